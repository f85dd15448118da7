//! What a field of the document may be: objects and words that serde writes and schemars describes, values by their names, numbers.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};

/// Objects of the document, each with the function `of` that makes it.
macro_rules! objects {
    ($(
        $(#[$meta:meta])*
        $name:ident $(<$life:lifetime>)? of ($($input:ident: $of:ty),+) $(let $part:pat = $found:expr;)* {
            $($(#[$about:meta])* $field:ident: $type:ty = $value:expr,)+
        }
    )+) => {$(
        #[derive(serde::Serialize, schemars::JsonSchema)]
        $(#[$meta])*
        pub struct $name $(<$life>)? {
            $($(#[$about])* pub $field: $type,)+
        }

        impl $(<$life>)? $name $(<$life>)? {
            pub fn of($($input: $of),+) -> Self {
                $(let $part = $found;)*
                Self { $($field: $value,)+ }
            }
        }
    )+};
}
pub(super) use objects;

/// Words of the document, of which the schema has no others.
macro_rules! words {
    ($($(#[$meta:meta])* $name:ident: $($word:literal)|+;)+) => {$(
        $(#[$meta])*
        #[derive(serde::Serialize)]
        pub struct $name(pub &'static str);

        impl JsonSchema for $name {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({ "type": "string", "enum": [$($word),+] })
            }
        }
    )+};
}

words! {
    /// What became of a claim.
    Verdict: "holds" | "fails" | "not-applicable" | "undecided";
    /// How strong its evidence is.
    Strength: "sampled" | "enclosed" | "certified" | "proved";
    /// The same of a claim over ranges, which is not sampled.
    RangesStrength: "enclosed" | "certified" | "proved";
    /// The same of a family.
    FamilyStrength: "sampled";
    /// What became of a step for all values.
    StepVerdict: "proved" | "refuted" | "undecided";
    /// The same in full.
    StepStanding: "proved" | "proved except" | "proved given" | "proved unreplayed" | "proved except unreplayed" | "proved given unreplayed" | "refuted" | "undecided";
    /// How a trajectory comes about.
    Origin: "integrated" | "formula" | "derived";
    /// Whether the units of a formula agree.
    UnitsVerdict: "consistent" | "inconsistent" | "not-checked";
    /// How conditions are put together.
    Join: "and" | "or";
    /// Whether a claim needs an assumption.
    Need: "needed" | "not-needed" | "undecided" | "untested";
    /// One of two verdicts.
    Decided: "holds" | "fails";
    /// What a node of the graph is.
    NodeKind: "claim" | "system" | "symbol";
}

/// Values by their names, in the order of the account.
pub struct Named<'a, T>(pub Vec<(&'a str, T)>);

impl<'a, T> Named<'a, T> {
    pub fn of<U>(values: &'a [(String, U)], value: impl Fn(&'a U) -> T) -> Self {
        Named(values.iter().map(|(name, x)| (name.as_str(), value(x))).collect())
    }
}

impl<T: Serialize> Serialize for Named<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<T: JsonSchema> JsonSchema for Named<'_, T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Named".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        BTreeMap::<String, T>::json_schema(generator)
    }
}

/// For a field that is there only where it is true.
pub fn is_false(value: &bool) -> bool {
    !value
}

/// A number that is one.
#[derive(Serialize)]
pub struct Finite(pub f64);

impl JsonSchema for Finite {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Finite".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "number" })
    }
}
