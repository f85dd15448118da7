//! Relations between fractions in the arguments of functions.
//!
//! **In:** the monomials of the arguments of one problem, which may have sums among their denominators. **Out:** for those that are
//! rational combinations of others, as rational functions of what stands in them, that combination. **Guaranteed:** both are equal
//! wherever both have a value. x/(4s + 4) is half of x/(2(s + 1)), and x/(s + 1)(s + 2) is x/(s + 1) − x/(s + 2).
//!
//! Every denominator is written up to a factor without sums as one polynomial; then all monomials are brought to a common
//! denominator, and their numerators are compared as vectors over the rational numbers. What is larger than is looked at stays as
//! it is written: a relation that is missed leaves an identity open.

use super::linear::{Combination, Combinations, Monomial, add_to, power, product, times, to_power};
use super::polynomial::fraction;
use expr::{Expr, FastMap, Graph, Node, Op, Rational};
use std::collections::{BTreeMap, BTreeSet};

/// Monomials that are compared by a common denominator.
const MOST: usize = 16;

/// Monomials that are combinations of others.
pub(super) type Relations = FastMap<Monomial, Combination>;

/// Powers of polynomials without a factor that is a monomial.
type Powers = BTreeMap<Combination, i32>;

/// A monomial as a fraction.
struct Ratio {
    top: Combination,
    under: Powers,
}

/// The relations between some monomials.
pub(super) fn relations(
    graph: &mut Graph,
    combinations: &mut Combinations,
    monomials: &BTreeSet<Monomial>,
) -> Relations {
    let mut out = Relations::default();
    let is_sum =
        |graph: &Graph, e: Expr| matches!(graph.node(e), Node::Binary(Op::Add | Op::Sub | Op::Mul | Op::Div, ..));
    let divides = |m: &Monomial| m.iter().any(|&(base, k)| k < 0 && is_sum(graph, base));
    let (fractions, plain): (Vec<&Monomial>, Vec<&Monomial>) = monomials.iter().partition(|m| divides(m));
    if fractions.is_empty() {
        return out;
    }
    // The first of those that differ by a rational factor stands for all.
    let mut known: Vec<(&Monomial, Ratio)> = Vec::new();
    let mut first: BTreeMap<(Combination, Powers), (&Monomial, Rational)> = BTreeMap::new();
    for m in fractions {
        let Some(ratio) = ratio(graph, combinations, m) else { continue };
        let Some((scale, top)) = scaled(&ratio.top) else { continue };
        match first.get(&(top.clone(), ratio.under.clone())) {
            Some(&(of, ref other)) => drop(out.insert(m.clone(), Combination::from([(of.clone(), scale / other)]))),
            None => {
                first.insert((top, ratio.under.clone()), (m, scale));
                known.push((m, ratio));
            }
        }
    }
    let whole = plain.into_iter().map(|m| {
        let top = Combination::from([(m.clone(), Rational::ONE)]);
        (m, Ratio { top, under: BTreeMap::new() })
    });
    // What has less to divide by comes first: others are written by it.
    known.sort_by_key(|(_, ratio)| ratio.under.values().sum::<i32>());
    let all: Vec<(&Monomial, Ratio)> = whole.chain(known).collect();
    if all.len() <= MOST {
        let equal = std::mem::take(&mut out);
        by_common_denominator(&all, &mut out);
        let resolved: Vec<_> = equal.into_iter().map(|(m, of)| (m, related(&out, of))).collect();
        out.extend(resolved);
    }
    out
}

/// The sum with monomials written by others, where they are combinations of these.
pub(super) fn related(relations: &Relations, sum: Combination) -> Combination {
    if relations.is_empty() {
        return sum;
    }
    let mut out = Combination::new();
    for (m, q) in sum {
        match relations.get(&m) {
            Some(others) => others.iter().for_each(|(n, r)| add_to(&mut out, n.clone(), &q * r)),
            None => add_to(&mut out, m, q),
        }
    }
    out
}

/// A monomial as a fraction; `None` where it is too long.
fn ratio(graph: &mut Graph, combinations: &mut Combinations, m: &Monomial) -> Option<Ratio> {
    let mut out = Ratio { top: Combination::from([(Vec::new(), Rational::ONE)]), under: BTreeMap::new() };
    for &(base, k) in m {
        let of_base = if k < 0 { fraction(graph, base) } else { (base, graph.integer(1)) };
        let [above, below] = [of_base.0, of_base.1].map(|e| combinations.of(graph, e));
        if above.len() < 2 || k >= 0 {
            let own = Combination::from([(vec![(base, k)], Rational::ONE)]);
            out.top = product(&out.top, &own)?;
            continue;
        }
        let (scale, content, rest) = without_content(&above)?;
        out.top = product(&out.top, &power(&below, -k)?)?;
        let factor = to_power(&content, k)?;
        out.top = product(&out.top, &Combination::from([(factor, expr::raised(&scale, k)?)]))?;
        *out.under.entry(rest).or_insert(0) += -k;
    }
    Some(out)
}

/// The first coefficient, and the sum divided by it.
fn scaled(sum: &Combination) -> Option<(Rational, Combination)> {
    let scale = sum.values().next()?.clone();
    let rest = sum.iter().map(|(m, q)| (m.clone(), q / &scale)).collect();
    Some((scale, rest))
}

/// A sum as a rational number times a monomial times a sum whose terms have no common factor, and whose first coefficient is 1.
fn without_content(sum: &Combination) -> Option<(Rational, Monomial, Combination)> {
    let bases: BTreeSet<Expr> = sum.keys().flatten().map(|&(base, _)| base).collect();
    let least = |base: Expr| {
        let of = |m: &Monomial| m.iter().find(|(b, _)| *b == base).map_or(0, |&(_, k)| k);
        sum.keys().map(of).min().unwrap_or(0)
    };
    let content: Monomial = bases.into_iter().map(|base| (base, least(base))).filter(|&(_, k)| k != 0).collect();
    let inverse: Monomial = content.iter().map(|&(base, k)| (base, -k)).collect();
    let rest: Option<Combination> = sum.iter().map(|(m, q)| Some((times(m, &inverse)?, q.clone()))).collect();
    let (scale, rest) = scaled(&rest?)?;
    Some((scale, content, rest))
}

/// Adds the relations between fractions that show with a common denominator.
fn by_common_denominator(all: &[(&Monomial, Ratio)], out: &mut Relations) {
    let mut common: BTreeMap<&Combination, i32> = BTreeMap::new();
    for (p, &k) in all.iter().flat_map(|(_, ratio)| &ratio.under) {
        let most = common.entry(p).or_insert(0);
        *most = k.max(*most);
    }
    // Numerators, each with the combination of monomials that it is.
    let mut rows: Vec<(Combination, Combination)> = Vec::new();
    for (m, ratio) in all {
        let missing = common.iter().map(|(p, &k)| (*p, k - ratio.under.get(*p).copied().unwrap_or(0)));
        let numerator =
            missing.filter(|&(_, k)| k > 0).try_fold(ratio.top.clone(), |top, (p, k)| product(&top, &power(p, k)?));
        let Some(mut left) = numerator else { return };
        let mut from = Combination::from([((*m).clone(), Rational::ONE)]);
        for (row, of) in &rows {
            let Some((lead, q)) = row.iter().next() else { continue };
            let Some(factor) = left.get(lead).map(|c| c / q) else { continue };
            row.iter().for_each(|(n, r)| add_to(&mut left, n.clone(), -&factor * r));
            of.iter().for_each(|(n, r)| add_to(&mut from, n.clone(), -&factor * r));
        }
        if !left.is_empty() {
            rows.push((left, from));
            continue;
        }
        from.remove(*m);
        out.insert((*m).clone(), from.into_iter().map(|(m, q)| (m, -q)).collect());
    }
}
