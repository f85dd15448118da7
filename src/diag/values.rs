//! How many values a text in JSON has, before anything is made of it.
//!
//! **In:** the bytes of a text that a stranger may have written. **Out:** the text may be read, or it has more values than are read.
//! **Why this way:** a value of one byte takes a hundred once it is read, so that a bound of the bytes alone bounds no memory.

/// A report with more values than this is not read. The largest report of this project has two million, in its proofs.
pub const MOST_VALUES: usize = 5_000_000;

/// Whether a text has at most so many values.
///
/// # Errors
/// A sentence that says so.
pub fn bounded(json: &[u8], most: usize) -> Result<(), String> {
    match values(json) {
        n if n > most => Err(format!("it has more than {most} values of JSON, which is more than is read")),
        _ => Ok(()),
    }
}

/// The values of a text, or some more: each stands behind a bracket or a comma, or is the whole.
fn values(json: &[u8]) -> usize {
    let (mut found, mut in_text, mut escaped) = (1, false, false);
    for byte in json {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = in_text,
            b'"' => in_text = !in_text,
            b',' | b'[' | b'{' if !in_text => found += 1,
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_counted_and_signs_in_texts_are_not() {
        assert_eq!(values(b"1"), 1);
        assert_eq!(values(br#"[1,2,{"a":[3,4],"b,[{":"\",[{\\","c":5}]"#), 9);
        assert_eq!(values(br#"["\\",",",1]"#), 4);
        assert_eq!(values(&[b'['; 10_000]), 10_001);
        let of = |n: usize| ["[", &"1,".repeat(n), "1]"].concat();
        assert!(bounded(of(1000).as_bytes(), 2000).is_ok());
        assert!(bounded(of(2000).as_bytes(), 2000).is_err_and(|why| why.contains("more than 2000 values")));
    }
}
