//! From how conditions and a claim stand on the trajectories to an explanation.

use super::Truth;
use super::ask::Sides;
use super::candidates::Candidate;
use crate::findings::ClaimAccount;
use crate::findings::conditions::{ConditionName, Explanation, Join, Rival, Separation};
use crate::verdict::Outcome;
use std::collections::HashSet;

/// Most rivals that are named.
const MOST_RIVALS: usize = 5;
/// Most conditions that are put together.
const MOST_JOINED: usize = 3;
/// A condition is possible if it is undecided on no more than one in this many of the trajectories.
const MOST_OPEN: usize = 8;
/// Most partial explanations that are named.
const MOST_PARTIAL: usize = 3;
/// Most different conditions that are put together: they are tried in all pairs and triples.
const MOST_PARTS: usize = 60;

/// Whether a claim holds on some trajectories and fails on others.
pub(super) fn is_split(claim: &ClaimAccount) -> bool {
    let has = |want: fn(Outcome) -> bool| claim.results.iter().any(|p| want(p.verdict.outcome()));
    has(|o| matches!(o, Outcome::Holds(_))) && has(|o| matches!(o, Outcome::Fails(_)))
}

/// The trajectories on which a claim holds, and those on which it fails, by their positions among the ids.
pub(super) fn sides(claim: &ClaimAccount, ids: &[String]) -> Sides {
    let with = |want: fn(Outcome) -> bool| -> Vec<usize> {
        let so = claim.results.iter().filter(|p| want(p.verdict.outcome())).map(|p| p.trajectory.as_str());
        let so: HashSet<&str> = so.collect();
        (0..ids.len()).filter(|&i| so.contains(ids[i].as_str())).collect()
    };
    Sides { holds: with(|o| matches!(o, Outcome::Holds(_))), fails: with(|o| matches!(o, Outcome::Fails(_))) }
}

/// A condition, or several, on all trajectories.
#[derive(Clone)]
struct Reason {
    explanation: Explanation,
    truth: Truth,
    /// Smaller is better: those of the file first, then what is simpler.
    rank: (usize, usize, usize),
}

/// All of several conditions, or one of them; undecided where that leaves it open.
fn joined(parts: &[&Truth], join: Join) -> Truth {
    let count = parts.first().map_or(0, |t| t.len());
    (0..count).map(|i| join.of(parts.iter().map(|part| part[i]))).collect()
}

/// Whether `a` is met nowhere but where `b` is.
fn implies(a: &Truth, b: &Truth) -> bool {
    a.iter().zip(b).all(|(a, b)| *a == Some(false) || *b == Some(true))
}

/// What separates the trajectories of a claim. `ids` are those of all trajectories, in the order of the truths; `judged` are
/// the conditions that may explain something, of `tried` that were tried.
pub(super) fn separation(
    claim: &ClaimAccount,
    ids: &[String],
    judged: &[(&Candidate, &Truth)],
    tried: usize,
) -> Separation {
    let outcome = |id: &String| claim.on(id).map(|p| p.verdict.outcome());
    let stands: Vec<Option<bool>> = ids.iter().map(|id| outcome(id)?.truth()).collect();
    let named = |want: bool| -> Vec<String> {
        ids.iter().zip(&stands).filter(|(_, s)| **s == Some(want)).map(|(id, _)| id.clone()).collect()
    };
    let mut all: Vec<Reason> = Vec::new();
    for (position, (candidate, truth)) in judged.iter().enumerate() {
        let built = usize::from(candidate.name.id.is_none());
        let one = |name: ConditionName, truth: Truth, rank| {
            let explanation = Explanation { conditions: vec![name], join: Join::And };
            Reason { explanation, truth, rank }
        };
        all.push(one(candidate.name.clone(), Truth::clone(truth), (built, 1, position)));
        if built == 0 && candidate.fixed {
            let name = ConditionName { negated: true, ..candidate.name.clone() };
            let truth = truth.iter().map(|t| t.map(|t| !t)).collect();
            all.push(one(name, truth, (0, 2, position)));
        }
    }
    let relevant: Vec<usize> = (0..ids.len()).filter(|&i| stands[i].is_some()).collect();
    let decided = |o: &Reason| relevant.iter().all(|&i| o.truth[i].is_some());
    let undecided = judged.iter().filter(|(_, t)| relevant.iter().any(|&i| t[i].is_none())).count();
    // What is undecided on a few, and met exactly where the claim holds on all others.
    let open = |o: &Reason| relevant.iter().copied().filter(|&i| o.truth[i].is_none()).collect::<Vec<_>>();
    let agrees = |o: &Reason| relevant.iter().all(|&i| o.truth[i].is_none() || o.truth[i] == stands[i]);
    let may_explain = |o: &&Reason| (1..=relevant.len() / MOST_OPEN).contains(&open(o).len()) && agrees(o);
    let mut possible: Vec<&Reason> = all.iter().filter(may_explain).collect();
    possible.sort_by_key(|o| (open(o).len(), o.rank));
    let name = |o: &&Reason| {
        let on = open(o).into_iter().map(|i| ids[i].clone()).collect();
        o.explanation.conditions.first().map(|c| (c.clone(), on))
    };
    let possible: Vec<(ConditionName, Vec<String>)> = possible.iter().take(MOST_PARTIAL).filter_map(name).collect();
    all.retain(decided);
    let exact = |truth: &Truth| relevant.iter().all(|&i| truth[i] == stands[i]);
    let mut found: Vec<Reason> = all.iter().filter(|o| exact(&o.truth)).cloned().collect();
    if found.is_empty() {
        found = combinations(&all, &stands, &relevant);
    }
    let mut out = Separation {
        holds: named(true),
        fails: named(false),
        explanation: None,
        rivals: Vec::new(),
        more_rivals: 0,
        sufficient: Vec::new(),
        necessary: Vec::new(),
        possible: Vec::new(),
        tried,
        undecided,
    };
    // The weakest: none that is met on more. Those of the file come first among those that are equally weak.
    let weaker = |a: &Reason, b: &Reason| implies(&b.truth, &a.truth) && !implies(&a.truth, &b.truth);
    let from_file = |o: &&Reason| o.rank.0 == 0;
    let pool: Vec<&Reason> = found.iter().filter(from_file).collect();
    let pool: Vec<&Reason> = if pool.is_empty() { found.iter().collect() } else { pool };
    let weakest = pool.iter().filter(|o| !pool.iter().any(|p| weaker(p, o))).min_by_key(|o| o.rank);
    if let Some(best) = weakest {
        out.explanation = Some(best.explanation.clone());
        let mut rivals: Vec<&Reason> = found.iter().filter(|o| o.explanation != best.explanation).collect();
        rivals.sort_by_key(|o| o.rank);
        out.more_rivals = rivals.len().saturating_sub(MOST_RIVALS);
        let differ = |o: &Reason| {
            let apart = |i: &usize| matches!((o.truth[*i], best.truth[*i]), (Some(a), Some(b)) if a != b);
            (0..ids.len()).filter(apart).map(|i| ids[i].clone()).collect()
        };
        let rival = |o: &&Reason| Rival { explanation: o.explanation.clone(), differ_on: differ(o) };
        out.rivals = rivals.iter().take(MOST_RIVALS).map(rival).collect();
    } else {
        let count = |o: &Reason, stand: bool| {
            relevant.iter().filter(|&&i| o.truth[i] == Some(true) && stands[i] == Some(stand)).count()
        };
        let (holding, failing) = (out.holds.len(), out.fails.len());
        let mut sufficient: Vec<&Reason> = all.iter().filter(|o| count(o, false) == 0 && count(o, true) > 0).collect();
        sufficient.sort_by_key(|o| (holding - count(o, true), o.rank));
        let mut necessary: Vec<&Reason> =
            all.iter().filter(|o| count(o, true) == holding && count(o, false) < failing).collect();
        necessary.sort_by_key(|o| (count(o, false), o.rank));
        let part = |o: &&Reason, stand| o.explanation.conditions.first().map(|c| (c.clone(), count(o, stand)));
        out.sufficient = sufficient.iter().take(MOST_PARTIAL).filter_map(|o| part(o, true)).collect();
        out.necessary = necessary.iter().take(MOST_PARTIAL).filter_map(|o| part(o, false)).collect();
        out.possible = possible;
    }
    out
}

/// Few conditions that only together are met exactly where the claim holds: the fewest that do.
fn combinations(all: &[Reason], stands: &[Option<bool>], relevant: &[usize]) -> Vec<Reason> {
    for joined_count in 2..=MOST_JOINED {
        let mut found = Vec::new();
        for join in [Join::And, Join::Or] {
            // Parts of an `and` are met wherever the claim holds; parts of an `or` nowhere else.
            let needs = join == Join::And;
            let fits = |o: &&Reason| {
                let agrees = |&i: &usize| stands[i] != Some(needs) || o.truth[i] == Some(needs);
                let says = |&i: &usize| stands[i] == Some(!needs) && o.truth[i] == Some(!needs);
                relevant.iter().all(agrees) && relevant.iter().any(says)
            };
            let mut parts: Vec<&Reason> = Vec::new();
            let mut sorted: Vec<&Reason> = all.iter().filter(fits).collect();
            sorted.sort_by_key(|o| o.rank);
            for o in sorted {
                // Of those that are alike here, the first stands for all.
                let same = |p: &&Reason| relevant.iter().all(|&i| p.truth[i] == o.truth[i]);
                if parts.len() < MOST_PARTS && !parts.iter().any(same) {
                    parts.push(o);
                }
            }
            for choice in choices(parts.len(), joined_count) {
                let chosen: Vec<&Reason> = choice.iter().map(|&i| parts[i]).collect();
                let truths: Vec<&Truth> = chosen.iter().map(|o| &o.truth).collect();
                let truth = joined(&truths, join);
                if relevant.iter().all(|&i| truth[i] == stands[i]) {
                    let conditions = chosen.iter().flat_map(|o| o.explanation.conditions.clone()).collect();
                    let built = chosen.iter().map(|o| o.rank.0).sum();
                    let rank = (built, chosen.iter().map(|o| o.rank.1).sum(), found.len());
                    found.push(Reason { explanation: Explanation { conditions, join }, truth, rank });
                }
            }
        }
        if !found.is_empty() {
            return found;
        }
    }
    Vec::new()
}

/// All choices of k among n, in order.
fn choices(n: usize, k: usize) -> Vec<Vec<usize>> {
    if k == 0 {
        return vec![Vec::new()];
    }
    let mut out = Vec::new();
    for last in 0..n {
        for mut rest in choices(last, k - 1) {
            rest.push(last);
            out.push(rest);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const T: Option<bool> = Some(true);
    const F: Option<bool> = Some(false);

    #[test]
    fn undecided_is_neither() {
        assert_eq!(joined(&[&vec![T, T, F], &vec![T, None, None]], Join::And), [T, None, F]);
        assert_eq!(joined(&[&vec![F, F, T], &vec![F, None, None]], Join::Or), [F, None, T]);
        assert!(!implies(&vec![None], &vec![F]));
        assert!(implies(&vec![F, T], &vec![None, T]));
    }

    #[test]
    fn choices_are_complete() {
        assert_eq!(choices(4, 2).len(), 6);
        assert_eq!(choices(5, 3).len(), 10);
        assert_eq!(choices(3, 2), [[0, 1], [0, 2], [1, 2]]);
        assert!(choices(1, 2).is_empty());
    }
}
