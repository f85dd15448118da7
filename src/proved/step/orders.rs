//! Claims about the sizes of positive parameters: in which of their orders something holds.
//!
//! **In:** a claim about parameters, or the conditions of a proof. **Out:** the question as requirements of signs, and the
//! account of its answer.

use super::Step;
use crate::derivation::Form;
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::IdentityAccount;
use crate::findings::standing::Finding;
use crate::latex::RelationKind;
use order::{Question, Requirement};
use proof::{Condition, order};
use reason::{Coordinate, Plain, Proviso, Refuting};

/// Most parameters whose orders of size are listed: four have 75.
const MOST_ORDERED: usize = 3;

impl Step<'_> {
    /// For which orders of positive parameters conditions about them hold; nothing where there are none.
    pub(super) fn orders_of(&mut self, conditions: &[Condition]) -> Option<Proviso> {
        let restricting: Vec<Condition> = conditions.iter().filter(|c| c.leaves_out().is_none()).copied().collect();
        let roots = restricting.iter().map(|c| match *c {
            Condition::Denominator(e) | Condition::Radicand(e) | Condition::Unit(e) | Condition::Positive(e) => e,
            Condition::Pivot(e) | Condition::Rate(e) | Condition::Discriminant(e) => e,
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
        let (mut out, mut formulas) = (Question::default(), Vec::new());
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
                // What is assumed has a value.
                out.assumed.extend(order::of_needs(&mut self.graph, &[l, r]));
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
                    out.claimed.extend(order::of_needs(&mut self.graph, &w.value.components));
                    formulas.extend(w.value.components.iter().copied());
                }
                _ => {}
            }
        }
        let roots: Vec<Expr> = out.assumed.iter().chain(&out.claimed).map(|&(_, e)| e).collect();
        out.parameters = self.graph.leaves_within(roots);
        if out.parameters.is_empty() && !out.claimed.is_empty() {
            // Numbers are asked of; what has a value, or none, has it for all parameters.
            out.parameters = self.graph.leaves_within(formulas);
        }
        out.parameters.sort_unstable();
        out
    }

    /// For which orders of the parameters the claim holds, as conditions.
    pub(super) fn where_real(mut self) -> Vec<Proviso> {
        let question = self.order_question();
        let found = self.order_of(&question).filter(|found| found.tells() && !question.parameters.is_empty());
        found.map(|found| words_of(&self.graph, &question, &found, MEETING)).into_iter().collect()
    }

    /// The account of a claim about parameters.
    pub(super) fn account_of_order(&mut self, question: &Question, found: order::Orders) -> IdentityAccount {
        let names: Vec<String> = question.parameters.iter().map(|&l| self.graph.leaf_latex(l)).collect();
        let words = || words_of(&self.graph, question, &found, MEETING);
        let mut out = IdentityAccount {
            finding: Finding::of_signs(&found),
            conditions: (1..=MOST_ORDERED).contains(&names.len()).then(words).into_iter().collect(),
            ..IdentityAccount::default()
        };
        if found.is_proved() {
            out.reason = None;
        } else if let Some(values) = found.refuting() {
            let values = names.iter().zip(&values).map(|(n, v)| Coordinate::Value(n.clone(), v.to_string()));
            out.witness = Some(Refuting::Sizes(values.collect()));
        } else {
            out.reason = Some(Plain::SignsUndecided.into());
        }
        out
    }
}

/// Said of parameters of a claim.
const MEETING: &str = " that meet the assumptions it holds";

/// In which orders of the sizes of its parameters something is so.
fn words_of(graph: &Graph, question: &Question, found: &order::Orders, that: &str) -> Proviso {
    let names: Vec<String> = question.parameters.iter().map(|&l| graph.leaf_latex(l)).collect();
    Proviso::Orders(format!("for positive {}{that} {}", names.join(", "), found.words(&names)).into())
}
