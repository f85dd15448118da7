//! Coordinates, and the fields that depend on them: what their declarations say.
//!
//! **In:** the key of a field, `u(x,t)`; the scale factor of a coordinate. **Out:** the coordinates that a name shows, those of
//! space with their scale factors, and what a subscript such as that of `u_{xx}` names. **Guaranteed:** a field's formula names
//! nothing that changes but its coordinates; a scale factor names coordinates and parameters only.

use super::super::elaborate::Elaborator;
use super::super::syntax::{Name, SubItem};
use super::{Arguments, DeclareError, Entry, Role, Scope, bad_key, too_many};
use diag::Problem;
use expr::{Expr, Graph, Leaf, Shape, Symbol, Tensor};

/// The places of an unknown function of what is no coordinate.
pub(super) struct FunctionPlaces {
    /// The coordinates that stand for its places.
    pub coordinates: Vec<Leaf>,
    /// What stands in them.
    pub values: Vec<Expr>,
}

impl Scope {
    /// The coordinates that stand in the parentheses of a field's name.
    pub(super) fn coordinates_of(
        &self,
        graph: &Graph,
        key: &str,
        arguments: Option<&str>,
    ) -> Result<Vec<Leaf>, DeclareError> {
        if arguments.is_none() {
            return Err(bad_key("a field shows its coordinates", key, "for instance `u(x,t)`"));
        }
        let mut out: Vec<Leaf> = Vec::new();
        for name in places_in(key) {
            let symbol = self.symbol(name).filter(|s| matches!(self.role(*s), Some(Role::Coordinate | Role::Time)));
            let Some(symbol) = symbol else {
                let message = format!("`{name}` is not declared as a coordinate");
                return Err(bad_key(message, key, "declare it before the field, with the role `coordinate`"));
            };
            for component in 0..graph.component_count(symbol) as u16 {
                let leaf = Leaf::now(symbol, component);
                if out.contains(&leaf) {
                    return Err(bad_key(format!("`{name}` stands twice"), key, ""));
                }
                out.push(leaf);
            }
        }
        Ok(out)
    }

    /// For an unknown function of what is no coordinate, `V(r)` or `L(q,\dot q,t)`: coordinates that stand for its places, and what stands in
    /// them: states, their rates, the time, parameters, coordinates. `None` for a field of coordinates.
    ///
    /// The coordinates are the first of the graph, whatever they are called: the function is never taken at them, but at its places.
    pub(super) fn places_of(
        &self,
        graph: &mut Graph,
        key: &str,
        arguments: Option<&str>,
    ) -> Result<Option<FunctionPlaces>, DeclareError> {
        if arguments.is_none() {
            return Ok(None);
        }
        let is_coordinate =
            |name: &str| self.symbol(name).is_none_or(|s| matches!(self.role(s), Some(Role::Coordinate | Role::Time)));
        let dotted = |name: &str| name.starts_with(r"\dot") || name.starts_with(r"\ddot");
        if places_in(key).into_iter().all(|name| is_coordinate(name) && !dotted(name)) {
            return Ok(None);
        }
        let mut places = Vec::new();
        for part in places_in(key) {
            let read = Elaborator::new(self, graph).quantity(part);
            // A vector stands for its components: `V({\bf r})`.
            let is_leaf = |e: &Expr| matches!(graph.node(*e), expr::Node::Leaf(l) if l.instant.is_none());
            let values = read.ok().filter(|t| !t.shape.is_complex()).map(|t| t.components).unwrap_or_default();
            let is_place = !values.is_empty() && values.iter().all(|e| is_leaf(e) && !places.contains(e));
            if !is_place {
                let message = format!("`{part}` is no place of a function");
                let hint = "a place is a coordinate, the time, a state or its rate, or a parameter, each once: `L(q,\\dot q,t)`";
                return Err(bad_key(message, key, hint));
            }
            places.extend(values);
        }
        let mut known: Vec<Leaf> = graph.coordinates().collect();
        while known.len() < places.len() {
            let symbol = graph.declare(&format!(r"\xi_{{{}}}", known.len() + 1), Shape::scalar(), false);
            graph.add_coordinate(symbol, 0).ok_or_else(|| too_many(key))?;
            known.push(Leaf::now(symbol, 0));
        }
        known.truncate(places.len());
        Ok(Some(FunctionPlaces { coordinates: known, values: places }))
    }

    /// Refuses a field's formula that names something that changes and is not among its coordinates.
    pub(super) fn depends_on(
        &self,
        graph: &Graph,
        t: &Tensor,
        allowed: &[Leaf],
        text: &str,
    ) -> Result<(), DeclareError> {
        let fixed = |l: &Leaf| match self.role(graph.field_of(l.symbol)) {
            Some(Role::Coordinate | Role::Time) => allowed.contains(l),
            Some(Role::State | Role::Observable) => false,
            // What it names must not depend on more than it does itself.
            Some(Role::Field) => {
                graph.coordinates().enumerate().all(|(at, c)| !graph.depends(l.symbol, at) || allowed.contains(&c))
            }
            Some(Role::Parameter | Role::Abbreviation | Role::Argument) | None => true,
        };
        let Some(leaf) = graph.leaves_within(t.components.iter().copied()).into_iter().find(|l| !fixed(l)) else {
            return Ok(());
        };
        let message = format!("`{}` is not among the coordinates of this field", graph.name(leaf.symbol));
        let hint = Some("name it in the parentheses of the field".to_owned());
        Err(DeclareError::Formula(vec![Problem { code: "latex::derivative", message, span: 0..text.len(), hint }]))
    }

    /// The scale factor of a coordinate: a number that names coordinates, parameters and nothing else.
    pub(super) fn scale_factor(
        &self,
        graph: &mut Graph,
        name: &str,
        (shape, text): (Option<&Shape>, &str),
    ) -> Result<Expr, DeclareError> {
        let wrong = |message: String, hint: &str| {
            let hint = Some(hint.to_owned());
            DeclareError::Formula(vec![Problem { code: "latex::shape", message, span: 0..text.len(), hint }])
        };
        if !is_of_space(name, Role::Coordinate) {
            return Err(wrong(format!("`{name}` is no coordinate of space"), "leave its scale factor out"));
        }
        let (tensor, _) = Elaborator::new(self, graph).definition(text, &[]).map_err(DeclareError::Formula)?;
        let Some(factor) = tensor.as_scalar().filter(|_| shape.is_none_or(|s| s.rank() == 0)) else {
            return Err(wrong(
                "a scale factor is that of one coordinate, a real number".to_owned(),
                "declare r, θ, φ one by one",
            ));
        };
        let still = |l: &&Leaf| !matches!(self.role(l.symbol), Some(Role::Coordinate | Role::Parameter)) || l.rate > 0;
        match graph.leaves_within([factor]).iter().find(still) {
            None => Ok(factor),
            Some(leaf) => {
                let message = format!("a scale factor does not depend on `{}`", graph.name(leaf.symbol));
                Err(wrong(message, "it names coordinates that are declared before, and parameters"))
            }
        }
    }

    /// The scale factors of the coordinates of space, 1 unless another is declared; `None` where all are Cartesian.
    pub(crate) fn scale_factors(&self, graph: &mut Graph) -> Option<Vec<Expr>> {
        let one = graph.integer(1);
        let space = || self.entries.coordinates().filter(|e| self.is_place(e));
        let factors = space().flat_map(|e| vec![e.scale.unwrap_or(one); graph.component_count(e.symbol)]).collect();
        space().any(|e| e.scale.is_some()).then_some(factors)
    }

    /// The coordinates of space: all but the time, but `t`, and but momenta.
    pub(crate) fn space(&self, graph: &Graph) -> Vec<Leaf> {
        let symbols = self.entries.coordinates().filter(|e| self.is_place(e)).map(|e| e.symbol);
        symbols.flat_map(|s| (0..graph.component_count(s) as u16).map(move |c| Leaf::now(s, c))).collect()
    }

    /// Says that a field is the velocity with which `\frac{D}{Dt}` moves.
    ///
    /// # Errors
    /// [`DeclareError::Key`], where there is one already, or where it is no field of real numbers.
    pub fn set_velocity(&mut self, key: &str, symbol: Symbol) -> Result<(), DeclareError> {
        let real = self.by_symbol(symbol).is_some_and(|e| e.role == Role::Field && e.rank < 2 && !e.complex);
        if !real || self.velocity().is_some() {
            return Err(bad_key("the velocity is one field, a real vector", key, "leave `velocity` out"));
        }
        self.velocity = Some(symbol);
        Ok(())
    }

    /// The velocity that is declared, unless another declaration hides it.
    pub(crate) fn velocity(&self) -> Option<Symbol> {
        self.velocity.filter(|symbol| self.entries.is_found(*symbol))
    }

    /// The coordinate of this name, if it is one number.
    pub(crate) fn coordinate(&self, letter: &str) -> Option<Leaf> {
        let is_it = |e: &&Entry| e.name == letter && e.rank == 0;
        let entry = self.entries.like(letter, &[]).rev().find(is_it)?;
        matches!(entry.role, Role::Coordinate | Role::Time).then(|| Leaf::now(entry.symbol, 0))
    }

    /// Whether there are coordinates of space.
    pub(crate) fn has_space(&self) -> bool {
        self.entries.coordinates().any(|e| self.is_place(e))
    }

    /// Whether ∇ acts on a symbol: on a coordinate of space that is no momentum.
    fn is_place(&self, e: &Entry) -> bool {
        is_of_space(&e.name, e.role) && !self.is_momentum(e.symbol)
    }

    /// Whether a symbol, as it is written, is a field of one coordinate: its derivative is written with primes.
    pub(crate) fn is_of_one_coordinate(&self, name: &str, sub: Option<&[SubItem]>) -> bool {
        self.find(name, sub, None).is_some_and(|f| f.coordinates.len() == 1)
    }

    /// The variables on which a symbol depends, as it is written, by their names: coordinates, the time. `None` where they have no plain names.
    pub(crate) fn variables(&self, name: &str, sub: Option<&[SubItem]>) -> Option<Vec<Name>> {
        let Some(found) = self.find(name, sub, None) else { return Some(Vec::new()) };
        let named = |symbol: Symbol| self.by_symbol(symbol).filter(|e| e.sub.is_empty()).map(|e| e.name.clone());
        let time = || self.time_name().map(|name| vec![name.to_owned()]);
        match found.role {
            Role::Coordinate => named(found.symbol).map(|name| vec![name]),
            Role::Field if found.place.is_empty() => found.coordinates.iter().map(|leaf| named(leaf.symbol)).collect(),
            Role::Field | Role::Argument => None,
            Role::Time | Role::State | Role::Observable => time(),
            Role::Abbreviation if self.is_moving(name, sub) => time(),
            Role::Abbreviation | Role::Parameter => Some(Vec::new()),
        }
    }

    /// The coordinates that a subscript of a scalar field names, if it names nothing else: it has no components, and a label would
    /// be declared.
    pub(super) fn derivatives(&self, entry: &Entry, subscript: &[SubItem]) -> Option<Vec<Leaf>> {
        let Arguments::Coordinates(_, coordinates) = &entry.arguments else { return None };
        // The coordinates of a function of what is no coordinate are nobody's names.
        if subscript.is_empty() || entry.rank > 0 || !entry.place.is_empty() {
            return None;
        }
        let named = |letter: &Name| {
            let is_it =
                |leaf: &&Leaf| self.by_symbol(leaf.symbol).is_some_and(|e| e.name == *letter && e.sub.is_empty());
            coordinates.iter().find(is_it).copied()
        };
        let one = |item: &SubItem| if let SubItem::Name(letter) = item { named(letter) } else { None };
        subscript.iter().map(one).collect()
    }
}

/// Whether ∇ acts on a symbol: on a coordinate that is not that of the time by its name.
fn is_of_space(name: &str, role: Role) -> bool {
    role == Role::Coordinate && !matches!(name, "t" | r"\tau")
}

/// What stands between the commas of the parentheses with which a key ends, as it is written.
fn places_in(key: &str) -> Vec<&str> {
    let inside = key.trim_end().strip_suffix(')').unwrap_or_default();
    let mut depth = 1usize;
    let open = inside.char_indices().rev().find(|(_, c)| {
        depth = match c {
            ')' => depth + 1,
            '(' => depth - 1,
            _ => depth,
        };
        depth == 0
    });
    let inside = open.map_or("", |(at, _)| &inside[at + 1..]);
    let (mut out, mut from, mut depth) = (Vec::new(), 0, 0i32);
    for (at, c) in inside.char_indices() {
        depth += i32::from(matches!(c, '{' | '(')) - i32::from(matches!(c, '}' | ')'));
        if c == ',' && depth == 0 {
            out.push(inside[from..at].trim());
            from = at + 1;
        }
    }
    out.push(inside[from..].trim());
    out
}
