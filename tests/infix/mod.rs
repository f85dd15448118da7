//! A small infix reader for tests: `sin(x)^2 + cos(x)^2 = 1`, `x'` for a rate, names as they come.

#![allow(dead_code, reason = "each test binary uses a part")]

use rederive::check::identity::{Known, Premises, When};
use rederive::expr::{Expr, Graph, Leaf, Op, Shape, Symbol};
use std::collections::HashMap;

#[derive(Default)]
pub struct Reader {
    pub graph: Graph,
    symbols: HashMap<String, Symbol>,
    abbreviations: HashMap<String, Expr>,
}

impl Reader {
    pub fn symbol(&mut self, name: &str) -> Symbol {
        if let Some(&s) = self.symbols.get(name) {
            return s;
        }
        let s = self.graph.declare(name, Shape::scalar(), false);
        self.symbols.insert(name.to_owned(), s);
        s
    }

    pub fn leaf(&mut self, name: &str) -> Leaf {
        let rate = name.chars().filter(|&c| c == '\'').count() as u8;
        let symbol = self.symbol(name.trim_end_matches('\''));
        Leaf { rate, ..Leaf::now(symbol, 0) }
    }

    /// From now on `name` means this expression.
    pub fn abbreviate(&mut self, name: &str, text: &str) {
        let e = self.read(text);
        self.abbreviations.insert(name.to_owned(), e);
    }

    pub fn read(&mut self, text: &str) -> Expr {
        let tokens = tokens(text);
        let mut at = 0;
        let e = self.sum(&tokens, &mut at);
        assert_eq!(at, tokens.len(), "unread rest of `{text}` from token {at}: {:?}", &tokens[at..]);
        e
    }

    /// `left = right`
    pub fn equation(&mut self, text: &str) -> (Expr, Expr) {
        let (l, r) = text.split_once('=').unwrap_or_else(|| panic!("no `=` in `{text}`"));
        (self.read(l), self.read(r))
    }

    /// Equations separated by `;`.
    pub fn equations(&mut self, text: &str) -> Vec<(Expr, Expr)> {
        text.split(';').map(str::trim).filter(|t| !t.is_empty()).map(|t| self.equation(t)).collect()
    }

    /// `a = b; c != 0; d > 0`; every moving symbol named in `moving`, time is `t`.
    pub fn premises(&mut self, text: &str, moving: &str) -> Premises {
        let mut out = Premises::default();
        for part in text.split(';').map(str::trim).filter(|t| !t.is_empty()) {
            if let Some((l, r)) = part.split_once("!=") {
                assert_eq!(r.trim(), "0");
                out.nonzero.push(self.read(l));
            } else if let Some((l, r)) = part.split_once('>') {
                assert_eq!(r.trim(), "0");
                let e = self.read(l);
                out.positive.push(e);
            } else {
                let pair = self.equation(part);
                out.equations.push(Known::of(pair, When::Always));
            }
        }
        if !moving.is_empty() {
            out.time = Some(self.leaf("t"));
            out.moving = moving.split_whitespace().map(|m| self.symbol(m)).collect();
        }
        out
    }

    fn sum(&mut self, t: &[String], at: &mut usize) -> Expr {
        let mut e = self.product(t, at);
        while let Some(op @ ("+" | "-")) = t.get(*at).map(String::as_str) {
            *at += 1;
            let r = self.product(t, at);
            e = if op == "+" { self.graph.add(e, r) } else { self.graph.sub(e, r) };
        }
        e
    }

    fn product(&mut self, t: &[String], at: &mut usize) -> Expr {
        let mut e = self.sign(t, at);
        while let Some(op @ ("*" | "/")) = t.get(*at).map(String::as_str) {
            *at += 1;
            let r = self.sign(t, at);
            e = if op == "*" { self.graph.mul(e, r) } else { self.graph.div(e, r) };
        }
        e
    }

    fn sign(&mut self, t: &[String], at: &mut usize) -> Expr {
        if t.get(*at).is_some_and(|t| t == "-") {
            *at += 1;
            let e = self.sign(t, at);
            return self.graph.neg(e);
        }
        let base = self.atom(t, at);
        if t.get(*at).is_some_and(|t| t == "^") {
            *at += 1;
            let exponent = self.sign(t, at);
            return self.graph.binary(Op::Pow, base, exponent);
        }
        base
    }

    fn atom(&mut self, t: &[String], at: &mut usize) -> Expr {
        let token = t.get(*at).cloned().unwrap_or_else(|| panic!("formula ends early: {t:?}"));
        *at += 1;
        if token == "(" {
            let e = self.sum(t, at);
            assert_eq!(t.get(*at).map(String::as_str), Some(")"), "{t:?}");
            *at += 1;
            return e;
        }
        if token.chars().all(|c| c.is_ascii_digit()) {
            let value: dashu_int::IBig = token.parse().unwrap();
            return self.graph.constant(value.into());
        }
        let op = match token.as_str() {
            "pi" => return self.graph.pi(),
            "sqrt" => Op::Sqrt,
            "exp" => Op::Exp,
            "ln" => Op::Ln,
            "sin" => Op::Sin,
            "cos" => Op::Cos,
            "tan" => Op::Tan,
            "arcsin" => Op::Arcsin,
            "arccos" => Op::Arccos,
            "arctan" => Op::Arctan,
            "sinh" => Op::Sinh,
            "cosh" => Op::Cosh,
            "tanh" => Op::Tanh,
            "abs" => Op::Abs,
            "atan2" => Op::Arctan2,
            _ => {
                if let Some(&e) = self.abbreviations.get(&token) {
                    return e;
                }
                let leaf = self.leaf(&token);
                return self.graph.leaf(leaf);
            }
        };
        assert_eq!(t.get(*at).map(String::as_str), Some("("), "argument of {token} in {t:?}");
        *at += 1;
        let a = self.sum(t, at);
        let e = if op.arity() == 2 {
            assert_eq!(t[*at], ",");
            *at += 1;
            let b = self.sum(t, at);
            self.graph.binary(op, a, b)
        } else {
            self.graph.unary(op, a)
        };
        assert_eq!(t[*at], ")");
        *at += 1;
        e
    }
}

fn tokens(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    let chars: Vec<char> = text.chars().collect();
    let mut i = 0;
    while i < chars.len() {
        let c = chars[i];
        let mut j = i + 1;
        if c.is_alphanumeric() {
            while j < chars.len() && (chars[j].is_alphanumeric() || chars[j] == '_' || chars[j] == '\'') {
                j += 1;
            }
        }
        if !c.is_whitespace() {
            out.push(chars[i..j].iter().collect());
        }
        i = j;
    }
    out
}

/// An expression in the notation of [`Reader`], cut off below some depth.
pub fn show(graph: &Graph, e: Expr, depth: usize) -> String {
    use rederive::expr::Node;
    if depth == 0 {
        return "…".into();
    }
    let sub = |e| show(graph, e, depth - 1);
    match graph.node(e) {
        Node::Constant(r) => r.to_string(),
        Node::Pi => "pi".into(),
        Node::Leaf(l) => {
            let name = graph.name(l.symbol);
            if name.starts_with('\u{2063}') {
                return format!("g{}", l.component);
            }
            format!("{name}{}", "'".repeat(l.rate as usize))
        }
        Node::Unary(Op::Powi(n), a) => format!("{}^{n}", sub(*a)),
        Node::Unary(Op::Neg, a) => format!("-{}", sub(*a)),
        Node::Unary(op, a) => format!("{}({})", op.spelling().trim_start_matches('\\'), sub(*a)),
        Node::Binary(op, a, b) => {
            let sign = match op {
                Op::Add => "+",
                Op::Sub => "-",
                Op::Mul => "*",
                Op::Div => "/",
                other => other.spelling(),
            };
            format!("({}{sign}{})", sub(*a), sub(*b))
        }
    }
}
