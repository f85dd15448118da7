//! Systems whose motions are known in closed form, with many digits: what an enclosure must contain.
#![allow(dead_code, reason = "each user needs another part")]

use crate::flow_support::World;
use dashu_float::{FBig, round::mode::HalfEven};
use rederive::flow::{Enclosure, Setup, Source};
use rederive::number::{Draws, Interval};

pub type Exact = FBig<HalfEven, 2>;

/// Bits of the closed forms.
const PRECISION: usize = 160;

pub fn exact(x: f64) -> Exact {
    Exact::try_from(x).expect("finite").with_precision(PRECISION).value()
}

/// A system, where its motions start, and what they are.
pub struct Case {
    pub name: &'static str,
    states: &'static [&'static str],
    equations: &'static [&'static str],
    parameters: &'static [(&'static str, &'static str)],
    pub span: f64,
    /// The centre of a box of starts, and which of its components may vary.
    start: fn(&mut Draws) -> Vec<f64>,
    varies: &'static [bool],
    /// The state at a time, from a start.
    solution: fn(&[f64], f64) -> Vec<Exact>,
}

fn unit(draws: &mut Draws) -> f64 {
    (draws.bits() >> 11) as f64 / (1_u64 << 53) as f64
}

fn between(draws: &mut Draws, low: f64, high: f64) -> f64 {
    low + (high - low) * unit(draws)
}

/// Start boxes: points, then boxes of these radii.
const RADII: [f64; 4] = [0.0, 0.0, 1e-9, 1e-4];
/// Starts and times per box.
const TIMES: usize = 50;

impl Case {
    fn enclose(&self, start: &[Interval]) -> Enclosure {
        let mut w = World::default();
        let field = w.field(self.states, self.equations).expect("solvable");
        let zeros: Vec<(&str, &str)> = self.states.iter().map(|&s| (s, "1")).collect();
        let setup = Setup {
            time: w.leaf("t"),
            span: (0.0, 1e-3),
            initial_time: 0.0,
            parameters: w.pairs(self.parameters),
            source: Source::Integrated { field: &field, initial: w.pairs(&zeros), start: Default::default() },
            observables: Vec::new(),
        };
        let any = Enclosure::new(&mut w.graph, &setup, None).expect("a motion");
        any.restart_over(start, (0.0, self.span)).expect("integrated")
    }

    /// The width at the end, from a box.
    pub fn final_width(&self, centre: &[f64], radius: f64) -> f64 {
        let start: Vec<Interval> = centre.iter().map(|&x| Interval::ball(x, radius)).collect();
        let enclosure = self.enclose(&start);
        let state = enclosure.state(Interval::point(self.span)).expect("reached");
        state.iter().map(Interval::width).fold(0.0, f64::max)
    }

    /// Whether the enclosure of the motion from a point reaches the end.
    pub fn reaches_the_end(&self, centre: &[f64]) -> bool {
        let start: Vec<Interval> = centre.iter().map(|&x| Interval::point(x)).collect();
        self.enclose(&start).reach().1 == self.span
    }

    /// Compares random starts and times with the closed form: how many there were, and how many states were outside.
    pub fn compare(&self, points: usize, seed: u64) -> (usize, usize) {
        let mut draws = Draws::new(seed);
        let (mut compared, mut outside) = (0, 0);
        for round in 0..points.div_ceil(TIMES) {
            let radius = RADII[round % RADII.len()];
            let centre = (self.start)(&mut draws);
            let start: Vec<Interval> = centre
                .iter()
                .zip(self.varies)
                .map(|(&x, &varies)| if varies { Interval::ball(x, radius) } else { Interval::point(x) })
                .collect();
            let enclosure = self.enclose(&start);
            let (_, end) = enclosure.reach();
            assert!(end > 0.25 * self.span, "{}: {:?}", self.name, enclosure.stop());
            for _ in 0..TIMES {
                let t = between(&mut draws, 0.0, end);
                let x0: Vec<f64> =
                    start.iter().map(|x| between(&mut draws, x.lo(), x.hi()).clamp(x.lo(), x.hi())).collect();
                let state = enclosure.state(Interval::point(t)).expect("in reach");
                // A stretch around the time contains what the time does.
                let wide = Interval::ball(t, 1e-3).intersection(Interval::new(0.0, end).expect("a span"));
                let around = enclosure.state(wide.expect("not empty")).expect("in reach");
                for ((x, w), truth) in state.iter().zip(around).zip((self.solution)(&x0, t)) {
                    compared += 1;
                    let within = |i: &Interval| exact(i.lo()) <= truth && truth <= exact(i.hi());
                    outside += usize::from(!within(x) || !within(&w));
                }
            }
        }
        (compared, outside)
    }
}

/// sn, cn, dn with many digits, for 0 ≤ m < 1 (Abramowitz & Stegun 16.4), m₁ = 1 − m.
fn jacobi(u: Exact, m: Exact, m1: Exact) -> (Exact, Exact, Exact) {
    let (mut a, mut b, mut c) = (vec![exact(1.0)], m1.clone().sqrt(), vec![m.clone().sqrt()]);
    for _ in 0..12 {
        let last = a[a.len() - 1].clone();
        c.push((last.clone() - b.clone()) / exact(2.0));
        a.push((last.clone() + b.clone()) / exact(2.0));
        b = (last * b).sqrt();
        let small = c[c.len() - 1].clone() / a[a.len() - 1].clone();
        if small < exact(1e-24) {
            break;
        }
    }
    let n = a.len() - 1;
    let mut phi = exact((1_u64 << n) as f64) * a[n].clone() * u;
    for k in (1..=n).rev() {
        phi = (phi.clone() + (c[k].clone() / a[k].clone() * phi.sin()).asin()) / exact(2.0);
    }
    let (s, c) = (phi.sin(), phi.cos());
    let dn = (m1 + m * c.clone() * c.clone()).sqrt();
    (s, c, dn)
}

/// The free rigid body with I = (1, 2, 3) and Ω₂(0) = 0 (Landau & Lifshitz, Mechanics, §37).
fn rigid_body(start: &[f64], t: f64) -> Vec<Exact> {
    let (o1, o3) = (exact(start[0]), exact(start[2]));
    let [i1, i2, i3] = [1.0, 2.0, 3.0].map(exact);
    let p2 = i1.clone() * (i1.clone() - i2.clone()) * o1.clone() * o1.clone()
        + i3.clone() * (i3.clone() - i2.clone()) * o3.clone() * o3.clone();
    if p2 < exact(0.0) {
        let mut back = regime([i3, i2, i1], [o3, o1], p2, t);
        back.reverse();
        return back;
    }
    regime([i1, i2, i3], [o1, o3], p2, t)
}

fn regime([i1, i2, i3]: [Exact; 3], [o1, o3]: [Exact; 2], p2: Exact, t: f64) -> Vec<Exact> {
    let p1 = i3.clone() * (i3.clone() - i1.clone()) * o3.clone() * o3.clone();
    let p3 = i1.clone() * (i3.clone() - i1.clone()) * o1.clone() * o1.clone();
    let rate = ((i3.clone() - i2.clone()) * p1.clone() / (i1.clone() * i2.clone() * i3.clone())).sqrt();
    let m = (i2.clone() - i1.clone()) * p3.clone() / ((i3.clone() - i2.clone()) * p1.clone());
    let m1 = (i3.clone() - i1) * p2 / ((i3.clone() - i2.clone()) * p1);
    let (sn, cn, dn) = jacobi(rate * exact(t), m, m1);
    vec![o1 * cn, (p3 / (i2.clone() * (i3 - i2))).sqrt() * sn, o3 * dn]
}

/// Kepler's problem from perihelion, μ = 1, by Kepler's equation.
fn kepler(start: &[f64], t: f64) -> Vec<Exact> {
    let (q, w) = (exact(start[0]), exact(start[3]));
    let one = exact(1.0);
    let e = q.clone() * w.clone() * w - one.clone();
    let a = q / (one.clone() - e.clone());
    let n = (one.clone() / (a.clone() * a.clone() * a.clone())).sqrt();
    let mean = n.clone() * exact(t);
    let mut anomaly = mean.clone();
    for _ in 0..60 {
        let wrong = anomaly.clone() - e.clone() * anomaly.sin() - mean.clone();
        let step = wrong / (one.clone() - e.clone() * anomaly.cos());
        anomaly -= step.clone();
        if step.clone() * step < exact(1e-90) {
            break;
        }
    }
    let (s, c) = (anomaly.sin(), anomaly.cos());
    let b = (one.clone() - e.clone() * e.clone()).sqrt();
    let rate = n / (one - e.clone() * c.clone());
    vec![
        a.clone() * (c.clone() - e),
        a.clone() * b.clone() * s.clone(),
        -(a.clone() * s * rate.clone()),
        a * b * c * rate,
    ]
}

pub const CASES: [Case; 9] = [
    Case {
        name: "decay",
        states: &["x"],
        equations: &["x' = -k*x"],
        parameters: &[("k", "0.75")],
        span: 20.0,
        start: |d| vec![between(d, 0.5, 2.0)],
        varies: &[true],
        solution: |x, t| vec![exact(x[0]) * (exact(-0.75) * exact(t)).exp()],
    },
    Case {
        name: "oscillator",
        states: &["x", "v"],
        equations: &["x' = v", "v' = -4*x"],
        parameters: &[],
        span: 30.0,
        start: |d| vec![between(d, -1.0, 1.0), between(d, -1.0, 1.0)],
        varies: &[true, true],
        solution: |x, t| {
            let angle = exact(2.0) * exact(t);
            let (s, c) = (angle.sin(), angle.cos());
            let (x, v) = (exact(x[0]), exact(x[1]));
            let here = x.clone() * c.clone() + v.clone() * s.clone() / exact(2.0);
            vec![here, v * c - exact(2.0) * x * s]
        },
    },
    Case {
        name: "tanh",
        states: &["x"],
        equations: &["x' = 1 - x^2"],
        parameters: &[],
        span: 10.0,
        start: |d| vec![between(d, -0.75, 0.75)],
        varies: &[true],
        solution: |x, t| {
            let (x, h) = (exact(x[0]), exact(t).tanh());
            vec![(x.clone() + h.clone()) / (exact(1.0) + x * h)]
        },
    },
    Case {
        name: "sech, on the separatrix",
        states: &["x", "v"],
        equations: &["x' = v", "v' = x - 2*x^3"],
        parameters: &[],
        span: 12.0,
        start: |_| vec![1.0, 0.0],
        varies: &[false, false],
        solution: |_, t| {
            let (c, h) = (exact(t).cosh(), exact(t).tanh());
            vec![exact(1.0) / c.clone(), -(h / c)]
        },
    },
    Case {
        name: "pendulum, on the separatrix",
        states: &["x", "v"],
        equations: &["x' = v", "v' = -sin(x)"],
        parameters: &[],
        span: 12.0,
        start: |_| vec![0.0, 2.0],
        varies: &[false, false],
        solution: |_, t| {
            let (c, h) = (exact(t).cosh(), exact(t).sinh());
            vec![exact(2.0) * h.atan(), exact(2.0) / c]
        },
    },
    Case {
        name: "driven",
        states: &["x"],
        equations: &["x' = -2*t*x"],
        parameters: &[],
        span: 2.0,
        start: |d| vec![between(d, 0.5, 2.0)],
        varies: &[true],
        solution: |x, t| vec![exact(x[0]) * (-(exact(t) * exact(t))).exp()],
    },
    Case {
        name: "rest, by a quotient and a root",
        states: &["x"],
        equations: &["x' = x^2/(1 + x) - sqrt(x)*sqrt(x)*x/(1 + x)"],
        parameters: &[],
        span: 5.0,
        start: |d| vec![between(d, 0.5, 2.0)],
        varies: &[true],
        solution: |x, _| vec![exact(x[0])],
    },
    Case {
        name: "rigid body",
        states: &["O1", "O2", "O3"],
        equations: &["I1*O1' = (I2-I3)*O2*O3", "I2*O2' = (I3-I1)*O3*O1", "I3*O3' = (I1-I2)*O1*O2"],
        parameters: &[("I1", "1"), ("I2", "2"), ("I3", "3")],
        span: 20.0,
        start: |d| vec![between(d, 0.25, 1.0), 0.0, between(d, 0.25, 1.0)],
        varies: &[true, false, true],
        solution: rigid_body,
    },
    Case {
        name: "Kepler",
        states: &["x", "y", "u", "v"],
        equations: &["x' = u", "y' = v", "u' = -x/sqrt(x^2+y^2)^3", "v' = -y/sqrt(x^2+y^2)^3"],
        parameters: &[],
        span: 10.0,
        start: |d| vec![between(d, 0.75, 1.0), 0.0, 0.0, between(d, 1.05, 1.2)],
        varies: &[true, false, false, true],
        solution: kepler,
    },
];
