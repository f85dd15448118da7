//! Texts and formulas as LaTeX source, so that nothing in them is a command.
//!
//! **In:** texts of a file. **Out:** LaTeX that plain `pdflatex` compiles with `amsmath`, `amssymb` and `bm`. **Guaranteed:** no command of
//! a text is carried out; formulas are written anew from their syntax trees; letters that LaTeX does not know are commands or spelled out.

use super::wording::{self, Part};
use latex::{self, Scope, syntax};

/// A formula inside a line.
pub(super) fn inline(text: &str, scope: &Scope) -> String {
    match latex::parse(text, scope) {
        Ok(chains) => {
            let all: Vec<String> = chains.iter().map(|c| format!("${}$", syntax::to_latex(c))).collect();
            all.join(", ")
        }
        Err(_) => format!("\\texttt{{{}}}", escaped(text)),
    }
}

/// A formula on lines of its own.
pub(super) fn display(text: &str, scope: &Scope) -> String {
    match latex::parse(text, scope) {
        Ok(chains) => chains.iter().map(|c| format!("\\[{}\\]", syntax::to_latex(c))).collect::<Vec<_>>().join("\n"),
        Err(_) => format!("\\begin{{quote}}\\texttt{{{}}}\\end{{quote}}", escaped(text)),
    }
}

/// What a comparison is called: a formula, then perhaps its component, or words.
pub(super) fn label(text: &str, scope: &Scope) -> String {
    let label = wording::label(text);
    let component = label.component.map(|c| format!(", component {}", inline(c, scope))).unwrap_or_default();
    format!("{}{}{}{component}", escaped(label.before), inline(label.formula, scope), escaped(label.after))
}

/// A text of the file: `$…$` and `` `…` `` are formulas where they can be read as such.
pub(super) fn prose(text: &str, scope: &Scope) -> String {
    let written = |part: &Part<'_>| match part {
        Part::Words(words) => escaped(words),
        Part::Formula(text) => inline(text, scope),
    };
    wording::parts(&wording::one_line(text)).iter().map(written).collect()
}

/// Text in which nothing is a command.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::new();
    let mut letters = text.chars().peekable();
    while let Some(c) = letters.next() {
        match c {
            c if raised(c).is_some() => {
                let mut power: String = raised(c).into_iter().collect();
                while let Some(next) = letters.peek().copied().and_then(raised) {
                    power.push(next);
                    letters.next();
                }
                out.push_str(&format!("$^{{{power}}}$"));
            }
            '\\' => out.push_str(r"\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => out.extend(['\\', c]),
            '^' => out.push_str(r"\textasciicircum{}"),
            '~' => out.push_str(r"\textasciitilde{}"),
            '<' => out.push_str(r"\textless{}"),
            '>' => out.push_str(r"\textgreater{}"),
            '|' => out.push_str(r"\textbar{}"),
            '"' => out.push_str("''"),
            '`' => out.push_str(r"\textasciigrave{}"),
            c if c.is_ascii_graphic() || c == ' ' => out.push(c),
            // Letters of western languages are known to the font encoding.
            '\u{a1}'..='\u{17f}' => out.push_str(&latin(c)),
            c => out.push_str(&sign(c)),
        }
    }
    // In the log of a workflow a line that begins so is a command.
    out.replace("::", ":{}:")
}

/// The letter of a power that is written with raised digits.
fn raised(c: char) -> Option<char> {
    const DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let digit = DIGITS.chars().zip('0'..='9').find_map(|(small, digit)| (small == c).then_some(digit));
    digit.or((c == '⁻').then_some('-'))
}

/// A sign of the range Latin-1 and Latin Extended-A.
fn latin(c: char) -> String {
    match c {
        '·' => r"$\cdot$".into(),
        '×' => r"$\times$".into(),
        '÷' => r"$\div$".into(),
        '±' => r"$\pm$".into(),
        '°' => r"$^\circ$".into(),
        '¬' => r"$\neg$".into(),
        'µ' => r"$\mu$".into(),
        '½' => r"$\frac12$".into(),
        '§' => r"\S{}".into(),
        c if c.is_alphabetic() => c.to_string(),
        c => format!("[U+{:04X}]", u32::from(c)),
    }
}

/// A sign that plain `pdflatex` does not know, as a command; spelled out where there is none.
fn sign(c: char) -> String {
    let command = match c {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' => "varepsilon",
        'ϵ' => "epsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' => "theta",
        'ϑ' => "vartheta",
        'ι' => "iota",
        'κ' => "kappa",
        'λ' => "lambda",
        'μ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'ς' => "varsigma",
        'τ' => "tau",
        'υ' => "upsilon",
        'φ' => "varphi",
        'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Γ' => "Gamma",
        'Δ' => "Delta",
        'Θ' => "Theta",
        'Λ' => "Lambda",
        'Ξ' => "Xi",
        'Π' => "Pi",
        'Σ' => "Sigma",
        'Υ' => "Upsilon",
        'Φ' => "Phi",
        'Ψ' => "Psi",
        'Ω' => "Omega",
        '≠' => "ne",
        '≤' => "le",
        '≥' => "ge",
        '≈' => "approx",
        '≡' => "equiv",
        '∈' => "in",
        '∞' => "infty",
        '∓' => "mp",
        '→' => "rightarrow",
        '⇒' => "Rightarrow",
        '∥' => "parallel",
        '√' => "surd",
        '∂' => "partial",
        'ℓ' => "ell",
        'ℏ' => "hbar",
        '⊥' => "perp",
        '†' => "dagger",
        '⋅' => "cdot",
        _ => "",
    };
    if !command.is_empty() {
        return format!("$\\{command}$");
    }
    match c {
        '−' => "$-$".into(),
        '–' => "--".into(),
        '—' => "---".into(),
        '“' => "``".into(),
        '”' => "''".into(),
        '‘' => "`".into(),
        '’' => "'".into(),
        '…' => r"\ldots{}".into(),
        'ᵀ' => "$^T$".into(),
        '₀'..='₉' => format!("$_{}$", u32::from(c) - u32::from('₀')),
        '′' => "$'$".into(),
        '″' => "$''$".into(),
        'ᵢ' => "$_i$".into(),
        'ⱼ' => "$_j$".into(),
        'ₖ' => "$_k$".into(),
        '\u{a0}' | '\u{2009}' | '\u{202f}' => "~".into(),
        'ℝ' => r"$\mathbb{R}$".into(),
        // Spelled out, so that nothing is lost and nothing stops the compiler.
        c => format!("[U+{:04X}]", u32::from(c)),
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;

    #[test]
    fn no_text_is_a_command() {
        let derivation = derivation();
        for text in
            [r"\input{secret}", r"\write18{rm}", "50 % of a_b^c & #1 {", "$\\input{x}$", "`\\end{document}`", "日本 🎾"]
        {
            let out = prose(text, &derivation.scope);
            for bad in [r"\input", r"\write", r"\end{", "日", "🎾"] {
                assert!(!out.contains(bad), "{text}: {out}");
            }
            assert!(!out.contains('%') || out.contains(r"\%"), "{out}");
        }
    }
}
