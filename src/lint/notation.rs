//! What a paper shows of its names and of its notation, together.
//!
//! **In:** a paper. **Out:** an [`Evidence`]. **Guaranteed:** nothing is decided here.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Deref;

use latex::Logarithm;
use meter::{Ended, Limits, Task};
use paper::{DifferenceSigns, Notation, Paper, PaperName, PrintedSide, is_variable, names, unprimed};

use super::letters::{Sizes, sizes};
use super::refusal::NotRead;
use super::space::prints_operators;

/// What the whole paper shows of its names and of its notation.
#[derive(Clone, Debug, Default)]
pub struct Evidence {
    names: paper::Evidence,
    notation: Notation,
    /// Letters that have a subscript which is no index.
    labelled: BTreeSet<String>,
    /// Of names that are equal to a matrix somewhere: where the section begins and ends in which they are, and its rows and columns.
    sizes: Sizes,
    /// Which signs of differences are something else somewhere.
    differences: DifferenceSigns,
    /// Names with subscripts that stand in a sum with a bare number: `P_{r,i}+1`.
    numbers: BTreeSet<String>,
    /// Whether hats may be those of operators.
    has_operators: bool,
    /// What `\log` is, where somebody says it.
    logarithm: Option<Logarithm>,
    /// The work of the paper.
    limits: Limits,
}

impl Deref for Evidence {
    type Target = paper::Evidence;
    fn deref(&self) -> &paper::Evidence {
        &self.names
    }
}

impl Evidence {
    /// The evidence of a paper; `names` is what was seen of its names.
    pub fn new(paper: &Paper, names: paper::Evidence, limits: &Limits) -> Evidence {
        let labelled = names.subscripts.iter().filter(|(_, all)| all.have_label()).map(|(letter, _)| letter.clone());
        let labelled = labelled.collect();
        let sizes = sizes(paper);
        let (differences, logarithm) = (paper.differences.clone(), paper.logarithm);
        let (notation, limits) = (Notation::of(paper), limits.of_file(0));
        let has_operators = notation.is_quantum() && prints_operators(paper);
        let numbers = beside_numbers(paper);
        Evidence { names, notation, labelled, sizes, differences, numbers, has_operators, logarithm, limits }
    }

    /// Whether a name is a number, and its subscripts are labels: it stands in a sum with a bare number, of which each term would have the index.
    pub fn is_a_number(&self, key: &str) -> bool {
        self.numbers.contains(key)
    }

    /// Whether hats may be those of operators.
    pub fn has_operators_with_hats(&self) -> bool {
        self.has_operators
    }

    /// The variables of which the paper shows a name to be a function, and how often: by a place behind it, with primes or without, or a derivative.
    pub fn variables_of(&self, name: &PaperName) -> BTreeMap<String, usize> {
        let bare = unprimed(name);
        let mut out: BTreeMap<String, usize> = BTreeMap::new();
        for (places, n) in self.names.calls.get(&bare).into_iter().flatten() {
            if let Some([one]) = places.as_deref()
                && is_variable(one)
            {
                *out.entry(one.clone()).or_default() += n;
            }
        }
        let primed = self.names.primed_places.get(&bare).into_iter().flatten().map(|(by, n)| (by.clone(), *n));
        let derived = self.names.derived.get(&bare).into_iter().flatten().map(|by| (by.clone(), 1));
        for (by, n) in primed.chain(derived) {
            *out.entry(by).or_default() += n;
        }
        out.remove(&bare);
        out
    }

    /// What `\log` is, where somebody says it.
    pub fn logarithm(&self) -> Option<Logarithm> {
        self.logarithm
    }

    /// Sets what `\log` is, where the paper does not say it.
    pub fn assume_logarithm(&mut self, logarithm: Option<Logarithm>) {
        self.logarithm = logarithm;
    }

    /// The limits of the questions of the paper, with one total for all of them.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Why nothing more is asked, where it is so.
    pub fn ended(&self) -> Option<Ended> {
        let is_worked_through = self.limits.total.left() == 0;
        self.limits.reached().or_else(|| is_worked_through.then_some(Ended::File(Task::Step, self.limits.work)))
    }

    /// Rows and columns of a name at a place, where the section says that it is a matrix.
    pub fn matrix_size(&self, key: &str, place: usize) -> Option<(usize, usize)> {
        let mut here =
            self.sizes.get(key)?.iter().filter(|(section, _)| section.contains(&place)).map(|(_, size)| *size);
        let first = here.next()?;
        here.all(|other| other == first).then_some(first)
    }

    /// Whether a letter has a subscript that is no index: beside `E_r` and `E_t`, the one of `E_i` is a label, too.
    pub fn is_labelled(&self, letter: &str) -> bool {
        self.labelled.contains(letter)
    }

    /// Whether a name is a difference of something, and the sign may be a factor or an operator in this paper.
    pub fn is_unsure_difference(&self, name: &PaperName) -> bool {
        name.difference_sign().is_some_and(|sign| !self.differences.makes_names(sign))
    }

    /// Whether a side stands in a text of groups, rings, cardinals or logic: what is printed as a product, or a sum, may be anything.
    pub fn is_algebra(&self, side: &PrintedSide) -> bool {
        self.notation.is_algebra(side)
    }

    /// Whether something is said modulo something: `\equiv` is then no equality.
    pub fn has_modulus(&self) -> bool {
        self.notation.has_modulus()
    }

    /// Whether products of vectors may be of operators.
    pub fn is_quantum(&self) -> bool {
        self.notation.is_quantum()
    }

    /// Whether a name varies, though the paper prints no rate of it.
    pub fn varies(&self, key: &str) -> bool {
        self.notation.varies(key) && !self.names.moving.contains(key)
    }

    /// The obstacle to reading sides as numbers together; what is known as a function is read as one.
    pub fn obstacle_together(&self, sides: &[&PrintedSide]) -> Option<NotRead> {
        let is_function = |letter: &str| self.names.may_be_function(letter);
        Notation::not_numbers_together(sides, &is_function).map(NotRead::of)
    }

    /// What keeps a side from being read as numbers: nothing is declared of its names.
    pub fn obstacle(&self, side: &PrintedSide) -> Option<NotRead> {
        let is_matrix = |letter: &str| self.matrix_size(letter, side.span.start).is_some();
        self.notation.not_numbers(side).or_else(|| self.notation.unsure(side, &is_matrix)).map(NotRead::of)
    }
}

/// The names with letters below of which a sum with 1 stands alone in brackets, or in braces: `\frac{P_{r,i}}{1+P_{r,i}}`.
fn beside_numbers(paper: &Paper) -> BTreeSet<String> {
    let mut out = BTreeSet::new();
    for side in paper.printed.iter().flat_map(|relation| &relation.sides) {
        let text: String = side.text.chars().filter(|c| !c.is_whitespace()).collect();
        let text = text.replace(r"\left", "").replace(r"\right", "");
        if !["1+", "+1", "1-"].iter().any(|sum| text.contains(sum)) {
            continue;
        }
        let is_alone = |sum: &str| [("{", "}"), ("(", ")")].iter().any(|(a, b)| text.contains(&format!("{a}{sum}{b}")));
        let keys = names(side).into_iter().filter(|n| !n.index_letters().is_empty()).map(|n| n.key());
        let sums = |key: &str| [format!("1+{key}"), format!("{key}+1"), format!("1-{key}")];
        out.extend(keys.filter(|key| sums(key).iter().any(|sum| is_alone(sum))));
    }
    out
}
