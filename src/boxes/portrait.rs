//! Pictures of fields over two ranges: what they are there, and by how much an equation fails.
//!
//! **In:** a claim whose fields have formulas, and the box on which it is tried. **Out:** values at the middles of the squares of a
//! board over the first two ranges that vary, the others being in the middle of theirs. **Guaranteed:** they are numbers to look
//! at, and decide nothing.

use super::question::Insertion;
use super::signs::Variable;
use crate::derivation::{Claim, Form, Ranged};
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::region::{ARROWS, Drawn, Portrait, SQUARES};
use crate::latex::{RelationKind, Role};
use crate::number::Bounded;

/// More is not drawn of one claim.
const MOST: usize = 4;

/// The pictures of the fields of a claim, and of the equations that it says, unless they are identities.
pub(super) fn portraits(
    graph: &mut Graph,
    (claim, ranges, identical): (&Claim, &[Ranged], bool),
    put: &Insertion,
    variables: &[Variable],
) -> Vec<Portrait> {
    let [across, up, ..] = variables else { return Vec::new() };
    if [across, up].iter().any(|v| graph.coordinate(v.leaf).is_none()) {
        return Vec::new();
    }
    let mut out = Vec::new();
    let mut fields: Vec<_> = ranges.iter().map(|r| r.leaf.symbol).filter(|s| graph.is_field(*s)).collect();
    fields.dedup();
    for symbol in fields {
        let leaves = (0..graph.component_count(symbol)).map(|c| Leaf::now(symbol, c as u16));
        let mut components = Vec::new();
        for leaf in leaves.collect::<Vec<_>>() {
            let e = graph.leaf(leaf);
            components.push(put.put(graph, e, &[]));
        }
        let name = graph.name(symbol).to_owned();
        let complex = graph.shape(symbol).is_complex();
        match components[..] {
            [e] => out.extend(shades(graph, (name, false), e, variables)),
            [re, im] if complex => {
                let (a, b) = (graph.powi(re, 2), graph.powi(im, 2));
                let square = graph.add(a, b);
                out.extend(shades(graph, (format!(r"\left|{name}\right|^2"), false), square, variables));
            }
            _ if !complex && graph.shape(symbol).rank() == 1 => {
                // The components are those along the coordinates of space, in their order.
                let space: Vec<Leaf> =
                    graph.coordinates().filter(|l| claim.scope.role(l.symbol) == Some(Role::Coordinate)).collect();
                let along =
                    |v: &Variable| space.iter().position(|l| *l == v.leaf).and_then(|i| components.get(i)).copied();
                if let (Some(a), Some(b), true) = (along(across), along(up), space.len() == components.len()) {
                    out.extend(arrows(graph, name, (a, b), variables));
                }
            }
            _ => {}
        }
    }
    let said = claim.forms.iter().filter_map(|form| match form {
        Form::Always(w) if !identical => w.value.relations.first().map(|r| (&w.text, r)),
        _ => None,
    });
    for (text, relation) in said {
        let sides = (relation.left.components.as_slice(), relation.right.components.as_slice());
        if let ([left], [right], RelationKind::Equal, false) = (sides.0, sides.1, relation.kind, relation.has_branches)
        {
            let difference = graph.sub(*left, *right);
            let difference = put.put(graph, difference, &[]);
            out.extend(shades(graph, (text.clone(), true), difference, variables));
        }
    }
    out.truncate(MOST);
    out
}

/// Values at the middles of the squares of a board.
fn sampled(graph: &Graph, of: &[Expr], squares: usize, variables: &[Variable]) -> Option<Vec<Vec<Option<f64>>>> {
    let leaves: Vec<Leaf> = variables.iter().map(|v| v.leaf).collect();
    let tape = Tape::compile(graph, &leaves, of).ok()?;
    let mut slots = tape.slots::<Bounded>(&());
    let mut out = Vec::with_capacity(squares * squares);
    for square in 0..squares * squares {
        let (column, row) = (square % squares, square / squares);
        let inputs = variables.iter().enumerate().map(|(i, v)| {
            let share = match i {
                0 => (column as f64 + 0.5) / squares as f64,
                1 => (row as f64 + 0.5) / squares as f64,
                _ => 0.5,
            };
            Ok(Bounded::exact(v.shown.0 + share * (v.shown.1 - v.shown.0)))
        });
        let inputs: Vec<_> = inputs.collect();
        let values = tape.evaluate(&(), &inputs, &mut slots);
        // What is all error shows nothing.
        let told = |v: Bounded| Some(v.value).filter(|x| x.is_finite() && v.error <= 1e-3 * (1.0 + x.abs()));
        out.push(values.into_iter().map(|v| v.ok().and_then(told)).collect());
    }
    Some(out)
}

fn shades(graph: &Graph, (shows, residual): (String, bool), e: Expr, variables: &[Variable]) -> Option<Portrait> {
    let values: Vec<Option<f64>> =
        sampled(graph, &[e], SQUARES, variables)?.into_iter().map(|v| v.first().copied().flatten()).collect();
    let some = values.iter().any(Option::is_some);
    some.then_some(Portrait { shows, residual, drawn: Drawn::Shades(values) })
}

fn arrows(graph: &Graph, shows: String, (a, b): (Expr, Expr), variables: &[Variable]) -> Option<Portrait> {
    let pair = |v: Vec<Option<f64>>| v.first().copied().flatten().zip(v.get(1).copied().flatten());
    let values: Vec<Option<(f64, f64)>> = sampled(graph, &[a, b], ARROWS, variables)?.into_iter().map(pair).collect();
    let some = values.iter().any(Option::is_some);
    some.then_some(Portrait { shows, residual: false, drawn: Drawn::Arrows(values) })
}
