//! The times of a motion: its span and the time of its initial values.
//!
//! **In:** the table of a trajectory. **Out:** binary64 numbers. **Guaranteed:** the first time is before the last, and the initial time is not outside.

use super::load::Loader;
use super::model::Trajectory;
use super::number::finite;
use super::table::{Table, Value, literal_of};
use latex::Scope;

impl Loader<'_> {
    /// Span and initial time.
    pub(super) fn times(
        &mut self,
        table: &Table<'_, '_>,
        source: Option<&Trajectory>,
        scope: &Scope,
    ) -> Option<((f64, f64), f64)> {
        let span = match (table.get("span"), source) {
            (None, Some(source)) => source.span,
            (None, None) => {
                table.missing(&mut self.problems, "span");
                return None;
            }
            (Some(value), _) => self.span(table, value, scope)?,
        };
        let inside = |t: f64| span.0 <= t && t <= span.1;
        let initial = match table.get("initial-time") {
            Some(value) => {
                let t = self.time(value, "initial-time", scope)?;
                if !inside(t) {
                    let message = "`initial-time` lies outside `span`";
                    self.problems.note("derivation::bad-span", value.span(), message);
                    return None;
                }
                t
            }
            None => {
                source.map(|s| s.initial_time).filter(|t| inside(*t)).unwrap_or(if inside(0.0) { 0.0 } else { span.0 })
            }
        };
        Some((span, initial))
    }

    fn span(&mut self, table: &Table<'_, '_>, value: &Value<'_>, scope: &Scope) -> Option<(f64, f64)> {
        let [a, b] = table.array(&mut self.problems, "span", "two times") else {
            if value.get_ref().is_array() {
                let message = "`span` is the first and the last time";
                self.problems.note("derivation::bad-span", value.span(), message).hint("for instance span = [0, 80]");
            }
            return None;
        };
        let (a, b) = (self.time(a, "span", scope), self.time(b, "span", scope));
        let (a, b) = a.zip(b)?;
        if a >= b {
            let message = "the first time of `span` must be before the last";
            self.problems.note("derivation::bad-span", value.span(), message);
            return None;
        }
        Some((a, b))
    }

    /// A time: a number, or a formula of numbers, as the binary64 number that is nearest to it as far as it is computed.
    fn time(&mut self, value: &Value<'_>, key: &str, scope: &Scope) -> Option<f64> {
        if value.get_ref().as_str().is_none() {
            return finite(&mut self.problems, value, key);
        }
        let formula = literal_of(&mut self.problems, value, key)?;
        let read = self.quantity(&formula, scope)?;
        let number = match read.value.components.as_slice() {
            &[e] => self.out.graph.number(e),
            _ => None,
        };
        if number.is_none() {
            let message = format!("`{key}` must be a finite number, or a formula of numbers");
            self.problems.note("derivation::bad-number", read.span, message).hint("for instance '4\\pi'");
        }
        number
    }
}
