//! `rederive lsp`: a language server for derivation files and papers.
//!
//! **In:** requests of an editor on standard input, and the texts that it has open. **Out:** problems and verdicts at their places, and
//! what is asked of a place: its meaning, its definition, a formula that would be right.
//!
//! **Guaranteed:** problems of a text come before its verdicts, and what is said is of the newest text. A defect
//! ends the look at one text, not the server, and so does a message that is not understood. The end of the talk waits for nothing.
//!
//! **Why this way:** one thread reads, another looks texts through, so that an answer never waits for a motion; both find with the
//! functions that `check` and `lint` use. Of the protocol ten methods are needed: a library for it would take more code to be kept within its
//! limits.

mod answers;
mod positions;
mod texts;

use std::sync::Arc;

use rederive::Ending;
use rederive::diag::escape::in_one_line;
use serde_json::{Value, json};

use super::ending::Stop;
use super::wire::{self, NO_METHOD, NO_REQUEST, NOT_BEGUN, refused, send};
use texts::{Desk, look_through, newest};

#[derive(clap::Args)]
pub struct LspArguments {
    /// Talk over standard input and output, which is all that there is; editors name it
    #[arg(long)]
    stdio: bool,
}

/// How far a talk has come.
#[derive(PartialEq)]
enum Talk {
    Before,
    Open,
    ShutDown,
}

pub fn lsp(_: &LspArguments) -> Result<Ending, Stop> {
    let desk = Arc::new(Desk::default());
    let of_looker = Arc::clone(&desk);
    // It is not waited for: what it still looks for when the editor ends the talk is wanted by nobody.
    rederive::threads().build()?.spawn(move || look_through(&of_looker));
    let mut input = std::io::stdin().lock();
    let mut talk = Talk::Before;
    while let Some(body) = wire::next(&mut input)? {
        let answer = match wire::message(&body) {
            Ok(message) if message["method"] == "exit" => break,
            Ok(message) => taken(message, &mut talk, &desk),
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
fn taken(message: Value, talk: &mut Talk, desk: &Desk) -> Option<Value> {
    let (id, params) = (message.get("id"), message.get("params").unwrap_or(&Value::Null));
    let (method, id) = match (message.get("method").and_then(Value::as_str), id) {
        (Some(method), Some(id)) => (method, id),
        (Some(method), None) => {
            if let Some(told) = newest(method, params).filter(|_| *talk == Talk::Open) {
                desk.take(told);
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
        (_, Talk::Open) => match answered(method, params, desk) {
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
fn answered(method: &str, params: &Value, desk: &Desk) -> Option<Option<Value>> {
    let uri = params.pointer("/textDocument/uri").and_then(Value::as_str).unwrap_or_default();
    let of = desk.known(uri);
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
