//! Two sides at random points: a look that costs little, before a proof is looked for, and where there is none.
//!
//! **In:** pairs of expressions that should be equal. **Out:** whether they are, to ten digits, wherever both have a value.

use expr::tape::Tape;
use expr::{Expr, Graph};
use number::Draws;

/// Relative difference of two values that are called equal.
const SAME: f64 = 1e-10;

/// How many of the points gave both sides of all pairs a value, and whether they agreed at all of these.
pub fn agreement(graph: &Graph, equations: &[(Expr, Expr)], points: usize) -> Option<(usize, bool)> {
    let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    let leaves = graph.leaves_within(roots.iter().copied());
    let tape = Tape::compile(graph, &leaves, &roots).ok()?;
    let mut slots = tape.slots::<f64>(&());
    // The points of every question are the same: the same paper gives the same words.
    let mut draws = Draws::new(0x5EED);
    let mut valid = 0;
    for point in 0..points {
        let value = |draws: &mut Draws| {
            let size = 0.4 + 2.0 * draws.below(1 << 30) as f64 / f64::from(1u32 << 30);
            // Every other point is all positive, as most quantities are.
            if point % 2 == 1 && draws.below(2) == 1 { -size } else { size }
        };
        let inputs: Vec<Result<f64, number::NoValue>> = leaves.iter().map(|_| Ok(value(&mut draws))).collect();
        let outputs = tape.evaluate(&(), &inputs, &mut slots);
        let values: Option<Vec<f64>> = outputs.into_iter().map(|v| v.ok().filter(|v| v.is_finite())).collect();
        let Some(values) = values else { continue };
        valid += 1;
        let agree = values.chunks(2).all(|p| (p[0] - p[1]).abs() <= SAME * (1.0 + p[0].abs().max(p[1].abs())));
        if !agree {
            return Some((valid, false));
        }
    }
    Some((valid, true))
}
