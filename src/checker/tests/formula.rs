//! Formulas and sequents for tests, in a short notation: `x'' + 2*x(0) = sin(t)`.

use crate::*;

/// A formula as a term.
pub(super) fn term(text: &str) -> Term {
    let mut parser = Parser { rest: text.chars().filter(|c| !c.is_whitespace()).collect(), at: 0, nodes: Vec::new() };
    parser.sum();
    assert_eq!(parser.at, parser.rest.len(), "{text}");
    Term(parser.nodes)
}

/// A relation: one of = # < ≤ between formulas (# for ≠), or > ≥.
pub(super) fn rel(text: &str) -> Relation {
    let at = text.find(['=', '#', '<', '≤', '>', '≥']).expect("a relation");
    let sign = text[at..].chars().next().expect("a sign");
    let (left, right) = (term(&text[..at]), term(&text[at + sign.len_utf8()..]));
    match sign {
        '=' => Relation { left, sense: Sense::Equal, right },
        '#' => Relation { left, sense: Sense::NotEqual, right },
        '<' => Relation { left, sense: Sense::Less, right },
        '≤' => Relation { left, sense: Sense::LessOrEqual, right },
        '>' => Relation { left: right, sense: Sense::Less, right: left },
        _ => Relation { left: right, sense: Sense::LessOrEqual, right: left },
    }
}

struct Parser {
    rest: Vec<char>,
    at: usize,
    nodes: Vec<TermNode>,
}

impl Parser {
    fn peek(&self) -> char {
        self.rest.get(self.at).copied().unwrap_or('\0')
    }
    fn eat(&mut self, c: char) -> bool {
        let found = self.peek() == c;
        self.at += usize::from(found);
        found
    }
    fn push(&mut self, node: TermNode) -> u32 {
        self.nodes.push(node);
        self.nodes.len() as u32 - 1
    }
    fn apply(&mut self, name: &str, of: Vec<u32>) -> u32 {
        self.push(TermNode::Apply(name.to_owned(), of))
    }
    fn sum(&mut self) -> u32 {
        let mut out = self.product();
        loop {
            if self.eat('+') {
                let b = self.product();
                out = self.apply("+", vec![out, b]);
            } else if self.eat('-') {
                let b = self.product();
                out = self.apply("-", vec![out, b]);
            } else {
                return out;
            }
        }
    }
    fn product(&mut self) -> u32 {
        if self.eat('-') {
            let a = self.product();
            return self.apply("-", vec![a]);
        }
        let mut out = self.power();
        loop {
            if self.eat('*') {
                let b = self.power();
                out = self.apply(r"\cdot", vec![out, b]);
            } else if self.eat('/') {
                let b = self.power();
                out = self.apply(r"\frac", vec![out, b]);
            } else {
                return out;
            }
        }
    }
    fn power(&mut self) -> u32 {
        let base = self.atom();
        if !self.eat('^') {
            return base;
        }
        if self.peek().is_ascii_digit() {
            let n = self.digits();
            return self.apply(&format!("^{n}"), vec![base]);
        }
        let exponent = self.atom();
        self.apply("^", vec![base, exponent])
    }
    fn digits(&mut self) -> String {
        let start = self.at;
        while self.peek().is_ascii_digit() {
            self.at += 1;
        }
        self.rest[start..self.at].iter().collect()
    }
    fn atom(&mut self) -> u32 {
        if self.eat('(') {
            let e = self.sum();
            assert!(self.eat(')'));
            return e;
        }
        if self.peek().is_ascii_digit() {
            let n = self.digits();
            return self.push(TermNode::Number(n));
        }
        let start = self.at;
        while self.peek().is_ascii_alphanumeric() {
            self.at += 1;
        }
        let name: String = self.rest[start..self.at].iter().collect();
        let op = match name.as_str() {
            "pi" => return self.push(TermNode::Pi),
            "sqrt" | "exp" | "ln" | "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "arcsin" | "arccos"
            | "arctan" => Some(format!(r"\{name}")),
            "abs" => Some(r"|\cdot|".to_owned()),
            "atan2" | "agm" => Some(format!(r"\operatorname{{{name}}}")),
            "restrict" => Some(r"\restriction".to_owned()),
            _ => None,
        };
        if let Some(op) = op {
            assert!(self.eat('('), "{name}");
            let mut of = vec![self.sum()];
            while self.eat(',') {
                of.push(self.sum());
            }
            assert!(self.eat(')'));
            return self.apply(&op, of);
        }
        let mut rate = 0;
        while self.eat('\'') {
            rate += 1;
        }
        let at = self.eat('(').then(|| {
            let e = self.sum();
            assert!(self.eat(')'));
            e
        });
        self.push(TermNode::Leaf { name, component: 0, rate, at })
    }
}

/// A symbol.
pub(super) fn declared(name: &str, kind: SymbolKind) -> Declared {
    Declared { name: name.to_owned(), components: 1, kind }
}

/// The time t, states with so many rates, and a claim.
pub(super) fn sequent(states: &str, orders: u8, claim: &str) -> Sequent {
    let mut symbols = vec![declared("t", SymbolKind::Time)];
    symbols.extend(states.split(',').filter(|s| !s.is_empty()).map(|s| declared(s, SymbolKind::Moves(orders))));
    Sequent::of(symbols, rel(claim))
}

impl Sequent {
    pub(super) fn premise(mut self, text: &str) -> Sequent {
        self.premises.push(rel(text));
        self
    }
    pub(super) fn system(mut self, text: &str) -> Sequent {
        self.systems.push(rel(text));
        self
    }
    pub(super) fn assuming(mut self, text: &str) -> Sequent {
        self.assumed.push(rel(text));
        self
    }
    pub(super) fn selector(mut self, text: &str) -> Sequent {
        self.selectors.push(rel(text));
        self
    }
    pub(super) fn instant(mut self, text: &str) -> Sequent {
        self.instants.push(term(text));
        self
    }
    pub(super) fn constant(mut self, name: &str, sign: ConstantSign) -> Sequent {
        self.symbols.push(declared(name, SymbolKind::Constant(sign)));
        self
    }
    pub(super) fn define(mut self, name: &str, formula: &str) -> Sequent {
        self.symbols.push(declared(name, SymbolKind::Defined));
        self.definitions.push(Definition { name: name.to_owned(), component: 0, formula: term(formula) });
        self
    }
}

/// A draft that tests write proofs with.
pub(super) struct Work(pub(super) Draft);

impl Work {
    pub(super) fn new(sequent: &Sequent) -> Work {
        Work(Draft::new(sequent).expect("a sequent"))
    }
    /// A step that is taken.
    pub(super) fn step(&mut self, step: Step) -> FactId {
        let made = self.0.push(step).unwrap_or_else(|refused| panic!("{refused}\n{}", self.all()));
        made.or(self.0.last()).unwrap_or(FactId(0))
    }
    /// A step that is refused, for a reason that has these words.
    pub(super) fn refuse(&mut self, step: Step, why: &str) {
        match self.0.push(step) {
            Err(refused) => assert!(refused.why.contains(why), "{refused}"),
            Ok(made) => panic!("accepted: {}\n{}", made.map(|id| self.0.words(id)).unwrap_or_default(), self.all()),
        }
    }
    pub(super) fn all(&self) -> String {
        (0..1000)
            .map(FactId)
            .take_while(|id| self.0.fact(*id).is_some())
            .map(|id| format!("{}: {}\n", id.0, self.0.words(id)))
            .collect()
    }
    pub(super) fn premise(&mut self, at: u32) -> FactId {
        self.step(Step::Given { given: Given::Premise(at), because: vec![] })
    }
    pub(super) fn given(&mut self, given: Given) -> FactId {
        self.step(Step::Given { given, because: vec![] })
    }
    pub(super) fn rate(&mut self, fact: FactId) -> FactId {
        self.step(Step::Rate { fact })
    }
    pub(super) fn zero(&mut self, says: &str, d: &str, terms: &[(FactId, &str)]) -> FactId {
        self.step(zero(says, d, terms))
    }
    pub(super) fn sign(&mut self, says: &str, from: &[FactId]) -> FactId {
        self.step(Step::Sign { says: rel(says), from: from.to_vec() })
    }
    pub(super) fn discharge(&mut self, fact: FactId, because: &[FactId]) -> FactId {
        self.step(Step::Discharge { fact, because: because.to_vec() })
    }
    pub(super) fn law(&mut self, law: Law, of: &[&str]) -> FactId {
        self.step(Step::Law { law, of: of.iter().map(|e| term(e)).collect() })
    }
    /// A relation as the draft writes it.
    pub(super) fn read(&mut self, says: &str) -> Relation {
        let says = self.0.context.relation(&rel(says)).expect("a relation");
        self.0.context.written(says).expect("a relation")
    }
    /// Opens a case: its number.
    pub(super) fn suppose(&mut self, says: &str, manner: Manner) -> CaseId {
        self.step(Step::Suppose { says: rel(says), manner });
        CaseId(self.0.cases.len() as u32 - 1)
    }
    pub(super) fn supposed(&mut self, case: CaseId, within: When) -> FactId {
        self.step(Step::Supposition { case, within })
    }
    /// Ends the proof, and replays its record.
    pub(super) fn end(mut self, sequent: &Sequent, fact: FactId) -> Shown {
        self.step(Step::Conclude { fact });
        let (steps, shown) = self.0.finish().expect("an end");
        let text = serde_json::to_string(&steps).expect("steps can be written");
        let read: Vec<Step> = serde_json::from_str(&text).expect("steps can be read");
        assert_eq!(read, steps);
        assert_eq!(replay(sequent, &read).expect("a proof that replays"), shown);
        shown
    }
}

/// A step of algebra.
pub(super) fn zero(says: &str, d: &str, terms: &[(FactId, &str)]) -> Step {
    let terms = terms.iter().map(|(id, q)| (*id, term(q))).collect();
    Step::Zero { says: rel(says), multiplier: term(d), terms, insert: vec![], modulo: vec![] }
}

/// An equation that is an identity when others are put in.
pub(super) fn inserted(says: &str, insert: &[FactId]) -> Step {
    Step::Zero { says: rel(says), multiplier: term("1"), terms: vec![], insert: insert.to_vec(), modulo: vec![] }
}
