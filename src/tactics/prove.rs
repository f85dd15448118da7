//! The search: given facts, their rates and values, elimination, and the claim.
//!
//! **In:** a [`Question`]. **Out:** a proof that the checker accepted, or why none was found. **Guaranteed:** bounded: so many facts, so many nodes.

use crate::eliminate::{Search, Solved};
use crate::sequent::Question;
use crate::used::used;
use crate::vanish::{Beginning, order};
use crate::write::Reader;
use checker::{
    CaseId, Definition, Draft, FactId, Given, Instant, Manner, Relation, Sense, Sequent, Split, Step, SymbolKind, Term,
    TermNode, When,
};
use expr::{Expr, Leaf, Node, Op};

/// Most facts that are solved.
const MOST_FACTS: usize = 160;
/// Most formulas that are tried whether they are conserved.
const MOST_CARRIED: usize = 8;
/// Most inequalities of which two may be an equation.
const MOST_ORDERED: usize = 8;

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
        is_placed: false,
    };
    let shown = attempt.run(question.conserved).ok_or("no proof was found by algebra and rates")?;
    let mut draft = attempt.search.draft;
    draft.push(Step::Conclude { fact: shown }).map_err(|refused| refused.to_string())?;
    let (steps, _) = draft.finish().map_err(|refused| refused.to_string())?;
    Ok(used(steps))
}

pub(crate) struct Attempt<'a> {
    pub(crate) search: Search,
    pub(crate) sequent: &'a Sequent,
    /// Equations that are known.
    pub(crate) facts: Vec<FactId>,
    /// Assumptions and inequalities.
    pub(crate) assumptions: Vec<FactId>,
    is_placed: bool,
}

impl Attempt<'_> {
    fn run(&mut self, conserved: Option<u32>) -> Option<FactId> {
        self.give();
        for fact in self.assumptions.clone() {
            let told = self.by_laws(fact);
            self.assumptions.extend(told);
        }
        self.differentiate(u8::from(conserved.is_some()));
        let claim = self.sequent.claim.clone();
        if claim.sense != Sense::Equal {
            let fact = self.ordered(&claim).or_else(|| {
                self.place();
                self.ordered(&claim)
            })?;
            return self.weaken(fact);
        }
        if let Some(at) = conserved
            && let Some(fact) = self.carry(&claim.left, at)
        {
            return self.weaken(fact);
        }
        let says = self.search.draft.claim_says()?;
        let (left, right) = self.search.reader.sides(&says)?;
        let goal = self.search.reader.graph.sub(left, right);
        let fact = self.show(&claim, left, right, goal)?;
        self.place();
        self.weaken(fact)
    }

    /// Learns where the arguments of functions lie: once, and no earlier than it is of use.
    fn place(&mut self) {
        if !self.is_placed {
            self.is_placed = true;
            let places = self.on_stretches();
            self.assumptions.extend(places);
        }
    }

    /// The claim, by one way after the other: by algebra alone, with values at fixed times, with formulas as wholes, by squares.
    fn show(&mut self, claim: &Relation, left: Expr, right: Expr, goal: Expr) -> Option<FactId> {
        let like = self.like_a_fact(claim, left, right);
        if let (Some(fact), _) = like {
            return Some(fact);
        }
        let of_logarithms = self.by_logarithms(claim, goal);
        if of_logarithms.is_some() {
            return of_logarithms;
        }
        // A fact about a side of the claim is put in before anything is solved.
        let mut ways = [Beginning::Plain, Beginning::Wholes];
        if like.1 {
            ways.reverse();
        }
        if let Some(fact) = ways.into_iter().find_map(|beginning| self.renewed(claim, goal, beginning)) {
            return Some(fact);
        }
        // What the rates leave open the values at fixed times may decide.
        let mut instants = self.instants(goal);
        if instants.is_empty() {
            instants = (0..self.sequent.instants.len() as u32).collect();
        }
        if !instants.is_empty() {
            let carried = self.carried([&claim.left, &claim.right], goal, &instants);
            let since = self.carried_here(claim, goal);
            self.facts.extend(since);
            self.take_values(&instants);
            self.facts.extend(carried);
            if let Some(fact) = ways.into_iter().find_map(|beginning| self.renewed(claim, goal, beginning)) {
                return Some(fact);
            }
        }
        if let Some(fact) = self.by_uniqueness(claim, goal) {
            return Some(fact);
        }
        self.place();
        self.search.renew();
        self.by_squares(claim, left, right)
    }

    /// The claim, as a fact with a side of it says it in other words; and whether there is such a fact.
    fn like_a_fact(&mut self, claim: &Relation, left: Expr, right: Expr) -> (Option<FactId>, bool) {
        let mut shared = false;
        let is_formula = |this: &Self, e: Expr| this.search.reader.graph.reachable([e]).len() > 1;
        self.search.solved.clear();
        for fact in self.facts.clone() {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            let shares = |a: Expr, b: Expr| a == b && is_formula(self, a);
            let same = shares(l, left) || shares(r, right);
            if !same && !shares(l, right) && !shares(r, left) {
                continue;
            }
            shared = true;
            let sign = self.search.reader.graph.integer(if same { 1 } else { -1 });
            let found = self.search.zero(claim.clone(), None, &[(fact, sign)], &[]);
            if found.is_some() {
                return (found, true);
            }
        }
        (None, shared)
    }

    pub(crate) fn renewed(&mut self, claim: &Relation, goal: Expr, beginning: Beginning) -> Option<FactId> {
        self.search.renew();
        self.algebra(claim, goal, beginning)
    }

    /// Sides of the claim, and definitions in it, that are found to be conserved: what they are at fixed times.
    fn carried(&mut self, sides: [&Term; 2], goal: Expr, instants: &[u32]) -> Vec<FactId> {
        let mut of: Vec<Term> = sides.into_iter().cloned().collect();
        let below = self.search.reader.graph.reachable([goal]);
        for definition in &self.sequent.definitions {
            let name = definition.name.clone();
            let term = Term(vec![TermNode::Leaf { name, component: definition.component, rate: 0, at: None }]);
            let is_whole = self.search.draft.formula(&term).and_then(|formula| self.search.reader.read(&formula));
            let is_function =
                |e: &Expr| matches!(self.search.reader.graph.node(*e), Node::Unary(..) | Node::Binary(..));
            if is_whole.is_some_and(|e| is_function(&e) && below.contains(&e)) && of.len() < MOST_CARRIED {
                of.push(term);
            }
        }
        of.extend(self.differences(goal));
        let each = instants.iter().flat_map(|&at| of.iter().map(move |term| (term, at)));
        each.filter_map(|(term, at)| if self.is_constant(term) { None } else { self.carry(term, at) }).collect()
    }

    /// What a claim says of fixed times, if it is conserved as it is at any time: x = x(0), where x(1) is asked for.
    fn carried_here(&mut self, claim: &Relation, goal: Expr) -> Vec<FactId> {
        let sides = [&claim.left, &claim.right].into_iter().filter_map(|side| self.search.reader.read(side));
        let mut of: Vec<Term> = Vec::new();
        for then in sides.chain([goal]).collect::<Vec<_>>() {
            let present = |leaf: Leaf| leaf.instant.map(|_| Leaf { instant: None, ..leaf });
            let graph = &mut self.search.reader.graph;
            let now = graph.replaced(then, |graph, leaf| present(leaf).map(|leaf| graph.leaf(leaf)));
            of.extend(Some(now).filter(|now| *now != then).and_then(|now| self.search.reader.term(now)));
        }
        of.dedup();
        let instants = 0..(self.sequent.instants.len().min(MOST_CARRIED) as u32);
        let each = of.iter().flat_map(|term| instants.clone().map(move |at| (term, at)));
        each.filter_map(|(term, at)| if self.is_constant(term) { None } else { self.carry(term, at) }).collect()
    }

    /// Of a claim that names the time, the difference of the sides, as it is and with formulas put in that do not move.
    fn differences(&mut self, goal: Expr) -> Vec<Term> {
        let is_time = |this: &Self, leaf: Leaf| this.kind_of(leaf).is_none() && leaf.instant.is_none();
        if self.variables().len() > 1 || !self.search.reader.graph.leaves([goal]).into_iter().any(|l| is_time(self, l))
        {
            return Vec::new();
        }
        self.search.renew();
        let mut e = goal;
        for fact in self.facts.clone() {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            for (node, value) in [(l, r), (r, l)] {
                let is_whole = self.search.reader.graph.reachable([node]).len() > 1;
                if is_whole && self.moves(node) && !self.moves(value) {
                    self.search.put_in(&mut e, Solved { node, value });
                }
            }
        }
        let mut all = vec![goal];
        all.extend(Some(e).filter(|e| *e != goal));
        all.into_iter().filter_map(|e| self.search.reader.term(e)).collect()
    }

    /// Whether a formula does not move, or is given as what it is at a fixed time.
    fn is_constant(&mut self, of: &Term) -> bool {
        let Some(e) = self.search.draft.formula(of).and_then(|formula| self.search.reader.read(&formula)) else {
            return false;
        };
        if !self.moves(e) {
            return true;
        }
        let sides: Vec<_> = self.facts.clone().into_iter().filter_map(|fact| self.search.equation(fact)).collect();
        sides.into_iter().any(|(l, r)| l == e && !self.moves(r) || r == e && !self.moves(l))
    }

    /// Whether an expression names the present time.
    pub(crate) fn moves(&self, e: Expr) -> bool {
        let leaves = self.search.reader.graph.leaves([e]);
        let still = |leaf| matches!(self.kind_of(leaf), Some(crate::vanish::Kind::Constant));
        leaves.into_iter().any(|leaf| leaf.instant.is_none() && !still(leaf))
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
            let _ = self.search.draft.push(Step::Everywhere { because: vec![] });
        }
        self.facts.extend(&self.assumptions);
        let others = count(sequent.systems.len()).map(Given::System);
        for given in others.chain(count(sequent.premises.len()).map(Given::Premise)) {
            let fact = self.search.push(Step::Given { given, because: vec![] });
            self.facts.extend(fact);
            let says = fact.and_then(|fact| self.search.draft.says(fact));
            if says.is_some_and(|says| says.sense != Sense::Equal) {
                self.assumptions.extend(fact);
            }
        }
        let open = |step: &Step| matches!(step, Step::Open { .. });
        let chooses = !sequent.selectors.is_empty() || !sequent.assumed.is_empty();
        if chooses && !self.search.draft.steps().iter().any(open) {
            let because = [self.assumptions.clone(), self.values_throughout()].concat();
            let _ = self.search.draft.push(Step::Open { because });
        }
        let mut later = Vec::new();
        let chosen = count(sequent.selectors.len()).map(Given::Selector);
        let chosen = chosen.chain(count(sequent.assumed.len()).map(Given::Assumed));
        let values: Vec<FactId> = chosen.flat_map(|given| self.values_of(given)).collect();
        let known = [self.assumptions.clone(), values].concat();
        for given in count(sequent.claims.len()).map(Given::Claimed) {
            let because = known.clone();
            let plain = self.search.push(Step::Given { given, because: vec![] });
            let fact = plain.or_else(|| self.search.push(Step::Given { given, because }));
            later.extend(fact.is_none().then_some(given));
            self.facts.extend(fact);
            let says = fact.and_then(|fact| self.search.draft.says(fact));
            self.assumptions.extend(fact.filter(|_| says.is_some_and(|says| says.sense != Sense::Equal)));
        }
        self.meet();
        if later.is_empty() {
            return;
        }
        // What is assumed at the chosen times is so at all times, perhaps; then it brings more claims.
        let always = self.assumed_always();
        let free = |id: &FactId| self.search.draft.fact(*id).is_some_and(checker::Fact::is_free);
        let given: Vec<FactId> = self.facts.iter().copied().filter(free).collect();
        let because = [known, always, given, self.values_throughout()].concat();
        for given in later {
            let fact = self.search.push(Step::Given { given, because: because.clone() });
            self.facts.extend(fact);
        }
    }

    /// Equations from inequalities in both directions.
    fn meet(&mut self) {
        let ordered: Vec<(FactId, Relation)> = self
            .assumptions
            .iter()
            .filter_map(|&id| Some((id, self.search.draft.says(id)?)))
            .filter(|(_, says)| says.sense == Sense::LessOrEqual)
            .take(MOST_ORDERED)
            .collect();
        for (at, (one, says)) in ordered.iter().enumerate() {
            for (other, _) in &ordered[at + 1..] {
                let equal = Relation { sense: Sense::Equal, ..says.clone() };
                let fact = self.search.push(Step::Sign { says: equal, from: vec![*one, *other] });
                self.facts.extend(fact);
            }
        }
    }

    /// Assumed equations at all times, where facts of all times carry them: e = e(c), and e(c) = 0, which does not move.
    fn assumed_always(&mut self) -> Vec<FactId> {
        let mut out = Vec::new();
        let whole =
            |this: &Self, id: FactId| this.search.draft.fact(id).is_some_and(|fact| *fact.when() == When::Always);
        let integrals: Vec<FactId> = self.facts.clone().into_iter().filter(|&id| whole(self, id)).collect();
        for fact in self.assumptions.clone() {
            let Some((l, r)) = self.search.equation(fact).filter(|(l, r)| l != r) else { continue };
            let found = integrals.iter().find_map(|&integral| self.lifted(fact, [l, r], integral));
            out.extend(found);
        }
        out
    }

    /// l = r at all times, if an integral says that l − r is what it is at a fixed time.
    fn lifted(&mut self, fact: FactId, [l, r]: [Expr; 2], integral: FactId) -> Option<FactId> {
        let (e, then) = self.search.equation(integral)?;
        let graph = &mut self.search.reader.graph;
        let (one, minus, zero) = (graph.integer(1), graph.integer(-1), graph.integer(0));
        // e is l, or l − r.
        let value = match e {
            e if e == l => r,
            e if e == graph.sub(l, r) => zero,
            _ => return None,
        };
        let still = self.search.reader.equation(then, value)?;
        let still = self.search.zero(still, None, &[(fact, one), (integral, minus)], &[])?;
        let says = self.search.reader.equation(l, r)?;
        self.search.zero(says, None, &[(integral, one), (still, one)], &[])
    }

    /// An inequality with the functions in it as laws write them: of sin atan2(y, x) ≠ 0, y/√(x² + y²) ≠ 0.
    pub(crate) fn by_laws(&mut self, fact: FactId) -> Option<FactId> {
        let says = self.search.draft.says(fact).filter(|says| says.sense != Sense::Equal)?;
        let (mut sides, before) = (Vec::new(), self.search.solved.len());
        let (left, right) = self.search.reader.sides(&says)?;
        for mut side in [left, right] {
            self.normalise(&mut side, &mut [])?;
            sides.push(self.search.reader.term(side)?);
        }
        let laws = self.search.solved.split_off(before);
        let mut equal = Vec::new();
        for law in laws {
            // Turned, since the right side is written as the left one.
            let says = self.search.draft.says(law)?;
            let terms = vec![(law, Term::integer(-1))];
            let (turned, multiplier) = (Relation::equal(says.right, says.left), Term::integer(1));
            let step = Step::Zero { says: turned, multiplier, terms, insert: vec![], modulo: vec![] };
            equal.push(self.search.push(step)?);
        }
        let right = sides.pop()?;
        let says = Relation { left: sides.pop()?, sense: says.sense, right };
        if equal.is_empty() { None } else { self.search.push(Step::Congruence { says, from: Some(fact), equal }) }
    }

    fn highest_rate(&mut self, relation: &Relation) -> u8 {
        let Some((l, r)) = self.search.reader.sides(relation) else { return 0 };
        self.search.reader.graph.leaves([l, r]).into_iter().map(order).max().unwrap_or(0)
    }

    /// Adds the rates of facts, as far as the claim and the facts name rates.
    fn differentiate(&mut self, more: u8) {
        let claim = self.search.draft.claim_says();
        let says: Vec<_> = self.facts.iter().filter_map(|&id| self.search.draft.says(id)).chain(claim).collect();
        let wanted = says.iter().map(|relation| self.highest_rate(relation)).max().unwrap_or(0).max(more);
        // A field that is a derivative of another one stands in the claim with derivatives of its own.
        let claimed = says.last().map_or(0, |relation| self.highest_rate(relation));
        let wanted = if self.variables().len() > 1 { wanted.max(claimed + 1) } else { wanted };
        // A fact, the last of the variables by which it was derived, as others are for those before, and how often it was.
        let variables = self.variables();
        let mut open: Vec<(FactId, usize, u8)> = self.facts.iter().map(|&id| (id, 0, 0)).collect();
        while let Some((id, last, times)) = open.pop() {
            let Some(relation) = self.search.draft.says(id) else { continue };
            // What names the time alone has no rates, however often it is derived.
            if self.highest_rate(&relation).max(times) >= wanted {
                continue;
            }
            for (at, variable) in variables.iter().enumerate().skip(last) {
                if self.facts.len() >= MOST_FACTS {
                    return;
                }
                let step = match variable {
                    None => Step::Rate { fact: id },
                    Some((by, component)) => Step::Partial { fact: id, by: by.clone(), component: *component },
                };
                if let Some(rate) = self.search.push(step) {
                    self.facts.push(rate);
                    open.push((rate, at, times + 1));
                }
            }
        }
    }

    /// The time, and the coordinates by their names and components.
    fn variables(&self) -> Vec<Option<(String, u16)>> {
        let coordinates = self.sequent.symbols.iter().filter(|d| d.kind == SymbolKind::Coordinate);
        let each = coordinates.flat_map(|d| (0..d.components).map(|component| Some((d.name.clone(), component))));
        [None].into_iter().chain(each).collect()
    }

    /// Adds what facts say at fixed times.
    pub(crate) fn take_values(&mut self, instants: &[u32]) {
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

    /// e = e(c), if the rate of e is found to be 0; or that of its argument, if e is a function: √u needs no rate where u is 0.
    fn carry(&mut self, of: &Term, at: u32) -> Option<FactId> {
        self.carry_by_rate(of, at).or_else(|| {
            let formula = self.formula_of(of).unwrap_or(of).clone();
            let e = self.search.reader.read(&formula)?;
            let Node::Unary(op, a) = *self.search.reader.graph.node(e) else { return None };
            let inner = self.search.reader.term(a)?;
            let fact = self.carry_by_rate(&inner, at)?;
            let (_, then) = self.search.equation(fact)?;
            let right = self.search.reader.graph.unary(op, then);
            let says = Relation::equal(of.clone(), self.search.reader.term(right)?);
            self.search.push(Step::Congruence { says, from: None, equal: vec![fact] })
        })
    }

    /// The formula of a symbol that is defined.
    fn formula_of(&self, of: &Term) -> Option<&Term> {
        let [TermNode::Leaf { name, component, rate: 0, at: None }] = of.0.as_slice() else { return None };
        let is_this = |d: &&Definition| d.name == *name && d.component == *component;
        self.sequent.definitions.iter().find(is_this).map(|d| &d.formula)
    }

    fn carry_by_rate(&mut self, of: &Term, at: u32) -> Option<FactId> {
        let rate = match self.search.draft.derivative(of) {
            Ok(rate) => rate,
            Err(_) => {
                self.raise();
                self.search.draft.derivative(of).ok()?
            }
        };
        let d = self.search.reader.read(&rate)?;
        let fact = if self.search.reader.graph.is_zero(d) {
            self.search.solved.clear();
            self.search.zero(Relation::equal(Term::integer(0), Term::integer(0)), None, &[], &[])?
        } else {
            self.rate_vanishes(&Relation::equal(rate, Term::integer(0)), d)?
        };
        let because = self.values_throughout();
        if let Some(found) = self.conserved_since(of, at, fact, because.clone()) {
            return Some(found);
        }
        // What the claim needs does not move, perhaps; then it holds at all times.
        let of_claim = 0..self.search.draft.claim_needs().len() as u32;
        let needs: Vec<FactId> =
            of_claim.filter_map(|need| self.search.push(Step::ClaimHasValue { need, within: When::Always })).collect();
        let found = self.conserved(of, at, fact, [&because[..], &needs].concat());
        found.or_else(|| self.conserved_by_case(of, at, fact, &because))
    }

    /// What is conserved, by what is known throughout, by what is equal to it, and by what these make of what is needed.
    fn conserved_since(&mut self, of: &Term, at: u32, fact: FactId, because: Vec<FactId>) -> Option<FactId> {
        if let Some(found) = self.conserved(of, at, fact, because.clone()) {
            return Some(found);
        }
        let says = Relation::equal(of.clone(), of.clone());
        let same = self.search.push(Step::Congruence { says, from: None, equal: vec![] });
        let facts: Vec<FactId> = [Some(fact), same].into_iter().flatten().collect();
        let mut all = because;
        all.extend(self.by_equals(&all.clone()));
        all.extend(self.needed(&facts, &all.clone()));
        self.conserved(of, at, fact, all)
    }

    /// What is conserved in the case that what the claim needs at fixed times is not 0; otherwise the claim has no value.
    fn conserved_by_case(&mut self, of: &Term, at: u32, fact: FactId, because: &[FactId]) -> Option<FactId> {
        let mut product = self.search.reader.graph.integer(1);
        for need in self.search.draft.claim_needs() {
            let (l, _) = self.search.reader.sides(&need)?;
            if need.sense == Sense::NotEqual && !self.moves(l) {
                product = self.search.reader.graph.mul(product, l);
            }
        }
        if self.search.reader.graph.as_constant(product).is_some() {
            return None;
        }
        let left = self.search.reader.term(product)?;
        let within = When::Chosen.within(CaseId::CLAIM);
        let of_claim = 0..self.search.draft.claim_needs().len() as u32;
        let values: Vec<FactId> =
            of_claim.filter_map(|need| self.search.push(Step::ClaimHasValue { need, within: When::Chosen })).collect();
        let [some, none] = [Sense::NotEqual, Sense::Equal]
            .map(|sense| Relation { left: left.clone(), sense, right: Term::integer(0) })
            .map(|says| self.search.suppose(says, Manner::AtTimes));
        let (some, none) = (some?, none?);
        let supposed = self.search.push(Step::Supposition { case: some, within: When::Always })?;
        let found = self.conserved_since(of, at, fact, [because, &[supposed]].concat())?;
        let supposed = self.search.push(Step::Supposition { case: none, within: within.clone() })?;
        let says = self.search.draft.says(found)?;
        let otherwise = self.search.push(Step::Sign { says, from: [&values[..], &[supposed]].concat() })?;
        let split = Split::Order(left, Term::integer(0));
        self.search.push(Step::Close { within, split, branches: vec![found, otherwise], because: vec![] })
    }

    /// Gives symbols further rates, where the highest is a function that has one.
    fn raise(&mut self) {
        let because = self.values_throughout();
        for fact in self.facts.clone() {
            let before = self.search.draft.steps().len();
            if let Some((l, _)) = self.search.sides_of.get(&fact)
                && let Node::Leaf(_) = *self.search.reader.graph.node(*l)
            {
                let _ = self.search.draft.push(Step::Smooth { fact, because: because.clone() });
            }
            if self.search.draft.steps().len() > before
                && let Some(rate) = self.search.push(Step::Rate { fact })
            {
                self.facts.push(rate);
            }
        }
    }

    /// What is equal, at all times, to something of a known sign that does not move, is not 0.
    fn by_equals(&mut self, known: &[FactId]) -> Vec<FactId> {
        let mut out = Vec::new();
        for fact in self.facts.clone() {
            let whole = self.search.draft.fact(fact).is_some_and(|fact| *fact.when() == When::Always && fact.is_free());
            let Some((l, r)) = self.search.equation(fact).filter(|_| whole) else { continue };
            for (moving, still, equal) in [(l, r, true), (r, l, false)] {
                if self.moves(still) || !self.moves(moving) {
                    continue;
                }
                let not_zero = |this: &Self, e: Expr| {
                    let left = this.search.reader.term(e)?;
                    Some(Relation { left, sense: Sense::NotEqual, right: Term::integer(0) })
                };
                let Some((says, said)) = not_zero(self, still).zip(not_zero(self, moving)) else { continue };
                let Some(from) = self.search.push(Step::Sign { says, from: known.to_vec() }) else { continue };
                let equal = if equal { Some(fact) } else { self.turned(fact) };
                let Some(equal) = equal else { continue };
                out.extend(self.search.push(Step::Congruence { says: said, from: Some(from), equal: vec![equal] }));
            }
        }
        out
    }

    /// r = l of l = r.
    fn turned(&mut self, fact: FactId) -> Option<FactId> {
        let (l, r) = self.search.equation(fact)?;
        let says = self.search.reader.equation(r, l)?;
        let minus = self.search.reader.graph.integer(-1);
        let before = std::mem::take(&mut self.search.solved);
        let found = self.search.zero(says, None, &[(fact, minus)], &[]);
        self.search.solved = before;
        found
    }

    /// What facts need, by the rules of signs, as soon as it is written so that they see it.
    pub(crate) fn needed(&mut self, facts: &[FactId], known: &[FactId]) -> Vec<FactId> {
        let needs: Vec<Relation> = facts.iter().flat_map(|&id| self.search.draft.needs(id)).collect();
        let mut out: Vec<FactId> = Vec::new();
        for need in needs {
            let Some((l, r)) = self.search.reader.sides(&need) else { continue };
            let difference = self.search.reader.graph.sub(l, r);
            // A root is not 0 where what is below it is positive.
            for node in self.search.reader.graph.reachable([difference]) {
                let Node::Unary(Op::Sqrt, under) = *self.search.reader.graph.node(node) else { continue };
                let opposite = self.search.reader.graph.neg(under);
                out.extend(self.signed(opposite, Sense::Less, known));
            }
            let Some(found) = self.signed(difference, need.sense, known) else { continue };
            let Some(said) = self.search.push(Step::Sign { says: need, from: vec![found] }) else { continue };
            out.push(self.search.push(Step::Discharge { fact: said, because: known.to_vec() }).unwrap_or(said));
        }
        out
    }

    fn conserved(&mut self, of: &Term, at: u32, fact: FactId, because: Vec<FactId>) -> Option<FactId> {
        let rate = self.search.push(Step::Discharge { fact, because: because.clone() }).unwrap_or(fact);
        self.search.push(Step::Conserved { of: of.clone(), at: Instant(at), rate, because })
    }

    fn rate_vanishes(&mut self, says: &Relation, d: Expr) -> Option<FactId> {
        [Beginning::Plain, Beginning::Wholes].into_iter().find_map(|beginning| self.renewed(says, d, beginning))
    }

    /// What something given needs, since it has values.
    pub(crate) fn values_of(&mut self, given: Given) -> Vec<FactId> {
        (0..).map_while(|need| self.search.push(Step::HasValue { given, need })).collect()
    }

    pub(crate) fn values_throughout(&mut self) -> Vec<FactId> {
        (0..self.sequent.systems.len() as u32).flat_map(|at| self.values_of(Given::System(at))).collect()
    }
}
