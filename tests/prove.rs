//! `rederive prove`: what it prints, how it ends, and that the page on proofs shows it as it is.

use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

fn prove(arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    let command = command.current_dir(env!("CARGO_MANIFEST_DIR")).arg("prove").args(arguments);
    let output = command.output().expect("the program runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    (output.status.code().unwrap_or(-1), text(output.stdout), text(output.stderr))
}

#[track_caller]
fn ends(code: i32, arguments: &[&str]) -> String {
    let (found, out, err) = prove(arguments);
    assert_eq!(found, code, "{arguments:?}\n{out}{err}");
    assert_eq!(out.is_empty(), code == 2, "{arguments:?}\n{out}{err}");
    assert!(!err.contains("panicked"), "{err}");
    out + &err
}

#[test]
fn a_formula_may_begin_with_a_sign() {
    ends(0, &["-x=-1\\cdot x", "-s", "x"]);
    ends(0, &["--symbol", "x", "-x+x=0"]);
    ends(0, &["-s", "x", "--", "-x+x=0"]);
    ends(2, &["-s", "x", "x=x", "--certificat"]);
}

#[test]
fn words_of_a_symbol_want_commas() {
    let said = ends(2, &["-s", "A(x,y,z): field 3", "\\nabla\\cdot A=0"]);
    assert!(said.contains("write commas between the words: `field, 3`"), "{said}");
}

/// What is the same in each base is decided, and says so; what is not is refused.
#[test]
fn the_base_of_a_logarithm_need_not_be_known() {
    let told = "either base that `\\log` may have";
    assert!(ends(0, &["\\log(ab)=\\log a+\\log b", "-s", "a, b: positive"]).contains(told));
    assert!(ends(1, &["\\log(a+b)=\\log a+\\log b", "-s", "a, b: positive"]).contains(told));
    for depends in ["\\log 10=1", "\\ln x=\\log x"] {
        assert!(ends(2, &[depends, "-s", "x"]).contains("latex::base-of-logarithm"), "{depends}");
    }
    assert!(!ends(0, &["\\log 10=1", "--log", "decimal"]).contains(told));
}

/// The words of a line as a shell takes them: blanks separate, single quotes keep together.
fn words(line: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '\'' => quoted = !quoted,
            ' ' if !quoted => out.push(String::new()),
            c => out.last_mut().expect("never empty").push(c),
        }
    }
    assert!(!quoted, "a quote stays open: {line}");
    out.retain(|w| !w.is_empty());
    out
}

#[test]
fn the_page_on_proofs_shows_what_is_printed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/proofs.md");
    let page = std::fs::read_to_string(path).expect("the page is there");
    let mut tried = 0;
    for block in page.split("```console\n").skip(1) {
        let block = block.split("```").next().expect("an end");
        for example in block.split("$ rederive prove ").skip(1) {
            let (line, expected) = example.split_once('\n').expect("a command and its output");
            let arguments = words(line);
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let (code, out, err) = prove(&arguments);
            assert_eq!(format!("{out}{err}").trim_end(), expected.trim_end(), "{line}");
            let verdict = expected.lines().next().unwrap_or_default();
            let meant = match verdict {
                "proved" | "proved unreplayed" => 0,
                "refuted" => 1,
                "undecided" => 3,
                _ => 2,
            };
            assert_eq!(code, meant, "{line}");
            tried += 1;
        }
    }
    assert!(tried >= 12, "{tried} examples");
}

#[test]
fn symbols_are_declared_as_in_a_file() {
    ends(
        0,
        &[r"RR^T=\mathbb 1", "-s", "R: 2x2", "-s", "a", "-g", r"R_{11}=R_{22}=\cos a", "-g", r"R_{21}=-R_{12}=\sin a"],
    );
    ends(0, &[r"\det I=I_1I_2I_3, \frac{I_1}{I_1}=1", "-s", "I: diagonal 3, positive"]);
    ends(0, &[r"|x|=x", "-s", "x: positive"]);
    ends(1, &[r"|x|=x", "-s", "x"]);
    ends(0, &[r"f(2a)=2f(a)\cos a", "-s", "a", "-s", r"f(\alpha) = \sin\alpha"]);
    ends(0, &[r"\dot r=\frac{x\dot x+y\dot y}{r}", "-s", "x, y: state", "-s", r"r: observable = \sqrt{x^2+y^2}"]);
    ends(0, &[r"\dot x=2t", "-s", "x: state", "-g", "x=t^2"]);
    ends(0, &[r"\dot x=2\tau", "-s", r"\tau: time", "-s", "x: state", "-g", r"x=\tau^2"]);
    // Typed symbols beside those of a file, and those of a claim.
    ends(0, &["h=c-c+h", "--in", "derivations/pendulum.toml", "-s", "c"]);
    let comment = "derivations/deriglazov-comment.toml";
    ends(0, &[r"\dot E=0", "--in", comment, "-g", "t1-euler/cross-product"]);
}

#[test]
fn what_is_false_is_never_proved() {
    ends(1, &["(a+b)^2=a^2+b^2", "-s", "a, b"]);
    ends(1, &[r"\sin 2x=2\sin x", "-s", "x"]);
    ends(1, &["x=y", "-s", "x, y", "-g", "x^2=y^2"]);
    ends(1, &[r"\sqrt{x^2}=\pm x", "-s", "x", "--branches", "throughout"]);
    ends(1, &[r"x=\pm 2y", "-s", "x, y", "-g", "x=3y", "-g", r"y\ne 0"]);
    // From a contradiction nothing follows, though there would be a certificate.
    for premises in [["x=1", "x=2"], ["x>0", "x<0"], ["x=0", r"x\ne 0"], ["x^2=-1", "y=2"]] {
        let text = ends(3, &["y=1", "-s", "x, y", "-g", premises[0], "-g", premises[1]]);
        assert!(text.contains("contradict each other"), "{premises:?}: {text}");
    }
    ends(3, &[r"\frac{x}{y-y}=\frac{x}{y-y}", "-s", "x, y"]);
    ends(3, &[r"\frac{x}{0}=1", "-s", "x"]);
}

#[test]
fn problems_are_shown_at_their_places() {
    let text = [
        &["x^2+=y", "-s", "x, y"][..],
        &["x=w, y=v", "-s", "x, y", "-g", "z>0"],
        &["x<y", "-s", "x, y"],
        &["x=y", "-s", "x, y: postive"],
        &["x=y", "-s", "x", "-s", "y = x +"],
        &["x=y", "-s", "x, y", "-s", "x"],
        &["x=y", "-s", "x,, y"],
        &["x=y", "-s", "x, y: state, positive"],
        &["x=y", "-s", "x: abbreviation", "-s", "y: state = 3"],
        &["x=y", "-s", "x, y", "-g", r"\lim_{t\rightarrow 0}x=y"],
        &["", "-s", "x"],
        &["h=0", "--in", "derivations/pendulum.toml", "-g", "enrgy"],
        &["E=0", "--in", "derivations/deriglazov-comment.toml", "-g", "t8"],
        &["E=0", "--in", "derivations/deriglazov-comment.toml", "--scope", "t99"],
        &["E=0", "--in", "derivations/none.toml"],
    ]
    .map(|arguments| format!("$ rederive prove {}\n{}", arguments.join(" | "), ends(2, arguments)))
    .join("\n");
    insta::assert_snapshot!(text);
}

#[test]
fn json_has_all_that_is_known() {
    let read =
        |code, arguments: &[&str]| -> Value { serde_json::from_str(&ends(code, arguments)).expect("this is JSON") };
    let proved = read(0, &[r"\sin 2x=2\sin x\cos x", "-s", "x", "--format", "json"]);
    assert_eq!(proved["verdict"], "proved");
    assert_eq!(proved["field"], "GF(p^2)");
    assert!(proved["log2_error"].as_f64().is_some_and(|b| b <= -100.0), "{proved}");
    assert_eq!(proved["trials"]["count"], proved["trials"]["primes"].as_array().map_or(0, Vec::len));
    assert!(proved["certificate"].as_str().is_some_and(|c| c.contains("\ncheck(\n")), "{proved}");
    let refuted = read(1, &["x=y", "-s", "x, y", "-g", "x^2=y^2", "--format", "json"]);
    let (left, right) = (&refuted["witness"]["left"], &refuted["witness"]["right"]);
    assert!(left != right && left == &refuted["witness"]["point"]["x"], "{refuted}");
    assert_eq!(refuted["certificate"], Value::Null);
    let open = read(3, &["y=1", "-s", "x, y", "-g", "x=1=2", "--format", "json"]);
    assert_eq!((&open["verdict"], &open["contradiction"]), (&"undecided".into(), &true.into()));
    let branch = read(0, &[r"|x|=\pm x", "-s", "x: positive", "--branches", "throughout", "--format", "json"]);
    assert_eq!(branch["branch"], "with the upper sign");
    // The same bytes every time.
    assert_eq!(prove(&["x=x^2", "-s", "x"]), prove(&["x=x^2", "-s", "x"]));
}

#[test]
fn nothing_typed_makes_it_panic() {
    let odd = [
        "",
        " ",
        "=",
        ":",
        ",",
        "x:",
        "x=",
        "{",
        "}",
        "(",
        "\\",
        "é: 3",
        "x: 3x3x3x3x3x3x3",
        "f() = 1",
        "f(,) = 1",
        "x(a = 1",
    ];
    for text in odd {
        let (code, _, err) = prove(&["x=1", "-s", text]);
        assert!((code == 2 || text.is_empty()) && !err.contains("panicked"), "`{text}`: {code} {err}");
        let (code, _, err) = prove(&[text, "-s", "x"]);
        assert!(code == 2 && !err.contains("panicked"), "`{text}`: {code} {err}");
        let (code, _, err) = prove(&["x=1", "-s", "x", "-g", text]);
        assert!(code == 2 && !err.contains("panicked"), "`{text}`: {code} {err}");
    }
}

/// Numbers that grow without end, and what names the time alone, took a minute or all memory.
#[test]
fn what_grows_without_end_is_left_at_once() {
    let within = |code: i32, arguments: &[&str]| {
        let mut command = Command::cargo_bin("rederive").expect("the program is built");
        command.arg("prove").args(arguments).timeout(std::time::Duration::from_secs(20)).assert().code(code);
    };
    // The square of a square, forty-five times.
    let squares = format!("{}x+1{}=1", "(".repeat(45), ")^2".repeat(45));
    within(1, &[&squares, "-s", "x"]);
    let given = ["-g", r"\dot x=y", "-g", "|t|=ty(0)", "-g", "y=0"];
    // y(0) = 0, and |t| is 0 at one time only: no motion satisfies that.
    within(3, &[&["x=x(0)", "-s", "x,y: state"], &given[..]].concat());
}
