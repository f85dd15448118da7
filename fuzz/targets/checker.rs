//! Checks: a derivation file that loads is checked to the end, without panic and without a defect.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rederive::check::{CheckError, Options, Rigor, check};
use rederive::derivation::parse;
use rederive::diag::Source;

fuzz_target!(|text: &str| {
    if text.len() > 4096 {
        return;
    }
    let Ok(derivation) = parse(Source { path: "fuzz.toml".into(), text: text.into() }, "fuzz") else { return };
    let options = Options { rigor: Rigor::Sampled, ..Options::default() };
    match check(&derivation, &options, &|_, _| {}) {
        Ok(_) | Err(CheckError::Problems(_)) => {}
        Err(CheckError::Defect(message)) => panic!("{message}"),
    }
});
