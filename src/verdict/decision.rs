//! Verdicts. There is one door: [`Verdict::decide`].
//!
//! **In:** what a claim says, as a [`Proposition`] over its parts, and a [`Finding`] for each part: what methods of each
//! strength leave possible, with the evidence. **Out:** a [`Verdict`].
//!
//! **Guaranteed.** The fields of a verdict are private to this file, and a finding that lacks the evidence that its word needs
//! is taken for no finding. The proposition is evaluated three times: with what is proved; with what is proved or enclosed;
//! with all. The strongest level that decides it gives the value and the strength. So a conjunction is as strong as its weakest
//! part, a false conjunction as one witness, a negation as what it negates. Two rigorous findings that exclude each other are
//! a defect of the program; the claim then has no verdict. A rigorous finding stands against a sampled one.

use reason::{Plain, Reason};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

use super::evidence::{Evidence, Exclusion, Obstacle, PartShown, Proof, Residuals, Witness};
use super::proposition::Proposition;
use super::truth::{Possible, Truth};

/// How strong the evidence is; ordered, weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Strength {
    /// At finitely many times, residual against its error bound; what lies between was searched.
    Sampled,
    /// For every time in the span, with rounding accounted for (a `fails` or `not-applicable` of this strength is called
    /// certified).
    Enclosed,
    /// For all values.
    Proved,
}

impl Strength {
    const STRONGEST_FIRST: [Strength; 3] = [Strength::Proved, Strength::Enclosed, Strength::Sampled];
}

/// What was found for one claim on one trajectory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Outcome {
    /// The claim holds, with this strength.
    Holds(Strength),
    /// The claim fails, with this strength; a witness is always given.
    Fails(Strength),
    /// An assumption is unmet, or a formula has no real value there; a reason is always given.
    NotApplicable(Strength),
    /// The evidence does not settle it; a reason is always given.
    Undecided,
}

impl Outcome {
    /// The word of the report contract.
    pub fn word(self) -> &'static str {
        match self {
            Outcome::Holds(_) => "holds",
            Outcome::Fails(_) => "fails",
            Outcome::NotApplicable(_) => "not-applicable",
            Outcome::Undecided => "undecided",
        }
    }

    /// Whether it holds; `None` where that is undecided, or it does not apply.
    pub fn truth(self) -> Option<bool> {
        match self {
            Outcome::Holds(_) => Some(true),
            Outcome::Fails(_) => Some(false),
            Outcome::NotApplicable(_) | Outcome::Undecided => None,
        }
    }

    /// The strength in the words of the report contract.
    pub fn strength(self) -> Option<&'static str> {
        match self {
            Outcome::Holds(Strength::Sampled)
            | Outcome::Fails(Strength::Sampled)
            | Outcome::NotApplicable(Strength::Sampled) => Some("sampled"),
            Outcome::Holds(Strength::Enclosed) => Some("enclosed"),
            Outcome::Fails(Strength::Enclosed) | Outcome::NotApplicable(Strength::Enclosed) => Some("certified"),
            Outcome::Holds(Strength::Proved)
            | Outcome::Fails(Strength::Proved)
            | Outcome::NotApplicable(Strength::Proved) => Some("proved"),
            Outcome::Undecided => None,
        }
    }
}

/// What methods found of one part of a claim: what each strength leaves possible, and the evidence for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    sampled: Possible,
    enclosed: Possible,
    proved: Possible,
    evidence: Evidence,
}

impl Finding {
    /// What samples leave possible. What samples say true needs a number of samples, what they say false a witness, anything
    /// else a reason; without it, nothing is known.
    pub fn sampled(known: Possible, evidence: Evidence) -> Finding {
        let complete = match known.decided() {
            Some(Truth::True) => evidence.samples > 0,
            Some(Truth::False) => evidence.witness.is_some(),
            Some(Truth::Void) | None => evidence.reason.is_some(),
        };
        let (known, evidence) = match complete {
            true => (known, evidence),
            false => (Possible::ANY, Evidence { reason: Some(Plain::WithoutEvidence.into()), ..evidence }),
        };
        Finding { sampled: known, enclosed: Possible::ANY, proved: Possible::ANY, evidence }
    }

    /// Nothing is known, for this reason.
    pub fn open(reason: impl Into<Reason>) -> Finding {
        Finding::sampled(Possible::ANY, Evidence::because(reason))
    }

    /// What is left possible at a strength, stronger evidence included; `None` where rigorous evidence contradicts itself.
    pub fn known(&self, strength: Strength) -> Option<Possible> {
        let rigorous = match strength {
            Strength::Proved => return Some(self.proved),
            Strength::Enclosed | Strength::Sampled => self.proved.agreed(self.enclosed)?,
        };
        if strength == Strength::Enclosed {
            return Some(rigorous);
        }
        // What is rigorous stands against samples.
        Some(rigorous.agreed(self.sampled).unwrap_or(rigorous))
    }

    /// Whether rigorous evidence excludes what samples say.
    pub fn overrules_samples(&self) -> bool {
        self.proved.agreed(self.enclosed).is_some_and(|rigorous| rigorous.agreed(self.sampled).is_none())
    }

    /// The evidence.
    pub fn evidence(&self) -> &Evidence {
        &self.evidence
    }
}

/// More parts than these are not weighed against each other one by one.
const MANY: usize = 64;

/// The verdict of one claim (in one reading) on one trajectory, or over its ranges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Kept")]
pub struct Verdict {
    claim: Proposition,
    findings: Vec<Finding>,
    outcome: Outcome,
    evidence: Evidence,
    defect: Option<Reason>,
}

/// A verdict that was kept: what it was decided from, and what was decided.
#[derive(Deserialize)]
struct Kept {
    claim: Proposition,
    findings: Vec<Finding>,
    outcome: Outcome,
    evidence: Evidence,
    defect: Option<Reason>,
}

impl TryFrom<Kept> for Verdict {
    type Error = &'static str;

    /// Decides again: what was kept must say the same.
    fn try_from(kept: Kept) -> Result<Verdict, Self::Error> {
        let Kept { claim, findings, outcome, evidence, defect } = kept;
        let again = Verdict::decide(claim, findings);
        let same = if defect.is_some() { Outcome::Undecided } else { again.outcome };
        if same != outcome || again.defect.is_some() && defect.is_none() {
            return Err("a verdict that does not follow from its evidence");
        }
        Ok(Verdict { outcome, evidence, defect, ..again })
    }
}

impl Verdict {
    /// The verdict on a claim: a proposition over parts, of which each has a finding.
    pub fn decide(claim: Proposition, findings: Vec<Finding>) -> Verdict {
        let mut verdict =
            Verdict { claim, findings, outcome: Outcome::Undecided, evidence: Evidence::default(), defect: None };
        verdict.fold();
        if verdict.findings.len() > MANY {
            // Of many parts the curve of the one that is told is looked at, and all of them would be most of what a verdict takes.
            let told = verdict.evidence.series.as_ref();
            verdict.findings.iter_mut().for_each(|finding| finding.evidence.thin(told));
        }
        verdict
    }

    /// The verdict of a claim that has one part.
    pub fn of(finding: Finding) -> Verdict {
        Verdict::decide(Proposition::Atom(0), vec![finding])
    }

    /// The verdict of a claim over ranges of values, for which `cells` were judged. What is false needs the point at which it is.
    pub fn over_ranges(
        known: Possible,
        strength: Strength,
        cells: usize,
        point: Option<&[(String, f64)]>,
        reason: Reason,
    ) -> Verdict {
        let complete = cells > 0 && (known != Possible::FALSE || point.is_some());
        let known = if complete { known } else { Possible::ANY };
        let evidence = Evidence { samples: cells, ..Evidence::because(reason) };
        let mut finding = Finding { sampled: Possible::ANY, enclosed: Possible::ANY, proved: Possible::ANY, evidence };
        match strength {
            Strength::Proved => finding.proved = known,
            Strength::Enclosed => finding.enclosed = known,
            Strength::Sampled => finding.sampled = known,
        }
        Verdict::of(finding)
    }

    /// What an enclosure leaves possible of a part, in place of what was known of it by enclosures before. The evidence is that of the
    /// part, changed by `change`. What is said true needs [`Evidence::enclosed`], what is said false a witness.
    pub fn enclose(&mut self, part: usize, known: Possible, change: impl FnOnce(&mut Evidence)) {
        let Some(finding) = self.findings.get_mut(part) else { return };
        let mut evidence = finding.evidence.clone();
        change(&mut evidence);
        let complete = match known.decided() {
            Some(Truth::True) => evidence.enclosed.is_some_and(|e| e.places > 0 && e.gap.is_finite()),
            Some(Truth::False) => evidence.witness.is_some(),
            Some(Truth::Void) | None => evidence.reason.is_some(),
        };
        if complete {
            finding.enclosed = known;
            finding.evidence = evidence;
            // One of many that is true decides nothing by itself: that is seen when all are known, see `settle`.
            if self.findings.len() <= MANY || !known.may_be(Truth::True) {
                self.fold();
            }
        }
    }

    /// Decides again, after all parts of a claim have been enclosed.
    pub fn settle(&mut self) {
        self.fold();
    }

    /// A proof, or a refutation for certain values, of a part on this motion. A proof of all values says that the part is true wherever it
    /// has a value; that it has one somewhere is known from elsewhere. What is said false needs a witness.
    pub fn prove(&mut self, part: usize, known: Possible, change: impl FnOnce(&mut Evidence)) {
        let Some(finding) = self.findings.get_mut(part) else { return };
        let mut evidence = finding.evidence.clone();
        change(&mut evidence);
        let complete = match known.may_be(Truth::True) {
            true => evidence.proof.is_some() && !known.may_be(Truth::False),
            false => evidence.witness.is_some() || known == Possible::VOID && evidence.reason.is_some(),
        };
        if complete {
            finding.proved = known;
            finding.evidence = evidence;
            self.fold();
        }
    }

    /// A proof of all that the claim says, on this motion: given what it presupposes, which is not proved by that.
    pub fn prove_claim(&mut self, proof: &Proof) {
        let said: Vec<_> = self.claim.said().into_iter().map(|part| (part, PartShown::IsSo)).collect();
        self.prove_parts(&said, proof);
    }

    /// A proof that parts are so, or are not so, on this motion, wherever they have a value. What is said to be false needs a time at which
    /// it has one: the comparison there is the witness. Where what is presupposed may be false, the proof says nothing of the parts.
    pub fn prove_parts(&mut self, parts: &[(usize, PartShown)], proof: &Proof) {
        let known =
            |part: usize| self.findings.get(part).and_then(|f| f.known(Strength::Sampled)).unwrap_or(Possible::ANY);
        if self.claim.may_not_apply(&mut { known }) {
            return;
        }
        for &(part, shown) in parts {
            let Some(finding) = self.findings.get_mut(part) else { continue };
            let (truth, why) = match shown {
                PartShown::IsSo => (Truth::True, None),
                PartShown::IsNotSo => (Truth::False, Some(Plain::DeniedIsProved)),
                PartShown::IsExcluded => (Truth::False, Some(Plain::SaidIsExcluded)),
            };
            if let Some(why) = why {
                let Some(witness) = finding.evidence.compared() else { continue };
                (finding.evidence.witness, finding.evidence.reason) = (Some(witness), Some(why.into()));
            }
            if shown == PartShown::IsExcluded {
                // Sides that agree to within an error have values, and are not equal for that.
                for seen in [&mut finding.sampled, &mut finding.enclosed] {
                    *seen = seen.or_else(if *seen == Possible::TRUE { Possible::FALSE } else { *seen });
                }
            }
            let was_seen = finding.known(Strength::Sampled) == Some(Possible::TRUE);
            finding.evidence.proof = Some(proof.clone());
            finding.proved = Possible::only(truth).or_else(Possible::VOID);
            let is_decided = finding.known(Strength::Sampled).and_then(Possible::decided).is_some();
            if truth != Truth::False && !was_seen && is_decided {
                // Why it was open is of no interest any more. Where it is not seen to have a value, it is.
                finding.evidence.reason = None;
            }
        }
        self.fold();
    }

    /// Gives up what samples say, of all parts: the sampled motion is not what its bounds say.
    pub fn withdraw_samples(&mut self, reason: &Reason) {
        for finding in &mut self.findings {
            finding.sampled = Possible::ANY;
            if finding.known(Strength::Enclosed).and_then(Possible::decided).is_none() {
                finding.evidence.reason = Some(reason.clone());
            }
        }
        self.fold();
    }

    /// Gives up that samples say that a part is true, or void: what is asked of every time is seen to be open at one.
    pub fn doubt(&mut self, part: usize, reason: Reason) {
        let of_all_times = |f: &&mut Finding| matches!(f.sampled, Possible::TRUE | Possible::VOID);
        if let Some(finding) = self.findings.get_mut(part).filter(of_all_times) {
            finding.sampled = if finding.sampled == Possible::TRUE { Possible::OPEN } else { Possible::ANY };
            finding.evidence.obstacle = Obstacle::of(&reason);
            finding.evidence.reason = Some(reason);
            self.fold();
        }
    }

    /// Adds to what is said of a verdict, without changing it.
    pub fn remark(&mut self, reason: Reason) {
        self.evidence.obstacle = Obstacle::of(&reason);
        self.evidence.reason = Some(reason);
    }

    /// Completes the witness that is shown, and gives another curve where there is one: what is shown, not what it means.
    pub fn show(&mut self, witness: Witness, series: Option<Arc<Residuals>>) {
        if self.evidence.witness.is_some() {
            self.evidence.witness = Some(witness);
            self.evidence.series = series.or(self.evidence.series.take());
        }
    }

    fn fold(&mut self) {
        // What contradicts itself stays without a verdict.
        if self.defect.is_some() {
            return;
        }
        let level = |strength: Strength| -> Option<Possible> {
            let known: Option<Vec<Possible>> = self.findings.iter().map(|f| f.known(strength)).collect();
            let known = known?;
            Some(self.claim.value(&mut |n| known.get(n).copied().unwrap_or(Possible::ANY)))
        };
        let mut decided = None;
        for strength in Strength::STRONGEST_FIRST {
            match level(strength) {
                None => {
                    self.contradict(Plain::CertainBothWays.into());
                    return;
                }
                Some(value) => decided = decided.or(value.decided().map(|truth| (truth, strength))),
            }
        }
        self.outcome = match decided {
            Some((Truth::True, strength)) => Outcome::Holds(strength),
            Some((Truth::False, strength)) => Outcome::Fails(strength),
            Some((Truth::Void, strength)) => Outcome::NotApplicable(strength),
            None => Outcome::Undecided,
        };
        self.evidence = self.told(decided);
        if !matches!(self.outcome, Outcome::Fails(_)) {
            // A witness is one against the claim.
            self.evidence.witness = None;
        }
        // "So wherever it has a value" was shown: that it has one somewhere may be seen by weaker means.
        if let Some((truth @ (Truth::True | Truth::False), weaker)) = decided {
            for strength in [Strength::Proved, Strength::Enclosed].into_iter().filter(|s| *s > weaker) {
                let with_value = |f: &Finding| {
                    let known = f.known(strength)?;
                    let seen = f.known(Strength::Sampled).and_then(Possible::decided).map(Possible::only);
                    Some(seen.filter(|seen| known == seen.or_else(Possible::VOID)).unwrap_or(known))
                };
                let known: Option<Vec<Possible>> = self.findings.iter().map(with_value).collect();
                let value = known.map(|k| self.claim.value(&mut |n| k.get(n).copied().unwrap_or(Possible::ANY)));
                if value == Some(Possible::only(truth)) {
                    self.outcome = match truth {
                        Truth::True => Outcome::Holds(strength),
                        Truth::False | Truth::Void => Outcome::Fails(strength),
                    };
                    break;
                }
            }
        }
    }

    /// The evidence of the part that a reader should see: one that decides by itself, or is itself open; of several the one
    /// with the largest residual in units of its bound.
    fn told(&self, decided: Option<(Truth, Strength)>) -> Evidence {
        let level = decided.map_or(Strength::Sampled, |(_, strength)| strength);
        let known = |n: usize| self.findings.get(n).and_then(|f| f.known(level)).unwrap_or(Possible::ANY);
        let value = |only: Option<usize>, without: Option<usize>| {
            self.claim.value(&mut |n| match (only, without) {
                (Some(only), _) if only != n => Possible::ANY,
                (_, Some(without)) if without == n => Possible::ANY,
                _ => known(n),
            })
        };
        let now = value(None, None);
        let mut parts = self.claim.atoms();
        parts.retain(|&n| n < self.findings.len());
        if parts.len() > MANY {
            return self.told_of_many(&parts, decided, known);
        }
        let tells: Vec<usize> = match decided {
            Some((Truth::True, _)) => parts.iter().copied().filter(|&n| value(None, Some(n)) != now).collect(),
            Some(_) => parts.iter().copied().filter(|&n| value(Some(n), None) == now).collect(),
            None => parts.iter().copied().filter(|&n| known(n).decided().is_none()).collect(),
        };
        // Where several are needed together, each of them tells.
        let tells = match (tells.is_empty(), decided) {
            (false, _) => tells,
            (true, Some(_)) => {
                let needed: Vec<usize> = parts.iter().copied().filter(|&n| value(None, Some(n)) != now).collect();
                let wanted = |n: &usize| decided.is_none_or(|(t, _)| t != Truth::False) || self.has_witness(*n);
                let chosen: Vec<usize> = needed.iter().copied().filter(wanted).collect();
                if chosen.is_empty() { parts.iter().copied().filter(wanted).collect() } else { chosen }
            }
            (true, None) => parts,
        };
        // Of what holds the reader asks how well, and not how well what it presupposes does.
        let said = if matches!(decided, Some((Truth::True, _))) { self.claim.said() } else { Vec::new() };
        let of_said: Vec<usize> = tells.iter().copied().filter(|n| said.contains(n)).collect();
        let tells = if of_said.is_empty() { tells } else { of_said };
        let ratio = |n: &usize| self.findings[*n].evidence.residual.as_ref().map_or(0.0, super::Residual::ratio);
        let worst = tells.into_iter().reduce(|a, b| if ratio(&b) > ratio(&a) { b } else { a });
        match worst {
            Some(n) => self.findings[n].evidence.clone(),
            None => Evidence::because(Plain::NothingToTry),
        }
    }

    /// The same for a claim with very many parts, without asking what each of them does to the whole.
    fn told_of_many(
        &self,
        parts: &[usize],
        decided: Option<(Truth, Strength)>,
        known: impl Fn(usize) -> Possible,
    ) -> Evidence {
        let tells = |n: &&usize| match decided {
            Some((Truth::True, _)) => true,
            Some((Truth::False, _)) => self.has_witness(**n),
            Some((Truth::Void, _)) => known(**n) == Possible::VOID,
            None => known(**n).decided().is_none(),
        };
        match parts.iter().find(tells) {
            Some(&n) => self.findings[n].evidence.clone(),
            None => Evidence::because(Plain::NoPartDecides),
        }
    }

    fn has_witness(&self, part: usize) -> bool {
        self.findings.get(part).is_some_and(|f| f.evidence.witness.is_some())
    }

    /// The stretches on which some part was not compared.
    pub fn exclusions(&self) -> impl Iterator<Item = &Exclusion> {
        self.findings.iter().flat_map(|f| &f.evidence.excluded)
    }

    /// Whether what is said is met throughout: times without a value are not times at which it is.
    pub fn is_met(&self) -> Option<bool> {
        self.outcome().truth().filter(|holds| !holds || self.exclusions().next().is_none())
    }

    /// What was found.
    pub fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// What it rests on.
    pub fn evidence(&self) -> &Evidence {
        &self.evidence
    }

    /// What was found of each part.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Why the claim has no verdict: the program contradicts itself.
    pub fn defect(&self) -> Option<&Reason> {
        self.defect.as_ref()
    }

    /// Two ways to the same number contradict each other.
    pub fn contradict(&mut self, reason: Reason) {
        self.outcome = Outcome::Undecided;
        self.evidence = Evidence::because(reason.clone());
        self.defect = Some(reason);
    }
}

#[cfg(test)]
mod tests {
    use super::Proposition::{And, Atom};
    use super::*;
    use crate::Enclosed;

    fn witness() -> Option<Witness> {
        Some(Witness { t: 0.0, formula: String::new(), left: 0.0, right: 1.0, bound: 0.0, values: Vec::new() })
    }

    fn held() -> Finding {
        Finding::sampled(Possible::TRUE, Evidence { samples: 3, ..Evidence::default() })
    }

    fn failed() -> Finding {
        Finding::sampled(Possible::FALSE, Evidence { witness: witness(), ..Evidence::default() })
    }

    fn enclosed(evidence: &mut Evidence) {
        evidence.enclosed = Some(Enclosed { places: 4, gap: 1e-13, scale: 1.0 });
    }

    #[test]
    fn no_word_without_its_evidence() {
        let nothing = Evidence::default;
        for known in [Possible::TRUE, Possible::FALSE, Possible::VOID] {
            assert_eq!(Verdict::of(Finding::sampled(known, nothing())).outcome(), Outcome::Undecided, "{known:?}");
        }
        let mut verdict = Verdict::of(held());
        verdict.enclose(0, Possible::TRUE, |_| {});
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Sampled), "no stretch was looked at");
        verdict.enclose(0, Possible::TRUE, |e| e.enclosed = Some(Enclosed { places: 0, gap: 0.0, scale: 1.0 }));
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Sampled), "no stretch counted");
        verdict.enclose(0, Possible::FALSE, |_| {});
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Sampled), "no witness");
        verdict.prove(0, Possible::TRUE_OR_VOID, |_| {});
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Sampled), "no proof");
        verdict.prove(0, Possible::OPEN, |e| e.proof = Some(Proof::default()));
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Sampled), "a proof that leaves false possible is none");
    }

    #[test]
    fn a_conjunction_is_as_strong_as_its_weakest_part_and_fails_with_one() {
        let mut verdict = Verdict::decide(And(vec![Atom(0), Atom(1)]), vec![held(), held()]);
        verdict.enclose(0, Possible::TRUE, enclosed);
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Sampled));
        verdict.enclose(1, Possible::TRUE, enclosed);
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Enclosed));
        verdict.prove(1, Possible::TRUE_OR_VOID, |e| e.proof = Some(Proof::default()));
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Enclosed));
        verdict.prove(0, Possible::TRUE_OR_VOID, |e| e.proof = Some(Proof::default()));
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Proved));
        let mut verdict =
            Verdict::decide(And(vec![Atom(0), Atom(1)]), vec![Finding::open(Plain::NotLookedAt), failed()]);
        assert_eq!(verdict.outcome(), Outcome::Fails(Strength::Sampled));
        verdict.enclose(1, Possible::FALSE, |_| {});
        assert_eq!(verdict.outcome(), Outcome::Fails(Strength::Enclosed));
    }

    #[test]
    fn what_is_void_and_what_is_proved_wherever_it_has_a_value() {
        let void = Finding::sampled(Possible::VOID, Evidence::because(Plain::NoValueDetermined));
        let mut verdict = Verdict::of(void);
        assert_eq!(verdict.outcome(), Outcome::NotApplicable(Strength::Sampled));
        // A proof says nothing of whether there is a value.
        verdict.prove(0, Possible::TRUE_OR_VOID, |e| e.proof = Some(Proof::default()));
        assert_eq!(verdict.outcome(), Outcome::NotApplicable(Strength::Sampled));
        let given = Atom(0).given(Atom(1));
        let unmet = Finding::sampled(Possible::FALSE, Evidence { witness: witness(), ..Evidence::default() });
        assert_eq!(
            Verdict::decide(given, vec![failed(), unmet]).outcome(),
            Outcome::NotApplicable(Strength::Sampled),
            "what is presupposed is not so"
        );
    }

    #[test]
    fn what_is_rigorous_stands_against_samples_and_contradicts_only_what_is_rigorous() {
        let mut verdict = Verdict::of(held());
        verdict.enclose(0, Possible::FALSE, |e| e.witness = witness());
        assert_eq!(verdict.outcome(), Outcome::Fails(Strength::Enclosed));
        assert!(verdict.findings()[0].overrules_samples());
        assert!(verdict.defect().is_none());
        verdict.prove(0, Possible::TRUE, |e| e.proof = Some(Proof::default()));
        assert_eq!(verdict.outcome(), Outcome::Undecided);
        assert!(verdict.defect().is_some());
    }

    #[test]
    fn a_withdrawn_motion_decides_nothing_that_it_alone_decided() {
        let mut verdict = Verdict::of(held());
        verdict.withdraw_samples(&Plain::Ended.into());
        assert_eq!(verdict.outcome(), Outcome::Undecided);
        assert_eq!(verdict.evidence().reason, Some(Plain::Ended.into()));
        let mut verdict = Verdict::of(held());
        verdict.enclose(0, Possible::TRUE, enclosed);
        verdict.withdraw_samples(&Plain::Ended.into());
        assert_eq!(verdict.outcome(), Outcome::Holds(Strength::Enclosed));
    }

    #[test]
    fn a_verdict_that_was_kept_is_decided_again() {
        let two = || Proposition::And(vec![Proposition::Atom(0), Proposition::Atom(1)]);
        let mut contradicted = Verdict::of(held());
        contradicted.contradict(Reason::quoted("two routes differ"));
        for verdict in [
            Verdict::of(held()),
            Verdict::of(failed()),
            Verdict::of(Finding::open(Plain::NotLookedAt)),
            Verdict::decide(two(), vec![held(), failed()]),
            contradicted,
        ] {
            let kept = serde_json::to_value(&verdict).expect("it is written");
            assert_eq!(serde_json::from_value::<Verdict>(kept.clone()).expect("it is read"), verdict);
            for other in [Outcome::Holds(Strength::Proved), Outcome::Fails(Strength::Enclosed), Outcome::Undecided] {
                let mut forged = kept.clone();
                forged["outcome"] = serde_json::to_value(other).expect("it is written");
                let read = serde_json::from_value::<Verdict>(forged);
                assert_eq!(read.is_ok(), other == verdict.outcome(), "{other:?} for {:?}", verdict.outcome());
            }
        }
        assert!(serde_json::from_str::<Possible>("0").is_err() && serde_json::from_str::<Possible>("8").is_err());
    }
}
