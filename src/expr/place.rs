//! Fields at other places: u(0, t), f(x − ct), V(q).
//!
//! **In:** a field, and an expression for each coordinate on which it depends. **Out:** a symbol of its own for the field at that
//! place, and everything that is taken *through* places: substitution, derivatives, leaves.
//!
//! The components of such a symbol are those of the field. Its [`Partials`](super::Partials) say how often the *field* is derived by each of its
//! coordinates before it is taken there: with the partials (2) of f(x − ct), it is f″(x − ct). So its derivatives follow the chain
//! rule, ∂ₓ f⁽ⁿ⁾(g) = ∂ₓg · f⁽ⁿ⁺¹⁾(g).
//!
//! **Guaranteed:** the same field at the same places is the same symbol; at its own coordinates it is the field itself; nothing
//! that is taken through places leaves out what stands in them.
//!
//! **Why a symbol and no node with arguments:** for a proof, values of a field at different places are independent unknowns, as
//! its derivatives are. There, and only there, nothing is taken through places: see [`Graph::replaced`] and [`Graph::slope`].

use super::{Expr, FastMap, FastSet, Graph, Leaf, NoDerivative, Op, Symbol};

/// Places in places are looked through this often, f(g(h(x))): what is deeper is not written.
pub const DEEPEST_PLACE: usize = 6;

/// A field at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The field.
    pub field: Symbol,
    /// The positions of its coordinates, in the order in which its name shows them, and what is put for each.
    pub at: Vec<(usize, Expr)>,
}

impl Graph {
    /// The place at which a symbol is a field, if it is one at another place.
    pub fn place(&self, symbol: Symbol) -> Option<&Place> {
        let at = self.places.binary_search_by_key(&symbol, |(s, _)| *s).ok()?;
        Some(&self.places[at].1)
    }

    /// The field that a symbol is, at whatever place; the symbol itself, if it is at none.
    pub fn field_of(&self, symbol: Symbol) -> Symbol {
        self.place(symbol).map_or(symbol, |p| p.field)
    }

    /// Whether fields at other places stand below some expressions.
    pub fn has_places(&self, roots: impl IntoIterator<Item = Expr>) -> bool {
        !self.places.is_empty() && self.leaves(roots).iter().any(|l| self.place(l.symbol).is_some())
    }

    /// The leaves below some expressions, and those in the places at which fields are taken.
    pub fn leaves_within(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Leaf> {
        let mut roots: Vec<Expr> = roots.into_iter().collect();
        roots.extend(self.places_below(roots.iter().copied()));
        self.leaves(roots)
    }

    /// What is put for the coordinates of fields at places, below some expressions and in such places.
    pub fn places_below(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        if self.places.is_empty() {
            return Vec::new();
        }
        let (mut out, mut seen) = (Vec::new(), FastSet::default());
        let mut open: Vec<Expr> = roots.into_iter().collect();
        while !open.is_empty() {
            let leaves = self.leaves(open.drain(..));
            let places = leaves.iter().filter_map(|l| self.place(l.symbol)).flat_map(|p| p.at.iter().map(|&(_, e)| e));
            open.extend(places.filter(|e| seen.insert(*e)));
            out.extend(open.iter().copied());
        }
        out
    }

    /// How many places stand in each other below an expression.
    pub fn depth_of_places(&self, e: Expr) -> usize {
        let (mut depth, mut open) = (0, vec![e]);
        loop {
            let leaves = self.leaves(open);
            open =
                leaves.iter().filter_map(|l| self.place(l.symbol)).flat_map(|p| p.at.iter().map(|&(_, e)| e)).collect();
            if open.is_empty() {
                return depth;
            }
            depth += 1;
        }
    }

    /// A field's leaf with other values for the coordinates on which it depends, by their positions.
    fn moved(&mut self, leaf: Leaf, at: Vec<(usize, Expr)>) -> Expr {
        let field = self.field_of(leaf.symbol);
        let own: Vec<Expr> = self.coordinates().collect::<Vec<_>>().into_iter().map(|c| self.leaf(c)).collect();
        if at.iter().all(|(position, e)| own.get(*position) == Some(e)) {
            return self.leaf(Leaf { symbol: field, ..leaf });
        }
        let place = Place { field, at };
        let known = self.places.iter().find(|(_, p)| *p == place).map(|(s, _)| *s);
        let symbol = known.unwrap_or_else(|| {
            let name = format!("{}{}", self.bare_name(field), self.arguments_latex(&place));
            let symbol = self.declare(&name, self.shape(field).clone(), self.is_diagonal(field));
            self.places.push((symbol, place));
            symbol
        });
        self.leaf(Leaf { symbol, ..leaf })
    }

    /// The leaf of a field with expressions put for coordinates, by `put`, which is given those that it depends on, or what
    /// stands for them where it is at a place already.
    pub(super) fn through(&mut self, leaf: Leaf, mut put: impl FnMut(&mut Graph, Expr) -> Expr) -> Expr {
        let at = match self.place(leaf.symbol) {
            Some(place) => place.at.clone(),
            None => self.own_place(leaf.symbol),
        };
        let at = at.into_iter().map(|(position, e)| (position, put(self, e))).collect();
        self.moved(leaf, at)
    }

    /// The coordinates of a field, as expressions.
    fn own_place(&mut self, symbol: Symbol) -> Vec<(usize, Expr)> {
        let order = self.arguments.get(&symbol).cloned().unwrap_or_default();
        let coordinates: Vec<Leaf> = self.coordinates().collect();
        order.into_iter().filter_map(|at| Some((at, self.leaf(*coordinates.get(at)?)))).collect()
    }

    /// An expression with other values for coordinates.
    pub fn taken_at(&mut self, e: Expr, values: &[(Leaf, Expr)]) -> Expr {
        self.substitute(e, |_, leaf| values.iter().find(|(l, _)| *l == leaf).map(|(_, e)| *e))
    }

    /// `e` with every leaf replaced for which `with` yields an expression, in the places of fields, too: a field depends on its
    /// coordinates, whether they are written or not.
    pub fn substitute(&mut self, e: Expr, mut with: impl FnMut(&mut Graph, Leaf) -> Option<Expr>) -> Expr {
        self.substitute_dyn(e, Graph::power, &mut with)
    }

    /// The same, as the formula reads where the expressions are written instead of the leaves: x^{±2} with a sign for ±.
    pub fn rewrite(&mut self, e: Expr, mut with: impl FnMut(&mut Graph, Leaf) -> Option<Expr>) -> Expr {
        self.substitute_dyn(e, |graph, a, b| graph.binary(Op::Pow, a, b), &mut with)
    }

    fn substitute_dyn(
        &mut self,
        e: Expr,
        power: fn(&mut Graph, Expr, Expr) -> Expr,
        with: &mut dyn FnMut(&mut Graph, Leaf) -> Option<Expr>,
    ) -> Expr {
        if self.coordinates.is_empty() {
            return self.replaced_by(e, power, &mut *with);
        }
        self.replaced_by(e, power, |graph, leaf| {
            let found = with(graph, leaf);
            if found.is_some() || leaf.instant.is_some() || !graph.is_field(leaf.symbol) {
                return found;
            }
            Some(graph.through(leaf, |graph, e| graph.substitute_dyn(e, power, &mut *with)))
        })
    }

    /// The derivative of a field at a place, by the chain rule: `derive` yields the derivatives of what it is taken at.
    fn chain(
        &mut self,
        leaf: Leaf,
        mut derive: impl FnMut(&mut Graph, Expr) -> Result<Expr, NoDerivative>,
    ) -> Result<Expr, NoDerivative> {
        let at = self.place(leaf.symbol).map(|p| p.at.clone()).unwrap_or_default();
        let mut sum = self.integer(0);
        for (position, e) in at {
            let inner = derive(self, e)?;
            if !self.is_zero(inner) {
                let partials = leaf.partials.raised(position).ok_or(NoDerivative::Order)?;
                let outer = self.leaf(Leaf { partials, ..leaf });
                let term = self.mul(inner, outer);
                sum = self.add(sum, term);
            }
        }
        Ok(sum)
    }

    /// The derivatives of the fields at places that stand below an expression.
    fn chains(
        &mut self,
        e: Expr,
        mut derive: impl FnMut(&mut Graph, Expr) -> Result<Expr, NoDerivative>,
    ) -> Result<FastMap<Leaf, Expr>, NoDerivative> {
        let mut out = FastMap::default();
        if !self.places.is_empty() {
            for leaf in self.leaves([e]).into_iter().filter(|l| self.place(l.symbol).is_some()).collect::<Vec<_>>() {
                out.insert(leaf, self.chain(leaf, &mut derive)?);
            }
        }
        Ok(out)
    }

    /// The derivative of a field's leaf by a coordinate; `None` where it does not depend on it.
    ///
    /// # Errors
    /// [`NoDerivative::Order`] beyond [`HIGHEST_ORDER`](super::HIGHEST_ORDER).
    pub(super) fn raised(&mut self, leaf: Leaf, coordinate: usize) -> Result<Option<Expr>, NoDerivative> {
        if leaf.instant.is_some() || !self.depends(leaf.symbol, coordinate) {
            return Ok(None);
        }
        if self.place(leaf.symbol).is_some() {
            return self.chain(leaf, |graph, e| graph.derivative_by(e, coordinate)).map(Some);
        }
        let partials = leaf.partials.raised(coordinate).ok_or(NoDerivative::Order)?;
        Ok(Some(self.leaf(Leaf { partials, ..leaf })))
    }

    /// ∂e/∂leaf, also through the places at which fields are taken.
    ///
    /// # Errors
    /// See [`Graph::directional_derivative`].
    pub fn partial_derivative(&mut self, e: Expr, by: Leaf) -> Result<Expr, NoDerivative> {
        let chains = self.chains(e, |graph, e| graph.partial_derivative(e, by))?;
        self.directional_derivative(e, |graph, leaf| match chains.get(&leaf) {
            // The field at a place by itself, and by what it is taken at, cannot both be meant.
            Some(&chained) if leaf != by => Some(chained),
            Some(_) | None => (leaf == by).then(|| graph.integer(1)),
        })
    }

    /// de/dt by the chain rule: a leaf for which `moves` is true contributes its rate, `time` contributes 1, a field its
    /// derivative by the time, all coordinates being held fixed, and at a moving place what comes with that.
    ///
    /// # Errors
    /// See [`Graph::directional_derivative`].
    pub fn time_derivative(&mut self, e: Expr, time: Leaf, moves: impl Fn(Leaf) -> bool) -> Result<Expr, NoDerivative> {
        self.rate(e, time, &moves)
    }

    fn rate(&mut self, e: Expr, time: Leaf, moves: &dyn Fn(Leaf) -> bool) -> Result<Expr, NoDerivative> {
        let coordinate = self.coordinate(time);
        let chains = self.chains(e, |graph, e| graph.rate(e, time, moves))?;
        for leaf in self.leaves([e]) {
            coordinate.map_or(Ok(None), |at| self.raised(leaf, at))?;
        }
        self.directional_derivative(e, |graph, leaf| {
            if leaf == time {
                Some(graph.integer(1))
            } else if let Some(&chained) = chains.get(&leaf) {
                Some(chained)
            } else if let Some(at) = coordinate
                && graph.depends(leaf.symbol, at)
            {
                graph.raised(leaf, at).ok().flatten()
            } else if leaf.instant.is_none() && moves(leaf) {
                Some(graph.leaf(Leaf { rate: leaf.rate + 1, ..leaf }))
            } else {
                None
            }
        })
    }

    /// The pairs of places at which one field is taken below some expressions: for each, the differences of what is put for its
    /// coordinates. Where one of them is not 0, the values of the field and of its derivatives there are free of each other.
    pub fn differences_of_places(&mut self, roots: impl IntoIterator<Item = Expr>) -> Vec<Vec<Expr>> {
        let roots: Vec<Expr> = roots.into_iter().collect();
        if !self.has_places(roots.iter().copied()) {
            return Vec::new();
        }
        // Also those in the places of others: f(g(x)).
        let within = self.leaves_within(roots).into_iter().filter(|l| self.is_field(l.symbol));
        let mut symbols: Vec<Symbol> = within.map(|l| l.symbol).collect();
        symbols.sort_unstable();
        symbols.dedup();
        let mut out = Vec::new();
        for (i, &a) in symbols.iter().enumerate() {
            for &b in &symbols[i + 1..] {
                if self.field_of(a) == self.field_of(b) {
                    let [p, q] = [a, b].map(|s| match self.place(s) {
                        Some(place) => place.at.clone(),
                        None => self.own_place(s),
                    });
                    out.push(p.into_iter().zip(q).map(|((_, x), (_, y))| self.sub(x, y)).collect());
                }
            }
        }
        out
    }
}
