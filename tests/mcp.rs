//! The server for agents, line by line.

use std::io::Write;
use std::process::{Command, Stdio};

use serde_json::{Value, json};

/// What the server answers to lines, in their order.
fn answers(arguments: &[&str], lines: &[String]) -> Vec<Value> {
    let mut server = Command::new(env!("CARGO_BIN_EXE_rederive"))
        .arg("mcp")
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the server starts");
    let mut to = server.stdin.take().expect("open");
    let text = lines.join("\n") + "\n";
    let writer = std::thread::spawn(move || to.write_all(text.as_bytes()));
    let output = server.wait_with_output().expect("it ends with its input");
    writer.join().expect("no panic").expect("written");
    assert!(output.status.success());
    String::from_utf8(output.stdout).expect("UTF-8").lines().map(|l| serde_json::from_str(l).expect("JSON")).collect()
}

fn call(id: i32, tool: &str, arguments: &Value) -> String {
    json!({ "jsonrpc": "2.0", "id": id, "method": "tools/call", "params": { "name": tool, "arguments": arguments } })
        .to_string()
}

#[test]
fn a_verdict_has_its_strength_in_its_name() {
    let found = answers(
        &[],
        &[
            json!({ "jsonrpc": "2.0", "id": 0, "method": "initialize", "params": { "protocolVersion": "2024-11-05" } })
                .to_string(),
            json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }).to_string(),
            call(1, "prove", &json!({ "formula": r"\sqrt{x^2}=x", "symbols": ["x"] })),
            call(2, "prove", &json!({ "formula": r"\sqrt{x^2}=x", "symbols": ["x"], "given": ["x>0"] })),
            call(3, "lint", &json!({ "text": r"\[(a+b)^2=a^2-2ab+b^2\]" })),
            call(4, "check", &json!({ "text": "[derivation]\ntitle = 1" })),
        ],
    );
    assert_eq!(found[0]["result"]["protocolVersion"], "2024-11-05");
    let verdict = |at: usize| found[at]["result"]["structuredContent"]["verdict"].as_str().unwrap_or_default();
    assert_eq!((found.len(), verdict(1), verdict(2)), (5, "refuted_by_a_point", "proved"));
    assert!(found[1]["result"]["structuredContent"]["witness"].is_object());
    let [wrong] = &found[3]["result"]["structuredContent"]["relations"].as_array().expect("relations")[..] else {
        panic!("one")
    };
    assert_eq!(wrong["verdict"], "wrong_refuted_by_a_point");
    assert!(wrong["instead"].is_string() && wrong["message"].is_string());
    assert_eq!(found[4]["result"]["isError"], true);
}

#[test]
fn whatever_is_sent_the_next_request_is_answered() {
    let bad = [
        "",
        "{",
        "[]",
        "3",
        r#"{"id":1}"#,
        r#"{"id":[],"method":"none"}"#,
        r#"{"id":2,"method":"tools/call"}"#,
        "\u{0}",
    ];
    let mut lines: Vec<String> = bad.map(str::to_owned).into();
    lines.push(call(3, "prove", &json!({ "formula": 7 })));
    lines.push(call(4, "prove", &json!([])));
    lines.push(call(5, "lint", &json!({ "text": "$x$", "path": "a.tex" })));
    lines.push(call(6, "lint", &json!({ "path": "Cargo.toml" })));
    lines.push("x".repeat(17 << 20));
    lines.push(format!(r#"{{"id":7,"method":"none","params":[{}1]}}"#, "1,".repeat(600_000)));
    lines.push(call(9, "prove", &json!({ "formula": "1+1=2" })));
    let found = answers(&[], &lines);
    let last = found.last().expect("answers");
    assert_eq!((&last["id"], &last["result"]["structuredContent"]["verdict"]), (&json!(9), &json!("proved")));
    let of = |id: i32| found.iter().find(|f| f["id"] == id).unwrap_or_else(|| panic!("{id} is answered: {found:?}"));
    assert_eq!(of(2)["error"]["code"], -32602);
    let told = |f: &Value| f["error"]["message"].as_str().is_some_and(|m| m.contains("more than 500000 values"));
    assert!(found.iter().any(told), "{found:?}");
    for id in 3..=6 {
        assert_eq!(of(id)["result"]["isError"], true, "{id}");
    }
}

#[test]
fn no_file_is_read_beyond_the_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let inside = folder.path().join("inside");
    std::fs::create_dir(&inside).expect("made");
    std::fs::write(folder.path().join("secret.tex"), "$1+1=3$").expect("written");
    std::fs::write(inside.join("paper.tex"), r"\input{../secret}$1+1=2$").expect("written");
    #[cfg(unix)]
    std::os::unix::fs::symlink("../secret.tex", inside.join("link.tex")).expect("linked");
    let paths = ["../secret.tex", "link.tex", "/etc/passwd", "paper.tex"];
    let lines: Vec<String> = (0..).zip(paths).map(|(id, path)| call(id, "lint", &json!({ "path": path }))).collect();
    let found = answers(&["--folder", &inside.display().to_string()], &lines);
    for (of, path) in found.iter().zip(&paths[..3]) {
        assert_eq!(of["result"]["isError"], true, "{path}: {of}");
    }
    let relations = found[3]["result"]["structuredContent"]["relations"].as_array().expect("relations");
    assert_eq!(relations.len(), 1, "{:?}", found[3]);
}

/// A text of formulas alone is read, a text that is too long gets a clear word, and what a tool says is what `lint` prints.
#[test]
fn a_text_is_looked_through_as_the_command_does() {
    let text = "(a+b)^2=a^2-2ab+b^2";
    let found = answers(
        &[],
        &[
            call(1, "lint", &json!({ "text": text })),
            call(2, "lint", &json!({ "text": format!("\\[{text}\\]") })),
            call(3, "lint", &json!({ "text": "\u{1}".repeat(2_500_000) })),
            call(4, "lint", &json!({ "text": "$x=1$".repeat(20_000) })),
        ],
    );
    let document = |at: usize| &found[at]["result"]["structuredContent"];
    for at in 0..2 {
        assert_eq!(document(at)["words"]["wrong"], 1);
        assert_eq!(document(at)["relations"][0]["instead"], "a^2+2ab+b^2");
    }
    for (at, why) in [(2, "the text has 2500000 bytes, and 1048576"), (3, "there are 20000 relations, and 10000")] {
        let told = found[at]["result"]["content"][0]["text"].as_str().unwrap_or_default();
        assert!(told.contains(why) && told.contains("hand over a part"), "{told}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("text.tex"), format!("\\[{text}\\]")).expect("written");
    let printed = std::process::Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(["lint", "--format", "json", "text.tex"])
        .current_dir(folder.path())
        .output()
        .expect("it runs");
    let printed: Value = serde_json::from_slice(&printed.stdout).expect("JSON");
    assert_eq!(&printed, document(1));
}
