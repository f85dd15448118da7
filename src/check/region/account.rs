//! What was found for a claim over ranges.

use super::super::account::{ClaimAccount, IdentityAccount};
use super::super::identity::Proof;
use super::super::standing::Decision;
use super::map::{RegionMap, draw};
use super::portrait::Portrait;
use super::question::{Insertion, Part, Question};
use super::signs::{Cell, Variable};
use super::subdivide::Division;
use super::{enclosed, nearest};
use crate::derivation::{Claim, Region, Values};
use crate::expr::Graph;
use crate::number::Interval;
use crate::verdict::{Finding, Possible, Strength, Truth, Verdict};

/// A symbol with its range or value.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeAccount {
    /// Name, in LaTeX.
    pub name: String,
    /// Unit as written.
    pub unit: Option<String>,
    /// First and last value, to the nearest binary64 number; equal for a single value. `None` for a value that depends on
    /// others.
    pub values: Option<(f64, f64)>,
    /// For a value that depends on others: its formula.
    pub formula: Option<String>,
}

/// Parts of the volume; they add up to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares {
    /// The claim holds wherever it applies.
    pub proved: f64,
    /// It fails at every point.
    pub refuted: f64,
    /// It applies nowhere.
    pub not_applicable: f64,
    /// Not known.
    pub undecided: f64,
}

/// A point at which a claim over ranges fails.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionWitness {
    /// Names and values of the ranges.
    pub values: Vec<(String, f64)>,
    /// The formula that fails, as written; `None` where the failure is not that of one formula.
    pub formula: Option<String>,
    /// What encloses its left and its right side there; `None` for a formula without a value.
    pub sides: Option<((f64, f64), (f64, f64))>,
    /// What is wrong there; formulas between dollars.
    pub says: String,
}

/// A solution: each unknown with what encloses it.
#[derive(Clone, Debug, PartialEq)]
pub struct SolutionAccount {
    /// Name, lower and upper end.
    pub values: Vec<(String, f64, f64)>,
}

/// One claim over ranges.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionAccount {
    /// The verdict.
    pub verdict: Verdict,
    /// The word that the derivation file expects, if it expects one.
    pub expected: Option<&'static str>,
    /// The ranges, in the order of the file; those that vary, then single values.
    pub ranges: Vec<RangeAccount>,
    /// How many of them vary.
    pub varying: usize,
    /// For `exists`: the unknowns, each with the range in which a solution is looked for.
    pub unknowns: Vec<RangeAccount>,
    /// For `exists`: whether there is to be one solution only.
    pub unique: bool,
    /// The parts of the box.
    pub shares: Shares,
    /// Number of cells that were judged.
    pub cells: usize,
    /// Most bisections of an undecided cell that is left; 0 where none is.
    pub depth: u32,
    /// A point at which the claim fails.
    pub witness: Option<RegionWitness>,
    /// For `exists`: the solutions that were found, if the ranges were not taken apart for them.
    pub solutions: Vec<SolutionAccount>,
    /// What else is to be known, in words.
    pub remarks: Vec<String>,
    /// The picture of the first two ranges.
    pub map: Option<RegionMap>,
    /// Pictures of its fields over them.
    pub portraits: Vec<Portrait>,
}

/// A part of the volume, in words.
fn percent(share: f64, whole: bool) -> String {
    match 100.0 * share {
        p if share > 0.0 && p < 0.1 => "less than 0.1 %".to_owned(),
        p if !whole && p > 99.9 => "more than 99.9 %".to_owned(),
        p => format!("{} %", (10.0 * p).round() / 10.0),
    }
}

impl RegionAccount {
    /// The account of a claim about fields, by what was decided of it as a step: over all of them, not over ranges.
    pub(crate) fn of_step(claim: &Claim, region: &Region, step: Option<&IdentityAccount>) -> RegionAccount {
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
        RegionAccount {
            verdict: Verdict::over_ranges(known, strength, 1, Some(&[]), reason),
            ..RegionAccount::empty(region)
        }
    }

    /// Whether this is about fields, whatever they are.
    pub fn is_of_fields(&self) -> bool {
        self.ranges.is_empty() && self.unknowns.is_empty()
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
            remarks: Vec::new(),
            map: None,
            portraits: Vec::new(),
        }
    }

    pub(super) fn blank(region: &Region, graph: &Graph, put: &Insertion, variables: &[Variable]) -> RegionAccount {
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
        RegionAccount {
            varying: variables.len(),
            ranges: ranges.into_iter().map(|(_, r)| r).collect(),
            ..RegionAccount::empty(region)
        }
    }

    /// Volumes, numbers, and the picture.
    pub(super) fn measure(&mut self, division: &Division) {
        for piece in &division.pieces {
            let volume = piece.volume();
            match piece.part {
                Part::Proved | Part::Border => self.shares.proved += volume,
                Part::Refuted => self.shares.refuted += volume,
                Part::NotApplicable => self.shares.not_applicable += volume,
                Part::Undecided => {
                    self.shares.undecided += volume;
                    self.depth = self.depth.max(piece.bisections());
                }
            }
        }
        self.cells = division.judged;
        if division.exhausted {
            self.remarks.push("work limit: the ranges were not taken apart any further".to_owned());
        }
        self.map = draw(division);
    }

    /// The coordinates of a point.
    pub(super) fn point(&self, cell: &Cell) -> Vec<(String, f64)> {
        let of = self.ranges.iter().zip(cell.sides.iter().zip(&cell.at_end));
        let at = |(range, (side, end)): (&RangeAccount, (&Interval, &Option<bool>))| {
            // At an end it is the number of the file, of which only an enclosure is binary64.
            let shown = range.values.zip(*end).map(|((from, to), upper)| if upper { to } else { from });
            (range.name.clone(), shown.unwrap_or(side.mid()))
        };
        of.map(at).collect()
    }

    /// What the identity test said of equations.
    pub(super) fn identities(&mut self, question: &Question) {
        // Of a formula with components that are no identities nothing is said of those that are.
        let whole = |text: &String| !question.equations.contains(text);
        for (text, bound, given) in question.identities.iter().filter(|(text, ..)| whole(text)) {
            if *given {
                self.remarks.push(format!(
                    "${text}$ follows from what is assumed and from the signs of the ranges, by random evaluation with an error \
                     probability of at most 2^{}",
                    bound.ceil()
                ));
                continue;
            }
            if *bound <= Proof::CERTAIN {
                self.remarks.push(format!("${text}$ is an identity between algebraic numbers, compared exactly"));
                continue;
            }
            // Of several components the weakest bound.
            let same = question.identities.iter().filter(|(other, ..)| other == text).map(|(_, bound, _)| *bound);
            let bound = same.fold(*bound, f64::max);
            self.remarks.push(format!(
                "${text}$ is an identity, by random evaluation with an error probability of at most 2^{}",
                bound.ceil()
            ));
        }
        // Where a point refutes the claim, nobody asks whether it is an identity.
        let open = self.shares.undecided > 0.0 && self.witness.is_none();
        for text in question.equations.iter().filter(|_| open) {
            self.remarks.push(format!(
                "${text}$ was not shown to be an identity; intervals refute an equation, but prove it only where both sides \
                 are one number"
            ));
        }
        self.remarks.dedup();
    }

    /// The verdict.
    pub(super) fn conclude(&mut self, division: &Division, strength: Strength) {
        let has = |part: Part| division.pieces.iter().any(|p| p.part == part);
        let all_decided = !has(Part::Undecided);
        let known = if self.witness.is_some() {
            Possible::FALSE
        } else if division.pieces.iter().all(|p| p.part == Part::NotApplicable) && !division.met {
            Possible::VOID
        } else if all_decided && !has(Part::Refuted) && division.met {
            Possible::TRUE
        } else {
            Possible::ANY
        };
        let strength = if known == Possible::TRUE { strength } else { Strength::Enclosed };
        let reason = self.sentence(known, division);
        let point = self.witness.as_ref().map(|w| w.values.as_slice());
        self.verdict = Verdict::over_ranges(known, strength, division.judged, point, reason);
    }

    fn sentence(&self, known: Possible, division: &Division) -> String {
        let mut out = match known.decided() {
            Some(Truth::True) if self.varying == 0 => "at the one point that is asked for".to_owned(),
            Some(Truth::True)
                if self.shares.not_applicable > 0.0 || division.pieces.iter().any(|p| p.part == Part::Border) =>
            {
                "at every point at which it applies".to_owned()
            }
            Some(Truth::True) => "at every point of the ranges".to_owned(),
            Some(Truth::Void) => {
                "at no point of the ranges do its assumptions hold and its formulas have values".to_owned()
            }
            Some(Truth::False) => match &self.witness {
                Some(w) => w.sentence(),
                None => "a part of the ranges is refuted".to_owned(),
            },
            None if self.shares.undecided == 0.0 && !division.met => {
                "no point was found at which its assumptions certainly hold".to_owned()
            }
            None if self.varying == 0 => "at the one point that is asked for".to_owned(),
            None => "it is not decided everywhere".to_owned(),
        };
        if self.varying > 0 {
            let Shares { proved, refuted, not_applicable, undecided } = self.shares;
            let parts = [
                (proved, "proved"),
                (refuted, "refuted"),
                (not_applicable, "outside of what it applies to"),
                (undecided, "undecided"),
            ];
            let there = parts.iter().filter(|(share, _)| *share > 0.0);
            let whole = there.clone().count() == 1;
            let said: Vec<String> = there.map(|(share, word)| format!("{} {word}", percent(*share, whole))).collect();
            let cells = if self.cells == 1 { "1 cell".to_owned() } else { format!("{} cells", self.cells) };
            out = format!("{out}: {}, by {cells}", said.join(", "));
        }
        out
    }
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

impl RegionWitness {
    /// A formula that fails: its sides differ as they must not, or it has no value.
    pub(super) fn of_formula(
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

    /// The point and what is wrong there, in a sentence; formulas between dollars.
    pub fn sentence(&self) -> String {
        let at: Vec<String> = self.values.iter().map(|(name, x)| format!("${name}={x}$")).collect();
        if at.is_empty() { self.says.clone() } else { format!("at {}: {}", at.join(", "), self.says) }
    }
}

impl ClaimAccount {
    /// The account of a claim over ranges.
    pub(super) fn of_region(claim: &Claim, region: RegionAccount) -> ClaimAccount {
        ClaimAccount { region: Some(region), ..ClaimAccount::of(claim, Vec::new()) }
    }
}
