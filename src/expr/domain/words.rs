//! The table of domains in words, for the page on the grammar.

use super::super::Op;
use super::{Bound, Change, Edge, Order, Place, Row, Sides, Sign, Slope, Term, row};

impl Term {
    fn words(self) -> &'static str {
        match self {
            Term::First => "a",
            Term::Second => "b",
            Term::Opposite => "−b",
            Term::Cosine => "cos a",
            Term::Sine => "sin a",
            Term::Unit => "1 − a²",
            Term::Excess => "a − 1",
            Term::Product => "a·b",
            Term::Squares => "a² + b²",
            Term::Support => "a + b + \\|b\\|",
        }
    }
}

fn need_words((term, sign): (Term, Sign)) -> String {
    match (term, sign) {
        (Term::Support, _) => "a > 0 or b > 0".to_owned(),
        (_, Sign::Positive) => format!("{} > 0", term.words()),
        (_, Sign::NotNegative) => format!("{} ≥ 0", term.words()),
        (_, Sign::NotZero) => format!("{} ≠ 0", term.words()),
    }
}

fn edge_words(edge: Edge) -> String {
    let place = match edge.place {
        Place::Zero(term) => format!("{} = 0", term.words()),
        Place::ZeroWhile(term, Term::Opposite) => format!("{} = 0, b < 0", term.words()),
        Place::ZeroWhile(term, other) => format!("{} = 0, {} > 0", term.words(), other.words()),
        Place::Infinity => "through ∞".to_owned(),
    };
    let sides = |sides: Sides| match sides {
        Sides::Opposite => ", sides opposite",
        Sides::Alike => ", sides alike",
        Sides::One => ", one side",
    };
    match edge.change {
        Change::Pole(Order::Whole(n), s) => format!("{place}: pole of order {n}{}", sides(s)),
        Change::Pole(Order::Exponent, s) => format!("{place}: pole of order −b{}", sides(s)),
        Change::Log => format!("{place}: logarithmic pole"),
        Change::Jump(1) => format!("{place}: jump of π"),
        Change::Jump(n) => format!("{place}: jump of {n}π"),
        Change::Kink => format!("{place}: kink"),
        Change::Steep => format!("{place}: steep"),
    }
}

fn bound_words(bound: Option<Bound>, low: bool) -> String {
    let Some(Bound { whole, quarter_turns, attained }) = bound else {
        return if low { "(−∞".to_owned() } else { "∞)".to_owned() };
    };
    let minus = |n: i8| if n < 0 { "−" } else { "" };
    let value = match quarter_turns.unsigned_abs() {
        0 => format!("{}{}", minus(whole), whole.unsigned_abs()),
        1 => format!("{}π/2", minus(quarter_turns)),
        2 => format!("{}π", minus(quarter_turns)),
        n => format!("{}{n}π/2", minus(quarter_turns)),
    };
    match (low, attained) {
        (true, true) => format!("[{value}"),
        (true, false) => format!("({value}"),
        (false, true) => format!("{value}]"),
        (false, false) => format!("{value})"),
    }
}

fn slope_words(op: Op, row: &Row) -> String {
    let one = |slope: Slope| match slope {
        Slope::Flat => "–".to_owned(),
        Slope::Rising => "↑".to_owned(),
        Slope::Falling => "↓".to_owned(),
        Slope::Of(term) => format!("as {}", term.words()),
        Slope::Against(term) => format!("against {}", term.words()),
    };
    match op.arity() {
        2 => format!("{}; {}", one(row.slopes[0]), one(row.slopes[1])),
        _ => one(row.slopes[0]),
    }
}

/// A list in words; a dash where there is nothing.
fn listed(all: Vec<String>) -> String {
    if all.is_empty() { "–".to_owned() } else { all.join("; ") }
}

/// The row of an operation as a line of a Markdown table: spelling, needs, edges, range, slopes.
pub fn line(op: Op) -> String {
    let row = row(op);
    let spelling = match op {
        Op::Powi(n) => format!("a^{{{n}}}"),
        op => op.spelling().replace('|', r"\|"),
    };
    let needs = listed(row.needs.iter().copied().map(need_words).collect());
    let edges = listed(row.edges.iter().copied().map(edge_words).collect());
    let range = match (row.range.low, row.range.high) {
        (None, None) => "ℝ".to_owned(),
        (Some(low), Some(high)) if low == high => format!("{{{}}}", low.whole),
        (low, high) => format!("{}, {}", bound_words(low, true), bound_words(high, false)),
    };
    format!("| `{spelling}` | {needs} | {edges} | {range} | {} |", slope_words(op, &row))
}
