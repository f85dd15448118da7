//! What a number of failures in a sample says of the distribution that it is drawn from.
//!
//! **In:** so many failures in so many independent draws. **Out:** the upper bound of Clopper and Pearson for the share that fails:
//! with that share or a larger one, so few failures would occur with a probability of at most 5 %.
//!
//! **Guaranteed:** the bound is rounded up, and the same on every machine. It is the share p at which P(X ≤ k) for X binomial with
//! n draws is 0.05, found by bisection. The sum is taken from its largest term down: terms fall from k on, since p > k/n.

use super::draw::{exp, ln};

/// The confidence of the bound.
pub const CONFIDENCE: f64 = 0.95;

/// ln √(2π).
const HALF_LN_TAU: f64 = 0.918_938_533_204_672_7;

/// What Stirling's formula leaves of ln n!, for n of at least 1.
fn stirling_error(n: f64) -> f64 {
    if n < 16.0 {
        let factorial = (2..=n as u32).fold(1.0_f64, |f, i| f * f64::from(i));
        return ln(factorial) - (n + 0.5) * ln(n) + n - HALF_LN_TAU;
    }
    let s = 1.0 / (n * n);
    (1.0 / 12.0 - s * (1.0 / 360.0 - s * (1.0 / 1260.0 - s * (1.0 / 1680.0 - s / 1188.0)))) / n
}

/// x ln(x/m) + m − x, without the loss of digits where x is near m.
fn deviance(x: f64, m: f64) -> f64 {
    let v = (x - m) / (x + m);
    if v.abs() >= 0.1 {
        return x * ln(x / m) + m - x;
    }
    // (x − m) v + 2x Σ v^(2j+1)/(2j+1)
    let mut sum = (x - m) * v;
    let mut term = 2.0 * x * v;
    for j in 1..100 {
        term *= v * v;
        let next = sum + term / f64::from(2 * j + 1);
        if next == sum {
            break;
        }
        sum = next;
    }
    sum
}

/// ln P(X = k), for 0 < k < n and 0 < p < 1.
fn ln_probability(k: f64, n: f64, p: f64) -> f64 {
    let rest = n - k;
    stirling_error(n) - stirling_error(k) - stirling_error(rest) - deviance(k, n * p) - deviance(rest, n * (1.0 - p))
        + 0.5 * (ln(n) - ln(k) - ln(rest))
        - HALF_LN_TAU
}

/// P(X ≤ k) for X binomial, with p > k/n.
fn at_most(k: u64, n: u64, p: f64) -> f64 {
    let (k, n) = (k as f64, n as f64);
    // ln(1 − p), without the loss of digits for small p.
    let ln_rest = if p < 1e-4 { -p * (1.0 + p * (0.5 + p / 3.0)) } else { ln(1.0 - p) };
    if k == 0.0 {
        return exp(n * ln_rest);
    }
    let (mut sum, mut term, mut j) = (1.0, 1.0, k);
    while j > 0.0 && term > 1e-18 * sum {
        term *= j * (1.0 - p) / ((n - j + 1.0) * p);
        sum += term;
        j -= 1.0;
    }
    exp(ln_probability(k, n, p)) * sum
}

/// The share of failures that is excluded with [`CONFIDENCE`], after so many failures in so many draws: an upper bound, rounded up.
/// 1 where nothing was drawn.
pub fn failing_share(failures: u64, draws: u64) -> f64 {
    if failures >= draws {
        return 1.0;
    }
    let (mut low, mut high) = (failures as f64 / draws as f64, 1.0_f64);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if at_most(failures, draws, middle) > 1.0 - CONFIDENCE { low = middle } else { high = middle }
    }
    // More than what rounding takes away.
    (high * (1.0 + 1e-9)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn near(found: f64, expected: f64) {
        assert!(found >= expected * (1.0 - 1e-12) && found < expected * (1.0 + 1e-7), "{found} {expected}");
    }

    #[test]
    fn without_failures_it_is_the_rule_of_three_made_exact() {
        // 1 − 0.05^(1/n).
        near(failing_share(0, 200), 0.014_867_039_231_272_0);
        near(failing_share(0, 1), 0.95);
        near(failing_share(0, 1_000_000), 2.995_727_786_352e-6);
        assert_eq!(failing_share(0, 0), 1.0);
        assert_eq!(failing_share(5, 5), 1.0);
    }

    #[test]
    fn with_failures_it_inverts_the_binomial_distribution() {
        // Quantiles of the beta distribution with parameters k + 1 and n − k at 0.95.
        near(failing_share(1, 10), 0.394_163_302_436);
        near(failing_share(3, 100), 0.075_710_793_749);
        // By its definition: summed with exact binomials.
        for (k, n) in [(1_u64, 10_u64), (2, 20), (7, 30), (19, 20)] {
            let p = failing_share(k, n);
            let mut sum = 0.0;
            for j in 0..=k {
                let choose = (0..j).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
                let power = |x: f64, times: u64| (0..times).fold(1.0, |y, _| y * x);
                sum += choose * power(p, j) * power(1.0 - p, n - j);
            }
            assert!((sum - 0.05).abs() < 1e-7 && sum <= 0.05, "{k} of {n}: {sum}");
        }
        // Of many draws the share itself, and a little more.
        let p = failing_share(500_000, 1_000_000_000);
        assert!(p > 5e-4 && p < 5.02e-4, "{p}");
    }
}
