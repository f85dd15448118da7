//! What was found for a claim over ranges, made from its cells.

use super::ends::{enclosed, nearest};
use super::map::draw;
use super::question::{Insertion, Question};
use super::signs::{Cell, Variable};
use super::subdivide::Division;
use crate::derivation::{Claim, Region, Values};
use crate::expr::Graph;
use crate::findings::region::{Part, RangeAccount, RegionAccount, RegionWitness, Shares};
use crate::findings::standing::Decision;
use crate::findings::{ClaimAccount, IdentityAccount};
use crate::number::Interval;
use crate::verdict::{Finding, Possible, Strength, Truth, Verdict};
use proof::Proof;

/// A part of the volume, in words.
fn percent(share: f64, whole: bool) -> String {
    match 100.0 * share {
        p if share > 0.0 && p < 0.1 => "less than 0.1 %".to_owned(),
        p if !whole && p > 99.9 => "more than 99.9 %".to_owned(),
        p => format!("{} %", (10.0 * p).round() / 10.0),
    }
}

/// The account of a claim about fields, by what was decided of it as a step: over all of them, not over ranges.
pub fn of_step(claim: &Claim, region: &Region, step: Option<&IdentityAccount>) -> RegionAccount {
    let (known, reason) = match step {
        None => (Possible::ANY, "it is no equation that could follow from others".to_owned()),
        Some(step) => match (step.finding.decision(), &step.witness) {
            // What is given may assume more than this does, or say less.
            (Decision::Proved, _) if !step.presupposed.is_empty() => {
                let assumed: Vec<String> = step.presupposed.iter().map(|text| format!("${text}$")).collect();
                let assumed = assumed.join(", ");
                (Possible::ANY, format!("what it follows from assumes {assumed}, and it does not say so itself"))
            }
            (Decision::Proved, _) if step.is_proved() && step.lends_strength() => {
                (Possible::TRUE, for_all(claim, step))
            }
            (Decision::Refuted, Some(point)) => {
                (Possible::FALSE, format!("a solution near a point contradicts it: {}", marked(point)))
            }
            _ => (Possible::ANY, step.sentence()),
        },
    };
    let strength = if known == Possible::TRUE { Strength::Proved } else { Strength::Enclosed };
    RegionAccount { verdict: Verdict::over_ranges(known, strength, 1, Some(&[]), reason), ..empty(region) }
}

fn empty(region: &Region) -> RegionAccount {
    RegionAccount {
        verdict: Verdict::of(Finding::open("it was not looked at")),
        expected: region.expect,
        varying: 0,
        unknowns: Vec::new(),
        unique: false,
        ranges: Vec::new(),
        shares: Shares::default(),
        cells: 0,
        depth: 0,
        witness: None,
        solutions: Vec::new(),
        identities: Vec::new(),
        remarks: Vec::new(),
        map: None,
        portraits: Vec::new(),
    }
}

pub fn blank(region: &Region, graph: &Graph, put: &Insertion, variables: &[Variable]) -> RegionAccount {
    let mut ranges = Vec::new();
    for ranged in &region.ranges {
        // A field has one formula for all its components.
        let field = graph.is_field(ranged.leaf.symbol);
        if field && ranged.leaf.component > 0 {
            continue;
        }
        let name = if field { graph.name(ranged.leaf.symbol).to_owned() } else { graph.leaf_latex(ranged.leaf) };
        let formula = ranged.formula.clone();
        let values = match ranged.values {
            Values::Between(..) => {
                let of = variables.iter().find(|v| v.leaf == ranged.leaf);
                of.map(|v| v.shown)
            }
            Values::One(_) if field => None,
            Values::One(_) => {
                put.value(ranged.leaf).and_then(|e| Some(nearest(graph, e, enclosed(graph, e)?))).map(|x| (x, x))
            }
        };
        ranges.push((
            matches!(ranged.values, Values::One(_)),
            RangeAccount { name, unit: ranged.unit.clone(), values, formula },
        ));
    }
    ranges.sort_by_key(|(single, _)| *single);
    RegionAccount { varying: variables.len(), ranges: ranges.into_iter().map(|(_, r)| r).collect(), ..empty(region) }
}

/// Volumes, numbers, and the picture.
pub fn measure(account: &mut RegionAccount, division: &Division) {
    for piece in &division.pieces {
        let volume = piece.volume();
        match piece.part {
            Part::Proved | Part::Border => account.shares.proved += volume,
            Part::Refuted => account.shares.refuted += volume,
            Part::NotApplicable => account.shares.not_applicable += volume,
            Part::Undecided => {
                account.shares.undecided += volume;
                account.depth = account.depth.max(piece.bisections());
            }
        }
    }
    account.cells = division.judged;
    if division.exhausted {
        account.remarks.push("work limit: the ranges were not taken apart any further".to_owned());
    }
    account.map = draw(division);
}

/// The coordinates of a point.
pub fn point(account: &RegionAccount, cell: &Cell) -> Vec<(String, f64)> {
    let of = account.ranges.iter().zip(cell.sides.iter().zip(&cell.at_end));
    let at = |(range, (side, end)): (&RangeAccount, (&Interval, &Option<bool>))| {
        // At an end it is the number of the file, of which only an enclosure is binary64.
        let shown = range.values.zip(*end).map(|((from, to), upper)| if upper { to } else { from });
        (range.name.clone(), shown.unwrap_or(side.mid()))
    };
    of.map(at).collect()
}

/// What the identity test said of equations.
pub fn identities(account: &mut RegionAccount, question: &Question) {
    // Of a formula with components that are no identities nothing is said of those that are.
    let whole = |text: &String| !question.equations.contains(text);
    for (text, bound, given) in question.identities.iter().filter(|(text, ..)| whole(text)) {
        if *given {
            account.identities.push((text.clone(), *bound));
            account.remarks.push(format!(
                "${text}$ follows from what is assumed and from the signs of the ranges, by random evaluation with an error \
                 probability of at most 2^{}",
                bound.ceil()
            ));
            continue;
        }
        if *bound <= Proof::CERTAIN {
            account.remarks.push(format!("${text}$ is an identity between algebraic numbers, compared exactly"));
            continue;
        }
        // Of several components the weakest bound.
        let same = question.identities.iter().filter(|(other, ..)| other == text).map(|(_, bound, _)| *bound);
        let bound = same.fold(*bound, f64::max);
        account.identities.push((text.clone(), bound));
        account.remarks.push(format!(
            "${text}$ is an identity, by random evaluation with an error probability of at most 2^{}",
            bound.ceil()
        ));
    }
    // Where a point refutes the claim, nobody asks whether it is an identity.
    let open = account.shares.undecided > 0.0 && account.witness.is_none();
    for text in question.equations.iter().filter(|_| open) {
        account.remarks.push(format!(
            "${text}$ was not shown to be an identity; intervals refute an equation, but prove it only where both sides \
             are one number"
        ));
    }
    account.identities.dedup();
    account.remarks.dedup();
}

/// The verdict.
pub fn conclude(account: &mut RegionAccount, division: &Division, strength: Strength) {
    let has = |part: Part| division.pieces.iter().any(|p| p.part == part);
    let all_decided = !has(Part::Undecided);
    let known = if account.witness.is_some() {
        Possible::FALSE
    } else if division.pieces.iter().all(|p| p.part == Part::NotApplicable) && !division.met {
        Possible::VOID
    } else if all_decided && !has(Part::Refuted) && division.met {
        Possible::TRUE
    } else {
        Possible::ANY
    };
    let strength = if known == Possible::TRUE { strength } else { Strength::Enclosed };
    let reason = sentence(account, known, division);
    let point = account.witness.as_ref().map(|w| w.values.as_slice());
    account.verdict = Verdict::over_ranges(known, strength, division.judged, point, reason);
}

fn sentence(account: &RegionAccount, known: Possible, division: &Division) -> String {
    let mut out = match known.decided() {
        Some(Truth::True) if account.varying == 0 => "at the one point that is asked for".to_owned(),
        Some(Truth::True)
            if account.shares.not_applicable > 0.0 || division.pieces.iter().any(|p| p.part == Part::Border) =>
        {
            "at every point at which it applies".to_owned()
        }
        Some(Truth::True) => "at every point of the ranges".to_owned(),
        Some(Truth::Void) => {
            "at no point of the ranges do its assumptions hold and its formulas have values".to_owned()
        }
        Some(Truth::False) => match &account.witness {
            Some(w) => w.sentence(),
            None => "a part of the ranges is refuted".to_owned(),
        },
        None if account.shares.undecided == 0.0 && !division.met => {
            "no point was found at which its assumptions certainly hold".to_owned()
        }
        None if account.varying == 0 => "at the one point that is asked for".to_owned(),
        None => "it is not decided everywhere".to_owned(),
    };
    if account.varying > 0 {
        let Shares { proved, refuted, not_applicable, undecided } = account.shares;
        let parts = [
            (proved, "proved"),
            (refuted, "refuted"),
            (not_applicable, "outside of what it applies to"),
            (undecided, "undecided"),
        ];
        let there = parts.iter().filter(|(share, _)| *share > 0.0);
        let whole = there.clone().count() == 1;
        let said: Vec<String> = there.map(|(share, word)| format!("{} {word}", percent(*share, whole))).collect();
        let cells = if account.cells == 1 { "1 cell".to_owned() } else { format!("{} cells", account.cells) };
        out = format!("{out}: {}, by {cells}", said.join(", "));
    }
    out
}

/// A point in words, with its names between dollars: `left 1, right 0 at u = 1; v = 2 — and left 2, right 0 at u = 2`.
fn marked(point: &str) -> String {
    let one = |part: &str| match part.split_once(" = ") {
        None => part.to_owned(),
        Some((head, value)) => {
            let (before, name) = head.split_at(head.rfind(" at ").map_or(0, |at| at + " at ".len()));
            format!("{before}${name}$ = {value}")
        }
    };
    let half = |half: &str| half.split("; ").map(one).collect::<Vec<_>>().join("; ");
    point.split(" — and ").map(half).collect::<Vec<_>>().join(" — and ")
}

/// For which fields something is proved.
fn for_all(claim: &Claim, step: &IdentityAccount) -> String {
    let given = (!step.from.is_empty()).then_some("what it follows from");
    let assumed = (!claim.assuming.is_empty()).then_some("what it assumes");
    let both: Vec<&str> = given.into_iter().chain(assumed).collect();
    match both.is_empty() {
        true => "for all fields".to_owned(),
        false => format!("for all fields that satisfy {}", both.join(" and ")),
    }
}

/// A formula that fails: its sides differ as they must not, or it has no value.
pub fn of_formula(
    values: Vec<(String, f64)>,
    formula: String,
    sides: Option<((f64, f64), (f64, f64))>,
) -> RegionWitness {
    let middle = |(lo, hi): (f64, f64)| if lo == hi { lo } else { 0.5 * lo + 0.5 * hi };
    let says = match sides {
        Some((left, right)) => format!("${formula}$ has the sides {} and {}", middle(left), middle(right)),
        None => format!("${formula}$ has no value"),
    };
    RegionWitness { values, formula: Some(formula), sides, says }
}

/// The account of a claim over ranges.
pub fn of_region(claim: &Claim, region: RegionAccount) -> ClaimAccount {
    ClaimAccount { region: Some(region), ..ClaimAccount::of(claim, Vec::new()) }
}
