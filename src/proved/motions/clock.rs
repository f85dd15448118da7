//! Along what a motion is one: the time, or the one coordinate on which fields depend.
//!
//! **In:** what formulas name. **Out:** the same leaves, where a place of a field is a time and its derivatives are rates. **Guaranteed:** a
//! field counts as moving where it depends on that coordinate, and on no other.

use crate::derivation::Derivation;
use crate::expr::{Graph, Leaf, Partials};
use crate::latex::{Role, Scope};

/// What plays the time for a claim that names these leaves, if anything does; `None` where fields depend on several coordinates.
pub(super) fn clock(derivation: &Derivation, scope: &Scope, named: &[Leaf]) -> Option<Option<Leaf>> {
    let graph = &derivation.graph;
    let mut fields = named.iter().filter(|l| graph.is_field(l.symbol));
    let Some(first) = fields.next() else { return Some(scope.time()) };
    let on =
        |l: &Leaf| (0..graph.coordinates().count()).filter(|&c| graph.depends(graph.field_of(l.symbol), c)).collect();
    let all: Vec<usize> = on(first);
    let [only] = all.as_slice() else { return None };
    let states = named.iter().any(|l| scope.moves(l));
    (!states && fields.all(|l| on(l) == all)).then(|| graph.coordinates().nth(*only))
}

/// A leaf as one of a motion: f′(0) is a rate at a time.
pub(super) fn read(graph: &Graph, leaf: Leaf) -> Leaf {
    if !graph.is_field(leaf.symbol) || leaf.rate > 0 || leaf.instant.is_some() {
        return leaf;
    }
    let Ok(rate) = u8::try_from(leaf.partials.order()) else { return leaf };
    let of_field = Leaf { symbol: graph.field_of(leaf.symbol), rate, partials: Partials::NONE, ..leaf };
    match graph.place(leaf.symbol).map(|place| place.at.as_slice()) {
        None => of_field,
        Some(&[(_, there)]) => Leaf { instant: Some(there), ..of_field },
        Some(_) => leaf,
    }
}

/// Whether a component has a course: it is a state, or a field that depends on what plays the time alone.
pub(super) fn has_course(graph: &Graph, scope: &Scope, clock: Option<Leaf>, leaf: Leaf) -> bool {
    match clock.and_then(|clock| graph.coordinate(clock)) {
        Some(along) if graph.is_field(leaf.symbol) => {
            graph.place(leaf.symbol).is_none()
                && (0..graph.coordinates().count()).all(|c| graph.depends(leaf.symbol, c) == (c == along))
        }
        _ => scope.role(leaf.symbol) == Some(Role::State) && !graph.is_field(leaf.symbol),
    }
}
