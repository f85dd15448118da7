//! Error bounds of motions against the same motions with 128 bits.
//!
//! **In:** random systems over every operation that has a series: steep, nearly singular, stiff, long. **Out:** for each motion the
//! largest distance from the reference as a share of its error bound, which must be below 1, for both estimates.
//!
//! The reference shares nothing with the program but the expressions of the rates: it evaluates them in the numbers of `dashu-float`,
//! and integrates by extrapolation of the modified midpoint rule (Gragg, Bulirsch & Stoer; Hairer, Nørsett & Wanner, "Solving Ordinary
//! Differential Equations I", section II.9), which knows no series.
//!
//! `REDERIVE_MOTIONS` is how many systems are tried, `REDERIVE_SEED` where the draws start.

use crate::estimate::Estimation;
use crate::flow_support::World;
use crate::trajectory::{Plan, Trajectory};
use dashu_float::FBig;
use expr::Leaf;
use expr::tape::Tape;
use number::{Bounded, Draws, NoValue, Op, Rational, Uniform};
use std::fmt::Write as _;

/// Bits of the reference.
const BITS: usize = 128;
/// Rows of the extrapolation: its order is twice that.
const ROWS: usize = 12;
/// What a step of the reference may be off, relative to the state.
const FINE: f64 = 1e-22;
/// Most evaluations of the rates for one motion.
const MOST: usize = 60_000;

/// A real number with [`BITS`] bits.
#[derive(Clone, Debug)]
struct Long(FBig);

fn long(x: f64) -> FBig {
    FBig::try_from(x).unwrap_or_default().with_precision(BITS).value()
}

fn near(x: &FBig) -> f64 {
    x.to_f64().value()
}

fn inside(so: bool) -> Result<(), NoValue> {
    if so { Ok(()) } else { Err(NoValue::OutOfDomain) }
}

impl Uniform for Long {
    type Context = ();

    fn blank(_: &()) -> Long {
        Long(long(0.0))
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let (numerator, denominator) = (FBig::from(r.numerator().clone()), FBig::from(r.denominator().clone()));
        self.0 = numerator.with_precision(BITS).value() / denominator.with_precision(BITS).value();
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        self.0 = FBig::pi(BITS);
        Ok(())
    }
    fn rule(&mut self, _: &(), op: Op, a: &Long, b: &Long) -> Result<(), NoValue> {
        let (zero, one) = (long(0.0), long(1.0));
        let (a, b) = (a.0.clone(), b.0.clone());
        // e^u of what is far below everything is 0, in a way that the crate need not be asked for.
        let exp = |u: FBig| if near(&u) < -1000.0 { long(0.0) } else { u.exp() };
        let found = match op {
            Op::Neg => -a,
            Op::Sqrt => {
                inside(a >= zero)?;
                if a == zero { zero } else { a.sqrt() }
            }
            Op::Exp => exp(a),
            Op::Ln => {
                inside(a > zero)?;
                a.ln()
            }
            Op::Sin => a.sin(),
            Op::Cos => a.cos(),
            Op::Tan => a.sin() / a.cos(),
            Op::Arcsin | Op::Arccos => {
                inside(a <= one && a >= -one.clone())?;
                if op == Op::Arcsin { a.asin() } else { a.acos() }
            }
            Op::Arctan => a.atan(),
            Op::Sinh => (exp(a.clone()) - exp(-a)) / long(2.0),
            Op::Cosh => (exp(a.clone()) + exp(-a)) / long(2.0),
            Op::Tanh => {
                let (size, negative) = (if a < zero { -a.clone() } else { a.clone() }, a < zero);
                let e = exp(size * long(-2.0));
                let tanh = (one.clone() - e.clone()) / (one + e);
                if negative { -tanh } else { tanh }
            }
            Op::Abs if a < zero => -a,
            Op::Abs | Op::Restrict => a,
            Op::Add => a + b,
            Op::Sub => a - b,
            Op::Mul => a * b,
            Op::Div => {
                inside(b != zero)?;
                a / b
            }
            Op::Pow => {
                inside(a > zero)?;
                (b * a.ln()).exp()
            }
            Op::Powi(n) => {
                inside(n >= 0 || a != zero)?;
                let power = (0..n.unsigned_abs()).fold(one.clone(), |p, _| p * a.clone());
                if n < 0 { one / power } else { power }
            }
            Op::Arctan2 => {
                inside(a != zero || b != zero)?;
                a.atan2(&b)
            }
            Op::DirectionCosine => {
                let radius = (a.clone() * a.clone() + b.clone() * b).sqrt();
                inside(radius != zero)?;
                a / radius
            }
            Op::Agm => return Err(NoValue::Unsupported),
        };
        // 0 has lost its precision.
        self.0 = found.with_precision(BITS).value();
        Ok(())
    }
}

/// The reference: the rates, and how often they were evaluated.
struct Reference {
    tape: Tape,
    evaluations: usize,
}

impl Reference {
    fn rates(&mut self, t: &FBig, state: &[FBig]) -> Option<Vec<FBig>> {
        self.evaluations += 1;
        let inputs: Vec<Result<Long, NoValue>> = [t].into_iter().chain(state).map(|x| Ok(Long(x.clone()))).collect();
        let mut slots = self.tape.slots::<Long>(&());
        self.tape.evaluate(&(), &inputs, &mut slots).into_iter().map(|x| x.ok().map(|x| x.0)).collect()
    }

    /// The modified midpoint rule with `n` parts, n even, without smoothing: an even power series in the step.
    fn midpoint(&mut self, t: &FBig, h: &FBig, start: &[FBig], rates: &[FBig], n: usize) -> Option<Vec<FBig>> {
        let part = h.clone() / long(n as f64);
        let moved = |from: &[FBig], rates: &[FBig], by: &FBig| -> Vec<FBig> {
            from.iter().zip(rates).map(|(x, r)| x.clone() + by.clone() * r.clone()).collect()
        };
        let (mut before, mut now) = (start.to_vec(), moved(start, rates, &part));
        let double = part.clone() * long(2.0);
        for i in 1..n {
            let time = t.clone() + part.clone() * long(i as f64);
            let rates = self.rates(&time, &now)?;
            let next = moved(&before, &rates, &double);
            before = std::mem::replace(&mut now, next);
        }
        Some(now)
    }

    /// A step by extrapolation: where it leads, how far off that may be, relative to the states, and how many rows it took.
    fn step(&mut self, t: &FBig, h: &FBig, start: &[FBig]) -> Option<(Vec<FBig>, f64, usize)> {
        let rates = self.rates(t, start)?;
        // The row before: by midpoints, then extrapolated once, twice, …
        let mut before: Vec<Vec<FBig>> = Vec::new();
        let (mut off, mut rows) = (f64::INFINITY, 0);
        for row in 0..ROWS {
            rows = row;
            let parts = |row: usize| long(2.0 * (row as f64 + 1.0));
            let mut now = vec![self.midpoint(t, h, start, &rates, 2 * (row + 1))?];
            for k in 0..row {
                // Aitken & Neville in the squares of the steps.
                let ratio = parts(row) / parts(row - k - 1);
                let weight = ratio.clone() * ratio - long(1.0);
                let both = now[k].iter().zip(&before[k]);
                let better = both.map(|(x, y)| x.clone() + (x.clone() - y.clone()) / weight.clone()).collect();
                now.push(better);
            }
            if let Some([last, best]) = now.last_chunk() {
                let apart = |(x, y): (&FBig, &FBig)| near(&(x.clone() - y.clone())).abs() / (1e-3 + near(x).abs());
                off = best.iter().zip(last).map(apart).fold(0.0, f64::max);
            }
            before = now;
            let hopeless = row > ROWS / 2 && off > 1e-3 * FINE.sqrt();
            if off <= FINE || hopeless {
                break;
            }
        }
        Some((before.pop()?, off, rows))
    }

    /// The state at each of some times; fewer where the work is too much.
    fn along(&mut self, from: f64, start: Vec<FBig>, times: &[f64]) -> Vec<Vec<f64>> {
        let mut state = start;
        let (mut t, mut h) = (long(from), times.first().map_or(0.0, |t| t - from) / 4.0);
        let mut out = Vec::new();
        for &end in times {
            let end = long(end);
            loop {
                let left = near(&(end.clone() - t.clone()));
                if left <= 0.0 {
                    break;
                }
                let last = h >= left;
                let length = if last { end.clone() - t.clone() } else { long(h) };
                let Some((next, off, rows)) = self.step(&t, &length, &state) else { return out };
                if off <= FINE {
                    state = next;
                    t = if last { end.clone() } else { t + length };
                    h *= if last || rows + 3 >= ROWS { 0.95 } else { 1.5 };
                } else {
                    h = near(&length) * 0.5;
                }
                if self.evaluations > MOST {
                    return out;
                }
            }
            out.push(state.iter().map(near).collect());
        }
        out
    }
}

/// Random formulas.
struct Formulas {
    draws: Draws,
    states: usize,
}

impl Formulas {
    fn one<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[self.draws.below(of.len() as u64) as usize]
    }

    /// A decimal between `low` and `high`, some of them numbers of binary64.
    fn number(&mut self, low: u64, high: u64) -> String {
        let whole = low + self.draws.below(high - low);
        let part = self.draws.below(1000);
        if self.draws.below(3) == 0 { format!("{whole}.{:03}", part / 125 * 125) } else { format!("{whole}.{part:03}") }
    }

    fn state(&mut self) -> String {
        format!("x{}", self.draws.below(self.states as u64))
    }

    /// A formula of moderate size whose values and slopes are moderate where those of the states are.
    fn tree(&mut self, depth: usize) -> String {
        if depth == 0 {
            let x = self.state();
            let c = self.number(0, 3);
            return if self.draws.below(4) == 0 { c } else { format!("{c}*{x}") };
        }
        let a = self.tree(depth - 1);
        let shape = self.one(&[
            "(A+B)",
            "(A-B)",
            "A*sin(B)",
            "sin(A)",
            "cos(A)",
            "tanh(A)",
            "exp(-(A)^2)",
            "sqrt(1+(A)^2)",
            "ln(2+(A)^2)",
            "B/(1.5+sin(A))",
            "asin(0.9*sin(A))",
            "acos(0.9*cos(A))",
            "tan(0.5*tanh(A))",
            "sinh(tanh(A))",
            "cosh(sin(A))",
            "atan(A)",
            "atan2(A,1+(B)^2)",
            "(A)^3/(1+(A)^2)",
            "abs(3+sin(A))*B",
            "pow(1+(A)^2,0.3)",
            "pow(1+(A)^2,sin(B))",
            "cos(atan2(A,1+(B)^2))",
            "sin(A)^5",
            "(2+cos(A))^-3",
            "agm(2,3)*sin(A)",
        ]);
        let b = if shape.contains('B') { self.tree(depth - 1) } else { String::new() };
        shape.replace('A', &format!("({a})")).replace('B', &format!("({b})"))
    }

    /// A function with a step or a peak at u = 0.
    fn steep(&mut self, u: &str) -> String {
        let shape = self.one(&[
            "tanh(U)",
            "tanh(U)",
            "tanh(U)^2",
            "exp(-(U)^2)",
            "1/(1+exp(U))",
            "1/(1+exp(-(U)))",
            "1/cosh(U)^2",
            "atan(U)",
            "1/(1+(U)^2)",
            "(U)/sqrt(1+(U)^2)",
            "ln(1+exp(-(U)^2))",
            "sin(atan2(U,1))",
            "atan2(U,1)",
            "sqrt(1+tanh(U))*exp(-(U)^2)",
            "cosh(tanh(U))",
            "asin(0.999*tanh(U))",
            "exp(tanh(U))",
        ]);
        shape.replace('U', u)
    }

    /// A function that is singular a little beside u = 0.
    fn singular(&mut self, u: &str) -> String {
        let e = self.one(&["0.1", "0.01", "0.001", "0.0001"]);
        let shape = self.one(&[
            "1/(E+(U)^2)",
            "sqrt(E+(U)^2)",
            "ln(E+(U)^2)",
            "atan2(U,E)",
            "pow(E+(U)^2,0.3)",
            "pow(E+(U)^2,-0.7)",
            "cos(atan2(U,E))",
            "asin((1-E)*sin(U))",
            "acos((1-E)*cos(U))",
            "(E+(U)^2)^-3",
            "tan((1.57-E)*cos(U))",
            "1/(1+E+cos(U))",
        ]);
        format!("{e}*{}", shape.replace('U', u).replace('E', e))
    }

    /// Equations for the states, and how long the motion lasts.
    fn system(&mut self) -> (Vec<String>, f64) {
        let kind = self.draws.below(6);
        self.states = 2 + self.draws.below(2) as usize;
        let mut out = Vec::new();
        let span = match kind {
            0 | 1 => {
                self.states = 2;
                let at = self.number(0, 1);
                let by = self.one(&["3", "10", "40", "100", "300"]);
                let u = format!("{by}*(x0-{at})");
                let rate = if kind == 0 { self.steep(&u) } else { self.singular(&u) };
                out.push("x0' = 1".to_owned());
                let more = self.one(&["", "", "-x1", "+cos(x0)", "-0.5*sin(x1)", "*x1"]);
                out.push(format!("x1' = {rate}{more}"));
                1.5
            }
            // Stiff.
            2 => {
                self.states = 2;
                let by = self.one(&["5", "30", "100"]);
                let (goal, other) = (self.tree(1), self.tree(1));
                out.push(format!("x0' = 0.3-0.1*sin({other})"));
                out.push(format!("x1' = -{by}*(x1-sin({goal}))"));
                1.0
            }
            // Long, with a conserved energy or a limit cycle, some driven.
            3 => {
                self.states = 2;
                let force = self.one(&[
                    "-sin(x0)",
                    "-x0-x0^3",
                    "-tanh(3*x0)",
                    "-x0/sqrt(1+x0^2)",
                    "-x0*exp(-x0^2/9)",
                    "(1-x0^2)*x1-x0",
                ]);
                let by = self.one(&["", "", "+0.1*cos(t)"]);
                out.push("x0' = x1".to_owned());
                out.push(format!("x1' = {force}{by}"));
                20.0
            }
            _ => {
                for i in 0..self.states {
                    let depth = 1 + self.draws.below(2) as usize;
                    out.push(format!("x{i}' = {}-0.3*x{i}", self.tree(depth)));
                }
                2.0
            }
        };
        (out, span)
    }

    fn start(&mut self) -> Vec<String> {
        (0..self.states)
            .map(|_| {
                let x = self.number(0, 1);
                if self.draws.below(2) == 0 { format!("-{x}") } else { x }
            })
            .collect()
    }
}

/// A motion by both estimates, its largest error as a share of its bound: `None` where there is no motion, or no reference.
fn largest_share(equations: &[String], start: &[String], length: f64, told: &mut String) -> Option<f64> {
    let mut w = World::default();
    let names: Vec<String> = (0..equations.len()).map(|i| format!("x{i}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let lines: Vec<&str> = equations.iter().map(String::as_str).collect();
    let field = w.field(&names, &lines).ok()?;
    let initial: Vec<(&str, &str)> = names.iter().copied().zip(start.iter().map(String::as_str)).collect();
    let motion = w.integrate(&field, &initial, &[], &[], (0.0, length), 0.0).ok()?;
    let orbit = motion.core.orbit.as_ref()?;
    let begin = orbit.trajectory.place(0.0);
    let state = (0..names.len()).map(|i| orbit.trajectory.bounded(begin, i)).collect();
    let plan =
        Plan { constants: orbit.constants.clone(), initial_time: 0.0, state, span: (0.0, length), max_steps: 100_000 };
    let found = [Estimation::Companions, Estimation::Steps].map(|estimation| {
        Trajectory::integrate(&orbit.field.flow, std::slice::from_ref(&plan), estimation, &|| false)?.pop()?.ok()
    });
    let leaves: Vec<Leaf> = [w.leaf("t")].into_iter().chain(field.states().iter().copied()).collect();
    let tape = Tape::compile(&w.graph, &leaves, field.rates()).ok()?;
    let exact: Vec<_> = start.iter().map(|text| w.e(text)).collect();
    let exact = Tape::compile(&w.graph, &[], &exact).ok()?;
    let exact = exact.evaluate(&(), &[], &mut exact.slots::<Long>(&()));
    let exact: Vec<FBig> = exact.into_iter().map(|x| x.ok().map(|x| x.0)).collect::<Option<_>>()?;
    let times: Vec<f64> = (1..=6).map(|i| length * f64::from(i) / 6.0).collect();
    let truth = Reference { tape, evaluations: 0 }.along(0.0, exact, &times);
    let mut worst: f64 = 0.0;
    for trajectory in found.into_iter().flatten() {
        let reach = trajectory.reach().1;
        for (&t, truth) in times.iter().zip(&truth).filter(|(t, _)| **t <= reach) {
            for (i, x) in truth.iter().enumerate() {
                let Bounded { value, error } = trajectory.bounded(trajectory.place(t), i);
                // The reference is rounded, too, as it is told.
                let off = ((value - x).abs() - f64::EPSILON * x.abs()).max(0.0);
                if off > worst * error {
                    worst = off / error;
                    told.clear();
                    let _ = write!(
                        told,
                        "{equations:?} from {start:?}: x{i}({t}) = {x:e} is off by {off:e}, bound {error:e}"
                    );
                }
            }
        }
    }
    (!truth.is_empty()).then_some(worst)
}

#[test]
fn no_motion_is_farther_off_than_its_bound() {
    let asked = |name: &str, usual: u64| std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(usual);
    let (count, seed) = (asked("REDERIVE_MOTIONS", 8), asked("REDERIVE_SEED", 41));
    let (mut compared, mut wrong) = (0, Vec::new());
    for n in 0..count {
        let mut told = String::new();
        let mut formulas = Formulas { draws: Draws::new(seed.wrapping_mul(1_000_003).wrapping_add(n)), states: 2 };
        let (equations, length) = formulas.system();
        let start = formulas.start();
        let Some(share) = largest_share(&equations, &start, length, &mut told) else { continue };
        compared += 1;
        if share > 1.0 {
            wrong.push(format!("{n}: {share:.1} times its bound: {told}"));
        }
    }
    assert!(wrong.is_empty(), "{} of {compared}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(4 * compared > 3 * count, "{compared} of {count} have a reference");
}

/// Steps far within which the function is 1, or 0, for binary64: a series that starts there must know how far from it.
#[test]
fn a_step_that_is_below_the_last_digit_where_a_series_starts_is_followed() {
    for (by, at) in [("40", "-0.82"), ("100", "-0.7"), ("300", "-0.82"), ("300", "-0.31")] {
        let equations = ["x0' = 1".to_owned(), format!("x1' = tanh({by}*x0)")];
        let mut told = String::new();
        let share = largest_share(&equations, &[at.to_owned(), "0".to_owned()], 1.0, &mut told);
        assert!(share.is_some_and(|share| share <= 1.0), "{share:?}: {told}");
    }
}
