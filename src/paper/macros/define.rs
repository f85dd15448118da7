//! Definitions of macros, as LaTeX and TeX write them.
//!
//! **In:** the command that begins one, and what follows. **Out:** a macro, an environment, an alias, a condition. **Guaranteed:** of a package only
//! what prints is taken.

use super::super::token::{Kind, Token};
use super::call::call;
use super::defined::{CommandMeaning, Defined};
use super::rest::{MOST_ARGUMENTS, Macro, Rest, argument, defined_name, next_is, optional, spaces};

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

/// Reads a definition, if `command` begins one.
pub(super) fn define(command: &str, rest: &mut Rest, defined: &mut Defined) -> bool {
    match command {
        "newcommand" | "renewcommand" | "providecommand" | "DeclareRobustCommand" => {
            next_is(rest, "*");
            let name = defined_name(rest);
            let count: String = optional(rest).unwrap_or_default().iter().map(|t| t.text.as_str()).collect();
            let default = optional(rest);
            let body = argument(rest);
            let arguments = count.trim().parse().map_or(0, |n: usize| n.min(MOST_ARGUMENTS));
            let fresh = |name: &String| command != "providecommand" || !defined.has(name);
            if let Some(name) = name.filter(fresh) {
                let is_robust = command == "DeclareRobustCommand";
                defined.put(name, Macro { is_robust, ..Macro::plain(arguments, default, body) });
            }
        }
        "newenvironment" | "renewenvironment" => {
            next_is(rest, "*");
            let name: String = argument(rest).iter().map(|t| t.text.as_str()).collect();
            let count: String = optional(rest).unwrap_or_default().iter().map(|t| t.text.as_str()).collect();
            let default = optional(rest);
            let (begin, end) = (argument(rest), argument(rest));
            let arguments = count.trim().parse().map_or(0, |n: usize| n.min(MOST_ARGUMENTS));
            if defined.takes(&name, &begin) && defined.takes(&name, &end) {
                defined.put_environment(name, (Macro::plain(arguments, default, begin), Macro::plain(0, None, end)));
            }
        }
        "def" | "gdef" | "edef" | "xdef" => {
            let Some(name) = rest.pop().map(|(t, _)| t).filter(|t| t.kind == Kind::Command) else { return true };
            let mut pattern = Vec::new();
            while let Some((t, _)) = rest.last().filter(|(t, _)| t.kind != Kind::Open) {
                if t.kind != Kind::Space {
                    pattern.push(t.clone());
                }
                rest.pop();
            }
            let mut body = argument(rest);
            let is_open = matches!(command, "edef" | "xdef") && {
                let now = expanded_now(&body, defined);
                let is_open = now.is_none();
                body = now.unwrap_or(body);
                is_open
            };
            defined.is_global |= matches!(command, "gdef" | "xdef");
            let arguments = pattern.iter().filter(|t| t.kind == Kind::Argument).count();
            if arguments == pattern.len() {
                pattern.clear();
            }
            if arguments <= MOST_ARGUMENTS {
                let found = Macro { arguments, default: None, body, pattern, options: Vec::new(), is_robust: false };
                let name = String::from(name.text);
                defined.put(name.clone(), found);
                if is_open {
                    defined.doubt(&name);
                }
            }
        }
        "let" => {
            let Some(name) = rest.pop().map(|(t, _)| t).filter(|t| t.kind == Kind::Command) else { return true };
            if next_is(rest, "=") {
                // One space behind the sign belongs to it.
                spaces(rest);
            }
            let Some((meaning, _)) = rest.pop() else { return true };
            defined.let_be(name.text.into(), meaning);
        }
        "newif" => {
            let name = rest.pop().map(|(t, _)| t).filter(|t| t.kind == Kind::Command);
            if let Some(name) = name.filter(|n| defined.takes(&n.text, &[])) {
                defined.assign(name.text.into(), CommandMeaning::Condition(Some(false)));
            }
        }
        "DeclareMathOperator" => {
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
        "NewDocumentCommand" | "RenewDocumentCommand" | "DeclareDocumentCommand" | "ProvideDocumentCommand" => {
            let name = defined_name(rest);
            let kinds = argument(rest);
            let body = argument(rest);
            let fresh = |name: &String| command != "ProvideDocumentCommand" || !defined.has(name);
            if let Some((name, found)) = name.filter(fresh).zip(document_macro(kinds, body)) {
                defined.put(name, found);
            }
        }
        "DeclarePairedDelimiter" => {
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
        "setboolean" => {
            let text = |tokens: Vec<Token>| tokens.iter().map(|t| t.text.as_str()).collect::<String>();
            let (name, value) = (text(argument(rest)), text(argument(rest)));
            let value = match value.trim() {
                "true" => Some(true),
                "false" => Some(false),
                _ => None,
            };
            defined.assign(format!("if{}", name.trim()), CommandMeaning::Condition(value));
        }
        _ => return false,
    }
    defined.is_global = false;
    true
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

/// A macro of `\NewDocumentCommand`, from what its second argument asks for: arguments, of which the first may have a default, and options
/// behind them; `None` where it asks for what is not understood.
fn document_macro(kinds: Vec<Token>, body: Vec<Token>) -> Option<Macro> {
    let mut rest: Rest = kinds.into_iter().rev().map(|t| (t, 0)).collect();
    let default = next_is(&mut rest, "O").then(|| argument(&mut rest));
    let mut arguments = usize::from(default.is_some());
    while next_is(&mut rest, "m") {
        arguments += 1;
    }
    let mut options = Vec::new();
    while next_is(&mut rest, "O") {
        options.push(argument(&mut rest));
    }
    spaces(&mut rest);
    let is_known = rest.is_empty() && arguments + options.len() <= MOST_ARGUMENTS;
    is_known.then(|| Macro { options, is_robust: true, ..Macro::plain(arguments, default, body) })
}
