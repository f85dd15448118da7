//! Zeros as factors: 0·e has no value where e has none, whatever writes the product.
//!
//! The law is that an expression of vectors and matrices has a value exactly where it has one when it is written out by components.

use rederive::check::{Options, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};
use rederive::number::Draws;

use crate::prove_traps::all;

const MOTION: &str = r"
[derivation]
title = 'Zeros'
concerns = 'zeros as factors'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'y' = { role = 'state' }
'I' = { role = 'parameter', shape = 'diagonal 2' }
'{\bf u}' = { role = 'abbreviation', formula = '(\frac1x,1)' }
'{\bf w}' = { role = 'abbreviation', formula = '(0,1)' }
'Z' = { role = 'abbreviation', formula = '\begin{pmatrix}0&1\\1&0\end{pmatrix}' }
'D' = { role = 'abbreviation', formula = 'I' }
[[trajectory]]
id = 'm'
formula = { 'x' = 't', 'y' = '\frac{1}{t-1}' }
parameters = { 'I' = [2, 3] }
span = [-1, 2]
";

/// The verdicts of claims, by words.
fn words(claims: &[String]) -> Vec<&'static str> {
    let blocks = claims.iter().enumerate().map(|(k, c)| format!("[[claim]]\nid = 'c{k}'\nsays = 'a zero'\n{c}\n"));
    let text = MOTION.to_owned() + &blocks.collect::<String>();
    let source = Source { path: "zeros.toml".into(), text };
    let derivation = parse(source, "zeros").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("verdicts");
    account.claims.iter().map(|c| c.results[0].verdict.outcome().word()).collect()
}

fn defined(formulas: &[&str]) -> Vec<&'static str> {
    words(&formulas.iter().map(|f| format!("defined = ['{f}']")).collect::<Vec<_>>())
}

#[test]
fn a_zero_that_is_written_or_computed_is_a_factor() {
    let holes = [
        r"\frac1x\cdot0+1\cdot1",
        r"(\frac1x,1)\cdot(0,1)",
        r"0\cdot y",
        r"\det\begin{pmatrix}1&\frac1x\\0&1\end{pmatrix}",
        r"\left|\frac{d}{dt}(2)\right|\cdot\frac1x",
        r"\left|\frac{d^2}{dt^2}(t)\right|\cdot\frac1x",
        r"\begin{pmatrix}0&1\\1&0\end{pmatrix}\begin{pmatrix}\frac1x\\1\end{pmatrix}",
        r"(\frac1x,1,1)\times(0,0,1)",
        r"\left[\begin{pmatrix}0&1\\1&0\end{pmatrix},\begin{pmatrix}\frac1x&1\\1&1\end{pmatrix}\right]",
        r"{\bf w}{\bf u}^T",
        r"0{\bf u}",
        r"{\bf u}\cdot{\bf w}",
        r"Z_{ij}u_jw_i",
        r"Z_{11}u_1",
        r"(u_1Z)_{11}",
        r"\operatorname{tr}(\begin{pmatrix}0&1\\1&0\end{pmatrix}\begin{pmatrix}\frac1x&1\\1&1\end{pmatrix})",
        r"\begin{pmatrix}x&0\\0&1\end{pmatrix}^{-1}",
        r"(\mathrm{i},1)^T(\frac1x,\mathrm{i})\cdot0",
        r"\operatorname{Re}((0+2\mathrm{i})(\frac1x+\mathrm{i}))",
        r"\operatorname{Im}(2)\frac1x",
    ];
    let wrong: Vec<_> = holes.iter().zip(defined(&holes)).filter(|(_, word)| *word != "fails").collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let claims = [(0, 2), (1, 1)].map(|(at, c)| format!("at = 'x={at}'\nalways = ['(\\frac1x,1)\\cdot(0,1)={c}']"));
    let found = words(&claims);
    assert!(found[0] != "fails" && found[1] == "holds", "{found:?}");
    let (once, twice) = (r"(\frac1x,1)\cdot(0,1)=y; x=0", r"(\frac1x,1)\cdot(0,1)=y; xy=2x");
    all(&[("unproved", "y=1", "x,y", once), ("unrefuted", "y=2", "x,y", twice)]);
}

#[test]
fn what_a_definition_leaves_empty_makes_no_term() {
    let whole = [
        r"\delta_{12}\frac1x",
        r"\delta_{1j}u_j\cdot0+u_2",
        r"\delta_{2j}u_j",
        r"(\delta_{12}-2\delta_{21}^2)\frac1x",
        r"\frac{\delta_{12}}{x}",
        r"\epsilon_{113}\frac1x",
        r"(\mathbb{1}{\bf u})_2",
        r"I_{2j}u_j",
        r"(I{\bf u})_2",
        r"(I^2{\bf u})_2",
        r"(I^{-1}{\bf u})_2",
        r"(D{\bf u})_2",
        r"(I^TI\begin{pmatrix}\frac1x&1\\1&1\end{pmatrix})_{22}",
        r"((I+2\mathbb{1}){\bf u})_2",
        r"(\operatorname{diag}(x,1){\bf u})_2",
        r"\operatorname{Re}(\delta_{12}(\frac1x+\mathrm{i}))",
    ];
    let found = defined(&whole);
    let wrong: Vec<_> = whole.iter().zip(found).filter(|(f, word)| (*word == "holds") == f.contains("1j")).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A 2×2 matrix, or a vector, of entries of which some are 0 and some have a hole.
fn entries(draws: &mut Draws, count: usize) -> Vec<&'static str> {
    const ENTRIES: [&str; 8] = ["0", "0", "1", "t", "x", r"\frac1x", r"\ln x", r"\sqrt x"];
    (0..count).map(|_| ENTRIES[draws.below(ENTRIES.len() as u64) as usize]).collect()
}

fn matrix(m: &[&str]) -> String {
    format!(r"\begin{{pmatrix}}{}&{}\\{}&{}\end{{pmatrix}}", m[0], m[1], m[2], m[3])
}

fn vector(v: &[&str]) -> String {
    format!("({})", v.join(","))
}

/// Σ ab, written out.
fn sum(pairs: &[(&str, &str)]) -> String {
    pairs.iter().map(|(a, b)| format!(r"({a})\cdot({b})")).collect::<Vec<_>>().join("+")
}

#[test]
fn products_have_values_where_they_have_them_written_out() {
    let mut draws = Draws::new(11);
    let mut pairs: Vec<[String; 2]> = Vec::new();
    for _ in 0..12 {
        let (a, b) = (entries(&mut draws, 4), entries(&mut draws, 4));
        let (u, v) = (entries(&mut draws, 3), entries(&mut draws, 3));
        let (m, n) = (matrix(&a), matrix(&b));
        let inner = |f: &[&str], g: &[&str]| sum(&f.iter().copied().zip(g.iter().copied()).collect::<Vec<_>>());
        pairs.push([format!(r"{}\cdot{}", vector(&u), vector(&v)), inner(&u, &v)]);
        let third = format!("{}-{}", sum(&[(u[0], v[1])]), sum(&[(u[1], v[0])]));
        pairs.push([format!(r"({}\times{})_3", vector(&u), vector(&v)), third]);
        let det = format!("{}-{}", sum(&[(a[0], a[3])]), sum(&[(a[1], a[2])]));
        pairs.push([format!(r"\det{m}"), det]);
        pairs.push([format!("({m}{n})_{{12}}"), sum(&[(a[0], b[1]), (a[1], b[3])])]);
        pairs.push([format!("({m}{})_2", vector(&v[..2])), sum(&[(a[2], v[0]), (a[3], v[1])])]);
        let trace = sum(&[(a[0], b[0]), (a[1], b[2]), (a[2], b[1]), (a[3], b[3])]);
        pairs.push([format!(r"\operatorname{{tr}}({m}{n})"), trace]);
        let forth = sum(&[(a[0], b[1]), (a[1], b[3])]);
        let back = sum(&[(b[0], a[1]), (b[1], a[3])]);
        pairs.push([format!(r"([{m},{n}])_{{12}}"), format!("{forth}-({back})")]);
        pairs.push([format!("({}{}^T)_{{21}}", vector(&u), vector(&v)), sum(&[(u[1], v[0])])]);
        let complex =
            format!(r"\operatorname{{Re}}(({}+({})\mathrm{{i}})\cdot({}+({})\mathrm{{i}}))", u[0], u[1], v[0], v[1]);
        // Both parts have a value where all four numbers have one.
        pairs.push([complex, sum(&[(u[0], v[0]), (u[1], v[1])])]);
    }
    let all: Vec<&str> = pairs.iter().flatten().map(String::as_str).collect();
    let found = defined(&all);
    let (found, _) = found.as_chunks::<2>();
    let wrong: Vec<_> = pairs.iter().zip(found).filter(|(_, [whole, written])| whole != written).collect();
    assert!(wrong.is_empty(), "{} of {}: {wrong:#?}", wrong.len(), pairs.len());
    let holds = found.iter().filter(|[whole, _]| *whole == "holds").count();
    assert!(holds > 5 && holds + 5 < pairs.len(), "{holds} hold");
}

#[test]
fn an_equation_that_says_nothing_wherever_it_has_a_value_is_no_constraint() {
    let symbols = MOTION.split("[[trajectory]]").next().unwrap_or_default();
    let text = symbols.to_owned()
        + r"[system.s]
states = ['x', 'y']
equations = ['(\dot x,\dot y,0)=-\frac1x(x,y,0)']
[[trajectory]]
id = 'm'
system = 's'
initial = { 'x' = 1, 'y' = 2 }
parameters = { 'I' = [2, 3] }
span = [0, 0.5]
[[claim]]
id = 'c'
says = 'the first component'
always = ['x=1-t']
";
    let source = Source { path: "zeros.toml".into(), text };
    let derivation = parse(source, "zeros").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("verdicts");
    assert_eq!(account.claims[0].results[0].verdict.outcome().word(), "holds");
}
