//! What can go wrong with a system or a motion.

use expr::{Graph, Leaf};
use number::NoValue;

/// Why a system cannot be solved for its rates, or a motion cannot be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FlowError {
    /// An equation in which a rate does not enter linearly.
    #[error("equation {} is not linear in {rate}", equation + 1)]
    Nonlinear {
        /// Position of the equation, counted from 0.
        equation: usize,
        /// The rate, as a formula writes it.
        rate: String,
    },
    /// An equation between quantities without a rate: it constrains the state instead of moving it.
    #[error("equation {} contains no rate of a state: it is a constraint, not an equation of motion", equation + 1)]
    Constraint {
        /// Position of the equation, counted from 0.
        equation: usize,
    },
    /// A state of which no rate occurs in any equation.
    #[error("no equation contains a rate of {state}")]
    NoEquation {
        /// The state, as a formula writes it.
        state: String,
    },
    /// The equations that are left for a rate determine other rates already (structurally singular).
    #[error("the equations do not determine {rate}: {found} equations for {needed} rates")]
    Undetermined {
        /// The rate, as a formula writes it.
        rate: String,
        /// Number of equations that contain a rate.
        found: usize,
        /// Number of rates to be determined.
        needed: usize,
    },
    /// More equations than rates, even if they agree with one another: leave the repetition out.
    #[error(
        "equation {} is one too many: {found} equations for {needed} rates (leave repeated equations out, also \
         consistent ones)", equation + 1
    )]
    OverDetermined {
        /// Position of the equation, counted from 0.
        equation: usize,
        /// Number of equations that contain a rate.
        found: usize,
        /// Number of rates to be determined.
        needed: usize,
    },
    /// A leaf that the motion does not know.
    #[error("{leaf} is neither the time, a parameter, a state nor an observable of this motion")]
    UnknownLeaf {
        /// The leaf, as a formula writes it.
        leaf: String,
    },
    /// A rate that cannot be written as an expression.
    #[error("{leaf} cannot be derived by time: {reason}")]
    NoDerivative {
        /// The leaf, as a formula writes it.
        leaf: String,
        /// Which operation has no derivative.
        reason: expr::NoDerivative,
    },
    /// A state without an initial value among those given.
    #[error("no initial value is given for {state}")]
    NoInitial {
        /// The state, as a formula writes it.
        state: String,
    },
    /// An initial value, or a coefficient of the system, that has no value.
    #[error("{what} has no value: {reason}")]
    Undefined {
        /// What has no value.
        what: String,
        /// Why.
        reason: NoValue,
    },
    /// No solution of the constraints near the guesses.
    #[error("no initial values satisfy the constraints with {near}")]
    NoStart {
        /// Where they were looked for.
        near: String,
    },
    /// More solutions than one.
    #[error("two choices of initial values satisfy the constraints: {first}, and {second}")]
    SeveralStarts {
        /// The first.
        first: String,
        /// Another one.
        second: String,
    },
    /// A solution that cannot be shown to be the only one, or to be one.
    #[error(
        "it is not decided which initial values satisfy the constraints with {near}: near {at} they are no simple solution \
         (the Jacobian of the constraints is singular there, or a formula is at the edge of its domain)"
    )]
    UnclearStart {
        /// Where they were looked for.
        near: String,
        /// Where it is not decided.
        at: String,
    },
    /// A solution at the edge of where it is looked for.
    #[error("initial values that satisfy the constraints, {at}, lie at the edge of {near}")]
    StartAtEdge {
        /// Where they were looked for.
        near: String,
        /// The solution.
        at: String,
    },
    /// A guess without a value, or without a size.
    #[error(
        "where to look for the initial value of {state} is not clear: its guess is 0 or has no value, or `within` is not positive"
    )]
    Guess {
        /// The state, as a formula writes it.
        state: String,
    },
    /// Initial values that are given by one another.
    #[error("an initial value needs {leaf}, which needs that value itself")]
    CircularStart {
        /// A rate, as a formula writes it.
        leaf: String,
    },
    /// The rate of a state has no value at the initial time: a moment of inertia that is 0, for instance.
    #[error("the rate of {state} has no value at t = {}: {reason}", number::six(*time))]
    Singular {
        /// The state, as a formula writes it.
        state: String,
        /// The time.
        time: f64,
        /// Why.
        reason: NoValue,
    },
    /// More unknowns than validated integration takes: its work grows with their cube, and its memory with their square.
    #[error("{unknowns} unknowns are too much work for an enclosure, whose limit is {limit}")]
    TooManyUnknowns {
        /// Number of unknowns.
        unknowns: usize,
        /// The limit.
        limit: usize,
    },
    /// A span that is not an interval of finite times around the initial time.
    #[error("the span [{}, {}] is not a finite interval with the initial time {initial_time} in it", span.0, span.1)]
    Span {
        /// The span asked for.
        span: (f64, f64),
        /// The initial time.
        initial_time: f64,
    },
}

impl FlowError {
    /// Whether it is about constraints between initial values, and what to do about it.
    pub fn about_constraints(&self) -> Option<&'static str> {
        match self {
            FlowError::NoStart { .. } => {
                Some("a better guess, or a larger `within`; or the constraints contradict each other")
            }
            FlowError::SeveralStarts { .. } => Some("`near` the one that is meant, and a smaller `within`"),
            FlowError::UnclearStart { .. } => Some(
                "a smaller `within` leaves such places out; where the solution itself is a double one, give it by a formula",
            ),
            FlowError::StartAtEdge { .. } => Some("a larger or a smaller `within`"),
            FlowError::Guess { .. } => Some("write { near = 1, within = 0.5 }"),
            FlowError::CircularStart { .. } => Some("give one of them by a number, or by a constraint"),
            FlowError::Nonlinear { .. }
            | FlowError::Constraint { .. }
            | FlowError::NoEquation { .. }
            | FlowError::Undetermined { .. }
            | FlowError::OverDetermined { .. }
            | FlowError::UnknownLeaf { .. }
            | FlowError::NoDerivative { .. }
            | FlowError::NoInitial { .. }
            | FlowError::Undefined { .. }
            | FlowError::Singular { .. }
            | FlowError::TooManyUnknowns { .. }
            | FlowError::Span { .. } => None,
        }
    }
}

/// Why a trajectory ends before the end of its span. What was reached is kept.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The step size shrank below what binary64 can resolve: a singularity is near.
    #[error("the step size collapses at t = {}, where a singularity of the motion is near", number::six(*time))]
    StepCollapsed {
        /// The time that was reached.
        time: f64,
    },
    /// More steps than the limit.
    #[error("t = {} is reached after {steps} steps, which is the limit", number::six(*time))]
    TooManySteps {
        /// The time that was reached.
        time: f64,
        /// The limit.
        steps: usize,
    },
    /// A rate without a value.
    #[error("the rate of {state} has no value after t = {}: {reason}", number::six(*time))]
    NoRate {
        /// The state, as a formula writes it.
        state: String,
        /// The time that was reached.
        time: f64,
        /// Why.
        reason: NoValue,
    },
    /// A right side that jumps or has an infinite slope there.
    #[error(
        "the motion is not determined after t = {}: a right side jumps there, or its slope by a state is infinite, so \
         that several motions may go on, or none", number::six(*time)
    )]
    Undetermined {
        /// The time up to which it is.
        time: f64,
    },
    /// The independent integration, from which the error is estimated, ends earlier.
    #[error("the error is not known after t = {}", number::six(*time))]
    ErrorUnknown {
        /// The time up to which it is known.
        time: f64,
    },
}

/// How a leaf is written: name, dots, indices, argument.
pub(super) fn leaf_name(graph: &Graph, leaf: Leaf) -> String {
    let mut name = graph.name(leaf.symbol).to_owned();
    name = match leaf.rate {
        0 => name,
        1 => format!(r"\dot{{{name}}}"),
        2 => format!(r"\ddot{{{name}}}"),
        n => format!("{name}^{{({n})}}"),
    };
    let indices = graph.written_indices(leaf.symbol, leaf.component);
    if !indices.is_empty() {
        let list: Vec<String> = indices.iter().map(u16::to_string).collect();
        name = format!("{name}_{{{}}}", list.join(if indices.iter().any(|&i| i > 9) { "," } else { "" }));
    }
    if let Some(part) = graph.part(leaf) {
        name = part.of(&name);
    }
    if leaf.instant.is_some() { format!("{name} at a fixed time") } else { name }
}
