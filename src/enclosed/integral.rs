//! First integrals that a derivation file names, and that are ones.
//!
//! **In:** the claims of a file, and a system. **Out:** expressions in its states and parameters whose derivative along the
//! field vanishes identically. Claimed first integrals and both sides of equations are candidates; nothing else is known of
//! them. **Guaranteed:** L_f F = 0 for all values of states and parameters is *proved*, by the identity test with its stated
//! probability of error (at most 2⁻¹⁰⁰). What holds on some motions only, or because of other equations, is none.

use super::request::Request;
use crate::derivation::Form;
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::VectorField;
use crate::latex::{RelationKind, Role};
use crate::number::{Draws, Finite, FiniteField};
use claim::comparison::traced;
use proof::{Condition, Identity, Options, Premises, identity_test};

/// Start of the generator of primes and points.
const SEED: u64 = 0x1_17E6_0A15;
/// Most candidates that are looked at.
const MOST: usize = 600;

/// The first integrals of every system of a derivation, none of which depends on those before it; in the order of the file.
pub(super) fn of_systems(request: &Request, graph: &mut Graph) -> Vec<Vec<Expr>> {
    let all = candidates(request, graph);
    request.fields.all().iter().map(|field| of_system(request, graph, field, &all)).collect()
}

/// What could be constant: differences of the sides of equations, and claimed first integrals, in states and parameters.
fn candidates(request: &Request, graph: &mut Graph) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    for claim in &request.derivation.claims {
        let mut of_claim = Vec::new();
        let assumed = claim.assuming.iter().map(|w| &w.value);
        let claimed = claim.forms.iter().filter_map(|form| match form {
            Form::Always(w) => Some(&w.value),
            _ => None,
        });
        for relation in assumed.chain(claimed).flat_map(|s| &s.relations) {
            if relation.kind != RelationKind::Equal || relation.limit.is_some() || relation.has_branches {
                continue;
            }
            let sides = relation.left.components.iter().zip(&relation.right.components);
            of_claim.extend(sides.map(|(&l, &r)| graph.sub(l, r)));
        }
        for form in &claim.forms {
            if let Form::FirstIntegral(w) = form {
                of_claim.extend(&w.value.components);
            }
        }
        for e in of_claim {
            let e = traced(graph, &claim.scope, e);
            if !found.contains(&e) && found.len() < MOST {
                found.push(e);
            }
        }
    }
    found
}

fn of_system(request: &Request, graph: &mut Graph, field: &VectorField, candidates: &[Expr]) -> Vec<Expr> {
    let states = field.states();
    let scope = &request.derivation.scope;
    let known = |l: &Leaf| {
        let fixed = l.rate == 0 && l.instant.is_none();
        fixed && (states.contains(l) || scope.role(l.symbol) == Some(Role::Parameter))
    };
    let (mut kept, mut roots) = (Vec::new(), Vec::new());
    for &e in candidates {
        let leaves = graph.leaves([e]);
        if !leaves.iter().all(known) || !leaves.iter().any(|l| states.contains(l)) {
            continue;
        }
        let Ok(rate) = graph.directional_derivative(e, |_, l| field.rate(l)) else { continue };
        let slopes: Result<Vec<Expr>, _> = states.iter().map(|&s| graph.partial_derivative(e, s)).collect();
        if let Ok(slopes) = slopes {
            kept.push((e, rate));
            roots.extend(slopes);
            roots.push(rate);
        }
    }
    // At one point of a finite field nearly all that do not vanish are seen not to; and which depend on others.
    let leaves = graph.leaves(roots.iter().copied());
    let mut draws = Draws::new(SEED);
    let finite = FiniteField::draw(&mut draws);
    let point: Vec<_> = leaves.iter().map(|_| Ok(finite.draw_element(&mut draws))).collect();
    let Ok(tape) = Tape::compile(graph, &leaves, &roots) else { return Vec::new() };
    let mut slots = tape.slots::<Finite>(&finite);
    let values = tape.evaluate(&finite, &point, &mut slots);
    let (mut rows, mut found): (Vec<Vec<Finite>>, Vec<Expr>) = (Vec::new(), Vec::new());
    for ((e, rate), values) in kept.into_iter().zip(values.chunks(states.len() + 1)) {
        let Ok(values) = values.iter().copied().collect::<Result<Vec<Finite>, _>>() else { continue };
        let Some((&moves, slopes)) = values.split_last() else { continue };
        let Some(row) = moves.is_zero().then_some(slopes).and_then(|s| reduced(&finite, &rows, s)) else {
            continue;
        };
        let zero = graph.integer(0);
        let asked = identity_test(graph, &[(rate, zero)], &Premises::default(), &Options::default());
        // A quotient by something that moves may jump where that vanishes.
        let fixed = |c: &Condition| match c {
            Condition::Denominator(e) => !graph.leaves([*e]).iter().any(|l| states.contains(l)),
            _ => false,
        };
        if matches!(asked, Identity::Proved(proof) if proof.conditions.iter().all(fixed)) {
            rows.push(row);
            found.push(e);
        }
    }
    found
}

/// What is left of a row when those before it are taken away, scaled so that its first entry is 1; `None` for nothing.
fn reduced(field: &FiniteField, rows: &[Vec<Finite>], row: &[Finite]) -> Option<Vec<Finite>> {
    let mut left = row.to_vec();
    for known in rows {
        let Some(pivot) = known.iter().position(|x| !x.is_zero()) else { continue };
        let factor = left[pivot];
        for (x, &k) in left.iter_mut().zip(known) {
            *x = field.difference(*x, field.product(factor, k));
        }
    }
    let first = left.iter().position(|x| !x.is_zero())?;
    let inverse = field.inverse(left[first])?;
    left.iter_mut().for_each(|x| *x = field.product(*x, inverse));
    Some(left)
}
