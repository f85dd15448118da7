//! Formulas as plain text, for a terminal and for what has no room for a formula: letters of Unicode, small ones for indices.
//!
//! **In:** LaTeX. **Out:** a line of text. A fraction, a root and an exponent of several signs have brackets, so that what is read is
//! what is written. A matrix has no line of its own: a formula with one stays as it is.

use super::mathml;

/// Commands that only say how something is set.
const STYLES: &str = "bf rm it cal boldsymbol mathbf mathrm mathit mathbb mathcal mathsf left right text big Big bigl bigr displaystyle \
                      limits nolimits";
/// Signs that stand between the parts of a formula: each command, then its sign.
const SIGNS: &str = "cdot · times × le ≤ leq ≤ ge ≥ geq ≥ ne ≠ neq ≠ pm ± mp ∓ approx ≈ equiv ≡ propto ∝ sim ∼ ll ≪ gg ≫ in ∈ \
                     rightarrow → to → ldots … dots … cdots …";
/// Signs that are, or begin, one of the parts.
const LETTERS: &str = "partial ∂ nabla ∇ infty ∞ int ∫ sum ∑ prod ∏ dagger † ast * prime ′ langle ⟨ rangle ⟩ lfloor ⌊ rfloor ⌋ lceil ⌈ rceil ⌉ lvert | rvert | lVert ‖ rVert ‖ \
                       Box □";
/// Marks above a letter.
const ABOVE: &str = "dot \u{307} ddot \u{308} dddot \u{20db} hat \u{302} bar \u{304} tilde \u{303} vec \u{20d7}";

/// What is done with indices and exponents.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scripts {
    /// They become small letters.
    Small,
    /// They stay behind their marks, so that a program can read them.
    Kept,
}

/// A text as plain text, its commands as letters, its indices below the line.
pub(super) fn plain(text: &str) -> String {
    if text.contains("\\begin") { text.to_owned() } else { line(text, Scripts::Small).trim_start().to_owned() }
}

/// The same in letters that can be pasted into a program.
pub(super) fn bare(text: &str) -> String {
    line(text, Scripts::Kept)
}

fn line(text: &str, scripts: Scripts) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let tail = &rest[c.len_utf8()..];
        rest = match c {
            '\\' => of_command(tail, scripts, &mut out),
            '_' | '^' => script(c, tail, scripts, &mut out),
            '{' | '}' | '\u{2063}' => tail,
            c => {
                out.push(c);
                tail
            }
        };
    }
    out
}

/// The name of a command, and what follows it.
fn command(text: &str) -> (&str, &str) {
    text.split_at(text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len()))
}

/// The sign of a command in a list.
fn of(list: &'static str, name: &str) -> Option<&'static str> {
    list.split_whitespace()
        .zip(list.split_whitespace().skip(1))
        .step_by(2)
        .find(|(known, _)| *known == name)
        .map(|(_, sign)| sign)
}

fn symbol(name: &str) -> Option<&'static str> {
    of(LETTERS, name).or_else(|| of(SIGNS, name)).or_else(|| mathml::letter(name))
}

/// Prints a command; what follows it.
fn of_command<'t>(text: &'t str, scripts: Scripts, out: &mut String) -> &'t str {
    let (name, after) = command(text);
    if name.is_empty() {
        // A space, or a sign that is a command elsewhere.
        return after.strip_prefix([',', ';', ':', '!']).unwrap_or(after);
    }
    if ["frac", "dfrac", "tfrac"].contains(&name)
        && let Some((top, bottom, after)) =
            argument(after).and_then(|(a, rest)| argument(rest).map(|(b, rest)| (a, b, rest)))
    {
        let ratio =
            format!("{}/{}", bracketed(&line(top, scripts), is_product), bracketed(&line(bottom, scripts), is_one));
        let is_between_bars = out.ends_with('|') && after.starts_with('|');
        let apart = out.ends_with(char::is_alphanumeric) || begins_factor(after) && !is_between_bars;
        out.push_str(&if apart { format!("({ratio})") } else { ratio });
        return after;
    }
    if let (Some((inner, after)), true) = (argument(after), name == "sqrt") {
        out.push_str(&format!("√{}", bracketed(&line(inner, scripts), is_one)));
        return after;
    }
    if let (Some(mark), Some((inner, after))) = (of(ABOVE, name), argument(after)) {
        let inner = line(inner, scripts);
        let (letter, more) = inner.trim_start().split_at(inner.trim_start().chars().next().map_or(0, char::len_utf8));
        out.extend([letter, mark, more]);
        return after;
    }
    if let (Some((inner, after)), true) = (argument(after), name == "operatorname") {
        word(&line(inner, scripts), after, out);
        return after;
    }
    match symbol(name) {
        _ if STYLES.split(' ').any(|style| style == name) => {}
        _ if ["quad", "qquad"].contains(&name) => out.push(' '),
        Some(symbol) => out.push_str(symbol),
        None => word(name, after, out),
    }
    after.trim_start()
}

/// Prints a word, apart from letters beside it.
fn word(name: &str, after: &str, out: &mut String) {
    if out.ends_with(|c: char| c.is_alphanumeric() || c == ')') {
        out.push(' ');
    }
    out.push_str(name);
    if after.trim_start().starts_with(|c: char| c.is_alphanumeric() || "\\{".contains(c))
        && !after.starts_with("\\left")
    {
        out.push(' ');
    }
}

/// What stands in the braces with which a text begins, and what follows them.
fn braced(text: &str) -> Option<(&str, &str)> {
    let inner = text.strip_prefix('{')?;
    let mut depth = 1;
    for (at, c) in inner.char_indices() {
        depth += match c {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        if depth == 0 {
            return Some((&inner[..at], &inner[at + 1..]));
        }
    }
    None
}

/// The argument of a command, in braces or one sign, and what follows it.
fn argument(text: &str) -> Option<(&str, &str)> {
    let text = text.trim_start();
    match text.chars().next()? {
        '{' => braced(text),
        '\\' => Some(text.split_at(1 + command(&text[1..]).0.len())),
        first => Some(text.split_at(first.len_utf8())),
    }
}

/// Prints an index or an exponent; what follows it.
fn script<'t>(mark: char, text: &'t str, scripts: Scripts, out: &mut String) -> &'t str {
    let Some((inner, after)) = argument(text).filter(|_| !text.starts_with(char::is_whitespace)) else {
        out.push(mark);
        return text;
    };
    let inner = line(inner, scripts);
    let letters: Option<String> = inner.chars().map(if mark == '_' { lowered } else { raised }).collect();
    match letters.filter(|s| !s.is_empty() && scripts == Scripts::Small) {
        Some(letters) => out.push_str(&letters),
        None => {
            out.push(mark);
            out.push_str(&if inner.chars().count() > 1 && (mark == '^' || scripts == Scripts::Small) {
                format!("({inner})")
            } else {
                inner
            });
        }
    }
    after
}

/// A part, between brackets where it is not such a part.
fn bracketed(text: &str, is: fn(&str) -> bool) -> String {
    if is(text) { text.to_owned() } else { format!("({text})") }
}

/// Whether a text is no sum.
fn is_product(text: &str) -> bool {
    !text.contains(['+', '-', '=', '±', '/'])
}

/// Whether a text is one number, one letter with its marks, or the d of a derivative with one.
fn is_one(text: &str) -> bool {
    let is_number = !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let letters = text.strip_prefix(['d', '∂']).filter(|rest| !rest.is_empty()).unwrap_or(text);
    let mut signs = letters.chars();
    let is_mark =
        |c: char| raised_or_lowered(c) || ('\u{300}'..'\u{370}').contains(&c) || ('\u{20d0}'..'\u{2100}').contains(&c);
    is_number || signs.next().is_some_and(char::is_alphabetic) && signs.all(is_mark)
}

/// Whether a text goes on with a factor.
fn begins_factor(text: &str) -> bool {
    let text = text.trim_start();
    match text.strip_prefix('\\').map(|tail| command(tail).0) {
        Some(name) => name != "right" && !name.is_empty() && of(SIGNS, name).is_none(),
        None => text.starts_with(|c: char| c.is_alphanumeric() || "([{|".contains(c)),
    }
}

/// Letters below and above the line.
const LOW: [(&str, &str); 2] = [("0123456789+-=()", "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎"), ("aehijklmnoprstuvx", "ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ")];
const HIGH: [(&str, &str); 1] = [("0123456789+-=()niT", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱᵀ")];

fn small(c: char, tables: &[(&str, &str)]) -> Option<char> {
    tables.iter().find_map(|(plain, small)| small.chars().nth(plain.chars().position(|p| p == c)?))
}

fn lowered(c: char) -> Option<char> {
    small(c, &LOW)
}

fn raised(c: char) -> Option<char> {
    small(c, &HIGH)
}

fn raised_or_lowered(c: char) -> bool {
    LOW.iter().chain(&HIGH).any(|(_, small)| small.contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_lines() {
        for (text, shown) in [
            (r"I_1", "I₁"),
            (r"{\bf m}_{12}", "m₁₂"),
            (r"I_1^2+m_i", "I₁²+mᵢ"),
            (r"2E= I^{-1}_i m_i^2", "2E= I⁻¹ᵢ mᵢ²"),
            (r"{\bf x}_N(t)=R(t){\bf x}_N(0)", "x_N(t)=R(t)x_N(0)"),
            (r"R^T R=\mathbb{1}", "Rᵀ R=1"),
            (r"\frac{\partial u}{\partial t}+6u=\frac{a+1}{b}", "∂u/∂t+6u=(a+1)/b"),
            (r"\frac{h}{mc}x-\frac{\mu}{r^2}", "(h/(mc))x-μ/r²"),
            (r"\frac12\ell^2\dot q^2+\ddot{\bf r}_1", "(1/2)ℓ²q\u{307}²+r\u{308}₁"),
            (r"\frac{d\psi}{d\varphi}=3\frac12", "dψ/dφ=3(1/2)"),
            (r"e^{-kx}+\sqrt{a+b}-\sqrt2", "e^(-kx)+√(a+b)-√2"),
            (r"m\sin\theta\le\cos(x)", "m sin θ≤cos(x)"),
            (r"\lim_{t\rightarrow t_0}\theta(t)=0", "lim_(t→t₀)θ(t)=0"),
            (r"\operatorname{Re}(\dot\psi)\,x", "Re(ψ\u{307})x"),
            (r"\nabla^2u=\frac{1", "∇²u=frac 1"),
            (r"q\rightarrow 0", "q→0"),
            (r"|\frac{h}{g}| ≤ 1", "|h/g| ≤ 1"),
            (r"\begin{pmatrix}a\\b\end{pmatrix}", r"\begin{pmatrix}a\\b\end{pmatrix}"),
            (r"x_Q", "x_Q"),
            ("x_", "x_"),
            ("", ""),
        ] {
            assert_eq!(plain(text), shown);
        }
    }
}
