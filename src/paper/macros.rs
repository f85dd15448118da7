//! Macros of a paper, expanded: what is left is what LaTeX would print.
//!
//! **In:** the tokens of a document. **Out:** those that it prints; where there are more than can be read, the first of them, and where reading
//! ended. **Guaranteed:** a macro that takes most of what a paper may have is named, the outermost one; without it the rest can be read.
//!
//! A token that comes out of a macro has the place of the call, so that a difference points at what the author wrote.
//!
//! **What is not known**: what stands in a branch that may not be printed, and all that is made of a name to which something has been done that is
//! not understood, is printed and in doubt: no formula in it is judged.

mod alters;
mod behind;
mod branches;
mod call;
mod conditions;
mod cut;
mod define;
mod defined;
mod doubts;
mod environments;
mod expansion;
mod kernel;
mod rest;
mod scopes;
#[cfg(test)]
mod tests;
mod units;

use std::collections::BTreeSet;
use std::ops::Range;

use behind::Behind;
use branches::{BranchForm, Unclosed};
use call::call;
use define::define;
pub(super) use defined::Definitions;
use defined::{CommandMeaning, Defined, DefinitionScope};
pub(super) use doubts::Doubts;
use rest::{MOST_NAME, Rest, argument, next_is, optional, spaces, takes_braces};
use units::Units;

use super::displays;
use super::named::{COMMANDS_OF_TEXT, Input, Named, PACKAGES};
use super::note::PaperNote;
use super::short::Short;
use super::token::{IN_DOUBT, Kind, MOST_TOKENS, Token};

/// The most calls of macros.
const MOST_CALLS: usize = 1_000_000;
/// The deepest that macros may call each other.
const DEEPEST: usize = 200;

/// Macros that do not end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Endless {
    /// The name of one of them.
    pub name: String,
    /// Where it is called.
    pub span: Range<usize>,
}

/// The tokens that a document prints.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Expanded {
    pub tokens: Vec<Token>,
    /// Where reading ended, if the document goes on there.
    pub cut: Option<Range<usize>>,
    /// Of which places it is not known whether they are printed, or as what.
    pub doubts: Doubts,
    /// Notes of places that were not read.
    pub notes: Vec<PaperNote>,
}

/// A macro that is being expanded, and how much was read before it.
struct Outer {
    /// Its name; none for what stands in a file.
    name: Option<Short>,
    calls: usize,
    tokens: usize,
}

/// The outermost macro from which what stands so deep comes, if it took most of what a paper may have.
fn at_fault(outer: &[Outer], depth: usize, (calls, tokens): (usize, usize)) -> Option<&str> {
    let first = outer.iter().take(depth).find(|o| o.name.is_some())?;
    let most = calls - first.calls > MOST_CALLS / 2 || tokens - first.tokens > MOST_TOKENS / 2;
    first.name.as_deref().filter(|_| most)
}

/// The command that stands behind the text of a package while it is read; no text has it, nor the next ones.
const END_OF_DEFINITIONS: &str = "";
/// That behind the text of another file.
const END_OF_FILE: &str = "end file";
/// That behind branches that are arguments.
const END_OF_BRANCHES: &str = "end branches";
/// The mark behind the end of an environment of the document's own; its name follows.
const END_OF_ENVIRONMENT: &str = "end environment ";

/// Commands of classes for exercises, and of layout, that print their argument as it is; options before it are not printed.
const PRINT_THEIR_ARGUMENT: &[&str] = &["answer", "eqmathbox"];

/// Commands that do what stands in their argument, outside of any group.
const DO_THEIR_ARGUMENT: &[&str] =
    &["AtBeginDocument", "AtEndPreamble", "AfterEndPreamble", "AfterPreamble", "AtEndOfClass", "AtEndOfPackage"];
/// Those of them that do it where the document begins.
const DO_IT_AT_BEGIN: &[&str] = &["AtBeginDocument", "AtEndPreamble", "AfterEndPreamble", "AfterPreamble"];

/// Commands between `\\global` and what it is said of.
const BEHIND_GLOBAL: &[&str] = &["long", "outer", "protected", "relax"];
/// Those that make the next one first.
const MAKES_NEXT: &[&str] = &["expandafter", "csname"];

/// Whether reading goes on.
enum Then {
    Next,
    /// The document ends.
    End,
    /// It is too long.
    Cut(Range<usize>),
}

/// A document that is being expanded.
struct Expander<'e, 'i> {
    /// The tokens that are still to be read, the next one last; the depth of macros it came from beside it.
    rest: Rest,
    out: Vec<Token>,
    defined: Defined,
    definitions: Definitions,
    /// Macros that leave nothing can call each other more often than any paper has tokens.
    calls: usize,
    outer: Vec<Outer>,
    conditions: Vec<Unclosed>,
    /// Tokens that were looked at to find where conditions end.
    looked: usize,
    units: Units,
    doubts: Doubts,
    /// Where the last call ends of which the meaning is in doubt.
    doubted_to: usize,
    /// The files within files that are being read.
    files: usize,
    /// What the document does where it begins, if that is still to come.
    at_begin: Option<Rest>,
    /// The definitions of a main file are read before a chapter.
    is_chapter: bool,
    behind: Behind,
    notes: Vec<PaperNote>,
    input: &'e mut Input<'i>,
}

/// The tokens of a document with its own macros expanded; definitions leave no token, and those of the names in `passed` no meaning. `preamble` is that of
/// the main file of a chapter: only its definitions count. `input` gives the tokens of a file that the document names, if it may be read.
pub(super) fn expanded(
    mut document: Vec<Token>,
    preamble: Vec<Token>,
    passed: &BTreeSet<String>,
    definitions: Definitions,
    input: &mut Input<'_>,
) -> Result<Expanded, Endless> {
    let mut cut = document.get(MOST_TOKENS).map(|t| t.span.clone());
    document.truncate(MOST_TOKENS);
    let rest: Rest = document.into_iter().rev().map(|t| (t, 0)).collect();
    let begins = (0..rest.len()).any(|at| rest[at].0.is("begin") && begins_group(&rest[..at], "document"));
    let at_begin = (begins || !preamble.is_empty()).then(Vec::new);
    let mut all = Expander {
        out: Vec::with_capacity(rest.len()),
        rest,
        defined: Defined::passing(passed.clone()),
        definitions,
        calls: 0,
        outer: Vec::new(),
        conditions: Vec::new(),
        looked: 0,
        units: Units::default(),
        doubts: Doubts::default(),
        doubted_to: 0,
        files: 0,
        at_begin,
        is_chapter: !preamble.is_empty(),
        behind: Behind::default(),
        notes: Vec::new(),
        input,
    };
    if !preamble.is_empty() {
        all.defined.packages = 1;
        all.put_behind(END_OF_DEFINITIONS, 0..0, 0);
        all.rest.extend(preamble.into_iter().rev().map(|t| (t, 0)));
    }
    while let Some((token, depth)) = all.rest.pop() {
        if all.out.len() >= MOST_TOKENS {
            if let Some(name) = at_fault(&all.outer, depth, (all.calls, all.out.len())) {
                return Err(Endless { name: name.to_owned(), span: token.span });
            }
            cut = Some(token.span);
            break;
        }
        match all.take(token, depth)? {
            Then::Next => {}
            Then::End => {
                cut = None;
                break;
            }
            Then::Cut(span) => {
                cut = Some(span);
                break;
            }
        }
    }
    let Expander { mut out, doubts, notes, .. } = all;
    if cut.is_some() {
        let end = cut::end_of_whole(&out);
        cut = out.get(end).map(|t| t.span.clone()).or(cut);
        out.truncate(end);
    }
    Ok(Expanded { tokens: out, cut, doubts: doubts.in_order(), notes })
}

impl Expander<'_, '_> {
    /// Puts a command that no text has in front of what is still to be read.
    fn put_behind(&mut self, command: &str, span: Range<usize>, depth: usize) {
        self.rest.push((Token { kind: Kind::Command, text: command.into(), span }, depth));
    }

    /// Takes the next token.
    fn take(&mut self, mut token: Token, depth: usize) -> Result<Then, Endless> {
        let (mut frozen, mut is_sure) = (false, true);
        if token.kind == Kind::Command
            && let Some(meaning) = self.defined.alias(&token.text).map(Short::from)
        {
            if self.defined.is_doubted(&token.text) {
                self.doubt_call(&token);
                is_sure = false;
            }
            token.text = meaning;
            frozen = true;
        }
        let ends_argument = token.kind == Kind::Close && self.defined.innermost() == Some(&DefinitionScope::Argument);
        self.scope(&token);
        if token.kind != Kind::Command {
            self.print(token);
            if ends_argument {
                self.behind = Behind::Unknown;
            }
            return Ok(Then::Next);
        }
        if token.is("end") && begins_group(&self.rest, "document") {
            return Ok(self.end_of_document(&token));
        }
        let is_long = !frozen && self.defined.macro_of(&token.text).is_some_and(units::needs_braces);
        if is_long && let Some(accent) = self.units.accent() {
            let doubt = self.doubts.of_reach(accent);
            self.doubts.note(&token.span, doubt);
        }
        if is_long && self.units.waits() {
            // The argument of a macro of LaTeX: all of what it prints.
            let brace = |kind, text: &str| Token { kind, text: text.into(), span: token.span.clone() };
            self.rest.push((brace(Kind::Close, "}"), depth));
            self.rest.push((token.clone(), depth));
            self.rest.push((brace(Kind::Open, "{"), depth));
            return Ok(Then::Next);
        }
        if self.ends(&token) || self.conditional(&token, depth, is_sure) {
            return Ok(Then::Next);
        }
        if token.is("endinput") && self.defined.macro_of("endinput").is_none() {
            return Ok(self.end_of_input(&token));
        }
        if let Some(value) = self.defined.switched(&token.text) {
            let known = (!self.defined.is_doubtful).then_some(value.1);
            self.defined.assign(value.0, CommandMeaning::Condition(known));
            self.defined.is_global = false;
            return Ok(Then::Next);
        }
        if token.is("global") {
            self.defined.is_global = true;
            return Ok(Then::Next);
        }
        if self.defined.is_global && BEHIND_GLOBAL.contains(&token.text.as_str()) {
            return Ok(Then::Next);
        }
        let is_global = self.defined.is_global && !MAKES_NEXT.contains(&token.text.as_str());
        let then = self.call_or_print(token, depth, frozen);
        // `\\global` is said of what stands right behind it.
        self.defined.is_global &= !is_global;
        then
    }

    /// Takes a command that is none of conditions.
    fn call_or_print(&mut self, token: Token, depth: usize, frozen: bool) -> Result<Then, Endless> {
        if let Some(named) = named_by(&token, &self.defined, frozen) {
            return self.read_files(token, named, depth);
        }
        if self.expand_names(&token, depth)? || define(&token.text, &mut self.rest, &mut self.defined) {
            // Nothing is printed.
            return Ok(Then::Next);
        }
        if token.is("begin") || token.is("end") {
            self.environment(token, depth)?;
        } else if !frozen && self.defined.macro_of(&token.text).is_some() {
            self.call_macro(token, depth)?;
        } else if DO_THEIR_ARGUMENT.contains(&token.text.as_str()) && takes_braces(&self.rest) {
            let body = argument(&mut self.rest);
            let waits = DO_IT_AT_BEGIN.contains(&token.text.as_str()) && self.defined.packages == 0;
            let of_document = if waits { self.at_begin.as_mut() } else { None };
            match of_document {
                Some(waiting) => waiting.extend(body.into_iter().map(|t| (t, depth))),
                None => self.rest.extend(body.into_iter().rev().map(|t| (t, depth))),
            }
        } else if PRINT_THEIR_ARGUMENT.contains(&token.text.as_str()) && takes_braces(&self.rest) {
            while optional(&mut self.rest).is_some() {}
        } else if let Some((ends, name)) = displays::of_command(&token.text).filter(|_| self.at_begin.is_none()) {
            self.print_environment(ends, name, &token);
        } else {
            if !frozen && self.defined.is_doubted(&token.text) {
                self.doubt_call(&token);
            }
            self.doubt_altered(&token);
            self.print(token);
        }
        Ok(Then::Next)
    }

    /// Puts the body of a macro in the place of its call.
    fn call_macro(&mut self, token: Token, depth: usize) -> Result<(), Endless> {
        let is_doubted = self.defined.is_doubted(&token.text);
        if is_doubted {
            self.doubt_call(&token);
        }
        self.calls += 1;
        let Expander { rest, out, defined, calls, outer, doubts, .. } = self;
        let room = MOST_TOKENS.saturating_sub(rest.len() + out.len());
        let too_many = depth >= DEEPEST || *calls > MOST_CALLS;
        if defined.is_pair(&token.text) {
            next_is(rest, "*");
            optional(rest);
        }
        let found = defined.macro_of(&token.text);
        let Some(body) = found.filter(|_| !too_many).and_then(|found| call(found, &token, rest, room)) else {
            let fault = at_fault(outer, depth, (*calls, out.len())).filter(|_| depth < DEEPEST);
            let name = fault.map_or_else(|| token.text.to_string(), str::to_owned);
            return Err(Endless { name, span: token.span });
        };
        if is_doubted {
            let doubt = doubts.of_meaning(&token);
            body.iter().for_each(|t| doubts.note(&t.span, doubt));
        }
        outer.truncate(depth);
        outer.push(Outer { name: Some(token.text), calls: *calls, tokens: out.len() });
        self.rest.extend(body.into_iter().rev().map(|t| (t, depth + 1)));
        Ok(())
    }

    /// What a name of which the meaning is in doubt makes of itself and of the arguments behind it is not known.
    fn doubt_call(&mut self, token: &Token) {
        let doubt = self.doubts.of_meaning(token);
        self.doubts.note(&token.span, doubt);
        if token.span.start < self.doubted_to {
            return;
        }
        if let Some(end) = rest::end_of_groups(&self.rest, &mut self.looked).filter(|end| *end > token.span.start) {
            self.doubts.note(&(token.span.start..end), doubt);
            self.doubted_to = end;
        }
    }

    /// Puts the files that a command names in its place.
    fn read_files(&mut self, token: Token, named: Named, depth: usize) -> Result<Then, Endless> {
        self.calls += 1;
        if self.calls > MOST_CALLS || depth >= DEEPEST {
            return Err(Endless { name: token.text.into(), span: token.span });
        }
        let file = files_named(named, &token, &mut self.rest, self.input);
        if file.len() + self.rest.len() + self.out.len() > MOST_TOKENS {
            return Ok(Then::Cut(token.span));
        }
        if file.is_empty() {
            return Ok(Then::Next);
        }
        self.defined.packages += usize::from(named != Named::Text);
        self.files += usize::from(named == Named::Text);
        let end = if named == Named::Text { END_OF_FILE } else { END_OF_DEFINITIONS };
        self.put_behind(end, token.span, depth);
        self.outer.truncate(depth);
        self.outer.push(Outer { name: None, calls: self.calls, tokens: self.out.len() });
        self.rest.extend(file.into_iter().rev().map(|t| (t, depth + 1)));
        Ok(Then::Next)
    }

    /// Takes what stands behind files and environments.
    fn ends(&mut self, token: &Token) -> bool {
        if let Some(name) = token.text.strip_prefix(END_OF_ENVIRONMENT) {
            self.defined.end(&DefinitionScope::Environment(name.to_owned()));
            self.end_doubt(&BranchForm::Environment(name.to_owned()));
            return true;
        }
        if token.is(END_OF_DEFINITIONS) {
            // What a package begins and does not end has no end in the paper.
            let here = self.defined.packages;
            while self.conditions.last().is_some_and(|c| c.packages >= here) {
                self.conditions.pop();
            }
            self.defined.packages = here.saturating_sub(1);
            self.be_doubtful();
            if self.defined.packages == 0 && self.is_chapter {
                self.begin_document();
            }
            return true;
        }
        if let Some(name) = token.text.strip_prefix(IN_DOUBT) {
            // One whose own definition is in doubt says it itself.
            if self.defined.is_doubted(name) {
                return true;
            }
            let named = Token { kind: Kind::Command, text: name.into(), span: token.span.clone() };
            let doubt = self.doubts.of_meaning(&named);
            self.open(BranchForm::Environment(name.to_owned()), Some(doubt));
            return true;
        }
        if token.is(END_OF_FILE) {
            self.end_doubt(&BranchForm::File(self.files));
            self.files = self.files.saturating_sub(1);
            return true;
        }
        false
    }

    /// Puts what waits for the beginning of the document in front of what follows.
    fn begin_document(&mut self) {
        let waiting = self.at_begin.take().unwrap_or_default();
        self.rest.extend(waiting.into_iter().rev());
    }

    /// At `\\endinput`: drops what stands behind it in its file; where it is not known whether that is done, that is in doubt.
    fn end_of_input(&mut self, token: &Token) -> Then {
        if self.may_be_passed_over() {
            self.doubt_what_follows(token, BranchForm::File(self.files));
            return Then::Next;
        }
        let end = |t: &Token| t.is(END_OF_FILE) || t.is(END_OF_DEFINITIONS);
        match self.rest.iter().rposition(|(t, _)| end(t)) {
            Some(at) => {
                self.rest.truncate(at + 1);
                Then::Next
            }
            None => Then::End,
        }
    }

    fn end_of_document(&mut self, token: &Token) -> Then {
        if self.may_be_passed_over() {
            self.doubt_what_follows(token, BranchForm::File(0));
            return Then::Next;
        }
        Then::End
    }

    /// Puts out a token that is printed.
    fn print(&mut self, token: Token) {
        self.behind = self.behind.after(&token);
        if self.defined.packages > 0 {
            return;
        }
        match self.conditions.last().and_then(|c| c.doubt) {
            Some(doubt) => self.doubts.note(&token.span, doubt),
            None => self.doubts.pass(&token.span),
        }
        let has_option = token.is("sqrt") && self.rest.last().is_some_and(|(t, _)| t.is_char("["));
        self.units.take(&token, has_option);
        self.out.push(token);
    }
}

/// The kind of file that a command names, unless the document gave it another meaning.
fn named_by(token: &Token, defined: &Defined, frozen: bool) -> Option<Named> {
    let command = token.text.as_str();
    let package = || PACKAGES.iter().find(|(name, _)| *name == command).map(|(_, named)| *named);
    let named = if COMMANDS_OF_TEXT.contains(&command) { Named::Text } else { package()? };
    (frozen || defined.macro_of(command).is_none()).then_some(named)
}

/// The tokens of the files that a command names, one behind the other.
fn files_named(named: Named, token: &Token, rest: &mut Rest, input: &mut Input<'_>) -> Vec<Token> {
    if named == Named::Text {
        let name = file_name(rest);
        return input(&name, named, &token.span);
    }
    optional(rest);
    let names: String = argument(rest).iter().map(|t| t.text.as_str()).collect();
    names.split(',').map(str::trim).filter(|n| !n.is_empty()).flat_map(|n| input(n, named, &token.span)).collect()
}

/// The name of a file behind `\input`, in braces or not.
fn file_name(rest: &mut Rest) -> String {
    spaces(rest);
    let text = |t: &Token| if t.kind == Kind::Command { format!("\\{}", t.text) } else { t.text.to_string() };
    if rest.last().is_some_and(|(t, _)| t.kind == Kind::Open) {
        // Quotation marks hold a name with blanks together.
        return argument(rest).iter().map(text).collect::<String>().replace('"', "").trim().to_owned();
    }
    let mut out = String::new();
    while rest.last().is_some_and(|(t, _)| t.kind == Kind::Other) && out.len() < MOST_NAME {
        out.extend(rest.pop().map(|(t, _)| String::from(t.text)));
    }
    out
}

fn begins_group(rest: &[(Token, usize)], name: &str) -> bool {
    let mut next = rest.iter().rev().map(|(t, _)| t);
    let open = next.next().is_some_and(|t| t.kind == Kind::Open);
    let inside: String = next.take_while(|t| t.kind != Kind::Close).take(40).map(|t| t.text.as_str()).collect();
    open && inside == name
}
