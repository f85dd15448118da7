//! `independent-of`, `scales-as`, `monotone`, `extremum` and `limit`: claims that compare the members of a family with one another.
//!
//! **In:** the table of such a form, in a claim whose `families` and `at` are read. **Out:** an [`Across`]. **Guaranteed:** every family
//! that the claim names varies the symbol, and says which value follows which where that matters; the quantity is one number of
//! each member, since it does not move or is taken at an event. Such a claim says nothing else, and is tried on no trajectory.

use std::ops::Range;

use super::dependence::{Dependence, End, NoOther};
use super::form::{Across, Form, FormKind};
use super::formula::Written;
use super::keys;
use super::load::Loader;
use super::model::{Claim, Formula};
use super::motions::undotted;
use super::number::finite;
use super::table::{Table, Value, text_of};
use expr::{Expr, Leaf, Tensor};
use latex::{Role, Scope};

impl Loader<'_> {
    /// Reads one of these forms.
    pub(super) fn across(&mut self, claim: &mut Claim, table: &Table<'_, '_>, kind: FormKind) {
        let Some(value) = table.get(kind.key()) else { return };
        let (name, known) = match kind {
            FormKind::ScalesAs => ("scales-as", keys::SCALES_AS),
            FormKind::Monotone => ("monotone", keys::MONOTONE),
            FormKind::IndependentOf => ("independent-of", keys::INDEPENDENT_OF),
            FormKind::Extremum => ("extremum", keys::EXTREMUM),
            FormKind::Limit => ("limit", keys::LIMIT),
            _ => return,
        };
        let Some(inner) = Table::open(&mut self.problems, value, name, known) else { return };
        if !self.stands_alone(claim, table, kind, value.span()) {
            return;
        }
        let of = inner.formula(&mut self.problems, "of");
        for key in ["of", "with"].into_iter().filter(|key| inner.get(key).is_none()) {
            inner.missing(&mut self.problems, key);
        }
        let of = of.and_then(|f| {
            claim.formulas.push(Formula { text: f.printed(), kind });
            self.quantity(&f, &claim.scope)
        });
        let with = inner.text(&mut self.problems, "with");
        let dependence = self.dependence(&inner, kind);
        let before = self.problems.found.len();
        let (point, limit) = self.point(claim, &inner, kind);
        let (Some(of), Some(with), Some(dependence)) = (of, with, dependence) else { return };
        if self.problems.found.len() > before
            || ![Some(&of), limit.as_ref()].into_iter().flatten().all(|w| self.is_one_number(claim, w))
        {
            return;
        }
        let place = inner.get("with").map_or(value.span(), |v| v.span());
        let (rate, bare) = undotted(&with);
        let Some(symbol) = self.symbol(bare.trim(), place.clone(), &claim.scope) else { return };
        let leaf = Leaf { rate, ..Leaf::now(symbol, 0) };
        if let Some(limit) =
            limit.as_ref().filter(|w| self.out.graph.leaves_within(w.value.components.iter().copied()).contains(&leaf))
        {
            let message = format!("the limit is one number, and `{}` tends to something itself", with.trim());
            self.problems
                .note("derivation::bad-family", limit.span.clone(), message)
                .hint("write what is left of it where it has its limit");
            return;
        }
        if !claim.families.iter().all(|&at| self.is_varied_by(at, leaf, (&with, &place), dependence)) {
            return;
        }
        // What compares members is tried on these alone.
        claim.trajectories.clear();
        claim.expect.clear();
        let (name, values) = (with.trim().to_owned(), Err(NoOther::NoMember));
        let others = Vec::new();
        let across = Across { of, with: leaf, name, dependence, point, value: limit, others, values };
        claim.forms.push(Form::Across(Box::new(across)));
    }

    /// Where an extremum lies, or what the symbol tends to, and the limit.
    fn point(
        &mut self,
        claim: &mut Claim,
        table: &Table<'_, '_>,
        kind: FormKind,
    ) -> (Option<Written<Expr>>, Option<Written<Tensor>>) {
        if kind == FormKind::Extremum {
            return (self.place(table, "at", &claim.scope), None);
        }
        if kind != FormKind::Limit {
            return (None, None);
        }
        let point = match end(table) {
            End::Number => self.place(table, "tends-to", &claim.scope),
            End::Infinity | End::MinusInfinity => None,
        };
        (point, self.limit(claim, table))
    }

    /// A number at which something is.
    fn place(&mut self, table: &Table<'_, '_>, key: &str, scope: &Scope) -> Option<Written<Expr>> {
        let Some(value) = table.get(key) else {
            table.missing(&mut self.problems, key);
            return None;
        };
        let e = self.number_or_formula(value, scope)?;
        let e = self.without_leaves(e, value, scope)?;
        Some(Written { text: self.text_at(value), span: value.span(), value: e })
    }

    /// The value of a limit: a number, or a formula in what stays the same.
    fn limit(&mut self, claim: &mut Claim, table: &Table<'_, '_>) -> Option<Written<Tensor>> {
        let Some(value) = table.get("value") else {
            table.missing(&mut self.problems, "value");
            return None;
        };
        if value.get_ref().is_str() {
            let formula = table.formula(&mut self.problems, "value")?;
            claim.formulas.push(Formula { text: formula.printed(), kind: FormKind::Limit });
            return self.quantity(&formula, &claim.scope);
        }
        let e = self.number_or_formula(value, &claim.scope)?;
        Some(Written { text: self.text_at(value), span: value.span(), value: Tensor::scalar(e) })
    }

    /// A number or a formula as it is written.
    fn text_at(&self, value: &Value<'_>) -> String {
        let text = self.problems.source.text.get(value.span()).unwrap_or_default();
        text.trim_matches('\'').trim().to_owned()
    }

    /// Whether the claim says this alone, of families.
    fn stands_alone(&mut self, claim: &Claim, table: &Table<'_, '_>, kind: FormKind, place: Range<usize>) -> bool {
        let key = kind.key();
        let mut refuse = |message: String, hint: &str| {
            self.problems.note("derivation::bad-family", place.clone(), message).hint(hint.to_owned());
            false
        };
        let several = claim.forms.iter().any(|f| !matches!(f, Form::Across(_) if f.kind() == kind));
        let others = FormKind::ALL.iter().any(|f| *f != kind && table.get(f.key()).is_some());
        if several || others {
            return refuse(format!("`{key}` stands beside another form"), "say it in a claim of its own");
        }
        if claim.region.is_some() {
            return refuse(
                format!("`{key}` compares motions, and this claim is over ranges"),
                "name `families` instead",
            );
        }
        if claim.families.is_empty() {
            return refuse(format!("`{key}` compares the members of a family"), "say of which: families = [\"…\"]");
        }
        if claim.names_trajectories && !claim.trajectories.is_empty() {
            return refuse(
                format!("`{key}` compares the members of a family, and no trajectories"),
                "leave `trajectories` out",
            );
        }
        if !claim.assuming.is_empty() {
            return refuse(format!("`{key}` has no assumptions"), "exclude members by `where` in the family");
        }
        true
    }

    /// Whether the quantity is one real number of each motion.
    fn is_one_number(&mut self, claim: &Claim, of: &Written<Tensor>) -> bool {
        let mut refuse = |message: &str, hint: &str| {
            self.problems.note("derivation::bad-family", of.span.clone(), message).hint(hint.to_owned());
            false
        };
        let leaves = self.out.graph.leaves_within(of.value.components.iter().copied());
        if of.value.as_scalar().is_none() || of.value.components.len() != 1 {
            return refuse("members are compared by one real number", "give one component, or one part");
        }
        if leaves.contains(&claim.scope.branch_sign()) {
            return refuse("± has no meaning here", "write a reading for each sign");
        }
        let moves = |leaf: &Leaf| {
            let role = claim.scope.role(leaf.symbol);
            leaf.instant.is_none() && matches!(role, Some(Role::State | Role::Observable | Role::Time))
        };
        if claim.at.is_none() && leaves.iter().any(moves) {
            return refuse(
                "this moves, so that it is not said which of its values are compared",
                "say when by `at`, or take the value at a time, such as q(0)",
            );
        }
        true
    }

    /// Whether a family varies a symbol, in a way that can be compared.
    fn is_varied_by(
        &mut self,
        at: usize,
        leaf: Leaf,
        (name, place): (&str, &Range<usize>),
        dependence: Dependence,
    ) -> bool {
        let family = &self.out.families[at];
        let id = &family.id;
        let (message, hint) = match family.vary.iter().find(|v| v.leaf == leaf) {
            None => {
                let names: Vec<String> = family.vary.iter().map(|v| format!("`{}`", v.name)).collect();
                (format!("the family `{id}` does not vary `{name}`"), format!("it varies {}", names.join(", ")))
            }
            Some(v) if v.spread.is_drawn() && dependence.is_of_neighbours() => (
                format!("the family `{id}` draws `{name}`, so that no value follows another"),
                "compare the members of a row: { from = a, to = b, count = n }".to_owned(),
            ),
            Some(v)
                if !v.spread.is_drawn() && v.spread.points() < 2 && !matches!(dependence, Dependence::Limit { .. }) =>
            {
                (format!("the family `{id}` has one value of `{name}`"), "give it several".to_owned())
            }
            Some(_) => return true,
        };
        self.problems.note("derivation::bad-family", place.clone(), message).hint(hint);
        false
    }

    /// How the quantity depends on what varies.
    fn dependence(&mut self, table: &Table<'_, '_>, kind: FormKind) -> Option<Dependence> {
        match kind {
            FormKind::ScalesAs => {
                let power = self.real(table, "power");
                let to = self.above_zero(table, "how far the slope may be off, for instance 0.01");
                let (power, to) = (power?, to?);
                Some(Dependence::Power { power, to })
            }
            FormKind::Extremum => {
                let to = self.above_zero(table, "how precisely its place is said, for instance 0.01");
                let Some(value) = table.get("kind") else {
                    table.missing(&mut self.problems, "kind");
                    return None;
                };
                let word = text_of(&mut self.problems, value, "kind")?;
                let known = ["maximum", "minimum"];
                if !known.contains(&word) {
                    self.problems.unknown("derivation::unknown-key", value.span(), "kind", word, known);
                    return None;
                }
                Some(Dependence::Extremum { maximum: word == "maximum", to: to? })
            }
            FormKind::Limit => {
                let to = self.above_zero(table, "how far the limit may be off, for instance 1e-6")?;
                Some(Dependence::Limit { end: end(table), to })
            }
            FormKind::Monotone => {
                let Some(value) = table.get("direction") else {
                    table.missing(&mut self.problems, "direction");
                    return None;
                };
                match text_of(&mut self.problems, value, "direction")? {
                    "increasing" => Some(Dependence::Increasing),
                    "decreasing" => Some(Dependence::Decreasing),
                    word => {
                        let known = ["increasing", "decreasing"];
                        self.problems.unknown("derivation::unknown-key", value.span(), "direction", word, known);
                        None
                    }
                }
            }
            FormKind::IndependentOf => Some(Dependence::Independent),
            _ => None,
        }
    }

    /// The number `to`, which lies above 0.
    fn above_zero(&mut self, table: &Table<'_, '_>, hint: &str) -> Option<f64> {
        let to = self.real(table, "to")?;
        if to > 0.0 {
            return Some(to);
        }
        let place = table.get("to").map_or(table.span.clone(), |v| v.span());
        self.problems.note("derivation::bad-number", place, "`to` lies above 0").hint(hint.to_owned());
        None
    }

    /// A number that a table needs.
    fn real(&mut self, table: &Table<'_, '_>, key: &str) -> Option<f64> {
        let Some(value): Option<&Value<'_>> = table.get(key) else {
            table.missing(&mut self.problems, key);
            return None;
        };
        finite(&mut self.problems, value, key)
    }
}

/// What the symbol of a limit tends to.
fn end(table: &Table<'_, '_>) -> End {
    match table.get("tends-to").and_then(|v| v.get_ref().as_str()).map(str::trim) {
        Some("\\infty" | "+\\infty") => End::Infinity,
        Some("-\\infty") => End::MinusInfinity,
        _ => End::Number,
    }
}
