//! What a step is worth: the only room that says *proved*.
//!
//! **In:** the answer of an identity test, with what the step knows of its circumstances; then what the checker replayed of it. **Out:** [`Finding`]: the decision, with what it
//! leaves out, as data; words are made from it elsewhere.
//!
//! | decision | means |
//! |---|---|
//! | *proved* | the checker replayed it, no case is left out, and a real point was found at which it says something |
//! | *proved except* | the checker replayed it, and the cases listed are open, or those that its steps leave out |
//! | *proved unreplayed* | the prover alone says so: there are no steps that the checker makes again |
//! | *refuted* | a motion, or real constants, satisfy everything given, and not the claim |
//! | *undecided* | else |
//!
//! **Guaranteed.** The fields are private. *Proved* and *proved except* have one maker, `Finding::replayed`, which takes what the checker showed; `Finding::weigh` and
//! `Finding::of_signs`, which take what the prover says, come to *proved unreplayed* at most; `Finding::of_motion` takes the motion that refutes. Whether all that a proof follows from is proved itself is seen in the graph of the
//! derivation, see `conditional`.

use crate::recorded::{Grounds, Recorded};
use crate::words::{self, Word};
use expr::domain::Sign;
use expr::{Expr, Graph, Rational};
use proof::{Condition, Identity, Reason, order};
use serde::{Deserialize, Serialize};
use verdict::Witness;

/// What was decided of a step, taken by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Decision {
    /// For all values: the checker replayed it.
    Proved,
    /// For all values but those of the exceptions: the checker replayed it.
    ProvedExcept,
    /// For all values but those of the exceptions, as the prover says; the checker has not replayed it.
    Unreplayed,
    /// Not so.
    Refuted,
    /// Neither.
    #[default]
    Undecided,
}

impl Decision {
    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Decision::Proved => "proved",
            Decision::ProvedExcept => "proved except",
            Decision::Unreplayed => "proved unreplayed",
            Decision::Refuted => "refuted",
            Decision::Undecided => "undecided",
        }
    }

    /// The word of schema 1 of the report, which tells neither exceptions nor who proved it.
    pub fn contract_word(self) -> &'static str {
        match self {
            Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed => "proved",
            Decision::Refuted => "refuted",
            Decision::Undecided => "undecided",
        }
    }
}

/// What a proof does not reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Exception {
    /// That this vanishes.
    Vanishes(Expr),
    /// What lies beyond a time at which this leaps, or has an edge, as |x| has at 0.
    Leaps(Expr),
    /// What lies beyond a time at which this vanishes, under something.
    Divides(Expr),
    /// What lies beyond a time at which this vanishes, which is assumed not to.
    Passes(Expr),
    /// Where this does not have the sign: something that is named has no value there, and the claim may.
    HasNoValue(Expr, Sign),
    /// Where a part has no value with the sign of ± that is proved, and another is false with the other.
    OneSign,
}

/// Why a proof is none after all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Void {
    /// A formula has no value under what is given.
    NoValue,
    /// It was proved outside of special cases, and no point was found outside of them.
    OnlySpecial,
    /// No real point was found at which what is given holds and the claim has a value: perhaps it says nothing.
    Unseen,
    /// It was refuted without something given that could not be used.
    Incomplete,
}

/// The decision on a step, and what it rests on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    decision: Decision,
    exceptions: Vec<Exception>,
    void: Option<Void>,
}

impl Finding {
    /// Weighs an answer. `complete`: everything given could be used; `along`: what a proof along motions does not reach.
    pub fn weigh(graph: &Graph, identity: &Identity, complete: bool, along: Vec<Exception>) -> Finding {
        let undecided = |void| Finding { void, ..Finding::default() };
        match identity {
            Identity::Proved(proof) => {
                let mut exceptions: Vec<Exception> = Vec::new();
                for condition in &proof.conditions {
                    if let Some(e) = condition.leaves_out() {
                        exceptions.push(Exception::Vanishes(e));
                    }
                }
                if proof.conditions.iter().any(|c| is_impossible(graph, c)) {
                    return undecided(Some(Void::NoValue));
                }
                if proof.example.is_none() {
                    return undecided(Some(if exceptions.is_empty() { Void::Unseen } else { Void::OnlySpecial }));
                }
                exceptions.extend(along);
                Finding { decision: Decision::Unreplayed, exceptions, void: None }
            }
            Identity::Refuted(_) if complete => Finding { decision: Decision::Refuted, ..Finding::default() },
            Identity::Refuted(_) => undecided(Some(Void::Incomplete)),
            Identity::Undecided(_) => undecided(None),
        }
    }

    /// A motion on which everything given holds, and the claim does not.
    pub fn of_motion(_: &Witness) -> Finding {
        Finding { decision: Decision::Refuted, ..Finding::default() }
    }

    /// A motion of so many components by formulas, on which everything given holds exactly, and the claim does not.
    pub fn of_example(components: usize) -> Finding {
        let decision = if components > 0 { Decision::Refuted } else { Decision::Undecided };
        Finding { decision, ..Finding::default() }
    }

    /// The signs of everything, for every order of size of positive parameters.
    pub fn of_signs(found: &order::Orders) -> Finding {
        let decision = match (found.is_proved(), found.refuting()) {
            (true, _) => Decision::Unreplayed,
            (false, Some(_)) => Decision::Refuted,
            (false, None) => Decision::Undecided,
        };
        Finding { decision, ..Finding::default() }
    }

    /// The finding on the negation of what this one is about: what is proved for all values, on motions that there are, is never false.
    #[must_use]
    pub fn of_negation(&self) -> Finding {
        let decision = match self.decision {
            Decision::Proved | Decision::Unreplayed if self.exceptions.is_empty() => Decision::Refuted,
            Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed => Decision::Undecided,
            Decision::Refuted | Decision::Undecided => Decision::Undecided,
        };
        Finding { decision, ..Finding::default() }
    }

    /// Both findings: of a claim that must follow in two cases.
    pub fn and(self, other: Finding) -> Finding {
        let rank = |d: Decision| match d {
            Decision::Refuted => 4,
            Decision::Undecided => 3,
            Decision::Unreplayed => 2,
            Decision::ProvedExcept => 1,
            Decision::Proved => 0,
        };
        let decision = if rank(self.decision) >= rank(other.decision) { self.decision } else { other.decision };
        let mut exceptions = self.exceptions;
        exceptions.extend(other.exceptions);
        exceptions.dedup();
        Finding { decision, exceptions, void: self.void.or(other.void) }
    }

    /// The finding, once the checker has replayed its proof, or has not: the one maker of *proved*.
    #[must_use]
    pub fn replayed(self, recorded: &Recorded) -> Finding {
        let decision = match (self.decision, recorded.grounds()) {
            (Decision::Unreplayed, Grounds::Checker) if self.exceptions.is_empty() => Decision::Proved,
            (Decision::Unreplayed, Grounds::Checker | Grounds::CheckerBut(_)) => Decision::ProvedExcept,
            (decision, _) => decision,
        };
        Finding { decision, ..self }
    }

    /// Whether the prover alone says that it is proved.
    pub fn is_unreplayed(&self) -> bool {
        self.decision == Decision::Unreplayed
    }

    /// What was decided.
    pub fn decision(&self) -> Decision {
        self.decision
    }

    /// Whether it is proved, by the prover at least, and no case is left out.
    pub fn is_whole(&self) -> bool {
        self.is_proved_in_part() && self.exceptions.is_empty()
    }

    /// Whether it leaves out what lies beyond some times.
    pub fn ends_on_the_way(&self) -> bool {
        self.exceptions.iter().any(|e| match e {
            Exception::Leaps(_) | Exception::Divides(_) | Exception::Passes(_) => true,
            Exception::Vanishes(_) | Exception::HasNoValue(..) | Exception::OneSign => false,
        })
    }

    /// Whether it is proved, by the prover at least, perhaps with exceptions.
    pub fn is_proved_in_part(&self) -> bool {
        matches!(self.decision, Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed)
    }

    /// What a proof does not reach.
    pub fn exceptions(&self) -> &[Exception] {
        &self.exceptions
    }

    /// Why a proof or a refutation is none after all.
    pub fn void(&self) -> Option<Void> {
        self.void
    }
}

/// Whether a condition is a false statement about a number.
fn is_impossible(graph: &Graph, condition: &Condition) -> bool {
    let number = |e: Expr| graph.as_constant(e).cloned();
    let (zero, one) = (Rational::ZERO, Rational::ONE);
    match condition {
        Condition::Denominator(e) | Condition::Pivot(e) | Condition::Rate(e) => number(*e).is_some_and(|r| r == zero),
        Condition::Radicand(e) | Condition::Discriminant(e) => number(*e).is_some_and(|r| r < zero),
        Condition::Positive(e) => number(*e).is_some_and(|r| r <= zero),
        Condition::Unit(e) => number(*e).is_some_and(|r| r > one || r < -one),
    }
}

/// Whether an answer says that what is given contradicts itself, or that it leaves the claim without a value.
pub fn is_empty(identity: &Identity) -> bool {
    matches!(identity, Identity::Undecided(Reason::Contradiction | Reason::NoValue))
}

/// So many claims, and so many assumptions, are named of what is open behind a proof; the rest is one more entry, the last.
pub const MOST_TOLD: usize = 64;

/// Something that a proof is given, and that is not proved itself.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Given {
    /// Name of the claim.
    pub name: String,
    /// What its own step came to; `None` where it is no question for all values, or was not asked.
    #[serde(deserialize_with = "words::standing")]
    pub standing: Option<Word>,
    /// Whether it is a postulate: what a file stands on is not asked to be proved.
    pub postulated: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_two_findings_the_worse_counts() {
        let of = |decision| Finding { decision, ..Finding::default() };
        use Decision::{Proved, ProvedExcept, Refuted, Undecided, Unreplayed};
        for (a, b, both) in [
            (Proved, Proved, Proved),
            (Proved, ProvedExcept, ProvedExcept),
            (ProvedExcept, Unreplayed, Unreplayed),
            (Unreplayed, Undecided, Undecided),
            (Undecided, Refuted, Refuted),
        ] {
            assert_eq!(of(a).and(of(b)).decision(), both);
            assert_eq!(of(b).and(of(a)).decision(), both);
        }
        assert_eq!(Finding::default().decision(), Undecided);
    }
}
