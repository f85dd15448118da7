//! Random true identities, built by rewriting, and random near-misses: neither may get the opposite verdict.
//!
//! `REDERIVE_CASES=10000 cargo test --release --test all identity_random` for the long run.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use rederive::check::identity::{Identity, Options, Premises, identity_test};
use rederive::expr::{Expr, Graph, Node, Op, Rational, Shape};
use rederive::number::Draws;
use rederive::tape::Tape;

struct Maker {
    graph: Graph,
    draws: Draws,
    leaves: Vec<Expr>,
}

impl Maker {
    fn new(seed: u64) -> Maker {
        let mut graph = Graph::new();
        let leaves = ["x", "y", "z"].map(|n| {
            let s = graph.declare(n, Shape::scalar(), false);
            graph.component(s, 0)
        });
        Maker { graph, draws: Draws::new(seed), leaves: leaves.to_vec() }
    }

    fn pick(&mut self, n: u64) -> u64 {
        self.draws.below(n)
    }

    fn leaf(&mut self) -> Expr {
        let at = self.pick(3) as usize;
        self.leaves[at]
    }

    fn constant(&mut self) -> Expr {
        let n = self.pick(5) as i64 + 1;
        let d = self.pick(3) as i64 + 1;
        self.graph.constant(Rational::from(n) / Rational::from(d))
    }

    fn expression(&mut self, depth: u32) -> Expr {
        if depth == 0 {
            return if self.pick(4) == 0 { self.constant() } else { self.leaf() };
        }
        match self.pick(12) {
            0..=2 => {
                let (a, b) = (self.expression(depth - 1), self.expression(depth - 1));
                self.graph.add(a, b)
            }
            3 => {
                let (a, b) = (self.expression(depth - 1), self.expression(depth - 1));
                self.graph.sub(a, b)
            }
            4..=6 => {
                let (a, b) = (self.expression(depth - 1), self.expression(depth - 1));
                self.graph.mul(a, b)
            }
            7 => {
                let a = self.expression(depth - 1);
                let b = self.positive(depth - 1);
                self.graph.div(a, b)
            }
            8 => {
                let a = self.expression(depth - 1);
                let n = self.pick(2) as i32 + 2;
                self.graph.powi(a, n)
            }
            9 | 10 => {
                let a = self.argument();
                let op = [Op::Sin, Op::Cos, Op::Exp, Op::Sinh, Op::Cosh, Op::Tanh][self.pick(6) as usize];
                self.graph.unary(op, a)
            }
            _ => {
                let a = self.positive(depth - 1);
                self.graph.unary(Op::Sqrt, a)
            }
        }
    }

    /// Something positive for all real values.
    fn positive(&mut self, depth: u32) -> Expr {
        let a = self.expression(depth.min(1));
        let square = self.graph.powi(a, 2);
        let c = self.constant();
        self.graph.add(square, c)
    }

    fn argument(&mut self) -> Expr {
        let (a, c) = (self.leaf(), self.constant());
        let term = self.graph.mul(c, a);
        if self.pick(2) == 0 {
            return term;
        }
        let b = self.leaf();
        self.graph.add(term, b)
    }

    /// The same function, written differently: one rule at random places, from the leaves up. Arguments of transcendental
    /// functions stay as they are: equal arguments are recognised by expansion only.
    fn rewrite(&mut self, e: Expr) -> Expr {
        let mut image = std::collections::HashMap::new();
        for node in self.graph.reachable([e]) {
            let rebuilt = match self.graph.node(node).clone() {
                Node::Unary(op @ (Op::Neg | Op::Sqrt | Op::Powi(_)), a) => self.graph.unary(op, image[&a]),
                Node::Binary(op, a, b) => self.graph.binary(op, image[&a], image[&b]),
                _ => node,
            };
            let new = if self.pick(3) == 0 { self.rule(rebuilt) } else { rebuilt };
            image.insert(node, new);
        }
        image[&e]
    }

    fn rule(&mut self, e: Expr) -> Expr {
        let two = self.graph.integer(2);
        let one = self.graph.integer(1);
        match self.graph.node(e).clone() {
            Node::Unary(Op::Sin, a) => {
                let half = self.graph.div(a, two);
                let (s, c) = (self.graph.unary(Op::Sin, half), self.graph.unary(Op::Cos, half));
                let p = self.graph.mul(s, c);
                self.graph.mul(two, p)
            }
            Node::Unary(Op::Cos, a) => {
                let half = self.graph.div(a, two);
                let s = self.graph.unary(Op::Sin, half);
                let ss = self.graph.mul(s, s);
                let twice = self.graph.mul(two, ss);
                self.graph.sub(one, twice)
            }
            Node::Unary(Op::Exp, a) => {
                let b = self.leaf();
                let rest = self.graph.sub(a, b);
                let (p, q) = (self.graph.unary(Op::Exp, rest), self.graph.unary(Op::Exp, b));
                self.graph.mul(p, q)
            }
            Node::Unary(Op::Tanh, a) => {
                let (s, c) = (self.graph.unary(Op::Sinh, a), self.graph.unary(Op::Cosh, a));
                self.graph.div(s, c)
            }
            Node::Unary(Op::Cosh, a) => {
                let s = self.graph.unary(Op::Sinh, a);
                let ss = self.graph.mul(s, s);
                let sum = self.graph.add(one, ss);
                self.graph.unary(Op::Sqrt, sum)
            }
            Node::Unary(Op::Sqrt, a) => {
                let root = self.graph.unary(Op::Sqrt, a);
                self.graph.div(a, root)
            }
            Node::Unary(Op::Powi(2), a) => self.graph.mul(a, a),
            Node::Binary(Op::Mul, a, b) => match self.graph.node(b).clone() {
                Node::Binary(op @ (Op::Add | Op::Sub), p, q) => {
                    let (l, r) = (self.graph.mul(a, p), self.graph.mul(a, q));
                    self.graph.binary(op, l, r)
                }
                _ => {
                    // ab = ((a + b)² − (a − b)²)/4
                    let (s, d) = (self.graph.add(a, b), self.graph.sub(a, b));
                    let (ss, dd) = (self.graph.powi(s, 2), self.graph.powi(d, 2));
                    let difference = self.graph.sub(ss, dd);
                    let four = self.graph.integer(4);
                    self.graph.div(difference, four)
                }
            },
            Node::Binary(Op::Add, a, b) => {
                let minus = self.graph.neg(b);
                self.graph.sub(a, minus)
            }
            Node::Binary(Op::Div, a, b) => {
                let c = self.positive(0);
                let (p, q) = (self.graph.mul(a, c), self.graph.mul(c, b));
                self.graph.div(p, q)
            }
            _ => match self.pick(3) {
                0 => {
                    let a = self.argument();
                    let (s, c) = (self.graph.unary(Op::Sin, a), self.graph.unary(Op::Cos, a));
                    let (ss, cc) = (self.graph.powi(s, 2), self.graph.powi(c, 2));
                    let sum = self.graph.add(ss, cc);
                    self.graph.mul(e, sum)
                }
                1 => {
                    let c = self.positive(0);
                    let root = self.graph.unary(Op::Sqrt, c);
                    let up = self.graph.mul(e, root);
                    self.graph.div(up, root)
                }
                _ => {
                    let b = self.leaf();
                    let sum = self.graph.add(e, b);
                    self.graph.sub(sum, b)
                }
            },
        }
    }

    /// One edit somewhere.
    fn edit(&mut self, e: Expr) -> Expr {
        let nodes = self.graph.reachable([e]);
        let at = nodes[self.pick(nodes.len() as u64) as usize];
        let one = self.graph.integer(1);
        let edited = match self.graph.node(at).clone() {
            Node::Unary(Op::Sin, a) => self.graph.unary(Op::Cos, a),
            Node::Unary(Op::Cos, a) => self.graph.unary(Op::Sin, a),
            Node::Unary(Op::Powi(2), a) => a,
            Node::Binary(Op::Add, a, b) => self.graph.sub(a, b),
            Node::Binary(Op::Sub, a, b) => self.graph.add(a, b),
            Node::Leaf(_) => self.leaf(),
            Node::Constant(_) => self.graph.add(at, one),
            _ => self.graph.neg(at),
        };
        let mut image = std::collections::HashMap::new();
        for node in nodes {
            let new = match self.graph.node(node).clone() {
                _ if node == at => edited,
                Node::Unary(op, a) => self.graph.unary(op, image[&a]),
                Node::Binary(op, a, b) => self.graph.binary(op, image[&a], image[&b]),
                _ => node,
            };
            image.insert(node, new);
        }
        image[&e]
    }

    /// Whether the two certainly differ, at some of a few real points.
    fn differ(&mut self, a: Expr, b: Expr) -> bool {
        let leaves = self.graph.leaves([a, b]);
        let Ok(tape) = Tape::compile(&self.graph, &leaves, &[a, b]) else { return false };
        let mut slots = tape.slots::<f64>(&());
        (0..40).any(|_| {
            let values: Vec<_> = leaves.iter().map(|_| Ok(self.pick(4000) as f64 / 1000.0 - 2.0)).collect();
            match tape.evaluate(&(), &values, &mut slots).as_slice() {
                [Ok(p), Ok(q)] => {
                    let largest = (0..tape.slot_count()).map(|s| slots.value(s).abs()).fold(1.0, f64::max);
                    (p - q).abs() > 1e-5 * p.abs().max(q.abs()) && (p - q).abs() > 1e-8 * largest
                }
                _ => false,
            }
        })
    }
}

#[test]
fn no_error_of_either_kind() {
    let cases: u64 = std::env::var("REDERIVE_CASES").ok().and_then(|v| v.parse().ok()).unwrap_or(300);
    let (mut proved, mut refuted, mut open_true, mut open_false, mut built_false) = (0, 0, 0, 0, 0);
    for seed in 0..cases {
        let mut m = Maker::new(seed);
        let e = m.expression(3);
        let mut same = e;
        for _ in 0..2 {
            same = m.rewrite(same);
        }
        let options = Options { seed, ..Options::default() };
        match identity_test(&mut m.graph, &[(e, same)], &Premises::default(), &options) {
            Identity::Proved(p) => {
                assert!(p.log2_error <= -100.0);
                proved += 1;
            }
            Identity::Refuted(r) => panic!("seed {seed}: a true identity is refuted: {r:?}"),
            Identity::Undecided(rederive::check::identity::Reason::Defect(what)) => panic!("seed {seed}: {what}"),
            Identity::Undecided(reason) => {
                if open_true < 5 {
                    println!("seed {seed}: true, undecided: {reason:?}");
                }
                open_true += 1;
            }
        }
        let near = m.edit(same);
        if near == same || !m.differ(e, near) {
            continue;
        }
        built_false += 1;
        match identity_test(&mut m.graph, &[(e, near)], &Premises::default(), &options) {
            Identity::Proved(_) => panic!("seed {seed}: a false identity is proved"),
            Identity::Refuted(_) => refuted += 1,
            Identity::Undecided(reason) => {
                if open_false < 5 {
                    println!("seed {seed}: false, undecided: {reason:?}");
                }
                open_false += 1;
            }
        }
    }
    println!(
        "true: {proved} proved, {open_true} undecided of {cases}; false: {refuted} refuted, {open_false} undecided of {built_false}"
    );
    assert!(proved * 20 > cases * 19, "{proved} of {cases} true identities proved");
    assert!(refuted * 20 > built_false * 19, "{refuted} of {built_false} false identities refuted");
}
