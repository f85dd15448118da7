//! Through which points solutions of partial differential equations pass.
//!
//! **In:** equations of fields, each with the derivative that leads it (see [`jets`](super::jets)). **Out:** [`Passive`]:
//! equations with the same solutions, and what must not be 0 at a point so that every choice of values there that satisfies
//! them and their derivatives belongs to a solution; nothing where no theorem says so.
//!
//! # The theorem
//!
//! A point that satisfies equations and all of their derivatives need not belong to a solution: uₓ = yu, u_y = u have none but
//! u = 0. It does if no equation names a field, since polynomials have any derivatives; or by **Riquier's theorem** (Riquier
//! 1910; Ritt, *Differential Algebra*, 1950, ch. VIII; Rust, Reid & Wittkopf, ISSAC 1999): every equation is solved for its
//! leader, the factor of which is not 0 at the point; the equations are analytic there; they are *passive*: what two of them say
//! of one derivative is the same, given the equations that lead lower; and the field that leads an equation depends on all
//! coordinates of it. The ranking is one of those for which the theorem holds: how two derivatives compare does not depend on
//! the field, but for equal ones.
//!
//! # Two ways
//!
//! 1. *Each leads with another field*, and no equation names a derivative of another's leader, its own included. Then no two
//!    say anything of one derivative. Equations may be of any degree in their leaders, and a field that is defined by others
//!    leads before all.
//! 2. *Leaders of one field.* All equations are linear in their leaders, which are their highest derivatives. Where two lead
//!    with derivatives of one field, both are derived up to the least that they have in common. The difference, in which what
//!    leads is replaced by what it is, is 0 identically, or it is one more equation. So Maxwell's equations are passive as they
//!    are; those of an incompressible fluid are, with one for ∇²p. By the lemma of Boulier, Lazard, Ollivier and Petitot
//!    (ISSAC 1995) these pairs are enough.

use super::jets::{Led, rank};
use super::outcome::{Premises, Reason, Vanishes};
use expr::domain::{Change, Edge, Place, Sides, row};
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Partials};

/// More equations are not added.
const MOST_ADDED: usize = 10;

/// An addition of higher order is not looked at.
const HIGHEST_ADDED: u32 = 4;

/// Nodes of the graph that may be made.
const MOST_NODES: usize = 12_000;

/// What is replaced by what it is, at most so often in one expression.
const MOST_REPLACED: usize = 24;

/// Equations through whose points solutions pass.
#[derive(Clone, Debug)]
pub(super) struct Passive {
    /// What must not be 0 at the point: what is divided by when each equation is solved for its leader.
    pub(super) slopes: Vec<Expr>,
    /// The equations, those that were added behind the others; `None`: they are those that were given, with their leaders.
    pub(super) completed: Option<Vec<Led>>,
}

/// The equations made passive, if a theorem then says that solutions pass through their points. `constants` are equations that
/// name neither fields nor coordinates; `is_zero` tests whether something is 0 by them.
///
/// # Errors
/// [`Reason::NoDerivative`] where a derivative cannot be written.
pub(super) fn passive(
    graph: &mut Graph,
    led: &[Led],
    constants: &Premises,
    (time, is_zero): (Option<Leaf>, Vanishes),
) -> Result<Option<Passive>, Reason> {
    if !led.iter().all(|p| is_analytic(graph, p)) {
        return Ok(None);
    }
    if are_apart(graph, led) && led.iter().all(|p| depends_on_all(graph, p)) {
        let slopes = led.iter().map(|p| slope(graph, p)).collect::<Result<_, _>>()?;
        return Ok(Some(Passive { slopes, completed: None }));
    }
    Completion {
        limit: graph.len() + MOST_NODES,
        graph,
        constants,
        time,
        is_zero,
        all: Vec::new(),
        images: FastMap::default(),
    }
    .of(led)
}

fn is_analytic(graph: &Graph, p: &Led) -> bool {
    // Both sides of a pole belong to one analytic function, and a point has a value there only beside it.
    let edge = |edge: &Edge| !matches!(edge.change, Change::Pole(_, Sides::Opposite | Sides::Alike));
    let analytic = |op: Op| row(op).edges.iter().filter(|e| edge(e)).all(|e| e.place == Place::Infinity);
    graph.reachable([p.left, p.right]).into_iter().all(|e| match *graph.node(e) {
        Node::Constant(_) | Node::Pi | Node::Leaf(_) => true,
        Node::Unary(op, _) | Node::Binary(op, ..) => op != Op::Restrict && analytic(op),
    })
}

/// Whether the field that leads depends on all coordinates of its equation. One that does not satisfies another one: its
/// derivative by that coordinate is 0.
pub(super) fn depends_on_all(graph: &Graph, p: &Led) -> bool {
    let leaves = graph.leaves([p.left, p.right]);
    let depends = |l: &Leaf, at: usize| graph.coordinate(*l) == Some(at) || graph.depends(l.symbol, at);
    (0..graph.coordinates().count())
        .all(|at| graph.depends(p.leader.symbol, at) || !leaves.iter().any(|l| depends(l, at)))
}

/// Whether a derivative is one of a leader, or the leader itself: by what, beyond it.
fn beyond(leader: Leaf, leaf: Leaf) -> Option<Partials> {
    let same = (leaf.symbol, leaf.component) == (leader.symbol, leader.component);
    if same { leaf.partials.beyond(leader.partials) } else { None }
}

/// Whether each leads with another field, and no equation names a derivative of another's leader.
fn are_apart(graph: &Graph, led: &[Led]) -> bool {
    led.iter().enumerate().all(|(at, p)| {
        let named = graph.fields([p.left, p.right]);
        let mut others = led.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, q)| q.leader);
        !others.any(|leader| {
            (leader.symbol, leader.component) == (p.leader.symbol, p.leader.component)
                || named.iter().any(|&l| beyond(leader, l).is_some())
        })
    })
}

fn slope(graph: &mut Graph, p: &Led) -> Result<Expr, Reason> {
    let residual = graph.sub(p.left, p.right);
    graph.slope(residual, p.leader).map_err(|_| Reason::NoDerivative)
}

/// An equation solved for its leader.
#[derive(Clone, Copy, Debug)]
struct Solved {
    led: Led,
    /// What the leader is.
    value: Expr,
    slope: Expr,
}

/// Equations on their way to being passive.
struct Completion<'a> {
    graph: &'a mut Graph,
    constants: &'a Premises,
    time: Option<Leaf>,
    is_zero: Vanishes,
    all: Vec<Solved>,
    /// What derivatives of leaders are, by the equation and what they are beyond its leader.
    images: FastMap<(usize, Partials), Expr>,
    limit: usize,
}

impl Completion<'_> {
    fn of(mut self, led: &[Led]) -> Result<Option<Passive>, Reason> {
        let mut same = true;
        for &p in led {
            let residual = self.graph.sub(p.left, p.right);
            let Some(added) = self.solved(residual)? else { return Ok(None) };
            same &= added.led.leader == p.leader;
            self.all.push(Solved { led: Led { leader: added.led.leader, ..p }, ..added });
        }
        let given = self.all.len();
        let (mut i, mut j) = (0, 0);
        // Every pair, the added ones included.
        while i < self.all.len() {
            if j == i {
                (i, j) = (i + 1, 0);
                continue;
            }
            let Some(difference) = self.pair(i, j)? else { return Ok(None) };
            j += 1;
            if self.vanishes(difference) {
                continue;
            }
            match self.solved(difference)? {
                Some(added) if self.all.len() < given + MOST_ADDED => self.all.push(added),
                _ => return Ok(None),
            }
        }
        let slopes = self.all.iter().map(|s| s.slope).collect();
        let all = self.all.iter().map(|s| s.led).collect();
        let completed = (!same || self.all.len() > given).then_some(all);
        Ok(Some(Passive { slopes, completed }))
    }

    /// Whether an expression is 0 wherever it has a value.
    fn vanishes(&mut self, e: Expr) -> bool {
        if let Some(value) = self.graph.as_constant(e) {
            return value.is_zero();
        }
        (self.is_zero)(self.graph, e, self.constants)
    }

    /// The equation e = 0, solved for its highest derivative; `None` where it names none, or is not linear in it.
    fn solved(&mut self, mut e: Expr) -> Result<Option<Solved>, Reason> {
        loop {
            let fields = self.graph.fields([e]);
            let highest = fields.into_iter().max_by_key(|l| rank(self.graph, self.time, *l));
            let Some(leader) = highest.filter(|l| l.partials.order() <= HIGHEST_ADDED) else { return Ok(None) };
            let zero = self.graph.integer(0);
            let led = Led { left: e, right: zero, leader, everywhere: false };
            let slope = slope(self.graph, &led)?;
            let rest = self.graph.replaced(e, |_, l| (l == leader).then_some(zero));
            // Its terms may cancel.
            if self.vanishes(slope) {
                e = rest;
                continue;
            }
            if self.graph.leaves([slope]).contains(&leader) || !depends_on_all(self.graph, &led) {
                return Ok(None);
            }
            let quotient = self.graph.div(rest, slope);
            let value = self.graph.neg(quotient);
            return Ok((self.graph.len() <= self.limit).then_some(Solved { led, value, slope }));
        }
    }

    /// The difference of what two equations say of the least derivative that is one of both leaders; 0 where there is none.
    /// `None` where it is too large.
    fn pair(&mut self, i: usize, j: usize) -> Result<Option<Expr>, Reason> {
        let (a, b) = (self.all[i].led.leader, self.all[j].led.leader);
        let zero = self.graph.integer(0);
        if (a.symbol, a.component) != (b.symbol, b.component) {
            return Ok(Some(zero));
        }
        let both = least_common(a.partials, b.partials);
        let (Some(over_a), Some(over_b)) =
            (both.and_then(|both| both.beyond(a.partials)), both.and_then(|both| both.beyond(b.partials)))
        else {
            return Ok(None);
        };
        let (left, right) = (self.image(i, over_a)?, self.image(j, over_b)?);
        let difference = self.graph.sub(left, right);
        self.normal(difference)
    }

    /// What a derivative of a leader is.
    fn image(&mut self, at: usize, by: Partials) -> Result<Expr, Reason> {
        let (mut so_far, mut e) = (Partials::NONE, self.all[at].value);
        for step in by.steps() {
            so_far = so_far.raised(step).ok_or(Reason::TooLarge)?;
            e = match self.images.get(&(at, so_far)) {
                Some(&known) => known,
                None => self.graph.derivative_by(e, step).map_err(|_| Reason::NoDerivative)?,
            };
            self.images.insert((at, so_far), e);
        }
        Ok(e)
    }

    /// An expression in which what leads is replaced by what it is, until nothing leads. What replaces it ranks lower, so this
    /// ends. `None` where it is too large.
    fn normal(&mut self, mut e: Expr) -> Result<Option<Expr>, Reason> {
        for _ in 0..MOST_REPLACED {
            let mut images = FastMap::default();
            for leaf in self.graph.fields([e]) {
                let leads = self.all.iter().enumerate().find_map(|(at, s)| Some((at, beyond(s.led.leader, leaf)?)));
                if let Some((at, by)) = leads {
                    images.insert(leaf, self.image(at, by)?);
                }
            }
            if images.is_empty() {
                return Ok(Some(e));
            }
            e = self.graph.replaced(e, |_, leaf| images.get(&leaf).copied());
            if self.graph.len() > self.limit {
                return Ok(None);
            }
        }
        Ok(None)
    }
}

/// The least derivative that is one of both.
pub(super) fn least_common(a: Partials, b: Partials) -> Option<Partials> {
    let missing: Vec<usize> = a
        .orders()
        .iter()
        .zip(b.orders())
        .enumerate()
        .flat_map(|(at, (&a, b))| vec![at; usize::from(b.saturating_sub(a))])
        .collect();
    missing.into_iter().try_fold(a, |p, at| p.raised(at))
}
