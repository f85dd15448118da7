//! Premises of high degree, written with lower ones that say the same of real numbers.
//!
//! **In:** equations among the premises. **Out:** equations with the same real solutions; `None` where none changes.
//!
//! * aⁿ = bⁿ is a = b for odd n, and for even n where neither a nor b is negative; otherwise it is a² = b².
//! * A polynomial in one unknown with rational coefficients is the product of its rational factors of degree 1 and a rest; the
//!   rest is left out where Sturm's theorem says that it has no real zero.

use super::linear::{Combination, Combinations, Monomial, expression};
use super::outcome::Premises;
use super::polynomial::fraction;
use expr::{Expr, Graph, Leaf, Node, Op, Rational};

/// Highest degree that is looked at.
const HIGHEST: usize = 12;
/// Numerators and denominators of rational zeros that are tried.
const LARGEST_ZERO: i64 = 60;

/// Premises with lower degrees, if there are any.
pub(super) fn simpler(graph: &mut Graph, given: &Premises) -> Option<Premises> {
    let mut out = given.clone();
    let mut changed = false;
    for known in &mut out.equations {
        let residual = graph.sub(known.left, known.right);
        let (top, under) = fraction(graph, residual);
        // A denominator may bring zeros of its own.
        if graph.as_constant(under).is_none() {
            continue;
        }
        let sum = Combinations::default().of(graph, top);
        let new = equal_powers(graph, given, &sum).or_else(|| by_zeros(graph, &sum));
        if let Some(pair) = new {
            *known = known.with(pair);
            changed = true;
        }
    }
    changed.then_some(out)
}

/// What is given as a number, `x = \sqrt[3]2`.
pub(super) fn numbers_given(graph: &Graph, given: &Premises) -> Vec<(Leaf, Expr)> {
    let mut out: Vec<(Leaf, Expr)> = Vec::new();
    for (left, right) in given.pairs() {
        for (l, r) in [(left, right), (right, left)] {
            let Node::Leaf(leaf) = *graph.node(l) else { continue };
            if graph.leaves_within([r]).is_empty() && !out.iter().any(|(of, _)| *of == leaf) {
                out.push((leaf, r));
            }
        }
    }
    out
}

/// Equations with numbers put in for what is given as one, where nothing but numbers is left: then they are equations between numbers, and
/// whatever else is given does not matter. It is put into nothing that is given: that may be known at other times, and with its rates.
pub(super) fn with_numbers(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    numbers: &[(Leaf, Expr)],
) -> Option<Vec<(Expr, Expr)>> {
    if numbers.is_empty() {
        return None;
    }
    let mut put = |e: Expr| graph.substitute(e, |_, leaf| numbers.iter().find(|(of, _)| *of == leaf).map(|(_, r)| *r));
    let out: Vec<(Expr, Expr)> = equations.iter().map(|&(l, r)| (put(l), put(r))).collect();
    graph.leaves_within(out.iter().flat_map(|&(l, r)| [l, r])).is_empty().then_some(out)
}

/// aⁿ = bⁿ.
fn equal_powers(graph: &mut Graph, given: &Premises, sum: &Combination) -> Option<(Expr, Expr)> {
    let mut terms = sum.iter();
    let (Some((m, p)), Some((n, q)), None) = (terms.next(), terms.next(), terms.next()) else { return None };
    let degree = m.iter().chain(n).fold(0, |d, &(_, k)| greatest_common_divisor(d, k.unsigned_abs()));
    // p·aⁿ = −q·bⁿ: with 1 before a.
    let ratio = -(q / p);
    let order = (2..=degree.min(HIGHEST as u32)).rev().find(|&k| {
        degree.is_multiple_of(k) && rational_root(&ratio, k).is_some() && (k % 2 != 0 || ratio > Rational::ZERO)
    })?;
    let root = |graph: &mut Graph, m: &Monomial, c: &Rational, k: u32| {
        let m: Monomial = m.iter().map(|&(b, n)| (b, n / k as i32)).collect();
        expression(graph, &m, c)
    };
    let scale = rational_root(&ratio, order)?;
    let (a, b) = (root(graph, m, &Rational::ONE, order), root(graph, n, &scale, order));
    if order % 2 != 0 {
        return Some((a, b));
    }
    let not_negative = |graph: &Graph, e: Expr| {
        let combination = Combinations::default().of(graph, e);
        combination.iter().all(|(m, q)| {
            *q >= Rational::ZERO && m.iter().all(|&(base, k)| k % 2 == 0 || is_not_negative(graph, given, base))
        })
    };
    if not_negative(graph, a) && not_negative(graph, b) {
        return Some((a, b));
    }
    if order == 2 {
        return None;
    }
    // (a²)^{n/2} = (b²)^{n/2}, where squares are not negative.
    Some((root(graph, m, &Rational::ONE, order / 2), root(graph, n, &(&scale * &scale), order / 2)))
}

fn is_not_negative(graph: &Graph, given: &Premises, base: Expr) -> bool {
    given.positive.contains(&base)
        || given.not_negative.contains(&base)
        || matches!(graph.node(base), Node::Unary(Op::Sqrt | Op::Abs | Op::Exp | Op::Cosh, _) | Node::Pi)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

/// The n-th root of a rational, if it is one; of a negative one for odd n.
fn rational_root(r: &Rational, n: u32) -> Option<Rational> {
    let (negative, size) = if *r < Rational::ZERO { (true, -r.clone()) } else { (false, r.clone()) };
    if negative && n.is_multiple_of(2) {
        return None;
    }
    let (top, under) = size.clone().into_parts();
    let top = top.into_parts().1.nth_root(n as usize);
    let under = under.nth_root(n as usize);
    let root = Rational::from(top) / Rational::from(under);
    (root.pow(n as isize) == size).then(|| if negative { -root } else { root })
}

/// The product of x − r over the rational zeros, and of what is left if it has real zeros.
fn by_zeros(graph: &mut Graph, sum: &Combination) -> Option<(Expr, Expr)> {
    let base = sum.keys().flatten().map(|&(base, _)| base).next()?;
    if !matches!(graph.node(base), Node::Leaf(_)) {
        return None;
    }
    let mut coefficients = vec![Rational::ZERO; HIGHEST + 1];
    for (m, q) in sum {
        let k = match m.as_slice() {
            [] => 0,
            &[(b, k)] if b == base => usize::try_from(k).ok().filter(|k| *k <= HIGHEST)?,
            _ => return None,
        };
        coefficients[k] = q.clone();
    }
    let mut left = trimmed(coefficients);
    if left.len() < 4 {
        return None;
    }
    let mut zeros: Vec<Rational> = Vec::new();
    for d in 1..=12 {
        for n in -LARGEST_ZERO..=LARGEST_ZERO {
            let r = Rational::from(n) / Rational::from(d);
            while left.len() > 1 && value(&left, &r) == Rational::ZERO {
                left = divided(&left, &r);
                if !zeros.contains(&r) {
                    zeros.push(r.clone());
                }
            }
        }
    }
    if zeros.is_empty() {
        return None;
    }
    let mut product = graph.integer(1);
    for r in zeros {
        let r = graph.constant(r);
        let factor = graph.sub(base, r);
        product = graph.mul(product, factor);
    }
    if left.len() > 1 && real_zeros(&left) != Some(0) {
        let mut rest = graph.integer(0);
        for (k, c) in left.iter().enumerate().filter(|(_, c)| **c != Rational::ZERO) {
            let monomial = if k == 0 { Vec::new() } else { vec![(base, k as i32)] };
            let term = expression(graph, &monomial, c);
            rest = graph.add(rest, term);
        }
        product = graph.mul(product, rest);
    }
    Some((product, graph.integer(0)))
}

/// Without leading zeros; lowest first.
fn trimmed(mut p: Vec<Rational>) -> Vec<Rational> {
    while p.last().is_some_and(|c| *c == Rational::ZERO) {
        p.pop();
    }
    p
}

fn value(p: &[Rational], x: &Rational) -> Rational {
    p.iter().rev().fold(Rational::ZERO, |sum, c| sum * x + c)
}

/// p/(x − r), for a zero r.
fn divided(p: &[Rational], r: &Rational) -> Vec<Rational> {
    let mut out = vec![Rational::ZERO; p.len() - 1];
    let mut carry = Rational::ZERO;
    for k in (0..p.len() - 1).rev() {
        carry = &p[k + 1] + carry * r;
        out[k] = carry.clone();
    }
    out
}

/// How many different real zeros there are, by Sturm's theorem.
fn real_zeros(p: &[Rational]) -> Option<usize> {
    let mut chain = vec![p.to_vec()];
    let slope: Vec<Rational> = p.iter().enumerate().skip(1).map(|(k, c)| c * Rational::from(k)).collect();
    chain.push(trimmed(slope));
    while chain.last()?.len() > 1 {
        let (a, b) = (&chain[chain.len() - 2], &chain[chain.len() - 1]);
        let mut rest = a.clone();
        while rest.len() >= b.len() {
            let factor = rest.last()? / b.last()?;
            let shift = rest.len() - b.len();
            for (k, c) in b.iter().enumerate() {
                rest[k + shift] -= c * &factor;
            }
            rest.pop();
            rest = trimmed(rest);
        }
        if rest.is_empty() {
            break;
        }
        chain.push(rest.into_iter().map(|c| -c).collect());
    }
    // Signs at −∞ and ∞.
    let changes = |below: bool| {
        let signs: Vec<bool> = chain
            .iter()
            .filter_map(|p| {
                let up = *p.last()? > Rational::ZERO;
                Some(if below && p.len() % 2 == 0 { !up } else { up })
            })
            .collect();
        signs.windows(2).filter(|w| w[0] != w[1]).count()
    };
    changes(true).checked_sub(changes(false))
}
