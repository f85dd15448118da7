//! The answer to a proposition: what `rederive prove` prints.

use super::certificates::{certificate_text, is_certified};
use super::document::Answer;
use super::json::text;
use super::text::{Paint, paragraph};
use findings::standing::Decision;
use findings::{Counterexample, IdentityAccount, Place, Proposition, Trials};

/// The answer for a person; with `certificate`, followed by the exact proof as a program. `colour`: with escape codes.
pub fn proposition_text(
    proposition: &Proposition,
    account: &IdentityAccount,
    certificate: bool,
    colour: bool,
) -> String {
    let evidence = &account.evidence;
    let mut out = format!("{}\n", Paint(colour).bold(account.standing()));
    out.push_str(&lines(&[proposition.formula.as_str()], 2));
    if !proposition.given.is_empty() {
        out.push_str("  given\n");
        out.push_str(&lines(&proposition.given, 4));
    }
    out.push('\n');
    match account.finding.decision() {
        Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed => {
            let where_true = if proposition.given.is_empty() { "" } else { " for which the premises hold" };
            let words = match account.finding.is_whole() && account.exceptions.is_empty() {
                false => format!(
                    "Holds for values of the symbols{where_true} and both sides have a value, but whether it holds in the \
                     cases that the proof does not reach is open."
                ),
                true => format!("Holds for all values of the symbols{where_true} and both sides have a value."),
            };
            out.push_str(&paragraph(&words, 2));
            if let Some(branch) = &evidence.branch {
                out.push_str(&paragraph(&format!("± holds {branch}."), 2));
            }
            if let Some(reason) = &account.reason {
                out.push_str(&paragraph(&format!("But note: {reason}."), 2));
            }
            if let Some(recorded) = &account.recorded {
                out.push_str(&paragraph(&recorded.sentence(), 2));
            }
            out.push_str(&routes(account));
            for (title, list) in account.terms() {
                out.push_str(&format!("  {title}\n{}", lines(&list, 4)));
            }
        }
        Decision::Refuted => {
            match &evidence.counterexample {
                Some(found) => out.push_str(&counterexample(found, !proposition.given.is_empty())),
                None => out.push_str(&lines(&account.witness.iter().map(ToString::to_string).collect::<Vec<_>>(), 2)),
            }
            if let Some(reason) = &account.reason {
                out.push_str(&paragraph(&format!("But note: {reason}."), 2));
            }
        }
        Decision::Undecided => {
            let reason = account.reason.as_ref().map_or_else(|| "no reason is known".to_owned(), ToString::to_string);
            out.push_str(&paragraph(&format!("Neither proved nor refuted: {reason}."), 2));
        }
    }
    if certificate && is_certified(account) {
        out.push('\n');
        out.push_str(&certificate_text(&proposition.formula, &proposition.given, &evidence.certificates));
    }
    out
}

fn lines<S: ToString>(texts: &[S], indent: usize) -> String {
    let one = |text: &S| {
        let line = text.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
        format!("{}{line}\n", " ".repeat(indent))
    };
    texts.iter().map(one).collect()
}

/// How it was proved.
fn routes(account: &IdentityAccount) -> String {
    let mut out = String::new();
    match (&account.evidence.no_certificate, is_certified(account)) {
        (_, true) => out.push_str(&paragraph("Exact: there is a certificate, which --certificate prints.", 2)),
        (Some(reason), false) => out.push_str(&paragraph(&format!("There is no exact certificate: {reason}."), 2)),
        (None, false) if account.log2_error.is_some() && account.evidence.trials.is_none() => {
            let words = "Exact: both sides are algebraic numbers, and are enclosed more closely than two of their degree and \
                         height can differ.";
            out.push_str(&paragraph(words, 2));
        }
        (None, false) => {}
    }
    if let (Some(trials), Some(bound)) = (&account.evidence.trials, account.log2_error) {
        let Trials { count, degree, height, signs, cases, .. } = trials;
        let trials = if *count == 1 { "1 trial".to_owned() } else { format!("{count} trials") };
        let mut words = format!(
            "Random evaluation: {trials} over GF(p²), p above 2^61, degree at most {degree}, height at most {height:.0}"
        );
        if *signs > 0 {
            words.push_str(&match signs {
                1 => ", both choices of one sign".to_owned(),
                n => format!(", all choices of {n} signs"),
            });
        }
        if *cases > 1 {
            words.push_str(&format!(", {cases} cases"));
        }
        out.push_str(&paragraph(&format!("{words}; the probability of an error is at most 2^{}.", bound.ceil()), 2));
    }
    out
}

fn counterexample(found: &Counterexample, given: bool) -> String {
    let place = |Place { left, right, point, beyond }: &Place| {
        let mut values: Vec<String> = point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        if !beyond.is_empty() {
            values.push(format!(
                "and {} more values, by which what is given holds (--format json lists them)",
                beyond.len()
            ));
        }
        let at = if values.is_empty() { "as it stands".to_owned() } else { format!("at {}", values.join("; ")) };
        format!("{}    left   {left}\n    right  {right}\n", paragraph(&at, 2))
    };
    let mut out = String::new();
    if found.equation > 0 {
        out.push_str(&format!("  Equation {}:\n", found.equation + 1));
    }
    out.push_str(&place(&found.first));
    if let Some(second) = found.second.as_ref().filter(|_| given) {
        out.push_str("\n  The premises leave it open: they hold there, and also\n");
        out.push_str(&place(second));
    }
    out
}

/// The answer as JSON.
pub fn proposition_json(proposition: &Proposition, account: &IdentityAccount) -> String {
    text(&Answer::of(proposition, account))
}
