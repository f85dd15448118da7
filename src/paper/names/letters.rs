//! Commands that are letters, and those that change how a letter is printed.
//!
//! **In:** –. **Out:** tables. **Why:** what is a name is decided by what is printed, and this is all that prints one.

/// Whether a command is a letter as a paper prints one: `\top` stands for a transpose more often than for a name.
pub fn is_letter_command(command: &str) -> bool {
    command == "varkappa" || command != "top" && latex::is_letter_command(command)
}

pub const BOLD: &[&str] = &[
    "mathbf",
    "boldsymbol",
    "bm",
    "vec",
    "bf",
    "textbf",
    "pmb",
    "vb",
    "va",
    "vectorbold",
    "mathbfit",
    "overrightarrow",
];
pub const HATS: &[&str] = &["hat", "widehat", "vu", "uvec"];
pub const STYLES: &[&str] = &[
    "tilde",
    "widetilde",
    "bar",
    "overline",
    "mathcal",
    "mathrm",
    "mathsf",
    "mathfrak",
    "mathbb",
    "mathscr",
    "mathit",
    "mathnormal",
    "textit",
    "textsf",
    "widecheck",
    "acute",
    "grave",
    "mathring",
    "cal",
    "rm",
    "check",
    "breve",
];
pub const DOTS: &[(&str, usize)] = &[("dot", 1), ("ddot", 2), ("dddot", 3), ("ddddot", 4)];
/// Signs of differences and variations.
pub const SIGNS_OF_DIFFERENCES: &[&str] = &[r"\Delta", r"\delta"];
pub const FRACTIONS: &[&str] = &["frac", "dfrac", "tfrac", "cfrac"];

/// Whether a style holds for the rest of its group.
pub fn is_switch(style: &str) -> bool {
    matches!(style, "bf" | "rm" | "cal")
}

/// Whether what stands above a name is a word in upright letters, and no transpose.
pub(super) fn is_upright_label(above: &[&str]) -> bool {
    let [r"\mathrm" | r"\text" | r"\rm" | r"\textrm", rest @ ..] = above else { return false };
    let word: String = rest.iter().filter(|t| !matches!(**t, "{" | "}")).copied().collect();
    !word.is_empty()
        && word.chars().all(|c| c.is_ascii_alphanumeric() || c == ' ')
        && !matches!(word.as_str(), "T" | "t" | "H" | "tr" | "d")
}
