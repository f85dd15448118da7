//! A defect in one piece of the work, at every way into the program: all else is told, and the end is 70.
//!
//! A build with debug assertions stops in the first piece of the task that `REDERIVE_FAULT` names (`src/meter/faults.rs`).

use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

use assert_cmd::Command;
use serde_json::{Value, json};

const FILE: &str = r"[derivation]
title = 'x'
concerns = 'y'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter' }
[system.s]
states = ['x']
equations = ['\dot x=-kx']
[[trajectory]]
id = 'a'
system = 's'
parameters = { 'k' = 1 }
initial = { 'x' = 1 }
span = [0, 1]
[[trajectory]]
id = 'b'
system = 's'
parameters = { 'k' = 2 }
initial = { 'x' = 1 }
span = [0, 1]
[[family]]
id = 'f'
of = 'a'
vary = { 'k' = { from = 1, to = 2, count = 20 } }
[[claim]]
id = 'first'
says = 's'
always = ['\ddot x=k^2x']
follows-from = ['s']
families = ['f']
[[claim]]
id = 'second'
says = 's'
always = ['x<2']
[[claim]]
id = 'wrong'
says = 's'
always = ['\ddot x=-k^2x']
[[claim]]
id = 'ranges'
says = 's'
always = ['x^2+k^2<10']
ranges = { 'x' = [0, 1], 'k' = [0, 1] }
";

/// Runs a command in a folder, with a stop in a task.
fn run(folder: &Path, task: &str, arguments: &[&str], input: &str) -> (i32, String, String) {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env("REDERIVE_FAULT", task).env("REDERIVE_CACHE", "").args(arguments);
    let output = command.write_stdin(input).output().expect("the program runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    (output.status.code().unwrap_or(-1), text(output.stdout), text(output.stderr))
}

/// It ends with 70, and says so.
#[track_caller]
fn stops(folder: &Path, task: &str, arguments: &[&str], input: &str) -> String {
    let (code, out, err) = run(folder, task, arguments, input);
    assert_eq!(code, 70, "{task}, {arguments:?}: {out}{err}");
    assert!(err.contains("This is a defect of rederive"), "{task}, {arguments:?}: {err}");
    out
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("one.toml"), FILE).expect("written");
    fs::write(folder.path().join("two.toml"), FILE).expect("written");
    folder
}

/// How many verdicts on motions are not open, of each claim.
fn decided(report: &Value) -> Vec<usize> {
    let claims = report["claims"].as_array().expect("claims");
    let open = |pair: &&Value| pair["verdict"] != "undecided";
    claims.iter().map(|claim| claim["results"].as_array().expect("results").iter().filter(open).count()).collect()
}

fn reports(folder: &Path) -> Vec<Value> {
    let read = |id: &str| fs::read_to_string(folder.join("reports").join(id).join("report.json"));
    ["one", "two"].map(read).into_iter().flatten().map(|text| serde_json::from_str(&text).expect("JSON")).collect()
}

/// A stop in a piece of the check of one file: the rest of that file and all of the other have their verdicts, and both have reports.
#[test]
fn a_defect_in_a_check_ends_one_piece() {
    let folder = folder();
    let (code, ..) = run(folder.path(), "", &["check", "one.toml", "two.toml"], "");
    assert_eq!(code, 1);
    let whole: usize = reports(folder.path()).iter().flat_map(decided).sum();
    assert_eq!(whole, 12);
    for (task, lost) in [
        ("computing a motion", 4),
        ("trying a claim on a motion", 1),
        ("proving a claim", 2),
        ("enclosing a motion", 3),
        ("taking ranges apart", 0),
        ("trying altered formulas", 0),
        ("trying members of a family", 0),
    ] {
        stops(folder.path(), task, &["check", "one.toml", "two.toml"], "");
        let reports = reports(folder.path());
        assert_eq!(reports.len(), 2, "{task}");
        let left: usize = reports.iter().flat_map(decided).sum();
        assert!(left + lost >= whole, "{task}: {left} of {whole}");
        fs::remove_dir_all(folder.path().join("reports")).expect("there are reports");
    }
    // Where a file is not compiled, there is nothing to tell of it.
    stops(folder.path(), "compiling the claims of a file", &["check", "one.toml", "two.toml"], "");
    assert_eq!(reports(folder.path()).len(), 1);
}

#[test]
fn a_defect_is_told_by_every_command() {
    let folder = folder();
    let at = folder.path();
    stops(at, "proving a claim", &["prove", "-s", "x", "x+x=2x"], "");
    stops(at, "proving a claim", &["explain", "first", "one.toml"], "");
    stops(at, "computing a motion", &["search", "second", "one.toml"], "");
    stops(at, "trying members of a family", &["sweep", "one.toml", "--family", "f", "-o", "part"], "");
    let paper = "\\[ \\sin^2x+\\cos^2x=1 \\]\n\\[ \\sin 2x=2\\sin x\\cos x=\\sin x\\cos x \\]\n";
    fs::write(at.join("paper.tex"), paper).expect("written");
    let told = stops(at, "deciding a step of a paper", &["lint", "paper.tex"], "");
    assert!(told.contains("wrong"), "the other steps are told: {told}");
    let call = |id: i32, name: &str, arguments: Value| {
        let params = json!({ "name": name, "arguments": arguments });
        json!({ "jsonrpc": "2.0", "id": id, "method": "tools/call", "params": params }).to_string()
    };
    let arguments = json!({ "formula": "x+x=2x", "symbols": ["x"] });
    let lines = [call(1, "prove", arguments.clone()), call(2, "prove", arguments)].join("\n") + "\n";
    let answers = stops(at, "proving a claim", &["mcp"], &lines);
    let mut answers = answers.lines();
    assert!(answers.next().is_some_and(|line| line.contains("a defect of rederive")), "the first call stopped");
    assert!(answers.next().is_some_and(|line| line.contains("proved") && !line.contains("defect")));
    let message = |method: &str, id: Option<i32>, params: Value| {
        let mut of = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        if let Some(id) = id {
            of["id"] = id.into();
        }
        let text = of.to_string();
        format!("Content-Length: {}\r\n\r\n{text}", text.len())
    };
    let document = json!({ "uri": "file:///one.toml", "languageId": "toml", "version": 1, "text": FILE });
    let talk = message("initialize", Some(1), json!({ "processId": null, "rootUri": null, "capabilities": {} }))
        + &message("initialized", None, json!({}))
        + &message("textDocument/didOpen", None, json!({ "textDocument": document }));
    let told = edited(at, "proving a claim", &talk);
    assert!(told.contains("publishDiagnostics") && told.contains("a defect of rederive"), "{told}");
}

/// What the language server says until it has told of a defect, or half a minute is over. It ends where its input does, whatever it is at.
fn edited(folder: &Path, task: &str, talk: &str) -> String {
    let mut server = std::process::Command::new(env!("CARGO_BIN_EXE_rederive"))
        .current_dir(folder)
        .env("REDERIVE_FAULT", task)
        .arg("lsp")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the server starts");
    let (mut to, mut from) = (server.stdin.take().expect("its input"), server.stdout.take().expect("its output"));
    to.write_all(talk.as_bytes()).expect("written");
    let (send, receive) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        let mut some = [0; 4096];
        while let Ok(n @ 1..) = from.read(&mut some) {
            if send.send(String::from_utf8_lossy(&some[..n]).into_owned()).is_err() {
                break;
            }
        }
    });
    let mut said = String::new();
    while !(said.contains("publishDiagnostics") && said.contains("a defect of rederive")) {
        match receive.recv_timeout(Duration::from_secs(30)) {
            Ok(more) => said += &more,
            Err(_) => break,
        }
    }
    drop(to);
    server.wait().expect("it ends with its input");
    said
}
