//! Claims that compare the members of a family: the verdicts of the corpus, how members are counted, and what is refused.

use std::path::Path;

use rederive::check::{Account, CheckError, FamilyAccount, Options, check};
use rederive::derivation::{load, parse};
use rederive::diag::{Source, render};
use rederive::report;

fn account() -> Account {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/across.toml");
    let derivation = load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let options = Options { plain: true, ..Options::default() };
    check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

fn on<'a>(account: &'a Account, id: &str) -> &'a FamilyAccount {
    let claim = account.claims.iter().find(|c| c.id == id).expect("the claim");
    assert!(claim.results.is_empty(), "it is tried on no trajectory");
    &claim.families[0]
}

#[test]
fn verdicts_are_as_expected_and_members_are_counted() {
    let account = account();
    for found in &account.claims {
        for family in &found.families {
            let reason = family.first_undecided.as_ref().and_then(|m| m.verdict.evidence().reason.clone());
            assert!(!family.is_unexpected(), "{}: {family:?} {reason:?}", found.id);
            assert!(matches!(family.verdict.outcome().strength(), Some("sampled") | None));
        }
        assert!(found.identity.as_ref().is_none_or(|i| i.standing() != "proved"), "{}", found.id);
    }
    let counts = |id: &str| {
        let f = on(&account, id);
        (f.counts.members, f.counts.holds, f.counts.fails, f.counts.not_applicable, f.counts.undecided)
    };
    // The first of each row of three is what the others are compared with: of four rows, one for each k.
    assert_eq!(counts("period-of-a-spring"), (12, 8, 0, 4, 0));
    // The last of the row has no neighbour.
    assert_eq!(counts("grows"), (5, 4, 0, 1, 0));
    assert_eq!(counts("falls"), (5, 0, 4, 1, 0));
    assert_eq!(counts("not-of-n"), (8, 6, 0, 2, 0));
    // From -2 to -1; from -1 to 0 and from 0 to 2 there is no slope, and 2 is the last; for two values of A.
    assert_eq!(counts("no-logarithm"), (8, 2, 0, 6, 0));
    // It falls to 0 and grows from there.
    assert_eq!(counts("even"), (8, 2, 4, 2, 0));
    assert_eq!(counts("never-there"), (12, 0, 0, 12, 0));
    // What differs by less than its error is in no order.
    assert_eq!(counts("no-order"), (12, 0, 0, 4, 8));
    // All members are compared with a motion at 45°, which is none of them; and each with another beside it.
    assert_eq!(counts("farthest"), (7, 7, 0, 0, 0));
    // The motion at 0.79 flies farther: that is seen from the three members below. The member at 0.8 has no side.
    assert_eq!(counts("farthest-elsewhere"), (7, 3, 3, 1, 0));
    assert_eq!(counts("fastest-when-small"), (5, 4, 0, 1, 0));
    assert_eq!(counts("extremum-of-no-member"), (8, 0, 0, 8, 0));
    // -7 does not tend to infinity, 3 and 10 not to minus infinity; of two values of A.
    assert_eq!(counts("far-away"), (6, 4, 0, 2, 0));
    assert_eq!(counts("far-below"), (6, 2, 0, 4, 0));
    assert_eq!(counts("even-at-zero"), (8, 6, 0, 2, 0));
    assert_eq!(counts("not-allowed"), (2, 0, 0, 2, 0));
}

#[test]
#[expect(clippy::disallowed_methods, reason = "what is expected is compared with room for how a platform rounds")]
fn a_witness_has_both_members() {
    let account = account();
    let found = on(&account, "square-too-closely");
    let first = found.first_failing.as_ref().expect("it fails");
    let witness = first.verdict.evidence().witness.as_ref().expect("a witness");
    assert_eq!(witness.right, 1e-6);
    let names: Vec<&str> = witness.values.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["x", "x of the other", "t-2\\pi", "t-2\\pi of the other"]);
    let value = |n: usize| witness.values[n].1;
    assert_eq!((value(0), value(1)), (0.01, 0.04));
    // T/2π = 1 + A²/16 + 11 A⁴/3072 + …
    for n in [0, 1] {
        let a = value(n);
        let period = 2.0 * std::f64::consts::PI * (a * a / 16.0 + 11.0 * a.powi(4) / 3072.0);
        assert!((value(n + 2) - period).abs() < 1e-8 * period.max(1e-3), "{} {period}", value(n + 2));
    }
    let slope = (value(3) / value(2)).ln() / (value(1) / value(0)).ln();
    assert!((witness.left - (slope - 2.0).abs()).abs() < 1e-6, "{} {slope}", witness.left);
}

#[test]
fn a_scaling_law_has_a_slope_over_the_whole_family() {
    let account = account();
    // The period of a pendulum less 2π grows as A², and at the largest amplitudes a little faster.
    let found = on(&account, "square-too-closely").slope.clone().expect("a slope");
    assert_eq!((found.pairs, found.power), (on(&account, "square-too-closely").counts.members - 1, 2.0));
    assert!(found.least >= 2.0 && found.least < found.slope && found.slope < found.greatest, "{found:?}");
    let error = found.standard_error.expect("more than one pair");
    assert!(error > 0.0 && (found.slope - 2.0).abs() < found.greatest - 2.0, "{found:?}");
    assert_eq!(found.contains, (found.slope - 2.0).abs() <= 2.0 * error + found.bound);
    assert!(found.cells.windows(2).all(|w| w[0].value < w[1].value && w[0].logarithm < w[1].logarithm), "{found:?}");
    // Between values of different signs there is no slope; of the pairs that are left there is.
    let found = on(&account, "no-logarithm").slope.clone().expect("a slope");
    assert_eq!(found.pairs, 2);
    // What is no scaling law has none.
    let with: Vec<&str> =
        account.claims.iter().filter(|c| c.families.iter().any(|f| f.slope.is_some())).map(|c| c.id.as_str()).collect();
    assert_eq!(with, ["square", "square-too-closely", "inverse", "energy", "energy-square", "no-logarithm"]);
}

#[test]
fn what_has_no_meaning_is_refused() {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/across.toml"));
    let text = text.expect("the corpus");
    let head = &text[..text.find("[[claim]]").expect("claims")];
    let problem = |claim: &str| {
        let text = format!("{head}\n[[claim]]\nid = 'c'\nsays = 's'\n{claim}\n");
        match parse(Source { path: "t.toml".into(), text }, "t") {
            Err(found) => render(&found, false),
            Ok(_) => "no problem".to_owned(),
        }
    };
    let springs = "families = ['springs']";
    let cases = [
        (format!("{springs}\nindependent-of = {{ of = 'k', with = 'x' }}"), "no problem"),
        ("independent-of = { of = 'k', with = 'x' }".to_owned(), "compares the members of a family"),
        (format!("{springs}\nindependent-of = {{ of = 'E', with = 'x' }}"), "this moves"),
        (format!("{springs}\nindependent-of = {{ of = 'k' }}"), "needs `with`"),
        (format!("{springs}\nindependent-of = {{ of = 'k', with = 'v' }}"), "`springs` does not vary `v`"),
        (format!("{springs}\nindependent-of = {{ of = 'k', with = 'z' }}"), "no symbol `z`"),
        (format!("{springs}\nindependent-of = {{ of = '\\pm k', with = 'x' }}"), "±"),
        (format!("{springs}\nassuming = ['k>1']\nindependent-of = {{ of = 'k', with = 'x' }}"), "no assumptions"),
        (format!("{springs}\nalways = ['k>0']\nindependent-of = {{ of = 'k', with = 'x' }}"), "beside another form"),
        (
            format!("{springs}\ntrajectories = ['swing']\nindependent-of = {{ of = 'k', with = 'x' }}"),
            "and no trajectories",
        ),
        (format!("{springs}\nscales-as = {{ of = 'k', with = 'x', power = 2 }}"), "needs `to`"),
        (format!("{springs}\nscales-as = {{ of = 'k', with = 'x', power = 2, to = 0 }}"), "`to` lies above 0"),
        (format!("{springs}\nmonotone = {{ of = 'k', with = 'x' }}"), "needs `direction`"),
        (format!("{springs}\nmonotone = {{ of = 'k', with = 'x', direction = 'up' }}"), "there is no direction `up`"),
        (
            "families = ['drawn']\nmonotone = { of = 'k', with = 'x', direction = 'increasing' }".to_owned(),
            "draws `x`, so that no value follows another",
        ),
        (format!("{springs}\nextremum = {{ of = 'k', with = 'x', at = 1, to = 0.1 }}"), "needs `kind`"),
        (
            format!("{springs}\nextremum = {{ of = 'k', with = 'x', kind = 'largest', at = 1, to = 0.1 }}"),
            "there is no kind `largest`",
        ),
        (format!("{springs}\nextremum = {{ of = 'k', with = 'x', kind = 'maximum', to = 0.1 }}"), "needs `at`"),
        (format!("{springs}\nextremum = {{ of = 'k', with = 'x', kind = 'maximum', at = 1 }}"), "needs `to`"),
        (
            format!("{springs}\nextremum = {{ of = 'k', with = 'x', kind = 'maximum', at = 1, to = -1 }}"),
            "`to` lies above 0",
        ),
        (
            format!("{springs}\nextremum = {{ of = 'k', with = 'x', kind = 'maximum', at = 'k', to = 1 }}"),
            "is a number, `k` is none",
        ),
        (
            format!("{springs}\nextremum = {{ of = 'k', with = 'x', kind = 'maximum', at = [1], to = 1 }}"),
            "a number is needed",
        ),
        (format!("{springs}\nlimit = {{ of = 'k', with = 'x', value = 0, to = 1 }}"), "needs `tends-to`"),
        (format!("{springs}\nlimit = {{ of = 'k', with = 'x', tends-to = 0, to = 1 }}"), "needs `value`"),
        (format!("{springs}\nlimit = {{ of = 'k', with = 'x', tends-to = 0, value = 0 }}"), "needs `to`"),
        (
            format!("{springs}\nlimit = {{ of = 'k', with = 'x', tends-to = 0, value = 0, to = 0 }}"),
            "`to` lies above 0",
        ),
        (
            format!("{springs}\nlimit = {{ of = 'E(0)', with = 'x', tends-to = 0, value = 'kx(0)', to = 1 }}"),
            "no problem",
        ),
        (
            format!("{springs}\nlimit = {{ of = 'E(0)', with = 'k', tends-to = 0, value = 'k', to = 1 }}"),
            "the limit is one number, and `k` tends to something itself",
        ),
        (format!("{springs}\nlimit = {{ of = 'E(0)', with = 'x', tends-to = 0, value = 'E', to = 1 }}"), "this moves"),
        (
            format!("{springs}\nlimit = {{ of = 'k', with = 'x', tends-to = '\\infty+1', value = 0, to = 1 }}"),
            "\\infty",
        ),
        (format!("{springs}\nlimit = {{ of = 'k', with = 'x', tends-to = 'zero', value = 0, to = 1 }}"), "tends-to"),
        ("ranges = { 'x' = [0, 1] }\nindependent-of = { of = 'k', with = 'x' }".to_owned(), "over ranges"),
    ];
    for (claim, expected) in cases {
        let found = problem(&claim);
        assert!(found.contains(expected), "{claim}\n{found}");
    }
}

#[test]
fn every_report_says_what_is_compared() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/across.toml");
    let derivation = load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let options = Options {
        plain: true,
        claims: ["square", "grows", "farthest", "small-swings"].map(str::to_owned).to_vec(),
        ..Options::default()
    };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    for report in [report::markdown, report::page, report::tex] {
        let text = report(&derivation, &account);
        let words = text.contains("Scales as a power of") && text.contains("whose exponent is 2 to within 0.01");
        assert!(text.contains("Is largest at") && text.contains("to within 0.01"), "{text}");
        assert!(text.contains("Tends to") && text.contains("by extrapolation"), "{text}");
        assert!(text.contains("east squares give the slope"), "{text}");
        assert!(words && text.contains("Grows with") && !text.contains("The motion is that of"), "{text}");
    }
    let text = report::explain(&derivation, &account, &["square".to_owned()], &[], false);
    assert!(text.contains("Scales as a power of x, whose exponent is 2 to within 0.01"), "{text}");
}

#[test]
fn an_extremum_outside_of_the_family_is_refused() {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/across.toml"));
    let text = text.expect("the corpus");
    for (old, new, expected) in [
        ("at = 0.79, to", "at = 1.5, to", "the family `throws` varies `\\alpha` from 0.2 to 1.4"),
        ("at = 0.79, to", "at = '\\sqrt{-1}', to", "is no real number"),
        ("tends-to = 0, value = '2\\pi',", "tends-to = '\\frac10', value = '2\\pi',", ""),
    ] {
        let text = text.replace(old, new);
        let source = Source { path: "t.toml".into(), text };
        let found = match parse(source, "t") {
            Err(found) => render(&found, false),
            Ok(derivation) => match check(&derivation, &Options::default(), &|_, _| {}) {
                Err(CheckError::Problems(found)) => render(&found, false),
                other => panic!("{new}: {other:?}"),
            },
        };
        assert!(found.contains(expected) && found.contains("t.toml:"), "{new}\n{found}");
    }
}

#[test]
#[expect(clippy::disallowed_methods, reason = "what is expected is compared with room for how a platform rounds")]
fn the_witness_of_an_extremum_flies_farther_and_that_of_a_limit_is_estimated() {
    let account = account();
    let found = on(&account, "farthest-elsewhere");
    let first = found.first_failing.as_ref().expect("it fails");
    assert_eq!(first.number, 1);
    let witness = first.verdict.evidence().witness.as_ref().expect("a witness");
    let value = |n: usize| witness.values[n].1;
    // The motion beside the place, and the one at the place: sin 2α.
    assert!((value(0) - 0.79).abs() < 1e-12 && value(1) == 0.8, "{:?}", witness.values);
    for n in [0, 1] {
        assert!((value(n + 2) - (2.0 * value(n)).sin()).abs() < 1e-9, "{:?}", witness.values);
    }
    assert!(value(2) > value(3));
    let found = on(&account, "small-swings-are-slower");
    let witness = found.first_failing.as_ref().and_then(|f| f.verdict.evidence().witness.clone()).expect("a witness");
    let names: Vec<&str> = witness.values.iter().map(|(name, _)| name.as_str()).collect();
    let expected = ["x", "x of the last of the sequence", "t", "t of the last of the sequence", "estimated limit of t"];
    assert_eq!(names, expected);
    let value = |n: usize| witness.values[n].1;
    assert_eq!(value(1), value(0) / 3.618_033_988_749_895_f64.powi(5));
    assert!((value(4) - 2.0 * std::f64::consts::PI).abs() < 1e-8, "{}", value(4));
    assert!((witness.left - 1e-6).abs() < 1e-8 && witness.right == 1e-7, "{witness:?}");
}

#[test]
fn what_cannot_be_told_of_two_members_is_not_told() {
    let head = r#"
[derivation]
title = "T"
concerns = "C"
[symbols]
't' = { role = "time" }
'a' = { role = "parameter" }
'k' = { role = "parameter", positive = true }
'x' = { role = "state" }
[system.spring]
states = ['x']
equations = ['\ddot x=-kx']
[[trajectory]]
id = "touching"
formula = { 'x' = '(t-a)^2' }
parameters = { 'a' = 1 }
span = [0, 2]
[[trajectory]]
id = "swing"
system = "spring"
parameters = { 'k' = 1 }
initial = { 'x' = 1, '\dot x' = 0 }
span = [0, 3]
[[trajectory]]
id = "quarter"
formula = { 'x' = '\cos(at)' }
parameters = { 'a' = 1 }
span = [0, 1.5707963267948966]
[[family]]
id = "three"
of = "touching"
vary = { 'a' = { values = [1, 2, 3] } }
[[family]]
id = "row"
of = "touching"
vary = { 'a' = { from = 0, to = 1, count = 3 } }
[[family]]
id = "springs"
of = "swing"
vary = { 'k' = { values = [1, 2, 3] } }
[[family]]
id = "quarters"
of = "quarter"
vary = { 'a' = { values = [1, 2] } }
"#;
    let found = |family: &str, claim: &str| {
        let text = format!("{head}[[claim]]\nid = 'c'\nsays = 's'\nfamilies = ['{family}']\n{claim}\n");
        let source = Source { path: "t.toml".into(), text };
        let derivation = parse(source, "t").unwrap_or_else(|found| panic!("{claim}\n{}", render(&found, false)));
        let options = Options { plain: true, ..Options::default() };
        let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{claim}: {e:?}"));
        on(&account, "c").clone()
    };
    // Holds, fails, does not apply, undecided.
    for (family, claim, counts) in [
        // Beside 0.1 on the side of 0 lies no motion of the family, and 0 is too near.
        ("row", "extremum = { of = '0.1-a', with = 'a', kind = 'maximum', at = 0.1, to = 0.2 }", (2, 0, 1, 0)),
        ("three", r"monotone = { of = '\sqrt{a-1.5}', with = 'a', direction = 'increasing' }", (1, 0, 2, 0)),
        // A law that is true, asked for more closely than it is known.
        ("springs", "at = 'x=0'\nscales-as = { of = 't', with = 'k', power = -0.5, to = 1e-15 }", (0, 0, 1, 2)),
        ("springs", "at = 'x=0'\nscales-as = { of = 't', with = 'k', power = -0.5, to = 1e-6 }", (2, 0, 1, 0)),
        // Whether it touches 0 cannot be told.
        ("three", "at = 'x=0'\nmonotone = { of = 't', with = 'a', direction = 'increasing' }", (0, 0, 1, 2)),
        // Nor whether this lies in the span.
        ("quarters", "at = 'x=0'\nmonotone = { of = 't', with = 'a', direction = 'decreasing' }", (0, 0, 1, 1)),
    ] {
        let of = found(family, claim).counts;
        assert_eq!((of.holds, of.fails, of.not_applicable, of.undecided), counts, "{family}: {claim}");
    }
    // All are compared with the first.
    let of = found("three", "independent-of = { of = 'a^2', with = 'a' }");
    let witness = of.first_failing.as_ref().and_then(|m| m.verdict.evidence().witness.clone()).expect("a witness");
    assert_eq!(witness.values[..2], [("a".to_owned(), 2.0), ("a of the other".to_owned(), 1.0)]);
}

/// The logarithm has no value at 0; beside 0.5, on that side, it is smaller.
#[test]
fn an_extremum_fails_on_the_side_of_a_member_without_a_value() {
    let text = r"
[derivation]
title = 'T'
concerns = 'C'
[symbols]
't' = { role = 'time' }
's' = { role = 'state' }
'x' = { role = 'parameter' }
[[trajectory]]
id = 'm'
formula = { 's' = 't' }
parameters = { 'x' = 1 }
span = [0, 1]
[[family]]
id = 'f'
of = 'm'
vary = { 'x' = { values = [0, 1, 2, 3] } }
[[claim]]
id = 'least'
says = 'test'
families = ['f']
trajectories = []
extremum = { of = '\ln x', with = 'x', kind = 'minimum', at = 0.5, to = 0.25 }
[[claim]]
id = 'right'
says = 'test'
families = ['f']
trajectories = []
extremum = { of = '(x-0.5)^2+0\cdot\ln x', with = 'x', kind = 'minimum', at = 0.5, to = 0.25 }
";
    let derivation = parse(Source { path: "t.toml".into(), text: text.into() }, "t");
    let derivation = derivation.unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let counts = |id: &str| {
        let f = on(&account, id);
        (f.counts.holds, f.counts.fails, f.counts.not_applicable, f.counts.undecided)
    };
    assert_eq!(counts("least"), (3, 1, 0, 0));
    // What holds beside it says nothing of the member itself.
    assert_eq!(counts("right"), (3, 0, 1, 0));
}
