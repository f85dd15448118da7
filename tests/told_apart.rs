//! What is printed otherwise is not the same: commas below a name, spaces in a label, braces, spaces between formulas, what Markdown does not
//! print; and a partial derivative by the time is not the total one.

use std::fs;

use assert_cmd::Command;
use predicates::prelude::*;
use rederive::check::{Limits, Proposition};
use rederive::diag::Source;
use rederive::lint::{self, Word};
use rederive::paper;
use rederive::{Question, Session};

/// The word on each relation of a paper, what it relates, and why.
fn judged(path: &str, text: &str) -> Vec<(Word, String, String)> {
    let source = Source { path: path.into(), text: text.into() };
    let paper = paper::parse(source, String::new()).unwrap_or_else(|d| panic!("{d}"));
    let found = lint::lint(&paper, &Limits::default()).judgements;
    found.into_iter().map(|j| (j.word, paper.printed[j.relation].text(), j.why)).collect()
}

fn tex(text: &str) -> Vec<(Word, String, String)> {
    judged("p.tex", text)
}

#[track_caller]
fn says(text: &str, wanted: &[Word]) {
    let found = tex(text);
    assert_eq!(found.iter().map(|w| w.0).collect::<Vec<_>>(), wanted, "{found:?}");
}

/// Whether a formula is proved of these symbols; or what is wrong with it.
fn proves(formula: &str, symbols: &[&str]) -> Result<bool, String> {
    let question = Question {
        proposition: Proposition { formula: formula.to_owned(), ..Default::default() },
        symbols: symbols.iter().map(|s| (*s).to_owned()).collect(),
        scope: None,
    };
    let answer = Session::blank().prove(&question).map_err(|failure| failure.to_string())?;
    Ok(answer.standing() == "proved")
}

#[test]
fn a_comma_tells_labels_apart() {
    for (formula, symbols) in [
        ("A_{1,12}=A_{11,2}", &["A_{1,12}", "A_{11,2}"][..]),
        ("u_{x,y}=u_{xy}", &["u_{x,y}", "u_{xy}"]),
        ("x_{a,bc}=x_{ab,c}", &["x_{a,bc}", "x_{ab,c}"]),
        (r"x_{\text{a b}}=x_{\text{ab}}", &[r"x_{\text{a b}}", r"x_{\text{ab}}"]),
        (r"x^{\text{a b}}=x^{\text{ab}}", &[r"x^{\text{a b}}", r"x^{\text{ab}}"]),
    ] {
        assert_eq!(proves(formula, symbols), Ok(false), "{formula}");
        let (left, _) = formula.split_once('=').expect("an equation");
        assert_eq!(proves(&format!("{left}+1=1+{left}"), symbols), Ok(true), "{left}");
    }
    for formula in ["A_{1,12}=A_{11,2}", "A_{1,12}=A_{112}", "A_{112}=A_{1,12}"] {
        let why = proves(formula, &["A_{112}"]).expect_err(formula);
        assert!(why.contains("is not declared with this subscript") && why.contains("as it is written"), "{why}");
    }
    // Other spaces would be lost.
    for label in [r"1\,12", r"11\;2", "1~2", r"1\ 2", r"\rm in~a", r"\rm a\,bc", r"a\quad b"] {
        let why = proves(&format!("A_{{{label}}}=A_{{{label}}}"), &["A_{112}"]).expect_err(label);
        assert!(why.contains("a space within a subscript"), "{label}: {why}");
    }
    // One space, or none around the word, prints the same; letters of mathematics have no spaces.
    assert_eq!(proves(r"x_{\text{ a  b }}=x_{\text{a b}}", &[r"x_{\text{a b}}"]), Ok(true));
    assert_eq!(proves(r"x_{\mathrm{a b}}=x_{\mathrm{ab}}", &[r"x_{\rm ab}"]), Ok(true));
}

#[test]
fn components_have_commas_or_none() {
    let all: &[(&str, &[&str])] = &[
        ("R_{1,2}=R_{12}", &["R: 3x3"]),
        (r"R_{i,j}R_{k,j}=R_{ij}R_{kj}", &["R: 3x3"]),
        (r"(RR)_{1,2}=R_{1,i}R_{i2}", &["R: 3x3"]),
        (r"\delta_{i,j}R_{jk}=R_{i,k}", &["R: 3x3"]),
        (r"\epsilon_{1,2,3}=1", &["x"]),
        ("r_{f,1}=r_{f1}", &["r_f: 3"]),
    ];
    for (formula, symbols) in all {
        assert_eq!(proves(formula, symbols), Ok(true), "{formula}");
    }
    // Between which two indices a comma stands that stands between some of them is not known.
    let why = proves("A_{1,12}=A_{11,2}", &["A: 3x3x3"]).expect_err("no components");
    assert!(why.contains("is not an index"), "{why}");
    let why = proves("R_{1,2}=0", &["R: 3x3", "R_{1,2}"]).expect_err("two meanings");
    assert!(why.contains("would also be a component"), "{why}");
}

#[test]
fn papers_with_commas_below_names() {
    for text in ["x_{1,12}=x_{11,2}", "u_{x,y}=u_{xy}", "x_{a,bc}=x_{ab,c}", r"x_{\text{a b}}=x_{\text{ab}}"] {
        let (one, other) = text.split_once('=').expect("an equation");
        let square = format!(r"({one}+1)^2={other}^2+2{other}+1");
        let found = tex(&format!(r"\[ {square} \] \[ y={one} \] Hence \[ y^2={other}^2 \]"));
        assert!(found.iter().all(|(word, ..)| !matches!(word, Word::Follows | Word::Wrong)), "{found:?}");
    }
    for name in ["x_{1,12}", "u_{x, y}", r"x_{\text{a b}}", r"T_{\textrm{max out},i}"] {
        says(&format!(r"\[ ({name}+1)^2={name}^2+2{name}+1 \]"), &[Word::Follows]);
        says(&format!(r"\newcommand{{\own}}{{{name}}} \[ (\own+1)^2={name}^2+2\own+1 \]"), &[Word::Follows]);
    }
}

#[test]
fn as_before_is_what_prints_the_same() {
    let again = |one: &str, two: &str| {
        let found = tex(&format!(r"\[ f={one} \] Hence \[ f={two} \]"));
        assert_eq!(found.len(), 2, "{found:?}");
        assert_eq!(found[1].0, Word::Defines, "{found:?}");
        found[1].2.clone()
    };
    for (one, two) in [
        (r"\frac{1}{2x}", r"\frac{1}{2}x"),
        (r"\frac{1}{x+y}", r"\frac{1}{x}+y"),
        ("e^{x+y}", "e^{x}+y"),
        ("x^{2a}", "x^2a"),
        (r"\sqrt{x+y}", r"\sqrt{x}+y"),
        (r"\frac{12}{x}", r"\frac{1}{2x}"),
        (r"y_{\text{a b}}+1", r"y_{\text{ab}}+1"),
    ] {
        assert_eq!(again(one, two), "otherwise than before", "{one} and {two}");
    }
    for (one, two) in [
        (r"\frac{1}{2}x", r"\frac12 x"),
        ("e^{x}+{y}", "e^x+y"),
        (r"\dfrac{x}{2}", r"\frac{x}{2}"),
        (r"\left(x+1\right)^{2}", "(x+1)^2"),
        ("{xy}z", r"x\,y z"),
    ] {
        assert_eq!(again(one, two), "as before", "{one} and {two}");
    }
}

#[test]
fn a_partial_derivative_by_the_time_is_of_what_stands_there() {
    use Word::{Condition, Defines, Follows, NotRead, Wrong};
    let moved = r"\[ f=xt \] with \[ x=vt \] Hence ";
    says(
        &format!(r"{moved}\[ \frac{{\partial f}}{{\partial t}}=x \] \[ \frac{{df}}{{dt}}=x+vt \]"),
        &[Defines, Defines, Follows, Follows],
    );
    says(&format!(r"{moved}\[ \partial_tf=x \]"), &[Defines, Defines, Follows]);
    says(&format!(r"{moved}\[ \partial_tf=2x \]"), &[Defines, Defines, Condition]);
    says(&format!(r"{moved}\[ \frac{{\partial f}}{{\partial t}}=\frac{{df}}{{dt}} \]"), &[Defines, Defines, NotRead]);
    // Through a name for the derivative, in an equation, and of a formula in parentheses; by another variable, too.
    says(
        r"\[ f=xt \] with \[ x=vt \] and \[ g=\frac{\partial f}{\partial t} \] Hence \[ g=x \]",
        &[Defines, Defines, Defines, Follows],
    );
    for (variable, text) in [
        ("t", r"and \[ g=\frac{\partial f}{\partial T} \] Hence \[ g=2x \]"),
        ("y", r"and \[ g=\frac{\partial f}{\partial T} \] Hence \[ g=2x \]"),
        ("t", r"Hence \[ g+h=\frac{\partial f}{\partial T} \] hence \[ g+h=2x \]"),
        ("t", r"Hence \[ \frac{\partial(xT)}{\partial T}=2x \]"),
    ] {
        let text = format!(r"\[ f=xT \] with \[ x=vT \] {text}").replace('T', variable);
        let (word, ..) = tex(&text).pop().expect("a relation");
        assert!(!matches!(word, Follows | Wrong), "{text}: {word:?}");
    }
    // What moves in the formula, and in no formula.
    let energy = r"\[ H=\frac{p^2}{2m}+\frac{kx^2}{2} \] ";
    let is = r"\[ \frac{dH}{dt}=\frac{\partial H}{\partial t} \]";
    for text in [
        r"\[ f=x^2t \] Then $\dot x=v$ and \[ \frac{df}{dt}=\frac{\partial f}{\partial t} \]".to_owned(),
        format!(r"{energy} Then $\dot x=\frac pm$ and {is}"),
        format!(r"{energy} Then $\dot x=\frac pm$, $\dot p=-kx$ and {is}"),
        r"Hence \[ \frac{df}{dt}=\frac{\partial f}{\partial t} \]".to_owned(),
        r"Since $\dot f=g$ and $\partial_tf=h$, we have \[ g=h \]".to_owned(),
    ] {
        let (word, ..) = tex(&text).pop().expect("a relation");
        assert!(!matches!(word, Follows | Wrong), "{text}: {word:?}");
    }
    // Everything that is derived stands there.
    says(r"\[ f=x^2t \] Hence \[ \frac{\partial f}{\partial t}=x^2 \]", &[Defines, Follows]);
    says(r"\[ f=x^2t \] Hence \[ \frac{\partial f}{\partial t}=2x^2 \]", &[Defines, Wrong]);
    says(
        r"\[ u=\sin(x-ct) \] Hence \[ \frac{\partial^2 u}{\partial t^2}=c^2\frac{\partial^2 u}{\partial x^2} \]",
        &[Defines, Follows],
    );
    says(
        r"\[ u=\sin\xi \] with \[ \xi=x-ct \] Hence \[ \frac{\partial u}{\partial t}=-c\cos\xi \]",
        &[Defines, Defines, Follows],
    );
}

#[test]
fn a_wide_space_parts_two_formulas() {
    for space in [
        r"\hskip1cm ",
        r"\hskip 1cm plus 1fil minus 2pt ",
        r"\kern1cm ",
        r"\mskip36mu ",
        r"\break ",
        r"\par ",
        r"\newline ",
        r"\hspace{1cm}",
        r"\hfil ",
        r"\linebreak ",
    ] {
        let found = tex(&format!(r"\[ u=x^2{space}v=3 \]"));
        let texts: Vec<&str> = found.iter().map(|(_, text, _)| text.as_str()).collect();
        assert_eq!(texts, ["u=x^2", "v=3"], "{space}");
    }
    for space in [r"\mkern-2mu ", r"\kern-1cm ", r"\mskip 3mu ", r"\hskip 2pt "] {
        let found = tex(&format!(r"\[ u=x^2{space}v=3 \]"));
        assert_eq!(found.len(), 1, "{space}: {found:?}");
    }
    // A formula goes on behind a break.
    assert_eq!(tex(r"\[ u=x^2\break +v=3 \]").len(), 1);
    assert_eq!(tex(r"\[ u=x^2\hskip1cm v \]").len(), 1);
    // A formula begins with a sign behind a space.
    for space in [r"\hskip1cm", r"\hspace{1cm}", r"\qquad"] {
        assert_eq!(tex(&format!(r"\[ u=x^2{space} -v=3 \]")).len(), 2, "{space}");
    }
    assert_eq!(tex(r"With $u=x^2\hskip1cm v=3$").len(), 2);
}

#[test]
fn a_sign_in_a_box_is_a_part_of_the_formula() {
    let found = tex(r"\[ a\mbox{$+$}b=a+b \]");
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].0, Word::Follows, "{found:?}");
    says(r"\[ f=x^2 \] \[ f\hbox{$-1$}=(x-1)(x+1) \]", &[Word::Defines, Word::Follows]);
    // What relates something, or parts formulas, is said beside them.
    assert_eq!(tex(r"\[ a=b \mbox{$\Rightarrow$} b=a \]").len(), 2);
    assert_eq!(tex(r"\[ u=x^2 \quad\mbox{where $v=3$} \]")[0].1, "u=x^2");
}

#[test]
fn markdown_is_read_as_it_is_printed() {
    let md = |text: &str| -> Vec<(Word, String)> {
        judged("notes.md", text).into_iter().map(|(word, text, _)| (word, text)).collect()
    };
    use Word::{Defines, Follows, Wrong};
    assert_eq!(md("$$\\sin 2x = %2\n\\sin x\\cos x$$")[0].0, Wrong, "a comment is none of the formula");
    assert_eq!(md("$$\\sin 2x = 2 % twice\n\\sin x\\cos x$$")[0].0, Follows);
    let found = md("50% of it:\n\n$$f = x^2 % +1$$\n\n100%: $$g=f+1$$");
    assert_eq!(found.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>(), ["f=x^2", "g=f+1"]);
    assert!(md("$f=x\\%$").iter().all(|(word, _)| *word != Defines), "a percent is not nothing");
    let printed = "$$f=x^2$$\n\nHence\n\n$$f+1=x^2+1$$\n";
    let wanted = [(Defines, "f=x^2".to_owned()), (Follows, "f+1=x^2+1".to_owned())];
    assert_eq!(md("> $$\n> f=x^2\n> $$\n\nHence\n\n> $$f+1=x^2+1$$\n"), wanted);
    assert_eq!(md("- an item\n\n    $$f=x^2$$\n\n1. Hence\n\n   $$f+1=x^2+1$$\n"), wanted);
    for hidden in [
        "<!-- $$f=x^3$$ -->\n\n",
        "Text\n\n    $$f=x^3$$\n\n",
        "<pre>\n$$f=x^3$$\n\n</pre>\n\n",
        "See <code>$f=x^3$</code>.\n\n",
        "<script type=\"x\">\n$$f=x^3$$\n</script>\n\n",
        "---\ntitle: $f=x^3$\n---\n\n",
        "`` $f=x^3$\n` ``\n\n",
        "> ```\n> $$f=x^3$$\n> ```\n\n",
    ] {
        assert_eq!(md(&format!("{hidden}{printed}")), wanted, "{hidden}");
    }
}

#[test]
fn a_program_is_told_that_a_paper_cannot_be_read() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.tex"), r"\[ f=x^2 \]").expect("written");
    let run = |arguments: &[&str]| {
        let mut command = Command::cargo_bin("rederive").expect("the program is built");
        let run = command.current_dir(folder.path()).arg("lint").args(["--format", "json"]).args(arguments).assert();
        let run = run.code(2).stderr(predicate::str::contains("cannot be read"));
        serde_json::from_slice::<serde_json::Value>(&run.get_output().stdout).expect("JSON")
    };
    let one = run(&["none.tex"]);
    assert_eq!(one["paper"], "none.tex");
    assert!(one["unreadable"].as_str().is_some_and(|why| why.contains("cannot be read")), "{one}");
    let both = run(&["a.tex", "none.tex"]);
    assert_eq!((&both[0]["paper"], &both[1]["paper"]), (&"a.tex".into(), &"none.tex".into()));
    assert!(both[0].get("unreadable").is_none(), "{both}");
}
