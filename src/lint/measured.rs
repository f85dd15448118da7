//! Units behind numbers: which formula of numbers may be right in another unit.

use paper::PrintedRelation;

use super::LintWitness;
use super::judge::Judge;
use super::sentence::window;

/// The longest text behind a number that is looked at for a unit.
const UNIT_BEHIND: usize = 40;
/// Prefixes of units, units that have them, and others that are multiples of a unit.
const PREFIXES: &[&str] = &["n", "µ", "μ", "m", "c", "d", "h", "k", "M", "G", "T", "p", "f"];
const UNITS: &[&str] = &[
    "s", "m", "g", "A", "V", "W", "J", "N", "C", "F", "H", "T", "Hz", "Pa", "eV", "K", "Ω", "ohm", "ohms", "mol", "L",
    "l", "bar", "cal", "Wh",
];
const MULTIPLES: &[&str] = &[
    "%", "°", "percent", "degrees", "min", "minutes", "h", "hours", "days", "years", "cm", "km", "mm", "kg", "in",
    "ft", "miles", "inches", "feet", "hr", "yr", "bar", "atm", "eV", "cal", "AU", "Å", "ppm", "dB",
];

/// The highest power of ten by which units differ.
const MOST_TENS: usize = 18;
/// Multiples beside powers of ten.
const FACTORS: &[f64] = &[60.0, 3600.0, 24.0, 1440.0, 86400.0, 7.0, 12.0, 365.0];

impl Judge<'_> {
    /// Whether the words behind a formula begin with a unit that is a multiple of another one, "$RC=0.5$ ms", and its numbers differ by such a
    /// multiple.
    pub(super) fn is_in_another_unit(&self, relation: &PrintedRelation, witness: &LintWitness) -> bool {
        let factor = (witness.left / witness.right).abs().max((witness.right / witness.left).abs());
        let tens = std::iter::successors(Some(10.0), |ten| Some(ten * 10.0)).take(MOST_TENS);
        let is_multiple = tens.chain(FACTORS.iter().copied()).any(|f| (factor - f).abs() < 1e-9 * f);
        if !witness.values.is_empty() || !is_multiple {
            return false;
        }
        let (file, span) = self.paper.locate(&relation.span());
        let behind = window(&file.text, span.end, span.end + UNIT_BEHIND);
        let skipped = |c: char| c.is_whitespace() || matches!(c, '$' | '~' | '\\' | ',' | ')' | '{');
        let behind = behind.trim_start_matches(skipped);
        let behind =
            ["mathrm{", "text{", "rm "].iter().find_map(|c| behind.strip_prefix(c)).unwrap_or(behind).trim_start();
        let end = behind.find(|c: char| !c.is_alphabetic() && !matches!(c, '%' | '°' | 'µ')).unwrap_or(behind.len());
        let word = &behind[..end];
        let is_multiple = |prefix: &str| word.strip_prefix(prefix).is_some_and(|unit| UNITS.contains(&unit));
        MULTIPLES.contains(&word) || PREFIXES.iter().any(|p| is_multiple(p))
    }
}
