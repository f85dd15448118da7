//! What the tests of the formula reader share: a scope with declared symbols, and points at which formulas are evaluated.
#![allow(dead_code, reason = "each test crate uses a part")]

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};
use rederive::diag::Problem;
use rederive::expr::{Expr, Graph, Leaf, Shape, Tensor};
use rederive::latex::{self, Declaration, Role, Scope, Statement};
use rederive::tape::Tape;

/// A graph and the symbols that are declared in it.
#[derive(Clone)]
pub struct World {
    pub graph: Graph,
    pub scope: Scope,
}

/// The shape that a word such as `3`, `3x3` or `diagonal 3` stands for, and whether only the diagonal is stored.
fn shape(word: &str) -> (Option<Shape>, bool) {
    match word {
        "" | "complex" => (None, false),
        "3" => (Some(Shape::vector(3)), false),
        "2" => (Some(Shape::vector(2)), false),
        "3x3" => (Some(Shape::matrix(3, 3)), false),
        "2x2" => (Some(Shape::matrix(2, 2)), false),
        "2x3" => (Some(Shape::matrix(2, 3)), false),
        "diagonal 3" => (Some(Shape::matrix(3, 3)), true),
        _ => panic!("unknown shape {word}"),
    }
}

impl World {
    pub fn empty() -> World {
        let mut graph = Graph::new();
        let scope = Scope::new(&mut graph);
        World { graph, scope }
    }

    /// Declares a symbol without a formula.
    pub fn with(mut self, key: &str, role: Role, word: &str) -> World {
        let (shape, diagonal) = shape(word);
        let declaration = Declaration { shape, diagonal, complex: word == "complex", ..Declaration::of(role) };
        self.scope.declare(&mut self.graph, key, declaration).unwrap_or_else(|e| panic!("{key}: {e:?}"));
        self
    }

    /// Declares a symbol by a formula.
    pub fn by(mut self, key: &str, role: Role, formula: &str) -> World {
        self.define(key, role, formula, &[]);
        self
    }

    pub fn define(&mut self, key: &str, role: Role, formula: &str, arguments: &[&str]) {
        let declaration = Declaration { formula: Some(formula), arguments, ..Declaration::of(role) };
        self.scope.declare(&mut self.graph, key, declaration).unwrap_or_else(|e| panic!("{key}: {e:?}"));
    }

    /// Mechanics of a rigid body, as the Comment writes it.
    pub fn rigid_body() -> World {
        use Role::{Abbreviation, Observable, Parameter, State, Time};
        World::empty()
            .with("t", Time, "")
            .with("I", Parameter, "diagonal 3")
            .with("I'", Parameter, "3x3")
            .with("R", State, "3x3")
            .with(r"\Omega", State, "3")
            .with(r"\omega", Observable, "3")
            .with(r"{\bf m}", Observable, "3")
            .with("E", Observable, "")
            .with(r"{\bf x}_N", Observable, "3")
            .with(r"\theta", Observable, "")
            .with(r"\varphi", Observable, "")
            .with(r"\psi", Observable, "")
            .with(r"\psi_0", Parameter, "")
            .with(r"\varphi_0", Parameter, "")
            .with("t_0", Parameter, "")
            .by("I_{(n-k)}", Abbreviation, r"\frac{1}{I_n}-\frac{1}{I_k}")
            .by(r"\Omega({\bf m})", Abbreviation, r"I^{-1}R^T{\bf m}")
    }

    pub fn try_read(&mut self, text: &str) -> Result<Vec<Statement>, Vec<Problem>> {
        latex::read(text, &self.scope, &mut self.graph)
    }

    pub fn read(&mut self, text: &str) -> Vec<Statement> {
        match self.try_read(text) {
            Ok(statements) => statements,
            Err(problems) => panic!("{}", shown(text, &problems)),
        }
    }

    pub fn try_expression(&mut self, text: &str) -> Result<Tensor, Vec<Problem>> {
        latex::read_expression(text, &self.scope, &mut self.graph)
    }

    pub fn expression(&mut self, text: &str) -> Tensor {
        match self.try_expression(text) {
            Ok(tensor) => tensor,
            Err(problems) => panic!("{}", shown(text, &problems)),
        }
    }

    /// The values of expressions at a point; `None` where there is none.
    pub fn values(&self, roots: &[Expr], point: &Point) -> Vec<Option<f64>> {
        let leaves = self.graph.leaves(roots.iter().copied());
        let tape = Tape::compile(&self.graph, &leaves, roots).unwrap_or_else(|l| panic!("no input {l:?}"));
        let mut slots = tape.slots::<f64>(&());
        let inputs: Vec<_> = leaves.iter().map(|&leaf| Ok(point.leaf(&self.graph, leaf))).collect();
        tape.evaluate(&(), &inputs, &mut slots).into_iter().map(Result::ok).collect()
    }

    /// The value of a scalar expression written as text.
    pub fn number(&mut self, text: &str, point: &Point) -> f64 {
        let t = self.expression(text);
        let e = t.as_scalar().unwrap_or_else(|| panic!("{text} is a {}", t.shape));
        self.values(&[e], point)[0].unwrap_or_else(|| panic!("{text} has no value"))
    }

    /// Components of an expression at a point.
    pub fn numbers(&mut self, text: &str, point: &Point) -> Vec<f64> {
        let t = self.expression(text);
        self.values(&t.components, point).into_iter().map(|v| v.unwrap_or(f64::NAN)).collect()
    }
}

/// Problems with their places, for a failing test.
pub fn shown(text: &str, problems: &[Problem]) -> String {
    let mut out = String::new();
    for p in problems {
        let place = text.get(p.span.clone()).unwrap_or("(outside)");
        let hint = p.hint.as_deref().unwrap_or("");
        out.push_str(&format!("\n{text}\n  {}: {} at {:?} `{place}`; hint: {hint}\n", p.code, p.message, p.span));
    }
    out
}

/// A value for every leaf: as set, or a reproducible random number between 0.2 and 1.7 that depends on the leaf only.
#[derive(Clone, Default)]
pub struct Point {
    pub seed: u64,
    set: BTreeMap<String, f64>,
}

fn mixed(mut z: u64) -> u64 {
    z = z.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

fn key(name: &str, indices: &[u16], rate: u8, instant: &str) -> String {
    format!("{name}|{indices:?}|{rate}|{instant}")
}

impl Point {
    pub fn new(seed: u64) -> Point {
        Point { seed, set: BTreeMap::new() }
    }

    pub fn set(mut self, name: &str, value: f64) -> Point {
        self.set.insert(key(name, &[], 0, ""), value);
        self
    }

    /// The value of a component of a symbol, or of its rates, now (`""`) or at a time.
    pub fn at(&self, name: &str, indices: &[u16], rate: u8, instant: &str) -> f64 {
        let key = key(name, indices, rate, instant);
        if let Some(&value) = self.set.get(&key) {
            return value;
        }
        let hash = key.bytes().fold(mixed(self.seed), |h, b| mixed(h ^ u64::from(b)));
        0.2 + 1.5 * (hash >> 11) as f64 / (1u64 << 53) as f64
    }

    fn leaf(&self, graph: &Graph, leaf: Leaf) -> f64 {
        let instant = leaf.instant.map_or_else(String::new, |e| graph.to_latex(e));
        let indices = graph.component_indices(leaf.symbol, leaf.component);
        self.at(graph.name(leaf.symbol), &indices, leaf.rate, &instant)
    }

    pub fn s(&self, name: &str) -> f64 {
        self.at(name, &[], 0, "")
    }

    pub fn rate(&self, name: &str) -> f64 {
        self.at(name, &[], 1, "")
    }

    pub fn v(&self, name: &str) -> Vector3<f64> {
        self.vector(name, 0, "")
    }

    pub fn vector(&self, name: &str, rate: u8, instant: &str) -> Vector3<f64> {
        Vector3::from_fn(|i, _| self.at(name, &[i as u16 + 1], rate, instant))
    }

    pub fn m(&self, name: &str) -> Matrix3<f64> {
        self.matrix(name, 0, "")
    }

    pub fn matrix(&self, name: &str, rate: u8, instant: &str) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| self.at(name, &[i as u16 + 1, j as u16 + 1], rate, instant))
    }

    /// A diagonal matrix of which only the diagonal is stored.
    pub fn d(&self, name: &str) -> Matrix3<f64> {
        Matrix3::from_diagonal(&self.v(name))
    }
}

/// Row-major entries of a matrix.
pub fn rows(m: &Matrix3<f64>) -> Vec<f64> {
    m.transpose().iter().copied().collect()
}

/// Whether two lists of numbers agree to rounding.
pub fn close(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1e-12 * (1.0 + x.abs().max(y.abs())))
}

/// The formulas of the Comment that are read in [`World::rigid_body`], as its source prints them.
pub const COMMENT: &[&str] = &[
    r"\dot R_{ij}=-\epsilon_{jkp}\Omega_k R_{ip}, \quad 
I\dot{\boldsymbol\Omega}=[I{\boldsymbol\Omega},{\boldsymbol\Omega}]. ",
    "I=diagonal (I_1, I_2, I_3)",
    r"E=\frac12 I_i\Omega_i^2",
    r"{\bf m}=RI{\boldsymbol\Omega}",
    r"\Omega_k({\bf m})=(I^{-1}R^T{\bf m})_k",
    r"\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{3k}) R_{ip},  \quad 
E=\frac12 I_i\Omega_i^2({\bf m}).  ",
    r"{\bf x}_N(t)=R(t){\bf x}_N(0)",
    r"R_{ij}(0)=\delta_{ij}",
    r"m_i=I_{ij}\omega_j(0)=I_{ij}\Omega_j(0)",
    "2E= I^{-1}_i m_i^2",
    r"{\bf m}=(0, 0, m_3)",
    r"\dot R_{ij}=-\frac{m_3}{I_k}\epsilon_{jkp}R_{3k}R_{ip}. ",
    r"R= \left(
\begin{array}{ccc}
\cos t &  -\sin t & 0  \\
\sin t & \cos t &  0 \\
0 & 0 & 1
\end{array}\right). ",
    r"\Omega_k({\bf m})=m_3R_{3k}/I_k",
    r"\Omega_k({\bf m})=m_3R_{3i}I'^{-1}_{ik}",
    r"\dot\theta=m_3 I_{(1-2)}\sin\theta\sin\psi\cos\psi, \cr
\dot\varphi=\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi,  \cr
\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta. \\
2E=\frac{m^2_3}{I_3}+m^2_3[I_{(1-3)}-I_{(1-2)}\cos^2\psi]\sin^2\theta, \label{t10}",
    r"I_{(n-k)}=\frac{1}{I_n}-\frac{1}{I_k}",
    r"\frac{d\psi}{d\varphi}=\pm
\frac{\sqrt{(I_{(1-3)}-I_{(1-2)}\cos^2\psi)(1/I_3-2E/m_3^2+I_{(1-3)}-I_{(1-2)}\cos^2\psi)}}{1/I_1-I_{(1-2)}\cos^2\psi}.",
    r"[I_{(1-3)}-I_{(1-2)}\cos^2\psi]\sin^2\theta=0",
    r"\theta\ne 0",
    r"\psi=\psi_0",
    r"\cos^2\psi_0=[I_2(I_3-I_1)]/[I_3(I_2-I_1)]",
    r"\psi(t)=\psi_0",
    r"\dot\theta=\frac12 m_3I_{(1-2)}\sin2\psi_0 \sin\theta",
    r"\dot\varphi=\frac{m_3}{I_3}",
    r"\cos\theta(t)=\frac{1-ce^{2kt}}{1+ce^{2kt}}, \quad 
\varphi=\frac{m_3}{I_3}t+\varphi_0,   \quad 
\psi=\psi_0. ",
    "c> 0",
    r"k\equiv\frac12 m_3I_{(1-2)}\sin2\psi_0\ne 0",
    r"\lim_{t\rightarrow t_0}\theta(t)=0",
    r"R^TR=\mathbb{1}",
    r"I_1\dot\Omega_1=(I_2-I_3)\Omega_2\Omega_3",
];
