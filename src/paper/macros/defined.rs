//! What the names of a document mean, and where that ends.
//!
//! **In:** definitions, and where groups, environments and formulas begin and end. **Out:** the meaning of a name. **Guaranteed:** a definition is
//! undone at the end of what it stands in, unless it is global; one of a branch of which it is not known whether it is printed leaves its name in doubt.

use std::collections::{BTreeMap, BTreeSet};

use super::super::token::{Kind, Token};
use super::define::is_taken_of_package;
use super::kernel::is_of_latex;
use super::rest::Macro;

/// Where definitions end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Definitions {
    /// With the group, the environment or the formula in which they stand, as in LaTeX.
    OfTheirGroup,
    /// Never, as on pages, which write formulas with MathJax.
    OfTheWhole,
}

/// The meaning of a command.
#[derive(Clone, Debug)]
pub(super) enum CommandMeaning {
    Macro(Macro),
    /// A pair of delimiters: a star, or a size in brackets, stands before the argument of some calls.
    Pair(Macro),
    /// What `\let` gave to a command of LaTeX: it keeps its meaning, whatever becomes of that.
    Alias(String),
    /// A condition of `\newif`, `ifdraft`, and whether it holds, if that is known.
    Condition(Option<bool>),
}

impl CommandMeaning {
    /// Whether both are macros that print the same.
    fn prints_as(&self, other: &CommandMeaning) -> bool {
        let alike = |a: &[Token], b: &[Token]| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.kind == b.kind && a.text == b.text)
        };
        match (self, other) {
            (CommandMeaning::Macro(a), CommandMeaning::Macro(b)) => {
                let is_plain = |m: &Macro| m.default.is_none() && m.pattern.is_empty() && m.options.is_empty();
                is_plain(a) && is_plain(b) && a.arguments == b.arguments && alike(&a.body, &b.body)
            }
            (CommandMeaning::Alias(a), CommandMeaning::Alias(b)) => a == b,
            (CommandMeaning::Condition(a), CommandMeaning::Condition(b)) => a == b && a.is_some(),
            _ => false,
        }
    }
}

/// The meaning of a command.
#[derive(Clone, Debug)]
struct Meaning {
    what: CommandMeaning,
    /// It stands in a branch of which it is not known whether it is printed.
    is_doubted: bool,
}

/// A group, formula or environment that a document begins: its end ends the definitions in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum DefinitionScope {
    /// `{`
    Braces,
    /// `\begingroup` and `\bgroup`
    Group,
    /// `$`, `$$`, `\[`, `\(`, `\left`
    Formula(&'static str),
    Environment(String),
}

type Environment = (Macro, Macro);

/// What a name was before it was defined anew.
enum Before {
    Command(String, Option<Meaning>),
    Environment(String, Option<Environment>),
}

/// The definitions of a document.
#[derive(Default)]
pub(super) struct Defined {
    /// Names whose definitions are passed over.
    passed: BTreeSet<String>,
    commands: BTreeMap<String, Meaning>,
    /// Environments: what stands at their beginning and at their end.
    pub environments: BTreeMap<String, Environment>,
    /// Packages that are being read: what they print is no text of the paper.
    pub packages: usize,
    /// What is defined next is so everywhere, as `\global` says.
    pub is_global: bool,
    /// What is defined now stands in a branch of which it is not known whether it is printed.
    pub is_doubtful: bool,
    /// What has begun, and how much was noted before.
    scopes: Vec<(DefinitionScope, usize)>,
    /// What was before, in the order of definitions, each with its number.
    before: Vec<(usize, Before)>,
    /// The number of the next definition.
    next: usize,
    /// Names that were defined everywhere, and when.
    everywhere: BTreeMap<String, usize>,
}

/// How far back what ends is looked for.
const MOST_OPEN: usize = 200;

impl Defined {
    /// No definitions; those of some names are passed over.
    pub(super) fn passing(passed: BTreeSet<String>) -> Defined {
        Defined { passed, ..Defined::default() }
    }

    /// Whether a definition is taken: of a package not each.
    pub(super) fn takes(&self, name: &str, body: &[Token]) -> bool {
        self.packages == 0 || is_taken_of_package(name, body)
    }

    /// The macro of this name.
    pub(super) fn macro_of(&self, name: &str) -> Option<&Macro> {
        match &self.commands.get(name)?.what {
            CommandMeaning::Macro(found) | CommandMeaning::Pair(found) => Some(found),
            _ => None,
        }
    }

    /// Whether this is a pair of delimiters.
    pub(super) fn is_pair(&self, name: &str) -> bool {
        self.commands.get(name).is_some_and(|m| matches!(m.what, CommandMeaning::Pair(_)))
    }

    /// The command of LaTeX for which this name stands.
    pub(super) fn alias(&self, name: &str) -> Option<&str> {
        match &self.commands.get(name)?.what {
            CommandMeaning::Alias(meaning) => Some(meaning),
            _ => None,
        }
    }

    /// Whether a condition of the document's own holds, if that is known; `None` for what is none.
    pub(super) fn condition(&self, name: &str) -> Option<Option<bool>> {
        let found = self.commands.get(name)?;
        match found.what {
            CommandMeaning::Condition(value) => Some(value.filter(|_| !found.is_doubted)),
            _ => None,
        }
    }

    /// Whether it is not known whether the definition of a name is printed.
    pub(super) fn is_doubted(&self, name: &str) -> bool {
        self.commands.get(name).is_some_and(|m| m.is_doubted)
    }

    /// Whether a name has a meaning: one of the document's own, or of LaTeX.
    pub(super) fn has(&self, name: &str) -> bool {
        self.commands.contains_key(name) || is_of_latex(name)
    }

    /// Puts the meaning of a name in doubt.
    pub(super) fn doubt(&mut self, name: &str) {
        if let Some(meaning) = self.commands.get_mut(name) {
            meaning.is_doubted = true;
        }
    }

    /// Gives a name a meaning.
    pub(super) fn assign(&mut self, name: String, what: CommandMeaning) {
        if self.passed.contains(&name) && !matches!(what, CommandMeaning::Condition(_)) {
            return;
        }
        let was = self.commands.remove(&name);
        let is_same = was.as_ref().is_some_and(|m| !m.is_doubted && m.what.prints_as(&what));
        let is_doubted = self.is_doubtful && !is_same;
        self.commands.insert(name.clone(), Meaning { what, is_doubted });
        self.note(name.clone(), Before::Command(name, was));
    }

    /// Notes what a name was, to be undone.
    fn note(&mut self, name: String, was: Before) {
        self.next += 1;
        if self.is_global {
            self.everywhere.insert(name, self.next);
        } else if !self.scopes.is_empty() {
            self.before.push((self.next, was));
        }
    }

    /// Defines a macro.
    pub(super) fn put(&mut self, name: String, found: Macro) {
        if self.takes(&name, &found.body) {
            self.assign(name, CommandMeaning::Macro(found));
        }
    }

    /// Defines a pair of delimiters.
    pub(super) fn put_pair(&mut self, name: String, found: Macro) {
        if self.takes(&name, &found.body) {
            self.assign(name, CommandMeaning::Pair(found));
        }
    }

    /// Defines an environment.
    pub(super) fn put_environment(&mut self, name: String, found: Environment) {
        let was = self.environments.insert(name.clone(), found);
        self.note(format!("begin {name}"), Before::Environment(name, was));
    }

    /// Gives a name the meaning that a token has now.
    pub(super) fn let_be(&mut self, name: String, meaning: Token) {
        if meaning.kind != Kind::Command {
            return self.put(name, Macro::plain(0, None, vec![meaning]));
        }
        match self.commands.get(meaning.text.as_str()).cloned() {
            Some(Meaning { what, is_doubted }) => {
                let body = match &what {
                    CommandMeaning::Macro(found) | CommandMeaning::Pair(found) => found.body.as_slice(),
                    _ => &[],
                };
                if self.takes(&name, body) {
                    self.assign(name.clone(), what);
                    if is_doubted {
                        self.doubt(&name);
                    }
                }
            }
            None if self.takes(&name, &[]) => self.assign(name, CommandMeaning::Alias(meaning.text.into())),
            None => {}
        }
    }

    /// At `\drafttrue` or `\draftfalse`: the condition, and what it becomes.
    pub(super) fn switched(&self, command: &str) -> Option<(String, bool)> {
        let (name, value) = match command.strip_suffix("true") {
            Some(name) => (name, true),
            None => (command.strip_suffix("false")?, false),
        };
        let condition = format!("if{name}");
        self.condition(&condition).is_some().then_some((condition, value))
    }

    /// What has begun last and not ended.
    pub(super) fn innermost(&self) -> Option<&DefinitionScope> {
        self.scopes.last().map(|(scope, _)| scope)
    }

    /// Something begins.
    pub(super) fn begin(&mut self, scope: DefinitionScope) {
        self.scopes.push((scope, self.before.len()));
    }

    /// Something ends, with all that began in it. What has not begun does not end.
    pub(super) fn end(&mut self, scope: &DefinitionScope) {
        let behind = self.scopes.iter().rev().take(MOST_OPEN).position(|(open, _)| open == scope);
        if let Some(behind) = behind {
            self.end_to(self.scopes.len() - 1 - behind);
        }
    }

    /// Ends what has begun, up to so much; definitions in it are undone.
    fn end_to(&mut self, depth: usize) {
        let Some(&(_, noted)) = self.scopes.get(depth) else { return };
        self.scopes.truncate(depth);
        let is_everywhere =
            |all: &BTreeMap<String, usize>, name: &str, number: usize| all.get(name).is_some_and(|when| *when > number);
        while self.before.len() > noted
            && let Some((number, was)) = self.before.pop()
        {
            match was {
                Before::Command(name, _) if is_everywhere(&self.everywhere, &name, number) => {}
                Before::Command(name, Some(meaning)) => drop(self.commands.insert(name, meaning)),
                Before::Command(name, None) => drop(self.commands.remove(&name)),
                Before::Environment(name, _) if is_everywhere(&self.everywhere, &format!("begin {name}"), number) => {}
                Before::Environment(name, Some(found)) => drop(self.environments.insert(name, found)),
                Before::Environment(name, None) => drop(self.environments.remove(&name)),
            }
        }
    }
}
