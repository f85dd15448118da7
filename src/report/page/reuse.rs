//! Lines that several pictures share, drawn once.
//!
//! **In:** HTML of ours with pictures in it. **Out:** the same with every line that was drawn before as a reference to it. Level
//! sets are those of a body, and many motions are of one body: on a page of fifty motions they are a tenth of its bytes.

use std::collections::HashMap;

const OPEN: &str = "<path class=";
/// Classes of lines that belong to a body, not to one motion.
const SHARED: [&str; 2] = ["level ", "separatrix "];
/// Shorter lines are not worth a reference.
const WORTH: usize = 120;

/// The same pictures, with references. A path is given as [`plot`](super::super::plot) and [`tight`](super::tight) write it.
pub(super) fn drawn_once(html: &str) -> String {
    let mut times: HashMap<&str, usize> = HashMap::new();
    for line in lines(html) {
        *times.entry(line).or_default() += 1;
    }
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    for line in lines(html).filter(|line| times.get(line).is_some_and(|n| *n > 1)) {
        let Some((before, after)) = rest.split_once(line) else { break };
        out.push_str(before);
        rest = after;
        let next = places.len();
        match places.get(line) {
            Some(at) => out.push_str(&format!("<use href=\"#/line/{at}\"/>")),
            None => {
                places.insert(line, next);
                out.push_str(&format!("<path id=\"/line/{next}\" class={}", &line[OPEN.len()..]));
            }
        }
    }
    out.push_str(rest);
    out
}

/// The lines that can be shared, in order.
fn lines(html: &str) -> impl Iterator<Item = &str> {
    html.match_indices(OPEN).filter_map(|(at, _)| {
        let line = &html[at..];
        SHARED.iter().any(|class| line[OPEN.len()..].starts_with(class)).then_some(())?;
        let line = &line[..line.find("/>")? + "/>".len()];
        (line.len() >= WORTH).then_some(line)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_several_pictures_is_drawn_once() {
        let line = |class: &str, n: usize| format!("<path class={class} d=\"M0 {n}{}\"/>", "l1 1".repeat(40));
        let (a, b, c) = (line("level", 1), line("separatrix", 2), line("c0", 3));
        let html = format!("<svg>{a}{b}{c}</svg>x<svg>{c}{b}{a}</svg><svg>{a}</svg>");
        let (first_a, first_b) =
            (a.replacen("<path ", "<path id=\"/line/0\" ", 1), b.replacen("<path ", "<path id=\"/line/1\" ", 1));
        let (use_a, use_b) = ("<use href=\"#/line/0\"/>", "<use href=\"#/line/1\"/>");
        assert_eq!(
            drawn_once(&html),
            format!("<svg>{first_a}{first_b}{c}</svg>x<svg>{c}{use_b}{use_a}</svg><svg>{use_a}</svg>")
        );
    }

    #[test]
    fn what_is_drawn_once_or_short_stays() {
        for html in ["", "<path class=level d=\"M0 0\"/><path class=level d=\"M0 0\"/>", "<path class=level d=\"M0"] {
            assert_eq!(drawn_once(html), html);
        }
    }
}
