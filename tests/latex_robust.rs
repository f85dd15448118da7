//! Any text ends quickly in a meaning or in problems whose places lie inside the text.

use crate::latex_support::{COMMENT, World};
use rederive::diag::Problem;
use rederive::latex::Role;
use std::time::{Duration, Instant};

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

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }
}

fn world() -> World {
    World::rigid_body().with("c", Role::Parameter, "").with("k", Role::Parameter, "").with("x", Role::State, "").by(
        r"\lambda",
        Role::Abbreviation,
        r"\frac12\dot x^2",
    )
}

const PIECES: &[&str] = &[
    r"\frac",
    r"\sqrt",
    r"\sin",
    r"\cos^2",
    r"\dot",
    r"\ddot",
    r"\pm",
    r"\mp",
    r"\cdot",
    r"\times",
    r"\lim",
    r"\to",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "^",
    "_",
    "|",
    "&",
    r"\\",
    r"\cr",
    ",",
    ".",
    ";",
    "=",
    r"\ne",
    "<",
    "+",
    "-",
    "/",
    "*",
    "'",
    "0",
    "1",
    "12",
    "3.5",
    "x",
    "t",
    "d",
    "e",
    "I",
    "R",
    "i",
    "j",
    "k",
    r"\Omega",
    r"\theta",
    r"\psi_0",
    r"{\bf m}",
    "_i",
    "_{ij}",
    "_3",
    "^2",
    "^T",
    "^{-1}",
    r"\left",
    r"\right",
    r"\begin{pmatrix}",
    r"\end{pmatrix}",
    r"\begin",
    r"\mathbb{1}",
    r"\operatorname{tr}",
    r"\operatorname",
    r"\label{",
    r"\mathrm{d}",
    r"\frac{d}{dt}",
    r"\epsilon_{ijk}",
    r"\delta_{ij}",
    "(0)",
    "(t)",
    r"\left|",
    r"\right|",
    r"\infty",
    r"\hat",
    r"\rm",
    "é",
    "∂",
    "\u{0}",
    "\\",
    "%",
    "\n",
    "~",
    "$",
    "#",
];

/// Pieces of a text that a person could exchange: commands, numbers, single characters.
fn pieces(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for c in text.chars() {
        match out.last_mut() {
            Some(last) if last.starts_with('\\') && c.is_ascii_alphabetic() => last.push(c),
            Some(last) if last == "\\" && !c.is_whitespace() => last.push(c),
            _ => out.push(c.to_string()),
        }
    }
    out
}

fn mutated(dice: &mut Dice) -> String {
    let mut parts = pieces(dice.of(COMMENT));
    for _ in 0..1 + dice.below(2) {
        let n = parts.len();
        if n < 2 {
            break;
        }
        let (a, b) = (dice.below(n), dice.below(n));
        match dice.below(6) {
            0 => drop(parts.remove(a)),
            1 => parts.insert(a, parts[b].clone()),
            2 => parts.swap(a, b),
            3 => parts.insert(a, dice.of(PIECES).to_owned()),
            4 => parts[a] = dice.of(PIECES).to_owned(),
            _ => {
                let other = pieces(dice.of(COMMENT));
                let from = dice.below(other.len());
                let piece = other[from..(from + 1 + dice.below(8)).min(other.len())].concat();
                parts.insert(a, piece);
            }
        }
    }
    parts.concat()
}

fn random(dice: &mut Dice) -> String {
    let n = 1 + dice.below(40);
    match dice.below(3) {
        0 => (0..n).map(|_| dice.of(PIECES)).collect::<Vec<_>>().join(if dice.below(2) == 0 { " " } else { "" }),
        1 => (0..n).map(|_| char::from(32 + dice.below(95) as u8)).collect(),
        _ => (0..n).filter_map(|_| char::from_u32(dice.below(0x3000) as u32)).collect(),
    }
}

fn sound(text: &str, problems: &[Problem]) {
    assert!(!problems.is_empty(), "{text:?} is refused without a reason");
    for p in problems {
        let inside = p.span.start <= p.span.end && text.get(p.span.clone()).is_some();
        assert!(inside, "{text:?}: {} at {:?}", p.code, p.span);
        assert!(p.code.starts_with("latex::") && !p.message.is_empty(), "{text:?}: {p:?}");
    }
}

#[test]
fn any_text_is_read_or_refused() {
    let original = world();
    let mut dice = Dice(20_200_806);
    let (mut read, mut refused, mut codes) = (0, 0, std::collections::BTreeSet::new());
    for round in 0..12_000 {
        let text = if round % 3 == 0 { random(&mut dice) } else { mutated(&mut dice) };
        let mut w = original.clone();
        let start = Instant::now();
        match w.try_read(&text) {
            Ok(statements) => {
                read += 1;
                for r in statements.iter().flat_map(|s| &s.relations) {
                    assert_eq!(r.left.shape, r.right.shape, "{text}");
                    assert_eq!(r.left.components.len(), r.left.shape.len(), "{text}");
                }
            }
            Err(problems) => {
                refused += 1;
                sound(&text, &problems);
                codes.extend(problems.iter().map(|p| p.code));
            }
        }
        if let Err(problems) = w.try_expression(&text) {
            sound(&text, &problems);
        }
        assert!(start.elapsed() < Duration::from_secs(5), "{text:?} took {:?}", start.elapsed());
    }
    // The dice reach both outcomes, and most reasons.
    assert!(read > 300 && refused > 5000, "{read} read, {refused} refused");
    assert!(codes.len() > 12, "{codes:?}");
}

#[test]
fn any_name_is_declared_or_refused() {
    let original = world();
    let mut dice = Dice(7);
    let mut declared = 0;
    for round in 0..4000 {
        let key = if round % 2 == 0 { random(&mut dice) } else { dice.of(PIECES).to_owned() + dice.of(PIECES) };
        let formula = (dice.below(2) == 0).then(|| mutated(&mut dice));
        let mut w = original.clone();
        let declaration = rederive::latex::Declaration {
            formula: formula.as_deref().or(Some("x")),
            ..rederive::latex::Declaration::of(Role::Abbreviation)
        };
        match w.scope.declare(&mut w.graph, &key, declaration) {
            Ok(symbol) => {
                declared += 1;
                assert!(w.scope.role(symbol).is_some(), "{key}");
            }
            Err(rederive::latex::DeclareError::Key(p)) => sound(&key, &[p]),
            Err(rederive::latex::DeclareError::Formula(p)) => sound(formula.as_deref().unwrap_or("x"), &p),
        }
    }
    assert!(declared > 20, "{declared}");
}

/// Short texts that stand for much: sums over many indices, high powers, long numbers.
#[test]
fn short_texts_that_stand_for_much() {
    let a = "R_{ij}R_{kl}R_{mn}R_{pq}R_{ab}R_{cd}R_{fg}R_{hs}";
    let mut tall = "R".to_owned();
    for _ in 0..40 {
        tall = format!("({tall}+R)^{{16}}");
    }
    let mut tower = "9".to_owned();
    for _ in 0..30 {
        tower = format!("9^{{{tower}}}");
    }
    let mut squares = "R".to_owned();
    for _ in 0..45 {
        squares = format!("({squares})^2");
    }
    let mut indexed = "m".to_owned();
    for _ in 0..40 {
        indexed = format!("(R{indexed})");
    }
    let mut sums = "x".to_owned();
    for _ in 0..45 {
        sums = format!("(m_iR_{{ij}}m_j{sums})");
    }
    for text in [
        format!("x={a}{a}"),
        format!("{a}=0"),
        format!("R={tall}"),
        format!("x={tower}"),
        format!("R={squares}"),
        format!("x={indexed}_1"),
        format!("x={sums}"),
        format!("x={}", "9".repeat(100_000)),
        format!("x=({})", "1,".repeat(100_000) + "1"),
        format!("x=1^{{{}}}", "9".repeat(50)),
        format!("x=2^{{-{}}}", "9".repeat(9)),
        format!("x=\\sqrt[{}]{{x}}", "9".repeat(50)),
        format!("x_{{{}}}=0", "i".repeat(1000)),
        format!("R_{{{}}}=0", "1".repeat(1000)),
        format!("x={}", "x(0)".repeat(5000)),
        format!("x=|{}|", "a".repeat(5000)),
        "x=0,".repeat(20_000),
        format!("x={}", "m_iR_{ij}m_j+".repeat(2000) + "1"),
    ] {
        let mut w = world();
        let start = Instant::now();
        if let Err(problems) = w.try_read(&text) {
            sound(&text, &problems);
        }
        let shown: String = text.chars().take(60).collect();
        assert!(start.elapsed() < Duration::from_secs(10), "{shown} took {:?}", start.elapsed());
    }
}
