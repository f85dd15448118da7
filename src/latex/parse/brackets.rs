//! Brackets, bars, and what they hold.

use super::super::lexer::Kind;
use super::super::syntax::{Bracket, Node, NodeKind};
use super::{Parsed, Parser, refuse};

impl Parser<'_> {
    pub(super) fn round(&mut self, start: usize) -> Parsed<Node> {
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let first = self.sum()?;
        let kind = if self.is(',') {
            let mut parts = vec![first];
            while self.eat(',') {
                parts.push(self.sum()?);
            }
            NodeKind::Tuple(parts)
        } else {
            match first.kind {
                NodeKind::Matrix(_) => first.kind,
                _ => NodeKind::Group(Box::new(first), Bracket::Round),
            }
        };
        self.expect(')')?;
        self.bars = outer;
        Ok(self.node(kind, start))
    }

    pub(super) fn square(&mut self, start: usize) -> Parsed<Node> {
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let first = self.sum()?;
        let kind = if self.eat(',') {
            let second = self.sum()?;
            NodeKind::Cross { left: Box::new(first), right: Box::new(second), bracket: true }
        } else {
            match first.kind {
                NodeKind::Matrix(_) => first.kind,
                _ => NodeKind::Group(Box::new(first), Bracket::Square),
            }
        };
        self.expect(']')?;
        self.bars = outer;
        Ok(self.node(kind, start))
    }

    /// `|…|` whose bars do not say which side they are on.
    pub(super) fn bars(&mut self, start: usize) -> Parsed<Node> {
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 1);
        let inner = self.sum()?;
        self.bars = outer;
        let hint = r"write `\left|` and `\right|`";
        if !self.eat('|') {
            return refuse("latex::unbalanced", "`|` is never closed", start..start + 1, hint);
        }
        // `|a|b|c|` is |a| b |c| or | a|b|c |.
        let later = self.has_bar_beside();
        if later && self.begins_factor() && !self.is('|') {
            return refuse("latex::ambiguous", "it is not clear which bars belong together", start..start + 1, hint);
        }
        Ok(self.node(NodeKind::Absolute(Box::new(inner)), start))
    }

    /// Whether another bar follows that is not inside of brackets or braces, as it is in `|x|\frac1{|x|}`.
    fn has_bar_beside(&self) -> bool {
        let mut depth = 0usize;
        for token in &self.tokens[self.at..] {
            match token.kind {
                Kind::Sign('|') if depth == 0 => return true,
                Kind::Sign('{' | '(' | '[') => depth += 1,
                Kind::Sign('}' | ')' | ']') if depth == 0 => return false,
                Kind::Sign('}' | ')' | ']') => depth -= 1,
                _ => {}
            }
        }
        false
    }

    /// `\overline{…}` over more than a name: the complex conjugate.
    pub(super) fn overlined(&mut self, start: usize) -> Parsed<Node> {
        self.bump();
        self.bump();
        let outer = std::mem::replace(&mut self.bars, 0);
        let inner = self.sum()?;
        self.expect('}')?;
        self.bars = outer;
        Ok(self.node(NodeKind::Conjugate(Box::new(inner)), start))
    }
}
