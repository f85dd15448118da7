//! Numbers as texts, from which the same are read, to the last bit: JSON has no infinity, and most of its readers no 128 bits.

use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;

/// What is written as texts; for `#[serde(with = …)]`.
pub trait Exact: Sized {
    /// What is written.
    type Text: Serialize + DeserializeOwned;

    /// As it is written.
    fn text(&self) -> Self::Text;

    /// As it was read; `None` where it is nothing of the kind.
    fn read(text: Self::Text) -> Option<Self>;
}

macro_rules! numbers {
    ($($number:ty),*) => {
        $(impl Exact for $number {
            type Text = String;

            fn text(&self) -> String {
                format!("{self:?}")
            }

            fn read(text: String) -> Option<$number> {
                text.parse().ok()
            }
        })*
    };
}
numbers!(f64, i128);

impl<T: Exact, const N: usize> Exact for [T; N] {
    type Text = Vec<T::Text>;

    fn text(&self) -> Self::Text {
        self.iter().map(T::text).collect()
    }

    fn read(text: Self::Text) -> Option<[T; N]> {
        text.into_iter().map(T::read).collect::<Option<Vec<T>>>()?.try_into().ok()
    }
}

/// Pairs, which may be missing.
impl<T: Exact + Copy> Exact for Vec<Option<(T, T)>> {
    type Text = Vec<Option<Vec<T::Text>>>;

    fn text(&self) -> Self::Text {
        self.iter().map(|pair| pair.map(|(a, b)| [a, b].text())).collect()
    }

    fn read(text: Self::Text) -> Option<Self> {
        let pair = |text: Vec<T::Text>| <[T; 2]>::read(text).map(|[a, b]| (a, b));
        text.into_iter().map(|text| text.map_or(Some(None), |text| pair(text).map(Some))).collect()
    }
}

/// Keys of a map of JSON are texts: pairs are written instead.
impl Exact for BTreeMap<i64, u64> {
    type Text = Vec<(i64, u64)>;

    fn text(&self) -> Self::Text {
        self.iter().map(|(key, value)| (*key, *value)).collect()
    }

    fn read(text: Self::Text) -> Option<Self> {
        let pairs = text.len();
        // A key that comes twice is one too few.
        Some(text.into_iter().collect()).filter(|map: &Self| map.len() == pairs)
    }
}

pub fn serialize<T: Exact, S: Serializer>(of: &T, serializer: S) -> Result<S::Ok, S::Error> {
    of.text().serialize(serializer)
}

pub fn deserialize<'de, T: Exact, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    T::read(Deserialize::deserialize(deserializer)?).ok_or_else(|| D::Error::custom("these are not such numbers"))
}
