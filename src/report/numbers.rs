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

/// A value with six digits: as many as a reader compares. What goes into a formula or a file needs [`ascii_six`].
pub(super) fn six(x: f64) -> String {
    read(&ascii_six(x))
}

/// Both sides of a relation with six digits each; with all of them, where six do not tell them apart.
pub(super) fn both(left: f64, right: f64) -> (String, String) {
    let (left, right) = ascii_both(left, right);
    (read(&left), read(&right))
}

/// The same, as programs and formulas read them.
pub(super) fn ascii_both(left: f64, right: f64) -> (String, String) {
    let (short, long) = ((ascii_six(left), ascii_six(right)), (value(left), value(right)));
    if short.0 == short.1 && long.0 != long.1 { long } else { short }
}

/// A size, of which two digits are enough: 1.2·10⁻¹⁴, 0.25.
pub(super) fn size(x: f64) -> String {
    read(&ascii_size(x))
}

/// A time, with six digits.
pub(super) fn time(x: f64) -> String {
    six(x)
}

/// A value with six digits, as programs and formulas read it.
pub(super) fn ascii_six(x: f64) -> String {
    reason::short(&x)
}

/// A size, of which two digits are enough, as programs and formulas read it.
pub(super) fn ascii_size(x: f64) -> String {
    match x {
        0.0 => "0".to_owned(),
        x if x.is_nan() => "no value".to_owned(),
        x => value(format!("{x:.1e}").parse().unwrap_or(x)),
    }
}

/// A number that is written for a program, as it is read in a text: `−0.25` for `-0.25`, `1.2·10⁻¹⁴` for `1.2e-14`.
pub(super) fn read(written: &str) -> String {
    let (sign, size) = written.strip_prefix('-').map_or(("", written), |size| ("−", size));
    let Some((digits, power)) = size.split_once('e').filter(|(_, power)| power.parse::<i32>().is_ok()) else {
        return format!("{sign}{size}");
    };
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize).unwrap_or(c),
        None => '⁻',
    };
    let power: String = power.trim_start_matches('+').chars().map(raised).collect();
    if digits == "1" { format!("{sign}10{power}") } else { format!("{sign}{digits}·10{power}") }
}

/// A text in which the numbers stand as they are read: a word that is a number, or one between brackets.
pub(super) fn retold(text: &str) -> String {
    let is_part = |c: char| c.is_ascii_digit() || "-+.e".contains(c);
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut before = ' ';
    while let Some(c) = rest.chars().next() {
        let begins = matches!(before, ' ' | '(' | '[' | '\u{a0}' | '\n') && (c.is_ascii_digit() || c == '-');
        let end = if begins { rest.find(|c| !is_part(c)).unwrap_or(rest.len()) } else { 0 };
        // A full stop or a stroke at its end is none of the number's.
        let word = rest[..end].trim_end_matches(['.', '-', '+', 'e']);
        let follows = rest[word.len()..].chars().next();
        let is_number =
            word.parse::<f64>().is_ok() && !follows.is_some_and(|c| c.is_alphanumeric() || "-_/".contains(c));
        if is_number {
            out.push_str(&read(word));
            rest = &rest[word.len()..];
            before = '0';
        } else {
            out.push(c);
            rest = &rest[c.len_utf8()..];
            before = c;
        }
    }
    out
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
        assert_eq!((size(1.234e-14), ascii_size(1.234e-14)), ("1.2·10⁻¹⁴".to_owned(), "1.2e-14".to_owned()));
        assert_eq!(
            (six(-1e-5), six(-0.25), ascii_six(-0.25)),
            ("−10⁻⁵".to_owned(), "−0.25".to_owned(), "-0.25".to_owned())
        );
        assert_eq!(size(12.345), "12");
        assert_eq!(size(0.99999), "1");
        assert_eq!((time(0.1 + 0.2), time(2.326327123456)), ("0.3".to_owned(), "2.32633".to_owned()));
        assert_eq!(time(2.326327123456), "2.32633");
        assert_eq!(count(1, "motion"), "1 motion");
        assert_eq!(count(2, "family"), "2 families");
    }

    #[test]
    fn numbers_in_a_text_are_read() {
        for (text, told) in [
            ("lies in [-1.39e-13, 1.38e-13], on", "lies in [−1.39·10⁻¹³, 1.38·10⁻¹³], on"),
            ("t = -2.", "t = −2."),
            ("up to 1e-9.", "up to 10⁻⁹."),
            ("t15-2, a-1, 2023-04 and 3-4", "t15-2, a-1, 2023-04 and 3-4"),
            ("arXiv:2302.04190, --all, 1e, 2E", "arXiv:2302.04190, --all, 1e, 2E"),
        ] {
            assert_eq!(retold(text), told);
        }
    }
}
