//! Which indices are summed over, and where.
//!
//! The parts of a formula that are *one piece* are: a side, a term of a sum, what stands in parentheses, a denominator, a
//! radicand, an exponent, the argument of a function, an entry of a matrix. An index that occurs at least twice in a piece
//! is summed over there; an index that occurs once is handed on to what the piece is a part of. An index that is summed
//! over inside a piece and occurs outside of it in the same term would have two meanings, and is refused.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::super::name;
use super::super::syntax::{Name, Node, NodeKind, SubItem, SymbolNode, indices};
use super::{Elaborated, Elaborator, refuse};
use expr::Rational;

/// One occurrence of an index letter.
#[derive(Clone, Debug)]
pub(super) struct Occurrence {
    pub letter: Name,
    pub span: Range<usize>,
}

/// The indices of a part of a formula.
#[derive(Default)]
struct Usage {
    /// Handed on, with multiplicity.
    open: Vec<Occurrence>,
    /// Used up inside: summed over, or repeated there although the left side has them.
    closed: BTreeSet<Name>,
}

impl Usage {
    /// The same with every index counted twice, side by side.
    fn twice(mut self) -> Usage {
        self.open = self.open.into_iter().flat_map(|o| [o.clone(), o]).collect();
        self
    }

    /// Adds the indices of another part of the same term.
    fn join(&mut self, other: Usage) -> Elaborated<()> {
        let clash =
            |closed: &BTreeSet<Name>, open: &[Occurrence]| open.iter().find(|o| closed.contains(&o.letter)).cloned();
        if let Some(o) = clash(&self.closed, &other.open).or_else(|| clash(&other.closed, &self.open)) {
            let shown = name::to_latex(&o.letter);
            let message =
                format!("the index `{shown}` is repeated in a part of this term and stands outside of it too");
            return refuse("latex::ambiguous", message, &o.span, "use another letter for the sum");
        }
        self.open.extend(other.open);
        self.closed.extend(other.closed);
        Ok(())
    }
}

impl Elaborator<'_> {
    /// Indices that an expression leaves free: each once, in order of appearance. What it sums over is noted.
    pub(super) fn free(&mut self, node: &Node) -> Elaborated<Vec<Occurrence>> {
        Ok(self.piece(node)?.open)
    }

    /// A node that is one piece: each index that is left occurs once.
    fn piece(&mut self, node: &Node) -> Elaborated<Usage> {
        let mut usage = self.usage(node)?;
        let mut counts: BTreeMap<Name, usize> = BTreeMap::new();
        for o in &usage.open {
            *counts.entry(o.letter.clone()).or_default() += 1;
        }
        let mut summed = Vec::new();
        for o in &usage.open {
            let repeated = counts.get(&o.letter).is_some_and(|n| *n > 1);
            if repeated && !self.fixed.contains(&o.letter) && !summed.contains(&o.letter) {
                summed.push(o.letter.clone());
            }
        }
        for letter in &summed {
            self.not_too_often(letter, &usage.open)?;
        }
        usage.open.retain(|o| !summed.contains(&o.letter));
        let mut seen = BTreeSet::new();
        usage.open.retain(|o| seen.insert(o.letter.clone()));
        usage.closed.extend(counts.into_iter().filter(|(_, n)| *n > 1).map(|(letter, _)| letter));
        if summed.is_empty() {
            self.sums.remove(&std::ptr::from_ref(node));
        } else {
            self.sums.insert(std::ptr::from_ref(node), summed);
        }
        Ok(usage)
    }

    /// Refuses an index at four places of one piece: that could be the product of two sums.
    fn not_too_often(&self, letter: &Name, open: &[Occurrence]) -> Elaborated<()> {
        let mut spans: Vec<&Range<usize>> = open.iter().filter(|o| o.letter == *letter).map(|o| &o.span).collect();
        spans.dedup();
        match spans.get(3) {
            Some(fourth) => {
                let message = format!("the index `{}` stands at four places of one term", name::to_latex(letter));
                let hint = "use different letters for different sums, or parentheses around a sum";
                refuse("latex::ambiguous", message, fourth, hint)
            }
            None => Ok(()),
        }
    }

    fn pieces<'n>(&mut self, nodes: impl IntoIterator<Item = &'n Node>) -> Elaborated<Usage> {
        let mut all = Usage::default();
        for node in nodes {
            let piece = self.piece(node)?;
            all.join(piece)?;
        }
        Ok(all)
    }

    fn usage(&mut self, node: &Node) -> Elaborated<Usage> {
        match &node.kind {
            NodeKind::Number(_)
            | NodeKind::Pi
            | NodeKind::Euler { .. }
            | NodeKind::Identity
            | NodeKind::Conjugation { .. } => Ok(Usage::default()),
            NodeKind::Symbol(s) => self.symbol_usage(s, &node.span),
            NodeKind::Group(inner, _) => self.piece(inner),
            NodeKind::Scripted { base, sub, sup, .. } => {
                let sub = sub.as_deref().map(indices);
                let mut usage = self.piece(base)?;
                if let Some(items) = sub.as_deref().filter(|_| self.held(base, sub.as_deref()).is_none()) {
                    usage.join(Usage {
                        open: self.lowered(base, &usage.open, items, &node.span)?,
                        closed: BTreeSet::new(),
                    })?;
                }
                if sup.as_deref().is_some_and(is_power) {
                    usage = usage.twice();
                }
                if let Some(sup) = sup.as_deref().filter(|s| !self.is_transpose(s)) {
                    let sup = self.piece(sup)?;
                    usage.join(sup)?;
                }
                Ok(usage)
            }
            NodeKind::Sum(terms) => self.sum_usage(terms.iter().map(|(_, term)| term)),
            NodeKind::Product(parts) | NodeKind::Dot(parts) => {
                let mut all = Usage::default();
                for part in parts {
                    let usage = self.usage(part)?;
                    all.join(usage)?;
                }
                Ok(all)
            }
            NodeKind::Cross { left, right, bracket } => {
                if *bracket {
                    return self.pieces([&**left, right]);
                }
                let (mut usage, right) = (self.usage(left)?, self.usage(right)?);
                usage.join(right)?;
                Ok(usage)
            }
            NodeKind::Quotient { top, bottom, .. } => {
                let (mut usage, below) = (self.usage(top)?, self.piece(bottom)?);
                usage.join(below)?;
                Ok(usage)
            }
            NodeKind::Derivative { of, by, .. } => self.pieces([&**of, by]),
            NodeKind::Partial { of, by, .. } => {
                let mut usage = self.piece(of)?;
                for by in by {
                    let own = match self.space_index(by) {
                        Some(letter) => {
                            let extent = self.cartesian(&by.span)?.len() as u16;
                            self.note_extent(&letter, extent, &by.span)?;
                            let open = vec![Occurrence { letter, span: by.span.clone() }];
                            Usage { open, closed: BTreeSet::new() }
                        }
                        None => self.piece(by)?,
                    };
                    usage.join(own)?;
                }
                Ok(usage)
            }
            NodeKind::Nabla { .. } | NodeKind::Poisson(..) | NodeKind::Variation { .. } => self.pieces(node.children()),
            NodeKind::At { of, time, .. } => self.pieces([&**of, time]),
            NodeKind::Factorial(a)
            | NodeKind::Differential { of: a, .. }
            | NodeKind::Root(a, _)
            | NodeKind::Exponential { exponent: a, .. }
            | NodeKind::Conjugate(a)
            | NodeKind::Absolute(a) => self.piece(a),
            NodeKind::Limit(a, _) => self.piece(a),
            NodeKind::Function(_, power, arguments) => {
                let usage = self.pieces(arguments)?;
                Ok(if power.is_some() { usage.twice() } else { usage })
            }
            NodeKind::Tuple(parts) => self.sum_usage(parts),
            NodeKind::Matrix(rows) => self.sum_usage(rows.iter().flatten()),
        }
    }

    /// Terms of a sum, or entries of an array: all have the same free indices.
    fn sum_usage<'n>(&mut self, terms: impl IntoIterator<Item = &'n Node>) -> Elaborated<Usage> {
        let mut all = Usage::default();
        let mut first: Option<BTreeSet<Name>> = None;
        let mut plainly: BTreeSet<Name> = BTreeSet::new();
        for term in terms {
            let usage = self.piece(term)?;
            let names: BTreeSet<Name> =
                usage.open.iter().map(|o| o.letter.clone()).filter(|l| !self.loose.contains(l)).collect();
            match &first {
                Some(before) if *before != names && !term.is_zero() => {
                    let message = format!(
                        "this term has the free indices {}, the terms before it {}",
                        list(&names),
                        list(before)
                    );
                    let hint = "every term of a sum has the same free indices";
                    return refuse("latex::index", message, &term.span, hint);
                }
                None if !term.is_zero() => first = Some(names),
                _ => {}
            }
            for o in usage.open {
                if !usage.closed.contains(&o.letter) {
                    plainly.insert(o.letter.clone());
                }
                if !all.open.iter().any(|a| a.letter == o.letter) {
                    all.open.push(o);
                }
            }
            all.closed.extend(usage.closed);
        }
        // `x_i(r_i-a_ix_i)`: the term r_i shows that the index is not summed over in the other.
        all.closed.retain(|l| !(plainly.contains(l) && self.fixed.contains(l)));
        Ok(all)
    }

    /// Occurrences in the subscript of something that is not a symbol.
    fn lowered(
        &mut self,
        base: &Node,
        inside: &[Occurrence],
        items: &[SubItem],
        span: &Range<usize>,
    ) -> Elaborated<Vec<Occurrence>> {
        let mut open = Vec::new();
        if !items.iter().any(|i| matches!(i, SubItem::Name(_))) {
            return Ok(open);
        }
        // The shape does not depend on the values of indices inside.
        let before = self.values.len();
        self.values.extend(inside.iter().map(|o| (o.letter.clone(), 1)));
        let shape = self.tensor(base).map(|t| t.shape);
        self.values.truncate(before);
        let shape = shape?;
        for (axis, item) in items.iter().enumerate() {
            if let SubItem::Name(letter) = item {
                self.index_letter(letter, span)?;
                if let Some(&extent) = shape.real_extents().get(axis) {
                    self.note_extent(letter, extent, span)?;
                }
                open.push(Occurrence { letter: letter.clone(), span: span.clone() });
            }
        }
        Ok(open)
    }

    fn symbol_usage(&mut self, s: &SymbolNode, span: &Range<usize>) -> Elaborated<Usage> {
        let mut usage = Usage::default();
        let (items, extents) = match self.builtin(s) {
            Some(extent) => (indices(s.sub.as_deref().unwrap_or_default()), vec![extent; 3]),
            None if self.is_imaginary_unit(s, span)? => (Vec::new(), Vec::new()),
            None => {
                let found = self.resolve(s, span)?;
                let items = found.indices.clone();
                let shape = match found.definition {
                    Some(t) => t.shape.clone(),
                    None => self.graph.shape(found.symbol).clone(),
                };
                // One index on a diagonal matrix is its diagonal.
                (items, shape.real_extents().iter().map(|&n| Some(n)).collect())
            }
        };
        for (axis, item) in items.iter().enumerate() {
            if let SubItem::Name(letter) = item {
                self.index_letter(letter, span)?;
                if let Some(Some(extent)) = extents.get(axis) {
                    self.note_extent(letter, *extent, span)?;
                }
                usage.open.push(Occurrence { letter: letter.clone(), span: span.clone() });
            }
        }
        if s.sup.as_deref().is_some_and(is_power) {
            usage = usage.twice();
        }
        if let Some(sup) = s.sup.as_deref()
            && !self.is_transpose(sup)
        {
            let sup = self.piece(sup)?;
            usage.join(sup)?;
        }
        if let Some(arguments) = &s.arguments
            && !self.resolve(s, span).is_ok_and(|f| f.literal_arguments)
        {
            let arguments = self.pieces(arguments)?;
            usage.join(arguments)?;
        }
        Ok(usage)
    }

    /// Refuses letters that are labels in print: `v_x`, `v_\theta`.
    fn index_letter(&self, letter: &Name, span: &Range<usize>) -> Elaborated<()> {
        let shown = name::to_latex(letter);
        if !name::is_index(letter) {
            let message = format!("`{shown}` is read as a label here, not as an index");
            let hint = "number the components 1, 2, 3, or declare a symbol with this subscript";
            return refuse("latex::index", message, span, hint);
        }
        if self.scope.is_time_or_moving(letter) {
            let message = format!("`{shown}` is declared as something that depends on time, so it is no clear index");
            return refuse("latex::index", message, span, "use another letter");
        }
        Ok(())
    }

    /// Index letters in places of a name, as in `I_{(n-k)}`, anywhere in a side.
    pub(super) fn places(&self, side: &Node) -> BTreeSet<Name> {
        let mut out = BTreeSet::new();
        let mut stack = vec![side];
        while let Some(node) = stack.pop() {
            stack.extend(node.children());
            if let NodeKind::Symbol(s) = &node.kind
                && let Ok(found) = self.resolve(s, &node.span)
            {
                out.extend(found.indices.into_iter().take(found.places).filter_map(|i| match i {
                    SubItem::Name(letter) => Some(letter),
                    _ => None,
                }));
            }
        }
        out
    }

    fn note_extent(&mut self, letter: &Name, extent: u16, span: &Range<usize>) -> Elaborated<()> {
        match self.extents.insert(letter.clone(), extent) {
            Some(before) if before != extent => {
                let shown = name::to_latex(letter);
                let message = format!("the index `{shown}` runs to {before} in one place and to {extent} here");
                refuse("latex::index", message, span, "use different letters")
            }
            _ => Ok(()),
        }
    }
}

/// A numeric exponent of at least 2, by which an index counts twice.
fn is_power(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Number(r) if *r >= Rational::from(2))
}

fn list(names: &BTreeSet<Name>) -> String {
    if names.is_empty() {
        return "(none)".to_owned();
    }
    names.iter().map(|n| format!("`{}`", name::to_latex(n))).collect::<Vec<_>>().join(", ")
}
