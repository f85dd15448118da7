//! Recorded proofs: what a report holds, and their replay.
//!
//! **In:** the sequents of a claim, which differ in what is claimed, and steps for each. **Out:** [`ProofRecord`], and what its replay shows. **Guaranteed:** a
//! record says nothing by itself.

use super::draft::{Refused, Shown, replay};
use super::sequent::Sequent;
use super::step::Step;
use super::term::Relation;
use serde::{Deserialize, Serialize};

/// The proof of one relation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RelationRecord {
    /// What is claimed.
    pub claim: Relation,
    /// The steps.
    pub steps: Vec<Step>,
}

/// Proofs of all relations that a claim says.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ProofRecord {
    /// What is given to all of them; its claim is that of the first.
    pub sequent: Sequent,
    /// The relations, each with its proof.
    pub relations: Vec<RelationRecord>,
    /// Assumptions of the sequent that the claim does not make, and what it follows from does. To be told; the sequent holds them already.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub presupposed: Vec<Relation>,
    /// What the claim assumes at the times that it chooses, and the sequent at all times: the proof says nothing of what lies beyond a time at which one of these is not so. To be told; they are premises of the sequent.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub throughout: Vec<Relation>,
}

impl ProofRecord {
    /// Replays all relations.
    ///
    /// # Errors
    /// The position of the relation, and the step that is refused.
    pub fn shown(&self) -> Result<Vec<Shown>, (usize, Refused)> {
        let each = self.relations.iter().enumerate();
        each.map(|(at, of)| replay(&self.sequent_of(of), &of.steps).map_err(|refused| (at, refused))).collect()
    }

    /// The sequent of a relation.
    pub fn sequent_of(&self, relation: &RelationRecord) -> Sequent {
        Sequent { claim: relation.claim.clone(), ..self.sequent.clone() }
    }
}
