//! Formulas as they are printed: what differs only in spelling becomes the same.

use std::ops::Range;

use super::short::Short;
use super::token::{Kind, Token};

/// A token of a formula, in one spelling, and where it was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Mark {
    pub text: Short,
    pub span: Range<usize>,
}

/// Commands that leave nothing but space, or choose a size.
const NO_PRINT: &[&str] = &[
    ",",
    ";",
    ":",
    ">",
    "!",
    " ",
    "/",
    "\n",
    "\t",
    "@",
    "quad",
    "qquad",
    "thinspace",
    "medspace",
    "thickspace",
    "negthinspace",
    "enspace",
    "displaystyle",
    "textstyle",
    "scriptstyle",
    "nonumber",
    "notag",
    "limits",
    "nolimits",
    "left",
    "right",
    "middle",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "bigr",
    "bigm",
    "Bigl",
    "Bigr",
    "Bigm",
    "biggl",
    "biggr",
    "Biggl",
    "Biggr",
    "hfill",
    "hfil",
    "allowbreak",
    "noalign",
    "protect",
    "relax",
    "strut",
    "displaylimits",
    "centering",
    "noindent",
    "par",
    "break",
    "linebreak",
    "pagebreak",
    "allowdisplaybreaks",
];
/// The same with an argument in braces.
const NO_PRINT_WITH_ARGUMENT: &[&str] = &[
    "label",
    "tag",
    "hspace",
    "vspace",
    "hskip",
    "vskip",
    "noalign",
    "intertext",
    "shortintertext",
    "phantom",
    "vphantom",
    "hphantom",
    "color",
];
/// Two spellings of one sign.
const SAME: &[(&str, &str)] = &[
    ("leq", "le"),
    ("geq", "ge"),
    ("neq", "ne"),
    ("rightarrow", "to"),
    ("dfrac", "frac"),
    ("tfrac", "frac"),
    ("cfrac", "frac"),
    ("lvert", "|"),
    ("rvert", "|"),
    ("vert", "|"),
    ("lbrack", "["),
    ("rbrack", "]"),
    ("cr", "\\"),
    ("newline", "\\"),
    ("tabularnewline", "\\"),
];
/// Environments that only say where lines may be broken.
pub(super) const INNER: &[&str] = &["split", "aligned", "alignedat", "gathered", "subequations", "multlined"];

/// The marks of a formula. Breaks of lines, `\\` and `\cr`, are marks `\\`; spaces between words are marks, too.
pub(super) fn marks(tokens: &[Token]) -> Vec<Mark> {
    let mut out: Vec<Mark> = Vec::new();
    let mut at = 0;
    // Where the words end that stand here.
    let mut words_end = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        let last = out.last().map_or("", |m| m.text.as_str());
        if at < words_end && (token.kind == Kind::Space || token.is_char("~")) && !matches!(last, "{" | " ") {
            out.push(Mark { text: " ".into(), span: token.span.clone() });
        } else if token.kind == Kind::Close && last == " " {
            out.pop();
        }
        let mut push = |text: &str| out.push(Mark { text: text.into(), span: token.span.clone() });
        match token.kind {
            Kind::Space => {}
            Kind::Other if token.text == "~" || token.text == "&" => {}
            Kind::Command => match token.text.as_str() {
                "left" | "right" if tokens.get(at).is_some_and(|t| t.is_char(".")) => at += 1,
                "begin" | "end" => {
                    let (name, after) = group_text(tokens, at);
                    if !INNER.contains(&name.as_str()) {
                        push(&format!("\\{} {name}", token.text));
                    } else if name == "alignedat" && token.text == "begin" {
                        at = group_text(tokens, after).1;
                        continue;
                    }
                    at = after;
                }
                name if NO_PRINT.contains(&name) => {}
                name if NO_PRINT_WITH_ARGUMENT.contains(&name) => {
                    if tokens.get(at).is_some_and(|t| t.is_char("*")) {
                        at += 1;
                    }
                    at = group_text(tokens, at).1;
                }
                "\\" => {
                    push("\\");
                    at = after_row(tokens, at);
                }
                name => {
                    if latex::sets_words(name) {
                        words_end = group_text(tokens, at).1.max(words_end);
                    }
                    let same = SAME.iter().find(|(other, _)| *other == name).map(|(_, same)| *same);
                    match same {
                        Some(sign @ ("|" | "[" | "]")) => push(sign),
                        Some("\\") => push("\\"),
                        other => push(&format!("\\{}", other.unwrap_or(name))),
                    }
                }
            },
            _ => push(&token.text),
        }
    }
    ordered(&without_needless_braces(out))
}

/// The longest group whose text is looked for, in tokens.
const MOST_OF_A_GROUP: usize = 4_000;
/// The deepest group whose text is looked for: formulas are not read so deep.
const DEEPEST_GROUP: i32 = 100;

/// The text of a group that begins at `at`, and the position after it; nothing where no group begins.
pub(super) fn group_text(tokens: &[Token], at: usize) -> (String, usize) {
    let mut from = at;
    while tokens.get(from).is_some_and(|t| t.kind == Kind::Space) {
        from += 1;
    }
    if tokens.get(from).is_none_or(|t| t.kind != Kind::Open) {
        return (String::new(), at);
    }
    let mut depth = 0;
    let ends = |t: &Token| {
        depth += i32::from(t.kind == Kind::Open) - i32::from(t.kind == Kind::Close);
        depth == 0 || depth > DEEPEST_GROUP
    };
    let end = tokens[from..].iter().take(MOST_OF_A_GROUP).position(ends).map(|i| from + i);
    // One that is not closed is none: what it opens may be most of the paper, for each of many.
    if depth > DEEPEST_GROUP || end.is_none() && tokens.len() > from + MOST_OF_A_GROUP {
        return (String::new(), from + 1);
    }
    let mut text = String::new();
    for t in &tokens[from + 1..end.unwrap_or(tokens.len())] {
        if t.kind == Kind::Command {
            text.push('\\');
        }
        text.push_str(&t.text);
    }
    (text, end.map_or(tokens.len(), |end| end + 1))
}

/// The position after what may follow `\\`: a star, and a distance in brackets.
pub(super) fn after_row(tokens: &[Token], at: usize) -> usize {
    let mut next = at;
    if tokens.get(next).is_some_and(|t| t.is_char("*")) {
        next += 1;
    }
    if tokens.get(next).is_some_and(|t| t.is_char("[")) {
        let end = tokens.iter().skip(next).take(12).position(|t| t.is_char("]"));
        let inside = |end: usize| tokens[next + 1..next + end].iter().map(|t| t.text.as_str()).collect::<String>();
        // `\\[2pt]` is a distance; `\\ [a,b]` is a formula.
        if let Some(end) = end
            && ["pt", "em", "ex", "mm", "cm", "in", "baselineskip", "jot"].iter().any(|u| inside(end).ends_with(u))
        {
            next += end + 1;
        }
    }
    next
}

/// `{x}` is `x`, again and again.
fn without_needless_braces(marks: Vec<Mark>) -> Vec<Mark> {
    let mut out: Vec<Mark> = Vec::with_capacity(marks.len());
    for mark in marks {
        match &out[..] {
            [.., open, inner]
                if mark.text == "}"
                    && open.text == "{"
                    && !matches!(inner.text.as_str(), "{" | "}")
                    && !takes_more(&inner.text) =>
            {
                let inner = out.pop();
                out.pop();
                out.extend(inner);
            }
            _ => out.push(mark),
        }
    }
    out
}

/// Whether a command in braces would take what follows them, if they were not there.
fn takes_more(mark: &str) -> bool {
    switches(mark) || matches!(mark, r"\frac" | r"\sqrt")
}

/// Whether a command changes all behind it in its group.
fn switches(mark: &str) -> bool {
    matches!(mark, r"\bf" | r"\rm" | r"\it" | r"\cal" | r"\sf" | r"\frak" | r"\boldmath" | r"\over" | r"\atop" | "\\")
}

/// How many units behind a mark belong to it; of a command that is not known, all groups right behind it.
fn arguments(mark: &str) -> usize {
    match mark.strip_prefix('\\') {
        None => usize::from(matches!(mark, "_" | "^" | "]")),
        Some("frac" | "binom" | "dbinom" | "tbinom" | "overset" | "underset" | "stackrel") => 2,
        Some(command) if latex::is_letter_command(command) => 0,
        Some(_) => usize::MAX,
    }
}

/// What a formula prints, as a text: two formulas with the same print are the same, letter by letter. Braces that hold no argument print
/// nothing.
pub(super) fn print(tokens: &[Token]) -> String {
    let all = marks(tokens);
    let mut out = String::new();
    // How many units still belong to what stands before; of each open group, those behind it, and whether its braces stay.
    let (mut wanted, mut open) = (0usize, Vec::new());
    for (at, mark) in all.iter().enumerate() {
        let text = mark.text.as_str();
        let is_kept = match text {
            "{" => {
                let is_next =
                    |at: usize, all_of: &[&str]| all.get(at).is_some_and(|m| all_of.contains(&m.text.as_str()));
                // Scripts behind empty braces stand behind those before, and not above or below them.
                let parts_scripts = is_next(at + 1, &["}"]) && is_next(at + 2, &["_", "^"]);
                let stays = wanted > 0 || parts_scripts || all.get(at + 1).is_some_and(|m| switches(&m.text));
                open.push((wanted.saturating_sub(usize::from(wanted < usize::MAX)), stays));
                wanted = 0;
                stays
            }
            "}" => {
                let (behind, stays) = open.pop().unwrap_or_default();
                wanted = behind;
                stays
            }
            _ => {
                let rest = if wanted == usize::MAX { 0 } else { wanted.saturating_sub(1) };
                wanted = arguments(text).max(rest);
                true
            }
        };
        if is_kept {
            out.push_str(text);
            out.push(' ');
        }
    }
    out
}

/// The end of the unit that begins at `at`: one mark, or a group.
pub(super) fn unit(marks: &[Mark], at: usize) -> usize {
    if marks.get(at).is_none_or(|m| m.text != "{") {
        return (at + 1).min(marks.len());
    }
    let mut depth = 0;
    for (i, m) in marks.iter().enumerate().skip(at) {
        match m.text.as_str() {
            "{" => depth += 1,
            "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return i + 1;
        }
    }
    marks.len()
}

/// For each mark the end of the unit that begins with it, as [`unit`] has it.
pub(super) fn units(marks: &[Mark]) -> Vec<usize> {
    let mut ends: Vec<usize> = (1..=marks.len()).collect();
    let mut open = Vec::new();
    for (at, mark) in marks.iter().enumerate() {
        match mark.text.as_str() {
            "{" => {
                ends[at] = marks.len();
                open.push(at);
            }
            "}" => {
                if let Some(start) = open.pop() {
                    ends[start] = at + 1;
                }
            }
            _ => {}
        }
    }
    ends
}

/// Subscripts before superscripts: `m^2_3` is printed as `m_3^2` is.
fn ordered(marks: &[Mark]) -> Vec<Mark> {
    let ends = units(marks);
    let unit = |at: usize, to: usize| ends.get(at).map_or(to, |end| (*end).min(to));
    let mut out = Vec::with_capacity(marks.len());
    // What is still to be put there, the next one last.
    let mut left = vec![(0, marks.len())];
    while let Some((mut at, to)) = left.pop() {
        while at < to {
            let (middle, is_above) = (unit(at + 1, to), marks[at].text == "^");
            if is_above && middle > at + 1 && middle < to && marks[middle].text == "_" {
                let end = unit(middle + 1, to);
                left.extend([(end, to), (at + 1, middle), (at, at + 1), (middle, end)]);
                break;
            }
            out.push(marks[at].clone());
            at += 1;
        }
    }
    out
}

/// Words that stand between formulas.
const BETWEEN: &[&str] = &["and", "or", "with", "where", "for", "if"];

/// A formula in parts: at commas, wide spaces and breaks of lines that stand outside of all brackets, and at words between
/// formulas. Commas and stops at the end of a part are no part of it.
pub(super) fn parts(tokens: &[Token]) -> Vec<Vec<Token>> {
    let mut out = vec![Vec::new()];
    let (mut braces, mut brackets, mut environments) = (0i32, 0i32, 0i32);
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        let outside = braces == 0 && brackets <= 0 && environments == 0;
        let mut separates = false;
        match token.kind {
            Kind::Open => braces += 1,
            Kind::Close => braces -= 1,
            Kind::Other if braces == 0 => match token.text.as_str() {
                "(" | "[" => brackets += 1,
                ")" | "]" => brackets -= 1,
                "," | ";" => separates = outside,
                _ => {}
            },
            Kind::Command => match token.text.as_str() {
                "begin" | "end" => {
                    let (name, _) = group_text(tokens, at);
                    let step = if token.text == "begin" { 1 } else { -1 };
                    environments += if INNER.contains(&name.as_str()) { 0 } else { step };
                }
                "lbrack" => brackets += 1,
                "rbrack" => brackets -= 1,
                "quad" | "qquad" => separates = outside,
                "\\" | "cr" | "newline" if braces == 0 && environments == 0 => {
                    // No bracket reaches over a break that the author means as one.
                    brackets = 0;
                    separates = true;
                    at = after_row(tokens, at);
                }
                "text" | "mbox" | "hbox" | "textrm" | "mathrm" if outside => {
                    let (text, after) = group_text(tokens, at);
                    let word = text.trim_matches(|c: char| !c.is_alphabetic());
                    if BETWEEN.contains(&word) {
                        separates = true;
                        at = after;
                    }
                }
                _ => {}
            },
            _ => {}
        }
        if separates {
            out.push(Vec::new());
        } else if let Some(part) = out.last_mut() {
            part.push(token.clone());
        }
    }
    out.iter_mut().for_each(trim);
    out.retain(|part| !marks(part).is_empty());
    out
}

/// Drops stops and spaces from the end of a part.
fn trim(part: &mut Vec<Token>) {
    let idle = |t: &Token| {
        t.kind == Kind::Space
            || (t.kind == Kind::Other && matches!(t.text.as_str(), "." | "," | ";" | "&" | "~"))
            || (t.kind == Kind::Command && NO_PRINT.contains(&t.text.as_str()) && !t.is("right"))
    };
    while part.last().is_some_and(idle) {
        // `\right.` ends a bracket, and not a sentence.
        let right = part.len() > 1 && part[part.len() - 2].is("right");
        if right && part.last().is_some_and(|t| t.is_char(".")) {
            return;
        }
        part.pop();
    }
}

/// A formula as text again, with single spaces where commands need them; labels and marks of alignment are left out.
pub(super) fn text_of(tokens: &[Token]) -> String {
    let mut out = String::new();
    let mut at = 0;
    let mut arrays = 0;
    // Whether what is written ends with the name of a command.
    let mut after_command = false;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match token.kind {
            Kind::Command if matches!(token.text.as_str(), "label" | "tag") => at = group_text(tokens, at).1,
            Kind::Command if matches!(token.text.as_str(), "nonumber" | "notag") => {}
            Kind::Command if matches!(token.text.as_str(), "begin" | "end") => {
                let (name, after) = group_text(tokens, at);
                let inner = INNER.contains(&name.as_str());
                if !inner {
                    arrays += if token.text == "begin" { 1 } else { -1 };
                    out.push_str(&format!("\\{}{{{name}}}", token.text));
                    after_command = false;
                }
                at = if inner && name == "alignedat" && token.text == "begin" {
                    group_text(tokens, after).1
                } else {
                    after
                };
            }
            Kind::Other if token.text == "&" && arrays == 0 => {}
            Kind::Command => {
                out.push('\\');
                out.push_str(&token.text);
                after_command = !token.text.is_empty() && token.text.chars().all(|c| c.is_ascii_alphabetic());
            }
            Kind::Space => {
                if !out.ends_with(' ') {
                    out.push(' ');
                    after_command = false;
                }
                continue;
            }
            _ => {
                let letter = token.text.starts_with(|c: char| c.is_ascii_alphabetic());
                if std::mem::take(&mut after_command) && letter {
                    out.push(' ');
                }
                out.push_str(&token.text);
            }
        }
    }
    out.trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    fn shown(text: &str) -> String {
        marks(&tokens(text)).into_iter().map(|m| m.text.to_string()).collect::<Vec<_>>().join(" ")
    }

    #[track_caller]
    fn same(a: &str, b: &str) {
        assert_eq!(shown(a), shown(b), "{a} and {b}");
        assert_eq!(print(&tokens(a)), print(&tokens(b)), "{a} and {b}");
    }

    #[test]
    fn what_is_printed_alike_is_the_same() {
        same(r"\dot R_{ij} = -x", r"\dot  R_{ij}=-x");
        same(r"m^2_3", r"m_3^{2}");
        same(r"\frac{1}{2}x", r"\frac12 x");
        same(r"\dfrac{d\psi}{dt}", r"\frac{d\psi}{dt}");
        same(r"\left(\frac{a}{b}\right)^2", r"(\frac ab)^{2}");
        same(r"a\leq b\,,\;c\neq0", r"a\le b,c\ne 0");
        same(r"x_{k}^{n+1}", r"x^{n+1}_k");
        same(r"a &= b \nonumber\\ &+ c", r"a=b\\+c");
        same(r"\begin{split}a&=b\end{split}", "a=b");
        same(r"T_{\text{ a  b }}c d", r"T_{\text{a b}}cd");
    }

    #[test]
    fn braces_that_hold_no_argument_print_nothing() {
        for (a, b) in [("{ab}c", "a{bc}"), (r"\alpha{ab}", r"\alpha ab"), ("e^{x}+{y+z}", "e^x+y+z"), ("{{a}b}", "ab")]
        {
            assert_eq!(print(&tokens(a)), print(&tokens(b)), "{a} and {b}");
        }
    }

    #[test]
    fn what_is_printed_otherwise_is_not() {
        for (a, b) in [
            (r"\frac{12}{x}", r"\frac{1}{2x}"),
            ("x^{2a}", "x^2a"),
            (r"\sqrt{x+y}", r"\sqrt{x}+y"),
            (r"\frac\pi{2x}", r"\frac{\pi}2x"),
            (r"{\bf m}x", r"{\bf mx}"),
            (r"\bar{ab}", r"\bar ab"),
            (r"T_{\text{a b}}", r"T_{\text{ab}}"),
            ("a+b", "a-b"),
            (r"\Omega", r"\omega"),
            ("x_1", "x^1"),
            (r"\frac12x", r"\frac1{2x}"),
            (r"{\bf m}", "m"),
            ("ab", "ba"),
            ("a^{b_c}", "a^b_c"),
            (r"\sin^2x", r"\sin x^2"),
            ("T_a{}^b", "T_a^b"),
            ("T^a{}_b", "T^a_b"),
            ("x{}_2F", "x_2F"),
            ("{x_a}_{bc}", "x_{abc}"),
        ] {
            assert_ne!(shown(a), shown(b), "{a} and {b}");
            assert_ne!(print(&tokens(a)), print(&tokens(b)), "{a} and {b}");
        }
    }

    #[test]
    fn parts_are_what_stands_between_commas_and_breaks() {
        let of = |t: &str| parts(&tokens(t)).iter().map(|p| text_of(p)).collect::<Vec<_>>();
        assert_eq!(of(r"a=[b,c], \quad d=f(x,y). "), ["a=[b,c]", "d=f(x,y)"]);
        assert_eq!(of(r"\dot q=p,\cr \dot p=-q.\\[2pt] z=1"), [r"\dot q=p", r"\dot p=-q", "z=1"]);
        assert_eq!(
            of(r"R=\left(\begin{array}{cc}1&2\\3&4\end{array}\right)."),
            [r"R=\left(\begin{array}{cc}1&2\\3&4\end{array}\right)"]
        );
        assert_eq!(of(r"a=b \text{ and } c=\text{const}"), ["a=b", r"c=\text{const}"]);
    }

    #[test]
    fn no_text_panics() {
        let text =
            r"\left.{x}^{2}_{\begin{split}a\\[2pt]b^{c}_}\text{and}\\*[1em]\right.\label{\}^_\begin{alignedat}{2}";
        for end in 0..text.len() {
            let all = tokens(&text[..end]);
            let _ = (shown(&text[..end]), parts(&all), text_of(&all));
        }
    }
}
