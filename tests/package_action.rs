//! What a repository copies does what it says: the steps of the action and the hook for pre-commit, run as they are written.
//!
//! Only the build is left out: the program of this test lies where the action would have put it.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::Command;

const LAW: &str = r"
[derivation]
title = 'Decay'
concerns = 'A textbook'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
[system.decay]
states = ['x']
equations = ['\dot x=-x']
[[trajectory]]
id = 'slow'
system = 'decay'
initial = { 'x' = 1.5 }
span = [0, 2]
[[claim]]
id = 'law'
says = 'the rate is minus x'
always = ['\dot x=-x']
";

fn read(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// The script of a step of the action.
fn script(step: &str) -> String {
    let action = read("action.yml");
    let (_, after) = action.split_once(&format!("    - name: {step}\n")).unwrap_or_else(|| panic!("no step {step}"));
    let (_, run) = after.split_once("      run: ").expect("a script");
    match run.strip_prefix("|\n") {
        Some(block) => {
            let lines = block.lines().take_while(|l| l.is_empty() || l.starts_with("        "));
            lines.map(|l| l.trim_start()).collect::<Vec<_>>().join("\n")
        }
        None => run.lines().next().unwrap_or_default().to_owned(),
    }
}

/// A repository with a derivation file, and the folder of the runner with the program.
fn repository(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    fs::create_dir_all(at("work/derivations")).expect("made");
    fs::create_dir_all(at("runner/rederive/bin")).expect("made");
    fs::write(at("work/derivations/decay.toml"), text).expect("written");
    let program = at("runner/rederive/bin/rederive");
    std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_rederive"), program).expect("a link");
    folder
}

/// Runs a script as a runner does; the exit code and what it printed.
fn run(folder: &Path, script: &str, inputs: &[(&str, &str)]) -> (i32, String) {
    let out = Command::new("bash")
        .args(["--noprofile", "--norc", "-eo", "pipefail", "-c", script])
        .current_dir(folder.join("work"))
        .env("RUNNER_TEMP", folder.join("runner"))
        .env("GITHUB_OUTPUT", folder.join("output"))
        .env("GITHUB_STEP_SUMMARY", folder.join("summary"))
        .envs(inputs.iter().copied())
        .output()
        .expect("bash runs");
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    (out.status.code().unwrap_or(-1), text)
}

/// The step that checks, then the step that tells the result: its exit code, and what the first one printed.
fn action(folder: &Path, source: &str) -> (i32, String) {
    let inputs = [("FILES", "derivations"), ("SOURCE", source), ("SARIF", "rederive.sarif"), ("JUNIT", "rederive.xml")];
    let (code, text) = run(folder, &script("Check"), &inputs);
    assert_eq!(code, 0, "the step itself goes on, so that findings are shown: {text}");
    let output = fs::read_to_string(folder.join("output")).expect("an output");
    let found = output.lines().next_back().and_then(|l| l.strip_prefix("exit-code=")).expect("an exit code");
    let (code, _) = run(folder, &script("Result"), &[("CODE", found)]);
    (code, text)
}

#[test]
fn the_action_checks_annotates_and_tells_the_result() {
    let folder = repository(LAW);
    let (code, text) = action(folder.path(), "");
    assert_eq!((code, text.as_str()), (0, ""), "nothing to annotate");
    for file in ["rederive.sarif", "rederive.xml", "reports/decay/index.html", "reports/decay/report.json"] {
        assert!(folder.path().join("work").join(file).is_file(), "{file}");
    }

    // A claim that is wrong: an annotation, and the exit code.
    let wrong = LAW.replace(r"always = ['\dot x=-x']", r"always = ['\dot x=x']");
    let folder = repository(&wrong);
    let (code, text) = action(folder.path(), "");
    assert_eq!(code, 1);
    assert!(text.contains("::error") && text.contains("derivations/decay.toml"), "{text}");
    let sarif = fs::read_to_string(folder.path().join("work/rederive.sarif")).expect("written");
    assert!(sarif.contains("verdict::fails"));

    // A file that cannot be read, and a paper that is not there.
    let folder = repository("title = ");
    assert_eq!(action(folder.path(), "").0, 2);
    let folder = repository(LAW);
    assert_eq!(action(folder.path(), "paper.tex").0, 2);
}

/// What the tree says that is checked, about cargo, toolchains or names like options, changes nothing.
#[test]
fn the_action_builds_a_copy_and_takes_no_name_for_an_option() {
    use std::os::unix::fs::PermissionsExt;
    let folder = repository(LAW);
    let at = |name: &str| folder.path().join(name);
    for made in ["work/rederive", "work/.cargo", "tools"] {
        fs::create_dir_all(at(made)).expect("made");
    }
    fs::write(at("work/.cargo/config.toml"), "[build]\nrustc-wrapper = 'owned'\n").expect("written");
    fs::write(at("work/rust-toolchain.toml"), "[toolchain]\nchannel = 'owned'\n").expect("written");
    fs::write(at("work/rederive/Cargo.toml"), "").expect("written");
    // They tell where they are, and with what they are called.
    for tool in ["cargo", "rustup"] {
        fs::write(at("tools").join(tool), "#!/bin/sh\necho \"$0 in $PWD: $* with $RUSTUP_TOOLCHAIN\"\n")
            .expect("written");
        fs::set_permissions(at("tools").join(tool), fs::Permissions::from_mode(0o755)).expect("made a program");
    }
    let path = format!("{}:{}", at("tools").display(), std::env::var("PATH").unwrap_or_default());
    let source = at("work/rederive").display().to_string();
    let inputs = [("PATH", path.as_str()), ("GITHUB_ACTION_PATH", source.as_str()), ("RUSTUP_TOOLCHAIN", "1.89.0")];
    let (code, text) = run(folder.path(), &script("Build"), &inputs);
    assert_eq!(code, 0, "{text}");
    let built = text.lines().find(|l| l.contains("cargo in")).expect("cargo is called");
    assert!(
        built.contains("/runner/rederive-source: install --locked --path . ") && built.ends_with("1.89.0"),
        "{built}"
    );
    assert!(read("action.yml").contains("RUSTUP_TOOLCHAIN: 1.89.0"), "the toolchain is fixed");
    assert!(at("runner/rederive-source/Cargo.toml").is_file());

    // A file that is called like an option, and one like a pattern.
    fs::write(at("work/--no-reports"), "").expect("written");
    let inputs = [("FILES", "--no-reports\n*.toml"), ("SOURCE", ""), ("SARIF", "a.sarif"), ("JUNIT", "a.xml")];
    let (_, text) = run(folder.path(), &script("Check"), &inputs);
    assert!(text.contains("--no-reports") && !text.contains("rust-toolchain"), "{text}");
    let output = fs::read_to_string(folder.path().join("output")).expect("an output");
    assert!(output.ends_with("exit-code=2\n"), "{output}");
}

#[test]
fn the_action_compares_with_a_baseline() {
    let folder = repository(LAW);
    assert_eq!(action(folder.path(), "").0, 0);
    fs::rename(folder.path().join("work/reports"), folder.path().join("work/before")).expect("moved");
    let wrong = LAW.replace(r"always = ['\dot x=-x']", r"always = ['\dot x=x']");
    fs::write(folder.path().join("work/derivations/decay.toml"), wrong).expect("written");
    assert_eq!(action(folder.path(), "").0, 1);
    let (code, text) = run(folder.path(), &script("Compare"), &[("BASELINE", "before")]);
    assert_eq!(code, 0, "{text}");
    let summary = fs::read_to_string(folder.path().join("summary")).expect("written");
    assert!(summary.contains("law") && summary.contains("fails"), "{summary}");
}

#[test]
fn the_hook_stops_a_commit_with_a_wrong_claim() {
    let hook = read(".pre-commit-hooks.yaml");
    let value =
        |key: &str| hook.lines().find_map(|l| l.trim_start_matches("- ").trim().strip_prefix(key)).map(str::trim);
    let entry = value("entry:").expect("an entry");
    assert_eq!(value("files:"), Some("^derivations/"));
    let program = entry.replacen("rederive", "\"$RUNNER_TEMP/rederive/bin/rederive\"", 1);
    let folder = repository(LAW);
    // pre-commit puts the files that are committed behind the entry.
    let commit = format!("{program} derivations/decay.toml");
    assert_eq!(run(folder.path(), &commit, &[]).0, 0);
    assert!(!folder.path().join("work/reports").exists(), "a commit writes nothing");
    let wrong = LAW.replace(r"always = ['\dot x=-x']", r"always = ['\dot x=x']");
    fs::write(folder.path().join("work/derivations/decay.toml"), wrong).expect("written");
    let (code, text) = run(folder.path(), &commit, &[]);
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("law"), "{text}");
}
