//! All tests of the whole program, in one binary: what they are linked against is large.
//!
//! A file of this folder is a module here; `cargo test units::` runs those of `tests/units.rs`. A new file needs a line below,
//! and a test sees to that. Crates have their own tests beside their code.

mod claims;
mod comment;
mod enclosure_support;
mod flow_support;
mod formats_support;
mod infix;
mod latex_support;
mod schema_support;

mod claims_random;
mod cli;
mod cli_mangled;
mod corpus;
mod derivation_docs;
mod derivation_errors;
mod determinism;
mod diff;
mod enclosure;
mod enclosure_containment;
mod enclosure_limits;
mod flow_events;
mod flow_integration;
mod flow_motion;
mod flow_rigid_body;
mod flow_systems;
mod formats;
mod grammar;
mod identity;
mod identity_certificates;
mod identity_mutants;
mod identity_random;
mod identity_steps;
mod identity_traps;
mod init;
mod interval_laws;
mod latex_comment;
mod latex_derivations;
mod latex_meaning;
mod latex_print;
mod latex_refused;
mod latex_robust;
mod layering;
mod mutants;
mod number_laws;
mod package;
mod package_action;
mod page;
mod pdf;
mod planted;
mod premises;
mod prove;
mod prove_traps;
mod readme;
mod regions;
mod schema;
mod search;
mod separation;
mod source;
mod two_routes;
mod units;
mod variants;
mod watch;
mod witnesses;
