//! How printed relations can be typeset: the scope in which their sides are read.

use meter::Limits;
use paper::{Paper, PrintedRelation, PrintedSide};

use super::desk::{Desk, evidence_of};
use super::judge::LONGEST;
use super::relation::free_indices;

/// How a printed relation can be typeset.
pub struct Typeset {
    /// The scope in which its sides are read.
    pub scope: latex::Scope,
    /// The sides, with a sign of multiplication where a bracket behind a name could be a call.
    pub sides: Vec<String>,
}

/// For each printed relation how it can be typeset; `None` where its names are not read.
pub fn typesetting(paper: &Paper) -> Vec<Option<Typeset>> {
    let evidence = evidence_of(paper, &Limits::default());
    let is_factor = |letter: &str| !evidence.may_be_function(letter);
    let one = |relation: &PrintedRelation| {
        let sides: Vec<&PrintedSide> = relation.sides.iter().filter(|s| s.text.len() <= LONGEST).collect();
        let scope = Desk::new(&sides, &[], &evidence, &free_indices(relation)).ok()?.scope;
        let text = |s: &PrintedSide| match latex::parse(&s.text, &scope) {
            Ok(_) => s.text.clone(),
            Err(_) => s.with_factors(&is_factor),
        };
        let sides = relation.sides.iter().map(text).collect();
        Some(Typeset { scope, sides })
    };
    paper.printed.iter().map(one).collect()
}
