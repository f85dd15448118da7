//! The print of a side: what stands above what, and what stands side by side.
//!
//! **In:** a formula as LaTeX. **Out:** whether something stands in it that is no product, and no power. **Guaranteed:** it is told by the print
//! alone.

use super::super::letters::is_letter_command;
use super::super::letters::is_upright_label;

/// The commands and characters of a formula, without spaces.
pub(super) fn tokens(text: &str) -> Vec<&str> {
    placed(text).into_iter().map(|(_, token)| token).collect()
}

/// The commands and characters of a formula, each with where it begins.
pub(super) fn placed(text: &str) -> Vec<(usize, &str)> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = match c {
            '\\' => {
                let letters = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len() - 1);
                let one = rest[1..].chars().next().map_or(0, char::len_utf8);
                1 + if letters == 0 { one } else { letters }
            }
            _ => c.len_utf8(),
        };
        let (token, after) = rest.split_at(length);
        if !c.is_whitespace() {
            out.push((text.len() - rest.len(), token));
        }
        rest = after;
    }
    out
}

/// The position after a group, or after one token.
pub(super) fn behind(all: &[&str], at: usize) -> usize {
    let mut depth = 0usize;
    for (i, token) in all.iter().enumerate().skip(at) {
        match *token {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return i + 1;
        }
    }
    all.len()
}

/// Something with a script above.
pub(super) struct Raised {
    /// The letter below, or the last token of what is raised.
    pub base: String,
    /// Whether the base is printed in bold.
    pub is_bold: bool,
    /// What stands above.
    pub above: Vec<String>,
    /// Whether a number or a lone name in parentheses stands right behind.
    pub calls: bool,
}

const GREEK_INDICES: &[&str] = &[r"\mu", r"\nu", r"\rho", r"\sigma", r"\lambda", r"\kappa"];

impl Raised {
    pub fn is_letter(&self) -> bool {
        let base = self.base.as_str();
        let letter = base.len() == 1 && base.chars().all(|c| c.is_ascii_alphabetic())
            || base.len() > 2 && base.starts_with('\\');
        letter && !matches!(base, "e" | r"\exp" | r"\right" | r"\mathrm") && !is_function(base)
    }

    /// Whether what stands above is no power of numbers: an index, or several.
    pub fn is_index(&self) -> bool {
        if !self.is_letter() {
            return false;
        }
        let above: Vec<&str> = self.above.iter().map(String::as_str).collect();
        let greek = |t: &&str| GREEK_INDICES.contains(t) || matches!(*t, r"\alpha" | r"\beta" | r"\gamma" | r"\delta");
        let sure = |t: &&str| greek(t) || matches!(*t, "i" | "j");
        match above.as_slice() {
            ["0" | "1"] => true,
            [one] => GREEK_INDICES.contains(one) || matches!(*one, "i" | "j"),
            several => {
                let index = |t: &&str| sure(t) || matches!(*t, "k" | "l" | "m" | "n" | "0" | "1" | "2" | "3" | ",");
                let letters = several.iter().any(sure)
                    || several.first() == Some(&"0")
                    || several.iter().filter(|t| matches!(**t, "k" | "l" | "m")).count() > 2;
                (2..=5).contains(&several.len()) && several.iter().all(index) && letters
            }
        }
    }

    /// Whether what stands above could be an index of a letter that has them: digits and letters, and no sign or fraction.
    pub fn could_be_index(&self) -> bool {
        let plain = |t: &String| {
            t == "," || t.chars().all(char::is_alphanumeric) || t.strip_prefix('\\').is_some_and(is_letter_command)
        };
        self.above.iter().all(plain)
    }

    pub fn is_digit(&self, digit: &str) -> bool {
        matches!(self.above.as_slice(), [one] if one == digit)
    }

    /// Two digits that could be indices.
    pub fn two_digits(&self) -> Option<String> {
        let digit = |t: &String| matches!(t.as_str(), "1" | "2" | "3");
        (self.is_letter() && self.above.len() == 2 && self.above.iter().all(digit)).then(|| self.above.concat())
    }

    pub fn is_transpose(&self) -> bool {
        let above: Vec<&str> = self.above.iter().map(String::as_str).filter(|t| !matches!(*t, "{" | "}")).collect();
        let transposed = matches!(
            above.as_slice(),
            ["T"] | [r"\top"] | [r"\intercal"] | [r"\mathrm" | r"\rm" | r"\text" | r"\mathsf", "T"]
        );
        transposed && !self.is_bold && (self.is_letter() || matches!(self.base.as_str(), ")" | "]"))
    }
}

pub(super) fn is_function(command: &str) -> bool {
    matches!(
        command,
        r"\sin"
            | r"\cos"
            | r"\tan"
            | r"\cot"
            | r"\sec"
            | r"\csc"
            | r"\sinh"
            | r"\cosh"
            | r"\tanh"
            | r"\coth"
            | r"\ln"
            | r"\log"
            | r"\arcsin"
            | r"\arccos"
            | r"\arctan"
            | r"\partial"
            | r"\nabla"
            | r"\det"
            | r"\arg"
            | r"\sech"
    )
}

/// Everything that has a script above.
pub(super) fn scripted(all: &[&str]) -> Vec<Raised> {
    let mut out = Vec::new();
    for at in (1..all.len()).filter(|&i| all[i] == "^") {
        let mut end = at;
        while end > 0 && all[end - 1] == "'" {
            end -= 1;
        }
        // Behind a subscript stands its letter.
        let begin = |end: usize| match all.get(end.wrapping_sub(1)) {
            Some(&"}") => {
                let mut depth = 0i32;
                (0..end).rev().find(|&i| {
                    depth += i32::from(all[i] == "}") - i32::from(all[i] == "{");
                    depth == 0
                })
            }
            Some(_) => Some(end - 1),
            None => None,
        };
        let Some(mut from) = begin(end) else { continue };
        let styled = |from: usize| {
            from > 1
                && all[from] == "{"
                && all[from - 1].len() > 2
                && all[from - 1].starts_with('\\')
                && all[from - 2] == "_"
        };
        if styled(from) {
            from -= 1;
        }
        if from > 1 && all[from - 1] == "_" {
            end = from - 1;
            match begin(end) {
                Some(base) => from = base,
                None => continue,
            }
        }
        let group = &all[from..end];
        let bare: Vec<&str> = group.iter().copied().filter(|t| !matches!(*t, "{" | "}")).collect();
        let style = from.checked_sub(1).map_or("", |i| all[i]);
        let is_bold = [style, bare.first().copied().unwrap_or_default()].iter().any(|t| {
            matches!(*t, r"\dot" | r"\ddot" | r"\mathbf" | r"\boldsymbol" | r"\vec" | r"\bm" | r"\bf" | r"\pmb")
        });
        let base = if bare.len() == 1 || is_bold { bare.last().copied().unwrap_or_default() } else { ")" };
        let after = behind(all, at + 1);
        let above: Vec<String> =
            all[at + 1..after].iter().filter(|t| !matches!(**t, "{" | "}")).map(|t| (*t).to_owned()).collect();
        let calls = match &all[after.min(all.len())..] {
            // A label is a part of the name: `u^{\mathrm I}(x)`.
            ["(", inside, ")", ..] if !is_labelled(&all[at + 1..after]) => {
                is_letter_token(base) && (inside.chars().all(|c| c.is_ascii_digit()) || is_letter_token(inside))
            }
            _ => false,
        };
        out.push(Raised { base: base.to_owned(), is_bold, above, calls });
    }
    out
}

/// Whether what stands above is a label, with its braces.
fn is_labelled(above: &[&str]) -> bool {
    is_upright_label(above.strip_prefix(&["{"]).and_then(|rest| rest.strip_suffix(&["}"])).unwrap_or(above))
}

pub(super) fn is_letter_token(token: &str) -> bool {
    token.len() == 1 && token.chars().all(|c| c.is_ascii_alphabetic())
        || token.strip_prefix('\\').is_some_and(is_letter_command)
}

pub(super) fn is_twice(text: &str) -> bool {
    text.chars().all(|c| text.starts_with(c))
}

/// Whether `i` stands by itself in a side, and not below or above.
pub(super) fn has_imaginary(text: &str) -> bool {
    let all = tokens(text);
    let mut words = vec![false; all.len()];
    for k in 0..all.len() {
        if matches!(
            all[k],
            r"\text"
                | r"\mathrm"
                | r"\operatorname"
                | r"\mbox"
                | r"\textrm"
                | r"\textit"
                | r"\textbf"
                | r"\begin"
                | r"\end"
        ) {
            let end = behind(&all, k + 1);
            words[k + 1..end.min(all.len())].fill(true);
        }
    }
    (0..all.len()).filter(|&k| !words[k]).any(|k| {
        let before = k.checked_sub(1).map_or("", |b| all[b]);
        let in_script = || {
            let mut depth = 0i32;
            (0..k).rev().any(|b| {
                depth += i32::from(all[b] == "{") - i32::from(all[b] == "}");
                depth > 0 && all[b] == "{" && b > 0 && all[b - 1] == "_"
            })
        };
        all[k] == "i" && !matches!(before, "_" | "^") && !in_script()
    })
}

/// Units that are no usual products of names.
const UNITS: &[&str] = &[
    "cm", "mm", "km", "nm", "kg", "mg", "ms", "ns", "Hz", "kHz", "MHz", "GHz", "eV", "keV", "MeV", "GeV", "TeV", "mol",
    "rad", "Pa", "kPa", "kJ", "kW", "mV", "kV", "mA", "dB", "deg", "min", "hr", "yr",
];

/// Those of energy: no product of names is spelled so.
const OF_ENERGY: &[&str] = &["keV", "MeV", "GeV", "TeV"];

/// A number, a space, a unit in italics: `10~cm`; or two units: `MeV cm^2`.
pub(super) fn has_unit_of_italics(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().collect();
    let unit = |w: &str| w.chars().take_while(char::is_ascii_alphabetic).collect::<String>();
    let has = |w: &str, units: &[&str]| units.contains(&unit(w.trim_start_matches(['{', '(', '}'])).as_str());
    words.windows(2).any(|w| {
        w[0].ends_with(|c: char| c.is_ascii_digit()) && has(w[1], UNITS) || has(w[0], OF_ENERGY) && has(w[1], UNITS)
    })
}

/// `I-P`, `1+A` with capitals: I is the identity.
pub(super) fn has_identity(all: &[&str]) -> bool {
    let capital = |t: Option<&&str>| t.is_some_and(|t| t.len() == 1 && t.chars().all(|c| c.is_ascii_uppercase()));
    let plain = |i: usize| !matches!(all.get(i + 1), Some(&("_" | "^" | "(" | "'")));
    (0..all.len()).filter(|&i| all[i] == "I" && plain(i) && !is_script(all, i)).any(|i| {
        let sign = |t: Option<&&str>| matches!(t, Some(&("+" | "-")));
        let behind = sign(all.get(i + 1)) && capital(all.get(i + 2)) && plain(i + 2);
        let before = i > 1 && sign(all.get(i - 1)) && capital(all.get(i - 2));
        (behind || before) && (i == 0 || !is_letter_token(all[i - 1]))
    })
}

/// A comma in parentheses that belong to no name, beside anything else.
pub(super) fn has_pair(all: &[&str]) -> bool {
    let plain: Vec<&str> =
        all.iter().copied().filter(|t| !matches!(*t, r"\left" | r"\right" | r"\," | r"\;" | r"\!")).collect();
    let opens = |i: usize| {
        plain[i] == "("
            && !i.checked_sub(1).is_some_and(|b| {
                is_letter_token(plain[b])
                    || matches!(plain[b], "}" | "'")
                    || is_function(plain[b])
                    || is_script(&plain, b)
            })
    };
    for start in (0..plain.len()).filter(|&i| opens(i)) {
        let (mut depth, mut comma) = (0i32, false);
        let mut end = plain.len();
        for (i, token) in plain.iter().enumerate().skip(start) {
            match *token {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => depth -= 1,
                "," => comma |= depth == 1,
                _ => {}
            }
            if depth == 0 {
                end = i;
                break;
            }
        }
        if comma && !(start == 0 && end + 1 >= plain.len()) {
            return true;
        }
    }
    false
}

pub(super) fn is_script(all: &[&str], at: usize) -> bool {
    at > 0 && matches!(all[at - 1], "_" | "^")
}

/// A letter before brackets whose content is no factor: `\gamma(-1)`, `N(aX,b)`, `E[XY]`.
pub(super) fn call(all: &[&str]) -> Option<&'static str> {
    if is_negated_call(all) {
        return Some("a value at a place, or a product");
    }
    for i in 1..all.len() {
        let named = is_letter_token(all[i - 1]) && !is_script(all, i - 1);
        let is_labelled = i > 2 && all[i - 2] == "_" && is_letter_token(all[i - 3]);
        match all[i] {
            // Nobody sets a plus before a factor: `\omega_0(+m)`.
            "(" if (named || is_labelled) && all.get(i + 1) == Some(&"+") => {
                return Some("a value at a place, or a product");
            }
            // `\pi(g)v` is a map of g as often as a number.
            "(" if all[i - 1] == r"\pi"
                && i > 0
                && all.get(i + 1).is_some_and(|t| is_letter_token(t))
                && all.get(i + 2) == Some(&")")
                && !(i > 1 && all[i - 2].chars().all(|c| c.is_ascii_digit())) =>
            {
                return Some("a function of anything, or a product");
            }
            "(" if named => {
                let signed = matches!(&all[i + 1..], ["-" | "+", rest @ ..] if {
                    let digits = rest.iter().take_while(|t| t.chars().all(|c| c.is_ascii_digit() || c == '.')).count();
                    digits > 0 && rest.get(digits) == Some(&")")
                });
                if signed {
                    return Some("a value at a place, or a product");
                }
                // A function of a value of itself, `\sigma(\sigma(G))`.
                if all.get(i + 1) == Some(&all[i - 1]) && all.get(i + 2) == Some(&"(") {
                    return Some("a function of anything, or a product");
                }
                if SPECIAL.contains(&all[i - 1]) {
                    return Some("a special function, or a product");
                }
                if has_list_of_formulas(&all[i..]) {
                    return Some("a function of anything, or a product");
                }
            }
            "[" if named => {
                let end = (i..all.len()).find(|&k| all[k] == "]").unwrap_or(all.len());
                let sum = all[i..end].iter().any(|t| matches!(*t, "+" | "-" | r"\pm" | "("));
                if !sum {
                    return Some("a function of anything, or a product");
                }
            }
            _ => {}
        }
    }
    None
}

/// Whether a letter stands before brackets that hold one term with a minus, `F(-x)`; how large the brackets are makes no difference.
fn is_negated_call(all: &[&str]) -> bool {
    let all: Vec<&str> = all.iter().filter(|t| !SIZES.contains(t)).copied().collect();
    let ends =
        |from: usize| all[from..].iter().find(|t| matches!(**t, ")" | "(" | "[" | "+" | "-" | r"\pm" | r"\mp" | ","));
    (1..all.len()).any(|i| {
        let named = is_letter_token(all[i - 1]) && !is_script(&all, i - 1);
        named && all[i] == "(" && all.get(i + 1) == Some(&"-") && ends(i + 2) == Some(&")")
    })
}

/// Commands that make brackets large.
const SIZES: &[&str] =
    &[r"\left", r"\right", r"\big", r"\bigl", r"\bigr", r"\Big", r"\Bigl", r"\Bigr", r"\bigg", r"\biggl", r"\biggr"];

/// Letters of functions that have their name from nobody: before parentheses they are no factors.
const SPECIAL: &[&str] = &[r"\Gamma", r"\zeta", r"\delta"];

/// Whether a group in parentheses has commas, and more than a name or a number between them.
pub(super) fn has_list_of_formulas(all: &[&str]) -> bool {
    let mut depth = 0i32;
    let (mut commas, mut letters, mut most, mut signs) = (0, 0, 0, false);
    for token in all {
        match *token {
            "(" | "[" => depth += 1,
            ")" | "]" => depth -= 1,
            "," if depth == 1 => {
                commas += 1;
                letters = 0;
            }
            "+" | "-" | "^" => signs = true,
            one if is_letter_token(one) => letters += 1,
            _ => {}
        }
        most = most.max(letters);
        if depth == 0 {
            break;
        }
    }
    commas > 0 && (signs || most > 2)
}

pub(super) fn has_bars(text: &str) -> bool {
    text.contains('|') || text.contains(r"\lvert") || text.contains(r"\vert") || text.contains(r"\abs")
}

/// `|z|^2`, and no vector in it: of a real number nobody needs the bars.
pub(super) fn squares_an_absolute_value(text: &str) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let styles = [r"\mathbf", r"\vec", r"\boldsymbol", r"\bf", r"\bm", r"\nabla", r"\hat"];
    let by_command = squeezed.contains(r"\abs") && (squeezed.contains("}^2") || squeezed.contains("}^{2}"));
    by_command && !styles.iter().any(|s| squeezed.contains(s))
        || ["|^2", "|^{2}", r"\rvert^2", r"\rvert^{2}", r"\right|^2", r"\vert^2"].iter().any(|w| squeezed.contains(w))
            && !styles.iter().any(|s| squeezed.contains(s))
}

/// A norm of what is no vector in print.
pub(super) fn has_norm(text: &str) -> bool {
    let bold = [r"\mathbf", r"\vec", r"\boldsymbol", r"\bf", r"\bm", r"\nabla"].iter().any(|s| text.contains(s));
    !bold && [r"\norm", r"\|", r"\lVert", r"\Vert"].iter().any(|n| text.contains(n))
}

/// An upright word before parentheses or a letter: `\mathrm{Var}(X)`.
pub(super) fn has_named_function(all: &[&str]) -> bool {
    (0..all.len()).any(|i| {
        if !matches!(all[i], r"\mathrm" | r"\operatorname" | r"\text" | r"\textrm" | r"\mathop")
            || i > 0 && is_script(all, i)
        {
            return false;
        }
        if i > 1 && all[i - 1] == "{" && is_script(all, i - 1) {
            return false;
        }
        let end = behind(all, i + 1);
        let word: String =
            all[i + 1..end.min(all.len())].iter().filter(|t| !matches!(**t, "{" | "}")).copied().collect();
        word.len() > 1
            && word.chars().all(|c| c.is_ascii_alphabetic())
            && !latex::is_function(&word)
            && all.get(end).is_some_and(|t| *t == "(" || *t == "[" || is_letter_token(t) || *t == r"\left")
    })
}

/// Functions that have no command of their own, or are written without it: before parentheses their letters are no factors.
const PLAIN: &[&str] = &[
    "sgn", "sign", "ord", "gcd", "lcm", "deg", "det", "dim", "ker", "rank", "span", "Var", "Cov", "Pr", "erf", "tr",
    "mod", "arg", "Re", "Im", "max", "min", "log", "lim", "exp", "sup", "inf", "im", "Tr", "char", "card", "vol",
    "supp",
];

/// Letters that spell a function right before parentheses: `sgn(\tau)`.
pub(super) fn has_plain_function(text: &str) -> bool {
    let mut rest = text;
    let mut before = ' ';
    while let Some(c) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        if word == 0 {
            before = c;
            rest = &rest[c.len_utf8()..];
            continue;
        }
        let behind = rest[word..].trim_start();
        let opens = ["(", "[", r"\left(", r"\left (", r"\big", r"\Big"].iter().any(|o| behind.starts_with(o));
        if before != '\\' && before != '{' && opens && PLAIN.contains(&&rest[..word]) {
            return true;
        }
        before = 'a';
        rest = &rest[word..];
    }
    false
}

/// A column of two entries in parentheses, with no style of a vector beside it: `\begin{pmatrix}n\k\end{pmatrix}`.
pub(super) fn has_column_of_two(all: &[&str]) -> bool {
    let styled = |t: &&str| matches!(*t, r"\vec" | r"\mathbf" | r"\boldsymbol" | r"\bm" | r"\bf");
    let is_begin = |at: usize| {
        let word = |from: usize| all[from + 1..].iter().take_while(|t| **t != "}").copied().collect::<String>();
        all[at] == r"\begin"
            && all.get(at + 1) == Some(&"{")
            && matches!(word(at + 1).as_str(), "pmatrix" | "smallmatrix" | "psmallmatrix")
            || all[at] == r"\atop"
    };
    !all.iter().any(styled)
        && (0..all.len()).filter(|&at| is_begin(at)).any(|at| {
            let end = (at + 1..all.len()).find(|&k| all[k] == r"\end").unwrap_or(all.len());
            let inside = &all[at + 1..end];
            all[at] == r"\atop" || inside.iter().filter(|t| **t == r"\").count() == 1 && !inside.contains(&"&")
        })
}

/// Two letters side by side, or with a dot between them.
pub(super) fn has_product_of_letters(all: &[&str]) -> bool {
    let letter = |t: &str| is_letter_token(t);
    let all: Vec<&str> = all.iter().copied().filter(|t| !matches!(*t, r"\cdot" | r"\,")).collect();
    (1..all.len()).any(|i| {
        let before = all[i - 1];
        letter(all[i])
            && (letter(before) || matches!(before, "}" | ")"))
            && !is_script(&all, i)
            && !(is_script(&all, i - 1) && before == "}")
    })
}

/// `\frac{Du}{Dt}`, `\frac{D}{Dt}`, with any D.
pub(super) fn follows_a_flow(text: &str) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let squeezed = squeezed.replace(r"\mathrm{D}", "D").replace(r"\mathcal{D}", "D").replace(r"\mathcalD", "D");
    squeezed.match_indices("}{D").any(|(at, _)| {
        let by = squeezed[at + 3..].split('}').next().unwrap_or_default();
        let top = squeezed[..at].rsplit(r"frac{").next().unwrap_or_default();
        matches!(by, "t" | r"\tau") && top.starts_with('D')
    })
}

/// Brackets around what needs none: `[E]`, `[mv^2]`, `8[\\frac ms]`.
pub(super) fn has_bare_brackets(all: &[&str]) -> bool {
    let derives = all.windows(3).any(|w| w[1] == "{" && matches!(w[2], "d" | r"\partial" | r"\mathrm"));
    let has_option =
        |command: &str| matches!(command, r"\sqrt" | r"\dv" | r"\pdv" | r"\derivative" | r"\partialderivative");
    (0..all.len()).filter(|&i| all[i] == "[" && !(i > 0 && has_option(all[i - 1]))).any(|i| {
        let mut depth = 0i32;
        let end = (i..all.len()).find(|&k| {
            depth += i32::from(matches!(all[k], "[" | "(" | "{")) - i32::from(matches!(all[k], "]" | ")" | "}"));
            depth == 0
        });
        let Some(end) = end else { return false };
        let mut depth = 0i32;
        let needed = (i + 1..end).any(|k| {
            depth += i32::from(matches!(all[k], "(" | "{")) - i32::from(matches!(all[k], ")" | "}"));
            depth == 0 && matches!(all[k], "+" | "-" | r"\pm" | ",") && k > i + 1
        });
        let raised = matches!(all.get(end + 1), Some(&("^" | "_"))) || all.get(end) == Some(&r"\right");
        let holds_brackets = all[i + 1..end].contains(&"(");
        !needed && !raised && !derives && !holds_brackets
    })
}
