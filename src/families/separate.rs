//! Which condition separates the members on which a claim holds from those on which it fails, and what it says of fresh ones.
//!
//! **In:** a claim that holds on some members and fails on others. **Out:** the simplest condition that was found, and on how many fresh
//! members it says what is so ([`FamilySeparation`]). **Guaranteed:** the condition is found on members of the family alone, and tried on
//! motions that were not used to find it and are no members: their numbers follow the last one. Numbers determine both, so the same
//! file gives the same condition everywhere. It is evidence from motions and no proof, and no verdict is changed by it.
//!
//! **How:** up to [`MOST`] members, spread evenly, are tried as trajectories, and what separates trajectories is asked of them
//! (`separation`). A condition of the file comes first; then that one value that varies lies above or below a number; then
//! conditions that are built from the symbols; then that it lies between two numbers.

use std::collections::{BTreeMap, BTreeSet};

use super::member::{Member, Members};
use crate::derivation::{Claim, Derivation, Form};
use crate::expr::Graph;
use crate::findings::ClaimAccount;
use crate::findings::conditions::{ConditionName, Explanation, Join};
use crate::findings::family::{Exception, FamilySeparation, Tally};
use crate::verdict::Verdict;
use claim::error::CheckError;
use claim::options::Options;

/// The most members on which a condition is looked for, and the most fresh ones.
const MOST: u64 = 24;

/// What separates the members of a family may take one of so many parts of the work of a file, beside the file: nobody waits for a verdict
/// since it is looked for.
const PARTS: u64 = 10;

/// The most numbers that are looked at for members.
const LOOKED_AT: u64 = 4096;

/// The fewest members that say that a value lies between two numbers.
const FEWEST: usize = 3;

/// At most `most` of the numbers below `size`, spread evenly.
fn spread(size: u64, most: u64) -> Vec<u64> {
    (0..size.min(most)).map(|i| if size <= most { i } else { i * (size - 1) / (most - 1) }).collect()
}

/// A member that is tried as a trajectory: its values, and its id.
struct Tried {
    number: u64,
    values: Vec<f64>,
    id: String,
}

/// The derivation with some members as trajectories at its end; nothing where one of them is no motion.
fn with_members(
    derivation: &Derivation,
    members: &Members,
    of: impl Iterator<Item = (u64, Vec<f64>)>,
) -> Option<(Derivation, Vec<Tried>)> {
    let family = &members.family;
    let mut out = derivation.clone();
    out.families = <_>::default();
    out.measures.clear();
    out.pictures.clear();
    let base = derivation.trajectories.get(family.of)?;
    let taken: BTreeSet<String> = derivation.trajectories.iter().map(|t| t.id.clone()).collect();
    let mut tried = Vec::new();
    for (number, values) in of {
        let mut trajectory = family.member(&mut out.graph, base, number, &values)?;
        trajectory.id = family.member_id(number, |id| taken.contains(id));
        tried.push(Tried { number, values, id: trajectory.id.clone() });
        out.trajectories.push(trajectory);
    }
    Some((out, tried))
}

/// Whoever checks claims on trajectories: members are tried as such.
pub trait Checker {
    /// The accounts of the claims; with what separates the trajectories where `separating`.
    ///
    /// # Errors
    /// Trajectories that cannot be built, and defects of the program.
    fn check(
        &self,
        derivation: &Derivation,
        options: &Options,
        separating: bool,
    ) -> Result<Vec<ClaimAccount>, CheckError>;

    /// Conditions by their names, each as the claim that it is met at every time; `None` for one that the file does not give rise to.
    /// The graph is that of the file, and grows.
    fn conditions(&self, derivation: &Derivation, graph: &mut Graph, names: &[ConditionName]) -> Vec<Option<Claim>>;
}

/// Tries claims on the last trajectories.
fn try_on(
    checker: &dyn Checker,
    derivation: &mut Derivation,
    ids: BTreeSet<String>,
    tried: &[Tried],
    separating: bool,
    options: &Options,
) -> Result<Option<Vec<ClaimAccount>>, CheckError> {
    let count = derivation.trajectories.len();
    for claim in &mut derivation.claims {
        claim.families.clear();
        claim.expect_of_families.clear();
        claim.trajectories = (0..count).collect();
        claim.expect = vec![None; count];
    }
    let trajectories = tried.iter().map(|t| t.id.clone()).collect();
    let claims = ids.into_iter().collect();
    let options = Options { claims, trajectories, plain: true, limits: options.limits.clone(), ..Options::default() };
    match checker.check(derivation, &options, separating) {
        Ok(claims) => Ok(Some(claims)),
        // A motion that cannot be made is none to tell anything by.
        Err(CheckError::Problems(_)) => Ok(None),
        Err(defect) => Err(defect),
    }
}

/// The verdict on a trajectory.
fn verdict_on<'a>(account: &'a ClaimAccount, id: &str) -> Option<&'a Verdict> {
    account.results.iter().find(|p| p.trajectory == id).map(|p| &p.verdict)
}

/// Whether a claim holds on a trajectory; `None` where that is undecided, or it does not apply.
fn stand(account: &ClaimAccount, id: &str) -> Option<bool> {
    verdict_on(account, id)?.outcome().truth()
}

/// That a value lies above or below a number.
#[derive(Clone, Debug, PartialEq)]
struct Threshold {
    /// The position of what varies.
    varied: usize,
    number: f64,
    above: bool,
}

impl Threshold {
    fn is_met(&self, values: &[f64]) -> Option<bool> {
        let x = values.get(self.varied)?;
        Some(if self.above { *x > self.number } else { *x < self.number })
    }
}

/// The number with the fewest digits between two others, near their middle.
fn between(a: f64, b: f64) -> Option<f64> {
    let middle = a + (b - a) / 2.0;
    let short = (0..17).filter_map(|digits| format!("{middle:.digits$e}").parse::<f64>().ok());
    short.chain([middle]).find(|x| a < *x && *x < b)
}

/// What separates members by one of their values: above or below a number, or between two; as few numbers as possible.
fn thresholds(of: &[(&[f64], bool)], varied: usize) -> Option<(Vec<Threshold>, Join)> {
    let mut row: Vec<(f64, bool)> =
        of.iter().filter_map(|(values, holds)| Some((*values.get(varied)?, *holds))).collect();
    row.sort_by(|a, b| a.0.total_cmp(&b.0));
    let changes: Vec<&[(f64, bool)]> = row.windows(2).filter(|w| w[0].1 != w[1].1).collect();
    if changes.is_empty() || changes.len() > 2 {
        return None;
    }
    let one = |w: &&[(f64, bool)]| Some(Threshold { varied, number: between(w[0].0, w[1].0)?, above: w[1].1 });
    // Any few could be fenced in by chance.
    let inside = row.iter().filter(|(_, holds)| *holds != row[0].1).count();
    if changes.len() == 2 && inside < FEWEST {
        return None;
    }
    let found: Option<Vec<Threshold>> = changes.iter().map(one).collect();
    // Between two numbers, or outside of them.
    let join = if changes[0][1].1 { Join::And } else { Join::Or };
    Some((found?, join))
}

/// A condition that was found.
struct Condition {
    explanation: Explanation,
    /// Where it is about values that vary: these.
    thresholds: Vec<Threshold>,
}

/// The simplest condition, of what separates trajectories and what separates by one value.
fn simplest(found: Option<Explanation>, of: &[(&[f64], bool)], members: &Members) -> Option<Condition> {
    let family = &members.family;
    let by_value = |numbers: usize| {
        let mut each = (0..family.vary.len()).filter_map(|varied| thresholds(of, varied));
        let (thresholds, join) = each.find(|(thresholds, _)| thresholds.len() == numbers)?;
        let name = |t: &Threshold| ConditionName {
            id: None,
            formula: format!("{}{}{:?}", family.vary[t.varied].name, if t.above { ">" } else { "<" }, t.number),
            says: None,
            negated: false,
        };
        let explanation = Explanation { conditions: thresholds.iter().map(name).collect(), join };
        Some(Condition { explanation, thresholds })
    };
    let of_file = |e: &Explanation| e.conditions.iter().all(|c| c.id.is_some());
    let plain = |explanation: Explanation| Condition { explanation, thresholds: Vec::new() };
    let is_single = |e: &Explanation| e.conditions.len() == 1;
    match found {
        Some(e) if of_file(&e) => Some(plain(e)),
        Some(e) if is_single(&e) => by_value(1).or_else(|| Some(plain(e))),
        Some(e) => by_value(1).or_else(|| by_value(2)).or_else(|| Some(plain(e))),
        None => by_value(1).or_else(|| by_value(2)),
    }
}

/// Whether it is asked of a claim what separates its members.
fn is_asked(claim: &Claim, tally: &Tally) -> bool {
    let whole = tally.first_defect.is_none() && !claim.is_over_ranges();
    let compared = claim.forms.iter().any(|f| matches!(f, Form::Across(_)));
    tally.counts.holds > 0 && tally.counts.fails > 0 && whole && !compared
}

/// What separates the members of each claim that holds on some and fails on others.
///
/// # Errors
/// The run was cancelled; the program contradicts itself.
pub fn separations(
    checker: &dyn Checker,
    derivation: &Derivation,
    members: &Members,
    asked: &[&Claim],
    tallies: &[Tally],
    options: &Options,
) -> Result<Vec<Option<FamilySeparation>>, CheckError> {
    let mut out: Vec<Option<FamilySeparation>> = vec![None; asked.len()];
    let split: Vec<usize> = (0..asked.len()).filter(|&n| is_asked(asked[n], &tallies[n])).collect();
    if options.plain || split.is_empty() || options.limits.reached().is_some() {
        return Ok(out);
    }
    let options = &Options { limits: options.limits.of_part(PARTS), ..options.clone() };
    let family = &members.family;
    let size = family.size();
    // Of those that satisfy the constraints.
    let member = |number: u64| match members.member(number) {
        Member::Found(values, _) => Some((number, values)),
        Member::Rejected | Member::TooRare => None,
    };
    let some: Vec<(u64, Vec<f64>)> = spread(size, LOOKED_AT).into_iter().map(|i| i + 1).filter_map(member).collect();
    let mut found: BTreeMap<u64, Vec<f64>> =
        spread(some.len() as u64, MOST).into_iter().filter_map(|i| some.get(i as usize).cloned()).collect();
    found.extend(split.iter().flat_map(|&n| tallies[n].kept()).filter_map(member));
    let found = found.into_iter();
    let Some((mut of_members, tried)) = with_members(derivation, members, found) else { return Ok(out) };
    let ids = || split.iter().map(|&n| asked[n].id.clone()).collect::<BTreeSet<String>>();
    let Some(accounts) = try_on(checker, &mut of_members, ids(), &tried, true, options)? else { return Ok(out) };
    let account = |accounts: &[ClaimAccount], claim: &Claim| {
        accounts.iter().position(|a| a.id == claim.id && a.reading == claim.reading)
    };
    let mut conditions: Vec<(usize, Condition)> = Vec::new();
    for &n in &split {
        let Some(at) = account(&accounts, asked[n]) else { continue };
        let of: Vec<(&[f64], bool)> =
            tried.iter().filter_map(|t| Some((t.values.as_slice(), stand(&accounts[at], &t.id)?))).collect();
        let holds = of.iter().filter(|(_, holds)| *holds).count();
        let separation = accounts[at].conditions.separation.as_ref();
        // A condition of the file itself, which is no reason for what it says.
        if separation.is_none() || holds == 0 || holds == of.len() {
            continue;
        }
        let found = simplest(separation.and_then(|s| s.explanation.clone()), &of, members);
        let none = FamilySeparation {
            explanation: found.as_ref().map(|c| c.explanation.clone()),
            sides: (holds, of.len() - holds),
            right: 0,
            wrong: 0,
            open: 0,
            exception: None,
        };
        out[n] = Some(none);
        conditions.extend(found.map(|c| (n, c)));
    }
    let fresh = (0..MOST).filter_map(|n| Some((size + 1 + n, members.fresh(size + 1 + n)?)));
    let fresh: Vec<(u64, Vec<f64>)> = fresh.collect();
    if conditions.is_empty() || fresh.is_empty() {
        return Ok(out);
    }
    let Some((mut of_fresh, tried)) = with_members(derivation, members, fresh.into_iter()) else { return Ok(out) };
    // The conditions are claims beside the others.
    let names =
        conditions.iter().flat_map(|(_, c)| c.explanation.conditions.iter().filter(|_| c.thresholds.is_empty()));
    let names: Vec<ConditionName> = names.cloned().collect();
    let mut graph = of_fresh.graph.clone();
    let probes = checker.conditions(&of_fresh, &mut graph, &names);
    of_fresh.graph = graph;
    let mut all = ids();
    all.extend(probes.iter().flatten().map(|c| c.id.clone()));
    let probe_ids: Vec<(ConditionName, String)> =
        names.into_iter().zip(&probes).filter_map(|(name, c)| Some((name, c.as_ref()?.id.clone()))).collect();
    let mut added = BTreeSet::new();
    of_fresh.claims.extend(probes.into_iter().flatten().filter(|c| added.insert(c.id.clone())));
    let Some(accounts) = try_on(checker, &mut of_fresh, all, &tried, false, options)? else { return Ok(out) };
    for (n, condition) in &conditions {
        let (Some(at), Some(separation)) = (account(&accounts, asked[*n]), &mut out[*n]) else { continue };
        for of in &tried {
            let Condition { explanation, thresholds } = condition;
            let part = |name: &ConditionName| {
                let id = &probe_ids.iter().find(|(known, _)| known == name)?.1;
                let probe = accounts.iter().find(|a| a.id == *id)?;
                verdict_on(probe, &of.id)?.is_met().map(|met| met != name.negated)
            };
            let met = match thresholds.is_empty() {
                true => explanation.join.of(explanation.conditions.iter().map(part)),
                false => explanation.join.of(thresholds.iter().map(|t| t.is_met(&of.values))),
            };
            match (met, stand(&accounts[at], &of.id)) {
                (Some(met), Some(holds)) if met == holds => separation.right += 1,
                (Some(_), Some(holds)) => {
                    separation.wrong += 1;
                    let exception = || Exception {
                        values: family.vary.iter().map(|v| v.name.clone()).zip(of.values.iter().copied()).collect(),
                        holds,
                        toml: family.toml(&of.id, of.number, &of.values),
                    };
                    separation.exception.get_or_insert_with(exception);
                }
                _ => separation.open += 1,
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_spread_from_the_first_to_the_last() {
        assert_eq!(spread(3, 48), [0, 1, 2]);
        assert_eq!(spread(0, 48), [0; 0]);
        let of = spread(1_000_000_000, 48);
        assert!(of.len() == 48 && of[0] == 0 && of[47] == 999_999_999 && of.windows(2).all(|w| w[0] < w[1]));
    }

    #[test]
    fn a_number_between_has_few_digits() {
        assert_eq!(between(2.9, 3.01), Some(3.0));
        assert_eq!(between(0.1, 0.2), Some(0.15));
        assert_eq!(between(-1.0, 1.0), Some(0.0));
        assert_eq!(between(1.0, 1.0), None);
        assert_eq!(between(1.0, 1.0 + f64::EPSILON), None);
    }

    #[test]
    fn one_value_separates_by_one_number_or_two() {
        let of = |stands: &[bool]| {
            let values: Vec<Vec<f64>> = (0..stands.len()).map(|i| vec![7.0, i as f64]).collect();
            let rows: Vec<(&[f64], bool)> = values.iter().map(Vec::as_slice).zip(stands.iter().copied()).collect();
            assert_eq!(thresholds(&rows, 0), None, "what is the same for all separates nothing");
            let found = thresholds(&rows, 1)?;
            // It says what is so of all of them.
            for (values, holds) in &rows {
                assert_eq!(found.1.of(found.0.iter().map(|t| t.is_met(values))), Some(*holds), "{stands:?}");
            }
            Some(found.0.len())
        };
        assert_eq!(of(&[true, true, false]), Some(1));
        assert_eq!(of(&[false, true, true]), Some(1));
        assert_eq!(of(&[false, true, true, true, false]), Some(2));
        assert_eq!(of(&[true, false, false, false, true]), Some(2));
        assert_eq!(of(&[true, false, false, true, true, true]), None, "two are too few");
        assert_eq!(of(&[true, false, true, false]), None);
    }

    #[test]
    fn what_is_open_is_neither() {
        let (t, f) = (Some(true), Some(false));
        assert_eq!(Join::And.of([t, None]), None);
        assert_eq!(Join::And.of([f, None]), f);
        assert_eq!(Join::Or.of([t, None]), t);
        assert_eq!(Join::Or.of([f, None]), None);
    }
}
