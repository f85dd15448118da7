//! Where expressions vary more rapidly than the samples of a motion, or a series around one time, tell.
//!
//! **In:** expressions along a motion, and the samples. **Out:** the times between them at which each is to be looked at, see
//! [`arguments`](super::arguments) for why. All arguments of all expressions are on one tape: many formulas have the same.

use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::{Arc, OnceLock};

use super::arguments::{Argument, Kind, Moves, Within, changes_sign, moves};
use super::core::Core;
use super::cover::{BLOCK, Explorer};
use super::error::FlowError;
use super::polynomial::{shift, tail};
use super::program::{Bench, Program};
use expr::{Expr, Graph};
use number::{Bounded, BoundedLanes};

/// Degree of the polynomials of arguments.
const DEGREE: usize = 12;
/// Most times that are added for one argument, and for one claim.
const MOST: usize = 20_000;

/// A polynomial is used for what it is of if its last terms are below this share of all.
const FINE: f64 = 1e-13;
/// It tells how a part of its stretch moves that is above this share of all: what is below is not known well from afar.
const COARSE: f64 = 1e-9;

/// What stays below this share of its error is not known at any time of a stretch, though the error varies on it.
const CERTAIN: f64 = 0.25;

/// Times between samples at which an expression is to be looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rapid {
    /// Where an exponential, or a high power, changes by a large factor from one sample to the next.
    pub times: Vec<f64>,
    /// Where only what is divided by, or has a root or a kink, does: there errors may be larger than anything that is to be seen.
    pub singular: Vec<f64>,
    /// A stretch on which an exponential has more such times than can be looked at: these are some of them.
    pub unresolved: Option<(f64, f64)>,
}

/// An argument, and where it moves by much.
#[derive(Clone, Debug)]
struct Watched {
    argument: Argument,
    found: OnceLock<Rapid>,
}

/// A search for where expressions vary rapidly, compiled when a motion is made ready and carried out when it is first asked for.
#[derive(Clone, Debug)]
pub struct RapidSearch {
    core: Arc<Core>,
    /// What the slots of the arguments stand for.
    program: Arc<Program>,
    watched: Vec<Watched>,
    /// For each expression, its arguments; none where it has no meaning on the motion.
    of: Arc<[Vec<usize>]>,
    /// For each argument, where it moves by much.
    gaps: OnceLock<Vec<Vec<Moved>>>,
}

impl RapidSearch {
    /// The same search along a motion with other numbers.
    pub(super) fn again(&self, core: Arc<Core>) -> RapidSearch {
        let watched = |w: &Watched| Watched { argument: w.argument, found: OnceLock::new() };
        RapidSearch {
            core,
            program: Arc::clone(&self.program),
            watched: self.watched.iter().map(watched).collect(),
            of: Arc::clone(&self.of),
            gaps: OnceLock::new(),
        }
    }

    /// What it is searched with.
    pub(super) fn core(&self) -> &Core {
        &self.core
    }

    /// Where one of some expressions, by their positions, varies more rapidly than the samples of the motion tell, which are the same
    /// each time that this is asked.
    pub fn rapid(&self, expressions: impl IntoIterator<Item = usize>, samples: &[f64]) -> Rapid {
        let mut arguments: Vec<usize> =
            expressions.into_iter().filter_map(|e| self.of.get(e)).flatten().copied().collect();
        arguments.sort_unstable();
        arguments.dedup();
        let mut out = Rapid::default();
        for at in arguments {
            let found = self.watched[at].found.get_or_init(|| self.resolve(at, samples));
            out.times.extend(&found.times);
            out.singular.extend(&found.singular);
            out.unresolved = out.unresolved.or(found.unresolved);
        }
        for times in [&mut out.times, &mut out.singular] {
            times.sort_by(f64::total_cmp);
            times.dedup();
        }
        if out.times.len() > MOST {
            out.unresolved = out.unresolved.or(out.times.first().copied().zip(out.times.last().copied()));
        }
        for times in [&mut out.times, &mut out.singular] {
            if times.len() > MOST {
                *times = (0..MOST).map(|i| times[i * times.len() / MOST]).collect();
            }
        }
        out
    }

    /// Where an argument moves by much, in steps that are moderate.
    fn resolve(&self, at: usize, samples: &[f64]) -> Rapid {
        let mut out = Rapid::default();
        let gaps = &self.gaps.get_or_init(|| self.moved(samples))[at];
        if gaps.is_empty() {
            return out;
        }
        let argument = self.watched[at].argument;
        let slots: Vec<usize> = argument.slots().collect();
        let program = self.program.part(&slots);
        let explorer = Explorer::new(&self.core, &program, DEGREE);
        let mut local = Local { explorer, argument, errors: vec![0.0; slots.len()], slots };
        let count = |kind: Kind| gaps.iter().filter(|gap| gap.kind == kind).count();
        let mut left = (count(Kind::Exponential), count(Kind::Singular));
        for gap in gaps {
            let whole = (samples[gap.from], samples[gap.from + 1]);
            local.errors.clone_from(&gap.errors);
            let (times, left) = match gap.kind {
                Kind::Exponential => (&mut out.times, &mut left.0),
                Kind::Singular => (&mut out.singular, &mut left.1),
            };
            // Each has its share of what is left.
            let most = (MOST - times.len().min(MOST)) / *left;
            *left -= 1;
            if !local.halve((whole, gap.kind), most, times) && gap.kind == Kind::Exponential {
                out.unresolved.get_or_insert(whole);
            }
        }
        for times in [&mut out.times, &mut out.singular] {
            times.retain(|t| samples.binary_search_by(|x| x.total_cmp(t)).is_err());
        }
        out
    }

    /// For each argument, where it moves by much.
    fn moved(&self, samples: &[f64]) -> Vec<Vec<Moved>> {
        // The number in each slot, one slot after the other.
        let count = samples.len();
        let mut values: Vec<Option<Bounded>> = vec![None; count * self.program.output_count()];
        let mut wide: Bench<BoundedLanes<BLOCK>> = self.program.bench(&self.core, 0);
        let mut narrow: Bench<Bounded> = self.program.bench(&self.core, 0);
        let mut angles = Vec::new();
        for (at, block) in samples.chunks(BLOCK).enumerate() {
            let times: [f64; BLOCK] = std::array::from_fn(|i| block[i.min(block.len() - 1)]);
            let turns = self.core.turns_of_block(&self.program, &times, &mut angles);
            self.program.run_lanes(&self.core, &mut wide, &times, &turns);
            let mut missing = Vec::new();
            for slot in 0..self.program.output_count() {
                match self.program.output(&wide, slot) {
                    Ok(found) => {
                        let (first, found) = (slot * count + at * BLOCK, found.coefficient(0));
                        (0..block.len()).for_each(|i| values[first + i] = Some(found.lane(i)));
                    }
                    Err(_) => missing.push(slot),
                }
            }
            // What has no value at one of the times may have one at the others.
            for (i, &t) in block.iter().enumerate().filter(|_| !missing.is_empty()) {
                self.program.run(&self.core, &mut narrow, t, &turns[i]);
                for &slot in &missing {
                    let found = self.program.output(&narrow, slot).ok();
                    values[slot * count + at * BLOCK + i] = found.map(|x| x.coefficient(0));
                }
            }
        }
        let value = |slot: usize, k: usize| values[slot * count + k];
        let step = |slot: usize, k: usize| Some((value(slot, k + 1)?.value - value(slot, k)?.value).abs());
        let last = count.saturating_sub(1);
        let moved = |argument: &Argument, from: usize| {
            // From sample to sample, and from those beside them: a peak between two that are alike shows in its neighbours.
            let beside = from.saturating_sub(1)..(from + 2).min(last);
            let by = |slot: usize| beside.clone().filter_map(|k| step(slot, k)).fold(0.0, f64::max);
            let moves = |slot: usize, k: usize| {
                let Bounded { value, error } = value(slot, k)?;
                Some(Moves { value, by: by(slot), error })
            };
            let kinds = [from, from + 1].map(|k| argument.varies(|slot| moves(slot, k), |_| true));
            let kind = if kinds.contains(&Some(Kind::Singular)) { Some(Kind::Singular) } else { kinds[0].or(kinds[1]) };
            let error = |slot: usize, k: usize| value(slot, k).map_or(0.0, |x| x.error);
            let errors = || argument.slots().map(|slot| error(slot, from).max(error(slot, from + 1))).collect();
            kind.map(|kind| Moved { from, kind, errors: errors() })
        };
        self.watched.iter().map(|w| (0..last).filter_map(|i| moved(&w.argument, i)).collect()).collect()
    }
}

/// A stretch between two samples on which an argument moves by much.
#[derive(Clone, Debug)]
struct Moved {
    /// The first of the samples.
    from: usize,
    kind: Kind,
    /// How well what is in each of its slots is known there.
    errors: Vec<f64>,
}

/// The polynomials of what is in the slots of an argument, around a time, up to a radius.
struct Expanded {
    centre: f64,
    radius: f64,
    slots: Vec<Option<Vec<f64>>>,
}

impl Expanded {
    /// How far what is in a slot moves up to a distance from a time; nothing if the polynomial does not tell, since it does not
    /// converge, or rounds what is left.
    fn moves(&self, slot: usize, error: f64, (t, radius): (f64, f64), out: &mut Vec<f64>) -> Option<Option<Moves>> {
        let Some(Some(c)) = self.slots.get(slot) else { return Some(None) };
        shift(c, t - self.centre, radius, out);
        let here = moves(out.iter().copied(), 1.0, error);
        if t == self.centre && radius == self.radius {
            return Some(Some(here));
        }
        let whole = moves(c.iter().copied(), self.radius, error);
        let all = whole.value.abs() + whole.by;
        let seen = here.value.abs() + here.by >= COARSE * all;
        (tail(c, DEGREE, self.radius) <= FINE * all && seen).then_some(Some(here))
    }
}

/// How an argument moves on a stretch.
enum Found {
    Moderate,
    /// It is singular on all of it, as far as it is known.
    Nothing,
    Much,
}

/// An argument along a motion.
struct Local<'a> {
    explorer: Explorer<'a>,
    argument: Argument,
    slots: Vec<usize>,
    /// How well what is in each slot is known.
    errors: Vec<f64>,
}

impl Local<'_> {
    /// Cuts a stretch in halves until the argument moves moderately on each, or it is as short as times can be told, all of them by one
    /// level after the other: whether that took no more times than are allowed. If it would take more, some are added all over the
    /// stretch.
    fn halve(&mut self, (whole, kind): ((f64, f64), Kind), most: usize, times: &mut Vec<f64>) -> bool {
        let before = times.len();
        let mut shifted = Vec::new();
        let mut left = VecDeque::from([(whole, None)]);
        let mut resolved = true;
        while let Some(((start, end), known)) = left.pop_front() {
            let middle = start + 0.5 * (end - start);
            let radius = 0.5 * (end - start);
            let smallest = 1e-12 * (whole.1 - whole.0) + 2.0 * f64::EPSILON * start.abs().max(end.abs());
            let (moves, known) = self.look(middle, radius, known, &mut shifted);
            match moves {
                // Whatever is singular there has no value that is known.
                Found::Nothing if kind == Kind::Singular => continue,
                Found::Moderate => {}
                _ if end - start <= smallest => {}
                // Halves would be more than may be added.
                _ if times.len() - before + 2 * (left.len() + 2) > most => resolved = false,
                _ => {
                    left.extend([((start, middle), Some(Rc::clone(&known))), ((middle, end), Some(known))]);
                    continue;
                }
            }
            times.extend([start, middle]);
        }
        resolved
    }

    /// How the argument moves up to a distance from a time, and the polynomials that say so: those that are known, if they tell.
    fn look(&mut self, t: f64, radius: f64, known: Option<Rc<Expanded>>, out: &mut Vec<f64>) -> (Found, Rc<Expanded>) {
        let Local { explorer, argument, slots, errors } = self;
        let mut of = |expanded: &Expanded| -> Option<Vec<Option<Moves>>> {
            (0..slots.len()).map(|i| expanded.moves(i, errors[i], (t, radius), out)).collect()
        };
        let told = known.and_then(|known| Some((of(&known)?, known)));
        let (found, known) = told.unwrap_or_else(|| {
            explorer.expand(t);
            let slots = (0..slots.len()).map(|i| explorer.expanded(i).map(<[f64]>::to_vec)).collect();
            let new = Expanded { centre: t, radius, slots };
            (of(&new).unwrap_or_default(), Rc::new(new))
        });
        let position = |slot: usize| slots.iter().position(|&s| s == slot);
        let how = |slot: usize| found.get(position(slot)?).copied().flatten();
        let turn = |slot: usize| {
            let at = position(slot).and_then(|i| Some((known.slots.get(i)?.as_ref()?, errors[i])));
            at.is_none_or(|(c, error)| {
                let mut here = Vec::new();
                shift(c, t - known.centre, 1.0, &mut here);
                changes_sign(&here, radius, error)
            })
        };
        let moves = match argument.varies(how, turn) {
            None => Found::Moderate,
            Some(_) if argument.is_lost(how) => {
                // Between the samples it may be known better than there: u² is, where u = 0.
                let here = explorer.values(t);
                let known = |slot: usize| {
                    let error = here.get(position(slot)?)?.as_ref().map_or(f64::INFINITY, |x| x.error);
                    how(slot).map(|moves| Moves { error: CERTAIN * error, ..moves })
                };
                if argument.is_lost(known) { Found::Nothing } else { Found::Much }
            }
            Some(_) => Found::Much,
        };
        (moves, known)
    }
}

impl Core {
    /// Compiles a search for where some resolved expressions vary rapidly; those that are not known do so nowhere.
    pub(super) fn rapid_search(
        self: &Arc<Core>,
        graph: &Graph,
        resolved: &[Option<Expr>],
    ) -> Result<RapidSearch, FlowError> {
        let known: Vec<Expr> = resolved.iter().flatten().copied().collect();
        let states = self.orbit.as_ref().map_or(&[][..], |orbit| &orbit.field.states);
        let within = Within::new(graph, &known, |leaf| *leaf == self.time || states.contains(leaf));
        let mut of = within.of.into_iter();
        let of = resolved.iter().map(|e| e.and_then(|_| of.next()).unwrap_or_default()).collect();
        let program = Arc::new(self.compile(graph, &within.slots)?);
        let watched = |argument| Watched { argument, found: OnceLock::new() };
        let watched = within.arguments.into_iter().map(watched).collect();
        Ok(RapidSearch { core: Arc::clone(self), program, watched, of, gaps: OnceLock::new() })
    }
}
