//! Formulas with derivatives of fields, made at random, are printed so that they are read back as the same formula.
//!
//! The same up to parentheses, and up to how factors are joined: no product of scalars depends on either.

use super::super::parse::chains;
use super::super::scope::{Declaration, Role, Scope};
use super::super::syntax::{Bracket, Chain, Nabla, Node, NodeKind, PartialForm, Sign, SymbolNode};
use super::to_latex;
use expr::{Graph, Rational, Shape};

const SCALARS: [&str; 6] = ["x", "t", "a", "u", "v", "f"];

fn scope() -> Scope {
    let mut graph = Graph::new();
    let mut scope = Scope::new(&mut graph);
    let mut declare = |key: &str, role: Role, shape: Option<Shape>| {
        let declaration = Declaration { shape, ..Declaration::of(role) };
        scope.declare(&mut graph, key, declaration).unwrap_or_else(|e| panic!("{key}: {e:?}"));
    };
    declare("t", Role::Time, None);
    for key in ["x", "y", "z"] {
        declare(key, Role::Coordinate, None);
    }
    declare("a", Role::Parameter, None);
    for key in ["u(x,t)", "v(x,y,z,t)", "f(x)"] {
        declare(key, Role::Field, None);
    }
    declare(r"{\bf w}(x,y,z,t)", Role::Field, Some(Shape::vector(3)));
    scope
}

/// Numbers that look random, and are the same everywhere.
struct Draws(u64);

impl Draws {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

fn node(kind: NodeKind) -> Node {
    Node::new(kind, 0..0)
}

fn symbol(name: &str, sup: Option<Node>) -> Node {
    node(NodeKind::Symbol(SymbolNode {
        name: name.to_owned(),
        dots: 0,
        primed: false,
        sub: None,
        sup: sup.map(Box::new),
        sup_first: false,
        arguments: None,
        arguments_text: String::new(),
    }))
}

fn number(n: usize) -> Node {
    node(NodeKind::Number(Rational::from(n as u64)))
}

/// A formula of at most this depth.
fn drawn(draws: &mut Draws, depth: usize) -> Node {
    let some = |draws: &mut Draws, least: usize| -> Vec<Node> {
        (0..least + draws.below(2)).map(|_| drawn(draws, depth - 1)).collect()
    };
    if depth == 0 {
        return match draws.below(5) {
            0 => number(2 + draws.below(8)),
            1 => symbol(draws.of(&SCALARS), Some(number(2 + draws.below(3)))),
            _ => symbol(draws.of(&SCALARS), None),
        };
    }
    let inner = |draws: &mut Draws| Box::new(drawn(draws, depth - 1));
    node(match draws.below(16) {
        0 => {
            let terms = some(draws, 2);
            NodeKind::Sum(
                terms
                    .into_iter()
                    .map(|n| (draws.of(&[Sign::Plus, Sign::Minus]), n))
                    .enumerate()
                    .map(|(i, (sign, n))| (if i == 0 { Sign::Plus } else { sign }, n))
                    .collect(),
            )
        }
        1 | 2 => NodeKind::Product(some(draws, 2)),
        3 => NodeKind::Dot(some(draws, 2)),
        4 => NodeKind::Quotient { top: inner(draws), bottom: inner(draws), slash: draws.below(2) == 0 },
        5 => NodeKind::Function(
            draws.of(&["sin", "exp", "ln"]).to_owned(),
            draws.of(&[None, Some(2)]),
            vec![node(NodeKind::Group(inner(draws), Bracket::Round))],
        ),
        6 => NodeKind::Scripted {
            base: inner(draws),
            sub: None,
            sup: Some(Box::new(number(2 + draws.below(3)))),
            sup_first: false,
        },
        7 => match draws.below(4) {
            0 => NodeKind::Absolute(inner(draws)),
            1 => NodeKind::Root(inner(draws), 2),
            2 => NodeKind::Exponential { exponent: inner(draws), upright: false },
            _ => NodeKind::Group(inner(draws), Bracket::Round),
        },
        8..=11 => {
            let mut by: Vec<Node> = (0..1 + draws.below(3)).map(|_| symbol(draws.of(&["x", "t"]), None)).collect();
            by.sort_by_key(|n| n.is_named("t"));
            let form = draws.of(&[PartialForm::Fraction, PartialForm::Operator, PartialForm::Subscript]);
            // Written one run after the other, each is a derivative of its own.
            let by = if form == PartialForm::Subscript { vec![by[0].clone(); by.len()] } else { by };
            NodeKind::Partial { of: inner(draws), by, form }
        }
        12 => NodeKind::Derivative {
            of: inner(draws),
            by: Box::new(symbol("x", None)),
            order: 1,
            operator: draws.below(2) == 0,
            upright: false,
        },
        13 => NodeKind::Poisson(inner(draws), inner(draws)),
        14 => NodeKind::Variation { of: inner(draws), by: Box::new(symbol("u", None)) },
        _ => {
            let along = Nabla::Along(Box::new(symbol("bf:w", None)));
            let action = match draws.below(7) {
                0 => Nabla::Gradient,
                1 => Nabla::Divergence,
                2 => Nabla::Curl,
                3 => Nabla::Laplacian { delta: draws.below(2) == 0 },
                4 => Nabla::Wave,
                5 => Nabla::Following { fraction: draws.below(2) == 0 },
                _ => along,
            };
            NodeKind::Nabla { of: inner(draws), action }
        }
    })
}

/// The formula without what does not count: places, brackets, whether factors are joined by a dot, a plus before all.
fn plain(node: &Node) -> String {
    let of = |nodes: &[Node]| nodes.iter().map(plain).collect::<Vec<_>>().join(" ");
    match &node.kind {
        NodeKind::Group(inner, _) => plain(inner),
        NodeKind::Product(_) | NodeKind::Dot(_) => {
            fn factors(node: &Node, into: &mut Vec<String>) {
                match &node.kind {
                    NodeKind::Group(inner, _) if matches!(inner.kind, NodeKind::Product(_) | NodeKind::Dot(_)) => {
                        factors(inner, into);
                    }
                    NodeKind::Product(parts) | NodeKind::Dot(parts) => parts.iter().for_each(|n| factors(n, into)),
                    _ => into.push(plain(node)),
                }
            }
            let mut all = Vec::new();
            factors(node, &mut all);
            format!("[* {}]", all.join(" "))
        }
        NodeKind::Symbol(s) => match &s.sup {
            Some(sup) => format!("[^ {} {}]", s.name, plain(sup)),
            None => s.name.clone(),
        },
        NodeKind::Scripted { base, sup, .. } => {
            format!("[^ {} {}]", plain(base), sup.as_deref().map(plain).unwrap_or_default())
        }
        NodeKind::Sum(terms) => {
            let all: Vec<String> = terms.iter().map(|(sign, n)| format!("{sign:?} {}", plain(n))).collect();
            format!("[sum {}]", all.join(" "))
        }
        NodeKind::Quotient { top, bottom, .. } => format!("[/ {} {}]", plain(top), plain(bottom)),
        NodeKind::Partial { of, by, form } => format!("[{form:?} {} by {}]", plain(of), self::plain_by(by)),
        NodeKind::Nabla { of, action: Nabla::Along(direction) } => {
            format!("[along {} {}]", plain(direction), plain(of))
        }
        NodeKind::Nabla { of, action } => format!("[{action:?} {}]", plain(of)),
        NodeKind::Derivative { of, operator, .. } => format!("[d {operator} {}]", plain(of)),
        NodeKind::Number(n) => n.to_string(),
        NodeKind::Function(name, power, arguments) => format!("[{name} {power:?} {}]", of(arguments)),
        other => {
            let name = format!("{other:?}");
            let name = name.split(['(', ' ', '{']).next().unwrap_or_default().to_owned();
            format!("[{name} {}]", node.children().into_iter().map(plain).collect::<Vec<_>>().join(" "))
        }
    }
}

fn plain_by(by: &[Node]) -> String {
    by.iter().map(plain).collect()
}

fn chain(node: Node) -> Chain {
    Chain { sides: vec![node, number(0)], relations: vec![super::RelationKind::Equal], span: 0..0, time: None }
}

#[test]
fn derivatives_read_back() {
    let scope = scope();
    let mut draws = Draws(19);
    let mut wrong: Vec<(String, String)> = Vec::new();
    for _ in 0..20_000 {
        let depth = 1 + draws.below(3);
        let chain = chain(drawn(&mut draws, depth));
        let text = to_latex(&chain);
        match chains(&text, &scope) {
            Ok(read) if read.len() == 1 => {
                let (written, read) = (plain(&chain.sides[0]), plain(&read[0].sides[0]));
                if written != read {
                    wrong.push(("another formula".to_owned(), format!("{text}\n  {written}\n  {read}")));
                }
            }
            Ok(read) => wrong.push((format!("{} chains", read.len()), text)),
            Err(problems) => wrong.push((problems[0].message.clone(), text)),
        }
    }
    // The shortest examples of each kind.
    wrong.sort_by_key(|(_, text)| text.len());
    let mut told: Vec<&(String, String)> = Vec::new();
    for one in &wrong {
        if told.iter().filter(|t| t.0 == one.0).count() < 4 {
            told.push(one);
        }
    }
    assert!(wrong.is_empty(), "{} are not read back: {told:#?}", wrong.len());
}

#[test]
fn products_of_derivatives_keep_their_print() {
    let scope = scope();
    for text in [
        r"u_t=6u\partial_xu",
        r"\partial_tu\partial_xu=0",
        r"\frac{\partial_xu}{u}\partial_tu=0",
        r"\partial_x(u)\cdot v=0",
        r"({\bf w}\cdot\nabla)u+\nabla\cdot(u{\bf w})=0",
        r"\frac{\partial}{\partial x}(uv)\cdot\partial_xu=0",
    ] {
        let Ok(read) = chains(text, &scope) else { panic!("{text} is not read") };
        assert_eq!(to_latex(&read[0]).replace(' ', ""), text.replace(' ', ""));
    }
}
