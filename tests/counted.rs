//! Events with a direction and a count: random products of factors with known zeros, families, measures, and what is refused.
//!
//! The verdicts and strengths of single cases are those of `tests/corpus/semantics-counted.toml`.

use std::path::Path;

use rederive::check::{Account, Options, Rigor, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};

const HEAD: &str = r"
[derivation]
title = 't'
concerns = 'c'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'w' = { role = 'parameter', positive = true }
";

fn account(text: &str, rigor: Rigor) -> Account {
    let derivation = match parse(Source { path: "t.toml".into(), text: text.into() }, "t") {
        Ok(derivation) => derivation,
        Err(found) => panic!("{}\n{text}", render(&found, false)),
    };
    check(&derivation, &Options { plain: true, rigor, ..Options::default() }, &|_, _| {}).expect("no defect")
}

/// The next of a fixed row of numbers below `n`.
fn next(state: &mut u64, n: u64) -> u64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) % n
}

/// A zero: eighths, and how many units of 10⁻¹² beside it.
type Place = (i64, i64);

/// The zeros with a direction inside the span, by the order of the product: whether it passes upwards.
fn passed(roots: &[Place], (from, to): (Place, Place)) -> Vec<(Place, bool)> {
    let mut distinct = roots.to_vec();
    distinct.sort_unstable();
    distinct.dedup();
    let odd = |at: &Place| roots.iter().filter(|r| *r == at).count() % 2 == 1;
    // Before a zero the product has the sign of the number of factors that are negative there.
    let up = |at: &Place| roots.iter().filter(|r| *r >= at).count() % 2 == 1;
    distinct.into_iter().filter(|at| from < *at && *at < to && odd(at)).map(|at| (at, up(&at))).collect()
}

fn formula((eighths, beside): Place) -> String {
    format!(r"\frac{{{eighths}}}{{8}}+{beside}\cdot 10^{{-12}}")
}

/// What is true is not found to fail, and what is false not to hold, however close the zeros are; and enough is decided.
#[test]
fn the_nth_zero_of_a_product_is_never_another() {
    let (mut state, mut text, mut truths) = (7, HEAD.to_owned(), Vec::new());
    // How far zeros lie from one another, in units of 10⁻¹²; eighths where nothing is close.
    let gaps = [0, 0, 1, 1_000, 1_000_000, 100_000_000, 1_000_000_000];
    for k in 0..48 {
        let base: Vec<i64> = (0..1 + next(&mut state, 3)).map(|_| next(&mut state, 24) as i64).collect();
        let mut roots: Vec<Place> = base.iter().map(|e| (*e, 0)).collect();
        for _ in 0..next(&mut state, 3) {
            let of = base[next(&mut state, base.len() as u64) as usize];
            roots.push((of, gaps[next(&mut state, gaps.len() as u64) as usize]));
        }
        // Some spans begin or end at a zero.
        let (from, to) = match k % 4 {
            0 => ((base[0], 0), (25, 0)),
            1 if base[0] > 0 => ((-1, 0), (base[0], 0)),
            _ => ((-1, 0), (25, 0)),
        };
        let product: Vec<String> = roots.iter().map(|r| format!(r"\left(t-({})\right)", formula(*r))).collect();
        let seconds = |(e, _): Place| e as f64 / 8.0;
        text.push_str(&format!(
            "[[trajectory]]\nid = 'm{k}'\nspan = [{:?}, {:?}]\nformula = {{ 'x' = '{}' }}\n",
            seconds(from),
            seconds(to),
            product.concat()
        ));
        let all = passed(&roots, (from, to));
        for (up, n) in [(true, 1), (true, 2), (false, 1), (false, 2)] {
            let nth = all.iter().filter(|(_, way)| *way == up).nth(n - 1).map(|(at, _)| *at);
            let at = format!("at = {{ when = 'x=0', direction = '{}', count = {n} }}", if up { "up" } else { "down" });
            let says = match nth {
                Some(at) => format!(r"\left|t-({})\right|<10^{{-13}}", formula(at)),
                None => "t<100".to_owned(),
            };
            for (word, says) in [("is", says.clone()), ("not", format!("t>100+{n}"))] {
                let id = format!("{word}-{k}-{up}-{n}");
                text.push_str(&format!(
                    "[[claim]]\nid = '{id}'\nsays = 's'\n{at}\nalways = ['{says}']\ntrajectories = ['m{k}']\n"
                ));
                truths.push((id, nth.is_some(), word == "is"));
            }
        }
    }
    for rigor in [Rigor::Sampled, Rigor::Enclosed] {
        let account = account(&text, rigor);
        let mut decided = [0; 2];
        for (id, happens, is) in &truths {
            let claim = account.claims.iter().find(|c| c.id == *id).expect("the claim");
            let verdict = &claim.results[0].verdict;
            let word = verdict.outcome().word();
            let right = match (happens, is) {
                (true, true) => "holds",
                (true, false) => "fails",
                (false, _) => "not-applicable",
            };
            assert!(word == right || word == "undecided", "{id}: {word}, not {right}: {:?}", verdict.evidence());
            decided[usize::from(*happens)] += usize::from(word == right);
        }
        assert!(decided.iter().all(|n| *n > 40), "{rigor:?}: {decided:?} of {}", truths.len());
    }
}

const COSINES: &str = r"
[[trajectory]]
id = 'cosine'
parameters = { 'w' = 1 }
formula = { 'x' = '\cos wt' }
span = [0, 20]
[[family]]
id = 'cosines'
of = 'cosine'
vary = { 'w' = { from = 0.5, to = 2, count = 4, spacing = 'logarithmic' } }
";

#[test]
fn members_are_tried_and_compared_at_the_time_that_is_counted() {
    let second = "at = { when = 'x=0', direction = 'up', count = 2 }\ntrajectories = []\nfamilies = ['cosines']";
    let fifth = "at = { when = 'x=0', direction = 'up', count = 5 }\ntrajectories = []\nfamilies = ['cosines']";
    let across = |at: &str| at.replace("trajectories = []\n", "");
    let claims = [
        ("second", second.to_owned(), r"always = ['wt=\frac72\pi']", "holds"),
        ("first", second.to_owned(), r"always = ['wt=\frac32\pi']", "fails"),
        // 19π/2 lies in the span of the last member alone.
        ("fifth", fifth.to_owned(), r"always = ['wt=\frac{19}2\pi']", "holds"),
        ("ninth", second.replace("count = 2", "count = 9"), r"always = ['t>0']", "not-applicable"),
        ("inversely", across(second), "scales-as = { of = 't', with = 'w', power = -1, to = 1e-6 }", "holds"),
        ("not-so", across(second), "scales-as = { of = 't', with = 'w', power = 1, to = 1e-6 }", "fails"),
        ("earlier", across(second), "monotone = { of = 't', with = 'w', direction = 'decreasing' }", "holds"),
        (
            "never",
            across(&second.replace("count = 2", "count = 9")),
            "independent-of = { of = 't', with = 'w' }",
            "not-applicable",
        ),
    ];
    let mut text = format!("{HEAD}{COSINES}");
    for (id, at, form, _) in &claims {
        text.push_str(&format!("[[claim]]\nid = '{id}'\nsays = 's'\n{at}\n{form}\n"));
    }
    let account = account(&text, Rigor::Enclosed);
    for (id, _, _, word) in claims {
        let claim = account.claims.iter().find(|c| c.id == id).expect("the claim");
        assert_eq!(claim.families[0].verdict.outcome().word(), word, "{id}: {:?}", claim.families[0]);
    }
    let fifth = account.claims.iter().find(|c| c.id == "fifth").expect("the claim");
    assert_eq!((fifth.families[0].counts.holds, fifth.families[0].counts.not_applicable), (1, 3));
}

#[test]
fn a_measure_is_taken_at_the_time_that_is_counted() {
    let measure = |id: &str, at: &str| format!("[[measure]]\nid = '{id}'\nsays = 's'\nformula = 't'\nat = {at}\n");
    let text = format!(
        "{HEAD}{COSINES}{}{}{}[[trajectory]]\nid = 'touches'\nparameters = {{ 'w' = 1 }}\nformula = {{ 'x' = '(t-1)^2(t-2)' }}\nspan = [0, 4]\n",
        measure("second", "{ when = 'x=0', direction = 'up', count = 2 }"),
        measure("down", "{ when = 'x=0', direction = 'down' }"),
        measure("ninth", "{ when = 'x=0', count = 9 }"),
    );
    let account = account(&text, Rigor::Sampled);
    let found = |id: &str, on: &str| {
        let m = account.measurements.iter().find(|m| m.measure == id && m.trajectory == on).expect("the measurement");
        (m.values.iter().map(|v| v.1).collect::<Vec<f64>>(), m.reason.as_ref().map(ToString::to_string))
    };
    let close = |found: Vec<f64>, expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b * std::f64::consts::PI).abs() < 1e-9), "{found:?}");
    };
    close(found("second", "cosine").0, &[3.5]);
    close(found("down", "cosine").0, &[0.5, 2.5, 4.5]);
    let (none, why) = found("ninth", "cosine");
    assert!(
        none.is_empty() && why.as_deref().is_some_and(|w| w.contains("for the 9th time does not happen")),
        "{why:?}"
    );
    let (none, why) = found("second", "touches");
    assert!(none.is_empty() && why.is_some(), "{why:?}");
}

#[test]
fn what_has_no_meaning_is_refused() {
    let cases = [
        ("at = { when = 'x=0' }\nalways = ['x=0']", "no problem"),
        ("at = { direction = 'up' }\nalways = ['x=0']", "needs `when`"),
        ("at = { when = 'x=0', direction = 'left' }\nalways = ['x=0']", "there is no direction `left`"),
        ("at = { when = 'x=0', count = 0 }\nalways = ['x=0']", "counted from 1"),
        ("at = { when = 'x=0', count = -1 }\nalways = ['x=0']", "0 or more"),
        ("at = { when = 'x=0', count = 1.5 }\nalways = ['x=0']", "a whole number"),
        ("at = { when = 'x>0', count = 1 }\nalways = ['x=0']", "one equation between scalars"),
        ("at = { when = 'x=0', which = 1 }\nalways = ['x=0']", "no key `which`"),
        ("at = { when = 'x=0', count = 2 }\nfirst-integral = ['x']", "`count` leaves one"),
        ("at = { when = 'x=0', direction = 'up' }\nfirst-integral = ['x']", "no problem"),
        ("at = 7\nalways = ['x=0']", "`at` must be"),
    ];
    for (claim, expected) in cases {
        let text = format!("{HEAD}{COSINES}[[claim]]\nid = 'c'\nsays = 's'\n{claim}\n");
        let found = match parse(Source { path: "t.toml".into(), text }, "t") {
            Err(found) => render(&found, false),
            Ok(_) => "no problem".to_owned(),
        };
        assert!(found.contains(expected), "{claim}\n{found}");
    }
}

/// Enclosures count events by a route of their own. So what samples say of the corpus is looked at by itself: it is what is
/// expected, or nothing.
#[test]
fn samples_alone_count_the_same_events() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/semantics-counted.toml");
    let account = account(&std::fs::read_to_string(path).expect("the corpus"), Rigor::Sampled);
    let (mut decided, mut open) = (0, 0);
    for claim in &account.claims {
        for pair in &claim.results {
            let word = pair.verdict.outcome().word();
            if word == "undecided" {
                open += 1;
                continue;
            }
            decided += 1;
            assert_eq!(Some(word), pair.expected, "{} on {}", claim.id, pair.trajectory);
        }
    }
    assert!(decided >= 41 && open <= 23, "{decided} decided, {open} open");
}
