//! Audit: replays the recorded proofs of a report, without the prover.
//!
//! **In:** a [`ProofFile`], and who knows what the claims ask. **Out:** [`Audit`]: for each claim the sequent in words, what was replayed, what the proof rests on, or the step that is
//! refused. **Guaranteed:** nothing that the file says of a proof is believed: the checker makes each step again. What is taken on trust is
//! named: that the sequents are what the derivation file says, and the claims of which no proof is recorded.

use super::proof_file::{ProofFile, RecordedClaim, UnrecordedClaim};
use super::recorded::shown_words;
use checker::Shown;
use diag::escape::in_one_line;
use findings::Grounds;
use serde_json::{Value, json};

/// Units of work of a letter of a sequent.
const WORK_OF_A_LETTER: u64 = 40;

/// The outcome of one relation.
#[derive(Clone, Debug, PartialEq)]
pub enum Replayed {
    /// The checker made every step again.
    Shown(Box<Shown>),
    /// A step that it refused, counted from 1; nothing for a record that cannot be read at all.
    Refused {
        /// The step.
        step: Option<usize>,
        /// The condition that is not met.
        why: String,
    },
}

/// One relation of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct AuditedRelation {
    /// The sequent in words.
    pub sequent: String,
    /// What the replay came to.
    pub outcome: Replayed,
}

/// Where the sequents of a claim come from: whether they are what its derivation file says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Provenance {
    /// The file is not at hand, or is another one by now.
    OnTrust,
    /// They were written anew from the file, and are the same.
    AsInFile,
    /// They are others, or the file has no such claim.
    Otherwise,
}

/// One claim.
#[derive(Clone, Debug, PartialEq)]
pub struct AuditedClaim {
    /// `id`, or `id/reading`.
    pub claim: String,
    /// What the report says of it.
    pub standing: String,
    /// What the proof assumes beside what the claim does, since what it follows from does.
    pub presupposed: Vec<String>,
    /// Whether this is what the derivation file asks.
    pub stated: Provenance,
    /// What the proof assumes at all times between two, and the claim at those that it chooses.
    pub throughout: Vec<String>,
    /// Its relations.
    pub relations: Vec<AuditedRelation>,
}

/// The proofs of a report, replayed.
#[derive(Clone, Debug, PartialEq)]
pub struct Audit {
    /// The id of the derivation.
    pub derivation: String,
    /// Claims with recorded proofs.
    pub claims: Vec<AuditedClaim>,
    /// Claims without.
    pub unrecorded: Vec<UnrecordedClaim>,
    /// Whether the sum of the file is that of its content.
    pub has_its_sum: bool,
}

/// Replays the proofs of a file, each within the work that the proof of a claim may take, and all within that of a file. `stated`: whether
/// a claim's proof proves what the derivation file asks.
pub fn audit(file: &ProofFile, stated: &dyn Fn(&RecordedClaim) -> Provenance) -> Audit {
    let has_its_sum = file.sum == file.right_sum();
    let limits = meter::Limits::default().of_file(0);
    let claims = file.proofs.iter().map(|recorded| {
        meter::piece(meter::Task::Proving, &limits, || audited(recorded, stated)).unwrap_or_else(|ended| {
            let outcome = Replayed::Refused { step: None, why: ended.to_string() };
            AuditedClaim {
                claim: recorded.claim.clone(),
                standing: recorded.standing.clone(),
                presupposed: Vec::new(),
                stated: Provenance::OnTrust,
                throughout: Vec::new(),
                relations: vec![AuditedRelation { sequent: "not replayed".to_owned(), outcome }],
            }
        })
    });
    Audit {
        claims: claims.collect(),
        derivation: file.derivation.clone(),
        unrecorded: file.unrecorded.clone(),
        has_its_sum,
    }
}

/// Replays the proof of a claim. The words of its sequents count as memory that it takes.
fn audited(recorded: &RecordedClaim, stated: &dyn Fn(&RecordedClaim) -> Provenance) -> AuditedClaim {
    let RecordedClaim { claim, standing, proof } = recorded;
    // The sequent is that of the first relation; the others claim something else of the same.
    let is_first = proof.relations.first().is_none_or(|first| first.claim == proof.sequent.claim);
    let relations = proof.relations.iter().map(|relation| {
        let sequent = proof.sequent_of(relation);
        let outcome = match is_first {
            true => checker::replay(&sequent, &relation.steps).map_or_else(
                |refused| Replayed::Refused { step: refused.step.map(|s| s + 1), why: refused.why },
                |shown| Replayed::Shown(Box::new(shown)),
            ),
            false => Replayed::Refused {
                step: None,
                why: "the sequent claims something else than its first relation".to_owned(),
            },
        };
        let sequent = sequent.words().unwrap_or_else(|refused| refused.to_string());
        // What is written is read, copied and printed.
        meter::charge(WORK_OF_A_LETTER * sequent.len() as u64);
        meter::grow(4 * sequent.len() as u64);
        AuditedRelation { sequent, outcome }
    });
    AuditedClaim {
        relations: relations.collect(),
        presupposed: proof.presupposed_words(),
        throughout: proof.throughout_words(),
        claim: claim.clone(),
        standing: standing.clone(),
        stated: stated(recorded),
    }
}

impl Provenance {
    /// The word in JSON.
    fn word(self) -> &'static str {
        match self {
            Provenance::OnTrust => "on trust",
            Provenance::AsInFile => "as in the file",
            Provenance::Otherwise => "otherwise",
        }
    }
}

impl AuditedClaim {
    /// Whether every step of every relation was made again, none is missing, and the file asks nothing else.
    pub fn is_replayed(&self) -> bool {
        self.stated != Provenance::Otherwise
            && !self.relations.is_empty()
            && self.relations.iter().all(|r| matches!(r.outcome, Replayed::Shown(_)))
    }
}

impl AuditedClaim {
    /// The number of cases that are left out.
    pub fn left_out(&self) -> usize {
        let of = |relation: &AuditedRelation| match &relation.outcome {
            Replayed::Shown(shown) => shown.leaves_out().len(),
            Replayed::Refused { .. } => 0,
        };
        self.relations.iter().map(of).sum()
    }
}

impl Audit {
    /// Whether all that is recorded was replayed.
    pub fn is_replayed(&self) -> bool {
        self.has_its_sum && self.claims.iter().all(AuditedClaim::is_replayed)
    }

    /// The audit for people.
    pub fn text(&self) -> String {
        // What the file says may have lines that look like some of this report.
        let mut out = format!("{}\n", in_one_line(&self.derivation));
        for claim in &self.claims {
            let word = match (claim.is_replayed(), claim.left_out()) {
                (false, _) => "REFUSED".to_owned(),
                (true, 0) => Grounds::Checker.word().to_owned(),
                (true, cases) => format!("{}, cases left out: {cases}", Grounds::CheckerBut(cases).word()),
            };
            let (name, standing) = (in_one_line(&claim.claim), in_one_line(&claim.standing));
            out += &format!("\n  {name}  {word} (the report says: {standing})\n");
            if claim.stated == Provenance::Otherwise {
                out += "    refused: the derivation file asks something else of this claim, or has no such claim\n";
            }
            if !claim.presupposed.is_empty() {
                let all = in_one_line(&claim.presupposed.join(", "));
                out += &format!("    Presupposed, as what the claim follows from does: {all}\n");
            }
            if !claim.throughout.is_empty() {
                let all = in_one_line(&claim.throughout.join(", "));
                out += &format!("    Of times between which these are so throughout: {all}\n");
            }
            for relation in &claim.relations {
                out += &format!("    {}\n", in_one_line(&relation.sequent));
                out += &match &relation.outcome {
                    Replayed::Shown(shown) => format!("      {}\n", shown_words(shown)),
                    Replayed::Refused { step: Some(step), why } => {
                        format!("      step {step} is refused: {}\n", in_one_line(why))
                    }
                    Replayed::Refused { step: None, why } => format!("      refused: {}\n", in_one_line(why)),
                };
            }
        }
        let replayed = self.claims.iter().filter(|claim| claim.is_replayed()).count();
        out += &format!("\n{replayed} of {} recorded claims are replayed.\n", self.claims.len());
        if !self.has_its_sum {
            out += "Refused: the file was changed after it was written; its sum is another.\n";
        }
        out += match self.claims.iter().all(|claim| claim.stated == Provenance::AsInFile) {
            true => {
                "Each sequent was written anew from the derivation file, and is the same. On trust: how formulas are read, the words of the \
                     report, the theorems that the rules name.\n"
            }
            false => {
                "On trust: that the sequents say what, and all that, the derivation file says, which is not at hand as it was; the words of \
                      the report; the theorems that the rules name.\n"
            }
        };
        if !self.unrecorded.is_empty() {
            out += &format!("Proved, and not recorded: these rest on the prover alone ({}):\n", self.unrecorded.len());
            for UnrecordedClaim { claim, standing, why } in &self.unrecorded {
                let [claim, standing, why] = [claim, standing, why].map(|text| in_one_line(text));
                out += &format!("  {claim} ({standing}): {why}\n");
            }
        }
        out
    }

    /// The audit as JSON.
    pub fn json(&self) -> Value {
        let relation = |relation: &AuditedRelation| match &relation.outcome {
            Replayed::Shown(shown) => json!({
                "sequent": relation.sequent,
                "outcome": "replayed",
                "steps": shown.steps(),
                "rests_on": shown.rests_on(),
                "leaves_out": shown.leaves_out().len(),
                "exact": shown.log2_error() == f64::NEG_INFINITY,
            }),
            Replayed::Refused { step, why } => {
                json!({ "sequent": relation.sequent, "outcome": "refused", "step": step, "why": why })
            }
        };
        let claim = |claim: &AuditedClaim| {
            json!({
                "claim": claim.claim,
                "standing": claim.standing,
                "replayed": claim.is_replayed(),
                "stated": claim.stated.word(),
                "leaves_out": claim.left_out(),
                "presupposed": claim.presupposed,
                "throughout": claim.throughout,
                "relations": claim.relations.iter().map(relation).collect::<Vec<_>>(),
            })
        };
        json!({
            "derivation": self.derivation,
            "has_its_sum": self.has_its_sum,
            "claims": self.claims.iter().map(claim).collect::<Vec<_>>(),
            "unrecorded": self.unrecorded,
        })
    }
}
