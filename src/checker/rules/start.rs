//! Start and rates: a function whose rate is 0 is what it is at the start.
//!
//! **Conserved.** *Theorem.* If e has values on T, is differentiable on T, and ė = 0 on T, then e = e(c) for each c in T. *Proof.* The mean value
//! theorem on the interval between t and c. □
//!
//! **Vanishes.** *Theorem.* Let e₁, …, eₙ be differentiable on T, ėᵢ = Σⱼ gᵢⱼ·eⱼ with gᵢⱼ continuous on T, and eᵢ(c) = 0 for all i. Then all eᵢ are 0 on T.
//! *Proof.* On a compact interval with c in it, |gᵢⱼ| ≤ M, so that y = Σeᵢ² has |ẏ| ≤ 2nM·y and y(c) = 0; y·exp(∓2nMt) is monotone, hence
//! y = 0 (Gronwall). □ So a formula that solves a system with its start is the solution: the differences of both vanish.
//!
//! **Conditions.** T is connected, and so the facts are known at all times of T (or in a case that does not move: all times, or none); nothing
//! is left that e, ė, g need at any time: no pole, no edge, no jump is touched. The start is a fact that needs nothing.
//!
//! **Traps.** x/|x| has the rate 0 wherever it has one. The start of atan2(0, x) has no value where x(0) = 0 (S2): then "e(0) = 0" is a fact with a
//! need. Chosen times are not connected.

use super::made;
use crate::context::Says;
use crate::derivative::derivative;
use crate::draft::{Draft, Made};
use crate::needs::{Needs, continuous, frozen, needs, smooth};
use crate::polynomial;
use crate::step::FactId;
use crate::term::{Sense, Term};
use crate::when::{Instant, When};
use expr::Expr;

/// A fact known at all times of T, or none, that needs nothing.
fn free_on_all(draft: &Draft, id: FactId, when: &When) -> Result<Says, String> {
    let fact = draft.equation(id).and_then(|_| draft.known_at(id, when))?;
    if fact.needs.is_empty() { Ok(fact.says) } else { Err(format!("fact {} needs something", id.0)) }
}

/// Whether two equations are about the same difference, as rational functions: where all their sides have values, they say the same.
fn say_same(draft: &mut Draft, a: Says, b: Says) -> bool {
    let (x, y) = (draft.context.difference(a), draft.context.difference(b));
    let (minus, plus) = (draft.context.graph.sub(x, y), draft.context.graph.add(x, y));
    a.is(b) || [minus, plus].into_iter().any(|e| polynomial::vanishes(&draft.context.graph, e) == Some(true))
}

/// e = e(c).
pub(super) fn conserved(
    draft: &mut Draft,
    of: &Term,
    at: Instant,
    rate: FactId,
    because: &[FactId],
) -> Result<Made, String> {
    draft.context.is_of_times()?;
    let e = draft.context.read(of)?;
    let when = draft.common(&[&[rate], because].concat())?;
    if !draft.is_whole(&when) {
        return Err("the rate is not known at all times".to_owned());
    }
    let zero = draft.context.graph.integer(0);
    let d = derivative(&mut draft.context, e)?;
    let vanishes = Says { left: d, sense: Sense::Equal, right: zero };
    // A derivative that is written as 0 needs no fact but those that show that the function is smooth.
    let said = free_on_all(draft, rate, &when)?;
    if d != zero && !say_same(draft, said, vanishes) {
        return Err(format!("the fact does not say `{}`", draft.context.latex(vanishes)));
    }
    let mut asked = smooth(&mut draft.context, e);
    asked.extend(needs(&mut draft.context, d));
    draft.all_shown(asked, because, &when)?;
    let c = draft.context.instant(at)?;
    let start = frozen(&mut draft.context, e, c);
    let open = needs(&mut draft.context, c);
    let says = Says { left: e, sense: Sense::Equal, right: start };
    Ok(made("start and rates", [&[rate], because].concat(), says, when, open))
}

/// A linear system that some functions satisfy.
pub(super) struct Linear<'a> {
    pub(super) of: &'a [Term],
    pub(super) matrix: &'a [Vec<Term>],
    pub(super) at: Instant,
    pub(super) rates: &'a [FactId],
    pub(super) starts: &'a [FactId],
    pub(super) because: &'a [FactId],
}

/// e₁ = 0.
pub(super) fn vanishes(draft: &mut Draft, linear: &Linear) -> Result<Made, String> {
    draft.context.is_of_times()?;
    let n = linear.of.len();
    let square = linear.matrix.len() == n && linear.matrix.iter().all(|row| row.len() == n);
    if n == 0 || !square || linear.rates.len() != n || linear.starts.len() != n {
        return Err("the system is not square".to_owned());
    }
    let from = [linear.rates, linear.starts, linear.because].concat();
    let when = draft.common(&from)?;
    if !draft.is_whole(&when) {
        return Err("the rates are not known at all times".to_owned());
    }
    let (zero, c) = (draft.context.graph.integer(0), draft.context.instant(linear.at)?);
    let functions: Vec<Expr> = linear.of.iter().map(|e| draft.context.read(e)).collect::<Result<_, _>>()?;
    let mut asked: Needs = needs(&mut draft.context, c);
    for (i, &e) in functions.iter().enumerate() {
        let d = derivative(&mut draft.context, e)?;
        let mut sum = zero;
        for (g, &other) in linear.matrix[i].iter().zip(&functions) {
            let g = draft.context.read(g)?;
            asked.extend(continuous(&mut draft.context, g, &Needs::new()));
            let term = draft.context.graph.mul(g, other);
            sum = draft.context.graph.add(sum, term);
        }
        asked.extend(smooth(&mut draft.context, e));
        asked.extend(needs(&mut draft.context, d));
        let rate = Says { left: d, sense: Sense::Equal, right: sum };
        let start = Says { left: frozen(&mut draft.context, e, c), sense: Sense::Equal, right: zero };
        for (id, wanted) in [(linear.rates[i], rate), (linear.starts[i], start)] {
            let said = free_on_all(draft, id, &when)?;
            if !say_same(draft, said, wanted) {
                return Err(format!("fact {} does not say `{}`", id.0, draft.context.latex(wanted)));
            }
        }
    }
    draft.all_shown(asked, linear.because, &when)?;
    let says = Says { left: functions[0], sense: Sense::Equal, right: zero };
    Ok(made("start and rates", from, says, when, Needs::new()))
}
