//! Named functions and operators, and where their arguments end.

use super::super::lexer::Kind;
use super::super::syntax::{Nabla, Node, NodeKind};
use super::super::typeset;
use super::{Open, Parsed, Parser, refuse, side_by_side};
use expr::Op;

/// Functions of one argument that need no parentheses.
pub(super) const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth", "exp", "ln", "log", "det",
    "cot", "sec", "csc",
];

/// Functions of one argument that have no command of their own.
const NAMED: &[&str] = &["asinh", "acosh", "atanh", "sech", "csch", "sgn", "floor", "ceil", "Re", "Im", "arg"];

/// Other words for functions, behind `\operatorname` or in upright type.
const SYNONYMS: &[(&str, &str)] = &[
    ("asin", "arcsin"),
    ("acos", "arccos"),
    ("atan", "arctan"),
    ("arsinh", "asinh"),
    ("arcsinh", "asinh"),
    ("arcosh", "acosh"),
    ("arccosh", "acosh"),
    ("artanh", "atanh"),
    ("arctanh", "atanh"),
    ("sign", "sgn"),
    ("ceiling", "ceil"),
];

/// The function of one argument that a word stands for.
pub(super) fn named(word: &str) -> Option<&'static str> {
    let synonym = SYNONYMS.iter().find(|(w, _)| *w == word).map(|(_, f)| *f);
    synonym.or_else(|| FUNCTIONS.iter().chain(NAMED).find(|f| **f == word).copied())
}

/// Whether a word, in upright type, is a function of the language.
pub fn is_function(word: &str) -> bool {
    named(word).is_some() || operators().any(|(name, _)| name == word)
}

/// Functions written with `\operatorname` or `\rm`, and their number of arguments; 0 for any.
pub(super) fn operators() -> impl Iterator<Item = (&'static str, usize)> {
    let name = |op: &Op| Some((op.spelling().strip_prefix(r"\operatorname{")?.strip_suffix('}')?, op.arity()));
    Op::ALL.iter().filter_map(name).chain([("tr", 1), ("diag", 0), ("diagonal", 0)])
}

/// The word for what ∇ does: `\operatorname{rot}` is `\nabla\times`.
pub(super) fn of_nabla(word: &str) -> Option<Nabla> {
    match word {
        "grad" => Some(Nabla::Gradient),
        "div" => Some(Nabla::Divergence),
        "rot" | "curl" => Some(Nabla::Curl),
        _ => None,
    }
}

/// The sign of such a word, `\nabla\times` for `rot`; `None` of other words.
pub fn sign_of_nabla(word: &str) -> Option<&'static str> {
    match of_nabla(word)? {
        Nabla::Gradient => Some(r"\nabla "),
        Nabla::Divergence => Some(r"\nabla\cdot "),
        Nabla::Curl => Some(r"\nabla\times "),
        Nabla::Laplacian { .. } | Nabla::Along(_) | Nabla::Wave | Nabla::Following { .. } => None,
    }
}

/// Operators that papers also write as plain words.
pub(super) const WORDS: &[&str] = &["diag", "diagonal"];

/// The brackets of a whole part, on a page; `None` for other functions.
pub fn whole_part(function: &str) -> Option<[&'static str; 2]> {
    match function {
        "floor" => Some(["⌊", "⌋"]),
        "ceil" => Some(["⌈", "⌉"]),
        _ => None,
    }
}

/// The operation of that name.
pub(crate) fn operation(name: &str) -> Option<Op> {
    let spelling = spelled(name);
    Op::ALL.iter().copied().find(|op| op.spelling() == spelling)
}

/// A function as a formula writes it.
pub(crate) fn spelled(name: &str) -> String {
    if FUNCTIONS.contains(&name) { format!(r"\{name}") } else { format!(r"\operatorname{{{name}}}") }
}

/// Whether the function may stand before its argument without parentheses.
pub(crate) fn takes_bare_argument(name: &str) -> bool {
    FUNCTIONS.contains(&name) || NAMED.contains(&name) || name == "tr"
}

impl Parser<'_> {
    /// At `\lfloor` or `\lceil`: a whole part.
    pub(super) fn whole_part(&mut self, name: &str, closing: &str, start: usize) -> Parsed<Node> {
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let inner = self.sum()?;
        self.bars = outer;
        if !matches!(self.kind(), Kind::Command(c) if c == closing) {
            let message = format!("a whole part is not closed by `\\{closing}`");
            return refuse("latex::unbalanced", message, self.span(), "");
        }
        self.bump();
        Ok(self.node(NodeKind::Function(name.to_owned(), None, vec![inner]), start))
    }

    /// Whether the bracket of a whole part was just closed.
    pub(super) fn follows_whole_part(&self) -> bool {
        let before = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        before.is_some_and(|t| matches!(&t.kind, Kind::Command(c) if c == "rfloor" || c == "rceil"))
    }

    /// After an operator's name: its arguments in parentheses.
    pub(super) fn operator(&mut self, word: String, start: usize) -> Parsed<Node> {
        let arity = operators().find(|(name, _)| *name == word).map_or(0, |(_, n)| n);
        if self.is('^') || self.is('_') {
            let message = format!("a script behind `{word}`");
            return refuse("latex::unexpected", message, self.span(), "put parentheses around the function");
        }
        if word == "tr" {
            let argument = self.function_argument(&word, start)?;
            return Ok(self.node(NodeKind::Function(word, None, vec![argument]), start));
        }
        let span = self.span();
        if !self.eat('(') {
            return refuse("latex::unexpected", format!("`{word}` needs its arguments in parentheses"), span, "");
        }
        let outer = std::mem::replace(&mut self.bars, 0);
        let mut arguments = vec![self.sum()?];
        while self.eat(',') {
            arguments.push(self.sum()?);
        }
        self.expect(')')?;
        self.bars = outer;
        if arity != 0 && arguments.len() != arity {
            let message = format!("`{word}` has {arity} arguments, not {}", arguments.len());
            return refuse("latex::arity", message, start..self.last_end(), "");
        }
        Ok(self.node(NodeKind::Function(word, None, arguments), start))
    }

    /// After `\sin` and the like: an optional power, then an argument.
    pub(super) fn function(&mut self, name: &str, start: usize) -> Parsed<Node> {
        let mut power = None;
        let mut base = None;
        if self.is('_') {
            if name != "log" {
                let message = format!("a subscript behind `{}`", spelled(name));
                return refuse("latex::unexpected", message, self.span(), "");
            }
            self.bump();
            base = Some(self.base()?);
        }
        if self.eat('^') {
            let span = self.span();
            let exponent = self.superscript()?;
            let integer = match &exponent.kind {
                NodeKind::Number(r) => i32::try_from(r.clone()).ok(),
                _ => None,
            };
            match integer {
                Some(n @ 2..=64) => power = Some(n),
                _ => {
                    let (inverse, shown) = (format!("arc{name}"), spelled(name));
                    let other = if FUNCTIONS.contains(&inverse.as_str()) {
                        format!(
                            r"write `\{inverse}(…)` for the inverse function, `\frac{{1}}{{{shown}(…)}}` for the power"
                        )
                    } else {
                        format!(r"write parentheses around the function, `({shown}(…))^{{…}}`")
                    };
                    let message = format!("`{shown}` to this power may mean a power or another function");
                    return refuse("latex::ambiguous", message, span.start..self.last_end(), other);
                }
            }
        }
        let argument = self.function_argument(name, start)?;
        let arguments = std::iter::once(argument).chain(base).collect();
        Ok(self.node(NodeKind::Function(name.to_owned(), power, arguments), start))
    }

    /// Behind `\log_`: the base, one token or what stands in braces.
    fn base(&mut self) -> Parsed<Node> {
        if let Kind::Number(n) = self.kind()
            && n.len() > 1
        {
            let hint = format!("write `_{{{n}}}`");
            return refuse("latex::ambiguous", "LaTeX lowers only the first digit", self.span(), hint);
        }
        self.argument()
    }

    /// The argument of a function: in parentheses; or one factor; or a number or π and one factor; or a product of numbers
    /// and constants that ends in the time.
    fn function_argument(&mut self, name: &str, begin: usize) -> Parsed<Node> {
        let shown = spelled(name);
        let start = self.span().start;
        let bar = *self.kind() == Kind::OpenBar || (self.is('|') && self.bars == 0);
        if self.is('(') || self.is('[') || bar || self.is_command("begin") {
            let Some(argument) = self.primary()? else {
                return refuse("latex::unexpected", format!("`{shown}` has no argument"), self.span(), "");
            };
            if (self.is('^') || self.is('_')) && !(self.is('^') && is_lone(&argument)) {
                let hint = format!("write `{shown}^2(…)`, or another pair of parentheses");
                let message = format!("does the script belong to `{shown}` or to its argument?");
                return refuse("latex::ambiguous", message, self.span(), hint);
            }
            return Ok(argument);
        }
        if matches!(self.kind(), Kind::Sign('-' | '+')) || self.is_command("pm") || self.is_command("mp") {
            let message = format!("a sign stands behind `{shown}`");
            return refuse("latex::ambiguous", message, self.span(), "put the argument into parentheses");
        }
        let mut factors: Vec<Node> = Vec::new();
        let mut spaced = false;
        while self.begins_bare_argument() {
            if let Some(last) = factors.last() {
                // `\sin\theta\,\dot\varphi`: a space that is printed ends what can be an argument by itself.
                let gap = self.is_spaced();
                // `\sin\theta\dot\varphi`: so does a rate behind it, which no one writes into an argument without parentheses.
                if (gap || self.begins_rate() && !has_dots(last)) && self.moves(last) || self.begins_vector()? {
                    break;
                }
                spaced |= gap;
                self.end_is_clear()?;
            }
            let Some(factor) = self.factor()? else { break };
            if let Some(last) = factors.last() {
                side_by_side(last, &factor)?;
            }
            match factor.kind {
                NodeKind::Product(inner) => factors.extend(inner),
                _ => factors.push(factor),
            }
        }
        let clear = match factors.as_slice() {
            [] if self.begins_function() => return self.function_of_function(&shown),
            [] => {
                let hint = format!("put the argument into parentheses: `{shown}(…)`");
                return refuse("latex::unexpected", format!("`{shown}` has no argument"), self.span(), hint);
            }
            [_] => true,
            [Node { kind: NodeKind::Number(_) | NodeKind::Pi, .. }, last] => !matches!(last.kind, NodeKind::Group(..)),
            [first, Node { kind: NodeKind::Pi, .. }, _] => matches!(first.kind, NodeKind::Number(_)),
            // `\cos\omega t`, `\cos kx`.
            [init @ .., last] => {
                // Where nothing moves, the letter `t` is as good as a time.
                let timeless = self.scope.is_timeless();
                let time = self.is_time(last) || timeless && is_letter(last) && last.is_named("t");
                time && init.iter().all(|n| self.is_steady(n))
                    // `\det AB` could be a number times a matrix.
                    || is_letter(last)
                        && !matches!(name, "det" | "tr")
                        && (timeless || self.moves(last))
                        && init.iter().all(|n| self.is_coefficient(n))
            }
        };
        let ended = self.begins_vector()?
            || (self.is_spaced() || self.begins_rate()) && factors.last().is_some_and(|n| self.moves(n));
        let followed = !ended
            && (self.is('(') || self.is('[') || *self.kind() == Kind::OpenBar || (self.is('|') && self.bars == 0));
        let grouped = matches!(factors.as_slice(), [Node { kind: NodeKind::Group(..), .. }]);
        // `\sin a\,t` may be a product, or have a longer argument.
        if !clear || spaced || (followed && !grouped) {
            let message = format!("it is not clear where the argument of `{shown}` ends");
            let hint = self.two_arguments(&factors, (begin, start), followed);
            return refuse("latex::ambiguous", message, start..self.last_end(), hint);
        }
        if let Some(raised) = factors.iter().find(|n| has_superscript(n)) {
            let message = format!("does the power belong to `{shown}` or to its argument?");
            let (head, argument) = (&self.text[begin..start], &self.text[start..self.last_end()]);
            let other = match argument.split_once('^') {
                Some((base, power)) if power == "2" => format!("({head}{base})^{power}"),
                _ => format!("({head}(…))^{{…}}"),
            };
            let hint = format!("write `{}({argument})`, or `{other}`", head.trim());
            return refuse("latex::ambiguous", message, raised.span.clone(), hint);
        }
        if grouped && (self.is('^') || self.is('_')) {
            let message = format!("does the script belong to `{shown}` or to its argument?");
            return refuse("latex::ambiguous", message, self.span(), "");
        }
        if !grouped {
            let steady = !factors.last().is_some_and(|n| self.is_time(n)) && factors.iter().all(|n| self.is_steady(n));
            self.leave_open(Open::Function { name: name.to_owned(), steady });
        }
        match (factors.len(), factors.pop()) {
            (1, Some(only)) => Ok(only),
            (_, last) => {
                factors.extend(last);
                Ok(self.node(NodeKind::Product(factors), start))
            }
        }
    }

    /// `\ln\sin x`: a function of another one, where nothing follows that could belong to either.
    // Out of line: what calls it is deep enough as it is.
    #[inline(never)]
    fn function_of_function(&mut self, shown: &str) -> Parsed<Node> {
        let start = self.span().start;
        // It takes as much of the stack as what stands in three brackets.
        let inner = self
            .deeper(|p| p.deeper(|p| p.deeper(Self::factor)))?
            .filter(|_| !(self.begins_factor() || self.is('/') || self.is_command("cdot") || self.is_command("times")));
        inner.map_or_else(
            || {
                let message = format!("it is not clear where the argument of `{shown}` ends");
                let hint = format!("put the argument into parentheses: `{shown}(…)`");
                refuse("latex::ambiguous", message, start..self.last_end(), hint)
            },
            Ok,
        )
    }

    /// The two readings of a function whose argument has no clear end: all of it, or the first factor.
    fn two_arguments(&self, factors: &[Node], (begin, start): (usize, usize), followed: bool) -> String {
        let text = |from: usize, to: usize| self.text.get(from..to).unwrap_or_default().trim();
        let head = text(begin, start);
        let (long, short, rest) = match self.closing().filter(|_| followed && self.is('(')) {
            Some(close) => {
                let end = self.tokens[close].span.end;
                (text(start, end), text(start, self.last_end()), text(self.last_end(), end).trim_start_matches(r"\,"))
            }
            None => {
                let first = factors.iter().position(|n| !matches!(n.kind, NodeKind::Number(_) | NodeKind::Pi));
                let [.., last, next] = &factors[..factors.len().min(first.unwrap_or(0) + 2)] else {
                    return format!("put the argument into parentheses: `{head}(…)`");
                };
                let whole = text(start, self.last_end());
                (whole, text(start, last.span.end), text(next.span.start, self.last_end()))
            }
        };
        format!("put the argument into parentheses, `{head}({long})`, or write `{rest}{head}({short})`")
    }

    /// Whether a name with dots begins here.
    pub(super) fn begins_rate(&self) -> bool {
        let braces = (0..3).take_while(|&i| *self.kind_after(i) == Kind::Sign('{')).count();
        matches!(self.kind_after(braces), Kind::Command(c) if matches!(c.as_str(), "dot" | "ddot"))
    }

    /// Whether a name in bold, or with an arrow, stands here, and makes no number of what stands before it: no function of a number has a vector
    /// in its argument. `\cos\omega\mathbf k\cdot\mathbf r` is not so.
    pub(super) fn begins_vector(&mut self) -> Parsed<bool> {
        let is_styled = |p: &Self| matches!(p.kind(), Kind::Command(c) if super::super::name::style(c).is_some_and(super::super::name::marks_tensor));
        if !is_styled(self) {
            return Ok(false);
        }
        let back = self.at;
        let name = self.single_name()?.map(|(name, _)| name);
        let mut scripts = 0;
        while self.is('_') && scripts < 2 {
            scripts += 1;
            self.bump();
            self.skip_argument();
        }
        let goes_on = self.is_command("cdot") || self.is_command("times") || self.is('^') || self.is('(');
        self.at = back;
        Ok(name.is_some_and(|n| !self.scope.is_number(&n, None)) && !goes_on)
    }

    /// Passes over a token, or what stands in braces.
    fn skip_argument(&mut self) {
        let mut depth = 0usize;
        loop {
            match self.kind() {
                Kind::End => return,
                Kind::Sign('{') => depth += 1,
                Kind::Sign('}') => depth = depth.saturating_sub(1),
                _ => {}
            }
            self.bump();
            if depth == 0 {
                return;
            }
        }
    }

    pub(super) fn is_time(&self, node: &Node) -> bool {
        matches!(&node.kind, NodeKind::Symbol(s) if s.sub.is_none() && self.scope.time_name() == Some(s.name.as_str()))
    }

    /// A number, or a constant of one Latin letter: what stands before a variable in `\cos kx`.
    fn is_coefficient(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::Number(_) | NodeKind::Pi => true,
            _ => is_letter(node) && self.is_steady(node),
        }
    }

    /// Whether LaTeX prints a space between what was read last and what stands here.
    pub(super) fn is_spaced(&self) -> bool {
        let mut gap = String::new();
        // What stands in a comment, or in a label, is not printed.
        typeset::gap(self.text.get(self.last_end()..self.span().start).unwrap_or_default(), &mut gap);
        [r"\,", r"\;", r"\:", r"\>", r"\ ", "~", r"\quad", r"\qquad"].iter().any(|s| gap.contains(s))
    }

    fn is_steady(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::Number(_) | NodeKind::Pi => true,
            NodeKind::Symbol(s) => s.dots == 0 && !self.scope.is_variable(&s.name, s.sub.as_deref()),
            NodeKind::Group(inner, _) => self.is_steady(inner),
            NodeKind::Sum(terms) => terms.iter().all(|(_, n)| self.is_steady(n)),
            NodeKind::Product(parts) => parts.iter().all(|n| self.is_steady(n)),
            NodeKind::Quotient { top, bottom, .. } => self.is_steady(top) && self.is_steady(bottom),
            NodeKind::Root(inner, _) => self.is_steady(inner),
            _ => false,
        }
    }
}

/// One symbol in parentheses that it needs for nothing but being an argument: `\sin(x)^2` is the square of the sine.
pub(super) fn is_lone(argument: &Node) -> bool {
    let NodeKind::Group(inner, _) = &argument.kind else { return false };
    matches!(&inner.kind, NodeKind::Symbol(s) if s.sup.is_none() && s.arguments.is_none())
}

/// One Latin letter without scripts or dots.
fn is_letter(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Symbol(s) if s.name.len() == 1 && s.dots == 0 && s.sub.is_none() && s.sup.is_none())
}

fn has_dots(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Symbol(s) if s.dots > 0)
}

fn has_superscript(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Symbol(s) => s.sup.is_some(),
        NodeKind::Scripted { sup, .. } => sup.is_some(),
        _ => false,
    }
}
