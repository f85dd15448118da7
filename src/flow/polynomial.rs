//! Polynomials by their coefficients, ascending.

/// c₀ + c₁h + … (coefficients ascending).
#[inline]
pub(super) fn horner(c: &[f64], h: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, &x| sum * h + x)
}

/// Coefficients of p(middle + half·x).
pub(super) fn shift(p: &[f64], middle: f64, half: f64, c: &mut Vec<f64>) {
    c.clear();
    c.extend_from_slice(p);
    let n = if middle == 0.0 { 0 } else { c.len() };
    for i in 0..n {
        for k in (i..n.saturating_sub(1)).rev() {
            c[k] += middle * c[k + 1];
        }
    }
    scale(c, half);
}

/// Coefficients of p(radius·x), in the place of those of p.
pub(super) fn scale(p: &mut [f64], radius: f64) {
    let mut power = 1.0;
    for c in p {
        *c *= power;
        power *= radius;
    }
}

/// The sum of the last three terms of a polynomial of full degree, at a distance: what a truncation may leave out.
pub(super) fn tail(coefficients: &[f64], degree: usize, radius: f64) -> f64 {
    let mut power = 1.0;
    let mut sum = 0.0;
    for (k, c) in coefficients.iter().enumerate() {
        if k + 3 > degree {
            sum += c.abs() * power;
        }
        power *= radius;
    }
    sum
}
