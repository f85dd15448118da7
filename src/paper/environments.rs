//! Environments whose content is not printed, or not as LaTeX: those of packages, and those that the author makes.
//!
//! **In:** the commands of a text, one by one. **Out:** where such an environment ends that begins at a place. **Guaranteed:** what the author
//! says of a name comes before what a package says; what cannot be told from a definition is printed.

use std::collections::BTreeSet;

/// Environments of packages whose content is not printed, or not as LaTeX.
const NOT_PRINTED: &[&str] = &[
    "verbatim",
    "verbatim*",
    "Verbatim",
    "Verbatim*",
    "BVerbatim",
    "LVerbatim",
    "SaveVerbatim",
    "VerbatimOut",
    "spverbatim",
    "lstlisting",
    "tcblisting",
    "comment",
    "filecontents",
    "filecontents*",
    "minted",
    "alltt",
    "tikzpicture",
    "luacode",
    "luacode*",
    "asy",
    "asydef",
    "pycode",
    "pyblock",
    "pyconsole",
    "sagesilent",
    "sageblock",
];

/// How it is known whether the content of an environment is printed.
#[derive(Clone, Copy)]
enum Made {
    /// The command says it.
    Printed(bool),
    /// By what stands at its beginning and its end.
    BeginAndEnd,
    /// The same behind a list of arguments, of which one may be the content.
    Arguments,
    /// By whether `\BODY` stands in what it does.
    Body,
}

/// Commands that make an environment.
const MAKE_ENVIRONMENTS: &[(&str, Made)] = &[
    ("newenvironment", Made::BeginAndEnd),
    ("renewenvironment", Made::BeginAndEnd),
    ("provideenvironment", Made::BeginAndEnd),
    ("NewDocumentEnvironment", Made::Arguments),
    ("RenewDocumentEnvironment", Made::Arguments),
    ("ProvideDocumentEnvironment", Made::Arguments),
    ("DeclareDocumentEnvironment", Made::Arguments),
    ("NewEnviron", Made::Body),
    ("RenewEnviron", Made::Body),
    ("newtheorem", Made::Printed(true)),
    ("includecomment", Made::Printed(true)),
    ("specialcomment", Made::Printed(true)),
    ("includeversion", Made::Printed(true)),
    ("markversion", Made::Printed(true)),
    ("newtcolorbox", Made::Printed(true)),
    ("NewTColorBox", Made::Printed(true)),
    ("excludecomment", Made::Printed(false)),
    ("excludeversion", Made::Printed(false)),
    ("lstnewenvironment", Made::Printed(false)),
    ("newtcblisting", Made::Printed(false)),
    ("NewTCBListing", Made::Printed(false)),
    ("DeclareTCBListing", Made::Printed(false)),
    ("DefineVerbatimEnvironment", Made::Printed(false)),
    ("newverbatim", Made::Printed(false)),
];

/// Commands that begin an environment whose content is not printed as LaTeX, where they stand in one of the author's own.
const BEGIN_VERBATIM: &[&str] =
    &["comment", "verbatim", "Verbatim", "VerbatimEnvironment", "lstlisting", "minted", "alltt"];

/// Commands that keep what follows in a box, and those that print a box.
const BOXES: (&[&str], &[&str]) = (
    &["setbox", "lrbox", "savebox", "sbox"],
    &["box", "copy", "unhbox", "unvbox", "unhcopy", "unvcopy", "usebox", "BODY"],
);

/// The longest name of an environment that is kept.
const LONGEST_NAME: usize = 100;
/// The most environments of the author's own that are kept.
const MOST_OWN: usize = 500;
/// The longest definition of an environment that is looked at, in bytes.
const LONGEST_DEFINITION: usize = 20_000;

/// Environments that the author makes, and whether what stands in them is printed; `None` where two definitions say different things of it.
#[derive(Clone, Debug, Default)]
pub(super) struct OwnEnvironments(Vec<(String, Option<bool>)>);

/// What is not printed goes on to the end of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Unended;

impl OwnEnvironments {
    /// Whether the other ones read the same texts.
    pub fn read_as(&self, other: &OwnEnvironments) -> bool {
        let counts = |all: &OwnEnvironments| -> BTreeSet<(String, Option<bool>)> {
            let is_other = |(name, is_printed): &&(String, Option<bool>)| {
                *is_printed != Some(!NOT_PRINTED.contains(&name.as_str()))
            };
            all.0.iter().filter(is_other).cloned().collect()
        };
        counts(self) == counts(other)
    }

    fn is_printed(&self, name: &str) -> bool {
        let own = self.0.iter().find(|(known, _)| known == name).map(|(_, is_printed)| is_printed.unwrap_or(true));
        own.unwrap_or(!NOT_PRINTED.contains(&name))
    }

    /// The name of the environment that begins here, behind `\begin`, if one definition of it says that it is printed, and another one that it is not.
    pub fn in_doubt<'t>(&self, command: &str, text: &'t str, at: usize) -> Option<&'t str> {
        let name = group(text, at).filter(|_| command == "begin")?.0;
        self.0.iter().any(|(known, is_printed)| known == name && is_printed.is_none()).then_some(name)
    }

    fn put(&mut self, name: &str, is_printed: bool) {
        let has_room = self.0.len() < MOST_OWN && name.len() <= LONGEST_NAME;
        match self.0.iter_mut().find(|(known, _)| known == name) {
            Some((_, before)) => *before = before.filter(|before| *before == is_printed),
            None if has_room => self.0.push((name.to_owned(), Some(is_printed))),
            None => {}
        }
    }

    /// Takes a command that ends at a place of a text.
    pub fn take(&mut self, command: &str, text: &str, at: usize) {
        match command {
            // `\let\hide\comment`: the same by another name.
            "let" => {
                let names = name_of_command(text, at).and_then(|(new, at)| Some((new, name_of_command(text, at)?.0)));
                if let Some((new, _)) = names.filter(|(_, old)| !self.is_printed(old)) {
                    self.put(new, false);
                }
            }
            "newminted" => {
                let (option, at) = option(text, at);
                let name = option.map(str::to_owned).or_else(|| Some(format!("{}code", group(text, at)?.0)));
                if let Some(name) = name {
                    self.put(&name, false);
                }
            }
            _ => {
                let Some((_, made)) = MAKE_ENVIRONMENTS.iter().find(|(name, _)| *name == command) else { return };
                let at = text.len() - text[at..].trim_start_matches(['*', ' ']).len();
                if let Some((name, at)) = group(text, option(text, at).1).filter(|(name, _)| name.len() <= LONGEST_NAME)
                {
                    let is_printed = self.made(*made, text, at);
                    self.put(name, is_printed);
                }
            }
        }
    }

    /// Whether what stands in an environment is printed, whose definition goes on at a place.
    fn made(&self, made: Made, text: &str, at: usize) -> bool {
        let bodies = |at: usize| {
            let (begin, after) = group(text, at)?;
            Some((begin, group(text, after).map_or("", |(end, _)| end)))
        };
        match made {
            Made::Printed(is_printed) => is_printed,
            Made::Body => bodies(behind_options(text, at)).is_none_or(|(body, _)| body.contains(r"\BODY")),
            Made::BeginAndEnd => {
                bodies(behind_options(text, at)).is_none_or(|(begin, end)| self.prints_between(begin, end))
            }
            Made::Arguments => {
                let Some((arguments, at)) = group(text, at) else { return true };
                let (count, has_content) = arguments_of(arguments);
                let content = format!("#{count}");
                bodies(at).is_none_or(|(begin, end)| match has_content {
                    true => begin.contains(&content) || end.contains(&content),
                    false => self.prints_between(begin, end),
                })
            }
        }
    }

    /// Whether what stands between these is printed.
    fn prints_between(&self, begin: &str, end: &str) -> bool {
        let named = |at: usize, command: &str| match command {
            "begin" => group(begin, at).is_some_and(|(name, _)| !self.is_printed(name)),
            command => BEGIN_VERBATIM.contains(&command) || !self.is_printed(command),
        };
        let mut all = commands(begin);
        let is_first = all.next().is_some_and(|(at, first)| {
            begin[..at].trim_matches(['{', ' ', '\n', '%']).len() == first.len() + 1 && named(at, first)
        });
        let ends =
            |command: &str| end.contains(&format!("\\end{command}")) || end.contains(&format!("\\end{{{command}}}"));
        let is_ended = all.any(|(at, command)| command != "begin" && named(at, command) && ends(command));
        let any = |text: &str, of: &[&str]| commands(text).any(|(_, command)| of.contains(&command));
        let is_kept = (any(begin, BOXES.0) || begin.contains("{lrbox}")) && !any(begin, BOXES.1) && !any(end, BOXES.1);
        !(is_first || is_ended || is_kept)
    }

    /// The end of what a command begins that ends at a place, where the content of that is not printed; `Err` where nothing ends it.
    pub fn after_unprinted(&self, command: &str, text: &str, at: usize) -> Option<Result<usize, Unended>> {
        let (name, after) = match command {
            "begin" | "processifversion" => group(text, at).filter(|(name, _)| !self.is_printed(name))?,
            _ => return None,
        };
        if command == "processifversion" {
            return group(text, after).map(|(_, end)| Ok(end));
        }
        let closes = |(i, word): (usize, &str)| {
            let rest = text[after + i + word.len()..].trim_start_matches([' ', '\t']);
            let behind = rest.strip_prefix('{')?.strip_prefix(name)?.strip_prefix('}')?;
            Some(text.len() - behind.len())
        };
        Some(text[after..].match_indices(r"\end").find_map(closes).ok_or(Unended))
    }
}

/// The place behind spaces, comments and the end of a line: what TeX passes over before an argument.
fn behind_blanks(text: &str, mut at: usize) -> usize {
    let mut breaks = 0;
    while let Some(c) = text[at..].chars().next() {
        match c {
            '%' => at = text[at..].find('\n').map_or(text.len(), |i| at + i + 1),
            '\n' if breaks == 1 => break,
            '\n' => {
                breaks += 1;
                at += 1;
            }
            ' ' | '\t' | '\r' => at += 1,
            _ => break,
        }
    }
    at
}

/// What stands in the braces that open at a place, and the place behind them.
fn group(text: &str, at: usize) -> Option<(&str, usize)> {
    let open = behind_blanks(text, at);
    let (mut depth, mut escaped, mut in_comment) = (0usize, false, false);
    for (i, byte) in text[open..].bytes().enumerate().take(LONGEST_DEFINITION) {
        match byte {
            _ if depth == 0 && byte != b'{' => return None,
            _ if in_comment => in_comment = byte != b'\n',
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'%' => in_comment = true,
            b'{' => depth += 1,
            b'}' if depth == 1 => return Some((&text[open + 1..open + i], open + i + 1)),
            b'}' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// An option in brackets, where one stands at a place, and the place behind it.
fn option(text: &str, at: usize) -> (Option<&str>, usize) {
    let open = behind_blanks(text, at);
    let inside = text[open..].strip_prefix('[').and_then(|rest| rest.split_once(']'));
    match inside.filter(|(option, _)| option.len() <= LONGEST_DEFINITION) {
        Some((option, behind)) => (Some(option), text.len() - behind.len()),
        None => (None, at),
    }
}

fn behind_options(text: &str, mut at: usize) -> usize {
    while let (Some(_), after) = option(text, at) {
        at = after;
    }
    at
}

/// The names of the commands of a text, each with the place where it ends.
fn commands(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.match_indices('\\').filter_map(move |(i, _)| {
        let length = text[i + 1..].bytes().take_while(u8::is_ascii_alphabetic).count();
        (length > 0).then(|| (i + 1 + length, &text[i + 1..i + 1 + length]))
    })
}

/// The name of the command that stands at a place, perhaps behind an equals sign, and the place behind it.
fn name_of_command(text: &str, at: usize) -> Option<(&str, usize)> {
    let rest = text[at..].trim_start_matches([' ', '=']).strip_prefix('\\')?;
    let length = rest.bytes().take_while(|b| b.is_ascii_alphabetic() || *b == b'@').count();
    (length > 0).then(|| (&rest[..length], text.len() - rest.len() + length))
}

/// How many arguments a list of `\NewDocumentEnvironment` has, and whether one is the content: that is the last.
fn arguments_of(list: &str) -> (usize, bool) {
    let (mut count, mut has_content, mut at) = (0, false, 0);
    let behind_group = |at: usize| group(list, at).map_or(at, |(_, end)| end);
    let behind_sign = |at: usize| {
        let sign = behind_blanks(list, at);
        list[sign..].chars().next().map_or(sign, |c| sign + c.len_utf8())
    };
    while let Some(c) = list[at..].chars().next() {
        at += c.len_utf8();
        match c {
            '+' | '!' => continue,
            c if c.is_whitespace() => continue,
            '>' | '=' => {
                at = behind_group(at);
                continue;
            }
            'b' | 'c' => has_content = true,
            'r' | 'd' => at = behind_sign(behind_sign(at)),
            'R' | 'D' => at = behind_group(behind_sign(behind_sign(at))),
            'O' | 'G' => at = behind_group(at),
            't' | 'u' => at = behind_sign(at),
            // One argument for each of the signs.
            'e' | 'E' => {
                let signs = group(list, at).map_or("", |(signs, _)| signs);
                count += signs.chars().filter(|c| !c.is_whitespace()).count().saturating_sub(1);
                at = behind_group(at);
                at = if c == 'E' { behind_group(at) } else { at };
            }
            _ => {}
        }
        count += 1;
    }
    (count, has_content)
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;

    fn prints(text: &str) -> bool {
        tokens(text).iter().any(|t| t.text == *"Q")
    }

    #[test]
    fn what_is_printed_is_what_the_author_says() {
        for (text, is_printed) in [
            (r"\begin{comment}Q\end{comment}", false),
            (r"\newtheorem{comment}{Note}\begin{comment}Q\end{comment}", true),
            (r"\newenvironment{comment}{\it}{}\begin{comment}Q\end{comment}", true),
            (r"\includecomment{comment}\begin{comment}Q\end{comment}", true),
            (r"\excludecomment{e}\begin{e}Q\end{e}", false),
            (r"\excludeversion{e}\begin{e}Q\end{e}", false),
            (r"\excludeversion {e}\begin{e}Q\end{e}", false),
            (r"\excludeversion{e}\includeversion{e}\begin{e}Q\end{e}", true),
            (r"\excludeversion{e}\processifversion{e}{Q}", false),
            (r"\includeversion{e}\processifversion{e}{Q}", true),
            (r"\excludeversion{e}\processifversion{e}{x}Q", true),
            (r"\NewEnviron{e}{}\begin{e}Q\end{e}", false),
            (r"\NewEnviron{e}{\BODY}\begin{e}Q\end{e}", true),
            (r"\NewEnviron{e}[1][a]{\BODY}\begin{e}Q\end{e}", true),
            (r"\newenvironment{e}{\comment}{\endcomment}\begin{e}Q\end{e}", false),
            (r"\newenvironment{e}[1][a]{\small\verbatim}{\endverbatim}\begin{e}Q\end{e}", false),
            (r"\newenvironment{e}{\expandafter\comment}{\expandafter\endcomment}\begin{e}Q\end{e}", false),
            (r"\newenvironment{e}{\small\comment{a}}{b}\begin{e}Q\end{e}", true),
            (r"\newenvironment{e}{\setbox0\vbox\bgroup}{\egroup}\begin{e}Q\end{e}", false),
            (r"\newenvironment{e}{\setbox0\vbox\bgroup}{\egroup\box0}\begin{e}Q\end{e}", true),
            (r"\newenvironment{e}{\begin{lrbox}{\x}}{\end{lrbox}}\begin{e}Q\end{e}", false),
            (r"\newenvironment{e}{\begin{lrbox}{\x}}{\end{lrbox}\usebox\x}\begin{e}Q\end{e}", true),
            (r"\NewDocumentEnvironment{e}{}{\comment}{\endcomment}\begin{e}Q\end{e}", false),
            (r"\NewDocumentEnvironment{e}{+b}{}{}\begin{e}Q\end{e}", false),
            (r"\NewDocumentEnvironment{e}{+b}{#1}{}\begin{e}Q\end{e}", true),
            (r"\NewDocumentEnvironment{e}{+b}{}{#1}\begin{e}Q\end{e}", true),
            (r"\NewDocumentEnvironment{e}{m O{a} +b}{#1#2}{}\begin{e}Q\end{e}", false),
            (r"\NewDocumentEnvironment{e}{s D(){} e{^_} !b}{#5}{}\begin{e}Q\end{e}", true),
            (r"\NewDocumentEnvironment{e}{m}{#1}{}\begin{e}{a}Q\end{e}", true),
            (r"\lstnewenvironment{e}{}{}\begin{e}Q\end{e}", false),
            (r"\newminted{c}{}\begin{ccode}Q\end{ccode}", false),
            (r"\newminted[e]{c}{}\begin{e}Q\end{e}", false),
            (r"\let\e\comment\let\ende=\endcomment\begin{e}Q\end{e}", false),
            (r"\let\e=\it\begin{e}Q\end{e}", true),
            (r"\begin{BVerbatim}Q\end{BVerbatim}\begin{pycode}$Q$\end{pycode}", false),
        ] {
            assert_eq!(prints(text), is_printed, "{text}");
        }
    }

    #[test]
    fn blanks_comments_and_ends_of_lines_stand_before_a_name() {
        for between in ["", " ", "\t", "\n", "  \n ", "% a\n", " % }\n  ", "\r\n"] {
            let text = format!("\\begin{between}{{comment}}Q\\end{{comment}}x");
            assert!(!prints(&text), "{text}");
            let text =
                format!("\\newenvironment{between}{{e}}{between}{{\\comment}}{between}{{}}\\begin{{e}}Q\\end{{e}}x");
            assert!(!prints(&text), "{text}");
        }
        assert!(prints(r"\begin{comment}a\end {comment}Q"));
        assert!(!prints(r"\begin{comment}a\end{comments}\endgraf\end{comment }Q"));
        assert!(prints(r"\begin{comment}\begin{comment}a\end{comment}Q\end{comment}"), "as in print");
        assert!(!prints(r"\begin{comment}[a]{b}Q"), "one that does not end");
    }

    #[test]
    fn no_text_panics() {
        for text in [
            "\\newenvironment{é}[1]{\\é}{}",
            "\\NewDocumentEnvironment{é}{e{}E é>{é}D é r}{#1}{}",
            "\\let\\é=\\é\\let\\a\\comment",
            "\\newminted[é]{é}\\processifversion{é}{é}",
            "\\begin%é\n{comment}é\\end é{comment}",
        ] {
            for end in (0..=text.len()).filter(|i| text.is_char_boundary(*i)) {
                tokens(&text[..end]);
            }
        }
    }
}
