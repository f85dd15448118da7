//! `proofs.json`: the proofs of a report as steps that anybody can replay.
//!
//! **In:** an account. **Out:** a text: for each claim that is proved, the sequents and the steps of its proofs, or why there are none. **Guaranteed:**
//! nothing of the prover is wanted to replay it: see [`checker`].

use super::tally::{declared, name};
use checker::ProofRecord;
use derivation::{Claim, Derivation};
use findings::{Account, ClaimAccount};
use rayon::prelude::*;
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

/// The text of `proofs.json`; `record` finds the steps of the proof of a claim, or says why there are none.
pub fn proofs(
    derivation: &Derivation,
    account: &Account,
    record: impl Fn(&Claim) -> Result<ProofRecord, String> + Sync,
) -> String {
    let mut file = ProofFile {
        schema: PROOF_SCHEMA,
        derivation: derivation.id.clone(),
        sha256: derivation.sha256.clone(),
        proofs: Vec::new(),
        unrecorded: Vec::new(),
    };
    let is_proved = |account: &&ClaimAccount| account.identity.as_ref().is_some_and(|i| i.finding.is_proved_in_part());
    let proved: Vec<&ClaimAccount> = account.claims.iter().filter(is_proved).collect();
    let recorded: Vec<_> = proved.par_iter().with_max_len(1).map(|of| declared(derivation, of).map(&record)).collect();
    for (account, recorded) in proved.into_iter().zip(recorded) {
        let standing = account.identity.as_ref().map_or("", |identity| identity.standing()).to_owned();
        let claim = name(account);
        match recorded {
            Some(Ok(proof)) => file.proofs.push(RecordedClaim { claim, standing, proof }),
            Some(Err(why)) => file.unrecorded.push(UnrecordedClaim { claim, standing, why }),
            None => {}
        }
    }
    diag::escape::in_json(&super::json::text(&file))
}
