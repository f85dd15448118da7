//! Coordinates, and fields: symbols that depend on coordinates.
//!
//! **In:** which components of which symbols are coordinates, and on which of them a symbol depends. **Out:** [`Partials`], the
//! order of a partial derivative, which is part of a [`Leaf`]; and derivatives by a coordinate.
//!
//! **Guaranteed:** a derivative of a field is a leaf of its own, the same in whatever order it was taken: fields are smooth.
//! Whoever gives a field by a formula must see to that.
//!
//! **Why a multi-index and not new symbols:** what is known of a field, its shape, its unit, its formula, is known of its
//! derivatives, too.

use super::{Expr, Graph, Leaf, NoDerivative, Symbol};

/// Most coordinates of one graph.
pub const MOST_COORDINATES: usize = 5;

/// Highest total order of a partial derivative.
pub const HIGHEST_ORDER: u32 = 12;

/// How often a field is derived by each coordinate of its graph.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Partials([u8; MOST_COORDINATES]);

impl Partials {
    /// The field itself.
    pub const NONE: Partials = Partials([0; MOST_COORDINATES]);

    /// Whether this is the field itself.
    pub fn is_none(self) -> bool {
        self == Partials::NONE
    }

    /// The total order.
    pub fn order(self) -> u32 {
        self.0.iter().map(|&n| u32::from(n)).sum()
    }

    /// The orders, one for each coordinate.
    pub fn orders(self) -> [u8; MOST_COORDINATES] {
        self.0
    }

    /// Once more by a coordinate; `None` beyond [`HIGHEST_ORDER`].
    pub fn raised(self, coordinate: usize) -> Option<Partials> {
        let mut out = self;
        *out.0.get_mut(coordinate)? += 1;
        (out.order() <= HIGHEST_ORDER).then_some(out)
    }

    /// What must be derived in addition to `lower` to get this, if that is possible.
    pub fn beyond(self, lower: Partials) -> Option<Partials> {
        let mut out = Partials::NONE;
        for (to, (a, b)) in out.0.iter_mut().zip(self.0.iter().zip(lower.0)) {
            *to = a.checked_sub(b)?;
        }
        Some(out)
    }

    /// The coordinates by which it is derived, each as often as it is.
    pub fn steps(self) -> impl Iterator<Item = usize> {
        self.0.into_iter().enumerate().flat_map(|(at, n)| std::iter::repeat_n(at, usize::from(n)))
    }
}

impl Leaf {
    /// The present value of a component of a symbol.
    pub fn now(symbol: Symbol, component: u16) -> Leaf {
        Leaf { symbol, component, rate: 0, partials: Partials::NONE, instant: None }
    }
}

impl Graph {
    /// Makes a component of a symbol a coordinate, unless it is one. Its position among the coordinates; `None` where there are
    /// [`MOST_COORDINATES`] already.
    pub fn add_coordinate(&mut self, symbol: Symbol, component: u16) -> Option<usize> {
        let known = self.coordinates.iter().position(|c| *c == (symbol, component));
        if known.is_none() && self.coordinates.len() < MOST_COORDINATES {
            self.coordinates.push((symbol, component));
            return Some(self.coordinates.len() - 1);
        }
        known
    }

    /// The coordinates.
    pub fn coordinates(&self) -> impl Iterator<Item = Leaf> {
        self.coordinates.iter().map(|&(symbol, component)| Leaf::now(symbol, component))
    }

    /// The position of a leaf among the coordinates, if it is one.
    pub fn coordinate(&self, leaf: Leaf) -> Option<usize> {
        let is_it = |&(symbol, component): &(Symbol, u16)| Leaf::now(symbol, component) == leaf;
        self.coordinates.iter().position(is_it)
    }

    /// Says that a symbol is a field: which coordinates it depends on, by their positions.
    pub fn set_arguments(&mut self, symbol: Symbol, coordinates: &[usize]) {
        let known = self.arguments.entry(symbol).or_default();
        for &at in coordinates {
            if !known.contains(&at) {
                known.push(at);
            }
        }
    }

    /// Whether a symbol depends on a coordinate.
    pub fn depends(&self, symbol: Symbol, coordinate: usize) -> bool {
        match self.place(symbol) {
            // What stands in the place does.
            Some(place) => self.leaves(place.at.iter().map(|&(_, e)| e)).into_iter().any(|l| {
                self.coordinate(l) == Some(coordinate) || l.instant.is_none() && self.depends(l.symbol, coordinate)
            }),
            None => self.arguments.get(&symbol).is_some_and(|all| all.contains(&coordinate)),
        }
    }

    /// Whether a symbol depends on some coordinate, or is a field at a place.
    pub fn is_field(&self, symbol: Symbol) -> bool {
        self.arguments.get(&symbol).is_some_and(|all| !all.is_empty()) || self.place(symbol).is_some()
    }

    /// ∂e/∂(coordinate), the other coordinates and everything that depends on none being held fixed.
    ///
    /// # Errors
    /// See [`Graph::directional_derivative`]; and [`NoDerivative::Order`].
    pub fn derivative_by(&mut self, e: Expr, coordinate: usize) -> Result<Expr, NoDerivative> {
        for leaf in self.leaves([e]) {
            self.raised(leaf, coordinate)?;
        }
        self.directional_derivative(e, |graph, leaf| match graph.coordinate(leaf) {
            Some(at) => (at == coordinate).then(|| graph.integer(1)),
            None => graph.raised(leaf, coordinate).ok().flatten(),
        })
    }

    /// An expression with fields replaced by their formulas, and their derivatives by those of the formulas. The formulas name
    /// no other fields, and coordinates by themselves.
    ///
    /// # Errors
    /// See [`Graph::derivative_by`].
    pub fn with_fields(
        &mut self,
        e: Expr,
        formula: impl Fn(Symbol, u16) -> Option<Expr>,
    ) -> Result<Expr, NoDerivative> {
        self.with_fields_dyn(e, &formula)
    }

    fn with_fields_dyn(
        &mut self,
        e: Expr,
        formula: &dyn Fn(Symbol, u16) -> Option<Expr>,
    ) -> Result<Expr, NoDerivative> {
        let mut images = super::FastMap::default();
        for leaf in self.leaves([e]) {
            if let Some(value) = formula(self.field_of(leaf.symbol), leaf.component) {
                // Where the field has no value, its derivatives have none, and where one of these has none, its own have none.
                let mut image = value;
                for at in leaf.partials.steps() {
                    let derivative = self.derivative_by(image, at)?;
                    let argument = self.broken_by(image).and_then(|e| self.node(e).children().next());
                    let speed = argument.and_then(|v| self.derivative_by(v, at).ok());
                    image = self.rate_known(image, derivative, speed, |_| false);
                }
                if let Some(place) = self.place(leaf.symbol).cloned() {
                    let coordinates: Vec<Leaf> = self.coordinates().collect();
                    let mut values = Vec::with_capacity(place.at.len());
                    for (at, e) in place.at {
                        values.push((coordinates[at], self.with_fields_dyn(e, formula)?));
                    }
                    image = self.taken_at(image, &values);
                }
                images.insert(leaf, image);
                continue;
            }
            // In the places of other fields, and in the times at which something is taken, too.
            let places = self.place(leaf.symbol).map(|place| place.at.clone()).unwrap_or_default();
            let mut put = super::FastMap::default();
            for e in places.into_iter().map(|(_, e)| e).chain(leaf.instant) {
                put.insert(e, self.with_fields_dyn(e, formula)?);
            }
            if put.iter().any(|(before, after)| before != after) {
                let there = |e: Expr| put.get(&e).copied().unwrap_or(e);
                let now = Leaf { instant: leaf.instant.map(there), ..leaf };
                let image =
                    if self.is_field(leaf.symbol) { self.through(now, |_, e| there(e)) } else { self.leaf(now) };
                images.insert(leaf, image);
            }
        }
        Ok(self.replaced(e, |_, leaf| images.get(&leaf).copied()))
    }

    /// The leaves of fields below some expressions.
    pub fn fields(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Leaf> {
        self.leaves(roots).into_iter().filter(|l| self.is_field(l.symbol)).collect()
    }
}
