//! Motions that are given by formulas are premises: a claim on one of them is first an identity in time.
//!
//! **In:** the verdicts of claims on motions, from samples. **Out:** the same verdicts, with what is proved of their parts: the
//! states are replaced by their formulas, parameters by their exact values, observables by their definitions, rates by
//! derivatives, and values at fixed times by values. What is left is an equation in time alone, which [`along`] decides.
//!
//! **Guaranteed.** A part is *true* if each of its equations is such an identity, and there is a time that counts at which the
//! sides have values; *false* if sides differ for certain at a time of the span that counts, in the direction that an inequality
//! forbids, or that *never* forbids. That an inequality is true, ± and limits are left to other methods, and so is everything at events.

use crate::derivation::{Claim, Derivation, Motion};
use crate::expr::domain::Sign;
use crate::expr::tape::Tape;
use crate::expr::{Expr, FastMap, Graph, Leaf, Rational, Symbol};
use crate::findings::{ClaimAccount, by_trajectory};
use crate::latex::{RelationKind, Scope};
use crate::number::Bounded;
use crate::verdict::{Outcome, Possible, Proof, Strength, Verdict, Witness};
use claim::comparison::{Comparison, Group, may_leap};
use claim::denote::denote;
use claim::limits::Limits;
use claim::program::{Assumption, Part, What};
use claim::system;
use proof::{Along, Apart, InTime, Memory, Refuted, along};
use reason::Proving;
use std::cmp::Ordering;

/// Finds the verdict on a claim on a motion, after this one, or recalls it.
pub type Recall<'a> = &'a (dyn Fn(usize, (&Claim, &Verdict), &Limits, &mut dyn FnMut() -> Verdict) -> Verdict + Sync);

/// Settles what can be settled; `tried` are the motions of the results. What a limit of the run is reached before stays as it is.
pub fn settle(
    derivation: &Derivation,
    claims: &mut [ClaimAccount],
    (claimed, tried): (&[usize], &[usize]),
    limits: &Limits,
    recall: Recall,
) {
    let results = by_trajectory(claims);
    let column = |&t: &usize, limits: &Limits| -> Vec<(usize, usize, Verdict)> {
        let mut setting = Setting::of(derivation, t, None);
        let mut start: Option<Option<Setting>> = None;
        let mut out = Vec::new();
        for &(k, at) in results.get(derivation.trajectories[t].id.as_str()).into_iter().flatten() {
            let found = &claims[k].results[at].verdict;
            // What an assumption or a formula leaves out stays out; of integrated motions only what is open is looked at.
            let asked = match found.outcome() {
                Outcome::NotApplicable(_) => false,
                Outcome::Undecided => true,
                Outcome::Holds(_) | Outcome::Fails(_) => setting.is_some(),
            };
            if !asked {
                continue;
            }
            if limits.reached().is_some() {
                break;
            }
            let (claim, motion) = (&derivation.claims[claimed[k]], &derivation.trajectories[t]);
            let mut compute = || {
                let mut verdict = found.clone();
                if let Some(setting) = &mut setting {
                    setting.claim(claim, motion, &mut verdict);
                }
                // What no change of sign shows may be so at the start, exactly.
                if matches!(verdict.outcome(), Outcome::Undecided)
                    && let Some(start) = start.get_or_insert_with(|| Setting::at_start(derivation, t))
                {
                    start.at_once(claim, motion, &mut verdict);
                }
                verdict
            };
            out.push((k, at, recall(t, (claim, found), limits, &mut compute)));
        }
        out
    };
    let found = meter::each(limits, tried, column);
    for (k, at, verdict) in found.into_iter().flatten() {
        claims[k].results[at].verdict = verdict;
    }
}

/// Places at which a formula is looked at for a change of its sign.
const LOOKS: u32 = 256;
/// A rate at the start is a derivative of rates at most so many times.
const MOST_DERIVATIONS: u8 = 6;
/// The largest denominator of a time that is tried exactly.
const LARGEST_DENOMINATOR: i64 = 1000;

/// The fraction with a small denominator that a number rounds to, by its continued fraction.
fn simple_fraction(number: f64) -> Option<Rational> {
    let (mut rest, mut old, mut now) = (number, (1_i64, 0_i64), (number.floor() as i64, 1_i64));
    if number.abs() > 1e9 {
        return None;
    }
    loop {
        if (now.0 as f64 / now.1 as f64 - number).abs() <= 1e-12 * number.abs().max(1.0) {
            return Some(Rational::from(now.0) / Rational::from(now.1));
        }
        let part = rest - rest.floor();
        if part.abs() < 1e-15 {
            return None;
        }
        rest = 1.0 / part;
        let digit = rest.floor() as i64;
        let next = (digit.checked_mul(now.0)?.checked_add(old.0)?, digit.checked_mul(now.1)?.checked_add(old.1)?);
        if next.1 > LARGEST_DENOMINATOR {
            return None;
        }
        (old, now) = (now, next);
    }
}

/// Rates at the start of an integrated motion.
struct Rates {
    initial: FastMap<Leaf, Expr>,
    /// Those that the system gives, of each state variable.
    given: FastMap<Leaf, Expr>,
}

/// A motion by formulas, or any motion at its start.
struct Setting<'a> {
    derivation: &'a Derivation,
    graph: Graph,
    memory: Memory,
    time: Leaf,
    span: (f64, f64),
    /// The time, where the motion is looked at at its start alone.
    start: Option<Expr>,
    /// Components of states, as formulas in time or by their values at the start, and of parameters, as numbers.
    values: FastMap<(Symbol, u16), Expr>,
    /// What is known of rates at the start of an integrated motion: initial values, and what its system says.
    rates: Option<Rates>,
    /// What has a value wherever the formulas have.
    needs: Vec<Expr>,
}

impl<'a> Setting<'a> {
    /// The motion at its start, where its initial values are exact.
    fn at_start(derivation: &'a Derivation, t: usize) -> Option<Setting<'a>> {
        let trajectory = &derivation.trajectories[t];
        let start = Rational::try_from(trajectory.initial_time).ok()?;
        if let Some(mut setting) = Setting::of(derivation, t, None) {
            setting.start = Some(setting.graph.constant(start));
            setting.span = (trajectory.initial_time, trajectory.initial_time);
            return Some(setting);
        }
        Setting::of(derivation, t, Some(&start))
    }

    /// The motion, where it is given by formulas in the end; at a time, where it is given then.
    fn of(derivation: &'a Derivation, t: usize, start: Option<&Rational>) -> Option<Setting<'a>> {
        let time = derivation.scope.time()?;
        let trajectory = &derivation.trajectories[t];
        let alone = |span: (f64, f64)| {
            let mut graph = derivation.graph.clone();
            let start = start.map(|start| graph.constant(start.clone()));
            let (memory, values) = (Memory::default(), FastMap::default());
            Setting { derivation, graph, memory, time, span, start, values, rates: None, needs: Vec::new() }
        };
        let mut setting = match (&trajectory.motion, start) {
            (Motion::Integrated { .. }, None) => return None,
            (Motion::Integrated { .. }, Some(start))
                if Rational::try_from(trajectory.initial_time) != Ok(start.clone()) =>
            {
                return None;
            }
            (Motion::Integrated { .. } | Motion::Formula { .. }, _) => alone(trajectory.span),
            (Motion::Derived { from, .. }, _) => {
                Setting { span: trajectory.span, ..Setting::of(derivation, *from, start)? }
            }
        };
        if start.is_some() {
            setting.span = (trajectory.initial_time, trajectory.initial_time);
        }
        let mut known: Vec<(Symbol, Vec<Expr>)> =
            trajectory.parameters.iter().map(|(s, w)| (*s, w.value.clone())).collect();
        setting.note(&mut known);
        let states: Vec<(Symbol, &derivation::Written<Vec<Expr>>)> = match &trajectory.motion {
            Motion::Formula { states } => states.iter().map(|(s, w)| (*s, w)).collect(),
            Motion::Derived { map, .. } => map.iter().map(|(s, w)| (*s, w)).collect(),
            Motion::Integrated { initial, .. } => {
                initial.iter().filter(|i| i.1 == 0).map(|(s, _, w)| (*s, w)).collect()
            }
        };
        for (symbol, written) in states {
            let put: Option<Vec<Expr>> = written.value.iter().map(|&e| setting.put(&derivation.scope, e)).collect();
            known.push((symbol, put?));
        }
        setting.note(&mut known);
        if let (Motion::Integrated { system, initial, .. }, Some(_)) = (&trajectory.motion, setting.start) {
            let equations = &derivation.systems[*system];
            let mut rates = FastMap::default();
            for (symbol, rate, written) in initial.iter().filter(|i| i.1 > 0) {
                for (at, &e) in written.value.iter().enumerate() {
                    let leaf = Leaf { rate: *rate, component: at as u16, ..Leaf::now(*symbol, 0) };
                    rates.insert(leaf, setting.put(&derivation.scope, e)?);
                }
            }
            let given = system::rates(&mut setting.graph, &derivation.scope, equations, time);
            let given = given.into_iter().flatten().collect();
            setting.rates = Some(Rates { initial: rates, given });
        }
        setting.needs.clear();
        Some(setting)
    }

    fn note(&mut self, known: &mut Vec<(Symbol, Vec<Expr>)>) {
        for (symbol, values) in known.drain(..) {
            for (at, e) in values.into_iter().enumerate() {
                self.values.insert((symbol, at as u16), e);
            }
        }
    }

    /// An expression in time alone; `None` if something in it is no function of time that is known by a formula.
    fn put(&mut self, scope: &Scope, e: Expr) -> Option<Expr> {
        self.put_at(scope, e, self.start)
    }

    /// The same at a start, or over all times.
    fn put_at(&mut self, scope: &Scope, e: Expr, start: Option<Expr>) -> Option<Expr> {
        let mut images: FastMap<Leaf, Expr> = FastMap::default();
        for leaf in self.graph.leaves([e]) {
            match start {
                Some(start) if leaf == self.time => images.insert(leaf, start),
                None if leaf == self.time => continue,
                Some(_) | None => images.insert(leaf, self.leaf(scope, leaf, start)?),
            };
        }
        Some(self.graph.substitute(e, |_, l| images.get(&l).copied()))
    }

    fn leaf(&mut self, scope: &Scope, leaf: Leaf, start: Option<Expr>) -> Option<Expr> {
        let mut value = match self.values.get(&(leaf.symbol, leaf.component)) {
            Some(&known) => known,
            None => {
                let definition = scope.definition(leaf.symbol)?;
                let component = *definition.components.get(usize::from(leaf.component))?;
                // Of formulas in time its rate is taken before the time is put in.
                self.put_at(scope, component, start.filter(|_| self.rates.is_some()))?
            }
        };
        if self.derivation.is_angle(leaf.symbol) && may_leap(&self.graph, value) {
            return None;
        }
        if let (Some(_), Some(start)) = (&self.rates, start) {
            let then = leaf.instant.map_or(Some(start), |at| self.put(scope, at))?;
            let now = Leaf { instant: None, ..leaf };
            return match (then == start, leaf.rate) {
                (false, _) => None,
                (true, 0) => Some(value),
                (true, _) => self.rate_at_start(scope, now, MOST_DERIVATIONS),
            };
        }
        let now = leaf.instant.is_none();
        self.needs.extend(now.then_some(value));
        for _ in 0..leaf.rate {
            value = self.graph.time_derivative(value, self.time, |_| false).ok()?;
            self.needs.extend(now.then_some(value));
        }
        let instant = match leaf.instant {
            Some(instant) => self.put_at(scope, instant, start)?,
            None => match start {
                Some(start) => start,
                None => return Some(value),
            },
        };
        let time = self.time;
        let fixed = !self.graph.leaves([instant]).contains(&time);
        fixed.then(|| self.graph.substitute(value, |_, l| (l == time).then_some(instant)))
    }

    /// A rate at the start of an integrated motion: an initial value, what the system says, or a derivative of either.
    fn rate_at_start(&mut self, scope: &Scope, leaf: Leaf, most: u8) -> Option<Expr> {
        let rates = self.rates.as_ref()?;
        if let Some(&known) = rates.initial.get(&leaf) {
            return Some(known);
        }
        let mut lower = Leaf { rate: leaf.rate.checked_sub(1)?, ..leaf };
        let mut formula = loop {
            match rates.given.get(&lower) {
                Some(&formula) => break formula,
                None if lower.rate > 0 => lower.rate -= 1,
                None => {
                    let definition = scope.definition(leaf.symbol)?;
                    // Derived as often as is asked.
                    let component = *definition.components.get(usize::from(leaf.component))?;
                    break self.derived(component)?;
                }
            }
        };
        for _ in lower.rate + 1..leaf.rate {
            formula = self.derived(formula)?;
        }
        let mut images: FastMap<Leaf, Expr> = FastMap::default();
        for below in self.graph.leaves([formula]) {
            let image = match below.rate > 0 && below.instant.is_none() {
                true => self.rate_at_start(scope, below, most.checked_sub(1)?)?,
                false => {
                    let leaf = self.graph.leaf(below);
                    self.put(scope, leaf)?
                }
            };
            images.insert(below, image);
        }
        Some(self.graph.substitute(formula, |_, l| images.get(&l).copied()))
    }

    /// The derivative by time of a formula of states and observables.
    fn derived(&mut self, e: Expr) -> Option<Expr> {
        let scope = &self.derivation.scope;
        let moves = |l: Leaf| scope.moves(&l);
        let slope = self.graph.time_derivative(e, self.time, moves).ok()?;
        Some(self.graph.rate_of(e, slope, |_| true))
    }

    /// Both sides, with everything put in.
    fn sides(&mut self, scope: &Scope, (left, right): (Expr, Expr)) -> Option<(Expr, Expr)> {
        Some((self.put(scope, left)?, self.put(scope, right)?))
    }

    /// What selects times; `None` for assumptions of other kinds.
    fn guards(&mut self, scope: &Scope, selectors: &[Assumption]) -> Option<InTime> {
        let mut out = InTime::default();
        for Assumption { part, .. } in selectors {
            if part.group.formula.is_some() || part.group.branching {
                return None;
            }
            for c in &part.group.comparisons {
                let (l, r) = self.sides(scope, (c.left, c.right))?;
                let (over, under) = (self.graph.sub(l, r), self.graph.sub(r, l));
                match c.kind {
                    RelationKind::Equal => return None,
                    RelationKind::NotEqual => out.guards.push((over, Sign::NotZero)),
                    RelationKind::Greater => out.guards.push((over, Sign::Positive)),
                    RelationKind::Less => out.guards.push((under, Sign::Positive)),
                    RelationKind::GreaterEqual => out.guards.push((over, Sign::NotNegative)),
                    RelationKind::LessEqual => out.guards.push((under, Sign::NotNegative)),
                }
            }
        }
        Some(out)
    }

    fn ask(&mut self, guards: &InTime, needs: Vec<Expr>, sides: (Expr, Expr), refuted: Refuted) -> Along {
        let (time, sides) = (Some(self.time), Some(sides));
        let question = InTime { time, span: self.span, sides, needs, refuted, ..guards.clone() };
        along(&mut self.memory, &mut self.graph, &question)
    }

    /// What is proved of a claim on the motion, part by part.
    fn claim(&mut self, claim: &Claim, motion: &derivation::Trajectory, verdict: &mut Verdict) {
        let Ok(start) = Rational::try_from(motion.initial_time) else { return };
        if claim.at.is_some() || claim.region.is_some() {
            return;
        }
        let denoted = denote(&mut self.graph, self.derivation.into(), claim, &start);
        self.needs.clear();
        let Some(guards) = self.guards(&claim.scope, &denoted.selectors) else { return };
        // Where a selector has no value, nothing counts.
        let presupposed = std::mem::take(&mut self.needs);
        let parts = denoted.parts.iter().chain(denoted.hypotheses.iter().map(|a| &a.part));
        for (position, part) in parts.enumerate() {
            match self.part(claim, &guards, &presupposed, part) {
                Some(Ok(())) => verdict.prove(position, Possible::TRUE, |e| {
                    e.samples = e.samples.max(1);
                    (e.witness, e.reason, e.proof) = (None, None, Some(Proof::default()));
                }),
                Some(Err((witness, reason))) => verdict.prove(position, Possible::FALSE, |e| {
                    (e.witness, e.reason) = (Some(witness), Some(reason.into()));
                }),
                None if part.is_definedness() => {
                    if let Some(t) = self.may_lack_a_rate(claim, &guards, part) {
                        verdict.doubt(position, Proving::RateOpen(t).into());
                    }
                }
                None => {}
            }
            if matches!(verdict.outcome(), Outcome::Fails(Strength::Proved) | Outcome::NotApplicable(Strength::Proved))
            {
                return;
            }
        }
    }

    /// What is proved of a claim by the motion's start alone: that something is not so at every time.
    fn at_once(&mut self, claim: &Claim, motion: &derivation::Trajectory, verdict: &mut Verdict) {
        let (Ok(start), None, None) = (Rational::try_from(motion.initial_time), &claim.at, &claim.region) else {
            return;
        };
        let denoted = denote(&mut self.graph, self.derivation.into(), claim, &start);
        let met = |this: &mut Self, part: &Part| this.now(&claim.scope, part).is_some_and(|(k, _)| k == Possible::TRUE);
        if !denoted.selectors.iter().all(|s| met(self, &s.part)) {
            return;
        }
        for (position, part) in denoted.parts.iter().enumerate() {
            // Agreement to within a precision is no matter of single times.
            let strict =
                |c: &Comparison| matches!(c.kind, RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater);
            let strict = matches!(part.what, What::Every) && part.group.comparisons.iter().all(strict);
            if !strict && !matches!(part.what, What::Denied) {
                continue;
            }
            if let Some((Possible::FALSE, Some(witness))) = self.now(&claim.scope, part) {
                verdict.prove(position, Possible::FALSE, |e| {
                    e.samples = e.samples.max(1);
                    (e.witness, e.residual) = (Some(witness), None);
                    e.reason = Some(Proving::ByStart(motion.initial_time).into());
                });
            }
        }
    }

    /// What a part is at the start, with a comparison there.
    fn now(&mut self, scope: &Scope, part: &Part) -> Option<(Possible, Option<Witness>)> {
        let group = &part.group;
        if group.branching || group.comparisons.is_empty() {
            return None;
        }
        let (mut known, mut witness) = (Vec::new(), None);
        for c in &group.comparisons {
            let sides = self.sides(scope, (c.left, c.right))?;
            let (order, left, right, bound) = match self.ask(&InTime::default(), Vec::new(), sides, Refuted::Apart) {
                Along::Agree { seen: Some((_, v)), .. } => (Ordering::Equal, v.value, v.value, v.error),
                Along::Differ(Apart { left, right, bound, .. }) if left != right => {
                    (left.partial_cmp(&right)?, left, right, bound)
                }
                Along::Differ(_) | Along::Agree { .. } | Along::Open => return None,
            };
            let holds = c.kind.holds(order);
            if !holds {
                let (t, formula) = (self.span.0, c.label.clone());
                witness.get_or_insert(Witness { t, formula, left, right, bound, values: Vec::new() });
            }
            known.push(if holds { Possible::TRUE } else { Possible::FALSE });
        }
        Some((group.value(|c| known[c]), witness))
    }

    /// Whether a part is true, or where it is false; `None` where neither is proved.
    fn part(
        &mut self,
        claim: &Claim,
        guards: &InTime,
        presupposed: &[Expr],
        part: &Part,
    ) -> Option<Result<(), (Witness, Proving)>> {
        let group = &part.group;
        if part.is_definedness() {
            let sides: Vec<Expr> = group.comparisons.iter().flat_map(|c| [c.left, c.right]).collect();
            // A formula for a rate may divide by 0 where there is a rate; that of the quantity itself may not.
            let leaves = self.graph.leaves(sides.iter().copied());
            let moving = leaves.iter().filter(|l| l.instant.is_none());
            let own: Vec<Expr> = moving.map(|l| self.graph.leaf(Leaf { rate: 0, ..*l })).collect();
            let plain = |e: &Expr| self.graph.leaves([*e]).iter().all(|l| l.rate == 0);
            let asked: Vec<Expr> = sides.into_iter().filter(plain).chain(own).collect();
            let all: Vec<Expr> = asked.into_iter().filter_map(|e| self.put(&claim.scope, e)).collect();
            if let (Some(t), Some(first)) = (self.missing(guards, presupposed, all), group.comparisons.first()) {
                let formula = first.label.clone();
                let witness = Witness { t, formula, left: 0.0, right: 0.0, bound: 0.0, values: Vec::new() };
                return Some(Err((witness, Proving::DividesByZero(t))));
            }
        }
        if group.formula.is_some() || group.branching || group.comparisons.is_empty() {
            return None;
        }
        match part.what {
            What::Every => {}
            What::Constant if group.comparisons.iter().any(|c| c.kind != RelationKind::Equal) => return None,
            What::Constant => {
                let constant = |c: &Comparison| self.is_constant(claim, guards, presupposed, c.left);
                let proved = group.comparisons.iter().all(constant);
                return (proved && self.are_met_together(claim, guards, presupposed, group)).then_some(Ok(()));
            }
            // Its comparisons are the opposites of what must not be.
            What::Denied => {}
            What::Defined => {
                let formulas: Vec<Expr> =
                    group.comparisons.iter().filter(|c| c.left == c.right).map(|c| c.left).collect();
                let mut everywhere = |e: Expr| {
                    self.needs.clear();
                    let Some(e) = self.put(&claim.scope, e) else { return false };
                    let needs = std::mem::take(&mut self.needs);
                    let found = self.ask(guards, needs, (e, e), Refuted::Apart);
                    matches!(found, Along::Agree { everywhere: true, seen: Some(_) })
                };
                let all = !formulas.is_empty() && formulas.into_iter().all(&mut everywhere);
                return all.then_some(Ok(()));
            }
            What::Value
            | What::Limit(_)
            | What::SameMotion(..)
            | What::Independent
            | What::Across
            | What::Unread(_) => return None,
        }
        let mut holds = true;
        for c in &group.comparisons {
            self.needs.clear();
            let sides = self.sides(&claim.scope, (c.left, c.right));
            let mut needs = std::mem::take(&mut self.needs);
            needs.extend(presupposed);
            let Some(sides) = sides else {
                holds = false;
                continue;
            };
            let refuted = match c.kind {
                RelationKind::Equal => Refuted::Apart,
                RelationKind::Less | RelationKind::LessEqual => Refuted::Above,
                RelationKind::Greater | RelationKind::GreaterEqual => Refuted::Below,
                RelationKind::NotEqual => {
                    holds = false;
                    continue;
                }
            };
            match self.ask(guards, needs, sides, refuted) {
                Along::Agree { seen: Some(_), .. } => {}
                Along::Differ(Apart { time, left, right, bound }) => {
                    let witness = Witness { t: time, formula: c.label.clone(), left, right, bound, values: Vec::new() };
                    let (equation, unseen) = (refuted == Refuted::Apart, left == right);
                    return Some(Err((witness, Proving::Differ { equation, t: time, unseen })));
                }
                Along::Agree { .. } | Along::Open => holds = false,
            }
        }
        (holds && self.are_met_together(claim, guards, presupposed, group)).then_some(Ok(()))
    }

    /// Whether all comparisons of a group have values at one time: components that have them at different times only say nothing.
    fn are_met_together(&mut self, claim: &Claim, guards: &InTime, presupposed: &[Expr], group: &Group) -> bool {
        let [first, others @ ..] = group.comparisons.as_slice() else { return true };
        if others.is_empty() {
            return true;
        }
        self.needs.clear();
        let mut sides = |c: &Comparison| self.sides(&claim.scope, (c.left, c.right));
        let Some((left, right)) = sides(first) else { return false };
        let Some(others) = others.iter().map(sides).collect::<Option<Vec<_>>>() else { return false };
        let mut needs = std::mem::take(&mut self.needs);
        needs.extend(others.into_iter().flat_map(|(l, r)| [l, r]).chain([right]));
        needs.extend(presupposed);
        matches!(self.ask(guards, needs, (left, left), Refuted::Apart), Along::Agree { seen: Some(_), .. })
    }

    /// A time that counts at which one of these formulas has no value, shown in exact arithmetic; and why.
    fn missing(&mut self, guards: &InTime, presupposed: &[Expr], formulas: Vec<Expr>) -> Option<f64> {
        let needs = self.graph.implied_below(formulas);
        for need in needs.into_iter().filter(|n| n.sign == Sign::NotZero) {
            for time in self.rational_zeros(need.value) {
                let mut exactly = |e: Expr| {
                    let at = self.graph.constant(time.clone());
                    let clock = self.time;
                    let then = self.graph.substitute(e, |_, l| (l == clock).then_some(at));
                    self.graph.as_constant(then).cloned()
                };
                let vanishes = exactly(need.value).is_some_and(|v| v == Rational::ZERO);
                let selected = guards.guards.iter().all(|&(e, sign)| exactly(e).is_some_and(|v| sign.is_of(&v)));
                // What has no value for another reason does not count.
                let valued = presupposed.iter().all(|&e| exactly(e).is_some());
                if vanishes && selected && valued {
                    return Some(time.to_f64().value());
                }
            }
        }
        None
    }

    /// Candidates for rational zeros of a formula in time, on the span: simple fractions close to where its sign changes.
    fn rational_zeros(&self, e: Expr) -> Vec<Rational> {
        let mut out: Vec<Rational> =
            self.changes(e).into_iter().flat_map(|(a, b)| [a, b]).filter_map(simple_fraction).collect();
        out.dedup();
        out
    }

    /// Where the sign of a formula in time is seen to change on the span: neighbouring numbers.
    fn changes(&self, e: Expr) -> Vec<(f64, f64)> {
        let Some(mut value) = self.value(e) else { return Vec::new() };
        let (from, to) = self.span;
        let place = |k: u32| from + (to - from) * f64::from(k) / f64::from(LOOKS);
        let mut out = Vec::new();
        for k in 0..LOOKS {
            let (mut a, mut b) = (place(k), place(k + 1));
            let (Some(at_a), Some(at_b)) = (value(a), value(b)) else { continue };
            if at_a != 0.0 && at_b != 0.0 && (at_a > 0.0) == (at_b > 0.0) {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                match value(middle) {
                    Some(v) if v != 0.0 && (v > 0.0) == (at_a > 0.0) && at_a != 0.0 => a = middle,
                    _ => b = middle,
                }
            }
            out.push((a, b));
        }
        out
    }

    /// The values of a formula in time.
    fn value(&self, e: Expr) -> Option<impl FnMut(f64) -> Option<f64>> {
        let tape = Tape::compile(&self.graph, &[self.time], &[e]).ok()?;
        let mut slots = tape.slots::<Bounded>(&());
        Some(move |t: f64| {
            tape.evaluate(&(), &[Ok(Bounded::exact(t))], &mut slots).pop()?.ok().map(|v: Bounded| v.value)
        })
    }

    /// A time that may count at which the formula for a rate may have no value: there may be no rate, as at a kink.
    fn may_lack_a_rate(&mut self, claim: &Claim, guards: &InTime, part: &Part) -> Option<f64> {
        let sides: Vec<Expr> = part.group.comparisons.iter().flat_map(|c| [c.left, c.right]).collect();
        let moves = |l: &Leaf| l.rate > 0 && l.instant.is_none();
        let sides: Vec<Expr> = sides.into_iter().filter(|&e| self.graph.leaves([e]).iter().any(moves)).collect();
        let sides: Vec<Expr> = sides.into_iter().filter_map(|e| self.put(&claim.scope, e)).collect();
        let needs: Vec<Expr> = self.graph.needs_below(sides).into_iter().map(|n| n.value).collect();
        let may_count = |t: f64, (e, sign): (Expr, Sign)| {
            let value = self.value(e).and_then(|mut value| value(t));
            sign == Sign::NotZero || value.is_none_or(|v| v >= -f64::EPSILON)
        };
        let changes = needs.into_iter().flat_map(|e| self.changes(self.graph.root_of_zeros(e)));
        changes.map(|(a, b)| 0.5 * (a + b)).find(|&t| guards.guards.iter().all(|&guard| may_count(t, guard)))
    }

    /// Whether something has, wherever it has a value, the value that it has at some time of the span that counts.
    fn is_constant(&mut self, claim: &Claim, guards: &InTime, presupposed: &[Expr], e: Expr) -> bool {
        self.needs.clear();
        let Some(e) = self.put(&claim.scope, e) else { return false };
        let mut needs = std::mem::take(&mut self.needs);
        needs.extend(presupposed);
        let (time, (from, to)) = (self.time, self.span);
        [from, 0.5 * (from + to), to].into_iter().any(|at| {
            let Ok(start) = Rational::try_from(at) else { return false };
            let start = self.graph.constant(start);
            let then = self.graph.substitute(e, |_, l| (l == time).then_some(start));
            matches!(self.ask(guards, needs.clone(), (e, then), Refuted::Apart), Along::Agree { seen: Some(_), .. })
        })
    }
}
