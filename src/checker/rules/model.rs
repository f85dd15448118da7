//! Model: there is a motion on which all that is given is true, and the claim, at some time.
//!
//! **Theorem.** Put functions of time for the symbols that move and numbers for the constants. If (a) every equation that is given becomes an identity of rational functions
//! (with functions as indeterminates); (b) every inequality that is given and no selector becomes one that is strict at the time t₀, or true by the rules of signs at any time;
//! (c) everything that is given, and the functions, has values beside t₀ and is continuous; (d) all fixed times are t₀, or (c) and (b) hold at any time by the rules of signs; (e) the selectors and the claim are
//! true at t₀: then a neighbourhood of t₀ (or all times) is the T of such a motion. *Proof.* What is continuous and strict at t₀ is so beside it; identities hold where both sides have values. □
//!
//! **Conditions.** The functions are formulas of the time alone; they have all rates. *Trap.* A motion that satisfies what is given at t₀ only is none.

use super::given::certain_of;
use super::needs_of;
use crate::context::{Context, Says};
use crate::derivative::derivative;
use crate::draft::Draft;
use crate::needs::{Needs, allowed, around, continuous, is_trivial, replaced};
use crate::polynomial;
use crate::sequent::SymbolKind;
use crate::signs::{KnownSigns, of_sense, signs};
use crate::term::{Sense, Term, rational};
use expr::{Expr, Leaf, Node, Symbol};
use std::collections::BTreeMap;

/// A motion by formulas.
struct Motion {
    /// The formulas, of symbols and components.
    formulas: BTreeMap<(Symbol, u16), Expr>,
    /// The values of the fixed times.
    instants: BTreeMap<Expr, Expr>,
    /// t₀.
    at: Expr,
    /// Whether T is a neighbourhood of t₀; all times otherwise.
    local: bool,
}

impl Motion {
    /// An expression along the motion.
    fn along(&self, context: &mut Context, e: Expr) -> Result<Expr, String> {
        let mut images: BTreeMap<Leaf, Expr> = BTreeMap::new();
        for leaf in context.graph.leaves([e]) {
            if context.kind(leaf) == SymbolKind::Time {
                continue;
            }
            let formula = self.formulas.get(&(leaf.symbol, leaf.component)).copied();
            let mut image = formula.ok_or("a symbol has no formula")?;
            for _ in 0..leaf.rate {
                image = derivative(context, image)?;
            }
            if let Some(c) = leaf.instant {
                let time = *self.instants.get(&c).ok_or("a fixed time has no value")?;
                image = at_time(context, image, time);
            }
            images.insert(leaf, image);
        }
        Ok(replaced(context, e, |_, leaf| images.get(&leaf).copied()))
    }

    fn says_along(&self, context: &mut Context, says: Says) -> Result<Says, String> {
        let (left, right) = (self.along(context, says.left)?, self.along(context, says.right)?);
        Ok(Says { left, sense: says.sense, right })
    }

    /// Whether needs hold on T, as conditions that are strict at t₀, or at any time.
    fn holds_on_t(&self, context: &mut Context, needs: &Needs) -> bool {
        around(context, needs, &Needs::new()).into_iter().all(|need| {
            let value = at_time(context, need.value, self.at);
            let here = signs(context, value, &KnownSigns::new()).within(allowed(need.sign));
            is_trivial(context, need) || self.local && here
        })
    }
}

/// A formula of the time, at a time.
fn at_time(context: &mut Context, e: Expr, time: Expr) -> Expr {
    replaced(context, e, |context, leaf| (context.kind(leaf) == SymbolKind::Time).then_some(time))
}

fn is_true(context: &mut Context, says: Says) -> bool {
    let difference = context.difference(says);
    let by_signs = signs(context, difference, &KnownSigns::new()).within(of_sense(says.sense));
    let is_zero = || polynomial::vanishes(&context.graph, difference) == Some(true);
    by_signs || matches!(says.sense, Sense::Equal | Sense::LessOrEqual) && is_zero()
}

fn read(draft: &mut Draft, values: &[(String, u16, Term)], at: &str) -> Result<Motion, String> {
    draft.context.is_of_times()?;
    let context = &mut draft.context;
    let at = context.graph.constant(rational(at)?);
    let mut motion = Motion { formulas: BTreeMap::new(), instants: BTreeMap::new(), at, local: true };
    for (name, component, term) in values {
        let (symbol, e) = (context.symbol(name)?, context.read(term)?);
        let constant = matches!(context.kind(Leaf::now(symbol, 0)), SymbolKind::Constant(_));
        let only_time = context.graph.leaves([e]).into_iter().all(|l| context.kind(l) == SymbolKind::Time);
        let is_number = matches!(context.graph.node(e), Node::Constant(_));
        if !only_time || constant && !is_number {
            return Err(format!("{name} is no formula of the time, or no number"));
        }
        let sign = context.graph.component(symbol, *component);
        let allowed_signs = signs(context, sign, &KnownSigns::new());
        if constant && !signs(context, e, &KnownSigns::new()).within(allowed_signs) {
            return Err(format!("{name} has the wrong sign"));
        }
        motion.formulas.insert((symbol, *component), e);
    }
    for c in context.instants.clone() {
        let value = motion.along(context, c)?;
        if !matches!(context.graph.node(value), Node::Constant(_)) {
            return Err("a fixed time is no number on the motion".to_owned());
        }
        motion.local &= value == at;
        motion.instants.insert(c, value);
    }
    Ok(motion)
}

/// Shows that there is a motion.
pub(super) fn model(draft: &mut Draft, values: &[(String, u16, Term)], at: &str) -> Result<(), String> {
    let motion = read(draft, values, at)?;
    let formulas: Vec<Expr> = motion.formulas.values().copied().collect();
    for e in formulas {
        let asked = crate::needs::smooth(&mut draft.context, e);
        if !motion.holds_on_t(&mut draft.context, &asked) {
            return Err("a formula is not smooth at all times".to_owned());
        }
    }
    let context = &draft.context;
    let mut given: Vec<Says> = [&context.systems[..], &context.premises, &context.assumed].concat();
    given.extend(context.claims.iter().map(|claim| claim.says));
    for says in given {
        let along = motion.says_along(&mut draft.context, says)?;
        let mut asked = needs_of(draft, along);
        for side in along.sides() {
            asked.extend(continuous(&mut draft.context, side, &Needs::new()));
        }
        let here = Says {
            left: at_time(&mut draft.context, along.left, motion.at),
            sense: along.sense,
            right: at_time(&mut draft.context, along.right, motion.at),
        };
        let beside = match along.sense {
            Sense::Equal => false,
            // A weak inequality that is strict at t₀ is so beside it.
            Sense::Less | Sense::LessOrEqual => {
                motion.local && is_true(&mut draft.context, Says { sense: Sense::Less, ..here })
            }
            Sense::NotEqual => motion.local && is_true(&mut draft.context, here),
        };
        if !motion.holds_on_t(&mut draft.context, &asked) || !(beside || is_true(&mut draft.context, along)) {
            return Err(format!("not true on the motion: `{}`", draft.context.latex(says)));
        }
    }
    for says in draft.context.selectors.clone().into_iter().chain([draft.context.claim]) {
        let along = motion.says_along(&mut draft.context, says)?;
        let here = Says {
            left: at_time(&mut draft.context, along.left, motion.at),
            sense: along.sense,
            right: at_time(&mut draft.context, along.right, motion.at),
        };
        let values = needs_of(draft, here);
        let open: Needs = values.into_iter().chain(certain_of(draft, here)).collect();
        if !open.iter().all(|need| is_trivial(&draft.context, *need)) || !is_true(&mut draft.context, here) {
            return Err(format!("not true at the time: `{}`", draft.context.latex(says)));
        }
    }
    draft.model = true;
    Ok(())
}
