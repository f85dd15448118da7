//! What is printed reads back as the same: expressions as the same node, syntax trees as the same tree up to places.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use crate::latex_support::World;
use rederive::expr::{Expr, Leaf, Op, Rational, Symbol};
use rederive::latex::syntax::{Chain, Node, NodeKind, to_latex};
use rederive::latex::{Role, parse};
use rederive::number::Draws;

/// Names of every kind: plain, Greek, styled, primed, labelled, with components.
fn world() -> World {
    use Role::{Observable, Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with(r"\lambda'", Parameter, "")
        .with(r"\psi_0", Parameter, "")
        .with(r"c_{\rm max}", Parameter, "")
        .with("I", Parameter, "diagonal 3")
        .with("x", State, "")
        .with(r"\psi", Observable, "")
        .with(r"\hat q", State, "")
        .with(r"\theta_N", Observable, "")
        .with(r"{\bf m}", State, "3")
        .with(r"\boldsymbol{\Omega}", State, "3")
        .with(r"{\bf x}_N", Observable, "3")
        .with("R", State, "3x3")
        .with("e", Parameter, "")
        .by("L_i", Observable, r"\epsilon_{ijk}m_jm_k")
        .by("S_{(n-k)}", Observable, r"\frac{1}{I_n}-\frac{1}{I_k}")
}

const KEYS: &[&str] = &[
    "t",
    "a",
    r"\lambda'",
    r"\psi_0",
    r"c_{\rm max}",
    "I",
    "e",
    "x",
    r"\psi",
    r"\hat q",
    r"\theta_N",
    r"{\bf m}",
    r"\boldsymbol{\Omega}",
    r"{\bf x}_N",
    "R",
    "L_i",
    "S_{(n-k)}",
];

/// Number of the keys that do not depend on time.
const STEADY: usize = 7;

/// What to do next with the expressions built so far, by their positions from the end.
#[derive(Clone, Debug)]
enum Step {
    Number(i32, u8),
    Pi,
    Branch,
    Leaf { key: usize, component: u16, rate: u8, instant: Option<usize> },
    Unary(usize, usize),
    Power(usize, i32),
    Binary(usize, usize, usize),
}

/// A step that was drawn: leaves and operations with two operands most of all.
fn step(draws: &mut Draws) -> Step {
    let mut below = |n: usize| draws.below(n as u64) as usize;
    match below(20) {
        0 | 1 => Step::Number(below(40) as i32 - 20, 1 + below(8) as u8),
        2 => Step::Pi,
        3 => Step::Branch,
        4..10 => {
            let (key, component, rate) = (below(KEYS.len()), below(9) as u16, below(5) as u8);
            let instant = (below(2) == 1).then(|| below(6));
            Step::Leaf { key, component, rate, instant }
        }
        10..13 => Step::Unary(below(Op::ALL.len()), below(6)),
        13 => Step::Power(below(6), below(24) as i32 - 12),
        _ => Step::Binary(below(Op::ALL.len()), below(6), below(6)),
    }
}

fn built(w: &mut World, steps: &[Step]) -> Vec<Expr> {
    let unary: Vec<Op> = Op::ALL.iter().copied().filter(|o| o.arity() == 1 && !matches!(o, Op::Powi(_))).collect();
    let binary: Vec<Op> = Op::ALL.iter().copied().filter(|o| o.arity() == 2).collect();
    let symbol = |w: &World, key: &str| -> Symbol { w.scope.symbol(key).unwrap_or_else(|| panic!("{key}")) };
    let mut made: Vec<Expr> = vec![w.graph.integer(1)];
    for step in steps {
        let back = |i: usize| made[made.len() - 1 - i % made.len()];
        let e = match *step {
            Step::Number(n, d) => w.graph.constant(Rational::from(n) / Rational::from(d)),
            Step::Pi => w.graph.pi(),
            Step::Branch => {
                let leaf = w.scope.branch_sign();
                w.graph.leaf(leaf)
            }
            Step::Leaf { key, component, rate, instant } => {
                let s = symbol(w, KEYS[key]);
                let count = w.graph.component_count(s) as u16;
                let moving = key >= STEADY;
                let steady = |w: &World, e: Expr| {
                    w.graph.leaves([e]).iter().all(|l| KEYS[1..STEADY].contains(&w.graph.name(l.symbol)))
                };
                let instant = instant.map(back).filter(|&e| moving && steady(w, e));
                let rate = if moving { rate } else { 0 };
                w.graph.leaf(Leaf { rate, instant, ..Leaf::now(s, component % count) })
            }
            Step::Unary(op, a) => {
                let a = back(a);
                w.graph.unary(unary[op % unary.len()], a)
            }
            Step::Power(a, n) => {
                let a = back(a);
                w.graph.powi(a, n)
            }
            Step::Binary(op, a, b) => {
                let (a, b) = (back(a), back(b));
                w.graph.binary(binary[op % binary.len()], a, b)
            }
        };
        // Whatever can be built can be printed, but texts grow fast.
        if w.graph.to_latex(e).len() < 2000 {
            made.push(e);
        }
    }
    made
}

#[test]
fn printed_expressions_read_back() {
    let mut draws = Draws::new(15);
    for _ in 0..256 {
        let steps: Vec<Step> = (0..1 + draws.below(29)).map(|_| step(&mut draws)).collect();
        let mut w = world();
        for e in built(&mut w, &steps) {
            let text = w.graph.to_latex(e);
            match w.try_expression(&text) {
                Ok(t) => assert_eq!(t.as_scalar(), Some(e), "{text}, of {steps:?}"),
                Err(p) => assert!(p[0].code == "latex::too-deep", "{}", crate::latex_support::shown(&text, &p)),
            }
        }
    }
}

#[test]
fn names_with_labels_components_rates_and_times() {
    let mut w = world();
    for (key, component, rate, instant, wanted) in [
        (r"\psi_0", 0, 0, None, r"\psi_0"),
        (r"c_{\rm max}", 0, 0, None, r"c_{\rm max}"),
        ("R", 5, 0, None, "R_{23}"),
        ("R", 5, 1, Some(0), r"\dot{R}_{23}(0)"),
        (r"{\bf x}_N", 1, 2, None, r"\ddot{\bf x}_{N2}"),
        (r"{\bf x}_N", 0, 0, Some(-1), r"{\bf x}_{N1}(-1)"),
        ("L_i", 2, 3, None, r"\dddot{L}_3"),
        ("S_{(n-k)}", 1, 1, None, r"\dot{S}_{(1-2)}"),
        (r"\theta_N", 0, 1, Some(2), r"\dot{\theta}_N(2)"),
    ] {
        let symbol = w.scope.symbol(key).unwrap_or_else(|| panic!("{key}"));
        let instant = instant.map(|n| w.graph.integer(n));
        let e = w.graph.leaf(Leaf { rate, instant, ..Leaf::now(symbol, component) });
        assert_eq!(w.graph.to_latex(e), wanted);
        assert_eq!(w.expression(wanted).as_scalar(), Some(e), "{wanted}");
    }
}

// ---- syntax trees --------------------------------------------------------------------------------------------------

/// The tree without places.
fn unplaced(chain: &Chain) -> String {
    let text = format!("{chain:?}");
    let mut out = String::new();
    let mut rest = text.as_str();
    while let Some(at) = rest.find("span: ") {
        out.push_str(&rest[..at]);
        rest = rest[at..].trim_start_matches(|c: char| c != ' ').trim_start();
        rest = rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
    }
    out + rest
}

fn round_trip(w: &World, text: &str) -> usize {
    let chains = parse(text, &w.scope).unwrap_or_else(|p| panic!("{}", crate::latex_support::shown(text, &p)));
    for chain in &chains {
        let printed = to_latex(chain);
        let again =
            parse(&printed, &w.scope).unwrap_or_else(|p| panic!("{}", crate::latex_support::shown(&printed, &p)));
        assert_eq!(again.len(), 1, "{printed}");
        assert_eq!(unplaced(&again[0]), unplaced(chain), "{text}\n{printed}");
    }
    chains.len()
}

/// All literal strings of a text in TOML: formulas, and names.
fn literals(text: &str) -> Vec<&str> {
    let lines = text.lines().filter(|l| !l.starts_with('#'));
    lines.flat_map(|l| l.split('\'').skip(1).step_by(2)).collect()
}

#[test]
fn formulas_of_the_derivations_read_back() {
    let mut seen = 0;
    for file in ["kepler.toml", "pendulum.toml", "rabi.toml", "deriglazov-comment.toml"] {
        let path = format!("{}/derivations/{file}", env!("CARGO_MANIFEST_DIR"));
        let derivation = rederive::derivation::load(std::path::Path::new(&path))
            .unwrap_or_else(|p| panic!("{}", rederive::diag::render(&p, false)));
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let mut w = World { graph: derivation.graph.clone(), scope: derivation.scope.clone() };
        for formula in literals(&text) {
            let Ok(chains) = parse(formula, &w.scope) else { continue };
            let printed: Vec<String> = chains.iter().map(to_latex).collect();
            let components = |w: &mut World, text: &str| -> Option<Vec<Expr>> {
                if let Ok(t) = w.try_expression(text) {
                    return Some(t.components);
                }
                let statements = w.try_read(text).ok()?;
                let relations = statements.into_iter().flat_map(|s| s.relations);
                Some(relations.flat_map(|r| r.left.components.into_iter().chain(r.right.components)).collect())
            };
            // What has a meaning is printed so that it is read as the same, and means the same.
            let Some(before) = components(&mut w, formula) else { continue };
            seen += round_trip(&w, formula);
            let after = components(&mut w, &printed.join(",\\quad "));
            assert_eq!(Some(before), after, "{formula}\n{printed:?}");
        }
    }
    assert!(seen > 600, "{seen}");
}

#[test]
fn formulas_of_the_comment_read_back() {
    let w = World::rigid_body();
    let mut seen = 0;
    for text in crate::latex_support::COMMENT {
        seen += round_trip(&w, text);
    }
    assert!(seen >= 38, "{seen}");
}

#[test]
fn printed_trees_stay_near_the_original() {
    let w = World::rigid_body();
    for text in [
        r"\dot R_{ij}=-\frac{m_3}{I_k}\epsilon_{jkp}R_{3k}R_{ip}",
        r"\dot\theta=m_3I_{(1-2)}\sin\theta\sin\psi\cos\psi",
        r"2E=\frac{m^2_3}{I_3}+m^2_3[I_{(1-3)}-I_{(1-2)}\cos^2\psi]\sin^2\theta",
        r"\Omega_k({\bf m})=m_3R_{3i}I'^{-1}_{ik}",
        r"\cos^2\psi_0=[I_2(I_3-I_1)]/[I_3(I_2-I_1)]",
        r"\frac{d\psi}{d\varphi}=\pm\frac{\sqrt{1/I_3-2E/m_3^2}}{1/I_1}",
        r"{\bf x}_N=R(t){\bf x}_N(0)",
    ] {
        let chains = parse(text, &w.scope).unwrap_or_else(|p| panic!("{}", crate::latex_support::shown(text, &p)));
        assert_eq!(to_latex(&chains[0]), text);
    }
}

#[test]
fn every_construct_reads_back() {
    let w = world();
    for text in [
        r"\left|a-\left|x\right|\right|=1.05",
        r"\sqrt[3]{a}\ne\sqrt{2}x",
        r"[{\bf m},{\boldsymbol\Omega}]={\bf m}\times{\boldsymbol\Omega}",
        r"{\bf m}\cdot R{\boldsymbol\Omega}\le a\cdot2",
        r"\frac{d^2x}{dt^2}+\frac{d}{dt}(xa)>\frac{\mathrm{d}\psi}{\mathrm{d}x}",
        r"\begin{pmatrix}1&a\\-a&1\end{pmatrix}_{12}=0",
        r"\operatorname{atan2}(x,a)=\operatorname{agm}(1,a)\ge\mathrm{e}^{-a}",
        r"\operatorname{tr}R+\operatorname{tr}(RR)=\det R",
        r"R(0)^{T}R=\mathbb{1}",
        r"\{\dot x}",
        r"\lim_{t\rightarrow-\infty}\psi(t)=\pi",
        r"\lim_{t\rightarrow a-1}\psi=0",
        r"{\dot{\bf m}}_1=\dot m_1",
        r"-x\pm a\mp2=+a",
        r"\hat q\,\lambda'^2=\hat{q}^{\prime}",
        r"(R{\bf m})_1^2=(x,a,1)_{2}",
        r"2^{10}=x^{a^2}",
    ] {
        // Some are not meant to be accepted; those that are must come back.
        if parse(text, &w.scope).is_ok() {
            round_trip(&w, text);
        }
    }
}

#[test]
fn altered_trees_get_their_parentheses() {
    let w = world();
    let node = |text: &str| parse(text, &w.scope).expect("a formula")[0].sides[0].clone();
    let sum = node("a+x");
    let wrap = |kind: NodeKind| {
        let chain = Chain { sides: vec![Node::new(kind, 0..0)], relations: vec![], span: 0..0, time: None };
        to_latex(&chain)
    };
    assert_eq!(wrap(NodeKind::Product(vec![node("2"), sum.clone()])), "2(a+x)");
    assert_eq!(wrap(NodeKind::Function("sin".into(), Some(2), vec![sum.clone()])), r"\sin^2(a+x)");
    assert_eq!(wrap(NodeKind::Function("sin".into(), None, vec![node("x^2")])), r"\sin(x^2)");
    let slash =
        |top: Node, bottom: Node| NodeKind::Quotient { top: Box::new(top), bottom: Box::new(bottom), slash: true };
    assert_eq!(wrap(slash(sum.clone(), node("ax"))), "(a+x)/(ax)");
    assert_eq!(wrap(NodeKind::Number(Rational::from(-3) / Rational::from(7))), r"-\frac{3}{7}");
    assert_eq!(
        wrap(NodeKind::Product(vec![Node::new(NodeKind::Number(Rational::from(-2)), 0..0), node("x")])),
        "(-2)x"
    );
}
