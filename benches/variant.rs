//! What variants cost: a check without them, with them, and with a formula to be corrected.

use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::Source;

fn main() {
    divan::main();
}

fn derivation(path: &str, alter: impl Fn(String) -> String) -> Derivation {
    let text = alter(std::fs::read_to_string(path).expect("a derivation of this project"));
    parse(Source { path: path.into(), text }, "bench").expect("it can be read")
}

fn run(derivation: Derivation, options: &Options) -> Account {
    check(&derivation, options, &|_, _| {}).expect("it can be checked")
}

const FILES: &[&str] = &["derivations/deriglazov-comment.toml", "derivations/kepler.toml"];

/// Verdicts alone.
#[divan::bench(args = FILES, sample_count = 3)]
fn plain(bencher: divan::Bencher, path: &str) {
    let options = Options { plain: true, ..Options::default() };
    bencher.with_inputs(|| derivation(path, |t| t)).bench_values(|d| run(d, &options));
}

/// Verdicts, and what they are worth.
#[divan::bench(args = FILES, sample_count = 3)]
fn with_variants(bencher: divan::Bencher, path: &str) {
    bencher.with_inputs(|| derivation(path, |t| t)).bench_values(|d| run(d, &Options::default()));
}

/// One wrong sign in the radial equation, found and corrected.
#[divan::bench(sample_count = 10)]
fn correction(bencher: divan::Bencher) {
    let printed = r"\ddot r=\frac{{\bf L}\cdot{\bf L}}{r^3}-\frac{\mu}{r^2}";
    let wrong = r"\ddot r=\frac{{\bf L}\cdot{\bf L}}{r^3}+\frac{\mu}{r^2}";
    let options = Options { claims: vec!["radial-equation".into()], ..Options::default() };
    bencher
        .with_inputs(|| derivation("derivations/kepler.toml", |t| t.replace(printed, wrong)))
        .bench_values(|d| run(d, &options));
}
