//! Which claims are tried on which motions.
//!
//! **In:** a file, and the names that were asked for. **Out:** a [`Selection`]: the only place where positions of one kind are made
//! into those of another.
//!
//! Three kinds of positions go through a check: those of claims and trajectories in the file; those among the claims that are tried,
//! in whose order accounts and verdicts of one motion stand; and those of initial times, of which many motions share one.

use crate::derivation::{Derivation, Trajectory};
use crate::expr::{FastMap, Leaf, Rational};

/// Which claims are tried on which motions.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// The claims that are tried along motions, by their positions in the file, increasing.
    pub claims: Vec<usize>,
    /// The trajectories that they are tried on, by their positions in the file, increasing.
    pub tried: Vec<usize>,
    /// The initial times of all trajectories of the file, each once for each choice of what is shared.
    pub starts: Vec<Rational>,
    /// For each of these the parameters that others stand for, see [`Derivation::shared_parameters`].
    pub shared: Vec<Vec<(Leaf, Leaf)>>,
    /// For each trajectory of the file the position of its initial time, and of what is shared on it.
    pub start_of: Vec<usize>,
}

/// Whether a name is among those that were asked for: all are when there are none.
pub fn is_asked(names: &[String], id: &str) -> bool {
    names.is_empty() || names.iter().any(|name| name == id)
}

impl Selection {
    /// The claims and trajectories with these ids; all for no ids. Claims over ranges need no motion, and are left out.
    pub fn new(derivation: &Derivation, claims: &[String], trajectories: &[String]) -> Selection {
        let (mut starts, mut shared): (Vec<Rational>, Vec<Vec<(Leaf, Leaf)>>) = Default::default();
        let start_of = |t: &Trajectory| {
            let start = Rational::try_from(t.initial_time).unwrap_or(Rational::ZERO);
            let own = derivation.shared_parameters(t);
            let known = starts.iter().zip(&shared).position(|(s, of)| *s == start && *of == own);
            known.unwrap_or_else(|| {
                starts.push(start);
                shared.push(own);
                starts.len() - 1
            })
        };
        let start_of = derivation.trajectories.iter().map(start_of).collect();
        let along = derivation.claims.iter().enumerate().filter(|(_, c)| !c.is_over_ranges());
        let claims = along.filter(|(_, c)| is_asked(claims, &c.id)).map(|(at, _)| at).collect();
        let tried = derivation.trajectories.iter().enumerate();
        let tried = tried.filter(|(_, t)| is_asked(trajectories, &t.id)).map(|(at, _)| at).collect();
        Selection { claims, tried, starts, shared, start_of }
    }

    /// The position of each trajectory that is tried among them, by its id.
    pub fn columns<'d>(&self, derivation: &'d Derivation) -> FastMap<&'d str, usize> {
        self.tried.iter().enumerate().map(|(at, &t)| (derivation.trajectories[t].id.as_str(), at)).collect()
    }
}
