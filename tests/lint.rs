//! `rederive lint` and `rederive PAPER.TEX`: a paper as it is.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use rederive::check::Limits;
use rederive::diag::Source;
use rederive::lint::{self, Word};
use rederive::paper::{self, Paper};

use Word::{Condition, Defines, Differs, Follows, NotRead, Wrong};

fn rederive(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).assert()
}

fn read(tex: &str) -> Paper {
    let source = Source { path: "paper.tex".into(), text: tex.into() };
    paper::parse(source, String::new()).unwrap_or_else(|d| panic!("{d}"))
}

/// The word on every relation, with the relation.
fn words(tex: &str) -> Vec<(Word, String)> {
    let paper = read(tex);
    lint::lint(&paper, &Limits::default())
        .judgements
        .iter()
        .map(|j| (j.word, paper.printed[j.relation].text()))
        .collect()
}

/// What is told beside the word on the last relation.
fn why(tex: &str) -> String {
    lint::lint(&read(tex), &Limits::default()).judgements.pop().map(|j| j.why).unwrap_or_default()
}

#[track_caller]
fn says(tex: &str, wanted: &[Word]) {
    let found = words(tex);
    assert_eq!(found.iter().map(|w| w.0).collect::<Vec<_>>(), wanted, "{found:?}");
}

/// What is shown instead of the first wrong step.
fn instead(tex: &str) -> Option<String> {
    let paper = read(tex);
    lint::lint(&paper, &Limits::default()).judgements.into_iter().find_map(|j| j.instead)
}

#[test]
fn two_planted_errors_of_a_page_are_told_in_one_command() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("page.tex"), include_str!("lint/page.tex")).expect("written");
    let run = rederive(folder.path(), &["page.tex"]).code(1).stderr("");
    let text = String::from_utf8(run.get_output().stdout.clone()).expect("UTF-8");
    let wrong: Vec<&str> = text.lines().filter(|l| l.contains("  wrong  ")).collect();
    assert_eq!(wrong.len(), 2, "{text}");
    // The sign of the potential in the Lagrangian, and of the energy in the quartic.
    assert!(wrong[0].contains("L=E_{\\mathrm{kin}}") && wrong[1].contains("H+\\frac{\\Lambda z^2}{2}"), "{text}");
    assert!(text.contains("page.tex:15:") && text.contains("page.tex:38:"), "{text}");
    assert!(text.contains("-H+\\frac{\\Lambda z^2}{2}"), "{text}");
    assert!(text.contains("follows") && text.contains("E_{\\mathrm{pot}}=m g h"), "{text}");
    // Said with the command's name, and again: the same bytes.
    rederive(folder.path(), &["lint", "page.tex"]).code(1).stdout(text);
}

#[test]
fn the_slip_of_a_chain_of_six_lines_is_told_at_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("chain.tex"), include_str!("lint/chain.tex")).expect("written");
    let run = rederive(folder.path(), &["chain.tex"]).code(1);
    run.stdout(predicate::str::contains("chain.tex:8:").and(predicate::str::contains("x^2+x+7")));
    let mended = include_str!("lint/chain.tex").replace("x^2+x+1", "x^2+x+7").replace(r"\frac34", r"\frac{27}4");
    fs::write(folder.path().join("chain.tex"), mended.replace("+3}{4}", "+27}{4}")).expect("written");
    rederive(folder.path(), &["chain.tex"]).code(0).stdout(predicate::str::contains("follows"));
}

#[test]
fn words_are_what_the_formulas_deserve() {
    use Word::{Approximates, NotFollowed};
    says(r"\[ E=mc^2 \]", &[Defines]);
    says(r"\[ (a+b)^2=a^2+2ab+b^2 \]", &[Follows]);
    says(r"\[ A=(a+b)^2=a^2+2ab+b^2 \]", &[Follows]);
    says(r"\[ h=a+b \] \[ h^2=a^2+2ab+b^2 \]", &[Defines, Follows]);
    says(r"With $h=a+b$, \[ h^2=a^2+2ab+b^2 \]", &[Defines, Follows]);
    says(r"\[ m\ddot x=-kx \]", &[Condition]);
    says(r"\[ x\approx y \]", &[Approximates]);
    says(r"\[ x>0 \]", &[Condition]);
    says(r"\[ x=\int_0^1 y \]", &[NotRead]);
    says(r"\[ x=1,2,3 \]", &[NotRead]);
    says(r"\[ A=ab+c=d+\sqrt{f} \]", &[NotFollowed]);
    says(r"\[ \dot x=-y, \quad \dot y=x, \quad N=x^2+y^2 \] \[ \dot N=0 \]", &[Defines, Defines, Defines, Follows]);
}

/// A lint that calls right formulas wrong is of no use: nothing of this is.
#[test]
fn what_may_be_meant_otherwise_is_not_called_wrong() {
    for tex in [
        r"\[ x+y=x-y \]",
        r"\[ x^2=2x \]",
        r"\[ L=T-V \] \[ L=T+V \]",
        r"\[ \sin x=x \]",
        r"\[ x_1=x_2, \quad a+b=2a \]",
        r"\section{A} \[ E=ab \] \section{B} \[ E^2=a^2c^2 \]",
        r"\[ \hat x\hat p-\hat p\hat x=i\hbar \]",
        r"\[ x_ix_i=x_jx_jx_kx_k \]",
        r"\[ E'=\frac{\hbar^2(k')^2}{2M}=\frac{\hbar^2(-k)^2}{2M}=\frac{\hbar^2k^2}{2M} \]",
        r"\[ F=E+\frac{q}{\sqrt{\mu\epsilon}}B=E+\frac qnB \]",
        r"\[ (BAB^{-1})^2=BAB^{-1}BAB^{-1}=BAIAB^{-1}=BA^2B^{-1} \]",
        r"\[ C=AB+QD-BA=QD+2AB \]",
        r"\[ y=f(x+1)=f(x)+1 \] \[ f(x)=x \]",
        r"\[ d(xy)=x\,dy+y\,dx \]",
        r"\[ f(x)=\sqrt{x^2}+1 = x+1 \]",
        r"\[ \psi=e^{ikx}, \quad |\psi|^2=1 \]",
    ] {
        assert!(words(tex).iter().all(|w| w.0 != Word::Wrong), "{tex}: {:?}", words(tex));
    }
}

#[test]
fn a_wrong_step_has_the_nearest_formula_that_holds_beside_it() {
    for (tex, right) in [
        (r"\[ A=(a+b)^2+c=a^2-2ab+b^2+c \]", "a^2+2ab+b^2+c"),
        (r"\[ A=\cos^2x-\sin^2x+q=2\sin^2x-1+q \]", r"2\cos^2x-1+q"),
        (r"\[ h=a+b \] \[ h^2+c=a^2+ab+b^2+c \]", "a^2+2ab+b^2+c"),
        (
            r"\[ \omega=\sqrt{\frac g\ell} \] \[ T=\frac{2\pi}\omega=\sqrt{\frac\ell g} \]",
            r"2\pi\cdot\left(\sqrt{\frac{\ell}{g}}\right)",
        ),
    ] {
        assert_eq!(instead(tex).map(|t| t.replace(' ', "")).as_deref(), Some(right), "{tex}");
    }
}

/// Texts that print the same, or say the same, have the same word.
#[test]
fn derivatives_chains_and_lost_terms_are_claims() {
    for (tex, right) in [
        (r"Let $f(x)=x^2e^{-x}$. \[f'(x)=(2x+x^2)e^{-x}\]", r"(2x-x^2)e^{-x}"),
        (r"Let $y=x^3$. Then $\frac{dy}{dx}=3x$.", "3x^2"),
        (r"With $x=A\cos\omega t$ we have \[\ddot x=\omega^2x.\]", r"-\omega^2x"),
        (r"Here $\cos2x=\cos^2x-\sin^2x=2\cos^2x+1$.", r"2\cos^2x-1"),
        (r"Thus $\frac{1}{1-x}=1+x+\frac{x^2}{1+x}$.", r"1+x+\frac{x^2}{1-x}"),
        (r"We have \[(a+b)^2=a^2+b^2.\]", "a^2+b^2+2ab"),
        (r"Let $r=\frac{a-b}{a+b}$. \[R=r^2=\left(\frac{a-b}{a+b}\right)^3\]", r"(\frac{a-b}{a+b})^2"),
        (r"Let $z=\frac xy$. Then $\frac{\partial z}{\partial y}=\frac{x}{y^2}$.", r"-\frac{x}{y^2}"),
        (r"Let $F=ma$ and $a=\frac{v^2}{r}$. Then \[F=\frac{mv}{r}.\]", r"\frac{mv^2}{r}"),
    ] {
        assert_eq!(instead(tex).as_deref(), Some(right), "{tex}");
    }
    for tex in [
        // Another case, another item of a list, a condition, an unknown that takes the difference in.
        r"Let $F=ma$ and $a=\frac{v^2}{r}$. If it is thrown in another case then \[F=\frac{mv}{r}.\]",
        r"\begin{itemize}\item Let \[r=\frac{b}{a-c}.\] \item Thus let \[r=\frac{b}{c-a}.\]\end{itemize}",
        r"Suppose $\frac{1}{1-x}=1+x+\frac{x^2}{1+x}$.",
        r"The vectors are orthogonal where \[(a+b)^2=a^2+b^2.\]",
        r"Let $x=A\cos\omega t$. In a moving frame \[\bar x=\omega^2x.\]",
    ] {
        assert_eq!(instead(tex), None, "{tex}");
    }
}

#[test]
fn a_case_of_the_running_text_proves_nothing_later() {
    for case in [
        r"\begin{figure}\caption{The body for $\theta=\alpha$}\end{figure}",
        r"Of this kind are bodies of which $\theta=\alpha$.",
        r"\begin{itemize}\item $\theta=\alpha+b$: a top.\end{itemize}",
        r"当$\theta=2\alpha$。",
    ] {
        let found = words(&format!(r"{case} The angle is \[\tan(\theta-\alpha)=\sin(2\theta-2\alpha)=\tan b.\]"));
        assert!(found.iter().all(|(word, _)| *word != Word::Follows && *word != Word::Wrong), "{case}: {found:?}");
    }
}

#[test]
fn displays_are_read_as_they_are_printed() {
    for (tex, wanted) in [
        (r"\begin{align} u &= ab & v &= cd \end{align}", &["u=ab", "v=cd"][..]),
        (r"\begin{align} E &= \frac12mv^2 \nonumber\\ &\quad+mgh \end{align}", &[r"E=\frac12mv^2 +mgh"][..]),
        (r"\begin{align} A &= B \\ &= C \end{align}", &["A=B=C"][..]),
        (r"\[\Phi=\left\{T, V, n\right\}\]", &[r"\Phi=\left\{T, V, n\right\}"][..]),
        (r"\DefineShortVerb{\|} \[a=b\] The |$HOME/x| runs. \[c=d\] $y=1$", &["a=b", "c=d", "y=1"][..]),
        (r"\let\s\section \renewcommand\section[1]{\s{#1}} \section{A} \[a=b\]", &["a=b"][..]),
    ] {
        let texts: Vec<String> = words(tex).into_iter().map(|w| w.1).collect();
        assert_eq!(texts, wanted, "{tex}");
    }
}

#[test]
fn what_has_no_end_is_read_as_far_as_it_goes_and_told() {
    let paper = read("\\begin{equation} a=b\n\ntext $c=d$ and $e=f\n\ntext \\[ g=h \\] \\[ i=j\n\n$k=l$");
    let texts: Vec<String> = paper.printed.iter().map(|r| r.text()).collect();
    assert_eq!(texts, ["a=b", "c=d", "g=h", "i=j", "k=l"]);
    assert_eq!(paper.notes.len(), 3, "{:?}", paper.notes);
    assert_eq!(paper.line(&paper.notes[1].span), 3);
}

#[test]
fn files_that_a_paper_names_are_read_inside_of_its_folder_only() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    fs::create_dir_all(folder.path().join("paper/parts")).expect("made");
    write("secret.tex", r"\[ s=1 \]");
    write("paper/parts/one.tex", "Text.\n\\[ (a+b)^2+c=a^2-2ab+b^2+c \\] \\input{main}\\input{parts/one}");
    write("paper/parts/two.tex", "\\documentclass[../main]{subfiles}\n\\begin{document}\\[ t=2 \\]\\end{document}");
    write(
        "paper/main.tex",
        "\\begin{document}\\input{parts/one}\\input{../secret}\\subfile{parts/two}\\input{none}\\[ e=f \\]\\end{document}",
    );
    let run = rederive(folder.path(), &["lint", "paper/main.tex", "--format", "json"]).code(1);
    let text = String::from_utf8(run.get_output().stdout.clone()).expect("UTF-8");
    let found: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let relations = found["relations"].as_array().expect("a list");
    let formulas: Vec<&str> = relations.iter().filter_map(|r| r["formula"].as_str()).collect();
    assert_eq!(formulas, ["(a+b)^2+c=a^2-2ab+b^2+c", "t=2", "e=f"]);
    assert_eq!((relations[0]["file"].as_str(), relations[0]["line"].as_u64()), (Some("paper/parts/one.tex"), Some(2)));
    let notes = found["notes"].as_array().expect("a list");
    assert_eq!(notes.len(), 4, "{notes:?}");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../secret.tex", folder.path().join("paper/link.tex")).expect("a link");
        write("paper/other.tex", r"\input{link}\[ e=f \]");
        let run = rederive(folder.path(), &["lint", "paper/other.tex"]).code(0);
        run.stdout(predicate::str::contains("s=1").not().and(predicate::str::contains("note")));
    }
}

#[test]
fn hostile_sources_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |text: &str| {
        fs::write(folder.path().join("p.tex"), text).expect("written");
        rederive(folder.path(), &["lint", "p.tex"])
    };
    let left_out = || predicate::str::contains("does not end; its definition is left out");
    run(r"\def\a{\a}\a").code(0).stdout(left_out());
    run(r"\def\a{\b\b}\def\b{\a\a}\a").code(0).stdout(left_out());
    run(r"\let\a\b\DeclareMathOperator{\d}{\d}\[(a+b)^2=a^2+2ab+b^2\]\[\d x=1\]")
        .code(0)
        .stdout(left_out().and(predicate::str::contains("1 follows")));
    run(r"\newenvironment{e}{\begin{e}}{\end{e}}\begin{e}").code(0).stdout(left_out());
    run(&format!("\\[ {} \\]", "{".repeat(10_000))).code(0);
    run(&format!("\\[ a={}b \\]", "(".repeat(5_000))).code(0);
    run(&format!("\\[ a={} \\]", "\\frac{".repeat(5_000))).code(0);
    run(&format!("\\[ a=b{} \\]", "+c".repeat(40_000))).code(0).stdout(predicate::str::contains("1 relation"));
    let too_long = || predicate::str::contains("longer than 100000 signs");
    run(&format!("\\[ a=b{} \\]", "+c".repeat(100_000))).code(0).stdout(too_long());
    run(&format!("${}$ and $x=x$", "a".repeat(100_001))).code(0).stdout(too_long());
    run(&"\\[ a=b ".repeat(2_000)).code(0);
    run(&"\\[ a=\\int b \\]\n".repeat(20_000)).code(0).stdout(predicate::str::contains("20000 relations"));
    run("").code(0).stdout(predicate::str::contains("0 relations"));
    rederive(folder.path(), &["lint", "none.tex"]).code(2);
    rederive(folder.path(), &["none.tex"]).code(2);
}

#[test]
fn formats_tell_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(
        folder.path().join("p.md"),
        "# A\n\nText with `$code=1$` and 5 %.\n\n$$A=(a+b)^2+c=a^2-2ab+b^2+c$$\n\n```\n$x=y$\n```\n",
    )
    .expect("written");
    rederive(folder.path(), &["p.md", "--format", "github"]).code(1).stdout(
        predicate::str::starts_with("::error file=p.md,line=5,").and(predicate::str::contains("a^2+2ab+b^2+c")),
    );
    let run = rederive(folder.path(), &["p.md", "--format", "sarif"]).code(1);
    let log: serde_json::Value = serde_json::from_slice(&run.get_output().stdout).expect("JSON");
    let results = log["runs"][0]["results"].as_array().expect("results");
    assert_eq!(results.len(), 1);
    assert_eq!(results[0]["ruleId"], "lint::wrong");
    let run = rederive(folder.path(), &["p.md", "--format", "json"]).code(1);
    let found: serde_json::Value = serde_json::from_slice(&run.get_output().stdout).expect("JSON");
    assert_eq!(found["words"]["wrong"], 1);
    assert_eq!(found["relations"][0]["line"], 5);
    assert_eq!(found["relations"].as_array().map(Vec::len), Some(1));
}

#[test]
fn a_page_shows_the_wrong_step_beside_what_holds() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = r"\title{A <b>page</b>} \[ A=(a+b)^2+c=a^2-2ab+b^2+c \] \[ q=\int x \] <script>";
    fs::write(folder.path().join("p.tex"), text).expect("written");
    rederive(folder.path(), &["p.tex", "--html", "p.html"]).code(1);
    let page = fs::read_to_string(folder.path().join("p.html")).expect("the page");
    assert!(
        page.contains("As printed")
            && page.contains("✗ wrong: ")
            && page.contains("holds: ")
            && page.contains("<math>")
            && page.contains("<svg"),
        "{page}"
    );
    // The step is marked in its place, and what holds stands beside it.
    let formula = page.split_once("aria-label=\"formula of line").map_or("", |(_, rest)| rest);
    let formula = formula.split_once("</div>").map_or("", |(formula, _)| formula);
    let wrong = formula.split_once("<span class=\"step bad\">").map_or("", |(_, rest)| rest);
    assert!(!wrong.is_empty() && wrong.contains("<span class=\"instead\">holds: "), "{formula}");
    assert!(!page.contains("<script") && !page.contains("<b>page") && page.contains("default-src 'none'"), "{page}");
    assert!(page.contains("not read"), "{page}");
    let first = page.clone();
    rederive(folder.path(), &["p.tex", "--html", "p.html"]).code(1);
    assert_eq!(fs::read_to_string(folder.path().join("p.html")).expect("the page"), first);
    // The paper itself is not written over.
    rederive(folder.path(), &["p.tex", "--html", "p.tex"]).code(2);
    assert_eq!(fs::read_to_string(folder.path().join("p.tex")).expect("the paper"), text);
}

#[test]
fn a_configuration_says_what_is_looked_through() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    fs::create_dir_all(folder.path().join("text/deep")).expect("made");
    write("text/a.tex", r"\[ (a+b)^2=a^2+2ab+b^2 \]");
    write("b.tex", r"\[ h=a+b \]");
    let deep = folder.path().join("text/deep");
    rederive(&deep, &["lint"]).code(2).stderr(predicate::str::contains("rederive.toml"));
    write("rederive.toml", "sources = [\"text/a.tex\", \"b.tex\"]\nrigor = \"sampled\"\n");
    for place in [folder.path(), &deep] {
        rederive(place, &["lint"])
            .code(0)
            .stdout(predicate::str::contains("1 follows").and(predicate::str::contains("1 defines")));
    }
    let run = rederive(folder.path(), &["lint", "--format", "json"]).code(0);
    let found: serde_json::Value = serde_json::from_slice(&run.get_output().stdout).expect("JSON");
    assert_eq!(found.as_array().map(Vec::len), Some(2));
    // What the command line says wins.
    rederive(folder.path(), &["lint", "b.tex"]).code(0).stdout(predicate::str::contains("1 follows").not());
    for (text, wanted) in [
        ("sorces = []\n", "rederive.toml:1:1"),
        ("sources = 3\n", "rederive.toml:1:11"),
        ("sources = [\"../a.tex\"]\n", "stays in its folder"),
        ("sources = [\"/etc/passwd\"]\n", "stays in its folder"),
        ("sources = [\"a\"]\nrigor = \"much\"\n", "rederive.toml:2:9"),
        ("sources = [\n", "config::unreadable"),
    ] {
        write("rederive.toml", text);
        rederive(folder.path(), &["lint"]).code(2).stderr(predicate::str::contains(wanted));
        rederive(folder.path(), &["check"]).code(2).stderr(predicate::str::contains(wanted));
    }
    fs::remove_file(folder.path().join("rederive.toml")).expect("removed");
    write("pyproject.toml", "[project]\nname = \"x\"\n[tool.rederive]\nsources = \"b.tex\"\n");
    rederive(&deep, &["lint"]).code(0).stdout(predicate::str::contains("1 defines"));
}

#[test]
fn standard_input_and_a_paper_that_is_saved_again_are_looked_through() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder.path()).args(["lint", "-", "--format", "github"]);
    let run = command.write_stdin("\\[ A=(a+b)^2+c=a^2-2ab+b^2+c \\]").assert().code(1);
    run.stdout(predicate::str::contains("a^2+2ab+b^2+c"));
    fs::write(folder.path().join("p.tex"), r"\[ h=a+b \]").expect("written");
    let run = rederive(folder.path(), &["lint", "p.tex", "--watch", "--checks", "1"]).code(0);
    run.stdout(predicate::str::contains("1 defines"));
    rederive(folder.path(), &["lint", "-", "--watch"]).code(2);
}

/// A case keeps what stands beside it from being a premise; what "where" says, a range and a list of values do not.
#[test]
fn words_that_define_or_give_a_range_open_no_case() {
    use Word::NotFollowed;
    says(r"\[ E=T+V,\quad\text{where } V=kx^2 \] \[ E=T+kx^2 \]", &[Defines, Defines, Follows]);
    says(r"\[ E=T+V\quad\text{mit}\quad V=kx^2 \] \[ E=T+kx^2 \]", &[Defines, Defines, Follows]);
    says(r"\[ p=qx\quad\text{for } x>0 \] \[ p^2=q^2x^2 \]", &[Defines, Condition, Follows]);
    says(r"\[ p=qx\quad\text{for } n=1,2,\ldots \] \[ p^2=q^2x^2 \]", &[Defines, Condition, Follows]);
    says(r"\[ p= at\,x \] \[ p^2=a^2t^2x^2 \]", &[Defines, Follows]);
    says(r"\[ p = at\, x = q, \quad r=sx \] \[ r^2=s^2x^2 \]", &[NotFollowed, Defines, Follows]);
    says(r"\[ Q_\mathrm{in}=cT_\text{on} \] \[ Q_\mathrm{in}^2=c^2T_\text{on}^2 \]", &[Defines, Follows]);
    says(r"\[ p=qx \quad and \quad r=sx \] \[ p^2r^2=q^2s^2x^4 \]", &[Defines, Defines, Follows]);
    says(r"\[ p=qx \text{ and } r=sx \] \[ p^2r^2=q^2s^2x^4 \]", &[Defines, Defines, Follows]);
    says(r"\[ y=\mathrm{e}^{x} \] \[ y^2=\mathrm{e}^{2x} \]", &[Defines, Follows]);
    // The next row, and the next sentence, are no case.
    says(
        r"\begin{align} p&=qx &&\text{if } u=v\\ r&=sx \end{align} \[ r^2=s^2x^2 \]",
        &[Condition, Condition, Defines, Follows],
    );
    says(r"We have $u=v$ if $a=b$. Now \[ r=sx \] \[ r^2=s^2x^2 \]", &[Condition, Condition, Defines, Follows]);
}

/// A label of the defined name is no index of its formula; a long side may be simplified to a power; of numbers alone nothing vanishes.
#[test]
fn slips_beside_labels_powers_and_zeros_are_told() {
    for (tex, wanted) in [
        (r"\[ c_p=\frac{aq+b/q}{q}=a+\frac{b}{q^3} \]", r"a+\frac{b}{q^2}"),
        (r"\[ g=(-r\sin\theta)^2+(r\cos\theta)^2=r^3 \]", "r^2"),
        (r"It is $K=4.96+2.3=2.66$ eV.", "4.96-2.3 = 2.66"),
        (r"\[ F=0+\frac32+\frac{\sqrt2}{2}=\frac42+\frac{\sqrt2}{2} \]", r"\frac{3}{2}+\frac{\sqrt{2}}{2}"),
    ] {
        assert_eq!(instead(tex).as_deref(), Some(wanted), "{:?}", words(tex));
    }
}

/// A sign of a difference and the name behind it are one name, where the sign is nothing else in the paper.
#[test]
fn a_difference_is_a_name() {
    says(r"\[ \Delta x=v\Delta t \] \[ \frac{\Delta x}{\Delta t}=v \]", &[Defines, Follows]);
    says(r"\[ (x+\Delta x)^2-x^2=2x\,\Delta x+(\Delta x)^2 \]", &[Follows]);
    says(r"\[ (x+\Delta x)^2-x^2=2x\,\Delta x+\Delta x^2 \]", &[NotRead]);
    says(r"\[ \Delta\vec v=\vec a\Delta t \] \[ \Delta\vec v/\Delta t=\vec a \]", &[Defines, Follows]);
    says(r"\[ \Delta x_1=x_2-x_1 \] \[ x_1+\Delta x_1=x_2 \]", &[Defines, Follows]);
    says(r"\[ \delta E=T\,\delta S \] \[ (\delta E)^2=T^2(\delta S)^2 \]", &[Defines, Follows]);
    says(
        r"\[ \Delta x=v\Delta t \] The discriminant is $\Delta$. \[ \frac{\Delta x}{\Delta t}=v \]",
        &[NotRead, NotRead],
    );
    says(
        r"\[ F\Delta t=\Delta(mv) \] \[ \Delta x=v\Delta t \] \[ \frac{\Delta x}{\Delta t}=v \]",
        &[NotRead, Defines, Follows],
    );
    let slip = r"\[ \Delta x=v\Delta t \] Hence \[ W=F\Delta x=Fv(\Delta t)^2 \]";
    assert_eq!(instead(slip).as_deref(), Some(r"Fv\cdot (\Delta t)"), "{:?}", words(slip));
}

/// What a text says of another case, denies, asks or means by its notation: see `tests/lint/never.txt`.
#[test]
fn what_may_be_meant_otherwise_is_neither_proved_nor_wrong() {
    let mut found = Vec::new();
    for line in include_str!("lint/never.txt").lines().filter(|l| !l.is_empty() && !l.starts_with('#')) {
        let [word, which, text] = line.splitn(3, '|').collect::<Vec<_>>()[..] else { panic!("three fields: {line}") };
        let all = words(&format!("\\usepackage{{physics}}\\begin{{document}}\n{text}\n\\end{{document}}"));
        let told = |w: &Word| w.text() == word;
        let is_told = match which {
            "last" => all.last().is_some_and(|(w, _)| told(w)),
            "any" => all.iter().any(|(w, _)| told(w)),
            other => panic!("any or last, not {other}"),
        };
        assert!(!all.is_empty(), "nothing is read of {text}");
        if is_told {
            found.push(format!("{word}: {text}: {all:?}"));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Steps that hold, or fail, in each base that `\log` may have; what depends on the base is not read.
#[test]
fn the_base_of_a_logarithm_need_not_be_known() {
    says(r"\[\log(a^2b)=2\log a+\log b\]", &[Follows]);
    says(r"Hence \[\log(a^3)=2\log a\]", &[Wrong]);
    assert_eq!(instead(r"Hence \[\log(a^3)=2\log a\]").as_deref(), Some(r"3\log a"));
    for depends in [r"\[\log 100=2\]", r"\[\log e^x=x\]", r"Hence \[\frac{d}{dx}\log x=\frac1x\]"] {
        says(depends, &[NotRead]);
    }
}

/// What has a formula is not defined again by an equation of motion.
#[test]
fn an_equation_of_motion_that_a_formula_denies_differs() {
    let of = |says: &str| format!(r"The position is $x=A\cos\omega t$ and the acceleration \[{says}\]");
    says(&of(r"\ddot x=\omega^2x"), &[Defines, Differs]);
    says(&of(r"\ddot x=-\omega^2x"), &[Defines, Follows]);
    // Another motion, of which nothing but the name is the same.
    says(&of(r"\ddot x=\frac{k}{m}x^3"), &[Defines, Defines]);
}

/// What is divided by, and what a quotient is called, need not stand in a conclusion.
#[test]
fn a_conclusion_may_divide_and_eliminate() {
    says(r"We have \[ma=mb+mc.\] Hence \[a=b+c.\]", &[Condition, Follows]);
    says(r"We have \[ma=mb+mc.\] Hence \[a=b-c.\]", &[Condition, Wrong]);
    says(r"We have \[mgh=\frac12mv^2.\] This gives \[v^2=gh.\]", &[Condition, Wrong]);
    says(
        r"The law is \[m\ddot x=-kx.\] With \[\omega^2=\frac km\] we get \[\ddot x=-\omega^2x.\]",
        &[Condition, Condition, Follows],
    );
    says(
        r"The law is \[m\ddot x=-kx.\] With \[\omega^2=\frac km\] we get \[\ddot x=\omega^2x.\]",
        &[Condition, Condition, Wrong],
    );
    // Nothing may be divided by what is 0, or negative where that is said, or may vanish.
    for none in [
        r"With \[x=0\] we have \[xa=xb.\] Hence \[a=b.\]",
        r"We have \[(x-1)a=(x-1)b\] and \[y=c.\] Hence \[a=b.\]",
        r"We have \[a\sin x=b\sin x\] and \[y=c.\] Hence \[a=b.\]",
    ] {
        assert!(words(none).last().is_some_and(|(w, _)| !matches!(w, Follows | Wrong)), "{none}: {:?}", words(none));
    }
    assert_eq!(why(r"We have \[ma=mb+mc.\] Hence \[a=b+c.\]"), "where m is positive");
}

/// What an equation is solved for follows from it.
#[test]
fn what_is_solved_for_is_reckoned() {
    let of = |says: &str, what: &str| format!(r"We have \[\frac1f=\frac1u+\frac1v.\] {says} \[{what}.\]");
    for words in ["Solving for $f$,", "We solve for $f$:", "Solving, we get", "Solving this for $f$ gives"] {
        says(&of(words, r"f=\frac{uv}{u+v}"), &[Condition, Follows]);
        says(&of(words, r"f=\frac{uv}{u-v}"), &[Condition, Wrong]);
    }
    let period = r"From \[T=2\pi\sqrt{\frac lg}\] we get \[g=\frac{4\pi l}{T^2}.\]";
    assert_eq!(instead(period).as_deref(), Some(r"\frac{4\pi^2l}{T^2}"));
}

/// Letters beside the variable are constants, of which that is told, unless the paper shows otherwise.
#[test]
fn letters_beside_the_variable_are_held_fixed() {
    let chain = r"\[\frac{d}{dx}\sin(ax^2)=2ax\cos(ax^2)\]";
    says(chain, &[Follows]);
    assert_eq!(why(chain), "where nothing but the variable varies");
    says(r"\[\frac{\partial}{\partial x}e^{ax}=ae^{ax}\]", &[Follows]);
    says(r"Let $y=2x$. \[\frac{d}{dx}(xy)=4x\]", &[Defines, Follows]);
    for varies in [
        r"Let $y=2x$. \[\frac{d}{dx}(xy)=y\]",
        r"We have \[y'=y\] and \[\frac{d}{dx}(xy)=y\]",
        r"The function $y(x)$ has \[\frac{d}{dx}(xy)=y\]",
        r"With \[\frac{\partial p}{\partial T}=a\] we have \[\frac{\partial}{\partial V}(pV)=p\]",
    ] {
        assert!(words(varies).last().is_some_and(|(w, _)| *w != Follows), "{varies}: {:?}", words(varies));
    }
}

/// Derivatives of exponentials and quotients, powers of functions, and derivatives side by side.
#[test]
fn slips_in_derivatives_and_identities_are_told() {
    for wrong in [
        r"Hence \[\frac{d}{dx}e^{-x^2}=2xe^{-x^2}.\]",
        r"The derivative is \[\frac{d}{dx}\frac{x}{1+x^2}=\frac{1+x^2-2x}{(1+x^2)^2}.\]",
        r"Hence \[\sin^2x=\frac{1+\cos2x}{2}.\]",
        r"Completing the square, \[x^2+bx=\left(x+\frac b2\right)^2+\frac{b^2}{4}.\]",
        r"Let \[H=\frac{p^2}{2m}+\frac k2x^2.\] Then \[\dot x=\frac{\partial H}{\partial p}=\frac pm,\quad\dot p=-\frac{\partial H}{\partial x}=kx.\]",
        r"Let \[H=\frac{p^2}{2m}+\frac k2x^2.\] Then \[\frac{\partial H}{\partial p}=\frac pm.\] Then \[\frac{\partial H}{\partial x}=2kx.\]",
    ] {
        assert!(words(wrong).last().is_some_and(|(w, _)| *w == Wrong), "{wrong}: {:?}", words(wrong));
    }
}

/// The square of a name is a premise like another one; what was one name for another in a chain, and a lost square below a line, are told.
#[test]
fn what_gives_the_square_of_a_name_is_used() {
    let lorentz = |says: &str| {
        format!(
            r"\begin{{document}}Let $X=\gamma(x-vt)$ and $T=\gamma(t-vx/c^2)$, where \[\gamma^2=\frac{{1}}{{1-v^2/c^2}}.\] Then \[{says}\]\end{{document}}"
        )
    };
    let last = |text: &str| words(text).pop().map(|(word, _)| word);
    assert_eq!(last(&lorentz("c^2T^2-X^2=c^2t^2-x^2.")), Some(Word::Follows));
    assert_eq!(last(&lorentz("c^2T^2-X^2=c^2t^2+x^2.")), Some(Word::Wrong));
    let divider = r"\begin{document}The current is $I=\frac{V}{R_1+R_2}$. The power is \[P=I^2R_2=\frac{V^2R_2}{R_1+R_2}.\]\end{document}";
    assert_eq!(last(divider), Some(Word::Wrong));
    assert!(instead(divider).is_some_and(|i| i.contains("^2")), "{:?}", instead(divider));
}

/// A prime behind a name that one letter defines, and a dot behind one that the time does, derive; the key of a rate has its index; an arrow in a
/// display concludes from the equations beside it.
#[test]
fn derivatives_of_what_is_defined_are_reckoned() {
    says("Let $y=x^3$. Then $y'=3x^2$.", &[Defines, Follows]);
    says("Let $y=x^3$. Then $y'=3x^3$.", &[Defines, Wrong]);
    says(r"\[ w=\sin x \] and \[ w'=-\cos x \]", &[Defines, Wrong]);
    says(r"\[ y=t^3 \] then \[ \dot y=3t^2 \]", &[Defines, Follows]);
    says(r"\[ y=t^3 \] then \[ \dot y=3t^3 \]", &[Defines, Wrong]);
    // Beside a letter with a prime, or a second one, it may be another name.
    says("Let $y=x^3$ and $x'=2x$. Then $y'=3x^3$.", &[Defines, Defines, Defines]);
    says("Let $y=ax^3$. Then $y'=3x^3$.", &[Defines, Defines]);
    says(
        r"\[ L=\frac12m\dot{x}_1^2+\frac12M\dot x_2^2 \] Then \[ \frac{\partial L}{\partial\dot{x}_1}=2m\dot x_1 \] and \[ \frac{\partial L}{\partial\dot x_2}=M\dot x_2 \]",
        &[Defines, Wrong, Follows],
    );
    let spring = r"\begin{gather} m\ddot y=-ky-mg \\ Y=y+mg/k \\ \ddot Y=\ddot y \Longrightarrow \ddot Y=\frac km Y \end{gather}";
    says(spring, &[Condition, Defines, Follows, Wrong]);
}

/// What an arrow, or a word, solves for a name of the equation before it follows from that; what differs from what was said before is told by its
/// word, also where other definitions stand between.
#[test]
fn what_is_solved_for_and_what_differs_is_told() {
    says(r"\[ F=ma \implies a=Fm \]", &[Defines, Wrong]);
    says(r"$F=ma \implies a=Fm$", &[Defines, Wrong]);
    says(r"\[ F=ma \] Hence \[ a=\frac Fm \]", &[Defines, Follows]);
    assert_eq!(instead(r"\[ F=ma \implies a=Fm \]").as_deref(), Some(r"\frac{F}{m}"));
    // A sign, or a matrix, may be its own inverse; without a word or an arrow it is another definition.
    for tex in [r"\[ u=sv \implies v=su \]", r"\[ b=Ax \implies x=Ab \]", r"\[ y_k=\mu(k)c \implies c=\mu(k)y_k \]"] {
        assert!(words(tex).iter().all(|w| w.0 != Wrong), "{tex}");
    }
    says(r"\[ F=ma \] \[ a=Fm \]", &[Defines, Defines]);
    says(r"\[ T=\frac12mv^2, \quad v=gt \] \[ T=mg^2t^2 \]", &[Defines, Defines, Differs]);
    says(r"\[ T=\frac12mv^2, \quad v=gt \] Now \[ T=mg^2t^2 \]", &[Defines, Defines, Defines]);
}

/// The page has a link to every wrong formula, with the formula, and a button for each word.
#[test]
fn the_page_shows_the_formulas_of_one_word() {
    let paper = read(r"\[ E=mc^2 \] \[ A=(a+b)^2+c=a^2-2ab+b^2+c \]");
    let page = rederive::report::lint_page(&paper, &lint::lint(&paper, &Limits::default()));
    assert!(page.contains(r##"<a href="#f1">line 1</a><div class="formula""##), "{page}");
    assert!(page.contains(r#"id="wrong""#) && page.contains(r#"data-word="defines""#), "{page}");
    assert!(page.contains("body:has(#defines:checked) .relation:not([data-word=defines]){display:none}"), "{page}");
    assert!(!page.contains("<script"), "{page}");
}

/// What holds no formula, no text, or an environment that is not known is said.
#[test]
fn what_is_not_read_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let lint = |name: &str, bytes: &[u8]| {
        fs::write(folder.path().join(name), bytes).expect("written");
        rederive(folder.path(), &["lint", name])
    };
    lint("empty.tex", b"").code(0).stdout(predicate::str::contains("this file is empty"));
    lint("words.tex", b"words").code(0).stdout(predicate::str::contains("no formula that relates something"));
    lint("zero.tex", b"$a=b$\0").code(2).stderr(predicate::str::contains("bytes that are 0"));
    lint("wide.tex", &[0xff, 0xfe, b'$', 0]).code(2).stderr(predicate::str::contains("UTF-16"));
    lint("paper.tex", b"%PDF-1.5").code(2).stderr(predicate::str::contains("a PDF"));
    let unknown = br"\begin{IEEEeqnarray}{rCl} a&=&b+c \end{IEEEeqnarray} \begin{foo} \frac12a=b \end{foo}";
    let run = lint("unknown.tex", unknown).code(0);
    run.stdout(predicate::str::contains("defines          a=b+c").and(predicate::str::contains("environment `foo`")));
    lint("alone.tex", br"\[ \text{Here } \quad \]").stdout(predicate::str::contains("relates nothing").not());
    rederive(folder.path(), &["."]).code(2).stderr(predicate::str::contains("rederive lint"));
    rederive(folder.path(), &["alone.tex.txt"]).code(2).stderr(predicate::str::contains("unrecognized"));
    fs::write(folder.path().join("plain.txt"), "words").expect("written");
    rederive(folder.path(), &["plain.txt"]).code(2).stderr(predicate::str::contains("rederive lint plain.txt"));
}

/// Of numbers alone nothing is a condition, but for what may be rounded; a word between two formulas of a text concludes as an arrow does.
#[test]
fn numbers_and_solutions_of_the_text_are_reckoned() {
    says("We have $0.1+0.2=0.4$.", &[Wrong]);
    says(r"We have $\frac12+\frac13=\frac25$.", &[Wrong]);
    assert_eq!(instead(r"We have $\frac12+\frac13=\frac25$.").as_deref(), Some(r"\frac{5}{6}"));
    says("We have $2.5+1.3=4$ and $1/3+1/3=0.66$ and $0.33+0.33+0.33=1.0$.", &[Condition; 3]);
    says("Here $3x+6=0$ so $x=2$.", &[Condition, Wrong]);
    says("Here $3x+6=0$ so $x=-2$. And $3x+6=0$ or $x=2$.", &[Condition; 4]);
}

/// Beside decimals that are reckoned wrongly stands their value.
#[test]
fn a_wrong_sum_of_decimals_has_its_value_beside_it() {
    assert_eq!(instead(r"\[ 0.1+0.2=0.4 \]").as_deref(), Some("0.3"));
    assert_eq!(instead(r"\[ K=4.96+2.3=2.66 \]").as_deref(), Some("4.96-2.3 = 2.66"));
}

/// An equation that moves a name is another one than that which its formula solves, unless the sentence concludes; what unknown functions vary by is
/// no number that could be reckoned.
#[test]
fn another_equation_of_motion_and_unknown_functions_are_not_wrong() {
    let next = r"\[ \frac{dy}{dx}=ky \] solved by \[ y=Ce^{kx} \] Next, we have \[ \frac{dy}{dx}=-ky \] solved by other functions.";
    assert!(words(next).iter().all(|w| w.0 != Wrong), "{:?}", words(next));
    says(r"\[ y=e^{kx} \] Hence \[ \frac{dy}{dx}=ky \]", &[Defines, Follows]);
    says(r"\[ y=e^{kx} \] Hence \[ \frac{dy}{dx}=-ky \]", &[Defines, Wrong]);
    let unknown = r"$x'=y+(x^2+y^2-1)x$, $y'=-x+(x^2+y^2-1)y$ is solved by $x=\cos(t)$, $y=\sin(t)$. Furthermore,
        \[ \frac{\partial f}{\partial x}+\frac{\partial g}{\partial y}=4x^2+4y^2-2 \] where $x'=f(x,y)$.";
    assert!(words(unknown).iter().all(|w| w.0 != Wrong), "{:?}", words(unknown));
}

/// A chapter is read with the definitions of the file that includes it, and of the packages beside that.
#[test]
fn a_chapter_has_the_macros_of_its_paper() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("parts")).expect("made");
    let main = r"\documentclass{own}\usepackage{amsmath,own}\newcommand{\half}{\frac12}\begin{document}\input{parts/one}\end{document}";
    fs::write(at("main.tex"), main).expect("written");
    // Of a package only what prints counts: neither its frame nor its formulas.
    let package = r"\def\over@all{x}\newcommand{\square}[1]{{#1}^2}\renewcommand{\section}[1]{}\def\at(#1,#2){#1_{#2}} \[ 1=2 \]
        \newcommand{\sum}{\if@x 1\else 2\fi}";
    fs::write(at("own.sty"), package).expect("written");
    fs::write(at("own.cls"), r"\newcommand{\mass}{m}").expect("written");
    let chapter = r"\section{One} \[ A=\square{(a+b)}+\mass=a^2-2ab+b^2+m \] \[ B=\half\at(c,d) \]";
    fs::write(at("parts/one.tex"), chapter).expect("written");
    for (place, file) in [(folder.path().join("parts"), "one.tex"), (folder.path().to_path_buf(), "main.tex")] {
        let run = rederive(&place, &["lint", file]).code(1);
        let told = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
        assert!(told.contains(r"A={(a+b)}^2+m=") && told.contains(r"B=\frac12c_{d}"), "{told}");
        assert!(told.contains("wrong") && !told.contains("1=2"), "{told}");
    }
    // A copy of a package whose commands have a meaning here changes none, nor does one in the language of LaTeX3.
    fs::write(at("physics.sty"), r"\newcommand{\qty}[1]{0}").expect("written");
    fs::write(at("new.sty"), r"\ExplSyntaxOn\newcommand{\frac}[2]{0}").expect("written");
    let paper = r"\documentclass{article}\usepackage{physics,new}\begin{document}\[ x=\qty(\frac ab) \]\end{document}";
    fs::write(at("paper.tex"), paper).expect("written");
    let run = rederive(folder.path(), &["lint", "paper.tex"]).code(0);
    assert!(String::from_utf8_lossy(&run.get_output().stdout).contains(r"\frac ab"), "the copies are not read");
}

/// The words of the steps of a chain, and where its slip is told.
fn steps(tex: &str) -> (Vec<Word>, Option<String>) {
    let paper = read(tex);
    let found = lint::lint(&paper, &Limits::default());
    let judgement = found.judgements.first().expect("a relation");
    let place = (judgement.word == Word::Wrong).then(|| paper.file.text[judgement.span.clone()].to_owned());
    (judgement.chain.iter().map(|s| s.word).collect(), place)
}

#[test]
fn every_step_of_a_chain_has_its_word() {
    // A slip that is carried on is told once, and one that is taken back, too.
    let (words, place) = steps(r"\[ (a+b)^2 = a^2+2ab+b^2 = a^2+3ab+b^2 = b^2+3ab+a^2 \]");
    assert_eq!(words, [Word::Follows, Word::Wrong, Word::Follows]);
    assert_eq!(place.as_deref(), Some("a^2+3ab+b^2"));
    let (words, _) = steps(r"\[ (a+b)^2 = a^2+2ab+b^2 = a^2+3ab+b^2 = b^2+2ab+a^2 = (b+a)^2 \]");
    assert_eq!(words, [Word::Follows, Word::Wrong, Word::Follows, Word::Follows]);
    // What is not decided, or not read, hides no step behind it.
    let (words, _) = steps(r"\[ q^2+w = (a+b)^2 = a^2+2ab+b^2 = \sum_k c_k = k^2 \]");
    assert_eq!(words, [Word::NotFollowed, Word::Follows, Word::NotRead, Word::NotRead]);
    let (words, _) = steps(r"\[ E = (a+b)^2 = a^2+2ab+b^2 \approx a^2 \]");
    assert_eq!(words, [Word::Defines, Word::Follows, Word::Approximates]);
    // The list has a line for each.
    let paper = read("\\begin{align} q^2+w &= (a+b)^2 \\\\\n &= a^2+2ab+b^2 \\\\\n &= a^2+3ab+b^2 \\end{align}");
    let text = lint::lint_text(&paper, &lint::lint(&paper, &Limits::default()));
    for line in [
        "     1    not followed   = (a+b)^2",
        "     2    follows        = a^2+2ab+b^2",
        "     3    wrong          = a^2+3ab+b^2",
    ] {
        assert!(text.contains(line), "{text}");
    }
    let document = rederive::report::lint_document(&paper, &lint::lint(&paper, &Limits::default()));
    let words: Vec<&str> = document["relations"][0]["chain"]
        .as_array()
        .expect("steps")
        .iter()
        .filter_map(|s| s["word"].as_str())
        .collect();
    assert_eq!(words, ["not followed", "follows", "wrong"]);
}

#[test]
fn a_slip_is_told_at_the_side_that_was_altered() {
    // The later side has a slip that the next one goes on with, or takes back.
    for rest in ["b^2+3ab+a^2", "b^2+2ab+a^2"] {
        let (words, place) = steps(&format!(r"\[ (a+b)^2 = a^2+3ab+b^2 = {rest} \]"));
        assert_eq!(words, [Word::Wrong, Word::Follows]);
        assert_eq!(place.as_deref(), Some("a^2+3ab+b^2"));
    }
    // No slip of the later side is known, which is proved to go on: it is the earlier one.
    let (words, place) = steps(r"\[ a^3-3a^2b+3ab^2+b^3 = (a-b)^3 = a^3-3a^2b+3ab^2-b^3 \]");
    assert_eq!(words, [Word::Wrong, Word::Follows]);
    assert_eq!(place.as_deref(), Some("a^3-3a^2b+3ab^2+b^3"));
}

/// What `\log` is, an editor takes from the nearest configuration of a paper, as the command line does.
#[test]
fn an_editor_knows_what_the_configuration_says() {
    use rederive::check::Cancel;
    use rederive::look::Looker;
    let folder = tempfile::tempdir().expect("a folder");
    let deep = folder.path().join("text");
    fs::create_dir_all(&deep).expect("made");
    let looked = |config: &str| {
        fs::write(folder.path().join("rederive.toml"), config).expect("written");
        let (mut words, mut said) = (Vec::new(), Vec::new());
        let text = r"\[ \log 100 = 2 \]".to_owned();
        Looker::default().look(&deep.join("a.tex"), text, &Cancel::default(), &mut |looked| {
            words.extend(looked.remarks.iter().map(|r| r.word.clone()));
            said.extend(looked.findings.iter().map(|f| f.message.clone()));
        });
        (words.join(" "), said.join(" "))
    };
    assert_eq!(looked("").0, "not read");
    assert_eq!(looked("log = \"decimal\"\n").0, "follows");
    assert_ne!(looked("log = \"natural\"\n").0, "follows");
    // What is no configuration is told, and the paper is looked through without it.
    let (words, said) = looked("log = \"binary\"\n");
    assert!(words == "not read" && said.contains("the configuration is not read"), "{words}: {said}");
}
