//! What a claim that fails should have said.
//!
//! **In:** claims that fail where they are stated to hold, their variants, and the points at which they were tried. **Out:**
//! corrections: altered formulas that hold on every motion to which the claim applies.
//!
//! First single edits, then [`completion`](super::completion), then pairs of edits; the latter only where nothing nearer holds.
//! What passes at a few points of every motion is tried as a claim of its own, as it is printed, on the motions of the check:
//! only what gets the verdict `holds` on every one is offered (see `confirm`). So a correction is as strong as any verdict of this program.
//!
//! A correction that holds because it says nothing (x = x) is refused, and so is one whose units do not agree, if those of the
//! print do; one that is true by the definitions alone comes after those that are not. In which order they are offered is said
//! in `nearness`.

use meter::{Limits, Task};

use super::atom::atoms;
use super::completion::{Points, completions};
use super::confirm::Encloses;
use super::difference::difference;
use super::equivalence::Sight;
use super::gap::Insertions;
use super::generate::{ClaimVariants, Formula, Manner, Part, Setting, Source, Variant, drawn};
use super::nearness::{Nearness, edits_between};
use super::rejection::{self, Evidence, Placed};
use super::sites::Sites;
use super::tree::cancelled;
use super::vocabulary::{Vocabulary, phrases};
use super::{Altered, Battery, Memory, Weighed};
use crate::derivation::{Claim, Derivation, Form, FormKind, Written};
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::{ClaimAccount, EditClass, Erratum, PairAccount};
use crate::flow::Sample;
use crate::latex::syntax::{Chain, Node, to_latex};
use crate::latex::{self, RelationKind, Role};
use crate::verdict::Outcome;
use claim::error::CheckError;
use claim::program::Values;
use sampled::selection::Selection;
use sampled::trace::Trace;

/// Most candidates of one formula that are handed to the checker.
const MOST_CANDIDATES: usize = 12;
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

/// A formula that may be what was meant.
pub(super) struct Candidate {
    pub claim: usize,
    pub formula: usize,
    tree: Chain,
    pub text: String,
    pub classes: Vec<EditClass>,
    pub difference: String,
    pub nearness: Nearness,
}

/// An altered formula, with the edits that lead to it.
pub(super) type Made = (Vec<EditClass>, Chain);

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

impl Search<'_> {
    /// Looks for corrections of all claims that need one.
    pub fn offer(&self, accounts: &mut [ClaimAccount], traces: &[Trace]) -> Result<(), CheckError> {
        let wanted: Vec<Vec<bool>> = accounts.iter().map(asked).collect();
        let corrected: Vec<usize> = (0..wanted.len()).filter(|&k| wanted[k].contains(&true)).collect();
        let last = corrected.get(MOST_CORRECTED - 1).copied().unwrap_or(usize::MAX);
        let columns = self.selection.columns(self.derivation);
        let of_claim = |k: usize, account: &ClaimAccount| {
            let asked = &wanted[k];
            let on: Vec<usize> = account
                .results
                .iter()
                .zip(asked)
                .filter(|(_, asked)| **asked)
                .filter_map(|(p, _)| columns.get(p.trajectory.as_str()).copied())
                .collect();
            if on.is_empty() || k > last {
                return (Vec::new(), None, on);
            }
            let mut erratum = Erratum::default();
            let absent = account.results.iter().any(is_absent);
            let candidates = self.candidates(k, &Asked { on: on.clone(), absent }, &mut erratum);
            (candidates, Some(erratum), on)
        };
        let one = |&k: &usize, limits: &Limits| {
            meter::piece(Task::Weighing, limits, || of_claim(k, &accounts[k])).unwrap_or_else(|ended| {
                let remark = Some(ended.to_string());
                (Vec::new(), Some(Erratum { remark, ..Erratum::default() }), Vec::new())
            })
        };
        let all: Vec<usize> = (0..accounts.len()).collect();
        let found = meter::each(self.limits, &all, one);
        let (mut candidates, mut motions) = (Vec::new(), Vec::new());
        for ((of_claim, erratum, on), account) in found.into_iter().zip(accounts.iter_mut()) {
            candidates.push(of_claim);
            motions.push(on);
            if let (Some(variants), Some(erratum)) = (&mut account.variants, erratum) {
                variants.erratum = Some(erratum);
            }
        }
        self.confirm(accounts, candidates.into_iter().flatten().collect(), &motions, traces)
    }

    /// What passes at the points at which the claim was tried.
    fn candidates(&self, k: usize, asked: &Asked, erratum: &mut Erratum) -> Vec<Candidate> {
        let claim = &self.derivation.claims[self.selection.claims[k]];
        let variants = &self.altered.claims[k];
        let mut graph = self.altered.graph(k).clone();
        let setting = Setting { claim, starts: &self.selection.starts, shared: self.derivation.graph.len() };
        let vocabulary = Vocabulary::new(self.derivation, claim);
        let near = phrases(self.derivation, claim);
        let rejections: Vec<_> = asked.on.iter().filter_map(|&t| self.weighed[t].rejections[k].as_ref()).collect();
        let mut out = Vec::new();
        for (f, formula) in variants.formulas.iter().enumerate() {
            let absent = asked.absent && self.has_no_value(k, asked, &graph, formula);
            if is_inequality(formula) || !absent && !rejections.iter().any(|r| r.formulas[f]) {
                continue;
            }
            // Where the print has no value, what is tried instead must have one.
            let formula = &if absent { without_print(&mut graph, formula) } else { formula.clone() };
            let size = formula.size(&graph);
            let screened = |graph: &mut Graph, trees: &mut dyn Iterator<Item = Made>| {
                self.screened(k, asked, graph, &setting, (formula, size), trees)
            };
            let mut made: Vec<Made> = Vec::new();
            for (v, variant) in variants.variants.iter().enumerate().filter(|(_, v)| v.formula == f) {
                erratum.tried.0 += 1;
                if rejections.iter().all(|r| !r.variants[v]) {
                    made.push((vec![variant.class], variant.tree(&variants.formulas)));
                }
            }
            let empty = variants.empty.iter().filter(|v| v.formula == f);
            made.extend(empty.map(|v| (vec![v.class], v.tree(&variants.formulas))));
            if absent {
                made = screened(&mut graph, &mut made.into_iter());
            }
            let atoms = atoms(&formula.tree, &vocabulary, &near);
            let insertions = Insertions::new(&formula.tree, &vocabulary, &atoms);
            let inserted = insertions.count().min(MOST_INSERTED_NODES / size);
            let places = MOST_FITTED_NODES / size;
            let complete = self.completed(k, asked, &mut graph, &setting, &vocabulary, formula, (&atoms, places));
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
            out.extend(ranked(self.derivation, (k, f), &mut graph, &setting, &variants.formulas[f], &vocabulary, made));
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

    #[expect(clippy::too_many_arguments, reason = "a formula, its surroundings, and where it is tried")]
    fn completed(
        &self,
        k: usize,
        asked: &Asked,
        graph: &mut Graph,
        setting: &Setting,
        vocabulary: &Vocabulary,
        formula: &Formula,
        (atoms, places): (&[Node], usize),
    ) -> Vec<Chain> {
        let each = FITTED.div_ceil(asked.on.len()).max(4);
        // A few motions, three points or more of each: with all of them for one initial time.
        let Some(start) = asked.on.first().map(|&t| self.selection.start_of[self.selection.tried[t]]) else {
            return Vec::new();
        };
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
        if points.len() < 3 {
            return Vec::new();
        }
        let points = Points { start, points, motions, known: &self.altered.known };
        completions(graph, setting, vocabulary, formula, atoms, &points, places)
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

/// Candidates, the closest to the print first, without those that say nothing or what another says.
pub(super) fn ranked(
    derivation: &Derivation,
    (k, f): (usize, usize),
    graph: &mut Graph,
    setting: &Setting,
    formula: &Formula,
    vocabulary: &Vocabulary,
    made: Vec<Made>,
) -> Vec<Candidate> {
    let print = to_latex(&formula.tree);
    let mut group = ClaimVariants { formulas: vec![formula.clone()], ..ClaimVariants::default() };
    let mut kept = Vec::new();
    for (classes, tree) in made {
        // What is multiplied and divided again was never there; an addition that only undoes what is printed is none.
        let plain = Chain { sides: tree.sides.iter().map(cancelled).collect(), ..tree.clone() };
        if plain != tree && classes == [EditClass::Missing] {
            continue;
        }
        let tree = plain;
        let Some(altered) = setting.altered(graph, formula, &tree).filter(|a| !a.is_empty()) else { continue };
        // Both sides are one expression, or nothing is left that could be compared.
        let says_nothing = altered
            .iter()
            .all(|(_, p)| p.sides.0 == p.sides.1 || graph.leaves(p.difference.iter().copied()).is_empty());
        if says_nothing && altered.len() == formula.parts.len() {
            continue;
        }
        let (difference, changed) = difference(&print, &to_latex(&tree));
        let class = classes.first().copied().unwrap_or(EditClass::Missing);
        let variant = Variant { class, formula: 0, source: Source::Tree(Box::new(tree)), altered };
        kept.push((variant, classes, difference, changed));
    }
    let nearness = Nearness::of_all(derivation, setting.claim, graph, formula, vocabulary, &kept);
    // What adds joules to kilograms is no correction of what did not.
    let as_printed: Vec<_> = formula.parts.iter().map(|p| (p.sides.0, Some(p.sides.1))).collect();
    let odd = units::inconsistent(derivation, graph, &[as_printed]).contains(&true);
    let mut kept: Vec<_> = kept.into_iter().zip(nearness).filter(|(_, n)| odd || !n.inconsistent).collect();
    kept.sort_by(|a, b| a.1.cmp(&b.1));
    let mut rest = Vec::new();
    for ((variant, classes, difference, _), nearness) in kept {
        group.variants.push(variant);
        rest.push((classes, difference, nearness));
    }
    let sights = group.sights(derivation, setting.claim, graph, true);
    let by_algebra = group.sights(derivation, setting.claim, graph, false);
    let sights = sights.into_iter().zip(by_algebra);
    // What is made of parameters alone can only be true by algebra.
    let scope = &setting.claim.scope;
    let residuals: Vec<Expr> = formula.parts.iter().flat_map(|p| p.difference.iter().copied()).collect();
    let leaves = graph.leaves(residuals);
    let moves = leaves.iter().any(|l| l.instant.is_none() && scope.role(l.symbol) != Some(Role::Parameter));
    let mut out: Vec<Candidate> = Vec::new();
    for ((variant, (sight, alone)), (classes, difference, mut nearness)) in
        std::mem::take(&mut group.variants).into_iter().zip(sights).zip(rest)
    {
        if matches!(sight, Sight::Same | Sight::Repeated | Sight::Said) {
            continue;
        }
        // What does not move anyway says nothing by being constant, and what was added only to make both sides one
        // expression says nothing either.
        let trivial = sight == Sight::Empty && formula.manner == Manner::Constant;
        let made_up = moves && alone == Sight::Empty && edits_between(&classes) > edits_between(&[EditClass::Sign]);
        if trivial || made_up {
            continue;
        }
        let tree = variant.tree(&group.formulas);
        let text = to_latex(&tree);
        nearness.empty = sight == Sight::Empty;
        out.push(Candidate { claim: k, formula: f, tree, text, classes, difference, nearness });
    }
    out.sort_by(|a, b| a.nearness.cmp(&b.nearness));
    out.truncate(MOST_CANDIDATES);
    out
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

/// Pairs of edits of a formula: every edit of every variant of it, thinned evenly where there are too many.
struct Pairs<'a> {
    formulas: &'a [Formula],
    vocabulary: &'a Vocabulary,
    /// The variants that are left.
    of: std::vec::IntoIter<&'a Variant>,
    /// Pairs that may still be made of them.
    room: usize,
    /// Those of one variant.
    made: std::vec::IntoIter<Made>,
}

impl<'a> Pairs<'a> {
    fn new(variants: &'a ClaimVariants, f: usize, vocabulary: &'a Vocabulary, room: usize) -> Pairs<'a> {
        let of: Vec<&Variant> = variants.variants.iter().filter(|v| v.formula == f).collect();
        Pairs { formulas: &variants.formulas, vocabulary, of: of.into_iter(), room, made: Vec::new().into_iter() }
    }
}

impl Iterator for Pairs<'_> {
    type Item = Made;

    fn next(&mut self) -> Option<Made> {
        loop {
            if let Some(made) = self.made.next() {
                return Some(made);
            }
            // The same share of each variant's edits.
            let share = self.room / self.of.len().max(1);
            let variant = self.of.next()?;
            let tree = variant.tree(self.formulas);
            let sites = Sites::new(&tree, self.vocabulary);
            let step = sites.count().div_ceil(share.max(1)).max(1);
            let edits = sites.at(&mut (0..sites.count()).step_by(step).take(self.room));
            self.room -= edits.len();
            let made = edits.into_iter().map(|edit| (vec![variant.class, edit.class], edit.apply(&tree)));
            self.made = made.collect::<Vec<Made>>().into_iter();
        }
    }
}
