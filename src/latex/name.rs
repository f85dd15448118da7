//! Names of symbols in one canonical spelling.

use super::lexer::{Kind, Token};

/// Greek letters and other commands that are names.
pub(super) const NAMES: &[&str] = &[
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "varrho",
    "sigma",
    "varsigma",
    "tau",
    "upsilon",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "varpi",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Upsilon",
    "Phi",
    "Psi",
    "Omega",
    "varGamma",
    "varDelta",
    "varTheta",
    "varLambda",
    "varXi",
    "varPi",
    "varSigma",
    "varUpsilon",
    "varPhi",
    "varPsi",
    "varOmega",
    "ell",
    "hbar",
    "imath",
    "jmath",
    "aleph",
    "wp",
    "top",
];

/// Whether a command is a letter that names a symbol.
pub fn is_letter_command(command: &str) -> bool {
    NAMES.contains(&command)
}

/// The style that a command gives to the name after it, in canonical spelling.
pub(super) fn style(command: &str) -> Option<&'static str> {
    Some(match command {
        "bf" | "mathbf" | "boldsymbol" | "bm" | "pmb" | "textbf" | "symbf" | "bold" => "bf",
        "vec" | "overrightarrow" => "vec",
        "hat" | "widehat" => "hat",
        "tilde" | "widetilde" => "tilde",
        "bar" | "overline" => "bar",
        "rm" | "mathrm" | "text" | "mbox" | "operatorname" | "textrm" | "textup" | "textnormal" | "mathup" => "rm",
        "cal" | "mathcal" => "cal",
        "sf" | "mathsf" | "textsf" => "sf",
        "mathscr" => "scr",
        "check" | "widecheck" => "check",
        "breve" => "breve",
        "acute" => "acute",
        "grave" => "grave",
        "mathring" => "mathring",
        "frak" | "mathfrak" => "frak",
        "it" | "mathit" | "textit" | "mathnormal" => "it",
        "mathbb" | "mathds" => "bb",
        _ => return None,
    })
}

/// Whether a command sets words, in which spaces are printed: `T_{\text{a b}}` is no `T_{\text{ab}}`.
pub fn sets_words(command: &str) -> bool {
    matches!(command, "text" | "mbox" | "hbox" | "textrm" | "textup" | "textnormal")
}

/// Whether a style switches the rest of a group, as `{\bf m}` does, instead of taking an argument.
pub(super) fn is_switch(command: &str) -> bool {
    matches!(command, "bf" | "rm" | "cal" | "sf" | "it" | "frak")
}

/// Whether a style only marks a vector or a matrix: `\boldsymbol\Omega` may then stand for a declared `\Omega`.
pub(super) fn marks_tensor(style: &str) -> bool {
    matches!(style, "bf" | "vec")
}

/// Whether a style is an accent: of these a name may have several.
pub(super) fn is_accent(style: &str) -> bool {
    matches!(style, "bar" | "hat" | "tilde" | "vec" | "check" | "breve" | "acute" | "grave" | "mathring")
}

/// Whether a name can be an index that runs over components. Other letters, such as the x of `v_x` or the r of `v_r`, are
/// labels in print.
pub(super) fn is_index(name: &str) -> bool {
    let base = name.trim_end_matches('\'');
    let greek = ["\\alpha", "\\beta", "\\gamma", "\\delta", "\\mu", "\\nu", "\\rho", "\\sigma", "\\lambda", "\\kappa"];
    matches!(base.as_bytes(), [b'a'..=b'd' | b'f'..=b'n' | b'p' | b'q' | b's']) || greek.contains(&base)
}

/// Whether a name, where it is not declared, is the imaginary unit.
pub(super) fn is_imaginary_unit(name: &str) -> bool {
    matches!(name, "i" | "rm:i" | "\\imath")
}

/// Whether a command before a name makes one name of both where that is declared, as `\Delta t`.
pub(super) fn is_difference(command: &str) -> bool {
    matches!(command, "Delta" | "delta")
}

/// The style of a name in square brackets, as `[S]` for a concentration.
pub(super) const AMOUNT: &str = "amount";

/// The style and the rest of a canonical name.
pub(super) fn split(name: &str) -> (Option<&str>, &str) {
    match name.split_once(':') {
        Some((style, rest)) => (Some(style), rest),
        None => (None, name),
    }
}

/// The name and the label above it, as in `\mu^{(1)}`, for one that has a label.
pub(super) fn labelled(name: &str) -> Option<(&str, &str)> {
    if split(name).0 == Some(AMOUNT) { None } else { name.split_once('^') }
}

/// The name without a style that only marks a vector or a matrix.
pub(super) fn unmarked(name: &str) -> &str {
    match split(name) {
        (Some(style), bare) if marks_tensor(style) => bare,
        _ => name,
    }
}

/// The canonical spelling as LaTeX.
pub(super) fn to_latex(name: &str) -> String {
    if let Some((name, label)) = labelled(name) {
        return format!("{}^{label}", to_latex(name));
    }
    let (style, rest) = split(name);
    let base = rest.trim_end_matches('\'');
    let primes = &rest[base.len()..];
    let styled = match style {
        None => base.to_owned(),
        Some("bf") if base.starts_with('\\') => format!(r"{{\boldsymbol{base}}}"),
        Some("rm") if base.contains(' ') => format!(r"\text{{{base}}}"),
        Some(switch) if is_switch(switch) && !base.contains([':', '\'']) => format!(r"{{\{switch} {base}}}"),
        Some(switch) if is_switch(switch) => format!(r"\math{switch}{{{}}}", to_latex(base)),
        Some(AMOUNT) => format!("[{}]", to_latex(base)),
        Some(sign) if is_difference(sign) => format!(r"\{sign} {}", to_latex(base)),
        Some(style @ ("bb" | "scr")) => format!(r"\math{style}{{{base}}}"),
        Some(accent) => format!(r"\{accent}{{{}}}", to_latex(base)),
    };
    format!("{styled}{primes}")
}

/// Tokens as one canonical text, in which spacing and the spelling of styles do not matter.
pub(super) fn canonical(tokens: &[Token]) -> String {
    let mut out = String::new();
    let mut i = 0;
    while let Some(token) = tokens.get(i) {
        match &token.kind {
            Kind::Letter(c) => out.push(*c),
            Kind::Number(n) => out.push_str(n),
            Kind::Sign('{' | '}') => {}
            Kind::Sign(c) => out.push(*c),
            Kind::Command(name) => match style(name) {
                Some(style) => {
                    out.push_str(style);
                    out.push(':');
                }
                None if matches!(name.as_str(), "+" | "-" | "*") => out.push_str(name),
                None => {
                    out.push('\\');
                    out.push_str(name);
                    out.push(' ');
                }
            },
            Kind::OpenBar | Kind::CloseBar => out.push('|'),
            Kind::Row => out.push_str("\\\\"),
            Kind::End | Kind::OpenFence => {}
        }
        i += 1;
    }
    out
}
