//! `[[condition]]`, and what a file says of units.

use super::keys;
use super::load::Loader;
use super::model::Condition;
use super::table::{Table, Value, text_of};
use super::unit::Unit;

impl Loader<'_> {
    /// Reads every `[[condition]]`.
    pub fn conditions(&mut self, root: &Table<'_, '_>) {
        for value in root.array(&mut self.problems, "condition", "tables, [[condition]]") {
            if let Some(condition) = self.one_condition(value) {
                self.out.conditions.push(condition);
            }
        }
    }

    fn one_condition(&mut self, value: &Value<'_>) -> Option<Condition> {
        let table = Table::open(&mut self.problems, value, "[[condition]]", keys::CONDITION)?;
        let id = table.id(&mut self.problems, "id");
        let says = table.needed_text(&mut self.problems, "says");
        if table.get("holds").is_none() {
            table.missing(&mut self.problems, "holds");
        }
        let scope = self.out.scope.clone();
        let before = self.problems.found.len();
        let mut holds = Vec::new();
        for formula in table.formulas(&mut self.problems, "holds") {
            holds.extend(self.with_one_sign(&formula, &scope));
        }
        let (id, span) = id?;
        let new = self.take("condition", &id, span.clone());
        if holds.is_empty() && self.problems.found.len() == before {
            let span = table.get("holds").map_or(span.clone(), |v| v.span());
            self.problems.note("derivation::empty-claim", span, format!("the condition `{id}` says nothing"));
        }
        new.then_some(Condition { id, says: says?, holds, span })
    }

    /// The unit of a symbol or a measure: as written, and as understood.
    pub fn unit(&mut self, table: &Table<'_, '_>) -> (Option<String>, Option<Unit>) {
        let Some(text) = table.text(&mut self.problems, "unit") else { return (None, None) };
        match Unit::parse(&text) {
            Ok(unit) => (Some(text), Some(unit)),
            Err(message) => {
                let span = table.get("unit").map_or(table.span.clone(), |v| v.span());
                self.problems
                    .note("derivation::bad-unit", span, format!("the unit `{text}` is not understood: {message}"))
                    .hint("write products and powers of SI units, as in `kg m^2/s^2`; `1` for a number");
                (Some(text), None)
            }
        }
    }

    /// Whether the file expects formulas that are not consistent in their units; `None` where it does not say.
    pub fn expect_units(&mut self, table: &Table<'_, '_>) -> Option<bool> {
        let value = table.get("expect-units")?;
        match text_of(&mut self.problems, value, "expect-units")? {
            "inconsistent" => Some(true),
            "consistent" => Some(false),
            word => {
                let known = ["consistent", "inconsistent"];
                self.problems.unknown("derivation::unknown-key", value.span(), "expectation", word, known);
                None
            }
        }
    }
}
