//! Syntax trees as LaTeX, as near as possible to what was written.
//!
//! A tree that came from a text reads back as the same tree, up to places, and where derivatives occur up to parentheses around
//! them and what they act on, and to dots between factors. A tree that was altered gets the parentheses that it needs: how far a derivative reaches can be seen,
//! and what is printed of products of derivatives is read as the same products.

mod joint;

use super::name;
use super::syntax::MOST_PRIMES;
use super::syntax::{
    Bracket, Chain, Least, Nabla, Node, NodeKind, PartialForm, RelationKind, Sign, SubItem, SymbolNode, Target,
    tightness,
};
use expr::Rational;
use joint::{
    End, between, end, ends_with_bare_argument, fitting, has_dots, is_letter_or_number, is_one_piece, is_raised,
};

/// A chain of relations as LaTeX.
pub fn to_latex(chain: &Chain) -> String {
    let mut out = Text::default();
    for (k, side) in chain.sides.iter().enumerate() {
        if let Some(kind) = k.checked_sub(1).and_then(|before| chain.relations.get(before)) {
            out.put(relation(*kind));
        }
        match &side.kind {
            NodeKind::Limit(body, target) => {
                out.put(r"\lim_{");
                out.put(&chain.time.as_deref().map_or_else(|| "t".to_owned(), name::to_latex));
                out.put(r"\rightarrow");
                match target {
                    Target::Finite(at) => out.node(at, Least::Sum),
                    Target::PlusInfinity => out.put(r"+\infty"),
                    Target::MinusInfinity => out.put(r"-\infty"),
                }
                out.put("}");
                out.node(body, Least::Sum);
            }
            _ => out.node(side, Least::Sum),
        }
    }
    out.written
}

fn relation(kind: RelationKind) -> &'static str {
    match kind {
        RelationKind::Equal => "=",
        RelationKind::NotEqual => r"\ne",
        RelationKind::Less => "<",
        RelationKind::LessEqual => r"\le",
        RelationKind::Greater => ">",
        RelationKind::GreaterEqual => r"\ge",
    }
}

/// Text to which pieces are added; commands and letters are kept apart.
#[derive(Default)]
struct Text {
    written: String,
    /// Whether it ends with the letters of a command. It is known, since to look back for each piece would take the square.
    is_command: bool,
}

impl Text {
    fn put(&mut self, piece: &str) {
        let is_name = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_alphabetic());
        if self.is_command && piece.starts_with(|c: char| c.is_ascii_alphabetic()) {
            self.written.push(' ');
        }
        // `\ln^2 0` is no power 20.
        let mut last = self.written.chars().rev();
        let script = last.next().is_some_and(|c| c.is_ascii_digit()) && matches!(last.next(), Some('^' | '_'));
        if script && piece.starts_with(|c: char| c.is_ascii_digit()) {
            self.written.push(' ');
        }
        self.is_command = match piece.rsplit_once('\\') {
            Some((_, name)) => is_name(name),
            None => is_name(piece) && self.written.ends_with('\\') || piece.is_empty() && self.is_command,
        };
        self.written.push_str(piece);
    }

    fn node(&mut self, node: &Node, least: Least) {
        if tightness(node) < least || least > Least::Dot && has_dots(node) {
            self.put("(");
            self.bare(node);
            self.put(")");
        } else {
            self.bare(node);
        }
    }

    fn joined(&mut self, nodes: &[Node], between: &str, least: Least) {
        for (i, node) in nodes.iter().enumerate() {
            if i > 0 {
                self.put(between);
            }
            self.node(node, least);
        }
    }

    /// Parts with something between them. What has no visible end gets parentheses where something follows it.
    fn followed(&mut self, nodes: &[Node], between: &str, least: Least) {
        for (i, node) in nodes.iter().enumerate() {
            if i > 0 {
                self.put(between);
            }
            let fits = i + 1 == nodes.len() || end(node) == End::Seen;
            self.node(node, if fits { least } else { Least::Never });
        }
    }

    /// What a derivative acts on: a power would be one of the derivative as well, and digits look like its order.
    fn operand(&mut self, of: &Node) {
        self.node(of, if is_raised(of) || of.begins_with_number() { Least::Never } else { Least::Factor });
    }

    fn braced(&mut self, node: &Node) {
        self.put("{");
        self.node(node, Least::Sum);
        self.put("}");
    }

    fn bare(&mut self, node: &Node) {
        match &node.kind {
            NodeKind::Number(r) => self.put(&number(r)),
            NodeKind::Pi => self.put(r"\pi"),
            NodeKind::Euler { upright } => self.put(if *upright { r"\mathrm{e}" } else { "e" }),
            NodeKind::Identity => self.put(r"\mathbb{1}"),
            NodeKind::Symbol(s) => self.symbol(s),
            NodeKind::Group(inner, bracket) => {
                let (open, close) = match bracket {
                    Bracket::Round => ("(", ")"),
                    Bracket::Square => ("[", "]"),
                    Bracket::Curly => (r"\{", r"\}"),
                };
                self.put(open);
                self.node(inner, Least::Sum);
                self.put(close);
            }
            NodeKind::Scripted { base, sub, sup, sup_first } => {
                match &base.kind {
                    NodeKind::Symbol(s) if s.arguments.is_none() && s.sup.is_none() => self.braced(base),
                    _ => self.node(base, if is_one_piece(base) { Least::Factor } else { Least::Never }),
                }
                self.scripts(sub.as_deref(), sup.as_deref(), *sup_first);
            }
            NodeKind::Sum(terms) => {
                for (i, (sign, term)) in terms.iter().enumerate() {
                    match sign {
                        Sign::Plus if i > 0 || terms.len() == 1 => self.put("+"),
                        Sign::Plus => {}
                        Sign::Minus => self.put("-"),
                        Sign::PlusMinus => self.put(r"\pm"),
                        Sign::MinusPlus => self.put(r"\mp"),
                    }
                    self.node(term, Least::Dot);
                }
            }
            NodeKind::Product(parts) => {
                let fits = fitting(parts);
                for (i, part) in parts.iter().enumerate() {
                    if let Some(before) = i.checked_sub(1) {
                        self.put(between((&parts[before], fits[before]), (part, fits[i])));
                    }
                    self.node(part, if fits[i] { Least::Factor } else { Least::Never });
                }
            }
            NodeKind::Dot(parts) => self.followed(parts, r"\cdot", Least::Cross),
            NodeKind::Cross { left, right, bracket } => {
                let (open, middle, close, least) =
                    if *bracket { ("[", ",", "]", Least::Sum) } else { ("", r"\times", "", Least::Product) };
                self.put(open);
                // `a\times b\times c` of numbers.
                let before = if *bracket { least } else { Least::Cross };
                self.node(left, if *bracket || end(left) == End::Seen { before } else { Least::Never });
                self.put(middle);
                self.node(right, least);
                self.put(close);
            }
            NodeKind::Quotient { top, bottom, slash: false } => {
                self.put(r"\frac");
                self.braced(top);
                self.braced(bottom);
            }
            NodeKind::Quotient { top, bottom, slash: true } => {
                let fits = end(top) == End::Seen && !ends_with_bare_argument(top);
                self.node(top, if fits { Least::Product } else { Least::Never });
                self.put("/");
                self.node(bottom, Least::Factor);
            }
            NodeKind::Root(inner, degree) => {
                self.put(r"\sqrt");
                if *degree != 2 {
                    self.put(&format!("[{degree}]"));
                }
                self.braced(inner);
            }
            NodeKind::Exponential { exponent, upright } => {
                self.put(if *upright { r"\mathrm{e}^" } else { "e^" });
                self.braced(exponent);
            }
            NodeKind::Function(name, power, arguments) => self.function(name, *power, arguments),
            NodeKind::Conjugate(inner) => {
                self.put(r"\overline");
                self.braced(inner);
            }
            NodeKind::Conjugation { transposed } => self.put(if *transposed { r"\dagger" } else { "*" }),
            NodeKind::Absolute(inner) => {
                self.put(r"\left|");
                self.node(inner, Least::Sum);
                self.put(r"\right|");
            }
            NodeKind::Derivative { of, by, order, operator, upright } => {
                let d = if *upright { r"\mathrm{d}" } else { "d" };
                let power = if *order == 1 { String::new() } else { format!("^{order}") };
                self.put(r"\frac{");
                self.put(d);
                self.put(&power);
                if !operator {
                    self.operand(of);
                }
                self.put("}{");
                self.put(d);
                self.node(by, Least::Factor);
                self.put(&power);
                self.put("}");
                if *operator {
                    self.operand(of);
                }
            }
            NodeKind::Partial { of, by, form } => {
                let power = |n: usize| if n == 1 { String::new() } else { script('^', &n.to_string()) };
                let runs = by.chunk_by(|a, b| a.kind == b.kind);
                if *form == PartialForm::Subscript {
                    for run in runs {
                        self.put(r"\partial");
                        let mut under = Text::default();
                        under.node(&run[0], Least::Factor);
                        self.put(&script('_', &under.written));
                        self.put(&power(run.len()));
                    }
                    self.put(" ");
                    return self.operand(of);
                }
                self.put(r"\frac{\partial");
                self.put(&power(by.len()));
                self.put(" ");
                if *form == PartialForm::Fraction {
                    self.operand(of);
                }
                self.put("}{");
                for run in runs {
                    self.put(r"\partial ");
                    self.node(&run[0], Least::Factor);
                    self.put(&power(run.len()));
                }
                self.put("}");
                if *form == PartialForm::Operator {
                    self.operand(of);
                }
            }
            NodeKind::Nabla { of, action } => {
                match action {
                    Nabla::Wave => self.put(r"\Box "),
                    Nabla::Following { fraction: false } => self.put(r"\frac{D}{Dt}"),
                    Nabla::Following { fraction: true } => {
                        self.put(r"\frac{D");
                        self.operand(of);
                        return self.put("}{Dt}");
                    }
                    Nabla::Gradient => self.put(r"\nabla "),
                    Nabla::Divergence => self.put(r"\nabla\cdot "),
                    Nabla::Curl => self.put(r"\nabla\times "),
                    Nabla::Laplacian { delta: false } => self.put(r"\nabla^2 "),
                    Nabla::Laplacian { delta: true } => self.put(r"\Delta "),
                    Nabla::Along(direction) => {
                        self.put("(");
                        self.node(direction, Least::Factor);
                        self.put(r"\cdot\nabla)");
                    }
                }
                self.operand(of);
            }
            NodeKind::Variation { of, by } => {
                self.put(r"\frac{\delta ");
                let named = matches!(of.kind, NodeKind::Symbol(_) | NodeKind::Group(..)) && !is_raised(of);
                self.node(of, if named { Least::Factor } else { Least::Never });
                self.put(r"}{\delta ");
                self.node(by, Least::Factor);
                self.put("}");
            }
            NodeKind::Poisson(left, right) => {
                self.put(r"\{");
                self.node(left, Least::Sum);
                self.put(",");
                self.node(right, Least::Sum);
                self.put(r"\}");
            }
            NodeKind::Differential { of, upright } => {
                self.put(if *upright { r"\mathrm{d}" } else { "d" });
                self.node(of, Least::Factor);
            }
            NodeKind::At { of, time, bar: None } => {
                self.node(of, if end(of) == End::Seen { Least::Factor } else { Least::Never });
                self.put("(");
                self.node(time, Least::Sum);
                self.put(")");
            }
            NodeKind::At { of, time, bar: Some(name) } => {
                self.put(r"\left.");
                self.node(of, Least::Sum);
                self.put(r"\right|_{");
                self.put(&name::to_latex(name));
                self.put("=");
                self.node(time, Least::Sum);
                self.put("}");
            }
            NodeKind::Factorial(inner) => {
                self.node(inner, Least::Factor);
                self.put("!");
            }
            NodeKind::Tuple(parts) => {
                self.put("(");
                self.joined(parts, ",", Least::Sum);
                self.put(")");
            }
            NodeKind::Matrix(rows) => {
                self.put(r"\begin{pmatrix}");
                for (i, row) in rows.iter().enumerate() {
                    if i > 0 {
                        self.put(r"\\");
                    }
                    self.joined(row, "&", Least::Sum);
                }
                self.put(r"\end{pmatrix}");
            }
            NodeKind::Limit(body, _) => self.node(body, Least::Sum),
        }
    }

    fn function(&mut self, function: &str, power: Option<i32>, arguments: &[Node]) {
        if let ("binom", [n, k]) = (function, arguments) {
            self.put(r"\binom");
            self.braced(n);
            self.braced(k);
            return;
        }
        if let ("floor" | "ceil", None, [inner]) = (function, power, arguments) {
            self.put(&format!(r"\left\l{function} "));
            self.node(inner, Least::Sum);
            self.put(&format!(r"\right\r{function} "));
            return;
        }
        let command = super::parse::spelled(function);
        self.put(&command);
        let (arguments, base) = match (function, arguments) {
            ("log", [argument, base]) => (std::slice::from_ref(argument), Some(base)),
            _ => (arguments, None),
        };
        if let Some(base) = base {
            self.put("_");
            self.braced(base);
        }
        if let Some(n) = power {
            self.put(&script('^', &n.to_string()));
        }
        match arguments {
            [one] if super::parse::takes_bare_argument(function) => {
                let as_it_is = match &one.kind {
                    NodeKind::Symbol(s) => s.sup.is_none(),
                    NodeKind::Scripted { sup, .. } => sup.is_none(),
                    NodeKind::Function(..) | NodeKind::Matrix(_) | NodeKind::Cross { .. } | NodeKind::Poisson(..) => {
                        false
                    }
                    NodeKind::Product(parts) => parts.iter().all(is_letter_or_number) && !has_dots(one),
                    _ if end(one) != End::Seen
                        || matches!(one.kind, NodeKind::Partial { .. } | NodeKind::Nabla { .. }) =>
                    {
                        false
                    }
                    _ => {
                        tightness(one) >= Least::Product && !matches!(one.kind, NodeKind::Quotient { slash: true, .. })
                    }
                };
                if as_it_is {
                    self.bare(one);
                } else {
                    self.put("(");
                    self.bare(one);
                    self.put(")");
                }
            }
            _ => {
                self.put("(");
                self.joined(arguments, ",", Least::Sum);
                self.put(")");
            }
        }
    }

    fn symbol(&mut self, s: &SymbolNode) {
        if s.dots > 0 && !s.primed {
            self.put(&format!(r"\{}ot", "d".repeat(usize::from(s.dots))));
        }
        self.put(&name::to_latex(&s.name));
        match s.dots {
            n if s.primed && usize::from(n) > MOST_PRIMES => self.put(&format!("^{{({n})}}")),
            n if s.primed => self.put(&"'".repeat(usize::from(n))),
            _ => {}
        }
        self.scripts(s.sub.as_deref(), s.sup.as_deref(), s.sup_first);
        if let Some(arguments) = &s.arguments {
            self.put("(");
            self.joined(arguments, ",", Least::Sum);
            self.put(")");
        }
    }

    fn scripts(&mut self, sub: Option<&[SubItem]>, sup: Option<&Node>, sup_first: bool) {
        let lowered = sub.map(subscript);
        let raised = sup.map(|node| {
            let mut inner = Text::default();
            inner.node(node, Least::Sum);
            script('^', &inner.written)
        });
        let (first, second) = if sup_first { (raised, lowered) } else { (lowered, raised) };
        for text in first.iter().chain(&second) {
            self.put(text);
        }
    }
}

/// A subscript, with its sign.
pub(super) fn subscript(items: &[SubItem]) -> String {
    let mut inner = Text::default();
    for item in items {
        match item {
            SubItem::Name(n) => inner.put(&name::to_latex(n)),
            SubItem::Digit(d) => inner.put(&d.to_string()),
            SubItem::Other(c) => inner.put(&c.to_string()),
        }
    }
    script('_', &inner.written)
}

fn script(sign: char, inner: &str) -> String {
    if inner.chars().count() == 1 { format!("{sign}{inner}") } else { format!("{sign}{{{inner}}}") }
}

/// A number as decimals where that is exact, otherwise as a fraction.
fn number(r: &Rational) -> String {
    let ten = Rational::from(10);
    let negative = *r < Rational::ZERO;
    let mut scaled = if negative { -r.clone() } else { r.clone() };
    let mut places = 0usize;
    while !scaled.denominator().is_one() && places < 400 {
        scaled *= &ten;
        places += 1;
    }
    let sign = if negative { "-" } else { "" };
    if !scaled.denominator().is_one() {
        let (top, bottom) = (r.numerator().to_string(), r.denominator().to_string());
        return format!(r"{sign}\frac{{{}}}{{{bottom}}}", top.trim_start_matches('-'));
    }
    let digits = scaled.numerator().to_string();
    if places == 0 {
        return format!("{sign}{digits}");
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    format!("{sign}{whole}.{fraction}")
}

#[cfg(test)]
mod tests;
