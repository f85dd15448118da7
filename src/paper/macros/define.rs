//! Definitions of macros, as LaTeX and TeX write them.
//!
//! **In:** the command that begins one, and what follows. **Out:** a macro, an environment, an alias, a condition. **Guaranteed:** of a package only
//! what prints is taken.

use std::collections::{BTreeMap, BTreeSet};

use super::super::token::{Kind, Token};
use super::rest::{MOST_ARGUMENTS, Macro, Rest, argument, defined_name, next_is, optional, spaces};

/// The definitions of a document.
#[derive(Default)]
pub(super) struct Defined {
    /// Names whose definitions are passed over.
    pub passed: BTreeSet<String>,
    pub macros: BTreeMap<String, Macro>,
    /// Names that `\let` gave to commands of LaTeX: they keep their meaning, whatever becomes of these.
    pub aliases: BTreeMap<String, String>,
    /// Environments: what stands at their beginning and at their end.
    pub environments: BTreeMap<String, (Macro, Macro)>,
    /// Conditions of `\newif`, `ifdraft`, and whether they hold.
    pub conditions: BTreeMap<String, bool>,
    /// Names of pairs of delimiters: a star, or a size in brackets, stands before the argument of some calls.
    pub paired: BTreeSet<String>,
    /// Packages that are being read: what they print is no text of the paper.
    pub packages: usize,
}

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

impl Defined {
    /// Whether a definition is taken: of a package only what prints, no commands for the document's frame, and nothing of how TeX is programmed.
    fn takes(&self, name: &str, body: &[Token]) -> bool {
        let programs = |t: &Token| {
            let command = t.text.as_str();
            t.kind == Kind::Command
                && (command.contains('@')
                    || PROGRAMS.contains(&command)
                    || command.starts_with("if") && command != "iff")
        };
        let switches = name.starts_with("if") && name.len() > 2 && name != "iff";
        self.packages == 0
            || !name.contains('@') && !OF_THE_FRAME.contains(&name) && (switches || !body.iter().any(programs))
    }

    /// Defines a macro.
    pub(super) fn put(&mut self, name: String, found: Macro) {
        if self.takes(&name, &found.body) {
            self.aliases.remove(&name);
            self.macros.insert(name, found);
        }
    }

    /// At `\drafttrue` or `\draftfalse`: the condition, and what it becomes.
    pub(super) fn switched(&self, command: &str) -> Option<(String, bool)> {
        let (name, value) = match command.strip_suffix("true") {
            Some(name) => (name, true),
            None => (command.strip_suffix("false")?, false),
        };
        let condition = format!("if{name}");
        self.conditions.contains_key(&condition).then_some((condition, value))
    }
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
            let fresh = |name: &String| command != "providecommand" || !defined.macros.contains_key(name);
            if let Some(name) = name.filter(fresh) {
                defined.put(name, Macro::plain(arguments, default, body));
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
                defined
                    .environments
                    .insert(name, (Macro::plain(arguments, default, begin), Macro::plain(0, None, end)));
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
            let body = argument(rest);
            let arguments = pattern.iter().filter(|t| t.kind == Kind::Argument).count();
            if arguments == pattern.len() {
                pattern.clear();
            }
            if arguments <= MOST_ARGUMENTS {
                defined.put(name.text.into(), Macro { arguments, default: None, body, pattern, options: Vec::new() });
            }
        }
        "let" => {
            let Some(name) = rest.pop().map(|(t, _)| t).filter(|t| t.kind == Kind::Command) else { return true };
            next_is(rest, "=");
            let Some((meaning, _)) = rest.pop() else { return true };
            let known = defined.macros.get(meaning.text.as_str()).filter(|_| meaning.kind == Kind::Command).cloned();
            match known {
                Some(known) => {
                    defined.put(name.text.into(), known);
                }
                None if meaning.kind == Kind::Command => {
                    let meaning =
                        defined.aliases.get(meaning.text.as_str()).cloned().unwrap_or_else(|| meaning.text.into());
                    if defined.takes(&name.text, &[]) {
                        defined.aliases.insert(name.text.into(), meaning);
                    }
                }
                None => {
                    defined.put(name.text.into(), Macro::plain(0, None, vec![meaning]));
                }
            }
        }
        "newif" => {
            let name = rest.pop().map(|(t, _)| t).filter(|t| t.kind == Kind::Command);
            if let Some(name) = name.filter(|n| defined.takes(&n.text, &[])) {
                defined.conditions.insert(name.text.into(), false);
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
            if let Some((name, found)) = name.zip(document_macro(kinds, body)) {
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
                defined.paired.insert(name.clone());
                defined.put(name, Macro::plain(1, None, body));
            }
        }
        _ => return false,
    }
    true
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
    is_known.then(|| Macro { options, ..Macro::plain(arguments, default, body) })
}
