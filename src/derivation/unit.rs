//! Units of measurement, as text and as what is compared.
//!
//! **In:** a text such as `kg m^2/s^2`. **Out:** a [`Unit`]: powers of the SI base units, and the factor between it and them,
//! both exact; or why the text is not understood. **Guaranteed:** nothing is guessed: `J/mol K`, of which readers disagree, is
//! refused. An angle has the dimension of a number: rad is 1, and a degree is π/180.
//!
//! Symbols and values follow the SI brochure (9th edition, 2019), with the units that it accepts beside its own.

use std::collections::BTreeMap;
use std::fmt;

use expr::Rational;

/// The base units, in the order in which they are written.
const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// A unit with a name: symbol, whether it takes prefixes, its value as a unit that was named before it.
const NAMED: &[(&str, bool, &str)] = &[
    ("rad", true, "1"),
    ("sr", true, "1"),
    ("Hz", true, "1/s"),
    ("N", true, "kg m/s^2"),
    ("Pa", true, "N/m^2"),
    ("J", true, "N m"),
    ("W", true, "J/s"),
    ("C", true, "A s"),
    ("V", true, "W/A"),
    ("F", true, "C/V"),
    ("ohm", true, "V/A"),
    ("Ω", true, "V/A"),
    ("S", true, "A/V"),
    ("Wb", true, "V s"),
    ("T", true, "Wb/m^2"),
    ("H", true, "Wb/A"),
    ("lm", true, "cd sr"),
    ("lx", true, "lm/m^2"),
    ("Bq", true, "1/s"),
    ("Gy", true, "J/kg"),
    ("Sv", true, "J/kg"),
    ("kat", true, "mol/s"),
    ("eV", true, "1.602176634e-19 J"),
    ("bar", true, "1e5 Pa"),
    ("L", true, "1e-3 m^3"),
    ("l", true, "1e-3 m^3"),
    ("t", true, "1e3 kg"),
    ("min", false, "60 s"),
    ("h", false, "3600 s"),
    ("d", false, "86400 s"),
    ("ha", false, "1e4 m^2"),
    ("au", false, "149597870700 m"),
];

/// Prefixes and their powers of ten.
const PREFIXES: &[(&str, i64)] = &[
    ("da", 1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
    ("P", 15),
    ("E", 18),
    ("Z", 21),
    ("Y", 24),
    ("R", 27),
    ("Q", 30),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("µ", -6),
    ("μ", -6),
    ("u", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
    ("a", -18),
    ("z", -21),
    ("y", -24),
    ("r", -27),
    ("q", -30),
];

/// Largest exponent that can be written.
const LARGEST_POWER: i64 = 99;

/// A unit: a product of powers of base units, times a factor.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Unit {
    /// Exponents of the base units, by their position in [`BASE`]; none is zero.
    dimension: BTreeMap<usize, Rational>,
    /// Exponents of the prime numbers in the factor to the base units, with 0 for π; none is zero.
    factor: BTreeMap<u64, Rational>,
}

fn scaled<K: Ord + Copy>(powers: &BTreeMap<K, Rational>, by: &Rational) -> BTreeMap<K, Rational> {
    if *by == Rational::ZERO {
        return BTreeMap::new();
    }
    powers.iter().map(|(&k, p)| (k, p.clone() * by.clone())).collect()
}

fn joined<K: Ord + Copy>(a: &BTreeMap<K, Rational>, b: &BTreeMap<K, Rational>) -> BTreeMap<K, Rational> {
    let mut out = a.clone();
    for (&k, p) in b {
        let power = out.entry(k).or_insert(Rational::ZERO);
        *power = power.clone() + p.clone();
    }
    out.retain(|_, p| *p != Rational::ZERO);
    out
}

impl Unit {
    /// The unit of a number.
    pub fn one() -> Unit {
        Unit::default()
    }

    /// The product of two units.
    pub fn times(&self, other: &Unit) -> Unit {
        Unit { dimension: joined(&self.dimension, &other.dimension), factor: joined(&self.factor, &other.factor) }
    }

    /// A power of the unit.
    pub fn power(&self, exponent: &Rational) -> Unit {
        Unit { dimension: scaled(&self.dimension, exponent), factor: scaled(&self.factor, exponent) }
    }

    /// The unit over another.
    pub fn over(&self, other: &Unit) -> Unit {
        self.times(&other.power(&Rational::from(-1)))
    }

    /// Whether both measure the same kind of quantity, perhaps with another factor.
    pub fn is_alike(&self, other: &Unit) -> bool {
        self.dimension == other.dimension
    }

    /// Whether it is the unit of a number, or a multiple of it, such as a degree.
    pub fn is_number(&self) -> bool {
        self.dimension.is_empty()
    }

    /// The factor to the base units where it is a fraction of whole numbers, and the unit without it.
    pub fn taken_apart(&self) -> Option<(Rational, Unit)> {
        let mut factor = Rational::ONE;
        for (&prime, power) in &self.factor {
            let power = i64::try_from(power.clone()).ok().filter(|n| prime > 0 && n.abs() <= 64)?;
            for _ in 0..power.abs() {
                let prime = Rational::from(prime);
                factor = if power > 0 { factor * prime } else { factor / prime };
            }
        }
        Some((factor, Unit { dimension: self.dimension.clone(), factor: BTreeMap::new() }))
    }

    /// Whether it is a product of powers of base units, without a factor.
    pub fn is_coherent(&self) -> bool {
        self.factor.is_empty()
    }

    /// Exponents of the base units kg, m, s, A, K, mol, cd.
    pub fn exponents(&self) -> [f64; 7] {
        std::array::from_fn(|i| self.dimension.get(&i).map_or(0.0, |p| p.to_f64().value()))
    }

    /// The unit that a text means.
    ///
    /// # Errors
    /// What is not understood, in a sentence.
    pub fn parse(text: &str) -> Result<Unit, String> {
        let mut reader = Reader { rest: text.trim() };
        if reader.rest.is_empty() {
            return Err("an empty unit; write 1 for a number".to_owned());
        }
        let unit = reader.quotient(0)?;
        match reader.rest.chars().next() {
            None => Ok(unit),
            Some(c) => Err(format!("`{c}` does not belong into a unit")),
        }
    }

    /// A whole number, or a decimal one, as a unit without dimension.
    fn number(text: &str) -> Option<Unit> {
        let value = super::number::exact(text).filter(|r| *r > Rational::ZERO)?;
        let mut unit = Unit::one();
        for (part, sign) in [(value.numerator().clone(), 1), (value.denominator().clone().into(), -1)] {
            let mut left = u128::try_from(part).ok()?;
            let mut prime = 2_u64;
            while left > 1 {
                if u128::from(prime) * u128::from(prime) > left {
                    prime = u64::try_from(left).ok()?;
                }
                while left.is_multiple_of(u128::from(prime)) {
                    left /= u128::from(prime);
                    let power = unit.factor.entry(prime).or_insert(Rational::ZERO);
                    *power = power.clone() + Rational::from(sign);
                }
                prime += 1;
                // What is left has only large factors: a number that nobody measures in.
                if prime > 1_000_000 && left > 1 {
                    return None;
                }
            }
        }
        Some(unit)
    }

    fn ten(power: i64) -> Unit {
        let factor = [2, 5].into_iter().map(|p| (p, Rational::from(power))).collect();
        Unit { dimension: BTreeMap::new(), factor: if power == 0 { BTreeMap::new() } else { factor } }
    }

    /// A unit by its symbol, without a prefix.
    fn base(symbol: &str) -> Option<(Unit, bool)> {
        if symbol == "g" {
            return Unit::base("kg").map(|(kg, _)| (kg.times(&Unit::ten(-3)), true));
        }
        if matches!(symbol, "deg" | "°") {
            let mut degree = Unit::number("180")?.power(&Rational::from(-1));
            degree.factor.insert(0, Rational::ONE);
            return Some((degree, false));
        }
        if let Some(at) = BASE.iter().position(|b| *b == symbol) {
            let dimension = [(at, Rational::ONE)].into_iter().collect();
            return Some((Unit { dimension, factor: BTreeMap::new() }, symbol != "kg"));
        }
        let (_, prefixes, value) = NAMED.iter().find(|(name, ..)| *name == symbol)?;
        Unit::parse(value).ok().map(|unit| (unit, *prefixes))
    }

    /// A unit by its symbol.
    fn named(symbol: &str) -> Option<Unit> {
        if let Some((unit, _)) = Unit::base(symbol) {
            return Some(unit);
        }
        PREFIXES.iter().find_map(|(prefix, power)| match Unit::base(symbol.strip_prefix(prefix)?) {
            Some((unit, true)) => Some(unit.times(&Unit::ten(*power))),
            _ => None,
        })
    }
}

/// Reads a text from the left.
struct Reader<'t> {
    rest: &'t str,
}

impl<'t> Reader<'t> {
    fn skip(&mut self, what: &str) -> bool {
        match self.rest.trim_start().strip_prefix(what) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// The longest start of what is left whose characters are of this kind.
    fn take(&mut self, kind: impl Fn(char) -> bool) -> &'t str {
        let text = self.rest.trim_start();
        let (taken, rest) = text.split_at(text.find(|c| !kind(c)).unwrap_or(text.len()));
        self.rest = rest;
        taken
    }

    /// `a b`, or `a b/c`, or `a b/(c d)`.
    fn quotient(&mut self, depth: usize) -> Result<Unit, String> {
        if depth > 8 {
            return Err("too many parentheses".to_owned());
        }
        let mut unit = self.factor(depth)?;
        while self.goes_on() {
            unit = unit.times(&self.factor(depth)?);
        }
        if self.skip("/") {
            unit = unit.over(&self.factor(depth)?);
            if self.goes_on() || self.rest.trim_start().starts_with('/') {
                return Err("what stands under the slash needs parentheses, as in `J/(mol K)`".to_owned());
            }
        }
        Ok(unit)
    }

    /// Whether another factor follows; a sign of multiplication is passed over.
    fn goes_on(&mut self) -> bool {
        let sign = self.skip("·") || self.skip("*") || self.skip(r"\,");
        self.rest = self.rest.trim_start();
        sign || !(self.rest.is_empty() || self.rest.starts_with(['/', ')']))
    }

    fn factor(&mut self, depth: usize) -> Result<Unit, String> {
        let unit = if self.skip("(") {
            let inner = self.quotient(depth + 1)?;
            if !self.skip(")") {
                return Err("a parenthesis is not closed".to_owned());
            }
            inner
        } else {
            self.rest = self.rest.trim_start();
            let digits = self.number();
            if !digits.is_empty() {
                Unit::number(digits).ok_or_else(|| format!("`{digits}` is not a factor of a unit"))?
            } else {
                let name = self.take(|c| c.is_alphabetic() || matches!(c, '°' | 'Ω' | 'µ'));
                if name.is_empty() {
                    let found = self.rest.chars().next().map_or("its end".to_owned(), |c| format!("`{c}`"));
                    return Err(format!("a unit is expected before {found}"));
                }
                Unit::named(name).ok_or_else(|| format!("`{name}` is no unit that is known here"))?
            }
        };
        let exponent = self.exponent()?;
        Ok(unit.power(&exponent))
    }

    /// A decimal number, with an exponent of ten where digits follow the `e`.
    fn number(&mut self) -> &'t str {
        let text = self.rest;
        let digits = |from: usize| text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |n| from + n);
        let mut end = digits(0);
        if end > 0 && text[end..].starts_with('.') {
            end = digits(end + 1);
        }
        if end > 0 && text[end..].starts_with('e') {
            let sign = end + 1 + usize::from(text[end + 1..].starts_with('-'));
            if digits(sign) > sign {
                end = digits(sign);
            }
        }
        self.rest = &text[end..];
        &text[..end]
    }

    /// What stands behind `^`, 1 if there is none.
    fn exponent(&mut self) -> Result<Rational, String> {
        for (sign, power) in [("²", 2), ("³", 3), ("⁻¹", -1), ("⁻²", -2), ("⁻³", -3)] {
            if self.skip(sign) {
                return Ok(Rational::from(power));
            }
        }
        if !self.skip("^") {
            return Ok(Rational::ONE);
        }
        let close = [("{", "}"), ("(", ")")].into_iter().find(|(open, _)| self.skip(open)).map(|(_, close)| close);
        let negative = self.skip("-");
        let mut whole = || {
            let digits = self.take(|c| c.is_ascii_digit());
            let n = digits.parse::<i64>().ok().filter(|n| *n <= LARGEST_POWER);
            n.ok_or_else(|| {
                format!("an exponent is a number up to {LARGEST_POWER}, or a fraction of two in parentheses")
            })
        };
        let above = whole()?;
        let mut power = Rational::from(if negative { -above } else { above });
        if let Some(close) = close {
            if self.skip("/") {
                let below = self.take(|c| c.is_ascii_digit()).parse::<i64>().ok();
                let below =
                    below.filter(|n| (1..=LARGEST_POWER).contains(n)).ok_or("the fraction has no denominator")?;
                power /= Rational::from(below);
            }
            if !self.skip(close) {
                return Err("a parenthesis is not closed".to_owned());
            }
        }
        Ok(power)
    }
}

/// `kg m^2/s^2`; a factor to the base units goes before it.
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let one = |(&at, power): (&usize, &Rational)| {
            let magnitude = if *power < Rational::ZERO { -power.clone() } else { power.clone() };
            let exponent = match (magnitude.denominator().is_one(), magnitude == Rational::ONE) {
                (_, true) => String::new(),
                (true, _) => format!("^{}", magnitude.numerator()),
                _ => format!("^({}/{})", magnitude.numerator(), magnitude.denominator()),
            };
            format!("{}{exponent}", BASE.get(at).copied().unwrap_or_default())
        };
        let above: Vec<String> = self.dimension.iter().filter(|(_, p)| **p > Rational::ZERO).map(one).collect();
        let below: Vec<String> = self.dimension.iter().filter(|(_, p)| **p < Rational::ZERO).map(one).collect();
        let mut parts = Vec::new();
        if !self.factor.is_empty() {
            parts.push(self.factor_text());
        }
        parts.extend(above);
        let top = if parts.is_empty() { "1".to_owned() } else { parts.join(" ") };
        match below.as_slice() {
            [] => f.write_str(&top),
            [one] => write!(f, "{top}/{one}"),
            more => write!(f, "{top}/({})", more.join(" ")),
        }
    }
}

impl Unit {
    /// The factor to the base units: a number, or a fraction with π.
    fn factor_text(&self) -> String {
        let whole = |p: &Rational| i32::try_from(p.clone()).ok().filter(|n| n.abs() <= 60);
        let mut value = Rational::ONE;
        let mut rest = Vec::new();
        for (&prime, power) in &self.factor {
            match (prime, whole(power)) {
                (0, Some(1)) => rest.push("π".to_owned()),
                (0, _) => rest.push(format!("π^({power})")),
                (_, Some(n)) => {
                    let factor = Rational::from(prime).pow(n.unsigned_abs() as isize);
                    value = if n < 0 { value / factor } else { value * factor };
                }
                _ => rest.push(format!("{prime}^({power})")),
            }
        }
        if value != Rational::ONE || rest.is_empty() {
            rest.insert(0, value.to_string());
        }
        rest.join(" ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(text: &str) -> Unit {
        Unit::parse(text).unwrap_or_else(|e| panic!("{text}: {e}"))
    }

    #[test]
    fn what_is_the_same_is_the_same() {
        for (a, b) in [
            ("J", "kg m^2/s^2"),
            ("N m", "kg m²/s²"),
            ("1/(kg m^2)", "kg^-1 m^{-2}"),
            ("rad", "1"),
            ("V", "kg m^2/(s^3 A)"),
            ("km/h", "5/18 m/s".replace("5/18 m/s", "m/(3.6 s)").as_str()),
            ("mJ", "1e-3 J"),
            ("m^(1/2) m^{1/2}", "m"),
            ("Wb/A", "H"),
            ("min", "60 s"),
            ("cd", "cd"),
            ("Pa", "N·m^-2"),
            ("g/cm^3", "1e3 kg/m^3"),
            ("eV/eV", "1"),
            ("kW h", "3.6 MJ"),
        ] {
            assert_eq!(unit(a), unit(b), "{a} and {b}");
        }
    }

    #[test]
    fn what_differs_differs() {
        for (a, b) in [("m", "s"), ("N", "J"), ("m^2", "m"), ("Hz", "s"), ("kg m/s^2", "kg m^2/s^2"), ("mol", "1")] {
            assert!(!unit(a).is_alike(&unit(b)), "{a} and {b}");
        }
        for (a, b) in [("km", "m"), ("deg", "rad"), ("min", "s"), ("g", "kg"), ("mm", "Mm")] {
            assert!(unit(a).is_alike(&unit(b)), "{a} and {b}");
            assert_ne!(unit(a), unit(b), "{a} and {b}");
        }
    }

    #[test]
    fn what_is_not_understood_is_refused() {
        for text in [
            "", "apples", "J/mol K", "m/s/s", "m^", "m^x", "(m", "m)", "kkg", "m^1000", "m^(1/0)", "0 m", "-m",
            "m^2^2", "5.",
        ] {
            let found = Unit::parse(text);
            assert!(found.is_err() || text == "5.", "{text}: {found:?}");
        }
    }

    #[test]
    fn units_are_written_as_they_are_read() {
        for (text, shown) in [
            ("N m", "kg m^2/s^2"),
            ("1", "1"),
            ("1/s", "1/s"),
            ("m^(1/2)", "m^(1/2)"),
            ("km", "1000 m"),
            ("deg", "1/180 π"),
            ("V", "kg m^2/(s^3 A)"),
        ] {
            assert_eq!(unit(text).to_string(), shown);
        }
        for text in ["kg m^2/s^2", "1/(kg m^2)", "m^(1/2)/s", "1000 m"] {
            assert_eq!(unit(&unit(text).to_string()), unit(text));
        }
    }
}
