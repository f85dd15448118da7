//! Where a text is one of groups, rings, cardinals or logic: what is printed there as a product, a sum or a power may be anything.
//!
//! **In:** the text of a file. **Out:** an [`Algebra`], which tells for a place whether it stands in such a text. **Guaranteed:** words only keep
//! something from being read, or from being called wrong.

/// Words of which several in a file are enough, however long it is.
const ALGEBRA: &[&str] = &[
    "subgroup",
    "coset",
    "homomorphism",
    "isomorphi",
    "abelian",
    "noetherian",
    "functor",
    "morphism",
    "sylow",
    "legendre symbol",
    "alternating group",
    "symmetric group",
    "conjugacy class",
    "residue field",
    "quotient group",
    "quotient ring",
];
/// Words that count where they stand close to each other: other papers have them, too.
const CLOSE: &[&str] = &[
    "semigroup",
    "monoid",
    "groupoid",
    "integral domain",
    "subring",
    "subfield",
    "idempotent",
    "boolean",
    "karnaugh",
    "logic gate",
    "truth table",
    "transposition",
    "permutation",
    "disjoint cycle",
    "ordinal",
    "cardinal",
    "power set",
    "jacobi symbol",
    "quadratic residue",
    "cyclic group",
    "finite field",
    "field extension",
    "commutative ring",
    "polynomial ring",
    " rings",
    "anillo",
    "galois",
    "equivalence class",
    "zero divisor",
    "principal ideal",
    "陪集",
    "商集",
    "同态",
    "同构",
    "交换群",
    "置换",
];
/// So many words of [`ALGEBRA`] make a file one of algebra.
const MANY: usize = 8;
/// One word of both tables among so many words of a file does, too, if there are at least two.
const DENSE: usize = 200;
/// So many of them near a place make its surroundings algebra: before it, and behind it, in bytes.
const NEAR: usize = 5;
const BEFORE: usize = 2500;
const BEHIND: usize = 800;

/// Where such words stand in a file.
pub(super) struct Algebra {
    is_whole: bool,
    places: Vec<usize>,
}

impl Algebra {
    pub(super) fn of(text: &str) -> Algebra {
        let text = text.to_ascii_lowercase();
        let find = |words: &[&'static str]| -> Vec<usize> {
            words.iter().flat_map(|w| text.match_indices(w).map(|(at, _)| at)).collect()
        };
        let mut places = find(ALGEBRA);
        let is_many = places.len() >= MANY;
        places.extend(find(CLOSE));
        places.sort_unstable();
        let words = text.split_whitespace().count();
        Algebra { is_whole: is_many || places.len() > 1 && places.len() * DENSE >= words, places }
    }

    /// Whether a place stands in a text of algebra.
    pub(super) fn holds(&self, at: usize) -> bool {
        let up_to = |place: usize| self.places.partition_point(|p| *p < place);
        self.is_whole || up_to(at + BEHIND) - up_to(at.saturating_sub(BEFORE)) >= NEAR
    }
}

#[cfg(test)]
mod tests {
    use super::Algebra;

    #[test]
    fn words_of_algebra_count_by_their_number_or_where_they_stand_close() {
        assert!(Algebra::of("Let G be a semigroup. A permutation of it").holds(3));
        assert!(!Algebra::of("A permutation of two particles").holds(3));
        let long = "a word ".repeat(2000);
        assert!(Algebra::of(&format!("{}{long}", "subgroup ".repeat(8))).holds(10_000));
        let local = Algebra::of(&format!("{long}{}{long}", "boolean ".repeat(5)));
        assert!(local.holds(long.len() + 10) && !local.holds(10) && !local.holds(2 * long.len()));
    }
}
