//! Initial values that equations determine: `{ near = 1 }` and `constraints`.
//!
//! **In:** initial values, some of them as guesses, and the equations of a `[[trajectory]]`. **Out:** [`Start`]: the unknowns,
//! each with its guess, and as many equations between numbers. **Guaranteed:** an equation speaks of parameters, unknowns, and
//! rates that the system gives, and of nothing else. Nothing is solved here.

use toml::de::DeValue;

use super::formula::Written;
use super::keys;
use super::load::{Loader, is_equation};
use super::model::{Start, Unknown};
use super::table::{Table, Value};
use super::values::Known;
use expr::{Expr, Leaf, Shape, Symbol};
use latex::{Scope, Statement};

/// What an equation between initial values may use.
const MAY_USE: &str = "a constraint holds at the initial time: it may use parameters, the initial values, and rates that the \
                       system gives; write x, not x(0)";

impl Loader<'_> {
    /// A guess, `{ near = 1, within = 0.5 }`: a symbol of its own stands for the value. Only where guesses are taken.
    pub fn guess(&mut self, value: &Value<'_>, scope: &Scope) -> Option<Expr> {
        let table = Table::open(&mut self.problems, value, "an initial value that is solved for", keys::GUESS)?;
        let Some(near) = table.get("near") else {
            table.missing(&mut self.problems, "near");
            return None;
        };
        let near = self.scalar_component(near, scope)?;
        let within = match table.get("within") {
            Some(within) => Some(self.scalar_component(within, scope)?),
            None if self.out.graph.is_zero(near) => {
                let message = "how near to 0 is not said";
                let hint =
                    "without `within`, an initial value lies within half of its guess: write { near = 0, within = 1 }";
                self.problems.note("derivation::bad-range", value.span(), message).hint(hint);
                return None;
            }
            None => None,
        };
        let known = |e: Option<Expr>| e.and_then(|e| self.out.graph.as_constant(e));
        if known(within).is_some_and(|r| *r <= expr::Rational::ZERO) {
            let message = "`within` is how far the value may be from its guess: a positive number";
            self.problems.note("derivation::bad-range", value.span(), message);
            return None;
        }
        let symbol = self.out.graph.declare("initial value", Shape::scalar(), false);
        let leaf = Leaf::now(symbol, 0);
        let unknown = Unknown { leaf, name: String::new(), near, within, span: value.span() };
        self.guesses.as_mut()?.push(unknown);
        Some(self.out.graph.leaf(leaf))
    }

    /// Names the guesses that are among the components of a value, and puts them in: the value as one may look at its units.
    pub fn name_guesses(&mut self, symbol: Symbol, rate: u8, value: &Written<Vec<Expr>>) -> Written<Vec<Expr>> {
        let Some(mut guesses) = self.guesses.take() else { return value.clone() };
        for guess in guesses.iter_mut().filter(|g| g.name.is_empty()) {
            let own = self.out.graph.leaf(guess.leaf);
            if let Some(component) = value.value.iter().position(|e| *e == own) {
                guess.name = self.leaf_name(Leaf { rate, ..Leaf::now(symbol, component as u16) });
            }
        }
        let near = |leaf: Leaf| guesses.iter().find(|g| g.leaf == leaf).map(|g| g.near);
        let put = value.value.iter().map(|e| self.out.graph.substitute(*e, |_, leaf| near(leaf))).collect();
        self.guesses = Some(guesses);
        Written { value: put, ..value.clone() }
    }

    /// The equations that determine what was guessed; `known` are the initial values. Nothing where nothing was guessed.
    pub fn start(
        &mut self,
        table: &Table<'_, '_>,
        mut unknowns: Vec<Unknown>,
        known: &Known,
        scope: &Scope,
        free: &dyn Fn(&Scope, Leaf) -> bool,
    ) -> Option<Start> {
        let formulas = table.formulas(&mut self.problems, "constraints");
        let place = table.get("constraints").map(|v| v.span());
        let mut equations: Vec<Written<Statement>> = Vec::new();
        for formula in &formulas {
            for equation in self.with_one_sign(formula, scope) {
                if equation.value.relations.iter().all(is_equation) {
                    equations.push(equation);
                } else {
                    let message = "initial values are determined by plain equations";
                    self.problems
                        .note("derivation::not-an-equation", equation.span, message)
                        .hint("only `=`, without limits; which of several solutions is meant is said by `near`");
                }
            }
        }
        let mut differences = Vec::new();
        for equation in &equations {
            for relation in &equation.value.relations {
                for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                    let d = self.out.graph.sub(l, r);
                    match self.resolve(d, known, scope, free) {
                        Ok(d) => differences.push(d),
                        Err(leaf) => {
                            let message = format!("`{}` has no value here", self.leaf_name(leaf));
                            self.problems.note("derivation::no-value", equation.span.clone(), message).hint(MAY_USE);
                            return None;
                        }
                    }
                }
            }
        }
        let of_parameters = |scope: &Scope, leaf: Leaf| free(scope, leaf) && !unknowns.iter().any(|u| u.leaf == leaf);
        let mut resolved = Vec::new();
        for unknown in &unknowns {
            for e in [Some(unknown.near), unknown.within].into_iter().flatten() {
                match self.resolve(e, &Known::new(), scope, &of_parameters) {
                    Ok(e) => resolved.push(e),
                    Err(leaf) => {
                        let message = format!("`{}` has no value here", self.leaf_name(leaf));
                        let hint = "a guess may use the trajectory's parameters";
                        self.problems.note("derivation::no-value", unknown.span.clone(), message).hint(hint);
                        return None;
                    }
                }
            }
        }
        let mut resolved = resolved.into_iter();
        for unknown in &mut unknowns {
            unknown.near = resolved.next()?;
            unknown.within = unknown.within.and_then(|_| resolved.next());
        }
        if differences.len() != unknowns.len() {
            let (equations, of) = (differences.len(), unknowns.len());
            let span = place.clone().or(unknowns.first().map(|u| u.span.clone())).unwrap_or(table.span.clone());
            let message = format!("{equations} equations for {of} initial values that are solved for");
            let hint = match (equations, of) {
                (0, _) => "add them: constraints = ['…'], one equation for each value with `near`",
                (_, 0) => "give an initial value by a guess, 'x' = { near = 1 }: it is solved for",
                _ => "as many equations as values with `near`, counted by components",
            };
            self.problems.note("derivation::constraints", span, message).hint(hint);
            return None;
        }
        let open = |u: &&Unknown| !differences.iter().any(|&d| self.out.graph.leaves_within([d]).contains(&u.leaf));
        if let Some(unknown) = unknowns.iter().find(open) {
            let message = format!("no constraint contains `{}`, which is solved for", unknown.name);
            self.problems.note("derivation::constraints", unknown.span.clone(), message);
            return None;
        }
        let span = place?;
        (!unknowns.is_empty()).then_some(Start { unknowns, equations, differences, span })
    }

    /// Whether a value is a guess: one that stands where guesses are not taken is refused.
    pub fn is_guess(&mut self, value: &Value<'_>) -> bool {
        let DeValue::Table(_) = value.get_ref() else { return false };
        if self.guesses.is_none() {
            let message = "a value that is solved for stands among initial values only";
            self.problems
                .note("derivation::wrong-type", value.span(), message)
                .hint("write a number or a formula here");
        }
        true
    }
}
