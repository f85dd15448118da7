//! Names, subscripts and superscripts.

use std::ops::Range;

use super::super::lexer::{Kind, Token};
use super::super::name::{self, NAMES, canonical};
use super::super::scope::Scope;
use super::super::syntax::{Name, SubItem, SymbolNode};
use super::{Parsed, Parser, refuse};
use diag::Problem;

/// The name of a symbol taken apart.
pub(crate) struct WrittenName {
    /// Base, style and primes.
    pub name: Name,
    /// Its subscript.
    pub sub: Vec<SubItem>,
    /// What stands in parentheses, in canonical spelling.
    pub arguments: Option<String>,
}

/// Reads a text that is nothing but a name; `None` where it is something else.
pub(crate) fn read_name(text: &str, scope: &Scope) -> Result<Option<WrittenName>, Problem> {
    let mut parser = Parser::new(text, scope).map_err(|mut p| p.swap_remove(0))?;
    parser.in_name = true;
    parser.whole_name().map_err(|p| *p)
}

/// Most letters of a name that is spelled in letters.
pub(super) const LONGEST_WORD: usize = 16;

impl Parser<'_> {
    fn whole_name(&mut self) -> Parsed<Option<WrittenName>> {
        if let Some((name, close)) = self.in_brackets() {
            self.at = close;
            self.bump();
            let sub = if self.eat('_') { self.subscript()? } else { Vec::new() };
            let arguments = self.arguments_of_name();
            return Ok((*self.kind() == Kind::End).then_some(WrittenName { name, sub, arguments }));
        }
        let difference = match self.kind() {
            Kind::Command(c) if name::is_difference(c) => self.difference()?,
            _ => None,
        };
        let name = match difference {
            Some(name) => Some(name),
            None => self.single_name()?.map(|(name, _)| name),
        };
        let Some(mut name) = name else { return Ok(None) };
        // `KE`: letters of one name.
        if let [c] = name.as_bytes()
            && c.is_ascii_alphabetic()
        {
            while let Kind::Letter(c) = *self.kind()
                && self.last_end() == self.span().start
            {
                name.push(c);
                self.bump();
            }
            if name.len() > LONGEST_WORD || name.len() > 1 && super::function::named(&name).is_some() {
                return Ok(None);
            }
            self.primes(&mut name);
        }
        let mut sub = if self.eat('_') { self.subscript()? } else { Vec::new() };
        self.primes(&mut name);
        if let Some((label, tokens)) = self.label_above() {
            self.at += tokens;
            name = format!("{name}^{label}");
            if sub.is_empty() && self.eat('_') {
                sub = self.subscript()?;
            }
        }
        let arguments = self.arguments_of_name();
        Ok((*self.kind() == Kind::End).then_some(WrittenName { name, sub, arguments }))
    }

    /// What stands in parentheses behind the name of a declaration.
    fn arguments_of_name(&mut self) -> Option<String> {
        let close = if self.is('(') { self.closing()? } else { return None };
        let arguments = canonical(&self.tokens[self.at + 1..close]);
        self.at = close;
        self.bump();
        Some(arguments)
    }

    /// One name: a letter, a Greek letter, a styled or braced one; with its primes. Leaves its place where there is none.
    pub(super) fn single_name(&mut self) -> Parsed<Option<(Name, Range<usize>)>> {
        let start = self.span().start;
        let difference = matches!(self.kind(), Kind::Command(c) if name::is_difference(c)) && self.is_difference()?;
        let name = match difference {
            true => self.difference()?,
            false => self.name_without_primes()?.map(|(name, _)| name),
        };
        let Some(mut name) = name else { return Ok(None) };
        self.primes(&mut name);
        Ok(Some((name, start..self.last_end())))
    }

    /// The same without primes behind it: what TeX takes for an argument without braces, in `\sqrt x'` or `x_i'`.
    pub(super) fn name_without_primes(&mut self) -> Parsed<Option<(Name, Range<usize>)>> {
        let start = self.span().start;
        let name = match self.kind().clone() {
            Kind::Sign('[') => match self.bracketed_name()? {
                Some((name, close)) => {
                    self.at = close;
                    self.bump();
                    name
                }
                None => return Ok(None),
            },
            Kind::Letter(_) if self.spelled_name()?.is_some() => {
                let name = self.spelled_name()?.unwrap_or_default();
                self.at += name.len();
                name
            }
            Kind::Letter(c) => {
                self.bump();
                c.to_string()
            }
            Kind::Command(c) if NAMES.contains(&c.as_str()) || c == "pi" && !self.is_pi() => {
                self.bump();
                format!("\\{c}")
            }
            Kind::Command(c) if !name::is_switch(&c) => {
                let Some(style) = name::style(&c) else { return Ok(None) };
                match self.styled(style, &c)? {
                    Some(inner) => inner,
                    None => return Ok(None),
                }
            }
            Kind::Sign('{') => {
                let back = self.at;
                match self.braced_word(None)? {
                    Some(inner) => inner,
                    None => {
                        self.at = back;
                        return Ok(None);
                    }
                }
            }
            _ => return Ok(None),
        };
        Ok(Some((name, start..self.last_end())))
    }

    /// `\Delta t`, whether it is declared or not; leaves its place where no name follows.
    fn difference(&mut self) -> Parsed<Option<Name>> {
        let Kind::Command(sign) = self.kind().clone() else { return Ok(None) };
        self.deeper(|p| {
            let back = p.at;
            p.bump();
            let of = match p.kind() {
                Kind::Letter(_) | Kind::Command(_) | Kind::Sign('{') => p.single_name()?,
                _ => None,
            };
            if of.is_none() {
                p.at = back;
            }
            Ok(of.map(|(of, _)| format!("{sign}:{of}")))
        })
    }

    /// Whether a declared name as `\Delta t` stands here.
    pub(super) fn is_difference(&mut self) -> Parsed<bool> {
        let (back, span) = (self.at, self.span());
        let Some(name) = self.difference()? else { return Ok(false) };
        let end = self.last_end();
        let raised = self.is('^') && self.prime().is_none();
        self.at = back;
        if !self.scope.declares(&name) {
            return Ok(false);
        }
        let (sign, of) = name::split(&name);
        let shown = name::to_latex(&name);
        if sign.is_some_and(|sign| self.scope.declares(&format!("\\{sign}"))) && self.scope.declares(of) {
            let message = format!("is `{shown}` a name, or a product?");
            return refuse("latex::ambiguous", message, span.start..end, "rename one of the two");
        }
        if sign == Some("Delta") && self.scope.has_space() && self.scope.is_field(of, None) {
            let message = format!("is `{shown}` a name, or the Laplacian?");
            return refuse("latex::ambiguous", message, span.start..end, r"write `\nabla^2`, or rename the difference");
        }
        if raised {
            let message = format!("`{shown}` to a power, or the difference of a power?");
            return refuse("latex::ambiguous", message, span.start..end, format!("write `({shown})^{{…}}`"));
        }
        Ok(true)
    }

    /// What stands here in square brackets as a name, and where they are closed: letters and their scripts, as in
    /// `[S]`, `[\mathrm{H}^+]`.
    fn in_brackets(&self) -> Option<(Name, usize)> {
        if !self.is('[') {
            return None;
        }
        let close = (self.at + 1..self.tokens.len()).find(|&i| self.tokens[i].kind == Kind::Sign(']'))?;
        let inside = &self.tokens[self.at + 1..close];
        let fits = |kind: &Kind| match kind {
            Kind::Letter(_) | Kind::Number(_) => true,
            Kind::Sign(c) => matches!(c, '{' | '}' | '_' | '^' | '+' | '-'),
            Kind::Command(c) => {
                matches!(c.as_str(), "mathrm" | "text" | "rm" | "+" | "-") || NAMES.contains(&c.as_str())
            }
            Kind::OpenBar | Kind::CloseBar | Kind::OpenFence | Kind::Row | Kind::End => false,
        };
        let begins =
            matches!(inside.first().map(|t| &t.kind), Some(Kind::Letter(_) | Kind::Command(_) | Kind::Sign('{')));
        // `A_12` is not printed as `A_{12}`, and braces are not part of a canonical name.
        let script = |kind: &Kind| matches!(kind, Kind::Sign('_' | '^'));
        let split = |kind: &Kind| matches!(kind, Kind::Number(n) if n.len() > 1);
        if inside.windows(2).any(|w| script(&w[0].kind) && split(&w[1].kind)) {
            return None;
        }
        let name = format!("{}:{}", name::AMOUNT, canonical(inside));
        (begins && inside.len() <= LONGEST_WORD && inside.iter().all(|t| fits(&t.kind))).then_some((name, close))
    }

    /// The same, where it is declared.
    pub(super) fn bracketed_name(&self) -> Parsed<Option<(Name, usize)>> {
        let Some((name, close)) = self.in_brackets().filter(|(name, _)| self.scope.declares(name)) else {
            return Ok(None);
        };
        let content = name::split(&name).1;
        let clash = match content.split_once(['_', '^']) {
            Some((base, _)) => self.scope.declares(base),
            None => self.scope.is_known(content, None),
        };
        if clash {
            let message = "is this a name, or something in brackets?";
            let span = self.span().start..self.tokens[close].span.end;
            return refuse("latex::ambiguous", message, span, "rename one of the two");
        }
        Ok(Some((name, close)))
    }

    /// A declared name of several letters that stands here, as `KE`.
    pub(super) fn spelled_name(&self) -> Parsed<Option<Name>> {
        if !self.scope.has_words() || self.in_subscript {
            return Ok(None);
        }
        let letters: String = (0..)
            .map_while(|i| match self.kind_after(i) {
                Kind::Letter(c) => Some(*c),
                _ => None,
            })
            .take(LONGEST_WORD)
            .collect();
        let Some(name) = self.scope.word(&letters) else { return Ok(None) };
        let end = self.tokens[self.at + name.len() - 1].span.end;
        let span = self.span().start..end;
        let apart = name.chars().all(|c| self.scope.declares(&c.to_string()));
        let across = (1..name.len()).any(|i| self.scope.word(&letters[i..]).is_some_and(|w| i + w.len() > name.len()));
        if apart || across {
            let message = format!("is `{name}` a name, or a product of letters?");
            return refuse(
                "latex::ambiguous",
                message,
                span,
                r"write `\mathrm{…}` for the name, `\cdot` for the product",
            );
        }
        Ok(Some(name.to_owned()))
    }

    /// A name behind the command of a style; leaves its place where there is none.
    fn styled(&mut self, style: &'static str, command: &str) -> Parsed<Option<Name>> {
        let back = self.at;
        self.bump();
        // In italics or upright it is π that is printed.
        let outer = self.in_name;
        self.in_name |= !matches!(style, "rm" | "it");
        let inner = self.deeper(|p| {
            if p.is('{') { p.braced_word(Some(command)) } else { Ok(p.name_without_primes()?.map(|(n, _)| n)) }
        });
        self.in_name = outer;
        let inner = inner?;
        if inner.is_none() {
            self.at = back;
        }
        Ok(inner.map(|inner| restyle(style, inner)))
    }

    /// `{…}` that contains nothing but one name, or a style switch and one name; behind a command for upright letters it may have several
    /// letters. Leaves its place otherwise.
    pub(super) fn braced_word(&mut self, command: Option<&str>) -> Parsed<Option<Name>> {
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
            let several = switch == Some("rm") || command.and_then(name::style) == Some("rm");
            let has_spaces = command.is_some_and(name::sets_words);
            let outer = p.in_name;
            p.in_name |= !matches!(switch, None | Some("rm" | "it"));
            let mut text = String::new();
            let read = loop {
                let before = p.last_end();
                match p.single_name() {
                    Ok(Some((name, span))) => {
                        let is_behind_space = has_spaces && !text.is_empty() && before < span.start;
                        text.extend(is_behind_space.then_some(' '));
                        text.push_str(&name);
                    }
                    Ok(None) => break Ok(()),
                    Err(problem) => break Err(problem),
                }
                if !several {
                    break Ok(());
                }
            };
            p.in_name = outer;
            read?;
            if text.is_empty() || !p.eat('}') {
                p.at = back;
                return Ok(None);
            }
            Ok(Some(match switch {
                Some(style) => restyle(style, text),
                None => text,
            }))
        })
    }

    /// A word in braces, such as the argument of `\operatorname`.
    pub(super) fn word(&mut self) -> Option<String> {
        let back = self.at;
        if !self.eat('{') {
            return None;
        }
        let mut word = String::new();
        loop {
            match self.kind().clone() {
                Kind::Letter(c) => word.push(c),
                Kind::Number(n) => word.push_str(&n),
                Kind::Sign('*') => word.push('*'),
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

    /// Position of the token that closes the parenthesis at the present place.
    pub(super) fn closing(&self) -> Option<usize> {
        self.closing_from(self.at)
    }

    /// The same for a parenthesis elsewhere.
    pub(super) fn closing_from(&self, at: usize) -> Option<usize> {
        let mut depth = 0usize;
        for (i, Token { kind, .. }) in self.tokens.iter().enumerate().skip(at) {
            match kind {
                Kind::Sign('(') => depth += 1,
                Kind::Sign(')') => {
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
}

fn restyle(style: &str, name: Name) -> Name {
    // What the style does not change in print: Greek letters in upright type, a Latin letter in italics.
    let base = name.trim_end_matches('\'');
    let latin = base.len() == 1 && base.bytes().all(|b| b.is_ascii_alphabetic());
    let small = base.strip_prefix('\\').is_some_and(|b| b.starts_with(|c: char| c.is_ascii_lowercase()));
    if style == "rm" && base.starts_with('\\') && !base.contains(':') || style == "it" && (latin || small) {
        return name;
    }
    // `{\bf {\bf m}}` is printed as `{\bf m}`. Accents and other styles are kept: `\bar{\bar z}` has two bars.
    if !name::is_accent(style) && name.starts_with(&format!("{style}:")) { name } else { format!("{style}:{name}") }
}

/// A symbol without anything attached to it.
pub(super) fn plain(name: Name) -> SymbolNode {
    SymbolNode {
        name,
        dots: 0,
        primed: false,
        sub: None,
        sup: None,
        sup_first: false,
        arguments: None,
        arguments_text: String::new(),
    }
}
