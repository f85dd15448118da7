//! Variants that say the same as the print.
//!
//! **In:** the variants of a claim. **Out:** those whose residual is, wherever the symbols have the meaning that they are
//! defined to have and the equations hold that the claim assumes, a constant times that of the print or of a power of it (then
//! the two are one equation), or 0 (then it says nothing), or a constant times that of an earlier variant. A factor that is made
//! of parameters is a constant: it is the same along every motion.
//!
//! Decided at random points, see `point`. Two different analytic residuals are proportional at all of them with probability 0;
//! what is taken for proportional by rounding is so to thirteen digits.

use super::battery::{Battery, Outputs};
use super::generate::{ClaimVariants, Manner, Part, Variant};
use super::point::{self, Ground, Point, assumes_equations};
use crate::derivation::{Claim, Derivation};
use crate::expr::{FastMap, Graph};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};

/// What proportional residuals have in common: for each altered part its position and ratios of its values.
type Fingerprint = Vec<(usize, Vec<u32>)>;

/// What random points say of a variant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sight {
    /// It differs from the print, and from all before it.
    New,
    /// The same equation.
    Same,
    /// Always true.
    Empty,
    /// Another formula of the claim says it.
    Said,
    /// The same equation as an earlier variant, which is at this position.
    Repeated(usize),
}

/// Whether v = c·r with one constant c ≠ 0 at all points; c > 0 where the direction matters.
fn proportional(v: &[Bounded], r: &[Bounded], directed: bool) -> bool {
    if v.len() != r.len() {
        return false;
    }
    let Some(at) = r.iter().position(|x| !is_zero(*x)) else { return v.iter().all(|x| is_zero(*x)) };
    let (v0, r0) = (v[at], r[at]);
    !is_zero(v0) && (!directed || v0.value * r0.value > 0.0) && v.iter().zip(r).all(|(&v, &r)| is_zero(v * r0 - v0 * r))
}

fn is_zero(x: Bounded) -> bool {
    x.value.abs() <= 4.0 * x.error
}

/// A fingerprint that proportional residuals have in common.
fn fingerprint(v: &[Bounded]) -> Vec<u32> {
    let largest = v.iter().map(|x| x.value.abs()).fold(0.0, f64::max);
    let Some(first) = v.iter().find(|x| x.value.abs() >= 0.1 * largest) else { return vec![0; v.len()] };
    let ratio = |x: &Bounded| {
        let q = (x.value / first.value) as f32;
        // Eight digits are compared, so that rounding does not tell equals apart.
        if q.abs() < 1e-6 { 0 } else { q.to_bits().wrapping_add(8) >> 4 }
    };
    v.iter().map(ratio).collect()
}

impl ClaimVariants {
    /// Removes the variants that are no variants, and counts them.
    pub fn reduce(&mut self, derivation: &Derivation, claim: &Claim, graph: &mut Graph) {
        let sights = self.sights(derivation, claim, graph, true);
        let mut kept: Vec<Variant> = Vec::new();
        // Where each is among those that are kept.
        let mut places = vec![None; sights.len()];
        for (v, (variant, sight)) in std::mem::take(&mut self.variants).into_iter().zip(sights).enumerate() {
            let count = self.count(variant.class);
            match sight {
                Sight::New => {
                    places[v] = Some(kept.len());
                    kept.push(variant);
                    continue;
                }
                Sight::Same => count.equivalent += 1,
                Sight::Said => count.empty += 1,
                Sight::Empty => {
                    count.empty += 1;
                    count.kept -= 1;
                    self.empty.push(variant);
                    continue;
                }
                Sight::Repeated(first) => {
                    count.repeated += 1;
                    count.kept -= 1;
                    let first = places.get(first).copied().flatten();
                    self.alike.extend(first.and_then(|at| Some((at, variant.on_another_side(kept.get(at)?)?))));
                    continue;
                }
            }
            count.kept -= 1;
        }
        self.variants = kept;
    }

    /// What random points say of each variant. `defined`: observables are what they are defined to be, and what the claim
    /// assumes holds; otherwise they are independent, too, and only what algebra makes true is true.
    pub fn sights(&self, derivation: &Derivation, claim: &Claim, graph: &mut Graph, defined: bool) -> Vec<Sight> {
        let Some(battery) = self.battery(claim, graph) else { return vec![Sight::New; self.variants.len()] };
        let mut look = |manner| self.sights_at(derivation, claim, graph, &battery, manner);
        let mut out = look(point::Manner { defined, ..Default::default() });
        // A constant may be any function of the parameters: of it, assumptions say nothing here.
        let relation = |v: &Variant| self.formulas[v.formula].manner == Manner::Relation;
        if defined && assumes_equations(claim) && self.variants.iter().any(relation) {
            let assumed = look(point::Manner { defined: true, assumed: true });
            for ((variant, sight), assumed) in self.variants.iter().zip(&mut out).zip(assumed) {
                if *sight == Sight::New && relation(variant) {
                    *sight = assumed;
                }
            }
        }
        out
    }

    /// The same by the definitions, whatever the claim assumes.
    pub fn sights_defined(&self, derivation: &Derivation, claim: &Claim, graph: &mut Graph) -> Vec<Sight> {
        let Some(battery) = self.battery(claim, graph) else { return vec![Sight::New; self.variants.len()] };
        let manner = point::Manner { defined: true, ..Default::default() };
        self.sights_at(derivation, claim, graph, &battery, manner)
    }

    fn battery(&self, claim: &Claim, graph: &Graph) -> Option<Battery> {
        Battery::new(graph, self, 0, (0..self.variants.len()).collect(), claim.scope.branch_sign())
    }

    fn sights_at(
        &self,
        derivation: &Derivation,
        claim: &Claim,
        graph: &mut Graph,
        battery: &Battery,
        manner: point::Manner,
    ) -> Vec<Sight> {
        let ground = Ground::new(derivation, claim, graph, battery, manner);
        let free = ground.as_ref().map_or_else(Vec::new, |ground| ground.draw(false));
        // A factor made of parameters makes no difference, and a constant may be any function of them: so they stay what they are.
        let steady = ground.filter(Ground::has_parameters).map(|ground| ground.draw(true));
        let fixed = steady.as_ref().unwrap_or(&free);
        let mut seen: FastMap<(usize, Fingerprint), usize> = FastMap::default();
        (0..self.variants.len()).map(|v| self.sight(v, &free, fixed, &mut seen)).collect()
    }

    fn sight(
        &self,
        v: usize,
        free: &[Point],
        fixed: &[Point],
        seen: &mut FastMap<(usize, Fingerprint), usize>,
    ) -> Sight {
        let variant = &self.variants[v];
        let formula = &self.formulas[variant.formula];
        let constant = formula.manner == Manner::Constant;
        let points = if constant { fixed } else { free };
        let fixed = self.rows(v, fixed);
        let rows = if constant { fixed.clone() } else { self.rows(v, free) };
        if rows.iter().any(|r| r.len() < 3) {
            // Too few points to tell: it is not known to be the same.
            return Sight::New;
        }
        let whole = variant.altered.len() == formula.parts.len();
        let zero = |row: &Row| row.iter().all(|x| is_zero(x.altered[0]) && is_zero(x.altered[1]));
        let print_is_zero = |row: &Row| row.iter().all(|x| is_zero(x.print[0]) && is_zero(x.print[1]));
        if rows.iter().all(|r| zero(r) && print_is_zero(r)) {
            return Sight::Same;
        }
        if whole && rows.iter().all(zero) {
            return Sight::Empty;
        }
        let same = |rows: &[Row], turned: bool, how: Compare| {
            rows.iter().zip(&variant.altered).all(|(row, (_, part))| {
                let directed = !matches!(part.kind, RelationKind::Equal | RelationKind::NotEqual);
                how(&altered(row), &print(row, turned), directed)
            })
        };
        let one = |rows: &[Row], how: Compare| same(rows, false, how) || formula.branching && same(rows, true, how);
        // With parameters that stay what they are, what moves must move, or everything is proportional to everything.
        let moves = fixed.iter().all(|row| row.len() >= 3 && varies(&altered(row)) && varies(&print(row, false)));
        let directed = |(_, p): &(usize, Part)| !matches!(p.kind, RelationKind::Equal | RelationKind::NotEqual);
        let moves = moves && !variant.altered.iter().any(directed);
        if one(&rows, &proportional) || moves && one(&fixed, &proportional) {
            return Sight::Same;
        }
        let equations = variant.altered.iter().all(|(_, p)| p.kind == RelationKind::Equal);
        // x² = 0 says what x = 0 says.
        if equations && !constant && one(&rows, &|v, r, _| is_power(v, r)) {
            return Sight::Same;
        }
        let said = |g: usize| {
            let parts = self.formulas[g].parts.len();
            g != variant.formula
                && self.formulas[g].manner == formula.manner
                && self.formulas[g].parts.iter().all(|p| p.kind == RelationKind::Equal)
                && rows.iter().all(|row| {
                    zero(row) || (0..parts).any(|p| proportional(&altered(row), &sibling(row, points, g, p), false))
                })
        };
        if equations && whole && (0..self.formulas.len()).any(said) {
            return Sight::Said;
        }
        // For an inequality the direction matters, and there are few: all are kept.
        let rows = if moves { &fixed } else { &rows };
        let key: Fingerprint =
            variant.altered.iter().zip(rows).map(|((part, _), row)| (*part, fingerprint(&altered(row)))).collect();
        if !equations {
            return Sight::New;
        }
        let first = *seen.entry((variant.formula, key)).or_insert(v);
        if first == v { Sight::New } else { Sight::Repeated(first) }
    }

    /// The points at which everything has a value, for each altered part of a variant.
    fn rows(&self, v: usize, points: &[Point]) -> Vec<Row> {
        let variant = &self.variants[v];
        let mut rows: Vec<Row> = vec![Row::new(); variant.altered.len()];
        for (at, point) in points.iter().enumerate() {
            let minus = point.minus.as_ref().unwrap_or(&point.plus);
            let row = |(n, (part, _)): (usize, &(usize, _))| -> Result<Seen, NoValue> {
                let own = |o: &Outputs| o.own(variant.formula, *part);
                let altered = [point.plus.altered(v, n)?, minus.altered(v, n)?];
                Ok(Seen { altered, print: [own(&point.plus)?, own(minus)?], at })
            };
            if let Ok(row) = variant.altered.iter().enumerate().map(row).collect::<Result<Vec<_>, _>>() {
                rows.iter_mut().zip(row).for_each(|(all, one)| all.push(one));
            }
        }
        rows
    }
}

/// The residuals of one part at one point, for both signs of ±.
#[derive(Clone)]
struct Seen {
    altered: [Bounded; 2],
    print: [Bounded; 2],
    /// The point, by its position.
    at: usize,
}

type Row = Vec<Seen>;

/// How the values of two residuals are compared, and whether the direction matters.
type Compare<'a> = &'a dyn Fn(&[Bounded], &[Bounded], bool) -> bool;

fn altered(row: &Row) -> Vec<Bounded> {
    [0, 1].iter().flat_map(|&s| row.iter().map(move |x| x.altered[s])).collect()
}

fn print(row: &Row, turned: bool) -> Vec<Bounded> {
    let signs = if turned { [1, 0] } else { [0, 1] };
    signs.iter().flat_map(|&s| row.iter().map(move |x| x.print[s])).collect()
}

/// A part of another formula, as often as both signs of ± need it; nothing that anything is proportional to where it has no
/// value.
fn sibling(row: &Row, points: &[Point], formula: usize, part: usize) -> Vec<Bounded> {
    meter::charge(10 * row.len() as u64);
    let value = |x: &Seen| points.get(x.at)?.plus.own(formula, part).ok();
    let values: Option<Vec<Bounded>> = row.iter().map(value).collect();
    let values = values.filter(|v| v.iter().any(|x| !is_zero(*x)));
    values.map_or_else(Vec::new, |v| [v.clone(), v].concat())
}

/// Whether values are not all alike.
fn varies(v: &[Bounded]) -> bool {
    let half = &v[..v.len() / 2];
    let largest = half.iter().map(|x| x.value.abs()).fold(0.0, f64::max);
    let spread = |x: &Bounded| half.iter().map(|y| (y.value - x.value).abs()).fold(0.0, f64::max);
    half.iter().all(|x| spread(x) > 1e-6 * largest)
}

/// Whether one is a constant times a power of the other, so that both vanish together.
fn is_power(v: &[Bounded], r: &[Bounded]) -> bool {
    let raised =
        |v: &[Bounded], n: usize| -> Vec<Bounded> { v.iter().map(|x| (1..n).fold(*x, |p, _| p * *x)).collect() };
    (2..=3).any(|n| proportional(v, &raised(r, n), false) || proportional(&raised(v, n), r, false))
}
