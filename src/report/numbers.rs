//! How numbers are written. Nothing is computed here.

/// A value with every digit that it has: 0.25, 12, 3.5e-14.
pub(super) fn value(x: f64) -> String {
    let plain = x == 0.0 || (1e-4..1e7).contains(&x.abs());
    if x.is_nan() {
        "no value".to_owned()
    } else if plain {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// A value with six digits: as many as a reader compares.
pub(super) fn six(x: f64) -> String {
    reason::short(&x)
}

/// Both sides of a relation with six digits each; with all of them, where six do not tell them apart.
pub(super) fn both(left: f64, right: f64) -> (String, String) {
    let (short, long) = ((six(left), six(right)), (value(left), value(right)));
    if short.0 == short.1 && long.0 != long.1 { long } else { short }
}

/// A size, of which two digits are enough: 1.2e-14, 0.25.
pub(super) fn size(x: f64) -> String {
    match x {
        0.0 => "0".to_owned(),
        x if x.is_nan() => "no value".to_owned(),
        x => value(format!("{x:.1e}").parse().unwrap_or(x)),
    }
}

/// A time.
pub(super) fn time(x: f64) -> String {
    six(x)
}

/// `1 claim`, `2 claims`.
pub(super) fn count(n: usize, what: &str) -> String {
    if n == 1 { format!("1 {what}") } else { format!("{n} {}", plural(what)) }
}

fn plural(what: &str) -> String {
    match what.strip_suffix('y') {
        Some(stem) if !what.ends_with("ey") => format!("{stem}ies"),
        _ => format!("{what}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_whole() {
        assert_eq!(value(0.1), "0.1");
        assert_eq!(value(-12.0), "-12");
        assert_eq!(value(1.25e-9), "1.25e-9");
        assert_eq!(value(f64::NAN), "no value");
        assert_eq!(value(f64::INFINITY), "inf");
        assert_eq!(six(2.907906170195047), "2.90791");
        assert_eq!(six(f64::NAN), "no value");
        assert_eq!(both(0.1 + 0.2, 0.4), ("0.3".to_owned(), "0.4".to_owned()));
        assert_eq!(both(1.00000001, 1.0), ("1.00000001".to_owned(), "1".to_owned()));
        assert_eq!(size(0.0), "0");
        assert_eq!(size(1.234e-14), "1.2e-14");
        assert_eq!(size(12.345), "12");
        assert_eq!(size(0.99999), "1");
        assert_eq!(time(0.1 + 0.2), "0.3");
        assert_eq!(count(1, "trajectory"), "1 trajectory");
        assert_eq!(count(2, "trajectory"), "2 trajectories");
    }
}
