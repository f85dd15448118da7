//! Searches along an enclosed motion end when they should, and are not repeated.

use super::cover::{Along, Judgement, Ranges, Selection};
use crate::flow::{Enclosure, Setup, Source};
use crate::flow_support::World;
use std::cell::Cell;

/// q = cos t, with q² + p² − 1 and q as what is looked at.
fn oscillator() -> (Along, Selection, Selection) {
    let mut w = World::default();
    let field = w.field(&["q", "p"], &["q' = p", "p' = -q"]).expect("solvable");
    let setup = Setup {
        time: w.leaf("t"),
        span: (0.0, 10.0),
        initial_time: 0.0,
        parameters: Vec::new(),
        source: Source::Integrated { field: &field, initial: w.pairs(&[("q", "1"), ("p", "0")]) },
        observables: Vec::new(),
    };
    let (energy, q) = (w.e("q^2 + p^2 - 1"), w.e("q"));
    let enclosure = Enclosure::new(&mut w.graph, &setup, None).expect("a motion");
    let mut along = Along::new(enclosure, w.graph, (0.0, 10.0));
    let places = [along.difference(energy).expect("known"), along.difference(q).expect("known")];
    along.compile().expect("known");
    let [energy, q] = places.map(|place| Selection::new(vec![place]));
    (along, energy, q)
}

#[test]
fn what_is_true_is_settled_by_the_first_stretches() {
    let (mut along, energy, _) = oscillator();
    let small = |_: crate::number::Interval, ranges: &Ranges| match &ranges[0] {
        Ok(reach) if reach.range().magnitude() < 1e-13 => Judgement::Settled,
        other => Judgement::Open(format!("{other:?}")),
    };
    let looked = along.cover(&energy, small, |_| true);
    assert_eq!(looked, Ok(along.pieces().len()));
}

/// A search that refines for ever is stopped by counting, at the same place on every machine.
#[test]
fn an_endless_search_reaches_the_limit_of_work() {
    let (mut along, energy, _) = oscillator();
    let never = |time: crate::number::Interval, _: &Ranges| match time.width() > 2.5e-5 {
        true => Judgement::Open("too long".to_owned()),
        false => Judgement::Settled,
    };
    let first = along.cover(&energy, never, |_| false).expect_err("too much");
    assert!(first.contains("work limit of 400000 operations") && first.contains("t = "), "{first}");
    // Without a new allowance the next search ends at once; with one it comes as far as the first.
    assert!(along.cover(&energy, never, |_| false).expect_err("nothing left").contains("work limit"));
    along.refill();
    assert_eq!(along.cover(&energy, never, |_| false), Err(first));
    // All claims of a motion together have a limit too.
    let mut last = String::new();
    for _ in 0..40 {
        along.refill();
        last = along.cover(&energy, never, |_| false).expect_err("too much");
    }
    assert!(last.contains("for the motion"), "{last}");
}

/// A bound that is too wide at one time ends a search after one stretch.
#[test]
fn what_no_shorter_stretch_could_help_is_given_up_at_once() {
    let (mut along, _, q) = oscillator();
    let (judged, asked) = (Cell::new(0), Cell::new(0));
    let judge = |_: crate::number::Interval, _: &Ranges| {
        judged.set(judged.get() + 1);
        Judgement::Open("open".to_owned())
    };
    let hopeless = |ranges: &Ranges| {
        asked.set(asked.get() + 1);
        // At a single time, q is known to the last digits.
        assert!(ranges[0].as_ref().is_ok_and(|reach| reach.range().width() < 1e-13));
        true
    };
    let why = along.cover(&q, judge, hopeless).expect_err("hopeless");
    assert!(why.contains("too wide"), "{why}");
    assert_eq!((judged.get(), asked.get()), (1, 1));
}

/// A presupposition is looked at once for each precision, and its answer is that of its own precision.
#[test]
fn presuppositions_are_shared_by_precision_only() {
    let (mut along, ..) = oscillator();
    let calls = Cell::new(0);
    let mut ask = |precision: f64, answer: Result<(), String>| {
        along.presuppose((vec![(0, 0)], precision.to_bits()), |_| {
            calls.set(calls.get() + 1);
            answer
        })
    };
    assert!(ask(1e-3, Ok(())).is_ok());
    assert!(ask(1e-3, Err("not asked again".to_owned())).is_ok());
    assert!(ask(1e-12, Err("too fine".to_owned())).is_err());
    assert!(ask(1e-12, Ok(())).is_err() && ask(1e-3, Err(String::new())).is_ok());
    assert_eq!(calls.get(), 2);
}
