//! Expressions as LaTeX that reads back as the same expression.

use super::{Expr, Graph, Leaf, Node, Op, Rational};

/// How tightly a printed expression holds together; from loose to tight.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Sum,
    Product,
    Factor,
}

impl Graph {
    /// A leaf as a formula writes it: `\dot R_{12}`, `\psi(0)`.
    pub fn leaf_latex(&self, leaf: Leaf) -> String {
        let name = self.name(leaf.symbol);
        let dotted = match leaf.rate {
            0 => name.to_owned(),
            1 => format!(r"\dot{{{name}}}"),
            2 => format!(r"\ddot{{{name}}}"),
            n => format!(r"\frac{{d^{n} {name}}}{{dt^{n}}}"),
        };
        let dotted = if leaf.rate > 0 && leaf.rate < 3 { self.dotted(name, leaf.rate) } else { dotted };
        let indices = self.component_indices(leaf.symbol, leaf.component);
        let indexed = if indices.is_empty() {
            dotted
        } else {
            let list: String = indices.iter().map(u16::to_string).collect();
            let base = if name.contains('_') { format!("({dotted})") } else { dotted };
            match indices.as_slice() {
                [single] if *single < 10 => format!("{base}_{single}"),
                _ => format!("{base}_{{{list}}}"),
            }
        };
        match leaf.instant {
            None => indexed,
            Some(e) => format!("{indexed}({})", self.to_latex(e)),
        }
    }

    /// A name under dots; a label stays outside of them.
    fn dotted(&self, name: &str, rate: u8) -> String {
        let dot = if rate == 1 { r"\dot" } else { r"\ddot" };
        match name.split_once('_') {
            Some((head, label)) => format!("{dot}{{{head}}}_{label}"),
            None if name.starts_with('{') => format!("{dot}{name}"),
            None => format!("{dot}{{{name}}}"),
        }
    }

    /// An expression as LaTeX.
    pub fn to_latex(&self, e: Expr) -> String {
        let mut printed: std::collections::HashMap<Expr, (String, Bond)> = std::collections::HashMap::new();
        for node in self.reachable([e]) {
            let text = match self.node(node) {
                Node::Constant(r) => number(r),
                Node::Pi => (r"\pi".to_owned(), Bond::Factor),
                Node::Leaf(leaf) => (self.leaf_latex(*leaf), Bond::Factor),
                Node::Unary(op, a) => unary(*op, &printed[a]),
                Node::Binary(op, a, b) => binary(*op, &printed[a], &printed[b]),
            };
            printed.insert(node, text);
        }
        printed.remove(&e).map_or_else(String::new, |(text, _)| text)
    }
}

fn number(r: &Rational) -> (String, Bond) {
    let negative = *r < Rational::ZERO;
    let r = if negative { -r.clone() } else { r.clone() };
    let text = if r.denominator().is_one() {
        r.numerator().to_string()
    } else {
        format!(r"\frac{{{}}}{{{}}}", r.numerator(), r.denominator())
    };
    if negative { (format!("-{text}"), Bond::Sum) } else { (text, Bond::Factor) }
}

fn wrapped((text, bond): &(String, Bond), least: Bond) -> String {
    if *bond >= least { text.clone() } else { format!("({text})") }
}

fn unary(op: Op, a: &(String, Bond)) -> (String, Bond) {
    match op {
        Op::Neg => (format!("-{}", wrapped(a, Bond::Product)), Bond::Sum),
        Op::Sqrt => (format!(r"\sqrt{{{}}}", a.0), Bond::Factor),
        Op::Abs => (format!(r"\left|{}\right|", a.0), Bond::Factor),
        Op::Powi(n) => (format!("({})^{{{n}}}", a.0), Bond::Factor),
        _ => (format!("{}({})", op.spelling(), a.0), Bond::Factor),
    }
}

fn binary(op: Op, a: &(String, Bond), b: &(String, Bond)) -> (String, Bond) {
    match op {
        Op::Add => (format!("{}+{}", a.0, wrapped(b, Bond::Product)), Bond::Sum),
        Op::Sub => (format!("{}-{}", a.0, wrapped(b, Bond::Product)), Bond::Sum),
        Op::Mul => (format!(r"{}\cdot {}", wrapped(a, Bond::Product), wrapped(b, Bond::Factor)), Bond::Product),
        Op::Div => (format!(r"\frac{{{}}}{{{}}}", a.0, b.0), Bond::Factor),
        Op::Pow => (format!("({})^{{{}}}", a.0, b.0), Bond::Factor),
        _ => (format!("{}({},{})", op.spelling(), a.0, b.0), Bond::Factor),
    }
}
