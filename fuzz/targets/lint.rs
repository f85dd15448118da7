//! Papers as they are: every relation that any text prints has one word, and what is said of it has its place in the text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rederive::check::Limits;
use rederive::diag::Source;
use rederive::{lint, paper};

fuzz_target!(|text: &str| {
    let Ok(read) = paper::parse(Source { path: "paper.tex".into(), text: text.into() }, String::new()) else { return };
    // A second of work is more than a short text needs: what takes longer is ended, and said.
    let limits = Limits { deadline: Limits::after(Some(1.0)), ..Limits::default() };
    for judged in lint::lint(&read, &limits).judgements {
        let relation = &read.printed[judged.relation];
        assert!(!relation.sides.is_empty(), "{text}");
        assert!(text.get(relation.span()).is_some(), "{text}: {:?}", relation.span());
    }
});
