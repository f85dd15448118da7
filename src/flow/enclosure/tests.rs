//! The comparison with closed forms must notice every mistake that an enclosure could rest on.

#[path = "../../../tests/enclosure_support/mod.rs"]
mod enclosure_support;

use super::set::faults::{LOST_DIRECTIONS, LOST_LOW, NO_REMAINDER, NO_ROTATION, SHORT_SERIES};
use enclosure_support::CASES;
#[cfg(debug_assertions)]
use number::interval_faults::NEAREST;
use std::cell::Cell;
use std::thread::LocalKey;

/// Switches a mistake on, and off again however the test ends.
struct Broken(&'static LocalKey<Cell<bool>>);

impl Broken {
    fn new(what: &'static LocalKey<Cell<bool>>) -> Broken {
        what.set(true);
        Broken(what)
    }
}

impl Drop for Broken {
    fn drop(&mut self) {
        self.0.set(false);
    }
}

/// The cases in which a mistake puts the truth outside.
fn noticed(what: &'static LocalKey<Cell<bool>>) -> Vec<&'static str> {
    let _broken = Broken::new(what);
    let found = |case: &enclosure_support::Case| {
        let (_, outside) = case.compare(200, 7);
        (outside > 0).then_some(case.name)
    };
    CASES.iter().filter_map(found).collect()
}

#[test]
fn nothing_is_outside_as_long_as_nothing_is_broken() {
    for case in &CASES {
        assert_eq!(case.compare(200, 7).1, 0, "{}", case.name);
    }
}

#[cfg(debug_assertions)]
#[test]
fn rounding_to_nearest_is_noticed() {
    let found = noticed(&NEAREST);
    // Where steps are limited by what a model leaves out, that covers rounding.
    for name in ["tanh", "driven", "rigid body", "Kepler"] {
        assert!(found.contains(&name), "{name} not in {found:?}");
    }
}

#[test]
fn a_missing_remainder_is_noticed() {
    // Remainders are usually below rounding. Where series are so short that they are not, they make up for it.
    let _short = Broken::new(&SHORT_SERIES);
    for case in &CASES {
        assert_eq!(case.compare(200, 7).1, 0, "{}", case.name);
    }
    let found = noticed(&NO_REMAINDER);
    for name in ["decay", "oscillator", "tanh", "sech, on the separatrix", "rigid body"] {
        assert!(found.contains(&name), "{name} not in {found:?}");
    }
}

#[test]
fn errors_along_wrong_directions_are_noticed() {
    // Errors are usually below rounding, too small to be missed.
    let _short = Broken::new(&SHORT_SERIES);
    let found = noticed(&LOST_DIRECTIONS);
    assert!(found.contains(&"oscillator") && found.contains(&"rigid body"), "{found:?}");
}

/// What the centre loses when it is rounded to binary64 is below the width of the result at one step, not at many.
#[test]
fn a_centre_that_loses_its_second_part_is_noticed() {
    let found = noticed(&LOST_LOW);
    for name in ["oscillator", "rigid body"] {
        assert!(found.contains(&name), "{name} not in {found:?}");
    }
}

/// Boxes that do not turn are right, and become too wide: this is what directions are for.
#[test]
fn boxes_that_do_not_turn_become_too_wide() {
    let case = CASES.iter().find(|c| c.name == "oscillator").expect("there");
    let turning = case.final_width(&[1.0, 0.0], 1e-6);
    assert!(turning < 1e-5, "{turning:e}");
    // Errors that are large enough to be seen.
    let _short = Broken::new(&SHORT_SERIES);
    assert!(case.reaches_the_end(&[1.0, 0.0]));
    let _broken = Broken::new(&NO_ROTATION);
    assert!(!case.reaches_the_end(&[1.0, 0.0]));
}
