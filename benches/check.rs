//! The whole check of a derivation, from the text of its file to the account.
//!
//! `cargo bench --bench check`. The single steps have benchmarks of their own: integration in `flow`, residuals in `number`,
//! identities in `identity`.

use divan::{Bencher, black_box};
use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::Source;

fn main() {
    divan::main();
}

const FILES: &[(&str, &str)] = &[
    ("kepler", include_str!("../derivations/kepler.toml")),
    ("pendulum", include_str!("../derivations/pendulum.toml")),
    ("deriglazov-comment", include_str!("../derivations/deriglazov-comment.toml")),
];

fn text(id: &str) -> &'static str {
    FILES.iter().find(|(name, _)| *name == id).map(|(_, text)| *text).expect("a known file")
}

fn read(id: &str) -> Derivation {
    let source = Source { path: format!("{id}.toml"), text: text(id).to_owned() };
    parse(source, id).unwrap_or_else(|found| panic!("{} problems in {id}", found.len()))
}

fn account(derivation: &mut Derivation, options: &Options) -> Account {
    check(derivation, options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

#[divan::bench(args = ["kepler", "pendulum", "deriglazov-comment"])]
fn parse_only(bencher: Bencher, id: &str) {
    bencher.bench(|| read(black_box(id)));
}

#[divan::bench(args = ["kepler", "pendulum"], max_time = 5)]
fn whole(bencher: Bencher, id: &str) {
    bencher.bench(|| account(&mut read(black_box(id)), &Options::default()));
}

#[divan::bench(sample_count = 5, sample_size = 1)]
fn whole_comment(bencher: Bencher) {
    bencher.bench(|| account(&mut read(black_box("deriglazov-comment")), &Options::default()));
}

/// One claim on one motion: what an author waits for who works on one equation.
#[divan::bench(max_time = 3)]
fn one_claim_on_one_motion(bencher: Bencher) {
    let options =
        Options { claims: vec!["t9-psi".into()], trajectories: vec!["racket-out".into()], ..Options::default() };
    bencher.bench(|| account(&mut read(black_box("deriglazov-comment")), &options));
}
