//! What `init` reads of a paper: which evidence counts where, and what stays refused with both readings.

use rederive::derivation::parse;
use rederive::diag::{Source, render};
use rederive::paper;

/// The text of a draft, which loads.
#[track_caller]
pub fn draft(tex: &str) -> String {
    let source = Source { path: "paper.tex".into(), text: tex.into() };
    let paper = paper::parse(source, String::new()).unwrap_or_else(|d| panic!("{}", render(&[*d], false)));
    let text = paper::draft(&paper, "paper.tex").text;
    let source = Source { path: "draft.toml".into(), text: text.clone() };
    if let Err(found) = parse(source, "draft") {
        panic!("{}\n{text}", render(&found, false));
    }
    text
}

/// What is said of a formula that is not read; `None` where it is drafted.
#[track_caller]
pub fn refused(text: &str, formula: &str) -> Option<String> {
    let mut before = "";
    for line in text.lines() {
        if line.trim_start_matches(['#', ' ']) == formula {
            let why = before.strip_prefix("# confirm: not read, ").map(|w| w.trim_end_matches(':').to_owned());
            return Some(why.unwrap_or_else(|| panic!("{formula} stands in a comment of {text}")));
        }
        before = line;
    }
    assert!(
        text.contains(&format!("'{formula}',")) || text.contains(&format!("'''{formula}''',")),
        "{formula}: {text}"
    );
    None
}

#[track_caller]
pub fn is_drafted(text: &str, formulas: &[&str]) {
    for formula in formulas {
        assert_eq!(refused(text, formula), None, "{formula}");
    }
}

#[test]
fn a_sign_behind_a_script_relates_nothing() {
    let text = draft(r"\[ \delta w_\perp = a w_\parallel + b w_\| \] \[ a \perp b \] \[ v_\bot = 2 v^\perp \]");
    is_drafted(&text, &[r"\delta w_{\perp}=a w_{\parallel}+ b w_\|"]);
    assert!(refused(&text, r"a\perp b").is_some(), "{text}");
}

#[test]
fn lengths_print_nothing() {
    let text = draft(
        r"\[ \Psi = A\cos(\mkern1.5mu\overline{\mkern-1.5mu\omega\mkern-1.5mu}\mkern1.5mu s) \]
        \[ \begin{pmatrix} a \\[1.5ex] b \end{pmatrix} = \begin{pmatrix} b \\* [2pt] a \end{pmatrix} \]
        \[ {\cal V}_1 + {\cal V}_2 = {\cal V} \]",
    );
    is_drafted(
        &text,
        &[
            r"\Psi=A\cos(\overline{\omega} s)",
            r"\begin{pmatrix} a \\[1.5ex] b \end{pmatrix}=\begin{pmatrix} b \\* [2pt] a \end{pmatrix}",
            r"{\cal V}_1 + {\cal V}_2={\cal V}",
        ],
    );
    assert!(text.contains(r"'\bar{\omega}' = ") || text.contains(r"'\overline{\omega}' = "), "{text}");
}

#[test]
fn an_operator_of_one_chapter_is_a_number_where_another_shows_it() {
    let chapters = |last: &str| {
        format!(
            r"\chapter{{A}} The operator $p$ acts. \[ a = p b \]
            \chapter{{B}} \[ F = A p \] \[ q = p b \]
            \chapter{{C}} {last}"
        )
    };
    let text = draft(&chapters(r"\[ s = p r \]"));
    assert!(refused(&text, "a=p b").is_some_and(|why| why.contains("operator")), "{text}");
    assert!(refused(&text, "s=p r").is_some_and(|why| why.contains("operator")), "nothing shows it there: {text}");
    is_drafted(&text, &["F=A p", "q=p b"]);
    // One chapter, and one of quanta: the word counts in all of it.
    let text = draft(r"The operator $p$ acts. \[ F = A p \] \[ q = p b \]");
    assert!(refused(&text, "q=p b").is_some(), "{text}");
    let text = draft(&chapters(r"\[ w = \hbar k \]"));
    assert!(refused(&text, "q=p b").is_some(), "{text}");
}

#[test]
fn a_prime_is_a_part_of_a_name_where_nothing_is_derived() {
    let calculus = r"\section{A} \[ u'' + u = 0 \]";
    let lens = r"\section{B} \[ \frac{1}{s} + \frac{1}{s'} = \frac{1}{f} \]";
    let formula = r"\frac{1}{s} + \frac{1}{s'}=\frac{1}{f}";
    is_drafted(&draft(&format!("{calculus} {lens}")), &[formula]);
    for with in [r"\[ \frac{ds}{dr} = 2 \]", r"\[ \int_0^1 s\,dr = 2 \]", r"\[ p' = k p, \quad \dot q = 2 \]"] {
        let text = draft(&format!("{calculus} {lens} {with}"));
        let why = refused(&text, formula).unwrap_or_else(|| panic!("{with}: {text}"));
        assert!(why.contains("a derivative, or another name"), "{with}: {why}");
    }
}

#[test]
fn e_is_a_name_in_a_chapter_of_its_factors() {
    let orbits = r"\chapter{Orbits} \[ b = a\sqrt{1-e^2} \] \[ r = \frac{p}{1+e\cos\theta} \]";
    let decay = r"\chapter{Decay} \[ N = N_0 e^{-kx} \]";
    let text = draft(&format!("{decay} {orbits}"));
    is_drafted(&text, &[r"b=a\sqrt{1-e^2}"]);
    // Euler's number is raised in the same chapter, or divides as a number does: `1/e`.
    let text = draft(&format!(r"{orbits} \[ N = N_0 e^{{-kx}} \]"));
    assert!(refused(&text, r"b=a\sqrt{1-e^2}").is_some_and(|why| why.contains("Euler")), "{text}");
    let text = draft(&format!(r"{decay} \chapter{{Beams}} \[ w = \frac{{I}}{{e^2}} \] \[ v = \frac{{I}}{{e}} \]"));
    assert!(refused(&text, r"w=\frac{I}{e^2}").is_some_and(|why| why.contains("Euler")), "{text}");
}

#[test]
fn what_moves_elsewhere_is_a_coordinate_where_it_is_derived_by() {
    let text = draft(
        r"\[ \frac{dx}{dt} = u(x,t) \] \[ \frac{\partial u}{\partial t} + u\frac{\partial u}{\partial x} = 0 \]
        \[ \frac{\partial^2 u}{\partial x^2} = k u \] \[ \frac{\partial w}{\partial x} = 2 w \] \[ \frac{dE}{dt}=\frac{\partial E}{\partial x}\frac{dx}{dt} \]",
    );
    is_drafted(
        &text,
        &[
            r"\frac{\partial u}{\partial t} + u\frac{\partial u}{\partial x}=0",
            r"\frac{\partial^2 u}{\partial x^2}=k u",
            r"\frac{\partial w}{\partial x}=2 w",
        ],
    );
    // A total rate beside it: what moves is not held fixed.
    let chain = refused(&text, r"\frac{dE}{dt}=\frac{\partial E}{\partial x}\frac{dx}{dt}");
    assert!(chain.is_none_or(|why| why.contains("state")), "{text}");
}

#[test]
fn a_function_at_a_place_is_that_of_its_variables() {
    let text = draft(r"\[ \frac{dy}{dx} = f(x,y) \] \[ y_1 = y_0 + h f(x_0,y_0) \] \[ y_2 = y_1 + h f(x_1,y_1) \]");
    is_drafted(&text, &[r"\frac{dy}{dx}=f(x,y)", "y_1=y_0 + h f(x_0,y_0)", "y_2=y_1 + h f(x_1,y_1)"]);
    assert!(text.contains("'y(x)' = { role = \"field\" }"), "{text}");
    assert!(!text.contains("'f(x_0,y_0)'"), "{text}");
}

#[test]
fn a_difference_is_a_name_beside_coordinates_and_labels() {
    let text = draft(
        r"\[ \frac{\partial u}{\partial x} + \frac{\partial u}{\partial y} + \frac{\partial u}{\partial z} = 0 \]
        \[ \nabla^2 u = 0 \] \[ \Delta T = T_2 - T_1 \] \[ T = 2 s \] \[ \Delta_r = 3 s \] \[ \delta J = 0 \] \[ J = \delta_{ab} \]",
    );
    is_drafted(&text, &[r"\Delta T=T_2 - T_1", r"\delta J=0", r"\Delta_r=3 s", "T=2 s"]);
}

#[test]
fn a_letter_is_a_column_in_the_chapters_that_say_so() {
    let text = draft(
        r"\chapter{A} \[ A = \begin{pmatrix} a \\ b \\ c \end{pmatrix} \] \[ A\cdot A = s \]
        \chapter{B} \[ r = \frac{m}{1+Am\cos\theta} \]",
    );
    is_drafted(&text, &[r"r=\frac{m}{1+Am\cos\theta}"]);
    let text =
        draft(r"\chapter{A} \[ A = \begin{pmatrix} a \\ b \\ c \end{pmatrix} \] \[ r = \frac{m}{1+Am\cos\theta} \]");
    assert!(refused(&text, r"r=\frac{m}{1+Am\cos\theta}").is_some(), "{text}");
}

#[test]
fn a_gradient_says_nothing_of_the_shape_of_its_function() {
    let text = draft(
        r"\[ \nabla\phi = \begin{pmatrix} u \\ v \\ w \end{pmatrix} \] \[ \phi = x y z \] \[ u = \frac{\partial\phi}{\partial x} \]",
    );
    is_drafted(&text, &[r"\phi=x y z", r"u=\frac{\partial\phi}{\partial x}"]);
}

#[test]
fn rates_in_places_keep_their_dots_and_spellings() {
    let text = draft(
        r"\[ L(q_1,\dot q_1,t) = \frac12 m\dot q_1^2 \] \[ p_\alpha = \frac{\partial K}{\partial\dot{q}_\alpha} \]
        \[ \frac{\partial K}{\partial q_\alpha} = 0 \] \[ g(\phi,t) = \phi t \]",
    );
    assert!(text.contains(r"L(q_1,\dot q_1,t)' = "), "{text}");
    is_drafted(&text, &[r"p_\alpha=\frac{\partial K}{\partial\dot{q}_\alpha}", r"g(\phi,t)=\phi t"]);
    assert!(!text.contains(r"' t'"), "{text}");
}

#[test]
fn a_function_at_another_place_is_no_product() {
    let text = draft(r"\[ \rho(z) = a z \] \[ b = \rho(z+h) - \rho(z) \] \[ c = \rho(1-z) \]");
    let is_drafted = refused(&text, r"b=\rho(z+h) - \rho(z)").is_none();
    assert!(!is_drafted || text.contains(r"'\rho(z)' = { role = "), "{text}");
    // A function of one section, whose primes derive there, is another name where nothing is derived: refused.
    let text =
        draft(r"\section{A} \[ \frac{dn}{ds} = n'(s) \] \[ u'' + u = 0 \] \section{B} \[ n\sin\alpha = n'\sin\beta \]");
    assert!(refused(&text, r"n\sin\alpha=n'\sin\beta").is_some(), "{text}");
}

#[test]
fn values_of_a_function_of_several_places_are_of_what_stands_there_elsewhere() {
    let text = draft(
        r"\[ 3u(x) = 1 + x \] \[ 2u(x) = 2 - x \] \[ y(x,t) = x - 2t \] \[ y(x,0) = x \] \[ y(0,t) = -2t \]
        \[ v(x,0) = \sin(x) \] \[ v(0,t) = t^2 \] \[ w(x,0) = x \] \[ w(s,0) = s \]",
    );
    is_drafted(&text, &["y(x,0)=x", "y(0,t)=-2t", r"v(x,0)=\sin(x)", "v(0,t)=t^2"]);
    assert!(text.contains("'v(x,t)' = { role = \"field\" }"), "{text}");
    // Which variables these are is not shown.
    assert!(refused(&text, "w(x,0)=x").is_some(), "{text}");
}

#[test]
fn vectors_have_as_many_components_as_the_matrices_beside_them() {
    let text = draft(
        r"\[ P = \begin{bmatrix} a & b \\ c & d \end{bmatrix} \] \[ \vec y = P\vec x \] \[ P\vec v = \lambda\vec v \]
        \[ \begin{bmatrix} 1 & 2 \\ \noalign{\smallskip} 3 & 4 \end{bmatrix}\vec u = \vec w \]",
    );
    is_drafted(&text, &[r"\vec y=P\vec x", r"P\vec v=\lambda\vec v"]);
    assert!(!text.contains("not read"), "{text}");
    assert!(text.contains("shape = \"2\"") && !text.contains("shape = \"3\""), "{text}");
    // Matrices of several sizes in the paper are square in a formula for all of them.
    let text = draft(
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \] \[ B = \begin{bmatrix} 1 & 2 & 0 \\ 3 & 4 & 1 \\ 0 & 1 & 1 \end{bmatrix} \]
        \[ \det(A)\det(B)=\det(AB) \] \[ AB-BA=C \]",
    );
    is_drafted(&text, &[r"\det(A)\det(B)=\det(AB)"]);
}

#[test]
fn a_matrix_of_another_section_is_a_number_where_no_matrix_is_printed() {
    let matrices = r"\section{One} \[ M = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \] \[ N = \begin{bmatrix} 0 & 2 \\ 3 & 4 \end{bmatrix} \]";
    let text =
        draft(&format!(r"{matrices} \[ h-M=k \] \section{{Two}} \[ \frac{{dx}}{{dt}} = kx(M-x) \] \[ MN-NM=k \]"));
    is_drafted(&text, &[r"\frac{dx}{dt}=kx(M-x)"]);
    // Beside matrices, and where the order of the factors would count, it is none.
    assert!(refused(&text, "h-M=k").is_some(), "{text}");
    assert!(refused(&text, "MN-NM=k").is_some(), "{text}");
}

#[test]
fn primes_behind_brackets_derive_by_what_stands_in_them() {
    let text = draft(
        r"\[ m\ddot z = -mg \] \[ (m\dot z)' = -mg \] \[ \left(mz^2\dot q\right)^\prime = 0 \]
        \[ y(x) = x^2 \] \[ y'' + y' = x \] \[ y_1(x) = x \] \[ y_1'' = 0 \] \[ (ay + by_1)'' = ay'' + by_1'' \]
        \[ A(s) = \begin{bmatrix} s & 0 \\ 1 & s \end{bmatrix} \] \[ \bigl(A(s)A(s)\bigr)' = A'(s)A(s)+A(s)A'(s) \]
        \[ (z)' = w \] \[ (\dot z)' = w \] \[ (xz)' = w \]",
    );
    is_drafted(
        &text,
        &["(m\\dot z)'=-mg", r"\left(mz^2\dot q\right)^\prime=0", r"(ay + by_1)''=ay'' + by_1^{\prime\prime}"],
    );
    is_drafted(&text, &[r"\bigl(A(s)A(s)\bigr)'=A'(s)A(s)+A(s)A'(s)"]);
    assert!(text.contains("'A(s)' = { role = \"field\", shape = \"2x2\" }"), "{text}");
    // A name alone in brackets may be another name.
    for formula in ["(z)'=w", r"(\dot z)'=w", "(xz)'=w"] {
        assert!(refused(&text, formula).is_some(), "{formula}: {text}");
    }
}

#[test]
fn what_varies_is_a_number_where_only_other_rates_are_printed() {
    let text = draft(
        r"\[ \frac{dl}{dt} = kl \] \[ L = ml^2 \] \[ f(l) = l^2 \] \[ f(l) = 2l^3 \] \[ g(l) = l \] \[ \frac{\partial f}{\partial l}=2l \]
        \[ \frac{\partial H}{\partial p} = \dot q = \frac{p}{ml^2} \]",
    );
    is_drafted(&text, &[r"\frac{\partial H}{\partial p}=\dot q=\frac{p}{ml^2}"]);
    // Where it is derived by the time, it is none.
    let text = draft(
        r"\[ f(l) = l^2 \] \[ g(l) = l^3 \] \[ h(l) = l \] \[ \frac{\partial f}{\partial l}=2l \] \[ \frac{dl}{dt} = kl \]",
    );
    assert!(!text.contains("'l' = { role = \"parameter\" }"), "{text}");
}

#[test]
fn sides_that_are_products_of_capitals_are_matrices_beside_one() {
    let matrix = r"\begin{bmatrix} 1 & f \\ 0 & 1 \end{bmatrix}";
    let text = draft(&format!(
        r"\[ M_2M_1 = {matrix}{matrix} \] \[ M = M_2M_1 = {matrix} \] \[ I = I_2 = {matrix} \] \[ K = G = h \]"
    ));
    is_drafted(&text, &[&format!("M_2M_1={matrix}{matrix}"), &format!("M=M_2M_1={matrix}")]);
    assert!(text.contains("'M_2' = { role = \"parameter\", shape = \"2x2\" }"), "{text}");
    assert!(!text.contains("'G' = { role = \"parameter\", shape"), "{text}");
}

#[test]
fn a_function_that_is_equal_to_a_matrix_is_one() {
    let text = draft(
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \] \[ A = \begin{bmatrix} 1 & 2 & 0 \\ 3 & 4 & 1 \\ 0 & 0 & 1 \end{bmatrix} \]
        \[ B(\alpha) = \begin{bmatrix} \cos\alpha & \sin\alpha & 0 \\ -\sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 1 \end{bmatrix} \] \[ A = B(\phi)B(\psi) \]",
    );
    let claim = text.split("[[claim]]").find(|c| c.contains(r"'A=B(\phi)B(\psi)'")).expect("a claim");
    assert!(!claim.contains("2x2"), "{text}");
    // Where the other side is a matrix of another size, nothing is.
    let text = draft(
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \] \[ A(\phi) = B(\phi)B(\phi) \]
        \[ B(\alpha) = \begin{bmatrix} \cos\alpha & \sin\alpha & 0 \\ -\sin\alpha & \cos\alpha & 0 \\ 0 & 0 & 1 \end{bmatrix} \]",
    );
    assert!(refused(&text, r"A(\phi)=B(\phi)B(\phi)").is_some(), "{text}");
}

#[test]
fn a_capital_beside_a_matrix_is_no_number() {
    let matrix = r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}";
    let text = draft(&format!(
        r"\[ A = {matrix} \] \[ B = {matrix} \] \[ A(BC) = (AB)C \] \[ A(BA) = (AB)A \] \[ A\vec x = K\vec x \]"
    ));
    assert!(refused(&text, "A(BC)=(AB)C").is_some_and(|why| why.contains("matrix")), "{text}");
    is_drafted(&text, &["A(BA)=(AB)A"]);
}

#[test]
fn a_letter_without_an_index_is_no_vector_for_those_of_others() {
    let text = draft(r"\[ a_ib_i = c \] \[ a_i = kb_i \] \[ L = ma^2 \]");
    is_drafted(&text, &["L=ma^2"]);
    let claim = text.split("[[claim]]").find(|c| c.contains("'L=ma^2'")).expect("a claim");
    assert!(!claim.contains("shape") || claim.contains("'a' = { role = \"parameter\" }"), "{text}");
    let text = draft(r"\[ \frac{\partial f}{\partial q_k} = (\delta_{k1} - \delta_{k2})g \] \[ g = f^2 \]");
    assert!(refused(&text, r"\frac{\partial f}{\partial q_k}=(\delta_{k1} - \delta_{k2})g").is_some(), "{text}");
}

#[test]
fn boxed_displays_arrays_and_cases_are_read_as_they_print() {
    let text = draft(
        r"\newcommand{\boxedEquation}[2]{\begin{empheq}[box=\mybox]{equation}\label{#1}#2\end{empheq}}
        \begin{document} \boxedEquation{eq:a}{E = \frac12 m v^2}
        \begin{empheq}[left=\empheqlbrace]{align} p &= mv \\ k &= 2E \end{empheq}
        \[ \begin{array}{c} a = b+c \\ d = 2a. \end{array} \]
        \[ \begin{array}{c} a \\ d \end{array} \] \[ \begin{array}{ll} s=b & u = w \end{array} \]
        \[ f = \left\{ \begin{array}{l l} 2x & \mbox{if \(x>0\)} \\ 0 & \mbox{for $x \le 0$} \end{array} \right. \]
        \[ g = \left\{ \begin{array}{l l} 2x & \mbox{if \(x>0\)} \\ 0 & \mbox{otherwise} \end{array} \right. \]
        \end{document}",
    );
    is_drafted(&text, &[r"E=\frac12 m v^2", "p=mv", "k=2E", "a=b+c", "d=2a", "f=2x", "f=0"]);
    assert!(text.contains(r"\begin{array}{c} a \\ d \end{array}"), "{text}");
    assert!(text.contains("otherwise"), "{text}");
    for condition in ["x>0", r"x\le0"] {
        assert!(text.contains(&format!("'{condition}'")), "{condition}: {text}");
    }
}
