//! Partial derivatives, of fields and of formulas, and vector analysis.
//!
//! Two things are called ∂. By a **coordinate**: the other coordinates are held fixed, and fields change with it. By something
//! else that a formula names, q, q̇, p or a parameter, as in ∂L/∂q̇: everything else that the formula names is held fixed, and
//! what observables stand for is written out first. What does not show how it depends on it is refused, since the answer would
//! be 0.

use std::ops::Range;

use super::super::scope::Role;
use super::super::syntax::{Name, Node, NodeKind, SubItem};
use super::{Elaborated, Elaborator, refuse, stray};
use expr::{DEEPEST_PLACE, Expr, Leaf, NoDerivative, Tensor};

/// Names of coordinates that nobody takes for Cartesian.
pub(super) const POLAR: &[&str] = &["r", "R", r"\rho", r"\theta", r"\vartheta", r"\phi", r"\varphi"];

/// How often observables are written out that stand in the formulas of others.
const DEEPEST_FORMULAS: usize = 64;

impl Elaborator<'_> {
    /// The position of the coordinate that a node is, if it is one.
    pub(super) fn coordinate(&mut self, node: &Node) -> Elaborated<Option<usize>> {
        if !matches!(node.kind, NodeKind::Symbol(_)) {
            return Ok(None);
        }
        let value = self.tensor(node)?;
        Ok(value.as_scalar().and_then(|e| self.leaf(e)).and_then(|leaf| self.graph.coordinate(leaf)))
    }

    pub(super) fn leaf(&self, e: Expr) -> Option<Leaf> {
        match self.graph.node(e) {
            expr::Node::Leaf(leaf) => Some(*leaf),
            _ => None,
        }
    }

    /// Every component derived; where the function has no value, neither has its derivative.
    pub(super) fn derived(
        &mut self,
        t: Tensor,
        span: &Range<usize>,
        derive: impl Fn(&mut Self, Expr) -> Result<Expr, NoDerivative>,
    ) -> Elaborated<Tensor> {
        let mut components = Vec::with_capacity(t.components.len());
        for e in t.components {
            let scope = self.scope;
            match derive(self, e) {
                Ok(d) => {
                    let argument = self.graph.broken_by(e).and_then(|e| self.graph.node(e).children().next());
                    let speed = argument.and_then(|v| derive(self, v).ok());
                    let partial = |l: Leaf| scope.role(l.symbol) == Some(Role::Observable);
                    components.push(self.graph.rate_known(e, d, speed, partial));
                }
                Err(reason) => return refuse("latex::derivative", reason.to_string(), span, ""),
            }
        }
        Ok(Tensor { shape: t.shape, components })
    }

    /// Refuses the derivative of what names an argument of a function: what is put in its place may change, too.
    pub(super) fn names_no_argument(&self, t: &Tensor, span: &Range<usize>) -> Elaborated<()> {
        let leaves = self.graph.leaves_within(t.components.iter().copied());
        let Some(leaf) = leaves.into_iter().find(|l| self.scope.role(l.symbol) == Some(Role::Argument)) else {
            return Ok(());
        };
        let message = format!("`{}` stands for anything, and may change", self.graph.leaf_latex(leaf));
        let hint = "write the derivative where the function is applied, or derive by the argument";
        refuse("latex::derivative", message, span, hint)
    }

    pub(super) fn by_coordinate(&mut self, t: Tensor, at: usize, span: &Range<usize>) -> Elaborated<Tensor> {
        self.names_no_argument(&t, span)?;
        self.derived(t, span, |this, e| this.graph.derivative_by(e, at))
    }

    /// `\frac{du}{dx}` by a coordinate: of what depends on this one only, so that nothing else could change with it.
    pub(super) fn total(&mut self, t: Tensor, at: usize, span: &Range<usize>) -> Elaborated<Tensor> {
        self.is_total(&t, Some(at), span)?;
        self.by_coordinate(t, at, span)
    }

    /// Refuses a total derivative of a field of several coordinates.
    pub(super) fn is_total(&mut self, t: &Tensor, at: Option<usize>, span: &Range<usize>) -> Elaborated<()> {
        let others = self.graph.coordinates().count();
        let fields = self.graph.fields(t.components.iter().copied());
        let other = |l: &Leaf| (0..others).any(|o| Some(o) != at && self.graph.depends(l.symbol, o));
        let Some(leaf) = fields.into_iter().find(other) else { return Ok(()) };
        let message = format!("`{}` depends on other coordinates", self.graph.name(leaf.symbol));
        let hint = r"write `\partial` where they are held fixed; what changes along a motion is written out";
        refuse("latex::derivative", message, span, hint)
    }

    /// `\dot u` and `f'`: by the time, or by the only coordinate.
    pub(super) fn derivative_of_field(
        &mut self,
        t: Tensor,
        (coordinates, primed): (&[Leaf], bool),
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let by = match coordinates {
            [only] if primed => Some(*only),
            _ => self.scope.time().filter(|time| coordinates.contains(time)),
        };
        if !primed && coordinates.iter().any(|c| self.scope.is_canonical(c.symbol)) {
            let message = "is this the derivative along the motion, or by the time alone?";
            let hint = r"write `\frac{\partial f}{\partial t}`, and `\{f,H\}+\frac{\partial f}{\partial t}`";
            return refuse("latex::ambiguous", message, span, hint);
        }
        match by.and_then(|leaf| self.graph.coordinate(leaf)) {
            Some(at) => self.by_coordinate(t, at, span),
            None => {
                let hint = r"write `\frac{\partial u}{\partial t}`";
                refuse(
                    "latex::dot",
                    "a dot is the derivative by the time, on which this field does not depend",
                    span,
                    hint,
                )
            }
        }
    }

    /// A field at a place, `u(0,t)`, `f(x-ct)`.
    pub(super) fn at_place(
        &mut self,
        t: Tensor,
        coordinates: &[Leaf],
        places: &[Node],
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let mut values = Vec::new();
        for place in places {
            let value = self.tensor(place)?;
            if value.shape.is_complex() {
                return refuse("latex::shape", "a place is real", &place.span, "");
            }
            values.extend(value.components);
        }
        if values.len() != coordinates.len() {
            let message = format!("the field has {} coordinates, not {}", coordinates.len(), values.len());
            return refuse("latex::arity", message, span, r"write `\cdot` for a product");
        }
        let values: Vec<(Leaf, Expr)> = coordinates.iter().copied().zip(values).collect();
        self.taken_at(t, &values, span)
    }

    /// `\left.\partial_xu\right|_{x=0}`: what depends on a coordinate, at a value of it.
    pub(super) fn at_coordinate(
        &mut self,
        t: Tensor,
        (leaf, value): (Leaf, Expr),
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let by = self.graph.coordinate(leaf);
        let leaves = self.graph.leaves_within(t.components.iter().copied());
        if !leaves.iter().any(|l| *l == leaf || by.is_some_and(|at| self.graph.depends(l.symbol, at))) {
            let message = format!("this does not depend on `{}`", self.graph.leaf_latex(leaf));
            return refuse("latex::instant", message, span, "leave the bar out");
        }
        if leaves.iter().any(|l| l.instant.is_none() && self.is_moving(*l) && self.graph.coordinate(*l).is_none()) {
            let message = "what moves is taken at a time, not at a coordinate's value";
            return refuse("latex::instant", message, span, "write the field alone before the bar");
        }
        self.taken_at(t, &[(leaf, value)], span)
    }

    /// Something with other values for coordinates, in the formulas and in the places of its fields.
    pub(super) fn taken_at(&mut self, t: Tensor, values: &[(Leaf, Expr)], span: &Range<usize>) -> Elaborated<Tensor> {
        let unknown = !self.graph.fields(t.components.iter().copied()).is_empty();
        let put: Vec<Expr> = values.iter().map(|(_, e)| *e).collect();
        if unknown && self.graph.leaves_within(put.iter().copied()).contains(&self.scope.branch_sign()) {
            return refuse("latex::unsupported", "a place with ±", span, "write the two places");
        }
        if put.iter().any(|&e| self.graph.depth_of_places(e) >= DEEPEST_PLACE) {
            return refuse("latex::unsupported", "places within places, too deep", span, "");
        }
        let components = t.components.into_iter().map(|e| self.taken_with_values(e, values)).collect();
        Ok(Tensor { shape: t.shape, components })
    }

    /// The same of one component. A formula that does not name a coordinate has a value only where the place has one, too: J(ln r), of J = 1.
    fn taken_with_values(&mut self, e: Expr, values: &[(Leaf, Expr)]) -> Expr {
        let leaves = self.graph.leaves_within([e]);
        let mut out = self.graph.taken_at(e, values);
        for &(coordinate, value) in values {
            let at = self.graph.coordinate(coordinate);
            let is_named = |l: &Leaf| *l == coordinate || at.is_some_and(|at| self.graph.depends(l.symbol, at));
            if !leaves.iter().any(is_named) && !self.graph.needs_below([value]).is_empty() {
                let zero = self.graph.integer(0);
                let nothing = self.graph.mul(zero, value);
                out = self.graph.add(out, nothing);
            }
        }
        out
    }

    /// A partial derivative.
    pub(super) fn partial(&mut self, of: &Node, by: &[Node], span: &Range<usize>) -> Elaborated<Tensor> {
        let mut value = self.tensor(of)?;
        let shows = match &of.kind {
            NodeKind::Symbol(s) => {
                let found = self.resolve(s, &of.span)?;
                found.definition.is_some() || found.role == Role::Field
            }
            _ => true,
        };
        for by in by.iter().rev() {
            if let Some(letter) = self.space_index(by) {
                let at = self.along(&letter, &by.span)?;
                value = self.by_coordinate(value, at, span)?;
                continue;
            }
            if self.number(by)?.shape.is_complex() {
                return refuse("latex::derivative", "a derivative by a complex number", &by.span, "");
            }
            let e = self.scalar(by)?;
            let Some(leaf) = self.leaf(e) else {
                let hint = "give it a name of its own, on which the formula depends";
                return refuse("latex::derivative", "this stands for a formula", &by.span, hint);
            };
            if let Some(at) = self.graph.coordinate(leaf) {
                self.is_explicit(&value, shows, leaf, span)?;
                value = self.by_coordinate(value, at, span)?;
                continue;
            }
            value = self.spelled_out(value, span)?;
            // A field at a moving place depends on what moves there, and on no other state; nor on the time, unless that is a
            // coordinate.
            // One at a place that names a parameter depends on that parameter there.
            let role = self.scope.role(leaf.symbol);
            let fields = self.graph.fields(value.components.iter().copied());
            let hidden = |l: &&Leaf| match role {
                Some(Role::State | Role::Time) => self.graph.place(l.symbol).is_none(),
                Some(Role::Parameter) => !self.stands_at(l, leaf),
                _ => true,
            };
            if let Some(field) = fields.iter().find(hidden) {
                let message = format!("whether `{}` depends on it is not said", self.graph.name(field.symbol));
                let hint = "give the field a `formula` where it is declared, or make this a coordinate of it";
                return refuse("latex::derivative", message, &by.span, hint);
            }
            if self.scope.role(leaf.symbol) != Some(Role::Argument) {
                self.names_no_argument(&value, span)?;
            }
            match self.scope.role(leaf.symbol) {
                Some(Role::State | Role::Parameter | Role::Time | Role::Argument) if leaf.instant.is_none() => {}
                _ => {
                    let hint = "derivatives are by coordinates, states, their rates, and parameters";
                    return refuse("latex::derivative", "it is not clear what is held fixed", &by.span, hint);
                }
            }
            self.is_explicit(&value, shows, leaf, span)?;
            value = self.derived(value, span, |this, e| this.graph.partial_derivative(e, leaf))?;
        }
        Ok(value)
    }

    /// Whether a field is taken at a place that names this, and no coordinate: of `f(x+ct)` nobody says that it does not depend on c otherwise.
    fn stands_at(&self, field: &Leaf, leaf: Leaf) -> bool {
        let Some(place) = self.graph.place(field.symbol) else { return false };
        let leaves = self.graph.leaves_within(place.at.iter().map(|(_, e)| *e));
        leaves.contains(&leaf) && leaves.iter().all(|l| self.graph.coordinate(*l).is_none())
    }

    /// Whether a value depends on this parameter alone, of all that could change: its fields are at places that name nothing else.
    pub(super) fn depends_on_parameter(&self, t: &Tensor, leaf: Leaf) -> bool {
        let parameter = |l: &Leaf| self.scope.role(l.symbol) == Some(Role::Parameter) && l.instant.is_none();
        let only = |l: &Leaf| {
            let place = self.graph.place(l.symbol);
            place.is_some_and(|p| self.graph.leaves_within(p.at.iter().map(|(_, e)| *e)).iter().all(|l| *l == leaf))
        };
        let fields = self.graph.fields(t.components.iter().copied());
        let leaves = self.graph.leaves_within(t.components.iter().copied());
        parameter(&leaf)
            && fields.iter().all(|f| only(f) && self.stands_at(f, leaf))
            && leaves.iter().all(|l| fields.contains(l) || parameter(l))
    }

    /// In `\partial_i`: the index, one of the letters from i to n that nothing is called.
    pub(super) fn space_index(&self, by: &Node) -> Option<Name> {
        let NodeKind::Symbol(s) = &by.kind else { return None };
        let plain = s.sub.is_none() && s.sup.is_none() && s.arguments.is_none() && s.dots == 0;
        let letter = matches!(s.name.as_bytes(), [b'i'..=b'n']);
        (plain && letter && !self.scope.declares(&s.name)).then(|| s.name.clone())
    }

    /// The position of the coordinate along which `\partial_i` derives, for the value that the index has.
    fn along(&mut self, letter: &Name, span: &Range<usize>) -> Elaborated<usize> {
        let space = self.cartesian(span)?;
        let Some(value) = self.value_of(letter) else { return stray(letter, span) };
        let leaf = usize::from(value).checked_sub(1).and_then(|at| space.get(at));
        match leaf.and_then(|&leaf| self.graph.coordinate(leaf)) {
            Some(at) => Ok(at),
            None => refuse("latex::index", "an index out of range", span, "it runs over the coordinates of space"),
        }
    }

    /// The coordinates of space, where an index may run over them: they are Cartesian.
    pub(super) fn cartesian(&mut self, span: &Range<usize>) -> Elaborated<Vec<Leaf>> {
        let leaves = self.scope.space(self.graph);
        let polar = |l: &Leaf| self.graph.component_count(l.symbol) == 1 && POLAR.contains(&self.graph.name(l.symbol));
        if leaves.is_empty() || leaves.iter().any(polar) || self.scope.scale_factors(self.graph).is_some() {
            let message = "an index at `\\partial` runs over Cartesian coordinates of space, and there are none";
            return refuse("latex::derivative", message, span, "declare `x`, `y`, `z` with the role `coordinate`");
        }
        Ok(leaves)
    }

    /// In `\left(\frac{\partial U}{\partial T}\right)_V`: the coordinates in the subscript, if these are what it holds.
    pub(super) fn held(&self, base: &Node, sub: Option<&[SubItem]>) -> Option<Vec<Leaf>> {
        let NodeKind::Group(inner, _) = &base.kind else { return None };
        let one = |item: &SubItem| match item {
            SubItem::Name(letter) => self.scope.coordinate(letter),
            SubItem::Digit(_) | SubItem::Other(_) => None,
        };
        matches!(inner.kind, NodeKind::Partial { .. }).then(|| sub?.iter().map(one).collect())?
    }

    /// A partial derivative that says what is held fixed: all else on which it depends.
    pub(super) fn holding(&mut self, base: &Node, held: &[Leaf], span: &Range<usize>) -> Elaborated<Tensor> {
        let NodeKind::Group(inner, _) = &base.kind else { return self.tensor(base) };
        let NodeKind::Partial { of, by, .. } = &inner.kind else { return self.tensor(base) };
        let mut moved = Vec::new();
        for by in by {
            moved.extend(self.coordinate(by)?);
        }
        let value = self.tensor(of)?;
        let leaves = self.graph.leaves_within(value.components.iter().copied());
        let all = self.graph.coordinates().enumerate();
        let wrong = all.into_iter().find(|(at, c)| {
            let depends = leaves.iter().any(|l| l == c || self.graph.depends(l.symbol, *at));
            // To hold what it does not depend on changes nothing.
            let open = depends && !moved.contains(at) && !held.contains(c);
            open || moved.contains(at) && held.contains(c)
        });
        match wrong {
            None => self.tensor(base),
            Some((_, leaf)) => {
                let name = self.graph.leaf_latex(leaf);
                let message = format!("whether `{name}` is held fixed is not as its declaration has it");
                let hint = "let the field depend on what varies and what is held fixed, and on nothing else";
                refuse("latex::derivative", message, span, hint)
            }
        }
    }

    /// Refuses the derivative of something by what it does not name, unless it is defined by a formula that shows it.
    fn is_explicit(&self, t: &Tensor, shows: bool, by: Leaf, span: &Range<usize>) -> Elaborated<()> {
        let at = self.graph.coordinate(by);
        let leaves = self.graph.leaves_within(t.components.iter().copied());
        let named = leaves.iter().any(|l| *l == by || at.is_some_and(|at| self.graph.depends(l.symbol, at)));
        let moves = |l: &Leaf| self.scope.moves(l);
        let own = |l: &Leaf| self.graph.place(l.symbol).map(|p| p.field);
        if !named && leaves.iter().filter_map(own).any(|field| at.is_some_and(|at| self.graph.depends(field, at))) {
            let message = "is this the derivative at a place, or that of a value?";
            let hint = r"write `\left.\frac{\partial u}{\partial x}\right|_{x=0}`, or `u_x(0,t)`";
            return refuse("latex::ambiguous", message, span, hint);
        }
        // A formula that names neither it nor anything that could hide it: its derivative is 0 for everybody to see.
        if named || shows && !leaves.iter().any(|l| moves(l) && self.graph.coordinate(by).is_some()) {
            return Ok(());
        }
        let message = format!("this does not show how it depends on `{}`", self.graph.leaf_latex(by));
        let hint = "declare it as a field of its coordinates, or as an abbreviation with a formula";
        refuse("latex::derivative", message, span, hint)
    }

    /// Observables replaced by what they stand for.
    pub(super) fn spelled_out(&mut self, mut t: Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        for _ in 0..DEEPEST_FORMULAS {
            let leaves = self.graph.leaves_within(t.components.iter().copied());
            let scope = self.scope;
            let hidden = |l: &Leaf| scope.role(l.symbol) == Some(Role::Observable);
            let Some(first) = leaves.iter().find(|l| hidden(l)) else { return Ok(t) };
            if let Some(other) = leaves.iter().find(|l| hidden(l) && (l.rate > 0 || l.instant.is_some())) {
                let message = format!("`{}` hides what it depends on", self.graph.leaf_latex(*other));
                return refuse("latex::derivative", message, span, "write it out");
            }
            let formula = |l: Leaf| {
                let definition = if hidden(&l) { scope.definition(l.symbol) } else { None };
                definition.and_then(|d| d.components.get(usize::from(l.component)).copied())
            };
            if formula(*first).is_none() {
                break;
            }
            let components = t.components.iter().map(|&e| self.graph.substitute(e, |_, l| formula(l))).collect();
            t = Tensor { shape: t.shape, components };
        }
        refuse("latex::derivative", "this hides what it depends on", span, "write it out")
    }
}
