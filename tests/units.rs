//! Units: what agrees and what does not, against an independent test, and what the command makes of it.

use std::collections::HashMap;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::PredicateBooleanExt;
use rederive::check::units::{UnitVerdict, UnitsAccount, units};
use rederive::derivation::{Derivation, Form, parse};
use rederive::diag::{Source, render};
use rederive::expr::{Expr, Leaf};
use rederive::number::Draws;
use rederive::tape::Tape;

fn read(text: String) -> Derivation {
    let source = Source { path: "test.toml".into(), text };
    parse(source, "test").unwrap_or_else(|found| panic!("{}", render(&found, false)))
}

/// A file with these symbols and one claim.
fn file(symbols: &str, claim: &str) -> Derivation {
    read(format!(
        "[derivation]\ntitle = 'test'\nconcerns = 'test'\n[symbols]\n{symbols}\n[[claim]]\nid = 'c'\nsays = 'c'\n{claim}\n"
    ))
}

const MECHANICS: &str = r"
't' = { role = 'time', unit = 's' }
'x' = { role = 'state', unit = 'm' }
'v' = { role = 'state', unit = 'm/s' }
'M' = { role = 'parameter', unit = 'kg' }
'g' = { role = 'parameter', unit = 'm/s^2' }
'w' = { role = 'parameter', unit = '1/s' }
'\theta' = { role = 'state', unit = 'rad' }
'\beta' = { role = 'parameter', unit = 'deg' }
'\ell' = { role = 'parameter', unit = 'km' }
'n' = { role = 'parameter' }
'E' = { role = 'observable', formula = '\frac12Mv^2+Mgx' }
'V' = { role = 'observable', shape = '2', formula = '(x,\theta)' }
";

fn verdict(formula: &str) -> UnitVerdict {
    let found = units(&file(MECHANICS, &format!("always = ['{formula}']")));
    found.formulas.iter().find(|f| f.kind == "claim").map(|f| f.verdict.clone()).expect("the claim is looked at")
}

#[test]
fn what_agrees_agrees() {
    for formula in [
        r"\dot x=v",
        r"\ddot x=-g",
        r"E=\frac12Mv^2+Mgx",
        r"\dot E=0",
        r"v^2=2gx",
        r"v=\sqrt{2gx}",
        r"v=(2gx)^{\frac12}",
        r"v^3=(gx)^{\frac32}",
        r"\frac{x}{v}=\frac1w e^{-wt}",
        r"\theta=\operatorname{atan2}(v,wx)",
        r"x=x(0)+v(0)t",
        r"x=x(2)",
        r"x=0",
        r"x\ge 0",
        r"\sin^2(wt)+\cos^2(wt)=1",
        r"\frac{d\theta}{dx}=\frac{\dot\theta}{v}",
        r"\left|x\right|=\operatorname{agm}(x,\frac{v}{w})",
        r"V_1=x",
        r"V_2=\theta",
        r"\dot V_1=v",
        r"2^{wt}=1",
        r"x=\pm vt",
    ] {
        assert_eq!(verdict(formula), UnitVerdict::Consistent, "{formula}");
    }
}

#[test]
fn what_does_not_agree_is_named() {
    for (formula, a, b) in [
        (r"\dot x=x", ("\\dot{x}", "m/s"), ("x", "m")),
        (r"\ddot x=g t", ("\\ddot{x}", "m/s^2"), ("g\\cdot t", "m/s")),
        (r"E=\frac12Mv+Mgx", (r"\frac{1}{2}\cdot M\cdot v", "kg m/s"), (r"M\cdot g\cdot x", "kg m^2/s^2")),
        (r"\theta=\sin x", ("x", "m"), ("a number", "1")),
        (r"x=e^{t}", ("t", "s"), ("a number", "1")),
        (r"\theta=\operatorname{atan2}(v,x)", ("v", "m/s"), ("x", "m")),
        (r"v=\sqrt{gx^2}", ("v", "m/s"), (r"\sqrt{g\cdot x^2}", "m^(3/2)/s")),
        (r"x=x(w)", ("w", "1/s"), ("t", "s")),
        (r"x=1", ("x", "m"), ("1", "1")),
        (r"v^{wt}=1", ("v", "m/s"), ("a number", "1")),
        (r"V_1=V_2", ("V_1", "m"), ("V_2", "1")),
        (r"x=n+v", ("x", "m"), ("v", "m/s")),
        (r"\lim_{t\rightarrow w}x(t)=0", ("w", "1/s"), ("t", "s")),
    ] {
        match verdict(formula) {
            UnitVerdict::Inconsistent { terms, .. } => {
                let found = terms.each_ref().map(|t| (t.latex.as_str(), t.unit.as_str()));
                assert_eq!(found, [a, b], "{formula}");
            }
            other => panic!("{formula}: {other:?}"),
        }
    }
}

#[test]
fn what_cannot_be_told_is_not_said() {
    for (formula, reason) in [
        ("x=nv", "n has no unit"),
        (r"\sin n=0", "n has no unit"),
        ("x=\\ell", "units of different size"),
        (r"\sin\beta=0", "units of different size"),
    ] {
        match verdict(formula) {
            UnitVerdict::NotChecked { reason: found } => assert!(found.contains(reason), "{formula}: {found}"),
            other => panic!("{formula}: {other:?}"),
        }
    }
}

#[test]
fn a_declared_unit_is_compared_with_the_formula() {
    let with = |unit: &str| {
        let symbols = format!("{MECHANICS}\n'K' = {{ role = 'abbreviation', unit = '{unit}', formula = 'Mv^2' }}");
        let found = units(&file(&symbols, "always = ['K=E']"));
        let word = |kind: &str, of: &str| {
            let mut all = found.formulas.iter().filter(|f| f.kind == kind && f.of == of);
            all.next().map(|f| f.verdict.word()).unwrap_or_default()
        };
        (word("symbol", "K"), word("claim", "c"))
    };
    assert_eq!(with("J"), ("consistent", "consistent"));
    assert_eq!(with("N"), ("inconsistent", "consistent"));
    assert_eq!(with("kJ"), ("not-checked", "consistent"));
}

#[test]
fn values_of_trajectories_measures_and_systems_are_looked_at() {
    let text = format!(
        "[derivation]\ntitle = 't'\nconcerns = 't'\n[symbols]\n{MECHANICS}\n{}",
        r"
[system.s]
states = ['x', 'v', '\theta']
equations = ['\dot x=v', '\dot v=-gx', '\dot\theta=w']
[[trajectory]]
id = 'one'
system = 's'
parameters = { 'g' = 9.81, 'w' = 'g', 'M' = '2\pi' }
initial = { 'x' = '\frac{g}{w^2}', 'v' = '\frac{g}{w^2}', '\theta' = 1 }
span = [0, 1]
[[claim]]
id = 'c'
says = 'c'
first-integral = ['x']
[[measure]]
id = 'good'
says = 'good'
formula = 'x'
unit = 'm'
[[measure]]
id = 'bad'
says = 'bad'
formula = 'x^2'
unit = 'm'
[[condition]]
id = 'odd'
says = 'odd'
holds = ['x=v']
"
    );
    let found = units(&read(text));
    let words = |kind: &str| -> Vec<&str> {
        found.formulas.iter().filter(|f| f.kind == kind).map(|f| f.verdict.word()).collect()
    };
    assert_eq!(words("system"), ["consistent", "inconsistent", "consistent"]);
    // w = g, x, v; numbers have the unit of what they are given to.
    assert_eq!(words("trajectory"), ["inconsistent", "consistent", "inconsistent"]);
    assert_eq!(words("measure"), ["consistent", "inconsistent"]);
    assert_eq!(words("condition"), ["inconsistent"]);
}

#[test]
fn an_expected_inconsistency_is_no_problem_and_a_missed_one_is() {
    let count = |claim: &str| units(&file(MECHANICS, claim)).unexpected();
    assert_eq!(count("always = ['x=v']"), 1);
    assert_eq!(count("always = ['x=v']\nexpect-units = 'inconsistent'"), 0);
    assert_eq!(count("always = ['x=0']\nexpect-units = 'inconsistent'"), 1);
    assert_eq!(count("always = ['x=0']"), 0);
}

#[test]
fn without_units_nothing_is_said() {
    let found = units(&file("'t' = { role = 'time' }\n'x' = { role = 'state' }", "always = ['x=t']"));
    assert_eq!(found, UnitsAccount::default());
}

/// A random formula whose units are made to agree, but for slips.
struct Random {
    draws: Draws,
    symbols: Vec<(String, [i64; 3])>,
    slips: u64,
}

const NAMES: &[&str] = &[
    "a", "b", "c", "f", "g", "h", "k", "l", "n", "p", "q", "r", "u", "v", "w", "x", "y", "z", "A", "B", "C", "D", "F",
    "G", "H", "K", "L", "M", "N", "P", "Q", "U", "V", "W", "X", "Y", "Z",
];

impl Random {
    fn symbol(&mut self, mut unit: [i64; 3]) -> String {
        if self.draws.below(100) < self.slips {
            unit[self.draws.below(3) as usize] += 1;
        }
        let name = NAMES[self.symbols.len() % NAMES.len()].to_owned();
        self.symbols.push((name.clone(), unit));
        name
    }

    /// An expression of this unit, positive for positive symbols; every symbol occurs once, so that nothing cancels.
    fn expression(&mut self, unit: [i64; 3], depth: u32) -> String {
        let one = unit == [0; 3];
        let even = unit.iter().all(|n| n % 2 == 0);
        match self.draws.below(if depth == 0 { 1 } else { 9 }) {
            1 | 2 => format!("({}+{})", self.expression(unit, depth - 1), self.expression(unit, depth - 1)),
            3 => {
                let other: [i64; 3] = std::array::from_fn(|_| self.draws.below(3) as i64 - 1);
                let rest = std::array::from_fn(|i| unit[i] - other[i]);
                format!("{}\\cdot {}", self.expression(other, depth - 1), self.expression(rest, depth - 1))
            }
            4 => {
                let other: [i64; 3] = std::array::from_fn(|_| self.draws.below(3) as i64 - 1);
                let rest = std::array::from_fn(|i| unit[i] + other[i]);
                format!("\\frac{{{}}}{{{}}}", self.expression(rest, depth - 1), self.expression(other, depth - 1))
            }
            5 => format!("\\sqrt{{{}}}", self.expression(unit.map(|n| 2 * n), depth - 1)),
            6 if even => format!("({})^2", self.expression(unit.map(|n| n / 2), depth - 1)),
            6 => format!("({})^{{\\frac12}}", self.expression(unit.map(|n| 2 * n), depth - 1)),
            7 if one => match self.draws.below(3) {
                0 => format!("(2+\\sin({}))", self.expression(unit, depth - 1)),
                1 => format!("(2+\\tanh({}))", self.expression(unit, depth - 1)),
                _ => {
                    let other: [i64; 3] = std::array::from_fn(|_| self.draws.below(3) as i64 - 1);
                    let (a, b) = (self.expression(other, depth - 1), self.expression(other, depth - 1));
                    format!("\\operatorname{{atan2}}({a},{b})")
                }
            },
            _ => self.symbol(unit),
        }
    }
}

/// The values of expressions for values of symbols.
fn evaluate(derivation: &Derivation, exprs: &[Expr], values: &HashMap<String, f64>) -> Vec<f64> {
    let leaves: Vec<Leaf> = derivation.graph.leaves(exprs.iter().copied());
    let tape = Tape::compile(&derivation.graph, &leaves, exprs).expect("all leaves are given");
    let mut slots = tape.slots::<rederive::number::Bounded>(&());
    let number = |l: &Leaf| values.get(derivation.graph.name(l.symbol)).copied().unwrap_or(f64::NAN);
    let inputs: Vec<_> =
        leaves.iter().map(|l| Ok(rederive::number::Bounded { value: number(l), error: 0.0 })).collect();
    tape.evaluate(&(), &inputs, &mut slots).into_iter().map(|v| v.map_or(f64::NAN, |b| b.value)).collect()
}

/// xⁿ.
fn power(x: f64, n: i64) -> f64 {
    let base = if n < 0 { 1.0 / x } else { x };
    (0..n.abs()).map(|_| base).product()
}

/// A relation whose units agree keeps its truth when the base units are changed: both sides change by the same factor. This
/// knows nothing of how units are inferred.
#[test]
fn the_verdict_is_that_of_a_change_of_units() {
    let (mut agree, mut differ, mut unclear) = (0, 0, 0);
    for seed in 0..3000 {
        let slips = if seed % 2 == 0 { 0 } else { 12 };
        let mut random = Random { draws: Draws::new(seed), symbols: Vec::new(), slips };
        let unit: [i64; 3] = std::array::from_fn(|_| random.draws.below(5) as i64 - 2);
        let formula = format!("{}={}", random.expression(unit, 4), random.expression(unit, 4));
        if random.symbols.len() > NAMES.len() {
            continue; // a name would stand for two symbols
        }
        let one = |(name, [a, b, c]): &(String, [i64; 3])| {
            format!("'{name}' = {{ role = 'parameter', unit = 'kg^{{{a}}} m^{{{b}}} s^{{{c}}}' }}")
        };
        let symbols: Vec<String> = random.symbols.iter().map(one).collect();
        let derivation = file(&symbols.join("\n"), &format!("always = ['{formula}']"));
        let found = units(&derivation);
        let verdict = &found.formulas.iter().find(|f| f.kind == "claim").expect("the claim is looked at").verdict;

        let mut draws = Draws::new(seed + 1_000_000);
        let mut uniform = || 0.5 + draws.below(1 << 20) as f64 / (1 << 20) as f64;
        let lambda = [uniform(), uniform(), uniform()];
        let values: HashMap<String, f64> = random.symbols.iter().map(|(n, _)| (n.clone(), uniform())).collect();
        let factor = |unit: &[i64; 3]| -> f64 { (0..3).map(|i| power(lambda[i], unit[i])).product() };
        let scaled = random.symbols.iter().map(|(n, u)| (n.clone(), values[n] * factor(u))).collect();
        let Form::Always(w) = &derivation.claims[0].forms[0] else { panic!("an equation") };
        let sides = [w.value.relations[0].left.components[0], w.value.relations[0].right.components[0]];
        let (before, after) = (evaluate(&derivation, &sides, &values), evaluate(&derivation, &sides, &scaled));
        let (left, right) = (after[0] / before[0], after[1] / before[1]);
        let gap = (left / right - 1.0).abs();
        match verdict {
            UnitVerdict::Consistent => {
                assert!(gap < 1e-12, "{formula}: said to agree, and the sides change by {left} and {right}");
                agree += 1;
            }
            UnitVerdict::Inconsistent { .. } if gap < 1e-12 => unclear += 1,
            UnitVerdict::Inconsistent { .. } => differ += 1,
            UnitVerdict::NotChecked { reason } => panic!("{formula}: {reason}"),
        }
    }
    assert!(agree > 1000 && differ > 500, "{agree} agree, {differ} differ");
    assert_eq!(unclear, 0, "{unclear} are said not to agree, and their sides change alike");
}

#[test]
fn the_derivations_of_this_project_agree() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
    for (name, expected) in [("deriglazov-comment", 0), ("kepler", 1), ("pendulum", 0)] {
        let text = std::fs::read_to_string(folder.join(format!("{name}.toml"))).expect("the file is there");
        let found = units(&read(text));
        assert_eq!((found.count("inconsistent"), found.unexpected()), (expected, 0), "{name}");
        assert_eq!(found.count("not-checked"), 0, "{name}");
        assert!(found.count("consistent") > 20, "{name}");
    }
}

#[test]
fn a_slip_in_a_derivation_is_found() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
    let text = std::fs::read_to_string(folder.join("deriglazov-comment.toml")).expect("the file is there");
    for (right, wrong) in [
        (
            r"always = ['\dot\theta=m_3 I_{(1-2)}\sin\theta\sin\psi\cos\psi']",
            r"always = ['\dot\theta=m_3^2 I_{(1-2)}\sin\theta\sin\psi\cos\psi']",
        ),
        (r"'2E=\frac{m^2_3}{I_3}+m^2_3[I_{(1-3)}", r"'2E=\frac{m_3}{I_3}+m^2_3[I_{(1-3)}"),
        (r"'\cos\theta(t)=\frac{1-ce^{2kt}}{1+ce^{2kt}}'", r"'\cos\theta(t)=\frac{1-ce^{2k}}{1+ce^{2kt}}'"),
        (r"formula = '\frac12 I_i\Omega_i^2', says = ", r"formula = '\frac12 I_i\Omega_i', says = "),
    ] {
        assert!(text.contains(right), "{right}");
        let found = units(&read(text.replacen(right, wrong, 1)));
        assert!(found.unexpected() > 0, "{wrong}");
    }
}

#[test]
fn the_command_counts_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("units.toml");
    let write = |formula: &str, more: &str| {
        let text = format!(
            "[derivation]\ntitle = 't'\nconcerns = 't'\n[symbols]\n{MECHANICS}\n[system.s]\nstates = ['x', 'v']\n\
             equations = ['\\dot x=v', '\\dot v=-g']\n[[trajectory]]\nid = 'a'\nsystem = 's'\nparameters = {{ 'g' = 1, \
             'w' = 1 }}\ninitial = {{ 'x' = 0, 'v' = 0 }}\nspan = [0, 1]\n[[claim]]\nid = 'c'\nsays = 'c'\n\
             always = ['{formula}']\n{more}\n"
        );
        std::fs::write(&path, text).expect("written");
        Command::cargo_bin("rederive").expect("built").args(["check", "--no-reports"]).arg(&path).assert()
    };
    // Both hold on the motion: with g = w = 1 the number is right and the unit is not.
    write("v=-gt", "").code(0).stdout(predicates::str::contains("Units").not());
    write("v=-t", "").code(1).stdout(predicates::str::contains("Units that do not agree (1)"));
    write("v=-t", "expect-units = 'inconsistent'").code(0);
    write("v=-gt", "expect-units = 'inconsistent'").code(1);

    write("v=-t", "expect-units = 'wrong'").code(2).stderr(predicates::str::contains("expectation"));
}

#[test]
fn a_unit_that_is_not_understood_is_refused() {
    let text = "[derivation]\ntitle = 't'\nconcerns = 't'\n[symbols]\n't' = { role = 'time', unit = 'fortnight' }\n";
    let found = parse(Source { path: "t.toml".into(), text: text.into() }, "t").expect_err("refused");
    let shown = render(&found, false);
    assert!(shown.contains("fortnight") && shown.contains("bad-unit"), "{shown}");
}
