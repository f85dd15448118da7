//! Cases: what is so in each case is so.
//!
//! **At times.** *Theorem.* Let a relation hold at those times of W at which one of several suppositions is true, for each of them. It holds at each
//! time t of W at which one of them is true. *Proof.* Pick the one that is true at t. □ One of them is true: of a product that is 0,
//! one factor is 0; of two numbers, one is less, or they are equal.
//!
//! **On intervals.** *Theorem.* Let W be open in T, let a₁·…·aₙ = 0 on W, all aᵢ continuous, and let G, an equation or ≤ between continuous sides,
//! hold on every interval in W on which some aᵢ ≡ 0. Then G holds on W. *Proof.* Let J ⊆ W be an interval. If a₁ is not 0 somewhere in J,
//! then on an interval J₁ ⊆ J, on which a₂·…·aₙ = 0; and so on: some aᵢ ≡ 0 on an interval in J, where G holds. So G holds on a dense
//! part of W, and at each t ∈ W as a limit of such times, since = and ≤ are closed. □ For two numbers, a = l − r: on an interval in J, l < r, l = r, or l > r throughout.
//!
//! **Conditions on intervals.** W is open. Needs are strict, or `because` shows v ≥ 0 at all times: if they hold at t, they hold beside t,
//! where the theorem is used. Both sides of G, and the aᵢ, are continuous over their definitions, and do not leap.
//!
//! **Traps.** d ≡ 0 for a while may be refuted by motion *on intervals* only; at a time, d = 0 has no rate. A limit says nothing at a
//! single time (S4), nothing of a side that leaps (S1), and nothing of ≠ and <.

use super::{made, needs_of};
use crate::context::{Context, Says};
use crate::draft::{Case, Draft, Made};
use crate::fact::Because;
use crate::needs::{Need, Needs, allowed, around, closure, continuous, edges, needs};
use crate::rules::given::certain_of;
use crate::rules::times::strictness;
use crate::signs::{KnownSigns, Signs, of_sense, signs};
use crate::step::{FactId, Manner, Split};
use crate::term::{Relation, Sense};
use crate::when::{CaseId, When};
use expr::domain::{Change, Sign};

/// Whether needs that hold at a time hold beside it.
pub(crate) fn is_open(context: &mut Context, needs: &Needs) -> bool {
    needs.iter().all(|need| {
        let strict = match need.sign {
            Sign::Positive | Sign::NotZero => true,
            Sign::NotNegative => !context.moves(need.value),
        };
        strict && edges(context, need.value, |change| matches!(change, Change::Jump(_))).is_empty()
    })
}

/// Opens a case.
pub(super) fn suppose(draft: &mut Draft, says: &Relation, manner: Manner) -> Result<(), String> {
    let says = draft.context.relation(says)?;
    let values = needs_of(draft, says);
    let known = certain_of(draft, says);
    let strict = match says.sense {
        Sense::NotEqual | Sense::Less => true,
        Sense::Equal | Sense::LessOrEqual => false,
    };
    let mut guards = Needs::new();
    for side in says.sides() {
        guards.extend(continuous(&mut draft.context, side, &Needs::new()));
    }
    let open = strict && values.is_subset(&known) && is_open(&mut draft.context, &values) && guards.is_subset(&values);
    let constant = says.sides().into_iter().all(|e| !draft.context.moves(e));
    draft.cases.push(Case { says: Some(says), manner, open: open || constant, constant });
    Ok(())
}

/// The supposition, as a fact: it is true, so that its sides have values.
pub(super) fn supposition(draft: &mut Draft, case: CaseId, within: &When) -> Result<Made, String> {
    let says = draft.cases.get(case.0 as usize).and_then(|case| case.says).ok_or("no such case")?;
    if !draft.exists(within) {
        return Err("there are no such times".to_owned());
    }
    let mut open = needs_of(draft, says);
    for need in certain_of(draft, says) {
        open.remove(&need);
    }
    Ok(Made { says, when: within.clone().within(case), needs: open, because: Because::Supposed })
}

/// The suppositions of the branches, and the relation that all of them come to.
struct Branches {
    suppositions: Vec<Says>,
    manner: Manner,
    says: Says,
    needs: Needs,
}

fn branches(draft: &Draft, within: &When, ids: &[FactId]) -> Result<Branches, String> {
    let mut all: Option<Branches> = None;
    for &id in ids {
        let fact = draft.get(id)?;
        let When::In(case, _) = fact.when else { return Err("a branch belongs to no case".to_owned()) };
        let case_times = within.clone().within(case);
        let fact = draft.known_at(id, &case_times)?;
        let Case { says: Some(supposed), manner, .. } = draft.cases[case.0 as usize] else {
            return Err("a branch belongs to the case of the claim".to_owned());
        };
        let found = all.get_or_insert_with(|| Branches {
            suppositions: Vec::new(),
            manner,
            says: fact.says,
            needs: Needs::new(),
        });
        if found.manner != manner || !found.says.is(fact.says) {
            return Err("the branches differ".to_owned());
        }
        found.suppositions.push(supposed);
        found.needs.extend(fact.needs);
    }
    all.ok_or_else(|| "no branch".to_owned())
}

/// Closes cases.
pub(super) fn close(
    draft: &mut Draft,
    within: &When,
    split: &Split,
    ids: &[FactId],
    because: &[FactId],
) -> Result<Made, String> {
    if !draft.exists(within) {
        return Err("there are no such times".to_owned());
    }
    let Branches { suppositions, manner, says, needs: mut open } = branches(draft, within, ids)?;
    let mut from = [ids, because].concat();
    let mut compared = Vec::new();
    match split {
        Split::Product(id) => {
            let fact = draft.equation(*id).and_then(|_| draft.known_at(*id, within))?;
            from.push(*id);
            let zero = draft.context.graph.integer(0);
            let product = match fact.says.sides() {
                [product, z] | [z, product] if z == zero => product,
                _ => return Err("the product is not 0".to_owned()),
            };
            for factor in draft.context.factors(product) {
                let sign = signs(&draft.context, factor, &KnownSigns::new());
                if sign.within(allowed(Sign::NotZero)) {
                    continue;
                }
                let vanishes = Says { left: factor, sense: Sense::Equal, right: zero };
                if !suppositions.iter().any(|s| s.is(vanishes)) {
                    return Err(format!("no branch for `{}`", draft.context.latex(vanishes)));
                }
                compared.push(factor);
            }
            open.extend(fact.needs);
        }
        Split::Order(left, right) => {
            let (l, r) = (draft.context.read(left)?, draft.context.read(right)?);
            let mut covered = Signs::NONE;
            for s in suppositions {
                covered = match (s.left, s.right) {
                    pair if pair == (l, r) => covered.or(of_sense(s.sense)),
                    pair if pair == (r, l) => covered.or(of_sense(s.sense).opposite()),
                    _ => return Err("a branch supposes something else".to_owned()),
                };
            }
            if !Signs::ALL.within(covered) {
                return Err("an order is left out".to_owned());
            }
            compared.extend([l, r]);
        }
    }
    for &e in &compared {
        open.extend(needs(&mut draft.context, e));
    }
    if manner == Manner::OnIntervals {
        open = in_the_limit(draft, within, says, open, &compared, because)?;
    }
    Ok(made("case", from, says, within.clone(), open))
}

/// What is needed for the theorem on intervals.
fn in_the_limit(
    draft: &mut Draft,
    within: &When,
    says: Says,
    mut open: Needs,
    compared: &[expr::Expr],
    because: &[FactId],
) -> Result<Needs, String> {
    if !draft.is_open(within) {
        return Err("cases on intervals are of an open set of times".to_owned());
    }
    match says.sense {
        Sense::Equal | Sense::LessOrEqual => {}
        Sense::NotEqual | Sense::Less => return Err("the limit of a strict relation need not be strict".to_owned()),
    }
    open.extend(needs_of(draft, says));
    let mut all = closure(&mut draft.context, &open);
    for e in compared {
        all.extend(needs(&mut draft.context, *e));
    }
    let everywhere: Needs = strictness(draft, all, because)?;
    open = around(&mut draft.context, &open, &everywhere);
    for e in says.sides().iter().chain(compared) {
        open.extend(continuous(&mut draft.context, *e, &everywhere));
    }
    open.retain(|need: &Need| !everywhere.contains(need));
    Ok(open)
}
