//! What the names of a document mean, and where that ends.
//!
//! **In:** definitions, and where groups, environments and formulas begin and end. **Out:** the meaning of a name. **Guaranteed:** a definition is
//! undone at the end of what it stands in, unless it is global; one of a branch of which it is not known whether it is printed, or that is not
//! understood, leaves its name in doubt.
//!
//! An environment is two commands, as in LaTeX: `\newenvironment{x}` defines `\x` and `\endx`.

use std::collections::{BTreeMap, BTreeSet};

use super::super::displays::is_display;
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
    /// What is defined in a way that is not understood.
    NotRead,
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
    /// It stands in a branch of which it is not known whether it is printed, or something that is not understood may have changed it.
    is_doubted: bool,
}

/// A group, formula or environment that a document begins: its end ends the definitions in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum DefinitionScope {
    /// `{`
    Braces,
    /// `{` behind a command that is not known: what is defined in it may be so elsewhere, later, or never.
    Argument,
    /// A cell of a table or of a display in columns.
    Cell,
    /// `\begingroup` and `\bgroup`
    Group,
    /// `$`, `$$`, `\[`, `\(`, `\left`
    Formula(&'static str),
    Environment(String),
}

/// What a name was before it was defined anew, and the number of that definition.
struct Before {
    number: usize,
    name: String,
    meaning: Option<Meaning>,
}

/// The definitions of a document.
#[derive(Default)]
pub(super) struct Defined {
    /// Names whose definitions are passed over.
    passed: BTreeSet<String>,
    commands: BTreeMap<String, Meaning>,
    /// Packages that are being read: what they print is no text of the paper.
    pub packages: usize,
    /// What is defined next is so everywhere, as `\global` says.
    pub is_global: bool,
    /// What is defined now stands in a branch of which it is not known whether it is printed.
    pub is_doubtful: bool,
    /// What has begun, and how much was noted before.
    scopes: Vec<(DefinitionScope, usize)>,
    /// What was before, in the order of definitions.
    before: Vec<Before>,
    /// The number of the next definition.
    next: usize,
    /// Names that were defined everywhere, and when.
    everywhere: BTreeMap<String, usize>,
}

/// Commands of LaTeX's kernel that choose among their arguments: how many they have, and which is printed.
const OF_THE_KERNEL: &[(&str, usize, Option<char>)] = &[
    ("@firstofone", 1, Some('1')),
    ("@firstoftwo", 2, Some('1')),
    ("@secondoftwo", 2, Some('2')),
    ("@gobble", 1, None),
    ("@gobbletwo", 2, None),
    ("@empty", 0, None),
];

/// How far back what ends is looked for.
const MOST_OPEN: usize = 200;

impl Defined {
    /// No definitions; those of some names are passed over.
    pub(super) fn passing(passed: BTreeSet<String>) -> Defined {
        let mut all = Defined { passed, ..Defined::default() };
        for (name, arguments, printed) in OF_THE_KERNEL {
            let body = printed.map(|nth| Token { kind: Kind::Argument, text: nth.into(), span: 0..0 });
            let what = CommandMeaning::Macro(Macro::plain(*arguments, None, body.into_iter().collect()));
            all.commands.insert((*name).to_owned(), Meaning { what, is_doubted: false });
        }
        all
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

    /// The command of LaTeX for which a name stands, or the name.
    pub(super) fn meant<'n>(&'n self, name: &'n str) -> &'n str {
        self.alias(name).unwrap_or(name)
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

    /// Whether a name has a meaning of the document's own.
    pub(super) fn is_own(&self, name: &str) -> bool {
        self.commands.contains_key(name)
    }

    /// Puts the meaning of a name in doubt, also of one that has none here.
    pub(super) fn doubt(&mut self, name: &str) {
        if self.passed.contains(name) {
            return;
        }
        let was = self.commands.get(name).cloned();
        if was.as_ref().is_some_and(|m| m.is_doubted) {
            return;
        }
        let what = was.as_ref().map_or(CommandMeaning::NotRead, |m| m.what.clone());
        self.commands.insert(name.to_owned(), Meaning { what, is_doubted: true });
        self.note(name.to_owned(), was);
    }

    /// Gives a name a meaning that is not understood; of a package that counts for the paper's own names alone.
    pub(super) fn not_read(&mut self, name: String) {
        if self.packages == 0 {
            self.assign(name.clone(), CommandMeaning::NotRead);
        }
        if self.is_own(&name) {
            self.doubt(&name);
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
        self.note(name, was);
    }

    /// Notes what a name was, to be undone.
    fn note(&mut self, name: String, meaning: Option<Meaning>) {
        self.next += 1;
        if self.is_global {
            self.everywhere.insert(name, self.next);
        } else if !self.scopes.is_empty() {
            self.before.push(Before { number: self.next, name, meaning });
        }
    }

    /// Defines a macro.
    pub(super) fn put(&mut self, name: String, found: Macro) {
        match self.takes(&name, &found.body) {
            true => self.assign(name, CommandMeaning::Macro(found)),
            false => self.not_read(name),
        }
    }

    /// Defines a pair of delimiters.
    pub(super) fn put_pair(&mut self, name: String, found: Macro) {
        if self.takes(&name, &found.body) {
            self.assign(name, CommandMeaning::Pair(found));
        }
    }

    /// Whether an environment of this name is one of the document's own, or may be.
    pub(super) fn has_environment(&self, name: &str) -> bool {
        self.commands.get(name).is_some_and(|m| match m.what {
            CommandMeaning::Macro(_) | CommandMeaning::Pair(_) | CommandMeaning::Alias(_) => true,
            CommandMeaning::NotRead => is_display(name) || self.is_own(&format!("end{name}")),
            CommandMeaning::Condition(_) => false,
        }) || is_display(name) && self.is_own(&format!("end{name}"))
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
                    CommandMeaning::Alias(_) | CommandMeaning::Condition(_) | CommandMeaning::NotRead => &[],
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

    /// Whether what is read now stands in a formula.
    pub(super) fn is_in_formula(&self) -> bool {
        let is_formula = |scope: &DefinitionScope| match scope {
            DefinitionScope::Formula(_) => true,
            DefinitionScope::Environment(name) => is_display(name),
            DefinitionScope::Braces | DefinitionScope::Argument | DefinitionScope::Cell | DefinitionScope::Group => {
                false
            }
        };
        self.scopes.iter().rev().take(MOST_OPEN).any(|(scope, _)| is_formula(scope))
    }

    /// Something begins.
    pub(super) fn begin(&mut self, scope: DefinitionScope) {
        self.scopes.push((scope, self.before.len()));
    }

    /// Something ends, with all that began in it. What has not begun does not end.
    pub(super) fn end(&mut self, scope: &DefinitionScope) {
        let is_it = |open: &DefinitionScope| {
            open == scope || (scope, open) == (&DefinitionScope::Braces, &DefinitionScope::Argument)
        };
        let behind = self.scopes.iter().rev().take(MOST_OPEN).position(|(open, _)| is_it(open));
        if let Some(behind) = behind {
            self.end_to(self.scopes.len() - 1 - behind);
        }
    }

    /// Ends what has begun, up to so much; definitions in it are undone, and those in an argument of a command that is not known are in doubt.
    fn end_to(&mut self, depth: usize) {
        let Some(&(_, noted)) = self.scopes.get(depth) else { return };
        let from = self.scopes[depth..].iter().find(|(scope, _)| *scope == DefinitionScope::Argument);
        let arguments = from.map_or(usize::MAX, |(_, noted)| *noted);
        let mut unsure = Vec::new();
        self.scopes.truncate(depth);
        while self.before.len() > noted
            && let Some(Before { number, name, meaning }) = self.before.pop()
        {
            if self.everywhere.get(&name).is_some_and(|when| *when > number) {
                continue;
            }
            if self.before.len() >= arguments {
                unsure.push(name.clone());
            }
            match meaning {
                Some(meaning) => drop(self.commands.insert(name, meaning)),
                None => drop(self.commands.remove(&name)),
            }
        }
        unsure.iter().for_each(|name| self.doubt(name));
    }
}
