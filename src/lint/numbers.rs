//! Two sides at random points: a look that costs little, before a proof is looked for, and where there is none.
//!
//! **In:** pairs of expressions that should be equal. **Out:** whether they are, to ten digits, wherever both have a value.

use expr::tape::Tape;
use expr::{Expr, Graph, Leaf};
use number::Draws;

/// Relative difference of two values that are called equal.
const SAME: f64 = 1e-10;

/// How many of the points gave both sides of all pairs a value, and whether they agreed at all of these.
pub fn agreement(graph: &Graph, equations: &[(Expr, Expr)], points: usize) -> Option<(usize, bool)> {
    let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    let leaves = graph.leaves_within(roots.iter().copied());
    let tape = Tape::compile(graph, &leaves, &roots).ok()?;
    let mut slots = tape.slots::<f64>(&());
    // The points of every question are the same: the same paper gives the same words.
    let mut draws = Draws::new(0x5EED);
    let mut valid = 0;
    for point in 0..points {
        let value = |draws: &mut Draws| {
            let size = 0.4 + 2.0 * draws.below(1 << 30) as f64 / f64::from(1u32 << 30);
            // Every other point is all positive, as most quantities are.
            if point % 2 == 1 && draws.below(2) == 1 { -size } else { size }
        };
        let inputs: Vec<Result<f64, number::NoValue>> = leaves.iter().map(|_| Ok(value(&mut draws))).collect();
        let outputs = tape.evaluate(&(), &inputs, &mut slots);
        let values: Option<Vec<f64>> = outputs.into_iter().map(|v| v.ok().filter(|v| v.is_finite())).collect();
        let Some(values) = values else { continue };
        valid += 1;
        let agree = values.chunks(2).all(|p| (p[0] - p[1]).abs() <= SAME * (1.0 + p[0].abs().max(p[1].abs())));
        if !agree {
            return Some((valid, false));
        }
    }
    Some((valid, true))
}

/// Whether equations hold at a point, to ten digits; `None` where it does not have all their names, or a side has no value there.
pub fn holds_at(graph: &Graph, equations: &[(Expr, Expr)], point: &proof::Point) -> Option<bool> {
    let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    let leaves = graph.leaves_within(roots.iter().copied());
    let tape = Tape::compile(graph, &leaves, &roots).ok()?;
    let value = |leaf: &Leaf| point.values.iter().find(|(l, _)| l == leaf).map(|(_, v)| Ok(v.decimal));
    let inputs: Vec<Result<f64, number::NoValue>> = leaves.iter().map(value).collect::<Option<_>>()?;
    let outputs = tape.evaluate(&(), &inputs, &mut tape.slots::<f64>(&()));
    let values: Vec<f64> = outputs.into_iter().map(Result::ok).collect::<Option<_>>()?;
    Some(values.chunks(2).all(|p| (p[0] - p[1]).abs() <= 1e-6 * (1.0 + p[0].abs().max(p[1].abs()))))
}

/// Whether a name that stands for any constant could stand for another one on the later side, so that an equation holds: the `C` that
/// takes in a factor or a term from one line to the next. One value of it has to do for all values of the other names.
pub fn absorbs(graph: &Graph, equation: (Expr, Expr), constant: Leaf) -> bool {
    let roots = [equation.0, equation.1];
    let leaves = graph.leaves_within(roots);
    let Some(at) = leaves.iter().position(|l| *l == constant) else { return false };
    let Ok(tape) = Tape::compile(graph, &leaves, &roots) else { return false };
    let mut slots = tape.slots::<f64>(&());
    let mut value = |inputs: &[f64]| {
        let inputs: Vec<Result<f64, number::NoValue>> = inputs.iter().map(|v| Ok(*v)).collect();
        let mut out = tape.evaluate(&(), &inputs, &mut slots).into_iter();
        Some([out.next()?.ok()?, out.next()?.ok()?]).filter(|v| v.iter().all(|v| v.is_finite()))
    };
    let mut draws = Draws::new(0xC0);
    let mut draw = || 0.4 + 2.0 * draws.below(1 << 30) as f64 / f64::from(1u32 << 30);
    let own = draw();
    let mut found: Option<f64> = None;
    for _ in 0..4 {
        let mut point: Vec<f64> = leaves.iter().map(|_| draw()).collect();
        point[at] = own;
        let Some([wanted, _]) = value(&point) else { continue };
        let mut off = |c: f64| {
            point[at] = c;
            value(&point).map(|v| v[1] - wanted)
        };
        match found {
            Some(c) => match off(c) {
                Some(rest) if rest.abs() <= 1e-7 * (1.0 + wanted.abs()) => {}
                _ => return false,
            },
            None => {
                found = Some(match zero_near(own, &mut off) {
                    Some(c) => c,
                    None => return false,
                })
            }
        }
    }
    found.is_some()
}

/// A zero of a function, by the method of secants.
fn zero_near(start: f64, f: &mut impl FnMut(f64) -> Option<f64>) -> Option<f64> {
    let (mut a, mut b) = (start, start * 1.1 + 0.01);
    let (mut fa, mut fb) = (f(a)?, f(b)?);
    for _ in 0..60 {
        if fb.abs() < 1e-12 {
            return Some(b);
        }
        let slope = (fb - fa) / (b - a);
        if slope == 0.0 || !slope.is_finite() {
            return None;
        }
        (a, fa) = (b, fb);
        b -= fb / slope;
        fb = f(b)?;
    }
    (fb.abs() < 1e-9).then_some(b)
}

/// The number by which the later side has to be multiplied to be the earlier one, where it is one number at all points.
pub fn ratio(graph: &Graph, equation: (Expr, Expr)) -> Option<f64> {
    let roots = [equation.0, equation.1];
    let leaves = graph.leaves_within(roots);
    let tape = Tape::compile(graph, &leaves, &roots).ok()?;
    let mut slots = tape.slots::<f64>(&());
    let mut draws = Draws::new(0x0F);
    let mut found: Option<f64> = None;
    let mut points = 0;
    for _ in 0..12 {
        let inputs: Vec<Result<f64, number::NoValue>> =
            leaves.iter().map(|_| Ok(0.4 + 2.0 * draws.below(1 << 30) as f64 / f64::from(1u32 << 30))).collect();
        let values: Option<Vec<f64>> =
            tape.evaluate(&(), &inputs, &mut slots).into_iter().map(|v| v.ok().filter(|v| v.is_finite())).collect();
        let Some([left, right]) = values.as_deref() else { continue };
        if right.abs() < 1e-9 {
            return None;
        }
        let here = left / right;
        match found {
            Some(before) if (before - here).abs() > SAME * before.abs() => return None,
            Some(_) => points += 1,
            None => found = Some(here),
        }
    }
    found.filter(|_| points >= 3 && !leaves.is_empty())
}

/// Points of a picture.
const DRAWN: i32 = 60;

/// Both sides along one name, the others being as they are at a point; `None` where they are the same all along, or a side has no values.
pub fn curves(
    graph: &Graph,
    equation: (Expr, Expr),
    point: &[(Leaf, f64)],
    along: Leaf,
) -> Option<Vec<super::PicturePoint>> {
    let roots = [equation.0, equation.1];
    let leaves = graph.leaves_within(roots);
    let at = leaves.iter().position(|l| *l == along)?;
    let fixed: Vec<f64> =
        leaves.iter().map(|l| point.iter().find(|(p, _)| p == l).map(|(_, v)| *v)).collect::<Option<_>>()?;
    let tape = Tape::compile(graph, &leaves, &roots).ok()?;
    let mut slots = tape.slots::<f64>(&());
    let width = 2.0 * fixed[at].abs().max(1.0);
    let mut value = |x: f64| {
        let inputs: Vec<Result<f64, number::NoValue>> =
            fixed.iter().enumerate().map(|(k, v)| Ok(if k == at { x } else { *v })).collect();
        let mut out = tape.evaluate(&(), &inputs, &mut slots).into_iter().map(|v| v.ok().filter(|v| v.is_finite()));
        (x, out.next().flatten(), out.next().flatten())
    };
    let points: Vec<_> =
        (0..=DRAWN).map(|k| value(fixed[at] + width * f64::from(2 * k - DRAWN) / f64::from(2 * DRAWN))).collect();
    let both = points.iter().filter_map(|(_, l, r)| Some((*l)? - (*r)?));
    let differ = both.clone().filter(|d| d.abs() > 1e-9).count();
    (differ > 10).then_some(points)
}

/// A fraction as a decimal, where that ends soon: `-3/20` is `-0.15`.
pub fn as_decimal(value: &str) -> Option<String> {
    let (sign, size) = value.strip_prefix('-').map_or(("", value), |size| ("-", size));
    let (above, below) = size.split_once('/').unwrap_or((size, "1"));
    let (above, below): (u64, u64) = (above.parse().ok()?, below.parse().ok()?);
    let (mut rest, mut digits) = (above.checked_rem(below)?, String::new());
    while rest > 0 && digits.len() < MOST_DECIMALS {
        rest = rest.checked_mul(10)?;
        digits.push_str(&(rest / below).to_string());
        rest %= below;
    }
    let point = if digits.is_empty() { "" } else { "." };
    (rest == 0).then(|| format!("{sign}{}{point}{digits}", above / below))
}

/// The most decimals of a number that is told as one.
const MOST_DECIMALS: usize = 9;

/// A number as LaTeX has it: `-3/2` is `-\frac{3}{2}`.
pub fn as_fraction(value: &str) -> String {
    let (sign, size) = value.strip_prefix('-').map_or(("", value), |size| ("-", size));
    match size.split_once('/') {
        Some((above, below)) => format!(r"{sign}\frac{{{above}}}{{{below}}}"),
        None => value.to_owned(),
    }
}
