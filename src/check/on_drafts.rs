//! Claims, tried on drafts of motions.
//!
//! **In:** a derivation; drafts, each with an id; claims, each with the drafts that it is tried on. **Out:** the verdicts; nothing for a
//! draft that is no motion: its values are refused, or it cannot be built. **Guaranteed:** a verdict is that on the very text of the
//! draft, put behind the text of the file.

use std::ops::Range;

use super::draft::Draft;
use super::memory::compares_motions;
use super::run::Run;
use crate::derivation::{Derivation, parse};
use crate::diag::{Diagnostic, Source};
use crate::verdict::Verdict;
use claim::error::CheckError;
use claim::limits::Limits;
use claim::options::Options;
use findings::{Account, ClaimAccount};

/// A claim, and the drafts that it is tried on.
pub(super) struct Asked {
    /// Its name, `id` or `id/reading`.
    pub name: String,
    /// The positions of the drafts, increasing.
    pub on: Vec<usize>,
}

/// How claims are tried.
pub(super) type Method = fn(&Run) -> Result<Account, CheckError>;

/// The verdicts of each claim on each of its drafts.
///
/// # Errors
/// The program contradicts itself.
pub(super) fn verdicts(
    derivation: &Derivation,
    drafts: &[(String, Draft)],
    asked: &[Asked],
    (method, limits): (Method, &Limits),
) -> Result<Vec<Vec<Option<Verdict>>>, CheckError> {
    let batch = Batch { derivation, drafts, asked, method, limits };
    let mut out: Vec<Vec<Option<Verdict>>> = asked.iter().map(|a| vec![None; a.on.len()]).collect();
    batch.fill((0..drafts.len()).collect(), &mut out)?;
    Ok(out)
}

struct Batch<'a> {
    derivation: &'a Derivation,
    drafts: &'a [(String, Draft)],
    asked: &'a [Asked],
    method: Method,
    limits: &'a Limits,
}

impl Batch<'_> {
    /// Puts the verdicts on some of the drafts, by their positions, in their places.
    fn fill(&self, mut some: Vec<usize>, out: &mut [Vec<Option<Verdict>>]) -> Result<(), CheckError> {
        while !some.is_empty() {
            let (text, places) = self.text(&some);
            let problems = match self.account(text, &some) {
                Ok(account) => {
                    self.take(&account, &some, out);
                    return Ok(());
                }
                Err(CheckError::Problems(problems)) => problems,
                Err(defect) => return Err(defect),
            };
            // Those that cannot be are told by their places; the others are tried without them.
            let is_refused = |place: &Range<usize>| problems.iter().any(|p| is_in(p, place));
            let refused: Vec<bool> = places.iter().map(is_refused).collect();
            if !refused.contains(&true) {
                let half = some.split_off(some.len() / 2);
                // Alone, it is the one that cannot be.
                return if some.is_empty() {
                    Ok(())
                } else {
                    self.fill(some, out)?;
                    self.fill(half, out)
                };
            }
            let mut refused = refused.into_iter();
            some.retain(|_| refused.next() == Some(false));
        }
        Ok(())
    }

    /// The text of the file with some drafts behind it, and where each of them stands.
    fn text(&self, some: &[usize]) -> (String, Vec<Range<usize>>) {
        let mut text = self.derivation.file.text.clone();
        let mut places = Vec::new();
        for (id, draft) in some.iter().filter_map(|&at| self.drafts.get(at)) {
            let start = text.len();
            text.push_str(&format!("\n{}", draft.table(id)));
            places.push(start..text.len());
        }
        (text, places)
    }

    fn account(&self, text: String, some: &[usize]) -> Result<Account, CheckError> {
        let path = self.derivation.file.path.clone();
        let mut read = parse(Source { path, text }, &self.derivation.id).map_err(CheckError::Problems)?;
        let mut first = read.trajectories.len() - some.len();
        // Other claims cost time: their symbols are computed along every motion.
        read.claims.retain(|c| self.asked.iter().any(|a| a.name == c.name()));
        if !read.claims.iter().any(compares_motions) {
            read.trajectories.drain(..first);
            read.families = Default::default();
            first = 0;
        }
        for claim in &mut read.claims {
            let asked = self.asked.iter().find(|a| a.name == claim.name());
            let is_asked = |at: &usize| asked.is_some_and(|a| a.on.binary_search(at).is_ok());
            claim.trajectories =
                some.iter().enumerate().filter(|(_, at)| is_asked(at)).map(|(k, _)| first + k).collect();
            claim.expect = vec![None; claim.trajectories.len()];
            // What a claim follows from is no matter of a motion.
            claim.follows_from.clear();
        }
        read.measures.clear();
        let claims = self.asked.iter().map(|a| a.name.split('/').next().unwrap_or(&a.name).to_owned()).collect();
        let trajectories = some.iter().filter_map(|&at| self.drafts.get(at)).map(|(id, _)| id.clone()).collect();
        let options = Options { claims, trajectories, plain: true, limits: self.limits.clone(), ..Options::default() };
        (self.method)(&Run::new(&read, &options))
    }

    fn take(&self, account: &Account, some: &[usize], out: &mut [Vec<Option<Verdict>>]) {
        for (asked, out) in self.asked.iter().zip(out) {
            let Some(claim) = account.claims.iter().find(|c| name(c) == asked.name) else { continue };
            let on = claim.on_each();
            for (at, verdict) in asked.on.iter().zip(out).filter(|(at, _)| some.binary_search(at).is_ok()) {
                let pair = self.drafts.get(*at).and_then(|(id, _)| on.get(id.as_str()));
                *verdict = pair.map(|pair| pair.verdict.clone());
            }
        }
    }
}

/// Whether a problem is of what stands there.
fn is_in(problem: &Diagnostic, place: &Range<usize>) -> bool {
    problem.place.as_ref().is_some_and(|label| place.contains(&label.span.start))
}

/// The name of a claim, `id` or `id/reading`.
pub(super) fn name(claim: &ClaimAccount) -> String {
    claim.reading.as_ref().map_or_else(|| claim.id.clone(), |reading| format!("{}/{reading}", claim.id))
}
