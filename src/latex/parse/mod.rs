//! Tokens → syntax tree.
//!
//! A strict recursive-descent parser: what it does not understand it refuses, with the place and a way to write it. The
//! scope is asked only where a text has two readings (is `f(x)` a value of f or a product?).
//!
//! What LaTeX does not print has no meaning here: braces group arguments of commands, but `{a+b}c` is printed as a + bc,
//! so it is refused. What is printed without a clear end, `a/b`, `\sin x`, `\frac{d}{dt}x`, must not be followed by
//! something that could belong to it.

mod beside;
mod brackets;
mod call;
mod factor;
mod fraction;
mod function;
mod instant;
mod names;
mod partial;
mod scripts;
mod symbol;
mod units;

use std::ops::Range;

use super::expand::written_out;
use super::feature;
use super::invisible::without_invisible_braces;
use super::lexer::{Kind, Token, tokens};
use super::name;
use super::refusal::{DEEPEST, Parsed, refuse};
use super::scope::Scope;
use super::syntax::{Chain, Node, NodeKind, RelationKind, Sign, Target};
use diag::Problem;
use expr::Rational;

pub(super) use beside::is_relation;
use beside::{relation, side_by_side};
pub use function::{is_function, sign_of_nabla, whole_part};
pub(super) use function::{operation, spelled, takes_bare_argument};
pub(super) use names::{WrittenName, read_name};

/// What was read last, if its end cannot be seen in print.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Open {
    /// A denominator behind a slash.
    Slash,
    /// The argument of a function, without parentheses; whether it is nothing but constants.
    Function { name: String, steady: bool },
    /// What a derivative written as an operator acts on; `clear` where it shows its variable, as `f(x)` does.
    Operator { clear: bool },
    /// A number of which the gradient is taken: a vector behind it can only be multiplied by that.
    Gradient,
}

pub(super) struct Parser<'a> {
    text: &'a str,
    scope: &'a Scope,
    tokens: Vec<Token>,
    at: usize,
    depth: usize,
    bars: usize,
    /// Where something with an open end stopped.
    open: Option<(usize, Open)>,
    /// Where something stopped that is taken at a time behind a bar, and how deep that was.
    bar: Option<(usize, usize)>,
    /// Letters in a subscript are labels or indices, one by one.
    in_subscript: bool,
    /// A name is read as such, or stands behind the command of a style: `\pi` is a letter there.
    in_name: bool,
    /// How deep the terms of an exponent of Euler's number are that is being read.
    exponent: Option<usize>,
    /// A double prime stands somewhere in the text: then it is no name of another frame.
    double_primes: bool,
}

/// Reads all chains of relations of a text; a chain may be a single expression.
pub(super) fn chains(text: &str, scope: &Scope) -> Result<Vec<Chain>, Vec<Problem>> {
    let mut parser = Parser::new(text, scope)?;
    parser.all().map_err(|p| vec![*p])
}

/// Finds unbalanced delimiters before anything else, so that they are named at their opening.
fn balanced(tokens: &[Token]) -> Parsed<()> {
    let mut open: Vec<(char, Range<usize>)> = Vec::new();
    let close = |c| match c {
        '(' => ')',
        '[' => ']',
        _ => '}',
    };
    for token in tokens {
        match token.kind {
            Kind::Sign(c @ ('(' | '[' | '{')) => open.push((c, token.span.clone())),
            Kind::Sign(c @ (')' | ']' | '}')) => match open.pop() {
                Some((o, _)) if close(o) == c => {}
                Some((o, span)) => {
                    let hint = format!("close it with `{}`", close(o));
                    return refuse("latex::unbalanced", format!("`{o}` is closed by `{c}`"), span, hint);
                }
                None => {
                    return refuse("latex::unbalanced", format!("`{c}` was never opened"), token.span.clone(), "");
                }
            },
            _ => {}
        }
        if open.len() > 4 * DEEPEST {
            let hint = "use a declared abbreviation";
            return refuse("latex::too-deep", "the nesting is too deep", token.span.clone(), hint);
        }
    }
    match open.pop() {
        Some((c, span)) => refuse("latex::unbalanced", format!("`{c}` is never closed"), span, ""),
        None => Ok(()),
    }
}

/// Environments that hold displayed equations.
const DISPLAYS: &[&str] = &["equation", "eqnarray", "align", "gather", "multline", "displaymath"];

impl<'a> Parser<'a> {
    fn new(text: &'a str, scope: &'a Scope) -> Result<Parser<'a>, Vec<Problem>> {
        let tokens = tokens(text)?;
        balanced(&tokens).map_err(|p| vec![*p])?;
        let tokens = written_out(tokens).and_then(without_invisible_braces).map_err(|p| vec![*p])?;
        let double_primes = tokens.windows(2).any(|w| w.iter().all(|t| t.kind == Kind::Sign('\'')));
        Ok(Parser {
            text,
            scope,
            tokens,
            at: 0,
            depth: 0,
            bars: 0,
            open: None,
            bar: None,
            in_subscript: false,
            in_name: false,
            exponent: None,
            double_primes,
        })
    }

    // ---- tokens --------------------------------------------------------------------------------------------------

    fn kind(&self) -> &Kind {
        self.kind_after(0)
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

    fn node(&self, kind: NodeKind, start: usize) -> Node {
        Node { kind, span: start..self.last_end() }
    }

    /// What was read last, if it stops here with an open end.
    fn open_here(&self) -> Option<&Open> {
        self.open.as_ref().filter(|(at, _)| *at == self.at).map(|(_, open)| open)
    }

    // ---- statements ----------------------------------------------------------------------------------------------

    /// Eats what stands between statements.
    fn separators(&mut self) -> Parsed<usize> {
        let mut eaten = 0;
        loop {
            match self.kind().clone() {
                Kind::Sign('.') => {
                    let next = self.kind_after(1);
                    let digit = |k: &Kind| matches!(k, Kind::Number(_));
                    if digit(next) && self.at > 0 && digit(&self.tokens[self.at - 1].kind) {
                        let hint = r"write a comma between two relations";
                        return refuse("latex::ambiguous", "a full stop between digits", self.span(), hint);
                    }
                    let adjacent = self.tokens[self.at + 1].span.start == self.span().end;
                    if adjacent && !matches!(next, Kind::End | Kind::Row) {
                        let hint = r"write `\cdot` for a product; a full stop is followed by a space";
                        return refuse("latex::ambiguous", "a full stop inside the formula", self.span(), hint);
                    }
                    self.bump();
                }
                Kind::Sign(',' | ';') | Kind::Row => self.bump(),
                Kind::Sign('&') if eaten > 0 => self.bump(),
                Kind::Command(c) if c == "begin" || c == "end" => {
                    let back = self.at;
                    self.bump();
                    let name = self.word();
                    if !name.is_some_and(|n| DISPLAYS.contains(&n.trim_end_matches('*'))) {
                        self.at = back;
                        return Ok(eaten);
                    }
                }
                _ => return Ok(eaten),
            }
            eaten += 1;
        }
    }

    fn all(&mut self) -> Parsed<Vec<Chain>> {
        let mut out = Vec::new();
        self.separators()?;
        if *self.kind() == Kind::End {
            return refuse("latex::empty", "there is no formula here", 0..self.text.len(), "");
        }
        loop {
            out.push(self.chain()?);
            if self.is_command("rightarrow") || self.is_command("to") {
                let hint = r"write `\lim_{t\rightarrow t_0}… = …`";
                return refuse("latex::limit", "an arrow is no relation", self.span(), hint);
            }
            if self.separators()? == 0 && *self.kind() != Kind::End {
                return refuse("latex::unexpected", format!("{} is not expected here", self.shown()), self.span(), "");
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
            Kind::Command(c) => return relation(c),
            _ => return None,
        })
    }

    fn chain(&mut self) -> Parsed<Chain> {
        let start = self.span().start;
        let mut sides = vec![self.side()?];
        let mut relations = Vec::new();
        loop {
            let back = self.at;
            while self.is('&') {
                self.bump();
            }
            let Some(relation) = self.relation() else {
                self.at = back;
                break;
            };
            self.bump();
            while self.is('&') {
                self.bump();
            }
            relations.push(relation);
            if relation == RelationKind::Equal {
                self.is_no_word_for_constant()?;
            }
            sides.push(self.side()?);
        }
        let time = self.scope.time_name().map(str::to_owned);
        Ok(Chain { sides, relations, span: start..self.last_end(), time })
    }

    /// Refuses `=\text{const.}`: what is constant is said by another form of claim.
    fn is_no_word_for_constant(&self) -> Parsed<()> {
        let upright = |k: &Kind| matches!(k, Kind::Command(c) if name::style(c) == Some("rm") || c == "textrm");
        let mut begin = 0;
        while upright(self.kind_after(begin)) || *self.kind_after(begin) == Kind::Sign('{') {
            begin += 1;
        }
        let letter = |i: usize| match self.kind_after(begin + i) {
            Kind::Letter(c) => Some(*c),
            _ => None,
        };
        let word: String = (0..10).map_while(letter).collect();
        let declared = match begin {
            0 => word.chars().all(|c| self.scope.declares(&c.to_string())),
            _ => self.scope.declares(&format!("rm:{word}")),
        };
        if !matches!(word.as_str(), "const" | "constant") || declared {
            return Ok(());
        }
        let span =
            self.span().start..self.tokens[(self.at + begin + word.len() - 1).min(self.tokens.len() - 1)].span.end;
        let hint = "claim `first-integral` of what is constant, without an equation";
        refuse("latex::unsupported", "that something is constant is no equation", span, hint)
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
        let name = self.single_name()?.map(|(name, _)| name);
        if name.is_none() || self.scope.time_name() != name.as_deref() {
            return refuse("latex::limit", "a limit goes along the time", variable, r"write `\lim_{t\rightarrow t_0}`");
        }
        if !(self.is_command("rightarrow") || self.is_command("to")) {
            let message = format!("{} stands where `\\rightarrow` is expected", self.shown());
            return refuse("latex::limit", message, self.span(), "");
        }
        self.bump();
        let signed = matches!(self.kind(), Kind::Sign('+' | '-'));
        let infinite = matches!(self.kind_after(usize::from(signed)), Kind::Command(c) if c == "infty");
        let target = if infinite {
            let minus = self.is('-');
            if signed {
                self.bump();
            }
            self.bump();
            if minus { Target::MinusInfinity } else { Target::PlusInfinity }
        } else {
            Target::Finite(Box::new(self.sum()?))
        };
        if self.is('^') {
            return refuse("latex::limit", "a limit from one side", self.span(), "limits are taken along the motion");
        }
        self.expect('}')?;
        let body = self.sum()?;
        Ok(Node { span: start..body.span.end, kind: NodeKind::Limit(Box::new(body), target) })
    }

    // ---- sums and products ---------------------------------------------------------------------------------------

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

    /// At `-` behind a sign: `a+-b` is a − b. Two other signs are hard to tell from one on paper.
    fn second_sign(&mut self, first: Sign) -> Parsed<Sign> {
        let span = self.span();
        if first == Sign::Plus {
            self.bump();
            return Ok(Sign::Minus);
        }
        refuse(
            "latex::unexpected",
            "two signs stand side by side",
            span,
            "put parentheses around the term with its sign",
        )
    }

    fn sum(&mut self) -> Parsed<Node> {
        self.deeper(|p| {
            let start = p.span().start;
            let first = p.sign();
            let term = p.term()?;
            let mut terms = vec![(first.unwrap_or(Sign::Plus), term)];
            while let Some(mut sign) = p.sign() {
                if p.is('-') {
                    sign = p.second_sign(sign)?;
                }
                let from = p.at;
                let term = p.term()?;
                p.bar_is_clear(from, terms.iter().map(|(_, n)| n))?;
                terms.push((sign, term));
            }
            match (first, terms.len(), terms.pop()) {
                (None, 1, Some((_, only))) => Ok(only),
                (_, _, Some(last)) => {
                    terms.push(last);
                    Ok(p.node(NodeKind::Sum(terms), start))
                }
                (_, _, None) => refuse("latex::unexpected", "a term is expected", p.span(), ""),
            }
        })
    }

    /// Refuses `\cdot` and `\times` behind something whose end cannot be seen.
    fn joint_is_clear(&mut self) -> Parsed<()> {
        let is_gradient = matches!(self.open_here(), Some(Open::Gradient));
        let before_vector = is_gradient && (self.is_command("times") || self.begins_vector_after_joint());
        let hint = match self.open_here() {
            Some(Open::Slash) => r"write `\frac{}{}`, or parentheses around the quotient",
            Some(Open::Operator { .. }) => r"put what is derived into parentheses: `\frac{d}{dt}(…)`",
            // `\nabla\phi\times{\bf E}`: a number and a vector have no such product.
            Some(Open::Gradient) if !before_vector => r"put what is derived into parentheses: `(\nabla\phi)\cdot…`",
            Some(Open::Function { steady: true, .. }) => "put the argument of the function into parentheses",
            _ => return Ok(()),
        };
        let message = format!("it is not clear what {} belongs to", self.shown());
        refuse("latex::ambiguous", message, self.span(), hint)
    }

    /// Whether a vector, by its name or as a gradient, stands behind the joint here.
    fn begins_vector_after_joint(&mut self) -> bool {
        let back = self.at;
        self.bump();
        let mut found = self.is_command("nabla");
        if let Ok(Some((name, _))) = self.single_name() {
            let sub = if self.eat('_') { self.subscript().ok() } else { None };
            found = self.scope.is_vector(&name, sub.as_deref());
        }
        self.at = back;
        found
    }

    /// Factors joined by `\cdot`; `\times` binds closer.
    fn term(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let first = self.crosses()?;
        if self.is('*') {
            let hint = r"write `\cdot`, or nothing";
            return refuse("latex::unexpected", "`*` is not a product here", self.span(), hint);
        }
        if !self.is_command("cdot") {
            return Ok(first);
        }
        let mut parts = vec![first];
        while self.is_command("cdot") {
            self.joint_is_clear()?;
            self.bump();
            let from = self.at;
            let part = self.crosses()?;
            self.bar_is_clear(from, &parts)?;
            parts.push(part);
        }
        Ok(self.node(NodeKind::Dot(parts), start))
    }

    fn crosses(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let mut left = self.product()?;
        let mut count = 0;
        while self.is_command("times") {
            count += 1;
            if count > DEEPEST {
                let hint = r"write `\cdot`, or nothing";
                return refuse("latex::too-deep", "too many factors are joined by `\\times`", self.span(), hint);
            }
            self.joint_is_clear()?;
            self.bump();
            let from = self.at;
            let right = Box::new(self.product()?);
            self.bar_is_clear(from, [&left])?;
            left = self.node(NodeKind::Cross { left: Box::new(left), right, bracket: false }, start);
        }
        Ok(left)
    }

    /// Refuses a factor behind something whose end cannot be seen.
    fn end_is_clear(&mut self) -> Parsed<()> {
        if self.open_here().is_none() {
            return Ok(());
        }
        let before_vector = self.begins_vector()?;
        let Some(open) = self.open_here() else { return Ok(()) };
        let span = self.span();
        match open {
            Open::Slash => {
                let hint = r"write `\frac{}{}`, or parentheses around the denominator";
                refuse("latex::ambiguous", "it is not clear what belongs to the denominator", span, hint)
            }
            Open::Operator { .. } | Open::Gradient => {
                let clear = !matches!(open, Open::Operator { clear: false });
                // `\frac{d}{dt}x(t)\frac{d}{dt}y(t)`: what is derived shows its variable, and another derivative follows.
                let bracket = usize::from(self.is('('));
                if clear && self.begins_derivative_after(bracket) {
                    return Ok(());
                }
                let hint = r"put what is derived into parentheses: `\frac{d}{dt}(…)`";
                refuse("latex::ambiguous", "it is not clear how far the derivative reaches", span, hint)
            }
            Open::Function { name, .. } => {
                let complete = matches!(open, Open::Function { steady: false, .. });
                if before_vector || self.begins_function() || complete && (self.is_spaced() || self.begins_rate()) {
                    return Ok(());
                }
                let message = format!("it is not clear where the argument of `{}` ends", function::spelled(name));
                let hint = format!("put the argument into parentheses: `{}(…)`", function::spelled(name));
                refuse("latex::ambiguous", message, span, hint)
            }
        }
    }

    /// Juxtaposed factors, at most one slash among them.
    fn product(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let mut factors: Vec<Node> = Vec::new();
        while self.begins_factor() {
            if let Kind::Command(c) = self.kind()
                && feature::of_command(c).is_some()
            {
                return self.unsupported(c);
            }
            if !factors.is_empty() {
                self.end_is_clear()?;
            }
            let spaced = self.is_spaced();
            let Some(factor) = self.factor()? else { break };
            let mut factor = self.with_times(factor)?;
            if self.is_bar_of_time() {
                self.end_is_clear()?;
                self.bump();
                let start = factor.span.start;
                factor = self.at_bar(factor, start)?;
                factor = self.with_times(factor)?;
                self.bar = Some((self.at, self.depth));
                self.bar_is_clear(0, &factors)?;
            }
            if let Some(last) = factors.last() {
                side_by_side(last, &factor)?;
                if !spaced {
                    Self::is_no_operator(last, &factor)?;
                    self.is_no_place(last, &factor)?;
                }
            }
            // `{ab}c` is printed as three factors.
            match factor.kind {
                NodeKind::Product(inner) => factors.extend(inner),
                _ => factors.push(factor),
            }
        }
        if factors.is_empty() {
            // A factor that cannot begin here may have more to say about why.
            self.factor()?;
            let hint = if matches!(self.kind(), Kind::End) { "the formula stops too early" } else { "" };
            let message = format!("{} stands where a factor is expected", self.shown());
            return refuse("latex::unexpected", message, self.span(), hint);
        }
        let numerator = match (factors.len(), factors.pop()) {
            (1, Some(only)) => only,
            (_, last) => {
                factors.extend(last);
                self.node(NodeKind::Product(factors), start)
            }
        };
        if !self.is('/') {
            return Ok(numerator);
        }
        let slash = self.span();
        if let Some(open) = self.open_here() {
            let message = match open {
                Open::Slash => "two `/` in one term".to_owned(),
                Open::Operator { .. } | Open::Gradient => "it is not clear how far the derivative reaches".to_owned(),
                Open::Function { name, .. } => {
                    format!("does `/` divide `{}` or its argument?", function::spelled(name))
                }
            };
            return refuse("latex::ambiguous", message, slash, r"write `\frac{}{}`, or parentheses");
        }
        self.bump();
        let Some(denominator) = self.factor()? else {
            return refuse("latex::unexpected", "nothing stands behind `/`", slash, "");
        };
        let denominator = self.tight_denominator(&numerator, denominator)?;
        self.open = Some((self.at, Open::Slash));
        if self.begins_factor() || self.is('/') {
            let end = self.span().end;
            let hint = r"write `\frac{}{}`, or parentheses around the denominator";
            let span = denominator.span.start..end;
            return refuse("latex::ambiguous", "it is not clear what belongs to the denominator", span, hint);
        }
        let kind = NodeKind::Quotient { top: Box::new(numerator), bottom: Box::new(denominator), slash: true };
        Ok(self.node(kind, start))
    }
}

/// A decimal number, exactly.
fn decimal(text: &str) -> Rational {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = format!("{whole}{fraction}");
    let numerator = digits.parse::<dashu_int::IBig>().unwrap_or(dashu_int::IBig::ZERO);
    let denominator = dashu_int::UBig::from(10u8).pow(fraction.len());
    Rational::from_parts(numerator, denominator)
}
