//! What a search for a motion came to, as people read it.
//!
//! **In:** a [`SearchAccount`]. **Out:** the motion as a table of a derivation file, with what it shows as comments; what is to be said
//! beside it, a line each.

use diag::escape::in_one_line;
use findings::search::{FailingMotion, SearchAccount};

/// The table of the motion that was found.
pub fn search_table(account: &SearchAccount) -> Option<String> {
    let FailingMotion { number, claim, from, table, verdict, .. } = account.found.as_ref()?;
    let fails = match &account.variant {
        Some(formula) => format!("`{claim}` holds here, and would not hold as\n# {}\n# It was", in_one_line(formula)),
        None => format!("`{claim}` fails here;"),
    };
    let mut out = format!("\n# {fails} found with seed {}, try {number}, from `{from}`.\n", account.seed);
    if let Some(w) = &verdict.evidence().witness {
        let formula = in_one_line(&w.formula);
        let values = format!("{} and {}, error bound {:.1e}", w.left, w.right, w.bound);
        out.push_str(&format!("# At t = {}: {formula}: {values}.\n", w.t));
    }
    Some(out + table)
}

/// What is to be said beside the table, of a derivation with this id: where the claim fails already, what is to be added to it, how
/// the tries ended.
pub fn search_notes(id: &str, account: &SearchAccount) -> Vec<String> {
    let what = if account.variant.is_some() { "the altered formula" } else { "the claim" };
    let mut out = Vec::new();
    if let Some((first, more)) = account.known.split_first() {
        let others = if more.is_empty() { String::new() } else { format!(" and {} more motions", more.len()) };
        out.push(format!("{what} fails already on {first}{others} of the file"));
    }
    match &account.found {
        Some(found) if found.listed => {
            out.push(format!("`{}` names its motions: add \"{}\" to them", found.claim, found.id));
        }
        Some(_) => {}
        None => {
            let meant = account.variant.as_ref().unwrap_or(&account.claim);
            out.push(format!("{id}: no motion was found on which `{}` fails", in_one_line(meant)));
        }
    }
    let t = account.tries;
    out.push(format!(
        "{} tried: {what} holds on {}, fails on {}, does not apply to {}, is undecided on {}; {} are no motions",
        t.all(),
        t.holds,
        t.fails,
        t.not_applicable,
        t.undecided,
        t.impossible
    ));
    out
}
