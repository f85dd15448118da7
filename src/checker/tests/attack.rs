//! Random and mutated steps: none is accepted that makes a fact which a motion refutes.
//!
//! First there are motions, with exact jets; then sequents that are true of them, as they are quantified. Steps are drawn at random, and made from those of
//! true proofs by changing one part. Every fact of every accepted step is tried on the motion, at many times.

use super::formula::*;
use super::numbers::{Jet, Numbers};
use crate::*;
use expr::Op;
use number::Draws;

/// A sequent, a motion that satisfies it, and formulas to draw from.
pub(super) struct Scene {
    pub(super) sequent: Sequent,
    pub(super) motion: Numbers,
    pub(super) formulas: &'static [&'static str],
}

fn of(op: Op, t: f64) -> f64 {
    let mut out = 0.0;
    op.apply(&(), &mut out, &t, &t).map_or(f64::NAN, |()| out)
}

const PARABOLA: Jet = |t| [2.0 - t * t, -2.0 * t, -2.0, 0.0];
const TIME: Jet = |t| [t, 1.0, 0.0, 0.0];
const ZERO: Jet = |_| [0.0; 4];
const FIVE: Jet = |_| [5.0, 0.0, 0.0, 0.0];
const OPPOSITE: Jet = |t| [-t * t, -2.0 * t, -2.0, 0.0];
const CAP: Jet = |t| [1.0 - t * t, -2.0 * t, -2.0, 0.0];
/// 2 + (|1−t|+1−t)³
const LATE: Jet = |t| {
    let s = (2.0 * (1.0 - t)).max(0.0);
    [2.0 + s * s * s, -6.0 * s * s, 24.0 * s, if s > 0.0 { -48.0 } else { 0.0 }]
};
const FLAT: Jet = |t| {
    if t <= 0.0 {
        return [0.0; 4];
    }
    let (e, u) = (of(Op::Exp, -1.0 / t), 1.0 / t);
    let (u3, u4) = (u * u * u, u * u * u * u);
    [e, e * u * u, e * (u4 - 2.0 * u3), e * (u3 * u3 - 6.0 * u * u4 + 6.0 * u4)]
};
const COSINE: Jet = |t| [of(Op::Cos, t), -of(Op::Sin, t), -of(Op::Cos, t), of(Op::Sin, t)];
const SINE: Jet = |t| [of(Op::Sin, t), of(Op::Cos, t), -of(Op::Sin, t), -of(Op::Cos, t)];
const SHIFTED: Jet = |t| [t - 1.0, 1.0, 0.0, 0.0];
/// (t−1)|t−1|/2
const KINKED: Jet = |t| [(t - 1.0) * (t - 1.0).abs() / 2.0, (t - 1.0).abs(), (t - 1.0).signum(), 0.0];
/// 0 before 1, and then (t−1)³
const RISING: Jet = |t| {
    let s = (t - 1.0).max(0.0);
    [s * s * s, 3.0 * s * s, 6.0 * s, if s > 0.0 { 6.0 } else { 0.0 }]
};

pub(super) fn scenes() -> Vec<Scene> {
    let motion =
        |functions: &[(&'static str, Jet)]| Numbers { functions: functions.to_vec(), constants: vec![("a", 2.0)] };
    let with_a = |s: Sequent| s.constant("a", ConstantSign::Positive);
    let floor = "x-1/2+atan2(sin(2*pi*x),-cos(2*pi*x))/(2*pi)";
    let near = |s: Sequent| s.selector("t^2<1");
    let mut claimed = with_a(sequent("x,z", 2, "z'(0)=0").instant("0").instant("2").selector("x>1"));
    claimed.claims.push(Claimed {
        name: "c".into(),
        selectors: vec![rel("x>1")],
        hypotheses: vec![],
        says: rel("z=2"),
    });
    vec![
        Scene {
            sequent: near(with_a(sequent("x", 2, "N=1").define("N", floor).instant("0").assuming("t*N=t"))),
            motion: motion(&[("x", PARABOLA)]),
            formulas: &["N", "t", "1", "x", "x'", "0", "t*N-t", "N-1", "a", "t*(N-1)", "sin(2*pi*x)", "x(0)"],
        },
        Scene {
            sequent: with_a(sequent("x", 2, "atan2(0,x)=0").instant("0").premise("x(0)^2=x(0)").premise("x(0)*x'=0")),
            motion: motion(&[("x", OPPOSITE)]),
            formulas: &[
                "x",
                "x(0)",
                "1",
                "0",
                "x'",
                "atan2(0,x)",
                "x(0)*x'",
                "x(0)-1",
                "x(0)*(x(0)-1)",
                "1/x(0)",
                "x^2",
            ],
        },
        Scene {
            sequent: with_a(sequent("y,z", 2, "z=1").instant("0").selector("y≥1").assuming("t*z=t")),
            motion: motion(&[("y", CAP), ("z", ZERO)]),
            formulas: &["z", "t", "1", "0", "y", "y'", "z'", "t*z", "t*(z-1)", "z-1", "1/t", "z(0)", "sqrt(y-1)"],
        },
        Scene {
            sequent: with_a(
                sequent("x,z", 2, "z'(0)=0").instant("0").instant("2").selector("x>1").assuming("z=2").system("x'=1"),
            ),
            motion: motion(&[("x", TIME), ("z", LATE)]),
            formulas: &["z", "z'", "z(0)", "z'(0)", "2", "0", "x", "1", "x(0)", "z-2", "z(2)", "x-1", "x*z'", "t"],
        },
        Scene {
            sequent: claimed,
            motion: motion(&[("x", TIME), ("z", LATE)]),
            formulas: &["z", "z'", "z(0)", "z'(0)", "2", "0", "x", "1", "x(2)", "z-2", "x-1"],
        },
        Scene {
            sequent: with_a(
                sequent("y", 2, "y'=y'(1)").instant("1").instant("0").selector("y≤0").assuming("y*y'=y*y'(1)"),
            ),
            motion: motion(&[("y", FLAT)]),
            formulas: &["y", "y'", "y'(1)", "0", "1", "y*(y'-y'(1))", "y'-y'(1)", "1/y", "y(1)", "y(0)", "sqrt(-y)"],
        },
        Scene {
            sequent: with_a(
                sequent("x,y,w", 2, "w'=0").define("r", "sqrt(x^2+y^2)").instant("0").premise("r*w=r").system("w'=1"),
            ),
            motion: motion(&[("x", ZERO), ("y", ZERO), ("w", TIME)]),
            formulas: &["r", "w", "w'", "1", "0", "r*w", "r*(w-1)", "1/r", "x", "y", "x^2+y^2", "r'", "w(0)", "abs(x)"],
        },
        Scene {
            sequent: with_a(sequent("x,y", 2, "y(0)=1").instant("0").premise("x(0)*y(0)=x(0)").premise("x'=1")),
            motion: motion(&[("x", TIME), ("y", FIVE)]),
            formulas: &["x(0)", "y(0)", "1", "0", "x'", "y'", "x", "y", "x(0)*(y(0)-1)", "y(0)-1", "1/x(0)", "1/x"],
        },
        Scene {
            sequent: with_a(
                sequent("x,y", 2, "x^2+y^2=1").instant("0").system("x'=-y").system("y'=x").premise("x(0)=1"),
            ),
            motion: motion(&[("x", COSINE), ("y", SINE)]),
            formulas: &[
                "x",
                "y",
                "x'",
                "y'",
                "x^2+y^2",
                "x(0)",
                "y(0)",
                "0",
                "1",
                "-1",
                "y/x",
                "abs(x)",
                "sqrt(y)",
                "atan2(y,x)",
                "2*x",
                "2*y",
            ],
        },
        Scene {
            sequent: with_a(
                sequent("z,w", 1, "z'(0)=w(0)")
                    .instant("0")
                    .instant("2")
                    .system("z'=abs(w)")
                    .system("w'=1")
                    .selector("w>0")
                    .assuming("z=w^2/2"),
            ),
            motion: motion(&[("z", KINKED), ("w", SHIFTED)]),
            formulas: &[
                "z", "w", "z'", "w'", "w(0)", "z'(0)", "w^2/2", "abs(w)", "0", "1", "z(0)", "w(0)^2/2", "w(2)", "z(2)",
            ],
        },
        Scene {
            sequent: with_a(
                sequent("u,v", 2, "v'=0").instant("0").instant("2").premise("u*v=0").premise("u'*v=0").selector("t#1"),
            ),
            motion: motion(&[
                ("u", RISING),
                ("v", |t| {
                    let s = (1.0 - t).max(0.0);
                    [s * s * s, -3.0 * s * s, 6.0 * s, if s > 0.0 { -6.0 } else { 0.0 }]
                }),
            ]),
            formulas: &[
                "u", "v", "u'", "v'", "u*v", "0", "1", "u'*v", "u*v'", "v(0)", "u(2)", "sqrt(u)", "1/v", "v(2)",
                "abs(v)",
            ],
        },
    ]
}

/// Draws of steps.
struct Dice<'a> {
    draws: Draws,
    formulas: &'a [&'static str],
    facts: u32,
    cases: u32,
    instants: u32,
}

impl Dice<'_> {
    fn below(&mut self, n: u64) -> usize {
        self.draws.below(n) as usize
    }
    fn term(&mut self) -> Term {
        let text = self.formulas[self.below(self.formulas.len() as u64)];
        match self.below(6) {
            0 => {
                let other = self.formulas[self.below(self.formulas.len() as u64)];
                let op = ["*", "+", "-", "/"][self.below(4)];
                term(&format!("({text}){op}({other})"))
            }
            1 => term(["0", "1", "-1", "2"][self.below(4)]),
            _ => term(text),
        }
    }
    fn relation(&mut self) -> Relation {
        let sense = [Sense::Equal, Sense::Equal, Sense::NotEqual, Sense::Less, Sense::LessOrEqual][self.below(5)];
        Relation { left: self.term(), sense, right: self.term() }
    }
    fn equation(&mut self) -> Relation {
        Relation::equal(self.term(), self.term())
    }
    fn fact(&mut self) -> FactId {
        // The newest facts most often.
        let back = self.below(8).min(self.below(40)) as u32;
        FactId(self.facts.saturating_sub(1 + back))
    }
    fn facts(&mut self, most: u64) -> Vec<FactId> {
        (0..self.below(most + 1)).map(|_| self.fact()).collect()
    }
    fn when(&mut self) -> When {
        let base = match self.below(5) {
            0 => When::Chosen,
            1 => When::ChosenOpen,
            2 => When::At(Instant(self.below(u64::from(self.instants)) as u32)),
            _ => When::Always,
        };
        match self.below(3) {
            0 => base.within(CaseId(self.below(u64::from(self.cases)) as u32)),
            _ => base,
        }
    }
    fn given(&mut self) -> Given {
        let at = self.below(3) as u32;
        [Given::System(at), Given::Premise(at), Given::Assumed(at), Given::Selector(at), Given::Claimed(at)]
            [self.below(5)]
    }
    fn instant(&mut self) -> Instant {
        Instant(self.below(u64::from(self.instants)) as u32)
    }
    fn step(&mut self) -> Step {
        match self.below(24) {
            0 | 1 => Step::Given { given: self.given(), because: self.facts(2) },
            2 => Step::HasValue { given: self.given(), need: self.below(3) as u32 },
            3 => Step::ClaimHasValue { need: self.below(2) as u32, within: self.when() },
            4 => Step::Suppose { says: self.relation(), manner: [Manner::AtTimes, Manner::OnIntervals][self.below(2)] },
            5 | 6 => Step::Supposition { case: CaseId(self.below(u64::from(self.cases)) as u32), within: self.when() },
            7 | 8 => Step::Restrict { fact: self.fact(), to: self.when(), because: self.facts(2) },
            9 => Step::Open { because: self.facts(2) },
            10 => Step::Everywhere { because: self.facts(2) },
            11 | 12 => Step::Rate { fact: self.fact() },
            13 | 14 => {
                let terms = (0..self.below(3)).map(|_| (self.fact(), self.term())).collect();
                let modulo = (0..self.below(3)).map(|_| self.fact()).collect();
                Step::Zero { says: self.equation(), multiplier: self.term(), terms, insert: self.facts(2), modulo }
            }
            15 => Step::Discharge { fact: self.fact(), because: self.facts(2) },
            16 => {
                let split = match self.below(2) {
                    0 => Split::Product(self.fact()),
                    _ => Split::Order(self.term(), self.term()),
                };
                Step::Close { within: self.when(), split, branches: self.facts(3), because: self.facts(1) }
            }
            17 => Step::Conserved { of: self.term(), at: self.instant(), rate: self.fact(), because: self.facts(2) },
            18 => Step::Vanishes {
                of: vec![self.term()],
                matrix: vec![vec![self.term()]],
                at: self.instant(),
                rates: vec![self.fact()],
                starts: vec![self.fact()],
                because: self.facts(2),
            },
            19 => {
                let from = if self.below(2) == 0 { None } else { Some(self.fact()) };
                Step::Congruence { says: self.relation(), from, equal: self.facts(2) }
            }
            20 => Step::Sign { says: self.relation(), from: self.facts(3) },
            21 => match self.below(3) {
                0 => Step::Summand { sum: self.fact(), term: self.term(), from: self.facts(2) },
                1 => Step::Injective { fact: self.fact(), from: self.facts(1) },
                _ => Step::Smooth { fact: self.fact(), because: self.facts(2) },
            },
            22 => match self.below(2) {
                0 => Step::Analytic { equations: self.facts(3), because: self.facts(2) },
                _ => Step::Continue { fact: self.fact(), because: self.facts(2) },
            },
            _ => {
                let law = Law::ALL[self.below(Law::ALL.len() as u64)];
                Step::Law { law, of: (0..law.arity()).map(|_| self.term()).collect() }
            }
        }
    }
    /// Steps that belong together: a supposition, a division by a term, the closing of two cases.
    fn steps(&mut self, draft: &Draft) -> Vec<Step> {
        match self.below(9) {
            // From a product that vanishes: one factor, on the rest.
            0 => {
                let (fact, factor) = (self.fact(), self.term());
                let Some(says) = draft.says(fact) else { return vec![] };
                let left = joined(&joined(&says.left, "-", &says.right), r"\frac", &factor);
                vec![Step::Zero {
                    says: Relation::equal(left, Term::integer(0)),
                    multiplier: factor,
                    terms: vec![(fact, Term::integer(1))],
                    insert: self.facts(1),
                    modulo: vec![],
                }]
            }
            // The same in two cases, on intervals or at times.
            1 => {
                let (e, manner) = (self.term(), [Manner::AtTimes, Manner::OnIntervals][self.below(2)]);
                let within = self.when();
                let zero = Term::integer(0);
                let equal = Relation::equal(e.clone(), zero.clone());
                let other = Relation { sense: Sense::NotEqual, ..equal.clone() };
                let (a, b, fact) = (CaseId(self.cases), CaseId(self.cases + 1), self.fact());
                let n = self.facts;
                vec![
                    Step::Suppose { says: equal, manner },
                    Step::Suppose { says: other, manner },
                    Step::Supposition { case: a, within: within.clone() },
                    Step::Supposition { case: b, within: within.clone() },
                    Step::Rate { fact: FactId(n) },
                    Step::Discharge { fact, because: vec![FactId(n + 1)] },
                    Step::Restrict { fact, to: within.clone().within(a), because: vec![] },
                    Step::Close {
                        within,
                        split: Split::Order(e, zero),
                        branches: vec![FactId(n + 3), FactId(n + 4)],
                        because: self.facts(1),
                    },
                ]
            }
            _ => vec![self.step()],
        }
    }
}

fn joined(a: &Term, op: &str, b: &Term) -> Term {
    let mut nodes = a.0.clone();
    let shift = nodes.len() as u32;
    for node in &b.0 {
        nodes.push(match node {
            TermNode::Apply(name, of) => TermNode::Apply(name.clone(), of.iter().map(|i| i + shift).collect()),
            TermNode::Leaf { name, component, rate, at } => {
                TermNode::Leaf { name: name.clone(), component: *component, rate: *rate, at: at.map(|i| i + shift) }
            }
            other => other.clone(),
        });
    }
    let last = nodes.len() as u32 - 1;
    nodes.push(TermNode::Apply(op.to_owned(), vec![shift - 1, last]));
    Term(nodes)
}

pub(super) const TIMES: [f64; 15] =
    [-2.0, -1.5, -1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5];

/// So many steps of a scene: how many are accepted.
pub(super) fn attack(scene: &Scene, seed: u64, steps: usize) -> usize {
    let (mut accepted, mut tried, mut round) = (0, 0, 0);
    while tried < steps {
        round += 1;
        let mut draft = Draft::new(&scene.sequent).expect("a sequent");
        let mut dice = Dice {
            draws: Draws::new(seed.wrapping_mul(1_000_003).wrapping_add(round)),
            formulas: scene.formulas,
            facts: 0,
            cases: 1,
            instants: scene.sequent.instants.len() as u32,
        };
        let mut queue: Vec<Step> = ["Premise", "System", "Assumed", "Selector", "Claimed"]
            .into_iter()
            .flat_map(|list| (0..2).map(move |at| given(list, at)))
            .map(|given| Step::Given { given, because: vec![] })
            .collect();
        for _ in 0..150 {
            if queue.is_empty() {
                queue = dice.steps(&draft);
                queue.reverse();
            }
            let Some(step) = queue.pop() else { continue };
            tried += 1;
            let Ok(made) = draft.push(step.clone()) else { continue };
            accepted += 1;
            dice.cases = draft.cases.len() as u32;
            if let Some(id) = made {
                dice.facts = id.0 + 1;
                if let Some(t) = scene.motion.refutes(&draft, id, &TIMES) {
                    let steps: Vec<String> = (0..=id.0)
                        .map(|i| {
                            format!("{i}: {} {:?}", draft.words(FactId(i)), draft.fact(FactId(i)).unwrap().because())
                        })
                        .collect();
                    panic!("false at {t} (seed {seed}): {step:?}\n{}\n{:?}", steps.join("\n"), scene.sequent.claim);
                }
            }
        }
    }
    accepted
}

fn given(list: &str, at: u32) -> Given {
    match list {
        "Premise" => Given::Premise(at),
        "System" => Given::System(at),
        "Assumed" => Given::Assumed(at),
        "Claimed" => Given::Claimed(at),
        _ => Given::Selector(at),
    }
}

#[test]
fn no_random_step_proves_what_a_motion_refutes() {
    let seeds: u64 = std::env::var("CHECKER_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(1);
    let (mut accepted, mut tried) = (0, 0);
    for seed in 1..=seeds {
        for (i, scene) in scenes().iter().enumerate() {
            accepted += attack(scene, seed * 100 + i as u64, 9_200);
            tried += 9_200;
        }
    }
    assert!(tried >= 100_000 && accepted > tried / 20, "{accepted} of {tried}");
    println!("{accepted} of {tried} steps accepted");
}
