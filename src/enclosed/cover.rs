//! A span of time, covered by stretches that are halved until something is known of each.

use std::cell::{Cell, OnceCell};
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::ready::Shown;
use crate::expr::{Expr, Graph};
use crate::flow::{Compiled, Enclosure, Reach, Reaches, Sharp, Stretch};
use crate::number::{Interval, NoValue};
use reason::{Enclosing, Place, Plain, Reason};

/// Stretches are halved down to this part of the span.
const SHORTEST: f64 = 1e-6;
/// After first integrals were of no use so often for a claim, they are not asked again.
const PATIENCE: usize = 4;
/// Most operations on models that are spent on one claim along one motion, and on a set of its presuppositions.
const MOST: usize = 400_000;

/// Expressions of all claims, as one tape on which they share what they have in common.
#[derive(Default)]
struct Sheet {
    roots: Vec<Expr>,
    place: HashMap<Expr, usize>,
    compiled: Option<Compiled>,
}

impl Sheet {
    fn add(&mut self, e: Expr) -> usize {
        *self.place.entry(e).or_insert_with(|| {
            self.roots.push(e);
            self.roots.len() - 1
        })
    }
}

/// Some of the roots of all claims.
pub(super) struct Selection {
    roots: Vec<usize>,
    /// What they need of the tape, and nothing else.
    part: OnceCell<Compiled>,
    /// The same with the first integrals of the motion, where these may help.
    sharp: OnceCell<Option<Sharp>>,
    /// How often they did not.
    idle: Cell<usize>,
}

impl Selection {
    pub fn new(roots: Vec<usize>) -> Selection {
        Selection { roots, part: OnceCell::new(), sharp: OnceCell::new(), idle: Cell::new(0) }
    }

    /// The same, for which first integrals are of no use.
    pub fn blunt(roots: Vec<usize>) -> Selection {
        Selection { sharp: OnceCell::from(None), ..Selection::new(roots) }
    }

    pub fn roots(&self) -> &[usize] {
        &self.roots
    }
}

/// Times, as bits.
type Times = (u64, u64);

fn key(time: Interval) -> Times {
    (time.lo().to_bits(), time.hi().to_bits())
}

/// An enclosed motion, with what was found out about it before.
pub(super) struct Along {
    pub enclosure: Enclosure,
    pub graph: Graph,
    pub span: (f64, f64),
    /// What is looked at over stretches, and what at times.
    differences: Sheet,
    sides: Sheet,
    /// The stretches to begin with: on them all claims are evaluated at once.
    pieces: Vec<Interval>,
    first: HashSet<Times>,
    stretches: HashMap<Times, Rc<Stretch>>,
    shared: HashMap<Times, Rc<Reaches>>,
    middles: HashMap<Times, Rc<Vec<Result<Interval, NoValue>>>>,
    /// Operations that may still be spent on this claim, beyond what all share.
    left: usize,
    /// What was shown of hypotheses, which is the same for every claim that presupposes them.
    presupposed: HashMap<Presupposed, Shown>,
}

/// What a hypothesis and its selectors look at, as it is written, and the bits of the precision.
pub(super) type Presupposed = (Vec<usize>, String, u64);

/// What is known of one stretch.
pub(super) enum Judgement {
    /// Enough.
    Settled,
    /// Not enough, and why.
    Open(Reason),
    /// What makes the rest superfluous.
    Stop(Reason),
}

/// The ranges of all roots over one stretch.
pub(super) type Ranges = [Result<Reach, NoValue>];

impl Along {
    pub fn new(enclosure: Enclosure, graph: Graph, span: (f64, f64)) -> Along {
        let pieces = pieces(&enclosure, span);
        Along {
            enclosure,
            graph,
            span,
            differences: Sheet::default(),
            sides: Sheet::default(),
            first: pieces.iter().map(|&time| key(time)).collect(),
            pieces,
            stretches: HashMap::new(),
            shared: HashMap::new(),
            middles: HashMap::new(),
            left: MOST,
            presupposed: HashMap::new(),
        }
    }

    /// The place of an expression among those that are looked at over stretches.
    ///
    /// # Errors
    /// Why the motion does not know it.
    pub fn difference(&mut self, e: Expr) -> Result<usize, Reason> {
        let resolved = self.enclosure.resolved(&mut self.graph, e).map_err(Reason::quoted)?;
        Ok(self.differences.add(resolved))
    }

    /// The place of an expression among those that are looked at at times.
    ///
    /// # Errors
    /// Why the motion does not know it.
    pub fn side(&mut self, e: Expr) -> Result<usize, Reason> {
        let resolved = self.enclosure.resolved(&mut self.graph, e).map_err(Reason::quoted)?;
        Ok(self.sides.add(resolved))
    }

    /// What stands at a place of what is looked at over stretches, in basic leaves.
    pub fn difference_at(&self, place: usize) -> Expr {
        self.differences.roots[place]
    }

    /// Compiles what was asked for so far.
    ///
    /// # Errors
    /// What the motion does not know.
    pub fn compile(&mut self) -> Result<(), Reason> {
        for sheet in [&mut self.differences, &mut self.sides] {
            let compiled = self.enclosure.compile_resolved(&self.graph, &sheet.roots);
            sheet.compiled = Some(compiled.map_err(Reason::quoted)?);
        }
        Ok(())
    }

    /// Another claim: the work may begin anew.
    pub fn refill(&mut self) {
        self.left = MOST;
    }

    /// What is shown of a hypothesis, found once with work of its own.
    pub fn presuppose(&mut self, key: Presupposed, find: impl FnOnce(&mut Along) -> Shown) -> Shown {
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
    pub fn incomplete(&self) -> Option<Reason> {
        let (from, to) = self.enclosure.reach();
        if from <= self.span.0 && self.span.1 <= to {
            return None;
        }
        Some(match self.enclosure.stop() {
            Some(stop) => Reason::quoted(stop),
            None => Plain::DoesNotReachSpan.into(),
        })
    }

    /// The stretches to begin with.
    pub fn pieces(&self) -> &[Interval] {
        &self.pieces
    }

    /// The ranges of some roots over a stretch.
    pub fn over(&mut self, selection: &Selection, time: Interval) -> Vec<Result<Reach, NoValue>> {
        let Some(all) = &self.differences.compiled else {
            return vec![Err(NoValue::Unsupported); selection.roots.len()];
        };
        let part = selection.part.get_or_init(|| all.part(&selection.roots));
        let key = key(time);
        if !self.first.contains(&key) {
            self.left = self.left.saturating_sub(part.operations());
            let stretch = self.stretch(time);
            return self.enclosure.over(part, &stretch);
        }
        let known = self.shared.get(&key).cloned();
        let ranges = known.unwrap_or_else(|| {
            let stretch = Rc::new(self.enclosure.stretch(time));
            self.stretches.insert(key, Rc::clone(&stretch));
            let new = Rc::new(self.enclosure.packed(all, &stretch));
            self.shared.insert(key, Rc::clone(&new));
            new
        });
        selection.roots.iter().map(|&root| ranges.get(root)).collect()
    }

    /// Bounds made sharper by first integrals; `None` where there is no use in trying.
    ///
    /// The theorem is about quantities that are continuous, so that only what has a range already is looked at.
    fn sharper(
        &mut self,
        selection: &Selection,
        time: Interval,
        ranges: &Ranges,
    ) -> Option<Vec<Result<Reach, NoValue>>> {
        if !self.enclosure.conserves() || selection.idle.get() >= PATIENCE {
            return None;
        }
        let (enclosure, graph, differences) = (&self.enclosure, &mut self.graph, &self.differences);
        let quantities = || selection.roots.iter().map(|&root| differences.roots[root]).collect::<Vec<_>>();
        let sharp = selection.sharp.get_or_init(|| enclosure.sharp(graph, &quantities()).ok()).as_ref()?;
        let stretch = self.stretch(time);
        let (found, work) = self.enclosure.sharpened(sharp, &stretch);
        let work = work + sharp.operations();
        self.left = self.left.saturating_sub(work);
        let both = ranges.iter().zip(found).map(|(&known, new)| match (known, new) {
            (Ok(known), Ok(new)) => Ok(new.and(&known)),
            (known, _) => known,
        });
        Some(both.collect())
    }

    /// The values of all sides at the middle of a stretch.
    pub fn at_middle(&mut self, time: Interval) -> Rc<Vec<Result<Interval, NoValue>>> {
        let key = key(time);
        if let Some(known) = self.middles.get(&key) {
            return Rc::clone(known);
        }
        let stretch = self.stretch(time);
        let all = self.sides.compiled.as_ref();
        let new = Rc::new(all.map_or(Vec::new(), |all| self.enclosure.value_at_middle(all, &stretch)));
        self.middles.insert(key, Rc::clone(&new));
        new
    }

    /// The values of some sides at a time.
    pub fn sides_at(&self, places: &[usize], t: f64) -> Vec<Result<Interval, NoValue>> {
        let Some(all) = &self.sides.compiled else { return vec![Err(NoValue::Unsupported); places.len()] };
        self.enclosure.value(&all.part(places), Interval::point(t))
    }

    /// The states over a stretch: expanded once for all claims.
    fn stretch(&mut self, time: Interval) -> Rc<Stretch> {
        let key = key(time);
        let known = self.stretches.get(&key).cloned();
        known.unwrap_or_else(|| {
            let new = Rc::new(self.enclosure.stretch(time));
            self.stretches.insert(key, Rc::clone(&new));
            new
        })
    }

    /// Looks at stretches until each is settled: how many there were. `hopeless` is asked at a single time of a stretch that
    /// is open: if it is true even there, no shorter stretch could help.
    ///
    /// # Errors
    /// The first stretch that could not be settled, and why.
    pub fn cover(
        &mut self,
        selection: &Selection,
        mut judge: impl FnMut(Interval, &Ranges) -> Judgement,
        hopeless: impl Fn(&Ranges) -> bool,
    ) -> Result<usize, Reason> {
        let shortest = SHORTEST * (self.span.1 - self.span.0);
        let mut todo = self.pieces.clone();
        todo.reverse();
        let mut looked = 0;
        while let Some(time) = todo.pop() {
            if self.left == 0 {
                return Err(Enclosing::WorkLimit { operations: MOST, at: time.lo() }.into());
            }
            looked += 1;
            let ranges = self.over(selection, time);
            let mut why = match judge(time, &ranges) {
                Judgement::Settled => continue,
                Judgement::Stop(reason) => return Err(reason),
                Judgement::Open(why) => why,
            };
            if let Some(ranges) = self.sharper(selection, time, &ranges) {
                why = match judge(time, &ranges) {
                    Judgement::Settled => {
                        selection.idle.set(0);
                        continue;
                    }
                    Judgement::Stop(reason) => return Err(reason),
                    Judgement::Open(why) => why,
                };
                selection.idle.set(selection.idle.get() + 1);
            }
            let middle = time.mid();
            if self.first.contains(&key(time)) {
                let now = Interval::point(middle);
                let ranges = self.over(selection, now);
                if hopeless(&ranges) && self.sharper(selection, now, &ranges).is_none_or(|ranges| hopeless(&ranges)) {
                    return Err(why.placed(Place::Time(middle)));
                }
            }
            let (first, second) = (Interval::new(time.lo(), middle), Interval::new(middle, time.hi()));
            let short = time.hi() - time.lo() < shortest || middle <= time.lo() || middle >= time.hi();
            let (false, Ok(first), Ok(second)) = (short, first, second) else {
                return Err(why.placed(Place::Stretch(time.lo(), time.hi())));
            };
            todo.extend([second, first]);
        }
        Ok(looked)
    }
}

/// Steps of the enclosure, and of the angles, as far as they go.
fn pieces(enclosure: &Enclosure, span: (f64, f64)) -> Vec<Interval> {
    let reach = enclosure.reach();
    let (from, to) = (span.0.max(reach.0), span.1.min(reach.1));
    let mut times = enclosure.boundaries();
    times.extend(enclosure.angle_boundaries());
    times.retain(|t| from < *t && *t < to);
    times.extend([from, to]);
    times.sort_by(f64::total_cmp);
    times.dedup();
    times.windows(2).filter_map(|w| Interval::new(w[0], w[1]).ok()).collect()
}
