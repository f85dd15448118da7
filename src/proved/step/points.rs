//! Values through which a solution of what a step is given passes.
//!
//! **In:** a step, and the leaves that are asked about. **Out:** values of them at a few points. **Guaranteed:** everything given
//! holds at each of the points, and a solution passes through it: they are what a question that no solution answers is refuted
//! by, see [`identity`](proof). **Left out:** where that is not known of any point, there is none.

use super::definitions::Definitions;
use super::{Pairs, Step};
use crate::expr::{Graph, Leaf, Rational};
use crate::number::{Bounded, NoValue};
use claim::program::Values;
use proof::{Identity, Options, Point, identity_test};

/// How often points are drawn: each time there are two.
const DRAWS: u64 = 4;

impl Step<'_> {
    /// The formulas of the step.
    pub fn graph(&mut self) -> &mut Graph {
        &mut self.graph
    }

    /// Values of some leaves, in their order, at points of solutions.
    pub fn points(&mut self, leaves: &[Leaf]) -> Vec<Values> {
        let gathered = self.gather(None);
        // Nobody says that this sum is 1.
        let mut sum = self.graph.integer(0);
        for (number, &leaf) in leaves.iter().enumerate() {
            let factor = Rational::from(3 + 2 * number as i64) / Rational::from(7);
            let (factor, leaf) = (self.graph.constant(factor), self.graph.leaf(leaf));
            let term = self.graph.mul(factor, leaf);
            sum = self.graph.add(sum, term);
        }
        let question: Pairs = vec![(sum, self.graph.integer(1))];
        let premises = self.premises(&gathered, &question, Definitions::Everything);
        if !gathered.complete || !self.in_part.is_empty() {
            return Vec::new();
        }
        let mut out = Vec::new();
        for draw in 0..DRAWS {
            let usual = Options::default();
            let options = Options { seed: usual.seed.wrapping_add(draw), ..usual };
            let Identity::Refuted(found) = identity_test(&mut self.graph, &question, &premises, &options) else {
                break;
            };
            out.push(values(leaves, &found.point));
            out.extend(found.second.map(|(point, ..)| values(leaves, &point)));
        }
        out
    }
}

fn values(leaves: &[Leaf], point: &Point) -> Values {
    let value = |leaf: &Leaf| {
        let (_, found) = point.values.iter().find(|(l, _)| l == leaf).ok_or(NoValue::Indeterminate)?;
        Ok(Bounded { value: found.decimal, error: 8.0 * f64::EPSILON * found.decimal.abs() })
    };
    leaves.iter().map(value).collect()
}
