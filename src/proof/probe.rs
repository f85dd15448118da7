//! Random evaluation of lowered expressions over GF(p²).

use std::cell::RefCell;
use std::rc::Rc;

use super::generators::{Generator, Generators};
use super::sign::Known;
use super::structure::Structure;
use super::values::Values;
use expr::FastMap;
use expr::{Expr, Graph, Leaf, Node};
use number::{Draws, Finite, FiniteField, NoValue};

/// What random evaluation says of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sight {
    /// 0 at several random points: probably identically zero.
    Zero,
    /// Not 0 at some point: certainly not identically zero.
    Nonzero,
    /// No value at any point tried: division by something identically zero.
    Nowhere,
}

/// Coefficients of a polynomial in one leaf, and those above that vanish at the random points.
pub(super) type InPowers = (Vec<Expr>, Vec<Expr>);

/// One of the points.
#[derive(Clone, Default)]
struct Place {
    leaves: FastMap<Leaf, Finite>,
    values: Values<Finite>,
}

/// A random point of the space of leaves, kept so that all expressions are seen at the same points.
pub(super) struct Probe {
    pub(super) field: FiniteField,
    draws: Draws,
    points: Vec<Place>,
    /// What was seen: the points stay, so it does not change.
    sights: FastMap<Expr, Sight>,
    /// What does not depend on points.
    pub(super) structure: Rc<RefCell<Structure>>,
    /// Equation and unknown → its coefficients, and the leading ones that vanish; `None` where it cannot be solved for.
    pub(super) solvable: FastMap<(Expr, Leaf), Option<Rc<InPowers>>>,
    /// The terms of sums of squares, see the solver.
    pub(super) squares: FastMap<Expr, Option<Vec<Expr>>>,
    /// What the facts of the problem say of signs.
    pub(super) signs: FastMap<Expr, Known>,
}

/// Number of points at which [`Probe::sight`] must see 0.
const POINTS: usize = 3;
/// The same where signs are drawn too: seeing one choice of them only has probability 2⁻⁹ at most.
const POINTS_WITH_SIGNS: usize = 10;
/// Number of points tried.
const TRIES: usize = 16;

impl Probe {
    pub(super) fn new(draws: &mut Draws, structure: Rc<RefCell<Structure>>) -> Probe {
        let field = FiniteField::draw(draws);
        let draws = Draws::new(draws.bits());
        Probe {
            field,
            draws,
            points: vec![Place::default(); TRIES],
            sights: FastMap::default(),
            structure,
            signs: FastMap::default(),
            squares: FastMap::default(),
            solvable: FastMap::default(),
        }
    }

    /// The value of a leaf at a point: on the circle for cosine and sine, ±1 for a sign, random otherwise.
    fn leaf(&mut self, generators: &Generators, point: usize, leaf: Leaf) -> Finite {
        if let Some(&v) = self.points[point].leaves.get(&leaf) {
            return v;
        }
        if let Some((c, s)) = generators.circle(leaf) {
            let (cosine, sine) = on_circle(&self.field, &mut self.draws);
            self.points[point].leaves.insert(c, cosine);
            self.points[point].leaves.insert(s, sine);
            return if leaf == c { cosine } else { sine };
        }
        let v = match generators.get(leaf) {
            Some(Generator::Sign) => self.field.integer(if self.draws.bits() & 1 == 0 { 1 } else { -1 }),
            _ => self.field.draw_element(&mut self.draws),
        };
        self.points[point].leaves.insert(leaf, v);
        v
    }

    /// The value of an expression at one of the points. What it shares with others is computed once.
    fn value(&mut self, graph: &Graph, generators: &Generators, point: usize, e: Expr) -> Result<Finite, NoValue> {
        if let Some(known) = self.points[point].values.of(e) {
            return known;
        }
        let new = self.points[point].values.missing(graph, &[e]);
        // Leaves in the order of the graph: the numbers drawn for them depend on it.
        for &node in &new {
            if let Node::Leaf(leaf) = *graph.node(node) {
                let value = self.leaf(generators, point, leaf);
                self.points[point].values.set(node, Ok(value));
            }
        }
        self.points[point].values.compute(&self.field, graph, &new);
        self.points[point].values.of(e).unwrap_or(Err(NoValue::Unsupported))
    }

    /// Values of the expressions at one of the points.
    pub(super) fn values(
        &mut self,
        graph: &Graph,
        generators: &Generators,
        point: usize,
        exprs: &[Expr],
    ) -> Vec<Result<Finite, NoValue>> {
        let leaves = graph.leaves(exprs.iter().copied());
        for leaf in leaves {
            self.leaf(generators, point, leaf);
        }
        exprs.iter().map(|&e| self.value(graph, generators, point, e)).collect()
    }

    /// Whether an expression has a value ≠ 0 at every point at which the roots in it exist, and at some.
    pub(super) fn never_vanishes(&mut self, graph: &Graph, generators: &Generators, e: Expr) -> bool {
        let mut seen = false;
        for point in 0..TRIES {
            match self.value(graph, generators, point, e) {
                Ok(v) if !v.is_zero() => seen = true,
                Err(NoValue::Indeterminate) => {}
                _ => return false,
            }
        }
        seen
    }

    /// Whether an expression is identically zero, see [`Sight`].
    pub(super) fn sight(&mut self, graph: &Graph, generators: &Generators, e: Expr) -> Sight {
        if let Some(&known) = self.sights.get(&e) {
            return known;
        }
        let seen = self.look(graph, generators, e);
        self.sights.insert(e, seen);
        seen
    }

    fn look(&mut self, graph: &Graph, generators: &Generators, e: Expr) -> Sight {
        if let Node::Constant(_) = graph.node(e) {
            return if graph.is_zero(e) { Sight::Zero } else { Sight::Nonzero };
        }
        let (mut zeros, mut enough) = (0, None);
        for point in 0..TRIES {
            match self.value(graph, generators, point, e) {
                Ok(v) if !v.is_zero() => return Sight::Nonzero,
                Ok(_) => zeros += 1,
                Err(_) => continue,
            }
            let enough = *enough.get_or_insert_with(|| {
                let signed = graph.leaves([e]).iter().any(|&l| generators.get(l) == Some(&Generator::Sign));
                if signed { POINTS_WITH_SIGNS } else { POINTS }
            });
            if zeros == enough {
                return Sight::Zero;
            }
        }
        if zeros > 0 { Sight::Zero } else { Sight::Nowhere }
    }
}

/// ((1 − t²)/(1 + t²), 2t/(1 + t²)) for a random t; 1 + t² ≠ 0 as −1 is no square in GF(p).
fn on_circle(f: &FiniteField, draws: &mut Draws) -> (Finite, Finite) {
    let t = f.draw_element(draws);
    let one = f.integer(1);
    let square = f.product(t, t);
    let inverse = f.inverse(f.sum(one, square)).unwrap_or(one);
    (f.product(f.difference(one, square), inverse), f.product(f.sum(t, t), inverse))
}
