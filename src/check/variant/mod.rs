//! What the evidence is worth: single-edit variants of every claim, and which of them the same evidence rejects.
//!
//! **In:** claims, and the motions on which they are tried. **Out:** for every pair how many of the variants the motion
//! rejects, and for every claim which survive, the fewest motions that reject the others, and, where it fails, what it should
//! have said.
//!
//! The order of work: `edit` alters syntax trees, one place at a time; `generate` keeps those with a meaning; `equivalence`
//! removes those that say what the print says; `battery` makes one program of what is left; `rejection` tries it at the points
//! at which the claim was tried; `cover` chooses motions; `erratum` looks for what should have been printed.
//!
//! **Guaranteed:** a variant counts as rejected only if it is violated by the rule that the print is judged by. What was
//! not tried, and why, is counted and reported.

mod account;
mod battery;
mod cover;
mod edit;
mod equivalence;
mod generate;
mod rejection;
mod vocabulary;

pub use account::{ClassCount, Correction, Discrimination, Erratum, Survivor, VariantAccount, WEAK};
pub use edit::EditClass;

use rayon::prelude::*;

use super::account::ClaimAccount;
use super::program::Program;
use super::trial::{Course, Values};
use super::verdict::{Outcome, Verdict};
use crate::derivation::{Claim, Derivation};
use crate::expr::{Graph, Leaf, Rational};
use battery::Battery;
use generate::{ClaimVariants, Setting};
use rejection::{Evidence, Placed};

/// Claims that share a copy of the graph.
const TOGETHER: usize = 8;

/// The variants of all claims that are tried.
pub(super) struct Altered {
    /// Copies of the graph, each for [`TOGETHER`] claims.
    graphs: Vec<Graph>,
    claims: Vec<ClaimVariants>,
    /// For each claim and initial time; empty for a claim without variants.
    placed: Vec<Vec<Placed>>,
    known: Vec<Leaf>,
}

impl Altered {
    /// Makes the variants. `claimed` are the positions of the claims, `starts` the initial times of the motions.
    pub fn new(derivation: &Derivation, claimed: &[usize], starts: &[Rational]) -> Altered {
        let shared = derivation.graph.len();
        let several = |some: &[usize]| {
            let mut graph = derivation.graph.clone();
            let mut out = Vec::new();
            for &c in some {
                let claim = &derivation.claims[c];
                let setting = Setting { claim, starts, shared };
                let mut variants = ClaimVariants::new(derivation, &mut graph, &setting);
                variants.reduce(derivation, claim, &mut graph);
                out.push(variants);
            }
            (graph, out)
        };
        let made: Vec<(Graph, Vec<ClaimVariants>)> = claimed.par_chunks(TOGETHER).map(several).collect();
        let (graphs, claims): (Vec<_>, Vec<_>) = made.into_iter().unzip();
        Altered { graphs, claims: claims.into_iter().flatten().collect(), placed: Vec::new(), known: Vec::new() }
    }

    /// The leaves that must be known to try them, the sign of ± apart.
    pub fn leaves(&self, starts: usize, sign: Leaf) -> Vec<Leaf> {
        let mut out = Vec::new();
        for (k, claim) in self.claims.iter().enumerate().filter(|(_, c)| !c.variants.is_empty()) {
            for start in 0..starts {
                out.extend(self.graphs[k / TOGETHER].leaves(claim.roots(start)));
            }
        }
        out.sort_unstable();
        out.dedup();
        out.retain(|l| *l != sign);
        out
    }

    /// Compiles them for points with values of these leaves, which are sorted.
    pub fn compile(&mut self, starts: usize, sign: Leaf, known: &[Leaf]) {
        self.known = known.to_vec();
        let one = |(k, claim): (usize, &ClaimVariants)| -> Vec<Placed> {
            let graph = &self.graphs[k / TOGETHER];
            let all = || (0..claim.variants.len()).collect();
            let battery = |start| Battery::new(graph, claim, start, all(), sign).map(|b| Placed::new(b, known));
            if claim.variants.is_empty() { Vec::new() } else { (0..starts).filter_map(battery).collect() }
        };
        self.placed = self.claims.par_iter().enumerate().map(one).collect();
    }

    /// Which variants of the k-th claim a motion rejects; `None` where nothing was tried.
    pub fn rejected(&self, k: usize, start: usize, claim: &Claim, found: &Found) -> Option<Vec<bool>> {
        let placed = self.placed.get(k)?.get(start)?;
        if !matches!(found.verdict.outcome(), Outcome::Holds(_) | Outcome::Fails(_)) {
            return None;
        }
        let at_events: Vec<Values>;
        let points: Vec<&Values> = match found.program.at {
            Some(event) => {
                let zeros = found.course.zeros(event)?;
                let times = zeros.times.iter().zip(&zeros.slack).filter(|(t, _)| found.counts(**t));
                at_events = times.map(|(&t, &slack)| found.course.values_at_event(t, slack)).collect();
                at_events.iter().collect()
            }
            None => {
                let counted = found.course.times.iter().zip(&found.course.points).filter(|(t, _)| found.counts(**t));
                counted.map(|(_, p)| p).collect()
            }
        };
        if points.is_empty() {
            return None;
        }
        let graph = &self.graphs[k / TOGETHER];
        let evidence =
            Evidence { points: &points, precision: claim.precision, one_sign_throughout: claim.branches_throughout };
        let sign = claim.scope.branch_sign();
        Some(rejection::rejected(graph, &self.claims[k], start, sign, &self.known, placed, &evidence))
    }

    /// Writes what was found into the accounts. `rejected[t][k]` is what [`Altered::rejected`] gave.
    pub fn conclude(&self, claims: &mut [ClaimAccount], rejected: &[Vec<Option<Vec<bool>>>], tried: &[String]) {
        for (k, (account, variants)) in claims.iter_mut().zip(&self.claims).enumerate() {
            account.variants = Some(self.account(k, account, variants, rejected, tried));
        }
    }

    fn account(
        &self,
        k: usize,
        account: &mut ClaimAccount,
        variants: &ClaimVariants,
        rejected: &[Vec<Option<Vec<bool>>>],
        tried: &[String],
    ) -> VariantAccount {
        let column = |id: &str| tried.iter().position(|t| t == id);
        let on = |id: &str| column(id).and_then(|t| rejected[t][k].as_ref());
        let holds: Vec<(String, &Vec<bool>)> = account
            .results
            .iter()
            .filter(|p| matches!(p.verdict.outcome(), Outcome::Holds(_)))
            .filter_map(|p| Some((p.trajectory.clone(), on(&p.trajectory)?)))
            .collect();
        let survives: Vec<usize> = (0..variants.variants.len()).filter(|&v| holds.iter().any(|(_, r)| !r[v])).collect();
        for pair in &mut account.results {
            let Some((_, rejected)) = holds.iter().find(|(id, _)| *id == pair.trajectory) else { continue };
            let survivors: Vec<usize> =
                survives.iter().enumerate().filter(|(_, v)| !rejected[**v]).map(|(i, _)| i).collect();
            let of = rejected.len();
            pair.discrimination = Some(Discrimination { rejected: of - survivors.len(), of, survivors });
        }
        let sets: Vec<Vec<bool>> = holds.iter().map(|(_, r)| (*r).clone()).collect();
        let (cover, cover_is_least) = cover::least_cover(&sets);
        let survivor = |&v: &usize| Survivor {
            class: variants.variants[v].class,
            formula: variants.variants[v].text(),
            everywhere: holds.iter().all(|(_, r)| !r[v]),
        };
        VariantAccount {
            classes: variants.counts.values().cloned().collect(),
            skipped: variants.skipped.clone(),
            survivors: survives.iter().map(survivor).collect(),
            cover: cover.into_iter().map(|i| holds[i].0.clone()).collect(),
            cover_is_least,
            erratum: None,
        }
    }
}

/// A claim on a motion, as it was tried.
pub(super) struct Found<'a> {
    /// Its program.
    pub program: &'a Program,
    /// The motion.
    pub course: &'a Course<'a>,
    /// What came out.
    pub verdict: &'a Verdict,
}

impl Found<'_> {
    /// Whether the claim was compared at a time.
    fn counts(&self, t: f64) -> bool {
        !self.verdict.evidence().excluded.iter().any(|e| (e.from..=e.to).contains(&t))
    }
}
