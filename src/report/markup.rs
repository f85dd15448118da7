//! Texts and formulas as Markdown, so that nothing in them is markup that the report did not mean.
//!
//! **In:** texts of a file. **Out:** Markdown, as a forge renders it. What could do more there than set a formula is shown as it
//! is written.

use super::mathml;
use latex::printed;

/// Text of the file: formulas between dollar signs and code between backticks are kept, and what else Markdown would take
/// for markup is made harmless.
pub fn prose(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut out = String::new();
    let mut rest = text.as_str();
    while let Some(c) = rest.chars().next() {
        let after = &rest[c.len_utf8()..];
        if let Some(end) = after.find(c).filter(|end| (c == '`' || c == '$') && *end > 0) {
            let inner = &after[..end];
            let shown = printed(inner).filter(|shown| !shown.trim().is_empty());
            let written = match shown {
                Some(shown) if c == '$' => written_math(&shown),
                shown => code(shown.as_deref().unwrap_or(inner)),
            };
            // Two signs with nothing between them are signs: side by side, they would join with the next ones.
            if !inner.trim().is_empty() {
                append(&mut out, &written);
                rest = &after[end + 1..];
                continue;
            }
        }
        match c {
            '<' => out.push_str("&lt;"),
            // Where a line may begin with it: a list, a quotation, a heading that is underlined, a command to a log.
            '>' if out.is_empty() => out.push_str("&gt;"),
            ':' if out.is_empty() && after.starts_with(':') => out.push_str("&#58;"),
            '-' | '+' | '=' if out.is_empty() && after.starts_with([' ', c]) => out.extend(['\\', c]),
            '.' | ')' if after.starts_with(' ') && !out.is_empty() && out.bytes().all(|b| b.is_ascii_digit()) => {
                out.extend(['\\', c]);
            }
            // No address becomes a link: a link takes what follows for its own, signs of code among it.
            ':' if after.starts_with("//") => out.push_str(":<!-- -->"),
            'w' | 'W' if after.starts_with('.') && ends_with_ww(&out) => {
                out.push(c);
                out.push_str("<!-- -->");
            }
            // A name of a sign between it and a semicolon would be that sign.
            '&' if after.starts_with(|next: char| next.is_ascii_alphanumeric() || next == '#') => out.push_str("&amp;"),
            // Between letters it is one of them; elsewhere it may set what follows in italics.
            '_' if !(out.ends_with(char::is_alphanumeric) && after.starts_with(char::is_alphanumeric)) => {
                out.push_str(r"\_");
            }
            // Whoever is named is not told of it.
            '@' if after.starts_with(|next: char| next.is_alphanumeric()) => out.push_str("@<!-- -->"),
            // Before punctuation it would take away the meaning of what is written next.
            '\\' if after.chars().next().is_none_or(|next| next.is_ascii_punctuation()) => out.push_str(r"\\"),
            '*' | '|' | '`' | '#' | '[' | ']' | '$' | '~' => out.extend(['\\', c]),
            c => out.push(c),
        }
        rest = after;
    }
    out
}

fn ends_with_ww(text: &str) -> bool {
    text.as_bytes().last_chunk::<2>().is_some_and(|last| last.eq_ignore_ascii_case(b"ww"))
}

/// Adds what comes next. Two pieces of code side by side would be one, and take what follows for code or for text as its signs happen to pair.
pub(super) fn append(out: &mut String, next: &str) {
    if out.ends_with('`') && next.starts_with('`') {
        out.push_str("<!-- -->");
    }
    out.push_str(next);
}

/// A formula in a text. What a forge could do more with than set it is shown as it is written.
fn written_math(formula: &str) -> String {
    let mut commands = formula.split('\\').skip(1).map(|rest| {
        let name = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        &rest[..name]
    });
    let harmless = |name: &str| name.is_empty() || mathml::letter(name).is_some() || SET_ONLY.contains(&name);
    if commands.all(harmless) && !formula.contains('%') { math(formula) } else { code(formula) }
}

/// Commands of LaTeX, beside those of letters, that set something and do nothing else.
const SET_ONLY: &[&str] = &[
    "arccos",
    "arcsin",
    "arctan",
    "array",
    "bar",
    "bf",
    "big",
    "Big",
    "boldsymbol",
    "cal",
    "cdot",
    "cdots",
    "circ",
    "cos",
    "cosh",
    "cot",
    "coth",
    "cr",
    "ddot",
    "dddot",
    "det",
    "dfrac",
    "displaystyle",
    "div",
    "dot",
    "dots",
    "ell",
    "equiv",
    "exists",
    "exp",
    "forall",
    "frac",
    "ge",
    "geq",
    "gg",
    "hat",
    "in",
    "infty",
    "int",
    "it",
    "langle",
    "ldots",
    "le",
    "left",
    "leq",
    "lim",
    "limits",
    "ln",
    "log",
    "lvert",
    "mathbb",
    "mathbf",
    "mathcal",
    "mathrm",
    "mathsf",
    "max",
    "min",
    "mp",
    "nabla",
    "ne",
    "neq",
    "not",
    "operatorname",
    "partial",
    "perp",
    "pm",
    "prime",
    "prod",
    "propto",
    "qquad",
    "quad",
    "rangle",
    "right",
    "rightarrow",
    "rm",
    "rvert",
    "sf",
    "sim",
    "simeq",
    "sin",
    "sinh",
    "sqrt",
    "sum",
    "tan",
    "tanh",
    "text",
    "textstyle",
    "tfrac",
    "tilde",
    "times",
    "to",
    "top",
    "Rightarrow",
    "vec",
    "vert",
    "wedge",
    "approx",
];

/// A text as it is written.
pub(super) fn code(text: &str) -> String {
    let text = if text.trim().is_empty() { " " } else { text };
    // Renderers differ on where a cell of a table ends that has both.
    if text.contains(r"\|") {
        let sign = |c: char| if c.is_ascii_punctuation() { format!("&#{};", u32::from(c)) } else { c.to_string() };
        return format!("<code>{}</code>", text.chars().map(sign).collect::<String>());
    }
    format!("`{}`", text.replace('|', r"\|").replace('`', "'"))
}

/// A formula inside a line.
pub(super) fn math(formula: &str) -> String {
    let one_line = formula.split_whitespace().collect::<Vec<_>>().join(" ");
    // In a table a bar ends the cell, even inside a formula.
    let one_line = if one_line.is_empty() { " ".to_owned() } else { one_line };
    format!("$`{}`$", one_line.replace(r"\|", r"\Vert ").replace('|', r"\vert ").replace('`', "'"))
}

/// A formula on its own lines.
pub(super) fn display(formula: &str) -> String {
    let lines: Vec<&str> = formula.lines().map(str::trim).filter(|l| !l.is_empty()).collect();
    let body = lines.join("\n");
    let broken = body.contains(r"\cr") || body.contains(r"\\");
    if broken && !body.contains(r"\begin{") {
        let body = body.replace(r"\cr", r"\\");
        return fenced("math", &format!("\\begin{{gathered}}\n{body}\n\\end{{gathered}}"));
    }
    fenced("math", &body)
}

/// A text as it is, between fences that are longer than any in it.
pub fn fenced(kind: &str, body: &str) -> String {
    let mut longest = 0;
    let mut run = 0;
    for c in body.chars() {
        run = if c == '`' { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    let fence = "`".repeat(3.max(longest + 1));
    format!("{fence}{kind}\n{body}\n{fence}\n\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_begins_a_block_or_tells_somebody() {
        for (text, written) in [
            ("~~~ x", r"\~\~\~ x"),
            ("- item", r"\- item"),
            ("+ item", r"\+ item"),
            ("=== a - b", r"\=== a - b"),
            ("> said", "&gt; said"),
            ("12. item", r"12\. item"),
            ("3) item, 1.5", r"3\) item, 1.5"),
            ("::error::x", "&#58;:error::x"),
            ("-0.5 and 1.5", "-0.5 and 1.5"),
            ("1.5: so", "1.5: so"),
            ("see http://e/`<b>`, WWW.e/`<b>`", "see http:<!-- -->//e/`<b>`, WWW<!-- -->.e/`<b>`"),
            ("&commat;x &num;1 a & b &#64;", "&amp;commat;x &amp;num;1 a & b &amp;\\#64;"),
            ("___", r"\_\_\_"),
            ("_x_ and t_8, x_", r"\_x\_ and t_8, x\_"),
            (r"`a\|<b>`", "<code>a&#92;&#124;&#60;b&#62;</code>"),
            ("by @octocat and a@b, @ 5", "by @<!-- -->octocat and a@<!-- -->b, @ 5"),
        ] {
            assert_eq!(prose(text), written);
        }
    }

    #[test]
    fn what_prints_nothing_leaves_no_sign_that_joins_with_others() {
        for (text, written) in [
            ("` ``<img src=x>`", r"\` \`<!-- -->`<img src=x>`"),
            ("`` `", r"\`\` \`"),
            ("$ $``[](x)`", r"\$ \$\`<!-- -->`[](x)`"),
            ("`a``b`", "`a`<!-- -->`b`"),
            (r"`\label{x}``[a](b)`", r"`\label{x}`<!-- -->`[a](b)`"),
            ("$%x$`<b>`", "`%x`<!-- -->`<b>`"),
        ] {
            assert_eq!(prose(text), written);
        }
    }

    #[test]
    fn formulas_survive_markdown() {
        assert_eq!(math("|x|_1"), r"$`\vert x\vert _1`$");
        assert_eq!(math(r"\|x\|"), r"$`\Vert x\Vert `$");
        assert_eq!(prose("`a|b` and $x|y$, <b>*"), r"`a\|b` and $`x\vert y`$, &lt;b>\*");
        assert_eq!(prose("costs 3$ or `"), r"costs 3\$ or \`");
        assert_eq!(prose(r"\`<b>` \[x\](y) \alpha \\* \"), r"\\`<b>` \\\[x\\\](y) \alpha \\\\\* \\");
        assert_eq!(fenced("", "a```b"), "````\na```b\n````\n\n");
        assert!(display("a=b \\cr c=d").contains("\\begin{gathered}\na=b \\\\ c=d\n"));
    }
}
