//! The forms of claims: what can be said of a motion, of a box, of a family.
//!
//! What a form *means* is the business of whoever compiles it; here is what it is called, and which formulas it has.

use std::ops::Range;

use super::dependence::{Dependence, NoOther};
use super::formula::{Ranged, Written};
use expr::{Expr, Leaf, Symbol, Tensor};
use latex::Statement;

macro_rules! forms {
    ($($(#[$doc:meta])* $kind:ident = $key:literal, $heading:literal;)*) => {
        /// What a formula of a claim is there for.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum FormKind {
            $($(#[$doc])* $kind,)*
        }

        impl FormKind {
            /// All of them: a claim has at least one.
            pub const ALL: &[FormKind] = &[$(FormKind::$kind),*];

            /// The key of the derivation file.
            pub fn key(self) -> &'static str {
                match self {
                    $(FormKind::$kind => $key,)*
                }
            }

            /// What is said of its formulas along a motion, as a heading without an end.
            pub fn heading(self) -> &'static str {
                match self {
                    $(FormKind::$kind => $heading,)*
                }
            }
        }
    };
}

forms! {
    /// The relation holds at every time.
    Always = "always", "At every time";
    /// The relation holds at no time.
    Never = "never", "At no time";
    /// The relation holds at some time.
    Eventually = "eventually", "At some time";
    /// The expression is constant along the motion.
    FirstIntegral = "first-integral", "Constant along the motion";
    /// The expression has a real value at every time.
    Defined = "defined", "Has a real value at every time";
    /// The motion solves a system.
    Solves = "solves", "The motion solves";
    /// Two motions are the same.
    SameMotion = "same-motion", "The motion is that of";
    /// Functions are independent.
    Independent = "independent", "Independent functions";
    /// Equations have a solution.
    Exists = "exists", "There is a solution of";
    /// A quantity has the same value for members of a family that differ in a symbol.
    IndependentOf = "independent-of", "Compared between members of a family";
    /// It is a power of the symbol.
    ScalesAs = "scales-as", "Compared between members of a family";
    /// It grows with the symbol, or falls.
    Monotone = "monotone", "Compared between members of a family";
    /// It is largest, or smallest, at a value of the symbol.
    Extremum = "extremum", "Compared between members of a family";
    /// It tends to a value as the symbol does.
    Limit = "limit", "Compared between members of a family";
}

/// One thing that a claim says of a motion.
#[derive(Clone, Debug)]
pub enum Form {
    /// The statement holds at every time.
    Always(Written<Statement>),
    /// The statement holds at no time.
    Never(Written<Statement>),
    /// The statement holds at some time.
    Eventually(Written<Statement>),
    /// Every component is constant along the motion.
    FirstIntegral(Written<Tensor>),
    /// Every component has a real value at every time.
    Defined(Written<Tensor>),
    /// The states of the motion satisfy the equations of a system.
    Solves {
        /// Position in [`Derivation::systems`](super::Derivation::systems).
        system: usize,
    },
    /// The states of the motion are, at every time, those of another.
    SameMotion {
        /// Position in [`Derivation::trajectories`](super::Derivation::trajectories).
        other: usize,
        /// The states that are compared.
        of: Vec<Symbol>,
    },
    /// The functions (of the states at one time) are independent where the constraints hold.
    Independent {
        /// The functions.
        functions: Vec<Written<Tensor>>,
        /// Relations between the variables that hold anyway.
        subject_to: Vec<Written<Statement>>,
    },
    /// Equations have a solution in a box.
    Exists {
        /// The unknowns: each a component with the range in which it is looked for.
        unknowns: Vec<Ranged>,
        /// As many equations as unknowns, and any number of other relations, which a solution must satisfy, too.
        such_that: Vec<Written<Statement>>,
        /// Whether there is one only.
        unique: bool,
    },
    /// How a quantity depends on what a family varies.
    Across(Box<Across>),
    /// The formulas of the claim take too much work to be read: nothing is known of it.
    Unread {
        /// What the first of them is there for.
        kind: FormKind,
        /// Why they were not read.
        why: String,
    },
}

/// What a claim says of members that differ in one symbol.
#[derive(Clone, Debug)]
pub struct Across {
    /// The quantity.
    pub of: Written<Tensor>,
    /// The symbol that varies, as the families have it.
    pub with: Leaf,
    /// Its name.
    pub name: String,
    /// How the quantity depends on it.
    pub dependence: Dependence,
    /// Where the extremum lies, or what the symbol tends to: an expression without leaves; nothing where there is no such number.
    pub point: Option<Written<Expr>>,
    /// The limit.
    pub value: Option<Written<Tensor>>,
    /// Where a member is tried: the trajectories that it is compared with, by their positions.
    pub others: Vec<usize>,
    /// Where a member is tried: its value of what varies, and those of the others; or why there is none.
    pub values: Result<Vec<f64>, NoOther>,
}

impl Form {
    /// Whether ± stands in what it says of a statement.
    pub fn has_branches(&self) -> bool {
        self.statement().is_some_and(|w| w.value.relations.iter().any(|r| r.has_branches))
    }

    /// What it is.
    pub fn kind(&self) -> FormKind {
        match self {
            Form::Always(_) => FormKind::Always,
            Form::Never(_) => FormKind::Never,
            Form::Eventually(_) => FormKind::Eventually,
            Form::FirstIntegral(_) => FormKind::FirstIntegral,
            Form::Defined(_) => FormKind::Defined,
            Form::Solves { .. } => FormKind::Solves,
            Form::SameMotion { .. } => FormKind::SameMotion,
            Form::Independent { .. } => FormKind::Independent,
            Form::Exists { .. } => FormKind::Exists,
            Form::Unread { kind, .. } => *kind,
            Form::Across(across) => match across.dependence {
                Dependence::Independent => FormKind::IndependentOf,
                Dependence::Increasing | Dependence::Decreasing => FormKind::Monotone,
                Dependence::Power { .. } => FormKind::ScalesAs,
                Dependence::Extremum { .. } => FormKind::Extremum,
                Dependence::Limit { .. } => FormKind::Limit,
            },
        }
    }

    /// The statement that is true at every, at no, or at some time.
    pub fn statement(&self) -> Option<&Written<Statement>> {
        let (Form::Always(w) | Form::Never(w) | Form::Eventually(w)) = self else { return None };
        Some(w)
    }

    /// The quantity of which it says something at each time by itself.
    pub fn quantity(&self) -> Option<&Written<Tensor>> {
        let (Form::FirstIntegral(w) | Form::Defined(w)) = self else { return None };
        Some(w)
    }

    /// All formulas of which it says something, and what restricts them.
    pub fn formulas(&self) -> Vec<FormFormula<'_>> {
        match self {
            Form::Always(w) | Form::Never(w) | Form::Eventually(w) => vec![FormFormula::Statement(w)],
            Form::FirstIntegral(w) | Form::Defined(w) => vec![FormFormula::Quantity(w)],
            Form::Independent { functions, subject_to } => {
                let functions = functions.iter().map(FormFormula::Quantity);
                functions.chain(subject_to.iter().map(FormFormula::Statement)).collect()
            }
            Form::Exists { such_that, .. } => such_that.iter().map(FormFormula::Statement).collect(),
            Form::Across(across) => {
                let limit = across.value.iter().map(|value| FormFormula::Limit { of: &across.of, value });
                std::iter::once(FormFormula::Quantity(&across.of)).chain(limit).collect()
            }
            // A system has its own; another motion has none.
            Form::Solves { .. } | Form::SameMotion { .. } | Form::Unread { .. } => Vec::new(),
        }
    }

    /// Its formulas, each with its place.
    pub fn written(&self) -> impl Iterator<Item = (&str, Range<usize>)> {
        self.formulas().into_iter().map(|formula| match formula {
            FormFormula::Statement(w) => (w.text.as_str(), w.span.clone()),
            FormFormula::Quantity(w) | FormFormula::Limit { value: w, .. } => (w.text.as_str(), w.span.clone()),
        })
    }
}

/// A formula of a form.
#[derive(Clone, Copy, Debug)]
pub enum FormFormula<'a> {
    /// Relations.
    Statement(&'a Written<Statement>),
    /// A quantity.
    Quantity(&'a Written<Tensor>),
    /// What a quantity tends to.
    Limit {
        /// The quantity.
        of: &'a Written<Tensor>,
        /// The limit.
        value: &'a Written<Tensor>,
    },
}
