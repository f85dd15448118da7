//! The edge of where a claim holds on a map: bisection between neighbours, on one of which it holds and on the other fails.
//!
//! **In:** the cells of a map, each with one member; the width that is asked for along each axis; and a way to try members at other
//! values. **Out:** a [`Boundary`]: for each such pair of neighbours two values, and the width between them.
//!
//! **Guaranteed:** at one end of every crossing the claim was found to hold, and at the other to fail; both are motions that were tried.
//! What lies between is one change or, where the edge is folded finer than the map, an odd number of them. Members in between
//! are no members of the family: they are counted nowhere. Crossings depend on the map alone, so they are the same wherever it
//! was counted.

use crate::findings::family::{Axis, Boundary, Crossing};
use reason::Reason;

/// How finely is looked along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Width {
    /// The two ends are at most so far apart.
    pub width: f64,
    /// Whether the row has even ratios: then its middle is the geometric one.
    pub logarithmic: bool,
}

/// What is found at some points of the map: whether it holds, nothing where that is not known; or why no more are tried.
pub(super) type Found = Result<Vec<Option<bool>>, Reason>;

/// Tries members at points of the map.
type Tried<'a, E> = &'a mut dyn FnMut(&[[f64; 2]]) -> Result<Found, E>;

/// Whether the one member of a cell holds, where it does or fails.
fn holds(cell: &[u64; 4]) -> Option<bool> {
    let [holds, fails, not_applicable, undecided] = *cell;
    let is_known = (holds > 0) != (fails > 0) && not_applicable == 0 && undecided == 0;
    is_known.then_some(holds > 0)
}

/// A value between two others, with 15 digits; `None` where there is none.
fn between((low, high): (f64, f64), logarithmic: bool) -> Option<f64> {
    let x = if logarithmic && low > 0.0 { low * (high / low).sqrt() } else { low + 0.5 * (high - low) };
    let rounded: f64 = format!("{x:.14e}").parse().ok()?;
    (low < rounded && rounded < high).then_some(rounded)
}

/// The two ends of a crossing along its axis.
fn ends(of: &mut Crossing) -> &mut (f64, f64) {
    if of.along == 0 { &mut of.across } else { &mut of.up }
}

/// The pairs of neighbours between which the verdict changes, row by row, then column by column.
fn pairs(cells: &[[u64; 4]], axes: [&Axis; 2], widths: [Option<Width>; 2]) -> Vec<Crossing> {
    let columns = axes[0].cells.len();
    let mut out = Vec::new();
    for along in [0, 1].into_iter().filter(|along| widths[*along].is_some()) {
        for (at, cell) in cells.iter().enumerate() {
            let (row, column) = (at / columns.max(1), at % columns.max(1));
            let (next_row, next_column) = if along == 0 { (row, column + 1) } else { (row + 1, column) };
            let next = (next_column < columns).then(|| cells.get(next_row * columns + next_column)).flatten();
            let Some((here, there)) = holds(cell).zip(next.and_then(holds)) else { continue };
            let value = |axis: usize, n: usize| axes[axis].cells.get(n).map_or(f64::NAN, |cell| cell.0);
            if here != there {
                out.push(Crossing {
                    along,
                    across: (value(0, column), value(0, next_column)),
                    up: (value(1, row), value(1, next_row)),
                    first_holds: here,
                    is_narrow: false,
                });
            }
        }
    }
    out
}

/// Finds the boundary on a map; `tried` tries members at points of it.
///
/// # Errors
/// What `tried` finds wrong.
pub(super) fn find<E>(
    cells: &[[u64; 4]],
    axes: [&Axis; 2],
    widths: [Option<Width>; 2],
    tried: Tried<E>,
) -> Result<Boundary, E> {
    let mut crossings = pairs(cells, axes, widths);
    let mut out = Boundary { widths: widths.map(|w| w.map(|w| w.width)), ..Boundary::default() };
    let mut open: Vec<usize> = (0..crossings.len()).collect();
    while !open.is_empty() && out.stopped.is_none() {
        let (mut points, mut asked) = (Vec::new(), Vec::new());
        for at in open {
            let crossing = &mut crossings[at];
            let Some(Width { width, logarithmic }) = widths[crossing.along] else { continue };
            let ends = *ends(crossing);
            crossing.is_narrow = ends.1 - ends.0 <= width;
            if let (false, Some(middle)) = (crossing.is_narrow, between(ends, logarithmic)) {
                let fixed = if crossing.along == 0 { crossing.up.0 } else { crossing.across.0 };
                points.push(if crossing.along == 0 { [middle, fixed] } else { [fixed, middle] });
                asked.push((at, middle));
            }
        }
        open = Vec::new();
        if asked.is_empty() {
            break;
        }
        match tried(&points)? {
            Err(stopped) => out.stopped = Some(stopped),
            Ok(found) => {
                out.members += points.len() as u64;
                for ((at, middle), holds) in asked.into_iter().zip(found) {
                    let Some(holds) = holds else { continue };
                    let crossing = &mut crossings[at];
                    let is_first = holds == crossing.first_holds;
                    let ends = ends(crossing);
                    *ends = if is_first { (middle, ends.1) } else { (ends.0, middle) };
                    open.push(at);
                }
            }
        }
    }
    out.crossings = crossings;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(values: &[f64]) -> Axis {
        Axis { name: "x".to_owned(), cells: values.iter().map(|x| (*x, *x)).collect() }
    }

    /// The boundary of what `truth` says, on a map of these values; how often points were asked for.
    fn found(
        values: [&[f64]; 2],
        widths: [Option<Width>; 2],
        truth: &dyn Fn(f64, f64) -> Option<bool>,
    ) -> (Boundary, usize) {
        let axes = values.map(axis);
        let kind = |x: f64, y: f64| match truth(x, y) {
            Some(true) => [1, 0, 0, 0],
            Some(false) => [0, 1, 0, 0],
            None => [0, 0, 0, 1],
        };
        let cells: Vec<[u64; 4]> = values[1].iter().flat_map(|y| values[0].iter().map(|x| kind(*x, *y))).collect();
        let mut rounds = 0;
        let mut tried = |points: &[[f64; 2]]| -> Result<Found, ()> {
            rounds += 1;
            Ok(Ok(points.iter().map(|[x, y]| truth(*x, *y)).collect()))
        };
        let found = find(&cells, [&axes[0], &axes[1]], widths, &mut tried).expect("no error");
        (found, rounds)
    }

    const GRID: [f64; 5] = [-2.0, -1.0, 0.0, 1.0, 2.0];

    fn linear(width: f64) -> Option<Width> {
        Some(Width { width, logarithmic: false })
    }

    #[test]
    fn every_crossing_has_the_edge_between_its_ends() {
        let circle = |x: f64, y: f64| Some(x * x + y * y < 1.7);
        let (boundary, _) = found([&GRID, &GRID], [linear(1e-3), linear(1e-6)], &circle);
        // Rows −1, 0, 1 and columns −1, 0, 1 leave the circle at both of their ends.
        assert_eq!((boundary.crossings.len(), boundary.stopped), (12, None));
        assert_eq!(boundary.widths, [Some(1e-3), Some(1e-6)]);
        for c in &boundary.crossings {
            let (ends, other, width) = if c.along == 0 { (c.across, c.up, 1e-3) } else { (c.up, c.across, 1e-6) };
            assert!(other.0 == other.1 && c.is_narrow, "{c:?}");
            let edge = (1.7 - other.0 * other.0).sqrt().copysign(ends.0 + ends.1);
            assert!(ends.0 <= edge && edge <= ends.1 && ends.1 - ends.0 <= width && ends.1 > ends.0, "{c:?} {edge}");
            let at = |x: f64| if c.along == 0 { circle(x, other.0) } else { circle(other.0, x) };
            assert_eq!((at(ends.0), at(ends.1)), (Some(c.first_holds), Some(!c.first_holds)), "{c:?}");
        }
        // Along one of the two alone; as wide as the map is: nothing is tried.
        let (boundary, rounds) = found([&GRID, &GRID], [linear(1.0), None], &circle);
        assert_eq!((boundary.crossings.len(), boundary.members, rounds), (6, 0, 0));
        assert!(boundary.crossings.iter().all(|c| c.is_narrow));
    }

    #[test]
    fn what_is_not_known_ends_a_bisection_and_has_no_edge() {
        // Undecided near the edge: the ends stay where the verdict is known.
        let near = |x: f64, _: f64| ((x - 0.3).abs() > 0.1).then_some(x < 0.3);
        let (boundary, _) = found([&GRID, &[0.0, 1.0]], [linear(1e-9), linear(1e-9)], &near);
        assert_eq!(boundary.crossings.len(), 2);
        for c in &boundary.crossings {
            assert!(
                !c.is_narrow && near(c.across.0, 0.0) == Some(true) && near(c.across.1, 0.0) == Some(false),
                "{c:?}"
            );
        }
        let never = |x: f64, _: f64| (x < 0.0).then_some(true);
        assert_eq!(found([&GRID, &[0.0]], [linear(0.1), None], &never).0.crossings, []);
        assert_eq!(found([&[], &[]], [linear(0.1), None], &never).0.crossings, []);
    }

    #[test]
    fn a_logarithmic_row_is_halved_in_ratios() {
        let width = Some(Width { width: 1e-7, logarithmic: true });
        let (boundary, rounds) = found([&[1e-6, 1.0], &[0.0]], [width, None], &|x, _| Some(x < 2e-6));
        let ends = boundary.crossings[0].across;
        assert!(ends.0 < 2e-6 && 2e-6 <= ends.1 && ends.1 - ends.0 <= 1e-7, "{ends:?}");
        // With differences it would take 24 rounds.
        assert!(rounds < 12, "{rounds}");
    }

    #[test]
    fn a_width_below_the_digits_of_numbers_ends() {
        let (boundary, rounds) = found([&[1.0, 2.0], &[0.0]], [linear(1e-300), None], &|x, _| Some(x * x < 2.0));
        assert!(!boundary.crossings[0].is_narrow && rounds < 60, "{boundary:?}");
        assert!((boundary.crossings[0].across.0 - 2.0_f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn a_limit_leaves_the_ends_as_they_are() {
        let axes = [axis(&GRID), axis(&[0.0])];
        let cells: Vec<[u64; 4]> = GRID.iter().map(|x| if *x < 0.5 { [1, 0, 0, 0] } else { [0, 1, 0, 0] }).collect();
        let mut left = 3;
        let mut tried = |points: &[[f64; 2]]| -> Result<Found, ()> {
            left -= 1;
            Ok(if left == 0 { Err(reason::Plain::MotionsTried.into()) } else { Ok(vec![Some(true); points.len()]) })
        };
        let boundary = find(&cells, [&axes[0], &axes[1]], [linear(1e-9), None], &mut tried).expect("no error");
        assert_eq!((boundary.stopped, boundary.members), (Some(reason::Plain::MotionsTried.into()), 2));
        assert!(boundary.crossings[0].across == (0.75, 1.0) && !boundary.crossings[0].is_narrow);
        let mut wrong = |_: &[[f64; 2]]| -> Result<Found, &str> { Err("defect") };
        assert_eq!(find(&cells, [&axes[0], &axes[1]], [linear(1e-9), None], &mut wrong), Err("defect"));
    }
}
