// Starts `rederive lsp` for papers and derivation files; everything else is the server's.
const { workspace } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

exports.activate = () => {
  const command = workspace.getConfiguration("rederive").get("program");
  const documents = ["latex", "tex", "toml"].map(language => ({ language }));
  // Of TOML only what is a derivation: other files of that kind are left alone.
  const isOurs = document => document.languageId !== "toml" || /^\s*\[derivation\]/m.test(document.getText());
  const ours = (document, next) => (isOurs(document) ? next(document) : undefined);
  client = new LanguageClient("rederive", "rederive", { command, args: ["lsp"] }, {
    documentSelector: documents,
    middleware: { didOpen: ours, didChange: (event, next) => (isOurs(event.document) ? next(event) : undefined), didClose: ours },
  });
  return client.start();
};

exports.deactivate = () => client?.stop();
