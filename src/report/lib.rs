//! Verdicts as people and programs read them.
//!
//! **In:** an [`Account`](findings::Account) and the [`Derivation`](derivation::Derivation) that it is of.
//! **Out:** [`summary`] for a terminal, [`json`] (the contract), [`markdown`] (for a forge), [`explain`] (one verdict);
//! [`page`] (for a browser); [`tex`] (for an appendix); [`junit`], [`sarif`] and [`github`] for machines, the last two drawn
//! from [`findings()`]; [`part_text`] for the machine that joins the parts of a family, [`member_line`] for programs that
//! read its members.
//!
//! **Guaranteed:** the same account gives the same bytes; no clock, no machine, no path outside the project. Nothing is
//! computed here: every number comes from the account, and is only chosen and written.

#![forbid(unsafe_code)]

mod argument;
mod assumption;
mod audit;
mod basis;
mod behind;
mod card;
mod certificates;
mod claim_story;
mod condition_spelling;
mod conditions;
mod consequence;
mod contents;
mod diff;
mod differing;
mod digest;
mod discrimination;
mod document;
mod drawn;
mod explain;
mod family;
mod finding;
mod fingerprint;
mod form;
mod former;
mod front;
mod github;
mod graph;
mod headline;
mod hypotheses;
mod json;
mod junit;
mod latex_text;
mod letters;
mod limited;
mod lint_findings;
mod lint_json;
mod lint_page;
mod markdown;
mod markup;
mod mathml;
mod members;
mod motion_matrix;
mod numbers;
mod page;
mod page_one;
mod pair_story;
mod paper;
mod part;
mod plain;
mod plot;
mod points;
mod proof_file;
mod proposition;
mod recorded;
mod refuting;
mod region;
mod said;
mod sarif;
mod schema;
mod search;
mod sections;
mod shape;
mod sketch;
mod story;
mod summary;
mod tally;
mod tex;
mod text;
mod units;
mod whole;
mod wording;

/// The name of the program, as reports give it.
const PROGRAM: &str = "rederive";

pub use assumption::assumptions;
pub use certificates::{CERTIFICATES, certificate_text, certificates, lean_text};
pub use contents::contents;
pub use diff::{Change, Direction, OtherId, diff, diff_files, diff_text, is_worse};
pub use explain::explain;
pub use finding::{Finding, Fix, Level, Place, Region, findings, problems, rule_says};
pub use front::alarms;
pub use github::github;
pub use json::{json, json_with_paper};
pub use junit::{Checked, junit};
pub use lint_findings::lint_findings;
pub use lint_json::{lint_document, unread_document};
pub use lint_page::{lint_formulas, lint_page};
pub use markdown::markdown;
pub use markup::{fenced, prose};
pub use mathml::formula_mathml;
pub use members::{member_line, members_head};
pub use page::{first_page, page, printed_page};
pub use page_one::{front_markdown, front_page};
pub use paper::{add_paper, paper_findings, paper_summary};
pub use part::{part_text, read_parts};
pub use proposition::{proposition_json, proposition_text};
pub use sarif::sarif;
pub use schema::schema;
pub use search::{search_notes, search_table};
pub use summary::{checked_again, exceptions, summary};
pub use tex::{tex, tex_summary};
pub use text::fit_terminal;

pub use audit::{Audit, AuditedClaim, AuditedRelation, Provenance, Replayed, audit};
pub use proof_file::{PROOF_SCHEMA, PROOFS, ProofFile, RecordedClaim, UnrecordedClaim, proofs};

/// The path as the project sees it; nothing outside the project is named.
fn project_path(path: &str) -> String {
    let path = path.replace('\\', "/");
    let path = path.trim_start_matches("./");
    let outside = path.starts_with('/') || path.split('/').any(|p| p == ".." || p.ends_with(':'));
    if outside { path.rsplit('/').next().unwrap_or_default().to_owned() } else { path.to_owned() }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use derivation::{Derivation, parse};
    use diag::{Source, render};
    use findings::sample;

    /// The derivation that the handmade account is of.
    pub(super) fn derivation() -> Derivation {
        let source = Source { path: "derivations/spring.toml".into(), text: sample::FILE.into() };
        parse(source, "spring").unwrap_or_else(|e| panic!("{}", render(&e, false)))
    }
}
