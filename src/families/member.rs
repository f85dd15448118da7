//! Members of a family, from their numbers.
//!
//! **In:** a family, and the number of a member. **Out:** its values, or that no such motion is wanted; and how many were rejected on
//! the way.
//!
//! **Guaranteed:** the number, the family and its seed determine the member, on every machine: `draw` says how. What is computed has
//! at most 15 digits, so that its text in a file is short, and is the same number.

use std::cell::OnceCell;
use std::cmp::Ordering;

use super::draw::{Random, Sequence, exp, ln, normal_at, polar_at, random_normal};
use super::map::Scale;
use diag::Diagnostic;
use expr::tape::Tape;
use proof::exact::Exact;

use crate::derivation::{Claim, Dependence, Derivation, Drawing, Family, Form, Spread, Varied, exact};
use crate::expr::{Expr, Leaf, Rational};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue, Number};

/// The most draws for one member: with a constraint that leaves one in a thousand, one member in 20,000 would need more.
pub(super) const MOST_DRAWS: u64 = 10_000;

/// A family, ready to give its members.
pub(super) struct Members {
    pub family: Family,
    /// The numbers that each spread is given by.
    pub(super) numbers: Vec<Vec<f64>>,
    /// The points of a sequence that the draws are; nothing where they are random.
    sequence: Option<Sequence>,
    /// The links of the constraints: kinds of relations; their sides are the first outputs of the tape, in pairs.
    kinds: Vec<RelationKind>,
    /// The sides, then what must be positive; nothing where members need satisfy nothing.
    tape: Option<Tape>,
}

/// A scaling law along something that varies.
pub(super) struct Law {
    /// Its position among what varies.
    pub varied: usize,
    pub scale: Scale,
    /// The power that is claimed.
    pub power: f64,
    /// How far it may be off.
    pub to: f64,
}

/// What a number gives.
#[derive(Clone, Debug)]
pub(super) enum Member {
    /// A member with these values, after so many draws were rejected.
    Found(Vec<f64>, u64),
    /// A point of a grid, or of a sequence, that does not satisfy the constraints.
    Rejected,
    /// So many draws did not satisfy them that the search was ended.
    TooRare,
}

/// The counted work of a draw that is looked at.
const OF_A_DRAW: u64 = 500;

impl Members {
    /// Prepares a family.
    ///
    /// # Errors
    /// What is wrong with its numbers, where only their values show it.
    pub fn new(derivation: &Derivation, family: &Family) -> Result<Members, Vec<Diagnostic>> {
        let graph = &derivation.graph;
        let mut problems = Vec::new();
        let mut numbers = Vec::new();
        for varied in &family.vary {
            let exprs = varied.spread.numbers();
            let values = evaluated(derivation, &exprs);
            let place = varied.span.clone();
            if values.iter().any(Option::is_none) {
                let message = format!("the values of `{}` are no real numbers", varied.name);
                problems.push(Diagnostic::at(&derivation.file, "derivation::bad-range", place, message));
                continue;
            }
            let number = |e: Expr| exprs.iter().zip(&values).find(|(x, _)| **x == e).and_then(|(_, v)| *v);
            if let Some((code, message, hint)) = varied.spread.fault(&varied.name, varied.positive, &number) {
                problems.push(Diagnostic::at(&derivation.file, code, place, message).hint(hint));
            }
            numbers.push(values.into_iter().flatten().collect());
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        let links = || family.constraints.iter().flat_map(|c| &c.links);
        let positive = |symbol| derivation.symbols.iter().any(|s| s.symbol == symbol && s.positive);
        let mut roots: Vec<Expr> = links().flat_map(|(_, left, right)| [*left, *right]).collect();
        roots.extend(family.positive(graph, positive));
        let leaves: Vec<Leaf> = family.vary.iter().map(|v| v.leaf).collect();
        let tape = if roots.is_empty() { None } else { Tape::compile(graph, &leaves, &roots).ok() };
        let kinds = links().map(|(kind, ..)| *kind).collect();
        let drawn = family.vary.iter().filter(|v| v.spread.is_drawn()).count();
        let sequence = (family.sequence == Drawing::LowDiscrepancy).then(|| Sequence::new(drawn, family.seed));
        Ok(Members { family: family.clone(), numbers, sequence, kinds, tape })
    }

    /// The two scales of the map, if it has one: across, and up.
    pub fn scales(&self) -> Option<[Scale; 2]> {
        let [across, up] = self.family.map?;
        Some([self.scale(across)?, self.scale(up)?])
    }

    /// The scale of something that varies.
    pub fn scale(&self, varied: usize) -> Option<Scale> {
        let (of, numbers) = (self.family.vary.get(varied)?, self.numbers.get(varied)?);
        let at = |position: u64| match &of.spread {
            Spread::Grid { count, logarithmic, .. } => {
                on_grid((numbers[0], numbers[1]), (position, *count), *logarithmic)
            }
            Spread::Values(_)
            | Spread::Uniform(..)
            | Spread::LogUniform(..)
            | Spread::Polar(..)
            | Spread::Normal(..) => f64::NAN,
        };
        Some(Scale::new(&of.name, &of.spread, numbers, &at))
    }

    /// The cell of a scale in which a member lies.
    pub fn place(&self, scale: &Scale, varied: usize, number: u64, values: &[f64]) -> Option<usize> {
        Some(scale.place(*self.positions(number).get(varied)?, *values.get(varied)?))
    }

    /// The scaling law that a claim is, along something that varies here.
    pub fn law(&self, claim: &Claim) -> Option<Law> {
        let Some(Form::Across(across)) = claim.forms.first() else { return None };
        let Dependence::Power { power, to } = across.dependence else { return None };
        let varied = self.family.vary.iter().position(|v| v.leaf == across.with)?;
        Some(Law { varied, scale: self.scale(varied)?, power, to })
    }

    /// The cell of the map in which a member lies.
    pub fn cell(&self, scales: &[Scale; 2], number: u64, values: &[f64]) -> Option<usize> {
        let [across, up] = self.family.map?;
        let place = |scale: &Scale, n: usize| self.place(scale, n, number, values);
        Some(place(&scales[1], up)? * scales[0].axis.cells.len() + place(&scales[0], across)?)
    }

    /// The member with a number, the first of which is 1.
    pub fn member(&self, number: u64) -> Member {
        let again = self.family.is_drawn_again();
        for attempt in 0..if again { MOST_DRAWS } else { 1 } {
            let values = self.values(number, attempt);
            meter::charge(OF_A_DRAW);
            if values.iter().all(|x| x.is_finite()) && self.is_wanted(&values) {
                return Member::Found(values, attempt);
            }
        }
        if again { Member::TooRare } else { Member::Rejected }
    }

    /// What would be the member at a point of the map, of a family with nothing else that varies.
    pub fn at(&self, [x, y]: [f64; 2]) -> Member {
        let Some([across, up]) = self.family.map else { return Member::Rejected };
        let value = |(n, numbers): (usize, &Vec<f64>)| match n {
            n if n == across => x,
            n if n == up => y,
            _ => numbers.first().copied().unwrap_or(f64::NAN),
        };
        let values: Vec<f64> = self.numbers.iter().enumerate().map(value).collect();
        let is_member = values.iter().all(|x| x.is_finite()) && self.is_wanted(&values);
        if is_member { Member::Found(values, 0) } else { Member::Rejected }
    }

    /// A motion that is no member: its values lie between those of rows and lists, and are drawn as others are. The number determines it.
    /// `None` where none is found that satisfies the constraints, or where nothing but what is a member could be.
    pub fn fresh(&self, number: u64) -> Option<Vec<f64>> {
        let varies = |(n, _): (usize, &Varied)| {
            let (least, greatest) = self.range(n);
            least < greatest
        };
        if !self.family.vary.iter().enumerate().any(varies) {
            return None;
        }
        let one = |attempt: u64, (n, varied): (usize, &Varied)| {
            let mut random = Random::new(self.family.seed, number, attempt, n as u64);
            let (numbers, ends) = (&self.numbers[n], self.range(n));
            match &varied.spread {
                Spread::Values(_) | Spread::Grid { logarithmic: false, .. } | Spread::Uniform(..) => {
                    at_share(random.share(), ends, false)
                }
                Spread::Grid { logarithmic: true, .. } | Spread::LogUniform(..) => at_share(random.share(), ends, true),
                Spread::Polar(..) => short(polar_at(random.share(), ends), ends),
                Spread::Normal(..) => short(numbers[0] + numbers[1] * random_normal(&mut random), (f64::MIN, f64::MAX)),
            }
        };
        let each = |attempt| self.family.vary.iter().enumerate().map(|of| one(attempt, of)).collect::<Vec<f64>>();
        let wanted = |values: &Vec<f64>| values.iter().all(|x| x.is_finite()) && self.is_wanted(values);
        (0..MOST_DRAWS).map(each).find(wanted)
    }

    /// Where the values of a number stand in their rows.
    pub(super) fn positions(&self, number: u64) -> Vec<u64> {
        // The last of the symbols changes fastest; draws of one point of the grid follow one another.
        let mut point = (number - 1) / self.family.draws;
        let mut positions = vec![0; self.family.vary.len()];
        for (position, varied) in positions.iter_mut().zip(&self.family.vary).rev() {
            let count = varied.spread.points();
            (*position, point) = (point % count, point / count);
        }
        positions
    }

    /// The values of a number at an attempt to draw them. The first attempt is the point of the sequence, where there is one.
    pub(super) fn values(&self, number: u64, attempt: u64) -> Vec<f64> {
        let positions = self.positions(number);
        let sequence = self.sequence.as_ref().filter(|_| attempt == 0);
        let mut drawn = 0;
        let one = |(n, (varied, position)): (usize, (&Varied, u64))| {
            let numbers = &self.numbers[n];
            let mut random = Random::new(self.family.seed, number, attempt, n as u64);
            // One share for each symbol that is drawn.
            let mut share = || match sequence {
                Some(sequence) => {
                    drawn += 1;
                    sequence.share(drawn - 1, number)
                }
                None => random.share(),
            };
            match &varied.spread {
                Spread::Values(_) => numbers.get(position as usize).copied().unwrap_or(f64::NAN),
                Spread::Grid { count, logarithmic, .. } => {
                    on_grid((numbers[0], numbers[1]), (position, *count), *logarithmic)
                }
                Spread::Uniform(..) => at_share(share(), (numbers[0], numbers[1]), false),
                Spread::LogUniform(..) => at_share(share(), (numbers[0], numbers[1]), true),
                Spread::Polar(..) => {
                    let ends = (numbers[0], numbers[1]);
                    short(polar_at(share(), ends), ends)
                }
                Spread::Normal(..) => {
                    let standard = if sequence.is_some() { normal_at(share()) } else { random_normal(&mut random) };
                    short(numbers[0] + numbers[1] * standard, (f64::MIN, f64::MAX))
                }
            }
        };
        self.family.vary.iter().zip(positions).enumerate().map(one).collect()
    }

    /// The least and the greatest value of a symbol that varies.
    pub fn range(&self, varied: usize) -> (f64, f64) {
        match &self.family.vary[varied].spread {
            Spread::Normal(..) => (f64::NEG_INFINITY, f64::INFINITY),
            Spread::Values(_)
            | Spread::Grid { .. }
            | Spread::Uniform(..)
            | Spread::LogUniform(..)
            | Spread::Polar(..) => {
                let of = self.numbers[varied].iter().copied();
                of.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
            }
        }
    }

    /// Whether values satisfy the constraints, and are positive where they must be. What has no value satisfies nothing.
    pub(super) fn is_wanted(&self, values: &[f64]) -> bool {
        let positive = |(varied, x): (&Varied, &f64)| !varied.positive || *x > 0.0;
        if !self.family.vary.iter().zip(values).all(positive) {
            return false;
        }
        let Some(tape) = &self.tape else { return true };
        // A value is what its decimal digits say.
        let decimal: Vec<Option<Rational>> = values.iter().map(|x| exact(&format!("{x:e}"))).collect();
        let rounded = |x: &Option<Rational>| {
            let mut out = Bounded::exact(0.0);
            Number::rational(&mut out, &(), x.as_ref().ok_or(NoValue::Unsupported)?).map(|()| out)
        };
        let inputs: Vec<_> = decimal.iter().map(rounded).collect();
        let found = tape.determined(&inputs);
        let rational = OnceCell::new();
        let rational = |side: usize| {
            let all = rational.get_or_init(|| {
                let inputs: Vec<_> = decimal.iter().map(|x| x.clone().map(Exact).ok_or(NoValue::Unsupported)).collect();
                tape.evaluate(&(), &inputs, &mut tape.slots::<Exact>(&()))
            });
            all.get(side)?.as_ref().ok()
        };
        let order = |side: usize| {
            let (Ok(left), Ok(right)) = (found.get(side)?, found.get(side + 1)?) else { return None };
            let difference = *left - *right;
            // What rational arithmetic cannot tell, and errors neither, is the same.
            Some(match difference.contains_zero() {
                true => rational(side).zip(rational(side + 1)).map_or(Ordering::Equal, |(l, r)| l.0.cmp(&r.0)),
                false => difference.value.total_cmp(&0.0),
            })
        };
        let satisfied = |(n, kind): (usize, &RelationKind)| order(2 * n).is_some_and(|order| kind.holds(order));
        let positive = |side: usize| match found[side] {
            Ok(x) if x.contains_zero() => rational(side).is_some_and(|x| x.0 > Rational::ZERO),
            Ok(x) => x.value > 0.0,
            Err(_) => false,
        };
        let sides = (2 * self.kinds.len()).min(found.len());
        self.kinds.iter().enumerate().all(satisfied) && (sides..found.len()).all(positive)
    }
}

/// The values of expressions without leaves.
pub(super) fn evaluated(derivation: &Derivation, exprs: &[Expr]) -> Vec<Option<f64>> {
    let Ok(tape) = Tape::compile(&derivation.graph, &[], exprs) else { return vec![None; exprs.len()] };
    tape.determined(&[]).into_iter().map(|x| x.ok().map(|x| x.value)).collect()
}

/// A value of a grid; its ends are those that are given.
pub(super) fn on_grid((from, to): (f64, f64), (position, count): (u64, u64), logarithmic: bool) -> f64 {
    if position == 0 || position + 1 == count {
        return if position == 0 { from } else { to };
    }
    if logarithmic {
        return at_share(position as f64 / (count - 1) as f64, (from, to), true);
    }
    // Numbers are what their digits say, so that a row that passes 0 has it.
    let [Some(first), Some(last)] = [from, to].map(|x| exact(&format!("{x:e}"))) else { return f64::NAN };
    let step = (&last - &first) / Rational::from(count - 1);
    short((first + step * Rational::from(position)).to_f64().value(), (from, to))
}

/// What lies at a share of the way from one number to another, or from its logarithm to the other's.
fn at_share(share: f64, (from, to): (f64, f64), logarithmic: bool) -> f64 {
    let x = match logarithmic {
        true => exp((1.0 - share) * ln(from) + share * ln(to)),
        false => (1.0 - share) * from + share * to,
    };
    short(x, (from, to))
}

/// A number with 15 digits, between two others.
fn short(x: f64, (from, to): (f64, f64)) -> f64 {
    let rounded: f64 = format!("{x:.14e}").parse().unwrap_or(x);
    if rounded < from {
        from
    } else if rounded > to {
        to
    } else {
        rounded
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_has_the_ends_that_are_given_and_short_numbers_between() {
        let grid: Vec<f64> = (0..20).map(|i| on_grid((0.1, 2.0), (i, 20), false)).collect();
        assert_eq!((grid[0], grid[1], grid[2], grid[19]), (0.1, 0.2, 0.3, 2.0));
        for (from, to, count, zero) in [(-2.0, 1.0, 4, 2), (-1.4, 0.7, 4, 2), (-1.0, 2.0, 7, 2), (-0.3, 0.6, 10, 3)] {
            assert_eq!(on_grid((from, to), (zero, count), false), 0.0, "{from} … {to}");
        }
        assert_eq!(on_grid((-1000.0, 2.0), (10_001, 10_021), false), 0.1, "small beside its ends");
        let log: Vec<f64> = (0..4).map(|i| on_grid((0.001, 1.0), (i, 4), true)).collect();
        assert_eq!(log, [0.001, 0.01, 0.1, 1.0]);
        let pi = std::f64::consts::PI;
        assert!(short(pi, (0.0, pi)) <= pi);
    }
}
