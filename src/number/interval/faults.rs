//! Mistakes that tests can make on purpose, to see that they are noticed. Tests of other crates make them, too: so they are
//! there in every build with debug assertions, and in no other.

#[cfg(any(test, debug_assertions))]
thread_local! {
    /// Round to nearest, and take elementary functions for exact.
    pub static NEAREST: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
    /// Forget the terms of a product of models beyond their last order.
    pub static NO_TAIL: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
    /// Forget the remainder of the series of a function of a model.
    pub static NO_LAGRANGE: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
    /// Take what sums of two numbers are rounded to for exact.
    pub static EXACT_PAIRS: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
    /// Forget the second numbers of coefficients where there is no room for them.
    pub static LOST_LOW: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

#[cfg(any(test, debug_assertions))]
pub(super) fn nearest() -> bool {
    NEAREST.get()
}
#[cfg(any(test, debug_assertions))]
pub(super) fn no_tail() -> bool {
    NO_TAIL.get()
}
#[cfg(any(test, debug_assertions))]
pub(super) fn no_lagrange() -> bool {
    NO_LAGRANGE.get()
}
#[cfg(any(test, debug_assertions))]
pub(super) fn exact_pairs() -> bool {
    EXACT_PAIRS.get()
}
#[cfg(any(test, debug_assertions))]
pub(super) fn lost_low() -> bool {
    LOST_LOW.get()
}

/// Whether rounding is broken: no.
#[cfg(not(any(test, debug_assertions)))]
#[inline(always)]
pub(super) fn nearest() -> bool {
    false
}
#[cfg(not(any(test, debug_assertions)))]
#[inline(always)]
pub(super) fn no_tail() -> bool {
    false
}
#[cfg(not(any(test, debug_assertions)))]
#[inline(always)]
pub(super) fn no_lagrange() -> bool {
    false
}
#[cfg(not(any(test, debug_assertions)))]
#[inline(always)]
pub(super) fn exact_pairs() -> bool {
    false
}
#[cfg(not(any(test, debug_assertions)))]
#[inline(always)]
pub(super) fn lost_low() -> bool {
    false
}
