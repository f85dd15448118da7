//! What an identity test is asked and what it answers.

use super::known::{Known, When};
use expr::{Expr, Graph, Leaf, Rational, Symbol};

/// What may be used in a proof.
#[derive(Clone, Debug, Default)]
pub struct Premises {
    /// Equations that hold: definitions, systems, assumptions, earlier claims; each with the times at which it does.
    pub equations: Vec<Known>,
    /// The times that the question is about: the signs that follow are known at these.
    pub present: When,
    /// Expressions that are not 0.
    pub nonzero: Vec<Expr>,
    /// Expressions that are positive (declared parameters, assumptions).
    pub positive: Vec<Expr>,
    /// Expressions that are not negative (assumptions).
    pub not_negative: Vec<Expr>,
    /// The leaf for time. With it and `moving`, equations are differentiated by time as often as the rates that occur ask for.
    pub time: Option<Leaf>,
    /// Symbols that depend on time.
    pub moving: Vec<Symbol>,
    /// Symbols whose values are continued through any number of turns: their definitions do not leap.
    pub angles: Vec<Symbol>,
    /// What moves and has a formula that is not smooth: the symbol with what vanishes where the formula has an edge. Its rates are known
    /// to exist elsewhere only.
    pub edges: Vec<(Symbol, Expr)>,
    /// Leaves that are kept free as long as something else can be solved for: parameters of the problem.
    pub parameters: Vec<Leaf>,
}

impl Premises {
    /// The equations, whenever they hold: what may be used at the present.
    pub fn pairs(&self) -> impl DoubleEndedIterator<Item = (Expr, Expr)> + Clone + '_ {
        self.equations.iter().map(Known::sides)
    }

    /// Both sides of all of them.
    pub fn sides(&self) -> impl Iterator<Item = Expr> + Clone + '_ {
        self.equations.iter().flat_map(|k| [k.left, k.right])
    }

    /// The expressions whose signs are known, of whatever kind.
    pub fn signs(&self) -> impl Iterator<Item = Expr> + Clone + '_ {
        self.nonzero.iter().chain(&self.positive).chain(&self.not_negative).copied()
    }

    /// Whether an equation is among them.
    pub fn says(&self, pair: (Expr, Expr)) -> bool {
        self.equations.iter().any(|k| k.sides() == pair)
    }

    /// Adds equations.
    pub fn give(&mut self, pairs: impl IntoIterator<Item = (Expr, Expr)>, when: When) {
        self.equations.extend(pairs.into_iter().map(|pair| Known::of(pair, when)));
    }
}

/// What an answer is wanted for: of answers between which it does not tell, any is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// Everything: what is proved, refuted, or open, and why.
    #[default]
    Answer,
    /// Whether it is proved.
    Proof,
    /// Whether a point refutes it, or what is given contradicts itself.
    Fault,
}

/// How an identity is tested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Start of the generator of primes and points.
    pub seed: u64,
    /// log₂ of the largest acceptable probability of proving something false.
    pub target_log2_error: f64,
    /// Largest number of independent signs (of roots, of |·|): all 2ⁿ choices are tested.
    pub most_signs: u32,
    /// Number of real points tried for a witness.
    pub attempts: u32,
    /// How many pivots are looked at by themselves: the case that they vanish.
    pub special_cases: u32,
    /// Solving the premises is given up when it has made this many nodes.
    pub most_nodes: usize,
    /// What the answer is wanted for.
    pub wanted: Wanted,
    /// Whether roots are written by other roots, logarithms are taken apart, and signs are looked for in ranges. What is left
    /// open without is asked again with it, where it is small: what is open for other reasons would only cost more.
    pub further: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            seed: 0x5EED,
            target_log2_error: -100.0,
            most_signs: 10,
            attempts: 240,
            special_cases: 8,
            most_nodes: 20_000,
            wanted: Wanted::Answer,
            further: false,
        }
    }
}

/// The answer for "these equations hold wherever the premises do and both sides have a value".
#[derive(Clone, Debug, PartialEq)]
pub enum Identity {
    /// They do, except with the stated probability over the draws of primes and points.
    Proved(Proof),
    /// They do not: a real point shows it.
    Refuted(Box<Refutation>),
    /// Neither was established.
    Undecided(Reason),
}

/// What a proof rests on. See [`identity_test`](super::identity_test) for the theorem.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// log₂ of the bound for the probability of a false proof.
    pub log2_error: f64,
    /// Bound for the degree of the norms whose vanishing was tested.
    pub degree_bound: f64,
    /// Bound for log₂ of their coefficients.
    pub height_bound: f64,
    /// Number of independent trials, each with a prime and points of its own.
    pub trials: usize,
    /// The primes, in order of cases and trials.
    pub primes: Vec<u64>,
    /// The most independent signs of roots and |·| in a case; all choices were tested.
    pub signs: usize,
    /// Cases into which products among the premises were split.
    pub cases: usize,
    /// What must hold for the formulas to have a value and for the premises to be solved, beyond what was given.
    pub conditions: Vec<Condition>,
    /// A real point that satisfies all premises and conditions, at which the equations were seen to hold numerically;
    /// `None` when none was found: the conditions may be empty.
    pub example: Option<Point>,
}

/// A condition under which a proof holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Condition {
    /// A denominator of a formula is not 0.
    Denominator(Expr),
    /// Divided by while solving the premises: not 0. Common solutions at which it vanishes were not tested, unless they are
    /// limits of others.
    Pivot(Expr),
    /// Not 0, so that a rate of something given has a value, for which neither the claim asks nor what is given: where it vanishes,
    /// nothing follows by that rate.
    Rate(Expr),
    /// Under a square root of a formula: not negative.
    Radicand(Expr),
    /// Of a premise that is quadratic in an unknown: not negative wherever the premises hold, which nothing but they says.
    Discriminant(Expr),
    /// Argument of arccos or arcsin: in [−1, 1].
    Unit(Expr),
    /// Argument of a logarithm or base of a power: positive.
    Positive(Expr),
}

impl Condition {
    /// What it is about.
    pub fn subject(self) -> Expr {
        match self {
            Condition::Denominator(e) | Condition::Pivot(e) | Condition::Rate(e) | Condition::Radicand(e) => e,
            Condition::Discriminant(e) | Condition::Unit(e) | Condition::Positive(e) => e,
        }
    }

    /// Whether a case is left out where its subject vanishes.
    pub fn leaves_out(self) -> Option<Expr> {
        match self {
            Condition::Pivot(e) | Condition::Rate(e) => Some(e),
            Condition::Denominator(_) | Condition::Radicand(_) | Condition::Discriminant(_) => None,
            Condition::Unit(_) | Condition::Positive(_) => None,
        }
    }
}

/// Values of leaves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point {
    /// In order of first appearance in the graph.
    pub values: Vec<(Leaf, PointValue)>,
}

/// A value in a witness.
#[derive(Clone, Debug, PartialEq)]
pub struct PointValue {
    /// Exactly, where it is rational.
    pub exact: Option<Rational>,
    /// (cos, sin) exactly, where the leaf is an angle with rational cosine and sine.
    pub circle: Option<(Rational, Rational)>,
    /// In decimals.
    pub decimal: f64,
    /// How far the value may be from these, beside rounding.
    pub error: f64,
}

/// One side of an equation at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// Exactly, where all roots are rational.
    pub exact: Option<Rational>,
    /// In decimals, evaluated from the formula as written.
    pub decimal: f64,
}

/// A real point that satisfies the premises and not the equation.
#[derive(Clone, Debug, PartialEq)]
pub struct Refutation {
    /// Number of the equation among those tested.
    pub equation: usize,
    /// The point.
    pub point: Point,
    /// What the sides name. The other values of a point are what the premises ask for.
    pub named: Vec<Leaf>,
    /// Left side there.
    pub left: Side,
    /// Right side there.
    pub right: Side,
    /// Another point that satisfies the premises, with another difference of the sides: the premises do not fix it.
    pub second: Option<(Point, Side, Side)>,
}

impl Refutation {
    /// The values of one of its points that the sides name, and those that the premises ask for beyond that. A point of few values, or
    /// whose values are all of the second kind, is not parted.
    pub fn parted<'p>(&self, point: &'p Point) -> [Vec<&'p (Leaf, PointValue)>; 2] {
        let (named, beyond): (Vec<_>, Vec<_>) = point.values.iter().partition(|(leaf, _)| self.named.contains(leaf));
        match named.is_empty() || point.values.len() <= FEW_VALUES {
            true => [point.values.iter().collect(), Vec::new()],
            false => [named, beyond],
        }
    }
}

/// A point of no more values is shown as a whole.
const FEW_VALUES: usize = 8;

/// Why an identity is undecided.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// The premises cannot hold together: anything would follow.
    Contradiction,
    /// A premise that could not be solved for any unknown.
    Unsolved(Expr),
    /// Some formula divides by something that vanishes identically under the premises.
    NoValue,
    /// Every way of solving the premises divides by something that vanishes wherever they hold.
    Degenerate,
    /// The premises have no solution at which this base of a power is positive; where it is 0 was not decided.
    Boundary(Expr),
    /// The premises have no solution unless this vanishes, and that case was not decided.
    OnlyWhere(Expr),
    /// It fails over the field on `failing` of `of` choices of signs of roots, but no real point was found where it fails.
    Branches {
        /// Choices at which an equation fails.
        failing: usize,
        /// Choices at which the premises hold.
        of: usize,
    },
    /// More independent roots than [`Options::most_signs`].
    TooManyRoots(usize),
    /// More cases, generators or exponents than are looked at.
    TooLarge,
    /// A derivative by time that cannot be written.
    NoDerivative,
    /// The bound could not be brought below the target within a reasonable number of trials.
    Bound(f64),
    /// Real points satisfy what is given and its derivatives, and not the claim; that a motion passes through one of them was
    /// not shown.
    Unextended,
    /// Each choice of ± is refuted, by points that need not belong to one motion.
    EachSign,
    /// No point of the field was found at which all roots exist.
    NoPoint,
    /// A relation between roots that held at all random points of the preparation does not hold at others: try another seed.
    Coincidence,
    /// The field test and the real points contradict each other: a defect of this program.
    Defect(String),
}

impl Reason {
    /// Whether the premises were not solved, in any order: not a matter of the points that were tried.
    pub(super) fn is_about_solving(&self) -> bool {
        let divided = matches!(self, Reason::Unsolved(_) | Reason::OnlyWhere(_) | Reason::Degenerate);
        divided || matches!(self, Reason::TooLarge | Reason::TooManyRoots(_))
    }
}

impl Proof {
    /// log₂ of the bound of a proof that uses no random number: far below every other.
    pub const CERTAIN: f64 = -1e9;

    /// Whether nothing random is in it: both sides are algebraic numbers, compared exactly.
    pub fn is_certain(&self) -> bool {
        self.trials == 0
    }
}

impl Identity {
    /// The word of the report contract.
    pub fn word(&self) -> &'static str {
        match self {
            Identity::Proved(_) => "proved",
            Identity::Refuted(_) => "refuted",
            Identity::Undecided(_) => "undecided",
        }
    }
}

impl std::fmt::Display for Reason {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Reason::Contradiction => f.write_str("the premises contradict each other, or exclude what the formulas need; nothing follows from them"),
            Reason::Unsolved(_) => f.write_str("a premise could not be solved for any of its unknowns"),
            Reason::NoValue => f.write_str("a formula divides by something that is 0 wherever the premises hold"),
            Reason::Degenerate => {
                f.write_str("the premises were not solved: each way divides by something that is 0 wherever they hold")
            }
            Reason::Boundary(_) => {
                f.write_str("the premises hold at most where the base of a power is 0, which was not decided")
            }
            Reason::OnlyWhere(_) => f.write_str(
                "the premises hold at most where something vanishes that was divided by; that was not decided",
            ),
            // False for every choice of signs, unless there is a relation that is not known.
            Reason::Branches { failing, of } if failing == of => f.write_str(
                "no relation is known that makes the sides equal, and no real point was found at which they differ",
            ),
            Reason::Branches { failing, of } => write!(
                f,
                "it depends on the signs of roots: false for {failing} of {of} choices, and no real point decides"
            ),
            Reason::TooManyRoots(n) => write!(f, "{n} independent square roots are more than are tried"),
            Reason::TooLarge => f.write_str("too many cases, exponents or transcendental arguments"),
            Reason::NoDerivative => f.write_str("a derivative by time cannot be written with the known operations"),
            Reason::Bound(b) => write!(f, "the error bound stays at 2^{b:.0}"),
            Reason::Unextended => f.write_str(
                "a point satisfies what is given, and not the claim; but that a motion, or a field, passes through it was not shown",
            ),
            Reason::EachSign => f.write_str(
                "neither sign serves for all motions; that neither serves for one of them was not shown",
            ),
            Reason::NoPoint => f.write_str("no point of the field was found at which all square roots exist"),
            Reason::Coincidence => f.write_str("a relation between roots held at some random points only"),
            Reason::Defect(what) => write!(f, "the two routes disagree, a defect of this program: {what}"),
        }
    }
}

/// Whether an expression is 0 wherever it has a value, given premises.
pub(super) type Vanishes = fn(&mut Graph, Expr, &Premises) -> bool;
