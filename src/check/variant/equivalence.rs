//! Variants that say the same as the print.
//!
//! **In:** the variants of a claim. **Out:** those whose residual is, wherever the symbols have the meaning that they are
//! defined to have, a constant times that of the print (then the two are one equation), or 0 (then it says nothing), or a
//! constant times that of an earlier variant.
//!
//! Decided at random points: every state, rate, parameter and value at a fixed time is drawn by itself, observables follow
//! from their definitions. Two different analytic residuals are proportional at all of them with probability 0; what is
//! taken for proportional by rounding is so to fourteen digits.

use super::battery::{Battery, Outputs, Value};
use super::generate::{ClaimVariants, Manner};
use crate::check::comparison::traced;
use crate::derivation::{Claim, Derivation};
use crate::expr::{FastSet, Graph, Leaf};
use crate::latex::{RelationKind, Role};
use crate::number::{Bounded, Draws, NoValue};
use crate::tape::Tape;

/// Points at which residuals are compared.
const POINTS: usize = 5;
/// Points that are drawn at most: at some a formula may have no real value.
const DRAWN: usize = 40;
/// The start of the generator of points.
pub const SEED: u64 = 0x0DD5;

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
    /// The same equation as an earlier variant.
    Repeated,
}

/// The values of everything at one random point, for both signs of ±.
struct Point<'a> {
    plus: Outputs<'a>,
    minus: Option<Outputs<'a>>,
}

/// Whether v = c·r with one constant c ≠ 0 at all points; c > 0 where the direction matters.
fn proportional(v: &[Bounded], r: &[Bounded], directed: bool) -> bool {
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
        let mut kept = Vec::new();
        for (variant, sight) in std::mem::take(&mut self.variants).into_iter().zip(sights) {
            let count = self.count(variant.class);
            match sight {
                Sight::New => {
                    kept.push(variant);
                    continue;
                }
                Sight::Same => count.equivalent += 1,
                Sight::Empty => {
                    count.empty += 1;
                    count.kept -= 1;
                    self.empty.push(variant);
                    continue;
                }
                Sight::Repeated => count.repeated += 1,
            }
            count.kept -= 1;
        }
        self.variants = kept;
    }

    /// What random points say of each variant. `defined`: observables are what they are defined to be; otherwise they are
    /// independent, too, and only what algebra makes true is true.
    pub fn sights(&self, derivation: &Derivation, claim: &Claim, graph: &mut Graph, defined: bool) -> Vec<Sight> {
        let sign = claim.scope.branch_sign();
        let all = (0..self.variants.len()).collect();
        let Some(battery) = Battery::new(graph, self, 0, all, sign) else {
            return vec![Sight::New; self.variants.len()];
        };
        let free = draw(derivation, claim, graph, &battery, false, defined);
        // A constant may be any function of the parameters, so these stay what they are.
        let fixed = match self.formulas.iter().any(|f| f.manner == Manner::Constant) {
            true => draw(derivation, claim, graph, &battery, true, defined),
            false => Vec::new(),
        };
        let mut seen: FastSet<(usize, Fingerprint)> = FastSet::default();
        (0..self.variants.len())
            .map(|v| {
                let manner = self.formulas[self.variants[v].formula].manner;
                let points = if manner == Manner::Constant { &fixed } else { &free };
                self.sight(v, points, &mut seen)
            })
            .collect()
    }

    fn sight(&self, v: usize, points: &[Point], seen: &mut FastSet<(usize, Fingerprint)>) -> Sight {
        let variant = &self.variants[v];
        let formula = &self.formulas[variant.formula];
        // The points at which everything has a value.
        let mut rows: Vec<Vec<[Bounded; 4]>> = vec![Vec::new(); variant.altered.len()];
        for point in points {
            let minus = point.minus.as_ref().unwrap_or(&point.plus);
            let row = |(n, (part, _)): (usize, &(usize, _))| -> Result<[Bounded; 4], NoValue> {
                let own = |o: &Outputs| o.own(variant.formula, *part);
                Ok([point.plus.altered(v, n)?, minus.altered(v, n)?, own(&point.plus)?, own(minus)?])
            };
            if let Ok(row) = variant.altered.iter().enumerate().map(row).collect::<Result<Vec<_>, _>>() {
                rows.iter_mut().zip(row).for_each(|(all, one)| all.push(one));
            }
        }
        if rows.iter().any(|r| r.len() < 3) {
            // Too few points to tell: it is not known to be the same.
            return Sight::New;
        }
        let column = |row: &Vec<[Bounded; 4]>, k: usize| row.iter().map(|x| x[k]).collect::<Vec<Bounded>>();
        let whole = variant.altered.len() == formula.parts.len();
        let zero = |row: &Vec<[Bounded; 4]>| row.iter().all(|x| is_zero(x[0]) && is_zero(x[1]));
        let print_is_zero = |row: &Vec<[Bounded; 4]>| row.iter().all(|x| is_zero(x[2]) && is_zero(x[3]));
        if rows.iter().all(|r| zero(r) && print_is_zero(r)) {
            return Sight::Same;
        }
        if whole && rows.iter().all(zero) {
            return Sight::Empty;
        }
        let same = |signs: [usize; 2]| {
            rows.iter().zip(&variant.altered).all(|(row, (_, part))| {
                let directed = !matches!(part.kind, RelationKind::Equal | RelationKind::NotEqual);
                let v: Vec<Bounded> = [column(row, 0), column(row, 1)].concat();
                let r: Vec<Bounded> = [column(row, signs[0]), column(row, signs[1])].concat();
                proportional(&v, &r, directed)
            })
        };
        if same([2, 3]) || formula.branching && same([3, 2]) {
            return Sight::Same;
        }
        // For an inequality the direction matters, and there are few: all are kept.
        let equations = variant.altered.iter().all(|(_, p)| p.kind == RelationKind::Equal);
        let key: Fingerprint = variant
            .altered
            .iter()
            .zip(&rows)
            .map(|((part, _), row)| (*part, fingerprint(&[column(row, 0), column(row, 1)].concat())))
            .collect();
        if equations && !seen.insert((variant.formula, key)) { Sight::Repeated } else { Sight::New }
    }
}

/// Draws points and evaluates everything at them.
fn draw<'a>(
    derivation: &Derivation,
    claim: &Claim,
    graph: &mut Graph,
    battery: &'a Battery,
    steady: bool,
    defined: bool,
) -> Vec<Point<'a>> {
    let scope = &claim.scope;
    let leaves: Vec<Leaf> = battery.leaves().to_vec();
    let mut meanings = Vec::new();
    for &leaf in &leaves {
        let e = graph.leaf(leaf);
        meanings.push(if defined { traced(graph, scope, e) } else { e });
    }
    let basic = graph.leaves(meanings.iter().copied());
    let Ok(tape) = Tape::compile(graph, &basic, &meanings) else { return Vec::new() };
    let positive = |leaf: &Leaf| derivation.symbols.iter().any(|s| s.symbol == leaf.symbol && s.positive);
    let mut draws = Draws::new(SEED);
    let mut random = |leaf: &Leaf| {
        let size = 0.3 + draws.below(1 << 30) as f64 / f64::from(1u32 << 30) * 1.4;
        let negative = draws.below(2) == 1 && !positive(leaf);
        if negative { -size } else { size }
    };
    let mut slots = tape.slots::<Bounded>(&());
    let mut run = battery.slots();
    let mut points: Vec<Point> = Vec::new();
    let mut first: Option<Vec<f64>> = None;
    for _ in 0..DRAWN {
        let mut at: Vec<f64> = basic.iter().map(&mut random).collect();
        if let (true, Some(first)) = (steady, &first) {
            for (i, leaf) in basic.iter().enumerate() {
                if scope.role(leaf.symbol) == Some(Role::Parameter) {
                    at[i] = first[i];
                }
            }
        }
        let inputs: Vec<Value> = at.iter().map(|x| Ok(Bounded::exact(*x))).collect();
        let values = tape.evaluate(&(), &inputs, &mut slots);
        let plus = battery.at(values.iter().copied(), 1.0, &mut run);
        let minus = battery.has_sign().then(|| battery.at(values.iter().copied(), -1.0, &mut run));
        // A point at which the print says nothing is no point.
        let counted = battery.formulas().any(|(f, parts)| (0..parts).all(|p| plus.own(f, p).is_ok()));
        if counted {
            first.get_or_insert(at);
            points.push(Point { plus, minus });
        }
        if points.len() == POINTS {
            break;
        }
    }
    points
}
