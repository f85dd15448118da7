//! The nearest right formula: what should stand where a step is refuted.
//!
//! **In:** a refuted question. **Out:** a [`WrongStep`], where a formula that is one slip away is proved from the same things.
//! **Guaranteed:** what an author may mean is not called wrong: a constant that takes in a factor, a term that is neglected on
//! the earlier side, units in which a constant of nature is 1, another definition of a name, another branch of a solution.

use std::collections::BTreeSet;

use latex::syntax::{Chain, Node, NodeKind, SymbolNode, to_latex};
use meter::Task;
use paper::{PrintedSide, names};
use proof::{Identity, Point, Refutation, Wanted};

use expr::{Graph, Leaf, Rational};

use super::desk::{Given, pairs_of};
use super::numbers::{absorbs, agreement, as_decimal, as_fraction, curves, holds_at, ratio};
use super::question::{Asked, Rests, tested, vanishes};
use super::slips::{Alteration, Slip, bare, simplified, size, slips, symbols};
use super::{LintPicture, LintWitness};
use paper::squeezed;

/// The counted work of reading an altered relation.
const OF_A_SLIP: u64 = 400_000;
/// Slips that are tried of one side.
const MOST_SLIPS: usize = 260;
/// Relative difference of two sides that rounding may make.
const ROUNDED: f64 = 0.02;
/// Relative error of a difference of decimals.
const SAME: f64 = 1e-9;
/// Fewest nodes of a side whose slip is told.
const FEWEST_NODES: usize = 5;

/// The same of a step between numbers.
const LEAST_OF_NUMBERS: usize = 2;

/// Fewest nodes of a side with one name for another: where the name stands on the other side of a chain, and else.
const LEAST_EXCHANGED: (usize, usize) = (6, 9);

/// Letters that stand for any constant: from one line to the next they may stand for another one.
const ANY_CONSTANT: &[&str] = &["C", "K", "A", "B", "D", "N", "c", "k", r"\mathcal{N}", r"\mathcal{C}", r"\tilde{C}"];

/// Nodes of an earlier side of a chain that is simplified to a power, or a product, of one name.
const LONG_BEFORE_SHORT: usize = 9;

/// Numbers by which a side may have been multiplied wrongly, beside 2: as they are printed.
const FACTORS: &[(&str, f64)] = &[
    (r"\pi", std::f64::consts::PI),
    (r"2\pi", 2.0 * std::f64::consts::PI),
    (r"4\pi", 4.0 * std::f64::consts::PI),
    (r"\frac{1}{\pi}", 1.0 / std::f64::consts::PI),
    (r"\frac{1}{2\pi}", 0.5 / std::f64::consts::PI),
    (r"\frac{1}{4\pi}", 0.25 / std::f64::consts::PI),
    (r"\sqrt{2}", std::f64::consts::SQRT_2),
    (r"\frac{1}{\sqrt{2}}", std::f64::consts::FRAC_1_SQRT_2),
    ("3", 3.0),
    (r"\frac{1}{3}", 1.0 / 3.0),
    ("4", 4.0),
    (r"\frac{1}{4}", 0.25),
    (r"\frac{2}{3}", 2.0 / 3.0),
    (r"\frac{3}{2}", 1.5),
    (r"\frac{1}{6}", 1.0 / 6.0),
    ("6", 6.0),
    ("8", 8.0),
    (r"\frac{1}{8}", 0.125),
];

/// A step that is wrong.
pub struct WrongStep {
    /// A point at which it fails.
    pub witness: LintWitness,
    /// The later side as it should be, or the whole relation.
    pub instead: String,
    /// Both sides along a name.
    pub picture: Option<LintPicture>,
    /// The relations that it contradicts.
    pub with: Vec<usize>,
    /// Whether it is the earlier side that is altered.
    pub is_of_earlier: bool,
    /// Whether the later side is the earlier one with a slip.
    pub is_copy: bool,
}

/// How sure it is that a relation claims something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sureness {
    /// It stands there: it may be an equation that is assumed.
    Stands,
    /// It is a step of a chain: a name may be one side, and a term may have been lost.
    Chain,
    /// Its sentence concludes: so may the first side, which was defined before.
    Concludes,
    /// It is solved for a name of the equation before it.
    Solves,
    /// It says what the derivative is of what was defined: its constants are those of the definition.
    Derives,
}

/// The nearest formula that holds, where a step is refuted.
pub fn nearest(asked: Asked, rests: &Rests, free: &BTreeSet<char>, sureness: Sureness) -> Option<WrongStep> {
    let Identity::Refuted(refutation) = &asked.identity else { return None };
    if asked.desk.is_complex && !rests.stated.is_empty() || !free.is_empty() {
        return None;
    }
    // A number that was rounded.
    let (left, right) = (refutation.left.decimal, refutation.right.decimal);
    // Unknown functions, and what they depend on, are no numbers either.
    let is_of_numbers = asked.desk.scalars.is_empty() && refutation.point.values.is_empty();
    if is_of_numbers && last_place(&asked.text).is_some_and(|unit| (left - right).abs() < unit * (1.0 - SAME)) {
        return None;
    }
    if (left - right).abs() < ROUNDED * left.abs().max(right.abs())
        && asked.text.chars().filter(char::is_ascii_digit).count() > 2
    {
        return None;
    }
    // Of fractions the sum is told.
    let has_fraction = asked.text.contains(['/']) || asked.text.contains(r"\frac");
    let is_told = has_fraction && asked.equations.len() == 1 && !asked.text.contains('.');
    let value = refutation.left.exact.as_ref().filter(|_| is_told);
    let reckoned = value.map(|value| as_fraction(&value.to_string()));
    let refutation_value = refutation.left.exact.as_ref().map(ToString::to_string);
    let printed = asked.text.clone();
    let has_decimals = asked.equations.len() == 1 && asked.text.contains('.');
    let witness = witness(&asked.desk.graph, refutation);
    let picture = drawn(&asked, &refutation.point);
    let points: Vec<Point> =
        std::iter::once(&refutation.point).chain(refutation.second.as_ref().map(|s| &s.0)).cloned().collect();
    let mut chains = latex::parse(&asked.text, &asked.desk.scope).ok()?;
    let chain = chains.pop().filter(|c| chains.is_empty() && c.sides.len() == 2)?;
    if !is_claim(&asked, rests, &chain, sureness)? {
        return None;
    }
    let all = named(&chain.sides);
    let is_copy = is_copy(&chain);
    let mut search = Search { asked, rests, chain, points, sureness };
    let (mut instead, mut is_of_earlier) = (None, false);
    'sides: for k in [1, 0] {
        let others = slips(&search.chain.sides[k], &all);
        let is_meant = |s: &Slip| match s.way {
            Alteration::LostTerm => k == 1,
            Alteration::Inverse => k == 1 && sureness == Sureness::Solves,
            Alteration::MissingTerm => k == 1 && sureness >= Sureness::Chain,
            _ => true,
        };
        for slip in others.into_iter().filter(is_meant).take(MOST_SLIPS) {
            instead = search.holds(k, &slip);
            if instead.is_some() {
                is_of_earlier = k == 0;
                break 'sides;
            }
        }
    }
    let instead = instead.or_else(|| search.scaled());
    let instead = instead.or_else(|| reckoned.filter(|_| is_of_numbers && sureness >= Sureness::Chain))?;
    // Of decimals the value is told, not which of them could have a factor.
    let is_factor =
        |text: &str| is_of_numbers && has_decimals && text.contains(r"\cdot") && !printed.contains(r"\cdot");
    let decimal = refutation_value.and_then(|value| as_decimal(&value)).filter(|_| is_factor(&instead));
    let instead = decimal.unwrap_or(instead);
    let mut with: Vec<usize> = rests.given.iter().map(|g| g.relation).collect();
    with.extend(rests.stated.iter().map(|s| s.relation));
    Some(WrongStep { witness, instead, picture, with, is_of_earlier, is_copy })
}

/// Whether the later side is the earlier one but for a sign, number, exponent or function, as they are printed.
fn is_copy(chain: &Chain) -> bool {
    let [before, now] = chain.sides.as_slice() else { return false };
    let wanted = spelled(chain, &bare(before));
    slips(now, &[]).iter().any(|s| s.way == Alteration::Value && spelled(chain, &bare(&s.side)) == wanted)
}

/// Whether a refuted relation claims something, by its print: it is long enough, no number that was rounded or put in, nothing that a
/// constant takes in, no equation for a name. `None` where it has no sides.
fn is_claim(asked: &Asked, rests: &Rests, chain: &Chain, sureness: Sureness) -> Option<bool> {
    // What is said to be conserved, and is not.
    let conserves = matches!(chain.sides.first()?.kind, NodeKind::Derivative { .. })
        && !asked.premises.equations.is_empty()
        && chain.sides.last().is_some_and(|s| matches!(&s.kind, NodeKind::Number(n) if *n == Rational::ZERO));
    let smallest = if conserves { size(&chain.sides[0]) } else { chain.sides.iter().map(written).min()? };
    let is_solved = matches!(sureness, Sureness::Concludes | Sureness::Solves) && !rests.stated.is_empty();
    let is_derivation = derives_formula(chain, asked) && !rests.are_some();
    let least = if is_derivation || is_solved || sureness >= Sureness::Chain && !rests.given.is_empty() {
        1
    } else if sureness == Sureness::Chain && chain.sides.first().is_some_and(|s| size(s) >= LONG_BEFORE_SHORT) {
        2
    } else {
        3
    };
    let fewest = match sureness {
        _ if is_derivation || is_solved => FEWEST_NODES - 2,
        Sureness::Derives | Sureness::Solves | Sureness::Chain => FEWEST_NODES - 2,
        Sureness::Concludes => FEWEST_NODES - 1,
        Sureness::Stands => FEWEST_NODES,
    };
    // In a chain, numbers alone are reckoned with: what they stand for does not matter.
    let is_reckoned = chain.sides.iter().any(|s| !is_written_number(s));
    let is_of_numbers = sureness >= Sureness::Chain && named(&chain.sides).is_empty();
    if is_of_numbers && !is_reckoned {
        return Some(false);
    }
    let (fewest, least) = if is_of_numbers { (LEAST_OF_NUMBERS, 1) } else { (fewest, least) };
    if chain.sides.iter().map(size).max()? < fewest || smallest < least {
        return Some(false);
    }
    let is_constant = |key: &str| {
        ANY_CONSTANT.contains(&key.split('_').next().unwrap_or_default())
            && !matches!(key, "c" | "k" | "N" | "A" | "B" | "D")
    };
    let open =
        asked.desk.scalars.iter().any(|(key, _, is_parameter)| {
            *is_parameter && is_constant(key) && !rests.given.iter().any(|g| g.key == *key)
        });
    // From one line to the next a constant of integration stands for another one.
    if !rests.stated.is_empty() && open {
        return Some(false);
    }
    if sureness < Sureness::Derives && takes_in(asked, &rests.given)
        || !conserves && is_evaluated(chain)
        || is_reordered(chain)
    {
        return Some(false);
    }
    Some(true)
}

/// The size of a side as it is printed: the power of a function, `\sin^2x`, is a part of it.
fn written(side: &Node) -> usize {
    let has_power = matches!(&side.kind, NodeKind::Function(_, Some(_), _));
    size(side) + usize::from(has_power)
}

/// Whether two sides that differ are one sign, number, exponent or function apart, as they are printed.
pub fn is_slip_of(asked: &Asked) -> bool {
    let Ok(chains) = latex::parse(&asked.text, &asked.desk.scope) else { return false };
    let [chain] = chains.as_slice() else { return false };
    let [before, now] = chain.sides.as_slice() else { return false };
    if !matches!(asked.identity, Identity::Refuted(_)) || size(before).min(size(now)) < FEWEST_NODES {
        return false;
    }
    is_copy(chain)
}

/// The unit of the last place of the number with the fewest of them, where there are decimals: 0.01 of `2/45=0.04`, 1 of `2.5+1.3=4`.
fn last_place(text: &str) -> Option<f64> {
    let digits = |rest: &str| rest.chars().take_while(char::is_ascii_digit).count();
    let places = text.match_indices('.').map(|(at, _)| digits(&text[at + 1..])).filter(|n| *n > 0).min()?;
    let is_whole = text.rsplit('=').next().is_some_and(|right| !right.contains('.'));
    let places = if is_whole { 0 } else { places };
    Some((0..places.min(18)).fold(1.0, |unit, _| unit / 10.0))
}

struct Search<'a> {
    asked: Asked,
    rests: &'a Rests,
    chain: Chain,
    /// Points at which what is given holds.
    points: Vec<Point>,
    sureness: Sureness,
}

impl Search<'_> {
    /// The altered relation as LaTeX, if it is proved and says something.
    fn holds(&mut self, k: usize, slip: &Slip) -> Option<String> {
        let chain = &self.chain;
        let mut altered = chain.clone();
        altered.sides[k] = slip.side.clone();
        let (new, other) = (spelled(chain, &altered.sides[k]), spelled(chain, &altered.sides[1 - k]));
        // What becomes the other side, or what is given letter by letter, is no slip of it.
        let same = |side: &PrintedSide| squeezed(&side.text) == squeezed(&new);
        let [one, two] = [k, 1 - k].map(|side| spelled(chain, &bare(&altered.sides[side])));
        if one == two
            || prints_the_same(&one, &two)
            || self.rests.given.iter().any(|g| same(&g.right))
            || self.rests.stated.iter().any(|s| same(&s.left) || same(&s.right))
        {
            return None;
        }
        // What is derived and stands nowhere else is unknown: a derivative of it is an equation for it.
        // And an exponent is no factor.
        if matches!(slip.way, Alteration::LostFactor | Alteration::LostTerm)
            && (has_derivative(&chain.sides[k]) || is_power_of_name(&chain.sides[k]))
            && loses_a_name(chain, &altered)
        {
            return None;
        }
        // `t_A-t_A` is no formula of anybody.
        if cancels(&altered.sides[k]) && !cancels(&chain.sides[k]) {
            return None;
        }
        // Beside a lone name, or a number, anything could be meant.
        let is_simplified = self.sureness == Sureness::Chain
            && k == 1
            && !self.rests.are_some()
            && size(&chain.sides[0]) >= LONG_BEFORE_SHORT;
        let plain = |n: &Node| match &n.kind {
            // A long side that becomes a power of a name.
            NodeKind::Symbol(s) => s.sup.is_none() || !is_simplified,
            NodeKind::Number(_) => true,
            _ => false,
        };
        let is_of_numbers = self.sureness >= Sureness::Chain && k == 1 && named(&chain.sides).is_empty();
        if !is_of_numbers && (plain(&altered.sides[k]) || plain(&chain.sides[k])) {
            return None;
        }
        // With definitions, another name, or one more or fewer, may be another definition; in a chain, a name that stands on the other side is
        // the one that was meant.
        let is_named_beside = |by: &str| {
            // An unknown function, or a rate, is what such an equation is for.
            let is_plain = |s: &SymbolNode| s.arguments.is_none() && s.dots == 0 && !s.name.ends_with('\'');
            named(std::slice::from_ref(&chain.sides[1 - k]))
                .iter()
                .any(|s| is_plain(s) && format!("{}{:?}", s.name, s.sub) == by)
        };
        let is_exchange = self.sureness >= Sureness::Chain
            && matches!(&slip.way, Alteration::Exchange { by, .. } if k == 1 && is_named_beside(by));
        let least = if is_exchange { LEAST_EXCHANGED.0 } else { LEAST_EXCHANGED.1 };
        if let Alteration::Exchange { of, by } = &slip.way
            && (of == by || size(&chain.sides[k]) < least)
        {
            return None;
        }
        if self.rests.are_some() && !matches!(slip.way, Alteration::Value | Alteration::Inverse) && !is_exchange {
            return None;
        }
        self.proved(&altered)?;
        let chain = &self.chain;
        let told = spelled(chain, &simplified(&altered.sides[k]));
        Some(if k == 1 { told } else { format!("{told} = {other}") })
    }

    fn proved(&mut self, altered: &Chain) -> Option<()> {
        let desk = &mut self.asked.desk;
        // Reading it, and a look at some points; what a proof takes is counted beside.
        meter::piece(Task::Step, &desk.limits, || meter::charge(OF_A_SLIP)).ok()?;
        let statement = latex::elaborate(altered, &desk.scope, &mut desk.graph).ok()?;
        let equations = pairs_of(&statement);
        let premises = &self.asked.premises;
        // A look at three points spares most proofs.
        if premises.equations.is_empty() && agreement(&desk.graph, &equations, 6).is_some_and(|(_, agree)| !agree) {
            return None;
        }
        // What is given holds at the points that refute the step, so what follows does, too.
        if self.points.iter().any(|p| holds_at(&desk.graph, &equations, p) == Some(false)) {
            return None;
        }
        let found = tested(desk, &equations, premises, Wanted::Proof);
        if !matches!(found, Ok(Identity::Proved(_))) {
            return None;
        }
        // Premises that make both sides zero prove it with any factor.
        let is_zero = |side: &Node| matches!(&side.kind, NodeKind::Number(n) if *n == Rational::ZERO);
        let is_vacuous =
            self.rests.are_some() && !altered.sides.iter().any(is_zero) && vanishes(desk, &equations, premises);
        (!is_vacuous).then_some(())
    }

    /// The later side times a number, where that is proved.
    fn scaled(&mut self) -> Option<String> {
        let [equation] = self.asked.equations.as_slice() else { return None };
        let measured = match self.asked.premises.equations.is_empty() {
            true => Some(ratio(&self.asked.desk.graph, *equation)?),
            false => None,
        };
        let (left, right) = (spelled(&self.chain, &self.chain.sides[0]), spelled(&self.chain, &self.chain.sides[1]));
        for (text, factor) in FACTORS {
            for (sign, signed) in [("", *factor), ("-", -factor)] {
                if measured.is_some_and(|m| (m - signed).abs() > 1e-9 * signed.abs()) {
                    continue;
                }
                let instead = format!(r"{sign}{text}\cdot\left({right}\right)");
                let mut chains = latex::parse(&format!("{left} = {instead}"), &self.asked.desk.scope).ok()?;
                let altered = chains.pop()?;
                if self.proved(&altered).is_some() {
                    return Some(instead);
                }
            }
        }
        None
    }
}

/// Whether two sides have the same signs in print, in whatever order, but for a plus before everything and an exponent that is one: nobody
/// states that.
fn prints_the_same(one: &str, other: &str) -> bool {
    let plain = |text: &str| {
        let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        let text = text.replace("{+", "{").replace("(+", "(").replace("^{1}", "");
        let mut out: Vec<char> = text.chars().filter(|c| !matches!(c, '{' | '}')).collect();
        out.sort_unstable();
        out
    };
    plain(one) == plain(other)
}

/// The symbols of some sides, each once.
fn named(sides: &[Node]) -> Vec<SymbolNode> {
    let mut all = Vec::new();
    sides.iter().for_each(|side| symbols(side, &mut all));
    all
}

/// Whether the earlier side is the derivative of a formula that shows its variable, with nothing unknown in it: what it is is no choice.
fn derives_formula(chain: &Chain, asked: &Asked) -> bool {
    let Some(Node { kind: NodeKind::Derivative { of, by, .. }, .. }) = chain.sides.first() else { return false };
    let names = named(std::slice::from_ref(of));
    let variables = named(std::slice::from_ref(by));
    let shows = names.iter().any(|s| variables.iter().any(|v| v.name == s.name));
    let is_plain = |s: &SymbolNode| s.arguments.is_none() && s.dots == 0 && !s.name.ends_with('\'');
    shows && size(of) > 1 && names.iter().all(is_plain) && asked.desk.moving.is_empty()
}

/// Whether something is derived.
fn has_derivative(node: &Node) -> bool {
    matches!(node.kind, NodeKind::Derivative { .. } | NodeKind::Partial { .. })
        || node.children().into_iter().any(has_derivative)
}

/// Whether a side as a whole is raised to a power with names in it.
fn is_power_of_name(side: &Node) -> bool {
    let above = match &side.kind {
        NodeKind::Scripted { sup, .. } => sup,
        NodeKind::Symbol(s) => &s.sup,
        _ => return false,
    };
    above.as_deref().is_some_and(|sup| !named(std::slice::from_ref(sup)).is_empty())
}

/// Whether a name of a relation does not stand in an altered one.
fn loses_a_name(printed: &Chain, altered: &Chain) -> bool {
    let [before, now] = [printed, altered].map(|chain| named(&chain.sides));
    before.iter().any(|s| !now.iter().any(|n| (&n.name, &n.sub) == (&s.name, &s.sub)))
}

/// Whether a sum has a term and its negative.
fn cancels(node: &Node) -> bool {
    let terms: &[(latex::syntax::Sign, Node)] = match &node.kind {
        NodeKind::Sum(terms) => terms,
        _ => &[],
    };
    let text = |n: &Node| {
        let mut out = Vec::new();
        sequence_of(n, &mut out);
        (size(n), out)
    };
    let pair = terms.iter().enumerate().any(|(i, (sign, a))| {
        terms[i + 1..]
            .iter()
            .any(|(other, b)| sign != other && text(a) == text(b) && matches!(a.kind, NodeKind::Symbol(_)))
    });
    pair || node.children().into_iter().any(cancels)
}

/// Both sides along the first name in which they differ, where nothing else is fixed by it.
fn drawn(asked: &Asked, point: &Point) -> Option<LintPicture> {
    let [equation] = asked.equations.as_slice() else { return None };
    if !asked.premises.equations.is_empty() {
        return None;
    }
    let at: Vec<(Leaf, f64)> = point.values.iter().map(|(leaf, v)| (*leaf, v.decimal)).collect();
    at.iter().find_map(|(leaf, _)| {
        let points = curves(&asked.desk.graph, *equation, &at, *leaf)?;
        Some(LintPicture { name: asked.desk.graph.leaf_latex(*leaf), points })
    })
}

/// Whether a side is a number as it is written, with its sign: `-4=5` is said modulo something.
fn is_written_number(side: &Node) -> bool {
    match &side.kind {
        NodeKind::Number(_) => true,
        NodeKind::Sum(terms) => matches!(terms.as_slice(), [(_, one)] if is_written_number(one)),
        NodeKind::Group(inner, _) => is_written_number(inner),
        _ => false,
    }
}

/// Whether the later side is a number: it may be the value for values that words give.
fn is_evaluated(chain: &Chain) -> bool {
    let [earlier, later] = [0, 1].map(|k| named(std::slice::from_ref(&chain.sides[k])));
    later.is_empty() && !earlier.is_empty()
}

/// Whether both sides are products of the same factors in another order: their order may count.
fn is_reordered(chain: &Chain) -> bool {
    let sequence = |side: &Node| {
        let mut out = Vec::new();
        factors_of(side, &mut out);
        out
    };
    let [a, b] = chain.sides.as_slice() else { return false };
    let is_product = |n: &Node| match &n.kind {
        NodeKind::Sum(terms) => terms.len() == 1,
        _ => !has_derivative(n),
    };
    let (first, second) = (sequence(a), sequence(b));
    let mut sorted = (first.clone(), second.clone());
    sorted.0.sort();
    sorted.1.sort();
    is_product(a) && is_product(b) && first.len() > 1 && first != second && sorted.0 == sorted.1
}

/// The names of a side in their order, with their powers. What a function takes is a number, and so is what it gives: its place in a product
/// counts for nothing.
fn factors_of(side: &Node, out: &mut Vec<String>) {
    match &side.kind {
        NodeKind::Symbol(s) => out.push(format!("{}{:?}^{:?}", s.name, s.sub, s.sup.as_ref().map(|n| &n.kind))),
        NodeKind::Function(..) | NodeKind::Number(_) => {}
        _ => side.children().into_iter().for_each(|c| factors_of(c, out)),
    }
}

/// The names of a side in their order.
fn sequence_of(side: &Node, out: &mut Vec<String>) {
    if let NodeKind::Symbol(s) = &side.kind {
        out.push(format!("{}{:?}", s.name, s.sub));
    }
    side.children().into_iter().for_each(|c| sequence_of(c, out));
}

/// A side as LaTeX.
fn spelled(chain: &Chain, side: &Node) -> String {
    to_latex(&Chain { sides: vec![side.clone()], relations: Vec::new(), ..chain.clone() })
}

/// Whether a letter that stands for any constant could take in the difference.
fn takes_in(asked: &Asked, given: &[Given]) -> bool {
    let [equation] = asked.equations.as_slice() else { return false };
    let constants = asked.desk.scalars.iter().filter(|(key, _, is_parameter)| {
        let (letter, below) = key.split_once('_').unwrap_or((key.as_str(), ""));
        let numbered = below.trim_matches(['{', '}']).chars().all(|c| c.is_ascii_digit());
        *is_parameter
            && numbered
            && ANY_CONSTANT.contains(&letter)
            && (letter != "c" && letter != "k" || !below.is_empty())
            // What a definition is made of is no constant of integration.
            && !given.iter().any(|g| g.key == *key || names(&g.right).iter().any(|n| n.key() == *key))
    });
    let leaves: Vec<Leaf> = constants.map(|(_, symbol, _)| Leaf::now(*symbol, 0)).collect();
    // Several of them could each take in something.
    leaves.len() > 1 || leaves.into_iter().any(|leaf| absorbs(&asked.desk.graph, *equation, leaf))
}

/// Whether the later side has no name that neither the earlier side nor what is given has: what relates a new one is not known here.
pub fn introduces_nothing(sides: [&PrintedSide; 2], rests: &Rests) -> bool {
    let mut known: BTreeSet<String> = names(sides[0]).iter().map(|n| n.key()).collect();
    let given = rests.given.iter().flat_map(|g| [&g.left, &g.right]);
    for side in given.chain(rests.stated.iter().flat_map(|s| [&s.left, &s.right])) {
        known.extend(names(side).iter().map(|n| n.key()));
    }
    names(sides[1]).iter().all(|n| known.contains(&n.key()))
}

fn witness(graph: &Graph, refutation: &Refutation) -> LintWitness {
    let [named, _] = refutation.parted(&refutation.point);
    let value = |v: &proof::PointValue| match &v.exact {
        Some(exact) => exact.to_string(),
        None => format!("{:.6}", v.decimal),
    };
    LintWitness {
        values: named.iter().map(|(leaf, v)| (graph.leaf_latex(*leaf), value(v))).collect(),
        left: refutation.left.decimal,
        right: refutation.right.decimal,
    }
}
