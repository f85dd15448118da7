//! Solutions of systems: what a claim says of motions, by the theorem that one motion goes through each state.
//!
//! **In:** equations, and systems that are given. **Out:** a proof that the equations hold along every motion of the systems, if they
//! hold at a fixed time that is named.
//!
//! Let the systems be ẋ = F(x, t), F analytic. The residuals of the equations, as functions r(x, t), are joined by their rates
//! along the motion, as functions of x and t, until all rates of them vanish wherever they all do. If the gradients of the residuals by x
//! are independent at every point, a rate that vanishes there is a sum of residuals with smooth factors (Hadamard's lemma), so that the
//! residuals obey a linear equation along each motion, the only solution of which that is 0 once is 0 (Picard and Lindelöf). Independent
//! they are for certain where some of the slopes are numbers whose matrix has full rank, or where numbers and positive parameters make it
//! triangular.

use super::gather::Gathered;
use super::{LEFT_OUT_NODES, Pairs, Step, has_exceptions};
use crate::expr::{Expr, FastMap, FastSet, Leaf, Node, Op, Rational, Symbol};
use claim::comparison::{at_instant, traced};
use proof::{Condition, Identity, Known, Options, Premises, Proof, Wanted, When};

/// More residuals are not looked at.
const MOST_RESIDUALS: usize = 8;
/// Residuals with more nodes are not looked at.
const MOST_NODES: usize = 600;
/// More rates are not solved for together.
const MOST_TOGETHER: usize = 3;

/// What systems determine.
pub(super) struct Determined {
    /// The highest rates of the states, by the states.
    pub(super) rates: FastMap<Leaf, Expr>,
    /// Constants that are divided by, and may be 0.
    pub(super) divided: Vec<Expr>,
}

impl Step<'_> {
    /// A proof that the equations hold along every motion, since they do at one time and a motion is determined by that.
    pub(super) fn by_uniqueness(&mut self, gathered: &Gathered, equations: &Pairs) -> Option<Identity> {
        if gathered.lasting != When::Always {
            return None;
        }
        let claimed: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let given = gathered.premises.sides();
        let named = self.graph.leaves_within(claimed.into_iter().chain(given));
        let start = named.iter().find_map(|l| l.instant)?;
        self.start = Some(start);
        let Determined { rates, divided } = self.rates_of_systems()?;
        let mut residuals = Vec::new();
        for &(l, r) in equations {
            let residual = self.graph.sub(l, r);
            residuals.push(self.of_states(residual, &rates)?);
        }
        let bent = residuals.iter().chain(rates.values()).copied();
        if self.graph.reachable(bent).into_iter().any(|e| self.is_branching(e)) {
            return None;
        }
        let options = Options { attempts: 1, most_nodes: LEFT_OUT_NODES, wanted: Wanted::Proof, ..Options::default() };
        let mut proof: Option<Proof> = None;
        let (mut at, zero) = (0, self.graph.integer(0));
        while at < residuals.len() {
            // More rows do not make it so.
            if !self.are_independent(&residuals, &rates) {
                return None;
            }
            let rate = self.rate_of_states(residuals[at], &rates)?;
            let premises = self.where_all_vanish(gathered, &residuals);
            match self.test_only(&premises, &vec![(rate, zero)], &options) {
                Identity::Proved(one) if !has_exceptions(&one) => match &mut proof {
                    None => proof = Some(one),
                    Some(all) => all.absorb(one),
                },
                _ if residuals.len() < MOST_RESIDUALS => residuals.push(rate),
                _ => return None,
            }
            at += 1;
        }
        let scope = &self.claim.scope;
        let then: Pairs = residuals.iter().map(|&r| (at_instant(&mut self.graph, scope, r, start), zero)).collect();
        let begun = self.levels(gathered, &then, false, Wanted::Proof);
        self.settled = None;
        match begun {
            Identity::Proved(mut all) if !has_exceptions(&all) => {
                proof.into_iter().for_each(|one| all.absorb(one));
                // Where one of them is 0, the systems determine less.
                all.conditions.extend(divided.into_iter().map(Condition::Pivot));
                Some(Identity::Proved(all))
            }
            Identity::Proved(_) | Identity::Refuted(_) | Identity::Undecided(_) => None,
        }
    }

    /// What the highest rates of all states are, by the systems that are given; `None` where an equation is not linear in one of its own.
    pub(super) fn rates_of_systems(&mut self) -> Option<Determined> {
        let equations = self.equations_of_systems();
        let highest = self.highest_rates(&equations);
        let (mut rates, mut divided) = (FastMap::default(), Vec::new());
        for (l, r) in equations {
            let residual = self.graph.sub(l, r);
            let residual = traced(&mut self.graph, &self.claim.scope, residual);
            let leaves = self.graph.leaves([residual]);
            let mut own = leaves.into_iter().filter(|l| highest.values().any(|h| h == l));
            let (Some(leaf), None) = (own.next(), own.next()) else { return None };
            let slope = self.graph.slope(residual, leaf).ok()?;
            // Where it vanishes, nothing is determined.
            if self.graph.is_zero(slope) || self.moves(slope) {
                return None;
            }
            if !self.is_nonzero(slope) {
                divided.push(slope);
            }
            let zero = self.graph.integer(0);
            let rest = self.graph.replaced(residual, |_, l| (l == leaf).then_some(zero));
            let quotient = self.graph.div(rest, slope);
            let rate = self.graph.neg(quotient);
            if rates.insert(leaf, rate).is_some() {
                return None;
            }
        }
        // A motion may be continued in several ways where a rate has no value.
        let poles = self.poles(rates.values().copied().collect());
        (!poles.into_iter().any(|under| self.moves(under))).then_some(Determined { rates, divided })
    }

    /// The highest rate of each component that equations name.
    fn highest_rates(&self, equations: &Pairs) -> FastMap<(Symbol, u16), Leaf> {
        let sides = equations.iter().flat_map(|&(l, r)| [l, r]);
        let mut highest: FastMap<(Symbol, u16), Leaf> = FastMap::default();
        for leaf in self.graph.leaves_within(sides).into_iter().filter(|l| l.rate > 0 && l.instant.is_none()) {
            let one = highest.entry((leaf.symbol, leaf.component)).or_insert(leaf);
            *one = if leaf.rate > one.rate { leaf } else { *one };
        }
        highest
    }

    /// The components whose highest rates are determined by equations of systems, as analytic functions of the states, wherever the
    /// equations have values; `None` where there are others, or that cannot be told. A motion does not come to where its equations have
    /// no value.
    pub(super) fn determined(&mut self, equations: &Pairs) -> Option<FastSet<(Symbol, u16)>> {
        let mut residuals = Vec::new();
        for &(l, r) in equations {
            let residual = self.graph.sub(l, r);
            residuals.push(traced(&mut self.graph, &self.claim.scope, residual));
        }
        residuals.retain(|&r| !self.graph.is_zero(r));
        let zero = self.graph.integer(0);
        let highest = self.highest_rates(&residuals.iter().map(|&r| (r, zero)).collect());
        if residuals.is_empty() || residuals.len() != highest.len() {
            return None;
        }
        let mut beside = Gathered::default();
        beside.throughout.nonzero = self.divided_by(equations);
        let nodes = self.graph.reachable(residuals.iter().copied());
        if nodes.into_iter().any(|e| self.is_branching(e) && self.may_reach_edge(e, &beside)) {
            return None;
        }
        let mut open: Vec<Leaf> = highest.values().copied().collect();
        open.sort_unstable();
        while !open.is_empty() {
            let named = |this: &Self, e: Expr| -> Vec<Leaf> {
                let leaves = this.graph.leaves([e]);
                open.iter().copied().filter(|l| leaves.contains(l)).collect()
            };
            // One by one where that is possible; what is left, all together.
            let alone = residuals.iter().position(|&r| named(self, r).len() == 1);
            let (rows, columns) = match alone {
                Some(at) => {
                    let row = residuals.swap_remove(at);
                    (vec![row], named(self, row))
                }
                None => (std::mem::take(&mut residuals), open.clone()),
            };
            if rows.len() != columns.len() || rows.len() > MOST_TOGETHER {
                return None;
            }
            let mut slopes = Vec::new();
            for &row in &rows {
                for &column in &columns {
                    let slope = self.graph.slope(row, column).ok()?;
                    if !named(self, slope).is_empty() {
                        return None;
                    }
                    slopes.push(slope);
                }
            }
            let determinant = self.determinant(&slopes, columns.len());
            if !self.is_nonzero(determinant) && !self.never_vanishes(determinant, &beside) {
                return None;
            }
            open.retain(|l| !columns.contains(l));
        }
        Some(highest.into_keys().collect())
    }

    /// The determinant of a matrix, given by its rows.
    fn determinant(&mut self, rows: &[Expr], size: usize) -> Expr {
        if size == 1 {
            return rows[0];
        }
        let mut sum = self.graph.integer(0);
        for column in 0..size {
            let minor: Vec<Expr> = (size..size * size).filter(|at| at % size != column).map(|at| rows[at]).collect();
            let minor = self.determinant(&minor, size - 1);
            let term = self.graph.mul(rows[column], minor);
            sum = if column % 2 == 0 { self.graph.add(sum, term) } else { self.graph.sub(sum, term) };
        }
        sum
    }

    /// A formula in states alone: without observables, and without the rates that the systems determine. `None` where others are named.
    fn of_states(&mut self, e: Expr, rates: &FastMap<Leaf, Expr>) -> Option<Expr> {
        let e = traced(&mut self.graph, &self.claim.scope, e);
        let e = self.graph.substitute(e, |_, leaf| rates.get(&leaf).copied());
        let known = |leaf: &Leaf| {
            if self.graph.is_field(leaf.symbol) {
                return false;
            }
            let is_state = |h: &Leaf| (h.symbol, h.component) == (leaf.symbol, leaf.component) && leaf.rate < h.rate;
            leaf.instant.is_some() || !self.claim.scope.moves(leaf) || rates.keys().any(is_state)
        };
        let small = self.graph.reachable([e]).len() <= MOST_NODES;
        (small && self.graph.leaves([e]).iter().all(known)).then_some(e)
    }

    fn rate_of_states(&mut self, e: Expr, rates: &FastMap<Leaf, Expr>) -> Option<Expr> {
        let scope = &self.claim.scope;
        let rate = self.graph.time_derivative(e, scope.time()?, |leaf| scope.moves(&leaf)).ok()?;
        self.of_states(rate, rates)
    }

    /// That the residuals vanish, and what is given of constants, values at fixed times among them. What else is given of states may
    /// hold along the motion alone, and not beside it.
    fn where_all_vanish(&mut self, gathered: &Gathered, residuals: &[Expr]) -> Premises {
        let (zero, scope) = (self.graph.integer(0), &self.claim.scope);
        let moves = |l: &Leaf| l.instant.is_none() && (scope.moves(l) || Some(*l) == scope.time());
        let is_constant = |e: &Expr| !self.graph.leaves_within([*e]).iter().any(moves);
        let Premises { mut equations, mut nonzero, mut positive, mut not_negative, parameters, .. } =
            gathered.premises.clone();
        equations.retain(|k| is_constant(&k.left) && is_constant(&k.right));
        for facts in [&mut nonzero, &mut positive, &mut not_negative] {
            facts.retain(is_constant);
        }
        let own: Pairs = residuals.iter().map(|&r| (r, zero)).collect();
        // Beside the motion: at a point, not for a while.
        equations.extend(own.iter().map(|&pair| Known::of(pair, When::Chosen)));
        let mut premises = Premises { equations, nonzero, positive, not_negative, parameters, ..Premises::default() };
        self.add_positive_parameters(&own, &mut premises);
        premises
    }

    /// Whether the gradients of residuals by the states are independent at every point: their matrix has full rank, or triangular form,
    /// by numbers and positive parameters.
    fn are_independent(&mut self, residuals: &[Expr], rates: &FastMap<Leaf, Expr>) -> bool {
        let mut states: Vec<Leaf> = self.graph.leaves(residuals.iter().copied());
        states.retain(|l| {
            l.instant.is_none() && rates.keys().any(|h| (h.symbol, h.component) == (l.symbol, l.component))
        });
        let slope = |this: &mut Self, r: Expr, by: Leaf| this.graph.slope(r, by).ok();
        let columns: Option<Vec<Vec<Expr>>> =
            states.into_iter().map(|state| residuals.iter().map(|&r| slope(self, r, state)).collect()).collect();
        let Some(columns) = columns else { return false };
        let number = |e: &Expr| self.graph.as_constant(*e).cloned();
        let numbers: Vec<Vec<Rational>> =
            columns.iter().filter_map(|column| column.iter().map(number).collect()).collect();
        if rank(numbers) == residuals.len() {
            return true;
        }
        // A state that only one of those that are left names, for certain.
        let mut left: Vec<usize> = (0..residuals.len()).collect();
        while !left.is_empty() {
            let alone = columns.iter().find_map(|column| {
                let mut named = left.iter().copied().filter(|&i| !self.graph.is_zero(column[i]));
                named.next().filter(|&i| named.next().is_none() && self.is_nonzero(column[i]))
            });
            let Some(alone) = alone else { return false };
            left.retain(|&i| i != alone);
        }
        true
    }

    /// Whether something is a product of numbers and positive parameters.
    fn is_nonzero(&self, e: Expr) -> bool {
        match *self.graph.node(e) {
            Node::Constant(_) => !self.graph.is_zero(e),
            Node::Leaf(leaf) => self.is_positive_parameter(leaf),
            Node::Unary(Op::Neg | Op::Powi(_) | Op::Sqrt, a) => self.is_nonzero(a),
            Node::Binary(Op::Mul | Op::Div, a, b) => self.is_nonzero(a) && self.is_nonzero(b),
            Node::Pi | Node::Unary(..) | Node::Binary(..) => false,
        }
    }
}

/// The rank of a matrix.
fn rank(mut rows: Vec<Vec<Rational>>) -> usize {
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] != Rational::ZERO) else { continue };
        rows.swap(rank, pivot);
        let top = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            let factor = &row[column] / &top[column];
            for (x, t) in row.iter_mut().zip(&top) {
                *x -= &factor * t;
            }
        }
        rank += 1;
    }
    rank
}
