//! Zero: an equation that follows from equations by algebra.
//!
//! **Theorem.** Let d·(l − r) = Σ qᵢ·(lᵢ − rᵢ) be an identity of rational functions, in which everything that is no sum, product, quotient or whole power (symbols, their
//! rates and values, π, values of functions) counts as an indeterminate, the same for the same expression. If lᵢ = rᵢ at t, all formulas have values there, and d ≠ 0, then l = r at t.
//! *Proof.* Cleared of denominators, the identity is one of polynomials; it holds for the values at t, no denominator of which is 0; so d·(l − r) = 0. □
//!
//!
//! **Inserted.** With the right side of an equation u = v for its left one in all of the identity, it may be one. *Proof.* Equals for equals do not change the
//! value of any formula in it at t, nor whether it has one: see [`congruence`](super::congruence). □ So an equation that is solved for something is
//! put in as it is, and no cofactors are wanted.
//!
//! **Modulo.** Nor are they for facts by which is divided, as by sin²u + cos²u = 1: what is left after all is put in may be the sum of multiples of such. *Proof.* At t they vanish, and so do their multiples; the value of each formula is that of its numerator by its denominator, and stays so where multiples are taken from either. □
//!
//! **Conditions.** The facts are known at one set of times. Needs: those of l, r, d, qᵢ, and d ≠ 0. The identity is checked by expansion ([`polynomial`](crate::polynomial)), or,
//! where that is too large, by trials ([`trials`](crate::trials)), whose error is added to that of the proof.
//!
//! **Traps.** d need not vanish "for a while" to be dangerous: one time is enough. Different indeterminates may be related (sine and cosine): a
//! relation that is wanted is a fact, by a law; none is guessed.

use super::congruence::identified;
use super::{made, needs_of};
use crate::draft::{Draft, Made};
use crate::needs::{Need, needs};
use crate::polynomial::{self, Rewrite};
use crate::step::FactId;
use crate::term::{Relation, Sense, Term};
use crate::trials::{self, Square};

pub(super) fn zero(
    draft: &mut Draft,
    says: &Relation,
    multiplier: &Term,
    terms: &[(FactId, Term)],
    insert: &[FactId],
    modulo: &[FactId],
) -> Result<Made, String> {
    let says = draft.context.relation(says)?;
    if says.sense != Sense::Equal {
        return Err("algebra shows equations".to_owned());
    }
    let facts: Vec<FactId> =
        terms.iter().map(|(id, _)| *id).chain(insert.iter().copied()).chain(modulo.iter().copied()).collect();
    let when = draft.common(&facts)?;
    let d = draft.context.read(multiplier)?;
    let mut open = needs_of(draft, says);
    open.extend(needs(&mut draft.context, d));
    open.insert(Need::not_zero(d));
    let conclusion = draft.context.difference(says);
    let mut residual = draft.context.graph.mul(d, conclusion);
    for (id, factor) in terms {
        let fact = draft.equation(*id)?;
        let q = draft.context.read(factor)?;
        open.extend(needs(&mut draft.context, q));
        open.extend(fact.needs);
        let difference = draft.context.difference(fact.says);
        let term = draft.context.graph.mul(q, difference);
        residual = draft.context.graph.sub(residual, term);
    }
    for id in insert {
        let fact = draft.equation(*id)?;
        residual = identified(&mut draft.context, residual, fact.says.left, fact.says.right);
        open.extend(fact.needs);
    }
    let (mut rewrites, mut squares) = (Vec::new(), Vec::new());
    for id in modulo {
        let fact = draft.equation(*id)?;
        let difference = draft.context.difference(fact.says);
        let rewrite = Rewrite::of(&draft.context.graph, difference)
            .ok_or_else(|| format!("nothing is divided by fact {}", id.0))?;
        squares.extend(rewrite.square(&mut draft.context.graph).map(|(v, of)| Square { v, of }));
        rewrites.push(rewrite);
        open.extend(fact.needs);
    }
    squares.sort_unstable_by_key(|square| square.v);
    let all_squares = squares.len() == rewrites.len();
    if all_squares && trials::is_refuted(&draft.context.graph, residual, &squares) {
        return Err(format!("no identity: `{}` does not follow", draft.context.latex(says)));
    }
    let (vanishes, products) = polynomial::vanishes_modulo(&draft.context.graph, residual, &rewrites);
    draft.products += products;
    match vanishes {
        Some(true) => {}
        None if all_squares => {
            let log2_error = trials::vanishes(&draft.context, residual, &squares)?;
            draft.log2_error = trials::sum_log2(draft.log2_error, log2_error);
        }
        Some(false) | None => return Err(format!("no identity: `{}` does not follow", draft.context.latex(says))),
    }
    Ok(made("algebra", facts, says, when, open))
}
