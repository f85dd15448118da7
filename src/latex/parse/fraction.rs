//! What takes its arguments in braces: fractions, derivatives, roots, matrices.

use super::super::lexer::Kind;
use super::super::name::{self, NAMES};
use super::super::syntax::{Node, NodeKind};
use super::names::plain;
use super::{Open, Parsed, Parser, decimal, refuse};

/// Most rows or columns of a matrix that is written out.
const WIDEST: usize = 32;

impl Parser<'_> {
    /// One TeX argument: a group, or a single token.
    pub(super) fn argument(&mut self) -> Parsed<Node> {
        if self.eat('{') {
            let outer = std::mem::replace(&mut self.bars, 0);
            let inner = self.sum()?;
            self.expect('}')?;
            self.bars = outer;
            return Ok(inner);
        }
        let start = self.span().start;
        if let Kind::Number(n) = self.kind().clone() {
            // `\frac12`: TeX takes one digit at a time.
            if n.contains('.') {
                return refuse("latex::ambiguous", "LaTeX takes only the first digit", self.span(), "use braces");
            }
            let (first, rest) = n.split_at(1);
            let node = Node { kind: NodeKind::Number(decimal(first)), span: start..start + 1 };
            if rest.is_empty() {
                self.bump();
            } else {
                let token = &mut self.tokens[self.at];
                token.kind = Kind::Number(rest.to_owned());
                token.span.start += 1;
            }
            return Ok(node);
        }
        if self.is_pi() {
            self.bump();
            return Ok(self.node(NodeKind::Pi, start));
        }
        if *self.kind() == Kind::Letter('e') && !self.scope.declares("e") {
            self.bump();
            return Ok(self.node(NodeKind::Euler { upright: false }, start));
        }
        match self.name_without_primes()? {
            Some((name, span)) => Ok(Node { kind: NodeKind::Symbol(plain(name)), span }),
            None => {
                let message = format!("{} stands where an argument is expected", self.shown());
                refuse("latex::unexpected", message, self.span(), "use braces")
            }
        }
    }

    /// After `\sqrt`.
    pub(super) fn root(&mut self, start: usize) -> Parsed<Node> {
        let mut degree = 2;
        if self.eat('[') {
            let span = self.span();
            degree = match self.kind() {
                Kind::Number(n) => n.parse().ok().filter(|d| (2..=64).contains(d)).unwrap_or(0),
                _ => 0,
            };
            if degree == 0 {
                let message = "the degree of a root is a number between 2 and 64";
                return refuse("latex::unexpected", message, span, "");
            }
            self.bump();
            self.expect(']')?;
        }
        let inner = self.argument()?;
        Ok(self.node(NodeKind::Root(Box::new(inner), degree), start))
    }

    /// After `\binom`: two whole numbers.
    pub(super) fn binomial(&mut self, start: usize) -> Parsed<Node> {
        let arguments = vec![self.argument()?, self.argument()?];
        Ok(self.node(NodeKind::Function("binom".to_owned(), None, arguments), start))
    }

    /// After `\frac`: a quotient, or a derivative in Leibniz' notation.
    pub(super) fn fraction(&mut self, start: usize) -> Parsed<Node> {
        if let Some(derivative) = self.leibniz(start)? {
            return Ok(derivative);
        }
        if let Some(derivative) = self.partial_fraction(start)? {
            return Ok(derivative);
        }
        if let Some(derivative) = self.following_fraction(start)? {
            return Ok(derivative);
        }
        if let Some(derivative) = self.variation_fraction(start)? {
            return Ok(derivative);
        }
        let top = Box::new(self.argument()?);
        let bottom = Box::new(self.argument()?);
        Ok(self.node(NodeKind::Quotient { top, bottom, slash: false }, start))
    }

    /// Number of tokens of the d of a differential at an offset: `d`, `\mathrm d`, `\mathrm{d}`, `\text{d}`, `{\rm d}`.
    fn differential_at(&self, offset: usize) -> Option<usize> {
        let named = |i: usize| matches!(self.kind_after(i), Kind::Sign('_' | '\''));
        let d = |i: usize| *self.kind_after(offset + i) == Kind::Letter('d') && !named(offset + i + 1);
        let command = |i: usize, names: &[&str]| matches!(self.kind_after(offset + i), Kind::Command(c) if names.contains(&c.as_str()));
        let upright: &[&str] = &["mathrm", "text", "textrm", "operatorname"];
        let sign = |i: usize, c: char| *self.kind_after(offset + i) == Kind::Sign(c);
        if d(0) {
            Some(1)
        } else if command(0, upright) && d(1) {
            Some(2)
        } else if (command(0, upright) && sign(1, '{') && d(2) && sign(3, '}'))
            || (sign(0, '{') && command(1, &["rm"]) && d(2) && sign(3, '}'))
        {
            Some(4)
        } else {
            None
        }
    }

    /// Eats the d of a differential.
    fn differential(&mut self) -> bool {
        match self.differential_at(0) {
            Some(tokens) => {
                self.at += tokens;
                true
            }
            None => false,
        }
    }

    /// Number of tokens of the d of a differential that is not part of a fraction: it is not declared, and a name follows.
    pub(super) fn begins_differential(&self) -> Parsed<Option<usize>> {
        let Some(tokens) = self.differential_at(0) else { return Ok(None) };
        let upright = *self.kind() != Kind::Letter('d');
        if self.scope.is_known(if upright { "rm:d" } else { "d" }, None) || !upright && self.spelled_name()?.is_some() {
            return Ok(None);
        }
        let named = match self.kind_after(tokens) {
            Kind::Letter(_) => true,
            Kind::Command(c) => NAMES.contains(&c.as_str()) || matches!(name::style(c), Some("bf" | "vec")),
            Kind::Sign('{') => matches!(self.kind_after(tokens + 1), Kind::Command(c) if c == "bf"),
            Kind::Sign('[' | '(') => true,
            _ => false,
        };
        Ok(named.then_some(tokens))
    }

    /// At the d: what it is the differential of.
    pub(super) fn free_differential(&mut self, tokens: usize, start: usize) -> Parsed<Node> {
        let upright = *self.kind() != Kind::Letter('d');
        self.at += tokens;
        let of = self.primary()?;
        let clear = |n: &Node| match &n.kind {
            NodeKind::Symbol(s) => s.sup.is_none(),
            NodeKind::Group(..) => true,
            _ => false,
        };
        let Some(of) = of.filter(clear) else {
            let message = "it is not clear what this is the differential of";
            let hint = r"write `d` before one symbol or before parentheses, and powers of differentials as products";
            return refuse("latex::ambiguous", message, start..self.last_end(), hint);
        };
        self.rate_is_clear(&of)?;
        Ok(self.node(NodeKind::Differential { of: Box::new(of), upright }, start))
    }

    /// The order in `d^2`; 1 without a superscript.
    pub(super) fn differential_order(&mut self) -> Parsed<u8> {
        if !self.eat('^') {
            return Ok(1);
        }
        let braced = self.eat('{');
        let order = match self.kind().clone() {
            Kind::Number(n) => n.parse::<u8>().ok(),
            _ => None,
        };
        let Some(order @ 1..=9) = order else {
            let message = "the order of a derivative lies between 1 and 9";
            return refuse("latex::derivative", message, self.span(), "");
        };
        self.bump();
        if braced {
            self.expect('}')?;
        }
        Ok(order)
    }

    /// Position of the token behind the group that opens at the present place.
    pub(super) fn behind_group(&self) -> Option<usize> {
        let mut depth = 0usize;
        for (i, token) in self.tokens.iter().enumerate().skip(self.at) {
            match token.kind {
                Kind::Sign('{') => depth += 1,
                Kind::Sign('}') => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        return Some(i + 1);
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// Whether a derivative in Leibniz' notation begins so many tokens ahead.
    pub(super) fn begins_derivative_after(&self, n: usize) -> bool {
        let fraction =
            matches!(self.kind_after(n), Kind::Command(c) if matches!(c.as_str(), "frac" | "tfrac" | "dfrac"));
        fraction && *self.kind_after(n + 1) == Kind::Sign('{') && self.differential_at(n + 2).is_some()
            || self.begins_partial_after(n)
    }

    fn leibniz(&mut self, start: usize) -> Parsed<Option<Node>> {
        if !self.is('{') || self.differential_at(1).is_none() {
            return Ok(None);
        }
        let below = self.behind_group().and_then(|i| i.checked_sub(self.at));
        // `{dx}^2` prints what `dx^2` does.
        let braced =
            below.is_some_and(|b| *self.kind_after(b + 1) == Kind::Sign('{') && self.differential_at(b + 2).is_some());
        let both = below.is_some_and(|b| {
            *self.kind_after(b) == Kind::Sign('{') && (braced || self.differential_at(b + 1).is_some())
        });
        if *self.kind_after(1) == Kind::Letter('d') && self.scope.is_known("d", None) {
            if !both {
                return Ok(None);
            }
            let message = "`d` is declared: a derivative, or a quotient of products?";
            let hint = r"write `\frac{\mathrm{d}x}{\mathrm{d}t}` for the derivative";
            return refuse("latex::ambiguous", message, start..self.last_end(), hint);
        }
        if !both {
            let hint = r"write `\frac{dx}{dt}` or `\frac{d}{dt}(…)`";
            let message = "the denominator of a derivative is a differential";
            let span =
                below.map_or(self.span(), |b| self.tokens[(self.at + b).min(self.tokens.len() - 1)].span.clone());
            return refuse("latex::derivative", message, span, hint);
        }
        let upright = *self.kind_after(1) != Kind::Letter('d');
        self.bump();
        self.differential();
        let order = self.differential_order()?;
        let mut of = None;
        if !self.is('}') {
            let span = self.span();
            of = self.factor()?;
            let raised = match of.as_ref().map(|n| &n.kind) {
                Some(NodeKind::Symbol(s)) => s.sup.is_some(),
                Some(NodeKind::Scripted { sup, .. }) => sup.is_some(),
                _ => false,
            };
            if raised || of.is_none() || !self.is('}') {
                let message = "it is not clear what is derived";
                let hint = r"put it into parentheses, `\frac{d(…)}{dt}`, or write `\frac{d}{dt}(…)`";
                return refuse("latex::ambiguous", message, span.start..self.span().end, hint);
            }
        }
        self.expect('}')?;
        self.expect('{')?;
        if braced {
            self.expect('{')?;
        }
        self.differential();
        let by_start = self.span().start;
        let Some((name, _)) = self.single_name()? else {
            let hint = r"write `\frac{dx}{dt}`";
            return refuse("latex::derivative", "a derivative is by one symbol", self.span(), hint);
        };
        let mut symbol = plain(name);
        if self.eat('_') {
            symbol.sub = Some(self.subscript()?);
        }
        let by = Box::new(self.node(NodeKind::Symbol(symbol), by_start));
        if braced {
            self.expect('}')?;
        }
        if self.differential_order()? != order {
            let message = "the two orders of the derivative differ";
            return refuse("latex::derivative", message, by_start..self.last_end(), "");
        }
        self.expect('}')?;
        if let Some(of) = of {
            self.rate_is_clear(&of)?;
            let kind = NodeKind::Derivative { of: Box::new(of), by, order, operator: false, upright };
            return Ok(Some(self.node(kind, start)));
        }
        let of = self.derived(std::slice::from_ref(&by), r"write `\frac{d}{dt}(…)`")?;
        self.rate_is_clear(&of)?;
        let grouped = matches!(of.kind, NodeKind::Group(..));
        let kind = NodeKind::Derivative { of: Box::new(of), by, order, operator: true, upright };
        let node = self.node(kind, start);
        if !grouped {
            let clear = matches!(&node.kind, NodeKind::Derivative { of, .. }
                if matches!(&of.kind, NodeKind::Symbol(s) if s.arguments.is_some()));
            self.leave_open(Open::Operator { clear });
        }
        Ok(Some(node))
    }

    /// In the exponent of Euler's number, `e^{-x^2/4Dt}`: letters that touch the denominator belong to it, since a script is
    /// set without spaces, and what is divided stands before the slash. Two prints are left out that are also used for the
    /// other meaning: a bare number above, `e^{-1/2x^2}`, and a power below where there is none above, `e^{-a/2x^2}`.
    pub(super) fn tight_denominator(&mut self, numerator: &Node, first: Node) -> Parsed<Node> {
        let single = |n: &Node| match &n.kind {
            NodeKind::Symbol(s) => s.arguments.is_none() && s.dots == 0,
            NodeKind::Number(_) | NodeKind::Pi => true,
            _ => false,
        };
        if self.exponent != Some(self.depth) || numerator.is_numeric() || !single(&first) {
            return Ok(first);
        }
        let (back, start) = (self.at, first.span.start);
        let mut factors = vec![first.clone()];
        let letter = |kind: &Kind| match kind {
            Kind::Letter(_) => true,
            Kind::Command(c) => NAMES.contains(&c.as_str()) || c == "pi",
            _ => false,
        };
        while letter(self.kind()) && !self.is_spaced() {
            match self.factor()? {
                Some(factor) if single(&factor) => factors.push(factor),
                _ => {
                    self.at = back;
                    return Ok(first);
                }
            }
        }
        if factors.len() == 1 || factors.iter().any(shows_power) && !shows_power(numerator) {
            self.at = back;
            return Ok(first);
        }
        Ok(self.node(NodeKind::Product(factors), start))
    }

    /// After `\begin`.
    pub(super) fn matrix(&mut self, start: usize) -> Parsed<Node> {
        let span = self.span();
        let Some(environment) = self.word() else {
            return refuse("latex::unexpected", "`\\begin` needs the name of an environment", span, "");
        };
        match environment.as_str() {
            "array" => {
                self.expect('{')?;
                while !self.is('}') && *self.kind() != Kind::End {
                    self.bump();
                }
                self.expect('}')?;
            }
            "pmatrix" | "bmatrix" | "matrix" | "psmallmatrix" | "bsmallmatrix" | "smallmatrix" | "vmatrix" => {}
            _ => {
                let message = format!("the environment `{environment}` is not known");
                return refuse("latex::unsupported", message, span, "use `pmatrix`");
            }
        }
        let mut rows = vec![Vec::new()];
        loop {
            let cell = self.sum()?;
            if let Some(row) = rows.last_mut() {
                row.push(cell);
            }
            if self.eat('&') {
                continue;
            }
            if *self.kind() == Kind::Row {
                self.bump();
                if !self.is_command("end") {
                    rows.push(Vec::new());
                    continue;
                }
            }
            if self.is_command("end") {
                self.bump();
                if self.word().as_deref() != Some(environment.as_str()) {
                    let message = format!("`\\begin{{{environment}}}` is closed by another environment");
                    return refuse("latex::unbalanced", message, span, "");
                }
                break;
            }
            let message = format!("{} is not expected in a matrix", self.shown());
            return refuse("latex::unexpected", message, self.span(), "");
        }
        let columns = rows.first().map_or(0, Vec::len);
        if rows.iter().any(|r| r.len() != columns) {
            return refuse("latex::shape", "the rows of the matrix differ in length", start..self.last_end(), "");
        }
        if rows.len() > WIDEST || columns > WIDEST {
            return refuse("latex::too-large", format!("a matrix of more than {WIDEST} rows or columns"), span, "");
        }
        let matrix = self.node(NodeKind::Matrix(rows), start);
        Ok(match environment.as_str() {
            // Between bars stands its determinant.
            "vmatrix" => self.node(NodeKind::Function("det".to_owned(), None, vec![matrix]), start),
            _ => matrix,
        })
    }
}

/// Whether something is raised to a power somewhere outside of brackets.
fn shows_power(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Symbol(s) => s.sup.is_some(),
        NodeKind::Scripted { sup, .. } => sup.is_some(),
        NodeKind::Product(parts) => parts.iter().any(shows_power),
        _ => false,
    }
}
