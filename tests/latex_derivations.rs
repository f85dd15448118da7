//! The derivation files that come with the program are read without a problem.

use rederive::derivation::load;
use rederive::diag::render;

#[test]
fn every_derivation_is_read() {
    let folder = format!("{}/derivations", env!("CARGO_MANIFEST_DIR"));
    let mut seen = 0;
    for entry in std::fs::read_dir(&folder).expect("the folder is there") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|e| e == "toml") {
            seen += 1;
            if let Err(problems) = load(&path) {
                panic!("{}", render(&problems, false));
            }
        }
    }
    assert!(seen >= 3);
}
