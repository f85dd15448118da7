//! Symbols with what is attached to them: dots, scripts, and parentheses that may or may not be arguments.

use super::super::lexer::{Kind, Token};
use super::super::name::{NAMES, canonical};
use super::super::syntax::{Name, Node, NodeKind, SymbolNode};
use super::{Parsed, Parser, refuse};

/// What stands in the parentheses behind a symbol.
struct Content {
    /// Several parts, separated by commas.
    tuple: bool,
    /// Terms joined by signs.
    sum: bool,
    /// A sign before the first term.
    signed: bool,
    /// `\cdot` or `\times`.
    joined: bool,
    /// Something that depends on time, other than the time itself.
    moving: bool,
    /// The time, or a symbol of its name such as `t_0`.
    time: bool,
    /// A vector or a matrix.
    tensor: bool,
    /// Nothing but numbers.
    number: bool,
    /// Several factors with indices: `(w_jv_j)`.
    indexed: bool,
}

impl Parser<'_> {
    pub(super) fn symbol(&mut self, dots: u8) -> Parsed<Node> {
        let start = self.span().start;
        match self.single_name()? {
            Some((name, _)) => self.symbol_named(name, dots, start),
            None => {
                let message = format!("{} stands where a symbol is expected", self.shown());
                refuse("latex::unexpected", message, self.span(), "")
            }
        }
    }

    /// At `\dot` and its kin: one symbol, which may have its subscript under the dot.
    pub(super) fn dotted(&mut self, command: &str, start: usize) -> Parsed<Node> {
        let dots = command.bytes().take_while(|b| *b == b'd').count().min(4) as u8;
        self.bump();
        let span = self.span();
        if let Some((name, _)) = self.single_name()? {
            return self.symbol_named(name, dots, start);
        }
        let hint = r"for anything longer write `\frac{d}{dt}(…)`";
        if self.eat('{')
            && let Some((name, _)) = self.single_name()?
            && self.eat('_')
        {
            let sub = self.subscript()?;
            if self.eat('}') {
                if self.is('_') {
                    let message = "a second subscript";
                    return refuse("latex::double-script", message, self.span(), "put all indices into one subscript");
                }
                return self.scripted_symbol(name, dots, Some(sub), start);
            }
        }
        refuse("latex::dot", format!("`\\{command}` needs one symbol"), span, hint)
    }

    /// A symbol whose name was read: scripts, then what stands in parentheses behind it, if that belongs to it.
    pub(super) fn symbol_named(&mut self, name: Name, dots: u8, start: usize) -> Parsed<Node> {
        self.scripted_symbol(name, dots, None, start)
    }

    fn scripted_symbol(
        &mut self,
        name: Name,
        dots: u8,
        under: Option<Vec<super::super::syntax::SubItem>>,
        start: usize,
    ) -> Parsed<Node> {
        let (sub, sup, sup_first) = self.script_pair()?;
        let sub = under.or(sub);
        let mut symbol = SymbolNode { name, dots, sub, sup, sup_first, arguments: None, arguments_text: String::new() };
        if self.is('(')
            && let Some(close) = self.closing()
        {
            let text = canonical(&self.tokens[self.at + 1..close]);
            if self.scope.applies(&symbol.name, symbol.sub.as_deref(), &text)
                || self.is_instant(&symbol, start, close)?
            {
                self.bump();
                let outer = std::mem::replace(&mut self.bars, 0);
                let mut arguments = vec![self.sum()?];
                while self.eat(',') {
                    arguments.push(self.sum()?);
                }
                self.expect(')')?;
                self.bars = outer;
                symbol.arguments = Some(arguments);
                symbol.arguments_text = text;
            }
        }
        Ok(self.node(NodeKind::Symbol(symbol), start))
    }

    /// Whether the parentheses that end at `close` hold the time at which the symbol is taken; otherwise they are a factor.
    fn is_instant(&self, symbol: &SymbolNode, start: usize, close: usize) -> Parsed<bool> {
        let sub = symbol.sub.as_deref();
        if !self.scope.is_known(&symbol.name, sub) {
            // Said by name later.
            return Ok(false);
        }
        let inside = &self.tokens[self.at + 1..close];
        let content = self.content(inside);
        let span = start..self.tokens[close].span.end;
        let shown = &self.text[start..self.last_end()];
        let ambiguous = |message: String, hint: &str| refuse("latex::ambiguous", message, span.clone(), hint);
        if self.scope.is_moving(&symbol.name, sub) {
            if content.tuple {
                // A matrix before the components of a vector.
                if self.scope.is_matrix(&symbol.name, sub) {
                    return Ok(false);
                }
                let hint = r"a value is taken at one time; write `\cdot` for a product";
                return ambiguous(format!("`{shown}` is not declared with these arguments"), hint);
            }
            if content.sum {
                if content.time {
                    let hint = r"declare a symbol for the time, or write `\cdot` for a product";
                    return ambiguous(format!("is this `{shown}` at a time, or a product?"), hint);
                }
                return Ok(false);
            }
            if content.signed && !content.number && !content.time {
                return if content.moving {
                    Ok(false)
                } else {
                    ambiguous(format!("is this `{shown}` at a time, or a product?"), r"write `\cdot` for a product")
                };
            }
            if content.joined && content.tensor || content.indexed && content.moving {
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
        let message =
            format!("`{shown}` does not depend on time, so this is neither a value at a time nor a clear product");
        ambiguous(message, r"leave the parentheses out, or write `\cdot`")
    }

    fn content(&self, tokens: &[Token]) -> Content {
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
        };
        let mut names = 0;
        let mut lowered_names = 0;
        let mut depth = 0usize;
        let mut bar = false;
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
                Kind::Command(c) if NAMES.contains(&c.as_str()) => format!("\\{c}"),
                _ => continue,
            };
            let lowered = matches!(body.get(i + 1), Some(Token { kind: Kind::Sign('_'), .. }));
            names += 1;
            content.number = false;
            lowered_names += usize::from(lowered);
            let (moves, tensor) = self.scope.kinds_of(&base, lowered);
            content.moving |= moves;
            content.tensor |= tensor;
            content.time |= self.scope.time_name() == Some(base.as_str());
        }
        content.indexed = names > 1 && lowered_names == names;
        content
    }
}
