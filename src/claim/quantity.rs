//! A quantity by itself, and whether its value is that of one side of a leap.
//!
//! **In:** an expression, and the values of leaves. **Out:** its value. **Guaranteed:** where an angle in it, or a whole part, may lie on
//! either side of its cut, as far as errors tell, there is none: the error of a value near one of them says nothing of the other.

use crate::program::Values;
use expr::tape::Tape;
use expr::{Expr, Graph, Leaf};
use number::{Bounded, NoValue};

/// A quantity, compiled.
pub struct Quantity {
    /// The quantity, then y and x of each cut.
    tape: Tape,
}

impl Quantity {
    /// A quantity with its [`cuts`](crate::comparison::cuts), from the values of leaves; nothing where another is needed.
    pub fn new(graph: &Graph, known: &[Leaf], quantity: Expr, cuts: &[[Expr; 2]]) -> Option<Quantity> {
        let outputs: Vec<Expr> = [quantity].into_iter().chain(cuts.iter().flatten().copied()).collect();
        Tape::compile(graph, known, &outputs).ok().map(|tape| Quantity { tape })
    }

    /// Its value.
    ///
    /// # Errors
    /// Why it has none; [`NoValue::Indeterminate`] where it may be that of one side of a leap.
    pub fn value(&self, values: &Values) -> Result<Bounded, NoValue> {
        self.of(values, true)
    }

    /// The same, of either side of a leap: at single times, which do not matter to an integral.
    ///
    /// # Errors
    /// Why it has none.
    pub fn beside_leaps(&self, values: &Values) -> Result<Bounded, NoValue> {
        self.of(values, false)
    }

    fn of(&self, values: &Values, whole: bool) -> Result<Bounded, NoValue> {
        let found = self.tape.evaluate(&(), values, &mut self.tape.slots(&()));
        let (value, cuts) = found.split_first().ok_or(NoValue::OutOfDomain)?;
        let leaps = |of: &[Result<Bounded, NoValue>]| matches!(of, [Ok(y), Ok(x)] if y.straddles_cut(x));
        if whole && value.is_ok() && cuts.chunks(2).any(leaps) { Err(NoValue::Indeterminate) } else { *value }
    }
}
