//! Every witness of a report can be recomputed from the values that stand beside it.
//!
//! By another route than the one that printed them: the formulas of the derivation file are read, and their trees are walked with
//! plain `f64` and the functions of the platform; nothing of tapes, error bounds, trajectories or enclosures takes part. What is
//! printed is all that is known.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use std::collections::BTreeMap;
use std::path::Path;

use rederive::check::{Options, Rigor, check};
use rederive::derivation::{Claim, Derivation, Form, load};
use rederive::expr::{Expr, Graph, Node, Op};
use rederive::latex::RelationKind;
use rederive::report::json;
use serde_json::Value;

/// The value of a tree; `None` where a leaf is not among the values. Without a real value: not a number.
fn value(graph: &Graph, e: Expr, values: &BTreeMap<String, f64>) -> Option<f64> {
    let of = |e: Expr| value(graph, e, values);
    Some(match *graph.node(e) {
        Node::Constant(ref r) => r.to_f64().value(),
        Node::Pi => std::f64::consts::PI,
        Node::Leaf(leaf) => *values.get(&graph.leaf_latex(leaf))?,
        Node::Unary(op, a) => {
            let a = of(a)?;
            match op {
                Op::Neg => -a,
                Op::Sqrt => a.sqrt(),
                Op::Exp => a.exp(),
                Op::Ln => a.ln(),
                Op::Sin => a.sin(),
                Op::Cos => a.cos(),
                Op::Tan => a.tan(),
                Op::Arcsin => a.asin(),
                Op::Arccos => a.acos(),
                Op::Arctan => a.atan(),
                Op::Sinh => a.sinh(),
                Op::Cosh => a.cosh(),
                Op::Tanh => a.tanh(),
                Op::Abs => a.abs(),
                Op::Powi(n) => a.powi(n),
                _ => panic!("an operation that is not known here"),
            }
        }
        Node::Binary(op, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            match op {
                Op::Add => a + b,
                Op::Sub => a - b,
                Op::Mul => a * b,
                Op::Div => a / b,
                Op::Pow => a.powf(b),
                Op::Arctan2 => a.atan2(b),
                Op::Restrict => a,
                Op::Agm => (0..40).fold((a, b), |(a, b), _| (0.5 * (a + b), (a * b).sqrt())).0,
                _ => panic!("an operation that is not known here"),
            }
        }
    })
}

/// The sides that a claim compares under a label: formula, then perhaps its component.
fn sides(derivation: &mut Derivation, claim: &Claim, label: &str, start: f64) -> Vec<(Expr, Expr)> {
    let (text, component) = match label.split_once("   [") {
        Some((text, rest)) => (text, Some(rest.trim_end_matches(']').to_owned())),
        None => (label, None),
    };
    let text = text.trim_end_matches(", in the limit").trim_end_matches(" is constant");
    let wanted = |shape: &rederive::expr::Shape, indices: &[String], at: usize| {
        let names: Vec<String> = shape
            .indices(at)
            .iter()
            .enumerate()
            .map(|(axis, v)| indices.get(axis).map_or(v.to_string(), |n| format!("{n} = {v}")))
            .collect();
        component.as_ref().is_none_or(|c| *c == names.join(", "))
    };
    let mut out = Vec::new();
    let systems: Vec<_> = claim
        .forms
        .iter()
        .filter_map(|f| if let Form::Solves { system } = f { Some(*system) } else { None })
        .flat_map(|s| derivation.systems[s].equations.clone())
        .collect();
    let relations = claim.forms.iter().filter_map(|f| match f {
        Form::Always(w) | Form::Never(w) | Form::Eventually(w) => Some(w),
        _ => None,
    });
    for w in relations.chain(&systems).filter(|w| w.text.trim() == text.trim()) {
        for r in &w.value.relations {
            for (at, (l, r_)) in r.left.components.iter().zip(&r.right.components).enumerate() {
                if wanted(&r.left.shape, &r.indices, at) {
                    out.push((*l, *r_));
                }
            }
        }
    }
    let graph = &mut derivation.graph;
    let start = graph.constant(rederive::expr::Rational::try_from(start).expect("finite"));
    for form in &claim.forms {
        if let Form::FirstIntegral(w) = form
            && w.text.trim() == text.trim()
        {
            for (at, e) in w.value.components.iter().enumerate() {
                if wanted(&w.value.shape, &[], at) {
                    let fixed = graph.substitute(*e, |g, leaf| {
                        let moves = leaf.instant.is_none()
                            && claim.scope.role(leaf.symbol) != Some(rederive::latex::Role::Parameter);
                        moves.then(|| g.leaf(rederive::expr::Leaf { instant: Some(start), ..leaf }))
                    });
                    out.push((*e, fixed));
                }
            }
        }
    }
    out
}

/// How far a number may be from the printed one: what is known of the difference, and rounding in terms of this size.
fn close(a: f64, b: f64, bound: f64, size: f64) -> bool {
    (a - b).abs() <= 4.0 * bound + 1e-11 * (1.0 + a.abs().max(b.abs()) + size)
}

/// The largest number on the way to a value: rounding is relative to it.
fn largest(graph: &Graph, e: Expr, values: &BTreeMap<String, f64>) -> f64 {
    graph
        .reachable([e])
        .into_iter()
        .filter_map(|e| value(graph, e, values))
        .filter(|v| v.is_finite())
        .fold(0.0, |m, v| m.max(v.abs()))
}

#[derive(Default, Debug)]
struct Counts {
    compared: usize,
    undefined: usize,
    ranks: usize,
    limits: usize,
    motions: usize,
    shadowed: usize,
}

/// Recomputes every witness of a report.
fn recompute(derivation: &mut Derivation, report: &Value, counts: &mut Counts) {
    let claims = derivation.claims.clone();
    let sign = derivation.scope.branch_sign();
    for account in report["claims"].as_array().expect("claims") {
        let (id, reading) = (account["id"].as_str().expect("id"), account["reading"].as_str());
        let claim = claims.iter().find(|c| c.id == id && c.reading.as_deref() == reading).expect("declared");
        for pair in account["results"].as_array().expect("results") {
            let witness = &pair["witness"];
            if witness.is_null() {
                assert_ne!(pair["verdict"], "fails", "{id}: a failure without a witness");
                continue;
            }
            let place = format!("{} on {}", claim.name(), pair["trajectory"]);
            let label = witness["formula"].as_str().expect("formula");
            let values: BTreeMap<String, f64> = witness["values"]
                .as_object()
                .expect("values")
                .iter()
                .filter_map(|(name, v)| Some((name.clone(), v.as_f64()?)))
                .collect();
            assert!(!values.is_empty(), "{place}: nothing to recompute `{label}` from");
            if values.keys().any(|name| name.ends_with(" (of the file)")) {
                // Two symbols with one name: here values are looked up by names.
                counts.shadowed += 1;
                continue;
            }
            let (left, right) = (witness["left"].as_f64(), witness["right"].as_f64());
            let bound = witness["bound"].as_f64().unwrap_or(0.0);
            if let (Some(left), Some(right)) = (left, right) {
                let printed = witness["difference"].as_f64().expect("a difference");
                assert_eq!(printed, (left - right).abs(), "{place}: the difference is |left − right|");
            }
            if label.starts_with("rank of") {
                counts.ranks += 1;
                continue;
            }
            if label.ends_with(" of both motions") {
                let numbers: Vec<f64> = values.values().copied().collect();
                assert!(numbers.contains(&left.expect("left")) && numbers.contains(&right.expect("right")), "{place}");
                counts.motions += 1;
                continue;
            }
            if label.contains(" has a value") {
                assert_eq!((left, right), (None, None), "{place}: what has no value shows none");
                counts.undefined += 1;
                continue;
            }
            let (left, right) = (left.expect("a left side"), right.expect("a right side"));
            let id = pair["trajectory"].as_str().expect("id");
            let start = derivation.trajectories.iter().find(|t| t.id == id).expect("declared").initial_time;
            let found = sides(derivation, claim, label, start);
            assert!(!found.is_empty(), "{place}: no formula `{label}`");
            let graph = &derivation.graph;
            let mut tried = Vec::new();
            let agrees = found.iter().any(|&(l, r)| {
                [1.0, -1.0].iter().any(|&s| {
                    let mut values = values.clone();
                    values.insert(graph.leaf_latex(sign), s);
                    let (Some(l_), Some(r_)) = (value(graph, l, &values), value(graph, r, &values)) else {
                        return false;
                    };
                    let size = largest(graph, l, &values).max(largest(graph, r, &values));
                    tried.push((l_, r_));
                    close(l_, left, bound, size) && close(r_, right, bound, size)
                })
            });
            if label.ends_with(", in the limit") {
                counts.limits += 1;
            }
            assert!(agrees, "{place}, `{label}`: printed {left} and {right}, recomputed {tried:?} from {values:?}");
            counts.compared += 1;
        }
    }
    let _ = RelationKind::Equal;
}

fn of(name: &str, options: &Options) -> (Derivation, Value) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations").join(name);
    let derivation = load(&path).unwrap_or_else(|d| panic!("{name}: {d:?}"));
    let account = check(&derivation, options, &|_, _| {}).expect("checked");
    let report = serde_json::from_str(&json(&derivation, &account)).expect("JSON");
    (derivation, report)
}

#[test]
fn witnesses_of_the_small_files() {
    let mut counts = Counts::default();
    for rigor in [Rigor::Sampled, Rigor::Enclosed] {
        for name in ["kepler.toml", "pendulum.toml"] {
            let (mut derivation, report) = of(name, &Options { rigor, plain: true, ..Options::default() });
            recompute(&mut derivation, &report, &mut counts);
        }
    }
    assert!(counts.compared > 50, "{counts:?}");
}

/// Vector equations, limits, definedness, ranks and one sign of ±, certified on motions of every kind.
#[test]
fn witnesses_of_the_comment_on_some_motions() {
    let ids = |names: &[&str]| names.iter().map(|n| n.to_string()).collect::<Vec<_>>();
    let options = Options {
        rigor: Rigor::Enclosed,
        plain: true,
        claims: ids(&[
            "chosen-momentum",
            "four-constants",
            "theta-to-zero",
            "only-through-unit",
            "m-from-start",
            "t8-outside",
            "t11",
            "t15-limits",
            "t15-no-motion",
            "t1-euler",
        ]),
        trajectories: ids(&[
            "t8-stable",
            "t8-turned",
            "unit-generic",
            "psi-oscillating",
            "t15-plus",
            "t15-lab",
            "generic-generic",
        ]),
        ..Options::default()
    };
    let (mut derivation, report) = of("deriglazov-comment.toml", &options);
    let mut counts = Counts::default();
    recompute(&mut derivation, &report, &mut counts);
    assert!(counts.compared > 30, "{counts:?}");
    assert!(counts.ranks > 0 && counts.undefined > 0 && counts.limits > 0, "{counts:?}");
}

/// The committed reports, all of each, wherever they are of the file as it is.
#[test]
fn witnesses_of_the_committed_reports() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut counts = Counts::default();
    for name in ["deriglazov-comment", "kepler", "pendulum"] {
        let mut derivation = load(&root.join("derivations").join(format!("{name}.toml"))).expect("read");
        let text = std::fs::read_to_string(root.join("reports").join(name).join("report.json")).expect("a report");
        let report: Value = serde_json::from_str(&text).expect("JSON");
        // A report of an earlier version has no differences, and is told to be stale elsewhere.
        if report["derivation"]["sha256"] == derivation.sha256.as_str() && report["digest"].is_object() {
            recompute(&mut derivation, &report, &mut counts);
        }
    }
    assert!(counts.compared > 300 && counts.shadowed < 60, "{counts:?}");
}
