//! Numbers of the file that binary64 does not hold: what is true of the decimals never fails, whatever cancels, and a motion has the
//! same verdict alone and as a member of a family.

use rederive::check::{Account, Options, Outcome, Strength, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};
use rederive::number::Draws;

fn found(text: &str) -> Account {
    let source = Source { path: "t.toml".into(), text: text.to_owned() };
    let derivation = parse(source, "t").unwrap_or_else(|f| panic!("{}", render(&f, false)));
    check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

/// A file with a motion, and with a family of it whose first member is that motion.
fn file(parameters: [&str; 3], claims: &[(String, String)]) -> String {
    let [a, b, c] = parameters;
    let mut text = format!(
        r"
[derivation]
title = 'T'
concerns = 'C'
[symbols]
't' = {{ role = 'time' }}
'a' = {{ role = 'parameter' }}
'b' = {{ role = 'parameter' }}
'c' = {{ role = 'parameter' }}
'x' = {{ role = 'state' }}
[system.s]
states = ['x']
equations = ['\dot x=cx']
[[trajectory]]
id = 'm'
system = 's'
parameters = {{ 'a' = {a}, 'b' = {b}, 'c' = {c} }}
initial = {{ 'x' = 1 }}
span = [0, 0.5]
[[family]]
id = 'f'
title = 'rates'
of = 'm'
vary = {{ 'c' = {{ values = [{c}, 0.5] }} }}
"
    );
    for (id, formula) in claims {
        text += &format!(
            "[[claim]]\nid = '{id}'\nsays = 's'\ntrajectories = ['m']\nfamilies = ['f']\nalways = ['{formula}']\n"
        );
    }
    text
}

/// A decimal with so many digits after the point, as a whole number of the last one.
fn decimal(units: i64, digits: u32) -> String {
    let one = 10_i64.pow(digits);
    format!("{}.{:0width$}", units / one, units % one, width = digits as usize)
}

/// So many random files, of which `REDERIVE_FILES` may ask for more.
#[test]
fn what_is_true_of_decimals_never_fails_and_families_agree_with_motions() {
    let count = std::env::var("REDERIVE_FILES").ok().and_then(|n| n.parse().ok()).unwrap_or(12);
    let (mut held, mut refuted) = (0, 0);
    for n in 0..count {
        let mut draws = Draws::new(4_100 + n);
        let digits = 1 + draws.below(9) as u32;
        let one = 10_i64.pow(digits);
        let a = one + draws.below(one as u64) as i64;
        // Neighbours, or the same.
        let apart = if draws.below(4) == 0 { 0 } else { 1 + draws.below(9) as i64 };
        let b = a + apart;
        let c = ["0.3", "0.25", "0.7"][draws.below(3) as usize];
        let difference = format!(r"\frac{{{apart}}}{{{one}}}");
        let mut claims = vec![
            ("difference".to_owned(), format!("b-a={difference}")),
            ("sum".to_owned(), format!(r"a+b=\frac{{{}}}{{{one}}}", a + b)),
            ("false-difference".to_owned(), format!(r"b-a=1.001\cdot{difference}+\frac{{1}}{{3\cdot{one}}}")),
            ("false-sum".to_owned(), format!(r"a+b=\frac{{{}}}{{{one}}}+10^{{-6}}", a + b)),
        ];
        if apart > 0 {
            claims.push(("ratio".to_owned(), format!(r"\frac{{x}}{{b-a}}=\frac{{{one}}}{{{apart}}}x")));
            claims.push(("false-ratio".to_owned(), format!(r"\frac{{x}}{{b-a}}=1.01\cdot\frac{{{one}}}{{{apart}}}x")));
        } else {
            claims.push(("same".to_owned(), "a=b".to_owned()));
            claims.push(("same-root".to_owned(), r"\sqrt{b-a}=0".to_owned()));
            claims.push(("false-order".to_owned(), "a<b".to_owned()));
        }
        let text = file([&decimal(a, digits), &decimal(b, digits), c], &claims);
        for claim in &found(&text).claims {
            let (alone, family) = (claim.results[0].verdict.outcome(), claim.families[0].verdict.outcome());
            // Members are tried on samples, and a motion may be enclosed, too.
            let enclosed = matches!(alone, Outcome::Holds(s) | Outcome::Fails(s) if s > Strength::Sampled);
            let is_open = family == Outcome::Undecided && enclosed;
            assert!(is_open || alone.word() == family.word(), "{}: {alone:?}, {family:?} in {text}", claim.id);
            let words = [alone.word(), family.word()];
            let is_false = claim.id.starts_with("false");
            let never = if is_false { "holds" } else { "fails" };
            assert!(!words.contains(&never), "{}: {words:?} in {text}", claim.id);
            held += usize::from(alone.word() == "holds");
            refuted += usize::from(alone.word() == "fails");
        }
    }
    // Most of it is decided.
    assert!(held > 2 * count as usize && refuted > 2 * count as usize, "{held} hold, {refuted} fail in {count}");
}

/// Numbers that binary64 holds are known exactly.
#[test]
fn what_binary64_holds_carries_no_error() {
    let claims = [("order".to_owned(), "a<b".to_owned()), ("root".to_owned(), r"\sqrt{a-\frac54}=0".to_owned())];
    for claim in &found(&file(["1.25", "1.5", "0.25"], &claims)).claims {
        assert_eq!(claim.results[0].verdict.outcome().word(), "holds", "{}", claim.id);
    }
}

/// A rank that is below the precision of samples is not refuted by them, and what is exact still is.
#[test]
fn a_small_rank_is_not_refuted_by_samples() {
    let text = r"
[derivation]
title = 'T'
concerns = 'C'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'y' = { role = 'state' }
[system.s]
states = ['x', 'y']
equations = ['\dot x=y', '\dot y=-x']
[[trajectory]]
id = 'm'
system = 's'
initial = { 'x' = 0.3, 'y' = '\sqrt2' }
span = [0, 1]
";
    let claim = |id: &str, functions: &str| {
        format!("[[claim]]\nid = '{id}'\nsays = 's'\nindependent = {{ functions = [{functions}] }}\n")
    };
    let claims = [
        claim("small", r"'x', 'x+10^{-20}y'"),
        claim("hidden", r"'e^x+y', 'e^x+y+10^{-20}x'"),
        claim("twice", r"'x', '2x'"),
        claim("none", r"'x', '3'"),
        claim("three", r"'x', 'y', 'xy'"),
        claim("usual", r"'x', 'xy'"),
    ];
    let word = |id: &str, account: &Account| {
        let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("{id}"));
        claim.results[0].verdict.outcome().word()
    };
    let account = found(&format!("{text}{}", claims.concat()));
    for id in ["small", "hidden"] {
        assert_ne!(word(id, &account), "fails", "{id}");
    }
    for id in ["twice", "none", "three"] {
        assert_eq!(word(id, &account), "fails", "{id}");
    }
    assert_eq!(word("usual", &account), "holds");
}
