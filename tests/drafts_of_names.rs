//! What `init` takes for a name, an index, a variable, and what stays refused with both readings.

use super::drafts::{draft, is_drafted, refused};

#[test]
fn labels_above_are_a_part_of_what_is_called() {
    // Three spellings of one print.
    for label in [r"\mathrm{R}", r"{\mathrm{R}}", r"{\rm R}", r"\mathrm R"] {
        let formula = format!(r"u_E^{label}(x)=A x");
        let text = draft(&format!(r"\[ {formula} \] \[ u_E^{label}(0)=0 \]"));
        is_drafted(&text, &[&formula]);
        assert!(
            text.contains(r"_E^{\mathrm R}(x)' = { role = ") || text.contains(r"_E^{\rm R}(x)' = { role = "),
            "{text}"
        );
    }
    let text = draft(r"\[ F=aT^{*}+bT^{**}+cT^{***} \] \[ G={a\times\Bigl(} {T^{*}+1\Bigr)} \]");
    is_drafted(&text, &["F=aT^{*}+bT^{**}+cT^{***}", r"G=a\times\Bigl( T^{*}+1\Bigr)"]);
    assert!(text.contains("'T^{**}' = ") && text.contains("'T^{***}' = "), "{text}");
    // A power, a transpose, Euler's number.
    let text = draft(r"\[ u^{2}(x)=A x \] \[ B^{\mathrm T}(x)=A x \] \[ w=e^\mathrm{ix} \]");
    for formula in ["u^{2}(x)=A x", r"B^{\mathrm T}(x)=A x"] {
        assert!(refused(&text, formula).is_some(), "{formula}: {text}");
    }
    assert!(!text.contains("'e^{"), "{text}");
}

#[test]
fn a_capital_in_square_brackets_is_a_name() {
    let text = draft(
        r"\[ [C]_k = \frac{n_k}{V} \] \[ [X]_i = [C] \] \[ X = 2 n_1 \] \[ \frac{\partial [C]_k}{\partial V} = -\frac{1}{V}[C]_k \]",
    );
    is_drafted(&text, &[r"[C]_k=\frac{n_k}{V}", r"[X]_i=[C]", "X=2 n_1"]);
    is_drafted(&text, &[r"\frac{\partial[C]_k}{\partial V}=-\frac{1}{V}[C]_k"]);
    assert!(text.contains("'[C]_k' = ") && text.contains("'[C]_k(V)' = "), "{text}");
    // A root, a sum, a call.
    let text = draft(r"\[ x=\sqrt[N]{y} \] \[ x=2[A+B] \] \[ E[X]=m \]");
    assert!(!text.contains("'[N]") && !text.contains("'[A"), "{text}");
    assert!(refused(&text, "E[X]=m").is_some(), "{text}");
}

#[test]
fn a_letter_that_stands_free_is_not_summed_over() {
    let labels = r"\[ k_{f,i} = 2 \] \[ k_{r,i} = 3 \]";
    let text = draft(&format!(
        r"{labels} \[ k_{{f,i}} = A_i T^{{\beta_i}} \] \[ \frac{{\partial F_i}}{{\partial V}} = F_i P_{{r,i}} P_{{r,j}} \]
        \[ A_0 = B_0 = F_0 = x_0 = y_0 = z_0 \] \[ s = x_i y_i \] \[ s = x_i(y_i+z_i) \] \[ s = A_i\begin{{bmatrix}} x_i \\ y_i \end{{bmatrix}} \]
        \[ B_i = x_i y_i \]"
    ));
    is_drafted(&text, &["B_i=x_i y_i"]);
    is_drafted(&text, &[r"k_{f,i}=A_i T^{\beta_i}", r"\frac{\partial F_i}{\partial V}=F_i P_{r,i} P_{r,j}"]);
    for formula in ["s=x_i y_i", "s=x_i(y_i+z_i)", r"s=A_i\begin{bmatrix} x_i \\ y_i \end{bmatrix}"] {
        assert!(refused(&text, formula).is_some_and(|why| why.contains("summed")), "{formula}: {text}");
    }
    // Without a sibling that is a label, r may be an index.
    let text = draft(r"\[ F_0 = 2 \] \[ s = F_i P_{r,i} P_{r,j} \]");
    assert!(refused(&text, r"s=F_i P_{r,i} P_{r,j}").is_some(), "{text}");
    // What stands in other entries of a matrix, or in other terms of a group, is no factor.
    let text = draft(
        r"\[ \begin{bmatrix} P_s \\ Q_s \end{bmatrix} = 2\begin{bmatrix} p \\ q \end{bmatrix} \] \[ w = (y_p+2y_p) - (3y_p) \]",
    );
    is_drafted(&text, &[r"\begin{bmatrix} P_s \\ Q_s \end{bmatrix}=2\begin{bmatrix} p \\ q \end{bmatrix}"]);
    is_drafted(&text, &["w=(y_p+2y_p) - (3y_p)"]);
}

#[test]
fn the_entries_of_a_matrix_that_is_derived_change() {
    let text = draft(
        r"\[ \frac{d}{dt}\begin{bmatrix} P_s \\ Q_s \end{bmatrix} = \omega\begin{bmatrix} -Q_s \\ P_s \end{bmatrix} \]",
    );
    is_drafted(
        &text,
        &[r"\frac{d}{dt}\begin{bmatrix} P_s \\ Q_s \end{bmatrix}=\omega\begin{bmatrix} -Q_s \\ P_s \end{bmatrix}"],
    );
    assert!(text.contains("'P_s' = { role = \"state\"") && text.contains("'Q_s' = { role = \"state\""), "{text}");
    assert!(text.contains("'\\omega' = { role = \"parameter\""), "{text}");
    let text = draft(r"\[ \frac{d}{dx} u_0(x) = -x u_0(x) \]");
    is_drafted(&text, &[r"\frac{d}{dx} u_0(x)=-x u_0(x)"]);
    assert!(text.contains("'u_0(x)' = { role = \"field\""), "{text}");
    // What an operator acts on is a name with its label.
    let text = draft(r"\[ \frac{d}{dt} x_1 = a x_1 \] \[ x = 2a \]");
    assert!(text.contains("'x_1' = { role = \"state\"") && !text.contains("'x' = { role = \"state\""), "{text}");
}

#[test]
fn the_rate_of_a_variable_is_no_field_of_another() {
    let paper = |more: &str| {
        format!(
            r"\[ \frac{{\partial p}}{{\partial V}} = a \] \[ \frac{{\partial p}}{{\partial T}} = b \] \[ \frac{{dV}}{{dt}} = c \] {more}
            \[ \frac{{\partial\dot V}}{{\partial T}} = J \] \[ J = \frac{{\partial}}{{\partial T}} \frac{{dV}}{{dt}} \]"
        )
    };
    let text = draft(&paper(""));
    is_drafted(&text, &[r"\frac{\partial p}{\partial V}=a", r"\frac{dV}{dt}=c"]);
    for formula in [r"\frac{\partial\dot V}{\partial T}=J", r"J=\frac{\partial}{\partial T} \frac{dV}{dt}"] {
        assert!(refused(&text, formula).is_some_and(|why| why.contains("rate of a variable, V")), "{formula}: {text}");
    }
    // Where V itself is derived, it is a function.
    let text = draft(&paper(r"\[ \frac{\partial V}{\partial T} = g \]"));
    let why = refused(&text, r"\frac{\partial\dot V}{\partial T}=J");
    assert!(why.is_none_or(|why| !why.contains("rate of a variable")), "{text}");
}

#[test]
fn a_logarithm_of_ten_is_natural() {
    let formula = r"\frac{da}{dx}=\frac{1}{x\log(10)}";
    let other = r"y=\log z";
    let text = draft(&format!(r"\[ s=\ln r \] \[ {formula} \] \[ {other} \]"));
    is_drafted(&text, &[formula, other]);
    assert!(text.contains("log = \"natural\" # confirm"), "{text}");
    for with in [r"\[ w=\log_{10}(10) \]", r"\[ w=\log 10^x \]"] {
        let text = draft(&format!(r"\[ s=\ln r \] \[ {other} \] {with}"));
        assert!(refused(&text, other).is_some_and(|why| why.contains("base")), "{with}: {text}");
    }
}

#[test]
fn primes_are_a_part_of_names_where_the_paper_shows_it() {
    // A second medium: beside `n\alpha` stands `n'\alpha'`.
    let snell = r"\[ n\sin\alpha = n'\sin\alpha' \] \[ L(x)=x^2 \] \[ \frac{dL}{dx} = 2x \]";
    let formula = r"\frac{n'}{n}=\frac{\sin\theta}{\sin\phi}";
    let shown = r"\[ \frac{n'}{n} = \frac{\sin\theta}{\sin\phi} \]";
    let text = draft(&format!(r"{snell} With $n(s)=c$, {shown}"));
    is_drafted(&text, &[formula]);
    for with in [r"\[ n' = 2 n \]", r"\[ n'(x) = 2 \]", r"\[ \frac{dn}{dx} = 2 \]", r"\[ y'' = y \]"] {
        let text = draft(&format!(r"{snell} With $n(s)=c$, {shown} {with}"));
        assert!(refused(&text, formula).is_some() || text.contains("'n("), "{with}: {text}");
    }
    let text = draft(&format!(r"\[ L(x)=x^2 \] \[ \frac{{dL}}{{dx}} = 2x \] With $n(s)=c$, {shown} \[ n = 2 \]"));
    assert!(refused(&text, formula).is_some(), "nothing shows it: {text}");
    // Forward and backward: S' and S'', and never S.
    let kinetics = r"\[ \frac{\partial R}{\partial P} = S'k - S''l \]";
    let text = draft(&format!(r"{kinetics} \[ w=S' \]"));
    is_drafted(&text, &[r"\frac{\partial R}{\partial P}=S'k - S''l"]);
    assert!(text.contains("\"S''\" = ") && text.contains("\"S'\" = "), "{text}");
    let text = draft(&format!(r"{kinetics} \[ S = 2 \]"));
    assert!(refused(&text, r"\frac{\partial R}{\partial P}=S'k - S''l").is_some(), "{text}");
    let text = draft(&format!(r"{kinetics} \[ S'(x) = 2 \]"));
    assert!(text.contains("'S(x)' = ") && !text.contains("\"S'\" = "), "{text}");
}

#[test]
fn the_only_variable_of_a_formula_is_that_of_its_primes() {
    let first = r"\section{A} \[ y'' + p(x)y' + q(x)y = 0 \]";
    let formula = r"u_1' \cos x + u_2' \sin x=0";
    let text = draft(&format!(r"{first} \section{{B}} \[ u_1' \cos x + u_2' \sin x = 0 \]"));
    is_drafted(&text, &[formula]);
    assert!(text.contains("'u_1(x)' = { role = \"field\" } # confirm"), "{text}");
    // x is a function itself there, or another variable stands beside it.
    for with in [r"\[ x' = 2 \]", r"\[ \dot x = 2 \]"] {
        let text = draft(&format!(r"{first} \section{{B}} {with} \[ u_1' \cos x + u_2' \sin x = 0 \]"));
        assert!(refused(&text, formula).is_some_and(|why| why.contains("a prime")), "{with}: {text}");
    }
    let text = draft(&format!(r"{first} \[ h(s) = s \] \section{{B}} \[ u_1' \cos x + u_2' \sin s = 0 \]"));
    assert!(refused(&text, r"u_1' \cos x + u_2' \sin s=0").is_some(), "{text}");
    // Behind brackets a prime derives by the same variable, and never by the time of another section.
    let moving = r"\section{T} \[ m\ddot x = -kx \] \[ \ddot x = -\omega^2 x \] \[ \dot x = v \] \[ x(t) = c t \]";
    let primed = r"y_p'' + y_p'=(Ax+B)'' + (Ax+B)'=A";
    let text = draft(&format!(r"{moving} {first} \section{{B}} \[ {primed} \] \[ y_p'' + y_p' = x \]"));
    assert!(refused(&text, primed).is_some() || text.contains("'x' = { role = \"coordinate\""), "{text}");
}

#[test]
fn an_operator_is_a_number_in_a_section_that_prints_it_below() {
    let paper = |more: &str| {
        format!(
            r"\section{{A}} The operator $L$ acts. \[ L y = g \] \section{{B}} \[ \ddot q + \frac{{g}}{{L}}\sin q = 0 \] \[ LI + R = V \] {more}"
        )
    };
    let text = draft(&paper(r"\section{C} \[ L w = g \]"));
    is_drafted(&text, &[r"\ddot q + \frac{g}{L}\sin q=0", "LI + R=V"]);
    for formula in ["L y=g", "L w=g"] {
        assert!(refused(&text, formula).is_some_and(|why| why.contains("operator")), "{formula}: {text}");
    }
    let text = draft(&paper(r"Here the operator $L$ acts, too. \[ L w = g \]"));
    assert!(refused(&text, "LI + R=V").is_some_and(|why| why.contains("operator")), "{text}");
    let text = draft(&paper(r"\[ p = \hbar k \]"));
    assert!(refused(&text, "LI + R=V").is_some_and(|why| why.contains("operator")), "{text}");
}

#[test]
fn capitals_that_stand_nowhere_alone_may_be_one_name() {
    let text = draft(
        r"\[ OPL = n r \] \[ \frac{d(OPL)}{dx} = 0 \] \[ V = LWH \] \[ NRT = PV \] \[ NRT = E \] \[ N + R = T \]",
    );
    for formula in ["OPL=n r", r"\frac{d(OPL)}{dx}=0"] {
        assert!(refused(&text, formula).is_some_and(|why| why.contains("several letters, OPL")), "{formula}: {text}");
    }
    // Printed once, or of letters that stand by themselves, too.
    is_drafted(&text, &["V=LWH", "NRT=PV", "NRT=E", "N + R=T"]);
}

#[test]
fn beside_dots_primes_of_all_three_axes_are_other_axes() {
    let turned = r"\begin{bmatrix} x'' \\ y'' \end{bmatrix}=\begin{bmatrix} a & b \\ -b & a \end{bmatrix} \begin{bmatrix} x' \\ y' \end{bmatrix}";
    let shown = format!(r"\[ {turned} \]");
    let text = draft(&format!(r"{shown} \[ z''=z' \] \[ \omega=\dot\phi \]"));
    assert_eq!(refused(&text, turned), None, "{text}");
    assert!(text.contains("\"x''\" = ") && text.contains("\"y'\" = ") && !text.contains("'x(t)'"), "{text}");
    // Two axes alone, or a place behind a prime: either.
    for with in [r"\[ \omega=\dot\phi \]", r"\[ z''=z' \] \[ \omega=\dot\phi \] \[ f'(s)=1 \]"] {
        let text = draft(&format!("{shown} {with}"));
        assert!(refused(&text, turned).is_some_and(|why| why.contains("a prime")), "{with}: {text}");
    }
    // Without dots it is the usual spelling of a rate.
    let text = draft(r"\[ x''+x=0 \] \[ y'=x' \]");
    assert!(text.contains("'x(t)'"), "{text}");
}

#[test]
fn a_letter_below_a_sum_is_an_index_of_other_formulas() {
    let formula = r"R=p_i \dot{q}_i - L";
    let labels = r"\[ p_\theta = m_\theta v \] \[ p_r=m_r v \] \[ q_f=a \]";
    let text = draft(&format!(r"{labels} \[ {formula} \]"));
    is_drafted(&text, &[formula]);
    for sum in [r"\sum_{i=1}^n", r"\sum_i", r"\sum\limits_{i<k}", r"\prod_{k,i}"] {
        let text = draft(&format!(r"{labels} \[ {formula} \] \[ M={sum} m_i \]"));
        assert!(refused(&text, formula).is_some_and(|why| why.contains("summed over, i")), "{sum}: {text}");
    }
}

#[test]
fn a_letter_beside_an_index_is_no_label() {
    // What stands below `p` may be a label; below σ it is an index, and the letter is the same.
    let labels = r"\[ p_\theta = m v \] \[ E_t = 2 E_f \] \[ E_r = E_f \] \[ x_f = 2 \]";
    let formula = r"\sigma_i x_i=- \sigma_i p_i";
    let text = draft(&format!(r"{labels} \[ p_f = 2 \] \[ {formula} \]"));
    assert!(refused(&text, formula).is_some_and(|why| why.contains("summed over, i")), "{text}");
    // It stands alone on the other side: free, or a label.
    let text = draft(&format!(r"{labels} \[ p_f = 2 \] \[ E_i = \sigma_i p_i \]"));
    assert!(refused(&text, r"E_i=\sigma_i p_i").is_none_or(|why| !why.contains("summed")), "{text}");
}

#[test]
fn a_vector_with_a_prime_beside_a_product_with_it_is_a_rate_or_another() {
    let formula = r"\mathbf{z}'=A\mathbf{z}";
    for with in ["", r"\[ \dot\theta=2 \]", r"\[ \dot{\mathbf{z}}=2\mathbf{z} \]"] {
        let text = draft(&format!(r"{with} \[ {formula} \] \[ \mathbf{{u}}' = 2\mathbf{{w}}+\mathbf{{b}} \]"));
        assert!(refused(&text, formula).is_some_and(|why| why.contains("a prime")), "{with}: {text}");
        is_drafted(&text, &[r"\mathbf{u}'=2\mathbf{w}+\mathbf{b}"]);
    }
    // What is added is no product.
    is_drafted(&draft(r"\[ \mathbf{r}'=\mathbf{a}+\mathbf{r} \]"), &[r"\mathbf{r}'=\mathbf{a}+\mathbf{r}"]);
}

#[test]
fn a_sum_of_an_exponential_and_the_identity_is_of_matrices() {
    let formula = r"\mathbf{x}=(e^{Bt}-I)\mathbf{a}";
    let text = draft(&format!(r"\[ {formula} \] \[ I_1=e^{{Bt}}-I_0 \] \[ u=e^{{bt}}-I \]"));
    assert!(refused(&text, formula).is_some_and(|why| why.contains("identity")), "{text}");
    is_drafted(&text, &["I_1=e^{Bt}-I_0", "u=e^{bt}-I"]);
}

#[test]
fn a_case_with_two_conditions_holds_under_each() {
    let text = draft(
        r"\[ u = \begin{cases} a+b & \text{if } 0\le x\le L, \\ 0 & \text{if } x<0 \text{ or } x>L. \end{cases} \]",
    );
    assert_eq!(text.matches("'u=0',").count(), 2, "{text}");
    assert!(text.contains("'x<0'") && text.contains("'x>L'") && text.contains("'u=a+b',"), "{text}");
    // Other words than those of a condition may say anything.
    let text = draft(r"\[ u = \begin{cases} a & \text{approximately } x>0 \\ b & \text{if } x<0 \end{cases} \]");
    assert!(!text.contains("'u=a',"), "{text}");
    // Two conditions that hold together are none of that kind.
    let text =
        draft(r"\[ u = \begin{cases} a & \text{if } x<0, \\ 0 & \text{if } x>0 \text{ and } y>0. \end{cases} \]");
    assert!(!text.contains("'u=0',"), "{text}");
}
