//! What the whole paper shows of its names.

use std::collections::{BTreeMap, BTreeSet};

use super::super::Paper;
use super::super::mark;
use super::super::printed::{PrintedRelation, PrintedSide, terms};
use super::super::token::{Kind, Token};
use super::local::Local;
use super::notation::files;
use super::runs::Runs;
use super::subscripts::index_letters_of_sums;
use super::{Call, INDICES, PaperName, Subscripts, names_apart, names_of, squeezed};

/// Letters of unknown functions, whose primes derive them where two stand behind them somewhere.
const FUNCTIONS: &[&str] =
    &["x", "y", "z", "u", "v", "w", "f", "g", "h", "X", "Y", r"\phi", r"\psi", r"\varphi", r"\theta"];
/// The axes of space.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Longest side, in bytes, that is looked at.
const LONGEST: usize = 20_000;
/// The text behind a letter that says what it is.
const SAID_OF_A_LETTER: usize = 40;
/// The most terms of a relation that are compared with each other.
const MOST_TERMS: usize = 40;

/// What the whole paper shows of its names.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    /// Keys with a dot or a derivative by time somewhere.
    pub moving: BTreeSet<String>,
    /// What the names are derived by, not partially.
    pub derived: BTreeMap<String, BTreeSet<String>>,
    /// What they are derived by partially.
    pub partial: BTreeMap<String, BTreeSet<String>>,
    /// What their rates are derived by, partially or not, until it is known which names are variables.
    of_rates: BTreeMap<(String, bool), BTreeSet<String>>,
    /// What something is derived by partially.
    pub variables: BTreeSet<String>,
    /// What the paper derives something by in which the names stand, `\partial_r\frac{A'}{A}`, partially or not.
    pub inside: BTreeMap<String, BTreeSet<String>>,
    /// For each name what stands in parentheses behind it, and how often; with `None` how often nothing does.
    pub calls: BTreeMap<String, BTreeMap<Option<Vec<String>>, usize>>,
    /// Letters that are used as operators: with a hat.
    pub hats: BTreeSet<String>,
    /// Whether a letter is printed in bold somewhere.
    pub bold: BTreeSet<String>,
    /// Letters, without backslash, with a place in parentheses behind them somewhere.
    pub functions: BTreeSet<String>,
    /// Subscripts of each letter.
    pub subscripts: BTreeMap<String, Subscripts>,
    /// How often each name is printed, without its primes.
    pub keys: BTreeMap<String, usize>,
    /// The most primes that a name is printed with.
    pub primes: BTreeMap<String, usize>,
    /// Whether the unknown function of an equation has two primes somewhere.
    pub has_double_primes: bool,
    /// Names with dots somewhere.
    pub dotted: BTreeSet<String>,
    /// Of names with primes: the single places that are printed behind them.
    pub primed_places: BTreeMap<String, BTreeMap<String, usize>>,
    /// Of names that are equal to a matrix somewhere: its rows and columns, and how often.
    pub sizes: BTreeMap<String, BTreeMap<(usize, usize), usize>>,
    /// Letters of constants to which the paper gives a meaning of its own.
    other_constants: BTreeSet<String>,
    /// Whether `i` stands where the imaginary unit does: in an exponent, or before ħ.
    pub is_complex: bool,
    /// The same of `j`.
    pub has_complex_j: bool,
    /// Whether `e` is raised to anything but a bare number.
    pub has_exponentials: bool,
    /// Whether `\log` may be another logarithm than the natural one: `\ln` is printed, and `\log(10)`, which would be 1, is not.
    pub has_other_logarithm: bool,
    /// Letters below signs of sums and products: `i` of `\sum_{i=1}^n`.
    summed: BTreeSet<char>,
    /// Labels before a comma below, `r` of `k_{r,i}` beside `k_{f,i}`.
    pub labels: BTreeSet<char>,
    /// For each letter what stands below it before a comma.
    listed: BTreeMap<String, BTreeSet<String>>,
    /// Names that are printed without primes.
    unprimed: BTreeSet<String>,
    /// Names that are printed with one prime.
    primed_once: BTreeSet<String>,
    /// Names of which two stand in a term with one prime each, and in another without: `nr+n'r'`.
    doubled: BTreeSet<String>,
    /// Names that make up a side with their primes.
    primed_alone: BTreeSet<String>,
    /// Vectors that make up a side with a prime, beside one that has a product with them: `\mathbf z'=A\mathbf z`.
    primed_products: BTreeSet<String>,
    /// Runs of capitals.
    pub runs: Runs,
    /// What single sections and chapters show.
    pub local: Local,
}

impl Evidence {
    /// The evidence of a paper.
    pub fn of(paper: &Paper) -> Evidence {
        let mut out = Evidence::default();
        for relation in &paper.printed {
            out.note(relation);
        }
        let text = |s: &PrintedSide| squeezed(&s.text).replace(r"\left", "").replace(r"\right", "");
        let prints = |what: &str| paper.printed.iter().flat_map(|r| &r.sides).any(|s| text(s).contains(what));
        out.has_other_logarithm = prints(r"\ln") && !prints(r"\log(10)");
        out.labels = labels(&out.listed);
        for file in files(paper) {
            out.note_other_constants(&file.text);
        }
        // `\frac{\partial\dot V}{\partial T}` says nothing of V where it is a variable itself, `\frac{\partial p}{\partial V}`.
        for ((key, is_partial), by) in std::mem::take(&mut out.of_rates) {
            if !out.variables.contains(&key) {
                let seen = if is_partial { &mut out.partial } else { &mut out.derived };
                seen.entry(key).or_default().extend(by);
            }
        }
        out
    }

    /// Whether a letter, however it is styled and whatever stands below it, is printed with a place in parentheses behind it: it may be
    /// a function.
    pub fn may_be_function(&self, letter: &str) -> bool {
        self.functions.contains(letter)
    }

    /// Whether a place stands alone in parentheses behind a name somewhere, and is not the time.
    pub fn is_called_at(&self, key: &str, place: &str) -> bool {
        place != "t" && self.calls.get(key).is_some_and(|calls| calls.keys().flatten().any(|p| *p == [place]))
    }

    /// Whether the subscripts of a letter are indices of its components: all could be, and one is a letter that is used so.
    pub fn has_indices(&self, letter: &str) -> bool {
        self.subscripts.get(letter).is_some_and(Subscripts::are_indices)
    }

    /// Whether a name has an index below over which the paper prints a sum: it is no label, whatever else stands below the letter.
    pub fn is_summed_over(&self, name: &PaperName) -> bool {
        name.index_letters().iter().any(|letter| self.summed.contains(letter))
    }

    fn note(&mut self, relation: &PrintedRelation) {
        self.note_doubled(relation);
        let sizes: Vec<Option<(usize, usize)>> = relation.sides.iter().map(|s| size(&s.tokens)).collect();
        for (i, side) in relation.sides.iter().enumerate().filter(|(_, s)| s.text.len() <= LONGEST) {
            self.note_units(side);
            self.note_constants(relation, i);
            self.summed.extend(index_letters_of_sums(&side.tokens));
            self.runs.note(side);
            if let [name] = names_apart(side).as_slice()
                && name.primes > 0
                && is_alone(side)
            {
                let bare = unprimed(name);
                let others = relation.sides.iter().enumerate().filter(|(k, s)| *k != i && s.text.len() <= LONGEST);
                if name.is_bold && others.flat_map(|(_, s)| terms(&s.tokens)).any(|term| multiplies(&term, &bare)) {
                    self.primed_products.insert(bare.clone());
                }
                self.primed_alone.insert(bare);
            }
            self.local.note_side(relation, side);
            let beside = [i.checked_sub(1), Some(i + 1)].into_iter().flatten();
            let found = beside.filter_map(|k| sizes.get(k).copied().flatten()).next();
            if let (Some(size), [name, rest @ ..]) = (found, names_apart(side).as_slice())
                && sizes[i].is_none()
                && (rest.is_empty() && (name.derived_by.is_some() || is_alone(side)) || is_at_places(name, side))
            {
                self.local.note_size(relation, &name.key());
                *self.sizes.entry(name.key()).or_default().entry(size).or_default() += 1;
            }
        }
        for name in relation.sides.iter().filter(|s| s.text.len() <= LONGEST).flat_map(names_apart) {
            let key = name.key();
            let bare = unprimed(&name);
            self.local.note_name(relation, &name);
            *self.keys.entry(bare.clone()).or_default() += 1;
            if name.dots > 0 {
                self.dotted.insert(bare.clone());
            }
            self.note_primes(&name, &bare);
            self.note_derivative(&name, &key, &bare);
            let call = match &name.call {
                Call::Places(places) => Some(Some(places.clone())),
                Call::None => Some(None),
                Call::Other => None,
            };
            if let Some(call) = call {
                *self.calls.entry(key).or_default().entry(call).or_default() += 1;
            }
            if let Call::Places(places) = &name.call
                && places.iter().any(|p| !p.chars().all(|c| c.is_ascii_digit()))
            {
                self.functions.insert(name.letter.trim_start_matches('\\').to_owned());
            }
            if name.has_hat {
                self.hats.insert(name.letter.clone());
            }
            if name.is_bold {
                self.bold.insert(name.letter.clone());
            }
            if let Some(sub) = &name.subscript {
                self.subscripts.entry(name.letter.clone()).or_default().note(sub);
                if let Some((first, _)) = sub.split_once(',') {
                    self.listed.entry(name.letter.clone()).or_default().insert(first.trim().to_owned());
                }
            }
        }
    }

    /// With how many primes a name is printed.
    fn note_primes(&mut self, name: &PaperName, bare: &str) {
        if name.primes == 0 {
            self.unprimed.insert(bare.to_owned());
        }
        if name.primes == 1 {
            self.primed_once.insert(bare.to_owned());
        }
        if name.primes > 0 {
            let letter = name.base.trim_end_matches('\'');
            self.has_double_primes |= name.primes > 1 && ["x", "y", "u", "f"].contains(&letter);
            let most = self.primes.entry(bare.to_owned()).or_default();
            *most = name.primes.max(*most);
            if let Call::Places(places) = &name.call
                && let [one] = places.as_slice()
                && is_variable(one)
            {
                *self.primed_places.entry(bare.to_owned()).or_default().entry(one.clone()).or_default() += 1;
            }
        }
    }

    /// By what a name is derived.
    fn note_derivative(&mut self, name: &PaperName, key: &str, bare: &str) {
        let is_derived = name.derived_by.is_some() && !name.is_in_group;
        if name.dots > 0 || is_derived && name.derived_by.as_deref() == Some("t") && !name.is_partial {
            self.moving.insert(key.to_owned());
        }
        if let Some(by) = name.derived_by.as_ref().filter(|_| is_derived) {
            let seen = match (name.is_partial, name.dots > 0 && by != "t") {
                (is_partial, true) => self.of_rates.entry((key.to_owned(), is_partial)).or_default(),
                (true, false) => self.partial.entry(key.to_owned()).or_default(),
                (false, false) => self.derived.entry(key.to_owned()).or_default(),
            };
            seen.insert(by.clone());
        }
        if let Some(by) = name.derived_by.as_ref().filter(|_| name.is_partial) {
            self.variables.insert(by.clone());
        }
        if let Some(by) = name.derived_by.as_ref().filter(|by| is_variable(by) && *by != key) {
            self.inside.entry(bare.to_owned()).or_default().insert(by.clone());
        }
    }

    /// Letters of constants that the paper gives another meaning: `i=V/R`, `\dot i`, `\pi=p-eA`.
    fn note_constants(&mut self, relation: &PrintedRelation, at: usize) {
        let Some(side) = relation.sides.get(at) else { return };
        let text = side.text.trim();
        let is_first = at == 0 && relation.sides.iter().skip(1).any(|other| !names_apart(other).is_empty());
        // `\dot i`, `\frac{d\pi}{dt}`
        let varies = |name: &PaperName| name.dots > 0 || name.derived_by.is_some();
        let varies = |letter: &str| names_apart(side).iter().any(|name| name.base == letter && varies(name));
        for letter in ["i", r"\pi"] {
            if is_first && text == letter || varies(letter) {
                self.other_constants.insert(letter.to_owned());
            }
        }
    }

    /// Notes the letters of constants that the words of a text give another meaning: "let $i$ be the current".
    fn note_other_constants(&mut self, text: &str) {
        for (letter, printed) in [("i", "$i$"), (r"\pi", r"$\pi$")] {
            let is_other = |(at, _): (usize, &str)| {
                let behind: String = text[at + printed.len()..].chars().take(SAID_OF_A_LETTER).collect();
                let behind = behind.to_lowercase();
                let says = [" be the ", " be a ", " is the ", " is a ", " denotes", " stands for"];
                let is_itself =
                    ["imaginary", "unit", "root", "ratio", "circle", "complex"].iter().any(|w| behind.contains(w));
                says.iter().any(|w| behind.starts_with(w)) && !is_itself
            };
            if text.match_indices(printed).any(is_other) {
                self.other_constants.insert(letter.to_owned());
            }
        }
    }

    /// Whether the paper gives the letter of a constant another meaning; beside exponents with `i` that is the unit, whatever it is called, too.
    pub fn is_other_constant(&self, key: &str) -> bool {
        self.other_constants.contains(key) && !(key == "i" && self.is_complex)
    }

    /// What stands in exponents of `e`, and before ħ.
    fn note_units(&mut self, side: &PrintedSide) {
        let marks = mark::marks(&side.tokens);
        let text = |i: usize| marks.get(i).map_or("", |m| m.text.as_str());
        for at in 0..marks.len() {
            let exponent = match text(at) {
                "e" | r"\mathrm" if text(at + 1) == "^" => at + 2..mark::unit(&marks, at + 2),
                "e" if text(at + 1) == "}" && text(at + 2) == "^" => at + 3..mark::unit(&marks, at + 3),
                r"\exp" => at + 1..(at + 12).min(marks.len()),
                _ => continue,
            };
            let inside: Vec<&str> = exponent.map(text).collect();
            self.has_exponentials |= inside.iter().any(|t| t.starts_with('\\') || t.chars().all(char::is_alphabetic));
            let unit = |letter: &str| {
                (0..inside.len()).any(|i| inside[i] == letter && (i == 0 || !matches!(inside[i - 1], "_" | "^")))
            };
            self.is_complex |= unit("i");
            self.has_complex_j |= unit("j");
        }
        self.is_complex |= (0..marks.len())
            .any(|i| text(i) == "i" && text(i + 1) == r"\hbar" && (i == 0 || !matches!(text(i - 1), "_" | "^")));
    }

    /// What the primes of a name are.
    ///
    /// Two primes somewhere in the paper, or a prime before a place, `f'(x)`, show that primes derive: by the variable of which the paper
    /// prints the name as a function, or by which it derives it. Beside dots for rates a prime is part of a name: a system of axes that is
    /// turned. Of a function elsewhere, or of a wave function, it could be either.
    pub fn primes_of(&self, bare: &str) -> Primes {
        let Some(&primes) = self.primes.get(bare) else { return Primes::Name };
        let called = self.primed_places.get(bare);
        // A rate, or other axes.
        if self.primed_products.contains(bare) {
            return Primes::Unclear;
        }
        if self.dotted.contains(bare) && called.is_none() {
            return Primes::Name;
        }
        let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
        for (places, n) in self.calls.get(bare).into_iter().flatten() {
            if let Some([one]) = places.as_deref()
                && is_variable(one)
            {
                *seen.entry(one).or_default() += n;
            }
        }
        for (by, n) in called.into_iter().flatten() {
            *seen.entry(by).or_default() += n;
        }
        // A second medium has the index n′, whatever n is derived by.
        for by in self.derived.get(bare).into_iter().flatten().filter(|by| primes > 1 && is_variable(by)) {
            *seen.entry(by).or_default() += 1;
        }
        // Two primes derive: by the one variable by which the paper derives what it stands in.
        if primes > 1
            && seen.is_empty()
            && let Some(by) = self.inside.get(bare)
            && by.len() == 1
        {
            seen.extend(by.iter().map(|by| (by.as_str(), 1)));
        }
        let letter = plain_letter(bare);
        let is_function = FUNCTIONS.contains(&letter);
        let derive = called.is_some() || primes > 1 || self.has_double_primes;
        if self.may_be_wave(bare) {
            return Primes::Unclear;
        }
        if !is_function && self.primes_name(bare) {
            return Primes::Name;
        }
        match seen.into_iter().max_by_key(|(v, n)| (*n, std::cmp::Reverse(*v))) {
            Some((by, _)) if derive => Primes::Derive(by.to_owned()),
            Some(_) => Primes::Unclear,
            // The letter of an unknown function, in a paper whose primes derive, and no dots on that letter.
            None if is_function
                && (primes > 1 || self.has_double_primes)
                && !self.dotted.iter().any(|d| d.split('_').next() == Some(letter)) =>
            {
                let is_rate = matches!(letter, "x" | r"\theta" | r"\phi" | r"\varphi");
                match is_rate {
                    // Rates have dots in this paper: these are other axes, perhaps, and surely so where all three have primes.
                    _ if AXES.contains(&letter) && !self.dotted.is_empty() && self.has_other_axes() => Primes::Name,
                    true if !self.dotted.is_empty() => Primes::Unclear,
                    true => Primes::Usual("t".to_owned()),
                    false => Primes::Usual("x".to_owned()),
                }
            }
            None if bare.contains("\\mathbf") || bare.contains("\\vec") => Primes::Name,
            None if primes > 1 || self.has_double_primes => Primes::Unclear,
            None => Primes::Name,
        }
    }

    /// Whether x, y and z are printed with primes, and nothing is derived by them that way: other axes.
    fn has_other_axes(&self) -> bool {
        AXES.iter().all(|axis| self.primes.contains_key(*axis) && !self.derived.contains_key(*axis))
            && self.primed_places.is_empty()
    }

    /// Whether the paper shows that primes are a part of a name: it derives with fractions, and nowhere with primes before a place. Either it
    /// prints the name with one prime and with two, and never without; or it has no two primes at all, the name with its prime is no side of an
    /// equation, as a rate would be, and a term has a prime at two names, of which the product stands without primes beside it:
    /// `n\sin\alpha=n'\sin\alpha'`.
    fn primes_name(&self, bare: &str) -> bool {
        let derives_with_fractions = !self.inside.is_empty();
        let is_derived = self.derived.contains_key(bare) || self.partial.contains_key(bare);
        if !derives_with_fractions || is_derived || !self.primed_places.is_empty() {
            return false;
        }
        if self.primes.get(bare) == Some(&2) {
            return self.primed_once.contains(bare) && !self.unprimed.contains(bare);
        }
        self.primes.values().all(|n| *n == 1) && self.doubled.contains(bare) && !self.primed_alone.contains(bare)
    }

    /// Takes note of the names of which two stand in a term with one prime each, and in another without.
    fn note_doubled(&mut self, relation: &PrintedRelation) {
        let terms = relation.sides.iter().filter(|s| s.text.len() <= LONGEST).flat_map(|s| terms(&s.tokens));
        let keys = |all: &[PaperName], primes: usize| -> BTreeSet<String> {
            all.iter().filter(|n| n.primes == primes).map(unprimed).collect()
        };
        let all: Vec<_> = terms.map(|t| names_of(&t)).map(|n| (keys(&n, 0), keys(&n, 1))).take(MOST_TERMS).collect();
        for (plain, primed) in &all {
            for (other_plain, other_primed) in &all {
                let both: BTreeSet<&String> = primed.intersection(other_plain).collect();
                let is_mixed = both.iter().any(|k| plain.contains(*k) || other_primed.contains(*k));
                if both.len() > 1 && !is_mixed {
                    self.doubled.extend(both.into_iter().cloned());
                }
            }
        }
    }

    /// The same in a section: where it derives nothing, and has no such function, a single prime is a part of the name.
    pub fn primes_in(&self, bare: &str, section: usize) -> Primes {
        let is_function = FUNCTIONS.contains(&plain_letter(bare));
        let is_single =
            self.primes.get(bare) == Some(&1) && !self.may_be_wave(bare) && !self.primed_products.contains(bare);
        match self.primes_of(bare) {
            Primes::Unclear if is_single && !self.local.may_derive(section, bare) => Primes::Name,
            // A function of another section, whose primes derive there, perhaps.
            Primes::Derive(_) if is_single && !is_function && !self.local.may_derive(section, bare) => Primes::Unclear,
            known => known,
        }
    }

    /// Whether a name may be a wave function.
    fn may_be_wave(&self, bare: &str) -> bool {
        let letter = bare.split('_').next().unwrap_or_default();
        self.is_complex && matches!(letter, r"\psi" | r"\Psi" | r"\phi" | r"\varphi" | r"\chi")
    }

    /// The variable by which primes derive a name.
    pub fn primed_by(&self, bare: &str) -> Option<String> {
        match self.primes_of(bare) {
            Primes::Derive(by) | Primes::Usual(by) => Some(by),
            Primes::Name | Primes::Unclear => None,
        }
    }

    /// The rows and columns of what a name is equal to, where that is always the same.
    pub fn size(&self, key: &str) -> Option<(usize, usize)> {
        let sizes = self.sizes.get(key)?;
        (sizes.len() == 1).then(|| sizes.keys().next().copied()).flatten()
    }
}

/// The letter of a name without its subscript and a tilde, `y` of `\tilde{y}_p`.
fn plain_letter(bare: &str) -> &str {
    let base = bare.split('_').next().unwrap_or_default();
    base.strip_prefix(r"\tilde{").and_then(|rest| rest.strip_suffix('}')).unwrap_or(base)
}

/// What the primes of a name are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Primes {
    /// A part of the name.
    Name,
    /// Derivatives by this.
    Derive(String),
    /// Derivatives, by what is usual: the paper does not show it.
    Usual(String),
    /// Either.
    Unclear,
}

/// Letters that could be indices, and stand before a comma where the same name has another letter, which could not: they are labels.
fn labels(listed: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<char> {
    let letter = |s: &String| s.chars().next().filter(|c| s.chars().count() == 1 && c.is_alphabetic());
    let is_of_indices = |name: &str| matches!(name, r"\delta" | r"\epsilon" | r"\varepsilon");
    let labelled = listed.iter().filter(|(name, firsts)| {
        !is_of_indices(name) && firsts.iter().filter_map(letter).any(|c| !INDICES.contains(c))
    });
    labelled.flat_map(|(_, firsts)| firsts.iter().filter_map(letter)).collect()
}

/// A single letter that stands for a number.
pub fn is_variable(text: &str) -> bool {
    let mut letters = text.strip_prefix('\\').unwrap_or(text).chars();
    let one = text.starts_with('\\') || text.chars().count() == 1;
    one && letters.all(char::is_alphabetic) && !text.is_empty()
}

/// The key of a name without its primes.
pub fn unprimed(name: &PaperName) -> String {
    PaperName { base: name.base.trim_end_matches('\'').to_owned(), ..name.clone() }.key()
}

/// Whether the last of several names of a term is this one, without a prime.
fn multiplies(term: &[Token], bare: &str) -> bool {
    let all = names_of(term);
    all.len() > 1 && all.last().is_some_and(|n| n.primes == 0 && n.key() == bare)
}

/// Whether a side is a name at its places, and nothing else: `B(\alpha)`.
fn is_at_places(name: &PaperName, side: &PrintedSide) -> bool {
    let Call::Places(places) = &name.call else { return false };
    squeezed(&side.text) == squeezed(&format!("{}({})", name.key(), places.join(",")))
}

/// Whether a side is one name, with dots and labels, and nothing else.
pub fn is_alone(side: &PrintedSide) -> bool {
    let signs = ["+", "-", "(", "[", "=", r"\frac", r"\cdot", r"\times", "|", r"\nabla", r"\int", r"\sum", r"\partial"];
    let marks = mark::marks(&side.tokens);
    let is_digit = |at: usize| marks[at].text.starts_with(|c: char| c.is_ascii_digit());
    // The digits of a label, `M_1`, are no factor.
    let is_below = |at: usize| {
        let opening = (0..at).rev().find(|&i| marks[i].text != "{" && !is_digit(i));
        opening.is_some_and(|i| marks[i].text == "_" && (marks[i + 1].text == "{" || i + 1 == at))
    };
    (0..marks.len()).all(|at| !signs.contains(&marks[at].text.as_str()) && (!is_digit(at) || is_below(at)))
}

/// What makes a number of matrices, or may.
const OF_NUMBERS: &[&str] =
    &[r"\det", r"\cdot", r"\times", "|", r"\lvert", r"\operatorname", r"\mathrm", "^T", r"^{T}", r"\tr"];

impl PrintedSide {
    /// Rows and columns, where the side is a product or a sum of matrices that are written out.
    pub fn matrix_size(&self) -> Option<(usize, usize)> {
        let is_matrix = !OF_NUMBERS.iter().any(|w| self.text.contains(w));
        size(&self.tokens).filter(|_| is_matrix)
    }
}

/// Rows and columns of a product, or a sum, of matrices that are written out: those of its first, and of its last.
pub fn size(tokens: &[Token]) -> Option<(usize, usize)> {
    let (mut first, mut last) = (None, None);
    let mut at = 0;
    while at < tokens.len() {
        at += 1;
        if !tokens[at - 1].is("begin") {
            continue;
        }
        let (name, mut next) = mark::group_text(tokens, at);
        if !name.ends_with("matrix") || matches!(name.as_str(), "vmatrix" | "Vmatrix") {
            continue;
        }
        let (mut rows, mut columns, mut most, mut printed, mut depth) = (1, 1, 1, false, 0);
        while let Some(token) = tokens.get(next) {
            next += 1;
            match token.text.as_str() {
                "end" if token.kind == Kind::Command && depth == 0 => break,
                "begin" if token.kind == Kind::Command => depth += 1,
                "end" if token.kind == Kind::Command => depth -= 1,
                "&" if depth == 0 => columns += 1,
                "\\" if token.kind == Kind::Command && depth == 0 => {
                    rows += 1;
                    most = most.max(columns);
                    (columns, printed) = (1, false);
                }
                _ => printed |= token.kind != Kind::Space,
            }
        }
        most = most.max(columns);
        rows -= usize::from(!printed && columns == 1 && rows > 1);
        first.get_or_insert(rows);
        last = Some(most);
        at = next;
    }
    Some((first?, last?))
}
