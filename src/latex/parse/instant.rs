//! Values at a time: what stands in parentheses, or behind a bar, after something that moves.
//!
//! `x(0)`, `(x+y)(0)`, `\frac{dx}{dt}(0)`, `\sqrt x(0)` and `\left.\dot x\right|_{t=0}` are values at a time, never products.
//! Parentheses behind something are one of three: a time, a factor, or refused. What decides is what is printed: several
//! terms are a factor; one term without anything that moves is a time, if what stands before it moves; a bare number behind
//! something constant is refused, since nobody writes a product like that.

use super::super::convention::NUMBERS;
use super::super::lexer::{Kind, Token};
use super::super::name::NAMES;
use super::super::syntax::{Node, NodeKind, SymbolNode};
use super::function::FUNCTIONS;
use super::{Parsed, Parser, refuse};

/// What stands in the parentheses behind something.
pub(super) struct Content {
    /// Several parts, separated by commas.
    pub(super) tuple: bool,
    /// Terms joined by signs.
    pub(super) sum: bool,
    /// A sign before the first term.
    pub(super) signed: bool,
    /// `\cdot` or `\times`.
    joined: bool,
    /// Something that depends on time, other than the time itself.
    moving: bool,
    /// The time, or a symbol of its name such as `t_0`.
    time: bool,
    /// A vector or a matrix.
    tensor: bool,
    /// Nothing but numbers.
    pub(super) number: bool,
    /// Several factors with indices: `(w_jv_j)`.
    indexed: bool,
    /// A quotient.
    quotient: bool,
    /// One symbol, perhaps with a subscript.
    lone: bool,
    /// It begins with a quotient of differentials, `\frac{d…}{d…}`.
    rate: bool,
    /// The time in a term without functions: what a time is written as, `t-r/c`, and not `k\cos t`.
    timely: bool,
    /// How many names and numbers there are.
    factors: usize,
    /// One factor that needs parentheses before a power: `(\dot x)^2`, `(\sqrt a)^3`.
    dressed: bool,
}

/// What parentheses are.
enum Reading {
    Time,
    Factor,
}

const PRODUCT: &str = r"write `\cdot` for a product";

impl Parser<'_> {
    /// Whether the parentheses that end at `close` hold the time at which the symbol is taken; otherwise they are a factor.
    pub(super) fn is_instant(&self, symbol: &SymbolNode, start: usize, close: usize) -> Parsed<bool> {
        let sub = symbol.sub.as_deref();
        if !self.scope.is_known(&symbol.name, sub) {
            // Said by name later.
            return Ok(false);
        }
        let content = self.content(&self.tokens[self.at + 1..close]);
        let span = start..self.tokens[close].span.end;
        let shown = &self.text[start..self.last_end()];
        let ambiguous = |message: String, hint: &str| refuse("latex::ambiguous", message, span.clone(), hint);
        if self.scope.is_field(&symbol.name, sub) {
            if content.tuple || content.lone || content.number {
                let hint = r"name all of its coordinates, or none, or write `\cdot` for a product";
                return ambiguous(format!("`{shown}` is not declared with these coordinates"), hint);
            }
            return Ok(false);
        }
        if self.scope.is_moving(&symbol.name, sub) {
            if content.tuple {
                // A matrix before the components of a vector.
                if self.scope.is_matrix(&symbol.name, sub) {
                    return Ok(false);
                }
                let hint = r"a value is taken at one time; write `\cdot` for a product";
                return ambiguous(format!("`{shown}` is not declared with these arguments"), hint);
            }
            // `{\bf f}^T(A)^T`: no value of a function is transposed twice.
            if Self::is_transposed(symbol) && self.is_transposed_at(close) {
                return Ok(false);
            }
            if content.tensor && !content.lone && !content.sum && self.is_applied_to_tensors(symbol) {
                return Ok(false);
            }
            if content.sum {
                // `\dot q(\dot q m+k\cos t)`: no time is given by what moves, unless it is one less a delay.
                if content.timely || content.number || content.time && !content.moving {
                    let hint = r"write the time as one term, or `\cdot` for a product";
                    return ambiguous(format!("is this `{shown}` at a time, or a product?"), hint);
                }
                return Ok(false);
            }
            if content.signed && !content.number && !content.time {
                return if content.moving {
                    Ok(false)
                } else {
                    ambiguous(format!("is this `{shown}` at a time, or a product?"), PRODUCT)
                };
            }
            if content.joined && content.tensor || content.indexed && content.moving {
                return Ok(false);
            }
            // No function is ever given a rate written out: `r\left(\frac{d\varphi}{dt}\right)^2`.
            if content.rate && content.moving {
                return Ok(false);
            }
            // `\dot r(m\dot r)`: no rate is a function of itself.
            if symbol.dots > 0 && content.moving && content.factors > 1 && self.holds_itself(symbol, close) {
                return Ok(false);
            }
            if content.moving {
                let hint = r"declare it with this argument, or leave the parentheses out, or write `\cdot`";
                return ambiguous(format!("`{shown}` is not declared as a function of what follows"), hint);
            }
            return Ok(true);
        }
        // Something constant has no value at a time: a lone term in parentheses is then no clear product.
        if content.tuple || content.sum || content.joined || (content.signed && !content.number && !content.time) {
            return Ok(false);
        }
        // `m(\dot x)^2`, `A(BC)`.
        let product = content.tensor && !content.lone && self.is_applied_to_tensors(symbol);
        let several =
            content.factors > 1 && self.is_raised_at(close) && !crate::convention::prints_as_function(&symbol.name);
        if product || (content.dressed && self.is_raised_at(close) || several) && !content.time {
            return Ok(false);
        }
        // `\hbar^2(k')^2`
        if NUMBERS.contains(&symbol.name.as_str()) {
            return Ok(false);
        }
        // What no function is ever given is a factor: `F(b/a)`.
        if content.quotient && !content.moving && !content.time && !content.number {
            return Ok(false);
        }
        let message =
            format!("`{shown}` does not depend on time, so this is neither a value at a time nor a clear product");
        ambiguous(message, r"leave the parentheses out, or write `\cdot`")
    }

    /// Whether a symbol is a matrix, or transposed: it stands before vectors and matrices, and is no function of them.
    fn is_applied_to_tensors(&self, symbol: &SymbolNode) -> bool {
        Self::is_transposed(symbol) || self.scope.is_matrix(&symbol.name, symbol.sub.as_deref())
    }

    /// Whether a symbol has the sign of a transpose above it.
    pub(super) fn is_transposed(symbol: &SymbolNode) -> bool {
        symbol.sup.as_deref().is_some_and(|sup| sup.is_named("T") || sup.is_named(r"\top"))
    }

    /// What was read, or its value at the times that stand behind it.
    pub(super) fn with_times(&mut self, mut factor: Node) -> Parsed<Node> {
        while self.open_here().is_none() {
            let start = factor.span.start;
            if self.is('(') && !Self::decides_itself(&factor) {
                let Reading::Time = self.behind(&factor)? else { break };
                self.bump();
                let outer = std::mem::replace(&mut self.bars, 0);
                let time = Box::new(self.sum()?);
                self.expect(')')?;
                self.bars = outer;
                factor = self.node(NodeKind::At { of: Box::new(factor), time, bar: None }, start);
            } else if self.is('[') && !matches!(factor.kind, NodeKind::Number(_) | NodeKind::Pi) {
                let inside = matches!(self.kind_after(1), Kind::Number(_)) && *self.kind_after(2) == Kind::Sign(']');
                if inside {
                    let message = "a number in square brackets: a time, or a factor?";
                    return refuse(
                        "latex::ambiguous",
                        message,
                        self.span(),
                        r"write `(0)` for the time, `\cdot` for a product",
                    );
                }
                break;
            } else {
                break;
            }
            if self.is('_') || self.is('^') {
                let (sub, sup, sup_first) = self.script_pair()?;
                factor = self.node(NodeKind::Scripted { base: Box::new(factor), sub, sup, sup_first }, start);
            }
        }
        Ok(factor)
    }

    /// A symbol says by itself whether parentheses belong to it; behind a number they are a factor.
    fn decides_itself(factor: &Node) -> bool {
        match &factor.kind {
            NodeKind::Symbol(s) => s.arguments.is_none(),
            NodeKind::Number(_) | NodeKind::Pi => true,
            _ => false,
        }
    }

    /// What the parentheses behind a factor are.
    fn behind(&self, factor: &Node) -> Parsed<Reading> {
        let Some(close) = self.closing() else { return Ok(Reading::Factor) };
        let content = self.content(&self.tokens[self.at + 1..close]);
        let span = factor.span.start..self.tokens[close].span.end;
        let ambiguous = |message: &str, hint: &str| refuse("latex::ambiguous", message, span.clone(), hint);
        if content.tuple || content.moving {
            return Ok(Reading::Factor);
        }
        if factor.is_numeric() {
            return Ok(Reading::Factor);
        }
        if !self.moves(factor) {
            if !content.sum && content.number || content.lone && content.time {
                let message = "this is neither a value at a time nor a clear product";
                return ambiguous(message, r"leave the parentheses out, or write `\cdot`");
            }
            return Ok(Reading::Factor);
        }
        // `e^{-\gamma t}(A+Bt)`: what shows the time is not taken at another one.
        if content.sum && !content.number && (!content.time || self.is_explicit(factor)) {
            return Ok(Reading::Factor);
        }
        if content.sum || content.signed && !content.number || content.joined || !content.number && !content.time {
            return ambiguous(
                "is this a value at a time, or a product?",
                r"write the time as one term, or `\cdot` for a product",
            );
        }
        match unwrapped(factor) {
            NodeKind::Derivative { operator: true, .. } => ambiguous(
                "is this the derivative at a time, or that of a value?",
                r"write `\left(\frac{d}{dt}…\right)(0)`",
            ),
            NodeKind::Derivative { by, .. } if !self.is_time(by) => {
                let hint = r"write `\left.…\right|_{t=0}` for the time";
                ambiguous("is this at a time, or where the denominator has this value?", hint)
            }
            _ => Ok(Reading::Time),
        }
    }

    /// Whether the parentheses that open at `at` hold several terms: then they are a factor of a number.
    pub(super) fn holds_terms(&self, at: usize) -> bool {
        self.closing_from(at).is_some_and(|close| self.content(&self.tokens[at + 1..close]).sum)
    }

    /// Refuses a derivative of a value at a time: `\frac{d}{dt}x(0)` may mean the rate at that time.
    pub(super) fn rate_is_clear(&self, of: &Node) -> Parsed<()> {
        let taken = match &of.kind {
            NodeKind::Symbol(s) => {
                let applied = self.scope.applies(&s.name, s.sub.as_deref(), &s.arguments_text);
                let elsewhere = self.scope.is_elsewhere(&s.name, s.sub.as_deref(), &s.arguments_text);
                !applied && s.arguments.as_ref().is_some_and(|a| !a.iter().all(|a| self.is_time(a)))
                    || elsewhere && !s.arguments.iter().flatten().all(|a| self.varies(a))
            }
            NodeKind::Scripted { base, .. } => return self.rate_is_clear(base),
            NodeKind::At { .. } => true,
            _ => false,
        };
        if !taken {
            return Ok(());
        }
        let message = "is this the derivative at a time or place, or that of a value?";
        let hint = r"write `\dot x(0)`, or `\frac{dx}{dt}(0)`; of a field, `u_x(0,t)` or `f'(0)`";
        refuse("latex::ambiguous", message, of.span.clone(), hint)
    }

    /// Whether something names the time, a coordinate, or what depends on them.
    fn varies(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::At { .. } => false,
            NodeKind::Symbol(s) if s.sub.is_none() && self.scope.is_time_or_moving(&s.name) => true,
            _ => self.moves(node) || node.children().into_iter().any(|n| self.varies(n)),
        }
    }

    /// Whether something depends on time by the time itself alone, as `e^{-\gamma t}` does.
    fn is_explicit(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::At { .. }
            | NodeKind::Derivative { .. }
            | NodeKind::Partial { .. }
            | NodeKind::Nabla { .. }
            | NodeKind::Poisson(..)
            | NodeKind::Variation { .. }
            | NodeKind::Differential { .. } => false,
            NodeKind::Symbol(s) if self.scope.is_moving(&s.name, s.sub.as_deref()) || s.arguments.is_some() => false,
            _ => node.children().into_iter().all(|n| self.is_explicit(n)),
        }
    }

    /// Whether something depends on time.
    pub(super) fn moves(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::At { .. } => false,
            NodeKind::Symbol(s) => {
                let text = s.arguments.as_ref().map(|_| s.arguments_text.as_str());
                let applied = text.is_some_and(|text| self.scope.applies(&s.name, s.sub.as_deref(), text));
                let now = match &s.arguments {
                    Some(arguments) if !applied => arguments.iter().all(|a| self.is_time(a)),
                    _ => true,
                };
                now && (self.scope.is_moving(&s.name, s.sub.as_deref())
                    || self.is_time(node)
                    || node.children().into_iter().any(|n| self.moves(n)))
            }
            _ => node.children().into_iter().any(|n| self.moves(n)),
        }
    }

    // ---- bars ----------------------------------------------------------------------------------------------------

    /// At `\left.`: what is taken at the time behind `\right|`.
    pub(super) fn fenced(&mut self, start: usize) -> Parsed<Node> {
        let opening = self.span();
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let of = self.sum()?;
        self.bars = outer;
        if *self.kind() != Kind::CloseBar || *self.kind_after(1) != Kind::Sign('_') {
            let hint = r"write both delimiters of the pair, or a value at a time, `\left.x\right|_{t=0}`";
            return refuse("latex::invisible-delimiter", r"`\left.` has no delimiter", opening, hint);
        }
        self.bump();
        self.at_bar(of, start)
    }

    /// Whether a bar stands here that takes what is before it at a time.
    pub(super) fn is_bar_of_time(&self) -> bool {
        self.is('|') && self.bars == 0 && *self.kind_after(1) == Kind::Sign('_')
    }

    /// Behind the bar: `_{t=0}`.
    pub(super) fn at_bar(&mut self, of: Node, start: usize) -> Parsed<Node> {
        self.bump();
        let span = self.span();
        let hint = r"write `|_{t=0}`, with the time and its value";
        if !self.eat('{') {
            return refuse("latex::instant", "a value is taken at a time", span, hint);
        }
        let name = self.single_name()?.map(|(name, _)| name);
        let known = |n: &str| self.scope.time_name() == Some(n) || self.scope.coordinate(n).is_some();
        let Some(name) = name.filter(|n| known(n) && self.is('=')) else {
            return refuse("latex::instant", "a value is taken at a time, or at a coordinate's value", span, hint);
        };
        self.bump();
        let time = Box::new(self.sum()?);
        self.expect('}')?;
        if self.is('^') || self.is('_') {
            let hint = "put parentheses around the value";
            return refuse("latex::unexpected", "a script behind a bar", self.span(), hint);
        }
        Ok(self.node(NodeKind::At { of: Box::new(of), time, bar: Some(name) }, start))
    }

    /// Refuses a bar behind several terms or factors that move: it is not printed how far it reaches.
    pub(super) fn bar_is_clear<'n>(&self, from: usize, before: impl IntoIterator<Item = &'n Node>) -> Parsed<()> {
        let here = self.bar.is_some_and(|(at, depth)| at > from && depth == self.depth);
        if here && before.into_iter().any(|n| self.moves(n)) {
            let hint = r"write `\left.…\right|_{t=0}`, or parentheses";
            return refuse("latex::ambiguous", "it is not clear how far the bar reaches", self.span(), hint);
        }
        Ok(())
    }

    // ---- parentheses ---------------------------------------------------------------------------------------------

    /// Whether a power stands behind parentheses that are closed there.
    /// Whether the sign of a transpose stands above what ends there.
    pub(super) fn is_transposed_at(&self, close: usize) -> bool {
        let sign =
            |t: &Token| matches!(&t.kind, Kind::Letter('T')) || matches!(&t.kind, Kind::Command(c) if c == "top");
        let above = self.tokens.iter().skip(close + 2).find(|t| t.kind != Kind::Sign('{'));
        self.is_raised_at(close) && above.is_some_and(sign)
    }

    fn is_raised_at(&self, close: usize) -> bool {
        self.tokens.get(close + 1).is_some_and(|t| t.kind == Kind::Sign('^'))
    }

    pub(super) fn content(&self, tokens: &[Token]) -> Content {
        let signed = matches!(tokens, [Token { kind: Kind::Sign('-' | '+'), .. }, ..])
            || matches!(tokens, [Token { kind: Kind::Command(c), .. }, ..] if c == "pm" || c == "mp");
        let body = if signed { &tokens[1..] } else { tokens };
        let mut content = Content {
            tuple: false,
            sum: false,
            signed,
            joined: false,
            moving: false,
            time: false,
            tensor: false,
            number: true,
            indexed: false,
            quotient: false,
            lone: false,
            rate: matches!(tokens, [Token { kind: Kind::Command(c), .. }, Token { kind: Kind::Sign('{'), .. },
                Token { kind: Kind::Letter('d'), .. }, ..] if matches!(c.as_str(), "frac" | "tfrac" | "dfrac")),
            timely: false,
            factors: 0,
            dressed: is_dressed(tokens),
        };
        let mut names = 0;
        let mut others = 0;
        let mut lowered_names = 0;
        let mut depth = 0usize;
        let mut bar = false;
        let mut within_function = false;
        // A subscript, as the 0 in `t_0`, and the name of an operator are not looked at.
        let mut lowered_depth = None;
        for (i, token) in body.iter().enumerate() {
            let after_lower = i > 0 && body[i - 1].kind == Kind::Sign('_');
            let word = matches!(i.checked_sub(1).map(|before| &body[before].kind),
                Some(Kind::Command(c)) if matches!(c.as_str(), "operatorname" | "begin" | "end"));
            if (after_lower || word) && token.kind == Kind::Sign('{') {
                lowered_depth = Some(depth);
            }
            let base = match &token.kind {
                Kind::Sign('|') => {
                    bar = !bar;
                    depth = if bar { depth + 1 } else { depth.saturating_sub(1) };
                    continue;
                }
                Kind::Sign('(' | '[' | '{') | Kind::OpenBar => {
                    depth += 1;
                    continue;
                }
                Kind::Sign(')' | ']' | '}') | Kind::CloseBar => {
                    depth = depth.saturating_sub(1);
                    if lowered_depth == Some(depth) {
                        lowered_depth = None;
                    }
                    continue;
                }
                _ if lowered_depth.is_some() || after_lower => continue,
                Kind::Sign('-' | '+') => {
                    content.sum |= depth == 0;
                    within_function &= depth > 0;
                    continue;
                }
                Kind::Sign(',') => {
                    content.tuple |= depth == 0;
                    continue;
                }
                Kind::Command(c) if c == "pm" || c == "mp" => {
                    content.sum |= depth == 0;
                    continue;
                }
                Kind::Command(c) if c == "cdot" || c == "times" => {
                    content.joined |= depth == 0;
                    continue;
                }
                Kind::Letter(c) => c.to_string(),
                Kind::Command(c) if NAMES.contains(&c.as_str()) || c == "pi" && self.scope.declares(r"\pi") => {
                    format!("\\{c}")
                }
                other => {
                    content.factors += usize::from(depth == 0 && matches!(other, Kind::Number(_)));
                    within_function |= matches!(other, Kind::Command(c) if FUNCTIONS.contains(&c.as_str()));
                    let fraction =
                        matches!(other, Kind::Command(c) if matches!(c.as_str(), "frac" | "tfrac" | "dfrac"));
                    content.quotient |= depth == 0 && (fraction || *other == Kind::Sign('/'));
                    others += usize::from(*other != Kind::Sign('_'));
                    continue;
                }
            };
            // `\mathbf{u}_1` is printed as `\mathbf u_1`.
            let next = body[i + 1..].iter().find(|t| t.kind != Kind::Sign('}'));
            let lowered = matches!(next, Some(Token { kind: Kind::Sign('_'), .. }));
            names += 1;
            content.number = false;
            lowered_names += usize::from(lowered);
            let (moves, tensor) = self.scope.kinds_of(&base, lowered);
            content.moving |= moves;
            content.tensor |= tensor;
            let time = self.scope.time_name() == Some(base.as_str());
            content.time |= time;
            content.timely |= time && !within_function;
            within_function |= base == "e" && matches!(body.get(i + 1), Some(Token { kind: Kind::Sign('^'), .. }));
        }
        content.factors += names;
        content.lone = names == 1 && others == 0;
        content.indexed = names > 1 && lowered_names == names;
        content
    }
}

/// Whether tokens are one symbol with dots, or one root.
fn is_dressed(tokens: &[Token]) -> bool {
    let [Token { kind: Kind::Command(c), .. }, rest @ ..] = tokens else { return false };
    if !matches!(c.as_str(), "dot" | "ddot" | "dddot" | "sqrt") {
        return false;
    }
    let group = |tokens: &[Token]| {
        let mut depth = 0usize;
        tokens.iter().position(|t| {
            depth += usize::from(t.kind == Kind::Sign('{'));
            depth = depth.saturating_sub(usize::from(t.kind == Kind::Sign('}')));
            depth == 0
        })
    };
    let Some(end) = group(rest) else { return false };
    match &rest[end + 1..] {
        [] => true,
        [Token { kind: Kind::Sign('_'), .. }, sub @ ..] => {
            c != "sqrt" && group(sub).is_some_and(|e| e + 1 == sub.len())
        }
        _ => false,
    }
}

/// What a node is without brackets around it.
fn unwrapped(node: &Node) -> &NodeKind {
    match &node.kind {
        NodeKind::Group(inner, _) => unwrapped(inner),
        kind => kind,
    }
}
