//! Every key that a derivation file may have.

/// The tables of a file.
pub const FILE: &[&str] = &[
    "derivation",
    "conventions",
    "symbols",
    "system",
    "trajectory",
    "family",
    "domain",
    "claim",
    "measure",
    "condition",
    "picture",
];
/// Keys of `[derivation]`.
pub const DERIVATION: &[&str] = &["id", "title", "concerns", "source", "remark", "encoded-by"];
/// Keys of a symbol.
pub const SYMBOL: &[&str] = &[
    "role",
    "shape",
    "unit",
    "positive",
    "angle",
    "complex",
    "formula",
    "scale",
    "momentum-of",
    "velocity",
    "arguments",
    "says",
];
/// Keys of `[system.…]`.
pub const SYSTEM: &[&str] = &["says", "label", "states", "fields", "equations"];
/// Keys of `[[trajectory]]`.
pub const TRAJECTORY: &[&str] = &[
    "id",
    "title",
    "says",
    "system",
    "initial",
    "constraints",
    "formula",
    "from",
    "map",
    "parameters",
    "span",
    "initial-time",
];
/// Keys of an initial value that is solved for.
pub const GUESS: &[&str] = &["near", "within"];
/// Keys of `[[family]]`.
pub const FAMILY: &[&str] =
    &["id", "title", "says", "of", "vary", "draws", "seed", "sequence", "where", "map", "boundary"];
/// Keys of `[[domain]]`.
pub const DOMAIN: &[&str] = &["id", "says", "ranges"];
/// Keys of a symbol that varies.
pub const VARIED: &[&str] = &["from", "to", "count", "spacing", "values", "uniform", "log-uniform", "polar", "normal"];
/// Keys that `[[claim]]` and `[[claim.reading]]` share.
pub const READING: &[&str] = &[
    "id",
    "says",
    "remark",
    "printed",
    "role",
    "added",
    "symbols",
    "assuming",
    "follows-from",
    "precision",
    "branches",
    "trajectories",
    "families",
    "always",
    "never",
    "eventually",
    "first-integral",
    "defined",
    "solves",
    "same-motion",
    "independent",
    "exists",
    "independent-of",
    "scales-as",
    "monotone",
    "extremum",
    "limit",
    "domain",
    "ranges",
    "at",
    "expect",
    "expect-units",
];
/// Keys of `[[claim]]` beside those of a reading.
pub const CLAIM: &[&str] = &["place", "label", "conclusion", "rests-on", "reading"];
/// Keys of an `at` that says which of the times are meant.
pub const AT: &[&str] = &["when", "direction", "count"];
/// Keys of `same-motion`.
pub const SAME_MOTION: &[&str] = &["as", "of"];
/// Keys of `independent`.
pub const INDEPENDENT: &[&str] = &["functions", "subject-to"];
/// Keys of `exists`.
pub const EXISTS: &[&str] = &["unknowns", "such-that", "unique"];
/// Keys of `independent-of`.
pub const INDEPENDENT_OF: &[&str] = &["of", "with"];
/// Keys of `scales-as`.
pub const SCALES_AS: &[&str] = &["of", "with", "power", "to"];
/// Keys of `monotone`.
pub const MONOTONE: &[&str] = &["of", "with", "direction"];
/// Keys of `extremum`.
pub const EXTREMUM: &[&str] = &["of", "with", "kind", "at", "to"];
/// Keys of `limit`.
pub const LIMIT: &[&str] = &["of", "with", "tends-to", "value", "to"];
/// Keys of `expect`: the verdicts.
pub const EXPECT: &[&str] = &["holds", "fails", "not-applicable", "undecided"];
/// Keys of `[[measure]]`.
pub const MEASURE: &[&str] = &["id", "says", "formula", "at", "since", "take", "trajectories", "families", "unit"];
/// Keys of `[[condition]]`.
pub const CONDITION: &[&str] = &["id", "says", "holds"];
/// Keys of `[[picture]]`.
pub const PICTURE: &[&str] = &["id", "says", "kind", "show", "slopes", "levels", "trajectories"];

/// Every table with its keys, for the documentation and its test.
pub const ALL: &[(&str, &[&str])] = &[
    ("file", FILE),
    ("[derivation]", DERIVATION),
    ("[symbols]", SYMBOL),
    ("[system.…]", SYSTEM),
    ("[[trajectory]]", TRAJECTORY),
    ("initial", GUESS),
    ("[[family]]", FAMILY),
    ("[[domain]]", DOMAIN),
    ("vary", VARIED),
    ("[[claim]] and [[claim.reading]]", READING),
    ("[[claim]]", CLAIM),
    ("at", AT),
    ("same-motion", SAME_MOTION),
    ("independent", INDEPENDENT),
    ("exists", EXISTS),
    ("independent-of", INDEPENDENT_OF),
    ("scales-as", SCALES_AS),
    ("monotone", MONOTONE),
    ("extremum", EXTREMUM),
    ("limit", LIMIT),
    ("expect", EXPECT),
    ("[[measure]]", MEASURE),
    ("[[condition]]", CONDITION),
    ("[[picture]]", PICTURE),
];
