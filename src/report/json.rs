//! `report.json`: the data of a report.

use serde_json::{Map, Value, json};

use super::certificates::file_name;
use super::discrimination;
use super::graph::DerivationGraph;
use super::paper::paper_data;
use super::tally::declared;
use crate::derivation::{ClaimRole, Derivation};
use ::paper::Comparison;
use diag::shown::in_json;
use findings::family::{
    Axis, Boundary, Exception, ExtremeAccount, FamilyMap, FamilySeparation, MeasureAccount, SHARES, SlopeAccount,
};
use findings::{Account, ClaimAccount, FamilyAccount, MemberAccount, PairAccount, Trials, Witness};

/// The contract, as text: stable order, one line for each pair of claim and trajectory.
pub fn json(derivation: &Derivation, account: &Account) -> String {
    text(&document(derivation, account))
}

fn text(value: &Value) -> String {
    let mut out = String::new();
    write(value, 0, &mut out);
    out.push('\n');
    in_json(&out)
}

/// The same with the comparison with the paper, as `paper`.
pub fn json_with_paper(derivation: &Derivation, account: &Account, paper: &Comparison) -> String {
    let mut value = document(derivation, account);
    value["paper"] = paper_data(paper);
    text(&value)
}

/// A number, `null` where there is none.
pub(super) fn number(x: f64) -> Value {
    serde_json::Number::from_f64(x).map_or(Value::Null, Value::Number)
}

fn numbers(xs: &[f64]) -> Value {
    xs.iter().map(|x| number(*x)).collect()
}

fn document(derivation: &Derivation, account: &Account) -> Value {
    let summary = account.summary();
    let conventions: Map<String, Value> =
        derivation.conventions.iter().map(|(k, v)| (k.clone(), Value::String(v.clone()))).collect();
    let mut out = json!({
        "schema": 1,
        "tool": { "name": crate::PROGRAM, "version": env!("CARGO_PKG_VERSION") },
        "derivation": {
            "id": derivation.id,
            "title": derivation.title,
            "sha256": derivation.sha256,
            "concerns": derivation.concerns,
            "source": derivation.source,
            "remark": derivation.remark,
            "encoded_by": derivation.encoded_by,
            "conventions": conventions,
        },
        "trajectories": account.trajectories.iter().map(|t| json!({
            "id": t.id,
            "title": t.title,
            "span": numbers(&[t.span.0, t.span.1]),
            "source": t.source,
            "given": t.given.iter().map(|(n, v)| (n.clone(), numbers(v))).collect::<Map<String, Value>>(),
            "steps": t.steps,
            "error": number(t.error),
            "problem": t.problem,
        })).collect::<Vec<_>>(),
        "claims": account.claims.iter().map(|c| claim(derivation, c)).collect::<Vec<_>>(),
        "graph": DerivationGraph::new(derivation, account).json(),
        "digest": super::front::json(derivation, account),
        "measurements": account.measurements.iter().map(|m| json!({
            "measure": m.measure,
            "trajectory": m.trajectory,
            "values": m.values.iter().map(|(t, v, b)| json!({
                "t": number(*t), "value": number(*v), "bound": number(*b),
            })).collect::<Vec<_>>(),
            "reason": m.reason,
        })).collect::<Vec<_>>(),
        "units": super::units::json(&account.units),
        "alone": super::alone::json(account),
        "summary": {
            "holds": summary.holds,
            "fails": summary.fails,
            "not_applicable": summary.not_applicable,
            "undecided": summary.undecided,
            "unexpected": summary.unexpected,
        },
    });
    if !account.distributions.is_empty() {
        out["distributions"] = account.distributions.iter().map(on_measure).collect();
    }
    out
}

fn claim(derivation: &Derivation, claim: &ClaimAccount) -> Value {
    let declared = declared(derivation, claim);
    let mut out = json!({
        "id": claim.id,
        "reading": claim.reading,
        "says": claim.says,
        "formulas": claim.formulas,
        "kinds": declared.map(|d| d.formulas.iter().map(|f| f.kind.key()).collect::<Vec<_>>()),
        "role": declared.map(|d| d.role).unwrap_or_default().word(),
        "added": declared.is_some_and(|d| d.role == ClaimRole::Added),
        "conclusion": declared.is_some_and(|d| d.conclusion),
        "rests_on": declared.map(|d| d.rests_on.clone()).unwrap_or_default(),
        "place": claim.place,
        "label": declared.and_then(|d| d.label.clone()),
        "assumptions": claim.assumptions,
        "follows_from": declared.map(|d| d.follows_from.clone()),
        "precision": declared.map(|d| number(d.precision)),
        "remark": claim.remark,
        "identity": claim.identity.as_ref().map(|i| json!({
            "verdict": i.verdict(),
            "standing": i.standing(),
            "conditional_on": i.conditional_on.iter().map(|g| json!({ "id": g.name, "standing": g.standing })).collect::<Vec<_>>(),
            "log2_error": i.log2_error.map(number),
            "from": i.from,
            "conditions": i.conditions,
            "exceptions": i.exceptions,
            "given_only_where": i.given_only_where,
            "assumptions": i.assumptions.as_ref().map(|a| json!({ "used": a.used, "unused": a.unused })),
            "presupposed": i.presupposed,
            "generic": i.generic,
            "reason": i.reason,
            "witness": i.witness,
            "branch": i.evidence.branch,
            "trials": i.evidence.trials.as_ref().map(trials),
            "certificate": file_name(claim),
            "no_certificate": i.evidence.no_certificate,
        })),
        "variants": discrimination::claim_json(claim),
        "conditions": super::conditions::json(&claim.conditions),
        "region": claim.region.as_ref().map(super::region::json),
        "results": claim.results.iter().map(pair).collect::<Vec<_>>(),
    });
    if !claim.families.is_empty() {
        out["families"] = claim.families.iter().map(on_family).collect();
    }
    out
}

pub(super) fn trials(trials: &Trials) -> Value {
    json!({
        "count": trials.count, "primes": trials.primes, "degree": number(trials.degree), "height": number(trials.height),
        "signs": trials.signs, "cases": trials.cases,
    })
}

fn pair(pair: &PairAccount) -> Value {
    let outcome = pair.verdict.outcome();
    let evidence = pair.verdict.evidence();
    json!({
        "trajectory": pair.trajectory,
        "verdict": outcome.word(),
        "strength": outcome.strength(),
        "expected": pair.expected,
        "unexpected": pair.is_unexpected(),
        "residual": evidence.residual.as_ref().map(|r| json!({
            "max": number(r.max), "bound": number(r.bound), "at": number(r.at),
        })),
        "samples": evidence.samples,
        "reason": evidence.reason,
        "branch": evidence.branch,
        "excluded": evidence.excluded.iter().map(|e| json!({
            "from": number(e.from), "to": number(e.to), "reason": e.reason,
        })).collect::<Vec<_>>(),
        "discrimination": discrimination::pair_json(pair),
        "witness": evidence.witness.as_ref().map(witness),
    })
}

/// A point that can be checked by hand.
pub(super) fn witness(w: &Witness) -> Value {
    json!({
        "t": number(w.t),
        "formula": w.formula,
        "left": number(w.left),
        "right": number(w.right),
        "difference": number(w.difference()),
        "bound": number(w.bound),
        "values": w.values.iter().map(|(n, v)| (n.clone(), number(*v))).collect::<Map<String, Value>>(),
    })
}

/// Below this depth a value stands on one line: pairs of claim and trajectory do.
const INLINE_DEPTH: usize = 4;

pub(super) fn write(value: &Value, depth: usize, out: &mut String) {
    let line = |out: &mut String, depth: usize| {
        out.push('\n');
        out.extend(std::iter::repeat_n("  ", depth));
    };
    let nested = |v: &Value| v.is_object() || v.is_array();
    match value {
        Value::Object(map) if depth < INLINE_DEPTH && !map.is_empty() => {
            out.push('{');
            for (i, (key, value)) in map.iter().enumerate() {
                out.push_str(if i == 0 { "" } else { "," });
                line(out, depth + 1);
                out.push_str(&Value::String(key.clone()).to_string());
                out.push_str(": ");
                write(value, depth + 1, out);
            }
            line(out, depth);
            out.push('}');
        }
        Value::Array(items) if depth < INLINE_DEPTH && items.iter().any(nested) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                out.push_str(if i == 0 { "" } else { "," });
                line(out, depth + 1);
                write(item, depth + 1, out);
            }
            line(out, depth);
            out.push(']');
        }
        other => out.push_str(&other.to_string()),
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    #[test]
    fn the_contract_is_kept() {
        let text = json(&derivation(), &sample::account());
        let value: Value = serde_json::from_str(&text).expect("this is JSON");
        assert_eq!(value, document(&derivation(), &sample::account()));
        insta::assert_snapshot!(text);
    }
}

fn member(of: &MemberAccount) -> Value {
    let outcome = of.verdict.outcome();
    let evidence = of.verdict.evidence();
    json!({
        "number": of.number,
        "values": of.values.iter().map(|(name, x)| (name.clone(), number(*x))).collect::<Map<String, Value>>(),
        "verdict": outcome.word(),
        "strength": outcome.strength(),
        "reason": evidence.reason,
        "witness": evidence.witness.as_ref().map(witness),
        "trajectory": of.toml,
    })
}

/// An entry of `families`.
fn on_family(family: &FamilyAccount) -> Value {
    let outcome = family.verdict.outcome();
    let mut out = json!({
        "family": family.family,
        "verdict": outcome.word(),
        "strength": outcome.strength(),
        "expected": family.expected,
        "unexpected": family.is_unexpected(),
        "reason": family.verdict.evidence().reason,
        "size": family.size,
        "members": family.counts.members,
        "rejected": family.counts.rejected,
        "holds": family.counts.holds,
        "fails": family.counts.fails,
        "not_applicable": family.counts.not_applicable,
        "undecided": family.counts.undecided,
        "stopped": family.stopped,
        "failing_share": family.failing_share.map(|s| json!({
            "at_most": number(s.at_most),
            "confidence": number(s.confidence),
            "failures": s.failures,
            "draws": s.draws,
        })),
        "first_failing": family.first_failing.as_ref().map(member),
        "clearest_failing": family.clearest_failing.as_ref().map(member),
        "first_undecided": family.first_undecided.as_ref().map(member),
        "closest_call": family.closest_call.as_ref().map(member),
        "closest_gap": family.closest_gap.map(number),
    });
    if let Some(map) = &family.map {
        out["map"] = of_map(map);
    }
    if let Some(found) = &family.separation {
        out["separation"] = separation(found);
    }
    if let Some(found) = &family.slope {
        out["slope"] = slope(found);
    }
    out
}

/// The slope of a scaling law over a family.
fn slope(of: &SlopeAccount) -> Value {
    let cells = of.cells.iter().map(|c| json!([number(c.value), number(c.least), number(c.greatest)]));
    json!({
        "with": of.with,
        "pairs": of.pairs,
        "slope": number(of.slope),
        "standard_error": of.standard_error.map(number),
        "bound": number(of.bound),
        "least": number(of.least),
        "greatest": number(of.greatest),
        "power": number(of.power),
        "to": number(of.to),
        "contains_power": of.contains,
        "cells": cells.collect::<Vec<_>>(),
    })
}

/// What separates the members of a family.
fn separation(of: &FamilySeparation) -> Value {
    let exception = |e: &Exception| {
        json!({
            "values": e.values.iter().map(|(name, x)| (name.clone(), number(*x))).collect::<Map<String, Value>>(),
            "holds": e.holds,
            "trajectory": e.toml,
        })
    };
    json!({
        "explanation": of.explanation.as_ref().map(super::conditions::explanation_json),
        "holds": of.sides.0,
        "fails": of.sides.1,
        "fresh": { "right": of.right, "wrong": of.wrong, "undecided": of.open },
        "exception": of.exception.as_ref().map(exception),
    })
}

/// An entry of `distributions`.
fn on_measure(of: &MeasureAccount) -> Value {
    let extreme = |of: &ExtremeAccount| {
        json!({
            "number": of.number,
            "values": of.values.iter().map(|(name, x)| (name.clone(), number(*x))).collect::<Map<String, Value>>(),
            "value": number(of.value),
            "trajectory": of.toml,
        })
    };
    let found = &of.distribution;
    let quantile = |share: f64| {
        let (low, high) = found.quantile(share)?;
        Some(json!({ "share": number(share), "from": number(low), "to": number(high) }))
    };
    json!({
        "measure": of.measure,
        "family": of.family,
        "members": found.members,
        "without": found.without,
        "partial": found.partial,
        "values": found.values(),
        "bound": number(found.bound),
        "least": of.least.as_ref().map(extreme),
        "greatest": of.greatest.as_ref().map(extreme),
        "quantiles": SHARES.into_iter().filter_map(quantile).collect::<Vec<_>>(),
        "stopped": of.stopped,
    })
}

/// The map of a family: two axes with the least and greatest value of each cell, and the counts row by row from below.
fn of_map(map: &FamilyMap) -> Value {
    let axis = |axis: &Axis| {
        let cells: Vec<Value> = axis.cells.iter().map(|(from, to)| json!([number(*from), number(*to)])).collect();
        json!({ "name": axis.name, "cells": cells })
    };
    let rows: Vec<&[[u64; 4]]> = map.cells.chunks(map.across.cells.len().max(1)).collect();
    let mut out = json!({
        "across": axis(&map.across),
        "up": axis(&map.up),
        "counts": ["holds", "fails", "not_applicable", "undecided"],
        "rows": rows,
    });
    if let Some(boundary) = &map.boundary {
        out["boundary"] = of_boundary(boundary);
    }
    out
}

/// The boundary on a map: at the ends of each crossing are motions that were tried.
fn of_boundary(boundary: &Boundary) -> Value {
    let [across, up] = boundary.widths.map(|w| w.map_or(Value::Null, number));
    let crossings = boundary.crossings.iter().map(|c| {
        json!({
            "across": [number(c.across.0), number(c.across.1)],
            "up": [number(c.up.0), number(c.up.1)],
            "first": if c.first_holds { "holds" } else { "fails" },
            "narrow": c.is_narrow,
        })
    });
    json!({
        "widths": { "across": across, "up": up },
        "crossings": crossings.collect::<Vec<_>>(),
        "members": boundary.members,
        "stopped": boundary.stopped,
    })
}
