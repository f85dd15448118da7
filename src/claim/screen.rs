//! Whether equations hold at the samples of a motion, beyond any doubt.
//!
//! **In:** a claim that consists of equations at times of one motion, and the values along a motion, block by block. **Out:** that the
//! claim holds there, or nothing. **Guaranteed:** what is said to hold is found to hold by the rules for a claim that is looked at by
//! itself: every comparison is within its error bound at every sample, that bound is small against the size of the terms, so it is
//! around the worst sample, and every term is larger than what may hide it. It is so by much less than the bound, so that narrower
//! bounds would say the same. The values are those that are found there, bit for bit. Whatever is not so clear is left to those rules.
//!
//! **Why:** of a member of a family on which an equation holds nothing is kept but that. What a reader would be shown of it, the
//! columns of values, the witness and the curve, is most of the work of a verdict.

use std::ops::Range;
use std::sync::Arc;

use crate::block::{BLOCK, Block, Part as Tapes};
use crate::comparison::Comparison;
use crate::expr::Graph;
use crate::expr::Leaf;
use crate::expr::tape::Slots;
use crate::flow::{Motion, Sampler};
use crate::latex::RelationKind;
use crate::mute::Terms;
use crate::number::Bounded;
use crate::program::{Part, Program, SIDES, What};
use crate::sides::{median, samples};

/// What is asked of residuals.
#[derive(Clone, Copy, Debug)]
pub struct Margins {
    /// How small error bounds must be, as a share of the size of the terms.
    pub precision: f64,
    /// Up to this share of the size of the terms a residual is rounding, whatever its bound.
    pub rounding: f64,
    /// Above that it must be at most this share of its error bound.
    pub within: f64,
}

/// The equations of a claim, ready to be tried on many motions.
#[derive(Clone, Debug)]
pub struct Screen {
    /// The comparisons of each part.
    parts: Vec<Range<usize>>,
    /// Whether something is compared with what it is at the start.
    from_start: bool,
    margins: Margins,
    sides: Filled,
    sizes: Filled,
    /// The terms of the comparisons.
    terms: Vec<SeenTerms>,
}

/// A tape with its values at a block of times.
#[derive(Clone, Debug)]
struct Filled {
    tapes: Tapes,
    /// The leaf of the motion that each of its inputs is.
    leaves: Vec<usize>,
    slots: Slots<Block>,
}

impl Filled {
    fn of(tapes: &Tapes, places: &[Option<usize>]) -> Option<Filled> {
        let leaves =
            tapes.inputs().iter().map(|at| places.get(*at).copied().flatten()).collect::<Option<Vec<usize>>>()?;
        let mut slots = tapes.tape().slots::<Block>(&());
        // The sign of ±, which does not occur.
        slots.set(leaves.len(), Ok(Block::splat(Bounded::exact(1.0))));
        Some(Filled { tapes: tapes.clone(), leaves, slots })
    }

    /// Evaluates at the times of a block.
    fn run(&mut self, sampler: &Sampler) {
        for (i, &leaf) in self.leaves.iter().enumerate() {
            self.slots.set(i, Ok(*sampler.leaf(leaf)));
        }
        self.tapes.tape().run(&(), &mut self.slots);
    }

    /// Takes a lane of the inputs from another block.
    fn take(&mut self, sampler: &Sampler, from: usize, to: usize) {
        for (i, &leaf) in self.leaves.iter().enumerate() {
            self.slots.value_mut(i).set_lane(to, sampler.leaf(leaf).lane(from));
        }
    }

    fn output(&self, output: usize) -> Option<&Block> {
        self.tapes.tape().output(output, &self.slots).ok()
    }
}

/// The terms of a comparison, with their values at a sample.
#[derive(Clone, Debug)]
struct SeenTerms {
    terms: Arc<Terms>,
    /// The leaf of the motion that each input is; what is no leaf of a point is 1, as the sign of ±.
    leaves: Vec<Option<usize>>,
    slots: Slots<Bounded>,
}

impl SeenTerms {
    fn of(terms: Arc<Terms>, leaves: &[Leaf], places: &[Option<usize>]) -> Option<SeenTerms> {
        let leaf = |leaf: &Leaf| match leaves.binary_search(leaf) {
            Ok(at) => places.get(at).copied().flatten().map(Some),
            Err(_) => Some(None),
        };
        let leaves = terms.inputs().iter().map(leaf).collect::<Option<Vec<Option<usize>>>>()?;
        let slots = terms.slots();
        Some(SeenTerms { terms, leaves, slots })
    }

    /// Whether none of them is hidden at a lane of a block.
    fn are_seen(&mut self, sampler: &Sampler, lane: usize) -> bool {
        let SeenTerms { terms, leaves, slots } = self;
        let value = |leaf: &Option<usize>| leaf.map_or(Bounded::exact(1.0), |leaf| sampler.leaf(leaf).lane(lane));
        terms.are_seen(leaves.iter().map(|leaf| Ok(value(leaf))), slots)
    }
}

/// What was seen of the residuals of a part.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// Whether each is within its bound.
    agrees: bool,
    /// The largest bound.
    widest: f64,
    /// The largest residual that is not well within its bound.
    farthest: f64,
    /// The largest share of its bound that a residual is, and the sample at which it is so first.
    share: f64,
    worst: usize,
}

impl Seen {
    const NOTHING: Seen = Seen { agrees: true, widest: 0.0, farthest: 0.0, share: -1.0, worst: 0 };

    /// Looks at the comparisons of a part at a block of times, the first of which is sample `from`.
    fn look(&mut self, sides: &Filled, comparisons: Range<usize>, from: usize, within: f64) -> bool {
        let mut shares = [0.0_f64; BLOCK];
        for c in comparisons {
            let all = [0, 1, 2].map(|side| sides.output(SIDES * c + side));
            let [Some(_), Some(_), Some(difference)] = all else { return false };
            for (i, most) in shares.iter_mut().enumerate() {
                let Bounded { value, error } = difference.lane(i);
                let size = value.abs();
                // NaN is not within anything.
                self.agrees &= size <= error;
                self.widest = self.widest.max(error);
                let share = if size == 0.0 { 0.0 } else { size / error };
                if share > within {
                    self.farthest = self.farthest.max(size);
                }
                *most = most.max(share);
            }
        }
        for (i, share) in shares.into_iter().enumerate() {
            if share > self.share {
                (self.share, self.worst) = (share, from + i);
            }
        }
        self.agrees
    }

    /// Whether all is well, where the terms have this size.
    fn is_clear(&self, size: f64, margins: &Margins) -> bool {
        self.agrees && self.widest <= margins.precision * size && self.farthest <= margins.rounding * size
    }
}

/// Whether a part is made of equations alone, with nothing to be looked for between samples.
fn is_plain(part: &Part) -> bool {
    let group = &part.group;
    let equation = |c: &Comparison| {
        c.kind == RelationKind::Equal && c.boundaries.is_empty() && c.meetings.is_empty() && c.cuts.is_empty()
    };
    let whole = group.formula.is_none() && group.one_sided.is_empty();
    let flat = !group.branching && !group.asserted && !group.denied;
    let of_times = matches!(part.what, What::Every | What::Constant | What::Value);
    of_times && whole && flat && !group.comparisons.is_empty() && group.comparisons.iter().all(equation)
}

impl Screen {
    /// The equations of a claim; nothing where it is of another kind. `leaves` are those of a point, and `places` say which leaf of the
    /// motion each of them is.
    pub fn of(
        program: &Program,
        graph: &Graph,
        (leaves, places): (&[Leaf], &[Option<usize>]),
        margins: Margins,
    ) -> Option<Screen> {
        let alone = program.selectors.is_empty() && program.hypotheses.is_empty() && program.at.is_none();
        let smooth = program.rapid.is_empty() && program.edges.is_empty() && !program.leaps_at && !program.tells_apart;
        if !alone || !smooth || !program.parts.iter().all(is_plain) {
            return None;
        }
        let (mut parts, mut next) = (Vec::new(), 0);
        for part in &program.parts {
            let comparisons = next..next + part.group.comparisons.len();
            next = comparisons.end;
            if part.is_compared() {
                parts.push(comparisons);
            }
        }
        let mut terms = Vec::new();
        let compared = program.parts.iter().filter(|part| part.is_compared());
        for comparison in compared.flat_map(|part| &part.group.comparisons) {
            if let Some(of) = comparison.told.shared(graph, comparison) {
                terms.push(SeenTerms::of(of, leaves, places)?);
            }
        }
        Some(Screen {
            parts,
            from_start: program.parts.iter().any(|part| matches!(part.what, What::Constant)),
            margins,
            sides: Filled::of(program.sides()?, places)?,
            sizes: Filled::of(program.sizes()?, places)?,
            terms,
        })
    }

    /// Whether the claim holds on a motion with these samples, the worst of which is looked at more closely at the times that `near`
    /// gives, up to a block of them. The motion is one without a problem, and its initial values are given at `start`.
    pub fn holds(
        &mut self,
        sampler: &mut Sampler,
        (motion, start): (&Motion, f64),
        times: &[f64],
        near: impl Fn(usize) -> Vec<f64>,
    ) -> bool {
        let Some(last) = times.len().checked_sub(1) else { return false };
        let at_start = || times.binary_search_by(|t| t.total_cmp(&start)).is_ok();
        if self.from_start && !at_start() || !sampler.enter(motion) {
            return false;
        }
        let within = self.margins.within;
        let mut seen = vec![Seen::NOTHING; self.parts.len()];
        let count = self.sizes.tapes.tape().output_count();
        let mut sizes = Sizes { picked: samples(times.len()), seen: 0, found: vec![Vec::new(); count] };
        for from in (0..times.len()).step_by(BLOCK) {
            // What is left at the end is the last time again.
            let block = std::array::from_fn(|i| times[(from + i).min(last)]);
            if !sampler.run(motion, &block) {
                return false;
            }
            self.sides.run(sampler);
            if from == 0 && !self.terms.iter_mut().all(|terms| terms.are_seen(sampler, 0)) {
                return false;
            }
            let mut parts = seen.iter_mut().zip(&self.parts);
            if !parts.all(|(seen, part)| seen.look(&self.sides, part.clone(), from, within)) {
                return false;
            }
            if !sizes.take(&mut self.sizes, sampler, from..from + BLOCK) {
                return false;
            }
        }
        seen.iter().zip(&self.parts).all(|(along, part)| {
            let size = sizes.typical(part.clone());
            let around = near(along.worst);
            let Some(&end) = around.last() else { return false };
            if size <= 0.0 || !along.is_clear(size, &self.margins) || around.len() > BLOCK {
                return false;
            }
            let block = std::array::from_fn(|i| around.get(i).copied().unwrap_or(end));
            if !sampler.run(motion, &block) {
                return false;
            }
            self.sides.run(sampler);
            let mut closer = Seen::NOTHING;
            closer.look(&self.sides, part.clone(), 0, within) && closer.is_clear(size, &self.margins)
        })
    }
}

/// The sizes of the terms at some of the samples.
struct Sizes {
    /// Which samples, increasing, and how many of them were seen.
    picked: Vec<usize>,
    seen: usize,
    /// `[comparison][sample]`.
    found: Vec<Vec<f64>>,
}

impl Sizes {
    /// Takes those of the samples of a block that are picked; `false` where one has no size.
    fn take(&mut self, tapes: &mut Filled, sampler: &Sampler, block: Range<usize>) -> bool {
        while let Some(pick) = self.picked.get(self.seen).filter(|pick| block.contains(pick)) {
            let lane = self.seen % BLOCK;
            self.seen += 1;
            let last = self.seen == self.picked.len();
            // What is left at the end is the last sample again.
            for to in lane..if last { BLOCK } else { lane + 1 } {
                tapes.take(sampler, pick - block.start, to);
            }
            if !last && lane + 1 < BLOCK {
                continue;
            }
            tapes.tapes.tape().run(&(), &mut tapes.slots);
            for (c, found) in self.found.iter_mut().enumerate() {
                let Some(sizes) = tapes.output(c) else { return false };
                found.extend_from_slice(&sizes.values()[..=lane]);
            }
        }
        true
    }

    /// What is typical of a part.
    fn typical(&self, comparisons: Range<usize>) -> f64 {
        self.found[comparisons].iter().map(|sizes| median(sizes.clone())).fold(0.0, f64::max)
    }
}
