//! The matrix of verdicts in letters: one for each pair, for what is no screen.
//!
//! **In:** an account. **Out:** lines of equal letters, a row for each claim or reading, a column for each trajectory by its number.

use super::discrimination;
use super::tally::{glyph, name};
use findings::{Account, ClaimAccount, PairAccount};

/// What the letters mean.
pub(super) const LEGEND: &str =
    "H holds, h holds but weakly, F fails, - does not apply, ? undecided; ! differs from what is expected.";

/// Rows of more equal letters than this are told in words.
const LONG: usize = 12;

/// The matrix; `None` where no claim is tried on motions.
pub(super) fn letters(account: &Account) -> Option<String> {
    // What is about ranges has no cells.
    let rows: Vec<&ClaimAccount> = account.claims.iter().filter(|c| !c.results.is_empty()).collect();
    if rows.is_empty() {
        return None;
    }
    let cell = |pair: Option<&&PairAccount>| match pair {
        None => ' ',
        Some(pair) if pair.is_unexpected() => '!',
        Some(pair) if discrimination::is_weak(pair) => 'h',
        Some(pair) => glyph(pair.verdict.outcome()),
    };
    let names: Vec<String> = rows.iter().map(|c| name(c)).collect();
    let wide = names.iter().map(|n| n.chars().count()).max().unwrap_or(0);
    let mut body = String::new();
    let numbers: Vec<String> = (1..=account.trajectories.len()).map(|n| n.to_string()).collect();
    let digits = numbers.last().map_or(1, String::len);
    for digit in 0..digits {
        let at = |n: &String| format!("{n:>digits$}").chars().nth(digit).unwrap_or(' ');
        body.push_str(&format!("{:wide$}  {}\n", "", numbers.iter().map(at).collect::<String>()));
    }
    for (claim, name) in rows.iter().zip(&names) {
        let on = claim.on_each();
        let cells: String = account.trajectories.iter().map(|t| cell(on.get(t.id.as_str()))).collect();
        let first = cells.chars().next().unwrap_or(' ');
        // A long row of one letter is told in two words.
        match cells.chars().count() {
            n if n > LONG && cells.chars().all(|c| c == first) => body.push_str(&format!("{name}  {first} on all")),
            _ => body.push_str(format!("{name:wide$}  {cells}").trim_end()),
        }
        body.push('\n');
    }
    Some(body)
}
