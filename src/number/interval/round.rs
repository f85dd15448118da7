//! Directed rounding of + − × ÷ √ without touching the rounding mode of the machine.
//!
//! Each function yields the largest binary64 number that is not above the exact result (`down`) or the smallest that is not
//! below it (`up`), where the result is in the normal range; near the ends of the exponent range, one number further.
//!
//! **Why it is right:** the error of a rounded sum, and the residual of a rounded product, quotient or root, are binary64
//! numbers that can be computed exactly (error-free transforms: [Knuth 1969, §4.2.2] for sums; [Dekker 1971] with
//! Veltkamp's splitting for products). Their sign says on which side of the exact result the rounded one lies.
//!
//! [Knuth 1969, §4.2.2]: https://www-cs-faculty.stanford.edu/~knuth/taocp.html
//! [Dekker 1971]: https://doi.org/10.1007/BF01397083

use super::faults;

/// Products between these sizes can be split without underflow of the residual or overflow of a part.
const SMALLEST: f64 = 1e-280;
const LARGEST: f64 = 1e290;

/// The next number below `x` where the exact result is below it: `below` says so.
#[inline(always)]
fn down_if(x: f64, below: bool) -> f64 {
    if faults::nearest() {
        return x;
    }
    // An overflow to +∞ means that the exact result is at least MAX.
    if x == f64::INFINITY {
        f64::MAX
    } else if below {
        x.next_down()
    } else {
        x
    }
}

/// What rounding `a + b` to `s` has lost, exactly.
#[inline(always)]
pub(crate) fn sum_error(a: f64, b: f64, s: f64) -> f64 {
    let virtual_b = s - a;
    (a - (s - virtual_b)) + (b - virtual_b)
}

/// What rounding a·b to p has lost, exactly, for sizes within [`SMALLEST`] and [`LARGEST`].
#[inline(always)]
pub(crate) fn product_error(a: f64, b: f64, p: f64) -> f64 {
    if cfg!(target_feature = "fma") {
        return a.mul_add(b, -p);
    }
    const SPLIT: f64 = 134_217_729.0; // 2^27 + 1
    let (s, t) = (SPLIT * a, SPLIT * b);
    let (ah, bh) = (s - (s - a), t - (t - b));
    let (al, bl) = (a - ah, b - bh);
    ((ah * bh - p) + ah * bl + al * bh) + al * bl
}

#[inline(always)]
fn splits(x: f64) -> bool {
    (SMALLEST..LARGEST).contains(&x.abs())
}

/// ⌊a + b⌋
#[inline(always)]
pub(super) fn add_down(a: f64, b: f64) -> f64 {
    let s = a + b;
    if s.is_nan() {
        // ∞ − ∞ may be anything; what is not a number stays so.
        return if a.is_nan() || b.is_nan() { s } else { f64::NEG_INFINITY };
    }
    down_if(s, sum_error(a, b, s) < 0.0)
}

/// ⌈a + b⌉
#[inline(always)]
pub(super) fn add_up(a: f64, b: f64) -> f64 {
    -add_down(-a, -b)
}

/// ⌊ab⌋
#[inline(always)]
pub(super) fn mul_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        // Also where the other one is the infinite end of an interval of finite numbers.
        return if a.is_nan() || b.is_nan() { f64::NAN } else { 0.0 };
    }
    let p = a * b;
    let exact_residual = splits(p) && splits(a) && splits(b);
    down_if(p, !exact_residual || product_error(a, b, p) < 0.0)
}

/// ⌈ab⌉
#[inline(always)]
pub(super) fn mul_up(a: f64, b: f64) -> f64 {
    -mul_down(-a, b)
}

/// ⌊a/b⌋ for b ≠ 0
#[inline(always)]
pub(super) fn div_down(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        return if b.is_nan() { f64::NAN } else { 0.0 };
    }
    let q = a / b;
    if !(splits(a) && splits(b) && splits(q)) {
        return down_if(q, true);
    }
    // a − qb exactly: qb lies next to a.
    let p = q * b;
    let residual = (a - p) - product_error(q, b, p);
    down_if(q, if b > 0.0 { residual < 0.0 } else { residual > 0.0 })
}

/// ⌈a/b⌉ for b ≠ 0
#[inline(always)]
pub(super) fn div_up(a: f64, b: f64) -> f64 {
    -div_down(-a, b)
}

/// ⌊√a⌋ for a ≥ 0
#[inline(always)]
pub(super) fn sqrt_down(a: f64) -> f64 {
    let s = a.sqrt();
    if a == 0.0 || !splits(a) {
        return if a == 0.0 { 0.0 } else { down_if(s, true).max(0.0) };
    }
    let p = s * s;
    down_if(s, (a - p) - product_error(s, s, p) < 0.0)
}

/// ⌈√a⌉ for a ≥ 0
#[inline(always)]
pub(super) fn sqrt_up(a: f64) -> f64 {
    let s = a.sqrt();
    if a == 0.0 || !splits(a) {
        return if a == 0.0 { 0.0 } else { s.next_up() };
    }
    let p = s * s;
    if !faults::nearest() && (a - p) - product_error(s, s, p) > 0.0 { s.next_up() } else { s }
}

/// A number that is at least one unit in the last place of `x` below it.
#[inline(always)]
pub(super) fn below(x: f64) -> f64 {
    if faults::nearest() {
        return x;
    }
    let next = x.next_down();
    // Below a power of two the numbers are twice as dense.
    if x > 0.0 && x.to_bits() & ((1 << 52) - 1) == 0 { next.next_down() } else { next }
}

/// A number that is at least one unit in the last place of `x` above it.
#[inline(always)]
pub(super) fn above(x: f64) -> f64 {
    -below(-x)
}
