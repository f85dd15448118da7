//! Papers in which nothing is wrong, and papers with one slip each.

use diag::Source;

use crate::{Lint, Word, lint};

fn linted(tex: &str) -> (paper::Paper, Lint) {
    let paper = paper::parse(Source { path: "p.tex".into(), text: tex.into() }, String::new()).expect("it is read");
    let found = lint(&paper, &meter::Limits::default());
    (paper, found)
}

/// The texts of a file, each behind a line that says what it is about.
fn texts(file: &'static str) -> Vec<(&'static str, &'static str)> {
    file.split("%% ").skip(1).filter_map(|t| t.split_once('\n')).collect()
}

fn all(found: &Lint, paper: &paper::Paper) -> String {
    let one =
        |j: &crate::Judgement| format!("{} {} {:?}\n", j.word.text(), paper.printed[j.relation].text(), j.instead);
    found.judgements.iter().map(one).collect()
}

#[test]
fn nothing_is_wrong_in_derivations_that_are_right() {
    let texts = texts(include_str!("right.tex"));
    assert!(texts.len() >= 60, "{}", texts.len());
    let mut failures = String::new();
    for (about, tex) in texts {
        let (paper, found) = linted(tex);
        if found.count(Word::Wrong) > 0 {
            failures += &format!("{about}:\n{}", all(&found, &paper));
        }
    }
    assert!(failures.is_empty(), "{failures}");
}

#[test]
fn a_slip_is_found_where_the_paper_says_what_its_names_are() {
    for (about, tex) in texts(include_str!("slips.tex")) {
        let (wanted, tex) = tex.split_once('\n').expect("what is right, then the text");
        let (paper, found) = linted(tex);
        let instead: Vec<String> = found.judgements.iter().filter_map(|j| j.instead.clone()).collect();
        let plain = |t: &str| t.replace(' ', "");
        let wanted = wanted.trim_start_matches("% ");
        assert!(
            found.count(Word::Wrong) == 1 && plain(&instead[0]).contains(&plain(wanted)),
            "{about}: {instead:?}\n{}",
            all(&found, &paper)
        );
    }
}

#[test]
fn what_stands_before_it_proves_a_step() {
    for (about, tex) in texts(include_str!("follows.tex")) {
        let (paper, found) = linted(tex);
        let last = found.judgements.iter().rev().find(|j| paper.printed[j.relation].display.is_some());
        assert!(last.is_some_and(|j| j.word == Word::Follows), "{about}\n{}", all(&found, &paper));
    }
}

#[test]
fn what_does_not_follow_is_not_said_to() {
    for (about, tex) in texts(include_str!("open.tex")) {
        let (paper, found) = linted(tex);
        let last = found.judgements.iter().rev().find(|j| paper.printed[j.relation].display.is_some());
        assert!(
            last.is_some_and(|j| !matches!(j.word, Word::Follows | Word::Wrong)),
            "{about}\n{}",
            all(&found, &paper)
        );
    }
}

#[test]
fn a_definition_that_differs_by_a_slip_is_told() {
    let word = |tex: &str| linted(tex).1.judgements.last().map(|j| j.word);
    let first = r"\[ E=\frac12mv^2+mgh \] \[ a=b \] \[ c=d \] \[ f=g \] ";
    let again = r"\[ E=\frac12mv^2-mgh \]";
    assert_eq!(word(&format!("{first} Its energy is, again, {again}")), Some(Word::Differs));
    // What stands side by side is a list of several values.
    assert_eq!(word(&format!(r"\[ E=\frac12mv^2+mgh \] Its energy is, again, {again}")), Some(Word::Defines));
    assert_eq!(word(&format!("{first} If it falls upwards, {again}")), Some(Word::Defines));
    assert_eq!(word(&format!(r"{first} \section{{Another}} {again}")), Some(Word::Defines));
    assert_eq!(word(&format!("{first} Neglecting much, {again}")), Some(Word::Defines));
    assert_eq!(word(r"\[ L=T-V \] \[ L=T+V \]"), Some(Word::Defines));
    assert_eq!(word(r"\[ E=\frac12mv^2+mgh \] \[ E=mgh+\frac12mv^2 \]"), Some(Word::Follows));
}

/// Of one name both a rate and a value are explained behind a display, and taken back after it.
#[test]
fn what_is_explained_is_taken_back() {
    let text = r"\[ E = \frac12mv^2 \] where $\dot x=v$, $x=at$, $\dot x=u$. \[ F = ma \]";
    let (paper, found) = linted(text);
    assert_eq!(found.count(Word::Wrong), 0, "{}", all(&found, &paper));
}

#[test]
fn a_chain_of_names_that_ends_with_a_value_is_a_condition() {
    let word = |tex: &str| linted(tex).1.judgements.last().map(|j| j.word);
    assert_eq!(word(r"\[ x_1=x_2=0 \]"), Some(Word::Condition));
    assert_eq!(word(r"\[ a=b=c \]"), Some(Word::Condition));
    assert_eq!(word(r"\[ K=E=\frac12mv^2 \]"), Some(Word::NotFollowed));
}

#[test]
fn a_formula_without_a_first_side_stands_where_it_is_printed() {
    let (paper, found) = linted("A line,\n\\[ =a+b \\]");
    let (_, place) = paper.locate(&found.judgements[0].span);
    assert!(place.start > 7, "{place:?}");
}

#[test]
fn what_a_sentence_supposes_does_not_follow() {
    let system =
        "\\[ x' = y+(x^2+y^2-1)x \\]\n\\[ y' = -x+(x^2+y^2-1)y \\]\nwith the solution $x=\\sin t$, $y=\\cos t$.\n\n";
    let words = |sentence: &str| -> Vec<Word> {
        let (_, found) = linted(&format!("{system}{sentence}"));
        found.judgements.iter().rev().take(2).rev().map(|j| j.word).collect()
    };
    assert_eq!(words("If we consider the linear system $x' = y$, $y' = -x$, then it is so."), [Word::Condition; 2]);
    assert_eq!(words("We see that $x' = y$ and that $y' = -x$."), [Word::Follows; 2]);
}

/// In Markdown blank lines part a display from the words around it.
#[test]
fn words_around_a_display_of_markdown_take_it_back() {
    let words = |text: &str| -> Vec<Word> {
        let source = Source { path: "p.md".into(), text: text.into() };
        let paper = paper::parse(source, String::new()).expect("it is read");
        lint(&paper, &meter::Limits::default()).judgements.iter().map(|j| j.word).collect()
    };
    let slip = "$$\n(x+y)^2=x^2-2xy+y^2\n$$";
    assert_eq!(words(&format!("We have\n\n{slip}\n\nby expanding.")), [Word::Wrong]);
    for before in
        ["Suppose", "Students write", "Contrary to", "Up to a sign", "The model assumes", "If it were true that"]
    {
        assert_eq!(words(&format!("{before}\n\n{slip}\n")), [Word::Condition], "{before}");
    }
    for behind in ["does not hold.", "cannot be true.", "when $y$ is small.", "modulo 4."] {
        assert_eq!(words(&format!("Here\n\n{slip}\n\n{behind}"))[0], Word::Condition, "{behind}");
    }
    // What is printed is judged, what is struck out is not.
    for text in [r"\\[(x+y)^2=x^2-2xy+y^2\\]", r"\\((x+y)^2=x^2-2xy+y^2\\)", "{math}`(x+y)^2=x^2-2xy+y^2`"] {
        assert_eq!(words(&format!("We have {text}")), [Word::Wrong], "{text}");
    }
    for text in ["~~$(x+y)^2=x^2-2xy+y^2$~~", "{% comment %}$(x+y)^2=x^2-2xy+y^2${% endcomment %}"] {
        assert_eq!(words(text), [], "{text}");
    }
}

#[test]
fn what_defines_or_is_posed_is_not_wrong() {
    let words = |tex: &str| -> Vec<Word> { linted(tex).1.judgements.iter().map(|j| j.word).collect() };
    let of = |sign: &str| words(&format!(r"\[ (x+y)^2{sign} x^2-2xy+y^2 \]"));
    for sign in [":=", "=:", r"\coloneqq", r"\triangleq", r"\stackrel{\mathrm{def}}{=}"] {
        assert_eq!(of(sign), [Word::NotRead], "{sign}");
    }
    assert_eq!((of(r"\doteq"), of("=")), (vec![Word::Approximates], vec![Word::Wrong]));
    assert_eq!(words(r"\[ f:=(x+y)^2=x^2+2xy+y^2 \]"), [Word::Follows]);
    assert_eq!(words(r"\[ (x+y)^2:=x^2+2xy+y^2 \]"), [Word::Follows]);
    assert_eq!(words(r"\[ (x-a)^2=(x+a)^2\quad\implies\quad 4ax=0 \]"), [Word::Condition, Word::Follows]);
    // What is concluded from it is a claim, and so is what stands beside another name.
    assert_eq!(words(r"\[ F=ma\implies a=Fm \]"), [Word::Defines, Word::Wrong]);
    assert_eq!(words(r"\[ p=qr,\quad (x+y)^2=x^2-2xy+y^2 \]"), [Word::Defines, Word::Wrong]);
}

/// What is said plainly is a claim, also behind acts of reckoning and reasons.
#[test]
fn words_that_reckon_take_nothing_back() {
    for before in [
        "We have",
        "Then",
        "Expanding the square,",
        "Inserting this into Eq. (2) gives",
        "It follows that",
        "Since $x$ is real,",
        "On the other hand,",
        "In order to proceed, expand",
        "If we expand, we get",
        "When we square this, we obtain",
        "For $x>0$ we get",
        "The square of the sum is",
        "Substituting the initial conditions,",
        "and therefore",
        "We can also use the first of these to determine the magnitude of the velocity",
        "Differentiating twice and adding,",
        "Because of (3)",
        "They obey $a=b$, so that",
    ] {
        let (paper, found) = linted(&format!(r"{before} \[ (x+y)^2=x^2-2xy+y^2. \] Next."));
        assert_eq!(found.count(Word::Wrong), 1, "{before}: {}", all(&found, &paper));
    }
}
