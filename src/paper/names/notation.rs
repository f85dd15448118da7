//! What a paper shows of its notation: where what stands side by side is no product of numbers, and what stands above is no power.
//!
//! **In:** a paper, then its sides one by one. **Out:** why a side is not read as numbers. **Guaranteed:** only the print, and the words beside
//! lone names, are looked at; what is seen of a letter once is so in the whole paper. A formula that is not read is told as that: a
//! power that is an index, or two operators in another order, would be *proved*.

mod acting;
mod algebra;
mod ambiguous;
mod angles;
mod apart;
mod print;
mod words;

use std::collections::{BTreeMap, BTreeSet};

use super::super::{Paper, PrintedRelation, PrintedSide};
use super::{PaperName, names_apart};
use acting::Acting;
use algebra::Algebra;
use ambiguous::{
    applies_a_group, has_bare_degrees, has_commutator, has_cosets, has_expectation, has_ladder, has_map_of_vector,
    has_order_of_magnitude, has_plain_triple_product, has_primed_transpose, has_small_transpose, has_turned_subscripts,
    has_two_places, has_upright_derivative,
};
use angles::Angles;
use apart::has_scripts_apart;
use print::{
    call, follows_a_flow, has_bare_brackets, has_bars, has_column_of_two, has_identity, has_imaginary,
    has_named_function, has_norm, has_pair, has_plain_function, has_product_of_letters, has_unit_of_italics,
    is_letter_token, is_twice, scripted, squares_an_absolute_value, tokens,
};
use words::{is_lone, named_beside};

/// What a paper shows of its notation.
#[derive(Clone, Debug, Default)]
pub struct Notation {
    /// Letters with an index above them somewhere.
    upper: BTreeSet<String>,
    /// Letters with a number above them somewhere that is no usual power: 0, 1, 3.
    numbered: BTreeSet<String>,
    /// Keys of names whose order counts: operators, matrices, elements of a group.
    ordered: BTreeSet<String>,
    /// Names that are called operators.
    acting: Acting,
    /// What functions of angles are applied to.
    angles: Angles,
    /// The relations that stand in a text of groups, rings, cardinals or logic: where each begins, and ends.
    algebra: BTreeMap<usize, usize>,
    /// Keys of names that are equal, to some power, to what has a rate in it: they vary, though no rate of them is printed.
    varies: BTreeSet<String>,
    /// Whether the imaginary unit stands somewhere.
    has_imaginary: bool,
    /// Keys of names in relations in which it stands, or that are said to be complex.
    complex: BTreeSet<String>,
    /// Keys of names that are said to be vectors, and are printed as numbers are.
    vectors: BTreeSet<String>,
    /// Whether the paper is one of random variables: an E may be an expectation.
    is_stochastic: bool,
    /// Whether it has eigenvectors: a capital before a vector may be a matrix.
    has_eigenvectors: bool,
    /// Whether something is said modulo something: `\equiv` is then no equality.
    has_modulus: bool,
    /// Whether it is one of quanta: products of vectors may be of operators.
    is_quantum: bool,
    /// Whether it prints hats above plain letters, as operators have them.
    has_hats: bool,
    /// Whether it counts combinations: a column of two in parentheses may be a binomial coefficient.
    is_combinatorial: bool,
}

/// Words of papers in which an E may be an expectation.
const STOCHASTIC: &[&str] = &[
    "random variable",
    "random vector",
    "i.i.d",
    "zufallsvariable",
    "variable aléatoire",
    "variables aléatoires",
    r"variable al\'eatoire",
    "variabile aleatoria",
    "variabili aleatorie",
    "variable aleatoria",
    "variables aleatorias",
    "variável aleatória",
    "covariance",
];
/// Words of papers with eigenvectors.
const EIGEN: &[&str] =
    &["eigenvec", "eigenval", "vecteur propre", "vecteurs propres", "autovett", "autovec", "autoval"];
/// What says that something holds modulo something.
const MODULO: &[&str] = &[
    r"\pmod",
    r"\bmod",
    r"\pod",
    "(mod",
    "$ mod $",
    "$ mod~$",
    "congruence",
    "congruent mod",
    "integers mod",
    "numbers mod",
];

/// Words of papers in which a column of two in parentheses may be a binomial coefficient.
const BINOMIAL: &[&str] = &["binomial", r"\binom", r"\choose", "combinator", "binôm", "coefficiente binom", "pascal's"];

/// Words beside a lone name that say that its order counts.
const ORDERED: &[&str] = &[
    "matri",
    "Matri",
    "commut",
    "subgroup",
    "coset",
    "quaternion",
    "spinor",
    "grassmann",
    "generator",
    "group element",
    "linear map",
];
/// Words beside a lone name that say that it is a vector.
const VECTORS: &[&str] = &["vectors", "Vektoren", "vecteurs", "vettori", "vectores", "vetores"];
/// Longest side, in bytes, of which the notation is looked at for evidence.
const LONGEST: usize = 4_000;
/// The most terms of a side that are compared with each other.
const MOST_TERMS: usize = 60;

impl Notation {
    /// The notation of a paper.
    pub fn of(paper: &Paper) -> Notation {
        let mut out = Notation::default();
        for file in files(paper) {
            let text = file.text.to_lowercase();
            out.ordered.extend(named_beside(&file.text, ORDERED).into_iter().map(|n| n.key));
            out.vectors.extend(named_beside(&file.text, VECTORS).into_iter().map(|n| n.key));
            let says = |words: &[&str]| words.iter().any(|w| text.contains(w));
            out.is_stochastic |= says(STOCHASTIC) || says(&["expectation"]) && !says(&[r"\hbar", r"\psi"]);
            out.has_eigenvectors |= says(EIGEN);
            out.is_combinatorial |= says(BINOMIAL);
            out.has_modulus |= says(MODULO);
            out.is_quantum |= says(&[r"\hbar", "commutator", "kommutator", "commutateur"]);
        }
        out.algebra = algebraic(paper);
        out.acting = Acting::of(paper, out.is_quantum);
        let mut pairs: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for relation in &paper.printed {
            for side in relation.sides.iter().filter(|s| s.text.len() <= LONGEST) {
                for one in scripted(&tokens(&side.text)) {
                    if one.is_index() && !one.is_digit("0") && !one.is_digit("1") {
                        out.upper.insert(one.base.clone());
                    }
                    if ["0", "1", "3"].iter().any(|digit| one.is_digit(digit)) {
                        out.numbered.insert(one.base.clone());
                    }
                    if let Some(digits) = one.two_digits() {
                        pairs.entry(one.base.clone()).or_default().insert(digits);
                    }
                }
                out.angles.note(&side.text);
                out.has_hats |= has_plain_hat(&tokens(&side.text));
                if has_imaginary(&side.text) {
                    out.has_imaginary = true;
                    out.complex.extend(relation.sides.iter().flat_map(names_apart).map(|n| n.key()));
                }
            }
            out.note_set(relation);
            out.ordered.extend(relation.sides.iter().filter(|s| s.text.len() <= LONGEST).flat_map(commuted));
            if out.is_quantum {
                out.ordered.extend(commuted_across(relation));
            }
            out.varies.extend(varying(&relation.sides));
        }
        let turned = |all: &BTreeSet<String>| {
            all.iter().any(|p| all.contains(&p.chars().rev().collect::<String>()) && !is_twice(p))
        };
        out.upper.extend(pairs.into_iter().filter(|(_, all)| turned(all)).map(|(base, _)| base));
        out
    }

    /// Notes what is said to be complex, a vector or a matrix: `$z\in\mathbb C$`, `$u\in\mathbb R^3$`.
    fn note_set(&mut self, relation: &PrintedRelation) {
        let [left, right] = relation.sides.as_slice() else { return };
        if relation.signs.first().is_none_or(|s| s != r"\in") {
            return;
        }
        let set = squeezed(&right.text);
        let keys = || names_apart(left).into_iter().map(|n| n.key());
        if set.starts_with(r"\mathbbC") {
            self.has_imaginary = true;
            self.complex.extend(keys());
        }
        if set.starts_with(r"\mathbbR^") || set.starts_with(r"\mathbbC^") {
            self.vectors.extend(keys().map(|k| squeezed(&k)));
        }
        if set.contains(r"\times") {
            self.ordered.extend(keys().map(|k| squeezed(&k)));
        }
    }

    /// Whether a side stands in a text of groups, rings, cardinals or logic: what is printed as a product, or a sum, may be anything.
    pub fn is_algebra(&self, side: &PrintedSide) -> bool {
        let before = self.algebra.range(..=side.span.start).next_back();
        before.is_some_and(|(_, end)| side.span.start <= *end)
    }

    /// Whether something is said modulo something: `\equiv` is then no equality.
    pub fn has_modulus(&self) -> bool {
        self.has_modulus
    }

    /// Whether products of vectors may be of operators.
    pub fn is_quantum(&self) -> bool {
        self.is_quantum
    }

    /// Whether the paper may be one of operators: angle brackets are then those of states.
    pub fn has_operators(&self) -> bool {
        self.is_quantum || self.has_hats
    }

    /// Whether a name varies, though the paper prints no rate of it.
    pub fn varies(&self, key: &str) -> bool {
        self.varies.contains(key)
    }

    /// A formula with parentheses around the angles behind functions, where the paper shows that what follows is a factor.
    pub fn with_ends_of_angles(&self, text: &str) -> Option<String> {
        self.angles.with_ends(text)
    }

    /// Why a side is no formula of numbers, vectors and matrices, whatever its names are declared as.
    pub fn not_numbers(&self, side: &PrintedSide) -> Option<&'static str> {
        let all = tokens(&side.text);
        if has_scripts_apart(&side.tokens) {
            return Some("scripts behind each other: indices of a tensor, or a power");
        }
        for one in scripted(&all) {
            let is_square = one.is_digit("2") && (one.is_bold || !self.numbered.contains(&one.base));
            if one.is_index() || self.upper.contains(&one.base) && !is_square && one.could_be_index() {
                return Some("an index above, or a power");
            }
            if one.calls {
                return Some("a call of what has something above, or a power");
            }
        }
        if follows_a_flow(&side.text) {
            return Some("a derivative that follows a flow");
        }
        if all.iter().any(|t| matches!(*t, r"\forall" | r"\exists" | r"\nexists")) {
            return Some("a quantifier");
        }
        if all.iter().any(|t| matches!(*t, r"\mathbb" | r"\mathds")) {
            return Some("a set, or an expectation");
        }
        if has_unit_of_italics(&side.text) {
            return Some("a number with its unit, or a product");
        }
        if has_named_function(&all) || has_plain_function(&side.text) {
            return Some("a function by its name, or a product");
        }
        if self.is_combinatorial && has_column_of_two(&all) {
            return Some("a binomial coefficient, or a column");
        }
        if let Some(what) = call(&all) {
            return Some(what);
        }
        if self.angles.stands_before_time(&all) {
            return Some("an angle before the time: a factor, or a part of the argument");
        }
        if has_order_of_magnitude(&all) {
            return Some("an order of magnitude");
        }
        if has_upright_derivative(&all) {
            return Some("a derivative, or a factor");
        }
        if all.contains(&r"\aleph") {
            return Some("a cardinal number");
        }
        if self.acting.acts_in(side) {
            return Some("an operator, or a factor");
        }
        None
    }

    /// Why sides that are compared are no formulas of numbers together, though each of them could be one.
    pub fn not_numbers_together(sides: &[&PrintedSide], is_function: &dyn Fn(&str) -> bool) -> Option<&'static str> {
        let all: Vec<Vec<&str>> = sides.iter().map(|s| tokens(&s.text)).collect();
        if has_cosets(&all) {
            return Some("cosets, or sums");
        }
        has_two_places(&all, is_function).then_some("a value at a place, or a product")
    }

    /// Why a side may be no formula of numbers, where nothing says that its names are matrices, vectors or complex; of some letters it may be known that
    /// they are matrices.
    pub fn unsure(&self, side: &PrintedSide, is_matrix: &dyn Fn(&str) -> bool) -> Option<&'static str> {
        let all = tokens(&side.text);
        if scripted(&all).iter().any(|one| one.is_transpose() && !is_matrix(&one.base)) {
            return Some("a transpose, or a power");
        }
        if has_small_transpose(&all) || has_primed_transpose(&all) {
            return Some("a transpose, or a power");
        }
        if applies_a_group(&all) {
            return Some("a function of anything, or a product");
        }
        if has_commutator(&all) {
            return Some("products whose order may count: matrices, or operators");
        }
        if self.is_quantum && has_ladder(&side.text) {
            return Some("products whose order may count: matrices, or operators");
        }
        if has_plain_triple_product(&all) {
            return Some("vectors in plain letters");
        }
        if has_bare_degrees(&all) {
            return Some("an angle in degrees, or a number");
        }
        if has_turned_subscripts(&all) {
            return Some("derivatives, or labels");
        }
        if all.iter().any(|t| matches!(*t, r"\mathfrak" | r"\frak")) {
            return Some("sets, or elements of an algebra");
        }
        if self.is_stochastic && has_expectation(&all) {
            return Some("an expectation, or a factor");
        }
        if self.has_eigenvectors && has_map_of_vector(&all) {
            return Some("a matrix before a vector, or a factor");
        }
        if has_identity(&all) {
            return Some("a sum with the identity, or with a number");
        }
        if has_pair(&all) {
            return Some("a pair: a point, or a product of two vectors");
        }
        if has_norm(&side.text) {
            return Some("a norm, or an absolute value");
        }
        if has_bare_brackets(&all) {
            return Some("brackets of a dimension, a unit, a matrix or a whole part");
        }
        let beside_i = self.has_imaginary && names_apart(side).iter().any(|n| self.complex.contains(&n.key()));
        if (beside_i || squares_an_absolute_value(&side.text)) && has_bars(&side.text) {
            return Some("an absolute value of what may be complex");
        }
        let of_vectors =
            names_apart(side).iter().filter(|n| !n.is_bold && self.vectors.contains(&squeezed(&n.key()))).count();
        if of_vectors > 1 || of_vectors > 0 && has_bars(&side.text) {
            return Some("vectors in plain letters");
        }
        let mut ordered = names_apart(side)
            .into_iter()
            .map(|n| n.key())
            .filter(|k| self.ordered.contains(&squeezed(k)))
            .collect::<Vec<_>>();
        ordered.sort();
        ordered.dedup();
        if ordered.len() > 1 || self.is_algebra(side) && has_product_of_letters(&all) {
            return Some("products whose order may count: matrices, operators, or elements of a group");
        }
        None
    }
}

/// The names that alone make up a side, whatever their power, beside one with rates: `v^2=\dot x^2+\dot y^2`.
fn varying(sides: &[PrintedSide]) -> Vec<String> {
    let all: Vec<Vec<PaperName>> = sides.iter().map(names_apart).collect();
    let has_rate =
        |k: usize| all.get(k).is_some_and(|n| n.iter().any(|n| n.dots > 0 || n.derived_by.as_deref() == Some("t")));
    let lone = |k: &usize| match all[*k].as_slice() {
        [one] => one.dots == 0 && one.derived_by.is_none() && !one.is_difference,
        _ => false,
    };
    let beside = |k: &usize| has_rate(k + 1) || *k > 0 && has_rate(k - 1);
    (0..all.len()).filter(lone).filter(beside).map(|k| all[k][0].key()).collect()
}

/// Where the relations begin and end that stand in a text of algebra.
fn algebraic(paper: &Paper) -> BTreeMap<usize, usize> {
    let mut known: Vec<(std::sync::Arc<diag::Source>, Algebra)> = Vec::new();
    let mut out = BTreeMap::new();
    for relation in &paper.printed {
        let span = relation.span();
        let (file, place) = paper.locate(&span);
        let found = known.iter().position(|(f, _)| std::sync::Arc::ptr_eq(f, file)).unwrap_or_else(|| {
            known.push((file.clone(), Algebra::of(&file.text)));
            known.len() - 1
        });
        if known[found].1.holds(place.start) {
            out.insert(span.start, span.end);
        }
    }
    out
}

/// Whether a hat stands above a letter that is no vector by its style.
fn has_plain_hat(all: &[&str]) -> bool {
    let is_bold = |t: &str| t.strip_prefix('\\').is_some_and(|t| super::letters::BOLD.contains(&t));
    let under = |at: usize| all[at + 1..].iter().find(|t| **t != "{").copied();
    (0..all.len()).any(|at| matches!(all[at], r"\hat" | r"\widehat") && under(at).is_some_and(|t| !is_bold(t)))
}

/// The files of a paper that print something.
pub(super) fn files(paper: &Paper) -> Vec<std::sync::Arc<diag::Source>> {
    let mut out: Vec<std::sync::Arc<diag::Source>> = Vec::new();
    for relation in &paper.printed {
        let (file, _) = paper.locate(&relation.span());
        if !out.iter().any(|known| std::sync::Arc::ptr_eq(known, file)) {
            out.push(file.clone());
        }
    }
    out
}

/// The names of two terms of a side that differ in nothing but their order, and in their sign: `xp-px`.
fn commuted(side: &PrintedSide) -> Vec<String> {
    let all = tokens(&side.text);
    let mut terms: Vec<(bool, Vec<&str>)> = vec![(false, Vec::new())];
    let mut depth = 0i32;
    for token in &all {
        match *token {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        match *token {
            "+" | "-" if depth == 0 => terms.push((*token == "-", Vec::new())),
            one => {
                if let Some(last) = terms.last_mut() {
                    last.1.push(one);
                }
            }
        }
    }
    terms.retain(|(_, t)| t.len() > 1);
    terms.truncate(MOST_TERMS);
    let mut out = Vec::new();
    for (i, a) in terms.iter().enumerate() {
        for b in &terms[i + 1..] {
            let (mut first, mut second) = (a.1.clone(), b.1.clone());
            first.sort_unstable();
            second.sort_unstable();
            let plain = a
                .1
                .iter()
                .all(|t| is_letter_token(t) || matches!(*t, "_" | "{" | "}") || t.chars().all(char::is_alphanumeric));
            if first == second && a.1 != b.1 && a.0 != b.0 && plain {
                out.extend(names_apart(side).into_iter().map(|n| squeezed(&n.key())));
                return out;
            }
        }
    }
    out
}

/// The names of a relation that says what two names are in the other order, `xp=px+i\hbar`, or what they have for a commutator, `[a,b]=1`.
fn commuted_across(relation: &PrintedRelation) -> Vec<String> {
    let [left, right] = relation.sides.as_slice() else { return Vec::new() };
    if relation.signs.first().is_none_or(|s| s != "=") || left.text.len() > MOST_TERMS {
        return Vec::new();
    }
    let keys = || names_apart(left).into_iter().filter(|n| !n.is_bold).map(|n| squeezed(&n.key())).collect::<Vec<_>>();
    let text = squeezed(&left.text).replace(r"\left", "").replace(r"\right", "").replace(r"\,", "");
    let within = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).and_then(|rest| rest.split_once(','));
    if within.is_some_and(|(a, b)| is_lone(a) && is_lone(b) && a != b) {
        return keys();
    }
    let whole = tokens(&left.text);
    let is_plain = |t: &&str| is_letter_token(t) || matches!(*t, "_" | "{" | "}" | "+" | "-");
    if whole.len() < 2 || !whole.iter().all(is_plain) {
        return Vec::new();
    }
    // Pairs of neighbours that stand the other way about before a further term.
    let behind = tokens(&right.text);
    let turned = whole.windows(2).any(|pair| {
        let is_turned = |other: &[&str]| other[0] == pair[1] && other[1] == pair[0];
        pair[0] != pair[1]
            && pair.iter().all(|t| is_letter_token(t))
            && behind.len() > whole.len() + 1
            && behind[..whole.len()].windows(2).any(is_turned)
            && matches!(behind[whole.len()], "+" | "-")
            && {
                let (mut a, mut b) = (whole.clone(), behind[..whole.len()].to_vec());
                a.sort_unstable();
                b.sort_unstable();
                a == b
            }
    });
    if turned { keys() } else { Vec::new() }
}

/// A text without spaces and braces.
pub fn squeezed(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect()
}
