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
    /// At a value of what varies it is larger, or smaller, than at all values that are far enough from that one.
    Extremum {
        /// Whether it is larger there.
        maximum: bool,
        /// From which distance on.
        to: f64,
    },
    /// It tends to a value.
    Limit {
        /// What the symbol tends to.
        end: End,
        /// How far the limit may be off.
        to: f64,
    },
}

/// What a symbol tends to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A number.
    Number,
    /// It grows without bound.
    Infinity,
    /// It falls without bound.
    MinusInfinity,
}

impl Dependence {
    /// Whether neighbours are compared, so that values must follow one another.
    pub fn is_of_neighbours(self) -> bool {
        match self {
            Dependence::Independent | Dependence::Extremum { .. } | Dependence::Limit { .. } => false,
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
    /// The motion that it would be compared with does not satisfy the constraints.
    Rejected,
    /// It lies nearer to the place of the extremum than what the claim speaks of.
    Near,
    /// It lies where the symbol tends to, or beyond.
    Beyond,
}
