//! Derivation files: any text is loaded or refused; problems are printed, and nothing of the file acts in what is printed.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rederive::derivation::parse;
use rederive::diag::{Source, render, sort};

fuzz_target!(|text: &str| {
    if let Err(mut found) = parse(Source { path: "fuzz.toml".into(), text: text.into() }, "fuzz") {
        assert!(!found.is_empty());
        sort(&mut found);
        let told = render(&found, false);
        assert!(told.chars().all(|c| !c.is_control() || c == '\n'), "{told:?}");
    }
});
