//! The language server, as an editor talks to it.

use std::io::BufReader;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

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
