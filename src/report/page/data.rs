//! The curves of all pairs, packed for the script.
//!
//! A page may have thousands of pairs. Each of its curves is some fifty samples; a value takes two characters: its place
//! between the least and the largest value, in 1/7225 of the way (85 characters that need no escape, squared). That is
//! finer than a line is thick. Equal strings are stored once. Numbers that a reader may want exactly (worst residual,
//! witness) are stored as numbers.

use std::collections::HashMap;

use serde_json::{Value, json};

use super::super::tally::{declared, name};
use super::claims::pasted;
use super::text::label;
use crate::check::{Account, ClaimAccount, PairAccount, Residuals};
use crate::derivation::Derivation;

/// Digits of the packed values.
const DIGITS: &[u8; 85] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%()*+,-./:;=?@[]^_{|";
/// Steps between the least and the largest value.
const STEPS: f64 = 7224.0;
/// Decades of residuals and bounds; what lies outside is drawn at the edge.
const DECADES: (f64, f64) = (-40.0, 20.0);

/// Strings that are stored once.
#[derive(Default)]
struct Strings {
    all: Vec<String>,
    index: HashMap<String, usize>,
}

impl Strings {
    fn put(&mut self, text: String) -> usize {
        if let Some(&at) = self.index.get(&text) {
            return at;
        }
        self.all.push(text.clone());
        self.index.insert(text, self.all.len() - 1);
        self.all.len() - 1
    }
}

/// The data as JSON that may stand inside a script element.
pub(super) fn json(derivation: &Derivation, account: &Account) -> String {
    let mut strings = Strings::default();
    let mut pairs = serde_json::Map::new();
    for claim in &account.claims {
        for pair in &claim.results {
            if let Some(packed) = packed(derivation, claim, pair, &mut strings) {
                pairs.insert(format!("{}@{}", name(claim), pair.trajectory), packed);
            }
        }
    }
    let units = derivation.symbols.iter().find(|s| Some(s.symbol) == derivation.scope.time().map(|l| l.symbol));
    let unit = units.and_then(|s| s.unit.clone());
    let document = json!({
        "unit": unit,
        "decades": [DECADES.0, DECADES.1],
        "strings": strings.all,
        "pairs": pairs,
    });
    // `<` could end the element that the text stands in.
    document.to_string().replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

fn packed(derivation: &Derivation, claim: &ClaimAccount, pair: &PairAccount, strings: &mut Strings) -> Option<Value> {
    let evidence = pair.verdict.evidence();
    let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
    let mut out = serde_json::Map::new();
    if let Some(series) = evidence.series.as_deref().filter(|s| s.points.len() > 1) {
        out.insert("f".into(), strings.put(label(&series.formula, scope).into_string()).into());
        curves(series, strings, &mut out);
    }
    if let Some(r) = &evidence.residual {
        out.insert("w".into(), json!([r.at, short(r.max), short(r.bound)]));
    }
    if let Some(w) = &evidence.witness {
        out.insert(
            "v".into(),
            json!([
                strings.put(label(&w.formula, scope).into_string()),
                w.t,
                w.left,
                w.right,
                short(w.bound),
                pasted(w)
            ]),
        );
    }
    if !evidence.excluded.is_empty() {
        let all: Vec<Value> = evidence.excluded.iter().map(|e| json!([e.from, e.to])).collect();
        out.insert("x".into(), all.into());
    }
    (!out.is_empty()).then(|| Value::Object(out))
}

/// A number with three digits.
fn short(x: f64) -> Value {
    let rounded: f64 = format!("{x:.2e}").parse().unwrap_or(x);
    serde_json::Number::from_f64(rounded).map_or(Value::Null, Value::Number)
}

fn curves(series: &Residuals, strings: &mut Strings, out: &mut serde_json::Map<String, Value>) {
    let column = |f: &dyn Fn(usize) -> f64| -> Vec<f64> { (0..series.points.len()).map(f).collect() };
    let at = |i: usize| series.points[i];
    let t = column(&|i| at(i).t);
    let (left, right) = (column(&|i| at(i).left), column(&|i| at(i).right));
    let all = || left.iter().chain(&right).copied().filter(|x| x.is_finite());
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
    let span = (t.first().copied().unwrap_or(0.0), t.last().copied().unwrap_or(1.0));
    let log = |x: f64| if x > 0.0 { x.log10() } else { DECADES.0 };
    let logs = |f: &dyn Fn(usize) -> f64| pack(&column(&|i| log(f(i))), DECADES);
    let (l, r) = (pack(&left, (low, high)), pack(&right, (low, high)));
    out.insert("n".into(), series.of.into());
    out.insert("s".into(), json!([short(low), short(high), span.0, span.1]));
    let mut put = |key: &str, text: String, out: &mut serde_json::Map<String, Value>| {
        out.insert(key.into(), strings.put(text).into());
    };
    put("t", pack(&t, span), out);
    if l != r {
        put("r", r, out);
    }
    put("l", l, out);
    put("d", logs(&|i| at(i).residual), out);
    put("b", logs(&|i| at(i).bound), out);
    let limit = series.points.iter().map(|p| p.limit).fold(f64::INFINITY, f64::min);
    if series.equation {
        out.insert("p".into(), short(limit));
    }
}

fn pack(values: &[f64], (low, high): (f64, f64)) -> String {
    let base = DIGITS.len();
    let width = if high > low { high - low } else { 1.0 };
    let mut out = String::with_capacity(2 * values.len());
    for x in values {
        let share = if x.is_finite() { ((x - low) / width).clamp(0.0, 1.0) } else { 0.0 };
        let step = (share * STEPS).round() as usize;
        for digit in [step / base, step % base] {
            out.push(char::from(DIGITS.get(digit).copied().unwrap_or(b'0')));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_packed_in_order_and_reach_both_ends() {
        assert_eq!(pack(&[0.0, 1.0], (0.0, 1.0)), "00||");
        assert_eq!(pack(&[5.0, 5.0], (5.0, 5.0)), "0000");
        assert_eq!(pack(&[f64::NAN], (0.0, 1.0)), "00");
        let packed = pack(&[0.25, 0.5], (0.0, 1.0));
        assert!(packed[..2] < packed[2..]);
    }
}
