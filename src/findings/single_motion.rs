//! What one motion alone could have decided.
//!
//! **In:** an [`Account`] with the discrimination of its pairs. **Out:** for each motion what would be known without the others:
//! how many claims do not apply to it, which hold on it and fail elsewhere, and how many of the altered formulas of those that
//! hold would hold as well.

use crate::{Account, ClaimAccount, PairAccount, TrajectoryAccount, WEAK};
use reason::Alone;
use std::collections::HashMap;
use verdict::Outcome;

fn name(claim: &ClaimAccount) -> String {
    match &claim.reading {
        Some(reading) => format!("{}/{reading}", claim.id),
        None => claim.id.clone(),
    }
}

impl Account {
    /// What each motion alone could have decided, in the order of the motions; empty where no variants were tried.
    pub fn alone(&self) -> Vec<Alone> {
        if self.claims.iter().all(|c| c.variants.is_none()) {
            return Vec::new();
        }
        let none = |t: &TrajectoryAccount| Alone { trajectory: t.id.clone(), ..Alone::default() };
        let mut all: Vec<Alone> = self.trajectories.iter().map(none).collect();
        let columns = self.columns();
        for claim in &self.claims {
            let fails = |p: &PairAccount| matches!(p.verdict.outcome(), Outcome::Fails(_));
            let misleads = claim.results.iter().any(fails);
            for pair in &claim.results {
                let Some(&column) = columns.get(pair.trajectory.as_str()) else { continue };
                let out = &mut all[column];
                out.tried += 1;
                match pair.verdict.outcome() {
                    Outcome::NotApplicable(_) => out.not_applicable += 1,
                    Outcome::Holds(_) => {
                        out.holds += 1;
                        if misleads {
                            out.misleading.push(name(claim));
                        }
                        if let Some(d) = &pair.discrimination {
                            out.weak += usize::from(d.is_weak());
                            out.rejected += d.rejected;
                            out.of += d.of;
                        }
                    }
                    Outcome::Fails(_) | Outcome::Undecided => {}
                }
            }
        }
        all
    }

    /// The place of each trajectory that was tried, by its id.
    pub fn columns(&self) -> HashMap<&str, usize> {
        self.trajectories.iter().enumerate().map(|(at, t)| (t.id.as_str(), at)).collect()
    }

    /// The motions that decide little by themselves, the poorest first: those that reject so few of the altered formulas that a
    /// single verdict would be called weak, and the poorest in any case. Empty where there is only one motion, or no altered
    /// formula.
    pub fn poor(&self) -> Vec<Alone> {
        let mut all = self.alone();
        if all.len() < 2 {
            return Vec::new();
        }
        all.retain(|a| a.of > 0);
        all.sort_by(|a, b| a.share().total_cmp(&b.share()));
        let poor = all.iter().take_while(|a| a.share() < WEAK).count();
        all.truncate(poor.max(1));
        all
    }
}
