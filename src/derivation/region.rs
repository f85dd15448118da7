//! `ranges` and `exists`: claims over ranges of values, without a motion.

use std::ops::Range;

use toml::de::DeValue;

use super::form::{Form, FormFormula, FormKind};
use super::formula::{Ranged, Values, Written};
use super::keys;
use super::load::Loader;
use super::model::{Claim, Domain, Formula, Region, SymbolEntry};
use super::table::{Table, Value, as_printed, text_of};
use super::values::Known;
use expr::{Expr, Leaf, Partials, Rational, Symbol};
use latex::{RelationKind, Role, Scope, Statement};

/// The forms that a claim over ranges may have.
const POSSIBLE: &[FormKind] = &[FormKind::Always, FormKind::Defined, FormKind::Exists];
/// Keys that say something of motions.
const OF_MOTIONS: &[&str] = &["trajectories", "families", "at", "follows-from"];

/// What a range looks like.
const HINT: &str = "a range is [from, to], for instance 'c' = [0, 2]; a single value is a number or a formula";

/// A component at the present time.
fn now(symbol: Symbol, component: usize) -> Leaf {
    Leaf::now(symbol, component as u16)
}

impl Loader<'_> {
    /// Reads every `[[domain]]`.
    pub fn domains(&mut self, root: &Table<'_, '_>) {
        for value in root.array(&mut self.problems, "domain", "tables, [[domain]]") {
            let Some(table) = Table::open(&mut self.problems, value, "[[domain]]", keys::DOMAIN) else { continue };
            let Some((id, place)) = table.id(&mut self.problems, "id") else { continue };
            if !self.take("domain", &id, place) {
                continue;
            }
            let says = table.text(&mut self.problems, "says");
            let Some(value) = table.get("ranges") else {
                table.missing(&mut self.problems, "ranges");
                self.refused.push(id);
                continue;
            };
            let scope = self.out.scope.clone();
            let mut ranges = Vec::new();
            self.ranges_of(value, &scope, &[], &mut ranges);
            self.out.domains.push(Domain { id, says, ranges });
        }
    }

    /// `domain` and `ranges`: the values of every symbol of a claim.
    pub fn ranges(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        let mut region = Region::default();
        if let Some(value) = table.get("domain") {
            let Some(name) = text_of(&mut self.problems, value, "domain") else { return };
            match self.out.domains.iter().find(|d| d.id == name) {
                Some(domain) => region.ranges.clone_from(&domain.ranges),
                None if self.refused.iter().any(|r| r == name) => return,
                None => {
                    let ids = self.out.domains.iter().map(|d| d.id.as_str());
                    self.problems.unknown("derivation::unknown-domain", value.span(), "domain", name, ids);
                    return;
                }
            }
        }
        if let Some(value) = table.get("ranges") {
            let scope = claim.scope.clone();
            self.ranges_of(value, &scope, &claim.symbols, &mut region.ranges);
        }
        claim.region = Some(region);
    }

    /// Ranges beside those that are there already.
    fn ranges_of(&mut self, value: &Value<'_>, scope: &Scope, own: &[SymbolEntry], ranges: &mut Vec<Ranged>) {
        let DeValue::Table(entries) = value.get_ref() else {
            self.problems.wrong_type(value, "ranges", "a table of symbols and their ranges");
            return;
        };
        if entries.is_empty() {
            self.problems.note("derivation::empty-claim", value.span(), "`ranges` gives no symbol").hint(HINT);
        }
        for (name, value) in entries {
            let given = self.ranged((name.get_ref(), name.span()), value, scope, own, ranges);
            ranges.extend(given);
        }
    }

    /// The components of one symbol, with their values.
    fn ranged(
        &mut self,
        (name, place): (&str, Range<usize>),
        value: &Value<'_>,
        scope: &Scope,
        own: &[SymbolEntry],
        before: &[Ranged],
    ) -> Vec<Ranged> {
        let Some(symbol) = self.symbol(name.trim(), place.clone(), scope) else { return Vec::new() };
        if matches!(scope.role(symbol), Some(Role::Abbreviation | Role::Argument)) {
            let message = format!("`{name}` stands for a formula, it has no range of its own");
            self.problems
                .note("derivation::bad-role", place, message)
                .hint("give the symbols of its formula a range, or declare it in the claim's `symbols` as a parameter");
            return Vec::new();
        }
        if scope.role(symbol) == Some(Role::Parameter) && scope.definition(symbol).is_some() {
            let message = format!("`{name}` is a constant: it has no range");
            self.problems.note("derivation::bad-role", place, message).hint("leave it out");
            return Vec::new();
        }
        if before.iter().any(|r| r.leaf.symbol == symbol) {
            let message = format!("`{name}` has two ranges");
            self.problems.note("derivation::duplicate-id", place, message);
            return Vec::new();
        }
        if scope.role(symbol) == Some(Role::Field) && scope.definition(symbol).is_some() {
            let message = format!("`{name}` has a formula already");
            self.problems.note("derivation::bad-role", place, message).hint("leave it out");
            return Vec::new();
        }
        let entry = self.out.symbols.iter().chain(own).find(|s| s.symbol == symbol);
        let (unit, positive) = entry.map_or((None, false), |s| (s.unit.clone(), s.positive));
        let graph = &self.out.graph;
        let extents = match (graph.is_diagonal(symbol), graph.shape(symbol).extents()) {
            (true, [n, ..]) => vec![usize::from(*n)],
            (_, extents) => extents.iter().map(|n| usize::from(*n)).collect(),
        };
        if scope.role(symbol) == Some(Role::Field) {
            let formula = Some(written(value));
            let found = self.formulas_of_field((name, symbol), value, scope, before).into_iter();
            let one = |(leaf, values)| Ranged {
                leaf,
                values,
                formula: formula.clone(),
                unit: unit.clone(),
                span: value.span(),
            };
            return found.map(one).collect();
        }
        let mut items = Vec::new();
        if !components_of(value, &extents, &mut items) {
            let count = graph.component_count(symbol);
            let message = format!("`{name}` has {count} components, each with a range or a value");
            let hint = "for instance 'I' = [[2.9, 3.1], 2, 1] for three: a range, and two values";
            self.problems.note("derivation::wrong-components", value.span(), message).hint(hint);
            return Vec::new();
        }
        let mut out = Vec::new();
        for (component, item) in items.into_iter().enumerate() {
            let Some(values) = self.values_of_one(item, scope, before) else { continue };
            self.check_range(name, &values, positive, item.span());
            if !self.depends_as_declared(symbol, &values, name, item.span()) {
                continue;
            }
            let depends = matches!(values, Values::One(e) if !self.out.graph.leaves_within([e]).is_empty());
            let formula = depends.then(|| written(item));
            out.push(Ranged { leaf: now(symbol, component), values, formula, unit: unit.clone(), span: item.span() });
        }
        out
    }

    /// Refuses what names coordinates on which it does not depend: a derivative by one of them would be wrong.
    fn depends_as_declared(&mut self, symbol: Symbol, values: &Values, name: &str, span: Range<usize>) -> bool {
        let graph = &self.out.graph;
        let (message, hint) = match values {
            Values::Between(..) => return true,
            Values::One(e) => {
                let foreign = |leaf: &Leaf| graph.coordinate(*leaf).is_some_and(|at| !graph.depends(symbol, at));
                let Some(leaf) = graph.leaves_within([*e]).into_iter().find(foreign) else { return true };
                let message = format!("`{name}` does not depend on `{}`", graph.name(leaf.symbol));
                (message, "declare it as a field of its coordinates")
            }
        };
        self.problems.note("derivation::bad-range", span, message).hint(hint);
        false
    }

    /// A field's formula, for each component.
    fn formulas_of_field(
        &mut self,
        (name, symbol): (&str, Symbol),
        value: &Value<'_>,
        scope: &Scope,
        before: &[Ranged],
    ) -> Vec<(Leaf, Values)> {
        let Some(written) = self.components(value, symbol, scope) else { return Vec::new() };
        let mut out = Vec::new();
        for (component, e) in written.value.into_iter().enumerate() {
            let Some(e) = self.given_before(e, value.span(), scope, before) else { continue };
            let values = Values::One(e);
            if self.depends_as_declared(symbol, &values, name, value.span()) {
                out.push((now(symbol, component), values));
            }
        }
        out
    }

    /// A range or a value.
    fn values_of_one(&mut self, value: &Value<'_>, scope: &Scope, before: &[Ranged]) -> Option<Values> {
        match value.get_ref() {
            DeValue::Array(items) => match &items[..] {
                [from, to] => {
                    let from = self.closed(from, scope)?;
                    Some(Values::Between(from, self.closed(to, scope)?))
                }
                _ => {
                    let message = "a range has two ends";
                    self.problems.note("derivation::bad-range", value.span(), message).hint(HINT);
                    None
                }
            },
            _ => {
                let one = self.number_or_formula(value, scope)?;
                self.given_before(one, value.span(), scope, before).map(Values::One)
            }
        }
    }

    /// An expression of what is given before it.
    fn given_before(&mut self, e: Expr, span: Range<usize>, scope: &Scope, before: &[Ranged]) -> Option<Expr> {
        let free = |_: &Scope, leaf: Leaf| before.iter().any(|r| r.leaf == leaf);
        match self.resolve(e, &Known::new(), scope, &free) {
            Ok(e) => Some(e),
            Err(leaf) => {
                let message = format!("`{}` has no value here", self.leaf_name(leaf));
                let hint = "a value may use the symbols that are given before it";
                self.problems.note("derivation::no-value", span, message).hint(hint);
                None
            }
        }
    }

    /// An end of a range: an expression without leaves.
    fn closed(&mut self, value: &Value<'_>, scope: &Scope) -> Option<Expr> {
        let e = self.number_or_formula(value, scope)?;
        self.without_leaves(e, value, scope)
    }

    /// The same of what was read already.
    pub(super) fn without_leaves(&mut self, e: Expr, value: &Value<'_>, scope: &Scope) -> Option<Expr> {
        match self.resolve(e, &Known::new(), scope, &|_, _| false) {
            Ok(e) => Some(e),
            Err(leaf) => {
                let message = format!("the end of a range is a number, `{}` is none", self.leaf_name(leaf));
                self.problems.note("derivation::bad-range", value.span(), message).hint(HINT);
                None
            }
        }
    }

    /// Notes what is wrong with a range as far as its ends are rational numbers; the others are compared when it is used.
    fn check_range(&mut self, name: &str, values: &Values, positive: bool, span: Range<usize>) {
        let number = |e: &Expr| self.out.graph.as_constant(*e).cloned();
        let (from, to) = match values {
            Values::Between(from, to) => (number(from), number(to)),
            Values::One(e) => (number(e), None),
        };
        if let (Some(from), Some(to)) = (&from, &to)
            && from >= to
        {
            let (message, hint) = if from == to {
                ("both ends of this range are the same number", "write the number alone")
            } else {
                ("the ends of this range are in the wrong order", "the smaller one comes first")
            };
            self.problems.note("derivation::bad-range", span, message).hint(hint);
        } else if positive && from.is_some_and(|r| r <= Rational::ZERO) {
            let message = format!("`{name}` is declared positive");
            self.problems
                .note("derivation::not-positive", span, message)
                .hint("both ends belong to the range: begin it above 0");
        }
    }

    /// `exists`: equations have a solution.
    pub fn exists(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        let Some(value) = table.get("exists") else { return };
        let Some(table) = Table::open(&mut self.problems, value, "exists", keys::EXISTS) else { return };
        for key in ["unknowns", "such-that"].iter().filter(|k| table.get(k).is_none()) {
            table.missing(&mut self.problems, key);
        }
        let scope = claim.scope.clone();
        let given = claim.region.as_ref().map_or(&[][..], |r| &r.ranges);
        let mut unknowns: Vec<Ranged> = Vec::new();
        if let Some(value) = table.get("unknowns") {
            let DeValue::Table(entries) = value.get_ref() else {
                self.problems.wrong_type(value, "unknowns", "a table of symbols and their ranges");
                return;
            };
            for (name, value) in entries {
                let found = self.ranged((name.get_ref(), name.span()), value, &scope, &claim.symbols, &unknowns);
                for unknown in found {
                    if matches!(unknown.values, Values::One(_)) {
                        let message = "an unknown is looked for in a range";
                        self.problems.note("derivation::bad-range", value.span(), message).hint(HINT);
                    } else if given.iter().any(|g| g.leaf == unknown.leaf) {
                        let message = format!("`{}` is in `ranges`, it is not unknown", self.leaf_name(unknown.leaf));
                        self.problems.note("derivation::duplicate-id", name.span(), message);
                    } else {
                        unknowns.push(unknown);
                    }
                }
            }
        }
        let mut such_that: Vec<Written<Statement>> = Vec::new();
        for formula in table.formulas(&mut self.problems, "such-that") {
            claim.formulas.push(Formula { text: formula.printed(), kind: FormKind::Exists });
            such_that.extend(self.statements(&formula, &scope));
        }
        let unique = table.boolean(&mut self.problems, "unique").unwrap_or(false);
        if unknowns.is_empty() || such_that.is_empty() {
            return;
        }
        let relations = || such_that.iter().flat_map(|w| &w.value.relations);
        let equations: usize =
            relations().filter(|r| r.kind == RelationKind::Equal).map(|r| r.left.components.len()).sum();
        if equations != unknowns.len() {
            let message = format!("{equations} equations for {} unknowns", unknowns.len());
            self.problems
                .note("derivation::not-square", value.span(), message)
                .hint("there must be as many equations as unknowns, counted by components; other relations are free");
        }
        if let Some(w) = such_that.iter().find(|w| w.value.relations.iter().any(|r| r.has_branches)) {
            self.problems.note("derivation::bad-region", w.span.clone(), "± cannot stand in `such-that`");
        }
        claim.region.get_or_insert_default();
        claim.forms.push(Form::Exists { unknowns, such_that, unique });
    }

    /// Sees to it that a claim over ranges speaks of nothing else; it is tried on no motion.
    pub fn confine(&mut self, claim: &mut Claim, tables: &[&Table<'_, '_>]) {
        let Some(region) = claim.region.clone() else { return self.of_fields(claim, tables) };
        claim.trajectories.clear();
        claim.expect.clear();
        claim.families.clear();
        claim.expect_of_families.clear();
        for key in OF_MOTIONS {
            if let Some(value) = tables.iter().find_map(|t| t.get(key)) {
                let message = format!("a claim over ranges has no `{key}`: there is no motion");
                self.problems
                    .note("derivation::bad-region", value.span(), message)
                    .hint("give ranges to everything that the claim depends on, or take `ranges` out");
            }
        }
        if claim.branches_throughout {
            let message = "a claim over ranges allows either sign of ± at each point";
            self.problems.note("derivation::bad-region", claim.span.clone(), message).hint("take `branches` out");
        }
        self.solves_everywhere(claim);
        if let Some(form) = claim.forms.iter().find(|f| !POSSIBLE.contains(&f.kind())) {
            let message = format!("`{}` is said of a motion, not of ranges of values", form.kind().key());
            self.problems
                .note("derivation::bad-region", claim.span.clone(), message)
                .hint("a claim over ranges says `always`, `defined` or `exists`");
            return;
        }
        let exists = claim.forms.iter().filter(|f| f.kind() == FormKind::Exists).count();
        if exists > 0 && claim.forms.len() > exists {
            let message = "`exists` stands alone: what is said beside it is another claim";
            self.problems.note("derivation::bad-region", claim.span.clone(), message);
        }
        let known: Vec<Leaf> = region.ranges.iter().map(|r| r.leaf).collect();
        // A range that was refused is not missed a second time.
        let refused = |name: &str| {
            let components = |s: Symbol| known.iter().filter(|l| l.symbol == s).count();
            claim.scope.symbol(name).is_none_or(|s| components(s) < self.out.graph.component_count(s))
        };
        let listed = tables.iter().find_map(|t| t.get("ranges")).and_then(|v| v.get_ref().as_table());
        if listed.is_some_and(|t| t.keys().any(|name| refused(name.get_ref().trim()))) {
            return;
        }
        for written in &claim.assuming.clone() {
            self.only_of(&claim.scope, &written.value, &written.span, &known);
        }
        for form in claim.forms.clone() {
            match &form {
                Form::Always(w) => self.only_of(&claim.scope, &w.value, &w.span, &known),
                Form::Defined(w) => {
                    self.only(&claim.scope, &w.value.components, &w.span, &known);
                }
                Form::Exists { unknowns, such_that, .. } => {
                    let all: Vec<Leaf> = known.iter().copied().chain(unknowns.iter().map(|u| u.leaf)).collect();
                    such_that.iter().for_each(|w| self.only_of(&claim.scope, &w.value, &w.span, &all));
                }
                _ => {}
            }
        }
    }

    /// What it means that fields solve their equations on a domain: that these hold there, and that both sides have a value at
    /// every point. What has a kink inside solves nothing there.
    fn solves_everywhere(&self, claim: &mut Claim) {
        let mut forms = Vec::with_capacity(claim.forms.len());
        for form in std::mem::take(&mut claim.forms) {
            match form {
                Form::Solves { system } if self.out.systems[system].states.is_empty() => {
                    for equation in &self.out.systems[system].equations {
                        let relations = equation.value.relations.iter();
                        let sides = relations.flat_map(|r| [r.left.clone(), r.right.clone()]).collect::<Vec<_>>();
                        forms.push(Form::Always(equation.clone()));
                        forms.extend(sides.into_iter().map(|value| {
                            Form::Defined(Written { text: equation.text.clone(), span: equation.span.clone(), value })
                        }));
                    }
                }
                other => forms.push(other),
            }
        }
        claim.forms = forms;
    }

    /// A claim about fields without ranges is tried on no motion: it follows from something, or not.
    fn of_fields(&mut self, claim: &mut Claim, tables: &[&Table<'_, '_>]) {
        let assumed = claim.assuming.iter().flat_map(|w| components(&w.value));
        let said = claim.forms.iter().flat_map(Form::formulas).flat_map(|formula| match formula {
            FormFormula::Statement(w) => components(&w.value),
            FormFormula::Quantity(w) => w.value.components.clone(),
            FormFormula::Limit { value, .. } => value.value.components.clone(),
        });
        let roots: Vec<Expr> = assumed.chain(said).collect();
        let place = |l: &Leaf| matches!(claim.scope.role(l.symbol), Some(Role::Coordinate | Role::Field));
        let leaves = self.out.graph.leaves_within(roots);
        let Some(leaf) = leaves.iter().find(|l| self.out.graph.is_field(l.symbol) || place(l)) else { return };
        let name = self.leaf_name(*leaf);
        claim.region = Some(Region::default());
        claim.trajectories.clear();
        claim.expect.clear();
        claim.families.clear();
        claim.expect_of_families.clear();
        let about = format!("`{name}` has no value along a motion");
        let hint = "give everything in the claim a range or a formula in `ranges`, or let it follow from something";
        // That it is tried on no motion may be said.
        let names_some = |value: &&Value<'_>| value.get_ref().as_array().is_none_or(|all| !all.is_empty());
        let mut of_motions = OF_MOTIONS[..3].iter().flat_map(|key| tables.iter().filter_map(|t| t.get(key)));
        if let Some(value) = of_motions.find(names_some) {
            self.problems.note("derivation::bad-region", value.span(), about).hint(hint);
        } else if let Some(form) = claim.forms.iter().find(|f| f.kind() != FormKind::Always) {
            let message = format!("{about}, and `{}` is said of motions", form.kind().key());
            self.problems.note("derivation::bad-region", claim.span.clone(), message).hint(hint);
        }
    }

    /// The relations of a statement have values where the known components have.
    fn only_of(&mut self, scope: &Scope, statement: &Statement, span: &Range<usize>, known: &[Leaf]) {
        for relation in &statement.relations {
            if relation.limit.is_some() {
                let message = "a limit is taken along a motion, not over ranges of values";
                self.problems.note("derivation::bad-region", span.clone(), message);
                return;
            }
            if relation.kind != RelationKind::Equal && relation.left.shape.rank() > 0 {
                let message = "only numbers are compared over ranges, and equations may have components";
                self.problems.note("derivation::bad-region", span.clone(), message);
                return;
            }
            let sides: Vec<Expr> = relation.left.components.iter().chain(&relation.right.components).copied().collect();
            if !self.only(scope, &sides, span, known) {
                return;
            }
        }
    }

    /// The same for expressions; whether it is so.
    fn only(&mut self, scope: &Scope, roots: &[Expr], span: &Range<usize>, known: &[Leaf]) -> bool {
        let sign = scope.branch_sign();
        // What is known of a field is known of its derivatives.
        let itself = |leaf: Leaf| Leaf { partials: Partials::NONE, ..leaf };
        let free = |_: &Scope, leaf: Leaf| leaf == sign || known.contains(&itself(leaf));
        for &root in roots {
            let Err(leaf) = self.resolve(root, &Known::new(), scope, &free) else { continue };
            let name = self.leaf_name(Leaf { rate: 0, partials: Partials::NONE, instant: None, ..leaf });
            let base = self.out.graph.name(leaf.symbol).to_owned();
            let (message, hint) = if leaf.rate > 0 {
                let message = format!("`{}` is a rate: a claim over ranges has no motion", self.leaf_name(leaf));
                (message, "take `ranges` out to try it on trajectories, or write a symbol for the rate".to_owned())
            } else if leaf.instant.is_some() {
                let message = format!("`{name}` at a fixed time is a value along a motion, of which there is none");
                (message, "take `ranges` out to try it on trajectories, or write a parameter for it".to_owned())
            } else if scope.role(leaf.symbol) == Some(Role::Field) {
                let message = format!("`{name}` has no formula here");
                (message, format!(r"add '{base}' to `ranges`, for instance '{base}' = '\sin x'"))
            } else if matches!(scope.role(leaf.symbol), Some(Role::Parameter | Role::Coordinate)) {
                let message = format!("`{name}` has no range");
                (message, format!("add '{base}' to `ranges`, as [from, to] or as one value"))
            } else {
                let message = format!("`{name}` changes along a motion, and a claim over ranges has none");
                (message, format!("add '{base}' to `ranges`: it is then a number among others; or take `ranges` out"))
            };
            self.problems.note("derivation::no-range", span.clone(), message).hint(hint);
            return false;
        }
        true
    }

    /// A number, or a formula for one.
    pub(super) fn number_or_formula(&mut self, value: &Value<'_>, scope: &Scope) -> Option<Expr> {
        if value.get_ref().is_array() {
            self.problems.note("derivation::bad-range", value.span(), "a number is needed here").hint(HINT);
            return None;
        }
        self.scalar_component(value, scope)
    }
}

/// Formulas and numbers as they are written; several in parentheses.
fn written(value: &Value<'_>) -> String {
    match value.get_ref() {
        DeValue::Array(items) => format!("({})", items.iter().map(written).collect::<Vec<_>>().join(",")),
        DeValue::String(text) => as_printed(text),
        DeValue::Integer(n) => n.as_str().to_owned(),
        DeValue::Float(x) => x.as_str().to_owned(),
        DeValue::Boolean(_) | DeValue::Datetime(_) | DeValue::Table(_) => String::new(),
    }
}

/// Both sides of every relation.
fn components(statement: &Statement) -> Vec<Expr> {
    let sides = statement.relations.iter().flat_map(|r| r.left.components.iter().chain(&r.right.components));
    sides.copied().collect()
}

/// The values of all components, one item for each, as an array of arrays has them; whether there are as many as needed.
fn components_of<'v, 's>(value: &'v Value<'s>, extents: &[usize], out: &mut Vec<&'v Value<'s>>) -> bool {
    let Some((&n, inner)) = extents.split_first() else {
        out.push(value);
        return true;
    };
    match value.get_ref() {
        DeValue::Array(items) if items.len() == n => items.iter().all(|item| components_of(item, inner, out)),
        _ => false,
    }
}
