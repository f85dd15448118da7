//! Formulas → what their names may be, from what the whole paper shows.
//!
//! **In:** the sides of a formula, and the [`Evidence`] of the paper. **Out:** the readings that are tried, in their order, or the feature that
//! keeps it from being read. **Guaranteed:** what could be an operator, a matrix, a function of anything, a sum over indices is not declared
//! as a number: it is refused by its name.

use std::collections::BTreeSet;

use super::super::names::{Evidence, PaperName, cancels_by_order, evidence, names_apart, order_counts, unprimed};
use super::super::printed::PrintedSide;
use super::declared::{Names, Way};
use super::guess::{Place, Reading};
use super::index;
use super::obstacle::{obstacle, raised_e};

/// The readings of a formula, the best first: each with others that mean the same, and need less of the file.
///
/// # Errors
/// The feature that is not understood.
pub(super) fn readings(
    sides: &[&PrintedSide],
    evidence: &Evidence,
    is_of_indices: bool,
    place: Place,
) -> Result<Vec<Vec<Reading>>, String> {
    let all: Vec<PaperName> = sides.iter().flat_map(|s| names_apart(s)).collect();
    obstacle(sides, &all, evidence, place)?;
    let indices = ways_of_indices(sides, &all, evidence, is_of_indices)?;
    let text: String = sides.iter().map(|s| s.text.as_str()).collect::<Vec<_>>().join(" ");
    let mut out: Vec<Vec<Reading>> = Vec::new();
    let is_name = !evidence.has_exponentials || evidence.local.is_e_a_name(place.chapter);
    let has_charge = is_name && sides.iter().filter_map(|s| raised_e(s)).any(|(number, other)| number && !other);
    for with_indices in indices {
        for way in ways(sides, &all, evidence, place) {
            let names = Names {
                way,
                place,
                moving_are_coordinates: false,
                all: &all,
                evidence,
                text: &text,
                with_indices,
                places_are_numbers: false,
                moving_are_functions: false,
                coordinates_are_numbers: false,
                has_charge,
            };
            let mut tried: Vec<Reading> = Vec::new();
            for (places_are_numbers, moving_are_functions) in
                [(false, false), (true, false), (false, true), (true, true)]
            {
                let reading = Names { places_are_numbers, moving_are_functions, ..names }.reading()?;
                if !tried.contains(&reading) {
                    tried.push(reading);
                }
            }
            let still = Names { moving_are_coordinates: true, ..names };
            let numbers = Names { coordinates_are_numbers: true, ..names };
            for other in [still, numbers] {
                if !other.has_rate_of_function()
                    && let Ok(reading) = other.reading()
                    && !tried.contains(&reading)
                {
                    tried.push(reading);
                }
            }
            if !out.contains(&tried) {
                out.push(tried);
            }
        }
    }
    Ok(out)
}

/// How shapes and motions may be taken in a formula, the better way first.
fn ways(sides: &[&PrintedSide], all: &[PaperName], evidence: &Evidence, place: Place) -> Vec<Way> {
    let printed = sides.iter().find_map(|s| evidence::size(&s.tokens)).map(|(rows, _)| rows).filter(|n| *n > 1);
    let usual = Way { dimension: 3, ..Way::default() };
    let mut ways = vec![usual, Way { dimension: printed.unwrap_or(3), ..usual }, Way { bold_matrices: true, ..usual }];
    if !evidence.sizes.is_empty() {
        ways.push(Way { columns_of_chapter: true, ..usual });
    }
    if sides.iter().any(|s| s.text.contains('\\')) {
        ways.push(Way { steady_before_time: true, ..usual });
    }
    let known = |n: &PaperName| evidence.sizes.get(&n.key()).or_else(|| evidence.sizes.get(&unprimed(n)));
    let of_matrices: Vec<_> = all.iter().filter_map(known).flat_map(|sizes| sizes.keys()).collect();
    let has_bold = all.iter().any(|n| n.is_bold);
    if has_bold || !of_matrices.is_empty() {
        // A vector has as many components as the matrices beside it have rows.
        let mut dimensions: Vec<usize> = printed.into_iter().collect();
        dimensions.extend(of_matrices.iter().map(|(rows, _)| *rows));
        dimensions.extend([2, 3, 4]);
        let mut seen = BTreeSet::new();
        dimensions.retain(|n| *n > 1 && seen.insert(*n));
        ways.extend(dimensions.iter().map(|&dimension| Way { dimension, ..usual }));
        ways.extend(dimensions.iter().map(|&dimension| Way { dimension, is_uniform: true, ..usual }));
    }
    // A letter of another section may be a matrix there and a number here, unless the order of its factors counts.
    let of_order = |s: &&PrintedSide| order_counts(&s.text) || cancels_by_order(s) || s.text.contains(r"\det");
    let has_order = sides.iter().any(of_order);
    if !of_matrices.is_empty() && !has_bold && !has_order && !evidence.local.has_matrices(place.section) {
        ways.push(Way { without_matrices: true, ..usual });
    }
    ways
}

/// Whether subscripts are taken for indices of components, the better way first.
fn ways_of_indices(
    sides: &[&PrintedSide],
    all: &[PaperName],
    evidence: &Evidence,
    is_of_indices: bool,
) -> Result<Vec<bool>, String> {
    let summed = index::summed(sides, evidence);
    let of_indices = all.iter().any(|n| evidence.has_indices(&n.letter));
    let mut ways = Vec::new();
    if of_indices && is_of_indices {
        ways.push(true);
    }
    let mut refused = None;
    if index::has_symbols_of_indices(all) {
        refused = Some("indices of δ or ε".to_owned());
    } else if let Some(letter) = summed.first() {
        refused = Some(format!("an index that may be summed over, {letter}"));
    } else {
        ways.push(false);
    }
    if of_indices && !is_of_indices {
        ways.push(true);
    }
    if ways.is_empty() {
        return Err(refused.unwrap_or_default());
    }
    Ok(ways)
}
