//! Where the right sides of a system are not smooth: kinks, jumps, places where a slope is infinite, and ends of their domains.
//!
//! **In:** the tape of a field, and the series of its slots at the present time. **Out:** how far the next kink is within a step,
//! and whether the motion is not determined here. A series does not go on behind a kink, so that a step ends there; which places
//! are kinks is read from the table of domains.

use super::arguments::{Moves, moves};
use super::polynomial::{horner, shift};
use super::taylor::Flow;
use expr::domain::{Change, Place, Sign, Term, row};
use expr::tape::Slots;
use number::{Growth, Jet};

/// The series of all slots of one motion, at the time that was looked at last.
pub(super) trait Series {
    /// Coefficient `k` of the series in a slot, which has a value.
    fn coefficient(&self, slot: usize, k: usize) -> f64;
}

impl Series for Slots<Jet<f64>> {
    fn coefficient(&self, slot: usize, k: usize) -> f64 {
        self.value(slot).coefficient(k)
    }
}

/// One of several motions whose series are grown together.
pub(super) struct Lane<'s, const N: usize> {
    /// The series of all of them.
    pub(super) growth: &'s Growth<N>,
    /// Which one.
    pub(super) lane: usize,
}

impl<const N: usize> Series for Lane<'_, N> {
    fn coefficient(&self, slot: usize, k: usize) -> f64 {
        self.growth.coefficient(slot, k).0[self.lane]
    }
}

/// What of the right sides is not smooth, by the table of domains. Where the argument of a kink, as |·| has one, changes its
/// sign, no series goes on, and a step ends there. Where a right side is steep or jumps, the motion is not determined.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Edges {
    /// The slots of what vanishes at kinks and jumps.
    pub(super) slots: Vec<usize>,
    /// For each of these, what is positive where there is no jump; nothing for a kink.
    jumps: Vec<Option<usize>>,
    /// What vanishes where a right side is steep in a state: a term of the value in a slot.
    steep: Vec<(Term, usize)>,
    /// What must keep its sign for right sides to have values.
    needs: Vec<Need>,
}

/// A term of the values in two slots that must keep its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Need {
    term: Term,
    sign: Sign,
    slots: [usize; 2],
    /// The first state whose rate has no value without it.
    rate: usize,
}

/// An end of the domain of a right side within a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// How far away.
    pub(super) at: f64,
    /// The state whose rate has no value there.
    pub(super) rate: usize,
    /// Whether there is none at the end itself, and not only beyond it.
    pub(super) is_hole: bool,
}

/// The kinks and ends that one motion may meet: the series of their arguments around the present time.
#[derive(Clone, Debug, Default)]
pub(super) struct Kinks {
    /// `order + 1` coefficients for each argument.
    pub(super) series: Vec<f64>,
    /// The same for what is positive where there is no jump, one after the other.
    whilst: Vec<f64>,
    /// The same for what must keep its sign.
    needs: Vec<f64>,
    /// The same for the exponents of powers that may be of 0, one after the other.
    exponents: Vec<f64>,
    /// How many were crossed.
    pub(super) crossed: usize,
}

/// Parts of a step that are looked at for a change of the sign of one argument.
const MOST_PARTS: usize = 1000;
/// The shortest of them, as a share of the step.
const SHORTEST: f64 = 1e-13;
/// What is below this share of the terms of a polynomial may be their rounding.
const NOISE: f64 = 1e-13;

impl Edges {
    pub(super) fn of(flow: &Flow) -> Edges {
        let (moving, varying) = (flow.moving(false), flow.moving(true));
        let mut out = Edges::default();
        // For every slot, the first state whose rate depends on it.
        let mut rates = vec![usize::MAX; flow.tape.slot_count()];
        (0..flow.dimension).rev().for_each(|i| rates[flow.tape.output_slot(i)] = i);
        for step in flow.tape.instructions().iter().rev() {
            let rate = rates[step.out as usize];
            [step.a, step.b].into_iter().for_each(|slot| rates[slot as usize] = rates[slot as usize].min(rate));
        }
        for step in flow.tape.instructions() {
            let (a, b) = (step.a as usize, step.b as usize);
            let rate = rates[step.out as usize];
            for (term, sign) in row(step.op).needs {
                let slots = match term {
                    Term::First | Term::Unit | Term::Cosine => [a; 2],
                    Term::Second => [b; 2],
                    Term::Squares | Term::Support => [a, b],
                    // Nothing asks for the sign of these.
                    Term::Opposite | Term::Sine | Term::Excess | Term::Product => continue,
                };
                if slots.into_iter().any(|slot| varying[slot]) && rate < flow.dimension {
                    out.needs.push(Need { term, sign, slots, rate });
                }
            }
            for edge in row(step.op).edges {
                match (edge.change, edge.place) {
                    (Change::Kink, Place::Zero(Term::First)) => {
                        out.slots.push(a);
                        out.jumps.push(None);
                    }
                    (Change::Jump(_), Place::ZeroWhile(Term::First, Term::Opposite)) if varying[a] || varying[b] => {
                        out.slots.push(a);
                        out.jumps.push(Some(b));
                    }
                    // In the time alone it does no harm.
                    (Change::Steep, Place::Zero(Term::Second)) if moving[b] => out.steep.push((Term::First, b)),
                    (Change::Steep, Place::Zero(term)) if moving[a] => out.steep.push((term, a)),
                    // Other edges are where there is no value, which ends the motion anyway.
                    (Change::Kink | Change::Jump(_) | Change::Steep | Change::Pole(..) | Change::Log, _) => {}
                }
            }
        }
        out
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.slots.is_empty() && self.steep.is_empty()
    }

    /// Whether a right side is steep or jumps at the present state: exactly at an edge.
    pub(super) fn is_met(&self, now: &impl Series) -> bool {
        let mut jumps = self.slots.iter().zip(&self.jumps).filter_map(|(&slot, jump)| Some((slot, (*jump)?)));
        jumps.any(|(slot, whilst)| now.coefficient(slot, 0) == 0.0 && now.coefficient(whilst, 0) < 0.0)
            || self.steep.iter().any(|&(term, slot)| term.vanishes(now.coefficient(slot, 0)))
    }

    /// Whether an edge at which a right side is steep is nearer than a moment.
    pub(super) fn is_near_steep(&self, now: &impl Series, moment: f64) -> bool {
        self.steep.iter().any(|&(term, slot)| {
            let (x, speed) = (now.coefficient(slot, 0), now.coefficient(slot, 1).abs());
            let off = match term {
                Term::Unit => (1.0 - x.abs()).abs(),
                _ => x.abs(),
            };
            off <= moment * speed
        })
    }

    /// Whether a right side jumps at a change that [`Kinks::first`] found, of an argument by its position.
    pub(super) fn jumps(&self, argument: usize) -> bool {
        self.jumps[argument].is_some()
    }
}

impl Kinks {
    /// Keeps the series of the arguments around the present time, up to an order.
    pub(super) fn keep(&mut self, flow: &Flow, now: &impl Series, order: usize) {
        let keep = |out: &mut Vec<f64>, slot: usize| {
            // Of what is not a state, the last coefficient is not grown; beside a walker of higher order it may be there.
            let known = if slot <= flow.dimension { order } else { order - 1 };
            let coefficient = |k: usize| if k <= known { now.coefficient(slot, k) } else { 0.0 };
            out.extend((0..=order).map(coefficient));
        };
        self.series.clear();
        self.whilst.clear();
        self.needs.clear();
        self.exponents.clear();
        flow.edges.slots.iter().for_each(|&slot| keep(&mut self.series, slot));
        flow.edges.jumps.iter().flatten().for_each(|&slot| keep(&mut self.whilst, slot));
        for need in &flow.edges.needs {
            let [a, b] = need.slots;
            keep(&mut self.needs, a);
            if need.term == Term::Support {
                keep(&mut self.exponents, b);
            }
            if need.term == Term::Squares {
                let begun = self.needs.len() - (order + 1);
                keep(&mut self.needs, b);
                squares(&mut self.needs[begun..], order);
                self.needs.truncate(begun + order + 1);
            }
        }
    }

    /// The first end of the domain of a right side within `size` in the direction. A series may go on smoothly where what it is of has no
    /// value: behind a root of high order, or with a small factor.
    pub(super) fn end(&self, edges: &Edges, order: usize, size: f64, direction: f64) -> Option<End> {
        if edges.needs.is_empty() {
            return None;
        }
        let mut ends = Vec::new();
        let mut turned = Vec::with_capacity(order + 1);
        let mut exponents = self.exponents.chunks(order + 1);
        for (&Need { term, sign, rate, .. }, c) in edges.needs.iter().zip(self.needs.chunks(order + 1)) {
            // Where offset + factor · value comes to 0.
            let pi = std::f64::consts::PI;
            let turn = (c[0] / pi).round();
            let sides = match (term, sign) {
                (Term::Unit, _) => [(1.0, 1.0), (1.0, -1.0)],
                (Term::Cosine, _) => [((0.5 - turn) * pi, 1.0), ((0.5 + turn) * pi, -1.0)],
                (_, Sign::NotZero) if c[0] < 0.0 => [(0.0, -1.0); 2],
                _ => [(0.0, 1.0); 2],
            };
            let exponent = if term == Term::Support { exponents.next() } else { None };
            let (first, rest) = (c[0], variation(c, size));
            // What may be 0 and only touches it has values on both sides; what may not is a hole there.
            let is_hole = sign != Sign::NotNegative;
            for (n, (offset, factor)) in sides.into_iter().enumerate() {
                let noise = NOISE * (offset.abs() + first.abs() + rest);
                if n == 1 && sides[0] == sides[1] || offset + factor * first > rest + noise {
                    continue;
                }
                turned.clear();
                turned.extend(c.iter().map(|c| -factor * c));
                turned[0] -= if is_hole { offset - noise } else { offset + noise };
                let at = if turned[0] < 0.0 { first_change(&turned, size, direction) } else { is_hole.then_some(0.0) };
                // Where the exponent is positive, a power of 0 has a value.
                let is_met = |at: f64| exponent.is_some_and(|b| horner(b, direction * at) > 0.0);
                ends.extend(at.filter(|&at| !is_met(at)).map(|at| End { at, rate, is_hole }));
            }
        }
        ends.into_iter().min_by(|a, b| a.at.total_cmp(&b.at))
    }

    /// Whether the argument of a kink or jump may vanish within a step: then the series over all its times has no sign to go by.
    pub(super) fn are_near(&self, edges: &Edges, order: usize, h: f64) -> bool {
        let mut whilst = self.whilst.chunks(order + 1);
        self.series.chunks(order + 1).zip(&edges.jumps).any(|(c, jump)| {
            let passes = jump.and_then(|_| whilst.next()).is_some_and(|b| b[0] > variation(b, h.abs()));
            !passes && c[0].abs() <= variation(c, h.abs())
        })
    }

    /// How far the first change of a sign is at which there is a kink or a jump, within `size` in the direction; with the argument that
    /// changes.
    pub(super) fn first(&self, edges: &Edges, order: usize, size: f64, direction: f64) -> Option<(f64, usize)> {
        let mut whilst = self.whilst.chunks(order + 1);
        let changes = |(argument, c): (usize, &[f64])| {
            let Some(whilst) = edges.jumps[argument].and_then(|_| whilst.next()) else {
                return Some((first_change(c, size, direction)?, argument));
            };
            let (mut at, mut local) = (0.0, c.to_vec());
            // Where the other argument is positive, the angle passes 0, and not its cut.
            for _ in 0..MOST_PARTS {
                at += first_change(&local, size - at, direction)?;
                if horner(whilst, direction * at) <= 0.0 {
                    return Some((at, argument));
                }
                shift(c, direction * at, 1.0, &mut local);
            }
            Some((at, argument))
        };
        // An argument without a change is a constant as far as this step goes.
        self.series.chunks(order + 1).enumerate().filter_map(changes).min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// How far a polynomial may be from its value at 0 within `size`.
fn variation(c: &[f64], size: f64) -> f64 {
    c[1..].iter().rev().fold(0.0, |sum, x| (sum + x.abs()) * size)
}

/// Puts the sum of the squares of two polynomials in the place of the first.
fn squares(both: &mut [f64], order: usize) {
    let (a, b) = both.split_at_mut(order + 1);
    for k in (0..=order).rev() {
        a[k] = (0..=k).map(|i| a[i] * a[k - i] + b[i] * b[k - i]).sum();
    }
}

/// Where a polynomial first has another sign than at 0, within `size` in the direction. The step is halved until the polynomial has no
/// zero on a part, or is monotone there: two changes that lie close together are not passed over.
fn first_change(c: &[f64], size: f64, direction: f64) -> Option<f64> {
    let now = c[0] > 0.0;
    let changed = |x: f64| (horner(c, direction * x) > 0.0) != now;
    let mut local = Vec::with_capacity(c.len());
    let mut stack = vec![(0.0, size)];
    let mut parts = 0;
    while let Some((low, high)) = stack.pop() {
        parts += 1;
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        shift(c, direction * middle, half, &mut local);
        let Moves { value, by, .. } = moves(local.iter().copied(), 1.0, 0.0);
        let constant = value.abs() > by || by == 0.0;
        if constant && (value > 0.0) == now {
            continue;
        }
        let bends: f64 = local.iter().enumerate().skip(2).map(|(k, c)| k as f64 * c.abs()).sum();
        let monotone = local.get(1).is_some_and(|slope| slope.abs() > bends);
        if constant || monotone || half <= SHORTEST * size || parts > MOST_PARTS {
            if !changed(high) {
                continue;
            }
            let (mut low, mut high) = (low, high);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if changed(middle) { high = middle } else { low = middle }
            }
            return Some(high);
        }
        stack.extend([(middle, high), (low, middle)]);
    }
    None
}
