//! Messages of servers as they come and go: JSON, and to and from an editor a length before it.
//!
//! **In:** the bytes of a client. **Out:** messages, and answers to what is none. **Guaranteed:** memory is taken for bytes that have come,
//! not for those that are announced; a message that is not understood takes no other with it.

use std::io::{BufRead, Read, Write};

use meter::Defects;
use rederive::diag::values::bounded;
use rederive::paper::LARGEST_PAPER;
use serde_json::{Value, json};

use super::ending::Stop;

/// Longest message, in bytes: the largest text, in which each sign may be written with some more.
const LONGEST: u64 = 4 * LARGEST_PAPER;
/// Longest line before a message.
const LONGEST_LINE: u64 = 8 << 10;
/// Values of JSON that a message may have: a client sends texts, and few of them.
const MOST_VALUES: usize = 500_000;

pub(super) const NOT_JSON: i32 = -32700;
pub(super) const NO_REQUEST: i32 = -32600;
pub(super) const NO_METHOD: i32 = -32601;
pub(super) const NO_PARAMETER: i32 = -32602;
pub(super) const NOT_BEGUN: i32 = -32002;

/// The bytes of the next message; `None` where the editor is gone.
///
/// # Errors
/// Where one message ends and the next one begins cannot be known.
pub(super) fn next(input: &mut impl BufRead) -> Result<Option<Vec<u8>>, Stop> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        let read = input.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line)?;
        if line.last() != Some(&b'\n') {
            return if (read as u64) < LONGEST_LINE {
                Ok(None)
            } else {
                Err("what the editor sends is no message".into())
            };
        }
        let line = String::from_utf8_lossy(line.trim_ascii());
        if line.is_empty() {
            break;
        }
        let (name, value) = line.split_once(':').ok_or("a line before a message of the editor has no colon")?;
        if name.trim().eq_ignore_ascii_case("Content-Length") {
            let number: Option<u64> = value.trim().parse().ok();
            length = Some(number.ok_or_else(|| format!("the editor announces a message of `{}` bytes", value.trim()))?);
        }
    }
    let length = length.ok_or("a message of the editor has no Content-Length")?;
    if length > LONGEST {
        return Err(format!("the editor announces a message of {length} bytes, more than {LONGEST}").into());
    }
    let mut body = Vec::new();
    input.take(length).read_to_end(&mut body)?;
    Ok((body.len() as u64 == length).then_some(body))
}

/// The message in these bytes.
///
/// # Errors
/// The answer to what is no message.
pub(super) fn message(body: &[u8]) -> Result<Value, Value> {
    let refused = |code, why: &str| refused(&Value::Null, code, why);
    bounded(body, MOST_VALUES).map_err(|why| refused(NO_REQUEST, &format!("the message is not read: {why}")))?;
    match serde_json::from_slice(body) {
        Ok(message @ Value::Object(_)) => Ok(message),
        Ok(_) => Err(refused(NO_REQUEST, "a message is an object")),
        Err(error) => Err(refused(NOT_JSON, &format!("the message is not JSON: {error}"))),
    }
}

/// An answer that says why there is none.
pub(super) fn refused(id: &Value, code: i32, why: &str) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": why } })
}

/// The words for a panic that ended a piece of the work.
pub(super) fn defect(what: &str) -> String {
    format!("a defect of rederive, not of your file; please report it, with the file: {what}")
}

/// Shows an editor a panic that ended a piece of the work since then: all else was done.
pub(super) fn tell_of_defect(before: &Defects) {
    if let Some(what) = before.since() {
        let params = json!({ "type": 1, "message": defect(&what) });
        // Where the editor is gone, the talk ends.
        drop(send(&json!({ "jsonrpc": "2.0", "method": "window/showMessage", "params": params })));
    }
}

/// Sends a message.
pub(super) fn send(message: &Value) -> std::io::Result<()> {
    let text = message.to_string();
    let mut out = std::io::stdout().lock();
    write!(out, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    out.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_taken_apart() {
        let mut input: &[u8] =
            b"content-length: 2\r\nX: \xff\r\n\r\n{}Content-Length:3\n\n[1]Content-Length: 9\r\n\r\n{}";
        assert_eq!(next(&mut input).expect("a message"), Some(b"{}".to_vec()));
        assert_eq!(next(&mut input).expect("a message"), Some(b"[1]".to_vec()));
        assert_eq!(next(&mut input).expect("its end"), None);
        for wrong in ["0x5", "-1", "", "18446744073709551616", "9223372036854775808", "5000000000", "67108865"] {
            let text = format!("Content-Length: {wrong}\r\n\r\n{{}}");
            assert!(next(&mut text.as_bytes()).is_err(), "{wrong}");
        }
        for wrong in ["\r\n", "{}\r\n", "X: 3\r\n\r\n", &"x".repeat(10_000)] {
            assert!(next(&mut wrong.as_bytes()).is_err(), "{wrong}");
        }
    }

    #[test]
    fn what_is_no_message_has_an_answer() {
        let code = |body: &[u8]| message(body).expect_err("no message")["error"]["code"].clone();
        for body in [&b"\xff\xfe{}"[..], br#"{"a":"\ud800"}"#, "[".repeat(100_000).as_bytes(), b"{", b""] {
            assert_eq!(code(body), NOT_JSON);
        }
        for body in ["[]", "3", &format!("[{}1]", "1,".repeat(600_000))] {
            assert_eq!(code(body.as_bytes()), NO_REQUEST);
        }
        assert!(message(br#"{"method":"exit"}"#).is_ok());
    }
}
