//! Whether what is given holds at a point for certain, and not only as far as binary64 shows it.
//!
//! **In:** a point at which the sides of all premises agree within rounding. **Out:** whether there is a real point, as near to it as
//! its values are known, at which they are equal. **Guaranteed:** rational numbers are compared as they are; otherwise every value
//! is written as a formula of numbers, in the order in which it was made: √5/2 − 1/2, arctan2(3/5, 4/5) + 2π, ln 2; these are put
//! into the premises as they were given, and that the sides are equal is proved. Other facts hold, and sides differ, by the
//! decimals of these formulas. So a premise that is wrong by 10⁻³⁰, as π = 3.14159265358979323846 is, holds nowhere, whatever the
//! solver took it for.

use super::{
    Bounded, Computed, Expr, FastMap, Found, Frame, Generator, Graph, Leaf, Op, Placed, Rational, Scene, Values,
    decimals, values_at,
};
use crate::outcome::{Identity, Options, Point, PointValue, Premises, Wanted};
use crate::prove::identity_test;
use std::cell::Cell;
use std::f64::consts::TAU;

impl Scene<'_> {
    /// Whether the sides of all premises are equal as rational numbers.
    pub(super) fn is_exact(&self, computed: &mut Computed, exact: &FastMap<Leaf, Rational>) -> bool {
        let sides: Vec<Expr> = self.premises.iter().filter(|(l, r)| l != r).flat_map(|&(l, r)| [l, r]).collect();
        let values = computed.exactly(self.graph, &sides, exact);
        values.as_chunks().0.iter().all(|[l, r]| l.is_some() && l == r)
    }

    /// Whether there is a real point where `found` is one within rounding; `closings`: so many may be looked at as
    /// formulas of numbers.
    pub(in super::super) fn is_certain(&self, frame: &Frame, found: &Found, closings: &Cell<u32>) -> bool {
        if self.leaps(&found.point) {
            return false;
        }
        if found.is_exact && found.differs.is_none_or(|at| found.is_apart || self.differ_exactly(at)) {
            return true;
        }
        let Some(left) = closings.get().checked_sub(1) else { return false };
        closings.set(left);
        self.closes(frame, found).unwrap_or(false)
    }

    /// Whether something has two values at one fixed time: at the point two times are equal, as t₀ and 1 are where t₀ = 1.
    fn leaps(&self, point: &Point) -> bool {
        let then: Vec<(Leaf, Expr, &PointValue)> =
            point.values.iter().filter_map(|(leaf, value)| Some((*leaf, leaf.instant?, value))).collect();
        let times: Vec<Expr> = then.iter().map(|(_, instant, _)| *instant).collect();
        let times = decimals(self.graph, &times, &values_at(point));
        let pairs = (0..then.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        pairs.into_iter().any(|(i, j)| {
            let ((a, at, v), (b, to, w)) = (then[i], then[j]);
            let alike = Leaf { instant: b.instant, ..a } == b && at != to;
            let together = || match (&times[i], &times[j]) {
                (Some(s), Some(t)) => (s.value - t.value).abs() <= s.error + t.error,
                _ => false,
            };
            let differ = match (&v.exact, &w.exact) {
                (Some(v), Some(w)) => v != w,
                _ => v.decimal != w.decimal,
            };
            alike && differ && together()
        })
    }

    /// Whether sides differ where their exact values do: neither a function that was solved for, nor a sign that was chosen, which are
    /// known within rounding, makes these.
    fn differ_exactly(&self, at: usize) -> bool {
        let is_function = |leaf: &Leaf| self.generators.get(*leaf).is_some_and(|g| g.argument().is_some());
        let is_sign = |leaf: &Leaf| self.generators.get(*leaf) == Some(&Generator::Sign);
        let sides = self.lowered.get(at).map(|&(l, r)| self.graph.leaves([l, r]));
        !self.defined.keys().any(is_function) && sides.is_some_and(|leaves| !leaves.iter().any(is_sign))
    }

    fn closes(&self, frame: &Frame, found: &Found) -> Option<bool> {
        let mut closing =
            Closing { scene: self, frame, placed: &found.placed, graph: self.graph.clone(), known: FastMap::default() };
        let forms: Vec<(Leaf, Expr)> =
            frame.given.iter().map(|&leaf| Some((leaf, closing.leaf(leaf)?))).collect::<Option<_>>()?;
        let graph = &mut closing.graph;
        let numbers: Vec<Expr> = forms.iter().map(|&(_, e)| e).collect();
        let mut values = Values::default();
        for (&(leaf, _), value) in forms.iter().zip(decimals(graph, &numbers, &Values::default())) {
            let (value, old) = (value?, found.placed.values.get(&leaf)?);
            if (value.value - old.value).abs() > value.error + old.error {
                return Some(false);
            }
            values.insert(leaf, value);
        }
        let forms: FastMap<Leaf, Expr> = forms.into_iter().collect();
        let mut put = |e: Expr| graph.replaced(e, |_, leaf| forms.get(&leaf).copied());
        let mut equations: Vec<(Expr, Expr)> = self.premises.iter().map(|&(l, r)| (put(l), put(r))).collect();
        equations.retain(|(l, r)| l != r);
        equations.sort_unstable();
        equations.dedup();
        let options = Options { attempts: 0, special_cases: 0, wanted: Wanted::Proof, ..Options::default() };
        let are_equal = equations.is_empty()
            || match identity_test(graph, &equations, &Premises::default(), &options) {
                Identity::Proved(proof) => proof.conditions.iter().all(|c| c.leaves_out().is_none()),
                Identity::Refuted(_) | Identity::Undecided(_) => false,
            };
        let mut computed = Computed::default();
        Some(are_equal && self.has_facts(&mut computed, &values) && self.still_differs(&mut computed, &values, found)?)
    }

    /// Whether the sides that differ do so at these values.
    fn still_differs(&self, computed: &mut Computed, values: &Values, found: &Found) -> Option<bool> {
        let Some(at) = found.differs else { return Some(true) };
        if !found.is_apart && self.differ_exactly(at) {
            return Some(true);
        }
        let &(l, r) = self.claim.get(at)?;
        let &[Some(l), Some(r)] = computed.decimals(self.graph, &[l, r], values).as_slice() else { return None };
        Some((l.value - r.value).abs() > 4.0 * (l.error + r.error))
    }
}

/// The values of a point as formulas of numbers.
struct Closing<'a> {
    scene: &'a Scene<'a>,
    frame: &'a Frame,
    placed: &'a Placed,
    graph: Graph,
    /// Those that were asked for; none while it is made.
    known: FastMap<Leaf, Option<Expr>>,
}

impl Closing<'_> {
    /// The value of a leaf.
    fn leaf(&mut self, leaf: Leaf) -> Option<Expr> {
        if let Some(&known) = self.known.get(&leaf) {
            return known;
        }
        self.known.insert(leaf, None);
        let form = self.made(leaf);
        self.known.insert(leaf, form);
        form
    }

    fn made(&mut self, leaf: Leaf) -> Option<Expr> {
        let scene = self.scene;
        if let Some(r) = self.placed.exact.get(&leaf) {
            return Some(self.graph.constant(r.clone()));
        }
        match scene.generators.get(leaf) {
            Some(&Generator::Cosine(a)) => self.function(Op::Cos, a),
            Some(&Generator::Sine(a)) => self.function(Op::Sin, a),
            Some(&Generator::Exponential(a)) => self.function(Op::Exp, a),
            Some(&Generator::Opaque(e)) => self.formula(e),
            Some(Generator::Sign | Generator::Half | Generator::Free) => None,
            None => match scene.targets.iter().find(|t| t.leaf == leaf) {
                Some(target) => {
                    let argument = scene.generators.list.get(target.generator)?.argument()?;
                    let solved = self.solved(target.generator)?;
                    self.by_argument(leaf, (argument, target.power), solved)
                }
                None if self.placed.circles.contains_key(&leaf) => self.drawn_angle(leaf),
                None => self.formula(*scene.explicit.get(&leaf).or_else(|| scene.defined.get(&leaf))?),
            },
        }
    }

    /// A formula with the values of what it names.
    fn formula(&mut self, e: Expr) -> Option<Expr> {
        let named: Option<FastMap<Leaf, Expr>> =
            self.graph.leaves([e]).into_iter().map(|leaf| Some((leaf, self.leaf(leaf)?))).collect();
        let named = named?;
        Some(self.graph.replaced(e, |_, leaf| named.get(&leaf).copied()))
    }

    fn function(&mut self, op: Op, argument: Expr) -> Option<Expr> {
        let argument = self.formula(argument)?;
        Some(self.graph.unary(op, argument))
    }

    /// An angle whose half-angle tangent was drawn.
    fn drawn_angle(&mut self, leaf: Leaf) -> Option<Expr> {
        let factor = self.frame.angles.iter().find(|(_, l)| *l == leaf)?.0.clone();
        let (c, s) = self.placed.circles.get(&leaf)?.clone();
        let (c, s) = (self.graph.constant(c), self.graph.constant(s));
        let principal = self.graph.binary(Op::Arctan2, s, c);
        let (own, factor) = (self.graph.leaf(leaf), self.graph.constant(factor));
        let argument = self.graph.mul(factor, own);
        self.by_argument(leaf, (argument, 1), (principal, true))
    }

    /// The formula that a generator was solved as.
    fn definition(&mut self, generator: usize) -> Option<Expr> {
        let leaf = self.scene.generators.leaf(generator)?;
        match self.placed.exact.get(&leaf) {
            Some(r) => Some(self.graph.constant(r.clone())),
            None => self.formula(*self.scene.defined.get(&leaf)?),
        }
    }

    /// The principal value of the argument of a function that was solved for, and whether turns may be added to it.
    fn solved(&mut self, generator: usize) -> Option<(Expr, bool)> {
        match self.scene.generators.list.get(generator)? {
            Generator::Cosine(_) => {
                let (c, s) = (self.definition(generator)?, self.definition(generator + 1)?);
                Some((self.graph.binary(Op::Arctan2, s, c), true))
            }
            Generator::Exponential(_) => {
                let e = self.definition(generator)?;
                Some((self.graph.unary(Op::Ln, e), false))
            }
            Generator::Sine(_) | Generator::Opaque(_) => None,
            Generator::Sign | Generator::Half | Generator::Free => None,
        }
    }

    /// The value of a leaf by that of an argument, a multiple of the leaf or of its inverse, with as many turns as its decimal has.
    fn by_argument(
        &mut self,
        leaf: Leaf,
        (argument, power): (Expr, i32),
        (principal, turns): (Expr, bool),
    ) -> Option<Expr> {
        let one = self.graph.integer(1);
        let unit = self.graph.replaced(argument, |_, l| (l == leaf).then_some(one));
        let unit = self.formula(unit)?;
        let mut value = principal;
        if turns {
            let at = decimals(&self.graph, &[unit, principal], &Values::default());
            let &[Some(u), Some(p)] = at.as_slice() else { return None };
            let own: &Bounded = self.placed.values.get(&leaf)?;
            let whole = if power > 0 { own.value * u.value } else { u.value / own.value };
            let count = ((whole - p.value) / TAU).round();
            let count = (count.abs() <= 64.0).then_some(count as i64)?;
            let (number, pi) = (self.graph.integer(2 * count), self.graph.pi());
            let turned = self.graph.mul(number, pi);
            value = self.graph.add(principal, turned);
        }
        let (above, below) = if power > 0 { (value, unit) } else { (unit, value) };
        Some(self.graph.div(above, below))
    }
}
