//! The search: given facts, their rates and values, elimination, and the claim.
//!
//! **In:** a [`Question`]. **Out:** a proof that the checker accepted, or why none was found. **Guaranteed:** bounded: so many facts, so many nodes.

use crate::eliminate::Search;
use crate::sequent::Question;
use crate::used::used;
use crate::vanish::{Beginning, order};
use crate::write::Reader;
use checker::{CaseId, Draft, FactId, Given, Instant, Relation, Sense, Sequent, Step, SymbolKind, Term, When};
use expr::Expr;

/// Most facts that are solved.
const MOST_FACTS: usize = 160;
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

pub(crate) struct Attempt<'a> {
    pub(crate) search: Search,
    pub(crate) sequent: &'a Sequent,
    /// Equations that are known.
    pub(crate) facts: Vec<FactId>,
    /// Assumptions and inequalities.
    pub(crate) assumptions: Vec<FactId>,
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
        let fact = self.show(&claim, left, right, goal)?;
        self.weaken(fact)
    }

    /// The claim, by one way after the other: by algebra alone, with values at fixed times, with formulas as wholes, by squares.
    fn show(&mut self, claim: &Relation, left: Expr, right: Expr, goal: Expr) -> Option<FactId> {
        for beginning in [Beginning::Plain, Beginning::Wholes] {
            self.search.renew();
            if let Some(fact) = self.algebra(claim, goal, beginning) {
                return Some(fact);
            }
            if beginning == Beginning::Plain {
                // What the rates leave open the values at fixed times may decide.
                let mut instants = self.instants(goal);
                if instants.is_empty() {
                    instants = (0..self.sequent.instants.len() as u32).collect();
                }
                let carried: Vec<FactId> = instants.iter().filter_map(|&at| self.carry(&claim.left, at)).collect();
                if instants.is_empty() && carried.is_empty() {
                    continue;
                }
                self.take_values(&instants);
                self.facts.extend(carried);
                self.search.renew();
                if let Some(fact) = self.algebra(claim, goal, beginning) {
                    return Some(fact);
                }
            }
        }
        self.search.renew();
        self.by_squares(claim, left, right)
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
            if let Given::Premise(at) = given
                && sequent.premises[at as usize].sense != Sense::Equal
            {
                self.assumptions.extend(fact);
            }
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
            self.search.zero(Relation::equal(Term::integer(0), Term::integer(0)), None, &[], &[])?
        } else {
            self.rate_vanishes(&Relation::equal(rate, Term::integer(0)), d)?
        };
        let free = self.search.push(Step::Discharge { fact, because: because.clone() }).unwrap_or(fact);
        self.search.push(Step::Conserved { of: of.clone(), at: Instant(at), rate: free, because })
    }

    fn rate_vanishes(&mut self, says: &Relation, d: Expr) -> Option<FactId> {
        let ways = [Beginning::Plain, Beginning::Wholes].into_iter();
        ways.into_iter().find_map(|beginning| {
            self.search.renew();
            self.algebra(says, d, beginning)
        })
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
}
