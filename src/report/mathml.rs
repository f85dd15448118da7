//! Formulas as MathML, from the syntax trees that the formula reader makes.
//!
//! **In:** a formula as the file has it, and the scope that it was read in. **Out:** MathML Core, which browsers lay out
//! without any script or font of ours; `None` for a text that is no formula of the language.
//!
//! **Why from the tree, and not from LaTeX by a library:** the tree is what the verdict is about, so a reader sees how a
//! formula was understood: products and function values carry the invisible operators that screen readers speak. Nothing of
//! a file's text reaches the page unescaped: known libraries pass `\operatorname{<script>}` through.

use expr::Rational;
use latex::syntax::{
    Bracket, Chain, Least, Nabla, Node, NodeKind, PartialForm, RelationKind, Sign, SubItem, SymbolNode, Target,
    tightness,
};
use latex::{self, Scope};

/// Invisible multiplication and function application, for what reads a formula aloud.
const TIMES: &str = "<mo>\u{2062}</mo>";
const APPLY: &str = "<mo>\u{2061}</mo>";
/// The same where no bracket follows: the argument stands apart.
const APPLY_APART: &str = "<mo rspace=\"0.17em\">\u{2061}</mo>";

/// A formula inside a line; several relations are separated by commas.
pub fn formula_mathml(text: &str, scope: &Scope) -> Option<String> {
    let chains = latex::parse(text, scope).ok()?;
    // A `math` element is a row itself.
    if let [one] = chains.as_slice() {
        return Some(format!("<math>{}</math>", chain(one)));
    }
    let all: Vec<String> = chains.iter().map(|c| format!("<mrow>{}</mrow>", chain(c))).collect();
    Some(format!("<math>{}</math>", all.join("<mo separator=\"true\">,</mo><mspace width=\"0.5em\"/>")))
}

/// A formula on its own: each relation one `math` element. Its LaTeX is in `report.md`, and in the derivation file.
pub(super) fn display(text: &str, scope: &Scope) -> Option<Vec<String>> {
    let chains = latex::parse(text, scope).ok()?;
    Some(chains.iter().map(|c| format!("<math display=\"block\">{}</math>", chain(c))).collect())
}

/// Text between tags, or inside a quoted attribute.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// A chain of relations, as the inside of a row.
fn chain(chain: &Chain) -> String {
    let mut out = Markup(String::new());
    for (k, side) in chain.sides.iter().enumerate() {
        if let Some(kind) = k.checked_sub(1).and_then(|before| chain.relations.get(before)) {
            out.operator(relation(*kind));
        }
        match &side.kind {
            NodeKind::Limit(body, target) => {
                out.put("<munder><mo movablelimits=\"false\">lim</mo><mrow>");
                out.name(chain.time.as_deref().unwrap_or("t"));
                out.operator("→");
                match target {
                    Target::Finite(at) => out.node(at, Least::Sum),
                    Target::PlusInfinity => out.put("<mo form=\"prefix\">+</mo><mi>∞</mi>"),
                    Target::MinusInfinity => out.put("<mo form=\"prefix\">−</mo><mi>∞</mi>"),
                }
                out.put("</mrow></munder>");
                out.put(APPLY);
                out.node(body, Least::Product);
            }
            _ => out.node(side, Least::Sum),
        }
    }
    out.0
}

fn relation(kind: RelationKind) -> &'static str {
    match kind {
        RelationKind::Equal => "=",
        RelationKind::NotEqual => "≠",
        RelationKind::Less => "<",
        RelationKind::LessEqual => "≤",
        RelationKind::Greater => ">",
        RelationKind::GreaterEqual => "≥",
    }
}

struct Markup(String);

impl Markup {
    fn put(&mut self, markup: &str) {
        self.0.push_str(markup);
    }

    fn operator(&mut self, text: &str) {
        self.put(&format!("<mo>{}</mo>", escaped(text)));
    }

    fn row(&mut self, node: &Node, least: Least) {
        // One element needs no row.
        let one = match &node.kind {
            NodeKind::Number(r) => *r >= Rational::ZERO && r.denominator().is_one(),
            NodeKind::Symbol(s) => s.arguments.is_none(),
            _ => false,
        };
        if one {
            return self.node(node, least);
        }
        self.put("<mrow>");
        self.node(node, least);
        self.put("</mrow>");
    }

    fn node(&mut self, node: &Node, least: Least) {
        if tightness(node) < least {
            self.enclosed("(", node, ")");
        } else {
            self.bare(node);
        }
    }

    fn enclosed(&mut self, open: &str, node: &Node, close: &str) {
        let mut inner = Markup(String::new());
        inner.node(node, Least::Sum);
        self.fenced(open, &inner.0, close);
    }

    /// Brackets around markup.
    fn fenced(&mut self, open: &str, inner: &str, close: &str) {
        // Accents and indices make a row only a little taller; a bracket that grows with them looks wrong.
        let tall = ["<mfrac", "<mtable", "<msqrt", "<mroot", "<munder"].iter().any(|t| inner.contains(t));
        let stretchy = if tall { "" } else { " stretchy=\"false\"" };
        // First and last in a row, parentheses are known as brackets; bars are not.
        let (first, last) = match open {
            "|" => (" fence=\"true\" form=\"prefix\"", " fence=\"true\" form=\"postfix\""),
            _ => ("", ""),
        };
        self.put(&format!("<mrow><mo{first}{stretchy}>{open}</mo>{inner}<mo{last}{stretchy}>{close}</mo></mrow>"));
    }

    fn list(&mut self, nodes: &[Node]) {
        let mut inner = Markup(String::new());
        inner.joined(nodes, "<mo separator=\"true\">,</mo>", Least::Sum);
        self.fenced("(", &inner.0, ")");
    }

    fn joined(&mut self, nodes: &[Node], between: &str, least: Least) {
        for (i, node) in nodes.iter().enumerate() {
            if i > 0 {
                self.put(between);
            }
            self.node(node, least);
        }
    }

    fn bare(&mut self, node: &Node) {
        match &node.kind {
            NodeKind::Number(r) => self.number(r),
            NodeKind::Pi => self.put("<mi>π</mi>"),
            NodeKind::Euler { upright: false } => self.put("<mi>e</mi>"),
            NodeKind::Euler { upright: true } => self.put("<mi mathvariant=\"normal\">e</mi>"),
            NodeKind::Identity => self.put("<mi mathvariant=\"normal\">𝟙</mi>"),
            NodeKind::Symbol(s) => self.symbol(s),
            NodeKind::Group(inner, bracket) => {
                let (open, close) = match bracket {
                    Bracket::Round => ("(", ")"),
                    Bracket::Square => ("[", "]"),
                    Bracket::Curly => ("{", "}"),
                };
                self.enclosed(open, inner, close);
            }
            NodeKind::Scripted { base, sub, sup, .. } => {
                let mut inner = Markup(String::new());
                inner.row(base, Least::Factor);
                self.scripted(&inner.0, sub.as_deref(), sup.as_deref());
            }
            NodeKind::Sum(terms) => {
                for (i, (sign, term)) in terms.iter().enumerate() {
                    let sign = match sign {
                        Sign::Plus if i > 0 || terms.len() == 1 => "+",
                        Sign::Plus => "",
                        Sign::Minus => "−",
                        Sign::PlusMinus => "±",
                        Sign::MinusPlus => "∓",
                    };
                    match (sign, i) {
                        ("", _) => {}
                        (sign, 0) => self.put(&format!("<mo form=\"prefix\">{sign}</mo>")),
                        (sign, _) => self.operator(sign),
                    }
                    self.node(term, Least::Dot);
                }
            }
            NodeKind::Product(parts) => self.joined(parts, TIMES, Least::Factor),
            NodeKind::Dot(parts) => self.joined(parts, "<mo>⋅</mo>", Least::Cross),
            NodeKind::Cross { left, right, bracket: true } => {
                let mut inner = Markup(String::new());
                inner.node(left, Least::Sum);
                inner.put("<mo separator=\"true\">,</mo>");
                inner.node(right, Least::Sum);
                self.fenced("[", &inner.0, "]");
            }
            NodeKind::Cross { left, right, bracket: false } => {
                self.node(left, Least::Product);
                self.put("<mo>×</mo>");
                self.node(right, Least::Product);
            }
            NodeKind::Quotient { top, bottom, slash: false } => {
                self.put("<mfrac>");
                self.row(top, Least::Sum);
                self.row(bottom, Least::Sum);
                self.put("</mfrac>");
            }
            NodeKind::Quotient { top, bottom, slash: true } => {
                let slashed = matches!(top.kind, NodeKind::Quotient { slash: true, .. });
                self.node(top, if slashed { Least::Factor } else { Least::Product });
                self.put("<mo>/</mo>");
                self.node(bottom, Least::Factor);
            }
            NodeKind::Root(inner, 2) => {
                self.put("<msqrt>");
                self.row(inner, Least::Sum);
                self.put("</msqrt>");
            }
            NodeKind::Root(inner, degree) => {
                self.put("<mroot>");
                self.row(inner, Least::Sum);
                self.put(&format!("<mn>{degree}</mn></mroot>"));
            }
            NodeKind::Exponential { exponent, upright } => {
                self.put(if *upright { "<msup><mi mathvariant=\"normal\">e</mi>" } else { "<msup><mi>e</mi>" });
                self.row(exponent, Least::Sum);
                self.put("</msup>");
            }
            NodeKind::Function(name, power, arguments) => self.function(name, *power, arguments),
            NodeKind::Conjugate(inner) => {
                self.put("<mover accent=\"true\">");
                self.row(inner, Least::Sum);
                self.put("<mo>‾</mo></mover>");
            }
            NodeKind::Conjugation { transposed } => self.put(if *transposed { "<mo>†</mo>" } else { "<mo>*</mo>" }),
            NodeKind::Absolute(inner) => self.enclosed("|", inner, "|"),
            NodeKind::Derivative { of, by, order, operator, upright } => {
                let d = if *upright { "<mi mathvariant=\"normal\">d</mi>" } else { "<mi>d</mi>" };
                let raised = |what: &str| match order {
                    1 => what.to_owned(),
                    n => format!("<msup><mrow>{what}</mrow><mn>{n}</mn></msup>"),
                };
                self.put(&format!("<mfrac><mrow>{}", raised(d)));
                if !operator {
                    self.node(of, Least::Factor);
                }
                let mut under = Markup(String::new());
                under.node(by, Least::Factor);
                self.put(&format!("</mrow><mrow>{d}{}</mrow></mfrac>", raised(&under.0)));
                if *operator {
                    self.node(of, Least::Factor);
                }
            }
            NodeKind::Partial { of, by, form } => {
                const D: &str = "<mo rspace=\"0\">∂</mo>";
                let raised = |what: &str, n: usize| match n {
                    1 => what.to_owned(),
                    n => format!("<msup><mrow>{what}</mrow><mn>{n}</mn></msup>"),
                };
                let name = |node: &Node| {
                    let mut name = Markup(String::new());
                    name.node(node, Least::Factor);
                    name.0
                };
                let runs = by.chunk_by(|a, b| a.kind == b.kind);
                if *form == PartialForm::Subscript {
                    for run in runs {
                        let below = format!("<msub>{D}<mrow>{}</mrow></msub>", name(&run[0]));
                        self.put(&raised(&below, run.len()));
                    }
                    return self.node(of, Least::Factor);
                }
                self.put(&format!("<mfrac><mrow>{}", raised(D, by.len())));
                if *form == PartialForm::Fraction {
                    self.node(of, Least::Factor);
                }
                let below: String = runs.map(|run| format!("{D}{}", raised(&name(&run[0]), run.len()))).collect();
                self.put(&format!("</mrow><mrow>{below}</mrow></mfrac>"));
                if *form == PartialForm::Operator {
                    self.node(of, Least::Factor);
                }
            }
            NodeKind::Nabla { of, action } => {
                match action {
                    Nabla::Wave => self.put("<mo>□</mo>"),
                    Nabla::Following { fraction: false } => {
                        self.put("<mfrac><mi>D</mi><mrow><mi>D</mi><mi>t</mi></mrow></mfrac>");
                    }
                    Nabla::Following { fraction: true } => {
                        self.put("<mfrac><mrow><mi>D</mi>");
                        self.node(of, Least::Factor);
                        return self.put("</mrow><mrow><mi>D</mi><mi>t</mi></mrow></mfrac>");
                    }
                    Nabla::Gradient => self.put("<mo>∇</mo>"),
                    Nabla::Divergence => self.put("<mo>∇</mo><mo>⋅</mo>"),
                    Nabla::Curl => self.put("<mo>∇</mo><mo>×</mo>"),
                    Nabla::Laplacian { delta: false } => self.put("<msup><mo>∇</mo><mn>2</mn></msup>"),
                    Nabla::Laplacian { delta: true } => self.put("<mo>Δ</mo>"),
                    Nabla::Along(direction) => {
                        self.put("<mrow><mo>(</mo>");
                        self.node(direction, Least::Factor);
                        self.put("<mo>⋅</mo><mo>∇</mo><mo>)</mo></mrow>");
                    }
                }
                self.node(of, Least::Factor);
            }
            NodeKind::Variation { of, by } => {
                self.put("<mfrac><mrow><mo rspace=\"0\">δ</mo>");
                self.node(of, Least::Factor);
                self.put("</mrow><mrow><mo rspace=\"0\">δ</mo>");
                self.node(by, Least::Factor);
                self.put("</mrow></mfrac>");
            }
            NodeKind::Poisson(left, right) => {
                self.put("<mrow><mo>{</mo>");
                self.node(left, Least::Sum);
                self.put("<mo>,</mo>");
                self.node(right, Least::Sum);
                self.put("<mo>}</mo></mrow>");
            }
            NodeKind::Differential { of, upright } => {
                self.put(if *upright { "<mi mathvariant=\"normal\">d</mi>" } else { "<mi>d</mi>" });
                self.node(of, Least::Factor);
            }
            NodeKind::At { of, time, bar: None } => {
                self.row(of, Least::Factor);
                self.put(APPLY);
                self.enclosed("(", time, ")");
            }
            NodeKind::At { of, time, bar: Some(name) } => {
                self.put("<msub><mrow>");
                self.node(of, Least::Sum);
                self.put("<mo fence=\"true\" form=\"postfix\">|</mo></mrow><mrow>");
                self.name(name);
                self.operator("=");
                self.node(time, Least::Sum);
                self.put("</mrow></msub>");
            }
            NodeKind::Factorial(inner) => {
                self.row(inner, Least::Factor);
                self.put("<mo form=\"postfix\">!</mo>");
            }
            NodeKind::Tuple(parts) => self.list(parts),
            NodeKind::Matrix(rows) => {
                let mut inner = Markup("<mtable>".to_owned());
                for row in rows {
                    inner.put("<mtr>");
                    for cell in row {
                        inner.put("<mtd>");
                        inner.node(cell, Least::Sum);
                        inner.put("</mtd>");
                    }
                    inner.put("</mtr>");
                }
                inner.put("</mtable>");
                self.fenced("(", &inner.0, ")");
            }
            NodeKind::Limit(body, _) => self.node(body, Least::Sum),
        }
    }

    fn function(&mut self, function: &str, power: Option<i32>, arguments: &[Node]) {
        if let ("binom", [n, k]) = (function, arguments) {
            let mut inner = Markup("<mfrac linethickness=\"0\">".to_owned());
            inner.row(n, Least::Sum);
            inner.row(k, Least::Sum);
            inner.put("</mfrac>");
            return self.fenced("(", &inner.0, ")");
        }
        if let (Some([open, close]), None, [inner]) = (latex::whole_part(function), power, arguments) {
            return self.enclosed(open, inner, close);
        }
        let name = format!("<mi>{}</mi>", escaped(function));
        match power {
            None => self.put(&name),
            Some(n) => {
                let size = format!("<mn>{}</mn>", n.unsigned_abs());
                let power = if n < 0 { format!("<mrow><mo form=\"prefix\">−</mo>{size}</mrow>") } else { size };
                self.put(&format!("<msup>{name}{power}</msup>"));
            }
        }
        match arguments {
            [one] => {
                let bare = match &one.kind {
                    NodeKind::Symbol(s) => s.sup.is_none(),
                    NodeKind::Scripted { sup, .. } => sup.is_none(),
                    NodeKind::Function(..) | NodeKind::Matrix(_) | NodeKind::Cross { .. } => false,
                    NodeKind::Quotient { slash: true, .. } => false,
                    NodeKind::Group(..) | NodeKind::Absolute(_) => true,
                    _ => tightness(one) >= Least::Product,
                };
                let fenced = matches!(one.kind, NodeKind::Group(..) | NodeKind::Absolute(_));
                self.put(if bare && !fenced { APPLY_APART } else { APPLY });
                if bare {
                    self.row(one, Least::Product);
                } else {
                    self.enclosed("(", one, ")");
                }
            }
            _ => {
                self.put(APPLY);
                self.list(arguments);
            }
        }
    }

    fn symbol(&mut self, s: &SymbolNode) {
        let mut base = Markup(String::new());
        base.name(&s.name);
        if s.primed {
            base.0 = format!("<msup>{}<mo>{}</mo></msup>", base.0, "′".repeat(usize::from(s.dots)));
        } else if s.dots > 0 {
            let dots = ["˙", "¨", "\u{20db}", "\u{20dc}"][usize::from(s.dots - 1).min(3)];
            base.0 = format!("<mover accent=\"true\">{}<mo stretchy=\"false\">{dots}</mo></mover>", base.0);
        }
        self.scripted(&base.0, s.sub.as_deref(), s.sup.as_deref());
        if let Some(arguments) = &s.arguments {
            self.put(APPLY);
            self.list(arguments);
        }
    }

    fn scripted(&mut self, base: &str, sub: Option<&[SubItem]>, sup: Option<&Node>) {
        let lowered = sub.map(|items| {
            let single = items.len() == 1 || items.iter().all(|i| matches!(i, SubItem::Digit(_)));
            let mut inner = Markup(if single { String::new() } else { "<mrow>".to_owned() });
            let mut digits = String::new();
            for item in items {
                if !matches!(item, SubItem::Digit(_)) && !digits.is_empty() {
                    inner.put(&format!("<mn>{}</mn>", std::mem::take(&mut digits)));
                }
                match item {
                    SubItem::Name(n) => inner.name(n),
                    SubItem::Digit(d) => digits.push_str(&d.to_string()),
                    SubItem::Other('-') => inner.put("<mo>−</mo>"),
                    SubItem::Other(c @ ('(' | ')')) => inner.put(&format!("<mo stretchy=\"false\">{c}</mo>")),
                    SubItem::Other(c) => inner.operator(&c.to_string()),
                }
            }
            if !digits.is_empty() {
                inner.put(&format!("<mn>{digits}</mn>"));
            }
            inner.put(if single { "" } else { "</mrow>" });
            inner.0
        });
        let raised = sup.map(|node| {
            let mut inner = Markup(String::new());
            inner.row(node, Least::Sum);
            inner.0
        });
        match (lowered, raised) {
            (None, None) => self.put(base),
            (Some(low), None) => self.put(&format!("<msub>{base}{low}</msub>")),
            (None, Some(high)) => self.put(&format!("<msup>{base}{high}</msup>")),
            (Some(low), Some(high)) => self.put(&format!("<msubsup>{base}{low}{high}</msubsup>")),
        }
    }

    /// A name in canonical spelling: styles and accents before a colon, then the base, then primes.
    fn name(&mut self, name: &str) {
        let markup = named(name);
        self.put(&markup);
    }

    fn number(&mut self, r: &Rational) {
        let negative = *r < Rational::ZERO;
        if negative {
            self.put("<mo form=\"prefix\">−</mo>");
        }
        let written = decimal(r);
        match written.split_once('/') {
            Some((top, bottom)) => self.put(&format!("<mfrac><mn>{top}</mn><mn>{bottom}</mn></mfrac>")),
            None => self.put(&format!("<mn>{written}</mn>")),
        }
    }
}

/// A name as one element.
fn named(name: &str) -> String {
    let (style, rest) = name.split_once(':').map_or((None, name), |(s, r)| (Some(s), r));
    let base = rest.trim_end_matches('\'');
    let primes = rest.len() - base.len();
    let accent =
        |sign: &str| format!("<mover accent=\"true\">{}<mo stretchy=\"false\">{sign}</mo></mover>", named(base));
    let letters = match base.strip_prefix('\\') {
        Some(command) => letter(command).map_or_else(|| base.to_owned(), str::to_owned),
        None => base.to_owned(),
    };
    let letters = escaped(&letters);
    let styled = match style {
        Some("hat") => accent("^"),
        Some("tilde") => accent("~"),
        Some("bar") => accent("¯"),
        Some("vec") => accent("→"),
        Some("check") => accent("ˇ"),
        Some("breve") => accent("˘"),
        Some("acute") => accent("´"),
        Some("grave") => accent("`"),
        Some("mathring") => accent("˚"),
        // A difference, and the amount of a substance.
        Some("Delta") => format!("<mrow><mi mathvariant=\"normal\">Δ</mi>{}</mrow>", named(base)),
        Some("delta") => format!("<mrow><mi>δ</mi>{}</mrow>", named(base)),
        Some("amount") => {
            format!("<mrow><mo stretchy=\"false\">[</mo>{}<mo stretchy=\"false\">]</mo></mrow>", named(base))
        }
        Some(_) if base.contains(':') => named(base),
        Some("bf") => format!("<mi mathvariant=\"normal\" class=\"b\">{letters}</mi>"),
        Some("it") | None => upright_capital(&letters),
        Some(other) => format!("<mi mathvariant=\"normal\" class=\"{}\">{letters}</mi>", escaped(other)),
    };
    match primes {
        0 => styled,
        n => format!("<msup>{styled}<mo>{}</mo></msup>", "′".repeat(n)),
    }
}

/// A letter in the usual slant: capital Greek stands upright, as LaTeX prints it.
fn upright_capital(letters: &str) -> String {
    let capital_greek = letters.chars().all(|c| ('Α'..='Ω').contains(&c));
    if capital_greek { format!("<mi mathvariant=\"normal\">{letters}</mi>") } else { format!("<mi>{letters}</mi>") }
}

/// The letter that a command prints.
pub(super) fn letter(command: &str) -> Option<&'static str> {
    Some(match command {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "delta" => "δ",
        "epsilon" => "ϵ",
        "varepsilon" => "ε",
        "zeta" => "ζ",
        "eta" => "η",
        "theta" => "θ",
        "vartheta" => "ϑ",
        "iota" => "ι",
        "kappa" => "κ",
        "lambda" => "λ",
        "mu" => "μ",
        "nu" => "ν",
        "xi" => "ξ",
        "pi" => "π",
        "rho" => "ρ",
        "varrho" => "ϱ",
        "sigma" => "σ",
        "varsigma" => "ς",
        "tau" => "τ",
        "upsilon" => "υ",
        "phi" => "ϕ",
        "varphi" => "φ",
        "chi" => "χ",
        "psi" => "ψ",
        "omega" => "ω",
        "varpi" => "ϖ",
        "Gamma" => "Γ",
        "Delta" => "Δ",
        "Theta" => "Θ",
        "Lambda" => "Λ",
        "Xi" => "Ξ",
        "Pi" => "Π",
        "Sigma" => "Σ",
        "Upsilon" => "Υ",
        "Phi" => "Φ",
        "Psi" => "Ψ",
        "Omega" => "Ω",
        "ell" => "ℓ",
        "hbar" => "ℏ",
        "imath" => "ı",
        "jmath" => "ȷ",
        "aleph" => "ℵ",
        "wp" => "℘",
        "top" => "⊤",
        _ => return None,
    })
}

/// The size of a number: decimals where they are exact, otherwise `top/bottom`.
fn decimal(r: &Rational) -> String {
    let ten = Rational::from(10);
    let size = if *r < Rational::ZERO { -r.clone() } else { r.clone() };
    let (mut scaled, mut places) = (size.clone(), 0usize);
    while !scaled.denominator().is_one() && places < 40 {
        scaled *= &ten;
        places += 1;
    }
    if !scaled.denominator().is_one() {
        return format!("{}/{}", size.numerator(), size.denominator());
    }
    let digits = format!("{:0>width$}", scaled.numerator().to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    if fraction.is_empty() { whole.to_owned() } else { format!("{whole}.{fraction}") }
}

#[cfg(test)]
mod tests {
    use super::super::tests::derivation;
    use super::*;

    fn of(text: &str) -> String {
        formula_mathml(text, &derivation().scope).unwrap_or_else(|| panic!("{text} is no formula"))
    }

    /// The names of elements, opened and closed in order.
    fn assert_well_formed(markup: &str) {
        let mut open: Vec<&str> = Vec::new();
        for tag in markup.split('<').skip(1) {
            let name = tag.split(['>', ' ', '/']).find(|n| !n.is_empty()).unwrap_or_default();
            if tag.starts_with('/') {
                assert_eq!(open.pop(), Some(name), "{markup}");
            } else if !tag.split('>').next().unwrap_or_default().ends_with('/') {
                open.push(name);
            }
        }
        assert!(open.is_empty(), "{markup}");
    }

    #[test]
    fn formulas_keep_their_structure() {
        for (text, part) in [
            (r"\dot x=v", "<mover accent=\"true\"><mi>x</mi><mo stretchy=\"false\">˙</mo></mover><mo>=</mo><mi>v</mi>"),
            (r"\frac{x}{k}=1", "<mfrac><mi>x</mi><mi>k</mi></mfrac>"),
            (r"x^2=-k", "<msup><mi>x</mi><mn>2</mn></msup><mo>=</mo><mo form=\"prefix\">−</mo>"),
            (r"\sqrt{x}\ne 0", "<msqrt><mi>x</mi></msqrt><mo>≠</mo><mn>0</mn>"),
            (r"\sin^2x<1", "<msup><mi>sin</mi><mn>2</mn></msup><mo rspace=\"0.17em\">\u{2061}</mo>"),
            (r"kx>0.5", "<mi>k</mi><mo>\u{2062}</mo><mi>x</mi><mo>&gt;</mo><mn>0.5</mn>"),
        ] {
            let markup = of(text);
            assert!(markup.contains(part), "{text}: {markup}");
            assert_well_formed(&markup);
        }
    }

    #[test]
    fn brackets_grow_only_around_what_is_tall() {
        assert!(of("(x+v)k=0").contains("stretchy=\"false\""));
        assert!(!of(r"(\frac{x}{k}+v)k=0").contains("stretchy=\"false\""));
    }

    #[test]
    fn numbers_and_names_are_exact() {
        assert_eq!(named("bf:m"), "<mi mathvariant=\"normal\" class=\"b\">m</mi>");
        assert_eq!(named("delta:x"), "<mrow><mi>δ</mi><mi>x</mi></mrow>");
        assert!(
            named("Delta:\\theta").contains("Δ") && named("amount:S").contains("[") && named("check:x").contains("ˇ")
        );
        assert_eq!(named("x'"), "<msup><mi>x</mi><mo>′</mo></msup>");
        assert_eq!(named("<b>"), "<mi>&lt;b&gt;</mi>");
        assert_eq!(decimal(&Rational::from(12)), "12");
        assert_eq!(decimal(&(Rational::from(1) / Rational::from(3))), "1/3");
        assert_eq!(decimal(&(Rational::from(-1) / Rational::from(8))), "0.125");
    }

    #[test]
    fn what_is_no_formula_is_none() {
        assert_eq!(formula_mathml(r"\operatorname{<script>}", &derivation().scope), None);
        assert_eq!(formula_mathml("<script>", &derivation().scope), None);
    }
}
