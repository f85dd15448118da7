//! Searches along an enclosed motion end when they should, and are not repeated.

use super::cover::{Along, Judgement, Ranges, Selection};
use super::ready::Shown;
use crate::expr::{Graph, Leaf, Shape};
use crate::flow::{Enclosure, Setup, Source, VectorField};
use crate::number::Interval;
use reason::Reason;
use std::cell::Cell;

/// q = cos t, with q² + p² − 1 and q as what is looked at.
fn oscillator() -> (Along, Selection, Selection) {
    let mut graph = Graph::new();
    let [t, q, p] = ["t", "q", "p"].map(|name| graph.declare(name, Shape::scalar(), false));
    let leaf = |symbol, rate| Leaf { rate, ..Leaf::now(symbol, 0) };
    let [now, q_now, p_now] = [t, q, p].map(|symbol| leaf(symbol, 0));
    let [q_rate, p_rate, q_value, p_value] = [leaf(q, 1), leaf(p, 1), q_now, p_now].map(|l| graph.leaf(l));
    let back = graph.neg(q_value);
    let equations = [(q_rate, p_value), (p_rate, back)];
    let field = VectorField::solve(&mut graph, Some(now), &[q, p], &equations).expect("solvable");
    let (zero, one) = (graph.integer(0), graph.integer(1));
    let setup = Setup {
        time: now,
        span: (0.0, 10.0),
        initial_time: 0.0,
        parameters: Vec::new(),
        source: Source::Integrated {
            field: &field,
            initial: vec![(q_now, one), (p_now, zero)],
            start: Default::default(),
        },
        observables: Vec::new(),
    };
    let [qq, pp] = [q_value, p_value].map(|x| graph.powi(x, 2));
    let sum = graph.add(qq, pp);
    let energy = graph.sub(sum, one);
    let enclosure = Enclosure::new(&mut graph, &setup, None).expect("a motion");
    let mut along = Along::new(enclosure, graph, (0.0, 10.0));
    let places = [energy, q_value].map(|e| along.difference(e).expect("known"));
    along.compile().expect("known");
    let [energy, q] = places.map(|place| Selection::new(vec![place]));
    (along, energy, q)
}

#[test]
fn what_is_true_is_settled_by_the_first_stretches() {
    let (mut along, energy, _) = oscillator();
    let small = |_: Interval, ranges: &Ranges| match &ranges[0] {
        Ok(reach) if reach.range().magnitude() < 1e-10 => Judgement::Settled,
        other => Judgement::Open(Reason::quoted(format!("{other:?}"))),
    };
    let looked = along.cover(&energy, small, |_| true);
    assert_eq!(looked, Ok(along.pieces().len()));
}

/// A search that refines for ever is stopped by counting, at the same place on every machine.
#[test]
fn an_endless_search_reaches_the_limit_of_work() {
    let (mut along, energy, _) = oscillator();
    let never = |time: Interval, _: &Ranges| match time.width() > 2.5e-5 {
        true => Judgement::Open(Reason::quoted("too long")),
        false => Judgement::Settled,
    };
    let first = along.cover(&energy, never, |_| false).expect_err("too much");
    assert!(first.to_string().contains("work limit of 400000 operations was reached at t = "), "{first:?}");
    // Without a new allowance the next search ends at once; with one it comes as far as the first.
    assert!(along.cover(&energy, never, |_| false).expect_err("nothing left").to_string().contains("work limit"));
    along.refill();
    assert_eq!(along.cover(&energy, never, |_| false), Err(first));
}

/// A bound that is too wide at one time ends a search after one stretch.
#[test]
fn what_no_shorter_stretch_could_help_is_given_up_at_once() {
    let (mut along, _, q) = oscillator();
    let (judged, asked) = (Cell::new(0), Cell::new(0));
    let judge = |_: Interval, _: &Ranges| {
        judged.set(judged.get() + 1);
        Judgement::Open(Reason::quoted("open"))
    };
    let hopeless = |ranges: &Ranges| {
        asked.set(asked.get() + 1);
        // At a single time, q is known to the last digits.
        assert!(ranges[0].as_ref().is_ok_and(|reach| reach.range().width() < 1e-13));
        true
    };
    let why = along.cover(&q, judge, hopeless).expect_err("hopeless");
    assert!(why.to_string().contains("too wide"), "{why:?}");
    let (from, to) = why.obstacle().expect("a place").0.ends();
    assert_eq!(from, to, "at one time");
    assert_eq!((judged.get(), asked.get()), (1, 1));
}

/// A presupposition is looked at once for each precision, and its answer is that of its own precision.
#[test]
fn presuppositions_are_shared_by_precision_only() {
    let (mut along, ..) = oscillator();
    let calls = Cell::new(0);
    let mut ask = |precision: f64, answer: Shown| {
        let key = (vec![0], "q=0".to_owned(), precision.to_bits());
        along.presuppose(key, |_| {
            calls.set(calls.get() + 1);
            answer
        })
    };
    let yes = || Shown::at_one_place(Reason::quoted(""));
    let no = || Shown::Nothing(Reason::quoted("too fine"));
    assert!(matches!(ask(1e-3, yes()), Shown::Holds(..)));
    assert!(matches!(ask(1e-3, no()), Shown::Holds(..)));
    assert!(matches!(ask(1e-12, no()), Shown::Nothing(_)));
    assert!(matches!(ask(1e-12, yes()), Shown::Nothing(_)) && matches!(ask(1e-3, no()), Shown::Holds(..)));
    assert_eq!(calls.get(), 2);
}
