//! A span of time, covered by stretches that are halved until something is known of each.

use std::collections::HashMap;
use std::sync::Arc;

use crate::expr::{Expr, Graph};
use crate::flow::{Compiled, Enclosure, Reach, Stretch};
use crate::number::{Interval, NoValue};

/// Degree of the polynomials in time.
const DEGREE: usize = 10;
/// Stretches are halved down to this part of the span.
const SHORTEST: f64 = 1e-6;
/// Most operations on series that are spent on one claim along one motion, and on its presuppositions.
const MOST: usize = 400_000;

/// An enclosed motion, with the stretches that were looked at before.
pub(super) struct Along {
    pub enclosure: Enclosure,
    pub graph: Graph,
    pub span: (f64, f64),
    stretches: HashMap<(u64, u64), Arc<Stretch>>,
    /// Operations that may still be spent.
    left: usize,
    /// Whether sets of equations hold to a precision, which is the same for every claim that presupposes them.
    presupposed: HashMap<Presupposed, Result<(), String>>,
}

/// Differences of equations with the sizes of their terms, and the bits of the precision.
pub(super) type Presupposed = (Vec<Expr>, u64);

/// What is known of one stretch.
pub(super) enum Judgement {
    /// Enough.
    Settled,
    /// Not enough, and why.
    Open(String),
    /// What makes the rest superfluous.
    Stop(String),
}

/// The ranges of all roots over one stretch.
pub(super) type Ranges = [Result<Reach, NoValue>];

impl Along {
    pub fn new(enclosure: Enclosure, graph: Graph, span: (f64, f64)) -> Along {
        let (stretches, presupposed) = (HashMap::new(), HashMap::new());
        Along { enclosure, graph, span, stretches, left: MOST, presupposed }
    }

    /// Another claim: the work may begin anew.
    pub fn refill(&mut self) {
        self.left = MOST;
    }

    /// What is known of a presupposition, found once with work of its own.
    pub fn presuppose(
        &mut self,
        key: Presupposed,
        find: impl FnOnce(&mut Along) -> Result<(), String>,
    ) -> Result<(), String> {
        if let Some(known) = self.presupposed.get(&key) {
            return known.clone();
        }
        let left = std::mem::replace(&mut self.left, MOST);
        let found = find(self);
        self.left = left;
        self.presupposed.insert(key, found.clone());
        found
    }

    /// Why the span is not enclosed as a whole.
    pub fn incomplete(&self) -> Option<String> {
        let (from, to) = self.enclosure.reach();
        if from <= self.span.0 && self.span.1 <= to {
            return None;
        }
        Some(match self.enclosure.stop() {
            Some(stop) => stop.to_string(),
            None => "the enclosure does not reach as far as the span".to_owned(),
        })
    }

    /// The stretches to begin with: steps of the enclosure, and of the angles.
    pub fn pieces(&self) -> Vec<Interval> {
        let (from, to) = self.span;
        let mut times = self.enclosure.boundaries();
        times.extend(self.enclosure.angle_boundaries());
        times.retain(|t| from < *t && *t < to);
        times.extend([from, to]);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times.windows(2).filter_map(|w| Interval::new(w[0], w[1]).ok()).collect()
    }

    /// The ranges of the roots over a stretch.
    pub fn over(&mut self, compiled: &Compiled, time: Interval) -> Vec<Result<Reach, NoValue>> {
        self.left = self.left.saturating_sub(2 * compiled.operations());
        let stretch = self.stretch(time);
        self.enclosure.over(compiled, &stretch)
    }

    /// The values of the roots at the middle of a stretch.
    pub fn at_middle(&mut self, compiled: &Compiled, time: Interval) -> Vec<Result<Interval, NoValue>> {
        let stretch = self.stretch(time);
        self.enclosure.value_at_middle(compiled, &stretch)
    }

    /// The states over a stretch: expanded once for all claims.
    fn stretch(&mut self, time: Interval) -> Arc<Stretch> {
        let key = (time.lo().to_bits(), time.hi().to_bits());
        let known = self.stretches.get(&key).cloned();
        known.unwrap_or_else(|| {
            let new = Arc::new(self.enclosure.stretch(time, DEGREE));
            self.stretches.insert(key, Arc::clone(&new));
            new
        })
    }

    /// Looks at stretches until each is settled: how many there were.
    ///
    /// # Errors
    /// The first stretch that could not be settled, and why.
    pub fn cover(
        &mut self,
        compiled: &Compiled,
        mut judge: impl FnMut(Interval, &Ranges) -> Judgement,
    ) -> Result<usize, String> {
        let shortest = SHORTEST * (self.span.1 - self.span.0);
        let mut todo = self.pieces();
        todo.reverse();
        let mut looked = 0;
        while let Some(time) = todo.pop() {
            if self.left == 0 {
                return Err(format!("the work limit of {MOST} operations was reached at t = {:.6}", time.lo()));
            }
            looked += 1;
            let ranges = self.over(compiled, time);
            let why = match judge(time, &ranges) {
                Judgement::Settled => continue,
                Judgement::Stop(reason) => return Err(reason),
                Judgement::Open(why) => why,
            };
            let middle = time.mid();
            let (first, second) = (Interval::new(time.lo(), middle), Interval::new(middle, time.hi()));
            let short = time.hi() - time.lo() < shortest || middle <= time.lo() || middle >= time.hi();
            let (false, Ok(first), Ok(second)) = (short, first, second) else {
                return Err(format!("on [{:.6}, {:.6}] {why}", time.lo(), time.hi()));
            };
            todo.extend([second, first]);
        }
        Ok(looked)
    }
}
