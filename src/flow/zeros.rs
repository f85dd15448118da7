//! Events: where an expression vanishes along a motion, and where it comes closest to it.
//!
//! The motion is covered by stretches on which the Taylor polynomial of the expression is exact up to its error. On each,
//! all turning points of the polynomial are isolated (a stretch is halved until its derivative has provably no zero or is
//! provably monotone). Between neighbouring turning points the expression is monotone, so that signs there tell all
//! zeros: none is missed between two that lie close together.

mod beside;

use beside::{edge, is_pole, pole, turns_towards, vanishes, vanishes_towards};

use super::core::Core;
use super::cover::{Explorer, Piece, Stretch};
use super::incomplete::Incomplete;
use super::polynomial::{horner, scale, shift, tail};
use super::program::Program;
use expr::FastMap;
use number::{Bounded, NoValue};

/// Degree of the polynomials.
const DEGREE: usize = 20;
/// A minimum below this share of the values around it may be 0.
const FLAT: f64 = 64.0 * f64::EPSILON;
/// What is around it: up to this share of the span away.
const AROUND: f64 = 1e-2;

/// The zeros of an expression along a motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Zeros {
    /// Times at which the sign changes; also a zero at an end of the span that is passed with a speed other than 0.
    pub times: Vec<f64>,
    /// How well each of these times is known: the error of the expression there, over its speed.
    pub slack: Vec<f64>,
    /// Times at which the expression comes within its error of 0 and turns back: a double zero, or two close ones, or
    /// none; the values cannot tell.
    pub touching: Vec<f64>,
    /// Those of these times that are an edge of the domain towards which the expression falls in proportion to time: a
    /// coincidence, as where it has a zero of its own within the error of the edge, and may have values beyond it.
    pub cut_off: Vec<f64>,
    /// For every stretch of time on which the expression keeps its sign, the time among those looked at at which it is
    /// farthest from 0.
    pub peaks: Vec<f64>,
    /// The stretches on which nothing could be decided, in their order.
    pub incomplete: Vec<Incomplete>,
}

/// Where an expression comes closest to 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minimum {
    /// The time.
    pub time: f64,
    /// The value there, with its sign and error. It contains 0 where the sign changes.
    pub value: Bounded,
    /// The first stretch on which nothing could be decided: the expression may come closer to 0 there.
    pub incomplete: Option<Incomplete>,
}

/// A time at which the expression was looked at.
#[derive(Clone, Copy, Debug)]
struct Node {
    time: f64,
    value: Bounded,
    /// How far the expression may be from its polynomial there: a minimum is not known better than that.
    room: f64,
}

impl Node {
    /// −1, 0 (within the error) or 1.
    fn sign(&self) -> i8 {
        if self.value.contains_zero() {
            0
        } else if self.value.value > 0.0 {
            1
        } else {
            -1
        }
    }
}

/// Nodes of a stretch without gaps.
type Run = Vec<Node>;

/// What is seen of an expression along a motion.
struct Seen {
    /// For every run without gaps, ends and turning points.
    runs: Vec<Run>,
    /// Times at which no polynomial describes the expression, although it has values around.
    kinks: Vec<f64>,
    incomplete: Vec<Incomplete>,
}

/// Two notes that follow one another and say the same are one.
fn note(incomplete: &mut Vec<Incomplete>, what: Incomplete) {
    if let (Some(Incomplete::Vanishing { end, .. }), Incomplete::Vanishing { start, end: last }) =
        (incomplete.last_mut(), what)
        && *end == start
    {
        *end = last;
        return;
    }
    incomplete.push(what);
}

/// Values at times, each found once.
#[derive(Default)]
struct Known(FastMap<u64, Option<Bounded>>);

impl Known {
    /// Finds the values at times, many at once.
    fn find(&mut self, explorer: &mut Explorer, times: impl IntoIterator<Item = f64>) {
        let mut new: Vec<f64> = times.into_iter().filter(|t| !self.0.contains_key(&t.to_bits())).collect();
        new.sort_by(f64::total_cmp);
        new.dedup();
        let values = explorer.all_values(&new);
        self.0.extend(new.iter().map(|t| t.to_bits()).zip(values.into_iter().map(Result::ok)));
    }

    /// The value at a time, if it is known, and has one.
    fn get(&self, t: f64) -> Option<Bounded> {
        self.0.get(&t.to_bits()).copied().flatten()
    }
}

/// Whether a polynomial is what it is of, up to errors.
fn converges(piece: &Piece) -> bool {
    let (Some(c), Some(x)) = (piece.outputs.first(), piece.values.first()) else { return false };
    tail(c, DEGREE, piece.radius()) <= 0.25 * x.error + 4.0 * f64::EPSILON * size(c, *x, piece)
}

/// How large the first output of a piece is.
fn size(c: &[f64], x: Bounded, piece: &Piece) -> f64 {
    x.value.abs() + c.get(1).map_or(0.0, |c| c.abs() * piece.radius())
}

/// Whether the expression follows the polynomial up to the ends: behind a kink or a jump the polynomial goes on, and the expression
/// does not.
fn follows(piece: &Piece, ends: &Known) -> bool {
    let (Some(c), Some(x)) = (piece.outputs.first(), piece.values.first()) else { return false };
    [piece.start, piece.end].into_iter().all(|t| match ends.get(t) {
        Some(y) => {
            let gap = (y.value - horner(c, t - piece.centre)).abs();
            gap <= 4.0 * (x.error + y.error) + 64.0 * f64::EPSILON * (size(c, *x, piece) + y.value.abs())
        }
        // A piece may end where there is no value.
        None => true,
    })
}

/// Covers the motion.
fn look(explorer: &mut Explorer) -> Seen {
    let times = explorer.core.boundaries();
    let mut known = Known::default();
    let stretches = explorer.cover(&times, |explorer, pieces| {
        let converge: Vec<bool> = pieces.iter().map(|piece| converges(piece)).collect();
        let ends = pieces.iter().zip(&converge).filter(|(_, converges)| **converges);
        known.find(explorer, ends.flat_map(|(piece, _)| [piece.start, piece.end]));
        pieces.iter().zip(converge).map(|(piece, converges)| converges && follows(piece, &known)).collect()
    });
    // The times at which each piece is looked at, and whether it stays within its error of 0.
    let inner = |stretch: &Stretch| match stretch {
        Stretch::Gap { .. } => (Vec::new(), false),
        Stretch::Piece(piece) => {
            let mut inner = vec![piece.start];
            let flat = turning_points(piece, &mut inner);
            inner.push(piece.end);
            (inner, flat)
        }
    };
    let inner: Vec<(Vec<f64>, bool)> = stretches.iter().map(inner).collect();
    known.find(explorer, inner.iter().flat_map(|(times, _)| times.iter().copied()));
    let (mut incomplete, mut kinks) = (Vec::new(), Vec::new());
    let mut runs: Vec<Run> = vec![Vec::new()];
    let length = times.last().zip(times.first()).map_or(0.0, |(b, a)| b - a);
    for (stretch, (inner, flat)) in stretches.iter().zip(inner) {
        match *stretch {
            Stretch::Gap { start, end, reason } => {
                // A kink at one time is no obstacle: the expression is continuous across it, or has a pole.
                if end - start > 1e-12 * length || reason.is_some() {
                    let what = match reason {
                        Some(reason) => Incomplete::NoValue { start, end, reason },
                        None => Incomplete::Unresolved { start, end },
                    };
                    note(&mut incomplete, what);
                    runs.push(Vec::new());
                } else {
                    kinks.push(start + 0.5 * (end - start));
                }
            }
            Stretch::Piece(ref piece) => {
                let room = room(piece).unwrap_or(f64::INFINITY);
                if flat {
                    note(&mut incomplete, Incomplete::Vanishing { start: piece.start, end: piece.end });
                }
                for time in inner {
                    let run = match runs.last_mut() {
                        Some(run) => run,
                        None => continue,
                    };
                    if let Some(last) = run.last_mut().filter(|n: &&mut Node| n.time >= time) {
                        // Two pieces share an end.
                        last.room = last.room.max(room);
                        continue;
                    }
                    if let Some(value) = known.get(time) {
                        run.push(Node { time, value, room });
                        continue;
                    }
                    // A piece may end where there is no value. What it tends to tells whether it passes 0 before that.
                    let Some(value) = tends_to(piece, time) else { continue };
                    if value.contains_zero() {
                        note(
                            &mut incomplete,
                            Incomplete::NoValue { start: time, end: time, reason: NoValue::Indeterminate },
                        );
                    } else if time == piece.start {
                        runs.push(vec![Node { time, value, room }]);
                    } else if time == piece.end {
                        run.push(Node { time, value, room });
                        runs.push(Vec::new());
                    }
                }
            }
        }
    }
    Seen { runs, kinks, incomplete }
}

/// What the first output of a piece tends to at a time of it.
fn tends_to(piece: &Piece, time: f64) -> Option<Bounded> {
    Some(Bounded { value: horner(piece.outputs.first()?, time - piece.centre), error: room(piece)? })
}

/// How far the first output of a piece may be from its polynomial: by the errors of its values, and by rounding.
fn room(piece: &Piece) -> Option<f64> {
    let (c, x) = (piece.outputs.first()?, piece.values.first()?);
    Some(4.0 * x.error + 64.0 * f64::EPSILON * size(c, *x, piece))
}

/// Appends the turning points of the first output in ascending order; true if it stays within its error of 0 throughout.
fn turning_points(piece: &Piece, out: &mut Vec<f64>) -> bool {
    let (Some(c), Some(value)) = (piece.outputs.first(), piece.values.first()) else { return false };
    let radius = piece.radius();
    // Scaled to [−1, 1].
    let mut scaled = c.clone();
    scale(&mut scaled, radius);
    let variation: f64 = scaled.iter().skip(1).map(|c| c.abs()).sum();
    if value.contains_zero() && variation <= value.error {
        return true;
    }
    let noise = 0.125 * value.error + 2.0 * f64::EPSILON * value.value.abs();
    let slopes: Vec<f64> = scaled.iter().enumerate().skip(1).map(|(k, c)| c * k as f64).collect();
    let mut stack = vec![(-1.0_f64, 1.0_f64)];
    let mut local = Vec::with_capacity(scaled.len());
    while let Some((lo, hi)) = stack.pop() {
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        shift(&scaled, middle, half, &mut local);
        let slope = local.get(1).map_or(0.0, |c| c.abs());
        if slope > weighed(&local, 2, |k| k) {
            continue;
        }
        if weighed(&local, 1, |_| 1.0) <= noise || half < 1e-9 {
            out.push(piece.centre + radius * middle);
            continue;
        }
        let bend = local.get(2).map_or(0.0, |c| 2.0 * c.abs());
        if bend > weighed(&local, 3, |k| k * (k - 1.0)) {
            // The slope is monotone: at most one turning point.
            let (left, right) = (horner(&slopes, lo), horner(&slopes, hi));
            if (left <= 0.0) != (right <= 0.0) {
                let at = bisect((lo, left), (hi, right), |x| horner(&slopes, x));
                out.push(piece.centre + radius * at);
            }
            continue;
        }
        stack.push((middle, hi));
        stack.push((lo, middle));
    }
    false
}

/// The sum of the sizes of coefficients from an order on, each with a weight that depends on its order.
#[inline]
fn weighed(c: &[f64], from: usize, weight: impl Fn(f64) -> f64) -> f64 {
    c.iter().enumerate().skip(from).map(|(k, c)| weight(k as f64) * c.abs()).sum()
}

/// A zero of f between two points at which its signs differ: false position with the weight of the staying end halved
/// (Illinois), and a bisection whenever that does not halve the bracket in three steps.
fn bisect((mut a, mut fa): (f64, f64), (mut b, mut fb): (f64, f64), mut f: impl FnMut(f64) -> f64) -> f64 {
    let mut width = (b - a).abs();
    let (mut side, mut slow) = (0, 0);
    for _ in 0..200 {
        let middle = a + 0.5 * (b - a);
        if !(a.min(b) < middle && middle < a.max(b)) {
            break;
        }
        let mut x = if slow >= 3 { middle } else { (a * fb - b * fa) / (fb - fa) };
        if !(x > a.min(b) && x < a.max(b)) {
            x = middle;
        }
        let y = f(x);
        if y == 0.0 || !y.is_finite() {
            return x;
        }
        if (y > 0.0) == (fa > 0.0) {
            (a, fa) = (x, y);
            fb *= if side == 1 { 0.5 } else { 1.0 };
            side = 1;
        } else {
            (b, fb) = (x, y);
            fa *= if side == -1 { 0.5 } else { 1.0 };
            side = -1;
        }
        slow += 1;
        if (b - a).abs() <= 0.5 * width {
            width = (b - a).abs();
            slow = 0;
        }
    }
    a + 0.5 * (b - a)
}

/// Adds nodes between neighbours that are both within their error of 0, so that separate zeros are told apart.
fn separate(explorer: &mut Explorer, run: &mut Run, shortest: f64) {
    let mut more = Vec::new();
    for pair in run.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if a.sign() == 0 && b.sign() == 0 && b.time - a.time > shortest {
            for x in [0.25, 0.5, 0.75] {
                let time = a.time + x * (b.time - a.time);
                if let Some(Ok(value)) = explorer.values(time).first() {
                    more.push(Node { time, value: *value, room: a.room.max(b.room) });
                }
            }
        }
    }
    run.extend(more);
    run.sort_by(|a, b| a.time.total_cmp(&b.time));
}

/// All zeros of the only output of `program`.
pub(super) fn zeros(core: &Core, program: &Program) -> Zeros {
    let mut explorer = Explorer::new(core, program, DEGREE);
    let Seen { runs, kinks, incomplete } = look(&mut explorer);
    let (from, to) = core.reach();
    let shortest = 1e-9 * (to - from);
    let mut out = Zeros { incomplete, ..Zeros::default() };
    for mut run in runs {
        separate(&mut explorer, &mut run, shortest);
        out.peaks(&mut explorer, &run);
        // A kink that is no wider than the errors is not seen as one, the place of a flat minimum is not known better than the
        // values beside it, and a zero may lie just beyond an end: what comes so close to 0 there may reach it.
        let size = |n: &Node| n.value.value.abs();
        for (at, b) in run.iter().enumerate() {
            let beside = [at.checked_sub(1), Some(at + 1)].into_iter().flatten().filter_map(|i| run.get(i));
            // The first of equals: two that lie alike on both sides of a minimum are both next to it.
            let lowest =
                |n: &Node| b.sign() == n.sign() && if n.time < b.time { size(b) < size(n) } else { size(b) <= size(n) };
            if b.sign() == 0 || !beside.clone().all(lowest) {
                continue;
            }
            let near = |n: &&Node| (n.time - b.time).abs() <= AROUND * (to - from);
            let around = run[..at].iter().rev().take_while(near).chain(run[at + 1..].iter().take_while(near));
            let largest = around.chain(beside).map(size).fold(0.0, f64::max);
            if size(b) <= (16.0 * b.value.error).max(FLAT * largest).max(b.room) {
                out.touch(&mut explorer, *b);
            }
        }
        let mut at = 0;
        let mut before: Option<Node> = None;
        while at < run.len() {
            let node = run[at];
            if node.sign() != 0 {
                if let Some(b) = before
                    && b.sign() != node.sign()
                {
                    out.cross(&mut explorer, b, node);
                }
                before = Some(node);
                at += 1;
                continue;
            }
            let until = run[at..].iter().position(|n| n.sign() != 0).map_or(run.len(), |n| at + n);
            let after = run.get(until).copied();
            let closest = run[at..until].iter().copied().min_by(|a, b| {
                let size = |n: &Node| n.value.value.abs();
                size(a).total_cmp(&size(b))
            });
            let closest = closest.unwrap_or(node);
            match (before, after) {
                (Some(b), Some(a)) if a.sign() != b.sign() => out.cross(&mut explorer, b, a),
                (Some(_), Some(_)) => out.touch(&mut explorer, closest),
                (None, None) => {}
                // A zero at an end of the run: passed, or only touched.
                (b, a) => {
                    let (Some(other), end) = (b.or(a), closest) else { break };
                    if passes(&mut explorer, end, other) {
                        out.crossing(&mut explorer, end.time, end.value);
                    } else {
                        out.touch(&mut explorer, end);
                    }
                }
            }
            before = after.or(before);
            at = until + usize::from(after.is_some());
        }
    }
    for gap in &mut out.incomplete {
        if is_pole(&mut explorer, gap.stretch()) {
            *gap = pole(gap.stretch().0);
        }
    }
    // A root ends at an edge of its domain with the value 0, which no sign tells.
    let edges: Vec<(f64, f64)> = out.incomplete.iter().filter_map(edge).collect();
    for (start, end) in edges {
        for (at, onwards) in [(start, false), (end, true)] {
            if let Some(in_proportion) = vanishes_towards(&mut explorer, at, onwards) {
                out.touching.push(at);
                out.cut_off.extend(in_proportion.then_some(at));
            }
        }
    }
    let ends: Vec<[f64; 2]> = out.incomplete.iter().filter_map(edge).map(|(start, end)| [start, end]).collect();
    for [start, end] in ends.into_iter().chain(kinks.iter().map(|&kink| [kink, kink])) {
        let turns = [(start, false), (end, true)].map(|(at, onwards)| turns_towards(&mut explorer, at, onwards));
        out.incomplete.extend(turns.into_iter().flatten());
    }
    for kink in kinks {
        let near = |t: &f64| (t - kink).abs() <= 2.0 * shortest;
        let known = out.times.iter().chain(&out.touching).any(near);
        if !known && !is_pole(&mut explorer, (kink, kink)) {
            match vanishes(&mut explorer, kink) {
                Some(true) => out.touching.push(kink),
                Some(false) => {}
                None => out.incomplete.push(Incomplete::Unresolved { start: kink, end: kink }),
            }
        }
    }
    out.touching.sort_by(f64::total_cmp);
    out.incomplete.sort_by(|a, b| a.stretch().0.total_cmp(&b.stretch().0));
    // Poles so near to each other cannot be told apart.
    let is_one = |a: f64, b: f64| (a - b).abs() <= 64.0 * f64::EPSILON * a.abs();
    out.incomplete.dedup_by(|b, a| {
        a == b || *a == pole(a.stretch().0) && *b == pole(b.stretch().0) && is_one(a.stretch().0, b.stretch().0)
    });
    out
}

impl Zeros {
    /// What lies inside a span.
    pub(super) fn within(mut self, (from, to): (f64, f64)) -> Zeros {
        let inside = |t: &f64| (from..=to).contains(t);
        let kept = self.times.iter().zip(&self.slack).filter(|(t, _)| inside(t)).map(|(&t, &s)| (t, s));
        (self.times, self.slack) = kept.unzip();
        self.touching.retain(inside);
        self.cut_off.retain(inside);
        self.peaks.retain(inside);
        self.incomplete.retain(|i| i.stretch().0 <= to && i.stretch().1 >= from);
        self
    }

    /// Records the peak of every stretch of a run on which the sign stays.
    fn peaks(&mut self, explorer: &mut Explorer, run: &Run) {
        let mut best: Option<&Node> = None;
        let mut peaks: Vec<Node> = Vec::new();
        // What is very large close to a pole is not well known: a clear value counts more than a large one.
        let clear = |n: &Node| ((n.value.value / n.value.error).abs().min(1e6), n.value.value.abs());
        for node in run.iter().filter(|n| n.sign() != 0) {
            let farther = best.is_some_and(|b| clear(node) > clear(b));
            let other = best.is_some_and(|b| b.sign() != node.sign());
            if other {
                peaks.extend(best);
            }
            if best.is_none() || other || farther {
                best = Some(node);
            }
        }
        peaks.extend(best);
        for peak in peaks {
            if peak.value.value.abs() > 10.0 * peak.value.error {
                self.peaks.push(peak.time);
            } else {
                self.touch(explorer, peak);
            }
        }
    }

    /// Records a time at which the expression comes within its error of 0, unless this is only because it is large.
    fn touch(&mut self, explorer: &mut Explorer, node: Node) {
        if is_pole(explorer, (node.time, node.time)) {
            self.incomplete.push(pole(node.time));
        } else {
            self.touching.push(node.time);
        }
    }

    /// Records a zero.
    fn crossing(&mut self, explorer: &mut Explorer, time: f64, here: Bounded) {
        let (from, to) = explorer.core.reach();
        let step = 1e-6 * (to - from);
        let (before, after) = ((time - step).max(from), (time + step).min(to));
        let mut value = |t: f64| explorer.values(t).first().copied().and_then(Result::ok).map(|x| x.value);
        let speed = match (value(before), value(after)) {
            (Some(a), Some(b)) => (b - a).abs() / (after - before),
            _ => 0.0,
        };
        let floor = 4.0 * f64::EPSILON * time.abs().max(f64::MIN_POSITIVE);
        self.times.push(time);
        let slack = if speed > 0.0 { (here.value.abs() + here.error) / speed + floor } else { floor };
        // The zero lies where the sign changes: where the expression leaves it more slowly than its speed says, like y|y| or
        // y⁵, or was found beside it, that is as far away as the signs on both sides are not known, and not opposite.
        let sign = |explorer: &mut Explorer, t: f64| {
            let value = explorer.values(t).first().copied().and_then(Result::ok);
            value.filter(|x| !x.contains_zero()).map(|x| x.value > 0.0)
        };
        let between = |explorer: &mut Explorer, slack: f64| {
            let (before, after) = (time - 2.0 * slack, time + 2.0 * slack);
            let beyond = [before <= from, after >= to];
            let [left, right] = [before, after].map(|t| sign(explorer, t));
            match beyond {
                [true, true] => true,
                [true, false] => right.is_some(),
                [false, true] => left.is_some(),
                [false, false] => left.is_some() && right.is_some() && left != right,
            }
        };
        let mut wider = std::iter::successors(Some(slack), |slack| Some(2.0 * slack));
        let known = wider.find(|s| *s >= to - from || between(explorer, *s));
        self.slack.push(known.unwrap_or(slack));
    }

    /// Records the change of sign between two nodes: a zero, unless the expression jumps there.
    fn cross(&mut self, explorer: &mut Explorer, a: Node, b: Node) {
        let time = refine(explorer, a, b);
        match explorer.values(time).first() {
            Some(Ok(x)) if x.value.abs() <= 1e-6 * a.value.value.abs().max(b.value.value.abs()) + 4.0 * x.error => {
                let here = *x;
                match leaps(explorer, time, [a.time, b.time]) {
                    true => self.incomplete.push(Incomplete::Unresolved { start: time, end: time }),
                    false => self.crossing(explorer, time, here),
                }
            }
            Some(Err(reason)) => {
                self.incomplete.push(Incomplete::NoValue { start: time, end: time, reason: *reason });
            }
            // At a pole the sign changes and the values grow; at a jump they do not.
            _ if is_pole(explorer, (time, time)) => self.incomplete.push(pole(time)),
            _ => self.incomplete.push(Incomplete::Unresolved { start: time, end: time }),
        }
    }
}

/// Whether the expression comes to a zero on one side only: on the other it stays away from it however near the time is.
fn leaps(explorer: &mut Explorer, time: f64, ends: [f64; 2]) -> bool {
    ends.into_iter().any(|end| {
        let reach = end - time;
        let near = (1e-12 * reach.abs()).max(64.0 * f64::EPSILON * time.abs()).copysign(reach);
        let mut value = |t: f64| explorer.values(t).first().copied().and_then(Result::ok);
        match (value(time + near), value(time + 0.001 * reach)) {
            (Some(x), Some(far)) if near.abs() < 1e-4 * reach.abs() => {
                x.value.abs() - x.error > 0.5 * (far.value.abs() + far.error)
            }
            _ => false,
        }
    })
}

/// Whether the expression leaves a zero at the end of a run with a speed: then it is about linear close to it.
fn passes(explorer: &mut Explorer, end: Node, inner: Node) -> bool {
    let mut value = |x: f64| explorer.values(end.time + x * (inner.time - end.time)).first().copied();
    let mut step = 1.0;
    // Halve as long as the value is beyond its error: a linear one halves each time, a square quarters.
    let mut last = inner.value;
    let mut ratios = Vec::new();
    for _ in 0..30 {
        step *= 0.5;
        match value(step) {
            Some(Ok(x)) if x.value.abs() > 8.0 * x.error => {
                ratios.push(x.value / last.value);
                last = x;
            }
            _ => break,
        }
    }
    ratios.last().is_some_and(|r| *r > 0.36)
}

/// The zero between two nodes of opposite signs.
fn refine(explorer: &mut Explorer, a: Node, b: Node) -> f64 {
    bisect((a.time, a.value.value), (b.time, b.value.value), |t| match explorer.values(t).first() {
        Some(Ok(x)) => x.value,
        _ => f64::NAN,
    })
}

/// The smallest absolute value of the only output of `program`.
pub(super) fn minimum(core: &Core, program: &Program) -> Option<Minimum> {
    let mut explorer = Explorer::new(core, program, DEGREE);
    let Seen { runs, incomplete, .. } = look(&mut explorer);
    let incomplete = incomplete.first().copied();
    let mut best: Option<Minimum> = None;
    let mut offer = |time: f64, value: Bounded| {
        if best.is_none_or(|b| value.value.abs() < b.value.value.abs()) {
            best = Some(Minimum { time, value, incomplete });
        }
    };
    for run in runs {
        for pair in run.windows(2) {
            if pair[0].sign() * pair[1].sign() < 0 {
                let time = refine(&mut explorer, pair[0], pair[1]);
                if let Some(Ok(value)) = explorer.values(time).first() {
                    offer(time, *value);
                }
            }
        }
        for node in run {
            offer(node.time, node.value);
        }
    }
    best
}
