//! A claim over ranges as a question about cells.
//!
//! **In:** what a claim assumes and says. **Out:** [`Question`], which judges cells: see [`Part`].
//!
//! At a point, a relation holds, fails or has no value; one with ± holds if it does for one of the signs, and fails if it does
//! for one and holds for none. The claim *does not apply* at a point at which an assumption does not hold, or a formula of
//! `always` has no value; elsewhere it holds if all relations hold. `defined` holds at a point at which the formula has a value.

use super::signs::{Cell, Domain, Scratch, Signs, Truth, Variable};
use crate::derivation::{Claim, Form, Ranged, Values, Written};
use crate::expr::{Expr, FastMap, Graph, Leaf, Node, Op, Tensor};
use crate::latex::{RelationKind, Scope, Statement};

use super::super::identity::{Condition, Identity, Premises};
use super::super::second_route::answer;

/// What is known of a claim on a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Part {
    /// It holds at every point.
    Proved,
    /// It holds at every point at which it applies; not known where that is.
    Border,
    /// It fails at every point.
    Refuted,
    /// It applies at no point.
    NotApplicable,
    /// Not known.
    Undecided,
}

/// One scalar relation of a formula, for one sign of ±.
#[derive(Clone, Debug)]
struct Compared {
    relation: usize,
    left: Expr,
    right: Expr,
}

/// A formula: for each sign of ±, the relations that must hold at once.
#[derive(Clone, Debug)]
struct Formula {
    text: String,
    signs: Vec<Vec<Compared>>,
}

/// A formula that must have a value: for each component, the relation by which it is known.
#[derive(Clone, Debug)]
struct Defined {
    text: String,
    components: Vec<usize>,
}

/// What is known of a formula on a cell.
struct Standing {
    truth: Truth,
    domain: Domain,
}

/// The two sides of the formula that fails at a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Failing {
    /// As written.
    pub formula: String,
    /// Left and right side; none for a formula without a value.
    pub sides: Option<(Expr, Expr)>,
}

/// See the module.
#[derive(Debug)]
pub(super) struct Question {
    pub signs: Signs,
    assumed: Vec<Formula>,
    said: Vec<Formula>,
    defined: Vec<Defined>,
    /// Whether every relation that is said is an identity.
    pub identical: bool,
    /// Equations that are identities: text, log₂ of the error probability.
    pub identities: Vec<(String, f64)>,
    /// Equations that are not known to be identities.
    pub equations: Vec<String>,
}

/// Puts the definitions of symbols, and the single values of the ranges, into expressions.
pub(super) struct Insertion<'a> {
    scope: &'a Scope,
    values: FastMap<Leaf, Expr>,
}

impl<'a> Insertion<'a> {
    pub fn new(graph: &mut Graph, scope: &'a Scope, ranges: &[Ranged]) -> Insertion<'a> {
        let mut values: FastMap<Leaf, Expr> = FastMap::default();
        for ranged in ranges {
            if let Values::One(e) = ranged.values {
                // Single values may depend on those before them.
                let e = graph.substitute(e, |_, leaf| values.get(&leaf).copied());
                values.insert(ranged.leaf, e);
            }
        }
        Insertion { scope, values }
    }

    /// The single value of a component.
    pub fn value(&self, leaf: Leaf) -> Option<Expr> {
        self.values.get(&leaf).copied()
    }

    /// `e`, in which only variables, unknowns and the sign of ± are left.
    pub fn put(&self, graph: &mut Graph, e: Expr, variables: &[Leaf]) -> Expr {
        let kept = |leaf: &Leaf| variables.contains(leaf) || self.values.contains_key(leaf);
        let mut e = e;
        // Definitions are acyclic: each is written in terms of earlier symbols. One that has a range of its own is not used.
        loop {
            let mut changed = false;
            e = graph.substitute(e, |_, leaf| {
                let definition = self.scope.definition(leaf.symbol).filter(|_| !kept(&leaf) && leaf.rate == 0)?;
                changed = true;
                definition.components.get(usize::from(leaf.component)).copied()
            });
            if !changed {
                return graph.substitute(e, |_, leaf| self.values.get(&leaf).copied());
            }
        }
    }
}

/// What is compared with 0. |l| ≤ r says that l ≤ r and −l ≤ r, which have slopes where |l| has none; the same for <, and for
/// a size on the right that is not exceeded.
fn without_absolute(graph: &mut Graph, kind: RelationKind, left: Expr, right: Expr) -> Vec<Expr> {
    let size = |graph: &Graph, e: Expr| match *graph.node(e) {
        Node::Unary(Op::Abs, inner) => Some(inner),
        _ => None,
    };
    let inner = match kind {
        RelationKind::Less | RelationKind::LessEqual => size(graph, left),
        RelationKind::Greater | RelationKind::GreaterEqual => size(graph, right),
        RelationKind::Equal | RelationKind::NotEqual => None,
    };
    let Some(inner) = inner else { return vec![graph.sub(left, right)] };
    let opposite = graph.neg(inner);
    let on_the_left = matches!(kind, RelationKind::Less | RelationKind::LessEqual);
    let one = |graph: &mut Graph, e: Expr| if on_the_left { graph.sub(e, right) } else { graph.sub(left, e) };
    vec![one(graph, inner), one(graph, opposite)]
}

impl Question {
    /// Compiles what a claim assumes and says; what it says of solutions is not looked at.
    ///
    /// # Errors
    /// A leaf without a value.
    pub fn new(graph: &mut Graph, claim: &Claim, put: &Insertion, variables: Vec<Variable>) -> Result<Question, Leaf> {
        let mut question = Question {
            signs: Signs::new(variables),
            assumed: Vec::new(),
            said: Vec::new(),
            defined: Vec::new(),
            identical: false,
            identities: Vec::new(),
            equations: Vec::new(),
        };
        for written in &claim.assuming {
            let formulas = question.formulas(graph, &claim.scope, put, written)?;
            question.assumed.extend(formulas);
        }
        let mut all_identical = true;
        for form in &claim.forms {
            match form {
                Form::Always(written) => {
                    let formulas = question.formulas(graph, &claim.scope, put, written)?;
                    for formula in &formulas {
                        all_identical &= question.prove(graph, formula);
                    }
                    question.said.extend(formulas);
                }
                Form::Defined(written) => {
                    let formula = question.defined(graph, put, written)?;
                    question.defined.push(formula);
                }
                _ => {}
            }
        }
        question.identical = all_identical && !question.said.is_empty() && question.defined.is_empty();
        Ok(question)
    }

    fn formulas(
        &mut self,
        graph: &mut Graph,
        scope: &Scope,
        put: &Insertion,
        written: &Written<Statement>,
    ) -> Result<Vec<Formula>, Leaf> {
        let variables: Vec<Leaf> = self.signs.variables.iter().map(|v| v.leaf).collect();
        let sign = scope.branch_sign();
        let mut out = Vec::new();
        for relation in &written.value.relations {
            let mut signs = Vec::new();
            for value in [1, -1].into_iter().take(if relation.has_branches { 2 } else { 1 }) {
                let mut all = Vec::new();
                for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                    let mut one = |e: Expr| {
                        let e = put.put(graph, e, &variables);
                        graph.substitute(e, |g, leaf| (leaf == sign).then(|| g.integer(value)))
                    };
                    let (left, right) = (one(l), one(r));
                    for d in without_absolute(graph, relation.kind, left, right) {
                        all.push(Compared { relation: self.signs.add(graph, d, relation.kind)?, left, right });
                    }
                }
                signs.push(all);
            }
            out.push(Formula { text: written.text.clone(), signs });
        }
        Ok(out)
    }

    fn defined(&mut self, graph: &mut Graph, put: &Insertion, written: &Written<Tensor>) -> Result<Defined, Leaf> {
        let variables: Vec<Leaf> = self.signs.variables.iter().map(|v| v.leaf).collect();
        let mut components = Vec::new();
        for &e in &written.value.components {
            let e = put.put(graph, e, &variables);
            components.push(self.signs.add(graph, e, RelationKind::NotEqual)?);
        }
        Ok(Defined { text: written.text.clone(), components })
    }

    /// Whether the equations of a formula are identities, wherever they have values: then no interval has to see it.
    fn prove(&mut self, graph: &mut Graph, formula: &Formula) -> bool {
        let mut all = true;
        for compared in formula.signs.iter().flatten() {
            if self.signs.kind(compared.relation) != RelationKind::Equal {
                all = false;
                continue;
            }
            let pair = [(compared.left, compared.right)];
            match answer(graph, &pair, &Premises::default(), None) {
                Ok((Identity::Proved(proof), _))
                    if !proof.conditions.iter().any(|c| matches!(c, Condition::Pivot(_))) =>
                {
                    self.signs.vanishes(compared.relation);
                    self.identities.push((formula.text.clone(), proof.log2_error));
                }
                _ => {
                    all = false;
                    self.equations.push(formula.text.clone());
                }
            }
        }
        all
    }

    /// How a formula stands on a cell: with ±, it holds if it does for one of the signs.
    fn standing(&self, formula: &Formula, cell: &Cell, scratch: &mut Scratch) -> Standing {
        let mut each = formula.signs.iter().map(|all| self.all_of(all, cell, scratch)).collect::<Vec<_>>();
        if each.len() == 1
            && let Some(only) = each.pop()
        {
            return only;
        }
        let nowhere = |s: &Standing| s.domain == Domain::Nowhere;
        let domain = if each.iter().all(nowhere) {
            Domain::Nowhere
        } else if each.iter().any(|s| s.domain == Domain::Everywhere) {
            Domain::Everywhere
        } else {
            Domain::Open
        };
        // True with one sign at every point, or with every sign that has a value.
        let surely = |s: &Standing| s.truth == Truth::True && s.domain == Domain::Everywhere;
        let is = |truth: Truth| each.iter().all(|s| nowhere(s) || s.truth == truth);
        let truth = if each.iter().any(surely) || is(Truth::True) {
            Truth::True
        } else if is(Truth::False) {
            Truth::False
        } else {
            Truth::Open
        };
        Standing { truth, domain }
    }

    /// How relations stand that must hold at once.
    fn all_of(&self, all: &[Compared], cell: &Cell, scratch: &mut Scratch) -> Standing {
        let mut out = Standing { truth: Truth::True, domain: Domain::Everywhere };
        for compared in all {
            out.domain = out.domain.and(self.signs.domain(compared.relation, cell, scratch));
            out.truth = out.truth.and(self.signs.truth(compared.relation, cell, scratch));
        }
        out
    }

    /// Whether the assumptions hold on a cell; `False` where one holds at no point of it.
    pub fn applies(&self, cell: &Cell, scratch: &mut Scratch) -> Truth {
        let mut out = Truth::True;
        for formula in &self.assumed {
            let Standing { truth, domain } = self.standing(formula, cell, scratch);
            out = out.and(match (truth, domain) {
                (_, Domain::Nowhere) | (Truth::False, _) => Truth::False,
                (Truth::True, Domain::Everywhere) => Truth::True,
                _ => Truth::Open,
            });
        }
        out
    }

    /// Judges a cell.
    pub fn judge(&self, cell: &Cell, scratch: &mut Scratch) -> Part {
        self.signs.begin(scratch);
        let applies = self.applies(cell, scratch);
        if applies == Truth::False {
            return Part::NotApplicable;
        }
        let mut defined = Domain::Everywhere;
        for relation in self.defined.iter().flat_map(|d| &d.components) {
            defined = defined.and(self.signs.domain(*relation, cell, scratch));
        }
        if defined == Domain::Nowhere && applies == Truth::True {
            return Part::Refuted;
        }
        let mut said = Standing { truth: Truth::True, domain: Domain::Everywhere };
        for formula in &self.said {
            let one = self.standing(formula, cell, scratch);
            said = Standing { truth: said.truth.and(one.truth), domain: said.domain.and(one.domain) };
        }
        match (defined, said.domain, said.truth, applies) {
            (Domain::Everywhere, Domain::Nowhere, ..) => Part::NotApplicable,
            (_, Domain::Everywhere, Truth::False, Truth::True) => Part::Refuted,
            (Domain::Everywhere, Domain::Everywhere, Truth::True, Truth::True) => Part::Proved,
            (Domain::Everywhere, _, Truth::True, _) => Part::Border,
            _ => Part::Undecided,
        }
    }

    /// Which formula fails at a point at which the claim does.
    pub fn failing(&self, cell: &Cell, scratch: &mut Scratch) -> Option<Failing> {
        self.signs.begin(scratch);
        for of in &self.defined {
            if of.components.iter().any(|&r| self.signs.domain(r, cell, scratch) == Domain::Nowhere) {
                return Some(Failing { formula: of.text.clone(), sides: None });
            }
        }
        for formula in &self.said {
            if self.standing(formula, cell, scratch).truth == Truth::False {
                let fails = |c: &&Compared| self.signs.truth(c.relation, cell, scratch) == Truth::False;
                let compared = formula.signs.iter().flatten().find(fails)?;
                let sides = Some((compared.left, compared.right));
                return Some(Failing { formula: formula.text.clone(), sides });
            }
        }
        None
    }
}

impl Truth {
    /// That of two relations that must hold at once.
    fn and(self, other: Truth) -> Truth {
        match (self, other) {
            (Truth::False, _) | (_, Truth::False) => Truth::False,
            (Truth::True, Truth::True) => Truth::True,
            _ => Truth::Open,
        }
    }
}

impl Domain {
    /// Where two formulas have values both.
    fn and(self, other: Domain) -> Domain {
        match (self, other) {
            (Domain::Nowhere, _) | (_, Domain::Nowhere) => Domain::Nowhere,
            (Domain::Everywhere, Domain::Everywhere) => Domain::Everywhere,
            _ => Domain::Open,
        }
    }
}
