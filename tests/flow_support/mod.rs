//! A small notation for systems and formulas in tests of trajectories.
#![allow(dead_code, reason = "each test file uses another part")]

use rederive::expr::{Expr, Graph, Leaf, Op, Rational, Shape, Symbol};
use rederive::flow::{FlowError, Motion, Observable, Setup, Source, VectorField};
use std::collections::BTreeMap;

/// Scalar symbols by name. `x'` and `x''` are rates, `x@0` is the value at the time 0.
#[derive(Default)]
pub struct World {
    pub graph: Graph,
    symbols: BTreeMap<String, Symbol>,
}

impl World {
    pub fn symbol(&mut self, name: &str) -> Symbol {
        if let Some(&s) = self.symbols.get(name) {
            return s;
        }
        let s = self.graph.declare(name, Shape::scalar(), false);
        self.symbols.insert(name.to_owned(), s);
        s
    }

    /// The leaf `name`, with dashes for rates.
    pub fn leaf(&mut self, name: &str) -> Leaf {
        let plain = name.trim_end_matches('\'');
        let symbol = self.symbol(plain);
        Leaf { rate: (name.len() - plain.len()) as u8, ..Leaf::now(symbol, 0) }
    }

    /// A formula: + − * / ^ (integer powers), functions, decimals, leaves.
    pub fn e(&mut self, text: &str) -> Expr {
        let chars: Vec<char> = text.chars().filter(|c| !c.is_whitespace()).collect();
        let mut at = 0;
        let e = self.sum(&chars, &mut at);
        assert_eq!(at, chars.len(), "`{text}` is not understood");
        e
    }

    fn sum(&mut self, c: &[char], at: &mut usize) -> Expr {
        let mut left = if c.get(*at) == Some(&'-') {
            *at += 1;
            let e = self.product(c, at);
            self.graph.neg(e)
        } else {
            self.product(c, at)
        };
        while let Some(op @ ('+' | '-')) = c.get(*at) {
            *at += 1;
            let right = self.product(c, at);
            left = if *op == '+' { self.graph.add(left, right) } else { self.graph.sub(left, right) };
        }
        left
    }

    fn product(&mut self, c: &[char], at: &mut usize) -> Expr {
        let mut left = self.power(c, at);
        while let Some(op @ ('*' | '/')) = c.get(*at) {
            *at += 1;
            let right = self.power(c, at);
            left = if *op == '*' { self.graph.mul(left, right) } else { self.graph.div(left, right) };
        }
        left
    }

    fn power(&mut self, c: &[char], at: &mut usize) -> Expr {
        let base = self.atom(c, at);
        if c.get(*at) != Some(&'^') {
            return base;
        }
        *at += 1;
        let negative = c[*at] == '-';
        *at += usize::from(negative);
        let digits: String = c[*at..].iter().take_while(|x| x.is_ascii_digit()).collect();
        *at += digits.len();
        let n: i32 = digits.parse().unwrap();
        self.graph.powi(base, if negative { -n } else { n })
    }

    fn atom(&mut self, c: &[char], at: &mut usize) -> Expr {
        if c[*at] == '(' {
            *at += 1;
            let e = self.sum(c, at);
            assert_eq!(c[*at], ')');
            *at += 1;
            return e;
        }
        let word: String = c[*at..].iter().take_while(|x| x.is_alphanumeric() || "_.'@".contains(**x)).collect();
        *at += word.chars().count();
        if word.starts_with(|x: char| x.is_ascii_digit()) {
            return self.number(&word);
        }
        if c.get(*at) == Some(&'(') {
            *at += 1;
            let a = self.sum(c, at);
            let e = if c[*at] == ',' {
                *at += 1;
                let b = self.sum(c, at);
                let op = match word.as_str() {
                    "atan2" => Op::Arctan2,
                    "pow" => Op::Pow,
                    _ => Op::Agm,
                };
                self.graph.binary(op, a, b)
            } else {
                let op = match word.as_str() {
                    "sin" => Op::Sin,
                    "cos" => Op::Cos,
                    "tan" => Op::Tan,
                    "asin" => Op::Arcsin,
                    "acos" => Op::Arccos,
                    "atan" => Op::Arctan,
                    "sinh" => Op::Sinh,
                    "cosh" => Op::Cosh,
                    "sqrt" => Op::Sqrt,
                    "exp" => Op::Exp,
                    "abs" => Op::Abs,
                    "tanh" => Op::Tanh,
                    "ln" => Op::Ln,
                    other => panic!("no function {other}"),
                };
                self.graph.unary(op, a)
            };
            assert_eq!(c[*at], ')');
            *at += 1;
            return e;
        }
        if word == "pi" {
            return self.graph.pi();
        }
        match word.split_once('@') {
            Some((name, when)) => {
                let instant = self.e(when);
                let leaf = self.leaf(name);
                self.graph.leaf(Leaf { instant: Some(instant), ..leaf })
            }
            None => {
                let leaf = self.leaf(&word);
                self.graph.leaf(leaf)
            }
        }
    }

    /// A decimal, exactly.
    pub fn number(&mut self, text: &str) -> Expr {
        let (whole, part) = text.split_once('.').unwrap_or((text, ""));
        let top: i64 = format!("{whole}{part}").parse().unwrap();
        let value = Rational::from(top) / Rational::from(10_i64.pow(part.len() as u32));
        self.graph.constant(value)
    }

    /// A binary64 number, exactly.
    pub fn exactly(&mut self, x: f64) -> Expr {
        let value = Rational::simplest_from_f64(x).filter(|r| r.to_f64().value() == x).unwrap_or_default();
        assert_eq!(value.to_f64().value(), x);
        self.graph.constant(value)
    }

    /// Solves `left = right` lines for the states.
    pub fn field(&mut self, states: &[&str], equations: &[&str]) -> Result<VectorField, FlowError> {
        let time = self.leaf("t");
        let states: Vec<Symbol> = states.iter().map(|s| self.symbol(s)).collect();
        let pairs: Vec<(Expr, Expr)> = equations
            .iter()
            .map(|line| {
                let (l, r) = line.split_once('=').unwrap();
                (self.e(l), self.e(r))
            })
            .collect();
        VectorField::solve(&mut self.graph, Some(time), &states, &pairs)
    }

    pub fn pairs(&mut self, of: &[(&str, &str)]) -> Vec<(Leaf, Expr)> {
        of.iter().map(|(l, e)| (self.leaf(l), self.e(e))).collect()
    }

    /// Observables; a name that ends in `~` is an angle.
    pub fn observables(&mut self, of: &[(&str, &str)]) -> Vec<Observable> {
        of.iter()
            .map(|(l, e)| Observable {
                leaf: self.leaf(l.trim_end_matches('~')),
                definition: self.e(e),
                angle: l.ends_with('~'),
            })
            .collect()
    }

    /// An integrated motion.
    pub fn integrate(
        &mut self,
        field: &VectorField,
        initial: &[(&str, &str)],
        parameters: &[(&str, &str)],
        observables: &[(&str, &str)],
        span: (f64, f64),
        initial_time: f64,
    ) -> Result<Motion, FlowError> {
        let setup = Setup {
            time: self.leaf("t"),
            span,
            initial_time,
            parameters: self.pairs(parameters),
            source: Source::Integrated { field, initial: self.pairs(initial), start: Default::default() },
            observables: self.observables(observables),
        };
        Motion::new(&mut self.graph, setup)
    }

    /// Prepares leaves by name.
    pub fn prepare(&mut self, motion: &mut Motion, names: &[&str]) {
        let leaves: Vec<Leaf> = names
            .iter()
            .map(|n| match n.split_once('@') {
                Some((name, when)) => {
                    let instant = self.e(when);
                    Leaf { instant: Some(instant), ..self.leaf(name) }
                }
                None => self.leaf(n),
            })
            .collect();
        motion.prepare(&mut self.graph, &leaves).unwrap();
    }
}

/// The free rigid body: names R11 … R33, O1 … O3, parameters I1 … I3.
pub fn rigid_body(world: &mut World) -> VectorField {
    let mut equations = Vec::new();
    for i in 1..=3 {
        for (j, k, p) in [(1, 2, 3), (2, 3, 1), (3, 1, 2)] {
            // Ṙᵢⱼ = −ε_{jkp} Ω_k R_{ip}
            equations.push(format!("R{i}{j}' = O{p}*R{i}{k} - O{k}*R{i}{p}"));
        }
    }
    equations.push("I1*O1' = I2*O2*O3 - I3*O3*O2".to_owned());
    equations.push("I2*O2' = I3*O3*O1 - I1*O1*O3".to_owned());
    equations.push("I3*O3' = I1*O1*O2 - I2*O2*O1".to_owned());
    let equations: Vec<&str> = equations.iter().map(String::as_str).collect();
    let states = rigid_states();
    world.field(&states, &equations).unwrap()
}

pub fn rigid_states() -> Vec<&'static str> {
    vec!["R11", "R12", "R13", "R21", "R22", "R23", "R31", "R32", "R33", "O1", "O2", "O3"]
}

/// A free rigid body from R(0), Ω(0) and moments, all as text.
pub fn rigid_motion(
    world: &mut World,
    moments: [&str; 3],
    rotation: [&str; 9],
    omega: [&str; 3],
    observables: &[(&str, &str)],
    span: (f64, f64),
) -> Motion {
    let field = rigid_body(world);
    let parameters: Vec<(&str, &str)> = ["I1", "I2", "I3"].into_iter().zip(moments).collect();
    let values = rotation.into_iter().chain(omega);
    let initial: Vec<(&str, &str)> = rigid_states().into_iter().zip(values).collect();
    world.integrate(&field, &initial, &parameters, observables, span, 0.0).unwrap()
}

pub const UNIT: [&str; 9] = ["1", "0", "0", "0", "1", "0", "0", "0", "1"];
