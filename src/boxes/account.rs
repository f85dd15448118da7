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
use meter::Ended;
use proof::Proof;
use reason::{Plain, Ranges, Reason};
use std::sync::Arc;

/// The account of a claim about fields, by what was decided of it as a step: over all of them, not over ranges.
pub fn of_step(claim: &Claim, region: &Region, step: Option<&IdentityAccount>) -> RegionAccount {
    let (known, reason): (Possible, Reason) = match step {
        None => (Possible::ANY, Plain::NoEquation.into()),
        Some(step) => match (step.finding.decision(), &step.witness) {
            // What is given may assume more than this does, or say less.
            _ if step.finding.is_whole() && !step.presupposed.is_empty() => {
                (Possible::ANY, Ranges::Presupposes(step.presupposed.clone()).into())
            }
            _ if step.is_shown() && step.holds_on_motions() => {
                let (given, assumed) = (!step.from.is_empty(), !claim.assuming.is_empty());
                (Possible::TRUE, Ranges::AllFields { given, assumed }.into())
            }
            (Decision::Refuted, Some(point)) => (Possible::FALSE, Ranges::Contradicted(Arc::new(point.clone())).into()),
            _ => (Possible::ANY, Arc::new(step.decided()).into()),
        },
    };
    if let Some(why) = claim.unread() {
        return RegionAccount { verdict: Verdict::of(Finding::open(Reason::quoted(why))), ..empty(region) };
    }
    let strength = if known == Possible::TRUE { Strength::Proved } else { Strength::Enclosed };
    RegionAccount { verdict: Verdict::over_ranges(known, strength, 1, Some(&[]), reason), ..empty(region) }
}

/// The account of a claim whose piece of the work ended before it was done.
pub fn ended(region: &Region, by: Ended) -> RegionAccount {
    let is_defect = matches!(by, Ended::Defect(_));
    let reason: Reason = by.into();
    let mut verdict = Verdict::of(Finding::open(reason.clone()));
    if is_defect {
        verdict.contradict(reason);
    }
    RegionAccount { verdict, ..empty(region) }
}

fn empty(region: &Region) -> RegionAccount {
    RegionAccount {
        verdict: Verdict::of(Finding::open(Plain::NotLookedAt)),
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
        account.remarks.push(Plain::RangesWorkLimit.into());
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
        let formula = || text.as_str().into();
        if *given {
            account.identities.push((text.clone(), *bound));
            account.remarks.push(Ranges::Identity { formula: formula(), given: true, bound: bound.ceil() }.into());
            continue;
        }
        if *bound <= Proof::CERTAIN {
            account.remarks.push(Ranges::Algebraic(formula()).into());
            continue;
        }
        // Of several components the weakest bound.
        let same = question.identities.iter().filter(|(other, ..)| other == text).map(|(_, bound, _)| *bound);
        let bound = same.fold(*bound, f64::max);
        account.identities.push((text.clone(), bound));
        account.remarks.push(Ranges::Identity { formula: formula(), given: false, bound: bound.ceil() }.into());
    }
    // Where a point refutes the claim, nobody asks whether it is an identity.
    let open = account.shares.undecided > 0.0 && account.witness.is_none();
    for text in question.equations.iter().filter(|_| open) {
        account.remarks.push(Ranges::NoIdentity(text.as_str().into()).into());
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
    let reason = why(account, known, division);
    let point = account.witness.as_ref().map(|w| w.values.as_slice());
    account.verdict = Verdict::over_ranges(known, strength, division.judged, point, reason);
}

/// Why a claim over ranges has its verdict.
fn why(account: &RegionAccount, known: Possible, division: &Division) -> Reason {
    let Shares { proved, refuted, not_applicable, undecided } = account.shares;
    let what: Reason = match known.decided() {
        Some(Truth::False) => match account.witness.clone() {
            Some(w) => Ranges::Point { values: w.values, says: Arc::new(w.says) }.into(),
            None => Plain::PartRefuted.into(),
        },
        Some(Truth::Void) => Plain::AtNoPoint.into(),
        None if undecided == 0.0 && !division.met => Plain::NoPointForCertain.into(),
        Some(Truth::True) | None if account.varying == 0 => Plain::AtTheOnePoint.into(),
        Some(Truth::True) if not_applicable > 0.0 || division.pieces.iter().any(|p| p.part == Part::Border) => {
            Plain::WhereverItApplies.into()
        }
        Some(Truth::True) => Plain::AtEveryPoint.into(),
        None => Plain::NotEverywhere.into(),
    };
    if account.varying == 0 {
        return what;
    }
    let shares = reason::Shares { proved, refuted, not_applicable, undecided };
    Ranges::Divided { what: Arc::new(what), shares, cells: account.cells }.into()
}

/// A formula that fails: its sides differ as they must not, or it has no value.
pub fn of_formula(
    values: Vec<(String, f64)>,
    (formula, component): (String, Option<String>),
    sides: Option<((f64, f64), (f64, f64))>,
) -> RegionWitness {
    let middle = |(lo, hi): (f64, f64)| if lo == hi { lo } else { 0.5 * lo + 0.5 * hi };
    let name = formula.as_str().into();
    let says = match sides {
        Some((left, right)) => Ranges::Sides {
            formula: name,
            component: component.map(Into::into),
            left: middle(left),
            right: middle(right),
        },
        None => Ranges::NoValue(name),
    };
    RegionWitness { values, formula: Some(formula), sides, says: says.into() }
}

/// The account of a claim over ranges.
pub fn of_region(claim: &Claim, region: RegionAccount) -> ClaimAccount {
    ClaimAccount { region: Some(region), ..ClaimAccount::of(claim, Vec::new()) }
}
