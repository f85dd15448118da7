//! The tables of a file, read with every problem noted and none fatal.

use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use diag::escape::{in_one_line, shown};
use diag::{Diagnostic, Label, Source, nearest};
use files::is_portable;
use latex::printed;

/// A value and its place.
pub(super) type Value<'s> = Spanned<DeValue<'s>>;

/// The problems of one file.
pub(super) struct Problems<'s> {
    pub source: &'s Arc<Source>,
    pub found: Vec<Diagnostic>,
}

impl Problems<'_> {
    /// Notes a problem; the diagnostic is returned for hints.
    pub fn note(&mut self, code: &'static str, span: Range<usize>, message: impl Into<String>) -> Noted<'_> {
        self.found.push(Diagnostic::at(self.source, code, span, message));
        Noted(self.found.last_mut())
    }

    /// Notes that the value of a key has the wrong type.
    pub fn wrong_type(&mut self, value: &Value<'_>, key: &str, wanted: &str) {
        self.wrong_type_of(value, &format!("`{key}`"), wanted);
    }

    fn wrong_type_of(&mut self, value: &Value<'_>, what: &str, wanted: &str) {
        let found = match value.get_ref() {
            DeValue::String(_) => "a string",
            DeValue::Integer(_) => "an integer",
            DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "a boolean",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "an array",
            DeValue::Table(_) => "a table",
        };
        self.note("derivation::wrong-type", value.span(), format!("{what} must be {wanted}, not {found}"));
    }

    /// Notes that a name is not known.
    pub fn unknown<'k>(
        &mut self,
        code: &'static str,
        span: Range<usize>,
        what: &str,
        name: &str,
        known: impl IntoIterator<Item = &'k str> + Clone,
    ) {
        let near = nearest(name, known.clone());
        let noted = self.note(code, span, format!("there is no {what} `{name}`"));
        let mut names = known.into_iter();
        let few: Vec<String> = names.by_ref().take(8).map(|k| format!("`{k}`")).collect();
        match near {
            Some(near) => noted.hint(format!("did you mean `{near}`?")),
            None if few.is_empty() => noted,
            None if names.next().is_some() => noted.hint(format!("known are {}, …", few.join(", "))),
            None => noted.hint(format!("known: {}", few.join(", "))),
        };
    }
}

/// A diagnostic that was just noted.
pub(super) struct Noted<'d>(Option<&'d mut Diagnostic>);

impl Noted<'_> {
    pub fn hint(self, hint: impl Into<String>) -> Self {
        if let Noted(Some(diagnostic)) = self {
            diagnostic.hint = Some(hint.into());
            return Noted(Some(diagnostic));
        }
        self
    }
    pub fn see(self, span: Range<usize>, text: &str) -> Self {
        if let Noted(Some(diagnostic)) = self {
            diagnostic.other = Some(Label { span, text: text.to_owned() });
            return Noted(Some(diagnostic));
        }
        self
    }
}

/// A formula as the file has it: a literal string.
#[derive(Clone, Debug)]
pub(super) struct Literal<'a> {
    /// The formula.
    pub text: &'a str,
    /// Place of its first byte in the file.
    pub start: usize,
    /// Place of the whole string, quotes included.
    pub span: Range<usize>,
}

impl Literal<'_> {
    /// The formula without what is not set: what is kept of it.
    pub fn printed(&self) -> String {
        as_printed(self.text)
    }
}

/// A formula without what is not set; a text that is no formula, as it may be shown.
pub(super) fn as_printed(text: &str) -> String {
    printed(text).unwrap_or_else(|| shown(text.trim()).into_owned())
}

/// One table.
#[derive(Clone)]
pub(super) struct Table<'a, 's> {
    pub entries: &'a DeTable<'s>,
    /// Its place: the header, or the braces.
    pub span: Range<usize>,
    /// What it describes, for messages: `[[claim]]`.
    pub what: &'static str,
}

impl<'a, 's> Table<'a, 's> {
    /// The table in `value`, whose keys must be among `keys`.
    pub fn open(problems: &mut Problems<'_>, value: &'a Value<'s>, what: &'static str, keys: &[&str]) -> Option<Self> {
        let DeValue::Table(entries) = value.get_ref() else {
            problems.wrong_type_of(value, what, "a table");
            return None;
        };
        let table = Table { entries, span: value.span(), what };
        table.check_keys(problems, keys);
        Some(table)
    }

    /// Notes every key that is not among `keys`.
    pub fn check_keys(&self, problems: &mut Problems<'_>, keys: &[&str]) {
        for key in self.entries.keys().filter(|k| !keys.contains(&k.get_ref().as_ref())) {
            let name = key.get_ref().as_ref();
            let noted =
                problems.note("derivation::unknown-key", key.span(), format!("{} has no key `{name}`", self.what));
            match nearest(name, keys.iter().copied()) {
                Some(near) => noted.hint(format!("did you mean `{near}`?")),
                None => noted.hint(format!("its keys are {}", keys.join(", "))),
            };
        }
    }

    pub fn get(&self, key: &str) -> Option<&'a Value<'s>> {
        self.entries.get(key)
    }

    /// Notes that `key` is missing.
    pub fn missing(&self, problems: &mut Problems<'_>, key: &str) {
        problems.note("derivation::missing-key", self.span.clone(), format!("{} needs `{key}`", self.what));
    }

    /// A text, not a formula, in one line: a line break in it could forge a line of what is printed.
    pub fn text(&self, problems: &mut Problems<'_>, key: &str) -> Option<String> {
        let value = self.get(key)?;
        text_of(problems, value, key).map(in_one_line)
    }

    /// A text that must be there and say something.
    pub fn needed_text(&self, problems: &mut Problems<'_>, key: &str) -> Option<String> {
        let Some(value) = self.get(key) else {
            self.missing(problems, key);
            return None;
        };
        let text = in_one_line(text_of(problems, value, key)?);
        if text.is_empty() {
            problems.note("derivation::missing-key", value.span(), format!("`{key}` is empty"));
            return None;
        }
        Some(text)
    }

    pub fn boolean(&self, problems: &mut Problems<'_>, key: &str) -> Option<bool> {
        let value = self.get(key)?;
        let found = value.get_ref().as_bool();
        if found.is_none() {
            problems.wrong_type(value, key, "true or false");
        }
        found
    }

    /// An id: letters, digits, `-`, `_` and `.`, beginning with a letter or digit.
    pub fn id(&self, problems: &mut Problems<'_>, key: &str) -> Option<(String, Range<usize>)> {
        let text = self.needed_text(problems, key)?;
        let span = self.get(key)?.span();
        check_id(problems, &text, span.clone()).then_some((text, span))
    }

    /// An array, or nothing.
    pub fn array(&self, problems: &mut Problems<'_>, key: &str, of: &str) -> &'a [Value<'s>] {
        match self.get(key).map(|v| (v, v.get_ref())) {
            None => &[],
            Some((_, DeValue::Array(items))) => items,
            Some((value, _)) => {
                problems.wrong_type(value, key, &format!("an array of {of}"));
                &[]
            }
        }
    }

    /// An array of names of things in the file, each with its place.
    pub fn names(&self, problems: &mut Problems<'_>, key: &str) -> Vec<(&'a str, Range<usize>)> {
        let items = self.array(problems, key, "ids");
        items.iter().filter_map(|v| Some((text_of(problems, v, key)?, v.span()))).collect()
    }

    /// An array of formulas.
    pub fn formulas(&self, problems: &mut Problems<'_>, key: &str) -> Vec<Literal<'a>> {
        let items = self.array(problems, key, "formulas");
        items.iter().filter_map(|v| literal_of(problems, v, key)).collect()
    }

    /// One formula.
    pub fn formula(&self, problems: &mut Problems<'_>, key: &str) -> Option<Literal<'a>> {
        literal_of(problems, self.get(key)?, key)
    }
}

/// Notes an id that cannot be used as one.
pub(super) fn check_id(problems: &mut Problems<'_>, id: &str, span: Range<usize>) -> bool {
    let allowed = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    let good = id.starts_with(|c: char| c.is_ascii_alphanumeric()) && id.chars().all(allowed) && id.len() <= 100;
    if good && !is_portable(id) {
        problems
            .note(
                "derivation::bad-id",
                span,
                format!("`{id}` cannot be an id: it cannot be the name of a file on Windows"),
            )
            .hint("do not end it with a dot, and do not call it con, prn, aux, nul, com1 … or lpt1 …");
        return false;
    }
    if !good {
        let message = format!("`{id}` cannot be an id");
        problems
            .note("derivation::bad-id", span, message)
            .hint("use letters a–z, digits, `-`, `_` and `.`, beginning with a letter or digit, at most 100 of them");
    }
    good
}

/// The text of a string.
pub(super) fn text_of<'a>(problems: &mut Problems<'_>, value: &'a Value<'_>, key: &str) -> Option<&'a str> {
    let text = value.get_ref().as_str();
    if text.is_none() {
        problems.wrong_type(value, key, "a string");
    }
    text
}

/// The formula of a literal string. Any other string is refused: TOML would change `\theta` to a tab and `heta`.
pub(super) fn literal_of<'a>(problems: &mut Problems<'_>, value: &'a Value<'_>, key: &str) -> Option<Literal<'a>> {
    let Some(text) = value.get_ref().as_str() else {
        problems.wrong_type(value, key, "a formula in single quotes");
        return None;
    };
    let span = value.span();
    let raw = problems.source.text.get(span.clone()).unwrap_or_default();
    let open = match raw.strip_prefix("'''") {
        Some(rest) if rest.starts_with("\r\n") => 5,
        Some(rest) if rest.starts_with('\n') => 4,
        Some(_) => 3,
        None if raw.starts_with('\'') => 1,
        None => {
            note_double_quoted(problems, span, raw, false);
            return None;
        }
    };
    if raw.get(open..).is_some_and(|r| r.starts_with(text)) {
        return Some(Literal { text, start: span.start + open, span });
    }
    problems.note("derivation::line-ending", span, "this string mixes line endings");
    None
}

/// Whether TOML changes what stands in double quotes: it does not where every backslash is written twice.
pub(super) fn changes_backslashes(raw: &str) -> bool {
    raw.starts_with('"') && raw.replace(r"\\", "").contains('\\')
}

/// Notes a formula in double quotes, or a name, and how to write it.
pub(super) fn note_double_quoted(problems: &mut Problems<'_>, span: Range<usize>, raw: &str, name: bool) {
    let inner = raw.trim_matches('"');
    let noted = problems.note("derivation::quoted-formula", span, "formulas are written in single quotes");
    // There a backslash is written twice.
    let plain = inner.replace(r"\\", r"\");
    if name && inner.contains('\'') {
        let twice = plain.replace('\\', r"\\");
        noted.hint(format!("in double quotes TOML changes backslashes: write \"{twice}\""));
    } else if inner.contains(['\'', '\n']) {
        noted.hint("in double quotes TOML changes backslashes: put the formula between ''' and '''");
    } else {
        noted.hint(format!("in double quotes TOML changes backslashes: write '{plain}'"));
    }
}
