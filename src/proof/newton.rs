//! Real points at which premises of any degree hold, against a claim.
//!
//! **In:** a claim and premises that no order of solving settled, about numbers that do not move. **Out:** a refutation, or
//! nothing. **Guaranteed:** there is a real point near the one that is given, at which all premises hold and the sides differ.
//!
//! Newton's method finds a point in binary64. Where rational numbers close by satisfy the equations exactly, they are the
//! point. Otherwise the operator of Krawczyk, over intervals, shows that a box around it contains a solution: with f the
//! equations, x the middle of the box X and Y near the inverse of f′(x), if K = x − Y·f(x) + (1 − Y·f′(X))(X − x) lies inside X, then
//! it contains a zero of f (R. Krawczyk, *Computing* 4 (1969) 187; R. E. Moore, *SIAM J. Numer. Anal.* 14 (1977) 611). The other
//! premises must hold, and the sides differ, on all of the box.

use super::exact::Exact;
use super::jets::names_fields;
use super::outcome::{Options, Point, PointValue, Premises, Refutation, Side};
use super::witness::{Values, decimals};
use expr::tape::{Slots, Tape};
use expr::{Expr, FastSet, Graph, Leaf, Node, Rational};
use number::{Bounded, Draws, Interval, Number};

/// Points that are begun from.
const STARTS: usize = 48;
/// Steps from each.
const STEPS: usize = 60;
/// Equations that are solved together.
const MOST_EQUATIONS: usize = 4;
/// Larger systems are left.
const MOST_NODES: usize = 400;
/// Values of what is not solved for, and of where the search begins.
const SIZES: [(i64, i64); 10] = [(1, 1), (2, 1), (1, 2), (3, 2), (3, 1), (1, 4), (5, 2), (3, 4), (4, 1), (5, 1)];

/// The system: residuals, and their derivatives by everything.
struct System {
    leaves: Vec<Leaf>,
    tape: Tape,
    count: usize,
}

/// A point: exact numbers, and boxes.
struct Place {
    exact: Vec<Option<Rational>>,
    boxes: Vec<Interval>,
}

/// A real point at which the premises hold and the claim does not.
pub(super) fn refutes(
    graph: &mut Graph,
    claim: &[(Expr, Expr)],
    given: &Premises,
    options: &Options,
) -> Option<Refutation> {
    let equations: Vec<(Expr, Expr)> = given.equations.iter().chain(&given.only_now).copied().collect();
    let count = equations.len();
    // A point of a motion, or of a field, must belong to one.
    let bound = !given.moving.is_empty()
        || equations.iter().any(|&pair| names_fields(graph, pair))
        || graph.has_places(claim.iter().flat_map(|&(l, r)| [l, r]));
    if count == 0 || count > MOST_EQUATIONS || bound {
        return None;
    }
    let residuals: Vec<Expr> = equations.iter().map(|&(l, r)| graph.sub(l, r)).collect();
    let facts = [&given.nonzero, &given.positive, &given.not_negative].into_iter().flatten().copied();
    let all: Vec<Expr> =
        residuals.iter().copied().chain(claim.iter().flat_map(|&(l, r)| [l, r])).chain(facts).collect();
    if graph.reachable(all.iter().copied()).len() > MOST_NODES {
        return None;
    }
    let leaves = graph.leaves(all);
    let mut outputs = residuals.clone();
    for &e in &residuals {
        for &leaf in &leaves {
            outputs.push(graph.slope(e, leaf).ok()?);
        }
    }
    let tape = Tape::compile(graph, &leaves, &outputs).ok()?;
    let system = System { leaves, tape, count };
    let positive: FastSet<Leaf> = given.positive.iter().filter_map(|&e| leaf_of(graph, e)).collect();
    let mut draws = Draws::new(options.seed);
    for start in 0..STARTS {
        let Some(place) = system.solved(&positive, start, &mut draws) else { continue };
        if let Some(found) = judged(graph, claim, given, &system, &place) {
            return Some(found);
        }
    }
    None
}

fn leaf_of(graph: &Graph, e: Expr) -> Option<Leaf> {
    match *graph.node(e) {
        Node::Leaf(leaf) => Some(leaf),
        Node::Constant(_) | Node::Pi | Node::Unary(..) | Node::Binary(..) => None,
    }
}

impl System {
    fn run<N: Number<Context = ()>>(&self, values: &[N]) -> Option<Vec<N>> {
        let mut slots: Slots<N> = self.tape.slots(&());
        for (i, value) in values.iter().enumerate() {
            slots.set(i, Ok(value.clone()));
        }
        self.tape.run(&(), &mut slots);
        let outputs = self.count * (1 + self.leaves.len());
        (0..outputs).map(|i| self.tape.output(i, &slots).ok().cloned()).collect()
    }

    /// A solution near a random point.
    fn solved(&self, positive: &FastSet<Leaf>, start: usize, draws: &mut Draws) -> Option<Place> {
        let n = self.leaves.len();
        if n < self.count {
            return None;
        }
        let chosen: Vec<Rational> = self
            .leaves
            .iter()
            .map(|leaf| {
                let (top, under) = SIZES[draws.below(if start < STARTS / 2 { 5 } else { 10 }) as usize];
                let size = Rational::from(top) / Rational::from(under);
                if !positive.contains(leaf) && draws.bits() & 1 == 0 { -size } else { size }
            })
            .collect();
        // Which leaves are solved for: any, in turn.
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, draws.below(i as u64 + 1) as usize);
        }
        let mut unknown: Vec<usize> = order.into_iter().take(self.count).collect();
        unknown.sort_unstable();
        let mut x: Vec<f64> = chosen.iter().map(|r| r.to_f64().value()).collect();
        let mut inverse = Vec::new();
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let values = self.run(&x)?;
            inverse = inverse_of(&self.slopes(&values, &unknown))?;
            let mut size = 0.0f64;
            for (row, &at) in inverse.iter().zip(&unknown) {
                let step: f64 = row.iter().zip(&values).map(|(y, f)| y * f).sum();
                x[at] -= step;
                size = size.max(step.abs() / x[at].abs().max(1.0));
            }
            if !size.is_finite() {
                return None;
            }
            if size < 1e-15 || size < 1e-12 && size >= last {
                last = size;
                break;
            }
            last = size;
        }
        if last > 1e-10 {
            return None;
        }
        self.exactly(&chosen, &x, &unknown).or_else(|| self.enclosed(&chosen, &x, &unknown, &inverse))
    }

    fn slopes<T: Clone>(&self, values: &[T], unknown: &[usize]) -> Vec<Vec<T>> {
        let n = self.leaves.len();
        let of = |row: usize| unknown.iter().map(move |&at| values[self.count + row * n + at].clone());
        (0..self.count).map(|row| of(row).collect()).collect()
    }

    /// The rational numbers close by, if they satisfy the equations.
    fn exactly(&self, chosen: &[Rational], x: &[f64], unknown: &[usize]) -> Option<Place> {
        let mut exact = chosen.to_vec();
        for &at in unknown {
            exact[at] = (1..=12).find_map(|d| {
                let top = (x[at] * f64::from(d)).round();
                let close = (x[at] * f64::from(d) - top).abs() < 1e-9 && top.abs() < 1e6;
                close.then(|| Rational::from(top as i64) / Rational::from(d))
            })?;
        }
        let values: Vec<Exact> = exact.iter().cloned().map(Exact).collect();
        let mut slots: Slots<Exact> = self.tape.slots(&());
        for (i, value) in values.into_iter().enumerate() {
            slots.set(i, Ok(value));
        }
        self.tape.run(&(), &mut slots);
        let holds =
            (0..self.count).all(|i| matches!(self.tape.output(i, &slots), Ok(Exact(r)) if *r == Rational::ZERO));
        let boxes: Option<Vec<Interval>> = exact.iter().map(interval).collect();
        holds.then_some(Place { exact: exact.into_iter().map(Some).collect(), boxes: boxes? })
    }

    /// A box that contains a solution.
    fn enclosed(&self, chosen: &[Rational], x: &[f64], unknown: &[usize], inverse: &[Vec<f64>]) -> Option<Place> {
        let mut boxes: Vec<Interval> = chosen.iter().map(interval).collect::<Option<_>>()?;
        let middles: Vec<Interval> = unknown.iter().map(|&at| Interval::point(x[at])).collect();
        let mut at_middle = boxes.clone();
        for (&at, &middle) in unknown.iter().zip(&middles) {
            at_middle[at] = middle;
            let radius = 1e-9 * x[at].abs().max(1e-3);
            boxes[at] = Interval::ball(x[at], radius);
        }
        let f = self.run(&at_middle)?;
        let slopes = self.slopes(&self.run(&boxes)?, unknown);
        let k = self.count;
        let mut inside = Vec::new();
        for (i, &at) in unknown.iter().enumerate() {
            let mut sum = middles[i];
            for (m, y) in inverse[i].iter().enumerate() {
                sum = sum - Interval::point(*y) * f[m];
            }
            for (j, &other) in unknown.iter().enumerate() {
                let mut factor = Interval::point(if i == j { 1.0 } else { 0.0 });
                for m in 0..k {
                    factor = factor - Interval::point(inverse[i][m]) * slopes[m][j];
                }
                sum = sum + factor * (boxes[other] - middles[j]);
            }
            if !(boxes[at].lo() < sum.lo() && sum.hi() < boxes[at].hi()) {
                return None;
            }
            inside.push(sum);
        }
        let mut exact: Vec<Option<Rational>> = chosen.iter().cloned().map(Some).collect();
        for (&at, sum) in unknown.iter().zip(inside) {
            boxes[at] = sum;
            exact[at] = None;
        }
        Some(Place { exact, boxes })
    }
}

fn interval(r: &Rational) -> Option<Interval> {
    let mut out = Interval::point(0.0);
    Number::rational(&mut out, &(), r).ok()?;
    Some(out)
}

/// The inverse of a small matrix, by elimination with pivots; `None` where it is near to singular.
fn inverse_of(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let unit = |i: usize| (0..n).map(move |j| if i == j { 1.0 } else { 0.0 });
    let mut rows: Vec<Vec<f64>> =
        matrix.iter().enumerate().map(|(i, row)| row.iter().copied().chain(unit(i)).collect()).collect();
    for column in 0..n {
        let pivot = (column..n).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        let lead = rows[column][column];
        if lead.is_nan() || lead.abs() <= 1e-9 {
            return None;
        }
        rows[column].iter_mut().for_each(|v| *v /= lead);
        let top = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = row[column];
            if i != column && factor != 0.0 {
                row.iter_mut().zip(&top).for_each(|(v, t)| *v -= factor * t);
            }
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}

/// The refutation, if the other premises hold there and a pair of sides differs.
fn judged(
    graph: &Graph,
    claim: &[(Expr, Expr)],
    given: &Premises,
    system: &System,
    place: &Place,
) -> Option<Refutation> {
    let values: Values = system
        .leaves
        .iter()
        .zip(&place.boxes)
        .map(|(&leaf, b)| (leaf, Bounded { value: b.mid(), error: b.radius() }))
        .collect();
    let certain = |list: &[Expr], holds: fn(&Bounded) -> bool| {
        decimals(graph, list, &values).iter().all(|v| v.as_ref().is_some_and(holds))
    };
    if !certain(&given.nonzero, |v| !v.contains_zero())
        || !certain(&given.positive, |v| v.value > v.error)
        || !certain(&given.not_negative, |v| v.value >= v.error)
    {
        return None;
    }
    let sides: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    let at = decimals(graph, &sides, &values);
    let pairs: Option<Vec<(Bounded, Bounded)>> = at.chunks_exact(2).map(|p| Some((p[0]?, p[1]?))).collect();
    let (equation, (l, r)) =
        pairs?.into_iter().enumerate().find(|(_, (l, r))| (l.value - r.value).abs() > 4.0 * (l.error + r.error))?;
    let side = |v: Bounded| Side { exact: None, decimal: v.value };
    let point = system
        .leaves
        .iter()
        .zip(&place.exact)
        .zip(&place.boxes)
        .map(|((&leaf, exact), b)| (leaf, PointValue { exact: exact.clone(), circle: None, decimal: b.mid() }));
    let point = Point { values: point.collect() };
    Some(Refutation { equation, point, named: Vec::new(), left: side(l), right: side(r), second: None })
}
