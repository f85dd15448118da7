//! The committed reports stay small enough to be attached to a letter, opened on a telephone, and read on a forge.
//!
//! Elements are counted as they are written; `tests/browser/run` counts what a browser makes of them, and the pages of the print.

use std::path::{Path, PathBuf};

/// The largest page, in bytes.
const LARGEST_PAGE: usize = 1_500_000;
/// So many elements are too many.
const ELEMENTS: usize = 30_000;
/// The largest report for a forge, in bytes.
const LARGEST_MARKDOWN: usize = 160_000;

fn reports() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports");
    let folders = std::fs::read_dir(folder).expect("reports").map(|entry| entry.expect("an entry").path());
    folders.filter(|f| f.join("report.json").exists()).collect()
}

/// Elements of a page as they are written, without what the script makes of its data.
fn elements(page: &str) -> usize {
    let end = page.find("<script type=\"text/plain\"").expect("the data");
    let begins = |at: usize| page.as_bytes().get(at + 1).is_some_and(u8::is_ascii_alphabetic);
    page[..end].match_indices('<').filter(|(at, _)| begins(*at)).count()
}

#[test]
fn pages_and_reports_are_small() {
    let all = reports();
    assert!(all.len() >= 3, "{all:?}");
    for folder in all {
        let page = std::fs::read_to_string(folder.join("index.html")).expect("a page");
        let markdown = std::fs::read_to_string(folder.join("report.md")).expect("a report");
        let (size, number) = (page.len(), elements(&page));
        assert!(size < LARGEST_PAGE, "{}: the page has {size} bytes", folder.display());
        assert!(number < ELEMENTS, "{}: the page has {number} elements", folder.display());
        assert!(number > 1_000, "{}: elements are counted", folder.display());
        assert!(markdown.len() < LARGEST_MARKDOWN, "{}: report.md has {} bytes", folder.display(), markdown.len());
    }
}

#[test]
fn elements_are_counted_as_a_browser_does() {
    let page = "<html><body><p>a<br>b</p></body></html><script type=\"text/plain\">";
    assert_eq!(elements(page), 4);
}
