//! Small matrices: of binary64 numbers, and of intervals. Row by row, square.

use number::{Interval, Scalar};

/// More than what underflow may lose in a sum of products.
const TINY: f64 = 1e-290;

/// Counts the work of a product of two matrices, or of something as long.
fn count_cube(n: usize) {
    meter::charge(4 * (n * n * n) as u64);
}

/// M·v.
pub(super) fn apply(m: &[Interval], v: &[Interval]) -> Vec<Interval> {
    m.chunks_exact(v.len().max(1)).map(|row| dot(row.iter().copied(), v.iter().copied())).collect()
}

/// M·v for a matrix of numbers.
pub(super) fn apply_point(m: &[f64], v: &[Interval]) -> Vec<Interval> {
    m.chunks_exact(v.len().max(1)).map(|row| dot(row.iter().map(|&x| Interval::point(x)), v.iter().copied())).collect()
}

fn dot(a: impl Iterator<Item = Interval>, b: impl Iterator<Item = Interval>) -> Interval {
    let mut sum = Interval::ZERO;
    for (x, y) in a.zip(b) {
        if !x.is_zero() && !y.is_zero() {
            sum = sum + x * y;
        }
    }
    sum
}

/// M·P for a matrix P of numbers: products and sums of middles, to nearest, and a bound of what these leave out.
///
/// The radii contribute Σ rad(M)|P|. A sum of n products, each of whose terms is rounded at most n times, errs by at most
/// nu·Σ|mid(M)||P|/(1 − nu) ([Higham 2002, §3.1]; [Rump 1999, §2] for the whole), and so do the bounds themselves.
///
/// [Higham 2002, §3.1]: https://doi.org/10.1137/1.9780898718027
/// [Rump 1999, §2]: https://doi.org/10.1023/A:1022374804152
pub(super) fn times_point(m: &[Interval], p: &[f64], n: usize) -> Vec<Interval> {
    count_cube(n);
    let slips = (n as f64 + 4.0) * f64::EPSILON;
    let (mut sums, mut bounds) = (vec![0.0; n], vec![0.0; n]);
    let mut out = Vec::with_capacity(n * n);
    for row in m.chunks_exact(n) {
        sums.fill(0.0);
        bounds.fill(0.0);
        for (x, of) in row.iter().zip(p.chunks_exact(n)) {
            if x.is_zero() {
                continue;
            }
            let middle = x.mid();
            let apart = x.radius() + slips * middle.abs();
            for ((sum, bound), &y) in sums.iter_mut().zip(&mut bounds).zip(of) {
                *sum += middle * y;
                *bound += apart * y.abs();
            }
        }
        let ball = |(&sum, &bound): (&f64, &f64)| match bound == 0.0 && sum == 0.0 {
            // Of nothing but zeros, or of what is smaller than any bound that matters.
            true if row.iter().all(Scalar::is_zero) => Interval::ZERO,
            _ => Interval::ball(sum, bound * (1.0 + 2.0 * slips) + TINY),
        };
        out.extend(sums.iter().zip(&bounds).map(ball));
    }
    out
}

/// The numbers in the middle.
pub(super) fn middle(m: &[Interval]) -> Vec<f64> {
    m.iter().map(Interval::mid).collect()
}

pub(super) fn identity(n: usize) -> Vec<f64> {
    (0..n * n).map(|i| if i / n == i % n { 1.0 } else { 0.0 }).collect()
}

/// A matrix with nearly orthonormal columns that span what the first columns of `m` span, where columns are taken in the
/// order of their lengths times `weights`, longest first.
///
/// Any matrix that is invertible will do for rigour; this one keeps an error along its own directions, which is what stops
/// wrapping ([Lohner 1987]).
///
/// [Lohner 1987]: https://publikationen.bibliothek.kit.edu/38889
pub(super) fn orthogonal(m: &[f64], weights: &[f64], n: usize) -> Vec<f64> {
    count_cube(n);
    let length = |j: usize| (0..n).map(|i| m[i * n + j] * m[i * n + j]).sum::<f64>().sqrt() * weights[j];
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| length(b).total_cmp(&length(a)));
    let mut columns: Vec<Vec<f64>> = Vec::with_capacity(n);
    let candidates = order.iter().map(|&j| (0..n).map(|i| m[i * n + j]).collect::<Vec<f64>>());
    let axes = (0..n).map(|j| (0..n).map(|i| if i == j { 1.0 } else { 0.0 }).collect::<Vec<f64>>());
    for mut column in candidates.chain(axes) {
        if columns.len() == n {
            break;
        }
        let norm = |c: &[f64]| c.iter().map(|x| x * x).sum::<f64>().sqrt();
        let start = norm(&column);
        if !(start.is_finite() && start > 0.0) {
            continue;
        }
        // Twice is enough for orthogonality to the last digits.
        for _ in 0..2 {
            for before in &columns {
                let along: f64 = column.iter().zip(before).map(|(x, y)| x * y).sum();
                column.iter_mut().zip(before).for_each(|(x, y)| *x -= along * y);
            }
        }
        let left = norm(&column);
        if left > 1e-10 * start {
            column.iter_mut().for_each(|x| *x /= left);
            columns.push(column);
        }
    }
    (0..n * n).map(|i| columns.get(i % n).map_or(0.0, |c| c[i / n])).collect()
}

/// The transpose.
pub(super) fn transpose(m: &[f64], n: usize) -> Vec<f64> {
    (0..n * n).map(|i| m[i % n * n + i / n]).collect()
}

/// Roughly the inverse, by elimination with the largest pivot; `None` where a pivot vanishes.
pub(super) fn rough_inverse(m: &[f64], n: usize) -> Option<Vec<f64>> {
    count_cube(n);
    let (mut a, mut inverse) = (m.to_vec(), identity(n));
    for k in 0..n {
        let best = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()))?;
        let pivot = a[best * n + k];
        if !(pivot.abs() > 0.0 && pivot.is_finite()) {
            return None;
        }
        for j in 0..n {
            a.swap(k * n + j, best * n + j);
            inverse.swap(k * n + j, best * n + j);
        }
        for j in 0..n {
            a[k * n + j] /= pivot;
            inverse[k * n + j] /= pivot;
        }
        for i in (0..n).filter(|&i| i != k) {
            let factor = a[i * n + k];
            if factor != 0.0 {
                for j in 0..n {
                    a[i * n + j] -= factor * a[k * n + j];
                    inverse[i * n + j] -= factor * inverse[k * n + j];
                }
            }
        }
    }
    Some(inverse)
}

/// Bounds of m⁻¹v from a rough inverse A of m; `None` when A is too rough.
///
/// With E = I − A·m and ‖E‖∞ ≤ ε < 1, m⁻¹v = (I − E)⁻¹Av = Av + (E + E² + …)Av, and the entries of the sum in brackets are at
/// most ε/(1 − ε) (Neumann series).
pub(super) fn solve(m: &[f64], rough: &[f64], v: &[Interval]) -> Option<Vec<Interval>> {
    let n = v.len();
    let more = inverse_defect(m, rough, n)?;
    let near = apply_point(rough, v);
    let size = near.iter().fold(Interval::ZERO, |sum, x| sum + Interval::point(x.magnitude()));
    let beyond = Interval::ball(0.0, (size * Interval::point(more)).hi());
    Some(near.into_iter().map(|x| x + beyond).collect())
}

/// The ε/(1 − ε) of [`solve`].
fn inverse_defect(m: &[f64], rough: &[f64], n: usize) -> Option<f64> {
    count_cube(n);
    let points: Vec<Interval> = rough.iter().map(|&x| Interval::point(x)).collect();
    let product = times_point(&points, m, n);
    let mut norm = 0.0_f64;
    for (i, row) in product.chunks_exact(n).enumerate() {
        let mut sum = Interval::ZERO;
        for (j, &x) in row.iter().enumerate() {
            let e = if i == j { Interval::point(1.0) - x } else { x };
            sum = sum + Interval::point(e.magnitude());
        }
        norm = norm.max(sum.hi());
    }
    if norm.is_nan() || norm >= 0.5 {
        return None;
    }
    Some((Interval::point(norm) / (Interval::point(1.0) - Interval::point(norm))).hi())
}

/// A matrix of intervals that contains the inverse of `m`, see [`solve`].
pub(super) fn inverse(m: &[f64], rough: &[f64], n: usize) -> Option<Vec<Interval>> {
    let rest = inverse_defect(m, rough, n)?;
    let mut series: Vec<Interval> = vec![Interval::ball(0.0, rest); n * n];
    (0..n).for_each(|i| series[i * n + i] = series[i * n + i] + Interval::point(1.0));
    Some(times_point(&series, rough, n))
}

/// M·N for matrices of intervals.
pub(super) fn times(a: &[Interval], b: &[Interval], n: usize) -> Vec<Interval> {
    count_cube(n);
    let mut out = vec![Interval::ZERO; n * n];
    for (row, to) in a.chunks_exact(n).zip(out.chunks_exact_mut(n)) {
        for (&x, of) in row.iter().zip(b.chunks_exact(n)) {
            if x.is_zero() {
                continue;
            }
            to.iter_mut().zip(of).for_each(|(sum, &y)| *sum = *sum + x * y);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_of_a_rotation_is_contained() {
        let (c, s) = (0.6, 0.8);
        let q = [c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0];
        let inverse = inverse(&q, &transpose(&q, 3), 3).expect("nearly orthogonal");
        let product = times_point(&inverse, &q, 3);
        for (i, x) in product.iter().enumerate() {
            let one = if i / 3 == i % 3 { 1.0 } else { 0.0 };
            assert!(x.contains(one) && x.width() < 3e-14, "{x}");
        }
        assert!(super::inverse(&[1.0, 1.0, 0.0, 1.0], &identity(2), 2).is_none());
        let m = [1.0, 2.0, 0.0, 0.0, 3.0, 1.0, 5.0, 0.0, 1.0];
        let rough = rough_inverse(&m, 3).expect("regular");
        let product = times_point(&super::inverse(&m, &rough, 3).expect("regular"), &m, 3);
        assert!(product.iter().enumerate().all(|(i, x)| x.contains(if i % 4 == 0 { 1.0 } else { 0.0 })));
        assert!(rough_inverse(&[1.0, 2.0, 2.0, 4.0], 2).is_none());
    }

    #[test]
    fn columns_are_orthonormal_also_of_singular_matrices() {
        for m in
            [[1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 1.0, 1.0, 1.0], [0.0; 9], [1.0, 1e-9, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0]]
        {
            let q = orthogonal(&m, &[1.0, 2.0, 0.5], 3);
            assert!(inverse(&q, &transpose(&q, 3), 3).is_some(), "{q:?}");
        }
    }
}
