//! What the running text does not say: arguments that are not printed, what is struck out, boxes that are printed elsewhere.
//!
//! **In:** a command, and the tokens behind it. **Out:** where reading goes on. **Guaranteed:** formulas in a box that is not printed where it is
//! made are told.

use std::ops::Range;

use super::super::mark::group_text;
use super::super::note::PaperNote;
use super::super::token::{Kind, Token};
use super::{MOST_OF_OPTIONS, Reader};

/// Commands of which nothing is printed as a formula where they stand, and how many arguments in braces they have.
const NOT_PRINTED: &[(&str, usize)] = &[
    ("phantom", 1),
    ("vphantom", 1),
    ("hphantom", 1),
    ("index", 1),
    ("glossary", 1),
    ("label", 1),
    ("ref", 1),
    ("eqref", 1),
    ("detokenize", 1),
    ("typeout", 1),
    ("message", 1),
    ("errmessage", 1),
    ("wlog", 1),
    ("PackageInfo", 2),
    ("PackageWarning", 2),
    ("PackageWarningNoLine", 2),
    ("PackageError", 3),
    ("ClassInfo", 2),
    ("ClassWarning", 2),
    ("ClassWarningNoLine", 2),
    ("ClassError", 3),
    ("GenericInfo", 2),
    ("GenericWarning", 2),
    ("GenericError", 4),
    ("settowidth", 2),
    ("settoheight", 2),
    ("settodepth", 2),
    ("hypersetup", 1),
    ("pdfbookmark", 2),
    ("@gobble", 1),
    ("@gobbletwo", 2),
    // Of ulem, soul, cancel and changes: struck out.
    ("sout", 1),
    ("xout", 1),
    ("st", 1),
    ("cancel", 1),
    ("bcancel", 1),
    ("xcancel", 1),
    ("hcancel", 1),
    ("deleted", 1),
];
/// Commands of which the first argument stands in the place of the second, which is struck out.
const REPLACE: &[&str] = &["replaced"];
/// Commands that put something in a box.
const BOX: &[&str] = &["savebox", "sbox", "setbox"];
/// Commands that print a box.
const PRINT_BOX: &[&str] = &["usebox", "box", "copy", "unhbox", "unhcopy"];
/// The most tokens of a box.
const LONGEST_BOX: usize = 4_000;
/// So many tokens behind a box it is looked for what prints it.
const NEAR: usize = 200;

impl Reader<'_> {
    /// Passes over what stands behind a command and is not said; `false` where the command is none of these.
    pub(super) fn passes_over(&mut self, command: &str) -> bool {
        if let Some((_, count)) = NOT_PRINTED.iter().find(|(name, _)| *name == command) {
            self.at += usize::from(self.tokens.get(self.at).is_some_and(|t| t.is_char("*")));
            self.at = self.after_options(self.at);
            (0..*count).for_each(|_| self.at = group_text(self.tokens, self.at).1);
            return true;
        }
        if REPLACE.contains(&command) {
            let first = group_text(self.tokens, self.after_options(self.at)).1;
            let second = group_text(self.tokens, first).1;
            if second > first {
                self.passed.insert(first, second);
            }
            return true;
        }
        if BOX.contains(&command) {
            let span = self.tokens.get(self.at.saturating_sub(1)).map_or(0..0, |t| t.span.clone());
            self.boxed(&span);
            return true;
        }
        false
    }

    /// Passes over what is put into a box; a formula in it is told, since the box may be printed elsewhere.
    fn boxed(&mut self, span: &Range<usize>) {
        let name = group_text(self.tokens, self.at).1;
        // The name in braces or not, `=`, a width in brackets.
        let before_group =
            |from: usize| self.tokens.iter().skip(from).take(MOST_OF_OPTIONS).position(|t| t.kind == Kind::Open);
        let Some(more) = before_group(name) else { return };
        self.at = name + more;
        let body = self.argument();
        self.tell_of_box(&body, span);
    }

    /// The same of an environment, unless what prints the box stands right behind it; `after` is the place behind its name.
    pub(super) fn box_environment(&mut self, after: usize) -> bool {
        let tokens = self.tokens;
        let name = |at: usize| tokens.iter().skip(at).find(|t| t.kind != Kind::Space && t.kind != Kind::Open);
        let ends = |at: &usize| tokens[*at].is("end") && group_text(tokens, *at + 1).0 == "lrbox";
        let Some(end) = (after..tokens.len()).take(LONGEST_BOX).find(ends) else { return false };
        let is_printed = (end..tokens.len()).take(NEAR).any(|at| {
            let prints = tokens[at].kind == Kind::Command && PRINT_BOX.contains(&tokens[at].text.as_str());
            prints && name(at + 1).zip(name(after)).is_some_and(|(one, other)| one.text == other.text)
        });
        if !is_printed {
            let span = self.tokens[self.at.saturating_sub(1)].span.clone();
            self.tell_of_box(&tokens[after..end], &span);
            self.at = group_text(tokens, end + 1).1;
        }
        !is_printed
    }

    fn tell_of_box(&mut self, body: &[Token], span: &Range<usize>) {
        if body.iter().any(|t| t.kind == Kind::Dollar || t.is("(") || t.is("[")) {
            let message = "formulas in a box that is printed elsewhere, or not at all, are not read".to_owned();
            self.notes.push(PaperNote { message, span: span.clone() });
        }
    }
}
