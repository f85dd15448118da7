//! Signs and order: relations by the rules of signs.
//!
//! **Sign.** *Theorem.* If the rules of signs, applied to l − r from the signs that facts say, leave only signs that the relation l ρ r allows, it is true at t; if the
//! facts contradict each other there, nothing is true at t, and the result is. *Proof.* Induction on the expression: the sign of a sum, product, quotient, square, root, exponential of numbers
//! of known signs; the sign that a fact says is that of the value at t. □
//!
//! **Summand.** *Theorem.* If a sum of terms that are not negative is 0, each term is. □ **Injective.** *Theorem.* If f(a) = f(b), a = b, for an injective f: exp, ln, √, arcsin, arccos, arctan, sinh, tanh, odd powers,
//! and even powers and cosh of arguments that are not negative. *Proof.* Each is strictly monotone on its domain, an interval (odd negative powers are so on either side of 0, and have the sign of the argument). □
//!
//! **Conditions.** Both sides of the result have values: their needs. *Traps.* A sign that is known at one time is not known beside it; a² = b² leaves
//! two cases; sin and tan are not injective.

use super::{made, needs_of};
use crate::context::Says;
use crate::draft::{Draft, Made};
use crate::needs::{Need, needs};
use crate::signs::{Signs, of_sense, signs};
use crate::step::FactId;
use crate::term::{Relation, Sense, Term};
use expr::domain::Sign;
use expr::{Expr, Node, Op};

pub(super) fn sign(draft: &mut Draft, says: &Relation, from: &[FactId]) -> Result<Made, String> {
    let says = draft.context.relation(says)?;
    let when = draft.common(from)?;
    let (known, mut open) = draft.known_signs(from, &when)?;
    let mut contradictory = false;
    for id in from {
        let fact = draft.get(*id)?;
        let difference = draft.context.difference(fact.says);
        let possible = signs(&draft.context, difference, &known).and(of_sense(fact.says.sense));
        contradictory |= possible == Signs::NONE;
    }
    if contradictory {
        return Ok(made("contradiction", from.to_vec(), says, when, open));
    }
    let difference = draft.context.difference(says);
    if !signs(&draft.context, difference, &known).within(of_sense(says.sense)) {
        return Err(format!("the signs do not show `{}`", draft.context.latex(says)));
    }
    open.extend(needs_of(draft, says));
    Ok(made("sign", from.to_vec(), says, when, open))
}

/// The terms of a sum.
fn terms(draft: &Draft, e: Expr) -> Vec<Expr> {
    let (mut open, mut out) = (vec![e], Vec::new());
    while let Some(e) = open.pop() {
        match *draft.context.graph.node(e) {
            Node::Binary(Op::Add, a, b) => open.extend([a, b]),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => out.push(e),
        }
    }
    out
}

pub(super) fn summand(draft: &mut Draft, sum: FactId, term: &Term, from: &[FactId]) -> Result<Made, String> {
    let term = draft.context.read(term)?;
    let all = [&[sum], from].concat();
    let when = draft.common(&all)?;
    let fact = draft.equation(sum)?;
    let zero = draft.context.graph.integer(0);
    if fact.says.right != zero {
        return Err("the sum is not written as one that is 0".to_owned());
    }
    let (known, mut open) = draft.known_signs(from, &when)?;
    let terms = terms(draft, fact.says.left);
    let not_negative = Signs::POSITIVE.or(Signs::ZERO);
    if !terms.contains(&term) || !terms.iter().all(|t| signs(&draft.context, *t, &known).within(not_negative)) {
        return Err("a term may be negative, or there is no such term".to_owned());
    }
    open.extend(fact.needs);
    open.extend(needs(&mut draft.context, term));
    let says = Says { left: term, sense: Sense::Equal, right: zero };
    Ok(made("summand", all, says, when, open))
}

pub(super) fn injective(draft: &mut Draft, id: FactId, from: &[FactId]) -> Result<Made, String> {
    let fact = draft.equation(id)?;
    let all = [&[id], from].concat();
    let when = draft.common(&all)?;
    let node = |e: Expr| draft.context.graph.node(e).clone();
    let (op, a, b) = match (node(fact.says.left), node(fact.says.right)) {
        (Node::Unary(f, a), Node::Unary(g, b)) if f == g => (f, a, b),
        _ => return Err("these are not values of one operation".to_owned()),
    };
    let halves = match op {
        Op::Exp | Op::Ln | Op::Sqrt | Op::Arcsin | Op::Arccos | Op::Arctan | Op::Sinh | Op::Tanh | Op::Neg => false,
        Op::Powi(0) => return Err("the power is constant".to_owned()),
        Op::Powi(n) => n % 2 == 0,
        Op::Cosh | Op::Abs => true,
        Op::Sin | Op::Cos | Op::Tan | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow | Op::Arctan2 | Op::Agm => {
            return Err("the operation is not injective".to_owned());
        }
        Op::DirectionCosine | Op::Restrict => return Err("the operation is not injective".to_owned()),
    };
    let mut open = needs(&mut draft.context, a);
    open.extend(needs(&mut draft.context, b));
    open.extend(fact.needs);
    if halves {
        open.extend([a, b].map(|value| Need { value, sign: Sign::NotNegative }));
    }
    let open = draft.undischarged(open, from, &when)?;
    let says = Says { left: a, sense: Sense::Equal, right: b };
    Ok(made("injective", all, says, when, open))
}
