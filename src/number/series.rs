//! The recurrences of Taylor series, one per operation.
//!
//! Below, x is the result, a (and b) the argument, k ≥ 1 the order being computed, Σ without bounds runs over all products
//! of known coefficients whose orders add up to k. dx means the series of h·x′, whose coefficients are k·xₖ: in this form a
//! relation x′ = g·a′ reads dxₖ = Σ gₖ₋ⱼ·daⱼ and costs one convolution.

use super::{Instruction, Jet, NoValue, Number, Orders, Rational, Scalar, scalar::value};

/// Σ aᵢ·bₖ₋ᵢ for lo ≤ i ≤ hi, as far as both are known; slices end where the series does.
#[inline(always)]
fn sum<B: Scalar>(a: &[B], b: &[B], k: usize, lo: usize, hi: usize) -> B {
    if lo > hi {
        return B::ZERO;
    }
    match (a.get(lo..=hi), b.get(k - hi..=k - lo)) {
        (Some(a), Some(b)) => B::convolution(a, b),
        _ => partial_sum(a, b, k, lo, hi),
    }
}

/// The same where coefficients beyond the ends of the slices are 0. Terms are added in the order of the full sum, so that
/// the result does not depend on whether a zero is stored.
fn partial_sum<B: Scalar>(a: &[B], b: &[B], k: usize, lo: usize, hi: usize) -> B {
    let body = lo + (hi + 1 - lo) / 4 * 4;
    let (first, end) = (lo.max((k + 1).saturating_sub(b.len())), (hi + 1).min(a.len()));
    if end == first + 1 {
        return a[first] * b[k - first];
    }
    let mut s = [B::ZERO; 4];
    for i in first..end.min(body) {
        s[(i - lo) % 4] = s[(i - lo) % 4] + a[i] * b[k - i];
    }
    let mut sum = (s[0] + s[2]) + (s[1] + s[3]);
    for i in first.max(body)..end {
        sum = sum + a[i] * b[k - i];
    }
    sum
}

/// Coefficient k of a·b.
#[inline(always)]
fn product<B: Scalar>(a: &[B], b: &[B], k: usize) -> B {
    sum(a, b, k, 0, k)
}

/// Coefficient k ≥ 1 of a·b where one of them is constant.
#[inline(always)]
fn multiple<B: Scalar>(a: &[B], b: &[B], k: usize) -> Option<B> {
    match (a, b) {
        ([a], b) => Some(b.get(k).map_or(B::ZERO, |&b| *a * b)),
        (a, [b]) => Some(a.get(k).map_or(B::ZERO, |&a| a * *b)),
        _ => None,
    }
}

/// Coefficient k of a², with half the products.
#[inline(always)]
fn square<B: Scalar>(a: &[B], k: usize) -> B {
    let half = k.div_ceil(2);
    let mut s = if half > 0 { sum(a, a, k, 0, half - 1) } else { B::ZERO };
    s = s + s;
    if k.is_multiple_of(2) && k / 2 < a.len() {
        s = s + a[k / 2] * a[k / 2];
    }
    s
}

/// Coefficient k of a/b from the coefficients of x = a/b below k.
#[inline(always)]
fn quotient<B: Scalar>(a: B, b: &[B], x: &[B], k: usize) -> B {
    (a - sum(b, x, k, 1, k)) / b[0]
}

/// k as a number of the base.
#[inline(always)]
fn int<B: Scalar>(k: usize) -> B {
    B::integer(k as i32)
}

/// Splits the companions into `N` series.
#[inline(always)]
fn split<B, const N: usize>(companions: &mut [B], room: usize) -> [&mut [B]; N] {
    let mut chunks = companions.chunks_exact_mut(room);
    // `reserve(N)` has made room for N chunks.
    std::array::from_fn(|_| chunks.next().unwrap_or_default())
}

/// What [`turn`] starts from: both arguments times a power of two, which keeps the squares in range, and the square of the radius.
#[inline(always)]
fn turn_from<B: Scalar>([v, _, u, _, r, _]: [&mut [B]; 6], y: &Jet<B>, x: &Jet<B>, scale: B) {
    (v[0], u[0]) = (y.series[0] * scale, x.series[0] * scale);
    r[0] = v[0] * v[0] + u[0] * u[0];
}

/// Coefficient k of dθ for the angle θ of (x, y): (x² + y²)·dθ = x·dy − y·dx.
#[inline(always)]
fn turn<B: Scalar>([v, dv, u, du, r, dt]: [&mut [B]; 6], y: &Jet<B>, x: &Jet<B>, scale: B, k: usize) -> B {
    (v[k], u[k]) = (y.coefficient(k) * scale, x.coefficient(k) * scale);
    (dv[k], du[k]) = (int::<B>(k) * v[k], int::<B>(k) * u[k]);
    let (ny, nx) = (y.length.min(k + 1), x.length.min(k + 1));
    r[k] = square(&v[..ny], k) + square(&u[..nx], k);
    let turn = sum(&dv[..ny], &u[..nx], k, 1, k) - sum(&du[..nx], &v[..ny], k, 1, k);
    dt[k] = (turn - sum(dt, r, k, 1, k - 1)) / r[0];
    dt[k]
}

/// The first k + 1 coefficients of a companion.
#[inline(always)]
fn upto<B>(series: &[B], k: usize) -> &[B] {
    &series[..=k]
}

impl<B: Scalar> Jet<B> {
    /// Coefficient k of a result whose arguments are constant: 0, without a look at slopes that may not exist.
    #[inline]
    fn rest(&mut self, k: usize) -> Result<(), NoValue> {
        let room = self.series.len();
        for companion in self.companions.chunks_exact_mut(room) {
            companion[k] = B::ZERO;
        }
        self.put(k, B::ZERO)
    }

    /// x = f(a) where dx = w·da and w follows from x: exp (w = x), tan (w = 1 + x²), tanh (w = 1 − x²).
    #[inline(always)]
    fn by_slope(&mut self, cx: &Orders, a: &Jet<B>, w: impl Fn(&[B], usize) -> B) -> Result<(), NoValue> {
        self.reserve(2);
        let room = self.series.len();
        if cx.from() == 0 {
            self.companions[room] = w(&self.series[..1], 0);
        }
        for k in cx.recurrent() {
            if a.is_constant() {
                self.rest(k)?;
                continue;
            }
            let [da, ws] = split(&mut self.companions, room);
            da[k] = int::<B>(k) * a.coefficient(k);
            let x = sum(&da[..a.length.min(k + 1)], ws, k, 1, k) / int(k);
            self.put(k, x)?;
            let [_, ws] = split(&mut self.companions, room);
            ws[k] = w(&self.series[..=k], k);
        }
        Ok(())
    }

    /// The pair of sin and cos (σ = −1) or sinh and cosh (σ = 1): x is the first (`odd`) or the second of them.
    ///
    /// dx = y·da and dy = σ·x·da for the odd one; dx = σ·y·da and dy = x·da for the even one.
    #[inline(always)]
    fn paired(&mut self, cx: &Orders, a: &Jet<B>, partner: B, odd: bool, negative: bool) -> Result<(), NoValue> {
        self.reserve(2);
        let room = self.series.len();
        if cx.from() == 0 {
            self.companions[room] = partner.checked()?;
        }
        for k in cx.recurrent() {
            if a.is_constant() {
                self.rest(k)?;
                continue;
            }
            let [da, y] = split(&mut self.companions, room);
            da[k] = int::<B>(k) * a.coefficient(k);
            let da = &da[..a.length.min(k + 1)];
            let mut x = sum(da, y, k, 1, k) / int(k);
            let mut other = sum(da, &self.series[..k], k, 1, k) / int(k);
            if negative {
                if odd { other = -other } else { x = -x }
            }
            y[k] = other;
            self.put(k, x)?;
        }
        Ok(())
    }

    /// x = ±arcsin a + constant, with w = √(1 − a²): w·dx = ±da, dw = −a·(±dx).
    #[inline(always)]
    fn by_arcsine(&mut self, cx: &Orders, a: &Jet<B>, negative: bool) -> Result<(), NoValue> {
        self.reserve(2);
        let room = self.series.len();
        if cx.from() == 0 {
            let (one, a) = (int::<B>(1), a.coefficient(0));
            self.companions[room] = value(B::sqrt, (one - a) * (one + a));
        }
        for k in cx.recurrent() {
            if a.is_constant() {
                self.rest(k)?;
                continue;
            }
            let [dx, w] = split(&mut self.companions, room);
            dx[k] = (int::<B>(k) * a.coefficient(k) - sum(dx, w, k, 1, k - 1)) / w[0];
            w[k] = -sum(upto(dx, k), a.coefficients(), k, 1, k) / int(k);
            let x = dx[k] / int(k);
            self.put(k, if negative { -x } else { x })?;
        }
        Ok(())
    }

    /// x with w·dx = right side, where w(k) and right(k) yield coefficients: ln (w = a) and arctan (w = 1 + a²).
    #[inline(always)]
    fn by_quotient(&mut self, cx: &Orders, a: &Jet<B>, w: impl Fn(&[B], usize) -> B) -> Result<(), NoValue> {
        self.reserve(2);
        let room = self.series.len();
        if cx.from() == 0 {
            self.companions[room] = w(&a.series[..1], 0);
        }
        for k in cx.recurrent() {
            if a.is_constant() {
                self.rest(k)?;
                continue;
            }
            let [dx, ws] = split(&mut self.companions, room);
            ws[k] = w(a.coefficients(), k);
            dx[k] = (int::<B>(k) * a.coefficient(k) - sum(dx, ws, k, 1, k - 1)) / ws[0].checked()?;
            let x = dx[k] / int(k);
            self.put(k, x)?;
        }
        Ok(())
    }

    /// The orders of a product, from 0 on or with factors that end early.
    #[inline(never)]
    fn several_products(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.mul(&(), &a.series[0], &b.series[0]))?;
        for k in cx.recurrent() {
            let (a, b) = (a.coefficients(), b.coefficients());
            self.put(k, multiple(a, b, k).unwrap_or_else(|| product(a, b, k)))?;
        }
        Ok(())
    }

    /// Coefficient k of aⁿ for n ≥ 2 (`invert`: of its reciprocal) by the squarings and products of repeated squaring,
    /// each of which is a companion series. Never divides by a₀, so that polynomials stay exact at 0.
    fn power(&mut self, a: &Jet<B>, n: u32, invert: bool, k: usize) -> B {
        let room = self.series.len();
        // Companion in which a series lies; None: the argument itself.
        let (mut base, mut acc): (Option<usize>, Option<Option<usize>>) = (None, None);
        let mut next = 0;
        let last = if invert { usize::MAX } else { companions_of_power(n) - 1 };
        let top = n.ilog2();
        for bit in 0..=top {
            if bit > 0 {
                let c = match base {
                    None => square(a.coefficients(), k),
                    Some(i) => square(&self.companions[i * room..=i * room + k], k),
                };
                if next == last {
                    return c;
                }
                self.companions[next * room + k] = c;
                base = Some(next);
                next += 1;
            }
            if n >> bit & 1 == 1 {
                let Some(left) = acc else {
                    acc = Some(base);
                    continue;
                };
                let series = |i: Option<usize>| match i {
                    None => a.coefficients(),
                    Some(i) => &self.companions[i * room..=i * room + k],
                };
                let c = product(series(left), series(base), k);
                if next == last {
                    return c;
                }
                self.companions[next * room + k] = c;
                acc = Some(Some(next));
                next += 1;
            }
        }
        let start = acc.flatten().unwrap_or(0) * room;
        let p = &self.companions[start..=start + k];
        if k == 0 { int::<B>(1) / p[0] } else { quotient(B::ZERO, p, &self.series[..k], k) }
    }
}

/// Number of series that aⁿ, n ≥ 2, goes through: squarings and products.
fn companions_of_power(n: u32) -> usize {
    (n.ilog2() + n.count_ones() - 1) as usize
}

impl<B: Scalar> Number for Jet<B> {
    type Context = Orders;

    // In one place, so that the recurrences become part of the loop.
    #[inline(never)]
    fn run(orders: &Orders, values: &mut [Self], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
        B::run_series(orders, values, missing, steps);
    }
    // A coefficient of a product is a sum of as many products as its order tells.
    fn work(orders: &Orders) -> u64 {
        let up_to = |k: usize| (k * (k + 1) / 2) as u64;
        let products = up_to(orders.to() + 1) - up_to(orders.from());
        8 + products * (2 + size_of::<B>() as u64 / 16) / 4
    }
    fn blank(cx: &Orders) -> Jet<B> {
        Jet::constant(B::ZERO, cx)
    }
    fn rational(&mut self, _: &Orders, r: &Rational) -> Result<(), NoValue> {
        self.length = 1;
        self.series[0].rational(&(), r)
    }
    fn pi(&mut self, _: &Orders) -> Result<(), NoValue> {
        self.length = 1;
        self.series[0].pi(&())
    }
    fn restrict(&mut self, cx: &Orders, a: &Jet<B>, _: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| {
            *x = a.series[0];
            Ok(())
        })?;
        for k in cx.recurrent() {
            self.put(k, a.coefficient(k))?;
        }
        Ok(())
    }
    fn powi(&mut self, cx: &Orders, a: &Jet<B>, n: i32) -> Result<(), NoValue> {
        self.start(cx, |x| x.powi(&(), &a.series[0], n))?;
        let m = n.unsigned_abs();
        if m >= 2 && n != 2 {
            self.reserve(companions_of_power(m));
            if cx.from() == 0 {
                self.power(a, m, n < 0, 0);
            }
        }
        for k in cx.recurrent() {
            if a.is_constant() {
                self.rest(k)?;
                continue;
            }
            let x = match n {
                0 => B::ZERO,
                1 => a.coefficient(k),
                2 => square(a.coefficients(), k),
                -1 => quotient(B::ZERO, a.coefficients(), &self.series[..k], k),
                _ => self.power(a, m, n < 0, k),
            };
            self.put(k, x)?;
        }
        Ok(())
    }
    #[inline]
    fn neg(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.neg(&(), &a.series[0]))?;
        for k in cx.recurrent() {
            self.put(k, -a.coefficient(k))?;
        }
        Ok(())
    }
    /// x² = a.
    fn sqrt(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.sqrt(&(), &a.series[0]))?;
        for k in cx.recurrent() {
            if a.is_constant() {
                self.rest(k)?;
                continue;
            }
            // The square of x without the two products that contain xₖ.
            let known = square(&self.series[..k], k);
            let x = (a.coefficient(k) - known) / (self.series[0] + self.series[0]);
            self.put(k, x)?;
        }
        Ok(())
    }
    /// dx = x·da.
    fn exp(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.exp(&(), &a.series[0]))?;
        self.by_slope(cx, a, |x, k| x[k])
    }
    /// a·dx = da.
    fn ln(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.ln(&(), &a.series[0]))?;
        self.by_quotient(cx, a, |a, k| a.get(k).copied().unwrap_or(B::ZERO))
    }
    fn sin(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.sin(&(), &a.series[0]))?;
        let partner = if cx.from() == 0 { value(B::cos, a.series[0]) } else { B::ZERO };
        self.paired(cx, a, partner, true, true)
    }
    fn cos(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.cos(&(), &a.series[0]))?;
        let partner = if cx.from() == 0 { value(B::sin, a.series[0]) } else { B::ZERO };
        self.paired(cx, a, partner, false, true)
    }
    /// dx = (1 + x²)·da.
    fn tan(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.tan(&(), &a.series[0]))?;
        self.by_slope(cx, a, |x, k| if k == 0 { int::<B>(1) + x[0] * x[0] } else { square(x, k) })
    }
    fn arcsin(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.arcsin(&(), &a.series[0]))?;
        self.by_arcsine(cx, a, false)
    }
    fn arccos(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.arccos(&(), &a.series[0]))?;
        self.by_arcsine(cx, a, true)
    }
    /// (1 + a²)·dx = da.
    fn arctan(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.arctan(&(), &a.series[0]))?;
        self.by_quotient(cx, a, |a, k| if k == 0 { int::<B>(1) + a[0] * a[0] } else { square(a, k) })
    }
    fn sinh(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.sinh(&(), &a.series[0]))?;
        let partner = if cx.from() == 0 { value(B::cosh, a.series[0]) } else { B::ZERO };
        self.paired(cx, a, partner, true, false)
    }
    fn cosh(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.cosh(&(), &a.series[0]))?;
        let partner = if cx.from() == 0 { value(B::sinh, a.series[0]) } else { B::ZERO };
        self.paired(cx, a, partner, false, false)
    }
    /// dx = (1 − x²)·da.
    fn tanh(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.tanh(&(), &a.series[0]))?;
        // 1 − x² starts from what it is, and not from x, which may be 1 for binary64.
        let at = a.series[0];
        self.by_slope(cx, a, |x, k| if k == 0 { at.flatness(x[0]) } else { -square(x, k) })
    }
    fn abs(&mut self, cx: &Orders, a: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.abs(&(), &a.series[0]))?;
        for k in cx.recurrent() {
            self.put(k, a.series[0].sign().times(a.coefficient(k)))?;
        }
        Ok(())
    }
    #[inline]
    fn add(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        if let Some(k) = cx.single() {
            return self.put(k, a.coefficient(k) + b.coefficient(k));
        }
        self.start(cx, |x| x.add(&(), &a.series[0], &b.series[0]))?;
        for k in cx.recurrent() {
            self.put(k, a.coefficient(k) + b.coefficient(k))?;
        }
        Ok(())
    }
    #[inline]
    fn sub(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        if let Some(k) = cx.single() {
            return self.put(k, a.coefficient(k) - b.coefficient(k));
        }
        self.start(cx, |x| x.sub(&(), &a.series[0], &b.series[0]))?;
        for k in cx.recurrent() {
            self.put(k, a.coefficient(k) - b.coefficient(k))?;
        }
        Ok(())
    }
    #[inline]
    fn mul(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        if let Some(k) = cx.single() {
            if let (Some(p), Some(q)) = (a.upto(k), b.upto(k)) {
                return self.put(k, B::convolution(p, q));
            }
            if let Some(x) = multiple(a.coefficients(), b.coefficients(), k) {
                return self.put(k, x);
            }
        }
        self.several_products(cx, a, b)
    }
    /// x·b = a.
    fn div(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.div(&(), &a.series[0], &b.series[0]))?;
        for k in cx.recurrent() {
            let x = quotient(a.coefficient(k), b.coefficients(), &self.series[..k], k);
            self.put(k, x)?;
        }
        Ok(())
    }
    /// x = e^u with u = b·l, l = ln a: a·dl = da and dx = x·du.
    fn pow(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.pow(&(), &a.series[0], &b.series[0]))?;
        self.reserve(3);
        let room = self.series.len();
        for k in cx.recurrent() {
            if a.is_constant() && (b.is_constant() || a.series[0].is_zero()) {
                // 0 to a positive power stays 0.
                self.rest(k)?;
                continue;
            }
            let [dl, l, du] = split(&mut self.companions, room);
            dl[k] = (int::<B>(k) * a.coefficient(k) - sum(dl, a.coefficients(), k, 1, k - 1)) / a.series[0];
            l[k] = dl[k] / int(k);
            du[k] = if b.is_constant() {
                b.series[0] * dl[k]
            } else {
                l[0] = value(B::ln, a.series[0]);
                int::<B>(k) * product(b.coefficients(), upto(l, k), k)
            };
            let x = sum(upto(du, k), &self.series[..k], k, 1, k) / int(k);
            self.put(k, x)?;
        }
        Ok(())
    }
    /// The angle of (x, y).
    fn arctan2(&mut self, cx: &Orders, y: &Jet<B>, x: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |angle| angle.arctan2(&(), &y.series[0], &x.series[0]))?;
        self.reserve(6);
        let (room, scale) = (self.series.len(), y.series[0].scale(x.series[0]));
        if cx.from() == 0 {
            turn_from(split(&mut self.companions, room), y, x, scale);
        }
        for k in cx.recurrent() {
            if y.is_constant() && x.is_constant() {
                self.rest(k)?;
                continue;
            }
            let dx = turn(split(&mut self.companions, room), y, x, scale, k);
            self.put(k, dx / int(k))?;
        }
        Ok(())
    }
    /// The cosine x and the sine z of one angle: dx = −z·dθ, dz = x·dθ.
    fn direction_cosine(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.direction_cosine(&(), &a.series[0], &b.series[0]))?;
        self.reserve(7);
        let (room, scale) = (self.series.len(), b.series[0].scale(a.series[0]));
        if cx.from() == 0 {
            let [v, dv, u, du, r, turned, sine] = split(&mut self.companions, room);
            sine[0] = value(|z: &mut B, cx, b| z.direction_cosine(cx, b, &a.series[0]), b.series[0]);
            turn_from([v, dv, u, du, r, turned], b, a, scale);
        }
        for k in cx.recurrent() {
            if a.is_constant() && b.is_constant() {
                self.rest(k)?;
                continue;
            }
            let [v, dv, u, du, r, turned, sine] = split(&mut self.companions, room);
            turn([v, dv, u, du, r, turned], b, a, scale, k);
            let next = sum(upto(turned, k), &self.series[..k], k, 1, k) / int(k);
            // Never −0, which a lane at rest beside others that move would have, and not alone.
            let x = B::ZERO - sum(upto(turned, k), &sine[..k], k, 1, k) / int(k);
            sine[k] = next;
            self.put(k, x)?;
        }
        Ok(())
    }
    /// Only constants have higher coefficients here.
    fn agm(&mut self, cx: &Orders, a: &Jet<B>, b: &Jet<B>) -> Result<(), NoValue> {
        self.start(cx, |x| x.agm(&(), &a.series[0], &b.series[0]))?;
        for k in cx.recurrent() {
            self.put(k, if a.is_constant() && b.is_constant() { B::ZERO } else { B::INVALID })?;
        }
        Ok(())
    }
}
