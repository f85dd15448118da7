//! The pages "in five minutes", and the gallery: what they show is what the program prints.
//!
//! A block after `<!-- file: NAME -->` is a file. In a block of a console a line with `$` is a command; the lines below it occur in what
//! it prints, in their order, `…` standing for anything; `[exit N]` is its exit code.

use std::path::Path;
use std::process::Command;

/// (the words before it on its first line or in the comment above, the text) of each fenced block.
fn blocks(page: &str) -> Vec<(String, String)> {
    let mut out = Vec::new();
    let (mut open, mut before) = (None, "");
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(language)) => {
                let name = before.strip_prefix("<!-- file: ").and_then(|n| n.strip_suffix(" -->"));
                open = Some((name.map_or_else(|| language.to_owned(), |n| format!("file {n}")), String::new()));
            }
            (Some(_), Some(_)) => out.extend(open.take()),
            (Some((_, text)), None) => {
                text.push_str(line);
                text.push('\n');
            }
            (None, None) => {}
        }
        if !line.is_empty() {
            before = line;
        }
    }
    out
}

/// The words of a command line, as a shell takes simple ones.
fn words(line: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '\'' => quoted = !quoted,
            ' ' if !quoted => out.push(String::new()),
            c => out.last_mut().expect("a word").push(c),
        }
    }
    out
}

/// Runs a command, and looks for the lines in what it prints.
fn run(folder: &Path, line: &str, shown: &[&str]) {
    let words = words(line);
    assert_eq!(words[0], "rederive", "{line}");
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    let output = command.args(&words[1..]).current_dir(folder).env("REDERIVE_CACHE", "").output().expect("it runs");
    let text = format!("{}\n{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let mut printed = text.lines();
    for wanted in shown {
        if let Some(code) = wanted.strip_prefix("[exit ").and_then(|w| w.strip_suffix(']')) {
            assert_eq!(output.status.code().map(|c| c.to_string()).as_deref(), Some(code), "{line}\n{text}");
            continue;
        }
        let parts: Vec<&str> = wanted.split('…').map(str::trim).collect();
        let fits = |line: &str| {
            let mut rest = line;
            parts.iter().all(|part| rest.find(part).map(|at| rest = &rest[at + part.len()..]).is_some())
        };
        assert!(printed.any(fits), "{line} does not print {wanted:?}:\n{text}");
    }
}

fn follow(page: &str) -> usize {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(page);
    let text = std::fs::read_to_string(path).expect("the page is there");
    let folder = tempfile::tempdir().expect("a folder");
    let mut commands = 0;
    for (kind, block) in blocks(&text) {
        if let Some(name) = kind.strip_prefix("file ") {
            let place = folder.path().join(name);
            std::fs::create_dir_all(place.parent().expect("a folder")).expect("made");
            std::fs::write(place, &block).expect("written");
        }
        if kind == "console" {
            for one in block.split("$ ").filter(|one| !one.is_empty()) {
                let mut lines = one.lines();
                let line = lines.next().expect("a command");
                run(folder.path(), line, &lines.collect::<Vec<_>>());
                commands += 1;
            }
        }
    }
    commands
}

#[test]
fn what_the_pages_show_is_what_is_printed() {
    let found =
        ["as-a-referee.md", "as-an-author.md", "as-a-student.md", "as-a-maintainer.md", "gallery.md"].map(follow);
    assert_eq!(found, [3, 2, 4, 2, 12]);
}
