//! Branches of conditions, as they are read.
//!
//! **In:** the tokens of conditions. **Out:** the branch that is printed, or all of them where it is not known which is; what stands in these is in
//! doubt. **Guaranteed:** no branch is left out that may be printed.

use super::super::note::PaperNote;
use super::super::short::Short;
use super::super::token::{Kind, Token};
use super::conditions::{Skipped, TexCondition, condition, drop_arguments, skip_branch};
use super::rest::argument;
use super::{END_OF_BRANCHES, Expander};

/// How a condition, or something else that may not be printed, goes on.
#[derive(Clone, PartialEq, Eq)]
pub(super) enum BranchForm {
    /// The branch that is printed is being read.
    Known,
    /// Its branches end with `\else` and `\fi`.
    Open,
    /// Its branches are arguments.
    Arguments,
    /// An environment that is not understood, up to its end.
    Environment(String),
    /// A file so deep within files that may have ended, up to its end.
    File(usize),
}

/// A condition of which the end is still to come.
pub(super) struct Unclosed {
    form: BranchForm,
    /// The innermost condition around what is read of which it is not known whether it holds, this one counted.
    pub doubt: Option<usize>,
    /// The packages that are being read there.
    pub packages: usize,
}

/// How far back what ends is looked for.
const MOST_OPEN: usize = 200;

impl Expander<'_, '_> {
    /// Takes a token of a condition: its beginning, or the end of a branch; `is_sure` says whether it is known that it is this token.
    pub(super) fn conditional(&mut self, token: &Token, depth: usize, is_sure: bool) -> bool {
        match token.text.as_str() {
            "fi" | END_OF_BRANCHES => {
                let has_arguments = !token.is("fi");
                let Some(form) = self.conditions.last().map(|c| c.form.clone()) else { return has_arguments };
                if (form == BranchForm::Arguments) != has_arguments {
                    return has_arguments;
                }
                if form == BranchForm::Open {
                    self.print(token.clone());
                }
                self.conditions.pop();
                self.be_doubtful();
                return true;
            }
            "else" => {
                if self.conditions.last().is_none_or(|c| c.form != BranchForm::Known) {
                    return false;
                }
                self.conditions.pop();
                self.skip(token);
                return true;
            }
            _ => {}
        }
        let negates = token.is("unless");
        let asked = match self.rest.last() {
            Some((t, _)) if negates && t.kind == Kind::Command => {
                let text = self.defined.alias(&t.text).map_or_else(|| t.text.clone(), Short::from);
                Token { text, ..t.clone() }
            }
            _ if negates => return false,
            _ => token.clone(),
        };
        if negates {
            self.rest.pop();
        }
        let found = condition(&asked.text, &mut self.rest, &self.defined, &mut self.looked);
        match found.map(|found| if is_sure { found } else { found.in_doubt() }) {
            None => {
                if negates {
                    self.rest.push((asked, depth));
                }
                return false;
            }
            Some(TexCondition::Known(value)) if value != negates => self.open(BranchForm::Known, None),
            Some(TexCondition::Known(_)) => self.skip(token),
            Some(TexCondition::Open) => {
                let doubt = self.doubts.of_condition(&asked, &token.span);
                self.open(BranchForm::Open, Some(doubt));
                self.print(asked);
            }
            Some(TexCondition::Arguments(before, branches)) => self.branches(&asked, (before, branches), depth),
        }
        true
    }

    /// Puts the branches of a condition that are arguments in its place.
    fn branches(&mut self, token: &Token, (before, branches): (usize, usize), depth: usize) {
        drop_arguments(&mut self.rest, before);
        let all: Vec<Vec<Token>> = (0..branches).map(|_| argument(&mut self.rest)).collect();
        let doubt = self.doubts.of_condition(token, &token.span);
        self.put_behind(END_OF_BRANCHES, token.span.clone(), depth);
        self.rest.extend(all.into_iter().flatten().rev().map(|t| (t, depth)));
        self.open(BranchForm::Arguments, Some(doubt));
        self.print(token.clone());
    }

    pub(super) fn open(&mut self, form: BranchForm, doubt: Option<usize>) {
        let doubt = doubt.or_else(|| self.conditions.last().and_then(|c| c.doubt));
        self.conditions.push(Unclosed { form, doubt, packages: self.defined.packages });
        self.be_doubtful();
    }

    /// Whether what stands here may not be printed though its file goes on.
    pub(super) fn may_be_passed_over(&self) -> bool {
        self.conditions.last().is_some_and(|c| c.doubt.is_some() && !matches!(c.form, BranchForm::File(_)))
    }

    /// What may have ended here is in doubt up to its end, whatever conditions are open.
    pub(super) fn doubt_what_follows(&mut self, token: &Token, form: BranchForm) {
        if self.conditions.first().is_some_and(|c| c.form == form) {
            return;
        }
        let doubt = self.conditions.last().and_then(|c| c.doubt);
        let doubt = doubt.unwrap_or_else(|| self.doubts.of_condition(token, &token.span));
        self.conditions.insert(0, Unclosed { form, doubt: Some(doubt), packages: self.defined.packages });
    }

    /// The end of something of which it was not known whether it is printed.
    pub(super) fn end_doubt(&mut self, form: &BranchForm) {
        if let Some(at) = self.conditions.iter().rev().take(MOST_OPEN).position(|c| c.form == *form) {
            self.conditions.remove(self.conditions.len() - 1 - at);
            self.be_doubtful();
        }
    }

    /// Notes whether it is known that what stands here is printed.
    pub(super) fn be_doubtful(&mut self) {
        self.defined.is_doubtful = self.conditions.last().is_some_and(|c| c.doubt.is_some());
    }

    /// Passes over a branch that is not printed; its `\\else` is.
    fn skip(&mut self, token: &Token) {
        match skip_branch(&mut self.rest, &self.defined) {
            Skipped::Else => self.open(BranchForm::Known, None),
            Skipped::Fi => self.be_doubtful(),
            Skipped::Never => {
                self.be_doubtful();
                let name = diag::escape::in_one_line(&token.text);
                let message = format!("nothing closes this `\\{name}`: what follows is not read");
                self.notes.push(PaperNote { message, span: token.span.clone() });
            }
        }
    }
}
