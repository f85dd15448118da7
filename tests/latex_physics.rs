//! What books on physics print: names, brackets of matrices, subscripts that count bodies. Each text means what a physicist reads, and what
//! could be read in two ways beside it is refused.

use crate::latex_support::World;
use rederive::latex::{Declaration, DeclareError, Role};

fn world() -> World {
    use Role::{Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with("x", State, "")
        .with(r"\theta", State, "")
        .with("A", State, "3x3")
        .with("B", State, "3x3")
        .with("J_+", Parameter, "2x2")
        .with("J_-", Parameter, "2x2")
        .with(r"{\bf u}", State, "3")
        .with(r"{\bf v}", State, "3")
}

fn two_bodies() -> World {
    World::empty()
        .with("t", Role::Time, "")
        .with(r"{\bf r}", Role::State, "3")
        .with(r"{\bf r}_1", Role::State, "3")
        .with(r"{\bf r}_2", Role::State, "3")
        .by("r_1", Role::Abbreviation, r"|{\bf r}_1|")
}

#[track_caller]
fn same(w: &World, pairs: &[(&str, &str)]) {
    let mut w = w.clone();
    for (left, right) in pairs {
        let (a, b) = (w.expression(left), w.expression(right));
        assert_eq!(a, b, "{left} and {right}");
    }
}

/// The code and the hint with which a text is refused.
#[track_caller]
fn refusal(w: &World, text: &str) -> (&'static str, String) {
    let mut w = w.clone();
    let problems = match w.try_expression(text) {
        Err(problems) => problems,
        Ok(t) => {
            panic!("`{text}` was read as {:?}", t.components.iter().map(|&e| w.graph.to_latex(e)).collect::<Vec<_>>())
        }
    };
    (problems[0].code, problems[0].hint.clone().unwrap_or_default())
}

#[track_caller]
fn refused(w: &World, code: &str, texts: &[&str]) {
    for text in texts {
        assert_eq!(refusal(w, text).0, code, "{text}");
    }
}

fn declared(w: &World, key: &str, shape: &str) -> Result<(), DeclareError> {
    let mut w = w.clone();
    let shape = (!shape.is_empty()).then(|| rederive::expr::Shape::vector(3));
    let declaration = Declaration { shape, ..Declaration::of(Role::Parameter) };
    w.scope.declare(&mut w.graph, key, declaration).map(|_| ())
}

#[test]
fn a_subscript_counts_bodies_where_one_is_declared_so() {
    let w = two_bodies();
    same(
        &w,
        &[
            (r"\dot{\bf r}-\dot{\bf r}_1", r"\frac{d}{dt}({\bf r}-{\bf r}_1)"),
            ("r_1", r"\sqrt{{\bf r}_1\cdot{\bf r}_1}"),
        ],
    );
    same(&w, &[(r"({\bf r})_i({\bf r})_i", r"{\bf r}\cdot{\bf r}"), (r"({\bf r}_1)_2", r"{\bf r}_{12}")]);
    // A component, or another body.
    refused(&w, "latex::ambiguous", &[r"{\bf r}_3", "r_2", "r_3", r"{\bf r}_i{\bf r}_i", "r_ir_i"]);
    let (_, hint) = refusal(&w, "r_2");
    assert!(hint.contains(r"({\bf r})_") && hint.contains("declare"), "{hint}");
    // What is printed of a component is read as it.
    let mut again = w.clone();
    for component in again.expression(r"{\bf r}").components {
        let text = again.graph.to_latex(component);
        assert_eq!(again.expression(&text).components, [component], "{text}");
    }
}

#[test]
fn a_number_that_could_be_a_component_is_refused() {
    let w = two_bodies();
    assert!(declared(&w, "r_2", "").is_ok());
    assert!(declared(&w, "r_3", "").is_err());
    assert!(declared(&w, r"{\bf r}_3", "3").is_ok());
    let w = world();
    for key in ["u_1", r"{\bf u}_1", "u_i", "A_{12}"] {
        assert!(declared(&w, key, "").is_err(), "{key}");
    }
    assert!(declared(&w, r"{\bf u}_1", "3").is_ok());
}

#[test]
fn signs_and_stars_are_labels() {
    let w = world().with("x_+", Role::State, "").with("t_-", Role::Parameter, "").with("a_*", Role::Parameter, "");
    same(&w, &[("J_+", "J_{+}"), ("x_++x", "x+x_+"), ("x_+x", r"x\cdot x_+"), ("x_+(t_-)", "x_{+}(t_{-})")]);
    let primed = world().with(r"{\bf A}^\prime", Role::Parameter, "").with("A'", Role::State, "");
    same(&primed, &[(r"{\bf A}'A'", r"\mathbf A^\prime\cdot A'")]);
    same(&w, &[("a_*a", r"a_*\cdot a"), ("(x_+x)(t_-)", "x_+(t_-)x(t_-)")]);
    refused(&w, "latex::ambiguous", &["x_+1", "x_-1"]);
    refused(&w, "latex::unexpected", &[r"J_\pm", r"x_\mp", "x^+"]);
    refused(&w, "latex::index", &["x_-", "a_+"]);
}

#[test]
fn pi_is_a_number_where_it_is_not_declared() {
    let w = world().with(r"m_\pi", Role::Parameter, "").with(r"\hat\pi", Role::Parameter, "");
    let mut plain = w.clone();
    for text in [r"\pi", r"{\pi}", r"2\pi-\pi", r"\frac\pi1"] {
        let value = plain.expression(text).components[0];
        assert!(plain.graph.leaves([value]).is_empty(), "{text}");
    }
    let leaves = |w: &World, text: &str| {
        let mut w = w.clone();
        let value = w.expression(text).components[0];
        w.graph.leaves([value]).len()
    };
    assert_eq!(leaves(&w, r"m_\pi\pi"), 1);
    assert_eq!(leaves(&w, r"\hat\pi"), 1);
    let momentum = w.with(r"\pi", Role::State, "");
    for text in [r"\pi", r"{\pi}", r"\frac\pi2", r"\sin\pi", r"\dot\pi", r"\pi(0)", r"x^\pi"] {
        assert!(leaves(&momentum, text) >= 1, "{text}");
    }
    let pair = world().with(r"\pi_1", Role::State, "");
    assert_eq!((leaves(&pair, r"\pi_1"), leaves(&pair, r"\pi"), leaves(&pair, r"\pi_1\pi")), (1, 0, 1));
}

#[test]
fn brackets_of_matrices() {
    let w = world();
    same(
        &w,
        &[
            ("[A,B]", "AB-BA"),
            (r"\{A,B\}", "AB+BA"),
            (r"\left[A,B\right]^T", "(AB-BA)^T"),
            ("[J_+,J_-]_{12}", "(J_+J_--J_-J_+)_{12}"),
            ("[[A,B],A]", "(AB-BA)A-A(AB-BA)"),
            (r"[A,\mathbb{1}]", "A-A"),
            (r"[{\bf u},{\bf v}]", r"{\bf u}\times{\bf v}"),
        ],
    );
    refused(
        &w,
        "latex::shape",
        &["[A,J_+]", r"[A,{\bf u}]", "[A,a]", "[a,x]", r"\{A,J_-\}", r"[\mathbb{1},\mathbb{1}]"],
    );
    refused(&w, "latex::derivative", &[r"\{a,x\}", r"\{A,a\}"]);
    // Where there are canonical variables, braces of matrices could be either.
    let mut canonical = w.with("q", Role::State, "").with("p", Role::State, "");
    let momentum = canonical.scope.symbol("p").unwrap_or_else(|| panic!("p"));
    canonical.scope.set_momentum(&canonical.graph, momentum, "q").unwrap_or_else(|e| panic!("{e:?}"));
    refused(&canonical, "latex::ambiguous", &[r"\{A,B\}"]);
    same(&canonical, &[("[A,B]", "AB-BA"), (r"\{q,p\}", "1")]);
}

#[test]
fn a_scalar_product_before_the_identity_matrix() {
    let w = world();
    same(
        &w,
        &[
            (r"A+{\bf u}\cdot{\bf v}\,\mathbb{1}", r"A+({\bf u}\cdot{\bf v})\mathbb{1}"),
            (r"A+a{\bf u}\cdot{\bf v}\,\mathbb{1}", r"A+(a{\bf u}\cdot{\bf v})\mathbb{1}"),
        ],
    );
    refused(
        &w,
        "latex::shape",
        &[r"A+{\bf u}\cdot{\bf v}\,A", r"A+{\bf u}\mathbb{1}", r"A+{\bf u}\cdot{\bf v}\,a\mathbb{1}"],
    );
}

#[test]
fn a_subscript_behind_a_product_of_matrices() {
    let w = world();
    let matrix = r"\begin{pmatrix}1&0&a\\0&1&0\\0&0&1\end{pmatrix}B_{12}";
    refused(&w, "latex::ambiguous", &["AB_{12}", r"A{\bf u}_1", "aAu_1", "ABA_{11}", "A^TB_{12}", matrix]);
    same(&w, &[("(AB)_{12}", "A_{1k}B_{k2}"), ("B_{12}A", r"A\cdot B_{12}"), ("aB_{12}", r"a\cdot B_{12}")]);
    // A matrix that cannot be multiplied with what follows.
    same(&w, &[("J_+u_1", "u_1J_+")]);
}

#[test]
fn both_readings_of_a_hint_can_be_pasted() {
    let w = world().with(r"\omega", Role::Parameter, "").with("t_0", Role::Parameter, "");
    for text in [
        r"\sin\omega(t-t_0)",
        r"\sin^2\theta(1+a)",
        r"\cos\theta\left(1+x\right)",
        r"\sin x a",
        r"\cos2\omega x",
        r"\ln x^2",
        r"\sin\theta^2",
    ] {
        let (code, hint) = refusal(&w, text);
        assert_eq!(code, "latex::ambiguous", "{text}");
        let readings: Vec<&str> = hint.split('`').skip(1).step_by(2).collect();
        let [one, other] = readings[..] else { panic!("{text}: {hint}") };
        let mut w = w.clone();
        assert_ne!(w.expression(one), w.expression(other), "{hint}");
    }
}

#[test]
fn double_bars_are_a_length() {
    same(&world(), &[(r"\lVert{\bf u}\rVert", r"|{\bf u}|"), (r"\left\lVert x{\bf u}\right\rVert", r"|x{\bf u}|")]);
    refused(&world(), "latex::unbalanced", &[r"\lVert{\bf u}\rvert", r"\lvert{\bf u}\rVert"]);
    refused(&world(), "latex::shape", &[r"\lVert A\rVert"]);
}
