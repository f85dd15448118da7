//! Angles that are continuous along a motion.
//!
//! The value of an angle by its definition jumps by 2π where the definition has a cut. Here the motion is covered by
//! stretches on which the Taylor polynomial of the angle converges, and by which alone it changes from one end to the other;
//! at every time the multiple of 2π is chosen that brings the defined value next to the polynomial. A rapid passage (Euler
//! angles near θ = 0) is a singularity near the real axis: there the polynomial does not converge, and the stretches become
//! as short as the passage.

use std::f64::consts::TAU;

use super::core::Core;
use super::cover::{BLOCK, Explorer, Piece, Stretch};
use super::polynomial::{horner, tail};
use super::program::{Bench, Program, Turns};
use expr::Leaf;
use number::{Lanes, NoValue};

/// Degree of the polynomials that an angle is followed with.
const DEGREE: usize = 10;

/// Memory of the definition of an angle, at one time and at several.
#[derive(Clone, Debug, Default)]
pub(super) struct AngleBench {
    one: Option<Bench<f64>>,
    several: Option<Bench<Lanes<BLOCK>>>,
}

/// Memory of the definitions of angles.
pub(super) type AngleBenches = Vec<AngleBench>;

/// An angle and how often it has gone round.
#[derive(Clone, Debug)]
pub(super) struct Angle {
    /// The basic leaf that stands for 2π times the number of turns.
    pub(super) turns: Leaf,
    /// The definition, without turns.
    pub(super) raw: Program,
    pieces: Vec<(Piece, f64)>,
    /// Times at which the angle has no value and a new branch starts.
    pub(super) breaks: Vec<f64>,
}

fn around(x: f64) -> f64 {
    (x / TAU).round()
}

impl Piece {
    fn angle(&self, t: f64) -> f64 {
        self.outputs.first().map_or(f64::NAN, |c| horner(c, t - self.centre))
    }
}

impl Angle {
    /// Follows the angle that `raw` defines along the whole motion.
    pub(super) fn follow(core: &Core, turns: Leaf, raw: Program) -> Angle {
        let mut explorer = Explorer::new(core, &raw, DEGREE);
        let follows = |explorer: &mut Explorer, piece: &Piece| {
            let Some(c) = piece.outputs.first() else { return false };
            // Convergence is judged by the decay of the terms, not by their size: far from a passage at distance d every
            // term is of the order of d, even where the series diverges.
            let radius = piece.radius();
            let head: f64 =
                c.iter().zip([0.0, radius, radius * radius, radius * radius * radius]).map(|(c, r)| c.abs() * r).sum();
            let rest = tail(c, DEGREE, radius);
            if rest > 0.01 || rest > 0.05 * head + 1e-12 {
                return false;
            }
            // At the ends the definition must agree, up to turns.
            [piece.start, piece.end].into_iter().all(|t| {
                explorer.plain(t).is_none_or(|x| {
                    let off = x - piece.angle(t);
                    (off - TAU * around(off)).abs() < 0.1
                })
            })
        };
        let stretches = explorer.cover(&core.boundaries(), |explorer, pieces| {
            pieces.iter().map(|piece| follows(explorer, piece)).collect()
        });
        let initial = explorer.values(core.initial_time).first().copied().unwrap_or(Err(NoValue::Unsupported));
        let initial = initial.ok().map(|x| x.value);
        let mut pieces = Vec::new();
        let mut breaks = Vec::new();
        let mut gap = None;
        let shortest = 1e-9 * (core.span.1 - core.span.0);
        for stretch in stretches {
            match stretch {
                Stretch::Piece(piece) => {
                    if let (Some(at), false) = (gap.take(), pieces.is_empty()) {
                        breaks.push(at);
                    }
                    pieces.push((piece, 0.0));
                }
                // A kink is a gap of no length: there the polynomials on both sides decide.
                Stretch::Gap { start, end, .. } if end - start > shortest => gap = Some(start),
                Stretch::Gap { .. } => {}
            }
        }
        let mut angle = Angle { turns, raw, pieces, breaks };
        angle.connect(core.initial_time, initial);
        angle
    }

    /// Chooses the turns of every piece, from the one at the initial time on.
    fn connect(&mut self, initial_time: f64, initial: Option<f64>) {
        let count = self.pieces.len();
        let Some(last) = count.checked_sub(1) else { return };
        let anchor = self.pieces.partition_point(|(p, _)| p.end < initial_time).min(last);
        let near = self.pieces[anchor].0.angle(initial_time);
        self.pieces[anchor].1 = TAU * around(initial.unwrap_or(0.0) - near);
        for i in anchor + 1..count {
            let (before, from) = (&self.pieces[i - 1].0, self.pieces[i - 1].1);
            let here = &self.pieces[i].0;
            let step = before.angle(before.end) + from - here.angle(here.start);
            self.join(i, step, self.pieces[i].0.start);
        }
        for i in (0..anchor).rev() {
            let (after, from) = (&self.pieces[i + 1].0, self.pieces[i + 1].1);
            let here = &self.pieces[i].0;
            let step = after.angle(after.start) + from - here.angle(here.end);
            self.join(i, step, self.pieces[i].0.end);
        }
        self.breaks.sort_by(f64::total_cmp);
        self.breaks.dedup();
    }

    /// Gives piece `i` the turns that bridge `step`; a rest is a break of the branch.
    fn join(&mut self, i: usize, step: f64, at: f64) {
        let shift = TAU * around(step);
        self.pieces[i].1 = shift;
        if (step - shift).abs() > 0.2 && !self.breaks.contains(&at) {
            self.breaks.push(at);
        }
    }

    /// How many turns the defined value lacks at a time; `turns` has those of the angles before this one.
    pub(super) fn turns_at(&self, core: &Core, t: f64, turns: &Turns, bench: &mut AngleBench) -> Result<i64, NoValue> {
        let bench = bench.one.get_or_insert_with(|| self.raw.bench(core, 0));
        self.raw.run(core, bench, t, turns);
        Ok(self.lacking(t, self.raw.output(bench, 0)?.coefficient(0)))
    }

    /// The same at several times at once: pushes what is found to the turns at each.
    pub(super) fn push_turns(
        &self,
        core: &Core,
        times: &[f64; BLOCK],
        turns: &mut [Turns; BLOCK],
        bench: &mut AngleBench,
    ) {
        let wide = bench.several.get_or_insert_with(|| self.raw.bench(core, 0));
        self.raw.run_lanes(core, wide, times, turns);
        let found = self.raw.output(wide, 0).ok().map(|x| x.coefficient(0).0);
        // What has no value at one of the times is asked for time by time.
        let found = found.filter(|raw| raw.iter().all(|x| x.is_finite()));
        for (i, (&t, turns)) in times.iter().zip(turns).enumerate() {
            let n = match found {
                Some(raw) => Ok(self.lacking(t, raw[i])),
                None => self.turns_at(core, t, turns, bench),
            };
            turns.push(n);
        }
    }

    /// How many turns the defined value `raw` lacks at a time.
    fn lacking(&self, t: f64, raw: f64) -> i64 {
        let after = self.pieces.partition_point(|(p, _)| p.start <= t);
        let Some((piece, shift)) = self.pieces.get(after.saturating_sub(1)) else { return 0 };
        // Between pieces, the nearer end.
        let expected = piece.angle(t.clamp(piece.start, piece.end)) + shift;
        around(expected - raw) as i64
    }
}
