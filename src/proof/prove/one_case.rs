//! One case: its trials over finite fields, and the real points that refute it or are an example.
//!
//! **In:** a case, with everything that was solved put in. **Out:** what becomes of it: it holds, a point refutes it, nothing is left of it, or it stays open. **Guaranteed:** a point
//! counts only where everything given holds for certain, and, of a motion, where one passes through it.

use super::cases::{Outcome, Stop, merge};
use super::{Examination, Pairs};
use crate::conditions::raised;
use crate::field::{Trials, trials};
use crate::generators::Generator;
use crate::insertion::Insertion;
use crate::lowering::question;
use crate::outcome::{Options, Point, Proof, Reason, Wanted};
use crate::sign::Facts;
use crate::solve::{Resolved, closed, insert_definitions};
use crate::witness::{Found, Scene, decimals, refutation, targets, values_at, vanishing};
use expr::{Expr, FastMap, Leaf};
use number::Draws;
use std::cell::Cell;

/// Signs by which one case is taken apart.
const MOST_SIGNS_SPLIT: usize = 3;

impl Examination<'_> {
    /// What becomes of one case: trials over finite fields, then real points.
    pub(super) fn case(&mut self, case: &Resolved, options: &Options) -> Outcome {
        let map = closed(self.graph, &case.definitions);
        if self.clashes(&map) {
            return Outcome::Empty(Reason::Contradiction);
        }
        let claim = self.lowered.claim.clone();
        let residuals: Vec<Expr> = match case.void {
            // That it divides by 0 is tested like a claim.
            Some(denominator) => vec![denominator],
            None => claim.iter().map(|&(l, r)| self.graph.sub(l, r)).collect(),
        };
        let mut outcome = self.trials(case, &map, residuals.clone(), options, false);
        if case.void.is_some() {
            return match outcome {
                Trials::Vanish(bound) => Outcome::Void(bound),
                Trials::Contradiction => Outcome::Empty(Reason::Contradiction),
                _ => Outcome::Empty(Reason::Degenerate),
            };
        }
        if outcome == Trials::NoValue {
            outcome = self.trials(case, &map, residuals, options, true);
        }
        let mut sides = Pairs::new();
        for &(l, r) in &self.lowered.claim {
            sides.push((insert_definitions(self.graph, &map, l), insert_definitions(self.graph, &map, r)));
        }
        let scene = Scene {
            targets: targets(self.graph, &self.lowered.generators, &map),
            graph: self.graph,
            generators: &self.lowered.generators,
            claim: self.claim,
            lowered: &sides,
            premises: self.premises,
            nonzero: &self.given.nonzero,
            positive: &self.given.positive,
            not_negative: &self.given.not_negative,
            explicit: self.explicit,
            defined: &map,
        };
        match outcome {
            Trials::Vanish(bound) => {
                // Where something vanishes that was divided by, or a sign is another one than an equation asks for, it is another case.
                let pivots: Vec<Expr> = case.pivots.iter().map(|(e, _)| *e).collect();
                let obeyed = |f: &Found| obeys(&scene, &case.definitions, &f.point);
                let belongs = |f: &Found| {
                    let may = || case.unsolved.is_empty() && obeyed(f) != Some(false);
                    vanishing(scene.graph, &pivots, &f.point).is_none() && (f.differs.is_none() || may())
                };
                let most = (self.examples, &*self.closings);
                let found = look(&scene, &mut self.draws, most, belongs, |f| !f.is_empty());
                if let Some(f) = found.iter().find(|f| f.differs.is_some()) {
                    if obeyed(f).is_none() {
                        return Outcome::Open(Reason::Branches { failing: 1, of: 2 });
                    }
                    let sides = f.differs.map(|at| format!("{:?}", f.sides[at])).unwrap_or_default();
                    let what = format!("proved over finite fields, but at a real point: {sides}");
                    return Outcome::Open(Reason::Defect(what));
                }
                Outcome::Holds(Box::new(Proof {
                    log2_error: bound.log2_error,
                    degree_bound: bound.degree,
                    height_bound: bound.height,
                    trials: bound.primes.len(),
                    primes: bound.primes,
                    signs: bound.signs,
                    cases: 1,
                    conditions: Vec::new(),
                    example: found.into_iter().next().map(|f| f.point),
                }))
            }
            Trials::Fail { failing, of } => {
                // An exact point is looked for beyond the first that refutes, for a while; not where any will do.
                let any = options.wanted == Wanted::Proof;
                let enough = |f: &[Found]| {
                    refutation(f).is_some_and(|r| {
                        any || f.len() > 12 || r.left.exact.is_some() && r.right.exact.is_some() && r.second.is_some()
                    })
                };
                let mut passed_over = false;
                let on_a_motion = |f: &Found| {
                    let extends = f.differs.is_none() || self.solutions.extend(scene.graph, &f.point);
                    passed_over |= !extends;
                    extends
                };
                let most = (options.attempts, &*self.closings);
                match refutation(&look(&scene, &mut self.draws, most, on_a_motion, enough)) {
                    Some(refutation) => Outcome::Refuted(Box::new(refutation)),
                    None if passed_over => Outcome::Open(Reason::Unextended),
                    None => {
                        let split = if failing < of { self.split_by_sign(case, options) } else { None };
                        split.unwrap_or(Outcome::Open(Reason::Branches { failing, of }))
                    }
                }
            }
            Trials::Contradiction => Outcome::Empty(Reason::Contradiction),
            Trials::Void(bound) => Outcome::Void(bound),
            Trials::NoValue => Outcome::Empty(Reason::Degenerate),
            Trials::Unsettled(reason) => Outcome::Open(reason),
        }
    }

    /// A case that fails for some choice of signs, and at no real point, taken apart by the first sign in its definitions:
    /// what is given may exclude one of the two. `None` where that does not settle it.
    fn split_by_sign(&mut self, case: &Resolved, options: &Options) -> Option<Outcome> {
        let values: Vec<Expr> = case.definitions.iter().map(|&(_, e)| e).collect();
        let defined = |l: &Leaf| case.definitions.iter().any(|(d, _)| d == l);
        let generators = &self.lowered.generators;
        let is_sign = |l: &Leaf| generators.get(*l) == Some(&Generator::Sign) && !defined(l);
        let split = case.definitions.iter().filter(|(l, _)| generators.get(*l) == Some(&Generator::Sign)).count();
        let leaf = self.graph.leaves(values).into_iter().find(is_sign).filter(|_| split < MOST_SIGNS_SPLIT)?;
        let mut outcomes = Vec::new();
        for value in [1, -1] {
            let mut one = case.clone();
            one.define_sign(leaf, self.graph.integer(value));
            let outcome = self.case(&one, options);
            if let Outcome::Open(_) = outcome {
                return None;
            }
            outcomes.push((one, outcome));
        }
        match merge(outcomes) {
            Ok((proof, _)) => Some(Outcome::Holds(Box::new(proof))),
            Err(Stop::Refuted(refutation)) => Some(Outcome::Refuted(refutation)),
            Err(Stop::Empty(reason, _)) => Some(Outcome::Empty(reason)),
            Err(Stop::Undecided(_)) => None,
        }
    }

    /// The trials of one case; `with_pivots`, choices of signs without a value are left out, where that can be told.
    fn trials(
        &mut self,
        case: &Resolved,
        map: &FastMap<Leaf, Expr>,
        residuals: Vec<Expr>,
        options: &Options,
        with_pivots: bool,
    ) -> Trials {
        let question = question(self.graph, &mut self.lowered, &mut self.probe, (case, map), residuals, with_pivots);
        trials(self.graph, &self.lowered.generators, &question, options, &mut self.draws)
    }

    /// Whether something given as positive is not, by its structure, once the definitions are inserted.
    fn clashes(&mut self, map: &FastMap<Leaf, Expr>) -> bool {
        // An exponential that is solved for is positive, whatever it is solved as.
        let solved: Vec<Expr> = map
            .iter()
            .filter(|(l, _)| matches!(self.lowered.generators.get(**l), Some(Generator::Exponential(_))))
            .map(|(_, &e)| e)
            .collect();
        if solved.iter().any(|&e| {
            let Examination { graph, lowered, probe, .. } = &mut *self;
            lowered.facts.sign_after(graph, &lowered.generators, e, &mut probe.signs).not_positive
        }) {
            return true;
        }
        let Facts { positive, not_negative, .. } = &self.lowered.given_facts;
        let mut facts: Vec<(Expr, bool)> = positive.iter().map(|&e| (e, true)).collect();
        facts.extend(not_negative.iter().map(|&e| (e, false)));
        facts.sort_unstable();
        let mut insertion = Insertion::new(map);
        facts.into_iter().any(|(e, strict)| {
            let image = insertion.put_into(self.graph, e);
            let Examination { graph, lowered, probe, .. } = self;
            let known = lowered.facts.sign_by_parts(graph, &lowered.generators, image, &mut probe.signs);
            known.not_positive && (strict || known.nonzero)
        })
    }
}

/// Whether a point has what was solved for in a case, as far as numbers show; nothing where it depends on a sign that the point does not
/// have.
fn obeys(scene: &Scene<'_>, definitions: &[(Leaf, Expr)], point: &Point) -> Option<bool> {
    let mut graph = scene.graph.clone();
    let apart = definitions.iter().map(|&(leaf, e)| {
        let leaf = graph.leaf(leaf);
        let apart = graph.sub(leaf, e);
        raised(&mut graph, scene.generators, apart)
    });
    let apart: Vec<Expr> = apart.collect();
    let at = decimals(&graph, &apart, &values_at(point));
    match at.iter().flatten().all(|v| v.contains_zero()) {
        true => at.iter().all(Option::is_some).then_some(true),
        false => Some(false),
    }
}

/// Real points of a case that count, and are points for certain.
fn look(
    scene: &Scene<'_>,
    draws: &mut Draws,
    (attempts, closings): (u32, &Cell<u32>),
    mut counts: impl FnMut(&Found) -> bool,
    enough: impl Fn(&[Found]) -> bool,
) -> Vec<Found> {
    let mut found = Vec::new();
    let frame = scene.frame();
    for number in 0..attempts {
        if let Some(f) = scene.attempt(&frame, number, draws)
            && counts(&f)
            && scene.is_certain(&frame, &f, closings)
        {
            found.push(f);
            if enough(&found) {
                break;
            }
        }
    }
    found
}
