//! The matrix of page one: the claims that matter × classes of motions.
//!
//! **In:** the claims of an account with all their readings. **Out:** a table of at most [`MOST_ROWS`] × [`MOST_COLUMNS`] symbols, with the
//! legend of those that occur.
//!
//! **Classes.** Motions are told apart by the conditions that separate where claims hold from where they fail; where none does, by the
//! verdicts of the claims that are shown. Families of motions have columns of their own, and what is known without a motion has one.

use std::collections::{BTreeMap, BTreeSet};

use super::consequence::Consequences;
use super::digest::{self, Fate, Reading, Whole};
use super::discrimination;
use super::graph::ProofStanding;
use super::headline::CountedFate;
use super::limited::limited;
use super::numbers::count;
use super::said::said;
use super::story::{
    self, StoryBlock, StoryItem, StorySpan, StoryTable, TableCells, Tone, VerdictShape, joined, quiet, roomy, words,
};
use super::tally::motion_title;
use derivation::{ClaimRole, Derivation};
use findings::{Account, ClaimAccount, Outcome, PairAccount, Strength};

/// Most claims that are shown.
pub(super) const MOST_ROWS: usize = 9;
/// The same where the paper has conclusions, which page one tells by themselves, too.
const MOST_ROWS_BESIDE: usize = 6;
/// Most classes of motions that are shown.
pub(super) const MOST_COLUMNS: usize = 6;
/// Longest head of a row, in letters.
const LONGEST_HEAD: usize = 38;
/// Most motions that are named of a class.
const MOST_NAMED: usize = 3;
/// Most classes that are compared, each with each; of more the smallest are put together.
const MOST_COMPARED: usize = 40;
/// Conditions that tell motions apart.
const MOST_CONDITIONS: usize = 2;

/// What a column is about.
enum ColumnMotions<'a> {
    Motions(BTreeSet<&'a str>),
    Families(Vec<&'a str>),
    AllValues,
}

/// A column with what it is.
struct MatrixColumn<'a> {
    says: Vec<StorySpan<'a>>,
    of: ColumnMotions<'a>,
}

/// The claims that matter, in the order of the paper: its conclusions, what is stated and used differently, what does not stand, and what
/// most rests on.
pub(super) fn that_matter<'w, 'a>(
    derivation: &Derivation,
    wholes: &'w [Whole<'a>],
    hangs: &Consequences<'_>,
) -> Vec<&'w Whole<'a>> {
    let used_otherwise = limited(derivation, wholes, hangs).first().map(|l| l.whole.id);
    let of_paper: Vec<usize> = (0..wholes.len()).filter(|&at| wholes[at].fate.is_of_the_paper()).collect();
    let mut all: Vec<usize> = if of_paper.is_empty() { (0..wholes.len()).collect() } else { of_paper };
    all.sort_by_cached_key(|&at| {
        let whole = &wholes[at];
        (
            !whole.conclusion,
            Some(whole.id) != used_otherwise,
            !whole.fate.is_against(),
            std::cmp::Reverse(hangs.weight(whole.id)),
            at,
        )
    });
    all.truncate(if hangs.conclusions().is_empty() { MOST_ROWS } else { MOST_ROWS_BESIDE });
    all.sort_unstable();
    all.into_iter().map(|at| &wholes[at]).collect()
}

/// What symbols mean.
fn legend<'a>(seen: &BTreeSet<VerdictShape>) -> Vec<StorySpan<'a>> {
    let legend = VerdictShape::ALL.into_iter().filter(|s| seen.contains(s));
    joined(legend.map(|s| vec![StorySpan::Shape(s), quiet(format!(" {}", s.says()))]), "  ")
}

/// The matrix, its columns and its legend, which tells the symbols of what follows, too; where nothing was tried, that.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    (wholes, hangs): (&[Whole<'a>], &Consequences<'_>),
    following: BTreeSet<VerdictShape>,
) -> Vec<StoryBlock<'a>> {
    let rows = that_matter(derivation, wholes, hangs);
    let columns = columns(derivation, account, &rows);
    let letter = |at: usize| char::from_u32(u32::from('a') + at as u32).map(String::from).unwrap_or_default();
    let table = StoryTable {
        title: "Claims and classes of motions".to_owned(),
        head: std::iter::once(Vec::new()).chain((0..columns.len()).map(|at| vec![quiet(letter(at))])).collect(),
        rows: rows.iter().map(|whole| row(derivation, whole, &columns, hangs)).collect(),
        cells: TableCells::Symbols,
    };
    let table = StoryBlock::Table(table);
    let mut legend = legend(&(&story::shapes(std::slice::from_ref(&table)) | &following));
    let has_share = |whole: &Whole<'_>, of| cell(whole, of).and_then(|shape| share(whole, of, shape)).is_some();
    if rows.iter().any(|whole| columns.iter().any(|column| has_share(whole, &column.of))) {
        legend.push(quiet("; 1/3: where it applies"));
    }
    if rows.iter().any(|whole| columns.iter().any(|column| as_used(whole, &column.of).is_some())) {
        legend.push(quiet("; / ✖: as used"));
    }
    if rows.iter().any(|whole| columns.iter().any(|column| on_drawn(whole, &column.of).is_some())) {
        legend.push(quiet(format!("; ≢ / {}: on a drawn motion", VerdictShape::Fails.sign())));
    }
    let more = wholes.iter().filter(|w| w.fate.is_of_the_paper()).count().saturating_sub(rows.len());
    if more > 0 {
        let more = StorySpan::Section(format!("+{more} rows"), "/claims".to_owned());
        legend.push(StorySpan::Roomy(vec![quiet("; "), more]));
    }
    let keys = columns.into_iter().enumerate().map(|(at, column)| StoryItem {
        mark: letter(at),
        line: column.says,
        below: Vec::new(),
    });
    let keys: Vec<StoryItem<'a>> = keys.collect();
    let mut out = vec![table];
    if keys.is_empty() {
        out.push(StoryBlock::Paragraph(vec![quiet("Nothing was tried on a motion, and nothing for all values.")]));
    } else {
        out.push(StoryBlock::Paragraph(legend));
        out.push(StoryBlock::Group("keys", vec![StoryBlock::List(keys)]));
    }
    out
}

fn row<'a>(
    derivation: &'a Derivation,
    whole: &Whole<'a>,
    columns: &[MatrixColumn<'a>],
    hangs: &Consequences<'_>,
) -> Vec<Vec<StorySpan<'a>>> {
    let tone = match whole.fate {
        Fate::Fails | Fate::Partly => Tone::Bad,
        Fate::Reading => Tone::Open,
        _ if whole.counted_as() == CountedFate::OnFile => Tone::Open,
        _ => Tone::Plain,
    };
    let mut head = vec![said(derivation, whole, tone, LONGEST_HEAD)];
    if let Some(letter) = hangs.letter(whole.id) {
        head.insert(0, StorySpan::Words(format!("{letter} "), Tone::Strong));
    }
    let cells = columns.iter().map(|column| {
        let stated = cell(whole, &column.of);
        let slash = stated.map(|_| quiet("\u{a0}/\u{a0}"));
        let stated = stated.into_iter().flat_map(|shape| {
            let share = share(whole, &column.of, shape).map(|(some, all)| quiet(format!("\u{a0}{some}/{all}")));
            std::iter::once(StorySpan::Shape(shape)).chain(share)
        });
        let used = as_used(whole, &column.of).or_else(|| on_drawn(whole, &column.of));
        let used = used.into_iter().flat_map(|shape| slash.clone().into_iter().chain([StorySpan::Shape(shape)]));
        stated.chain(used).collect()
    });
    std::iter::once(head).chain(cells).collect()
}

/// The symbol of a claim that stands as it is stated where it fails as the paper uses it.
fn as_used(whole: &Whole<'_>, column: &ColumnMotions<'_>) -> Option<VerdictShape> {
    let used = whole.failing_need().filter(|_| !whole.fate.is_against())?;
    of_reading(used, column).filter(|shape| shape.tone() == Tone::Bad)
}

/// The symbol of a claim that stands on the motions of the file and fails on one that was drawn: beside what is known for all values.
fn on_drawn(whole: &Whole<'_>, column: &ColumnMotions<'_>) -> Option<VerdictShape> {
    match column {
        ColumnMotions::AllValues => whole.shape_on_drawn(),
        ColumnMotions::Motions(_) | ColumnMotions::Families(_) => None,
    }
}

/// The reading that fails, of which the page tells, where it fails on this class of motions; with its symbol there.
fn told_failing<'w, 'a>(whole: &'w Whole<'a>, column: &ColumnMotions<'_>) -> Option<(&'w Reading<'a>, VerdictShape)> {
    let failing = whole.failing().filter(|r| whole.fate.is_against() && r.role == ClaimRole::Says)?;
    let shape = of_reading(failing, column).filter(|shape| shape.tone() == Tone::Bad)?;
    Some((failing, shape))
}

/// On how many motions of a class it is as the symbol says, and to how many it applies, where it is not so on all of these: fails, or holds
/// (of one that holds on some).
fn share(whole: &Whole<'_>, column: &ColumnMotions<'_>, shape: VerdictShape) -> Option<(usize, usize)> {
    let ColumnMotions::Motions(named) = column else { return None };
    let is_so = |p: &&PairAccount| match (shape, p.verdict.outcome()) {
        (_, Outcome::NotApplicable(_)) => false,
        (VerdictShape::Fails | VerdictShape::Certified, outcome) => matches!(outcome, Outcome::Fails(_)),
        (VerdictShape::Weak, _) => true,
        // Where much else would hold counts where no motion tells more.
        (_, Outcome::Holds(_)) => !discrimination::is_weak(p),
        (_, Outcome::Fails(_) | Outcome::Undecided) => shape.tone() == Tone::Open,
    };
    let applies = |p: &&PairAccount| !matches!(p.verdict.outcome(), Outcome::NotApplicable(_));
    let told = told_failing(whole, column);
    let readings = whole.deciding().filter(|r| told.is_none_or(|(told, _)| std::ptr::eq(told.claim, r.claim)));
    let readings: Vec<&Reading<'_>> = readings.collect();
    let on = |is: &dyn Fn(&&PairAccount) -> bool| {
        let pairs = readings.iter().flat_map(|reading| &reading.claim.results).filter(is);
        pairs.map(|p| p.trajectory.as_str()).filter(|id| named.contains(id)).collect::<BTreeSet<_>>().len()
    };
    let (found, of) = (on(&is_so), on(&applies));
    // A sign that refutes says to how many it applies, where that is not the whole class.
    let refutes_some = matches!(shape, VerdictShape::Fails | VerdictShape::Certified) && of < named.len();
    (found > 0 && (found < of || refutes_some)).then_some((found, of))
}

/// What a class of motions says of a claim with all its readings.
fn cell(whole: &Whole<'_>, column: &ColumnMotions<'_>) -> Option<VerdictShape> {
    let each: Vec<(ClaimRole, VerdictShape)> =
        whole.deciding().filter_map(|reading| Some((reading.role, of_reading(reading, column)?))).collect();
    if each.is_empty() {
        // What the paper says of it could not be computed: it is told by its contrary, and by what it needs.
        let other = |role: ClaimRole| whole.readings.iter().filter(move |r| r.role == role);
        let shown = |r: &Reading<'_>| of_reading(r, column).filter(|s| *s != VerdictShape::NotApplicable);
        let contrary = other(ClaimRole::Against).filter_map(shown).find(|s| s.tone() == Tone::Good);
        let needed = other(ClaimRole::Needs).filter_map(shown).find(|s| s.tone() == Tone::Bad);
        return contrary.map(|_| VerdictShape::Certified).or(needed);
    }
    // Of several that it says the one that is told of, with its share, so that numbers of the page agree.
    if let Some((failing, shape)) = told_failing(whole, column) {
        return match (shape, column) {
            (VerdictShape::Mixed, ColumnMotions::Motions(named)) => refutes(failing, named),
            (shape, _) => Some(shape),
        };
    }
    let applies: Vec<_> = each.iter().filter(|(_, shape)| *shape != VerdictShape::NotApplicable).collect();
    let weakest = |shapes: &mut dyn Iterator<Item = VerdictShape>| shapes.max();
    let is_bad = |shape: &VerdictShape| shape.tone() == Tone::Bad;
    let said = |role: ClaimRole| applies.iter().filter(move |(of, _)| *of == role).map(|(_, shape)| *shape);
    // Another that it says may fail where that one holds.
    let bad: Vec<VerdictShape> = said(ClaimRole::Says).filter(is_bad).collect();
    if let Some(worst) = bad.iter().find(|s| **s != VerdictShape::Mixed).or(bad.first()) {
        return Some(*worst);
    }
    let meant: Vec<VerdictShape> = said(ClaimRole::MayMean).collect();
    let (bad, good) = (meant.iter().any(is_bad), meant.iter().any(|s| !is_bad(s)));
    match (bad, good) {
        (true, true) => Some(VerdictShape::Meaning),
        (true, false) => meant.into_iter().find(is_bad),
        _ if applies.is_empty() => each.first().map(|(_, shape)| *shape),
        _ => weakest(&mut applies.iter().map(|(_, shape)| *shape)),
    }
}

/// How a reading fails on those motions of a class on which it fails.
fn refutes(reading: &Reading<'_>, named: &BTreeSet<&str>) -> Option<VerdictShape> {
    let of_class = reading.claim.results.iter().filter(|p| named.contains(p.trajectory.as_str()));
    of_class.map(|p| shape(p.verdict.outcome())).filter(|s| s.tone() == Tone::Bad).max()
}

/// What a class of motions says of one reading; `None` where it was not tried.
fn of_reading(reading: &Reading<'_>, column: &ColumnMotions<'_>) -> Option<VerdictShape> {
    let claim = reading.claim;
    let mut all: Vec<VerdictShape> = Vec::new();
    match column {
        ColumnMotions::Motions(named) => {
            for pair in claim.results.iter().filter(|p| named.contains(p.trajectory.as_str())) {
                let weak = discrimination::is_weak(pair);
                all.push(if weak { VerdictShape::Weak } else { on_motion(reading, pair.verdict.outcome()) });
            }
        }
        ColumnMotions::Families(named) => {
            for family in claim.families.iter().filter(|f| named.contains(&f.family.as_str())) {
                all.push(shape(family.verdict.outcome()));
                if family.counts.fails > 0 && family.counts.holds > 0 {
                    return Some(VerdictShape::Mixed);
                }
            }
        }
        ColumnMotions::AllValues => return for_all_values(reading),
    }
    all.retain({
        let some = all.iter().any(|s| *s != VerdictShape::NotApplicable);
        move |s| !some || *s != VerdictShape::NotApplicable
    });
    let bad = all.iter().filter(|s| s.tone() == Tone::Bad).count();
    let open = all.contains(&VerdictShape::Undecided);
    match (all.len(), bad) {
        (0, _) => None,
        (n, bad) if bad == n => all.into_iter().max(),
        (_, 0) if open => Some(VerdictShape::Undecided),
        // Of what holds the weakest is shown, but for verdicts that would be weak only by themselves.
        (_, 0) => all.iter().copied().filter(|s| *s != VerdictShape::Weak).max().or(Some(VerdictShape::Weak)),
        (..) if all.iter().all(|s| matches!(s.tone(), Tone::Bad | Tone::Open)) => Some(VerdictShape::Fails),
        _ => Some(VerdictShape::Mixed),
    }
}

/// What is known of a reading without a motion: over its ranges, or as a step.
fn for_all_values(reading: &Reading<'_>) -> Option<VerdictShape> {
    if let Some(region) = reading.claim.region.as_ref().filter(|_| reading.proof != ProofStanding::Proved) {
        return Some(match region.verdict.outcome() {
            // At every point of the ranges, which are not all values; for all fields it is a proof.
            Outcome::Holds(Strength::Proved) if !region.is_of_fields() => VerdictShape::Enclosed,
            outcome => shape(outcome),
        });
    }
    match (&reading.proof, reading.claim.verdict_alone(), reading.claim.identity.as_ref()?.verdict()) {
        (ProofStanding::Proved, ..) => Some(VerdictShape::Proved),
        (ProofStanding::Given(_), ..) => Some(VerdictShape::ProvedGiven),
        (ProofStanding::Except, ..) => Some(VerdictShape::ProvedExcept),
        (ProofStanding::Unreplayed, ..) => Some(VerdictShape::Unreplayed),
        (_, Some("fails"), _) => Some(VerdictShape::Certified),
        (_, _, "refuted") => Some(VerdictShape::NoIdentity),
        (_, Some("undecided"), _) => Some(VerdictShape::Undecided),
        _ => None,
    }
}

/// The symbol of a verdict on a motion: what is proved along it alone, and for other values is not, is so at every time of it.
fn on_motion(reading: &Reading<'_>, outcome: Outcome) -> VerdictShape {
    match (outcome, &reading.proof) {
        (Outcome::Holds(Strength::Proved), ProofStanding::None | ProofStanding::Circular) => VerdictShape::Enclosed,
        (outcome, _) => shape(outcome),
    }
}

/// The symbol of a verdict.
pub(super) fn shape(outcome: Outcome) -> VerdictShape {
    match outcome {
        Outcome::Holds(Strength::Proved) => VerdictShape::Proved,
        Outcome::Holds(Strength::Enclosed) => VerdictShape::Enclosed,
        Outcome::Holds(Strength::Sampled) => VerdictShape::Sampled,
        Outcome::Fails(Strength::Sampled) => VerdictShape::Fails,
        Outcome::Fails(Strength::Enclosed | Strength::Proved) => VerdictShape::Certified,
        Outcome::NotApplicable(_) => VerdictShape::NotApplicable,
        Outcome::Undecided => VerdictShape::Undecided,
    }
}

/// The columns: classes of motions, families, and what needs no motion.
fn columns<'a>(derivation: &'a Derivation, account: &'a Account, rows: &[&Whole<'a>]) -> Vec<MatrixColumn<'a>> {
    let shown: Vec<&'a ClaimAccount> = rows.iter().flat_map(|w| w.deciding()).map(|r| r.claim).collect();
    let known = rows.iter().flat_map(|w| w.deciding()).any(|r| for_all_values(r).is_some())
        || rows.iter().any(|w| w.shape_on_drawn().is_some());
    let mut families: Vec<&'a str> = Vec::new();
    for family in shown.iter().flat_map(|c| &c.families) {
        if !families.contains(&family.family.as_str()) {
            families.push(&family.family);
        }
    }
    let of_families = families.len().min(2);
    let mut out = motions(derivation, account, &shown, MOST_COLUMNS - of_families - usize::from(known));
    match families.as_slice() {
        few if few.len() <= 2 => out.extend(few.iter().map(|family| MatrixColumn {
            says: family_says(derivation, family),
            of: ColumnMotions::Families(vec![family]),
        })),
        all => {
            let says = format!("{}: {}", count(all.len(), "family"), named(all));
            out.push(MatrixColumn { says: vec![words(says)], of: ColumnMotions::Families(all.to_vec()) });
        }
    }
    if known {
        let over_ranges = |r: &Reading<'_>| r.claim.region.as_ref().is_some_and(|region| !region.is_of_fields());
        let has_ranges = rows.iter().flat_map(|w| w.deciding()).any(over_ranges);
        let says = if has_ranges { "for all values, or all of the ranges" } else { "for all values" };
        out.push(MatrixColumn { says: vec![words(says)], of: ColumnMotions::AllValues });
    }
    out
}

fn named(of: &[&str]) -> String {
    let shown = if of.len() > MOST_NAMED + 1 { MOST_NAMED } else { of.len() };
    let more = of.len() - shown;
    let list = of[..shown].join(", ");
    if more > 0 { format!("{list} and {more} more") } else { list }
}

/// Longest title of a motion, in letters.
const LONGEST_TITLE: usize = 30;
/// The same of a family.
const LONGEST_FAMILY_TITLE: usize = 50;

/// Motions by their names, each with its title where that is short.
fn titled<'a>(derivation: &'a Derivation, of: &[&str]) -> Vec<StorySpan<'a>> {
    let shown = if of.len() > MOST_NAMED + 1 { MOST_NAMED } else { of.len() };
    let one = |id: &&str| {
        let title = motion_title(derivation, id, LONGEST_TITLE);
        let title = title.map(|t| StorySpan::Prose(format!(" ({t})"), &derivation.scope, Tone::Quiet));
        std::iter::once(words(id.to_string())).chain(title).collect()
    };
    let mut out = joined(of[..shown].iter().map(one), ", ");
    if of.len() > shown {
        out.push(words(format!(" and {} more", of.len() - shown)));
    }
    out
}

/// A family by its name and its title up to the first stop.
fn family_says<'a>(derivation: &'a Derivation, id: &str) -> Vec<StorySpan<'a>> {
    let title = derivation.families.iter().find(|f| f.id == id).and_then(|f| f.title.split([':', ';']).next());
    let title = title.filter(|t| *t != id && t.chars().count() <= LONGEST_FAMILY_TITLE);
    let title = title.map(|t| StorySpan::Prose(format!(" ({t})"), &derivation.scope, Tone::Quiet));
    let name = [words("the family "), StorySpan::Words(id.to_owned(), Tone::Strong)];
    name.into_iter().chain(title).collect()
}

/// What tells motions apart.
#[derive(PartialEq)]
enum ClassMark<'a> {
    /// Whether each condition is met.
    Conditions(Vec<Option<bool>>),
    /// The verdicts of the claims that are shown.
    Verdicts(Vec<Option<&'a str>>),
}

/// Which of the conditions a class of motions meets, in words: those that are met; where only some are, that; else that none is.
fn condition_words<'a>(
    derivation: &'a Derivation,
    met: &[Option<bool>],
    conditions: &[digest::Unsaid<'_>],
) -> Vec<Vec<StorySpan<'a>>> {
    let with = |is: bool| met.iter().zip(conditions).filter(move |(met, _)| **met == Some(is)).map(|(_, u)| u);
    let (some, others) = (with(true).count(), with(false).count());
    let says = |u: &digest::Unsaid<'_>, lead: &str| {
        let text = format!("{lead}{}", digest::explanation(u.explanation));
        vec![StorySpan::Prose(text, &derivation.scope, Tone::Plain)]
    };
    match (some, others) {
        (0, 0) => Vec::new(),
        (0, 1) => vec![vec![words("the others")]],
        (0, 2) => vec![vec![words("neither")]],
        (0, _) => vec![vec![words("none of these")]],
        (_, 0) => with(true).map(|u| says(u, "")).collect(),
        _ => with(true).map(|u| says(u, "only ")).collect(),
    }
}

/// Of how many claims two classes have other verdicts; what fails and what does not apply is as far apart as what holds and what fails.
fn apart(a: &ClassMark<'_>, b: &ClassMark<'_>) -> usize {
    match (a, b) {
        (ClassMark::Verdicts(a), ClassMark::Verdicts(b)) => a.iter().zip(b).filter(|(a, b)| a != b).count(),
        (ClassMark::Conditions(a), ClassMark::Conditions(b)) => a.iter().zip(b).filter(|(a, b)| a != b).count(),
        (ClassMark::Verdicts(_), ClassMark::Conditions(_)) | (ClassMark::Conditions(_), ClassMark::Verdicts(_)) => {
            usize::MAX
        }
    }
}

/// Puts the two classes together that are most alike, until there are so many.
fn put_together<'a>(classes: &mut Vec<(ClassMark<'a>, Vec<&'a str>)>, most: usize) {
    while classes.len() > most {
        let pairs = (0..classes.len()).flat_map(|i| (i + 1..classes.len()).map(move |j| (i, j)));
        let of = |at: usize| classes.get(at).map(|(mark, _)| mark);
        let alike = pairs.min_by_key(|&(i, j)| of(i).zip(of(j)).map_or(usize::MAX, |(a, b)| apart(a, b)));
        let Some((first, second)) = alike else { break };
        let (_, ids) = classes.remove(second);
        if let Some((_, known)) = classes.get_mut(first) {
            known.extend(ids);
        }
    }
}

/// Classes of motions, at most so many: those on which most claims fare alike are put together; where conditions tell them apart, the
/// smallest.
fn motions<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    shown: &[&'a ClaimAccount],
    most: usize,
) -> Vec<MatrixColumn<'a>> {
    let unsaid = digest::unsaid(derivation, account);
    let conditions: Vec<_> = unsaid.into_iter().take(MOST_CONDITIONS).collect();
    let met: Vec<BTreeMap<&str, bool>> = conditions
        .iter()
        .map(|u| {
            let separated = u.claims.iter().filter_map(|c| c.conditions.separation.as_ref());
            let pairs = separated.flat_map(|s| {
                let with = |ids: &'a Vec<String>, is: bool| ids.iter().map(move |id| (id.as_str(), is));
                with(&s.holds, true).chain(with(&s.fails, false))
            });
            pairs.collect()
        })
        .collect();
    let verdicts: Vec<_> = shown.iter().map(|c| c.on_each()).collect();
    let mut classes: Vec<(ClassMark<'a>, Vec<&'a str>)> = Vec::new();
    for t in &account.trajectories {
        let of: Vec<Option<&str>> =
            verdicts.iter().map(|on| on.get(t.id.as_str()).map(|p| p.verdict.outcome().word())).collect();
        if of.iter().all(Option::is_none) {
            continue;
        }
        let mark = match conditions.is_empty() {
            true => ClassMark::Verdicts(of),
            false => ClassMark::Conditions(met.iter().map(|m| m.get(t.id.as_str()).copied()).collect()),
        };
        match classes.iter_mut().find(|(known, _)| *known == mark) {
            Some((_, ids)) => ids.push(&t.id),
            None => classes.push((mark, vec![&t.id])),
        }
    }
    let mut rest: Vec<&'a str> = Vec::new();
    let most = most.max(1);
    if conditions.is_empty() && classes.len() <= MOST_COMPARED {
        put_together(&mut classes, most);
    }
    while classes.len() + usize::from(!rest.is_empty()) > most {
        let Some(least) = (0..classes.len()).rev().min_by_key(|&at| classes[at].1.len()) else { break };
        rest.extend(classes.remove(least).1);
    }
    let says = |mark: &ClassMark<'a>, ids: &[&str]| -> Vec<StorySpan<'a>> {
        let n = count(ids.len(), "motion");
        match mark {
            ClassMark::Verdicts(_) => titled(derivation, ids),
            ClassMark::Conditions(of) => {
                let mut out = joined(condition_words(derivation, of, &conditions), "; ");
                let lead = if out.is_empty() { "neither is known: " } else { ": " };
                let first = ids.first().copied().unwrap_or_default();
                match ids.len() {
                    1 => out.push(quiet(format!("{lead}{first}"))),
                    _ => out.extend([quiet(format!("{lead}{n}")), roomy(format!(", e.g. {first}"))]),
                }
                out
            }
        }
    };
    let mut out: Vec<MatrixColumn<'a>> = classes
        .iter()
        .map(|(mark, ids)| MatrixColumn {
            says: says(mark, ids),
            of: ColumnMotions::Motions(ids.iter().copied().collect()),
        })
        .collect();
    if !rest.is_empty() {
        let mut says = vec![words(format!("the other {}: ", count(rest.len(), "motion")))];
        says.extend(titled(derivation, &rest));
        out.push(MatrixColumn { says, of: ColumnMotions::Motions(rest.into_iter().collect()) });
    }
    out
}
