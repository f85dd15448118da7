//! `[system.…]` and `[[trajectory]]`.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};
use std::ops::Range;

use toml::de::DeValue;

use super::formula::Written;
use super::keys;
use super::load::{Loader, is_equation};
use super::model::{GivenValue, Motion, System, Trajectory};
use super::table::{Table, Value, changes_backslashes, check_id, note_double_quoted, text_of};
use super::values::Known;
use expr::{Expr, Leaf, Rational, Symbol};
use latex::{Role, Scope};

/// A symbol with its value: one expression for each stored component.
pub(super) type ValueOf = (Symbol, Written<Vec<Expr>>);
type Values = Vec<ValueOf>;
/// States and orders of their rates, with their values.
type Given = Vec<(Symbol, u8, Written<Vec<Expr>>)>;

/// A motion may come through so many others from one that is integrated or given by formulas.
const MOST_MAPS: usize = 100;

/// A `[[trajectory]]` before what it comes from is known.
struct Draft<'a, 's> {
    table: Table<'a, 's>,
    id: String,
    place: Range<usize>,
    from: Option<usize>,
}

impl Loader<'_> {
    /// Reads every `[system.…]`.
    pub fn systems(&mut self, root: &Table<'_, '_>) {
        let Some(value) = root.get("system") else { return };
        let DeValue::Table(entries) = value.get_ref() else {
            self.problems.wrong_type(value, "system", "a table for each system, [system.ID]");
            return;
        };
        for (key, value) in entries {
            let id = key.get_ref().as_ref();
            let known = check_id(&mut self.problems, id, key.span());
            match self.one_system(id, key.span(), value) {
                Some(system) if known => self.out.systems.push(system),
                _ => self.refused.push(id.to_owned()),
            }
        }
    }

    fn one_system(&mut self, id: &str, span: Range<usize>, value: &Value<'_>) -> Option<System> {
        let table = Table::open(&mut self.problems, value, "a system", keys::SYSTEM)?;
        let scope = self.out.scope.clone();
        let says = table.text(&mut self.problems, "says");
        let label = table.text(&mut self.problems, "label");
        let states = self.unknowns(&table, ("states", Role::State, "a state"), &scope);
        let fields = self.unknowns(&table, ("fields", Role::Field, "a field"), &scope);
        let formulas = table.formulas(&mut self.problems, "equations");
        let unknowns = if table.get("fields").is_none() { "states" } else { "fields" };
        for key in [unknowns, "equations"].iter().filter(|k| table.get(k).is_none()) {
            table.missing(&mut self.problems, key);
        }
        if !states.is_empty() && !fields.is_empty() {
            let message = "a system is one of states, or one of fields";
            self.problems.note("derivation::bad-role", span.clone(), message).hint("write two systems");
            return None;
        }
        let mut equations = Vec::new();
        for formula in &formulas {
            for equation in self.statements(formula, &scope) {
                if equation.value.relations.iter().all(is_equation) {
                    let sides = equation
                        .value
                        .relations
                        .iter()
                        .flat_map(|r| r.left.components.iter().chain(&r.right.components));
                    self.refuse_continued(sides.copied().collect(), &scope, equation.span.clone());
                    equations.push(equation);
                } else {
                    let message = "a system consists of plain equations";
                    let hint = "only `=`, without ± and without limits";
                    self.problems.note("derivation::not-an-equation", equation.span, message).hint(hint);
                }
            }
        }
        (!(equations.is_empty() || states.is_empty() && fields.is_empty())).then(|| System {
            id: id.to_owned(),
            says,
            label,
            states,
            equations,
            span,
        })
    }

    /// Refuses an angle that is continued in what makes a motion: it is continued along a motion that is there already.
    fn refuse_continued(&mut self, formulas: Vec<Expr>, scope: &Scope, span: Range<usize>) {
        let mut open: Vec<Symbol> = self.out.graph.leaves_within(formulas).into_iter().map(|l| l.symbol).collect();
        let mut seen = Vec::new();
        while let Some(symbol) = open.pop() {
            let Some(definition) = scope.definition(symbol).filter(|_| !seen.contains(&symbol)) else { continue };
            if scope.is_angle(symbol) {
                let message =
                    format!("`{}` is continued along a motion, and cannot make one", self.out.graph.name(symbol));
                let hint = "write its formula here, which leaps, or make it a state with a rate";
                self.problems.note("derivation::bad-role", span, message).hint(hint);
                return;
            }
            seen.push(symbol);
            open.extend(
                self.out.graph.leaves_within(definition.components.iter().copied()).into_iter().map(|l| l.symbol),
            );
        }
    }

    /// An array of states.
    pub fn states(&mut self, table: &Table<'_, '_>, key: &str, scope: &Scope) -> Vec<Symbol> {
        self.unknowns(table, (key, Role::State, "a state"), scope)
    }

    /// An array of symbols of one role.
    fn unknowns(
        &mut self,
        table: &Table<'_, '_>,
        (key, role, called): (&str, Role, &str),
        scope: &Scope,
    ) -> Vec<Symbol> {
        let mut out = Vec::new();
        for (name, span) in table.names(&mut self.problems, key) {
            let raw = self.problems.source.text.get(span.clone()).unwrap_or_default();
            if changes_backslashes(raw) {
                note_double_quoted(&mut self.problems, span, raw, true);
                continue;
            }
            let Some(symbol) = self.symbol(name.trim(), span.clone(), scope) else { continue };
            if scope.role(symbol) != Some(role) {
                self.problems.note("derivation::bad-role", span, format!("`{name}` is not declared as {called}"));
            } else if out.contains(&symbol) {
                self.problems.note("derivation::duplicate-id", span, format!("`{name}` is listed twice"));
            } else {
                out.push(symbol);
            }
        }
        out
    }

    /// Reads every `[[trajectory]]`.
    pub fn trajectories(&mut self, root: &Table<'_, '_>) {
        let mut drafts = Vec::new();
        for value in root.array(&mut self.problems, "trajectory", "tables, [[trajectory]]") {
            let table = Table::open(&mut self.problems, value, "[[trajectory]]", keys::TRAJECTORY);
            let Some(table) = table else { continue };
            let Some((id, place)) = table.id(&mut self.problems, "id") else { continue };
            if self.take("trajectory", &id, place.clone()) {
                drafts.push(Draft { table, id, place, from: None });
            }
        }
        self.find_sources(&mut drafts);

        // Each behind the one that it comes from, as early as may be.
        let mut following: Vec<Vec<usize>> = vec![Vec::new(); drafts.len()];
        let mut ready = BinaryHeap::new();
        for (i, draft) in drafts.iter().enumerate() {
            match draft.from {
                Some(from) => following[from].push(i),
                None => ready.push(Reverse(i)),
            }
        }
        let mut done: Vec<Option<Option<Trajectory>>> = vec![None; drafts.len()];
        while let Some(Reverse(next)) = ready.pop() {
            ready.extend(following[next].iter().map(|&i| Reverse(i)));
            let source = drafts[next].from.and_then(|f| done[f].clone().flatten());
            let before = self.out.given.len();
            let built = self.one_trajectory(&drafts[next], source.as_ref());
            for given in self.out.given.iter_mut().skip(before) {
                given.trajectory.clone_from(&drafts[next].id);
            }
            if built.is_none() {
                self.refused.push(drafts[next].id.clone());
            }
            done[next] = Some(built);
        }
        // Positions count drafts; where one is missing, the file is refused and nobody sees them.
        self.out.trajectories = done.into_iter().flatten().flatten().collect();
    }

    /// Resolves `from`; those on a cycle, those that come from nothing known, and those too far from where their chain begins keep `None`.
    fn find_sources(&mut self, drafts: &mut [Draft<'_, '_>]) {
        let places: BTreeMap<&str, usize> = drafts.iter().enumerate().map(|(i, d)| (d.id.as_str(), i)).collect();
        let mut from = vec![None; drafts.len()];
        for (i, draft) in drafts.iter().enumerate() {
            let Some(value) = draft.table.get("from") else { continue };
            let Some(name) = text_of(&mut self.problems, value, "from") else { continue };
            from[i] = places.get(name).copied();
            if from[i].is_none() {
                let ids = drafts.iter().map(|d| d.id.as_str());
                self.problems.unknown("derivation::unknown-trajectory", value.span(), "trajectory", name, ids);
            }
        }
        for (i, draft) in drafts.iter_mut().enumerate() {
            let chain = || std::iter::successors(from[i], |&j| from[j]).take(MOST_MAPS + 1);
            if chain().count() <= MOST_MAPS {
                draft.from = from[i];
                continue;
            }
            let span = draft.table.get("from").map_or(draft.place.clone(), |v| v.span());
            if chain().any(|j| j == i) {
                let message = format!("`{}` comes from itself", draft.id);
                self.problems.note("derivation::cyclic-from", span, message).hint("a motion needs a beginning");
            } else {
                let message = format!("`{}` comes from a motion through more than {MOST_MAPS} others", draft.id);
                self.problems.note("derivation::too-deep", span, message).hint("one `map` can do what several do");
            }
        }
    }

    fn one_trajectory(&mut self, draft: &Draft<'_, '_>, source: Option<&Trajectory>) -> Option<Trajectory> {
        let table = &draft.table;
        let scope = self.out.scope.clone();
        let ways = ["system", "formula", "from"].map(|key| table.get(key).is_some());
        if ways.iter().filter(|w| **w).count() != 1 {
            let message = format!("`{}` needs exactly one of `system`, `formula` and `from`", draft.id);
            self.problems
                .note("derivation::missing-key", draft.place.clone(), message)
                .hint("integrated from initial values, given by formulas, or computed from another trajectory");
            return None;
        }
        if ways[2] && source.is_none() {
            return None; // said already
        }
        for (key, way, index) in [("initial", "system", 0), ("constraints", "system", 0), ("map", "from", 2)] {
            if let Some(value) = table.get(key).filter(|_| !ways[index]) {
                let message = format!("`{key}` goes with `{way}` only");
                self.problems.note("derivation::unknown-key", value.span(), message);
            }
        }
        let before = self.problems.found.len();
        let title = table.text(&mut self.problems, "title").unwrap_or_else(|| draft.id.clone());
        let says = table.text(&mut self.problems, "says");
        let times = self.times(table, source, &scope);
        let parameters = self.parameters(table, source, &scope, &[]);
        let motion = match (ways, source, draft.from) {
            ([_, _, true], Some(source), Some(from)) => {
                let map = self.map(table, source, &parameters, &scope);
                Some(Motion::Derived { from, map })
            }
            ([true, ..], ..) => self.integrated(table, &parameters, &scope, &[]),
            _ => {
                let states = self.formula_states(table, &parameters, &scope, &[]);
                Some(Motion::Formula { states })
            }
        };
        let ((span, initial_time), motion) = times.zip(motion)?;
        let mut states = match &motion {
            Motion::Integrated { system, .. } => self.out.systems[*system].states.clone(),
            Motion::Formula { states } => states.iter().map(|(s, _)| *s).collect(),
            Motion::Derived { .. } => source.map(|s| s.states.clone()).unwrap_or_default(),
        };
        if let Motion::Derived { map, .. } = &motion {
            let new: Vec<Symbol> = map.iter().map(|(s, _)| *s).filter(|s| !states.contains(s)).collect();
            states.extend(new);
        }
        (self.problems.found.len() == before).then(|| Trajectory {
            id: draft.id.clone(),
            title,
            says,
            motion,
            states,
            parameters,
            span,
            initial_time,
            place: draft.place.clone(),
        })
    }

    /// The values that a table gives to symbols of a role, each with its name's place.
    fn given<'a, 's>(
        &mut self,
        table: &Table<'a, 's>,
        key: &'static str,
        role: Role,
        scope: &Scope,
    ) -> Vec<Assigned<'a, 's>> {
        let Some(value) = table.get(key) else { return Vec::new() };
        let DeValue::Table(entries) = value.get_ref() else {
            self.problems.wrong_type(value, key, "a table of symbols and their values");
            return Vec::new();
        };
        let mut out = Vec::new();
        for (name, value) in entries {
            // Initial values may be those of rates: `\dot q`.
            let (rate, bare) = match (key, name.get_ref()) {
                ("initial", text) => undotted(text),
                (_, text) => (0, text.as_ref()),
            };
            let Some(symbol) = self.symbol(bare, name.span(), scope) else { continue };
            if role == Role::Parameter && scope.definition(symbol).is_some() {
                let message = format!("`{}` is a constant: its value is fixed", name.get_ref());
                self.problems.note("derivation::bad-role", name.span(), message).hint("leave it out");
            } else if let Some(first) = out.iter().find(|g: &&Assigned<'_, '_>| (g.symbol, g.rate) == (symbol, rate)) {
                let message = format!("`{}` is given twice", name.get_ref());
                let first = first.span.clone();
                self.problems.note("derivation::duplicate-id", name.span(), message).see(first, "the first value");
            } else if scope.role(symbol) == Some(role) {
                out.push(Assigned { symbol, rate, span: name.span(), value });
            } else {
                let word = if role == Role::State { "a state" } else { "a parameter" };
                let message = format!("`{}` is not declared as {word}", name.get_ref());
                self.problems.note("derivation::bad-role", name.span(), message);
            }
        }
        out
    }

    /// The values of parameters, those of the source first.
    ///
    /// What is varied is left open.
    pub(super) fn parameters(
        &mut self,
        table: &Table<'_, '_>,
        source: Option<&Trajectory>,
        scope: &Scope,
        varied: &[Leaf],
    ) -> Values {
        let mut out: Values = source.map(|s| s.parameters.clone()).unwrap_or_default();
        let constants = self.out.symbols.iter().filter(|s| s.role == Role::Parameter);
        for entry in constants {
            if let (Some(text), Some(definition)) = (&entry.formula, scope.definition(entry.symbol))
                && !out.iter().any(|(s, _)| *s == entry.symbol)
            {
                let (text, span, value) = (text.clone(), entry.span.clone(), definition.components.clone());
                out.push((entry.symbol, Written { text, span, value }));
            }
        }
        let mut known: Known = out.iter().map(|(s, w)| ((*s, 0), w.value.clone())).collect();
        for Assigned { symbol, value, .. } in self.given(table, "parameters", Role::Parameter, scope) {
            if let Some(open) = self.left_open(symbol, 0, value, varied) {
                known.insert((symbol, 0), open.value.clone());
                out.push((symbol, open));
                continue;
            }
            let Some(mut written) = self.components(value, symbol, scope) else {
                known.insert((symbol, 0), vec![self.out.graph.integer(1); self.out.graph.component_count(symbol)]);
                continue;
            };
            self.keep(symbol, 0, &written);
            let hint = "a parameter may use the parameters that are given before it";
            if !self.resolve_all(&mut written, &known, scope, &|_, leaf| varied.contains(&leaf), hint) {
                continue;
            }
            self.check_positive(symbol, &written);
            known.insert((symbol, 0), written.value.clone());
            out.retain(|(s, _)| *s != symbol);
            out.push((symbol, written));
        }
        out
    }

    /// Keeps a value as it is written; its trajectory is named later.
    fn keep(&mut self, symbol: Symbol, rate: u8, value: &Written<Vec<Expr>>) {
        self.out.given.push(GivenValue { trajectory: String::new(), symbol, rate, value: value.clone() });
    }

    /// The value of what is varied: the symbol itself.
    fn left_open(
        &mut self,
        symbol: Symbol,
        rate: u8,
        value: &Value<'_>,
        varied: &[Leaf],
    ) -> Option<Written<Vec<Expr>>> {
        let leaf = *varied.iter().find(|leaf| leaf.symbol == symbol && leaf.rate == rate)?;
        let text = self.out.graph.name(symbol).to_owned();
        Some(Written { text, span: value.span(), value: vec![self.out.graph.leaf(leaf)] })
    }

    /// Notes a value that is not positive although its symbol is declared so.
    fn check_positive(&mut self, symbol: Symbol, written: &Written<Vec<Expr>>) {
        let positive = self.out.symbols.iter().any(|s| s.symbol == symbol && s.positive);
        let negative = |e: &Expr| self.out.graph.as_constant(*e).is_some_and(|r| *r <= Rational::ZERO);
        if positive && written.value.iter().any(negative) {
            let message = format!("`{}` is declared positive", self.out.graph.name(symbol));
            self.problems.note("derivation::not-positive", written.span.clone(), message);
        }
    }

    /// Resolves every component; notes the first leaf without a value.
    fn resolve_all(
        &mut self,
        written: &mut Written<Vec<Expr>>,
        known: &Known,
        scope: &Scope,
        free: &dyn Fn(&Scope, Leaf) -> bool,
        hint: &str,
    ) -> bool {
        for i in 0..written.value.len() {
            match self.resolve(written.value[i], known, scope, free) {
                Ok(e) => written.value[i] = e,
                Err(leaf) => {
                    let message = format!("`{}` has no value here", self.leaf_name(leaf));
                    self.problems.note("derivation::no-value", written.span.clone(), message).hint(hint);
                    return false;
                }
            }
        }
        true
    }

    /// States given one after the other: each formula may use the states before it, and their rates. `free` may stay in it.
    fn state_values(
        &mut self,
        given: Vec<Assigned<'_, '_>>,
        varied: &[Leaf],
        scope: &Scope,
        free: &dyn Fn(&Scope, Leaf) -> bool,
        hint: &str,
    ) -> (Given, Known) {
        let mut out = Vec::new();
        let mut known = Known::new();
        for Assigned { symbol, rate, value, .. } in given {
            if let Some(open) = self.left_open(symbol, rate, value, varied) {
                known.insert((symbol, rate), open.value.clone());
                out.push((symbol, rate, open));
                continue;
            }
            let Some(mut written) = self.components(value, symbol, scope) else { continue };
            if scope.time().is_some_and(|time| free(scope, time)) {
                self.refuse_continued(written.value.clone(), scope, written.span.clone());
            }
            let shown = self.name_guesses(symbol, rate, &written);
            self.keep(symbol, rate, &shown);
            if self.resolve_all(&mut written, &known, scope, free, hint) {
                known.insert((symbol, rate), written.value.clone());
                out.push((symbol, rate, written));
            }
        }
        (out, known)
    }

    /// A motion by a system. What is varied is left open.
    pub(super) fn integrated(
        &mut self,
        table: &Table<'_, '_>,
        parameters: &[ValueOf],
        scope: &Scope,
        varied: &[Leaf],
    ) -> Option<Motion> {
        let value = table.get("system")?;
        let name = text_of(&mut self.problems, value, "system")?;
        let system = self.system(name, value.span())?;
        let states = self.out.systems[system].states.clone();
        if states.is_empty() {
            let message = format!("`{name}` is a system of fields: it has no motions");
            let hint = "let claims follow from it, or give the fields formulas in the claim's `ranges`";
            self.problems.note("derivation::bad-role", value.span(), message).hint(hint);
            return None;
        }
        if table.get("initial").is_none() {
            table.missing(&mut self.problems, "initial");
            return None;
        }
        let mut given = self.given(table, "initial", Role::State, scope);
        for g in given.iter().filter(|g| !states.contains(&g.symbol)) {
            let message = format!("`{}` is no state of the system `{name}`", self.out.graph.name(g.symbol));
            self.problems.note("derivation::unknown-symbol", g.span.clone(), message);
        }
        let missing: Vec<String> = states
            .iter()
            .filter(|s| !given.iter().any(|g| g.symbol == **s && g.rate == 0))
            .map(|s| self.out.graph.name(*s).to_owned())
            .collect();
        if !missing.is_empty() {
            let span = table.get("initial").map_or(table.span.clone(), |v| v.span());
            let names: Vec<String> = missing.iter().map(|m| format!("`{m}`")).collect();
            let message = format!("no initial value for {} of the system `{name}`", names.join(", "));
            self.problems.note("derivation::missing-initial", span, message);
        }
        given.retain(|g| states.contains(&g.symbol));
        let hint = "initial values may use the trajectory's parameters, the states and rates that are given before, and \
                    rates that the system gives";
        let has: Vec<Symbol> = parameters.iter().map(|(s, _)| *s).collect();
        let of_system = {
            let given: Vec<(Symbol, u8)> = given.iter().map(|g| (g.symbol, g.rate)).collect();
            let states = states.clone();
            move |leaf: Leaf| {
                leaf.rate > 0 && states.contains(&leaf.symbol) && !given.contains(&(leaf.symbol, leaf.rate))
            }
        };
        let free = |scope: &Scope, leaf: Leaf| {
            // A symbol without a role stands for a value that is solved for.
            let bare = leaf.rate == 0 && (has.contains(&leaf.symbol) || scope.role(leaf.symbol).is_none());
            leaf.instant.is_none() && (bare || of_system(leaf)) || varied.contains(&leaf)
        };
        let before = self.problems.found.len();
        self.guesses = Some(Vec::new());
        let (mut initial, known) = self.state_values(given, varied, scope, &free, hint);
        let guesses = self.guesses.take().unwrap_or_default();
        let start = if self.problems.found.len() == before && missing.is_empty() {
            self.start(table, guesses, &known, scope, &free)
        } else {
            None
        };
        initial.sort_by_key(|(s, rate, _)| (states.iter().position(|x| x == s), *rate));
        Some(Motion::Integrated { system, initial, start })
    }

    /// The states of a motion by formulas. What is varied is left open.
    pub(super) fn formula_states(
        &mut self,
        table: &Table<'_, '_>,
        parameters: &[ValueOf],
        scope: &Scope,
        varied: &[Leaf],
    ) -> Values {
        let given = self.given(table, "formula", Role::State, scope);
        if given.is_empty()
            && let Some(value) = table.get("formula")
            && value.get_ref().as_table().is_some_and(|t| t.is_empty())
        {
            self.problems.note("derivation::missing-key", value.span(), "`formula` gives no state");
        }
        let hint = "a motion's formula may use the time, the trajectory's parameters and the states before it";
        let has: Vec<Symbol> = parameters.iter().map(|(s, _)| *s).collect();
        let free = |scope: &Scope, leaf: Leaf| {
            let bare = has.contains(&leaf.symbol) || scope.time().is_some_and(|t| t.symbol == leaf.symbol);
            leaf.rate == 0 && bare || varied.contains(&leaf)
        };
        self.state_values(given, varied, scope, &free, hint).0.into_iter().map(|(s, _, w)| (s, w)).collect()
    }

    /// The map of a derived motion: its formulas keep their leaves, states of the source among them.
    fn map(&mut self, table: &Table<'_, '_>, source: &Trajectory, parameters: &Values, scope: &Scope) -> Values {
        let given = self.given(table, "map", Role::State, scope);
        let states = &source.states;
        let mut out = Values::new();
        for Assigned { symbol, value, .. } in given {
            let Some(mut written) = self.components(value, symbol, scope) else { continue };
            self.keep(symbol, 0, &written);
            // The other motion does not know this one's own parameters: their values are put in.
            let own = |leaf: Leaf| parameters.iter().rev().find(|(s, _)| *s == leaf.symbol).map(|(_, w)| &w.value);
            for e in &mut written.value {
                *e = self.out.graph.substitute(*e, |_, leaf| own(leaf)?.get(usize::from(leaf.component)).copied());
            }
            let leaves = self.out.graph.leaves_within(written.value.iter().copied());
            let unknown = leaves.into_iter().find(|leaf| match scope.role(leaf.symbol) {
                Some(Role::State) => !states.contains(&leaf.symbol),
                Some(Role::Parameter) => !parameters.iter().any(|(s, _)| *s == leaf.symbol),
                _ => false,
            });
            if let Some(leaf) = unknown {
                let message = format!("`{}` has no value here", self.leaf_name(leaf));
                let hint = format!("a map may use the states of `{}` and the parameters", source.id);
                self.problems.note("derivation::no-value", written.span, message).hint(hint);
            } else {
                out.push((symbol, written));
            }
        }
        out
    }
}

/// A value given to a symbol, or to one of its rates.
struct Assigned<'a, 's> {
    symbol: Symbol,
    rate: u8,
    span: Range<usize>,
    value: &'a Value<'s>,
}

/// Takes the dots off a name: `\dot q` is rate 1 of `q`.
pub(super) fn undotted(name: &str) -> (u8, &str) {
    for (dots, rate) in [(r"\ddot", 2), (r"\dot", 1)] {
        if let Some(rest) = name.trim().strip_prefix(dots)
            && rest.starts_with([' ', '{', '\\'])
        {
            let rest = rest.trim();
            // `\dot{q}`: the braces only group; `\dot{\bf r}`: they belong to the name.
            let inner = rest.strip_prefix('{').and_then(|r| r.strip_suffix('}'));
            let bare = inner.filter(|i| !i.trim_start().starts_with(r"\bf") && !i.trim_start().starts_with(r"\rm"));
            return (rate, bare.unwrap_or(rest));
        }
    }
    (0, name)
}
