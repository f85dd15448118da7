//! Definitions of macros, as LaTeX and TeX write them.
//!
//! **In:** the command that begins one, and what follows. **Out:** a macro, an environment, an alias, a condition. **Guaranteed:** of a package only
//! what prints is taken.

use super::super::token::{Kind, Token};
use super::call::call;
use super::defined::{CommandMeaning, Defined};
use super::rest::{MOST_ARGUMENTS, MOST_NAME, Macro, Rest, argument, defined_name, next_is, optional, spaces};

/// Commands of the frame of a document, which a package changes in looks alone.
const OF_THE_FRAME: &[&str] = &[
    "author",
    "begin",
    "bibitem",
    "bibliography",
    "caption",
    "chapter",
    "cite",
    "date",
    "documentclass",
    "end",
    "eqref",
    "footnote",
    "include",
    "includegraphics",
    "index",
    "input",
    "item",
    "label",
    "maketitle",
    "paragraph",
    "part",
    "ref",
    "section",
    "subsection",
    "subsubsection",
    "tableofcontents",
    "tag",
    "thanks",
    "title",
    "usepackage",
];

/// Commands with which macros are programmed.
const PROGRAMS: &[&str] = &[
    "advance",
    "begingroup",
    "bgroup",
    "box",
    "catcode",
    "csname",
    "def",
    "edef",
    "egroup",
    "else",
    "endgroup",
    "expandafter",
    "fi",
    "futurelet",
    "gdef",
    "global",
    "let",
    "loop",
    "newcommand",
    "noexpand",
    "or",
    "relax",
    "renewcommand",
    "repeat",
    "setbox",
    "setcounter",
    "setlength",
    "the",
    "xdef",
];

/// Commands with which `\\edef` is told what to expand, or that give other tokens.
const UNEXPANDED: &[&str] = &[
    "csname",
    "detokenize",
    "expandafter",
    "jobname",
    "meaning",
    "noexpand",
    "number",
    "protect",
    "romannumeral",
    "string",
    "the",
    "unexpanded",
];

/// The most tokens of a body of `\\edef`.
const MOST_TOKENS_NOW: usize = 100_000;

/// Whether a definition of a package is taken: only what prints, no commands for the document's frame, and nothing of how TeX is programmed.
pub(super) fn is_taken_of_package(name: &str, body: &[Token]) -> bool {
    let programs = |t: &Token| {
        let command = t.text.as_str();
        t.kind == Kind::Command
            && (command.contains('@') || PROGRAMS.contains(&command) || command.starts_with("if") && command != "iff")
    };
    let switches = name.starts_with("if") && name.len() > 2 && name != "iff";
    !name.contains('@') && !OF_THE_FRAME.contains(&name) && (switches || !body.iter().any(programs))
}

/// How a command defines.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Definer {
    /// `\newcommand{\x}[2][a]{…}`
    Command,
    /// `\newenvironment{x}[2][a]{…}{…}`
    Environment,
    /// `\def\x#1{…}`
    Plain,
    /// `\@namedef{x}#1{…}`
    Named,
    /// `\let\x=\y`
    Let,
    /// `\letcs\x{y}`, `\NewCommandCopy{\x}{\y}`: names in braces or not.
    Copy,
    /// `\newif\ifx`
    If,
    /// `\newbool{x}`
    Bool,
    /// `\DeclareMathOperator{\x}{…}`
    Operator,
    /// `\NewDocumentCommand{\x}{m O{a}}{…}`
    Document,
    /// `\NewDocumentEnvironment{x}{m}{…}{…}`
    DocumentEnvironment,
    /// `\DeclarePairedDelimiter{\x}{…}{…}`
    Pair,
    /// `\setbool{x}{true}`
    SetBool,
    /// `\booltrue{x}`
    BoolIs(bool),
}

/// Commands that define, and how.
const DEFINERS: &[(&str, Definer)] = &[
    ("newcommand", Definer::Command),
    ("renewcommand", Definer::Command),
    ("providecommand", Definer::Command),
    ("DeclareRobustCommand", Definer::Command),
    ("newrobustcmd", Definer::Command),
    ("renewrobustcmd", Definer::Command),
    ("providerobustcmd", Definer::Command),
    ("newenvironment", Definer::Environment),
    ("renewenvironment", Definer::Environment),
    ("def", Definer::Plain),
    ("gdef", Definer::Plain),
    ("edef", Definer::Plain),
    ("xdef", Definer::Plain),
    ("protected@edef", Definer::Plain),
    ("protected@xdef", Definer::Plain),
    ("@namedef", Definer::Named),
    ("csdef", Definer::Named),
    ("csgdef", Definer::Named),
    ("csedef", Definer::Named),
    ("csxdef", Definer::Named),
    ("let", Definer::Let),
    ("letcs", Definer::Copy),
    ("cslet", Definer::Copy),
    ("csletcs", Definer::Copy),
    ("LetLtxMacro", Definer::Copy),
    ("NewCommandCopy", Definer::Copy),
    ("RenewCommandCopy", Definer::Copy),
    ("DeclareCommandCopy", Definer::Copy),
    ("newif", Definer::If),
    ("newbool", Definer::Bool),
    ("providebool", Definer::Bool),
    ("newboolean", Definer::Bool),
    ("provideboolean", Definer::Bool),
    ("DeclareMathOperator", Definer::Operator),
    ("NewDocumentCommand", Definer::Document),
    ("RenewDocumentCommand", Definer::Document),
    ("DeclareDocumentCommand", Definer::Document),
    ("ProvideDocumentCommand", Definer::Document),
    ("NewExpandableDocumentCommand", Definer::Document),
    ("RenewExpandableDocumentCommand", Definer::Document),
    ("DeclareExpandableDocumentCommand", Definer::Document),
    ("ProvideExpandableDocumentCommand", Definer::Document),
    ("NewDocumentEnvironment", Definer::DocumentEnvironment),
    ("RenewDocumentEnvironment", Definer::DocumentEnvironment),
    ("DeclareDocumentEnvironment", Definer::DocumentEnvironment),
    ("ProvideDocumentEnvironment", Definer::DocumentEnvironment),
    ("DeclarePairedDelimiter", Definer::Pair),
    ("setboolean", Definer::SetBool),
    ("setbool", Definer::SetBool),
    ("booltrue", Definer::BoolIs(true)),
    ("boolfalse", Definer::BoolIs(false)),
];

/// Reads a definition, if `command` begins one.
pub(super) fn define(command: &str, rest: &mut Rest, defined: &mut Defined) -> bool {
    let Some((_, how)) = DEFINERS.iter().find(|(name, _)| *name == command) else { return false };
    match how {
        Definer::Command => new_command(command, rest, defined),
        Definer::Environment => new_environment(rest, defined),
        Definer::Plain => {
            if let Some(name) = taken_name(rest) {
                plain(command, name, rest, defined);
            }
        }
        Definer::Named => {
            if let Some(name) = written_name(rest, defined) {
                plain(command, name, rest, defined);
            }
        }
        Definer::Let => {
            let Some(name) = taken_name(rest) else { return true };
            if next_is(rest, "=") {
                // One space behind the sign belongs to it.
                spaces(rest);
            }
            let Some((meaning, _)) = rest.pop() else { return true };
            defined.let_be(name, meaning);
        }
        Definer::Copy => {
            if let Some((name, of)) = written_name(rest, defined).zip(written_name(rest, defined)) {
                defined.let_be(name, Token { kind: Kind::Command, text: of.into(), span: 0..0 });
            }
        }
        Definer::If => {
            if let Some(name) = taken_name(rest) {
                new_condition(name, defined);
            }
        }
        Definer::Bool => {
            if let Some(name) = written_name(rest, defined) {
                new_condition(format!("if{name}"), defined);
            }
        }
        Definer::Operator => operator(rest, defined),
        Definer::Document => {
            let name = defined_name(rest);
            let kinds = argument(rest);
            let body = argument(rest);
            let fresh = |name: &String| !command.starts_with("Provide") || !defined.has(name);
            match name.filter(fresh).map(|name| (name, document_macro(kinds, body))) {
                Some((name, Some(found))) => defined.put(name, found),
                Some((name, None)) => defined.not_read(name),
                None => {}
            }
        }
        Definer::DocumentEnvironment => {
            let name = written_name(rest, defined);
            let kinds = argument(rest);
            let (found, end) = document_environment(kinds, argument(rest), argument(rest));
            if let Some(name) = name.filter(|name| !command.starts_with("Provide") || !defined.has(name)) {
                put_environment(name, found, end, defined);
            }
        }
        Definer::Pair => pair(rest, defined),
        Definer::SetBool => {
            let (name, value) = (written_name(rest, defined), text(&argument(rest)));
            let value = match value.trim() {
                "true" => Some(true),
                "false" => Some(false),
                _ => None,
            };
            set_condition(name, value, defined);
        }
        Definer::BoolIs(value) => set_condition(written_name(rest, defined), Some(*value), defined),
    }
    defined.is_global = false;
    true
}

/// The command that comes next.
fn taken_name(rest: &mut Rest) -> Option<String> {
    rest.pop().map(|(t, _)| t).filter(|t| t.kind == Kind::Command).map(|t| t.text.into())
}

fn text(tokens: &[Token]) -> String {
    tokens.iter().map(|t| t.text.as_str()).collect()
}

/// A name that is written out, in braces or as a command.
fn written_name(rest: &mut Rest, defined: &Defined) -> Option<String> {
    let found = argument(rest);
    match found.as_slice() {
        [one] if one.kind == Kind::Command => Some(one.text.to_string()),
        _ => name_of(&found, defined),
    }
}

/// The name that tokens write, their macros expanded, if it is one.
pub(super) fn name_of(tokens: &[Token], defined: &Defined) -> Option<String> {
    let found = expanded_now(tokens, defined)?;
    let is_name = found.len() <= MOST_NAME && found.iter().all(|t| matches!(t.kind, Kind::Other | Kind::Space));
    is_name.then(|| text(&found).trim().to_owned()).filter(|name| !name.is_empty())
}

/// The number of arguments and the default of the first, as `[2][a]`.
fn counted(rest: &mut Rest) -> (usize, Option<Vec<Token>>) {
    let count = text(&optional(rest).unwrap_or_default());
    (count.trim().parse().map_or(0, |n: usize| n.min(MOST_ARGUMENTS)), optional(rest))
}

fn new_command(command: &str, rest: &mut Rest, defined: &mut Defined) {
    next_is(rest, "*");
    let name = defined_name(rest);
    let (arguments, default) = counted(rest);
    let body = argument(rest);
    let fresh = |name: &String| !command.starts_with("provide") || !defined.has(name);
    if let Some(name) = name.filter(fresh) {
        let is_robust = command == "DeclareRobustCommand" || command.ends_with("robustcmd");
        defined.put(name, Macro { is_robust, ..Macro::plain(arguments, default, body) });
    }
}

fn new_environment(rest: &mut Rest, defined: &mut Defined) {
    next_is(rest, "*");
    let name = written_name(rest, defined);
    let (arguments, default) = counted(rest);
    let (begin, end) = (argument(rest), argument(rest));
    if let Some(name) = name {
        put_environment(name, Some(Macro::plain(arguments, default, begin)), end, defined);
    }
}

/// Defines an environment; without a beginning it is not understood.
fn put_environment(name: String, begin: Option<Macro>, end: Vec<Token>, defined: &mut Defined) {
    let is_taken = |m: &Macro| defined.takes(&name, &m.body) && defined.takes(&name, &end);
    let ends = format!("end{name}");
    match begin.as_ref().is_none_or(is_taken).then_some(begin) {
        Some(Some(begin)) => {
            let is_global = defined.is_global;
            defined.put(name, begin);
            defined.is_global = is_global;
            defined.put(ends, Macro::plain(0, None, end));
        }
        Some(None) => {
            defined.not_read(name);
            defined.put(ends, Macro::plain(0, None, Vec::new()));
        }
        None => {}
    }
}

/// Reads what stands behind the name of a definition of TeX.
fn plain(command: &str, name: String, rest: &mut Rest, defined: &mut Defined) {
    let mut pattern = Vec::new();
    while let Some((t, _)) = rest.last().filter(|(t, _)| t.kind != Kind::Open) {
        if t.kind != Kind::Space {
            pattern.push(t.clone());
        }
        rest.pop();
    }
    let mut body = argument(rest);
    let is_now = command.ends_with("edef") || command.ends_with("xdef");
    let is_open = is_now && {
        let now = expanded_now(&body, defined);
        let is_open = now.is_none();
        body = now.unwrap_or(body);
        is_open
    };
    // `\def\x#1#{q}`: a brace ends what is taken, and stays.
    if pattern.last().is_some_and(|t| t.is_char("#"))
        && let Some(sign) = pattern.pop()
    {
        let brace = Token { kind: Kind::Open, text: "{".into(), span: sign.span };
        pattern.push(brace.clone());
        body.push(brace);
    }
    defined.is_global |= matches!(command, "gdef" | "xdef" | "protected@xdef" | "csgdef" | "csxdef");
    let arguments = pattern.iter().filter(|t| t.kind == Kind::Argument).count();
    if arguments == pattern.len() {
        pattern.clear();
    }
    if arguments <= MOST_ARGUMENTS {
        let found = Macro { pattern, ..Macro::plain(arguments, None, body) };
        defined.put(name.clone(), found);
        if is_open {
            defined.doubt(&name);
        }
    }
}

fn new_condition(name: String, defined: &mut Defined) {
    if defined.takes(&name, &[]) {
        defined.assign(name, CommandMeaning::Condition(Some(false)));
    }
}

fn set_condition(name: Option<String>, value: Option<bool>, defined: &mut Defined) {
    if let Some(name) = name {
        defined.assign(format!("if{name}"), CommandMeaning::Condition(value));
    }
}

fn operator(rest: &mut Rest, defined: &mut Defined) {
    next_is(rest, "*");
    let name = defined_name(rest);
    let body = argument(rest);
    let brace = |kind, text: &str| Token { kind, text: text.into(), span: 0..0 };
    let mut all = vec![brace(Kind::Command, "operatorname"), brace(Kind::Open, "{")];
    all.extend(body);
    all.push(brace(Kind::Close, "}"));
    if let Some(name) = name {
        defined.put(name, Macro::plain(0, None, all));
    }
}

fn pair(rest: &mut Rest, defined: &mut Defined) {
    let name = defined_name(rest);
    let (left, right) = (argument(rest), argument(rest));
    let piece = |kind, text: &str| Token { kind, text: text.into(), span: 0..0 };
    let mut body = vec![piece(Kind::Command, "left")];
    body.extend(left);
    body.push(piece(Kind::Argument, "1"));
    body.push(piece(Kind::Command, "right"));
    body.extend(right);
    if let Some(name) = name {
        defined.put_pair(name, Macro::plain(1, None, body));
    }
}

/// The most calls of macros within one `\\edef`.
const MOST_CALLS_NOW: usize = 10_000;

/// What `\\edef` makes of a body: its macros as they are now. `None` where that is programmed.
fn expanded_now(body: &[Token], defined: &Defined) -> Option<Vec<Token>> {
    let mut rest: Rest = body.iter().rev().map(|t| (t.clone(), 0)).collect();
    let (mut out, mut calls) = (Vec::new(), 0);
    while let Some((token, _)) = rest.pop() {
        let command = token.text.as_str();
        if token.kind != Kind::Command {
            out.push(token);
        } else if UNEXPANDED.contains(&command) || command.starts_with("if") && command != "iff" {
            return None;
        } else if let Some(found) = defined.macro_of(command).filter(|m| !m.is_robust) {
            calls += 1;
            if calls > MOST_CALLS_NOW || defined.is_doubted(command) {
                return None;
            }
            let room = MOST_TOKENS_NOW.checked_sub(rest.len() + out.len())?;
            let more = call(found, &token, &mut rest, room)?;
            rest.extend(more.into_iter().rev().map(|t| (t, 0)));
        } else {
            out.push(token);
        }
    }
    Some(out)
}

/// What stands at the beginning and at the end of an environment of `\NewDocumentEnvironment`; its content may be its last argument.
fn document_environment(
    mut kinds: Vec<Token>,
    mut begin: Vec<Token>,
    mut end: Vec<Token>,
) -> (Option<Macro>, Vec<Token>) {
    kinds.retain(|t| t.kind != Kind::Space);
    let takes_content = kinds.pop_if(|t| t.is_char("b")).is_some();
    if takes_content {
        while kinds.pop_if(|t| t.is_char("+") || t.is_char("!")).is_some() {}
    }
    let Some(found) = document_macro(kinds, Vec::new()) else { return (None, Vec::new()) };
    if takes_content {
        let nth = (found.arguments + found.options.len() + 1).to_string();
        let is_content = |t: &Token| t.kind == Kind::Argument && t.text == nth.as_str();
        let Some(at) = begin.iter().position(is_content) else { return (None, Vec::new()) };
        let behind = begin.split_off(at);
        end.splice(0..0, behind.into_iter().skip(1));
    }
    // Arguments are there at the end, too, and the content may be printed twice.
    let is_plain = !end.iter().any(|t| t.kind == Kind::Argument);
    (is_plain.then_some(Macro { body: begin, ..found }), end)
}

/// A macro of `\NewDocumentCommand`, from what its second argument asks for: arguments, of which the first may have a default, and options
/// behind them; `None` where it asks for what is not understood.
fn document_macro(mut kinds: Vec<Token>, body: Vec<Token>) -> Option<Macro> {
    // Whether an argument may have paragraphs, or spaces before it, is no matter of what it prints.
    kinds.retain(|t| !t.is_char("+") && !t.is_char("!"));
    let mut rest: Rest = kinds.into_iter().rev().map(|t| (t, 0)).collect();
    let has_star = next_is(&mut rest, "s");
    let default = option(&mut rest);
    let mut arguments = usize::from(has_star) + usize::from(default.is_some());
    while next_is(&mut rest, "m") {
        arguments += 1;
    }
    let mut options = Vec::new();
    while let Some(default) = option(&mut rest) {
        options.push(default);
    }
    spaces(&mut rest);
    let is_known = rest.is_empty() && arguments + options.len() <= MOST_ARGUMENTS;
    is_known.then(|| Macro { options, has_star, is_robust: true, ..Macro::plain(arguments, default, body) })
}

/// The default of an option, as `O{a}` or `o`, which has none.
fn option(kinds: &mut Rest) -> Option<Vec<Token>> {
    if next_is(kinds, "o") {
        return Some(vec![Token { kind: Kind::Command, text: "NoValue".into(), span: 0..0 }]);
    }
    next_is(kinds, "O").then(|| argument(kinds))
}
