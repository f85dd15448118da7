//! Commands that are letters, and those that change how a letter is printed.
//!
//! **In:** –. **Out:** tables. **Why:** what is a name is decided by what is printed, and this is all that prints one.

/// Letters of Greek that are names, with other commands that are.
pub const LETTERS: &[&str] = &[
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "varrho",
    "sigma",
    "varsigma",
    "tau",
    "upsilon",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Upsilon",
    "Phi",
    "Psi",
    "Omega",
    "varGamma",
    "varDelta",
    "varTheta",
    "varLambda",
    "varXi",
    "varPi",
    "varSigma",
    "varUpsilon",
    "varPhi",
    "varPsi",
    "varOmega",
    "ell",
    "hbar",
    "varpi",
    "aleph",
    "wp",
    "imath",
    "jmath",
    "varkappa",
];
pub const BOLD: &[&str] =
    &["mathbf", "boldsymbol", "bm", "vec", "bf", "pmb", "vb", "va", "vectorbold", "mathbfit", "overrightarrow"];
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
    "cal",
    "rm",
    "check",
    "breve",
];
pub const DOTS: &[(&str, usize)] = &[("dot", 1), ("ddot", 2), ("dddot", 3), ("ddddot", 4)];
pub const FRACTIONS: &[&str] = &["frac", "dfrac", "tfrac", "cfrac"];

/// Whether a style holds for the rest of its group.
pub fn is_switch(style: &str) -> bool {
    matches!(style, "bf" | "rm" | "cal")
}
