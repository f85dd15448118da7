//! Conditions of TeX and of its packages: what of them is printed.
//!
//! **In:** a command, and what follows it. **Out:** what kind of condition it begins. **Guaranteed:** each `\fi` closes the condition to which it
//! belongs, whatever is known of that.

use super::super::token::Kind;
use super::defined::Defined;
use super::rest::{MOST_AHEAD, Rest, argument, spaces};

/// Conditions of TeX, and of packages that tell how the document is set.
const OF_TEX: &[&str] = &[
    "if",
    "ifcat",
    "ifnum",
    "ifdim",
    "ifodd",
    "ifvmode",
    "ifhmode",
    "ifmmode",
    "ifinner",
    "ifvoid",
    "ifhbox",
    "ifvbox",
    "ifx",
    "ifeof",
    "iftrue",
    "iffalse",
    "ifcase",
    "ifdefined",
    "ifcsname",
    "iffontchar",
    "ifincsname",
    "ifpdf",
    "ifxetex",
    "ifluatex",
    "ifvtex",
    "ifPDFTeX",
    "ifXeTeX",
    "ifLuaTeX",
    "ifpdftex",
    "iftutex",
];

/// Conditions whose branches are arguments, and how many arguments stand before these.
const WITH_ARGUMENTS: &[(&str, usize, usize)] = &[
    ("ifthenelse", 1, 2),
    ("iftoggle", 1, 2),
    ("nottoggle", 1, 2),
    ("ifbool", 1, 2),
    ("notbool", 1, 2),
    ("ifboolexpr", 1, 2),
    ("ifdef", 1, 2),
    ("ifundef", 1, 2),
    ("ifcsdef", 1, 2),
    ("ifcsundef", 1, 2),
    ("ifdefmacro", 1, 2),
    ("ifdefempty", 1, 2),
    ("ifdefvoid", 1, 2),
    ("ifdefequal", 2, 2),
    ("ifdefstring", 2, 2),
    ("ifstrequal", 2, 2),
    ("ifstrempty", 1, 2),
    ("ifblank", 1, 2),
    ("notblank", 1, 2),
    ("ifnumcomp", 3, 2),
    ("ifnumequal", 2, 2),
    ("ifnumgreater", 2, 2),
    ("ifnumless", 2, 2),
    ("ifnumodd", 1, 2),
    ("ifdimcomp", 3, 2),
    ("ifinlist", 2, 2),
    ("iflanguage", 1, 2),
    ("@ifundefined", 1, 2),
    ("@ifpackageloaded", 1, 2),
    ("@ifclassloaded", 1, 2),
    ("@ifdefinable", 1, 1),
    ("@ifpackagelater", 2, 2),
    ("@ifpackagewith", 2, 2),
    ("IfPackageLoadedTF", 1, 2),
    ("IfPackageLoadedT", 1, 1),
    ("IfPackageLoadedF", 1, 1),
    ("IfClassLoadedTF", 1, 2),
    ("IfFileExists", 1, 2),
    ("InputIfFileExists", 1, 2),
    ("IfBooleanTF", 1, 2),
    ("IfBooleanT", 1, 1),
    ("IfBooleanF", 1, 1),
    ("IfNoValueTF", 1, 2),
    ("IfNoValueT", 1, 1),
    ("IfNoValueF", 1, 1),
    ("IfValueTF", 1, 2),
    ("IfValueT", 1, 1),
    ("IfValueF", 1, 1),
];

/// How a condition of TeX is asked, and whether its answer is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TexCondition {
    /// It holds, or does not.
    Known(bool),
    /// That is not known.
    Open,
    /// Its branches are so many arguments, behind so many others; whether it holds is not known.
    Arguments(usize, usize),
}

impl TexCondition {
    /// The same, where it is not known that it is this one.
    pub(super) fn in_doubt(self) -> TexCondition {
        if matches!(self, TexCondition::Known(_)) { TexCondition::Open } else { self }
    }
}

/// The condition that a command begins; what is asked of, where it is no number, is taken from what follows.
pub(super) fn condition(command: &str, rest: &mut Rest, defined: &Defined, looked: &mut usize) -> Option<TexCondition> {
    if defined.macro_of(command).is_some() {
        return None;
    }
    if let Some(value) = defined.condition(command) {
        return Some(value.map_or(TexCondition::Open, TexCondition::Known));
    }
    if let Some((_, before, branches)) = WITH_ARGUMENTS.iter().find(|(name, ..)| *name == command) {
        return Some(TexCondition::Arguments(*before, *branches));
    }
    match command {
        "iftrue" => return Some(TexCondition::Known(true)),
        "iffalse" => return Some(TexCondition::Known(false)),
        "ifdefined" => {
            spaces(rest);
            let is_named = rest.last().is_some_and(|(t, _)| t.kind == Kind::Command && !t.is("fi") && !t.is("else"));
            let name = if is_named { rest.pop().map(|(t, _)| t) } else { None };
            let is_known = |name: &str| defined.has(name) && !defined.is_doubted(name);
            let holds = name.is_some_and(|t| is_known(&t.text));
            return Some(if holds { TexCondition::Known(true) } else { TexCondition::Open });
        }
        "ifx" => {
            for _ in 0..2 {
                spaces(rest);
                // What is compared is not called; a condition goes on behind it.
                if rest.last().is_some_and(|(t, _)| !t.is("fi") && !t.is("else")) {
                    rest.pop();
                }
            }
            return Some(TexCondition::Open);
        }
        name if OF_TEX.contains(&name) => return Some(TexCondition::Open),
        _ => {}
    }
    // `\ifmine`, `\IfStrEq`, `\@ifstar`
    let is_of_tex = command.starts_with("if") && command != "iff";
    if !is_of_tex && !command.starts_with("If") && !command.starts_with("@if") {
        return None;
    }
    if is_of_tex && ends_ahead(rest, defined, looked) {
        return Some(TexCondition::Open);
    }
    let groups = groups_ahead(rest, looked);
    (groups > 0).then_some(TexCondition::Arguments(0, groups))
}

/// Whether a command begins what a `\fi` closes, as far as its name and the sign behind it tell.
fn is_closed_by_fi(command: &str, behind: Option<Kind>, defined: &Defined) -> bool {
    OF_TEX.contains(&command)
        || defined.condition(command).is_some()
        || defined.alias(command).is_some_and(|name| OF_TEX.contains(&name))
        || command.starts_with("if")
            && command != "iff"
            && behind != Some(Kind::Open)
            && defined.macro_of(command).is_none()
            && !WITH_ARGUMENTS.iter().any(|(name, ..)| *name == command)
}

/// Whether a `\fi` follows that closes a condition that begins here.
fn ends_ahead(rest: &Rest, defined: &Defined, looked: &mut usize) -> bool {
    let mut depth = 0usize;
    for at in (0..rest.len()).rev() {
        *looked += 1;
        if *looked > MOST_AHEAD {
            return true;
        }
        let Some((token, _)) = rest.get(at).filter(|(t, _)| t.kind == Kind::Command) else { continue };
        let behind = at.checked_sub(1).and_then(|k| rest.get(k)).map(|(t, _)| t.kind);
        match defined.meant(&token.text) {
            "fi" if depth == 0 => return true,
            "fi" => depth -= 1,
            name if is_closed_by_fi(name, behind, defined) => depth += 1,
            _ => {}
        }
    }
    false
}

/// The most groups behind a condition that are its arguments, as TeX has it.
const MOST_GROUPS: usize = 9;

/// How many groups follow each other, up to so many.
fn groups_ahead(rest: &Rest, looked: &mut usize) -> usize {
    let (mut depth, mut groups) = (0usize, 0);
    for (token, _) in rest.iter().rev() {
        *looked += 1;
        if *looked > MOST_AHEAD {
            return groups;
        }
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close if depth == 0 => return groups,
            Kind::Close => {
                depth -= 1;
                groups += usize::from(depth == 0);
                if groups == MOST_GROUPS {
                    return groups;
                }
            }
            Kind::Space if !token.text.contains('\n') => {}
            _ if depth == 0 => return groups,
            _ => {}
        }
    }
    groups
}

/// Drops so many arguments.
pub(super) fn drop_arguments(rest: &mut Rest, count: usize) {
    for _ in 0..count {
        argument(rest);
    }
}

/// How a branch that is passed over ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Skipped {
    /// With its `\else`.
    Else,
    /// With its `\fi`.
    Fi,
    /// Nothing ends it.
    Never,
}

/// Drops everything up to the `\fi` or `\else` of a branch that is not printed.
pub(super) fn skip_branch(rest: &mut Rest, defined: &Defined) -> Skipped {
    let mut depth = 0usize;
    while let Some((token, _)) = rest.pop() {
        if token.kind != Kind::Command {
            continue;
        }
        let behind = rest.last().map(|(t, _)| t.kind);
        match defined.meant(&token.text) {
            "fi" if depth == 0 => return Skipped::Fi,
            "else" if depth == 0 => return Skipped::Else,
            "fi" => depth -= 1,
            // What is made here is no condition yet.
            "newif" => drop(rest.pop()),
            name if is_closed_by_fi(name, behind, defined) => depth += 1,
            _ => {}
        }
    }
    Skipped::Never
}
