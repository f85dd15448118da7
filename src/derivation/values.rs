//! Values of symbols: numbers, formulas, and arrays of them.

use std::collections::HashMap;

use toml::de::DeValue;

use super::formula::Written;
use super::load::Loader;
use super::number::rational;
use super::table::{Value, as_printed, literal_of};
use expr::{Expr, Leaf, Shape, Symbol, Tensor};
use latex::Scope;

/// The values of symbols, and of their rates by order, that a formula may use: one expression for each stored component.
pub(super) type Known = HashMap<(Symbol, u8), Vec<Expr>>;

impl Loader<'_> {
    /// The components of a symbol, as a number, a formula, or an array of them gives them.
    pub fn components(&mut self, value: &Value<'_>, symbol: Symbol, scope: &Scope) -> Option<Written<Vec<Expr>>> {
        let graph = &self.out.graph;
        let extents = match (graph.is_diagonal(symbol), graph.shape(symbol).extents()) {
            (true, [n, ..]) => vec![*n],
            _ => graph.shape(symbol).real_extents().to_vec(),
        };
        let complex = graph.shape(symbol).is_complex();
        let span = value.span();
        let text = self.problems.source.text.get(span.clone()).unwrap_or_default();
        let (text, span) = match literal_span(text) {
            Some(inner) => (text[inner.clone()].to_owned(), span.start + inner.start..span.start + inner.end),
            None => (text.to_owned(), span),
        };
        let value = match value.get_ref() {
            DeValue::Array(_) => {
                let mut out = Vec::new();
                self.array_components(value, symbol, &extents, scope, &mut out).then_some(out)
            }
            DeValue::String(_) => self.formula_components(value, symbol, scope),
            _ if extents.is_empty() && complex => self.complex_component(value, symbol, scope),
            _ if extents.is_empty() => self.scalar_component(value, scope).map(|e| vec![e]),
            _ => {
                self.wrong_components(value, symbol);
                None
            }
        }?;
        Some(Written { text: as_printed(&text), span, value })
    }

    /// A formula for all components at once.
    fn formula_components(&mut self, value: &Value<'_>, symbol: Symbol, scope: &Scope) -> Option<Vec<Expr>> {
        let formula = literal_of(&mut self.problems, value, "the value")?;
        let mut read = self.quantity(&formula, scope)?;
        let zero = self.out.graph.integer(0);
        let graph = &self.out.graph;
        let shape = graph.shape(symbol);
        // Something real stands for a complex number without an imaginary part.
        if shape.is_complex() && read.value.shape == shape.real() {
            let parts = read.value.components.iter().flat_map(|&e| [e, zero]).collect();
            read.value = Tensor { shape: shape.clone(), components: parts };
        }
        if read.value.shape != *shape {
            let message = format!("`{}` is a {shape}, this formula a {}", graph.name(symbol), read.value.shape);
            self.problems.note("derivation::wrong-components", read.span, message);
            return None;
        }
        if !graph.is_diagonal(symbol) {
            return Some(read.value.components);
        }
        let n = graph.component_count(symbol);
        let on_diagonal = |i: &usize| i / n == i % n;
        if let Some(off) = (0..n * n).find(|i| !on_diagonal(i) && !graph.is_zero(read.value.components[*i])) {
            let message = format!(
                "`{}` is diagonal, row {} column {} of this is not 0",
                graph.name(symbol),
                off / n + 1,
                off % n + 1
            );
            self.problems.note("derivation::wrong-components", read.span, message);
            return None;
        }
        Some((0..n).map(|i| read.value.components[i * n + i]).collect())
    }

    /// The components of an array; extents outermost first. Whether all could be read.
    fn array_components(
        &mut self,
        value: &Value<'_>,
        symbol: Symbol,
        extents: &[u16],
        scope: &Scope,
        out: &mut Vec<Expr>,
    ) -> bool {
        let Some((&n, inner)) = extents.split_first() else {
            if self.out.graph.shape(symbol).is_complex() {
                let parts = self.complex_component(value, symbol, scope);
                return parts.map(|parts| out.extend(parts)).is_some();
            }
            return match value.get_ref() {
                DeValue::Array(_) => self.wrong_components(value, symbol),
                _ => self.scalar_component(value, scope).map(|e| out.push(e)).is_some(),
            };
        };
        match value.get_ref() {
            DeValue::Array(items) if items.len() == usize::from(n) => {
                let mut good = true;
                for item in items.iter() {
                    good &= self.array_components(item, symbol, inner, scope, out);
                }
                good
            }
            _ => self.wrong_components(value, symbol),
        }
    }

    /// The real and the imaginary part of a number: `[a, b]`, a real number, or a formula.
    fn complex_component(&mut self, value: &Value<'_>, symbol: Symbol, scope: &Scope) -> Option<Vec<Expr>> {
        match value.get_ref() {
            DeValue::Array(parts) if parts.len() == 2 => {
                let both: Vec<Option<Expr>> = parts.iter().map(|part| self.scalar_component(part, scope)).collect();
                both.into_iter().collect()
            }
            DeValue::Array(_) => {
                self.wrong_components(value, symbol);
                None
            }
            DeValue::String(_) => {
                let formula = literal_of(&mut self.problems, value, "the value")?;
                let read = self.quantity(&formula, scope)?;
                if read.value.shape == Shape::scalar().complexified() {
                    return Some(read.value.components);
                }
                let zero = self.out.graph.integer(0);
                let scalar = read.value.as_scalar();
                if scalar.is_none() {
                    let message = format!("one number is needed here, this formula is a {}", read.value.shape);
                    self.problems.note("derivation::wrong-components", read.span, message);
                }
                scalar.map(|e| vec![e, zero])
            }
            _ => {
                let zero = self.out.graph.integer(0);
                self.scalar_component(value, scope).map(|e| vec![e, zero])
            }
        }
    }

    /// A number, or a formula for one.
    pub fn scalar_component(&mut self, value: &Value<'_>, scope: &Scope) -> Option<Expr> {
        if let Some(number) = rational(&mut self.problems, value) {
            return number.ok().map(|r| self.out.graph.constant(r));
        }
        if self.is_guess(value) {
            return self.guess(value, scope);
        }
        if !value.get_ref().is_str() {
            self.problems.wrong_type(value, "a value", "a number or a formula in single quotes");
            return None;
        }
        let formula = literal_of(&mut self.problems, value, "the value")?;
        let read = self.quantity(&formula, scope)?;
        let scalar = read.value.as_scalar();
        if scalar.is_none() {
            let message = format!("one number is needed here, this formula is a {}", read.value.shape);
            self.problems.note("derivation::wrong-components", read.span, message);
        }
        scalar
    }

    fn wrong_components(&mut self, value: &Value<'_>, symbol: Symbol) -> bool {
        let graph = &self.out.graph;
        let (name, shape) = (graph.name(symbol), graph.shape(symbol));
        let (message, hint) = match (graph.is_diagonal(symbol), shape.real_extents()) {
            (_, []) if shape.is_complex() => {
                let hint = "write a formula in single quotes, a number, or [real part, imaginary part]";
                (format!("`{name}` is one complex number"), hint.to_owned())
            }
            (true, [n, ..]) => (
                format!("`{name}` is a diagonal matrix with {n} numbers on its diagonal"),
                format!("write [a, b, …] with {n} numbers or formulas"),
            ),
            (_, []) => (format!("`{name}` is one number"), "write a number, or a formula in single quotes".to_owned()),
            (_, [n]) => (
                format!("`{name}` is a {shape}"),
                format!("write [a, b, …] with {n} numbers or formulas, or one formula"),
            ),
            (_, [rows, columns, ..]) => (
                format!("`{name}` is a {shape}"),
                format!("write {rows} rows [[a, …], …] of {columns} numbers or formulas, or one formula"),
            ),
        };
        self.problems.note("derivation::wrong-components", value.span(), message).hint(hint);
        false
    }

    /// `e` with the known values put in, and definitions written out, until only `free` leaves remain.
    ///
    /// # Errors
    /// A leaf that has no value.
    pub fn resolve(
        &mut self,
        e: Expr,
        known: &Known,
        scope: &Scope,
        free: &dyn Fn(&Scope, Leaf) -> bool,
    ) -> Result<Expr, Leaf> {
        let mut e = e;
        loop {
            let graph = &self.out.graph;
            // What is known of a field is known of it at any place; what stands in the place must be known, too.
            let there = |l: Leaf| Leaf { symbol: graph.field_of(l.symbol), ..l };
            let leaves: Vec<Leaf> = graph.leaves_within([e]).into_iter().map(there).collect();
            let value = |leaf: Leaf| -> Option<Expr> {
                if leaf.instant.is_some() {
                    return None;
                }
                let values = known.get(&(leaf.symbol, leaf.rate)).map(Vec::as_slice);
                let defined = || scope.definition(leaf.symbol).filter(|_| leaf.rate == 0);
                let values = values.or_else(|| defined().map(|t| t.components.as_slice()))?;
                values.get(usize::from(leaf.component)).copied()
            };
            if let Some(bad) = leaves.iter().find(|&&l| !free(scope, l) && value(l).is_none()) {
                return Err(*bad);
            }
            if leaves.iter().all(|&l| free(scope, l)) {
                return Ok(e);
            }
            e = self.out.graph.substitute(e, |_, leaf| if free(scope, leaf) { None } else { value(leaf) });
        }
    }

    /// How a formula writes a leaf: `\dot R_{12}`.
    pub fn leaf_name(&self, leaf: Leaf) -> String {
        let graph = &self.out.graph;
        let name = graph.name(leaf.symbol);
        let indices: Vec<String> =
            graph.written_indices(leaf.symbol, leaf.component).iter().map(u16::to_string).collect();
        let index = if indices.is_empty() { String::new() } else { format!("_{{{}}}", indices.concat()) };
        let dots = match leaf.rate {
            0 => "",
            1 => r"\dot ",
            2 => r"\ddot ",
            _ => "a derivative of ",
        };
        let instant = if leaf.instant.is_some() { " at a fixed time" } else { "" };
        let derived = if leaf.partials.is_none() { "" } else { "a derivative of " };
        let whole = format!("{derived}{dots}{name}{index}{instant}");
        graph.part(leaf).map_or(whole.clone(), |part| part.of(&whole))
    }
}

/// The part of a literal string between its quotes.
fn literal_span(raw: &str) -> Option<std::ops::Range<usize>> {
    let quotes = if raw.starts_with("'''") { 3 } else { usize::from(raw.starts_with('\'')) };
    let inner = raw.get(quotes..raw.len().checked_sub(quotes)?)?;
    let start = quotes + inner.len() - inner.trim_start().len();
    (quotes > 0).then(|| start..start + inner.trim().len())
}
