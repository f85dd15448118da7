//! `rederive lsp`: a language server for derivation files and papers.
//!
//! **In:** requests of an editor on standard input, and the texts that it has open. **Out:** problems and verdicts at their places, and
//! what is asked of a place: its meaning, its definition, a formula that would be right.
//!
//! **Guaranteed:** problems of a text come before its verdicts, and what is said is of the newest text that was looked through. A defect
//! ends the look at one text, not the server.
//!
//! **Why this way:** one thread reads, another looks texts through, so that an answer never waits for a motion; both find with the
//! functions that `check` and `lint` use.

mod answers;
mod positions;

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use lsp_server::{Connection, ErrorCode, Message, Notification, Request, Response};
use rederive::Ending;
use rederive::look::{Looked, Looker};
use serde_json::{Value, json};

use super::ending::Stop;

#[derive(clap::Args)]
pub struct LspArguments {
    /// Talk over standard input and output, which is all that there is; editors name it
    #[arg(long)]
    stdio: bool,
}

/// A text that an editor has open.
struct Opened {
    uri: String,
    version: i64,
    text: String,
}

/// What was found of each text, by its address.
type Known = Arc<Mutex<HashMap<String, Arc<Looked>>>>;

pub fn lsp(_: &LspArguments) -> Result<Ending, Stop> {
    let (connection, threads) = Connection::stdio();
    let known = Known::default();
    let (to_looker, opened) = channel();
    let started = connection.initialize(capabilities());
    if let Err(error) = started {
        return Err(format!("the editor did not begin as it should: {error}").into());
    }
    let out = connection.sender.clone();
    let of_reader = Arc::clone(&known);
    let reader = std::thread::spawn(move || {
        read(&connection, &of_reader, &to_looker);
        // The queue ends here, and with it the thread that looks texts through.
    });
    look_through(&opened, &known, &|message| drop(out.send(message)));
    drop(out);
    if reader.join().is_err() || threads.join().is_err() {
        return Err("the editor is gone".into());
    }
    Ok(Ending::Good)
}

fn capabilities() -> Value {
    json!({
        "positionEncoding": "utf-16",
        "textDocumentSync": { "openClose": true, "change": 1 },
        "hoverProvider": true,
        "definitionProvider": true,
        "completionProvider": { "triggerCharacters": ["\\", "'", "\""] },
        "codeActionProvider": { "codeActionKinds": ["quickfix"] },
        "inlayHintProvider": true,
    })
}

/// Takes what the editor says until it is done.
fn read(connection: &Connection, known: &Known, opened: &Sender<Option<Opened>>) {
    for message in &connection.receiver {
        match message {
            Message::Request(request) => {
                if connection.handle_shutdown(&request).unwrap_or(true) {
                    break;
                }
                let answer = answered(request, known);
                if connection.sender.send(answer.into()).is_err() {
                    break;
                }
            }
            Message::Notification(notification) => {
                if opened.send(newest(&notification, known)).is_err() {
                    break;
                }
            }
            Message::Response(_) => {}
        }
    }
}

fn answered(request: Request, known: &Known) -> Response {
    let uri = request.params.pointer("/textDocument/uri").and_then(Value::as_str).unwrap_or_default();
    let looked = known.lock().unwrap_or_else(PoisonError::into_inner).get(uri).cloned();
    let found = match (request.method.as_str(), looked) {
        ("textDocument/hover", of) => of.and_then(|of| answers::hover(&of, &request.params)),
        ("textDocument/definition", of) => of.and_then(|of| answers::definition(&of, &request.params)),
        ("textDocument/completion", of) => Some(of.map_or(json!([]), |of| answers::completion(&of))),
        ("textDocument/codeAction", of) => Some(of.map_or(json!([]), |of| answers::actions(&of, &request.params))),
        ("textDocument/inlayHint", of) => Some(of.map_or(json!([]), |of| answers::hints(&of, &request.params))),
        (method, _) => {
            let message = format!("`{}` is not known here", rederive::diag::escape::in_one_line(method));
            return Response::new_err(request.id, ErrorCode::MethodNotFound as i32, message);
        }
    };
    Response::new_ok(request.id, found.unwrap_or(Value::Null))
}

/// The text that a notification brings; `None` where it brings none.
fn newest(notification: &Notification, known: &Known) -> Option<Opened> {
    let at = |pointer: &str| notification.params.pointer(pointer);
    let text = match notification.method.as_str() {
        "textDocument/didOpen" => at("/textDocument/text"),
        "textDocument/didChange" => at("/contentChanges").and_then(|all| all.as_array()?.last()?.get("text")),
        "textDocument/didClose" => {
            let uri = at("/textDocument/uri")?.as_str()?;
            known.lock().unwrap_or_else(PoisonError::into_inner).remove(uri);
            return None;
        }
        _ => None,
    };
    Some(Opened {
        uri: at("/textDocument/uri")?.as_str()?.to_owned(),
        version: at("/textDocument/version").and_then(Value::as_i64).unwrap_or(0),
        text: text?.as_str()?.to_owned(),
    })
}

/// Looks texts through, of each the newest alone, until no more come.
fn look_through(opened: &Receiver<Option<Opened>>, known: &Known, say: &dyn Fn(Message)) {
    let mut looker = Looker::default();
    let mut waiting: Vec<Opened> = Vec::new();
    loop {
        if waiting.is_empty() {
            match opened.recv() {
                Ok(one) => waiting.extend(one),
                Err(_) => return,
            }
        }
        waiting.extend(opened.try_iter().flatten());
        let Some(Opened { uri, version, text }) = waiting.pop() else { continue };
        waiting.retain(|older| older.uri != uri);
        looker.look(&path_of(&uri), text, &mut |looked| {
            let diagnostics: Vec<Value> = looked.findings.iter().filter_map(answers::diagnostic).collect();
            let params = json!({ "uri": uri, "version": version, "diagnostics": diagnostics });
            known.lock().unwrap_or_else(PoisonError::into_inner).insert(uri.clone(), Arc::new(looked));
            say(Notification::new("textDocument/publishDiagnostics".into(), params).into());
        });
    }
}

/// The path that an address of a file names; another address is a name that has no folder.
fn path_of(uri: &str) -> PathBuf {
    let path = uri.strip_prefix("file://").map(|path| percent_encoding::percent_decode_str(path).decode_utf8_lossy());
    PathBuf::from(path.map_or_else(|| uri.replace('/', ":"), |path| path.into_owned()))
}
