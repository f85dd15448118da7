//! What a paper shows of its notation: where what stands side by side is no product of numbers, and what stands above is no power.
//!
//! **In:** a paper, then its sides one by one. **Out:** why a side is not read as numbers. **Guaranteed:** only the print, and the words beside
//! lone names, are looked at; what is seen of a letter once is so in the whole paper. A step that is not read is told as that: a power
//! that is an index, or two operators in another order, would *follow*.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Deref;

use paper::{Paper, PrintedSide};

use super::desk::NotRead;
use super::facts::squeezed;

/// What the whole paper shows of its names and of its notation.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    names: paper::Evidence,
    /// Letters with an index above them somewhere.
    upper: BTreeSet<String>,
    /// Letters with a number above them somewhere that is no usual power: 0, 1, 3.
    numbered: BTreeSet<String>,
    /// Keys of names whose order counts: operators, matrices, elements of a group.
    ordered: BTreeSet<String>,
    /// Keys of names that are called operators.
    acting: BTreeSet<String>,
    /// Whether the paper is one of groups, rings or modules.
    is_algebra: bool,
    /// Keys of names that are equal, to some power, to what has a rate in it: they vary, though no rate of them is printed.
    varies: BTreeSet<String>,
    /// Whether the imaginary unit stands somewhere.
    has_imaginary: bool,
}

impl Deref for Evidence {
    type Target = paper::Evidence;
    fn deref(&self) -> &paper::Evidence {
        &self.names
    }
}

/// Words of papers in which letters side by side are no numbers.
const ALGEBRA: &[&str] = &[
    "subgroup",
    "coset",
    "homomorphism",
    "isomorphi",
    "abelian",
    " ideal",
    " module",
    "noetherian",
    "functor",
    "morphism",
    "sylow",
    "legendre symbol",
    "residue field",
    "quotient group",
    "quotient ring",
];
/// So often such words stand in one.
const MANY_WORDS: usize = 8;

/// Words beside a lone name that say that its order counts.
const ORDERED: &[&str] = &[
    "matrix",
    "matrices",
    "commut",
    "subgroup",
    "coset",
    "quaternion",
    "spinor",
    "grassmann",
    "generator",
    "group element",
    "linear map",
];
/// Words beside a lone name that say that it acts on what follows.
const ACTING: &[&str] = &["operator", "operators", "functional", "Operator"];
/// How far from a name such a word may stand, in bytes.
const BESIDE: usize = 70;

impl Evidence {
    /// The evidence of a paper; `names` is what was seen of its names.
    pub fn new(paper: &Paper, names: paper::Evidence) -> Evidence {
        let mut out = Evidence { has_imaginary: names.is_complex, names, ..Evidence::default() };
        for file in files(paper) {
            let text = file.text.to_lowercase();
            let count: usize = ALGEBRA.iter().map(|w| text.matches(w).count()).sum();
            out.is_algebra |= count >= MANY_WORDS;
            out.ordered.extend(named_beside(&file.text, ORDERED));
            out.acting.extend(named_beside(&file.text, ACTING));
        }
        let mut pairs: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for relation in &paper.printed {
            for side in &relation.sides {
                for one in scripted(&tokens(&side.text)) {
                    if one.is_index() && !one.is_digit("0") && !one.is_digit("1") {
                        out.upper.insert(one.base.clone());
                    }
                    if ["0", "1", "3"].iter().any(|digit| one.is_digit(digit)) {
                        out.numbered.insert(one.base.clone());
                    }
                    if let Some(digits) = one.two_digits() {
                        pairs.entry(one.base.clone()).or_default().insert(digits);
                    }
                }
                out.has_imaginary |= has_imaginary(&side.text);
            }
            out.ordered.extend(relation.sides.iter().flat_map(commuted));
            out.varies.extend(varying(&relation.sides));
        }
        let turned = |all: &BTreeSet<String>| {
            all.iter().any(|p| all.contains(&p.chars().rev().collect::<String>()) && !is_twice(p))
        };
        out.upper.extend(pairs.into_iter().filter(|(_, all)| turned(all)).map(|(base, _)| base));
        out
    }

    /// Whether the paper is one of groups, rings or modules: what is printed as a product, or a sum, may be anything.
    pub fn is_algebra(&self) -> bool {
        self.is_algebra
    }

    /// Whether a name varies, though the paper prints no rate of it.
    pub fn varies(&self, key: &str) -> bool {
        self.varies.contains(key) && !self.names.moving.contains(key)
    }

    /// What keeps a side from being read as numbers.
    pub fn obstacle(&self, side: &PrintedSide) -> Option<NotRead> {
        let all = tokens(&side.text);
        let found = |what: &str| Some(NotRead::of(what));
        for one in scripted(&all) {
            let is_square = one.is_digit("2") && !self.numbered.contains(&one.base);
            if one.is_index() || self.upper.contains(&one.base) && !is_square {
                return found("an index above, or a power");
            }
            if one.is_transpose() {
                return found("a transpose, or a power");
            }
            if one.calls {
                return found("a call of what has something above, or a power");
            }
        }
        if all.iter().any(|t| matches!(*t, r"\forall" | r"\exists" | r"\nexists")) {
            return found("a quantifier");
        }
        if all.iter().any(|t| matches!(*t, r"\mathbb" | r"\mathds")) {
            return found("a set, or an expectation");
        }
        if has_unit_of_italics(&side.text) {
            return found("a number with its unit, or a product");
        }
        if has_identity(&all) {
            return found("a sum with the identity, or with a number");
        }
        if has_pair(&all) {
            return found("a pair: a point, or a product of two vectors");
        }
        if has_named_function(&all) {
            return found("a function by its name, or a product");
        }
        if has_norm(&side.text) {
            return found("a norm, or an absolute value");
        }
        if let Some(what) = call(&all) {
            return found(what);
        }
        if (self.has_imaginary || squares_an_absolute_value(&side.text)) && has_bars(&side.text) {
            return found("an absolute value of what may be complex");
        }
        if paper::names(side).iter().any(|n| self.acting.contains(&squeezed(&n.key()))) {
            return found("an operator, or a factor");
        }
        let mut ordered = paper::names(side)
            .into_iter()
            .map(|n| n.key())
            .filter(|k| self.ordered.contains(&squeezed(k)))
            .collect::<Vec<_>>();
        ordered.sort();
        ordered.dedup();
        if ordered.len() > 1 || self.is_algebra && has_product_of_letters(&all) {
            return found("products whose order may count: matrices, operators, or elements of a group");
        }
        None
    }
}

/// The names that alone make up a side, whatever their power, beside one with rates: `v^2=\dot x^2+\dot y^2`.
fn varying(sides: &[PrintedSide]) -> Vec<String> {
    let all: Vec<Vec<paper::PaperName>> = sides.iter().map(paper::names).collect();
    let has_rate =
        |k: usize| all.get(k).is_some_and(|n| n.iter().any(|n| n.dots > 0 || n.derived_by.as_deref() == Some("t")));
    let lone = |k: &usize| match all[*k].as_slice() {
        [one] => one.dots == 0 && one.derived_by.is_none() && !one.is_difference,
        _ => false,
    };
    let beside = |k: &usize| has_rate(k + 1) || *k > 0 && has_rate(k - 1);
    (0..all.len()).filter(lone).filter(beside).map(|k| all[k][0].key()).collect()
}

/// The files of a paper that print something.
fn files(paper: &Paper) -> Vec<std::sync::Arc<diag::Source>> {
    let mut out: Vec<std::sync::Arc<diag::Source>> = Vec::new();
    for relation in &paper.printed {
        let (file, _) = paper.locate(&relation.span());
        if !out.iter().any(|known| std::sync::Arc::ptr_eq(known, file)) {
            out.push(file.clone());
        }
    }
    out
}

/// Lone names between dollars that stand near one of some words, in its sentence: "the operators $x$ and $p$".
fn named_beside(text: &str, words: &[&str]) -> BTreeSet<String> {
    let near = |mut at: usize| {
        while at < text.len() && !text.is_char_boundary(at) {
            at += 1;
        }
        at.min(text.len())
    };
    let mut out = BTreeSet::new();
    for word in words {
        for (at, _) in text.match_indices(word) {
            let before = &text[near(at.saturating_sub(BESIDE))..at];
            let behind = &text[at..near(at + BESIDE)];
            let before = before.rsplit(". ").next().unwrap_or_default();
            let behind = behind.split(". ").next().unwrap_or_default();
            for part in [before, behind] {
                let pieces: Vec<&str> = part.split('$').collect();
                // Between dollars, wherever the part begins: what has a blank is text.
                out.extend(
                    pieces.iter().flat_map(|p| p.split(',')).map(str::trim).filter(|p| is_lone(p)).map(squeezed),
                );
            }
        }
    }
    out
}

/// Whether a text is one letter, with scripts and a style, perhaps.
fn is_lone(text: &str) -> bool {
    let all = tokens(text);
    let letters = all
        .iter()
        .filter(|t| is_letter_token(t) && !matches!(**t, r"\mathbf" | r"\mathcal" | r"\boldsymbol" | r"\hat" | r"\vec"))
        .count();
    let sub = all.contains(&"_");
    !text.is_empty()
        && text.len() <= 14
        && (letters == 1 || sub && letters <= 2)
        && !text.contains(char::is_whitespace)
        && all
            .iter()
            .all(|t| is_letter_token(t) || matches!(*t, "{" | "}" | "_" | "'") || t.chars().all(|c| c.is_ascii_digit()))
}

/// The commands and characters of a formula, without spaces.
fn tokens(text: &str) -> Vec<&str> {
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
            out.push(token);
        }
        rest = after;
    }
    out
}

/// The position after a group, or after one token.
fn behind(all: &[&str], at: usize) -> usize {
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
struct Raised {
    /// The letter below, or the last token of what is raised.
    base: String,
    /// Whether the base is printed in bold.
    is_bold: bool,
    /// What stands above.
    above: Vec<String>,
    /// Whether a number or a lone name in parentheses stands right behind.
    calls: bool,
}

const GREEK_INDICES: &[&str] = &[r"\mu", r"\nu", r"\rho", r"\sigma", r"\lambda", r"\kappa"];

impl Raised {
    fn is_letter(&self) -> bool {
        let base = self.base.as_str();
        let letter = base.len() == 1 && base.chars().all(|c| c.is_ascii_alphabetic())
            || base.len() > 2 && base.starts_with('\\');
        letter && !matches!(base, "e" | r"\exp" | r"\right" | r"\mathrm") && !is_function(base)
    }

    /// Whether what stands above is no power of numbers: an index, or several.
    fn is_index(&self) -> bool {
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
                let letters = several.iter().any(|t| sure(t))
                    || several.first() == Some(&"0")
                    || several.iter().filter(|t| matches!(**t, "k" | "l" | "m")).count() > 2;
                (2..=5).contains(&several.len()) && several.iter().all(index) && letters
            }
        }
    }

    fn is_digit(&self, digit: &str) -> bool {
        matches!(self.above.as_slice(), [one] if one == digit)
    }

    /// Two digits that could be indices.
    fn two_digits(&self) -> Option<String> {
        let digit = |t: &String| matches!(t.as_str(), "1" | "2" | "3");
        (self.is_letter() && self.above.len() == 2 && self.above.iter().all(digit)).then(|| self.above.concat())
    }

    fn is_transpose(&self) -> bool {
        let above: Vec<&str> = self.above.iter().map(String::as_str).filter(|t| !matches!(*t, "{" | "}")).collect();
        let transposed = matches!(
            above.as_slice(),
            ["T"] | [r"\top"] | [r"\intercal"] | [r"\mathrm" | r"\rm" | r"\text" | r"\mathsf", "T"]
        );
        transposed && !self.is_bold && (self.is_letter() || matches!(self.base.as_str(), ")" | "]"))
    }
}

fn is_function(command: &str) -> bool {
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
fn scripted(all: &[&str]) -> Vec<Raised> {
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
        let is_bold = [style, bare.first().copied().unwrap_or_default()]
            .iter()
            .any(|t| matches!(*t, r"\mathbf" | r"\boldsymbol" | r"\vec" | r"\bm" | r"\bf" | r"\pmb"));
        let base = if bare.len() == 1 || is_bold { bare.last().copied().unwrap_or_default() } else { ")" };
        let after = behind(all, at + 1);
        let above: Vec<String> =
            all[at + 1..after].iter().filter(|t| !matches!(**t, "{" | "}")).map(|t| (*t).to_owned()).collect();
        let calls = match &all[after.min(all.len())..] {
            ["(", inside, ")", ..] => {
                is_letter_token(base) && (inside.chars().all(|c| c.is_ascii_digit()) || is_letter_token(inside))
            }
            _ => false,
        };
        out.push(Raised { base: base.to_owned(), is_bold, above, calls });
    }
    out
}

fn is_letter_token(token: &str) -> bool {
    token.len() == 1 && token.chars().all(|c| c.is_ascii_alphabetic())
        || token.len() > 2 && token.starts_with('\\') && !is_function(token) && token != r"\right" && token != r"\left"
}

fn is_twice(text: &str) -> bool {
    text.chars().all(|c| text.starts_with(c))
}

/// Whether `i` stands by itself in a side, and not below or above.
fn has_imaginary(text: &str) -> bool {
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

/// A number, a space, a unit in italics: `10~cm`.
fn has_unit_of_italics(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.windows(2).any(|w| {
        let unit: String = w[1].chars().take_while(char::is_ascii_alphabetic).collect();
        w[0].ends_with(|c: char| c.is_ascii_digit()) && UNITS.contains(&unit.as_str())
    })
}

/// `I-P`, `1+A` with capitals: I is the identity.
fn has_identity(all: &[&str]) -> bool {
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
fn has_pair(all: &[&str]) -> bool {
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

fn is_script(all: &[&str], at: usize) -> bool {
    at > 0 && matches!(all[at - 1], "_" | "^")
}

/// A letter before brackets whose content is no factor: `\gamma(-1)`, `N(aX,b)`, `E[XY]`.
fn call(all: &[&str]) -> Option<&'static str> {
    for i in 1..all.len() {
        let named = is_letter_token(all[i - 1]) && !is_script(all, i - 1);
        match all[i] {
            "(" if named => {
                let signed = matches!(&all[i + 1..], ["-" | "+", rest @ ..] if {
                    let digits = rest.iter().take_while(|t| t.chars().all(|c| c.is_ascii_digit() || c == '.')).count();
                    digits > 0 && rest.get(digits) == Some(&")")
                });
                if signed {
                    return Some("a value at a place, or a product");
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

/// Letters of functions that have their name from nobody: before parentheses they are no factors.
const SPECIAL: &[&str] = &[r"\Gamma", r"\zeta", r"\delta"];

/// Whether a group in parentheses has commas, and more than a name or a number between them.
fn has_list_of_formulas(all: &[&str]) -> bool {
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

fn has_bars(text: &str) -> bool {
    text.contains('|') || text.contains(r"\lvert") || text.contains(r"\vert") || text.contains(r"\abs")
}

/// `|z|^2`, and no vector in it: of a real number nobody needs the bars.
fn squares_an_absolute_value(text: &str) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let styles = [r"\mathbf", r"\vec", r"\boldsymbol", r"\bf", r"\bm", r"\nabla", r"\hat"];
    let by_command = squeezed.contains(r"\abs") && (squeezed.contains("}^2") || squeezed.contains("}^{2}"));
    by_command && !styles.iter().any(|s| squeezed.contains(s))
        || ["|^2", "|^{2}", r"\rvert^2", r"\rvert^{2}", r"\right|^2", r"\vert^2"].iter().any(|w| squeezed.contains(w))
            && !styles.iter().any(|s| squeezed.contains(s))
}

/// A norm of what is no vector in print.
fn has_norm(text: &str) -> bool {
    let bold = [r"\mathbf", r"\vec", r"\boldsymbol", r"\bf", r"\bm", r"\nabla"].iter().any(|s| text.contains(s));
    !bold && [r"\norm", r"\|", r"\lVert", r"\Vert"].iter().any(|n| text.contains(n))
}

/// An upright word before parentheses or a letter: `\mathrm{Var}(X)`.
fn has_named_function(all: &[&str]) -> bool {
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
        let letters =
            all[i + 1..end.min(all.len())].iter().filter(|t| t.chars().all(|c| c.is_ascii_alphabetic())).count();
        letters > 1 && all.get(end).is_some_and(|t| *t == "(" || *t == "[" || is_letter_token(t) || *t == r"\left")
    })
}

/// Two letters side by side.
fn has_product_of_letters(all: &[&str]) -> bool {
    let letter = |t: &str| is_letter_token(t);
    (1..all.len()).any(|i| {
        let before = all[i - 1];
        (letter(all[i]) || all[i] == "(")
            && (letter(before) || matches!(before, "}" | ")"))
            && !is_script(all, i)
            && !(is_script(all, i - 1) && before == "}")
    })
}

/// The names of two terms of a side that differ in nothing but their order, and in their sign: `xp-px`.
fn commuted(side: &PrintedSide) -> Vec<String> {
    let all = tokens(&side.text);
    let mut terms: Vec<(bool, Vec<&str>)> = vec![(false, Vec::new())];
    let mut depth = 0i32;
    for token in &all {
        match *token {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        match *token {
            "+" | "-" if depth == 0 => terms.push((*token == "-", Vec::new())),
            one => {
                if let Some(last) = terms.last_mut() {
                    last.1.push(one);
                }
            }
        }
    }
    terms.retain(|(_, t)| t.len() > 1);
    let mut out = Vec::new();
    for (i, a) in terms.iter().enumerate() {
        for b in &terms[i + 1..] {
            let (mut first, mut second) = (a.1.clone(), b.1.clone());
            first.sort_unstable();
            second.sort_unstable();
            let plain = a
                .1
                .iter()
                .all(|t| is_letter_token(t) || matches!(*t, "_" | "{" | "}") || t.chars().all(char::is_alphanumeric));
            if first == second && a.1 != b.1 && a.0 != b.0 && plain {
                out.extend(paper::names(side).into_iter().map(|n| squeezed(&n.key())));
                return out;
            }
        }
    }
    out
}
