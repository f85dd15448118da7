//! Whether formulas are consistent in their units.
//!
//! **In:** a [`Derivation`] in which symbols have units. **Out:** one [`UnitAccount`] for each formula: of claims, systems,
//! definitions, measures, conditions, and values of trajectories. **Guaranteed:** `consistent` is said only when every symbol
//! of the formula has a unit and every sum, comparison and argument was looked at; a symbol without a unit leaves the formula
//! unchecked, but for what can be told without it.
//!
//! **The rules.** Terms of a sum, both sides of a relation, and the arguments of atan2 and agm have the same unit; arguments
//! of sin, exp, ln … and exponents are numbers; a rate has the unit of its symbol over that of the time. A literal is a number;
//! 0 agrees with every unit. The rules are those of a formula that keeps its truth when the base units are changed.

#![forbid(unsafe_code)]

mod infer;

use std::collections::HashMap;

use derivation::{Claim, Derivation, Form, FormFormula, SymbolEntry, Unit, Written};
use expr::{Expr, Graph, Leaf, Tensor};
use infer::{Fault, Inference, State};
use latex::{LimitPoint, Role, Statement};

/// A part of a formula and its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The part, in LaTeX.
    pub latex: String,
    /// Its unit, in base units; `1` for a number.
    pub unit: String,
}

/// What was found for one formula.
#[derive(Clone, Debug, PartialEq)]
pub enum UnitVerdict {
    /// All units agree.
    Consistent,
    /// Two terms that must have the same unit have not.
    Inconsistent {
        /// What the terms have to do with one another: `are added`, `are compared` …
        relation: String,
        /// The two terms.
        terms: Box<[Term; 2]>,
    },
    /// Not everything could be looked at.
    NotChecked {
        /// Why.
        reason: String,
    },
}

impl UnitVerdict {
    /// The word of the reports.
    pub fn word(&self) -> &'static str {
        match self {
            UnitVerdict::Consistent => "consistent",
            UnitVerdict::Inconsistent { .. } => "inconsistent",
            UnitVerdict::NotChecked { .. } => "not-checked",
        }
    }
}

/// One formula.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitAccount {
    /// Where it stands: `claim`, `symbol`, `system`, `measure`, `condition`, `trajectory` or `family`.
    pub kind: &'static str,
    /// The id or name of that.
    pub of: String,
    /// The formula as written.
    pub formula: String,
    /// What was found.
    pub verdict: UnitVerdict,
    /// Whether the file expects the claim to have an inconsistent formula.
    pub expected: bool,
}

/// The units of one derivation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UnitsAccount {
    /// Every formula, in the order of the file; none where no symbol has a unit.
    pub formulas: Vec<UnitAccount>,
    /// Claims that are expected to have an inconsistent formula, and have none.
    pub missed: Vec<String>,
}

impl UnitsAccount {
    /// How many formulas have this verdict.
    pub fn count(&self, word: &str) -> usize {
        self.formulas.iter().filter(|f| f.verdict.word() == word).count()
    }

    /// Keeps, of the claims, only those with these ids; all if there are none. Where only some are asked for, what is measured
    /// and what is offered as a condition is left out, too.
    pub fn keep(&mut self, claims: &[String]) {
        if claims.is_empty() {
            return;
        }
        let chosen = |name: &str| claims.iter().any(|c| name.split('/').next() == Some(c.as_str()));
        self.formulas.retain(|f| match f.kind {
            "claim" => chosen(&f.of),
            "measure" | "condition" => false,
            _ => true,
        });
        self.missed.retain(|name| chosen(name));
    }

    /// How much is not as the file expects: inconsistent formulas that are not expected, and expected ones that are not there.
    pub fn unexpected(&self) -> usize {
        let inconsistent = |f: &&UnitAccount| f.verdict.word() == "inconsistent" && !f.expected;
        self.formulas.iter().filter(inconsistent).count() + self.missed.len()
    }
}

/// Checks the units of every formula of a derivation. Empty if nothing in the file has a unit.
pub fn units(derivation: &Derivation) -> UnitsAccount {
    let entries = || derivation.symbols.iter().chain(derivation.claims.iter().flat_map(|c| &c.symbols));
    let has_unit = entries().any(|s| s.measured_in.is_some()) || derivation.measures.iter().any(|m| m.unit.is_some());
    if !has_unit {
        return UnitsAccount::default();
    }
    let mut checker = Checker::new(derivation);
    checker.symbols();
    checker.systems();
    checker.trajectories();
    checker.families();
    checker.claims();
    checker.measures();
    checker.conditions();
    checker.out
}

/// Whether relations between pairs of sides, or expressions by themselves, are inconsistent in their units; `graph` is that of
/// the derivation, or a copy with more in it. Nothing is inconsistent where nothing has a unit.
pub fn inconsistent(derivation: &Derivation, graph: &Graph, formulas: &[Vec<(Expr, Option<Expr>)>]) -> Vec<bool> {
    if !derivation.symbols.iter().any(|s| s.measured_in.is_some()) {
        return vec![false; formulas.len()];
    }
    let inference = Inference::new(graph, derivation.scope.time(), derivation.scope.branch_sign());
    let mut checker = Checker { derivation, inference, out: UnitsAccount::default(), seen: HashMap::new() };
    checker.symbols();
    let mut is_different = |(l, r): &(Expr, Option<Expr>)| {
        let inside: Vec<Expr> = std::iter::once(*l).chain(*r).collect();
        let fault = checker.inference.fault(&inside);
        let fault = fault.or_else(|| r.and_then(|r| checker.inference.compared(*l, r)));
        matches!(fault, Some(Fault::Different { .. }))
    };
    formulas.iter().map(|sides| sides.iter().any(&mut is_different)).collect()
}

/// The formulas of a derivation, one after the other.
struct Checker<'d> {
    derivation: &'d Derivation,
    inference: Inference<'d>,
    out: UnitsAccount,
    /// Formulas that were looked at: a reading repeats those of its claim.
    seen: HashMap<(usize, Vec<Expr>), usize>,
}

/// The file's and every claim's symbols, each once.
fn all_symbols(derivation: &Derivation) -> Vec<(&SymbolEntry, Option<&Claim>)> {
    let mut out: Vec<(&SymbolEntry, Option<&Claim>)> = derivation.symbols.iter().map(|s| (s, None)).collect();
    for claim in &derivation.claims {
        for entry in &claim.symbols {
            if !out.iter().any(|(s, _)| s.symbol == entry.symbol) {
                out.push((entry, Some(claim)));
            }
        }
    }
    out
}

impl<'d> Checker<'d> {
    fn new(derivation: &'d Derivation) -> Checker<'d> {
        let inference = Inference::new(&derivation.graph, derivation.scope.time(), derivation.scope.branch_sign());
        Checker { derivation, inference, out: UnitsAccount::default(), seen: HashMap::new() }
    }

    fn graph(&self) -> &'d Graph {
        &self.derivation.graph
    }

    /// Notes the verdict of a formula; `exprs` are everything that it consists of.
    fn note(
        &mut self,
        kind: &'static str,
        of: &str,
        formula: &str,
        exprs: &[Expr],
        fault: Option<Fault>,
        expected: bool,
    ) {
        let verdict = match fault.or_else(|| self.inference.fault(exprs)) {
            Some(Fault::Different { relation, terms }) => UnitVerdict::Inconsistent { relation, terms },
            Some(Fault::Scale { relation, terms }) => UnitVerdict::NotChecked {
                reason: format!(
                    "{} in {} and {} in {} {relation}: the same kind of quantity in units of different size, which a number \
                     in the formula may or may not make good",
                    terms[0].latex, terms[0].unit, terms[1].latex, terms[1].unit
                ),
            },
            None => {
                let names = self.inference.without_unit(exprs);
                match names.as_slice() {
                    [] => UnitVerdict::Consistent,
                    [one] => UnitVerdict::NotChecked { reason: format!("{one} has no unit") },
                    more => UnitVerdict::NotChecked { reason: format!("{} have no units", more.join(", ")) },
                }
            }
        };
        self.out.formulas.push(UnitAccount { kind, of: of.to_owned(), formula: formula.to_owned(), verdict, expected });
    }

    /// Definitions: their units are those of their formulas.
    fn symbols(&mut self) {
        // Rates need the unit of the time, wherever it is declared.
        for entry in self.derivation.symbols.iter().filter(|s| s.role == Role::Time) {
            self.inference.set_time(entry.measured_in.clone());
        }
        for (entry, claim) in all_symbols(self.derivation).into_iter().filter(|(s, _)| s.role != Role::Time) {
            let declared = entry.measured_in.clone();
            let scope = claim.map_or(&self.derivation.scope, |c| &c.scope);
            let by_formula = scope.definition(entry.symbol).or_else(|| self.derivation.definition(entry.symbol));
            // The value of a constant is a number in its unit.
            let Some(formula) = entry.formula.as_deref().filter(|_| entry.role != Role::Parameter) else {
                self.inference.declare(entry.symbol, declared);
                continue;
            };
            let Some(definition) = by_formula else {
                self.inference.declare(entry.symbol, declared);
                continue;
            };
            if !entry.arguments.is_empty() {
                // Looked at where it is applied: its arguments have no unit of their own.
                continue;
            }
            let components = definition.components.clone();
            let states: Vec<State> = components.iter().map(|&e| self.inference.state(e)).collect();
            let mut fault = None;
            if let Some(unit) = &declared {
                let odd = components.iter().zip(&states).find_map(|(&e, state)| match state {
                    State::Known(found) if found != unit => {
                        let term = self.inference.term(e);
                        Some(Fault::between(
                            "is declared, and its formula is",
                            (entry.name.clone(), unit),
                            (term, found),
                        ))
                    }
                    _ => None,
                });
                fault = odd;
            }
            let expected = claim.is_some_and(|c| c.expect_inconsistent_units);
            self.note("symbol", &entry.name, formula, &components, fault, expected);
            let own = |state: State| match (&declared, state) {
                (Some(unit), _) => State::Known(unit.clone()),
                (None, state) => state,
            };
            self.inference.define(entry.symbol, states.into_iter().map(own).collect());
        }
    }

    fn systems(&mut self) {
        for system in &self.derivation.systems {
            for equation in &system.equations {
                self.statement("system", &system.id, equation, false);
            }
        }
    }

    /// What members of families satisfy.
    fn families(&mut self) {
        for family in self.derivation.families.iter() {
            for constraint in &family.constraints {
                self.statement("family", &family.id, &constraint.written, false);
            }
        }
    }

    /// Values that are formulas: a mere number has the unit of what it is given to. Then the equations that determine others.
    fn trajectories(&mut self) {
        for trajectory in &self.derivation.trajectories {
            for equation in trajectory.motion.start().into_iter().flat_map(|start| &start.equations) {
                self.statement("trajectory", &trajectory.id, equation, false);
            }
        }
        for given in &self.derivation.given {
            let graph = self.graph();
            let formulas: Vec<(usize, Expr)> = given.value.value.iter().copied().enumerate().collect();
            let formulas: Vec<_> = formulas.into_iter().filter(|(_, e)| !graph.leaves([*e]).is_empty()).collect();
            if formulas.is_empty() {
                continue;
            }
            let exprs: Vec<Expr> = formulas.iter().map(|(_, e)| *e).collect();
            let mut fault = None;
            let mut unknown = None;
            for &(component, e) in &formulas {
                let leaf = Leaf { rate: given.rate, ..Leaf::now(given.symbol, component as u16) };
                let name = graph.leaf_latex(leaf);
                match (self.inference.leaf_state(leaf), self.inference.state(e)) {
                    (State::Known(own), State::Known(found)) if own != found => {
                        let term = self.inference.term(e);
                        fault = fault.or(Some(Fault::between("is given by", (name, &own), (term, &found))));
                    }
                    (State::Unknown, _) => unknown = unknown.or(Some(name)),
                    _ => {}
                }
            }
            let text = format!("{} = {}", graph.name(given.symbol), given.value.text);
            self.note("trajectory", &given.trajectory, &text, &exprs, fault, false);
            if let (Some(name), Some(last)) = (unknown, self.out.formulas.last_mut())
                && last.verdict == UnitVerdict::Consistent
            {
                last.verdict = UnitVerdict::NotChecked { reason: format!("{name} has no unit") };
            }
        }
    }

    /// Both sides of every relation.
    fn statement(&mut self, kind: &'static str, of: &str, written: &Written<Statement>, expected: bool) {
        let mut exprs = Vec::new();
        let mut fault = None;
        for relation in &written.value.relations {
            for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                exprs.extend([l, r]);
                fault = fault.or_else(|| self.inference.fault(&[l, r])).or_else(|| self.inference.compared(l, r));
            }
            if let Some(LimitPoint::Finite(point)) = relation.limit.as_ref().map(|l| &l.approaches) {
                exprs.push(*point);
                fault = fault.or_else(|| self.inference.instant(*point));
            }
        }
        self.formula(kind, of, written.span.start, &written.text, exprs, fault, expected);
    }

    /// Expressions that stand for themselves.
    fn expression(&mut self, kind: &'static str, of: &str, written: &Written<Tensor>, expected: bool) {
        let exprs = written.value.components.clone();
        self.formula(kind, of, written.span.start, &written.text, exprs, None, expected);
    }

    /// What a quantity tends to. As with values that a motion gives, a plain number may have any unit.
    fn limit(&mut self, of: &str, (quantity, limit): (&Written<Tensor>, &Written<Tensor>), expected: bool) {
        let plain = self.graph().leaves_within(limit.value.components.iter().copied()).is_empty();
        let sides = quantity.value.as_scalar().zip(limit.value.as_scalar());
        let fault = sides.filter(|_| !plain).and_then(|(l, r)| self.inference.compared(l, r));
        let exprs = limit.value.components.clone();
        self.formula("claim", of, limit.span.start, &limit.text, exprs, fault, expected);
    }

    #[expect(clippy::too_many_arguments, reason = "a formula with its place and what was found")]
    fn formula(
        &mut self,
        kind: &'static str,
        of: &str,
        place: usize,
        text: &str,
        exprs: Vec<Expr>,
        fault: Option<Fault>,
        expected: bool,
    ) {
        if let Some(&at) = self.seen.get(&(place, exprs.clone())) {
            if let Some(first) = self.out.formulas.get_mut(at) {
                first.expected |= expected;
            }
            return;
        }
        self.seen.insert((place, exprs.clone()), self.out.formulas.len());
        self.note(kind, of, text, &exprs, fault, expected);
    }

    fn claims(&mut self) {
        for claim in &self.derivation.claims {
            let (name, expected) = (claim.name(), claim.expect_inconsistent_units);
            let before = self.out.formulas.len();
            for written in claim.assuming.iter().chain(claim.at.iter().map(|at| &at.equation)) {
                self.statement("claim", &name, written, expected);
            }
            // The equations of a system are looked at where they stand; two motions of one state have one unit.
            for formula in claim.forms.iter().flat_map(Form::formulas) {
                match formula {
                    FormFormula::Statement(w) => self.statement("claim", &name, w, expected),
                    FormFormula::Quantity(w) => self.expression("claim", &name, w, expected),
                    FormFormula::Limit { of, value } => self.limit(&name, (of, value), expected),
                }
            }
            let own = |f: &UnitAccount| f.kind == "symbol" && claim.symbols.iter().any(|s| s.name == f.of);
            let (earlier, later) = self.out.formulas.split_at(before);
            let found = later.iter().chain(earlier.iter().filter(|f| own(f)));
            if expected && !found.into_iter().any(|f| f.verdict.word() == "inconsistent") {
                self.out.missed.push(name);
            }
        }
    }

    fn measures(&mut self) {
        for measure in &self.derivation.measures {
            if let Some(at) = &measure.at {
                self.statement("measure", &measure.id, &at.equation, false);
            }
            if let Some((since, _)) = &measure.since {
                self.statement("measure", &measure.id, &since.equation, false);
            }
            let mut fault = None;
            if let (Some(unit), Some(e)) = (&measure.measured_in, measure.formula.value.as_scalar())
                && let State::Known(found) = self.inference.state(e)
                && found != *unit
            {
                let term = self.inference.term(e);
                fault = Some(Fault::between("is the declared unit of", (measure.id.clone(), unit), (term, &found)));
            }
            let exprs = measure.formula.value.components.clone();
            self.formula(
                "measure",
                &measure.id,
                measure.formula.span.start,
                &measure.formula.text,
                exprs,
                fault,
                false,
            );
        }
    }

    fn conditions(&mut self) {
        for condition in &self.derivation.conditions {
            condition.holds.iter().for_each(|w| self.statement("condition", &condition.id, w, false));
        }
    }
}

impl Fault {
    /// A fault between two terms, each with its unit.
    fn between(relation: &str, a: (String, &Unit), b: (String, &Unit)) -> Fault {
        let term = |(latex, unit): (String, &Unit)| Term { latex, unit: unit.to_string() };
        let alike = a.1.is_alike(b.1);
        let terms = Box::new([term(a), term(b)]);
        let relation = relation.to_owned();
        if alike { Fault::Scale { relation, terms } } else { Fault::Different { relation, terms } }
    }
}
