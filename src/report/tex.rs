//! The report as LaTeX source, for an appendix or a letter to an editor: plain `pdflatex` compiles it.
//!
//! **In:** a derivation and its account. **Out:** one file that needs only `amsmath`, `amssymb`, `bm` and `longtable`, which
//! every distribution has.
//!
//! **Guaranteed:** texts of the file are escaped: no command of theirs is carried out. Formulas are written anew from their
//! syntax trees, so that only commands of the formula language reach LaTeX; a text that is no formula is set as it is,
//! letter by letter. Letters that plain `pdflatex` does not know are replaced by commands or spelled out.

use super::digest::{self, Fate, Whole};
use super::form::{Heading, heading};
use super::graph::DerivationGraph;
use super::headline;
use super::numbers::count;
use super::numbers::{ascii_six as six, ascii_six as time, ascii_size as size};
use super::tally::{Group, declared, groups, name, says};
use super::wording::{self, Part};
use crate::derivation::Derivation;
use crate::latex::{self, Scope, syntax};
use findings::Account;

const PREAMBLE: &str = r"\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath,amssymb,bm,longtable}
\usepackage[margin=25mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 2pt}
\emergencystretch=3em
\allowdisplaybreaks
\begin{document}
";

/// The LaTeX source.
pub fn tex(derivation: &Derivation, account: &Account) -> String {
    let scope = &derivation.scope;
    let mut out = PREAMBLE.to_owned();
    out.push_str(&format!("\\section*{{{}}}\n\n", prose(&derivation.title, scope)));
    out.push_str(&format!("What is checked: {}\n\n", prose(&derivation.concerns, scope)));
    if let Some(text) = &derivation.source {
        out.push_str(&format!("{}\n\n", prose(text, scope)));
    }
    findings(derivation, account, &mut out);
    if !derivation.conventions.is_empty() {
        out.push_str("\\subsection*{Conventions}\n\\begin{description}\n");
        for (key, text) in &derivation.conventions {
            out.push_str(&format!("\\item[{}] {}\n", escaped(&key.replace('-', " ")), prose(text, scope)));
        }
        out.push_str("\\end{description}\n\n");
    }
    claims(derivation, account, &mut out);
    trajectories(derivation, account, &mut out);
    let path = super::project_path(&derivation.file.path);
    out.push_str(&format!(
        "\\subsection*{{How it was made}}\n{} {}, from the file {}, SHA-256\\\\\\texttt{{\\footnotesize {}}}.\\\\\nTo repeat it: \
         \\texttt{{{} check {}}}\n\n\\end{{document}}\n",
        crate::PROGRAM,
        env!("CARGO_PKG_VERSION"),
        escaped(&path),
        derivation.sha256,
        crate::PROGRAM,
        escaped(&path)
    ));
    out
}

fn findings(derivation: &Derivation, account: &Account, out: &mut String) {
    let scope = &derivation.scope;
    let wholes = digest::wholes(derivation, account);
    out.push_str("\\subsection*{What was found}\n\n");
    out.push_str(&super::story::tex(&super::page_one::blocks(derivation, account)));
    if let Some(remark) = &derivation.remark {
        out.push_str(&format!("\\emph{{Remark of the file:}} {}\n\n", prose(remark, scope)));
    }
    let unexpected: Vec<String> = headline::unexpected(account).into_iter().map(name).collect();
    let expected = match unexpected.is_empty() {
        true => "Every verdict is as the derivation file expects.".to_owned(),
        false => format!("Not as the derivation file expects: {}.", unexpected.join(", ")),
    };
    out.push_str(&format!("{} {}\n\n", escaped(&headline::tried(account)), escaped(&expected)));
    for fate in Fate::ALL {
        let found: Vec<&Whole<'_>> = wholes.iter().filter(|w| w.fate == fate).collect();
        if found.is_empty() {
            continue;
        }
        let heading = format!("{} {}", count(found.len(), "claim"), fate.words(found.len()));
        out.push_str(&format!("\\subsubsection*{{{}}}\n{}\n", escaped(&heading), escaped(fate.meaning())));
        out.push_str("\\begin{itemize}\n");
        for whole in found {
            out.push_str(&whole_in_words(whole, scope));
        }
        out.push_str("\\end{itemize}\n\n");
    }
    let unsaid = digest::unsaid(derivation, account);
    if !unsaid.is_empty() {
        out.push_str("\\subsubsection*{What was left unsaid}\n\\begin{itemize}\n");
        for u in &unsaid {
            let claims: Vec<String> = u.claims.iter().map(|c| escaped(&name(c))).collect();
            out.push_str(&format!(
                "\\item {}: {}\n",
                prose(&digest::explanation(u.explanation), scope),
                claims.join(", ")
            ));
        }
        out.push_str("\\end{itemize}\n\n");
    }
}

/// The first page as a document of its own, for a letter.
pub fn tex_summary(derivation: &Derivation, account: &Account) -> String {
    let scope = &derivation.scope;
    let mut out = PREAMBLE.replace("11pt", "10pt").replace("margin=25mm", "margin=20mm");
    out.push_str(&format!("\\section*{{{}}}\n\n", prose(&derivation.title, scope)));
    out.push_str(&format!("What is checked: {}\n\n", prose(&derivation.concerns, scope)));
    out.push_str(&super::story::tex(&super::page_one::blocks(derivation, account)));
    out.push_str("\\end{document}\n");
    out
}

/// An item of the list of claims; for one that does not stand, what became of each reading, and why.
fn whole_in_words(whole: &Whole<'_>, scope: &Scope) -> String {
    let place = whole.place.map(|p| format!("{}; ", prose(p, scope))).unwrap_or_default();
    let basis = whole.basis().filter(|_| whole.fate == Fate::Stands);
    let basis = basis.map(|b| format!(": {}", prose(&b.words(), scope))).unwrap_or_default();
    let mut out = format!("\\item {} ({place}{}){basis}.\n", prose(&whole.says, scope), escaped(whole.id));
    if whole.fate == Fate::Stands {
        return out;
    }
    out.push_str("\\begin{itemize}\n");
    for reading in &whole.readings {
        let mut parts = Vec::new();
        let whose = reading.whose(whole);
        if !whose.is_empty() {
            parts.push(format!("({})", escaped(whose)));
        }
        if reading.claim.reading.is_some() {
            parts.push(prose(&reading.claim.says, scope));
        } else if whole.is_read() {
            parts.push("As it stands.".to_owned());
        }
        let condition =
            digest::condition_of(reading.claim).map(|c| format!("; {}", prose(&c, scope))).unwrap_or_default();
        parts.push(format!("\\textbf{{{}}}{condition}.", escaped(&digest::verdict(reading))));
        if let Some(remark) = &reading.claim.remark {
            parts.push(format!("\\emph{{{}}}", prose(remark, scope)));
        }
        out.push_str(&format!("\\item {}\n", parts.join(" ")));
    }
    out.push_str("\\end{itemize}\n");
    out
}

fn claims(derivation: &Derivation, account: &Account, out: &mut String) {
    out.push_str("\\subsection*{Claims}\n\n");
    let graph = DerivationGraph::new(derivation, account);
    for claim in &account.claims {
        let declared = declared(derivation, claim);
        let scope = declared.map_or(&derivation.scope, |d| &d.scope);
        out.push_str(&format!(
            "\\subsubsection*{{{}}}\n{}\n",
            escaped(&name(claim)),
            prose(&says(derivation, claim), scope)
        ));
        if let Some(place) = &claim.place {
            out.push_str(&format!(" ({})", prose(place, scope)));
        }
        out.push_str("\n\n");
        for (i, text) in claim.formulas.iter().enumerate() {
            let words = match heading(claim, declared, i).1 {
                Heading::Words(words) => words,
                Heading::System => {
                    out.push_str(&format!("The motion solves the system {}.\n\n", escaped(text)));
                    continue;
                }
                Heading::Trajectory => {
                    out.push_str(&format!("The motion is that of {}.\n\n", escaped(text)));
                    continue;
                }
            };
            out.push_str(&format!("{}:\n{}\n", prose(&words, scope), display(text, scope)));
        }
        if !claim.assumptions.is_empty() {
            let all: Vec<String> = claim.assumptions.iter().map(|a| inline(a, scope)).collect();
            out.push_str(&format!("Assuming {}.\n\n", all.join(", ")));
        }
        if let Some(identity) = &claim.identity {
            let sentence = super::graph::sentence(identity, &graph.proof_of(claim));
            out.push_str(&format!("For all values: {}\n\n", prose(&sentence, scope)));
        }
        for group in groups(claim) {
            verdicts(&group, scope, out);
        }
        for family in &claim.families {
            let said = format!(
                "{} {}{}. {}",
                super::family::heading(family),
                family.family,
                super::family::expected(family),
                super::family::sentence(&super::family::counts(family))
            );
            let remarks = super::family::remarks(family);
            let remarks: String = remarks.iter().map(|text| format!(" {}", super::family::sentence(text))).collect();
            out.push_str(&format!("{}\n\n", prose(&(said + &remarks), scope)));
        }
        if let Some(region) = &claim.region {
            let mut said: Vec<String> = super::region::ranges(region).into_iter().collect();
            said.push(format!("{}{}.", super::region::verdict(region), super::region::expected(region)));
            said.extend(super::region::notes(region).into_iter().map(|n| format!("{n}.")));
            out.push_str(&format!("{}\n\n", prose(&said.join(" "), scope)));
        }
        if let Some(remark) = &claim.remark {
            out.push_str(&format!("\\emph{{Remark of the file:}} {}\n\n", prose(remark, scope)));
        }
    }
}

/// The pairs of a claim with the same verdict, and the clearest witness of those that fail.
fn verdicts(group: &Group<'_>, scope: &Scope, out: &mut String) {
    let word = match group.word {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    };
    let names: Vec<String> = group.pairs.iter().map(|p| escaped(&p.trajectory)).collect();
    out.push_str(&format!("\\textbf{{{word}}} on {}", names.join(", ")));
    if let (true, Some(expected)) = (group.unexpected, group.expected) {
        out.push_str(&format!(" (\\textbf{{expected: {expected}}})"));
    }
    out.push_str(".\n\n");
    let Some(telling) = group.telling() else { return };
    let evidence = telling.verdict.evidence();
    match (&evidence.witness, &evidence.residual) {
        (Some(w), _) if group.word == "fails" => {
            out.push_str(&format!(
                "For instance on {} at $t={}$: left side ${}$, right side ${}$, error bound ${}$, in {}.\n\n",
                escaped(&telling.trajectory),
                power(&time(w.t)),
                power(&six(w.left)),
                power(&six(w.right)),
                power(&size(w.bound)),
                label(&w.formula, scope)
            ));
        }
        (_, Some(r)) if group.word == "holds" => {
            out.push_str(&format!(
                "Largest residual ${}$, with an error bound of ${}$, on {} at $t={}$.\n\n",
                power(&size(r.max)),
                power(&size(r.bound)),
                escaped(&telling.trajectory),
                power(&time(r.at))
            ));
        }
        _ => {
            if let Some(reason) = &evidence.reason {
                out.push_str(&format!(
                    "For instance on {}: {}.\n\n",
                    escaped(&telling.trajectory),
                    prose(&reason.to_string(), scope)
                ));
            }
        }
    }
}

fn trajectories(derivation: &Derivation, account: &Account, out: &mut String) {
    out.push_str("\\subsection*{Motions}\n\\begin{longtable}{p{0.28\\linewidth}p{0.4\\linewidth}p{0.2\\linewidth}}\n");
    out.push_str("motion & what it is & error at most\\\\\n\\hline\n\\endhead\n");
    for t in &account.trajectories {
        out.push_str(&format!(
            "{} & {} ($t$ from ${}$ to ${}$) & ${}$\\\\\n",
            escaped(&t.id),
            prose(&t.title, &derivation.scope),
            power(&time(t.span.0)),
            power(&time(t.span.1)),
            power(&size(t.error))
        ));
    }
    out.push_str("\\end{longtable}\n\n");
}

/// `1.2e-14` as 1.2·10⁻¹⁴.
fn power(number: &str) -> String {
    match number.split_once('e') {
        Some((digits, exponent)) if exponent.parse::<i32>().is_ok() => format!("{digits}\\cdot 10^{{{exponent}}}"),
        _ if number.chars().all(|c| c.is_ascii_digit() || "+-.".contains(c)) => number.to_owned(),
        _ => format!("\\text{{{}}}", escaped(number)),
    }
}

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
fn display(text: &str, scope: &Scope) -> String {
    match latex::parse(text, scope) {
        Ok(chains) => chains.iter().map(|c| format!("\\[{}\\]", syntax::to_latex(c))).collect::<Vec<_>>().join("\n"),
        Err(_) => format!("\\begin{{quote}}\\texttt{{{}}}\\end{{quote}}", escaped(text)),
    }
}

/// What a comparison is called: a formula, then perhaps its component, or words.
fn label(text: &str, scope: &Scope) -> String {
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
    for c in text.chars() {
        match c {
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

/// A sign of the range Latin-1 and Latin Extended-A.
fn latin(c: char) -> String {
    match c {
        '²' => "$^2$".into(),
        '³' => "$^3$".into(),
        '¹' => "$^1$".into(),
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
        '⁻' => "$^{-}$".into(),
        '₀'..='₉' => format!("$_{}$", u32::from(c) - u32::from('₀')),
        '′' => "$'$".into(),
        '″' => "$''$".into(),
        '⁴'..='⁹' => format!("$^{}$", u32::from(c) - u32::from('⁰')),
        '⁰' => "$^0$".into(),
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
    use findings::sample;

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

    #[test]
    fn numbers_have_powers_of_ten() {
        assert_eq!(power("1.2e-14"), r"1.2\cdot 10^{-14}");
        assert_eq!(power("-0.5"), "-0.5");
        assert_eq!(power("no value"), r"\text{no value}");
    }

    #[test]
    fn the_source_is_whole() {
        let out = tex(&derivation(), &sample::account());
        assert!(out.starts_with(r"\documentclass") && out.ends_with("\\end{document}\n"));
        assert_eq!(out.matches(r"\begin{").count(), out.matches(r"\end{").count());
        assert!(out.contains(r"everywhere \textless{}sic\textgreater{}"));
        let page = tex_summary(&derivation(), &sample::account());
        assert!(page.starts_with(r"\documentclass") && page.ends_with("\\end{document}\n"));
        assert_eq!(page.matches(r"\begin{").count(), page.matches(r"\end{").count());
    }
}
