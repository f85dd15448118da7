//! What a claim denotes: the only reader of its forms.
//!
//! **In:** a claim as the file has it. **Out:** a proposition over parts ([`Program`]): each part speaks of all times that
//! count, by a group of comparisons that is true or false at each of them; the proposition says how the parts make the claim.
//!
//! **Guaranteed.** `docs/semantics.md` and this file say the same. In particular: `never` R is `always` not R, and `eventually`
//! R is not `always` not R, exactly; `u \ne v` says that some component differs; one ± in one text and one claim is one sign.
//! Negations are carried down to the comparisons, where ¬(l < r) is l ≥ r: both say nothing where a side has no value.

use crate::comparison::{Comparison, Group, at_instant, boundaries, cuts, presupposed, traced, traced_without_angles};
use crate::denial::{Denial, denied};
use crate::derivation::{Claim, Form, Written};
use crate::expr::domain::Sign;
use crate::expr::{Expr, FastSet, Graph, Leaf, Node, Op, Rational, Tensor};
use crate::flow::may_hide;
use crate::label::label;
use crate::latex::{Relation, RelationKind, Role, Scope, Statement};
use crate::program::{Assumption, Denoted, Part, Program, What};
use crate::surroundings::Surroundings;
use crate::verdict::{Proposition, Quantifier};

/// The sum of squares of left − right, which vanishes where an equation holds; left − right itself for a scalar.
fn vanishing(graph: &mut Graph, relation: &Relation) -> Option<Expr> {
    if relation.kind != RelationKind::Equal {
        return None;
    }
    let pairs = relation.left.components.iter().zip(&relation.right.components);
    let differences: Vec<Expr> = pairs.map(|(&l, &r)| graph.sub(l, r)).collect();
    if let [single] = differences.as_slice() {
        return Some(*single);
    }
    let mut sum = graph.integer(0);
    for d in differences {
        let square = graph.powi(d, 2);
        sum = graph.add(sum, square);
    }
    Some(sum)
}

/// The relation that holds where another does not.
fn opposite(kind: RelationKind) -> RelationKind {
    match kind {
        RelationKind::Equal => RelationKind::NotEqual,
        RelationKind::NotEqual => RelationKind::Equal,
        RelationKind::Less => RelationKind::GreaterEqual,
        RelationKind::LessEqual => RelationKind::Greater,
        RelationKind::Greater => RelationKind::LessEqual,
        RelationKind::GreaterEqual => RelationKind::Less,
    }
}

/// The relation of the sides exchanged.
fn turned(kind: RelationKind) -> RelationKind {
    match kind {
        RelationKind::Equal => RelationKind::Equal,
        RelationKind::NotEqual => RelationKind::NotEqual,
        RelationKind::Less => RelationKind::Greater,
        RelationKind::LessEqual => RelationKind::GreaterEqual,
        RelationKind::Greater => RelationKind::Less,
        RelationKind::GreaterEqual => RelationKind::LessEqual,
    }
}

/// Whether both sides are the same at every time: parameters, and values at fixed times.
fn is_constant(graph: &Graph, scope: &Scope, relation: &Relation) -> bool {
    let all = relation.left.components.iter().chain(&relation.right.components).copied();
    graph.leaves_within(all).iter().all(|l| l.instant.is_some() || scope.role(l.symbol) == Some(Role::Parameter))
}

/// The conditions under which every operation of an expression has a value, observables traced back; and what vanishes where
/// it is not known whether there is a value: edges of a rate.
fn domain_conditions(graph: &mut Graph, scope: &Scope, w: &Written<Tensor>) -> (Vec<Comparison>, Vec<Expr>) {
    let all: Vec<Expr> = w.value.components.iter().flat_map(|&e| presupposed(graph, scope, e)).collect();
    let zero = graph.integer(0);
    let (mut out, mut edges) = (Vec::new(), Vec::new());
    for need in graph.needs_below(all) {
        // What does not depend on anything is settled by the value itself.
        if graph.leaves_within([need.value]).is_empty() {
            continue;
        }
        let label = format!("{} has a value", w.text);
        let value = if need.sign == Sign::NotZero { graph.root_of_zeros(need.value) } else { need.value };
        let condition = Comparison::new(graph, scope, label, relation(need.sign), value, zero);
        match need.certain {
            true => out.push(condition),
            false => edges.extend(condition.boundaries),
        }
    }
    (out, edges)
}

/// The sides in which something that moves is in an exponential, a power or a quotient: they may vary more rapidly
/// than a motion is sampled. For each sign of ±; observables traced back.
pub fn rapid(graph: &mut Graph, scope: &Scope, sides: Vec<Expr>) -> Vec<Expr> {
    let moves = |l: &Leaf| l.instant.is_none() && scope.role(l.symbol) != Some(Role::Parameter);
    let mut sides: Vec<Expr> = sides.into_iter().map(|e| traced(graph, scope, e)).collect();
    let (mut moving, mut hiding): (FastSet<Expr>, FastSet<Expr>) = Default::default();
    for e in graph.reachable(sides.iter().copied()) {
        let node = graph.node(e);
        let of = |set: &FastSet<Expr>| node.children().any(|child| set.contains(&child));
        let (moved, mut hides) = (of(&moving) || matches!(node, Node::Leaf(leaf) if moves(leaf)), of(&hiding));
        match node {
            Node::Unary(op, a) => hides |= may_hide(*op, [moving.contains(a), false]),
            Node::Binary(op, a, b) => hides |= may_hide(*op, [a, b].map(|e| moving.contains(e))),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => {}
        }
        moving.extend(moved.then_some(e));
        hiding.extend(hides.then_some(e));
    }
    sides.retain(|e| hiding.contains(e));
    let sign = scope.branch_sign();
    let signed = |e: Expr| [1, -1].map(|n| graph.rewrite(e, |g, l| (l == sign).then(|| g.integer(n))));
    let mut out: Vec<Expr> = sides.into_iter().flat_map(signed).collect();
    out.sort_unstable();
    out.dedup();
    out
}

/// What must be positive for the sides to have values, or, with `true`, must not be negative, as it is under a root: where that
/// is negative and touches 0, they have values at single times.
fn edges<'c>(graph: &mut Graph, scope: &Scope, compared: impl Iterator<Item = &'c Comparison>) -> Vec<(Expr, bool)> {
    let sides: Vec<Expr> = compared.flat_map(|c| [c.left, c.right]).map(|e| traced(graph, scope, e)).collect();
    let needs = graph.implied_below(sides).into_iter();
    let mut out: Vec<(Expr, bool)> = needs
        .filter_map(|n| match n.sign {
            Sign::NotNegative => Some((n.value, true)),
            Sign::Positive => Some((n.value, false)),
            Sign::NotZero => None,
        })
        .filter(|&(e, _)| !graph.leaves_within([e]).is_empty())
        .collect();
    out.sort_unstable();
    out.dedup();
    out
}

/// What some comparisons of a group with ±, or one sign, need to have a value, and others do not.
fn one_sided(graph: &mut Graph, scope: &Scope, group: &Group) -> Vec<Expr> {
    if !group.chooses() {
        return Vec::new();
    }
    let sign = scope.branch_sign();
    let mut all: Vec<Vec<Expr>> = Vec::new();
    for c in &group.comparisons {
        let sides = [c.left, c.right].map(|e| traced(graph, scope, e));
        for n in [1, -1] {
            let of_sign = sides.map(|e| graph.rewrite(e, |g, l| (l == sign).then(|| g.integer(n))));
            let mut needs: Vec<Expr> = graph.needs_below(of_sign).iter().map(|need| need.value).collect();
            needs.sort_unstable();
            needs.dedup();
            all.push(needs);
        }
    }
    let mut some: Vec<Expr> = all.iter().flatten().copied().collect();
    some.sort_unstable();
    some.dedup();
    some.retain(|e| !all.iter().all(|needs| needs.contains(e)) && !graph.leaves_within([*e]).is_empty());
    some
}

/// What is asked of a term, as a relation to 0.
pub fn relation(sign: Sign) -> RelationKind {
    match sign {
        Sign::Positive => RelationKind::Greater,
        Sign::NotNegative => RelationKind::GreaterEqual,
        Sign::NotZero => RelationKind::NotEqual,
    }
}

/// What vanishes where the first relation of a statement holds, for events.
pub fn at_event(graph: &mut Graph, statement: &Statement) -> Option<Expr> {
    statement.relations.first().and_then(|r| vanishing(graph, r))
}

impl Program {
    /// A claim of a file, or beside it, not compiled yet; `initial_time` is that of the motion at hand.
    pub fn new(graph: &mut Graph, surroundings: Surroundings, claim: &Claim, initial_time: &Rational) -> Program {
        let mut program: Program = denote(graph, surroundings, claim, initial_time).into();
        program.leaps_at = !cuts(graph, &claim.scope, program.at).is_empty();
        program
    }
}

/// What a claim denotes on motions that begin at `initial_time`.
pub fn denote(graph: &mut Graph, surroundings: Surroundings, claim: &Claim, initial_time: &Rational) -> Denoted {
    let start = graph.constant(initial_time.clone());
    let sign = claim.scope.branch_sign();
    let branches = |w: &Written<Statement>| w.value.relations.iter().any(|r| r.has_branches);
    let assumed = claim.assuming.iter().any(branches);
    let said = claim.forms.iter().any(|form| {
        let leaves = |w: &Written<Tensor>| graph.leaves_within(w.value.components.iter().copied());
        form.has_branches() || form.quantity().is_some_and(|w| leaves(w).contains(&sign))
    });
    let mut denotation = Denotation {
        graph,
        surroundings,
        claim,
        start,
        selectors: Vec::new(),
        hypotheses: Vec::new(),
        parts: Vec::new(),
        readings: Vec::new(),
        denials: Vec::new(),
        stated: Vec::new(),
    };
    // A sign in assumptions and in the claim is one sign: for each of the two, the claim given what is assumed then.
    match assumed && said {
        true => [1, -1].into_iter().for_each(|sign| denotation.read(Some(sign))),
        false => denotation.read(None),
    }
    let Denotation { graph, mut selectors, mut hypotheses, mut parts, readings, denials, stated, .. } = denotation;
    for part in selectors.iter_mut().chain(&mut hypotheses).map(|a| &mut a.part).chain(&mut parts) {
        part.group.one_sided = one_sided(graph, &claim.scope, &part.group);
    }
    let beyond = parts.len();
    let reading = |(says, given): (Vec<Proposition>, Vec<usize>)| {
        let given = given.into_iter().map(|h| Proposition::Atom(beyond + h)).collect();
        Proposition::And(says).given(Proposition::And(given))
    };
    let mut readings: Vec<Proposition> = readings.into_iter().map(reading).collect();
    let whole = match readings.len() {
        1 => readings.swap_remove(0),
        _ => Proposition::Each(Quantifier::Every, readings),
    };
    let at = claim.at.as_ref().and_then(|at| at_event(graph, &at.equation.value));
    let said = parts.iter().filter(|p| p.is_compared() && at.is_none()).chain(hypotheses.iter().map(|a| &a.part));
    let compared: Vec<&Comparison> = said.flat_map(|p| &p.group.comparisons).collect();
    let mut sides: Vec<Expr> = compared.iter().flat_map(|c| [c.left, c.right]).collect();
    // Gradients vary as rapidly as their functions.
    for form in &claim.forms {
        if let Form::Independent { functions, .. } = form {
            sides.extend(functions.iter().flat_map(|w| &w.value.components));
        }
    }
    let rapid = rapid(graph, &claim.scope, sides);
    let assumed = selectors.iter().chain(&hypotheses).map(|a| &a.part);
    let compared = assumed.chain(&parts).flat_map(|p| &p.group.comparisons);
    let edges = edges(graph, &claim.scope, compared);
    Denoted { selectors, hypotheses, parts, denials, stated, claim: whole, at, rapid, edges, sign }
}

/// A claim while it is read.
struct Denotation<'a> {
    graph: &'a mut Graph,
    surroundings: Surroundings<'a>,
    claim: &'a Claim,
    start: Expr,
    selectors: Vec<Assumption>,
    hypotheses: Vec<Assumption>,
    parts: Vec<Part>,
    /// For each sign of ±, or for none: what is said of the parts, and the hypotheses by their positions.
    readings: Vec<(Vec<Proposition>, Vec<usize>)>,
    /// The parts that deny equations.
    denials: Vec<Denial>,
    /// The parts that state an equation of every time.
    stated: Vec<(usize, Relation)>,
}

/// A relation with its text.
type Said<'a> = (&'a str, Relation);

impl Denotation<'_> {
    /// The relations of a text, with a sign put in for ±.
    fn relations<'w>(&mut self, w: &'w Written<Statement>, sign: Option<i64>) -> Vec<Said<'w>> {
        let leaf = self.claim.scope.branch_sign();
        let put = |relation: &Relation| {
            let mut relation = relation.clone();
            if let (Some(sign), true) = (sign, relation.has_branches) {
                let components = relation.left.components.iter_mut().chain(&mut relation.right.components);
                for e in components {
                    *e = self.graph.rewrite(*e, |g, l| (l == leaf).then(|| g.integer(sign)));
                }
                relation.has_branches = false;
            }
            (w.text.as_str(), relation)
        };
        w.value.relations.iter().map(put).collect()
    }

    /// One reading of the claim, with a sign put in for ±.
    fn read(&mut self, sign: Option<i64>) {
        let first = sign.is_none_or(|s| s > 0);
        let mut given = Vec::new();
        let mut selected: Vec<Said> = Vec::new();
        // Among assumptions alone, too, ± is one sign: what has one is one statement.
        let (mut signed_selectors, mut signed_hypotheses): (Vec<Said>, Vec<Said>) = Default::default();
        let claim = self.claim;
        for w in &claim.assuming {
            for (relation, written) in self.relations(w, sign).into_iter().zip(&w.value.relations) {
                let (text, relation) = relation;
                let shared = sign.is_some() && written.has_branches;
                let selects = relation.limit.is_none()
                    && relation.kind != RelationKind::Equal
                    && !is_constant(self.graph, &claim.scope, &relation);
                if selects && shared {
                    selected.push((text, relation));
                    continue;
                }
                if relation.has_branches && relation.limit.is_none() && !is_denied(&relation) {
                    if selects { &mut signed_selectors } else { &mut signed_hypotheses }.push((text, relation));
                    continue;
                }
                let what = relation.limit.as_ref().map_or(What::Every, |l| What::Limit(l.approaches.clone()));
                let assumed_now = first && !selects && relation.limit.is_none();
                if assumed_now && let Some(valued) = self.having_value(&relation) {
                    let group = self.group(&[(text, valued)], false, &[]);
                    self.selectors.push(Assumption { text: text.to_owned(), part: Part { what: What::Every, group } });
                }
                let group = self.group(&[(text, relation)], false, &[]);
                let assumption = Assumption { text: text.to_owned(), part: Part { what, group } };
                match selects {
                    true if first => self.selectors.push(assumption),
                    true => {}
                    false => {
                        given.push(self.hypotheses.len());
                        self.hypotheses.push(assumption);
                    }
                }
            }
        }
        for (selects, signed) in [(true, signed_selectors), (false, signed_hypotheses)] {
            let Some((first, _)) = signed.first() else { continue };
            let text = (*first).to_owned();
            let mut group = self.group(&signed, false, &[]);
            group.throughout = !selects && claim.branches_throughout;
            let assumption = Assumption { text, part: Part { what: What::Every, group } };
            match selects {
                true => self.selectors.push(assumption),
                false => {
                    given.push(self.hypotheses.len());
                    self.hypotheses.push(assumption);
                }
            }
        }
        let mut says = Vec::new();
        // What has a ± at every time is one statement about one sign.
        let mut branching: Vec<Said> = Vec::new();
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    for (text, relation) in self.relations(w, sign) {
                        match (&relation.limit, relation.has_branches && !is_denied(&relation)) {
                            (None, true) => branching.push((text, relation)),
                            _ => {
                                let denies = denied(w, std::slice::from_ref(&relation), RelationKind::NotEqual);
                                let states = (relation.kind == RelationKind::Equal && relation.limit.is_none())
                                    .then(|| relation.clone());
                                says.push(self.relation((text, relation), &selected));
                                self.denies(denies, false);
                                let part = self.parts.len().saturating_sub(1);
                                self.stated.extend(states.map(|equal| (part, equal)));
                            }
                        }
                    }
                }
                Form::Never(w) => {
                    let (limits, others) = self.taken_apart(w, sign);
                    let limits: Vec<Proposition> =
                        limits.into_iter().map(|said| self.relation(said, &selected)).collect();
                    let mut ways: Vec<Proposition> = limits.iter().cloned().map(Proposition::negated).collect();
                    if !others.is_empty() {
                        let group = self.group(&others, true, &selected);
                        ways.push(self.part(What::Every, group));
                        if limits.is_empty() {
                            self.denies(denied(w, &w.value.relations, RelationKind::Equal), false);
                        }
                        if let Some(void) = one_is_void(&limits) {
                            // What is false of the others at some time makes the whole false then, whatever the limit is.
                            let otherwise = self.sometimes_false(&others, &selected);
                            ways.push(Proposition::And(vec![void, otherwise]));
                        }
                    }
                    says.push(one_or(ways, Proposition::Or));
                }
                Form::Eventually(w) => {
                    let (limits, others) = self.taken_apart(w, sign);
                    let mut both: Vec<Proposition> =
                        limits.into_iter().map(|said| self.relation(said, &selected)).collect();
                    let void = one_is_void(&both);
                    if !others.is_empty() {
                        let group = self.group(&others, true, &selected);
                        both.push(self.part(What::Denied, group).negated());
                        if void.is_none() {
                            self.denies(denied(w, &w.value.relations, RelationKind::Equal), true);
                        }
                        if let Some(void) = void {
                            let otherwise = self.sometimes_false(&others, &selected);
                            both.push(Proposition::And(vec![void, otherwise]).negated());
                        }
                    }
                    says.push(one_or(both, Proposition::And));
                }
                Form::Solves { system } => {
                    for w in &self.surroundings.systems[*system].equations {
                        for said in self.relations(w, sign) {
                            let sides = [&said.1.left, &said.1.right].map(|side| Written {
                                text: said.0.to_owned(),
                                span: 0..0,
                                value: side.clone(),
                            });
                            let group = self.group(&[said], false, &selected);
                            says.push(self.part(What::Every, group));
                            says.extend(sides.iter().map(|side| self.defined(side, sign)));
                        }
                    }
                }
                Form::FirstIntegral(w) => {
                    let group = self.values(w, sign, |text| format!("{text} is constant"), true);
                    says.push(self.part(What::Constant, group));
                    // Where the start does not count, or has no value, others are compared.
                    let (needs, _) = domain_conditions(self.graph, &claim.scope, w);
                    if !claim.assuming.is_empty() || claim.at.is_some() || !needs.is_empty() {
                        let mut group = self.values(w, sign, |text| format!("{text} is constant"), false);
                        let zero = self.graph.integer(0);
                        group.comparisons.iter_mut().for_each(|c| c.right = zero);
                        group.throughout = true;
                        self.parts.push(Part { what: What::Value, group });
                    }
                }
                Form::Defined(w) => {
                    let part = self.defined(w, sign);
                    says.push(part);
                }
                Form::SameMotion { other, of } => {
                    says.push(self.part(What::SameMotion(*other, of.clone()), Group::default()));
                }
                Form::Independent { .. } => says.push(self.part(What::Independent, Group::default())),
                Form::Across(across) => {
                    let mut group = self.values(&across.of, sign, str::to_owned, false);
                    let zero = self.graph.integer(0);
                    let limit = across.value.as_ref().and_then(|w| w.value.as_scalar()).unwrap_or(zero);
                    group.comparisons.iter_mut().for_each(|c| c.right = limit);
                    says.push(self.part(What::Across, group));
                }
                // Over ranges of values, and not along motions.
                Form::Exists { .. } => {}
                Form::Unread { why, .. } => says.push(self.part(What::Unread(why.clone()), Group::default())),
            }
        }
        if !branching.is_empty() {
            let mut group = self.group(&branching, false, &selected);
            group.throughout = claim.branches_throughout;
            says.push(self.part(What::Every, group));
        }
        self.readings.push((says, given));
    }

    /// Notes that the last part denies equations.
    fn denies(&mut self, equal: Option<Written<Statement>>, happens: bool) {
        let part = self.parts.len().saturating_sub(1);
        self.denials.extend(equal.map(|equal| Denial { part, equal, happens }));
    }

    /// The limits of a text, and its other relations.
    fn taken_apart<'w>(&mut self, w: &'w Written<Statement>, sign: Option<i64>) -> (Vec<Said<'w>>, Vec<Said<'w>>) {
        self.relations(w, sign).into_iter().partition(|(_, relation)| relation.limit.is_some())
    }

    /// A relation that is said of every time, or of a limit.
    fn relation(&mut self, said: Said, selected: &[Said]) -> Proposition {
        let what = said.1.limit.as_ref().map_or(What::Every, |l| What::Limit(l.approaches.clone()));
        let selected = if said.1.limit.is_some() { &[] } else { selected };
        let group = self.group(&[said], false, selected);
        self.part(what, group)
    }

    /// That a formula has a value at every time.
    fn defined(&mut self, w: &Written<Tensor>, sign: Option<i64>) -> Proposition {
        let mut group = self.values(w, sign, |text| format!("{text} has a value"), false);
        let (conditions, edges) = domain_conditions(self.graph, &self.claim.scope, w);
        if let Some(first) = group.comparisons.first_mut() {
            // The search between the samples looks there, too.
            first.boundaries.extend(edges);
        }
        group.comparisons.extend(conditions);
        group.asserted = true;
        self.part(What::Defined, group)
    }

    fn part(&mut self, what: What, group: Group) -> Proposition {
        self.parts.push(Part { what, group });
        Proposition::Atom(self.parts.len() - 1)
    }

    /// That the relations are not all true at some time that counts: one of them is false.
    fn sometimes_false(&mut self, relations: &[Said], selected: &[Said]) -> Proposition {
        let group = self.group(relations, false, selected);
        self.part(What::Denied, group).negated()
    }

    /// What is true where a relation has a value, and has none elsewhere; nothing, if it has one at all times. Times at which what is
    /// assumed has no value do not count.
    fn having_value(&mut self, relation: &Relation) -> Option<Relation> {
        let sides_of =
            |r: &Relation| -> Vec<Expr> { r.left.components.iter().chain(&r.right.components).copied().collect() };
        let scope = &self.claim.scope;
        // What must be so, and which rates there must be: where a motion has a kink there is none.
        let mut needs = |sides: Vec<Expr>, implied: bool| -> (Vec<(Expr, Sign)>, Vec<Leaf>) {
            let printed = self.graph.needs_below(sides.iter().copied());
            let written: Vec<Expr> = sides.into_iter().map(|e| traced_without_angles(self.graph, scope, e)).collect();
            let mut rates = self.graph.leaves_within(written.iter().copied());
            rates.retain(|leaf| leaf.rate > 0 && scope.moves(leaf));
            // What definitions divide by is 0 at single times; below a root they may lack a value for a while.
            let below = self.graph.needs_below(written).into_iter().filter(|need| need.sign != Sign::NotZero);
            let all = printed.into_iter().chain(below).filter(|need| !implied || need.certain);
            (all.map(|need| (need.value, need.sign)).collect(), rates)
        };
        let sides = sides_of(relation);
        let (asked, rates) = needs(sides.clone(), false);
        if asked.is_empty() && rates.is_empty() {
            return None;
        }
        // Where the claim itself has no value, nothing is said either.
        let said = self.claim.forms.iter().filter_map(|form| form.statement());
        let (own, own_rates) = needs(said.flat_map(|w| &w.value.relations).flat_map(sides_of).collect(), true);
        let beyond: Vec<Expr> = asked.into_iter().filter(|n| !own.contains(n)).map(|(e, _)| e).collect();
        let new = rates.into_iter().filter(|leaf| !own_rates.contains(leaf)).collect::<Vec<_>>();
        let kink = new.iter().any(|leaf| self.surroundings.may_lack_a_rate(self.graph, self.claim, leaf.symbol));
        let moving = self.graph.leaves_within(beyond).iter().any(|l| scope.moves(l));
        if !moving && !kink {
            return None;
        }
        // 1 + |l| + |r| > 0.
        let mut sum = self.graph.integer(1);
        for side in sides {
            let size = self.graph.unary(Op::Abs, side);
            sum = self.graph.add(sum, size);
        }
        let zero = self.graph.integer(0);
        let [left, right] = [sum, zero].map(Tensor::scalar);
        Some(Relation { kind: RelationKind::Greater, left, right, ..relation.clone() })
    }

    /// The comparisons of relations that must be true at once, or, `denied`, that must not be; where the selected ones are.
    fn group(&mut self, relations: &[Said], denied: bool, selected: &[Said]) -> Group {
        let mut group = Group { denied, ..Group::default() };
        let mut all = Vec::new();
        for (text, relation) in relations {
            all.push(self.compared(&mut group, text, relation, denied));
            group.branching |= relation.has_branches;
        }
        let mut formula = one_or(all, if denied { Proposition::Or } else { Proposition::And });
        // l ≠ r with ± says that it is neither: so does what is denied.
        let neither = relations.iter().any(|(_, r)| is_denied(r));
        group.signs = if denied != neither { Quantifier::Every } else { Quantifier::Some };
        if !selected.is_empty() {
            let conditions =
                selected.iter().map(|(text, relation)| self.compared(&mut group, text, relation, false)).collect();
            formula = formula.given(Proposition::And(conditions));
        }
        let count = group.comparisons.len();
        group.formula = (!is_conjunction_of_all(&formula, count)).then_some(formula);
        // Where other alternatives have no value, one that is met at a single time is all that is said.
        let compared = group.comparisons.iter();
        if group.formula.is_some() && !edges(self.graph, &self.claim.scope, compared).is_empty() {
            for c in group.comparisons.iter_mut().filter(|c| c.kind == RelationKind::Equal) {
                c.meetings = boundaries(self.graph, &self.claim.scope, c.left, c.right);
            }
        }
        group
    }

    /// Adds the comparisons of a relation, one for each component; the same component twice (as in a symmetric equation) once.
    fn compared(&mut self, group: &mut Group, text: &str, relation: &Relation, denied: bool) -> Proposition {
        let sides = relation.left.components.iter().zip(&relation.right.components).map(|(&l, &r)| (l, r));
        let sides: Vec<(Expr, Expr)> = sides.collect();
        let kind = if denied { opposite(relation.kind) } else { relation.kind };
        let mut atoms = Vec::new();
        for (component, &(left, right)) in sides.iter().enumerate() {
            if sides[..component].contains(&(left, right)) {
                continue;
            }
            let label = label(text, &relation.indices, &relation.left.shape, component);
            // What is presupposed of the times that count is so.
            atoms.push(match self.is_selected(kind, left, right) {
                true => Proposition::And(Vec::new()),
                false => Proposition::Atom(group.comparisons.len()),
            });
            group.comparisons.push(Comparison::new(self.graph, &self.claim.scope, label, kind, left, right));
        }
        // Some component differs; all are equal, or less.
        let some = denied != (relation.kind == RelationKind::NotEqual);
        one_or(atoms, if some { Proposition::Or } else { Proposition::And })
    }

    /// Whether a comparison, in this or the other direction, is a selector by itself.
    fn is_selected(&self, kind: RelationKind, left: Expr, right: Expr) -> bool {
        self.selectors.iter().map(|a| &a.part.group).filter(|g| g.formula.is_none() && !g.branching).any(|group| {
            let same = |c: &Comparison| (c.kind, c.left, c.right) == (kind, left, right);
            let turned = |c: &Comparison| (c.kind, c.left, c.right) == (turned(kind), right, left);
            group.comparisons.iter().any(|c| same(c) || turned(c))
        })
    }

    /// The components of a formula: compared with their values at the start, or with themselves.
    fn values(&mut self, w: &Written<Tensor>, sign: Option<i64>, text: impl Fn(&str) -> String, start: bool) -> Group {
        let scope = &self.claim.scope;
        let leaf = scope.branch_sign();
        let mut group = Group { throughout: true, ..Group::default() };
        for (component, &e) in w.value.components.iter().enumerate() {
            let mut e = e;
            if let Some(sign) = sign {
                e = self.graph.rewrite(e, |g, l| (l == leaf).then(|| g.integer(sign)));
            }
            group.branching |= self.graph.leaves_within([e]).contains(&leaf);
            let right = if start { at_instant(self.graph, scope, e, self.start) } else { e };
            let label = label(&text(&w.text), &[], &w.value.shape, component);
            group.comparisons.push(Comparison::new(self.graph, scope, label, RelationKind::Equal, e, right));
        }
        group.throughout = start || self.claim.branches_throughout;
        group
    }
}

/// Whether a relation with ± says that it is so for neither sign.
fn is_denied(relation: &Relation) -> bool {
    relation.has_branches && relation.kind == RelationKind::NotEqual
}

/// That these together are neither true nor false; `None` if there are none.
fn one_is_void(all: &[Proposition]) -> Option<Proposition> {
    let whole = (!all.is_empty()).then(|| one_or(all.to_vec(), Proposition::And))?;
    let asserted = |p: Proposition| Proposition::Assert(Box::new(p)).negated();
    Some(Proposition::And(vec![asserted(whole.clone()), asserted(whole.negated())]))
}

/// The single one, or all of them joined.
fn one_or(mut all: Vec<Proposition>, joined: fn(Vec<Proposition>) -> Proposition) -> Proposition {
    match all.len() {
        1 => all.swap_remove(0),
        _ => joined(all),
    }
}

/// Whether a formula says that all of `count` comparisons are true, and nothing else.
fn is_conjunction_of_all(formula: &Proposition, count: usize) -> bool {
    fn only_and(p: &Proposition) -> bool {
        match p {
            Proposition::Atom(_) => true,
            Proposition::And(all) => all.iter().all(only_and),
            Proposition::Not(_)
            | Proposition::Or(_)
            | Proposition::Given(..)
            | Proposition::Assert(_)
            | Proposition::Each(..) => false,
        }
    }
    only_and(formula) && formula.atoms().len() == count
}
