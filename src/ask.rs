//! What is asked of a derivation, and of several together.

use crate::check::{Limits, Rigor};
use crate::derivation::Derivation;
use crate::diag::nearest;
use crate::session::{Failure, Session};

/// What is to be found.
#[derive(Clone, Debug, Default)]
pub struct Ask {
    /// Only claims with these names, `id` or `id/reading`; all when empty.
    pub claims: Vec<String>,
    /// Only trajectories and families with these ids; all when empty.
    pub trajectories: Vec<String>,
    /// How much is asked of a verdict.
    pub rigor: Rigor,
    /// The verdicts alone: no altered formulas, nothing that separates motions.
    pub only_verdicts: bool,
    /// When the run must end, how much memory it may take, and the flag that ends it.
    pub limits: Limits,
}

/// A name that nothing has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// What was meant by it: `claim` or `trajectory`.
    pub what: &'static str,
    /// The name.
    pub name: String,
    /// One that is there, and is spelled like it.
    pub near: Option<String>,
}

impl std::fmt::Display for Unknown {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "there is no {} `{}`", self.what, self.name)?;
        self.near.as_ref().map_or(Ok(()), |near| write!(f, "; did you mean `{near}`?"))
    }
}

impl Ask {
    /// The sessions that have something of what is asked, each with its own part of it.
    ///
    /// # Errors
    /// A name that none of them knows.
    pub fn of_each(&self, sessions: Vec<Session>) -> Result<Vec<(Session, Ask)>, Failure> {
        self.check_names(sessions.iter().map(Session::derivation))?;
        let own = |names: &[String], known: Vec<String>| -> Option<Vec<String>> {
            let own: Vec<String> = names.iter().filter(|name| known.contains(name)).cloned().collect();
            (own.is_empty() == names.is_empty()).then_some(own)
        };
        let of = |session: Session| {
            let claims = own(&self.claims, claim_names(session.derivation()))?;
            let trajectories = own(&self.trajectories, motions(session.derivation()))?;
            Some((session, Ask { claims, trajectories, ..self.clone() }))
        };
        Ok(sessions.into_iter().filter_map(of).collect())
    }

    /// Refuses a name that none of these derivations knows.
    pub(crate) fn check_names<'d>(&self, all: impl Iterator<Item = &'d Derivation> + Clone) -> Result<(), Unknown> {
        let claims: Vec<String> = all.clone().flat_map(claim_names).collect();
        let trajectories: Vec<String> = all.flat_map(motions).collect();
        for (what, asked, known) in [("claim", &self.claims, claims), ("trajectory", &self.trajectories, trajectories)]
        {
            if let Some(name) = asked.iter().find(|name| !known.contains(name)) {
                let near = nearest(name, known.iter().map(String::as_str)).map(str::to_owned);
                return Err(Unknown { what, name: name.clone(), near });
            }
        }
        Ok(())
    }
}

/// Every name by which claims can be called: `id`, and `id/reading`.
fn claim_names(derivation: &Derivation) -> Vec<String> {
    derivation.claims.iter().flat_map(|c| [c.id.clone(), c.name()]).collect()
}

/// The ids of trajectories and families.
fn motions(derivation: &Derivation) -> Vec<String> {
    let families = derivation.families.iter().map(|f| f.id.clone());
    derivation.trajectories.iter().map(|t| t.id.clone()).chain(families).collect()
}
