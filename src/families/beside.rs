//! The motions that a member is compared with: those that differ from it in one symbol.
//!
//! **In:** a member, what varies, and a claim that compares. **Out:** the values of the motions, or why there is none. **Guaranteed:** the
//! number of the member alone determines them, as it does the member; whether they are members themselves does not matter to what
//! is found.

use super::member::{MOST_DRAWS, Members, evaluated, on_grid};
use crate::derivation::{Claim, Dependence, Derivation, End, Form, NoOther, Spread, Written};
use crate::diag::Diagnostic;
use crate::expr::Expr;
use claim::error::CheckError;
use sampled::extrapolate::{BEYOND, RATIO, STEPS};

/// Which motion a member is compared with: one that differs from it in one symbol.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Beside {
    /// The next larger value of its row that the constraints leave.
    Next,
    /// The first value of the row, with which all are compared, or another draw.
    Reference,
    /// This value, whether a member has it or not.
    At(f64),
    /// On the member's side of a value, at a distance from it.
    Edge { at: f64, distance: f64 },
    /// Nearer to a number, or to infinity, by so many powers of [`RATIO`].
    Toward { end: f64, powers: usize },
}

impl Beside {
    /// Whether the claim is judged without it where there is none: on the other side of an extremum, beyond a sequence.
    pub fn may_be_missing(self) -> bool {
        match self {
            Beside::Edge { .. } => true,
            Beside::Toward { powers, .. } => powers == BEYOND,
            Beside::Next | Beside::Reference | Beside::At(_) => false,
        }
    }
}

impl Members {
    /// The motion beside a member, which has another value of one symbol.
    pub fn beside(&self, number: u64, values: &[f64], varied: usize, which: Beside) -> Result<Vec<f64>, NoOther> {
        let own = values[varied];
        let with = |x: f64| {
            let mut other = values.to_vec();
            other[varied] = x;
            (x.is_finite() && self.is_wanted(&other)).then_some(other)
        };
        let next = match which {
            Beside::Next => true,
            Beside::Reference => false,
            Beside::At(x) => return with(x).ok_or(NoOther::Rejected),
            Beside::Edge { at, .. } if own == at => return Err(NoOther::Near),
            Beside::Edge { at, distance } => {
                let x = if own < at { at - distance } else { at + distance };
                let (least, greatest) = self.range(varied);
                return with(x).filter(|_| least <= x && x <= greatest).ok_or(NoOther::Near);
            }
            Beside::Toward { end, powers } => {
                let power = (0..powers).fold(1.0, |product, _| product * RATIO);
                let (is_before, x) = match end.is_finite() {
                    true => (own != end, end + (own - end) / power),
                    false => (own * end > 0.0, own * power),
                };
                let moves = !end.is_finite() || x != end;
                return if is_before && moves { with(x).ok_or(NoOther::Rejected) } else { Err(NoOther::Beyond) };
            }
        };
        let numbers = &self.numbers[varied];
        let first = |mut of: &mut dyn Iterator<Item = f64>| {
            let found = (&mut of).take(MOST_DRAWS as usize).find_map(with);
            match found {
                Some(other) if other[varied] == own => Err(NoOther::Last),
                Some(other) => Ok(other),
                None if of.next().is_some() => Err(NoOther::TooRare),
                None => Err(NoOther::Last),
            }
        };
        match &self.family.vary[varied].spread {
            Spread::Values(_) if next => {
                let mut later: Vec<f64> = numbers.iter().copied().filter(|x| *x > own).collect();
                later.sort_by(f64::total_cmp);
                first(&mut later.into_iter())
            }
            Spread::Values(_) => first(&mut numbers.iter().copied()),
            Spread::Grid { count, logarithmic, .. } => {
                let begin = if next { self.positions(number)[varied] + 1 } else { 0 };
                first(&mut (begin..*count).map(|at| on_grid((numbers[0], numbers[1]), (at, *count), *logarithmic)))
            }
            // Draws that no member is made of.
            Spread::Uniform(..) | Spread::LogUniform(..) | Spread::Polar(..) | Spread::Normal(..) => {
                first(&mut (MOST_DRAWS..).map(|attempt| self.values(number, attempt)[varied]))
            }
        }
    }
}

/// The motions that each claim compares a member with.
///
/// # Errors
/// A place that is no number, or that lies outside of what the family varies.
pub(super) fn compared_with(
    derivation: &Derivation,
    members: &Members,
    asked: &[&Claim],
) -> Result<Vec<Vec<(usize, Beside)>>, CheckError> {
    let family = &members.family;
    let refused = |point: &Written<Expr>, message: String, hint: String| {
        let place = point.span.clone();
        let problem = Diagnostic::at(&derivation.file, "derivation::bad-family", place, message).hint(hint);
        CheckError::Problems(vec![problem])
    };
    let number = |point: &Written<Expr>| {
        let found = evaluated(derivation, &[point.value]).into_iter().next().flatten();
        found.filter(|x| x.is_finite()).ok_or_else(|| {
            refused(point, format!("`{}` is no real number", point.text), "write one, such as 0".to_owned())
        })
    };
    let one = |claim: &&Claim| {
        let Some(Form::Across(across)) = claim.forms.first() else { return Ok(Vec::new()) };
        let Some(varied) = family.vary.iter().position(|v| v.leaf == across.with) else { return Ok(Vec::new()) };
        let point = across.point.as_ref().map(|point| Ok((point, number(point)?))).transpose()?;
        let which = match (across.dependence, point) {
            (Dependence::Independent, _) => vec![Beside::Reference],
            (Dependence::Increasing | Dependence::Decreasing | Dependence::Power { .. }, _) => vec![Beside::Next],
            (Dependence::Extremum { to, .. }, Some((point, at))) => {
                let (least, greatest) = members.range(varied);
                if at < least || at > greatest {
                    let (name, id) = (&across.name, &family.id);
                    let message = format!("the family `{id}` varies `{name}` from {least} to {greatest}");
                    return Err(refused(point, message, "an extremum is looked for in this range".to_owned()));
                }
                vec![Beside::At(at), Beside::Edge { at, distance: to }]
            }
            (Dependence::Limit { end, .. }, point) => {
                let end = match end {
                    End::Number => point.map_or(0.0, |(_, x)| x),
                    End::Infinity => f64::INFINITY,
                    End::MinusInfinity => f64::NEG_INFINITY,
                };
                (1..STEPS).chain([BEYOND]).map(|powers| Beside::Toward { end, powers }).collect()
            }
            (Dependence::Extremum { .. }, None) => Vec::new(),
        };
        Ok(which.into_iter().map(|which| (varied, which)).collect())
    };
    asked.iter().map(one).collect()
}
