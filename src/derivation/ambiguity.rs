//! Claims whose forms have no one meaning together.
//!
//! **In:** a claim, read. **Out:** problems, for what `docs/semantics.md` refuses: a sign of ± that would stand in several places
//! with different scopes, and limits that are compared with what moves. Each formula by itself is clear.

use std::ops::Range;

use super::form::Form;
use super::formula::Written;
use super::load::Loader;
use super::model::Claim;
use expr::{Leaf, Tensor};
use latex::{Relation, RelationKind, Role, Statement};

/// A formula with ±, and where it stands.
struct Signed {
    form: &'static str,
    /// It is l ≠ r: neither sign.
    neither: bool,
    span: Range<usize>,
}

impl Loader<'_> {
    /// Notes what has no one meaning.
    pub(super) fn refuse_ambiguity(&mut self, claim: &Claim) {
        self.moving_limits(claim);
        let said = self.signed_forms(claim);
        let relations = |w: &Written<Statement>| w.value.relations.iter().any(|r| r.has_branches);
        let at = claim.at.iter().map(|at| &at.equation).filter(|w| relations(w));
        let assumed: Vec<Range<usize>> =
            claim.assuming.iter().filter(|w| relations(w)).chain(at).map(|w| w.span.clone()).collect();
        let mut refuse = |span: &Range<usize>, message: &str| {
            self.problems
                .note("derivation::ambiguous-sign", span.clone(), message)
                .hint("write two claims, or readings, one for each sign");
        };
        for (at, one) in said.iter().enumerate() {
            let others = || said.iter().enumerate().filter(move |(o, _)| *o != at).map(|(_, o)| o);
            if one.neither && (others().any(|o| !o.neither) || !assumed.is_empty()) {
                refuse(&one.span, "`\\ne` with ± says “neither”, and the same sign stands elsewhere in the claim");
                continue;
            }
            match one.form {
                "never" if others().any(|o| o.form != "never") => {
                    refuse(
                        &one.span,
                        "± in `never` says “with neither sign”, and the same sign stands in another form",
                    );
                }
                "eventually" if !claim.branches_throughout && others().any(|o| o.form != "eventually") => {
                    refuse(&one.span, "± in `eventually` and in another form: one sign, or one for each time?");
                }
                "first-integral" if others().any(|o| o.form != "first-integral") => {
                    refuse(
                        &one.span,
                        "± in `first-integral` is one sign for all times, and stands in another form, too",
                    );
                }
                "first-integral" | "defined" if !assumed.is_empty() => {
                    refuse(&one.span, "the sign of an assumption stands in a form that is not about single times");
                }
                _ => {}
            }
        }
    }

    fn signed_forms(&self, claim: &Claim) -> Vec<Signed> {
        let sign = claim.scope.branch_sign();
        let mut out = Vec::new();
        let mut statement = |form: &'static str, w: &Written<Statement>| {
            let signed: Vec<&Relation> = w.value.relations.iter().filter(|r| r.has_branches).collect();
            let of_kind = |neither: bool| signed.iter().any(|r| (r.kind == RelationKind::NotEqual) == neither);
            out.extend([false, true].into_iter().filter(|&n| of_kind(n)).map(|neither| Signed {
                form,
                neither,
                span: w.span.clone(),
            }));
        };
        for form in &claim.forms {
            if let Some(w) = form.statement() {
                statement(form.kind().key(), w);
            }
        }
        let signed =
            |w: &Written<Tensor>| self.out.graph.leaves_within(w.value.components.iter().copied()).contains(&sign);
        for form in &claim.forms {
            if let Some(w) = form.quantity().filter(|w| signed(w)) {
                out.push(Signed { form: form.kind().key(), neither: false, span: w.span.clone() });
            }
        }
        out
    }

    /// A limit is one number: what it is compared with must not move.
    fn moving_limits(&mut self, claim: &Claim) {
        let mut statements: Vec<&Written<Statement>> = claim.assuming.iter().collect();
        statements.extend(claim.forms.iter().filter_map(Form::statement));
        let moves = |leaf: &Leaf| {
            leaf.instant.is_none()
                && matches!(claim.scope.role(leaf.symbol), Some(Role::State | Role::Observable | Role::Time))
        };
        for w in statements {
            let limits = w.value.relations.iter().filter(|r| r.limit.is_some());
            let right = limits.flat_map(|r| r.right.components.iter().copied());
            if self.out.graph.leaves_within(right).iter().any(moves) {
                self.problems
                    .note("derivation::moving-limit", w.span.clone(), "a limit is compared with something that moves")
                    .hint("write a number, a parameter, or a value at a time");
            }
        }
    }
}
