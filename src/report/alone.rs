//! What each motion alone could have decided, as reports show it.

use serde_json::{Value, json};

use super::markdown::{prose, table};
use crate::check::Account;

/// For `report.json`: one entry for each motion.
pub(super) fn json(account: &Account) -> Value {
    let each = account.alone();
    let one = each.iter().map(|a| {
        json!({
            "trajectory": a.trajectory, "tried": a.tried, "not_applicable": a.not_applicable, "holds": a.holds,
            "misleading": a.misleading, "weak": a.weak, "rejected": a.rejected, "of": a.of, "sentence": a.sentence(),
        })
    });
    one.collect()
}

/// The part of `report.md`: a sentence for each motion that decides little by itself, and all in a table.
pub(super) fn section(account: &Account) -> String {
    let poor: String = account.poor().iter().map(|a| format!("- {}\n", prose(&a.sentence()))).collect();
    if poor.is_empty() {
        return String::new();
    }
    let row = |a: crate::check::Alone| {
        let share = format!("{} of {}", a.rejected, a.of);
        let numbers = [a.tried, a.not_applicable, a.holds, a.misleading.len(), a.weak].map(|n| n.to_string());
        std::iter::once(format!("`{}`", a.trajectory)).chain(numbers).chain([share]).collect::<Vec<_>>()
    };
    let head = ["trajectory", "claims", "do not apply", "hold", "of these fail elsewhere", "hold weakly", "rejected"];
    format!(
        "## What each motion alone could have decided\n\nThe evidence is that of all motions together. These would \
         have decided the least, had there been one alone:\n\n{poor}\n<details><summary>All motions</summary>\n\n{}\n</details>\n\n",
        table(&head, account.alone().into_iter().map(row))
    )
}
