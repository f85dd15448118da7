//! Whether two texts in JSON say the same, without either in memory as values.
//!
//! **In:** a text. **Out:** a sum of what it says, whatever its layout and the order of its keys. **Guaranteed:** other values have other
//! sums, but for chance; a key that comes twice is not the same as one that comes once.

use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use sha2::{Digest, Sha256};

/// The sum of what a text says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fingerprint([u8; 32]);

impl Fingerprint {
    fn of(kind: u8, bytes: &[u8]) -> Fingerprint {
        Fingerprint(Sha256::new_with_prefix([kind]).chain_update(bytes).finalize().into())
    }
}

impl<'de> Deserialize<'de> for Fingerprint {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Fingerprint, D::Error> {
        from.deserialize_any(Summing)
    }
}

struct Summing;

impl<'de> Visitor<'de> for Summing {
    type Value = Fingerprint;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a value of JSON")
    }

    fn visit_unit<E>(self) -> Result<Fingerprint, E> {
        Ok(Fingerprint::of(0, &[]))
    }

    fn visit_bool<E>(self, is: bool) -> Result<Fingerprint, E> {
        Ok(Fingerprint::of(1, &[u8::from(is)]))
    }

    fn visit_u64<E>(self, n: u64) -> Result<Fingerprint, E> {
        Ok(Fingerprint::of(2, &n.to_le_bytes()))
    }

    fn visit_i64<E>(self, n: i64) -> Result<Fingerprint, E> {
        Ok(Fingerprint::of(3, &n.to_le_bytes()))
    }

    fn visit_f64<E>(self, x: f64) -> Result<Fingerprint, E> {
        Ok(Fingerprint::of(4, &x.to_le_bytes()))
    }

    fn visit_str<E>(self, text: &str) -> Result<Fingerprint, E> {
        Ok(Fingerprint::of(5, text.as_bytes()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut all: A) -> Result<Fingerprint, A::Error> {
        let mut sum = Sha256::new_with_prefix([6]);
        while let Some(Fingerprint(of)) = all.next_element()? {
            sum.update(of);
        }
        Ok(Fingerprint(sum.finalize().into()))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut all: A) -> Result<Fingerprint, A::Error> {
        // The sums of the entries are added up, whatever their order, as numbers of four words.
        let mut words = [0_u64; 5];
        while let Some((Fingerprint(key), Fingerprint(value))) = all.next_entry()? {
            let Fingerprint(entry) = Fingerprint::of(7, &[key, value].concat());
            for (word, part) in words.iter_mut().zip(entry.as_chunks::<8>().0) {
                *word = word.wrapping_add(u64::from_le_bytes(*part));
            }
            words[4] += 1;
        }
        Ok(Fingerprint::of(8, &words.map(u64::to_le_bytes).concat()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_in_another_layout_has_the_same_sum() {
        let of = |text: &str| serde_json::from_str::<Fingerprint>(text).expect("JSON");
        let one = of(r#"{"a":[1,-2,0.5,null,true],"b":{"c":"\u0064"}}"#);
        assert_eq!(one, of("{ \"b\": {\"c\":\"d\"}, \"a\": [1, -2, 5e-1, null, true] }"));
        let others = [
            r#"{"a":[1,-2,0.5,null,true],"b":{"c":"d"},"e":1}"#,
            r#"{"a":[1,-2,0.5,null,true],"b":{"c":"e"}}"#,
            r#"{"a":[1,-2,0.5,null,true],"b":{"c":"d"},"b":{"c":"d"}}"#,
            r#"{"a":[-2,1,0.5,null,true],"b":{"c":"d"}}"#,
            r#"{"a":[1,-2,0.5,null,false],"b":{"c":"d"}}"#,
            r#"{"a":[1.0,-2,0.5,null,true],"b":{"c":"d"}}"#,
            r#"{"a":[1,-2,0.5,[],true],"b":{"c":"d"}}"#,
            r#"{"a":[1,-2,0.5,{},true],"b":{"c":"d"}}"#,
        ];
        for other in others {
            assert_ne!(one, of(other), "{other}");
        }
        assert!(serde_json::from_str::<Fingerprint>("[1,").is_err());
    }
}
