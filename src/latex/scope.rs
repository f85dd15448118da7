//! Which symbols there are, and what a written symbol refers to.

mod canonical;
mod declare;
mod entry;
mod field;
mod table;

pub use declare::REFUSED;
pub use entry::Role;
use entry::{Arguments, Entry, Pattern};
use table::{Any, Kind, Table, base};

use super::name;
use super::syntax::{SubItem, indices};
use diag::Problem;
use expr::{Expr, Graph, Leaf, MOST_COORDINATES, Shape, Symbol, Tensor};

/// How a symbol is declared.
#[derive(Clone, Debug)]
pub struct Declaration<'a> {
    /// What it is.
    pub role: Role,
    /// Its shape; without one, that of its formula, or a scalar.
    pub shape: Option<Shape>,
    /// Only the diagonal of a square matrix is stored.
    pub diagonal: bool,
    /// Its formula; of a coordinate, its scale factor: how long a step of it is, per its change.
    pub formula: Option<&'a str>,
    /// Names of the arguments, for a function.
    pub arguments: &'a [&'a str],
    /// Its values are complex numbers.
    pub complex: bool,
    /// Its values are continued along a motion, through any number of turns.
    pub angle: bool,
    /// A subscript at it is a label: a number `r_1` may stand beside a vector `{\bf r}`, and is none of its components.
    pub labelled: bool,
}

impl Declaration<'_> {
    /// A real number of a role, without a formula.
    pub const fn of(role: Role) -> Declaration<'static> {
        Declaration {
            role,
            shape: None,
            diagonal: false,
            formula: None,
            arguments: &[],
            complex: false,
            angle: false,
            labelled: false,
        }
    }
}

/// Why a declaration is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum DeclareError {
    /// The name; the span is one in the key.
    Key(Problem),
    /// The formula; spans are in the formula.
    Formula(Vec<Problem>),
}

/// Whether a name is made of these pieces.
fn is_made_of(name: &str, pieces: &[&str]) -> bool {
    let rest = pieces.iter().try_fold(name, |rest, piece| rest.strip_prefix(piece));
    rest.is_some_and(str::is_empty)
}

/// The declared symbols. Later declarations hide earlier ones of the same name, so a claim may have symbols of its own.
#[derive(Clone, Debug)]
pub struct Scope {
    entries: Table,
    sign: Leaf,
    /// Pairs of canonical variables: a coordinate, and its momentum.
    pairs: Vec<(Symbol, Symbol)>,
    /// The field with which `\frac{D}{Dt}` moves.
    velocity: Option<Symbol>,
    /// Which sign the time has in `\Box`.
    signature: Option<Signature>,
    /// What `\log` is.
    logarithm: Option<Logarithm>,
    /// Whether `i` is the imaginary unit by a convention of the file.
    imaginary: bool,
    /// Whether a prime on what moves is its rate by a convention of the file.
    primes: bool,
    /// Whether upright letters are units where they are declared.
    units: bool,
}

/// The code of the refusal of `\log` where nobody says which logarithm it is.
pub const NO_BASE: &str = "latex::base-of-logarithm";

/// What `\log` stands for, by a convention of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Logarithm {
    /// The natural one.
    Natural,
    /// That of base 10.
    Decimal,
}

impl Logarithm {
    /// All, each with its name and with what it is.
    pub const ALL: [(&'static str, &'static str, Logarithm); 2] = [
        ("natural", "The natural one, `\\ln`", Logarithm::Natural),
        ("decimal", "That of base 10", Logarithm::Decimal),
    ];

    /// The one of a name.
    pub fn named(name: &str) -> Option<Logarithm> {
        Logarithm::ALL.iter().find(|(of, ..)| *of == name).map(|(.., which)| *which)
    }
}

/// The signs of a metric: which of time and space counts positive, by a convention of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signature {
    /// `+---`: □ = ∂ₜ²/c² − ∇².
    Time,
    /// `-+++`: □ = ∇² − ∂ₜ²/c².
    Space,
}

/// What a written symbol refers to.
pub(super) struct Found<'s> {
    pub symbol: Symbol,
    pub role: Role,
    pub definition: Option<&'s Tensor>,
    /// Formal arguments, for a function.
    pub formal: &'s [(Symbol, Shape)],
    /// What is left of the subscript: indices of components.
    pub indices: Vec<SubItem>,
    /// How many of the indices stand in places between signs, as in `I_{(n-k)}`.
    pub places: usize,
    /// Whether the parentheses behind it belong to its name.
    pub literal_arguments: bool,
    /// Its coordinates, for a field.
    pub coordinates: &'s [Leaf],
    /// Where it is taken, for a function of what is no coordinate; else empty.
    pub place: &'s [Expr],
    /// The same as written.
    places_text: &'s str,
    /// Coordinates in the subscript of a scalar field: by these it is derived, as in `u_{xx}`.
    pub derivatives: Vec<Leaf>,
    /// Written with a bar: the complex conjugate of what is declared.
    pub conjugate: bool,
}

fn bad_key(message: impl Into<String>, key: &str, hint: &str) -> DeclareError {
    DeclareError::Key(Problem {
        code: "latex::bad-name",
        message: message.into(),
        span: 0..key.len(),
        hint: (!hint.is_empty()).then(|| hint.to_owned()),
    })
}

fn too_many(key: &str) -> DeclareError {
    bad_key(format!("more than {MOST_COORDINATES} coordinates"), key, "fields of fewer coordinates")
}

impl Scope {
    /// A scope without symbols; it knows the sign that ± stands for.
    pub fn new(graph: &mut Graph) -> Scope {
        let symbol = graph.declare(r"\pm", Shape::scalar(), false);
        graph.set_always_has_value(symbol);
        Scope {
            entries: Table::default(),
            pairs: Vec::new(),
            velocity: None,
            signature: None,
            logarithm: None,
            imaginary: false,
            primes: false,
            units: false,
            sign: Leaf::now(symbol, 0),
        }
    }

    /// Says what `\log` stands for.
    pub fn set_logarithm(&mut self, logarithm: Logarithm) {
        self.logarithm = Some(logarithm);
    }

    /// Says that `i`, where it is not declared, is the imaginary unit.
    pub fn set_imaginary(&mut self) {
        self.imaginary = true;
    }

    /// Says that a prime on what moves, where the primed name is not declared, is the derivative by the time, however that is called.
    pub fn set_primes(&mut self) {
        self.primes = true;
    }

    pub(super) fn primes(&self) -> bool {
        self.primes
    }

    /// Says that declared names in upright type are units: `\mathrm{m/s^2}` is then a quotient of them.
    pub fn set_units(&mut self) {
        self.units = true;
    }

    /// Whether units may stand in formulas.
    pub fn has_units(&self) -> bool {
        self.units
    }

    /// Whether `i` is the imaginary unit: something is complex, or the file says so.
    pub(super) fn speaks_of_complex_numbers(&self) -> bool {
        self.imaginary || self.entries.any(Any::Complex)
    }

    /// Says which sign the time has in `\Box`.
    pub fn set_signature(&mut self, signature: Signature) {
        self.signature = Some(signature);
    }

    pub(super) fn signature(&self) -> Option<Signature> {
        self.signature
    }

    pub(super) fn logarithm(&self) -> Option<Logarithm> {
        self.logarithm
    }

    /// Whether a name with a label above is declared.
    pub(super) fn has_labels(&self) -> bool {
        self.entries.any(Any::Labelled)
    }

    /// Whether a name with a prime is declared.
    pub(super) fn has_primes(&self) -> bool {
        self.entries.any(Any::Primed)
    }

    /// Whether names of several letters are declared.
    pub(super) fn has_words(&self) -> bool {
        self.entries.has_words()
    }

    /// The longest declared name of several letters with which these letters begin.
    pub(super) fn word(&self, letters: &str) -> Option<&str> {
        self.entries.word(letters)
    }

    fn depends_on_time(&self, graph: &Graph, t: &Tensor) -> bool {
        graph.leaves_within(t.components.iter().copied()).iter().any(|l| {
            l.instant.is_none() && matches!(self.role(l.symbol), Some(Role::Time | Role::State | Role::Observable))
        })
    }

    fn by_symbol(&self, symbol: Symbol) -> Option<&Entry> {
        self.entries.of(symbol)
    }

    /// Whether the values of a symbol are continued along a motion, through any number of turns.
    pub fn is_angle(&self, symbol: Symbol) -> bool {
        self.by_symbol(symbol).is_some_and(|e| e.angle)
    }

    /// What a symbol is.
    pub fn role(&self, symbol: Symbol) -> Option<Role> {
        self.by_symbol(symbol).map(|e| e.role)
    }

    /// Whether it is something that motions have values of: a state or an observable.
    pub fn moves(&self, leaf: &Leaf) -> bool {
        matches!(self.role(leaf.symbol), Some(Role::State | Role::Observable))
    }

    /// Whether the names are those of another scope: neither has any of its own.
    pub fn has_names_of(&self, other: &Scope) -> bool {
        self.entries.is(&other.entries)
    }

    /// The meaning of the formula that a symbol was declared with.
    pub fn definition(&self, symbol: Symbol) -> Option<&Tensor> {
        self.by_symbol(symbol).and_then(|e| e.definition.as_ref())
    }

    /// The time.
    pub fn time(&self) -> Option<Leaf> {
        self.entries.time().map(|entry| Leaf::now(entry.symbol, 0))
    }

    pub(super) fn time_name(&self) -> Option<&str> {
        self.entries.time().map(|e| e.name.as_str())
    }

    /// The leaf that stands for ±: its value is +1 or −1.
    pub fn branch_sign(&self) -> Leaf {
        self.sign
    }

    /// All keys, in order of declaration.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.entries.all().map(|e| e.key.as_str())
    }

    /// Whether the declaration of a name was refused, with this subscript or the beginning of it.
    pub(super) fn is_refused(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        self.entries.is_refused(name, sub.unwrap_or_default())
    }

    /// Whether a name is declared in any form.
    pub(super) fn declares(&self, name: &str) -> bool {
        self.entries.has(|e| e.name == name, name)
    }

    /// Whether parentheses with this content behind this symbol are arguments.
    pub(super) fn applies(&self, name: &str, sub: Option<&[SubItem]>, text: &str) -> bool {
        let found = self.find(name, sub, Some(text));
        // As many parts as a field has coordinates are a place; anything else is a factor.
        let place = |f: &Found| f.role == Role::Field && parts(text) == parts(f.places_text);
        found.is_some_and(|f| f.literal_arguments || !f.formal.is_empty() || place(&f))
    }

    /// Whether a letter is the time, a coordinate, or something that depends on them: then it is no index.
    pub(super) fn is_time_or_moving(&self, letter: &str) -> bool {
        let named = self.entries.like(letter, &[]).rev().find(|e| e.name == letter);
        named.is_some_and(|e| {
            matches!(e.role, Role::Time | Role::State | Role::Observable | Role::Coordinate | Role::Field)
        })
    }

    /// Whether a symbol, as it is written, is a field.
    pub(super) fn is_field(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        self.find(name, sub, None).is_some_and(|f| f.role == Role::Field)
    }

    /// Whether a symbol, as it is written, is a field at another place.
    pub(super) fn is_elsewhere(&self, name: &str, sub: Option<&[SubItem]>, text: &str) -> bool {
        self.find(name, sub, Some(text)).is_some_and(|f| f.role == Role::Field && !f.literal_arguments)
    }

    /// Whether a symbol, as it is written, is a matrix.
    pub(super) fn is_matrix(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        let found = self.find(name, sub, None).filter(|f| f.indices.is_empty());
        found.and_then(|f| self.by_symbol(f.symbol)).is_some_and(|e| e.rank == 2)
    }

    /// Whether a symbol is the time, a state or an observable, not merely a name for a formula.
    pub(super) fn is_variable(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        let role = self.find(name, sub, None).map(|f| f.role);
        matches!(role, Some(Role::Time | Role::State | Role::Observable))
    }

    /// Whether no symbol depends on time.
    pub(super) fn is_timeless(&self) -> bool {
        !self.entries.any(Any::Moving)
    }

    /// Whether a symbol depends on time.
    pub(super) fn is_moving(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        let found = self.find(name, sub, None);
        found.and_then(|f| self.by_symbol(f.symbol)).is_some_and(|e| e.moving && e.role != Role::Time)
    }

    /// Whether a symbol, as it is written, is a parameter.
    pub(super) fn is_constant(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        self.find(name, sub, None).is_some_and(|f| f.role == Role::Parameter)
    }

    /// Whether a symbol, as it is written, is a real number, not a vector or a matrix.
    pub(super) fn is_number(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        let found = self.find(name, sub, None).filter(|f| f.indices.is_empty());
        found.and_then(|f| self.by_symbol(f.symbol)).is_some_and(|e| e.rank == 0 && !e.complex)
    }

    /// Whether a symbol, as it is written, is a vector.
    pub(super) fn is_vector(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        let found = self.find(name, sub, None).filter(|f| f.indices.is_empty());
        found.and_then(|f| self.by_symbol(f.symbol)).is_some_and(|e| e.rank == 1)
    }

    /// Whether something is declared that this could be.
    pub(super) fn is_known(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        self.find(name, sub, None).is_some()
    }

    /// Whether any symbol has this name, in any style and with any primes.
    pub(super) fn has_base(&self, name: &str) -> bool {
        self.entries.has(|e| base(&e.name) == base(name), name)
    }

    /// Whether any symbol of this name, in any style, depends on time; and whether any is a vector or a matrix. With
    /// `lowered`, only symbols that can have a subscript count, and their components are numbers.
    pub(super) fn kinds_of(&self, base: &str, lowered: bool) -> (bool, bool) {
        let is_any = |what| self.entries.is_any(base, what);
        if lowered { (is_any(Kind::MovesBelow), false) } else { (is_any(Kind::Moves), is_any(Kind::Tensor)) }
    }

    /// What a written symbol refers to.
    pub(super) fn find(&self, name: &str, sub: Option<&[SubItem]>, arguments: Option<&str>) -> Option<Found<'_>> {
        let (style, bare) = name::split(name);
        self.find_exact(&[name], sub, arguments).or_else(|| match style {
            // `\boldsymbol\Omega` for a declared vector `\Omega`.
            Some(style) if name::marks_tensor(style) => {
                self.find_exact(&[bare], sub, arguments).filter(|f| self.is_tensor(f.symbol))
            }
            // `\bar z` for the conjugate of a complex `z`; with two bars it is `z`.
            Some("bar") => {
                let found = self.find(bare, sub, arguments)?;
                let complex = self.by_symbol(found.symbol).is_some_and(|e| e.complex);
                complex.then_some(Found { conjugate: !found.conjugate, ..found })
            }
            Some(_) => None,
            // `m_3` for a component of a declared `{\bf m}`.
            None => {
                let sub = sub?;
                let styled = [["bf:", bare], ["vec:", bare]];
                let mut found = styled.iter().filter_map(|n| self.find_exact(n, Some(sub), arguments));
                found.next().filter(|f| !f.indices.is_empty() && self.is_tensor(f.symbol))
            }
        })
    }

    /// The key of something with components of which a name with a subscript could be one, or another of several: `r_1` where `{\bf r}` and
    /// `{\bf r}_1` are declared.
    pub(super) fn numbered(&self, name: &str, sub: &[SubItem], found: Option<&Found>) -> Option<&str> {
        let meant = match found {
            Some(found) => self.by_symbol(found.symbol).filter(|_| !found.indices.is_empty()),
            None => {
                let is_like =
                    |e: &&Entry| name::unmarked(&e.name) == name::unmarked(name) && indices(sub).len() == e.rank;
                self.entries.like(name, &[]).filter(is_like).find(|e| self.entries.is_numbered(e.symbol))
            }
        };
        meant.filter(|e| self.entries.is_numbered(e.symbol)).map(|e| e.key.as_str())
    }

    fn is_tensor(&self, symbol: Symbol) -> bool {
        self.by_symbol(symbol).is_some_and(|e| e.rank > 0)
    }

    /// What is declared under a name that is given in pieces.
    fn find_exact(&self, name: &[&str], sub: Option<&[SubItem]>, arguments: Option<&str>) -> Option<Found<'_>> {
        let sub = sub.unwrap_or(&[]);
        let fits = |e: &Entry| -> Option<Vec<SubItem>> {
            if e.sub.is_empty() {
                return Some(sub.to_vec());
            }
            // `L_{i,j}` of an `L_{ij}` with a formula in its indices.
            let own = e.sub.iter().all(|p| *p == Pattern::Index).then(|| indices(sub));
            let sub = own.as_deref().unwrap_or(sub);
            // A label, or a pattern with index places, fits the beginning; further indices may follow.
            if sub.len() < e.sub.len() {
                return None;
            }
            let mut indices = Vec::new();
            for (p, item) in e.sub.iter().zip(sub) {
                match p {
                    Pattern::Literal(l) if l == item => {}
                    Pattern::Literal(_) => return None,
                    Pattern::Index if matches!(item, SubItem::Other(_)) => return None,
                    Pattern::Index => indices.push(item.clone()),
                }
            }
            indices.extend(sub[e.sub.len()..].iter().cloned());
            Some(indices)
        };
        let mut best: Option<((usize, u32), &Entry, Vec<SubItem>)> = None;
        let whole = name.last().copied().unwrap_or_default();
        for (place, e) in self.entries.beginnings(whole, sub).filter(|(_, e)| is_made_of(&e.name, name)) {
            let literal = match (&e.arguments, arguments) {
                (Arguments::None, _) => false,
                (Arguments::Literal(text), Some(given)) if text == given => true,
                (Arguments::Formal(_), Some(_)) => true,
                (Arguments::Coordinates(..), None) => false,
                (Arguments::Coordinates(text, _), Some(given)) => text == given,
                _ => continue,
            };
            let Some(indices) = fits(e) else { continue };
            // The more of the written symbol belongs to the name, the better; among equals the latest.
            let weight = (2 * e.sub.len() + usize::from(literal), place);
            if best.as_ref().is_none_or(|(w, ..)| weight > *w) {
                best = Some((weight, e, indices));
            }
        }
        let (_, entry, behind) = best?;
        let indices = indices(&behind);
        let derivatives = self.derivatives(entry, &indices);
        let indices = if derivatives.is_some() { Vec::new() } else { indices };
        let formal: &[(Symbol, Shape)] = match &entry.arguments {
            Arguments::Formal(f) => f,
            _ => &[],
        };
        Some(Found {
            symbol: entry.symbol,
            role: entry.role,
            definition: entry.definition.as_ref(),
            formal,
            indices,
            places: if entry.sub.iter().any(|p| matches!(p, Pattern::Literal(_))) {
                entry.sub.iter().filter(|p| **p == Pattern::Index).count()
            } else {
                0
            },
            literal_arguments: match &entry.arguments {
                Arguments::Literal(_) => true,
                Arguments::Coordinates(text, _) => arguments == Some(text),
                Arguments::None | Arguments::Formal(_) => false,
            },
            coordinates: match &entry.arguments {
                Arguments::Coordinates(_, coordinates) => coordinates,
                Arguments::None | Arguments::Literal(_) | Arguments::Formal(_) => &[],
            },
            place: &entry.place,
            places_text: match &entry.arguments {
                Arguments::Coordinates(text, _) => text,
                Arguments::None | Arguments::Literal(_) | Arguments::Formal(_) => "",
            },
            conjugate: false,
            derivatives: derivatives.unwrap_or_default(),
        })
    }

    /// The declared key that is most like a name, for hints.
    pub(super) fn nearest(&self, name: &str) -> Option<&str> {
        let spelled = name::to_latex(name);
        let distance = |key: &str| edit_distance(&spelled, key);
        let alike = |key: &str| name::split(name).1.eq_ignore_ascii_case(name::split(key).1);
        // A text that is longer by more takes more edits.
        let near = self.keys().filter(|key| key.len().abs_diff(spelled.len()) <= 8 || alike(key));
        let best = near.min_by_key(|key| distance(key))?;
        (distance(best) <= 2 || alike(best)).then_some(best)
    }
}

/// Number of parts that commas outside of brackets separate.
fn parts(text: &str) -> usize {
    let (mut depth, mut count) = (0i32, 1);
    for c in text.chars() {
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        count += usize::from(c == ',' && depth == 0);
    }
    count
}

/// Number of single-character edits between two texts.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().enumerate() {
        let mut previous = row[0];
        row[0] = i + 1;
        for (j, &cb) in b.iter().enumerate() {
            let substituted = previous + usize::from(ca != cb);
            previous = row[j + 1];
            row[j + 1] = substituted.min(previous + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
