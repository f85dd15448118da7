//! Runs that may take a fraction of the usual work: each piece ends somewhere else, and no verdict becomes another one.
//!
//! As a database is tried with every allocation failing once, here the work ends at a few dozen places of each kind of piece. What is told then
//! is what is told with enough, or *undecided*, for this reason.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::Instant;

use rederive::check::{Limits, Outcome};
use rederive::diag::Source;
use rederive::{Ask, Failure, Findings, Rigor, Session, Strength};

/// Fractions of the usual work, from nearly none.
const SHARES: [&str; 5] = ["0.001", "0.003", "0.01", "0.03", "0.1"];

fn session(name: &str) -> Session {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations").join(name);
    let text = fs::read_to_string(path).expect("it is there");
    Session::open(name, &text).unwrap_or_else(|found| panic!("{}", rederive::diag::render(&found, false)))
}

/// What is said of a claim on something, or for all values: the word, how strong that is, and why it is open.
#[derive(Clone, Debug)]
struct Said {
    word: String,
    strength: u8,
    why: String,
}

/// All that is said, by claim and what it is tried on.
fn said(found: &Findings) -> BTreeMap<String, Said> {
    let rank = |of: Strength| match of {
        Strength::Sampled => 1,
        Strength::Enclosed => 2,
        Strength::Proved => 3,
    };
    let tried = found.all().into_iter().map(|of| {
        let on = of.trajectory.or(of.family).unwrap_or_default();
        let (word, strength) = match of.outcome {
            Outcome::Holds(strength) => ("holds", rank(strength)),
            Outcome::Fails(strength) => ("fails", rank(strength)),
            Outcome::NotApplicable(strength) => ("does not apply", rank(strength)),
            Outcome::Undecided => ("undecided", 0),
        };
        let why = of.reason.unwrap_or_default();
        (
            format!("{}/{} on {on}", of.claim.id, of.claim.reading.unwrap_or_default()),
            Said { word: word.to_owned(), strength, why },
        )
    });
    let proved = found.account().claims.iter().filter_map(|of| {
        let step = of.identity.as_ref()?;
        let why = step.reason.as_ref().map(ToString::to_string).unwrap_or_default();
        let name = format!("{}/{} for all values", of.id, of.reading.clone().unwrap_or_default());
        Some((name, Said { word: step.standing().to_owned(), strength: 0, why }))
    });
    tried.chain(proved).collect()
}

/// Tries a file with each share of the work: how many verdicts are open that are decided with enough.
fn starve(name: &str) -> usize {
    let session = session(name);
    let whole =
        said(&session.check(&Ask { rigor: Rigor::Enclosed, ..Ask::default() }, &|_, _| {}).expect("it is checked"));
    let mut open = 0;
    for share in SHARES {
        let limits = Limits { work: share.parse().expect("a number"), ..Limits::default() };
        let found = match session.check(&Ask { rigor: Rigor::Enclosed, limits, ..Ask::default() }, &|_, _| {}) {
            Ok(found) => {
                let defects: Vec<_> = found.account().defects().collect();
                assert!(defects.is_empty(), "{name} {share}: {defects:?}");
                said(&found)
            }
            Err(Failure::Problems(problems)) => {
                let told = rederive::diag::render(&problems, false);
                assert!(told.contains("work limit"), "{name} {share}: {told}");
                continue;
            }
            Err(other) => panic!("{name} {share}: {other:?}"),
        };
        for (of, now) in found {
            // Of what is no claim for all values nothing is said there, unless it was not found out.
            let full = whole.get(&of);
            let is_weaker = full.is_some_and(|full| {
                let unreplayed = now.word.strip_suffix(" unreplayed");
                (now.word == full.word || unreplayed == Some(&full.word)) && now.strength <= full.strength
            });
            let is_open = now.word == "undecided" && !now.why.is_empty();
            assert!(is_weaker || is_open, "{name} {share}: {of} was {full:?}, is {now:?}");
            open += usize::from(!is_weaker);
        }
    }
    open
}

#[test]
fn with_less_work_less_is_decided_and_nothing_otherwise() {
    let files = ["pendulum.toml", "circuit.toml", "kepler-laws.toml"];
    let open: usize = files.map(starve).iter().sum();
    assert!(open > 100, "{open}");
}

/// Of one motion the work ended after it was known, and what belongs to the others was taken for what belongs to it.
#[test]
fn what_belongs_to_one_motion_is_not_that_of_another() {
    let limits = Limits { work: "0.1".parse().expect("a number"), ..Limits::default() };
    let ask = Ask { rigor: Rigor::Sampled, limits, ..Ask::default() };
    let found = session("deriglazov-comment.toml").check(&ask, &|_, _| {}).expect("it ends");
    assert!(found.account().defects().next().is_none());
}

/// A claim that presupposes something has its parts also where nothing was tried: what is proved is not what it presupposes.
#[test]
fn what_was_not_tried_is_no_more_than_what_is_proved_of_it() {
    let session = session("circuit.toml");
    let limits = Limits { deadline: Some(Instant::now()), ..Limits::default() };
    let found = session.check(&Ask { limits, ..Ask::default() }, &|_, _| {}).expect("it is checked");
    let said = said(&found);
    let of: Vec<&Said> = said.iter().filter(|(name, _)| name.starts_with("resonance/ on")).map(|(_, of)| of).collect();
    assert!(of.len() == 3 && of.iter().all(|of| of.word == "undecided"), "{of:?}");
}

/// A derivation of one motion, with symbols, equations, a span and claims of a test.
fn file(symbols: &str, motion: &str, claims: &str) -> String {
    format!(
        "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = {{ role = 'time' }}\n'x' = {{ role = 'state' }}\n\
         'k' = {{ role = 'parameter' }}\n{symbols}{motion}{claims}"
    )
}

fn motion(rate: &str, end: u32) -> String {
    format!(
        "[system.s]\nstates = ['x']\nequations = ['\\dot x={rate}']\n[[trajectory]]\nid = 'a'\nsystem = 's'\n\
         parameters = {{ 'k' = 1 }}\ninitial = {{ 'x' = 1 }}\nspan = [0, {end}]\n"
    )
}

fn claim(id: usize, formula: &str) -> String {
    format!("[[claim]]\nid = 'c{id}'\nsays = 's'\nalways = ['{formula}']\n")
}

fn many(count: usize, join: &str, one: impl Fn(usize) -> String) -> String {
    (0..count).map(one).collect::<Vec<_>>().join(join)
}

/// Many motions, each with formulas of its own: none takes much to read.
fn many_motions() -> String {
    let one = |i: usize| {
        format!(
            "[[trajectory]]\nid = 'a{i}'\nsystem = 's'\nparameters = {{ 'k' = '\\sin({i})' }}\n\
             initial = {{ 'x' = '\\cos({i})' }}\nspan = [0, 1]\n"
        )
    };
    file("", &motion("-kx", 1), &(many(4000, "", one) + &claim(0, "x<3")))
}

/// A motion of many states, which takes little to compute, and much to enclose (Lorenz's system of 1996).
fn many_states() -> String {
    let n = 24;
    let symbols = many(n, "", |i| format!("'x_{{{i}}}' = {{ role = 'state' }}\n"));
    let rate = |i: usize| {
        let [after, before, far] = [i + 1, i + n - 1, i + n - 2].map(|k| k % n);
        format!(r"\dot x_{{{i}}}=(x_{{{after}}}-x_{{{far}}})x_{{{before}}}-x_{{{i}}}+8")
    };
    let motion = format!(
        "[system.s]\nstates = [{}]\nequations = ['{}']\n[[trajectory]]\nid = 'a'\nsystem = 's'\ninitial = {{ {} }}\n\
         span = [0, 1]\n",
        many(n, ", ", |i| format!("'x_{{{i}}}'")),
        many(n, ", ", rate),
        many(n, ", ", |i| format!("'x_{{{i}}}' = 8.{i:02}")),
    );
    let head = "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = { role = 'time' }\n";
    format!("{head}{symbols}{motion}{}", claim(0, "x_{1}<100"))
}

/// What is told of a file, or of a paper, with a share of the usual work.
fn told(name: &str, text: &str, share: &str) -> String {
    let limits = Limits { work: share.parse().expect("a number"), ..Limits::default() };
    if name.ends_with(".tex") {
        let source = Source { path: name.to_owned(), text: text.to_owned() };
        let paper = rederive::paper::parse(source, String::new()).expect("a paper");
        return rederive::lint::lint_text(&paper, &rederive::lint::lint(&paper, &limits));
    }
    let session = match meter::under(&limits, || Session::open(name, text)).expect("no defect") {
        Ok(session) => session,
        Err(problems) => return rederive::diag::render(&problems, false),
    };
    match session.check(&Ask { rigor: Rigor::Enclosed, limits, ..Ask::default() }, &|_, _| {}) {
        Ok(found) => found.json(),
        Err(Failure::Problems(problems)) => rederive::diag::render(&problems, false),
        Err(other) => panic!("{name}: {other:?}"),
    }
}

/// Every row of the page of limits, and the total, is reached by an input, with little work allowed: what is told names the row.
#[test]
fn limits_of_the_page_are_reached_by_an_input() {
    let waves = many(79, "+", |i| format!(r"\cos(e^{{{}x}})\sin({}x)", i % 3 + 1, i + 1));
    let nested =
        |id: usize| claim(id, &format!(r"\sin(\cos(\sin(\cos(x+{id}))))=\frac{{d}}{{dt}}\sin(\cos(\sin x))+{id}"));
    let sum = |terms| many(terms, "+", |i| format!(r"\sin({}x)\cos(\frac{{x}}{{{}}})", i + 1, i + 2)) + "<1000";
    let family = "[[family]]\nid = 'f'\nof = 'a'\nvary = { 'k' = { from = 1, to = 2, count = 2000 } }\n";
    let of_family = claim(0, "x<2") + "families = ['f']\n";
    let of_ranges =
        claim(0, r"\sin^2(kx)+\cos^2(kx)+x^2-x^2<1.000000001") + "ranges = { 'k' = [0, 3], 'x' = [0, 3] }\n";
    let derivation = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations").join(name);
        fs::read_to_string(path).expect("it is there")
    };
    let roots = r"\[ \sqrt{x+\sqrt{y+\sqrt{z}}}+\sqrt{y+\sqrt{z+\sqrt{x}}}=\sqrt{x+y+z+\sqrt{xyz+\sqrt{x+y}}}\sqrt[3]{z+\sqrt{x}} \]";
    let cases: [(&str, &str, String, &str); 12] = [
        ("reading a file", "x.toml", many_motions(), "0.001"),
        ("reading a formula", "x.toml", file("", &motion("-kx", 1), &claim(0, &sum(150))), "0.001"),
        (
            "compiling the claims of a file",
            "x.toml",
            file("", &motion("-kx", 1), &many(1500, "", |id| claim(id, &format!("x={id}+x-e^{{x}}")))),
            "0.001",
        ),
        ("the file", "x.toml", file("", &motion("-kx", 1), &many(150, "", nested)), "0.001"),
        ("computing a motion", "x.toml", file("", &motion(r"-k\sin(x)\cos(t)", 3000), &claim(0, "x<2")), "0.001"),
        (
            "trying a claim on a motion",
            "x.toml",
            file("", &motion(r"-k\sin x+\cos t", 400), &claim(0, &(waves.clone() + "<300"))),
            "0.002",
        ),
        ("proving a claim", "double-pendulum.toml", derivation("double-pendulum.toml"), "0.003"),
        ("enclosing a motion", "x.toml", many_states(), "0.001"),
        ("taking ranges apart", "x.toml", file("", &motion("-kx", 1), &of_ranges), "0.001"),
        ("trying altered formulas", "x.toml", file("", &motion("-kx", 1), &claim(0, &sum(30))), "0.001"),
        ("deciding a step of a paper", "x.tex", roots.to_owned(), "0.001"),
        (
            "trying members of a family",
            "x.toml",
            file("", &motion(r"-k\sin(x)\cos(t)", 300), &(family.to_owned() + &of_family)),
            "0.005",
        ),
    ];
    let page = include_str!("../docs/limits.md");
    let rows = page.lines().skip_while(|line| !line.starts_with("| piece |")).skip(2);
    for row in rows.take_while(|line| line.starts_with('|')) {
        let words = row.split('|').nth(1).unwrap_or_default().trim();
        assert!(cases.iter().any(|case| case.0 == words), "no input reaches `{words}`");
    }
    for (row, name, text, share) in cases {
        let told = told(name, &text, share);
        let line = told.split("work limit: ").find(|line| line.starts_with(row));
        assert!(line.is_some_and(|line| line.contains("--work")), "{row}: {told}");
    }
}
