//! Constants of nature, for files that ask for them: `'c' = { role = "constant" }`.
//!
//! **In:** a name as it is declared. **Out:** the exact value and the unit that the SI of 2019 gives it; or, of a constant that is
//! measured, what CODATA recommends. **Guaranteed:** what is measured is no exact number: it is never put in as one, the file
//! has to say which value its motions have.
//!
//! Values: The International System of Units, 9th edition (2019), tables 1 and 2; CODATA recommended values of 2022.

use std::ops::Range;

use super::load::{Loader, declared};
use super::model::SymbolEntry;
use super::table::{Literal, Table, as_printed, literal_of};
use super::unit::Unit;
use expr::Rational;
use latex::{Declaration, Role, Scope};

/// A constant whose value is exact: names, value, unit, what it is.
type Exact = (&'static [&'static str], &'static str, &'static str, &'static str);

const EXACT: &[Exact] = &[
    (&["c", "c_0"], "299792458", "m/s", "the speed of light in vacuum"),
    (&["h"], r"6.62607015\cdot10^{-34}", "J s", "the Planck constant"),
    (&[r"\hbar"], r"\frac{6.62607015\cdot10^{-34}}{2\pi}", "J s", "the reduced Planck constant"),
    (&["e"], r"1.602176634\cdot10^{-19}", "C", "the elementary charge"),
    (&["k", "k_B"], r"1.380649\cdot10^{-23}", "J/K", "the Boltzmann constant"),
    (&["N_A"], r"6.02214076\cdot10^{23}", "1/mol", "the Avogadro constant"),
    (&["R"], r"1.380649\cdot6.02214076", "J/(mol K)", "the molar gas constant"),
    (&["F"], r"1.602176634\cdot6.02214076\cdot10^4", "C/mol", "the Faraday constant"),
    (
        &[r"\sigma", r"\sigma_{SB}"],
        r"\frac{2\pi^5\cdot1.380649^4\cdot10^{-92}}{15\cdot6.62607015^3\cdot10^{-102}\cdot299792458^2}",
        "W/(m^2 K^4)",
        "the Stefan-Boltzmann constant",
    ),
    (&[r"\Phi_0"], r"\frac{6.62607015\cdot10^{-15}}{2\cdot1.602176634}", "Wb", "the magnetic flux quantum"),
    (&["K_J"], r"\frac{2\cdot1.602176634\cdot10^{15}}{6.62607015}", "Hz/V", "the Josephson constant"),
    (&["R_K"], r"\frac{6.62607015\cdot10^4}{1.602176634^2}", "ohm", "the von Klitzing constant"),
    (&["g_n"], "9.80665", "m/s^2", "the standard acceleration of gravity"),
];

/// A constant that is measured: names, recommended value, standard uncertainty, unit.
type Measured = (&'static [&'static str], &'static str, &'static str, &'static str);

const MEASURED: &[Measured] = &[
    (&["G"], r"6.67430\cdot10^{-11}", r"0.00015\cdot10^{-11}", "m^3/(kg s^2)"),
    (&[r"\epsilon_0", r"\varepsilon_0"], r"8.8541878188\cdot10^{-12}", r"0.0000000014\cdot10^{-12}", "F/m"),
    (&[r"\mu_0"], r"1.25663706127\cdot10^{-6}", r"0.00000000020\cdot10^{-6}", "N/A^2"),
    (&[r"\alpha"], r"7.2973525643\cdot10^{-3}", r"0.0000000011\cdot10^{-3}", "1"),
    (&["m_e"], r"9.1093837139\cdot10^{-31}", r"0.0000000028\cdot10^{-31}", "kg"),
    (&["m_p"], r"1.67262192595\cdot10^{-27}", r"0.00000000052\cdot10^{-27}", "kg"),
    (&["m_n"], r"1.67492750056\cdot10^{-27}", r"0.00000000085\cdot10^{-27}", "kg"),
    (&["a_0"], r"5.29177210544\cdot10^{-11}", r"0.00000000082\cdot10^{-11}", "m"),
    (&[r"R_\infty"], "10973731.568157", "0.000012", "1/m"),
    (&[r"\mu_B"], r"9.2740100657\cdot10^{-24}", r"0.0000000029\cdot10^{-24}", "J/T"),
];

/// Words of letters in upright groups that are no scripts: those that may be units. What begins with an upright d, e or i is none, and a letter
/// that stands as a script anywhere, as the T of a transpose, is none either.
fn upright_words(text: &str) -> Vec<String> {
    let (mut words, mut scripts): (Vec<String>, Vec<String>) = Default::default();
    for command in [r"\mathrm{", r"\text{"] {
        for (at, _) in text.match_indices(command) {
            let inside = &text[at + command.len()..];
            let mut depth = 1usize;
            let end = inside.bytes().position(|b| {
                depth += usize::from(b == b'{');
                depth -= usize::from(b == b'}');
                depth == 0
            });
            let Some(end) = end.filter(|end| *end <= LONGEST_UNIT) else { continue };
            let script = text[..at].trim_end_matches([' ', '{']).ends_with(['_', '^']);
            let spaced = inside[..end].replace(r"\cdot", " ");
            for word in spaced.split(|c: char| !c.is_ascii_alphabetic()).filter(|w| !w.is_empty()) {
                let list = if script { &mut scripts } else { &mut words };
                if !list.iter().any(|w| w == word) && !word.starts_with(['d', 'e', 'i']) {
                    list.push(word.to_owned());
                }
            }
        }
    }
    words.retain(|w| w.len() > 1 || !scripts.contains(w));
    words
}

/// Most characters of a unit.
const LONGEST_UNIT: usize = 80;

/// A name without what is not printed, and without the upright type of its label.
fn plain(name: &str) -> String {
    let bare = name.replace(r"\mathrm", "").replace(r"\text", "").replace(r"\rm", "");
    bare.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect()
}

fn is_among(names: &[&str], name: &str) -> bool {
    names.iter().any(|n| plain(n) == plain(name))
}

/// The exact value of a constant, as a formula.
///
/// # Errors
/// Why there is none, and what to write.
pub(super) fn exact_value(name: &str) -> Result<&'static Exact, (String, String)> {
    if let Some((_, value, uncertainty, unit)) = MEASURED.iter().find(|(names, ..)| is_among(names, name)) {
        let hint = format!(
            "declare it as a parameter, unit = \"{unit}\", and give its value on each motion; CODATA 2022 recommends \
             '{value}', with the standard uncertainty '{uncertainty}'"
        );
        return Err((format!("`{name}` is measured, it has no exact value"), hint));
    }
    EXACT.iter().find(|(names, ..)| is_among(names, name)).ok_or_else(|| {
        let names: Vec<&str> = EXACT.iter().flat_map(|(names, ..)| names.iter().copied()).collect();
        let hint = format!("give its value as a formula; known are {}", names.join(", "));
        (format!("`{name}` is not the name of a constant with an exact value"), hint)
    })
}

impl Loader<'_> {
    /// A symbol whose role is `constant`.
    pub(super) fn constant(
        &mut self,
        name: &str,
        span: Range<usize>,
        table: &Table<'_, '_>,
        scope: &mut Scope,
        in_claim: bool,
    ) -> Option<SymbolEntry> {
        if in_claim {
            let message = format!("`{name}`: a claim cannot declare a constant");
            self.problems.note("derivation::bad-role", span, message).hint("declare it under [symbols]");
            return None;
        }
        if let Some(key) = ["shape", "positive", "angle", "labelled", "complex", "arguments"]
            .iter()
            .find(|key| table.get(key).is_some())
        {
            let message = format!("`{name}` is a constant, which has no `{key}`");
            self.problems.note("derivation::bad-role", span, message).hint("a constant is one real number");
            return None;
        }
        if table.get("formula").is_none() {
            return self.named_constant(name, span, table, scope);
        }
        let formula = literal_of(&mut self.problems, table.get("formula")?, "formula")?;
        let (unit, measured_in) = self.unit(table);
        let says = table.text(&mut self.problems, "says");
        self.fixed(name, span, &formula, (unit, measured_in), says, scope)
    }

    fn named_constant(
        &mut self,
        name: &str,
        span: Range<usize>,
        table: &Table<'_, '_>,
        scope: &mut Scope,
    ) -> Option<SymbolEntry> {
        let (_, value, unit, what) = match exact_value(name) {
            Ok(found) => found,
            Err((message, hint)) => {
                self.problems.note("derivation::bad-role", span, message).hint(hint);
                return None;
            }
        };
        if table.get("unit").is_some() {
            let message = format!("`{name}` has its unit already, {unit}");
            self.problems
                .note("derivation::bad-role", span, message)
                .hint("leave `unit` out, or give a `formula`, too");
            return None;
        }
        let says = table.text(&mut self.problems, "says").unwrap_or_else(|| (*what).to_owned());
        let formula = Literal { text: value, start: span.start, span: span.clone() };
        let unit = (Some((*unit).to_owned()), Unit::parse(unit).ok());
        let entry = self.fixed(name, span, &formula, unit, Some(says), scope)?;
        self.in_si.push(entry.name.clone());
        Some(entry)
    }

    /// A parameter whose value is the same on every motion: its definition, which proofs may use.
    fn fixed(
        &mut self,
        name: &str,
        span: Range<usize>,
        formula: &Literal<'_>,
        (unit, measured_in): (Option<String>, Option<Unit>),
        says: Option<String>,
        scope: &mut Scope,
    ) -> Option<SymbolEntry> {
        let declaration = Declaration { formula: Some(formula.text), ..Declaration::of(Role::Parameter) };
        let symbol = match declared(Some(formula.text), || scope.declare(&mut self.out.graph, name, declaration)) {
            Ok(symbol) => symbol,
            Err(error) => {
                self.note_declaration(name, span, Some(formula), error);
                return None;
            }
        };
        let value = scope.definition(symbol).and_then(|t| t.as_scalar());
        let Some(value) = value.filter(|v| self.out.graph.leaves_within([*v]).is_empty()) else {
            let message = format!("the value of the constant `{name}` is not a number");
            let hint = "write digits, π and functions of them; what depends on something else is an abbreviation";
            self.problems.note("derivation::bad-role", formula.span.clone(), message).hint(hint);
            return None;
        };
        // Those of the table are positive.
        let known = formula.span == span;
        let positive = known || self.out.graph.as_constant(value).is_some_and(|r| *r > Rational::ZERO);
        Some(SymbolEntry {
            scale: None,
            name: as_printed(name),
            role: Role::Parameter,
            unit,
            measured_in,
            positive,
            angle: false,
            complex: false,
            formula: Some(formula.printed()),
            arguments: Vec::new(),
            says,
            span,
            symbol,
        })
    }

    /// The units that occur in the formulas of a file which speaks of units, `\mathrm{km}`: constants, with the number of
    /// coherent units of the SI as their value.
    pub(super) fn declare_units(&mut self, scope: &mut Scope) -> Vec<SymbolEntry> {
        let mut out = Vec::new();
        if !self.has_units {
            return out;
        }
        let source = std::sync::Arc::clone(self.problems.source);
        for word in upright_words(&source.text) {
            let Some((factor, unit)) = Unit::parse(&word).ok().and_then(|u| u.taken_apart()) else { continue };
            let name = format!(r"\mathrm{{{word}}}");
            let text = match (factor.numerator().to_string(), factor.denominator().to_string()) {
                (whole, one) if one == "1" => whole,
                (top, bottom) => format!(r"\frac{{{top}}}{{{bottom}}}"),
            };
            let formula = Literal { text: &text, start: 0, span: 0..0 };
            let says = Some("a unit".to_owned());
            out.extend(self.fixed(&name, 0..0, &formula, (Some(unit.to_string()), Some(unit)), says, scope));
            self.in_si.push(name);
        }
        out
    }

    /// The named constants have values in coherent units of the SI: another quantity in km would make numbers of another size.
    /// Beside `written` units every quantity needs one: nobody could say in what it is measured.
    pub(super) fn units_are_coherent(&mut self, written: bool) {
        let Some(first) = self.in_si.first() else { return };
        let basic =
            |s: &&SymbolEntry| matches!(s.role, Role::Time | Role::State | Role::Parameter) && s.measured_in.is_none();
        let without: Vec<(Range<usize>, String)> = self
            .out
            .symbols
            .iter()
            .filter(|s| written && basic(s))
            .map(|s| (s.span.clone(), format!("`{}` has no unit, and units stand in the formulas", s.name)))
            .collect();
        let odd = |s: &&SymbolEntry| s.measured_in.as_ref().is_some_and(|u| !u.is_number() && !u.is_coherent());
        let found: Vec<(Range<usize>, String)> = self
            .out
            .symbols
            .iter()
            .filter(odd)
            .map(|s| {
                let unit = s.unit.as_deref().unwrap_or_default();
                let message =
                    format!("`{}` is measured in {unit}, and `{first}` in units of the SI without factors", s.name);
                (s.span.clone(), message)
            })
            .collect();
        for (span, message) in without {
            let hint = "give it a `unit`; a number has the unit \"1\"";
            self.problems.note("derivation::bad-unit", span, message).hint(hint);
        }
        for (span, message) in found {
            let hint = "measure all in m, kg, s, A, K, mol and what is made of them, or give the constant a `formula` and a `unit`";
            self.problems.note("derivation::bad-unit", span, message).hint(hint);
        }
    }
}
