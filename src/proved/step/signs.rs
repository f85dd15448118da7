//! ± in a step: one sign for both choices of which it must follow.
//!
//! **In:** a step among whose assumptions or equations ± stands. **Out:** the answer for each choice, and that of both together. A sign
//! among the assumptions is one with that of the claim; under one of the two the assumptions may not be possible.

use super::definitions::Definitions;
use super::{Decided, Pairs, Step};
use crate::agreement::answer;
use crate::findings::standing::Decision;
use crate::findings::{IdentityAccount, IdentityEvidence};
use crate::latex::Relation;
use proof::{Identity, Reason};

/// The accounts of both choices of a sign that stands among the assumptions.
fn both_signs(upper: IdentityAccount, lower: IdentityAccount) -> IdentityAccount {
    let worse = |a: &IdentityAccount| match a.finding.decision() {
        Decision::Refuted => 3,
        Decision::Undecided => 2,
        Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed => u8::from(!a.finding.is_whole()),
    };
    let (mut first, second) = if worse(&upper) >= worse(&lower) { (upper, lower) } else { (lower, upper) };
    if first.finding.is_proved_in_part() {
        first.log2_error = first.log2_error.zip(second.log2_error).map(|(a, b)| a.max(b) + 1.0);
        let lists = [
            (&mut first.conditions, second.conditions),
            (&mut first.exceptions, second.exceptions),
            (&mut first.given_only_where, second.given_only_where),
        ];
        for (list, more) in lists {
            let new: Vec<_> = more.into_iter().filter(|line| !list.contains(line)).collect();
            list.extend(new);
        }
        // Each sign has certificates of its own.
        first.evidence.certificates.clear();
        first.evidence.no_certificate = Some("each sign of an assumption is a case of its own".to_owned());
        first.assumptions = None;
    }
    first.finding = first.finding.clone().and(second.finding);
    first
}

impl Step<'_> {
    /// The answer where both sides are one expression: whether it has a value somewhere, where what is given holds.
    ///
    /// # Errors
    /// A description of the contradiction, if the two routes disagree.
    pub fn of_one_expression(mut self, equations: &Pairs) -> Result<IdentityAccount, String> {
        // A sign that stands in what is given is one of two: some must be possible.
        let signs: &[Option<i64>] = if self.assumes_sign() { &[Some(1), Some(-1)] } else { &[None] };
        let mut last = None;
        for &sign in signs {
            self.sign = sign;
            let gathered = self.gather(None);
            let premises = self.premises(&gathered, equations, Definitions::All);
            let (identity, evidence) = answer(&mut self.graph, equations, &premises, None)?;
            let account = self.of_identity(identity, evidence);
            if account.finding.is_whole() {
                return Ok(account);
            }
            last = Some(account);
        }
        last.ok_or_else(|| "a sign that is neither".to_owned())
    }

    /// Whether ± stands among the assumptions of the claim.
    pub(super) fn assumes_sign(&self) -> bool {
        self.claim.assuming.iter().flat_map(|w| &w.value.relations).any(Relation::chooses_sign)
    }

    /// Whether the step is one for each sign that stands among the assumptions, and no sign was put in yet.
    pub(super) fn is_of_each_sign(&mut self) -> bool {
        let assumes = self.sign.is_none() && self.assumes_sign();
        assumes && (self.claim.branches_throughout || !self.names_other_times())
    }

    /// Whether a value at a fixed time, or of a field at another place, stands in the step or in what it follows from. A sign that is chosen
    /// point by point may be another one there: x = ±t² and x(1) = 1 leave x = t|t|.
    pub(super) fn names_other_times(&mut self) -> bool {
        let mut of = vec![self.claim];
        of.extend(self.claims_named());
        let mut roots = Vec::new();
        for one in of {
            let (equations, signs) = self.said(one).unwrap_or_default();
            roots.extend(equations.iter().flat_map(|&(l, r)| [l, r]));
            let assumed = one.assuming.iter().flat_map(|w| &w.value.relations);
            for relation in assumed.chain(signs) {
                roots.extend(self.scalars(relation).into_iter().flat_map(|(l, r)| [l, r]));
            }
        }
        let leaves = self.graph.leaves_within(roots);
        leaves.iter().any(|l| l.instant.is_some() || self.graph.place(l.symbol).is_some())
    }

    /// A sign that stands among the assumptions is one with that of the claim: it must follow for both.
    ///
    /// Of a sign that is chosen point by point this is so where everything is said of one time and place: on an interval that is short enough
    /// one of the two residuals vanishes, with its derivatives.
    pub(super) fn for_each_sign(self, decide: impl Fn(Self) -> Option<Decided>) -> Option<Decided> {
        let mut all: Option<IdentityAccount> = None;
        for value in [1, -1] {
            let mut step = Step::of(self.derivation, self.claim)?.with(self.plain);
            (step.sign, step.inequalities) = (Some(value), self.inequalities);
            let one = match decide(step)? {
                Ok(account) => account,
                Err(defect) => return Some(Err(defect)),
            };
            // Under one sign the assumptions may not be possible.
            if one.evidence.contradiction {
                continue;
            }
            all = Some(match all {
                None => one,
                Some(before) => both_signs(before, one),
            });
        }
        let contradiction = || {
            let mut step = Step::of(self.derivation, self.claim)?;
            let evidence = IdentityEvidence { contradiction: true, ..IdentityEvidence::default() };
            Some(step.of_identity(Identity::Undecided(Reason::Contradiction), evidence))
        };
        all.or_else(contradiction).map(Ok)
    }

    /// Equations with one sign in place of ±.
    pub(super) fn branch(&mut self, equations: &Pairs, value: i64) -> Pairs {
        let sign = self.claim.scope.branch_sign();
        let graph = &mut self.graph;
        let mut put = |e| graph.rewrite(e, |g, l| (l == sign).then(|| g.integer(value)));
        equations.iter().map(|&(l, r)| (put(l), put(r))).collect()
    }
}
