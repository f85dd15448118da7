//! Expressions as LaTeX that reads back as the same expression.
//!
//! For the reader in the scope in which the symbols were declared: numbers, operations, rates up to the fourth, values at
//! times, components and the sign ± come back as the same node.

use std::collections::HashMap;

use super::{Expr, Graph, Leaf, Node, Op, Place, Rational, Symbol};

/// How tightly a printed expression holds together; from loose to tight.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    /// Begins with a sign or contains one.
    Sum,
    Product,
    Factor,
    /// A symbol, which takes an exponent without parentheses.
    Symbol,
}

/// Texts longer than this are cut: a shared expression is printed once for each of its uses.
const LONGEST: usize = 1 << 16;

/// The name of the sign that ± stands for.
const BRANCH: &str = r"\pm";

/// The parts of a declared name: `\psi` and `0`; `I` and `(n-k)`; `\Omega` and what stands in parentheses behind it.
struct NameParts<'a> {
    head: &'a str,
    label: &'a str,
    arguments: &'a str,
}

fn parts(name: &str) -> NameParts<'_> {
    let split = |at: Option<usize>, text: &'_ str| at.unwrap_or(text.len());
    let lowered = split(name.find('_'), name);
    let (head, rest) = name.split_at(lowered.min(split(name.find('('), name)));
    let Some(label) = rest.strip_prefix('_') else { return NameParts { head, label: "", arguments: rest } };
    let end = match label.strip_prefix('{') {
        None => label.chars().next().map_or(0, char::len_utf8),
        Some(_) => {
            let mut depth = 0;
            let close = label.char_indices().find(|(_, c)| {
                depth += i32::from(*c == '{') - i32::from(*c == '}');
                depth == 0
            });
            close.map_or(label.len(), |(i, _)| i + 1)
        }
    };
    // A command, as in `x_\alpha`, has more than one letter.
    let end = match label.strip_prefix('\\') {
        Some(command) => 1 + command.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(command.len()),
        None => end,
    };
    let (label, arguments) = label.split_at(end);
    let label = label.strip_prefix('{').and_then(|l| l.strip_suffix('}')).unwrap_or(label);
    NameParts { head, label, arguments }
}

impl Graph {
    /// A leaf as a formula writes it: `\dot R_{12}`, `\psi(0)`.
    pub fn leaf_latex(&self, leaf: Leaf) -> String {
        let field = self.field_of(leaf.symbol);
        let NameParts { head, label, arguments } = parts(self.name(field));
        let place = self.place(leaf.symbol);
        // Of a field of one coordinate at a place, the derivative is written with primes.
        let primes = match place {
            Some(place) if place.at.len() == 1 && leaf.partials.order() <= 3 => leaf.partials.order(),
            Some(_) | None => 0,
        };
        let there = |place: &Place| self.arguments_latex(place);
        let arguments = match place {
            Some(place) if primes > 0 || leaf.partials.is_none() => there(place),
            Some(_) | None => arguments.to_owned(),
        };
        let head = format!("{head}{}", "'".repeat(primes as usize));
        let head = head.as_str();
        let dots = usize::from(leaf.rate);
        let dotted = match leaf.rate {
            0 => head.to_owned(),
            1..=4 if head.starts_with('{') => format!(r"\{}ot{head}", "d".repeat(dots)),
            1..=4 => format!(r"\{}ot{{{head}}}", "d".repeat(dots)),
            n => format!(r"\frac{{d^{n}}}{{dt^{n}}}{head}"),
        };
        let indices: Vec<String> =
            self.written_indices(leaf.symbol, leaf.component).iter().map(u16::to_string).collect();
        let sub = subscript(label, &indices);
        let lowered = match sub.chars().count() {
            0 => String::new(),
            1 => format!("_{sub}"),
            _ => format!("_{{{sub}}}"),
        };
        let at = match leaf.instant {
            None => String::new(),
            Some(e) => {
                let (text, bond) = self.printed(e);
                // A time with a sign that is no number could be taken for a factor.
                if bond == Bond::Sum && self.as_constant(e).is_none() {
                    format!("(({text}))")
                } else {
                    format!("({text})")
                }
            }
        };
        let whole = match self.is_numbered(leaf.symbol) && !lowered.is_empty() {
            true => format!("({dotted}{arguments}){lowered}{at}"),
            false => format!("{dotted}{lowered}{arguments}{at}"),
        };
        let whole = match place {
            None => self.with_partials(leaf, whole),
            Some(place) if primes == 0 && !leaf.partials.is_none() => {
                self.behind_a_bar(self.with_partials(leaf, whole), place)
            }
            Some(_) => whole,
        };
        match self.part(leaf) {
            Some(part) => part.of(&whole),
            None => whole,
        }
    }

    /// The name of a symbol without its arguments.
    pub(super) fn bare_name(&self, symbol: Symbol) -> String {
        let name = self.name(symbol);
        name[..name.len() - parts(name).arguments.len()].to_owned()
    }

    /// What is put for the coordinates of a field, in parentheses.
    pub(super) fn arguments_latex(&self, place: &Place) -> String {
        let each: Vec<String> = place.at.iter().map(|&(_, e)| self.to_latex(e)).collect();
        format!("({})", each.join(","))
    }

    /// A derivative taken at a place: only what is not at its own coordinate is named.
    fn behind_a_bar(&self, derivative: String, place: &Place) -> String {
        let coordinates: Vec<Leaf> = self.coordinates().collect();
        let moved = place.at.iter().filter_map(|&(at, e)| {
            let leaf = *coordinates.get(at)?;
            let itself = matches!(self.node(e), Node::Leaf(l) if *l == leaf);
            (!itself).then(|| format!("{}={}", self.leaf_latex(leaf), self.to_latex(e)))
        });
        format!(r"\left.{derivative}\right|_{{{}}}", moved.collect::<Vec<_>>().join(","))
    }

    /// The derivative of a field, as a fraction.
    fn with_partials(&self, leaf: Leaf, field: String) -> String {
        let power = |n: u32| if n == 1 { String::new() } else { format!("^{n}") };
        let order = leaf.partials.order();
        if order == 0 {
            return field;
        }
        let by = self.coordinates().zip(leaf.partials.orders()).filter(|(_, n)| *n > 0);
        let by = by.map(|(leaf, n)| format!(r"\partial {}{}", self.leaf_latex(leaf), power(u32::from(n))));
        format!(r"\frac{{\partial{} {field}}}{{{}}}", power(order), by.collect::<String>())
    }

    /// An expression as LaTeX.
    pub fn to_latex(&self, e: Expr) -> String {
        self.printed(e).0
    }

    fn is_branch(&self, e: Expr) -> bool {
        matches!(self.node(e), Node::Leaf(leaf) if self.name(leaf.symbol) == BRANCH)
    }

    fn printed(&self, e: Expr) -> (String, Bond) {
        let mut printed: HashMap<Expr, (String, Bond)> = HashMap::new();
        for node in self.reachable([e]) {
            let mut text = match self.node(node) {
                Node::Constant(r) => number(r),
                Node::Pi => (r"\pi".to_owned(), Bond::Factor),
                Node::Leaf(_) if self.is_branch(node) => (r"(\pm1)".to_owned(), Bond::Factor),
                Node::Leaf(leaf) => {
                    let name = self.name(leaf.symbol);
                    // `\mu^{(1)}` has its superscript already; a prime is none, nor is one in brackets.
                    let labelled = name.contains('^') && !name.contains(r"\prime") && !name.ends_with(']');
                    let plain = self.part(*leaf).is_none() && leaf.partials.is_none() && !labelled;
                    (self.leaf_latex(*leaf), if plain { Bond::Symbol } else { Bond::Factor })
                }
                Node::Binary(Op::Mul, a, b) if self.is_branch(*a) && !self.is_branch(*b) => {
                    (format!(r"\pm {}", wrapped(&printed[b], Bond::Product)), Bond::Sum)
                }
                Node::Binary(Op::Add, a, b) if self.is_signed(*b) => {
                    (format!("{}{}", printed[a].0, printed[b].0), Bond::Sum)
                }
                Node::Binary(Op::Sub, a, b) if self.is_signed(*b) => {
                    (format!("{}{}", printed[a].0, printed[b].0.replacen(BRANCH, r"\mp", 1)), Bond::Sum)
                }
                Node::Unary(Op::Neg, a) if self.is_signed(*a) => (printed[a].0.replacen(BRANCH, r"\mp", 1), Bond::Sum),
                Node::Unary(op, a) => unary(*op, &printed[a]),
                Node::Binary(op, a, b) => binary(*op, &printed[a], &printed[b]),
            };
            if text.0.len() > LONGEST {
                text = (r"\ldots".to_owned(), Bond::Factor);
            }
            printed.insert(node, text);
        }
        printed.remove(&e).unwrap_or_else(|| (String::new(), Bond::Factor))
    }

    /// Whether the expression is printed with ± before it.
    fn is_signed(&self, e: Expr) -> bool {
        matches!(self.node(e), Node::Binary(Op::Mul, a, b) if self.is_branch(*a) && !self.is_branch(*b))
    }
}

/// The label of a name and the indices of a component in one subscript. In `(n-k)` the letters are places for indices.
fn subscript(label: &str, indices: &[String]) -> String {
    let letters = label.chars().filter(char::is_ascii_alphabetic).count();
    if label.contains(['(', '-', '+']) && letters == indices.len() {
        let mut next = indices.iter();
        return label
            .chars()
            .map(|c| match c.is_ascii_alphabetic() {
                true => next.next().cloned().unwrap_or_default(),
                false => c.to_string(),
            })
            .collect();
    }
    let label =
        if label.starts_with(r"\rm") && !indices.is_empty() { format!("{{{label}}}") } else { label.to_owned() };
    format!("{label}{}", indices.concat())
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
        Op::Powi(n @ 2..=9) if a.1 == Bond::Symbol => (format!("{}^{n}", a.0), Bond::Factor),
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
        // As its formula: what it is restricted to is seen in the text that it was read from.
        Op::Restrict => a.clone(),
        Op::Pow => {
            // An exponent needs no parentheses.
            let exponent = if b.0 == r"(\pm1)" { r"\pm1" } else { &b.0 };
            (format!("({})^{{{exponent}}}", a.0), Bond::Factor)
        }
        _ => (format!("{}({},{})", op.spelling(), a.0, b.0), Bond::Factor),
    }
}
