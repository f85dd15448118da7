//! The same input gives the same bytes: on every run, and with any number of threads.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;

/// What a run prints, and the files that it writes, by their path below the folder.
type Ran = (Vec<u8>, BTreeMap<String, Vec<u8>>);

fn run(arguments: &[&str], threads: &str) -> Ran {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let reports = folder.path().join("reports");
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).env("RAYON_NUM_THREADS", threads);
    command.arg("check").args(arguments);
    if !arguments.contains(&"--claim") {
        command.arg("--reports").arg(&reports);
    }
    let output = command.output().expect("the program runs");
    let code = output.status.code();
    assert!(matches!(code, Some(0 | 1 | 3)), "{code:?}: {}", String::from_utf8_lossy(&output.stderr));
    let mut files = BTreeMap::new();
    collect(&reports, &reports, &mut files);
    // The path of the reports is printed: it is the only thing that may differ.
    let printed = String::from_utf8_lossy(&output.stdout).replace(&reports.display().to_string(), "reports");
    (printed.into_bytes(), files)
}

fn collect(root: &Path, folder: &Path, files: &mut BTreeMap<String, Vec<u8>>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for path in entries.map(|e| e.expect("an entry can be read").path()) {
        if path.is_dir() {
            collect(root, &path, files);
        } else {
            let name = path.strip_prefix(root).expect("below the root").display().to_string();
            files.insert(name, std::fs::read(&path).expect("a report can be read"));
        }
    }
}

#[track_caller]
fn assert_same(arguments: &[&str], files_at_least: usize) {
    assert_as_on_one_thread(arguments, &run(arguments, "5"), files_at_least);
}

#[track_caller]
fn assert_as_on_one_thread(arguments: &[&str], (printed, files): &Ran, files_at_least: usize) {
    let first = run(arguments, "1");
    assert!(!first.0.is_empty());
    assert!(first.1.len() >= files_at_least, "{:?}", first.1.keys());
    assert!(*printed == first.0, "with more threads something else is printed");
    assert_eq!(files.keys().collect::<Vec<_>>(), first.1.keys().collect::<Vec<_>>());
    for (name, bytes) in files {
        assert!(*bytes == first.1[name], "with more threads {name} has other bytes");
    }
}

const TWO: [&str; 2] = ["derivations/kepler.toml", "derivations/pendulum.toml"];
static REPORTS_OF_TWO: LazyLock<Ran> = LazyLock::new(|| run(&TWO, "5"));

#[test]
fn reports_do_not_depend_on_the_run_or_on_threads() {
    assert_as_on_one_thread(&TWO, &REPORTS_OF_TWO, 4);
}

#[test]
fn the_corpus_does_not_depend_on_the_run_or_on_threads() {
    assert_same(&["tests/corpus"], 8);
}

#[test]
fn json_of_the_comment_does_not_depend_on_the_run_or_on_threads() {
    let file = "derivations/deriglazov-comment.toml";
    assert_same(&[file, "--claim", "t9-psi", "--claim", "t11", "--format", "json"], 0);
}

#[test]
fn reports_name_no_machine_and_no_time() {
    let (_, files) = &*REPORTS_OF_TWO;
    assert!(files.len() >= 4, "{:?}", files.keys());
    let here = env!("CARGO_MANIFEST_DIR");
    for (name, bytes) in files {
        let text = String::from_utf8_lossy(bytes);
        assert!(!text.contains(here), "{name} contains the path of the project");
        assert!(!text.contains("threads"), "{name} speaks of threads");
    }
}
