//! Measured comparisons, judged at every time by themselves.
//!
//! **In:** both sides of every comparison with their error bounds ([`MeasuredGroup`]). **Out:** what is known of the group at each time,
//! and which comparison decides that. What it adds up to over all times is seen in `weigh`.

use std::sync::Arc;

use crate::describe::{Describer, Left, Setting};
use crate::flow::Points;
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};
use crate::trace::Trial;
use crate::verdict::{Possible, Quantifier, Truth, Witness};
use claim::comparison::Comparison;
use claim::program::Assumption;
use claim::sides::{Measured, MeasuredGroup, Measurements};
use reason::Sampling;

/// The times at which a claim is tried, with the values there, and which of them count.
pub(super) struct Tried<'a> {
    /// The times, increasing.
    pub times: &'a [f64],
    /// The values.
    pub points: &'a Arc<Points>,
    /// Which count.
    pub left: Vec<Left>,
}

/// What rounding explains, as a part of the size of the terms: four times as much is in the bound of every state, and ten times that
/// refutes.
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A measured group, judged.
pub(super) struct Pointwise<'a, 'g> {
    /// The measurements.
    pub measured: &'a MeasuredGroup<'g>,
    precision: f64,
    /// Whether it consists of equations only, that say more than that they have values.
    equations: bool,
    /// `[s][i]`: what is known of the whole group at time i for the sign s.
    pub whole: Vec<Vec<Possible>>,
    /// What is known at each time, of all signs together.
    together: Vec<Possible>,
}

impl<'a, 'g> Pointwise<'a, 'g> {
    /// Judges every comparison at every time.
    pub fn new(measured: &'a MeasuredGroup<'g>, precision: f64) -> Pointwise<'a, 'g> {
        let equations = measured.group.comparisons.iter().all(|c| c.kind == RelationKind::Equal);
        let equations = equations && !measured.group.asserted && measured.group.formula.is_none();
        let whole: Vec<Vec<Possible>> = (0..measured.signs.len()).map(|s| measured.stand(s, precision)).collect();
        let times = whole.iter().map(Vec::len).min().unwrap_or(0);
        let at = |time: usize| measured.group.over_signs(whole.iter().map(|s| s[time]));
        let together = (0..times).map(at).collect();
        Pointwise { measured, precision, equations, whole, together }
    }

    /// The comparison that decides the standing at a time, for one sign: the one that is furthest off, against the size of its
    /// terms, among the worst; where all is well, the one with the largest residual.
    pub fn deciding(&self, sign: usize, time: usize) -> usize {
        if self.whole[sign][time] == Possible::TRUE {
            return self.largest(sign, time);
        }
        let series = &self.measured.signs[sign];
        if series.len() == 1 {
            return 0;
        }
        let scale = |c: usize| self.measured.scale(sign, c, time);
        let off = |c: usize| series[c].difference(time).map_or(f64::INFINITY, |d| d.value.abs() / scale(c));
        let worst = self.worst(sign, time).map(|c| (c, off(c)));
        worst.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(c, _)| c)
    }

    /// The comparison with the largest residual at a time, in units of its error bound, among those that stand as the whole
    /// group does, for one sign. Among equals the one with the largest bound.
    pub fn largest(&self, sign: usize, time: usize) -> usize {
        let series = &self.measured.signs[sign];
        if series.len() == 1 {
            return 0;
        }
        let size = |c: usize| match series[c].difference(time) {
            Ok(d) => (ratio(d.value.abs(), d.error), d.error),
            // What has no value says nothing; it is not what is false, unless a value is promised.
            Err(_) if self.whole[sign][time] == Possible::FALSE && !self.measured.group.asserted => (-1.0, 0.0),
            Err(_) => (f64::INFINITY, f64::INFINITY),
        };
        let larger = |a: (usize, (f64, f64)), b: (usize, (f64, f64))| if b.1 > a.1 { b } else { a };
        let sized = |c| (c, size(c));
        // What is violated of an equation is further off than what is not.
        let found = match (self.whole[sign][time], self.equations) {
            (Possible::TRUE, _) | (Possible::FALSE, true) => (0..series.len()).map(sized).reduce(larger),
            _ => self.worst(sign, time).map(sized).reduce(larger),
        };
        found.map_or(0, |(c, _)| c)
    }

    /// The comparisons on which it hangs what the whole group is at a time, for one sign; those that are as the group is
    /// where none decides alone.
    pub fn worst(&self, sign: usize, time: usize) -> impl Iterator<Item = usize> + '_ {
        let whole = self.whole[sign][time];
        let standing = move |c: usize| self.measured.standing(sign, c, time, self.precision);
        let count = self.measured.signs[sign].len();
        let group = self.measured.group;
        let alone = move |c: usize| {
            group.formula.is_some() && group.value(|n| if n == c { Possible::ANY } else { standing(n) }) != whole
        };
        let decides = group.formula.is_some() && (0..count).any(alone);
        (0..count).filter(move |&c| count == 1 || if decides { alone(c) } else { standing(c) == whole })
    }

    /// Why a comparison has no value at a time.
    pub fn missing(&self, sign: usize, time: usize) -> (usize, NoValue) {
        let found = |c: usize| self.measured.signs[sign][c].difference(time).err().map(|reason| (c, reason));
        self.worst(sign, time).find_map(found).unwrap_or((0, NoValue::OutOfDomain))
    }

    /// The sign that decides at a time: the one that does best where one is asked for, the one that does worst where both are.
    pub fn sign(&self, time: usize) -> usize {
        if self.whole.len() == 1 {
            return 0;
        }
        let signs = self.whole.iter().map(|s| s[time]).enumerate();
        let rank = |known: Possible| match (known.decided(), self.measured.group.signs) {
            (Some(Truth::True), Quantifier::Some) | (Some(Truth::False), Quantifier::Every) => 0,
            (None, _) => 1,
            (Some(Truth::False), Quantifier::Some) | (Some(Truth::True), Quantifier::Every) => 2,
            (Some(Truth::Void), _) => 3,
        };
        signs.min_by_key(|(_, known)| rank(*known)).map_or(0, |(s, _)| s)
    }

    /// A comparison at some times, with the sign that does best there, and the size of its terms: what a reader is shown. Times
    /// without a value are left out.
    pub fn shown(&self, comparison: usize, times: &[usize]) -> Vec<(usize, Measured, f64)> {
        let known = |time: usize| self.whole.iter().all(|s| time < s.len());
        let best = |time: usize| known(time).then(|| self.sign(time));
        let mut out = Vec::with_capacity(times.len());
        for sign in 0..self.whole.len() {
            let here: Vec<usize> = times.iter().copied().filter(|&time| best(time) == Some(sign)).collect();
            let scales = self.measured.scales(sign, comparison, &here);
            let measured = |time: usize| self.measured.signs[sign].get(comparison)?.get(time).ok();
            let each = here.into_iter().zip(scales).filter_map(|(time, scale)| Some((time, measured(time)?, scale)));
            out.extend(each);
        }
        out.sort_by_key(|(time, ..)| *time);
        out
    }

    /// The largest share of its error bound that the sides of a comparison are apart at a time, of those that are one within it; 0
    /// where there is none. What rounding alone explains does not count: no bound of a state is less.
    pub fn within(&self, sign: usize, time: usize) -> f64 {
        let rounding = ROUNDING * self.measured.floor(sign);
        let share = |d: Bounded| if d.value.abs() <= rounding { 0.0 } else { ratio(d.value.abs(), d.error) };
        let shares = self.measured.signs[sign].iter().filter_map(|series| series.difference(time).ok().map(share));
        shares.filter(|share| *share <= 1.0).fold(0.0, f64::max)
    }

    /// What is known at a time, of all signs together.
    pub fn at(&self, time: usize) -> Possible {
        self.together.get(time).copied().unwrap_or(Possible::ANY)
    }
}

/// A point of a comparison that a reader can check.
pub(super) fn witness(setting: &Setting, comparison: &Comparison, time: usize, m: Measured) -> Witness {
    Witness {
        t: setting.times[time],
        formula: comparison.label.clone(),
        left: m.left,
        right: m.right,
        bound: m.difference.error,
        values: setting.describer.values(comparison, time),
    }
}

/// A residual in units of its bound.
pub(super) fn ratio(size: f64, bound: f64) -> f64 {
    if size == 0.0 { 0.0 } else { size / bound }
}

/// Which of the times the selectors leave.
pub(super) fn selected(trial: &Trial, measured: &Measurements, describer: &Describer) -> Vec<Left> {
    let mut left = vec![Left::In; describer.times.len()];
    for (Assumption { text, part }, group) in trial.program.selectors.iter().zip(&measured.selectors) {
        let judged = Pointwise::new(group, trial.claim.precision);
        let text: Arc<str> = text.as_str().into();
        let not_met = Arc::new(Sampling::NotMet { text: Arc::clone(&text), sides: None }.into());
        let open = Arc::new(Sampling::AssumptionOpen { text, why: None }.into());
        for (i, left) in left.iter_mut().enumerate() {
            let now = match judged.at(i).decided() {
                Some(Truth::True) => continue,
                Some(Truth::False) => Left::Out(Arc::clone(&not_met)),
                Some(Truth::Void) => {
                    let (c, reason) = judged.missing(0, i);
                    Left::Out(describer.fault(&part.group.comparisons[c], i, reason))
                }
                None => Left::Open(Arc::clone(&open)),
            };
            // What is out for certain is out.
            if *left == Left::In || (matches!(left, Left::Open(_)) && matches!(now, Left::Out(_))) {
                *left = now;
            }
        }
    }
    left
}
