//! The members of a family as a table: comma-separated values (RFC 4180), a line for each member.
//!
//! **In:** a family, and its members as they are tried. **Out:** a first line with names, and a line for each member: its number, the values
//! of what varies, the verdict of each claim, and the values of each measure, several of them with spaces between. **Guaranteed:**
//! numbers are read back to the last bit; a line needs nothing but its member, so memory does not grow with how many there are.

use derivation::{Derivation, Family};
use findings::family::Row;

/// A cell with a text.
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

fn line(cells: impl Iterator<Item = String>) -> String {
    format!("{}\n", cells.collect::<Vec<_>>().join(","))
}

/// The first line: `member`, what varies, the claims that are tried on the family, and what is measured on it.
pub fn members_head(derivation: &Derivation, family: &Family) -> String {
    let at = derivation.families.iter().position(|f| f.id == family.id);
    let here = |families: &[usize]| at.is_some_and(|at| families.contains(&at));
    let claims = derivation.claims.iter().filter(|c| here(&c.families)).map(|c| match &c.reading {
        Some(reading) => format!("{}/{reading}", c.id),
        None => c.id.clone(),
    });
    let measures = derivation.measures.iter().filter(|m| here(&m.families)).map(|m| m.id.clone());
    let varied = family.vary.iter().map(|v| v.name.clone());
    let names = std::iter::once("member".to_owned()).chain(varied).chain(claims).chain(measures);
    line(names.map(|name| cell(&name)))
}

/// The line of a member.
pub fn member_line(row: &Row) -> String {
    let values = row.values.iter().map(|x| format!("{x:?}"));
    let verdicts = row.verdicts.iter().map(|v| v.outcome().word().to_owned());
    let measured = row.measured.iter().map(|m| {
        let values: Vec<String> = m.values.iter().map(|(_, value, _)| format!("{value:?}")).collect();
        values.join(" ")
    });
    line(std::iter::once(row.number.to_string()).chain(values).chain(verdicts).chain(measured))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_end_a_cell_is_quoted() {
        let cells = ["a", "b,c", "d\"e", "f\ng", ""].map(cell);
        assert_eq!(line(cells.into_iter()), "a,\"b,c\",\"d\"\"e\",\"f\ng\",\n");
    }
}
