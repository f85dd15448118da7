//! Partial derivatives and ∇: `\frac{\partial^2u}{\partial x\partial t}`, `\partial_x^2u`, `\nabla\cdot{\bf E}`.
//!
//! How far an operator reaches cannot be seen in print, so it acts on one factor; what stands behind that must be another
//! derivative, or something that cannot belong to it.

use super::super::lexer::Kind;
use super::super::syntax::{Bracket, Nabla, Node, NodeKind, PartialForm};
use super::{Open, Parsed, Parser, refuse};
use expr::{HIGHEST_ORDER, Rational};

const HOW: &str = r"write `\frac{\partial u}{\partial x}`, or `\partial_xu`";

impl Parser<'_> {
    /// Whether a partial derivative, or ∇, begins so many tokens ahead.
    pub(super) fn begins_partial_after(&self, n: usize) -> bool {
        let command =
            |i: usize, names: &[&str]| matches!(self.kind_after(i), Kind::Command(c) if names.contains(&c.as_str()));
        let fraction = command(n, &["frac", "tfrac", "dfrac"])
            && *self.kind_after(n + 1) == Kind::Sign('{')
            && command(n + 2, &["partial"]);
        fraction || command(n, &["partial", "nabla", "Box"])
    }

    /// In a fraction, behind `\frac`: a partial derivative, if this is one.
    pub(super) fn partial_fraction(&mut self, start: usize) -> Parsed<Option<Node>> {
        // `\frac{\partial_xu}{u}` is a quotient.
        let begins = self.is('{') && matches!(self.kind_after(1), Kind::Command(c) if c == "partial");
        if !begins || *self.kind_after(2) == Kind::Sign('_') {
            return Ok(None);
        }
        self.bump();
        self.bump();
        let order = u32::from(self.differential_order()?);
        let mut of = None;
        if !self.is('}') {
            let span = self.span();
            of = self.factor()?.filter(|_| self.is('}'));
            if of.as_ref().is_none_or(is_raised) {
                let message = "it is not clear what is derived";
                let hint = r"put it into parentheses, `\frac{\partial(…)}{\partial x}`";
                return refuse("latex::ambiguous", message, span.start..self.span().end, hint);
            }
        }
        self.expect('}')?;
        self.expect('{')?;
        let below = self.span();
        let mut by = Vec::new();
        while self.is_command("partial") {
            self.bump();
            by.extend(self.variables()?);
        }
        if !self.is('}') || by.is_empty() {
            let message = "the denominator of a partial derivative has `\\partial` before each symbol";
            return refuse("latex::derivative", message, below.start..self.span().end, HOW);
        }
        self.expect('}')?;
        if by.len() as u64 != u64::from(order) {
            let message = format!("the orders of the derivative differ: {order} above, {} below", by.len());
            return refuse("latex::derivative", message, start..self.last_end(), "");
        }
        match of {
            Some(of) => {
                self.rate_is_clear(&of)?;
                let kind = NodeKind::Partial { of: Box::new(of), by, form: PartialForm::Fraction };
                Ok(Some(self.node(kind, start)))
            }
            None => {
                let (of, open) = self.operand(&by)?;
                let kind = NodeKind::Partial { of: Box::new(of), by, form: PartialForm::Operator };
                let node = self.node(kind, start);
                self.leave_operator_open(open);
                Ok(Some(node))
            }
        }
    }

    /// In a fraction, behind `\frac`: a derivative that follows the flow, `\frac{Df}{Dt}`, if this is one.
    pub(super) fn following_fraction(&mut self, start: usize) -> Parsed<Option<Node>> {
        let d = |p: &Self, i: usize| *p.kind_after(i) == Kind::Sign('{') && *p.kind_after(i + 1) == Kind::Letter('D');
        let below = self.behind_group().and_then(|i| i.checked_sub(self.at));
        if !d(self, 0) || !below.is_some_and(|b| d(self, b)) {
            return Ok(None);
        }
        if self.scope.declares("D") {
            if self.scope.velocity().is_none() {
                return Ok(None);
            }
            let hint = r"write `\frac{\partial u}{\partial t}+({\bf v}\cdot\nabla)u`, or a product with `\cdot`";
            let message = "`D` is declared: a derivative, or a quotient of products?";
            return refuse("latex::ambiguous", message, start..self.span().end, hint);
        }
        let back = self.at;
        self.bump();
        if self.spelled_name()?.is_some() {
            self.at = back;
            return Ok(None);
        }
        self.bump();
        let span = self.span();
        let of = match self.is('}') {
            true => None,
            false => self.factor()?,
        };
        if !self.is('}') || of.as_ref().is_some_and(is_raised) {
            let message = "it is not clear what is derived";
            let hint = r"put it into parentheses, `\frac{D(…)}{Dt}`";
            return refuse("latex::ambiguous", message, span.start..self.span().end, hint);
        }
        self.expect('}')?;
        self.expect('{')?;
        self.bump();
        let (by, span) = (self.span(), self.span());
        let name = self.single_name()?.map(|(name, _)| name);
        if name.is_none() || name.as_deref() != self.scope.time_name() || !self.is('}') {
            let hint = r"write `\frac{Du}{Dt}`, t being the time";
            return refuse("latex::derivative", "a flow is followed along the time", by.start..span.end, hint);
        }
        self.expect('}')?;
        let Some(of) = of else { return self.acting(Nabla::Following { fraction: false }, start).map(Some) };
        self.rate_is_clear(&of)?;
        let kind = NodeKind::Nabla { of: Box::new(of), action: Nabla::Following { fraction: true } };
        Ok(Some(self.node(kind, start)))
    }

    /// In a fraction, behind `\frac`: a variational derivative, if this is one.
    pub(super) fn variation_fraction(&mut self, start: usize) -> Parsed<Option<Node>> {
        if !self.begins_variation()? {
            return Ok(None);
        }
        self.bump();
        self.bump();
        let span = self.span();
        let of = self.factor()?.filter(|of| self.is('}') && !is_raised(of));
        let Some(of) = of else {
            let message = "it is not clear what is varied";
            let hint =
                r"put it into parentheses, `\frac{\delta(…)}{\delta q}`, and write derivatives of the first order";
            return refuse("latex::ambiguous", message, span.start..self.span().end, hint);
        };
        self.expect('}')?;
        let below = self.span();
        let by = match self.begins_variation()? {
            false => None,
            true => {
                self.bump();
                self.bump();
                self.factor()?.filter(|by| self.is('}') && matches!(by.kind, NodeKind::Symbol(_)) && !is_raised(by))
            }
        };
        let Some(by) = by else {
            let message = r"the denominator of a variational derivative is `\delta` and one symbol";
            let hint = r"write `\frac{\delta L}{\delta q}`, L being the density";
            return refuse("latex::derivative", message, below.start..self.span().end, hint);
        };
        self.expect('}')?;
        self.rate_is_clear(&of)?;
        let kind = NodeKind::Variation { of: Box::new(of), by: Box::new(by) };
        Ok(Some(self.node(kind, start)))
    }

    /// Whether `{\delta` begins here, and is no Kronecker symbol and no declared name.
    fn begins_variation(&mut self) -> Parsed<bool> {
        let delta = matches!(self.kind_after(1), Kind::Command(c) if c == "delta");
        if !self.is('{') || !delta || matches!(self.kind_after(2), Kind::Sign('_' | '^')) {
            return Ok(false);
        }
        let back = self.at;
        self.bump();
        let name = self.single_name()?.map(|(name, _)| name);
        self.at = back;
        Ok(name.as_deref() == Some(r"\delta") && !self.scope.declares(r"\delta"))
    }

    /// Behind `\partial` in a denominator: a symbol, as often as its superscript says.
    fn variables(&mut self) -> Parsed<Vec<Node>> {
        let span = self.span();
        let Some(mut node) = self.primary()? else {
            return refuse("latex::derivative", "a derivative is by a symbol", span, HOW);
        };
        let NodeKind::Symbol(s) = &mut node.kind else {
            return refuse("latex::derivative", "a derivative is by one symbol", node.span, HOW);
        };
        let order = match s.sup.take().map(|n| n.kind) {
            None => 1,
            Some(NodeKind::Number(n)) => u8::try_from(n).unwrap_or(0),
            Some(_) => 0,
        };
        if order == 0 || u32::from(order) > HIGHEST_ORDER || s.arguments.is_some() {
            let message = format!("a derivative is by a symbol, at most {HIGHEST_ORDER} times");
            return refuse("latex::derivative", message, node.span, HOW);
        }
        Ok(vec![node; usize::from(order)])
    }

    /// At `\partial`: by what, in a subscript, and what it acts on.
    pub(super) fn partial(&mut self, start: usize) -> Parsed<Node> {
        self.bump();
        if !self.eat('_') {
            return refuse("latex::derivative", "`\\partial` does not say by what", start..self.last_end(), HOW);
        }
        let braced = self.eat('{');
        let mut by = Vec::new();
        loop {
            let span = self.span();
            let read = if braced { self.single_name()? } else { self.name_without_primes()? };
            let Some((name, span)) = read else {
                return refuse("latex::derivative", "a derivative is by a symbol", span, HOW);
            };
            let mut symbol = super::names::plain(name);
            if braced && self.eat('_') {
                symbol.sub = Some(self.subscript()?);
            }
            by.push(Node::new(NodeKind::Symbol(symbol), span.start..self.last_end()));
            if !braced || self.is('}') {
                break;
            }
        }
        if braced {
            self.expect('}')?;
        }
        if self.is('^') {
            let span = self.span();
            let order = self.differential_order()?;
            if by.len() > 1 {
                let hint = r"write `\partial_x^2\partial_yu`";
                return refuse("latex::ambiguous", "a power of a derivative by several symbols", span, hint);
            }
            by = vec![by.swap_remove(0); usize::from(order)];
        }
        let (of, open) = self.operand(&by)?;
        let node = self.node(NodeKind::Partial { of: Box::new(of), by, form: PartialForm::Subscript }, start);
        self.leave_operator_open(open);
        Ok(node)
    }

    /// At `\nabla`: what it does, and to what.
    pub(super) fn nabla(&mut self, start: usize) -> Parsed<Node> {
        self.bump();
        let action = if self.is_command("cdot") {
            self.bump();
            Nabla::Divergence
        } else if self.is_command("times") {
            self.bump();
            Nabla::Curl
        } else if self.is('^') {
            let span = self.span();
            if self.differential_order()? != 2 {
                return refuse("latex::unsupported", r"of `\nabla` there is the square only", span, "");
            }
            Nabla::Laplacian { delta: false }
        } else {
            Nabla::Gradient
        };
        self.acting(action, start)
    }

    /// `\Delta`, where it is not declared, alone or with what follows, and there are coordinates: the Laplacian.
    pub(super) fn begins_laplacian(&mut self) -> Parsed<bool> {
        let could_be = self.is_command("Delta") && !self.scope.declares(r"\Delta") && self.scope.has_space();
        Ok(could_be && !self.is_difference()?)
    }

    /// An operator before what it acts on.
    pub(super) fn acting(&mut self, action: Nabla, start: usize) -> Parsed<Node> {
        let (mut of, mut open) = self.operand(&[])?;
        let number = matches!(&of.kind, NodeKind::Symbol(s) if s.sup.is_none() && self.scope.is_number(&s.name, s.sub.as_deref()));
        // `\nabla\cdot\epsilon{\bf E}`: a number alone has no divergence, and no curl.
        if number && matches!(action, Nabla::Divergence | Nabla::Curl) && self.begins_vector()? {
            let first = of.span.start;
            let (vector, end) = self.operand(&[])?;
            open = end;
            of = self.node(NodeKind::Product(vec![of, vector]), first);
        }
        if number && action == Nabla::Gradient {
            open = Some(Open::Gradient);
        }
        let node = self.node(NodeKind::Nabla { of: Box::new(of), action }, start);
        self.leave_operator_open(open);
        Ok(node)
    }

    /// At `\{`: a Poisson bracket. Braces that are printed around anything else have no meaning.
    pub(super) fn poisson(&mut self, start: usize) -> Parsed<Node> {
        let span = self.span();
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let left = self.sum()?;
        if self.is_command("}") && matches!(left.kind, NodeKind::Sum(_)) {
            self.bars = outer;
            self.bump();
            return Ok(self.node(NodeKind::Group(Box::new(left), Bracket::Curly), start));
        }
        if !self.eat(',') {
            let hint = "write parentheses around a group";
            let message = "braces that are printed are a Poisson bracket, `\\{f,g\\}`";
            return refuse("latex::unknown-command", message, span, hint);
        }
        let right = self.sum()?;
        self.bars = outer;
        if !self.is_command("}") {
            let message =
                format!("{} stands where a Poisson bracket of two formulas is closed by `\\}}`", self.shown());
            return refuse("latex::unbalanced", message, span.start..self.span().end, "");
        }
        self.bump();
        Ok(self.node(NodeKind::Poisson(Box::new(left), Box::new(right)), start))
    }

    /// `({\bf v}\cdot\nabla)`, and what it acts on, if this begins here.
    pub(super) fn derivative_along(&mut self, start: usize) -> Parsed<Option<Node>> {
        let Some(close) = self.closing().filter(|_| self.is('(')) else { return Ok(None) };
        let ends = |back: usize, name: &str| {
            let token = close.checked_sub(back).and_then(|i| self.tokens.get(i));
            matches!(token.map(|t| &t.kind), Some(Kind::Command(c)) if c == name)
        };
        if !ends(1, "nabla") || !ends(2, "cdot") {
            return Ok(None);
        }
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let Some(direction) = self.factor()? else {
            return refuse("latex::unexpected", "nothing stands before `\\cdot\\nabla`", self.span(), "");
        };
        self.bars = outer;
        if self.at + 2 != close {
            let hint = "put it into parentheses";
            return refuse("latex::ambiguous", "a direction is one factor", direction.span, hint);
        }
        self.at = close + 1;
        self.acting(Nabla::Along(Box::new(direction)), start).map(Some)
    }

    /// What an operator acts on, and whether its end can be seen: then another derivative may follow, or anything.
    fn operand(&mut self, by: &[Node]) -> Parsed<(Node, Option<Open>)> {
        let of = self.derived(by, r"write `\partial_x(…)`")?;
        self.rate_is_clear(&of)?;
        let open = match &of.kind {
            NodeKind::Group(..) | NodeKind::Poisson(..) => None,
            NodeKind::Symbol(_) => Some(Open::Operator { clear: true }),
            NodeKind::Nabla { action: Nabla::Following { fraction: true }, .. }
            | NodeKind::Partial { form: PartialForm::Fraction, .. } => Some(Open::Operator { clear: true }),
            NodeKind::Partial { .. } | NodeKind::Nabla { .. } => self.open_here().cloned(),
            _ => Some(Open::Operator { clear: false }),
        };
        Ok((of, open))
    }

    /// The factor that a derivative acts on, with the constants before it: `\frac{d}{dt}m\ell^2\dot\theta` is no derivative of m alone,
    /// which would be none.
    pub(super) fn derived(&mut self, by: &[Node], hint: &str) -> Parsed<Node> {
        let (start, span) = (self.span().start, self.span());
        let Some(first) = self.factor()? else {
            return refuse("latex::derivative", "nothing follows the derivative", span, hint);
        };
        let mut factors = vec![first];
        while factors.last().is_some_and(|last| self.is_constant(last, by))
            && self.begins_factor()
            && !self.begins_derivative_after(usize::from(self.is('(')))
        {
            match self.factor()? {
                Some(next) => factors.push(next),
                None => break,
            }
        }
        match (factors.len(), factors.pop()) {
            (1, Some(only)) => Ok(only),
            (_, last) => {
                factors.extend(last);
                Ok(self.node(NodeKind::Product(factors), start))
            }
        }
    }

    /// Whether something does not change, whatever is derived: numbers, and parameters that nothing is derived by.
    fn is_constant(&self, node: &Node, by: &[Node]) -> bool {
        match &node.kind {
            NodeKind::Number(_) | NodeKind::Pi => true,
            NodeKind::Symbol(s) => {
                let is_variable = |n: &Node| matches!(&n.kind, NodeKind::Symbol(v) if v.name == s.name);
                s.dots == 0
                    && s.arguments.is_none()
                    && self.scope.is_constant(&s.name, s.sub.as_deref())
                    && !by.iter().any(is_variable)
                    && s.sup.as_ref().is_none_or(|sup| self.is_constant(sup, by))
            }
            NodeKind::Quotient { top, bottom, .. } => self.is_constant(top, by) && self.is_constant(bottom, by),
            _ => false,
        }
    }

    fn leave_operator_open(&mut self, open: Option<Open>) {
        if let Some(open) = open {
            self.leave_open(open);
        }
    }
}

/// Whether something has a power that could belong to the derivative or to what is derived; `\psi^*` has none.
fn is_raised(node: &Node) -> bool {
    let power = |sup: &Option<Box<Node>>| sup.as_ref().is_some_and(|n| !matches!(n.kind, NodeKind::Conjugation { .. }));
    match &node.kind {
        NodeKind::Symbol(s) => power(&s.sup),
        NodeKind::Scripted { sup, .. } => power(sup),
        NodeKind::Number(r) => *r != Rational::ZERO,
        _ => false,
    }
}
