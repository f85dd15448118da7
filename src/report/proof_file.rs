//! `proofs.json`: the proofs of a report as steps that anybody can replay.
//!
//! **In:** an account. **Out:** a text: for each claim that is proved, the sequents and the steps of its proofs, or why there are none. **Guaranteed:**
//! nothing of the prover is wanted to replay it: see [`checker`].

use super::fingerprint::Fingerprint;
use super::tally::name;
use checker::ProofRecord;
use derivation::Derivation;
use diag::values::{MOST_VALUES, bounded};
use findings::{Account, Recorded};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use sha2::{Digest, Sha256};

/// The name of the file in the folder of a report.
pub const PROOFS: &str = "proofs.json";
/// The version of its layout.
pub const PROOF_SCHEMA: u32 = 2;

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
    /// SHA-256 of all the rest, so that no change of a word passes unseen. Who writes another sum is not stopped by it.
    pub sum: String,
}

impl ProofFile {
    /// The proofs in a text.
    ///
    /// # Errors
    /// A sentence: the text is no `proofs.json`, or one of another version.
    pub fn read(text: &[u8]) -> Result<ProofFile, String> {
        let not = |error: serde_json::Error| format!("this is no proofs.json: {error}");
        bounded(text, MOST_VALUES).map_err(|why| format!("this is no proofs.json: {why}"))?;
        let file: ProofFile = serde_json::from_slice(text).map_err(not)?;
        match file.schema {
            // What is not understood is not passed over.
            PROOF_SCHEMA if !file.says_all_of(text) => {
                Err("this is no proofs.json: it has a key that is not known".to_owned())
            }
            PROOF_SCHEMA => Ok(file),
            other => Err(format!("the layout {other} of proofs.json is not known")),
        }
    }

    /// Whether a text says this and no more.
    fn says_all_of(&self, text: &[u8]) -> bool {
        let sum = |text: &[u8]| serde_json::from_slice::<Fingerprint>(text);
        let written = serde_json::to_vec(self).and_then(|own| sum(&own));
        written.is_ok_and(|own| sum(text).is_ok_and(|of| of == own))
    }

    /// The sum that belongs to the rest.
    pub fn right_sum(&self) -> String {
        sum_of(&(self.schema, &self.derivation, &self.sha256, &self.proofs, &self.unrecorded))
    }
}

fn sum_of(rest: &impl Serialize) -> String {
    let mut sum = Sha256::new();
    // What was read from JSON can be written as JSON.
    let written = serde_json::to_writer(&mut sum, rest);
    debug_assert!(written.is_ok());
    sum.finalize().iter().map(|b| format!("{b:02x}")).collect()
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

/// A [`RecordedClaim`] as it is written: its proof is JSON already.
#[derive(Serialize)]
struct WrittenClaim<'a> {
    claim: String,
    standing: &'static str,
    proof: &'a RawValue,
}

/// A [`ProofFile`] as it is written.
#[derive(Serialize)]
struct WrittenFile<'a> {
    schema: u32,
    derivation: &'a str,
    sha256: &'a str,
    proofs: Vec<WrittenClaim<'a>>,
    unrecorded: Vec<UnrecordedClaim>,
    sum: String,
}

/// The text of `proofs.json`, of an account for which proofs were looked for.
pub fn proofs(derivation: &Derivation, account: &Account) -> String {
    let (mut proofs, mut unrecorded) = (Vec::new(), Vec::new());
    for of in &account.claims {
        let Some(identity) = &of.identity else { continue };
        let (claim, standing) = (name(of), identity.standing());
        let json = identity.recorded.as_ref().and_then(Recorded::replayed).map(|of| serde_json::from_str(of.json()));
        match (json, identity.recorded.as_ref().and_then(Recorded::why_not)) {
            (Some(Ok(proof)), _) => proofs.push(WrittenClaim { claim, standing, proof }),
            (_, Some(why)) => {
                unrecorded.push(UnrecordedClaim { claim, standing: standing.to_owned(), why: why.to_owned() });
            }
            _ => {}
        }
    }
    let (derivation, sha256) = (derivation.id.as_str(), derivation.sha256.as_str());
    let sum = sum_of(&(PROOF_SCHEMA, derivation, sha256, &proofs, &unrecorded));
    let file = WrittenFile { schema: PROOF_SCHEMA, derivation, sha256, proofs, unrecorded, sum };
    diag::escape::in_json(super::json::text(&file))
}
