//! Evidence: what methods hand over, as plain data.
//!
//! **In:** numbers that a method computed. **Out:** [`Evidence`] with its parts. Nothing is judged here; a report makes words
//! of it, and a reader can compute it again. Nothing that decides looks into a [`Reason`].

use reason::{Reason, SignsAlong};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The worst point of a comparison: where |left − right| is largest in units of what it is compared with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// |left − right| at that point.
    pub max: f64,
    /// Its propagated error bound there.
    pub bound: f64,
    /// The time.
    pub at: f64,
}

impl Residual {
    /// |left − right| in units of its bound; 0 where the sides are the same.
    pub fn ratio(&self) -> f64 {
        if self.max > 0.0 { self.max / self.bound } else { 0.0 }
    }
}

/// A point that a reader can check by hand.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// The time.
    pub t: f64,
    /// The formula that is compared, as written, with its component: `t9[1]`, `\dot R_{12}`.
    pub formula: String,
    /// Value of the left side; not a number where it has none.
    pub left: f64,
    /// Value of the right side; not a number where it has none.
    pub right: f64,
    /// Error bound of their difference.
    pub bound: f64,
    /// Values that the two sides depend on: LaTeX name, value.
    pub values: Vec<(String, f64)>,
}

impl Witness {
    /// How far the sides are apart: |left − right|, of the very numbers that are shown.
    pub fn difference(&self) -> f64 {
        (self.left - self.right).abs()
    }
}

/// A stretch of time that was left out, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Exclusion {
    /// First excluded sample.
    pub from: f64,
    /// Last excluded sample.
    pub to: f64,
    /// Why.
    pub reason: Arc<Reason>,
}

/// What an enclosure found on all stretches of a span.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Enclosed {
    /// How many stretches were looked at, or events.
    pub places: usize,
    /// The largest |left − right| that is not excluded, for equations; for weak inequalities, by how much the wrong side may be the
    /// larger one; 0 where there is neither.
    pub gap: f64,
    /// The size of the terms that the gap is small against.
    pub scale: f64,
}

/// Where an enclosure is too wide to decide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Obstacle {
    /// First time; that of an event is known no better.
    pub from: f64,
    /// Last time, which may be the first.
    pub to: f64,
    /// What encloses the difference of the two sides there, where both have a value.
    pub difference: Option<(f64, f64)>,
}

impl Obstacle {
    /// That of a reason which says where something stays open.
    pub fn of(reason: &Reason) -> Option<Obstacle> {
        let (place, difference) = reason.obstacle()?;
        let (from, to) = place.ends();
        Some(Obstacle { from, to, difference })
    }
}

/// A proof's word on a part of a claim that states equations of every time, or denies them: it is so wherever it has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum PartShown {
    /// It is so: what it denies is never so.
    IsSo,
    /// It is not so: what it denies is always so.
    IsNotSo,
    /// It states equations that are never all true, however close their sides are.
    IsExcluded,
}

/// A proof for all values, as far as a verdict needs to know it.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Proof {
    /// What it follows from.
    pub from: Vec<String>,
    /// Conditions under which it was found, and which must hold on the motion.
    pub conditions: Vec<String>,
}

/// One comparison at some of its sample times, increasing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Residuals {
    /// The formula that is compared, with its component: the one in which the worst point lies.
    pub formula: String,
    /// Whether it is an equation: then a residual within its bound is a pass.
    pub equation: bool,
    /// Whether the relation is looked for at some time, rather than compared at all: a residual near 0 is then a find.
    pub sought: bool,
    /// How many samples there were.
    pub of: usize,
    /// The samples that were kept.
    pub points: Vec<ResidualPoint>,
}

/// A comparison at one time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResidualPoint {
    /// The time.
    pub t: f64,
    /// Value of the left side.
    pub left: f64,
    /// Value of the right side.
    pub right: f64,
    /// |left − right|, computed with the error bound.
    pub residual: f64,
    /// Its error bound: what the residual is compared with.
    pub bound: f64,
    /// The largest bound that counts as evidence: the precision that is asked for, times the size of the terms.
    pub limit: f64,
}

/// By how much the logarithm of a quantity rises from one member of a family to another.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rise {
    /// How far the logarithm of what varies runs.
    pub run: f64,
    /// How much that of the quantity rises.
    pub rise: f64,
    /// Its error bound.
    pub error: f64,
}

/// What a verdict rests on.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Evidence {
    /// Number of times at which the claim was compared.
    pub samples: usize,
    /// The worst point, where something was compared.
    pub residual: Option<Residual>,
    /// By how much a weak inequality that holds may be violated at some sample: the largest error bound at which its sides agree.
    pub slack: Option<f64>,
    /// The refuting point of a `fails`, the found point of an `eventually`.
    pub witness: Option<Witness>,
    /// Why not applicable or undecided; a remark on a `holds`.
    pub reason: Option<Reason>,
    /// Times left out.
    pub excluded: Vec<Exclusion>,
    /// For a claim with ±: which sign, and where it changes.
    pub branch: Option<SignsAlong>,
    /// The deciding comparison along the motion, thinned for drawing.
    pub series: Option<Arc<Residuals>>,
    /// What an enclosure found.
    pub enclosed: Option<Enclosed>,
    /// A point at which an assumption is not met.
    pub unmet: Option<Witness>,
    /// Where an enclosure did not decide.
    pub obstacle: Option<Obstacle>,
    /// The proof behind it.
    pub proof: Option<Proof>,
    /// Of a scaling law, what was compared.
    pub rise: Option<Rise>,
    /// How much of what is true rests on how large error bounds are: where sides are one within their bound, the largest share of it
    /// that they are apart; infinite where at some time the bound is too large to tell. 0 where other bounds would not matter.
    pub within: f64,
}

impl Evidence {
    /// A time at which both sides have values, with these: where they come closest, if that was kept.
    pub fn compared(&self) -> Option<Witness> {
        let series = self.series.as_ref()?;
        let worst = self.residual.as_ref().map(|r| r.at);
        let point = series.points.iter().find(|p| Some(p.t) == worst).or(series.points.first())?;
        let ResidualPoint { t, left, right, bound, .. } = *point;
        Some(Witness { t, formula: series.formula.clone(), left, right, bound, values: Vec::new() })
    }

    /// Keeps of the curve the one point that [`Evidence::compared`] gives, unless it is the curve that is `shown`.
    pub(super) fn thin(&mut self, shown: Option<&Arc<Residuals>>) {
        let Some(series) = self.series.take_if(|own| shown.is_none_or(|shown| !Arc::ptr_eq(own, shown))) else {
            return;
        };
        let worst = self.residual.as_ref().map(|r| r.at);
        let point = series.points.iter().find(|p| Some(p.t) == worst).or(series.points.first());
        let points = point.copied().into_iter().collect();
        let Residuals { formula, equation, sought, of, .. } = &*series;
        self.series = Some(Arc::new(Residuals {
            formula: formula.clone(),
            equation: *equation,
            sought: *sought,
            of: *of,
            points,
        }));
    }

    /// Nothing but a reason.
    pub fn because(reason: impl Into<Reason>) -> Evidence {
        Evidence { reason: Some(reason.into()), ..Evidence::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thinned_curve_has_the_point_that_stands_for_it() {
        let at = |t: f64| ResidualPoint { t, left: t, right: 1.0, residual: t - 1.0, bound: 0.1, limit: 1.0 };
        let points: Vec<ResidualPoint> = (0..9).map(|n| at(f64::from(n))).collect();
        let series = Residuals { formula: "x=1".into(), equation: true, sought: false, of: 9, points };
        for worst in [Some(5.0), None] {
            let residual = worst.map(|at| Residual { max: 1.0, bound: 0.1, at });
            let whole = Evidence { residual, series: Some(Arc::new(series.clone())), ..Evidence::default() };
            let (mut shown, mut other) = (whole.clone(), whole.clone());
            shown.thin(whole.series.as_ref());
            assert_eq!(shown, whole);
            other.thin(None);
            assert_eq!(other.compared(), whole.compared());
            assert_eq!(other.series.map(|s| (s.points.len(), s.of)), Some((1, 9)));
        }
    }
}
