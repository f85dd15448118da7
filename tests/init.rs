//! `rederive init`, and the commands that print what a shell or a reader of manuals wants.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use rederive::derivation::parse;
use rederive::diag::{Source, render};
use rederive::paper;

fn rederive(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).assert()
}

fn draft(tex: &str) -> paper::Draft {
    let source = Source { path: "paper.tex".into(), text: tex.into() };
    let paper = paper::parse(source, String::new()).unwrap_or_else(|d| panic!("{}", render(&[*d], false)));
    paper::draft(&paper, "paper.tex")
}

/// Whatever the paper, the draft is a derivation file.
#[track_caller]
fn loads(tex: &str) -> paper::Draft {
    let draft = draft(tex);
    let source = Source { path: "draft.toml".into(), text: draft.text.clone() };
    if let Err(found) = parse(source, "draft") {
        panic!("{}\n{}", render(&found, false), draft.text);
    }
    draft
}

#[test]
fn a_draft_has_labels_formulas_and_guesses_that_are_marked() {
    let draft = loads(include_str!("source/paper.tex"));
    insta::assert_snapshot!(draft.text);
    let guesses = draft.text.lines().filter(|l| l.contains("role = \"")).collect::<Vec<_>>();
    assert_eq!(guesses.len(), draft.symbols);
    assert!(guesses.iter().all(|l| l.contains("# confirm: ")), "every guess is marked");
    assert!(draft.text.matches("# confirm: not read").count() == draft.refused);
}

#[test]
fn an_index_is_not_taken_for_a_name() {
    let draft =
        loads(r"\begin{equation}\label{e} \dot x_k=a_k x_k, \quad E=\frac12 a_ix_i^2, \quad b_k=0\end{equation}");
    assert!(draft.text.contains("'x' = { role = \"state\", shape = \"3\" }"), "{}", draft.text);
    for name in ["'a_k'", "'b_k'", "'x_k'"] {
        assert!(!draft.text.contains(name), "{name} in {}", draft.text);
    }
}

#[test]
fn papers_of_every_kind_give_drafts_that_load() {
    for tex in [
        "",
        r"\[ x' = y'' \] \[ f'(x) = 2 \]",
        r"\[ ''' = ' \] \[ a = \text{it's ''' so} \]",
        r"\begin{equation}\label{a b/ü'} \frac{a}{b}=c \end{equation}\begin{equation}\label{a b/ü'} d=e \end{equation}",
        r"\begin{equation}\label{...} \end{equation} \[ = \] \[ \] \[ {{ \] \[ a_{b_{c}} = d^{e^{f}} \]",
        r"\title{A ''quoted'' \emph{title} with \\ and ''' too} \[ \int_0^1 f(x) dx = 1 \] \[ x \in \mathbb{R} \]",
        r"\[ \Psi(x,t) = \sum_n c_n \psi_n(x) e^{-iE_nt/\hbar} \]",
        r"\[ \{q_i,p_j\}=\delta_{ij}, \quad \nabla\times\vec B = \mu_0\vec J \]",
    ] {
        loads(tex);
    }
}

#[test]
fn the_command_writes_a_file_once_and_the_file_can_be_checked() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("paper.tex"), include_str!("source/paper.tex")).expect("written");
    rederive(folder.path(), &["init", "paper.tex"]).code(0).stdout("").stderr(predicate::str::contains("confirm"));
    let path = folder.path().join("derivations/paper.toml");
    let text = fs::read_to_string(&path).expect("written");
    rederive(folder.path(), &["init", "paper.tex"]).code(2).stderr(predicate::str::contains("is there already"));
    assert_eq!(fs::read_to_string(&path).expect("still there"), text);
    rederive(folder.path(), &["init", "paper.tex", "--output", "-"]).code(0).stdout(text);
    // It has a motion, on which what it speaks of is tried; every formula is as printed.
    let run = rederive(folder.path(), &["check", "--source", "paper.tex", "--no-reports"]);
    run.stdout(predicate::str::contains("0 not the same"));
    fs::write(folder.path().join("empty.tex"), "no formula").expect("written");
    rederive(folder.path(), &["init", "empty.tex"]).code(2).stderr(predicate::str::contains("displays no equation"));
    rederive(folder.path(), &["init", "none.tex"]).code(2).stderr(predicate::str::contains("paper::unreadable"));
}

/// The lines of a draft below `[symbols]`, before the first claim.
fn of_the_file(draft: &paper::Draft) -> String {
    let rest = draft.text.split("\n[symbols]\n").nth(1).unwrap_or_default();
    rest.split("[[claim]]").next().unwrap_or_default().to_owned()
}

#[test]
fn no_formula_is_lost_or_changed_by_another() {
    let draft = loads(
        r"\[ \dot x=v \] \[ \frac{dy}{dx}=ky \] \[ F=eE \] \[ y=e^{kx} \] \[ \int_0^1 y\,dx=1 \] \[ \sum_n a_n=1 \] \[ x\approx vt \]
           \[ g^{\mu\nu}=0 \] \[ a=\langle b\rangle \] \[ \hat H=c \]",
    );
    assert_eq!((draft.formulas, draft.refused), (4, 6), "{}", draft.text);
    // A charge is one where it is printed; elsewhere e is Euler's number.
    assert!(!of_the_file(&draft).contains("'e' ="), "{}", draft.text);
    assert_eq!(draft.text.matches("'e' = ").count(), 1, "{}", draft.text);
    for name in ["`integral`", "`sum`", "approximation", "an index above", "`bra-ket`", "a hat"] {
        assert!(draft.text.contains(name), "{name} in {}", draft.text);
    }
}

#[test]
fn a_prime_is_a_derivative_only_where_the_paper_shows_it() {
    // Two primes, or a place behind a prime: derivatives.
    let draft = loads(r"\[ y''+p(x)y'+q(x)y=0 \]");
    assert!(draft.text.contains("'y(x)' = { role = \"field\" }"), "{}", draft.text);
    // Beside dots, other axes.
    let draft = loads(r"\[ x'=x\cos a+z\sin a \] \[ \dot x=z \]");
    assert!(draft.text.contains("\"x'\" = { role = \"parameter\" }"), "{}", draft.text);
    // A function elsewhere, and one prime: it is not known.
    let draft = loads(r"\[ n(s)=a \] \[ n\sin b=n'\sin c \]");
    assert_eq!(draft.refused, 1, "{}", draft.text);
    assert!(draft.text.contains("a derivative, or another name"), "{}", draft.text);
}

#[test]
fn what_may_be_a_sum_or_a_matrix_is_no_number() {
    for tex in [
        r"\[ T=m_iv_iv_i+v_{\rm max} \]",
        r"\[ AB-BA=C \]",
        r"\[ \Gamma^r_{\theta\theta}=ar \]",
        r"\[ E=e^2 \] \[ y=e^{ax} \] \[ F=eE \]",
        r"\[ \frac{d(ct)}{d\tau}=a \]",
        r"\[ a=\{b,c\} \]",
    ] {
        let draft = loads(tex);
        assert!(draft.refused > 0, "{tex}: {}", draft.text);
    }
}

#[test]
fn a_first_motion_is_that_of_the_printed_rates() {
    let draft = loads(
        r"\[ \dot q=p \] \[ \dot p=-kq \] \[ \dot z=w \] \[ \ddot\theta=-g\sin\theta \] \[ \partial_tu=c\partial_xu \] \[ \dot a=\frac{da}{dt} \]",
    );
    let file = of_the_file(&draft);
    assert!(file.contains("states = ['\\theta', 'p', 'q', 'z']"), "{file}");
    assert!(file.contains("'\\dot \\theta' = "), "{file}");
    let numbers = file.lines().filter(|l| l.starts_with("parameters") || l.starts_with("initial"));
    assert!(
        numbers.clone().count() == 2 && numbers.clone().all(|l| !l.contains("= 1 ") && !l.contains("= 1,")),
        "{file}"
    );
}

#[test]
fn what_was_guessed_is_told_name_by_name() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("p.tex"), r"\[ m\ddot x=-kx \] \[ V \]").expect("written");
    let run = rederive(folder.path(), &["init", "p.tex"]).code(0);
    run.stderr(predicate::str::contains("x: state: the paper prints its rate"))
        .stderr(predicate::str::contains("1 expressions"));
    let run = rederive(folder.path(), &["init", "p.tex", "-o", "-", "--format", "json"]).code(0);
    let found: serde_json::Value = serde_json::from_slice(&run.get_output().stdout).expect("JSON");
    assert_eq!((found["formulas"].as_u64(), found["expressions"].as_u64()), (Some(1), Some(1)), "{found}");
    assert!(found["draft"].as_str().is_some_and(|d| d.contains("[system.motion]")), "{found}");
}

#[test]
fn completions_and_manual_know_every_command() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let help = rederive(folder.path(), &["--help"]).code(0);
    let help = String::from_utf8(help.get_output().stdout.clone()).expect("UTF-8");
    let commands: Vec<&str> = help
        .lines()
        .skip_while(|l| *l != "Commands:")
        .skip(1)
        .take_while(|l| !l.is_empty())
        .filter(|l| l.starts_with("  ") && !l.starts_with("   "))
        .filter_map(|l| l.split_whitespace().next())
        .filter(|c| *c != "help")
        .collect();
    assert!(commands.contains(&"check") && commands.contains(&"init"), "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = rederive(folder.path(), &["completions", shell]).code(0).stderr("");
        let text = String::from_utf8(run.get_output().stdout.clone()).expect("UTF-8");
        assert!(commands.iter().all(|c| text.contains(c)) && text.contains("no-reports"), "{shell}");
    }
    rederive(folder.path(), &["completions", "tcsh"]).code(2);
    rederive(folder.path(), &["manual"]).code(0).stdout(predicate::str::contains(".SH NAME"));
    rederive(folder.path(), &["manual", "--output", "man"]).code(0).stdout("");
    for command in &commands {
        let page = fs::read_to_string(folder.path().join(format!("man/rederive-{command}.1"))).expect("a page");
        assert!(page.contains(".SH NAME") && page.contains(command), "{command}");
    }
    assert!(folder.path().join("man/rederive.1").exists());
}

#[test]
fn an_equation_of_motion_moves_its_state() {
    for (tex, equation) in [
        (r"\[m\ddot x+\gamma\dot x+kx=0\] and \[L=m r^2\dot\theta\]", Some(r"'m\ddot x+\gamma\dot x+kx=0'")),
        (r"\[m\ell^2\ddot\theta+mg\ell\sin\theta=0\]", Some(r"'m\ell^2\ddot\theta+mg\ell\sin\theta=0'")),
        // The second rate is squared, or another second rate stands beside it.
        (r"\[m\ddot x^2+kx=0\]", None),
        (r"\[m\ddot x+k\ddot y=0\]", None),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("p.tex"), tex).expect("written");
        let mut run = assert_cmd::Command::cargo_bin("rederive").expect("the program");
        run.current_dir(folder.path()).args(["init", "p.tex", "-o", "p.toml"]).assert().success();
        let draft = std::fs::read_to_string(folder.path().join("p.toml")).expect("a draft");
        let system = draft.lines().find(|l| l.starts_with("equations = "));
        assert_eq!(system.is_some(), equation.is_some(), "{draft}");
        assert!(equation.is_none_or(|e| system.is_some_and(|s| s.contains(e))), "{draft}");
        let mut run = assert_cmd::Command::cargo_bin("rederive").expect("the program");
        let code = run.current_dir(folder.path()).args(["check", "p.toml"]).assert().get_output().status.code();
        assert!(matches!(code, Some(0 | 3)), "{code:?}: {draft}");
    }
}

#[test]
fn what_a_file_has_no_room_for_is_read_with_less_of_it() {
    // Numbers in the place of coordinates: a function is derived by what it is applied to.
    let draft = loads(
        r"\[ \frac{\partial u}{\partial a}+\frac{\partial u}{\partial b}=0 \] \[ \frac{\partial v}{\partial g}=\frac{\partial v}{\partial h} \]
           \[ \frac{\partial w}{\partial p}=\frac{\partial w}{\partial q} \]",
    );
    assert_eq!((draft.formulas, draft.refused), (3, 0), "{}", draft.text);
    // A rate along a motion is none of what numbers could stand for.
    let draft = loads(
        r"\[ \frac{du}{dt}=\frac{\partial u}{\partial t}+\frac{\partial u}{\partial g}\frac{dg}{dt} \] \[ \frac{\partial v}{\partial a}=\frac{\partial v}{\partial b} \]
           \[ \frac{\partial w}{\partial c}=\frac{\partial w}{\partial s} \] \[ \frac{\partial k}{\partial a}=\frac{\partial k}{\partial b} \]",
    );
    assert!(!draft.text.contains("'u(g,t)' = { role = \"field\" } # confirm: a function of what moves, or of numbers\n'g' = { role = \"parameter\""), "{}", draft.text);
    // Over what an index runs is said beside the formula, and is none.
    let draft = loads(r"\[ p_i=mv_i, \quad i=1,2,\ldots,n \]");
    assert!(draft.text.contains("# printed beside it: i=1,2,") && draft.refused == 0, "{}", draft.text);
    // Zero in bold, a determinant between bars, a sine before a vector.
    let draft = loads(
        r"\[ \mathbf F=\mathbf 0 \] \[ \begin{vmatrix} a & b \\ c & d \end{vmatrix}=ad-bc \] \[ \mathbf e=\cos a\,\mathbf i+\sin a\mathbf j \] \[ \boldsymbol{p_e'}=b\mathbf F \]",
    );
    assert_eq!(draft.refused, 0, "{}", draft.text);
    let draft = loads(r"\[ U=\frac{e^2}{r} \] \[ x=ky \]");
    assert!(draft.guesses.iter().any(|g| g.starts_with("e: parameter")), "{:?}", draft.guesses);
}
