//! Where a motion that is given by formulas is what its samples show.
//!
//! A formula of the time may do anything between two samples: have a pole, or a peak as narrow as numbers can tell. Here the
//! span is cut into stretches on each of which every state is a polynomial up to rounding. That is *shown*, not guessed from
//! coefficients at one time: by Taylor's theorem with Lagrange's remainder, the series of a formula over the interval of all
//! times of a stretch bounds what a polynomial leaves out. A peak far from the middle of a stretch shows in that interval,
//! and the stretch is cut until it is resolved, or until it is as short as time can be told.
//!
//! **In:** the formulas of a motion. **Out:** the cuts, and what could not be resolved.

use std::cell::RefCell;

use super::core::Core;
use super::cover::{Explorer, Piece, Stretch};
use super::incomplete::Incomplete;
use super::polynomial::tail;
use super::program::{Bench, Program};
use number::{Bounded, Interval, NoValue, Scalar};

/// Degree of the polynomials.
const DEGREE: usize = 14;
/// A lower degree, for formulas whose high derivatives overflow where they do not matter.
const LOW: usize = 4;
/// Parts that the span is cut into at first.
const PARTS: usize = 16;
/// What a polynomial may leave out, relative to the size of the state.
const FINE: f64 = 1e-13;
/// States below this size are 0 for what may be left out.
const FLOOR: f64 = 1e-100;
/// A gap of up to this share of the span is one time.
const INSTANT: f64 = 1e-9;
/// Most cuts of a gap that is not one time.
const MOST_CUTS: usize = 200;
/// Up to this share of its size a state may change in a gap that is one time: it is continuous there.
const STEP: f64 = 1e-6;

/// The times that cut the span of a motion, and the stretches on which its formulas are not known from samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Resolution {
    pub(super) cuts: Vec<f64>,
    pub(super) gaps: Vec<Incomplete>,
    /// Times at which all states are continuous and one has a corner: there a rate has no value.
    pub(super) corners: Vec<f64>,
}

/// Series over intervals of time.
struct Prober<'a> {
    core: &'a Core,
    program: &'a Program,
    high: Bench<Interval>,
    low: Bench<Interval>,
    plain: Bench<Interval>,
}

impl Prober<'_> {
    /// Whether every output is a polynomial over a stretch.
    fn resolves(&mut self, piece: &Piece) -> bool {
        let time = Interval::point(piece.start).hull(Interval::point(piece.end));
        self.program.run_over(self.core, &mut self.high, time);
        let mut left: Vec<usize> = (0..piece.outputs.len()).collect();
        left.retain(|&i| !resolved(self.program, &self.high, piece, i));
        if left.is_empty() {
            return true;
        }
        self.program.run_over(self.core, &mut self.low, time);
        left.iter().all(|&i| resolved(self.program, &self.low, piece, i))
    }

    /// Whether some output certainly has no value at any time of a stretch.
    fn nowhere(&mut self, start: f64, end: f64) -> bool {
        self.values(start, end).contains(&Err(NoValue::OutOfDomain))
    }

    /// All values of every output over a stretch.
    fn values(&mut self, start: f64, end: f64) -> Vec<Result<Interval, NoValue>> {
        let time = Interval::point(start).hull(Interval::point(end));
        self.program.run_over(self.core, &mut self.plain, time);
        let output = |i: usize| self.program.output(&self.plain, i).and_then(|x| x.coefficient(0).checked());
        (0..self.program.output_count()).map(output).collect()
    }
}

/// Whether some term of the series over all times of the stretch is so small that nothing hides behind it.
fn resolved(program: &Program, bench: &Bench<Interval>, piece: &Piece, output: usize) -> bool {
    let Ok(series) = program.output(bench, output) else { return false };
    let (c, x) = (&piece.outputs[output], piece.values[output]);
    let radius = piece.radius();
    let size = x.value.abs() + c.get(1).map_or(0.0, |c| c.abs() * radius);
    let fine = FINE * size + 16.0 * x.error + FLOOR;
    if series.coefficient(0).checked().is_ok_and(|all| all.width() <= fine) {
        return true;
    }
    let mut power = 1.0;
    (1..=series.degree()).any(|k| {
        power *= radius;
        series.coefficient(k).checked().is_ok_and(|c| c.magnitude() * power <= fine)
    })
}

/// Cuts the span of a motion by formulas.
pub(super) fn resolve(core: &Core, program: &Program) -> Resolution {
    let (a, b) = core.span;
    let mut times: Vec<f64> = (0..=PARTS).map(|i| a + (b - a) * (i as f64 / PARTS as f64)).collect();
    times.push(core.initial_time);
    times[PARTS] = b;
    times.sort_by(f64::total_cmp);
    times.dedup();
    // The turns of an angle belong to single times.
    let prober = RefCell::new((!program.needs_turns()).then(|| Prober {
        core,
        program,
        high: program.bench(core, DEGREE),
        low: program.bench(core, LOW),
        plain: program.bench(core, 0),
    }));
    let mut explorer = Explorer::new(core, program, DEGREE);
    let mut sizes = vec![0.0_f64; program.output_count()];
    let mut one = |piece: &Piece| {
        let fine = |(c, x): (&Vec<f64>, &Bounded)| {
            let size = x.value.abs().max(c.get(1).map_or(0.0, |c| c.abs() * piece.radius()));
            tail(c, DEGREE, piece.radius()) <= 1e-12 * size + 16.0 * x.error
        };
        let accepted = piece.outputs.iter().zip(&piece.values).all(fine)
            && prober.borrow_mut().as_mut().is_none_or(|p| p.resolves(piece));
        if accepted {
            for (size, x) in sizes.iter_mut().zip(&piece.values) {
                *size = size.max(x.value.abs());
            }
        }
        accepted
    };
    let accept = |_: &mut Explorer, pieces: &[&Piece]| pieces.iter().map(|piece| one(piece)).collect();
    let stretches = explorer.cover_unless(&times, accept, |explorer, start, end| match prober.borrow_mut().as_mut() {
        Some(prober) => prober.nowhere(start, end),
        None => !explorer.somewhere(start, end),
    });
    let mut prober = prober.into_inner();
    let mut out = Resolution::default();
    for stretch in &stretches {
        let (start, end) = match *stretch {
            Stretch::Piece(ref p) => (p.start, p.end),
            Stretch::Gap { start, end, .. } => {
                if let Some(prober) = &mut prober {
                    gaps(prober, &sizes, (start, end), b - a, &mut out);
                }
                (start, end)
            }
        };
        out.cuts.extend([start, end]);
    }
    out.cuts.sort_by(f64::total_cmp);
    out.cuts.dedup();
    out
}

/// What the gaps in the cover are. A kink, across which all states are continuous, is none.
fn gaps(prober: &mut Prober, sizes: &[f64], (start, end): (f64, f64), length: f64, found: &mut Resolution) {
    let Resolution { gaps: out, corners, .. } = found;
    // Where values end lies in a gap with the times at which there are none: it is cut until the two are apart.
    let mut stack = vec![(start, end)];
    let mut budget = MOST_CUTS;
    while let Some((start, end)) = stack.pop() {
        let values = prober.values(start, end);
        let instant = end - start <= INSTANT * length;
        let nowhere = values.contains(&Err(NoValue::OutOfDomain));
        let unclear = values.iter().find_map(|x| x.err().filter(|_| !nowhere));
        let steps = values.iter().zip(sizes).any(|(x, size)| x.is_ok_and(|all| all.width() > STEP * size + FLOOR));
        let what = match unclear {
            _ if nowhere => Some(Incomplete::NoValue { start, end, reason: NoValue::OutOfDomain }),
            Some(reason) if instant => Some(Incomplete::NoValue { start, end, reason }),
            None if instant && !steps => {
                corners.push(start + 0.5 * (end - start));
                None
            }
            None if instant => Some(Incomplete::Unresolved { start, end }),
            _ if budget > 0 => {
                budget -= 1;
                let middle = start + 0.5 * (end - start);
                stack.extend([(middle, end), (start, middle)]);
                continue;
            }
            _ => Some(Incomplete::Unresolved { start, end }),
        };
        match (out.last_mut(), what) {
            (Some(Incomplete::Unresolved { end: last, .. }), Some(Incomplete::Unresolved { start, end }))
                if *last == start =>
            {
                *last = end;
            }
            (
                Some(Incomplete::NoValue { end: last, reason: before, .. }),
                Some(Incomplete::NoValue { start, end, reason }),
            ) if *last == start && *before == reason => *last = end,
            (_, what) => out.extend(what),
        }
    }
}
