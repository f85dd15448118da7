//! The curves of all pairs, for the script.
//!
//! A page may have thousands of pairs. Each of its curves is some sixty samples; a value takes two characters: its place
//! between the least and the largest value, in one of some hundred steps, and of residuals and bounds the logarithm, in one of
//! eighty. That is finer than a line is thick. Equal texts are stored once. Numbers that a reader may want exactly (worst residual, witness)
//! are stored as numbers. The whole is [packed](super::packed).

use std::collections::HashMap;

use rayon::prelude::*;
use serde_json::{Value, json};

use super::super::tally::{declared, name};
use super::claims::assigned;
use super::packed::{DIGITS, digit};
use super::text::{formula, label_parts};
use super::tight::tight;
use crate::derivation::{Claim, Derivation, Event};
use crate::latex::Scope;
use findings::{Account, ClaimAccount, PairAccount, ResidualPoint, Residuals};

/// Values of the second character.
const FINE: usize = 12;
/// Steps between the least and the largest value, and one more for what is not finite.
const STEPS: usize = DIGITS.len() * FINE;

/// Of what holds, one sample in so many is drawn.
const THIN: usize = 4;
/// Of the second characters, so many are taken as one: what is not seen is not stored. Times are stored as they are.
const GRAIN: Grain = Grain { time: 1, side: 3, logarithm: FINE };

struct Grain {
    time: usize,
    side: usize,
    logarithm: usize,
}
/// Shortest text that is worth a place of its own among the strings.
const WORTH: usize = 5;

/// The data as JSON.
///
/// `pairs` is by claim, then by the position of the trajectory. A pair is `[curves, worst, witness, excluded]`, each null
/// where there is none; curves are `[formula, samples, [least, largest], [first, last], [lowest, highest decade], t, left,
/// right, residual, bound, limit]`, where a right side of null is the same as the left. The limit is 0 where the relation is looked for at some time, and null where it is no
/// equation. A witness is `[formula, t, left, right, bound, names, values…]`, with one name in each line. `events` gives the
/// equation at which a claim is tried: its samples are events.
///
/// `folds` are what is folded on the page, by the `data-k` of its element.
///
/// Texts and packed columns are themselves, or positions in `strings`, where they occur several times; a list is its texts
/// one after the other.
pub(super) fn json(derivation: &Derivation, account: &Account, folds: &[String]) -> String {
    let of_claim = |claim: &ClaimAccount| {
        let mut pairs = serde_json::Map::new();
        let declared = declared(derivation, claim);
        let mut texts = Texts { scope: declared.map_or(&derivation.scope, |d| &d.scope), known: HashMap::new() };
        for pair in &claim.results {
            let trajectory = account.trajectories.iter().position(|t| t.id == pair.trajectory);
            if let (Some(t), Some(packed)) = (trajectory, packed(account, declared, pair, &mut texts)) {
                pairs.insert(t.to_string(), packed);
            }
        }
        let event = declared.and_then(|d| Some((d, d.at.as_ref()?)));
        let shown =
            |at: &Event, scope| format!("{}{}", formula(&at.equation.text, scope).into_string(), at.occasion.words());
        (pairs, event.map(|(d, at)| tight(&shown(at, &d.scope))))
    };
    let each: Vec<_> = account.claims.par_iter().map(of_claim).collect();
    let (mut claims, mut events) = (serde_json::Map::new(), serde_json::Map::new());
    for (claim, (pairs, event)) in account.claims.iter().zip(each) {
        if let Some(event) = event {
            events.insert(name(claim), event.into());
        }
        if !pairs.is_empty() {
            claims.insert(name(claim), Value::Object(pairs));
        }
    }
    let strings = share([&mut events, &mut claims]);
    let time = derivation.scope.time().map(|l| l.symbol);
    let unit = derivation.symbols.iter().find(|s| Some(s.symbol) == time).and_then(|s| s.unit.clone());
    json!({ "unit": unit, "strings": strings, "events": events, "pairs": claims, "folds": folds }).to_string()
}

/// Takes the texts that occur several times out of the maps; what is left in their place is their position in what is returned,
/// the most frequent first: they have the shortest numbers.
fn share(maps: [&mut serde_json::Map<String, Value>; 2]) -> Vec<String> {
    let [events, pairs] = maps;
    let mut found: HashMap<String, (usize, usize)> = HashMap::new();
    let mut count = |text: &mut Value| {
        if let Value::String(text) = text {
            let order = found.len();
            found.entry(text.clone()).or_insert((0, order)).0 += 1;
        }
    };
    events.values_mut().chain(pairs.values_mut()).for_each(|v| each_text(v, &mut count));
    let mut several: Vec<(String, (usize, usize))> =
        found.into_iter().filter(|(text, (times, _))| *times > 1 && text.len() >= WORTH).collect();
    several.sort_by_key(|(_, (times, order))| (std::cmp::Reverse(*times), *order));
    let strings: Vec<String> = several.into_iter().map(|(text, _)| text).collect();
    let places: HashMap<&str, usize> = strings.iter().enumerate().map(|(at, text)| (text.as_str(), at)).collect();
    let mut place = |value: &mut Value| {
        if let Some(&at) = value.as_str().and_then(|text| places.get(text)) {
            *value = at.into();
        }
    };
    events.values_mut().chain(pairs.values_mut()).for_each(|v| each_text(v, &mut place));
    strings
}

/// Every text of a value.
fn each_text(value: &mut Value, work: &mut impl FnMut(&mut Value)) {
    match value {
        Value::String(_) => work(value),
        Value::Array(list) => list.iter_mut().for_each(|v| each_text(v, work)),
        Value::Object(map) => map.values_mut().for_each(|v| each_text(v, work)),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

/// The labels of a claim's formulas as they are shown: the same on many motions.
struct Texts<'a> {
    scope: &'a Scope,
    known: HashMap<&'a str, Value>,
}

impl<'a> Texts<'a> {
    fn of(&mut self, label: &'a str) -> Value {
        let scope = self.scope;
        let made = || label_parts(label, scope).iter().map(|part| tight(&part.0)).collect();
        self.known.entry(label).or_insert_with(made).clone()
    }
}

fn packed<'a>(
    account: &Account,
    declared: Option<&Claim>,
    pair: &'a PairAccount,
    texts: &mut Texts<'a>,
) -> Option<Value> {
    let evidence = pair.verdict.evidence();
    // Events are few: they are shown on the whole span of the motion, and one is enough.
    let at_events = declared.is_some_and(|d| d.at.is_some());
    let span = account.trajectories.iter().find(|t| t.id == pair.trajectory).map(|t| t.span).filter(|_| at_events);
    let drawn = evidence.series.as_deref().filter(|s| s.points.len() > usize::from(!at_events));
    // What holds is the same line twice: fewer samples say it.
    let holds = matches!(pair.verdict.outcome(), findings::Outcome::Holds(_));
    let thin = if holds && !at_events { THIN } else { 1 };
    let curves = drawn.map(|s| curves(s, span, texts.of(&s.formula), thin));
    let worst = evidence.residual.as_ref().map(|r| json!([short(r.at), short(r.max), short(r.bound)]));
    let witness = evidence.witness.as_ref().map(|w| {
        let (names, values): (Vec<String>, Vec<f64>) = assigned(w).into_iter().unzip();
        let mut out = vec![texts.of(&w.formula), json!(w.t), json!(w.left), json!(w.right), short(w.bound)];
        out.push(names.join("\n").into());
        // What JSON has no number for is a text.
        let number = |v: f64| if v.is_finite() { json!(v) } else { format!("{v:?}").into() };
        out.extend(values.into_iter().map(number));
        Value::Array(out)
    });
    if curves.is_none() && witness.is_none() {
        return None;
    }
    let mut out = vec![json!(curves), json!(worst), json!(witness)];
    if !evidence.excluded.is_empty() {
        out.push(evidence.excluded.iter().map(|e| json!([short(e.from), short(e.to)])).collect());
    } else if witness.is_none() {
        out.truncate(2);
    }
    Some(Value::Array(out))
}

/// A number, a whole one without its `.0`.
fn exact(x: f64) -> Value {
    if x.fract() == 0.0 && x.abs() < 1e6 { (x as i64).into() } else { json!(x) }
}

/// A number with four digits.
fn short(x: f64) -> Value {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    let whole = rounded.fract() == 0.0 && rounded.abs() < 1e6;
    if whole {
        (rounded as i64).into()
    } else {
        serde_json::Number::from_f64(rounded).map_or(Value::Null, Value::Number)
    }
}

fn curves(series: &Residuals, span: Option<(f64, f64)>, formula: Value, thin: usize) -> Value {
    let last = series.points.len().saturating_sub(1);
    let worst = |p: &ResidualPoint| if p.bound > 0.0 { p.residual / p.bound } else { 0.0 };
    let most = series.points.iter().map(worst).fold(0.0, f64::max);
    let kept = |(i, p): &(usize, &ResidualPoint)| i % thin == 0 || *i == last || worst(p) == most;
    let points: Vec<ResidualPoint> = series.points.iter().enumerate().filter(kept).map(|(_, p)| *p).collect();
    let values = |f: &dyn Fn(&ResidualPoint) -> f64| -> Vec<f64> { points.iter().map(f).collect() };
    let (t, left, right) = (values(&|p| p.t), values(&|p| p.left), values(&|p| p.right));
    let span = span.unwrap_or((t.first().copied().unwrap_or(0.0), t.last().copied().unwrap_or(1.0)));
    let range = extent(left.iter().chain(&right).copied());
    let (residual, bound) = (values(&|p| pxfm::f_log10(p.residual)), values(&|p| pxfm::f_log10(p.bound)));
    let (low, high) = extent(residual.iter().chain(&bound).copied());
    let decades = (low.floor(), high.ceil());
    let side = |values: &[f64]| column(values, range, GRAIN.side);
    let (l, r) = (side(&left), side(&right));
    let r = (r != l).then_some(r);
    let limit = points.iter().map(|p| p.limit).fold(f64::INFINITY, f64::min);
    json!([
        formula,
        series.of,
        [short(range.0), short(range.1)],
        [exact(span.0), exact(span.1)],
        [short(decades.0), short(decades.1)],
        column(&t, span, GRAIN.time),
        l,
        r,
        column(&residual, decades, GRAIN.logarithm),
        column(&bound, decades, GRAIN.logarithm),
        match (series.sought, series.equation) {
            (true, _) => 0.into(),
            (false, true) => short(limit),
            (false, false) => Value::Null,
        },
    ])
}

/// Least and largest of the finite values.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|x| x.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low <= high { (low, high) } else { (0.0, 0.0) }
}

/// Two characters for each value, first those of all values that say most: alike stands beside alike, and packs well. What is
/// not finite (the logarithm of 0) is 0, the others are spread over the range, `grain` steps as one.
fn column(values: &[f64], (low, high): (f64, f64), grain: usize) -> String {
    let width = if high > low { high - low } else { 1.0 };
    let step = |x: &f64| match x.is_finite() {
        true => 1 + (((x - low) / width).clamp(0.0, 1.0) * (STEPS - 2) as f64).round() as usize,
        false => 0,
    };
    let coarse = values.iter().map(|x| digit(step(x) / FINE));
    // The middle of the steps that are one; what is not finite stays what it is.
    let fine = |step: usize| if step == 0 { 0 } else { step % FINE / grain * grain + grain / 2 };
    coarse.chain(values.iter().map(|x| digit(fine(step(x))))).collect()
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::*;

    #[test]
    fn texts_that_occur_several_times_are_stored_once() {
        let map = |value: Value| value.as_object().cloned().unwrap_or_default();
        let mut events = map(json!({ "c": "seldom seen" }));
        let mut pairs =
            map(json!({ "c": { "0": [["often", "seldom seen", 1.5, ["often", "once only"]], null, ["ab", "ab"]] },
            "d": ["often"] }));
        assert_eq!(share([&mut events, &mut pairs]), ["often", "seldom seen"]);
        assert_eq!(Value::Object(events), json!({ "c": 1 }));
        assert_eq!(
            Value::Object(pairs),
            json!({ "c": { "0": [[0, 1, 1.5, [0, "once only"]], null, ["ab", "ab"]] }, "d": [0] })
        );
    }

    #[test]
    fn values_are_packed_in_order_and_reach_both_ends() {
        assert_eq!(column(&[0.0, 1.0], (0.0, 1.0), 1), "0|1B");
        assert_eq!(column(&[0.0, 1.0], (0.0, 1.0), 3), "0|1A");
        assert_eq!(column(&[0.0, 1.0], (0.0, 1.0), FINE), "0|66");
        assert_eq!(column(&[5.0, 5.0], (5.0, 5.0), 1), "0011");
        for grain in [1, 3, FINE] {
            assert_eq!(column(&[f64::NAN, f64::NEG_INFINITY], (0.0, 1.0), grain), "0000");
        }
        let packed = column(&[0.25, 0.5], (0.0, 1.0), 1);
        assert!(packed[..1] < packed[1..2], "{packed}");
    }
}
