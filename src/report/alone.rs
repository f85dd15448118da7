//! What each motion alone could have decided, as reports show it.

use serde_json::{Value, json};

use findings::Account;

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
