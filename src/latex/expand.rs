//! Commands that are short for others are written out, and scripts are brought into one form.
//!
//! **In:** tokens whose brackets are balanced. **Out:** tokens of the formula language: no commands of layout and of packages
//! ([`macros`](super::macros)), `\frac{a}{b}` for `{a\over b}`, `x'^{2}` for `x^{\prime2}`, `x^{2}` for `x²`, bars that know their side.
//!
//! **Guaranteed:** what comes out prints what came in, and is at most a few times as long; places are those of the text.

use std::ops::Range;

use super::alike::{double_bars, primes, styles_under_dots, transposes, without_empty_braces};
use super::lexer::{Kind, Token, tokens};
use super::macros::{self, Macro};
use super::name;
use super::refusal::{DEEPEST, Parsed, refuse};
use super::unicode;

/// The tokens with all that is short for others written out.
pub(super) fn written_out(tokens: Vec<Token>) -> Parsed<Vec<Token>> {
    let tokens = without_empty_braces(tokens)?;
    let is_styled = |t: &Token| matches!(&t.kind, Kind::Command(c) if name::style(c).is_some());
    let tokens = if tokens.iter().any(|t| is_short(t) || is_styled(t)) { Expansion::of(&tokens)? } else { tokens };
    let tokens = double_bars(styles_under_dots(tokens))?;
    Ok(primes(transposes(tokens)))
}

/// Whether a token is short for others.
fn is_short(token: &Token) -> bool {
    match &token.kind {
        Kind::Command(c) => {
            !c.is_ascii()
                || macros::find(c).is_some()
                || matches!(
                    c.as_str(),
                    "over"
                        | "choose"
                        | "atop"
                        | "dv"
                        | "odv"
                        | "derivative"
                        | "pdv"
                        | "partialderivative"
                        | "fdv"
                        | "qty"
                        | "quantity"
                        | "eval"
                        | "evaluated"
                        | "overset"
                        | "underset"
                        | "stackrel"
                        | "num"
                        | "SI"
                        | "si"
                        | "unit"
                        | "ang"
                        | "div"
                        | "mqty"
                        | "matrixquantity"
                )
        }
        _ => false,
    }
}

/// The tokens of a text, all at one place.
fn placed(text: &str, span: &Range<usize>) -> Vec<Token> {
    // The texts are those of the tables, and are read without problems.
    let read = tokens(text).unwrap_or_default();
    let inside = read.into_iter().filter(|t| t.kind != Kind::End);
    inside.map(|t| Token { kind: t.kind, span: span.clone() }).collect()
}

pub(super) fn sign(c: char, span: &Range<usize>) -> Token {
    Token { kind: Kind::Sign(c), span: span.clone() }
}

struct Expansion<'a> {
    tokens: &'a [Token],
    /// Where a brace that opens is closed.
    closing: Vec<usize>,
}

impl<'a> Expansion<'a> {
    fn of(tokens: &'a [Token]) -> Parsed<Vec<Token>> {
        let mut closing = vec![0; tokens.len()];
        let mut open = Vec::new();
        for (i, token) in tokens.iter().enumerate() {
            match token.kind {
                Kind::Sign('{') => open.push(i),
                Kind::Sign('}') => {
                    if let Some(o) = open.pop() {
                        closing[o] = i;
                    }
                }
                _ => {}
            }
        }
        let mut out = Vec::with_capacity(tokens.len());
        Expansion { tokens, closing }.region(0..tokens.len(), 0, &mut out)?;
        Ok(out)
    }

    fn kind(&self, at: usize) -> Option<&Kind> {
        self.tokens.get(at).map(|t| &t.kind)
    }

    fn is(&self, at: usize, c: char) -> bool {
        self.kind(at) == Some(&Kind::Sign(c))
    }

    /// Writes out a range.
    fn region(&self, range: Range<usize>, depth: usize, out: &mut Vec<Token>) -> Parsed<()> {
        let mut at = range.start;
        if depth > DEEPEST {
            let span = self.tokens[at.min(self.tokens.len() - 1)].span.clone();
            return refuse("latex::too-deep", "the nesting is too deep", span, "use a declared abbreviation");
        }
        while at < range.end {
            let token = &self.tokens[at];
            match &token.kind {
                Kind::Sign('{') => {
                    let close = self.closing[at];
                    out.push(token.clone());
                    self.group(at + 1..close, depth + 1, out)?;
                    out.push(self.tokens[close].clone());
                    at = close + 1;
                }
                Kind::Command(c) if name::style(c).is_some() && self.lowered(at).is_some() => {
                    // `\vec{r_1}` is `\vec{r}_1`: one name with its label.
                    let (script, close) = self.lowered(at).unwrap_or((at, at));
                    out.push(token.clone());
                    out.push(self.tokens[at + 1].clone());
                    self.region(at + 2..script, depth + 1, out)?;
                    out.push(self.tokens[close].clone());
                    self.region(script..close, depth + 1, out)?;
                    at = close + 1;
                }
                Kind::Command(c) if name::style(c).is_some_and(name::marks_tensor) && self.zero(at).is_some() => {
                    // `\mathbf 0`: nothing, of any shape.
                    let (zero, after) = self.zero(at).unwrap_or((at, at + 1));
                    out.push(self.tokens[zero].clone());
                    at = after;
                }
                Kind::Command(c) if is_short(token) => at = self.short(c, at, range.end, depth, out)?,
                _ => {
                    out.push(token.clone());
                    at += 1;
                }
            }
        }
        Ok(())
    }

    /// The inside of braces: what `\over` divides is a fraction.
    fn group(&self, range: Range<usize>, depth: usize, out: &mut Vec<Token>) -> Parsed<()> {
        let mut at = range.start;
        let mut over = None;
        while at < range.end {
            let divides = matches!(&self.tokens[at].kind, Kind::Command(c) if matches!(c.as_str(), "over" | "choose"));
            if self.is(at, '{') {
                at = self.closing[at];
            } else if divides && over.replace(at).is_some() {
                let message = "two fractions in one pair of braces";
                return refuse("latex::ambiguous", message, self.tokens[at].span.clone(), "use braces");
            }
            at += 1;
        }
        let Some(over) = over else { return self.region(range, depth, out) };
        let span = &self.tokens[over].span;
        let choose = matches!(self.kind(over), Some(Kind::Command(c)) if c == "choose");
        let command = Kind::Command(if choose { "binom" } else { "frac" }.to_owned());
        let begin = self.tokens[range.start].span.start..self.tokens[range.start].span.start;
        out.push(Token { kind: command, span: begin.clone() });
        out.push(sign('{', &begin));
        self.region(range.start..over, depth, out)?;
        out.push(sign('}', span));
        out.push(sign('{', span));
        self.region(over + 1..range.end, depth, out)?;
        let end = self.tokens[range.end].span.start;
        out.push(sign('}', &(end..end)));
        Ok(())
    }

    /// At a style of vectors over a zero: where that stands, and what follows.
    fn zero(&self, at: usize) -> Option<(usize, usize)> {
        let is_zero = |at: usize| matches!(self.kind(at), Some(Kind::Number(n)) if n == "0");
        match self.is(at + 1, '{') {
            true => (is_zero(at + 2) && self.is(at + 3, '}')).then_some((at + 2, at + 4)),
            false => is_zero(at + 1).then_some((at + 1, at + 2)),
        }
    }

    /// At an accent or a style over one name with a subscript: where the subscript begins, and where the braces close.
    fn lowered(&self, at: usize) -> Option<(usize, usize)> {
        let upright =
            matches!(self.kind(at), Some(Kind::Command(c)) if name::style(c) == Some("rm") || name::is_switch(c));
        if upright || !self.is(at + 1, '{') {
            return None;
        }
        let close = self.closing[at + 1];
        let base = match self.kind(at + 2)? {
            Kind::Letter(_) => at + 3,
            Kind::Command(c) if name::is_letter_command(c) => at + 3,
            Kind::Command(c) if name::style(c).is_some() && self.is(at + 3, '{') => self.closing[at + 3] + 1,
            _ => return None,
        };
        let end = match self.is(base + 1, '{') {
            true => self.closing[base + 1] + 1,
            false => base + 2,
        };
        // `\vec{r_1'}`: the prime is of the name.
        let primes = (end..close).all(|at| self.is(at, '\''));
        (self.is(base, '_') && end <= close && primes && base + 1 < close).then_some((base, close))
    }

    /// One argument of a command as TeX takes it: its tokens, and where it ends.
    fn argument(&self, at: usize, end: usize) -> Parsed<(Range<usize>, usize)> {
        let span = self.tokens[at.min(self.tokens.len() - 1)].span.clone();
        match self.kind(at).filter(|_| at < end) {
            Some(Kind::Sign('{')) => Ok((at + 1..self.closing[at], self.closing[at] + 1)),
            Some(Kind::Number(n)) if n.len() > 1 => {
                refuse("latex::ambiguous", "LaTeX takes only the first digit", span, "use braces")
            }
            Some(Kind::Letter(_) | Kind::Number(_) | Kind::Command(_)) => Ok((at..at + 1, at + 1)),
            Some(Kind::Sign('+' | '-' | '=' | '<' | '>')) => Ok((at..at + 1, at + 1)),
            _ => refuse("latex::unexpected", "a command has no argument here", span, "use braces"),
        }
    }

    /// What stands in square brackets here, and where that ends.
    fn option(&self, at: usize, end: usize) -> Option<(Range<usize>, usize)> {
        if !self.is(at, '[') {
            return None;
        }
        let mut i = at + 1;
        while i < end && !self.is(i, ']') {
            i = if self.is(i, '{') { self.closing[i] + 1 } else { i + 1 };
        }
        (i < end).then_some((at + 1..i, i + 1))
    }

    /// Behind a command, a star.
    fn star(&self, at: usize) -> usize {
        at + usize::from(self.is(at, '*'))
    }

    /// At something that is short for others: writes it out, and says where it ends.
    fn short(&self, c: &str, at: usize, end: usize, depth: usize, out: &mut Vec<Token>) -> Parsed<usize> {
        if !c.is_ascii() {
            return self.unicode(c, at, end, out);
        }
        match c {
            "over" | "choose" | "atop" => {
                let message = format!("`\\{c}` without braces around what it divides");
                refuse("latex::ambiguous", message, self.tokens[at].span.clone(), r"write `\frac{…}{…}`")
            }
            "dv" | "odv" | "derivative" => self.derivative((r"\mathrm{d}", 2), at, end, depth, out),
            "pdv" | "partialderivative" => self.derivative((r"\partial ", 3), at, end, depth, out),
            "fdv" => self.derivative((r"\delta ", 2), at, end, depth, out),
            "qty" | "quantity" if !self.is(at + 1, '{') => Ok(self.star(at + 1)),
            "qty" | "quantity" | "SI" if self.is(self.closing[at + 1] + 1, '{') || c == "SI" => {
                self.quantity(at, end, out)
            }
            "qty" | "quantity" => {
                let all = Macro { name: "qty", arguments: 1, may_lack: false, prints: r"\left\{#1\right\}" };
                self.template(&all, at, end, depth, out)
            }
            "num" | "ang" | "si" | "unit" => self.quantity(at, end, out),
            "eval" | "evaluated" => {
                let all = Macro { name: "eval", arguments: 1, may_lack: false, prints: r"\left.#1\right|" };
                self.template(&all, at, end, depth, out)
            }
            "mqty" | "matrixquantity" => {
                // `\mqty(a&b\\c&d)`: the parentheses are those of the matrix.
                let inside =
                    Macro { name: "mqty", arguments: 1, may_lack: false, prints: r"\begin{matrix}#1\end{matrix}" };
                if self.is(at + 1, '{') {
                    return self.template(&inside, at, end, depth, out);
                }
                let close = (at + 1..end).find(|&i| self.is(i, ')'));
                let Some(close) = close.filter(|_| self.is(at + 1, '(')) else {
                    let span = self.tokens[at].span.clone();
                    return refuse("latex::unexpected", "a matrix has no entries here", span, "use `pmatrix`");
                };
                let span = self.tokens[at].span.clone();
                out.extend(placed(r"\begin{pmatrix}", &span));
                self.region(at + 2..close, depth + 1, out)?;
                out.extend(placed(r"\end{pmatrix}", &self.tokens[close].span));
                Ok(close + 1)
            }
            "overset" | "underset" | "stackrel" => self.above(c, at, end, depth, out),
            "div" => {
                let clear = !out
                    .last()
                    .is_some_and(|t| matches!(t.kind, Kind::Letter(_) | Kind::Number(_) | Kind::Sign(')' | ']' | '}')));
                if !clear {
                    let span = self.tokens[at].span.clone();
                    let hint = r"write `\nabla\cdot`, or a fraction";
                    return refuse("latex::ambiguous", "a divergence, or a quotient?", span, hint);
                }
                let all = Macro { name: "div", arguments: 1, may_lack: true, prints: r"\nabla\cdot #1" };
                self.template(&all, at, end, depth, out)
            }
            _ => match macros::find(c) {
                Some(found) => self.template(found, at, end, depth, out),
                None => {
                    out.push(self.tokens[at].clone());
                    Ok(at + 1)
                }
            },
        }
    }

    /// `\overset{!}{=}` and the like: a relation with a remark.
    fn above(&self, c: &str, at: usize, end: usize, depth: usize, out: &mut Vec<Token>) -> Parsed<usize> {
        let (_, next) = self.argument(at + 1, end)?;
        let (base, next) = self.argument(next, end)?;
        let relation = matches!(self.tokens[base.clone()], [Token { kind: Kind::Sign('=' | '<' | '>'), .. }])
            || matches!(&self.tokens[base.clone()], [Token { kind: Kind::Command(c), .. }] if super::parse::is_relation(c));
        if !relation {
            let span = self.tokens[at].span.clone();
            let message = format!("`\\{c}` above or below something that is no relation");
            return refuse("latex::unsupported", message, span, "give it a name of its own");
        }
        self.region(base, depth + 1, out)?;
        Ok(next)
    }

    /// A command with its arguments, as the table says what it prints.
    fn template(&self, of: &Macro, at: usize, end: usize, depth: usize, out: &mut Vec<Token>) -> Parsed<usize> {
        let mut next = self.star(at + 1);
        let mut power = None;
        if macros::OPTIONS.contains(&of.name) {
            next = self.option(next, end).map_or(next, |(_, next)| next);
        } else if matches!(of.name, "dd" | "differential")
            && let Some((inside, behind)) = self.option(next, end)
        {
            power = Some(inside);
            next = behind;
        }
        let mut arguments = Vec::new();
        for n in 0..of.arguments {
            if n == 0 && of.may_lack && !self.is(next, '{') {
                arguments.push(next..next);
                continue;
            }
            let (inside, behind) = self.argument(next, end)?;
            arguments.push(inside);
            next = behind;
        }
        let whole = self.tokens[at].span.start..self.tokens[next - 1].span.end;
        if let Some(power) = power {
            let span = self.tokens[power.start.min(self.tokens.len() - 1)].span.clone();
            let hint = "write out the differentials";
            return refuse("latex::unsupported", "a differential of a volume", span, hint);
        }
        for (i, piece) in of.prints.split('#').enumerate() {
            let text = if i == 0 { piece } else { &piece[1..] };
            if i > 0 {
                let number = piece.as_bytes().first().map_or(0, |b| usize::from(b.saturating_sub(b'1')));
                if let Some(argument) = arguments.get(number) {
                    self.group(argument.clone(), depth + 1, out)?;
                }
            }
            let begin = if i == 0 { whole.start..whole.start } else { whole.end..whole.end };
            out.extend(placed(text, &begin));
        }
        if macros::REMARKED.contains(&of.name) {
            while self.is(next, '_') || self.is(next, '^') {
                next = self.argument(next + 1, end)?.1;
            }
        }
        Ok(next)
    }

    /// `\dv{f}{x}`, `\pdv[2]{f}{x}`, `\pdv{f}{x}{y}`, `\dv{x}`: a derivative in Leibniz' notation.
    fn derivative(
        &self,
        (d, most): (&str, usize),
        at: usize,
        end: usize,
        depth: usize,
        out: &mut Vec<Token>,
    ) -> Parsed<usize> {
        let mut next = self.star(at + 1);
        let order = self.option(next, end);
        if let Some((_, behind)) = order {
            next = behind;
        }
        let mut arguments = Vec::new();
        while arguments.len() < most && (arguments.is_empty() || self.is(next, '{')) {
            let (inside, behind) = self.argument(next, end)?;
            arguments.push(inside);
            next = behind;
        }
        let span = self.tokens[at].span.start..self.tokens[next - 1].span.end;
        let (begin, last) = (span.start..span.start, span.end..span.end);
        let power = |out: &mut Vec<Token>| {
            let order =
                order.as_ref().map(|(inside, _)| self.tokens[inside.clone()].to_vec()).filter(|o| !o.is_empty());
            if let Some(order) = order {
                out.push(sign('^', &begin));
                out.push(sign('{', &begin));
                out.extend(order);
                out.push(sign('}', &begin));
            }
        };
        let by = if arguments.len() == 1 { &arguments[..] } else { &arguments[1..] };
        out.extend(placed(&format!(r"\frac{{{d}"), &begin));
        if by.len() == 2 {
            out.extend(placed("^{2}", &begin));
        }
        power(out);
        if arguments.len() > 1 {
            self.group(arguments[0].clone(), depth + 1, out)?;
        }
        out.extend(placed("}{", &begin));
        for by in by {
            out.extend(placed(d, &begin));
            self.group(by.clone(), depth + 1, out)?;
        }
        power(out);
        out.push(sign('}', &last));
        Ok(next)
    }

    /// `\num{1.2e3}`, `\SI{3}{\metre}`, `\qty{3}{\metre}`, `\ang{30}`: a number, and its unit in upright letters.
    fn quantity(&self, at: usize, end: usize, out: &mut Vec<Token>) -> Parsed<usize> {
        let command = match self.kind(at) {
            Some(Kind::Command(c)) => c.as_str(),
            _ => "",
        };
        let span = self.tokens[at].span.clone();
        let mut next = self.option(at + 1, end).map_or(at + 1, |(_, next)| next);
        if !matches!(command, "si" | "unit") {
            let (number, behind) = self.argument(next, end)?;
            next = behind;
            self.decimal(number, out)?;
            if command == "ang" {
                out.extend(placed(r"^\circ", &span));
            }
        }
        if matches!(command, "num" | "ang") {
            return Ok(next);
        }
        let (unit, behind) = self.argument(next, end)?;
        let mut text = String::new();
        for token in &self.tokens[unit] {
            let part = match &token.kind {
                Kind::Letter(c) => Some(c.to_string()),
                Kind::Number(n) => Some(n.clone()),
                Kind::Sign('.') => Some(r"\cdot ".to_owned()),
                Kind::Sign(c @ ('/' | '^' | '{' | '}' | '-')) => Some(c.to_string()),
                Kind::Command(c) => match c.as_str() {
                    "per" => Some("/".to_owned()),
                    "squared" => Some("^2".to_owned()),
                    "cubed" => Some("^3".to_owned()),
                    "square" | "cubic" => None,
                    c => macros::unit(c).map(str::to_owned),
                },
                _ => None,
            };
            let Some(part) = part else {
                let hint = r"write the unit in upright letters, `3\,\mathrm{m/s}`";
                return refuse("latex::unsupported", "this unit is not read", token.span.clone(), hint);
            };
            text.push_str(&part);
        }
        if text.matches('/').count() > 1 {
            let hint = r"write the unit in upright letters, with parentheses below: `3\,\mathrm{m/(s\,K)}`";
            return refuse("latex::ambiguous", "several units below", span, hint);
        }
        out.extend(placed(&format!(r"\mathrm{{{text}}}"), &span));
        Ok(behind)
    }

    /// A number of siunitx: digits, perhaps a sign, and `e` or `d` before a power of ten.
    fn decimal(&self, range: Range<usize>, out: &mut Vec<Token>) -> Parsed<()> {
        let mut rest = self.tokens[range.clone()].iter().peekable();
        let bad = |span: Range<usize>| {
            refuse(
                "latex::unsupported",
                "this number is not read",
                span,
                r"write it as it is printed, `1.2\times10^{3}`",
            )
        };
        let span = self.tokens[range.start.min(self.tokens.len() - 1)].span.clone();
        if let Some(minus) = rest.next_if(|t| t.kind == Kind::Sign('-')) {
            out.push(minus.clone());
        }
        match rest.next() {
            Some(number @ Token { kind: Kind::Number(_), .. }) => out.push(number.clone()),
            _ => return bad(span),
        }
        if rest.next_if(|t| matches!(t.kind, Kind::Letter('e' | 'E' | 'd'))).is_some() {
            out.extend(placed(r"\times10^{", &span));
            out.extend(rest.next_if(|t| t.kind == Kind::Sign('-')).cloned());
            match rest.next() {
                Some(number @ Token { kind: Kind::Number(n), .. }) if !n.contains('.') => out.push(number.clone()),
                _ => return bad(span),
            }
            out.push(sign('}', &span));
        }
        if rest.next().is_some() { bad(span) } else { Ok(()) }
    }

    /// At a character of Unicode that is several tokens, a script, or a mark on what stands before it.
    fn unicode(&self, c: &str, at: usize, end: usize, out: &mut Vec<Token>) -> Parsed<usize> {
        let span = &self.tokens[at].span;
        if let Some(accent) = unicode::accent(c) {
            let Some(Token { kind: Kind::Letter(_) | Kind::Command(_), .. }) = out.last() else {
                return refuse("latex::unexpected", "a mark that stands on no letter", span.clone(), r"write `\dot x`");
            };
            let begin = out.last().map_or(span.clone(), |t| t.span.clone());
            let place = out.len() - 1;
            out.splice(place..place, placed(&format!(r"\{accent}{{"), &begin));
            out.push(sign('}', span));
            return Ok(at + 1);
        }
        let Some((raised, _)) = unicode::script(c) else {
            let text = c.chars().next().and_then(unicode::spelled).unwrap_or_default();
            out.extend(placed(&text, span));
            return Ok(at + 1);
        };
        let mut text = String::new();
        let mut next = at;
        while let Some(Kind::Command(c)) = self.kind(next).filter(|_| next < end)
            && let Some((above, sign)) = unicode::script(c)
            && above == raised
        {
            text.push_str(sign);
            next += 1;
        }
        let mark = if raised { '^' } else { '_' };
        let place = span.start..self.tokens[next - 1].span.end;
        out.extend(placed(&format!("{mark}{{{text}}}"), &place));
        Ok(next)
    }
}
