//! What is known and not part of the formula language, by name.
//!
//! **In:** a command, or a refusal with its text. **Out:** the feature that is missing, one word for all its spellings, and what can be
//! written today. **Guaranteed:** a refusal with the code `latex::unsupported` at a command of the table has a feature.

use diag::Problem;

/// Something that formulas of papers have and the language has not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Feature {
    /// Its name: one word, or several with hyphens.
    pub name: &'static str,
    /// Why it is refused.
    pub(super) is_not: &'static str,
    /// What can be written today.
    pub(super) instead: &'static str,
    /// The commands that show it.
    commands: &'static [&'static str],
}

const FEATURES: &[Feature] = &[
    Feature {
        name: "integral",
        is_not: "integrals are not part of the formula language",
        instead: "write its result, or what its derivative is: `\\frac{dF}{dx}=f`",
        commands: &["int", "iint", "iiint", "oint", "oiint", "intop", "smallint"],
    },
    Feature {
        name: "sum",
        is_not: "sums are not part of the formula language",
        instead: "write out the terms, an index sum `u_iv_i`, or the result",
        commands: &["sum"],
    },
    Feature {
        name: "product",
        is_not: "products over an index are not part of the formula language",
        instead: "write out the factors, or the result",
        commands: &["prod", "coprod"],
    },
    Feature {
        name: "approximation",
        is_not: "an approximation is no relation that can be checked",
        instead: "write the equation that holds, or two inequalities; a claim may have a tolerance",
        commands: &[
            "approx",
            "approxeq",
            "simeq",
            "sim",
            "cong",
            "asymp",
            "propto",
            "ll",
            "gg",
            "lesssim",
            "gtrsim",
            "doteq",
            "order",
            "lessapprox",
            "gtrapprox",
        ],
    },
    Feature {
        name: "bra-ket",
        is_not: "vectors and averages in angle brackets are not part of the formula language",
        instead: "declare a name for the average or the matrix element, `n_a`; a vector of two or three components is written `pmatrix`",
        commands: &[
            "bra",
            "ket",
            "braket",
            "Bra",
            "Ket",
            "Braket",
            "ketbra",
            "dyad",
            "mel",
            "ev",
            "expval",
            "expectationvalue",
            "ip",
            "innerproduct",
            "outerproduct",
            "matrixelement",
            "langle",
            "rangle",
        ],
    },
    Feature {
        name: "infinity",
        is_not: "infinity is not a number",
        instead: r"write a limit, `\lim_{t\to\infty}`",
        commands: &["infty"],
    },
    Feature {
        name: "implication",
        is_not: "an implication is no relation",
        instead: "write a claim for what is given, and one for what follows with `follows-from`; or put what is given under `assuming`",
        commands: &[
            "Rightarrow",
            "implies",
            "Longrightarrow",
            "Leftrightarrow",
            "iff",
            "Longleftrightarrow",
            "Leftarrow",
            "impliedby",
            "therefore",
            "because",
            "Longleftarrow",
        ],
    },
    Feature {
        name: "dots",
        is_not: "dots stand for something that is not written",
        instead: "write out what is meant; for several values of a symbol a trajectory for each, a `[[family]]`, or `ranges`",
        commands: &["ldots", "dots", "cdots", "dotsc", "dotsb", "dotsm", "vdots", "ddots", "dotsi", "dotso"],
    },
    Feature {
        name: "set",
        is_not: "sets and quantifiers are not part of the formula language",
        instead: "give ranges under `ranges`, or inequalities under `assuming`",
        commands: &[
            "in",
            "notin",
            "ni",
            "subset",
            "subseteq",
            "supset",
            "cup",
            "cap",
            "setminus",
            "emptyset",
            "forall",
            "exists",
            "mid",
            "bigcup",
            "bigcap",
            "varnothing",
        ],
    },
    Feature {
        name: "tensor-product",
        is_not: "tensor products are not part of the formula language",
        instead: "write matrices out, or components",
        commands: &["otimes", "oplus", "wedge", "bigotimes", "bigoplus", "odot", "star", "ast"],
    },
    Feature {
        name: "extremum",
        is_not: "extrema are not part of the formula language",
        instead: "write the value, or the inequality that says it",
        commands: &["max", "min", "sup", "inf", "argmax", "argmin", "limsup", "liminf"],
    },
    Feature {
        name: "arrow",
        is_not: "an arrow is no relation",
        instead: r"write `\lim_{t\to t_0}… = …`, or what is put for what as an equation",
        commands: &[
            "longrightarrow",
            "mapsto",
            "longmapsto",
            "xrightarrow",
            "xleftarrow",
            "leftarrow",
            "leftrightarrow",
            "rightleftharpoons",
            "gets",
            "uparrow",
            "downarrow",
            "hookrightarrow",
        ],
    },
    Feature {
        name: "modulus",
        is_not: "remainders are not part of the formula language",
        instead: r"write `\lfloor x\rfloor`, the whole part",
        commands: &["mod", "bmod", "pmod"],
    },
    Feature {
        name: "reference",
        is_not: "a reference is no part of a formula",
        instead: "write it into the text",
        commands: &["ref", "eqref", "cite", "footnote", "footnotemark"],
    },
];

/// The feature that a command shows.
pub(super) fn of_command(command: &str) -> Option<&'static Feature> {
    FEATURES.iter().find(|f| f.commands.contains(&command))
}

/// The feature that a command shows, wherever it stands.
pub fn feature_of(command: &str) -> Option<&'static Feature> {
    of_command(command)
}

/// What is missing in the language, where a text was refused for that: the feature that stands at the place of the problem.
pub fn feature(text: &str, problem: &Problem) -> Option<&'static Feature> {
    let at = text.get(problem.span.start..)?;
    let c = at.chars().next()?;
    let spelled = if c == '\\' { None } else { super::unicode::spelled(c) };
    let command = spelled.as_deref().unwrap_or(at).strip_prefix('\\')?;
    let letters = command.bytes().take_while(u8::is_ascii_alphabetic).count();
    let found = of_command(&command[..letters])?;
    matches!(problem.code, "latex::unsupported" | "latex::limit").then_some(found)
}
