//! Habits of authors: packages, environments, labels, spellings of derivatives, one display each, and what `lint` says of it.
//!
//! Each is an identity, or a definition and what follows from it: one that is misread would be *wrong*, or not followed. What is not read yet
//! stands in the list, too, and is told by its name.

use rederive::check::Limits;
use rederive::diag::Source;
use rederive::lint::{self, Word};
use rederive::paper;

/// Displays that are read, and each of which has a step that follows.
const READ: &[(&str, &str)] = &[
    ("equation with a label", r"\begin{equation}\label{eq:a} (a+b)^2=a^2+2ab+b^2. \end{equation}"),
    ("align: a chain over rows", r"\begin{align} (a+b)(a-b) &= a^2-b^2 \\ &= -(b^2-a^2) \end{align}"),
    ("align with two columns", r"\begin{align*} (a+b)^2 &= a^2+2ab+b^2 & (a-b)^2 &= a^2-2ab+b^2 \end{align*}"),
    ("eqnarray", r"\begin{eqnarray} (a-b)^2 &=& a^2-2ab \nonumber\\ && {}+b^2 \end{eqnarray}"),
    ("gather", r"\begin{gather} \sin^2x+\cos^2x=1 \\ \cosh^2x-\sinh^2x=1 \end{gather}"),
    ("multline", r"\begin{multline} (a+b)^3 = a^3+3a^2b \\ +3ab^2+b^3 \end{multline}"),
    ("split in equation", r"\begin{equation}\begin{split} (a+b)c &= ac \\ &\quad + bc \end{split}\end{equation}"),
    ("aligned in brackets", r"\[ \begin{aligned} \cos 2x &= \cos^2x-\sin^2x \\ &= 1-2\sin^2x \end{aligned} \]"),
    ("alignat", r"\begin{alignat}{2} (a+b)^2 &= a^2 &&+ 2ab+b^2 \end{alignat}"),
    ("flalign", r"\begin{flalign} & (a-b)(a+b) = a^2-b^2 & \end{flalign}"),
    (
        "subequations",
        r"\begin{subequations}\begin{align} 2(a+b)&=2a+2b \label{s1}\\ 3(a-b)&=3a-3b \end{align}\end{subequations}",
    ),
    ("double dollars", r"$$ (x+1)^2 = x^2+2x+1 $$"),
    ("empheq", r"\begin{empheq}[box=\fbox]{align} (x-1)^2 &= x^2-2x+1 \end{empheq}"),
    (
        "a matrix times a column",
        r"\[ \begin{pmatrix} a & b \\ c & d \end{pmatrix}\begin{pmatrix} 1 \\ 2 \end{pmatrix}=\begin{pmatrix} a+2b \\ c+2d \end{pmatrix} \]",
    ),
    ("intertext", r"\begin{align} (a+1)^2&=a^2+2a+1 \intertext{and therefore} (a+1)^2-1&=a^2+2a \end{align}"),
    ("physics: dv", r"\[ \dv{x}(x^3) = 3x^2 \]"),
    ("physics: pdv", r"\[ \pdv{x}(x^2y) = 2xy, \qquad \pdv[2]{(x^3 y)}{x} = 6xy \]"),
    ("physics: qty and abs", r"\[ \qty(a+b)^2 = a^2+2ab+b^2, \quad \abs{-a} = \abs{a} \]"),
    ("physics: vb and cross", r"\[ \vb{A}\cross\vb{B} = -\vb{B}\cross\vb{A} \]"),
    ("physics: dd in a quotient", r"\[ \frac{\dd}{\dd x}\sin x = \cos x \]"),
    ("siunitx: num", r"\[ \num{2.5e3} = 2500 \]"),
    ("mathtools: coloneqq", r"\[ s \coloneqq a+b \] \[ s^2 = a^2+2ab+b^2 \]"),
    ("DeclarePairedDelimiter", r"\DeclarePairedDelimiter{\size}{\lvert}{\rvert} \[ \size{-x} = \size*{x} \]"),
    ("cancel", r"\[ \frac{\cancel{a}b}{\cancel{a}} = b \]"),
    ("bm", r"\[ \bm{r}\cdot\bm{r} = |\bm{r}|^2 \]"),
    ("nicefrac", r"\[ \nicefrac{1}{2}+\nicefrac12 = 1 \]"),
    ("boxed and underbrace", r"\[ \boxed{(a+b)^2 = \underbrace{a^2+b^2}_{\text{squares}} + 2ab} \]"),
    ("tfrac and dfrac", r"\[ \tfrac12 x + \dfrac{x}{2} = x \]"),
    ("color", r"\[ {\color{red}a}(b+c) = \textcolor{blue}{ab}+ac \]"),
    (
        "labels in roman",
        r"\[ E_{\rm tot} = E_\mathrm{kin} + E_{\text{pot}} \] \[ E_{\rm tot}-E_{\mathrm{kin}} = E_\text{pot} \]",
    ),
    ("labels that are operators", r"\[ v_{\max} = w + v_{\min} \] \[ v_{\max} - v_{\min} = w \]"),
    ("numbers below", r"\[ x_0 + x_1 = s \] \[ (x_0+x_1)^2 = s^2 \]"),
    ("infinity below", r"\[ v_\infty = 2u \] \[ v_\infty^2 = 4u^2 \]"),
    ("orders above in parentheses", r"\[ \mu^{(1)}(a+b) = a\mu^{(1)} + b\mu^{(1)} \]"),
    ("tildes and bars", r"\[ \tilde x = \bar x + a \] \[ \tilde x^2 = \bar x^2 + 2a\bar x + a^2 \]"),
    ("a prime before a subscript", r"\[ x'_1 = a \] \[ {x_1'}^2 = a^2 \]"),
    ("Leibniz", r"\[ \frac{d}{dx}\left(x^2\right) = 2x \]"),
    ("Leibniz, upright", r"\[ \frac{\mathrm{d}}{\mathrm{d}x}\sin x = \cos x \]"),
    ("Leibniz of a name", r"\[ x = \frac12 g t^2 \] \[ \frac{dx}{dt} = g t \]"),
    ("dots", r"\[ x = A\cos\omega t \] \[ \ddot x = -\omega^2 x \]"),
    ("a second derivative", r"\[ y = \sin kx \] \[ \frac{d^2y}{dx^2} = -k^2 y \]"),
    ("primes", r"\[ f(x) = x^3 \] \[ f'(x) = 3x^2 \]"),
    (
        "partial derivatives of a function",
        r"\[ u(x,t) = (x-ct)^2 \] \[ \frac{\partial u}{\partial t} = -c\frac{\partial u}{\partial x} \]",
    ),
    ("a partial sign with a variable below", r"\[ \partial_x (x^2) = 2x \]"),
    ("a rate over a slash", r"\[ y = x^3 \] \[ dy/dx = 3x^2 \]"),
    ("a bar with a place", r"\[ \left.\frac{d}{dx}x^2\right|_{x=3} = 6 \]"),
    ("the gradient", r"\[ \nabla\times(\nabla\phi) = 0 \]"),
    ("over", r"\[ {a+b \over 2} + {a-b \over 2} = a \]"),
    ("eqalign", r"$$ \eqalign{ (a+b)^2 &= a^2+2ab+b^2 \cr (a-b)^2 &= a^2-2ab+b^2 \cr} $$"),
    ("Unicode letters and signs", r"\[ ½(α+β)·2 = α+β \]"),
    ("a function in roman", r"\[ {\rm sin}^2 x + \mathrm{cos}^2 x = 1 \]"),
    ("powers of functions", r"\[ \sin^2(x) + \cos(x)^2 = 1 \]"),
    ("an argument without parentheses", r"\[ \sin 2x = 2\sin x\cos x \]"),
    ("and between wide spaces", r"\[ a = b+c \qquad\text{and}\qquad a-c = b \]"),
    ("text behind", r"\[ \sqrt{x^2} = x \qquad \text{for } x>0 \]"),
    ("a definition in the running text", r"With $k = 2\pi/\lambda$, \[ k\lambda = 2\pi \]"),
    ("a tag and a full stop", r"\[ e^{a+b} = e^a e^b\,. \tag{3} \]"),
    (
        "macros of the author",
        r"\newcommand{\half}[1][1]{\frac{#1}{2}} \def\sq#1{{#1}^2} \DeclareMathOperator{\sgnn}{sgn} \[ \half[3]\sq{x} + \half\sq{x} = 2\sq{x} \]",
    ),
];

/// Displays that are not read yet, and what is said of them.
const NOT_READ: &[(&str, &str, &str)] = &[
    ("cases", r"\[ |x| = \begin{cases} x & x\ge 0 \\ -x & x<0 \end{cases} \]", "cases"),
    ("siunitx", r"\[ v = \SI{3}{\m\per\s} \]", "a number with a unit"),
    ("two labels with a comma", r"\[ C_{p,k}(T+1) = C_{p,k}T + C_{p,k} \]", "an index that may be summed over, k"),
    ("a star above", r"\[ x^* = 2y \] \[ (x^*)^2 = 4y^2 \]", "a star above: a conjugate, or a name"),
];

/// The words on the relations of a paper, and why each is not read.
fn words(tex: &str) -> Vec<(Word, String)> {
    let text = format!("\\documentclass{{article}}\\begin{{document}}\n{tex}\n\\end{{document}}\n");
    let paper =
        paper::parse(Source { path: "paper.tex".into(), text }, String::new()).unwrap_or_else(|d| panic!("{d}"));
    lint::lint(&paper, &Limits::default()).judgements.into_iter().map(|j| (j.word, j.why)).collect()
}

#[test]
fn most_habits_are_read() {
    let good = [Word::Follows, Word::Defines, Word::Condition];
    for (name, tex) in READ {
        let found = words(tex);
        let follows = found.iter().any(|(word, _)| *word == Word::Follows);
        assert!(follows && found.iter().all(|(word, _)| good.contains(word)), "{name}: {found:?}");
    }
    assert_eq!(READ.len() + NOT_READ.len(), 62);
    assert!(READ.len() >= 58, "{}", READ.len());
}

#[test]
fn a_habit_that_is_not_read_is_named() {
    for (name, tex, why) in NOT_READ {
        let found = words(tex);
        assert!(found.iter().all(|(word, said)| *word == Word::NotRead && said == why), "{name}: {found:?}");
    }
}
