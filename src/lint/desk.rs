//! One step of a paper, read: the names that it needs are declared from what the paper shows, and nothing else is.
//!
//! **In:** the sides of a step, what is defined and what rates are known, and the [`Evidence`] of the paper. **Out:** a [`Desk`]: a
//! graph and a scope of its own, so that no formula can spoil another. **Guaranteed:** what could be an operator, a function
//! of anything, a sum over indices or a difference is not read as a product of numbers: it is [`NotRead`], with the name of the
//! feature.

use std::collections::BTreeSet;

use super::held::constants_apart;
use super::letters::{is_charge, shape_of};
use super::lone::{bare, undotted, unprimed};
use super::obstacle::{is_place, obstacle};
use expr::{Expr, Graph, Leaf, Symbol};
use latex::{Declaration, Role, Scope, Statement};
use meter::Limits;
use paper::{Call, Paper, PaperName, PrintedSide, names};

use super::notation::Evidence;
use super::primes::{place_of_definition, primed_by};
use super::refusal::{NotRead, refusal, refused};
use super::space::{General, coordinates_for};
use paper::squeezed;

/// Longest side, in bytes, that is looked at for evidence.
const LONGEST_SIDE: usize = 20_000;

/// A formula with the key that it defines, or of which it gives the rate.
#[derive(Clone, Debug)]
pub struct Given {
    /// The key of the name that is defined, or whose rate is given.
    pub key: String,
    /// How the left side is printed.
    pub left: PrintedSide,
    /// What it is.
    pub right: PrintedSide,
    /// The relation that says so, by its number in the paper.
    pub relation: usize,
    /// Whether the rate is given.
    pub is_rate: bool,
    /// The section in which it is.
    pub section: usize,
}

/// A graph with the symbols of one step.
pub struct Desk {
    /// Where the formulas are.
    pub graph: Graph,
    /// What is declared.
    pub scope: Scope,
    /// The independent variable, where there is one.
    pub time: Option<Leaf>,
    /// What depends on it.
    pub moving: Vec<Symbol>,
    /// Every number that is declared, by its key, and whether it is a parameter.
    pub scalars: Vec<(String, Symbol, bool)>,
    /// Whether the imaginary unit occurs: then the names may be complex.
    pub is_complex: bool,
    /// What is read more generally than it is meant: what refutes it then says nothing.
    pub general: General,
    /// Names that are held fixed in what is derived, and by what it is derived, which the paper does not say.
    pub held: BTreeSet<(String, String)>,
    /// The relations whose definitions were used.
    pub used: Vec<usize>,
    /// The limits of questions: all of a paper together may take as much as a file may.
    pub limits: Limits,
}

/// The independent variable by which the names of a step are derived, if there is just one.
fn variable(all: &[PaperName], given: &[&Given], evidence: &Evidence) -> Result<Option<String>, NotRead> {
    let mut found: BTreeSet<String> = BTreeSet::new();
    for name in all {
        if let Some(by) = primed_by(name, all, given, evidence) {
            found.insert(by);
        }
        if is_value(name) {
            let of_definition = place_of_definition(&name.key(), given);
            found.extend(of_definition.or_else(|| variable_here(name, all, evidence)));
        }
        if name.dots > 0 {
            found.insert("t".to_owned());
        }
        if let (Some(by), false) = (&name.derived_by, name.is_partial) {
            found.insert(by.clone());
        }
    }
    match found.len() {
        0 => Ok(None),
        1 => Ok(found.pop_first()),
        _ => Err(NotRead::of("derivatives by several variables")),
    }
}

/// Whether a name stands at a number: `y(0)`.
fn is_value(name: &PaperName) -> bool {
    matches!(&name.call, Call::Places(places) if places.len() == 1 && !is_place(places))
}

/// The variable of a name that stands at a number: that of a step, or, where the step has none, which of them it is does not matter.
fn variable_here(name: &PaperName, all: &[PaperName], evidence: &Evidence) -> Option<String> {
    let known = evidence.variables_of(name);
    let mut here = known.keys().filter(|by| all.iter().any(|n| n.key() == **by));
    match (here.next(), here.next()) {
        (Some(one), None) => Some(one.clone()),
        (Some(_), Some(_)) => None,
        (None, _) => known.into_iter().max_by_key(|(by, n)| (*n, std::cmp::Reverse(by.clone()))).map(|(by, _)| by),
    }
}

/// The evidence of a paper for rates: names with a dot, and those right behind the `d` of a derivative. What stands in parentheses behind
/// `d/dt` may be constant.
pub fn evidence_of(paper: &Paper, limits: &Limits) -> Evidence {
    let mut evidence = paper::Evidence::of(paper);
    let mut dotted: BTreeSet<String> = BTreeSet::new();
    let mut direct: BTreeSet<(String, String)> = BTreeSet::new();
    for side in paper.printed.iter().flat_map(|r| &r.sides).filter(|s| s.text.len() <= LONGEST_SIDE) {
        let text = bare(&squeezed(&side.text));
        for name in names(side) {
            let key = name.key();
            if name.dots > 0 {
                dotted.insert(key.clone());
            }
            if let (Some(by), false) = (&name.derived_by, name.is_partial) {
                let (k, v) = (bare(&squeezed(&key)), squeezed(by));
                let printed = [
                    format!("fracd{k}d{v}"),
                    format!("fracd2{k}d{v}"),
                    format!("fracdd{v}{k}"),
                    format!(r"\dv{k}{v}"),
                    format!("d{k}/d{v}"),
                ];
                if printed.iter().any(|p| text.contains(p)) {
                    direct.insert((key, by.clone()));
                }
            }
        }
    }
    let is_direct = |key: &String, by: &str| direct.contains(&(key.clone(), by.to_owned()));
    evidence.moving.retain(|key| dotted.contains(key) || is_direct(key, "t"));
    Evidence::new(paper, evidence, limits)
}

/// Whether a definition has something in it that varies with the independent variable: of what has nothing, that a rate is taken shows
/// that some name of it is not a constant, and it is not known which.
fn varies(one: &Given, given: &[&Given], evidence: &Evidence, time: &str) -> bool {
    let mut keys: Vec<String> = names(&one.right).into_iter().map(|n| n.key()).collect();
    let mut at = 0;
    while let Some(key) = keys.get(at).cloned() {
        at += 1;
        let moves = key == time
            || time == "t" && evidence.moving.contains(&key)
            || evidence.derived.get(&key).is_some_and(|by| by.contains(time))
            || evidence.calls.get(&key).is_some_and(|c| c.contains_key(&Some(vec![time.to_owned()])));
        let is_defined = given.iter().any(|g| g.key == key && !g.is_rate);
        if moves && !is_defined || given.iter().any(|g| g.key == key && g.is_rate) {
            return true;
        }
        let more = given.iter().filter(|g| g.key == key && !g.is_rate).flat_map(|g| names(&g.right)).map(|n| n.key());
        let more: Vec<String> = more.filter(|k| !keys.contains(k)).collect();
        keys.extend(more);
    }
    false
}

/// The keys of what is defined by others, down to what has no definition.
pub(super) fn inside(keys: &[String], given: &[&Given]) -> Vec<String> {
    let mut out = keys.to_vec();
    let mut at = 0;
    while let Some(key) = out.get(at).cloned() {
        at += 1;
        let more = given.iter().filter(|g| g.key == key && !g.is_rate).flat_map(|g| names(&g.right)).map(|n| n.key());
        let more: Vec<String> = more.filter(|k| !out.contains(k)).collect();
        out.extend(more);
    }
    out.split_off(keys.len())
}

/// Whether a definition, or what it names, names a variable, or that of which the variable is a rate.
pub(super) fn names_variable(key: &str, by: &str, given: &[&Given]) -> bool {
    let key = key.to_owned();
    let of = [r"\dot", r"\ddot"].iter().find_map(|dots| by.strip_prefix(dots)).map_or(by, str::trim_start);
    inside(std::slice::from_ref(&key), given).iter().chain([&key]).any(|k| k == of)
}

/// By what a name is derived, partially or as a whole.
pub(super) fn derived_by(name: &PaperName, is_partial: bool) -> Option<&str> {
    match &name.derived_by {
        Some(by) => (name.is_partial == is_partial).then_some(by.as_str()),
        None => (name.dots > 0 && !is_partial).then_some("t"),
    }
}

/// Whether what a step derives is known to depend on what it is derived by.
fn rates_are_given(
    all: &[PaperName],
    given: &[&Given],
    evidence: &Evidence,
    time: Option<&str>,
) -> Result<(), NotRead> {
    if let Some(time) = time {
        for one in given.iter().filter(|g| !g.is_rate) {
            let is_derived =
                |n: &PaperName| n.key() == one.key && (n.dots > 0 || n.derived_by.as_deref() == Some(time));
            if all.iter().any(is_derived) && !varies(one, given, evidence, time) {
                return Err(NotRead::of(format!("a rate of {}, which is defined by what has none", one.key)));
            }
        }
    }
    // Of what has no formula it is not known what else changes with the variable: its partial derivative is another one than the total one.
    for name in all {
        let Some(by) = derived_by(name, true) else { continue };
        let key = name.key();
        let is_total = |n: &PaperName| n.key() == key && derived_by(n, false) == Some(by);
        if all.iter().any(is_total) && !given.iter().any(|g| g.key == key && !g.is_rate) {
            return Err(NotRead::of(format!(
                "a partial derivative of {key} beside the total one: what is held fixed is not known"
            )));
        }
    }
    // The same of what is derived partially: that names in its definition do not depend on the variable is nowhere said.
    for name in all.iter().filter(|n| n.is_partial) {
        let Some(by) = &name.derived_by else { continue };
        let key = name.key();
        if given.iter().any(|g| g.key == key && !g.is_rate) && !names_variable(&key, by, given) {
            return Err(NotRead::of(format!("a derivative of {key} by {by}, which its definition does not name")));
        }
    }
    if time == Some("t") {
        let rate_of = |n: &&PaperName| n.dots > 0 || n.derived_by.as_deref() == Some("t") && !n.is_partial;
        let derived: Vec<String> = all.iter().filter(rate_of).map(PaperName::key).collect();
        let is_known =
            |key: &String| given.iter().any(|g| g.key == *key) || all.iter().any(|n| n.dots > 0 && n.key() == *key);
        let is_unknown = |key: &String| key != "t" && evidence.varies(key) && !is_known(key);
        if let Some(key) = inside(&derived, given).into_iter().find(is_unknown) {
            return Err(NotRead::of(format!("a rate of {key}, which the paper does not give")));
        }
    }
    Ok(())
}

/// What a lone `i` is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// The imaginary unit: other names are real.
    Imaginary,
    /// A number like the others: what holds then holds for complex names, too.
    Number,
}

impl Desk {
    /// Declares the names of a step, those of what is given among them.
    ///
    /// # Errors
    /// The feature that is not understood.
    pub fn new(
        sides: &[&PrintedSide],
        given: &[&Given],
        evidence: &Evidence,
        free: &BTreeSet<char>,
    ) -> Result<Desk, NotRead> {
        Desk::with_unit(sides, given, evidence, free, Unit::Imaginary)
    }

    /// The same, where it is said what a lone `i` is.
    ///
    /// # Errors
    /// The feature that is not understood.
    pub fn with_unit(
        sides: &[&PrintedSide],
        given: &[&Given],
        evidence: &Evidence,
        free: &BTreeSet<char>,
        unit: Unit,
    ) -> Result<Desk, NotRead> {
        let own: Vec<PaperName> = sides.iter().flat_map(|s| names(s)).map(undotted).collect();
        if let Some(found) = obstacle(sides, &own, evidence, free) {
            return Err(found);
        }
        let mut all = own;
        for one in given {
            let more: Vec<PaperName> = [&one.left, &one.right].into_iter().flat_map(names).map(undotted).collect();
            if let Some(found) = obstacle(&[&one.right], &more, evidence, free) {
                return Err(found);
            }
            all.extend(more);
        }
        // Beside partial derivatives `\Delta f` is a Laplacian, of coordinates that need not all be printed.
        if all.iter().any(|n| n.is_partial) && all.iter().any(|n| n.difference_sign().is_some()) {
            return Err(NotRead::of("a difference, or a Laplacian"));
        }
        let time = variable(&all, given, evidence)?;
        let partial = all.iter().filter(|n| n.is_partial).filter_map(|n| n.derived_by.clone());
        let by: BTreeSet<String> = partial.chain(time.clone()).collect();
        let mut held: BTreeSet<(String, String)> =
            by.iter().flat_map(|by| constants_apart(&mut all, evidence, by)).collect();
        held.retain(|(key, _)| !given.iter().any(|g| g.key == *key));
        rates_are_given(&all, given, evidence, time.as_deref())?;
        // A prime of a function of one variable is its derivative; there, `t` has primes too.
        let has_derived_primes = all.iter().any(|n| primed_by(n, &all, given, evidence).is_some());
        let mut all: Vec<PaperName> = all
            .iter()
            .map(|n| match primed_by(n, &all, given, evidence) {
                Some(by) => PaperName { derived_by: Some(by), is_partial: false, ..unprimed(n) },
                None => n.clone(),
            })
            .collect();
        if time.is_some() {
            all.sort_by_key(|n| n.derived_by.is_none());
        }
        let mut graph = Graph::new();
        let mut scope = Scope::new(&mut graph);
        if let Some(logarithm) = evidence.logarithm() {
            scope.set_logarithm(logarithm);
        }
        let mut desk = Desk {
            graph,
            scope,
            time: None,
            moving: Vec::new(),
            scalars: Vec::new(),
            is_complex: false,
            general: General { constants: !held.is_empty(), fields: false, vectors: all.iter().any(|n| n.has_hat) },
            held,
            used: Vec::new(),
            limits: evidence.limits().clone(),
        };
        let texts = || sides.iter().map(|s| s.text.as_str());
        // `i` beside no other use is the imaginary unit.
        let prints_pi = |text: &str| text.split(r"\pi").skip(1).any(|rest| !rest.starts_with(char::is_alphabetic));
        let is_printed = |letter: &str| match letter {
            "i" => all.iter().any(|n| n.key() == "i"),
            _ => sides.iter().any(|s| prints_pi(&s.text)),
        };
        let is_meant = |letter: &&&str| evidence.is_other_constant(letter) && is_printed(letter);
        if let Some(letter) = ["i", r"\pi"].iter().find(is_meant) {
            return Err(NotRead::of(format!("{letter}, which is a constant, or what the paper says of it")));
        }
        let imaginary = all.iter().any(|n| n.key() == "i");
        if imaginary && unit == Unit::Imaginary {
            desk.is_complex = true;
            desk.scope.set_imaginary();
            if texts().any(|t| t.contains('|')) {
                return Err(NotRead::of("an absolute value of what may be complex"));
            }
        }
        let whole: Vec<&str> = texts().chain(given.iter().map(|g| g.right.text.as_str())).collect();
        if is_charge(&whole) && !all.iter().any(|n| n.key() == "e") {
            let declared =
                desk.scope.declare(&mut desk.graph, "e", Declaration::of(Role::Parameter)).map_err(refused)?;
            desk.scalars.push(("e".to_owned(), declared, true));
        }
        // Of what the paper shows as a function a prime derives, also by the time.
        if time.is_some() && has_derived_primes {
            desk.scope.set_primes();
        }
        let place = sides.first().map_or(0, |s| s.span.start);
        let by: BTreeSet<String> = all.iter().filter(|n| n.is_partial).filter_map(|n| n.derived_by.clone()).collect();
        let printed = || sides.iter().copied().chain(given.iter().map(|g| &g.right));
        let space = coordinates_for(printed(), &by, time.as_deref());
        desk.general.fields = !space.is_empty();
        desk.declare(&all, given, (evidence, place), time.as_deref(), space)?;
        Ok(desk)
    }

    fn declare(
        &mut self,
        all: &[PaperName],
        given: &[&Given],
        (evidence, place): (&Evidence, usize),
        time: Option<&str>,
        space: &[&str],
    ) -> Result<(), NotRead> {
        let defined: BTreeSet<&str> = given.iter().filter(|g| !g.is_rate).map(|g| g.key.as_str()).collect();
        // By what something that is not defined is derived partially: the coordinates.
        let mut coordinates: BTreeSet<String> = space.iter().map(|&by| by.to_owned()).collect();
        for name in all.iter().filter(|n| n.is_partial) {
            let key = name.key();
            if !defined.contains(key.as_str()) {
                coordinates.extend(name.derived_by.clone());
            }
        }
        if let Some(time) = time {
            let declared = self.scope.declare(&mut self.graph, time, Declaration::of(Role::Time)).map_err(refused)?;
            self.time = Some(Leaf::now(declared, 0));
        }
        for key in coordinates.iter().filter(|k| Some(k.as_str()) != time) {
            let varies = |n: &PaperName| n.dots > 0 || n.derived_by.as_ref().is_some_and(|by| by != key);
            if all.iter().any(|n| n.key() == *key && varies(n)) {
                return Err(NotRead::of(format!("a derivative by {key}, which depends on others")));
            }
            self.scope.declare(&mut self.graph, key, Declaration::of(Role::Coordinate)).map_err(refused)?;
        }
        let mut seen: BTreeSet<String> = BTreeSet::new();
        for name in all {
            let key = name.key();
            let skipped = key == "i" && self.is_complex
                || Some(key.as_str()) == time
                || coordinates.contains(&key)
                || defined.contains(key.as_str())
                || name.letter == "e" && name.base != "e" && !name.is_bold
                || key == r"\pi";
            if skipped {
                continue;
            }
            let (declared, moves, is_field) = self.role_of(name, &key, all, evidence, time, (&coordinates, space))?;
            if !seen.insert(declared.clone()) {
                continue;
            }
            let role = if is_field {
                Role::Field
            } else if moves {
                Role::State
            } else {
                Role::Parameter
            };
            let shape = shape_of(name, &key, evidence, place).filter(|_| !is_field || name.is_bold);
            let declaration = Declaration { shape: shape.clone(), ..Declaration::of(role) };
            let symbol = self.scope.declare(&mut self.graph, &declared, declaration).map_err(refused)?;
            if role == Role::State {
                self.moving.push(symbol);
            }
            if shape.is_none() && !is_field {
                let varies = evidence.moving.contains(&key)
                    || evidence.derived.contains_key(&key)
                    || evidence.partial.contains_key(&key)
                    || evidence.calls.get(&key).is_some_and(|c| c.keys().flatten().any(|p| is_place(p)));
                self.scalars.push((key, symbol, role == Role::Parameter && !varies));
            }
        }
        // A definition stands behind those that it needs.
        for one in given.iter().filter(|g| !g.is_rate) {
            let dotted = one.right.with_factors(&|letter: &str| !evidence.may_be_function(letter));
            let mut declare = |text: &str| {
                let declaration = Declaration { formula: Some(text), ..Declaration::of(Role::Abbreviation) };
                self.scope.declare(&mut self.graph, &one.key, declaration)
            };
            declare(&one.right.text).or_else(|_| declare(&dotted)).map_err(refused)?;
            self.used.push(one.relation);
        }
        Ok(())
    }

    /// The key under which a name is declared, whether it depends on the independent variable, and whether it is a field.
    fn role_of(
        &self,
        name: &PaperName,
        key: &str,
        all: &[PaperName],
        evidence: &Evidence,
        time: Option<&str>,
        (coordinates, space): (&BTreeSet<String>, &[&str]),
    ) -> Result<(String, bool, bool), NotRead> {
        // Of ∇ everything is a field; and a unit vector may turn.
        let is_any = !space.is_empty() || name.has_hat && !coordinates.is_empty();
        if is_any || is_field(name, key, all, evidence, coordinates) {
            let places: Vec<String> = coordinates
                .iter()
                .cloned()
                .chain(time.filter(|t| !coordinates.contains(*t)).map(str::to_owned))
                .collect();
            return Ok((format!("{key}({})", places.join(",")), false, true));
        }
        let here = |n: &&PaperName| n.key() == key;
        let moves = time.is_some_and(|t| {
            all.iter().filter(here).any(|n| n.dots > 0 || n.derived_by.as_deref() == Some(t) && !n.is_partial)
                || t == "t" && evidence.moving.contains(key)
                || t != "t" && evidence.derived.get(key).is_some_and(|by| by.contains(t))
                || evidence.calls.get(key).is_some_and(|c| c.contains_key(&Some(vec![t.to_owned()])))
                || name.has_hat
                || all.iter().filter(here).any(is_value) && evidence.variables_of(name).contains_key(t)
        });
        let places: BTreeSet<&Vec<String>> = all
            .iter()
            .filter(here)
            .filter_map(|n| if let Call::Places(p) = &n.call { Some(p) } else { None })
            .filter(|p| is_place(p))
            .collect();
        if places.is_empty() {
            return Ok((key.to_owned(), moves, false));
        }
        if moves && places.iter().all(|p| p.len() == 1 && Some(p[0].as_str()) == time) {
            return Ok((key.to_owned(), true, false));
        }
        let derives = time.is_some() || !coordinates.is_empty();
        let bare = all.iter().filter(here).any(|n| n.call == Call::None);
        if derives || places.len() > 1 || bare {
            return Err(NotRead::of(format!("an unknown function, {key}")));
        }
        // The name with its place is a number: nothing is derived here, and it stands at no other place.
        let place = places.into_iter().next().map(|p| p.join(",")).unwrap_or_default();
        Ok((format!("{key}({place})"), false, false))
    }

    /// Reads a relation of two sides. A name that is printed nowhere with a place behind it is a factor of what stands in parentheses
    /// behind it.
    ///
    /// # Errors
    /// What the reader of formulas does not understand.
    pub fn read(&mut self, sides: [&PrintedSide; 2], evidence: &Evidence) -> Result<Read, NotRead> {
        let plain = sides.map(|s| s.text.clone());
        match self.statement(&plain) {
            Err((_, "latex::ambiguous")) => {
                let is_factor = |letter: &str| !evidence.may_be_function(letter);
                let dotted = sides.map(|s| s.with_factors(&is_factor));
                match dotted == plain {
                    true => self.statement(&plain).map_err(|e| e.0),
                    false => self.statement(&dotted).map_err(|e| e.0),
                }
            }
            other => other.map_err(|e| e.0),
        }
    }

    fn statement(&mut self, texts: &[String; 2]) -> Result<Read, (NotRead, &'static str)> {
        let text = equation(&texts[0], &texts[1]);
        let mut found = latex::read(&text, &self.scope, &mut self.graph)
            .map_err(|problems| (refusal(&problems), problems.first().map_or("", |p| p.code)))?;
        match (found.pop(), found.is_empty()) {
            (Some(statement), true) => Ok(Read { statement, text }),
            _ => Err((NotRead::of("several formulas"), "")),
        }
    }

    /// The pairs of scalars that an equation says to be equal.
    ///
    /// # Errors
    /// As for [`read`](Desk::read).
    pub fn pairs(&mut self, sides: [&PrintedSide; 2], evidence: &Evidence) -> Result<Vec<(Expr, Expr)>, NotRead> {
        Ok(pairs_of(&self.read(sides, evidence)?.statement))
    }
}

/// A relation that was read, and the text that was.
pub struct Read {
    /// What it says.
    pub statement: Statement,
    /// Its two sides as one text.
    pub text: String,
}

/// The pairs of scalars of a statement of one equation.
pub fn pairs_of(statement: &Statement) -> Vec<(Expr, Expr)> {
    let sides = |r: &latex::Relation| {
        r.left.components.iter().copied().zip(r.right.components.iter().copied()).collect::<Vec<_>>()
    };
    statement.relations.iter().flat_map(sides).collect()
}

/// Two sides as one text.
fn equation(left: &str, right: &str) -> String {
    format!("{left} = {right}")
}

/// Whether a name is a field: derived partially here, or of what the paper derives by the coordinates of the step.
fn is_field(
    name: &PaperName,
    key: &str,
    all: &[PaperName],
    evidence: &Evidence,
    coordinates: &BTreeSet<String>,
) -> bool {
    if coordinates.is_empty() {
        return false;
    }
    let here = all
        .iter()
        .any(|n| n.key() == key && n.is_partial && n.derived_by.as_ref().is_some_and(|b| coordinates.contains(b)));
    let paper = evidence.partial.get(key).is_some_and(|by| by.iter().any(|b| coordinates.contains(b)));
    let place = matches!(&name.call, Call::Places(p) if p.iter().any(|p| coordinates.contains(p)));
    here || paper || place
}
