//! Stand-in: nothing is checked, and every verdict says so. Replaced when the checks are merged.

use super::{Account, ClaimAccount, Evidence, Outcome, PairAccount, TrajectoryAccount, Verdict};
use crate::derivation::Derivation;
use crate::diag::Diagnostic;

/// What to check.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Ids of claims, `id` or `id/reading`; all if empty.
    pub claims: Vec<String>,
    /// Ids of trajectories; all if empty.
    pub trajectories: Vec<String>,
}

/// Why a check could not be made.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckError {
    /// Problems in the derivation file.
    Problems(Vec<Diagnostic>),
    /// The program contradicts itself: a defect to be reported.
    Defect(String),
}

/// Checks the claims of a derivation.
///
/// # Errors
/// Problems of the file that show only here.
pub fn check(
    derivation: &mut Derivation,
    options: &Options,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let wanted = |list: &[String], names: &[&str]| list.is_empty() || list.iter().any(|l| names.contains(&l.as_str()));
    let trajectories = derivation.trajectories.iter().filter(|t| wanted(&options.trajectories, &[&t.id]));
    let trajectories = trajectories.map(|t| TrajectoryAccount {
        id: t.id.clone(),
        title: t.title.clone(),
        span: t.span,
        source: t.source(),
        given: Vec::new(),
        steps: 0,
        error: 0.0,
        problem: None,
    });
    let claims = derivation.claims.iter().filter(|c| wanted(&options.claims, &[&c.id, &c.name()]));
    let claims = claims.map(|c| ClaimAccount {
        id: c.id.clone(),
        reading: c.reading.clone(),
        says: c.says.clone(),
        place: c.place.clone(),
        formulas: c.formulas.iter().map(|f| f.text.clone()).collect(),
        assumptions: c.assuming.iter().map(|a| a.text.clone()).collect(),
        remark: c.remark.clone(),
        results: c
            .trajectories
            .iter()
            .zip(&c.expect)
            .filter(|(t, _)| wanted(&options.trajectories, &[&derivation.trajectories[**t].id]))
            .map(|(t, expected)| PairAccount {
                trajectory: derivation.trajectories[*t].id.clone(),
                verdict: Verdict::new(
                    Outcome::Undecided,
                    Evidence { reason: Some("nothing was checked".into()), ..Evidence::default() },
                ),
                expected: *expected,
            })
            .collect(),
    });
    let account = Account { trajectories: trajectories.collect(), claims: claims.collect(), measurements: Vec::new() };
    progress(account.claims.len(), account.claims.len());
    Ok(account)
}
