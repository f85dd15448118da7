//! Names before brackets that are calls, not products: `f(x+1)`, `\Gamma(a+1)`, `S[q]`, `E[X^2]`, `L(q,\dot q,t)`.
//!
//! What is declared as a function, and a value at a time, is read elsewhere. All else behind a name is a product on paper only where
//! no reader takes it for a call: `m(a+b)` is one, `f(a+b)` is not. What could be a call is refused, with both readings, however the
//! name is declared: so no declaration makes a product of it.

use super::super::convention::{BETA, EVEN_OR_ODD, FUNCTIONALS, FUNCTIONS, base, known_function, prints_as_operator};
use super::super::lexer::Kind;
use super::super::name::{self, NAMES};
use super::super::syntax::{Bracket, Node, NodeKind, SymbolNode};
use super::super::write::subscript;
use super::{Parsed, Parser, refuse};

impl Parser<'_> {
    /// Refuses a name before parentheses that are neither its arguments nor its time, where both could be a call.
    pub(super) fn is_no_call(&self, symbol: &SymbolNode, start: usize, close: usize) -> Parsed<()> {
        if !self.scope.is_known(&symbol.name, symbol.sub.as_deref()) || self.is_spaced() {
            return Ok(());
        }
        // `\zeta(1-\zeta)`: no function is applied to itself.
        let is_function = FUNCTIONS.contains(&base(&symbol.name)) && !self.holds_itself(symbol, close);
        let content = self.content(&self.tokens[self.at + 1..close]);
        // `\dot{\boldsymbol\Theta}^T(\ldots)^T`: what is transposed itself is no function's value before what is transposed.
        let is_function = is_function && !(Self::is_transposed(symbol) && self.is_transposed_at(close));
        // The beta function has two arguments; a field or an amplitude B before one bracket is a factor.
        let is_function = is_function && (content.tuple || !BETA.contains(&base(&symbol.name)));
        let signed = content.signed && !content.sum && EVEN_OR_ODD.contains(&base(&symbol.name));
        let scalar = !self.scope.is_matrix(&symbol.name, symbol.sub.as_deref());
        let arguments = content.tuple && scalar && self.holds_names(close);
        if !is_function && !signed && !arguments {
            return Ok(());
        }
        self.two_readings(symbol, start, close)
    }

    /// Refuses a name before square brackets that could be what it is applied to.
    pub(super) fn is_no_functional(&self, symbol: &SymbolNode, start: usize) -> Parsed<()> {
        if self.bracketed_name()?.is_some() || self.is_spaced() {
            return Ok(());
        }
        let Some(close) = self.closing_square() else { return Ok(()) };
        let content = self.content(&self.tokens[self.at + 1..close]);
        let name = base(&symbol.name);
        let functional = FUNCTIONS.contains(&name) || FUNCTIONALS.contains(&name);
        if content.tuple || content.number || content.sum && !functional {
            return Ok(());
        }
        self.two_readings(symbol, start, close)
    }

    /// Whether the parentheses hold the name before them, applied to nothing.
    pub(super) fn holds_itself(&self, symbol: &SymbolNode, close: usize) -> bool {
        let itself = |kind: &Kind| match kind {
            Kind::Letter(c) => symbol.name == c.to_string(),
            Kind::Command(c) => symbol.name.strip_prefix('\\') == Some(c),
            _ => false,
        };
        symbol.sub.is_none()
            && (self.at + 1..close).any(|i| {
                itself(&self.tokens[i].kind) && !matches!(self.tokens[i + 1].kind, Kind::Sign('(' | '_' | '[' | '\''))
            })
    }

    fn two_readings(&self, symbol: &SymbolNode, start: usize, close: usize) -> Parsed<()> {
        let shown = self.text[start..self.last_end()].trim();
        let inside = &self.text[self.span().start..self.tokens[close].span.end];
        let called = known_function(base(&symbol.name)).map(|f| format!(", {f},")).unwrap_or_default();
        let message = format!("is this `{shown}`{called} of what follows, or a product?");
        let hint = format!(
            r"a product is written `{shown}\cdot{inside}`; a function is declared with its arguments, by a formula or as a field"
        );
        refuse("latex::ambiguous", message, start..self.tokens[close].span.end, hint)
    }

    /// Whether all that the parentheses hold, between commas, are names, or numbers beside names: `(q,\dot q,t)`, `(0,t)`.
    fn holds_names(&self, close: usize) -> bool {
        let inside = &self.tokens[self.at + 1..close];
        let plain = inside.iter().all(|t| match &t.kind {
            Kind::Letter(_) | Kind::Number(_) | Kind::Sign(',' | '_' | '{' | '}' | '\'') => true,
            Kind::Command(c) => {
                NAMES.contains(&c.as_str())
                    || matches!(c.as_str(), "dot" | "ddot" | "infty")
                    || name::style(c).is_some()
            }
            _ => false,
        });
        let names = |part: &[super::Token]| {
            part.iter()
                .any(|t| matches!(&t.kind, Kind::Letter(_)) || matches!(&t.kind, Kind::Command(c) if c != "infty"))
        };
        let parts = inside.split(|t| t.kind == Kind::Sign(','));
        let (with, without) = parts.partition::<Vec<_>, _>(|part| names(part));
        // `a(1,0,0)` and `a(x,0,0)` are vectors; `u(0,t)` is a place.
        let times = with.iter().any(|part| matches!(part, [t] if t.kind == Kind::Letter('t')));
        plain && !with.is_empty() && (without.is_empty() || times)
    }

    /// Position of the token that closes the square bracket at the present place.
    fn closing_square(&self) -> Option<usize> {
        let mut depth = 0usize;
        for (i, token) in self.tokens.iter().enumerate().skip(self.at) {
            match token.kind {
                Kind::Sign('[') => depth += 1,
                Kind::Sign(']') => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        return Some(i);
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// Refuses `\Delta_hf(x)`: a difference of values of f, or a product.
    pub(super) fn is_no_operator(last: &Node, factor: &Node) -> Parsed<()> {
        let (NodeKind::Symbol(operator), NodeKind::Symbol(of)) = (&last.kind, &factor.kind) else { return Ok(()) };
        let operates = prints_as_operator(&operator.name) && operator.arguments.is_none();
        if !operates || of.arguments.is_none() {
            return Ok(());
        }
        let message = "a difference of values of what follows, or a product?";
        let hint = r"write `\cdot` for the product; a difference is written out";
        refuse("latex::ambiguous", message, last.span.start..factor.span.end, hint)
    }

    /// Refuses `\frac{df}{dx}(a)` and `\frac{\partial u}{\partial t}(x,0)`: the derivative at a place, or a product. What holds a field, or a rate, is no
    /// place, and a factor.
    pub(super) fn is_no_place(&self, last: &Node, factor: &Node) -> Parsed<()> {
        let mut of = last;
        let mut derived = false;
        let mut by_number = false;
        while let NodeKind::Partial { of: inner, .. }
        | NodeKind::Derivative { of: inner, .. }
        | NodeKind::Nabla { of: inner, .. } = &of.kind
        {
            derived = true;
            by_number |= matches!(&of.kind, NodeKind::Partial { by, .. } if by.iter().any(|n| self.is_a_number(n)));
            of = inner;
        }
        let field = match &of.kind {
            NodeKind::Symbol(s) => s.arguments.is_none() && self.scope.is_field(&s.name, s.sub.as_deref()),
            _ => false,
        };
        let place = match &factor.kind {
            // No vector is a place for what is derived by a number.
            NodeKind::Group(inner, Bracket::Round) => {
                !(self.holds_a_field(inner) || by_number && self.is_a_vector(inner))
            }
            NodeKind::Tuple(_) => true,
            _ => false,
        };
        if !derived || !field || !place {
            return Ok(());
        }
        let message = "is this the derivative at a place, or a product?";
        let hint = r"write `\cdot` for the product, and `f'(a)`, `u_t(x,0)` or `\left.\partial_tu\right|_{t=0}` for the derivative at a place";
        refuse("latex::ambiguous", message, last.span.start..factor.span.end, hint)
    }

    fn is_a_number(&self, node: &Node) -> bool {
        matches!(&node.kind, NodeKind::Symbol(s) if s.sub.is_none() && self.scope.is_number(&s.name, None))
    }

    /// Whether something is a vector by the names of its terms.
    fn is_a_vector(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::Symbol(s) => s.arguments.is_none() && self.scope.is_vector(&s.name, s.sub.as_deref()),
            NodeKind::Group(inner, Bracket::Round) => self.is_a_vector(inner),
            NodeKind::Sum(terms) => terms.iter().all(|(_, term)| self.is_a_vector(term)),
            NodeKind::Product(factors) => factors.iter().filter(|f| self.is_a_vector(f)).count() == 1,
            _ => false,
        }
    }

    fn holds_a_field(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::Partial { .. } | NodeKind::Derivative { .. } | NodeKind::Nabla { .. } => true,
            NodeKind::Symbol(s) if self.scope.is_field(&s.name, s.sub.as_deref()) => true,
            _ => node.children().into_iter().any(|n| self.holds_a_field(n)),
        }
    }

    /// Refuses `f(…)` where f is not declared at all, with a hint on how a function is.
    pub(super) fn is_no_unknown_function(&self, symbol: &SymbolNode, start: usize, close: usize) -> Parsed<()> {
        let inside = &self.tokens[self.at + 1..close];
        let name = &symbol.name;
        let indexed = symbol.sub.is_some() && matches!(name.as_str(), r"\epsilon" | r"\varepsilon" | r"\delta");
        let built_in = indexed || matches!(name.as_str(), "e" | "rm:e") || name::is_imaginary_unit(name);
        let known = self.scope.has_base(name) || self.scope.is_refused(name, symbol.sub.as_deref());
        if inside.is_empty() || built_in || symbol.dots > 0 || known {
            return Ok(());
        }
        let called = name::to_latex(name) + &symbol.sub.as_deref().map(subscript).unwrap_or_default();
        let message = format!("`{called}` is not declared");
        let span = start..self.last_end();
        if let Some(function) = known_function(base(name)) {
            let hint = format!(
                r"if this is {function}, it is not part of the formula language; a number is declared, and written `{called}\cdot(…)` here"
            );
            return refuse("latex::unknown-symbol", message, span, hint);
        }
        let names = inside.iter().all(|t| match &t.kind {
            Kind::Letter(_) | Kind::Sign(',' | '_' | '{' | '}') | Kind::Number(_) => true,
            Kind::Command(c) => NAMES.contains(&c.as_str()),
            Kind::Sign(_) | Kind::OpenBar | Kind::CloseBar | Kind::OpenFence | Kind::Row | Kind::End => false,
        }) && !matches!(inside[0].kind, Kind::Number(_));
        if !names || name.contains(':') {
            let hint = "declare it under [symbols]: a function with its arguments and its formula, a field with its coordinates; \
                        as a number, it is multiplied by what stands in parentheses";
            return refuse("latex::unknown-symbol", message, span, hint);
        }
        let argument = &self.text[inside[0].span.start..self.tokens[close].span.start];
        let hint = format!(
            "a function is declared with its formula: '{called}({argument})' = {{ role = \"abbreviation\", arguments = \
             ['{argument}'], formula = '…' }}; what is no function is declared under [symbols]"
        );
        refuse("latex::unknown-symbol", message, span, hint)
    }
}
