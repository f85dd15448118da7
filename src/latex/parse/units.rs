//! Units behind numbers: `9.81\,\mathrm{m/s^2}`, `5\,\mathrm{N\,m}`.
//!
//! Where a file speaks of units, its upright names are units, and inside of one group they are joined as on paper: a product,
//! perhaps a slash, and behind it one unit or a product in parentheses.

use super::super::lexer::Kind;
use super::super::syntax::{Node, NodeKind};
use super::names::plain;
use super::{Parsed, Parser, refuse};

impl Parser<'_> {
    /// At `\mathrm` or `\text`: a unit, if the group holds nothing but declared units; leaves its place otherwise.
    pub(super) fn unit(&mut self, start: usize) -> Parsed<Option<Node>> {
        let command = matches!(self.kind(), Kind::Command(c) if matches!(c.as_str(), "mathrm" | "text"));
        if !self.scope.has_units() || !command || *self.kind_after(1) != Kind::Sign('{') {
            return Ok(None);
        }
        let back = self.at;
        self.at += 2;
        let Some(above) = self.unit_product()? else {
            self.at = back;
            return Ok(None);
        };
        let mut node = above;
        if self.eat('/') {
            let below = if self.eat('(') {
                let product = self.unit_product()?;
                self.expect(')')?;
                product
            } else {
                let from = self.at;
                let one = self.unit_factor()?;
                if self.at > from && !self.is('}') {
                    let hint = "put parentheses around what stands behind `/`";
                    return refuse("latex::ambiguous", "more than one unit behind `/`", self.span(), hint);
                }
                one
            };
            let Some(below) = below else {
                self.at = back;
                return Ok(None);
            };
            let kind = NodeKind::Quotient { top: Box::new(node), bottom: Box::new(below), slash: false };
            node = self.node(kind, start);
        }
        if !self.eat('}') {
            self.at = back;
            return Ok(None);
        }
        node.span = start..self.last_end();
        Ok(Some(node))
    }

    /// Units side by side.
    fn unit_product(&mut self) -> Parsed<Option<Node>> {
        let start = self.span().start;
        let mut factors = Vec::new();
        while let Some(factor) = self.unit_factor()? {
            factors.push(factor);
            if self.is_command("cdot") {
                self.bump();
            }
        }
        Ok(match (factors.len(), factors.pop()) {
            (1, only) => only,
            (_, None) => None,
            (_, Some(last)) => {
                factors.push(last);
                Some(self.node(NodeKind::Product(factors), start))
            }
        })
    }

    /// One unit, with its power: letters that touch each other.
    fn unit_factor(&mut self) -> Parsed<Option<Node>> {
        let (back, start) = (self.at, self.span().start);
        let mut word = String::new();
        while let Kind::Letter(c) = *self.kind()
            && (word.is_empty() || self.span().start == self.last_end())
        {
            word.push(c);
            self.bump();
        }
        let name = format!("rm:{word}");
        if word.is_empty() || !self.scope.declares(&name) {
            self.at = back;
            return Ok(None);
        }
        let mut symbol = plain(name);
        if self.eat('^') {
            symbol.sup = Some(Box::new(self.superscript()?));
        }
        Ok(Some(self.node(NodeKind::Symbol(symbol), start)))
    }
}
