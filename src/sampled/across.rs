//! Members of a family, compared in one quantity.
//!
//! **In:** motions that differ in one symbol, and its values; a quantity, at the first event of each motion, or one that does
//! not move. **Out:** a finding of what the claim says of them: that two quantities are equal, ordered, or that the slope of
//! their logarithms is a power; that one is the largest; that they tend to a value.
//!
//! **Guaranteed:** the quantities have the bounds of the motions, and what is computed of them carries these on: where they are too
//! large to tell, nothing is known. The first event is that of a complete search; where one may be missing, nothing is known
//! either. The rules are those of every comparison, see `weigh`.
//!
//! **Why two members at a time:** "it grows" is so of all if it is of neighbours; a slope between any two is a mean of those between
//! neighbours; "it is the same" is so of all if all are as one of them. So a claim across members is one of each member, is counted
//! as others are, and needs no memory for the members. For an extremum the other is the motion at its place, whether it is a member or
//! not; a limit is looked for from each member anew, along motions of which only the first is one.

use std::sync::{Arc, OnceLock};

use crate::between::may_lie_beyond;
use crate::derivation::{Across, Dependence, Derivation, End, Form, NoOther};
use crate::describe::{Describer, Left, incomplete};
use crate::expr::Expr;
use crate::flow::{Incomplete, Points};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue, Number};
use crate::pointwise::Tried;
use crate::trace::{Trace, Trial};
use crate::verdict::{Evidence, Finding, Possible, Rise};
use crate::weakening::{known, open_events};
use crate::weigh::weigh;
use crate::{events, extrapolate};
use claim::comparison::{Comparison, Group};
use claim::program::Values;
use claim::quantity::Quantity;
use claim::sides::{Measured, MeasuredGroup, Series, Sizes};
use reason::{Plain, Reason, Sampling};

/// What is compared, as the file of the member has it: the claim that is tried knows no member.
fn across_of<'d>(derivation: &'d Derivation, trial: &Trial) -> Option<&'d Across> {
    let claim = derivation.claims.iter().find(|c| c.id == trial.claim.id && c.reading == trial.claim.reading)?;
    claim.forms.iter().find_map(|form| match form {
        Form::Across(across) => Some(&**across),
        _ => None,
    })
}

/// When a quantity is taken, and what is known of the motion then.
struct Taken {
    t: f64,
    values: Values,
}

/// The first time at which the quantity is taken on a motion.
fn taken(trial: &Trial, trace: &Trace) -> Result<Taken, Box<Finding>> {
    if let Some(problem) = trace.motion.problem() {
        return Err(Finding::open(Reason::quoted(problem)).into());
    }
    // What an angle adds up along a motion is not known beyond such a place.
    let open = |gap: &&Incomplete| match gap {
        Incomplete::NoValue { .. } => false,
        Incomplete::Vanishing { .. } | Incomplete::Unresolved { .. } => true,
    };
    if let Some(gap) = trace.motion.unresolved().iter().find(open) {
        return Err(Finding::open(Sampling::Gap(incomplete(gap))).into());
    }
    let Some(event) = trial.program.at else {
        let t = trace.stage.initial_time(trace.trajectory);
        return Ok(Taken { t, values: trace.values(t) });
    };
    let found = trial.claim.at.as_ref().and_then(|at| events::of_event(trial.graph, at, event, trace));
    let Some(found) = found else {
        return Err(Finding::open(Plain::EventHasNoMeaning).into());
    };
    let counts = |i: &Incomplete| !matches!(i, Incomplete::NoValue { reason: NoValue::OutOfDomain, .. });
    let trial = Trial { trace, ..*trial };
    if let Some(reason) = open_events(&trial, &found, counts) {
        return Err(Finding::open(reason).into());
    }
    let (Some(&t), Some(&slack)) = (found.zeros.times.first(), found.zeros.slack.first()) else {
        return Err(void(Plain::NoEventOnOther).into());
    };
    if may_lie_beyond(trace.stage.span(trace.trajectory), t, slack) {
        return Err(Finding::open(Sampling::EventInSpan(t)).into());
    }
    Ok(Taken { t, values: trace.values_at_event(t, slack) })
}

/// It says nothing, for a reason.
fn void(reason: impl Into<Reason>) -> Finding {
    Finding::sampled(Possible::VOID, Evidence::because(reason))
}

/// Compares a member with those that the family gives beside it.
pub(super) fn try_on(derivation: &Derivation, trial: &Trial, tried: &Tried, position: usize) -> Finding {
    let Some(across) = across_of(derivation, trial) else { return Finding::open(Plain::ComparedUnknown) };
    let name = || across.name.as_str().into();
    let values = match &across.values {
        Ok(values) => values,
        Err(NoOther::Last) => {
            return void(Sampling::LastMember(name()));
        }
        Err(NoOther::TooRare) => return Finding::open(Plain::NoMemberBeside),
        Err(NoOther::Rejected) => {
            return void(Plain::OtherRejected);
        }
        Err(NoOther::Near) => return void(Plain::TooNearExtremum),
        Err(NoOther::Beyond) => return void(Sampling::BeyondLimit(name())),
        Err(NoOther::NoMember) => return Finding::open(Plain::ComparesMembers),
    };
    let trace = trial.trace;
    if let Some(Left::Open(reason) | Left::Out(reason)) = tried.left.first() {
        return Finding::open(Reason::clone(reason));
    }
    let group = &trial.program.parts[position].group.comparisons;
    let Some((quantity, limit, cuts)) = group.first().map(|c| (c.left, c.right, &c.cuts)) else {
        return Finding::open(Plain::NoQuantity);
    };
    let evaluator = |e: Expr| Quantity::new(trial.graph, trace.leaves, e, cuts);
    let (Some(value), Some(limit)) = (evaluator(quantity), evaluator(limit)) else {
        return Finding::open(Plain::QuantityUnknown);
    };
    let mut members = Vec::new();
    // Where the member has no value, what is claimed of its side of an extremum may be false all the same.
    let (extremum, mut without) = (matches!(across.dependence, Dependence::Extremum { .. }), None);
    for (n, &x) in values.iter().enumerate() {
        let other;
        let of = match n.checked_sub(1).map(|n| across.others.get(n)) {
            None => trace,
            Some(position) => {
                let built = position.and_then(|position| Some((*position, trace.stage.motion(*position)?)));
                let Some((trajectory, motion)) = built else { return Finding::open(Plain::OtherNotBuilt) };
                // Its samples are not asked for.
                let (times, points) = (Vec::new(), Arc::new(Points::default()));
                let between = OnceLock::new();
                other = Trace { stage: trace.stage, trajectory, motion, leaves: trace.leaves, times, points, between };
                &other
            }
        };
        // Where it is only compared with its neighbour, nothing is known of the two of which that one is between.
        let missing = |finding: Finding| match n > 0 && links_all(across.dependence) {
            true => Finding::open(finding.evidence().reason.clone().unwrap_or(Plain::NothingToCompare.into())),
            false => finding,
        };
        let taking = taken(trial, of).and_then(|at| match value.value(&at.values) {
            Ok(of) => Ok(Taking { x, at, of }),
            Err(NoValue::OutOfDomain) => Err(void(Sampling::NoValueOnMember(across.of.text.as_str().into())).into()),
            Err(reason) => Err(Finding::open(reason).into()),
        });
        match taking {
            Ok(taking) => members.push(taking),
            Err(finding) if n == 0 && extremum && known(&finding) == Possible::VOID => without = Some(*finding),
            Err(finding) => return missing(*finding),
        }
    }
    if let Dependence::Limit { end, to } = across.dependence {
        return tends(trial, across, &members, (end, to), &limit, quantity);
    }
    let (own, others) = members.split_at(usize::from(without.is_none()).min(members.len()));
    let [other, more @ ..] = others else { return Finding::open(Plain::NothingToCompare) };
    let two = |own: &Taking, other: &Taking| compare(trial, across, own, other, quantity);
    let Dependence::Extremum { to, .. } = across.dependence else {
        return own.first().map_or_else(|| Finding::open(Plain::NothingToCompare), |own| two(own, other));
    };
    // The member itself, if it is far enough from the extremum, and the motion beside the extremum.
    let far = own.iter().filter(|own| (own.x - other.x).abs() >= to);
    let findings = without.into_iter().chain(far.chain(more).map(|one| two(one, other)));
    let all = findings.reduce(|a, b| if rank(&b) >= rank(&a) { b } else { a });
    all.unwrap_or_else(|| void(Plain::TooNearExtremum))
}

/// Whether a claim of all members is one of each and one other, through which it is compared with all.
fn links_all(dependence: Dependence) -> bool {
    match dependence {
        Dependence::Independent | Dependence::Increasing | Dependence::Decreasing | Dependence::Power { .. } => true,
        Dependence::Extremum { .. } | Dependence::Limit { .. } => false,
    }
}

/// A member, or a motion beside it: the value of what varies, when the quantity is taken, and what it is.
struct Taking {
    x: f64,
    at: Taken,
    of: Bounded,
}

/// Of two findings about one extremum, which one is told: what is false before what is open, that before what says nothing, and that
/// before what is true.
fn rank(finding: &Finding) -> u8 {
    match known(finding) {
        Possible::FALSE => 3,
        Possible::VOID => 1,
        Possible::TRUE => 0,
        _ => 2,
    }
}

/// Compares two members.
fn compare(trial: &Trial, across: &Across, ours: &Taking, theirs: &Taking, quantity: Expr) -> Finding {
    let (text, own, q, r) = (&across.of.text, (ours.x, theirs.x), ours.of, theirs.of);
    let mut rise = None;
    let compared = match across.dependence {
        Dependence::Independent => both(text, q, r, RelationKind::Equal),
        Dependence::Increasing => both(text, q, r, ordered(own, RelationKind::Less, RelationKind::Greater)),
        Dependence::Decreasing => both(text, q, r, ordered(own, RelationKind::Greater, RelationKind::Less)),
        Dependence::Extremum { maximum: true, .. } => both(text, q, r, RelationKind::Less),
        Dependence::Extremum { maximum: false, .. } => both(text, q, r, RelationKind::Greater),
        Dependence::Power { power, to } => match slope((q, r), own) {
            Ok((slope, found)) => {
                rise = Some(found);
                // What the subtraction rounds.
                let error = slope.error + 4.0 * f64::EPSILON * (slope.value.abs() + power.abs() + to);
                let off = Bounded { value: slope.value - power, error };
                within(format!("slope of ln|{text}| against ln|{}|, less {power}", across.name), off, to)
            }
            Err(finding) => return *finding,
        },
        Dependence::Limit { .. } => return Finding::open(Plain::LimitNotOfTwo),
    };
    let values = vec![
        (across.name.clone(), own.0),
        (format!("{} of the other", across.name), own.1),
        (text.clone(), q.value),
        (format!("{text} of the other"), r.value),
    ];
    let finding = told(trial, &ours.at, compared, quantity, values);
    match rise {
        // Of what is not decided the slope counts, too.
        Some(rise) => Finding::sampled(known(&finding), Evidence { rise: Some(rise), ..finding.evidence().clone() }),
        None => finding,
    }
}

/// Whether the quantity tends to a value along a sequence of motions.
fn tends(
    trial: &Trial,
    across: &Across,
    members: &[Taking],
    (end, to): (End, f64),
    limit: &Quantity,
    quantity: Expr,
) -> Finding {
    let (sequence, beyond) = members.split_at(members.len().min(extrapolate::STEPS));
    let (Some(own), Some(last)) = (sequence.first(), sequence.last()) else {
        return Finding::open(Plain::NoSequence);
    };
    let (claimed, again) = match (limit.value(&own.at.values), limit.value(&last.at.values)) {
        (Ok(here), Ok(there)) => (here, there),
        (Err(NoValue::OutOfDomain), _) | (_, Err(NoValue::OutOfDomain)) => {
            return void(Plain::LimitHasNoValue);
        }
        (Err(reason), _) | (_, Err(reason)) => return Finding::open(reason),
    };
    if !(claimed - again).contains_zero() {
        return Finding::open(Plain::LimitChanges);
    }
    let sequence: Vec<Bounded> = sequence.iter().map(|m| m.of).collect();
    let found = match extrapolate::limit(&sequence) {
        Ok(found) => found,
        Err(reason) => {
            let (name, why) = (across.name.as_str().into(), Arc::new(reason.into()));
            return Finding::open(Sampling::FromOn { name, from: own.x, why });
        }
    };
    if let Some(beyond) = beyond.iter().find(|beyond| !extrapolate::goes_on(&found, &last.of, &beyond.of)) {
        return Finding::open(Sampling::OffSequence { name: across.name.as_str().into(), at: beyond.x });
    }
    let (text, name) = (&across.of.text, &across.name);
    let tends_to = match (end, &across.point) {
        (End::Infinity, _) => "\\infty",
        (End::MinusInfinity, _) => "-\\infty",
        (End::Number, point) => point.as_ref().map_or("a number", |p| p.text.as_str()),
    };
    let said = across.value.as_ref().map_or("0", |v| v.text.as_str());
    let label = format!("estimated limit of {text} for {name} → {tends_to}, less {said}");
    let values = vec![
        (name.clone(), own.x),
        (format!("{name} of the last of the sequence"), last.x),
        (text.clone(), own.of.value),
        (format!("{text} of the last of the sequence"), last.of.value),
        (format!("estimated limit of {text}"), found.value),
    ];
    told(trial, &own.at, within(label, found - claimed, to), quantity, values)
}

/// That a number is 0, to within a distance.
fn within(label: String, off: Bounded, to: f64) -> Compared {
    let left = off.value.abs();
    let difference = Bounded { value: left - to, error: off.error + 2.0 * f64::EPSILON * (left + to) };
    (label, RelationKind::LessEqual, Measured { left, right: to, difference }, to)
}

/// What a comparison says, with the members that were compared.
fn told(trial: &Trial, at: &Taken, compared: Compared, quantity: Expr, values: Vec<(String, f64)>) -> Finding {
    // Agreement within the error is no order.
    let (_, kind, measured, _) = &compared;
    if *kind != RelationKind::Equal && measured.difference.error > 0.0 && measured.difference.contains_zero() {
        let Measured { left, right, difference } = *measured;
        return Finding::open(Sampling::NotApart { left, right, bound: difference.error });
    }
    let finding = weighed(trial, at, compared, quantity);
    let mut evidence = finding.evidence().clone();
    if let Some(witness) = &mut evidence.witness {
        // Of both members, what varies, and when and what was compared.
        witness.values = values;
    }
    Finding::sampled(known(&finding), evidence)
}

/// What is compared: what it is called, how, the two, and the size of their terms.
type Compared = (String, RelationKind, Measured, f64);

fn both(text: &str, q: Bounded, r: Bounded, kind: RelationKind) -> Compared {
    let measured = Measured { left: q.value, right: r.value, difference: q - r };
    (format!("{text} of both members"), kind, measured, q.value.abs() + r.value.abs())
}

/// How quantities are ordered where the first value of what varies is the smaller one.
fn ordered((own, other): (f64, f64), smaller: RelationKind, larger: RelationKind) -> RelationKind {
    if own < other { smaller } else { larger }
}

/// The slope of ln|q| against ln|x| between two members, with its error.
fn slope((q, r): (Bounded, Bounded), (own, other): (f64, f64)) -> Result<(Bounded, Rise), Box<Finding>> {
    if own * other <= 0.0 {
        return Err(void(Plain::NoSlope).into());
    }
    let sizes = [(q.value.abs(), q.error), (r.value.abs(), r.error)];
    if sizes.iter().any(|(size, error)| *error > 0.25 * size) {
        return Err(Finding::open(Plain::NoLogarithm).into());
    }
    let log = |x: f64| {
        let mut out = Bounded::exact(0.0);
        Number::ln(&mut out, &(), &Bounded::exact(x)).map(|()| out)
    };
    // ln(1 + u) is off by at most 4/3 |u| for |u| up to 1/4.
    let of = |(size, error): (f64, f64)| {
        log(size).map(|l| Bounded { value: l.value, error: l.error + 4.0 / 3.0 * (error / size) * (1.0 + 1e-10) })
    };
    let all = (of(sizes[0]), of(sizes[1]), log(own.abs()), log(other.abs()));
    let (Ok(a), Ok(b), Ok(x), Ok(y)) = all else { return Err(Finding::open(Plain::LogarithmTooLarge).into()) };
    let (rise, run) = (b - a, y - x);
    if run.value.abs() <= 4.0 * run.error {
        return Err(Finding::open(Plain::TooNearOneAnother).into());
    }
    let value = rise.value / run.value;
    // |rise/run − exact| ≤ (δrise + |value| δrun)/(|run| − δrun), and rounding.
    let error = (rise.error + value.abs() * run.error) / (run.value.abs() - run.error);
    let slope = Bounded { value, error: error * (1.0 + 1e-10) + f64::EPSILON * value.abs() };
    Ok((slope, Rise { run: run.value, rise: rise.value, error: rise.error + value.abs() * run.error }))
}

/// Weighs one comparison, at the time at which the quantity is taken.
fn weighed(trial: &Trial, at: &Taken, (label, kind, measured, size): Compared, node: Expr) -> Finding {
    let comparison = Comparison::measured(label, kind, node);
    let group = Group { comparisons: vec![comparison], ..Group::default() };
    let mut series = Series::with_capacity(1);
    series.push(Ok(measured));
    let sizes = Sizes::Known(vec![vec![size]].into());
    let group = MeasuredGroup::new(&group, vec![vec![series]], (vec![sizes], 0));
    let times = [at.t];
    let points: Points = std::iter::once(at.values.clone()).collect();
    let describer = Describer::new(trial, &times, &points);
    weigh(describer.setting(vec![Left::In]), &group)
}
