//! What was found about a step, as the account has it.

use super::{Pairs, Step, pairs};
use crate::agreement::EITHER_SIGN;
use crate::derivation::{Form, Premise};
use crate::expr::domain::{Change, EdgeOf};
use crate::expr::{Expr, Graph, Leaf, Node, Op, Symbol};
use crate::findings::standing::{Exception, Finding, Void};
use crate::findings::{IdentityAccount, IdentityEvidence};
use crate::latex::{RelationKind, Role};
use order::{Question, Requirement};
use proof::{Condition, Identity, Point, PointValue, Reason, Refutation, Side, domains, order};

/// Most characters of a formula that is shown whole.
const LONGEST: usize = 160;
/// Most parameters whose orders of size are listed: four have 75.
const MOST_ORDERED: usize = 3;
/// Most names that are listed for one that is not.
const MOST_NAMES: usize = 6;

/// Why a proof of what may say nothing is none.
const NOWHERE: &str = "both sides are equal wherever they have values, but no real point was found that satisfies what is \
                       given and at which they have some";
/// Why a proof with exceptions is none.
const UNSEEN: &str = "it was proved outside of special cases only, and no real point was found outside of them";

impl Step<'_> {
    /// What a proof that goes along a motion does not reach.
    pub(super) fn continuation(&mut self, equations: &Pairs, moved: bool, leaping: &[Expr]) -> Vec<Exception> {
        let integral = self.claim.forms.iter().any(|form| matches!(form, Form::FirstIntegral(_)));
        if !(moved || integral) {
            return Vec::new();
        }
        let mut out: Vec<Exception> = leaping.iter().map(|&e| Exception::Leaps(e)).collect();
        let divided = self.divided_by_systems();
        let mut roots = self.along(equations);
        self.add_definitions(&mut roots);
        for under in self.poles(roots) {
            let mut base = under;
            while let Node::Unary(Op::Powi(_) | Op::Sqrt | Op::Abs, a) = *self.graph.node(base) {
                base = a;
            }
            if divided.contains(&under) || divided.contains(&base) || !self.moves(base) {
                continue;
            }
            let one = Exception::Divides(base);
            if !out.contains(&one) {
                out.push(one);
            }
        }
        out
    }

    /// Whether equations with ±, of which one sign is proved, have values at the same points with either sign, all together. Where
    /// some has none and another is false with the other sign, the claim is false: a sign for which it has no value does not
    /// count.
    pub(super) fn has_values_together(
        &mut self,
        equations: &Pairs,
        identity: &Identity,
        evidence: &IdentityEvidence,
    ) -> bool {
        let Identity::Proved(proof) = identity else { return true };
        let sign = self.claim.scope.branch_sign();
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let free = self.claim.branches_throughout || evidence.branch.as_deref() == Some(EITHER_SIGN);
        if free || !self.graph.leaves_within(roots).contains(&sign) {
            return true;
        }
        // Sides that are one expression are no equation, and have no value where it has none.
        let relations = self.claim.forms.iter().flat_map(|form| {
            let Form::Always(w) = form else { return &[][..] };
            &w.value.relations
        });
        let same: Pairs = relations.flat_map(pairs).filter(|(l, r)| l == r).collect();
        let depends = |graph: &mut Graph, e: Expr| {
            graph.needs_below([e]).iter().any(|n| !graph.leaves_within([n.value]).is_empty())
        };
        if proof.conditions.is_empty() && !same.iter().any(|&(l, _)| depends(&mut self.graph, l)) {
            return true;
        }
        let mut both = [1, -1].map(|value| self.branch(equations, value));
        both[0].extend(same);
        let mut needs = both.iter().flatten().map(|&(l, r)| {
            let mut needs: Vec<_> = self.graph.needs_below([l, r]).iter().map(|n| (n.value, n.sign)).collect();
            needs.sort_unstable();
            needs.dedup();
            needs
        });
        let first = needs.next();
        needs.all(|n| Some(n) == first)
    }

    /// What lies beyond something, in words.
    fn beyond_in_words(&self, exceptions: &[Exception]) -> Vec<String> {
        let mut out: Vec<String> = Vec::new();
        for exception in exceptions {
            let line = match *exception {
                Exception::Leaps(e) => format!("beyond a time at which {} leaps", self.shown(e)),
                Exception::Divides(e) => {
                    format!("beyond a time at which {} = 0, unless the motion is analytic there", self.shown(e))
                }
                Exception::OneSign => "where some of it has no value: the other sign counts there".to_owned(),
                Exception::Vanishes(_) => continue,
            };
            if !out.contains(&line) {
                out.push(line);
            }
        }
        out
    }

    /// Whether a proof holds where something that moves is not negative, or lies in [−1, 1], for which neither the claim asks nor a
    /// system: what is given has no value beyond, and says nothing there. At single times, as those at which a denominator is 0,
    /// the sides are what they tend to.
    pub(super) fn is_narrower(&mut self, identity: &Identity, equations: &Pairs) -> bool {
        let Identity::Proved(proof) = identity else { return false };
        let beyond = |c: &Condition| match *c {
            Condition::Radicand(e) | Condition::Unit(e) | Condition::Positive(e) => Some(e),
            Condition::Denominator(_) | Condition::Pivot(_) | Condition::Discriminant(_) => None,
        };
        let asked: Vec<Condition> =
            proof.conditions.iter().filter(|c| beyond(c).is_some_and(|e| self.moves(e))).copied().collect();
        if asked.is_empty() {
            return false;
        }
        let mut roots = self.along(equations);
        roots.extend(self.sides_of_systems());
        self.add_definitions(&mut roots);
        let own = domains(&mut self.graph, &roots);
        asked.iter().any(|c| !own.contains(c))
    }

    /// What is claimed along a motion.
    fn along(&self, equations: &Pairs) -> Vec<Expr> {
        let integrals = self.claim.forms.iter().filter_map(|form| match form {
            Form::FirstIntegral(w) => Some(w.value.components.clone()),
            _ => None,
        });
        integrals.flatten().chain(equations.iter().flat_map(|&(l, r)| [l, r])).collect()
    }

    /// The functions with several branches in what is claimed along a motion.
    pub(super) fn leaps(&mut self, equations: &Pairs) -> Vec<Expr> {
        let mut roots = self.along(equations);
        self.add_definitions(&mut roots);
        let divided = self.divided_by_systems();
        let mut out = self.graph.reachable(roots);
        out.retain(|&e| {
            // A motion of a system that divides by a root does not pass its zero.
            let root = matches!(self.graph.node(e), Node::Unary(Op::Sqrt, _)) && divided.contains(&e);
            !root && self.is_branching(e)
        });
        out
    }

    /// Whether an operation passes from one of its branches to another, if its arguments move so: at an edge that is no pole.
    fn is_branching(&mut self, e: Expr) -> bool {
        let arguments: Vec<Expr> = self.graph.node(e).children().collect();
        self.graph.edges(e).into_iter().any(|edge| match edge.change {
            // Both sides of a pole belong to the same function; a pole with one side comes with the base of a power.
            Change::Pole(..) => false,
            Change::Log | Change::Jump(_) | Change::Kink | Change::Steep => match edge.vanishing {
                Some(_) => arguments.iter().any(|&a| self.moves(a)),
                None => arguments.iter().any(|&a| self.has_poles(a)),
            },
        })
    }

    /// What vanishes where something below is infinite.
    fn poles(&mut self, roots: Vec<Expr>) -> Vec<Expr> {
        let mut out = Vec::new();
        for e in self.graph.reachable(roots) {
            let poles = self.graph.edges(e).into_iter().filter(EdgeOf::is_pole);
            out.extend(poles.filter_map(|edge| edge.vanishing));
        }
        out
    }

    /// The sides of the equations of the systems among the premises.
    fn sides_of_systems(&self) -> Vec<Expr> {
        let given = Step::given(self.derivation, self.claim);
        let systems = given.iter().filter_map(|name| match self.derivation.premise(name) {
            Premise::System(system) => Some(&self.derivation.systems[system]),
            Premise::Claim(_) | Premise::Definition => None,
        });
        let relations = systems.flat_map(|s| &s.equations).flat_map(|w| &w.value.relations);
        relations.flat_map(pairs).flat_map(|(l, r)| [l, r]).collect()
    }

    /// Everything that the systems among the premises divide by, as it stands and by its definition.
    fn divided_by_systems(&mut self) -> Vec<Expr> {
        let mut roots = self.sides_of_systems();
        self.add_definitions(&mut roots);
        let mut open = self.poles(roots);
        let mut out = Vec::new();
        while let Some(e) = open.pop() {
            if out.contains(&e) {
                continue;
            }
            out.push(e);
            match *self.graph.node(e) {
                Node::Unary(Op::Powi(_), a) => open.push(a),
                Node::Binary(Op::Mul, a, b) => open.extend([a, b]),
                Node::Leaf(leaf) if leaf.rate == 0 && leaf.instant.is_none() => {
                    let definition = self.claim.scope.definition(leaf.symbol);
                    open.extend(definition.and_then(|d| d.components.get(usize::from(leaf.component)).copied()));
                }
                _ => {}
            }
        }
        out
    }

    /// Adds the definitions of the observables that occur; of angles, which are continued along the motion, without the
    /// leaps by whole turns that the continuation heals.
    pub(super) fn add_definitions(&self, roots: &mut Vec<Expr>) {
        let mut seen: Vec<Symbol> = Vec::new();
        let mut open = roots.clone();
        while !open.is_empty() {
            let mut found: Vec<Expr> = Vec::new();
            for leaf in self.graph.leaves_within(open) {
                if seen.contains(&leaf.symbol) {
                    continue;
                }
                seen.push(leaf.symbol);
                let definition = self.claim.scope.definition(leaf.symbol);
                for &e in definition.into_iter().flat_map(|d| &d.components) {
                    match self.derivation.is_angle(leaf.symbol) {
                        true => self.healed(e, &mut found),
                        false => found.push(e),
                    }
                }
            }
            roots.extend(&found);
            open = found;
        }
    }

    /// What an angle is made of, but arguments in place of atan2 that stands in it with a whole factor: its leaps by 2π are
    /// healed.
    fn healed(&self, e: Expr, out: &mut Vec<Expr>) {
        let whole = |e: Expr| self.graph.as_constant(e).is_some_and(|r| r.denominator().is_one());
        match *self.graph.node(e) {
            Node::Binary(Op::Arctan2, y, x) => out.extend([y, x]),
            Node::Unary(Op::Neg, a) => self.healed(a, out),
            Node::Binary(Op::Add | Op::Sub, a, b) => {
                self.healed(a, out);
                self.healed(b, out);
            }
            Node::Binary(Op::Mul, a, b) if whole(a) => self.healed(b, out),
            Node::Binary(Op::Mul, a, b) if whole(b) => self.healed(a, out),
            _ => out.push(e),
        }
    }

    /// Whether something changes along a motion.
    fn moves(&self, e: Expr) -> bool {
        let scope = &self.claim.scope;
        let moves = |l: &Leaf| {
            let role = scope.role(l.symbol);
            l.instant.is_none() && matches!(role, Some(Role::State | Role::Observable)) || Some(*l) == scope.time()
        };
        self.graph.leaves_within([e]).iter().any(moves)
    }

    /// Whether something may be infinite at some time.
    fn has_poles(&mut self, e: Expr) -> bool {
        let mut roots = vec![e];
        self.add_definitions(&mut roots);
        self.poles(roots).into_iter().any(|under| self.moves(under))
    }

    pub(super) fn shown(&self, e: Expr) -> String {
        let text = self.graph.to_latex(e);
        // Names of auxiliary numbers begin with an invisible character.
        let auxiliary = text.contains('\u{2063}');
        if text.len() <= LONGEST && !auxiliary {
            text
        } else {
            let mut names: Vec<String> =
                self.graph.leaves_within([e]).iter().map(|&l| self.graph.leaf_latex(l)).collect();
            names.retain(|n| !n.contains('\u{2063}'));
            names.dedup();
            if names.is_empty() {
                names.push("auxiliary numbers".to_owned());
            }
            let more = names.len().saturating_sub(MOST_NAMES);
            names.truncate(MOST_NAMES);
            let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
            format!("(an expression in {}{rest}, too long to print)", names.join(", "))
        }
    }

    fn point(&self, refutation: &Refutation, point: &Point) -> String {
        let value = |(leaf, value): &(Leaf, PointValue)| {
            let name = self.graph.leaf_latex(*leaf);
            match (&value.exact, &value.circle) {
                (Some(r), _) => format!("{name} = {r}"),
                (None, Some((c, s))) => format!("cos {name} = {c}, sin {name} = {s}"),
                (None, None) => format!("{name} = {}", value.decimal),
            }
        };
        let [named, beyond] = refutation.parted(point);
        let more = match beyond.len() {
            0 => None,
            n => Some(format!("{n} more values, by which what is given holds")),
        };
        named.into_iter().map(value).chain(more).collect::<Vec<_>>().join("; ")
    }

    /// What an answer says of the claim, nothing being given.
    pub fn of_identity(&mut self, identity: Identity, evidence: IdentityEvidence) -> IdentityAccount {
        IdentityAccount { evidence, ..self.account(identity, Vec::new(), true) }
    }

    /// The account of an answer, in the words of the finding.
    pub(super) fn account(&mut self, identity: Identity, from: Vec<String>, complete: bool) -> IdentityAccount {
        self.account_along(identity, from, complete, Vec::new())
    }

    /// The same; `along` is what a proof along motions does not reach.
    pub(super) fn account_along(
        &mut self,
        identity: Identity,
        from: Vec<String>,
        complete: bool,
        along: Vec<Exception>,
    ) -> IdentityAccount {
        let finding = Finding::weigh(&self.graph, &identity, complete, along);
        let mut out = IdentityAccount { finding, from, ..IdentityAccount::default() };
        match identity {
            Identity::Proved(proof) => {
                for condition in &proof.conditions {
                    let (list, line) = match condition {
                        Condition::Denominator(e) => (&mut out.conditions, format!("{} ≠ 0", self.shown(*e))),
                        Condition::Pivot(e) => (&mut out.exceptions, format!("{} = 0", self.shown(*e))),
                        Condition::Radicand(e) => (&mut out.conditions, format!("{} ≥ 0", self.shown(*e))),
                        Condition::Discriminant(e) => (&mut out.given_only_where, format!("{} ≥ 0", self.shown(*e))),
                        Condition::Unit(e) => (&mut out.conditions, format!("|{}| ≤ 1", self.shown(*e))),
                        Condition::Positive(e) => (&mut out.conditions, format!("{} > 0", self.shown(*e))),
                    };
                    if !list.contains(&line) {
                        list.push(line);
                    }
                }
                // The short ones first; not in the order of the graph, which depends on what was written before.
                for list in [&mut out.conditions, &mut out.exceptions, &mut out.given_only_where] {
                    list.sort_by(|a, b| (a.chars().count(), a).cmp(&(b.chars().count(), b)));
                }
                let discriminant = |c: &Condition| matches!(c, Condition::Discriminant(_));
                if let Some(words) = self.orders_of(&proof.conditions) {
                    // What only the premises ask for does not restrict the claim.
                    let list = match proof.conditions.iter().any(discriminant) {
                        true => &mut out.given_only_where,
                        false => &mut out.conditions,
                    };
                    list.push(words);
                }
                let lines = self.beyond_in_words(out.finding.exceptions());
                out.exceptions.extend(lines);
                out.generic = !out.finding.exceptions().is_empty();
                out.log2_error = out.finding.is_proved_in_part().then_some(proof.log2_error);
                out.reason = match out.finding.void() {
                    Some(Void::NoValue) => Some("what is given makes a formula have no value".to_owned()),
                    Some(Void::OnlySpecial) => Some(UNSEEN.to_owned()),
                    Some(Void::Unseen) => Some(NOWHERE.to_owned()),
                    Some(Void::Incomplete) | None => out.reason,
                };
            }
            Identity::Refuted(refutation) if complete => {
                let side = |s: &Side| match &s.exact {
                    Some(r) => r.to_string(),
                    None => s.decimal.to_string(),
                };
                let mut text = format!(
                    "left {}, right {} at {}",
                    side(&refutation.left),
                    side(&refutation.right),
                    self.point(&refutation, &refutation.point)
                );
                if let Some((point, left, right)) = &refutation.second {
                    text.push_str(&format!(
                        " — and left {}, right {} at {}: what is given leaves the difference open",
                        side(left),
                        side(right),
                        self.point(&refutation, point)
                    ));
                }
                out.witness = Some(text);
            }
            Identity::Refuted(_) => {
                out.reason = Some("refuted without something given that could not be used".to_owned());
            }
            Identity::Undecided(Reason::OnlyWhere(e)) => {
                out.reason =
                    Some(format!("what is given holds at most where {} = 0, which was not decided", self.shown(e)));
            }
            Identity::Undecided(Reason::Boundary(e)) => {
                out.reason = Some(format!(
                    "what is given holds at most where {} = 0, the base of a power, which was not decided",
                    self.shown(e)
                ));
            }
            Identity::Undecided(Reason::Unsolved(e)) => {
                out.reason =
                    Some(format!("a premise could not be solved for any of its unknowns: {} = 0", self.shown(e)));
            }
            Identity::Undecided(reason) => out.reason = Some(reason.to_string()),
        }
        out
    }

    /// For which orders of positive parameters conditions about them hold; nothing where there are none.
    fn orders_of(&mut self, conditions: &[Condition]) -> Option<String> {
        let restricting: Vec<Condition> =
            conditions.iter().filter(|c| !matches!(c, Condition::Pivot(_))).copied().collect();
        let roots = restricting.iter().map(|c| match *c {
            Condition::Denominator(e) | Condition::Radicand(e) | Condition::Unit(e) | Condition::Positive(e) => e,
            Condition::Pivot(e) | Condition::Discriminant(e) => e,
        });
        let leaves = self.graph.leaves_within(roots);
        let parameters: Vec<Leaf> = leaves.into_iter().filter(|&l| self.is_positive_parameter(l)).collect();
        let all = order::of_conditions(&mut self.graph, &restricting, &parameters);
        let roots: Vec<Expr> = all.iter().map(|&(_, e)| e).collect();
        let mut parameters = self.graph.leaves_within(roots);
        parameters.sort_unstable();
        if parameters.len() < 2 {
            return None;
        }
        let question = Question { parameters, assumed: Vec::new(), claimed: all, asserted: true };
        let found = self.order_of(&question)?;
        found.tells().then(|| words_of(&self.graph, &question, &found, ", so far as it is about them, that is so"))
    }

    /// In which orders of the sizes of its parameters a claim holds; `None` of many: a long list of orders tells less than the
    /// conditions themselves.
    fn order_of(&mut self, question: &Question) -> Option<order::Orders> {
        (question.parameters.len() <= MOST_ORDERED).then(|| order::decide(&mut self.graph, question))
    }

    /// The claim, about positive parameters only, as requirements of signs.
    pub(super) fn order_question(&mut self) -> Question {
        let claim = self.claim;
        let mut out = Question::default();
        let requirements = |this: &mut Self, kind: RelationKind, l: Expr, r: Expr| match kind {
            RelationKind::Equal => (Requirement::Zero, this.graph.sub(l, r)),
            RelationKind::NotEqual => (Requirement::NotZero, this.graph.sub(l, r)),
            RelationKind::Greater => (Requirement::Positive, this.graph.sub(l, r)),
            RelationKind::GreaterEqual => (Requirement::NotNegative, this.graph.sub(l, r)),
            RelationKind::Less => (Requirement::Positive, this.graph.sub(r, l)),
            RelationKind::LessEqual => (Requirement::NotNegative, this.graph.sub(r, l)),
        };
        for relation in claim.assuming.iter().flat_map(|w| &w.value.relations) {
            for (l, r) in self.scalars(relation) {
                let one = requirements(self, relation.kind, l, r);
                out.assumed.push(one);
            }
        }
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    for relation in &w.value.relations {
                        for (l, r) in self.scalars(relation) {
                            let one = requirements(self, relation.kind, l, r);
                            out.claimed.push(one);
                        }
                    }
                }
                Form::Defined(w) => {
                    out.asserted = true;
                    let leaves = self.graph.leaves_within(w.value.components.iter().copied());
                    let domains = proof::domains(&mut self.graph, &w.value.components);
                    out.claimed.extend(order::of_conditions(&mut self.graph, &domains, &leaves));
                }
                _ => {}
            }
        }
        let roots: Vec<Expr> = out.assumed.iter().chain(&out.claimed).map(|&(_, e)| e).collect();
        out.parameters = self.graph.leaves_within(roots);
        out.parameters.sort_unstable();
        out
    }

    /// For which orders of the parameters the claim holds, as conditions.
    pub(super) fn where_real(mut self) -> Vec<String> {
        let question = self.order_question();
        let found = self.order_of(&question).filter(order::Orders::tells);
        found.map(|found| words_of(&self.graph, &question, &found, MEETING)).into_iter().collect()
    }

    /// The account of a claim about parameters.
    pub(super) fn account_of_order(&mut self, question: &Question, found: order::Orders) -> IdentityAccount {
        let names: Vec<String> = question.parameters.iter().map(|&l| self.graph.leaf_latex(l)).collect();
        let words = || words_of(&self.graph, question, &found, MEETING);
        let mut out = IdentityAccount {
            finding: Finding::of_signs(&found),
            conditions: (names.len() <= MOST_ORDERED).then(words).into_iter().collect(),
            ..IdentityAccount::default()
        };
        if found.is_proved() {
            out.reason = None;
        } else if let Some(values) = found.refuting() {
            let values: Vec<String> = names.iter().zip(&values).map(|(n, v)| format!("{n} = {v}")).collect();
            out.witness = Some(format!("it does not hold for {}", values.join("; ")));
        } else {
            out.reason =
                Some("the signs of the coefficients do not decide in every order of the parameters".to_owned());
        }
        out
    }
}

/// Said of parameters of a claim.
const MEETING: &str = " that meet the assumptions it holds";

/// In which orders of the sizes of its parameters something is so.
fn words_of(graph: &Graph, question: &Question, found: &order::Orders, that: &str) -> String {
    let names: Vec<String> = question.parameters.iter().map(|&l| graph.leaf_latex(l)).collect();
    format!("for positive {}{that} {}", names.join(", "), found.words(&names))
}
