//! Syntax tree → expressions: shapes, indices and sums over them.
//!
//! An index that occurs twice or more in a term, and is not free on the left side, is summed over; powers count. A term is
//! what stands between `+` and `-`; factors in parentheses belong to it unless they are sums themselves, which are
//! contracted on their own first.

use std::collections::BTreeMap;
use std::ops::Range;

use super::parse;
use super::scope::{Found, Role, Scope};
use super::syntax::{Chain, Name, Node, NodeKind, Sign, SubItem, SymbolNode, Target};
use super::{Limit, LimitPoint, Relation, RelationKind, Statement, name, tensor};
use crate::diag::Problem;
use crate::expr::{Expr, Graph, Leaf, Op, Shape, Symbol, Tensor};
use crate::number::Rational;

type Elaborated<T> = Result<T, Box<Problem>>;

pub(super) fn refuse<T>(
    code: &'static str,
    message: impl Into<String>,
    span: &Range<usize>,
    hint: impl Into<String>,
) -> Elaborated<T> {
    let hint = hint.into();
    Err(Box::new(Problem {
        code,
        message: message.into(),
        span: span.clone(),
        hint: (!hint.is_empty()).then_some(hint),
    }))
}

/// One occurrence of an index letter.
#[derive(Clone, Debug)]
struct Occurrence {
    letter: Name,
    span: Range<usize>,
}

pub(super) struct Elaborator<'a> {
    scope: &'a Scope,
    pub(super) graph: &'a mut Graph,
    values: Vec<(Name, u16)>,
    extents: BTreeMap<Name, u16>,
    /// Whether terms of a sum may have different free indices: in the formula of an indexed abbreviation.
    uneven: bool,
    /// The size of an identity matrix: that of the matrices around it.
    identity: Option<u16>,
}

/// Reads the formula of a declaration. `letters` are the letters of the key's subscript: when all of them are indices of
/// the formula the key is a pattern, and the result has one axis for each.
pub(super) fn definition(
    elaborator: &mut Elaborator,
    text: &str,
    letters: &[Name],
) -> Result<(Tensor, bool), Vec<Problem>> {
    let chain = single(text, elaborator.scope)?;
    let node = &chain.sides[0];
    elaborator.uneven = !letters.is_empty();
    let free = elaborator.free(node).map_err(|p| vec![*p])?;
    elaborator.identity = elaborator.square_size(&chain);
    let pattern = !letters.is_empty() && letters.iter().all(|l| free.iter().any(|o| o.letter == *l));
    let letters: &[Name] = if pattern { letters } else { &[] };
    let tensor = elaborator.components(node, letters).map_err(|p| vec![*p])?;
    Ok((tensor, pattern))
}

/// The only chain of a text, which must be a single expression.
pub(super) fn single(text: &str, scope: &Scope) -> Result<Chain, Vec<Problem>> {
    let mut chains = parse::chains(text, scope)?;
    let problem = |span: Range<usize>, message: &str| {
        vec![Problem { code: "latex::not-an-expression", message: message.into(), span, hint: None }]
    };
    if let [_, second, ..] = chains.as_slice() {
        return Err(problem(second.span.clone(), "one expression is expected here, not several"));
    }
    match chains.pop() {
        Some(chain) if chain.relations.is_empty() => Ok(chain),
        Some(chain) => Err(problem(chain.span, "an expression is expected here, not a relation")),
        None => Err(problem(0..text.len(), "there is no formula here")),
    }
}

impl<'a> Elaborator<'a> {
    pub(super) fn new(scope: &'a Scope, graph: &'a mut Graph) -> Elaborator<'a> {
        Elaborator { scope, graph, values: Vec::new(), extents: BTreeMap::new(), uneven: false, identity: None }
    }

    /// A chain of relations.
    pub(super) fn statement(&mut self, chain: &Chain) -> Elaborated<Statement> {
        if chain.relations.is_empty() {
            return refuse("latex::not-a-relation", "a relation is expected here", &chain.span, "write `… = …`");
        }
        let mut sides: Vec<(&Node, Option<&Target>)> = Vec::new();
        for side in &chain.sides {
            sides.push(match &side.kind {
                NodeKind::Limit(body, target) => (body, Some(target)),
                _ => (side, None),
            });
        }
        self.extents.clear();
        self.identity = self.square_size(chain);
        let mut letters: Vec<Name> = Vec::new();
        for (side, _) in &sides {
            let free = self.free(side)?;
            if letters.is_empty() {
                for o in free {
                    if !letters.contains(&o.letter) {
                        letters.push(o.letter);
                    }
                }
            }
            // `0 = a_i`: a side without indices passes the question on, if it is 0.
            if !letters.is_empty() || !is_zero(side) {
                break;
            }
        }
        // The other sides may tell the extents that group indices and δ leave open.
        for (side, _) in &sides {
            let bound = letters.iter().map(|l| (l.clone(), 1)).collect::<Vec<_>>();
            self.values.extend(bound);
            let seen = self.free(side);
            self.values.truncate(self.values.len() - letters.len());
            if let Some(stray) = seen?.first() {
                return refuse(
                    "latex::unsummed-index",
                    format!(
                        "the index `{}` stands once in this term and not on the left",
                        name::to_latex(&stray.letter)
                    ),
                    &stray.span,
                    "repeat it to sum over it, or let it stand on the left side too",
                );
            }
        }
        let mut tensors = Vec::new();
        for (side, _) in &sides {
            tensors.push(self.components(side, &letters)?);
        }
        let mut relations = Vec::new();
        for (k, &kind) in chain.relations.iter().enumerate() {
            let (left, right) = (tensors[k].clone(), tensors[k + 1].clone());
            let span = chain.sides[k].span.start..chain.sides[k + 1].span.end;
            let (left, right) = self.same_shape(left, right, &span)?;
            if sides[k + 1].1.is_some() {
                return refuse(
                    "latex::limit",
                    "a limit stands on the left side",
                    &chain.sides[k + 1].span,
                    "exchange the sides",
                );
            }
            let limit = match sides[k].1 {
                None => None,
                Some(target) => Some(Limit { approaches: self.limit_point(target)? }),
            };
            if left.shape.rank() > 0 && !matches!(kind, RelationKind::Equal | RelationKind::NotEqual) {
                return refuse(
                    "latex::shape",
                    format!("a {} cannot be ordered", left.shape),
                    &span,
                    "compare components",
                );
            }
            let sign = self.scope.branch_sign();
            let all = left.components.iter().chain(&right.components).copied();
            let has_branches = self.graph.leaves(all).contains(&sign);
            relations.push(Relation { kind, left, right, limit, indices: letters.clone(), has_branches, span });
        }
        Ok(Statement { relations, span: chain.span.clone() })
    }

    fn limit_point(&mut self, target: &Target) -> Elaborated<LimitPoint> {
        Ok(match target {
            Target::PlusInfinity => LimitPoint::PlusInfinity,
            Target::MinusInfinity => LimitPoint::MinusInfinity,
            Target::Finite(node) => LimitPoint::Finite(self.scalar(node)?),
        })
    }

    /// Gives 0 the shape of the other side.
    fn same_shape(&mut self, left: Tensor, right: Tensor, span: &Range<usize>) -> Elaborated<(Tensor, Tensor)> {
        if left.shape == right.shape {
            return Ok((left, right));
        }
        let zero = |t: &Tensor, g: &Graph| t.as_scalar().is_some_and(|e| g.is_zero(e));
        let fill = |shape: &Shape, g: &mut Graph| {
            let e = g.integer(0);
            Tensor { shape: shape.clone(), components: vec![e; shape.len()] }
        };
        if zero(&left, self.graph) {
            return Ok((fill(&right.shape, self.graph), right));
        }
        if zero(&right, self.graph) {
            let filled = fill(&left.shape, self.graph);
            return Ok((left, filled));
        }
        let hint = if left.shape.rank() == 2 { r"the identity matrix is written `\mathbb{1}`" } else { "" };
        refuse(
            "latex::shape",
            format!("the left side is a {}, the right side a {}", left.shape, right.shape),
            span,
            hint,
        )
    }

    /// The value for every choice of the letters: a tensor with one axis for each, or the tensor itself without letters.
    pub(super) fn components(&mut self, node: &Node, letters: &[Name]) -> Elaborated<Tensor> {
        if letters.is_empty() {
            return self.value(node);
        }
        let mut extents = Vec::new();
        for letter in letters {
            match self.extents.get(letter) {
                Some(&n) => extents.push(n),
                None => {
                    let message = format!("the extent of the index `{}` is not known", name::to_latex(letter));
                    return refuse("latex::index", message, &node.span, "");
                }
            }
        }
        let shape = Shape::of(extents);
        let mut components = Vec::with_capacity(shape.len());
        for position in 0..shape.len() {
            let chosen = shape.indices(position);
            let before = self.values.len();
            self.values.extend(letters.iter().cloned().zip(chosen));
            let value = self.scalar(node);
            self.values.truncate(before);
            components.push(value?);
        }
        Ok(Tensor { shape, components })
    }

    fn scalar(&mut self, node: &Node) -> Elaborated<Expr> {
        let t = self.value(node)?;
        match t.as_scalar() {
            Some(e) => Ok(e),
            None => refuse("latex::shape", format!("a scalar is needed here, this is a {}", t.shape), &node.span, ""),
        }
    }

    fn value_of(&self, letter: &str) -> Option<u16> {
        self.values.iter().rev().find(|(l, _)| l == letter).map(|(_, v)| *v)
    }

    // ---- indices -------------------------------------------------------------------------------------------------

    fn note_extent(&mut self, letter: &Name, extent: u16, span: &Range<usize>) -> Elaborated<()> {
        match self.extents.insert(letter.clone(), extent) {
            Some(before) if before != extent => refuse(
                "latex::index",
                format!("the index `{}` runs to {before} in one place and to {extent} here", name::to_latex(letter)),
                span,
                "use different letters",
            ),
            _ => Ok(()),
        }
    }

    /// Occurrences of index letters without a value in a term, with multiplicity; contracted sums count by what they leave.
    fn occurrences(&mut self, node: &Node, out: &mut Vec<Occurrence>) -> Elaborated<()> {
        match &node.kind {
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Identity => {}
            NodeKind::Symbol(s) => self.symbol_occurrences(s, &node.span, out)?,
            NodeKind::Scripted { base, sub, sup, .. } => {
                let twice = sup.as_deref().is_some_and(is_power);
                let flat = !twice && !matches!(base.kind, NodeKind::Sum(_));
                if flat && sub.is_none() {
                    self.occurrences(base, out)?;
                } else {
                    let free = self.free(base)?;
                    for _ in 0..=usize::from(twice) {
                        out.extend(free.iter().cloned());
                    }
                }
                if let Some(items) = sub {
                    let letters = items.iter().any(|i| matches!(i, SubItem::Name(_)));
                    let extents: Vec<u16> =
                        if letters { self.value(base)?.shape.extents().to_vec() } else { Vec::new() };
                    for (axis, item) in items.iter().enumerate() {
                        if let SubItem::Name(letter) = item
                            && self.value_of(letter).is_none()
                        {
                            if let Some(&extent) = extents.get(axis) {
                                self.note_extent(letter, extent, &node.span)?;
                            }
                            for _ in 0..=usize::from(twice) {
                                out.push(Occurrence { letter: letter.clone(), span: node.span.clone() });
                            }
                        }
                    }
                }
                if let Some(sup) = sup.as_deref().filter(|s| !is_transpose(s, self.scope)) {
                    out.extend(self.free(sup)?);
                }
            }
            NodeKind::Sum(terms) => match terms.as_slice() {
                [(_, only)] => self.occurrences(only, out)?,
                _ => out.extend(self.free(node)?),
            },
            NodeKind::Product(parts) | NodeKind::Dot(parts) => {
                for part in parts {
                    self.occurrences(part, out)?;
                }
            }
            NodeKind::Cross(a, b) | NodeKind::Quotient(a, b) => {
                self.occurrences(a, out)?;
                self.occurrences(b, out)?;
            }
            NodeKind::Derivative { of, by, .. } => {
                self.occurrences(of, out)?;
                self.occurrences(by, out)?;
            }
            NodeKind::Root(a, _) | NodeKind::Exponential(a) | NodeKind::Absolute(a) | NodeKind::Limit(a, _) => {
                out.extend(self.free(a)?);
            }
            NodeKind::Function(_, power, arguments) => {
                for argument in arguments {
                    let free = self.free(argument)?;
                    for _ in 0..=usize::from(power.is_some_and(|n| n > 1)) {
                        out.extend(free.iter().cloned());
                    }
                }
            }
            NodeKind::Tuple(parts) => {
                for part in parts {
                    out.extend(self.free(part)?);
                }
            }
            NodeKind::Matrix(rows) => {
                for cell in rows.iter().flatten() {
                    out.extend(self.free(cell)?);
                }
            }
        }
        Ok(())
    }

    fn symbol_occurrences(&mut self, s: &SymbolNode, span: &Range<usize>, out: &mut Vec<Occurrence>) -> Elaborated<()> {
        let twice = s.sup.as_deref().is_some_and(is_power);
        let (indices, extents) = match self.builtin(s) {
            Some(_) => {
                let items = s.sub.clone().unwrap_or_default();
                let extents = if s.name == "\\epsilon" { vec![Some(3); 3] } else { vec![None; 2] };
                (items, extents)
            }
            None => {
                let found = self.resolve(s, span)?;
                let (symbol, items, definition) = (found.symbol, found.indices.clone(), found.definition.cloned());
                let shape = definition.map_or_else(|| self.graph.shape(symbol).clone(), |t| t.shape);
                let mut extents: Vec<Option<u16>> = shape.extents().iter().map(|&n| Some(n)).collect();
                extents.resize(items.len().max(extents.len()), extents.first().copied().flatten());
                (items, extents)
            }
        };
        for (axis, item) in indices.iter().enumerate() {
            if let SubItem::Name(letter) = item
                && self.value_of(letter).is_none()
            {
                if let Some(Some(extent)) = extents.get(axis) {
                    self.note_extent(letter, *extent, span)?;
                }
                for _ in 0..=usize::from(twice) {
                    out.push(Occurrence { letter: letter.clone(), span: span.clone() });
                }
            }
        }
        if let Some(sup) = s.sup.as_deref()
            && !is_transpose(sup, self.scope)
            && !matches!(sup.kind, NodeKind::Number(_))
        {
            out.extend(self.free(sup)?);
        }
        for argument in s.arguments.iter().flatten() {
            if self.resolve(s, span).is_ok_and(|f| !f.literal_arguments) {
                out.extend(self.free(argument)?);
            }
        }
        Ok(())
    }

    /// Index letters that an expression leaves free: each once, in order of appearance.
    fn free(&mut self, node: &Node) -> Elaborated<Vec<Occurrence>> {
        if let NodeKind::Sum(terms) = &node.kind
            && terms.len() > 1
        {
            let mut all: Vec<Occurrence> = Vec::new();
            let mut first: Option<Vec<Name>> = None;
            for (_, term) in terms {
                let free = self.free(term)?;
                let mut names: Vec<Name> = free.iter().map(|o| o.letter.clone()).collect();
                names.sort();
                match &first {
                    Some(before) if *before != names && !self.uneven && !is_zero(term) => {
                        return refuse(
                            "latex::index",
                            format!(
                                "this term has the free indices {}, the terms before it {}",
                                list(&names),
                                list(before)
                            ),
                            &term.span,
                            "every term of a sum has the same free indices",
                        );
                    }
                    Some(_) => {}
                    None => first = Some(names),
                }
                for o in free {
                    if !all.iter().any(|a| a.letter == o.letter) {
                        all.push(o);
                    }
                }
            }
            return Ok(all);
        }
        let mut occurrences = Vec::new();
        self.occurrences(node, &mut occurrences)?;
        let count = |l: &Name| occurrences.iter().filter(|o| o.letter == *l).count();
        Ok(occurrences.iter().filter(|o| count(&o.letter) == 1).cloned().collect())
    }

    /// Letters that a term sums over.
    fn contracted(&mut self, node: &Node) -> Elaborated<Vec<Name>> {
        let mut occurrences = Vec::new();
        self.occurrences(node, &mut occurrences)?;
        let mut out: Vec<Name> = Vec::new();
        for o in &occurrences {
            let count = occurrences.iter().filter(|x| x.letter == o.letter).count();
            if count > 1 && !out.contains(&o.letter) {
                out.push(o.letter.clone());
            }
        }
        Ok(out)
    }

    // ---- values --------------------------------------------------------------------------------------------------

    /// The value of an expression; every free index must have a value.
    fn value(&mut self, node: &Node) -> Elaborated<Tensor> {
        if let NodeKind::Sum(terms) = &node.kind {
            let mut sum: Option<Tensor> = None;
            for (sign, term) in terms {
                let value = self.value(term)?;
                sum = Some(self.add_term(sum, *sign, value, &term.span)?);
            }
            return match sum {
                Some(sum) => Ok(sum),
                None => refuse("latex::empty", "an empty sum", &node.span, ""),
            };
        }
        let letters = self.contracted(node)?;
        let Some((letter, _)) = letters.split_first() else { return self.term(node) };
        let Some(&extent) = self.extents.get(letter) else {
            let message = format!("the extent of the index `{}` is not known", name::to_latex(letter));
            return refuse("latex::index", message, &node.span, "");
        };
        let mut sum: Option<Tensor> = None;
        for value in 1..=extent {
            self.values.push((letter.clone(), value));
            let term = self.value(node);
            self.values.pop();
            let term = term?;
            // A term with a structural zero, such as an entry of ε, is not there.
            if term.components.iter().all(|&e| self.graph.is_zero(e)) && sum.is_some() {
                continue;
            }
            let absent = |t: &Tensor, g: &Graph| t.components.iter().all(|&e| g.is_zero(e));
            sum = match sum {
                Some(s) if !absent(&s, self.graph) => Some(self.add_term(Some(s), Sign::Plus, term, &node.span)?),
                _ => Some(term),
            };
        }
        match sum {
            Some(sum) => Ok(sum),
            None => refuse("latex::index", "an index without values", &node.span, ""),
        }
    }

    fn add_term(&mut self, sum: Option<Tensor>, sign: Sign, term: Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        let term = match sign {
            Sign::Plus => term,
            Sign::Minus => self.map(term, |g, e| g.neg(e)),
            Sign::PlusMinus | Sign::MinusPlus => {
                let leaf = self.scope.branch_sign();
                self.map(term, |g, e| {
                    let s = g.leaf(leaf);
                    let signed = g.mul_structural(s, e);
                    if sign == Sign::PlusMinus { signed } else { g.neg(signed) }
                })
            }
        };
        let Some(sum) = sum else { return Ok(term) };
        let (a, b) = self.same_shape(sum, term, span).map_err(|mut p| {
            p.message =
                p.message.replace("the left side is", "the terms before are").replace("the right side", "this term is");
            p
        })?;
        let pairs = a.components.iter().zip(&b.components);
        let components = pairs.map(|(&x, &y)| add_or_subtract(self.graph, x, y)).collect();
        Ok(Tensor { shape: a.shape, components })
    }

    fn map(&mut self, t: Tensor, f: impl Fn(&mut Graph, Expr) -> Expr) -> Tensor {
        let components = t.components.into_iter().map(|e| f(self.graph, e)).collect();
        Tensor { shape: t.shape, components }
    }

    /// The value of a term whose indices all have values.
    fn term(&mut self, node: &Node) -> Elaborated<Tensor> {
        match &node.kind {
            NodeKind::Number(r) => Ok(Tensor::scalar(self.graph.constant(r.clone()))),
            NodeKind::Pi => Ok(Tensor::scalar(self.graph.pi())),
            NodeKind::Identity => match self.identity {
                Some(n) => {
                    let one = self.graph.integer(1);
                    Ok(tensor::diagonal(self.graph, &vec![one; usize::from(n)]))
                }
                None => refuse(
                    "latex::shape",
                    "the size of the identity matrix is not clear here",
                    &node.span,
                    "compare it with a square matrix, or add it to one",
                ),
            },
            NodeKind::Symbol(s) => self.symbol(s, &node.span),
            NodeKind::Scripted { base, sub, sup, sup_first } => {
                let base_value = self.value(base)?;
                self.scripted(base_value, sub.as_deref(), sup.as_deref(), *sup_first, &node.span)
            }
            NodeKind::Sum(_) => self.value(node),
            NodeKind::Product(parts) => {
                let mut values = Vec::new();
                for part in parts {
                    values.push((self.value(part)?, part.span.clone()));
                }
                tensor::product(self.graph, values, &node.span)
            }
            NodeKind::Dot(parts) => {
                let mut acc: Option<Tensor> = None;
                for part in parts {
                    let value = self.value(part)?;
                    acc = Some(match acc {
                        None => value,
                        Some(a) if a.shape.rank() == 1 && value.shape.rank() == 1 => {
                            tensor::dot(self.graph, &a, &value, &node.span)?
                        }
                        Some(a) => tensor::product(
                            self.graph,
                            vec![(a, node.span.clone()), (value, part.span.clone())],
                            &node.span,
                        )?,
                    });
                }
                acc.map_or_else(|| refuse("latex::empty", "an empty product", &node.span, ""), Ok)
            }
            NodeKind::Cross(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                tensor::cross(self.graph, &a, &b, &node.span)
            }
            NodeKind::Quotient(a, b) => {
                let top = self.value(a)?;
                let under = self.scalar(b)?;
                Ok(self
                    .map(top, |g, e| if g.is_zero(e) && g.as_constant(under).is_none() { e } else { g.div(e, under) }))
            }
            NodeKind::Root(a, degree) => {
                let e = self.scalar(a)?;
                Ok(Tensor::scalar(match degree {
                    2 => self.graph.unary(Op::Sqrt, e),
                    n => {
                        let one = self.graph.integer(1);
                        let degree = self.graph.integer(i64::from(*n));
                        let exponent = self.graph.div(one, degree);
                        self.graph.binary(Op::Pow, e, exponent)
                    }
                }))
            }
            NodeKind::Exponential(a) => {
                let e = self.scalar(a)?;
                Ok(Tensor::scalar(self.graph.unary(Op::Exp, e)))
            }
            NodeKind::Absolute(a) => {
                let t = self.value(a)?;
                match t.shape.rank() {
                    0 => Ok(self.map(t, |g, e| g.unary(Op::Abs, e))),
                    1 => {
                        let square = tensor::dot(self.graph, &t, &t, &node.span)?;
                        Ok(self.map(square, |g, e| g.unary(Op::Sqrt, e)))
                    }
                    _ => refuse(
                        "latex::shape",
                        "a matrix has no absolute value",
                        &node.span,
                        r"write `\det`, or a norm by components",
                    ),
                }
            }
            NodeKind::Function(function, power, arguments) => {
                let value = self.function(function, arguments, &node.span)?;
                Ok(match power {
                    Some(n) => self.map(value, |g, e| g.powi(e, *n)),
                    None => value,
                })
            }
            NodeKind::Derivative { of, by, order } => self.derivative(of, by, *order, &node.span),
            NodeKind::Tuple(parts) => {
                let mut components = Vec::new();
                for part in parts {
                    components.push(self.scalar(part)?);
                }
                Ok(Tensor { shape: Shape::vector(components.len() as u16), components })
            }
            NodeKind::Matrix(rows) => {
                let mut components = Vec::new();
                for cell in rows.iter().flatten() {
                    components.push(self.scalar(cell)?);
                }
                Ok(Tensor { shape: Shape::matrix(rows.len() as u16, rows[0].len() as u16), components })
            }
            NodeKind::Limit(..) => refuse("latex::limit", "a limit stands alone on the left side", &node.span, ""),
        }
    }

    fn function(&mut self, function: &str, arguments: &[Node], span: &Range<usize>) -> Elaborated<Tensor> {
        if matches!(function, "det" | "tr" | "diag" | "diagonal") {
            return self.matrix_function(function, arguments, span);
        }
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.scalar(argument)?);
        }
        let g = &mut *self.graph;
        let unary = |op| Some(op);
        let op = match function {
            "sin" => unary(Op::Sin),
            "cos" => unary(Op::Cos),
            "tan" => unary(Op::Tan),
            "arcsin" => unary(Op::Arcsin),
            "arccos" => unary(Op::Arccos),
            "arctan" => unary(Op::Arctan),
            "sinh" => unary(Op::Sinh),
            "cosh" => unary(Op::Cosh),
            "tanh" => unary(Op::Tanh),
            "exp" => unary(Op::Exp),
            "ln" => unary(Op::Ln),
            _ => None,
        };
        let e = match (op, values.as_slice()) {
            (Some(op), &[x]) => g.unary(op, x),
            (None, &[x]) => {
                let one = g.integer(1);
                match function {
                    "cot" | "sec" => {
                        let c = g.unary(Op::Cos, x);
                        if function == "sec" {
                            g.div(one, c)
                        } else {
                            let s = g.unary(Op::Sin, x);
                            g.div(c, s)
                        }
                    }
                    "csc" => {
                        let s = g.unary(Op::Sin, x);
                        g.div(one, s)
                    }
                    "log" => {
                        return refuse("latex::ambiguous", "the base of `\\log` is not clear", span, r"write `\ln`");
                    }
                    _ => return refuse("latex::unknown-function", format!("`{function}` is not known"), span, ""),
                }
            }
            (None, &[a, b]) if function == "atan2" => g.binary(Op::Arctan2, a, b),
            (None, &[a, b]) if function == "agm" => g.binary(Op::Agm, a, b),
            _ => return refuse("latex::arity", format!("`{function}` has another number of arguments"), span, ""),
        };
        Ok(Tensor::scalar(e))
    }

    fn matrix_function(&mut self, function: &str, arguments: &[Node], span: &Range<usize>) -> Elaborated<Tensor> {
        if function.starts_with("diag") {
            let mut values = Vec::new();
            for argument in arguments {
                values.push(self.scalar(argument)?);
            }
            return Ok(tensor::diagonal(self.graph, &values));
        }
        let Some(argument) = arguments.first() else { return refuse("latex::arity", "no argument", span, "") };
        let t = self.value(argument)?;
        if function == "det" { tensor::determinant(self.graph, &t, span) } else { tensor::trace(self.graph, &t, span) }
    }

    fn derivative(&mut self, of: &Node, by: &Node, order: u8, span: &Range<usize>) -> Elaborated<Tensor> {
        let of = self.value(of)?;
        let by_value = self.scalar(by)?;
        let Some(time) = self.scope.time() else {
            return refuse("latex::derivative", "no symbol is declared as the time", span, "give one the role `time`");
        };
        let time_node = self.graph.leaf(time);
        if by_value == time_node {
            let mut t = of;
            for _ in 0..order {
                t = self.time_derivative(t, span)?;
            }
            return Ok(t);
        }
        if order > 1 {
            return refuse(
                "latex::derivative",
                "a higher derivative by something other than time",
                span,
                "write it out",
            );
        }
        let top = self.time_derivative(of, span)?;
        let below = self.time_derivative(Tensor::scalar(by_value), span)?;
        match below.as_scalar() {
            Some(e) if !self.graph.is_zero(e) => Ok(self.map(top, |g, x| g.div(x, e))),
            _ => refuse("latex::derivative", "what stands in the denominator does not depend on time", &by.span, ""),
        }
    }

    fn time_derivative(&mut self, t: Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        let Some(time) = self.scope.time() else {
            return refuse("latex::derivative", "no symbol is declared as the time", span, "give one the role `time`");
        };
        let scope = self.scope;
        let moves = |leaf: Leaf| matches!(scope.role(leaf.symbol), Some(Role::State | Role::Observable));
        let mut components = Vec::new();
        for e in t.components {
            match self.graph.time_derivative(e, time, moves) {
                Ok(d) => components.push(d),
                Err(reason) => return refuse("latex::derivative", reason.to_string(), span, ""),
            }
        }
        Ok(Tensor { shape: t.shape, components })
    }

    // ---- symbols -------------------------------------------------------------------------------------------------

    /// ε and δ, unless they are declared; with the right number of indices.
    fn builtin(&self, s: &SymbolNode) -> Option<usize> {
        let count = s.sub.as_ref()?.len();
        let fits = (s.name == "\\epsilon" && count == 3) || (s.name == "\\delta" && count == 2);
        (fits && !self.scope.declares(&s.name)).then_some(count)
    }

    fn resolve(&self, s: &SymbolNode, span: &Range<usize>) -> Elaborated<Found<'a>> {
        let arguments = s.arguments.as_ref().map(|_| s.arguments_text.as_str());
        if let Some(found) = self.scope.find(&s.name, s.sub.as_deref(), arguments) {
            return Ok(found);
        }
        let shown = name::to_latex(&s.name);
        let (message, hint) = if self.scope.declares(&s.name) {
            (format!("`{shown}` is not declared with this subscript or these arguments"), String::new())
        } else {
            let hint = match self.scope.nearest(&s.name) {
                Some(near) => format!("declare it under [symbols], or did you mean `{near}`?"),
                None => "declare it under [symbols]".to_owned(),
            };
            (format!("`{shown}` is not declared"), hint)
        };
        refuse("latex::unknown-symbol", message, span, hint)
    }

    fn index_values(&self, items: &[SubItem], span: &Range<usize>) -> Elaborated<Vec<u16>> {
        let mut out = Vec::new();
        for item in items {
            out.push(match item {
                SubItem::Digit(d) => *d,
                SubItem::Name(letter) => match self.value_of(letter) {
                    Some(v) => v,
                    None => {
                        let shown = name::to_latex(letter);
                        return refuse(
                            "latex::unsummed-index",
                            format!("the index `{shown}` stands once in this term and not on the left"),
                            span,
                            "repeat it to sum over it, or let it stand on the left side too",
                        );
                    }
                },
                SubItem::Other(c) => {
                    return refuse(
                        "latex::index",
                        format!("`{c}` is not an index"),
                        span,
                        "declare a symbol with this subscript",
                    );
                }
            });
        }
        Ok(out)
    }

    fn symbol(&mut self, s: &SymbolNode, span: &Range<usize>) -> Elaborated<Tensor> {
        if self.builtin(s).is_some() {
            let values = self.index_values(s.sub.as_deref().unwrap_or(&[]), span)?;
            let e = self.graph.integer(match values.as_slice() {
                [i, j] => i64::from(i == j),
                [i, j, k] => levi_civita(*i, *j, *k),
                _ => 0,
            });
            return self.scripted(Tensor::scalar(e), None, s.sup.as_deref(), false, span);
        }
        let found = self.resolve(s, span)?;
        let (symbol, role) = (found.symbol, found.role);
        let items = found.indices.clone();
        let literal = found.literal_arguments;
        let formal: Vec<(Symbol, Shape)> = found.formal.to_vec();
        let mut base = match found.definition {
            Some(t) if role == Role::Abbreviation => t.clone(),
            _ => self.components_of(symbol),
        };
        if !formal.is_empty() {
            base = self.apply(base, &formal, s.arguments.as_deref().unwrap_or(&[]), span)?;
        }
        for _ in 0..s.dots {
            if role == Role::Time {
                return refuse("latex::dot", "the time has no rate", span, "");
            }
            base = self.time_derivative(base, span)?;
        }
        if let (Some([argument]), false, true) = (s.arguments.as_deref(), literal, formal.is_empty()) {
            let instant = self.scalar(argument)?;
            base = self.at_instant(base, instant, &argument.span)?;
        } else if s.arguments.as_ref().is_some_and(|a| a.len() > 1) && formal.is_empty() && !literal {
            return refuse("latex::arity", "a value is taken at one time", span, "");
        }
        let sub = (!items.is_empty()).then_some(items.as_slice());
        // One index on a diagonal matrix is its diagonal.
        if let (Some([_]), true) = (sub, self.graph.is_diagonal(symbol)) {
            let n = base.shape.extents()[0];
            let diagonal = (0..n).map(|i| base.components[i as usize * (n as usize + 1)]).collect();
            base = Tensor { shape: Shape::vector(n), components: diagonal };
        }
        self.scripted(base, sub, s.sup.as_deref(), s.sup_first, span)
    }

    /// The stored components of a symbol as a tensor: off the diagonal of a diagonal matrix there are zeros.
    fn components_of(&mut self, symbol: Symbol) -> Tensor {
        let shape = self.graph.shape(symbol).clone();
        if !self.graph.is_diagonal(symbol) {
            let components = (0..shape.len()).map(|c| self.graph.component(symbol, c as u16)).collect();
            return Tensor { shape, components };
        }
        let entries: Vec<Expr> =
            (0..self.graph.component_count(symbol)).map(|c| self.graph.component(symbol, c as u16)).collect();
        tensor::diagonal(self.graph, &entries)
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
            .map(|e| self.graph.substitute(e, |_, leaf| place(leaf).map(|i| values[i])))
            .collect();
        Ok(Tensor { shape: body.shape, components })
    }

    /// The value at a time: the present one for the time itself.
    fn at_instant(&mut self, t: Tensor, instant: Expr, span: &Range<usize>) -> Elaborated<Tensor> {
        let time = self.scope.time();
        if let Some(time) = time
            && self.graph.leaf(time) == instant
        {
            return Ok(t);
        }
        let scope = self.scope;
        let moving = |leaf: &Leaf| {
            leaf.instant.is_none()
                && matches!(scope.role(leaf.symbol), Some(Role::Time | Role::State | Role::Observable))
        };
        if self.graph.leaves([instant]).iter().any(moving) {
            return refuse(
                "latex::instant",
                "this time depends on time itself",
                span,
                "write a number, a parameter, or the time",
            );
        }
        let fixed = |graph: &mut Graph, leaf: Leaf| {
            if Some(leaf) == time {
                return Some(instant);
            }
            moving(&leaf).then(|| graph.leaf(Leaf { instant: Some(instant), ..leaf }))
        };
        let components = t.components.into_iter().map(|e| self.graph.substitute(e, fixed)).collect();
        Ok(Tensor { shape: t.shape, components })
    }

    // ---- scripts -------------------------------------------------------------------------------------------------

    fn scripted(
        &mut self,
        base: Tensor,
        sub: Option<&[SubItem]>,
        sup: Option<&Node>,
        sup_first: bool,
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let (Some(items), Some(sup)) = (sub, sup) else {
            let t = match sub {
                Some(items) => self.indexed(base, items, span)?,
                None => base,
            };
            return match sup {
                Some(sup) => self.power(t, sup, span),
                None => Ok(t),
            };
        };
        let matrix_power = base.shape.rank() == 2 && (is_transpose(sup, self.scope) || is_integer(sup, -1));
        if matrix_power && !sup_first {
            return refuse(
                "latex::ambiguous",
                "is this the inverse or transpose of the matrix, or of its component?",
                span,
                r"write the superscript first, `A^{-1}_{ij}`, or a fraction `\frac{1}{A_{ij}}`",
            );
        }
        if matrix_power {
            let t = self.power(base, sup, span)?;
            return self.indexed(t, items, span);
        }
        let t = self.indexed(base, items, span)?;
        self.power(t, sup, span)
    }

    fn indexed(&mut self, base: Tensor, items: &[SubItem], span: &Range<usize>) -> Elaborated<Tensor> {
        let indices = self.index_values(items, span)?;
        match base.shape.position(&indices) {
            Some(position) => Ok(Tensor::scalar(base.components[position])),
            None if indices.len() != base.shape.rank() => {
                let message = format!("{} indices on a {}", indices.len(), base.shape);
                refuse("latex::index", message, span, "")
            }
            None => {
                let list: Vec<String> = indices.iter().map(u16::to_string).collect();
                refuse("latex::index", format!("a {} has no component {}", base.shape, list.join(", ")), span, "")
            }
        }
    }

    fn power(&mut self, base: Tensor, sup: &Node, span: &Range<usize>) -> Elaborated<Tensor> {
        if base.shape.rank() > 0 && is_transpose(sup, self.scope) {
            return tensor::transpose(&base, span);
        }
        let exponent = self.scalar(sup)?;
        let integer = self.graph.as_constant(exponent).and_then(|r| i32::try_from(r.clone()).ok());
        match (base.shape.rank(), integer) {
            (0, Some(n)) => Ok(self.map(base, |g, e| g.powi(e, n))),
            (0, None) => {
                let e = base.components[0];
                // x^{n/2} by the root, which has a value at 0 where it should.
                if let Some(r) = self.graph.as_constant(exponent).cloned()
                    && *r.denominator() == dashu_int::UBig::from(2u8)
                    && let Ok(n) = i32::try_from(r * Rational::from(2))
                {
                    let root = self.graph.unary(Op::Sqrt, e);
                    return Ok(Tensor::scalar(self.graph.powi(root, n)));
                }
                Ok(Tensor::scalar(self.graph.binary(Op::Pow, e, exponent)))
            }
            (1, Some(2)) => tensor::dot(self.graph, &base, &base, span),
            (2, Some(-1)) => tensor::inverse(self.graph, &base, span),
            (2, Some(n @ 2..=16)) => {
                let mut t = base.clone();
                for _ in 1..n {
                    t = tensor::product(self.graph, vec![(t, span.clone()), (base.clone(), span.clone())], span)?;
                }
                Ok(t)
            }
            _ => refuse("latex::shape", format!("this power of a {} is not defined", base.shape), span, ""),
        }
    }
}

/// x + y, written as a difference where y is negated.
fn add_or_subtract(graph: &mut Graph, x: Expr, y: Expr) -> Expr {
    if let crate::expr::Node::Unary(Op::Neg, inner) = *graph.node(y) {
        return graph.sub(x, inner);
    }
    graph.add(x, y)
}

fn list(names: &[Name]) -> String {
    if names.is_empty() {
        return "(none)".to_owned();
    }
    names.iter().map(|n| format!("`{}`", name::to_latex(n))).collect::<Vec<_>>().join(", ")
}

fn is_zero(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Number(r) if *r == Rational::ZERO)
}

fn is_integer(node: &Node, n: i64) -> bool {
    match &node.kind {
        NodeKind::Number(r) => *r == Rational::from(n),
        NodeKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, inner)] => is_integer(inner, -n),
            _ => false,
        },
        _ => false,
    }
}

/// A numeric exponent of at least 2, by which an index counts twice.
fn is_power(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Number(r) if *r >= Rational::from(2))
}

fn is_transpose(node: &Node, scope: &Scope) -> bool {
    match &node.kind {
        NodeKind::Symbol(s) => {
            matches!(s.name.as_str(), "T" | "\\top" | "rm:T") && s.sub.is_none() && !scope.declares(&s.name)
        }
        _ => false,
    }
}

fn levi_civita(i: u16, j: u16, k: u16) -> i64 {
    let (i, j, k) = (i64::from(i), i64::from(j), i64::from(k));
    (j - i) * (k - j) * (k - i) / 2
}

impl Elaborator<'_> {
    /// Looks at the whole of an expression before its parts.
    pub(super) fn prepare(&mut self, chain: &Chain) {
        self.identity = self.square_size(chain);
    }

    /// The size of the square matrices that a chain names, if they agree.
    pub(super) fn square_size(&self, chain: &Chain) -> Option<u16> {
        let mut stack: Vec<&Node> = chain.sides.iter().collect();
        let mut sizes: Vec<u16> = Vec::new();
        while let Some(node) = stack.pop() {
            if let NodeKind::Symbol(s) = &node.kind
                && let Ok(found) = self.resolve(s, &node.span)
                && found.indices.is_empty()
            {
                let shape = found.definition.map_or_else(|| self.graph.shape(found.symbol), |t| &t.shape);
                if let &[n, m] = shape.extents()
                    && n == m
                {
                    sizes.push(n);
                }
            }
            if let NodeKind::Matrix(rows) = &node.kind
                && rows.len() == rows[0].len()
            {
                sizes.push(rows.len() as u16);
            }
            stack.extend(node.children());
        }
        sizes.dedup();
        match sizes.as_slice() {
            [n] => Some(*n),
            _ => None,
        }
    }

    /// An index that an expression leaves free, as a problem.
    pub(super) fn stray(&mut self, node: &Node) -> Elaborated<Option<Problem>> {
        let free = self.free(node)?;
        Ok(free.first().map(|o| Problem {
            code: "latex::unsummed-index",
            message: format!("the index `{}` stands once", name::to_latex(&o.letter)),
            span: o.span.clone(),
            hint: Some("repeat it to sum over it".to_owned()),
        }))
    }
}
