//! A span cut into stretches on each of which an expression is its Taylor polynomial.

use super::angle::AngleBenches;
use super::core::Core;
use super::program::{Bench, Program, Turns};
use number::{Bounded, BoundedLanes, Jet, Lanes, NoValue};

/// How many stretches, or times, are looked at together.
pub(super) const BLOCK: usize = 8;

/// Fewer than these are looked at one by one.
const FEW: usize = 3;

/// Stretches are halved at most so often in one cover: a piece has some 300 bytes.
const MOST_HALVINGS: usize = 100_000;

/// The counted work of a polynomial over a stretch beside its expansion: where it turns, whether it describes what it stands for.
const OF_A_PIECE: u64 = 1_200;

/// A stretch of time.
#[derive(Clone, Debug)]
pub(super) enum Stretch {
    /// The polynomial of every output around the middle.
    Piece(Piece),
    /// The outputs have no value, or no polynomial of the degree describes them.
    Gap {
        /// From where.
        start: f64,
        /// To where.
        end: f64,
        /// Why; `None` where there are values, but no convergence.
        reason: Option<NoValue>,
    },
}

impl Stretch {
    /// Where it begins.
    fn start(&self) -> f64 {
        match self {
            Stretch::Piece(piece) => piece.start,
            Stretch::Gap { start, .. } => *start,
        }
    }
}

/// Polynomials over a stretch.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) centre: f64,
    /// Coefficients of every output, ascending, around `centre`.
    pub(super) outputs: Vec<Vec<f64>>,
    /// Value of every output at the centre, with error.
    pub(super) values: Vec<Bounded>,
    /// Whether no argument of an exponential, a power, or a quotient moves so far that the polynomials may not know of it.
    pub(super) moderate: bool,
}

impl Piece {
    /// Half the length.
    pub(super) fn radius(&self) -> f64 {
        (self.centre - self.start).max(self.end - self.centre)
    }
}

/// Evaluates the outputs of a program along a motion: one memory for polynomials, one for values with errors.
pub(super) struct Explorer<'a> {
    pub(super) core: &'a Core,
    pub(super) program: &'a Program,
    series: Bench<f64>,
    values: Bench<Bounded>,
    plain: Bench<f64>,
    wide_series: Bench<Lanes<BLOCK>>,
    wide_values: Bench<BoundedLanes<BLOCK>>,
    angles: AngleBenches,
}

impl<'a> Explorer<'a> {
    pub(super) fn new(core: &'a Core, program: &'a Program, degree: usize) -> Explorer<'a> {
        Explorer {
            core,
            program,
            series: program.bench_of_steps(core, degree),
            values: program.bench(core, 0),
            plain: program.bench(core, 0),
            wide_series: program.bench_of_steps(core, degree),
            wide_values: program.bench(core, 0),
            angles: Vec::new(),
        }
    }

    /// The value of every output.
    pub(super) fn values(&mut self, t: f64) -> Vec<Result<Bounded, NoValue>> {
        let turns = self.core.turns(self.program, t, &mut self.angles);
        self.program.run(self.core, &mut self.values, t, &turns);
        (0..self.program.output_count())
            .map(|i| self.program.output(&self.values, i).map(|x| x.coefficient(0)))
            .collect()
    }

    /// The value of the first output at many times.
    pub(super) fn all_values(&mut self, times: &[f64]) -> Vec<Result<Bounded, NoValue>> {
        let mut out = Vec::with_capacity(times.len());
        for block in times.chunks(BLOCK) {
            let lanes = padded(block).and_then(|times| {
                let turns = self.turns(&times);
                self.program.run_lanes(self.core, &mut self.wide_values, &times, &turns);
                self.program.output(&self.wide_values, 0).ok().map(|x| x.coefficient(0))
            });
            match lanes {
                Some(lanes) => out.extend((0..block.len()).map(|i| Ok(lanes.lane(i)))),
                None => out.extend(
                    block.iter().map(|&t| self.values(t).first().copied().unwrap_or(Err(NoValue::Unsupported))),
                ),
            }
        }
        out
    }

    fn turns(&mut self, times: &[f64; BLOCK]) -> [Turns; BLOCK] {
        self.core.turns_of_block(self.program, times, &mut self.angles)
    }

    /// The polynomials around the middles of several stretches; none where that must be found out for a stretch alone.
    fn pieces(&mut self, stretches: &[(f64, f64); BLOCK]) -> [Option<Piece>; BLOCK] {
        let centres = stretches.map(|(start, end)| start + 0.5 * (end - start));
        let turns = self.turns(&centres);
        self.program.run_lanes(self.core, &mut self.wide_values, &centres, &turns);
        self.program.run_lanes(self.core, &mut self.wide_series, &centres, &turns);
        let outputs = 0..self.program.output_count();
        let values: Result<Vec<_>, _> =
            outputs.clone().map(|o| self.program.output(&self.wide_values, o).map(|x| x.coefficient(0))).collect();
        let series: Result<Vec<_>, _> = outputs.map(|o| self.program.output(&self.wide_series, o)).collect();
        let (Ok(values), Ok(series)) = (values, series) else { return [const { None }; BLOCK] };
        std::array::from_fn(|i| {
            let of = |x: &&Jet<Lanes<BLOCK>>| x.coefficients().iter().map(|c| c.0[i]).collect::<Vec<f64>>();
            let outputs: Vec<Vec<f64>> = series.iter().map(of).collect();
            // Of lanes, one without a value does not stop the others.
            let known = outputs.iter().flatten().all(|c| c.is_finite());
            let (start, end) = stretches[i];
            let values = values.iter().map(|x| x.lane(i)).collect();
            let moderate = self.program.is_moderate(
                (&self.wide_series, |c| c.0[i]),
                (&self.wide_values, |x| x.lane(i).error),
                0.5 * (end - start),
            );
            known.then(|| Piece { start, end, centre: centres[i], outputs, values, moderate })
        })
    }

    /// The value of the first output, without its error.
    pub(super) fn plain(&mut self, t: f64) -> Option<f64> {
        let turns = self.core.turns(self.program, t, &mut self.angles);
        self.program.run(self.core, &mut self.plain, t, &turns);
        self.program.output(&self.plain, 0).ok().map(|x| x.coefficient(0))
    }

    /// Expands all outputs around a time; [`Explorer::expanded`] tells them.
    pub(super) fn expand(&mut self, t: f64) {
        let turns = self.core.turns(self.program, t, &mut self.angles);
        self.program.run(self.core, &mut self.series, t, &turns);
    }

    /// The coefficients of an output; `None` if it has none.
    pub(super) fn expanded(&self, output: usize) -> Option<&[f64]> {
        self.program.output(&self.series, output).ok().map(Jet::coefficients)
    }

    /// The polynomials around the middle of a stretch.
    fn piece(&mut self, start: f64, end: f64) -> Result<Piece, NoValue> {
        let centre = start + 0.5 * (end - start);
        let values = self.values(centre).into_iter().collect::<Result<Vec<_>, _>>()?;
        self.expand(centre);
        // Without its error a value may be out of a domain that it is in, as for all that is known: √0.
        let outputs = (0..self.program.output_count())
            .map(|i| self.expanded(i).map(<[f64]>::to_vec))
            .collect::<Option<Vec<_>>>()
            .ok_or(NoValue::Indeterminate)?;
        let moderate =
            self.program.is_moderate((&self.series, |c| *c), (&self.values, |x| x.error), 0.5 * (end - start));
        Ok(Piece { start, end, centre, outputs, values, moderate })
    }

    /// Cuts the motion at `times`, and then in halves until every piece is moderate and `accept` takes it.
    ///
    /// Stretches without any value are given up at once, others when they are shorter than time can be resolved, or when
    /// the work exceeds a limit that is proportional to the number of times.
    pub(super) fn cover(
        &mut self,
        times: &[f64],
        mut accept: impl FnMut(&mut Self, &[&Piece]) -> Vec<bool>,
    ) -> Vec<Stretch> {
        let moderate = |explorer: &mut Self, pieces: &[&Piece]| {
            let moderate: Vec<&Piece> = pieces.iter().copied().filter(|piece| piece.moderate).collect();
            let mut accepted = accept(explorer, &moderate).into_iter();
            pieces.iter().map(|piece| piece.moderate && accepted.next() == Some(true)).collect()
        };
        self.cover_unless(times, moderate, |explorer, start, end| !explorer.somewhere(start, end))
    }

    /// The same, where `accept` alone decides, and `hopeless` says of a stretch whose middle has no value whether it has none
    /// anywhere.
    ///
    /// All stretches are looked at before any half, and all halves before a quarter: `accept` is asked of many at once.
    pub(super) fn cover_unless(
        &mut self,
        times: &[f64],
        mut accept: impl FnMut(&mut Self, &[&Piece]) -> Vec<bool>,
        mut hopeless: impl FnMut(&mut Self, f64, f64) -> bool,
    ) -> Vec<Stretch> {
        let length = times.last().zip(times.first()).map_or(0.0, |(b, a)| b - a);
        let mut budget = (4000 + 200 * times.len()).min(MOST_HALVINGS);
        let mut level: Vec<(f64, f64)> = times.windows(2).map(|pair| (pair[0], pair[1])).collect();
        let mut done: Vec<Stretch> = Vec::with_capacity(level.len());
        while !level.is_empty() {
            let found = self.all_pieces(&level);
            let pieces: Vec<&Piece> = found.iter().filter_map(|piece| piece.as_ref().ok()).collect();
            let mut accepted = accept(self, &pieces).into_iter();
            let mut halves = Vec::new();
            for (found, (start, end)) in found.into_iter().zip(level) {
                let reason = match found {
                    Ok(piece) if accepted.next() == Some(true) => {
                        done.push(Stretch::Piece(piece));
                        continue;
                    }
                    found => found.err(),
                };
                budget = budget.saturating_sub(1);
                let smallest = 1e-15 * length + 2.0 * f64::EPSILON * start.abs().max(end.abs());
                let middle = start + 0.5 * (end - start);
                let given_up = reason.is_some() && hopeless(self, start, end);
                if budget == 0 || given_up || end - start <= smallest || !(start < middle && middle < end) {
                    done.push(Stretch::Gap { start, end, reason });
                } else {
                    halves.extend([(start, middle), (middle, end)]);
                }
            }
            level = halves;
        }
        done.sort_by(|a, b| a.start().total_cmp(&b.start()));
        // Gaps side by side are one.
        let mut out: Vec<Stretch> = Vec::with_capacity(done.len());
        for stretch in done {
            match (out.last_mut(), &stretch) {
                (Some(Stretch::Gap { end: last, reason: why, .. }), Stretch::Gap { end, reason, .. }) => {
                    *last = *end;
                    *why = why.or(*reason);
                }
                _ => out.push(stretch),
            }
        }
        out
    }

    /// The polynomials around the middles of stretches.
    fn all_pieces(&mut self, stretches: &[(f64, f64)]) -> Vec<Result<Piece, NoValue>> {
        meter::charge(OF_A_PIECE * (stretches.len() * self.program.output_count()) as u64);
        let mut out = Vec::with_capacity(stretches.len());
        for block in stretches.chunks(BLOCK) {
            let together = match padded(block) {
                Some(block) => self.pieces(&block),
                None => [const { None }; BLOCK],
            };
            let each = block.iter().zip(together);
            out.extend(each.map(|(&(start, end), found)| found.map_or_else(|| self.piece(start, end), Ok)));
        }
        out
    }

    /// Whether the outputs have values at one of a few times of a stretch.
    pub(super) fn somewhere(&mut self, start: f64, end: f64) -> bool {
        [0.0, 0.11, 0.27, 0.73, 0.89, 1.0]
            .iter()
            .any(|x| self.values(start + x * (end - start)).iter().all(Result::is_ok))
    }
}

/// A full block, with the last as often as it takes; `None` where one by one is faster.
fn padded<T: Copy>(block: &[T]) -> Option<[T; BLOCK]> {
    let last = block.len().checked_sub(1).filter(|_| block.len() >= FEW)?;
    Some(std::array::from_fn(|i| block[i.min(last)]))
}
