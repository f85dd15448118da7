//! Verdicts over ranges, and what becomes of them when a part of the method is broken on purpose.

use super::faults::{NO_DOMAIN, NO_INCLUSION, TOO_FLAT, WEAK};
use super::question::{Insertion, Question};
use super::signs::{Cell, Scratch};
use super::subdivide::{MOST_CELLS, subdivide};
use super::*;
use crate::derivation::parse;
use crate::diag::{Source, render};
use crate::findings::region::{Part, Shares};
use crate::number::Draws;
#[cfg(debug_assertions)]
use crate::number::interval_faults::NEAREST;
use std::cell::Cell as Switch;
use std::thread::LocalKey;
use verdict::{Outcome, Strength};

/// Counted work that no test uses up.
const MOST_WORK_OF_TESTS: u64 = 6_000_000_000;

/// A file with one claim over ranges.
fn file(claim: &str) -> String {
    let symbols: String = ["x", "y", "z"].map(|s| format!("'{s}' = {{ role = \"parameter\" }}\n")).concat();
    format!(
        "[derivation]\ntitle = \"t\"\nconcerns = \"t\"\n[symbols]\n{symbols}\n[[claim]]\nid = \"c\"\nsays = \"s\"\n{claim}\n"
    )
}

fn derivation(claim: &str) -> Derivation {
    let source = Source { path: "t.toml".into(), text: file(claim) };
    parse(source, "t").unwrap_or_else(|found| panic!("{}", render(&found, false)))
}

fn account(claim: &str) -> RegionAccount {
    let derivation = derivation(claim);
    let of = &derivation.claims[0];
    decide(&derivation, of, of.region.as_ref().expect("ranges"), MOST_WORK_OF_TESTS).expect("a verdict")
}

/// The account on this thread alone, with a part of the method broken.
fn broken(fault: &'static LocalKey<Switch<bool>>, claim: &str) -> RegionAccount {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    pool.install(|| {
        fault.set(true);
        let found = account(claim);
        fault.set(false);
        found
    })
}

fn word(account: &RegionAccount) -> &'static str {
    account.verdict.outcome().word()
}

#[test]
fn each_trap_catches_a_method_that_is_broken() {
    let pole = "ranges = { 'x' = [0, 1] }\ndefined = ['\\frac{1}{x-0.3}']";
    let strict = "ranges = { 'x' = [0, 1] }\nalways = ['x>0']";
    let jump = "ranges = { 'x' = [-2, -1], 'y' = [-0.1, 0.1] }\nalways = ['45y-\\operatorname{atan2}(y,x)<2']";
    let near = "exists = { unknowns = { 'x' = [-1, 1] }, such-that = ['x^2-0.6x+0.090000001=0'] }";
    // Beyond a jump slopes say nothing: neither is the range continuous there, nor has the slope a value.
    assert_eq!(word(&account(jump)), "fails");
    // False between 0 and 0.00001, at whose ends it is true.
    let dip = "ranges = { 'x' = [0, 1] }\nalways = ['x^3\\ge 0.0000000001x']";
    for (fault, claim) in [(&NO_DOMAIN, pole), (&WEAK, strict), (&NO_INCLUSION, near), (&TOO_FLAT, dip)] {
        assert_ne!(word(&account(claim)), "holds", "{claim}");
        assert_eq!(word(&broken(fault, claim)), "holds", "{claim}");
    }
}

#[test]
fn a_power_that_both_sides_have_in_common_is_taken_out() {
    let over = |range: &str, formula: &str| word(&account(&format!("ranges = {{ {range} }}\nalways = ['{formula}']")));
    let sine = r"\left|\sin x-x+\frac{x^3}{6}\right|\le\frac{x^5}{60}";
    assert_eq!(over("'x' = [0, 0.5]", sine), "holds");
    // x⁵/120 is the next term: nothing smaller bounds what is left.
    assert_eq!(over("'x' = [0, 0.5]", &sine.replace("60", "121")), "fails");
    assert_eq!(over("'x' = [0, 0.5]", &sine.replace("\\le\\frac", "<\\frac")), "fails");
    assert_eq!(over("'x' = [0, 0.5]", r"\sqrt{1+x}-1-\frac x2\le\frac{x^2}{4}"), "holds");
    assert_eq!(over("'x' = [-0.5, 0]", r"1+x\le e^x\le1+x+x^2"), "holds");
    assert_eq!(over("'x' = [-0.5, 0]", r"e^x-1-x\le0.4x^2"), "fails");
    // Whatever the other variable is.
    assert_eq!(over("'x' = [0, 0.5], 'y' = [1, 2]", r"y\sin x\le xy"), "holds");
    assert_eq!(over("'x' = [0, 0.5], 'y' = [-1, 2]", r"y\sin x\le xy"), "fails");
}

#[test]
fn rounding_is_accounted_for() {
    // 0.1·3 rounded to nearest is not 0.3, and the sum of the terms is not what is written.
    let claim = "ranges = { 'x' = 0.1, 'y' = [1, 2] }\nalways = ['(3x-0.3)y=0']";
    assert_eq!(word(&account(claim)), "holds");
    // √2 rounded to nearest is too large.
    let root = "ranges = { 'x' = [2, 3] }\nalways = ['\\left(\\sqrt{2}\\right)^2>2']";
    assert_eq!(word(&account(root)), "undecided");
    #[cfg(debug_assertions)]
    assert_eq!(word(&broken(&NEAREST, root)), "holds");
}

#[test]
fn a_witness_lies_in_the_ranges_and_can_be_checked() {
    let found = account("ranges = { 'x' = [0.1, 0.7], 'y' = [0.1, 0.3] }\nalways = ['x+y<1']");
    let witness = found.witness.expect("a witness");
    assert_eq!(witness.values, [("x".to_owned(), 0.7), ("y".to_owned(), 0.3)]);
    let ((a, b), (c, d)) = witness.sides.expect("sides");
    assert!(a <= 1.0 && 1.0 <= b && c <= 1.0 && 1.0 <= d);
}

#[test]
fn the_parts_add_up_and_the_work_is_bounded() {
    for claim in [
        "ranges = { 'x' = [-1, 1], 'y' = [-1, 1] }\nalways = ['x^2+y^2<0.7']",
        "ranges = { 'x' = [-1, 1], 'y' = [-1, 1], 'z' = [0, 1] }\ndefined = ['\\sqrt{x^2+y^2-z}']",
        "ranges = { 'x' = [0, 2] }\nalways = ['\\sqrt{x^2}=x']",
    ] {
        let found = account(claim);
        let Shares { proved, refuted, not_applicable, undecided } = found.shares;
        assert!((proved + refuted + not_applicable + undecided - 1.0).abs() < 1e-12, "{:?}", found.shares);
        assert!(found.cells <= MOST_CELLS, "{}", found.cells);
        assert_eq!(found, account(claim), "the same input, the same account");
    }
}

#[test]
fn the_shares_of_a_disc_are_its_area() {
    let found = account("ranges = { 'x' = [-1, 1], 'y' = [-1, 1] }\nalways = ['x^2+y^2<0.7']");
    let area = std::f64::consts::PI * 0.7 / 4.0;
    let Shares { proved, refuted, undecided, .. } = found.shares;
    assert!(proved <= area && area <= proved + undecided && undecided < 0.01, "{:?}", found.shares);
    assert!(refuted <= 1.0 - area);
    let map = found.map.expect("a picture");
    let covered: u32 = map.patches.iter().map(|p| p.width * p.height).sum();
    assert_eq!(covered, map.squares * map.squares);
    assert!(map.patches.len() < 400, "{}", map.patches.len());
}

#[test]
fn cells_are_divided_along_what_a_claim_names() {
    let own = account("ranges = { 'x' = [-2, 2], 'y' = [-2, 2] }\nalways = ['x^2+y^2-xy>-0.01']");
    let more = account("ranges = { 'z' = [0, 1], 'x' = [-2, 2], 'y' = [-2, 2] }\nalways = ['x^2+y^2-xy>-0.01']");
    assert_eq!(own.verdict.outcome(), Outcome::Holds(Strength::Enclosed));
    assert_eq!((more.verdict.outcome(), more.cells), (own.verdict.outcome(), own.cells));
}

/// What is said of a cell is so at random points of it, and what is said of a part of a cell agrees with what is said of the
/// cell.
#[test]
fn cells_are_what_their_points_are() {
    let claims = [
        "ranges = { 'x' = [-2, 2], 'y' = [-2, 2] }\nalways = ['\\sqrt{x}\\,y<\\ln(x+y)']",
        "ranges = { 'x' = [-2, 2], 'y' = [-2, 2] }\nalways = ['\\frac{x}{y}\\ge\\tan(xy)']",
        "ranges = { 'x' = [-2, 2], 'y' = [-2, 2] }\nassuming = ['x^2+y^2\\ge 1']\nalways = ['\\operatorname{atan2}(y,x)<\\arcsin\\frac{x}{2}+\\frac12']",
        "ranges = { 'x' = [-2, 2], 'y' = [-2, 2] }\ndefined = ['\\sqrt{\\frac{x-y}{x+y}}']",
        "ranges = { 'x' = [-2, 2], 'y' = [-2, 2], 'z' = [0, 1] }\nassuming = ['x\\ne y']\nalways = ['\\pm\\sqrt{x}<e^{z}y', '\\left|x-y\\right|>z/4']",
    ];
    let mut draws = Draws::new(3);
    let mut decided = [0usize; 3];
    for text in claims {
        let derivation = derivation(text);
        let claim = &derivation.claims[0];
        let region = claim.region.as_ref().expect("ranges");
        let mut graph = derivation.graph.clone();
        let all = variables(&derivation, &graph, &region.ranges).expect("ranges");
        let put = Insertion::new(&mut graph, &claim.scope, &region.ranges);
        let question = Question::new(&mut graph, claim, &put, all.clone()).expect("a question");
        let division = subdivide(&question, &all, 4_000, MOST_WORK_OF_TESTS);
        let mut scratch = Scratch::default();
        for piece in &division.pieces {
            for _ in 0..3 {
                let point = piece.sides.iter().map(|side| {
                    let share = (draws.bits() >> 11) as f64 / (1u64 << 53) as f64;
                    Interval::point((side.lo() + share * (side.hi() - side.lo())).clamp(side.lo(), side.hi()))
                });
                let at = question.judge(&Cell::inside(point.collect()), &mut scratch);
                let agree = match piece.part {
                    Part::Proved => at == Part::Proved || at == Part::Undecided,
                    Part::Refuted => at == Part::Refuted || at == Part::Undecided,
                    Part::NotApplicable => at == Part::NotApplicable || at == Part::Undecided || at == Part::Border,
                    Part::Border => at != Part::Refuted,
                    Part::Undecided => true,
                };
                assert!(agree, "{text}: {:?} on {:?}, {at:?} at a point of it", piece.part, piece.sides);
                match piece.part {
                    Part::Proved => decided[0] += 1,
                    Part::Refuted => decided[1] += 1,
                    Part::NotApplicable => decided[2] += 1,
                    _ => {}
                }
            }
        }
    }
    assert!(decided.iter().all(|n| *n > 500), "{decided:?}");
}

#[test]
fn enclosures_of_solutions_contain_them() {
    let found = account("exists = { unknowns = { 'x' = [0, 3], 'y' = [0, 3] }, such-that = ['x^2+y^2=4, xy=1'] }");
    assert_eq!(found.verdict.outcome(), Outcome::Holds(Strength::Enclosed));
    assert_eq!(found.solutions.len(), 2);
    // x² and y² are 2 ± √3.
    let (small, large) = ((2.0 - 3f64.sqrt()).sqrt(), (2.0 + 3f64.sqrt()).sqrt());
    for (solution, expected) in found.solutions.iter().zip([[small, large], [large, small]]) {
        for ((name, lo, hi), x) in solution.values.iter().zip(expected) {
            assert!(*lo - 1e-15 <= x && x <= *hi + 1e-15 && hi - lo < 1e-14, "{name}: {x} in [{lo}, {hi}]");
        }
    }
}

#[test]
fn a_range_in_the_wrong_order_is_a_problem() {
    let derivation = derivation("ranges = { 'x' = ['\\pi', 3] }\nalways = ['x>0']");
    let claim = &derivation.claims[0];
    let problem =
        decide(&derivation, claim, claim.region.as_ref().expect("ranges"), MOST_WORK_OF_TESTS).expect_err("a problem");
    assert_eq!(problem.code, "check::bad-range");
}
