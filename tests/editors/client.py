"""The language server, asked by pytest-lsp: problems, hovering, fixes, words behind lines, the time after a keystroke."""

import os
import time

import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient

URI = "file:///paper.tex"
WRONG = "Es gilt\n\\[(a+b)^2=a^2-2ab+b^2\\]\n"


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[os.environ["REDERIVE"], "lsp"]))
async def client(lsp_client: LanguageClient):
    capabilities = types.ClientCapabilities()
    await lsp_client.initialize_session(types.InitializeParams(capabilities=capabilities, root_uri=None))
    yield
    await lsp_client.shutdown_session()


def opened(client, text, version=1):
    item = types.TextDocumentItem(uri=URI, language_id="latex", version=version, text=text)
    client.text_document_did_open(types.DidOpenTextDocumentParams(text_document=item))


def changed(client, text, version):
    of = types.VersionedTextDocumentIdentifier(uri=URI, version=version)
    whole = types.TextDocumentContentChangeWholeDocument(text=text)
    client.text_document_did_change(types.DidChangeTextDocumentParams(text_document=of, content_changes=[whole]))


async def test_a_wrong_step(client: LanguageClient):
    opened(client, WRONG)
    await client.wait_for_notification("textDocument/publishDiagnostics")
    [problem] = client.diagnostics[URI]
    assert problem.code == "lint::wrong" and problem.severity == types.DiagnosticSeverity.Error
    assert problem.range.start.line == 1
    document = types.TextDocumentIdentifier(uri=URI)
    inside = types.Position(line=1, character=12)
    hover = await client.text_document_hover_async(types.HoverParams(text_document=document, position=inside))
    assert "wrong" in hover.contents.value
    context = types.CodeActionContext(diagnostics=[problem])
    params = types.CodeActionParams(text_document=document, range=problem.range, context=context)
    [fix] = await client.text_document_code_action_async(params)
    [edit] = fix.edit.changes[URI]
    lines = WRONG.split("\n")
    line = lines[1][: edit.range.start.character] + edit.new_text + lines[1][edit.range.end.character :]
    changed(client, "\n".join([lines[0], line, ""]), 2)
    await client.wait_for_notification("textDocument/publishDiagnostics")
    assert len(client.diagnostics[URI]) == 0


async def test_a_keystroke(client: LanguageClient):
    page = open(os.path.join(os.path.dirname(__file__), "../lint/page.tex"), encoding="utf-8").read()
    opened(client, page)
    await client.wait_for_notification("textDocument/publishDiagnostics")
    times = []
    for version in range(2, 7):
        start = time.monotonic()
        changed(client, page + "%" * version, version)
        await client.wait_for_notification("textDocument/publishDiagnostics")
        times.append(time.monotonic() - start)
    print(f"after a keystroke: {sorted(times)[2] * 1000:.0f} ms")
    assert sorted(times)[2] < 5
