//! What a claim that fails should have said.
//!
//! **In:** claims that fail where they are stated to hold, their variants, and the points at which they were tried. **Out:**
//! corrections: altered formulas that hold on every motion to which the claim applies.
//!
//! First single edits and exchanges of symbols; then, where none of them is proved, [`completion`](super::completion); then pairs of
//! edits, only where nothing nearer passes.
//! What passes at a few points of every motion is tried as a claim of its own, as it is printed, on the motions of the check:
//! only what gets the verdict `holds` on every one is offered (see `confirm`). So a correction is as strong as any verdict of this program.
//!
//! A correction that holds because it says nothing (x = x) is refused, and so is one whose units do not agree, if those of the
//! print do; one that is true by the definitions alone comes after those that are not. In which order they are offered is said
//! in `nearness`.

use meter::{Limits, Task};

use super::atom::atoms;
use super::completion::{Points, completions, valued_atoms};
use super::confirm::Encloses;
use super::gap::Insertions;
use super::generate::{ClaimVariants, Formula, Manner, Part, Setting, Source, Variant, drawn};
use super::pairs::Pairs;
use super::ranked::{Candidate, Made, ranked};
use super::rate::rates;
use super::rejection::{self, Evidence, Placed};
use super::sites::Sites;
use super::vocabulary::{Vocabulary, phrases};
use super::{Altered, Battery, Memory, Weighed};
use crate::derivation::{Claim, Derivation, Form, FormKind, Written};
use crate::expr::{Graph, Leaf};
use crate::findings::{ClaimAccount, EditClass, Erratum, PairAccount};
use crate::flow::Sample;
use crate::latex::syntax::Node;
use crate::latex::{self, RelationKind};
use crate::verdict::Outcome;
use claim::error::CheckError;
use claim::program::Values;
use sampled::selection::Selection;
use sampled::trace::Trace;

/// Most pairs of edits of one formula that are tried.
const MOST_PAIRS: usize = 4_000;
/// Pairs of edits that are evaluated together.
const PAIRS_TOGETHER: usize = 300;
/// Nodes of trees that are evaluated together.
const NODES_TOGETHER: usize = 200_000;
/// The work that formulas with something more, and pairs of edits, may take, in nodes.
const MOST_INSERTED_NODES: usize = 8_000_000;
/// The work that the fit of completions may take, in nodes.
const MOST_FITTED_NODES: usize = 200_000;
/// Most claims that are corrected.
const MOST_CORRECTED: usize = 200;
/// Most points at which completions are fitted.
const FITTED: usize = 12;
/// Most corrections that are offered for a claim.
pub(super) const MOST_OFFERED: usize = 5;

/// Everything that the search shares.
pub(super) struct Search<'a> {
    pub derivation: &'a Derivation,
    pub altered: &'a Altered,
    pub selection: &'a Selection,
    /// What was found on each of the motions that were tried.
    pub weighed: &'a [Weighed],
    pub limits: &'a Limits,
    /// Encloses what may be offered, where more than samples is asked.
    pub encloses: Option<&'a dyn Encloses>,
}

/// The motions on which a correction must hold.
struct Asked {
    /// Columns.
    on: Vec<usize>,
    /// Whether the claim has no value on some of them where it is stated to hold.
    absent: bool,
}

/// Whether a claim is stated to hold on a motion, and does not: there a correction is asked for. A claim that holds nowhere is
/// wrong whatever is expected.
fn asked(account: &ClaimAccount) -> Vec<bool> {
    let fails = |p: &PairAccount| matches!(p.verdict.outcome(), Outcome::Fails(_));
    let holds = |p: &PairAccount| matches!(p.verdict.outcome(), Outcome::Holds(_));
    let stated = |p: &PairAccount| p.expected != Some("fails");
    if account.results.iter().any(|p| (fails(p) && stated(p)) || is_absent(p)) {
        return account.results.iter().map(|p| ((fails(p) || holds(p)) && stated(p)) || is_absent(p)).collect();
    }
    if account.results.iter().any(fails) && !account.results.iter().any(holds) {
        return account.results.iter().map(fails).collect();
    }
    vec![false; account.results.len()]
}

/// Whether a claim does not apply to a motion on which it is stated to hold.
fn is_absent(pair: &PairAccount) -> bool {
    matches!(pair.verdict.outcome(), Outcome::NotApplicable(_)) && pair.expected == Some("holds")
}

/// What the single edits of a formula came to.
struct Edited {
    /// Which formula.
    formula: usize,
    /// Whether the print has no value.
    absent: bool,
    /// Those that no point refutes.
    made: Vec<Made>,
}

/// What was tried of one claim.
#[derive(Default)]
struct Tried {
    edited: Vec<Edited>,
    candidates: Vec<Candidate>,
    /// Equations that may say the rate of a quantity.
    rates: Vec<Candidate>,
}

impl Search<'_> {
    /// Looks for corrections of all claims that need one: single edits first, and more only where none of them is proved.
    pub fn offer(&self, accounts: &mut [ClaimAccount], traces: &[Trace]) -> Result<(), CheckError> {
        let asked = self.asked(accounts);
        let mut errata: Vec<Erratum> = asked.iter().map(|_| Erratum::default()).collect();
        let edits = |k: usize, asked: &Asked, erratum: &mut Erratum| self.edits(k, asked, erratum);
        let first = self.of_each(&asked, &mut errata, &edits);
        let motions: Vec<Vec<usize>> =
            asked.iter().map(|a| a.as_ref().map(|a| a.on.clone()).unwrap_or_default()).collect();
        let candidates = |tried: &[Tried]| tried.iter().flat_map(|t| t.candidates.clone()).collect();
        let mut held = self.confirm(candidates(&first), &motions, traces)?;
        let settled = |k: usize, formula: usize| held.iter().any(|of| of.settles(k, formula));
        let open: Vec<Vec<&Edited>> = first
            .iter()
            .enumerate()
            .map(|(k, t)| t.edited.iter().filter(|e| !settled(k, e.formula)).collect())
            .collect();
        let more = |k: usize, asked: &Asked, erratum: &mut Erratum| {
            let known = first.get(k).map_or(&[][..], |tried| &tried.candidates);
            self.more(k, asked, erratum, (open.get(k).map_or(&[][..], Vec::as_slice), known))
        };
        let second = self.of_each(&asked, &mut errata, &more);
        held.extend(self.confirm(candidates(&second), &motions, traces)?);
        for (claim, rate) in self.proved_rates(second.into_iter().flat_map(|t| t.rates).collect(), &motions, traces)? {
            if let Some(erratum) = errata.get_mut(claim).filter(|erratum| erratum.rate.is_none()) {
                erratum.rate = Some(rate);
            }
        }
        for ((account, erratum), _) in accounts.iter_mut().zip(errata).zip(&asked).filter(|(_, asked)| asked.is_some())
        {
            if let Some(variants) = &mut account.variants {
                variants.erratum = Some(erratum);
            }
        }
        self.write(accounts, held);
        Ok(())
    }

    /// The motions on which a correction must hold, for each claim that needs one.
    fn asked(&self, accounts: &[ClaimAccount]) -> Vec<Option<Asked>> {
        let columns = self.selection.columns(self.derivation);
        let mut room = MOST_CORRECTED;
        let of_claim = |account: &ClaimAccount| {
            let wanted = asked(account);
            let pairs = account.results.iter().zip(&wanted).filter(|(_, wanted)| **wanted);
            let on: Vec<usize> = pairs.filter_map(|(p, _)| columns.get(p.trajectory.as_str()).copied()).collect();
            if on.is_empty() || room == 0 {
                return None;
            }
            room -= 1;
            Some(Asked { on, absent: account.results.iter().any(is_absent) })
        };
        accounts.iter().map(of_claim).collect()
    }

    /// Something for each claim that is asked for a correction; what takes too long is left out, with a remark.
    fn of_each(
        &self,
        asked: &[Option<Asked>],
        errata: &mut [Erratum],
        tried: &(dyn Fn(usize, &Asked, &mut Erratum) -> Tried + Sync),
    ) -> Vec<Tried> {
        let one = |&k: &usize, limits: &Limits| {
            let Some(asked) = asked.get(k).and_then(Option::as_ref) else { return Default::default() };
            let mut erratum = Erratum::default();
            meter::piece(Task::Weighing, limits, || tried(k, asked, &mut erratum)).map_or_else(
                |ended| (Tried::default(), Erratum { remark: Some(ended.to_string()), ..Erratum::default() }),
                |tried| (tried, erratum.clone()),
            )
        };
        let all: Vec<usize> = (0..asked.len()).collect();
        let (tried, told): (Vec<Tried>, Vec<Erratum>) = meter::each(self.limits, &all, one).into_iter().unzip();
        for (erratum, told) in errata.iter_mut().zip(told) {
            let ((a, b, c), (x, y, z)) = (erratum.tried, told.tried);
            erratum.tried = (a + x, b + y, c + z);
            erratum.remark = erratum.remark.take().or(told.remark);
        }
        tried
    }

    /// The single edits of a claim, and exchanges of symbols, that pass at the points at which it was tried.
    fn edits(&self, k: usize, asked: &Asked, erratum: &mut Erratum) -> Tried {
        let claim = &self.derivation.claims[self.selection.claims[k]];
        let variants = &self.altered.claims[k];
        let mut graph = self.altered.graph(k).clone();
        let setting = Setting { claim, starts: &self.selection.starts, shared: self.derivation.graph.len() };
        let vocabulary = Vocabulary::new(self.derivation, claim);
        let rejections: Vec<_> = asked.on.iter().filter_map(|&t| self.weighed[t].rejections[k].as_ref()).collect();
        let mut out = Tried::default();
        for (f, formula) in variants.formulas.iter().enumerate() {
            let absent = asked.absent && self.has_no_value(k, asked, &graph, formula);
            if is_inequality(formula) || !absent && !rejections.iter().any(|r| r.formulas[f]) {
                continue;
            }
            // Where the print has no value, what is tried instead must have one.
            let tried = &if absent { without_print(&mut graph, formula) } else { formula.clone() };
            let of = (tried, tried.size(&graph));
            let mut made: Vec<Made> = Vec::new();
            for (v, variant) in variants.variants.iter().enumerate().filter(|(_, v)| v.formula == f) {
                erratum.tried.0 += 1;
                if rejections.iter().all(|r| !r.variants[v]) {
                    made.push((vec![variant.class], variant.tree(&variants.formulas)));
                    let alike = variants.alike.iter().filter(|(first, _)| *first == v);
                    made.extend(alike.map(|(_, edit)| (vec![edit.class], edit.apply(&formula.tree))));
                }
            }
            let empty = variants.empty.iter().filter(|v| v.formula == f);
            made.extend(empty.map(|v| (vec![v.class], v.tree(&variants.formulas))));
            if absent {
                made = self.screened(k, asked, &mut graph, &setting, of, &mut made.into_iter());
            }
            let exchanges = Sites::new(&formula.tree, &vocabulary).exchanges();
            erratum.tried.0 += exchanges.len();
            let mut exchanges = exchanges.iter().map(|edit| (vec![edit.class], edit.apply(&formula.tree)));
            made.extend(self.screened(k, asked, &mut graph, &setting, of, &mut exchanges));
            let at = (k, f);
            out.candidates.extend(ranked(
                self.derivation,
                at,
                &mut graph,
                &setting,
                formula,
                &vocabulary,
                made.clone(),
            ));
            out.edited.push(Edited { formula: f, absent, made });
        }
        out
    }

    /// Formulas with something more that pass, and where nothing nearer does, pairs of edits; none that is known already.
    fn more(
        &self,
        k: usize,
        asked: &Asked,
        erratum: &mut Erratum,
        (edited, known): (&[&Edited], &[Candidate]),
    ) -> Tried {
        let mut out = Tried::default();
        if edited.is_empty() {
            return out;
        }
        let claim = &self.derivation.claims[self.selection.claims[k]];
        let variants = &self.altered.claims[k];
        let mut graph = self.altered.graph(k).clone();
        let setting = Setting { claim, starts: &self.selection.starts, shared: self.derivation.graph.len() };
        let vocabulary = Vocabulary::new(self.derivation, claim);
        let near = phrases(self.derivation, claim);
        for of in edited {
            let (f, absent) = (of.formula, of.absent);
            let Some(formula) = variants.formulas.get(f) else { continue };
            let tried = &if absent { without_print(&mut graph, formula) } else { formula.clone() };
            let size = tried.size(&graph);
            let screened = |graph: &mut Graph, trees: &mut dyn Iterator<Item = Made>| {
                self.screened(k, asked, graph, &setting, (tried, size), trees)
            };
            let mut made = of.made.clone();
            let atoms = atoms(&formula.tree, &vocabulary, &near);
            let insertions = Insertions::new(&formula.tree, &vocabulary, &atoms);
            let inserted = insertions.count().min(MOST_INSERTED_NODES / size);
            let places = MOST_FITTED_NODES / size;
            out.rates.extend(self.rates((k, f), asked, &mut graph, &setting, &atoms));
            let points = self.fitted(k, asked);
            let complete = points.map_or_else(Vec::new, |points| {
                completions(&mut graph, &setting, &vocabulary, tried, &atoms, &points, places)
            });
            erratum.tried.1 += inserted + complete.len();
            let count = insertions.count();
            let mut complete = insertions.at(drawn(count, inserted)).chain(complete);
            let mut complete = complete.by_ref().map(|tree| (vec![EditClass::Missing], tree));
            made.extend(screened(&mut graph, &mut complete));
            if made.is_empty() {
                let pairs = Pairs::new(variants, f, &vocabulary, MOST_PAIRS.min(MOST_INSERTED_NODES / size));
                let mut tried = 0;
                made.extend(screened(&mut graph, &mut pairs.inspect(|_| tried += 1)));
                erratum.tried.2 += tried;
            }
            let mut all = ranked(self.derivation, (k, f), &mut graph, &setting, formula, &vocabulary, made);
            all.retain(|c| !known.iter().any(|k| k.formula == f && k.text == c.text));
            out.candidates.extend(all);
        }
        out
    }

    /// Whether a formula has no value at any of the points.
    fn has_no_value(&self, k: usize, asked: &Asked, graph: &Graph, formula: &Formula) -> bool {
        let sign = self.derivation.claims[self.selection.claims[k]].scope.branch_sign();
        let group = ClaimVariants { formulas: vec![formula.clone()], ..ClaimVariants::default() };
        self.points(k, asked, 6).iter().all(|(start, points)| {
            let Some(battery) = Battery::new(graph, &group, *start, Vec::new(), sign) else { return false };
            let placed = Placed::new(battery, &self.altered.known);
            points.iter().all(|point| !placed.has_values(Sample::Alone(point), 0, formula.parts.len()))
        })
    }

    /// The points of motions at which a claim is tried, a few of each: for each initial time.
    fn points(&self, k: usize, asked: &Asked, each: usize) -> Vec<(usize, Vec<&Values>)> {
        let mut out: Vec<(usize, Vec<&Values>)> = Vec::new();
        for &t in &asked.on {
            let start = self.selection.start_of[self.selection.tried[t]];
            let of = self.weighed[t].points(k, each, asked.absent);
            match out.iter_mut().find(|(s, _)| *s == start) {
                Some((_, all)) => all.extend(of),
                None => out.push((start, of)),
            }
        }
        out
    }

    /// Points at which something is fitted: a few motions of one initial time, three points or more of each.
    fn fitted(&self, k: usize, asked: &Asked) -> Option<Points<'_>> {
        let each = FITTED.div_ceil(asked.on.len()).max(4);
        let start = asked.on.first().map(|&t| self.selection.start_of[self.selection.tried[t]])?;
        let on: Vec<usize> =
            asked.on.iter().copied().filter(|&t| self.selection.start_of[self.selection.tried[t]] == start).collect();
        let step = on.len().div_ceil(FITTED / 3).max(1);
        let (mut points, mut motions) = (Vec::new(), Vec::new());
        for &t in on.iter().step_by(step) {
            for point in self.weighed[t].points(k, each, asked.absent) {
                points.push(point);
                motions.push(t);
            }
        }
        // Two points agree with almost anything.
        (points.len() >= 3).then_some(Points { start, points, motions, known: &self.altered.known })
    }

    /// Equations that may say the rate of a quantity that is said to be constant.
    fn rates(
        &self,
        at: (usize, usize),
        asked: &Asked,
        graph: &mut Graph,
        setting: &Setting,
        atoms: &[Node],
    ) -> Vec<Candidate> {
        let (k, f) = at;
        let Some(formula) = self.altered.claims[k].formulas.get(f).filter(|of| of.rate.is_some()) else {
            return Vec::new();
        };
        let Some(points) = self.fitted(k, asked) else { return Vec::new() };
        let (nodes, values) = valued_atoms(graph, setting, atoms, &points);
        let found = rates(self.derivation, setting.claim, graph, formula, (&nodes, &values), &points);
        found.into_iter().map(|tree| Candidate::of_rate(at, tree)).collect()
    }

    /// Those of the trees that no point refutes.
    fn screened(
        &self,
        k: usize,
        asked: &Asked,
        graph: &mut Graph,
        setting: &Setting,
        (formula, size): (&Formula, usize),
        trees: &mut dyn Iterator<Item = Made>,
    ) -> Vec<Made> {
        let claim = setting.claim;
        let sign = claim.scope.branch_sign();
        let known: &[Leaf] = &self.altered.known;
        let points = self.points(k, asked, 6);
        let mut out = Vec::new();
        let together = (NODES_TOGETHER / size).clamp(1, PAIRS_TOGETHER);
        loop {
            let some: Vec<_> = (0..together).map_while(|_| trees.next()).collect();
            if some.is_empty() {
                return out;
            }
            let mut classes = Vec::new();
            let mut group = ClaimVariants { formulas: vec![formula.clone()], ..ClaimVariants::default() };
            for (of, tree) in some {
                if let Some(altered) = setting.altered(graph, formula, &tree).filter(|a| !a.is_empty()) {
                    let class = of.first().copied().unwrap_or(EditClass::Missing);
                    group.variants.push(Variant { class, formula: 0, source: Source::Tree(Box::new(tree)), altered });
                    classes.push(of);
                }
            }
            // A value that no motion was asked for is not known.
            let leaves = |v: &Variant| {
                let roots = v.altered.iter().flat_map(|(_, p)| p.difference.iter().copied());
                graph.leaves(roots).iter().all(|l| *l == sign || known.binary_search(l).is_ok())
            };
            let mut left: Vec<usize> = (0..group.variants.len()).filter(|&v| leaves(&group.variants[v])).collect();
            for (start, points) in &points {
                let Some(battery) = Battery::new(graph, &group, *start, left.clone(), sign) else { continue };
                let placed = Placed::new(battery, known);
                let precision = claim.precision;
                let points: Vec<Sample> = points.iter().map(|values| Sample::Alone(values)).collect();
                let evidence = Evidence { points: &points, first_counts: false, precision, one_sign_throughout: false };
                let found = rejection::rejected(&group, &placed, &evidence, &mut Memory::default());
                left.retain(|&v| !found.variants[v]);
            }
            out.extend(left.into_iter().map(|v| (classes[v].clone(), group.variants[v].tree(&group.formulas))));
        }
    }
}

/// A formula of which nothing is known but its tree, so that nothing is compared with its print: every part says 0 = 0.
fn without_print(graph: &mut Graph, formula: &Formula) -> Formula {
    let zero = graph.integer(0);
    let nothing =
        |part: &Part| Part { difference: vec![zero; part.difference.len()], sides: (zero, zero), ..part.clone() };
    Formula { parts: formula.parts.iter().map(nothing).collect(), ..formula.clone() }
}

/// Whether a formula says something else than equations: then an edit that holds says little.
pub(super) fn is_inequality(formula: &Formula) -> bool {
    formula.parts.iter().any(|p| p.kind != RelationKind::Equal)
}

/// The candidate as a claim of its own; `None` where it cannot be read as it is printed.
pub(super) fn as_claim(
    graph: &mut Graph,
    claim: &Claim,
    id: &str,
    candidate: &Candidate,
    manner: Manner,
    trajectories: Vec<usize>,
) -> Option<Claim> {
    let text = candidate.text.clone();
    let span = claim.span.clone();
    // Read again from its print: what is offered means what it shows.
    let (form, kind) = match manner {
        Manner::Relation => {
            let mut read = latex::read(&text, &claim.scope, graph).ok()?;
            let value = read.pop().filter(|_| read.is_empty())?;
            let meant = latex::elaborate(&candidate.tree, &claim.scope, graph).ok()?;
            let sides = |s: &latex::Statement| -> Vec<_> {
                s.relations.iter().map(|r| (r.kind, r.left.clone(), r.right.clone())).collect()
            };
            if sides(&value) != sides(&meant) {
                return None;
            }
            (Form::Always(Written { text, span, value }), FormKind::Always)
        }
        Manner::Constant => {
            let value = latex::read_expression(&text, &claim.scope, graph).ok()?;
            (Form::FirstIntegral(Written { text, span, value }), FormKind::FirstIntegral)
        }
    };
    let formulas = vec![derivation::Formula { text: candidate.text.clone(), kind }];
    let expect = vec![None; trajectories.len()];
    let id = id.to_owned();
    Some(Claim { id, reading: None, forms: vec![form], formulas, trajectories, expect, ..claim.clone() })
}
