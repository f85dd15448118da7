//! `[[claim]]`, its readings, and `[[measure]]`.

use std::ops::Range;

use toml::de::DeValue;

use super::form::{Form, FormKind};
use super::formula::Written;
use super::keys;
use super::load::{Loader, written};
use super::model::{Claim, Formula, Measure};
use super::number::finite;
use super::role::ClaimRole;
use super::table::{Literal, Table, Value, text_of};
use expr::Tensor;
use latex::Statement;

/// The precision that is asked for where a claim does not say.
pub const DEFAULT_PRECISION: f64 = 1e-9;

fn has_forms(table: &Table<'_, '_>) -> bool {
    FormKind::ALL.iter().any(|f| table.get(f.key()).is_some())
}

/// The names of a claim: its id, and `id/reading` for each of its readings.
fn names_of(table: &Table<'_, '_>, id: &str) -> Vec<String> {
    let readings = match table.get("reading").map(|v| v.get_ref()) {
        Some(DeValue::Array(readings)) => &readings[..],
        _ => &[],
    };
    let name = |reading: &Value<'_>| {
        let name = reading.get_ref().get("id")?.get_ref().as_str()?.trim();
        Some(format!("{id}/{name}"))
    };
    [id.to_owned()].into_iter().chain(readings.iter().filter_map(name)).collect()
}

/// Keeps a claim whose formulas took too much work to be read, without them.
fn leave_unread(claim: &mut Claim, why: &str) {
    let kind = claim.formulas.first().map_or(FormKind::Always, |formula| formula.kind);
    claim.forms = vec![Form::Unread { kind, why: why.to_owned() }];
    (claim.assuming, claim.at) = (Vec::new(), None);
}

/// Claims are tried on so many motions together; of each pair the verdict is kept.
const MOST_PAIRS: usize = 100_000;

/// Most formulas that a claim assumes: each is looked at beside all others.
const MOST_ASSUMED: usize = 200;

impl Loader<'_> {
    /// Reads every `[[claim]]`; `follows-from` is resolved when all ids are known.
    pub fn claims(&mut self, root: &Table<'_, '_>) {
        let known: Vec<&str> = keys::READING.iter().chain(keys::CLAIM).copied().collect();
        let mut tables = Vec::new();
        for value in root.array(&mut self.problems, "claim", "tables, [[claim]]") {
            let Some(table) = Table::open(&mut self.problems, value, "[[claim]]", &known) else { continue };
            let Some((id, span)) = table.id(&mut self.problems, "id") else { continue };
            if self.take("claim", &id, span.clone()) {
                tables.push((table, id, span));
            }
        }
        let ids: Vec<String> = tables.iter().flat_map(|(table, id, _)| names_of(table, id)).collect();
        let mut pairs = 0;
        for (table, id, span) in tables {
            let (before, claims) = (self.problems.found.len(), self.out.claims.len());
            self.one_claim(&table, id, span.clone(), &ids);
            let further = self.out.claims[claims..].iter().map(|claim| claim.trajectories.len()).sum::<usize>();
            if pairs <= MOST_PAIRS && pairs + further > MOST_PAIRS {
                let message = format!("with this claim there are more than {MOST_PAIRS} pairs of a claim and a motion");
                let hint = "name the `trajectories` of a claim, or make many motions a `[[family]]`";
                self.problems.note("derivation::too-many", span, message).hint(hint);
            }
            pairs += further;
            if let Some(why) = self.only_too_large(before) {
                self.out.claims[claims..].iter_mut().for_each(|claim| leave_unread(claim, &why));
            }
        }
    }

    /// One claim with its readings.
    fn one_claim(&mut self, table: &Table<'_, '_>, id: String, span: Range<usize>, ids: &[String]) {
        let problems = &mut self.problems;
        let mut base = Claim {
            reading: None,
            says: table.needed_text(problems, "says").unwrap_or_default(),
            parent_says: None,
            place: table.text(problems, "place"),
            label: table.text(problems, "label"),
            printed: true,
            role: ClaimRole::Says,
            conclusion: false,
            postulate: false,
            rests_on: Vec::new(),
            remark: table.text(problems, "remark"),
            symbols: Vec::new(),
            formulas: Vec::new(),
            assuming: Vec::new(),
            forms: Vec::new(),
            at: None,
            follows_from: Vec::new(),
            precision: DEFAULT_PRECISION,
            branches_throughout: false,
            trajectories: (0..self.out.trajectories.len()).collect(),
            names_trajectories: false,
            expect: Vec::new(),
            families: Vec::new(),
            expect_of_families: Vec::new(),
            expect_alone: None,
            expect_inconsistent_units: false,
            region: None,
            scope: self.out.scope.clone(),
            id,
            span,
        };
        if table.get("conclusion").is_some() {
            base.conclusion = table.boolean(&mut self.problems, "conclusion").unwrap_or(false);
        }
        if let Some(value) = table.get("postulate") {
            base.postulate = table.boolean(&mut self.problems, "postulate").unwrap_or(false);
            let other = ["follows-from", "conclusion"].into_iter().find_map(|key| table.get(key));
            if let (true, Some(other)) = (base.postulate, other) {
                self.problems
                    .note(
                        "derivation::wrong-type",
                        value.span(),
                        "a postulate follows from nothing, and is no conclusion",
                    )
                    .see(other.span(), "this says something else")
                    .hint("leave one of them out");
            }
        }
        base.rests_on = self.rests_on(table, &base, ids);
        self.fill(&mut base, table, ids);

        let readings = table.array(&mut self.problems, "reading", "tables, [[claim.reading]]");
        let mut seen: Vec<(String, Range<usize>)> = Vec::new();
        let mut entries = Vec::new();
        for value in readings {
            let reading = Table::open(&mut self.problems, value, "[[claim.reading]]", keys::READING);
            let Some(reading) = reading else { continue };
            let Some((name, span)) = reading.id(&mut self.problems, "id") else { continue };
            if let Some((_, first)) = seen.iter().find(|(n, _)| *n == name) {
                let message = format!("`{}` has two readings `{name}`", base.id);
                self.problems.note("derivation::duplicate-id", span, message).see(first.clone(), "the first one");
                continue;
            }
            seen.push((name.clone(), span.clone()));
            let says = reading.needed_text(&mut self.problems, "says").unwrap_or_default();
            let remark = reading.text(&mut self.problems, "remark").or_else(|| base.remark.clone());
            let parent_says = Some(base.says.clone());
            let mut claim =
                Claim { reading: Some(name), says, parent_says, remark, span, forms: Vec::new(), ..base.clone() };
            claim.formulas.clear();
            self.fill(&mut claim, &reading, ids);
            match (has_forms(&reading), has_forms(table)) {
                (true, _) => self.forms(&mut claim, &reading),
                (false, true) => self.forms(&mut claim, table),
                (false, false) => self.note_empty(&claim.span, &format!("the reading `{}`", claim.name())),
            }
            self.confine(&mut claim, &[&reading, table]);
            self.refuse_ambiguity(&claim);
            self.refuse_a_single_time(&claim);
            if reading.get("expect").is_some() {
                self.expect(&mut claim, &reading);
            } else if !has_forms(table) {
                self.expect(&mut claim, table);
            }
            entries.push(claim);
        }
        if has_forms(table) || readings.is_empty() {
            if !has_forms(table) {
                self.note_empty(&base.span, &format!("the claim `{}`", base.id));
            }
            self.forms(&mut base, table);
            self.confine(&mut base, &[table]);
            self.refuse_ambiguity(&base);
            self.refuse_a_single_time(&base);
            self.expect(&mut base, table);
            self.out.claims.push(base);
        }
        self.out.claims.extend(entries);
    }

    fn note_empty(&mut self, span: &Range<usize>, what: &str) {
        let keys: Vec<&str> = FormKind::ALL.iter().map(|f| f.key()).collect();
        self.problems
            .note("derivation::empty-claim", span.clone(), format!("{what} says nothing that could be checked"))
            .hint(format!("give at least one of {}", keys.join(", ")));
    }

    /// What a claim and a reading of it have in common; a reading adds to what its claim says.
    fn fill(&mut self, claim: &mut Claim, table: &Table<'_, '_>, ids: &[String]) {
        if table.get("printed").is_some() {
            claim.printed = table.boolean(&mut self.problems, "printed").unwrap_or(true);
        }
        self.role(claim, table);
        if let Some(value) = table.get("symbols") {
            let mut scope = claim.scope.clone();
            let declared = self.declare_all(value, &mut scope, true);
            claim.symbols.extend(declared);
            claim.scope = scope;
        }
        for formula in table.formulas(&mut self.problems, "assuming") {
            let statements = self.statements(&formula, &claim.scope);
            claim.assuming.extend(statements);
            if claim.assuming.len() > MOST_ASSUMED {
                let message = format!("a claim assumes at most {MOST_ASSUMED} formulas");
                let hint = "assume what follows from a claim, and let others follow from that";
                self.problems.note("derivation::too-many", formula.span.clone(), message).hint(hint);
                break;
            }
        }
        if table.get("at").is_some() {
            claim.at = self.at(table, &claim.scope);
        }
        if table.get("follows-from").is_some() {
            claim.follows_from = self.follows_from(table, claim, ids);
        }
        if let Some(value) = table.get("branches")
            && let Some(text) = text_of(&mut self.problems, value, "branches")
        {
            match text {
                "pointwise" => claim.branches_throughout = false,
                "throughout" => claim.branches_throughout = true,
                _ => {
                    let message = format!("`branches` is `pointwise` or `throughout`, not `{text}`");
                    self.problems.note("derivation::wrong-type", value.span(), message);
                }
            }
        }
        if let Some(value) = table.get("precision")
            && let Some(precision) = finite(&mut self.problems, value, "precision")
        {
            if precision > 0.0 && precision < 1.0 {
                claim.precision = precision;
            } else {
                let message = "`precision` lies between 0 and 1";
                self.problems
                    .note("derivation::bad-number", value.span(), message)
                    .hint("for instance 1e-9, which is usual");
            }
        }
        if table.get("trajectories").is_some() {
            claim.trajectories = self.some_trajectories(table);
            claim.names_trajectories = true;
        }
        if table.get("families").is_some() {
            claim.families = self.some_families(table);
        }
        if table.get("ranges").is_some() || table.get("domain").is_some() {
            self.ranges(claim, table);
        }
        claim.expect = vec![None; claim.trajectories.len()];
        claim.expect_of_families = vec![None; claim.families.len()];
        if let Some(inconsistent) = self.expect_units(table) {
            claim.expect_inconsistent_units = inconsistent;
        }
    }

    /// What a claim or a reading is to the paper.
    fn role(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        if table.get("added").is_some() && table.boolean(&mut self.problems, "added") == Some(true) {
            claim.role = ClaimRole::Added;
        }
        let Some(value) = table.get("role") else { return };
        if let Some(added) = table.get("added") {
            self.problems
                .note("derivation::wrong-type", value.span(), "`role` and `added` say the same twice")
                .see(added.span(), "this one")
                .hint("write `role` alone; `added = true` is short for `role = \"added\"`");
            return;
        }
        let Some(word) = text_of(&mut self.problems, value, "role") else { return };
        match ClaimRole::of(word) {
            Some(role) => claim.role = role,
            None => {
                let known = ClaimRole::ALL.map(ClaimRole::word);
                self.problems.unknown("derivation::unknown-key", value.span(), "role", word, known);
            }
        }
    }

    /// What the paper's argument for a claim rests on: other claims.
    fn rests_on(&mut self, table: &Table<'_, '_>, claim: &Claim, ids: &[String]) -> Vec<String> {
        let mut out = Vec::new();
        for (name, span) in table.names(&mut self.problems, "rests-on") {
            if name == claim.id {
                let message = format!("`{name}` cannot rest on itself");
                self.problems.note("derivation::unknown-claim", span, message);
            } else if ids.iter().any(|i| i == name) || self.refused.iter().any(|r| r == name) {
                out.push(name.to_owned());
            } else {
                let known = ids.iter().map(String::as_str);
                self.problems.unknown("derivation::unknown-claim", span, "claim", name, known);
            }
        }
        out
    }

    /// Claims, systems and symbols that are known.
    fn follows_from(&mut self, table: &Table<'_, '_>, claim: &Claim, ids: &[String]) -> Vec<String> {
        let mut out = Vec::new();
        for (name, span) in table.names(&mut self.problems, "follows-from") {
            let systems: Vec<String> = self.out.systems.iter().map(|s| s.id.clone()).collect();
            if name == claim.id || name == claim.name() {
                let message = format!("`{name}` cannot follow from itself");
                self.problems.note("derivation::unknown-claim", span, message);
            } else if ids.iter().chain(&systems).any(|i| i == name)
                || claim.scope.symbol(name).is_some()
                || self.refused.iter().any(|r| r == name)
            {
                out.push(name.to_owned());
            } else {
                let known = ids.iter().chain(&systems).map(String::as_str);
                self.problems.unknown("derivation::unknown-claim", span, "claim or system", name, known);
            }
        }
        out
    }

    /// The trajectories that a table names, in the order of the file.
    pub(super) fn some_trajectories(&mut self, table: &Table<'_, '_>) -> Vec<usize> {
        let mut out: Vec<usize> = Vec::new();
        for (name, span) in table.names(&mut self.problems, "trajectories") {
            let Some(index) = self.trajectory(name, span.clone()) else { continue };
            if out.contains(&index) {
                self.problems.note("derivation::duplicate-id", span, format!("`{name}` is listed twice"));
            } else {
                out.push(index);
            }
        }
        out.sort_unstable();
        out
    }

    /// Everything that the claim says of a motion.
    fn forms(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        for &kind in FormKind::ALL.iter().filter(|k| table.get(k.key()).is_some()) {
            let before = self.problems.found.len();
            match kind {
                FormKind::Always | FormKind::Never | FormKind::Eventually => self.relations(claim, table, kind),
                FormKind::FirstIntegral | FormKind::Defined => self.expressions(claim, table, kind),
                FormKind::Solves => self.solves(claim, table),
                FormKind::SameMotion => self.same_motion(claim, table),
                FormKind::Independent => self.independent(claim, table),
                FormKind::Exists => self.exists(claim, table),
                FormKind::IndependentOf
                | FormKind::ScalesAs
                | FormKind::Monotone
                | FormKind::Extremum
                | FormKind::Limit => self.across(claim, table, kind),
            }
            let said = claim.forms.iter().any(|f| f.kind() == kind);
            if !said && self.problems.found.len() == before {
                let span = table.get(kind.key()).map_or(claim.span.clone(), |v| v.span());
                self.note_empty(&span, &format!("`{}`", kind.key()));
            }
        }
    }

    fn relations(&mut self, claim: &mut Claim, table: &Table<'_, '_>, kind: FormKind) {
        for formula in table.formulas(&mut self.problems, kind.key()) {
            claim.formulas.push(Formula { text: formula.printed(), kind });
            let make: fn(Written<Statement>) -> Form = match kind {
                FormKind::Never => Form::Never,
                FormKind::Eventually => Form::Eventually,
                _ => Form::Always,
            };
            let mut statements = self.statements(&formula, &claim.scope);
            // What never happens, or happens at some time, is all that the text says, at once.
            if kind != FormKind::Always && statements.len() > 1 {
                let relations = statements.drain(..).flat_map(|w| w.value.relations).collect();
                let value = Statement { relations, span: 0..formula.text.len() };
                statements.push(written(&formula, 0..formula.text.len(), value));
            }
            claim.forms.extend(statements.into_iter().map(make));
        }
    }

    fn expressions(&mut self, claim: &mut Claim, table: &Table<'_, '_>, kind: FormKind) {
        for formula in table.formulas(&mut self.problems, kind.key()) {
            claim.formulas.push(Formula { text: formula.printed(), kind });
            let make: fn(Written<Tensor>) -> Form = match kind {
                FormKind::FirstIntegral => Form::FirstIntegral,
                _ => Form::Defined,
            };
            let expression = self.expression(&formula, &claim.scope);
            claim.forms.extend(expression.map(make));
        }
    }

    fn solves(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        let Some(value) = table.get("solves") else { return };
        let Some(name) = text_of(&mut self.problems, value, "solves") else { return };
        let Some(system) = self.system(name, value.span()) else { return };
        claim.formulas.push(Formula { text: name.to_owned(), kind: FormKind::Solves });
        claim.forms.push(Form::Solves { system });
    }

    fn same_motion(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        let Some(value) = table.get("same-motion") else { return };
        let Some(table) = Table::open(&mut self.problems, value, "same-motion", keys::SAME_MOTION) else { return };
        let scope = claim.scope.clone();
        let of = self.states(&table, "of", &scope);
        let Some(name) = table.needed_text(&mut self.problems, "as") else { return };
        let span = table.get("as").map_or(value.span(), |v| v.span());
        let Some(other) = self.trajectory(&name, span) else { return };
        if table.get("of").is_none() {
            table.missing(&mut self.problems, "of");
            return;
        }
        if of.is_empty() {
            return;
        }
        if let Some(symbol) = of.iter().find(|s| !self.out.trajectories[other].states.contains(s)) {
            let message = format!("`{name}` has no state `{}`", self.out.graph.name(*symbol));
            self.problems.note("derivation::unknown-symbol", value.span(), message);
        }
        claim.formulas.push(Formula { text: name, kind: FormKind::SameMotion });
        claim.forms.push(Form::SameMotion { other, of });
    }

    fn independent(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        let Some(value) = table.get("independent") else { return };
        let Some(table) = Table::open(&mut self.problems, value, "independent", keys::INDEPENDENT) else { return };
        let mut functions = Vec::new();
        for formula in table.formulas(&mut self.problems, "functions") {
            claim.formulas.push(Formula { text: formula.printed(), kind: FormKind::Independent });
            functions.extend(self.quantity(&formula, &claim.scope));
        }
        let mut subject_to = Vec::new();
        for formula in table.formulas(&mut self.problems, "subject-to") {
            subject_to.extend(self.with_one_sign(&formula, &claim.scope));
        }
        if table.get("functions").is_none() {
            table.missing(&mut self.problems, "functions");
        }
        if !functions.is_empty() {
            claim.forms.push(Form::Independent { functions, subject_to });
        }
    }

    /// The expected verdicts.
    fn expect(&mut self, claim: &mut Claim, table: &Table<'_, '_>) {
        let Some(value) = table.get("expect") else { return };
        if let (Some(_), DeValue::Table(_)) = (&claim.region, value.get_ref()) {
            let message = "a claim over ranges has one verdict, and no trajectories";
            self.problems
                .note("derivation::wrong-type", value.span(), message)
                .hint("write the word alone, for instance expect = \"holds\"");
            return;
        }
        if let DeValue::String(word) = value.get_ref() {
            match keys::EXPECT.iter().find(|k| *k == word) {
                Some(&word) => {
                    claim.expect_alone = Some(word);
                    claim.expect = vec![Some(word); claim.trajectories.len()];
                    claim.expect_of_families = vec![Some(word); claim.families.len()];
                    claim.region.iter_mut().for_each(|r| r.expect = Some(word));
                }
                None => {
                    let known = keys::EXPECT.iter().copied();
                    self.problems.unknown("derivation::unknown-key", value.span(), "verdict", word, known);
                }
            }
            return;
        }
        let Some(table) = Table::open(&mut self.problems, value, "expect", keys::EXPECT) else { return };
        // Of trajectories, then of families.
        let count = claim.trajectories.len() + claim.families.len();
        let mut places: Vec<Option<Range<usize>>> = vec![None; count];
        let mut rest: Option<(&'static str, Range<usize>, bool)> = None;
        for (&word, value) in keys::EXPECT.iter().filter_map(|k| Some((k, table.get(k)?))) {
            match value.get_ref() {
                DeValue::String(text) if text == "all" || text == "others" => {
                    if let Some((_, first, _)) = &rest {
                        let message = "only one verdict can be that of all or of the others";
                        self.problems
                            .note("derivation::expected-twice", value.span(), message)
                            .see(first.clone(), "the first one");
                    } else {
                        rest = Some((word, value.span(), text == "all"));
                    }
                }
                DeValue::Array(_) => {
                    for (name, span) in table.names(&mut self.problems, word) {
                        self.expect_one(claim, name, span, word, &mut places);
                    }
                }
                _ => self.problems.wrong_type(value, word, "an array of trajectories, \"others\" or \"all\""),
            }
        }
        let Some((word, span, all)) = rest else { return };
        claim.expect_alone = Some(word);
        if let Some(first) = places.iter().flatten().next().filter(|_| all) {
            let message = "`all` leaves no trajectory for another verdict";
            self.problems
                .note("derivation::expected-twice", span, message)
                .see(first.clone(), "this one")
                .hint("write \"others\" for the trajectories that are not listed");
        }
        let open = claim.expect.iter_mut().chain(&mut claim.expect_of_families).filter(|e| e.is_none());
        open.for_each(|e| *e = Some(word));
    }

    fn expect_one(
        &mut self,
        claim: &mut Claim,
        name: &str,
        span: Range<usize>,
        word: &'static str,
        places: &mut [Option<Range<usize>>],
    ) {
        let (at, key) = match self.out.families.iter().position(|f| f.id == name) {
            Some(index) => {
                let at = claim.families.iter().position(|f| *f == index);
                (at.map(|at| claim.trajectories.len() + at), "families")
            }
            None => {
                let Some(index) = self.trajectory(name, span.clone()) else { return };
                (claim.trajectories.iter().position(|t| *t == index), "trajectories")
            }
        };
        let Some(at) = at else {
            let message = format!("`{}` is not tried on `{name}`", claim.name());
            self.problems.note("derivation::unknown-trajectory", span, message).hint(format!("see its `{key}`"));
            return;
        };
        if let Some(first) = &places[at] {
            let message = format!("`{name}` is expected twice");
            self.problems.note("derivation::expected-twice", span, message).see(first.clone(), "the first time");
            return;
        }
        places[at] = Some(span);
        let trajectories = claim.trajectories.len();
        match at.checked_sub(trajectories) {
            Some(family) => claim.expect_of_families[family] = Some(word),
            None => claim.expect[at] = Some(word),
        }
    }

    /// Reads every `[[measure]]`.
    pub fn measures(&mut self, root: &Table<'_, '_>) {
        for value in root.array(&mut self.problems, "measure", "tables, [[measure]]") {
            if let Some(measure) = self.one_measure(value) {
                self.out.measures.push(measure);
            }
        }
    }

    fn one_measure(&mut self, value: &Value<'_>) -> Option<Measure> {
        let table = Table::open(&mut self.problems, value, "[[measure]]", keys::MEASURE)?;
        let id = table.id(&mut self.problems, "id");
        let says = table.needed_text(&mut self.problems, "says");
        let scope = self.out.scope.clone();
        if table.get("formula").is_none() {
            table.missing(&mut self.problems, "formula");
        }
        let formula: Option<Literal<'_>> = table.formula(&mut self.problems, "formula");
        let formula = formula.and_then(|f| self.quantity(&f, &scope));
        let at = self.at(&table, &scope);
        let since = self.since(&table, &scope);
        let families = self.some_families(&table);
        let trajectories = match table.get("trajectories") {
            Some(_) => self.some_trajectories(&table),
            None => (0..self.out.trajectories.len()).collect(),
        };
        let (unit, measured_in) = self.unit(&table);
        let (id, span) = id?;
        let new = self.take("measure", &id, span.clone());
        let formula = formula?;
        if formula.value.as_scalar().is_none() {
            let message = format!("a measured quantity is one number, this is a {}", formula.value.shape);
            self.problems.note("derivation::wrong-components", formula.span, message);
            return None;
        }
        new.then_some(Measure { id, says: says?, formula, at, since, trajectories, families, unit, measured_in, span })
    }
}
