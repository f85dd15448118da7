//! The search: given facts, their rates and values, elimination, and the claim.
//!
//! **In:** a [`Question`]. **Out:** a proof that the checker accepted, or why none was found. **Guaranteed:** bounded: so many facts, so many nodes.

use crate::eliminate::{MOST_NODES, Search, Solved};
use crate::fraction::fraction;
use crate::polynomial::divide;
use crate::sequent::Question;
use crate::used::used;
use crate::write::Reader;
use checker::{CaseId, Draft, FactId, Given, Instant, Law, Relation, Sense, Sequent, Step, SymbolKind, Term, When};
use expr::{Expr, Leaf, Node, Op};

/// Most facts that are solved.
const MOST_FACTS: usize = 160;
/// Most rounds of elimination.
const MOST_ROUNDS: usize = 120;
/// The work of a test for an identity, beside its nodes.
const IDENTITY: usize = 8_000;
/// Most divisions of the rest of a claim.
const MOST_DIVISIONS: usize = 12;

/// The steps of a proof of a sequent.
///
/// # Errors
/// A sentence: the sequent that cannot be read, or the search that ended without a proof.
pub fn prove(question: &Question) -> Result<Vec<Step>, String> {
    let sequent = &question.sequent;
    let draft = Draft::new(sequent).map_err(|refused| refused.to_string())?;
    let mut attempt = Attempt {
        search: Search::new(Reader::new(&sequent.symbols), draft),
        sequent,
        facts: Vec::new(),
        assumptions: Vec::new(),
    };
    let shown = attempt.run(question.conserved).ok_or("no proof was found by algebra and rates")?;
    let mut draft = attempt.search.draft;
    draft.push(Step::Conclude { fact: shown }).map_err(|refused| refused.to_string())?;
    let (steps, _) = draft.finish().map_err(|refused| refused.to_string())?;
    Ok(used(steps))
}

/// What a fact is solved for: a rate now, a value now, a value at a fixed time, a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Rate,
    Value,
    Fixed,
    Constant,
}

/// What is divided by: a number, a constant, something that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Divisor {
    Number,
    Constant,
    Moving,
}

/// A way to solve a fact for a leaf: the less, the better. The highest rate goes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Cost {
    divisor: Divisor,
    kind: Kind,
    lower: u8,
    nodes: usize,
}

/// A fact l = r that is not solved yet: e = l − r, with what is solved put in.
struct Open {
    fact: FactId,
    e: Expr,
}

/// Why an expression vanishes: d times it is a sum of multiples of facts, with what is solved put in.
struct Vanishing {
    multiplier: Option<Expr>,
    terms: Vec<(FactId, Expr)>,
}

struct Attempt<'a> {
    search: Search,
    sequent: &'a Sequent,
    /// Equations that are known.
    facts: Vec<FactId>,
    /// Assumptions and inequalities.
    assumptions: Vec<FactId>,
}

impl Attempt<'_> {
    fn run(&mut self, conserved: Option<u32>) -> Option<FactId> {
        self.give();
        self.differentiate(u8::from(conserved.is_some()));
        let claim = self.sequent.claim.clone();
        if claim.sense != Sense::Equal {
            return None;
        }
        if let Some(at) = conserved {
            let fact = self.carry(&claim.left, at)?;
            return self.weaken(fact);
        }
        let says = self.search.draft.claim_says()?;
        let (left, right) = self.search.reader.sides(&says)?;
        let goal = self.search.reader.graph.sub(left, right);
        if let Some(fact) = self.algebra(&claim, goal) {
            return self.weaken(fact);
        }
        // What the rates leave open the values at fixed times may decide.
        let instants = self.instants(goal);
        let carried: Vec<FactId> = instants.iter().filter_map(|&at| self.carry(&claim.left, at)).collect();
        self.take_values(&instants);
        self.facts.extend(carried);
        let fact = self.algebra(&claim, goal)?;
        self.weaken(fact)
    }

    fn algebra(&mut self, claim: &Relation, goal: Expr) -> Option<FactId> {
        let Vanishing { multiplier, terms } = self.vanishing(goal)?;
        self.search.zero(claim.clone(), multiplier, &terms)
    }

    /// The positions of the fixed times at which something in an expression is taken.
    fn instants(&mut self, e: Expr) -> Vec<u32> {
        let named = self.search.reader.graph.leaves([e]);
        let at = |c: &Expr| named.iter().any(|leaf| leaf.instant == Some(*c));
        let all: Vec<Option<Expr>> = self.sequent.instants.iter().map(|term| self.search.reader.read(term)).collect();
        (0..all.len() as u32).filter(|&i| all[i as usize].as_ref().is_some_and(at)).collect()
    }

    /// Takes all that is given.
    fn give(&mut self) {
        let count = |n: usize| 0..n as u32;
        let sequent = self.sequent;
        let assumed = count(sequent.selectors.len()).map(Given::Selector);
        for given in assumed.chain(count(sequent.assumed.len()).map(Given::Assumed)) {
            let fact = self.search.push(Step::Given { given, because: vec![] });
            self.assumptions.extend(fact);
        }
        if !self.assumptions.is_empty() {
            let _ = self.search.draft.push(Step::Open { because: self.assumptions.clone() });
        }
        self.facts.extend(&self.assumptions);
        let others = count(sequent.systems.len()).map(Given::System);
        for given in others.chain(count(sequent.premises.len()).map(Given::Premise)) {
            let fact = self.search.push(Step::Given { given, because: vec![] });
            self.facts.extend(fact);
        }
        for given in count(sequent.claims.len()).map(Given::Claimed) {
            let because = self.assumptions.clone();
            let plain = self.search.push(Step::Given { given, because: vec![] });
            let fact = plain.or_else(|| self.search.push(Step::Given { given, because }));
            self.facts.extend(fact);
        }
    }

    fn highest_rate(&mut self, relation: &Relation) -> u8 {
        let Some((l, r)) = self.search.reader.sides(relation) else { return 0 };
        self.search.reader.graph.leaves([l, r]).into_iter().map(|leaf| leaf.rate).max().unwrap_or(0)
    }

    /// Adds the rates of facts, as far as the claim and the facts name rates.
    fn differentiate(&mut self, more: u8) {
        let claim = self.search.draft.claim_says();
        let says: Vec<_> = self.facts.iter().filter_map(|&id| self.search.draft.says(id)).chain(claim).collect();
        let wanted = says.iter().map(|relation| self.highest_rate(relation)).max().unwrap_or(0).max(more);
        let mut open = self.facts.clone();
        while let Some(id) = open.pop() {
            let Some(relation) = self.search.draft.says(id) else { continue };
            if self.highest_rate(&relation) >= wanted || self.facts.len() >= MOST_FACTS {
                continue;
            }
            if let Some(rate) = self.search.push(Step::Rate { fact: id }) {
                self.facts.push(rate);
                open.push(rate);
            }
        }
    }

    /// Adds what facts say at fixed times.
    fn take_values(&mut self, instants: &[u32]) {
        let facts = self.facts.clone();
        for &instant in instants {
            for &fact in &facts {
                if self.facts.len() < MOST_FACTS {
                    let to = When::At(Instant(instant));
                    let made = self.search.push(Step::Restrict { fact, to, because: vec![] });
                    self.facts.extend(made);
                }
            }
        }
    }

    /// e = e(c), if the rate of e is found to be 0.
    fn carry(&mut self, of: &Term, at: u32) -> Option<FactId> {
        let rate = self.search.draft.derivative(of).ok()?;
        let d = self.search.reader.read(&rate)?;
        let because = self.values_throughout();
        let fact = if self.search.reader.graph.is_zero(d) {
            self.search.solved.clear();
            self.search.zero(Relation::equal(Term::integer(0), Term::integer(0)), None, &[])?
        } else {
            self.algebra(&Relation::equal(rate, Term::integer(0)), d)?
        };
        let free = self.search.push(Step::Discharge { fact, because: because.clone() }).unwrap_or(fact);
        self.search.push(Step::Conserved { of: of.clone(), at: Instant(at), rate: free, because })
    }

    /// What something given needs, since it has values.
    fn values_of(&mut self, given: Given) -> Vec<FactId> {
        (0..).map_while(|need| self.search.push(Step::HasValue { given, need })).collect()
    }

    fn values_throughout(&mut self) -> Vec<FactId> {
        (0..self.sequent.systems.len() as u32).flat_map(|at| self.values_of(Given::System(at))).collect()
    }

    /// The fact at the times at which the claim has a value, with as few needs as can be.
    fn weaken(&mut self, fact: FactId) -> Option<FactId> {
        let within = When::Chosen.within(CaseId::CLAIM);
        let fact = self.search.push(Step::Restrict { fact, to: within, because: vec![] })?;
        let mut because = self.assumptions.clone();
        because.extend(self.values_throughout());
        for need in 0..self.search.draft.claim_needs().len() as u32 {
            because.extend(self.search.push(Step::ClaimHasValue { need, within: When::Chosen }));
        }
        for at in 0..self.sequent.assumed.len() as u32 {
            because.extend(self.values_of(Given::Assumed(at)));
        }
        let mut best = fact;
        let steps = because.iter().map(|&each| vec![each]).chain([because.clone()]);
        for because in steps.collect::<Vec<_>>() {
            let fewer = self.search.push(Step::Discharge { fact: best, because });
            let count = |id: FactId| self.search.draft.needs(id).len();
            if let Some(fewer) = fewer.filter(|&fewer| count(fewer) < count(best)) {
                best = fewer;
            }
        }
        Some(best)
    }

    /// Why an expression vanishes, as far as facts can be solved: first for what they say without dividing by anything that moves.
    fn vanishing(&mut self, goal: Expr) -> Option<Vanishing> {
        self.search.solved.clear();
        let mut rest: Vec<Open> = Vec::new();
        for &fact in &self.facts {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            rest.push(Open { fact, e: self.search.reader.graph.sub(l, r) });
        }
        let mut e = goal;
        for divisor in [Divisor::Number, Divisor::Constant, Divisor::Moving] {
            for kind in [Kind::Rate, Kind::Value, Kind::Fixed, Kind::Constant] {
                if let Some(found) = self.vanishes(e, &rest) {
                    return Some(found);
                }
                for _ in 0..MOST_ROUNDS {
                    let leaves = self.search.reader.graph.leaves([e]);
                    let Some((at, leaf)) = self.best(&rest, &leaves, divisor, kind) else { break };
                    let open = rest.remove(at);
                    let Some(solved) = self.solve(&open, leaf) else { continue };
                    if !self.search.put_in(&mut e, solved) {
                        return None;
                    }
                    rest.retain_mut(|open| self.search.put_in(&mut open.e, solved));
                }
            }
        }
        self.vanishes(e, &rest)
    }

    /// Whether an expression vanishes as it stands, or divided by what is known.
    fn vanishes(&mut self, e: Expr, rest: &[Open]) -> Option<Vanishing> {
        if self.is_identity(e) {
            return Some(Vanishing { multiplier: None, terms: Vec::new() });
        }
        self.divided(e, rest)
    }

    fn is_identity(&mut self, e: Expr) -> bool {
        if self.search.reader.graph.is_zero(e) {
            return true;
        }
        self.search.work += IDENTITY + self.search.reader.graph.reachable([e]).len() * 10;
        if self.search.is_spent() {
            return false;
        }
        let Some(left) = self.search.reader.term(e) else { return false };
        let says = Relation::equal(left, Term::integer(0));
        let step = Step::Zero { says, multiplier: Term::integer(1), terms: vec![], insert: vec![] };
        self.search.draft.clone().push(step).is_ok()
    }

    /// The fact that is solved most easily for one of these leaves, as costly as is allowed.
    fn best(&mut self, rest: &[Open], leaves: &[Leaf], divisor: Divisor, kind: Kind) -> Option<(usize, Leaf)> {
        let mut best: Option<(Cost, usize, Leaf)> = None;
        for (at, open) in rest.iter().enumerate() {
            let ways = self.ways(open.e, leaves);
            let allowed = ways.into_iter().filter(|(cost, _)| cost.divisor <= divisor && cost.kind <= kind);
            if let Some((cost, leaf)) = allowed.min_by_key(|(cost, _)| *cost)
                && best.as_ref().is_none_or(|b| cost < b.0)
            {
                best = Some((cost, at, leaf));
            }
        }
        best.map(|(_, at, leaf)| (at, leaf))
    }

    fn kind_of(&self, leaf: Leaf) -> Option<Kind> {
        let name = self.search.reader.graph.name(leaf.symbol);
        let declared = self.sequent.symbols.iter().find(|d| d.name == name)?;
        match (declared.kind, leaf.instant, leaf.rate) {
            (SymbolKind::Time, ..) => None,
            (SymbolKind::Constant(_), ..) => Some(Kind::Constant),
            (SymbolKind::Moves(_) | SymbolKind::Defined, Some(_), _) => Some(Kind::Fixed),
            (SymbolKind::Moves(_) | SymbolKind::Defined, None, 0) => Some(Kind::Value),
            (SymbolKind::Moves(_) | SymbolKind::Defined, None, _) => Some(Kind::Rate),
        }
    }

    /// The leaves, of those that are wanted, for which an expression can be solved.
    fn ways(&mut self, e: Expr, wanted: &[Leaf]) -> Vec<(Cost, Leaf)> {
        let nodes = self.search.reader.graph.reachable([e]).len();
        self.search.work += nodes;
        let mut out = Vec::new();
        if nodes > MOST_NODES || self.search.is_spent() {
            return out;
        }
        for leaf in self.search.reader.graph.leaves([e]) {
            let Some(kind) = self.kind_of(leaf).filter(|_| wanted.contains(&leaf)) else { continue };
            self.search.work += nodes;
            let Ok(factor) = self.search.reader.graph.slope(e, leaf) else { continue };
            let below = self.search.reader.graph.leaves([factor]);
            if self.search.reader.graph.is_zero(factor) || below.contains(&leaf) {
                continue;
            }
            let moves = |l: &Leaf| matches!(self.kind_of(*l), None | Some(Kind::Rate | Kind::Value));
            let divisor = match below.iter().any(moves) {
                true => Divisor::Moving,
                false if below.is_empty() => Divisor::Number,
                false => Divisor::Constant,
            };
            out.push((Cost { divisor, kind, lower: u8::MAX - leaf.rate, nodes }, leaf));
        }
        out
    }

    /// Solves e for a leaf: e = d·x + rest.
    fn solve(&mut self, open: &Open, leaf: Leaf) -> Option<Solved> {
        let graph = &mut self.search.reader.graph;
        let factor = graph.slope(open.e, leaf).ok()?;
        let (zero, one) = (graph.integer(0), graph.integer(1));
        let rest = graph.replaced(open.e, |_, l| (l == leaf).then_some(zero));
        let ratio = graph.div(rest, factor);
        let value = graph.neg(ratio);
        let node = graph.leaf(leaf);
        let says = self.search.reader.equation(node, value)?;
        let fact = self.search.zero(says, Some(factor), &[(open.fact, one)])?;
        self.search.solved.push(fact);
        Some(Solved { node, value })
    }

    /// The numerator of an expression, divided by laws of the functions in it and by facts of a higher degree.
    fn divided(&mut self, e: Expr, rest: &[Open]) -> Option<Vanishing> {
        self.search.work += self.search.reader.graph.reachable([e]).len();
        if self.search.is_spent() {
            return None;
        }
        let quotient = fraction(&mut self.search.reader.graph, e)?;
        let denominator = quotient.denominator(&mut self.search.reader.graph);
        let multiplier = Some(denominator).filter(|_| !quotient.is_whole());
        let (mut e, mut terms) = (quotient.numerator, Vec::new());
        let divisors = self.divisors(e, rest);
        for _ in 0..MOST_DIVISIONS {
            let mut changed = false;
            for &(p, v, fact) in &divisors {
                let nodes = self.search.reader.graph.reachable([e]).len();
                self.search.work += nodes * 4;
                if nodes > MOST_NODES || self.search.is_spent() {
                    return None;
                }
                let Some(division) = divide(&mut self.search.reader.graph, e, p, v) else { continue };
                terms.push((fact, division.quotient));
                e = division.rest;
                changed = true;
                if self.is_identity(e) {
                    return Some(Vanishing { multiplier, terms });
                }
            }
            if !changed || self.search.is_spent() {
                return None;
            }
        }
        None
    }

    /// Expressions that vanish, each with a node in which others are divided by it, and the fact that says so.
    fn divisors(&mut self, e: Expr, rest: &[Open]) -> Vec<(Expr, Expr, FactId)> {
        let mut divisors = self.laws(e);
        let wanted = self.search.reader.graph.leaves([e]);
        for Open { fact, e: p } in rest {
            for leaf in self.search.reader.graph.leaves([*p]).into_iter().filter(|leaf| wanted.contains(leaf)) {
                divisors.push((*p, self.search.reader.graph.leaf(leaf), *fact));
            }
        }
        divisors
    }

    /// Laws of the functions below an expression, as l − r, with the node in which they are divided out.
    fn laws(&mut self, e: Expr) -> Vec<(Expr, Expr, FactId)> {
        let mut out = Vec::new();
        for node in self.search.reader.graph.reachable([e]) {
            let found = match *self.search.reader.graph.node(node) {
                Node::Unary(Op::Cos, a) => Some((Law::Pythagoras, a)),
                Node::Unary(Op::Sqrt, a) => Some((Law::SquareOfRoot, a)),
                Node::Unary(Op::Abs, a) => Some((Law::SquareOfAbsolute, a)),
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => None,
            };
            let Some((law, argument)) = found else { continue };
            let Some(of) = self.search.reader.term(argument) else { continue };
            let Some(fact) = self.search.push(Step::Law { law, of: vec![of] }) else { continue };
            let Some((l, r)) = self.search.equation(fact) else { continue };
            out.push((self.search.reader.graph.sub(l, r), node, fact));
        }
        out
    }
}
