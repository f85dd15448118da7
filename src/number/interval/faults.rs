//! Mistakes that tests can make on purpose, to see that they are noticed. Outside of tests there are none.

#[cfg(test)]
thread_local! {
    /// Round to nearest, and take elementary functions for exact.
    pub static NEAREST: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
    /// Forget the terms of a product of models beyond their last order.
    pub static NO_TAIL: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
    /// Forget the remainder of the series of a function of a model.
    pub static NO_LAGRANGE: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

#[cfg(test)]
pub(super) fn nearest() -> bool {
    NEAREST.get()
}
#[cfg(test)]
pub(super) fn no_tail() -> bool {
    NO_TAIL.get()
}
#[cfg(test)]
pub(super) fn no_lagrange() -> bool {
    NO_LAGRANGE.get()
}

/// Whether rounding is broken: no.
#[cfg(not(test))]
#[inline(always)]
pub(super) fn nearest() -> bool {
    false
}
#[cfg(not(test))]
#[inline(always)]
pub(super) fn no_tail() -> bool {
    false
}
#[cfg(not(test))]
#[inline(always)]
pub(super) fn no_lagrange() -> bool {
    false
}
