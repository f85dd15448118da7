-- Neovim 0.7 and later: waits for the first problem, prints it, ends.
local seen = false
vim.lsp.handlers["textDocument/publishDiagnostics"] = function(_, result)
  for _, d in ipairs(result.diagnostics) do
    seen = true
    print(d.message)
  end
end
local id = vim.lsp.start_client({ name = "rederive", cmd = { vim.env.REDERIVE, "lsp" }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(0, id)
vim.wait(30000, function() return seen end, 50)
vim.lsp.stop_client(id)
vim.wait(2000, function() return vim.lsp.client_is_stopped(id) end, 50)
vim.cmd("qall!")
