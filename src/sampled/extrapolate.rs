//! The limit of a sequence, from some of its members.
//!
//! **In:** a quantity with its error bound, at arguments whose distance from where they tend falls by the same ratio each time. **Out:** an
//! estimate of its limit, with an error; or that the members do not show one.
//!
//! **How:** by Aitken's process, twice. Where the quantity is L + a x^p with any p, a sequence of x in a constant ratio makes it L + a r^k, of
//! which three members give L; doing it again takes away the next power. (C. Brezinski, M. Redivo Zaglia, Extrapolation Methods,
//! 1991, § 2.2.) The error is the larger one of two differences: between the last two of the second estimates, and between the last
//! of the second and the last of the first, with what the members' own errors add; where the first agree to within their errors, how
//! far they are apart. It is no smaller than a share of what is extrapolated, by how unsteady the sequence is.
//!
//! **No member of a sequence says where it ends.** So this is evidence of the weakest kind, and what is estimated is refused where the
//! members speak against a geometric approach: the steps must shrink, by ratios that settle themselves. A quantity like 1/ln x,
//! which falls more slowly than every power, is refused for that reason: its ratios creep towards 1. So is x^p with p below 0.46. And where
//! there is a motion far beyond the sequence, it must lie where the estimate says ([`goes_on`]): tanh(10⁴x) is 1 at all that are near.

use crate::number::Bounded;
use reason::Plain;

/// How many members are looked at.
pub const STEPS: usize = 6;

/// The ratio of neighbouring distances: two more than the golden section, which of all numbers is farthest from fractions of small ones.
/// With a whole ratio sin(π/a) is 0 at all of a = ½, 1, 2, 4.
pub const RATIO: f64 = 3.618_033_988_749_895;

/// How many powers of the ratio nearer than the first the motion lies that is asked whether it goes on so: as far behind the sequence as
/// that is long, in logarithms.
pub const BEYOND: usize = 2 * (STEPS - 1);

/// A step that is a larger share of the one before it does not shrink.
const SHRINKS: f64 = 0.55;

/// The ratios of steps settle where their change is a smaller share of the one before, or is no larger than [`STEADY`].
const SETTLES: f64 = 0.3;
const STEADY: f64 = 0.01;

/// How many times the unsteadiness of the ratios is the least share of what is extrapolated that counts as error. A comparison wants
/// two sides to be ten errors apart. Of 50,000 random series of powers, roots, logarithms and sines that were not refused (with 4 as ratio), 40
/// had a limit further than that from the estimate, all but one with logarithms.
const DOUBT: f64 = 2.0;

/// A value whose error says nothing of it.
fn is_known(x: &Bounded) -> bool {
    x.value.is_finite() && x.error.is_finite()
}

/// Aitken's estimate from three members; `None` where their second difference may be 0.
fn aitken([a, b, c]: [Bounded; 3]) -> Option<Bounded> {
    let (first, second) = (b - a, c - b);
    let bend = second - first;
    let found = c - second * second / bend;
    (!bend.contains_zero() && is_known(&found)).then_some(found)
}

/// Every estimate from three members that follow one another.
fn estimates(of: &[Bounded]) -> Option<Vec<Bounded>> {
    of.windows(3).map(|w| aitken([w[0], w[1], w[2]])).collect()
}

/// Whether a member far beyond the sequence is as near to the estimate as that says, or is not known to be elsewhere: what is left of the
/// distance of the last must have shrunk to a tenth, as with x^p for p = 0.36.
pub fn goes_on(limit: &Bounded, last: &Bounded, beyond: &Bounded) -> bool {
    let left = (*beyond - *limit).value.abs();
    left <= 0.1 * (*last - *limit).magnitude() + limit.error + beyond.error
}

/// The limit of a sequence of [`STEPS`] members, with an estimate of its error: no bound.
///
/// # Errors
/// What speaks against a limit, or against estimating it from these members.
pub fn limit(of: &[Bounded]) -> Result<Bounded, Plain> {
    if of.len() != STEPS || !of.iter().all(is_known) {
        return Err(Plain::SequenceUnknown);
    }
    let steps: Vec<Bounded> = of.windows(2).map(|w| w[1] - w[0]).collect();
    let is_still = |step: &Bounded| step.contains_zero();
    let (Some(&last), [.., before, end]) = (of.last(), &steps[..]) else {
        return Err(Plain::SequenceUnknown);
    };
    // Once a step is below the errors, all that follow must be, and nothing is left to extrapolate.
    if let Some(n) = steps.iter().position(is_still) {
        if !steps[n..].iter().all(is_still) {
            return Err(Plain::StepsDoNotShrink);
        }
        let shrinks = |w: &[Bounded]| w[1].value.abs() <= SHRINKS * w[0].value.abs();
        if !steps[..n].windows(2).all(shrinks) {
            return Err(Plain::StepsDoNotShrink);
        }
        return Ok(Bounded { value: last.value, error: last.error + before.magnitude() + end.magnitude() });
    }
    let ratios: Vec<Bounded> = steps.windows(2).map(|w| w[1] / w[0]).collect();
    let [zeroth, a, b, c] = ratios[..] else { return Err(Plain::SequenceUnknown) };
    if [b, c].iter().any(|r| r.magnitude() > SHRINKS) {
        return Err(Plain::StepsDoNotShrink);
    }
    let (earlier, later) = ((b - a).magnitude(), (c - b).mignitude());
    if later > STEADY.max(SETTLES * earlier) {
        return Err(Plain::RatiosDoNotSettle);
    }
    let coarse = last.error + before.magnitude();
    let first = estimates(of);
    let Some((once, apart)) = first.as_deref().and_then(|estimates| {
        let (last, others) = estimates.split_last()?;
        Some((*last, others.iter().map(|e| (*last - *e).magnitude()).fold(0.0, f64::max)))
    }) else {
        return Ok(Bounded { value: last.value, error: coarse });
    };
    let twice = first.and_then(|e| estimates(&e));
    let rounding = f64::EPSILON * last.magnitude();
    let found = match twice.as_deref() {
        Some([.., earlier, later]) => {
            let apart = (later.value - earlier.value).abs().max((later.value - once.value).abs());
            Bounded { value: later.value, error: apart + later.error + rounding }
        }
        // Nothing is left to be taken away: the first estimates agree to within their errors.
        _ => Bounded { value: once.value, error: apart + once.error + rounding },
    };
    // The ratios of a geometric sequence are all the same.
    let unsteady = (c - b).value.abs().max((b - a).value.abs() / RATIO).max((a - zeroth).value.abs() / (RATIO * RATIO));
    let share = (DOUBT * unsteady / c.mignitude()).min(1.0);
    let doubt = share * (found.value - last.value).abs() + last.error;
    let found = Bounded { value: found.value, error: found.error.max(doubt) };
    Ok(if found.error <= coarse { found } else { Bounded { value: last.value, error: coarse } })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(f: impl Fn(f64) -> f64, error: f64) -> Result<Bounded, Plain> {
        let mut x = 1.0;
        let next = |_| {
            let value = f(x);
            x /= RATIO;
            Bounded { value, error: error + f64::EPSILON * value.abs() }
        };
        limit(&(0..STEPS).map(next).collect::<Vec<_>>())
    }

    #[test]
    fn limits_of_powers_and_series_are_found_within_their_errors() {
        type Case = (&'static str, fn(f64) -> f64, f64);
        let cases: [Case; 9] = [
            // The estimates agree by chance, and are 137 times as far from the limit as from one another.
            ("2.1x + 0.2x² - 1.7x³", |x| 2.1 * x + 0.2 * x * x - 1.7 * x * x * x, 0.0),
            ("a constant", |_| 3.0, 3.0),
            ("1 + x", |x| 1.0 + x, 1.0),
            ("x", |x| x, 0.0),
            ("1 + x²", |x| 1.0 + x * x, 1.0),
            ("√x", |x| 2.0 - x.sqrt(), 2.0),
            ("1/(1 + x)", |x| 1.0 / (1.0 + x), 1.0),
            ("x - 3x² + x³", |x| -5.0 + x - 3.0 * x * x + x * x * x, -5.0),
            ("(1 - x²)/(1 + x)²", |x| (1.0 - x * x) / ((1.0 + x) * (1.0 + x)), 1.0),
        ];
        for (name, f, exact) in cases {
            for error in [0.0, 1e-12, 1e-6] {
                let found = of(f, error).unwrap_or_else(|why| panic!("{name}: {why}"));
                assert!((found.value - exact).abs() <= found.error, "{name} {error} {found:?}");
                assert!(found.error < 0.2, "{name} {error} {found:?}");
            }
        }
        // An estimate is much better than the last member.
        let found = of(|x| 1.0 / (1.0 + x), 0.0).expect("a limit");
        assert!((found.value - 1.0).abs() < 1e-6 && found.error < 1e-3, "{found:?}");
    }

    #[test]
    fn what_does_not_settle_is_refused() {
        let log2 = |x: f64| (x.to_bits() >> 52) as f64 - 1023.0;
        let cases: [(&str, &dyn Fn(f64) -> f64); 10] = [
            ("⁴√x", &|x| x.sqrt().sqrt()),
            ("√x + x", &|x| x.sqrt() + x),
            ("1/(1 + 20x)", &|x| 1.0 / (1.0 + 20.0 * x)),
            ("a logarithm", &|x| log2(x)),
            ("1/(3 - ln x)", &|x| 1.0 / (3.0 - log2(x))),
            ("1/(1 - ln x)", &|x| 1.0 / (1.0 - log2(x))),
            ("1/(1 - ln x)²", &|x| 1.0 / ((1.0 - log2(x)) * (1.0 - log2(x)))),
            ("1/(20 - ln x)²", &|x| 1.0 / ((20.0 - log2(x)) * (20.0 - log2(x)))),
            ("1/x", &|x| 1.0 / x),
            ("an oscillation", &|x| if (log2(x) / 2.0) % 2.0 == 0.0 { 1.0 } else { -1.0 }),
        ];
        for (name, f) in cases {
            let found = of(f, 1e-14);
            assert!(found.is_err(), "{name} {found:?}");
        }
        assert!(limit(&[Bounded::exact(1.0); 3]).is_err());
        assert!(of(|x| if x < 0.1 { f64::NAN } else { x }, 0.0).is_err());
        assert!(of(|x| x, f64::INFINITY).is_err());
    }

    #[test]
    fn what_stands_still_and_moves_again_is_refused() {
        assert!(of(|x| if x < 0.002 { 1.0 } else { 0.0 }, 1e-9).is_err());
        assert!(of(|x| if x < 0.1 { 1.0 } else { 0.0 }, 1e-9).is_err());
    }
}
