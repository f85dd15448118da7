//! Names as they are printed, and what the whole paper shows of them.
//!
//! **In:** printed relations. **Out:** the names of each side, with dots, primes, subscripts and what stands in parentheses behind
//! them; and the [`Evidence`] of the paper: of what the paper prints a rate, what it derives by what, which subscripts are indices.
//! **Guaranteed:** nothing is decided here: a name is what is printed, and evidence is what was seen.

mod above;
mod braces;
mod derivatives;
mod difference;
pub mod evidence;
pub mod letters;
mod local;
mod notation;
mod order;
mod runs;
mod subscripts;
#[cfg(test)]
mod tests;

use super::PrintedSide;
use super::mark::{self, Mark};
use super::token::{Kind, Token};
use braces::without_braces_of_names;
pub use evidence::Evidence;
pub use evidence::{Primes, is_variable, unprimed};
use letters::{BOLD, DOTS, FRACTIONS, HATS, SIGNS_OF_DIFFERENCES, STYLES, is_letter_command, is_switch};
pub use notation::{Notation, squeezed};
pub use order::{cancels_by_order, order_counts};
pub use subscripts::Subscripts;

/// A name of a formula, as it is printed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct PaperName {
    /// The letter in LaTeX, with its style and primes: `\mathbf{x}`, `\psi`, `f'`.
    pub base: String,
    /// The letter without style and primes.
    pub letter: String,
    /// Whether its style is that of vectors.
    pub is_bold: bool,
    /// Whether it has a hat: an operator, or a unit vector.
    pub has_hat: bool,
    /// The subscript, without its outer braces.
    pub subscript: Option<String>,
    /// How many dots stand above it.
    pub dots: usize,
    /// How many primes stand behind it.
    pub primes: usize,
    /// What stands in parentheses behind it.
    pub call: Call,
    /// Whether it stands in a derivative by this.
    pub derived_by: Option<String>,
    /// Whether the derivative is a partial one.
    pub is_partial: bool,
    /// A `d`, `\delta` or `\Delta` right before another name: a difference, and no factor.
    pub is_difference: bool,
    /// A label above it, without its outer braces: `(1)`, `*`, `\rm R`.
    pub above: Option<String>,
    /// Whether it is derived together with other names, `\frac{d}{dt}(mv)`: some of them may not change.
    pub is_in_group: bool,
    /// Whether something is derived by it here.
    pub is_variable: bool,
}

/// Letters that are indices for most readers.
pub const INDICES: &str = "ijklmnpqrsabαβμν";

/// What stands in parentheses behind a name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Call {
    /// Nothing.
    None,
    /// Names and numbers, separated by commas: arguments, it may be.
    Places(Vec<String>),
    /// Anything else: a factor, it may be.
    Other,
}

impl PaperName {
    /// The name as a key of a derivation file, with its labels below and above.
    pub fn key(&self) -> String {
        let mut key = match &self.subscript {
            Some(sub) if sub.chars().count() == 1 => format!("{}_{sub}", self.base),
            Some(sub) => format!("{}_{{{sub}}}", self.base),
            None => self.base.clone(),
        };
        if let Some(above) = &self.above {
            key.push_str(&format!("^{{{above}}}"));
        }
        key
    }

    /// The sign of a difference with which it begins, `\Delta`.
    pub fn difference_sign(&self) -> Option<&'static str> {
        let begins = |sign: &&&str| self.base.strip_prefix(**sign).is_some_and(|rest| rest.starts_with(' '));
        SIGNS_OF_DIFFERENCES.iter().find(begins).copied()
    }

    /// Whether its subscript consists of letters that are used as indices.
    pub fn index_letters(&self) -> Vec<char> {
        let Some(sub) = &self.subscript else { return Vec::new() };
        let plain = !sub.is_empty() && sub.chars().all(|c| c == ',' || INDICES.contains(c)) && sub.chars().count() <= 4;
        if plain { sub.chars().filter(|c| *c != ',').collect() } else { Vec::new() }
    }

    /// The letters by themselves anywhere below it that could be indices: `i` of `k_{f,i}`, `j` of `\theta_{P,\partial n_j}`.
    pub fn letters_below(&self) -> Vec<char> {
        let whole = self.index_letters();
        let Some(sub) = self.subscript.as_deref().filter(|_| whole.is_empty()) else { return whole };
        // What follows a backslash, or another letter, is a part of a word.
        let words = sub.split(|c: char| !c.is_alphanumeric() && c != '\\').filter(|w| !w.starts_with('\\'));
        words.filter_map(|w| w.chars().next().filter(|c| w.chars().count() == 1 && INDICES.contains(*c))).collect()
    }
}

/// The names of a side, in their order; a sign of a difference and the name behind it are one, `\Delta x`.
pub fn names(side: &PrintedSide) -> Vec<PaperName> {
    read(&side.tokens, Differences::Joined)
}

/// The same, where a sign of a difference is a name of its own.
pub(super) fn names_apart(side: &PrintedSide) -> Vec<PaperName> {
    names_of(&side.tokens)
}

/// The names of a formula, in their order, the signs of differences apart.
pub(super) fn names_of(tokens: &[Token]) -> Vec<PaperName> {
    read(tokens, Differences::Apart)
}

/// What becomes of `\Delta` and `\delta` before a name.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Differences {
    Joined,
    Apart,
}

/// So many commands of style and braces stand before a letter at most: it is no name that is read otherwise.
const MOST_OF_STYLES: usize = 100;

fn read(tokens: &[Token], differences: Differences) -> Vec<PaperName> {
    let marks = without_braces_of_names(mark::marks(tokens));
    let cells = tokens.iter().filter(|t| t.is_char("&") || t.is("\\")).map(|t| t.span.start).collect();
    let mut reader = Names { units: mark::units(&marks), marks, cells, out: Vec::new(), differences };
    let end = reader.marks.len();
    reader.range(0, end, &None, 0);
    reader.out
}

struct Names {
    marks: Vec<Mark>,
    /// Where the unit ends that begins with each mark.
    units: Vec<usize>,
    /// Where a cell of a matrix ends.
    cells: Vec<usize>,
    out: Vec<PaperName>,
    differences: Differences,
}

/// By what something is derived, and whether partially.
type By = Option<(String, bool)>;

/// Deepest nesting of groups that is looked into.
const DEEPEST: usize = 100;

impl Names {
    fn text(&self, at: usize) -> &str {
        self.marks.get(at).map_or("", |m| m.text.as_str())
    }

    fn unit(&self, at: usize) -> usize {
        self.units.get(at).copied().unwrap_or(self.marks.len())
    }

    fn range(&mut self, from: usize, to: usize, by: &By, depth: usize) {
        if depth > DEEPEST {
            return;
        }
        let mut at = from;
        while at < to {
            let text = self.text(at).to_owned();
            let command = text.strip_prefix('\\').unwrap_or("");
            if FRACTIONS.contains(&command) {
                at = self.fraction(at, to, by, depth);
            } else if matches!(command, "dv" | "pdv" | "derivative" | "partialderivative" | "odv" | "fdv") {
                at = self.physics(at, to, command != "dv" && command != "derivative" && command != "odv", depth);
            } else if matches!(
                command,
                "text" | "mbox" | "hbox" | "textrm" | "operatorname" | "mathop" | "label" | "begin" | "end"
            ) {
                at = self.unit(at + 1);
            } else if let Some((end, primes)) = self.primed_matrix(at, to) {
                let before = self.out.len();
                self.range(at + 1, end - 1, by, depth + 1);
                self.note_primes(before, (at, end), primes);
                at = end;
            } else if command == "partial" {
                at = self.partial_letter(at, to, depth);
            } else if let Some(next) = self.slashed(at, to, depth) {
                at = next;
            } else if let Some(next) = self.name(at, to, by) {
                at = next;
            } else {
                at += 1;
            }
        }
    }

    /// A variable by which something is derived, as a key, and the position after it.
    fn variable(&self, at: usize) -> Option<(String, usize)> {
        self.variable_as_printed(at).map(|(text, end)| (canonical(&text), end))
    }

    fn variable_as_printed(&self, at: usize) -> Option<(String, usize)> {
        let text = self.text(at);
        let is_letter = text.len() == 1 && text.as_bytes()[0].is_ascii_alphabetic()
            || text.strip_prefix('\\').is_some_and(is_letter_command);
        let command = text.strip_prefix('\\').unwrap_or("");
        if DOTS.iter().any(|(d, _)| *d == command) {
            // `\dot x_1`: the rate of the name with its index.
            let (inner, end) = (self.inner(at + 1).0, self.unit(at + 1));
            let (mut key, inside) = self.variable_as_printed(inner)?;
            let mut end = end.max(inside);
            if self.text(end) == "_" {
                let index = end;
                end = self.unit(end + 1);
                key.push_str(&self.spelled(index, end));
            }
            return Some((with_dots(&text[1..], &canonical(&key)), end));
        }
        if BOLD.contains(&command) {
            let mut end = self.unit(at + 1);
            if self.text(end) == "_" {
                end = self.unit(end + 1);
            }
            return Some((self.spelled(at, end), end));
        }
        if !is_letter {
            return None;
        }
        let mut end = at + 1;
        if self.text(end) == "_" {
            end = self.unit(end + 1);
        }
        Some((self.spelled(at, end), end))
    }

    fn spelled(&self, from: usize, to: usize) -> String {
        let mut out = String::new();
        for m in &self.marks[from.min(to)..to.min(self.marks.len())] {
            let letter = m.text.starts_with(|c: char| c.is_ascii_alphabetic());
            let command = out
                .rfind('\\')
                .is_some_and(|i| out.len() > i + 1 && out[i + 1..].chars().all(|c| c.is_ascii_alphabetic()));
            if letter && command {
                out.push(' ');
            }
            out.push_str(&m.text);
        }
        out
    }

    /// What is inside of a group: from, to.
    fn inner(&self, at: usize) -> (usize, usize) {
        let end = self.unit(at);
        if self.text(at) == "{" { (at + 1, end.saturating_sub(1)) } else { (at, end) }
    }

    /// The position after the bracket that closes the one here.
    fn closing(&self, at: usize, to: usize) -> usize {
        let mut depth = 0i32;
        for i in at..to {
            match self.text(i) {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                return i + 1;
            }
        }
        to
    }

    /// A name that begins here, with all that belongs to it; the position after it.
    fn name(&mut self, at: usize, to: usize, by: &By) -> Option<usize> {
        let (mut dots, mut bold, mut hat) = (0, false, false);
        let mut styles: Vec<String> = Vec::new();
        let mut next = at;
        let mut closing = 0;
        let amount = self.amount(at, to);
        let mut letter = amount.clone().unwrap_or_default();
        if amount.is_some() {
            next = at + 3;
        }
        while amount.is_none() {
            if next >= to.min(at + MOST_OF_STYLES) {
                return None;
            }
            let text = self.text(next).to_owned();
            let command = text.strip_prefix('\\').unwrap_or("");
            if text == "{"
                && (!styles.is_empty() || dots > 0 || matches!(self.text(next + 1), r"\bf" | r"\rm" | r"\cal"))
            {
                closing += 1;
            } else if let Some((_, n)) = DOTS.iter().find(|(d, _)| *d == command) {
                dots += n;
            } else if BOLD.contains(&command) {
                bold = true;
                styles.push(if matches!(command, "vec" | "va" | "overrightarrow") {
                    r"\vec".into()
                } else {
                    r"\mathbf".into()
                });
            } else if HATS.contains(&command) {
                hat = true;
                styles.push(r"\hat".into());
            } else if STYLES.contains(&command) {
                styles.push(format!("\\{}", if command == "cal" { "mathcal" } else { command }));
            } else {
                let one = text.chars().count() == 1 && text.chars().all(char::is_alphabetic);
                if !one && !is_letter_command(command) {
                    return None;
                }
                letter = text;
                next += 1;
                break;
            }
            next += 1;
        }
        let mut primes = 0;
        let (mut subscript, mut above) = (None, None);
        while closing > 0 && next < to {
            // Several letters in one style are one name: `\mathrm{Re}`.
            match self.text(next) {
                "}" => closing -= 1,
                "'" | r"\prime" => primes += 1,
                "_" => {
                    let end = self.unit(next + 1);
                    subscript = Some(self.below(next + 1, end));
                    next = end;
                    continue;
                }
                more if more.chars().count() == 1 && more.chars().all(char::is_alphanumeric) => letter.push_str(more),
                _ => return None,
            }
            next += 1;
        }
        loop {
            match self.text(next) {
                "'" => primes += 1,
                "^" if self.primes_above(next + 1) > 0 => {
                    primes += self.primes_above(next + 1);
                    next = self.unit(next + 1);
                    continue;
                }
                "_" if subscript.is_none() && next < to => {
                    let end = self.script_end(next + 1);
                    subscript = Some(self.below(next + 1, end));
                    next = end;
                    continue;
                }
                "^" if above.is_none() && !(letter == "e" && styles.is_empty()) => match self.label_above(next + 1) {
                    Some((label, end)) if end <= to => {
                        above = Some(label);
                        next = end;
                        continue;
                    }
                    _ => break,
                },
                _ => break,
            }
            next += 1;
        }
        // Euler's number is no name, and upright d is a differential.
        if letter == "e" && styles.is_empty() && subscript.is_none() && self.text(next) == "^" {
            return Some(next);
        }
        let is_bare = styles.is_empty() && subscript.is_none() && primes + dots == 0;
        if self.differences == Differences::Joined
            && is_bare
            && let Some(end) = self.joined(&letter, next, to, by)
        {
            return Some(end);
        }
        let mut base = letter.clone();
        for style in styles.iter().rev() {
            base = format!("{style}{{{base}}}");
        }
        base.push_str(&"'".repeat(primes));
        let call = self.call(next, to);
        let alone = styles.is_empty() || styles == [r"\mathrm"];
        let is_difference = alone
            && (letter == "d" || SIGNS_OF_DIFFERENCES.contains(&letter.as_str()))
            && primes == 0
            && subscript.is_none()
            && self.begins_name(next, to);
        let (derived_by, is_partial) = match by {
            Some((by, partial)) => (Some(if by.starts_with(r"\d") { by.clone() } else { plain(by).key() }), *partial),
            None => (None, false),
        };
        let name = PaperName {
            base,
            letter,
            is_bold: bold,
            has_hat: hat,
            subscript,
            dots,
            primes,
            call,
            derived_by,
            is_partial,
            is_difference,
            above,
            is_in_group: false,
            is_variable: false,
        };
        self.out.push(name);
        Some(next)
    }

    /// Whether a name, or what stands in parentheses, begins here, perhaps behind a power.
    fn begins_name(&self, at: usize, to: usize) -> bool {
        let at = if self.text(at) == "^" { self.unit(at + 1) } else { at };
        let text = self.text(at);
        let command = text.strip_prefix('\\').unwrap_or("");
        let letter = text.chars().count() == 1 && text.chars().all(char::is_alphabetic);
        let styled = BOLD.contains(&command)
            || HATS.contains(&command)
            || STYLES.contains(&command)
            || DOTS.iter().any(|(d, _)| *d == command);
        at < to && !self.begins_cell(at) && (letter || text == "(" || is_letter_command(command) || styled)
    }

    /// How many primes a unit prints that has nothing else: `\prime`, `{\prime\prime}`.
    fn primes_above(&self, at: usize) -> usize {
        let (from, to) = self.inner(at);
        let are_primes = (from..to).all(|i| matches!(self.text(i), r"\prime" | "'"));
        if are_primes { to.saturating_sub(from) } else { 0 }
    }

    /// Whether a cell of a matrix ends before a mark, and another begins with it.
    fn begins_cell(&self, at: usize) -> bool {
        let place = |at: usize| self.marks.get(at).map(|m| m.span.start);
        let before = at.checked_sub(1).and_then(place);
        before.zip(place(at)).is_some_and(|(from, to)| self.cells.iter().any(|cell| (from..to).contains(cell)))
    }

    /// The end of a script that begins here: a command of style takes its argument with it, `p_\mathrm{max}`.
    fn script_end(&self, at: usize) -> usize {
        let command = self.text(at).strip_prefix('\\').unwrap_or("");
        let takes = matches!(command, "text" | "textrm" | "mbox" | "operatorname")
            || DOTS.iter().any(|(d, _)| *d == command)
            || [BOLD, HATS, STYLES].iter().any(|s| s.contains(&command)) && !is_switch(command);
        self.unit(if takes { at + 1 } else { at })
    }

    /// A subscript without its outer braces.
    fn below(&self, from: usize, to: usize) -> String {
        let (a, b) = if self.text(from) == "{" { self.inner(from) } else { (from, to) };
        self.spelled(a, b.min(to))
    }

    /// What stands in parentheses behind a name.
    fn call(&self, at: usize, to: usize) -> Call {
        if self.text(at) != "(" {
            return Call::None;
        }
        // Behind a name that an operator acts on the parentheses are no part of the range.
        let end = self.closing(at, if at < to { to } else { self.marks.len() });
        let inside: Vec<&str> = (at + 1..end.saturating_sub(1)).map(|i| self.text(i)).collect();
        let mut places = vec![String::new()];
        let mut after_command = false;
        for text in inside {
            match text {
                "," => {
                    places.push(String::new());
                    after_command = false;
                }
                t if matches!(t, "{" | "}" | "_" | "'")
                    || t.chars().all(char::is_alphanumeric)
                    || t.strip_prefix('\\').is_some_and(|c| {
                        is_letter_command(c) || BOLD.contains(&c) || DOTS.iter().any(|(d, _)| *d == c)
                    }) =>
                {
                    if let Some(place) = places.last_mut() {
                        if after_command && t.starts_with(|c: char| c.is_ascii_alphabetic()) {
                            place.push(' ');
                        }
                        place.push_str(t);
                    }
                    after_command = t.starts_with('\\');
                }
                _ => return Call::Other,
            }
        }
        // A product of two letters is a factor, not a place.
        let single = |p: &String| {
            let tokens = super::token::tokens(p);
            let letters = tokens.iter().filter(|t| is_letter(t)).count();
            letters <= 1 || p.contains('_')
        };
        let one = |p: String| match names_of(&super::token::tokens(&p)).as_slice() {
            // A vector is called as where it stands by itself.
            [name] if name.is_bold && name.dots == 0 => name.key(),
            [name] if name.dots > 0 && name.primes == 0 && name.call == Call::None => {
                let dots = DOTS.iter().find(|(_, n)| *n == name.dots).map_or("dot", |(d, _)| d);
                with_dots(dots, &name.key())
            }
            _ if is_variable(&p) || p.contains('_') => plain(&p).key(),
            _ => p,
        };
        if places.iter().all(|p| !p.is_empty() && single(p)) {
            Call::Places(places.into_iter().map(one).collect())
        } else {
            Call::Other
        }
    }
}

/// Whether a token is a letter that names something.
pub(super) fn is_letter(token: &Token) -> bool {
    match token.kind {
        Kind::Other => token.text.chars().all(char::is_alphabetic),
        Kind::Command => is_letter_command(&token.text),
        _ => false,
    }
}

/// The key of a name, however it is spelled: `\boldsymbol r` and `\mathbf{r}` are one, as `q_\alpha` and `q_{\alpha}` are.
fn canonical(text: &str) -> String {
    match names_of(&super::token::tokens(text)).as_slice() {
        [one] if one.dots == 0 && one.primes == 0 && one.call == Call::None && !one.is_difference => one.key(),
        _ => text.to_owned(),
    }
}

/// A key with dots above it: `\dot q_{\alpha}`, `\dot{\mathbf{r}}`.
fn with_dots(dots: &str, key: &str) -> String {
    let Some(command) = key.strip_prefix('\\') else { return format!("\\{dots} {key}") };
    let end = command.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(command.len());
    if is_letter_command(&command[..end]) { format!("\\{dots}{key}") } else { format!("\\{dots}{{{key}}}") }
}

/// A name that is nothing but this key, perhaps with dots.
fn plain(key: &str) -> PaperName {
    let dotted = DOTS.iter().rev().find_map(|(d, n)| {
        let rest = key.strip_prefix('\\')?.strip_prefix(d)?;
        (!rest.starts_with(|c: char| c.is_ascii_alphabetic())).then_some((rest, *n))
    });
    let (key, dots) = dotted.map_or((key, 0), |(rest, n)| {
        let rest = rest.trim();
        (rest.strip_prefix('{').and_then(|r| r.strip_suffix('}')).unwrap_or(rest).trim(), n)
    });
    let (base, subscript) = match key.split_once('_') {
        Some((base, sub)) => {
            let inside = sub.strip_prefix('{').and_then(|s| s.strip_suffix('}')).unwrap_or(sub);
            (base, Some(inside.to_owned()))
        }
        None => (key, None),
    };
    PaperName {
        base: base.trim().to_owned(),
        letter: base.trim().to_owned(),
        is_bold: BOLD.iter().any(|b| base.contains(&format!("\\{b}"))),
        has_hat: false,
        subscript,
        dots,
        primes: 0,
        call: Call::None,
        derived_by: None,
        is_partial: false,
        is_difference: false,
        above: None,
        is_in_group: false,
        is_variable: false,
    }
}
