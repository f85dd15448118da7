//! Every formula of the Comment, as its source prints it, means what a physicist reads there: each component of both
//! sides is evaluated at random points and compared with the same thing written in matrices.
#![expect(clippy::disallowed_methods, reason = "the platform's functions are the independent second route")]

use crate::latex_support::{Point, World, close, rows};
use nalgebra::{Matrix3, Vector3};
use rederive::latex::{LimitPoint, Relation, RelationKind, Role, Statement};

const POINTS: std::ops::Range<u64> = 1..6;

/// Compares both sides of one relation with what they should be.
fn means(world: &World, relation: &Relation, wanted: impl Fn(&Point) -> (Vec<f64>, Vec<f64>)) {
    means_at(world, relation, |p| p, wanted);
}

fn means_at(
    world: &World,
    relation: &Relation,
    place: impl Fn(Point) -> Point,
    wanted: impl Fn(&Point) -> (Vec<f64>, Vec<f64>),
) {
    for seed in POINTS {
        let point = place(Point::new(seed));
        let (left, right) = wanted(&point);
        for (side, tensor, expected) in [("left", &relation.left, left), ("right", &relation.right, right)] {
            let values = world.values(&tensor.components, &point);
            let got: Vec<f64> = values.into_iter().map(|v| v.unwrap_or(f64::NAN)).collect();
            assert!(close(&got, &expected), "{side} side: {got:?} instead of {expected:?}");
        }
    }
}

/// The only relation of the only statement of a text.
fn one(world: &mut World, text: &str) -> Relation {
    let mut statements = world.read(text);
    assert_eq!(statements.len(), 1, "{text}");
    relation(&mut statements, 0)
}

fn relation(statements: &mut [Statement], which: usize) -> Relation {
    let relations = &mut statements[which].relations;
    assert_eq!(relations.len(), 1);
    relations[0].clone()
}

fn unit(i: usize) -> Vector3<f64> {
    Vector3::from_fn(|k, _| f64::from(u8::from(k == i)))
}

/// The matrix that maps w to v × w.
fn cross(v: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::from_columns(&[v.cross(&unit(0)), v.cross(&unit(1)), v.cross(&unit(2))])
}

fn list(v: &Vector3<f64>) -> Vec<f64> {
    v.iter().copied().collect()
}

/// I₍ₐ₋ᵦ₎
fn gap(p: &Point, a: u16, b: u16) -> f64 {
    1.0 / p.at("I", &[a], 0, "") - 1.0 / p.at("I", &[b], 0, "")
}

fn i(p: &Point, k: u16) -> f64 {
    p.at("I", &[k], 0, "")
}

fn m3(p: &Point) -> f64 {
    p.at(r"{\bf m}", &[3], 0, "")
}

#[test]
fn t1_euler_poisson() {
    let mut w = World::rigid_body();
    let body = r"\begin{eqnarray}\label{t1} 
\dot R_{ij}=-\epsilon_{jkp}\Omega_k R_{ip}, \quad 
I\dot{\boldsymbol\Omega}=[I{\boldsymbol\Omega},{\boldsymbol\Omega}]. 
\end{eqnarray}";
    let inner = "\\label{t1} \n\\dot R_{ij}=-\\epsilon_{jkp}\\Omega_k R_{ip}, \\quad \nI\\dot{\\boldsymbol\\Omega}=[I{\\boldsymbol\\Omega},{\\boldsymbol\\Omega}]. \n";
    for text in [body, inner] {
        let mut s = w.read(text);
        assert_eq!(s.len(), 2);
        let poisson = relation(&mut s, 0);
        assert_eq!(poisson.indices, ["i", "j"]);
        // (RΩ̂)ᵢⱼ = Rᵢₚ Ω̂ₚⱼ with Ω̂ₚⱼ = ε_{pkj}Ω_k = −ε_{jkp}Ω_k, which is (Ω ×)ₚⱼ.
        means(&w, &poisson, |p| (rows(&p.matrix("R", 1, "")), rows(&(p.m("R") * cross(&p.v(r"\Omega"))))));
        let euler = relation(&mut s, 1);
        means(&w, &euler, |p| {
            let (inertia, omega) = (p.d("I"), p.v(r"\Omega"));
            (list(&(inertia * p.vector(r"\Omega", 1, ""))), list(&(inertia * omega).cross(&omega)))
        });
    }
}

#[test]
fn definitions_beside_t1() {
    let mut w = World::rigid_body();
    let r = one(&mut w, "I=diagonal (I_1, I_2, I_3)");
    means(&w, &r, |p| (rows(&p.d("I")), rows(&p.d("I"))));
    let r = one(&mut w, r"E=\frac12 I_i\Omega_i^2");
    means(&w, &r, |p| (vec![p.s("E")], vec![0.5 * p.v(r"\Omega").dot(&(p.d("I") * p.v(r"\Omega")))]));
    let r = one(&mut w, r"{\bf m}=RI{\boldsymbol\Omega}");
    means(&w, &r, |p| (list(&p.v(r"{\bf m}")), list(&(p.m("R") * p.d("I") * p.v(r"\Omega")))));
    let r = one(&mut w, r"\Omega_k({\bf m})=(I^{-1}R^T{\bf m})_k");
    means(&w, &r, |p| {
        let omega = list(&omega_of_m(p));
        (omega.clone(), omega)
    });
    // Not the same as the dynamical variable.
    let r = one(&mut w, r"\Omega_k=(I^{-1}R^T{\bf m})_k");
    means(&w, &r, |p| (list(&p.v(r"\Omega")), list(&omega_of_m(p))));
}

fn omega_of_m(p: &Point) -> Vector3<f64> {
    let transported = p.m("R").transpose() * p.v(r"{\bf m}");
    Vector3::from_fn(|k, _| transported[k] / i(p, k as u16 + 1))
}

#[test]
fn t3() {
    let mut w = World::rigid_body();
    let mut s = w.read(
        r"\begin{eqnarray}\label{t3}  
\dot R_{ij}=-I_k^{-1}\epsilon_{jkp}(m_1R_{1k}+m_2R_{2k}+m_3R_{3k}) R_{ip},  \quad 
E=\frac12 I_i\Omega_i^2({\bf m}).  
\end{eqnarray}",
    );
    let poisson = relation(&mut s, 0);
    means(&w, &poisson, |p| (rows(&p.matrix("R", 1, "")), rows(&(p.m("R") * cross(&omega_of_m(p))))));
    let energy = relation(&mut s, 1);
    means(&w, &energy, |p| {
        let omega = omega_of_m(p);
        (vec![p.s("E")], vec![0.5 * omega.dot(&(p.d("I") * omega))])
    });
}

#[test]
fn initial_values() {
    let mut w = World::rigid_body();
    let r = one(&mut w, r"{\bf x}_N(t)=R(t){\bf x}_N(0)");
    means(&w, &r, |p| (list(&p.v(r"{\bf x}_N")), list(&(p.m("R") * p.vector(r"{\bf x}_N", 0, "0")))));
    let r = one(&mut w, r"R_{ij}(0)=\delta_{ij}");
    means(&w, &r, |p| (rows(&p.matrix("R", 0, "0")), rows(&Matrix3::identity())));
    let statements = w.read(r"m_i=I_{ij}\omega_j(0)=I_{ij}\Omega_j(0)");
    let [first, second] = statements[0].relations.as_slice() else { panic!("a chain of two") };
    let momentum = |p: &Point, name: &str| list(&(p.d("I") * p.vector(name, 0, "0")));
    means(&w, first, |p| (list(&p.v(r"{\bf m}")), momentum(p, r"\omega")));
    means(&w, second, |p| (momentum(p, r"\omega"), momentum(p, r"\Omega")));
    let r = one(&mut w, "2E= I^{-1}_i m_i^2");
    means(&w, &r, |p| {
        let m = p.v(r"{\bf m}");
        (vec![2.0 * p.s("E")], vec![(0..3).map(|k| m[k] * m[k] / i(p, k as u16 + 1)).sum()])
    });
    let r = one(&mut w, r"{\bf m}=(0, 0, m_3)");
    means(&w, &r, |p| (list(&p.v(r"{\bf m}")), vec![0.0, 0.0, m3(p)]));
}

#[test]
fn t7_and_t8() {
    let mut w = World::rigid_body();
    let r = one(
        &mut w,
        r"\begin{eqnarray}\label{t7.1}
\dot R_{ij}=-\frac{m_3}{I_k}\epsilon_{jkp}R_{3k}R_{ip}. 
\end{eqnarray}",
    );
    let omega = |p: &Point| Vector3::from_fn(|k, _| m3(p) * p.m("R")[(2, k)] / i(p, k as u16 + 1));
    means(&w, &r, |p| (rows(&p.matrix("R", 1, "")), rows(&(p.m("R") * cross(&omega(p))))));
    let r = one(&mut w, r"\Omega_k({\bf m})=m_3R_{3k}/I_k");
    means(&w, &r, |p| (list(&omega_of_m(p)), list(&omega(p))));
    let r = one(&mut w, r"\Omega_k({\bf m})=m_3R_{3i}I'^{-1}_{ik}");
    means(&w, &r, |p| {
        let inverse = p.m("I'").try_inverse().expect("a random matrix is regular");
        (list(&omega_of_m(p)), list(&(m3(p) * (p.m("R").row(2) * inverse).transpose())))
    });
    // ω is a number here, not the vector of the section before.
    let mut w = w.by(r"\omega", Role::Abbreviation, "m_3/I_3");
    let r = one(
        &mut w,
        r"\begin{eqnarray}\label{t8}
R= \left(
\begin{array}{ccc}
\cos\omega t &  -\sin\omega t & 0  \\
\sin\omega t & \cos\omega t &  0 \\
0 & 0 & 1
\end{array}\right). 
\end{eqnarray}",
    );
    means(&w, &r, |p| {
        let angle = m3(p) / i(p, 3) * p.s("t");
        let (s, c) = (angle.sin(), angle.cos());
        (rows(&p.m("R")), vec![c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0])
    });
    let r = one(&mut w, r"\omega=m_3/I_3");
    means(&w, &r, |p| (vec![m3(p) / i(p, 3)], vec![m3(p) / i(p, 3)]));
}

#[test]
fn t9_and_t10() {
    let mut w = World::rigid_body();
    let mut s = w.read(
        r"\begin{eqnarray}\label{t9}
\dot\theta=m_3 I_{(1-2)}\sin\theta\sin\psi\cos\psi, \cr
\dot\varphi=\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi,  \cr
\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta. \\
2E=\frac{m^2_3}{I_3}+m^2_3[I_{(1-3)}-I_{(1-2)}\cos^2\psi]\sin^2\theta, \label{t10}
\end{eqnarray}",
    );
    assert_eq!(s.len(), 4);
    let turning = |p: &Point| {
        let (sin, cos) = p.s(r"\psi").sin_cos();
        m3(p) / i(p, 1) * sin * sin + m3(p) / i(p, 2) * cos * cos
    };
    let theta = relation(&mut s, 0);
    means(&w, &theta, |p| {
        let (psi, theta) = (p.s(r"\psi"), p.s(r"\theta"));
        (vec![p.rate(r"\theta")], vec![m3(p) * gap(p, 1, 2) * theta.sin() * psi.sin() * psi.cos()])
    });
    let phi = relation(&mut s, 1);
    means(&w, &phi, |p| (vec![p.rate(r"\varphi")], vec![turning(p)]));
    let psi = relation(&mut s, 2);
    means(&w, &psi, |p| (vec![p.rate(r"\psi")], vec![(m3(p) / i(p, 3) - turning(p)) * p.s(r"\theta").cos()]));
    let energy = relation(&mut s, 3);
    means(&w, &energy, |p| {
        let (c, s) = (p.s(r"\psi").cos(), p.s(r"\theta").sin());
        let bracket = gap(p, 1, 3) - gap(p, 1, 2) * c * c;
        (vec![2.0 * p.s("E")], vec![m3(p) * m3(p) / i(p, 3) + m3(p) * m3(p) * bracket * s * s])
    });
    for label in [r"I_{(n-k)}=\frac{1}{I_n}-\frac{1}{I_k}", r"I_{(i-j)}=\frac{1}{I_i}-\frac{1}{I_j}"] {
        let r = one(&mut w, label);
        means(&w, &r, |p| {
            let all: Vec<f64> = (1..4).flat_map(|a| (1..4).map(move |b| (a, b))).map(|(a, b)| gap(p, a, b)).collect();
            (all.clone(), all)
        });
    }
}

const T11: &str = r"\begin{eqnarray}\label{t11}
\frac{d\psi}{d\varphi}=\pm
\frac{\sqrt{(I_{(1-3)}-I_{(1-2)}\cos^2\psi)(1/I_3-2E/m_3^2+I_{(1-3)}-I_{(1-2)}\cos^2\psi)}}{1/I_1-I_{(1-2)}\cos^2\psi}.
\end{eqnarray}";

#[test]
fn t11_on_both_branches() {
    let mut w = World::rigid_body();
    let r = one(&mut w, T11);
    assert!(r.has_branches);
    for sign in [1.0, -1.0] {
        // Moments for which both factors under the root are positive.
        let place = |p: Point| p.set(r"\pm", sign);
        let mut compared = 0;
        for seed in 1..200 {
            let p = place(Point::new(seed));
            let c2 = p.s(r"\psi").cos().powi(2);
            let first = gap(&p, 1, 3) - gap(&p, 1, 2) * c2;
            let second = 1.0 / i(&p, 3) - 2.0 * p.s("E") / (m3(&p) * m3(&p)) + first;
            let got = w.values(&[r.left.components[0], r.right.components[0]], &p);
            assert!(close(&[got[0].expect("a quotient")], &[p.rate(r"\psi") / p.rate(r"\varphi")]));
            if first * second < 0.0 {
                assert_eq!(got[1], None);
                continue;
            }
            compared += 1;
            let wanted = sign * (first * second).sqrt() / (1.0 / i(&p, 1) - gap(&p, 1, 2) * c2);
            assert!(close(&[got[1].expect("a value")], &[wanted]));
        }
        assert!(compared > 20);
    }
}

#[test]
fn the_consequences_of_t10() {
    let mut w = World::rigid_body();
    let r = one(&mut w, r"[I_{(1-3)}-I_{(1-2)}\cos^2\psi]\sin^2\theta=0");
    means(&w, &r, |p| {
        let (c, s) = (p.s(r"\psi").cos(), p.s(r"\theta").sin());
        (vec![(gap(p, 1, 3) - gap(p, 1, 2) * c * c) * s * s], vec![0.0])
    });
    let r = one(&mut w, r"\theta\ne 0");
    assert_eq!(r.kind, RelationKind::NotEqual);
    means(&w, &r, |p| (vec![p.s(r"\theta")], vec![0.0]));
    for text in [r"\psi=\psi_0", r"\psi(t)=\psi_0"] {
        let r = one(&mut w, text);
        means(&w, &r, |p| (vec![p.s(r"\psi")], vec![p.s(r"\psi_0")]));
    }
    let r = one(&mut w, r"\cos^2\psi_0=[I_2(I_3-I_1)]/[I_3(I_2-I_1)]");
    means(&w, &r, |p| {
        let right = i(p, 2) * (i(p, 3) - i(p, 1)) / (i(p, 3) * (i(p, 2) - i(p, 1)));
        (vec![p.s(r"\psi_0").cos().powi(2)], vec![right])
    });
    let r = one(&mut w, r"\dot\theta=\frac12 m_3I_{(1-2)}\sin2\psi_0 \sin\theta");
    means(&w, &r, |p| {
        let right = 0.5 * m3(p) * gap(p, 1, 2) * (2.0 * p.s(r"\psi_0")).sin() * p.s(r"\theta").sin();
        (vec![p.rate(r"\theta")], vec![right])
    });
    let r = one(&mut w, r"\dot\varphi=\frac{m_3}{I_3}");
    means(&w, &r, |p| (vec![p.rate(r"\varphi")], vec![m3(p) / i(p, 3)]));
}

#[test]
fn t15() {
    let mut w = World::rigid_body().with("c", Role::Parameter, "").by(
        "k",
        Role::Abbreviation,
        r"\frac12 m_3I_{(1-2)}\sin2\psi_0",
    );
    let rate = |p: &Point| 0.5 * m3(p) * gap(p, 1, 2) * (2.0 * p.s(r"\psi_0")).sin();
    let mut s = w.read(
        r"\begin{eqnarray}\label{t15}
\cos\theta(t)=\frac{1-ce^{2kt}}{1+ce^{2kt}}, \quad 
\varphi=\frac{m_3}{I_3}t+\varphi_0,   \quad 
\psi=\psi_0. 
\end{eqnarray}",
    );
    assert_eq!(s.len(), 3);
    let theta = relation(&mut s, 0);
    means(&w, &theta, |p| {
        let grown = p.s("c") * (2.0 * rate(p) * p.s("t")).exp();
        (vec![p.s(r"\theta").cos()], vec![(1.0 - grown) / (1.0 + grown)])
    });
    let phi = relation(&mut s, 1);
    means(&w, &phi, |p| (vec![p.s(r"\varphi")], vec![m3(p) / i(p, 3) * p.s("t") + p.s(r"\varphi_0")]));
    let psi = relation(&mut s, 2);
    means(&w, &psi, |p| (vec![p.s(r"\psi")], vec![p.s(r"\psi_0")]));
    let r = one(&mut w, "c> 0");
    assert_eq!(r.kind, RelationKind::Greater);
    let statements = w.read(r"k\equiv\frac12 m_3I_{(1-2)}\sin2\psi_0\ne 0");
    let [same, different] = statements[0].relations.as_slice() else { panic!("a chain of two") };
    assert_eq!((same.kind, different.kind), (RelationKind::Equal, RelationKind::NotEqual));
    means(&w, same, |p| (vec![rate(p)], vec![rate(p)]));
    means(&w, different, |p| (vec![rate(p)], vec![0.0]));
    // With k a constant, the index k of the other equations is still an index.
    let r = one(&mut w, r"\dot R_{ij}=-\frac{m_3}{I_k}\epsilon_{jkp}R_{3k}R_{ip}.");
    let omega = |p: &Point| Vector3::from_fn(|k, _| m3(p) * p.m("R")[(2, k)] / i(p, k as u16 + 1));
    means(&w, &r, |p| (rows(&p.matrix("R", 1, "")), rows(&(p.m("R") * cross(&omega(p))))));
}

#[test]
fn limits() {
    let mut w = World::rigid_body();
    let r = one(&mut w, r"\lim_{t\rightarrow t_0}\theta(t)=0");
    let Some(LimitPoint::Finite(target)) = r.limit.as_ref().map(|l| l.approaches.clone()) else {
        panic!("a limit at a finite time")
    };
    assert_eq!(w.graph.to_latex(target), "t_0");
    means(&w, &r, |p| (vec![p.s(r"\theta")], vec![0.0]));
    let r = one(&mut w, r"\lim_{t\rightarrow 0}\theta(t)=0");
    let Some(LimitPoint::Finite(target)) = r.limit.map(|l| l.approaches) else { panic!("a limit at 0") };
    assert!(w.graph.is_zero(target));
    for (text, wanted) in [
        (r"\lim_{t\to+\infty}\theta=0", LimitPoint::PlusInfinity),
        (r"\lim_{t\to\infty}\theta=0", LimitPoint::PlusInfinity),
        (r"\lim_{t\rightarrow-\infty}\theta(t)=\pi", LimitPoint::MinusInfinity),
    ] {
        assert_eq!(one(&mut w, text).limit.map(|l| l.approaches), Some(wanted));
    }
}

#[test]
fn formulas_that_belong_to_sentences_about_the_comment() {
    let mut w = World::rigid_body();
    let r = one(&mut w, r"R^TR=\mathbb{1}");
    means(&w, &r, |p| (rows(&(p.m("R").transpose() * p.m("R"))), rows(&Matrix3::identity())));
    let r = one(&mut w, r"I_1\dot\Omega_1=(I_2-I_3)\Omega_2\Omega_3");
    means(&w, &r, |p| {
        let (rate, omega) = (p.vector(r"\Omega", 1, ""), p.v(r"\Omega"));
        (vec![i(p, 1) * rate[0]], vec![(i(p, 2) - i(p, 3)) * omega[1] * omega[2]])
    });
}
