//! What may be read and written: a folder that a stranger filled cannot make the program read, replace or remove anything else.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output};

const DECAY: &str = r"
[derivation]
title = 'Decay'
concerns = 'A textbook'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
[system.s]
states = ['x']
equations = ['\dot x=-x']
[[trajectory]]
id = 'a'
system = 's'
initial = { 'x' = 1 }
span = [0, 1]
[[claim]]
id = 'law'
says = 'the rate is minus x'
always = ['\dot x=-x']
";

fn project() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("derivations")).expect("made");
    fs::write(folder.path().join("derivations/decay.toml"), DECAY).expect("written");
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).output().expect("it runs")
}

/// It is refused, with these words, and in time.
#[track_caller]
fn refused(folder: &Path, arguments: &[&str], words: &str) {
    let output = run(folder, arguments);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
    assert!(told.contains(words), "{arguments:?}: {told}");
}

fn names(folder: &Path) -> Vec<String> {
    let mut out: Vec<String> = fs::read_dir(folder)
        .expect("listed")
        .map(|e| e.expect("entry").file_name().to_string_lossy().into_owned())
        .collect();
    out.sort();
    out
}

#[test]
fn outputs_that_cannot_be_meant_are_refused_before_anything_is_checked() {
    let project = project();
    let at = |name: &str| project.path().join(name);
    fs::create_dir(at("out")).expect("made");
    symlink("../derivations/decay.toml", at("out/link.json")).expect("a link");
    symlink("derivations", at("linked")).expect("a link");
    fs::hard_link(at("derivations/decay.toml"), at("second-name")).expect("a second name");
    for (output, words) in [
        ("/dev/null", "a device"),
        ("/dev/full", "a device"),
        ("derivations/decay.toml", "is read in this run"),
        ("./out/../derivations//decay.toml", "is read in this run"),
        ("second-name", "is read in this run"),
        ("out/link.json", "is a link"),
        ("linked/new.json", "is a link"),
        ("reports/decay/report.json", "exchanged as a whole"),
        ("out", "a folder"),
        ("..", "not the name of a file"),
    ] {
        refused(project.path(), &["check", "--format", "json", "--output", output], words);
        assert!(!at("reports").exists(), "{output}");
    }
    let twice = ["check", "--format", "json", "--output", "a.json", "--format", "sarif", "--output", "./out/../a.json"];
    refused(project.path(), &twice, "the output of two formats");
    let absolute = at("derivations/decay.toml").display().to_string();
    refused(project.path(), &["check", "--format", "json", "--output", &absolute], "is read in this run");
    refused(project.path(), &["report", "derivations/decay.toml", "--pdf", "derivations/decay.toml"], "");
    refused(project.path(), &["check", "--reports", "linked"], "is a link");
    assert_eq!(fs::read_to_string(at("derivations/decay.toml")).expect("read"), DECAY);
    assert_eq!(names(&at("derivations")), ["decay.toml"]);
    #[cfg(target_os = "linux")]
    {
        use std::os::unix::fs::FileTypeExt;
        assert!(fs::metadata("/dev/null").expect("there").file_type().is_char_device());
    }
}

#[test]
fn a_report_does_not_go_through_a_link() {
    let project = project();
    let at = |name: &str| project.path().join(name);
    fs::create_dir_all(at("src")).expect("made");
    fs::write(at("src/mine.py"), "mine").expect("written");
    fs::create_dir_all(at("reports/decay")).expect("made");
    symlink("../../src", at("reports/decay/certificates")).expect("a link");
    refused(project.path(), &["check"], "is a link");
    fs::remove_dir_all(at("reports")).expect("removed");
    fs::create_dir(at("reports")).expect("made");
    symlink("../src", at("reports/decay")).expect("a link");
    refused(project.path(), &["check"], "is a link");
    fs::remove_dir_all(at("reports")).expect("removed");
    symlink("src", at("reports")).expect("a link");
    refused(project.path(), &["check"], "is a link");
    assert_eq!(names(&at("src")), ["mine.py"]);
    assert_eq!(fs::read_to_string(at("src/mine.py")).expect("read"), "mine");
}

#[test]
fn a_search_follows_no_link_and_ends() {
    let project = project();
    let home = project.path().join("home");
    fs::create_dir(&home).expect("made");
    fs::write(home.join("secret.toml"), "password = 'xyzzy'").expect("written");
    let derivations = project.path().join("derivations");
    for name in ["x", "y", "z"] {
        symlink(".", derivations.join(name)).expect("a link");
    }
    symlink("../home", derivations.join("h")).expect("a link");
    symlink("../home/secret.toml", derivations.join("other.toml")).expect("a link");
    let output = run(project.path(), &["check", "--no-reports"]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{told}");
    assert!(!told.contains("xyzzy") && told.contains("`derivations/h` is a link"), "{told}");
    // What is named is read where it lies inside, and only there.
    let outside = tempfile::tempdir().expect("a folder");
    fs::write(outside.path().join("secret.toml"), "password = 'xyzzy'").expect("written");
    symlink(outside.path().join("secret.toml"), derivations.join("out.toml")).expect("a link");
    symlink(outside.path(), project.path().join("away")).expect("a link");
    for path in ["derivations/out.toml", "away/secret.toml", "away"] {
        refused(project.path(), &["check", path], "leads out of the current folder");
    }
    for command in ["list", "watch"] {
        refused(project.path(), &[command, "derivations/out.toml"], "leads out of the current folder");
    }
    refused(project.path(), &["prove", "1=1", "--in", "away/secret.toml"], "leads out of the current folder");
    refused(project.path(), &["check", "--source", "away/secret.toml"], "leads out of the current folder");
}

#[test]
fn pipes_and_devices_are_not_read() {
    let project = project();
    let pipe = project.path().join("derivations/pipe.toml");
    let made = Command::new("mkfifo").arg(&pipe).status().expect("it runs");
    assert!(made.success());
    refused(project.path(), &["check", "derivations/pipe.toml"], "this is a pipe, not a file");
    refused(project.path(), &["check", "/dev/zero"], "this is a device, not a file");
    refused(project.path(), &["check", "--source", "/dev/zero"], "this is a device, not a file");
    refused(project.path(), &["diff", "/dev/zero", "/dev/zero"], "is a device, not a file");
    // In a folder it is passed by.
    assert_eq!(run(project.path(), &["check", "--no-reports"]).status.code(), Some(0));
    let large = project.path().join("large.toml");
    fs::File::create(&large).and_then(|f| f.set_len(5 << 20)).expect("made");
    refused(project.path(), &["check", "large.toml"], "larger than 4 MiB");
    fs::File::create(&large).and_then(|f| f.set_len(17 << 20)).expect("made");
    refused(project.path(), &["check", "--source", "large.toml"], "larger than 16 MiB");
}

#[test]
fn the_bytes_do_not_depend_on_how_a_path_is_spelled() {
    let project = project();
    let reports = |path: &str| {
        assert_eq!(run(project.path(), &["check", path]).status.code(), Some(0), "{path}");
        ["report.json", "report.md", "index.html"].map(|n| {
            let file = project.path().join("reports/decay").join(n);
            fs::read(file).expect("read")
        })
    };
    let first = reports("derivations/decay.toml");
    let absolute = project.path().join("derivations/decay.toml").display().to_string();
    symlink("derivations", project.path().join("linked")).expect("a link");
    for path in
        ["./derivations//decay.toml", "derivations/../derivations/decay.toml", &absolute, "linked/decay.toml", "."]
    {
        assert!(reports(path) == first, "{path}");
    }
}

/// A run that is killed at any time leaves the old report or the new one, and the next run clears up.
#[test]
fn a_run_that_is_killed_leaves_a_whole_report() {
    let project = project();
    let file = project.path().join("derivations/decay.toml");
    assert_eq!(run(project.path(), &["check"]).status.code(), Some(0));
    let report = |name: &str| fs::read_to_string(project.path().join("reports/decay").join(name)).expect("a report");
    let mut seen = std::collections::BTreeSet::new();
    for n in 0..24 {
        fs::write(&file, DECAY.replace("'Decay'", &format!("'Decay {n}'"))).expect("written");
        let mut child = Command::new(env!("CARGO_BIN_EXE_rederive"))
            .current_dir(project.path())
            .args(["check", "--quiet"])
            .spawn()
            .expect("it starts");
        std::thread::sleep(std::time::Duration::from_millis(4 * n));
        let _ = child.kill();
        let _ = child.wait();
        let title = |text: &str| {
            let at = text.find("Decay").expect("a title");
            text[at..].chars().take_while(|c| c.is_alphanumeric() || *c == ' ').collect::<String>()
        };
        let (json, markdown) = (title(&report("report.json")), title(&report("report.md")));
        assert_eq!(json, markdown, "both of one run");
        seen.insert(json);
    }
    assert_eq!(run(project.path(), &["check"]).status.code(), Some(0));
    assert_eq!(names(&project.path().join("reports")), ["decay"], "nothing is left of {seen:?}");
}

/// Standard output that is full is an error, not a panic.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let project = project();
    for format in ["text", "json", "tex", "junit", "sarif", "github"] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("opened");
        let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
        command.current_dir(project.path()).args(["check", "--no-reports", "--format", format]).stdout(full);
        let output = command.output().expect("it runs");
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        let nothing_to_say = format == "github";
        assert!(
            output.status.code() == Some(2) && told.contains("cannot be written") || nothing_to_say,
            "{format}: {told}"
        );
        assert!(!told.contains("panicked"), "{told}");
    }
}

/// Nothing else in the program opens a file: whoever does must come to `files`, or stand on this list with a reason.
#[test]
fn one_room_opens_files() {
    // A log of a program that makes a PDF file, in a folder of its own; what the system says of the memory of this process.
    let allowed = ["cli/report.rs", "meter/lib.rs"];
    let mut open = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    let mut looked = 0;
    while let Some(at) = open.pop() {
        for entry in fs::read_dir(&at).expect("listed") {
            let path = entry.expect("entry").path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let shown = path.display().to_string();
            if !shown.ends_with(".rs") || shown.contains("/files/") || allowed.iter().any(|a| shown.ends_with(a)) {
                continue;
            }
            looked += 1;
            let text = fs::read_to_string(&path).expect("read");
            for word in ["std::fs", "fs::", "File::open", "File::create", "OpenOptions", "read_dir", ".canonicalize("] {
                assert!(!text.contains(word), "{shown} has `{word}`");
            }
        }
    }
    assert!(looked > 200, "{looked}");
}

/// Where a system does not tell case, two names that differ in nothing else are one.
#[test]
fn names_that_differ_in_case_get_different_files() {
    let project = project();
    fs::write(project.path().join("derivations/DECAY.toml"), DECAY).expect("written");
    let both = run(project.path(), &["check", "--no-cache"]);
    let told = String::from_utf8_lossy(&both.stderr).into_owned();
    assert_eq!(both.status.code(), Some(2), "{told}");
    assert!(told.contains("has the id") && !project.path().join("reports").exists(), "{told}");
    fs::remove_file(project.path().join("derivations/DECAY.toml")).expect("removed");
    // Of two claims the certificates are two files.
    let claims = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['(x+1)^2=x^2+2x+1']\n";
    let text = format!("{DECAY}{claims}{}", claims.replace("'c'", "'C'"));
    fs::write(project.path().join("derivations/decay.toml"), text).expect("written");
    let checked = run(project.path(), &["check", "--no-cache"]);
    assert_eq!(checked.status.code(), Some(0), "{}", String::from_utf8_lossy(&checked.stderr));
    let folder = project.path().join("reports/decay/certificates");
    let names: Vec<String> = fs::read_dir(folder)
        .expect("certificates")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().to_lowercase())
        .collect();
    let distinct: std::collections::BTreeSet<&String> = names.iter().collect();
    assert!(names.len() >= 4 && distinct.len() == names.len(), "{names:?}");
}
