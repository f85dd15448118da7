//! Enclosed motions: widths, ends, angles, dense output.

mod flow_support;

use flow_support::{UNIT, World, rigid_states};
use rederive::flow::{Enclosure, Setup, Source, VectorField};
use rederive::number::Interval;

/// Encloses an integrated motion; observables whose name ends in `~` are angles.
fn enclose(
    w: &mut World,
    field: &VectorField,
    initial: &[(&str, &str)],
    parameters: &[(&str, &str)],
    observables: &[(&str, &str)],
    span: (f64, f64),
) -> Enclosure {
    let setup = Setup {
        time: w.leaf("t"),
        span,
        initial_time: span.0.max(0.0_f64.min(span.1)),
        parameters: w.pairs(parameters),
        source: Source::Integrated { field, initial: w.pairs(initial) },
        observables: w.observables(observables),
    };
    Enclosure::new(&mut w.graph, &setup, None).expect("a motion")
}

fn euler(w: &mut World) -> VectorField {
    let equations = ["I1*O1' = (I2-I3)*O2*O3", "I2*O2' = (I3-I1)*O3*O1", "I3*O3' = (I1-I2)*O1*O2"];
    w.field(&["O1", "O2", "O3"], &equations).expect("solvable")
}

const MOMENTS: [(&str, &str); 3] = [("I1", "1"), ("I2", "2"), ("I3", "3")];
const TUMBLING: [(&str, &str); 3] = [("O1", "0.01"), ("O2", "1"), ("O3", "0.01")];

fn width(enclosure: &Enclosure, t: f64) -> f64 {
    let state = enclosure.state(Interval::point(t));
    state.unwrap_or_else(|| panic!("{:?}", enclosure.stop())).iter().map(Interval::width).fold(0.0, f64::max)
}

#[test]
fn widths_of_the_free_rigid_body() {
    let mut w = World::default();
    let field = euler(&mut w);
    for (span, most) in [(20.0, 7e-13), (100.0, 7e-11)] {
        let e = enclose(&mut w, &field, &TUMBLING, &MOMENTS, &[], (0.0, span));
        println!("3 unknowns, T = {span}: {} steps, {:.1e}", e.steps(), width(&e, span));
        assert!(width(&e, span) < most);
    }
    let e = enclose(&mut w, &field, &TUMBLING, &MOMENTS, &[], (0.0, 20.0));
    let start = e.state(Interval::point(0.0)).expect("a start");
    let wide: Vec<Interval> = start.iter().map(|x| Interval::ball(x.mid(), 1e-10)).collect();
    let e = e.restart(&wide).expect("integrated");
    // What the box really becomes: its corners.
    let mut hull: Option<Vec<Interval>> = None;
    for corner in 0..8 {
        let at = |i: usize| if corner >> i & 1 == 1 { wide[i].hi() } else { wide[i].lo() };
        let point = e.restart(&[0, 1, 2].map(|i| Interval::point(at(i)))).expect("integrated");
        let state = point.state(Interval::point(20.0)).expect("reached");
        hull = Some(match hull {
            None => state,
            Some(h) => h.iter().zip(state).map(|(a, b)| a.hull(b)).collect(),
        });
    }
    let least = hull.expect("corners").iter().map(Interval::width).fold(0.0, f64::max);
    println!("radius 1e-10, T = 20: {} steps, {:.2e}, of which {least:.2e} is real", e.steps(), width(&e, 20.0));
    assert!(width(&e, 20.0) < 1.2 * least);

    let mut w = World::default();
    let field = flow_support::rigid_body(&mut w);
    let initial: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.01", "1", "0.01"])).collect();
    for (span, most) in [(20.0, 2.7e-12), (100.0, 1.6e-9)] {
        let e = enclose(&mut w, &field, &initial, &MOMENTS, &[], (0.0, span));
        println!("12 unknowns, T = {span}: {} steps, {:.1e}", e.steps(), width(&e, span));
        assert!(width(&e, span) < most);
    }
}
