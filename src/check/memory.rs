//! What was found for an earlier state of a file, by content.
//!
//! **In:** questions ([`Question`]), each named by everything that its answer depends on. **Out:** the answer that is known, or one that is
//! found and kept ([`Answers`]).
//!
//! A verdict of a claim on a motion depends on the symbols, systems and conditions of the file, on the claim's own table, on
//! the motion with those that it comes from, and on what else motions are asked for, which moves the last places of error bounds. A proof
//! depends on the symbols and systems, on the claim, and on the claims that it
//! follows from, directly or through others. Names of questions are SHA-256 sums of these texts: two questions with one name are
//! the same question.
//!
//! Validated steps of a motion are named by what they are computed from, whatever file that is of: see [`KnownSteps`].
//!
//! **Guaranteed:** an answer is the one that would be found now.

use std::collections::{BTreeSet, HashMap};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::answers::{AGES, Answers, Key, key};
use super::motions::Family;
use crate::derivation::{Claim, Derivation, Form, Motion};
use crate::expr::{FastMap, Graph, Leaf};
use crate::findings::{ClaimAccount, FamilyAccount, family::MeasureAccount};
use crate::flow::{KnownSteps, Steps};
use crate::verdict::Verdict;
use claim::limits::Cancel;
use proved::conditional::premises_first;
use proved::step::Step;
use sampled::recall::Recall;
use sampled::stage::{Built, Requests};

/// What was found on all families.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct OnFamilies {
    /// In the order of the accounts of claims.
    pub claims: Vec<Vec<FamilyAccount>>,
    pub measures: Vec<MeasureAccount>,
}

/// What may be asked, with what the type of its answer is.
#[derive(Clone, Copy)]
pub(super) enum Question<'q> {
    /// The verdict of a claim on a motion, from samples; of the claim `whole` without one of its assumptions, by its place: [`Verdict`].
    Sampled { claim: &'q Claim, whole: &'q str, without: Option<usize>, motion: usize },
    /// Why the two routes to the values of a motion are not one, where they are not: `Option<Reason>`.
    Contradiction(usize),
    /// How a condition stands on a motion, named by what it says in the notation of the whole file: `Option<bool>`.
    Condition { says: &'q [&'q str], motion: usize },
    /// What a claim says for all values, where it is a claim of that kind; or how the program contradicts itself:
    /// `Option<Result<IdentityAccount, String>>`.
    Identity(&'q Claim),
    /// The steps of a proof, by all that is given and claimed: [`Recorded`](crate::findings::Recorded).
    Steps(&'q [u8]),
    /// The verdict of a claim on a motion that is given by a formula, after one from samples: [`Verdict`].
    ByFormula { claim: &'q Claim, motion: usize, before: &'q Verdict },
    /// What an enclosure says: [`enclosed::Answer`].
    Enclosed(enclosed::Question<'q>),
    /// What is counted on families: [`OnFamilies`].
    OnFamilies(&'q [ClaimAccount]),
    /// What a claim asks of motions: the names of leaves.
    Leaves(&'q Claim),
    /// How claims fare on motions that are drawn from those of the file: of each its `DrawnAccount`.
    Drawn(&'q [&'q Claim]),
}

/// Something that is kept, with the last age in which it was asked for.
type Aged<T> = (u64, Arc<T>);

/// What was found, for several states of a file.
#[derive(Debug, Default)]
pub(super) struct Memory {
    answers: Answers,
    /// The validated steps of motions, by all that they are computed from. Their work counts each time: no work is spared by them.
    steps: Answers,
    /// Whether it serves one check: motions are not kept then.
    once: bool,
    families: Mutex<HashMap<Key, Aged<Mutex<Family>>>>,
    /// The name of what the motions are asked for in this state of the file; nothing before that is known.
    asked: Mutex<Option<Key>>,
    /// Whether motions were asked for something else than a check of the whole file would ask for.
    other: AtomicBool,
}

impl Memory {
    /// What was found in another process, for one check of a new state of the file.
    pub fn of(mut answers: Answers, mut steps: Answers) -> Memory {
        answers.grow_older();
        steps.grow_older();
        Memory { answers, steps, once: true, ..Memory::default() }
    }

    /// All answers, and the steps of motions, to be kept longer than a process lives; `work` was counted in finding those that are new.
    pub fn answers(mut self, work: u64) -> (Answers, Answers) {
        self.answers.share(work);
        (self.answers, self.steps)
    }

    /// The counted work that was spared, since answers were known.
    pub fn recalled(&self) -> u64 {
        self.answers.recalled()
    }

    /// How many answers were known, and how many were found.
    pub fn counts(&self) -> [usize; 2] {
        self.answers.counts()
    }

    /// A new state of the file begins; what ends its check, where something may.
    pub fn grow_older(&mut self, cancel: Option<&Cancel>) {
        for kept in [&mut self.answers, &mut self.steps] {
            kept.until(cancel);
            kept.grow_older();
        }
        let now = self.answers.age();
        self.families.get_mut().unwrap_or_else(PoisonError::into_inner).retain(|_, (age, _)| *age + AGES >= now);
    }

    /// Whether nothing is known yet.
    pub fn is_new(&mut self) -> bool {
        self.asked.get_mut().unwrap_or_else(PoisonError::into_inner).is_none()
    }

    /// Whether an answer may differ from that of a check that knows nothing: error bounds of the points of a motion depend, in
    /// their last places, on what else the motion is asked for.
    pub fn is_misled(&self) -> bool {
        self.other.load(Ordering::Relaxed)
    }
}

/// A state of a file, by content: see [`super::cache`] for what counts as content.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Contents {
    /// Everything but claims, motions and words.
    pub base: String,
    /// Id and content of every motion.
    pub motions: Vec<(String, String)>,
    /// Id and content of every claim.
    pub claims: Vec<(String, String)>,
    /// Id and expectations of every claim: no verdict depends on them, but what is corrected does.
    pub expected: Vec<(String, String)>,
}

/// What is known, for one state of a file. Without a memory everything is computed.
#[derive(Clone, Copy, Default)]
pub(super) struct Known<'a>(Option<State<'a>>);

#[derive(Clone, Copy)]
struct State<'a> {
    memory: &'a Memory,
    names: &'a Names<'a>,
}

/// The content of a state of a file by its ids. To look for each would take the square of their number.
pub(super) struct Names<'a> {
    /// The name of everything but claims and motions.
    base: Key,
    /// That of all motions with their ids.
    all_motions: Key,
    motions: FastMap<&'a str, &'a str>,
    claims: FastMap<&'a str, &'a str>,
    /// The name of each claim with all that it follows from, once one is asked for.
    steps: OnceLock<HashMap<String, Option<Key>>>,
}

impl<'a> Names<'a> {
    pub fn of(contents: &'a Contents) -> Names<'a> {
        fn by_id(of: &[(String, String)]) -> FastMap<&str, &str> {
            // Of two with one id the first counts.
            of.iter().rev().map(|(id, content)| (id.as_str(), content.as_str())).collect()
        }
        let motions: Vec<&[u8]> = contents.motions.iter().flat_map(|(id, m)| [id.as_bytes(), m.as_bytes()]).collect();
        Names {
            base: key(&[contents.base.as_bytes()]),
            all_motions: key(&motions),
            motions: by_id(&contents.motions),
            claims: by_id(&contents.claims),
            steps: OnceLock::new(),
        }
    }
}

impl<'a> Known<'a> {
    /// What is known for a state of a file.
    pub fn new(memory: &'a Memory, names: &'a Names) -> Known<'a> {
        Known(Some(State { memory, names }))
    }

    /// Whether nothing is kept or recalled.
    pub fn is_nothing(&self) -> bool {
        self.0.is_none()
    }

    /// Where motions are kept, too.
    fn of_motions(&self) -> Option<State<'a>> {
        self.0.filter(|state| !state.memory.once)
    }

    /// The answer to a question about a state of the file: the one that is known, or the one that is found.
    pub fn answer<T: Serialize + DeserializeOwned>(
        &self,
        derivation: &Derivation,
        question: Question,
        find: impl FnOnce() -> T,
    ) -> T {
        let Some(state) = self.0 else { return find() };
        state.memory.answers.answer(state.name(derivation, question), find)
    }

    /// The answer to a question, if it is known.
    pub fn known<T: DeserializeOwned>(&self, derivation: &Derivation, question: Question) -> Option<T> {
        let state = self.0?;
        state.memory.answers.known(state.name(derivation, question)?)
    }

    /// Keeps the answer to a question.
    pub fn keep<T: Serialize>(&self, derivation: &Derivation, question: Question, answer: &T) {
        let name = self.0.and_then(|state| Some((state, state.name(derivation, question)?)));
        if let Some((state, name)) = name {
            state.memory.answers.keep(name, answer);
        }
    }

    /// Notes what each of some claims, with those that are made from it, asks of motions, and compares what all claims ask with
    /// what motions were built for.
    pub fn asks(&self, derivation: &Derivation, claimed: &[usize], leaves: impl Fn(usize) -> BTreeSet<Leaf>) {
        let Some(state) = self.0 else { return };
        let mut all: BTreeSet<String> = BTreeSet::new();
        for (c, claim) in derivation.claims.iter().enumerate() {
            let find = || match claimed.binary_search(&c) {
                Ok(k) => leaves(k).iter().map(|leaf| named(&derivation.graph, leaf)).collect(),
                // It was not checked before, and is not now: what it asks for is not known.
                Err(_) => BTreeSet::from([String::new()]),
            };
            all.extend(self.answer(derivation, Question::Leaves(claim), find));
        }
        let all = key(&all.iter().map(String::as_bytes).collect::<Vec<_>>());
        let mut asked = state.memory.asked.lock().unwrap_or_else(PoisonError::into_inner);
        if *asked.get_or_insert(all) != all {
            // Motions that are kept were built for something else.
            state.memory.other.store(true, Ordering::Relaxed);
        }
    }

    /// Puts what is found on all families into the accounts of their claims; returns what is measured.
    ///
    /// # Errors
    /// Those of `compute`, which does the same.
    pub fn on_families<E>(
        &self,
        derivation: &Derivation,
        claims: &mut [ClaimAccount],
        compute: impl FnOnce(&mut [ClaimAccount]) -> Result<Vec<MeasureAccount>, E>,
    ) -> Result<Vec<MeasureAccount>, E> {
        if let Some(OnFamilies { claims: found, measures }) = self.known(derivation, Question::OnFamilies(claims)) {
            claims.iter_mut().zip(found).for_each(|(claim, found)| claim.families = found);
            return Ok(measures);
        }
        let measures = compute(claims)?;
        let of_claims = claims.iter().map(|c| c.families.clone()).collect();
        let found = OnFamilies { claims: of_claims, measures };
        self.keep(derivation, Question::OnFamilies(claims), &found);
        Ok(found.measures)
    }
}

/// A leaf, whatever the numbers of the graph are.
fn named(graph: &Graph, leaf: &Leaf) -> String {
    let instant = leaf.instant.map(|e| if e.index() < graph.len() { graph.to_latex(e) } else { String::new() });
    format!("{} {} {} {instant:?}", leaf.symbol.index(), leaf.component, leaf.rate)
}

impl KnownSteps for Known<'_> {
    fn steps(&self, name: &str) -> Option<Steps> {
        self.0?.memory.steps.known(key(&[name.as_bytes()]))
    }

    fn keep_steps(&self, name: &str, steps: &Steps) {
        self.0.iter().for_each(|state| state.memory.steps.keep(key(&[name.as_bytes()]), steps));
    }

    fn is_known(&self) -> bool {
        self.0.is_some()
    }
}

impl Recall for Known<'_> {
    fn is_known(&self) -> bool {
        self.of_motions().is_some()
    }

    fn motions(&self, derivation: &Derivation, requests: &Requests, members: &[usize]) -> Option<Vec<(usize, Built)>> {
        let known = self.of_motions()?;
        let name = known.family(derivation, members)?;
        let kept = {
            let mut families = known.memory.families.lock().unwrap_or_else(PoisonError::into_inner);
            let (age, family) = families.get_mut(&name)?;
            *age = known.memory.answers.age();
            Arc::clone(family)
        };
        let again = kept.lock().unwrap_or_else(PoisonError::into_inner).again(derivation, requests, members);
        if known.memory.answers.is_cancelled() {
            // What was searched for may not have been looked for to the end.
            known.memory.families.lock().unwrap_or_else(PoisonError::into_inner).remove(&name);
        }
        again
    }

    fn keep(&self, derivation: &Derivation, members: &[usize], graph: Graph, built: &[(usize, Built)]) {
        let Some(known) = self.of_motions().filter(|known| !known.memory.answers.is_cancelled()) else { return };
        if let Some(name) = known.family(derivation, members) {
            let family = Family::new(derivation, graph, members, built);
            let kept = (known.memory.answers.age(), Arc::new(Mutex::new(family)));
            known.memory.families.lock().unwrap_or_else(PoisonError::into_inner).insert(name, kept);
        }
    }

    fn builds_for_a_part(&self) {
        if let Some(known) = self.0 {
            known.memory.other.store(true, Ordering::Relaxed);
        }
    }

    fn without(
        &self,
        derivation: &Derivation,
        (claim, whole, place): (&Claim, &str, usize),
        t: usize,
        compute: &dyn Fn() -> Verdict,
    ) -> Verdict {
        self.answer(derivation, Question::Sampled { claim, whole, without: Some(place), motion: t }, compute)
    }

    fn standing(
        &self,
        derivation: &Derivation,
        says: &[&str],
        t: usize,
        compute: &dyn Fn() -> Option<bool>,
    ) -> Option<bool> {
        self.answer(derivation, Question::Condition { says, motion: t }, compute)
    }
}

impl State<'_> {
    /// The name of a question: all that its answer depends on. `None` where that is not known, and the answer is found anew.
    fn name(&self, derivation: &Derivation, question: Question) -> Option<Key> {
        let base = &self.names.base;
        match question {
            Question::Sampled { claim, whole, without, motion } => {
                if compares_motions(claim) {
                    return None;
                }
                let content = self.claim(whole.split('/').next()?)?;
                let without = without.map_or(0, |place| place as u64 + 1).to_le_bytes();
                let (asked, motion) = (self.asked(), self.motion(derivation, motion)?);
                Some(key(&[b"claim", base, &asked, content.as_bytes(), whole.as_bytes(), &without, &motion]))
            }
            Question::Condition { says, motion } => {
                let says = key(&says.iter().map(|text| text.as_bytes()).collect::<Vec<_>>());
                Some(key(&[b"condition", base, &self.asked(), &says, &self.motion(derivation, motion)?]))
            }
            Question::Contradiction(motion) => {
                Some(key(&[b"contradiction", base, &self.asked(), &self.motion(derivation, motion)?]))
            }
            Question::Identity(claim) => self.step(derivation, claim),
            Question::Steps(content) => Some(key(&[b"steps", content])),
            Question::ByFormula { claim, motion, before } => {
                let (motions, about) = (self.motions(derivation, claim, motion)?, self.stands(claim, before)?);
                Some(key(&[b"by formula", base, &self.asked(), &motions, &about]))
            }
            Question::Enclosed(enclosed::Question { claim, motion, before, integrals }) => {
                let (motions, about) = (self.motions(derivation, claim, motion)?, self.stands(claim, before)?);
                Some(key(&[b"enclosed", base, &self.asked(), integrals.as_bytes(), &motions, &about]))
            }
            Question::OnFamilies(claims) => self.on_families(derivation, claims),
            Question::Leaves(claim) => {
                let content = self.claim(&claim.id).unwrap_or_default();
                Some(key(&[b"leaves", base, content.as_bytes(), claim.name().as_bytes()]))
            }
            Question::Drawn(claims) => self.drawn(claims),
        }
    }

    /// Claims, with all motions: others are drawn from these.
    fn drawn(&self, claims: &[&Claim]) -> Option<Key> {
        let mut sum = key(&[b"drawn", &self.names.base, &self.names.all_motions]);
        for claim in claims {
            sum = key(&[&sum, self.claim(&claim.id)?.as_bytes(), claim.name().as_bytes()]);
        }
        Some(sum)
    }

    /// A claim with what is known of it.
    fn stands(&self, claim: &Claim, before: &Verdict) -> Option<Key> {
        let before = postcard::to_allocvec(before).ok()?;
        Some(key(&[self.claim(&claim.id)?.as_bytes(), claim.name().as_bytes(), &before]))
    }

    /// The motion that a claim is tried on; with all others, where the claim compares motions.
    fn motions(&self, derivation: &Derivation, claim: &Claim, motion: usize) -> Option<Key> {
        let others = if compares_motions(claim) { self.names.all_motions } else { Key::default() };
        Some(key(&[&self.motion(derivation, motion)?, &others]))
    }

    /// What motions are asked for.
    fn asked(&self) -> Key {
        self.memory.asked.lock().unwrap_or_else(PoisonError::into_inner).unwrap_or_default()
    }

    /// The content of a motion and of those that it comes from.
    fn motion(&self, derivation: &Derivation, mut t: usize) -> Option<Key> {
        let mut parts: Vec<&[u8]> = Vec::new();
        loop {
            let trajectory = derivation.trajectories.get(t)?;
            let content = self.names.motions.get(trajectory.id.as_str())?;
            parts.push(content.as_bytes());
            match trajectory.motion {
                // No motion comes from itself; the loader has seen to that.
                Motion::Derived { from, .. } if parts.len() <= derivation.trajectories.len() => t = from,
                _ => return Some(key(&parts)),
            }
        }
    }

    fn family(&self, derivation: &Derivation, members: &[usize]) -> Option<Key> {
        let each = |&t: &usize| self.motion(derivation, t);
        let members = members.iter().map(each).collect::<Option<Vec<Key>>>()?;
        Some(key(&[b"family", &self.names.base, members.concat().as_slice()]))
    }

    fn claim(&self, id: &str) -> Option<&str> {
        self.names.claims.get(id).copied()
    }

    /// All claims that name families, with what they follow from, and the motions that members begin as.
    fn on_families(&self, derivation: &Derivation, claims: &[ClaimAccount]) -> Option<Key> {
        let mut sum = key(&[b"families", &self.names.base]);
        for t in derivation.families.iter().map(|family| family.of) {
            sum = key(&[&sum, &self.motion(derivation, t)?]);
        }
        for account in claims {
            let claim = derivation.claim(&account.id, account.reading.as_deref())?;
            let name = claim.name();
            sum = match claim.families.is_empty() {
                true => key(&[&sum, name.as_bytes()]),
                false => key(&[&sum, name.as_bytes(), &self.step(derivation, claim)?]),
            };
        }
        Some(sum)
    }

    /// A claim with all that it follows from.
    fn step(&self, derivation: &Derivation, claim: &Claim) -> Option<Key> {
        *self.names.steps.get_or_init(|| self.steps(derivation)).get(&claim.name())?
    }

    /// The names of all claims with all that each follows from: of a claim with the names of its premises, which have those of theirs.
    /// To go through all of them from each claim would take the square of the length of a chain.
    fn steps(&self, derivation: &Derivation) -> HashMap<String, Option<Key>> {
        let all = &derivation.claims;
        let given: Vec<Vec<String>> = all.iter().map(|claim| Step::given(derivation, claim)).collect();
        // Whether motions are analytic depends on how those are given on which a claim is tried.
        let behind = |at: usize| format!("{:?}", Step::behind(derivation, &all[at]));
        let claim = |name: &String| derivation.premise(name).claim();
        let mut keys: Vec<Option<Key>> = vec![None; all.len()];
        for at in premises_first(all.len(), |k| given[k].iter().filter_map(claim).collect()) {
            // In a circle a premise has no name yet, and what follows from it gets none.
            let named = |name: &String| claim(name).map_or(Some(Key::default()), |premise| keys[premise]);
            let found = self.step_from(&all[at], &given[at], named);
            keys[at] = found.map(|sum| key(&[&sum, behind(at).as_bytes()]));
        }
        all.iter().map(Claim::name).zip(keys).collect()
    }

    /// The name of a claim with its premises, by theirs.
    fn step_from(&self, claim: &Claim, given: &[String], named: impl Fn(&String) -> Option<Key>) -> Option<Key> {
        let content = self.claim(&claim.id)?;
        let mut sum = key(&[b"step", &self.names.base, claim.name().as_bytes(), content.as_bytes()]);
        for name in given {
            sum = key(&[&sum, name.as_bytes(), &named(name)?]);
        }
        Some(sum)
    }
}

/// Whether a claim depends on another motion, too.
pub(super) fn compares_motions(claim: &Claim) -> bool {
    claim.forms.iter().any(|f| matches!(f, Form::SameMotion { .. } | Form::Across(_)))
}
