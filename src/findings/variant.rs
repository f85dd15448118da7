//! What the reports are told about variants.

use serde::{Deserialize, Serialize};
use std::ops::Range;
use verdict::Strength;

use crate::account::{Account, ClaimAccount};

/// The start of the generator of points.
pub const SEED: u64 = 0x0DD5;

/// Kinds of slips.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum EditClass {
    /// The sign of a term, of an argument or of a side; ± for one of its signs.
    Sign,
    /// An index for another; two indices of a symbol exchanged.
    Index,
    /// A factor 2 or ½.
    Factor,
    /// A power one higher or lower; a root left out.
    Power,
    /// Sine for cosine, and their kin.
    Function,
    /// A symbol for another of the same shape and role.
    Symbol,
    /// A term or a factor left out.
    Dropped,
    /// A transpose, or a complex conjugate, set or left out.
    Transpose,
    /// The factors of a vector product, or two indices of ε, exchanged.
    Orientation,
    /// Another convention, throughout the formula: two like symbols exchanged, an angle counted from a quarter turn further
    /// or in the other direction.
    Convention,
    /// A factor or a term that is missing. Only corrections are of this class.
    Missing,
}

impl EditClass {
    /// All classes that variants are made of.
    pub const ALL: [EditClass; 10] = [
        EditClass::Sign,
        EditClass::Index,
        EditClass::Factor,
        EditClass::Power,
        EditClass::Function,
        EditClass::Symbol,
        EditClass::Dropped,
        EditClass::Transpose,
        EditClass::Orientation,
        EditClass::Convention,
    ];

    /// The word of the reports.
    pub fn word(self) -> &'static str {
        match self {
            EditClass::Sign => "sign",
            EditClass::Index => "index",
            EditClass::Factor => "factor",
            EditClass::Power => "power",
            EditClass::Function => "function",
            EditClass::Symbol => "symbol",
            EditClass::Dropped => "dropped",
            EditClass::Transpose => "transpose or conjugate",
            EditClass::Orientation => "orientation",
            EditClass::Convention => "convention",
            EditClass::Missing => "missing",
        }
    }

    /// What is wrong with a formula that has such an edit, in words.
    pub fn says(self) -> &'static str {
        match self {
            EditClass::Sign => "a wrong sign",
            EditClass::Index => "a wrong index",
            EditClass::Factor => "a wrong factor 2 or ½",
            EditClass::Power => "a wrong power",
            EditClass::Function => "sine for cosine",
            EditClass::Symbol => "a wrong symbol",
            EditClass::Dropped => "a term or factor left out",
            EditClass::Transpose => "a wrong transpose or conjugate",
            EditClass::Orientation => "the other orientation of a vector product",
            EditClass::Convention => "another convention for an angle or an order",
            EditClass::Missing => "a missing term or factor",
        }
    }
}

/// How many of the variants of a claim one motion rejects.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Discrimination {
    /// Variants that would not hold there: violated at some time, or without a value at every time.
    pub rejected: usize,
    /// Variants that were tried.
    pub of: usize,
    /// Those that the motion does not tell from the claim: positions in [`VariantAccount::survivors`].
    pub survivors: Vec<usize>,
}

impl Discrimination {
    /// The share that is rejected; 1 where there is no variant.
    pub fn share(&self) -> f64 {
        if self.of == 0 { 1.0 } else { self.rejected as f64 / self.of as f64 }
    }

    /// Whether so many altered formulas would hold as well that the verdict says little.
    pub fn is_weak(&self) -> bool {
        self.of > 0 && self.share() < WEAK
    }
}

/// A verdict `holds` is weak when a smaller share of the variants is rejected.
pub const WEAK: f64 = 0.75;

/// What became of the edits of one class.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClassCount {
    /// The class.
    pub class: EditClass,
    /// Edits that were made.
    pub generated: usize,
    /// Edits without a meaning: of the wrong shape, with a stray index, or with a value at a time that is not known.
    pub meaningless: usize,
    /// Edits that give what another edit gives, too.
    pub repeated: usize,
    /// Edits that change nothing, as the definitions of the symbols have it.
    pub equivalent: usize,
    /// Edits whose formula is true whatever the values are: it says nothing.
    pub empty: usize,
    /// Variants: what is left.
    pub kept: usize,
}

/// A variant that some motion does not tell from the claim.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Survivor {
    /// What was altered.
    pub class: EditClass,
    /// The formula as the file has it.
    pub printed: String,
    /// Its place in the file; none for a definition that stands for a name, nor in an account that was kept: the file may have moved it.
    #[serde(skip)]
    pub place: Option<Range<usize>>,
    /// The altered formula.
    pub formula: String,
    /// Whether no motion on which the claim holds rejects it.
    pub everywhere: bool,
}

/// A formula that holds where the printed one does not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Correction {
    /// The formula as printed.
    pub printed: String,
    /// The formula that holds.
    pub formula: String,
    /// The same with what is removed between `[-` and `-]`, and what is added between `{+` and `+}`.
    pub difference: String,
    /// The edits that lead from the one to the other.
    pub classes: Vec<EditClass>,
    /// The weakest strength with which it holds on a motion; *proved* where it is an identity, given what the claim follows from.
    pub strength: Strength,
    /// On how many motions it holds: on all to which the claim applies.
    pub holds_on: usize,
}

/// What a claim should have said, as far as one or two edits reach.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Erratum {
    /// Corrections, the closest to the print first.
    pub corrections: Vec<Correction>,
    /// Altered formulas that were tried: single edits, completions, pairs of edits.
    pub tried: (usize, usize, usize),
    /// Why nothing was found, or not everything was tried.
    pub remark: Option<String>,
    /// Of a quantity that is not constant, its rate by one term, as an equation: proved from what the claim follows from.
    pub rate: Option<String>,
}

/// The variants of a claim.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct VariantAccount {
    /// Counts, by class; classes without any edit are left out.
    pub classes: Vec<ClassCount>,
    /// Formulas without variants, and why.
    pub skipped: Vec<(String, String)>,
    /// Variants that some motion does not reject, in the order in which they were made.
    pub survivors: Vec<Survivor>,
    /// On how many motions the claim holds and the variants were tried.
    pub tried_on: usize,
    /// The fewest motions that reject all variants that are rejected by any.
    pub cover: Vec<String>,
    /// Whether there is certainly no smaller set of them.
    pub cover_is_least: bool,
    /// What the claim should have said, where it fails.
    pub erratum: Option<Erratum>,
}

impl VariantAccount {
    /// Number of variants.
    pub fn kept(&self) -> usize {
        self.classes.iter().map(|c| c.kept).sum()
    }

    /// How many variants the motions on which the claim holds reject together, and of how many; nothing where it holds on
    /// none, or has no variants.
    pub fn together(&self) -> Option<(usize, usize)> {
        let everywhere = self.survivors.iter().filter(|s| s.everywhere).count();
        (self.tried_on > 0 && self.kept() > 0).then(|| (self.kept() - everywhere, self.kept()))
    }

    /// The kinds of slips that survive among these survivors, in order and each once.
    pub fn unnoticed(&self, survivors: impl Iterator<Item = usize>) -> Vec<EditClass> {
        let mut classes: Vec<EditClass> = survivors.filter_map(|i| self.survivors.get(i)).map(|s| s.class).collect();
        classes.sort_unstable();
        classes.dedup();
        classes
    }
}

impl Account {
    /// The claims of whose variants all motions together reject less than a share: name, rejected, of.
    pub fn discriminating_less_than(&self, share: f64) -> Vec<(String, usize, usize)> {
        let of = |claim: &ClaimAccount| {
            let (rejected, of) = claim.variants.as_ref()?.together()?;
            let name = match &claim.reading {
                Some(reading) => format!("{}/{reading}", claim.id),
                None => claim.id.clone(),
            };
            ((rejected as f64) < share * of as f64).then_some((name, rejected, of))
        };
        self.claims.iter().filter_map(of).collect()
    }
}
