//! What the evidence is worth where there are no motions: over boxes, and of fields whatever they are.
//!
//! **In:** claims that hold over ranges, or for all fields that satisfy what is given. **Out:** for each of them which of its
//! variants points reject: points of the box at which the claim applies; or values of the fields, their derivatives and all else
//! through which a solution of what is given passes, see [`passive`](proof).
//!
//! For a claim that fails it offers the altered formulas, with one edit, that hold instead: each is decided as a claim of its own.
//!
//! **Guaranteed:** a variant counts as rejected only if it is false at such a point, or has no value at any: then it does not
//! hold over the box, or does not follow. Where no points are known, none was tried, and nothing is said.

use super::battery::{Battery, Memory};
use super::erratum::{MOST_OFFERED, as_claim, is_inequality};
use super::generate::{ClaimVariants, Formula, MOST_NODES, Setting, Variant};
use super::ranked::{Candidate, Made, ranked};
use super::rejection::{self, Evidence, Placed, Rejections};
use super::vocabulary::Vocabulary;
use crate::derivation::{Claim, Derivation, Region};
use crate::expr::{Expr, Graph, Leaf, Rational};
use crate::findings::{ClaimAccount, Correction, Erratum, Survivor, VariantAccount};
use crate::flow::Sample;
use crate::verdict::{Outcome, Strength};
use claim::limits::Limits;
use claim::program::Values;
use proved::step::Step;
use rayon::prelude::*;

/// The work that the variants of a claim may take, in nodes: formulas are inserted for fields, and derived.
const MOST_STILL_NODES: usize = MOST_NODES / 4;

/// The work that those of all such claims of a file may take.
const MOST_NODES_OF_A_FILE: usize = 4_000_000;

/// Most claims that are corrected: every correction is a claim that is decided.
const MOST_CORRECTED: usize = 24;

/// Adds to the accounts of claims without a motion what became of their variants: of those that hold, which are rejected; for
/// those that fail, which hold instead.
pub fn weigh_still(derivation: &Derivation, accounts: &mut [ClaimAccount], limits: &Limits) {
    let outcome = |account: &ClaimAccount| account.region.as_ref().map(|r| r.verdict.outcome());
    let holds = |account: &ClaimAccount| matches!(outcome(account), Some(Outcome::Holds(_)));
    let fails = |account: &ClaimAccount| matches!(outcome(account), Some(Outcome::Fails(_)));
    let count = accounts.iter().filter(|a| holds(a) || fails(a)).count();
    let room = (MOST_NODES_OF_A_FILE / count.max(1)).min(MOST_STILL_NODES);
    let corrected = accounts.iter().enumerate().filter(|(_, a)| fails(a)).nth(MOST_CORRECTED).map(|(k, _)| k);
    let last = corrected.unwrap_or(usize::MAX);
    accounts.par_iter_mut().enumerate().with_max_len(1).for_each(|(k, account)| {
        let declared = derivation.claims.iter().find(|c| c.id == account.id && c.reading == account.reading);
        let wanted = holds(account) || fails(account) && k < last;
        if limits.reached().is_none()
            && let Some(claim) = declared.filter(|_| wanted)
            && let Some(region) = &claim.region
        {
            account.variants = Some(of_claim(derivation, claim, region, holds(account), room));
        }
    });
}

fn of_claim(derivation: &Derivation, claim: &Claim, region: &Region, holds: bool, room: usize) -> VariantAccount {
    let mut step = if claim.is_of_fields() { Step::of(derivation, claim) } else { None };
    let mut own = derivation.graph.clone();
    let graph = step.as_mut().map_or(&mut own, Step::graph);
    let starts = [Rational::ZERO];
    let setting = Setting { claim, starts: &starts, shared: graph.len() };
    let mut variants = ClaimVariants::new(derivation, graph, &setting, room);
    variants.reduce(derivation, claim, graph);
    let sign = claim.scope.branch_sign();
    let found = if variants.variants.is_empty() {
        None
    } else {
        match &mut step {
            Some(step) => {
                let mut leaves = step.graph().leaves(variants.roots(0));
                leaves.retain(|l| *l != sign);
                let points = step.points(&leaves);
                rejections(step.graph(), claim, &variants, (&leaves, &points))
            }
            None => {
                let mut put = variants.clone();
                let mut all: Vec<&mut Expr> = put.expressions_mut().collect();
                boxes::points(derivation, claim, region, &mut own, &mut all)
                    .and_then(|(leaves, points)| rejections(&own, claim, &put, (&leaves, &points)))
            }
        }
    };
    if holds {
        return account(variants, found);
    }
    let graph = step.as_mut().map_or(&mut own, Step::graph);
    let erratum = found.map(|found| corrections(derivation, &setting, region, graph, &variants, &found));
    VariantAccount { erratum, ..account(variants, None) }
}

/// The altered formulas, with one edit, that hold where the claim fails.
fn corrections(
    derivation: &Derivation,
    setting: &Setting,
    region: &Region,
    graph: &mut Graph,
    variants: &ClaimVariants,
    found: &Rejections,
) -> Erratum {
    let claim = setting.claim;
    let vocabulary = Vocabulary::new(derivation, claim);
    let mut out = Erratum::default();
    let mut offered: Vec<(bool, Candidate, Correction)> = Vec::new();
    for (f, formula) in variants.formulas.iter().enumerate() {
        if is_inequality(formula) || !found.formulas[f] {
            continue;
        }
        let of = |v: &&Variant| v.formula == f;
        out.tried.0 += variants.variants.iter().filter(of).count();
        let passes = variants.variants.iter().enumerate().filter(|(v, _)| !found.variants[*v]).map(|(_, v)| v);
        let passes = passes.chain(&variants.empty).filter(of);
        let mut made: Vec<Made> = passes.map(|v| (vec![v.class], v.tree(&variants.formulas))).collect();
        let alike = variants.alike.iter().filter(|(v, _)| !found.variants[*v] && of(&&variants.variants[*v]));
        made.extend(alike.map(|(_, edit)| (vec![edit.class], edit.apply(&formula.tree))));
        for candidate in ranked(derivation, (0, f), graph, setting, formula, &vocabulary, made) {
            let Some(strength) = decided(derivation, claim, region, &candidate, formula) else { continue };
            let correction = Correction {
                printed: formula.text.clone(),
                formula: candidate.text.clone(),
                difference: candidate.difference.clone(),
                classes: candidate.classes.clone(),
                strength,
                holds_on: 0,
            };
            offered.push((strength == Strength::Proved, candidate, correction));
        }
    }
    offered.sort_by(|a, b| a.1.nearness.than(a.0, &b.1.nearness, b.0));
    out.corrections = offered.into_iter().map(|(.., correction)| correction).take(MOST_OFFERED).collect();
    if out.corrections.is_empty() {
        out.remark = Some("no formula with one edit holds instead, as far as that could be decided".to_owned());
    }
    out
}

/// How strongly a candidate holds as a claim of its own; none where it does not.
fn decided(
    derivation: &Derivation,
    claim: &Claim,
    region: &Region,
    candidate: &Candidate,
    formula: &Formula,
) -> Option<Strength> {
    let mut scratch = derivation.clone();
    let altered = as_claim(&mut scratch.graph, claim, "correction", candidate, formula.manner, Vec::new())?;
    let of = if altered.is_of_fields() {
        let step = Step::of(&scratch, &altered)?.decide()?.ok()?;
        boxes::of_step(&altered, region, Some(&step))
    } else {
        boxes::decide_one(&scratch, &altered, region)?
    };
    match of.verdict.outcome() {
        Outcome::Holds(strength) => Some(strength),
        Outcome::Fails(_) | Outcome::NotApplicable(_) | Outcome::Undecided => None,
    }
}

/// What points say of variants; none where there are no points.
fn rejections(
    graph: &Graph,
    claim: &Claim,
    variants: &ClaimVariants,
    (leaves, points): (&[Leaf], &[Values]),
) -> Option<Rejections> {
    if points.is_empty() {
        return None;
    }
    // In the order of leaves, as those of motions are.
    let mut order: Vec<usize> = (0..leaves.len()).collect();
    order.sort_by_key(|&at| leaves[at]);
    let known: Vec<Leaf> = order.iter().map(|&at| leaves[at]).collect();
    let points: Vec<Values> = points.iter().map(|p| order.iter().map(|&at| p[at]).collect()).collect();
    let all = (0..variants.variants.len()).collect();
    let battery = Battery::new(graph, variants, 0, all, claim.scope.branch_sign())?;
    let samples: Vec<Sample> = points.iter().map(|values| Sample::Alone(values)).collect();
    let evidence = Evidence {
        points: &samples,
        first_counts: false,
        precision: claim.precision,
        one_sign_throughout: claim.branches_throughout,
    };
    Some(rejection::rejected(variants, &Placed::new(battery, &known), &evidence, &mut Memory::default()))
}

fn account(variants: ClaimVariants, found: Option<Rejections>) -> VariantAccount {
    let survives = |&v: &usize| found.as_ref().is_some_and(|f| !f.variants[v]);
    let of = |v: usize| &variants.formulas[variants.variants[v].formula];
    let survivors = (0..variants.variants.len()).filter(survives).map(|v| Survivor {
        class: variants.variants[v].class,
        printed: of(v).text.clone(),
        place: of(v).place.clone(),
        formula: variants.variants[v].text(&variants.formulas),
        everywhere: true,
    });
    VariantAccount {
        survivors: survivors.collect(),
        classes: variants.counts.values().cloned().collect(),
        tried_on: usize::from(found.is_some()),
        cover: Vec::new(),
        cover_is_least: true,
        erratum: None,
        skipped: variants.skipped,
    }
}
