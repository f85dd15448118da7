//! Values of nodes: sums, products, functions.

use std::ops::{ControlFlow, Range};

use super::super::parse::operation;
use super::super::scope::{Logarithm, NO_BASE, Role};
use super::super::syntax::{Name, Node, NodeKind, Sign, indices};
use super::super::tensor;
use super::{Elaborated, Elaborator, MOST_WORK, refuse};
use expr::{Expr, Graph, Op, Rational, Shape, Tensor};

/// What a part of a formula stands for.
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// An array of expressions.
    Tensor(Tensor),
    /// A multiple of the identity matrix, whose size follows from what it is compared with or added to.
    Identity(Expr),
}

impl Value {
    fn scalar(e: Expr) -> Value {
        Value::Tensor(Tensor::scalar(e))
    }

    /// Whether its components are parts of complex numbers.
    pub(super) fn is_complex(&self) -> bool {
        matches!(self, Value::Tensor(t) if t.shape.is_complex())
    }
}

impl Elaborator<'_> {
    /// The value of a node; every index that it leaves free has a value.
    pub(super) fn value(&mut self, node: &Node) -> Elaborated<Value> {
        self.work += 1;
        if self.work > MOST_WORK {
            let hint = "use abbreviations, or fewer indices";
            return refuse("latex::too-large", "this formula stands for too many terms", &node.span, hint);
        }
        match self.sums.get(&std::ptr::from_ref(node)).cloned() {
            Some(letters) => self.summed(node, &letters),
            None => self.term(node),
        }
    }

    /// Sum over the letters.
    fn summed(&mut self, node: &Node, letters: &[Name]) -> Elaborated<Value> {
        let Some((letter, rest)) = letters.split_first() else { return self.term(node) };
        let extent = self.extent(letter, &node.span)?;
        let mut sum: Option<Value> = None;
        for value in 1..=extent {
            self.values.push((letter.clone(), value));
            let term = self.summed(node, rest);
            self.values.pop();
            let term = term?;
            sum = Some(match sum {
                None => term,
                Some(s) => self.plus(s, term, &node.span)?,
            });
        }
        sum.map_or_else(|| refuse("latex::index", "an index without values", &node.span, ""), Ok)
    }

    /// x + y, written as a difference where y is negated.
    fn plus(&mut self, x: Value, y: Value, span: &Range<usize>) -> Elaborated<Value> {
        self.combine(x, y, span, |g, x, y| match *g.node(y) {
            expr::Node::Unary(Op::Neg, inner) => g.sub(x, inner),
            _ => g.add(x, y),
        })
    }

    pub(super) fn combine(
        &mut self,
        x: Value,
        y: Value,
        span: &Range<usize>,
        f: impl Fn(&mut Graph, Expr, Expr) -> Expr,
    ) -> Elaborated<Value> {
        if let (Value::Identity(a), Value::Identity(b)) = (&x, &y) {
            return Ok(Value::Identity(f(self.graph, *a, *b)));
        }
        let zero = |v: &Value, g: &Graph| matches!(v, Value::Tensor(t) if t.as_scalar().is_some_and(|e| g.is_zero(e)));
        match (&x, &y) {
            (Value::Identity(_), _) if zero(&y, self.graph) => return Ok(x),
            (_, Value::Identity(_)) if zero(&x, self.graph) => {
                return Ok(self.map(y, |g, e| {
                    let z = g.integer(0);
                    f(g, z, e)
                }));
            }
            _ => {}
        }
        let (a, b) = self.same_shape(&x, &y, span).map_err(|mut p| {
            let message = p.message.replace("the left side is", "the terms before are");
            p.message = message.replace("the right side", "this term is");
            p
        })?;
        let pairs = a.components.iter().zip(&b.components);
        let components = pairs.map(|(&x, &y)| f(self.graph, x, y)).collect();
        Ok(Value::Tensor(Tensor { shape: a.shape, components }))
    }

    fn sum(&mut self, terms: &[(Sign, Node)], span: &Range<usize>) -> Elaborated<Value> {
        let mut sum: Option<Value> = None;
        for (sign, term) in terms {
            let mut value = self.value(term)?;
            if matches!(sign, Sign::PlusMinus | Sign::MinusPlus) {
                let leaf = self.scope.branch_sign();
                value = self.map(value, |g, e| {
                    let s = g.leaf(leaf);
                    g.term(s, e)
                });
            }
            let negative = matches!(sign, Sign::Minus | Sign::MinusPlus);
            sum = Some(match (sum, negative) {
                (None, false) => value,
                (None, true) => self.map(value, |g, e| g.neg(e)),
                (Some(s), false) => self.combine(s, value, &term.span, |g, x, y| g.add(x, y))?,
                (Some(s), true) => self.combine(s, value, &term.span, |g, x, y| g.sub(x, y))?,
            });
        }
        sum.map_or_else(|| refuse("latex::empty", "an empty sum", span, ""), Ok)
    }

    pub(super) fn map(&mut self, value: Value, f: impl Fn(&mut Graph, Expr) -> Expr) -> Value {
        match value {
            Value::Identity(s) => Value::Identity(f(self.graph, s)),
            Value::Tensor(t) => {
                let components = t.components.into_iter().map(|e| f(self.graph, e)).collect();
                Value::Tensor(Tensor { shape: t.shape, components })
            }
        }
    }

    /// s·1 in the shape of a square matrix.
    pub(super) fn identity_like(&mut self, s: Expr, shape: &Shape, span: &Range<usize>) -> Elaborated<Tensor> {
        match *shape.real_extents() {
            [n, m] if n == m => Ok(tensor::diagonal(self.graph, &vec![s; usize::from(n)])),
            _ => {
                let message = format!("the identity matrix stands beside a {shape}");
                refuse(
                    "latex::shape",
                    message,
                    span,
                    r"the components of the identity matrix are written `\delta_{ij}`",
                )
            }
        }
    }

    /// The value of a node whose indices all have values, without the sums that belong to the node itself.
    fn term(&mut self, node: &Node) -> Elaborated<Value> {
        match &node.kind {
            NodeKind::Number(r) => Ok(Value::scalar(self.graph.constant(r.clone()))),
            NodeKind::Pi => Ok(Value::scalar(self.graph.pi())),
            NodeKind::Euler { .. } => {
                let one = self.graph.integer(1);
                Ok(Value::scalar(self.graph.unary(Op::Exp, one)))
            }
            NodeKind::Identity => Ok(Value::Identity(self.graph.integer(1))),
            NodeKind::Symbol(s) => self.symbol(s, &node.span).map(Value::Tensor),
            NodeKind::Group(inner, _) => self.value(inner),
            NodeKind::Scripted { base, sub: None, sup: Some(sup), .. } if self.is_squared_size(base, sup)? => {
                self.squared_size(base, sup).map(Value::scalar)
            }
            NodeKind::Scripted { base, sub, sup, sup_first } => {
                let sub = sub.as_deref().map(indices);
                if let Some(held) = self.held(base, sub.as_deref()) {
                    let value = Value::Tensor(self.holding(base, &held, &node.span)?);
                    return self.scripted(value, None, sup.as_deref(), *sup_first, &node.span);
                }
                let base_value = self.value(base)?;
                self.scripted(base_value, sub.as_deref(), sup.as_deref(), *sup_first, &node.span)
            }
            NodeKind::Sum(terms) => self.sum(terms, &node.span),
            NodeKind::Product(parts) => {
                let mut values = Vec::new();
                for part in parts {
                    values.push((self.value(part)?, part.span.clone()));
                }
                self.component_is_clear(parts, &values)?;
                self.product(values, &node.span)
            }
            NodeKind::Dot(parts) => self.dot(parts, &node.span),
            NodeKind::Cross { left, right, bracket } => {
                if *bracket && let Some(commutator) = self.commutator(left, right, false, &node.span)? {
                    return Ok(commutator);
                }
                let (a, b) = (self.tensor(left)?, self.tensor(right)?);
                // `3\times10^8`, `a\times b`: between numbers it is a product; components could be those of a vector product.
                // No vector product has a matrix: `\frac{k}{m}\times M`.
                let rank = |t: &Tensor| t.shape.real_extents().len();
                let numbers = rank(&a) == 0 && matches!(rank(&b), 0 | 2) || rank(&a) == 2 && rank(&b) == 0;
                if numbers && !*bracket && self.values.is_empty() {
                    let (a, b) = (Value::Tensor(a), Value::Tensor(b));
                    return self.product(vec![(a, left.span.clone()), (b, right.span.clone())], &node.span);
                }
                if matches!(left.kind, NodeKind::Cross { bracket: false, .. }) {
                    let hint = "put parentheses around two of the factors";
                    return refuse("latex::ambiguous", "the product `\\times` is not associative", &node.span, hint);
                }
                tensor::cross(self.graph, &a, &b, &node.span).map(Value::Tensor)
            }
            NodeKind::Quotient { top, bottom, .. } => {
                let value = self.value(top)?;
                let under = self.number(bottom)?;
                let Some(under) = under.as_scalar().filter(|_| !value.is_complex()) else {
                    return self.complex_quotient(&value, &under, &node.span).map(Value::Tensor);
                };
                Ok(self.map(value, |g, e| if g.is_absent(e) && !g.is_zero(under) { e } else { g.div(e, under) }))
            }
            NodeKind::Root(a, degree) => {
                let number = self.number(a)?;
                let Some(e) = number.as_scalar() else {
                    let exponent = Rational::ONE / Rational::from(*degree);
                    return self.rational_power(&number, &exponent, &node.span).map(Value::Tensor);
                };
                if *degree == 2 {
                    return Ok(Value::scalar(self.graph.unary(Op::Sqrt, e)));
                }
                let one = self.graph.integer(1);
                let degree = self.graph.integer(i64::from(*degree));
                let exponent = self.graph.div(one, degree);
                Ok(Value::scalar(self.graph.binary(Op::Pow, e, exponent)))
            }
            NodeKind::Exponential { exponent: a, .. } => {
                let number = self.number(a)?;
                match number.as_scalar() {
                    Some(e) => Ok(Value::scalar(self.graph.unary(Op::Exp, e))),
                    None => self.complex_function("exp", &number, &node.span).map(Value::Tensor),
                }
            }
            NodeKind::Conjugate(inner) => {
                let t = self.tensor(inner)?;
                self.conjugate(&t, &node.span).map(Value::Tensor)
            }
            NodeKind::Conjugation { .. } => {
                refuse("latex::unexpected", "this stands behind what is conjugated", &node.span, "")
            }
            NodeKind::Absolute(a) => {
                let t = self.tensor(a)?;
                if t.shape == Shape::scalar().complexified() {
                    return self.size(a).map(Value::scalar);
                }
                if t.shape.is_complex() && t.shape.real_extents().len() < 2 {
                    let square = tensor::square_of_length(self.graph, &t);
                    return Ok(Value::scalar(self.graph.unary(Op::Sqrt, square)));
                }
                match t.shape.rank() {
                    0 => Ok(self.map(Value::Tensor(t), |g, e| g.unary(Op::Abs, e))),
                    1 => {
                        let square = tensor::dot(self.graph, &t, &t, &node.span)?;
                        Ok(self.map(Value::Tensor(square), |g, e| g.unary(Op::Sqrt, e)))
                    }
                    _ => {
                        let hint = r"write `\det`, or a norm by components";
                        refuse("latex::shape", "a matrix has no absolute value", &node.span, hint)
                    }
                }
            }
            NodeKind::Function(function, power, arguments) => {
                let value = self.function(function, arguments, &node.span)?;
                match power {
                    Some(n) if value.shape.is_complex() => {
                        self.rational_power(&value, &Rational::from(*n), &node.span).map(Value::Tensor)
                    }
                    Some(n) if value.shape.rank() == 0 => Ok(self.map(Value::Tensor(value), |g, e| g.powi(e, *n))),
                    Some(_) => refuse("latex::shape", "a power of something that is no number", &node.span, ""),
                    None => Ok(Value::Tensor(value)),
                }
            }
            NodeKind::Derivative { of, by, order, .. } => {
                self.derivative(of, by, *order, &node.span).map(Value::Tensor)
            }
            NodeKind::Partial { of, by, .. } => self.partial(of, by, &node.span).map(Value::Tensor),
            NodeKind::Nabla { of, action } => self.nabla(of, action, &node.span).map(Value::Tensor),
            NodeKind::Poisson(left, right) => match self.commutator(left, right, true, &node.span)? {
                Some(anticommutator) => Ok(anticommutator),
                None => self.bracket(left, right, &node.span).map(Value::Tensor),
            },
            NodeKind::Variation { of, by } => self.variation(of, by, &node.span).map(Value::Tensor),
            NodeKind::Differential { of, .. } => {
                if let NodeKind::Symbol(s) = &of.kind
                    && matches!(self.resolve(s, &of.span)?.role, Role::Parameter | Role::Argument)
                {
                    let hint = "declare what changes as a state or an observable";
                    return refuse("latex::derivative", "the differential of a constant", &node.span, hint);
                }
                let value = self.tensor(of)?;
                self.time_derivative(value, &node.span).map(Value::Tensor)
            }
            NodeKind::At { of, time, bar } => {
                let value = self.tensor(of)?;
                let instant = self.scalar(time)?;
                let coordinate = bar.as_deref().and_then(|name| self.scope.coordinate(name));
                if let Some(leaf) = coordinate.filter(|l| self.scope.role(l.symbol) == Some(Role::Coordinate)) {
                    return self.at_coordinate(value, (leaf, instant), &node.span).map(Value::Tensor);
                }
                self.at_instant(value, instant, &time.span).map(Value::Tensor)
            }
            NodeKind::Factorial(inner) => {
                let n = self.scalar(inner)?;
                match self.whole(n).map(factorial) {
                    Some(n) => Ok(Value::scalar(self.graph.constant(n))),
                    None => {
                        let message = format!("a factorial is that of a whole number from 0 to {LARGEST_FACTORIAL}");
                        refuse("latex::unsupported", message, &node.span, "")
                    }
                }
            }
            NodeKind::Tuple(parts) => {
                let components = self.numbers(parts)?;
                let Some(n) = u16::try_from(components.len()).ok().filter(|n| usize::from(*n) <= LONGEST_TUPLE) else {
                    let message = format!("a vector of more than {LONGEST_TUPLE} components");
                    return refuse("latex::too-large", message, &node.span, "");
                };
                Ok(Value::Tensor(tensor::of_numbers(self.graph, Shape::vector(n), &components)))
            }
            NodeKind::Matrix(rows) => {
                let mut components = Vec::new();
                for row in rows {
                    components.extend(self.numbers(row)?);
                }
                let columns = rows.first().map_or(0, Vec::len);
                // One column is a vector.
                let shape = match (rows.len() as u16, columns as u16) {
                    (1, 1) => Shape::scalar(),
                    (n, 1) => Shape::vector(n),
                    (n, m) => Shape::matrix(n, m),
                };
                Ok(Value::Tensor(tensor::of_numbers(self.graph, shape, &components)))
            }
            NodeKind::Limit(..) => refuse("latex::limit", "a limit stands alone on the left side", &node.span, ""),
        }
    }

    fn numbers(&mut self, nodes: &[Node]) -> Elaborated<Vec<Tensor>> {
        nodes.iter().map(|n| self.number(n)).collect()
    }

    fn scalars(&mut self, nodes: &[Node]) -> Elaborated<Vec<Expr>> {
        nodes.iter().map(|n| self.scalar(n)).collect()
    }

    /// Juxtaposed factors.
    pub(super) fn product(&mut self, factors: Vec<(Value, Range<usize>)>, span: &Range<usize>) -> Elaborated<Value> {
        let mut identity = false;
        let mut tensors = Vec::new();
        for (value, at) in factors {
            match value {
                Value::Tensor(t) => tensors.push((t, at)),
                Value::Identity(s) => {
                    identity = true;
                    let row = tensors.iter().any(|(t, _)| t.shape.real_extents().len() == 1);
                    if row {
                        let hint = r"write the matrix before the vector; `({\bf a}\cdot{\bf b})\mathbb{1}` for a number times the matrix";
                        return refuse("latex::shape", "no product of a vector and a matrix", span, hint);
                    }
                    // As a factor the identity matrix is a number.
                    if !self.graph.is_one(s) || tensors.is_empty() {
                        tensors.push((Tensor::scalar(s), at));
                    }
                }
            }
        }
        let scalars = tensors.iter().all(|(t, _)| t.shape.rank() == 0);
        let t = tensor::product(self.graph, tensors, span)?;
        if identity && t.shape == Shape::scalar().complexified() {
            let hint = r"write the matrix by its components, or multiply a matrix";
            return refuse("latex::unsupported", "a complex multiple of the identity matrix", span, hint);
        }
        Ok(match (identity && scalars, t.as_scalar()) {
            (true, Some(s)) => Value::Identity(s),
            _ => Value::Tensor(t),
        })
    }

    /// A whole number from 0 to [`LARGEST_FACTORIAL`].
    fn whole(&self, e: Expr) -> Option<u16> {
        let n = self.graph.as_constant(e).and_then(|r| u16::try_from(r.clone()).ok());
        n.filter(|n| *n <= LARGEST_FACTORIAL)
    }

    fn dot(&mut self, parts: &[Node], span: &Range<usize>) -> Elaborated<Value> {
        let mut acc: Option<(Value, Range<usize>)> = None;
        let mut vectors = 0;
        // `{\bf a}\cdot{\bf b}\,\mathbb{1}` is a multiple of the identity matrix.
        if let [first, Node { kind: NodeKind::Product(factors), .. }] = parts
            && let [second, Node { kind: NodeKind::Identity, .. }] = factors.as_slice()
            && let (Value::Tensor(a), Value::Tensor(b)) = (self.value(first)?, self.value(second)?)
            && [&a, &b].iter().all(|t| t.shape.real_extents().len() == 1)
        {
            self.conjugation_is_clear(&a, &b, &[first.clone(), second.clone()], span)?;
            let number = tensor::dot(self.graph, &a, &b, span)?;
            let identity = Value::Identity(self.graph.integer(1));
            return self.product(vec![(Value::Tensor(number), span.clone()), (identity, span.clone())], span);
        }
        if let Some(value) = self.vector_by_scalar_product(parts, span)? {
            return Ok(value);
        }
        for part in parts {
            let value = self.value(part)?;
            let rank = |v: &Value| if let Value::Tensor(t) = v { t.shape.real_extents().len() } else { 2 };
            vectors += usize::from(rank(&value) == 1);
            if vectors > 2 {
                let hint = "put parentheses around two of the factors";
                return refuse("latex::ambiguous", "a scalar product of three vectors", span, hint);
            }
            acc = Some(match acc {
                None => (value, part.span.clone()),
                Some((Value::Tensor(a), at)) if a.shape.real_extents().len() == 1 && rank(&value) == 1 => {
                    let Value::Tensor(b) = value else { return self.value(part) };
                    let whole = at.start..part.span.end;
                    self.conjugation_is_clear(&a, &b, parts, &whole)?;
                    (Value::Tensor(tensor::dot(self.graph, &a, &b, &whole)?), whole)
                }
                Some((a, at)) => {
                    let whole = at.start..part.span.end;
                    let factors = vec![(a, at), (value, part.span.clone())];
                    (self.product(factors, &whole)?, whole)
                }
            });
        }
        acc.map_or_else(|| refuse("latex::empty", "an empty product", span, ""), |(v, _)| Ok(v))
    }

    fn function(&mut self, function: &str, arguments: &[Node], span: &Range<usize>) -> Elaborated<Tensor> {
        if function == "diag" || function == "diagonal" {
            let entries = self.scalars(arguments)?;
            if entries.len() > LONGEST_DIAGONAL {
                let message = format!("a diagonal of more than {LONGEST_DIAGONAL} entries");
                return refuse("latex::too-large", message, span, "");
            }
            return Ok(tensor::diagonal(self.graph, &entries));
        }
        if let ("det" | "tr", [argument]) = (function, arguments) {
            let t = self.tensor(argument)?;
            return match function {
                "det" => tensor::determinant(self.graph, &t, span),
                _ => tensor::trace(self.graph, &t, span),
            };
        }
        if let ("log", [argument, base]) = (function, arguments) {
            // The quotient of natural logarithms has a value where the argument and the base are positive, and the base is not 1.
            let base = self.scalar(base)?;
            let below = self.graph.unary(Op::Ln, base);
            let above = self.function("ln", std::slice::from_ref(argument), span)?;
            let components = above.components.into_iter().map(|e| self.graph.div(e, below)).collect();
            return Ok(Tensor { shape: above.shape, components });
        }
        // An argument is read once: read twice, functions of functions would double the work at each level.
        let values = match arguments {
            [argument] => match self.of_complex(function, argument, span)? {
                ControlFlow::Break(value) => return Ok(value),
                ControlFlow::Continue(real) => vec![real],
            },
            _ => self.scalars(arguments)?,
        };
        if let ("binom", &[n, k]) = (function, values.as_slice()) {
            return match (self.whole(n), self.whole(k)) {
                (Some(n), Some(k)) => Ok(Tensor::scalar(self.graph.constant(binomial(n, k)))),
                _ => {
                    let message = format!("a binomial is of whole numbers from 0 to {LARGEST_FACTORIAL}");
                    refuse("latex::unsupported", message, span, "")
                }
            };
        }
        if let &[x] = values.as_slice()
            && let Some(e) = self.composed(function, x, span)?
        {
            return Ok(Tensor::scalar(e));
        }
        let g = &mut *self.graph;
        let Some(op) = operation(function) else {
            return refuse("latex::unknown-function", format!("`{function}` is not known"), span, "");
        };
        let e = match *values.as_slice() {
            [x] if op.arity() == 1 => g.unary(op, x),
            [a, b] if op.arity() == 2 => g.binary(op, a, b),
            _ => return refuse("latex::arity", format!("`{function}` has another number of arguments"), span, ""),
        };
        Ok(Tensor::scalar(e))
    }

    /// Functions that are made of others.
    fn composed(&mut self, function: &str, x: Expr, span: &Range<usize>) -> Elaborated<Option<Expr>> {
        let one = self.graph.integer(1);
        let g = &mut *self.graph;
        Ok(Some(match function {
            "cot" => {
                let (c, s) = (g.unary(Op::Cos, x), g.unary(Op::Sin, x));
                g.div(c, s)
            }
            "sec" | "csc" | "sech" | "csch" | "coth" => {
                let op = match function {
                    "sec" => Op::Cos,
                    "csc" => Op::Sin,
                    "sech" => Op::Cosh,
                    "csch" => Op::Sinh,
                    _ => Op::Tanh,
                };
                let below = g.unary(op, x);
                g.div(one, below)
            }
            // ln(x + √(x² ± 1)); for acosh, the root of x² − 1 and the logarithm leave x ≥ 1.
            "asinh" | "acosh" => {
                let square = g.powi(x, 2);
                let inside = if function == "asinh" { g.add(square, one) } else { g.sub(square, one) };
                let root = g.unary(Op::Sqrt, inside);
                let sum = g.add(x, root);
                g.unary(Op::Ln, sum)
            }
            "atanh" => {
                let (above, below) = (g.add(one, x), g.sub(one, x));
                let (ratio, two) = (g.div(above, below), g.integer(2));
                let logarithm = g.unary(Op::Ln, ratio);
                g.div(logarithm, two)
            }
            // x − ½ + atan2(sin 2πx, −cos 2πx)/2π: atan2 has the value π at its cut, so a whole number is its own whole part.
            "floor" | "ceil" => {
                let up = function == "ceil";
                if let Some(r) = g.as_constant(x) {
                    let whole = if up { r.ceil() } else { r.floor() };
                    return Ok(Some(g.constant(whole.into())));
                }
                let x = if up { g.neg(x) } else { x };
                let (two, pi) = (g.integer(2), g.pi());
                let turn = g.mul(two, pi);
                let angle = g.mul(turn, x);
                let (sine, cosine) = (g.unary(Op::Sin, angle), g.unary(Op::Cos, angle));
                let opposite = g.neg(cosine);
                let phase = g.binary(Op::Arctan2, sine, opposite);
                let (half, part) = (g.div(one, two), g.div(phase, turn));
                let middle = g.sub(x, half);
                let whole = g.add(middle, part);
                if up { g.neg(whole) } else { whole }
            }
            "sgn" => {
                let size = g.unary(Op::Abs, x);
                g.div(x, size)
            }
            "log" => {
                let logarithm = g.unary(Op::Ln, x);
                let base = self.logarithm_of_base(span)?;
                self.graph.div(logarithm, base)
            }
            _ => return Ok(None),
        }))
    }

    /// What the natural logarithm is divided by to give `\log`.
    pub(super) fn logarithm_of_base(&mut self, span: &Range<usize>) -> Elaborated<Expr> {
        match self.scope.logarithm() {
            Some(Logarithm::Natural) => Ok(self.graph.integer(1)),
            Some(Logarithm::Decimal) => {
                let ten = self.graph.integer(10);
                Ok(self.graph.unary(Op::Ln, ten))
            }
            None => {
                let hint = r#"write `\ln`, or say `log = "natural"` or `log = "decimal"` under [conventions] of a derivation file; `rederive prove` and `rederive lint` take `--log natural` or `--log decimal`"#;
                refuse(NO_BASE, "the base of `\\log` is not clear", span, hint)
            }
        }
    }
}

/// Largest number whose factorial is written out.
const LARGEST_FACTORIAL: u16 = 170;

/// n over k.
fn binomial(n: u16, k: u16) -> Rational {
    (0..k).fold(Rational::ONE, |product, i| product * Rational::from(n.saturating_sub(i)) / Rational::from(i + 1))
}

fn factorial(n: u16) -> Rational {
    (1..=n).fold(Rational::ONE, |product, k| product * Rational::from(k))
}

/// Most components of a vector that is written out.
const LONGEST_TUPLE: usize = 1024;

/// Most entries of a diagonal that is written out.
const LONGEST_DIAGONAL: usize = 32;
