//! Bounds of single leaves among what is given, for the choice of their values.
//!
//! **In:** expressions that are given as positive or not negative. **Out:** for a leaf of which one of them says x > q or x < q with
//! a rational q, values between its bounds. **Guaranteed:** nothing: a value is a proposal, and what is given is evaluated there.

use super::linear::Combinations;
use expr::{Expr, FastMap, Graph, Leaf, Node, Rational};

/// The largest lower and the least upper bound of leaves.
#[derive(Clone, Debug, Default)]
pub(super) struct Bounds(FastMap<Leaf, [Option<Rational>; 2]>);

impl Bounds {
    /// By what is not negative.
    pub(super) fn of(graph: &Graph, not_negative: impl IntoIterator<Item = Expr>) -> Bounds {
        let mut out: FastMap<Leaf, [Option<Rational>; 2]> = FastMap::default();
        for fact in not_negative {
            let mut slope = None;
            let mut constant = Rational::ZERO;
            let mut single = true;
            for (monomial, q) in Combinations::default().of(graph, fact) {
                match monomial.as_slice() {
                    [] => constant = q,
                    &[(base, 1)] if slope.is_none() => match *graph.node(base) {
                        Node::Leaf(leaf) => slope = Some((leaf, q)),
                        Node::Constant(_) | Node::Pi | Node::Unary(..) | Node::Binary(..) => single = false,
                    },
                    _ => single = false,
                }
            }
            let Some((leaf, q)) = slope.filter(|_| single) else { continue };
            let bound = -constant / &q;
            let [low, high] = out.entry(leaf).or_default();
            if q > Rational::ZERO {
                *low = Some(low.take().map_or(bound.clone(), |l| l.max(bound)));
            } else {
                *high = Some(high.take().map_or(bound.clone(), |h| h.min(bound)));
            }
        }
        Bounds(out)
    }

    /// The value itself if it lies between the bounds, else one that does. A bound that is 0 is met by one choice in a few anyway.
    pub(super) fn within(&self, leaf: Leaf, value: Rational) -> Rational {
        let Some([low, high]) = self.0.get(&leaf) else { return value };
        let beyond = |bound: &Option<Rational>, below: bool| {
            bound.as_ref().is_some_and(|b| *b != Rational::ZERO && if below { value <= *b } else { *b <= value })
        };
        if !beyond(low, true) && !beyond(high, false) {
            return value;
        }
        let size = match value == Rational::ZERO {
            true => Rational::ONE,
            false if value < Rational::ZERO => -value,
            false => value,
        };
        match (low, high) {
            // Large ones come near the upper bound: what is only false there is found, too.
            (Some(low), Some(high)) if size > Rational::from(2) => {
                high - (high - low) / (Rational::from(4) * &size * &size)
            }
            (Some(low), Some(high)) => low + (high - low) * &size / (Rational::ONE + &size),
            (Some(low), None) => low + size,
            (None, Some(high)) => high - size,
            (None, None) => size,
        }
    }
}
