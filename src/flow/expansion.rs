//! The values and rates of leaves, from the Taylor series of their definitions.
//!
//! **In:** one program for all leaves. **Out:** their values at a time, or at many. Times are taken in blocks; a leaf that has
//! no value somewhere in a block is looked at time by time, with a program of its own.
//!
//! **Guaranteed:** blocks and single times give the same values, bit for bit; error bounds of blocks may be larger by a few
//! units in their last place.

use std::sync::Arc;

use super::angle::AngleBenches;
use super::core::Core;
use super::cover::BLOCK;
use super::motion::Point;
use super::points::Points;
use super::program::{Bench, Program};
use number::{Bounded, BoundedLanes, Jet, NoValue, Scalar};

/// How many blocks of times in a row may be at branch points before times are looked at one by one.
const PATIENCE: usize = 3;

/// A program for leaves.
#[derive(Clone, Debug)]
pub(super) struct Expansion {
    program: Arc<Program>,
    degree: usize,
    /// Output and order of the time derivative of every leaf.
    places: Arc<[(usize, usize)]>,
    /// For every output, whether it has no value at any time.
    never: Vec<bool>,
    /// For every output, whether it is the same at all times.
    still: Arc<[bool]>,
}

/// Memory of one evaluation.
#[derive(Debug, Default)]
pub(super) struct Memory {
    bench: Option<Bench<Bounded>>,
    /// The same for other degrees, by degree: for branch points.
    others: Vec<Option<Bench<Bounded>>>,
    lanes: Option<Bench<BoundedLanes<BLOCK>>>,
    angles: AngleBenches,
    /// Programs for some of the leaves, which are named.
    parts: Vec<(Vec<usize>, Expansion, Memory)>,
}

/// The n-th derivative, from the series of a leaf.
fn derivative<B: Scalar>(series: &Jet<B>, order: usize) -> Result<B, NoValue> {
    let coefficient = series.coefficient(order);
    if order < 2 {
        // A product would add a rounding error, and make exact parameters inexact.
        return coefficient.checked();
    }
    let factorial = (2..=order).fold(B::integer(1), |product, k| product * B::integer(k as i32));
    (coefficient * factorial).checked()
}

impl Expansion {
    /// `places` has the output of the program and the order of the time derivative of every leaf.
    pub(super) fn new(core: &Core, program: Program, places: Vec<(usize, usize)>) -> Expansion {
        let degree = places.iter().map(|p| p.1).max().unwrap_or(0);
        let (never, still) = (program.never_valued(core), program.still().into());
        Expansion { program: Arc::new(program), degree, places: places.into(), never, still }
    }

    /// The same for a motion with other numbers.
    pub(super) fn again(&self, core: &Core) -> Expansion {
        let Expansion { program, degree, places, still, .. } = self;
        let (program, places, still) = (Arc::clone(program), Arc::clone(places), Arc::clone(still));
        Expansion { never: program.never_valued(core), program, degree: *degree, places, still }
    }

    /// The program, where leaves are the values of its outputs and nothing else is to be known.
    pub(super) fn direct(&self) -> Option<&Arc<Program>> {
        (self.degree == 0 && !self.program.needs_turns()).then_some(&self.program)
    }

    /// The output of every leaf.
    pub(super) fn outputs(&self) -> impl Iterator<Item = usize> {
        self.places.iter().map(|p| p.0)
    }

    /// The order of the time derivative of every leaf.
    pub(super) fn orders(&self) -> impl Iterator<Item = usize> {
        self.places.iter().map(|p| p.1)
    }

    /// The same for some of the leaves.
    pub(super) fn part(&self, leaves: &[usize]) -> Expansion {
        let mut outputs: Vec<usize> = leaves.iter().map(|&l| self.places[l].0).collect();
        outputs.sort_unstable();
        outputs.dedup();
        let place = |&l: &usize| (outputs.partition_point(|&o| o < self.places[l].0), self.places[l].1);
        Expansion {
            program: Arc::new(self.program.part(&outputs)),
            degree: leaves.iter().map(|&l| self.places[l].1).max().unwrap_or(0),
            places: leaves.iter().map(place).collect(),
            never: outputs.iter().map(|&o| self.never[o]).collect(),
            still: outputs.iter().map(|&o| self.still[o]).collect(),
        }
    }

    /// The leaves at a time, and whether a branch point lies there.
    pub(super) fn at(&self, core: &Core, memory: &mut Memory, t: f64) -> (Point, bool) {
        let turns = core.turns(&self.program, t, &mut memory.angles);
        let read = |bench: &Bench<Bounded>, output: usize, order: usize| {
            derivative(self.program.output(bench, output)?, order)
        };
        let bench = memory.bench.get_or_insert_with(|| self.program.bench(core, self.degree));
        self.program.run(core, bench, t, &turns);
        let branch = self.program.at_branch_point(bench);
        let mut point: Point = self.places.iter().map(|&(at, order)| read(bench, at, order)).collect();
        if self.degree > 0 && (branch || point.iter().any(Result::is_err)) {
            // A value exists also where a derivative does not: every order by itself. At a branch point, whether an
            // argument of √ is constant up to order n takes 2n orders to tell.
            memory.others.resize(2 * self.degree + 1, None);
            for order in 0..=self.degree {
                // Without a branch point, fewer orders can only help a leaf that has no value.
                let helps = |(x, place): (&Result<Bounded, NoValue>, &(usize, usize))| {
                    branch || (place.1 == order && order < self.degree && x.is_err() && !self.never[place.0])
                };
                if !point.iter().zip(&*self.places).any(helps) {
                    continue;
                }
                let degree = if branch { 2 * order } else { order };
                let bench = memory.others[degree].get_or_insert_with(|| self.program.bench(core, degree));
                self.program.run(core, bench, t, &turns);
                for (x, place) in point.iter_mut().zip(&*self.places) {
                    if place.1 == order {
                        *x = read(bench, place.0, order);
                    }
                }
            }
        }
        (point, branch)
    }

    /// The leaves at a time if a branch point lies there; `None`, from values alone, where none does.
    pub(super) fn at_branch_point(&self, core: &Core, memory: &mut Memory, t: f64) -> Option<Point> {
        if self.degree == 0 || !self.program.has_branches() {
            return None;
        }
        let turns = core.turns(&self.program, t, &mut memory.angles);
        memory.others.resize(2 * self.degree + 1, None);
        let bench = memory.others[0].get_or_insert_with(|| self.program.bench(core, 0));
        self.program.run(core, bench, t, &turns);
        if !self.program.is_at_branch_value(bench) {
            return None;
        }
        let (point, branch) = self.at(core, memory, t);
        branch.then_some(point)
    }

    /// The leaves at many times.
    pub(super) fn along(&self, core: &Core, memory: &mut Memory, times: &[f64]) -> Points {
        let mut out = Points::with_room(self.places.len(), times.len());
        let mut failed = 0;
        for block in times.chunks(BLOCK) {
            if let (Ok(block), true) = (block.try_into(), failed < PATIENCE) {
                if self.block(core, memory, block, &mut out) {
                    failed = 0;
                    continue;
                }
                failed += 1;
            }
            block.iter().for_each(|&t| out.push(self.at(core, memory, t).0));
        }
        out.finished()
    }

    /// Adds the leaves at several times; `false`, and nothing added, where that must be done one by one.
    fn block(&self, core: &Core, memory: &mut Memory, times: &[f64; BLOCK], out: &mut Points) -> bool {
        let turns = core.turns_of_block(&self.program, times, &mut memory.angles);
        let bench = memory.lanes.get_or_insert_with(|| self.program.bench(core, self.degree));
        self.program.run_lanes(core, bench, times, &turns);
        if self.program.may_be_at_branch_point(bench) {
            return false;
        }
        let mut single = Vec::new();
        for (leaf, &(output, order)) in self.places.iter().enumerate() {
            // A column that says of its first times what it says of all.
            if self.still[output] && !out.is_empty() {
                continue;
            }
            match self.program.output(bench, output).and_then(|series| derivative(series, order)) {
                Err(_) if !self.never[output] => single.push(leaf),
                lanes => out.push_lanes(leaf, lanes),
            }
        }
        if !single.is_empty() {
            let at = memory.parts.iter().position(|(leaves, ..)| *leaves == single).unwrap_or_else(|| {
                memory.parts.push((single.clone(), self.part(&single), Memory::default()));
                memory.parts.len() - 1
            });
            let (leaves, part, memory) = &mut memory.parts[at];
            for (i, &t) in times.iter().enumerate() {
                let (point, _) = part.at(core, memory, t);
                leaves.iter().zip(point).for_each(|(&leaf, x)| out.push_one(leaf, i, x));
            }
        }
        out.counted(BLOCK);
        true
    }
}
