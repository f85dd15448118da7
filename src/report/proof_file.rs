//! `proofs.json`: the proofs of a report as steps that anybody can replay.
//!
//! **In:** an account. **Out:** a text: for each claim that is proved, the sequents and the steps of its proofs, or why there are none. **Guaranteed:**
//! nothing of the prover is wanted to replay it: see [`checker`].

use super::tally::name;
use checker::ProofRecord;
use derivation::Derivation;
use findings::{Account, Recorded};
use serde::{Deserialize, Serialize};

/// The name of the file in the folder of a report.
pub const PROOFS: &str = "proofs.json";
/// The version of its layout.
pub const PROOF_SCHEMA: u32 = 1;

/// The proofs of a report.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProofFile {
    /// The version of the layout, [`PROOF_SCHEMA`].
    pub schema: u32,
    /// The id of the derivation.
    pub derivation: String,
    /// SHA-256 of the derivation file.
    pub sha256: String,
    /// Claims whose proofs are recorded.
    pub proofs: Vec<RecordedClaim>,
    /// Claims that the prover proves and of which no proof is recorded.
    pub unrecorded: Vec<UnrecordedClaim>,
}

/// A claim with its proofs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordedClaim {
    /// `id`, or `id/reading`.
    pub claim: String,
    /// What the report says of it: `proved`, `proved except`, `proved given`.
    pub standing: String,
    /// Its proofs.
    pub proof: ProofRecord,
}

/// A claim without recorded proofs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct UnrecordedClaim {
    /// `id`, or `id/reading`.
    pub claim: String,
    /// What the report says of it.
    pub standing: String,
    /// Why no proof is recorded.
    pub why: String,
}

/// The text of `proofs.json`, of an account for which proofs were looked for.
pub fn proofs(derivation: &Derivation, account: &Account) -> String {
    let mut file = ProofFile {
        schema: PROOF_SCHEMA,
        derivation: derivation.id.clone(),
        sha256: derivation.sha256.clone(),
        proofs: Vec::new(),
        unrecorded: Vec::new(),
    };
    for of in &account.claims {
        let Some(identity) = &of.identity else { continue };
        let (claim, standing) = (name(of), identity.standing().to_owned());
        match &identity.recorded {
            Some(Recorded::Proof(proof, _)) => {
                file.proofs.push(RecordedClaim { claim, standing, proof: ProofRecord::clone(proof) });
            }
            Some(Recorded::Not(why)) => file.unrecorded.push(UnrecordedClaim { claim, standing, why: why.clone() }),
            None => {}
        }
    }
    diag::escape::in_json(&super::json::text(&file))
}
