//! Guesses: what a name of a paper may be, as a line of `[symbols]`.
//!
//! **In:** a role, a shape, why. **Out:** the line. **Guaranteed:** every guess is marked `confirm`, and says why.

use super::spelling::quoted;

/// A guessed symbol.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Guess {
    /// The name as a key of `[symbols]`, with its places: `u(x,t)`.
    pub name: String,
    /// Its role.
    pub role: &'static str,
    /// Its shape, unless it is a number.
    pub shape: Option<String>,
    /// Whether its values are complex.
    pub is_complex: bool,
    /// Whether what stands below it is a label, where a component would be called so.
    pub is_labelled: bool,
    /// What the paper shows of it.
    pub why: &'static str,
}

impl Guess {
    /// A number that does not change.
    pub fn parameter(name: impl Into<String>, why: &'static str) -> Guess {
        Guess { name: name.into(), role: "parameter", shape: None, is_complex: false, is_labelled: false, why }
    }

    /// The name as a key of the file.
    pub fn key(&self) -> String {
        if self.name.contains('\'') { quoted(&self.name) } else { format!("'{}'", self.name) }
    }

    /// The name without its places.
    pub fn bare(&self) -> &str {
        match self.role {
            "field" => self.name.split_once('(').map_or(self.name.as_str(), |(bare, _)| bare),
            _ => &self.name,
        }
    }

    /// What a field depends on: names, without dots.
    pub fn places(&self) -> Vec<&str> {
        let inside = self.name.split_once('(').and_then(|(_, rest)| rest.strip_suffix(')')).unwrap_or_default();
        inside.split(',').map(super::spelling::bare).collect()
    }

    /// Whether the role can be declared for the whole file only.
    pub fn is_of_the_file(&self) -> bool {
        matches!(self.role, "time" | "state" | "coordinate")
    }

    /// Whether it would change what another formula means that does not name it: `e` is Euler's number elsewhere, `d` a differential.
    pub fn is_of_its_formula(&self) -> bool {
        // Beside `\Delta_r`, `\Delta x` could be a product; beside `e_1`, `e^{kz}` could be anything.
        let letter = self.name.split(['_', '^', '(']).next().unwrap_or_default();
        self.bare() == "t"
            || matches!(letter, r"\delta" | r"\Delta" | "e")
            || matches!(
                self.name.as_str(),
                "d" | "i" | "D" | r"\delta" | r"\Delta" | r"\epsilon" | r"\varepsilon" | r"\pi"
            )
    }

    /// The line that declares it.
    pub fn line(&self) -> String {
        let shape = self.shape.as_ref().map(|s| format!(", shape = {}", quoted(s))).unwrap_or_default();
        let complex = if self.is_complex { ", complex = true" } else { "" };
        let labelled = if self.is_labelled { ", labelled = true" } else { "" };
        format!("{} = {{ role = {}{shape}{complex}{labelled} }} # confirm: {}", self.key(), quoted(self.role), self.why)
    }
}

/// Where a formula stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place {
    /// The number of its section.
    pub section: usize,
    /// The number of its chapter.
    pub chapter: usize,
}

/// The symbols with which a formula is tried, and how two letters are read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Reading {
    /// Its symbols, in the order in which they are declared.
    pub symbols: Vec<Guess>,
    /// Whether `i` is the imaginary unit.
    pub is_complex: bool,
    /// Whether `\log` is the natural logarithm.
    pub has_logarithm: bool,
}

impl Reading {
    /// Whether all coordinates of space are among its symbols.
    pub(super) fn has_space(&self) -> bool {
        SPACE.iter().all(|c| self.symbols.iter().any(|g| g.role == "coordinate" && g.name == *c))
    }
}

/// The coordinates of space.
pub(super) const SPACE: [&str; 3] = ["x", "y", "z"];
