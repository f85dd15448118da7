//! Checking again after a change: quick, and with the verdicts of a check of the whole file.

use std::collections::HashMap;
use std::path::Path;
use std::sync::{LazyLock, Mutex};
use std::time::Duration;

use rederive::check::{Cache, Cancel, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report;

fn read(text: &str) -> Derivation {
    let source = Source { path: "derivations/kepler.toml".into(), text: text.into() };
    parse(source, "kepler").unwrap_or_else(|found| panic!("{}", render(&found, false)))
}

/// Checks through the cache, compares with a check of the whole, and returns what was checked again.
#[track_caller]
fn step(cache: &mut Cache, text: &str) -> Vec<String> {
    let derivation = read(text);
    let (account, checked) = cache.check(&derivation, None).unwrap_or_else(|e| panic!("{e:?}"));
    let quick = report::json(&derivation, &account);
    assert!(quick == whole(text), "the cache says something else than a check of the whole file");
    checked
}

/// The report on a text, by a check that knows nothing from before: once for each text, since edits are undone here.
fn whole(text: &str) -> String {
    static KNOWN: LazyLock<Mutex<HashMap<String, String>>> = LazyLock::new(Mutex::default);
    let known = || KNOWN.lock().expect("no test stops while it holds this");
    if let Some(report) = known().get(text) {
        return report.clone();
    }
    let derivation = read(text);
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let report = report::json(&derivation, &account);
    known().insert(text.to_owned(), report.clone());
    report
}

#[test]
fn the_cache_says_what_a_whole_check_says() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/kepler.toml");
    let text = std::fs::read_to_string(path).expect("it is there");
    let mut cache = Cache::default();
    let all = step(&mut cache, &text);
    assert!(all.len() > 5, "{all:?}");
    assert!(step(&mut cache, &text).is_empty(), "nothing has changed");
    assert!(step(&mut cache, &format!("# a comment\n{text}\n\n")).is_empty(), "a comment changes nothing");

    // One claim: it alone, with what follows from it and what it follows from.
    let derivation = read(&text);
    let from = &derivation.claims.iter().find(|c| c.follows_from.is_empty()).expect("one without premises").id;
    let claim = format!("id = \"{from}\"\n");
    let changed = text.replacen(&claim, &format!("{claim}precision = 1e-7\n"), 1);
    assert!(changed != text, "the edit changes something");
    if let Ok(found) = parse(Source { path: "k".into(), text: changed.clone() }, "kepler") {
        assert_eq!(found.claims.len(), derivation.claims.len());
        let checked = step(&mut cache, &changed);
        assert!(checked.contains(from) && checked.len() < all.len(), "{checked:?}");
    }

    // Words and expectations: nothing is checked again, and they are there.
    for (old, new) in [
        ("says = \"", "says = \"Reworded: "),
        ("remark = \"", "remark = \"Reworded: "),
        ("holds = \"all\"", "fails = \"all\""),
    ] {
        let claims = changed.find("[[claim]]").expect("claims");
        let (head, tail) = changed.split_at(claims);
        let reworded = head.to_owned() + &tail.replacen(old, new, 2);
        assert!(reworded != changed, "{old}");
        assert!(step(&mut cache, &reworded).is_empty(), "{old}");
        assert!(step(&mut cache, &changed).is_empty(), "{old}, and back");
    }

    // The formula of one claim, with the units that go with it.
    let (head, tail) = changed.split_at(changed.find("[[claim]]").expect("claims"));
    let squared = head.to_owned() + &tail.replacen(r"-\frac{\mu}{r^2}']", r"-\frac{\mu}{r}']", 1);
    assert!(squared != changed, "the edit changes something");
    let checked = step(&mut cache, &squared);
    assert!(!checked.is_empty() && checked.len() < all.len(), "{checked:?}");

    // A motion: everything.
    let moved = text.replacen("span = [0, ", "span = [0.0, ", 1);
    assert!(moved != text, "the edit changes something");
    assert_eq!(step(&mut cache, &moved).len(), all.len());
}

/// Checks that are ended at any moment, between others: what is said afterwards is what a check of the whole file says.
#[test]
fn a_check_that_is_cancelled_leaves_nothing_behind() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/kepler.toml");
    let text = std::fs::read_to_string(path).expect("it is there");
    let derivation = read(&text);
    let claim = format!("id = \"{}\"\n", derivation.claims[1].id);
    let of_claim = text.replacen(&claim, &format!("{claim}precision = 1e-7\n"), 1);
    let of_motions = text.replacen("span = [0,", "span = [0.25,", 1);
    assert!(of_claim != text && of_motions != text && of_motions != of_claim, "the edits change something");
    let mut cache = Cache::default();
    let mut cancelled = 0;
    for (n, changed) in [&text, &of_claim, &of_motions, &of_claim, &text, &of_motions].into_iter().enumerate() {
        let derivation = read(changed);
        for milliseconds in [0, 1, 10, 40, 200].into_iter().skip(n % 2).step_by(2) {
            let cancel = Cancel::default();
            let found = std::thread::scope(|scope| {
                scope.spawn(|| {
                    std::thread::sleep(Duration::from_millis(milliseconds));
                    cancel.raise();
                });
                cache.check(&derivation, Some(&cancel))
            });
            cancelled += usize::from(found.is_err());
        }
        step(&mut cache, changed);
    }
    assert!(cancelled > 5, "{cancelled}");
}

#[test]
fn what_says_what_formulas_mean_is_content() {
    let file = r"
[derivation]
title = 'a'
concerns = 'b'

[conventions]
signature = '+---'

[symbols]
't' = { role = 'time' }
'x' = { role = 'coordinate' }
'c' = { role = 'parameter' }
'q' = { role = 'parameter' }
'p' = { role = 'parameter', momentum-of = 'q' }
'v(x,t)' = { role = 'field', velocity = true }
'w(x,t)' = { role = 'field' }

[[claim]]
id = 'all'
says = 'c'
ranges = { 'x' = [1, 2], 't' = [1, 2], 'c' = 1, 'q' = [1, 2], 'p' = [1, 2], 'v' = 'x', 'w' = 0 }
always = ['\Box(t^2)=2', '\{q,p\}=1', '\frac{Dx}{Dt}=x']
";
    let mut cache = Cache::default();
    assert!(!step(&mut cache, file).is_empty());
    for (old, new) in [
        ("+---", "-+++"),
        (
            "'q' = { role = 'parameter' }\n'p' = { role = 'parameter', momentum-of = 'q' }",
            "'p' = { role = 'parameter' }\n'q' = { role = 'parameter', momentum-of = 'p' }",
        ),
        (
            "velocity = true }\n'w(x,t)' = { role = 'field' }",
            "velocity = false }\n'w(x,t)' = { role = 'field', velocity = true }",
        ),
    ] {
        let other = file.replacen(old, new, 1);
        assert!(other != file, "{old}");
        assert!(!step(&mut cache, &other).is_empty(), "{old}");
        step(&mut cache, file);
    }
}

#[test]
fn a_premise_that_becomes_wrong_is_noticed_in_what_follows() {
    let file = r"
[derivation]
title = 'Decay'
concerns = 'A textbook'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
[system.decay]
states = ['x']
equations = ['\dot x=-x']
[[trajectory]]
id = 'slow'
system = 'decay'
initial = { 'x' = 1.5 }
span = [0, 2]
[[claim]]
id = 'law'
says = 'the rate is minus x'
always = ['\dot x=-x']
follows-from = ['decay']
[[claim]]
id = 'second'
says = 'the second rate is x'
always = ['\ddot x=x']
follows-from = ['law']
[[claim]]
id = 'third'
says = 'the third rate is minus x'
always = ['\dddot x=-x']
follows-from = ['second']
[[claim]]
id = 'alone'
says = 'x is positive'
always = ['x>0']
";
    let file = file.replace(r"\dddot x=-x", r"\ddot x+x=2x");
    let mut cache = Cache::default();
    assert_eq!(step(&mut cache, &file).len(), 4);
    let wrong = file.replacen(r"always = ['\dot x=-x']", r"always = ['\dot x=x']", 1);
    assert_eq!(step(&mut cache, &wrong), ["law", "second", "third"]);
    assert_eq!(step(&mut cache, &file), ["law", "second", "third"], "and back");
    let last = file.replace("2x", "3x");
    assert_eq!(step(&mut cache, &last), ["third"], "what is known of the premises is enough");
    let strange = last.replacen(r"always = ['\ddot x=x']", "always = ['\\ddot x=x']\nassuming = ['x>1']", 1);
    assert_eq!(step(&mut cache, &strange), ["second", "third"]);
    assert_eq!(step(&mut cache, &strange.replace("3x", "4x")), ["third"], "a premise that is not given everywhere");
    // A false claim is looked at for what it should have said, beside a true one that only has to be proved again.
    step(&mut cache, &last);
    let both = last.replacen(r"always = ['\dot x=-x']", r"always = ['\dot x+x=0']", 1);
    assert_eq!(step(&mut cache, &both), ["law", "second", "third"]);
    assert_eq!(step(&mut cache, &last), ["law", "second", "third"], "and back");
    // A changed claim that follows from one that follows from another changed one.
    let ends = both.replace("3x", "2x");
    assert_eq!(step(&mut cache, &ends), ["law", "second", "third"]);
    // The numbers of a motion, and the symbols: everything.
    for (old, new) in [
        ("'x' = 1.5", "'x' = 1.75"),
        ("role = 'state'", "role = 'state', unit = 'm'"),
        ("span = [0, 2]", "span = [0, 3]"),
    ] {
        let changed = file.replacen(old, new, 1);
        assert!(changed != file, "the edit changes something");
        assert_eq!(step(&mut cache, &changed).len(), 4, "{old}");
    }
    assert_eq!(step(&mut cache, &file).len(), 4);
    // Claims that come and go: they, and what follows from them.
    let without = file.split("[[claim]]\nid = 'alone'").next().expect("the rest");
    assert!(step(&mut cache, without).is_empty());
    assert_eq!(step(&mut cache, &file), ["alone"]);
    let (head, alone) = file.split_at(file.find("[[claim]]\nid = 'alone'").expect("it is there"));
    let first = head.find("[[claim]]").expect("claims");
    let moved = format!("{}{alone}{}", &head[..first], &head[first..]);
    assert!(step(&mut cache, &moved).is_empty(), "the order is nothing that a verdict depends on");
    // A symbol of a claim is known to the motions: everything.
    let own = file.replacen(
        "says = 'x is positive'",
        "says = 'x is positive'\nsymbols = { 'y' = { role = 'observable', formula = 'x^2' } }",
        1,
    );
    assert!(own != file, "the edit changes something");
    step(&mut cache, &file);
    assert_eq!(step(&mut cache, &own).len(), 4);
}

/// Edits of one file, each made and undone in any order: what the cache says is what a check of the whole says, after each.
#[test]
fn any_sequence_of_edits_gives_what_a_whole_check_gives() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/kepler.toml");
    let text = std::fs::read_to_string(path).expect("it is there");
    let edits = [
        // Formulas: another one, the same in another order, one with a quantity that no other claim asks for.
        (r"r^2\dot\varphi={\bf L}_3", r"r^2\dot\varphi=2{\bf L}_3"),
        (r"={\bf L}\cdot{\bf L}-\mu r", r"=-\mu r+{\bf L}\cdot{\bf L}"),
        (r"{\bf A}\cdot{\bf L}=0", r"{\bf A}\cdot\ddot{\bf L}=0"),
        // Assumptions, one of them left out.
        (r"'e>10^{-9}'", r"'e>10^{-1}'"),
        (r"assuming = ['h<0', '{\bf r}_3=0', '{\bf L}_3>0']", r"assuming = ['h<0', '{\bf r}_3=0']"),
        // Motions: a parameter, an initial value, a span.
        (r"'\mu' = 0.8 ", r"'\mu' = 0.81 "),
        ("[-3, 1.4, 0]", "[-3, 1.3, 0.1]"),
        ("span = [0, 30]", "span = [0, 29]"),
        // A claim that comes.
        (
            "[[claim]]\nid = \"energy\"",
            "[[claim]]\nid = \"new\"\nsays = \"New.\"\nalways = ['r\\ddot r+\\dot r^2>0']\n\n[[claim]]\nid = \"energy\"",
        ),
        // A symbol.
        (r"({\bf r}_2,{\bf r}_1)", r"({\bf r}_1,{\bf r}_2)"),
    ];
    for (old, _) in &edits {
        assert!(text.contains(old), "{old}");
    }
    let mut made = vec![false; edits.len()];
    let mut cache = Cache::default();
    let mut random = 20_u64;
    for _ in 0..9 {
        let mut file = text.clone();
        for ((old, new), _) in edits.iter().zip(&made).filter(|(_, made)| **made) {
            file = file.replacen(old, new, 1);
        }
        step(&mut cache, &file);
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let at = (random >> 33) as usize % edits.len();
        made[at] = !made[at];
    }
}
