//! The table of limits that are no counted work, `docs/limits.md`: each row is what the program does.
//!
//! Every row names the constants that make it so, as they stand in the source, and an input that reaches it, here or in a test that is named.
//! (Counted work has a table of its own, and a test in `starved.rs`.)

use std::fs;
use std::path::Path;

use rederive::check::Limits;
use rederive::diag::Source;
use rederive::files::records::{QUICK, Records, Store};
use rederive::report::ProofFile;
use rederive::{Ask, Failure, Rigor, Session};

const HEAD: &str = "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = { role = 'time' }\n'x' = { role = 'state' }\n\
                    'k' = { role = 'parameter' }\n[system.s]\nstates = ['x']\n";
const MOTION: &str =
    "[[trajectory]]\nid = 'a'\nsystem = 's'\nparameters = { 'k' = 1 }\ninitial = { 'x' = 1 }\nspan = [0, 1]\n";

fn claim(id: usize, formula: &str) -> String {
    format!("[[claim]]\nid = 'c{id}'\nsays = 's'\nalways = ['{formula}']\n")
}

/// A file about a system, with more motions and claims.
fn file(rate: &str, more: &str) -> String {
    format!("{HEAD}equations = ['\\dot x={rate}']\n{MOTION}{more}")
}

fn of_family(family: &str) -> String {
    let family = format!("[[family]]\nid = 'f'\nof = 'a'\n{family}\n");
    file("-kx", &(family + &claim(0, "x<2") + "families = ['f']\n"))
}

/// What is told of a file.
fn told(text: &str) -> String {
    let session = match Session::open("x.toml", text) {
        Ok(session) => session,
        Err(problems) => return rederive::diag::render(&problems, false),
    };
    match session.check(&Ask { rigor: Rigor::Enclosed, ..Ask::default() }, &|_, _| {}) {
        Ok(found) => found.json() + &found.markdown(),
        Err(Failure::Problems(problems)) => rederive::diag::render(&problems, false),
        Err(other) => panic!("{other:?}"),
    }
}

/// What is told of a paper.
fn of_paper(text: &str) -> String {
    let source = Source { path: "x.tex".to_owned(), text: text.to_owned() };
    let paper = rederive::paper::parse(source, String::new()).expect("a paper");
    rederive::lint::lint_text(&paper, &rederive::lint::lint(&paper, &Limits::default()))
}

/// How a row is reached.
enum Reached {
    /// By this input; these words are told.
    By(fn() -> String, &'static str),
    /// In the test of this name.
    In(&'static str, &'static str),
}
use Reached::{By, In};

/// The first cell of a row; each number of it, with the constant that it is, and where that stands; what reaches it.
type Row = (&'static str, &'static [(&'static str, &'static str, &'static str)], Reached);

const ROWS: &[Row] = &[
    (
        "a `report.json`, a `proofs.json`, a line of a part",
        &[
            ("5 million values", "MOST_VALUES: usize = 5_000_000", "src/diag/values.rs"),
            ("256 MiB", "LARGEST_REPORT: u64 = 256 << 20", "src/cli/diff.rs"),
            ("256 MiB", "LARGEST_FILE: u64 = 256 << 20", "src/cli/audit.rs"),
            ("256 MiB", "LARGEST_PARTS: u64 = 256 << 20", "src/cli/files.rs"),
        ],
        By(|| ProofFile::read(("[".to_owned() + &"0,".repeat(5_000_000) + "0]").as_bytes()).unwrap_err(), "values"),
    ),
    (
        "a record in the cache folder",
        &[("128 MiB", "LARGEST: u64 = 1 << 27", "src/files/records.rs")],
        By(
            || {
                let folder = tempfile::tempdir().expect("a folder");
                let records = Records::new(folder.path().to_owned(), std::env::current_exe().expect("this"), [0; 32]);
                let (large, small) = (vec![0; (1 << 27) + 1], vec![0; 1 << 10]);
                std::thread::sleep(2 * QUICK);
                records.write("small", &small);
                records.write("large", &large);
                assert_eq!(records.read("small"), Some(small));
                format!("{:?}", records.read("large"))
            },
            "None",
        ),
    ),
    (
        "a text that is handed to `lint` of the server for agents",
        &[
            ("1 MiB", "LONGEST_TEXT: usize = 1 << 20", "src/cli/mcp/tools.rs"),
            ("10,000 relations", "MOST_RELATIONS: usize = 10_000", "src/cli/mcp/tools.rs"),
        ],
        In("tests/mcp.rs", "a_text_is_looked_through_as_the_command_does"),
    ),
    (
        "a formula",
        &[
            ("1 MiB", "LONGEST: usize = 1 << 20", "src/latex/lexer.rs"),
            ("nested 100 deep", "DEEPEST: usize = 100", "src/latex/refusal.rs"),
        ],
        By(
            || {
                let long = file("-kx", &claim(0, &("x=".to_owned() + &"x+".repeat(1 << 19) + "x")));
                let deep = file("-kx", &claim(0, &format!("x={}x{}", "(".repeat(101), ")".repeat(101))));
                assert!(told(&deep).contains("nesting is too deep"));
                told(&long)
            },
            "1048576 is the limit",
        ),
    ),
    (
        "macros of a paper",
        &[
            ("4 million tokens", "MOST_TOKENS: usize = 4_000_000", "src/paper/token.rs"),
            ("a million calls", "MOST_CALLS: usize = 1_000_000", "src/paper/macros.rs"),
            ("200 deep", "DEEPEST: usize = 200", "src/paper/macros.rs"),
            ("9 arguments", "MOST_ARGUMENTS: usize = 9", "src/paper/macros/rest.rs"),
        ],
        By(|| of_paper("\\def\\a{x+\\a}\n\\[ \\a=1 \\]\n"), "does not end"),
    ),
    (
        "a formula of a paper",
        &[("100,000 tokens", "LONGEST_FORMULA: usize = 100_000", "src/paper/document.rs")],
        By(|| of_paper(&format!("\\[ {}x=1 \\]\n", "x+".repeat(60_000))), "longer than 100000 signs, and is not read"),
    ),
    (
        "a motion that comes from another",
        &[("100 others", "MOST_MAPS: usize = 100", "src/derivation/motions.rs")],
        By(
            || {
                let from = |i: usize| if i == 0 { "a".to_owned() } else { format!("b{}", i - 1) };
                let one = |i| format!("[[trajectory]]\nid = 'b{i}'\nfrom = '{}'\nmap = {{ 'x' = '2x' }}\n", from(i));
                told(&file("-kx", &((0..102).map(one).collect::<String>() + &claim(0, "x<2"))))
            },
            "through more than 100 others",
        ),
    ),
    (
        "assumptions of a claim",
        &[
            ("200 formulas", "MOST_ASSUMED: usize = 200", "src/derivation/claims.rs"),
            ("more than 32", "MOST_ASSUMED: usize = 32", "src/weight/separation/assumptions.rs"),
            ("100,000", "MOST_TOGETHER: usize = 100_000", "src/weight/separation/assumptions.rs"),
        ],
        By(
            || {
                let assumed = |n: usize| (0..n).map(|i| format!("'x>-{i}'")).collect::<Vec<_>>().join(", ");
                let assuming = |n| file("-kx", &(claim(0, "x<2") + &format!("assuming = [{}]\n", assumed(n))));
                assert!(!told(&assuming(200)).contains("at most 200"));
                assert!(told(&assuming(32)).contains(r#""need":"#));
                assert!(!told(&assuming(33)).contains(r#""need":"#));
                told(&assuming(201))
            },
            "a claim assumes at most 200 formulas",
        ),
    ),
    (
        "a formula that `init` drafts",
        &[("400 names", "MOST_NAMES: usize = 400", "src/paper/draft/readings.rs")],
        By(
            || {
                let text = format!("\\[ a={} \\]\n", "b ".repeat(401));
                let source = Source { path: "x.tex".to_owned(), text };
                let paper = rederive::paper::parse(source, String::new()).expect("a paper");
                rederive::paper::draft(&paper, "x").text
            },
            "more than 400 names",
        ),
    ),
    (
        "claims and motions",
        &[("100,000 pairs", "MOST_PAIRS: usize = 100_000", "src/derivation/claims.rs")],
        By(
            || {
                let motions = (0..400).map(|i| MOTION.replace("'a'", &format!("'a{i}'"))).collect::<String>();
                told(&file("-kx", &(motions + &(0..250).map(|i| claim(i, "x<2")).collect::<String>())))
            },
            "more than 100000 pairs",
        ),
    ),
    (
        "altered formulas",
        &[
            ("1500 of a formula", "MOST_EDITS: usize = 1500", "src/weight/variant/generate.rs"),
            ("400,000 nodes", "MOST_NODES: usize = 400_000", "src/weight/variant/generate.rs"),
            ("5 million", "MOST_NODES_OF_A_FILE: usize = 5_000_000", "src/weight/variant/mod.rs"),
        ],
        By(
            || {
                let sum: Vec<String> = (1..400).map(|i| format!("\\sin({i}x)")).collect();
                told(&file("-kx", &claim(0, &format!("x<1000+{}", sum.join("+")))))
            },
            "not looked at",
        ),
    ),
    (
        "corrections",
        &[
            ("4000 pairs of edits", "MOST_PAIRS: usize = 4_000", "src/weight/variant/erratum.rs"),
            ("8 million nodes", "MOST_INSERTED_NODES: usize = 8_000_000", "src/weight/variant/erratum.rs"),
            ("first 200 claims", "MOST_CORRECTED: usize = 200", "src/weight/variant/erratum.rs"),
        ],
        By(
            || {
                let claims: String = (0..204).map(|i| claim(i, r"\dot x=-2kx")).collect();
                let told = told(&file("-kx", &claims));
                format!("{} are corrected", told.matches(r#""corrections":[{"#).count())
            },
            "200 are corrected",
        ),
    ),
    (
        "a motion",
        &[
            ("40,000 steps", "MAX_STEPS: usize = 40_000", "src/flow/field.rs"),
            ("300 million numbers", "MOST_NUMBERS: usize = 300_000_000", "src/sampled/systems.rs"),
        ],
        By(|| told(&file(r"k\sin(x+t)", &claim(0, "x<3")).replace("span = [0, 1]", "span = [0, 1e12]")), "40000 steps"),
    ),
    (
        "families",
        &[
            ("10\u{2079} numbers of members", "LARGEST_FAMILY: u64 = 1_000_000_000", "src/derivation/family.rs"),
            ("a million members are tried", "MOST_MEMBERS: u64 = 1_000_000", "src/families/budget.rs"),
            ("300 million steps", "MOST_STEPS: u64 = 300_000_000", "src/families/budget.rs"),
            ("100 million rejected", "MOST_NUMBERS: u64 = 100_000_000", "src/families/budget.rs"),
            ("10,000 draws", "MOST_DRAWS: u64 = 10_000", "src/families/member.rs"),
            ("on 24 of them", "MOST: u64 = 24", "src/families/separate.rs"),
        ],
        By(
            || {
                let many = "vary = { 'k' = { from = 1, to = 2, count = 1000000001 } }";
                assert!(told(&of_family(many)).contains("at most 1000000000 members"));
                told(&of_family("vary = { 'k' = { uniform = [1, 2] } }\ndraws = 3\nseed = 1\nwhere = ['k>2']"))
            },
            "of 10000 draws for member 1",
        ),
    ),
    (
        "what varies between two samples",
        &[("20,000 times", "MOST: usize = 20_000", "src/flow/rapid.rs")],
        In("tests/budgets.rs", "what_varies_rapidly_is_looked_at_for_a_while"),
    ),
    (
        "an enclosure",
        &[
            ("10,000 validated steps", "MAX_STEPS: usize = 10_000", "src/flow/enclosure/step.rs"),
            ("100 unknowns", "MOST_UNKNOWNS: usize = 100", "src/flow/enclosure/step.rs"),
        ],
        By(
            || told(&file(r"-kx+\cos t", &claim(0, "x<3")).replace("span = [0, 1]", "span = [0, 1e5]")),
            "the limit of 10000 is too few for the span",
        ),
    ),
    (
        "ranges",
        &[("20,000 cells", "MOST_CELLS: usize = 20_000", "src/boxes/subdivide.rs")],
        By(
            || {
                let formula = r"\sin^2(kx)+\cos^2(kx)+x^2-x^2<1.000000001";
                told(&file("-kx", &(claim(0, formula) + "ranges = { 'k' = [0, 3], 'x' = [0, 3] }\n")))
            },
            "cells",
        ),
    ),
    ("an identity", &[], In("tests/starved.rs", "limits_of_the_page_are_reached_by_an_input")),
];

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The rows of the first table of the page.
fn page() -> Vec<(String, String)> {
    let page = read("docs/limits.md");
    let rows = page.lines().skip_while(|line| !line.starts_with("| stage |")).skip(2);
    let cells = |line: &str| line.trim_matches('|').split_once('|').map(|(a, b)| (a.trim().into(), b.trim().into()));
    rows.take_while(|line| line.starts_with('|')).filter_map(cells).collect()
}

#[test]
fn the_table_says_what_the_source_says() {
    let page = page();
    let stages: Vec<&str> = page.iter().map(|(stage, _)| stage.as_str()).collect();
    assert_eq!(stages, ROWS.iter().map(|row| row.0).collect::<Vec<_>>());
    for ((stage, limit), (_, constants, reached)) in page.iter().zip(ROWS) {
        for (words, constant, path) in *constants {
            assert!(limit.contains(words), "the row of {stage} does not say `{words}`");
            let declared = format!("const {constant};");
            assert!(read(path).contains(&declared), "{path} has no `{declared}`, as {stage} says");
        }
        if let In(path, test) = reached {
            assert!(read(path).contains(&format!("fn {test}()")), "{path} has no test `{test}`");
        }
    }
}

#[test]
fn every_limit_is_reached_and_told() {
    for (stage, _, reached) in ROWS {
        if let By(input, words) = reached {
            let told = input();
            assert!(told.contains(words), "{stage}: {}", told.chars().take(3000).collect::<String>());
        }
    }
}
