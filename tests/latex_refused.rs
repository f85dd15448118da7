//! What is wrong or has two readings is refused: with a code, at the place, with a hint on how to write it.

use crate::latex_support::{World, shown};
use rederive::latex::Role;

/// Symbols of mechanics, with some names that are there to be confused.
fn world() -> World {
    use Role::{Abbreviation, Observable, Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with("b", Parameter, "")
        .with("c", Parameter, "")
        .with("k", Parameter, "")
        .with("T", Parameter, "")
        .with("t_0", Parameter, "")
        .with(r"\omega", Parameter, "")
        .with("x", State, "")
        .with("y", State, "")
        .with("z", State, "")
        .with(r"\theta", Observable, "")
        .with(r"\psi", Observable, "")
        .with(r"\psi_0", Parameter, "")
        .with("A", State, "3x3")
        .with("B", State, "3x3")
        .with("I", Parameter, "diagonal 3")
        .with("M", Parameter, "2x3")
        .with(r"{\bf u}", State, "3")
        .with(r"{\bf v}", State, "3")
        .with(r"{\bf w}", State, "3")
        .with(r"{\bf p}", Parameter, "2")
        .by("h", Abbreviation, r"a+b")
        .by("I_{(n-k)}", Abbreviation, r"\frac{1}{I_n}-\frac{1}{I_k}")
}

/// The text is refused with one of these codes; the place is the part of the text between `‹` and `›`, where marked.
fn refused_in(w: &World, marked: &str, code: &str) -> String {
    let text = marked.replace(['‹', '›'], "");
    let mut w = w.clone();
    let problems = match w.try_read(&text) {
        Err(problems) => problems,
        Ok(s) => {
            let r = &s[0].relations[0];
            let (left, right) = (w.graph.to_latex(r.left.components[0]), w.graph.to_latex(r.right.components[0]));
            panic!("`{text}` was read as `{left} … {right}`")
        }
    };
    let p = &problems[0];
    assert_eq!(p.code, code, "{}", shown(&text, &problems));
    if let (Some(start), Some(end)) = (marked.find('‹'), marked.find('›')) {
        let wanted = start..end - '‹'.len_utf8();
        assert_eq!(p.span, wanted, "{}", shown(&text, &problems));
    }
    p.hint.clone().unwrap_or_default()
}

fn refused(marked: &str, code: &str) -> String {
    refused_in(&world(), marked, code)
}

const AMBIGUOUS: &str = "latex::ambiguous";

#[test]
fn a_denominator_that_could_be_longer() {
    refused("x=a/‹2b›", AMBIGUOUS);
    for text in ["x=a/b c", "x=a/2b", "x=1/2\\pi", "x=a/b/c", r"x=a/b\cdot c", r"x=a/b(x+y)", r"x=a/b\frac{1}{2}"] {
        assert!(refused(text, AMBIGUOUS).contains(r"\frac"), "{text}");
    }
    for text in [r"{\bf u}=1/a{\bf v}", r"x=1/\sin\theta\cos\theta", r"x={a/b}c", r"{\bf u}={\bf v}/a\times{\bf w}"] {
        refused(text, AMBIGUOUS);
    }
}

#[test]
fn an_argument_that_could_be_longer() {
    for text in [
        r"x=\sin x y",
        r"x=\sin\theta A_{12}",
        r"x=\sin\theta\psi",
        r"x=\sin a(x+y)",
        r"x=\sin 2(x+y)",
        r"x=\cos\psi(a-b)",
        r"x=\sin\frac12(x+y)",
        r"x=\sin\theta[a+b]",
        r"x=\sin{x}y",
        r"x={\sin x}y",
        r"x=\sin{x y}",
        r"x=\sin a b",
        r"x=\sin x t",
        r"x=\sin\theta|a|",
        r"x=\sin\omega t\frac12",
        r"x=\operatorname{tr}A B_{11}",
        r"x=\sin a\cdot b",
    ] {
        assert!(refused(text, AMBIGUOUS).contains("parentheses"), "{text}");
    }
    for text in [
        r"x=\sin x/2",
        r"x=\sin^2\psi/a",
        r"x=\cos\theta^2",
        r"x=\sin\psi_0^2",
        r"x=\ln x^2",
        r"x=\sin(2x)^2",
        r"x=\sin(x+y)^2",
        r"x=\sin{x}^2",
        r"x=\sin 2x^2",
        r"x=\det A^2",
        r"x=\sin-x",
        r"x=\sin{-x}",
        r"x=\sin{a+b}",
    ] {
        refused(text, AMBIGUOUS);
    }
}

#[test]
fn powers_of_functions_that_could_be_inverses() {
    assert!(refused(r"x=\sin^‹{-1}›x", AMBIGUOUS).contains(r"\arcsin"));
    assert!(!refused(r"x=\ln^{-1}x", AMBIGUOUS).contains("arc"));
    refused(r"x=\cos^a x", AMBIGUOUS);
    refused(r"x=\log x", "latex::base-of-logarithm");
}

#[test]
fn numbers_side_by_side() {
    for text in [
        "x=‹2 3›",
        "x=‹a2›",
        "x=‹x2›",
        "x=1 200",
        "x=2\\frac12",
        r"x=\frac12 3",
        r"x=\frac123",
        r"x=\sqrt25",
        "x=a 2^3",
    ] {
        refused(text, AMBIGUOUS);
    }
    refused("x=2^‹10›", AMBIGUOUS);
    refused("x=I_‹12›", AMBIGUOUS);
    refused(r"x=\frac‹1.5› 2", AMBIGUOUS);
    refused("x=‹00›", "latex::unexpected");
    refused("x=‹03›", "latex::unexpected");
    refused("x=1,5", "latex::not-a-relation");
    refused("x=a.b", AMBIGUOUS);
}

#[test]
fn braces_that_are_not_printed() {
    for text in ["x={a+b}c", "x=2{a+b}", "x=a-{b-c}", "x=a{-b}", "x={ab}^2", "x={a+b}^2", "x={x^2}^3", "x={a/b}^2"] {
        refused(text, AMBIGUOUS);
    }
    refused(r"x={\bf u v}_1", AMBIGUOUS);
    refused(r"\bf u={\bf v}", AMBIGUOUS);
}

#[test]
fn undeclared_symbols() {
    let hint = refused(r"x=‹\Theta›", "latex::unknown-symbol");
    assert!(hint.contains(r"\theta"), "{hint}");
    let hint = refused(r"x=a+‹\psi_1›", "latex::index");
    assert!(hint.contains("declare"), "{hint}");
    refused(r"x=‹q›+a", "latex::unknown-symbol");
    refused(r"{\bf u}=‹u›", "latex::unknown-symbol");
    refused(r"x=f(x)", "latex::unknown-symbol");
    refused(r"x=\theta'", "latex::unknown-symbol");
    refused(r"x=‹\foo›", "latex::unknown-command");
    refused(r"x=x^i", "latex::unknown-symbol");
}

#[test]
fn shapes() {
    refused(r"‹{\bf u}=a›", "latex::shape");
    refused(r"‹A={\bf u}›", "latex::shape");
    refused(r"{\bf u}={\bf v}+‹a›", "latex::shape");
    assert!(refused(r"x=‹{\bf u}{\bf v}›", "latex::shape").contains(r"\cdot"));
    refused(r"{\bf u}={\bf v}A", "latex::shape");
    refused(r"{\bf u}=A{\bf p}", "latex::shape");
    refused(r"{\bf u}=a\times b", "latex::shape");
    refused(r"{\bf u}=[a,b]", "latex::shape");
    refused(r"A=[A,{\bf p}]", "latex::shape");
    refused(r"x=\sin{\bf u}", "latex::shape");
    refused(r"x=a/{\bf u}", "latex::shape");
    refused(r"{\bf u}<{\bf v}", "latex::shape");
    refused(r"x=|A|", "latex::shape");
    refused(r"x=\det M", "latex::shape");
    refused(r"A=M^{-1}", "latex::shape");
    refused(r"x={\bf u}^3", "latex::shape");
    refused(r"{\bf u}=\begin{pmatrix}a&b\\c\end{pmatrix}", "latex::shape");
    refused(r"x={\bf u}\cdot{\bf v}\cdot{\bf w}", AMBIGUOUS);
    refused(r"{\bf u}={\bf u}\times{\bf v}\times{\bf w}", AMBIGUOUS);
    // R^t is no transpose, and T is declared here.
    assert!(refused("B=A^T", "latex::shape").contains(r"\top"));
    refused("B=A^t", "latex::shape");
}

#[test]
fn the_identity_matrix() {
    let w =
        World::empty().with("A", Role::State, "3x3").with(r"{\bf u}", Role::State, "3").with("a", Role::Parameter, "");
    assert!(refused_in(&w, "1=A^TA", "latex::shape").contains(r"\mathbb{1}"));
    assert!(refused_in(&w, "A^TA=1", "latex::shape").contains(r"\mathbb{1}"));
    assert!(refused_in(&w, r"A_{ij}=\mathbb{1}_{ij}", "latex::shape").contains(r"\delta_{ij}"));
    for text in
        [r"\mathbb{1}=\mathbb{1}", r"a=\mathbb{1}", r"\mathbb{1}=0", r"{\bf u}=\mathbb{1}", r"a=\det(\mathbb{1})"]
    {
        refused_in(&w, text, "latex::shape");
    }
    refused_in(&w, r"A={\bf u}\mathbb{1}", "latex::shape");
    refused_in(&w, r"A=A+a", "latex::shape");
    refused_in(&w, r"A_{ij}=\mathbb{1}", "latex::index");
}

#[test]
fn delimiters() {
    refused("x=‹(›a+b", "latex::unbalanced");
    refused("x=a+b‹)›", "latex::unbalanced");
    refused("x=‹{›a+b", "latex::unbalanced");
    refused("x=‹(›a+b]", "latex::unbalanced");
    refused(r"x=‹|›a+b", "latex::unbalanced");
    refused(r"x=\left|a\right.", "latex::invisible-delimiter");
    refused(r"x=‹\left› a", "latex::unexpected");
    refused(r"x=‹\right›(a)", "latex::unexpected");
    refused(r"x=‹|›a|b|c|", AMBIGUOUS);
    refused("x=||a||", "latex::unexpected");
    refused(r"{\bf u}=\begin{pmatrix}a\\b\\c\end{array}", "latex::unbalanced");
}

#[test]
fn scripts() {
    refused("x=x_1‹_›2", "latex::double-script");
    refused("x=x^2‹^›3", "latex::double-script");
    assert!(refused("B_{ij}=‹A_{ij}^{-1}›", AMBIGUOUS).contains("first"));
    assert!(refused("x=‹A_{12}^{-1}›", AMBIGUOUS).contains("first"));
    refused("x=‹A^2_{12}›", AMBIGUOUS);
    refused("x=x^{(2)}", AMBIGUOUS);
    refused("x=A_{,12}", AMBIGUOUS);
    refused("x=A_{1.2}", "latex::unexpected");
    refused("x=A_{}", "latex::unexpected");
    refused("x=x^*", AMBIGUOUS);
    refused("x=x^", "latex::unexpected");
    refused("x=A_{1-2}", "latex::index");
}

#[test]
fn indices() {
    assert!(refused(r"A_{ij}=‹B_{ik}›", "latex::unsummed-index").contains("repeat"));
    refused(r"x=‹u_i›", "latex::unsummed-index");
    refused(r"u_i=‹x›", "latex::index");
    refused(r"u_i=v_i+‹x›", "latex::index");
    refused(r"u_i=v_i+‹w_j›", "latex::index");
    refused(r"x=‹u_4›", "latex::index");
    refused(r"x=‹u_0›", "latex::index");
    refused(r"x=A_{11}+‹A_1›", "latex::index");
    refused(r"x=‹u_{123}›", "latex::index");
    refused(r"x=‹a_1›", "latex::index");
    refused(r"x=u_i‹p_i›", "latex::index");
    refused(r"x=‹\epsilon_{145}›", "latex::index");
    refused(r"x=‹\delta_{ii}›", "latex::index");
    // What physicists read as labels.
    for text in
        ["x=u_x v_x+u_y v_y", r"x=u_\theta v_\theta", "x=u_E v_E", "x=u_t v_t", "x=u_r v_r", r"x=u_{\bf u}v_{\bf u}"]
    {
        refused(text, "latex::index");
    }
    refused("u_i=A_{ij}v_jB_{ij}w_j", AMBIGUOUS);
    refused("x=u_iv_iw_i‹u_i›", AMBIGUOUS);
    // An index of a sum inside that stands outside too.
    for text in [
        r"x=u_iv_i\sqrt{w_iw_i}",
        r"x=\frac{u_iv_i}{w_iw_i}",
        r"x=u_i(v_iw_i)u_i",
        r"u_i=v_i\sqrt{w_iw_i}",
        r"u_i=v_i(u_iw_i+a)",
        r"u_i=\frac{v_i}{w_iw_i}",
        r"x=u_iv_i\sin(u_iw_i)",
        r"x=u_iv_ie^{w_iw_i}",
        r"u_i=v_i(u_iw_i)",
    ] {
        let mut w = world();
        let code = w.try_read(text).expect_err(text)[0].code;
        assert!(code == AMBIGUOUS || code == "latex::index", "{text}: {code}");
    }
    refused(r"x=u_iu_ju_ku_lu_mu_nu_pu_qu_aA_{ij}A_{kl}A_{mn}A_{pq}A_{ab}A_{bc}A_{cd}A_{dd}", "latex::too-large");
    refused(r"u_iu_ju_ku_lu_mu_nu_pu_q=0", "latex::too-large");
}

#[test]
fn times() {
    refused("x=a(0)", AMBIGUOUS);
    refused("x=a(t)", AMBIGUOUS);
    refused("x=I_1(t_0)", AMBIGUOUS);
    refused("x=a(b)", AMBIGUOUS);
    refused(r"x=\theta(t+T)", AMBIGUOUS);
    refused(r"x=\theta(t_0+a)", AMBIGUOUS);
    refused(r"x=\psi(\theta)", AMBIGUOUS);
    refused(r"x=\theta(-a)", AMBIGUOUS);
    refused(r"x=\theta(0,1)", AMBIGUOUS);
    refused(r"x=x(2y)", AMBIGUOUS);
    refused(r"{\bf u}={\bf v}({\bf u})", AMBIGUOUS);
    refused("x=h(0)", AMBIGUOUS);
    refused(r"\frac{d^2a}{dt^2}=0", "latex::dot");
    refused(r"\dot a=0", "latex::dot");
    refused(r"\dot t=1", "latex::dot");
    refused(r"\dot{x y}=0", "latex::dot");
    refused(r"\dot{(x)}=0", "latex::dot");
    refused(r"\frac{da}{dt}=0", "latex::dot");
    refused(r"\lim_{x\to 0}\theta=0", "latex::limit");
    refused(r"0=\lim_{t\to t_0}\theta(t)", "latex::limit");
    refused(r"a\lim_{t\to t_0}\theta=0", "latex::limit");
    refused(r"\lim_{t\to x}\theta=0", "latex::limit");
    refused(r"x=\theta^{-1}(0)", AMBIGUOUS);
    assert!(refused(r"\theta(t)‹\rightarrow› 0", "latex::limit").contains(r"\lim"));
    refused(r"x=\infty", "latex::unsupported");
}

#[test]
fn derivatives() {
    refused(r"\frac{dx}{2}=0", "latex::derivative");
    refused(r"\frac{d^2x}{dt}=0", "latex::derivative");
    refused(r"\frac{dx}{da}=0", "latex::derivative");
    refused(r"\frac{d^2x}{d\theta^2}=0", "latex::derivative");
    for text in [
        r"\frac{dx^2}{dt}=0",
        r"\frac{d x y}{dt}=0",
        r"\frac{d}{dt}x y=0",
        r"\frac{d}{dt}x/y=0",
        r"\frac{d}{dt}x\cdot y=0",
    ] {
        refused(text, AMBIGUOUS);
    }
    let w = world().with("d", Role::Parameter, "");
    refused_in(&w, r"\frac{dx}{dt}=0", AMBIGUOUS);
    refused_in(&w, r"\frac{d}{dt}x=0", AMBIGUOUS);
    refused(r"\partial_tx=0", "latex::derivative");
    refused(r"\int x=0", "latex::unsupported");
}

#[test]
fn words_and_signs() {
    let w = world().with("s", Role::Parameter, "").with("i", Role::Parameter, "").with("n", Role::Parameter, "");
    assert!(refused_in(&w, "x=‹sin› a", AMBIGUOUS).contains(r"\sin"));
    refused_in(&w, "x=sinx", AMBIGUOUS);
    refused("x=‹*›a", "latex::unexpected");
    refused("x=a‹*›b", "latex::unexpected");
    refused("x=a‹é›b", "latex::unknown-character");
    refused("x=a‹$›", "latex::unknown-character");
    refused("x=", "latex::unexpected");
    refused("=x", "latex::unexpected");
    refused("x==a", "latex::unexpected");
    refused("x+a", "latex::not-a-relation");
    refused("", "latex::empty");
    refused("  , ", "latex::empty");
    refused(r"x=\sqrt x y z)", "latex::unbalanced");
    refused("x=a\\", "latex::stray-backslash");
    refused(r"x=\operatorname{foo}(a)", "latex::unknown-symbol");
    refused(r"x=\operatorname{atan2}(a)", "latex::arity");
    refused(r"x=\begin{cases}a\end{cases}", "latex::unsupported");
}

#[test]
fn declarations_that_would_have_two_meanings() {
    use rederive::expr::Shape;
    use rederive::latex::Declaration;
    let mut w = world();
    let vector = Declaration { shape: Some(Shape::vector(3)), ..Declaration::of(Role::State) };
    let number = Declaration { shape: None, role: Role::Parameter, ..vector.clone() };
    for key in ["u_1", r"{\bf u}_2", "u_i", "A_{12}", r"\vec u_3"] {
        assert!(w.scope.declare(&mut w.graph, key, number.clone()).is_err(), "{key}");
    }
    w.scope.declare(&mut w.graph, "q_1", number.clone()).expect("a label");
    assert!(w.scope.declare(&mut w.graph, "q", vector.clone()).is_err());
    assert!(w.scope.declare(&mut w.graph, "q_N", number.clone()).is_ok());
    for key in ["ab", "", "a+b", "2", "q_", r"\sin", "x(", r"\frac12", "t t"] {
        assert!(w.scope.declare(&mut w.graph, key, number.clone()).is_err(), "{key}");
    }
    // Some letters of the subscript are indices of the formula, some are not; or one is left over.
    for formula in ["u_n", "u_nv_j"] {
        let by = Declaration { formula: Some(formula), role: Role::Abbreviation, ..number.clone() };
        assert!(w.scope.declare(&mut w.graph, "S_{nk}", by).is_err(), "{formula}");
    }
}

#[test]
fn deep_and_long_texts_end_in_a_small_stack() {
    let run = || {
        let n = 100_000;
        let nested = |open: &str, inner: &str, close: &str| format!("x={}{inner}{}", open.repeat(n), close.repeat(n));
        for text in [
            nested("{", "a", "}"),
            nested("(", "a", ")"),
            nested("{", "", ""),
            nested(r"\sqrt{", "a", "}"),
            nested("a^{", "a", "}"),
            nested("a_{", "1", "}"),
            nested(r"\frac{1}{", "a", "}"),
            nested("[a,", "b", "]"),
            nested(r"\hat ", "a", ""),
            nested(r"\hat{", "a", "}"),
            nested(r"\operatorname{tr}", "A", ""),
            nested(r"\frac{d}{dt}", "x", ""),
            nested(r"\sin ", "x", ""),
            nested(r"\sin(", "x", ")"),
            nested(r"\left|", "x", r"\right|"),
            nested(r"\dot{", "x", "}"),
            nested("-", "x", ""),
            nested("x(", "0", ")"),
            nested(r"{\bf ", "u", "}"),
            nested(r"\begin{pmatrix}", "a", r"\end{pmatrix}"),
        ] {
            let problems = world().try_read(&text).expect_err("too deep");
            assert!(problems.iter().all(|p| p.span.end <= text.len()));
        }
        // Long, but flat.
        let sum = format!("x={}a", "a+".repeat(20_000));
        assert!(world().try_read(&sum).is_ok());
        let product = format!("x={}a", "a ".repeat(20_000));
        assert!(world().try_read(&product).is_ok());
    };
    std::thread::Builder::new().stack_size(512 * 1024).spawn(run).expect("a thread").join().expect("no overflow");
}

#[test]
fn what_is_said_in_other_ways_has_a_hint() {
    let hints = [
        (r"x=a‹\Rightarrow› y=b", "latex::unsupported", "follows-from"),
        (r"x=a‹\implies› y=b", "latex::unsupported", "assuming"),
        (r"k=0,1,2,‹\ldots›", "latex::unsupported", "ranges"),
        (r"x^2+y^2=‹\text{const›.}", "latex::unsupported", "first-integral"),
        (r"x^2+y^2=‹\mathrm{constant›}", "latex::unsupported", "first-integral"),
        (r"x^2+y^2=‹{\rm const›}", "latex::unsupported", "first-integral"),
        (r"x^2+y^2=‹const›", "latex::unsupported", "first-integral"),
        (r"‹Z›(\beta)=1", "latex::unknown-symbol", r"'Z(\beta)'"),
        (r"‹f›(q)=1", "latex::unknown-symbol", "arguments = ['q']"),
        (r"‹f_1›(q)=1", "latex::unknown-symbol", "abbreviation"),
        (r"x=\log_‹10›a", "latex::ambiguous", "_{10}"),
        (r"x=\ln‹_›2a", "latex::unexpected", ""),
        (r"x=a-‹-›b", "latex::unexpected", "parentheses"),
        (r"x=a\pm‹-›b", "latex::unexpected", "parentheses"),
        (r"x=\lfloor a‹)›", "latex::unbalanced", ""),
        (r"x=a‹\rfloor›", "latex::unexpected", ""),
    ];
    for (marked, code, hint) in hints {
        let found = refused(marked, code);
        assert!(found.contains(hint), "{marked}: {found}");
    }
}

#[test]
fn a_difference_is_a_name_only_where_that_is_clear() {
    use Role::{Parameter, State, Time};
    let w = World::empty()
        .with("t", Time, "")
        .with("x", State, "")
        .with(r"\Delta x", Parameter, "")
        .with("a", Parameter, "");
    refused_in(&w, r"a=‹\Delta x›^2", "latex::ambiguous");
    refused_in(&w, r"a=\Delta a", "latex::unknown-symbol");
    let both = w.clone().with(r"\Delta", Parameter, "");
    refused_in(&both, r"a=‹\Delta x›", "latex::ambiguous");
    // A product of two symbols stays one.
    let mut product = World::empty().with("t", Time, "").with(r"\Delta", Parameter, "").with("x", State, "");
    assert!(product.try_read(r"\Delta x=1").is_ok());
    for text in [r"\Delta x=a", r"(\Delta x)^2=a", r"\frac{a}{\Delta x}=1", r"a\Delta x=1", r"\sin\Delta x=a"] {
        let read = w.clone().try_read(text);
        assert!(read.is_ok(), "{text}");
    }
}
