//! Syntax trees as authors write them: numbers, signs, products, powers, and what is inside.
//!
//! **In:** nodes. **Out:** nodes that print as a person would have written them: no `1x`, no `--x`, `\frac{x}{4m}` for half of
//! `\frac{x}{2m}`. Whether a tree has a meaning is not asked here.

use std::ops::Range;

use crate::expr::Rational;
use crate::latex::syntax::{Bracket, Nabla, Node, NodeKind, Sign, SymbolNode, Target};

/// A number as a formula writes it.
pub(super) fn number(r: Rational, span: &Range<usize>) -> Node {
    let node = |kind| Node::new(kind, span.clone());
    if r.denominator().is_one() {
        return node(NodeKind::Number(r));
    }
    let (top, bottom) = (Rational::from(r.numerator().clone()), Rational::from(r.denominator().clone()));
    let part = |r| Box::new(node(NodeKind::Number(r)));
    node(NodeKind::Quotient { top: part(top), bottom: part(bottom), slash: false })
}

/// The value of a node that is written as a number or a fraction of numbers.
pub(super) fn as_number(node: &Node) -> Option<Rational> {
    match &node.kind {
        NodeKind::Number(r) => Some(r.clone()),
        NodeKind::Quotient { top, bottom, .. } => match (&top.kind, &bottom.kind) {
            (NodeKind::Number(a), NodeKind::Number(b)) if *b != Rational::ZERO => Some(a / b),
            _ => None,
        },
        _ => None,
    }
}

/// A product without the factor at a place.
pub(super) fn without(parts: &[Node], at: usize, span: &Range<usize>) -> Option<Node> {
    let rest: Vec<Node> = parts.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, n)| n.clone()).collect();
    product(rest, span)
}

/// A product of factors; `None` of none.
pub(super) fn product(mut parts: Vec<Node>, span: &Range<usize>) -> Option<Node> {
    match parts.len() {
        0 => None,
        1 => parts.pop(),
        _ => Some(Node::new(NodeKind::Product(parts), span.clone())),
    }
}

/// A node times a number, written as simply as it can be.
pub(super) fn scaled(node: &Node, factor: &Rational) -> Node {
    let span = &node.span;
    if let Some(r) = as_number(node) {
        return number(r * factor, span);
    }
    match &node.kind {
        NodeKind::Product(parts) => {
            let mut parts = parts.clone();
            match parts.first().and_then(as_number) {
                Some(r) => {
                    let r = r * factor;
                    if r == Rational::ONE {
                        parts.remove(0);
                    } else {
                        parts[0] = number(r, span);
                    }
                }
                None => {
                    if let NodeKind::Quotient { .. } = &parts[0].kind {
                        parts[0] = scaled(&parts[0], factor);
                    } else {
                        parts.insert(0, number(factor.clone(), span));
                    }
                }
            }
            product(parts, span).unwrap_or_else(|| node.clone())
        }
        NodeKind::Quotient { top, bottom, slash } => {
            let lead = |n: &Node| match &n.kind {
                NodeKind::Product(parts) => parts.first().and_then(as_number),
                _ => as_number(n),
            };
            let quotient = |top: Node, bottom: Node| {
                let kind = NodeKind::Quotient { top: Box::new(top), bottom: Box::new(bottom), slash: *slash };
                Node::new(kind, span.clone())
            };
            let whole = |r: Option<Rational>| r.is_some_and(|r| r.denominator().is_one() && r != Rational::ZERO);
            let inverse = Rational::ONE / factor;
            // \frac{x}{2m} times 2 is \frac{x}{m}, times ½ it is \frac{x}{4m}.
            if whole(lead(top).map(|r| r * factor)) {
                return quotient(scaled(top, factor), (**bottom).clone());
            }
            if whole(lead(bottom).map(|r| r * &inverse)) {
                let under = scaled(bottom, &inverse);
                if as_number(&under) == Some(Rational::ONE) {
                    return (**top).clone();
                }
                return quotient((**top).clone(), under);
            }
            if factor.denominator().is_one() {
                quotient(scaled(top, factor), (**bottom).clone())
            } else {
                quotient((**top).clone(), scaled(bottom, &inverse))
            }
        }
        _ => {
            let parts = vec![number(factor.clone(), span), node.clone()];
            Node::new(NodeKind::Product(parts), span.clone())
        }
    }
}

/// The opposite of a node.
pub(super) fn negated(node: &Node) -> Node {
    if let NodeKind::Sum(terms) = &node.kind
        && let [(sign, inner)] = terms.as_slice()
    {
        match sign {
            Sign::Minus => return inner.clone(),
            Sign::Plus => return Node::new(NodeKind::Sum(vec![(Sign::Minus, inner.clone())]), node.span.clone()),
            Sign::PlusMinus | Sign::MinusPlus => {}
        }
    }
    Node::new(NodeKind::Sum(vec![(Sign::Minus, node.clone())]), node.span.clone())
}

/// A sum of terms; without its sign where it is a single positive one.
pub(super) fn sum(mut terms: Vec<(Sign, Node)>, span: &Range<usize>) -> Node {
    if let [(Sign::Plus, _)] = terms.as_slice()
        && let Some((_, only)) = terms.pop()
    {
        return only;
    }
    Node::new(NodeKind::Sum(terms), span.clone())
}

/// An exponent that is written as a whole number.
pub(super) fn exponent(node: &Node) -> Option<i64> {
    match &node.kind {
        NodeKind::Number(r) if r.denominator().is_one() => i64::try_from(r.numerator().clone()).ok(),
        NodeKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, inner)] => exponent(inner).map(|n| -n),
            _ => None,
        },
        _ => None,
    }
}

/// A whole exponent; none for 1.
pub(super) fn raised(n: i64, span: &Range<usize>) -> Option<Box<Node>> {
    let positive = Node::new(NodeKind::Number(Rational::from(n.abs())), span.clone());
    match n {
        1 => None,
        n if n < 0 => Some(Box::new(Node::new(NodeKind::Sum(vec![(Sign::Minus, positive)]), span.clone()))),
        _ => Some(Box::new(positive)),
    }
}

/// The powers next to one; never 0, which leaves out the factor.
pub(super) fn neighbours(n: i64) -> impl Iterator<Item = i64> {
    [n - 1, n + 1].into_iter().map(move |m| if m == 0 { m + (m - n) } else { m })
}

/// The mark of a transpose.
pub(super) fn transpose(span: &Range<usize>) -> Node {
    let symbol = SymbolNode {
        name: "T".into(),
        dots: 0,
        primed: false,
        sub: None,
        sup: None,
        sup_first: false,
        arguments: None,
        arguments_text: String::new(),
    };
    Node::new(NodeKind::Symbol(symbol), span.clone())
}

/// Whether a superscript is the mark of a transpose or of a conjugate.
pub(super) fn is_transpose(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Conjugation { .. })
        || matches!(&node.kind, NodeKind::Symbol(s) if matches!(s.name.as_str(), "T" | "\\top" | "rm:T") && s.sub.is_none())
}

/// The parts of a node, to be replaced, in the order of [`Node::children`].
pub(super) fn parts_mut(node: &mut Node) -> Vec<&mut Node> {
    match &mut node.kind {
        NodeKind::Number(_)
        | NodeKind::Pi
        | NodeKind::Euler { .. }
        | NodeKind::Identity
        | NodeKind::Conjugation { .. } => Vec::new(),
        NodeKind::Symbol(s) => s.sup.as_deref_mut().into_iter().chain(s.arguments.iter_mut().flatten()).collect(),
        NodeKind::Scripted { base, sup, .. } => std::iter::once(&mut **base).chain(sup.as_deref_mut()).collect(),
        NodeKind::Sum(terms) => terms.iter_mut().map(|(_, n)| n).collect(),
        NodeKind::Product(parts) | NodeKind::Dot(parts) | NodeKind::Tuple(parts) => parts.iter_mut().collect(),
        NodeKind::Function(_, _, arguments) => arguments.iter_mut().collect(),
        NodeKind::Cross { left, right, .. } | NodeKind::Poisson(left, right) => vec![left, right],
        NodeKind::Quotient { top, bottom, .. } => vec![top, bottom],
        NodeKind::Derivative { of, by, .. } | NodeKind::Variation { of, by } => vec![of, by],
        NodeKind::Partial { of, by, .. } => std::iter::once(&mut **of).chain(by).collect(),
        NodeKind::Nabla { of, action: Nabla::Along(direction) } => vec![direction, of],
        NodeKind::Nabla { of, .. } => vec![of],
        NodeKind::At { of, time, .. } => vec![of, time],
        NodeKind::Factorial(a)
        | NodeKind::Differential { of: a, .. }
        | NodeKind::Group(a, _)
        | NodeKind::Root(a, _)
        | NodeKind::Absolute(a)
        | NodeKind::Conjugate(a) => vec![a],
        NodeKind::Exponential { exponent, .. } => vec![exponent],
        NodeKind::Matrix(rows) => rows.iter_mut().flatten().collect(),
        NodeKind::Limit(body, target) => match target {
            Target::Finite(at) => vec![at, body],
            Target::PlusInfinity | Target::MinusInfinity => vec![body],
        },
    }
}

/// Every node of a tree, parents first.
pub(super) fn walk<'n>(node: &'n Node, out: &mut Vec<&'n Node>) {
    out.push(node);
    for child in node.children() {
        walk(child, out);
    }
}

/// Something to a whole power.
pub(super) fn scripted(base: Node, n: i64) -> Node {
    let span = base.span.clone();
    let sup = raised(n, &span);
    Node::new(NodeKind::Scripted { base: Box::new(base), sub: None, sup, sup_first: false }, span)
}

/// The same tree with all places removed, and without an order of indices where there is one, so that trees can be compared.
pub(super) fn without_places(node: &Node) -> Node {
    let mut out = node.clone();
    out.span = 0..0;
    match &mut out.kind {
        NodeKind::Symbol(symbol) => symbol.sup_first &= symbol.sub.is_some(),
        NodeKind::Scripted { sub, sup_first, .. } => *sup_first &= sub.is_some(),
        _ => {}
    }
    for part in parts_mut(&mut out) {
        *part = without_places(part);
    }
    out
}

/// A tree in which no quotient has the same factor above and below, and no sum a term and its opposite: what is multiplied and
/// divided again, and what is added and taken away again, says nothing.
pub(super) fn cancelled(node: &Node) -> Node {
    let mut out = node.clone();
    let mut vanished = false;
    for part in parts_mut(&mut out) {
        let new = cancelled(part);
        vanished |= new.is_zero() && !part.is_zero();
        *part = new;
    }
    if let Some(without) = without_opposites(&out, vanished) {
        return without;
    }
    if let NodeKind::Product(parts) = &out.kind {
        let divides = |factor: &Node| {
            parts.iter().position(|part| match &part.kind {
                NodeKind::Quotient { bottom, .. } => without_places(bottom) == without_places(factor),
                _ => false,
            })
        };
        let found = (0..parts.len()).find_map(|at| Some((at, divides(&parts[at])?)));
        if let Some((at, quotient)) = found
            && let NodeKind::Quotient { top, .. } = &parts[quotient].kind
            && as_number(&parts[at]).is_none()
        {
            let mut left = parts.clone();
            left[quotient] = (**top).clone();
            left.remove(at);
            return product(left, &out.span).unwrap_or(out);
        }
    }
    let NodeKind::Quotient { top, bottom, slash } = &out.kind else { return out };
    let factors = |n: &Node| match &n.kind {
        NodeKind::Product(parts) => parts.clone(),
        _ => vec![n.clone()],
    };
    let (mut over, mut under) = (factors(top), factors(bottom));
    let before = over.len();
    // Numbers are left as they are: \frac{2}{2} is not what this is about.
    over.retain(|factor| {
        let same = |n: &Node| as_number(n).is_none() && without_places(n) == without_places(factor);
        under.iter().position(same).map(|at| under.remove(at)).is_none()
    });
    if over.len() == before {
        return out;
    }
    let one = || Node::new(NodeKind::Number(Rational::ONE), out.span.clone());
    let top = product(over, &out.span).unwrap_or_else(one);
    match product(under, &out.span) {
        None => top,
        Some(bottom) => {
            let kind = NodeKind::Quotient { top: Box::new(top), bottom: Box::new(bottom), slash: *slash };
            Node::new(kind, out.span.clone())
        }
    }
}

/// The opposite of a sign; `None` of ±.
fn turned(sign: Sign) -> Option<Sign> {
    match sign {
        Sign::Plus => Some(Sign::Minus),
        Sign::Minus => Some(Sign::Plus),
        Sign::PlusMinus | Sign::MinusPlus => None,
    }
}

/// The terms of a sum, those of sums in parentheses among them.
fn flattened(terms: &[(Sign, Node)]) -> Vec<(Sign, Node)> {
    let mut out = Vec::new();
    for (sign, term) in terms {
        let inner = match &term.kind {
            NodeKind::Group(inner, Bracket::Round) => &inner.kind,
            other => other,
        };
        let signed = |(own, part): &(Sign, Node)| {
            let own = if *sign == Sign::Plus { Some(*own) } else { turned(*own).filter(|_| *sign == Sign::Minus) };
            own.map(|own| (own, part.clone()))
        };
        let parts: Option<Vec<_>> = match inner {
            NodeKind::Sum(inner) => inner.iter().map(signed).collect(),
            _ => None,
        };
        match parts {
            Some(parts) => out.extend(parts),
            None => out.push((*sign, term.clone())),
        }
    }
    out
}

/// A sum without terms that take each other away, and what holds such a sum alone; `None` where nothing has vanished. `vanished`:
/// whether a part did.
fn without_opposites(node: &Node, vanished: bool) -> Option<Node> {
    let zero = || Node::new(NodeKind::Number(Rational::ZERO), node.span.clone());
    match &node.kind {
        NodeKind::Sum(terms) => {
            let mut left: Vec<(Sign, Node)> = Vec::new();
            let all = flattened(terms);
            for (sign, term) in &all {
                let opposite = |(other, known): &(Sign, Node)| {
                    turned(*sign) == Some(*other) && without_places(known) == without_places(term)
                };
                match left.iter().position(opposite) {
                    Some(at) => drop(left.remove(at)),
                    None if vanished && term.is_zero() => {}
                    None => left.push((*sign, term.clone())),
                }
            }
            let gone = left.len() < all.len();
            gone.then(|| if left.is_empty() { zero() } else { sum(left, &node.span) })
        }
        NodeKind::Product(parts) if vanished => parts.iter().any(Node::is_zero).then(zero),
        NodeKind::Group(inner, _) if vanished => inner.is_zero().then(zero),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Graph;
    use crate::latex::syntax::to_latex;
    use crate::latex::{self, Declaration, Role, Scope};

    #[test]
    fn what_is_multiplied_and_divided_again_is_left_out() {
        let mut graph = Graph::new();
        let mut scope = Scope::new(&mut graph);
        for name in ["t", "a", "b"] {
            let role = Role::Parameter;
            let scalar = Declaration::of(role);
            scope.declare(&mut graph, name, scalar).expect("a new name");
        }
        let simple = |text: &str| {
            let mut chains = latex::parse(text, &scope).expect("a formula");
            let mut chain = chains.remove(0);
            chain.sides = chain.sides.iter().map(cancelled).collect();
            to_latex(&chain)
        };
        assert_eq!(simple(r"\frac{ta}{t}"), "a");
        assert_eq!(simple(r"t\frac{a}{t}"), "a");
        assert_eq!(simple(r"\frac{a}{bt}"), r"\frac{a}{bt}");
        assert_eq!(simple(r"\frac{tta}{bt}"), r"\frac{ta}{b}");
        assert_eq!(simple(r"1+\frac{a}{a}"), "1+1");
        assert_eq!(simple(r"\frac{a^2b}{a^{2}}"), "b");
        assert_eq!(simple(r"\frac{2a}{2}"), r"\frac{2a}{2}");
        assert_eq!(simple(r"a+7(b-b)"), "a");
        assert_eq!(simple(r"7(b-b)"), "0");
        assert_eq!(simple(r"-a+b+a"), "b");
        assert_eq!(simple(r"t+7(a-b-(a-b))"), "t");
        assert_eq!(simple(r"t-(a-b)"), "t-(a-b)");
        assert_eq!(simple(r"a=0"), "a=0");
    }
}
