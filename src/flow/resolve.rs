//! Where a motion that is given by formulas is what its samples show.
//!
//! A formula of the time may do anything between two samples: have a pole, or a peak as narrow as numbers can tell. Here the
//! span is cut into stretches on each of which every state is a polynomial up to rounding. That is *shown*, not guessed from
//! coefficients at one time: by Taylor's theorem with Lagrange's remainder, the series of a formula over the interval of all
//! times of a stretch bounds what a polynomial leaves out. A peak far from the middle of a stretch shows in that interval,
//! and the stretch is cut until it is resolved, or until it is as short as time can be told.
//!
//! **In:** the formulas of a motion. **Out:** the cuts, and what could not be resolved.

use super::core::Core;
use super::cover::{Explorer, Piece, Stretch, tail};
use super::program::{Bench, Program};
use super::zeros::Incomplete;
use crate::number::{Bounded, Interval, NoValue, Scalar};

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
/// Up to this share of its size a state may change in a gap that is one time: it is continuous there.
const STEP: f64 = 1e-9;

/// The times that cut the span of a motion, and the stretches on which its formulas are not known from samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Resolution {
    pub(super) cuts: Vec<f64>,
    pub(super) gaps: Vec<Incomplete>,
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

    /// All values of every output over an interval of times.
    fn values(&mut self, time: Interval) -> Vec<Result<Interval, NoValue>> {
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
    let mut prober = (!program.needs_turns()).then(|| Prober {
        core,
        program,
        high: program.bench(core, DEGREE),
        low: program.bench(core, LOW),
        plain: program.bench(core, 0),
    });
    let mut explorer = Explorer::new(core, program, DEGREE);
    let mut sizes = vec![0.0_f64; program.output_count()];
    let stretches = explorer.cover(&times, |_, piece| {
        let fine = |(c, x): (&Vec<f64>, &Bounded)| {
            let size = x.value.abs().max(c.get(1).map_or(0.0, |c| c.abs() * piece.radius()));
            tail(c, DEGREE, piece.radius()) <= 1e-12 * size + 16.0 * x.error
        };
        let accepted =
            piece.outputs.iter().zip(&piece.values).all(fine) && prober.as_mut().is_none_or(|p| p.resolves(piece));
        if accepted {
            for (size, x) in sizes.iter_mut().zip(&piece.values) {
                *size = size.max(x.value.abs());
            }
        }
        accepted
    });
    let mut out = Resolution::default();
    for stretch in &stretches {
        let (start, end) = match *stretch {
            Stretch::Piece(ref p) => (p.start, p.end),
            Stretch::Gap { start, end, .. } => {
                out.gaps.extend(prober.as_mut().and_then(|p| gap(p, &sizes, (start, end), b - a)));
                (start, end)
            }
        };
        out.cuts.extend([start, end]);
    }
    out.cuts.sort_by(f64::total_cmp);
    out.cuts.dedup();
    out
}

/// What a gap in the cover is; `None` for a kink, across which all states are continuous.
fn gap(prober: &mut Prober, sizes: &[f64], (start, end): (f64, f64), length: f64) -> Option<Incomplete> {
    let values = prober.values(Interval::point(start).hull(Interval::point(end)));
    let instant = end - start <= INSTANT * length;
    let mut undefined = None;
    let mut steps = false;
    for (value, size) in values.into_iter().zip(sizes) {
        match value {
            Ok(all) => steps |= all.width() > STEP * size + FLOOR,
            // That there is no value at any of the times is certain; that there may be none says something of one time.
            Err(NoValue::OutOfDomain) => undefined = Some(NoValue::OutOfDomain),
            Err(reason) if instant => undefined = undefined.or(Some(reason)),
            Err(_) => steps = true,
        }
    }
    match undefined {
        Some(reason) => Some(Incomplete::NoValue { start, end, reason }),
        None if steps || !instant => Some(Incomplete::Unresolved { start, end }),
        None => None,
    }
}
