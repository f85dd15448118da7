//! What prints the same means the same: two texts that LaTeX sets alike have one meaning, or are refused.
//!
//! The oracle is written from what TeX does, not from the reader: [`typeset`] drops what leaves no ink (spaces, braces,
//! `\left`), takes arguments and scripts as TeX takes them, and lets digits touch.

use crate::latex_support::{self, World};
use rederive::expr::Expr;
use rederive::latex::syntax::{Node, NodeKind, to_latex};
use rederive::latex::{Role, elaborate_expression, parse};
use std::collections::BTreeMap;

fn world() -> World {
    use Role::{Observable, Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with("b", Parameter, "")
        .with("k", Parameter, "")
        .with("t_0", Parameter, "")
        .with("x", State, "")
        .with("y", State, "")
        .with("E", Observable, "")
        .with(r"\theta", Observable, "")
        .with(r"{\bf u}", State, "3")
}

// ---- what TeX sets -------------------------------------------------------------------------------------------------

/// Pieces of a text: commands, braces, single characters; spaces are gone.
fn pieces(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '\\' => {
                let mut command = String::from('\\');
                while let Some(letter) = chars.next_if(char::is_ascii_alphabetic) {
                    command.push(letter);
                }
                if command.len() == 1 {
                    command.extend(chars.next());
                }
                if !["\\left", "\\right", "\\,", "\\ ", "\\!", "\\;"].contains(&command.as_str()) {
                    out.push(command);
                }
            }
            ' ' => {}
            c => out.push(c.to_string()),
        }
    }
    out
}

/// One argument of a command or a script: a group, or one piece; what it leaves as ink.
fn argument(pieces: &[String], at: &mut usize) -> Option<String> {
    let first = pieces.get(*at)?;
    *at += 1;
    if first == "{" {
        let inner = row(pieces, at)?;
        (pieces.get(*at)? == "}").then(|| *at += 1)?;
        return Some(inner);
    }
    match first.as_str() {
        "}" => None,
        // A macro brings its arguments along.
        r"\frac" => Some(format!("⟨{}/{}⟩", argument(pieces, at)?, argument(pieces, at)?)),
        r"\sqrt" => Some(format!("√⟨{}⟩", argument(pieces, at)?)),
        r"\dot" => Some(format!("˙⟨{}⟩", argument(pieces, at)?)),
        _ => Some(first.clone()),
    }
}

/// The ink of everything up to a brace that closes.
fn row(pieces: &[String], at: &mut usize) -> Option<String> {
    let mut out = String::new();
    // TeX sets the scripts of one place at once, whichever came first.
    let (mut sub, mut sup): (Option<String>, Option<String>) = (None, None);
    let flush = |out: &mut String, sub: &mut Option<String>, sup: &mut Option<String>| {
        for (mark, script) in [('↓', sub.take()), ('↑', sup.take())] {
            if let Some(script) = script {
                out.push_str(&format!("{mark}⟨{script}⟩"));
            }
        }
    };
    while let Some(piece) = pieces.get(*at) {
        match piece.as_str() {
            "}" => break,
            "_" | "^" => {
                *at += 1;
                let script = argument(pieces, at)?;
                let place = if piece == "_" { &mut sub } else { &mut sup };
                if place.is_some() {
                    return None;
                }
                *place = Some(script);
            }
            "{" => {
                let inner = argument(pieces, at)?;
                if inner.starts_with(['↓', '↑']) || inner.is_empty() {
                    // Scripts of nothing stand where those of what is before would.
                    out.push_str(&inner);
                } else {
                    flush(&mut out, &mut sub, &mut sup);
                    out.push_str(&inner);
                }
            }
            _ => {
                flush(&mut out, &mut sub, &mut sup);
                let ink = argument(pieces, at)?;
                // Letters of a command do not run into a letter behind it.
                out.push_str(&ink);
                if ink.starts_with('\\') {
                    out.push('·');
                }
            }
        }
    }
    flush(&mut out, &mut sub, &mut sup);
    Some(out)
}

/// What a text leaves as ink; `None` where TeX would stop with an error.
fn typeset(text: &str) -> Option<String> {
    let pieces = pieces(text);
    let mut at = 0;
    let out = row(&pieces, &mut at)?;
    (at == pieces.len()).then_some(out)
}

#[test]
fn the_oracle_knows_what_tex_prints() {
    for (a, b) in [
        (r"x{\left(0\right)}", "x(0)"),
        (r"\cos{2}{1}", r"\cos21"),
        (r"\frac12", r"\frac{1}{2}"),
        ("{a+b}c", "a+bc"),
        ("x_1^2", "x^2_{1}"),
        ("x{}_1", "{x}_1"),
        (r"\sin^2 1 0", r"\sin^{2}10"),
    ] {
        assert!(typeset(a).is_some());
        assert_eq!(typeset(a), typeset(b), "{a} and {b}");
    }
    for (a, b) in [("x^12", "x^{12}"), (r"\frac123", r"\frac{12}{3}"), (r"\sqrt ab", r"\sqrt{ab}"), ("x(0)", "x0")] {
        assert_ne!(typeset(a), typeset(b), "{a} and {b}");
    }
}

// ---- respellings ---------------------------------------------------------------------------------------------------

/// A reproducible source of numbers (splitmix64).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n.max(1) as u64) as usize
    }
}

/// What random formulas are made of.
const ATOMS: &[&str] = &[
    "x",
    "y",
    "a",
    "b",
    "k",
    "t",
    "E",
    "0",
    "1",
    "2",
    "12",
    r"\theta",
    r"\dot x",
    r"{\bf u}_1",
    "x(0)",
    "t_0",
    "e",
    r"\pi",
    "(0)",
    "(x)",
    "(a+b)",
    "(1)",
    "[0]",
    "(t_0)",
    "+",
    "-",
    "=",
    "/",
    "^2",
    "^{2}",
    "_1",
    "^{-1}",
    r"\cos",
    r"\sin",
    r"\sin^2",
    r"\frac{x}{2}",
    r"\frac{dx}{dt}",
    r"\frac{d}{dt}",
    r"\frac12",
    r"\sqrt x",
    r"\sqrt{x+y}",
    r"\left|x\right|",
    "|",
    "(",
    ")",
    r"\cdot",
    "'",
    "!",
    ".",
    ",",
    r"\left(0\right)",
    r"\ln",
    r"\times",
    r"\operatorname{tr}",
    r"\dot{x}(0)",
    r"|_{t=0}",
];

/// A random text of a few atoms.
fn formula(dice: &mut Dice) -> String {
    let n = 1 + dice.below(6);
    (0..n).map(|_| ATOMS[dice.below(ATOMS.len())]).collect::<Vec<_>>().join(" ")
}

/// The same with braces, empty groups and spaces where they leave no ink.
fn respelled(text: &str, dice: &mut Dice) -> String {
    let mut parts = pieces(text);
    for _ in 0..1 + dice.below(3) {
        match dice.below(4) {
            0 => {
                let at = dice.below(parts.len() + 1);
                parts.insert(at, "{}".to_owned());
            }
            1 => {
                let at = dice.below(parts.len() + 1);
                parts.insert(at, " ".to_owned());
            }
            _ => {
                let (a, b) = (dice.below(parts.len() + 1), dice.below(parts.len() + 1));
                let (from, to) = (a.min(b), a.max(b));
                parts.insert(to, "}".to_owned());
                parts.insert(from, "{".to_owned());
            }
        }
        parts =
            parts.into_iter().flat_map(|p| if p == "{}" { vec!["{".into(), "}".into()] } else { vec![p] }).collect();
    }
    let mut out = String::new();
    for part in parts {
        let command = out
            .rsplit('\\')
            .next()
            .is_some_and(|tail| tail.len() < out.len() && tail.bytes().all(|b| b.is_ascii_alphabetic()));
        if command && part.starts_with(|c: char| c.is_ascii_alphabetic()) {
            out.push(' ');
        }
        out.push_str(&part);
    }
    out
}

/// What a text means, where it is read: the expressions of an expression, or of all sides.
fn meaning(w: &mut World, text: &str) -> Option<Vec<Expr>> {
    if let Ok(statements) = w.try_read(text) {
        let relations = statements.into_iter().flat_map(|s| s.relations);
        return Some(relations.flat_map(|r| r.left.components.into_iter().chain(r.right.components)).collect());
    }
    w.try_expression(text).ok().map(|t| t.components)
}

/// How many texts are tried: more with `REDERIVE_LONG`.
fn rounds() -> usize {
    if std::env::var_os("REDERIVE_LONG").is_some() { 3_000_000 } else { 60_000 }
}

#[test]
fn respelled_texts_mean_the_same() {
    let mut w = world();
    let mut dice = Dice(11);
    let (mut same, mut refused) = (0, 0);
    for _ in 0..rounds() {
        let text = formula(&mut dice);
        let other = respelled(&text, &mut dice);
        let (Some(ink), Some(again)) = (typeset(&text), typeset(&other)) else { continue };
        if ink != again {
            continue;
        }
        match (meaning(&mut w, &text), meaning(&mut w, &other)) {
            (Some(a), Some(b)) => {
                assert_eq!(a, b, "`{text}` and `{other}` print the same");
                same += 1;
            }
            (None, None) => {}
            _ => refused += 1,
        }
    }
    assert!(same > rounds() / 40, "{same} pairs were compared, in {refused} one was refused");
}

#[test]
fn texts_that_happen_to_print_the_same_mean_the_same() {
    let mut w = world();
    let mut dice = Dice(12);
    let mut seen: BTreeMap<String, (String, Vec<Expr>)> = BTreeMap::new();
    let mut met = 0;
    for _ in 0..rounds() {
        let text = formula(&mut dice);
        let (Some(ink), Some(means)) = (typeset(&text), meaning(&mut w, &text)) else { continue };
        if let Some((other, before)) = seen.get(&ink) {
            met += usize::from(*other != text);
            assert_eq!(*before, means, "`{text}` and `{other}` print the same");
        }
        seen.entry(ink).or_insert((text, means));
    }
    assert!(met > 100, "{met}");
}

/// Whether expressions have the same values: other groupings of one product are other expressions.
fn same_values(w: &World, left: &[Expr], right: &[Expr]) -> bool {
    let close = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => latex_support::close(&[*a], &[*b]),
        (a, b) => a.is_none() == b.is_none(),
    };
    (1..3).map(latex_support::Point::new).all(|p| {
        let (a, b) = (w.values(left, &p), w.values(right, &p));
        a.len() == b.len() && a.iter().zip(&b).all(close)
    })
}

#[test]
fn what_is_written_is_read() {
    let mut w = world();
    let mut dice = Dice(13);
    let mut read = 0;
    for _ in 0..rounds() {
        let text = formula(&mut dice);
        let Some(means) = meaning(&mut w, &text) else { continue };
        let chains = parse(&text, &w.scope).unwrap_or_else(|p| panic!("{}", latex_support::shown(&text, &p)));
        let written = chains.iter().map(to_latex).collect::<Vec<_>>().join(r",\quad ");
        let Some(again) = meaning(&mut w, &written) else { panic!("`{text}` is written as `{written}`") };
        assert!(same_values(&w, &means, &again), "`{text}` is written as `{written}`");
        read += 1;
    }
    assert!(read > rounds() / 40, "{read}");
}

/// A tree with two factors of a product exchanged, or with a factor taken twice: what variants of a formula are made of.
fn altered(node: &Node, dice: &mut Dice) -> Node {
    let mut out = node.clone();
    match &mut out.kind {
        NodeKind::Product(parts) => {
            let (a, b) = (dice.below(parts.len()), dice.below(parts.len()));
            parts.swap(a, b);
        }
        NodeKind::Sum(terms) => {
            for (_, term) in terms {
                *term = altered(term, dice);
            }
        }
        _ => {}
    }
    out
}

#[test]
fn what_is_altered_is_written_so_that_it_is_read_or_refused() {
    let mut w = world();
    let mut dice = Dice(14);
    let (mut read, mut refused) = (0, 0);
    for _ in 0..rounds() {
        let text = formula(&mut dice);
        let Ok(mut chains) = parse(&text, &w.scope) else { continue };
        let Some(mut chain) = chains.pop().filter(|c| c.relations.is_empty()) else { continue };
        let node = altered(&chain.sides[0], &mut dice);
        let Ok(means) = elaborate_expression(&node, &w.scope, &mut w.graph) else { continue };
        chain.sides[0] = node;
        let written = to_latex(&chain);
        match meaning(&mut w, &written) {
            Some(again) => {
                assert!(same_values(&w, &means.components, &again), "`{text}` altered is written as `{written}`");
                read += 1;
            }
            None => refused += 1,
        }
    }
    assert!(read > 20 * refused, "{read} were read, {refused} refused");
}

// ---- by hand -------------------------------------------------------------------------------------------------------

#[test]
fn values_at_a_time_in_any_braces() {
    let mut w = world();
    for (text, plain) in [
        ("x{(0)}", "x(0)"),
        (r"x{\left(0\right)}", "x(0)"),
        (r"x\left({0}\right)", "x(0)"),
        (r"{{x}}{{(0)}}", "x(0)"),
        (r"\dot x{(0)}", r"\dot x(0)"),
        (r"{\dot x}(0)", r"\dot x(0)"),
        (r"E{(0)}", "E(0)"),
        (r"x{\left(0\right)}^{2}", "x(0)^2"),
        (r"{\bf u}_{1}{(0)}", r"{\bf u}_1(0)"),
        (r"x{(t)}", "x"),
        (r"\cos{\left(x\right)}", r"\cos(x)"),
        (r"\left|{x+1}\right|", r"\left|x+1\right|"),
        (r"\frac{d{x}}{d{t}}", r"\dot x"),
        (r"\frac{d^{2}}{dt^{2}}x{\left(t \right)}", r"\ddot x"),
    ] {
        assert_eq!(w.expression(text), w.expression(plain), "{text}");
    }
}

#[test]
fn what_is_printed_otherwise_than_it_was_meant_is_refused() {
    let w = world();
    for text in [
        r"\cos2 1=0",
        r"\cos{2}{1}=0",
        r"\cos{2}1=0",
        r"\cos2{1}=0",
        r"\cos{{2}1}=0",
        r"{\cos2}1=0",
        r"\sin^2 1 0=0",
        r"\sin^{2}{1}{0}=0",
        "x=1 2",
        "x={1}{2}",
        "x=1{}2",
        "x=1{2}",
        "x={1}2",
        r"x=1\,2",
        "x=2. 3=x",
        "x=2.{3}=x",
        "x=2{.}3",
        "x=1{,}5",
        "x=2{a+b}",
        "x=a-{b-k}",
        "x={a+b}k",
        "x={a+b}^2",
        "x={ab}^2",
        r"x={\sin x}y",
        r"x=\sin{x}y",
        "x={a/b}k",
        "x{(0)y}^2=0",
        "x=[0]",
        "x[0]=0",
        "(x+y)[0]=0",
        "x^}2{=0",
        r"x={\frac}12",
        "x={x^}2",
        "(x(0))(0)=0",
        "x(0)(0)=0",
        "(a+b)(0)=0",
    ] {
        let mut w = w.clone();
        if text == "x=[0]" {
            // Brackets alone are brackets.
            assert!(w.try_read(text).is_ok());
            continue;
        }
        assert!(w.try_read(text).is_err(), "{text}");
    }
}
