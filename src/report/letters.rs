//! The matrix of verdicts in letters: one for each pair, for what is no screen.
//!
//! **In:** an account. **Out:** lines of equal letters, a row for each claim or reading, a column for each trajectory by its number.

use super::discrimination;
use super::tally::{glyph, name};
use findings::{Account, ClaimAccount, PairAccount};

/// What the letters mean.
pub(super) const LEGEND: &str =
    "H holds, h holds but weakly, F fails, - does not apply, ? undecided; ! differs from what is expected.";

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
    let mut body = String::new();
    let numbers: Vec<String> = (1..=account.trajectories.len()).map(|n| n.to_string()).collect();
    let wide = numbers.len();
    let digits = numbers.last().map_or(1, String::len);
    for digit in 0..digits {
        let at = |n: &String| format!("{n:>digits$}").chars().nth(digit).unwrap_or(' ');
        body.push_str(&format!("{}\n", numbers.iter().map(at).collect::<String>()));
    }
    let mut all: Vec<(&str, Vec<String>)> = ["H", "h", "H or h", "F"].map(|word| (word, Vec::new())).to_vec();
    let mut some: Vec<(String, Vec<String>)> = Vec::new();
    for claim in rows {
        let on = claim.on_each();
        let cells: String = account.trajectories.iter().map(|t| cell(on.get(t.id.as_str()))).collect();
        let only = |letters: &str| cells.chars().all(|c| letters.contains(c));
        // A row of one letter is told in words, together with those like it; equal rows are one.
        match ["H", "h", "Hh", "F"].iter().position(|letters| only(letters)) {
            Some(kind) if account.trajectories.len() > 1 => all[kind].1.push(name(claim)),
            _ => match some.iter_mut().find(|(row, _)| *row == cells) {
                Some((_, names)) => names.push(name(claim)),
                None => some.push((cells, vec![name(claim)])),
            },
        }
    }
    for (cells, names) in &some {
        for (n, line) in names.chunks(2).enumerate() {
            let cells = if n == 0 { cells.as_str() } else { "" };
            let end = if names.len() > 2 * n + 2 { "," } else { "" };
            body.push_str(&format!("{cells:wide$}  {}{end}\n", line.join(", ")));
        }
    }
    for (word, names) in all.iter().filter(|(_, names)| !names.is_empty()) {
        body.push_str(&format!("\n{word} on all:\n"));
        for line in names.chunks(2) {
            body.push_str(&format!("  {}\n", line.join(", ")));
        }
    }
    Some(body)
}
