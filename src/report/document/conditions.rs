//! Under which condition a claim holds, and which of its assumptions it needs.

use super::{Join, Need, objects};
use findings::conditions;

objects! {
    /// What was found of the conditions of a claim.
    Conditions<'a> of (of: &'a conditions::ConditionsAccount) {
        /// Where the claim holds on some trajectories and fails on others: what separates them.
        separation: Option<Separation<'a>> = of.separation.as_ref().map(Separation::of),
        /// One entry for each assumption.
        assumptions: Vec<Assumption<'a>> = of.assumptions.iter().map(Assumption::of).collect(),
    }

    /// What separates the trajectories on which a claim holds from those on which it fails.
    Separation<'a> of (of: &'a conditions::Separation) {
        /// Trajectories on which the claim holds.
        holds: &'a [String] = &of.holds,
        /// Trajectories on which it fails.
        fails: &'a [String] = &of.fails,
        /// The weakest that is met exactly where it holds.
        explanation: Option<Explanation<'a>> = of.explanation.as_ref().map(Explanation::of),
        /// Others, equally good on these trajectories.
        rivals: Vec<Rival<'a>> = of.rivals.iter().map(Rival::of).collect(),
        /// How many further ones there are.
        more_rivals: usize = of.more_rivals,
        /// Without an explanation: conditions that are met only where it holds.
        sufficient: Vec<PartialCondition<'a>> = of.sufficient.iter().map(PartialCondition::of).collect(),
        /// Without an explanation: conditions that are met wherever it holds.
        necessary: Vec<PartialCondition<'a>> = of.necessary.iter().map(PartialCondition::of).collect(),
        /// Without an explanation: conditions that may be one.
        possible: Vec<PossibleCondition<'a>> = of.possible.iter().map(PossibleCondition::of).collect(),
        /// Conditions that were tried.
        tried: usize = of.tried,
        /// Of these, such as might explain it but are undecided somewhere.
        undecided: usize = of.undecided,
    }

    /// One condition, or several together.
    Explanation<'a> of (of: &'a conditions::Explanation) {
        /// How they are put together.
        join: Join = Join(of.join.word()),
        /// The conditions.
        conditions: Vec<Condition<'a>> = of.conditions.iter().map(Condition::of).collect(),
    }

    /// A condition.
    Condition<'a> of (of: &'a conditions::ConditionName) {
        /// Its id; null for one that was built.
        id: Option<&'a str> = of.id.as_deref(),
        /// In LaTeX.
        formula: &'a str = &of.formula,
        /// In words.
        says: Option<&'a str> = of.says.as_deref(),
        /// Whether its opposite is meant.
        negated: bool = of.negated,
    }

    /// Another explanation, as good on the trajectories to which the claim applies.
    Rival<'a> of (of: &'a conditions::Rival) {
        /// The explanation.
        explanation: Explanation<'a> = Explanation::of(&of.explanation),
        /// Trajectories on which the two differ, without a verdict of the claim.
        differ_on: &'a [String] = &of.differ_on,
    }

    /// A condition that explains a part.
    PartialCondition<'a> of (of: &'a (conditions::ConditionName, usize)) {
        /// The condition.
        condition: Condition<'a> = Condition::of(&of.0),
        /// How many trajectories it covers.
        trajectories: usize = of.1,
    }

    /// A condition that is not decided everywhere.
    PossibleCondition<'a> of (of: &'a (conditions::ConditionName, Vec<String>)) {
        /// The condition.
        condition: Condition<'a> = Condition::of(&of.0),
        /// Trajectories on which it is undecided.
        undecided_on: &'a [String] = &of.1,
    }

    /// One assumption of a claim.
    Assumption<'a> of (of: &'a conditions::AssumptionAccount) {
        /// As written.
        formula: &'a str = &of.text,
        /// Whether it is needed.
        need: Need = Need(of.need.word()),
        /// The trajectories that show it.
        on: &'a [String] = &of.on,
    }
}
