//! Derivation files: what a paper says, in a form that can be checked.
//!
//! **In:** a TOML file with the symbols of a paper, its equations in LaTeX, the motions on which they are tried, and its
//! claims. **Out:** a [`Derivation`], in which every formula is read, every name resolved and every number exact; or all
//! problems of the file, each with its place.
//!
//! **Guaranteed:** no file makes the loader panic, and no part of a file is passed over: a key that is not known is a
//! problem. Numbers have exactly the value of their decimal digits. Formulas stand in single quotes only, since in double
//! quotes TOML changes `\theta` to a tab and `heta` without a word.
//!
//! **Why this way:** the file is walked by hand, not by derived deserializers: those stop at the first problem, and a person
//! who writes a file wants to see all of them. The format is described in `docs/derivation-file.md`.

#![forbid(unsafe_code)]

mod across;
mod ambiguity;
mod claims;
mod conditions;
mod constants;
mod declaration;
mod dependence;
mod event;
mod families;
mod family;
mod form;
mod formula;
pub mod keys;
mod list;
mod load;
mod map;
mod model;
mod motions;
mod number;
mod pictures;
mod premise;
mod region;
mod role;
mod schema;
mod shared;
mod span;
mod start;
mod symbols;
mod table;
mod unit;
mod values;

pub use self::number::exact;
pub use claims::DEFAULT_PRECISION;
pub use dependence::{Dependence, End, NoOther};
pub use event::{Direction, Event, Occasion, Since};
pub use family::{Constraint, Drawing, Family, LARGEST_FAMILY, Spread, Varied, WIDEST_ROW};
pub use form::{Across, Form, FormFormula, FormKind};
pub use formula::{Ranged, Values, Written};
pub use list::Shared;
pub use load::{LARGEST_FILE, load, load_all, meant, parse};
pub use model::{
    Claim, Condition, Derivation, Domain, Formula, GivenValue, Measure, Motion, Picture, PictureKind, Region, Start,
    SymbolEntry, System, Trajectory, Unknown,
};
pub use premise::{Premise, is_called};
pub use role::ClaimRole;
pub use schema::schema;
pub use unit::Unit;
