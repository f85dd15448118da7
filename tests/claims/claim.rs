//! Random claims as data, and how they are written in a derivation file.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::line::{Q, whole};
use super::term::{Motion, Term, latex_number, toml_number};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Equal,
    Different,
    Less,
    AtMost,
    Greater,
    AtLeast,
}

pub const KINDS: [Kind; 6] = [Kind::Equal, Kind::Different, Kind::Less, Kind::AtMost, Kind::Greater, Kind::AtLeast];

impl Kind {
    pub fn latex(self) -> &'static str {
        match self {
            Kind::Equal => "=",
            Kind::Different => r"\ne ",
            Kind::Less => "<",
            Kind::AtMost => r"\le ",
            Kind::Greater => ">",
            Kind::AtLeast => r"\ge ",
        }
    }
}

/// How components stand together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shape {
    Scalar,
    /// A vector of one component.
    One,
    /// A vector of three.
    Three,
    /// A matrix of two rows and two columns.
    Matrix,
}

pub const SHAPES: [Shape; 4] = [Shape::Scalar, Shape::One, Shape::Three, Shape::Matrix];

impl Shape {
    pub fn components(self) -> usize {
        match self {
            Shape::Scalar | Shape::One => 1,
            Shape::Three => 3,
            Shape::Matrix => 4,
        }
    }

    pub fn latex(self, c: &[Term]) -> String {
        let c: Vec<String> = c.iter().map(Term::latex).collect();
        match self {
            Shape::Scalar => c[0].clone(),
            Shape::One => format!(r"\begin{{pmatrix}}{}\end{{pmatrix}}", c[0]),
            Shape::Three => format!("({})", c.join(",")),
            Shape::Matrix => format!(r"\begin{{pmatrix}}{}&{}\\{}&{}\end{{pmatrix}}", c[0], c[1], c[2], c[3]),
        }
    }
}

/// A relation, chain, or limit.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// Sides, and the relations between them: one more side than relations.
    Relation { shape: Shape, sides: Vec<Vec<Term>>, kinds: Vec<Kind> },
    /// The limit of a term at a time, or at infinity.
    Limit { of: Term, at: Option<Q>, kind: Kind, value: Q },
}

impl Statement {
    pub fn latex(&self) -> String {
        match self {
            Statement::Relation { shape, sides, kinds } => {
                let mut text = shape.latex(&sides[0]);
                for (k, s) in kinds.iter().zip(&sides[1..]) {
                    text += k.latex();
                    text += &shape.latex(s);
                }
                text
            }
            Statement::Limit { of, at, kind, value } => {
                let at = at.as_ref().map_or(r"\infty".to_owned(), latex_number);
                let term = of.latex();
                format!(r"\lim_{{t\rightarrow {at}}}\left({term}\right){}{}", kind.latex(), latex_number(value))
            }
        }
    }

    pub fn has_sign(&self) -> bool {
        match self {
            Statement::Relation { sides, .. } => sides.iter().flatten().any(Term::has_sign),
            Statement::Limit { .. } => false,
        }
    }

    pub fn is_equation(&self) -> bool {
        matches!(self, Statement::Relation { kinds, .. } if kinds.iter().all(|k| *k == Kind::Equal))
    }
}

/// One string: several statements, separated by commas.
pub type Text = Vec<Statement>;

pub fn text_has_sign(text: &Text) -> bool {
    text.iter().any(Statement::has_sign)
}

fn latex_text(text: &Text) -> String {
    text.iter().map(Statement::latex).collect::<Vec<_>>().join(r",\quad ")
}

/// A term of several components.
pub type Shaped = (Shape, Vec<Term>);

#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    Always(Vec<Text>),
    Never(Vec<Text>),
    Eventually(Vec<Text>),
    FirstIntegral(Vec<Shaped>),
    Defined(Vec<Shaped>),
    /// x has this rate, and y that one.
    Solves(Term, Term),
    /// x is this on another motion, which has a span of its own.
    SameMotion(Term, (Q, Q)),
    /// x²+2bx+y and y, that is, gradients with the determinant 2(x+b); or y and 2y, which depend on one another.
    Independent(Option<Q>),
    /// u in a range with these factors of a product that is to vanish, each divided by 1 + its hole.
    Exists {
        range: (Q, Q),
        equation: (Term, Term),
        also: Option<Box<(Term, Kind, Term)>>,
        unique: bool,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Scene {
    Integrated,
    Formula,
    Derived,
    Box,
    /// All real numbers x, y = 2, a = 3/2.
    All,
}

pub const SCENES: [Scene; 5] = [Scene::Integrated, Scene::Formula, Scene::Derived, Scene::Box, Scene::All];

#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    pub scene: Scene,
    /// Place of the span, or range of x, in [`SPANS`].
    pub span: usize,
    pub motion: Motion,
    pub forms: Vec<Form>,
    pub assuming: Vec<Text>,
    pub at: Option<(Term, Term)>,
    pub throughout: bool,
    /// The role of the symbol `k`, where one stands for a term.
    pub role: &'static str,
    /// How much later all of it happens.
    pub later: i64,
}

/// First and last times.
pub const SPANS: [(i64, i64); 3] = [(0, 4), (-1, 2), (-3, 3)];

impl Claim {
    pub fn range(&self) -> (Q, Q) {
        let (a, b) = SPANS[self.span];
        (whole(a + self.later), whole(b + self.later))
    }

    /// All terms that stand in its texts.
    pub fn for_each_term(&mut self, f: &mut dyn FnMut(&mut Term)) {
        let statement = |s: &mut Statement, f: &mut dyn FnMut(&mut Term)| match s {
            Statement::Relation { sides, .. } => sides.iter_mut().flatten().for_each(f),
            Statement::Limit { of, .. } => f(of),
        };
        for s in self.assuming.iter_mut().flatten() {
            statement(s, f);
        }
        if let Some((l, r)) = &mut self.at {
            f(l);
            f(r);
        }
        for form in &mut self.forms {
            match form {
                Form::Always(t) | Form::Never(t) | Form::Eventually(t) => {
                    t.iter_mut().flatten().for_each(|s| statement(s, f));
                }
                Form::FirstIntegral(e) | Form::Defined(e) => e.iter_mut().flat_map(|(_, c)| c).for_each(&mut *f),
                Form::Solves(p, q) => {
                    f(p);
                    f(q);
                }
                Form::SameMotion(..) | Form::Independent(_) | Form::Exists { .. } => {}
            }
        }
    }

    /// What `k` stands for.
    fn named(&self) -> Option<Term> {
        let mut found = None;
        self.clone().for_each_term(&mut |t| found = found.take().or(t.named().cloned()));
        found
    }

    /// Its tables in a derivation file, under an id.
    pub fn toml(&self, id: &str) -> String {
        let mut out = String::new();
        let (from, to) = self.range();
        for form in &self.forms {
            match form {
                Form::Solves(p, q) => {
                    let (p, q) = (p.latex(), q.latex());
                    let _ = write!(
                        out,
                        "[system.{id}]\nstates = ['x', 'y']\nequations = ['\\dot x={p}', '\\dot y={q}']\n\n"
                    );
                }
                Form::SameMotion(x, (a, b)) => {
                    let _ = write!(
                        out,
                        "[[trajectory]]\nid = \"other-{id}\"\nformula = {{ 'x' = '{}', 'y' = 2 }}\nparameters = {{ 'a' = 1.5 \
                         }}\nspan = [{a}, {b}]\n\n",
                        x.latex(),
                    );
                }
                Form::Always(_)
                | Form::Never(_)
                | Form::Eventually(_)
                | Form::FirstIntegral(_)
                | Form::Defined(_)
                | Form::Independent(_)
                | Form::Exists { .. } => {}
            }
        }
        let _ = write!(out, "[[claim]]\nid = \"{id}\"\nsays = \"{id}\"\n");
        if let Some(named) = self.named() {
            let _ =
                writeln!(out, "symbols = {{ 'k' = {{ role = \"{}\", formula = '{}' }} }}", self.role, named.latex());
        }
        if self.scene == Scene::Box {
            if self.forms.iter().any(|f| matches!(f, Form::Exists { .. })) {
                out += "symbols = { 'u' = { role = \"parameter\" } }\n";
            }
            let _ = writeln!(out, "ranges = {{ 'x' = [{from}, {to}], 'y' = 2, 'a' = 1.5 }}");
        } else {
            let _ = writeln!(out, "trajectories = [\"{}\"]", trajectory_of(self));
        }
        if !self.assuming.is_empty() {
            let _ = writeln!(out, "assuming = [{}]", texts(&self.assuming));
        }
        if let Some((l, r)) = &self.at {
            let _ = writeln!(out, "at = '{}={}'", l.latex(), r.latex());
        }
        if self.throughout {
            out += "branches = \"throughout\"\n";
        }
        for form in &self.forms {
            let line = match form {
                Form::Always(t) => format!("always = [{}]", texts(t)),
                Form::Never(t) => format!("never = [{}]", texts(t)),
                Form::Eventually(t) => format!("eventually = [{}]", texts(t)),
                Form::FirstIntegral(e) => format!("first-integral = [{}]", terms(e)),
                Form::Defined(e) => format!("defined = [{}]", terms(e)),
                Form::Solves(..) => format!("solves = \"{id}\""),
                Form::SameMotion(..) => format!("same-motion = {{ as = \"other-{id}\", of = ['x'] }}"),
                Form::Independent(Some(b)) => {
                    let b = latex_number(b);
                    format!("independent = {{ functions = ['x^2-2\\cdot({b})\\cdot x+y', 'y'], subject-to = [] }}")
                }
                Form::Independent(None) => "independent = { functions = ['y', '2y'], subject-to = [] }".to_owned(),
                Form::Exists { range: (a, b), equation: (l, r), also, unique } => {
                    let mut such = vec![format!("'{}={}'", l.latex(), r.latex())];
                    if let Some((l, k, r)) = also.as_deref() {
                        such.push(format!("'{}{}{}'", l.latex(), k.latex(), r.latex()));
                    }
                    format!(
                        "exists = {{ unknowns = {{ 'u' = [{}, {}] }}, such-that = [{}], unique = {unique} }}",
                        toml_number(a),
                        toml_number(b),
                        such.join(", ")
                    )
                }
            };
            out += &line;
            out += "\n";
        }
        out
    }
}

fn quoted(parts: impl Iterator<Item = String>) -> String {
    parts.map(|t| format!("'{t}'")).collect::<Vec<_>>().join(", ")
}

fn texts(texts: &[Text]) -> String {
    quoted(texts.iter().map(latex_text))
}

fn terms(terms: &[Shaped]) -> String {
    quoted(terms.iter().map(|(s, c)| s.latex(c)))
}

fn trajectory_of(claim: &Claim) -> String {
    format!("{:?}-{:?}-{}-{}", claim.scene, claim.motion, claim.span, claim.later).to_lowercase()
}

/// The same term for a motion that is later by n.
pub fn later(term: &Term, n: i64) -> Term {
    let moved = |t: Term| match t {
        Term::T => super::term::sub(Term::T, Term::Number(whole(n))),
        Term::At(e, c) => Term::At(e, c + whole(n)),
        t => t,
    };
    if n == 0 { term.clone() } else { term.map(&moved) }
}

/// The motion of a claim, with what it is made from.
fn trajectory(claim: &Claim) -> String {
    let name = trajectory_of(claim);
    let (from, to) = claim.range();
    let shown = |t: Term| later(&t, claim.later).latex();
    let (x, rate) = (shown(claim.motion.term()), shown(claim.motion.rate()));
    let start = claim.motion.at(&(&from - whole(claim.later)));
    match claim.scene {
        Scene::Integrated => format!(
            r#"[system.{name}]
states = ['x', 'y']
equations = ['\dot x={rate}', '\dot y=0']

[[trajectory]]
id = "{name}"
system = "{name}"
parameters = {{ 'a' = 1.5 }}
initial = {{ 'x' = {start}, 'y' = 2 }}
initial-time = {from}
span = [{from}, {to}]

"#
        ),
        Scene::Formula => format!(
            r#"[[trajectory]]
id = "{name}"
formula = {{ 'x' = '{x}', 'y' = 2 }}
parameters = {{ 'a' = 1.5 }}
span = [{from}, {to}]

"#
        ),
        Scene::Derived => format!(
            r#"[[trajectory]]
id = "shifted-{name}"
formula = {{ 'x' = '{x}+1', 'y' = 1 }}
parameters = {{ 'a' = 1.5 }}
span = [{from}, {to}]

[[trajectory]]
id = "{name}"
from = "shifted-{name}"
map = {{ 'x' = 'x-1', 'y' = '2y' }}

"#
        ),
        Scene::Box | Scene::All => String::new(),
    }
}

/// A file with the motions of all scenes, and these claims.
pub fn file(claims: &[(String, &Claim)]) -> String {
    let mut out = r#"[derivation]
title = "Random claims"
concerns = "rederive's own tests"

[symbols]
't' = { role = "time" }
'a' = { role = "parameter" }
'x' = { role = "state" }
'y' = { role = "state" }

"#
    .to_owned();
    let motions: BTreeSet<String> = claims.iter().map(|(_, c)| trajectory(c)).collect();
    out.extend(motions);
    for (id, claim) in claims {
        out += &claim.toml(id);
        out += "\n";
    }
    out
}
