//! Two motions are the same: their states, at every time that both have.
//!
//! On common stretches the difference of the two enclosures is a model again, so that only what is not known of the states
//! counts, and not how far they move.

use super::cover::Along;
use super::pair::Asked;
use super::ready::{POINTS, Ready, Shown, median};
use crate::expr::{Leaf, Symbol};
use crate::flow::{Compiled, Enclosure};
use crate::number::{Interval, NoValue};
use crate::verdict::{Enclosed, Witness};
use claim::program::Part;
use reason::{Enclosing, Place, Plain, Reason, Refutation};

/// Stretches are halved down to this part of the common span.
const SHORTEST: f64 = 1e-6;
/// Most stretches that are looked at.
const MOST: usize = 4_000;

/// The states of two motions.
pub(super) struct Same {
    names: Vec<String>,
    theirs: (Enclosure, Compiled),
    ours: Compiled,
    /// What both have.
    span: (f64, f64),
    precision: f64,
}

impl Same {
    /// # Errors
    /// What one of the motions does not know, or why one is not enclosed.
    pub fn new(asked: &Asked, part: &Part, other: usize, of: &[Symbol], along: &mut Along) -> Result<Same, Reason> {
        let ready = Ready::new(asked.program, part, along, asked.claim)?;
        if ready.is_restricted() {
            return Err(Plain::MotionsUnderAssumptions.into());
        }
        let mut enclosure = (asked.other)(other, &mut along.graph)?;
        let (mut exprs, mut names) = (Vec::new(), Vec::new());
        for &symbol in of {
            for component in 0..along.graph.component_count(symbol) {
                let leaf = Leaf::now(symbol, component as u16);
                exprs.push(along.graph.leaf(leaf));
                names.push(format!("{} of both motions", along.graph.leaf_latex(leaf)));
            }
        }
        let theirs = enclosure.compile(&mut along.graph, &exprs).map_err(Reason::quoted)?;
        let ours = along.enclosure.compile(&mut along.graph, &exprs).map_err(Reason::quoted)?;
        if let Some(stop) = enclosure.stop() {
            return Err(Reason::quoted(stop));
        }
        let (a, b) = enclosure.reach();
        let span = (along.span.0.max(a), along.span.1.min(b));
        if span.0 >= span.1 {
            return Err(Plain::NoTimeInCommon.into());
        }
        Ok(Same { names, theirs: (enclosure, theirs), ours, span, precision: asked.claim.precision })
    }

    /// The difference of every state, and its size.
    fn compared(&self, along: &Along, time: Interval) -> Vec<Result<(Interval, f64), NoValue>> {
        let enclosure = &self.theirs.0;
        let ours = along.enclosure.over(&self.ours, &along.enclosure.stretch(time));
        let theirs = enclosure.over(&self.theirs.1, &enclosure.stretch(time));
        let each = ours.into_iter().zip(theirs).map(|(a, b)| {
            let (a, b) = (a?, b?);
            Ok((a.minus(&b)?, a.range().magnitude() + b.range().magnitude()))
        });
        each.collect()
    }

    /// The steps of both.
    fn pieces(&self, along: &Along) -> Vec<Interval> {
        let mut times = along.enclosure.boundaries();
        times.extend(self.theirs.0.boundaries());
        times.retain(|t| self.span.0 < *t && *t < self.span.1);
        times.extend([self.span.0, self.span.1]);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times.windows(2).filter_map(|w| Interval::new(w[0], w[1]).ok()).collect()
    }

    /// Where they differ for certain at a time.
    fn apart(&self, along: &Along, t: f64) -> Option<Witness> {
        let time = Interval::point(t);
        let compared = self.compared(along, time);
        let at = compared.iter().position(|c| c.as_ref().is_ok_and(|(difference, _)| !difference.contains(0.0)))?;
        let difference = compared[at].as_ref().ok()?.0;
        let ours = along.enclosure.value(&self.ours, time).swap_remove(at).ok()?;
        let theirs = self.theirs.0.value(&self.theirs.1, time).swap_remove(at).ok()?;
        let (left, right, bound) = (ours.mid(), theirs.mid(), difference.width());
        Some(Witness { t, formula: self.names[at].clone(), left, right, bound, values: Vec::new() })
    }

    /// That they are closer than the precision at all times.
    pub fn always(&self, along: &mut Along) -> Shown {
        let mut todo = self.pieces(along);
        let every = todo.len().div_ceil(POINTS).max(1);
        let sizes = todo.iter().step_by(every).map(|time| {
            let there = self.compared(along, Interval::point(time.mid()));
            there.iter().flatten().map(|(_, size)| *size).fold(0.0, f64::max)
        });
        let room = self.precision * median(sizes.collect());
        todo.reverse();
        let (mut looked, mut largest) = (0, 0.0_f64);
        while let Some(time) = todo.pop() {
            looked += 1;
            let mut open = None;
            for (name, compared) in self.names.iter().zip(self.compared(along, time)) {
                match compared {
                    Ok((d, _)) if d.magnitude() <= room => largest = largest.max(d.magnitude()),
                    Ok((d, _)) => {
                        // Not to within a precision: they differ.
                        if !d.contains(0.0)
                            && let Some(witness) = self.apart(along, time.mid())
                        {
                            let reason = lie_apart(&witness).into();
                            return Shown::Fails(witness, reason);
                        }
                        let name = name.as_str().into();
                        open = Some(Enclosing::StateNotApart { name, from: d.lo(), to: d.hi() });
                        break;
                    }
                    Err(reason) => {
                        open = Some(Enclosing::StateHasNoValue(name.as_str().into(), reason));
                        break;
                    }
                }
            }
            let Some(why) = open else { continue };
            let middle = time.mid();
            let (first, second) = (Interval::new(time.lo(), middle), Interval::new(middle, time.hi()));
            let short = time.width() < SHORTEST * (self.span.1 - self.span.0);
            let (false, true, Ok(first), Ok(second)) = (short, looked < MOST, first, second) else {
                return Shown::Nothing(Reason::from(why).placed(Place::Stretch(time.lo(), time.hi())));
            };
            todo.extend([second, first]);
        }
        let scale = if self.precision > 0.0 { room / self.precision } else { room };
        let reason = Enclosing::EveryCommonTime { stretches: looked, gap: largest };
        Shown::Holds(Enclosed { places: looked, gap: largest, scale }, reason.into())
    }

    /// A time at which they differ for certain.
    ///
    /// # Errors
    /// That none was found.
    pub fn refuted(&self, along: &mut Along, sampled: &Witness) -> Result<(Witness, Refutation), Reason> {
        let near = self.apart(along, sampled.t).map(|w| Witness { values: sampled.values.clone(), ..w });
        let pieces = self.pieces(along);
        let every = pieces.len().div_ceil(POINTS).max(1);
        let found = near.or_else(|| pieces.iter().step_by(every).find_map(|time| self.apart(along, time.mid())));
        let found = found.ok_or(Enclosing::MotionsOverlap(sampled.t))?;
        let reason = lie_apart(&found);
        Ok((found, reason))
    }
}

fn lie_apart(witness: &Witness) -> Refutation {
    Refutation::Apart { motions: true, t: witness.t }
}
