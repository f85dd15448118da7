//! Motions that are given by formulas are premises: a claim on one of them is first an identity in time.
//!
//! **In:** the verdicts of claims on motions, from samples. **Out:** the same verdicts, of which some are *proved*: the states
//! are replaced by their formulas, parameters by their exact values, observables by their definitions, rates by derivatives, and
//! values at fixed times by values. What is left is an equation in time alone, which [`along`] decides.
//!
//! **Guaranteed.** *Holds, proved*: every equation of the claim is such an identity, so are the equations among its assumptions,
//! and there is a time that counts at which the sides have values. *Fails, proved*: an equation has sides that differ for certain at a time of
//! the span at which the assumptions hold. Claims of other forms, with ±, limits or `at`, are left as they are.

use super::account::ClaimAccount;
use super::identity::{Along, Apart, InTime, Memory, along};
use super::verdict::{Evidence, Outcome, Strength, Verdict, Witness};
use crate::derivation::{Claim, Derivation, Form, Motion};
use crate::expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational, Symbol};
use crate::latex::{Relation, RelationKind, Scope};
use rayon::prelude::*;

/// Settles what can be settled; `tried` are the motions of the results.
///
/// # Errors
/// A description of a claim that is proved, and fails on samples.
pub(super) fn settle(
    derivation: &Derivation,
    claims: &mut [ClaimAccount],
    claimed: &[usize],
    tried: &[usize],
) -> Result<(), String> {
    let column = |&t: &usize| -> Vec<(usize, usize, Verdict)> {
        let Some(mut setting) = Setting::of(derivation, t) else { return Vec::new() };
        let id = &derivation.trajectories[t].id;
        let mut out = Vec::new();
        for (k, &c) in claimed.iter().enumerate() {
            let Some(at) = claims[k].results.iter().position(|r| r.trajectory == *id) else { continue };
            let before = &claims[k].results[at].verdict;
            if matches!(before.outcome(), Outcome::NotApplicable) {
                continue;
            }
            let Some(answer) = setting.claim(&derivation.claims[c]) else { continue };
            out.push((k, at, answer.verdict(before)));
        }
        out
    };
    let found: Vec<_> = tried.par_iter().with_max_len(1).map(column).collect();
    for (k, at, verdict) in found.into_iter().flatten() {
        let pair = &mut claims[k].results[at];
        if let (Outcome::Fails(_), Outcome::Holds(_)) = (pair.verdict.outcome(), verdict.outcome()) {
            return Err(format!("{} is an identity in time on {}, and fails there", claims[k].id, pair.trajectory));
        }
        pair.verdict = verdict;
    }
    Ok(())
}

/// What was found of a claim on a motion.
enum Answer {
    Holds,
    /// The formula, and where its sides differ.
    Fails(String, Apart),
}

impl Answer {
    fn verdict(self, before: &Verdict) -> Verdict {
        let old = before.evidence().clone();
        match self {
            Answer::Holds => {
                let evidence = Evidence { samples: old.samples.max(1), witness: None, reason: None, ..old };
                Verdict::new(Outcome::Holds(Strength::Proved), evidence)
            }
            Answer::Fails(formula, apart) => {
                let Apart { time, left, right, bound } = apart;
                let witness = Witness { t: time, formula, left, right, bound, values: Vec::new() };
                let reason = format!(
                    "with the formulas of the motion put in it is an equation in time alone, whose sides differ for certain \
                     at t = {time}"
                );
                let evidence = Evidence { witness: Some(witness), reason: Some(reason), ..old };
                Verdict::new(Outcome::Fails(Strength::Proved), evidence)
            }
        }
    }
}

/// A motion by formulas.
struct Setting<'a> {
    derivation: &'a Derivation,
    graph: Graph,
    memory: Memory,
    time: Leaf,
    span: (f64, f64),
    /// Components of states, as formulas in time, and of parameters, as numbers.
    values: FastMap<(Symbol, u16), Expr>,
    /// What has a value wherever the formulas have.
    needs: Vec<Expr>,
}

/// The claim, with everything put in.
#[derive(Default)]
struct Asked {
    guards: InTime,
    hypotheses: Vec<(Expr, Expr)>,
}

impl<'a> Setting<'a> {
    /// The motion, where it is given by formulas in the end.
    fn of(derivation: &'a Derivation, t: usize) -> Option<Setting<'a>> {
        let time = derivation.scope.time()?;
        let trajectory = &derivation.trajectories[t];
        let mut setting = match &trajectory.motion {
            Motion::Integrated { .. } => return None,
            Motion::Formula { .. } => Setting {
                derivation,
                graph: derivation.graph.clone(),
                memory: Memory::default(),
                time,
                span: trajectory.span,
                values: FastMap::default(),
                needs: Vec::new(),
            },
            Motion::Derived { from, .. } => Setting { span: trajectory.span, ..Setting::of(derivation, *from)? },
        };
        let mut known: Vec<(Symbol, Vec<Expr>)> =
            trajectory.parameters.iter().map(|(s, w)| (*s, w.value.clone())).collect();
        setting.note(&mut known);
        let states = match &trajectory.motion {
            Motion::Formula { states } => states,
            Motion::Derived { map, .. } => map,
            Motion::Integrated { .. } => return None,
        };
        for (symbol, written) in states {
            let put: Option<Vec<Expr>> = written.value.iter().map(|&e| setting.put(&derivation.scope, e)).collect();
            known.push((*symbol, put?));
        }
        setting.note(&mut known);
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
        let mut images: FastMap<Leaf, Expr> = FastMap::default();
        for leaf in self.graph.leaves([e]) {
            if leaf != self.time {
                let image = self.leaf(scope, leaf)?;
                images.insert(leaf, image);
            }
        }
        Some(self.graph.substitute(e, |_, l| images.get(&l).copied()))
    }

    fn leaf(&mut self, scope: &Scope, leaf: Leaf) -> Option<Expr> {
        let mut value = match self.values.get(&(leaf.symbol, leaf.component)) {
            Some(&known) => known,
            None => {
                let definition = scope.definition(leaf.symbol)?;
                let component = *definition.components.get(usize::from(leaf.component))?;
                self.put(scope, component)?
            }
        };
        if self.is_angle(leaf.symbol) && self.may_leap(value) {
            return None;
        }
        let now = leaf.instant.is_none();
        self.needs.extend(now.then_some(value));
        for _ in 0..leaf.rate {
            value = self.graph.time_derivative(value, self.time, |_| false).ok()?;
            self.needs.extend(now.then_some(value));
        }
        let Some(instant) = leaf.instant else { return Some(value) };
        let instant = self.put(scope, instant)?;
        let time = self.time;
        let fixed = !self.graph.leaves([instant]).contains(&time);
        fixed.then(|| self.graph.substitute(value, |_, l| (l == time).then_some(instant)))
    }

    fn is_angle(&self, symbol: Symbol) -> bool {
        let of_claims = self.derivation.claims.iter().flat_map(|c| &c.symbols);
        self.derivation.symbols.iter().chain(of_claims).any(|s| s.symbol == symbol && s.angle)
    }

    /// Whether a formula contains what may leap: then an angle is continued across it, and is not its formula.
    fn may_leap(&self, e: Expr) -> bool {
        self.graph.reachable([e]).iter().any(|&e| match *self.graph.node(e) {
            Node::Unary(op, _) => {
                matches!(op, Op::Abs | Op::Arcsin | Op::Arccos | Op::Arctan | Op::Tan | Op::Ln | Op::Sqrt)
                    || matches!(op, Op::Powi(n) if n < 0)
            }
            Node::Binary(op, ..) => matches!(op, Op::Arctan2 | Op::Div | Op::Pow | Op::Agm),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => false,
        })
    }

    fn sides(&mut self, scope: &Scope, relation: &Relation) -> Option<Vec<(Expr, Expr)>> {
        let (left, right) = (&relation.left.components, &relation.right.components);
        left.iter().zip(right).map(|(&l, &r)| Some((self.put(scope, l)?, self.put(scope, r)?))).collect()
    }

    /// What selects times, and what must hold at all of them; `None` for assumptions of other kinds.
    fn assumptions(&mut self, claim: &Claim) -> Option<Asked> {
        let mut out = Asked::default();
        for relation in claim.assuming.iter().flat_map(|w| &w.value.relations) {
            if relation.limit.is_some() || relation.has_branches {
                return None;
            }
            let sides = self.sides(&claim.scope, relation)?;
            if relation.kind == RelationKind::NotEqual && sides.len() > 1 {
                return None;
            }
            for (l, r) in sides {
                let (over, under) = (self.graph.sub(l, r), self.graph.sub(r, l));
                match relation.kind {
                    RelationKind::Equal => out.hypotheses.push((l, r)),
                    RelationKind::NotEqual => out.guards.nonzero.push(over),
                    RelationKind::Greater => out.guards.positive.push(over),
                    RelationKind::Less => out.guards.positive.push(under),
                    RelationKind::GreaterEqual => out.guards.not_negative.push(over),
                    RelationKind::LessEqual => out.guards.not_negative.push(under),
                }
            }
        }
        Some(out)
    }

    fn ask(&mut self, asked: &Asked, needs: Vec<Expr>, sides: (Expr, Expr)) -> Along {
        let question =
            InTime { time: Some(self.time), span: self.span, sides: Some(sides), needs, ..asked.guards.clone() };
        along(&mut self.memory, &mut self.graph, &question)
    }

    fn claim(&mut self, claim: &Claim) -> Option<Answer> {
        if claim.at.is_some() || claim.region.is_some() {
            return None;
        }
        self.needs.clear();
        let asked = self.assumptions(claim)?;
        let presupposed = std::mem::take(&mut self.needs);
        for &sides in &asked.hypotheses {
            match self.ask(&asked, presupposed.clone(), sides) {
                Along::Agree { seen: Some(_), .. } => {}
                _ => return None,
            }
        }
        let mut holds = true;
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    for relation in &w.value.relations {
                        if relation.kind != RelationKind::Equal || relation.limit.is_some() || relation.has_branches {
                            holds = false;
                            continue;
                        }
                        match self.relation(claim, &asked, relation, &w.text, false) {
                            Some(Answer::Holds) => {}
                            None => holds = false,
                            refuted => return refuted,
                        }
                    }
                }
                Form::Solves { system } => {
                    let derivation = self.derivation;
                    for w in &derivation.systems[*system].equations {
                        for relation in &w.value.relations {
                            match self.relation(claim, &asked, relation, &w.text, true) {
                                Some(Answer::Holds) => {}
                                None => holds = false,
                                refuted => return refuted,
                            }
                        }
                    }
                }
                Form::FirstIntegral(w) => {
                    holds &= w.value.components.iter().all(|&e| self.is_constant(claim, &asked, e) == Some(true));
                }
                Form::Never(_)
                | Form::Eventually(_)
                | Form::Defined(_)
                | Form::SameMotion { .. }
                | Form::Independent { .. }
                | Form::Exists { .. } => holds = false,
            }
        }
        holds.then_some(Answer::Holds)
    }

    /// An equation of a claim; `asserted`, it must have a value at every time.
    fn relation(
        &mut self,
        claim: &Claim,
        asked: &Asked,
        relation: &Relation,
        text: &str,
        asserted: bool,
    ) -> Option<Answer> {
        let mut holds = true;
        for at in 0..relation.left.components.len() {
            let (&l, &r) = (relation.left.components.get(at)?, relation.right.components.get(at)?);
            self.needs.clear();
            let sides = self.put(&claim.scope, l).zip(self.put(&claim.scope, r));
            let needs = std::mem::take(&mut self.needs);
            let Some(sides) = sides else {
                holds = false;
                continue;
            };
            match self.ask(asked, needs, sides) {
                Along::Agree { everywhere, seen: Some(_) } if everywhere || !asserted => {}
                Along::Differ(apart) => return Some(Answer::Fails(text.to_owned(), apart)),
                Along::Agree { .. } | Along::Open => holds = false,
            }
        }
        holds.then_some(Answer::Holds)
    }

    /// Whether something has, wherever it has a value, the value that it has at some time of the span.
    fn is_constant(&mut self, claim: &Claim, asked: &Asked, e: Expr) -> Option<bool> {
        self.needs.clear();
        let e = self.put(&claim.scope, e)?;
        let needs = std::mem::take(&mut self.needs);
        let (time, (from, to)) = (self.time, self.span);
        for at in [from, 0.5 * (from + to), to] {
            let start = Rational::try_from(at).ok()?;
            let start = self.graph.constant(start);
            let then = self.graph.substitute(e, |_, l| (l == time).then_some(start));
            if let Along::Agree { seen: Some(_), .. } = self.ask(asked, needs.clone(), (e, then)) {
                return Some(true);
            }
        }
        None
    }
}
