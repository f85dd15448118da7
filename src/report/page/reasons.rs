//! The reasons of verdicts, as a table of them shows them: what many have in common is said once, in a sentence above them.
//!
//! **In:** a reason, as the check gives it. **Out:** what it shares with those of other motions, as a sentence, and what is its
//! own: numbers in columns, and words.

/// A reason, taken apart.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Told<'a> {
    /// What is shared, as the check words it.
    pub head: &'a str,
    /// What the numbers beside it mean.
    pub meaning: &'static str,
    /// How many further parts of the claim hold likewise.
    pub others: usize,
    /// The number of stretches of an enclosure.
    pub stretches: Option<&'a str>,
    /// How far off the relation may be at most, and how large its terms are.
    pub apart: Option<(&'a str, &'a str)>,
    /// What is said of this motion alone.
    pub own: String,
}

/// What numbers after a colon mean, by the words before them: the first of these that a reason has.
const MEANINGS: [(&str, &str, &str); 5] = [
    (
        " is not met",
        ": at t = ",
        "; below: a time, the left and the right side there, and the error bound of their difference",
    ),
    (
        "cannot be decided",
        ": at t = ",
        "; below: a time, the left and the right side there, and the error bound of their difference",
    ),
    ("is not known well enough", ": within ", "; below: how well, and at which times"),
    (" cannot be told apart", ": their difference ", "; below: where their difference lies, and at which times"),
    ("lie apart", ": at t = ", ""),
];

/// A reason, taken apart.
pub(super) fn told(reason: &str) -> Told<'_> {
    if let Some(told) = enclosed(reason) {
        return told;
    }
    let meant = MEANINGS.iter().find_map(|(words, mark, meaning)| {
        let (head, own) = reason.split_once(mark).filter(|(head, _)| head.ends_with(words))?;
        let own = format!("{}{own}", &mark[2..]);
        Some(Told { head, meaning, own: spoken(&own), ..Told::default() })
    });
    meant.unwrap_or_else(|| {
        let marks = [": at t = ", ": in ", ": within ", ": their difference ", ", on ["];
        let heads = marks.iter().filter_map(|mark| reason.split_once(mark)).map(|(head, _)| head);
        match heads.min_by_key(|head| head.len()) {
            Some(head) => Told { head, own: spoken(&reason[head.len() + 2..]), ..Told::default() },
            None => Told { head: reason, ..Told::default() },
        }
    })
}

/// `for every t of the span: in 293 stretches, within 6.8e-10 where terms are 1.1e1; and 2 more likewise`.
fn enclosed(reason: &str) -> Option<Told<'_>> {
    let (head, tail) = reason.split_once(": in ").filter(|(head, _)| head.ends_with("for every t of the span"))?;
    let (first, others) = match tail.split_once("; and ") {
        Some((first, more)) => (first, more.strip_suffix(" more likewise")?.parse().ok()?),
        None => (tail, 0),
    };
    let (stretches, rest) = first.split_once(" stretches")?;
    if !stretches.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let apart = match rest {
        "" => None,
        _ => Some(rest.strip_prefix(", within ")?.split_once(" where terms are ")?),
    };
    let meaning = match apart {
        _ if head != "for every t of the span" => {
            ": the enclosure of the motion leaves no time in any of the stretches below"
        }
        Some(_) => {
            ", by enclosures of both sides on each of the stretches that it is cut into; below: how many there are, how far off \
             it may be at most, and how large the terms are that make up its sides"
        }
        None => ", by an enclosure on each of the stretches that it is cut into; below: how many there are",
    };
    Some(Told { head, meaning, others, stretches: Some(stretches), apart, own: String::new() })
}

/// Numbers in words.
fn spoken(numbers: &str) -> String {
    let words = [(" its sides are ", ": "), ("(error bound ", "(± "), (", on [", ", for t in [")];
    let text = words.iter().fold(numbers.to_owned(), |text, (from, to)| text.replace(from, to));
    match text.strip_prefix("on [") {
        Some(rest) => format!("for t in [{rest}"),
        None => text,
    }
}

impl Told<'_> {
    /// What is shared, as a sentence; empty where nothing is said.
    pub fn sentence(&self) -> String {
        let others = match self.others {
            0 => String::new(),
            1 => ". One more part of the claim likewise, with numbers of its own".to_owned(),
            n => format!(". {n} more parts of the claim likewise, with numbers of their own"),
        };
        format!("{}{}{others}", self.head, self.meaning)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_enclosure_is_told_in_words_and_columns() {
        let found = told(
            "for every t of the span: in 293 stretches, within 6.8e-10 where terms are 1.1e1; and 2 more likewise",
        );
        assert_eq!((found.stretches, found.apart, found.others), (Some("293"), Some(("6.8e-10", "1.1e1")), 2));
        assert!(found.own.is_empty());
        let sentence = found.sentence();
        assert!(
            sentence.starts_with("for every t of the span, by enclosures of both sides on each of the stretches"),
            "{sentence}"
        );
        assert!(sentence.ends_with("2 more parts of the claim likewise, with numbers of their own"), "{sentence}");
        let plain = told("for every t of the span: in 32 stretches");
        assert_eq!((plain.stretches, plain.apart, plain.others), (Some("32"), None, 0));
        assert!(told("excluded for every t of the span: in 32 stretches").sentence().contains("leaves no time"));
    }

    #[test]
    fn what_is_shared_is_a_sentence_and_the_rest_are_numbers() {
        let found = told("the assumption `m_1=0` is not met: at t = 0.5 its sides are 1 and 0 (error bound 2.2e-16)");
        assert_eq!(found.head, "the assumption `m_1=0` is not met");
        assert_eq!(found.own, "at t = 0.5: 1 and 0 (± 2.2e-16)");
        assert!(found.sentence().ends_with("the error bound of their difference"));
        let found = told(
            "not enclosed: the sides of `x: at t = 1` cannot be told apart: their difference lies in [-1, 1], on [2, 3]",
        );
        assert_eq!(found.own, "their difference lies in [-1, 1], for t in [2, 3]");
        assert_eq!(
            told("not enclosed: an assumption is not known well enough: within 2e-9, on [1, 2]").own,
            "within 2e-9, for t in [1, 2]"
        );
    }

    /// A text that only begins like a known one is shown as it is.
    #[test]
    fn nothing_is_lost_of_other_reasons() {
        for reason in [
            "",
            "not seen",
            "for every t of the span: in many stretches",
            "for every t of the span: in 3 stretches, closely",
            "x is not met: perhaps",
            "for every t of the span: in 3 stretches; and some more likewise",
        ] {
            let found = told(reason);
            let (sentence, own) = (found.sentence(), &found.own);
            assert!(sentence.starts_with(found.head), "{reason}");
            assert_eq!(
                found.head.len() + if own.is_empty() { 0 } else { own.len() + 2 },
                reason.len(),
                "{reason}: {found:?}"
            );
        }
    }
}
