//! One claim along one enclosed motion.

use super::cover::{Along, Judgement, Ranges, Selection};
use crate::check::comparison::{Comparison, Group};
use crate::check::program::{Program, Use};
use crate::check::verdict::{Evidence, Outcome, Strength, Verdict, Witness};
use crate::derivation::{Claim, Form};
use crate::flow::Reach;
use crate::latex::RelationKind;
use crate::number::{Bounded, Interval, NoValue};
use std::rc::Rc;

/// Sides that differ for certain refute a claim that holds on samples only if they differ by this many times what the
/// precision allows.
const CLEARLY: f64 = 10.0;
/// The residual of an equation must be below this part of its sides, where these do not vanish.
const TELLING: f64 = 1e-3;
/// How far two routes to the same residual may be apart, in units of the error bound of the sampled one.
const DISAGREEMENT: f64 = 100.0;

/// The residuals of all comparisons of a claim at a time, as samples see them: `None` for a comparison without a value.
pub(super) type Sampled<'a> = &'a dyn Fn(&Comparison, f64) -> Option<Bounded>;

/// Adds to a sampled verdict why it is not stronger.
pub(super) fn remark(verdict: &mut Verdict, reason: &str) {
    let outcome = verdict.outcome();
    let sampled = matches!(outcome, Outcome::Holds(Strength::Sampled) | Outcome::Fails(Strength::Sampled));
    if sampled || outcome == Outcome::Undecided {
        let before = verdict.evidence().reason.as_ref().map_or(String::new(), |r| format!("{r}; "));
        let reason = Some(format!("{before}not enclosed: {reason}"));
        *verdict = Verdict::new(outcome, Evidence { reason, ..verdict.evidence().clone() });
    }
}

/// What an enclosure shows of a part of a claim.
enum Shown {
    /// It holds, for the reason given.
    Holds(String),
    /// It does not, and where that can be seen.
    Fails(Witness, String),
    /// It does not tell.
    Nothing(String),
}

/// A group, compiled with the assumptions.
pub(super) struct Ready<'a> {
    group: &'a Group,
    /// The differences of the assumptions, then, for each sign and comparison, that of its sides; for a claim that something
    /// is defined, the left side.
    roots: Selection,
    /// For each of the above: the places of left side, right side, size of the terms.
    sides: Vec<usize>,
    /// The places of the differences of the equations among the assumptions, and of the size of their terms.
    given: Vec<(usize, usize)>,
    /// The kinds of the assumptions that select times.
    assumptions: Vec<RelationKind>,
    signs: usize,
    /// Where the rate of the only difference stands.
    slope: Option<usize>,
    scale: f64,
    /// The median size that the sides have for certain; 0 where they may vanish.
    known: f64,
    precision: f64,
}

/// Whether a relation between the sides holds for all, or for no, value of their difference.
fn certain(kind: RelationKind, difference: Interval) -> Option<bool> {
    let (lo, hi) = (difference.lo(), difference.hi());
    let apart = lo > 0.0 || hi < 0.0;
    let decide = |yes: bool, no: bool| if yes { Some(true) } else { no.then_some(false) };
    match kind {
        RelationKind::Equal => decide(lo == 0.0 && hi == 0.0, apart),
        RelationKind::NotEqual => decide(apart, lo == 0.0 && hi == 0.0),
        RelationKind::Less => decide(hi < 0.0, lo >= 0.0),
        RelationKind::LessEqual => decide(hi <= 0.0, lo > 0.0),
        RelationKind::Greater => decide(lo > 0.0, hi <= 0.0),
        RelationKind::GreaterEqual => decide(lo >= 0.0, hi < 0.0),
    }
}

/// The median of what is not negative; 1 where there is nothing.
fn median(mut sizes: Vec<f64>) -> f64 {
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().filter(|x| *x > 0.0).unwrap_or(0.0)
}

/// Most points at which sizes are taken.
const POINTS: usize = 40;

/// All sides at the middle of steps that are spread over the span.
fn at_middles(along: &mut Along) -> Vec<Rc<Vec<Result<Interval, NoValue>>>> {
    let every = along.pieces().len().div_ceil(POINTS).max(1);
    let times: Vec<Interval> = along.pieces().iter().copied().step_by(every).collect();
    times.into_iter().map(|time| along.at_middle(time)).collect()
}

impl<'a> Ready<'a> {
    fn new(
        program: &'a Program,
        (how, group): (&Use, &'a Group),
        along: &mut Along,
        claim: &Claim,
    ) -> Result<Ready<'a>, String> {
        let precision = claim.precision;
        let defined = matches!(how, Use::Defined);
        let signs = if group.branching { 2 } else { 1 };
        let sign = claim.scope.branch_sign();
        let (plus, minus) = (along.graph.integer(1), along.graph.integer(-1));
        let (mut roots, mut sides): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        let mut last = None;
        let (mut assumptions, mut given) = (Vec::new(), Vec::new());
        for assumption in &program.assumptions {
            if assumption.group.branching {
                return Err("an assumption with ± is not enclosed".to_owned());
            }
            for c in &assumption.group.comparisons {
                let difference = along.graph.sub(c.left, c.right);
                if assumption.throughout {
                    given.push((along.difference(difference)?, along.side(c.magnitude)?));
                    continue;
                }
                roots.push(along.difference(difference)?);
                for e in [c.left, c.right, c.magnitude] {
                    sides.push(along.side(e)?);
                }
                assumptions.push(c.kind);
            }
        }
        for s in 0..signs {
            let with = if s == 0 { plus } else { minus };
            for c in &group.comparisons {
                let graph = &mut along.graph;
                let [left, right, size] =
                    [c.left, c.right, c.magnitude].map(|e| graph.substitute(e, |_, l| (l == sign).then_some(with)));
                let value = defined && c.kind == RelationKind::Equal;
                let root = if value { left } else { graph.sub(left, right) };
                roots.push(along.difference(root)?);
                last = Some(root);
                for e in [left, right, size] {
                    sides.push(along.side(e)?);
                }
            }
        }
        let mut slope = None;
        if let (Use::Eventually(_), [_], Some(difference)) = (how, group.comparisons.as_slice(), last)
            && let Ok(rate) = along.enclosure.rate(&mut along.graph, difference)
            && let Ok(place) = along.difference(rate)
        {
            slope = Some(roots.len());
            roots.push(place);
        }
        let roots = Selection::new(roots);
        Ok(Ready { group, roots, sides, given, assumptions, signs, slope, scale: 1.0, known: 0.0, precision })
    }

    /// The median size of the terms, at the middle of steps.
    fn weigh(&mut self, along: &mut Along) {
        let points = at_middles(along);
        let of = |at: usize, k: usize, measure: fn(&Interval) -> f64| {
            let place = self.sides[3 * at + k];
            median(points.iter().filter_map(|p| p.get(place)?.as_ref().ok().map(measure)).collect())
        };
        let places = || self.assumptions.len()..self.sides.len() / 3;
        // A lower bound: what may be 0 has no size.
        let typical = places().map(|at| of(at, 2, Interval::lo)).fold(0.0, f64::max);
        let size = Interval::mignitude;
        self.known = places().map(|at| of(at, 0, size).max(of(at, 1, size))).fold(0.0, f64::max);
        self.scale = if typical > 0.0 { typical } else { 1.0 };
    }

    /// Where the difference of a comparison stands.
    fn place(&self, sign: usize, comparison: usize) -> usize {
        self.assumptions.len() + sign * self.group.comparisons.len() + comparison
    }

    /// Whether the assumptions that select times hold on a stretch: for certain, for certain not, or unknown.
    fn selected(&self, ranges: &Ranges) -> Option<bool> {
        let mut all = Some(true);
        for (i, &kind) in self.assumptions.iter().enumerate() {
            match &ranges[i] {
                Err(NoValue::OutOfDomain) => return Some(false),
                Err(_) => all = None,
                Ok(reach) => match certain(kind, reach.range()) {
                    Some(false) => return Some(false),
                    Some(true) => {}
                    None => all = None,
                },
            }
        }
        all
    }

    /// Whether the equations among the assumptions hold to the precision that is asked for, everywhere.
    fn presupposed(&self, along: &mut Along) -> Result<(), String> {
        if self.given.is_empty() {
            return Ok(());
        }
        along.presuppose((self.given.clone(), self.precision.to_bits()), |along| {
            let differences = Selection::new(self.given.iter().map(|g| g.0).collect());
            let points = at_middles(along);
            let most = |&(_, place): &(usize, usize)| {
                let sizes = points.iter().filter_map(|p| p.get(place)?.as_ref().ok().map(Interval::lo));
                let typical = median(sizes.collect());
                self.precision * if typical > 0.0 { typical } else { 1.0 }
            };
            let most: Vec<f64> = self.given.iter().map(most).collect();
            let judge = |_: Interval, ranges: &Ranges| {
                for (range, &most) in ranges.iter().zip(&most) {
                    match range {
                        Ok(r) if r.range().magnitude() <= most => {}
                        Ok(r) => {
                            let known = r.range().magnitude();
                            return Judgement::Open(format!("an assumption is only known within {known:.1e}"));
                        }
                        Err(reason) => return Judgement::Open(format!("an assumption has no value: {reason}")),
                    }
                }
                Judgement::Settled
            };
            let too_wide = |(range, &most): (&Result<Reach, NoValue>, &f64)| {
                matches!(range, Ok(r) if r.range().magnitude() > most)
            };
            along.cover(&differences, judge, |ranges| ranges.iter().zip(&most).any(too_wide)).map(|_| ())
        })
    }

    /// Whether all comparisons hold on a stretch with a sign of ±, and how far the sides of equations may be apart.
    fn holds(&self, ranges: &Ranges, sign: usize) -> Result<f64, String> {
        let room = self.precision * self.scale;
        // Where huge terms cancel, a bound that is small against them may be larger than the sides: that says nothing.
        let telling = if self.known > 0.0 { TELLING * self.known } else { f64::INFINITY };
        let mut largest = 0.0_f64;
        for (c, comparison) in self.group.comparisons.iter().enumerate() {
            let range = match &ranges[self.place(sign, c)] {
                Ok(reach) => reach.range(),
                Err(reason) => return Err(format!("`{}` has no value: {reason}", comparison.label)),
            };
            let fine = match comparison.kind {
                RelationKind::Equal => range.magnitude() <= room.min(telling),
                RelationKind::LessEqual => range.hi() <= room,
                RelationKind::GreaterEqual => range.lo() >= -room,
                kind => certain(kind, range) == Some(true),
            };
            if !fine {
                let (lo, hi) = (range.lo(), range.hi());
                return Err(format!("the sides of `{}` differ by something in [{lo:.2e}, {hi:.2e}]", comparison.label));
            }
            if comparison.kind == RelationKind::Equal {
                largest = largest.max(range.magnitude());
            }
        }
        Ok(largest)
    }

    /// Whether the bound of an equation is too wide, and does not refute it either: asked at a single time.
    fn hopeless(&self, ranges: &Ranges, sign: usize) -> bool {
        let telling = if self.known > 0.0 { TELLING * self.known } else { f64::INFINITY };
        let most = (self.precision * self.scale).min(telling);
        self.group.comparisons.iter().enumerate().any(|(c, comparison)| match &ranges[self.place(sign, c)] {
            Ok(reach) if comparison.kind == RelationKind::Equal => {
                let there = reach.range();
                there.contains(0.0) && there.magnitude() > most
            }
            _ => false,
        })
    }

    /// The comparison that does not hold anywhere on a stretch, with a sign of ±.
    fn violated(&self, ranges: &Ranges, sign: usize) -> Option<usize> {
        (0..self.group.comparisons.len()).find(|&c| match &ranges[self.place(sign, c)] {
            Ok(reach) => certain(self.group.comparisons[c].kind, reach.range()) == Some(false),
            Err(_) => false,
        })
    }

    fn nowhere_defined(&self, ranges: &Ranges, sign: usize) -> bool {
        let place = |c: usize| self.place(sign, c);
        (0..self.group.comparisons.len()).any(|c| matches!(ranges[place(c)], Err(NoValue::OutOfDomain)))
    }

    /// Both sides at a time.
    fn sides_at(&self, along: &Along, t: f64, place: usize) -> Option<(Interval, Interval)> {
        match along.sides_at(&self.sides[3 * place..3 * place + 2], t)[..] {
            [Ok(left), Ok(right)] => Some((left, right)),
            _ => None,
        }
    }

    /// A point at which every sign of ± fails, assumptions being met.
    fn witness(&self, along: &mut Along, t: f64, values: Vec<(String, f64)>) -> Option<Witness> {
        let time = Interval::point(t);
        let ranges = along.over(&self.roots, time);
        if self.selected(&ranges) != Some(true) {
            return None;
        }
        let mut worst = None;
        for s in 0..self.signs {
            let c = self.violated(&ranges, s)?;
            worst.get_or_insert((s, c));
        }
        let (s, c) = worst?;
        let difference = ranges[self.place(s, c)].as_ref().ok()?.range();
        let (left, right) = self.sides_at(along, t, self.place(s, c))?;
        let formula = self.group.comparisons[c].label.clone();
        Some(Witness { t, formula, left: left.mid(), right: right.mid(), bound: difference.width(), values })
    }
}

/// The parts of a claim, each ready to be looked at along a motion; or why there is nothing to look at.
pub(super) type Parts<'a> = Result<Vec<Result<Ready<'a>, String>>, String>;

/// Tells a motion what a claim will ask for.
pub(super) fn prepare<'a>(claim: &Claim, program: &'a Program, along: &mut Along, outcome: Outcome) -> Parts<'a> {
    if claim.forms.iter().any(|f| matches!(f, Form::SameMotion { .. } | Form::Independent { .. })) {
        return Err("claims of this form are not enclosed".to_owned());
    }
    if program.at.is_some() {
        return Err("claims at events are not enclosed".to_owned());
    }
    let fails = matches!(outcome, Outcome::Fails(_));
    if let (false, Some(reason)) = (fails, along.incomplete()) {
        return Err(reason);
    }
    Ok(program.groups.iter().map(|(how, group)| Ready::new(program, (how, group), along, claim)).collect())
}

/// Strengthens one verdict.
///
/// # Errors
/// A contradiction between an enclosure and samples.
pub(super) fn strengthen(
    claim: &Claim,
    program: &Program,
    parts: Parts,
    along: &mut Along,
    sampled: Sampled,
    verdict: &mut Verdict,
) -> Result<(), String> {
    let outcome = verdict.outcome();
    if matches!(outcome, Outcome::NotApplicable | Outcome::Holds(Strength::Enclosed | Strength::Proved)) {
        return Ok(());
    }
    let parts = match parts {
        Ok(parts) => parts,
        Err(reason) => {
            remark(verdict, &reason);
            return Ok(());
        }
    };
    if let Outcome::Fails(_) = outcome {
        certify(program, parts, along, verdict);
        return Ok(());
    }
    along.refill();
    let mut reasons = Vec::new();
    for ((how, group), ready) in program.groups.iter().zip(parts) {
        let shown = match ready {
            Ok(mut ready) => {
                ready.weigh(along);
                part(claim, how, &ready, along)?
            }
            Err(reason) => Shown::Nothing(reason),
        };
        match shown {
            Shown::Holds(reason) => reasons.push(reason),
            Shown::Fails(witness, reason) => {
                let Witness { t, left, right, bound, .. } = witness;
                let same = group.comparisons.iter().find(|c| c.label == witness.formula).filter(|_| !group.branching);
                if let Some(seen) = same.and_then(|c| sampled(c, t)) {
                    // Between samples anything may happen; at one time both routes must find the same.
                    let (gap, size) = ((seen.value - (left - right)).abs(), left.abs() + right.abs());
                    if gap > DISAGREEMENT * (seen.error + bound + f64::EPSILON * size) {
                        return Err(format!(
                            "at t = {t} the sides differ by {} ± {:.1e} on the sampled motion, and by {} ± {bound:.1e} on \
                             the enclosed one",
                            seen.value,
                            seen.error,
                            left - right
                        ));
                    }
                }
                let evidence = Evidence { witness: Some(witness), reason: Some(reason), ..verdict.evidence().clone() };
                *verdict = Verdict::new(Outcome::Fails(Strength::Enclosed), evidence);
                return Ok(());
            }
            Shown::Nothing(reason) => {
                remark(verdict, &reason);
                return Ok(());
            }
        }
    }
    if reasons.is_empty() {
        return Ok(());
    }
    reasons.dedup();
    let samples = verdict.evidence().samples.max(1);
    let evidence = Evidence { samples, reason: Some(reasons.join("; ")), ..verdict.evidence().clone() };
    *verdict = Verdict::new(Outcome::Holds(Strength::Enclosed), evidence);
    Ok(())
}

/// Looks for a time at which a claim that fails on samples fails for certain.
fn certify(program: &Program, parts: Vec<Result<Ready, String>>, along: &mut Along, verdict: &mut Verdict) {
    let Some(sampled) = verdict.evidence().witness.clone() else { return };
    along.refill();
    let mut why = "no part of it is refuted at the witness".to_owned();
    for ((how, _), ready) in program.groups.iter().zip(parts) {
        if !matches!(how, Use::Always | Use::Never(_)) {
            continue;
        }
        let found = ready.and_then(|ready| {
            ready.presupposed(along)?;
            match how {
                Use::Never(_) => occurs(&ready, along, &sampled),
                _ => ready
                    .witness(along, sampled.t, sampled.values.clone())
                    .ok_or_else(|| format!("at t = {} the enclosure does not exclude it", sampled.t)),
            }
        });
        match found {
            Ok(witness) => {
                let reason = format!("certified at t = {}: the enclosures of the two sides exclude it", witness.t);
                let evidence = Evidence { witness: Some(witness), reason: Some(reason), ..verdict.evidence().clone() };
                *verdict = Verdict::new(Outcome::Fails(Strength::Enclosed), evidence);
                return;
            }
            Err(reason) => why = reason,
        }
    }
    remark(verdict, &why);
}

/// That something which never happens does happen, near the time of a witness.
fn occurs(ready: &Ready, along: &mut Along, sampled: &Witness) -> Result<Witness, String> {
    let [comparison] = ready.group.comparisons.as_slice() else {
        return Err("several relations at once are not refuted".to_owned());
    };
    if ready.signs > 1 {
        return Err("relations with ± are not refuted".to_owned());
    }
    let here = along.over(&ready.roots, Interval::point(sampled.t));
    let place = ready.place(0, 0);
    let certainly = |r: &Ranges| match &r[place] {
        Ok(reach) => certain(comparison.kind, reach.range()) == Some(true) && ready.selected(r) == Some(true),
        Err(_) => false,
    };
    if certainly(&here) {
        return Ok(sampled.clone());
    }
    if comparison.kind != RelationKind::Equal {
        return Err("that it holds at the witness is not certain".to_owned());
    }
    let (from, to) = along.span;
    for part in [1e-9, 1e-7, 1e-5, 1e-3] {
        let (a, b) = ((sampled.t - part * (to - from)).max(from), (sampled.t + part * (to - from)).min(to));
        let Ok(time) = Interval::new(a, b) else { continue };
        let ranges = along.over(&ready.roots, time);
        if ready.selected(&ranges) == Some(true)
            && let Ok(reach) = &ranges[place]
            && changes_sign(reach, time)
        {
            return Ok(sampled.clone());
        }
    }
    Err("no change of sign was shown near the witness".to_owned())
}

/// Whether a quantity, continuous on a stretch, has opposite signs at its ends: then it vanishes between them.
fn changes_sign(reach: &Reach, time: Interval) -> bool {
    let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
    (a.hi() < 0.0 && b.lo() > 0.0) || (a.lo() > 0.0 && b.hi() < 0.0)
}

/// One part of a claim, over the whole span.
fn part(claim: &Claim, how: &Use, ready: &Ready, along: &mut Along) -> Result<Shown, String> {
    if let Err(reason) = ready.presupposed(along) {
        return Ok(Shown::Nothing(reason));
    }
    match how {
        Use::Always => always(claim, ready, along),
        Use::Defined => Ok(defined(ready, along)),
        Use::Never(_) => Ok(never(ready, along)),
        Use::Eventually(_) => Ok(eventually(ready, along)),
        Use::Limit(_) => Ok(Shown::Nothing("limits are not enclosed".to_owned())),
    }
}

fn always(claim: &Claim, ready: &Ready, along: &mut Along) -> Result<Shown, String> {
    let (mut largest, mut counted) = (0.0_f64, 0);
    let mut serves = vec![true; ready.signs];
    let mut apart: Option<(f64, usize)> = None;
    let judge = |time: Interval, ranges: &Ranges| {
        let selected = ready.selected(ranges);
        if selected == Some(false) || (0..ready.signs).all(|s| ready.nowhere_defined(ranges, s)) {
            return Judgement::Settled;
        }
        // A sign that serves nowhere on the stretch, while the assumptions hold on all of it.
        let excluded = |s: usize| selected == Some(true) && ready.violated(ranges, s).is_some();
        if (0..ready.signs).all(excluded) {
            let size = |s: usize| {
                let reach = ready.violated(ranges, s).and_then(|c| ranges[ready.place(s, c)].as_ref().ok());
                reach.map_or(0.0, |r| r.range().mignitude())
            };
            let least = (0..ready.signs).map(size).fold(f64::INFINITY, f64::min);
            apart = Some((time.mid(), usize::from(least > CLEARLY * ready.precision * ready.scale)));
            return Judgement::Stop(format!(
                "at t = {:.6} the sides differ for certain, by at least {least:.1e}, which samples do not see",
                time.mid()
            ));
        }
        let each: Vec<Result<f64, String>> = (0..ready.signs).map(|s| ready.holds(ranges, s)).collect();
        let now: Vec<bool> = each.iter().map(Result::is_ok).collect();
        let best = each.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if !now.contains(&true) {
            return Judgement::Open(each.into_iter().find_map(Result::err).unwrap_or_default());
        }
        serves.iter_mut().zip(now).for_each(|(s, n)| *s &= n);
        largest = largest.max(best);
        counted += 1;
        Judgement::Settled
    };
    let hopeless =
        |ranges: &Ranges| ready.selected(ranges) == Some(true) && (0..ready.signs).all(|s| ready.hopeless(ranges, s));
    let found = along.cover(&ready.roots, judge, hopeless);
    match (found, apart) {
        (Err(_), Some((t, 1))) => Ok(match ready.witness(along, t, Vec::new()) {
            Some(witness) => Shown::Fails(witness, format!("certified at t = {t}")),
            None => Shown::Nothing(format!("near t = {t:.6} the sides differ")),
        }),
        (Err(reason), _) => Ok(Shown::Nothing(reason)),
        (Ok(_), _) if counted == 0 => Ok(Shown::Nothing("no stretch of time is left by the assumptions".to_owned())),
        (Ok(_), _) if claim.branches_throughout && !serves.contains(&true) => {
            Ok(Shown::Nothing("no single sign of ± is shown to serve".to_owned()))
        }
        (Ok(looked), _) => {
            let (from, to) = along.span;
            let equation = ready.group.comparisons.iter().any(|c| c.kind == RelationKind::Equal);
            let apart = if equation {
                format!(", the sides at most {largest:.1e} apart where terms are of the size {:.1e}", ready.scale)
            } else {
                String::new()
            };
            Ok(Shown::Holds(format!("for every t in [{from}, {to}], by {looked} stretches{apart}")))
        }
    }
}

fn defined(ready: &Ready, along: &mut Along) -> Shown {
    // The conditions among the comparisons say the same in other words.
    let judge = |_: Interval, ranges: &Ranges| {
        if ready.selected(ranges) == Some(false) {
            return Judgement::Settled;
        }
        for (c, comparison) in ready.group.comparisons.iter().enumerate() {
            if comparison.kind == RelationKind::Equal
                && let Err(reason) = &ranges[ready.place(0, c)]
            {
                return Judgement::Open(format!("`{}`: {reason}", comparison.label));
            }
        }
        Judgement::Settled
    };
    match along.cover(&ready.roots, judge, |_| false) {
        Ok(looked) => {
            let (from, to) = along.span;
            Shown::Holds(format!("for every t in [{from}, {to}], by {looked} stretches"))
        }
        Err(reason) => Shown::Nothing(reason),
    }
}

fn never(ready: &Ready, along: &mut Along) -> Shown {
    let judge = |_: Interval, ranges: &Ranges| {
        let gone = |s: usize| ready.violated(ranges, s).is_some() || ready.nowhere_defined(ranges, s);
        if ready.selected(ranges) == Some(false) || (0..ready.signs).all(gone) {
            return Judgement::Settled;
        }
        Judgement::Open("it cannot be excluded".to_owned())
    };
    match along.cover(&ready.roots, judge, |_| false) {
        Ok(looked) => {
            let (from, to) = along.span;
            Shown::Holds(format!("excluded for every t in [{from}, {to}], by {looked} stretches"))
        }
        Err(reason) => Shown::Nothing(reason),
    }
}

fn eventually(ready: &Ready, along: &mut Along) -> Shown {
    let [Comparison { kind, .. }] = ready.group.comparisons.as_slice() else {
        return Shown::Nothing("several relations at once are not enclosed".to_owned());
    };
    if ready.signs > 1 {
        return Shown::Nothing("relations with ± are not enclosed".to_owned());
    }
    let place = ready.place(0, 0);
    if *kind != RelationKind::Equal {
        for time in along.pieces().to_vec() {
            for t in [time.lo(), time.mid(), time.hi()] {
                let ranges = along.over(&ready.roots, Interval::point(t));
                if let Ok(reach) = &ranges[place]
                    && certain(*kind, reach.range()) == Some(true)
                    && ready.selected(&ranges) == Some(true)
                {
                    return Shown::Holds(format!("certain at t = {t}"));
                }
            }
        }
        return Shown::Nothing("at no time that was looked at is it certain".to_owned());
    }
    // Stretches without a zero, and stretches on which the difference is monotone and changes its sign: one zero each.
    let mut zeros: Vec<Interval> = Vec::new();
    let mut unselected = false;
    let judge = |time: Interval, ranges: &Ranges| {
        let Ok(reach) = &ranges[place] else { return Judgement::Open("it has no value".to_owned()) };
        let selected = ready.selected(ranges);
        if selected == Some(false) || certain(RelationKind::Equal, reach.range()) == Some(false) {
            return Judgement::Settled;
        }
        let slope = ready.slope.and_then(|at| ranges[at].as_ref().ok()).map(Reach::range);
        if slope.is_some_and(|s| !s.contains(0.0)) {
            let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
            if !a.contains(0.0) && !b.contains(0.0) {
                if changes_sign(reach, time) {
                    unselected |= selected != Some(true);
                    zeros.push(time);
                }
                return Judgement::Settled;
            }
        }
        Judgement::Open("whether it happens cannot be told".to_owned())
    };
    let found = along.cover(&ready.roots, judge, |_| false);
    let listed = || {
        let shown: Vec<String> = zeros.iter().take(4).map(|z| format!("[{:.6}, {:.6}]", z.lo(), z.hi())).collect();
        shown.join(", ")
    };
    match (&found, zeros.is_empty()) {
        (_, false) if unselected => Shown::Nothing("whether the assumptions hold there is not certain".to_owned()),
        (Ok(_), false) => Shown::Holds(format!("happens {} times, once in each of {}", zeros.len(), listed())),
        (Err(_), false) => Shown::Holds(format!("happens, in {}", listed())),
        (Ok(_), true) => {
            let t = along.span.0;
            let ranges = along.over(&ready.roots, Interval::point(t));
            match (&ranges[place], ready.sides_at(along, t, place)) {
                (Ok(reach), Some((left, right))) => {
                    let formula = ready.group.comparisons[0].label.clone();
                    let (left, right, bound) = (left.mid(), right.mid(), reach.range().width());
                    let witness = Witness { t, formula, left, right, bound, values: Vec::new() };
                    Shown::Fails(witness, "excluded at every time of the span".to_owned())
                }
                _ => Shown::Nothing("it does not happen, but there is no point to show".to_owned()),
            }
        }
        (Err(reason), true) => Shown::Nothing(reason.clone()),
    }
}
