//! Mistakes that tests make on purpose, to see that a verdict would then be wrong. Outside of tests there are none.

macro_rules! faults {
    ($($(#[$says:meta])* $name:ident, $read:ident;)*) => {
        $(
            #[cfg(test)]
            thread_local! {
                $(#[$says])*
                pub static $name: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
            }

            #[inline(always)]
            pub(super) fn $read() -> bool {
                #[cfg(test)]
                return $name.get();
                #[cfg(not(test))]
                false
            }
        )*
    };
}

faults! {
    /// Take every formula for one that has a value everywhere.
    NO_DOMAIN, no_domain;
    /// Take < for ≤, and > for ≥.
    WEAK, weak;
    /// Take the first derivative at an end for 0, whatever it is.
    TOO_FLAT, too_flat;
    /// Take a zero for verified although Krawczyk's operator does not map into the interior, but only meets the part.
    NO_INCLUSION, no_inclusion;
}
