//! Factors: numbers, symbols, brackets, absolute values, and what a command begins.

use super::super::feature;
use super::super::lexer::Kind;
use super::super::name::{self, NAMES};
use super::super::syntax::{Bracket, Nabla, Node, NodeKind};
use super::function::{self, FUNCTIONS, WORDS, operators};
use super::{Open, Parsed, Parser, decimal, refuse};
use expr::Rational;

impl Parser<'_> {
    /// π, unless it is declared as something else, or is part of a name: the label of `m_\pi`, the letter of `\hat\pi`.
    pub(super) fn is_pi(&self) -> bool {
        let pi = r"\pi";
        let declared = match self.kind_after(1) {
            Kind::Sign('_' | '(') => self.scope.declares(pi),
            Kind::Sign('\'' | '^') if self.scope.declares(r"\pi'") => true,
            _ => self.scope.is_known(pi, None),
        };
        self.is_command("pi") && !self.in_name && !self.in_subscript && !declared
    }

    /// Whether a factor can begin here.
    pub(super) fn begins_factor(&self) -> bool {
        match self.kind() {
            Kind::Number(_) | Kind::Letter(_) | Kind::Sign('{' | '(' | '[') | Kind::OpenBar | Kind::OpenFence => true,
            Kind::Sign('|') => self.bars == 0 && !self.is_bar_of_time(),
            Kind::Command(c) => !matches!(
                c.as_str(),
                "rightarrow"
                    | "to"
                    | "cdot"
                    | "times"
                    | "pm"
                    | "mp"
                    | "ne"
                    | "neq"
                    | "equiv"
                    | "coloneqq"
                    | "le"
                    | "leq"
                    | "ge"
                    | "geq"
                    | "lt"
                    | "gt"
                    | "leqslant"
                    | "geqslant"
                    | "end"
                    | "infty"
                    | "rfloor"
                    | "rceil"
                    | "}"
            ),
            _ => false,
        }
    }

    /// Whether a named function begins here.
    pub(super) fn begins_function(&self) -> bool {
        matches!(self.kind(), Kind::Command(c)
            if FUNCTIONS.contains(&c.as_str()) || c == "operatorname" || matches!(c.as_str(), "Re" | "Im" | "arg"))
    }

    /// A factor with its scripts; `None` where no factor begins.
    pub(super) fn factor(&mut self) -> Parsed<Option<Node>> {
        self.deeper(|p| {
            let Some(mut node) = p.primary()? else { return Ok(None) };
            if p.is('!') {
                node = p.factorial(node)?;
            }
            if matches!(node.kind, NodeKind::Number(_)) && p.degree_sign() {
                p.is_no_temperature()?;
                node = p.in_degrees(node);
                if p.is('^') || p.is('_') {
                    return refuse("latex::double-script", "a script behind degrees", p.span(), "use parentheses");
                }
            }
            let primed = p.prime().is_some();
            if !(primed || p.is('_') || p.is('^')) {
                return Ok(Some(node));
            }
            // `{\dot x}_1` is printed as `\dot x_1`.
            if let NodeKind::Symbol(s) = &node.kind
                && !s.primed
                && s.sub.is_none()
                && s.sup.is_none()
                && s.arguments.is_none()
            {
                let (mut name, dots, start) = (s.name.clone(), s.dots, node.span.start);
                p.primes(&mut name);
                return p.symbol_named(name, dots, start).map(Some);
            }
            if primed {
                if let Some(by) = p.derived_by_primes(&node) {
                    return p.primed_group(node, by).map(Some);
                }
                let message = "a prime behind something that is no name";
                let hint = r"a prime belongs to a name, `x'`; of a root or a fraction it is printed behind the whole; a derivative is written `\frac{d}{dx}(…)`";
                return refuse("latex::ambiguous", message, p.span(), hint);
            }
            p.script_is_clear(&node)?;
            let (sub, sup, sup_first) = p.script_pair()?;
            let start = node.span.start;
            Ok(Some(p.node(NodeKind::Scripted { base: Box::new(node), sub, sup, sup_first }, start)))
        })
    }

    /// `^\circ`: eaten when it is there.
    fn degree_sign(&mut self) -> bool {
        let circle = |k: &Kind| matches!(k, Kind::Command(c) if c == "circ");
        let braced = *self.kind_after(1) == Kind::Sign('{') && *self.kind_after(3) == Kind::Sign('}');
        let tokens = match self.is('^') {
            true if circle(self.kind_after(1)) => 2,
            true if braced && circle(self.kind_after(2)) => 4,
            _ => return false,
        };
        self.at += tokens;
        true
    }

    /// Refuses degrees of Celsius and others: they are no angles.
    fn is_no_temperature(&self) -> Parsed<()> {
        let rest = self.text.get(self.last_end()..).unwrap_or_default();
        let rest = rest.trim_start_matches(|c: char| "\\,~:;{} ".contains(c));
        let rest = ["mathrm", "text", "textrm", "mbox", "rm", "operatorname"]
            .iter()
            .find_map(|w| rest.strip_prefix(w))
            .unwrap_or(rest);
        let mut letters = rest.trim_start_matches(['{', ' ']).chars();
        let is_scale = letters.next().is_some_and(|c| "CFKR".contains(c))
            && !letters.next().is_some_and(|c| c.is_alphanumeric() || c == '_');
        match is_scale {
            true => {
                let hint = "write the temperature as a number, or as a parameter with its unit";
                refuse("latex::ambiguous", "degrees of a temperature, or an angle", self.span(), hint)
            }
            false => Ok(()),
        }
    }

    /// A number of degrees: one degree is π/180.
    fn in_degrees(&self, number: Node) -> Node {
        let start = number.span.start;
        let top = Box::new(self.node(NodeKind::Pi, start));
        let bottom = Box::new(self.node(NodeKind::Number(Rational::from(180)), start));
        let one = self.node(NodeKind::Quotient { top, bottom, slash: false }, start);
        let angle = self.node(NodeKind::Product(vec![number, one]), start);
        self.node(NodeKind::Group(Box::new(angle), Bracket::Round), start)
    }

    /// At `!`: the factorial of what stands before it, which is one piece.
    fn factorial(&mut self, of: Node) -> Parsed<Node> {
        let span = self.span();
        self.bump();
        let clear = matches!(of.kind, NodeKind::Number(_) | NodeKind::Group(..) | NodeKind::Symbol(_));
        if !clear || self.is('!') {
            let hint = "write `n!` with one number, or parentheses";
            return refuse("latex::ambiguous", "it is not clear what `!` belongs to", span, hint);
        }
        let start = of.span.start;
        Ok(self.node(NodeKind::Factorial(Box::new(of)), start))
    }

    /// Refuses a script behind something that is not printed as one piece.
    fn script_is_clear(&self, node: &Node) -> Parsed<()> {
        let clear = match &node.kind {
            NodeKind::Group(..) | NodeKind::Matrix(_) | NodeKind::Absolute(_) | NodeKind::Tuple(_) => true,
            NodeKind::Cross { bracket, .. } => *bracket,
            NodeKind::Poisson(..) => self.is('^'),
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Identity | NodeKind::At { bar: None, .. } => true,
            NodeKind::Conjugate(_) => true,
            // The bar shows how far a root reaches.
            NodeKind::Root(..) => self.is('^'),
            NodeKind::Function(_, None, arguments) => {
                self.follows_whole_part()
                    || self.is('^') && matches!(arguments.as_slice(), [only] if function::is_lone(only))
            }
            // Behind its arguments, or behind braces as in `{\dot x}_1`.
            NodeKind::Symbol(s) => s.sup.is_none() && (s.arguments.is_some() || s.sub.is_none() || self.is('^')),
            _ => false,
        };
        if clear {
            return Ok(());
        }
        if self.is('_') && matches!(&node.kind, NodeKind::Symbol(s) if s.sub.is_some()) {
            let hint = "put all indices into one pair of braces, where `{x_a}_b` is to be `x_{ab}`";
            return refuse("latex::double-script", "a subscript below a name that has one", self.span(), hint);
        }
        let message = format!("it is not clear what {} belongs to", self.shown());
        refuse("latex::ambiguous", message, self.span(), "put parentheses around what it belongs to")
    }

    /// What a factor is made of; `None` where none begins.
    pub(super) fn primary(&mut self) -> Parsed<Option<Node>> {
        let start = self.span().start;
        match self.kind().clone() {
            Kind::Number(n) => {
                if n.len() > 1 && n.starts_with('0') && !n.starts_with("0.") {
                    return refuse("latex::unexpected", "a number that begins with 0", self.span(), "leave the 0 out");
                }
                self.bump();
                Ok(Some(self.node(NodeKind::Number(decimal(&n)), start)))
            }
            Kind::Letter('e') if *self.kind_after(1) == Kind::Sign('^') && self.is_euler(2) => {
                self.bump();
                self.bump();
                let exponent = self.exponent()?;
                Ok(Some(self.exponential(exponent, false, start)))
            }
            Kind::Letter(_) => {
                if let Some(operator) = self.plain_word()? {
                    return self.operator(operator, start).map(Some);
                }
                if let Some(tokens) = self.begins_differential()? {
                    return self.free_differential(tokens, start).map(Some);
                }
                if self.is_bare_euler()? {
                    self.bump();
                    return Ok(Some(self.node(NodeKind::Euler { upright: false }, start)));
                }
                self.symbol(0).map(Some)
            }
            Kind::Sign('{') => self.braces(start),
            Kind::Sign('(') => match self.derivative_along(start)? {
                Some(derivative) => Ok(Some(derivative)),
                None => self.round(start).map(Some),
            },
            Kind::Sign('[') if self.bracketed_name()?.is_some() => self.symbol(0).map(Some),
            Kind::Sign('[') => self.square(start).map(Some),
            Kind::OpenFence => self.fenced(start).map(Some),
            Kind::OpenBar => {
                self.bump();
                let outer = std::mem::replace(&mut self.bars, 0);
                let inner = self.sum()?;
                self.bars = outer;
                if *self.kind() != Kind::CloseBar {
                    return refuse("latex::unbalanced", "`|` is never closed", start..start + 1, "");
                }
                self.bump();
                Ok(Some(self.node(NodeKind::Absolute(Box::new(inner)), start)))
            }
            Kind::Sign('|') if self.bars == 0 && !self.is_bar_of_time() => self.bars(start).map(Some),
            Kind::Command(c) => match self.unit(start)? {
                Some(unit) => Ok(Some(unit)),
                None => self.command(&c, start),
            },
            _ => Ok(None),
        }
    }

    /// The exponent of Euler's number.
    fn exponent(&mut self) -> Parsed<Node> {
        let outer = self.exponent.replace(self.depth + 1);
        let exponent = self.raised();
        self.exponent = outer;
        exponent
    }

    fn exponential(&self, exponent: Node, upright: bool, start: usize) -> Node {
        self.node(NodeKind::Exponential { exponent: Box::new(exponent), upright }, start)
    }

    /// `e` with a superscript is Euler's number, unless `e` is declared; the superscript is `offset` tokens ahead.
    fn is_euler(&self, offset: usize) -> bool {
        let prime = matches!(self.kind_after(offset), Kind::Command(c) if c == "prime");
        !prime && !self.scope.declares("e")
    }

    /// `e` by itself is Euler's number, too, unless it is declared.
    fn is_bare_euler(&self) -> Parsed<bool> {
        let named = matches!(self.kind_after(1), Kind::Sign('_' | '^' | '\''));
        if *self.kind() != Kind::Letter('e') || named || !self.is_euler(1) {
            return Ok(false);
        }
        if *self.kind_after(1) == Kind::Sign('(') && !self.holds_terms(self.at + 1) {
            let hint = r"declare `e`, or write `\cdot`, or `\exp(…)`";
            return refuse("latex::ambiguous", "Euler's number before parentheses", self.span(), hint);
        }
        Ok(true)
    }

    /// Letters without a backslash that spell a function: `sin x` would be printed as a product.
    fn plain_word(&mut self) -> Parsed<Option<String>> {
        let letter = |i: usize| match self.tokens.get(i).map(|t| (&t.kind, &t.span)) {
            Some((Kind::Letter(c), span)) => Some((*c, span.clone())),
            _ => None,
        };
        let adjacent = |i: usize| match (i.checked_sub(1).and_then(letter), letter(i)) {
            (Some((_, before)), Some((_, here))) => before.end == here.start,
            _ => false,
        };
        if adjacent(self.at) {
            return Ok(None);
        }
        let mut word = String::new();
        let mut i = self.at;
        while let Some((c, _)) = letter(i)
            && (i == self.at || adjacent(i))
        {
            word.push(c);
            i += 1;
        }
        let span = self.span().start..self.tokens[i.saturating_sub(1)].span.end;
        let known = word.chars().all(|c| self.scope.declares(&c.to_string()));
        let spelled = |f: &str| word == f || (f.len() > 2 && word.starts_with(f));
        if let Some(f) = FUNCTIONS.iter().filter(|f| f.len() > 1).find(|f| spelled(f)) {
            let message = format!("`{f}` without a backslash is a product of letters");
            return refuse("latex::ambiguous", message, span, format!(r"write `\{f}`, or spaces between the letters"));
        }
        let operator = operators().map(|(name, _)| name).find(|name| *name == word);
        match operator {
            Some(name) if WORDS.contains(&name) && !known && self.tokens[i].kind == Kind::Sign('(') => {
                self.at = i;
                Ok(Some(name.to_owned()))
            }
            Some(name) if name.len() > 2 || !known => {
                let message = format!("`{name}` without a command is a product of letters");
                let hint = format!(r"write `\operatorname{{{name}}}`, or spaces between the letters");
                refuse("latex::ambiguous", message, span, hint)
            }
            _ => Ok(None),
        }
    }

    /// `{…}`: a name, an operator, or something that reads the same without braces.
    fn braces(&mut self, start: usize) -> Parsed<Option<Node>> {
        if let Some(operator) = self.switched_operator() {
            if let Some(action) = self.vector_operator(&operator) {
                return self.acting(action, start).map(Some);
            }
            if let Some(function) = function::named(&operator) {
                return self.function(function, start).map(Some);
            }
            return self.operator(operator, start).map(Some);
        }
        if self.braced_euler() {
            return self.upright_euler(start).map(Some);
        }
        let back = self.at;
        if let Some(mut name) = self.braced_word(None)? {
            self.primes(&mut name);
            return self.symbol_named(name, 0, start).map(Some);
        }
        self.at = back;
        if let Kind::Command(c) = self.kind_after(1).clone()
            && matches!(c.as_str(), "bf" | "mathbf" | "mathbb")
        {
            self.bump();
            if self.identity() && self.eat('}') {
                return Ok(Some(self.node(NodeKind::Identity, start)));
            }
            self.at = back;
        }
        let opening = self.span();
        self.bump();
        let inner = self.sum()?;
        if let NodeKind::Sum(_) = inner.kind {
            let hint = "write parentheses: LaTeX does not print braces";
            return refuse("latex::ambiguous", "a sum in braces", opening.start..inner.span.end, hint);
        }
        let open = self.open_here().cloned();
        self.expect('}')?;
        if let Some(open) = open {
            self.open = Some((self.at, open));
        }
        Ok(Some(Node { span: start..self.last_end(), ..inner }))
    }

    /// Behind an upright e: its exponent, if it has one.
    fn upright_euler(&mut self, start: usize) -> Parsed<Node> {
        if self.is('(') && !self.holds_terms(self.at) {
            let hint = r"write `\cdot`, or `\exp(…)`";
            return refuse("latex::ambiguous", "Euler's number before parentheses", self.span(), hint);
        }
        if !self.eat('^') {
            return Ok(self.node(NodeKind::Euler { upright: true }, start));
        }
        let exponent = self.exponent()?;
        Ok(self.exponential(exponent, true, start))
    }

    /// `{\rm e}`: eaten when it is there.
    fn braced_euler(&mut self) -> bool {
        let rm = matches!(self.kind_after(1), Kind::Command(c) if c == "rm");
        let found = rm
            && *self.kind_after(2) == Kind::Letter('e')
            && *self.kind_after(3) == Kind::Sign('}')
            && !self.scope.declares("rm:e");
        if found {
            self.at += 4;
        }
        found
    }

    /// `{\rm tr}` and the like: an operator in a group of its own.
    pub(super) fn switched_operator(&mut self) -> Option<String> {
        let back = self.at;
        let Kind::Command(c) = self.kind_after(1).clone() else { return None };
        if c != "rm" {
            return None;
        }
        self.bump();
        self.bump();
        let mut word = String::new();
        loop {
            match self.kind().clone() {
                Kind::Letter(c) => word.push(c),
                Kind::Number(n) => word.push_str(&n),
                _ => break,
            }
            self.bump();
        }
        let function = function::named(&word).is_some() && !self.scope.declares(&format!("rm:{word}"));
        let function = function || self.vector_operator(&word).is_some();
        if self.is('}') && (function || operators().any(|(name, _)| name == word)) {
            self.bump();
            return Some(word);
        }
        self.at = back;
        None
    }

    fn command(&mut self, c: &str, start: usize) -> Parsed<Option<Node>> {
        match c {
            "frac" | "tfrac" | "dfrac" => {
                self.bump();
                self.fraction(start).map(Some)
            }
            "binom" | "tbinom" | "dbinom" => {
                self.bump();
                self.binomial(start).map(Some)
            }
            "sqrt" => {
                self.bump();
                self.root(start).map(Some)
            }
            "pi" if self.is_pi() => {
                self.bump();
                Ok(Some(self.node(NodeKind::Pi, start)))
            }
            "dot" | "ddot" | "dddot" | "ddddot" => self.dotted(c, start).map(Some),
            "mathbb" | "mathbf" | "bf" if self.identity() => Ok(Some(self.node(NodeKind::Identity, start))),
            "begin" => {
                self.bump();
                self.matrix(start).map(Some)
            }
            "operatorname" | "mathrm" | "mathop" | "text" | "textrm" | "textup" => self.named_operator(start),
            _ if FUNCTIONS.contains(&c) => {
                self.bump();
                self.function(c, start).map(Some)
            }
            "Re" | "Im" | "arg" => {
                self.bump();
                self.function(c, start).map(Some)
            }
            "lfloor" => self.whole_part("floor", "rfloor", start).map(Some),
            "lceil" => self.whole_part("ceil", "rceil", start).map(Some),
            "partial" => self.partial(start).map(Some),
            "{" => self.poisson(start).map(Some),
            "nabla" => self.nabla(start).map(Some),
            "Box" => {
                self.bump();
                self.acting(Nabla::Wave, start).map(Some)
            }
            "Delta" if self.begins_laplacian()? => {
                self.bump();
                self.acting(Nabla::Laplacian { delta: true }, start).map(Some)
            }
            "lim" => {
                let hint = "take the limit of the whole left side";
                refuse("latex::limit", "a limit stands alone on the left side", self.span(), hint)
            }
            _ if feature::of_command(c).is_some() => self.unsupported(c),
            _ if name::is_switch(c) => {
                let hint = format!(r"write `{{\{c} …}}` around the name");
                refuse("latex::ambiguous", format!("`\\{c}` changes all that follows"), self.span(), hint)
            }
            _ if !self.begins_factor() => Ok(None),
            _ => match self.single_name()? {
                Some((name, _)) => self.symbol_named(name, 0, start).map(Some),
                None if name::style(c) == Some("bar") && *self.kind_after(1) == Kind::Sign('{') => {
                    self.overlined(start).map(Some)
                }
                None if name::style(c).is_some() => {
                    let hint = "write one name in the braces, and scripts or dots outside";
                    refuse("latex::unexpected", format!("`\\{c}` stands before one name"), self.span(), hint)
                }
                None => refuse("latex::unknown-command", format!("`\\{c}` is not known"), self.span(), ""),
            },
        }
    }

    /// Refuses a command that is known, and not part of the language.
    pub(super) fn unsupported<T>(&self, command: &str) -> Parsed<T> {
        let Some(feature) = feature::of_command(command) else {
            return refuse("latex::unknown-command", format!("`\\{command}` is not known"), self.span(), "");
        };
        let message = format!("`\\{command}`: {}", feature.is_not);
        refuse("latex::unsupported", message, self.span(), feature.instead)
    }

    /// `\operatorname{…}` and `\mathrm{…}`: an operator, Euler's e, or a name.
    fn named_operator(&mut self, start: usize) -> Parsed<Option<Node>> {
        let back = self.at;
        if let Some(tokens) = self.begins_differential()? {
            return self.free_differential(tokens, start).map(Some);
        }
        self.bump();
        let mut word = self.word();
        if word.is_none() && self.eat('{') {
            // `\mathop{\rm tr}`
            if self.is_command("rm") {
                self.at -= 1;
                word = self.switched_operator();
            }
        } else if word.is_none()
            && let Kind::Letter(c) = *self.kind()
        {
            self.bump();
            word = Some(c.to_string());
        }
        if let Some(word) = word {
            if operators().any(|(name, _)| name == word) {
                return self.operator(word, start).map(Some);
            }
            if let Some(action) = self.vector_operator(&word) {
                return self.acting(action, start).map(Some);
            }
            if word == "e" && !self.is('_') && !self.scope.declares("rm:e") {
                return self.upright_euler(start).map(Some);
            }
            // `\operatorname{atan}_2(y,x)`
            let second = matches!(self.kind_after(1), Kind::Number(n) if n == "2")
                || *self.kind_after(1) == Kind::Sign('{') && matches!(self.kind_after(2), Kind::Number(n) if n == "2");
            if matches!(word.as_str(), "atan" | "arctan") && self.is('_') && second {
                self.bump();
                self.subscript()?;
                return self.operator("atan2".to_owned(), start).map(Some);
            }
            if let Some(function) = function::named(&word)
                && !self.scope.declares(&format!("rm:{word}"))
            {
                return self.function(function, start).map(Some);
            }
        }
        self.at = back;
        let span = self.span();
        match self.single_name()? {
            Some((name, _)) => self.symbol_named(name, 0, start).map(Some),
            None => refuse("latex::unknown-function", "this function is not known", span, ""),
        }
    }

    /// What an upright word before something does, where it is no name: `\mathrm{rot}\,{\bf A}`.
    fn vector_operator(&self, word: &str) -> Option<Nabla> {
        function::of_nabla(word).filter(|_| !self.scope.declares(&format!("rm:{word}")))
    }

    /// `\mathbb{1}`, `\mathbf{1}`, `\bf 1`: eaten when it is there.
    fn identity(&mut self) -> bool {
        let one = |k: &Kind| matches!(k, Kind::Number(n) if n == "1");
        if one(self.kind_after(1)) {
            self.bump();
            self.bump();
            return true;
        }
        if *self.kind_after(1) == Kind::Sign('{') && one(self.kind_after(2)) && *self.kind_after(3) == Kind::Sign('}') {
            for _ in 0..4 {
                self.bump();
            }
            return true;
        }
        false
    }

    /// Whether what stands here can be the argument of a function without parentheses.
    pub(super) fn begins_bare_argument(&self) -> bool {
        match self.kind() {
            Kind::Number(_) | Kind::Letter(_) | Kind::Sign('{') => true,
            Kind::Command(c) => {
                let accent = matches!(
                    c.as_str(),
                    "frac" | "tfrac" | "dfrac" | "sqrt" | "pi" | "dot" | "ddot" | "dddot" | "ddddot" | "mathrm"
                );
                let styled = name::style(c).is_some_and(|s| s != "rm" && s != "bb") && !name::is_switch(c);
                accent || NAMES.contains(&c.as_str()) || styled
            }
            _ => false,
        }
    }

    /// Marks what was just read as having no visible end.
    pub(super) fn leave_open(&mut self, open: Open) {
        self.open = Some((self.at, open));
    }
}
