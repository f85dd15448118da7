//! The names of a formula → what they are declared as.
//!
//! **In:** the names of a formula, the evidence of the paper, and how both are taken. **Out:** a [`Reading`]. **Guaranteed:** what could be an
//! operator, a matrix or a function of anything is not declared as a number.

use std::collections::{BTreeMap, BTreeSet};

use super::super::names::{Call, Evidence, PaperName, Primes, Subscripts, squeezed, unprimed};
use super::guess::{Guess, Place, Reading, SPACE};
use super::spelling::{bare, is_vector};

/// How shapes and motions are taken, where the paper leaves a choice.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Way {
    /// How many components a vector has, where the paper does not show it.
    pub dimension: usize,
    /// Whether capital letters in bold are matrices.
    pub bold_matrices: bool,
    /// Whether a plain letter is a column only where its chapter sets it equal to one.
    pub columns_of_chapter: bool,
    /// Whether all matrices are square and of this dimension, and all vectors have it: a formula for any dimension.
    pub is_uniform: bool,
    /// Whether `I` is a matrix as large as those beside it: the identity, perhaps.
    pub has_identity: bool,
    /// Whether sides that are products of capital letters are products of square matrices: another side is a matrix.
    pub products_are_of_matrices: bool,
    /// Whether plain letters are numbers, whatever they are in sections with matrices.
    pub without_matrices: bool,
    /// Whether what stands between a function and the time, and has no rate in the formula, is a number: `\cos\omega t`.
    pub steady_before_time: bool,
}

/// The letter of the identity matrix.
pub(super) const IDENTITY: &str = "I";

/// Why something is a state.
const MOVES: &str = "the paper prints its rate, or its value at a time";

/// The names of a formula, and how they are taken.
#[derive(Clone, Copy)]
pub(super) struct Names<'a> {
    pub all: &'a [PaperName],
    pub evidence: &'a Evidence,
    pub text: &'a str,
    /// Where the formula stands.
    pub place: Place,
    /// How shapes and motions are taken.
    pub way: Way,
    /// Whether what moves elsewhere is a coordinate, where something is derived by it partially.
    pub moving_are_coordinates: bool,
    /// Whether subscripts are indices of components, where they can be.
    pub with_indices: bool,
    /// Whether what a function is applied to is a number, where nothing is derived by it, and no coordinate.
    pub places_are_numbers: bool,
    /// Whether what moves is a function of the time, and no state.
    pub moving_are_functions: bool,
    /// Whether coordinates are numbers, at which functions are taken and by which they are derived: a file has few coordinates.
    pub coordinates_are_numbers: bool,
    /// Whether what has no rate here is a number, where nothing is derived by the time: there it makes no difference.
    pub only_rates_move: bool,
    /// Whether `e` is raised to numbers alone in the whole paper.
    pub has_charge: bool,
    /// Names of sides that are products of capital letters, and of nothing else.
    pub products: &'a BTreeSet<String>,
}

impl Names<'_> {
    /// What the names are declared as.
    pub fn reading(&self) -> Result<Reading, String> {
        let is_usual = |n: &PaperName| {
            n.primes > 0 && matches!(self.evidence.primes_in(&unprimed(n), self.place.section), Primes::Usual(_))
        };
        let is_shown = |n: &PaperName| {
            n.primes > 0 && matches!(self.evidence.primes_in(&unprimed(n), self.place.section), Primes::Derive(_))
        };
        if self.all.iter().any(is_usual)
            && !self.all.iter().any(is_shown)
            && self.prime_variable().is_some_and(|v| v != "t" && self.stands_alone(&v) && !self.is_only_variable(&v))
        {
            return Err("a prime: a derivative, by something that the paper does not show".to_owned());
        }
        let functions = self.functions();
        let coordinates = self.coordinates(&functions);
        let mut out: Vec<Guess> = coordinates
            .iter()
            .filter(|c| *c != "t")
            .map(|c| Guess {
                role: "coordinate",
                shape: is_vector(c).then(|| self.way.dimension.to_string()),
                ..Guess::parameter(c.as_str(), "the paper derives by it, or applies a function to it")
            })
            .collect();
        let is_complex = self.evidence.is_complex && self.all.iter().any(|n| n.key() == "i");
        if self.has_charge {
            push(
                &mut out,
                Guess::parameter("e", "raised to numbers alone in the whole paper: a charge, and not Euler's number"),
            );
        }
        let mut at = 0;
        while let Some(name) = self.all.get(at) {
            at += 1;
            let next = self.all.get(at);
            if name.is_difference {
                if let Some(difference) = self.difference(name, next, &functions)? {
                    at += 1;
                    push(&mut out, difference);
                }
                continue;
            }
            if self.is_known(name, &coordinates, is_complex) {
                continue;
            }
            push(&mut out, self.guess(name, &functions, &coordinates, is_complex)?);
        }
        // What a function is applied to is declared, too, whether it stands in the formula or not.
        for place in functions.values().flatten() {
            let bare = bare(place);
            let known = bare == "t" || coordinates.contains(bare) || out.iter().any(|g| g.bare() == bare);
            if !known {
                let steady = self.places_are_numbers && self.is_of_primes(bare)
                    || self.coordinates_are_numbers && self.is_a_variable_here(bare);
                let moves = self.evidence.moving.contains(bare) && !steady || bare != place;
                let (role, why) = if moves { ("state", MOVES) } else { ("parameter", "a function is applied to it") };
                let shape = is_vector(bare).then(|| self.way.dimension.to_string());
                push(&mut out, Guess { role, shape, ..Guess::parameter(bare, why) });
            }
        }
        if self.moving_are_functions {
            for guess in out.iter_mut().filter(|g| g.role == "state") {
                guess.name.push_str("(t)");
                guess.role = "field";
            }
        }
        // Fields stand behind their coordinates, components behind their vectors.
        let of_time = |g: &Guess| g.name.ends_with("(t)");
        out.sort_by_key(|g| {
            (g.role == "field" && !of_time(g), g.role == "field", g.role != "coordinate", g.shape.is_none())
        });
        let has_logarithm = !self.evidence.has_other_logarithm && self.text.contains(r"\log");
        Ok(Reading { symbols: out, is_complex, has_logarithm })
    }

    /// Whether a name needs no declaration.
    fn is_known(&self, name: &PaperName, coordinates: &BTreeSet<String>, is_complex: bool) -> bool {
        let key = name.key();
        key == "t" && !self.is_prime_of(name)
            || coordinates.contains(&key)
            || key == r"\pi"
            || name.letter == "e" && name.base == r"\mathrm{e}"
            || key == "i" && is_complex
            || self.is_component(name)
    }

    /// Whether the primes of a name derive it.
    pub fn is_prime_of(&self, name: &PaperName) -> bool {
        name.primes > 0 && self.evidence.primed_by(&unprimed(name)).is_some()
    }

    /// The key under which a name is declared: primes that derive are none of it, nor is an order of differentiation above.
    pub fn key(&self, name: &PaperName) -> String {
        let bare = PaperName { above: None, ..name.clone() };
        let order = name.above.as_deref().is_some_and(|a| a.starts_with('('));
        let name = if order && self.evidence.primed_by(&unprimed(&bare)).is_some() { &bare } else { name };
        if self.is_prime_of(name) { unprimed(name) } else { name.key() }
    }

    /// `\Delta x`: one name, unless it is the Laplacian of a field.
    fn difference(
        &self,
        name: &PaperName,
        next: Option<&PaperName>,
        functions: &BTreeMap<String, Vec<String>>,
    ) -> Result<Option<Guess>, String> {
        if name.letter == "d" {
            return Ok(None);
        }
        let Some(next) = next.filter(|n| !functions.contains_key(&self.key(n)) && !n.is_difference) else {
            return Ok(None);
        };
        if next.call != Call::None || next.dots > 0 {
            return Err(format!("a difference, {}", name.letter));
        }
        Ok(Some(Guess {
            shape: self.shape(next),
            ..Guess::parameter(format!("{} {}", name.letter, next.key()), "a difference of its own")
        }))
    }

    fn guess(
        &self,
        name: &PaperName,
        functions: &BTreeMap<String, Vec<String>>,
        coordinates: &BTreeSet<String>,
        is_complex: bool,
    ) -> Result<Guess, String> {
        let key = self.key(name);
        let shape = self.shape(name);
        let complex = is_complex && self.is_complex(name);
        let is_labelled = shape.is_some() && name.subscript.is_none() && self.is_labelled(name);
        if let Some(places) = functions.get(&key) {
            let shown: Vec<&str> = places.iter().map(String::as_str).collect();
            let why = match places.iter().all(|p| coordinates.contains(p)) {
                true => "a function of its coordinates",
                false => "a function of what moves, or of numbers",
            };
            return Ok(Guess {
                name: format!("{key}({})", shown.join(",")),
                role: "field",
                shape,
                is_complex: complex,
                is_labelled,
                why,
            });
        }
        if name.call == Call::Other && self.is_shifted_place(name, &key) {
            return Err(format!("a function of what follows, or a product, {key}"));
        }
        let moves_alone = self.has_rate_here(&key) && !self.evidence.partial.contains_key(&key);
        if self.text.contains(r"\nabla") && !moves_alone && self.is_field_of_space(name, &key) {
            let space = match coordinates.iter().find(|c| is_vector(c)) {
                Some(place) => place.clone(),
                None => SPACE.join(","),
            };
            let time = if self.evidence.partial.get(&key).is_some_and(|by| by.contains("t")) { ",t" } else { "" };
            return Ok(Guess {
                name: format!("{key}({}{time})", space),
                role: "field",
                shape,
                is_complex: complex,
                is_labelled,
                why: "the paper applies ∇",
            });
        }
        if self.with_indices && self.evidence.has_indices(&name.letter) && !name.is_bold {
            let two = self.evidence.subscripts.get(&name.letter).is_some_and(Subscripts::have_pair);
            let shape = Some(if two { "3x3" } else { "3" }.to_owned());
            let moves = self.moves(name, &name.base);
            let (role, why) = if moves {
                ("state", "its subscripts are indices, and it has a rate")
            } else {
                ("parameter", "its subscripts are indices")
            };
            return Ok(Guess { name: name.base.clone(), role, shape, is_complex: false, is_labelled: false, why });
        }
        let (role, why) = match self.moves(name, &key) {
            true => ("state", MOVES),
            false if self.way.has_identity && key == IDENTITY => {
                ("parameter", "beside matrices of this size: any matrix here, the identity perhaps")
            }
            false
                if matches!(name.letter.as_str(), r"\delta" | r"\epsilon" | r"\varepsilon")
                    && name.subscript.is_some() =>
            {
                ("parameter", "a name with a label; of Kronecker's δ, or of ε with indices, the values are not used")
            }
            false if name.subscript.is_some() => ("parameter", "a name with a label"),
            false => ("parameter", "the paper prints no rate of it"),
        };
        Ok(Guess { name: key, role, shape, is_complex: complex, is_labelled, why })
    }

    /// Whether what stands in parentheses behind a name begins with a place that the paper prints behind it: `\rho(z+h)`, beside `\rho(z)`.
    fn is_shifted_place(&self, name: &PaperName, key: &str) -> bool {
        let at = self.all.iter().position(|n| std::ptr::eq(n, name));
        let inside = at.and_then(|at| self.all.get(at + 1)).filter(|n| n.dots == 0 && n.primes == 0);
        inside.is_some_and(|inside| self.evidence.is_called_at(key, &inside.key()))
    }

    /// Whether the paper prints names that could be components of this vector or matrix, and this formula has none.
    fn is_labelled(&self, name: &PaperName) -> bool {
        self.evidence.subscripts.get(&name.letter).is_some_and(Subscripts::have_named)
            && !self.all.iter().any(|n| self.is_component(n))
    }

    /// Whether a name is a component of a vector of this formula.
    fn is_component(&self, name: &PaperName) -> bool {
        !name.is_bold
            && name.subscript.as_deref().is_some_and(|s| s.len() == 1 && "123ijkl".contains(s))
            && self.all.iter().any(|n| n.is_bold && n.letter == name.letter && n.subscript.is_none())
    }

    /// Whether a name has a rate somewhere, or a value at a time.
    fn moves(&self, name: &PaperName, key: &str) -> bool {
        if self.way.steady_before_time && !self.has_rate_here(key) && self.is_before_time(name) {
            return false;
        }
        if self.only_rates_move && !self.has_rate_here(key) {
            return false;
        }
        let calls = self.evidence.calls.get(key);
        let printed = calls.is_some_and(|c| {
            c.keys().flatten().any(|p| p == &["t"] || p == &["t_0"] || p == &["0"] && !self.evidence.moving.is_empty())
        });
        let with_index = || {
            let base = format!("{}_", name.base);
            let first = self.evidence.moving.range(base.clone()..).next();
            name.subscript.is_some() && key == name.base && first.is_some_and(|m| m.starts_with(&base))
        };
        self.evidence.moving.contains(key) || self.has_rate_here(key) || printed || with_index()
    }

    /// Whether a name stands between a function and the time.
    fn is_before_time(&self, name: &PaperName) -> bool {
        let text = squeezed(self.text);
        let product = format!("{}t", squeezed(&name.key()));
        text.match_indices(&product).any(|(at, _)| {
            let before = text[..at].trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('^');
            let behind = text[at + product.len()..].chars().next();
            let command = before.rfind('\\').map_or("", |i| &before[i + 1..]);
            latex::is_function(command) && !behind.is_some_and(|c| c.is_alphanumeric() || c == '_')
        })
    }

    /// Whether ∇ acts on a name.
    fn is_field_of_space(&self, name: &PaperName, key: &str) -> bool {
        let derived = self.evidence.partial.contains_key(key);
        let spelled = name.letter.as_str();
        let after = |op: &str| {
            self.text.match_indices(op).any(|(i, _)| {
                let rest = self.text[i + op.len()..].trim_start_matches(['}', ' ', '{', '^', '2', '(']);
                let rest =
                    rest.trim_start_matches(r"\cdot").trim_start_matches(r"\times").trim_start_matches(r"\left(");
                let rest = rest.trim_start_matches([' ', '{']);
                let rest = ["mathbf", "boldsymbol", "vec", "bm", "bf"]
                    .iter()
                    .fold(rest, |r, s| r.strip_prefix('\\').and_then(|t| t.strip_prefix(s)).unwrap_or(r));
                rest.trim_start_matches(['{', ' ']).starts_with(spelled)
            })
        };
        name.is_bold || derived || after(r"\nabla")
    }

    /// Whether the values of a name are complex numbers: it is what a formula with the imaginary unit defines, or the paper conjugates it.
    fn is_complex(&self, name: &PaperName) -> bool {
        let key = self.key(name);
        let starred = format!("{key}^{{*}}");
        matches!(name.letter.as_str(), r"\psi" | r"\Psi")
            || self.evidence.keys.contains_key(&starred)
            || self.first() == Some(key)
    }

    /// The name with which a formula begins, perhaps derived: `\frac{\partial}{\partial x}u=…`.
    fn first(&self) -> Option<String> {
        let name = self.all.first()?;
        let text = squeezed(self.text);
        let is_derived = name.derived_by.is_some()
            && [r"\frac\partial\partial", r"\fracdd"].iter().any(|operator| text.starts_with(operator));
        (is_derived || self.text.trim_start().starts_with(name.base.as_str())).then(|| self.key(name))
    }

    /// The shape of a name: what it is equal to somewhere, or that of its style.
    pub fn shape(&self, name: &PaperName) -> Option<String> {
        let key = name.key();
        let several =
            self.evidence.sizes.get(&key).is_some_and(|s| s.len() > 1 && s.keys().any(|s| s.0 == self.way.dimension));
        let one = (
            self.way.dimension,
            if name.letter.starts_with(|c: char| c.is_ascii_uppercase()) { self.way.dimension } else { 1 },
        );
        let is_column = |key: &str| {
            let column = self.evidence.sizes.get(key).is_some_and(|s| s.keys().all(|(_, columns)| *columns == 1));
            column && !name.is_bold && !self.evidence.local.is_sized(self.place.chapter, key)
        };
        let known = self.evidence.sizes.get(&key).or_else(|| self.evidence.sizes.get(&unprimed(name)));
        let size = match several {
            _ if self.way.without_matrices && !name.is_bold => None,
            _ if self.way.is_uniform && known.is_some_and(|s| s.keys().any(|(rows, _)| *rows > 1)) => {
                let is_vector = name.is_bold && !name.letter.starts_with(|c: char| c.is_ascii_uppercase());
                let is_column = is_vector || known.is_some_and(|s| s.keys().all(|(_, columns)| *columns == 1));
                Some((self.way.dimension, if is_column { 1 } else { self.way.dimension }))
            }
            _ if self.way.columns_of_chapter && (is_column(&key) || is_column(&unprimed(name))) => Some((1, 1)),
            true => Some(one),
            false => self.evidence.size(&key).or_else(|| self.evidence.size(&unprimed(name))),
        };
        match size {
            Some((1, 1)) => None,
            Some((rows, 1)) => Some(rows.to_string()),
            Some((rows, columns)) if rows == columns => Some(format!("{rows}x{columns}")),
            Some(_) => None,
            None if name.is_bold => {
                let capital = name.letter.starts_with(|c: char| c.is_ascii_uppercase());
                let n = self.way.dimension;
                Some(if capital && self.way.bold_matrices { format!("{n}x{n}") } else { n.to_string() })
            }
            None if self.way.has_identity && key == IDENTITY => Some(format!("{n}x{n}", n = self.way.dimension)),
            None if self.way.products_are_of_matrices && self.products.contains(&key) => {
                Some(format!("{n}x{n}", n = self.way.dimension))
            }
            None => None,
        }
    }
}

fn push(out: &mut Vec<Guess>, guess: Guess) {
    if !out.iter().any(|g| g.name == guess.name) {
        out.push(guess);
    }
}
