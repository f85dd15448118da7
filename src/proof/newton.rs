//! Real points at which premises of any degree hold, against a claim.
//!
//! **In:** a claim and premises that no order of solving settled, about numbers that do not move; or a claim that is proved, and
//! everything given, of which the resolution gave no point. **Out:** a refutation, or an example, or nothing. **Guaranteed:** there
//! is a real point near the one that is given, at which all premises hold and the sides differ; or at which they have values.
//!
//! Newton's method finds a point in binary64. Where rational numbers close by satisfy the equations exactly, they are the
//! point. Otherwise the operator of Krawczyk, over intervals, shows that a box around it contains a solution: with f the
//! equations, x the middle of the box X and Y near the inverse of f′(x), if K = x − Y·f(x) + (1 − Y·f′(X))(X − x) lies inside X, then
//! it contains a zero of f (R. Krawczyk, *Computing* 4 (1969) 187; R. E. Moore, *SIAM J. Numer. Anal.* 14 (1977) 611). The other
//! premises must hold, and the sides differ, on all of the box.

use super::bounds::Bounds;
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
/// Equations that are solved together against a claim.
const MOST_EQUATIONS: usize = 4;
/// The same for an example, for which derivatives count.
const MOST_FOR_EXAMPLE: usize = 12;
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
    let equations: Vec<(Expr, Expr)> = given.pairs().collect();
    let count = equations.len();
    // A point of a motion, or of a field, must belong to one.
    let bound = !given.moving.is_empty()
        || equations.iter().any(|&pair| names_fields(graph, pair))
        || graph.has_places(claim.iter().flat_map(|&(l, r)| [l, r]));
    if count == 0 || count > MOST_EQUATIONS || bound {
        return None;
    }
    let facts: Vec<Expr> =
        [&given.nonzero, &given.positive, &given.not_negative].into_iter().flatten().copied().collect();
    let sides: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    let system = System::of(graph, &equations, sides.into_iter().chain(facts).collect())?;
    let mut draws = Draws::new(options.seed);
    let starts = Starts::of(graph, given);
    (0..STARTS).find_map(|start| {
        let place = system.solved(&starts, start, &mut draws)?;
        judged(graph, claim, given, &system, &place)
    })
}

/// A point that satisfies everything given.
pub(super) struct Example {
    pub(super) point: Point,
    /// The first equation whose sides certainly differ there.
    pub(super) differs: Option<usize>,
}

/// A real point at which all premises hold, `premises` among them derivatives of those given, nothing that was divided by
/// vanishes, and all sides have values.
pub(super) fn example(
    graph: &mut Graph,
    claim: &[(Expr, Expr)],
    premises: &[(Expr, Expr)],
    given: &Premises,
    divided: &[Expr],
    options: &Options,
) -> Option<Example> {
    let mut equations: Vec<(Expr, Expr)> = Vec::new();
    for &(l, r) in premises {
        if l != r && !equations.contains(&(l, r)) {
            equations.push((l, r));
        }
    }
    if equations.is_empty() || equations.len() > MOST_FOR_EXAMPLE {
        return None;
    }
    let sides: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    let facts: Vec<Expr> =
        [&given.nonzero, &given.positive, &given.not_negative].into_iter().flatten().copied().collect();
    // Where it depends on a sign that was made up on the way, it is not known whether it vanishes.
    let given_sides = equations.iter().flat_map(|&(l, r)| [l, r]);
    let known = graph.leaves(given_sides.chain(sides.iter().copied()).chain(facts.iter().copied()));
    if graph.leaves(divided.iter().copied()).iter().any(|leaf| !known.contains(leaf)) {
        return None;
    }
    let facts = facts.into_iter().chain(divided.iter().copied());
    let system = System::of(graph, &equations, sides.iter().copied().chain(facts).collect())?;
    let mut draws = Draws::new(options.seed);
    let starts = Starts::of(graph, given);
    // First where everything is 1.
    [None].into_iter().chain((0..STARTS).map(Some)).find_map(|start| {
        let place = match start {
            None => system.solved_from(vec![Rational::ONE; system.leaves.len()], &mut draws),
            Some(start) => system.solved(&starts, start, &mut draws),
        }?;
        let values = system.values(&place);
        if !admits(graph, given, &values) || !decimals(graph, divided, &values).iter().all(is_not_zero) {
            return None;
        }
        let at: Option<Vec<Bounded>> = decimals(graph, &sides, &values).into_iter().collect();
        let differs = at?.as_chunks().0.iter().position(|&[l, r]| are_apart(l, r));
        Some(Example { point: system.point(&place), differs })
    })
}

fn is_not_zero(value: &Option<Bounded>) -> bool {
    value.is_some_and(|v| !v.contains_zero())
}

fn are_apart(l: Bounded, r: Bounded) -> bool {
    (l.value - r.value).abs() > 4.0 * (l.error + r.error)
}

/// Whether everything given but equations certainly holds at a point.
fn admits(graph: &Graph, given: &Premises, values: &Values) -> bool {
    let certain = |list: &[Expr], holds: fn(&Bounded) -> bool| {
        decimals(graph, list, values).iter().all(|v| v.as_ref().is_some_and(holds))
    };
    certain(&given.nonzero, |v| !v.contains_zero())
        && certain(&given.positive, |v| v.value > v.error)
        && certain(&given.not_negative, |v| v.value >= v.error)
}

/// What the values that a search begins with are to be like.
struct Starts {
    positive: FastSet<Leaf>,
    bounds: Bounds,
}

impl Starts {
    fn of(graph: &Graph, given: &Premises) -> Starts {
        let positive = given.positive.iter().filter_map(|&e| leaf_of(graph, e)).collect();
        Starts { positive, bounds: Bounds::of(graph, given.positive.iter().chain(&given.not_negative).copied()) }
    }
}

fn leaf_of(graph: &Graph, e: Expr) -> Option<Leaf> {
    match *graph.node(e) {
        Node::Leaf(leaf) => Some(leaf),
        Node::Constant(_) | Node::Pi | Node::Unary(..) | Node::Binary(..) => None,
    }
}

impl System {
    /// The system of equations, over everything that they and others name.
    fn of(graph: &mut Graph, equations: &[(Expr, Expr)], others: Vec<Expr>) -> Option<System> {
        let residuals: Vec<Expr> = equations.iter().map(|&(l, r)| graph.sub(l, r)).collect();
        let all: Vec<Expr> = residuals.iter().copied().chain(others).collect();
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
        Some(System { leaves, tape, count: residuals.len() })
    }

    /// The values at a place, with what is not known of them.
    fn values(&self, place: &Place) -> Values {
        let value = |(&leaf, b): (&Leaf, &Interval)| (leaf, Bounded { value: b.mid(), error: b.radius() });
        self.leaves.iter().zip(&place.boxes).map(value).collect()
    }

    fn point(&self, place: &Place) -> Point {
        let each = self.leaves.iter().zip(&place.exact).zip(&place.boxes);
        let value = |((&leaf, exact), b): ((&Leaf, &Option<Rational>), &Interval)| {
            (leaf, PointValue { exact: exact.clone(), circle: None, decimal: b.mid(), error: b.radius() })
        };
        Point { values: each.map(value).collect() }
    }

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
    fn solved(&self, starts: &Starts, start: usize, draws: &mut Draws) -> Option<Place> {
        let mut chosen: Vec<Rational> = Vec::new();
        for leaf in &self.leaves {
            let (top, under) = SIZES[draws.below(if start < STARTS / 2 { 5 } else { 10 }) as usize];
            let size = Rational::from(top) / Rational::from(under);
            let negative = !starts.positive.contains(leaf) && draws.bits() & 1 == 0;
            chosen.push(starts.bounds.within(*leaf, if negative { -size } else { size }));
        }
        self.solved_from(chosen, draws)
    }

    /// A solution near a point.
    fn solved_from(&self, chosen: Vec<Rational>, draws: &mut Draws) -> Option<Place> {
        let n = self.leaves.len();
        // Which leaves are solved for: any, in turn.
        let mut order: Vec<usize> = (0..n).collect();
        for i in (1..n).rev() {
            order.swap(i, draws.below(i as u64 + 1) as usize);
        }
        if let Some(place) = self.exactly(chosen.clone()) {
            return Some(place);
        }
        let mut x: Vec<f64> = chosen.iter().map(|r| r.to_f64().value()).collect();
        let unknown = self.independent(&self.run(&x)?, &order)?;
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
        let near = self.near(&chosen, &x, &unknown).and_then(|near| self.exactly(near));
        near.or_else(|| self.enclosed(&chosen, &x, &unknown, &inverse))
    }

    /// As many leaves as there are equations, the first of an order with which these are independent to first order.
    fn independent(&self, values: &[f64], order: &[usize]) -> Option<Vec<usize>> {
        let n = self.leaves.len();
        let mut rows: Vec<Vec<f64>> =
            (0..self.count).map(|row| values[self.count + row * n..self.count + (row + 1) * n].to_vec()).collect();
        let mut unknown = Vec::new();
        for &column in order {
            let used = unknown.len();
            let Some(pivot) =
                (used..rows.len()).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))
            else {
                break;
            };
            let lead = rows[pivot][column];
            if lead.is_nan() || lead.abs() <= 1e-9 {
                continue;
            }
            rows.swap(used, pivot);
            let top = rows[used].clone();
            for row in &mut rows[used + 1..] {
                let factor = row[column] / lead;
                row.iter_mut().zip(&top).for_each(|(v, t)| *v -= factor * t);
            }
            unknown.push(column);
        }
        unknown.sort_unstable();
        (unknown.len() == self.count).then_some(unknown)
    }

    fn slopes<T: Clone>(&self, values: &[T], unknown: &[usize]) -> Vec<Vec<T>> {
        let n = self.leaves.len();
        let of = |row: usize| unknown.iter().map(move |&at| values[self.count + row * n + at].clone());
        (0..self.count).map(|row| of(row).collect()).collect()
    }

    /// The point with rational numbers close by for what was solved for.
    fn near(&self, chosen: &[Rational], x: &[f64], unknown: &[usize]) -> Option<Vec<Rational>> {
        let mut exact = chosen.to_vec();
        for &at in unknown {
            exact[at] = (1..=12).find_map(|d| {
                let top = (x[at] * f64::from(d)).round();
                let close = (x[at] * f64::from(d) - top).abs() < 1e-9 && top.abs() < 1e6;
                close.then(|| Rational::from(top as i64) / Rational::from(d))
            })?;
        }
        Some(exact)
    }

    /// The point, if it satisfies the equations exactly.
    fn exactly(&self, exact: Vec<Rational>) -> Option<Place> {
        let mut slots: Slots<Exact> = self.tape.slots(&());
        for (i, value) in exact.iter().cloned().enumerate() {
            slots.set(i, Ok(Exact(value)));
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
    let values = system.values(place);
    if !admits(graph, given, &values) {
        return None;
    }
    let sides: Vec<Expr> = claim.iter().flat_map(|&(l, r)| [l, r]).collect();
    let at = decimals(graph, &sides, &values);
    let pairs: Option<Vec<(Bounded, Bounded)>> = at.as_chunks().0.iter().map(|&[l, r]| Some((l?, r?))).collect();
    let (equation, (l, r)) = pairs?.into_iter().enumerate().find(|&(_, (l, r))| are_apart(l, r))?;
    let side = |v: Bounded| Side { exact: None, decimal: v.value };
    Some(Refutation {
        equation,
        point: system.point(place),
        named: Vec::new(),
        left: side(l),
        right: side(r),
        second: None,
    })
}
