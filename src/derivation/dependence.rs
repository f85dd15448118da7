//! How a quantity depends on what a family varies: the words of claims that compare members.

/// How a quantity depends on what varies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dependence {
    /// It has the same value.
    Independent,
    /// It is larger for larger values.
    Increasing,
    /// It is smaller for larger values.
    Decreasing,
    /// The slope of its logarithm against that of what varies.
    Power {
        /// The slope.
        power: f64,
        /// How far it may be off.
        to: f64,
    },
}

impl Dependence {
    /// Whether neighbours are compared, so that values must follow one another.
    pub fn is_of_neighbours(self) -> bool {
        match self {
            Dependence::Independent => false,
            Dependence::Increasing | Dependence::Decreasing | Dependence::Power { .. } => true,
        }
    }
}

/// Why a member is compared with none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoOther {
    /// It is not tried as a member.
    NoMember,
    /// It is the one with which others are compared, or the last of its row.
    Last,
    /// So many did not satisfy the constraints that the search was ended.
    TooRare,
}
