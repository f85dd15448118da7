//! How a text is refused, and how deep it may be nested.
//!
//! Shared by everything that looks at tokens. A refusal has a code, a place in the text, and a hint on how to write it.

use std::ops::Range;

use diag::Problem;

/// Deepest nesting of brackets, braces, roots, fractions, accents and operators.
pub(super) const DEEPEST: usize = 100;

/// What was understood, or why it is refused.
pub(super) type Parsed<T> = Result<T, Box<Problem>>;

/// Refuses a text; an empty hint is none.
pub(super) fn refuse<T>(
    code: &'static str,
    message: impl Into<String>,
    span: Range<usize>,
    hint: impl Into<String>,
) -> Parsed<T> {
    let hint = hint.into();
    Err(Box::new(Problem { code, message: message.into(), span, hint: (!hint.is_empty()).then_some(hint) }))
}

/// [`refuse`] at a place that is used again.
pub(super) fn refuse_at<T>(
    code: &'static str,
    message: impl Into<String>,
    span: &Range<usize>,
    hint: impl Into<String>,
) -> Parsed<T> {
    refuse(code, message, span.clone(), hint)
}
