//! The committed reports stay small enough to be attached to a letter, opened on a telephone, and read on a forge.
//!
//! Elements are counted as they are written; `tests/browser/run` counts what a browser makes of them, and the pages of the print.
//!
//! Of chains of steps: what a report says of a claim does not grow with the length of its chain.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use rederive::{Ask, Findings, Session};
use serde_json::Value;

/// The largest page, in bytes.
const LARGEST_PAGE: usize = 1_000_000;
/// So many elements are too many.
const ELEMENTS: usize = 31_000;
/// The largest report for a forge, in bytes.
const LARGEST_MARKDOWN: usize = 100_000;
/// The most words of a page that are seen with every fold closed, formulas symbol by symbol.
const MOST_WORDS: usize = 15_000;

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

/// Words of a page outside of its style, its data and its closed folds: runs of letters between two marks.
fn words_seen(page: &str) -> usize {
    let body = page.find("<body").expect("a body");
    let end = page.find("<script type=\"text/plain\"").expect("the data");
    let (mut folded, mut words) = (0_usize, 0);
    for part in page[body..end].split('<').skip(1) {
        let (tag, text) = part.split_once('>').unwrap_or((part, ""));
        match tag.split([' ', '>']).next().unwrap_or_default() {
            "details" => folded += 1,
            "/details" => folded = folded.saturating_sub(1),
            // The summary of a fold is seen, where the fold is not in another one.
            "summary" if folded == 1 => words += text.split_whitespace().count(),
            _ => {}
        }
        words += if folded == 0 { text.split_whitespace().count() } else { 0 };
    }
    words
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
        let words = words_seen(&page);
        assert!((500..MOST_WORDS).contains(&words), "{}: the page shows {words} words", folder.display());
        assert!(number > 1_000, "{}: elements are counted", folder.display());
        assert!(markdown.len() < LARGEST_MARKDOWN, "{}: report.md has {} bytes", folder.display(), markdown.len());
    }
}

#[test]
fn no_claim_is_lost_from_the_report_of_a_forge() {
    let mut rows = 0;
    for folder in reports() {
        let markdown = std::fs::read_to_string(folder.join("report.md")).expect("a report");
        let report = std::fs::read_to_string(folder.join("report.json")).expect("a report");
        let report: Value = serde_json::from_str(&report).expect("JSON");
        let claims = markdown.split("\n## ").find(|part| part.starts_with("Claims\n")).expect("the claims");
        rows += claims.lines().filter(|line| line.starts_with("#### ") || line.starts_with("**/")).count();
        for claim in report["claims"].as_array().expect("claims") {
            let id = claim["id"].as_str().expect("an id");
            // What is told of a claim: up to the next one.
            let at = claims.find(&format!("\n#### {id}: "));
            let told = &claims[at.unwrap_or_else(|| panic!("{}: {id} is not told", folder.display())) + 1..];
            let told = told.split("\n#### ").next().unwrap_or_default();
            let Some(reading) = claim["reading"].as_str() else { continue };
            assert!(told.contains(&format!("**/{reading}**")), "{}: {id}/{reading}", folder.display());
        }
    }
    assert!(rows > 100, "{rows}");
}

/// The data of a page, as its script reads them: what is folded is there.
fn data(page: &str) -> Value {
    const DIGITS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%()*+,-./:;=?@[]^_{|";
    let begin = page.find("id=\"/data\">").expect("the data") + "id=\"/data\">".len();
    let end = begin + page[begin..].find('<').expect("their end");
    let value = |c: u8| DIGITS.iter().position(|d| *d == c).expect("a digit") as u64;
    let mut packed = Vec::new();
    for chunk in page.as_bytes()[begin..end].chunks(5) {
        let word = (0..5).fold(0, |word, i| 85 * word + chunk.get(i).map_or(84, |c| value(*c)));
        packed.extend_from_slice(&u32::try_from(word).expect("four bytes").to_be_bytes()[..chunk.len() - 1]);
    }
    let bytes = miniz_oxide::inflate::decompress_to_vec_zlib(&packed).expect("packed data");
    serde_json::from_slice(&bytes).expect("JSON")
}

/// Texts of HTML in which a command of LaTeX is shown, outside of what shows sources on purpose.
fn sources_shown(html: &str) -> Vec<String> {
    // What is open of what shows sources: LaTeX that is copied from formulas, corrections, and members of families.
    let (mut within, mut shown) = (0_usize, Vec::new());
    for part in html.split('<').skip(1) {
        let (tag, text) = part.split_once('>').unwrap_or((part, ""));
        match tag.split(' ').next().unwrap_or_default() {
            "annotation" | "code" | "pre" => within += 1,
            "/annotation" | "/code" | "/pre" => within = within.saturating_sub(1),
            _ => {}
        }
        let is_command = |rest: &str| rest.bytes().take(2).filter(u8::is_ascii_alphabetic).count() == 2;
        if within == 0 && text.split('\\').skip(1).any(is_command) {
            shown.push(text.to_owned());
        }
    }
    shown
}

#[test]
fn no_sentence_of_a_page_shows_the_source_of_a_formula() {
    let mut folds = 0;
    for folder in reports() {
        let page = std::fs::read_to_string(folder.join("index.html")).expect("a page");
        let body = page.find("<body").expect("a body")..page.find("<script type=\"text/plain\"").expect("the data");
        let mut shown = sources_shown(&page[body]);
        for text in data(&page)["folds"].as_array().expect("what is folded") {
            folds += 1;
            shown.extend(sources_shown(text.as_str().expect("a text")));
        }
        assert!(shown.is_empty(), "{}: {shown:#?}", folder.display());
    }
    assert!(folds > 100, "{folds}");
    assert_eq!(sources_shown("<p>so `\\frac12`</p><code>\\frac12</code>"), ["so `\\frac12`"]);
}

#[test]
fn elements_are_counted_as_a_browser_does() {
    let page = "<html><body><p>a<br>b</p></body></html><script type=\"text/plain\">";
    assert_eq!(elements(page), 4);
}

/// What is special about the steps of a chain.
#[derive(Clone, Copy, Debug)]
enum Steps {
    /// Each is proved.
    Proved,
    /// Each assumes something of its own.
    Assuming,
    /// Each is a conclusion of the paper.
    Concluded,
    /// Every second one is no question for all values.
    Open,
    /// Each is refuted.
    Refuted,
}

impl Steps {
    const ALL: [Steps; 5] = [Steps::Proved, Steps::Assuming, Steps::Concluded, Steps::Open, Steps::Refuted];

    /// A chain in which each step follows from the one before; ids are of one length.
    fn chain(self, length: usize) -> Findings {
        let mut text = String::from(
            "[derivation]\ntitle='A chain'\nconcerns='Steps'\n[symbols]\n't'={role='time'}\n'k'={role='parameter',positive=true}\n\
             'x'={role='state'}\n[system.decay]\nstates=['x']\nequations=['\\dot x=-kx']\n[[trajectory]]\nid='one'\nsystem='decay'\n\
             parameters={'k'=1}\ninitial={'x'=2}\nspan=[0,1]\n",
        );
        for n in 10_000..10_000 + length {
            let from = if n > 10_000 { format!(",'c{}'", n - 1) } else { String::new() };
            let formula = match self {
                Steps::Open if n % 2 == 1 => format!("x<{n}"),
                Steps::Refuted => format!(r"\dot x=-kx+{n}(k-1)x+1"),
                _ => format!(r"\dot x+{n}x=-kx+{n}x"),
            };
            let more = match self {
                Steps::Assuming => format!("assuming=['k>-{n}']\n"),
                Steps::Concluded => "conclusion=true\n".to_owned(),
                Steps::Proved | Steps::Open | Steps::Refuted => String::new(),
            };
            write!(
                text,
                "[[claim]]\nid='c{n}'\nsays='A step.'\n{more}follows-from=['decay'{from}]\nalways=['{formula}']\n"
            )
            .expect("it is written");
        }
        let session = Session::open("chain.toml", text).unwrap_or_else(|found| panic!("{found:?}"));
        session.check(&Ask { only_verdicts: true, ..Ask::default() }, &|_, _| {}).expect("it is checked")
    }
}

/// Bytes of each field of the claims, and of what a report has beside them, by their names.
fn sizes(of: &Value, name: &str, out: &mut std::collections::BTreeMap<String, usize>) {
    match of {
        Value::Object(fields) => fields.iter().for_each(|(key, value)| sizes(value, &format!("{name}.{key}"), out)),
        Value::Array(items) if items.iter().any(Value::is_object) => items.iter().for_each(|one| sizes(one, name, out)),
        value => *out.entry(name.to_owned()).or_default() += value.to_string().len(),
    }
}

#[test]
fn what_is_said_of_a_step_does_not_grow_with_its_chain() {
    // Up to 64 of a kind are told of each step: the shorter chain is long beside that.
    let (short, long) = (300, 900);
    for steps in Steps::ALL {
        let [few, many] = [short, long].map(|length| steps.chain(length));
        let grown = |what: &str, few: usize, many: usize| {
            let (each, then) = (few as f64 / short as f64, many as f64 / long as f64);
            assert!(then < 1.2 * each + 1.0, "{steps:?}: {what} takes {each:.1} bytes a step, then {then:.1}");
        };
        let [of_few, of_many] = [&few, &many].map(|found| {
            let mut out = std::collections::BTreeMap::new();
            sizes(&serde_json::from_str(&found.json()).expect("JSON"), "report", &mut out);
            out
        });
        assert!(of_few.contains_key("report.graph.nodes.rests_on.claims"), "{of_few:?}");
        for (field, bytes) in &of_many {
            grown(field, of_few.get(field).copied().unwrap_or(0), *bytes);
        }
        grown("report.json", few.json().len(), many.json().len());
        grown("report.md", few.markdown().len(), many.markdown().len());
        grown("the page", few.page().len(), many.page().len());
    }
}

#[test]
fn what_is_open_behind_a_step_is_told_up_to_a_bound() {
    let report: Value = serde_json::from_str(&Steps::Open.chain(200).json()).expect("JSON");
    let told = |n: usize| {
        let identity = &report["claims"][n]["identity"];
        let ids = identity["conditional_on"].as_array().expect("a list").iter();
        let ids: Vec<String> = ids.map(|g| g["id"].as_str().expect("an id").to_owned()).collect();
        (ids, identity["conditional_on_more"].as_bool(), identity["standing"].as_str().expect("a word"))
    };
    // Every second step before it is open: 64 before the 128th.
    let odd = |from: usize, to: usize| -> Vec<String> {
        (from..to).filter(|n| n % 2 == 1).map(|n| format!("c{}", 10_000 + n)).collect()
    };
    assert_eq!(told(0), (Vec::new(), None, "proved"));
    assert_eq!(told(128), (odd(0, 128), None, "proved given"));
    assert_eq!(told(130), (odd(2, 130), Some(true), "proved given"), "the nearest");
    assert_eq!(told(198), (odd(70, 198), Some(true), "proved given"));
}

/// A page of a thousand claims, two thirds of them not as expected: what is seen at first is small, and every claim is on it with its verdict.
#[test]
fn a_page_of_a_thousand_claims_is_small() {
    let mut text = String::from(
        "[derivation]\ntitle = 'many'\nconcerns = 'test'\n[symbols]\n't' = { role = 'time', unit = 's' }\n\
         'q' = { role = 'state', unit = 'm' }\n'p' = { role = 'state', unit = 'm/s' }\n[system.s]\nstates = ['q', 'p']\n\
         equations = ['\\dot q=p', '\\dot p=-q']\n",
    );
    for (id, start) in [("one", 1), ("two", 2)] {
        let _ = write!(
            text,
            "[[trajectory]]\nid = '{id}'\nsystem = 's'\ninitial = {{ 'q' = {start}, 'p' = 0 }}\nspan = [0, 1]\n"
        );
    }
    for i in 0..1000 {
        let formula = ["q^2+p^2<", r"\left|q\right|>1+", "p="][i % 3];
        let says =
            format!("A claim with the number {i}, told in a sentence of an ordinary length, as a paper has them.");
        let _ = write!(text, "[[claim]]\nid = 'claim-number-{i}'\nsays = '{says}'\nalways = ['{formula}{}']\n", i + 5);
    }
    let session = Session::open("many.toml", text).unwrap_or_else(|found| panic!("{found:?}"));
    let findings = session.check(&Ask::default(), &|_, _| {}).expect("it is checked");
    let page = findings.page();
    let body = page.find("<body").expect("a body");
    assert!(page.len() < LARGEST_PAGE, "{}", page.len());
    for i in 0..1000 {
        let at = page[body..].find(&format!("id=claim-number-{i}>")).unwrap_or_else(|| panic!("{i} is not there"));
        let claim = page[body + at..].split("</article>").next().unwrap_or_default();
        assert!(claim.contains("class=\"mark "), "{claim}");
    }
}

/// What takes more than a file may is left out, and then nothing of the file is kept for the next run. No derivation of the gallery is so.
#[test]
fn no_derivation_comes_to_the_end_of_its_work() {
    let all = reports();
    assert!(all.len() >= 18, "{all:?}");
    for folder in all {
        let report = std::fs::read_to_string(folder.join("report.md")).expect("a report");
        let limited = report.lines().find(|line| line.contains("work limit"));
        assert_eq!(limited, None, "{}", folder.display());
    }
}
