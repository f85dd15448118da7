//! Environments of LaTeX that are displays, or tables.
//!
//! **In:** the name of an environment, or of a command. **Out:** whether it is a display, how its lines are numbered, whether its cells are groups.

/// How the lines of a display are numbered.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Numbers {
    /// One number for all.
    One,
    /// One for each line, unless the line says otherwise.
    EachLine,
}

/// How the lines of an environment are numbered, if it is a display.
pub(super) fn display(name: &str) -> Option<Numbers> {
    match name {
        "equation" | "equation*" | "displaymath" | "multline" | "multline*" | "math" | "dmath" | "dmath*"
        | "align*" | "eqnarray*" | "gather*" | "flalign*" | "alignat*" | "IEEEeqnarray*" | "dgroup" => {
            Some(Numbers::One)
        }
        "align" | "eqnarray" | "gather" | "flalign" | "alignat" | "IEEEeqnarray" => Some(Numbers::EachLine),
        "subeqnarray" | "xalignat" => Some(Numbers::EachLine),
        _ => None,
    }
}

/// Whether an environment is a display.
pub(super) fn is_display(name: &str) -> bool {
    display(name).is_some()
}

/// Environments whose cells are groups of their own, beside displays; a star behind a name makes no difference.
const WITH_CELLS: &[&str] = &[
    "aligned",
    "alignedat",
    "gathered",
    "split",
    "array",
    "tabular",
    "tabularx",
    "longtable",
    "matrix",
    "pmatrix",
    "bmatrix",
    "Bmatrix",
    "vmatrix",
    "Vmatrix",
    "smallmatrix",
    "cases",
    "dcases",
    "rcases",
];

/// Whether the cells of an environment end what is defined in them.
pub(super) fn has_cells(name: &str) -> bool {
    is_display(name) || WITH_CELLS.contains(&name.trim_end_matches('*'))
}

/// Whether a command of LaTeX begins a display or ends one, and which: `\align`, `\endalign`.
pub(super) fn of_command(command: &str) -> Option<(&'static str, &str)> {
    let ends = command.strip_prefix("end").filter(|name| is_display(name));
    ends.map(|name| ("end", name)).or_else(|| is_display(command).then_some(("begin", command)))
}
