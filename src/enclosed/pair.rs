//! One claim along one enclosed motion.
//!
//! **In:** the verdict that samples gave, and the enclosed motion. **Out:** the same verdict, with what the enclosure leaves
//! possible of each part and each hypothesis ([`Verdict::enclose`]). Nothing is combined here.

use std::sync::Arc;

use super::cover::Along;
use super::rank::Rank;
use super::ready::{Ready, Shown};
use super::same::Same;
use super::{event, limit, span};
use crate::derivation::Claim;
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::Enclosure;
use crate::number::Bounded;
use crate::verdict::{Enclosed, Outcome, Possible, Strength, Verdict, Witness};
use claim::comparison::{Comparison, Group};
use claim::program::{Part, Program, What};
use reason::{Enclosing, Plain, Reason, Refutation};
use sampled::independence::Gradients;

/// How far two routes to the same residual may be apart, in units of the error bound of the sampled one.
pub(super) const DISAGREEMENT: f64 = 100.0;

/// The residuals of a comparison at a time, as samples see them: `None` without a value.
pub(super) type Sampled<'a> = &'a dyn Fn(&Comparison, f64) -> Option<Bounded>;

/// Adds to a verdict that is not rigorous why it is not.
pub(super) fn remark(verdict: &mut Verdict, reason: &Reason) {
    if !is_rigorous(verdict.outcome()) {
        // What was enclosed of one part is no remark on the whole.
        let said = verdict.evidence().reason.clone().filter(|_| verdict.evidence().enclosed.is_none());
        let (before, why) = (said.map(Arc::new), Arc::new(reason.clone()));
        verdict.remark(Enclosing::NotEnclosed { before, why }.into());
    }
}

/// What a part shows that is looked at where samples find it false.
fn refuted(found: Result<(Witness, Refutation), Reason>) -> Shown {
    found.map_or_else(Shown::Nothing, |(witness, refutation)| Shown::Fails(witness, refutation.into()))
}

/// The counted work of a part in the outcome of all.
const OF_A_PART: u64 = 20;

/// Whether a verdict holds for every time, or for all values.
pub(super) fn is_rigorous(outcome: Outcome) -> bool {
    match outcome {
        Outcome::Holds(strength) | Outcome::Fails(strength) | Outcome::NotApplicable(strength) => {
            strength > Strength::Sampled
        }
        Outcome::Undecided => false,
    }
}

/// A part of a claim, ready to be looked at along a motion; or why it is not.
pub(super) enum Prepared<'a> {
    Compared(Result<Ready<'a>, Reason>),
    Rank(Result<Rank<'a>, Reason>),
    Same(Result<Box<Same>, Reason>),
    /// Nothing is said of it by itself.
    Silent,
}

/// What a claim is prepared from.
pub(super) struct Asked<'a, 'r> {
    pub claim: &'a Claim,
    pub program: &'a Program,
    pub gradients: Option<&'a Result<Gradients, Reason>>,
    /// Parameters and initial states, as they are given.
    pub start: &'r [(Leaf, Expr)],
    /// Another motion, enclosed.
    pub other: &'r dyn Fn(usize, &mut Graph) -> Result<Enclosure, Reason>,
}

/// Tells a motion what a claim will ask for: its parts, then its hypotheses.
pub(super) fn prepare<'a>(asked: &Asked<'a, '_>, along: &mut Along) -> Vec<Prepared<'a>> {
    let Asked { claim, program, gradients, .. } = *asked;
    let ready = |part: &'a Part, along: &mut Along| match &part.what {
        What::SameMotion(other, of) => Prepared::Same(Same::new(asked, part, *other, of, along).map(Box::new)),
        What::Independent => Prepared::Rank(match gradients {
            Some(Ok(gradients)) => Rank::new(asked, part, gradients, along),
            Some(Err(reason)) => Err(reason.clone()),
            None => Err(Plain::NoGradients.into()),
        }),
        What::Every
        | What::Denied
        | What::Defined
        | What::Constant
        | What::Value
        | What::Limit(_)
        | What::Across
        | What::Unread(_) => Prepared::Compared(Ready::new(program, part, along, claim)),
    };
    let mut all: Vec<Prepared> = Vec::new();
    for (position, part) in program.parts.iter().enumerate() {
        let one = ready(part, along);
        let before = position.checked_sub(1).map(|p| &program.parts[p].what);
        let (What::Value, Some(What::Constant)) = (&part.what, before) else {
            all.push(one);
            continue;
        };
        // What is the same at all times is looked at by its values, where the start may not count.
        if let (Prepared::Compared(Ok(values)), Some(constant)) = (one, all.last_mut())
            && values.is_restricted()
        {
            *constant = Prepared::Compared(Ok(values));
        }
        all.push(Prepared::Silent);
    }
    // Hypotheses are about all times that the selectors leave, and not about events.
    all.extend(program.hypotheses.iter().map(|a| match ready(&a.part, along) {
        Prepared::Compared(Ok(mut ready)) => {
            ready.event = None;
            Prepared::Compared(Ok(ready))
        }
        other => other,
    }));
    all
}

/// Strengthens one verdict.
///
/// # Errors
/// At one and the same time, the enclosure and the samples find different residuals: where, and how far they are apart.
pub(super) fn strengthen(
    program: &Program,
    prepared: Vec<Prepared>,
    along: &mut Along,
    sampled: Sampled,
    verdict: &mut Verdict,
) -> Result<(), Reason> {
    along.refill();
    let beyond = program.parts.len();
    let mut reasons = Vec::new();
    // A hypothesis that is false decides by itself.
    let order = (beyond..prepared.len()).chain(0..beyond);
    let mut prepared: Vec<Option<Prepared>> = prepared.into_iter().map(Some).collect();
    for position in order {
        let Some(one) = prepared[position].take() else { continue };
        if is_rigorous(verdict.outcome()) {
            break;
        }
        // The outcome is that of all parts together.
        meter::charge(OF_A_PART * prepared.len() as u64);
        let part = program.part(position);
        let group = &part.group;
        let before = verdict.findings().get(position).and_then(|f| f.known(Strength::Sampled));
        let seen = verdict.findings().get(position).and_then(|f| f.evidence().witness.clone());
        // What was false on samples is looked at where they saw it.
        let near = seen.as_ref().filter(|_| before == Some(Possible::FALSE));
        let shown = match one {
            Prepared::Compared(Ok(mut ready)) => {
                ready.agreed = before == Some(Possible::TRUE);
                let found = match (position.checked_sub(beyond), near) {
                    (Some(hypothesis), None) => {
                        let text = format!("{:?} {}", program.hypotheses[hypothesis].text, ready.agreed);
                        let key = (ready.roots.roots().to_vec(), text, ready.precision.to_bits());
                        along.presuppose(key, |along| shown(&mut ready, None, along))
                    }
                    _ => shown(&mut ready, near, along),
                };
                let all = ready.event.is_none() && !matches!(part.what, What::Limit(_));
                match found {
                    // That no sample counts says nothing of a single time between them.
                    open @ (Shown::Nothing(_) | Shown::Isolated(_) | Shown::Unless(..))
                        if all && before == Some(Possible::VOID) =>
                    {
                        span::silent(&ready, along, open)
                    }
                    found => found,
                }
            }
            // Samples do not tell a small rank from none.
            Prepared::Rank(Ok(rank)) => match (near, rank.refuted(along)) {
                (_, Ok((witness, refutation))) => Shown::Fails(witness, refutation.into()),
                (Some(_), Err(reason)) => Shown::Nothing(reason),
                (None, Err(_)) => rank.always(along),
            },
            Prepared::Same(Ok(same)) => match near {
                Some(witness) => refuted(same.refuted(along, witness)),
                None => same.always(along),
            },
            Prepared::Compared(Err(reason)) | Prepared::Rank(Err(reason)) | Prepared::Same(Err(reason)) => {
                Shown::Nothing(reason)
            }
            Prepared::Silent => continue,
        };
        if let (Shown::Fails(witness, _), false) = (&shown, group.branching)
            && let Some(comparison) = group.comparisons.iter().find(|c| c.label == witness.formula)
            && let Some(seen) = sampled(comparison, witness.t)
        {
            // Between samples anything may happen; at one time both routes must find the same.
            let Witness { t, left, right, bound, .. } = witness.clone();
            let (gap, size) = ((seen.value - (left - right)).abs(), left.abs() + right.abs());
            if gap > DISAGREEMENT * (seen.error + bound + f64::EPSILON * size) {
                learn(verdict, position, shown, (part, beyond));
                let (sampled, enclosed) = ((seen.value, seen.error), (left - right, bound));
                return Err(Enclosing::Contradiction { t, sampled, enclosed }.into());
            }
        }
        let shown = match (shown, near.and_then(|w| apart(group, w))) {
            (Shown::Holds(enclosed, _), Some((difference, why))) if difference <= enclosed.gap => {
                Shown::Nothing(why(false).into())
            }
            (shown @ (Shown::Holds(..) | Shown::Excluded(..)), Some((_, why))) => {
                learn(verdict, position, shown, (part, beyond));
                return Err(why(true).into());
            }
            (shown, _) => shown,
        };
        match &shown {
            Shown::Nothing(reason) | Shown::Isolated(reason) if part.is_definedness() => {
                // That there is a value everywhere is what was asked, and somewhere it is open.
                verdict.doubt(position, Enclosing::ValueOpen(Arc::new(reason.clone())).into());
                reasons.push(reason.clone());
            }
            // Samples do not tell of times at which something else is possible, all around being settled.
            Shown::Isolated(reason) if before == Some(Possible::VOID) || part.needs_a_complete_search() => {
                verdict.doubt(position, Enclosing::Undecided(Arc::new(reason.clone())).into());
                if verdict.outcome() != Outcome::Undecided {
                    reasons.push(reason.clone());
                }
            }
            Shown::Nothing(reason) | Shown::Isolated(reason) => reasons.push(reason.clone()),
            Shown::Holds(..) | Shown::Excluded(..) | Shown::Unless(..) | Shown::Fails(..) | Shown::Void(_) => {}
        }
        learn(verdict, position, shown, (part, beyond));
    }
    verdict.settle();
    if let (false, Some(reason)) = (is_rigorous(verdict.outcome()), reasons.first()) {
        remark(verdict, reason);
    }
    Ok(())
}

/// How far apart samples found the sides of an equation or inequality that they take for false, at least, and as a reason: `None`
/// where the sides differ by less than errors explain. Where an enclosure allows more, it does not tell them apart.
fn apart(group: &Group, seen: &Witness) -> Option<(f64, impl Fn(bool) -> Enclosing + use<>)> {
    // Where several comparisons are combined, or one has no value, another may have decided.
    if group.branching || group.asserted || group.formula.is_some() {
        return None;
    }
    let &Witness { t, left, right, bound, .. } = seen;
    let difference = left - right;
    let beyond = difference.abs() - DISAGREEMENT * (bound + f64::EPSILON * (left.abs() + right.abs()));
    let why = move |excluded| Enclosing::SampledApart { t, difference, bound, excluded };
    (beyond > 0.0).then_some((beyond, why))
}

/// What was shown, as what is left possible of a part.
fn learn(verdict: &mut Verdict, position: usize, shown: Shown, (part, beyond): (&Part, usize)) {
    let hypothesis = position >= beyond;
    let denied = matches!(part.what, What::Denied);
    match shown {
        Shown::Holds(enclosed, reason) => verdict.enclose(position, Possible::TRUE, |e| {
            e.enclosed = Some(enclosed);
            e.samples = e.samples.max(1);
            e.reason = Some(reason);
        }),
        Shown::Excluded(enclosed, reason, witness) => verdict.enclose(position, Possible::TRUE, |e| {
            e.enclosed = Some(enclosed);
            e.samples = e.samples.max(1);
            e.witness = Some(witness);
            e.reason = Some(Enclosing::Excluded(Arc::new(reason)).into());
        }),
        Shown::Unless(enclosed, reason) => verdict.enclose(position, Possible::TRUE_OR_VOID, |e| {
            e.enclosed = Some(enclosed);
            e.reason = Some(Enclosing::WhereverItSays(Arc::new(reason)).into());
        }),
        Shown::Void(reason) => verdict.enclose(position, Possible::VOID, |e| e.reason = Some(reason)),
        Shown::Fails(mut witness, reason) => verdict.enclose(position, Possible::FALSE, |e| {
            if witness.values.is_empty()
                && let Some(before) = e.witness.as_ref().filter(|w| w.t == witness.t && w.formula == witness.formula)
            {
                witness.values = before.values.clone();
            }
            e.reason = match (hypothesis, e.reason.take()) {
                // What is not met is said in the words of the assumption.
                (true, Some(before)) if e.witness.is_some() => Some(Enclosing::AlsoCertified(Arc::new(before)).into()),
                (true, _) => Some(Enclosing::Unmet(Arc::new(reason)).into()),
                (false, _) => Some(match reason {
                    Reason::Enclosing(Enclosing::Certified(how)) if denied => Enclosing::Certain(how).into(),
                    reason => reason,
                }),
            };
            if hypothesis {
                e.unmet.get_or_insert_with(|| witness.clone());
            }
            e.witness = Some(witness);
        }),
        Shown::Isolated(_) | Shown::Nothing(_) => {}
    }
}

/// What is shown of comparisons. `near` is where samples say that they are false.
fn shown(ready: &mut Ready, near: Option<&Witness>, along: &mut Along) -> Shown {
    if let (Some(witness), false) = (near, matches!(ready.part.what, What::Limit(_) | What::Value)) {
        let found = match ready.event {
            Some(event) => event::refuted(ready, event, along, witness.t),
            None => span::refuted(ready, along, witness.t),
        };
        if let Ok(found) = found {
            let reason = match ready.part.is_definedness() {
                true => Refutation::NoValue(found.t),
                false => Refutation::Apart { motions: false, t: found.t },
            };
            return Shown::Fails(found, reason.into());
        }
    }
    if let (Some(reason), false) = (along.incomplete(), matches!(ready.part.what, What::Limit(_))) {
        return Shown::Nothing(reason);
    }
    ready.weigh(along);
    let shown = match (&ready.part.what, ready.event) {
        // Where no time counts, nothing is said of a limit, either.
        (What::Limit(point), event) => match span::counts(ready, event, along) {
            Some(true) => limit::limit(ready, point, along),
            Some(false) => Shown::Void(Plain::NoTimeOfSpanCounts.into()),
            None => Shown::Nothing(Plain::WhetherTimesCountUncertain.into()),
        },
        (_, Some(event)) => event::always(ready, event, along),
        (What::Unread(why), None) => Shown::Nothing(Reason::quoted(why)),
        (What::Across, None) => Shown::Nothing(Plain::FamilyNotEnclosed.into()),
        (What::Value, None) => span::constant(ready, along),
        (
            What::Every | What::Denied | What::Defined | What::Constant | What::SameMotion(..) | What::Independent,
            None,
        ) => span::always(ready, along),
    };
    match (&ready.part.what, shown) {
        // Never, though it should: a reader sees a time at which it is not so.
        (What::Denied, Shown::Holds(enclosed, reason)) => match span::some_time(ready, along) {
            Some(witness) => Shown::Excluded(Enclosed { gap: 0.0, ..enclosed }, reason, witness),
            None => Shown::Nothing(Plain::NoTimeToShow.into()),
        },
        (_, shown) => shown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(left: f64, bound: f64) -> Witness {
        Witness { t: 1.0, formula: "x=1".to_owned(), left, right: 1.0, bound, values: Vec::new() }
    }

    #[test]
    fn samples_and_enclosures_that_contradict_each_other_do_not_pass_in_silence() {
        let single = Group::default();
        let far = apart(&single, &seen(1.5, 1e-6));
        assert!(far.is_some_and(|(by, why)| (0.499..0.5).contains(&by) && why(false).to_string().contains("t = 1 ")));
        // Of x < 1 samples say that it is false where both sides are the same as far as they see: that is no contradiction.
        assert!(apart(&single, &seen(1.0, 1e-6)).is_none());
        assert!(apart(&single, &seen(1.0 + 2e-5, 1e-6)).is_none());
        // What has no value is not apart, nor decides one of several comparisons.
        assert!(apart(&Group { asserted: true, ..Group::default() }, &seen(1.5, 1e-6)).is_none());
        assert!(apart(&Group { branching: true, ..Group::default() }, &seen(1.5, 1e-6)).is_none());
    }
}
