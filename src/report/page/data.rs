//! The curves of all pairs, for the script.
//!
//! A page may have thousands of pairs. Each of its curves is some sixty samples; a value is its place between the least and the
//! largest value, in one of some hundred steps, and of residuals and bounds the logarithm, in one of eighty: that is finer than a
//! line is thick. A column holds the change from each sample to the next, which is mostly one character. Equal texts are stored once. Numbers
//! that a reader may want (worst residual, witness) are stored as numbers: where there are thousands, in six digits or as many as tell
//! the sides apart; `report.json` has all of them. The whole is [packed](super::compression).

use std::collections::HashMap;

use rayon::prelude::*;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::super::pair_story::assigned;
use super::super::tally::{declared, name};
use super::compression::{DIGITS, digit};
use super::text::{formula, label_parts};
use super::tight::tight;
use derivation::{Claim, Derivation, Event};
use findings::{Account, ClaimAccount, PairAccount, ResidualPoint, Residuals};
use latex::Scope;

/// Steps between the least and the largest value: of times, of sides, of the logarithms of residuals and bounds.
const STEPS: Steps = Steps { time: 1020, side: 255, logarithm: 85 };

struct Steps {
    time: usize,
    side: usize,
    logarithm: usize,
}
/// A change with a number below this is one character, any other two.
const ONE_DIGIT: usize = 60;

/// Of what holds, one sample in so many is drawn: of few pairs, and of thousands.
const FEW_THIN: usize = 2;
const MANY_THIN: usize = 8;
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

/// A number with so many digits.
fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}

/// A number with four digits.
fn short(x: f64) -> Exact {
    Exact(rounded(x, 4))
}

/// A number with the digits that are shown of it, four and two, and that its place on a logarithmic axis needs.
fn on_axis(x: f64) -> Exact {
    Exact(rounded(x, if (1e-3..1e5).contains(&x.abs()) { 4 } else { 3 }))
}

/// Digits of a witness where a page has few of them.
const ALL_DIGITS: usize = 17;
/// The same where it has thousands, unless more are needed to tell the sides apart.
const FEW_DIGITS: usize = 6;

/// How many digits of a witness are told: of a few witnesses all; of many so many that the sides differ by what can be seen.
fn digits_of(left: f64, right: f64, many: Many) -> usize {
    let apart = (left - right).abs() / left.abs().max(right.abs());
    match many {
        Many::No => ALL_DIGITS,
        Many::Yes if apart > 0.0 => ((2.0 - pxfm::f_log10(apart)).ceil() as usize).clamp(FEW_DIGITS, ALL_DIGITS),
        Many::Yes => FEW_DIGITS,
    }
}

/// Whether the page has thousands of pairs: it is read for its verdicts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Many {
    Yes,
    No,
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

/// What is drawn and told of a claim on a motion.
struct Pair {
    curves: Option<Curves>,
    /// When the residual is worst, it, and its bound.
    worst: Option<[Exact; 3]>,
    witness: Option<Witness>,
    /// First and last time of what was left out.
    excluded: Vec<[Exact; 2]>,
}

/// The pairs column by column: of each entry the values of all pairs, null where there is none. Alike stands beside alike, which
/// packs in two thirds of the place.
struct Columns<'a>(Vec<&'a Pair>);

impl Columns<'_> {
    fn of<'a, T>(&'a self, entry: impl Fn(&'a Pair) -> Option<T>) -> Vec<Option<T>> {
        self.0.iter().map(|pair| entry(pair)).collect()
    }
}

impl Serialize for Columns<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        macro_rules! columns {
            ($part:ident: $($entry:ident),*) => {
                ($(self.of(|pair| pair.$part.as_ref().map(|part| &part.$entry)),)*)
            };
        }
        let worst = |k: usize| self.of(move |pair| Some(&pair.worst.as_ref()?[k]));
        let mut all = to.serialize_struct("Columns", 4)?;
        let curves = columns!(curves: formula, samples, range, span, decades, t, left, right, residual, bound, limit);
        all.serialize_field("curves", &curves)?;
        all.serialize_field("worst", &[worst(0), worst(1), worst(2)])?;
        all.serialize_field("witness", &columns!(witness: formula, t, left, right, bound, names, values))?;
        all.serialize_field("excluded", &self.of(|pair| (!pair.excluded.is_empty()).then_some(&pair.excluded)))?;
        all.end()
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
    pairs: Vec<(&'a str, Vec<usize>)>,
    #[serde(flatten)]
    columns: Columns<'a>,
    folds: &'a [String],
}

/// The data as JSON.
///
/// `pairs` are the claims, each with the positions of its trajectories; so pairs are numbered from 0. What is known of them
/// stands in columns, each a list with one entry for each pair, null where there is none. `curves` are the columns formula, samples,
/// [least, largest], [first, last], [lowest, highest decade], t, left, right, residual, bound, limit, where a right side of null is
/// the same as the left. The limit is 0 where the relation is looked for at some time, and null where it is no equation. `worst` are time,
/// residual, bound; `witness` are formula, t, left, right, bound, names (one in each line), values; `excluded` is one column.
/// `events` gives the equation at which a claim is tried: its samples are events.
///
/// `folds` are what is folded on the page, by the `data-k` of its element.
///
/// Texts and packed columns are themselves, or positions in `strings`, where they occur several times; a list is its texts
/// one after the other.
pub(super) fn json(derivation: &Derivation, account: &Account, folds: &[String]) -> String {
    let columns = account.columns();
    let many = if super::matrix::has_many_pairs(account) { Many::Yes } else { Many::No };
    let of_claim = |claim: &ClaimAccount| {
        let declared = declared(derivation, claim);
        let mut labels = Labels { scope: declared.map_or(&derivation.scope, |d| &d.scope), known: HashMap::new() };
        let pairs = claim.results.iter().filter_map(|pair| {
            let &at = columns.get(pair.trajectory.as_str())?;
            Some((at, packed(account.trajectories[at].span, declared, pair, &mut labels, many)?))
        });
        let pairs: Vec<_> = pairs.collect();
        let event = declared.and_then(|d| Some((d, d.at.as_ref()?)));
        let shown =
            |at: &Event, scope| format!("{}{}", formula(&at.equation.text, scope).into_string(), at.occasion.words());
        (pairs, event.map(|(d, at)| tight(&shown(at, &d.scope))))
    };
    let each: Vec<_> = account.claims.par_iter().map(of_claim).collect();
    let (mut pairs, mut events) = (Vec::new(), Map(Vec::new()));
    for (claim, (of_claim, event)) in account.claims.iter().zip(each) {
        events.0.extend(event.map(|event| (name(claim), Text::from(event))));
        if !of_claim.is_empty() {
            pairs.push((name(claim), of_claim));
        }
    }
    let of_pairs = pairs.iter_mut().flat_map(|(_, of_claim)| of_claim).flat_map(|(_, pair)| pair.texts());
    let strings = share(events.texts().into_iter().chain(of_pairs).collect());
    let columns = Columns(pairs.iter().flat_map(|(_, of_claim)| of_claim.iter().map(|(_, pair)| pair)).collect());
    let pairs = pairs.iter().map(|(claim, of)| (claim.as_str(), of.iter().map(|(at, _)| *at).collect())).collect();
    let time = derivation.scope.time().map(|l| l.symbol);
    let unit = derivation.symbols.iter().find(|s| Some(s.symbol) == time).and_then(|s| s.unit.as_deref());
    // Writing to a string does not fail.
    serde_json::to_string(&Data { unit, strings, events, pairs, columns, folds }).unwrap_or_default()
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
    many: Many,
) -> Option<Pair> {
    let evidence = pair.verdict.evidence();
    // Events are few: they are shown on the whole span of the motion, and one is enough.
    let at_events = declared.is_some_and(|d| d.at.is_some());
    let span = at_events.then_some(span);
    let drawn = evidence.series.as_deref().filter(|s| s.points.len() > usize::from(!at_events));
    // What holds is the same line twice: fewer samples say it.
    let holds = matches!(pair.verdict.outcome(), findings::Outcome::Holds(_));
    let thin = match (at_events, holds, many) {
        (true, ..) | (false, false, _) => 1,
        (false, true, Many::No) => FEW_THIN,
        (false, true, Many::Yes) => MANY_THIN,
    };
    let curves = drawn.map(|s| curves(s, span, labels.of(&s.formula), thin));
    let worst = evidence.residual.as_ref().map(|r| [short(r.at), on_axis(r.max), on_axis(r.bound)]);
    let witness = evidence.witness.as_ref().map(|w| {
        let (names, values): (Vec<String>, Vec<f64>) = assigned(w).into_iter().unzip();
        let digits = digits_of(w.left, w.right, many);
        let told = |v: f64| rounded(v, digits);
        let number = |v: f64| if v.is_finite() { Number::Finite(told(v)) } else { Number::Other(format!("{v:?}")) };
        Witness {
            formula: labels.of(&w.formula),
            t: told(w.t),
            left: told(w.left),
            right: told(w.right),
            bound: short(w.bound),
            names: names.join("\n").into(),
            values: values.into_iter().map(number).collect(),
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
    let side = |values: &[f64]| column(values, range, STEPS.side);
    let (left, right) = (side(&left), side(&right));
    let limit = points.iter().map(|p| p.limit).fold(f64::INFINITY, f64::min);
    Curves {
        formula,
        samples: series.of,
        range: [range.0, range.1].map(short),
        span: [span.0, span.1].map(Exact),
        decades: [decades.0, decades.1].map(short),
        t: column(&t, span, STEPS.time).into(),
        right: (right != left).then(|| right.into()),
        left: left.into(),
        residual: column(&residual, decades, STEPS.logarithm).into(),
        bound: column(&bound, decades, STEPS.logarithm).into(),
        limit: match (series.sought, series.equation) {
            (true, _) => Some(Exact(0.0)),
            (false, true) => Some(on_axis(limit)),
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

/// The places of values, each as the change from the one before. A place is one of so many steps over the range, counted from 1; what is
/// not finite (the logarithm of 0) is at 0. A change d is the number 2d, or −2d − 1 below 0: small changes are small numbers.
fn column(values: &[f64], (low, high): (f64, f64), steps: usize) -> String {
    let width = if high > low { high - low } else { 1.0 };
    let place = |x: &f64| match x.is_finite() {
        true => 1 + (((x - low) / width).clamp(0.0, 1.0) * (steps - 1) as f64).round() as usize,
        false => 0,
    };
    let mut out = String::with_capacity(values.len());
    let mut last = 0;
    for place in values.iter().map(place) {
        let number = if place >= last { 2 * (place - last) } else { 2 * (last - place) - 1 };
        last = place;
        match number.checked_sub(ONE_DIGIT) {
            None => out.push(digit(number)),
            Some(more) => out.extend([digit(ONE_DIGIT + more / DIGITS.len()), digit(more % DIGITS.len())]),
        }
    }
    out
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
        let values = vec![Number::Finite(1.0), Number::Other("inf".into())];
        let names = "a\nb".to_owned().into();
        let witness =
            Witness { formula: vec![Text::Place(3)], t: 0.0, left: 1.0, right: 2.5, bound: short(0.0), names, values };
        let (one, two) = (pair(Some(witness), Vec::new()), pair(None, vec![[Exact(0.0), Exact(1.5)]]));
        let written = serde_json::to_value(Columns(vec![&one, &two])).expect("JSON");
        let none = serde_json::json!([null, null]);
        assert_eq!(written["curves"], serde_json::json!(vec![&none; 11]));
        assert_eq!(written["worst"], serde_json::json!(vec![&none; 3]));
        assert_eq!(written["excluded"], serde_json::json!([null, [[0, 1.5]]]));
        let expected = r#"[[[3],null],[0.0,null],[1.0,null],[2.5,null],[0,null],["a\nb",null],[[1.0,"inf"],null]]"#;
        assert_eq!(written["witness"].to_string(), expected);
    }

    #[test]
    fn places_come_back_from_their_changes() {
        // As the script does it.
        let places = |text: &str| {
            let value = |c: u8| DIGITS.iter().position(|d| *d == c).expect("a digit");
            let (mut out, mut last, mut bytes) = (Vec::new(), 0, text.bytes());
            while let Some(c) = bytes.next() {
                let first = value(c);
                let mut next = || value(bytes.next().expect("a second digit"));
                let number =
                    if first < ONE_DIGIT { first } else { ONE_DIGIT + (first - ONE_DIGIT) * DIGITS.len() + next() };
                last = if number % 2 == 0 { last + number / 2 } else { last - number.div_ceil(2) };
                out.push(last);
            }
            out
        };
        for steps in [STEPS.logarithm, STEPS.side, STEPS.time] {
            let values = [0.0, 1.0, 0.0, f64::NAN, 1.0, 0.5, 0.25, f64::NEG_INFINITY, 0.0];
            let at = |x: f64| 1 + (x * (steps - 1) as f64).round() as usize;
            let expected = [1, steps, 1, 0, steps, at(0.5), at(0.25), 0, 1];
            assert_eq!(places(&column(&values, (0.0, 1.0), steps)), expected, "{steps}");
        }
        assert_eq!(places(&column(&[5.0, 5.0], (5.0, 5.0), 85)), [1, 1]);
    }

    #[test]
    fn a_witness_has_the_digits_that_tell_its_sides_apart() {
        assert_eq!(digits_of(1.0, 2.0, Many::Yes), FEW_DIGITS);
        assert_eq!(digits_of(1.0, 1.0, Many::Yes), FEW_DIGITS);
        assert_eq!(digits_of(f64::NAN, f64::INFINITY, Many::Yes), FEW_DIGITS);
        assert_eq!(digits_of(0.0, 0.0, Many::No), ALL_DIGITS);
        for (left, right) in [(1.0, 1.0 + 1e-9), (-3e7, -3.000_001e7), (1e-300, 1.000_000_1e-300)] {
            let digits = digits_of(left, right, Many::Yes);
            assert!((8..=12).contains(&digits), "{digits}");
            assert_ne!(rounded(left, digits), rounded(right, digits));
        }
    }
}
