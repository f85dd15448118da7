//! Grown formulas: a formula and the same one rewritten by rules, then one of the two altered.
//!
//! The laws: the two routes never contradict each other (that would be exit 70), what is the same by rules is not refuted, and what differs
//! at a point at which both sides have values is not proved. The long run: `REDERIVE_CASES=1000000 REDERIVE_SEED=7 cargo test --release
//! --test all grown -- --nocapture`, which tells the longest question, too.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use crate::checked::said_by_prover;
use std::rc::Rc;
use std::time::{Duration, Instant};

use rederive::check::{Proposition, prove};
use rederive::derivation::Derivation;
use rederive::number::Draws;

/// A formula in b and x.
#[derive(Clone)]
enum Tree {
    Name(&'static str),
    Number(i32),
    Sum(Rc<Tree>, char, Rc<Tree>),
    Product(Rc<Tree>, Rc<Tree>),
    Quotient(Rc<Tree>, Rc<Tree>),
    /// A whole power.
    Power(Rc<Tree>, i32),
    Function(&'static str, Rc<Tree>),
}

use Tree::{Function, Name, Number, Power, Product, Quotient, Sum};

const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "exp", "ln", "sqrt", "size", "arctan", "tanh", "cosh", "tan", "arcsin", "sqrt[3]"];

impl Tree {
    fn text(&self) -> String {
        match self {
            Name(name) => (*name).to_owned(),
            Number(n) => n.to_string(),
            Sum(a, sign, b) => format!("({}{sign}({}))", a.text(), b.text()),
            Product(a, b) => format!(r"({})\cdot({})", a.text(), b.text()),
            Quotient(a, b) => format!(r"\frac{{{}}}{{{}}}", a.text(), b.text()),
            Power(a, n) => format!("({})^{{{n}}}", a.text()),
            Function("size", a) => format!(r"\left|{}\right|", a.text()),
            Function(root @ ("sqrt" | "sqrt[3]"), a) => format!(r"\{root}{{{}}}", a.text()),
            Function(name, a) => format!(r"\{name}({})", a.text()),
        }
    }

    /// Not a number where there is no value.
    fn value(&self, b: f64, x: f64) -> f64 {
        let at = |tree: &Tree| tree.value(b, x);
        match self {
            Name("b") => b,
            Name(_) => x,
            Number(n) => f64::from(*n),
            Sum(p, '+', q) => at(p) + at(q),
            Sum(p, _, q) => at(p) - at(q),
            Product(p, q) => at(p) * at(q),
            Quotient(p, q) => {
                if at(q) == 0.0 {
                    f64::NAN
                } else {
                    at(p) / at(q)
                }
            }
            // What stands there must have a value, though its power is 1.
            Power(p, n) => at(p).powi(*n) + 0.0 * at(p),
            Function(name, p) => {
                let a = at(p);
                match *name {
                    _ if !a.is_finite() => f64::NAN,
                    "sin" => a.sin(),
                    "cos" => a.cos(),
                    "exp" => a.exp(),
                    "ln" => a.ln(),
                    "sqrt" => a.sqrt(),
                    "size" => a.abs(),
                    "arctan" => a.atan(),
                    "tanh" => a.tanh(),
                    "cosh" => a.cosh(),
                    "tan" => a.tan(),
                    "arcsin" => a.asin(),
                    _ if a < 0.0 => f64::NAN,
                    _ => a.cbrt(),
                }
            }
        }
    }
}

struct Maker(Draws);

impl Maker {
    fn pick(&mut self, n: u64) -> usize {
        self.0.below(n) as usize
    }

    fn leaf(&mut self) -> Tree {
        match self.pick(5) {
            0 | 1 => Name("b"),
            2 | 3 => Name("x"),
            _ => Number(self.pick(4) as i32 + 1),
        }
    }

    fn tree(&mut self, depth: usize) -> Tree {
        if depth == 0 {
            return self.leaf();
        }
        let mut part = |less: usize| Rc::new(self.tree(depth.saturating_sub(less)));
        let (a, b) = (part(1), part(2));
        match self.pick(9) {
            0 => Sum(a, '+', b),
            1 => Sum(a, '-', b),
            2 => Product(a, b),
            3 => Quotient(a, b),
            4 => Power(a, [-3, -2, -1, 0, 2, 3, 4][self.pick(7)]),
            _ => Function(FUNCTIONS[self.pick(FUNCTIONS.len() as u64)], a),
        }
    }

    /// The same at all values at which both have one, by rules at some of the places.
    fn rewritten(&mut self, tree: &Tree) -> Tree {
        let inner = match tree {
            Name(_) | Number(_) => tree.clone(),
            Sum(a, sign, b) => Sum(self.shared(a), *sign, self.shared(b)),
            Product(a, b) => Product(self.shared(a), self.shared(b)),
            Quotient(a, b) => Quotient(self.shared(a), self.shared(b)),
            Power(a, n) => Power(self.shared(a), *n),
            Function(name, a) => Function(name, self.shared(a)),
        };
        if self.pick(3) == 0 { self.rule(inner) } else { inner }
    }

    fn shared(&mut self, tree: &Rc<Tree>) -> Rc<Tree> {
        Rc::new(self.rewritten(tree))
    }

    fn rule(&mut self, tree: Tree) -> Tree {
        let other = Rc::new(self.leaf());
        let all = Rc::new(tree.clone());
        match (tree, self.pick(8)) {
            (Sum(a, '+', b), 0 | 1) => Sum(b, '+', a),
            (Sum(a, '-', b), 0 | 1) => Sum(a, '+', Rc::new(Product(Rc::new(Number(-1)), b))),
            (Product(a, b), 0) => Product(b, a),
            (Product(a, b), 1) => match &*b {
                Sum(p, sign, q) => Sum(Rc::new(Product(a.clone(), p.clone())), *sign, Rc::new(Product(a, q.clone()))),
                _ => Quotient(a, Rc::new(Power(b, -1))),
            },
            (Quotient(a, b), 0 | 1) => Product(a, Rc::new(Power(b, -1))),
            (Power(a, n @ 2..), 0 | 1) => Product(Rc::new(Power(a.clone(), n - 1)), a),
            (Function("sqrt", a), 0) => Power(Rc::new(Function("sqrt", Rc::new(Function("sqrt", a)))), 2),
            (Function("size", a), 0 | 1) => Function("sqrt", Rc::new(Power(a, 2))),
            (Function("exp", a), 0) => Quotient(Rc::new(Number(1)), Rc::new(Function("exp", minus(a)))),
            (Function("tan", a), 0 | 1) => Quotient(Rc::new(Function("sin", a.clone())), Rc::new(Function("cos", a))),
            (Function("sin", a), 0) => {
                let half = Rc::new(Quotient(a, Rc::new(Number(2))));
                let both = Product(Rc::new(Function("sin", half.clone())), Rc::new(Function("cos", half)));
                Product(Rc::new(Number(2)), Rc::new(both))
            }
            (_, 2) => Product(all, Rc::new(Power(other, 0))),
            (_, 3) => Sum(Rc::new(Sum(all, '+', other.clone())), '-', other),
            (_, 4) => Quotient(Rc::new(Number(1)), Rc::new(Power(all, -1))),
            (_, 5) => Function("ln", Rc::new(Function("exp", all))),
            (_, 6) => Quotient(Rc::new(Product(all, other.clone())), other),
            (tree, _) => tree,
        }
    }

    /// The same with something else at one place.
    fn altered(&mut self, tree: &Tree) -> Tree {
        match tree {
            Sum(a, sign, b) if self.pick(2) == 0 => Sum(a.clone(), *sign, Rc::new(self.altered(b))),
            Sum(a, sign, b) => Sum(b.clone(), if *sign == '+' { '-' } else { '+' }, a.clone()),
            Product(a, b) | Quotient(a, b) if self.pick(2) == 0 => Product(Rc::new(self.altered(a)), b.clone()),
            Power(a, n) if self.pick(2) == 0 => Power(a.clone(), n + 1),
            Power(a, n) => Power(Rc::new(self.altered(a)), *n),
            Function(name, a) if self.pick(2) == 0 => Function(name, Rc::new(self.altered(a))),
            Function(_, a) => Function(FUNCTIONS[self.pick(FUNCTIONS.len() as u64)], a.clone()),
            Product(..) | Quotient(..) | Name(_) | Number(_) => Sum(Rc::new(tree.clone()), '+', Rc::new(Number(1))),
        }
    }
}

fn minus(a: Rc<Tree>) -> Rc<Tree> {
    Rc::new(Product(Rc::new(Number(-1)), a))
}

/// Points; not those at which much is 0 or 1.
const POINTS: [(f64, f64); 7] =
    [(0.7, 1.3), (-0.6, 0.4), (1.9, -0.8), (-1.1, -1.7), (0.15, 2.6), (2.3, 0.35), (-2.2, 1.15)];

/// A point at which both sides have values, and differ by more than numbers of the machine do: a point beside it says the same.
fn difference(left: &Tree, right: &Tree) -> Option<(f64, f64)> {
    POINTS.into_iter().find(|&(b, x)| {
        let at = |tree: &Tree| [tree.value(b, x), tree.value(b * (1.0 + 1e-12), x * (1.0 - 1e-12))];
        let ([l, beside_l], [r, beside_r]) = (at(left), at(right));
        let least = 1e-4 * l.abs().max(r.abs()).max(1.0);
        let steady = (l - beside_l).abs() < 0.1 * least && (r - beside_r).abs() < 0.1 * least;
        steady && least < 100.0 && (l - r).abs() > least
    })
}

/// The standing of an equation, or what is wrong with the program.
fn standing(left: &Tree, right: &Tree) -> Result<&'static str, String> {
    let formula = format!("{}={}", left.text(), right.text());
    let mut derivation = Derivation::blank();
    derivation.declare_typed(&[("b,x".to_owned(), "b,x".to_owned())]).map_err(|e| format!("{formula}: {e:?}"))?;
    let proposition = Proposition { formula: formula.clone(), given: Vec::new(), throughout: false };
    match prove(&mut derivation, &proposition) {
        Ok(account) if account.is_defect => Err(format!("{formula}: a defect, {:?}", account.reason)),
        Ok(account) => Ok(said_by_prover(&account)),
        Err(error) => Err(format!("{formula}: {error:?}")),
    }
}

fn wrong(left: &Tree, right: &Tree, is_same: bool) -> Option<String> {
    let found = match standing(left, right) {
        Ok(found) => found,
        // What is one expression on both sides is no question.
        Err(text) if left.text() == right.text() && !text.contains("defect") => return None,
        Err(text) => return Some(text),
    };
    let (l, r) = (left.text(), right.text());
    match (found, is_same) {
        ("refuted", true) => Some(format!("{l}={r}: refuted, and the same by rules")),
        ("proved", false) => {
            let place = difference(left, right);
            place.map(|(b, x)| format!("{l}={r}: proved, and false at b = {b}, x = {x}"))
        }
        _ => None,
    }
}

#[test]
fn neither_route_contradicts_the_other_nor_the_numbers() {
    let number =
        |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(otherwise);
    let mut make = Maker(Draws::new(number("REDERIVE_SEED", 1)));
    let mut found = Vec::new();
    let mut longest = (Duration::ZERO, String::new());
    for _ in 0..number("REDERIVE_CASES", 1_000) {
        let depth = 1 + make.pick(4);
        let one = make.tree(depth);
        let other = make.rewritten(&one);
        let altered = make.altered(&other);
        for (other, is_same) in [(&other, true), (&altered, false)] {
            let started = Instant::now();
            found.extend(wrong(&one, other, is_same));
            if started.elapsed() > longest.0 {
                longest = (started.elapsed(), format!("{}={}", one.text(), other.text()));
            }
        }
    }
    println!("the longest took {:?}: {}", longest.0, longest.1);
    assert!(found.is_empty(), "{} wrong:\n{}", found.len(), found.join("\n"));
}
