//! Runs that may take a fraction of the usual work: each piece ends somewhere else, and no verdict becomes another one.
//!
//! As a database is tried with every allocation failing once, here the work ends at a few dozen places of each kind of piece. What is told then
//! is what is told with enough, or *undecided*, for this reason.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::Instant;

use rederive::check::{Limits, Outcome};
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
            let is_weaker = full.is_some_and(|full| now.word == full.word && now.strength <= full.strength);
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

/// The rows of the page of limits that a small file reaches, with little work allowed: what is said names the row.
#[test]
fn limits_of_the_page_are_reached_by_a_file() {
    let head = "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = { role = 'time' }\n'x' = { role = 'state' }\n\
                'k' = { role = 'parameter' }\n";
    let motion = |rate: &str, end: u32| {
        format!(
            "[system.s]\nstates = ['x']\nequations = ['\\dot x={rate}']\n[[trajectory]]\nid = 'a'\nsystem = 's'\n\
             parameters = {{ 'k' = 1 }}\ninitial = {{ 'x' = 1 }}\nspan = [0, {end}]\n"
        )
    };
    let claim = |id: usize, formula: &str| format!("[[claim]]\nid = 'c{id}'\nsays = 's'\nalways = ['{formula}']\n");
    let nested =
        |id: usize| claim(id, &format!(r"\sin(\cos(\sin(\cos(x+{id}))))=\frac{{d}}{{dt}}\sin(\cos(\sin x))+{id}"));
    let many = |count: usize, one: &dyn Fn(usize) -> String| (0..count).map(one).collect::<String>();
    let cases = [
        (
            "compiling the claims of a file",
            motion("-kx", 1) + &many(1500, &|id| claim(id, &format!("x={id}+x-e^{{x}}"))),
        ),
        ("the file takes more than about 0.03 s", motion("-kx", 1) + &many(150, &nested)),
        ("computing a motion", motion(r"-k\sin(x)\cos(t)", 3000) + &claim(0, "x<2")),
    ];
    for (row, text) in cases {
        let ask =
            Ask { limits: Limits { work: "0.001".parse().expect("a number"), ..Limits::default() }, ..Ask::default() };
        let session = Session::open("x.toml", &(head.to_owned() + &text)).expect("it is read with enough");
        let told = match session.check(&ask, &|_, _| {}) {
            Ok(found) => found.json(),
            Err(Failure::Problems(problems)) => rederive::diag::render(&problems, false),
            Err(other) => panic!("{row}: {other:?}"),
        };
        assert!(told.contains(&format!("work limit: {row}")), "{row}: {told}");
        assert!(told.contains("--work 0.01 would allow ten times as much"), "{told}");
    }
}
