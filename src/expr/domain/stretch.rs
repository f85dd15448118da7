//! On which stretches of its argument an operation has a sign: one row for each operation of one argument.
//!
//! **In:** an operation. **Out:** its [`Stretch`]es. **Guaranteed:** wherever the argument lies on a stretch and there is a value, the value has the
//! sign, or is 0; it is 0 at ends only. What the sign of the argument says, as that of √, sinh or arctan, is said by stretches, too. Of sine, cosine and tangent, which
//! go on for ever, the stretches about 0 are told.

use super::{Bound, Change, Op, Slope, row};
use crate::{Expr, Graph, Rational};

/// A closed stretch of the argument of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stretch {
    /// Its lower end, if there is one.
    pub from: Option<Bound>,
    /// Its upper end, if there is one.
    pub to: Option<Bound>,
    /// Whether values are positive there; otherwise they are negative.
    pub is_positive: bool,
}

const fn at(whole: i8, quarter_turns: i8) -> Option<Bound> {
    Some(Bound { whole, quarter_turns, attained: true })
}

const fn above(from: Option<Bound>, to: Option<Bound>) -> Stretch {
    Stretch { from, to, is_positive: true }
}

const fn below(from: Option<Bound>, to: Option<Bound>) -> Stretch {
    Stretch { from, to, is_positive: false }
}

const ZERO: Option<Bound> = at(0, 0);
const ONE: Option<Bound> = at(1, 0);
const SINE: [Stretch; 3] = [above(ZERO, at(0, 2)), below(at(0, -2), ZERO), below(at(0, 2), at(0, 4))];
const COSINE: [Stretch; 3] = [above(at(0, -1), at(0, 1)), below(at(0, 1), at(0, 3)), below(at(0, -3), at(0, -1))];
const TANGENT: [Stretch; 2] = [above(ZERO, at(0, 1)), below(at(0, -1), ZERO)];
const LOGARITHM: [Stretch; 2] = [above(ONE, None), below(None, ONE)];
const ODD: [Stretch; 2] = [above(ZERO, None), below(None, ZERO)];

/// The stretches of an operation of one argument on which its values have a sign.
pub fn stretches(op: Op) -> &'static [Stretch] {
    match op {
        Op::Sin => &SINE,
        Op::Cos => &COSINE,
        Op::Tan => &TANGENT,
        Op::Ln => &LOGARITHM,
        Op::Arcsin | Op::Arctan | Op::Sinh | Op::Tanh => &ODD,
        Op::Powi(n) if n % 2 != 0 => &ODD,
        // Their ranges say it, or the sign of the argument.
        Op::Neg | Op::Sqrt | Op::Exp | Op::Arccos | Op::Cosh | Op::Abs | Op::Powi(_) => &[],
        Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Div
        | Op::Pow
        | Op::Arctan2
        | Op::Agm
        | Op::DirectionCosine
        | Op::Restrict => &[],
    }
}

impl Bound {
    /// The bound as an expression: a whole number, a multiple of π, or the sum of both.
    pub fn expression(self, graph: &mut Graph) -> Expr {
        if self.quarter_turns == 0 {
            return graph.integer(self.whole.into());
        }
        let (turns, pi) = (graph.constant(Rational::from(self.quarter_turns) / Rational::from(2)), graph.pi());
        let turned = graph.mul(turns, pi);
        if self.whole == 0 {
            return turned;
        }
        let whole = graph.integer(self.whole.into());
        graph.add(whole, turned)
    }
}

/// Whether an operation of one argument grows with its argument over all that has a value: an interval for each of these.
pub fn rises(op: Op) -> bool {
    let row = row(op);
    let has_pole = row.edges.iter().any(|edge| match edge.change {
        Change::Pole(..) => true,
        Change::Log | Change::Jump(_) | Change::Kink | Change::Steep => false,
    });
    op.arity() == 1 && row.slopes[0] == Slope::Rising && !has_pole
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// Values of the operations inside of all stretches have the sign, in floating numbers; where there is none, nothing is said.
    #[test]
    fn values_have_the_sign_inside_of_stretches() {
        use Op::{Arcsin, Arctan, Cos, Ln, Powi, Sin, Sinh, Tan, Tanh};
        for op in [Sin, Cos, Tan, Ln, Arcsin, Arctan, Sinh, Tanh, Powi(-3), Powi(5)] {
            let rows = stretches(op);
            assert!(rows.len() > 1, "{op:?}");
            let mut told = 0;
            for row in rows {
                let end = |b: Bound| f64::from(b.whole) + FRAC_PI_2 * f64::from(b.quarter_turns);
                let (low, high) = (row.from.map_or(-20.0, end), row.to.map_or(20.0, end));
                for step in 1..400 {
                    let x = low + (high - low) * f64::from(step) / 400.0;
                    let mut value = 0.0;
                    if op.apply(&(), &mut value, &x, &0.0).is_ok() {
                        assert!((value > 0.0) == row.is_positive, "{op:?} at {x}: {value}");
                        told += 1;
                    }
                }
            }
            assert!(told > 10, "{op:?}");
        }
    }
}
