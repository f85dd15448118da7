//! Symbols with what is attached to them: dots, scripts, and parentheses that may or may not be arguments.

use std::collections::BTreeSet;

use super::super::lexer::Kind;
use super::super::name::canonical;
use super::super::syntax::{MOST_PRIMES, Name, Node, NodeKind, SubItem, SymbolNode};
use super::names::plain;
use super::{Parsed, Parser, refuse};
use expr::HIGHEST_ORDER;

/// On what a formula depends.
#[derive(Default)]
struct Variables {
    names: BTreeSet<Name>,
    /// Whether the time is printed in it: in a rate with dots, or where a function is taken.
    shows_time: bool,
    /// Whether something in it depends on what is not told by a name.
    is_unclear: bool,
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
            && let Some((mut name, _)) = self.single_name()?
            && (self.is('_') || self.label_of(&mut name))
        {
            let sub = if self.eat('_') { Some(self.subscript()?) } else { None };
            self.label_of(&mut name);
            if self.eat('}') {
                if sub.is_some() && self.is('_') {
                    let message = "a second subscript";
                    return refuse("latex::double-script", message, self.span(), "put all indices into one subscript");
                }
                return self.scripted_symbol(name, dots, sub, start);
            }
        }
        refuse("latex::dot", format!("`\\{command}` needs one symbol"), span, hint)
    }

    /// A symbol whose name was read: scripts, then what stands in parentheses behind it, if that belongs to it.
    pub(super) fn symbol_named(&mut self, name: Name, dots: u8, start: usize) -> Parsed<Node> {
        self.scripted_symbol(name, dots, None, start)
    }

    /// `y'` of a field of one coordinate is its derivative, and of a function y of x, unless it is declared. Where the independent variable is the time by name,
    /// too, rates have dots, and a prime makes another name; unless a text has double primes, and no name with a prime is declared.
    fn primed_rate(&self, name: &mut Name, dots: u8, sub: Option<&[SubItem]>) -> u8 {
        let base = name.trim_end_matches('\'');
        let primes = name.len() - base.len();
        if (1..=MOST_PRIMES).contains(&primes)
            && dots == 0
            && !self.scope.declares(name)
            && self.scope.is_of_one_coordinate(base, sub)
        {
            name.truncate(base.len());
            return primes as u8;
        }
        let lagrange = || self.double_primes && !self.scope.has_primes();
        if !(1..=MOST_PRIMES).contains(&primes) || dots > 0 || self.primes_are_rates().is_none() && !lagrange() {
            return dots;
        }
        if self.scope.declares(name) || !self.scope.is_moving(base, sub) {
            return dots;
        }
        name.truncate(base.len());
        primes as u8
    }

    /// The independent variable, where primes are derivatives by it: where it is not called t, T or τ.
    pub(super) fn primes_are_rates(&self) -> Option<Name> {
        let variable = self.scope.time_name()?;
        (self.scope.primes() || !variable.starts_with(['t', 'T']) && !variable.starts_with(r"\tau"))
            .then(|| variable.to_owned())
    }

    /// By what primes behind brackets, or behind a matrix, derive: by the independent variable where that is so for names; else by the one
    /// variable on which what stands there depends, the time only where it shows there: in a rate with dots, or in a function of it. A name
    /// alone in brackets may be another name.
    pub(super) fn derived_by_primes(&self, of: &Node) -> Option<Name> {
        let inside = match &of.kind {
            NodeKind::Group(inside, _) => Some(&**inside),
            NodeKind::Matrix(_) => None,
            _ => return None,
        };
        if let Some(by) = self.primes_are_rates().filter(|_| inside.is_some()) {
            return Some(by);
        }
        if inside.is_some_and(|node| matches!(&node.kind, NodeKind::Symbol(s) if s.arguments.is_none())) {
            return None;
        }
        let mut found = Variables::default();
        self.note_variables(of, &mut found);
        let time = self.scope.time_name();
        match found.names.pop_first() {
            Some(only) if found.names.is_empty() && !found.is_unclear => {
                (found.shows_time || time != Some(only.as_str())).then_some(only)
            }
            _ => None,
        }
    }

    fn note_variables(&self, node: &Node, found: &mut Variables) {
        if let NodeKind::Symbol(s) = &node.kind {
            match self.scope.variables(&s.name, s.sub.as_deref()) {
                Some(names) => {
                    let is_rate = s.dots > 0 && !s.primed || !self.scope.is_variable(&s.name, s.sub.as_deref());
                    found.shows_time |= is_rate && names.iter().any(|n| Some(n.as_str()) == self.scope.time_name());
                    found.names.extend(names);
                }
                None => found.is_unclear = true,
            }
        }
        node.children().into_iter().for_each(|child| self.note_variables(child, found));
    }

    /// `(uv)'`: the derivative of what stands in the brackets.
    pub(super) fn primed_group(&mut self, of: Node, by: Name) -> Parsed<Node> {
        let (start, span) = (of.span.start, self.span());
        let mut order = 0u8;
        while let Some(tokens) = self.prime() {
            self.at += tokens;
            order = order.saturating_add(1);
        }
        if usize::from(order) > MOST_PRIMES || self.is('^') || self.is('_') {
            let hint = r"write `\frac{d^n}{dx^n}(…)`, in parentheses before a power";
            return refuse("latex::ambiguous", "it is not clear what these primes are", span, hint);
        }
        let by = Box::new(self.node(NodeKind::Symbol(plain(by)), span.start));
        Ok(self.node(NodeKind::Derivative { of: Box::new(of), by, order, operator: true, upright: false }, start))
    }

    /// `^{(4)}` behind a field of one coordinate: the order of its derivative.
    fn order_in_parentheses(&mut self, name: &Name, dots: u8) -> Parsed<Option<u8>> {
        let is_open = self.is('^') && *self.kind_after(1) == Kind::Sign('{') && *self.kind_after(2) == Kind::Sign('(');
        let is_closed = *self.kind_after(4) == Kind::Sign(')') && *self.kind_after(5) == Kind::Sign('}');
        let Kind::Number(digits) = self.kind_after(3) else { return Ok(None) };
        if !is_open || !is_closed || dots > 0 || !self.scope.is_of_one_coordinate(name, None) {
            return Ok(None);
        }
        let span = self.span();
        let order = digits.parse::<u8>().ok().filter(|n| (1..=HIGHEST_ORDER).contains(&u32::from(*n)));
        let Some(order) = order else {
            let message = format!("a derivative is at most of order {HIGHEST_ORDER}, and at least of order 1");
            return refuse("latex::derivative", message, span, "");
        };
        self.at += 6;
        if self.is('^') {
            let hint = "put the derivative into parentheses";
            return refuse("latex::double-script", "a second superscript", self.span(), hint);
        }
        Ok(Some(order))
    }

    fn scripted_symbol(&mut self, mut name: Name, dots: u8, under: Option<Vec<SubItem>>, start: usize) -> Parsed<Node> {
        let order = self.order_in_parentheses(&name, dots)?;
        let (sub, mut sup, sup_first) = self.scripts_of(Some(&mut name))?;
        // `y_1''` is printed as `y''_1`.
        if sub.is_some() && sup.is_none() && self.primes(&mut name) {
            let span = self.span();
            let (second, raised, _) = self.scripts_of(Some(&mut name))?;
            if second.is_some() {
                let hint = "put all indices into one pair of braces";
                return refuse("latex::double-script", "a second subscript", span, hint);
            }
            sup = raised;
        }
        let sub = under.or(sub);
        let before = dots;
        let dots = order.unwrap_or_else(|| self.primed_rate(&mut name, dots, sub.as_deref()));
        let primed = dots > before;
        let mut symbol =
            SymbolNode { name, dots, primed, sub, sup, sup_first, arguments: None, arguments_text: String::new() };
        if self.is('(')
            && let Some(close) = self.closing()
        {
            let text = canonical(&self.tokens[self.at + 1..close]);
            self.is_no_unknown_function(&symbol, start, close)?;
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
            } else {
                self.is_no_call(&symbol, start, close)?;
            }
        } else if self.is('[') {
            self.is_no_functional(&symbol, start)?;
        }
        Ok(self.node(NodeKind::Symbol(symbol), start))
    }
}
