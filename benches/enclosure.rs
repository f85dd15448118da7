//! Validated integration of the free rigid body, I = (1, 2, 3), Ω(0) = (0.01, 1, 0.01), R(0) = 1: time and final width.
//! `cargo bench --bench enclosure`. Widths are printed first.

#[path = "../tests/flow_support/mod.rs"]
mod flow_support;

use flow_support::{UNIT, World, rigid_states};
use rederive::flow::{Enclosure, Setup, Source, VectorField};
use rederive::number::Interval;

/// Euler's equations alone.
fn euler(w: &mut World) -> VectorField {
    let equations = [("I1*O1'", "(I2-I3)*O2*O3"), ("I2*O2'", "(I3-I1)*O3*O1"), ("I3*O3'", "(I1-I2)*O1*O2")];
    let equations: Vec<_> = equations.iter().map(|&(l, r)| (w.e(l), w.e(r))).collect();
    let states: Vec<_> = ["O1", "O2", "O3"].map(|n| w.symbol(n)).to_vec();
    let time = w.leaf("t");
    VectorField::solve(&mut w.graph, Some(time), &states, &equations).expect("solvable")
}

/// The enclosure; `radius` widens the initial angular velocity.
fn enclose(rotation: bool, span: f64, radius: f64) -> Enclosure {
    let mut w = World::default();
    let field = if rotation { flow_support::rigid_body(&mut w) } else { euler(&mut w) };
    let velocity = ["0.01", "1", "0.01"];
    let values: Vec<(&str, &str)> = if rotation {
        rigid_states().into_iter().zip(UNIT.into_iter().chain(velocity)).collect()
    } else {
        ["O1", "O2", "O3"].into_iter().zip(velocity).collect()
    };
    let initial = w.pairs(&values);
    let parameters = w.pairs(&[("I1", "1"), ("I2", "2"), ("I3", "3")]);
    let setup = Setup {
        time: w.leaf("t"),
        span: (0.0, span),
        initial_time: 0.0,
        parameters,
        source: Source::Integrated { field: &field, initial, start: Default::default() },
        observables: Vec::new(),
    };
    let enclosure = Enclosure::new(&mut w.graph, &setup, None).expect("a motion");
    if radius == 0.0 {
        return enclosure;
    }
    let start = enclosure.state(Interval::point(0.0)).expect("a start");
    let wide: Vec<Interval> = start.iter().map(|x| Interval::ball(x.mid(), radius)).collect();
    enclosure.restart(&wide).expect("integrated")
}

const CASES: [(&str, bool, f64, f64); 5] = [
    ("3 unknowns, T = 20", false, 20.0, 0.0),
    ("3 unknowns, T = 100", false, 100.0, 0.0),
    ("3 unknowns, radius 1e-10, T = 20", false, 20.0, 1e-10),
    ("12 unknowns, T = 20", true, 20.0, 0.0),
    ("12 unknowns, T = 100", true, 100.0, 0.0),
];

/// CAPD 6.1 (`C0TripletonSet`, order 20) on the same problems: milliseconds, on a faster machine than most, and final width.
const CAPD: [(f64, f64); 5] = [(4.1, 7e-13), (20.0, 7e-11), (4.0, 1.6e-9), (91.0, 2.7e-12), (432.0, 1.6e-9)];

fn main() {
    for ((name, rotation, span, radius), (capd_time, capd_width)) in CASES.into_iter().zip(CAPD) {
        let enclosure = enclose(rotation, span, radius);
        let capd = format!("CAPD {capd_width:.1e} in {capd_time} ms");
        let width = match enclosure.state(Interval::point(span)) {
            Some(state) => format!("{:.1e}", state.iter().map(Interval::width).fold(0.0, f64::max)),
            None => format!("{:?}", enclosure.stop()),
        };
        println!("{name}: {} steps, final width {width}; {capd}", enclosure.steps());
    }
    divan::main();
}

/// The whole of it: compilation of the tapes, and integration.
#[divan::bench(args = 0..CASES.len(), sample_count = 7, sample_size = 1)]
fn enclosures(bencher: divan::Bencher, case: usize) {
    let (_, rotation, span, radius) = CASES[case];
    bencher.bench_local(|| enclose(rotation, span, radius).steps());
}
