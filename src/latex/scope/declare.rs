//! Declarations: a symbol under its name as LaTeX writes it, with what it is defined by.
//!
//! **In:** a key and what is said of it. **Out:** the scope with one more symbol, or why not, with its place. **Guaranteed:** a name that
//! could be read in two ways is refused.

use std::sync::Arc;

use super::super::elaborate::Elaborator;
use super::super::parse::{WrittenName, read_name};
use super::super::syntax::{Name, SubItem, indices};
use super::super::{name, tensor};
use super::entry::{labels, like_indices};
use super::{Arguments, Declaration, DeclareError, Entry, Pattern, Role, Scope, bad_key, too_many};
use diag::Problem;
use expr::{Graph, Shape, Symbol, Tensor};

/// What is said of a name whose declaration was refused.
pub const REFUSED: &str = "the declaration of this name was refused";

/// Takes a key apart.
fn read_key(key: &str, scope: &Scope) -> Result<WrittenName, DeclareError> {
    let hint = r"a name is one letter or Greek letter, perhaps styled, primed, with a label: `R`, `\Omega`, `{\bf m}`, `\psi_0`";
    match read_name(key, scope) {
        Ok(Some(name)) => Ok(name),
        Ok(None) => Err(bad_key(format!("`{key}` is not the name of a symbol"), key, hint)),
        Err(problem) => Err(DeclareError::Key(problem)),
    }
}

/// The letters of a name that has several, and nothing else but primes.
fn spelled(name: &str) -> Option<&str> {
    let letters = name.trim_end_matches('\'');
    (letters.len() > 1 && letters.bytes().all(|b| b.is_ascii_alphabetic())).then_some(letters)
}

impl Scope {
    /// Declares a symbol under its name as LaTeX writes it.
    ///
    /// Keys: `R`, `\Omega`, `{\bf m}`, `I'`; with a label, `\psi_0`; with index places, `I_{(n-k)}`, where the letters are
    /// indices of the formula; with declared symbols in parentheses, `\Omega({\bf m})`; with formal arguments, `Z(\alpha)`.
    ///
    /// # Errors
    /// [`DeclareError`], with the place in the key or in the formula.
    pub fn declare(&mut self, graph: &mut Graph, key: &str, d: Declaration<'_>) -> Result<Symbol, DeclareError> {
        let WrittenName { name, sub, arguments } = read_key(key, self)?;
        if spelled(&name).is_some_and(|letters| letters.chars().all(|c| self.declares(&c.to_string()))) {
            let message = format!("`{key}` would also be a product of the declared letters");
            return Err(bad_key(message, key, r"write `\mathrm{…}` around the name"));
        }
        // `z^*` beside a complex `z` would be its conjugate.
        let conjugate = |name: &str, other: &str| {
            name::labelled(name).is_some_and(|(of, label)| of == other && matches!(label, "*" | r"\dagger"))
        };
        let own = [name::labelled(&name).map_or(name.as_str(), |(of, _)| of).to_owned()];
        let starred = ["*", r"\dagger"].map(|label| format!("{name}^{label}"));
        let clash = own
            .iter()
            .chain(&starred)
            .flat_map(|other| self.entries.like(other, &sub))
            .find(|e| conjugate(&name, &e.name) && e.complex || d.complex && conjugate(&e.name, &name));
        if let Some(other) = clash {
            let message = format!("`{key}` and `{}`: one would also be the conjugate of the other", other.key);
            return Err(bad_key(message, key, "rename one of the two"));
        }
        if d.role == Role::Time && self.entries.time().is_some() {
            return Err(bad_key("there is a time already", key, ""));
        }
        let inner = self.inner(graph, d.arguments)?;
        let formal: Vec<(Symbol, Shape)> = inner.iter().map(|e| (e.symbol, Shape::scalar())).collect();
        let mut place = Vec::new();
        let coordinates = match d.role {
            Role::Field => match self.places_of(graph, key, arguments.as_deref())? {
                Some(_) if d.formula.is_some() => {
                    let hint = "declare what has a formula as an abbreviation";
                    return Err(bad_key("a field with a formula depends on coordinates", key, hint));
                }
                Some(at) => {
                    place = at.values;
                    at.coordinates
                }
                None => self.coordinates_of(graph, key, arguments.as_deref())?,
            },
            Role::Coordinate if d.complex || arguments.is_some() => {
                return Err(bad_key("a coordinate is a real number, and nothing else", key, ""));
            }
            _ => Vec::new(),
        };
        let mut pattern: Vec<Pattern> = sub.iter().cloned().map(Pattern::Literal).collect();
        let mut definition = None;
        let declared = d.shape.as_ref().map(|s| if d.complex { s.complexified() } else { s.clone() });
        let scale = match (d.role, d.formula) {
            (Role::Coordinate, Some(text)) => Some(self.scale_factor(graph, &name, (d.shape.as_ref(), text))?),
            _ => None,
        };
        if let Some(text) = d.formula.filter(|_| scale.is_none()) {
            let letters: Vec<Name> =
                sub.iter().filter_map(|i| if let SubItem::Name(n) = i { Some(n.clone()) } else { None }).collect();
            let (tensor, placed) = self.definition_with(graph, &inner, (text, &letters))?;
            if placed {
                for p in &mut pattern {
                    if matches!(p, Pattern::Literal(SubItem::Name(_))) {
                        *p = Pattern::Index;
                    }
                }
                if indices(&sub).iter().all(|item| matches!(item, SubItem::Name(_))) {
                    pattern.retain(|p| *p == Pattern::Index);
                }
            }
            let tensor = match d.complex && !tensor.shape.is_complex() {
                true => tensor::complexified(graph, &tensor),
                false => tensor,
            };
            if tensor.shape.is_complex() && !d.complex {
                let message = "the formula is complex, the symbol is not declared so";
                let (span, hint) = (0..text.len(), Some("declare it with `complex = true`".to_owned()));
                return Err(DeclareError::Formula(vec![Problem {
                    code: "latex::shape",
                    message: message.into(),
                    span,
                    hint,
                }]));
            }
            if let Some(shape) = &declared
                && *shape != tensor.shape
            {
                let message = format!("the formula is a {}, the symbol is declared as a {shape}", tensor.shape);
                let span = 0..text.len();
                return Err(DeclareError::Formula(vec![Problem { code: "latex::shape", message, span, hint: None }]));
            }
            if d.role == Role::Field {
                self.depends_on(graph, &tensor, &coordinates, text)?;
            }
            definition = Some(tensor);
        }
        let shape = definition.as_ref().map(|t| t.shape.clone()).or(declared);
        let shape = shape.unwrap_or_else(|| if d.complex { Shape::scalar().complexified() } else { Shape::scalar() });
        if d.labelled && shape.real_extents().is_empty() {
            return Err(bad_key(
                "a number has no components: what stands below it is a label anyway",
                key,
                "leave `labelled` out",
            ));
        }
        let numbered = self.with_such_components(key, (&name, &pattern), &shape, d.labelled)?;
        let arguments = match (arguments, formal.is_empty()) {
            (Some(text), _) if d.role == Role::Field => Arguments::Coordinates(text, coordinates),
            (None, true) => Arguments::None,
            (Some(_), false) => Arguments::Formal(formal),
            (Some(text), true) => Arguments::Literal(text),
            (None, false) => {
                return Err(bad_key("a function's name shows its arguments", key, r"for instance `Z(\alpha)`"));
            }
        };
        let moving = match d.role {
            Role::Time | Role::State | Role::Observable => true,
            Role::Parameter | Role::Argument | Role::Coordinate | Role::Field => false,
            Role::Abbreviation => definition.as_ref().is_some_and(|t| self.depends_on_time(graph, t)),
        };
        let rank = shape.real_extents().len();
        // `L_i` with a formula in i is a vector; its components are written like those of any other.
        let indexed = !pattern.is_empty() && pattern.iter().all(|p| *p == Pattern::Index);
        let printed = if indexed { name::to_latex(&name) } else { key.to_owned() };
        let symbol = graph.declare(&printed, shape, d.diagonal && definition.is_none());
        if matches!(d.role, Role::Time | Role::State | Role::Parameter | Role::Coordinate) {
            graph.set_always_has_value(symbol);
        }
        for whole in numbered {
            let whole = whole.unwrap_or(symbol);
            graph.set_numbered(whole);
            self.entries.number(whole);
        }
        if d.role == Role::Coordinate {
            for component in 0..graph.component_count(symbol) as u16 {
                graph.add_coordinate(symbol, component).ok_or_else(|| too_many(key))?;
            }
        }
        if let Arguments::Coordinates(_, coordinates) = &arguments {
            for &leaf in coordinates {
                // The time is a coordinate where a field depends on it.
                let at = graph.add_coordinate(leaf.symbol, leaf.component).ok_or_else(|| too_many(key))?;
                if definition.is_none() {
                    graph.set_arguments(symbol, &[at]);
                }
            }
        }
        self.add_word_of(&name);
        let key = key.to_owned();
        let entry = Entry {
            key,
            name,
            sub: pattern,
            arguments,
            symbol,
            role: d.role,
            definition,
            moving,
            rank,
            complex: d.complex,
            angle: d.angle,
            labelled: d.labelled,
            scale,
            place,
        };
        // The same name again hides the earlier one.
        self.entries.add(Arc::new(entry));
        Ok(symbol)
    }

    /// The formal arguments of a function, which are symbols of an inner scope.
    fn inner(&mut self, graph: &mut Graph, arguments: &[&str]) -> Result<Vec<Arc<Entry>>, DeclareError> {
        if arguments.is_empty() {
            return Ok(Vec::new());
        }
        // A scope of its own for every function would take the square of their number.
        self.entries.begin();
        let mut all = arguments.iter().map(|argument| self.declare(graph, argument, Declaration::of(Role::Argument)));
        let refused = all.find_map(Result::err);
        drop(all);
        let inner = self.entries.undo();
        refused.map_or(Ok(inner), Err)
    }

    /// The meaning of a formula where the arguments of its function are known; and whether the letters are indices of it.
    fn definition_with(
        &mut self,
        graph: &mut Graph,
        inner: &[Arc<Entry>],
        (text, letters): (&str, &[Name]),
    ) -> Result<(Tensor, bool), DeclareError> {
        if inner.is_empty() {
            return Elaborator::new(self, graph).definition(text, letters).map_err(DeclareError::Formula);
        }
        self.entries.begin();
        for argument in inner {
            self.entries.add(Arc::clone(argument));
            self.add_word_of(&argument.name);
        }
        let found = Elaborator::new(self, graph).definition(text, letters);
        self.entries.undo();
        found.map_err(DeclareError::Formula)
    }

    /// Notes a name of several letters.
    fn add_word_of(&mut self, name: &str) {
        if let Some(letters) = spelled(name) {
            self.entries.add_word(letters);
        }
    }

    /// The symbols, `None` for the one that is being declared, beside which another has the name of a component: `{\bf r}` beside a vector
    /// `{\bf r}_1`. A subscript alone is then no component of theirs. A number `r_1` is refused beside them, unless a vector is called
    /// `{\bf r}_1`, too, or the vector is declared as `labelled`: then it is clear that the subscript counts.
    fn with_such_components(
        &self,
        key: &str,
        (name, pattern): (&str, &[Pattern]),
        shape: &Shape,
        labelled: bool,
    ) -> Result<Vec<Option<Symbol>>, DeclareError> {
        let rank = shape.real_extents().len();
        let mut numbered: Vec<Option<Symbol>> =
            (labelled && rank > 0 && pattern.is_empty()).then_some(None).into_iter().collect();
        let like: Vec<&Entry> = match pattern.is_empty() {
            true => self.entries.components(name).collect(),
            false => self.entries.like(name, &[]).collect(),
        };
        for e in like.into_iter().filter(|e| name::unmarked(&e.name) == name::unmarked(name)) {
            let component = |sub: &[Pattern], rank: usize| like_indices(sub) == Some(rank);
            let (whole, below, rank_below, is_said) = if e.sub.is_empty() && component(pattern, e.rank) {
                (Some(e.symbol), pattern, rank, e.labelled)
            } else if pattern.is_empty() && component(&e.sub, rank) {
                (None, e.sub.as_slice(), e.rank, labelled)
            } else {
                continue;
            };
            let counts = |other: &Entry| other.rank > 0 && name::unmarked(&other.name) == name::unmarked(name);
            let below = labels(below).unwrap_or_default();
            if rank_below == 0 && !is_said && !self.entries.like(name, &below).any(counts) {
                let message = format!("`{key}` would also be a component of, or have the component, `{}`", e.key);
                return Err(bad_key(
                    message,
                    key,
                    "rename one of the two, or declare the one with components as `labelled`",
                ));
            }
            numbered.push(whole);
        }
        Ok(numbered)
    }

    /// Notes a name whose declaration was refused: what names it is refused with [`REFUSED`], which need not be told.
    pub fn note_refused(&mut self, key: &str) {
        if let Ok(WrittenName { name, sub, .. }) = read_key(key, self) {
            self.entries.refuse(name, sub);
        }
    }

    /// The symbol declared under a key, in any spelling of it.
    pub fn symbol(&self, key: &str) -> Option<Symbol> {
        let wanted = read_key(key, self).ok()?;
        let is_meant = |e: &&Entry| {
            e.name == wanted.name
                && wanted.arguments.is_none()
                && matches!(e.arguments, Arguments::None | Arguments::Coordinates(..))
        };
        let named = self.entries.like(&wanted.name, &wanted.sub).rev().find(is_meant);
        // Of both the one that was declared later.
        named.into_iter().chain(self.entries.under(key).next_back()).map(|e| e.symbol).max()
    }
}
