//! Sources of papers: any text is read or refused, and the draft that is made of it loads.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rederive::derivation::parse;
use rederive::diag::{Source, render};
use rederive::paper;

fuzz_target!(|text: &str| {
    let Ok(read) = paper::parse(Source { path: "paper.tex".into(), text: text.into() }, String::new()) else { return };
    if read.equations.is_empty() {
        return;
    }
    let draft = paper::draft(&read, "paper.tex");
    if let Err(found) = parse(Source { path: "draft.toml".into(), text: draft.text.clone() }, "draft") {
        panic!("{}\n{}", render(&found, false), draft.text);
    }
});
