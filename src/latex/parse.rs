//! Tokens → syntax tree.
//!
//! A strict recursive-descent parser: what it does not understand it refuses, with the place and a way to write it. The
//! scope is asked only where a text has two readings (is `f(x)` a value of f or a product?).

use std::ops::Range;

use super::lexer::{Kind, Token, tokens};
use super::name::{self, NAMES, canonical};
use super::scope::Scope;
use super::syntax::{Chain, Name, Node, NodeKind, RelationKind, Sign, SubItem, SymbolNode, Target};
use crate::diag::Problem;
use crate::number::Rational;

/// Deepest nesting of brackets, roots and fractions.
const DEEPEST: usize = 100;

/// Functions of one argument that need no parentheses.
const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "ln", "log", "det", "cot", "sec",
    "csc",
];

/// Functions written with `\operatorname` or `\rm`, and their number of arguments.
const OPERATORS: &[(&str, usize)] =
    &[("atan2", 2), ("agm", 2), ("tr", 1), ("diag", 0), ("diagonal", 0), ("arsinh", 1), ("arcosh", 1), ("artanh", 1)];

type Parsed<T> = Result<T, Box<Problem>>;

fn refuse<T>(code: &'static str, message: impl Into<String>, span: Range<usize>, hint: impl Into<String>) -> Parsed<T> {
    let hint = hint.into();
    Err(Box::new(Problem { code, message: message.into(), span, hint: (!hint.is_empty()).then_some(hint) }))
}

pub(super) struct Parser<'a> {
    text: &'a str,
    scope: &'a Scope,
    tokens: Vec<Token>,
    at: usize,
    depth: usize,
    bars: usize,
}

/// Reads all chains of relations of a text; a chain may be a single expression.
pub(super) fn chains(text: &str, scope: &Scope) -> Result<Vec<Chain>, Vec<Problem>> {
    let tokens = tokens(text)?;
    let mut parser = Parser { text, scope, tokens, at: 0, depth: 0, bars: 0 };
    parser.balanced().map_err(|p| vec![*p])?;
    parser.all().map_err(|p| vec![*p])
}

impl Parser<'_> {
    /// Finds unbalanced delimiters before anything else, so that they are named at their opening.
    fn balanced(&self) -> Parsed<()> {
        let mut open: Vec<(char, Range<usize>)> = Vec::new();
        let close = |c| match c {
            '(' => ')',
            '[' => ']',
            _ => '}',
        };
        for token in &self.tokens {
            match token.kind {
                Kind::Sign(c @ ('(' | '[' | '{')) => open.push((c, token.span.clone())),
                Kind::Sign(c @ (')' | ']' | '}')) => match open.pop() {
                    Some((o, _)) if close(o) == c => {}
                    Some((o, span)) => {
                        return refuse(
                            "latex::unbalanced",
                            format!("`{o}` is closed by `{c}`"),
                            span,
                            format!("close it with `{}`", close(o)),
                        );
                    }
                    None => {
                        return refuse("latex::unbalanced", format!("`{c}` was never opened"), token.span.clone(), "");
                    }
                },
                _ => {}
            }
            if open.len() > 4 * DEEPEST {
                return refuse(
                    "latex::too-deep",
                    "the nesting is too deep",
                    token.span.clone(),
                    "use a declared abbreviation",
                );
            }
        }
        match open.pop() {
            Some((c, span)) => refuse("latex::unbalanced", format!("`{c}` is never closed"), span, ""),
            None => Ok(()),
        }
    }

    fn kind(&self) -> &Kind {
        &self.tokens[self.at.min(self.tokens.len() - 1)].kind
    }

    fn kind_after(&self, n: usize) -> &Kind {
        &self.tokens[(self.at + n).min(self.tokens.len() - 1)].kind
    }

    fn span(&self) -> Range<usize> {
        self.tokens[self.at.min(self.tokens.len() - 1)].span.clone()
    }

    fn last_end(&self) -> usize {
        if self.at == 0 { 0 } else { self.tokens[self.at - 1].span.end }
    }

    fn bump(&mut self) {
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
    }

    fn is(&self, c: char) -> bool {
        *self.kind() == Kind::Sign(c)
    }

    fn is_command(&self, name: &str) -> bool {
        matches!(self.kind(), Kind::Command(c) if c == name)
    }

    fn eat(&mut self, c: char) -> bool {
        let found = self.is(c);
        if found {
            self.bump();
        }
        found
    }

    fn shown(&self) -> String {
        match self.kind() {
            Kind::End => "the end of the formula".to_owned(),
            _ => format!("`{}`", &self.text[self.span()]),
        }
    }

    fn expect(&mut self, c: char) -> Parsed<()> {
        if self.eat(c) {
            return Ok(());
        }
        refuse("latex::unexpected", format!("{} stands where `{c}` is expected", self.shown()), self.span(), "")
    }

    fn deeper<T>(&mut self, inner: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth >= DEEPEST {
            return refuse("latex::too-deep", "the nesting is too deep", self.span(), "use a declared abbreviation");
        }
        self.depth += 1;
        let result = inner(self);
        self.depth -= 1;
        result
    }

    fn separator(&self) -> bool {
        matches!(self.kind(), Kind::Sign(',' | '.' | ';') | Kind::Row)
    }

    fn all(&mut self) -> Parsed<Vec<Chain>> {
        let mut out = Vec::new();
        while self.separator() {
            self.bump();
        }
        if *self.kind() == Kind::End {
            return refuse("latex::empty", "there is no formula here", self.span(), "");
        }
        loop {
            out.push(self.chain()?);
            if *self.kind() != Kind::End && !self.separator() {
                return refuse("latex::unexpected", format!("{} is not expected here", self.shown()), self.span(), "");
            }
            while self.separator() || self.is('&') {
                self.bump();
            }
            if *self.kind() == Kind::End {
                return Ok(out);
            }
        }
    }

    fn relation(&self) -> Option<RelationKind> {
        Some(match self.kind() {
            Kind::Sign('=') => RelationKind::Equal,
            Kind::Sign('<') => RelationKind::Less,
            Kind::Sign('>') => RelationKind::Greater,
            Kind::Command(c) => match c.as_str() {
                "equiv" => RelationKind::Equal,
                "ne" | "neq" => RelationKind::NotEqual,
                "lt" => RelationKind::Less,
                "gt" => RelationKind::Greater,
                "le" | "leq" | "leqslant" => RelationKind::LessEqual,
                "ge" | "geq" | "geqslant" => RelationKind::GreaterEqual,
                _ => return None,
            },
            _ => return None,
        })
    }

    fn chain(&mut self) -> Parsed<Chain> {
        let start = self.span().start;
        let mut sides = vec![self.side()?];
        let mut relations = Vec::new();
        loop {
            if self.is('&') {
                self.bump();
                continue;
            }
            let Some(relation) = self.relation() else { break };
            self.bump();
            while self.is('&') {
                self.bump();
            }
            relations.push(relation);
            sides.push(self.side()?);
        }
        Ok(Chain { sides, relations, span: start..self.last_end() })
    }

    fn side(&mut self) -> Parsed<Node> {
        if !self.is_command("lim") {
            return self.sum();
        }
        let start = self.span().start;
        self.bump();
        self.expect('_')?;
        self.expect('{')?;
        let variable = self.span();
        let Some(Node { kind: NodeKind::Symbol(symbol), .. }) = self.primary()? else {
            return refuse("latex::limit", "a limit goes along the time", variable, r"write `\lim_{t\rightarrow t_0}`");
        };
        if self.scope.time_name() != Some(symbol.name.as_str()) {
            return refuse("latex::limit", "a limit goes along the time", variable, r"write `\lim_{t\rightarrow t_0}`");
        }
        if !(self.is_command("rightarrow") || self.is_command("to")) {
            return refuse(
                "latex::limit",
                format!("{} stands where `\\rightarrow` is expected", self.shown()),
                self.span(),
                "",
            );
        }
        self.bump();
        let sign = self.eat('-');
        let plus = !sign && self.eat('+');
        let target = if self.is_command("infty") {
            self.bump();
            if sign { Target::MinusInfinity } else { Target::PlusInfinity }
        } else if plus {
            return refuse("latex::limit", "`+` is only expected before `\\infty` here", self.span(), "");
        } else {
            let at = self.span().start;
            let inner = self.sum()?;
            let span = at..self.last_end();
            let inner = if sign { Node { kind: NodeKind::Sum(vec![(Sign::Minus, inner)]), span } } else { inner };
            Target::Finite(Box::new(inner))
        };
        self.expect('}')?;
        let body = self.sum()?;
        Ok(Node { span: start..body.span.end, kind: NodeKind::Limit(Box::new(body), target) })
    }

    fn sign(&mut self) -> Option<Sign> {
        let sign = match self.kind() {
            Kind::Sign('+') => Sign::Plus,
            Kind::Sign('-') => Sign::Minus,
            Kind::Command(c) if c == "pm" => Sign::PlusMinus,
            Kind::Command(c) if c == "mp" => Sign::MinusPlus,
            _ => return None,
        };
        self.bump();
        Some(sign)
    }

    fn sum(&mut self) -> Parsed<Node> {
        self.deeper(|p| {
            let start = p.span().start;
            let first = p.sign();
            let term = p.term()?;
            if first.is_none()
                && !matches!(p.kind(), Kind::Sign('+' | '-'))
                && !p.is_command("pm")
                && !p.is_command("mp")
            {
                return Ok(term);
            }
            let mut terms = vec![(first.unwrap_or(Sign::Plus), term)];
            while let Some(sign) = p.sign() {
                terms.push((sign, p.term()?));
            }
            Ok(Node { kind: NodeKind::Sum(terms), span: start..p.last_end() })
        })
    }

    /// Factors joined by `\cdot`; `\times` binds closer.
    fn term(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let mut parts = vec![self.crosses()?];
        while self.is_command("cdot") || self.is('*') {
            if self.is('*') {
                return refuse(
                    "latex::unexpected",
                    "`*` is not a product here",
                    self.span(),
                    r"write `\cdot`, or nothing",
                );
            }
            self.bump();
            parts.push(self.crosses()?);
        }
        match (parts.pop(), parts.is_empty()) {
            (Some(single), true) => Ok(single),
            (Some(last), false) => {
                parts.push(last);
                Ok(Node { kind: NodeKind::Dot(parts), span: start..self.last_end() })
            }
            (None, _) => refuse("latex::unexpected", "a term is expected", self.span(), ""),
        }
    }

    fn crosses(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let left = self.product()?;
        if !self.is_command("times") {
            return Ok(left);
        }
        self.bump();
        let right = self.product()?;
        if self.is_command("times") {
            return refuse(
                "latex::ambiguous",
                "the product `\\times` is not associative",
                self.span(),
                "put parentheses around two of the factors",
            );
        }
        Ok(Node { kind: NodeKind::Cross(Box::new(left), Box::new(right)), span: start..self.last_end() })
    }

    /// Juxtaposed factors, at most one slash among them.
    fn product(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let mut factors: Vec<Node> = Vec::new();
        while let Some(factor) = self.factor()? {
            if let (NodeKind::Number(_), Some(last)) = (&factor.kind, factors.last()) {
                let (message, hint) = match last.kind {
                    NodeKind::Number(_) => ("two numbers stand side by side", r"write `\cdot` between them"),
                    _ => (
                        "a number stands behind a factor",
                        r"write the number first, or `\cdot` before it, or a subscript",
                    ),
                };
                return refuse("latex::ambiguous", message, last.span.start..factor.span.end, hint);
            }
            factors.push(factor);
        }
        if factors.is_empty() {
            let hint = if matches!(self.kind(), Kind::End) { "the formula stops too early" } else { "" };
            return refuse(
                "latex::unexpected",
                format!("{} stands where a factor is expected", self.shown()),
                self.span(),
                hint,
            );
        }
        let end = self.last_end();
        let product = |mut f: Vec<Node>, span: Range<usize>| match (f.len(), f.pop()) {
            (1, Some(only)) => only,
            (_, Some(last)) => {
                f.push(last);
                Node { kind: NodeKind::Product(f), span }
            }
            (_, None) => Node { kind: NodeKind::Product(f), span },
        };
        let numerator = product(factors, start..end);
        if !self.eat('/') {
            return Ok(numerator);
        }
        let Some(denominator) = self.factor()? else {
            return refuse("latex::unexpected", "nothing stands behind `/`", self.span(), "");
        };
        let next = self.span();
        if self.is('/') {
            return refuse("latex::ambiguous", "two `/` in one term", next, r"write `\frac{}{}`, or parentheses");
        }
        if let Some(further) = self.factor()? {
            return refuse(
                "latex::ambiguous",
                "it is not clear what belongs to the denominator",
                denominator.span.start..further.span.end,
                r"write `\frac{}{}`, or parentheses around the denominator",
            );
        }
        Ok(Node { kind: NodeKind::Quotient(Box::new(numerator), Box::new(denominator)), span: start..self.last_end() })
    }

    /// A factor with its scripts; `None` where no factor begins.
    fn factor(&mut self) -> Parsed<Option<Node>> {
        let Some(node) = self.primary()? else { return Ok(None) };
        if matches!(node.kind, NodeKind::Symbol(_)) {
            return Ok(Some(node));
        }
        self.scripts(node).map(Some)
    }

    fn scripts(&mut self, base: Node) -> Parsed<Node> {
        let (sub, sup, sup_first) = self.script_pair()?;
        if sub.is_none() && sup.is_none() {
            return Ok(base);
        }
        let span = base.span.start..self.last_end();
        Ok(Node { kind: NodeKind::Scripted { base: Box::new(base), sub, sup: sup.map(Box::new), sup_first }, span })
    }

    #[expect(clippy::type_complexity, reason = "the two scripts and their order belong together")]
    fn script_pair(&mut self) -> Parsed<(Option<Vec<SubItem>>, Option<Node>, bool)> {
        let (mut sub, mut sup, mut sup_first) = (None, None, false);
        loop {
            if self.is('_') {
                if sub.is_some() {
                    return refuse(
                        "latex::double-script",
                        "a second subscript",
                        self.span(),
                        "put all indices into one pair of braces",
                    );
                }
                self.bump();
                sub = Some(self.subscript()?);
            } else if self.is('^') {
                if sup.is_some() {
                    return refuse("latex::double-script", "a second superscript", self.span(), "use parentheses");
                }
                self.bump();
                sup_first = sub.is_none();
                sup = Some(self.superscript()?);
            } else {
                return Ok((sub, sup, sup_first));
            }
        }
    }

    fn superscript(&mut self) -> Parsed<Node> {
        if self.is('{') {
            self.bump();
            let node = self.sum()?;
            self.expect('}')?;
            return Ok(node);
        }
        let start = self.span().start;
        // TeX takes one token: a single digit, letter or command.
        if let Kind::Number(n) = self.kind().clone() {
            if n.len() > 1 {
                let hint = format!("write `^{{{n}}}`");
                return refuse("latex::ambiguous", "LaTeX raises only the first digit", self.span(), hint);
            }
            self.bump();
            let kind = NodeKind::Number(decimal(&n));
            return Ok(Node { kind, span: start..self.last_end() });
        }
        match self.single_name()? {
            Some((name, span)) => Ok(Node { kind: NodeKind::Symbol(plain(name)), span }),
            None => refuse(
                "latex::unexpected",
                format!("{} stands where an exponent is expected", self.shown()),
                self.span(),
                "",
            ),
        }
    }

    fn subscript(&mut self) -> Parsed<Vec<SubItem>> {
        let braced = self.eat('{');
        let mut items = Vec::new();
        loop {
            match self.kind().clone() {
                Kind::Number(n) => {
                    if n.contains('.') {
                        return refuse("latex::unexpected", "a decimal number as an index", self.span(), "");
                    }
                    if !braced && n.len() > 1 {
                        let hint = format!("write `_{{{n}}}`");
                        return refuse("latex::ambiguous", "LaTeX lowers only the first digit", self.span(), hint);
                    }
                    items.extend(n.bytes().map(|b| SubItem::Digit(u16::from(b - b'0'))));
                    self.bump();
                }
                Kind::Sign('}') if braced => break,
                Kind::Sign('{') if braced => {
                    let Some((name, _)) = self.single_name()? else {
                        return refuse("latex::unexpected", "braces in a subscript", self.span(), "");
                    };
                    items.push(SubItem::Name(name));
                }
                Kind::Sign(c @ ('(' | ')' | '-' | '+' | ',' | '*' | '/')) if braced => {
                    if c != ',' {
                        items.push(SubItem::Other(c));
                    }
                    self.bump();
                }
                _ => match self.single_name()? {
                    Some((name, _)) => items.push(SubItem::Name(name)),
                    None => {
                        let message = format!("{} cannot stand in a subscript", self.shown());
                        return refuse("latex::unexpected", message, self.span(), "");
                    }
                },
            }
            if !braced {
                return Ok(items);
            }
        }
        self.expect('}')?;
        if items.is_empty() {
            return refuse("latex::unexpected", "an empty subscript", self.span(), "");
        }
        Ok(items)
    }

    /// One name: a letter, a Greek letter, a styled or braced one; with its primes.
    fn single_name(&mut self) -> Parsed<Option<(Name, Range<usize>)>> {
        let start = self.span().start;
        let mut name = match self.kind().clone() {
            Kind::Letter(c) => {
                self.bump();
                c.to_string()
            }
            Kind::Command(c) if NAMES.contains(&c.as_str()) => {
                self.bump();
                format!("\\{c}")
            }
            Kind::Command(c) if name::style(&c).is_some() => {
                let Some(style) = name::style(&c) else { return Ok(None) };
                let back = self.at;
                self.bump();
                let inner = if self.is('{') { self.braced_word()? } else { self.single_name()?.map(|(n, _)| n) };
                match inner {
                    Some(inner) => restyle(style, inner),
                    None => {
                        self.at = back;
                        return Ok(None);
                    }
                }
            }
            Kind::Sign('{') => {
                let back = self.at;
                match self.braced_word()? {
                    Some(inner) => inner,
                    None => {
                        self.at = back;
                        return Ok(None);
                    }
                }
            }
            _ => return Ok(None),
        };
        while self.is('\'') {
            self.bump();
            name.push('\'');
        }
        if self.is('^') && matches!(self.kind_after(1), Kind::Command(c) if c == "prime") {
            self.bump();
            self.bump();
            name.push('\'');
        }
        Ok(Some((name, start..self.last_end())))
    }

    /// `{…}` that contains nothing but one name, or a style switch and one name. Leaves its place otherwise.
    fn braced_word(&mut self) -> Parsed<Option<Name>> {
        self.deeper(|p| {
            let back = p.at;
            p.bump();
            let mut switch = None;
            if let Kind::Command(c) = p.kind().clone()
                && name::is_switch(&c)
            {
                switch = name::style(&c);
                p.bump();
            }
            let mut word = String::new();
            while let Some((name, _)) = p.single_name()? {
                word.push_str(&name);
                if switch != Some("rm") {
                    break;
                }
            }
            if word.is_empty() || !p.eat('}') {
                p.at = back;
                return Ok(None);
            }
            Ok(Some(match switch {
                Some(style) => restyle(style, word),
                None => word,
            }))
        })
    }

    /// A word in braces, such as the argument of `\operatorname`.
    fn word(&mut self) -> Option<String> {
        let back = self.at;
        if !self.eat('{') {
            return None;
        }
        let mut word = String::new();
        loop {
            match self.kind().clone() {
                Kind::Letter(c) => word.push(c),
                Kind::Number(n) => word.push_str(&n),
                Kind::Sign('}') => break,
                _ => {
                    self.at = back;
                    return None;
                }
            }
            self.bump();
        }
        self.bump();
        Some(word)
    }

    fn node(&self, kind: NodeKind, start: usize) -> Node {
        Node { kind, span: start..self.last_end() }
    }

    /// What a factor is made of; `None` where none begins.
    fn primary(&mut self) -> Parsed<Option<Node>> {
        let start = self.span().start;
        match self.kind().clone() {
            Kind::Number(n) => {
                self.bump();
                Ok(Some(self.node(NodeKind::Number(decimal(&n)), start)))
            }
            Kind::Letter('e') if *self.kind_after(1) == Kind::Sign('^') && !self.scope.declares("e") => {
                self.bump();
                self.bump();
                let exponent = self.superscript()?;
                Ok(Some(self.node(NodeKind::Exponential(Box::new(exponent)), start)))
            }
            Kind::Letter(_) => self.symbol(0).map(Some),
            Kind::Sign('{') => {
                if let Some(operator) = self.switched_operator() {
                    return self.operator(operator, start).map(Some);
                }
                let back = self.at;
                if let Some(name) = self.braced_word()? {
                    return self.symbol_named(name, 0, start).map(Some);
                }
                self.at = back;
                self.bump();
                let inner = self.sum()?;
                self.expect('}')?;
                Ok(Some(Node { span: start..self.last_end(), ..inner }))
            }
            Kind::Sign('(') => {
                self.bump();
                let first = self.sum()?;
                let kind = if self.is(',') {
                    let mut parts = vec![first];
                    while self.eat(',') {
                        parts.push(self.sum()?);
                    }
                    NodeKind::Tuple(parts)
                } else if self.is(')') {
                    // A pair of parentheses of its own keeps `(a b)` one factor.
                    match first.kind {
                        NodeKind::Matrix(_) => first.kind,
                        _ => NodeKind::Scripted { base: Box::new(first), sub: None, sup: None, sup_first: false },
                    }
                } else {
                    return refuse(
                        "latex::unexpected",
                        format!("{} stands where `)` is expected", self.shown()),
                        self.span(),
                        "",
                    );
                };
                self.expect(')')?;
                Ok(Some(self.node(kind, start)))
            }
            Kind::Sign('[') => {
                self.bump();
                let first = self.sum()?;
                let kind = if self.eat(',') {
                    let second = self.sum()?;
                    NodeKind::Cross(Box::new(first), Box::new(second))
                } else {
                    NodeKind::Scripted { base: Box::new(first), sub: None, sup: None, sup_first: false }
                };
                self.expect(']')?;
                Ok(Some(self.node(kind, start)))
            }
            Kind::OpenBar => {
                self.bump();
                let inner = self.deeper(|p| p.sum())?;
                if *self.kind() != Kind::CloseBar {
                    return refuse("latex::unbalanced", "`|` is never closed", start..start + 1, "");
                }
                self.bump();
                Ok(Some(self.node(NodeKind::Absolute(Box::new(inner)), start)))
            }
            Kind::Sign('|') if self.bars == 0 => {
                self.bump();
                self.bars += 1;
                let inner = self.sum();
                self.bars -= 1;
                let inner = inner?;
                if !self.eat('|') {
                    return refuse(
                        "latex::unbalanced",
                        "`|` is never closed",
                        start..start + 1,
                        r"write `\left|` and `\right|`",
                    );
                }
                Ok(Some(self.node(NodeKind::Absolute(Box::new(inner)), start)))
            }
            Kind::Command(c) => self.command(&c, start),
            _ => Ok(None),
        }
    }

    /// `{\rm tr}` and the like: an operator in a group of its own.
    fn switched_operator(&mut self) -> Option<String> {
        let back = self.at;
        let Kind::Command(c) = self.kind_after(1).clone() else { return None };
        if c != "rm" && c != "mathrm" {
            return None;
        }
        self.bump();
        self.bump();
        let mut word = String::new();
        loop {
            match self.kind().clone() {
                Kind::Letter(c) => word.push(c),
                Kind::Number(n) => word.push_str(&n),
                Kind::Sign('}') => break,
                _ => break,
            }
            self.bump();
        }
        if self.is('}') && OPERATORS.iter().any(|(name, _)| *name == word) {
            self.bump();
            return Some(word);
        }
        self.at = back;
        None
    }

    fn command(&mut self, c: &str, start: usize) -> Parsed<Option<Node>> {
        match c {
            "frac" | "tfrac" | "dfrac" => {
                self.bump();
                self.fraction(start).map(Some)
            }
            "sqrt" => {
                self.bump();
                let mut degree = 2;
                if self.eat('[') {
                    let span = self.span();
                    let Kind::Number(n) = self.kind().clone() else {
                        return refuse("latex::unexpected", "the degree of a root is a number", span, "");
                    };
                    degree = match n.parse::<u16>() {
                        Ok(d @ 2..=64) => d,
                        _ => {
                            return refuse("latex::unexpected", "the degree of a root lies between 2 and 64", span, "");
                        }
                    };
                    self.bump();
                    self.expect(']')?;
                }
                let inner = self.argument()?;
                Ok(Some(self.node(NodeKind::Root(Box::new(inner), degree), start)))
            }
            "pi" if !self.scope.declares("\\pi") => {
                self.bump();
                Ok(Some(self.node(NodeKind::Pi, start)))
            }
            "dot" | "ddot" => {
                self.bump();
                let dots = if c == "dot" { 1 } else { 2 };
                let span = self.span();
                match self.single_name()? {
                    Some((name, _)) => self.symbol_named(name, dots, start).map(Some),
                    None => refuse(
                        "latex::dot",
                        format!("`\\{c}` needs one symbol"),
                        span,
                        r"for anything longer write `\frac{d}{dt}(…)`",
                    ),
                }
            }
            "mathbb" | "mathbf" | "bf" if self.identity() => Ok(Some(self.node(NodeKind::Identity, start))),
            "begin" => {
                self.bump();
                self.matrix(start).map(Some)
            }
            "operatorname" | "mathrm" | "mathop" | "rm" => {
                let back = self.at;
                self.bump();
                let word = self.word().or_else(|| {
                    // `\mathop{\rm tr}`
                    if !self.eat('{') || !self.is_command("rm") {
                        return None;
                    }
                    self.at -= 1;
                    self.switched_operator()
                });
                match word {
                    Some(word) if OPERATORS.iter().any(|(name, _)| *name == word) => {
                        self.operator(word, start).map(Some)
                    }
                    _ => {
                        self.at = back;
                        match self.single_name()? {
                            Some((name, _)) => self.symbol_named(name, 0, start).map(Some),
                            None => refuse(
                                "latex::unknown-function",
                                "this function is not known",
                                start..self.last_end(),
                                "",
                            ),
                        }
                    }
                }
            }
            _ if FUNCTIONS.contains(&c) => {
                self.bump();
                self.function(c, start).map(Some)
            }
            "rightarrow" | "to" | "cdot" | "times" | "pm" | "mp" | "ne" | "neq" | "equiv" | "le" | "leq" | "ge"
            | "geq" | "lt" | "gt" | "leqslant" | "geqslant" | "end" | "infty" => Ok(None),
            "partial" | "nabla" | "int" | "sum" | "prod" => refuse(
                "latex::unsupported",
                format!("`\\{c}` is not part of the formula language"),
                self.span(),
                "write the result of the operation, or an index sum",
            ),
            _ => match self.single_name()? {
                Some((name, _)) => self.symbol_named(name, 0, start).map(Some),
                None => refuse("latex::unknown-command", format!("`\\{c}` is not known"), self.span(), ""),
            },
        }
    }

    /// `\mathbb{1}`, `\mathbf{1}`: eaten when it is there.
    fn identity(&mut self) -> bool {
        let one = |k: &Kind| matches!(k, Kind::Number(n) if n == "1");
        if one(self.kind_after(1)) {
            self.bump();
            self.bump();
            return true;
        }
        if *self.kind_after(1) == Kind::Sign('{') && one(self.kind_after(2)) && *self.kind_after(3) == Kind::Sign('}') {
            for _ in 0..4 {
                self.bump();
            }
            return true;
        }
        false
    }

    /// One TeX argument: a group, or a single token.
    fn argument(&mut self) -> Parsed<Node> {
        if self.eat('{') {
            let inner = self.sum()?;
            self.expect('}')?;
            return Ok(inner);
        }
        let start = self.span().start;
        if let Kind::Number(n) = self.kind().clone() {
            // `\frac12`: TeX takes one digit at a time.
            if n.contains('.') {
                return refuse("latex::ambiguous", "LaTeX takes only the first digit", self.span(), "use braces");
            }
            let (first, rest) = n.split_at(1);
            let token = &mut self.tokens[self.at];
            if rest.is_empty() {
                self.bump();
                return Ok(Node { kind: NodeKind::Number(decimal(first)), span: start..start + 1 });
            }
            token.kind = Kind::Number(rest.to_owned());
            token.span.start += 1;
            return Ok(Node { kind: NodeKind::Number(decimal(first)), span: start..start + 1 });
        }
        if self.is_command("pi") && !self.scope.declares("\\pi") {
            self.bump();
            return Ok(self.node(NodeKind::Pi, start));
        }
        match self.single_name()? {
            Some((name, span)) => Ok(Node { kind: NodeKind::Symbol(plain(name)), span }),
            None => refuse(
                "latex::unexpected",
                format!("{} stands where an argument is expected", self.shown()),
                self.span(),
                "use braces",
            ),
        }
    }

    /// After `\frac`: a quotient, or a derivative in Leibniz' notation.
    fn fraction(&mut self, start: usize) -> Parsed<Node> {
        if let Some(derivative) = self.leibniz(start)? {
            return Ok(derivative);
        }
        let top = self.deeper(|p| p.argument())?;
        let bottom = self.deeper(|p| p.argument())?;
        Ok(self.node(NodeKind::Quotient(Box::new(top), Box::new(bottom)), start))
    }

    fn differential(&mut self) -> bool {
        let d = match self.kind() {
            Kind::Letter('d') => !self.scope.declares("d"),
            _ => false,
        };
        if d {
            self.bump();
        }
        d
    }

    /// The order in `d^2`; 1 without a superscript.
    fn differential_order(&mut self) -> Parsed<u8> {
        if !self.eat('^') {
            return Ok(1);
        }
        let braced = self.eat('{');
        let order = match self.kind().clone() {
            Kind::Number(n) => n.parse::<u8>().ok(),
            _ => None,
        };
        let Some(order @ 1..=4) = order else {
            return refuse("latex::derivative", "the order of a derivative lies between 1 and 4", self.span(), "");
        };
        self.bump();
        if braced {
            self.expect('}')?;
        }
        Ok(order)
    }

    fn leibniz(&mut self, start: usize) -> Parsed<Option<Node>> {
        let back = self.at;
        if !self.eat('{') || !self.differential() {
            self.at = back;
            return Ok(None);
        }
        let order = self.differential_order()?;
        let of = if self.is('}') { None } else { Some(self.product()?) };
        self.expect('}')?;
        let span = self.span();
        if !self.eat('{') || !self.differential() {
            return refuse(
                "latex::derivative",
                "the denominator of a derivative is a differential",
                span,
                r"write `\frac{dx}{dt}`",
            );
        }
        let by_start = self.span().start;
        let Some((name, _)) = self.single_name()? else {
            return refuse("latex::derivative", "a derivative is by one symbol", self.span(), r"write `\frac{dx}{dt}`");
        };
        let mut symbol = plain(name);
        if self.is('_') {
            self.bump();
            symbol.sub = Some(self.subscript()?);
        }
        let by = self.node(NodeKind::Symbol(symbol), by_start);
        let below = self.differential_order()?;
        if below != order {
            return refuse(
                "latex::derivative",
                "the two orders of the derivative differ",
                by_start..self.last_end(),
                "",
            );
        }
        self.expect('}')?;
        let of = match of {
            Some(of) => of,
            None => {
                let span = self.span();
                match self.factor()? {
                    Some(of) => of,
                    None => {
                        return refuse(
                            "latex::derivative",
                            "nothing follows the derivative",
                            span,
                            r"write `\frac{d}{dt}(…)`",
                        );
                    }
                }
            }
        };
        Ok(Some(self.node(NodeKind::Derivative { of: Box::new(of), by: Box::new(by), order }, start)))
    }

    fn matrix(&mut self, start: usize) -> Parsed<Node> {
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
            "pmatrix" | "bmatrix" | "matrix" => {}
            _ => {
                return refuse(
                    "latex::unsupported",
                    format!("the environment `{environment}` is not known"),
                    span,
                    "use `pmatrix`",
                );
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
                    return refuse(
                        "latex::unbalanced",
                        format!("`\\begin{{{environment}}}` is closed by another environment"),
                        span,
                        "",
                    );
                }
                break;
            }
            return refuse(
                "latex::unexpected",
                format!("{} is not expected in a matrix", self.shown()),
                self.span(),
                "",
            );
        }
        if rows.iter().any(|r| r.len() != rows[0].len()) {
            return refuse("latex::shape", "the rows of the matrix differ in length", start..self.last_end(), "");
        }
        Ok(self.node(NodeKind::Matrix(rows), start))
    }

    /// After an operator's name: its arguments in parentheses.
    fn operator(&mut self, word: String, start: usize) -> Parsed<Node> {
        let arity = OPERATORS.iter().find(|(name, _)| *name == word).map_or(0, |(_, n)| *n);
        let span = self.span();
        if !self.eat('(') {
            if word == "tr" {
                let Some(argument) = self.factor()? else {
                    return refuse("latex::unexpected", "a trace needs a matrix", span, "");
                };
                return Ok(self.node(NodeKind::Function(word, None, vec![argument]), start));
            }
            return refuse("latex::unexpected", format!("`{word}` needs its arguments in parentheses"), span, "");
        }
        let mut arguments = vec![self.sum()?];
        while self.eat(',') {
            arguments.push(self.sum()?);
        }
        self.expect(')')?;
        if arity != 0 && arguments.len() != arity {
            let message = format!("`{word}` has {arity} arguments, not {}", arguments.len());
            return refuse("latex::arity", message, start..self.last_end(), "");
        }
        Ok(self.node(NodeKind::Function(word, None, arguments), start))
    }

    /// After `\sin` and the like: an optional power, then an argument.
    fn function(&mut self, name: &str, start: usize) -> Parsed<Node> {
        let mut power = None;
        if self.eat('^') {
            let span = self.span();
            let exponent = self.superscript()?;
            let integer = match &exponent.kind {
                NodeKind::Number(r) => i32::try_from(r.clone()).ok(),
                _ => None,
            };
            match integer {
                Some(n @ 1..=64) => power = Some(n),
                _ => {
                    return refuse(
                        "latex::ambiguous",
                        format!("`\\{name}` to this power may mean a power or an inverse function"),
                        span,
                        format!(r"write `\arc{name}`, `1/\{name}`, or parentheses around the function"),
                    );
                }
            }
        }
        let argument = self.function_argument(name)?;
        Ok(self.node(NodeKind::Function(name.to_owned(), power, vec![argument]), start))
    }

    /// The argument of a function: in parentheses, a fraction or a root, or a number and one symbol; a product of numbers
    /// and parameters may end in the time.
    fn function_argument(&mut self, name: &str) -> Parsed<Node> {
        let start = self.span().start;
        if self.is('(') || self.is('[') || self.is('{') || matches!(self.kind(), Kind::OpenBar) || self.is('|') {
            let single = self.is('{');
            let Some(argument) = self.primary()? else {
                return refuse("latex::unexpected", format!("`\\{name}` has no argument"), self.span(), "");
            };
            if self.is('^') || self.is('_') {
                if single {
                    return self.scripts(argument);
                }
                return refuse(
                    "latex::ambiguous",
                    format!("does the script belong to `\\{name}` or to its argument?"),
                    self.span(),
                    format!(r"write `\{name}^2(…)`, or another pair of parentheses"),
                );
            }
            return Ok(argument);
        }
        let sign = self.is('-') || self.is('+');
        if sign {
            return refuse(
                "latex::ambiguous",
                format!("a sign stands behind `\\{name}`"),
                self.span(),
                "put the argument into parentheses",
            );
        }
        let mut factors: Vec<Node> = Vec::new();
        loop {
            let next = self.kind().clone();
            let begins = match &next {
                Kind::Number(_) | Kind::Letter(_) | Kind::Sign('{') => true,
                Kind::Command(c) => {
                    matches!(c.as_str(), "frac" | "tfrac" | "dfrac" | "sqrt" | "pi" | "dot" | "ddot")
                        || NAMES.contains(&c.as_str())
                        || name::style(c).is_some_and(|s| s != "rm")
                }
                _ => false,
            };
            if !begins {
                break;
            }
            let Some(factor) = self.factor()? else { break };
            factors.push(factor);
        }
        let argument_end = self.last_end();
        let is_time =
            |n: &Node| matches!(&n.kind, NodeKind::Symbol(s) if self.scope.time_name() == Some(s.name.as_str()));
        let is_steady = |n: &Node| match &n.kind {
            NodeKind::Number(_) | NodeKind::Pi => true,
            NodeKind::Symbol(s) => !self.scope.is_moving(&s.name, s.sub.as_deref()),
            NodeKind::Quotient(..) | NodeKind::Root(..) => true,
            _ => false,
        };
        let plain_product = match factors.as_slice() {
            [] => return refuse("latex::unexpected", format!("`\\{name}` has no argument"), self.span(), ""),
            [_] => true,
            [Node { kind: NodeKind::Number(_) | NodeKind::Pi, .. }, _] => true,
            [first, Node { kind: NodeKind::Pi, .. }, _] => matches!(first.kind, NodeKind::Number(_)),
            [init @ .., last] => is_time(last) && init.iter().all(is_steady),
        };
        if !plain_product {
            return refuse(
                "latex::ambiguous",
                format!("it is not clear where the argument of `\\{name}` ends"),
                start..argument_end,
                format!(r"put the argument into parentheses: `\{name}(…)`"),
            );
        }
        if factors.len() == 1 {
            return factors
                .pop()
                .map_or_else(|| refuse("latex::unexpected", "no argument", start..argument_end, ""), Ok);
        }
        Ok(Node { kind: NodeKind::Product(factors), span: start..argument_end })
    }

    fn symbol(&mut self, dots: u8) -> Parsed<Node> {
        let start = self.span().start;
        match self.single_name()? {
            Some((name, _)) => self.symbol_named(name, dots, start),
            None => refuse(
                "latex::unexpected",
                format!("{} stands where a symbol is expected", self.shown()),
                self.span(),
                "",
            ),
        }
    }

    /// A symbol whose name was read: scripts, then what stands in parentheses behind it, if that belongs to it.
    fn symbol_named(&mut self, name: Name, dots: u8, start: usize) -> Parsed<Node> {
        let (sub, sup, sup_first) = self.script_pair()?;
        let mut symbol = SymbolNode {
            name,
            dots,
            sub,
            sup: sup.map(Box::new),
            sup_first,
            arguments: None,
            arguments_text: String::new(),
        };
        if self.is('(')
            && let Some(close) = self.closing()
        {
            let inside = &self.tokens[self.at + 1..close];
            let text = canonical(inside);
            let single = simple(inside);
            let applied = self.scope.applies(&symbol.name, symbol.sub.as_deref(), &text);
            let moving = self.scope.is_moving(&symbol.name, symbol.sub.as_deref());
            if applied || (single && moving) {
                self.bump();
                let mut arguments = vec![self.sum()?];
                while self.eat(',') {
                    arguments.push(self.sum()?);
                }
                self.expect(')')?;
                symbol.arguments = Some(arguments);
                symbol.arguments_text = text;
            } else if single && symbol.sup.is_none() && (self.scope.time_name() == Some(text.as_str()) || text == "0") {
                let shown = self.text[start..self.last_end()].to_owned();
                return refuse(
                    "latex::ambiguous",
                    format!(
                        "`{shown}` does not depend on time, so this is neither a value at a time nor a clear product"
                    ),
                    start..self.tokens[close].span.end,
                    r"leave the parentheses out, or write `\cdot`",
                );
            }
        }
        let span = start..self.last_end();
        let applied = symbol.arguments.is_some() && symbol.sup.is_none();
        let node = Node { kind: NodeKind::Symbol(symbol), span };
        // `R(0)^T`: scripts behind the arguments belong to the value.
        if applied { self.scripts(node) } else { Ok(node) }
    }

    /// Position of the token that closes the parenthesis at the present place.
    fn closing(&self) -> Option<usize> {
        let mut depth = 0usize;
        for (i, token) in self.tokens.iter().enumerate().skip(self.at) {
            match token.kind {
                Kind::Sign('(') => depth += 1,
                Kind::Sign(')') => {
                    depth -= 1;
                    if depth == 0 {
                        return Some(i);
                    }
                }
                _ => {}
            }
        }
        None
    }
}

/// Whether tokens are a single number or symbol, perhaps with a sign or a subscript: what a time looks like.
fn simple(tokens: &[Token]) -> bool {
    let mut rest = tokens;
    if let [Token { kind: Kind::Sign('-'), .. }, tail @ ..] = rest {
        rest = tail;
    }
    match rest {
        [Token { kind: Kind::Number(_) | Kind::Letter(_), .. }] => true,
        [Token { kind: Kind::Command(c), .. }] => NAMES.contains(&c.as_str()),
        [Token { kind: Kind::Letter(_), .. }, Token { kind: Kind::Sign('_'), .. }, tail @ ..] => {
            matches!(tail, [_] | [Token { kind: Kind::Sign('{'), .. }, _, Token { kind: Kind::Sign('}'), .. }])
        }
        _ => false,
    }
}

fn restyle(style: &str, name: Name) -> Name {
    // `{\bf {\bf m}}` is `{\bf m}`; other styles on top of one another are kept apart.
    if name.starts_with(&format!("{style}:")) { name } else { format!("{style}:{name}") }
}

fn plain(name: Name) -> SymbolNode {
    SymbolNode { name, dots: 0, sub: None, sup: None, sup_first: false, arguments: None, arguments_text: String::new() }
}

/// A decimal number, exactly.
fn decimal(text: &str) -> Rational {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = format!("{whole}{fraction}");
    let numerator = digits.parse::<dashu_int::IBig>().unwrap_or(dashu_int::IBig::ZERO);
    let denominator = dashu_int::UBig::from(10u8).pow(fraction.len());
    Rational::from_parts(numerator, denominator)
}
