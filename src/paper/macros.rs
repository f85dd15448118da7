//! Macros of a paper, expanded: what is left is what LaTeX would print.
//!
//! **In:** the tokens of a document. **Out:** those that it prints; where there are more than can be read, the first of them, and where reading
//! ended. **Guaranteed:** a macro that takes most of what a paper may have is named, the outermost one; without it the rest can be read.
//!
//! A token that comes out of a macro has the place of the call, so that a difference points at what the author wrote.

mod branches;
mod call;
mod conditions;
mod cut;
mod define;
mod defined;
mod doubts;
mod kernel;
mod rest;
#[cfg(test)]
mod tests;
mod units;

use std::collections::BTreeSet;
use std::ops::Range;

use branches::Unclosed;
use call::call;
use define::define;
pub(super) use defined::Definitions;
use defined::{CommandMeaning, Defined, DefinitionScope};
pub(super) use doubts::Doubts;
use rest::{MOST_NAME, Macro, Rest, argument, next_is, optional, spaces, takes_braces};
use units::Units;

use super::named::{COMMANDS_OF_TEXT, Input, Named, PACKAGES};
use super::note::PaperNote;
use super::short::Short;
use super::token::{Kind, MOST_TOKENS, Token};

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
const DO_THEIR_ARGUMENT: &[&str] = &["AtBeginDocument", "AtEndOfClass", "AtEndOfPackage", "AtEndPreamble"];

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
        self.scope(&token);
        if token.kind != Kind::Command {
            self.print(token);
            return Ok(Then::Next);
        }
        let frozen = match self.defined.alias(&token.text) {
            Some(meaning) => {
                token.text = meaning.into();
                true
            }
            None => false,
        };
        if token.is("end") && begins_group(&self.rest, "document") {
            return Ok(Then::End);
        }
        if self.units.waits() && self.defined.macro_of(&token.text).is_some_and(|m| !frozen && units::needs_braces(m)) {
            // The argument of a macro of LaTeX: all of what it prints.
            let brace = |kind, text: &str| Token { kind, text: text.into(), span: token.span.clone() };
            self.rest.push((brace(Kind::Close, "}"), depth));
            self.rest.push((token.clone(), depth));
            self.rest.push((brace(Kind::Open, "{"), depth));
            return Ok(Then::Next);
        }
        if self.ends(&token) || self.conditional(&token, depth) {
            return Ok(Then::Next);
        }
        if token.is("endinput") && self.defined.macro_of("endinput").is_none() {
            return Ok(self.end_of_input());
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
        if self.defined.is_global && matches!(token.text.as_str(), "long" | "outer" | "protected") {
            return Ok(Then::Next);
        }
        let is_global = self.defined.is_global;
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
        if define(&token.text, &mut self.rest, &mut self.defined) {
            // Nothing is printed.
            return Ok(Then::Next);
        }
        if token.is("end") && environment(&token, &self.rest, &self.defined).is_some() {
            let name = name_ahead(&self.rest);
            self.call_macro(token, depth, frozen, Some(name))?;
        } else if called(&token, &self.defined, &self.rest, frozen) {
            self.call_macro(token, depth, frozen, None)?;
        } else if DO_THEIR_ARGUMENT.contains(&token.text.as_str()) && takes_braces(&self.rest) {
            let body = argument(&mut self.rest);
            self.rest.extend(body.into_iter().rev().map(|t| (t, depth)));
        } else if PRINT_THEIR_ARGUMENT.contains(&token.text.as_str()) && takes_braces(&self.rest) {
            while optional(&mut self.rest).is_some() {}
        } else {
            self.print(token);
        }
        Ok(Then::Next)
    }

    /// Puts the body of a macro, or of the beginning or the end of an environment, in the place of its call; `ends` is the environment that ends.
    fn call_macro(&mut self, token: Token, depth: usize, frozen: bool, ends: Option<String>) -> Result<(), Endless> {
        self.calls += 1;
        let Expander { rest, out, defined, calls, outer, doubts, .. } = self;
        let room = MOST_TOKENS.saturating_sub(rest.len() + out.len());
        let too_many = depth >= DEEPEST || *calls > MOST_CALLS;
        if defined.is_doubted(&token.text) {
            doubts.note_meaning(&token);
        }
        let found = take_called(&token, rest, defined, frozen);
        let Some(body) = found.filter(|_| !too_many).and_then(|found| call(found, &token, rest, room)) else {
            let fault = at_fault(outer, depth, (*calls, out.len())).filter(|_| depth < DEEPEST);
            let name = fault.map_or_else(|| token.text.to_string(), str::to_owned);
            return Err(Endless { name, span: token.span });
        };
        outer.truncate(depth);
        outer.push(Outer { name: Some(token.text), calls: *calls, tokens: out.len() });
        if let Some(name) = ends {
            self.put_behind(&format!("{END_OF_ENVIRONMENT}{name}"), token.span, depth);
        }
        self.rest.extend(body.into_iter().rev().map(|t| (t, depth + 1)));
        Ok(())
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
            return true;
        }
        token.is(END_OF_FILE)
    }

    /// At `\\endinput`: drops what stands behind it in its file.
    fn end_of_input(&mut self) -> Then {
        // Whether that is done is not known; what stands behind is read as before.
        if self.defined.is_doubtful {
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

    /// Begins or ends what definitions stand in.
    fn scope(&mut self, token: &Token) {
        if self.definitions == Definitions::OfTheWhole {
            return;
        }
        let defined = &mut self.defined;
        match token.kind {
            Kind::Open => defined.begin(DefinitionScope::Braces),
            Kind::Close => defined.end(&DefinitionScope::Braces),
            // A formula of the running text ends with its paragraph.
            Kind::Space if token.text.contains('\n') && defined.innermost() == Some(&DefinitionScope::Formula("$")) => {
                defined.end(&DefinitionScope::Formula("$"));
            }
            Kind::Dollar => self.dollar(),
            Kind::Command => match token.text.as_str() {
                "begingroup" | "bgroup" => defined.begin(DefinitionScope::Group),
                "endgroup" | "egroup" => defined.end(&DefinitionScope::Group),
                "[" => defined.begin(DefinitionScope::Formula("[")),
                "(" => defined.begin(DefinitionScope::Formula("(")),
                "left" => defined.begin(DefinitionScope::Formula("left")),
                "right" => defined.end(&DefinitionScope::Formula("left")),
                "]" => defined.end(&DefinitionScope::Formula("[")),
                ")" => defined.end(&DefinitionScope::Formula("(")),
                "begin" | "end" => {
                    let name = name_ahead(&self.rest);
                    let is_own = defined.environments.contains_key(&name);
                    match token.is("begin") {
                        true if name != "document" => defined.begin(DefinitionScope::Environment(name)),
                        false if !is_own => defined.end(&DefinitionScope::Environment(name)),
                        _ => {}
                    }
                }
                _ => {}
            },
            _ => {}
        }
    }

    /// Begins or ends a formula at a dollar, or at the first of two.
    fn dollar(&mut self) {
        let is_doubled = self.rest.last().is_some_and(|(t, _)| t.kind == Kind::Dollar);
        let defined = &mut self.defined;
        match defined.innermost() {
            Some(DefinitionScope::Formula("$")) => defined.end(&DefinitionScope::Formula("$")),
            // The second of two ends nothing: it stands alone between the two that count.
            Some(DefinitionScope::Formula("$$")) if is_doubled => {
                defined.end(&DefinitionScope::Formula("$$"));
                defined.begin(DefinitionScope::Formula("second"));
            }
            Some(DefinitionScope::Formula("second")) => defined.end(&DefinitionScope::Formula("second")),
            Some(DefinitionScope::Formula("$$")) => {}
            _ if is_doubled => defined.begin(DefinitionScope::Formula("$$")),
            _ => defined.begin(DefinitionScope::Formula("$")),
        }
    }

    /// Puts out a token that is printed.
    fn print(&mut self, token: Token) {
        if self.defined.packages > 0 {
            return;
        }
        if let Some(doubt) = self.conditions.last().and_then(|c| c.doubt) {
            self.doubts.note(&token.span, doubt);
        }
        self.units.take(&token);
        self.out.push(token);
    }
}

/// The name in braces that comes next.
fn name_ahead(rest: &Rest) -> String {
    if rest.last().is_none_or(|(t, _)| t.kind != Kind::Open) {
        return String::new();
    }
    let inside = rest.iter().rev().skip(1).map(|(t, _)| t).take_while(|t| t.kind != Kind::Close).take(MOST_NAME);
    inside.map(|t| t.text.as_str()).collect()
}

/// Whether a token calls a macro of the document's own, or stands at the beginning or the end of its own environment.
fn called(token: &Token, defined: &Defined, rest: &Rest, frozen: bool) -> bool {
    environment(token, rest, defined).is_some() || !frozen && defined.macro_of(&token.text).is_some()
}

/// The macro that a token calls; the name of an environment is taken from what follows.
fn take_called<'d>(token: &Token, rest: &mut Rest, defined: &'d Defined, frozen: bool) -> Option<&'d Macro> {
    if let Some(found) = environment(token, rest, defined) {
        argument(rest);
        return Some(found);
    }
    let found = defined.macro_of(&token.text).filter(|_| !frozen)?;
    if defined.is_pair(&token.text) {
        next_is(rest, "*");
        optional(rest);
    }
    Some(found)
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

/// What stands at the beginning or at the end of an environment of the document's own.
fn environment<'d>(token: &Token, rest: &Rest, defined: &'d Defined) -> Option<&'d Macro> {
    if defined.environments.is_empty() || !(token.is("begin") || token.is("end")) {
        return None;
    }
    let (begin, end) = defined.environments.get(&name_ahead(rest))?;
    Some(if token.is("begin") { begin } else { end })
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

fn begins_group(rest: &Rest, name: &str) -> bool {
    let mut next = rest.iter().rev().map(|(t, _)| t);
    let open = next.next().is_some_and(|t| t.kind == Kind::Open);
    let inside: String = next.take_while(|t| t.kind != Kind::Close).take(40).map(|t| t.text.as_str()).collect();
    open && inside == name
}
