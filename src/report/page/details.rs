//! What is folded, kept out of the page until somebody unfolds it.
//!
//! **In:** HTML of ours, with `details` in it. **Out:** the same without what is folded, and that as a list: `data-k` of a
//! `details` is its position. A paragraph of the class `names`, directly after the summary, stays: it is what a reader without
//! the script has.
//!
//! **Why:** a page of some thousand pairs has ten times as many elements in its folded tables as in all the rest, and a browser
//! has to lay them out. The script puts them in their places when they are asked for.

const OPEN: &str = "<details";
const CLOSE: &str = "</details>";
const SUMMARY: &str = "</summary>";
const NAMES: [&str; 2] = ["<p class=\"names\">", "<p class=names>"];

/// Takes out what is folded, and adds it to `folds`. What is inside of something folded goes with it.
pub(super) fn taken_out(html: &str, folds: &mut Vec<String>) -> String {
    let mut out = String::with_capacity(html.len() / 2);
    let mut rest = html;
    while let Some(at) = rest.find(OPEN) {
        let Some(end) = closing(&rest[at..]) else { break };
        let whole = &rest[at..at + end];
        out.push_str(&rest[..at]);
        rest = &rest[at + end..];
        match parts(whole) {
            Some((attributes, head, inner)) if !inner.is_empty() => {
                out.push_str(&format!("{OPEN} data-k=\"{}\"{attributes}{head}{CLOSE}", folds.len()));
                folds.push(inner.to_owned());
            }
            _ => out.push_str(whole),
        }
    }
    out.push_str(rest);
    out
}

/// Where the element that the text begins with ends.
fn closing(text: &str) -> Option<usize> {
    let (mut depth, mut at) = (0, 0);
    loop {
        let close = text[at..].find(CLOSE)? + at;
        match text[at..close].find(OPEN) {
            Some(open) => {
                depth += 1;
                at += open + OPEN.len();
            }
            None => {
                depth -= 1;
                at = close + CLOSE.len();
                if depth == 0 {
                    return Some(at);
                }
            }
        }
    }
}

/// The attributes, what stays (`>`, the summary, the names), and what is folded.
fn parts(whole: &str) -> Option<(&str, &str, &str)> {
    let body = whole.strip_prefix(OPEN)?.strip_suffix(CLOSE)?;
    let begin = body.find('>')?;
    let mut end = body.find(SUMMARY)? + SUMMARY.len();
    if NAMES.iter().any(|n| body[end..].starts_with(n)) {
        end += body[end..].find("</p>")? + "</p>".len();
    }
    Some((&body[..begin], &body[begin..end], &body[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_folded_is_taken_out_with_all_that_is_in_it() {
        let html = "<p>a</p><details class=x><summary>S</summary><p class=names>n</p><ul><details><summary>T</summary>t</details></ul></details>b\
                    <details><summary>U</summary>u</details>";
        let mut folds = Vec::new();
        let page = taken_out(html, &mut folds);
        assert_eq!(
            page,
            "<p>a</p><details data-k=\"0\" class=x><summary>S</summary><p class=names>n</p></details>b\
             <details data-k=\"1\"><summary>U</summary></details>"
        );
        assert_eq!(folds, ["<ul><details><summary>T</summary>t</details></ul>", "u"]);
    }

    #[test]
    fn what_is_not_folded_stays() {
        for html in ["", "<p>a", "<details><summary>S</summary></details>", "<details><summary>S"] {
            let mut folds = Vec::new();
            assert_eq!((taken_out(html, &mut folds), folds), (html.to_owned(), Vec::new()), "{html}");
        }
    }
}
