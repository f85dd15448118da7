//! Texts of the derivation file as HTML. Every character of them is escaped; formulas become MathML.

use maud::{Markup, PreEscaped, html};

use super::super::mathml;
use super::super::numbers::retold;
pub(super) use super::super::plain::plain;
pub(super) use super::super::wording::unit;
use super::super::wording::{self, Part};
use latex::Scope;

/// Longest formula, in bytes of LaTeX, that fits on a narrow screen.
const LONG: usize = 40;

/// A text: `$…$` is a formula, `` `…` `` too, where it is one; everything else is shown as it is.
pub(in super::super) fn prose(text: &str, scope: &Scope) -> Markup {
    let mut out = String::new();
    for part in wording::parts(&wording::one_line(text)) {
        match part {
            Part::Words(words) => out.push_str(&mathml::escaped(&retold(words))),
            Part::Formula(text) => out.push_str(&formula(text, scope).into_string()),
        }
    }
    PreEscaped(out)
}

/// A reason that the check gives: formulas stand in it between backticks, or before "has no value".
pub(in super::super) fn reason(text: &str, scope: &Scope) -> Markup {
    match text.split_once(" has no value") {
        Some((subject, tail)) if !subject.contains([' ', '`']) => {
            html! { (formula(subject, scope)) " has no value" (prose(tail, scope)) }
        }
        Some((subject, tail)) => match subject.rsplit_once(", ") {
            Some((lead, name)) if !name.contains([' ', '`']) => {
                html! { (prose(lead, scope)) ", " (formula(name, scope)) " has no value" (prose(tail, scope)) }
            }
            _ => prose(text, scope),
        },
        _ => prose(text, scope),
    }
}

/// A formula inside a line; code, where the text is no formula of the language.
pub(in super::super) fn formula(text: &str, scope: &Scope) -> Markup {
    if let Some(math) = mathml::formula_mathml(text, scope) {
        // A formula is not broken into lines: on a narrow screen a long one is moved sideways.
        return match text.len() > LONG {
            true => html! { span.long tabindex="0" role="group" aria-label="formula" { (PreEscaped(math)) } },
            false => PreEscaped(math),
        };
    }
    // The name of a function by itself, `\arccos`.
    let bare = text.strip_prefix('\\').filter(|name| name.chars().all(|c| c.is_ascii_alphabetic()));
    match bare {
        Some(name) => html! { math { mi { (name) } } },
        None => html! { code { (plain(text)) } },
    }
}

/// What a comparison is called: a formula, then perhaps its component, or words.
pub(in super::super) fn label(text: &str, scope: &Scope) -> Markup {
    html! { @for part in label_parts(text, scope) { (part) } }
}

/// What a comparison is called, its component by itself: many comparisons of a claim differ in nothing else.
pub(super) fn label_parts(text: &str, scope: &Scope) -> Vec<Markup> {
    let label = wording::label(text);
    let name = html! { (label.before) (formula(label.formula, scope)) (label.after) };
    let component = label.component.map(|component| html! { ", component " (formula(component, scope)) });
    std::iter::once(name).chain(component).collect()
}

/// A formula on lines of its own. On paper nothing can be moved sideways: a wide one is printed in smaller letters.
pub(in super::super) fn display(text: &str, scope: &Scope) -> Markup {
    match mathml::display(text, scope) {
        Some(rows) => {
            // Each sign on the page is one element; those of rows of a matrix stand above one another.
            let signs = |row: &String| ["<mi", "<mo>", "<mn"].iter().map(|tag| row.matches(tag).count()).sum::<usize>();
            let most = rows.iter().filter(|row| !row.contains("<mtable")).map(signs).max().unwrap_or(0);
            let width = match most {
                0..=34 => "formula",
                35..=54 => "formula wide",
                _ => "formula widest",
            };
            html! {
                div class=(width) tabindex="0" role="group" aria-label="formula" { @for row in rows { (PreEscaped(row)) } }
            }
        }
        None => html! { div.formula tabindex="0" role="group" aria-label="formula" { code { (text) } } },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expr::Graph;

    #[test]
    fn texts_that_are_put_together_keep_their_spaces() {
        let mut graph = Graph::new();
        let scope = Scope::new(&mut graph);
        let shown = |text: &str| prose(text, &scope).into_string();
        assert_eq!(shown("at most "), "at most ");
        assert_eq!(shown("\n  a\n b"), " a b");
        assert_eq!((shown(" "), shown("")), (" ".to_owned(), String::new()));
        assert!(reason("x has no value at t = 1", &scope).into_string().ends_with("has no value at t = 1"));
    }

    #[test]
    fn no_text_becomes_markup() {
        let mut graph = Graph::new();
        let scope = Scope::new(&mut graph);
        for text in ["<script>alert(1)</script>", "`<img src=x>`", "$<b>$", r"$\operatorname{<script>}$", "a`<i>", "$"]
        {
            for out in [prose(text, &scope), reason(text, &scope), label(text, &scope), display(text, &scope)] {
                let out = out.into_string();
                for bad in ["<script", "<img", "<b>", "<i>"] {
                    assert!(!out.contains(bad), "{text}: {out}");
                }
            }
        }
    }
}
