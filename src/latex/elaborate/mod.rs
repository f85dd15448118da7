//! Syntax tree → expressions: shapes, indices and sums over them.
//!
//! An index that occurs twice or more in a term, and is not free on the left side, is summed over; powers count. Where a
//! sum stops is decided once, before anything is computed, see [`indices`].

mod beside;
mod bracket;
mod commutator;
mod conjugate;
mod differentials;
mod indices;
mod nabla;
mod partial;
mod rates;
mod scripts;
mod symbol;
mod value;
mod variation;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::parse;
use super::scope::{Role, Scope};
use super::syntax::{Chain, Name, Node, NodeKind, Sign, Target};
use super::{Limit, LimitPoint, Relation, RelationKind, Statement, name, tensor};
use diag::Problem;
use expr::{Expr, FastMap, Graph, Shape, Symbol, Tensor};
use value::Value;

pub(super) use super::refusal::refuse_at as refuse;

type Elaborated<T> = Result<T, Box<Problem>>;

/// Most components of a relation.
const MOST_COMPONENTS: usize = 4096;

/// Most parts of formulas that are computed for one statement, counted for every value of every index.
const MOST_WORK: usize = 400_000;

pub(super) struct Elaborator<'a> {
    scope: &'a Scope,
    pub(super) graph: &'a mut Graph,
    /// Indices that have a value at the moment.
    values: Vec<(Name, u16)>,
    /// To where indices run.
    extents: BTreeMap<Name, u16>,
    /// Indices that are free on the left side: never summed over.
    fixed: BTreeSet<Name>,
    /// Indices that stand in places of a name, as in `I_{(n-k)}`, on the left side: a term may do without them.
    loose: BTreeSet<Name>,
    /// Which indices a node sums over, by the address of the node.
    sums: FastMap<*const Node, Vec<Name>>,
    /// Symbols with so many dots, before any index.
    bases: FastMap<(Symbol, u8), Tensor>,
    work: usize,
}

/// The only chain of a text, which must be a single expression.
pub(super) fn single(text: &str, scope: &Scope) -> Result<Node, Vec<Problem>> {
    let mut chains = parse::chains(text, scope)?;
    let problem = |span: Range<usize>, message: &str| {
        vec![Problem { code: "latex::not-an-expression", message: message.into(), span, hint: None }]
    };
    if let [_, second, ..] = chains.as_slice() {
        return Err(problem(second.span.clone(), "one expression is expected here, not several"));
    }
    match chains.pop() {
        Some(mut chain) if chain.relations.is_empty() => match chain.sides.pop() {
            Some(node) => Ok(node),
            None => Err(problem(chain.span, "there is no formula here")),
        },
        Some(chain) => Err(problem(chain.span, "an expression is expected here, not a relation")),
        None => Err(problem(0..text.len(), "there is no formula here")),
    }
}

fn stray<T>(letter: &Name, span: &Range<usize>) -> Elaborated<T> {
    let message = format!("the index `{}` stands once in this term and not on the left", name::to_latex(letter));
    refuse("latex::unsummed-index", message, span, "repeat it to sum over it, or let it stand on the left side too")
}

/// Refuses ± where a formula stands for one value.
fn one_sign(node: &Node) -> Elaborated<()> {
    let mut stack = vec![node];
    while let Some(node) = stack.pop() {
        if let NodeKind::Sum(terms) = &node.kind
            && terms.iter().any(|(sign, _)| matches!(sign, Sign::PlusMinus | Sign::MinusPlus))
        {
            let hint = "write one of the signs, or declare a name for each";
            return refuse("latex::branches", "± stands for two values, and this has one", &node.span, hint);
        }
        stack.extend(node.children());
    }
    Ok(())
}

impl<'a> Elaborator<'a> {
    pub(super) fn new(scope: &'a Scope, graph: &'a mut Graph) -> Elaborator<'a> {
        Elaborator {
            scope,
            graph,
            values: Vec::new(),
            extents: BTreeMap::new(),
            fixed: BTreeSet::new(),
            loose: BTreeSet::new(),
            sums: FastMap::default(),
            bases: FastMap::default(),
            work: 0,
        }
    }

    /// One expression without free indices.
    pub(super) fn expression(mut self, text: &str) -> Result<Tensor, Vec<Problem>> {
        let node = single(text, self.scope)?;
        self.closed_expression(&node).map_err(|p| vec![*p])
    }

    /// One expression without free indices and without ±.
    pub(super) fn quantity(mut self, text: &str) -> Result<Tensor, Vec<Problem>> {
        let node = single(text, self.scope)?;
        one_sign(&node).and_then(|()| self.closed_expression(&node)).map_err(|p| vec![*p])
    }

    /// The value of a tree without free indices.
    pub(super) fn closed_expression(&mut self, node: &Node) -> Elaborated<Tensor> {
        differentials::cancel(node)?;
        if let Some(open) = self.free(node)?.first() {
            return stray(&open.letter, &open.span);
        }
        let value = self.tensor(node)?;
        Ok(self.settled(value))
    }

    /// The formula of a declaration. `letters` are the letters of the key's subscript: when they are indices of the formula
    /// the key is a pattern, and the result has one axis for each.
    pub(super) fn definition(mut self, text: &str, letters: &[Name]) -> Result<(Tensor, bool), Vec<Problem>> {
        let node = single(text, self.scope)?;
        one_sign(&node).map_err(|p| vec![*p])?;
        self.defined(&node, letters).map_err(|p| vec![*p])
    }

    fn defined(&mut self, node: &Node, letters: &[Name]) -> Elaborated<(Tensor, bool)> {
        differentials::cancel(node)?;
        self.fixed = letters.iter().cloned().collect();
        self.loose = self.fixed.clone();
        let open = self.free(node)?;
        let used = letters.iter().filter(|l| open.iter().any(|o| o.letter == **l)).count();
        if let Some(other) = open.iter().find(|o| !self.fixed.contains(&o.letter)) {
            return stray(&other.letter, &other.span);
        }
        if used == 0 {
            let value = self.tensor(node)?;
            return Ok((self.joined(value), false));
        }
        if used < letters.len() {
            let message = "some letters of the name's subscript are indices of the formula, others are not";
            return refuse("latex::index", message, &node.span, "let all of them occur, or none");
        }
        let value = self.components(node, letters)?;
        Ok((self.joined(value), true))
    }

    // ---- statements ----------------------------------------------------------------------------------------------

    /// A chain of relations.
    pub(super) fn statement(&mut self, chain: &Chain) -> Elaborated<Statement> {
        if chain.relations.is_empty() {
            return refuse("latex::not-a-relation", "a relation is expected here", &chain.span, "write `… = …`");
        }
        differentials::agree(chain)?;
        let sides: Vec<(&Node, Option<&Target>)> = chain
            .sides
            .iter()
            .map(|side| match &side.kind {
                NodeKind::Limit(body, target) => (&**body, Some(target)),
                _ => (side, None),
            })
            .collect();
        let letters = self.left_indices(&sides)?;
        let mut tensors = Vec::new();
        for (side, _) in &sides {
            tensors.push(match letters.is_empty() {
                true => self.value(side)?,
                false => Value::Tensor(self.components(side, &letters)?),
            });
        }
        let mut relations = Vec::new();
        for (k, &kind) in chain.relations.iter().enumerate() {
            let span = chain.sides[k].span.start..chain.sides[k + 1].span.end;
            let (left, right) = self.same_shape(&tensors[k], &tensors[k + 1], &span)?;
            if sides[k + 1].1.is_some() {
                let hint = "exchange the sides";
                return refuse("latex::limit", "a limit stands on the left side", &chain.sides[k + 1].span, hint);
            }
            let limit = match sides[k].1 {
                None => None,
                Some(target) => Some(Limit { approaches: self.limit_point(target)? }),
            };
            let (left, right) = (self.settled(left), self.settled(right));
            if left.shape.rank() > 0 && !matches!(kind, RelationKind::Equal | RelationKind::NotEqual) {
                let message = format!("a {} cannot be ordered", left.shape);
                let hint = if left.shape.is_complex() {
                    r"compare real numbers, as `|z|` or `\operatorname{Re}(z)`"
                } else {
                    "compare components"
                };
                return refuse("latex::shape", message, &span, hint);
            }
            let sign = self.scope.branch_sign();
            let all = left.components.iter().chain(&right.components).copied();
            let has_branches = self.graph.leaves_within(all).contains(&sign);
            let indices = letters.iter().map(|l| name::to_latex(l)).collect();
            relations.push(Relation { kind, left, right, limit, indices, has_branches, span });
        }
        Ok(Statement { relations, span: chain.span.clone() })
    }

    /// The indices that are free on the left side; every other side must have the same.
    fn left_indices(&mut self, sides: &[(&Node, Option<&Target>)]) -> Elaborated<Vec<Name>> {
        let mut letters: Vec<Name> = Vec::new();
        let mut first = 0;
        for (k, (side, _)) in sides.iter().enumerate() {
            first = k;
            // Places of a name are noted on the left side only, and only before anything else is asked.
            let places = self.places(side);
            self.loose = places;
            letters = self.free(side)?.into_iter().map(|o| o.letter).collect();
            // `0 = a_i`: a 0 passes the question on.
            if !letters.is_empty() || !side.is_zero() {
                break;
            }
        }
        self.fixed = letters.iter().cloned().collect();
        for (side, _) in &sides[first + 1..] {
            let open = self.free(side)?;
            if let Some(other) = open.iter().find(|o| !self.fixed.contains(&o.letter)) {
                return stray(&other.letter, &other.span);
            }
            let missing = letters.iter().find(|l| !self.loose.contains(*l) && !open.iter().any(|o| o.letter == **l));
            if let (Some(letter), false) = (missing, side.is_zero()) {
                let shown = name::to_latex(letter);
                let message = format!("the index `{shown}` stands free on the left side and not here");
                return refuse("latex::index", message, &side.span, "let it stand on both sides, or write components");
            }
        }
        Ok(letters)
    }

    fn limit_point(&mut self, target: &Target) -> Elaborated<LimitPoint> {
        Ok(match target {
            Target::PlusInfinity => LimitPoint::PlusInfinity,
            Target::MinusInfinity => LimitPoint::MinusInfinity,
            Target::Finite(node) => {
                if let Some(open) = self.free(node)?.first() {
                    return stray(&open.letter, &open.span);
                }
                let at = self.scalar(node)?;
                if self.moves(at) {
                    let hint = "write a number or a parameter";
                    return refuse("latex::limit", "the limit point depends on time", &node.span, hint);
                }
                LimitPoint::Finite(at)
            }
        })
    }

    /// Two sides as tensors of one shape: 0 and the identity matrix take the shape of the other side.
    fn same_shape(&mut self, left: &Value, right: &Value, span: &Range<usize>) -> Elaborated<(Tensor, Tensor)> {
        let (left, right) = match (left, right) {
            (Value::Tensor(a), Value::Tensor(b)) => (a.clone(), b.clone()),
            (Value::Identity(s), Value::Tensor(b)) => (self.identity_like(*s, &b.shape, span)?, b.clone()),
            (Value::Tensor(a), Value::Identity(s)) => (a.clone(), self.identity_like(*s, &a.shape, span)?),
            (Value::Identity(_), Value::Identity(_)) => {
                let hint = "compare it with a matrix";
                return refuse("latex::shape", "the size of the identity matrix is not clear here", span, hint);
            }
        };
        if left.shape == right.shape {
            return Ok((left, right));
        }
        if left.shape.real() == right.shape.real() {
            return Ok((tensor::complexified(self.graph, &left), tensor::complexified(self.graph, &right)));
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
        let matrix = left.shape.rank() == 2 || right.shape.rank() == 2;
        let scalar = left.shape.rank() == 0 || right.shape.rank() == 0;
        let hint = if matrix && scalar { r"the identity matrix is written `\mathbb{1}`" } else { "" };
        let message = format!("the left side is a {}, the right side a {}", left.shape, right.shape);
        refuse("latex::shape", message, span, hint)
    }

    // ---- evaluation ----------------------------------------------------------------------------------------------

    /// The value for every choice of the letters: a tensor with one axis for each.
    fn components(&mut self, node: &Node, letters: &[Name]) -> Elaborated<Tensor> {
        let mut extents = Vec::new();
        for letter in letters {
            extents.push(self.extent(letter, &node.span)?);
        }
        let count = extents.iter().try_fold(1usize, |n, &e| n.checked_mul(usize::from(e)));
        if count.is_none_or(|n| n > MOST_COMPONENTS) {
            let message = format!("more than {MOST_COMPONENTS} components");
            return refuse("latex::too-large", message, &node.span, "use fewer indices");
        }
        let shape = Shape::of(extents);
        let mut components = Vec::with_capacity(shape.len());
        for position in 0..shape.len() {
            let chosen = shape.indices(position);
            let before = self.values.len();
            self.values.extend(letters.iter().cloned().zip(chosen));
            let value = self.number(node);
            self.values.truncate(before);
            components.push(value?);
        }
        Ok(tensor::of_numbers(self.graph, shape, &components))
    }

    fn extent(&self, letter: &Name, span: &Range<usize>) -> Elaborated<u16> {
        match self.extents.get(letter) {
            Some(&n) => Ok(n),
            None => {
                let message = format!("it is not clear to where the index `{}` runs", name::to_latex(letter));
                refuse("latex::index", message, span, "let it stand at a vector or a matrix too")
            }
        }
    }

    fn value_of(&self, letter: &str) -> Option<u16> {
        self.values.iter().rev().find(|(l, _)| l == letter).map(|(_, v)| *v)
    }

    /// The value of a node as a tensor.
    fn tensor(&mut self, node: &Node) -> Elaborated<Tensor> {
        match self.value(node)? {
            Value::Tensor(t) => Ok(t),
            Value::Identity(_) => {
                let hint = r"compare it with a matrix, or add it to one; its components are written `\delta_{ij}`";
                refuse("latex::shape", "the size of the identity matrix is not clear here", &node.span, hint)
            }
        }
    }

    /// A real or complex number, not an array of them.
    fn number(&mut self, node: &Node) -> Elaborated<Tensor> {
        let t = self.tensor(node)?;
        if t.shape.real_extents().is_empty() {
            return Ok(t);
        }
        refuse("latex::shape", format!("a scalar is needed here, this is a {}", t.shape), &node.span, "")
    }

    /// Complex numbers whose parts have values together.
    fn joined(&mut self, t: Tensor) -> Tensor {
        let scope = self.scope;
        tensor::joined(self.graph, t, |l| scope.role(l.symbol) == Some(Role::Observable))
    }

    /// What a formula says as a whole: numbers, also where something is not there.
    fn settled(&mut self, t: Tensor) -> Tensor {
        let t = self.joined(t);
        tensor::settled(self.graph, t)
    }

    fn scalar(&mut self, node: &Node) -> Elaborated<Expr> {
        let t = self.tensor(node)?;
        match t.as_scalar() {
            Some(e) => Ok(e),
            None if t.shape.is_complex() && t.shape.real_extents().is_empty() => {
                let hint = r"write `\operatorname{Re}(z)`, `\operatorname{Im}(z)` or `|z|`";
                refuse("latex::shape", "a real number is needed here, this is a complex one", &node.span, hint)
            }
            None => refuse("latex::shape", format!("a scalar is needed here, this is a {}", t.shape), &node.span, ""),
        }
    }

    /// Whether an expression depends on time.
    fn moves(&self, e: Expr) -> bool {
        self.graph.leaves_within([e]).into_iter().any(|leaf| self.is_moving(leaf))
    }
}
