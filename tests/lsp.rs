//! The language server, as an editor talks to it.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use lsp_server::{Message, Notification, Request};
use serde_json::{Value, json};

struct Editor {
    server: Child,
    to: Option<ChildStdin>,
    from: BufReader<ChildStdout>,
    asked: i32,
}

impl Editor {
    fn start() -> Editor {
        let mut server = Command::new(env!("CARGO_BIN_EXE_rederive"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the server starts");
        let (to, from) = (server.stdin.take(), server.stdout.take().expect("its output"));
        let mut editor = Editor { server, to, from: BufReader::new(from), asked: 0 };
        let answer = editor.ask("initialize", json!({ "processId": null, "rootUri": null, "capabilities": {} }));
        assert_eq!(answer["capabilities"]["hoverProvider"], true);
        editor.tell("initialized", json!({}));
        editor
    }

    fn send(&mut self, message: Message) {
        message.write(self.to.as_mut().expect("open")).expect("written");
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send(Notification::new(method.to_owned(), params).into());
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.asked += 1;
        let id = self.asked;
        self.send(Request::new(id.into(), method.to_owned(), params).into());
        loop {
            match Message::read(&mut self.from).expect("a message").expect("the server lives") {
                Message::Response(answer) if answer.id == id.into() => {
                    return answer.response_kind_value();
                }
                _ => continue,
            }
        }
    }

    /// The next message.
    fn next(&mut self) -> Message {
        Message::read(&mut self.from).expect("a message").expect("the server lives")
    }

    fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "latex", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
    }

    fn change(&mut self, uri: &str, version: i32, text: &str) {
        let changes = json!([{ "text": text }]);
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": { "uri": uri, "version": version }, "contentChanges": changes }),
        );
    }

    /// The next diagnostics of a version of a text that are as wanted.
    fn diagnostics(&mut self, version: i32, wanted: &dyn Fn(&[Value]) -> bool) -> Vec<Value> {
        loop {
            if let Message::Notification(told) =
                Message::read(&mut self.from).expect("a message").expect("the server lives")
            {
                let all = told.params["diagnostics"].as_array().cloned().unwrap_or_default();
                if told.method == "textDocument/publishDiagnostics" && told.params["version"] == version && wanted(&all)
                {
                    return all;
                }
            }
        }
    }

    fn stop(mut self) {
        self.ask("shutdown", Value::Null);
        self.tell("exit", Value::Null);
        self.to = None;
        assert!(self.server.wait().expect("it ends").success());
    }
}

/// What an answer holds; its error where it is one.
trait Held {
    fn response_kind_value(self) -> Value;
}

impl Held for lsp_server::Response {
    fn response_kind_value(self) -> Value {
        let whole = serde_json::to_value(&self).expect("an answer is JSON");
        whole.get("result").cloned().unwrap_or_else(|| whole["error"].clone())
    }
}

fn place(line: usize, character: usize) -> Value {
    json!({ "line": line, "character": character })
}

#[test]
fn a_wrong_step_is_told_while_it_is_typed_and_can_be_exchanged() {
    let mut editor = Editor::start();
    let uri = "file:///paper.tex";
    editor.open(uri, "Über $a$:\n\\[(a+b)^2=a^2+2ab+b^2\\]\n");
    editor.diagnostics(1, &|all| all.is_empty());
    editor.change(uri, 2, "Über $a$:\n\\[(a+b)^2=a^2-2ab+b^2\\]\n");
    let wrong = editor.diagnostics(2, &|all| !all.is_empty());
    assert_eq!((&wrong[0]["code"], &wrong[0]["severity"]), (&json!("lint::wrong"), &json!(1)));
    assert_eq!(wrong[0]["range"]["start"], place(1, 10));
    let document = json!({ "uri": uri });
    let hover = editor.ask("textDocument/hover", json!({ "textDocument": document, "position": place(1, 12) }));
    assert!(hover["contents"]["value"].as_str().is_some_and(|v| v.starts_with("**wrong**")), "{hover}");
    let range = json!({ "start": place(1, 12), "end": place(1, 12) });
    let actions = editor.ask(
        "textDocument/codeAction",
        json!({ "textDocument": document, "range": range, "context": { "diagnostics": wrong } }),
    );
    let edit = &actions[0]["edit"]["changes"][uri][0];
    assert_eq!(edit["newText"].as_str().map(|t| t.replace(' ', "")), Some("a^2+2ab+b^2".to_owned()), "{actions}");
    assert_eq!(edit["range"], wrong[0]["range"]);
    let all = json!({ "start": place(0, 0), "end": place(9, 0) });
    let hints = editor.ask("textDocument/inlayHint", json!({ "textDocument": document, "range": all }));
    assert_eq!(hints[0]["label"], "wrong");
    editor.stop();
}

const SPRING: &str = "[derivation]\ntitle = 'A spring'\nconcerns = 'A textbook'\n\n[symbols]\n't' = { role = 'time' }\n'x' = { role = 'state', says = 'how far it is pulled' }\n'v' = { role = 'state' }\n\n[system.spring]\nstates = ['x', 'v']\nequations = ['\\dot x=v', '\\dot v=-x']\n\n[[trajectory]]\nid = 'pulled'\nsystem = 'spring'\ninitial = { 'x' = 1, 'v' = 0 }\nspan = [0, 10]\n\n[[claim]]\nid = 'energy'\nsays = 'The energy is what it was'\nalways = ['x^2+v^2=x(0)^2+v(0)^2']\n";

#[test]
fn a_derivation_file_is_checked_and_its_symbols_are_found() {
    let mut editor = Editor::start();
    let uri = "file:///spring.toml";
    editor.open(uri, SPRING);
    let document = json!({ "uri": uri });
    // The verdicts come after the problems, of which there are none.
    let text = |editor: &mut Editor| {
        let hover = editor.ask("textDocument/hover", json!({ "textDocument": document, "position": place(22, 2) }));
        hover["contents"]["value"].as_str().unwrap_or_default().to_owned()
    };
    let mut said = String::new();
    for _ in 0..600 {
        said = text(&mut editor);
        if !said.is_empty() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    assert!(said.contains("energy") && said.contains("holds"), "{said}");
    let at = json!({ "textDocument": document, "position": place(22, 11) });
    assert_eq!(editor.ask("textDocument/definition", at.clone())["range"]["start"]["line"], 6);
    assert!(editor.ask("textDocument/hover", at)["contents"]["value"].as_str().is_some_and(|v| v.contains("how far")));
    let names = editor.ask("textDocument/completion", json!({ "textDocument": document, "position": place(22, 11) }));
    assert_eq!(names.as_array().map(Vec::len), Some(3));
    // A claim that fails is told at its place; a name without a declaration can be declared.
    editor.change(uri, 2, &SPRING.replace("x(0)^2+v(0)^2", "1+v"));
    let fails = editor.diagnostics(2, &|all| !all.is_empty());
    assert_eq!(fails[0]["code"], "verdict::fails");
    editor.change(uri, 3, &SPRING.replace("x(0)^2+v(0)^2", "E"));
    let unknown = editor.diagnostics(3, &|all| !all.is_empty());
    let actions = editor.ask(
        "textDocument/codeAction",
        json!({ "textDocument": document, "range": unknown[0]["range"], "context": {} }),
    );
    assert_eq!(actions[0]["edit"]["changes"][uri][0]["newText"], "'E' = { role = 'parameter' }\n", "{unknown:?}");
    editor.stop();
}

#[test]
fn what_an_editor_gets_wrong_ends_nothing() {
    let mut editor = Editor::start();
    assert_eq!(editor.ask("textDocument/none", json!({}))["code"], -32601);
    assert_eq!(
        editor.ask(
            "textDocument/hover",
            json!({ "textDocument": { "uri": "file:///none.tex" }, "position": place(9, 9) })
        ),
        Value::Null
    );
    editor.tell("textDocument/didChange", json!({ "contentChanges": 3 }));
    editor.tell("textDocument/didOpen", json!("nothing"));
    let uri = "untitled:one.tex";
    editor.open(uri, "\\def\\a{\\a\\a}$\\a=1$");
    assert_eq!(editor.diagnostics(1, &|_| true).len(), 1);
    editor.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    editor.stop();
}

/// The settings for Helix are tables as its documentation has them: servers by name, each with a command and its arguments; languages
/// that name their servers. The program itself was not at hand.
#[test]
fn the_settings_for_helix_name_the_server_that_they_define() {
    let page = include_str!("../docs/editors.md");
    let (_, block) = page.split_once("```toml\n").expect("a block");
    let (block, _) = block.split_once("```").expect("its end");
    let settings: toml::Table = block.parse().expect("TOML");
    let server = &settings["language-server"]["rederive"];
    assert_eq!(server["command"].as_str(), Some("rederive"));
    let arguments: Vec<&str> = server["args"].as_array().expect("a list").iter().filter_map(|a| a.as_str()).collect();
    let help = Command::new(env!("CARGO_BIN_EXE_rederive")).args(&arguments).arg("--help").output().expect("it runs");
    assert!(help.status.success(), "{arguments:?}");
    let languages = settings["language"].as_array().expect("languages");
    let names: Vec<_> = languages.iter().filter_map(|l| l["name"].as_str()).collect();
    assert_eq!(names, ["latex", "toml"]);
    for language in languages {
        let servers = language["language-servers"].as_array().expect("servers");
        assert!(servers.iter().any(|s| s.as_str() == Some("rederive")), "{language}");
    }
}

impl Editor {
    /// Sends bytes as they are.
    fn write(&mut self, bytes: &[u8]) {
        self.to.as_mut().expect("open").write_all(bytes).expect("written");
    }

    /// The next message, as it is.
    fn read_raw(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(self.from.read_line(&mut line).expect("a line") > 0, "the server lives");
            match line.trim().split_once(": ") {
                Some((_, bytes)) => length = bytes.parse().expect("a number"),
                None => break,
            }
        }
        let mut body = vec![0; length];
        self.from.read_exact(&mut body).expect("a body");
        serde_json::from_slice(&body).expect("JSON")
    }

    /// Waits for the end of the server, and no longer than so many seconds.
    fn ends_within(mut self, seconds: u64) -> Option<i32> {
        let until = Instant::now() + Duration::from_secs(seconds);
        while Instant::now() < until {
            if let Some(status) = self.server.try_wait().expect("asked") {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        self.server.kill().expect("stopped");
        self.server.wait().expect("it ends");
        panic!("the server has not ended");
    }
}

#[test]
fn a_message_that_is_not_understood_takes_no_other_with_it() {
    let mut editor = Editor::start();
    let deep = format!(r#"{{"method":"x","params":{}}}"#, "[".repeat(100_000));
    let many = format!(r#"{{"method":"x","params":[{}1]}}"#, "1,".repeat(600_000));
    let bad: [(&[u8], i32); 7] = [
        (b"\xff\xfe{}", -32700),
        (br#"{"method":"textDocument/didOpen","params":{"textDocument":{"uri":"a","text":"\ud800"}}}"#, -32700),
        (deep.as_bytes(), -32700),
        (b"{", -32700),
        (b"[]", -32600),
        (br#"{"id":3000000000}"#, -32600),
        (many.as_bytes(), -32600),
    ];
    for (body, code) in bad {
        editor.write(format!("Content-Length: {}\r\n\r\n", body.len()).as_bytes());
        editor.write(body);
        assert_eq!(editor.read_raw()["error"]["code"], code);
    }
    let unknown = editor.ask("textDocument/none", json!({}));
    assert_eq!(unknown["code"], -32601);
    editor.stop();
}

#[test]
fn a_length_that_no_message_has_ends_the_server_with_a_word() {
    for length in ["1000000000", "5000000000", "9223372036854775808", "99999999999999999999", "-1", "x"] {
        let mut server = Command::new(env!("CARGO_BIN_EXE_rederive"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the server starts");
        // The end of input does not come: what is announced is refused for itself.
        let mut to = server.stdin.take().expect("its input");
        to.write_all(format!("Content-Length: {length}\r\n\r\n{{\"a\":").as_bytes()).expect("written");
        let told = server.wait_with_output().expect("it ends");
        let said = String::from_utf8_lossy(&told.stderr).into_owned();
        assert_eq!(told.status.code(), Some(2), "{length}: {said}");
        assert!(said.contains("the editor announces a message of"), "{length}: {said}");
    }
}

/// What takes many seconds.
fn long() -> String {
    r"[derivation]
title = 'A decay'
concerns = 'A textbook'
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
[[family]]
id = 'f'
of = 'a'
vary = { 'k' = { log-uniform = [1, 1e12] } }
draws = 1000000
seed = 1
[[claim]]
id = 'c'
says = 's'
always = ['x<2']
families = ['f']
"
    .to_owned()
}

#[test]
fn the_end_of_a_talk_waits_for_no_work() {
    for is_polite in [true, false] {
        let mut editor = Editor::start();
        for n in 0..3 {
            editor.open(&format!("file:///long{n}.toml"), &long());
        }
        // Problems come before verdicts: the work has begun.
        editor.diagnostics(1, &|_| true);
        if is_polite {
            assert_eq!(editor.ask("shutdown", Value::Null), Value::Null);
            assert_eq!(editor.ask("textDocument/hover", json!({}))["code"], json!(-32600));
            editor.tell("exit", Value::Null);
        } else {
            editor.to = None;
        }
        assert_eq!(editor.ends_within(10), Some(0));
    }
}

/// Twenty edits of a text of which each look takes many seconds: they do not queue up, and nothing is said of a text after a newer one came.
#[test]
fn edits_do_not_queue_up() {
    let mut editor = Editor::start();
    let uri = "file:///typed.toml";
    editor.open(uri, &long());
    editor.diagnostics(1, &|_| true);
    for version in 2..22 {
        editor.change(uri, version, &format!("{}# {version}\n", long()));
        std::thread::sleep(Duration::from_millis(100));
    }
    let started = Instant::now();
    editor.change(uri, 22, SPRING);
    let mut told = vec![0; 23];
    let mut newest = 1;
    // Problems, then verdicts.
    while told[22] < 2 {
        let Message::Notification(one) = editor.next() else { continue };
        if let Some(version) = one.params["version"].as_u64() {
            assert!(version >= newest, "{version} after {newest}");
            newest = version;
            told[version as usize] += 1;
        }
    }
    // Of what was typed over, no look came to its verdicts.
    assert!(told[..22].iter().all(|times| *times <= 1), "{told:?}");
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
    let document = json!({ "uri": uri });
    let all = json!({ "start": place(0, 0), "end": place(99, 0) });
    let hints = editor.ask("textDocument/inlayHint", json!({ "textDocument": document, "range": all }));
    assert!(hints[0]["label"].as_str().is_some_and(|label| label.starts_with("holds")), "{hints}");
    // What is closed is not known any more.
    editor.tell("textDocument/didClose", json!({ "textDocument": document }));
    let hints = editor.ask("textDocument/inlayHint", json!({ "textDocument": document, "range": all }));
    assert_eq!(hints, json!([]));
    editor.stop();
}
