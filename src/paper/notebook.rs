//! Notebooks: the text of their cells.
//!
//! **In:** the JSON of a notebook. **Out:** its Markdown cells, one behind the other, and those with LaTeX as they are, between [`BETWEEN_CELLS`]; and
//! the line at which each begins. **Guaranteed:** what stands in cells with code, and what these put out, is no part of it.

use std::sync::Arc;

use diag::{Diagnostic, Source};
use serde_json::Value;

use super::kinds::FileKind;
use super::markdown;
use super::note::PaperNote;

/// What stands between two cells: no cell has it.
const BETWEEN_CELLS: &str = "\n\n\u{c}\n\n";
/// The same for the eye.
const FORM_FEED: char = '\u{c}';
/// The most cells of which it is told where they begin.
const MOST_TOLD: usize = 60;

/// A file as it is read: of a notebook its cells, with a note.
pub(super) fn as_read(file: Arc<Source>) -> Result<(Arc<Source>, Option<PaperNote>), Box<Diagnostic>> {
    if FileKind::of(&file.path) != FileKind::Notebook {
        return Ok((file, None));
    }
    let refuse = |why: String| {
        Box::new(Diagnostic::of_file(&file.path, "paper::unreadable", format!("this file is no notebook: {why}")))
    };
    let all: Value = serde_json::from_str(file.text.trim_start_matches('\u{feff}'))
        .map_err(|error| refuse(format!("it is not JSON: {error}")))?;
    let Some(cells) = cells(&all) else { return Err(refuse("it has no list `cells`".to_owned())) };
    let (mut text, mut begins) = (String::new(), Vec::new());
    for (number, cell) in cells.into_iter().enumerate() {
        let Some(own) = printed(cell) else { continue };
        if !text.is_empty() {
            text.push_str(BETWEEN_CELLS);
        }
        begins.push((number + 1, text.matches('\n').count() + 1));
        text.push_str(&own);
    }
    let note = note(&begins);
    Ok((Arc::new(Source { path: file.path.clone(), text }), note))
}

/// The text of a notebook as [`markdown::printed`] has it, each cell by itself.
pub(super) fn printed_cells(text: &str) -> String {
    // A line before it: what stands between `---` at its beginning is text.
    let cell = |text: &str| markdown::printed(&format!("\n{text}")).split_off(1);
    text.split(FORM_FEED).map(cell).collect::<Vec<_>>().join("\u{c}")
}

/// The cells; in notebooks of the third version they stand in sheets.
fn cells(all: &Value) -> Option<Vec<&Value>> {
    if let Some(cells) = all.get("cells") {
        return cells.as_array().map(|cells| cells.iter().collect());
    }
    let sheets = all.get("worksheets")?.as_array()?;
    Some(sheets.iter().filter_map(|sheet| sheet.get("cells")?.as_array()).flatten().collect())
}

/// What a cell prints, if it is text.
fn printed(cell: &Value) -> Option<String> {
    let text = match cell.get("source")? {
        Value::Array(lines) => lines.iter().filter_map(Value::as_str).collect(),
        other => other.as_str()?.to_owned(),
    };
    let text = super::texts::with_plain_ends(text.replace("\r\n", "\n")).replace(FORM_FEED, " ");
    match cell.get("cell_type").and_then(Value::as_str)? {
        "markdown" => Some(text),
        "heading" => Some(format!("# {text}")),
        "raw" => {
            let format = |key: &str| cell.get("metadata").and_then(|of| of.get(key)).and_then(Value::as_str);
            let format = format("raw_mimetype").or_else(|| format("format")).unwrap_or_default();
            matches!(format, "text/latex" | "latex" | "text/x-latex").then(|| without_comments(&text))
        }
        _ => None,
    }
}

/// LaTeX without what stands behind a percent sign: in Markdown that is printed.
fn without_comments(text: &str) -> String {
    let line = |line: &str| {
        let mut is_escaped = false;
        let end = line.find(|c| {
            let ends = c == '%' && !is_escaped;
            is_escaped = c == '\\' && !is_escaped;
            ends
        });
        line[..end.unwrap_or(line.len())].to_owned()
    };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// Where the cells begin.
fn note(begins: &[(usize, usize)]) -> Option<PaperNote> {
    let (first, rest) = begins.split_first()?;
    let mut message = format!(
        "the cells with text are read one behind the other, and lines are counted so: cell {} begins at line {}",
        first.0, first.1
    );
    for (number, line) in rest.iter().take(MOST_TOLD) {
        message.push_str(&format!(", {number} at {line}"));
    }
    if rest.len() > MOST_TOLD {
        message.push_str(", \u{2026}");
    }
    Some(PaperNote { message, span: 0..0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(json: &str) -> Result<String, String> {
        let file = Arc::new(Source { path: "n.ipynb".into(), text: json.into() });
        as_read(file).map(|(file, _)| file.text.replace(BETWEEN_CELLS, "|")).map_err(|d| d.message.clone())
    }

    #[test]
    fn cells_with_text_are_read() {
        let json = r#"{"cells":[
            {"cell_type":"markdown","source":["a\n","$x$"]}, {"cell_type":"code","source":"$y$","outputs":[{"text":"$z$"}]},
            {"cell_type":"raw","source":"b"}, {"cell_type":"raw","metadata":{"format":"text/latex"},"source":"c % d\n\\% e"},
            {"cell_type":"markdown","source":"f"}],"nbformat":4}"#;
        assert_eq!(read(json).as_deref(), Ok("a\n$x$|c \n\\% e|f"));
        let old = r#"{"worksheets":[{"cells":[{"cell_type":"heading","source":["a"]}]}]}"#;
        assert_eq!(read(old).as_deref(), Ok("# a"));
        assert_eq!(read(r#"{"cells":[]}"#).as_deref(), Ok(""));
    }

    #[test]
    fn what_is_no_notebook_is_told() {
        for (json, why) in [("{", "not JSON"), ("", "not JSON"), ("[]", "no list"), (r#"{"cells":1}"#, "no list")] {
            assert!(read(json).is_err_and(|message| message.contains(why)), "{json}");
        }
        // A cell with no text in it is none.
        assert_eq!(
            read(r#"{"cells":[1,{},{"cell_type":"markdown"},{"cell_type":"markdown","source":1}]}"#).as_deref(),
            Ok("")
        );
    }

    #[test]
    fn a_fence_ends_with_its_cell() {
        let text = format!("```{BETWEEN_CELLS}---\n$x$\n---\n");
        assert!(printed_cells(&text).contains("$x$"));
        assert_eq!(printed_cells(&text).len(), text.len());
    }
}
