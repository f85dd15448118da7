//! Macros of a paper, expanded: what is left is what LaTeX would print.
//!
//! **In:** the tokens of a document. **Out:** those that it prints; where there are more than can be read, the first of them, and where reading
//! ended. **Guaranteed:** a macro that takes most of what a paper may have is named, the outermost one; without it the rest can be read.
//!
//! A token that comes out of a macro has the place of the call, so that a difference points at what the author wrote.

mod call;
mod cut;
mod define;
mod rest;

use std::collections::BTreeSet;
use std::ops::Range;

use call::call;
use define::{Defined, define};
use rest::{MOST_NAME, Macro, Rest, argument, next_is, optional, spaces, takes_braces};

use super::named::{COMMANDS_OF_TEXT, Input, Named, PACKAGES};
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

/// The command that stands behind the text of a package while it is read; no text has it.
const END_OF_DEFINITIONS: &str = "";

/// Commands of classes for exercises, and of layout, that print their argument as it is; options before it are not printed.
const PRINT_THEIR_ARGUMENT: &[&str] = &["answer", "eqmathbox"];

/// The tokens of a document with its own macros expanded; definitions leave no token, and those of the names in `passed` no meaning. `preamble` is that of
/// the main file of a chapter: only its definitions count. `input` gives the tokens of a file that the document names, if it may be read.
pub(super) fn expanded(
    mut document: Vec<Token>,
    preamble: Vec<Token>,
    passed: &BTreeSet<String>,
    input: &mut Input<'_>,
) -> Result<Expanded, Endless> {
    let mut cut = document.get(MOST_TOKENS).map(|t| t.span.clone());
    document.truncate(MOST_TOKENS);
    let mut defined = Defined { passed: passed.clone(), ..Defined::default() };
    // A stack of what is still to be read, the next token last; the depth of macros it came from beside it.
    let mut rest: Vec<(Token, usize)> = document.into_iter().rev().map(|t| (t, 0)).collect();
    let mut out: Vec<Token> = Vec::with_capacity(rest.len());
    // Macros that leave nothing can call each other more often than any paper has tokens.
    let mut calls = 0;
    let mut outer: Vec<Outer> = Vec::new();
    if !preamble.is_empty() {
        defined.packages = 1;
        rest.push((Token { kind: Kind::Command, text: END_OF_DEFINITIONS.into(), span: 0..0 }, 0));
        rest.extend(preamble.into_iter().rev().map(|t| (t, 0)));
    }
    // Conditions of the document's own that hold and are not yet closed.
    let mut open_conditions = 0;
    while let Some((mut token, depth)) = rest.pop() {
        if out.len() >= MOST_TOKENS {
            if let Some(name) = at_fault(&outer, depth, (calls, out.len())) {
                return Err(Endless { name: name.to_owned(), span: token.span });
            }
            cut = Some(token.span);
            break;
        }
        let frozen = token.kind == Kind::Command && defined.aliases.contains_key(token.text.as_str());
        if frozen && let Some(meaning) = defined.aliases.get(token.text.as_str()) {
            token.text = meaning.as_str().into();
        }
        if token.kind != Kind::Command {
            if defined.packages == 0 {
                out.push(token);
            }
        } else if token.is("end") && begins_group(&rest, "document") {
            cut = None;
            break;
        } else if token.is("iffalse") || defined.conditions.get(token.text.as_str()) == Some(&false) {
            skip_branch(&mut rest);
        } else if defined.conditions.get(token.text.as_str()) == Some(&true) {
            open_conditions += 1;
        } else if open_conditions > 0 && token.is("fi") {
            open_conditions -= 1;
        } else if open_conditions > 0 && token.is("else") {
            open_conditions -= 1;
            skip_branch(&mut rest);
        } else if let Some(value) = defined.switched(&token.text) {
            defined.conditions.insert(value.0, value.1);
        } else if token.is(END_OF_DEFINITIONS) {
            defined.packages = defined.packages.saturating_sub(1);
        } else if let Some(named) = named_by(&token, &defined, frozen) {
            calls += 1;
            if calls > MOST_CALLS || depth >= DEEPEST {
                return Err(Endless { name: token.text.into(), span: token.span });
            }
            let file = files_named(named, &token, &mut rest, input);
            if file.len() + rest.len() + out.len() > MOST_TOKENS {
                cut = Some(token.span);
                break;
            }
            if named != Named::Text && !file.is_empty() {
                defined.packages += 1;
                let end = Token { kind: Kind::Command, text: END_OF_DEFINITIONS.into(), span: token.span };
                rest.push((end, depth));
            }
            outer.truncate(depth);
            outer.push(Outer { name: None, calls, tokens: out.len() });
            rest.extend(file.into_iter().rev().map(|t| (t, depth + 1)));
        } else if define(&token.text, &mut rest, &mut defined) {
            // Nothing is printed.
            let Defined { passed, macros, .. } = &mut defined;
            passed.iter().for_each(|name| drop(macros.remove(name)));
        } else if let Some(found) = called(&token, &mut rest, &defined, frozen) {
            calls += 1;
            let room = MOST_TOKENS.saturating_sub(rest.len() + out.len());
            let too_many = depth >= DEEPEST || calls > MOST_CALLS;
            let Some(body) = (!too_many).then(|| call(found, &token, &mut rest, room)).flatten() else {
                let fault = at_fault(&outer, depth, (calls, out.len())).filter(|_| depth < DEEPEST);
                let name = fault.map_or_else(|| token.text.to_string(), str::to_owned);
                return Err(Endless { name, span: token.span });
            };
            outer.truncate(depth);
            outer.push(Outer { name: Some(token.text), calls, tokens: out.len() });
            rest.extend(body.into_iter().rev().map(|t| (t, depth + 1)));
        } else if PRINT_THEIR_ARGUMENT.contains(&token.text.as_str()) && takes_braces(&rest) {
            while optional(&mut rest).is_some() {}
        } else if defined.packages == 0 {
            out.push(token);
        }
    }
    if cut.is_some() {
        let end = cut::end_of_whole(&out);
        cut = out.get(end).map(|t| t.span.clone()).or(cut);
        out.truncate(end);
    }
    Ok(Expanded { tokens: out, cut })
}

/// The macro of the document's own that a token calls, or the beginning or the end of its own environment; the name of that is taken from what follows.
fn called<'d>(token: &Token, rest: &mut Rest, defined: &'d Defined, frozen: bool) -> Option<&'d Macro> {
    if let Some(found) = environment(token, rest, defined) {
        argument(rest);
        return Some(found);
    }
    let found = defined.macros.get(token.text.as_str()).filter(|_| !frozen)?;
    if defined.paired.contains(token.text.as_str()) {
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
    (frozen || !defined.macros.contains_key(token.text.as_str())).then_some(named)
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
    let open = rest.last().is_some_and(|(t, _)| t.kind == Kind::Open);
    let inside = rest.iter().rev().skip(1).map(|(t, _)| t).take_while(|t| t.kind != Kind::Close).take(MOST_NAME);
    let name: String = inside.map(|t| t.text.as_str()).collect();
    let (begin, end) = defined.environments.get(&name).filter(|_| open)?;
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

/// Drops everything up to the `\fi` or `\else` of an `\iffalse`.
fn skip_branch(rest: &mut Rest) {
    let mut depth = 0;
    while let Some((token, _)) = rest.pop() {
        if token.kind != Kind::Command {
            continue;
        }
        match token.text.as_str() {
            "fi" | "else" if depth == 0 => return,
            "fi" => depth -= 1,
            name if name.starts_with("if") && name != "iff" => depth += 1,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    fn expanded(text: &str) -> Result<Vec<Token>, Endless> {
        super::expanded(tokens(text), Vec::new(), &BTreeSet::new(), &mut |_, _, _| Vec::new()).map(|e| e.tokens)
    }

    fn shown(text: &str) -> String {
        let all = expanded(text).unwrap_or_else(|e| panic!("{e:?}"));
        let one = |t: &Token| if t.kind == Kind::Command { format!("\\{} ", t.text) } else { t.text.to_string() };
        all.iter().map(one).collect::<String>().trim().to_owned()
    }

    #[test]
    fn macros_are_expanded_as_latex_does() {
        assert_eq!(shown(r"\newcommand{\w}{\boldsymbol\Omega}\w x"), r"\boldsymbol \Omega x");
        assert_eq!(shown(r"\newcommand\d[2][t]{\frac{d#2}{d#1}}\d x\d[s]{y}"), r"\frac {dx}{dt}\frac {dy}{ds}");
        assert_eq!(shown(r"\def\a#1{<#1>}\def\b{\a}\b{x}"), "<x>");
        assert_eq!(shown(r"\DeclareMathOperator{\tr}{tr}\tr A"), r"\operatorname {tr}A");
        assert_eq!(shown(r"\let\eps=\epsilon\eps"), r"\epsilon");
        assert_eq!(shown(r"\providecommand{\x}{1}\renewcommand*{\x}{2}\providecommand{\x}{3}\x"), "2");
        assert_eq!(shown(r"\newcommand{\x}{1}\iffalse\newcommand{\x}{2}\ifx a\fi\fi\x"), "1");
        assert_eq!(shown(r"a\end{document}b"), "a");
        // A name that is let is what it was.
        assert_eq!(shown(r"\let\s\section\renewcommand\section[1]{(\s{#1})}\section{a}"), r"(\section {a})");
        assert_eq!(shown(r"\let\nc\newcommand\nc{\x}{1}\x"), "1");
        assert_eq!(
            shown(r"\newenvironment{e}{\begin{equation}}{\end{equation}}\begin{e}x\end{e}"),
            r"\begin {equation}x\end {equation}"
        );
        assert_eq!(shown(r"\NewDocumentCommand{\v}{m}{\vec{#1}}\v{x}"), r"\vec {x}");
        assert_eq!(shown(r"\NewDocumentCommand{\v}{O{2} m}{#2^{#1}}\v{x}\v[3]y"), "x^{2}y^{3}");
        assert_eq!(shown(r"\NewDocumentCommand{\r}{mmO{l}}{#2_#3}\r{x}{y}\r{x}{z}[c]"), "y_lz_c");
        // Arguments with signs between them, as TeX takes them.
        assert_eq!(shown(r"\def\at(#1,#2)#3{#3_#1^#2}\at(a,{(b)})x \at (c,{d,e})y"), "x_a^(b) y_c^d,e");
        assert_eq!(shown(r"\def\to#1\by#2.{#1/#2}\to{a}b\by c.d"), "{a}b/cd");
        assert_eq!(shown(r"\DeclarePairedDelimiter\n{\lVert}{\rVert}\n{x}\n*{y}\n[\big]z").matches("left").count(), 3);
    }

    #[test]
    fn what_prints_its_argument_is_that() {
        assert_eq!(shown(r"x=\answer[given]{a+b}"), "x={a+b}");
        assert_eq!(shown(r"x=\answer{a+b} y"), "x={a+b} y");
        assert_eq!(shown(r"\answer [tolerance=.1] {2}"), " {2}".trim());
        // Without braces it is another one, and the paper's own is what it says.
        assert_eq!(shown(r"\answer $x$"), r"\answer $x$");
        assert_eq!(shown(r"\newcommand\answer[1]{<#1>}\answer{2}"), "<2>");
    }

    #[test]
    fn macros_that_do_not_end_are_noticed() {
        for text in [r"\def\a{\a}\a", r"\def\a{\b\b}\def\b{\a\a}\a", r"\def\a{x\a\a}\a"] {
            assert!(expanded(text).is_err(), "{text}");
        }
    }

    #[test]
    fn macros_take_no_more_than_a_paper_may() {
        // Sixty doublings of nothing; a long argument that is used often; more arguments than TeX has.
        let names: Vec<char> = ('a'..='z').chain('A'..='Z').collect();
        let doubling = |base: &str| {
            let first = format!("\\def\\a{{{base}}}");
            let each = names.windows(2).map(|w| format!("\\def\\{}{{\\{}\\{}}}", w[1], w[0], w[0]));
            format!("{first}{}\\Z", each.collect::<String>())
        };
        // The one that the text calls is named, not one of those within.
        for base in ["", "x"] {
            let after_another = format!("\\def\\other{{o}}\\other {}", doubling(base));
            assert_eq!(expanded(&after_another).map_err(|e| e.name), Err("Z".to_owned()));
        }
        let often = format!("\\def\\a#1{{{}}}\\a{{{}}}", "#1".repeat(10_000), "x".repeat(10_000));
        assert!(expanded(&often).is_err());
        assert_eq!(shown(r"\newcommand{\a}[99999999999]{x}\a bcdefghijkl"), "xkl");
    }

    #[test]
    fn places_are_those_of_the_call() {
        let text = r"\def\a{xy} \a z";
        let all = expanded(text).expect("ends");
        assert!(all.iter().filter(|t| t.text == "x" || t.text == "y").all(|t| &text[t.span.clone()] == r"\a"));
    }

    #[test]
    fn unfinished_definitions_do_not_panic() {
        let text = r"\newcommand{\a}[2][x]{\b#1#2}\def\c#1{\let\d=\a}\DeclareMathOperator*{\t}{t}\a[\c{y}{z\d{w}";
        for end in 0..text.len() {
            let _ = expanded(&text[..end]);
        }
    }
}
