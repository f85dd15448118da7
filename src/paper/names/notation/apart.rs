//! Scripts that do not stand above each other: `T^a{}_b`, `T_a{}^b`, `T^a_{\ b}`, `{}_aT`.
//!
//! **In:** the tokens of a side. **Out:** whether such scripts stand in it. **Guaranteed:** a power behind a name with a subscript, or behind brackets,
//! is none, however it is set: `x_a{}^2`.

use super::super::super::token::{Kind, Token};

/// Whether scripts of one letter stand behind each other, or one before the letter that it belongs to.
pub(super) fn has_scripts_apart(all: &[Token]) -> bool {
    let partners = partners(all);
    let is_script = |t: Option<&Token>| t.is_some_and(|t| t.is_char("_") || t.is_char("^"));
    // A space that the author set has no length in the source.
    let is_set = |t: &Token| t.kind == Kind::Space && t.span.is_empty();
    // The token before a place, other than spaces.
    let before = |at: usize| all[..at].iter().rposition(|t| t.kind != Kind::Space);
    // Where what ends with a token begins, and whether it is a script.
    let begin_of = |end: usize| partners[end].filter(|_| all[end].kind == Kind::Close).unwrap_or(end);
    let ends_script = |end: usize| before(begin_of(end)).is_some_and(|at| is_script(all.get(at)));
    (0..all.len()).filter(|&at| is_script(all.get(at))).any(|at| {
        let Some(last) = before(at) else { return false };
        let is_power = all[at].is_char("^") && is_number(all, at + 1);
        let is_bracket = |t: &Token| t.is_char(")") || t.is_char("]") || t.is("}");
        if all[last].kind == Kind::Close && partners[last].is_some_and(|open| before(last) == Some(open)) {
            let Some(base) = partners[last].and_then(before) else { return false };
            return !(is_power && (ends_script(base) || is_bracket(&all[base])));
        }
        if all[last + 1..at].iter().any(is_set) {
            // `2\,^3P`
            let behind =
                if all.get(at + 1).is_some_and(|t| t.kind == Kind::Open) { partners[at + 1] } else { Some(at + 1) };
            let behind = behind.and_then(|end| all.get(end + 1));
            return !is_power
                || behind.is_some_and(|t| t.kind == Kind::Other && t.text.starts_with(char::is_alphabetic));
        }
        // `T^a_{\ b}`, `T^{\ a}_b`
        let open = at + 1;
        let is_spaced = all.get(open).is_some_and(|t| t.kind == Kind::Open) && all.get(open + 1).is_some_and(is_set);
        if !is_spaced || is_power {
            return false;
        }
        let other = match ends_script(last) {
            true => before(begin_of(last)),
            false => partners[open].map(|end| end + 1).filter(|at| is_script(all.get(*at))),
        };
        other.is_some_and(|at| !(all[at].is_char("^") && is_number(all, at + 1)))
    })
}

/// For each brace of a group that is closed the other one.
fn partners(all: &[Token]) -> Vec<Option<usize>> {
    let (mut out, mut open) = (vec![None; all.len()], Vec::new());
    for (at, token) in all.iter().enumerate() {
        match token.kind {
            Kind::Open => open.push(at),
            Kind::Close => {
                if let Some(from) = open.pop() {
                    (out[from], out[at]) = (Some(at), Some(from));
                }
            }
            _ => {}
        }
    }
    out
}

/// Whether what is raised is a number that is a power: 2, 12, -1.
fn is_number(all: &[Token], from: usize) -> bool {
    let inside: String = match all.get(from) {
        Some(t) if t.kind == Kind::Open => {
            all[from + 1..].iter().take_while(|t| t.kind != Kind::Close).map(|t| t.text.as_str().trim()).collect()
        }
        Some(t) => t.text.to_string(),
        None => return false,
    };
    let digits = inside.strip_prefix('-').unwrap_or(&inside);
    digits.parse::<u32>().is_ok_and(|n| n > 1 || inside.starts_with('-'))
}

#[cfg(test)]
mod tests {
    use super::super::super::super::printed::PrintedSide;
    use super::has_scripts_apart;

    fn side(text: &str) -> PrintedSide {
        let source = diag::Source { path: "p.tex".into(), text: format!("${text}=0$") };
        let paper = crate::parse(source, String::new()).expect("read");
        paper.printed[0].sides[0].clone()
    }

    #[test]
    fn scripts_that_stand_behind_each_other_are_seen() {
        for text in [
            "T^a{}_b",
            "T_a{}^b",
            "T^{a}{ }_{b}",
            "T{}^a{}_b",
            r"T^a\,_b",
            r"T_a\;^b",
            r"T_{a}^{\ b}",
            r"T^{a}_{\; b}",
            r"T^{\ a}_{b}",
            "x_a{}_b",
            "x{}_2F_1",
            "x^2{}_a",
            "T_1{}^1",
        ] {
            assert!(has_scripts_apart(&side(text).tokens), "{text}");
        }
        for text in [
            "T^a_b",
            "x_a{}^2",
            "x_{a}{}^{2}",
            "(a+b){}^2",
            r"\left(a\right){}^{-1}",
            r"x_{\,a}^2",
            r"x_a^{\,2}",
            r"x_{\,a}",
            r"e^{\,x}",
            r"x_a\,y^b",
            "{x}_a",
            "x_{a{}}",
        ] {
            assert!(!has_scripts_apart(&side(text).tokens), "{text}");
        }
    }
}
