//! `rederive lsp`: a language server for derivation files and papers.
//!
//! **In:** requests of an editor on standard input, and the texts that it has open. **Out:** problems and verdicts at their places, and
//! what is asked of a place: its meaning, its definition, a formula that would be right.
//!
//! **Guaranteed:** problems of a text come before its verdicts, and what is said is of the newest text that was looked through. A defect
//! ends the look at one text, not the server, and so does a message that is not understood. The end of the talk waits for nothing.
//!
//! **Why this way:** one thread reads, another looks texts through, so that an answer never waits for a motion; both find with the
//! functions that `check` and `lint` use. Of the protocol ten methods are needed: a library for it would take more code to be kept within its
//! limits.

mod answers;
mod positions;
mod wire;

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};

use rederive::Ending;
use rederive::diag::escape::in_one_line;
use rederive::look::{Looked, Looker};
use serde_json::{Value, json};

use super::ending::Stop;
use wire::{NO_METHOD, NO_REQUEST, NOT_BEGUN, refused, send};

#[derive(clap::Args)]
pub struct LspArguments {
    /// Talk over standard input and output, which is all that there is; editors name it
    #[arg(long)]
    stdio: bool,
}

/// What an editor says of a text.
enum Told {
    /// It is open, or has changed.
    Opened { uri: String, version: i64, text: String },
    /// It is closed.
    Closed { uri: String },
}

/// What was found of each text, by its address.
type Known = Arc<Mutex<HashMap<String, Arc<Looked>>>>;

/// How far a talk has come.
#[derive(PartialEq)]
enum Talk {
    Before,
    Open,
    ShutDown,
}

pub fn lsp(_: &LspArguments) -> Result<Ending, Stop> {
    let known = Known::default();
    let (to_looker, told) = channel();
    let of_looker = Arc::clone(&known);
    // It is not waited for: what it still looks for when the editor ends the talk is wanted by nobody.
    rederive::threads().build()?.spawn(move || look_through(&told, &of_looker));
    let mut input = std::io::stdin().lock();
    let mut talk = Talk::Before;
    while let Some(body) = wire::next(&mut input)? {
        let answer = match wire::message(&body) {
            Ok(message) if message["method"] == "exit" => break,
            Ok(message) => taken(message, &mut talk, &known, &to_looker),
            Err(refused) => Some(refused),
        };
        if answer.is_some_and(|answer| send(&answer).is_err()) {
            // The editor is gone.
            break;
        }
    }
    Ok(Ending::Good)
}

/// Takes a message; the answer, where one is wanted.
fn taken(message: Value, talk: &mut Talk, known: &Known, to_looker: &Sender<Told>) -> Option<Value> {
    let (id, params) = (message.get("id"), message.get("params").unwrap_or(&Value::Null));
    let (method, id) = match (message.get("method").and_then(Value::as_str), id) {
        (Some(method), Some(id)) => (method, id),
        (Some(method), None) => {
            if let Some(told) = newest(method, params).filter(|_| *talk == Talk::Open) {
                // It ends with the talk alone.
                drop(to_looker.send(told));
            }
            return None;
        }
        // An answer of the editor, to what was not asked.
        (None, Some(_)) if message.get("result").or(message.get("error")).is_some() => return None,
        (None, id) => return Some(refused(id.unwrap_or(&Value::Null), NO_REQUEST, "the message has no method")),
    };
    let result = match (method, &talk) {
        ("initialize", Talk::Before) => {
            *talk = Talk::Open;
            json!({ "capabilities": capabilities() })
        }
        (_, Talk::Before) => return Some(refused(id, NOT_BEGUN, "the talk has not begun")),
        ("initialize", _) | (_, Talk::ShutDown) => return Some(refused(id, NO_REQUEST, "it is not the time for this")),
        ("shutdown", Talk::Open) => {
            *talk = Talk::ShutDown;
            Value::Null
        }
        (_, Talk::Open) => match answered(method, params, known) {
            Some(found) => found.unwrap_or(Value::Null),
            None => return Some(refused(id, NO_METHOD, &format!("`{}` is not known here", in_one_line(method)))),
        },
    };
    Some(json!({ "jsonrpc": "2.0", "id": id, "result": result }))
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

/// What was found for a request; `None` where the method is not known.
fn answered(method: &str, params: &Value, known: &Known) -> Option<Option<Value>> {
    let uri = params.pointer("/textDocument/uri").and_then(Value::as_str).unwrap_or_default();
    let of = known.lock().unwrap_or_else(PoisonError::into_inner).get(uri).cloned();
    let or_none = |of: Option<Value>| Some(of.unwrap_or_else(|| json!([])));
    Some(match method {
        "textDocument/hover" => of.and_then(|of| answers::hover(&of, params)),
        "textDocument/definition" => of.and_then(|of| answers::definition(&of, params)),
        "textDocument/completion" => or_none(of.map(|of| answers::completion(&of))),
        "textDocument/codeAction" => or_none(of.map(|of| answers::actions(&of, params))),
        "textDocument/inlayHint" => or_none(of.map(|of| answers::hints(&of, params))),
        _ => return None,
    })
}

/// What a notification says of a text; `None` where it says nothing.
fn newest(method: &str, params: &Value) -> Option<Told> {
    let at = |pointer: &str| params.pointer(pointer);
    let uri = at("/textDocument/uri")?.as_str()?.to_owned();
    let text = match method {
        "textDocument/didOpen" => at("/textDocument/text")?,
        "textDocument/didChange" => at("/contentChanges")?.as_array()?.last()?.get("text")?,
        "textDocument/didClose" => return Some(Told::Closed { uri }),
        _ => return None,
    };
    let version = at("/textDocument/version").and_then(Value::as_i64).unwrap_or(0);
    Some(Told::Opened { uri, version, text: text.as_str()?.to_owned() })
}

/// Looks texts through, of each the newest alone, until no more come.
fn look_through(told: &Receiver<Told>, known: &Known) {
    let mut looker = Looker::default();
    let mut waiting: Vec<(String, i64, String)> = Vec::new();
    let known = || known.lock().unwrap_or_else(PoisonError::into_inner);
    loop {
        let first = if waiting.is_empty() { told.recv().ok() } else { None };
        if waiting.is_empty() && first.is_none() {
            return;
        }
        for one in first.into_iter().chain(told.try_iter()) {
            match one {
                Told::Opened { uri, version, text } => {
                    waiting.retain(|(older, ..)| *older != uri);
                    waiting.push((uri, version, text));
                }
                Told::Closed { uri } => {
                    waiting.retain(|(older, ..)| *older != uri);
                    looker.forget(&path_of(&uri));
                    known().remove(&uri);
                }
            }
        }
        let Some((uri, version, text)) = waiting.pop() else { continue };
        looker.look(&path_of(&uri), text, &mut |looked| {
            let diagnostics: Vec<Value> = looked.findings.iter().filter_map(answers::diagnostic).collect();
            let params = json!({ "uri": uri, "version": version, "diagnostics": diagnostics });
            known().insert(uri.clone(), Arc::new(looked));
            // Where the editor is gone, the talk ends.
            let told = json!({ "jsonrpc": "2.0", "method": "textDocument/publishDiagnostics", "params": params });
            drop(send(&told));
        });
    }
}

/// The path that an address of a file names; another address is a name that has no folder.
fn path_of(uri: &str) -> PathBuf {
    let path = uri.strip_prefix("file://").map(|path| percent_encoding::percent_decode_str(path).decode_utf8_lossy());
    PathBuf::from(path.map_or_else(|| uri.replace('/', ":"), |path| path.into_owned()))
}
