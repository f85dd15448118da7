//! How a number is shown to a reader. Nothing is computed here.

/// A value with six digits: as many as a reader compares.
pub fn six(x: f64) -> String {
    let x: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    match x {
        x if x.is_nan() => "no value".to_owned(),
        x if x == 0.0 || (1e-4..1e7).contains(&x.abs()) => format!("{x}"),
        x => format!("{x:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::six;

    #[test]
    fn six_digits_are_shown() {
        let of = [9.715626709872566, 0.1 + 0.2, -2.907906170195047, 0.0, 1234567.89, 1.5e-9, f64::NAN];
        let shown = ["9.71563", "0.3", "-2.90791", "0", "1234570", "1.5e-9", "no value"];
        assert_eq!(of.map(six), shown);
    }
}
