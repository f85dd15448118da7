//! What has no one meaning is refused, with the place.

use rederive::check::{CheckError, Options, check};
use rederive::derivation::parse;
use rederive::diag::Source;

const HEAD: &str = r#"
[derivation]
title = "Refused"
concerns = "rederive's own tests"
"#;

const SYMBOLS: &str = r#"
[symbols]
't' = { role = "time" }
'a' = { role = "parameter" }
'x' = { role = "state" }
'y' = { role = "state" }
"#;

const SCENE: &str = r#"
[system.unit]
states = ['x', 'y']
equations = ['\dot x=1', '\dot y=0']

[[trajectory]]
id = "m"
system = "unit"
parameters = { 'a' = 1 }
initial = { 'x' = 0, 'y' = 1 }
span = [0, 4]
"#;

/// Claims: a name, and its lines.
const CLAIMS: &[(&str, &str)] = &[
    ("a time that is a sum of numbers", r"always = ['x(0+1)=1']"),
    ("a rate of a value, or a value of a rate", r"always = ['\frac{d}{dt}x(0)=1']"),
    ("a limit that is to be what moves", r"always = ['\lim_{t\rightarrow 0}x=y']"),
    ("a limit that is to be a rate", r"always = ['\lim_{t\rightarrow 0}x=\dot x']"),
    ("plus-minus in never and in always", "always = ['x=\\pm x']\nnever = ['x=\\pm 2']"),
    ("plus-minus at some time and at all, pointwise", "always = ['x=\\pm x']\neventually = ['x=\\pm 2']"),
    ("plus-minus in a first integral and in always", "always = ['x=\\pm x']\nfirst-integral = ['x\\pm x']"),
    ("neither, and plus-minus elsewhere", r"always = ['x\ne\pm 5', 'x=\pm x']"),
    ("neither, and plus-minus assumed", "assuming = ['\\pm x>-5']\nalways = ['x\\ne\\pm 5']"),
    (
        "plus-minus in an abbreviation",
        "symbols = { 'g' = { role = \"abbreviation\", formula = '\\pm a' } }\nalways = ['g^2=1']",
    ),
    (
        "plus-minus in an observable",
        "symbols = { 'g' = { role = \"observable\", formula = '\\pm x' } }\nalways = ['g^2=x^2']",
    ),
];

/// Scenes: a name, and what stands there instead.
const SCENES: &[(&str, &str, &str)] = &[
    ("plus-minus in an initial value", "'x' = 0,", r"'x' = '\pm 1',"),
    ("plus-minus in a parameter", "'a' = 1 ", r"'a' = '\pm 1' "),
    ("plus-minus in a system", r"\dot x=1", r"\dot x=\pm 1"),
];

/// What is read in this version nonetheless.
const KNOWN_READ: &[&str] = &[];

/// Whether a file is refused when it is read, or when it is prepared to be checked.
fn is_refused(file: String) -> bool {
    match parse(Source { path: "refused".to_owned(), text: file }, "refused") {
        Err(_) => true,
        Ok(derivation) => {
            let options = Options { plain: true, ..Options::default() };
            matches!(check(&derivation, &options, &|_, _| {}), Err(CheckError::Problems(_)))
        }
    }
}

#[test]
fn what_has_no_one_meaning_is_refused() {
    let claim = |lines: &str| format!("[[claim]]\nid = \"c\"\nsays = \"c\"\n{lines}\n");
    let fine = claim("always = ['x=t']");
    assert!(!is_refused(format!("{HEAD}{SYMBOLS}{SCENE}{fine}")), "the scene itself is read");
    let mut read: Vec<&str> = Vec::new();
    for (name, lines) in CLAIMS {
        if !is_refused(format!("{HEAD}{SYMBOLS}{SCENE}{}", claim(lines))) {
            read.push(name);
        }
    }
    for (name, from, to) in SCENES {
        assert!(SCENE.contains(from), "{name}");
        if !is_refused(format!("{HEAD}{SYMBOLS}{}{fine}", SCENE.replace(from, to))) {
            read.push(name);
        }
    }
    assert_eq!(read, KNOWN_READ, "read, though refused by its meaning; or listed, though refused now");
}
