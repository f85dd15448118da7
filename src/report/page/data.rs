//! The curves of all pairs, for the script.
//!
//! A page may have thousands of pairs. Each of its curves is some sixty samples; a value takes two characters: its place
//! between the least and the largest value, in one of some hundred steps, and of residuals and bounds the logarithm, in one of
//! eighty. That is finer than a line is thick. Equal texts are stored once. Numbers that a reader may want exactly (worst residual, witness)
//! are stored as numbers. The whole is [packed](super::compression).

use std::collections::HashMap;

use rayon::prelude::*;
use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};

use super::super::tally::{declared, name};
use super::claims::assigned;
use super::compression::{DIGITS, digit};
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
const THIN: usize = 8;
/// Of the second characters, so many are taken as one: what is not seen is not stored. Times are stored as they are.
const GRAIN: Grain = Grain { time: 1, side: 4, logarithm: FINE };

struct Grain {
    time: usize,
    side: usize,
    logarithm: usize,
}
/// Shortest text that is worth a place of its own among the strings.
const WORTH: usize = 5;

/// Data by names, in the order in which they came.
#[derive(Debug)]
struct Map<T>(Vec<(String, T)>);

impl<T: Serialize> Serialize for Map<T> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// A text or a packed column: itself, or its position in `strings`, where it occurs several times.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
enum Text {
    Whole(String),
    Place(usize),
}

impl From<String> for Text {
    fn from(text: String) -> Text {
        Text::Whole(text)
    }
}

/// What has texts, for [`share`].
trait Texts {
    /// Every text, in order.
    fn texts(&mut self) -> Vec<&mut Text>;
}

impl Texts for Text {
    fn texts(&mut self) -> Vec<&mut Text> {
        vec![self]
    }
}

impl<T: Texts> Texts for Map<T> {
    fn texts(&mut self) -> Vec<&mut Text> {
        self.0.iter_mut().flat_map(|(_, value)| value.texts()).collect()
    }
}

/// A number, a whole one without its `.0`; what JSON has no number for is null.
struct Exact(f64);

impl Serialize for Exact {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Exact(x) = *self;
        if x.fract() == 0.0 && x.abs() < 1e6 { to.serialize_i64(x as i64) } else { to.serialize_f64(x) }
    }
}

/// A number with four digits.
fn short(x: f64) -> Exact {
    Exact(format!("{x:.3e}").parse().unwrap_or(x))
}

/// A number with ten digits: on a page of thousands of witnesses that is enough to look at; `report.json` has all of them.
fn ten_digits(x: f64) -> f64 {
    format!("{x:.9e}").parse().unwrap_or(x)
}

/// A number; what JSON has no number for is a text.
#[derive(Serialize)]
#[serde(untagged)]
enum Number {
    Finite(f64),
    Other(String),
}

/// A label of a claim's formula as it is shown, part by part.
type Label = Vec<Text>;

/// Both sides along a motion, and how they compare.
struct Curves {
    formula: Label,
    samples: usize,
    /// Least and largest value of a side.
    range: [Exact; 2],
    /// First and last time.
    span: [Exact; 2],
    /// Of residuals and bounds.
    decades: [Exact; 2],
    t: Text,
    left: Text,
    /// `None` is the same as the left.
    right: Option<Text>,
    residual: Text,
    bound: Text,
    /// 0 where the relation is looked for at some time, `None` where it is no equation.
    limit: Option<Exact>,
}

impl Serialize for Curves {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Curves { formula, samples, range, span, decades, t, left, right, residual, bound, limit } = self;
        (formula, samples, range, span, decades, t, left, right, residual, bound, limit).serialize(to)
    }
}

/// A point that can be checked by hand.
struct Witness {
    formula: Label,
    t: f64,
    left: f64,
    right: f64,
    bound: Exact,
    /// What the sides depend on, a name in each line, ...
    names: Text,
    /// ... and their values.
    values: Vec<Number>,
}

impl Serialize for Witness {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Witness { formula, t, left, right, bound, names, values } = self;
        let mut list = to.serialize_seq(Some(6 + values.len()))?;
        list.serialize_element(formula)?;
        for number in [t, left, right] {
            list.serialize_element(number)?;
        }
        list.serialize_element(bound)?;
        list.serialize_element(names)?;
        for value in values {
            list.serialize_element(value)?;
        }
        list.end()
    }
}

/// What is drawn and told of a claim on a motion.
struct Pair {
    curves: Option<Curves>,
    /// When the residual is worst, it, and its bound.
    worst: Option<[Exact; 3]>,
    witness: Option<Witness>,
    /// First and last time of what was left out.
    excluded: Vec<[Exact; 2]>,
}

impl Serialize for Pair {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Pair { curves, worst, witness, excluded } = self;
        match (witness, excluded.is_empty()) {
            (None, true) => (curves, worst).serialize(to),
            (Some(witness), true) => (curves, worst, witness).serialize(to),
            (witness, false) => (curves, worst, witness, excluded).serialize(to),
        }
    }
}

impl Texts for Pair {
    fn texts(&mut self) -> Vec<&mut Text> {
        let mut out = Vec::new();
        if let Some(Curves { formula, t, left, right, residual, bound, .. }) = &mut self.curves {
            out.extend(formula);
            out.extend([t, left]);
            out.extend(right);
            out.extend([residual, bound]);
        }
        if let Some(Witness { formula, names, .. }) = &mut self.witness {
            out.extend(formula);
            out.push(names);
        }
        out
    }
}

/// What the script is handed.
#[derive(Serialize)]
struct Data<'a> {
    unit: Option<&'a str>,
    strings: Vec<String>,
    events: Map<Text>,
    pairs: Map<Map<Pair>>,
    folds: &'a [String],
}

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
    let columns = account.columns();
    // A page of thousands of curves is read for its verdicts: of each curve half is enough there.
    let others = if super::has_many_pairs(account) { 2 } else { 1 };
    let of_claim = |claim: &ClaimAccount| {
        let declared = declared(derivation, claim);
        let mut labels = Labels { scope: declared.map_or(&derivation.scope, |d| &d.scope), known: HashMap::new() };
        let pairs = claim.results.iter().filter_map(|pair| {
            let &at = columns.get(pair.trajectory.as_str())?;
            Some((at.to_string(), packed(account.trajectories[at].span, declared, pair, &mut labels, others)?))
        });
        let pairs: Vec<_> = pairs.collect();
        let event = declared.and_then(|d| Some((d, d.at.as_ref()?)));
        let shown =
            |at: &Event, scope| format!("{}{}", formula(&at.equation.text, scope).into_string(), at.occasion.words());
        (pairs, event.map(|(d, at)| tight(&shown(at, &d.scope))))
    };
    let each: Vec<_> = account.claims.par_iter().map(of_claim).collect();
    let (mut pairs, mut events) = (Map(Vec::new()), Map(Vec::new()));
    for (claim, (of_claim, event)) in account.claims.iter().zip(each) {
        events.0.extend(event.map(|event| (name(claim), Text::from(event))));
        if !of_claim.is_empty() {
            pairs.0.push((name(claim), Map(of_claim)));
        }
    }
    let strings = share(events.texts().into_iter().chain(pairs.texts()).collect());
    let time = derivation.scope.time().map(|l| l.symbol);
    let unit = derivation.symbols.iter().find(|s| Some(s.symbol) == time).and_then(|s| s.unit.as_deref());
    // Writing to a string does not fail.
    serde_json::to_string(&Data { unit, strings, events, pairs, folds }).unwrap_or_default()
}

/// Exchanges the texts that occur several times for their positions in what is returned, the most frequent first: they have the
/// shortest numbers.
fn share(texts: Vec<&mut Text>) -> Vec<String> {
    let mut found: HashMap<String, (usize, usize)> = HashMap::new();
    for text in &texts {
        if let Text::Whole(text) = text {
            let order = found.len();
            match found.get_mut(text) {
                Some((times, _)) => *times += 1,
                None => drop(found.insert(text.clone(), (1, order))),
            }
        }
    }
    let mut several: Vec<(String, (usize, usize))> =
        found.into_iter().filter(|(text, (times, _))| *times > 1 && text.len() >= WORTH).collect();
    several.sort_by_key(|(_, (times, order))| (std::cmp::Reverse(*times), *order));
    let strings: Vec<String> = several.into_iter().map(|(text, _)| text).collect();
    let places: HashMap<&str, usize> = strings.iter().enumerate().map(|(at, text)| (text.as_str(), at)).collect();
    for text in texts {
        let place = if let Text::Whole(text) = &*text { places.get(text.as_str()) } else { None };
        if let Some(place) = place {
            *text = Text::Place(*place);
        }
    }
    strings
}

/// The labels of a claim's formulas as they are shown: the same on many motions.
struct Labels<'a> {
    scope: &'a Scope,
    known: HashMap<&'a str, Label>,
}

impl<'a> Labels<'a> {
    fn of(&mut self, label: &'a str) -> Label {
        let scope = self.scope;
        let made = || label_parts(label, scope).iter().map(|part| tight(&part.0).into()).collect();
        self.known.entry(label).or_insert_with(made).clone()
    }
}

fn packed<'a>(
    span: (f64, f64),
    declared: Option<&Claim>,
    pair: &'a PairAccount,
    labels: &mut Labels<'a>,
    others: usize,
) -> Option<Pair> {
    let evidence = pair.verdict.evidence();
    // Events are few: they are shown on the whole span of the motion, and one is enough.
    let at_events = declared.is_some_and(|d| d.at.is_some());
    let span = at_events.then_some(span);
    let drawn = evidence.series.as_deref().filter(|s| s.points.len() > usize::from(!at_events));
    // What holds is the same line twice: fewer samples say it.
    let holds = matches!(pair.verdict.outcome(), findings::Outcome::Holds(_));
    let thin = match (at_events, holds) {
        (true, _) => 1,
        (false, true) => THIN,
        (false, false) => others,
    };
    let curves = drawn.map(|s| curves(s, span, labels.of(&s.formula), thin));
    let worst = evidence.residual.as_ref().map(|r| [r.at, r.max, r.bound].map(short));
    let witness = evidence.witness.as_ref().map(|w| {
        let (names, values): (Vec<String>, Vec<f64>) = assigned(w).into_iter().unzip();
        let number = |v: f64| if v.is_finite() { Number::Finite(v) } else { Number::Other(format!("{v:?}")) };
        Witness {
            formula: labels.of(&w.formula),
            t: w.t,
            left: w.left,
            right: w.right,
            bound: short(w.bound),
            names: names.join("\n").into(),
            values: values.into_iter().map(|v| number(if others > 1 { ten_digits(v) } else { v })).collect(),
        }
    });
    if curves.is_none() && witness.is_none() {
        return None;
    }
    let excluded = evidence.excluded.iter().map(|e| [e.from, e.to].map(short)).collect();
    Some(Pair { curves, worst, witness, excluded })
}

fn curves(series: &Residuals, span: Option<(f64, f64)>, formula: Label, thin: usize) -> Curves {
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
    let (left, right) = (side(&left), side(&right));
    let limit = points.iter().map(|p| p.limit).fold(f64::INFINITY, f64::min);
    Curves {
        formula,
        samples: series.of,
        range: [range.0, range.1].map(short),
        span: [span.0, span.1].map(Exact),
        decades: [decades.0, decades.1].map(short),
        t: column(&t, span, GRAIN.time).into(),
        right: (right != left).then(|| right.into()),
        left: left.into(),
        residual: column(&residual, decades, GRAIN.logarithm).into(),
        bound: column(&bound, decades, GRAIN.logarithm).into(),
        limit: match (series.sought, series.equation) {
            (true, _) => Some(Exact(0.0)),
            (false, true) => Some(short(limit)),
            (false, false) => None,
        },
    }
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
        let all = ["seldom seen", "often", "seldom seen", "often", "once only", "ab", "ab", "often"];
        let mut texts: Vec<Text> = all.map(|text| text.to_owned().into()).into();
        assert_eq!(share(texts.iter_mut().collect()), ["often", "seldom seen"]);
        let written = serde_json::to_string(&texts).expect("JSON");
        assert_eq!(written, r#"[1,0,1,0,"once only","ab","ab",0]"#);
    }

    #[test]
    fn numbers_are_as_short_as_they_can_be() {
        let numbers =
            [Exact(2.0), Exact(-0.0), Exact(0.1), Exact(1e6), Exact(f64::NAN), short(1.23456), short(999999.0)];
        assert_eq!(serde_json::to_string(&numbers).expect("JSON"), "[2,0,0.1,1000000.0,null,1.235,1000000.0]");
        let pair = |witness, excluded| Pair { curves: None, worst: None, witness, excluded };
        assert_eq!(serde_json::to_string(&pair(None, Vec::new())).expect("JSON"), "[null,null]");
        assert_eq!(
            serde_json::to_string(&pair(None, vec![[Exact(0.0), Exact(1.5)]])).expect("JSON"),
            "[null,null,null,[[0,1.5]]]"
        );
        let values = vec![Number::Finite(1.0), Number::Other("inf".into())];
        let names = "a\nb".to_owned().into();
        let witness =
            Witness { formula: vec![Text::Place(3)], t: 0.0, left: 1.0, right: 2.5, bound: short(0.0), names, values };
        let written = serde_json::to_string(&pair(Some(witness), Vec::new())).expect("JSON");
        assert_eq!(written, r#"[null,null,[[3],0.0,1.0,2.5,0,"a\nb",1.0,"inf"]]"#);
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
