//! Independence of functions of the state, at every time.
//!
//! Let G have the gradients of the constraints as rows, F those of the functions. They are independent where the rows of both
//! together are linearly independent. **Theorem.** If ‖1 − AQ‖ < 1 in the maximum norm for a matrix Q and every matrix A of an
//! interval matrix, then the rows of each A are independent: AQ is invertible (Neumann's series). Over a stretch of time A is a
//! matrix of Taylor models, and Q one of polynomials, close to a right inverse; nothing is assumed of it. Rows that are the same expressions are taken once, so
//! that the rank of G is the number of its rows whenever the rows of both are independent, and rank (G, F) − rank G is the
//! number of functions.
//!
//! That functions are **dependent** is an equality, and no interval shows one. It is shown by exact arithmetic, at the start
//! of a motion whose parameters and initial states are rational numbers.

use super::cover::{Along, Judgement, Ranges};
use super::pair::Asked;
use super::ready::{Ready, Shown};
use crate::expr::{Expr, Graph, Leaf};
use crate::number::{Interval, NODES, NoValue, Number, Rational, TaylorModel};
use crate::verdict::{Enclosed, Witness};
use claim::program::Part;
use nalgebra::DMatrix;
use reason::{Enclosing, Plain, Reason, Refutation};
use sampled::independence::{Gradients, exact_rank};

/// The gradients along a motion.
pub(super) struct Rank<'a> {
    /// The assumptions of the claim.
    ready: Ready<'a>,
    /// Rows of places, `None` for an entry that is 0.
    rows: Vec<Vec<Option<usize>>>,
    /// Which functions are dependent at the start, if that is exact: rank beside the constraints, and how many there are.
    dependent: Result<(usize, usize), Reason>,
    gradients: &'a Gradients,
}

impl<'a> Rank<'a> {
    /// # Errors
    /// What the motion does not know.
    pub fn new(
        asked: &Asked<'a, '_>,
        part: &'a Part,
        gradients: &'a Gradients,
        along: &mut Along,
    ) -> Result<Rank<'a>, Reason> {
        let mut ready = Ready::new(asked.program, part, along, asked.claim)?;
        let (constraints, all) = gradients.rows();
        let mut distinct: Vec<&[Expr]> = Vec::new();
        for (at, row) in all.iter().enumerate() {
            let zero = row.iter().all(|&e| along.graph.is_zero(e));
            let known = distinct.contains(row);
            if at >= constraints || !(zero || known) {
                distinct.push(row);
            }
        }
        let mut places = Vec::new();
        for &e in distinct.iter().copied().flatten() {
            let zero = along.graph.is_zero(e);
            places.push(if zero { None } else { Some(along.difference(e)?) });
        }
        let first = ready.beside(places.iter().flatten().copied());
        let mut next = first..;
        let of: Vec<Option<usize>> = places.iter().map(|p| p.and_then(|_| next.next())).collect();
        let columns = all.first().map_or(1, |row| row.len().max(1));
        let rows = of.chunks(columns).map(<[Option<usize>]>::to_vec).collect();
        let dependent = exactly(asked, along, constraints, &all);
        Ok(Rank { ready, rows, dependent, gradients })
    }

    /// At every time.
    pub fn always(&self, along: &mut Along) -> Shown {
        if self.ready.event.is_some() {
            return Shown::Nothing(Plain::IndependentAtEvents.into());
        }
        let (mut may_say, mut says) = (false, false);
        let judge = |_: Interval, ranges: &Ranges| {
            let selected = self.ready.selected(ranges);
            if selected == Some(false) {
                return Judgement::Settled;
            }
            match self.independent(ranges) {
                true => {
                    may_say = true;
                    says |= selected == Some(true);
                    Judgement::Settled
                }
                false => Judgement::Open(Plain::MayBeDependent.into()),
            }
        };
        match along.cover(&self.ready.roots, judge, |_| false) {
            Ok(_) if !may_say => Shown::Void(Plain::NoTimeOfSpanCounts.into()),
            Ok(looked) => {
                let enclosed = Enclosed { places: looked, gap: 0.0, scale: 1.0 };
                let reason = Enclosing::EveryTime { stretches: looked, within: None }.into();
                if says { Shown::Holds(enclosed, reason) } else { Shown::Unless(enclosed, reason) }
            }
            Err(reason) => super::span::alone(along, &self.ready.roots, reason, |ranges| {
                self.ready.selected(ranges) == Some(false) || self.independent(ranges)
            }),
        }
    }

    /// Whether the rows are independent at all times of a stretch.
    fn independent(&self, ranges: &Ranges) -> bool {
        let entry = |place: &Option<usize>| match place {
            None => Some(TaylorModel::ZERO),
            Some(at) => ranges[*at].as_ref().ok().map(|reach| *reach.model()),
        };
        let rows: Option<Vec<Vec<TaylorModel>>> = self.rows.iter().map(|row| row.iter().map(entry).collect()).collect();
        rows.is_some_and(|rows| independent(&rows).unwrap_or(false))
    }

    /// That the functions are dependent at the start.
    ///
    /// # Errors
    /// Why that is not certain.
    pub fn refuted(&self, along: &mut Along) -> Result<(Witness, Refutation), Reason> {
        let (rank, of) = self.dependent.clone()?;
        let t = along.enclosure.initial_time();
        let ranges = along.over(&self.ready.roots, Interval::point(t));
        if self.ready.selected(&ranges) != Some(true) {
            return Err(Enclosing::AssumedAt(t).into());
        }
        Ok((self.gradients.witness(t, rank), Refutation::Dependent { t, rank, of }))
    }
}

/// Whether the rows are independent at every time: see the module.
///
/// # Errors
/// A bound that is not finite.
fn independent(rows: &[Vec<TaylorModel>]) -> Result<bool, NoValue> {
    let (m, n) = (rows.len(), rows.first().map_or(0, Vec::len));
    if m == 0 || m > n {
        return Ok(m == 0);
    }
    // Q at a few times, and polynomials through that; rows of the same length, for Q alone.
    let size = |row: &[TaylorModel]| row.iter().map(TaylorModel::bound).fold(f64::MIN_POSITIVE, f64::max);
    let sizes: Vec<f64> = rows.iter().map(|row| size(row)).collect();
    let mut values = vec![[0.0; NODES]; n * m];
    #[expect(clippy::needless_range_loop, reason = "one of two indices")]
    for node in 0..NODES {
        let there = DMatrix::from_fn(m, n, |i, j| rows[i][j].at_node(node) / sizes[i]);
        let Some(inverse) = (&there * there.transpose()).try_inverse() else { return Ok(false) };
        let right = there.transpose() * inverse;
        for (k, j) in (0..n).flat_map(|k| (0..m).map(move |j| (k, j))) {
            values[k * m + j][node] = right[(k, j)] / sizes[j];
        }
    }
    let q: Vec<TaylorModel> = values.iter().map(TaylorModel::through).collect::<Result<_, _>>()?;
    for (i, row) in rows.iter().enumerate() {
        let mut total = Interval::point(0.0);
        for j in 0..m {
            let mut sum = TaylorModel::constant(Interval::point(if i == j { -1.0 } else { 0.0 }));
            for (k, entry) in row.iter().enumerate().filter(|(_, entry)| entry.bound() > 0.0) {
                let (mut product, before) = (TaylorModel::ZERO, sum);
                product.mul(&(), entry, &q[k * m + j])?;
                sum.add(&(), &before, &product)?;
            }
            total = total + Interval::point(sum.bound());
        }
        // What is no number refutes, too.
        if total.hi() >= 1.0 || total.hi().is_nan() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The rank of the functions beside the constraints at the start of a motion, in exact arithmetic, if it is too small.
///
/// # Errors
/// Why that is not known.
fn exactly(asked: &Asked, along: &mut Along, constraints: usize, all: &[&[Expr]]) -> Result<(usize, usize), Reason> {
    let t = Rational::try_from(along.enclosure.initial_time()).map_err(|_| Plain::StartIsNoNumber)?;
    let (graph, time) = (&mut along.graph, along.enclosure.time());
    if asked.claim.at.as_ref().is_some_and(|at| !at.occasion.is_any()) {
        return Err(Plain::StartNotCounted.into());
    }
    if let Some(at) = asked.program.at {
        let there = at_start(graph, at, asked.start, time, &t);
        if !graph.is_zero(there) {
            return Err(Plain::StartNoExactEvent.into());
        }
    }
    let mut value = |&e: &Expr| {
        let there = at_start(graph, e, asked.start, time, &t);
        graph.as_constant(there).cloned()
    };
    let rows: Option<Vec<Vec<Rational>>> = all.iter().map(|row| row.iter().map(&mut value).collect()).collect();
    let rows = rows.ok_or(Plain::StartNotRational)?;
    let functions = rows.len() - constraints;
    let found = exact_rank(rows.clone()) - exact_rank(rows[..constraints].to_vec());
    if found < functions { Ok((found, functions)) } else { Err(Plain::IndependentAtStart.into()) }
}

/// An expression at the start, with everything put in that is given.
fn at_start(graph: &mut Graph, e: Expr, start: &[(Leaf, Expr)], time: Leaf, t: &Rational) -> Expr {
    let mut e = e;
    // Parameters may be given by others, states by parameters.
    for _ in 0..=start.len() {
        let next = graph.substitute(e, |graph, leaf| {
            if leaf == time {
                return Some(graph.constant(t.clone()));
            }
            let now = match leaf.instant {
                // A value at the start is that at the start.
                Some(instant) if graph.as_constant(instant) == Some(t) => Leaf { instant: None, ..leaf },
                _ => leaf,
            };
            start.iter().find(|(known, _)| *known == now).map(|(_, value)| *value)
        });
        if next == e {
            break;
        }
        e = next;
    }
    e
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(at: f64, slope: f64) -> TaylorModel {
        let mut values = [0.0; NODES];
        let s = TaylorModel::variable(Interval::point(0.0), 1.0);
        values.iter_mut().enumerate().for_each(|(node, v)| *v = at + slope * s.at_node(node));
        TaylorModel::through(&values).expect("finite")
    }

    #[test]
    fn rows_that_turn_are_independent_until_they_meet() {
        let (one, zero) = (line(1.0, 0.0), TaylorModel::ZERO);
        // (1, 0, 0) and (1, a + s·b, 0): dependent where a + s·b = 0.
        let rows =
            |a: f64, b: f64, unknown: f64| vec![vec![one, zero, zero], vec![one, line(a, b).widened(unknown), zero]];
        assert_eq!(independent(&rows(1e-3, 1e-4, 0.0)), Ok(true));
        assert_eq!(independent(&rows(1e-3, 5e-4, 0.0)), Ok(true));
        assert_eq!(independent(&rows(1e-3, 1.1e-3, 0.0)), Ok(false));
        assert_eq!(independent(&rows(1e-3, 1e-4, 1e-2)), Ok(false));
        assert_eq!(independent(&rows(0.0, 0.0, 0.0)), Ok(false));
        // More rows than there is room for.
        assert_eq!(independent(&[vec![one], vec![one]]), Ok(false));
    }

    #[test]
    fn ranks_of_rational_matrices_are_exact() {
        let rank =
            |rows: &[&[i64]]| exact_rank(rows.iter().map(|r| r.iter().map(|&x| Rational::from(x)).collect()).collect());
        assert_eq!(rank(&[&[1, 2, 3], &[2, 4, 6]]), 1);
        assert_eq!(rank(&[&[0, 2, 3], &[0, 4, 6], &[1, 0, 0]]), 2);
        assert_eq!(rank(&[&[1, 2], &[3, 4]]), 2);
        assert_eq!(rank(&[]), 0);
    }
}
