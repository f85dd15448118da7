//! Functions in a form in which equal ones look the same: by laws of the checker.
//!
//! **In:** what is to vanish, and the facts that are not solved. **Out:** the same, with sines and exponentials of sums taken apart, functions of functions put together, and functions of
//! equal arguments written alike. **Guaranteed:** each change is a fact, which is put in after those that are solved.

use crate::eliminate::Solved;
use crate::fraction::fraction;
use crate::prove::Attempt;
use crate::vanish::Open;
use checker::{ConstantSign, FactId, Law, Relation, Step, SymbolKind, Term};
use expr::{Expr, Graph, Node, Op, Rational};
use std::collections::BTreeSet;

/// Most changes of one expression.
const MOST_CHANGES: usize = 80;
/// Most terms that are looked at to compare a root with 1.
const MOST_FOR_A_ROOT: usize = 60_000;
/// Most roots that are compared with 1.
const MOST_ROOTS: usize = 4;
/// Largest whole multiple of an argument that is taken apart.
const LARGEST_MULTIPLE: i64 = 12;

/// A node as another: by a law of certain expressions.
type Change = (Law, Vec<Expr>);

/// Whether an expression is written as a multiple of 0.
fn is_nothing(graph: &Graph, e: Expr) -> bool {
    let node = graph.node(e);
    if let Node::Binary(Op::Mul, a, b) = *node {
        return is_nothing(graph, a) || is_nothing(graph, b);
    }
    if let Node::Binary(Op::Add | Op::Sub, a, b) = *node {
        return is_nothing(graph, a) && is_nothing(graph, b);
    }
    if let Node::Binary(Op::Div, a, _) | Node::Unary(Op::Neg, a) = *node {
        return is_nothing(graph, a);
    }
    graph.is_zero(e)
}

impl Attempt<'_> {
    /// Changes functions as far as laws do; nothing where that is too large.
    pub(crate) fn normalise(&mut self, e: &mut Expr, rest: &mut [Open]) -> Option<()> {
        let mut refused: BTreeSet<Expr> = BTreeSet::new();
        for _ in 0..MOST_CHANGES {
            let roots: Vec<Expr> = rest.iter().map(|open| open.e).chain([*e]).collect();
            let nodes = self.search.reader.graph.reachable(roots);
            self.search.work += nodes.len();
            let units = self.units(&nodes);
            let at_nothing =
                nodes.iter().copied().find(|node| !refused.contains(node) && self.is_function_of_nothing(*node));
            let found = nodes.into_iter().filter(|node| !refused.contains(node)).find_map(|node| {
                let (law, of) = self.change(node, &units)?;
                Some((node, law, of))
            });
            let changed = match (at_nothing, found) {
                (Some(node), _) => match self.value_at_nothing(node) {
                    Some(changed) => changed,
                    None => {
                        refused.insert(node);
                        continue;
                    }
                },
                (None, Some((node, law, of))) => match self.by_law(node, law, &of) {
                    Some(changed) => changed,
                    None => {
                        refused.insert(node);
                        continue;
                    }
                },
                (None, None) => match self.equal_functions(*e, &mut refused) {
                    Some(changed) => changed,
                    None => return Some(()),
                },
            };
            self.search.put_in(e, changed).then_some(())?;
            for open in rest.iter_mut() {
                self.search.put_in(&mut open.e, changed).then_some(())?;
            }
        }
        Some(())
    }

    /// Whether a node is the sine, the cosine or the exponential of what is written as a multiple of 0.
    fn is_function_of_nothing(&self, node: Expr) -> bool {
        let graph = &self.search.reader.graph;
        let Node::Unary(op, a) = *graph.node(node) else { return false };
        [Op::Sin, Op::Cos, Op::Exp].contains(&op) && is_nothing(graph, a)
    }

    /// f(a) = f(0), which the graph knows.
    fn value_at_nothing(&mut self, node: Expr) -> Option<Solved> {
        let Node::Unary(op, a) = *self.search.reader.graph.node(node) else { return None };
        let zero = self.search.reader.graph.integer(0);
        let value = self.search.reader.graph.unary(op, zero);
        let says = self.search.reader.equation(zero, a)?;
        let before = std::mem::take(&mut self.search.solved);
        let equal = self.search.zero(says, None, &[], &[]);
        self.search.solved = before;
        let says = self.search.reader.equation(node, value)?;
        let fact = self.search.push(Step::Congruence { says, from: None, equal: vec![equal?] })?;
        self.search.solved.push(fact);
        Some(Solved { node, value })
    }

    /// The node as the right side of a law, whose left side is the node, or the same function of an argument that is equal.
    fn by_law(&mut self, node: Expr, law: Law, of: &[Expr]) -> Option<Solved> {
        let (fact, l, r) = self.search.law(law, of)?;
        if l == node {
            self.search.solved.push(fact);
            return Some(Solved { node, value: r });
        }
        // f·g = r, solved for f.
        if let Node::Binary(Op::Mul, f, g) = *self.search.reader.graph.node(l)
            && f == node
        {
            let value = self.search.reader.graph.div(r, g);
            let says = self.search.reader.equation(node, value)?;
            let (one, before) = (self.search.reader.graph.integer(1), std::mem::take(&mut self.search.solved));
            let found = self.search.zero(says, Some(g), &[(fact, one)], &[]);
            self.search.solved = before;
            self.search.solved.push(found?);
            return Some(Solved { node, value });
        }
        let same = self.same_value(node, l)?;
        let one = self.search.reader.graph.integer(1);
        let says = self.search.reader.equation(node, r)?;
        let before = std::mem::take(&mut self.search.solved);
        let found = self.search.zero(says, None, &[(same, one), (fact, one)], &[]);
        self.search.solved = before;
        self.search.solved.push(found?);
        Some(Solved { node, value: r })
    }

    /// f(a) = f(b), where a = b by algebra.
    pub(crate) fn same_value(&mut self, node: Expr, other: Expr) -> Option<FactId> {
        let argument = |e: Expr| match *self.search.reader.graph.node(e) {
            Node::Unary(op, a) => Some((op, a)),
            Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => None,
        };
        let ((f, a), (g, b)) = (argument(node)?, argument(other)?);
        if f != g {
            return None;
        }
        let says = self.search.reader.equation(a, b)?;
        let before = std::mem::take(&mut self.search.solved);
        let equal = self.search.zero(says.clone(), None, &[], &[]).or_else(|| {
            let difference = self.search.reader.graph.sub(a, b);
            let laws = self.laws(difference);
            self.search.zero(says, None, &[], &laws)
        });
        self.search.solved = before;
        let says = self.search.reader.equation(node, other)?;
        self.search.push(Step::Congruence { says, from: None, equal: vec![equal?] })
    }

    /// Two functions whose arguments are equal by algebra: the later one becomes the earlier.
    fn equal_functions(&mut self, e: Expr, refused: &mut BTreeSet<Expr>) -> Option<Solved> {
        let graph = &self.search.reader.graph;
        let is_function = |n: &Expr| match graph.node(*n) {
            Node::Unary(op, _) => !matches!(op, Op::Neg | Op::Powi(_)),
            Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => false,
        };
        let functions: Vec<Expr> = graph.reachable([e]).into_iter().filter(is_function).collect();
        for (at, &later) in functions.iter().enumerate() {
            for &earlier in &functions[..at] {
                if refused.contains(&later) || self.search.is_spent() {
                    break;
                }
                if let Some(same) = self.same_value(later, earlier) {
                    self.search.solved.push(same);
                    return Some(Solved { node: later, value: earlier });
                }
            }
            refused.insert(later);
        }
        None
    }

    /// The arguments of circular functions and of exponentials, each as a number times something, by what they are numbers of; with the least common denominator of the numbers.
    fn units(&mut self, nodes: &[Expr]) -> Vec<(Expr, Rational)> {
        let mut out: Vec<(Expr, Rational)> = Vec::new();
        for &node in nodes {
            let Node::Unary(Op::Sin | Op::Cos | Op::Tan | Op::Exp | Op::Sinh | Op::Cosh | Op::Tanh, a) =
                *self.search.reader.graph.node(node)
            else {
                continue;
            };
            let (number, unit) = self.multiple(a);
            let denominator = Rational::from_parts(number.denominator().clone().into(), 1u8.into());
            match out.iter_mut().find(|(known, _)| *known == unit) {
                Some((_, common)) => {
                    let ratio = denominator.clone() / common.clone();
                    *common = common.clone() * Rational::from_parts(ratio.numerator().clone(), 1u8.into());
                }
                None => out.push((unit, denominator)),
            }
        }
        out
    }

    /// An expression as a number times another one.
    pub(crate) fn multiple(&mut self, e: Expr) -> (Rational, Expr) {
        let graph = &mut self.search.reader.graph;
        let (mut number, mut open, mut others) = (Rational::ONE, vec![e], Vec::new());
        while let Some(e) = open.pop() {
            if let Some(r) = graph.as_constant(e) {
                number *= r.clone();
                continue;
            }
            match *graph.node(e) {
                Node::Unary(Op::Neg, a) => {
                    number = -number;
                    open.push(a);
                }
                Node::Binary(Op::Mul, a, b) => open.extend([b, a]),
                Node::Binary(Op::Div, a, b) => match graph.as_constant(b) {
                    Some(r) if *r != Rational::ZERO => {
                        number /= r.clone();
                        open.push(a);
                    }
                    _ => others.push(e),
                },
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => others.push(e),
            }
        }
        let Some((&first, rest)) = others.split_first() else { return (Rational::ONE, e) };
        let unit = rest.iter().fold(first, |unit, factor| graph.mul(unit, *factor));
        (number, unit)
    }

    /// How a function is changed.
    fn change(&mut self, node: Expr, units: &[(Expr, Rational)]) -> Option<Change> {
        if let Node::Binary(Op::Pow, u, v) = *self.search.reader.graph.node(node) {
            return self.power(u, v);
        }
        let Node::Unary(op, a) = *self.search.reader.graph.node(node) else { return None };
        match op {
            Op::Tan => Some((Law::Tangent, vec![a])),
            Op::Sinh => Some((Law::HyperbolicSine, vec![a])),
            Op::Cosh => Some((Law::HyperbolicCosine, vec![a])),
            Op::Tanh => Some((Law::HyperbolicTangent, vec![a])),
            // Where halves of an angle stand, too, its functions are those of the halves.
            Op::Sin | Op::Cos if self.has_parts(a, units) => {
                let laws = [[Law::SineOfSum, Law::SineOfOpposite], [Law::CosineOfSum, Law::CosineOfOpposite]];
                self.of_sum(a, laws[usize::from(op == Op::Cos)], units)
            }
            Op::Sin => {
                let inverses = [
                    (Op::Arcsin, Law::SineOfArcsine),
                    (Op::Arccos, Law::SineOfArccosine),
                    (Op::Arctan, Law::SineOfArctangent),
                ];
                let found = self.of_inverse(a, &inverses, Some(Law::SineOfAngle));
                found.or_else(|| self.of_sum(a, [Law::SineOfSum, Law::SineOfOpposite], units))
            }
            Op::Cos => {
                let inverses = [
                    (Op::Arcsin, Law::CosineOfArcsine),
                    (Op::Arccos, Law::CosineOfArccosine),
                    (Op::Arctan, Law::CosineOfArctangent),
                ];
                let found = self.of_inverse(a, &inverses, Some(Law::CosineOfAngle));
                found.or_else(|| self.of_sum(a, [Law::CosineOfSum, Law::CosineOfOpposite], units))
            }
            Op::Exp => {
                let found = self.of_inverse(a, &[(Op::Ln, Law::ExponentialOfLogarithm)], None);
                found.or_else(|| {
                    let laws = [Law::ExponentialOfSum, Law::ExponentialOfOpposite];
                    let (sum, apart) = (self.of_sum(a, laws, units), self.distributed(a));
                    sum.or_else(|| apart.map(|(p, q)| (Law::ExponentialOfSum, vec![p, q])))
                })
            }
            // Below an exponential it stays whole.
            Op::Ln if units.iter().any(|(unit, _)| *unit == node) => None,
            Op::Ln => {
                let found = self.of_inverse(a, &[(Op::Exp, Law::LogarithmOfExponential)], None);
                found.or_else(|| self.of_product(a, Law::LogarithmOfProduct, Law::LogarithmOfQuotient))
            }
            Op::Abs => self.is_positive(a).then_some((Law::AbsoluteOfPositive, vec![a])),
            Op::Sqrt => self.root(a),
            Op::Powi(2) => self.square_of_size(a),
            Op::Neg | Op::Arcsin | Op::Arccos | Op::Arctan | Op::Powi(_) => None,
            Op::Add
            | Op::Sub
            | Op::Mul
            | Op::Div
            | Op::Pow
            | Op::Arctan2
            | Op::Agm
            | Op::DirectionCosine
            | Op::Restrict => None,
        }
    }

    /// A power with a rational exponent as a whole power of a root; another one as an exponential.
    fn power(&mut self, u: Expr, v: Expr) -> Option<Change> {
        let graph = &mut self.search.reader.graph;
        let Some(exponent) = graph.as_constant(v).cloned() else { return Some((Law::Power, vec![u, v])) };
        if *exponent.numerator() == 1.into() || exponent == Rational::ZERO {
            return None;
        }
        let whole = Rational::from_parts(exponent.numerator().clone(), 1u8.into());
        let [part, whole] = [exponent / whole.clone(), whole].map(|r| graph.constant(r));
        Some((Law::PowerOfPower, vec![u, part, whole]))
    }

    /// A product with a sum in it as a sum of two.
    fn distributed(&mut self, e: Expr) -> Option<(Expr, Expr)> {
        let node = self.search.reader.graph.node(e).clone();
        if let Node::Unary(Op::Neg, u) = node {
            let (p, q) = self.distributed(u)?;
            let graph = &mut self.search.reader.graph;
            return Some((graph.neg(p), graph.neg(q)));
        }
        let Node::Binary(op, u, v) = node else { return None };
        if op == Op::Add || op == Op::Sub {
            return Some((u, if op == Op::Add { v } else { self.search.reader.graph.neg(v) }));
        }
        if op != Op::Mul && op != Op::Div {
            return None;
        }
        if let Some((p, q)) = self.distributed(u) {
            let graph = &mut self.search.reader.graph;
            return Some((graph.binary(op, p, v), graph.binary(op, q, v)));
        }
        let (p, q) = if op == Op::Mul { self.distributed(v)? } else { return None };
        let graph = &mut self.search.reader.graph;
        Some((graph.mul(u, p), graph.mul(u, q)))
    }

    /// Whether functions of parts of an angle are named, too.
    fn has_parts(&mut self, a: Expr, units: &[(Expr, Rational)]) -> bool {
        let (_, unit) = self.multiple(a);
        let Node::Binary(Op::Arctan2, ..) = *self.search.reader.graph.node(unit) else { return false };
        units.iter().any(|(known, parts)| *known == unit && *parts != Rational::ONE)
    }

    /// A function of the value of another one, by the law of the list; of an angle, by its own.
    fn of_inverse(&self, a: Expr, laws: &[(Op, Law)], of_angle: Option<Law>) -> Option<Change> {
        let node = self.search.reader.graph.node(a);
        if let Node::Unary(inner, u) = *node {
            return laws.iter().find(|(op, _)| *op == inner).map(|(_, law)| (*law, vec![u]));
        }
        if let Node::Binary(Op::Arctan2, v, u) = *node {
            return of_angle.map(|law| (law, vec![u, v]));
        }
        None
    }

    /// The square of a root of a quotient, which laws divide by only where the quotient is whole.
    fn square_of_size(&mut self, a: Expr) -> Option<Change> {
        let Node::Unary(Op::Sqrt, u) = *self.search.reader.graph.node(a) else { return None };
        let is_whole = fraction(&mut self.search.reader.graph, u).is_some_and(|f| f.is_whole());
        (!is_whole).then(|| (Law::SquareOfRoot, vec![u]))
    }

    fn of_product(&self, a: Expr, product: Law, quotient: Law) -> Option<Change> {
        let node = self.search.reader.graph.node(a);
        if let Node::Binary(Op::Mul, u, v) = *node {
            return Some((product, vec![u, v]));
        }
        if let Node::Binary(Op::Div, u, v) = *node {
            return Some((quotient, vec![u, v]));
        }
        None
    }

    /// The function of a sum, of an opposite, or of a whole multiple of the unit of its argument.
    fn of_sum(&mut self, a: Expr, [sum, opposite]: [Law; 2], units: &[(Expr, Rational)]) -> Option<Change> {
        let inner = self.search.reader.graph.node(a).clone();
        match inner {
            Node::Binary(Op::Add, u, v) => return Some((sum, vec![u, v])),
            Node::Binary(Op::Sub, u, v) => return Some((sum, vec![u, self.search.reader.graph.neg(v)])),
            Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {}
        }
        let (number, unit) = self.multiple(a);
        let common = units.iter().find(|(known, _)| *known == unit).map_or(Rational::ONE, |(_, n)| n.clone());
        let times = number * common.clone();
        if !times.denominator().is_one() {
            return None;
        }
        let times = i64::try_from(times.numerator()).ok().filter(|n| n.abs() <= LARGEST_MULTIPLE)?;
        let graph = &mut self.search.reader.graph;
        let divisor = graph.constant(common);
        let one = if graph.as_constant(divisor) == Some(&Rational::ONE) { unit } else { graph.div(unit, divisor) };
        match times {
            0 | 1 => None,
            n if n < 0 => {
                let (factor, base) = (graph.integer(-n), one);
                let positive = graph.mul(factor, base);
                Some((opposite, vec![if n == -1 { one } else { positive }]))
            }
            n => {
                let factor = graph.integer(n - 1);
                let others = if n == 2 { one } else { graph.mul(factor, one) };
                Some((sum, vec![one, others]))
            }
        }
    }

    /// How a root is changed: of a square, of a product or quotient with a positive factor, of a sum of fractions.
    fn root(&mut self, a: Expr) -> Option<Change> {
        let inner = self.search.reader.graph.node(a).clone();
        match inner {
            Node::Unary(Op::Powi(2), u) => return Some((Law::RootOfSquare, vec![u])),
            Node::Unary(Op::Powi(n), u) if n > 2 && self.is_positive(u) => {
                let (two, rest) = (self.search.reader.graph.powi(u, 2), self.search.reader.graph.powi(u, n - 2));
                return Some((Law::RootOfProduct, vec![two, rest]));
            }
            Node::Binary(Op::Mul, u, v) if u == v => return Some((Law::RootOfSquare, vec![u])),
            Node::Binary(Op::Mul, u, v) if self.is_positive(u) || self.is_positive(v) => {
                return Some((Law::RootOfProduct, vec![u, v]));
            }
            Node::Binary(Op::Div, u, v) if self.is_positive(u) || self.is_positive(v) => {
                return Some((Law::RootOfQuotient, vec![u, v]));
            }
            Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {}
        }
        let quotient = fraction(&mut self.search.reader.graph, a)?;
        if quotient.is_whole() {
            return None;
        }
        let under = quotient.denominator(&mut self.search.reader.graph);
        self.is_positive(under).then_some((Law::RootOfQuotient, vec![quotient.numerator, under]))
    }

    /// Whether an expression is positive since all in it is.
    pub(crate) fn is_positive(&self, e: Expr) -> bool {
        let graph = &self.search.reader.graph;
        match *graph.node(e) {
            Node::Constant(ref r) => **r > Rational::ZERO,
            Node::Pi => true,
            Node::Leaf(leaf) => {
                let name = graph.name(leaf.symbol);
                let declared = self.sequent.symbols.iter().find(|d| d.name == name);
                declared.is_some_and(|d| d.kind == SymbolKind::Constant(ConstantSign::Positive))
            }
            Node::Binary(Op::Add | Op::Mul | Op::Div, a, b) => self.is_positive(a) && self.is_positive(b),
            Node::Unary(Op::Powi(_) | Op::Sqrt, a) => self.is_positive(a),
            Node::Unary(Op::Exp | Op::Cosh, _) => true,
            Node::Unary(..) | Node::Binary(..) => false,
        }
    }

    /// Roots of what facts say to be 1, as √(sin²u + cos²u) where the sine and the cosine are components of a unit vector.
    pub(crate) fn unit_roots(&mut self, e: &mut Expr, rest: &mut [Open]) -> Option<()> {
        let graph = &self.search.reader.graph;
        let under = |node: Expr| {
            let Node::Unary(Op::Sqrt, a) = *graph.node(node) else { return None };
            Some((node, a))
        };
        let roots: Vec<(Expr, Expr)> = graph.reachable([*e]).into_iter().filter_map(under).take(MOST_ROOTS).collect();
        for (node, a) in roots {
            let graph = &mut self.search.reader.graph;
            let one = graph.integer(1);
            let difference = graph.sub(one, a);
            let says = self.search.reader.equation(one, a)?;
            let Some(equal) = self.complete_within(&says, difference, rest, MOST_FOR_A_ROOT) else { continue };
            let says = self.search.reader.equation(node, one)?;
            let Some(fact) = self.search.push(Step::Congruence { says, from: None, equal: vec![equal] }) else {
                continue;
            };
            self.search.solved.push(fact);
            let solved = Solved { node, value: one };
            self.search.put_in(e, solved).then_some(())?;
            for open in rest.iter_mut() {
                self.search.put_in(&mut open.e, solved).then_some(())?;
            }
        }
        Some(())
    }

    /// l = r, since l² = r², and neither is negative.
    pub(crate) fn by_squares(&mut self, claim: &Relation, left: Expr, right: Expr) -> Option<FactId> {
        let graph = &mut self.search.reader.graph;
        let [l, r] = [left, right].map(|e| graph.powi(e, 2));
        let goal = graph.sub(l, r);
        let says = self.search.reader.equation(l, r)?;
        let fact = self.algebra(&says, goal, crate::vanish::Beginning::Plain)?;
        let found = self.search.push(Step::Injective { fact, from: self.assumptions.clone() })?;
        let one = Term::integer(1);
        let step = Step::Zero {
            says: claim.clone(),
            multiplier: one.clone(),
            terms: vec![(found, one)],
            insert: vec![],
            modulo: vec![],
        };
        self.search.push(step)
    }
}
