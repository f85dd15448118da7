//! The reasons of verdicts, as a table of them shows them: what many have in common is said once, in a sentence above them.
//!
//! **In:** a reason, as an engine found it. **Out:** what it shares with those of other motions, as a sentence, and what is its
//! own: numbers in columns, and words. **Guaranteed:** nothing is lost: what is not parted is shared as a whole.

use crate::numbers::size;
use reason::{Enclosing, Place, Reason, Refutation, Sampling, Sides, short};

/// A reason, in its parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Told {
    /// What is shared.
    pub head: String,
    /// What the numbers beside it mean.
    pub meaning: &'static str,
    /// The number of stretches of an enclosure.
    pub stretches: Option<usize>,
    /// How far off the relation may be at most, and how large its terms are, as the table shows it.
    pub apart: Option<(String, String)>,
    /// What stands between the shared part and the own one, where both are said in a line.
    joint: &'static str,
    /// What is said of this motion alone.
    pub own: String,
}

const OF_SIDES: &str = "; below: a time, the left and the right side there, and the error bound of their difference";
const OF_DIFFERENCE: &str = "; below: where their difference lies, and at which times";
const OF_STRETCHES: &str = ", by an enclosure on each of the stretches that it is cut into; below: how many there are";
const OF_BOUNDS: &str = ", by enclosures of both sides on each of the stretches that it is cut into; below: how many there are, \
                         how far off it may be at most, and how large the terms are that make up its sides";
const OF_NO_TIME: &str = ": the enclosure of the motion leaves no time in any of the stretches below";

/// A reason, in its parts.
pub(super) fn told(reason: &Reason) -> Told {
    match reason {
        Reason::Enclosing(of) => enclosing(of, reason),
        Reason::Sampling(of) => match of {
            Sampling::NotMet { text, sides: Some(Sides { t, left, right, bound }) } => {
                let [t, left, right] = [t, left, right].map(short);
                let own = format!("at t = {t}: {left} and {right} (± {bound:.1e})");
                let head = Sampling::NotMet { text: text.clone(), sides: None }.to_string();
                Told { meaning: OF_SIDES, ..parted(head, ": ", own) }
            }
            Sampling::TooLarge { example, .. } => match &**example {
                Reason::Sampling(Sampling::At(..) | Sampling::Differ { .. } | Sampling::FalseAt(..)) => {
                    split(reason, ": ")
                }
                _ => whole(reason),
            },
            Sampling::AssumptionOpen { why: Some(why), .. }
            | Sampling::NotSeen { why: Some(why), .. }
            | Sampling::TriedAtEvents(_, why) => led(reason, why),
            _ => whole(reason),
        },
        Reason::Plain(_)
        | Reason::Quoted(_)
        | Reason::NoValue(_)
        | Reason::Proving(_)
        | Reason::Ranges(_)
        | Reason::Decided(_) => whole(reason),
    }
}

fn enclosing(of: &Enclosing, reason: &Reason) -> Told {
    match of {
        Enclosing::EveryTime { stretches, within } => {
            let meaning = if within.is_some() { OF_BOUNDS } else { OF_STRETCHES };
            let apart = within.map(|(gap, scale)| (size(gap), size(scale)));
            let own = Told { stretches: Some(*stretches), apart, meaning, ..Told::default() };
            Told { head: "for every t of the span".to_owned(), ..own }
        }
        Enclosing::Excluded(why) if told(why).stretches.is_some() => {
            let told = told(why);
            Told { head: format!("excluded {}", told.head), meaning: OF_NO_TIME, ..told }
        }
        Enclosing::WhereverItSays(why) if told(why).stretches.is_some() => {
            let told = told(why);
            Told { head: format!("wherever it says something, {}", told.head), ..told }
        }
        Enclosing::WhereverItSays(_) => split(reason, ": "),
        Enclosing::EveryCommonTime { .. }
        | Enclosing::Certified(Refutation::Apart { .. } | Refutation::Dependent { .. })
        | Enclosing::Certain(Refutation::Apart { .. }) => split(reason, ": "),
        Enclosing::AlsoCertified(before) => {
            let told = told(before);
            match told.own.is_empty() {
                true => whole(reason),
                false => Told { own: format!("{}; certified", told.own), ..told },
            }
        }
        Enclosing::NotEnclosed { before: Some(before), why } => {
            let (known, open) = (told(before), told(why));
            // What cannot be told apart says more than what samples left open.
            match known.own.is_empty() || known.meaning.is_empty() && !open.meaning.is_empty() {
                true => led(reason, why),
                false => Told { own: format!("{}; not enclosed: {}", known.own, open.line()), ..known },
            }
        }
        Enclosing::NotEnclosed { before: None, why }
        | Enclosing::ValueOpen(why)
        | Enclosing::Undecided(why)
        | Enclosing::Unmet(why) => led(reason, why),
        Enclosing::Placed { what, place } => {
            let (apart, stretch) = (told(what), spoken(place));
            match (apart.own.is_empty(), place) {
                (false, _) => Told { own: format!("{}, {stretch}", apart.own), ..apart },
                (true, Place::Stretch(..)) => parted(apart.head, ", ", stretch),
                (true, Place::Time(_) | Place::Event { .. }) => whole(reason),
            }
        }
        // A label may have such a mark, too.
        Enclosing::NotApart { .. } => {
            let words = reason.to_string();
            let (head, own) = words.rsplit_once(": ").unwrap_or((&words, ""));
            Told { meaning: OF_DIFFERENCE, ..parted(head.to_owned(), ": ", own.to_owned()) }
        }
        _ => whole(reason),
    }
}

/// Where something stays open, in a line of a table.
fn spoken(place: &Place) -> String {
    match place {
        Place::Stretch(from, to) => format!("for t in [{}, {}]", short(from), short(to)),
        Place::Time(_) | Place::Event { .. } => place.to_string().trim_start_matches(", ").to_owned(),
    }
}

/// What is said of every motion alike.
fn whole(reason: &Reason) -> Told {
    Told { head: reason.to_string(), ..Told::default() }
}

fn parted(head: String, joint: &'static str, own: String) -> Told {
    Told { head, joint, own, ..Told::default() }
}

/// A sentence whose numbers stand after its first mark.
fn split(reason: &Reason, joint: &'static str) -> Told {
    let words = reason.to_string();
    let (head, own) = words.split_once(joint).unwrap_or((&words, ""));
    parted(head.to_owned(), joint, own.to_owned())
}

/// A reason that ends with another one, whose parts are its own.
fn led(reason: &Reason, by: &Reason) -> Told {
    let (words, last, told) = (reason.to_string(), by.to_string(), told(by));
    let lead = words.strip_suffix(&last).unwrap_or(&words);
    Told { head: format!("{lead}{}", told.head), ..told }
}

impl Told {
    /// What is shared, as a sentence; empty where nothing is said.
    pub fn sentence(&self) -> String {
        format!("{}{}", self.head, self.meaning)
    }

    /// Both parts, in a line.
    fn line(&self) -> String {
        format!("{}{}{}", self.head, self.joint, self.own)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    fn open() -> Enclosing {
        let what = Arc::new(Enclosing::NotApart { label: "x: at t = 1".into(), from: -1.0, to: 1.0 }.into());
        Enclosing::Placed { what, place: Place::Stretch(2.0, 3.0) }
    }

    #[test]
    fn an_enclosure_is_told_in_words_and_columns() {
        let every = |within| Enclosing::EveryTime { stretches: 293, within };
        let found = told(&every(Some((6.8e-10, 11.0))).into());
        assert_eq!(
            (found.stretches, found.apart.clone(), found.own.as_str()),
            (Some(293), Some(("6.8·10⁻¹⁰".to_owned(), "11".to_owned())), "")
        );
        let sentence = found.sentence();
        assert!(
            sentence.starts_with("for every t of the span, by enclosures of both sides on each of the stretches"),
            "{sentence}"
        );
        // A column of numbers has numbers alone: words stand in the sentence.
        let open = told(&Enclosing::WhereverItSays(Arc::new(every(Some((6.8e-10, 11.0))).into())).into());
        assert_eq!((open.stretches, open.apart.clone()), (found.stretches, found.apart.clone()));
        assert!(open.sentence().starts_with("wherever it says something, for every t of the span, by enclosures"));
        let excluded = told(&Enclosing::Excluded(Arc::new(every(None).into())).into());
        assert_eq!((excluded.stretches, excluded.apart.clone()), (Some(293), None));
        assert!(
            excluded.sentence().starts_with("excluded for every t of the span: the enclosure of the motion leaves no")
        );
    }

    #[test]
    fn what_is_shared_is_a_sentence_and_the_rest_are_numbers() {
        let sides = Some(Sides { t: 0.5, left: 1.0, right: 0.0, bound: 2.2e-16 });
        let unmet = Reason::from(Sampling::NotMet { text: "m_1=0".into(), sides });
        let found = told(&unmet);
        assert_eq!(found.head, "the assumption `m_1=0` is not met");
        assert_eq!(found.own, "at t = 0.5: 1 and 0 (± 2.2e-16)");
        assert!(found.sentence().ends_with("the error bound of their difference"));
        let found = told(&Enclosing::NotEnclosed { before: None, why: Arc::new(open().into()) }.into());
        assert_eq!(found.head, "not enclosed: the sides of `x: at t = 1` cannot be told apart");
        assert_eq!(found.own, "their difference lies in [-1.00e0, 1.00e0], for t in [2, 3]");
        let both = told(&Enclosing::NotEnclosed { before: Some(Arc::new(unmet)), why: Arc::new(open().into()) }.into());
        assert_eq!(both.head, "the assumption `m_1=0` is not met");
        assert!(both.own.ends_with(
            "(± 2.2e-16); not enclosed: the sides of `x: at t = 1` cannot be told apart: their \
                                    difference lies in [-1.00e0, 1.00e0], for t in [2, 3]"
        ));
    }

    /// What is not parted is shared as a whole.
    #[test]
    fn nothing_is_lost_of_other_reasons() {
        for words in ["", "not seen", "for every t of the span: in many stretches", "x is not met: at t = 3"] {
            let found = told(&Reason::quoted(words));
            assert_eq!((found.sentence().as_str(), found.own.as_str()), (words, ""));
        }
    }
}
