//! `rederive mcp`: a server for agents, which derive much and check little.
//!
//! **In:** requests of the model context protocol on standard input, one in a line. **Out:** answers on standard output: of each tool
//! what was found as data, with the strength in the verdict's name.
//!
//! **Guaranteed:** no file is read but inside of the folder that is named; a tool ends within its seconds; whatever a client sends, the
//! next request is answered.
//!
//! **Why this way:** of the protocol five methods are needed, each a line of JSON: a library for it would double the packages that the
//! program is compiled from.

mod tools;

use std::io::{BufRead, Read, Write};
use std::path::PathBuf;

use meter::Defects;
use rederive::Ending;
use rederive::diag::escape::in_one_line;
use serde_json::{Value, json};

use super::ending::Stop;
use super::wire::{self, NO_METHOD, NO_PARAMETER, NO_REQUEST, refused};
use tools::Workbench;

/// Versions of the protocol whose tools are these; of others the newest of these is offered.
const PROTOCOL: [&str; 3] = ["2025-06-18", "2025-03-26", "2024-11-05"];
/// Longest request, in bytes.
const LONGEST: u64 = 16 << 20;

#[derive(clap::Args)]
pub struct McpArguments {
    /// Papers and derivation files inside of this folder may be named; without it a tool takes texts alone
    #[arg(long, value_name = "FOLDER")]
    folder: Option<PathBuf>,
    /// A tool ends after so many seconds, and says what it knows
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=3600))]
    deadline: u32,
}

pub fn mcp(arguments: &McpArguments) -> Result<Ending, Stop> {
    let bench = Workbench::new(arguments.folder.as_deref(), f64::from(arguments.deadline))?;
    let mut input = std::io::stdin().lock();
    loop {
        let mut line = Vec::new();
        let read = input.by_ref().take(LONGEST).read_until(b'\n', &mut line)?;
        if read == 0 {
            return Ok(Ending::Good);
        }
        let answer = if line.last() != Some(&b'\n') && line.len() as u64 == LONGEST {
            // What is left of the line is nothing that could be answered.
            input.skip_until(b'\n')?;
            Some(refused(&Value::Null, NO_REQUEST, "the request is too long"))
        } else {
            answered(&line, &bench)
        };
        let Some(answer) = answer else { continue };
        let mut out = std::io::stdout().lock();
        if writeln!(out, "{answer}").and_then(|()| out.flush()).is_err() {
            // The client is gone.
            return Ok(Ending::Good);
        }
    }
}

/// The answer to a line; `None` where none is wanted.
fn answered(line: &[u8], bench: &Workbench) -> Option<Value> {
    if line.trim_ascii().is_empty() {
        return None;
    }
    let request = match wire::message(line) {
        Ok(request) => request,
        Err(refused) => return Some(refused),
    };
    let method = request.get("method").and_then(Value::as_str);
    // A notification has no id, and an answer has no method.
    let id = request.get("id")?;
    let method = method?;
    let params = request.get("params").unwrap_or(&Value::Null);
    let result = match method {
        "initialize" => {
            let asked = params.get("protocolVersion").and_then(Value::as_str);
            let version = PROTOCOL.into_iter().find(|v| Some(*v) == asked).unwrap_or(PROTOCOL[0]);
            json!({
                "protocolVersion": version,
                "capabilities": { "tools": {} },
                "serverInfo": { "name": "rederive", "version": env!("CARGO_PKG_VERSION") },
                "instructions": "Check each step of a derivation before it is used: `prove` for one equation, `lint` for LaTeX with several, `check` for a derivation file. A verdict names its strength; what is undecided or not followed is not confirmed.",
            })
        }
        "ping" => json!({}),
        "tools/list" => json!({ "tools": bench.described() }),
        "tools/call" => {
            let name = params.get("name").and_then(Value::as_str).unwrap_or_default();
            if !bench.has(name) {
                return Some(refused(id, NO_PARAMETER, &format!("there is no tool `{}`", in_one_line(name))));
            }
            let before = Defects::so_far();
            let answer = bench.call(name, params.get("arguments").unwrap_or(&Value::Null));
            // What was found stands beside it, in the editor of people as here.
            let said = |text: String| json!({ "type": "text", "text": text });
            let defect = before.since().map(|what| said(wire::defect(&what)));
            match answer {
                Ok(found) => {
                    let content: Vec<Value> = std::iter::once(said(found.to_string())).chain(defect).collect();
                    json!({ "content": content, "structuredContent": found, "isError": false })
                }
                Err(why) => {
                    let content: Vec<Value> = std::iter::once(said(why)).chain(defect).collect();
                    json!({ "content": content, "isError": true })
                }
            }
        }
        _ => return Some(refused(id, NO_METHOD, &format!("`{}` is not known here", in_one_line(method)))),
    };
    Some(json!({ "jsonrpc": "2.0", "id": id, "result": result }))
}
