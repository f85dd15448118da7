//! The proof checker: replays recorded proofs, and believes nobody.
//!
//! **In:** a [`Sequent`] (what is given, each as it is quantified; what is claimed) and [`Step`]s. **Out:** [`Shown`], or [`Refused`] with the step and
//! the condition that is not met. **Guaranteed:** a [`Shown`] that leaves nothing out says that on every motion on which what is given is true, the claim is
//! not false at any chosen time; it rests on this crate, on the graph and the table of domains of `expr`, on `number`'s finite fields, and on the
//! theorems that the rules name. Nothing of the prover is used.
//!
//! **Reading order:** `when` and `fact` (what a fact says), `sequent` (what a proof says), `needs`, `signs` and `derivative`, the rules
//! (`rules`), `draft` (which takes steps). A proof is made with a [`Draft`], which tells at once what each step says, and checked with [`replay`], which is the same.

#![forbid(unsafe_code)]

mod context;
mod derivative;
mod draft;
mod fact;
mod law;
mod needs;
mod polynomial;
mod record;
mod rules;
mod sequent;
mod signs;
mod step;
mod term;
mod told;
mod trials;
mod when;
mod words;

pub use draft::{Draft, MOST_STEPS, Refused, Shown, replay};
pub use fact::{Because, Fact};
pub use law::Law;
pub use record::{ProofRecord, RelationRecord};
pub use sequent::{Claimed, ConstantSign, Declared, Definition, Sequent, SymbolKind};
pub use step::{FactId, Given, Manner, Split, Step};
pub use term::{LARGEST_TERM, Relation, Sense, Term, TermNode, operation};
pub use told::Told;
pub use when::{CaseId, Instant, When};

#[cfg(test)]
mod tests;
