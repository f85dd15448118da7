//! What the evidence is worth: single-edit variants of every claim, and which of them the same evidence rejects.
//!
//! **In:** claims, and the motions on which they are tried. **Out:** for every pair how many of the variants the motion
//! rejects, and for every claim which survive, the fewest motions that reject the others, and, where it fails, what it should
//! have said.
//!
//! The order of work: `edit` and `convention` alter syntax trees, one place at a time or throughout; `generate` keeps those with a meaning; `equivalence`
//! removes those that say what the print says; `battery` makes one program of what is left; `rejection` tries it at the points
//! at which the claim was tried; `cover` chooses motions; `erratum` looks for what should have been printed. Claims without
//! motions are `motionless`'s.
//!
//! **Guaranteed:** a variant counts as rejected only if it is violated by the rule that the print is judged by. What was
//! not tried, and why, is counted and reported.

mod atom;
mod battery;
mod completion;
mod confirm;
mod convention;
mod cover;
mod difference;
mod edit;
mod equivalence;
mod erratum;
mod gap;
mod generate;
mod motionless;
mod nearness;
mod pairs;
mod point;
mod ranked;
mod rate;
mod rejection;
mod sites;
mod tree;
mod vocabulary;

pub use confirm::{Beside, Encloses};
pub use motionless::weigh_still;

use std::ops::Range;

use meter::{Ended, Limits, Task};
use rayon::prelude::*;

use crate::derivation::{Claim, Derivation};
use crate::expr::{FastMap, Graph, Leaf, Rational};
use crate::findings::{ClaimAccount, Discrimination, EditClass, PairAccount, Survivor, VariantAccount};
use crate::flow::Sample;
use crate::latex::Role;
use crate::verdict::{Outcome, Verdict};
use battery::{Battery, Memory};
use claim::error::CheckError;
use claim::program::{Program, Values};
use generate::{ClaimVariants, Formula, MOST_NODES, Manner, Setting, Source, Variant};
use rate::Rate;
use rejection::{Evidence, Placed, Rejections};
use sampled::events;
use sampled::selection::Selection;
use sampled::trace::Trace;

/// A formula of a claim with one edit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AlteredFormula {
    /// The formula as the file has it.
    pub printed: String,
    /// Its place in the file.
    pub place: Range<usize>,
    /// What was altered.
    pub class: EditClass,
    /// The altered formula. It reads as what it is meant to be.
    pub formula: String,
}

/// All single-edit variants of the formulas of a claim that mean something else than the print: what can be planted in a file
/// to see whether it is found.
pub fn altered_formulas(derivation: &Derivation, claim: usize) -> Vec<AlteredFormula> {
    let Some(of) = derivation.claims.get(claim) else { return Vec::new() };
    let starts = [Rational::ZERO];
    let mut graph = derivation.graph.clone();
    let setting = Setting { claim: of, starts: &starts, shared: graph.len() };
    let mut variants = ClaimVariants::new(derivation, &mut graph, &setting, MOST_NODES);
    variants.reduce(derivation, of, &mut graph);
    let mut out = Vec::new();
    for variant in &variants.variants {
        let formula = &variants.formulas[variant.formula];
        let text = variant.text(&variants.formulas);
        let mut reads = || {
            let tree = generate::tree(&text, &of.scope)?;
            Some(setting.altered(&mut graph, formula, &tree)? == variant.altered)
        };
        if let (Some(place), Some(true)) = (&formula.place, reads()) {
            let printed = formula.text.clone();
            out.push(AlteredFormula { printed, place: place.clone(), class: variant.class, formula: text });
        }
    }
    out
}

/// How far two formulas of a claim are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sameness {
    /// They are the same equation (or are constant for the same reason), as the definitions of the symbols have it.
    Defined,
    /// They are so where the equations hold that the claim assumes.
    Assumed,
}

/// Whether, and how far, two formulas of a claim are the same; `constant`: they are expressions that shall be constant. Texts
/// that cannot be read are not.
pub fn says_the_same(
    derivation: &Derivation,
    claim: usize,
    printed: &str,
    other: &str,
    constant: bool,
) -> Option<Sameness> {
    let of = derivation.claims.get(claim)?;
    let starts = [Rational::ZERO];
    let mut graph = derivation.graph.clone();
    let start = graph.constant(Rational::ZERO);
    let setting = Setting { claim: of, starts: &starts, shared: graph.len().max(start.index() + 1) };
    let manner = if constant { Manner::Constant } else { Manner::Relation };
    let formula = Formula::read(&mut graph, &setting, printed, manner)?;
    let tree = generate::tree(other, &of.scope)?;
    let altered = setting.altered(&mut graph, &formula, &tree)?;
    if altered.is_empty() {
        return Some(Sameness::Defined);
    }
    let variants = vec![Variant { class: EditClass::Sign, formula: 0, source: Source::Tree(Box::new(tree)), altered }];
    let group = ClaimVariants { formulas: vec![formula], variants, ..ClaimVariants::default() };
    match group.sights(derivation, of, &mut graph, true).as_slice() {
        [equivalence::Sight::Same] => match group.sights_defined(derivation, of, &mut graph).as_slice() {
            [equivalence::Sight::Same] => Some(Sameness::Defined),
            _ => Some(Sameness::Assumed),
        },
        _ => None,
    }
}

/// Fewest claims that share a copy of the graph.
const TOGETHER: usize = 8;
/// Most copies of the graph: it grows with the claims, and copies of all would grow with their square.
const MOST_COPIES: usize = 64;
/// The work that the variants of a file may take, in nodes.
const MOST_NODES_OF_A_FILE: usize = 5_000_000;

/// The variants of all claims that are tried.
pub struct Altered {
    /// Copies of the graph.
    graphs: Vec<Graph>,
    /// How many claims share one.
    together: usize,
    claims: Vec<ClaimVariants>,
    /// For each claim and initial time; empty for a claim without variants, and beyond what is kept.
    placed: Vec<Vec<Placed>>,
    /// Most variants whose programs are kept.
    room: usize,
    known: Vec<Leaf>,
}

/// Most variants whose programs are kept from one motion to the next; those beyond are compiled for each motion, and dropped.
const MOST_KEPT: usize = 100_000;
/// The same where one motion is tried: nothing asks for them after it, and so many are compiled side by side before it.
const MOST_KEPT_OF_ONE: usize = 10_000;

impl Altered {
    /// Makes the variants of the chosen claims.
    pub fn new(derivation: &Derivation, selection: &Selection, limits: &Limits) -> Altered {
        let Selection { claims: claimed, starts, .. } = selection;
        let shared = derivation.graph.len();
        let together = claimed.len().div_ceil(MOST_COPIES).max(TOGETHER);
        let room = (MOST_NODES_OF_A_FILE / claimed.len().max(1)).min(MOST_NODES);
        let several = |some: &[usize]| {
            let mut graph = derivation.graph.clone();
            let mut out = Vec::new();
            for &c in some {
                let claim = &derivation.claims[c];
                let setting = Setting { claim, starts, shared };
                let mut variants = ClaimVariants::new(derivation, &mut graph, &setting, room);
                variants.reduce(derivation, claim, &mut graph);
                // A file may have ten thousand claims, each with a hundred of them.
                variants.variants.shrink_to_fit();
                out.push(variants);
            }
            (graph, out)
        };
        // What takes too long is left out, and the report says so.
        let left_out = |c: &usize, ended: &Ended| {
            let formulas = derivation.claims[*c].formulas.iter();
            let skipped = formulas.map(|formula| (formula.text.clone(), ended.to_string())).collect();
            ClaimVariants { skipped, ..ClaimVariants::default() }
        };
        let chunks: Vec<&[usize]> = claimed.chunks(together).collect();
        let one = |some: &&[usize], limits: &Limits| match meter::piece(Task::Weighing, limits, || several(some)) {
            Ok(made) => made,
            Err(ended) => (derivation.graph.clone(), some.iter().map(|c| left_out(c, &ended)).collect()),
        };
        let made = meter::each(limits, &chunks, one);
        let (graphs, claims): (Vec<_>, Vec<_>) = made.into_iter().unzip();
        let claims = claims.into_iter().flatten().collect();
        let room = if selection.tried.len() > 1 { MOST_KEPT } else { MOST_KEPT_OF_ONE };
        Altered { graphs, together, claims, placed: Vec::new(), room, known: Vec::new() }
    }

    /// The graph of the k-th claim.
    fn graph(&self, k: usize) -> &Graph {
        &self.graphs[k / self.together]
    }

    /// The leaves that must be known to try them, and to look for corrections, the sign of ± apart: what a formula lacks may
    /// be anything that is given, a state, or its rate.
    pub fn leaves(&self, derivation: &Derivation, starts: usize, sign: Leaf) -> Vec<Leaf> {
        let mut out = Vec::new();
        for (k, claim) in self.claims.iter().enumerate().filter(|(_, c)| !c.variants.is_empty()) {
            for start in 0..starts {
                out.extend(self.graph(k).leaves(claim.roots(start)));
            }
        }
        let highest = out.iter().map(|l: &Leaf| l.rate).max().unwrap_or(0).max(1);
        for (k, claim) in self.claims.iter().enumerate() {
            let rates: Vec<&Rate> = claim.formulas.iter().filter_map(|formula| formula.rate.as_ref()).collect();
            out.extend(self.graph(k).leaves(rates.iter().map(|rate| rate.value)));
            out.extend(rates.iter().flat_map(|rate| &rate.named));
        }
        for symbol in derivation.symbols.iter().map(|s| s.symbol) {
            let rates = match derivation.scope.role(symbol) {
                Some(Role::Parameter) => 0,
                Some(Role::State) => highest,
                _ => continue,
            };
            let count = derivation.graph.component_count(symbol) as u16;
            let leaf = |(component, rate): (u16, u8)| Leaf { rate, ..Leaf::now(symbol, component) };
            out.extend((0..count).flat_map(|c| (0..=rates).map(move |r| (c, r))).map(leaf));
        }
        out.sort_unstable();
        out.dedup();
        out.retain(|l| *l != sign);
        out
    }

    /// The leaves of the variants of one claim.
    pub fn leaves_of(&self, k: usize, starts: usize) -> Vec<Leaf> {
        let claim = self.claims.get(k).filter(|c| !c.variants.is_empty());
        let roots = claim.map(|claim| (0..starts).flat_map(|start| claim.roots(start)).collect::<Vec<_>>());
        roots.map_or_else(Vec::new, |roots| self.graph(k).leaves(roots))
    }

    /// Compiles them for points with values of these leaves, which are sorted: as many as are kept.
    pub fn compile(&mut self, starts: usize, sign: Leaf, known: &[Leaf], limits: &Limits) {
        self.known = known.to_vec();
        let mut room = self.room;
        let kept = self.claims.iter().take_while(|claim| {
            let size = claim.variants.len() * starts;
            let fits = size <= room;
            room = room.saturating_sub(size);
            fits
        });
        let kept: Vec<usize> = (0..kept.count()).collect();
        let all = |k: usize| (0..starts).filter_map(|start| self.compiled((k, start), sign)).collect();
        let one = |&k: &usize, limits: &Limits| meter::piece(Task::Weighing, limits, || all(k)).unwrap_or_default();
        self.placed = meter::each(limits, &kept, one);
    }

    /// The program of a claim for one initial time; `None` for a claim without variants.
    fn compiled(&self, (k, start): (usize, usize), sign: Leaf) -> Option<Placed> {
        let (graph, claim) = (self.graph(k), self.claims.get(k).filter(|claim| !claim.variants.is_empty())?);
        let battery = Battery::new(graph, claim, start, (0..claim.variants.len()).collect(), sign)?;
        Some(Placed::new(battery, &self.known))
    }

    /// Tries all variants on one motion; `found` has an entry for each claim that was tried there.
    pub fn weigh(&self, graph: &Graph, start: usize, trace: &Trace, found: &[Option<Found>]) -> Weighed {
        let mut out = Weighed { rejections: Vec::new(), kept: Vec::new(), of_claims: Vec::new() };
        // Where a motion runs away, its last points are known to few digits, and tell nothing apart.
        let of = |i: usize| (trace.times[i], trace.points.row(i));
        let several = rejection::spread(trace.times.len(), 4 * KEPT).into_iter().map(of);
        let (well, badly): (Vec<_>, Vec<_>) = several.partition(|(_, values)| values.iter().all(is_well_known));
        out.kept = well.into_iter().chain(badly).take(KEPT).collect();
        let mut memory = Memory::default();
        for (k, found) in found.iter().enumerate() {
            let (rejections, own) = match found {
                Some(found) => self.rejections(graph, (k, start), trace, found, &mut memory).unwrap_or_default(),
                None => Default::default(),
            };
            out.rejections.push(rejections);
            let excluded = found.iter().flat_map(|f| f.verdict.exclusions()).map(|e| (e.from, e.to)).collect();
            let at_events = found.as_ref().is_some_and(|f| f.program.at.is_some());
            out.of_claims.push(OfClaim { excluded, at_events, own });
        }
        out
    }

    /// What a motion says of the k-th claim, and points that are the claim's own; `None` where nothing was tried.
    fn rejections(
        &self,
        graph: &Graph,
        (k, start): (usize, usize),
        trace: &Trace,
        found: &Found,
        memory: &mut Memory,
    ) -> Option<(Option<Rejections>, Vec<Values>)> {
        let claim = found.claim;
        let outcome = found.verdict.outcome();
        if !matches!(outcome, Outcome::Holds(_) | Outcome::Fails(_)) {
            return None;
        }
        let events = events::of_claim(graph, (claim, found.program), trace);
        // The point at which the claim fails most clearly is always among those used.
        let mut own: Vec<Values> = Vec::new();
        if let (Outcome::Fails(_), Some(witness)) = (outcome, &found.verdict.evidence().witness) {
            own.push(match trace.times.binary_search_by(|t| t.total_cmp(&witness.t)) {
                Ok(i) if found.program.at.is_none() => trace.points.row(i),
                _ if found.program.at.is_none() => trace.values(witness.t),
                _ => {
                    let zeros = &events.as_ref()?.zeros;
                    let i = zeros.times.iter().position(|&t| t == witness.t)?;
                    trace.values_at_event(witness.t, zeros.slack[i])
                }
            });
        }
        if found.program.at.is_some() {
            let zeros = &events.as_ref()?.zeros;
            let times = zeros.times.iter().zip(&zeros.slack).filter(|(t, _)| found.counts(**t));
            own.extend(times.take(rejection::MOST_TIMES).map(|(&t, &slack)| trace.values_at_event(t, slack)));
        }
        let mut points: Vec<Sample> = own.iter().map(|values| Sample::Alone(values)).collect();
        if found.program.at.is_none() {
            let counted = trace.times.iter().zip(trace.points.samples()).filter(|(t, _)| found.counts(**t));
            points.extend(counted.map(|(_, point)| point));
        }
        if points.is_empty() {
            return None;
        }
        let evidence = Evidence {
            points: &points,
            first_counts: matches!(outcome, Outcome::Fails(_)),
            precision: claim.precision,
            one_sign_throughout: claim.branches_throughout,
        };
        let dropped: Placed;
        let placed = match self.placed.get(k) {
            Some(kept) => kept.get(start)?,
            None => {
                dropped = self.compiled((k, start), claim.scope.branch_sign())?;
                &dropped
            }
        };
        let rejections = rejection::rejected(&self.claims[k], placed, &evidence, memory);
        own.truncate(KEPT);
        Some((Some(rejections), own))
    }

    /// Writes what was found into the accounts: one entry of `weighed`, and one trace, for each of the motions that were tried.
    ///
    /// # Errors
    /// Those of a check, when corrections are tried.
    pub fn conclude(
        &self,
        derivation: &Derivation,
        selection: &Selection,
        accounts: &mut [ClaimAccount],
        weighed: &[Weighed],
        (traces, limits): (&[Trace], &Limits),
        encloses: Option<&dyn Encloses>,
    ) -> Result<(), CheckError> {
        let columns = selection.columns(derivation);
        accounts.par_iter_mut().zip(&self.claims).enumerate().for_each(|(k, (account, variants))| {
            account.variants = Some(self.account(k, account, variants, weighed, &columns));
        });
        erratum::Search { derivation, altered: self, selection, weighed, limits, encloses }.offer(accounts, traces)
    }

    fn account(
        &self,
        k: usize,
        account: &mut ClaimAccount,
        variants: &ClaimVariants,
        weighed: &[Weighed],
        columns: &FastMap<&str, usize>,
    ) -> VariantAccount {
        let on = |p: &PairAccount| {
            let column =
                columns.get(p.trajectory.as_str()).filter(|_| matches!(p.verdict.outcome(), Outcome::Holds(_)))?;
            weighed[*column].rejections[k].as_ref().map(|r| &r.variants)
        };
        let rejected: Vec<Option<&Vec<bool>>> = account.results.iter().map(on).collect();
        let trajectories = account.results.iter().map(|p| &p.trajectory);
        let holds: Vec<(String, &Vec<bool>)> =
            trajectories.zip(&rejected).filter_map(|(t, r)| Some((t.clone(), (*r)?))).collect();
        let survives: Vec<usize> = (0..variants.variants.len()).filter(|&v| holds.iter().any(|(_, r)| !r[v])).collect();
        for (pair, rejected) in account.results.iter_mut().zip(rejected) {
            let Some(rejected) = rejected else { continue };
            let survivors: Vec<usize> =
                survives.iter().enumerate().filter(|(_, v)| !rejected[**v]).map(|(i, _)| i).collect();
            let of = rejected.len();
            pair.discrimination = Some(Discrimination { rejected: of - survivors.len(), of, survivors });
        }
        let sets: Vec<Vec<bool>> = holds.iter().map(|(_, r)| (*r).clone()).collect();
        let (cover, cover_is_least) = cover::least_cover(&sets);
        let of = |v: usize| &variants.formulas[variants.variants[v].formula];
        let survivor = |&v: &usize| Survivor {
            class: variants.variants[v].class,
            printed: of(v).text.clone(),
            place: of(v).place.clone(),
            formula: variants.variants[v].text(&variants.formulas),
            everywhere: holds.iter().all(|(_, r)| !r[v]),
        };
        VariantAccount {
            classes: variants.counts.values().cloned().collect(),
            skipped: variants.skipped.clone(),
            survivors: survives.iter().map(survivor).collect(),
            tried_on: holds.len(),
            cover: cover.into_iter().map(|i| holds[i].0.clone()).collect(),
            cover_is_least,
            erratum: None,
        }
    }
}

/// Points of a motion that are kept for corrections.
const KEPT: usize = 12;

/// Whether a value is known to seven digits, or is next to nothing; what has none is not known badly.
fn is_well_known(value: &Result<number::Bounded, number::NoValue>) -> bool {
    value.as_ref().map_or(true, |v| v.error <= 1e-7 * v.value.abs().max(1e-3))
}

/// What one motion says of the variants of all claims.
pub struct Weighed {
    /// One for each claim; none where it was not tried.
    rejections: Vec<Option<Rejections>>,
    /// A few points of the motion, with their times, in the order of [`rejection::spread`].
    kept: Vec<(f64, Values)>,
    of_claims: Vec<OfClaim>,
}

/// What belongs to one claim on one motion.
struct OfClaim {
    /// Times at which it was not compared.
    excluded: Vec<(f64, f64)>,
    /// Whether it is tried at events only.
    at_events: bool,
    /// Its witness, and its events.
    own: Vec<Values>,
}

impl Weighed {
    /// At most so many points at which a claim was tried; `all`: also those at which it has no value.
    fn points(&self, k: usize, most: usize, all: bool) -> Vec<&Values> {
        let of = &self.of_claims[k];
        let counts = |t: f64| all || !of.excluded.iter().any(|(a, b)| (*a..=*b).contains(&t));
        let shared = self.kept.iter().filter(|(t, _)| !of.at_events && counts(*t)).map(|(_, p)| p);
        of.own.iter().chain(shared).take(most).collect()
    }
}

/// A claim on a motion, as it was tried.
pub struct Found<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// Its program.
    pub program: &'a Program,
    /// What came out.
    pub verdict: Verdict,
}

impl Found<'_> {
    /// Whether the claim was compared at a time.
    fn counts(&self, t: f64) -> bool {
        !self.verdict.exclusions().any(|e| (e.from..=e.to).contains(&t))
    }
}
