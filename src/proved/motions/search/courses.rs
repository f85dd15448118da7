//! The courses that a search tries: polynomials of the time, by pieces.
//!
//! **In:** a search, as far as it has chosen. **Out:** courses for a component that is free, or for one of which a rate is a formula of what is chosen. **Guaranteed:** a course has the rate
//! that is asked for, exactly; there are boundedly many.

use super::Search;
use crate::expr::{Expr, Rational};
use crate::motions::polynomial::Polynomial;
use crate::motions::scene::Course;
use crate::motions::value::{Stop, Value};

impl Search<'_, '_> {
    /// Courses of what is free: polynomials of low degree, and such as vanish on one side of a time.
    pub(super) fn free(&self) -> Vec<Course> {
        let numbers: Vec<i64> = self.numbers.clone();
        let mut out: Vec<Course> = Vec::new();
        let mut add = |course: Course| {
            if !out.contains(&course) {
                out.push(course);
            }
        };
        let whole = |p: Polynomial| Course::polynomial(p);
        for &n in &numbers {
            add(whole(Polynomial::integers(&[n])));
        }
        let shapes: [&[i64]; 13] = [
            &[0, 1],
            &[0, -1],
            &[0, 0, 1],
            &[0, 0, -1],
            &[2, 0, -1],
            &[1, 0, -1],
            &[0, 2],
            &[0, 1, 1],
            &[1, 1],
            &[1, -1],
            &[2, 1],
            &[0, 0, 0, 1],
            &[0, -2],
        ];
        for at in self.about.iter().rev() {
            for shape in shapes {
                add(whole(shifted(shape, at)));
            }
        }
        // As smooth as is asked, and no more.
        let power = usize::from(self.question.order) + 2;
        let mut single = vec![0; power + 1];
        single[power] = 1;
        let one = Rational::ONE;
        let mut times: Vec<Rational> = self.about.iter().flat_map(|at| [at.clone(), at - &one, at + &one]).collect();
        times.sort();
        times.dedup();
        for n in numbers.iter().copied().filter(|n| *n >= 0) {
            for at in &times {
                let p = shifted(&single, at).add(&Polynomial::integers(&[n]));
                let flat = Polynomial::integers(&[n]);
                add(Course { pieces: vec![(at.clone(), flat.clone())], last: p.clone() });
                add(Course { pieces: vec![(at.clone(), p)], last: flat });
            }
        }
        out
    }

    /// The courses of which a rate is a formula of what is chosen.
    pub(super) fn integrated(&mut self, order: u8, formula: Expr) -> Vec<Course> {
        let Some(course) = self.course(formula) else { return Vec::new() };
        let mut all = vec![course];
        for further in (0..order).rev() {
            // Of the first rates only a few starts.
            let (times, numbers) = match further {
                0 => (self.about.len(), self.numbers.len()),
                _ => (1, 3),
            };
            let mut next = Vec::new();
            for course in &all {
                for at in self.about.iter().take(times).chain(self.scene.breaks().iter().take(2)) {
                    for &n in self.numbers.iter().take(numbers) {
                        let Some(one) = antiderivative(course, at, &Rational::from(n)) else { continue };
                        if !next.contains(&one) {
                            next.push(one);
                        }
                    }
                }
            }
            all = next;
        }
        all
    }

    /// A formula as a course, where it is a polynomial on each piece.
    fn course(&mut self, formula: Expr) -> Option<Course> {
        let values = self.parted(|this| {
            let open = (0..this.scene.cells().len()).step_by(2);
            open.map(|cell| this.scene.value(formula, cell)).collect::<Result<Vec<Value>, Stop>>()
        });
        let mut pieces: Vec<Polynomial> = Vec::new();
        for value in values? {
            let Value::Plain(f, 0) = value else { return None };
            pieces.push(f.as_polynomial()?.clone());
        }
        let last = pieces.pop()?;
        let mut out = Course { pieces: Vec::new(), last };
        for (at, p) in self.scene.breaks().iter().zip(pieces).rev() {
            let next = out.pieces.last().map_or(&out.last, |(_, p)| p);
            if p != *next {
                out.pieces.push((at.clone(), p));
            }
        }
        out.pieces.reverse();
        Some(out)
    }
}

/// A polynomial of the time since another one.
fn shifted(shape: &[i64], at: &Rational) -> Polynomial {
    let since = Polynomial::new(vec![-at.clone(), Rational::ONE]);
    shape.iter().rev().fold(Polynomial::integers(&[]), |sum, &c| {
        // Shapes are of low degree.
        sum.mul(&since).unwrap_or_else(|| Polynomial::integers(&[])).add(&Polynomial::integers(&[c]))
    })
}

/// The antiderivative that has a value at a time; `None` if degrees grow too high.
fn antiderivative(course: &Course, at: &Rational, value: &Rational) -> Option<Course> {
    let mut pieces: Vec<(Rational, Polynomial)> = Vec::new();
    let mut level: Option<(Rational, Rational)> = None;
    let meet = |p: &Polynomial, level: &Option<(Rational, Rational)>| {
        let p = p.integral();
        let lift = level.as_ref().map_or(Rational::ZERO, |(t, v)| v - p.at(t));
        p.add(&Polynomial::constant(lift))
    };
    for (until, p) in &course.pieces {
        let p = meet(p, &level);
        level = Some((until.clone(), p.at(until)));
        pieces.push((until.clone(), p));
    }
    let last = meet(&course.last, &level);
    if last.coefficients().len() > 12 {
        return None;
    }
    let there = pieces.iter().find(|(until, _)| at < until).map_or(&last, |(_, p)| p).at(at);
    let lift = Polynomial::constant(value - there);
    let pieces = pieces.into_iter().map(|(until, p)| (until, p.add(&lift))).collect();
    Some(Course { pieces, last: last.add(&lift) })
}
