//! What is missing: a factor or a term that makes a formula true.
//!
//! **In:** a formula that fails, and points at which it should hold. **Out:** formulas with one factor or one term more, which
//! vanish at these points.
//!
//! A residual is often an affine function of a factor F of one term: r = r₀ + (r₁ − r₀) F, with r₁ the residual as printed
//! (F = 1) and r₀ that without the term. So F = r₀/(r₀ − r₁) is known at every point, and the same goes for a missing term.
//! What is looked for is a monomial c·∏ aⁿ in the quantities of the formula and its language that has these values: at most
//! three different ones, powers up to 3, c a simple fraction. No tree is made before the numbers agree.

use super::battery::{Battery, Value};
use super::gap::{Gap, holes, monomial};
use super::generate::{ClaimVariants, Formula, Manner, Part, Setting, Source, Variant, drawn};
use super::vocabulary::Vocabulary;
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf, Rational};
use crate::findings::EditClass;
use crate::latex;
use crate::latex::syntax::{Chain, Node, NodeKind};
use crate::number::{Bounded, Number};

/// Largest power in a monomial.
const HIGHEST: i32 = 3;
/// How well the values of a monomial must agree with those that are wanted.
const AGREEMENT: f64 = 1e-7;
/// Most completions that are offered for one formula.
const MOST_FOUND: usize = 24;

/// Points at which a formula should hold, all for one initial time: each a lookup of values.
pub(super) struct Points<'a> {
    /// Which initial time.
    pub start: usize,
    /// The points, few and different.
    pub points: Vec<&'a Vec<Value>>,
    /// To which motion each belongs; points of one motion stand together.
    pub motions: Vec<usize>,
    /// The leaves that they have values of, sorted.
    pub known: &'a [Leaf],
}

impl Points<'_> {
    fn lookup(&self, point: &[Value], leaves: &[Leaf]) -> Option<Vec<Value>> {
        leaves.iter().map(|l| self.known.binary_search(l).ok().map(|i| point[i])).collect()
    }
}

/// Simple numbers that a coefficient may be.
fn simple(c: f64) -> Option<Rational> {
    const TOPS: [i64; 9] = [1, 2, 3, 4, 5, 6, 8, 12, 16];
    for q in TOPS {
        for p in TOPS {
            let r = p as f64 / q as f64;
            if (c.abs() - r).abs() <= AGREEMENT * r {
                let r = Rational::from(p) / Rational::from(q);
                return Some(if c < 0.0 { -r } else { r });
            }
        }
    }
    None
}

/// A monomial: coefficient, and atoms with their powers.
struct Found {
    coefficient: Rational,
    powers: Vec<(usize, i32)>,
}

impl Found {
    fn weight(&self) -> i32 {
        let simple = i32::from(self.coefficient != Rational::ONE && self.coefficient != Rational::from(-1));
        self.powers.iter().map(|(_, n)| n.abs() + 1).sum::<i32>() + simple
    }
}

/// What a missing factor or term X does to a residual at each point: at + slope·X.
#[derive(Default)]
struct Line {
    at: Vec<f64>,
    slope: Vec<f64>,
    /// For a constant, of which only differences are known: the point before on the same motion.
    before: Vec<Option<usize>>,
    constant: bool,
}

impl Line {
    /// The coefficient c for which X = c·m makes the residual vanish at a point (or the same as at the point before).
    fn coefficient(&self, p: usize, m: impl Fn(usize) -> f64) -> Option<f64> {
        if !self.constant {
            return Some(-self.at[p] / (self.slope[p] * m(p)));
        }
        let q = self.before[p]?;
        Some(-(self.at[p] - self.at[q]) / (self.slope[p] * m(p) - self.slope[q] * m(q)))
    }
}

/// xⁿ for a small n, multiplied from the left.
fn power(x: f64, n: i32) -> f64 {
    let size: f64 = (0..n.abs()).map(|_| x).product();
    if n < 0 { 1.0 / size } else { size }
}

/// ln |b/a|.
fn change(a: Option<&f64>, b: Option<&f64>) -> f64 {
    match (a, b) {
        (Some(a), Some(b)) => {
            let mut out = 0.0_f64;
            Number::ln(&mut out, &(), &(b / a).abs()).map_or(f64::NAN, |()| out)
        }
        _ => f64::NAN,
    }
}

/// The monomials c·∏ aⁿ that make the residual vanish, the simplest first.
fn monomials(values: &[Vec<f64>], line: &Line) -> Vec<Found> {
    let mut out = Vec::new();
    // How the logarithms change from the first point to the second, and to the last, which is of another motion where there
    // are several, rules out almost everything at the cost of two sums.
    let others = [1, line.at.len().saturating_sub(1)];
    let changes: Vec<[f64; 2]> = values.iter().map(|v| others.map(|p| change(v.first(), v.get(p)))).collect();
    let factor = |p: usize| line.coefficient(p, |_| 1.0);
    let wanted = match line.constant || line.at.len() < 2 {
        true => [f64::NAN; 2],
        false => others.map(|p| change(factor(0).as_ref(), factor(p).as_ref())),
    };
    let near = |powers: &[(usize, i32)]| {
        (0..2).all(|k| {
            let found: f64 = powers.iter().map(|&(a, n)| f64::from(n) * changes[a][k]).sum();
            // A looser bound than that of the values: this only chooses what is looked at. What is not known excludes nothing.
            let apart = (found - wanted[k]).abs();
            apart.is_nan() || apart <= 1e-5
        })
    };
    let agrees = |powers: &[(usize, i32)]| -> Option<Rational> {
        if !near(powers) {
            return None;
        }
        let m = |p: usize| -> f64 { powers.iter().map(|&(a, n)| power(values[a][p], n)).product() };
        let mut c = None;
        let mut count = 0;
        for p in 0..line.at.len() {
            let Some(ratio) = line.coefficient(p, m) else { continue };
            if !ratio.is_finite() || ratio == 0.0 {
                return None;
            }
            let first = *c.get_or_insert(ratio);
            if (ratio - first).abs() > AGREEMENT * first.abs() {
                return None;
            }
            count += 1;
        }
        if count >= 3 { simple(c?) } else { None }
    };
    let mut try_one = |powers: &[(usize, i32)]| {
        if let Some(coefficient) = agrees(powers) {
            out.push(Found { coefficient, powers: powers.to_vec() });
        }
    };
    try_one(&[]);
    let exponents = || (1..=HIGHEST).flat_map(|n| [n, -n]);
    for a in 0..values.len() {
        for i in exponents() {
            try_one(&[(a, i)]);
            for b in a + 1..values.len() {
                for j in exponents() {
                    try_one(&[(a, i), (b, j)]);
                    for c in b + 1..values.len() {
                        for k in exponents() {
                            try_one(&[(a, i), (b, j), (c, k)]);
                        }
                    }
                }
            }
        }
    }
    out.sort_by_key(Found::weight);
    out.truncate(4);
    out
}

/// The monomials that have the wanted values at the points, the simplest first: coefficient, and atoms with their powers.
pub(super) fn fits(values: &[Vec<f64>], wanted: &[f64]) -> Vec<(Rational, Vec<(usize, i32)>)> {
    let at = wanted.iter().map(|w| -w).collect();
    let line = Line { at, slope: vec![1.0; wanted.len()], before: vec![None; wanted.len()], constant: false };
    monomials(values, &line).into_iter().map(|found| (found.coefficient, found.powers)).collect()
}

/// The scalar atoms that have a value at every point.
pub(super) fn valued_atoms(
    graph: &mut Graph,
    setting: &Setting,
    all: &[Node],
    points: &Points,
) -> (Vec<Node>, Vec<Vec<f64>>) {
    let mut nodes = Vec::new();
    let mut roots: Vec<Expr> = Vec::new();
    for atom in all {
        let Ok(tensor) = latex::elaborate_expression(atom, &setting.claim.scope, graph) else { continue };
        let Some(e) = tensor.as_scalar() else { continue };
        if !roots.contains(&e) && graph.as_constant(e).is_none() {
            roots.push(e);
            nodes.push(atom.clone());
        }
    }
    let leaves = graph.leaves(roots.iter().copied());
    let Ok(tape) = Tape::compile(graph, &leaves, &roots) else { return (Vec::new(), Vec::new()) };
    let mut slots = tape.slots::<Bounded>(&());
    let mut values: Vec<Vec<f64>> = vec![Vec::new(); roots.len()];
    for point in &points.points {
        let inputs: Vec<Value> = leaves
            .iter()
            .map(|l| points.known.binary_search(l).map_or(Err(number::NoValue::Indeterminate), |i| point[i]))
            .collect();
        for (all, v) in values.iter_mut().zip(tape.evaluate(&(), &inputs, &mut slots)) {
            all.extend(v.ok().filter(|v| v.value.abs() > 1e3 * v.error).map(|v| v.value));
        }
    }
    let complete: Vec<bool> = values.iter().map(|v| v.len() == points.points.len()).collect();
    let keep = |i: &usize| complete[*i];
    let at: Vec<usize> = (0..nodes.len()).filter(keep).collect();
    (at.iter().map(|&i| nodes[i].clone()).collect(), at.iter().map(|&i| values[i].clone()).collect())
}

/// Formulas with one factor or one term more that vanish at the points, looked for at so many places at most for each of the two.
pub(super) fn completions(
    graph: &mut Graph,
    setting: &Setting,
    vocabulary: &Vocabulary,
    formula: &Formula,
    atoms: &[Node],
    points: &Points,
    most: usize,
) -> Vec<Chain> {
    let (nodes, values) = valued_atoms(graph, setting, atoms, points);
    let constant = |n: i64| Node::new(NodeKind::Number(Rational::from(n)), 0..0);
    let mut out: Vec<(i32, Chain)> = Vec::new();
    for (gap, probe, instead) in [(Gap::Factor, constant(0), true), (Gap::Term, constant(1), false)] {
        let all = holes(&formula.tree, gap, vocabulary);
        for hole in drawn(all.len(), most).filter_map(|at| all.get(at)) {
            // The residuals with the probe, and with it doubled, to see whether they depend on it in this simple way.
            let tree = hole.filled(&formula.tree, &probe, instead);
            let doubled = hole.filled(&formula.tree, &constant(2), false);
            let Some(line) = line(graph, setting, formula, points, (&tree, &doubled), gap) else { continue };
            for found in monomials(&values, &line) {
                let factors: Vec<(&Node, i32)> = found.powers.iter().map(|&(a, n)| (&nodes[a], n)).collect();
                let filling = monomial(&found.coefficient, &factors);
                out.push((found.weight(), hole.filled(&formula.tree, &filling, false)));
            }
        }
    }
    out.sort_by_key(|(weight, _)| *weight);
    out.truncate(MOST_FOUND);
    out.into_iter().map(|(_, tree)| tree).collect()
}

/// How the residuals depend on what is missing; `None` where they do so in another way, or not at all.
fn line(
    graph: &mut Graph,
    setting: &Setting,
    formula: &Formula,
    points: &Points,
    (probe, doubled): (&Chain, &Chain),
    gap: Gap,
) -> Option<Line> {
    let constant = formula.manner == Manner::Constant;
    // Of a constant the expression itself, not its difference from the start: a term may be any constant more.
    let plain = |mut part: Part| {
        if constant {
            let e = part.sides.0;
            part.difference.iter_mut().for_each(|d| *d = e);
        }
        part
    };
    let variant = |graph: &mut Graph, tree: &Chain| {
        let parts = setting.parts(graph, tree, formula.manner, formula.parts.len())?;
        let altered = parts.into_iter().map(plain).enumerate().collect();
        Some(Variant { class: EditClass::Missing, formula: 0, source: Source::Tree(Box::new(tree.clone())), altered })
    };
    let variants = vec![variant(graph, probe)?, variant(graph, doubled)?];
    let print = Formula { parts: formula.parts.iter().cloned().map(plain).collect(), ..formula.clone() };
    let claim = ClaimVariants { formulas: vec![print], variants, ..ClaimVariants::default() };
    let sign = setting.claim.scope.branch_sign();
    let battery = Battery::new(graph, &claim, points.start, vec![0, 1], sign)?;
    let mut slots = battery.slots();
    // One component speaks for all: that which depends most on what is missing. The others are seen to when it is tried.
    let mut lines: Vec<(f64, Line)> = (0..formula.parts.len()).map(|_| (0.0, Line::default())).collect();
    for (p, point) in points.points.iter().enumerate() {
        let values = points.lookup(point, battery.leaves())?;
        let outputs = battery.at(values.into_iter(), 1.0, &mut slots);
        let before = p.checked_sub(1).filter(|&q| points.motions[q] == points.motions[p]);
        for (part, (weight, line)) in lines.iter_mut().enumerate() {
            let own = outputs.own(0, part).ok()?;
            let (first, second) = (outputs.altered(0, part).ok()?, outputs.altered(1, part).ok()?);
            let size = own.value.abs().max(first.value.abs()).max(second.value.abs()) + 1e3 * own.error;
            let (slope, at) = match gap {
                // F = 0 gives `first`, F = 1 the print, F = 2 `second`.
                Gap::Factor => (own.value - first.value, first.value),
                // A term 0 is the print, 1 gives `first`, 2 `second`.
                Gap::Term => (first.value - own.value, own.value),
            };
            if (second.value - at - 2.0 * slope).abs() > AGREEMENT * size {
                return None;
            }
            *weight += slope.abs() / size.max(f64::MIN_POSITIVE);
            line.at.push(at);
            line.slope.push(slope);
            line.before.push(before);
            line.constant = constant;
        }
    }
    let (weight, line) = lines.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    (weight > 1e-6).then_some(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_monomial_is_recognised_by_its_values() {
        let x = vec![1.3, -0.7, 2.2, 0.4];
        let y = vec![0.2, 1.9, -1.1, 3.0];
        let wanted: Vec<f64> = x.iter().zip(&y).map(|(x, y)| -1.5 * x * x / y).collect();
        let line = |wanted: Vec<f64>| {
            let n = wanted.len();
            let before = (0..n).map(|p: usize| p.checked_sub(1)).collect();
            Line { at: wanted.iter().map(|w| -w).collect(), slope: vec![1.0; n], before, constant: false }
        };
        let found = monomials(&[x.clone(), y.clone()], &line(wanted.clone()));
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].powers, [(0, 2), (1, -1)]);
        assert_eq!(found[0].coefficient, Rational::from(-3) / Rational::from(2));
        let other: Vec<f64> = x.iter().zip(&y).map(|(x, y)| x + y).collect();
        assert!(monomials(&[x.clone(), y.clone()], &line(other)).is_empty());
        // Of a constant only differences are known.
        let shifted = Line { constant: true, ..line(wanted.iter().map(|w| w + 7.0).collect()) };
        let found = monomials(&[x, y], &shifted);
        assert_eq!(found[0].powers, [(0, 2), (1, -1)]);
    }
}
