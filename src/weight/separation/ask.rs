//! How conditions stand on motions, as far as that is asked.
//!
//! **In:** conditions, compiled, and the motions of a check. **Out:** how a condition stands on a motion: met, not met, or
//! undecided, exactly as a claim would be judged there.
//!
//! Most conditions fail on most motions at once: a few points show it. What is not refuted there is judged like any claim,
//! with a search between the samples, which costs more than everything else; so that is done only for what can matter for
//! some claim. A condition that is met somewhere where a claim fails, and not met somewhere where it holds, explains nothing of
//! it, whatever the other motions say.

use std::collections::{BTreeSet, HashMap};

use super::candidates::{self, Candidate};
use crate::derivation::{Claim, DEFAULT_PRECISION, Derivation};
use crate::expr::FastMap;
use crate::findings::Account;
use crate::flow::Points;
use crate::verdict::Possible;
use claim::comparison::judge;
use claim::program::{Program, What};
use meter::{Limits, Task};
use sampled::recall::Recall;
use sampled::trace::{Trace, Trial};
use sampled::trial::try_claim;

/// Points of a motion at which a condition is tried first.
const FIRST: usize = 8;

/// What is known of a condition on a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stand {
    /// It was not refuted at a few points; more was not asked.
    Open,
    /// Met, not met, or undecided.
    Judged(Option<bool>),
}

/// Conditions and motions.
pub(super) struct Ask<'a> {
    pub derivation: &'a Derivation,
    pub candidates: &'a [Candidate],
    /// One for each of the candidates and initial time.
    pub programs: &'a [Vec<Program>],
    pub start_of: &'a [usize],
    pub recall: &'a dyn Recall,
    pub limits: &'a Limits,
}

/// How every condition stands on every motion.
pub(super) struct Stands {
    /// `[candidate][column]`.
    all: Vec<Vec<Stand>>,
}

/// The columns of the motions on which a claim holds, and of those on which it fails.
#[derive(Clone, Debug)]
pub(super) struct Sides {
    pub holds: Vec<usize>,
    pub fails: Vec<usize>,
}

impl Ask<'_> {
    /// Tries every condition at a few points of every motion.
    pub fn first(&self, traces: &[Trace]) -> Stands {
        let try_all = |trace: &Trace| -> Vec<Stand> {
            let few = few(trace);
            let refuted = |k: usize| self.program(k, trace).is_some_and(|p| is_refuted(p, &few));
            let each = (0..self.candidates.len()).map(refuted);
            each.map(|refuted| if refuted { Stand::Judged(Some(false)) } else { Stand::Open }).collect()
        };
        // What is not looked at is not known.
        let on_one = |trace: &Trace, limits: &Limits| {
            let found = meter::piece(Task::Weighing, limits, || try_all(trace));
            found.unwrap_or_else(|_| vec![Stand::Judged(None); self.candidates.len()])
        };
        let columns = meter::each(self.limits, traces, on_one);
        let of = |k: usize| columns.iter().map(|column| column[k]).collect();
        Stands { all: (0..self.candidates.len()).map(of).collect() }
    }

    fn program(&self, k: usize, trace: &Trace) -> Option<&Program> {
        self.programs.get(k)?.get(*self.start_of.get(trace.trajectory)?)
    }

    /// Puts in what is known of the claims that say what a condition says: a file is not told two things of one formula.
    pub fn known(&self, stands: &mut Stands, traces: &[Trace], account: &Account) {
        let columns: FastMap<&str, usize> = traces
            .iter()
            .enumerate()
            .map(|(c, t)| (self.derivation.trajectories[t.trajectory].id.as_str(), c))
            .collect();
        let says = |claim: &Claim| candidates::said(&self.derivation.graph, claim);
        let conditions: HashMap<_, usize> = self
            .candidates
            .iter()
            .enumerate()
            .map(|(k, of)| (says(&of.claim), k))
            .filter(|(s, _)| !s.is_empty())
            .collect();
        // Where more or less than at every time is meant, it is another condition.
        let plain = |c: &&Claim| {
            c.at.is_none() && c.assuming.is_empty() && !c.branches_throughout && c.precision == DEFAULT_PRECISION
        };
        let declared: FastMap<_, &Claim> =
            self.derivation.claims.iter().filter(plain).map(|c| ((c.id.as_str(), c.reading.as_deref()), c)).collect();
        for of in &account.claims {
            let declared = declared.get(&(of.id.as_str(), of.reading.as_deref()));
            let Some(&k) = declared.and_then(|claim| conditions.get(&says(claim))) else { continue };
            for pair in &of.results {
                if let Some(&column) = columns.get(pair.trajectory.as_str()) {
                    stands.all[k][column] = Stand::Judged(pair.verdict.is_met());
                }
            }
        }
    }

    /// Judges what is asked for: candidates and columns.
    pub fn judge(&self, stands: &mut Stands, asked: &BTreeSet<(usize, usize)>, traces: &[Trace]) {
        // Long motions first: what is left at the end is short.
        let mut order: Vec<(usize, usize)> = asked.iter().copied().collect();
        order.sort_by_key(|(_, column)| std::cmp::Reverse(traces[*column].motion.steps()));
        let judged = |&(k, column): &(usize, usize), limits: &Limits| {
            meter::piece(Task::Weighing, limits, || self.standing(k, &traces[column])).unwrap_or_default()
        };
        let found: Vec<Option<bool>> = meter::each(self.limits, &order, judged);
        for ((k, column), met) in order.into_iter().zip(found) {
            stands.all[k][column] = Stand::Judged(met);
        }
    }

    fn standing(&self, k: usize, trace: &Trace) -> Option<bool> {
        let candidate = self.candidates.get(k)?;
        let name = &candidate.name;
        let says = [name.id.as_deref(), Some(&name.formula), name.says.as_deref()].map(Option::unwrap_or_default);
        self.recall.standing(self.derivation, &says, trace.trajectory, &|| self.tried(k, &candidate.claim, trace))
    }

    fn tried(&self, k: usize, claim: &Claim, trace: &Trace) -> Option<bool> {
        let program = self.program(k, trace)?;
        let trial = Trial { graph: &self.derivation.graph, claim, program, trace, shown: false };
        try_claim(self.derivation, &trial, None).is_met()
    }
}

/// A few points, spread evenly.
fn few(trace: &Trace) -> Points {
    let count = trace.points.len();
    let used = count.min(FIRST);
    (0..used).map(|i| trace.points.row(i * count.saturating_sub(1) / used.max(2).saturating_sub(1))).collect()
}

/// Whether a condition is violated at one of the points, whatever the size of its terms elsewhere: then it fails.
fn is_refuted(program: &Program, points: &Points) -> bool {
    if !program.selectors.is_empty() || !program.hypotheses.is_empty() || program.at.is_some() || program.is_branching()
    {
        return false;
    }
    let measured = program.measure((points, points.len()), 1.0);
    let mut first = 0;
    for part in &program.parts {
        let group = &part.group;
        let of = &measured[first.min(measured.len())..(first + group.comparisons.len()).min(measured.len())];
        first += group.comparisons.len();
        if !matches!(part.what, What::Every | What::Constant) || group.formula.is_some() {
            continue;
        }
        for point in 0..points.len() {
            // Where one of them has no value, none counts.
            let all =
                of.iter().zip(&group.comparisons).map(|(series, c)| Some((c.kind, series.difference(point).ok()?)));
            let Some(all) = all.collect::<Option<Vec<_>>>() else { continue };
            // With a size of 0 nothing is small: what is violated then is so for every size.
            let violated = |(kind, difference): &(_, _)| judge(*kind, *difference, 0.0, 0.0) == Possible::FALSE;
            if all.iter().any(violated) {
                return true;
            }
        }
    }
    false
}

impl Stands {
    fn at(&self, k: usize, column: usize) -> Stand {
        self.all[k][column]
    }

    fn open<'s>(
        &'s self,
        k: usize,
        columns: impl Iterator<Item = &'s usize> + 's,
    ) -> impl Iterator<Item = (usize, usize)> + 's {
        columns.filter(move |c| self.at(k, **c) == Stand::Open).map(move |c| (k, *c))
    }

    /// Whether a condition may be met wherever a claim holds, and unmet somewhere where it fails; or unmet wherever it fails,
    /// and met somewhere where it holds. What is undecided, or was not asked, may be anything.
    pub fn may_explain(&self, k: usize, sides: &Sides) -> bool {
        let (met, unmet) = (Stand::Judged(Some(true)), Stand::Judged(Some(false)));
        let may_be = |columns: &[usize], not: Stand| columns.iter().all(|c| self.at(k, *c) != not);
        let somewhere = |columns: &[usize], not: Stand| columns.iter().any(|c| self.at(k, *c) != not);
        let necessary = may_be(&sides.holds, unmet) && somewhere(&sides.fails, met);
        let sufficient = may_be(&sides.fails, met) && somewhere(&sides.holds, unmet);
        necessary || sufficient
    }

    /// What has to be judged next to know whether a condition explains something of a claim; nothing when that is known. One motion
    /// after the other: most conditions are settled by the first few.
    pub fn asked(&self, k: usize, sides: &Sides) -> Option<(usize, usize)> {
        if !self.may_explain(k, sides) {
            return None;
        }
        let unmet = Stand::Judged(Some(false));
        let necessary = sides.holds.iter().all(|c| self.at(k, *c) != unmet);
        let tells = sides.fails.iter().any(|c| self.at(k, *c) == unmet);
        // What is necessary must be met wherever the claim holds, once it is known to tell something; what is sufficient, unmet
        // wherever it fails.
        match necessary && tells {
            true => self.open(k, sides.holds.iter().chain(&sides.fails)).next(),
            false => self.open(k, sides.fails.iter().chain(&sides.holds)).next(),
        }
    }

    /// What is left to be judged of a condition.
    pub fn left(&self, k: usize) -> Vec<(usize, usize)> {
        (0..self.all[k].len()).filter(|c| self.at(k, *c) == Stand::Open).map(|c| (k, c)).collect()
    }

    /// How a condition stands on every motion; what was not asked is undecided.
    pub fn truth(&self, k: usize) -> super::Truth {
        let of = |stand: &Stand| match stand {
            Stand::Judged(met) => *met,
            Stand::Open => None,
        };
        self.all[k].iter().map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MET: Stand = Stand::Judged(Some(true));
    const UNMET: Stand = Stand::Judged(Some(false));

    #[test]
    fn only_what_may_explain_is_asked() {
        let sides = Sides { holds: vec![0, 1], fails: vec![2, 3] };
        let asked = |stands: [Stand; 4]| Stands { all: vec![stands.to_vec()] }.asked(0, &sides);
        let open = Stand::Open;
        // Unmet where the claim holds and met where it fails: nothing that the others say matters.
        assert_eq!(asked([UNMET, open, MET, open]), None);
        // Met wherever it holds so far, unmet on one that fails: all must be known, those on which it holds first.
        assert_eq!(asked([open, MET, UNMET, open]), Some((0, 0)));
        assert_eq!(asked([MET, MET, UNMET, open]), Some((0, 3)));
        // Unmet on one that holds: only what fails matters, one after the other.
        assert_eq!(asked([UNMET, open, open, open]), Some((0, 2)));
        assert_eq!(asked([UNMET, open, UNMET, UNMET]), Some((0, 1)));
        // It may be met everywhere: then it tells nothing.
        assert_eq!(asked([open, open, open, MET]), Some((0, 2)));
        assert_eq!(asked([open, open, MET, MET]), None);
        // Undecided may be anything.
        let undecided = Stand::Judged(None);
        assert_eq!(asked([undecided, MET, UNMET, open]), Some((0, 3)));
    }
}
