//! Sequents of a file: what a claim says for all values, and what it follows from, each as the file quantifies it.
//!
//! **In:** a claim and its derivation. **Out:** a [`Question`] for each component of each equation: a [`Sequent`], and where the claim is a
//! first integral, what is conserved. **Guaranteed:** what is left out of what is given makes the sequent say more; what is left out of
//! what is claimed is an error. So limits and boxes are left out as premises, and refused as claims.
//!
//! **How the file is quantified.** Definitions and systems hold at all times. What the claim assumes holds at the times that its inequalities
//! choose. Equations with ± are the products of the differences for either sign, where one sign or the other serves at each time. Another claim is given with its own assumptions ([`Claimed`]). A first integral e is e = e(c) for every time c of T: as a claim
//! with a constant c of which nothing is known, as a premise at each fixed time that occurs. A symbol has as many continuous
//! rates as formulas write.
//!
//! **Polar angles.** atan2(√q, x) is continuous wherever it has a value: near a point of its cut, where √q = 0 and x < 0, it is π − arctan(√q/|x|), and has the limit π; √q is never negative. So the
//! angle that is continued is its formula, and stands as a definition. (At √q = 0 neither has a rate: the root has an edge there, which the rate of a definition excludes as that of the file does.)
//!
//! **Traps.** An angle that is continued through whole turns is not its formula: it is a function of its own, with the sine, the cosine and, at all times at which the formula has one, the rate of
//! its formula; T is an interval on which it has values and, if rates are written, rates. Where it may have a kink between two times, nothing is said of both. What a claim says at events is said at some times only: refused as a claim, left out as a premise.

use crate::signs::of_either_sign;
use crate::vanish::order;
use crate::write::Writer;
use checker::{Claimed, Definition, Relation, Sense, Sequent};
use claim::comparison::{at_instant, is_continued, traced_without_angles};
use derivation::{Claim, Derivation, Form, Premise};
use expr::domain::Change;
use expr::{Expr, Graph, Leaf, Node, Op, Shape, Symbol};
use latex::{Relation as Read, RelationKind, Role};
use std::collections::{BTreeMap, BTreeSet};

/// A sequent, and how it is to be shown.
#[derive(Clone, Debug)]
pub struct Question {
    /// The sequent.
    pub sequent: Sequent,
    /// Whether it says e = e(c), for the position of c among the fixed times.
    pub conserved: Option<u32>,
    /// What is assumed beside what the claim assumes, since what it follows from does.
    pub presupposed: Vec<Relation>,
    /// What the claim assumes at the times that it chooses, and the sequent at all times, as equations of its systems.
    pub throughout: Vec<Relation>,
}

/// A relation between scalars of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scalar {
    pub(crate) left: Expr,
    pub(crate) sense: Sense,
    pub(crate) right: Expr,
}

impl Scalar {
    fn equal(left: Expr, right: Expr) -> Scalar {
        Scalar { left, sense: Sense::Equal, right }
    }
}

/// Another claim, by scalars.
struct Other {
    name: String,
    selectors: Vec<Scalar>,
    hypotheses: Vec<Scalar>,
    says: Vec<Scalar>,
}

/// The definitions that occur, and the highest rate that is written of each symbol.
type Named = (Vec<(Leaf, Expr)>, BTreeMap<Symbol, u8>);

/// The name of the fixed time of which nothing is known.
const ANY_TIME: &str = r"t_\ast";

/// The sequents of a claim.
///
/// # Errors
/// A sentence: what in the claim no sequent expresses.
pub fn sequents(derivation: &Derivation, claim: &Claim) -> Result<Vec<Question>, String> {
    let mut gathering = Gathering::new(derivation, claim);
    gathering.gather()?;
    gathering.questions()
}

/// The same, where what the claims assume that it follows from is assumed, too; nothing where that is nothing new.
///
/// # Errors
/// As for [`sequents`].
pub(crate) fn sequents_presupposing(derivation: &Derivation, claim: &Claim) -> Result<Vec<Question>, String> {
    let mut gathering = Gathering::new(derivation, claim);
    gathering.gather()?;
    gathering.presuppose();
    if gathering.presupposed.is_empty() { Ok(Vec::new()) } else { gathering.questions() }
}

/// The same, where assumptions are premises of all times.
///
/// # Errors
/// As for [`sequents`].
pub(crate) fn sequents_throughout(derivation: &Derivation, claim: &Claim) -> Result<Vec<Question>, String> {
    let mut gathering = Gathering::new(derivation, claim);
    gathering.gather()?;
    let assumed = std::mem::take(&mut gathering.assumed);
    gathering.premises.extend(std::mem::take(&mut gathering.selectors).into_iter().chain(assumed));
    gathering.questions()
}

/// The same of an interval of times at all of which assumptions are true.
///
/// # Errors
/// As for [`sequents`].
pub(crate) fn sequents_between(
    derivation: &Derivation,
    claim: &Claim,
    presupposing: Presupposing,
) -> Result<Vec<Question>, String> {
    let mut gathering = Gathering::new(derivation, claim);
    gathering.gather()?;
    match presupposing {
        Presupposing::Given => gathering.presuppose(),
        Presupposing::Nothing => {}
    }
    let selectors = std::mem::take(&mut gathering.selectors);
    let assumed = std::mem::take(&mut gathering.assumed);
    gathering.throughout = selectors.into_iter().chain(assumed).collect();
    gathering.systems.extend(&gathering.throughout);
    gathering.integrals_throughout();
    gathering.questions()
}

/// Whose assumptions are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Presupposing {
    /// Those of the claim.
    Nothing,
    /// Those of the claims that it follows from, too.
    Given,
}

/// What is given and what is claimed, in a graph of its own.
struct Gathering<'a> {
    derivation: &'a Derivation,
    claim: &'a Claim,
    graph: Graph,
    /// The fixed time of which nothing is known, and its symbol.
    any_time: (Expr, Symbol),
    claimed: Vec<(Scalar, bool)>,
    systems: Vec<Scalar>,
    premises: Vec<Scalar>,
    /// Angles that are continued, and whether their rates are told.
    angles: Vec<(Leaf, bool)>,
    /// Whether the formula of such an angle may have no rate where it has a value, beside its leaps.
    has_kinks: bool,
    others: Vec<Other>,
    selectors: Vec<Scalar>,
    assumed: Vec<Scalar>,
    presupposed: Vec<Scalar>,
    throughout: Vec<Scalar>,
}

/// The scalars of a relation; nothing for a limit or a relation with ±.
fn scalars(graph: &mut Graph, relation: &Read) -> Option<Vec<Scalar>> {
    if relation.limit.is_some() || relation.has_branches {
        return None;
    }
    let pairs: Vec<(Expr, Expr)> =
        relation.left.components.iter().copied().zip(relation.right.components.iter().copied()).collect();
    let each = |sense: Sense, turned: bool| {
        pairs.iter().map(move |&(l, r)| if turned { (r, sense, l) } else { (l, sense, r) }).collect::<Vec<_>>()
    };
    let out = match relation.kind {
        RelationKind::Equal => each(Sense::Equal, false),
        RelationKind::Less => each(Sense::Less, false),
        RelationKind::LessEqual => each(Sense::LessOrEqual, false),
        RelationKind::Greater => each(Sense::Less, true),
        RelationKind::GreaterEqual => each(Sense::LessOrEqual, true),
        RelationKind::NotEqual if pairs.len() == 1 => each(Sense::NotEqual, false),
        // Some component differs: the sum of the squares is not 0.
        RelationKind::NotEqual => {
            let zero = graph.integer(0);
            let mut sum = zero;
            for &(l, r) in &pairs {
                let difference = graph.sub(l, r);
                let square = graph.powi(difference, 2);
                sum = graph.add(sum, square);
            }
            vec![(sum, Sense::NotEqual, zero)]
        }
    };
    Some(out.into_iter().map(|(left, sense, right)| Scalar { left, sense, right }).collect())
}

/// Whether a claim says what it says of all values, and nothing of its assumptions is left out.
fn is_plain(claim: &Claim) -> bool {
    let plain = claim.assuming.iter().flat_map(|w| &w.value.relations).all(|r| r.limit.is_none() && !r.has_branches);
    // Over ranges of values it says nothing of others.
    claim.at.is_none() && !claim.is_over_ranges() && plain
}

fn assumes_sign(claim: &Claim) -> bool {
    claim.assuming.iter().flat_map(|w| &w.value.relations).any(|relation| relation.has_branches)
}

impl<'a> Gathering<'a> {
    fn new(derivation: &'a Derivation, claim: &'a Claim) -> Gathering<'a> {
        let mut graph = derivation.graph.clone();
        let symbol = graph.declare(ANY_TIME, Shape::scalar(), false);
        let any_time = (graph.leaf(Leaf::now(symbol, 0)), symbol);
        Gathering {
            derivation,
            claim,
            graph,
            any_time,
            claimed: Vec::new(),
            systems: Vec::new(),
            premises: Vec::new(),
            angles: Vec::new(),
            has_kinks: false,
            others: Vec::new(),
            selectors: Vec::new(),
            assumed: Vec::new(),
            presupposed: Vec::new(),
            throughout: Vec::new(),
        }
    }

    /// Assumes what the claims assume that are given: equations and inequalities that are not assumed yet.
    fn presuppose(&mut self) {
        for other in &self.others {
            for &scalar in &other.selectors {
                if !self.selectors.contains(&scalar) {
                    self.selectors.push(scalar);
                    self.presupposed.push(scalar);
                }
            }
            for &scalar in &other.hypotheses {
                // Between the same sides an equation says nothing.
                if scalar.left != scalar.right && !self.assumed.contains(&scalar) {
                    self.assumed.push(scalar);
                    self.presupposed.push(scalar);
                }
            }
        }
    }

    fn gather(&mut self) -> Result<(), String> {
        let (derivation, claim) = (self.derivation, self.claim);
        if claim.at.is_some() {
            return Err("a claim at events is no sequent".to_owned());
        }
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    for relation in w.value.relations.iter().filter(|relation| !relation.has_branches) {
                        let said = scalars(&mut self.graph, relation).ok_or("a limit")?;
                        self.claimed.extend(said.into_iter().map(|scalar| (scalar, false)));
                    }
                }
                Form::FirstIntegral(w) => {
                    for &e in &w.value.components {
                        let then = at_instant(&mut self.graph, &claim.scope, e, self.any_time.0);
                        self.claimed.push((Scalar::equal(e, then), true));
                    }
                }
                Form::Never(_)
                | Form::Eventually(_)
                | Form::Defined(_)
                | Form::Solves { .. }
                | Form::SameMotion { .. }
                | Form::Independent { .. }
                | Form::Exists { .. }
                | Form::Unread { .. }
                | Form::Across(_) => return Err("only equations and first integrals are sequents".to_owned()),
            }
        }
        if claim.forms.iter().any(Form::has_branches) {
            let said = self.signed(claim).filter(|_| !claim.branches_throughout && !assumes_sign(claim));
            let said = said.ok_or("± with one sign at all times, in assumptions or below a function")?;
            self.claimed.extend(said.into_iter().map(|scalar| (scalar, false)));
        }
        (self.selectors, self.assumed) = self.assumptions(claim);
        for name in derivation.given_to(claim) {
            match derivation.premise(&name) {
                Premise::System(system) => {
                    let equations = &derivation.systems[system].equations;
                    for relation in equations.iter().flat_map(|w| &w.value.relations) {
                        self.systems.extend(scalars(&mut self.graph, relation).unwrap_or_default());
                    }
                }
                Premise::Claim(at) => self.other(&derivation.claims[at]),
                Premise::Definition => {}
            }
        }
        // First integrals last: what they are at each fixed time that anything else names.
        let instants = self.instants();
        for name in derivation.given_to(claim) {
            if let Premise::Claim(at) = derivation.premise(&name) {
                self.integrals(&derivation.claims[at], &instants);
            }
        }
        Ok(())
    }

    /// What a claim assumes: inequalities, which choose times, and equations. A limit, or a sign ±, is left out.
    fn assumptions(&mut self, claim: &Claim) -> (Vec<Scalar>, Vec<Scalar>) {
        let relations = claim.assuming.iter().flat_map(|w| &w.value.relations);
        let all: Vec<Scalar> = relations.filter_map(|r| scalars(&mut self.graph, r)).flatten().collect();
        all.into_iter().partition(|scalar| scalar.sense != Sense::Equal)
    }

    /// A claim that is given, but for its first integrals. What is left out of its assumptions would make it say more, so that it is left out as a whole.
    fn other(&mut self, claim: &Claim) {
        if !is_plain(claim) {
            return;
        }
        let mut says = Vec::new();
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    says.extend(w.value.relations.iter().filter_map(|r| scalars(&mut self.graph, r)).flatten());
                }
                Form::Solves { system } => {
                    let relations = self.derivation.systems[*system].equations.iter().flat_map(|w| &w.value.relations);
                    says.extend(relations.filter_map(|r| scalars(&mut self.graph, r)).flatten());
                }
                Form::FirstIntegral(_)
                | Form::Never(_)
                | Form::Eventually(_)
                | Form::Defined(_)
                | Form::SameMotion { .. }
                | Form::Independent { .. }
                | Form::Exists { .. }
                | Form::Unread { .. }
                | Form::Across(_) => {}
            }
        }
        // One sign at all times is one at each.
        says.extend(self.signed(claim).unwrap_or_default());
        let (selectors, hypotheses) = self.assumptions(claim);
        self.others.push(Other { name: claim.name(), selectors, hypotheses, says });
    }

    /// What a claim says with ±, which is one sign at each time in all of it.
    fn signed(&mut self, claim: &Claim) -> Option<Vec<Scalar>> {
        let mut relations: Vec<Read> = Vec::new();
        for form in &claim.forms {
            if let Form::Always(w) = form {
                relations.extend(w.value.relations.iter().filter(|relation| relation.has_branches).cloned());
            }
        }
        let equations = of_either_sign(&mut self.graph, &relations, claim.scope.branch_sign())?;
        Some(equations.into_iter().map(|(l, r)| Scalar::equal(l, r)).collect())
    }

    /// First integrals with assumptions that hold at all times.
    fn integrals_throughout(&mut self) {
        let instants = self.instants();
        for name in self.derivation.given_to(self.claim) {
            let Premise::Claim(at) = self.derivation.premise(&name) else { continue };
            let other = &self.derivation.claims[at];
            let (selectors, assumed) = self.assumptions(other);
            let all: Vec<Scalar> = selectors.into_iter().chain(assumed).collect();
            if !all.is_empty() && all.iter().all(|s| self.throughout.contains(s) || s.left == s.right) {
                self.integrals_of(other, &instants);
            }
        }
    }

    /// The first integrals of a claim that is given: without assumptions all times count, and each has its value at each of these.
    fn integrals(&mut self, claim: &Claim, instants: &[Expr]) {
        if claim.assuming.is_empty() {
            self.integrals_of(claim, instants);
        }
    }

    fn integrals_of(&mut self, claim: &Claim, instants: &[Expr]) {
        if !is_plain(claim) {
            return;
        }
        let mut says = Vec::new();
        for form in &claim.forms {
            if let Form::FirstIntegral(w) = form {
                for &e in &w.value.components {
                    for &instant in instants {
                        let then = at_instant(&mut self.graph, &claim.scope, e, instant);
                        says.push(Scalar::equal(e, then));
                    }
                }
            }
        }
        if !says.is_empty() {
            self.others.push(Other { name: claim.name(), selectors: Vec::new(), hypotheses: Vec::new(), says });
        }
    }

    /// The fixed times that anything names, definitions too; and the one of which nothing is known, if the claim is about it, or there is no other.
    fn instants(&self) -> Vec<Expr> {
        let mut open = self.graph.leaves(self.all().iter().flat_map(|s| [s.left, s.right]));
        let (mut seen, mut out) = (BTreeSet::new(), BTreeSet::new());
        while let Some(leaf) = open.pop() {
            if !seen.insert(leaf) {
                continue;
            }
            if let Some(instant) = leaf.instant {
                out.insert(instant);
                open.extend(self.graph.leaves([instant]));
            }
            if let Some(formula) = self.definition(Leaf::now(leaf.symbol, leaf.component)) {
                open.extend(self.graph.leaves([formula]));
            }
        }
        if out.is_empty() {
            out.insert(self.any_time.0);
        }
        out.into_iter().collect()
    }

    /// The definition of a component.
    fn definition(&self, leaf: Leaf) -> Option<Expr> {
        let tensor = self.derivation.definition(leaf.symbol).or_else(|| self.claim.scope.definition(leaf.symbol))?;
        tensor.components.get(usize::from(leaf.component)).copied()
    }

    fn role(&self, symbol: Symbol) -> Option<Role> {
        self.derivation.role(symbol).or_else(|| self.claim.scope.role(symbol))
    }

    /// All relations.
    fn all(&self) -> Vec<Scalar> {
        let others = self.others.iter().flat_map(|o| o.selectors.iter().chain(&o.hypotheses).chain(&o.says));
        let own = self.claimed.iter().map(|(scalar, _)| scalar);
        own.chain(&self.systems)
            .chain(&self.premises)
            .chain(&self.selectors)
            .chain(&self.assumed)
            .chain(others)
            .copied()
            .collect()
    }

    /// The definitions that occur, those that others name first; and for each symbol the highest rate that is written of it, those of
    /// the formulas in which it stands added.
    fn definitions(&mut self) -> Result<Named, String> {
        let roots: Vec<Expr> = self.all().iter().flat_map(|s| [s.left, s.right]).collect();
        let (mut out, mut orders): Named = Default::default();
        let mut open: Vec<(Leaf, u8)> = self.graph.leaves(roots).into_iter().map(|leaf| (leaf, order(leaf))).collect();
        let mut steps = 0;
        while let Some((leaf, rate)) = open.pop() {
            steps += 1;
            if steps > 20_000 {
                return Err("the definitions are too many".to_owned());
            }
            let highest = orders.entry(leaf.symbol).or_insert(0);
            *highest = (*highest).max(rate);
            for (coordinate, _) in self.graph.coordinates().zip(leaf.partials.orders()).filter(|(_, n)| *n > 0) {
                orders.entry(coordinate.symbol).or_insert(0);
            }
            if let Some(instant) = leaf.instant {
                open.extend(self.graph.leaves([instant]).into_iter().map(|l| (l, order(l))));
            }
            let value = Leaf::now(leaf.symbol, leaf.component);
            let Some(formula) = self.definition(value) else { continue };
            if self.derivation.is_angle(leaf.symbol)
                && is_continued(&mut self.graph, &self.claim.scope, formula)
                && !self.is_polar(formula)
            {
                let further = self.continue_angle(value, formula, rate > 0);
                let inner = self.graph.leaves([formula]).into_iter();
                open.extend(inner.map(|l| (l, order(l).saturating_add(rate.max(further)))));
                continue;
            }
            // Definitions name what is declared before them: last found, first written.
            out.retain(|(known, _)| *known != value);
            out.push((value, formula));
            let inner = self.graph.leaves([formula]).into_iter();
            open.extend(inner.map(|l| (l, order(l).saturating_add(rate))));
        }
        out.reverse();
        Ok((self.ordered(out), orders))
    }

    /// Whether a formula is an angle atan2(√q, x), which no motion carries over its cut, and nothing else in it leaps.
    fn is_polar(&mut self, formula: Expr) -> bool {
        let root = |graph: &Graph, node: Expr| {
            let Node::Binary(Op::Arctan2, y, _) = *graph.node(node) else { return false };
            let Node::Unary(Op::Sqrt, _) = *graph.node(y) else { return false };
            true
        };
        let written = traced_without_angles(&mut self.graph, &self.claim.scope, formula);
        let names_angles = self.graph.leaves_within([written]).iter().any(|l| self.derivation.is_angle(l.symbol));
        root(&self.graph, formula)
            && !names_angles
            && self.graph.reachable([written]).into_iter().all(|node| {
                let leaps = |edge: &expr::domain::EdgeOf| matches!(edge.change, Change::Jump(_));
                root(&self.graph, node) || !self.graph.edges(node).iter().any(leaps)
            })
    }

    /// An angle that is continued through whole turns has the sine, the cosine and the rate of its formula, and not its value. The order of the rates of the formula that this takes.
    fn continue_angle(&mut self, angle: Leaf, formula: Expr, moves: bool) -> u8 {
        let node = self.graph.leaf(angle);
        if self.angles.iter().any(|(known, with_rate)| *known == angle && (*with_rate || !moves)) {
            return u8::from(moves);
        }
        if !self.angles.iter().any(|(known, _)| *known == angle) {
            for op in [Op::Sin, Op::Cos] {
                let [left, right] = [node, formula].map(|e| self.graph.unary(op, e));
                self.systems.push(Scalar::equal(left, right));
            }
        }
        self.angles.push((angle, moves));
        self.has_kinks |= self.graph.reachable([formula]).into_iter().any(|node| {
            let is_turn = matches!(self.graph.node(node), Node::Binary(Op::Arctan2, ..));
            !is_turn && !self.graph.edges(node).is_empty()
        });
        let Some(time) = self.claim.scope.time().filter(|_| moves) else { return 0 };
        let scope = &self.claim.scope;
        let Ok(rate) = self.graph.time_derivative(formula, time, |leaf| scope.moves(&leaf)) else { return 0 };
        let rate = self.graph.continued(formula, rate);
        let left = self.graph.leaf(Leaf { rate: 1, ..angle });
        self.premises.push(Scalar::equal(left, rate));
        1
    }

    /// Definitions, each after those that it names.
    fn ordered(&self, all: Vec<(Leaf, Expr)>) -> Vec<(Leaf, Expr)> {
        let (mut out, mut rest): (Vec<(Leaf, Expr)>, _) = (Vec::new(), all);
        while !rest.is_empty() {
            let (ready, later): (Vec<_>, Vec<_>) = rest.iter().partition(|(_, formula)| {
                let named = self.graph.leaves([*formula]);
                named.iter().all(|l| !rest.iter().any(|(of, _)| (of.symbol, of.component) == (l.symbol, l.component)))
            });
            if ready.is_empty() {
                break;
            }
            out.extend(ready);
            rest = later;
        }
        out
    }

    fn questions(mut self) -> Result<Vec<Question>, String> {
        let (definitions, orders) = self.definitions()?;
        let mut writer = Writer::new(&self.graph);
        let positive = |symbol: Symbol| self.derivation.role_of_positive(symbol).is_some();
        // Fields are as smooth as is wanted: two orders more than what is written.
        let of_fields = |s: &Symbol| self.graph.is_field(*s);
        let smooth = orders.iter().filter(|(s, _)| of_fields(s)).map(|(_, n)| n.saturating_add(2)).max().unwrap_or(0);
        for (&symbol, &order) in &orders {
            let order = if of_fields(&symbol) { smooth } else { order };
            let defined = definitions.iter().any(|(leaf, _)| leaf.symbol == symbol);
            let role = if symbol == self.any_time.1 { Some(Role::Parameter) } else { self.role(symbol) };
            writer.declare(symbol, role, defined, order, positive(symbol))?;
        }
        let named = definitions.iter().map(|(_, formula)| *formula);
        let roots: Vec<Expr> = self.all().iter().flat_map(|s| [s.left, s.right]).chain(named).collect();
        let instants = writer.instants(&roots);
        let is_named = |c: &Expr| *c != self.any_time.0 || self.claimed.iter().any(|(_, conserved)| *conserved);
        if self.has_kinks && instants.iter().any(is_named) {
            return Err("an angle that is continued may have a kink between the time and a fixed one".to_owned());
        }
        let any_time = instants.iter().position(|&c| c == self.any_time.0).map(|at| at as u32);
        let relations = |writer: &Writer, list: &[Scalar]| -> Result<Vec<Relation>, String> {
            list.iter().map(|s| writer.relation(*s)).collect()
        };
        let mut claims = Vec::new();
        for other in &self.others {
            for says in &other.says {
                claims.push(Claimed {
                    name: other.name.clone(),
                    selectors: relations(&writer, &other.selectors)?,
                    hypotheses: relations(&writer, &other.hypotheses)?,
                    says: writer.relation(*says)?,
                });
            }
        }
        let mut written = Vec::new();
        for (leaf, formula) in &definitions {
            let name = writer.name(leaf.symbol)?;
            written.push(Definition { name, component: leaf.component, formula: writer.term(*formula)? });
        }
        let shared = Sequent {
            symbols: writer.declared(),
            definitions: written,
            instants: instants.iter().map(|&c| writer.term(c)).collect::<Result<_, _>>()?,
            systems: relations(&writer, &self.systems)?,
            premises: relations(&writer, &self.premises)?,
            claims,
            selectors: relations(&writer, &self.selectors)?,
            assumed: relations(&writer, &self.assumed)?,
            claim: writer.relation(self.claimed.first().ok_or("nothing is claimed")?.0)?,
        };
        let presupposed = relations(&writer, &self.presupposed)?;
        let throughout = relations(&writer, &self.throughout)?;
        let each = self.claimed.iter().map(|(scalar, conserved)| {
            let sequent = Sequent { claim: writer.relation(*scalar)?, ..shared.clone() };
            let conserved = any_time.filter(|_| *conserved);
            let (presupposed, throughout) = (presupposed.clone(), throughout.clone());
            Ok(Question { sequent, conserved, presupposed, throughout })
        });
        each.collect()
    }
}
