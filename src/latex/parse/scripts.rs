//! Subscripts, superscripts, primes, and labels above.

use super::super::lexer::Kind;
use super::super::name::{self, NAMES};
use super::super::syntax::{Name, Node, NodeKind, SubItem};
use super::super::write::subscript;
use super::names::{LONGEST_WORD, plain};
use super::{Parsed, Parser, decimal, refuse};

/// Commands and signs that print a space between two letters.
const PRINTED_SPACES: &[&str] =
    &["~", r"\,", r"\:", r"\;", r"\>", "\\ ", r"\quad", r"\qquad", r"\enspace", r"\hspace", r"\thinspace"];

/// What moves a script that follows it to another place.
const MOVES: &[&str] = &[r"\!", r"\null", r"\strut", r"\mathstrut", r"\kern", r"\mkern", r"\hskip", r"\mskip"];

/// The two scripts of a symbol, and whether the superscript came first.
pub(super) type Scripts = (Option<Vec<SubItem>>, Option<Box<Node>>, bool);

impl Parser<'_> {
    /// Primes that stand here, added to a name.
    pub(super) fn primes(&mut self, name: &mut Name) -> bool {
        let before = name.len();
        while let Some(tokens) = self.prime() {
            self.at += tokens;
            name.push('\'');
        }
        name.len() > before
    }

    pub(super) fn script_pair(&mut self) -> Parsed<Scripts> {
        self.scripts_of(None)
    }

    /// The two scripts of a symbol. A label above it that is declared, as in `\mu^{(1)}`, becomes part of its name.
    pub(super) fn scripts_of(&mut self, mut name: Option<&mut Name>) -> Parsed<Scripts> {
        let (mut sub, mut sup, mut sup_first) = (None, None, false);
        let mut is_spaced = false;
        loop {
            let labelled = sup.is_none() && name.as_deref_mut().is_some_and(|name| self.label_of(name));
            if sup.is_none()
                && !labelled
                && let Some(name) = name.as_deref()
            {
                self.is_no_unknown_label(name)?;
            }
            if labelled {
                name = None;
                if self.is('^') {
                    let hint = "put the name and its label into parentheses";
                    return refuse("latex::double-script", "a power behind a label", self.span(), hint);
                }
            } else if self.is('_') {
                self.is_not_apart(sup.is_some(), is_spaced)?;
                is_spaced |= self.begins_with_space();
                if sub.is_some() {
                    let hint = "put all indices into one pair of braces";
                    return refuse("latex::double-script", "a second subscript", self.span(), hint);
                }
                self.bump();
                sub = Some(self.subscript()?);
            } else if self.is('^') && (sup.is_some() || self.prime().is_none()) {
                if sup.is_some() {
                    return refuse("latex::double-script", "a second superscript", self.span(), "use parentheses");
                }
                self.is_not_apart(sub.is_some(), is_spaced)?;
                is_spaced |= self.begins_with_space();
                self.bump();
                sup_first = sub.is_none();
                sup = Some(Box::new(self.superscript()?));
            } else {
                return Ok((sub, sup, sup_first));
            }
        }
    }

    /// Whether a space is printed between a sign of a script, which stands here, and what it lowers or raises in braces.
    fn begins_with_space(&self) -> bool {
        let token = |at: usize| self.tokens.get(self.at + at);
        let between = token(1).filter(|t| t.kind == Kind::Sign('{')).zip(token(2));
        let between = between.and_then(|(open, first)| self.text.get(open.span.end..first.span.start));
        let is_power = super::super::alike::is_power(&self.tokens[self.at..]);
        !is_power && between.is_some_and(|text| PRINTED_SPACES.iter().any(|space| text.contains(space)))
    }

    /// Refuses a script behind a space, or with one at its beginning, where another stands before it: `T^a_{\ b}` are indices of a tensor behind
    /// each other. A power is clear.
    fn is_not_apart(&self, is_second: bool, is_spaced: bool) -> Parsed<()> {
        let between = self.text.get(self.last_end()..self.span().start).unwrap_or_default();
        let is_behind = PRINTED_SPACES.iter().chain(MOVES).any(|space| between.contains(space));
        let is_power = super::super::alike::is_power(&self.tokens[self.at..]);
        // `2\,^3P`
        let behind = if *self.kind_after(1) == Kind::Sign('{') { self.kind_after(4) } else { self.kind_after(2) };
        if is_power && is_behind && matches!(behind, Kind::Letter(_)) {
            let hint = "a power touches what it is of";
            return refuse("latex::ambiguous", "a power, or a script before a letter", self.span(), hint);
        }
        if !is_second || is_power || !(is_behind || is_spaced || self.begins_with_space()) {
            return Ok(());
        }
        let hint = "write the scripts above each other, `T^a_b`, where their order does not count";
        refuse("latex::ambiguous", "two scripts behind each other: indices of a tensor", self.span(), hint)
    }

    /// A label above that stands here, and the number of its tokens: something in parentheses, a word in upright letters, or a sign,
    /// as in `\mu^{(1)}`, `u^{\rm R}`, `x^*`, `J^+`, `p^\circ`.
    pub(super) fn label_above(&self) -> Option<(String, usize)> {
        if !self.is('^') {
            return None;
        }
        let sign = |kind: &Kind| match kind {
            Kind::Sign(c @ ('*' | '+' | '-')) => Some(c.to_string()),
            Kind::Command(c)
                if matches!(c.as_str(), "circ" | "dagger" | "pm" | "mp" | "ominus" | "infty" | "star" | "ast") =>
            {
                Some(if c == "ast" { "*".to_owned() } else { format!("\\{c}") })
            }
            _ => None,
        };
        if *self.kind_after(1) != Kind::Sign('{') {
            return sign(self.kind_after(1)).map(|label| (label, 2)).or_else(|| self.upright_above(1));
        }
        if let Some(found) = self.upright_in_parentheses() {
            return Some(found);
        }
        let end = (2..LONGEST_WORD).find(|&i| *self.kind_after(i) == Kind::Sign('}'))?;
        let inside = || (2..end).map(|i| self.kind_after(i));
        if end == 3 {
            return sign(self.kind_after(2)).map(|label| (label, 4));
        }
        if inside().all(|kind| *kind == Kind::Sign('*')) {
            return Some((format!("{{{}}}", "*".repeat(end - 2)), end + 1));
        }
        let parentheses = *self.kind_after(2) == Kind::Sign('(') && *self.kind_after(end - 1) == Kind::Sign(')');
        if parentheses {
            let content = inside().map(text_of).collect::<Option<String>>()?;
            return Some((format!("{{{content}}}"), end + 1));
        }
        // A word in upright letters: a switch, or a command with its argument.
        let Kind::Command(style) = self.kind_after(2) else { return None };
        if name::style(style) == Some("rm") && name::is_switch(style) {
            let word = (3..end).map(|i| text_of(self.kind_after(i))).collect::<Option<String>>()?;
            return (!word.is_empty()).then(|| (format!(r"{{\rm {word}}}"), end + 1));
        }
        let (label, tokens) = self.upright_above(2)?;
        (*self.kind_after(tokens) == Kind::Sign('}')).then_some((label, tokens + 1))
    }

    /// A command for upright letters and its argument, `\mathrm{II}` or `\mathrm I`, and the position after them.
    fn upright_above(&self, at: usize) -> Option<(String, usize)> {
        let Kind::Command(style) = self.kind_after(at) else { return None };
        if name::style(style) != Some("rm") || name::is_switch(style) {
            return None;
        }
        let (from, to, after) = match self.kind_after(at + 1) {
            Kind::Sign('{') => {
                let end = (at + 2..at + LONGEST_WORD).find(|&i| *self.kind_after(i) == Kind::Sign('}'))?;
                (at + 2, end, end + 1)
            }
            Kind::Letter(_) => (at + 1, at + 2, at + 2),
            _ => return None,
        };
        let end = |i: usize| self.tokens.get(self.at + i).map(|t| t.span.end);
        let start = |i: usize| self.tokens.get(self.at + i).map(|t| t.span.start);
        let is_behind_space = |i: usize| name::sets_words(style) && i > from && end(i - 1) < start(i);
        let mut word = String::new();
        for i in from..to {
            word.extend(is_behind_space(i).then_some(' '));
            word.push_str(&text_of(self.kind_after(i))?);
        }
        let label =
            if (from..to).any(is_behind_space) { format!(r"{{\text{{{word}}}}}") } else { format!(r"{{\rm {word}}}") };
        (!word.is_empty()).then_some((label, after))
    }

    /// `R^{(\mathrm{e})}`: a word in upright letters and in parentheses, and the number of its tokens.
    fn upright_in_parentheses(&self) -> Option<(String, usize)> {
        let style =
            |kind: &Kind| matches!(kind, Kind::Command(c) if name::style(c) == Some("rm") && !name::is_switch(c));
        let sign = |at: usize, c: char| *self.kind_after(at) == Kind::Sign(c);
        if !(sign(2, '(') && style(self.kind_after(3)) && sign(4, '{')) {
            return None;
        }
        let end = (5..LONGEST_WORD).find(|&i| sign(i, '}')).filter(|&end| sign(end + 1, ')') && sign(end + 2, '}'))?;
        let letter = |kind: &Kind| if let Kind::Letter(c) = kind { Some(*c) } else { None };
        let word = (5..end).map(|i| letter(self.kind_after(i))).collect::<Option<String>>()?;
        (!word.is_empty()).then(|| (format!(r"{{(\mathrm{{{word}}})}}"), end + 3))
    }

    /// Refuses a word above a name that is declared without it: it is no power.
    fn is_no_unknown_label(&self, name: &str) -> Parsed<()> {
        let Some((label, tokens)) = self.label_above() else { return Ok(()) };
        let words = label.strip_prefix(r"{\text{").and_then(|w| w.strip_suffix("}}"));
        let word = label.strip_prefix(r"{\rm ").and_then(|w| w.strip_suffix('}')).or(words);
        // `A^{\rm T}`, `x^{\rm i}`, and the power of a declared upright name.
        let power = |w: &str| matches!(w, "T" | "i" | "e") || self.scope.declares(&format!("rm:{w}"));
        if word.is_none_or(power) {
            return Ok(());
        }
        let message = format!("`{}^{label}` is not declared", name::to_latex(name));
        let span = self.span().start..self.tokens[(self.at + tokens - 1).min(self.tokens.len() - 1)].span.end;
        refuse(
            "latex::unknown-symbol",
            message,
            span,
            "declare the name under [symbols] with its label, as it is printed",
        )
    }

    /// Makes a declared label that stands here part of the name.
    pub(super) fn label_of(&mut self, name: &mut Name) -> bool {
        let Some((label, tokens)) = self.label_above().filter(|_| self.scope.has_labels()) else { return false };
        let whole = format!("{name}^{label}");
        let declared = self.scope.declares(&whole);
        if declared {
            self.at += tokens;
            *name = whole;
        }
        declared
    }

    /// A superscript of something that could have labels.
    pub(super) fn superscript(&mut self) -> Parsed<Node> {
        let node = self.raised()?;
        if let NodeKind::Group(..) = node.kind {
            let hint = "write a power without parentheses; other meanings of `^{(…)}` are not known";
            return refuse("latex::ambiguous", "a superscript in parentheses", node.span, hint);
        }
        Ok(node)
    }

    /// What stands behind `^`.
    pub(super) fn raised(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        if let Some((transposed, tokens)) = self.conjugation() {
            self.at += tokens;
            return Ok(self.node(NodeKind::Conjugation { transposed }, start));
        }
        if self.eat('{') {
            let is_number = matches!(self.kind_after(1), Kind::Number(_)) && *self.kind_after(2) == Kind::Sign('}');
            if self.is('+') && is_number {
                let hint = "a power has no plus; an uncertainty is no part of a formula";
                return refuse("latex::ambiguous", "a power, or an uncertainty", self.span(), hint);
            }
            let outer = std::mem::replace(&mut self.bars, 0);
            let node = self.sum()?;
            self.expect('}')?;
            self.bars = outer;
            return Ok(node);
        }
        // TeX takes one token: a single digit, letter or command; a fraction or a root brings its arguments along.
        let whole =
            matches!(self.kind(), Kind::Command(c) if matches!(c.as_str(), "frac" | "tfrac" | "dfrac" | "sqrt"));
        if whole && let Some(node) = self.primary()? {
            return Ok(node);
        }
        if let Kind::Number(n) = self.kind().clone() {
            if n.len() > 1 {
                let hint = format!("write `^{{{n}}}`");
                return refuse("latex::ambiguous", "LaTeX raises only the first digit", self.span(), hint);
            }
            self.bump();
            return Ok(self.node(NodeKind::Number(decimal(&n)), start));
        }
        if self.is_pi() {
            self.bump();
            return Ok(self.node(NodeKind::Pi, start));
        }
        if *self.kind() == Kind::Letter('e') && !self.scope.declares("e") {
            self.bump();
            return Ok(self.node(NodeKind::Euler { upright: false }, start));
        }
        match self.name_without_primes()? {
            Some((name, span)) => Ok(Node { kind: NodeKind::Symbol(plain(name)), span }),
            None => {
                let message = format!("{} stands where an exponent is expected", self.shown());
                refuse("latex::unexpected", message, self.span(), "put the exponent into braces")
            }
        }
    }

    /// `*` or `\dagger`, perhaps in braces: whether it transposes, and the number of its tokens.
    fn conjugation(&self) -> Option<(bool, usize)> {
        let mark = |kind: &Kind| match kind {
            Kind::Sign('*') => Some(false),
            Kind::Command(c) if c == "ast" => Some(false),
            Kind::Command(c) if matches!(c.as_str(), "dagger" | "dag") => Some(true),
            _ => None,
        };
        if let Some(transposed) = mark(self.kind()) {
            return Some((transposed, 1));
        }
        let braced = self.is('{') && *self.kind_after(2) == Kind::Sign('}');
        mark(self.kind_after(1)).filter(|_| braced).map(|transposed| (transposed, 3))
    }

    pub(super) fn subscript(&mut self) -> Parsed<Vec<SubItem>> {
        let outer = std::mem::replace(&mut self.in_subscript, true);
        let items = self.subscript_items();
        self.in_subscript = outer;
        items
    }

    /// Refuses a printed space between two parts of a label: what it parts would be read as one.
    fn is_no_space_in_label(&self) -> Parsed<()> {
        let between = self.text.get(self.last_end()..self.span().start).unwrap_or_default();
        let is_space = PRINTED_SPACES.iter().any(|space| between.contains(space));
        if !is_space || self.is('}') {
            return Ok(());
        }
        let hint = "put a comma between its parts, or no space";
        refuse("latex::ambiguous", "a space within a subscript", self.span(), hint)
    }

    fn subscript_items(&mut self) -> Parsed<Vec<SubItem>> {
        let braced = self.eat('{');
        let mut items = Vec::new();
        if braced
            && let Kind::Command(c) = self.kind().clone()
            && name::is_switch(&c)
        {
            // `_{\rm max}`: the switch holds to the end of the braces.
            self.bump();
            let mut word = String::new();
            while let Some((name, _)) = self.single_name()? {
                word.push_str(&name);
                self.is_no_space_in_label()?;
            }
            if let (false, Some(style)) = (word.is_empty(), name::style(&c)) {
                items.push(SubItem::Name(format!("{style}:{word}")));
            }
        }
        loop {
            // A comma parts what it stands between by itself.
            if braced && !matches!(items.last(), None | Some(SubItem::Other(','))) && !self.is(',') {
                self.is_no_space_in_label()?;
            }
            match self.kind().clone() {
                Kind::Number(n) => {
                    if n.contains('.') {
                        return refuse("latex::unexpected", "a decimal number as an index", self.span(), "");
                    }
                    if !braced && n.len() > 1 {
                        let hint = format!("write `_{{{n}}}`");
                        return refuse("latex::ambiguous", "LaTeX lowers only the first digit", self.span(), hint);
                    }
                    items.extend(n.bytes().map(|b| SubItem::Digit(u16::from(b.saturating_sub(b'0')))));
                    self.bump();
                }
                // Labels that are no names elsewhere.
                Kind::Command(c)
                    if matches!(
                        c.as_str(),
                        "infty" | "parallel" | "perp" | "bot" | "|" | "odot" | "oplus" | "star" | "circ" | "partial"
                    ) =>
                {
                    items.push(SubItem::Name(format!("\\{c}")));
                    self.bump();
                }
                Kind::Command(c) if matches!(c.as_str(), "min" | "max") => {
                    items.push(SubItem::Name(format!("rm:{c}")));
                    self.bump();
                }
                Kind::Sign('}') if braced => break,
                Kind::Sign(',') if braced => {
                    if items.is_empty() || *self.kind_after(1) == Kind::Sign('}') {
                        let hint = "write a derivative as a fraction";
                        return refuse("latex::ambiguous", "a comma beside an index", self.span(), hint);
                    }
                    items.push(SubItem::Other(','));
                    self.bump();
                }
                Kind::Command(c) if matches!(c.as_str(), "+" | "-" | "*") => {
                    items.extend(c.chars().map(SubItem::Other));
                    self.bump();
                }
                Kind::Command(c) if matches!(c.as_str(), "pm" | "mp") => {
                    let hint = "write a relation for each sign, with names such as `J_+` and `J_-`";
                    return refuse("latex::unexpected", "± cannot stand in a subscript", self.span(), hint);
                }
                Kind::Sign(c @ ('(' | ')' | '-' | '+' | '*' | '/')) if braced => {
                    items.push(SubItem::Other(c));
                    self.bump();
                }
                // TeX lowers one token: `x_i'` is printed as `x'_i`.
                _ => match if braced { self.single_name()? } else { self.name_without_primes()? } {
                    // `P_{\theta_2}`: a label with a label.
                    Some((name, _)) if braced && self.is('_') => {
                        self.bump();
                        let inner = self.deeper(Self::subscript)?;
                        items.push(SubItem::Name(name + &subscript(&inner)));
                    }
                    Some((name, _)) => items.push(SubItem::Name(name)),
                    None => {
                        let message = format!("{} cannot stand in a subscript", self.shown());
                        return refuse("latex::unexpected", message, self.span(), "");
                    }
                },
            }
            if !braced {
                return Ok(items);
            }
        }
        self.expect('}')?;
        if items.is_empty() {
            return refuse("latex::unexpected", "an empty subscript", self.span(), "");
        }
        Ok(items)
    }

    /// Number of tokens of a prime that stands here.
    pub(super) fn prime(&self) -> Option<usize> {
        let prime = |k: &Kind| matches!(k, Kind::Command(c) if c == "prime");
        if self.is('\'') {
            return Some(1);
        }
        if !self.is('^') {
            return None;
        }
        if prime(self.kind_after(1)) {
            return Some(2);
        }
        let braced = *self.kind_after(1) == Kind::Sign('{') && *self.kind_after(3) == Kind::Sign('}');
        (braced && prime(self.kind_after(2))).then_some(4)
    }
}

/// What a token of a label prints.
fn text_of(kind: &Kind) -> Option<String> {
    match kind {
        Kind::Letter(c) => Some(c.to_string()),
        Kind::Number(n) => Some(n.clone()),
        Kind::Sign(c @ (',' | '+' | '-' | '(' | ')')) => Some(c.to_string()),
        Kind::Command(c) if NAMES.contains(&c.as_str()) => Some(format!("\\{c} ")),
        _ => None,
    }
}
