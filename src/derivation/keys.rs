//! Every key that a derivation file may have: its name, what its value may be, and what it means.
//!
//! The loader takes the names from here, the schema and the documentation take the rest: a key is listed once.

use super::role::ClaimRole;
use Kind::{
    Flag, Formula, Formulas, Id, Named, Other, Pair, Part, Parts, Positive, Text, Texts, Value, Values, Whole, Words,
};
use serde_json::json;

/// What the value of a key may be.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A text.
    Text,
    /// Several texts, or ids of something.
    Texts,
    /// The id of what the table is.
    Id,
    /// LaTeX.
    Formula,
    /// Several formulas.
    Formulas,
    /// A number, a formula, or an array of them.
    Value,
    /// Two of these.
    Pair,
    /// Values, each under a name.
    Values,
    /// `true` or `false`.
    Flag,
    /// One of these words.
    Words(&'static [&'static str]),
    /// A number above 0.
    Positive,
    /// A whole number from this on.
    Whole(u64),
    /// What has a definition of its own in the schema.
    Part(&'static str),
    /// Several of these.
    Parts(&'static str),
    /// Several of these, each under a name.
    Named(&'static str),
    /// Something else: its schema.
    Other(fn() -> serde_json::Value),
}

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// What its value may be.
    pub kind: Kind,
    /// What it means.
    pub says: &'static str,
}

macro_rules! tables {
    ($($(#[$doc:meta])* $name:ident = $table:literal { $($key:literal: $kind:expr, $says:literal;)* })*) => {
        $($(#[$doc])* pub const $name: &[&str] = &[$($key),*];)*

        /// Every table with the names of its keys, for the documentation and its test.
        pub const ALL: &[(&str, &[&str])] = &[$(($table, $name)),*];

        /// Every table with its keys, for the schema.
        pub const TABLES: &[(&str, &[Key])] =
            &[$(($table, &[$(Key { name: $key, kind: $kind, says: $says }),*])),*];
    };
}

tables! {
    /// The tables of a file.
    FILE = "file" {
        "derivation": Part("derivation"), "What is checked";
        "conventions": Other(|| json!({ "type": "object", "additionalProperties": { "type": "string" } })),
            "Any names with any texts: the report shows them";
        "symbols": Named("symbol"), "Every symbol of the formulas, under its LaTeX name in single quotes";
        "system": Named("system"), "Systems of differential equations, each under its id";
        "trajectory": Parts("trajectory"), "Motions on which claims are tried";
        "family": Parts("family"), "Many motions from one, by values that vary";
        "domain": Parts("domain"), "Boxes of values, with formulas for fields, that claims share";
        "claim": Parts("claim"), "What the paper claims";
        "measure": Parts("measure"), "Quantities to be measured";
        "condition": Parts("condition"), "Conditions that may explain where a claim holds";
        "picture": Parts("picture"), "Pictures of the motions for the report";
    }
    /// Keys of `[derivation]`.
    DERIVATION = "[derivation]" {
        "id": Id, "Name of the report's folder; without it, the file's name without .toml";
        "title": Text, "What the report is called";
        "concerns": Text, "The citation of what is checked";
        "source": Text, "Where the paper can be found";
        "remark": Text, "What a reader of the report should know";
        "encoded-by": Text, "Who wrote the file: sentences and remarks are theirs";
    }
    /// Keys of a symbol.
    SYMBOL = "[symbols]" {
        "role": Words(&["time", "state", "parameter", "observable", "abbreviation", "coordinate", "field", "constant"]),
            "What the symbol is";
        "shape": Other(|| json!({ "type": ["string", "integer"] })),
            "\"3\" for a vector, \"3x3\" for a matrix, \"diagonal 3\" for a diagonal matrix; nothing for a scalar";
        "unit": Text, "Its unit";
        "positive": Flag, "Every component is positive";
        "angle": Flag, "Its values along a motion are continued without jumps by 2π: of an observable";
        "complex": Flag, "Its values are complex numbers";
        "labelled": Flag, "A subscript at it is a label, and names no component: of a vector or matrix";
        "formula": Formula, "The definition of an observable or abbreviation";
        "scale": Formula, "The scale factor of a coordinate that is not Cartesian";
        "momentum-of": Formula, "The coordinate to which this momentum belongs";
        "velocity": Flag, "The field with which the derivative D/Dt moves";
        "arguments": Formulas, "Names of arguments: the abbreviation is then a function";
        "says": Text, "What it stands for";
    }
    /// Keys of `[system.…]`.
    SYSTEM = "[system.…]" {
        "says": Text, "What the system is";
        "label": Text, "The label of its equations in the paper's source";
        "states": Texts, "The unknowns of equations of motion";
        "fields": Texts, "The unknowns of partial differential equations";
        "equations": Formulas, "The equations, one or several in a string; only plain =";
    }
    /// Keys of `[[trajectory]]`.
    TRAJECTORY = "[[trajectory]]" {
        "id": Id, "Its id";
        "title": Text, "For the reader";
        "says": Text, "For the reader";
        "system": Text, "Integrated: the id of the system";
        "initial": Other(|| json!({ "type": "object", "additionalProperties": { "$ref": "#/definitions/initial" } })),
            "Integrated: the value of every state at the initial time";
        "constraints": Formulas, "Equations between the initial values: those that are guessed are solved for";
        "formula": Values, "Given by formulas: every state, in terms of time and parameters";
        "from": Text, "Computed from another trajectory: its id";
        "map": Values, "With `from`: states in terms of those of the other trajectory";
        "parameters": Values, "Values of parameters";
        "span": Pair, "First and last time";
        "initial-time": Value, "The time of the initial values";
    }
    /// Keys of an initial value that is solved for.
    GUESS = "initial" {
        "near": Value, "A guess: the value is the solution of the constraints near to it";
        "within": Value, "How far it may be from the guess; half of it unless given";
    }
    /// Keys of `[[family]]`.
    FAMILY = "[[family]]" {
        "id": Id, "Its id; no trajectory has it";
        "title": Text, "Its title";
        "says": Text, "For the reader";
        "of": Text, "The trajectory whose values are varied: its id";
        "vary": Named("varied"), "Parameters and initial values, each with how it varies";
        "draws": Whole(1), "How many members are drawn, for each point of the grid";
        "seed": Whole(0), "Which draws: the same seed gives the same members everywhere";
        "sequence": Words(&["random", "low-discrepancy"]),
            "How values are drawn: at random, which is so unless given, or from a sequence that fills space evenly";
        "where": Formulas, "Inequalities that every member satisfies; others are rejected and counted";
        "map": Other(|| json!({ "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2 })),
            "Two symbols of `vary`, to the right and upwards: the report shows where over these a claim holds";
        "boundary": Other(|| json!({ "type": "object", "additionalProperties": { "type": "number", "exclusiveMinimum": 0 } })),
            "Symbols of the map, each with the width to which the edge of where a claim holds is found along it";
    }
    /// Keys of `[[domain]]`.
    DOMAIN = "[[domain]]" {
        "id": Id, "Its id";
        "says": Text, "For the reader";
        "ranges": Values, "[from, to] for a range, one number or formula for a fixed value or a field";
    }
    /// Keys of a symbol that varies.
    VARIED = "vary" {
        "from": Value, "The first of several values in a row";
        "to": Value, "The last of them";
        "count": Whole(2), "How many there are";
        "spacing": Words(&["linear", "logarithmic"]),
            "Whether neighbours have the same difference, which is so unless given, or the same ratio";
        "values": Other(|| json!({ "type": "array", "items": { "$ref": "#/definitions/value" }, "minItems": 1 })), "These values";
        "uniform": Pair, "Drawn: the ends of a range in which all values are equally likely";
        "log-uniform": Pair, "Drawn: the ends of a range in which all logarithms are equally likely";
        "polar": Pair, "Drawn: the ends of a range of angles from a pole of a sphere, whose cosines are equally likely";
        "normal": Pair, "Drawn from a normal distribution: mean and standard deviation";
    }
    /// Keys that `[[claim]]` and `[[claim.reading]]` share.
    READING = "[[claim]] and [[claim.reading]]" {
        "id": Id, "Its id";
        "says": Text, "The claim in your own words; $…$ around a formula";
        "remark": Text, "What a reader should know, for instance why it fails";
        "printed": Flag, "false: the formulas are a variant of what the paper prints under the label";
        "role": Other(|| json!({ "enum": ClaimRole::ALL.map(ClaimRole::word) })),
            "What it is to the paper: what the paper says (unless given), may mean or needs, what is against it, what was added to compare, a lemma of the file, or a choice of the paper";
        "added": Flag, "true: short for role = \"added\": the paper does not say it; it was added for comparison";
        "symbols": Named("symbol"), "Symbols for this claim only";
        "assuming": Formulas, "Relations without which the claim does not apply";
        "follows-from": Texts, "Claims, systems and symbols from which it follows";
        "precision": Other(|| json!({ "type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 1 })),
            "The relative precision that is asked for, 1e-9 unless given";
        "branches": Words(&["pointwise", "throughout"]), "For ±: some sign at each time, or one sign for the whole motion";
        "trajectories": Texts, "Where it is tried; all unless given";
        "families": Texts, "Families of motions on which it is tried";
        "always": Formulas, "These relations hold at every time";
        "never": Formulas, "These relations hold at no time";
        "eventually": Formulas, "These relations hold at some time";
        "first-integral": Formulas, "These expressions are constant along the motion";
        "defined": Formulas, "These expressions have a real value at every time";
        "solves": Text, "The motion solves this system: its id";
        "same-motion": Part("same-motion"), "The motion is that of another trajectory";
        "independent": Part("independent"), "Functions of the states are independent of one another";
        "exists": Part("exists"), "Equations have a solution in a box";
        "independent-of": Part("independent-of"), "A quantity is the same for members of a family that differ in a symbol";
        "scales-as": Part("scales-as"), "A quantity is a power of a symbol that a family varies";
        "monotone": Part("monotone"), "A quantity grows, or falls, with a symbol that a family varies";
        "extremum": Part("extremum"), "A quantity is largest, or smallest, at a value of a symbol that a family varies";
        "limit": Part("limit"), "A quantity tends to a value as a symbol that a family varies tends to one";
        "domain": Text, "The claim is about the values of this domain: its id";
        "ranges": Values,
            "The claim is about all these values, and no motion: [from, to] for a range, one number or formula for a fixed value";
        "at": Part("at"), "When the claim is tried: an equation between scalars, or which of the times at which it holds";
        "expect": Part("expect"), "The expected verdict: one word, or trajectories for each verdict";
        "expect-units": Words(&["inconsistent"]), "The units of its formulas are expected not to agree";
    }
    /// Keys of `[[claim]]` beside those of a reading.
    CLAIM = "[[claim]]" {
        "place": Text, "Where it stands in the paper";
        "label": Text, "The label of its equation in the paper's source";
        "conclusion": Flag, "true: it is something that the paper concludes";
        "postulate": Flag, "true: it is stated, and not derived; whether it is so for all values is not asked";
        "rests-on": Texts, "Claims on which the paper's argument for it rests; nothing is proved from them";
        "reading": Parts("reading"), "The ways in which the claim can be understood";
    }
    /// Keys of an `at` that says which of the times are meant.
    AT = "at" {
        "when": Formula, "An equation between scalars";
        "direction": Words(&["up", "down"]), "The times at which left − right changes its sign, from − to + or from + to −";
        "count": Whole(1), "The n-th of them after the start of the span";
    }
    /// Keys of `same-motion`.
    SAME_MOTION = "same-motion" {
        "as": Text, "The id of the other trajectory";
        "of": Texts, "The states that are compared";
    }
    /// Keys of `independent`.
    INDEPENDENT = "independent" {
        "functions": Formulas, "The functions";
        "subject-to": Formulas, "Equations that hold between the states anyway";
    }
    /// Keys of `exists`.
    EXISTS = "exists" {
        "unknowns": Values, "The unknowns, each with the range [from, to] in which a solution is looked for";
        "such-that": Formulas, "As many equations as unknowns, and other relations that a solution satisfies";
        "unique": Flag, "There is one solution only";
    }
    /// Keys of `independent-of`.
    INDEPENDENT_OF = "independent-of" {
        "of": Formula, "The quantity, one number of each member";
        "with": Text, "The symbol that the family varies";
    }
    /// Keys of `scales-as`.
    SCALES_AS = "scales-as" {
        "of": Formula, "The quantity, one number of each member";
        "with": Text, "The symbol that the family varies";
        "power": Other(|| json!({ "type": "number" })), "The slope of the logarithms";
        "to": Positive, "How far the slope may be off";
    }
    /// Keys of `monotone`.
    MONOTONE = "monotone" {
        "of": Formula, "The quantity, one number of each member";
        "with": Text, "The symbol that the family varies";
        "direction": Words(&["increasing", "decreasing"]), "With larger values of the symbol the quantity is larger, or smaller";
    }
    /// Keys of `extremum`.
    EXTREMUM = "extremum" {
        "of": Formula, "The quantity, one number of each member";
        "with": Text, "The symbol that the family varies";
        "kind": Words(&["maximum", "minimum"]), "Whether it is largest or smallest";
        "at": Value, "The value of the symbol at which it is";
        "to": Positive, "From which distance on other values of the symbol are compared";
    }
    /// Keys of `limit`.
    LIMIT = "limit" {
        "of": Formula, "The quantity, one number of each member";
        "with": Text, "The symbol that the family varies";
        "tends-to": Value, "What the symbol tends to: a number, '\\infty' or '-\\infty'";
        "value": Value, "The limit";
        "to": Positive, "How far the limit may be off";
    }
    /// Keys of `expect`: the verdicts.
    EXPECT = "expect" {
        "holds": Other(some_of_them), "Trajectories and families on which this verdict is expected";
        "fails": Other(some_of_them), "Trajectories and families on which this verdict is expected";
        "not-applicable": Other(some_of_them), "Trajectories and families on which this verdict is expected";
        "undecided": Other(some_of_them), "Trajectories and families on which this verdict is expected";
    }
    /// Keys of `[[measure]]`.
    MEASURE = "[[measure]]" {
        "id": Id, "Its id";
        "says": Text, "What it is";
        "formula": Formula, "A scalar";
        "at": Part("at"), "When it is taken; without it, at the initial time";
        "since": Part("at"), "Another event: what is taken is taken between the last of it before `at`, and `at`";
        "take": Words(&["change", "mean"]),
            "With `since`: the change of the quantity, which is so unless given, or its mean over the time between";
        "trajectories": Texts, "Where it is measured; all unless given";
        "families": Texts, "Families on whose members it is measured, too";
        "unit": Text, "Its unit";
    }
    /// Keys of `[[condition]]`.
    CONDITION = "[[condition]]" {
        "id": Id, "Its id";
        "says": Text, "What it is, in words";
        "holds": Formulas, "It is met where all of these hold at every time";
    }
    /// Keys of `[[picture]]`.
    PICTURE = "[[picture]]" {
        "id": Id, "Its id";
        "says": Text, "What it shows";
        "kind": Words(&["time", "curve", "sphere"]), "Quantities against time, one against another, or three of constant length";
        "show": Formulas, "The quantities";
        "slopes": Formulas, "For a curve: slopes that are claimed of it";
        "levels": Formula, "For a sphere: a function whose level sets are drawn";
        "trajectories": Texts, "Of which it is drawn; all unless given";
    }
}

/// For verdicts: trajectories and families on which one is expected.
fn some_of_them() -> serde_json::Value {
    json!({ "anyOf": [{ "enum": ["all", "others"] }, { "type": "array", "items": { "type": "string" } }] })
}
