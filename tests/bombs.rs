//! Inputs that grow: every generator of much work, at n, 2n and 4n, ends under the meter.
//!
//! The library checks each in this process. It must give an account, or problems with places; what is undecided has its reason. Nothing
//! is measured by the clock: what does not end does not pass. What a run may take is tested in `budgets`.

use std::fmt::Write as _;

use rederive::check::Outcome;
use rederive::{Ask, Failure, Session};

const HEAD: &str = "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n";
const SYMBOLS: &str = "'t' = { role = 'time' }\n'x' = { role = 'state' }\n'k' = { role = 'parameter' }\n";
const SYSTEM: &str = "[system.s]\nstates = ['x']\nequations = ['\\dot x=-kx']\n";
const MOTION: &str =
    "[[trajectory]]\nid = 'a'\nsystem = 's'\nparameters = { 'k' = 1 }\ninitial = { 'x' = 1 }\nspan = [0, 1]\n";

fn claim(id: usize, formula: &str, more: &str) -> String {
    format!("[[claim]]\nid = 'c{id}'\nsays = 's'\nalways = ['{formula}']\n{more}\n")
}

/// A file with more symbols, and with claims.
fn file(symbols: &str, claims: &str) -> String {
    [HEAD, SYMBOLS, symbols, SYSTEM, MOTION, claims].concat()
}

fn one(formula: &str) -> String {
    file("", &claim(0, formula, ""))
}

/// The n-th name of a row of names.
fn name(n: usize) -> String {
    let letters: String = n.to_string().bytes().map(|digit| char::from(b'a' + digit - b'0')).collect();
    format!("y_{{\\rm {letters}}}")
}

fn sum(terms: impl Iterator<Item = String>) -> String {
    terms.collect::<Vec<_>>().join("+")
}

fn list(of: impl Iterator<Item = String>) -> String {
    of.collect::<Vec<_>>().join(", ")
}

/// Functions, each of which calls the one before it twice.
fn calls(n: usize) -> String {
    let mut all = format!(
        "'{}(\\alpha)' = {{ role = 'abbreviation', arguments = ['\\alpha'], formula = '\\sin\\alpha' }}\n",
        name(0)
    );
    for i in 1..=n {
        let (this, before) = (name(i), name(i - 1));
        let _ = writeln!(
            all,
            "'{this}(\\alpha)' = {{ role = 'abbreviation', arguments = ['\\alpha'], formula = '{before}(\\alpha+1)+{before}(2\\alpha)' }}"
        );
    }
    file(&all, &claim(0, &format!("x={}(x)", name(n)), ""))
}

/// An identity of powers whose numbers have so many digits.
fn powers_of_long_fractions(digits: usize) -> String {
    let number =
        |seed: usize| (0..digits).map(|i| char::from(b'1' + ((i * i + seed * (i + 3)) % 9) as u8)).collect::<String>();
    let fraction = |seed: usize| format!("\\frac{{{}}}{{{}}}", number(seed), number(seed + 1));
    let power = |seed: usize| format!("({}x+{}k+{})^5", fraction(seed), fraction(seed + 2), fraction(seed + 4));
    let symbols = format!(
        "'X' = {{ role = 'abbreviation', formula = '{}' }}\n'Y' = {{ role = 'abbreviation', formula = '{}' }}\n",
        power(1),
        power(11)
    );
    file(&symbols, &claim(0, "XY=X(Y-k)+Xk", "follows-from = []"))
}

/// Brackets of Poisson within one another.
fn brackets(n: usize) -> String {
    let symbols = "'q' = { role = 'state' }\n'p' = { role = 'state', momentum-of = 'q' }\n'H' = { role = 'observable', formula = \
                   'p^2q^2\\sin q' }\n";
    let formula = format!("{}q{}=0", "\\{H,".repeat(n), "\\}".repeat(n));
    [HEAD, "'t' = { role = 'time' }\n", symbols, &claim(0, &formula, "")].concat()
}

fn matrices(n: usize) -> String {
    file(&format!("'A' = {{ role = 'parameter', shape = '{n}x{n}' }}\n"), &claim(0, "AAAA=AAA", "follows-from = []"))
}

/// Sums over repeated indices.
fn sums(n: usize) -> String {
    let vector = format!("'{{\\bf u}}' = {{ role = 'parameter', shape = '{n}' }}\n");
    file(&vector, &claim(0, "u_iu_iu_ju_ju_ku_k=u_iu_iu_ju_j", "follows-from = []"))
}

fn ranges(n: usize) -> String {
    let names = || (0..n).map(name);
    let symbols: String = names().map(|of| format!("'{of}' = {{ role = 'parameter' }}\n")).collect();
    let terms = sum(names().flat_map(|a| (0..n).map(move |b| format!("\\sin({a}{})", name(b)))));
    let over = list(names().map(|of| format!("'{of}' = [-10, 10]")));
    [HEAD, &symbols, &claim(0, &format!("{terms}<{}", n * n), &format!("ranges = {{ {over} }}"))].concat()
}

fn units(n: usize) -> String {
    let unit = ["m", "s^{-1}", "kg"].repeat(n).join("\\,");
    let symbols = format!("'t' = {{ role = 'time' }}\n'x' = {{ role = 'parameter', unit = '{unit}' }}\n");
    [HEAD.replace("[symbols]", "[conventions]\nunits = 'SI'\n[symbols]").as_str(), &symbols, &claim(0, "x=x", "")]
        .concat()
}

fn steps(n: usize) -> String {
    let from = |i: usize| if i == 0 { String::new() } else { format!("'c{}'", i - 1) };
    file(
        "",
        &(0..n)
            .map(|i| claim(i, &format!("k+{i}=k+{i}"), &format!("follows-from = [{}]", from(i))))
            .collect::<String>(),
    )
}

fn premises(n: usize) -> String {
    let symbols: String = (0..n).map(|i| format!("'{}' = {{ role = 'parameter' }}\n", name(i))).collect();
    let given = |i: usize| claim(i, &format!("{}^2={}+1", name(i), name((i + 1) % n)), "postulate = true");
    let all = list((0..n).map(|i| format!("'c{i}'")));
    let last = claim(n, &format!("{}^8={}^2+7", name(0), name(3 % n)), &format!("follows-from = [{all}]"));
    file(&symbols, &((0..n).map(given).collect::<String>() + &last))
}

fn formulas(n: usize) -> String {
    let all = list((0..n).map(|i| format!("'x<{}'", i + 2)));
    file("", &format!("[[claim]]\nid = 'c'\nsays = 's'\nalways = [{all}]\n"))
}

fn motions(n: usize) -> String {
    let all: String = (0..n).map(|i| MOTION.replace("'a'", &format!("'a{i}'"))).collect();
    [HEAD, SYMBOLS, SYSTEM, &all, &claim(0, "x>0", "")].concat()
}

fn family(n: &str) -> String {
    let family = "[[family]]\nid = 'f'\nof = 'a'\nvary = { 'k' = { uniform = [1, 2] } }\ndraws = N\nseed = 1\nwhere = ['k<1.5']\n";
    let claim = claim(0, "x<2", "families = ['f']");
    [HEAD, SYMBOLS, SYSTEM, MOTION, &family.replace('N', n), &claim].concat()
}

/// A rate of a field of the n-th order, of a product that grows with it.
fn fields(n: usize) -> String {
    let symbols = "'z' = { role = 'coordinate' }\n'u(z)' = { role = 'field' }\n";
    let formula = format!("\\frac{{\\partial^{n}(u^2\\sin u)}}{{\\partial z^{n}}}=0");
    [HEAD, symbols, &claim(0, &formula, "follows-from = []")].concat()
}

/// A name, what it makes of a size, and the first of the three sizes.
type Generator = (&'static str, fn(usize) -> String, usize);

const GENERATORS: &[Generator] = &[
    ("calls", calls, 8),
    ("brackets", brackets, 3),
    ("matrices", matrices, 4),
    ("sums", sums, 5),
    ("products", |n| one(&format!("{}=x", (1..=n).map(|j| format!("(x+{j})")).collect::<String>())), 25),
    ("powers", |n| one(&format!("(x+k+1)^{{{}}}=x", 10_usize.pow((n / 4) as u32))), 8),
    ("ranges", ranges, 2),
    ("units", units, 20),
    ("steps", steps, 50),
    ("premises", premises, 4),
    ("formulas", formulas, 100),
    ("motions", motions, 25),
    ("families", |n| family(&n.to_string()), 10),
    ("fields", fields, 2),
    ("nested", |n| one(&format!("x={}x{}", "\\sin(".repeat(n), ")".repeat(n))), 14),
    ("chains", |n| one(&vec!["x"; n].join("=")), 250),
    ("fractions", |n| one(&format!("x={}", sum((1..n).map(|i| format!("\\frac1{{x+{i}}}"))))), 25),
    ("roots", |n| one(&format!("x={}", sum((1..n).map(|i| format!("\\sqrt{{x+{i}}}"))))), 10),
    ("digits", powers_of_long_fractions, 100),
    ("spans", |n| one("x>0").replace("[0, 1]", &format!("[0, 1e{n}]")), 75),
];

/// Checks a file to its end: verdicts that are undecided have a reason.
fn ends(name: &str, text: String) {
    let session = match Session::open("f.toml", text) {
        Ok(session) => session,
        Err(problems) => return assert!(problems.iter().all(|p| !p.message.is_empty()), "{name}"),
    };
    match session.check(&Ask::default(), &|_, _| {}) {
        Ok(findings) => {
            for found in findings.all() {
                assert!(found.outcome != Outcome::Undecided || found.reason.is_some(), "{name}: {found:?}");
            }
        }
        Err(Failure::Problems(problems)) => assert!(!problems.is_empty(), "{name}"),
        Err(other) => panic!("{name}: {other:?}"),
    }
}

#[test]
fn every_generator_ends() {
    for (name, make, first) in GENERATORS {
        // A generator of files that are refused would try nothing.
        let least = Session::open("f.toml", make(*first));
        assert!(least.is_ok(), "{name}: {:?}", least.err());
        for size in [*first, 2 * first, 4 * first] {
            ends(&format!("{name} {size}"), make(size));
        }
    }
}

#[test]
fn every_number_is_read_or_refused() {
    let range = [HEAD, "'y' = { role = 'parameter' }\n", &claim(0, "y^2>-1", "ranges = { 'y' = [0, 1] }")].concat();
    let motion = file("", &claim(0, "x>0", "precision = 0.1"));
    for file in [&range, &motion, &family("20")] {
        assert!(Session::open("f.toml", file.clone()).is_ok(), "{file}");
    }
    let places = [("span = [0, 1]", "span = [0, N]"), ("'k' = 1", "'k' = N"), ("'x' = 1", "'x' = N"), ("0.1", "N")];
    for number in ["nan", "inf", "-inf", "1e-320", "5e-324", "2e-308", "1e308", "-0.0", "1e-300", "9223372036854775807"]
    {
        for (at, by) in places {
            ends(&format!("{by} {number}"), motion.replace(at, &by.replace('N', number)));
        }
        ends(&format!("between {number}"), family("20").replace("[1, 2]", &format!("[1, {number}]")));
        ends(&format!("draws {number}"), family("20").replace("draws = 20", &format!("draws = {number}")));
        ends(&format!("range {number}"), range.replace("[0, 1]", &format!("[0, {number}]")));
    }
}

/// Findings that go from file to file.
#[test]
fn places_of_many_files_are_counted_once() {
    use rederive::report::{Finding, Level, Place, sarif};
    let text = "a=b\n".repeat(10_000);
    let source =
        |i: usize| std::sync::Arc::new(rederive::diag::Source { path: format!("{i}.tex"), text: text.clone() });
    let files: Vec<_> = (0..400).map(source).collect();
    let finding = |k: usize| Finding {
        rule: "lint::wrong",
        level: Level::Error,
        message: String::new(),
        place: Place::new(&files[k % files.len()], 4 * (k % 9_000)..4 * (k % 9_000) + 1),
        related: Vec::new(),
        identity: k.to_string(),
        fix: None,
    };
    let found: Vec<Finding> = (0..20_000).map(finding).collect();
    let log = sarif(&found);
    assert!(log.contains("\"startLine\": 9000"));
}

/// Groups and environments of a paper that are opened and not closed, many of them.
#[test]
fn what_is_opened_in_a_paper_is_looked_at_once() {
    let words = |text: String, name: &str| {
        let source = rederive::diag::Source { path: name.into(), text };
        rederive::paper::parse(source, String::new()).map_or(0, |paper| paper.printed.len())
    };
    for n in [2_000, 4_000, 8_000] {
        for piece in [r"\begin{", r"\newtheorem{", r"\stepcounter{"] {
            words(format!("\\begin{{document}}{}", piece.repeat(n)), "p.tex");
        }
        for piece in [r"\text{$a", r"\\[a", r"\intertext{", r"\overset{a}", "_{", "a{}_b"] {
            words(format!("\\begin{{align}}{}", piece.repeat(4 * n)), "p.tex");
        }
        for piece in
            ["![", "](", "](<", "[a](", "<a b=\"", "<p hidden>", "</", "```{note}\n", "[a]: ", "- ", "> ", "{math}`"]
        {
            words(format!("a {}", piece.repeat(4 * n)), "p.md");
            words(piece.repeat(4 * n), "p.md");
        }
        let other: String = (0..n).map(|i| format!("\\begin{{{i}}}")).collect();
        words(other, "p.md");
        words(format!("a\n{}{}", " ".repeat(20 * n), "b".repeat(20 * n)), "p.md");
        words(format!("\\def\\x#1{0}x{{#1}}\\x{0}{0}{0}", ";".repeat(2 * n)), "p.tex");
        assert!(!rederive::report::prose(&"www".repeat(20 * n)).is_empty());
    }
}
