//! Signs between the sides of a printed relation, by what they say.

/// Signs that say that two sides are equal.
pub const EQUALS: &[&str] = &["=", r"\equiv", "≡", ":=", "=:", r"\coloneqq", r"\coloneq", r"\eqqcolon", r"\triangleq"];
/// Those of them that define the side before them, or behind them: that sides differ is no mistake.
pub const DEFINES: &[&str] = &[":=", "=:", r"\coloneqq", r"\coloneq", r"\eqqcolon", r"\triangleq"];
/// Those of these that define the side behind them.
const DEFINES_BEHIND: &[&str] = &["=:", r"\eqqcolon"];
/// Characters that say that they are about equal.
const ABOUT: &[&str] = &["≈", "∼", "∝", "≪", "≫"];
/// Commands that do so, and of which the formula language has nothing to say.
const ABOUT_HERE: &[&str] = &[r"\eqsim", r"\thickapprox", r"\thicksim"];
/// Signs that compare.
pub const COMPARES: &[&str] = &[
    "<",
    ">",
    r"\le",
    r"\leq",
    r"\ge",
    r"\geq",
    r"\ne",
    r"\neq",
    r"\lt",
    r"\gt",
    r"\leqslant",
    r"\geqslant",
    r"\in",
    r"\notin",
    "≤",
    "≥",
    "≠",
    r"\not=",
    r"\subset",
    r"\subseteq",
];

/// Whether a sign says that two sides are about equal: what is an approximation in the formula language is one here.
pub fn is_about(sign: &str) -> bool {
    let feature = sign.strip_prefix('\\').and_then(latex::feature_of);
    is_one_of(ABOUT, sign) || is_one_of(ABOUT_HERE, sign) || feature.is_some_and(|f| f.name == "approximation")
}

/// Whether a sign defines the side behind it, and not the one before it; `None` where it defines none.
pub fn defines_behind(sign: &str) -> Option<bool> {
    is_one_of(DEFINES, sign).then(|| is_one_of(DEFINES_BEHIND, sign))
}

/// Whether a sign is one of a kind.
pub fn is_one_of(kind: &[&str], sign: &str) -> bool {
    kind.contains(&sign)
}

/// The places of a sign in a text. A command ends where its letters end: `\part` stands nowhere in `\partial`.
pub(super) fn places_of<'t>(text: &'t str, sign: &'t str) -> impl Iterator<Item = usize> {
    let is_command = sign.strip_prefix('\\').is_some_and(|name| name.chars().all(|c| c.is_ascii_alphabetic()));
    let goes_on = move |at: usize| text[at + sign.len()..].starts_with(|c: char| c.is_ascii_alphabetic());
    text.match_indices(sign).map(|(at, _)| at).filter(move |at| !is_command || !goes_on(*at))
}

/// Whether one of some signs stands in a text.
pub(super) fn has_sign(text: &str, signs: &[&str]) -> bool {
    signs.iter().any(|sign| places_of(text, sign).next().is_some())
}
