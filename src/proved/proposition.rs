//! A formula typed by a person, decided for all values.
//!
//! **In:** a formula, premises, and a [`Derivation`] that knows the symbols; a premise may also be the name of a claim or of a
//! system of it. **Out:** what a claim of a file would get, an [`IdentityAccount`]: the formula becomes a claim that follows
//! from its premises, and is decided by the same code.

use std::ops::Range;
use std::sync::Arc;

use crate::conditional::presupposed;
use crate::derivation::{Claim, DEFAULT_PRECISION, Derivation, Form, FormKind, Formula, Written};
use crate::diag::{Diagnostic, Source, nearest};
use crate::findings::IdentityAccount;
use crate::latex::{self, Relation, RelationKind, Scope, Statement};
use crate::step::Step;
use claim::denial::denies;
use claim::error::CheckError;
use findings::Proposition;

/// The name of a typed claim: no file can have it.
const NAME: &str = "\u{2063}typed";

/// Makes the symbols that a claim declares for itself known to the whole derivation.
///
/// # Errors
/// [`CheckError::Problems`] if there is no such claim; `shown` is what the name is called.
pub fn with_symbols_of(derivation: &mut Derivation, claim: &str, shown: &str) -> Result<(), CheckError> {
    match claim_named(derivation, claim) {
        Ok(found) => {
            derivation.scope = found.scope.clone();
            Ok(())
        }
        Err(words) => Err(CheckError::Problems(vec![unknown(shown, claim, &words)])),
    }
}

/// Decides a proposition; what is proved was replayed by the checker, or is *unreplayed*.
///
/// # Errors
/// [`CheckError::Problems`] for formulas and names that are not understood, with their places;
/// [`CheckError::Defect`] when the two routes contradict each other.
pub fn prove(derivation: &mut Derivation, proposition: &Proposition) -> Result<IdentityAccount, CheckError> {
    let claim = stated(derivation, proposition)?;
    Ok(crate::replay::replayed_throughout(derivation, &claim, decided(derivation, &claim)?))
}

fn decided(derivation: &Derivation, claim: &Claim) -> Result<IdentityAccount, CheckError> {
    match Step::of(derivation, claim).map(Step::typed).and_then(Step::decide) {
        Some(account) => account.map_err(CheckError::Defect).map(|mut account| {
            if account.finding.is_proved_in_part() {
                account.presupposed = presupposed(derivation, claim);
            }
            account
        }),
        // Both sides are one expression: all that is left to see is whether it has a value, where what is given holds.
        None if denies(claim) => Ok(IdentityAccount::default()),
        None => {
            let relations = claim.forms.iter().filter_map(|form| match form {
                Form::Always(w) => Some(&w.value.relations),
                _ => None,
            });
            let pairs: Vec<_> = relations.flatten().flat_map(sides).collect();
            let step = Step::of(derivation, claim).map(Step::typed);
            let step = step.ok_or_else(|| CheckError::Defect("an equation is no equation".to_owned()))?;
            step.of_one_expression(&pairs).map_err(CheckError::Defect)
        }
    }
}

/// A proposition as a claim that follows from its premises.
///
/// # Errors
/// [`CheckError::Problems`] for formulas and names that are not understood, with their places.
pub fn stated(derivation: &mut Derivation, proposition: &Proposition) -> Result<Claim, CheckError> {
    let mut problems = Vec::new();
    let scope = derivation.scope.clone();
    let source = typed("the formula", &proposition.formula);
    let conclusion = read(derivation, &source, &scope, &mut problems);
    // Inequalities are decided where they are about positive parameters only, which is seen below.
    let mut others = Vec::new();
    for relation in conclusion.iter().flat_map(|w| &w.value.relations) {
        if relation.kind != RelationKind::Equal || relation.limit.is_some() {
            let d = Diagnostic::at(&source, "prove::not-an-equation", relation.span.clone(), "this is no equation");
            others.push(d.hint(
                "only equations, and inequalities between positive parameters, are decided for all values; other relations can \
                 be premises",
            ));
        }
    }
    let (mut assuming, mut follows_from) = (Vec::new(), Vec::new());
    for (at, text) in proposition.given.iter().enumerate() {
        let source = typed(&format!("premise {}", at + 1), text);
        match premise_named(derivation, text.trim()) {
            Some(Ok(name)) => follows_from.push(name),
            Some(Err(words)) => problems.push(unknown(&source.path, text, &words)),
            None => {
                let statements = read(derivation, &source, &scope, &mut problems);
                for relation in statements.iter().flat_map(|w| &w.value.relations) {
                    note_premise(&source, relation, &mut problems);
                }
                assuming.extend(statements);
            }
        }
    }
    if !problems.is_empty() {
        return Err(CheckError::Problems(problems));
    }
    // Where units stand in formulas, one metre is not one second, though both are the number 1.
    let typed_relations = conclusion.iter().chain(&assuming).flat_map(|w| &w.value.relations);
    let sides_of: Vec<Vec<_>> = typed_relations
        .map(|r| r.left.components.iter().copied().zip(r.right.components.iter().copied().map(Some)).collect())
        .collect();
    if scope.has_units() && units::inconsistent(derivation, &derivation.graph, &sides_of).contains(&true) {
        let whole = 0..proposition.formula.len();
        let d =
            Diagnostic::at(&source, "prove::units", whole, "the two sides differ in their units, or terms of a sum do");
        return Err(CheckError::Problems(vec![d.hint("see the units that the file declares")]));
    }
    let formulas = vec![Formula { text: proposition.formula.clone(), kind: FormKind::Always }];
    let claim = Claim {
        id: NAME.to_owned(),
        reading: None,
        says: proposition.formula.clone(),
        parent_says: None,
        role: Default::default(),
        conclusion: false,
        postulate: false,
        rests_on: Vec::new(),
        place: None,
        label: None,
        remark: None,
        symbols: Vec::new(),
        formulas,
        assuming,
        forms: conclusion.into_iter().map(Form::Always).collect(),
        at: None,
        follows_from,
        precision: DEFAULT_PRECISION,
        branches_throughout: proposition.throughout,
        expect_inconsistent_units: false,
        printed: false,
        names_trajectories: true,
        trajectories: Vec::new(),
        expect: Vec::new(),
        families: Vec::new(),
        expect_of_families: Vec::new(),
        expect_alone: None,
        region: None,
        scope,
        span: 0..0,
    };
    if !others.is_empty() && Step::of(derivation, &claim).is_none() {
        return Err(CheckError::Problems(others));
    }
    Ok(claim)
}

fn sides(relation: &Relation) -> Vec<(expr::Expr, expr::Expr)> {
    relation.left.components.iter().copied().zip(relation.right.components.iter().copied()).collect()
}

fn typed(shown: &str, text: &str) -> Arc<Source> {
    Arc::new(Source { path: shown.to_owned(), text: text.to_owned() })
}

fn unknown(shown: &str, text: &str, words: &str) -> Diagnostic {
    Diagnostic::at(&typed(shown, text), "prove::unknown-premise", 0..text.len(), words)
}

/// The statements of a typed text.
fn read(
    derivation: &mut Derivation,
    source: &Arc<Source>,
    scope: &Scope,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Written<Statement>> {
    match latex::read(&source.text, scope, &mut derivation.graph) {
        // What stands alone is told as it was typed, its brackets with their sizes.
        Ok(statements) if !statements.is_empty() => statements
            .iter()
            .cloned()
            .map(|s| {
                let span: Range<usize> = if statements.len() == 1 { 0..source.text.len() } else { s.span.clone() };
                let text = source.text.get(span.clone()).unwrap_or(&source.text).trim().to_owned();
                Written { text, span, value: s }
            })
            .collect(),
        Ok(_) => {
            problems.push(Diagnostic::at(
                source,
                "derivation::empty-formula",
                0..source.text.len(),
                "this says nothing",
            ));
            Vec::new()
        }
        Err(found) => {
            problems.extend(found.into_iter().map(|p| Diagnostic::of_formula(source, 0, p)));
            Vec::new()
        }
    }
}

/// Notes what cannot be a premise.
fn note_premise(source: &Arc<Source>, relation: &Relation, problems: &mut Vec<Diagnostic>) {
    let mut note = |message: &str, hint: &str| {
        problems.push(Diagnostic::at(source, "prove::no-premise", relation.span.clone(), message).hint(hint));
    };
    if relation.limit.is_some() {
        note("a limit cannot be a premise", "say what is used of it, as an equation");
    }
}

/// The claim of this name; of a claim that has readings only, the reading must be named.
fn claim_named<'d>(derivation: &'d Derivation, name: &str) -> Result<&'d Claim, String> {
    if let Some(claim) = derivation.claims.iter().find(|c| c.name() == name) {
        return Ok(claim);
    }
    let readings: Vec<String> =
        derivation.claims.iter().filter(|c| c.id == name).map(|c| format!("`{}`", c.name())).collect();
    if !readings.is_empty() {
        return Err(format!("`{name}` has several readings: say which, {}", readings.join(", ")));
    }
    let names: Vec<String> = derivation.claims.iter().flat_map(|c| [c.id.clone(), c.name()]).collect();
    let systems = derivation.systems.iter().map(|s| s.id.as_str());
    let near = nearest(name, names.iter().map(String::as_str).chain(systems));
    let hint = near.map(|n| format!("; did you mean `{n}`?")).unwrap_or_default();
    Err(format!("there is no claim or system `{name}`{hint}"))
}

/// The claim or system that a premise names; `None` where it is a formula.
fn premise_named(derivation: &Derivation, text: &str) -> Option<Result<String, String>> {
    if derivation.systems.iter().any(|s| s.id == text) {
        return Some(Ok(text.to_owned()));
    }
    // Of a formula, a premise needs a relation: none of its signs can stand in a name.
    let could_be = |c: char| c.is_ascii_alphanumeric() || "-_./".contains(c);
    let nameable = !derivation.claims.is_empty() || !derivation.systems.is_empty();
    (nameable && !text.is_empty() && text.chars().all(could_be)).then(|| claim_named(derivation, text).map(Claim::name))
}
