//! `[symbols]`, of the file and of a claim.

use toml::de::{DeTable, DeValue};

use super::keys;
use super::load::{Loader, declared};
use super::model::SymbolEntry;
use super::table::{Literal, Table, Value, as_printed, changes_backslashes, literal_of, note_double_quoted};
use expr::Shape;
use latex::{Declaration, DeclareError, Role, Scope};

pub(super) const ROLES: &[(&str, Role)] = &[
    ("time", Role::Time),
    ("state", Role::State),
    ("parameter", Role::Parameter),
    ("observable", Role::Observable),
    ("abbreviation", Role::Abbreviation),
    ("coordinate", Role::Coordinate),
    ("field", Role::Field),
];

/// The role of a parameter whose value is fixed.
pub(super) const CONSTANT: &str = "constant";

/// Largest number of components of a symbol.
const LARGEST_SHAPE: usize = 1024;

impl Loader<'_> {
    /// The symbols of the whole file.
    pub fn symbols(&mut self, root: &Table<'_, '_>) {
        let Some(value) = root.get("symbols") else {
            root.missing(&mut self.problems, "[symbols]");
            return;
        };
        let mut scope = self.out.scope.clone();
        let units = self.declare_units(&mut scope);
        self.out.symbols = self.declare_all(value, &mut scope, false);
        self.out.scope = scope;
        self.units_are_coherent(!units.is_empty());
        self.out.symbols.extend(units);
    }

    /// Declares the symbols of a table, in its order.
    pub fn declare_all(&mut self, value: &Value<'_>, scope: &mut Scope, in_claim: bool) -> Vec<SymbolEntry> {
        let DeValue::Table(entries) = value.get_ref() else {
            self.problems.wrong_type(value, "symbols", "a table");
            return Vec::new();
        };
        self.declare_entries(entries, scope, in_claim)
    }

    fn declare_entries(&mut self, entries: &DeTable<'_>, scope: &mut Scope, in_claim: bool) -> Vec<SymbolEntry> {
        let mut out = Vec::new();
        for (key, value) in entries {
            let name = key.get_ref().as_ref();
            let raw = self.problems.source.text.get(key.span()).unwrap_or_default();
            if changes_backslashes(raw) {
                note_double_quoted(&mut self.problems, key.span(), raw, true);
                self.refuse_symbol(raw.trim_matches('"'), scope);
                continue;
            }
            // In another spelling, `{x}` for `x`, TOML does not see that a name is there already.
            let before = scope.symbol(name);
            if let Some(first) = out.iter().find(|e: &&SymbolEntry| Some(e.symbol) == before) {
                let message = format!("`{name}` is declared already, as `{}`", first.name);
                self.problems
                    .note("derivation::duplicate-id", key.span(), message)
                    .see(first.span.clone(), "the first one");
                continue;
            }
            match self.declare_one(name, key.span(), value, scope, in_claim) {
                Some(entry) => out.push(entry),
                None => self.refuse_symbol(name, scope),
            }
        }
        out
    }

    fn declare_one(
        &mut self,
        name: &str,
        span: std::ops::Range<usize>,
        value: &Value<'_>,
        scope: &mut Scope,
        in_claim: bool,
    ) -> Option<SymbolEntry> {
        let table = Table::open(&mut self.problems, value, "a symbol", keys::SYMBOL)?;
        if table.get("role").and_then(|v| v.get_ref().as_str()) == Some(CONSTANT) {
            return self.constant(name, span, &table, scope, in_claim);
        }
        let problems = &mut self.problems;
        let role = role(problems, &table)?;
        if in_claim && matches!(role, Role::Time | Role::State) {
            let message = format!("`{name}`: a claim cannot declare a state or the time");
            problems.note("derivation::bad-role", span, message).hint("declare it under [symbols]");
            return None;
        }
        let (shape, diagonal) = match table.get("shape") {
            Some(value) => shape(problems, value).map(|(shape, diagonal)| (Some(shape), diagonal))?,
            None => (None, false),
        };
        let complex = table.boolean(problems, "complex").unwrap_or(false);
        let mut on = |key: &'static str| table.boolean(problems, key).unwrap_or(false);
        let against = [
            (role == Role::Time, "the time"),
            (diagonal, "a diagonal matrix"),
            (on("positive"), "positive"),
            (on("angle"), "an angle"),
        ];
        if let Some((_, what)) = against.iter().find(|(is, _)| complex && *is) {
            let message = format!("`{name}` is declared complex, and as {what}");
            problems.note("derivation::bad-role", span, message).hint("leave one of the two out");
            return None;
        }
        if on("angle") && !matches!(role, Role::Observable | Role::State) {
            let message = format!("`{name}` is no observable, and its values are not continued along a motion");
            let hint = "declare it as an observable, or leave `angle` out";
            problems.note("derivation::bad-role", span, message).hint(hint);
            return None;
        }
        if let Some(value) = table.get("arguments").filter(|_| role != Role::Abbreviation) {
            let message = format!("`{name}` is no abbreviation, and has no arguments");
            let hint = "an abbreviation with arguments may name states and the time, too";
            problems.note("derivation::bad-role", value.span(), message).hint(hint);
            return None;
        }
        if on("positive") && role != Role::Parameter {
            let message = format!("`{name}`: only parameters are declared positive");
            let hint = format!("assume it in the claim, `assuming = ['{name}>0']`");
            problems.note("derivation::bad-role", span, message).hint(hint);
            return None;
        }
        let formula = match table.get("formula") {
            Some(value) => Some(literal_of(problems, value, "formula")?),
            None => None,
        };
        let scale = match table.get("scale") {
            Some(value) if role != Role::Coordinate => {
                let message = format!("`{name}` is no coordinate, and has no scale factor");
                problems.note("derivation::bad-role", value.span(), message).hint("leave `scale` out");
                return None;
            }
            Some(value) => Some(literal_of(problems, value, "scale")?),
            None => None,
        };
        let place = match table.get("momentum-of") {
            Some(value) => Some(literal_of(problems, value, "momentum-of")?),
            None => None,
        };
        let velocity = table.boolean(problems, "velocity") == Some(true);
        let defined = matches!(role, Role::Observable | Role::Abbreviation);
        if defined != formula.is_some() && role != Role::Field {
            let role = ROLES.iter().find(|(_, r)| *r == role).map_or("", |(word, _)| word);
            let noted = if defined {
                let message = format!("`{name}` is an {role} without a `formula`");
                problems.note("derivation::missing-key", table.span.clone(), message)
            } else {
                let message = format!("`{name}` is declared as {role}, which has no `formula`");
                problems.note("derivation::bad-role", span.clone(), message)
            };
            noted.hint("observables and abbreviations are defined by a formula, fields may be, nothing else is");
            return None;
        }
        let arguments = table.formulas(problems, "arguments");
        let names: Vec<&str> = arguments.iter().map(|a| a.text.trim()).collect();
        let (unit, measured_in) = self.unit(&table);
        let problems = &mut self.problems;
        let angle = table.boolean(problems, "angle").unwrap_or(false);
        let labelled = table.boolean(problems, "labelled").unwrap_or(false);
        let entry = SymbolEntry {
            name: as_printed(name),
            role,
            unit,
            measured_in,
            positive: table.boolean(problems, "positive").unwrap_or(false),
            angle,
            complex,
            formula: formula.as_ref().map(Literal::printed),
            scale: scale.as_ref().map(Literal::printed),
            arguments: names.iter().map(|&n| n.to_owned()).collect(),
            says: table.text(problems, "says"),
            span: span.clone(),
            symbol: {
                let formula = formula.as_ref().or(scale.as_ref());
                let text = formula.map(|f| f.text);
                let declaration =
                    Declaration { role, shape, diagonal, formula: text, arguments: &names, complex, angle, labelled };
                match declared(text, || scope.declare(&mut self.out.graph, name, declaration)) {
                    Ok(symbol) => symbol,
                    Err(error) => {
                        self.note_declaration(name, span, formula, error);
                        return None;
                    }
                }
            },
        };
        if velocity && let Err(error) = scope.set_velocity(name, entry.symbol) {
            self.note_declaration(name, span, None, error);
            return None;
        }
        if let Some(place) = &place
            && let Err(error) = scope.set_momentum(&self.out.graph, entry.symbol, place.text)
        {
            self.note_declaration(name, span, Some(place), error);
            return None;
        }
        Some(entry)
    }

    /// Notes why a declaration was refused.
    pub(super) fn note_declaration(
        &mut self,
        name: &str,
        span: std::ops::Range<usize>,
        formula: Option<&Literal<'_>>,
        error: DeclareError,
    ) {
        match (error, formula) {
            (DeclareError::Formula(found), Some(formula)) => self.note_formula(formula, found),
            (DeclareError::Formula(found), None) => {
                for p in found {
                    self.problems.note(p.code, span.clone(), format!("`{name}`: {}", p.message));
                }
            }
            (DeclareError::Key(mut problem), _) => {
                let raw = self.problems.source.text.get(span.clone()).unwrap_or_default();
                // Where backslashes are written twice, places are not those of the name.
                if raw.starts_with('"') && raw.contains('\\') {
                    problem.span = 0..raw.len().saturating_sub(2);
                }
                let start = span.start + usize::from(raw.starts_with(['\'', '"']));
                self.note_formula(&Literal { text: name, start, span }, vec![problem]);
            }
        }
    }
}

fn role(problems: &mut super::table::Problems<'_>, table: &Table<'_, '_>) -> Option<Role> {
    let text = table.needed_text(problems, "role")?;
    let found = ROLES.iter().find(|(word, _)| *word == text).map(|(_, role)| *role);
    if found.is_none() {
        let span = table.get("role").map_or(table.span.clone(), |v| v.span());
        let words = ROLES.iter().map(|(word, _)| *word).chain([CONSTANT]);
        problems.unknown("derivation::bad-role", span, "role", &text, words);
    }
    found
}

/// A shape, and whether only the diagonal is stored.
fn shape(problems: &mut super::table::Problems<'_>, value: &Value<'_>) -> Option<(Shape, bool)> {
    let text = match value.get_ref() {
        DeValue::String(text) => text.as_ref(),
        DeValue::Integer(n) => n.as_str(),
        _ => {
            problems.wrong_type(value, "shape", "a string");
            return None;
        }
    };
    let found = parse_shape(text.trim());
    if found.is_none() {
        let message = format!("`{text}` is not a shape");
        problems.note("derivation::bad-shape", value.span(), message).hint(
            "write \"3\" for a vector, \"3x3\" for a matrix, \"diagonal 3\" for a diagonal matrix; nothing for a scalar",
        );
    }
    found
}

pub(super) fn parse_shape(text: &str) -> Option<(Shape, bool)> {
    let extent = |s: &str| s.trim().parse::<u16>().ok().filter(|n| *n > 0);
    if let Some(rest) = text.strip_prefix("diagonal") {
        let n = extent(rest)?;
        return (usize::from(n).pow(2) <= LARGEST_SHAPE).then(|| (Shape::matrix(n, n), true));
    }
    let extents = text.split(['x', '×']).map(extent).collect::<Option<Vec<u16>>>()?;
    if extents.len() > 8 {
        return None;
    }
    let size = extents.iter().try_fold(1usize, |a, &n| a.checked_mul(n.into()))?;
    (size <= LARGEST_SHAPE).then(|| (Shape::of(extents), false))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes() {
        assert_eq!(parse_shape("3"), Some((Shape::vector(3), false)));
        assert_eq!(parse_shape("3x3"), Some((Shape::matrix(3, 3), false)));
        assert_eq!(parse_shape("2 x 4"), Some((Shape::matrix(2, 4), false)));
        assert_eq!(parse_shape("diagonal 3"), Some((Shape::matrix(3, 3), true)));
        for refused in ["", "0", "3x", "-3", "diagonal", "65535x65535x65535x65535x65535", "three", "99999"] {
            assert_eq!(parse_shape(refused), None, "{refused}");
        }
    }
}
