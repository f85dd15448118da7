//! Which variants a motion rejects.
//!
//! **In:** the variants of a claim, and the points at which the claim was tried on a motion. **Out:** for each variant, whether
//! it would not hold there.
//!
//! A variant is judged as the print is: violated where its residual is beyond the guarded error bound. At most
//! [`MOST_TIMES`] of the tried times are used, spread evenly. Most variants fall at the first of them, and only those that
//! are left go on. So what is reported as not rejected is so at these times; what is reported as rejected is rejected.

use super::battery::{Battery, LANES, Memory, Outputs};
use super::generate::ClaimVariants;
use crate::expr::Leaf;
use crate::flow::Sample;
use crate::number::NoValue;
use crate::verdict::Possible;
use claim::comparison::judge;

/// Most times of a motion at which a variant is tried.
pub(super) const MOST_TIMES: usize = 64;
/// How many times are used in each round.
const ROUNDS: [usize; 3] = [2, 12, MOST_TIMES - 14];

/// The battery of a claim for one initial time, with the places of its inputs.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    battery: Battery,
    /// Positions among the leaves of a point; none for the sign of ±.
    inputs: Vec<Option<usize>>,
}

impl Placed {
    /// Finds the inputs of a battery among the leaves of points, which are sorted.
    pub fn new(battery: Battery, known: &[Leaf]) -> Placed {
        let inputs = battery.leaves().iter().map(|l| known.binary_search(l).ok()).collect();
        Placed { battery, inputs }
    }

    /// Whether a formula has a value at a point, in all of its parts.
    pub fn has_values(&self, point: Sample, formula: usize, parts: usize) -> bool {
        let outputs = self.at(point, 1.0, &mut self.battery.slots());
        (0..parts).all(|part| outputs.own(formula, part).is_ok())
    }

    fn at(&self, point: Sample, sign: f64, slots: &mut expr::tape::Slots<number::Bounded>) -> Outputs<'_> {
        let value = |i: &Option<usize>| i.map_or(Err(NoValue::Indeterminate), |i| point.get(i));
        self.battery.at(self.inputs.iter().map(value), sign, slots)
    }

    /// The outputs at several points, for both signs of ± where it occurs.
    fn both(&self, points: &[Sample], memory: &mut Memory) -> (Vec<Outputs<'_>>, Option<Vec<Outputs<'_>>>) {
        let plus = self.at_each(points, 1.0, memory);
        (plus, self.battery.has_sign().then(|| self.at_each(points, -1.0, memory)))
    }

    /// The outputs at several points: all at once where that pays.
    fn at_each(&self, points: &[Sample], sign: f64, memory: &mut Memory) -> Vec<Outputs<'_>> {
        if points.len() < LANES {
            let slots = self.battery.prepare(memory);
            return points.iter().map(|point| self.at(*point, sign, slots)).collect();
        }
        let value = |i: usize, p: usize| self.inputs[i].map_or(Err(NoValue::Indeterminate), |i| points[p].get(i));
        self.battery.at_each(points.len(), value, sign, memory)
    }
}

/// What is found out about one variant on one motion.
#[derive(Clone, Copy, Debug, Default)]
struct Record {
    /// Times at which the print had a value.
    tried: usize,
    /// Times at which the variant had one, too, or it could not be told.
    valued: usize,
    /// Whether it was violated with each sign of ±, at any time.
    violated: [bool; 2],
    /// Whether it was violated with both signs at one time.
    both: bool,
}

/// Where and how a claim was tried.
pub(super) struct Evidence<'a> {
    /// The points: those at which the claim was compared.
    pub points: &'a [Sample<'a>],
    /// Whether the first of the points must be used: it is the witness.
    pub first_counts: bool,
    /// The precision that the claim asks for.
    pub precision: f64,
    /// Whether one sign of ± must serve the whole motion.
    pub one_sign_throughout: bool,
}

/// At most `most` of the positions 0 … n − 1, in an order in which every beginning is spread over the whole.
pub(super) fn spread(n: usize, most: usize) -> Vec<usize> {
    let mut seen = vec![false; n];
    let wanted = most.min(n);
    let mut out = Vec::with_capacity(wanted);
    // Not from the start: many things vanish there.
    let mut at = 0.5;
    // The golden section fills the interval evenly; what it leaves out comes last, in order.
    for _ in 0..2 * n {
        if out.len() == wanted {
            return out;
        }
        let i = ((at * n as f64) as usize).min(n.saturating_sub(1));
        if !std::mem::replace(&mut seen[i], true) {
            out.push(i);
        }
        at += 0.618_033_988_749_894_9;
        at -= if at >= 1.0 { 1.0 } else { 0.0 };
    }
    out.extend((0..n).filter(|&i| !seen[i]).take(wanted - out.len()));
    out
}

/// What a motion says of the formulas of a claim and of their variants.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rejections {
    /// For each variant, whether it is rejected.
    pub variants: Vec<bool>,
    /// For each formula, whether it is violated as printed, at one of the times used.
    pub formulas: Vec<bool>,
}

/// Which of the variants are rejected. The first of the points are used in any case.
pub(super) fn rejected(claim: &ClaimVariants, whole: &Placed, evidence: &Evidence, memory: &mut Memory) -> Rejections {
    let mut formulas = vec![false; claim.formulas.len()];
    let mut records = vec![Record::default(); claim.variants.len()];
    let mut order = spread(evidence.points.len(), MOST_TIMES);
    // Where the print fails most clearly comes first.
    if evidence.first_counts {
        match order.iter().position(|&i| i == 0) {
            Some(at) => order[..=at].rotate_right(1),
            None => {
                order.rotate_right(1);
                order.first_mut().into_iter().for_each(|first| *first = 0);
            }
        }
    }
    let mut next = order.iter();
    let mut smaller: Option<Placed> = None;
    for round in ROUNDS {
        let placed = smaller.as_ref().unwrap_or(whole);
        let points: Vec<Sample> = next.by_ref().take(round).map(|&i| evidence.points[i]).collect();
        if points.is_empty() {
            break;
        }
        let (plus, minus) = placed.both(&points, memory);
        try_at(claim, placed, (&plus, minus.as_deref()), evidence, &mut records, &mut formulas);
        let left = |v: usize| !records[v].is_rejected(evidence);
        let count = placed.battery.chosen.iter().filter(|v| left(**v)).count();
        if count == 0 {
            break;
        }
        // A smaller tape pays when it is much smaller.
        if count * 3 < placed.battery.chosen.len() * 2 {
            smaller = Some(Placed { battery: placed.battery.part(claim, left), inputs: placed.inputs.clone() });
        }
    }
    let variants = records.iter().map(|r| r.is_rejected(evidence) || r.has_no_value()).collect();
    Rejections { variants, formulas }
}

impl Record {
    fn is_rejected(&self, evidence: &Evidence) -> bool {
        if evidence.one_sign_throughout { self.violated == [true; 2] } else { self.both }
    }
    fn has_no_value(&self) -> bool {
        self.tried > 0 && self.valued == 0
    }
}

fn try_at(
    claim: &ClaimVariants,
    placed: &Placed,
    (plus, minus): (&[Outputs], Option<&[Outputs]>),
    evidence: &Evidence,
    records: &mut [Record],
    formulas: &mut [bool],
) {
    let battery = &placed.battery;
    let stand = |o: &Outputs, f: usize, p: usize, difference| match difference {
        Ok(d) => judge(claim.formulas[f].parts[p].kind, d, o.size(f, p), evidence.precision),
        Err(NoValue::OutOfDomain) => Possible::VOID,
        Err(_) => Possible::OPEN,
    };
    // How the parts of each formula stand as printed, for each sign: those of one formula one after the other.
    let mut printed: Vec<[Possible; 2]> = Vec::new();
    let starts: Vec<usize> = claim
        .formulas
        .iter()
        .scan(0, |sum, formula| Some(std::mem::replace(sum, *sum + formula.parts.len())))
        .collect();
    let of = |f: usize| starts[f]..starts[f] + claim.formulas[f].parts.len();
    let mut speaks = vec![false; claim.formulas.len()];
    for (at, plus) in plus.iter().enumerate() {
        let minus = minus.and_then(|all| all.get(at));
        printed.clear();
        for (f, formula) in claim.formulas.iter().enumerate() {
            printed.extend((0..formula.parts.len()).map(|p| {
                let first = stand(plus, f, p, plus.own(f, p));
                [first, minus.map_or(first, |m| stand(m, f, p, m.own(f, p)))]
            }));
            let signs = |what: &dyn Fn(usize) -> bool| [what(0), what(1)];
            let violated = signs(&|s| printed[of(f)].iter().any(|p| p[s] == Possible::FALSE));
            formulas[f] |= violated == [true; 2];
            let valued = signs(&|s| printed[of(f)].iter().all(|p| p[s] != Possible::VOID));
            speaks[f] = valued.contains(&true);
        }
        for (position, &v) in battery.chosen.iter().enumerate() {
            let variant = &claim.variants[v];
            let f = variant.formula;
            let record = &mut records[v];
            // What is rejected stays so.
            if !speaks[f] || record.is_rejected(evidence) {
                continue;
            }
            record.tried += 1;
            let one = |s: usize, outputs: &Outputs| {
                let mut standing = Possible::TRUE;
                if claim.formulas[f].branching {
                    // With this sign the unaltered parts must be true, too.
                    for (p, own) in printed[of(f)].iter().enumerate() {
                        if variant.altered.iter().all(|(a, _)| *a != p) {
                            standing = standing.and(own[s]);
                        }
                    }
                }
                for (n, (p, _)) in variant.altered.iter().enumerate() {
                    standing = standing.and(stand(outputs, f, *p, outputs.altered(position, n)));
                }
                standing
            };
            let first = one(0, plus);
            let standings = [first, minus.map_or(first, |minus| one(1, minus))];
            let violated = standings.map(|s| s == Possible::FALSE);
            // Where one sign gives no value at all, the other decides.
            record.valued += usize::from(standings.iter().any(|s| *s != Possible::VOID));
            record.both |= violated == [true; 2];
            for (all, now) in record.violated.iter_mut().zip(violated) {
                *all |= now;
            }
        }
    }
}
