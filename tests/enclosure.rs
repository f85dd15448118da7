//! Enclosed motions: widths, ends, angles, dense output.

use crate::flow_support::{UNIT, World, rigid_states};
use rederive::check::{Options, Outcome, Rigor, Strength, check};
use rederive::derivation::load;
use rederive::diag::render;
use rederive::flow::{Enclosure, KnownSteps, Setup, Source, Steps, VectorField};
use rederive::number::Interval;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Mutex;

/// The corpus states the truth. What is enclosed or certified must be it, also where samples are fooled.
#[test]
fn no_verdict_of_the_corpus_is_wrong() {
    let (mut enclosed, mut certified) = (0, 0);
    let (mut decided, mut wrong) = (Vec::new(), Vec::new());
    for file in ["enclosed", "forms", "opponent", "precision", "systems", "traps"] {
        let path = format!("{}/tests/corpus/{file}.toml", env!("CARGO_MANIFEST_DIR"));
        let derivation = load(Path::new(&path)).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let options = Options { rigor: Rigor::Enclosed, ..Options::default() };
        let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{file}: {e:?}"));
        for claim in &account.claims {
            for pair in &claim.results {
                let outcome = pair.verdict.outcome();
                let at = || format!("{file}: {} on {}: {:?}", claim.id, pair.trajectory, pair.verdict);
                match outcome {
                    Outcome::Holds(Strength::Enclosed) => enclosed += 1,
                    Outcome::Fails(Strength::Enclosed) => certified += 1,
                    Outcome::Holds(Strength::Sampled) | Outcome::Fails(Strength::Sampled) => {
                        let reason =
                            pair.verdict.evidence().reason.as_ref().map(ToString::to_string).unwrap_or_default();
                        assert!(reason.contains("not enclosed: "), "{}", at());
                        continue;
                    }
                    _ => continue,
                }
                // What no digit is known of is never enclosed.
                assert_ne!(claim.id, "cancellation-of-all-digits", "{}", at());
                if pair.expected == Some("undecided") {
                    // What samples cannot decide; each of them was looked at.
                    decided.push(format!("{file}: {} on {}: {}", claim.id, pair.trajectory, outcome.word()));
                } else if pair.expected != Some(outcome.word()) {
                    wrong.push(at());
                }
            }
        }
    }
    println!("{enclosed} enclosed, {certified} certified; decided where samples could not:\n{}", decided.join("\n"));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(enclosed >= 20 && certified >= 20, "{enclosed} enclosed, {certified} certified");
}

/// A term that matters for a thousandth of the time, and between samples. At its edge it is too small to refute anything,
/// which must not end the search.
#[test]
fn what_happens_between_samples_is_found() {
    let path = format!("{}/tests/enclosure_support/between.toml", env!("CARGO_MANIFEST_DIR"));
    let outcome = |rigor: Rigor| {
        let derivation = load(Path::new(&path)).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let options = Options { rigor, ..Options::default() };
        let account = check(&derivation, &options, &|_, _| {}).expect("checked");
        account.claims[0].results[0].verdict.outcome()
    };
    assert_eq!(outcome(Rigor::Sampled), Outcome::Fails(Strength::Sampled));
    assert_eq!(outcome(Rigor::Enclosed), Outcome::Fails(Strength::Enclosed));
}

/// What first integrals tell of any quantity is true of every motion that starts in a box, and tells much of what they fix.
#[test]
fn first_integrals_sharpen_what_they_contain() {
    let mut w = World::default();
    let field = w.field(&["q", "p"], &["q' = p", "p' = -q"]).expect("solvable");
    let whole = enclose(&mut w, &field, &[("q", "1"), ("p", "0")], &[], &[], (0.0, 3.0));
    let start = [Interval::ball(1.0, 1e-3), Interval::ball(0.0, 1e-3)];
    let mut e = whole.restart(&start).expect("integrated");
    let energy = w.e("q^2 + p^2");
    e.conserve(&mut w.graph, &[energy]);
    assert!(e.conserves());
    let quantities = ["q^2 + p^2 - 1", "q^2 + 2*p^2 + q*p", "(q^2 + p^2)^3 - q", "p/(q^2 + p^2)"];
    let quantities: Vec<_> = quantities.map(|q| w.e(q)).to_vec();
    let resolved: Vec<_> = quantities.iter().map(|&q| e.resolved(&mut w.graph, q).expect("known")).collect();
    let sharp = e.sharp(&mut w.graph, &resolved).expect("differentiable");
    let plain = e.compile(&mut w.graph, &quantities).expect("known");
    let mut state = 7_u64;
    let mut draw = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for (from, to) in [(0.3, 0.7), (1.0, 1.05), (2.2, 2.6)] {
        let stretch = e.stretch(Interval::new(from, to).expect("a stretch"));
        let (found, _) = e.sharpened(&sharp, &stretch);
        let known = e.over(&plain, &stretch);
        let width = |k: usize| found[k].expect("bounded").range().width() / known[k].expect("bounded").range().width();
        assert!(width(0) < 1.01, "{}", width(0));
        for _ in 0..1_000 {
            let (a, b, t) =
                (1.0 + 1e-3 * (2.0 * draw() - 1.0), 1e-3 * (2.0 * draw() - 1.0), from + (to - from) * draw());
            let (s, c) = (pxfm::f_sin(t), pxfm::f_cos(t));
            let (q, p) = (a * c + b * s, b * c - a * s);
            let f = q * q + p * p;
            let values = [f - 1.0, f + p * p + q * p, f * f * f - q, p / f];
            for (k, value) in values.into_iter().enumerate() {
                let range = found[k].expect("bounded").at(t);
                assert!(range.lo() - 1e-13 <= value && value <= range.hi() + 1e-13, "{k} at {t}: {value} in {range}");
            }
        }
    }
}

/// Where states are known badly, what is conserved is known well; and what is only nearly conserved is not accepted.
#[test]
fn what_is_conserved_is_enclosed_where_states_are_wide() {
    let path = format!("{}/tests/enclosure_support/conserved.toml", env!("CARGO_MANIFEST_DIR"));
    let derivation = load(Path::new(&path)).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let options = Options { rigor: Rigor::Enclosed, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).expect("checked");
    for claim in &account.claims {
        let verdict = &claim.results[0].verdict;
        let (strong, held) = match verdict.outcome() {
            Outcome::Holds(strength) => (strength >= Strength::Enclosed, true),
            _ => (false, false),
        };
        match claim.id.as_str() {
            "energy" | "energy-by-another-name" => assert!(strong, "{}: {:?}", claim.id, verdict.evidence().reason),
            _ => assert!(!held, "{}: {:?}", claim.id, verdict.evidence().reason),
        }
    }
}

/// A blow-up ends the enclosure, with its time and the width there.
#[test]
fn a_singularity_ends_the_enclosure() {
    let mut w = World::default();
    let field = w.field(&["x"], &["x' = x^2"]).expect("solvable");
    let e = enclose(&mut w, &field, &[("x", "1")], &[], &[], (0.0, 2.0));
    let (_, end) = e.reach();
    assert!(end > 0.9 && end < 1.0, "{end}");
    let text = e.stop().expect("it stops").to_string();
    assert!(text.contains("wide") && text.contains("t = 1,"), "{text}");
    assert!(e.state(Interval::point(1.0)).is_none());
}

/// Decimals are enclosed: 0.1 is not a binary number, and the exact motion e^(0.1·t) is inside.
#[test]
fn decimals_are_enclosed() {
    let mut w = World::default();
    let field = w.field(&["x"], &["x' = k*x"]).expect("solvable");
    let e = enclose(&mut w, &field, &[("x", "0.1")], &[("k", "0.1")], &[], (-5.0, 10.0));
    let start = e.state(Interval::point(0.0)).expect("a start")[0];
    assert!(start.lo() < start.hi() && start.contains(0.1));
    let end = e.state(Interval::point(10.0)).expect("reached")[0];
    assert!(end.contains(0.271_828_182_845_904_5) && end.width() < 1e-15);
    assert!(e.state(Interval::point(-5.0)).expect("reached")[0].contains(0.060_653_065_971_263_34));
}

/// An angle is followed through whole turns in both directions, and its rate with it.
#[test]
fn angles_are_followed() {
    let mut w = World::default();
    let field = w.field(&["x", "y"], &["x' = -y", "y' = x"]).expect("solvable");
    let observables = [("a~", "atan2(y, x)")];
    let mut e = enclose(&mut w, &field, &[("x", "1"), ("y", "0")], &[], &observables, (-20.0, 30.0));
    let roots = [w.e("a"), w.e("a'"), w.e("a - t")];
    let compiled = e.compile(&mut w.graph, &roots).expect("known");
    for t in [-19.5, -3.0, -0.5, 0.0, 0.5, 3.0, 3.12, 3.17, 9.0, 29.9] {
        let values = e.value(&compiled, Interval::point(t));
        let [Ok(angle), Ok(rate), Ok(gap)] = values[..] else { panic!("t = {t}: {values:?}") };
        assert!(angle.contains(t) && angle.width() < 1e-12 && rate.contains(1.0) && gap.contains(0.0), "{t}: {angle}");
    }
}

/// Encloses an integrated motion; observables whose name ends in `~` are angles.
fn enclose(
    w: &mut World,
    field: &VectorField,
    initial: &[(&str, &str)],
    parameters: &[(&str, &str)],
    observables: &[(&str, &str)],
    span: (f64, f64),
) -> Enclosure {
    let setup = Setup {
        time: w.leaf("t"),
        span,
        initial_time: 0.0,
        parameters: w.pairs(parameters),
        source: Source::Integrated { field, initial: w.pairs(initial), start: Default::default() },
        observables: w.observables(observables),
    };
    Enclosure::new(&mut w.graph, &setup, None).expect("a motion")
}

fn euler(w: &mut World) -> VectorField {
    let equations = ["I1*O1' = (I2-I3)*O2*O3", "I2*O2' = (I3-I1)*O3*O1", "I3*O3' = (I1-I2)*O1*O2"];
    w.field(&["O1", "O2", "O3"], &equations).expect("solvable")
}

const MOMENTS: [(&str, &str); 3] = [("I1", "1"), ("I2", "2"), ("I3", "3")];
const TUMBLING: [(&str, &str); 3] = [("O1", "0.01"), ("O2", "1"), ("O3", "0.01")];

fn width(enclosure: &Enclosure, t: f64) -> f64 {
    let state = enclosure.state(Interval::point(t));
    state.unwrap_or_else(|| panic!("{:?}", enclosure.stop())).iter().map(Interval::width).fold(0.0, f64::max)
}

/// A start and moments of inertia that are decimals, ten flips near a separatrix: what is not a binary number is known to
/// twice the precision, so that nothing but the last rounding is left.
#[test]
fn decimals_near_a_separatrix_stay_sharp() {
    let mut w = World::default();
    let field = crate::flow_support::rigid_body(&mut w);
    let initial: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.13", "1.6", "0.12"])).collect();
    let moments = [("I1", "1.748"), ("I2", "1.638"), ("I3", "0.121")];
    let e = enclose(&mut w, &field, &initial, &moments, &[], (0.0, 40.0));
    println!("racket, T = 40: {} steps, {:.1e}", e.steps(), width(&e, 40.0));
    assert!(width(&e, 40.0) < 4e-15);
}

#[test]
fn widths_of_the_free_rigid_body() {
    let mut w = World::default();
    let field = euler(&mut w);
    for (span, most) in [(20.0, 2e-15), (100.0, 2e-15)] {
        let e = enclose(&mut w, &field, &TUMBLING, &MOMENTS, &[], (0.0, span));
        println!("3 unknowns, T = {span}: {} steps, {:.1e}", e.steps(), width(&e, span));
        assert!(width(&e, span) < most);
    }
    let e = enclose(&mut w, &field, &TUMBLING, &MOMENTS, &[], (0.0, 20.0));
    let start = e.state(Interval::point(0.0)).expect("a start");
    let wide: Vec<Interval> = start.iter().map(|x| Interval::ball(x.mid(), 1e-10)).collect();
    let e = e.restart(&wide).expect("integrated");
    // What the box really becomes: its corners.
    let mut hull: Option<Vec<Interval>> = None;
    for corner in 0..8 {
        let at = |i: usize| if corner >> i & 1 == 1 { wide[i].hi() } else { wide[i].lo() };
        let point = e.restart(&[0, 1, 2].map(|i| Interval::point(at(i)))).expect("integrated");
        let state = point.state(Interval::point(20.0)).expect("reached");
        hull = Some(match hull {
            None => state,
            Some(h) => h.iter().zip(state).map(|(a, b)| a.hull(b)).collect(),
        });
    }
    let least = hull.expect("corners").iter().map(Interval::width).fold(0.0, f64::max);
    println!("radius 1e-10, T = 20: {} steps, {:.2e}, of which {least:.2e} is real", e.steps(), width(&e, 20.0));
    assert!(width(&e, 20.0) < 1.05 * least && width(&e, 20.0) < 1.6e-9);

    let mut w = World::default();
    let field = crate::flow_support::rigid_body(&mut w);
    let initial: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.01", "1", "0.01"])).collect();
    for (span, most) in [(20.0, 4e-15), (100.0, 4e-15)] {
        let e = enclose(&mut w, &field, &initial, &MOMENTS, &[], (0.0, span));
        println!("12 unknowns, T = {span}: {} steps, {:.1e}", e.steps(), width(&e, span));
        assert!(width(&e, span) < most);
    }
}

/// Steps by their names, as texts, and how often some were recalled.
#[derive(Default)]
struct Kept {
    steps: Mutex<HashMap<String, String>>,
    recalled: Mutex<usize>,
}

impl KnownSteps for Kept {
    fn steps(&self, name: &str) -> Option<Steps> {
        let found = serde_json::from_str(self.steps.lock().expect("a map").get(name)?).expect("steps");
        *self.recalled.lock().expect("a count") += 1;
        Some(found)
    }

    fn keep_steps(&self, name: &str, steps: &Steps) {
        let text = serde_json::to_string(steps).expect("a text");
        self.steps.lock().expect("a map").insert(name.to_owned(), text);
    }

    fn is_known(&self) -> bool {
        true
    }
}

/// Steps that are known are those that would be found, bit by bit, and their work counts; those of another motion are not taken for them,
/// whatever the symbols are numbered.
#[test]
fn known_steps_are_those_that_would_be_found() {
    let kept = Kept::default();
    let bits = |e: &Enclosure| {
        let stretch = |w: &[f64]| e.state(Interval::new(w[0], 0.3 * w[0] + 0.7 * w[1]).expect("a stretch"));
        let states = e.boundaries().windows(2).filter_map(stretch).flatten().collect::<Vec<_>>();
        states.iter().map(|x| (x.lo().to_bits(), x.hi().to_bits())).collect::<Vec<_>>()
    };
    let enclosed = |start: &str, moment: &str, end: f64, known: Option<&Kept>, symbols: usize| {
        let mut w = World::default();
        for n in 0..symbols {
            w.symbol(&format!("z{n}"));
        }
        let field = euler(&mut w);
        let initial = [("O1", start), ("O2", "1"), ("O3", "0.01")];
        let setup = Setup {
            time: w.leaf("t"),
            span: (-1.0, end),
            initial_time: 0.0,
            parameters: w.pairs(&[("I1", "1"), ("I2", moment), ("I3", "3")]),
            source: Source::Integrated { field: &field, initial: w.pairs(&initial), start: Default::default() },
            observables: Vec::new(),
        };
        let graph = &mut w.graph;
        let enclose = || match known {
            Some(known) => Enclosure::recalling(graph, &setup, None, known),
            None => Enclosure::new(graph, &setup, None),
        };
        let (found, work) = meter::counted(meter::Task::Enclosing, enclose);
        (bits(&found.expect("in time").expect("a motion")), work)
    };
    let cases = [("0.01", "2", 9.0), ("0.010000000000000002", "2", 9.0), ("0.01", "2.1", 9.0), ("0.01", "2", 8.0)];
    for (n, (start, moment, end)) in cases.into_iter().enumerate() {
        let of = |known, symbols| enclosed(start, moment, end, known, symbols);
        let alone = of(None, 0);
        assert!(alone.0.len() > 30 && alone.1 > 100_000, "{}, {}", alone.0.len(), alone.1);
        assert!(of(Some(&kept), 0) == alone && *kept.recalled.lock().expect("a count") == n, "another motion: {n}");
        assert!(of(Some(&kept), 5) == alone && *kept.recalled.lock().expect("a count") == n + 1, "the same: {n}");
    }
}
