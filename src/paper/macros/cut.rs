//! Where a document that is too long can be cut.
//!
//! **In:** the first tokens of it. **Out:** how many are whole: up to the last display that begins, or the last paragraph that ends, outside of all
//! environments and formulas. **Guaranteed:** no display is cut, and none loses what stands behind it up to the next.

use super::super::token::{Kind, Token};

/// How many tokens stand before the last place at which a document can be cut.
pub(super) fn end_of_whole(all: &[Token]) -> usize {
    let (mut end, mut open, mut depth) = (0, 0usize, 0usize);
    let (mut formula, mut at) = (false, 0);
    while let Some(token) = all.get(at) {
        let is_doubled = token.is_doubled_by(all.get(at + 1));
        let outside = open == 0 && depth == 0 && !formula;
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Space if outside && token.text.contains('\n') => end = at,
            Kind::Dollar => {
                if outside && is_doubled {
                    end = at;
                }
                formula = !formula;
                at += usize::from(is_doubled);
            }
            Kind::Command if token.is("begin") && begins_document(all, at + 1) => {}
            Kind::Command if matches!(token.text.as_str(), "[" | "(" | "begin") => {
                if outside && !token.is("(") {
                    end = at;
                }
                open += 1;
            }
            Kind::Command if matches!(token.text.as_str(), "]" | ")" | "end") => open = open.saturating_sub(1),
            _ => {}
        }
        at += 1;
    }
    end
}

fn begins_document(all: &[Token], at: usize) -> bool {
    let name = "{document}";
    all.iter().skip(at).take(name.len()).flat_map(|t| t.text.chars()).eq(name.chars())
}

#[cfg(test)]
mod tests {
    use super::super::super::token::tokens;
    use super::end_of_whole;

    #[test]
    fn a_document_is_cut_outside_of_formulas() {
        let kept = |text: &str| {
            let all = tokens(text);
            let end = end_of_whole(&all);
            all.get(end).map_or(text.len(), |t| t.span.start)
        };
        for (whole, rest) in [
            (r"\[ a=b \] for $x>0$ ", r"\[ c=d+"),
            (r"\[ a=b \] for $x>0$ ", r"$$ c=d+"),
            (r"$$ a=b $$ and ", r"\begin{align} c &= \begin{aligned} d \end{aligned}"),
            ("$a=b$ and $c=d$.", "\n\nNext $e="),
            (r"\begin{document} $$ a=b $$ and ", r"\[ c=d \]"),
            ("", r"\begin{itemize} \item \[ a=b \] \item \[ c=d"),
        ] {
            assert_eq!(kept(&format!("{whole}{rest}")), whole.len(), "{whole}{rest}");
        }
    }
}
