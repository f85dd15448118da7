//! What a step may use: the claims and systems that it names, assumptions, definitions.

use super::{MOST_CASES, Pairs, Step, now, pairs};
use crate::derivation::{Claim, Derivation, Form, Premise};
use crate::expr::{Expr, FastSet, Graph, Leaf, Node, Op};
use crate::latex::{Relation, RelationKind, Role, Scope, Statement};
use claim::comparison::{at_instant, may_leap, traced};
use proof::{Premises, solve_for_arguments};

/// Which definitions of observables are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Definitions {
    /// None: an observable is what the premises say of it.
    None,
    /// Those of symbols that are declared for a claim.
    OfClaims,
    /// Those, and all at the fixed times that occur.
    Then,
    /// All, at the present time.
    Now,
    /// All, also at the fixed times that occur.
    All,
    /// All, and the systems that are given where no rate occurs, but an equation ties what moves. Only such a point can refute.
    Everything,
}

impl Definitions {
    /// In the order of trying: all but the last leave something out.
    pub(super) const LEVELS: [Definitions; 6] = [
        Definitions::None,
        Definitions::OfClaims,
        Definitions::Then,
        Definitions::Now,
        Definitions::All,
        Definitions::Everything,
    ];
}

/// What an angle has of its formula.
enum Continued {
    /// It is its formula.
    No,
    /// It has its rate.
    Rate(Expr),
    /// That cannot be said.
    Unknown,
}

/// Everything that is named.
#[derive(Clone, Debug, Default)]
pub(super) struct Gathered {
    /// Equations of claims and assumptions, and what they say at the fixed times that occur.
    pub(super) premises: Premises,
    pub(super) systems: Pairs,
    /// Assumptions of the claims that are named.
    pub(super) inherited: Vec<String>,
    /// Whether all of it is known at all times.
    pub(super) elsewhere: bool,
    /// Whether all of it may be used of the times between others: none is left out, or motions are analytic.
    pub(super) between: bool,
    /// The names.
    pub(super) from: Vec<String>,
    /// Whether all could be used: a refutation needs that.
    pub(super) complete: bool,
}

fn sides(pairs: &[(Expr, Expr)]) -> impl Iterator<Item = Expr> + '_ {
    pairs.iter().flat_map(|&(l, r)| [l, r])
}

impl Step<'_> {
    /// The rate of a first integral as an equation `… = 0`: it says nothing where the integral has no value.
    fn constancy(&mut self, scope: &Scope, e: Expr) -> Option<(Expr, Expr)> {
        let time = scope.time()?;
        let moves = |leaf: Leaf| scope.moves(&leaf);
        let rate = self.graph.time_derivative(e, time, moves).ok()?;
        let rate = self.graph.rate_of(e, rate, |leaf| scope.role(leaf.symbol) == Some(Role::Observable));
        Some((rate, self.graph.integer(0)))
    }

    /// What a claim says as equations; `None` where it says something else, or not at all times.
    pub(super) fn equations(&mut self, claim: &Claim) -> Option<Pairs> {
        let mut out = Vec::new();
        if claim.at.is_some() {
            return None;
        }
        for form in &claim.forms {
            if let Form::FirstIntegral(w) = form {
                for &e in &w.value.components {
                    out.push(self.constancy(&claim.scope, e)?);
                }
            } else if let Form::Solves { system } = form {
                let relations = self.derivation.systems[*system].equations.iter().flat_map(|w| &w.value.relations);
                out.extend(relations.flat_map(pairs));
            } else if let Form::Always(w) = form {
                for relation in &w.value.relations {
                    if relation.kind != RelationKind::Equal || relation.limit.is_some() {
                        return None;
                    }
                    out.extend(pairs(relation));
                }
            } else {
                return None;
            }
        }
        match self.sign {
            Some(value) if std::ptr::eq(claim, self.claim) => Some(self.branch(&out, value)),
            _ => Some(out),
        }
    }

    /// Adds the assumptions of a claim but those with the given numbers.
    ///
    /// Whether all of them could be used: a limit says nothing of present values, and a sign of another claim is not known.
    ///
    /// Equations of fields are assumed at all places; where an equation says at which places, they are assumed there alone, and
    /// nothing is known of their derivatives.
    fn assume(&mut self, claim: &Claim, without: &[usize], premises: &mut Premises) -> bool {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let mut complete = true;
        let before = premises.equations.len();
        for relation in used.flat_map(|(_, w)| &w.value.relations) {
            if relation.limit.is_some() || relation.has_branches && self.sign.is_none() {
                complete = false;
                continue;
            }
            for (l, r) in self.scalars(relation) {
                match relation.kind {
                    RelationKind::Equal => premises.equations.push((l, r)),
                    RelationKind::NotEqual => premises.nonzero.push(self.graph.sub(l, r)),
                    RelationKind::Greater => premises.positive.push(self.graph.sub(l, r)),
                    RelationKind::Less => premises.positive.push(self.graph.sub(r, l)),
                    RelationKind::GreaterEqual => premises.not_negative.push(self.graph.sub(l, r)),
                    RelationKind::LessEqual => premises.not_negative.push(self.graph.sub(r, l)),
                }
            }
        }
        let graph = &self.graph;
        let of_fields = |(l, r): &(Expr, Expr)| !graph.fields([*l, *r]).is_empty();
        let is_place = |pair: &(Expr, Expr)| {
            let leaves = graph.leaves_within([pair.0, pair.1]);
            !of_fields(pair) && leaves.iter().any(|l| graph.coordinate(*l).is_some())
        };
        if premises.equations[before..].iter().any(is_place) {
            let (there, everywhere) = premises.equations.drain(before..).partition::<Pairs, _>(of_fields);
            premises.equations.extend(everywhere);
            // Along such places they may be meant to hold together: no point refutes that.
            complete &= there.is_empty();
            premises.only_now.extend(there);
        }
        complete
    }

    /// The inequalities that a claim assumes, but those with the given numbers, by which times are chosen: something moves in them. What
    /// must not be 0 leaves out single times of a smooth motion, beyond which everything goes on.
    fn choosing<'c>(&self, claim: &'c Claim, without: &[usize]) -> Vec<&'c Relation> {
        let scope = &claim.scope;
        let moves = |l: &Leaf| l.instant.is_none() && (scope.moves(l) || Some(*l) == scope.time());
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let relations = used.flat_map(|(_, w)| &w.value.relations);
        let inequalities = relations.filter(|r| !matches!(r.kind, RelationKind::Equal | RelationKind::NotEqual));
        let chooses = |r: &&Relation| {
            let sides = r.left.components.iter().chain(&r.right.components).copied();
            self.graph.leaves_within(sides).iter().any(moves)
        };
        inequalities.filter(chooses).collect()
    }

    /// Whether what is so at the times that a claim chooses goes on at all others: none is left out; or it is so for a while, and motions
    /// are analytic.
    fn goes_on(&mut self, of: &Claim, without: &[usize]) -> bool {
        let choosing = self.choosing(of, without);
        let for_a_while = choosing.iter().all(|r| matches!(r.kind, RelationKind::Greater | RelationKind::Less));
        self.at_all_times || choosing.is_empty() || for_a_while && self.motions_are_analytic(of)
    }

    /// Whether systems that are given determine everything that two claims name, by equations without kinks and leaps.
    pub(super) fn motions_are_analytic(&mut self, of: &Claim) -> bool {
        let systems = self.sides_of_systems();
        let mut given = systems.clone();
        self.add_definitions(&mut given);
        if systems.is_empty() || self.graph.reachable(given).into_iter().any(|e| self.is_branching(e)) {
            return false;
        }
        let moved = self.graph.leaves_within(systems);
        let has_rate = |leaf: &Leaf| moved.iter().any(|m| m.rate > 0 && m.symbol == leaf.symbol);
        let claim = self.claim;
        let assumed = [of, claim].into_iter().flat_map(|c| &c.assuming).flat_map(|w| &w.value.relations);
        let mut named: Vec<Expr> = assumed.flat_map(pairs).flat_map(|(l, r)| [l, r]).collect();
        for one in [of, claim] {
            named.extend(sides(&self.equations(one).unwrap_or_default()));
        }
        self.add_definitions(&mut named);
        let scope = &claim.scope;
        self.graph.leaves_within(named).iter().all(|leaf| {
            let is_defined = scope.definition(leaf.symbol).or_else(|| of.scope.definition(leaf.symbol)).is_some();
            !(scope.moves(leaf) || of.scope.moves(leaf)) || is_defined || has_rate(leaf)
        })
    }

    /// Whether equations that are so at the times that count are so at all others, since they go on and cannot leap.
    fn is_known_elsewhere(&mut self, of: &Claim, without: &[usize], equations: &Pairs) -> bool {
        if self.at_all_times || self.choosing(of, without).is_empty() {
            return true;
        }
        let mut leaps = |e: Expr| {
            let e = traced(&mut self.graph, &of.scope, e);
            may_leap(&self.graph, e)
        };
        !equations.iter().any(|&(l, r)| leaps(l) || leaps(r)) && self.goes_on(of, without)
    }

    /// What `follows-from` and the assumptions give; `without` some assumptions.
    pub(super) fn gather(&mut self, without: Option<&[usize]>) -> Gathered {
        let (derivation, claim) = (self.derivation, self.claim);
        let mut out = Gathered { complete: !self.lacks_systems(), ..Gathered::default() };
        let mut premises = Premises::default();
        self.roles(&mut premises);
        let absent = without.unwrap_or(&[]);
        out.complete &= self.assume(claim, absent, &mut premises);
        // Each with the scope that says what moves in it.
        let mut always: Vec<(&Scope, Pairs)> = Vec::new();
        out.elsewhere = self.at_all_times || self.choosing(claim, absent).is_empty();
        out.between = self.goes_on(claim, absent);
        if self.is_known_elsewhere(claim, absent, &premises.equations) {
            always.push((&claim.scope, premises.equations.clone()));
        }
        let mut constant: Vec<(&Scope, Expr)> = Vec::new();
        for name in Step::given(derivation, claim) {
            out.from.push(name.clone());
            let premise = match derivation.premise(&name) {
                Premise::System(system) => {
                    let equations = &derivation.systems[system].equations;
                    out.systems.extend(equations.iter().flat_map(|w| &w.value.relations).flat_map(pairs));
                    continue;
                }
                Premise::Claim(claim) => &derivation.claims[claim],
                Premise::Definition => continue,
            };
            let mut at_others = true;
            match self.equations(premise) {
                Some(equations) => {
                    let equations = self.without_branches(premise, equations, &mut out.complete);
                    premises.equations.extend(&equations);
                    // What it assumes is known at other times if it is assumed here of all of them.
                    at_others = self.is_known_elsewhere(premise, &[], &equations)
                        && (premise.assuming.is_empty() || self.is_known_elsewhere(claim, absent, &equations));
                    out.elsewhere &= at_others;
                    out.between &= at_others;
                    for form in &premise.forms {
                        if let (Form::FirstIntegral(w), true) = (form, at_others) {
                            constant.extend(w.value.components.iter().map(|&e| (&premise.scope, e)));
                        }
                    }
                    always.extend(at_others.then_some((&premise.scope, equations)));
                }
                None => out.complete = false,
            }
            let before = premises.equations.len();
            // An assumption that is left out is left out everywhere.
            let dropped =
                |of: &Statement| without.is_some_and(|w| w.iter().any(|&i| claim.assuming[i].value.says_the_same(of)));
            let numbers: Vec<usize> =
                (0..premise.assuming.len()).filter(|&i| dropped(&premise.assuming[i].value)).collect();
            out.complete &= self.assume(premise, &numbers, &mut premises);
            let assumed = premises.equations[before..].to_vec();
            if at_others && self.is_known_elsewhere(claim, absent, &assumed) {
                always.push((&premise.scope, assumed));
            }
            // What a premise presupposes is presupposed here: a proof says so, and does not reach beyond it.
            // A name may mean something else in each claim.
            let own = |of: &Statement| claim.assuming.iter().any(|w| w.value.says_the_same(of));
            let more = premise.assuming.iter().filter(|w| !own(&w.value)).map(|w| w.text.clone());
            out.inherited.extend(more);
        }
        let mut seen = Vec::new();
        out.inherited.retain(|text| {
            !seen.contains(text) && {
                seen.push(text.clone());
                true
            }
        });
        self.at_instants(&always, &constant, &mut premises);
        out.premises = premises;
        out
    }

    /// ± in a premise: at each time one of the signs holds, so the product of the two residuals vanishes.
    fn without_branches(&mut self, premise: &Claim, equations: Pairs, complete: &mut bool) -> Pairs {
        let sign = premise.scope.branch_sign();
        let branching = |graph: &Graph, &(l, r): &(Expr, Expr)| graph.leaves_within([l, r]).contains(&sign);
        let count = equations.iter().filter(|p| branching(&self.graph, p)).count();
        // One sign for several equations, for all times, or for an assumption, too, says more than the products.
        let assumed = premise.assuming.iter().flat_map(|w| &w.value.relations).any(|r| r.has_branches);
        *complete &= count == 0 || count == 1 && !premise.branches_throughout && !assumed;
        let one = |this: &mut Self, pair: (Expr, Expr)| {
            if !branching(&this.graph, &pair) {
                return pair;
            }
            let residual = this.graph.sub(pair.0, pair.1);
            let [p, q] = [1, -1].map(|v| this.graph.rewrite(residual, |g, l| (l == sign).then(|| g.integer(v))));
            (this.graph.mul(p, q), this.graph.integer(0))
        };
        equations.into_iter().map(|pair| one(self, pair)).collect()
    }

    /// What holds at all times holds at the fixed times that occur; constants have their present value there.
    fn at_instants(&mut self, always: &[(&Scope, Pairs)], constant: &[(&Scope, Expr)], premises: &mut Premises) {
        let mut roots: Vec<Expr> = always.iter().flat_map(|(_, p)| sides(p)).collect();
        roots.extend(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative));
        let own = self.equations(self.claim).unwrap_or_default();
        roots.extend(sides(&own));
        let mut instants: Vec<Expr> = self.graph.leaves_within(roots).into_iter().filter_map(|l| l.instant).collect();
        instants.sort_unstable();
        instants.dedup();
        for &instant in &instants {
            for &(scope, e) in constant {
                let then = at_instant(&mut self.graph, scope, e, instant);
                premises.equations.push((e, then));
            }
            for (scope, list) in always {
                for &(l, r) in list {
                    if self.graph.leaves_within([l, r]).iter().any(|l| l.rate > 0) {
                        continue;
                    }
                    let then = [l, r].map(|e| at_instant(&mut self.graph, scope, e, instant));
                    if then != [l, r] && then[0] != then[1] && !premises.equations.contains(&(then[0], then[1])) {
                        premises.equations.push((then[0], then[1]));
                    }
                }
            }
            let scope = &self.claim.scope;
            let signs = [&mut premises.positive, &mut premises.not_negative].into_iter().filter(|_| self.at_all_times);
            for list in std::iter::once(&mut premises.nonzero).chain(signs) {
                for e in list.clone() {
                    if self.graph.leaves_within([e]).iter().all(|l| l.rate == 0) {
                        let then = at_instant(&mut self.graph, scope, e, instant);
                        if !list.contains(&then) {
                            list.push(then);
                        }
                    }
                }
            }
        }
    }

    /// Which symbols move, and which are parameters.
    fn roles(&mut self, premises: &mut Premises) {
        let Derivation { symbols, claims, scope, .. } = self.derivation;
        premises.time = scope.time();
        for entry in symbols.iter().chain(claims.iter().flat_map(|c| &c.symbols)) {
            let count = self.graph.component_count(entry.symbol);
            match entry.role {
                Role::State | Role::Observable => {
                    premises.moving.push(entry.symbol);
                    premises.angles.extend(entry.angle.then_some(entry.symbol));
                }
                Role::Parameter => premises.parameters.extend((0..count).map(|c| now(entry.symbol, c))),
                Role::Coordinate => premises.parameters.extend((0..count).map(|c| now(entry.symbol, c))),
                Role::Time | Role::Abbreviation | Role::Argument | Role::Field => {}
            }
        }
    }

    /// All premises of a question, with some definitions.
    pub(super) fn premises(&mut self, gathered: &Gathered, equations: &Pairs, which: Definitions) -> Premises {
        let mut premises = gathered.premises.clone();
        self.definitions(equations, &gathered.systems, which, &mut premises);
        self.definitions_at_instants(equations, which, &mut premises);
        self.add_positive_parameters(equations, &mut premises);
        solve_for_arguments(&mut self.graph, &mut premises);
        premises
    }

    /// What is positive among the parameters that occur.
    pub(super) fn add_positive_parameters(&mut self, equations: &Pairs, premises: &mut Premises) {
        let roots: Vec<Expr> = sides(equations).chain(sides(&premises.equations)).collect();
        for leaf in self.graph.leaves_within(roots) {
            if self.is_positive_parameter(leaf) {
                let node = self.graph.leaf(leaf);
                premises.positive.push(node);
            }
        }
    }

    /// The definition of a component, as far as definitions are used.
    fn definition(&self, leaf: Leaf, which: Definitions) -> Option<Expr> {
        let Derivation { claims, scope, .. } = self.derivation;
        let in_file = || {
            scope
                .definition(leaf.symbol)
                .filter(|_| matches!(which, Definitions::Now | Definitions::All | Definitions::Everything))
        };
        // The claims are many, and asked for the same symbols again and again.
        let in_claim = || {
            let found = || {
                let own = scope.definition(leaf.symbol).is_none();
                claims.iter().filter(|_| own).find_map(|c| c.scope.definition(leaf.symbol))
            };
            *self.of_claims.borrow_mut().entry(leaf.symbol).or_insert_with(found)
        };
        let definition = match which {
            Definitions::None => None,
            _ => in_file().or_else(in_claim),
        };
        definition?.components.get(usize::from(leaf.component)).copied()
    }

    /// The definitions of the observables that occur, of those in these, and so on; where rates occur, the systems that
    /// are given join in. What does not occur is left out: a premise less can only lose a proof. Where a point may refute, the
    /// systems join in, too, where an equation that is given ties what moves, or they have one without a rate: with the rates of that
    /// they may say more.
    fn definitions(
        &mut self,
        equations: &Pairs,
        systems: &[(Expr, Expr)],
        which: Definitions,
        premises: &mut Premises,
    ) {
        let mut seen: Vec<Leaf> = Vec::new();
        let tied = |graph: &Graph, &(l, r): &(Expr, Expr)| {
            graph.leaves_within([l, r]).iter().any(|l| l.instant.is_none() && self.claim.scope.moves(l))
        };
        let constraint =
            |graph: &Graph, &(l, r): &(Expr, Expr)| graph.leaves_within([l, r]).iter().all(|l| l.rate == 0);
        let mut moving = which == Definitions::Everything
            && (premises.equations.iter().any(|pair| tied(&self.graph, pair))
                || systems.iter().any(|pair| constraint(&self.graph, pair)));
        let roots: Vec<Expr> = sides(equations)
            .chain(sides(&premises.equations))
            .chain(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied())
            .collect();
        let mut open = self.graph.leaves_within(roots);
        loop {
            while let Some(leaf) = open.pop() {
                moving |= leaf.rate > 0 || self.graph.is_field(leaf.symbol);
                let value = Leaf { rate: 0, ..leaf };
                if value.instant.is_some() || seen.contains(&value) {
                    continue;
                }
                seen.push(value);
                if let Some(e) = self.definition(value, which) {
                    match self.continued(value, e, equations, premises) {
                        Continued::No => {
                            let node = self.graph.leaf(value);
                            premises.equations.push((node, e));
                        }
                        // Whole turns may lie between it and its formula: only its rate is that of the formula.
                        Continued::Rate(rate) => {
                            let node = self.graph.leaf(Leaf { rate: 1, ..value });
                            premises.equations.push((node, rate));
                            (moving, self.loosened) = (true, true);
                        }
                        Continued::Unknown => self.loosened = true,
                    }
                    open.extend(self.graph.leaves_within([e]));
                }
            }
            if !moving || systems.is_empty() || premises.equations.contains(&systems[0]) {
                return;
            }
            premises.equations.extend(systems);
            open.extend(self.graph.leaves_within(sides(systems)));
        }
    }

    /// What an angle that is continued along motions has of its formula, where more of it occurs than its sine and cosine.
    fn continued(&mut self, leaf: Leaf, e: Expr, equations: &Pairs, premises: &Premises) -> Continued {
        if !self.derivation.is_angle(leaf.symbol) || !may_leap(&self.graph, e) {
            return Continued::No;
        }
        let node = self.graph.leaf(leaf);
        let roots = sides(equations)
            .chain(sides(&premises.equations))
            .chain(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied());
        let bare = self.tells_turns(roots, node);
        let scope = &self.claim.scope;
        let (true, Some(time)) = (bare, scope.time()) else { return Continued::No };
        let moves = |leaf: Leaf| scope.moves(&leaf);
        match self.graph.time_derivative(e, time, moves) {
            Ok(rate) => Continued::Rate(self.graph.continued(e, rate)),
            Err(_) => Continued::Unknown,
        }
    }

    /// Whether whole turns of an angle change a formula: it stands elsewhere than in sums and whole multiples below a sine, a
    /// cosine or a tangent.
    fn tells_turns(&self, roots: impl Iterator<Item = Expr>, angle: Expr) -> bool {
        let whole = |e: Expr| self.graph.as_constant(e).is_some_and(|r| r.denominator().is_one());
        let mut seen: FastSet<(Expr, bool)> = FastSet::default();
        let mut open: Vec<(Expr, bool)> = roots.map(|e| (e, false)).collect();
        while let Some((e, periodic)) = open.pop() {
            if !seen.insert((e, periodic)) {
                continue;
            }
            if e == angle && !periodic {
                return true;
            }
            match *self.graph.node(e) {
                Node::Unary(Op::Sin | Op::Cos | Op::Tan, a) => open.push((a, true)),
                Node::Unary(Op::Neg, a) => open.push((a, periodic)),
                Node::Binary(Op::Add | Op::Sub, a, b) => open.extend([(a, periodic), (b, periodic)]),
                Node::Binary(Op::Mul, a, b) => open.extend([(a, periodic && whole(b)), (b, periodic && whole(a))]),
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {
                    open.extend(self.graph.node(e).children().map(|child| (child, false)));
                }
            }
        }
        false
    }

    /// The values at fixed times that occur obey the definitions at these times.
    fn definitions_at_instants(&mut self, equations: &Pairs, which: Definitions, premises: &mut Premises) {
        let roots: Vec<Expr> = sides(equations)
            .chain(sides(&premises.equations))
            .chain(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied())
            .collect();
        let which = match which {
            Definitions::Now => return,
            Definitions::Then => Definitions::All,
            other => other,
        };
        let scope = &self.claim.scope;
        let mut open: Vec<Leaf> = self.graph.leaves_within(roots);
        open.retain(|l| l.instant.is_some());
        let mut seen: Vec<Leaf> = Vec::new();
        while let Some(leaf) = open.pop() {
            let (Some(instant), false) = (leaf.instant, seen.contains(&leaf)) else { continue };
            seen.push(leaf);
            if leaf.rate > 0 {
                continue;
            }
            if let Some(e) = self.definition(Leaf { instant: None, ..leaf }, which) {
                if self.derivation.is_angle(leaf.symbol) && may_leap(&self.graph, e) {
                    self.loosened = true;
                    continue;
                }
                let then = at_instant(&mut self.graph, scope, e, instant);
                open.extend(self.graph.leaves_within([then]));
                let node = self.graph.leaf(leaf);
                premises.equations.push((node, then));
            }
        }
    }

    /// Premises with every choice of factors of the equations `product = 0` among them and their derivatives.
    pub(super) fn cases(&mut self, premises: &Premises) -> Vec<Premises> {
        let (mut open, mut done) = (vec![premises.clone()], Vec::new());
        while let Some(case) = open.pop() {
            if open.len() + done.len() > MOST_CASES {
                return vec![premises.clone()];
            }
            match self.factors_of_one(&case) {
                None => done.push(case),
                Some(factors) => {
                    let zero = self.graph.integer(0);
                    let case = self.of_one_time(case);
                    for factor in factors.into_iter().rev() {
                        let mut one = case.clone();
                        // First, so that it is solved first.
                        one.equations.insert(0, (factor, zero));
                        open.push(one);
                    }
                }
            }
        }
        done
    }

    /// Premises without what they say of fixed times: another factor may vanish there.
    pub(super) fn of_one_time(&self, mut case: Premises) -> Premises {
        let graph = &self.graph;
        let now = |e: &Expr| graph.leaves_within([*e]).iter().all(|leaf| leaf.instant.is_none());
        case.equations.retain(|(l, r)| now(l) && now(r));
        for facts in [&mut case.nonzero, &mut case.positive, &mut case.not_negative] {
            facts.retain(now);
        }
        case
    }

    /// The factors of the first premise, or derivative of one, that is a product and has no factor among the premises yet.
    fn factors_of_one(&mut self, case: &Premises) -> Option<Vec<Expr>> {
        let time = case.time?;
        for at in 0..case.equations.len() {
            let (l, r) = case.equations[at];
            let residual = self.graph.sub(l, r);
            let rate = self.graph.time_derivative(residual, time, |l| case.moving.contains(&l.symbol));
            for e in [Some(residual), rate.ok()].into_iter().flatten() {
                let bases = bases(&self.graph, e);
                let product = bases.len() > 1;
                let settled = |b: &Expr| case.equations.iter().any(|&(l, r)| l == *b && self.graph.is_zero(r));
                if bases.iter().any(settled) {
                    continue;
                }
                let moving = |b: &Expr| self.graph.leaves_within([*b]).iter().any(|l| case.moving.contains(&l.symbol));
                let bases: Vec<Expr> = bases.into_iter().filter(|b| !case.nonzero.contains(b)).collect();
                if product && bases.iter().any(moving) {
                    return Some(bases);
                }
            }
        }
        None
    }
}

/// The factors of a product, by its structure; powers and quotients are taken apart.
fn bases(graph: &Graph, e: Expr) -> Vec<Expr> {
    let mut out = Vec::new();
    let mut stack = vec![e];
    while let Some(e) = stack.pop() {
        match *graph.node(e) {
            Node::Constant(_) => {}
            Node::Unary(Op::Neg, a) => stack.push(a),
            Node::Unary(Op::Powi(n), a) if n > 0 => stack.push(a),
            Node::Binary(Op::Mul, a, b) => stack.extend([b, a]),
            Node::Binary(Op::Div, a, _) => stack.push(a),
            _ if out.contains(&e) => {}
            _ => out.push(e),
        }
    }
    out
}
