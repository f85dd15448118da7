//! Formulas → what their names may be, from what the whole paper shows.
//!
//! **In:** the sides of a formula, and the [`Evidence`] of the paper. **Out:** the readings that are tried, in their order, or the feature that
//! keeps it from being read. **Guaranteed:** what could be an operator, a matrix, a function of anything, a sum over indices is not declared
//! as a number: it is refused by its name.

use std::collections::BTreeSet;

use super::super::names::{
    Call, Evidence, PaperName, cancels_by_order, evidence, names_apart, order_counts, squeezed, unprimed,
};
use super::super::printed::PrintedSide;
use super::declared::{IDENTITY, Names, Way};
use super::guess::{Place, Reading};
use super::index;
use super::obstacle::{obstacle, raised_e};

/// Most names of a formula that is drafted: each is looked at beside all others.
const MOST_NAMES: usize = 400;

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
    if all.len() > MOST_NAMES {
        return Err(format!("more than {MOST_NAMES} names"));
    }
    obstacle(sides, &all, evidence, place)?;
    let indices = ways_of_indices(sides, &all, evidence, is_of_indices)?;
    let text: String = sides.iter().map(|s| s.text.as_str()).collect::<Vec<_>>().join(" ");
    let mut out: Vec<Vec<Reading>> = Vec::new();
    let is_name = !evidence.has_exponentials || evidence.local.is_e_a_name(place.chapter);
    let has_charge = is_name && sides.iter().filter_map(|s| raised_e(s)).any(|(number, other)| number && !other);
    let products = products_of_capitals(sides);
    for with_indices in indices {
        for way in ways(sides, &all, (evidence, &products), place) {
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
                only_rates_move: false,
                has_charge,
                products: &products,
            };
            let mut tried: Vec<Reading> = Vec::new();
            // What primes behind brackets derive by is then the time.
            let has_primed_group = has_primed_group(&text);
            let choices = [(false, false), (true, false), (false, true), (true, true)];
            for (places_are_numbers, moving_are_functions) in choices {
                if moving_are_functions && has_primed_group {
                    continue;
                }
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
            if is_of_a_moment(&all)
                && let Ok(reading) = (Names { only_rates_move: true, ..names }).reading()
                && !tried.contains(&reading)
            {
                tried.push(reading);
            }
            if !out.contains(&tried) {
                out.push(tried);
            }
        }
    }
    Ok(out)
}

/// Whether a prime stands behind brackets: `(uv)'`.
fn has_primed_group(text: &str) -> bool {
    let text = squeezed(text);
    [")'", "]'", r")^\prime", r"]^\prime", "matrix'"].iter().any(|sign| text.contains(sign))
}

/// Whether nothing is derived by the time in a formula, but for names with dots, and nothing is taken at a time: what else changes with it does
/// not matter.
fn is_of_a_moment(all: &[PaperName]) -> bool {
    all.iter().all(|n| {
        n.derived_by.as_deref() != Some("t") && n.primes == 0 && !matches!(n.call, Call::Places(_)) && !n.is_difference
    })
}

/// The names of the sides that are products of capital letters, and of nothing else, or one of them alone; none where no side is a product.
fn products_of_capitals(sides: &[&PrintedSide]) -> BTreeSet<String> {
    let is_capital = |n: &PaperName| {
        n.base == n.letter && n.letter.chars().all(|c| c.is_ascii_uppercase()) && n.dots == 0 && n.call == Call::None
    };
    let mut out = BTreeSet::new();
    let mut has_product = false;
    for side in sides {
        let all = names_apart(side);
        let keys: Vec<String> = all.iter().map(PaperName::key).collect();
        if all.iter().all(is_capital) && squeezed(&side.text) == squeezed(&keys.concat()) {
            has_product |= keys.len() > 1;
            out.extend(keys);
        }
    }
    if has_product { out } else { BTreeSet::new() }
}

/// How shapes and motions may be taken in a formula, the better way first.
fn ways(
    sides: &[&PrintedSide],
    all: &[PaperName],
    (evidence, products): (&Evidence, &BTreeSet<String>),
    place: Place,
) -> Vec<Way> {
    let printed = sides.iter().find_map(|s| evidence::size(&s.tokens)).map(|(rows, _)| rows).filter(|n| *n > 1);
    let usual = Way { dimension: 3, ..Way::default() };
    let mut ways = vec![usual, Way { dimension: printed.unwrap_or(3), ..usual }, Way { bold_matrices: true, ..usual }];
    if !evidence.sizes.is_empty() {
        ways.push(Way { columns_of_chapter: true, ..usual });
    }
    if sides.iter().any(|s| s.text.contains('\\')) {
        ways.push(Way { steady_before_time: true, ..usual });
    }
    let sizes_of = |n: &PaperName| evidence.sizes.get(&n.key()).or_else(|| evidence.sizes.get(&unprimed(n)));
    // What is of one size in the whole paper goes before what is of several.
    let mut known: Vec<_> = all.iter().filter_map(sizes_of).collect();
    known.sort_by_key(|sizes| sizes.len());
    let of_matrices: Vec<_> = known.into_iter().flat_map(|sizes| sizes.keys()).collect();
    let has_bold = all.iter().any(|n| n.is_bold);
    if has_bold || !of_matrices.is_empty() {
        // A vector has as many components as the matrices beside it have rows.
        let mut dimensions: Vec<usize> = printed.into_iter().collect();
        dimensions.extend(of_matrices.iter().map(|(rows, _)| *rows));
        dimensions.extend([2, 3, 4]);
        let mut seen = BTreeSet::new();
        dimensions.retain(|n| *n > 1 && seen.insert(*n));
        ways.extend(dimensions.iter().map(|&dimension| Way { dimension, ..usual }));
        // A function that is equal to a matrix keeps its size.
        let at_places = |n: &&PaperName| matches!(n.call, Call::Places(_));
        let sized: Vec<_> = all.iter().filter(at_places).filter_map(sizes_of).collect();
        dimensions.retain(|n| sized.iter().all(|sizes| sizes.keys().any(|(rows, _)| rows == n)));
        ways.extend(dimensions.iter().map(|&dimension| Way { dimension, is_uniform: true, ..usual }));
    }
    // `M=M_2M_1` beside a matrix: the order of the factors is kept, so that what holds of matrices holds of numbers.
    if !products.is_empty() {
        let square = of_matrices.iter().filter(|(rows, columns)| rows == columns && *rows > 1).map(|(rows, _)| *rows);
        let dimensions: BTreeSet<usize> = printed.into_iter().chain(square).collect();
        if let (Some(&dimension), 1) = (dimensions.first(), dimensions.len()) {
            ways.push(Way { dimension, products_are_of_matrices: true, ..usual });
        }
    }
    // `A^2=-\frac{k}{m}I`: no number is a matrix.
    if all.iter().any(|n| n.key() == IDENTITY) {
        let square = of_matrices.iter().filter(|(rows, columns)| rows == columns && *rows > 1).map(|(rows, _)| *rows);
        let dimensions: BTreeSet<usize> = printed.into_iter().chain(square).collect();
        ways.extend(dimensions.iter().map(|&dimension| Way { dimension, has_identity: true, ..usual }));
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
    if let Some(letter) = index::mixed(sides, evidence) {
        return Err(format!("an index that may be summed over, {letter}"));
    }
    let summed = index::summed(sides, evidence);
    // A letter that stands there without a subscript is no vector for those that it has elsewhere.
    let of_indices = all.iter().any(|n| n.subscript.is_some() && evidence.has_indices(&n.letter));
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
