//! Why an enclosure does not decide: in words, and as numbers.
//!
//! **In:** what is open, and where. **Out:** [`Why`], whose words are remarks on a verdict, and whose [`Obstacle`] goes beside them
//! as data. **Guaranteed:** every number of the words is one of the obstacle.

use crate::number::Interval;
use crate::verdict::Obstacle;

/// Why something is not shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Why {
    pub words: String,
    /// What encloses the difference of two sides that cannot be told apart.
    difference: Option<(f64, f64)>,
    place: Option<(f64, f64)>,
}

impl Why {
    /// Of two sides whose difference is enclosed by this.
    pub fn apart(self, range: Interval) -> Why {
        Why { difference: Some((range.lo(), range.hi())), ..self }
    }

    /// On a stretch that is not halved any more.
    pub fn on(self, time: Interval) -> Why {
        let words = format!("{}, on [{:.6}, {:.6}]", self.words, time.lo(), time.hi());
        Why { words, place: Some((time.lo(), time.hi())), ..self }
    }

    /// At a time that no shorter stretch could help.
    pub fn at(self, time: f64) -> Why {
        let words = format!("{}, at t = {time:.6}, where the enclosure is too wide", self.words);
        Why { words, place: Some((time, time)), ..self }
    }

    /// At an event.
    pub fn at_event(self, time: Interval) -> Why {
        let words = format!("{}, at the event at t = {:.6}", self.words, time.mid());
        Why { words, place: Some((time.lo(), time.hi())), ..self }
    }

    /// Where it is, if it is somewhere.
    pub fn obstacle(&self) -> Option<Obstacle> {
        let (from, to) = self.place?;
        Some(Obstacle { from, to, difference: self.difference })
    }
}

impl From<String> for Why {
    fn from(words: String) -> Why {
        Why { words, ..Why::default() }
    }
}

impl From<&str> for Why {
    fn from(words: &str) -> Why {
        Why::from(words.to_owned())
    }
}
