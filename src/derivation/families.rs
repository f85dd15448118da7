//! `[[family]]`: reads what varies, and how.
//!
//! **In:** the table, and that of the trajectory whose values are varied. **Out:** a [`Family`]. Everything that can be known to be
//! wrong before a member is made is noted here, with its place.

use std::ops::Range;
use std::sync::Arc;

use toml::de::DeValue;

use super::family::{Constraint, Drawing, Family, LARGEST_FAMILY, Piece, Spread, Varied};
use super::formula::Written;
use super::keys;
use super::load::Loader;
use super::model::{GivenValue, Motion};
use super::motions::{ValueOf, undotted};
use super::number::exact;
use super::table::{Table, Value, text_of};
use super::values::Known;
use expr::{Expr, Leaf, Rational, Tensor};
use latex::{RelationKind, Role, Scope};

const SPREADS: &str = "one of { from = a, to = b, count = n }, { values = […] }, { uniform = [a, b] }, \
    { log-uniform = [a, b] }, { polar = [a, b] } and { normal = [mean, deviation] }";

impl Loader<'_> {
    /// Reads every `[[family]]`.
    pub fn families(&mut self, root: &Table<'_, '_>) {
        for value in root.array(&mut self.problems, "family", "tables, [[family]]") {
            let Some(table) = Table::open(&mut self.problems, value, "[[family]]", keys::FAMILY) else { continue };
            let Some((id, place)) = table.id(&mut self.problems, "id") else { continue };
            if !self.take("family", &id, place.clone()) {
                continue;
            }
            if let Some(same) = self.out.trajectories.iter().find(|t| t.id == id) {
                let same = same.place.clone();
                let message = format!("a trajectory is called `{id}`, too");
                self.problems
                    .note("derivation::duplicate-id", place, message)
                    .see(same, "this one")
                    .hint("claims expect verdicts of both by their ids");
                self.refused.push(id);
                continue;
            }
            match self.one_family(root, &table, &id, place) {
                Some(family) => Arc::make_mut(&mut self.out.families).push(family),
                None => self.refused.push(id),
            }
        }
    }

    fn one_family(
        &mut self,
        root: &Table<'_, '_>,
        table: &Table<'_, '_>,
        id: &str,
        place: Range<usize>,
    ) -> Option<Family> {
        let before = self.problems.found.len();
        let scope = self.out.scope.clone();
        let title = table.text(&mut self.problems, "title").unwrap_or_else(|| id.to_owned());
        let says = table.text(&mut self.problems, "says");
        let name = table.needed_text(&mut self.problems, "of")?;
        let of_span = table.get("of").map_or(place.clone(), |v| v.span());
        let of = self.trajectory(&name, of_span.clone())?;
        if matches!(self.out.trajectories.get(of)?.motion, Motion::Derived { .. }) {
            let message = format!("`{name}` comes from another trajectory");
            self.problems
                .note("derivation::bad-family", of_span, message)
                .hint("vary the trajectory that it comes from, or give it by a system or by formulas");
            return None;
        }
        let base = base_table(root, &name)?;
        let vary = self.vary(id, table, (&name, &base), &scope);
        let drawn = vary.iter().any(|v| v.spread.is_drawn());
        let draws = self.draws(table, drawn);
        let seed = self.seed(table, drawn);
        let sequence = self.sequence(table, drawn);
        let size = vary.iter().try_fold(draws, |size, v| size.checked_mul(v.spread.points()));
        if size.is_none_or(|size| size > LARGEST_FAMILY) {
            let message = format!("a family has at most {LARGEST_FAMILY} members");
            self.problems
                .note("derivation::too-large", place.clone(), message)
                .hint("take fewer values, or fewer draws");
        }
        if self.problems.found.len() > before || vary.is_empty() {
            return None;
        }
        // The trajectory once more, with what varies left open.
        let leaves: Vec<Leaf> = vary.iter().map(|v| v.leaf).collect();
        let given = self.out.given.len();
        let parameters = self.parameters(&base, None, &scope, &leaves);
        let motion = self.varied_motion(&base, &parameters, &scope, &leaves);
        self.out.given.truncate(given);
        let motion = motion?;
        let constraints = self.constraints(table, (&parameters, &motion), &scope, &leaves);
        let map = self.map_over(table, &vary);
        let boundary = self.boundary(table, (map, &vary));
        let text = self.text_of_members(&base, &vary, &scope);
        let where_span = table.get("where").map(|v| v.span());
        (self.problems.found.len() == before).then(|| Family {
            id: id.to_owned(),
            title,
            says,
            of,
            vary,
            draws,
            seed,
            sequence,
            constraints,
            map,
            boundary,
            where_span,
            parameters,
            motion,
            text,
            span: place,
        })
    }

    /// A number that a spread is given by. As it is written, it has the unit of what it is given to.
    fn end(&mut self, value: &Value<'_>, scope: &Scope, written: &mut Vec<Written<Vec<Expr>>>) -> Option<Expr> {
        let e = self.number_or_formula(value, scope)?;
        let text = self.problems.source.text.get(value.span()).unwrap_or_default();
        // A value of a member is a number of binary64, and what a file says of it is the shortest text for that.
        let shortest = |x: &Rational| exact(&format!("{:e}", x.to_f64().value()));
        if let (DeValue::Float(_) | DeValue::Integer(_), Some(x)) = (value.get_ref(), self.out.graph.as_constant(e))
            && shortest(x).as_ref() != Some(x)
        {
            let message = format!("a member of a family cannot have the value {text}: it has too many digits");
            let hint = "values of members have at most 15 digits; a single trajectory may have any number";
            self.problems.note("derivation::bad-family", value.span(), message).hint(hint);
            return None;
        }
        written.push(Written { text: text.trim_matches('\'').to_owned(), span: value.span(), value: vec![e] });
        self.without_leaves(e, value, scope)
    }

    /// What varies.
    fn vary(&mut self, id: &str, table: &Table<'_, '_>, base: (&str, &Table<'_, '_>), scope: &Scope) -> Vec<Varied> {
        let Some(value) = table.get("vary") else {
            table.missing(&mut self.problems, "vary");
            return Vec::new();
        };
        let DeValue::Table(entries) = value.get_ref() else {
            self.problems.wrong_type(value, "vary", "a table of symbols and how they vary");
            return Vec::new();
        };
        if entries.is_empty() {
            let message = "this family varies nothing";
            let hint = "for instance vary = { 'A' = { from = 0.1, to = 2, count = 20 } }";
            self.problems.note("derivation::bad-family", value.span(), message).hint(hint);
        }
        let mut out: Vec<Varied> = Vec::new();
        for (name, value) in entries {
            let Some(leaf) = self.varied_leaf((name.get_ref(), name.span()), base, scope) else { continue };
            if out.iter().any(|v| v.leaf == leaf) {
                let message = format!("`{}` varies twice", name.get_ref());
                self.problems.note("derivation::duplicate-id", name.span(), message);
                continue;
            }
            let mut written = Vec::new();
            let spread = self.spread(value, scope, &mut written);
            for value in written {
                let trajectory = id.to_owned();
                self.out.given.push(GivenValue { trajectory, symbol: leaf.symbol, rate: leaf.rate, value });
            }
            let Some(spread) = spread else { continue };
            let name = name.get_ref().trim().to_owned();
            let positive = leaf.rate == 0 && self.out.symbols.iter().any(|s| s.symbol == leaf.symbol && s.positive);
            let graph = &self.out.graph;
            let number = |e: Expr| graph.as_constant(e).map(|r| r.to_f64().value());
            if let Some((code, message, hint)) = spread.fault(&name, positive, &number) {
                self.problems.note(code, value.span(), message).hint(hint);
                continue;
            }
            out.push(Varied { leaf, name, spread, positive, span: value.span() });
        }
        out
    }

    /// The symbol that varies: a number to which the base trajectory gives a value.
    fn varied_leaf(
        &mut self,
        (name, place): (&str, Range<usize>),
        (base, given): (&str, &Table<'_, '_>),
        scope: &Scope,
    ) -> Option<Leaf> {
        let (rate, bare) = undotted(name);
        let symbol = self.symbol(bare.trim(), place.clone(), scope)?;
        let key = match scope.role(symbol) {
            Some(Role::Parameter) if scope.definition(symbol).is_some() => {
                let message = format!("`{name}` is a constant: its value is fixed");
                self.problems.note("derivation::bad-role", place, message).hint("leave it out");
                return None;
            }
            Some(Role::Parameter) => "parameters",
            Some(Role::State) => "initial",
            Some(
                Role::Time | Role::Observable | Role::Abbreviation | Role::Argument | Role::Coordinate | Role::Field,
            )
            | None => {
                let message = format!("`{name}` is neither a parameter nor a state");
                let hint = "a family varies parameters and initial values; other quantities follow from them";
                self.problems.note("derivation::bad-role", place, message).hint(hint);
                return None;
            }
        };
        let shape = self.out.graph.shape(symbol);
        if shape.rank() > 0 || shape.is_complex() || self.out.graph.is_diagonal(symbol) {
            let message = format!("`{name}` is not one real number");
            let hint = "give its components by parameters, for instance 'I' = ['a', 'b', 1], and vary these";
            self.problems.note("derivation::wrong-components", place, message).hint(hint);
            return None;
        }
        let entries = given.get(key).and_then(|v| v.get_ref().as_table());
        let is_it = |name: &str| {
            let (its_rate, bare) = if key == "initial" { undotted(name) } else { (0, name) };
            its_rate == rate && scope.symbol(bare.trim()) == Some(symbol)
        };
        if !entries.is_some_and(|t| t.keys().any(|k| is_it(k.get_ref()))) {
            let message = format!("`{base}` gives no value to `{name}`");
            let hint = match (key, given.get("formula").is_some()) {
                ("initial", true) => "its states are formulas in time: vary the parameters in them".to_owned(),
                _ => format!("a family replaces values of its trajectory: add '{name}' to `{key}` there"),
            };
            self.problems.note("derivation::no-value", place, message).hint(hint);
            return None;
        }
        Some(Leaf { rate, ..Leaf::now(symbol, 0) })
    }

    /// How a symbol varies.
    fn spread(&mut self, value: &Value<'_>, scope: &Scope, written: &mut Vec<Written<Vec<Expr>>>) -> Option<Spread> {
        let DeValue::Table(_) = value.get_ref() else {
            self.problems.wrong_type(value, "a symbol that varies", SPREADS);
            return None;
        };
        let table = Table::open(&mut self.problems, value, "a symbol that varies", keys::VARIED)?;
        let ways = ["from", "values", "uniform", "log-uniform", "polar", "normal"];
        let ways: Vec<&str> = ways.into_iter().filter(|key| table.get(key).is_some()).collect();
        let &[way] = &ways[..] else {
            let message = if ways.is_empty() { "how it varies is not said" } else { "it varies in two ways" };
            self.problems.note("derivation::bad-family", value.span(), message).hint(format!("write {SPREADS}"));
            return None;
        };
        for key in ["to", "count", "spacing"].into_iter().filter(|_| way != "from") {
            if let Some(value) = table.get(key) {
                self.problems.note("derivation::unknown-key", value.span(), format!("`{key}` goes with `from` only"));
                return None;
            }
        }
        match way {
            "from" => self.grid(&table, scope, written),
            "values" => {
                let items = table.array(&mut self.problems, "values", "numbers");
                if items.is_empty() && table.get("values").is_some_and(|v| v.get_ref().is_array()) {
                    let message = "this family has no members: `values` is empty";
                    self.problems.note("derivation::bad-family", value.span(), message);
                }
                let values: Vec<Expr> = items.iter().filter_map(|item| self.end(item, scope, written)).collect();
                (values.len() == items.len() && !values.is_empty()).then_some(Spread::Values(values))
            }
            _ => {
                let span = table.get(way).map_or(value.span(), |v| v.span());
                let [a, b] = table.array(&mut self.problems, way, "two numbers") else {
                    if table.get(way).is_some_and(|v| v.get_ref().is_array()) {
                        let message = format!("`{way}` has two numbers");
                        self.problems.note("derivation::bad-range", span, message).hint(format!("write {SPREADS}"));
                    }
                    return None;
                };
                let (a, b) = (self.end(a, scope, written), self.end(b, scope, written));
                let (a, b) = a.zip(b)?;
                Some(match way {
                    "uniform" => Spread::Uniform(a, b),
                    "log-uniform" => Spread::LogUniform(a, b),
                    "polar" => Spread::Polar(a, b),
                    _ => Spread::Normal(a, b),
                })
            }
        }
    }

    /// Values in a row.
    fn grid(&mut self, table: &Table<'_, '_>, scope: &Scope, written: &mut Vec<Written<Vec<Expr>>>) -> Option<Spread> {
        for key in ["to", "count"].into_iter().filter(|key| table.get(key).is_none()) {
            table.missing(&mut self.problems, key);
        }
        let (from, to, count) = (table.get("from")?, table.get("to")?, table.get("count")?);
        let (from, to) = (self.end(from, scope, written), self.end(to, scope, written));
        let number = self.whole(count, "count")?;
        if number < 2 {
            let message = if number == 0 { "this family has no members" } else { "a range has at least its two ends" };
            self.problems
                .note("derivation::bad-number", count.span(), message)
                .hint("`count` is 2 or more; write { values = [a] } for a single value");
            return None;
        }
        let spacing = match table.text(&mut self.problems, "spacing").as_deref() {
            None | Some("linear") => false,
            Some("logarithmic") => true,
            Some(word) => {
                let span = table.get("spacing").map_or(table.span.clone(), |v| v.span());
                let known = ["linear", "logarithmic"];
                self.problems.unknown("derivation::unknown-key", span, "spacing", word, known);
                return None;
            }
        };
        let (from, to) = from.zip(to)?;
        Some(Spread::Grid { from, to, count: number, logarithmic: spacing })
    }

    /// How many are drawn.
    fn draws(&mut self, table: &Table<'_, '_>, drawn: bool) -> u64 {
        let Some(value) = table.get("draws") else {
            if drawn {
                let message = "some values are drawn: `draws` says how many times";
                self.problems
                    .note("derivation::missing-key", table.span.clone(), message)
                    .hint("for instance draws = 200");
            }
            return 1;
        };
        if !drawn {
            let message = "nothing is drawn: the lists and ranges give all members";
            self.problems.note("derivation::bad-family", value.span(), message).hint("leave `draws` out");
            return 1;
        }
        let draws = self.whole(value, "draws").unwrap_or(1);
        if draws == 0 {
            self.problems
                .note("derivation::bad-number", value.span(), "this family has no members")
                .hint("`draws` is 1 or more");
        }
        draws.max(1)
    }

    /// Where the draws begin.
    fn seed(&mut self, table: &Table<'_, '_>, drawn: bool) -> u64 {
        match table.get("seed") {
            Some(value) if drawn => self.whole(value, "seed").unwrap_or(0),
            Some(value) => {
                let message = "nothing is drawn, so there is nothing to seed";
                self.problems.note("derivation::bad-family", value.span(), message).hint("leave `seed` out");
                0
            }
            None if drawn => {
                let message = "some values are drawn: `seed` says which draws";
                self.problems
                    .note("derivation::missing-key", table.span.clone(), message)
                    .hint("any whole number, for instance seed = 1; the same seed gives the same members everywhere");
                0
            }
            None => 0,
        }
    }

    /// How values are drawn.
    fn sequence(&mut self, table: &Table<'_, '_>, drawn: bool) -> Drawing {
        let Some(value) = table.get("sequence") else { return Drawing::Random };
        if !drawn {
            let message = "nothing is drawn, so there is no sequence of draws";
            self.problems.note("derivation::bad-family", value.span(), message).hint("leave `sequence` out");
            return Drawing::Random;
        }
        match text_of(&mut self.problems, value, "sequence") {
            Some("random") | None => Drawing::Random,
            Some("low-discrepancy") => Drawing::LowDiscrepancy,
            Some(word) => {
                let known = ["random", "low-discrepancy"];
                self.problems.unknown("derivation::unknown-key", value.span(), "sequence", word, known);
                Drawing::Random
            }
        }
    }

    /// A whole number, 0 or more.
    pub(super) fn whole(&mut self, value: &Value<'_>, key: &str) -> Option<u64> {
        let DeValue::Integer(number) = value.get_ref() else {
            self.problems.wrong_type(value, key, "a whole number");
            return None;
        };
        let found = u64::from_str_radix(&number.as_str().replace('_', ""), number.radix()).ok();
        let found = found.filter(|n| i64::try_from(*n).is_ok());
        if found.is_none() {
            let message = format!("`{key}` is a whole number, 0 or more");
            self.problems.note("derivation::bad-number", value.span(), message);
        }
        found
    }

    fn varied_motion(
        &mut self,
        base: &Table<'_, '_>,
        parameters: &[ValueOf],
        scope: &Scope,
        varied: &[Leaf],
    ) -> Option<Motion> {
        match base.get("system").is_some() {
            true => self.integrated(base, parameters, scope, varied),
            false => Some(Motion::Formula { states: self.formula_states(base, parameters, scope, varied) }),
        }
    }

    /// What members must satisfy, in what varies alone.
    fn constraints(
        &mut self,
        table: &Table<'_, '_>,
        (parameters, motion): (&[ValueOf], &Motion),
        scope: &Scope,
        varied: &[Leaf],
    ) -> Vec<Constraint> {
        let free = |_: &Scope, leaf: Leaf| varied.contains(&leaf);
        let mut known: Known = parameters.iter().map(|(s, w)| ((*s, 0), w.value.clone())).collect();
        if let Motion::Integrated { initial, .. } = motion {
            for (symbol, _, written) in initial.iter().filter(|(_, rate, _)| *rate == 0) {
                let each = written.value.iter().map(|e| self.resolve(*e, &known, scope, &free));
                if let Ok(values) = each.collect::<Result<Vec<Expr>, Leaf>>() {
                    known.insert((*symbol, 0), values);
                }
            }
        }
        let mut out = Vec::new();
        for formula in table.formulas(&mut self.problems, "where") {
            for written in self.with_one_sign(&formula, scope) {
                let mut links = Vec::new();
                for relation in &written.value.relations {
                    let one = |side: &Tensor| side.as_scalar().filter(|_| side.components.len() == 1);
                    let sides = one(&relation.left).zip(one(&relation.right));
                    let (Some((left, right)), None) = (sides, &relation.limit) else {
                        let message = "a member satisfies relations between numbers";
                        self.problems.note("derivation::bad-family", written.span.clone(), message);
                        continue;
                    };
                    if relation.kind == RelationKind::Equal {
                        let message = "a constraint is an inequality: hardly any member would satisfy an equation";
                        self.problems
                            .note("derivation::bad-family", written.span.clone(), message)
                            .hint("give the trajectory the value by a formula of what varies");
                        continue;
                    }
                    match (self.resolve(left, &known, scope, &free), self.resolve(right, &known, scope, &free)) {
                        (Ok(left), Ok(right)) => links.push((relation.kind, left, right)),
                        (Err(leaf), _) | (_, Err(leaf)) => {
                            let message = format!("`{}` has no value here", self.leaf_name(leaf));
                            let hint = "a constraint may use the parameters and the initial values of the trajectory";
                            self.problems.note("derivation::no-value", written.span.clone(), message).hint(hint);
                        }
                    }
                }
                out.push(Constraint { written, links });
            }
        }
        out
    }

    /// The text that all members share, and where their values go.
    fn text_of_members(&self, base: &Table<'_, '_>, vary: &[Varied], scope: &Scope) -> Vec<Piece> {
        let at = |key: &str, name: &str| {
            let (rate, bare) = if key == "initial" { undotted(name) } else { (0, name) };
            let symbol = scope.symbol(bare.trim())?;
            let states = scope.role(symbol) == Some(Role::State);
            let is_it = |v: &Varied| v.leaf.symbol == symbol && v.leaf.rate == rate && states == (key == "initial");
            vary.iter().position(is_it)
        };
        let raw = |span: Range<usize>| self.problems.source.text.get(span).unwrap_or_default().to_owned();
        let mut out = Vec::new();
        for (key, value) in base.entries {
            let name = key.get_ref().as_ref();
            if ["id", "title", "says"].contains(&name) {
                continue;
            }
            let DeValue::Table(entries) = value.get_ref() else {
                out.push(Piece::Text(format!("{name} = {}\n", raw(value.span()))));
                continue;
            };
            out.push(Piece::Text(format!("{name} = {{ ")));
            for (i, (inner, value)) in entries.iter().enumerate() {
                let comma = if i > 0 { ", " } else { "" };
                out.push(Piece::Text(format!("{comma}{} = ", raw(inner.span()))));
                out.push(match at(name, inner.get_ref()) {
                    Some(position) => Piece::Value(position),
                    None => Piece::Text(raw(value.span())),
                });
            }
            out.push(Piece::Text(" }\n".to_owned()));
        }
        out
    }
}

/// The table of a trajectory.
fn base_table<'a, 's>(root: &Table<'a, 's>, id: &str) -> Option<Table<'a, 's>> {
    let DeValue::Array(items) = root.get("trajectory")?.get_ref() else { return None };
    let entries = items.iter().filter_map(|value| Some((value.get_ref().as_table()?, value.span())));
    let mut found = entries.filter(|(entries, _)| {
        let its = entries.get("id").and_then(|v| v.get_ref().as_str());
        its.is_some_and(|its| its.trim() == id)
    });
    found.next().map(|(entries, span)| Table { entries, span, what: "[[trajectory]]" })
}

impl Loader<'_> {
    /// The families that a table names, in the order of the file.
    pub fn some_families(&mut self, table: &Table<'_, '_>) -> Vec<usize> {
        let mut out: Vec<usize> = Vec::new();
        for (name, span) in table.names(&mut self.problems, "families") {
            let found = self.out.families.iter().position(|f| f.id == name);
            match found {
                Some(at) if out.contains(&at) => {
                    self.problems.note("derivation::duplicate-id", span, format!("`{name}` is listed twice"));
                }
                Some(at) => out.push(at),
                None if self.refused.iter().any(|r| r == name) => {}
                None => {
                    let ids = self.out.families.iter().map(|f| f.id.as_str());
                    self.problems.unknown("derivation::unknown-family", span, "family", name, ids);
                }
            }
        }
        out.sort_unstable();
        out
    }
}
