//! Braces that LaTeX does not print are taken away.
//!
//! **In:** tokens whose brackets are balanced. **Out:** the same tokens, where braces are left only around what belongs to a
//! command (`\frac{a}{b}`, `\dot{x}`), to a script (`x^{2}`), to a switch of style (`{\bf m}`), or around what a script
//! belongs to (`{\dot x}_1`).
//!
//! **Guaranteed:** what follows sees what is printed. `x{\left(0\right)}` is x(0) and `\cos{2}{1}` is cos 21, here as on
//! paper; where the braces hide a term that is printed otherwise than it was meant, as in `2{a+b}`, the text is refused.

use std::ops::Range;

use super::lexer::{Kind, Token};
use super::name;
use super::refusal::{DEEPEST, Parsed, refuse};

/// Number of TeX arguments behind a command.
fn arity(command: &str) -> usize {
    match command {
        "frac" | "tfrac" | "dfrac" | "binom" | "tbinom" | "dbinom" => 2,
        "sqrt" | "dot" | "ddot" | "dddot" | "ddddot" | "mathop" | "begin" | "end" => 1,
        _ if name::style(command).is_some() && !name::is_switch(command) => 1,
        _ => 0,
    }
}

/// Whether a token joins terms or sides.
fn joins(kind: &Kind) -> bool {
    match kind {
        Kind::Sign(c) => matches!(c, '+' | '-' | '=' | '<' | '>'),
        Kind::Command(c) => matches!(
            c.as_str(),
            "pm" | "mp"
                | "ne"
                | "neq"
                | "equiv"
                | "le"
                | "leq"
                | "leqslant"
                | "lt"
                | "ge"
                | "geq"
                | "geqslant"
                | "gt"
                | "to"
                | "rightarrow"
        ),
        _ => false,
    }
}

fn opens(kind: &Kind) -> bool {
    matches!(kind, Kind::Sign('(' | '[' | '{') | Kind::OpenBar | Kind::OpenFence)
}

fn closes(kind: &Kind) -> bool {
    matches!(kind, Kind::Sign(')' | ']' | '}') | Kind::CloseBar)
}

fn separates(kind: &Kind) -> bool {
    matches!(kind, Kind::Sign(',' | ';' | '&' | '.') | Kind::Row)
}

/// `\vec\nabla`, `\boldsymbol{\nabla}` and `{\bf\nabla}` are ∇, which is a vector without a mark.
fn unmarked_nabla(tokens: Vec<Token>) -> Vec<Token> {
    let nabla = |t: Option<&Token>| matches!(t.map(|t| &t.kind), Some(Kind::Command(c)) if c == "nabla");
    if !tokens.iter().any(|t| nabla(Some(t))) {
        return tokens;
    }
    let sign = |t: Option<&Token>, c: char| t.is_some_and(|t| t.kind == Kind::Sign(c));
    let marks = |t: &Token, switch: bool| match &t.kind {
        Kind::Command(c) => name::is_switch(c) == switch && name::style(c).is_some_and(name::marks_tensor),
        _ => false,
    };
    let mut out = Vec::with_capacity(tokens.len());
    let mut rest = tokens.as_slice();
    while let [first, after @ ..] = rest {
        let (at, length) = match first.kind {
            Kind::Sign('{') if after.first().is_some_and(|t| marks(t, true)) => (2, 4),
            _ if marks(first, false) && sign(after.first(), '{') => (2, 4),
            _ if marks(first, false) => (1, 2),
            _ => (0, 1),
        };
        let marked = at > 0 && nabla(rest.get(at)) && (length == 2 || sign(rest.get(3), '}'));
        let (at, length) = if marked { (at, length) } else { (0, 1) };
        out.push(rest[at].clone());
        rest = &rest[length..];
    }
    out
}

/// The tokens without braces that are not printed.
pub(super) fn without_invisible_braces(tokens: Vec<Token>) -> Parsed<Vec<Token>> {
    let tokens = unmarked_nabla(tokens);
    if !tokens.iter().any(|t| t.kind == Kind::Sign('{')) && !numbers_touch(&tokens) {
        return Ok(tokens);
    }
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
    Braces { tokens: &tokens, closing: &closing }.region(0..tokens.len(), 0, false, &mut out)?;
    Ok(out)
}

fn numbers_touch(tokens: &[Token]) -> bool {
    let number = |t: &Token| matches!(t.kind, Kind::Number(_));
    tokens.windows(2).any(|w| number(&w[0]) && number(&w[1]))
}

struct Braces<'a> {
    tokens: &'a [Token],
    /// Where a brace that opens is closed.
    closing: &'a [usize],
}

impl Braces<'_> {
    /// Copies the tokens of a range; whether it ends in digits that belong to no command. In a subscript, the digits of
    /// `labels` stand for themselves.
    fn region(&self, range: Range<usize>, depth: usize, labels: bool, out: &mut Vec<Token>) -> Parsed<bool> {
        let (from, to) = (range.start, range.end);
        if depth > DEEPEST {
            let span = self.tokens[from.min(self.tokens.len() - 1)].span.clone();
            return refuse("latex::too-deep", "the nesting is too deep", span, "use a declared abbreviation");
        }
        let begin = out.len();
        let mut at = from;
        // TeX arguments that are still to come, and whether a script is.
        let (mut arguments, mut script) = (0usize, false);
        // Digits stood last, and belong to no command.
        let mut digits = false;
        while at < to {
            let token = &self.tokens[at];
            let taken = arguments > 0 || script;
            match &token.kind {
                Kind::Sign('{') => {
                    let close = self.closing[at];
                    let switch = matches!(&self.tokens[at + 1].kind, Kind::Command(c) if name::is_switch(c));
                    if taken || switch {
                        let lowered = script && out.last().is_some_and(|t| t.kind == Kind::Sign('_'));
                        out.push(token.clone());
                        self.region(at + 1..close, depth + 1, labels || lowered, out)?;
                        out.push(self.tokens[close].clone());
                        let array = close == at + 6 && self.is_array(at);
                        arguments = arguments.saturating_sub(usize::from(!script)) + usize::from(array);
                        (script, digits) = (false, false);
                    } else {
                        let before = out.len();
                        let trailing = self.group(at..close, begin, depth, labels, out)?;
                        if let Some(first) = out.get(before) {
                            let number = |t: &Token| matches!(t.kind, Kind::Number(_));
                            if digits && number(first) && !labels {
                                return two_numbers(out[before - 1].span.start..first.span.end);
                            }
                            digits = trailing;
                        }
                    }
                    at = close + 1;
                    continue;
                }
                Kind::Sign('[')
                    if arguments > 0
                        && matches!(out.last(), Some(Token { kind: Kind::Command(c), .. }) if c == "sqrt") =>
                {
                    // The degree of a root.
                    while at < to && self.tokens[at].kind != Kind::Sign(']') {
                        out.push(self.tokens[at].clone());
                        at += 1;
                    }
                    continue;
                }
                Kind::Sign(']') if arguments > 0 => {}
                Kind::Sign('^' | '_') => {
                    script = true;
                    digits = false;
                }
                Kind::Number(n) => {
                    if digits && !taken && !labels {
                        return two_numbers(out.last().map_or(0, |t| t.span.start)..token.span.end);
                    }
                    let eaten = if script { 1 } else { arguments.min(n.len()) };
                    arguments = if script { arguments } else { arguments - eaten };
                    digits = eaten < n.len() && (eaten == 0 || !n.contains('.'));
                    script = false;
                }
                Kind::Command(c) => {
                    arguments = arguments.saturating_sub(usize::from(!script)) + arity(c);
                    (script, digits) = (false, false);
                }
                _ => {
                    arguments = arguments.saturating_sub(usize::from(!script));
                    (script, digits) = (false, false);
                }
            }
            out.push(token.clone());
            at += 1;
        }
        if to < self.tokens.len() && (script || arguments > 0) {
            let message = "`}` stands where an argument is expected";
            return refuse("latex::unexpected", message, self.tokens[to].span.clone(), "");
        }
        Ok(digits)
    }

    /// Whether the braces at `at` hold the word `array`.
    fn is_array(&self, at: usize) -> bool {
        let letters = self.tokens[at + 1..at + 6].iter().map(|t| &t.kind);
        let begins = matches!(at.checked_sub(1).map(|i| &self.tokens[i].kind), Some(Kind::Command(c)) if c == "begin");
        begins && letters.eq("array".chars().map(Kind::Letter).collect::<Vec<_>>().iter())
    }

    /// A group that belongs to no command: its content, or, where a script belongs to all of it, the group.
    fn group(
        &self,
        braces: Range<usize>,
        begin: usize,
        depth: usize,
        labels: bool,
        out: &mut Vec<Token>,
    ) -> Parsed<bool> {
        let (open, close) = (braces.start, braces.end);
        let span = self.tokens[open].span.start..self.tokens[close].span.end;
        let raised = matches!(self.tokens[close + 1].kind, Kind::Sign('^' | '_' | '\''));
        if raised {
            out.push(self.tokens[open].clone());
        }
        let inner = out.len();
        let digits = self.region(open + 1..close, depth + 1, labels, out)?;
        if raised {
            self.base(close, inner, span, out)?;
            return Ok(false);
        }
        let (mut nested, mut bar) = (0usize, false);
        let (mut signed, mut joined) = (false, false);
        for (i, token) in out[inner..].iter().enumerate() {
            if token.kind == Kind::Sign('|') {
                bar = !bar;
            } else if opens(&token.kind) {
                nested += 1;
            } else if closes(&token.kind) {
                nested = nested.saturating_sub(1);
            } else if nested == 0 && !bar {
                joined |= joins(&token.kind);
                signed |= i == 0 && joins(&token.kind);
                if separates(&token.kind) {
                    let hint = "leave the braces out: LaTeX does not print them";
                    return refuse("latex::ambiguous", "a separator in braces", span, hint);
                }
            }
        }
        if !joined {
            return Ok(digits);
        }
        let relation = |k: &Kind| joins(k) && !is_sign(k);
        let plain_left = out[begin..inner]
            .last()
            .map(|t| &t.kind)
            .is_none_or(|k| opens(k) || separates(k) || relation(k) || (!signed && *k == Kind::Sign('+')));
        let right = self.tokens[close + 1..].iter().map(|t| &t.kind).find(|k| **k != Kind::Sign('{'));
        let plain_right = right.is_none_or(|k| closes(k) || separates(k) || joins(k) || matches!(k, Kind::End));
        if plain_left && plain_right {
            return Ok(digits);
        }
        let hint = "write parentheses: LaTeX does not print braces";
        refuse("latex::ambiguous", "a sum in braces", span, hint)
    }

    /// A group that a script or a prime follows. What is one piece in print loses its braces; what is a symbol with scripts
    /// keeps them, and the parser says whether it is clear.
    fn base(&self, close: usize, inner: usize, span: Range<usize>, out: &mut Vec<Token>) -> Parsed<()> {
        let content = &out[inner..];
        let bracketed = match content.first().map(|t| &t.kind) {
            Some(Kind::Sign('(' | '[')) => {
                let mut nested = 0usize;
                let whole = content.iter().position(|t| {
                    nested += usize::from(opens(&t.kind));
                    nested = nested.saturating_sub(usize::from(closes(&t.kind)));
                    nested == 0
                });
                Some(whole == content.len().checked_sub(1))
            }
            _ => None,
        };
        // `{\left.x\right|}_{t=0}`
        let fenced = content.first().is_some_and(|t| t.kind == Kind::OpenFence)
            && content.iter().position(|t| t.kind == Kind::CloseBar) == content.len().checked_sub(1);
        if content.len() <= 1 || bracketed == Some(true) || fenced {
            out.remove(inner - 1);
            return Ok(());
        }
        if bracketed == Some(false) || matches!(content[0].kind, Kind::Number(_) | Kind::Sign('.')) {
            let message = "it is not clear what the script belongs to";
            return refuse("latex::ambiguous", message, span, "put parentheses around what it belongs to");
        }
        out.push(self.tokens[close].clone());
        Ok(())
    }
}

fn is_sign(kind: &Kind) -> bool {
    match kind {
        Kind::Sign(c) => matches!(c, '+' | '-'),
        Kind::Command(c) => matches!(c.as_str(), "pm" | "mp"),
        _ => false,
    }
}

fn two_numbers<T>(span: Range<usize>) -> Parsed<T> {
    let hint = r"write `\cdot` between them";
    refuse("latex::ambiguous", "two numbers stand side by side", span, hint)
}
