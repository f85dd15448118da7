//! The texts that an editor has open, and the thread that looks them through.
//!
//! **In:** what the editor says of texts, in its order. **Out:** their problems, to the editor, and what is known of each. **Guaranteed:** a
//! text that was changed or closed is looked through no longer, and nothing more is said of it: however fast somebody types, one look is under
//! way, and the newest text waits for it to end.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use rederive::check::Cancel;
use rederive::look::{Looked, Looker};
use serde_json::{Value, json};

use super::super::wire::{send, tell_of_defect};
use super::answers;

/// What an editor says of a text.
pub(super) enum Told {
    /// It is open, or has changed.
    Opened { uri: String, version: i64, text: String },
    /// It is closed.
    Closed { uri: String },
}

/// A text that waits.
struct Text {
    uri: String,
    version: i64,
    text: String,
}

/// The texts that an editor has open: what was found of each, those that wait, and the one that is looked through.
#[derive(Default)]
pub(super) struct Desk {
    state: Mutex<State>,
    news: Condvar,
}

#[derive(Default)]
struct State {
    known: HashMap<String, Arc<Looked>>,
    /// Of each address the newest text alone.
    waiting: Vec<Text>,
    closed: Vec<String>,
    /// The address of the text at hand, and what ends the look at it.
    at: Option<(String, Cancel)>,
}

impl Desk {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What was found of a text.
    pub fn known(&self, uri: &str) -> Option<Arc<Looked>> {
        self.state().known.get(uri).cloned()
    }

    /// Takes what an editor says of a text. An older one of this address is looked through no longer.
    pub fn take(&self, told: Told) {
        let mut state = self.state();
        let (Told::Opened { uri, .. } | Told::Closed { uri }) = &told;
        state.waiting.retain(|older| older.uri != *uri);
        state.at.iter().filter(|(at, _)| at == uri).for_each(|(_, cancel)| cancel.raise());
        match told {
            Told::Opened { uri, version, text } => {
                state.closed.retain(|closed| *closed != uri);
                state.waiting.push(Text { uri, version, text });
            }
            Told::Closed { uri } => {
                state.known.remove(&uri);
                state.closed.push(uri);
            }
        }
        self.news.notify_one();
    }

    /// The addresses that were closed, and the text that came last, with what ends the look at it; waits until there is something.
    fn next(&self) -> (Vec<String>, Option<(Text, Cancel)>) {
        let mut state = self.state();
        state.at = None;
        while state.waiting.is_empty() && state.closed.is_empty() {
            state = self.news.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        let next = state.waiting.pop().map(|text| (text, Cancel::default()));
        state.at = next.as_ref().map(|(text, cancel)| (text.uri.clone(), cancel.clone()));
        (std::mem::take(&mut state.closed), next)
    }

    /// Keeps what was found of the text at hand, and tells the editor, unless there is a newer one.
    fn found(&self, of: &Text, cancel: &Cancel, looked: Looked) {
        let diagnostics: Vec<Value> = looked.findings.iter().filter_map(answers::diagnostic).collect();
        {
            let mut state = self.state();
            if cancel.is_raised() {
                return;
            }
            state.known.insert(of.uri.clone(), Arc::new(looked));
        }
        let params = json!({ "uri": of.uri, "version": of.version, "diagnostics": diagnostics });
        let told = json!({ "jsonrpc": "2.0", "method": "textDocument/publishDiagnostics", "params": params });
        // Where the editor is gone, the talk ends.
        drop(send(&told));
    }
}

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

/// Looks texts through, of each the newest alone, as long as the process lives.
pub(super) fn look_through(desk: &Desk) {
    let mut looker = Looker::default();
    loop {
        let (closed, next) = desk.next();
        closed.iter().for_each(|uri| looker.forget(&path_of(uri)));
        let Some((mut of, cancel)) = next else { continue };
        let text = std::mem::take(&mut of.text);
        let before = meter::Defects::so_far();
        looker.look(&path_of(&of.uri), text, &cancel, &mut |looked| desk.found(&of, &cancel, looked));
        tell_of_defect(&before);
    }
}

/// The path that an address of a file names; another address is a name that has no folder.
fn path_of(uri: &str) -> PathBuf {
    let path = uri.strip_prefix("file://").map(|path| percent_encoding::percent_decode_str(path).decode_utf8_lossy());
    PathBuf::from(path.map_or_else(|| uri.replace('/', ":"), |path| path.into_owned()))
}
