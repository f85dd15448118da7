//! Texts in which formulas stand, taken apart, and sentences that several kinds of report share; how each part is written is for the kind
//! of report to say.

use super::numbers::size;
use findings::{Outcome, PairAccount, Strength};

/// A part of a text.
#[derive(Debug, PartialEq)]
pub(super) enum Part<'a> {
    Words(&'a str),
    Formula(&'a str),
}

/// A text on one line. A space at an end is kept, since texts are put together.
pub(super) fn one_line(text: &str) -> String {
    let edge = |at: Option<char>| if at.is_some_and(char::is_whitespace) { " " } else { "" };
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let end = if words.is_empty() { "" } else { edge(text.chars().next_back()) };
    format!("{}{words}{end}", edge(text.chars().next()))
}

/// Whether a text between backticks is an id of a file, and no formula: words of small letters, put together with strokes, points and
/// slashes. A product of single letters is no word.
pub(super) fn is_id(text: &str) -> bool {
    let is_word = |part: &str| {
        let letters = part.bytes().take_while(u8::is_ascii_lowercase).count();
        let rest = &part[letters..];
        letters > 2 || (letters > 0 && !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()))
    };
    let small = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b"-./".contains(&b);
    text.starts_with(|c: char| c.is_ascii_lowercase())
        && text.bytes().all(small)
        && text.split(['-', '.', '/']).any(is_word)
}

/// The parts of a text: `$…$` is a formula, and so is `` `…` ``, unless it is an id.
pub(super) fn parts(text: &str) -> Vec<Part<'_>> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find(['$', '`']) {
        let (mark, after) = (&rest[start..=start], &rest[start + 1..]);
        let Some(end) = after.find(mark).filter(|end| *end > 0) else { break };
        out.push(Part::Words(&rest[..start]));
        let inner = &after[..end];
        out.push(if mark == "`" && is_id(inner) { Part::Words(inner) } else { Part::Formula(inner) });
        rest = &after[end + 1..];
    }
    out.push(Part::Words(rest));
    out.retain(|p| *p != Part::Words(""));
    out
}

/// A unit as it is printed: `kg m^2/s` with raised digits.
pub(super) fn unit(text: &str) -> String {
    let mut out = String::new();
    let mut raised = false;
    for c in text.chars() {
        match c {
            '^' => {
                raised = true;
                continue;
            }
            '-' if raised => out.push('⁻'),
            c if raised && c.is_ascii_digit() => {
                let at = usize::from(c as u8 - b'0');
                out.extend("⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(at));
            }
            c => {
                raised = false;
                out.push(c);
            }
        }
    }
    out
}

/// By how much a weak inequality that holds at samples may be violated there.
pub(super) fn slack(pair: &PairAccount) -> Option<f64> {
    let sampled = matches!(pair.verdict.outcome(), Outcome::Holds(Strength::Sampled));
    pair.verdict.evidence().slack.filter(|_| sampled)
}

/// The same in words.
pub(super) fn slack_sentence(pair: &PairAccount) -> Option<String> {
    slack(pair).map(|slack| format!("Where its sides agree it may be violated by up to {}", size(slack)))
}

/// What a comparison is called.
#[derive(Debug, PartialEq)]
pub(super) struct Label<'a> {
    /// Words before the formula, with their space.
    pub before: &'a str,
    pub formula: &'a str,
    /// Words after it, with their space.
    pub after: &'a str,
    /// Which component of it is compared: a formula.
    pub component: Option<&'a str>,
}

/// A label as the check writes it: a formula, perhaps with words, then perhaps its component in brackets.
pub(super) fn label(text: &str) -> Label<'_> {
    let (head, component) = match text.split_once("   [") {
        Some((head, component)) => (head, Some(component.trim_end_matches(']'))),
        None => (text, None),
    };
    let before =
        ["rank of the gradients of ", "for the system "].into_iter().find(|w| head.starts_with(w)).unwrap_or("");
    let rest = &head[before.len()..];
    let after = [" has a value", " of both motions"].into_iter().find(|w| rest.ends_with(w)).unwrap_or("");
    Label { before, formula: &rest[..rest.len() - after.len()], after, component }
}

/// A text without white space, to be compared.
pub(super) fn dense(text: &str) -> String {
    text.split_whitespace().collect()
}

/// A LaTeX name as a word that can be pasted into a program: `\dot{R}_{11}` becomes `R_11_dot`.
pub(super) fn identifier(name: &str) -> String {
    let dots = ["\\dddot", "\\ddot", "\\dot"].iter().position(|d| name.starts_with(d));
    let mut out = String::new();
    let mut word = String::new();
    let mut escaped = false;
    let rest = dots.map_or(name, |d| &name[["\\dddot", "\\ddot", "\\dot"][d].len()..]);
    for c in rest.chars().chain([' ']) {
        if escaped && c.is_ascii_alphabetic() {
            word.push(c);
            continue;
        }
        let style =
            ["bf", "rm", "it", "cal", "sf", "mathbf", "mathrm", "boldsymbol", "operatorname"].contains(&word.as_str());
        if !style {
            out.push_str(&word);
        }
        word.clear();
        escaped = c == '\\';
        match c {
            '\'' => out.push_str("_prime"),
            '(' => out.push_str("_at_"),
            '-' => out.push('m'),
            '_' => out.push('_'),
            c if c.is_alphanumeric() => out.push(c),
            _ => {}
        }
    }
    let suffix = ["_dddot", "_ddot", "_dot"];
    out + dots.map_or("", |d| suffix[d])
}

#[cfg(test)]
mod tests {
    use super::*;
    use Part::{Formula, Words};

    #[test]
    fn formulas_stand_between_marks() {
        assert_eq!(parts("a $x$ b `y`"), [Words("a "), Formula("x"), Words(" b "), Formula("y")]);
        assert_eq!(parts("costs 3$ or `"), [Words("costs 3$ or `")]);
        assert_eq!(parts("$$"), [Words("$$")]);
        assert!(parts("").is_empty());
        assert_eq!(parts("given `start-is-a-rotation`."), [Words("given "), Words("start-is-a-rotation"), Words(".")]);
    }

    #[test]
    fn an_id_is_no_formula() {
        for id in
            ["start-is-a-rotation", "t10", "energy", "t8/with-unit-start", "t7.1", "reduced-phi/given-the-relation"]
        {
            assert!(is_id(id), "{id}");
        }
        for formula in ["x", "xy", "x-y", "a/b", "ab-cd", "2x", r"\alpha", "x^2", "q(0)", "X1", "x_1"] {
            assert!(!is_id(formula), "{formula}");
        }
    }

    #[test]
    fn one_line_keeps_a_space_at_an_end() {
        assert_eq!(one_line("\n  a\n b"), " a b");
        assert_eq!(one_line("at most "), "at most ");
        assert_eq!((one_line(" "), one_line("")), (" ".to_owned(), String::new()));
    }

    #[test]
    fn labels_have_words_and_components() {
        let of = |text| {
            let Label { before, formula, after, component } = label(text);
            (before, formula, after, component)
        };
        assert_eq!(of("x=y"), ("", "x=y", "", None));
        assert_eq!(of("R=1   [i=1]"), ("", "R=1", "", Some("i=1")));
        assert_eq!(of("for the system a"), ("for the system ", "a", "", None));
        assert_eq!(of("x has a value"), ("", "x", " has a value", None));
    }

    #[test]
    fn names_become_words() {
        for (name, word) in [
            (r"\dot{R}_{11}", "R_11_dot"),
            (r"{\bf m}_3", "m_3"),
            (r"\Omega_2(0)", "Omega_2_at_0"),
            (r"\dot{\bf w}_1", "w_1_dot"),
            (r"\ddot{\theta}", "theta_ddot"),
            (r"I_{(1-3)}", "I__at_1m3"),
            (r"\operatorname{Re}(c)", "Re_at_c"),
            ("t", "t"),
        ] {
            assert_eq!(identifier(name), word, "{name}");
        }
    }
}
