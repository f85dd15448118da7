//! Claims over ranges of values: decided for all points of a box, without a motion.
//!
//! **In:** a claim with `ranges`. **Out:** [`RegionAccount`]: a verdict, the parts of the box that are proved, refuted, outside
//! the claim's assumptions and undecided, a point at which it fails, and a picture of two ranges.
//!
//! **Guaranteed.** `holds` (*enclosed*) means: at every point of the closed box at which the claim applies, it holds, with
//! every rounding accounted for, and there is a point at which it applies. `fails` (*certified*) means: at the point that is
//! named, which lies in the box, the assumptions hold, the formulas have values, and the claim is false. Nothing holds by a
//! tolerance: a range of values that contains 0 and other numbers says nothing of an equation. An equation holds where its two
//! sides are the same number for interval arithmetic, or are an identity for the [random test](proof); if all that
//! is said is of that kind, the verdict is *proved*, with the test's probability of error.
//!
//! **How.** The box is bisected, breadth first, until every cell is decided or the work is done that was allowed
//! (`subdivide`); a cell is decided by intervals (`signs`), the claim on it by what it says (`question`), that solutions exist
//! by Krawczyk's operator (`solutions`). The numbers of the file are enclosed, not rounded: a range that ends at 0.1 is taken
//! to the next binary64 number outwards, and witnesses are looked for inwards.

#![forbid(unsafe_code)]

use ::{derivation, diag, expr, findings, latex, number, verdict};

mod account;
mod ends;
mod faults;
mod map;
mod portrait;
mod question;
mod signs;
mod solutions;
mod subdivide;
#[cfg(test)]
mod tests;

use crate::findings::region::{Part, RangeAccount, RegionAccount};
pub use account::of_step;

use crate::derivation::{Claim, Derivation, Form, Ranged, Region, Values};
use crate::diag::Diagnostic;
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf, Node, Rational};
use crate::findings::ClaimAccount;
use crate::latex::RelationKind;
use crate::number::{Bounded, Draws, Interval};
use crate::verdict::{Finding, Strength, Verdict};
use ends::{enclosed, nearest};
use meter::{Limits, Task};
use portrait::portraits;
use question::{Insertion, Question};
use reason::Reason;
use signs::{Cell, Scratch, Variable};
use solutions::Solver;
use subdivide::{Division, Judge, MOST_CELLS, subdivide};

impl Judge for Question {
    type Scratch = Scratch;
    const TOGETHER: usize = 16;

    fn judge(&self, cell: &Cell, scratch: &mut Scratch) -> Part {
        Question::judge(self, cell, scratch)
    }

    fn divides(&self, _: usize) -> Vec<bool> {
        self.signs.named()
    }
}

/// An operation on intervals is so many units of counted work.
const UNITS: u64 = 6;

/// The counted work after which the ranges of a claim that is only a proposal are taken apart no further.
const MOST_WORK_OF_ONE: u64 = 300_000_000;

/// The same for any claim, and for all claims of a file together: what is left of the work of the file is for its motions.
fn most_work(limits: &Limits, claims: usize) -> u64 {
    let of_one = limits.work.of(Task::Ranges.units()) / 5 * 2;
    of_one.min(limits.total.left() / 5 * 4 / claims.max(1) as u64)
}

/// Points at which variants of a claim are tried, and most that are drawn for them.
const MOST_POINTS: usize = 48;
const MOST_DRAWN: usize = 400;

/// The accounts of the claims over ranges among those that are asked for, by their positions in the file. Each is a piece of the work.
///
/// # Errors
/// A diagnostic for every range whose ends are in the wrong order, or not numbers.
pub fn decide_all(
    derivation: &Derivation,
    asked: impl Fn(&Claim) -> bool,
    limits: &Limits,
) -> Result<Vec<(usize, ClaimAccount)>, Vec<Diagnostic>> {
    let asked: Vec<(usize, &Claim, &Region)> = derivation
        .claims
        .iter()
        .enumerate()
        .filter(|(_, claim)| claim.is_over_ranges())
        .filter_map(|(at, claim)| Some((at, claim, claim.region.as_ref()?)))
        .filter(|(_, claim, _)| asked(claim))
        .collect();
    let most_work = most_work(limits, asked.len());
    let decided = meter::each(limits, &asked, |&(at, claim, region), limits| {
        let account = meter::piece(Task::Ranges, limits, || decide(derivation, claim, region, most_work))
            .unwrap_or_else(|ended| Ok(account::ended(region, ended)))?;
        Ok::<_, Box<Diagnostic>>((at, account::of_region(claim, account)))
    });
    let (mut out, mut problems) = (Vec::new(), Vec::new());
    for one in decided {
        match one {
            Ok(account) => out.push(account),
            Err(problem) => problems.push(*problem),
        }
    }
    if problems.is_empty() { Ok(out) } else { Err(problems) }
}

/// One claim by itself; `None` where a range is none.
pub fn decide_one(derivation: &Derivation, claim: &Claim, region: &Region) -> Option<RegionAccount> {
    decide(derivation, claim, region, MOST_WORK_OF_ONE).ok()
}

/// The ranges that are no single values, enclosed from outside and inside.
fn variables(derivation: &Derivation, graph: &Graph, ranges: &[Ranged]) -> Result<Vec<Variable>, Box<Diagnostic>> {
    let mut out = Vec::new();
    for ranged in ranges {
        let Values::Between(from, to) = ranged.values else { continue };
        let problem = |message: &str| {
            Diagnostic::at(&derivation.file, "check::bad-range", ranged.span.clone(), message.to_owned())
        };
        let (Some(low), Some(high)) = (enclosed(graph, from), enclosed(graph, to)) else {
            return Err(Box::new(problem("an end of this range has no value")));
        };
        let Some(inner) = Interval::new(low.hi(), high.lo()).ok().filter(|inner| !inner.is_point()) else {
            let message = "the ends of this range are in the wrong order, or too close to tell";
            return Err(Box::new(problem(message).hint("the smaller one comes first: [from, to]")));
        };
        let shown = (nearest(graph, from, low), nearest(graph, to, high));
        out.push(Variable { leaf: ranged.leaf, outer: low.hull(high), inner, ends: (from, to), shown, only: None });
    }
    Ok(out)
}

/// The account of a claim.
fn decide(
    derivation: &Derivation,
    claim: &Claim,
    region: &Region,
    most_work: u64,
) -> Result<RegionAccount, Box<Diagnostic>> {
    let mut graph = derivation.graph.clone();
    let mut variables = variables(derivation, &graph, &region.ranges)?;
    fix(&graph, claim, &mut variables);
    let put = Insertion::new(&mut graph, &claim.scope, &region.ranges);
    let mut account = account::blank(region, &graph, &put, &variables);
    if let Some(why) = claim.unread() {
        account.verdict = Verdict::of(Finding::open(Reason::quoted(why)));
        return Ok(account);
    }
    let problem = |graph: &Graph, leaf: Leaf| {
        let message = format!("`{}` has no value in the claim `{}`", graph.leaf_latex(leaf), claim.name());
        Box::new(Diagnostic::at(&derivation.file, "check::no-range", claim.span.clone(), message))
    };
    let question = Question::new(&mut graph, claim, &put, variables.clone()).map_err(|l| problem(&graph, l))?;
    let exists = claim.forms.iter().find_map(|form| match form {
        Form::Exists { unknowns, such_that, unique } => Some((unknowns, such_that, *unique)),
        _ => None,
    });
    if let Some((unknowns, such_that, unique)) = exists {
        let wanted = self::variables(derivation, &graph, unknowns)?;
        account.unique = unique;
        account.unknowns = unknowns
            .iter()
            .zip(&wanted)
            .map(|(u, v)| RangeAccount {
                name: graph.leaf_latex(u.leaf),
                unit: u.unit.clone(),
                values: Some(v.shown),
                formula: None,
            })
            .collect();
        let solver = Solver::new(&mut graph, &put, question, wanted, such_that, unique);
        let solver = solver.map_err(|l| problem(&graph, l))?;
        let division = subdivide(&solver, &variables, solver.most_cells(), most_work);
        account::measure(&mut account, &division);
        solver.describe(&division, &mut account);
        account::conclude(&mut account, &division, Strength::Enclosed);
        return Ok(account);
    }
    let division = subdivide(&question, &variables, MOST_CELLS, most_work);
    account::measure(&mut account, &division);
    witness(&graph, &question, &variables, &division, &mut account);
    account::identities(&mut account, &question);
    account.portraits = portraits(&mut graph, (claim, &region.ranges, question.identical), &put, &variables);
    account::conclude(&mut account, &division, if question.identical { Strength::Proved } else { Strength::Enclosed });
    Ok(account)
}

/// Notes the values that assumptions give single variables: `\\theta=1`. Points at which a claim applies are looked for there.
fn fix(graph: &Graph, claim: &Claim, variables: &mut [Variable]) {
    let equations = claim.assuming.iter().flat_map(|w| &w.value.relations);
    for relation in equations.filter(|r| r.kind == RelationKind::Equal && r.limit.is_none()) {
        let (&[left], &[right]) = (relation.left.components.as_slice(), relation.right.components.as_slice()) else {
            continue;
        };
        for (name, number) in [(left, right), (right, left)] {
            let Some(exact) = graph.as_constant(number) else { continue };
            let near = exact.to_f64().value();
            let representable = Rational::try_from(near).is_ok_and(|r| r == *exact);
            for v in variables.iter_mut().filter(|_| representable) {
                if *graph.node(name) == Node::Leaf(v.leaf) {
                    v.only = Some(near);
                }
            }
        }
    }
}

/// Points of the box at which a claim applies, and some expressions with everything inserted that has one value there: the
/// variables, and their values at each point. `None` where a range is none.
pub fn points(
    derivation: &Derivation,
    claim: &Claim,
    region: &Region,
    graph: &mut Graph,
    expressions: &mut [&mut Expr],
) -> Option<(Vec<Leaf>, Vec<claim::program::Values>)> {
    let variables = variables(derivation, graph, &region.ranges).ok()?;
    let leaves: Vec<Leaf> = variables.iter().map(|v| v.leaf).collect();
    let put = Insertion::new(graph, &claim.scope, &region.ranges);
    // What is assumed, by itself.
    let assumed = Claim { forms: Vec::new(), ..claim.clone() };
    let question = match claim.assuming.is_empty() {
        true => None,
        false => Some(Question::new(graph, &assumed, &put, variables.clone()).ok()?),
    };
    for e in expressions.iter_mut() {
        **e = put.put(graph, **e, &leaves);
    }
    let mut draws = Draws::new(crate::findings::SEED);
    let (mut out, mut scratch) = (Vec::new(), Scratch::default());
    for _ in 0..MOST_DRAWN {
        let at = variables.iter().map(|v| {
            let share = (draws.bits() >> 11) as f64 / (1u64 << 53) as f64;
            (v.inner.lo() + share * (v.inner.hi() - v.inner.lo())).clamp(v.inner.lo(), v.inner.hi())
        });
        let at: Vec<f64> = at.collect();
        let sides: Option<Vec<Interval>> = at.iter().map(|&x| Interval::new(x, x).ok()).collect();
        let cell = Cell::inside(sides?);
        if question.as_ref().is_none_or(|q| q.applies_now(&cell, &mut scratch) == signs::Truth::True) {
            out.push(at.into_iter().map(|x| Ok(Bounded::exact(x))).collect());
        }
        if out.len() == MOST_POINTS || variables.is_empty() {
            break;
        }
    }
    Some((leaves, out))
}

/// The point at which the claim fails, with the sides of the formula that does.
fn witness(graph: &Graph, question: &Question, of: &[Variable], division: &Division, account: &mut RegionAccount) {
    let Some(cell) = &division.refuted_at else { return };
    let mut scratch = Scratch::default();
    let Some(failing) = question.failing(cell, &mut scratch) else { return };
    let leaves: Vec<Leaf> = of.iter().map(|v| v.leaf).collect();
    let sides = failing.sides.and_then(|(left, right)| {
        let tape = Tape::compile(graph, &leaves, &[left, right]).ok()?;
        let mut slots = tape.slots::<Interval>(&());
        let inputs: Vec<_> = cell.sides.iter().map(|s| Ok(*s)).collect();
        let values: Vec<Interval> =
            tape.evaluate(&(), &inputs, &mut slots).into_iter().collect::<Result<_, _>>().ok()?;
        let end = |v: &Interval| (v.lo(), v.hi());
        Some((end(values.first()?), end(values.get(1)?)))
    });
    account.witness =
        Some(account::of_formula(account::point(account, cell), (failing.formula, failing.component), sides));
}
