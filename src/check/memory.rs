//! What was found for an earlier state of a file, by content.
//!
//! **In:** questions, each named by everything that its answer depends on. **Out:** the answer that is known, or one that is
//! computed and kept; and [`Found`], all answers but the motions, to be kept longer than
//! a process lives.
//!
//! A verdict of a claim on a motion depends on the symbols, systems and conditions of the file, on the claim's own table, and on
//! the motion with those that it comes from. A proof depends on the symbols and systems, on the claim, and on the claims that it
//! follows from, directly or through others. Names of questions are SHA-256 sums of these texts: two questions with one name are
//! the same question.
//!
//! **Guaranteed:** an answer is the one that would be computed now. What is not asked for in [`AGES`] states of the file is
//! forgotten.

use std::collections::{BTreeSet, HashMap};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::motions::Family;
use crate::derivation::{Claim, Derivation, Form, Motion, Premise};
use crate::expr::{FastMap, Graph, Leaf};
use crate::findings::{ClaimAccount, FamilyAccount, IdentityAccount, family::MeasureAccount};
use crate::verdict::Verdict;
use proved::conditional::premises_first;
use proved::step::Step;
use sampled::recall::Recall;
use sampled::stage::{Built, Requests};

/// For how many states of a file an answer is kept that is not asked for.
const AGES: u64 = 8;

/// The name of a question.
pub(super) type Key = [u8; 32];

/// The name of a question with several parts.
pub(super) fn key(parts: &[&[u8]]) -> Key {
    let mut sum = Sha256::new();
    for part in parts {
        sum.update((part.len() as u64).to_le_bytes());
        sum.update(part);
    }
    sum.finalize().into()
}

/// Answers of one kind, each with the last age in which it was asked for.
type Answers<T> = Mutex<HashMap<Key, (u64, T)>>;

/// What a claim says for all values, where it is a claim of that kind; or how the program contradicts itself.
type Identity = Option<Result<IdentityAccount, String>>;

/// What was found on all families.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct OnFamilies {
    /// In the order of the accounts of claims.
    pub claims: Vec<Vec<FamilyAccount>>,
    pub measures: Vec<MeasureAccount>,
}

/// What was found in another process: every answer by its name. Motions are not kept.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(super) struct Found {
    verdicts: Vec<(Key, Verdict)>,
    standings: Vec<(Key, Option<bool>)>,
    identities: Vec<(Key, Identity)>,
    on_families: Vec<(Key, OnFamilies)>,
    strengthened: Vec<(Key, Vec<Verdict>)>,
    asked: Option<BTreeSet<String>>,
}

/// What was found, for several states of a file.
#[derive(Debug, Default)]
pub(super) struct Memory {
    age: u64,
    /// Whether it serves one check: motions are not kept then.
    once: bool,
    verdicts: Answers<Verdict>,
    standings: Answers<Option<bool>>,
    identities: Answers<Identity>,
    on_families: Answers<OnFamilies>,
    strengthened: Answers<Vec<Verdict>>,
    families: Answers<Arc<Mutex<Family>>>,
    wanted: Answers<BTreeSet<String>>,
    /// What the motions were asked for when they were built; nothing before that.
    asked: Mutex<Option<BTreeSet<String>>>,
    /// Whether motions were asked for something else than a check of the whole file would ask for.
    other: AtomicBool,
}

impl Memory {
    /// What was found in another process, for one check.
    pub fn of(found: Found) -> Memory {
        fn answers<T>(list: Vec<(Key, T)>) -> Answers<T> {
            Mutex::new(list.into_iter().map(|(name, answer)| (name, (0, answer))).collect())
        }
        let Found { verdicts, standings, identities, on_families, strengthened, asked } = found;
        Memory {
            age: 1,
            once: true,
            verdicts: answers(verdicts),
            standings: answers(standings),
            identities: answers(identities),
            on_families: answers(on_families),
            strengthened: answers(strengthened),
            asked: Mutex::new(asked),
            ..Memory::default()
        }
    }

    /// What was asked for in this state of the file.
    pub fn found(self) -> Found {
        fn inner<T>(of: Mutex<T>) -> T {
            of.into_inner().unwrap_or_else(PoisonError::into_inner)
        }
        let now = self.age;
        fn answers<T>(kept: Answers<T>, now: u64) -> Vec<(Key, T)> {
            let asked = inner(kept).into_iter().filter(|(_, (age, _))| *age == now);
            let mut list: Vec<(Key, T)> = asked.map(|(name, (_, answer))| (name, answer)).collect();
            list.sort_unstable_by_key(|(name, _)| *name);
            list
        }
        Found {
            verdicts: answers(self.verdicts, now),
            standings: answers(self.standings, now),
            identities: answers(self.identities, now),
            on_families: answers(self.on_families, now),
            strengthened: answers(self.strengthened, now),
            asked: inner(self.asked),
        }
    }

    /// A new state of the file begins.
    pub fn grow_older(&mut self) {
        self.age += 1;
        let now = self.age;
        fn forget<T>(kept: &mut Answers<T>, now: u64) {
            kept.get_mut().unwrap_or_else(PoisonError::into_inner).retain(|_, (age, _)| *age + AGES >= now);
        }
        forget(&mut self.verdicts, now);
        forget(&mut self.standings, now);
        forget(&mut self.families, now);
        forget(&mut self.wanted, now);
        forget(&mut self.identities, now);
        forget(&mut self.on_families, now);
        forget(&mut self.strengthened, now);
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

    /// The answer to a question, if it is known.
    fn known<T: Clone>(&self, kept: &Answers<T>, name: Key) -> Option<T> {
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        let (age, known) = kept.get_mut(&name)?;
        *age = self.age;
        Some(known.clone())
    }

    /// The answer to a question; what has no name is always computed.
    fn answer<T: Clone>(&self, kept: &Answers<T>, name: Option<Key>, compute: impl FnOnce() -> T) -> T {
        let Some(name) = name else { return compute() };
        if let Some(known) = self.known(kept, name) {
            return known;
        }
        let found = compute();
        kept.lock().unwrap_or_else(PoisonError::into_inner).insert(name, (self.age, found.clone()));
        found
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

    /// Where only answers are kept.
    fn of_one_check(&self) -> Option<State<'a>> {
        self.0.filter(|state| state.memory.once)
    }

    /// Where motions are kept, too.
    fn of_motions(&self) -> Option<State<'a>> {
        self.0.filter(|state| !state.memory.once)
    }

    /// The verdict of a claim on a motion.
    pub fn verdict(
        &self,
        derivation: &Derivation,
        claim: &Claim,
        t: usize,
        compute: impl FnOnce() -> Verdict,
    ) -> Verdict {
        let Some(known) = self.0 else { return compute() };
        let name = known.of_claim(derivation, claim, &claim.name(), t, b"");
        known.memory.answer(&known.memory.verdicts, name, compute)
    }

    /// The verdict of a claim on a motion, if it is known.
    pub fn known_verdict(&self, derivation: &Derivation, claim: &Claim, t: usize) -> Option<Verdict> {
        let known = self.0?;
        let name = known.of_claim(derivation, claim, &claim.name(), t, b"")?;
        known.memory.known(&known.memory.verdicts, name)
    }

    /// Notes what each of some claims, with those that are made from it, asks of motions, and compares what all claims ask with
    /// what motions were built for.
    pub fn asks(&self, derivation: &Derivation, claimed: &[usize], leaves: impl Fn(usize) -> BTreeSet<Leaf>) {
        let Some(known) = self.0 else { return };
        let mut all = BTreeSet::new();
        for (c, claim) in derivation.claims.iter().enumerate() {
            let content = known.claim(&claim.id).unwrap_or_default();
            let name = key(&[b"leaves", &known.names.base, content.as_bytes(), claim.name().as_bytes()]);
            let compute = || match claimed.binary_search(&c) {
                Ok(k) => leaves(k).iter().map(|leaf| named(&derivation.graph, leaf)).collect(),
                // It was not checked before, and is not now: what it asks for is not known.
                Err(_) => BTreeSet::from([String::new()]),
            };
            all.extend(known.memory.answer(&known.memory.wanted, Some(name), compute));
        }
        let mut asked = known.memory.asked.lock().unwrap_or_else(PoisonError::into_inner);
        if *asked.get_or_insert_with(|| all.clone()) == all {
            return;
        }
        if !known.memory.once {
            known.memory.other.store(true, Ordering::Relaxed);
            return;
        }
        // The motions are built for what is asked now; what others gave is of no use.
        *asked = Some(all);
        known.memory.verdicts.lock().unwrap_or_else(PoisonError::into_inner).clear();
        known.memory.standings.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// Whether a claim holds for all values.
    pub fn identity(&self, derivation: &Derivation, claim: &Claim, compute: impl FnOnce() -> Identity) -> Identity {
        let Some(known) = self.0 else { return compute() };
        known.memory.answer(&known.memory.identities, known.step(derivation, claim), compute)
    }

    /// The verdicts on claims on a motion, after a method has looked for stronger evidence: its name, and what it knows of
    /// the rest of the file. What it finds depends on that, on the claims, on the motions, on the verdicts before, and on what motions
    /// were built for.
    pub fn strengthened(
        &self,
        method: (&str, &str),
        derivation: &Derivation,
        t: usize,
        before: &[(&Claim, &Verdict)],
        compute: &mut dyn FnMut() -> Vec<Verdict>,
    ) -> Vec<Verdict> {
        let Some(known) = self.of_one_check() else { return compute() };
        known.memory.answer(&known.memory.strengthened, known.strengthened(method, derivation, t, before), compute)
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
        let name = self.0.and_then(|known| Some((known, known.on_families(derivation, claims)?)));
        let Some((known, name)) = name else { return compute(claims) };
        if let Some(OnFamilies { claims: found, measures }) = known.memory.known(&known.memory.on_families, name) {
            claims.iter_mut().zip(found).for_each(|(claim, found)| claim.families = found);
            return Ok(measures);
        }
        let measures = compute(claims)?;
        let found =
            OnFamilies { claims: claims.iter().map(|c| c.families.clone()).collect(), measures: measures.clone() };
        known.memory.answer(&known.memory.on_families, Some(name), || found);
        Ok(measures)
    }
}

/// A leaf, whatever the numbers of the graph are.
fn named(graph: &Graph, leaf: &Leaf) -> String {
    let instant = leaf.instant.map(|e| if e.index() < graph.len() { graph.to_latex(e) } else { String::new() });
    format!("{} {} {} {instant:?}", leaf.symbol.index(), leaf.component, leaf.rate)
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
            *age = known.memory.age;
            Arc::clone(family)
        };
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.again(derivation, requests, members)
    }

    fn keep(&self, derivation: &Derivation, members: &[usize], graph: Graph, built: &[(usize, Built)]) {
        let Some(known) = self.of_motions() else { return };
        if let Some(name) = known.family(derivation, members) {
            let family = Family::new(derivation, graph, members, built);
            let kept = (known.memory.age, Arc::new(Mutex::new(family)));
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
        let Some(known) = self.0 else { return compute() };
        let name = known.of_claim(derivation, claim, whole, t, &(place as u64 + 1).to_le_bytes());
        known.memory.answer(&known.memory.verdicts, name, compute)
    }

    fn standing(
        &self,
        derivation: &Derivation,
        says: &[&str],
        t: usize,
        compute: &dyn Fn() -> Option<bool>,
    ) -> Option<bool> {
        let Some(known) = self.0 else { return compute() };
        let name = known.motion(derivation, t).map(|motion| {
            let says = key(&says.iter().map(|text| text.as_bytes()).collect::<Vec<_>>());
            key(&[b"condition", &known.names.base, &says, &motion])
        });
        known.memory.answer(&known.memory.standings, name, compute)
    }
}

impl State<'_> {
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

    fn of_claim(&self, derivation: &Derivation, claim: &Claim, name: &str, t: usize, without: &[u8]) -> Option<Key> {
        // It depends on another motion, too.
        if claim.forms.iter().any(|f| matches!(f, Form::SameMotion { .. } | Form::Across(_))) {
            return None;
        }
        let content = self.claim(name.split('/').next()?)?;
        let motion = self.motion(derivation, t)?;
        Some(key(&[b"claim", &self.names.base, content.as_bytes(), name.as_bytes(), without, &motion]))
    }

    fn strengthened(
        &self,
        method: (&str, &str),
        derivation: &Derivation,
        t: usize,
        before: &[(&Claim, &Verdict)],
    ) -> Option<Key> {
        let asked = postcard::to_allocvec(&*self.memory.asked.lock().ok()?).ok()?;
        let mut sum = key(&[
            method.0.as_bytes(),
            method.1.as_bytes(),
            &self.names.base,
            &asked,
            // Claims may compare motions.
            &self.names.all_motions,
            derivation.trajectories.get(t)?.id.as_bytes(),
        ]);
        for (claim, verdict) in before {
            let verdict = postcard::to_allocvec(verdict).ok()?;
            sum = key(&[&sum, self.claim(&claim.id)?.as_bytes(), claim.name().as_bytes(), &verdict]);
        }
        Some(sum)
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
        let claim = |name: &String| match derivation.premise(name) {
            Premise::Claim(at) => Some(at),
            Premise::System(_) | Premise::Definition => None,
        };
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
