//! Initial values that equations determine.
//!
//! **In:** n equations F(x) = 0 between n unknowns x and constants, and for each unknown a guess g and a distance w. **Out:** the
//! solution with |x − g| ≤ w, enclosed. **Guaranteed:** there is exactly one, and it lies in the enclosure, for all values of the
//! constants in theirs. Where that is not shown, nothing is returned but why.
//!
//! **Theorem** ([Krawczyk 1969]; uniqueness: [Neumaier 1990, Theorem 5.1.8]). Let F have continuous partial derivatives on a box
//! V, J ⊇ F′(V) an interval matrix, y ∈ V and C any matrix. With K(V) = y − C·F(y) + (1 − C·J)(V − y), every zero of F in V lies
//! in K(V), so that there is none if K(V) ∩ V is empty; and if K(V) lies in the interior of V, then V contains exactly one zero.
//! With constants in intervals, all of this holds for each choice of them.
//!
//! **How.** The box is bisected, breadth first; a part is dropped where an equation has no zero on it, or K(V) ∩ V is empty, and
//! where it lies in a neighbourhood in which one zero was verified. Whatever else is left over makes the answer unclear. The one
//! zero is then narrowed, with F(y) in twice the precision of binary64: of the constants the last rounding counts, no more.
//!
//! **Why its own search beside the one over ranges of values:** that one answers claims, with parameters in cells and other
//! relations, and may leave parts undecided; here constants are points, and all that is not decided is refused.
//!
//! [Krawczyk 1969]: https://doi.org/10.1007/BF02234767
//! [Neumaier 1990, Theorem 5.1.8]: https://doi.org/10.1017/CBO9780511526473

use std::collections::VecDeque;

use nalgebra::DMatrix;

use super::error::{FlowError, leaf_name};
use super::field::VectorField;
use expr::tape::Tape;
use expr::{Expr, Graph, Leaf, Op, Rational};
use number::{Decorated, Interval, Number, Precise, PreciseModel, Scalar};

/// Most parts of the box that are looked at.
const MOST_PARTS: usize = 20_000;
/// Most times that an enclosure is narrowed.
const MOST_ITERATIONS: usize = 12;
/// By so much of its width a part is made larger on each side before a zero is verified in it.
const LARGER: f64 = 0.1;
/// Parts narrower than this part of the box are not bisected.
const NARROWEST: f64 = 1e-12;
/// Most times that rates that the system gives are put into one another.
const MOST_ROUNDS: usize = 32;

/// An unknown and where it is looked for.
#[derive(Clone, Debug)]
pub struct Guess {
    /// What the equations and the initial values call it.
    pub leaf: Leaf,
    /// How a formula writes the quantity.
    pub name: String,
    /// The guess.
    pub near: Expr,
    /// How far from it; half of it unless given.
    pub within: Option<Expr>,
}

/// Initial values that equations determine.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// The unknowns.
    pub guesses: Vec<Guess>,
    /// As many expressions that are 0.
    pub differences: Vec<Expr>,
}

/// An expression at the initial time: states and their rates are replaced by what is given for them, other rates by what the system
/// says of them.
///
/// # Errors
/// [`FlowError::CircularStart`].
pub(super) fn at_start(
    graph: &mut Graph,
    field: &VectorField,
    initial: &[(Leaf, Expr)],
    mut e: Expr,
) -> Result<Expr, FlowError> {
    let image = |leaf: Leaf| -> Option<Expr> {
        if let Some((_, given)) = initial.iter().find(|(l, _)| *l == leaf) {
            return Some(*given);
        }
        let lower = Leaf { rate: leaf.rate.checked_sub(1)?, ..leaf };
        let at = field.states().iter().position(|s| *s == lower)?;
        field.rates().get(at).copied()
    };
    for _ in 0..MOST_ROUNDS {
        let leaves = graph.leaves([e]);
        if !leaves.iter().any(|&l| image(l).is_some()) {
            return Ok(e);
        }
        e = graph.substitute(e, |_, leaf| image(leaf));
    }
    let leaf = graph.leaves([e]).into_iter().find(|&l| image(l).is_some());
    Err(FlowError::CircularStart { leaf: leaf.map_or_else(String::new, |l| leaf_name(graph, l)) })
}

/// The start, ready to be solved: everything in constants, the time and the unknowns.
pub(super) struct Ready<'a> {
    guesses: &'a [Guess],
    /// Guess and distance of every unknown.
    around: Vec<(Expr, Option<Expr>)>,
    differences: Vec<Expr>,
}

impl Start {
    /// Puts definitions in; `resolve` does that for what is given at the initial time.
    pub(super) fn resolved(
        &self,
        graph: &mut Graph,
        field: &VectorField,
        initial: &[(Leaf, Expr)],
        mut resolve: impl FnMut(&mut Graph, Expr) -> Result<Expr, FlowError>,
    ) -> Result<Ready<'_>, FlowError> {
        // An unknown is no definition of the motion: while others are put in, it is left as it is.
        let mut put = |graph: &mut Graph, e: Expr| -> Result<Expr, FlowError> {
            let e = at_start(graph, field, initial, e)?;
            let leaves = graph.leaves([e]);
            let mut images = Vec::new();
            for leaf in leaves.into_iter().filter(|l| !self.guesses.iter().any(|g| g.leaf == *l)) {
                let of = graph.leaf(leaf);
                images.push((leaf, resolve(graph, of)?));
            }
            Ok(graph.substitute(e, |_, leaf| images.iter().find(|(l, _)| *l == leaf).map(|(_, e)| *e)))
        };
        let (mut around, mut differences) = (Vec::new(), Vec::new());
        for guess in &self.guesses {
            let near = put(graph, guess.near)?;
            let within = guess.within.map(|e| put(graph, e)).transpose()?;
            around.push((near, within));
        }
        for &d in &self.differences {
            differences.push(put(graph, d)?);
        }
        Ok(Ready { guesses: &self.guesses, around, differences })
    }
}

/// The values of expressions over constants.
fn values<N: Number<Context = ()>>(tape: &Tape, inputs: &[N]) -> Option<Vec<N>> {
    let mut slots = tape.slots::<N>(&());
    let inputs: Vec<_> = inputs.iter().cloned().map(Ok).collect();
    tape.evaluate(&(), &inputs, &mut slots).into_iter().map(Result::ok).collect()
}

impl Ready<'_> {
    /// The unknowns with their values; `value` gives those of constants.
    ///
    /// # Errors
    /// [`FlowError::NoStart`], [`FlowError::SeveralStarts`], [`FlowError::UnclearStart`], [`FlowError::StartAtEdge`],
    /// [`FlowError::Guess`].
    pub(super) fn solve(
        &self,
        graph: &mut Graph,
        value: impl Fn(Leaf) -> Option<Precise>,
    ) -> Result<Vec<(Leaf, Precise)>, FlowError> {
        if self.guesses.is_empty() {
            return Ok(Vec::new());
        }
        let mut sides = Vec::new();
        for (guess, (near, within)) in self.guesses.iter().zip(&self.around) {
            let side = self.side(graph, *near, *within, &value);
            sides.push(side.ok_or_else(|| FlowError::Guess { state: guess.name.clone() })?);
        }
        let near = sides
            .iter()
            .zip(self.guesses)
            .map(|(side, guess)| format!("{:?} ≤ {} ≤ {:?}", side.low.mid(), guess.name, side.high.mid()));
        let near = near.collect::<Vec<_>>().join(", ");
        let Some(equations) = Equations::new(graph, self, &value) else {
            let at = "any values".to_owned();
            return Err(FlowError::UnclearStart { near, at });
        };
        let shown = |x: &[Interval]| {
            let each = self.guesses.iter().zip(x).map(|(guess, side)| format!("{} = {:?}", guess.name, side.mid()));
            each.collect::<Vec<_>>().join(", ")
        };
        let outer: Vec<Interval> = sides.iter().map(|side| side.outer).collect();
        let found = equations.search(&outer);
        let mut zeros = found.zeros.iter();
        let enclosure = match (zeros.next(), zeros.next(), found.left.first()) {
            (Some(first), Some(second), _) if !found.unclear => {
                let (first, second) = (shown(&first.enclosure), shown(&second.enclosure));
                return Err(FlowError::SeveralStarts { first, second });
            }
            (None, _, None) => return Err(FlowError::NoStart { near }),
            (Some(only), None, None) => &only.enclosure,
            (Some(zero), _, None) => {
                return Err(FlowError::UnclearStart { near, at: shown(&zero.enclosure) });
            }
            (_, _, Some(left)) => return Err(FlowError::UnclearStart { near, at: shown(left) }),
        };
        if !sides.iter().zip(enclosure).all(|(side, x)| side.inner.contains_interval(*x)) {
            return Err(FlowError::StartAtEdge { near, at: shown(enclosure) });
        }
        let narrowed = equations.narrowed(enclosure);
        Ok(self.guesses.iter().map(|g| g.leaf).zip(narrowed).collect())
    }

    /// Where an unknown is looked for.
    fn side(
        &self,
        graph: &mut Graph,
        near: Expr,
        within: Option<Expr>,
        value: &impl Fn(Leaf) -> Option<Precise>,
    ) -> Option<Side> {
        let within = within.unwrap_or_else(|| {
            let (size, half) = (graph.unary(Op::Abs, near), graph.constant(Rational::ONE / Rational::from(2)));
            graph.mul(half, size)
        });
        let ends = [graph.sub(near, within), graph.add(near, within)];
        let number = |e: Expr| -> Option<Interval> {
            let leaves = graph.leaves([e]);
            let tape = Tape::compile(graph, &leaves, &[e]).ok()?;
            let inputs: Vec<Interval> = leaves.iter().map(|&l| Some(value(l)?.interval())).collect::<Option<_>>()?;
            values(&tape, &inputs)?.first().copied()
        };
        let [low, high] = [number(ends[0])?, number(ends[1])?];
        if low.hi() >= high.lo() {
            return None;
        }
        Some(Side {
            outer: Interval::new(low.lo(), high.hi()).ok()?,
            inner: Interval::new(low.hi(), high.lo()).ok()?,
            low,
            high,
        })
    }
}

/// Where an unknown is looked for: its ends are known up to rounding.
struct Side {
    /// No value that is meant is outside of it.
    outer: Interval,
    /// All values in it are meant.
    inner: Interval,
    low: Interval,
    high: Interval,
}

/// F and F′, over constants and unknowns.
struct Equations {
    values: Tape,
    slopes: Tape,
    /// The constants: first inputs of both.
    constants: Vec<Precise>,
}

/// A verified zero.
struct Zero {
    /// It is the only one here.
    neighbourhood: Vec<Interval>,
    /// It lies here.
    enclosure: Vec<Interval>,
}

#[derive(Default)]
struct Found {
    zeros: Vec<Zero>,
    /// Parts that are neither dropped nor decided.
    left: Vec<Vec<Interval>>,
    /// Whether two enclosures may belong to one zero.
    unclear: bool,
}

fn inside(a: &[Interval], b: &[Interval]) -> bool {
    a.iter().zip(b).all(|(a, b)| b.contains_interval(*a))
}

fn common(a: &[Interval], b: &[Interval]) -> Option<Vec<Interval>> {
    a.iter().zip(b).map(|(a, b)| a.intersection(*b)).collect()
}

impl Equations {
    fn new(graph: &mut Graph, ready: &Ready, value: &impl Fn(Leaf) -> Option<Precise>) -> Option<Equations> {
        let unknowns: Vec<Leaf> = ready.guesses.iter().map(|g| g.leaf).collect();
        let mut rows = Vec::new();
        for &d in &ready.differences {
            for &unknown in &unknowns {
                rows.push(graph.partial_derivative(d, unknown).ok()?);
            }
        }
        let all = graph.leaves(ready.differences.iter().chain(&rows).copied());
        let known: Vec<Leaf> = all.into_iter().filter(|l| !unknowns.contains(l)).collect();
        let constants: Vec<Precise> = known.iter().map(|&l| value(l)).collect::<Option<_>>()?;
        let inputs: Vec<Leaf> = known.into_iter().chain(unknowns).collect();
        let values = Tape::compile(graph, &inputs, &ready.differences).ok()?;
        let slopes = Tape::compile(graph, &inputs, &rows).ok()?;
        Some(Equations { values, slopes, constants })
    }

    fn on(&self, tape: &Tape, x: &[Interval]) -> Option<Vec<Decorated>> {
        let constants = self.constants.iter().map(Precise::interval);
        let inputs: Vec<Decorated> = constants.chain(x.iter().copied()).map(Decorated::all_of).collect();
        values(tape, &inputs)
    }

    /// The ranges of F on a box, and whether it has values and is continuous there; `None` where it has a value nowhere on it.
    fn value(&self, x: &[Interval]) -> Option<(Vec<Interval>, bool)> {
        let found = self.on(&self.values, x)?;
        let continuous = found.iter().all(Decorated::is_continuous);
        Some((found.iter().map(Decorated::range).collect(), continuous))
    }

    /// An approximate inverse C of F′ on a box, and 1 − C·F′ there; `None` where F is not known to be continuously differentiable, or
    /// no inverse is found.
    fn inverse(&self, v: &[Interval]) -> Option<(DMatrix<f64>, Vec<Interval>)> {
        let n = v.len();
        let slopes = self.on(&self.slopes, v)?;
        if !self.value(v)?.1 || !slopes.iter().all(Decorated::is_continuous) {
            return None;
        }
        let slopes: Vec<Interval> = slopes.iter().map(Decorated::range).collect();
        let inverse = DMatrix::from_fn(n, n, |i, k| slopes[n * i + k].mid()).try_inverse()?;
        let mut rest = Vec::with_capacity(n * n);
        for i in 0..n {
            for k in 0..n {
                let mut entry = Interval::point(if i == k { 1.0 } else { 0.0 });
                for j in 0..n {
                    entry = entry - Interval::point(inverse[(i, j)]) * slopes[n * j + k];
                }
                rest.push(entry.checked().ok()?);
            }
        }
        inverse.iter().all(|x| x.is_finite()).then_some((inverse, rest))
    }

    /// K(V), with the middle for y.
    fn krawczyk(&self, v: &[Interval]) -> Option<Vec<Interval>> {
        let n = v.len();
        let (inverse, rest) = self.inverse(v)?;
        let y: Vec<Interval> = v.iter().map(|side| Interval::point(side.mid())).collect();
        let (at, _) = self.value(&y)?;
        let one = |i: usize| {
            let mut sum = y[i];
            for (k, f) in at.iter().enumerate() {
                sum = sum - Interval::point(inverse[(i, k)]) * *f;
            }
            for k in 0..n {
                sum = sum + rest[n * i + k] * (v[k] - y[k]);
            }
            sum.checked().ok()
        };
        (0..n).map(one).collect()
    }

    /// A zero in a box or next to it, if it can be verified.
    fn verify(&self, x: &[Interval]) -> Option<Zero> {
        let larger: Vec<Interval> = x.iter().map(|side| side.widened(LARGER, f64::MIN_POSITIVE)).collect();
        for v in [&larger[..], x] {
            let Some(mut enclosure) = self.krawczyk(v) else { continue };
            if !v.iter().zip(&enclosure).all(|(v, k)| v.encloses_strictly(*k)) {
                continue;
            }
            for _ in 0..MOST_ITERATIONS {
                let next = self.krawczyk(&enclosure).and_then(|next| common(&next, &enclosure));
                match next {
                    Some(next) if next != enclosure => enclosure = next,
                    _ => break,
                }
            }
            return Some(Zero { neighbourhood: v.to_vec(), enclosure });
        }
        None
    }

    /// Looks for all zeros in a box.
    fn search(&self, sides: &[Interval]) -> Found {
        let mut found = Found::default();
        let mut open = VecDeque::from([sides.to_vec()]);
        for looked in 0.. {
            let Some(x) = open.pop_front() else { break };
            if looked >= MOST_PARTS {
                found.left.push(x);
                break;
            }
            if found.zeros.iter().any(|z| inside(&x, &z.neighbourhood)) {
                continue;
            }
            let Some((ranges, _)) = self.value(&x) else { continue };
            if ranges.iter().any(|r| !r.contains(0.0)) {
                continue;
            }
            if let Some(zero) = self.verify(&x) {
                let covered = inside(&x, &zero.neighbourhood);
                found.add(zero);
                if covered {
                    continue;
                }
            }
            let narrowed = match self.krawczyk(&x) {
                Some(image) => common(&image, &x),
                None => Some(x),
            };
            let Some(x) = narrowed else { continue };
            match bisected(&x, sides) {
                Some(halves) => open.extend(halves),
                None => found.left.push(x),
            }
        }
        // A zero beyond the box is none of those that are asked for.
        found.zeros.retain(|z| common(&z.enclosure, sides).is_some());
        found
    }

    /// The one zero of a box, in twice the precision. What is computed is K of the box with other points y.
    fn narrowed(&self, enclosure: &[Interval]) -> Vec<Precise> {
        let mut best: Vec<Precise> = enclosure.iter().copied().map(Precise::enclosing).collect();
        let mut v = enclosure.to_vec();
        for _ in 0..MOST_ITERATIONS {
            let Some(next) = self.precisely(&v, &best) else { break };
            // A zero that lies in both lies where they meet.
            let Some(both) = common(&next.iter().map(Precise::interval).collect::<Vec<_>>(), &v) else { break };
            let better = next.iter().zip(&best).any(|(a, b)| a.error() < 0.5 * b.error());
            if !better || next.iter().zip(&best).any(|(a, b)| a.error() > b.error()) {
                break;
            }
            (best, v) = (next, both);
        }
        best
    }

    /// K(V) with F(y) in twice the precision; y are the centres of `near`.
    fn precisely(&self, v: &[Interval], near: &[Precise]) -> Option<Vec<Precise>> {
        let n = v.len();
        let (inverse, rest) = self.inverse(v)?;
        let y: Vec<Precise> = near.iter().map(|x| Precise::new(x.centre(), 0.0)).collect();
        // The theorem is about y in V.
        if !y.iter().zip(v).all(|(y, v)| v.contains_interval(y.interval())) {
            return None;
        }
        let inputs: Vec<PreciseModel> = self.constants.iter().chain(&y).map(PreciseModel::constant).collect();
        let at = values(&self.values, &inputs)?;
        let one = |i: usize| {
            let mut sum = PreciseModel::constant(&y[i]);
            for (k, f) in at.iter().enumerate() {
                let c = PreciseModel::constant(&Precise::enclosing(Interval::point(-inverse[(i, k)])));
                let (mut product, mut next) = (PreciseModel::ZERO, PreciseModel::ZERO);
                product.mul(&(), &c, f).ok()?;
                next.add(&(), &sum, &product).ok()?;
                sum = next;
            }
            let mut around = Interval::point(0.0);
            for k in 0..n {
                around = around + rest[n * i + k] * (v[k] - y[k].interval());
            }
            let around = around.checked().ok()?;
            Some(sum.value().plus(&Precise::enclosing(around)))
        };
        (0..n).map(one).collect()
    }
}

impl Found {
    /// Adds a zero, unless it is known.
    fn add(&mut self, mut zero: Zero) {
        for known in &mut self.zeros {
            let Some(both) = common(&known.enclosure, &zero.enclosure) else { continue };
            if inside(&zero.enclosure, &known.neighbourhood) || inside(&known.enclosure, &zero.neighbourhood) {
                // One zero: it lies in both enclosures. Both neighbourhoods are done with; the larger one is kept.
                known.enclosure = both;
                if inside(&known.neighbourhood, &zero.neighbourhood) {
                    std::mem::swap(&mut known.neighbourhood, &mut zero.neighbourhood);
                }
                return;
            }
            self.unclear = true;
        }
        self.zeros.push(zero);
    }
}

/// The halves of a part along the side that is longest as a part of the box.
fn bisected(x: &[Interval], sides: &[Interval]) -> Option<[Vec<Interval>; 2]> {
    let part = |i: usize| x[i].width() / sides[i].width();
    let divisible = |i: &usize| x[*i].lo() < x[*i].mid() && x[*i].mid() < x[*i].hi();
    let along = (0..x.len()).filter(divisible).max_by(|&a, &b| part(a).total_cmp(&part(b)).then(b.cmp(&a)))?;
    if part(along) < NARROWEST {
        return None;
    }
    let half = |lo: f64, hi: f64| {
        let mut half = x.to_vec();
        half[along] = Interval::point(lo).hull(Interval::point(hi));
        half
    };
    let side = x[along];
    Some([half(side.lo(), side.mid()), half(side.mid(), side.hi())])
}
