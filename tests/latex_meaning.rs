//! Texts that could be misread: each means what LaTeX prints, as a physicist reads it.

#![allow(clippy::type_complexity, reason = "tables of formulas and closures")]
#![expect(clippy::disallowed_methods, reason = "the platform's functions are the independent second route")]

use crate::latex_support::{Point, World, close, rows};
use nalgebra::Matrix3;
use rederive::latex::Role;

fn world() -> World {
    use Role::{Abbreviation, Observable, Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with("b", Parameter, "")
        .with("c", Parameter, "")
        .with("k", Parameter, "")
        .with("t_0", Parameter, "")
        .with(r"\tau", Parameter, "")
        .with(r"\omega", Parameter, "")
        .with("x", State, "")
        .with("y", State, "")
        .with(r"\theta", Observable, "")
        .with(r"\psi", Observable, "")
        .with(r"\psi_0", Parameter, "")
        .with(r"x_{\rm max}", Parameter, "")
        .with("A", State, "3x3")
        .with("B", State, "3x3")
        .with("I", Parameter, "diagonal 3")
        .with(r"{\bf u}", State, "3")
        .with(r"{\bf v}", State, "3")
        .with(r"\vec w", State, "3")
        .by("h", Abbreviation, r"\frac12\dot x^2+\cos\theta")
}

/// Each text has the value of the closure at several points.
fn check(cases: &[(&str, &dyn Fn(&Point) -> f64)]) {
    let mut w = world();
    for (text, wanted) in cases {
        for seed in 1..4 {
            let p = Point::new(seed);
            let (got, wanted) = (w.number(text, &p), wanted(&p));
            assert!(close(&[got], &[wanted]), "{text}: {got} instead of {wanted}");
        }
    }
}

fn same(pairs: &[(&str, &str)]) {
    let mut w = world();
    for (left, right) in pairs {
        let (a, b) = (w.expression(left), w.expression(right));
        assert_eq!(a, b, "{left} and {right}");
    }
}

fn different(pairs: &[(&str, &str)]) {
    let mut w = world();
    for (left, right) in pairs {
        let (a, b) = (w.expression(left), w.expression(right));
        assert_ne!(a, b, "{left} and {right}");
    }
}

#[test]
fn sums_products_powers() {
    check(&[
        ("-a^2", &|p| -(p.s("a") * p.s("a"))),
        ("a-b-c", &|p| p.s("a") - p.s("b") - p.s("c")),
        ("a-(b-c)", &|p| p.s("a") - p.s("b") + p.s("c")),
        (r"\frac12a", &|p| 0.5 * p.s("a")),
        (r"\frac12\cdot 3", &|_| 1.5),
        (r"\frac a b", &|p| p.s("a") / p.s("b")),
        (r"\sqrt2x", &|p| 2f64.sqrt() * p.s("x")),
        (r"\sqrt{2x}", &|p| (2.0 * p.s("x")).sqrt()),
        (r"\sqrt[3]{a}", &|p| p.s("a").cbrt()),
        ("e^xy", &|p| p.s("x").exp() * p.s("y")),
        ("e^{xy}", &|p| (p.s("x") * p.s("y")).exp()),
        (r"\mathrm{e}^{-a}", &|p| (-p.s("a")).exp()),
        (r"{\rm e}^{(a+b)c}", &|p| ((p.s("a") + p.s("b")) * p.s("c")).exp()),
        ("2^{10}", &|_| 1024.0),
        ("10^{-3}a", &|p| 1e-3 * p.s("a")),
        ("a^{1/2}", &|p| p.s("a").sqrt()),
        ("a^{-3/2}", &|p| p.s("a").powf(-1.5)),
        ("a^b", &|p| p.s("a").powf(p.s("b"))),
        ("a^{b^c}", &|p| p.s("a").powf(p.s("b").powf(p.s("c")))),
        (r"a\cdot b/c", &|p| p.s("a") * p.s("b") / p.s("c")),
        ("ab/c", &|p| p.s("a") * p.s("b") / p.s("c")),
        ("a/(bc)", &|p| p.s("a") / (p.s("b") * p.s("c"))),
        ("[a-b]/[a+b]", &|p| (p.s("a") - p.s("b")) / (p.s("a") + p.s("b"))),
        ("a(b-c)", &|p| p.s("a") * (p.s("b") - p.s("c"))),
        ("x(b-c)", &|p| p.s("x") * (p.s("b") - p.s("c"))),
        ("a(-b)", &|p| -p.s("a") * p.s("b")),
        (r"2\pi a", &|p| std::f64::consts::TAU * p.s("a")),
        (r"|a-b||a|", &|p| (p.s("a") - p.s("b")).abs() * p.s("a")),
        (r"|a-b|+|b-c|", &|p| (p.s("a") - p.s("b")).abs() + (p.s("b") - p.s("c")).abs()),
        (r"\left|a-|b-c|\right|", &|p| (p.s("a") - (p.s("b") - p.s("c")).abs()).abs()),
        ("1.5a", &|p| 1.5 * p.s("a")),
        (r"x_{\rm max}a", &|p| p.s(r"x_{\rm max}") * p.s("a")),
        (r"x_{\mathrm{max}}", &|p| p.s(r"x_{\rm max}")),
        (r"\operatorname{agm}(1,1)", &|_| 1.0),
        (r"+a", &|p| p.s("a")),
    ]);
}

#[test]
fn functions() {
    check(&[
        (r"\sin 2\pi x", &|p| (std::f64::consts::TAU * p.s("x")).sin()),
        (r"\sin2\psi_0\sin\theta", &|p| (2.0 * p.s(r"\psi_0")).sin() * p.s(r"\theta").sin()),
        (r"\cos\omega t", &|p| (p.s(r"\omega") * p.s("t")).cos()),
        (r"\cos 2\omega t\sin\theta", &|p| (2.0 * p.s(r"\omega") * p.s("t")).cos() * p.s(r"\theta").sin()),
        (r"\sin^2\psi", &|p| p.s(r"\psi").sin().powi(2)),
        (r"\sin(a+b)c", &|p| (p.s("a") + p.s("b")).sin() * p.s("c")),
        (r"\sin(\theta^2)", &|p| p.s(r"\theta").powi(2).sin()),
        (r"(\sin\theta)^2", &|p| p.s(r"\theta").sin().powi(2)),
        (r"\sin\frac{\theta}{2}", &|p| (p.s(r"\theta") / 2.0).sin()),
        (r"\cos\theta\cdot x", &|p| p.s(r"\theta").cos() * p.s("x")),
        (r"a\sin\theta+b", &|p| p.s("a") * p.s(r"\theta").sin() + p.s("b")),
        (r"1/\sin\theta", &|p| 1.0 / p.s(r"\theta").sin()),
        (r"\sin|x|", &|p| p.s("x").sin()),
        (r"\tan\theta\cot\theta", &|_| 1.0),
        (r"\sec\theta\cos\theta", &|_| 1.0),
        (r"\exp(-a)", &|p| (-p.s("a")).exp()),
        (r"\ln\frac{a}{b}", &|p| (p.s("a") / p.s("b")).ln()),
        (r"\operatorname{atan2}(a,b)", &|p| p.s("a").atan2(p.s("b"))),
        (r"\det A", &|p| p.m("A").determinant()),
        (r"\operatorname{tr}A", &|p| p.m("A").trace()),
        (r"{\rm tr}(AB)", &|p| (p.m("A") * p.m("B")).trace()),
    ]);
}

#[test]
fn vectors_and_matrices() {
    let (u, v) = (r"{\bf u}", r"{\bf v}");
    check(&[
        (r"{\bf u}^2", &|p| p.v(u).norm_squared()),
        (r"|{\bf u}|", &|p| p.v(u).norm()),
        (r"{\bf u}\cdot{\bf v}", &|p| p.v(u).dot(&p.v(v))),
        (r"{\bf u}^T{\bf v}", &|p| p.v(u).dot(&p.v(v))),
        (r"{\bf u}^TA{\bf v}", &|p| (p.v(u).transpose() * p.m("A") * p.v(v))[0]),
        (r"{\bf u}\cdot A{\bf v}", &|p| p.v(u).dot(&(p.m("A") * p.v(v)))),
        (r"{\bf u}\cdot{\bf v}\times\vec w", &|p| p.v(u).dot(&p.v(v).cross(&p.v(r"\vec w")))),
        (r"{\bf u}\cdot[{\bf v},\vec w]", &|p| p.v(u).dot(&p.v(v).cross(&p.v(r"\vec w")))),
        (r"[{\bf u},{\bf v}]_2", &|p| p.v(u).cross(&p.v(v))[1]),
        (r"(A{\bf u})_3", &|p| (p.m("A") * p.v(u))[2]),
        (r"(AB)_{12}", &|p| (p.m("A") * p.m("B"))[(0, 1)]),
        (r"A^T_{12}", &|p| p.m("A")[(1, 0)]),
        (r"A^{-1}_{12}", &|p| p.m("A").try_inverse().expect("regular")[(0, 1)]),
        (r"A_{12}^2", &|p| p.m("A")[(0, 1)].powi(2)),
        (r"(A^2)_{12}", &|p| (p.m("A") * p.m("A"))[(0, 1)]),
        (r"I^{-1}_2", &|p| 1.0 / p.v("I")[1]),
        (r"I_2^{-1}", &|p| 1.0 / p.v("I")[1]),
        (r"I_{22}", &|p| p.v("I")[1]),
        (r"I_{23}", &|_| 0.0),
        (r"u_2", &|p| p.v(u)[1]),
        (r"w_2", &|p| p.v(r"\vec w")[1]),
        (r"{\bf A}_{12}", &|p| p.m("A")[(0, 1)]),
        (r"\mathbf{u}\cdot\boldsymbol{v}", &|p| p.v(u).dot(&p.v(v))),
        (r"\varepsilon_{ijk}u_iv_jw_k", &|p| p.v(u).dot(&p.v(v).cross(&p.v(r"\vec w")))),
        (r"\det(A-a\mathbb{1})", &|p| (p.m("A") - Matrix3::identity() * p.s("a")).determinant()),
    ]);
}

#[test]
fn sums_over_indices() {
    let (u, v) = (r"{\bf u}", r"{\bf v}");
    let sum = |f: &dyn Fn(usize) -> f64| (0..3).map(f).sum::<f64>();
    check(&[
        ("u_iv_i", &|p| p.v(u).dot(&p.v(v))),
        ("(u_iv_i)^2", &|p| p.v(u).dot(&p.v(v)).powi(2)),
        (r"\sqrt{u_iu_i}", &|p| p.v(u).norm()),
        (r"\frac{u_iv_i}{\sqrt{u_ju_j}}", &|p| p.v(u).dot(&p.v(v)) / p.v(u).norm()),
        (r"\frac{1}{u_iu_i}", &|p| 1.0 / p.v(u).norm_squared()),
        (r"u_i(v_i+w_i)", &|p| p.v(u).dot(&(p.v(v) + p.v(r"\vec w")))),
        (r"(u_i+v_i)(u_i-v_i)", &|p| p.v(u).norm_squared() - p.v(v).norm_squared()),
        (r"(u_iv_i+a)(u_iw_i+b)", &|p| (p.v(u).dot(&p.v(v)) + p.s("a")) * (p.v(u).dot(&p.v(r"\vec w")) + p.s("b"))),
        (r"a+u_i^2", &|p| p.s("a") + p.v(u).norm_squared()),
        (r"\frac12I_iu_i^2", &|p| 0.5 * sum(&|i| p.v("I")[i] * p.v(u)[i].powi(2))),
        (r"I_i^2u_i^2", &|p| sum(&|i| (p.v("I")[i] * p.v(u)[i]).powi(2))),
        (r"\frac{u_i^2}{2I_i}", &|p| sum(&|i| p.v(u)[i].powi(2) / (2.0 * p.v("I")[i]))),
        (r"u_i(v_jw_j)v_i", &|p| p.v(u).dot(&p.v(v)) * p.v(v).dot(&p.v(r"\vec w"))),
        (r"A_{ii}", &|p| p.m("A").trace()),
        (r"A_{ij}B_{ji}", &|p| (p.m("A") * p.m("B")).trace()),
        (r"A_{ij}A_{ij}", &|p| p.m("A").norm_squared()),
        (r"A_{1k}u_k", &|p| (p.m("A") * p.v(u))[0]),
        (r"\delta_{ij}u_iv_j", &|p| p.v(u).dot(&p.v(v))),
        (r"(A{\bf u})_iv_i", &|p| (p.m("A") * p.v(u)).dot(&p.v(v))),
        (r"[{\bf u},{\bf v}]_iw_i", &|p| p.v(u).cross(&p.v(v)).dot(&p.v(r"\vec w"))),
        (r"ku_kv_k", &|p| p.s("k") * p.v(u).dot(&p.v(v))),
        (r"\dot u_iv_i", &|p| p.vector(u, 1, "").dot(&p.v(v))),
        (r"u_i(0)v_i", &|p| p.vector(u, 0, "0").dot(&p.v(v))),
        (r"\sin(u_iv_i)", &|p| p.v(u).dot(&p.v(v)).sin()),
        (r"|u_iv_i|", &|p| p.v(u).dot(&p.v(v)).abs()),
        (r"|u_i|^2", &|p| p.v(u).norm_squared()),
        (r"e^{-u_iv_i}", &|p| (-p.v(u).dot(&p.v(v))).exp()),
    ]);
}

#[test]
fn free_indices_of_relations() {
    let mut w = world();
    let (u, v) = (r"{\bf u}", r"{\bf v}");
    let list = |v: nalgebra::Vector3<f64>| v.iter().copied().collect::<Vec<_>>();
    let cases: &[(&str, &dyn Fn(&Point) -> Vec<f64>)] = &[
        ("u_i=A_{ij}v_j", &|p| list(p.m("A") * p.v(v))),
        ("u_j=v_iA_{ij}", &|p| list(p.m("A").transpose() * p.v(v))),
        (r"u_i=I_iv_i", &|p| list(p.v("I").component_mul(&p.v(v)))),
        (r"u_i=v_i(w_jv_j)", &|p| list(p.v(v) * p.v(r"\vec w").dot(&p.v(v)))),
        (r"u_i=v_i(w_i-I_iv_i)", &|p| list(p.v(v).component_mul(&(p.v(r"\vec w") - p.v("I").component_mul(&p.v(v)))))),
        (r"u_i=\epsilon_{ijk}v_jw_k", &|p| list(p.v(v).cross(&p.v(r"\vec w")))),
        (r"u_i=[{\bf v},\vec w]_i", &|p| list(p.v(v).cross(&p.v(r"\vec w")))),
        (r"u_i=\frac{v_i}{\sqrt{v_jv_j}}", &|p| list(p.v(v).normalize())),
        (r"u_i=a\sin v_i", &|p| list(p.v(v).map(|x| p.s("a") * x.sin()))),
        ("u_i=0", &|_| vec![0.0; 3]),
        ("A_{ij}=u_iv_j", &|p| rows(&(p.v(u) * p.v(v).transpose()))),
        ("A_{ij}=B_{ji}", &|p| rows(&p.m("B").transpose())),
        (r"A=B-a\mathbb{1}", &|p| rows(&(p.m("B") - Matrix3::identity() * p.s("a")))),
        (r"A=2\,\mathbb{1}", &|_| rows(&(Matrix3::identity() * 2.0))),
        (r"A={\bf 1}B", &|p| rows(&p.m("B"))),
        (r"A=\mathbf 1-{\bf u}{\bf v}^T", &|p| rows(&(Matrix3::identity() - p.v(u) * p.v(v).transpose()))),
        (r"A=(B+\mathbb{1})^{-1}(B-\mathbb{1})", &|p| {
            let (b, one) = (p.m("B"), Matrix3::identity());
            rows(&((b + one).try_inverse().expect("regular") * (b - one)))
        }),
        (r"A=\frac{a\mathbb{1}}{b}", &|p| rows(&(Matrix3::identity() * (p.s("a") / p.s("b"))))),
        (r"{\bf u}=(a,b,c)", &|p| vec![p.s("a"), p.s("b"), p.s("c")]),
        (r"{\bf u}={\bf v}({\bf v}\cdot\vec w)", &|p| list(p.v(v) * p.v(v).dot(&p.v(r"\vec w")))),
        (r"{\bf u}=\begin{pmatrix}a\\b\\c\end{pmatrix}", &|p| vec![p.s("a"), p.s("b"), p.s("c")]),
        (r"A=diag(a,b,c)", &|p| rows(&Matrix3::from_diagonal(&nalgebra::Vector3::new(p.s("a"), p.s("b"), p.s("c"))))),
    ];
    for (text, wanted) in cases {
        for seed in 1..4 {
            let p = Point::new(seed);
            let r = w.read(text)[0].relations[0].clone();
            let got: Vec<f64> = w.values(&r.right.components, &p).into_iter().map(|v| v.unwrap_or(f64::NAN)).collect();
            assert!(close(&got, &wanted(&p)), "{text}: {got:?}");
        }
    }
}

#[test]
fn times_and_rates() {
    check(&[
        (r"\theta(t)", &|p| p.s(r"\theta")),
        (r"\theta(0)", &|p| p.at(r"\theta", &[], 0, "0")),
        (r"\theta(t_0)", &|p| p.at(r"\theta", &[], 0, "t_0")),
        (r"\theta(-1)", &|p| p.at(r"\theta", &[], 0, "-1")),
        (r"\theta(\tau/2)", &|p| p.at(r"\theta", &[], 0, r"\frac{\tau}{2}")),
        (r"\theta(2\pi/\omega)", &|p| p.at(r"\theta", &[], 0, r"\frac{2\cdot \pi}{\omega}")),
        (r"\dot\theta(0)", &|p| p.at(r"\theta", &[], 1, "0")),
        (r"\ddot x", &|p| p.at("x", &[], 2, "")),
        (r"\dot{\bf u}_2", &|p| p.vector(r"{\bf u}", 1, "")[1]),
        (r"\dot{u_2}", &|p| p.vector(r"{\bf u}", 1, "")[1]),
        (r"\dot h", &|p| p.rate("x") * p.at("x", &[], 2, "") - p.s(r"\theta").sin() * p.rate(r"\theta")),
        (r"\frac{d}{dt}(a+b)", &|_| 0.0),
        (r"h(0)", &|p| 0.5 * p.at("x", &[], 1, "0").powi(2) + p.at(r"\theta", &[], 0, "0").cos()),
        (r"\frac{dx}{dt}", &|p| p.rate("x")),
        (r"\frac{\mathrm{d}x}{\mathrm{d}t}", &|p| p.rate("x")),
        (r"\frac{d^2x}{dt^2}", &|p| p.at("x", &[], 2, "")),
        (r"\frac{d}{dt}(xy)", &|p| p.rate("x") * p.s("y") + p.s("x") * p.rate("y")),
        (r"\frac{d}{dt}\cos\theta", &|p| -p.s(r"\theta").sin() * p.rate(r"\theta")),
        (r"\frac{d(xy)}{dt}", &|p| p.rate("x") * p.s("y") + p.s("x") * p.rate("y")),
        (r"\frac{d\psi}{d\theta}", &|p| p.rate(r"\psi") / p.rate(r"\theta")),
        (r"\frac{dA_{12}}{dt}", &|p| p.matrix("A", 1, "")[(0, 1)]),
        (r"(A(0)^TA)_{12}", &|p| (p.matrix("A", 0, "0").transpose() * p.m("A"))[(0, 1)]),
        (r"x(t)^2", &|p| p.s("x").powi(2)),
        (r"x^2(0)", &|p| p.at("x", &[], 0, "0").powi(2)),
    ]);
}

#[test]
fn spellings_of_the_same() {
    same(&[
        (r"{\bf u}\cdot{\bf v}", r"\mathbf u\cdot\mathbf{v}"),
        (r"\left(a+b\right)c", r"(a+b)\,c"),
        (r"a\,b\;c\!", "abc"),
        (r"a~b % a remark", "ab"),
        (r"\dot{\theta}", r"\dot\theta"),
        (r"A_{1 2}", "A_{12}"),
        (r"A_{1,2}", "A_{12}"),
        (r"A^\top", r"A^{\mathrm{T}}"),
        (r"{ab}c", "abc"),
        (r"\tfrac12", r"\dfrac{1}{2}"),
        (r"{\dot{\bf u}}_1", r"\dot{\bf u}_1"),
        (r"\left[a+b\right]", "(a+b)"),
        (r"\bigl(a+b\bigr)c", "(a+b)c"),
    ]);
    different(&[("a/(b/c)", "(a/b)/c"), ("(a^b)^c", "a^{b^c}"), (r"\sin^2x", r"\sin(x^2)"), ("2^{12}", "2^1 a")]);
}

#[test]
fn branches_go_together() {
    let mut w = world();
    let value = |w: &mut World, text: &str, sign: f64| w.number(text, &Point::new(3).set(r"\pm", sign));
    let (a, b) = (Point::new(3).s("a"), Point::new(3).s("b"));
    for sign in [1.0, -1.0] {
        assert!(close(&[value(&mut w, r"\pm a\mp b", sign)], &[sign * (a - b)]));
        assert!(close(&[value(&mut w, r"a\pm b", sign)], &[a + sign * b]));
        assert!(close(&[value(&mut w, r"(\pm a)(\pm b)", sign)], &[a * b]));
    }
    // Two statements of one text mean the same branch.
    let s = w.read(r"x=\pm a,\quad y=\mp b");
    assert!(s.iter().all(|s| s.relations[0].has_branches));
    assert!(!w.read("x=a")[0].relations[0].has_branches);
}

#[test]
fn several_statements() {
    let mut w = world();
    for text in [r"x=a, y=b", r"x=a\\ y=b", r"x=a, \cr y=b.", r"x&=a,\\ y&=b \label{e}", r"x=a;\quad y=b"] {
        assert_eq!(w.read(text).len(), 2, "{text}");
    }
    let chain = &w.read("a<b\\le c\\ne 0")[0];
    assert_eq!(chain.relations.len(), 3);
    assert_eq!(w.read("0=u_i")[0].relations[0].left.components.len(), 3);
    assert_eq!(w.read(r"0={\bf u}")[0].relations[0].left.components.len(), 3);
}

#[test]
fn inner_scopes_hide_outer_ones() {
    let w = world();
    // In a claim, ω is an abbreviation and k too, while k stays an index.
    let mut inner = w.clone().by(r"\omega", Role::Abbreviation, "a/b").by("k", Role::Abbreviation, "2a");
    let p = Point::new(2);
    assert!(close(&[inner.number(r"\omega k", &p)], &[2.0 * p.s("a") * p.s("a") / p.s("b")]));
    assert!(close(&[inner.number("ku_kv_k", &p)], &[2.0 * p.s("a") * p.v(r"{\bf u}").dot(&p.v(r"{\bf v}"))]));
    // The meaning of an abbreviation is that of its own place.
    let mut later = w.clone().by("q", Role::Abbreviation, "2a").by("a", Role::Abbreviation, "5b");
    assert!(close(&[later.number("q", &p)], &[2.0 * p.s("a")]));
    assert!(close(&[later.number("a", &p)], &[5.0 * p.s("b")]));
    // e and d may be names.
    let mut named = w.clone().with("e", Role::Parameter, "");
    assert!(close(&[named.number("e^2", &p)], &[p.s("e").powi(2)]));
    assert!(close(&[named.number(r"\mathrm{e}^2", &p)], &[2f64.exp()]));
}

#[test]
fn declared_vectors_functions_and_labels() {
    let mut w = world();
    w.define("L_i", Role::Observable, r"\epsilon_{ijk}u_jv_k", &[]);
    w.define(
        r"Z(\alpha)",
        Role::Abbreviation,
        r"\begin{pmatrix}\cos\alpha&-\sin\alpha\\\sin\alpha&\cos\alpha\end{pmatrix}",
        &[r"\alpha"],
    );
    w.define("S_{jk}", Role::Abbreviation, r"\frac12(A_{jk}+A_{kj})", &[]);
    let p = Point::new(5);
    assert!(close(&w.numbers("L_2", &p), &[p.at("L", &[2], 0, "")]));
    assert!(close(&w.numbers(r"\dot L_2", &p), &[p.at("L", &[2], 1, "")]));
    assert!(close(&w.numbers(r"Z(2\theta)_{12}", &p), &[-(2.0 * p.s(r"\theta")).sin()]));
    let trace = p.m("A").trace();
    assert!(close(&w.numbers("S_{ii}", &p), &[trace]));
    assert!(close(&w.numbers("S_{12}", &p), &[(p.m("A")[(0, 1)] + p.m("A")[(1, 0)]) / 2.0]));
}

#[test]
fn a_written_zero_keeps_what_has_no_value() {
    let mut w = world();
    for text in
        [r"0\cdot\frac{1}{a-a}", r"0\frac{1}{a-a}", r"\frac{0}{a-a}", r"(1-1)\frac{1}{a-a}", r"\frac02\frac{1}{a-a}"]
    {
        let t = w.expression(text);
        assert_eq!(w.values(&t.components, &Point::new(1)), [None], "{text}");
    }
    // An entry that is not there takes nothing with it.
    let t = w.expression(r"\frac{\delta_{12}}{a-a}");
    assert_eq!(w.values(&t.components, &Point::new(1)), [Some(0.0)]);
}
