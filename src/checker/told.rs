//! Recorded proofs in words: the sequent, and what each step says.
//!
//! **In:** a [`ProofRecord`]. **Out:** [`Told`] for a relation of it. **Guaranteed:** a step is told only if the checker made it again; its words are those of the fact that it makes.

use super::draft::{Draft, Refused, Shown};
use super::fact::Because;
use super::record::ProofRecord;
use super::step::{FactId, Given, Manner, Step};
use super::term::Sense;

/// Longest formula that is told in full, in characters.
const LONGEST: usize = 400;

/// A relation that is shown, in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// The sequent.
    pub sequent: String,
    /// What each step says, with the steps that it uses: formulas in LaTeX between backquotes.
    pub steps: Vec<String>,
    /// What was shown.
    pub shown: Shown,
}

impl Given {
    /// The place, in words.
    pub fn words(self) -> String {
        match self {
            Given::System(at) => format!("equation {} of the systems", at + 1),
            Given::Premise(at) => format!("premise {}", at + 1),
            Given::Assumed(at) => format!("assumption {}", at + 1),
            Given::Selector(at) => format!("selector {}", at + 1),
            Given::Claimed(at) => format!("given claim {}", at + 1),
        }
    }
}

impl Shown {
    /// What the proof rests on, in words.
    pub fn rests_on(&self) -> String {
        match self.given() {
            [] => "the definitions alone".to_owned(),
            all => all.iter().map(|given| given.words()).collect::<Vec<_>>().join(", "),
        }
    }
}

impl ProofRecord {
    /// What the proof presupposes, in words.
    pub fn presupposed_words(&self) -> Vec<String> {
        super::words::relations(&self.sequent, &self.presupposed)
    }

    /// What is assumed at all times, in words.
    pub fn throughout_words(&self) -> Vec<String> {
        super::words::relations(&self.sequent, &self.throughout)
    }

    /// A relation, replayed and told.
    ///
    /// # Errors
    /// The step that is refused, or a relation that is not there.
    pub fn told(&self, relation: usize) -> Result<Told, Refused> {
        let missing = || Refused { step: None, why: "there is no such relation".to_owned() };
        let relation = self.relations.get(relation).ok_or_else(missing)?;
        let sequent = self.sequent_of(relation);
        let mut draft = Draft::new(&sequent)?;
        // The number of the step that made each fact.
        let (mut made_by, mut steps) = (Vec::new(), Vec::new());
        for (number, step) in relation.steps.iter().enumerate() {
            let made = draft.push(step.clone())?;
            if made.is_some() {
                made_by.push(number + 1);
            }
            steps.push(step_words(&draft, step, made, &made_by));
        }
        let (_, shown) = draft.finish()?;
        Ok(Told { sequent: sequent.words()?, steps, shown })
    }
}

fn shortened(text: String) -> String {
    let long = text.chars().count();
    if long <= LONGEST {
        return text;
    }
    let start: String = text.chars().take(LONGEST).collect();
    let closing = if start.matches('`').count() % 2 == 1 { "`" } else { "" };
    format!("{start}{closing} \u{2026} ({long} characters)")
}

fn step_words(draft: &Draft, step: &Step, made: Option<FactId>, made_by: &[usize]) -> String {
    let number = |id: &FactId| made_by.get(id.0 as usize).map_or_else(String::new, ToString::to_string);
    let numbers = |ids: &[FactId]| ids.iter().map(number).collect::<Vec<_>>().join(", ");
    let from = |ids: &[FactId]| if ids.is_empty() { String::new() } else { format!(" of {}", numbers(ids)) };
    let fact = made.and_then(|id| draft.fact(id).map(|fact| (id, fact)));
    if let Some((id, fact)) = fact {
        let why = match fact.because() {
            Because::Given(given, facts) => format!("{}{}", given.words(), from(facts)),
            Because::Supposed => "supposed".to_owned(),
            Because::Rule(rule, facts) => format!("{rule}{}", from(facts)),
        };
        let law = match step {
            Step::Law { law, .. } => format!(", {}", law.words()),
            _ => String::new(),
        };
        return format!("{why}{law}: {}", shortened(draft.words(id)));
    }
    match step {
        Step::Suppose { says, manner } => {
            let sense = match says.sense {
                Sense::Equal => "an equation",
                Sense::NotEqual | Sense::Less | Sense::LessOrEqual => "an inequality",
            };
            let times = match manner {
                Manner::AtTimes => "at times",
                Manner::OnIntervals => "on intervals",
            };
            format!("a case opens, {sense} {times}")
        }
        Step::Open { .. } => "each chosen time has chosen times around it".to_owned(),
        Step::Everywhere { .. } => "all times are chosen".to_owned(),
        Step::Smooth { fact, .. } => format!("the highest rate of {} has a rate", number(fact)),
        Step::Analytic { equations, .. } => format!("solutions of {} are analytic", numbers(equations)),
        Step::Model { .. } => "there is a motion on which all of this is true".to_owned(),
        Step::Conclude { fact } => format!("the claim is {}", number(fact)),
        _ => String::new(),
    }
}
