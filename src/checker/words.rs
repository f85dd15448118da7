//! Sequents and times in words, so that a reader sees what is proved.
//!
//! **In:** a [`Sequent`], or a set of times. **Out:** a sentence: "For every motion with …, at every time at which …". **Guaranteed:** each list of the sequent that is not empty is
//! named, with the times at which it is meant; formulas are in LaTeX, between backquotes, with the names of the file (definitions are not put in, but named).

use super::context::Context;
use super::draft::{Draft, Refused};
use super::sequent::{Claimed, ConstantSign, Declared, Sequent, SymbolKind};
use super::term::{Relation, Term, TermNode};
use super::when::{Instant, When};

/// The times of a set.
pub(crate) fn when(draft: &Draft, when: &When) -> String {
    match when {
        When::At(Instant(at)) => {
            let c = draft.context.instants.get(*at as usize).map(|c| draft.context.graph.to_latex(*c));
            format!("at the time `{}`", c.unwrap_or_default())
        }
        When::Chosen => "at the chosen times".to_owned(),
        When::ChosenOpen => "at the chosen times, which are an open set".to_owned(),
        When::Always => "at all times".to_owned(),
        When::In(case, inner) => {
            let supposed = draft.cases.get(case.0 as usize);
            let text = match supposed.and_then(|case| case.says) {
                Some(says) => format!("`{}`", draft.context.latex(says)),
                None => "the claim has a value".to_owned(),
            };
            let manner = match supposed.map(|case| case.manner) {
                Some(super::step::Manner::OnIntervals) => "on intervals on which",
                Some(super::step::Manner::AtTimes) | None => "where",
            };
            format!("{} {manner} {text}", self::when(draft, inner))
        }
    }
}

/// Formulas as they are written.
struct Printer(Context);

impl Printer {
    fn latex(&mut self, term: &Term) -> String {
        self.0.read(term).map(|e| self.0.graph.to_latex(e)).unwrap_or_default()
    }

    fn relation(&mut self, relation: &Relation) -> String {
        self.0.relation(relation).map(|says| format!("`{}`", self.0.latex(says))).unwrap_or_default()
    }

    fn relations(&mut self, relations: &[Relation]) -> String {
        relations.iter().map(|r| self.relation(r)).collect::<Vec<_>>().join(", ")
    }

    fn claimed(&mut self, claimed: &Claimed) -> String {
        let mut text = format!("the claim {}: {}", claimed.name, self.relation(&claimed.says));
        if !claimed.selectors.is_empty() {
            text += &format!(" at every time at which {}", self.relations(&claimed.selectors));
        }
        if !claimed.hypotheses.is_empty() {
            text += &format!(", if {} at all of these times", self.relations(&claimed.hypotheses));
        }
        text
    }
}

fn symbol_words(declared: &Declared) -> Option<String> {
    let of = match declared.kind {
        SymbolKind::Time | SymbolKind::Coordinate | SymbolKind::Defined => return None,
        SymbolKind::Field(orders) => {
            return Some(format!("`{}`, a field with continuous derivatives up to order {orders}", declared.name));
        }
        SymbolKind::Constant(ConstantSign::Any) => "a number",
        SymbolKind::Constant(ConstantSign::Positive) => "a positive number",
        SymbolKind::Constant(ConstantSign::NotNegative) => "a number that is not negative",
        SymbolKind::Constant(ConstantSign::NotZero) => "a number that is not 0",
        SymbolKind::Moves(0) => "a continuous function of time",
        SymbolKind::Moves(orders) => {
            return Some(format!("`{}`, a function of time with {orders} continuous rates", declared.name));
        }
    };
    Some(format!("`{}`, {of}", declared.name))
}

impl Sequent {
    /// The sequent in words.
    ///
    /// # Errors
    /// [`Refused`] if a term cannot be read.
    pub fn words(&self) -> Result<String, Refused> {
        Draft::new(self)?;
        let mut printer = Printer(Context::as_written(self).map_err(|why| Refused { step: None, why })?);
        let (time, times) = match printer.0.has_fields() {
            true => ("place and time", "places and times"),
            false => ("time", "times"),
        };
        let symbols: Vec<String> = self.symbols.iter().filter_map(symbol_words).collect();
        let mut text = format!("For every motion ({})", symbols.join("; "));
        let mut parts = Vec::new();
        let systems = printer.relations(&self.systems);
        let premises = printer.relations(&self.premises);
        let claims: Vec<String> = self.claims.iter().map(|c| printer.claimed(c)).collect();
        let definitions = self.definitions.iter().map(|d| {
            let leaf = TermNode::Leaf { name: d.name.clone(), component: d.component, rate: 0, at: None };
            printer.relation(&Relation::equal(Term(vec![leaf]), d.formula.clone()))
        });
        let definitions: Vec<String> = definitions.collect();
        let always = format!("at all {times}");
        for (list, of) in
            [(definitions.join(", "), "by definition".to_owned()), (systems, always.clone()), (premises, always)]
        {
            if !list.is_empty() {
                parts.push(format!("{list} {of}"));
            }
        }
        parts.extend(claims);
        let (selectors, assumed) = (printer.relations(&self.selectors), printer.relations(&self.assumed));
        let chosen = if selectors.is_empty() {
            format!("at every {time}")
        } else {
            format!("at every {time} at which {selectors}")
        };
        if !assumed.is_empty() {
            parts.push(format!("{assumed} {chosen}"));
        }
        if !parts.is_empty() {
            text += &format!(" with {}", parts.join("; with "));
        }
        let instants: Vec<String> = self.instants.iter().map(|c| format!("`{}`", printer.latex(c))).collect();
        if !instants.is_empty() {
            text += &format!(", on times among which are {}", instants.join(", "));
        }
        let void = if assumed.is_empty() { "" } else { " and the assumptions have values" };
        text += &format!(": {chosen}{void}, {} where both sides have values.", printer.relation(&self.claim));
        Ok(text)
    }
}

/// Relations of a sequent in words; nothing where it cannot be read.
pub(crate) fn relations(sequent: &Sequent, relations: &[Relation]) -> Vec<String> {
    let Ok(context) = Context::as_written(sequent) else { return Vec::new() };
    let mut printer = Printer(context);
    relations.iter().map(|relation| printer.relation(relation)).collect()
}
