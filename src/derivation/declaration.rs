//! Symbols typed on a command line, in the words of `[symbols]`.
//!
//! A declaration is `NAMES`, `NAMES: WORDS`, `NAME = FORMULA` or `NAME: WORDS = FORMULA`. Names are separated by commas; words,
//! too: a role, a shape, `positive`, `angle`, or `constant` for a parameter with a fixed value. Without a role a symbol is a parameter, with a formula an abbreviation. For
//! instance `x, y`, `I: diagonal 3, positive`, `\theta: state`, `r = \sqrt{x^2+y^2}`, `f(\alpha) = \sin\alpha`. The formula of a coordinate
//! is its scale factor, `\theta: coordinate = r`; a momentum says of what it is one, `p: state, momentum of q`.
//!
//! Where a state or an observable is declared, and no time, `t` is the time. What stands in the parentheses of a field,
//! `u(x,t): field`, and is not declared, is a coordinate.

use std::ops::Range;
use std::sync::Arc;

use super::constants::exact_value;
use super::list::Shared;
use super::load::declared;
use super::model::{Derivation, SymbolEntry};
use super::symbols::{CONSTANT, ROLES, parse_shape};
use super::table::as_printed;
use diag::{Diagnostic, Source, nearest};
use expr::{Graph, Shape};
use latex::{Declaration, DeclareError, Role, Scope};

impl Derivation {
    /// A derivation that says nothing: no symbols, no claims.
    pub fn blank() -> Derivation {
        let mut graph = Graph::new();
        let scope = Scope::new(&mut graph);
        Derivation {
            id: String::new(),
            title: String::new(),
            concerns: String::new(),
            source: None,
            remark: None,
            encoded_by: None,
            file: Arc::new(Source { path: String::new(), text: String::new() }),
            sha256: String::new(),
            work: 0,
            conventions: Vec::new(),
            symbols: Vec::new(),
            graph,
            scope,
            systems: Vec::new(),
            trajectories: Shared::default(),
            families: Arc::default(),
            domains: Vec::new(),
            claims: Shared::default(),
            measures: Vec::new(),
            conditions: Vec::new(),
            pictures: Vec::new(),
            given: Vec::new(),
            index: super::premise::Index::default(),
        }
    }

    /// Declares typed symbols, each text on its own, in their order; `shown` is what each is called in problems.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn declare_typed(&mut self, texts: &[(String, String)]) -> Result<(), Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let mut all = Vec::new();
        for (shown, text) in texts {
            let source = Arc::new(Source { path: shown.clone(), text: text.clone() });
            match Typed::read(&source) {
                Ok(typed) => all.push((source, typed)),
                Err(problem) => problems.push(*problem),
            }
        }
        let moves = all.iter().any(|(_, t)| matches!(t.role, Role::State | Role::Observable));
        let taken = |t: &Typed| t.role == Role::Time || t.names.iter().any(|(name, _)| name == "t");
        if moves
            && self.scope.time().is_none()
            && self.scope.symbol("t").is_none()
            && !all.iter().any(|(_, t)| taken(t))
        {
            let source = Arc::new(Source { path: String::new(), text: "t: time".to_owned() });
            if let Ok(typed) = Typed::read(&source) {
                all.insert(0, (source, typed));
            }
        }
        // What depends on others comes behind them: fields on coordinates, formulas on anything.
        all.sort_by_key(|(_, t)| match (t.role, &t.formula) {
            (Role::Coordinate, _) => 1,
            (Role::Field, None) => 2,
            (Role::Field, Some(_)) => 4,
            (_, formula) => {
                if formula.is_some() {
                    3
                } else {
                    0
                }
            }
        });
        let coordinates = self.unnamed_coordinates(&all);
        all.splice(0..0, coordinates);
        let mut paired = false;
        for (source, typed) in &all {
            // Formulas may have brackets, and stand behind all that has none.
            if !paired && problems.is_empty() && typed.formula.is_some() && typed.role != Role::Coordinate {
                problems.extend(self.pair_typed(&all));
                paired = true;
            }
            for (name, span) in &typed.names {
                if let Err(found) = self.declare_one(source, typed, name, span) {
                    problems.extend(found);
                }
            }
        }
        if !paired && problems.is_empty() {
            problems = self.pair_typed(&all);
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    /// Joins momenta to their coordinates, all being declared. What is wrong with them.
    fn pair_typed(&mut self, all: &[(Arc<Source>, Typed)]) -> Vec<Diagnostic> {
        let mut problems = Vec::new();
        for (source, typed) in all {
            let Some((of, start)) = &typed.momentum_of else { continue };
            let Some(momentum) = typed.names.first().and_then(|(name, _)| self.scope.symbol(name)) else { continue };
            match self.scope.set_momentum(&self.graph, momentum, of) {
                Ok(()) => {}
                Err(DeclareError::Key(found)) => problems.push(Diagnostic::of_formula(source, *start, found)),
                Err(DeclareError::Formula(found)) => {
                    problems.extend(found.into_iter().map(|p| Diagnostic::of_formula(source, *start, p)));
                }
            }
        }
        problems
    }

    /// What stands in the parentheses of fields and is not declared: coordinates, and `t` is the time.
    fn unnamed_coordinates(&self, all: &[(Arc<Source>, Typed)]) -> Vec<(Arc<Source>, Typed)> {
        let mut out: Vec<(Arc<Source>, Typed)> = Vec::new();
        // The order of coordinates with scale factors is said by whoever declares them: a curl depends on it.
        if all.iter().any(|(_, t)| t.role == Role::Coordinate && t.formula.is_some()) {
            return out;
        }
        for (_, field) in all.iter().filter(|(_, t)| t.role == Role::Field) {
            for (name, _) in &field.names {
                for one in inside(name) {
                    let among = |list: &[(Arc<Source>, Typed)]| {
                        list.iter().any(|(_, t)| t.names.iter().any(|(known, _)| *known == one))
                    };
                    // A rate is no coordinate, but a place of a function of what moves.
                    let is_rate = one.starts_with(r"\dot") || one.starts_with(r"\ddot");
                    if one.is_empty() || is_rate || self.scope.symbol(&one).is_some() || among(all) || among(&out) {
                        continue;
                    }
                    let timeless = self.scope.time().is_none() && !all.iter().any(|(_, t)| t.role == Role::Time);
                    let role = if one == "t" && timeless { "time" } else { "coordinate" };
                    let source = Arc::new(Source { path: String::new(), text: format!("{one}: {role}") });
                    if let Ok(typed) = Typed::read(&source) {
                        out.push((source, typed));
                    }
                }
            }
        }
        out
    }

    fn declare_one(
        &mut self,
        source: &Arc<Source>,
        typed: &Typed,
        name: &str,
        span: &Range<usize>,
    ) -> Result<(), Vec<Diagnostic>> {
        if self.scope.symbol(name).is_some() {
            let message = format!("`{name}` is declared already");
            return Err(vec![Diagnostic::at(source, "derivation::duplicate-id", span.clone(), message)]);
        }
        let arguments = typed.arguments(name, &self.scope);
        let names: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let mut formula = typed.formula.as_ref().map(|(text, _)| text.as_str());
        if typed.constant && formula.is_none() {
            let (_, value, ..) = exact_value(name).map_err(|(message, hint)| {
                vec![Diagnostic::at(source, "derivation::bad-role", span.clone(), message).hint(hint)]
            })?;
            formula = Some(value);
        }
        let (shape, diagonal) = typed.shape.clone().map_or((None, false), |(shape, d)| (Some(shape), d));
        let Typed { role, complex, angle, labelled, .. } = *typed;
        let declaration = Declaration { role, shape, diagonal, formula, arguments: &names, complex, angle, labelled };
        let symbol = declared(formula, || self.scope.declare(&mut self.graph, name, declaration)).map_err(|error| {
            let at = |start: usize, found: Vec<diag::Problem>| {
                found.into_iter().map(|p| Diagnostic::of_formula(source, start, p)).collect::<Vec<_>>()
            };
            match error {
                DeclareError::Key(problem) => at(span.start, vec![problem]),
                DeclareError::Formula(found) => at(typed.formula.as_ref().map_or(0, |(_, start)| *start), found),
            }
        })?;
        if typed.velocity
            && let Err(DeclareError::Key(found)) = self.scope.set_velocity(name, symbol)
        {
            return Err(vec![Diagnostic::of_formula(source, span.start, found)]);
        }
        let constant = self.scope.definition(symbol).and_then(|t| t.as_scalar()).filter(|_| typed.constant);
        if typed.constant && !constant.is_some_and(|value| self.graph.leaves_within([value]).is_empty()) {
            let message = format!("the value of the constant `{name}` is not a number");
            return Err(vec![Diagnostic::at(source, "derivation::bad-role", span.clone(), message)]);
        }
        self.symbols.push(SymbolEntry {
            name: as_printed(name),
            symbol,
            role: typed.role,
            unit: None,
            measured_in: None,
            positive: typed.positive || typed.constant && typed.formula.is_none(),
            angle: typed.angle,
            complex: typed.complex,
            formula: formula.filter(|_| typed.role != Role::Coordinate).map(as_printed),
            scale: formula.filter(|_| typed.role == Role::Coordinate).map(as_printed),
            arguments,
            says: None,
            span: span.clone(),
        });
        Ok(())
    }
}

/// Words before the coordinate to which a momentum belongs.
const MOMENTUM: &str = "momentum of ";

/// The word for the field with which D/Dt moves.
const VELOCITY: &str = "velocity";

/// One declaration.
struct Typed {
    /// Names, with their places.
    names: Vec<(String, Range<usize>)>,
    role: Role,
    /// A parameter with a fixed value.
    constant: bool,
    shape: Option<(Shape, bool)>,
    positive: bool,
    angle: bool,
    labelled: bool,
    complex: bool,
    /// The field with which D/Dt moves.
    velocity: bool,
    /// The coordinate whose momentum it is, and where that begins.
    momentum_of: Option<(String, usize)>,
    /// The formula, and where it begins.
    formula: Option<(String, usize)>,
}

/// The place of a part without the blanks around it.
fn trimmed(text: &str, range: Range<usize>) -> Range<usize> {
    let part = &text[range.clone()];
    let start = range.start + (part.len() - part.trim_start().len());
    start..start + part.trim().len()
}

/// The parts of a text between commas that stand in no bracket.
fn parts(text: &str, range: Range<usize>) -> Vec<Range<usize>> {
    let (mut out, mut depth, mut from) = (Vec::new(), 0i32, range.start);
    for (at, c) in text[range.clone()].char_indices() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                out.push(trimmed(text, from..range.start + at));
                from = range.start + at + 1;
            }
            _ => {}
        }
    }
    out.push(trimmed(text, from..range.end));
    out
}

impl Typed {
    fn read(source: &Arc<Source>) -> Result<Typed, Box<Diagnostic>> {
        let text = source.text.as_str();
        let problem = |span: Range<usize>, code, message: String, hint: &str| {
            let d = Diagnostic::at(source, code, span, message);
            Box::new(if hint.is_empty() { d } else { d.hint(hint) })
        };
        let equals = text.find('=');
        let head = 0..equals.unwrap_or(text.len());
        let colon = text[head.clone()].find(':');
        let names: Vec<(String, Range<usize>)> =
            parts(text, 0..colon.unwrap_or(head.end)).into_iter().map(|r| (text[r.clone()].to_owned(), r)).collect();
        if let Some((_, span)) = names.iter().find(|(name, _)| name.is_empty()) {
            let hint = "for instance 'x', 'x, y: positive', 'I: diagonal 3', 'q: state' or 'r = x+y'";
            return Err(problem(span.clone(), "derivation::missing-key", "a name is missing".into(), hint));
        }
        let formula = equals.map(|at| {
            let range = trimmed(text, at + 1..text.len());
            (text[range.clone()].to_owned(), range.start)
        });
        let mut out = Typed {
            role: if formula.is_some() { Role::Abbreviation } else { Role::Parameter },
            names,
            constant: false,
            shape: None,
            positive: false,
            angle: false,
            labelled: false,
            complex: false,
            velocity: false,
            momentum_of: None,
            formula,
        };
        let words = colon.map_or(Vec::new(), |at| parts(text, at + 1..head.end));
        let (mut positive, mut complex) = (0..0, 0..0);
        for span in words {
            let word = &text[span.clone()];
            if let Some(of) = word.strip_prefix(MOMENTUM) {
                out.momentum_of = Some((of.to_owned(), span.start + MOMENTUM.len()));
                continue;
            }
            match (word, ROLES.iter().find(|(known, _)| *known == word), parse_shape(word)) {
                ("positive", ..) => (out.positive, positive) = (true, span),
                ("angle", ..) => out.angle = true,
                ("labelled", ..) => out.labelled = true,
                (VELOCITY, ..) => out.velocity = true,
                ("complex", ..) => (out.complex, complex) = (true, span),
                (CONSTANT, ..) => (out.constant, out.role) = (true, Role::Parameter),
                (_, Some((_, role)), _) => out.role = *role,
                (_, None, Some(shape)) => out.shape = Some(shape),
                _ => {
                    let known = [
                        CONSTANT,
                        "positive",
                        "angle",
                        "labelled",
                        "complex",
                        VELOCITY,
                        "momentum of q",
                        "diagonal 3",
                        "3x3",
                    ];
                    let known = ROLES.iter().map(|(word, _)| *word).chain(known);
                    // Several words without commas, as the tables of the documentation have them.
                    let several: Vec<&str> = word.split_whitespace().collect();
                    let says = |w: &&str| parse_shape(w).is_some() || known.clone().any(|k| k == *w);
                    let hint = match nearest(word, known.clone()) {
                        _ if several.len() > 1 && several.iter().all(says) => {
                            format!("write commas between the words: `{}`", several.join(", "))
                        }
                        Some(near) => format!("did you mean `{near}`?"),
                        None => format!("known: {}", known.collect::<Vec<_>>().join(", ")),
                    };
                    let message = format!("`{word}` says nothing about a symbol");
                    return Err(problem(span, "derivation::bad-role", message, &hint));
                }
            }
        }
        let defined = matches!(out.role, Role::Observable | Role::Abbreviation);
        if out.constant
            && (out.role != Role::Parameter
                || out.positive
                || out.angle
                || out.labelled
                || out.complex
                || out.shape.is_some())
        {
            let message = "a constant is one real number, and nothing else".to_owned();
            return Err(problem(head, "derivation::bad-role", message, "write 'c: constant', or 'g: constant = 9.81'"));
        }
        if !out.constant && defined != out.formula.is_some() && !matches!(out.role, Role::Field | Role::Coordinate) {
            let message =
                if defined { "this needs a formula, after `=`" } else { "a symbol of this role has no formula" };
            let hint = "observables and abbreviations are defined by a formula, fields may be, nothing else is";
            return Err(problem(head, "derivation::bad-role", message.into(), hint));
        }
        if out.momentum_of.is_some() && out.names.len() > 1 {
            let span = out.names[1].1.clone();
            let hint = "declare each momentum by itself";
            return Err(problem(span, "derivation::bad-role", "a coordinate has one momentum".into(), hint));
        }
        if out.formula.is_some() && out.names.len() > 1 {
            let span = out.names[1].1.clone();
            return Err(problem(span, "derivation::bad-role", "a formula defines one symbol".into(), ""));
        }
        let diagonal = out.shape.as_ref().is_some_and(|(_, diagonal)| *diagonal);
        if out.complex && (out.positive || out.angle || diagonal || out.role == Role::Time) {
            let message = "nothing complex is positive, an angle, diagonal or the time".to_owned();
            return Err(problem(complex, "derivation::bad-role", message, "leave one of the two out"));
        }
        if out.positive && out.role != Role::Parameter {
            let message = "only parameters are declared positive".to_owned();
            return Err(problem(positive, "derivation::bad-role", message, "write it as a premise: --given 'x>0'"));
        }
        Ok(out)
    }

    /// The formal arguments of a function: what stands in the parentheses of its name and is not declared.
    fn arguments(&self, name: &str, scope: &Scope) -> Vec<String> {
        if self.formula.is_none() || self.role == Role::Field {
            return Vec::new();
        }
        inside(name).into_iter().filter(|n| !n.is_empty() && scope.symbol(n).is_none()).collect()
    }
}

/// What stands in the parentheses of a name.
fn inside(name: &str) -> Vec<String> {
    let Some(open) = name.find('(').filter(|_| name.ends_with(')')) else { return Vec::new() };
    parts(name, open + 1..name.len() - 1).into_iter().map(|r| name[r].to_owned()).collect()
}
