//! What `init` takes from what the paper prints elsewhere: sizes, variables, places, conditions; and what that never reaches.

use super::drafts::{draft, is_drafted, refused};

#[test]
fn a_name_with_a_number_below_is_a_matrix_where_it_is_equal_to_one() {
    let matrix = r"\begin{bmatrix} 1 & s \\ 0 & 1 \end{bmatrix}";
    let text = draft(&format!(r"\[ M_2 = {matrix} \] \[ M_{{13}} = {matrix} \]"));
    is_drafted(&text, &[&format!("M_2={matrix}"), &format!("M_{{13}}={matrix}")]);
    assert_eq!(text.matches("shape = \"2x2\"").count(), 2, "{text}");
    // Twice a matrix, the square of one, a name and a number.
    for left in ["2 M", "M^2", "M_1 2", "M_{1} 2"] {
        let text = draft(&format!(r"\[ {left} = {matrix} \]"));
        assert!(refused(&text, &format!("{left}={matrix}")).is_some(), "{text}");
    }
}

#[test]
fn primes_behind_a_column_are_those_of_its_names() {
    let formula = |left: &str| format!(r"{left}'=\begin{{bmatrix}} v \\ -u \end{{bmatrix}}");
    let paper = |left: &str, more: &str| format!(r"{more} \[ {left}' = \begin{{bmatrix}} v \\ -u \end{{bmatrix}} \]");
    let column = r"\begin{bmatrix} u \\ v \end{bmatrix}";
    let primes = r"\[ x'' = -x \] \[ u' = 2 \] \[ u(t) = v(t) = 1 \]";
    let text = draft(&paper(column, primes));
    is_drafted(&text, &[&formula(column)]);
    assert!(text.contains("'u(t)' = { role = \"field\"") && text.contains("'v(t)' = { role = \"field\""), "{text}");
    // Nothing shows by what they derive; an entry is a product.
    let text = draft(&paper(column, ""));
    assert!(refused(&text, &formula(column)).is_some(), "{text}");
    let product = r"\begin{bmatrix} uv \\ v \end{bmatrix}";
    let text = draft(&paper(product, r"\[ c = 1 \]"));
    assert!(refused(&text, &formula(product)).is_some(), "{text}");
}

#[test]
fn what_a_system_derives_by_the_time_is_no_place_of_others() {
    let other = r"\section{A} \[ y'' + x y' = 0 \] \[ y(t) = 2 \]";
    let formula = "z'=z + x^2";
    let text = draft(&format!(r"{other} \section{{B}} \[ x' = -y \] \[ y' = 2 x \] \[ z' = z + x^2 \]"));
    is_drafted(&text, &[formula]);
    assert!(text.contains("'z(t)' = { role = \"field\""), "{text}");
    // One other alone may be another variable.
    let text = draft(&format!(r"{other} \section{{B}} \[ x' = -y \] \[ z' = z + x^2 \]"));
    assert!(refused(&text, formula).is_some_and(|why| why.contains("a prime")), "{text}");
}

#[test]
fn what_is_derived_by_one_variable_is_a_function_of_it_alone() {
    let moving = r"\section{A} \[ \frac{dy}{dt} = 2 \] \[ \frac{dx}{dt} = 3 \]";
    for formula in [r"\frac{dy}{dx}=k y", r"\frac{d^2y}{{dx}^2}=-k^2 y", r"x\frac{d^2y}{dx^2}+\frac{dy}{dx}=0"] {
        let text = draft(&format!(r"{moving} \section{{B}} \[ \frac{{dy}}{{dx}} = x \] \[ {formula} \] \[ y(x)=1 \]"));
        is_drafted(&text, &[formula]);
        assert!(text.contains("'y(x)' = { role = \"field\""), "{text}");
        assert!(!text.contains("'y(x,t)'"), "{text}");
    }
    // Partially, or beside the time: of both.
    for right in ["t", "2"] {
        let text = draft(&format!(r"{moving} \[ \frac{{\partial y}}{{\partial x}} = {right} \]"));
        assert!(!text.contains("'y(x)' = "), "{text}");
    }
}

#[test]
fn a_value_is_that_of_the_variable_that_stands_beside_it() {
    let paper = r"\[ n(r) = 2 \] \[ n(x) = 3 \]";
    let text = draft(&format!(r"{paper} \[ n = n(0) e^{{-r}} \]"));
    is_drafted(&text, &["n=n(0) e^{-r}"]);
    assert!(text.contains("'n(r)' = { role = \"field\""), "{text}");
    // Both stand there, or none.
    for formula in ["n=n(0) e^{-rx}", "n=n(0) + 1"] {
        let text = draft(&format!(r"{paper} \[ {formula} \]"));
        assert!(refused(&text, formula).is_some(), "{text}");
    }
}

#[test]
fn the_identity_beside_matrices_is_one() {
    let matrix = r"\[ A = \begin{bmatrix} 0 & -k \\ 1 & 0 \end{bmatrix} \]";
    let text = draft(&format!(r"{matrix} \[ A^2 = -k I \]"));
    is_drafted(&text, &["A^2=-k I"]);
    assert!(text.contains("'I' = { role = \"parameter\", shape = \"2x2\" } # confirm: beside matrices"), "{text}");
    // Of numbers alone it is one; another letter is no identity.
    let text = draft(r"\[ A^2 = -k I \] \[ A = 3 \]");
    assert!(!text.contains("'I' = { role = \"parameter\", shape"), "{text}");
    let text = draft(&format!(r"{matrix} \[ A^2 = -k J \]"));
    assert!(refused(&text, "A^2=-k J").is_some(), "{text}");
}

#[test]
fn what_stands_below_a_name_with_a_label_is_no_part_of_the_label() {
    let text = draft(r"\[ k_i = {E_a}_i + \frac{{E_{a}}_{i}}{T} \] \[ {E_a}_i = 2 \]");
    for formula in [r"k_i={E_a}_i + \frac{{E_{a}}_{i}}{T}", "{E_a}_i=2"] {
        assert!(refused(&text, formula).is_some(), "{text}");
    }
    assert!(!text.contains("'E_{ai}' = "), "{text}");
    // A power, and a root.
    let text = draft(r"\[ w = x^{E_a}_i + \sqrt{E_a} \]");
    assert!(!text.contains("'E_{ai}' = "), "{text}");
}

#[test]
fn an_index_behind_a_label_stands_free() {
    let labels = r"\[ k_{g,i} = 2 \] \[ k_f = 3 \]";
    let text =
        draft(&format!(r"{labels} \[ k_{{f,i}} = A_i T^{{\beta_i}} \] \[ k_f = A_j T^{{\beta_j}} \] \[ A_0 = 2 \]"));
    is_drafted(&text, &[r"k_{f,i}=A_i T^{\beta_i}"]);
    assert!(refused(&text, r"k_f=A_j T^{\beta_j}").is_some(), "{text}");
}

#[test]
fn a_condition_means_the_place_of_its_formula() {
    let text = draft(
        r"\[ u(x) = k x \] \[ \frac{\partial}{\partial x}u(x) = \begin{cases} k & \text{if } x < 0, \\ 2k & \text{if } x \geq 0. \end{cases} \]",
    );
    is_drafted(&text, &[r"\frac{\partial}{\partial x}u(x)=k", r"\frac{\partial}{\partial x}u(x)=2k"]);
    assert!(!text.contains("'x' = { role = \"parameter\""), "{text}");
}

#[test]
fn what_a_formula_with_i_derives_is_complex() {
    let text = draft(
        r"\[ u(x) = A e^{ikx} \] \[ \frac{\partial}{\partial x}u(x) = ik(A e^{ikx} - B e^{-ikx}) \] \[ p = \hbar k \]",
    );
    is_drafted(&text, &[r"\frac{\partial}{\partial x}u(x)=ik(A e^{ikx} - B e^{-ikx})"]);
    assert_eq!(text.matches("'u(x)' = ").count(), 1, "{text}");
    assert!(text.contains("'u(x)' = { role = \"field\", complex = true }"), "{text}");
}

#[test]
fn an_argument_ends_at_an_angle_that_stands_alone_elsewhere() {
    let angles = r"\[ \cos\theta_i = 1 \] \[ \cos(\theta_r) = 2 \]";
    let text = draft(&format!(r"{angles} \[ \sin\theta_i E_i = \sin{{\theta_r}} E_r \]"));
    is_drafted(&text, &[r"\sin(\theta_i) E_i=\sin(\theta_r) E_r"]);
    // How it is printed stands above it.
    assert!(text.contains("# confirm: arguments of functions end at the angle"), "{text}");
    assert!(text.contains("#   \\sin\\theta_i E_i=\\sin{\\theta_r} E_r"), "{text}");
    let text = draft(r"\[ \cos\phi = a \] \[ b = \tan\phi\frac{1-c}{2} \]");
    is_drafted(&text, &[r"b=\tan(\phi)\frac{1-c}{2}"]);
    // Nothing shows it; another letter's subscript; a product in an argument elsewhere; a phase; one of two.
    for (before, formula) in [
        ("", r"b=\sin\theta_i E_i"),
        (angles, r"b=\sin\theta_i E_r"),
        (r"\[ \cos\theta_i = \cos(\theta_i E_i) \]", r"b=\sin\theta_i E_i"),
        (r"\[ \cos\phi = a \]", r"b=\tan\phi\frac{x}{c}"),
        (r"\[ \cos\theta_i = 1 \]", r"\sin\theta_i E_i=\sin\theta_r E_r"),
    ] {
        let text = draft(&format!(r"{before} \[ {formula} \]"));
        let why = refused(&text, formula).unwrap_or_else(|| panic!("{formula} is read in {text}"));
        assert!(why.contains("where the argument of"), "{why}");
    }
}

#[test]
fn a_divergence_goes_through_a_number_to_its_vector() {
    let text = draft(r"\[ \nabla\cdot\epsilon\mathbf E=\rho \] \[ \nabla\times\mu\mathbf H=\mathbf J \]");
    is_drafted(&text, &[r"\nabla\cdot\epsilon\mathbf E=\rho", r"\nabla\times\mu\mathbf H=\mathbf J"]);
    // What stands behind it; what has no such meaning.
    for formula in [
        r"\nabla\cdot\epsilon\mathbf E\phi=\rho",
        r"\nabla\cdot\epsilon\mathbf E\cdot\mathbf B=\rho",
        r"\nabla\epsilon\mathbf E=\rho",
        r"\nabla\cdot\epsilon^2\mathbf E=\rho",
    ] {
        let text = draft(&format!(r"\[ {formula} \]"));
        assert!(refused(&text, formula).is_some(), "{text}");
    }
}

#[test]
fn an_average_of_a_name_is_a_name() {
    for (printed, formula) in [
        (r"\langle E\rangle=\frac{3}{2}kT", r"E_{\text{mean}}=\frac{3}{2}kT"),
        (r"I=\left\langle{ \Psi_s }\right\rangle^2", r"I=\Psi_{s,\text{mean}}^2"),
    ] {
        let text = draft(&format!(r"\[ {printed} \]"));
        is_drafted(&text, &[formula]);
        assert!(text.contains("# confirm: an average is a name; printed:"), "{text}");
    }
    // Averages of more than a name, elements of matrices, a part of something; a paper of quanta.
    for (before, formula) in [
        ("", r"\langle E^2\rangle=a"),
        ("", r"\langle EB\rangle=a"),
        ("", r"\langle E\rangle=\langle EB\rangle"),
        ("", r"\langle E|B\rangle=a"),
        ("", r"\langle E\rangle_2=a"),
        ("", r"|E\rangle=a"),
        ("", r"\langle E,B\rangle=a"),
        ("", r"\langle2\rangle=a"),
        (r"\[ p=\hbar k \]", r"\langle E\rangle=a"),
        (r"\[ \hat H=c \]", r"\langle E\rangle=a"),
    ] {
        let text = draft(&format!(r"{before} \[ {formula} \]"));
        assert!(refused(&text, formula).is_some_and(|why| why.contains("bra-ket")), "{formula}: {text}");
    }
}

/// All that is listed behind "where" are meanings: the first is no condition of the others.
#[test]
fn a_list_behind_where_is_of_meanings() {
    let display = |list: &str| {
        let text = format!(
            "\\begin{{equation}}\ny = Ax + \\frac{{C}}{{L}}, \\quad \\text{{where}} \\quad {list}.\n\\end{{equation}}\n"
        );
        draft(&text)
    };
    for list in ["A=68.7672, C=3.0022, L = 299.2239", "A=68.7672, C=3.0022 \\text{ and } L = 299.2239"] {
        let text = display(list);
        let assumed = "assuming = [\n  'A=68.7672',\n  'C=3.0022',\n  'L=299.2239',\n]";
        assert!(text.contains(assumed) && !text.contains("always = [\n  'C="), "{text}");
    }
    // Behind other words it is something else again.
    assert!(!display("A=68.7672 \\text{ so that } L = 299.2239").contains("  'L=299.2239',\n]\nalways"));
}
