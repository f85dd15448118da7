//! What the loader says about files that are wrong: every problem, with its place.

use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};

/// The problems of a text, as they are printed.
fn problems(text: &str) -> String {
    match load(text) {
        Ok(_) => "no problem\n".to_owned(),
        Err(text) => text,
    }
}

fn load(text: &str) -> Result<Derivation, String> {
    let source = Source { path: "derivations/test.toml".into(), text: text.into() };
    parse(source, "test").map_err(|found| render(&found, false))
}

const HEAD: &str = r"
[derivation]
title = 'T'
concerns = 'C'

[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'v' = { role = 'state', shape = '2' }
'a' = { role = 'parameter' }
'I' = { role = 'parameter', shape = 'diagonal 3', positive = true }

[system.free]
states = ['x', 'v']
equations = ['\dot x=a', '\dot v=v']
";

const MOTION: &str = r"
[[trajectory]]
id = 'one'
system = 'free'
initial = { 'x' = 0, 'v' = [1, '-a'] }
parameters = { 'a' = 2.5, 'I' = [1.748, 1.638, 0.121] }
span = [0, 10]
";

fn with(parts: &[&str]) -> String {
    parts.concat()
}

#[test]
fn a_good_file_loads() {
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x=0, a=1']\nexpect = { holds = ['one'] }\n";
    let d = load(&with(&[HEAD, MOTION, claim])).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((d.id.as_str(), d.systems.len(), d.trajectories.len()), ("test", 1, 1));
    assert_eq!(d.claims[0].forms.len(), 2);
    assert_eq!(d.claims[0].formulas.len(), 1);
    assert_eq!(d.claims[0].expect, [Some("holds")]);
    assert_eq!(d.trajectories[0].source(), "integrated");
}

#[test]
fn the_frame_of_a_file() {
    insta::assert_snapshot!("empty_file", problems(""));
    insta::assert_snapshot!("toml_syntax", problems("[derivation]\ntitle = 'a\nconcerns = = 'b'\n"));
    insta::assert_snapshot!("escape", problems("[derivation]\ntitle = \"\\Omega\"\n"));
    insta::assert_snapshot!(
        "unknown_keys",
        problems(&with(&[HEAD, "[conventons]\na = 'b'\n[[claim]]\nid = 'c'\nsays = 's'\nalway = ['x=0']\nfoo = 1\n"]))
    );
    insta::assert_snapshot!(
        "wrong_types",
        problems(&with(&[
            HEAD,
            "[[claim]]\nid = 'c'\nsays = 7\nalways = 'x=0'\nprecision = 'small'\ntrajectories = [1]\n"
        ]))
    );
}

#[test]
fn formulas_in_double_quotes() {
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = [\"\\theta = x\", \"x=0\", \"\"\"x\n=\\t\"\"\"]\n";
    insta::assert_snapshot!("double_quotes", problems(&with(&[HEAD, claim])));
    let key = "[derivation]\ntitle='T'\nconcerns='C'\n[symbols]\n\"\\theta\" = { role = 'parameter' }\n'x' = { role = 'abbreviation', formula = \"\\beta\" }\n";
    insta::assert_snapshot!("double_quoted_key", problems(key));
}

#[test]
fn names_with_primes_and_backslashes() {
    let head = "[derivation]\ntitle='T'\nconcerns='C'\n[symbols]\n";
    let both = "\"{\\\\bf A}'\" = { role = 'parameter' }\n'{\\bf B}^\\prime' = { role = 'parameter' }\n";
    let d = load(&with(&[head, both])).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<&str> = d.symbols.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, [r"{\bf A}'", r"{\bf B}^\prime"]);
    // Where TOML would change backslashes, the hint is what TOML reads.
    let found = problems(&with(&[head, "\"\\theta'\" = { role = 'parameter' }\n"]));
    assert!(found.contains("derivation::quoted-formula") && found.contains("write \"\\\\theta'\""), "{found}");
    let found = problems(&with(&[head, "'{\\bf A}'' = { role = 'parameter' }\n"]));
    assert!(found.contains("derivation::toml") && found.contains(r"write `^\prime`"), "{found}");
}

#[test]
fn a_name_is_missed_once() {
    let head = "[derivation]\ntitle='T'\nconcerns='C'\n[symbols]\n't' = { role = 'time' }\n";
    let symbols = "'g_1' = { role = 'stte' }\n'h(x)' = { role = 'state', shape = 'y' }\n'k' = { role = 'abbreviation', formula = 'g_1+1' }\n";
    let claim = |id: &str, formula: &str| format!("[[claim]]\nid = '{id}'\nsays = 's'\nalways = ['{formula}']\n");
    let found = problems(&with(&[
        head,
        symbols,
        &claim("a", "g_1=k"),
        &claim("b", "q_1=1, q_2=1, h(x)=q_1"),
        &claim("c", "q_1=g_1"),
    ]));
    assert_eq!(found.matches("error[").count(), 4, "{found}");
    for text in ["there is no role `stte`", "is not a shape", "`q_1` is not declared", "`q_2` is not declared"] {
        assert_eq!(found.matches(text).count(), 1, "{text}: {found}");
    }
}

#[test]
fn a_formula_with_a_problem_has_its_place() {
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x = y', '''\nx=0,\na = zz''', '''q=1''']\n";
    insta::assert_snapshot!("formula_places", problems(&with(&[HEAD, claim])));
}

#[test]
fn symbols() {
    let text = r"[derivation]
title = 'T'
concerns = 'C'
[symbols]
'a' = { role = 'paramter' }
'b' = { role = 'parameter', shape = '3y3' }
'c' = { role = 'parameter', formula = 'a' }
'd' = { role = 'observable' }
'e' = { shape = 3 }
'f' = 3
'g' = { role = 'state', shape = '99999x9' }
'h' = { role = 'state', positiv = true }
";
    insta::assert_snapshot!("symbols", problems(text));
}

#[test]
fn trajectories() {
    let text = r"
[[trajectory]]
id = 'components'
system = 'free'
initial = { 'x' = [1, 2], 'v' = [1, 2, 3] }
parameters = { 'a' = 'I', 'I' = [1, -2, 3] }
span = [0, 1]
[[trajectory]]
id = 'components'
system = 'free'
initial = { 'x' = 'a', 'a' = 3, 'y' = 2 }
span = [1, 0]
[[trajectory]]
id = 'b'
system = 'fre'
initial = { 'x' = 1 }
span = [0, inf]
[[trajectory]]
id = 'c'
system = 'free'
formula = { 'x' = 't' }
span = [0]
[[trajectory]]
id = 'no value'
system = 'free'
initial = { 'x' = 1, 'v' = [1, 2] }
span = [0, 1]
[[trajectory]]
id = 'd'
system = 'free'
initial = { 'x' = 'a', 'v' = ['x', 1e999] }
initial-time = 3
span = [0, 1]
[[trajectory]]
id = 'e'
from = 'f'
[[trajectory]]
id = 'f'
from = 'e'
[[trajectory]]
id = 'g'
from = 'nobody'
map = { 'x' = 'x' }
[[trajectory]]
id = 'h'
system = 'free'
initial = { 'x' = 1 }
map = { 'x' = 'x' }
span = [0, 1]
";
    insta::assert_snapshot!("trajectories", problems(&with(&[HEAD, text])));
}

#[test]
fn claims() {
    let text = r"
[[claim]]
id = 'c'
says = 's'
[[claim]]
id = 'c'
says = 's'
always = ['x=0']
[[claim]]
id = 'd'
says = ''
always = []
follows-from = ['d', 'cc', 'free', 'a', 'c']
expect = { holds = ['one', 'oen'], fails = ['one'], undecided = 'others', not-applicable = 'all' }
[[claim]]
id = 'e'
says = 's'
solves = 'fee'
same-motion = { as = 'two', of = ['x'] }
independent = { function = ['x'] }
at = 'v=v'
expect = 'hold'
[[claim]]
id = 'f'
says = 's'
[[claim.reading]]
id = 'r'
says = 'rs'
[[claim.reading]]
id = 'r'
says = 'rs'
always = ['x=0']
[[claim]]
id = 'g'
says = 's'
symbols = { 'k' = { role = 'state' } }
assuming = ['k=0']
always = ['x=0']
precision = 2
[[measure]]
id = 'm'
says = 's'
formula = 'v'
at = 'x>0'
[[measure]]
says = 's'
";
    insta::assert_snapshot!("claims", problems(&with(&[HEAD, MOTION, text])));
}

#[test]
fn files_that_are_no_derivation_files() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let shown = |name: &str, bytes: Option<&[u8]>| {
        let path = folder.path().join(name);
        if let Some(bytes) = bytes {
            std::fs::write(&path, bytes).expect("the file can be written");
        }
        let found = rederive::derivation::load(&path).expect_err("this is no derivation file");
        render(&found, false).replace(&folder.path().display().to_string(), "FOLDER")
    };
    insta::assert_snapshot!("missing_file", shown("missing.toml", None));
    insta::assert_snapshot!("folder", shown("", None));
    insta::assert_snapshot!("not_utf8", shown("latin1.toml", Some(b"[derivation]\ntitle = 'Marde\xb9i\xe6'\n")));
    insta::assert_snapshot!("too_large", shown("large.toml", Some(&vec![b'#'; (4 << 20) + 1])));
}

#[test]
fn hostile_files_are_refused_without_a_crash() {
    for text in [
        format!("a = {}1{}", "[".repeat(100_000), "]".repeat(100_000)),
        format!("{}[[claim]]\nid='c'\nsays='s'\nalways=['{}x=0']\n", HEAD, "{".repeat(100_000)),
        format!("{}[[claim]]\nid='c'\nsays='s'\nalways=[{}]\n", HEAD, "'',".repeat(20_000)),
        "\u{feff}[derivation]\r\ntitle = '''\r\nx'''\r\n".to_owned(),
        "[[claim]]\n".repeat(20_000),
        "\0".to_owned(),
        "[symbols]\n'x' = { role = 'state', shape = '1x1x1x1x1x1x1x1x1x1x1x1' }".to_owned(),
    ] {
        assert!(problems(&text).contains("error["), "{}", &text[..60.min(text.len())]);
    }
}

#[test]
fn a_map_has_the_values_of_its_own_parameters() {
    let derived = "[[trajectory]]\nid = 'two'\nfrom = 'one'\nparameters = { 'a' = 3 }\nmap = { 'x' = 'a x' }\n";
    let d = load(&with(&[HEAD, MOTION, derived])).unwrap_or_else(|e| panic!("{e}"));
    let rederive::derivation::Motion::Derived { from: 0, map } = &d.trajectories[1].motion else {
        panic!("{:?}", d.trajectories[1].motion)
    };
    let names: Vec<&str> =
        d.graph.leaves(map[0].1.value.iter().copied()).iter().map(|l| d.graph.name(l.symbol)).collect();
    assert_eq!(names, ["x"]);
    assert_eq!(d.trajectories[1].span, d.trajectories[0].span);
}

#[test]
fn no_claim_follows_from_itself() {
    let claim = |id: &str, from: &str, more: &str| {
        format!("[[claim]]\nid = '{id}'\nsays = 's'\nalways = ['x=0']\nfollows-from = [{from}]\n{more}")
    };
    let reading = |id: &str, from: &str| {
        format!("[[claim.reading]]\nid = '{id}'\nsays = 's'\nalways = ['x=1']\nfollows-from = [{from}]\n")
    };
    let circle = [claim("a", "'free', 'b'", ""), claim("b", "'c'", ""), claim("c", "'a', 'd'", ""), claim("d", "", "")];
    insta::assert_snapshot!("circle", problems(&with(&[HEAD, MOTION, &circle.concat()])));
    // A reading may follow from another of the same claim, but not in a circle, and not from itself.
    let readings = [reading("r", "'a'"), reading("s", "'a/r'"), reading("u", "'a/v'"), reading("v", "'a/u', 'a/w'")];
    let own = claim("a", "'free'", &readings.concat());
    insta::assert_snapshot!("circle_of_readings", problems(&with(&[HEAD, MOTION, &own])));
    // Two ways to one premise are no circle.
    let two = [claim("a", "'b', 'c'", ""), claim("b", "'d'", ""), claim("c", "'d'", ""), claim("d", "'free'", "")];
    assert_eq!(problems(&with(&[HEAD, MOTION, &two.concat()])), "no problem\n");
}

#[test]
fn a_sign_that_is_two_has_no_place_where_there_is_one_value() {
    let definition = |formula: &str, role: &str| {
        let declared = format!("'t' = {{ role = 'time' }}\n'g' = {{ role = '{role}', formula = '{formula}' }}");
        HEAD.replace("'t' = { role = 'time' }", &declared)
    };
    let initial = MOTION.replace("'x' = 0", r"'x' = '\pm1'");
    let component = MOTION.replace("'-a'", r"'\mp a'");
    let parameter = MOTION.replace("'a' = 2.5", r"'a' = '2\pm1'");
    let by_formula = r"
[[trajectory]]
id = 'given'
formula = { 'x' = '\pm t' }
span = [0, 1]
";
    let system = HEAD.replace(r"'\dot x=a'", r"'\dot x=\pm a'");
    let measure = "[[measure]]\nid = 'm'\nsays = 's'\nformula = 'x\\pm a'\n";
    let condition = "[[condition]]\nid = 'm'\nsays = 's'\nholds = ['x=\\pm a']\n";
    let independent = "[[claim]]\nid = 'c'\nsays = 's'\nindependent = { functions = ['x\\pm a'] }\n";
    for text in [
        definition(r"\pm a", "abbreviation"),
        definition(r"1-\frac{a\mp1}{2}", "observable"),
        with(&[HEAD, &initial]),
        with(&[HEAD, &component]),
        with(&[HEAD, &parameter]),
        with(&[HEAD, by_formula]),
        with(&[&system, MOTION]),
        with(&[HEAD, MOTION, measure]),
        with(&[HEAD, MOTION, condition]),
        with(&[HEAD, MOTION, independent]),
    ] {
        let found = problems(&text);
        assert!(found.contains('±') && found.contains("test.toml:"), "{text}\n{found}");
    }
    // In claims it has a scope.
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nassuming = ['a=\\pm1']\nalways = ['a^2=1']\n";
    assert!(load(&with(&[HEAD, MOTION, claim])).is_ok());
}

#[test]
fn what_log_means_is_a_convention_of_the_file() {
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['a=\\log x']\n";
    assert!(problems(&with(&[HEAD, MOTION, claim])).contains("[conventions]"));
    for (word, fine) in [("natural", true), ("decimal", true), ("binary", false)] {
        let convention = format!("[conventions]\nlog = '{word}'\n");
        assert_eq!(load(&with(&[HEAD, &convention, MOTION, claim])).is_ok(), fine, "{word}");
    }
}

/// What an attribute means for one role only is refused of others, rather than ignored.
#[test]
fn attributes_of_other_roles() {
    for (symbol, words) in [
        (r"'z(\alpha)' = { role = 'observable', arguments = ['\alpha'], formula = '\alpha x' }", "has no arguments"),
        (r"'z' = { role = 'abbreviation', angle = true, formula = '\arctan x' }", "are not continued along a motion"),
        (r"'\beta' = { role = 'parameter', angle = true }", "are not continued along a motion"),
        ("'s' = { role = 'state', positive = true }", "only parameters are declared positive"),
    ] {
        let found = problems(&with(&[&HEAD.replace("\n[system", &format!("{symbol}\n\n[system")), MOTION]));
        assert!(found.contains(words), "{symbol}: {found}");
    }
}
