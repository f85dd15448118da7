//! `map` and `boundary` of a family: the two symbols over which a report shows where claims hold, and how finely their edge is found.
//!
//! **In:** the table of the family, and what varies. **Out:** positions among what varies, and widths. **Guaranteed:** a boundary has a
//! map with one member for each of its cells, so that neighbours differ in one value alone.

use toml::de::DeValue;

use super::family::{Varied, WIDEST_ROW};
use super::load::Loader;
use super::number::finite;
use super::table::{Literal, Table};

impl Loader<'_> {
    /// The two symbols of its map.
    pub(super) fn map_over(&mut self, table: &Table<'_, '_>, vary: &[Varied]) -> Option<[usize; 2]> {
        let value = table.get("map")?;
        let names = table.formulas(&mut self.problems, "map");
        let [across, up] = names.as_slice() else {
            let message = "a map is over two of the symbols that vary";
            self.problems
                .note("derivation::bad-family", value.span(), message)
                .hint("for instance map = ['a', 'b']: the first to the right, the second upwards");
            return None;
        };
        let mut place = |name: &Literal<'_>| {
            let found = vary.iter().position(|v| v.name == name.text.trim());
            if found.is_none() {
                let known: Vec<&str> = vary.iter().map(|v| v.name.as_str()).collect();
                let message = format!("this family does not vary `{}`", name.printed());
                self.problems
                    .note("derivation::bad-family", name.span.clone(), message)
                    .hint(format!("it varies {}", known.join(", ")));
            }
            found
        };
        let (across, up) = (place(across)?, place(up)?);
        if across == up {
            let message = "a map is over two different symbols";
            self.problems.note("derivation::bad-family", value.span(), message);
            return None;
        }
        Some([across, up])
    }

    /// To which width the boundary is found, along which of the symbols of the map.
    pub(super) fn boundary(
        &mut self,
        table: &Table<'_, '_>,
        (map, vary): (Option<[usize; 2]>, &[Varied]),
    ) -> Vec<(usize, f64)> {
        let Some(value) = table.get("boundary") else { return Vec::new() };
        let mut refuse = |message: &str, hint: &str| {
            self.problems.note("derivation::bad-family", value.span(), message.to_owned()).hint(hint.to_owned());
        };
        let Some(map) = map else {
            if table.get("map").is_none() {
                refuse("a boundary is that of a map", "say over what: map = ['a', 'b']");
            }
            return Vec::new();
        };
        let is_single = |(n, v): (usize, &Varied)| map.contains(&n) || v.spread.points() == 1;
        if vary.iter().any(|v| v.spread.is_drawn()) || !vary.iter().enumerate().all(is_single) {
            let hint = "let rows and lists of the two symbols of the map be all that varies, and draw nothing";
            refuse("a boundary lies between members that differ in one value alone", hint);
            return Vec::new();
        }
        if map.iter().any(|n| vary[*n].spread.points() > WIDEST_ROW) {
            let message =
                format!("a boundary lies between single values, and a cell has several of more than {WIDEST_ROW}");
            refuse(&message, "take fewer values: bisection goes between them");
            return Vec::new();
        }
        let DeValue::Table(entries) = value.get_ref() else {
            self.problems.wrong_type(value, "boundary", "a table of symbols and widths, for instance { 'a' = 0.001 }");
            return Vec::new();
        };
        let mut out = Vec::new();
        for (name, width) in entries {
            let Some(at) = map.iter().copied().find(|n| vary[*n].name == name.get_ref().trim()) else {
                let known: Vec<&str> = map.iter().map(|n| vary[*n].name.as_str()).collect();
                let message = format!("the map is not over `{}`", name.get_ref());
                let hint = format!("it is over {}", known.join(" and "));
                self.problems.note("derivation::bad-family", name.span(), message).hint(hint);
                continue;
            };
            match finite(&mut self.problems, width, "a width").filter(|x| *x > 0.0) {
                Some(width) => out.push((at, width)),
                None => {
                    let message = "a width is a number above 0";
                    self.problems.note("derivation::bad-number", width.span(), message);
                }
            }
        }
        if entries.is_empty() {
            let message = "this boundary has no width";
            self.problems
                .note("derivation::bad-family", value.span(), message)
                .hint("for instance boundary = { 'a' = 0.001 }");
        }
        out
    }
}
