//! The texts that an editor has open, and the thread that looks them through.
//!
//! **In:** what the editor says of texts, in its order. **Out:** their problems, to the editor, and what is known of each.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex, PoisonError};

use rederive::look::{Looked, Looker};
use serde_json::{Value, json};

use super::super::wire::send;
use super::answers;

/// What an editor says of a text.
pub(super) enum Told {
    /// It is open, or has changed.
    Opened { uri: String, version: i64, text: String },
    /// It is closed.
    Closed { uri: String },
}

/// What was found of each text, by its address.
pub(super) type Known = Arc<Mutex<HashMap<String, Arc<Looked>>>>;

/// What a notification says of a text; `None` where it says nothing.
pub(super) fn newest(method: &str, params: &Value) -> Option<Told> {
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
pub(super) fn look_through(told: &Receiver<Told>, known: &Known) {
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
