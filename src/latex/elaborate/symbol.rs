//! Symbols: what they refer to, at which time, with which rates.

use std::ops::Range;

use super::super::complex::Pair;
use super::super::name;
use super::super::scope::{Found, REFUSED, Role};
use super::super::syntax::{Node, SubItem, SymbolNode, indices};
use super::super::tensor;
use super::super::write::subscript;
use super::scripts::is_integer;
use super::{Elaborated, Elaborator, Value, refuse, stray};
use expr::{Expr, Graph, Leaf, Shape, Symbol, Tensor};

impl<'a> Elaborator<'a> {
    /// ε and δ, unless they are declared, with the right number of indices: to where their indices run, if that is known.
    pub(super) fn builtin(&self, s: &SymbolNode) -> Option<Option<u16>> {
        let count = indices(s.sub.as_deref()?).len();
        if self.scope.declares(&s.name) || s.dots > 0 || s.arguments.is_some() {
            return None;
        }
        match s.name.as_str() {
            "\\epsilon" | "\\varepsilon" if count == 3 => Some(Some(3)),
            "\\delta" if count == 2 => Some(None),
            _ => None,
        }
    }

    pub(super) fn resolve(&self, s: &SymbolNode, span: &Range<usize>) -> Elaborated<Found<'a>> {
        let arguments = s.arguments.as_ref().map(|_| s.arguments_text.as_str());
        if self.scope.is_refused(&s.name, s.sub.as_deref()) {
            return refuse("latex::unknown-symbol", REFUSED, span, "");
        }
        let found = self.scope.find(&s.name, s.sub.as_deref(), arguments);
        let whole = s.sub.as_ref().and_then(|sub| self.scope.numbered(&s.name, sub, found.as_ref()));
        if let Some(whole) = whole {
            let message = format!("is this a component of `{whole}`, or another of several?");
            let hint = format!("write `({whole})_…` for the component, or declare what is meant with its subscript");
            return refuse("latex::ambiguous", message, span, hint);
        }
        if let Some(found) = found {
            return Ok(found);
        }
        let shown = name::to_latex(&s.name) + &s.sub.as_deref().map(subscript).unwrap_or_default();
        if self.scope.declares(&s.name) {
            let message = format!("`{shown}` is not declared with this subscript or these arguments");
            return refuse("latex::unknown-symbol", message, span, "declare it under [symbols] as it is written here");
        }
        let base = s.name.trim_end_matches('\'');
        if base.len() < s.name.len() && self.scope.is_moving(base, s.sub.as_deref()) {
            let hint =
                r"declare it under [symbols], or write the derivative by the time as `\dot x` or `\frac{dx}{dt}`";
            return refuse("latex::unknown-symbol", format!("`{shown}` is not declared"), span, hint);
        }
        let hint = match self.scope.nearest(&s.name) {
            Some(near) => format!("declare it under [symbols], or did you mean `{near}`?"),
            None => "declare it under [symbols]".to_owned(),
        };
        refuse("latex::unknown-symbol", format!("`{shown}` is not declared"), span, hint)
    }

    pub(super) fn index_values(&self, items: &[SubItem], span: &Range<usize>) -> Elaborated<Vec<u16>> {
        let mut out = Vec::new();
        for item in items {
            out.push(match item {
                SubItem::Digit(d) => *d,
                SubItem::Name(letter) => match self.value_of(letter) {
                    Some(v) => v,
                    None => return stray(letter, span),
                },
                SubItem::Other(c) => {
                    let hint = "declare a symbol with this subscript";
                    return refuse("latex::index", format!("`{c}` is not an index"), span, hint);
                }
            });
        }
        Ok(out)
    }

    pub(super) fn symbol(&mut self, s: &SymbolNode, span: &Range<usize>) -> Elaborated<Tensor> {
        if let Some(extent) = self.builtin(s) {
            let values = self.index_values(&indices(s.sub.as_deref().unwrap_or(&[])), span)?;
            if values.iter().any(|&v| v == 0 || extent.is_some_and(|n| v > n)) {
                return refuse("latex::index", "an index out of range", span, "indices are counted from 1");
            }
            let entry = match values.as_slice() {
                [i, j] => i64::from(i == j),
                [i, j, k] => levi_civita(*i, *j, *k),
                _ => 0,
            };
            let e = if entry == 0 { self.graph.absent() } else { self.graph.integer(entry) };
            return self.scripted_tensor(Tensor::scalar(e), None, s.sup.as_deref(), false, span);
        }
        if self.is_imaginary_unit(s, span)? {
            let unit = Pair::unit(self.graph).scalar();
            return self.scripted_tensor(unit, None, s.sup.as_deref(), false, span);
        }
        let found = self.resolve(s, span)?;
        let (symbol, role, conjugate) = (found.symbol, found.role, found.conjugate);
        let (items, formal, derivatives) = (found.indices, found.formal, found.derivatives);
        let literal = found.literal_arguments;
        // A function of what is no coordinate is taken at its own places, where nothing else is written.
        let own_place: Vec<(Leaf, Expr)> = match s.arguments.is_some() && !literal {
            true => Vec::new(),
            false => found.coordinates.iter().copied().zip(found.place.iter().copied()).collect(),
        };
        // What is not applied to anything is the same wherever it stands: with indices it is asked for very often.
        let keeps = formal.is_empty() && role != Role::Field;
        let known = self.bases.get(&(symbol, s.dots)).filter(|_| keeps).cloned();
        let mut base = match known {
            Some(base) => base,
            None => {
                let mut base = match found.definition {
                    Some(t) if matches!(role, Role::Abbreviation | Role::Field) => t.clone(),
                    _ => self.components_of(symbol),
                };
                if !formal.is_empty() {
                    base = self.apply(base, formal, s.arguments.as_deref().unwrap_or(&[]), span)?;
                }
                if s.dots > 0 {
                    self.has_rate(role, span)?;
                    if role == Role::Time {
                        return refuse("latex::dot", "the rate of the time is 1", span, "leave it out");
                    }
                }
                if !own_place.is_empty() && !s.primed {
                    base = self.taken_at(base, &own_place, span)?;
                }
                for _ in 0..s.dots {
                    base = match role {
                        Role::Field if !s.primed && !found.place.is_empty() => self.time_derivative(base, span)?,
                        Role::Field => self.derivative_of_field(base, (found.coordinates, s.primed), span)?,
                        _ => self.time_derivative(base, span)?,
                    };
                }
                if !own_place.is_empty() && s.primed {
                    base = self.taken_at(base, &own_place, span)?;
                }
                if keeps {
                    self.bases.insert((symbol, s.dots), base.clone());
                }
                base
            }
        };
        for leaf in derivatives {
            if let Some(at) = self.graph.coordinate(leaf) {
                base = self.by_coordinate(base, at, span)?;
            }
        }
        match s.arguments.as_deref() {
            Some(places) if role == Role::Field && !literal => {
                base = self.at_place(base, found.coordinates, places, span)?;
            }
            Some([argument]) if !literal && formal.is_empty() => {
                let instant = self.scalar(argument)?;
                base = self.at_instant(base, instant, &argument.span)?;
            }
            Some([_, _, ..]) if !literal && formal.is_empty() => {
                return refuse("latex::arity", "a value is taken at one time", span, "");
            }
            _ => {}
        }
        if conjugate {
            base = self.conjugate(&base, span)?;
        }
        let applied = s.arguments.is_some() && !literal;
        if applied && base.shape.rank() == 0 && s.sup.as_deref().is_some_and(|sup| is_integer(sup, -1)) {
            let message = "is this the inverse function, or one over its value?";
            return refuse("latex::ambiguous", message, span, r"write a fraction, `\frac{1}{f(x)}`");
        }
        let sub = (!items.is_empty()).then_some(items.as_slice());
        // One index on a diagonal matrix is its diagonal.
        if let (Some([_]), true, &[n, _]) = (sub, self.graph.is_diagonal(symbol), base.shape.extents()) {
            let diagonal = (0..usize::from(n)).filter_map(|i| base.components.get(i * (usize::from(n) + 1)).copied());
            base = Tensor { shape: Shape::vector(n), components: diagonal.collect() };
        }
        self.scripted_tensor(base, sub, s.sup.as_deref(), s.sup_first, span)
    }

    fn scripted_tensor(
        &mut self,
        base: Tensor,
        sub: Option<&[SubItem]>,
        sup: Option<&Node>,
        sup_first: bool,
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        match self.scripted(Value::Tensor(base), sub, sup, sup_first, span)? {
            Value::Tensor(t) => Ok(t),
            Value::Identity(_) => refuse("latex::shape", "a matrix of unknown size", span, ""),
        }
    }

    /// The stored components of a symbol as a tensor: off the diagonal of a diagonal matrix there is nothing.
    fn components_of(&mut self, symbol: Symbol) -> Tensor {
        let count = self.graph.component_count(symbol);
        let components: Vec<Expr> = (0..count).map(|c| self.graph.component(symbol, c as u16)).collect();
        if self.graph.is_diagonal(symbol) {
            return tensor::diagonal(self.graph, &components);
        }
        Tensor { shape: self.graph.shape(symbol).clone(), components }
    }

    /// Refuses the rate of a parameter: it is a constant by declaration, so the dot is a slip. What an abbreviation stands
    /// for may happen not to move.
    pub(super) fn has_rate(&self, role: Role, span: &Range<usize>) -> Elaborated<()> {
        match role {
            Role::Coordinate => {
                let hint = "declare it as a state, if it is the place of something that moves";
                refuse("latex::dot", "a coordinate does not depend on time", span, hint)
            }
            Role::Parameter | Role::Argument => {
                let hint = "a parameter has no rate; leave the derivative out";
                refuse("latex::dot", "this does not depend on time", span, hint)
            }
            Role::Time | Role::State | Role::Observable | Role::Abbreviation | Role::Field => Ok(()),
        }
    }

    fn apply(
        &mut self,
        body: Tensor,
        formal: &[(Symbol, Shape)],
        arguments: &[Node],
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        if arguments.len() != formal.len() {
            let message = format!("the function has {} arguments, not {}", formal.len(), arguments.len());
            return refuse("latex::arity", message, span, "");
        }
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.scalar(argument)?);
        }
        let place = |leaf: Leaf| formal.iter().position(|(s, _)| *s == leaf.symbol);
        let components = body
            .components
            .into_iter()
            .map(|e| self.graph.rewrite(e, |_, leaf| place(leaf).and_then(|i| values.get(i).copied())))
            .collect();
        Ok(Tensor { shape: body.shape, components })
    }

    /// A fixed time with what defined names stand for: one time has one name.
    fn without_names(&mut self, mut instant: Expr) -> Expr {
        let scope = self.scope;
        // Definitions are acyclic.
        loop {
            let written = self.graph.substitute(instant, |_, leaf| {
                scope.definition(leaf.symbol)?.components.get(usize::from(leaf.component)).copied()
            });
            if written == instant {
                return instant;
            }
            instant = written;
        }
    }

    /// The value at a time: the present one for the time itself.
    pub(super) fn at_instant(&mut self, t: Tensor, instant: Expr, span: &Range<usize>) -> Elaborated<Tensor> {
        let time = self.scope.time();
        if let Some(time) = time
            && self.graph.leaf(time) == instant
        {
            return Ok(t);
        }
        if self.moves(instant) {
            let hint = "write a number, a parameter, or the time";
            return refuse("latex::instant", "this time depends on time itself", span, hint);
        }
        if self.graph.leaves_within([instant]).contains(&self.scope.branch_sign()) {
            return refuse("latex::instant", "a time with ±", span, "write the two times");
        }
        let instant = self.without_names(instant);
        let scope = self.scope;
        let moving = |leaf: &Leaf| leaf.instant.is_none() && scope.moves(leaf);
        let fixed = |graph: &mut Graph, leaf: Leaf| {
            if Some(leaf) == time {
                return Some(instant);
            }
            moving(&leaf).then(|| graph.leaf(Leaf { instant: Some(instant), ..leaf }))
        };
        let components = t.components.into_iter().map(|e| self.graph.substitute(e, fixed)).collect();
        Ok(Tensor { shape: t.shape, components })
    }
}

fn levi_civita(i: u16, j: u16, k: u16) -> i64 {
    let (i, j, k) = (i64::from(i), i64::from(j), i64::from(k));
    (j - i) * (k - j) * (k - i) / 2
}
