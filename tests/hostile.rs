//! Texts of strangers in every format: what acts is shown as a sign, what is markup there stays a text.
//!
//! Every place of a derivation file that takes a text gets every hostile text, and every writer writes the file down. The
//! list of writers is compared with what `report` has, so that a new format comes to this table or fails it.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Texts that act somewhere, each in the spelling of a TOML basic string.
const HOSTILE: &[&str] = &[
    r"\u001b[2J\u001b[1;1H\u001b[32mAll claims hold\u001b[0m\u001b[8m",
    r"\u001b]0;owned\u0007 \u0008\u0008\u0000 \u007f \u009b31m \u0085",
    r"false \u202egnissim\u202c \u2066x\u2069 \u200f \u200b \ufeff \u2028 \U000e0041",
    r"\n::stop-commands::x\n::error file=a::owned\n  ::add-mask::y",
    r"a\r::warning::b %0A::error::c ##[error]d ##vso[task.setvariable]e",
    r"<script>alert(1)</script><img src=x onerror=alert(2)> </title></style> ]]> &amp;",
    r"[l](javascript:alert(3)) ![i](http://e.invalid/p.png) | a | `c` *b* \n# H1\n```\n---\n",
    r"\\input{/etc/passwd} \\write18{id} \\end{document} $\\href{javascript:alert(4)}{x}$ ^^5c",
    r"$x=a\\label{\\input{/etc/passwd}}$ `x\\tag{\\input{q}}` $\\def\\x{y}$",
    r#"\"\"\" ''' \\\" #{} {{}} \nimport os"#,
    r#"\\`<img src=x onerror=alert(5)>` \\[l\\](javascript:alert(6)) \\*b\\* \\\\`<script>alert(7)</script>`"#,
    r"` ``<img src=x onerror=alert(8)>` `` `",
    r"$ $``<script>alert(9)</script>` `%x``<img src=x>` `\\label{x}``[l](javascript:alert(6))`",
    r"coding: unicode_escape \\u000aimport os http://e/`<img src=x>` www.e.x/`<script>` `a\\|<img src=x>` &commat;o &lt;i&gt;",
    r"[3cm] two\nAll 9 claims stand.\n\nVerdict: holds (proved)",
    r"##[error]planted ##[add-mask]x \\##[c] $a$\\`<script>` |\\| x \\",
];

/// A derivation file with this text wherever a text may stand.
fn derivation(text: &str) -> String {
    let formula = "\\label{\\immediate\\write18{touch X}\\input{/etc/passwd}}\\tag{</script><i>}";
    format!(
        r#"
[derivation]
title = "T {text}"
concerns = "C {text}"
source = "S {text}"
remark = "R {text}"
[conventions]
"k {text}" = "v {text}"
[symbols]
't' = {{ role = "time", says = "{text}" }}
'x' = {{ role = "state", says = "{text}" }}
'k' = {{ role = "parameter", says = "{text}" }}
'a' = {{ role = "abbreviation", formula = '2x{formula}', says = "{text}" }}
[system.s]
says = "Y {text}"
label = "L {text}"
states = ['x']
equations = ['\dot x=-kx{formula}']
[[trajectory]]
id = "one"
title = "M {text}"
says = "{text}"
system = "s"
parameters = {{ 'k' = 1 }}
initial = {{ 'x' = 1 }}
span = [0, 1]
[[claim]]
id = "wrong"
says = "W {text}"
place = "P {text}"
remark = "{text}"
label = "E {text}"
always = ['x=2a{formula}']
[[claim]]
id = "right"
says = "{text} G"
assuming = ['x>0{formula}']
always = ['\dot x=-kx % </script>{formula}', '''\dot x=-kx % <script>
''']
[[claim]]
id = "open"
says = "{text} G"
eventually = ['x=7{formula}']
[[measure]]
id = "m"
says = "{text}"
formula = 'x{formula}'
[[condition]]
id = "q"
says = "{text}"
holds = ['x<0.5{formula}']
"#
    )
}

fn run(folder: &Path, arguments: &[&str], colour: bool) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.current_dir(folder).env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
    if colour {
        command.env("CLICOLOR_FORCE", "1");
    }
    command.args(arguments).output().expect("it runs")
}

/// Whether a character acts: written down anew, not taken from the program.
fn acts(c: char) -> bool {
    c.is_control() && c != '\n' && c != '\t'
        || "\u{ad}\u{200b}\u{200e}\u{200f}\u{2028}\u{2029}\u{2066}\u{2067}\u{2068}\u{2069}\u{feff}".contains(c)
        || ('\u{202a}'..='\u{202e}').contains(&c)
        || ('\u{e0000}'..='\u{e007f}').contains(&c)
}

/// The text without the colours of the program: bold, faint, red, green, yellow and their likes.
fn without_colours(text: &str) -> String {
    let mut out = text.to_owned();
    for code in
        ["0", "1", "2", "31", "32", "33", "1;35", "91", "92", "94", "96", "1;91", "1;94", "1;96", "1;92", "1;33"]
    {
        out = out.replace(&format!("\u{1b}[{code}m"), "");
        out = out.replace(&format!("\u{1b}[{code}m").replace(';', "m\u{1b}["), "");
    }
    out
}

#[track_caller]
fn inert(what: &str, text: &str) {
    if let Some(c) = text.chars().find(|c| acts(*c)) {
        let at = text.find(c).expect("there");
        let near: String = text[..at].chars().rev().take(60).collect::<Vec<_>>().into_iter().rev().collect();
        panic!("{what}: U+{:04X} after {near:?}", u32::from(c));
    }
}

/// A log of a workflow reads no command in it.
#[track_caller]
fn no_command(what: &str, text: &str) {
    for line in text.lines() {
        assert!(!line.trim_start().starts_with("::"), "{what}: {line}");
        assert!(!line.contains("##[") && !line.contains("##vso["), "{what}: {line}");
    }
}

/// A line of Markdown as CommonMark takes it apart: text and code in turn. Of a text the signs are gone that a backslash makes plain.
fn spans(line: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let mut rest = line;
    while let Some(c) = rest.chars().next() {
        let run = rest.bytes().take_while(|b| *b == b'`').count();
        let after = &rest[run..];
        let fence = "`".repeat(run);
        // A run of backticks ends at the next run that is as long; without one it is text.
        let ends = || {
            let mut from = 0;
            while let Some(at) = after[from..].find(&fence) {
                let length = after[from + at..].bytes().take_while(|b| *b == b'`').count();
                if length == run {
                    return Some(from + at);
                }
                from += at + length;
            }
            None
        };
        if run > 0 {
            match ends() {
                Some(end) => {
                    out.extend([after[..end].to_owned(), String::new()]);
                    rest = &after[end + run..];
                }
                None => {
                    out.last_mut().expect("there is one").push_str(&fence);
                    rest = after;
                }
            }
            continue;
        }
        let plain = c == '\\' && rest[1..].starts_with(|next: char| next.is_ascii_punctuation());
        let length = if plain { 2 } else { c.len_utf8() };
        if !plain {
            out.last_mut().expect("there is one").push(c);
        }
        rest = &rest[length..];
    }
    out
}

#[test]
fn markdown_is_taken_apart_as_a_forge_does() {
    assert_eq!(spans(r"a \`<b>` c"), ["a <b>` c"]);
    assert_eq!(spans(r"a \\`<b>` ``x`y``"), ["a ", "<b>", " ", "x`y", ""]);
    assert_eq!(spans(r"\[l\](javascript:x) `open"), ["l(javascript:x) `open"]);
}

/// What a format may not have in it besides.
#[track_caller]
fn plain_in(format: &str, text: &str) {
    let lower = text.to_ascii_lowercase();
    let none = |words: &[&str]| {
        for word in words {
            let line = lower.lines().find(|l| l.contains(word));
            assert!(!lower.contains(word), "{format} has {word:?}: {line:?}");
        }
    };
    match format {
        "html" => {
            none(&["<img src=x", "alert(1)</script>", "<i>", "href=\"javascript"]);
            // Formulas are MathML: nothing is left of what is not set.
            assert_eq!(lower.matches("<script").count(), lower.matches("</script>").count());
        }
        "md" | "markdown" => {
            for line in lower.lines().filter(|l| !l.starts_with("```")) {
                let parts = spans(line);
                for (at, part) in parts.iter().enumerate() {
                    let set = at % 2 == 1 && parts[at - 1].ends_with('$');
                    let words: &[&str] = match (at % 2, set) {
                        (0, _) => &["<script", "<img", "](javascript", "\\label{", "\\tag{", "://", "www.", "&commat"],
                        (_, true) => &["\\label{", "\\tag{", "\\href", "\\def"],
                        (_, false) => &[],
                    };
                    for word in words {
                        assert!(!part.contains(word), "{format} has {word:?}: {line:?}");
                    }
                }
            }
            none(&["\n# h1", "\n```\n---"]);
            assert_eq!(lower.matches("```").count() % 2, 0);
        }
        "text" => {
            let forged = ["all 9 claims stand.", "verdict: holds (proved)"];
            assert!(lower.lines().all(|l| !forged.iter().any(|f| l.trim() == *f)), "{text}");
        }
        "tex" => none(&["\\\\\n[", "\\item [", "\\input", "\\write", "\\href", "\\def\\", "\\label{", "\\tag{", "^^"]),
        "py" | "lean" => {
            none(&["\nimport os"]);
            // Another encoding would make other lines of the same bytes.
            assert!(format == "lean" || lower.starts_with("# -*- coding: utf-8 -*-\n"));
            // Comments say what the file says.
            let mut program = lower.lines().filter(|l| !l.starts_with('#') && !l.starts_with("--"));
            assert!(program.all(|l| !l.contains("\\label{") && !l.contains("\\tag{")), "{format}");
        }
        "junit" => none(&["<script", "<img"]),
        _ => {}
    }
    if format == "tex" {
        assert_eq!(text.matches("\\end{document}").count(), 1);
    }
}

#[test]
fn every_hostile_text_in_every_format() {
    let mut written = 0;
    for text in HOSTILE {
        let project = tempfile::tempdir().expect("a folder");
        fs::create_dir(project.path().join("derivations")).expect("made");
        fs::write(project.path().join("derivations/h.toml"), derivation(text)).expect("written");
        for format in ["text", "json", "tex", "markdown", "junit", "sarif", "github"] {
            let output = run(project.path(), &["check", "--format", format], format == "text");
            let (out, told) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            assert_eq!(output.status.code(), Some(1), "{text}: {told}");
            let out = if format == "text" { without_colours(&out) } else { out.into_owned() };
            inert(format, &out);
            inert("told", &without_colours(&told));
            plain_in(format, &out);
            if format == "github" {
                // Every line is one of ours.
                for line in out.lines() {
                    let ours =
                        ["::error file=", "::warning file=", "::notice file="].iter().any(|b| line.starts_with(b));
                    assert!(ours && line.matches("::").count() >= 2, "{line}");
                }
                assert_eq!(out.lines().count(), 2, "{out}");
            } else {
                no_command(format, &out);
            }
            written += 1;
        }
        for (name, format) in [
            ("report.json", "json"),
            ("report.md", "md"),
            ("index.html", "html"),
            ("certificates/proof-right.py", "py"),
            ("certificates/proof-right.lean", "lean"),
        ] {
            let out = fs::read_to_string(project.path().join("reports/h").join(name)).expect("a report");
            inert(name, &out);
            plain_in(format, &out);
            written += 1;
        }
        for arguments in [
            &["list"][..],
            &["explain", "wrong"],
            &["explain", "right"],
            &["search", "wrong", "--tries", "2"],
            &["watch", "derivations/h.toml", "--checks", "1"],
        ] {
            let output = run(project.path(), arguments, false);
            let out = String::from_utf8_lossy(&output.stdout).into_owned();
            inert(arguments[0], &out);
            no_command(arguments[0], &out);
            plain_in("text", &out);
            written += 1;
        }
        // A report that a stranger wrote is compared.
        let old = fs::read_to_string(project.path().join("reports/h/report.json")).expect("a report");
        let changed = old.replace("\"id\": \"wrong\"", &format!("\"id\": \"{}\"", text.replace("\\U000e0041", "")));
        fs::write(project.path().join("old.json"), changed).expect("written");
        for format in ["text", "markdown"] {
            let output = run(project.path(), &["diff", "old.json", "reports/h/report.json", "--format", format], false);
            let out = String::from_utf8_lossy(&output.stdout).into_owned();
            inert("diff", &out);
            no_command("diff", &out);
            if format == "markdown" {
                plain_in("md", &out);
            }
            written += 1;
        }
    }
    assert_eq!(written, HOSTILE.len() * 19);
}

/// Problems quote the file as it is, and are shown.
#[test]
fn problems_are_shown_too() {
    let bad = [
        "[derivation]\ntitle = 'x \u{1b}'\n".to_owned(),
        "[derivation]\ntitle = \"a\" # \u{202e}gnissim\nconcern = 'b'\n".to_owned(),
        "[derivation]\ntitle = \"a\"\nconcerns = \"b\"\n\"\\u001b[2Jkey\\n::error::\" = 1\n".to_owned(),
        derivation("x").replace("'x=2a", "'x=2\u{202e}\u{2066}a").replace("says = \"W", "say = \"\\u001b[8m"),
        derivation("x").replace("id = \"wrong\"", "id = \"\\u001b[2J\\n::error::x\""),
        derivation("x").replace("id = \"wrong\"", "id = \"CON\""),
        derivation("x").replace("id = \"wrong\"", "id = \"a..\""),
        derivation("x").replace("system = \"s\"", "system = \"\\u001b[31ms\\r\\n::error::\""),
    ];
    for text in bad {
        let project = tempfile::tempdir().expect("a folder");
        fs::write(project.path().join("h.toml"), &text).expect("written");
        for format in ["text", "sarif", "github", "junit"] {
            let output = run(project.path(), &["check", "h.toml", "--format", format], true);
            assert_eq!(output.status.code(), Some(2), "{text}");
            for stream in [&output.stdout, &output.stderr] {
                let out = without_colours(&String::from_utf8_lossy(stream));
                inert(format, &out);
                if format != "github" {
                    no_command(format, &out);
                }
            }
        }
    }
    // The name of a file, too.
    let project = tempfile::tempdir().expect("a folder");
    let name = "a\u{1b}[2J\n::error::x\u{202e}.toml";
    if fs::write(project.path().join(name), "x = 1").is_ok() {
        for arguments in [&["check", "."][..], &["check", name], &["list", "b\u{1b}[2J\n::error::.toml"]] {
            let output = run(project.path(), arguments, true);
            let told = without_colours(&String::from_utf8_lossy(&output.stderr));
            assert_eq!(output.status.code(), Some(2), "{told}");
            inert("told", &told);
            no_command("told", &told);
        }
    }
}

/// Words of a command line that nobody understands are quoted, and act no more.
#[test]
fn words_that_are_not_understood_are_quoted_in_signs() {
    let folder = tempfile::tempdir().expect("a folder");
    let word = "--x\u{1b}[2J\n::error::x\u{202e}";
    for arguments in [
        &["check", word][..],
        &[&word[2..]],
        &["lint", "--format", word],
        &["check", "--output", word],
        &["check", "--work", word],
    ] {
        let output = run(folder.path(), arguments, false);
        let told = without_colours(&String::from_utf8_lossy(&output.stderr));
        assert_eq!(output.status.code(), Some(2), "{told}");
        assert!(told.contains("\u{241b}"), "{told}");
        inert("told", &told);
        no_command("told", &told);
    }
}

#[test]
fn a_paper_of_strangers_is_text_on_its_page() {
    let texts = [
        "<script>alert(1)</script>",
        "<img src=x onerror=alert(1)>",
        "\" onload=\"alert(1)",
        "&lt;script>",
        "</title><b>",
    ];
    for text in texts {
        let source = format!(
            "\\title{{{text}}}$x={text}$\\begin{{equation}}\\label{{{text}}} a=\\text{{{text}}}b \\end{{equation}}"
        );
        let source = rederive::diag::Source { path: text.to_owned(), text: source };
        let Ok(paper) = rederive::paper::parse(source, String::new()) else { continue };
        let found = rederive::lint::lint(&paper, &rederive::check::Limits::default());
        let told = rederive::report::lint_findings(&paper, &found);
        inert("github", &rederive::report::github(&told));
        let page = rederive::report::lint_page(&paper, &found);
        let formulas = rederive::report::lint_formulas(&paper, &found).concat();
        let answer = rederive::Session::blank().prove(&rederive::Question {
            proposition: rederive::check::Proposition { formula: format!("{text}=1"), ..Default::default() },
            symbols: vec!["x".to_owned()],
            scope: None,
        });
        let typeset = answer.ok().and_then(|a| a.mathml()).unwrap_or_default();
        for command in ["<script", "<img", "</title><b>", "\" onload"] {
            for shown in [&page, &formulas, &typeset] {
                assert!(!shown.contains(command), "{text}: {shown}");
            }
        }
        // The document is data: a text of the paper is a string in it, and nothing else.
        let document = rederive::report::lint_document(&paper, &found);
        assert_eq!(document["paper"], text);
        assert_eq!(document["relations"].as_array().map(Vec::len), Some(found.judgements.len()));
        let unread = rederive::report::unread_document(text, text);
        assert_eq!((&unread["paper"], &unread["unreadable"]), (&document["paper"], &document["paper"]));
    }
}

/// The writers of `report`: each is in the table above, or makes nothing of a file's texts.
#[test]
fn the_table_has_every_writer() {
    let listed = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/report/lib.rs")).expect("read");
    let mut found: Vec<&str> = listed
        .lines()
        .filter(|l| l.starts_with("pub use "))
        .flat_map(|l| l.split(|c: char| !c.is_alphanumeric() && c != '_'))
        .filter(|w| w.starts_with(|c: char| c.is_ascii_lowercase()))
        .filter(|w| !["pub", "use"].contains(w))
        .collect();
    found.sort_unstable();
    found.dedup();
    let in_the_table = [
        "lint_findings",
        "lint_document",
        "unread_document",
        "lint_formulas",
        "lint_json",
        "lint_page",
        "formula_mathml",
        "mathml",
        "certificate_text",
        "contents",
        "certificates",
        "lean_text",
        "diff",
        "diff_files",
        "diff_text",
        "checked_again",
        "exceptions",
        "explain",
        "finding",
        "findings",
        "github",
        "json",
        "json_with_paper",
        "junit",
        "markdown",
        "markup",
        "fenced",
        "prose",
        "page",
        "paper",
        "paper_findings",
        "paper_summary",
        "problems",
        "proposition",
        "proposition_json",
        "proposition_text",
        "sarif",
        "search",
        "search_notes",
        "search_table",
        "summary",
        "tex",
        "add_paper",
        "first_page",
        "front",
        "front_markdown",
        "front_page",
        "page_one",
        "printed_page",
        "tex_summary",
    ];
    // A part of a family has ids in JSON, and numbers; it is for the program alone. The members have ids and names of symbols, and numbers.
    // An assumption is a formula that the program writes, of declared names, without quotes and line breaks.
    let no_texts = [
        "assumption",
        "assumptions",
        "audit",
        "proof_file",
        "proofs",
        "alarms",
        "is_worse",
        "member_line",
        "members",
        "members_head",
        "part",
        "part_text",
        "read_parts",
        "rule_says",
        "schema",
        "fit_terminal",
        "text",
    ];
    let missing: Vec<&&str> = found.iter().filter(|f| !in_the_table.contains(f) && !no_texts.contains(f)).collect();
    assert!(missing.is_empty(), "write these down in the table of hostile texts: {missing:?}");
}

/// Files that took minutes and gigabytes, or all verdicts with one claim: each ends with its reason.
#[test]
fn what_takes_too_much_work_ends_with_its_reason() {
    let project = tempfile::tempdir().expect("a folder");
    let check = |name: &str, text: &str| {
        fs::write(project.path().join(name), text).expect("written");
        let output = run(project.path(), &["check", name, "--no-reports", "--no-cache"], false);
        let told = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
        (output.status.code(), told)
    };
    let head = "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = { role = 'time' }\n'x' = { role = 'state' }\n\
                'k' = { role = 'parameter' }\n";
    let motion = "[system.s]\nstates = ['x']\nequations = ['\\dot x=-kx']\n[[trajectory]]\nid = 'a'\nsystem = 's'\n\
                  parameters = { 'k' = 1 }\ninitial = { 'x' = 1 }\nspan = [0, 1]\n";
    // A function calls another one twice, and that one another one twice: 2²³ different terms.
    let mut calls =
        "'f_{\\rm a}(\\alpha)' = { role = 'abbreviation', arguments = ['\\alpha'], formula = '\\sin\\alpha' }\n"
            .to_owned();
    for (of, name) in ('a'..='w').zip('b'..='x') {
        calls += &format!(
            "'f_{{\\rm {name}}}(\\alpha)' = {{ role = 'abbreviation', arguments = ['\\alpha'], formula = \
             'f_{{\\rm {of}}}(\\alpha+1)+f_{{\\rm {of}}}(2\\alpha)' }}\n"
        );
    }
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x=f_{\\rm x}(x)']\n[[claim]]\nid = 'good'\nsays = 's'\n\
                 always = ['\\dot x=-kx']\n[[claim]]\nid = 'from'\nsays = 's'\nalways = ['x=-x']\nfollows-from = ['c']\n";
    let (code, told) = check("calls.toml", &[head, &calls, motion, claim].concat());
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("work limit: reading a formula") && told.contains("--work 10"), "{told}");
    assert!(told.contains("1 hold, 1 fail, 0 do not apply, 1 undecided"), "{told}");
    // What motions need is needed by the whole file.
    let needed = motion.replace("-kx", "-kx+f_{\\rm x}(x)");
    let (code, told) = check("needed.toml", &[head, &calls, &needed, claim].concat());
    assert_eq!(code, Some(2), "{told}");
    assert!(told.contains("work limit: reading a formula") && told.contains("needed.toml:"), "{told}");
    // Over ranges, and over all fields, it is undecided, too.
    let over = claim
        .replace("'s'\nalways = ['x=f_{\\rm x}(x)']", "'s'\nalways = ['k=f_{\\rm x}(k)']\nranges = { 'k' = [0, 1] }");
    let (code, told) = check("over.toml", &[head, &calls, motion, &over].concat());
    assert!(code == Some(1) && told.contains("1 undecided"), "{told}");

    // The program contradicted itself here, and no claim had a verdict.
    let nowhere = "[[claim]]\nid = 'good'\nsays = 's'\nalways = ['\\dot x=-kx']\n[[claim]]\nid = 'c'\nsays = 's'\n\
                   always = ['e^{\\ln k}=e^{\\ln(-k)}']\n";
    let (code, told) = check("nowhere.toml", &[head, motion, nowhere].concat());
    assert_eq!(code, Some(0), "{told}");
    let output = run(project.path(), &["prove", r"e^{\ln x}=e^{\ln(-x)}", "--symbol", "x"], false);
    assert_eq!(output.status.code(), Some(3));
}
