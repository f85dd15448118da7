//! Headings of Markdown: where the parts of a page begin, in which names mean the same.
//!
//! **In:** the text of a page. **Out:** the places of its headings: `# A`, a line above `===` or `---`, a rule, `<h2>`, and bold words that begin a
//! line and end like a sentence. **Guaranteed:** a place too many only parts what may belong together.

/// The longest bold words that begin a line as a heading, in bytes.
const LONGEST: usize = 60;

/// Where headings begin.
pub(super) fn headings(text: &str) -> Vec<usize> {
    let mut out = Vec::new();
    let (mut at, mut above) = (0, 0);
    for line in text.split_inclusive('\n') {
        let bare = line.trim();
        if begins_part(bare) {
            out.push(at);
        } else if is_ruled(bare) {
            // The line above is the heading.
            out.push(above);
        }
        above = at;
        at += line.len();
    }
    out
}

/// Whether a line is a heading by itself.
fn begins_part(line: &str) -> bool {
    let marks = line.bytes().take_while(|b| *b == b'#').count();
    let is_marked = (1..=6).contains(&marks) && line[marks..].starts_with([' ', '\t']);
    let bare = ["- ", "* ", "+ "].into_iter().find_map(|mark| line.strip_prefix(mark)).unwrap_or(line).trim_start();
    let bold = ["**", "__"].into_iter().find_map(|mark| {
        let words = bare.strip_prefix(mark)?;
        let end = words.find(mark)?;
        Some((&words[..end], &words[end + mark.len()..]))
    });
    let is_bold = bold.is_some_and(|(words, behind)| {
        words.len() <= LONGEST && (words.ends_with(['.', ':']) || behind.is_empty() || behind.starts_with(['.', ':']))
    });
    let lower = line.get(..3).unwrap_or_default().to_lowercase();
    is_marked
        || is_bold
        || lower.starts_with("<h") && lower.ends_with(|c: char| c.is_ascii_digit())
        || line == "</details>"
}

/// Whether a line is drawn below a heading, or between two parts.
fn is_ruled(line: &str) -> bool {
    let plain: Vec<char> = line.chars().filter(|c| !c.is_whitespace()).collect();
    plain.len() >= 3 && plain.iter().all(|c| *c == plain[0]) && matches!(plain[0], '=' | '-' | '*' | '_')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_a_page_begin_at_its_headings() {
        let parts = |text: &str| headings(text).len();
        for text in [
            "a\n## B\nc",
            "a\n\nB\n===\nc",
            "a\n\n---\nb",
            "a\n* * *\nb",
            "a\n<h2>B</h2>\n",
            "**Barrier.** Then",
            "- **Pole:** x",
        ] {
            assert_eq!(parts(text), 1, "{text}");
        }
        for text in ["#5 is a number", "a **bold** word", "- an item", "**strong** words", "=\n", "a - b"] {
            assert_eq!(parts(text), 0, "{text}");
        }
    }
}
