//! What belongs together in print: each text is read as its partner, and what could belong elsewhere is refused.

use crate::latex_support::World;
use rederive::latex::Role;

fn world() -> World {
    use Role::{Coordinate, Field, Observable, Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with("b", Parameter, "")
        .with("k", Parameter, "")
        .with("k'", Parameter, "")
        .with("E_{ai}", Parameter, "")
        .with("E_a", Parameter, "")
        .with(r"\hbar", Parameter, "")
        .with("x", State, "")
        .with("y", State, "")
        .with(r"\theta", Observable, "")
        .with("A", State, "3x3")
        .with("B", Parameter, "2x2")
        .with(r"{\bf u}", State, "3")
        .with(r"{\bf v}", State, "3")
        .with(r"{\bf w}", State, "3")
        .with(r"{\bf p}", Parameter, "2")
        .with("z", State, "complex")
        .with(r"\boldsymbol{\Theta}", State, "3")
        .with("s", Coordinate, "")
        .with("U(s)", Field, "")
        .with("V(s)", Field, "")
}

/// Both texts have the same components.
#[track_caller]
fn same(pairs: &[(&str, &str)]) {
    let mut w = world();
    for (text, plain) in pairs {
        let (one, other) = (w.expression(text), w.expression(plain));
        assert_eq!(one.components, other.components, "{text}: {}", w.graph.to_latex(one.components[0]));
        assert_eq!(one.shape, other.shape, "{text}");
    }
}

#[track_caller]
fn refused(texts: &[&str]) {
    let mut w = world();
    for text in texts {
        if let Ok(found) = w.try_expression(text) {
            panic!("{text} is read as {}", w.graph.to_latex(found.components[0]));
        }
    }
}

#[test]
fn a_vector_beside_a_scalar_product_is_multiplied_by_it() {
    same(&[
        (r"\frac{{\bf u}}{a}{\bf v}\cdot{\bf w}", r"\frac{{\bf u}}{a}({\bf v}\cdot{\bf w})"),
        (r"{\bf u}{\bf v}\cdot{\bf w}", r"{\bf u}({\bf v}\cdot{\bf w})"),
        (r"b\,{\bf u}\,{\bf v}\cdot(a{\bf w})", r"b{\bf u}({\bf v}\cdot(a{\bf w}))"),
        (r"A{\bf u}{\bf v}\cdot{\bf w}", r"(A{\bf u})({\bf v}\cdot{\bf w})"),
        // A matrix before a vector is another product.
        (r"A{\bf v}\cdot{\bf w}", r"(A{\bf v})\cdot{\bf w}"),
    ]);
    refused(&[
        r"{\bf u}{\bf v}",
        r"{\bf u}{\bf v}{\bf w}\cdot{\bf w}",
        r"{\bf u}{\bf v}\cdot a",
        r"{\bf u}{\bf v}\cdot{\bf p}",
        r"{\bf u}{\bf v}\times{\bf w}",
        r"{\bf u}A{\bf v}\cdot{\bf w}",
        r"{\bf u}{\bf v}\cdot{\bf w}\cdot{\bf w}",
    ]);
}

#[test]
fn a_number_times_a_matrix_needs_no_dot() {
    same(&[(r"\frac{a}{b}\times B", r"\frac{a}{b}B"), (r"B\times a", "Ba"), (r"a\times b", "ab")]);
    refused(&[r"A\times A", r"{\bf u}\times A", r"B\times{\bf p}", r"a\times{\bf u}", "[a,B]"]);
}

#[test]
fn a_function_of_a_function_ends_where_nothing_follows() {
    same(&[
        (r"\ln\sin\theta", r"\ln(\sin(\theta))"),
        (r"\cos\operatorname{atan}x+a", r"\cos(\arctan(x))+a"),
        (r"\frac{1}{\ln\ln a}", r"\frac{1}{\ln(\ln(a))}"),
    ]);
    refused(&[
        r"\ln\sin\theta\,a",
        r"\ln\sin\theta\cos\theta",
        r"\ln\sin\theta(a+b)",
        r"\ln\sin\theta/a",
        r"\ln\sin\theta\cdot a",
        r"\ln\sin a b",
        r"\ln-\sin\theta",
    ]);
}

#[test]
fn brackets_go_on_behind_a_break() {
    same(&[
        (r"\left(a+\right.\left.b\right)x", "(a+b)x"),
        (r"\left[a+\left(b\right.\right. \left.\left.+k\right)x\right]", "a+(b+k)x"),
        (r"\left|x+\right.\left. a\right|", "|x+a|"),
        (r"\left.x\right|_{t=0}", "x(0)"),
    ]);
    refused(&[
        r"\left(a+\right.b",
        r"a\right.b",
        r"(a+\right.b)",
        r"\left(a+\right.b)+\left.",
        r"\left(a+\right.\left.b\right]",
        r"\left(a+\right.\left.x\right|_{t=0}",
        r"\left. a\right.",
    ]);
}

#[test]
fn a_subscript_below_a_name_that_has_one_is_refused() {
    same(&[(r"\frac{dy}{{dx}^1}", r"\frac{dy}{dx}"), ("{E_a}^2", "E_a^2")]);
    refused(&[
        "{E_a}_i",
        "2{E_{a}}_{i}^2",
        r"\frac{{E_{a}}_{i}}{a}",
        "{E_a}_k",
        "{E_a}_i_i",
        "(E_a)_i",
        "{x_a}_i",
        "{{E_a}}_i",
        "{x_a}_{bc}",
        r"\dot{x_a}_i",
        r"\vec{x_a}_i",
        r"\mathbf{x_a}_i",
        r"{\bf x_a}_i",
    ]);
    same(&[(r"\frac{d^2U}{{ds}^2}", r"\frac{d^2U}{ds^2}"), (r"\frac{d^2U}{{\mathrm ds}^2}", r"\frac{d^2U}{ds^2}")]);
    refused(&[r"\frac{d^2U}{{ds}}", r"\frac{dU}{{ds}^2}", r"\frac{d^2U}{{ds^2}^2}", r"\frac{d^2U}{a{ds}^2}"]);
}

#[test]
fn scripts_behind_each_other_are_refused() {
    refused(&[
        "E_a{}^k",
        "E^k{}_a",
        "E^{k}{ }_{a}",
        "E{}_a",
        "x{}_aE",
        r"x\,{}_a",
        "x_a{}_b",
        "{}_ax",
        "2{}_ax",
        r"E_a\,^k",
        r"E^k\;_a",
        r"E^k\!_a",
        r"E^k\null_a",
        r"E_{a}^{\ k}",
        r"E^{k}_{\ a}",
        r"E^{\;k}_{a}",
        r"E_{a}^{~k}",
        "E^2{}_a",
        "E_a{}^1",
        "x {}^{14}a",
    ]);
    same(&[
        ("E_a{}^2", "E_a^2"),
        ("E_{a}{}^{-1}", "E_a^{-1}"),
        ("(a+k){}^2", "(a+k)^2"),
        (r"\left(a+k\right){}^{2}", "(a+k)^2"),
        (r"E_a^{\,2}", "E_a^2"),
        (r"E_{\,a}^2", "E_a^2"),
        (r"E_a\,^2", "E_a^2"),
        (r"E_{\,a}", "E_a"),
    ]);
}
