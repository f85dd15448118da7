//! The sums of a step: how far it moves each component, and the slope at its end; and how far a part of it does.
//!
//! **In:** coefficients, order by order, and the length of a step. **Out:** the sums of each component, by Horner's rule. They are work
//! for the widest registers: some components at a time, whose sums stay in registers.

use super::ABREAST;
use number::Work;

/// c₁ + c₂h + … of each component, and c₁ + 2c₂h + …, from the coefficients order by order.
pub(super) struct Sums<'w> {
    pub(super) orders: &'w [f64],
    pub(super) h: f64,
    pub(super) sums: &'w mut [f64],
    pub(super) slopes: &'w mut [f64],
}

/// The first of these sums alone.
pub(in super::super) struct Moved<'w> {
    pub(in super::super) orders: &'w [f64],
    pub(in super::super) h: f64,
    pub(in super::super) sums: &'w mut [f64],
}

impl Work for Sums<'_> {
    type Output = ();
    #[inline(always)]
    fn work(self) {
        let Sums { orders, h, sums, slopes } = self;
        all::<true>(orders, h, sums, slopes);
    }
}

impl Work for Moved<'_> {
    type Output = ();
    #[inline(always)]
    fn work(self) {
        all::<false>(self.orders, self.h, self.sums, &mut []);
    }
}

/// The sums, and the slopes if they are asked for.
#[inline(always)]
fn all<const SLOPES: bool>(orders: &[f64], h: f64, sums: &mut [f64], slopes: &mut [f64]) {
    let n = sums.len();
    // Some components at a time, whose sums stay in registers.
    let mut some = 0;
    while some + 2 * ABREAST <= n {
        of::<{ 2 * ABREAST }, SLOPES>(orders, (n, some), h, sums, slopes);
        some += 2 * ABREAST;
    }
    while some + ABREAST <= n {
        of::<ABREAST, SLOPES>(orders, (n, some), h, sums, slopes);
        some += ABREAST;
    }
    while some < n {
        of::<1, SLOPES>(orders, (n, some), h, sums, slopes);
        some += 1;
    }
}

/// The same of `N` components of `n`, the first of which is `from`.
#[inline(always)]
fn of<const N: usize, const SLOPES: bool>(
    orders: &[f64],
    (n, from): (usize, usize),
    h: f64,
    sums: &mut [f64],
    slopes: &mut [f64],
) {
    let (mut sum, mut slope) = ([0.0; N], [0.0; N]);
    let mut k = (orders.len() / n) as f64;
    for c in orders.chunks_exact(n).skip(1).rev() {
        let Some(c) = c[from..].first_chunk::<N>() else { return };
        k -= 1.0;
        for i in 0..N {
            sum[i] = sum[i] * h + c[i];
            if SLOPES {
                slope[i] = slope[i] * h + c[i] * k;
            }
        }
    }
    sums[from..from + N].copy_from_slice(&sum);
    if SLOPES {
        slopes[from..from + N].copy_from_slice(&slope);
    }
}
