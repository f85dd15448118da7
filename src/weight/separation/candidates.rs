//! The conditions that are tried as an explanation: those of the file, and simple ones built from its symbols.
//!
//! Built: orderings and equalities of parameters of one unit, their signs, which of three lies between the others; states and
//! observables that vanish, never vanish, keep one sign, do not change, or have a special value at the start.

use crate::derivation::{Claim, DEFAULT_PRECISION, Derivation, Form, FormKind, Formula, SymbolEntry, Written};
use crate::expr::{Expr, Graph, Leaf, Node, Tensor};
use crate::findings::conditions::ConditionName;
use crate::latex::{self, RelationKind, Role, Statement};
use sampled::trace::Trace;

/// What the ids of claims begin with that are made here: no id of a file can.
pub(super) const PROBE: char = '~';

/// Most conditions that are built from the symbols.
const MOST: usize = 240;
/// Symbols with more components are not taken apart: a matrix is a whole.
const MOST_COMPONENTS: usize = 3;

/// A condition, as a claim.
pub(super) struct Candidate {
    /// How it is named.
    pub name: ConditionName,
    /// The claim that it is met at every time.
    pub claim: Claim,
    /// Whether it does not move: it is about parameters and the start. That something which moves is not so *throughout* is an
    /// accident of the span, and explains nothing.
    pub fixed: bool,
}

/// What a condition says.
enum Says {
    Statements(Vec<Written<Statement>>),
    Constant(Written<Tensor>),
}

/// All candidates, those of the file first.
pub(super) fn candidates(derivation: &Derivation, graph: &mut Graph) -> Vec<Candidate> {
    let mut out: Vec<Candidate> = Vec::new();
    for condition in &derivation.conditions {
        let texts: Vec<&str> = condition.holds.iter().map(|w| w.text.as_str()).collect();
        let name = ConditionName {
            id: Some(condition.id.clone()),
            formula: texts.join(", "),
            says: Some(condition.says.clone()),
            negated: false,
        };
        let claim = claim(derivation, out.len(), Says::Statements(condition.holds.clone()));
        let fixed = is_fixed(derivation, graph, &claim);
        out.push(Candidate { name, claim, fixed });
    }
    let mut texts = parameters(derivation);
    texts.extend(starts(derivation));
    texts.extend(moving(derivation));
    for text in texts.into_iter().take(MOST) {
        let written = 0..0;
        let says = match text.strip_suffix(CONSTANT) {
            Some(quantity) => {
                let written = |value| Written { text: quantity.to_owned(), span: written, value };
                let read = latex::read_expression(quantity, &derivation.scope, graph).ok();
                read.map(|value| (quantity.to_owned(), Says::Constant(written(value))))
            }
            None => latex::read(&text, &derivation.scope, graph).ok().map(|statements| {
                let each = |value| Written { text: text.clone(), span: written.clone(), value };
                (text.clone(), Says::Statements(statements.into_iter().map(each).collect()))
            }),
        };
        // A name that does not read back is of no use to the reader either.
        let Some((formula, says)) = says else { continue };
        let constant = matches!(says, Says::Constant(_)).then(|| "does not change".to_owned());
        let name = ConditionName { id: None, formula, says: constant, negated: false };
        let claim = claim(derivation, out.len(), says);
        // The file may have said it in other words.
        if !out.iter().any(|c| said(graph, &c.claim) == said(graph, &claim)) {
            let fixed = is_fixed(derivation, graph, &claim);
            out.push(Candidate { name, claim, fixed });
        }
    }
    out
}

/// Whether all that a condition is about are parameters and values at fixed times.
fn is_fixed(derivation: &Derivation, graph: &Graph, claim: &Claim) -> bool {
    let sides = said(graph, claim).into_iter().flat_map(|(_, l, r)| std::iter::once(l).chain(r));
    let leaves = graph.leaves(sides.collect::<Vec<_>>());
    leaves.iter().all(|l| l.instant.is_some() || derivation.scope.role(l.symbol) == Some(Role::Parameter))
}

/// A quantity that equals its value at a fixed time does not change.
fn is_its_start(graph: &Graph, l: Expr, r: Expr) -> bool {
    match (graph.node(l), graph.node(r)) {
        (Node::Leaf(l), Node::Leaf(r)) => {
            l.instant.is_none() && r.instant.is_some() && Leaf { instant: None, ..*r } == *l
        }
        _ => false,
    }
}

/// What a claim says, in whatever words: the sides of its relations, and what is constant, in a fixed order.
pub(super) fn said(graph: &Graph, claim: &Claim) -> Vec<Part> {
    let mut out = Vec::new();
    for form in &claim.forms {
        match form {
            Form::Always(w) => {
                for relation in &w.value.relations {
                    let sides = relation.left.components.iter().zip(&relation.right.components);
                    // 0 = 0 off a diagonal says nothing.
                    let telling = sides.filter(|(l, r)| l != r);
                    out.extend(telling.map(|(&l, &r)| match relation.kind {
                        RelationKind::Equal if is_its_start(graph, l, r) => (None, l, None),
                        RelationKind::Equal if is_its_start(graph, r, l) => (None, r, None),
                        kind => turned(kind, l, r),
                    }));
                }
            }
            Form::FirstIntegral(w) => out.extend(w.value.components.iter().map(|e| (None, *e, None))),
            // Said of no condition.
            _ => return Vec::new(),
        }
    }
    out.sort_unstable_by_key(|(kind, l, r)| (kind.map(|k| k as u8), *l, *r));
    out.dedup();
    out
}

/// A part of what a claim says.
type Part = (Option<RelationKind>, Expr, Option<Expr>);

/// Times of a motion at which two quantities are compared.
const COMPARED: usize = 8;

/// Whether a condition and a claim say of one quantity each that it does not change, and the two move alike on all of some motions: then
/// the condition is the claim in other words, as far as these motions tell.
pub(super) fn is_alike(graph: &Graph, (condition, own): (&[Part], &[Part]), on: &[&Trace]) -> bool {
    let constant = |said: &[Part]| match said {
        [(None, e, None)] => match graph.node(*e) {
            Node::Leaf(leaf) if leaf.instant.is_none() => Some(*leaf),
            _ => None,
        },
        _ => None,
    };
    let Some((a, b)) = constant(condition).zip(constant(own)) else { return false };
    let on_one = |trace: &&Trace| {
        let place = |leaf: Leaf| trace.leaves.binary_search(&leaf).ok();
        let Some((a, b)) = place(a).zip(place(b)) else { return false };
        let step = (trace.times.len() / COMPARED).max(1);
        let values = trace.times.iter().step_by(step).map(|t| trace.values(*t));
        let moved: Option<Vec<_>> = values.map(|v| v.get(a)?.ok().zip(v.get(b)?.ok()).map(|(a, b)| a - b)).collect();
        let Some(apart) = moved else { return false };
        apart.first().is_some_and(|first| apart.iter().all(|x| (*x - *first).contains_zero()))
    };
    !on.is_empty() && on.iter().all(on_one)
}

/// A relation in one of the two ways in which it can be written.
fn turned(kind: RelationKind, l: Expr, r: Expr) -> Part {
    let (kind, l, r) = match kind {
        RelationKind::Equal | RelationKind::NotEqual => (kind, l.min(r), l.max(r)),
        RelationKind::Greater => (RelationKind::Less, r, l),
        RelationKind::GreaterEqual => (RelationKind::LessEqual, r, l),
        RelationKind::Less | RelationKind::LessEqual => (kind, l, r),
    };
    (Some(kind), l, Some(r))
}

/// Marks the text of a quantity that does not change.
const CONSTANT: &str = "\u{1}";

fn claim(derivation: &Derivation, number: usize, says: Says) -> Claim {
    let (forms, kind): (Vec<Form>, FormKind) = match says {
        Says::Statements(all) => (all.into_iter().map(Form::Always).collect(), FormKind::Always),
        Says::Constant(quantity) => (vec![Form::FirstIntegral(quantity)], FormKind::FirstIntegral),
    };
    Claim {
        id: format!("{PROBE}{number}"),
        reading: None,
        says: String::new(),
        parent_says: None,
        role: Default::default(),
        conclusion: false,
        postulate: false,
        rests_on: Vec::new(),
        place: None,
        label: None,
        remark: None,
        symbols: Vec::new(),
        formulas: vec![Formula { text: String::new(), kind }],
        assuming: Vec::new(),
        forms,
        at: None,
        follows_from: Vec::new(),
        precision: DEFAULT_PRECISION,
        branches_throughout: false,
        trajectories: (0..derivation.trajectories.len()).collect(),
        names_trajectories: false,
        expect: vec![None; derivation.trajectories.len()],
        families: Vec::new(),
        expect_of_families: Vec::new(),
        expect_alone: None,
        expect_inconsistent_units: false,
        region: None,
        printed: false,
        scope: derivation.scope.clone(),
        span: 0..0,
    }
}

/// The names of the components of a symbol.
fn components(derivation: &Derivation, entry: &SymbolEntry) -> Vec<String> {
    let graph = &derivation.graph;
    let leaf = |c: usize| Leaf::now(entry.symbol, c as u16);
    (0..graph.component_count(entry.symbol)).map(|c| graph.leaf_latex(leaf(c))).collect()
}

fn of_role(derivation: &Derivation, role: Role) -> impl Iterator<Item = &SymbolEntry> {
    derivation.symbols.iter().filter(move |s| s.role == role && s.arguments.is_empty())
}

/// Orderings, equalities and signs of parameters.
fn parameters(derivation: &Derivation) -> Vec<String> {
    let mut out = Vec::new();
    let mut scalars: Vec<(&SymbolEntry, String)> = Vec::new();
    // A constant is the same on all motions.
    for entry in of_role(derivation, Role::Parameter).filter(|s| s.formula.is_none()) {
        let names = components(derivation, entry);
        if names.len() > MOST_COMPONENTS {
            continue;
        }
        for (i, a) in names.iter().enumerate() {
            for b in &names[..i] {
                out.extend([format!("{b}={a}"), format!("{b}<{a}"), format!("{b}>{a}"), format!(r"{b}\ne {a}")]);
            }
            let others: Vec<&String> = names.iter().filter(|n| *n != a).collect();
            if let [b, c] = others.as_slice() {
                for relation in [">0", r"\ge 0", "<0"] {
                    out.push(format!("({a}-{b})({c}-{a}){relation}"));
                }
            }
            if !entry.positive {
                out.extend([format!("{a}>0"), format!("{a}<0"), format!("{a}=0"), format!(r"{a}\ne 0")]);
            }
        }
        if let [name] = names.as_slice() {
            scalars.push((entry, name.clone()));
        }
    }
    for (i, (a, name)) in scalars.iter().enumerate() {
        for (b, other) in scalars[..i].iter().filter(|(b, _)| b.measured_in.is_some() && b.measured_in == a.measured_in)
        {
            let _ = b;
            out.extend([format!("{other}={name}"), format!("{other}<{name}"), format!("{other}>{name}")]);
        }
    }
    out
}

/// Special values at the start, which is the time 0.
fn starts(derivation: &Derivation) -> Vec<String> {
    if derivation.trajectories.iter().any(|t| t.initial_time != 0.0) {
        return Vec::new();
    }
    let mut out = Vec::new();
    for entry in of_role(derivation, Role::State) {
        let shape = derivation.graph.shape(entry.symbol);
        match shape.extents() {
            [n, m] if n == m => out.push(format!(r"{}(0)=\mathbb{{1}}", entry.name)),
            [_] | [] if shape.len() <= MOST_COMPONENTS => {
                let names = components(derivation, entry);
                out.extend(names.iter().map(|x| format!("{x}(0)=0")));
                // Systems of second order start with a rate, too.
                let dotted = |c: usize| Leaf { rate: 1, ..Leaf::now(entry.symbol, c as u16) };
                out.extend((0..names.len()).map(|c| format!("{}(0)=0", derivation.graph.leaf_latex(dotted(c)))));
            }
            _ => {}
        }
    }
    out
}

/// States and observables along the motion.
fn moving(derivation: &Derivation) -> Vec<String> {
    let mut out = Vec::new();
    for role in [Role::State, Role::Observable] {
        for entry in of_role(derivation, role) {
            let names = components(derivation, entry);
            if names.len() > MOST_COMPONENTS {
                continue;
            }
            for x in &names {
                out.extend([format!("{x}=0"), format!("{x}>0"), format!("{x}<0"), format!(r"{x}\ne 0")]);
            }
            out.push(format!("{}{CONSTANT}", entry.name));
        }
    }
    out
}
