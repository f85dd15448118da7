//! The words: relation by relation, in the order of the paper.

use std::collections::{BTreeMap, BTreeSet};

use expr::{Expr, Graph};
use latex::syntax::{Chain, NodeKind, RelationKind, to_latex};
use paper::{Evidence, Paper, PrintedRelation, PrintedSide, names};
use proof::{Condition, Identity, Known, Options, Premises, Refutation, Wanted, When, identity_test};

use super::desk::{Desk, Given, NotRead, lone_name, pairs_of};
use super::numbers::agreement;
use super::slips::{Slip, size, slips, symbols};
use super::{Judgement, Lint, LintWitness, Word};

/// Questions that may be asked of one paper: what is beyond is *not followed*.
const MOST_QUESTIONS: usize = 60_000;
/// Slips that are tried of one side.
const MOST_SLIPS: usize = 260;
/// Longest side, in bytes, that is looked at.
const LONGEST: usize = 1500;
/// Definitions that a step may need.
const MOST_GIVEN: usize = 14;
/// Relations since a definition, beyond which it may be another one that is meant: it refutes nothing then.
const NEAR: usize = 25;
/// Random points at which a step that is not proved is tried.
const POINTS: usize = 40;
/// Fewest nodes of a side whose slip is told.
const FEWEST_NODES: usize = 5;

/// Signs that say that two sides are equal.
const EQUALS: &[&str] = &["=", r"\equiv", ":=", "=:", r"\coloneqq", r"\triangleq", r"\doteq", "≡"];
/// Signs that say that they are about equal.
const ABOUT: &[&str] = &[
    r"\approx",
    r"\sim",
    r"\simeq",
    r"\propto",
    r"\cong",
    r"\asymp",
    r"\approxeq",
    r"\eqsim",
    "≈",
    "∼",
    "∝",
    r"\ll",
    r"\gg",
    "≪",
    "≫",
    r"\lesssim",
    r"\gtrsim",
    r"\thickapprox",
    r"\thicksim",
];
/// Signs that compare.
const COMPARES: &[&str] = &[
    "<",
    ">",
    r"\le",
    r"\leq",
    r"\ge",
    r"\geq",
    r"\ne",
    r"\neq",
    r"\lt",
    r"\gt",
    r"\leqslant",
    r"\geqslant",
    r"\in",
    r"\notin",
    "≤",
    "≥",
    "≠",
    r"\not=",
    r"\subset",
    r"\subseteq",
];

/// The words on every relation that a paper prints.
pub fn lint(paper: &Paper) -> Lint {
    let evidence = Evidence::of(paper);
    let mut judge = Judge { paper, evidence, given: Vec::new(), section: 0, asked: 0 };
    let judgements = (0..paper.printed.len()).map(|at| judge.relation(at)).collect();
    Lint { judgements }
}

struct Judge<'p> {
    paper: &'p Paper,
    evidence: Evidence,
    /// What is defined in this section so far, the latest last.
    given: Vec<Given>,
    section: usize,
    asked: usize,
}

/// What became of a step.
enum Step {
    /// Proved, with these relations.
    Follows(Vec<usize>),
    /// Not proved, and true at random points.
    Numbers,
    /// Refuted, and one slip away from what holds.
    Wrong(Box<WrongStep>),
    /// Nothing decides it; the names that have no definition.
    Open(Vec<String>),
    NotRead(NotRead),
}

/// What became of the steps of a relation.
#[derive(Default)]
struct Tally {
    /// Names that nothing defines.
    open: Vec<String>,
    /// Why a step was not read.
    unread: Option<NotRead>,
    /// Steps that are proved.
    follows: usize,
    /// Steps that hold in numbers.
    numbers: usize,
    /// Whether a name is defined.
    defines: bool,
    /// The relation that defined it before.
    anew: Option<usize>,
}

struct WrongStep {
    witness: LintWitness,
    instead: String,
    with: Vec<usize>,
}

impl Judge<'_> {
    fn relation(&mut self, at: usize) -> Judgement {
        let relation = &self.paper.printed[at];
        if relation.section != self.section {
            self.section = relation.section;
            self.given.clear();
        }
        let mut out = Judgement {
            relation: at,
            word: Word::NotRead,
            span: relation.span(),
            why: String::new(),
            witness: None,
            instead: None,
            with: Vec::new(),
            steps: (0, 0),
        };
        if relation.sides.len() < 2 {
            out.why = "a formula that relates nothing".to_owned();
            return out;
        }
        let is = |list: &[&str], sign: &String| list.contains(&sign.as_str());
        if let Some(sign) = relation.signs.iter().find(|s| !is(EQUALS, s) && !is(ABOUT, s) && !is(COMPARES, s)) {
            out.why = format!("the sign `{}`", diag::escape::in_one_line(sign));
            return out;
        }
        if relation.signs.iter().all(|s| is(COMPARES, s)) || relation.is_condition {
            out.word = Word::Condition;
            return out;
        }
        if relation.sides.iter().any(|s| s.text.len() > LONGEST) {
            out.why = "a formula that is too long".to_owned();
            return out;
        }
        if self.asked > MOST_QUESTIONS {
            out.word = Word::NotFollowed;
            out.why = "more formulas than are looked at in one paper".to_owned();
            return out;
        }
        self.steps(relation, at, &mut out);
        if out.word != Word::Wrong && relation.signs.iter().any(|s| is(ABOUT, s)) {
            out.word = Word::Approximates;
        } else if out.word != Word::Wrong && relation.signs.iter().any(|s| is(COMPARES, s)) {
            out.word = Word::Condition;
        }
        self.define(relation, at);
        out
    }

    /// Decides the steps of a relation from side to side.
    fn steps(&mut self, relation: &PrintedRelation, at: usize, out: &mut Judgement) {
        let free = free_indices(relation);
        let first = lone_name(&relation.sides[0]);
        let inline = relation.display.is_none();
        let mut tally = Tally::default();
        for k in 1..relation.sides.len() {
            if !EQUALS.contains(&relation.signs[k - 1].as_str()) {
                continue;
            }
            let (left, right) = (&relation.sides[k - 1], &relation.sides[k]);
            let known = first
                .as_ref()
                .is_some_and(|n| self.given.iter().any(|g| g.key == n.key() && !g.is_rate && n.dots == 0));
            let defining = k == 1 && first.is_some() && !known;
            if defining {
                // Whether it can be read is all that there is to say of it.
                tally.defines = true;
                let rate = first.as_ref().is_some_and(|n| n.dots > 0 || n.derived_by.is_some());
                match self.readable(left, right, &free) {
                    Err(found) => tally.unread = Some(found),
                    Ok(()) if !rate => continue,
                    Ok(()) => {}
                }
                if !rate || self.given.is_empty() || inline {
                    continue;
                }
            }
            out.steps.1 += 1;
            match self.step([left, right], &free, at, !inline && (!defining || self.has_rates())) {
                Step::Follows(with) => {
                    tally.follows += 1;
                    out.steps.0 += 1;
                    out.with.extend(with);
                    if defining {
                        tally.defines = false;
                    }
                }
                Step::Numbers => tally.numbers += 1,
                Step::Wrong(wrong) => {
                    out.word = Word::Wrong;
                    out.span = right.span.clone();
                    out.why = "a point refutes it, and one slip away it holds".to_owned();
                    out.witness = Some(wrong.witness);
                    out.instead = Some(wrong.instead);
                    out.with = wrong.with;
                    return;
                }
                // Said otherwise than before, of a name alone: it is defined anew.
                Step::Open(_) if k == 1 && known => {
                    out.steps.1 -= 1;
                    tally.defines = true;
                    let before = self
                        .given
                        .iter()
                        .rev()
                        .find(|g| first.as_ref().is_some_and(|n| g.key == n.key() && !g.is_rate));
                    tally.anew = before.map(|g| g.relation);
                }
                Step::Open(names) if !defining => tally.open.extend(names),
                Step::Open(_) => {}
                Step::NotRead(found) => tally.unread = Some(found),
            }
        }
        self.conclude(relation, at, tally, out);
    }

    /// The word, from what became of the steps.
    fn conclude(&self, relation: &PrintedRelation, at: usize, tally: Tally, out: &mut Judgement) {
        let first = lone_name(&relation.sides[0]);
        let inline = relation.display.is_none();
        out.with.sort_unstable();
        out.with.dedup();
        out.with.retain(|w| *w != at);
        let Tally { mut open, unread, follows, numbers, defines, anew } = tally;
        let undecided = out.steps.1 - follows - numbers;
        if let Some(found) = unread {
            out.why = match &found.why {
                Some(why) => format!("{}: {why}", found.feature),
                None => found.feature.clone(),
            };
            out.word = Word::NotRead;
        } else if undecided > 0 && !defines {
            // An equation between two things that are not defined is what is assumed, or to be solved.
            let single = relation.sides.len() == 2;
            out.word = if single && first.is_none() || inline { Word::Condition } else { Word::NotFollowed };
            open.sort();
            open.dedup();
            if out.word == Word::NotFollowed {
                out.why = match open.is_empty() {
                    true => "nothing above decides it".to_owned(),
                    false => format!("nothing above defines {}", open.join(", ")),
                };
            }
        } else if defines && undecided == 0 {
            out.word = Word::Defines;
        } else if defines {
            out.word = if out.steps.1 > 1 || relation.sides.len() > 2 { Word::NotFollowed } else { Word::Defines };
            if out.word == Word::NotFollowed {
                out.why = "a step between its later sides is not decided".to_owned();
            }
        } else {
            out.word = Word::Follows;
        }
        if out.word == Word::Defines && out.steps.0 > 0 {
            out.word = Word::Follows;
        }
        if numbers > 0 && matches!(out.word, Word::Follows | Word::Defines) {
            out.word = Word::Numbers;
            out.why = "not proved, and true at random points".to_owned();
        }
        if let Some(before) = anew.filter(|_| out.word == Word::Defines) {
            out.why = "otherwise than before".to_owned();
            out.with.push(before);
        }
        let value = relation.sides.len() == 2 && names(&relation.sides[1]).is_empty();
        let is_rate = first.as_ref().is_some_and(|n| n.dots > 0 || n.derived_by.is_some());
        if out.word == Word::Defines && !is_rate && (value || lone_name(&relation.sides[1]).is_some()) {
            out.word = Word::Condition;
        }
    }

    fn has_rates(&self) -> bool {
        self.given.iter().any(|g| g.is_rate)
    }

    /// Notes what a relation defines.
    fn define(&mut self, relation: &PrintedRelation, at: usize) {
        let Some(name) = lone_name(&relation.sides[0]) else { return };
        if !EQUALS.contains(&relation.signs[0].as_str()) || relation.is_condition {
            return;
        }
        let right = &relation.sides[1];
        let key = name.key();
        let is_rate = name.dots == 1 || name.derived_by.is_some() && !name.is_partial;
        if name.dots > 1 || name.is_partial || right.is_list || right.text.is_empty() {
            return;
        }
        let own = names(right);
        // A value is a condition, and what stands on both sides is an equation.
        if own.is_empty() || own.iter().any(|n| n.key() == key && (!is_rate || n.dots > 0 || n.derived_by.is_some())) {
            return;
        }
        if matches!(&name.call, paper::Call::Places(places) if places.len() != 1 || places[0].chars().any(|c| c.is_ascii_digit()))
        {
            return;
        }
        let free = free_indices(relation);
        if self.readable(&relation.sides[0], right, &free).is_err() {
            // What was defined before is defined no more: by what, was not read.
            self.given.retain(|g| g.key != key || g.is_rate != is_rate);
            return;
        }
        self.given.retain(|g| g.key != key || g.is_rate != is_rate);
        let given = Given { key, left: relation.sides[0].clone(), right: right.clone(), relation: at, is_rate };
        self.given.push(given);
    }

    fn readable(&mut self, left: &PrintedSide, right: &PrintedSide, free: &BTreeSet<char>) -> Result<(), NotRead> {
        let mut desk = Desk::new(&[left, right], &[], &self.evidence, free)?;
        desk.pairs([left, right], &self.evidence).map(|_| ())
    }

    /// What is given that a step needs: the definitions of its names, and of theirs, and the rates.
    fn needed(&self, sides: [&PrintedSide; 2]) -> Vec<Given> {
        let mut wanted: Vec<String> = sides.into_iter().flat_map(names).map(|n| n.key()).collect();
        let has_rates = sides.into_iter().flat_map(names).any(|n| n.dots > 0 || n.derived_by.is_some());
        let mut found: BTreeMap<usize, Given> = BTreeMap::new();
        let mut at = 0;
        while let Some(key) = wanted.get(at).cloned() {
            at += 1;
            for (k, given) in self.given.iter().enumerate().filter(|(_, g)| g.key == key && (!g.is_rate || has_rates)) {
                if found.insert(k, given.clone()).is_none() {
                    wanted.extend(names(&given.right).iter().map(|n| n.key()));
                }
            }
            if found.len() > MOST_GIVEN {
                return Vec::new();
            }
        }
        in_order(found.into_values().collect())
    }

    /// Decides one step.
    fn step(&mut self, sides: [&PrintedSide; 2], free: &BTreeSet<char>, at: usize, told: bool) -> Step {
        let [left, right] = sides;
        if self.asked > MOST_QUESTIONS {
            return Step::Open(Vec::new());
        }
        let bare = match self.ask(left, right, &[], free) {
            Err(found) => return Step::NotRead(found),
            Ok(asked) => asked,
        };
        if matches!(bare.identity, Identity::Proved(_)) {
            return Step::Follows(Vec::new());
        }
        let given = self.needed([left, right]);
        let with = match given.is_empty() {
            true => None,
            false => self.ask(left, right, &given, free).ok(),
        };
        if let Some(asked) = &with
            && matches!(asked.identity, Identity::Proved(_))
        {
            return Step::Follows(given.iter().map(|g| g.relation).collect());
        }
        if let Identity::Undecided(_) = &bare.identity
            && let Some((valid, true)) = agreement(&bare.desk.graph, &bare.equations, POINTS)
            && valid >= POINTS / 2
        {
            return Step::Numbers;
        }
        if told {
            let near = given.iter().all(|g| g.relation + NEAR >= at);
            for (asked, given) in [(Some(bare), Vec::new()), (with.filter(|_| near), given.clone())] {
                if let Some(asked) = asked
                    && introduces_nothing(left, right, &given)
                    && let Some(wrong) = self.slip(asked, &given, free)
                {
                    return Step::Wrong(Box::new(wrong));
                }
            }
        }
        let defined: BTreeSet<String> = given.iter().map(|g| g.key.clone()).collect();
        let mut open: Vec<String> = [left, right].into_iter().flat_map(names).map(|n| n.key()).collect();
        open.retain(|key| !defined.contains(key));
        Step::Open(open)
    }

    fn ask(
        &mut self,
        left: &PrintedSide,
        right: &PrintedSide,
        given: &[Given],
        free: &BTreeSet<char>,
    ) -> Result<Asked, NotRead> {
        self.asked += 1;
        let list: Vec<&Given> = given.iter().collect();
        let mut desk = Desk::new(&[left, right], &list, &self.evidence, free)?;
        let read = desk.read([left, right], &self.evidence)?;
        let statement = &read.statement;
        if statement.relations.iter().any(|r| r.kind != RelationKind::Equal || r.has_branches || r.limit.is_some()) {
            return Err(NotRead { feature: "a sign of two branches, or a limit".to_owned(), why: None });
        }
        let equations = pairs_of(statement);
        let mut premises = Premises { time: desk.time, moving: desk.moving.clone(), ..Premises::default() };
        for rate in given.iter().filter(|g| g.is_rate) {
            let pairs = desk.pairs([&rate.left, &rate.right], &self.evidence)?;
            premises.equations.extend(pairs.into_iter().map(|pair| Known::of(pair, When::Always)));
        }
        let identity = tested(&mut desk.graph, &equations, &premises, Wanted::Answer);
        Ok(Asked { desk, premises, equations, identity, text: read.text })
    }

    /// The nearest formula that holds, where a step is refuted.
    fn slip(&mut self, asked: Asked, given: &[Given], free: &BTreeSet<char>) -> Option<WrongStep> {
        let Identity::Refuted(refutation) = &asked.identity else { return None };
        let Asked { mut desk, premises, text, .. } = asked;
        if desk.is_complex || !free.is_empty() {
            return None;
        }
        let witness = witness(&desk.graph, refutation);
        let mut chains = latex::parse(&text, &desk.scope).ok()?;
        let chain = chains.pop().filter(|c| chains.is_empty() && c.sides.len() == 2)?;
        if chain.sides.iter().map(size).max()? < FEWEST_NODES || chain.sides.iter().any(|s| size(s) < 3) {
            return None;
        }
        let mut all = Vec::new();
        chain.sides.iter().for_each(|s| symbols(s, &mut all));
        for k in [1, 0] {
            let others = slips(&chain.sides[k], &all);
            for slip in others.into_iter().take(MOST_SLIPS) {
                if self.asked > MOST_QUESTIONS {
                    return None;
                }
                if let Some(instead) = self.holds(&mut desk, &premises, &chain, k, &slip, given) {
                    return Some(WrongStep { witness, instead, with: given.iter().map(|g| g.relation).collect() });
                }
            }
        }
        None
    }

    /// The altered relation as LaTeX, if it is proved and says something.
    fn holds(
        &mut self,
        desk: &mut Desk,
        premises: &Premises,
        chain: &Chain,
        k: usize,
        slip: &Slip,
        given: &[Given],
    ) -> Option<String> {
        let mut altered = chain.clone();
        altered.sides[k] = slip.side.clone();
        let spelled = |n: &latex::syntax::Node| {
            let one = Chain { sides: vec![n.clone()], relations: Vec::new(), ..chain.clone() };
            to_latex(&one)
        };
        let (new, other) = (spelled(&altered.sides[k]), spelled(&altered.sides[1 - k]));
        // What becomes the other side, or a definition, letter by letter, is no slip of it.
        if new == other || given.iter().any(|g| squeezed(&g.right.text) == squeezed(&new)) {
            return None;
        }
        // Beside a lone name, or a number, anything could be meant.
        let plain = |n: &latex::syntax::Node| matches!(n.kind, NodeKind::Symbol(_) | NodeKind::Number(_));
        if plain(&altered.sides[k]) || plain(&chain.sides[k]) {
            return None;
        }
        if let Some((a, b)) = &slip.exchanges
            && (a == b || size(&chain.sides[k]) < 9)
        {
            return None;
        }
        // With definitions, another name, or one more or fewer, may be another definition.
        if !given.is_empty() && slip.is_of_names() {
            return None;
        }
        let statement = latex::elaborate(&altered, &desk.scope, &mut desk.graph).ok()?;
        let equations = pairs_of(&statement);
        // A look at three points spares most proofs.
        if premises.equations.is_empty() && agreement(&desk.graph, &equations, 6).is_some_and(|(_, agree)| !agree) {
            return None;
        }
        self.asked += 1;
        let proved = matches!(tested(&mut desk.graph, &equations, premises, Wanted::Proof), Identity::Proved(_));
        proved.then(|| if k == 1 { new } else { format!("{new} = {other}") })
    }
}

/// Whether the later side has no name that neither the earlier side nor a definition has: what relates a new one is not known here.
fn introduces_nothing(left: &PrintedSide, right: &PrintedSide, given: &[Given]) -> bool {
    let mut known: BTreeSet<String> = names(left).iter().map(|n| n.key()).collect();
    for one in given {
        known.extend([&one.left, &one.right].into_iter().flat_map(names).map(|n| n.key()));
    }
    names(right).iter().all(|n| known.contains(&n.key()))
}

/// A question, and its answer.
struct Asked {
    desk: Desk,
    premises: Premises,
    equations: Vec<(Expr, Expr)>,
    identity: Identity,
    /// What was read.
    text: String,
}

/// Definitions in an order in which each stands behind those that it needs; those that need each other are left out.
fn in_order(given: Vec<Given>) -> Vec<Given> {
    let (rates, mut rest): (Vec<Given>, Vec<Given>) = given.into_iter().partition(|g| g.is_rate);
    let mut out: Vec<Given> = Vec::new();
    while !rest.is_empty() {
        let keys: BTreeSet<String> = rest.iter().map(|g| g.key.clone()).collect();
        let ready = |g: &Given| !names(&g.right).iter().any(|n| keys.contains(&n.key()));
        let (now, later): (Vec<Given>, Vec<Given>) = rest.into_iter().partition(ready);
        if now.is_empty() {
            break;
        }
        out.extend(now);
        rest = later;
    }
    out.extend(rates);
    out
}

/// The answer, with a bound on the work.
fn tested(graph: &mut Graph, equations: &[(Expr, Expr)], premises: &Premises, wanted: Wanted) -> Identity {
    let proof = wanted == Wanted::Proof;
    let options = Options {
        attempts: if proof { 0 } else { 60 },
        special_cases: 0,
        most_signs: 6,
        most_nodes: 4000,
        wanted,
        ..Options::default()
    };
    match identity_test(graph, equations, premises, &options) {
        // A case that was divided by is left out: that is no proof of what is printed.
        Identity::Proved(proof)
            if proof.conditions.iter().any(|c| matches!(c, Condition::Pivot(_) | Condition::Discriminant(_))) =>
        {
            Identity::Undecided(proof::Reason::Degenerate)
        }
        other => other,
    }
}

fn squeezed(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect()
}

fn witness(graph: &Graph, refutation: &Refutation) -> LintWitness {
    let [named, _] = refutation.parted(&refutation.point);
    let value = |v: &proof::PointValue| match &v.exact {
        Some(exact) => exact.to_string(),
        None => format!("{:.6}", v.decimal),
    };
    LintWitness {
        values: named.iter().map(|(leaf, v)| (graph.leaf_latex(*leaf), value(v))).collect(),
        left: refutation.left.decimal,
        right: refutation.right.decimal,
    }
}

/// Index letters that stand once in a lone name on the left: they are free, and nothing is summed over them.
fn free_indices(relation: &PrintedRelation) -> BTreeSet<char> {
    let Some(name) = lone_name(&relation.sides[0]) else { return BTreeSet::new() };
    let letters = name.index_letters();
    letters.iter().copied().filter(|l| letters.iter().filter(|m| *m == l).count() == 1).collect()
}
