//! Numbers of the file, exactly as their decimal digits say.

use dashu_int::IBig;

use super::table::{Problems, Value};
use expr::Rational;
use toml::de::DeValue;

/// Largest power of ten: binary64 ends near 10^308, and larger powers would only fill the memory.
const LARGEST_EXPONENT: i64 = 400;

/// The value of a decimal number, without rounding; nothing where it is none that can be computed with.
pub fn exact(text: &str) -> Option<Rational> {
    let text = text.replace('_', "");
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((m, e)) => (m, e.parse::<i64>().ok()?),
        None => (text.as_str(), 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: IBig = format!("{whole}{fraction}").trim_start_matches('+').parse().ok()?;
    let exponent = exponent.checked_sub(i64::try_from(fraction.len()).ok()?)?;
    if exponent.abs() > LARGEST_EXPONENT || whole.len() > 400 {
        return None;
    }
    let power = Rational::from(10).pow(exponent.unsigned_abs() as isize);
    Some(if exponent < 0 { Rational::from(digits) / power } else { Rational::from(digits) * power })
}

/// The digits of a number in the file.
fn digits<'a>(value: &'a Value<'_>) -> Option<&'a str> {
    match value.get_ref() {
        DeValue::Integer(i) if i.radix() == 10 => Some(i.as_str()),
        DeValue::Float(f) => Some(f.as_str()),
        _ => None,
    }
}

/// The number in a value, `None` (and nothing noted) if it is not one.
pub(super) fn rational(problems: &mut Problems<'_>, value: &Value<'_>) -> Option<Result<Rational, ()>> {
    let text = digits(value)?;
    let number = exact(text);
    if number.is_none() {
        let message = format!("`{text}` is not a number that can be computed with");
        problems.note("derivation::bad-number", value.span(), message).hint("finite numbers up to about 1e±300 are");
    }
    Some(number.ok_or(()))
}

/// A number for the integrator or a tolerance.
pub(super) fn finite(problems: &mut Problems<'_>, value: &Value<'_>, key: &str) -> Option<f64> {
    let Some(text) = digits(value) else {
        problems.wrong_type(value, key, "a number");
        return None;
    };
    match text.replace('_', "").parse::<f64>() {
        Ok(x) if x.is_finite() => Some(x),
        _ => {
            problems.note("derivation::bad-number", value.span(), format!("`{key}` must be a finite number"));
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_text_is_exact() {
        let ratio = |n: i64, d: i64| Rational::from(n) / Rational::from(d);
        assert_eq!(exact("1.748"), Some(ratio(437, 250)));
        assert_eq!(exact("-0.1"), Some(ratio(-1, 10)));
        assert_eq!(exact("+1_000.5e-1"), Some(ratio(2001, 20)));
        assert_eq!(exact("3"), Some(Rational::from(3)));
        assert_eq!(exact("2e3"), Some(Rational::from(2000)));
        for refused in ["inf", "nan", "-inf", "1e999999999", "1e-500", "", "."] {
            assert_eq!(exact(refused), None, "{refused}");
        }
    }
}
