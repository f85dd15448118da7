//! When what a step came to is the verdict on its claim: the only place where that is decided.
//!
//! **In:** what a claim says of itself, what follows from it, its verdicts on motions, and what its step came to. **Out:** a verdict for
//! all values, which counts in sums and in how a run ends; or none.
//!
//! | the claim | its step is its verdict |
//! |---|---|
//! | is a postulate | never |
//! | is tried on nothing | always |
//! | applies to none of the motions that it is tried on | where the step is decided |
//! | says what it follows from, or is about parameters alone; and fails on no motion | where the step is refuted: it holds there by the values that letters happen to have |
//! | else | never: on motions it may hold by their starts, or by their parameters |
//!
//! **A postulate** is given nothing, and either something follows from it, or it says that it is one (`postulate = true`): what a file
//! stands on is not asked to be proved. What the paper concludes, and what has an expectation of its own, is none.

use crate::account::{ClaimAccount, IdentityAccount};
use crate::standing::Decision;
use crate::words::{self, Word};
use derivation::{Claim, Derivation, Form};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use verdict::Outcome;

/// On what a claim is tried, as far as its step is concerned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum TrialScope {
    /// On nothing.
    #[default]
    Nothing,
    /// On motions or families.
    Motions,
    /// On these; but it says what it follows from, or is about parameters alone.
    AsStep,
}

/// What makes the step of a claim its verdict, and what is expected then.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct AloneAccount {
    /// The word that the derivation file expects of a claim that is tried on nothing, if it expects one.
    #[serde(deserialize_with = "words::expected")]
    pub expected: Option<Word>,
    /// Whether it is stated, and not derived.
    pub postulated: bool,
    /// On what it is tried.
    pub scope: TrialScope,
}

/// The claims of a file from which another one follows, by their positions.
#[derive(Clone, Debug, Default)]
pub struct Premises(BTreeSet<usize>);

impl Premises {
    /// Those of a file.
    pub fn of(derivation: &Derivation) -> Premises {
        Premises(derivation.claims.iter().flat_map(|c| derivation.claims_among(&c.follows_from)).collect())
    }
}

impl AloneAccount {
    /// Of a claim from which something follows.
    pub fn of(claim: &Claim) -> Option<AloneAccount> {
        (!claim.is_tried() || claim.postulate).then(|| AloneAccount {
            expected: claim.expect_alone,
            postulated: claim.postulate || is_free(claim),
            scope: TrialScope::Nothing,
        })
    }

    /// Of a claim of a file, by its position; `None` for claims over ranges.
    pub fn within(derivation: &Derivation, premises: &Premises, at: usize) -> Option<AloneAccount> {
        let claim = derivation.claims.get(at).filter(|claim| claim.region.is_none())?;
        let scope = match claim.is_tried() {
            false => TrialScope::Nothing,
            true if claim.follows_from.is_empty() && !is_about_parameters(derivation, claim) => TrialScope::Motions,
            true => TrialScope::AsStep,
        };
        let postulated = claim.postulate || premises.0.contains(&at) && is_free(claim);
        Some(AloneAccount { expected: claim.expect_alone, postulated, scope })
    }
}

/// Whether a claim relates parameters alone, whatever moves.
fn is_about_parameters(derivation: &Derivation, claim: &Claim) -> bool {
    let mut sides = Vec::new();
    for form in &claim.forms {
        let Form::Always(w) = form else { return false };
        let relations = w.value.relations.iter();
        sides.extend(relations.flat_map(|r| r.left.components.iter().chain(&r.right.components).copied()));
    }
    let (graph, scope) = (&derivation.graph, &claim.scope);
    let leaves = graph.leaves_within(sides);
    let is_parameter = |l: &expr::Leaf| {
        let placed = graph.coordinate(*l).is_some() || graph.is_field(l.symbol);
        !placed && !scope.moves(l) && scope.time() != Some(*l) && *l != scope.branch_sign()
    };
    !leaves.is_empty() && claim.assuming.is_empty() && leaves.iter().all(is_parameter)
}

/// Whether nothing is given to a claim, nothing is expected of it by itself, and the paper does not conclude it.
fn is_free(claim: &Claim) -> bool {
    claim.follows_from.is_empty() && claim.assuming.is_empty() && claim.expect_alone.is_none() && !claim.conclusion
}

impl IdentityAccount {
    /// What a claim comes to for which the step is the verdict: what is left out, assumed on the way, or not proved itself, leaves it
    /// open.
    fn word(&self) -> Option<&'static str> {
        match self.finding.decision() {
            Decision::Refuted => Some("fails"),
            Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed | Decision::Undecided => {
                self.is_proved_by_postulates().then_some("holds")
            }
        }
    }
}

impl ClaimAccount {
    /// What a claim came to of which the step is the verdict; `None` for others, see the module.
    pub fn verdict_alone(&self) -> Option<&'static str> {
        let alone = self.alone.filter(|alone| !alone.postulated)?;
        let word = self.identity.as_ref().and_then(IdentityAccount::word);
        let outcomes = || self.verdicts().map(|judged| judged.verdict.outcome());
        let nowhere = || outcomes().next().is_some() && outcomes().all(|o| matches!(o, Outcome::NotApplicable(_)));
        match alone.scope {
            // Nothing is asked of a step of which nothing is expected.
            TrialScope::Nothing => word.or(alone.expected.map(|_| "undecided")),
            TrialScope::Motions | TrialScope::AsStep if nowhere() => word,
            TrialScope::AsStep if outcomes().all(|o| o.truth() != Some(false)) => word.filter(|word| *word == "fails"),
            TrialScope::Motions | TrialScope::AsStep => None,
        }
    }

    /// Whether the verdict of a step is not as expected; without an expectation, whether the step is refuted.
    pub fn is_unexpected_alone(&self) -> bool {
        let expected = self.alone.and_then(|alone| alone.expected);
        self.verdict_alone().is_some_and(|word| expected.map_or(word == "fails", |expected| expected != word))
    }
}
