//! A handmade account with verdicts of every kind, for the tests of the reports. It is there in builds with debug assertions
//! only: the program has no verdicts but those that it found.

use super::conditions::{
    AssumptionAccount, ConditionName, ConditionsAccount, Explanation, Join, Need, Rival, Separation,
};
use super::{Account, ClaimAccount, Measurement, PairAccount, TrajectoryAccount};
use reason::{Reason, Sign, SignsAlong};
use units::{Term, UnitAccount, UnitVerdict, UnitsAccount};
use verdict::{Enclosed, Evidence, Exclusion, Finding, Outcome, Possible, Proof, Residual, Strength, Verdict, Witness};

/// The derivation file that the account belongs to.
pub const FILE: &str = r"
[derivation]
title = 'A spring'
concerns = 'Nobody, *Springs* (1900)'
remark = 'Made up.'

[conventions]
sign = 'x grows to the right'

[symbols]
't' = { role = 'time', unit = 's' }
'x' = { role = 'state', unit = 'm', says = 'elongation' }
'v' = { role = 'state', unit = 'm/s' }
'k' = { role = 'parameter', positive = true }

[system.spring]
states = ['x', 'v']
equations = ['\dot x=v', '\dot v=x']

[[trajectory]]
id = 'pulled'
title = 'Pulled and let go'
system = 'spring'
initial = { 'x' = 1, 'v' = 0 }
parameters = { 'k' = 2.5 }
span = [0, 10]

[[trajectory]]
id = 'pushed'
system = 'spring'
initial = { 'x' = 0, 'v' = 1 }
parameters = { 'k' = 2.5 }
span = [0, 10]

[[claim]]
id = 'motion'
says = 'Velocity is the rate of x'
place = 'Eq. (1)'
label = 's1'
assuming = ['k>0']
always = ['\dot x=v']
follows-from = ['spring']
expect = 'holds'

[[claim]]
id = 'rest'
says = 'It rests | everywhere <sic>'
always = ['v=0, x=0']
remark = 'The wrong claim.'
expect = { fails = ['pulled'], holds = ['pushed'] }

[[claim]]
id = 'far'
says = 'It goes far'
[[claim.reading]]
id = 'near'
says = 'if far is near'
never = ['x=7']
[[claim.reading]]
id = 'sky'
says = 'if far is the sky'
defined = ['x']
expect = 'not-applicable'

[[measure]]
id = 'reach'
says = 'how far it goes'
formula = 'x'
at = 'v=0'
unit = 'm'
";

fn pair(trajectory: &str, outcome: Outcome, evidence: Evidence, expected: Option<&'static str>) -> PairAccount {
    PairAccount { trajectory: trajectory.into(), verdict: verdict(outcome, evidence), expected, discrimination: None }
}

/// A verdict with this outcome.
fn verdict(outcome: Outcome, evidence: Evidence) -> Verdict {
    let (known, strength) = match outcome {
        Outcome::Holds(strength) => (Possible::TRUE, strength),
        Outcome::Fails(strength) => (Possible::FALSE, strength),
        Outcome::NotApplicable(strength) => (Possible::VOID, strength),
        Outcome::Undecided => (Possible::ANY, Strength::Sampled),
    };
    let mut out = Verdict::of(Finding::sampled(known, evidence));
    match strength {
        Strength::Sampled => {}
        Strength::Enclosed => out.enclose(0, known, |e| {
            e.enclosed.get_or_insert(Enclosed { places: 1, gap: 0.0, scale: 1.0 });
        }),
        Strength::Proved => out.prove(0, known, |e| {
            e.proof.get_or_insert_with(Proof::default);
        }),
    }
    out
}

fn holds(max: f64) -> Evidence {
    let residual = Some(Residual { max, bound: 3.0e-13, at: 12.5 });
    Evidence { samples: 400, residual, ..Evidence::default() }
}

fn fails(max: f64) -> Evidence {
    let witness = Witness {
        t: 2.25,
        formula: "v".into(),
        left: 0.25 + max,
        right: 0.25,
        bound: 1.5e-14,
        values: vec![("v".into(), 0.25 + max), ("x".into(), f64::NAN)],
    };
    Evidence { witness: Some(witness), residual: Some(Residual { max, bound: 1.5e-14, at: 2.25 }), ..holds(max) }
}

fn reason(text: &str) -> Evidence {
    Evidence { reason: Some(Reason::quoted(text)), ..Evidence::default() }
}

fn trajectory(id: &str, title: &str) -> TrajectoryAccount {
    TrajectoryAccount {
        id: id.into(),
        title: title.into(),
        span: (0.0, 10.0),
        source: "integrated",
        given: vec![("k".into(), vec![2.5]), ("x".into(), vec![1.0])],
        steps: 42,
        error: 2.0e-15,
        problem: None,
    }
}

fn claim(id: &str, reading: Option<&str>, says: &str, formula: &str, results: Vec<PairAccount>) -> ClaimAccount {
    ClaimAccount {
        id: id.into(),
        reading: reading.map(Into::into),
        says: says.into(),
        place: (id == "motion").then(|| "Eq. (1)".into()),
        formulas: vec![formula.into()],
        assumptions: if id == "motion" { vec!["k>0".into()] } else { Vec::new() },
        remark: (id == "rest").then(|| "The wrong claim.".into()),
        identity: None,
        conditions: if id == "motion" { conditions() } else { ConditionsAccount::default() },
        results,
        families: Vec::new(),
        region: None,
        alone: None,
        variants: None,
        drawn: None,
    }
}

/// The account.
pub fn account() -> Account {
    let sampled = Outcome::Holds(Strength::Sampled);
    let refuted = Outcome::Fails(Strength::Sampled);
    let gap = Exclusion {
        from: 1.0,
        to: 1.5,
        reason: std::sync::Arc::new(Reason::quoted("the denominator x is too close to 0")),
    };
    Account {
        distributions: Vec::new(),
        trajectories: vec![trajectory("pulled", "Pulled and let go"), trajectory("pushed", "pushed")],
        claims: vec![
            claim(
                "motion",
                None,
                "Velocity is the rate of x",
                r"\dot x=v",
                vec![
                    pair("pulled", sampled, holds(1.2e-14), Some("holds")),
                    pair(
                        "pushed",
                        sampled,
                        Evidence {
                            excluded: vec![gap],
                            branch: Some(SignsAlong::Throughout(Sign::Plus)),
                            ..holds(0.0)
                        },
                        Some("holds"),
                    ),
                ],
            ),
            claim(
                "rest",
                None,
                "It rests | everywhere <sic>",
                "v=0, x=0",
                vec![
                    pair("pulled", refuted, fails(0.5), Some("fails")),
                    pair("pushed", refuted, fails(1.0), Some("holds")),
                ],
            ),
            claim(
                "far",
                Some("near"),
                "if far is near",
                "x=7",
                vec![
                    pair("pulled", Outcome::Undecided, reason("not seen at 400 samples"), None),
                    pair("pushed", Outcome::Undecided, reason("not seen at 400 samples"), None),
                ],
            ),
            claim(
                "far",
                Some("sky"),
                "if far is the sky",
                "x",
                vec![
                    pair(
                        "pulled",
                        Outcome::NotApplicable(Strength::Sampled),
                        reason("`k>0` is unmet at t = 0: k = -1"),
                        Some("not-applicable"),
                    ),
                    pair("pushed", sampled, holds(0.0), Some("not-applicable")),
                ],
            ),
        ],
        pictures: Vec::new(),
        measurements: vec![
            Measurement {
                measure: "reach".into(),
                trajectory: "pulled".into(),
                values: vec![(0.0, 1.0, 1e-15), (3.0, -1.0, 2e-15)],
                reason: None,
            },
            Measurement {
                measure: "reach".into(),
                trajectory: "pushed".into(),
                values: Vec::new(),
                reason: Some(Reason::quoted("v=0 does not happen")),
            },
        ],
        units: UnitsAccount {
            formulas: vec![
                units("claim", "motion", r"\dot x=v", UnitVerdict::Consistent),
                units(
                    "claim",
                    "rest",
                    "v=0, x=v",
                    UnitVerdict::Inconsistent {
                        relation: "are compared".into(),
                        terms: Box::new([term("x", "m"), term("v", "m/s")]),
                    },
                ),
                units("symbol", "k", "2k", UnitVerdict::NotChecked { reason: "k has no unit".into() }),
            ],
            missed: Vec::new(),
        },
    }
}

fn condition(id: Option<&str>, formula: &str, negated: bool) -> ConditionName {
    let says = id.map(|_| "it | is so".to_owned());
    ConditionName { id: id.map(Into::into), formula: formula.into(), says, negated }
}

fn conditions() -> ConditionsAccount {
    let one = |c: ConditionName| Explanation { conditions: vec![c], join: Join::And };
    let two = vec![condition(None, "x>0", false), condition(Some("slow"), "v<1", true)];
    let separation = Separation {
        holds: vec!["pulled".into()],
        fails: vec!["pushed".into()],
        explanation: Some(one(condition(Some("slow"), "v<1", false))),
        rivals: vec![
            Rival { explanation: one(condition(None, "x=0", false)), differ_on: vec!["pushed".into()] },
            Rival { explanation: Explanation { conditions: two, join: Join::Or }, differ_on: Vec::new() },
        ],
        more_rivals: 3,
        sufficient: Vec::new(),
        necessary: Vec::new(),
        possible: Vec::new(),
        tried: 12,
        undecided: 1,
    };
    let assumption = |text: &str, need, on: &[&str]| AssumptionAccount {
        text: text.into(),
        need,
        on: on.iter().map(|t| (*t).to_owned()).collect(),
    };
    let assumptions = vec![
        assumption("k>0", Need::Needed, &["pulled"]),
        assumption("k>1", Need::NotNeeded, &["pulled", "pushed"]),
        assumption("k>2", Need::Untested, &[]),
    ];
    ConditionsAccount { separation: Some(separation), assumptions }
}

fn term(latex: &str, unit: &str) -> Term {
    Term { latex: latex.into(), unit: unit.into() }
}

fn units(kind: &'static str, of: &str, formula: &str, verdict: UnitVerdict) -> UnitAccount {
    UnitAccount { kind, of: of.into(), formula: formula.into(), verdict, expected: false }
}
