//! Mistakes that tests can make on purpose, to see that they are noticed. Outside of tests there are none.

#[cfg(test)]
thread_local! {
    /// Round to nearest, and take elementary functions for exact.
    pub static NEAREST: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

/// Whether rounding is broken.
#[cfg(test)]
pub(super) fn nearest() -> bool {
    NEAREST.get()
}

/// Whether rounding is broken: no.
#[cfg(not(test))]
#[inline(always)]
pub(super) fn nearest() -> bool {
    false
}
