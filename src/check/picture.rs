//! Pictures of motions: numbers for drawing, in the plane of the drawing.
//!
//! **In:** the pictures that a file declares, and a sampled motion. **Out:** [`PictureAccount`]: lines. Nothing is judged
//! here. A sphere is seen from a fixed side of its axes, or from the opposite ones if the motion is there.
//!
//! Level sets are found on a grid of the visible disc, by the signs at its corners and linear interpolation between them;
//! a saddle is a point of a grid on the whole sphere around which the function changes sides four times or more.

use reason::{Plain, Reason, Sampling};
use std::collections::BTreeMap;

use crate::derivation::{Derivation, Picture, PictureKind, Written};
use crate::expr::tape::Tape;
use crate::expr::{Expr, Leaf};
use crate::number::{Bounded, NoValue};
use findings::{Line, LineKind, PictureAccount};
use sampled::trace::Trace;

/// Most points of a line: of these the drawing keeps as few as look the same.
const MOST: usize = 600;
/// Slopes that are drawn along a curve.
const MARKS: usize = 18;
/// Points of the grid of level sets, across the disc.
const GRID: usize = 81;
/// Level sets beside those through saddles.
const LEVELS: usize = 7;
/// Pieces of level sets of so few points are not drawn.
const CRUMB: usize = 5;
/// Points of the grid for saddles, across each side of a cube around the sphere: odd, so that axes are grid points.
const SIDE: usize = 31;
/// How much the length of three quantities may vary on a sphere, relative.
const ROUND: f64 = 1e-6;

/// The leaves that the pictures of a derivation need.
pub(super) fn leaves(derivation: &Derivation) -> Vec<Leaf> {
    let exprs =
        |p: &Picture| -> Vec<Expr> { p.show.iter().chain(&p.slopes).chain(&p.levels).map(|w| w.value).collect() };
    derivation.graph.leaves(derivation.pictures.iter().flat_map(exprs))
}

/// Draws every picture of a motion that is asked for.
pub(super) fn draw(derivation: &Derivation, trace: &Trace) -> Vec<PictureAccount> {
    let asked = derivation.pictures.iter().filter(|p| p.trajectories.binary_search(&trace.trajectory).is_ok());
    let one = |picture: &Picture| {
        let lines = match picture.kind {
            PictureKind::Time => against_time(derivation, picture, trace),
            PictureKind::Curve => curve(derivation, picture, trace),
            PictureKind::Sphere => sphere(derivation, picture, trace),
        };
        let (lines, reason) = match lines {
            Ok(lines) if lines.iter().any(|l| l.points.len() > 1) => (lines, None),
            Ok(_) => (Vec::new(), Some(Plain::NothingToShow.into())),
            Err(reason) => (Vec::new(), Some(reason)),
        };
        let trajectory = derivation.trajectories[trace.trajectory].id.clone();
        PictureAccount { picture: picture.id.clone(), trajectory, lines, reason }
    };
    asked.map(one).collect()
}

type Row = Vec<Result<f64, NoValue>>;

/// Times and values of formulas, thinned.
fn table(derivation: &Derivation, trace: &Trace, formulas: &[Written<Expr>]) -> Result<Vec<(f64, Row)>, Reason> {
    let roots: Vec<Expr> = formulas.iter().map(|w| w.value).collect();
    let unknown = |leaf: Leaf| Sampling::NotKnown(derivation.graph.leaf_latex(leaf).into());
    let tape = Tape::compile(&derivation.graph, trace.leaves, &roots).map_err(unknown)?;
    let mut slots = tape.slots::<Bounded>(&());
    // A motion that is at rest for long is drawn with few points there: samples are dense where it moves.
    let step = trace.times.len().div_ceil(MOST).max(1);
    let mut kept: Vec<usize> = (0..trace.times.len()).step_by(step).collect();
    kept.extend(trace.times.len().checked_sub(1).filter(|last| kept.last() != Some(last)));
    let row = |&i: &usize| {
        let values = tape.evaluate(&(), &trace.points.row(i), &mut slots);
        (trace.times[i], values.into_iter().map(|v| v.map(|v| v.value)).collect())
    };
    Ok(kept.iter().map(row).collect())
}

/// Points in order, parted where there is no value.
fn parts(kind: LineKind, points: impl Iterator<Item = Option<(f64, f64)>>) -> Vec<Line> {
    let mut out = vec![Line { kind, points: Vec::new() }];
    for point in points {
        match (point, out.last_mut()) {
            (Some(p), Some(line)) => line.points.push(p),
            (None, Some(line)) if !line.points.is_empty() => out.push(Line { kind, points: Vec::new() }),
            _ => {}
        }
    }
    out.retain(|l| l.points.len() > 1);
    out
}

fn against_time(derivation: &Derivation, picture: &Picture, trace: &Trace) -> Result<Vec<Line>, Reason> {
    let rows = table(derivation, trace, &picture.show)?;
    let value = |row: &Row, k: usize| row.get(k).and_then(|v| v.as_ref().ok()).copied();
    let of = |k: usize| parts(LineKind::Shown(k), rows.iter().map(move |(t, row)| Some((*t, value(row, k)?))));
    Ok((0..picture.show.len()).flat_map(of).collect())
}

fn curve(derivation: &Derivation, picture: &Picture, trace: &Trace) -> Result<Vec<Line>, Reason> {
    let formulas: Vec<Written<Expr>> = picture.show.iter().chain(&picture.slopes).cloned().collect();
    let rows = table(derivation, trace, &formulas)?;
    let value = |row: &Row, k: usize| row.get(k).and_then(|v| v.as_ref().ok()).copied();
    let point = |row: &Row| Some((value(row, 0)?, value(row, 1)?));
    let mut lines = parts(LineKind::Shown(0), rows.iter().map(|(_, row)| point(row)));
    let all: Vec<(f64, f64)> = lines.iter().flat_map(|l| l.points.iter().copied()).collect();
    let extent = |f: &dyn Fn(&(f64, f64)) -> f64| {
        let (low, high) = all.iter().map(f).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if high > low { high - low } else { 1.0 }
    };
    let (wide, tall) = (extent(&|p| p.0), extent(&|p| p.1));
    for k in 0..picture.slopes.len() {
        for (_, row) in rows.iter().step_by(rows.len().div_ceil(MARKS).max(1)) {
            let (Some((x, y)), Some(slope)) = (point(row), value(row, 2 + k)) else { continue };
            // Of one length on paper, whatever the units.
            let (dx, dy) = (1.0 / wide, slope / tall);
            let length = dx.hypot(dy) / 0.035;
            let (dx, dy) = (1.0 / length, slope / length);
            lines.push(Line { kind: LineKind::Slope(k), points: vec![(x - dx, y - dy), (x + dx, y + dy)] });
        }
    }
    Ok(lines)
}

type Vector = [f64; 3];

fn dot(a: &Vector, b: &Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Directions of the drawing: to the right, up, and towards the viewer.
fn view(points: &[Vector]) -> [Vector; 3] {
    let side = |k: usize| if points.iter().map(|p| p[k]).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
    let towards = [0.78 * side(0), 0.47 * side(1), 0.413 * side(2)];
    let length = dot(&towards, &towards).sqrt();
    let towards = towards.map(|x| x / length);
    // The third axis points up.
    let right = [-towards[1], towards[0], 0.0];
    let length = dot(&right, &right).sqrt();
    let right = right.map(|x| x / length);
    let up = [
        towards[1] * right[2] - towards[2] * right[1],
        towards[2] * right[0] - towards[0] * right[2],
        towards[0] * right[1] - towards[1] * right[0],
    ];
    [right, up, towards]
}

fn sphere(derivation: &Derivation, picture: &Picture, trace: &Trace) -> Result<Vec<Line>, Reason> {
    let rows = table(derivation, trace, &picture.show)?;
    let vector = |row: &Row| -> Option<Vector> {
        let mut out = [0.0; 3];
        for (x, v) in out.iter_mut().zip(row) {
            *x = *v.as_ref().ok()?;
        }
        Some(out)
    };
    let points: Vec<Vector> = rows.iter().filter_map(|(_, row)| vector(row)).collect();
    let lengths: Vec<f64> = points.iter().map(|p| dot(p, p).sqrt()).collect();
    let (short, long) = lengths.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(*x), b.max(*x)));
    if points.is_empty() || long == 0.0 {
        return Ok(Vec::new());
    }
    if long - short > ROUND * long {
        return Err(Sampling::LengthVaries(short, long).into());
    }
    let [right, up, towards] = view(&points);
    let mut lines = Vec::new();
    if let Some(levels) = &picture.levels {
        lines = level_sets(derivation, picture, levels, trace, long, &[right, up, towards]).unwrap_or_default();
    }
    let flat = |p: &Vector| (dot(p, &right) / long, dot(p, &up) / long);
    let in_front = |p: &Vector| dot(p, &towards) >= 0.0;
    for axis in 0..3 {
        let side = if towards[axis] < 0.0 { -1.0 } else { 1.0 };
        let place = (side * right[axis], side * up[axis]);
        lines.push(Line { kind: LineKind::Axis(axis, side > 0.0), points: vec![place] });
    }
    let seen = |front: bool| points.iter().map(move |p| (in_front(p) == front).then(|| flat(p)));
    lines.extend(parts(LineKind::Hidden, seen(false)));
    lines.extend(parts(LineKind::Shown(0), seen(true)));
    if lines.iter().all(|l| !matches!(l.kind, LineKind::Shown(_) | LineKind::Hidden))
        && let Some(first) = points.first()
    {
        // A motion that stays where it is.
        lines.push(Line { kind: LineKind::Shown(0), points: vec![flat(first), flat(first)] });
    }
    Ok(lines)
}

/// Level sets on the visible half of the sphere with this radius.
fn level_sets(
    derivation: &Derivation,
    picture: &Picture,
    levels: &Written<Expr>,
    trace: &Trace,
    radius: f64,
    [right, up, towards]: &[Vector; 3],
) -> Option<Vec<Line>> {
    let graph = &derivation.graph;
    let inputs = graph.leaves([levels.value]);
    let tape = Tape::compile(graph, &inputs, &[levels.value]).ok()?;
    let mut slots = tape.slots::<Bounded>(&());
    let at = |leaf: &Leaf| trace.leaves.iter().position(|l| l == leaf).ok_or(NoValue::OutOfDomain);
    let mut values: Vec<Result<Bounded, NoValue>> =
        inputs.iter().map(|l| at(l).and_then(|i| trace.points.get(0, i))).collect();
    // Where among the inputs each of the three quantities is.
    let shown: Vec<Option<usize>> = picture
        .show
        .iter()
        .map(|w| graph.leaves([w.value]).first().and_then(|leaf| inputs.iter().position(|l| l == leaf)))
        .collect();
    let mut f = |p: &Vector| -> Option<f64> {
        for (place, x) in shown.iter().zip(p) {
            if let Some(place) = place {
                values[*place] = Ok(Bounded { value: radius * x, error: 0.0 });
            }
        }
        Some(tape.evaluate(&(), &values, &mut slots).pop()?.ok()?.value).filter(|x| x.is_finite())
    };
    let mut extent = (f64::INFINITY, f64::NEG_INFINITY);
    let saddles = saddles(&mut f, &mut extent);
    let place = |i: usize| (2.0 * i as f64 / (GRID - 1) as f64 - 1.0) * 0.9999;
    let mut grid = vec![None; GRID * GRID];
    for (k, cell) in grid.iter_mut().enumerate() {
        let (u, v) = (place(k % GRID), place(k / GRID));
        let w = 1.0 - u * u - v * v;
        // Beyond the rim are the values of the rim, so that lines reach it; there they are cut.
        let (w, size) = if w >= 0.0 { (w.sqrt(), 1.0) } else { (0.0, u.hypot(v)) };
        let p = [0, 1, 2].map(|i| (u * right[i] + v * up[i] + w * towards[i]) / size);
        *cell = f(&p);
    }
    let (low, high) = extent;
    if high - low <= 1e-12 * high.abs().max(low.abs()) {
        return Some(Vec::new());
    }
    let even = (1..=LEVELS).map(|k| low + (high - low) * k as f64 / (LEVELS + 1) as f64);
    let level = |kind: LineKind, c: f64| {
        contours(&grid, c).into_iter().flat_map(move |line| {
            let places: Vec<(f64, f64)> = line.into_iter().map(|(x, y)| (fraction(x), fraction(y))).collect();
            inside(&places).into_iter().map(move |points| Line { kind, points })
        })
    };
    let mut lines: Vec<Line> = even.flat_map(|c| level(LineKind::Level, c)).collect();
    lines.extend(saddles.into_iter().flat_map(|c| level(LineKind::Separatrix, c)));
    Some(lines)
}

/// The parts of a line on the disc, each up to the rim.
fn inside(line: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
    let size = |p: &(f64, f64)| p.0.hypot(p.1);
    let mut out: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut open = false;
    for (k, p) in line.iter().enumerate() {
        let before = k.checked_sub(1).and_then(|k| line.get(k));
        let within = size(p) <= 1.0;
        // Where the line crosses the rim, the distance from the middle taken as linear in between.
        let rim = before.filter(|b| (size(b) <= 1.0) != within).map(|b| {
            let share = (1.0 - size(b)) / (size(p) - size(b));
            (b.0 + share * (p.0 - b.0), b.1 + share * (p.1 - b.1))
        });
        if within && !open {
            out.push(Vec::new());
        }
        open = within;
        if let Some(part) = out.last_mut() {
            part.extend(rim);
            part.extend(within.then_some(*p));
        }
    }
    out.retain(|part| part.len() > 1);
    out
}

/// A place on the grid as a place on the disc.
fn fraction(x: f64) -> f64 {
    (2.0 * x / (GRID - 1) as f64 - 1.0) * 0.9999
}

/// Values of a function at its saddles on the unit sphere, different ones only; its extent is noted.
fn saddles(f: &mut dyn FnMut(&Vector) -> Option<f64>, extent: &mut (f64, f64)) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    for face in 0..6 {
        let mut grid = vec![None; SIDE * SIDE];
        for (k, cell) in grid.iter_mut().enumerate() {
            let along = |i: usize| 2.0 * i as f64 / (SIDE - 1) as f64 - 1.0;
            let (a, b, c) = (along(k % SIDE), along(k / SIDE), if face < 3 { 1.0 } else { -1.0 });
            let p = match face % 3 {
                0 => [c, a, b],
                1 => [b, c, a],
                _ => [a, b, c],
            };
            let length = dot(&p, &p).sqrt();
            *cell = f(&p.map(|x| x / length));
            if let Some(x) = cell {
                *extent = (extent.0.min(*x), extent.1.max(*x));
            }
        }
        for i in 1..SIDE - 1 {
            for j in 1..SIDE - 1 {
                let at = |di: i32, dj: i32| {
                    let (i, j) = (i as i32 + di, j as i32 + dj);
                    grid[(j * SIDE as i32 + i) as usize]
                };
                let ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
                let Some(centre) = at(0, 0) else { continue };
                let signs: Vec<bool> = ring.iter().filter_map(|&(a, b)| Some(at(a, b)? > centre)).collect();
                let turns = (0..signs.len()).filter(|&k| signs[k] != signs[(k + 1) % signs.len()]).count();
                if signs.len() == ring.len() && turns >= 4 {
                    found.push(centre);
                }
            }
        }
    }
    let width = extent.1 - extent.0;
    found.sort_by(f64::total_cmp);
    found.dedup_by(|a, b| (*a - *b).abs() <= 1e-3 * width);
    // Where nothing varies but the last digits, rounding makes saddles.
    found.retain(|x| x - extent.0 > 1e-3 * width && extent.1 - x > 1e-3 * width);
    found.truncate(6);
    found
}

/// The lines of a grid on which a function has a value, in units of its cells.
fn contours(grid: &[Option<f64>], level: f64) -> Vec<Vec<(f64, f64)>> {
    // An edge of the grid: its lower end, and whether it goes up.
    type Edge = (usize, usize, bool);
    let above = |i: usize, j: usize| grid[j * GRID + i].map(|x| x > level);
    let crossing = |(i, j, upward): Edge| -> (f64, f64) {
        let (k, l) = if upward { (i, j + 1) } else { (i + 1, j) };
        let (a, b) = (grid[j * GRID + i].unwrap_or(level), grid[l * GRID + k].unwrap_or(level));
        let share = if a == b { 0.5 } else { (level - a) / (b - a) };
        if upward { (i as f64, j as f64 + share) } else { (i as f64 + share, j as f64) }
    };
    let mut links: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for j in 0..GRID - 1 {
        for i in 0..GRID - 1 {
            let corners = [above(i, j), above(i + 1, j), above(i + 1, j + 1), above(i, j + 1)];
            let [Some(a), Some(b), Some(c), Some(d)] = corners else { continue };
            let edges: [(Edge, bool); 4] = [
                ((i, j, false), a != b),
                ((i + 1, j, true), b != c),
                ((i, j + 1, false), c != d),
                ((i, j, true), d != a),
            ];
            let crossed: Vec<Edge> = edges.iter().filter(|(_, crossed)| *crossed).map(|(e, _)| *e).collect();
            // Where all four edges are crossed, the two corners above are parted.
            let pairs: Vec<(Edge, Edge)> = match crossed.as_slice() {
                [e, f] => vec![(*e, *f)],
                [e, f, g, h] => {
                    if a {
                        vec![(*h, *e), (*f, *g)]
                    } else {
                        vec![(*e, *f), (*g, *h)]
                    }
                }
                _ => Vec::new(),
            };
            for (e, f) in pairs {
                links.entry(e).or_default().push(f);
                links.entry(f).or_default().push(e);
            }
        }
    }
    let mut out = Vec::new();
    // Open lines first, from their ends; then the closed ones.
    for ends_only in [true, false] {
        let wanted = |l: &Vec<Edge>| if ends_only { l.len() == 1 } else { !l.is_empty() };
        while let Some(start) = links.iter().find(|(_, l)| wanted(l)).map(|(e, _)| *e) {
            let mut line = vec![crossing(start)];
            let mut here = start;
            while let Some(next) = links.get_mut(&here).and_then(Vec::pop) {
                if let Some(back) = links.get_mut(&next)
                    && let Some(at) = back.iter().position(|e| *e == here)
                {
                    back.swap_remove(at);
                }
                line.push(crossing(next));
                here = next;
            }
            // At the rim the grid leaves crumbs.
            if line.len() > CRUMB {
                out.push(thinned(line));
            }
        }
    }
    out
}

/// Every third point, and the last.
fn thinned(line: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let last = line.last().copied();
    let mut out: Vec<(f64, f64)> = line.into_iter().step_by(3).collect();
    out.extend(last.filter(|p| out.last() != Some(p)));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_saddles_of_a_quadratic_form_are_its_middle_axis() {
        let mut extent = (f64::INFINITY, f64::NEG_INFINITY);
        let mut f = |p: &Vector| Some(p[0] * p[0] + 2.0 * p[1] * p[1] + 3.0 * p[2] * p[2]);
        assert_eq!(saddles(&mut f, &mut extent), [2.0]);
        assert_eq!(extent, (1.0, 3.0));
        let mut flat = |_: &Vector| Some(1.0);
        assert!(saddles(&mut flat, &mut (f64::INFINITY, f64::NEG_INFINITY)).is_empty());
        let mut round = |p: &Vector| Some(p[0] * p[0] + p[1] * p[1] + 3.0 * p[2] * p[2]);
        assert!(saddles(&mut round, &mut (f64::INFINITY, f64::NEG_INFINITY)).is_empty());
    }

    #[test]
    fn lines_end_at_the_rim() {
        let across: Vec<(f64, f64)> = (0..=40).map(|k| (f64::from(k) / 10.0 - 2.0, 0.6)).collect();
        let parts = inside(&across);
        assert_eq!(parts.len(), 1);
        for end in [parts[0].first(), parts[0].last()] {
            let (x, y) = end.expect("a point");
            assert!((x.hypot(*y) - 1.0).abs() < 1e-3, "{x} {y}");
        }
        assert!(inside(&[(2.0, 0.0), (2.0, 1.0)]).is_empty());
        let all = [(0.0, 0.0), (0.5, 0.0), (0.5, 0.5)];
        assert_eq!(inside(&all), [all.to_vec()]);
    }

    #[test]
    fn a_circle_is_one_closed_line_and_a_cut_one_is_open() {
        let grid: Vec<Option<f64>> = (0..GRID * GRID)
            .map(|k| {
                let (x, y) = (fraction((k % GRID) as f64), fraction((k / GRID) as f64));
                Some(x * x + y * y)
            })
            .collect();
        let lines = contours(&grid, 0.25);
        assert_eq!(lines.len(), 1);
        assert!(lines[0].len() > 20);
        assert_eq!(lines[0].first(), lines[0].last());
        for (x, y) in &lines[0] {
            assert!((fraction(*x).hypot(fraction(*y)) - 0.5).abs() < 1e-3);
        }
        let cut: Vec<Option<f64>> = grid.iter().enumerate().map(|(k, x)| x.filter(|_| k % GRID > GRID / 2)).collect();
        let lines = contours(&cut, 0.25);
        assert_eq!(lines.len(), 1);
        assert_ne!(lines[0].first(), lines[0].last());
    }
}
