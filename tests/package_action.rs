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
    put_program(folder.path());
    folder
}

/// The program of this test, where the action would have put it.
fn put_program(folder: &Path) {
    let program = folder.join("runner/rederive/bin/rederive");
    std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_rederive"), program).expect("a link");
}

/// Whether this is the repository: how the program is had is not in the package.
fn in_the_repository() -> bool {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(".ci").is_dir()
}

/// What of the action's repository says how the program is had.
fn copy_of_the_action(to: &Path) {
    fs::create_dir_all(to.join(".ci")).expect("made");
    let from = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in [".ci/program", ".ci/hook", "Cargo.toml"] {
        fs::copy(from.join(name), to.join(name)).expect("copied");
    }
}

/// A program of a shell, which is all that a tool or a released program is here.
fn script_at(path: &Path, text: &str) {
    use std::os::unix::fs::PermissionsExt;
    fs::create_dir_all(path.parent().expect("a folder")).expect("made");
    fs::write(path, format!("#!/bin/sh\n{text}\n")).expect("written");
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).expect("made a program");
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
    action_beside(folder, source, "")
}

/// The same with reports to compare with.
fn action_beside(folder: &Path, source: &str, baseline: &str) -> (i32, String) {
    let own = [("FILES", "derivations"), ("SOURCE", source), ("SARIF", "rederive.sarif"), ("JUNIT", "rederive.xml")];
    let inputs: Vec<_> = own.into_iter().chain([("BASELINE", baseline)]).collect();
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

/// Names that are none are those of no file, as an empty input is; and nothing is compared.
#[test]
fn the_action_checks_nothing_where_no_file_is_named() {
    let folder = repository(LAW);
    for files in [" ", "\n", " \t\n "] {
        let inputs = [("FILES", files), ("SOURCE", ""), ("SARIF", "s.sarif"), ("JUNIT", "s.xml"), ("BASELINE", "b")];
        assert_eq!(run(folder.path(), &script("Check"), &inputs), (0, String::new()), "{files:?}");
        assert!(!folder.path().join("output").exists() && !folder.path().join("work/s.sarif").exists());
    }
    assert_eq!(run(folder.path(), &script("Result"), &[("CODE", ""), ("PAPERS", "")]).0, 0);
    assert!(read("action.yml").contains("if: inputs.baseline != '' && steps.check.outputs.reports != ''"));
}

/// What the tree says that is checked, about cargo, toolchains or names like options, changes nothing.
#[test]
fn the_action_builds_a_copy_and_takes_no_name_for_an_option() {
    if !in_the_repository() {
        return;
    }
    let folder = repository(LAW);
    let at = |name: &str| folder.path().join(name);
    for made in ["work/rederive", "work/.cargo", "tools"] {
        fs::create_dir_all(at(made)).expect("made");
    }
    fs::write(at("work/.cargo/config.toml"), "[build]\nrustc-wrapper = 'owned'\n").expect("written");
    fs::write(at("work/rust-toolchain.toml"), "[toolchain]\nchannel = 'owned'\n").expect("written");
    copy_of_the_action(&at("work/rederive"));
    // They tell where they are, and with what they are called.
    for tool in ["cargo", "rustup"] {
        script_at(&at("tools").join(tool), r#"echo "$0 in $PWD: $* with $RUSTUP_TOOLCHAIN""#);
    }
    let path = format!("{}:{}", at("tools").display(), std::env::var("PATH").unwrap_or_default());
    let source = at("work/rederive").display().to_string();
    fs::remove_file(at("runner/rederive/bin/rederive")).expect("removed");
    let inputs = [
        ("PATH", path.as_str()),
        ("GITHUB_ACTION_PATH", source.as_str()),
        ("RUSTUP_TOOLCHAIN", "1.89.0"),
        ("REPOSITORY", ""),
        ("REF", ""),
        ("SERVER", ""),
    ];
    let (code, text) = run(folder.path(), &script("Program"), &inputs);
    assert_eq!(code, 0, "{text}");
    let built = text.lines().find(|l| l.contains("cargo in")).expect("cargo is called");
    assert!(built.contains("/runner/rederive/sources.") && built.contains(": install --locked --path . "), "{built}");
    assert!(built.ends_with("1.89.0"), "{built}");
    assert!(read("action.yml").contains("RUSTUP_TOOLCHAIN: 1.89.0"), "the toolchain is fixed");
    put_program(folder.path());

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
    // What the tree has at hand as a report is none of this run.
    let copied = fs::read_dir(folder.path().join("work/before/decay")).expect("listed");
    fs::create_dir_all(folder.path().join("work/reports/decay")).expect("made");
    for file in copied.map(|f| f.expect("a file").path()).filter(|f| f.is_file()) {
        let name = file.file_name().expect("a name");
        fs::copy(&file, folder.path().join("work/reports/decay").join(name)).expect("copied");
    }
    let compare = |inputs: &[(&str, &str)]| {
        let (code, text) = run(folder.path(), &script("Compare"), inputs);
        assert_eq!(code, 0, "{text}");
        let summary = fs::read_to_string(folder.path().join("summary")).expect("written");
        fs::remove_file(folder.path().join("summary")).expect("removed");
        summary
    };
    let written = || {
        let output = fs::read_to_string(folder.path().join("output")).expect("an output");
        output.lines().rev().find_map(|l| l.strip_prefix("reports=")).expect("a folder").to_owned()
    };
    assert_eq!(action_beside(folder.path(), "", "before").0, 1);
    let reports = written();
    assert!(reports.starts_with(&folder.path().join("runner").display().to_string()), "{reports}");
    let summary = compare(&[("BASELINE", "before"), ("REPORTS", &reports)]);
    assert!(summary.contains("law") && summary.contains("fails"), "{summary}");
    // A file that is taken away takes its verdicts away, whatever report the tree has of it.
    for name in ["other", "another"] {
        fs::write(folder.path().join(format!("work/derivations/{name}.toml")), LAW).expect("written");
    }
    fs::remove_file(folder.path().join("work/derivations/decay.toml")).expect("removed");
    assert_eq!(action_beside(folder.path(), "", "before").0, 0);
    let summary = compare(&[("BASELINE", "before"), ("REPORTS", &written())]);
    assert!(summary.contains("Worse") && summary.contains("decay"), "{summary}");
}

/// A release is taken if it is what its checksums say and of this version; otherwise the program is compiled.
#[test]
fn a_released_program_is_taken_if_it_is_whole() {
    if !in_the_repository() {
        return;
    }
    let (folder, version) = (tempfile::tempdir().expect("a folder"), env!("CARGO_PKG_VERSION"));
    let at = |name: &str| folder.path().join(name);
    fs::create_dir_all(at("work")).expect("made");
    copy_of_the_action(&at("action"));
    script_at(&at("tools/cargo"), "echo compiled");
    let target = match std::env::consts::ARCH {
        "aarch64" if cfg!(target_os = "linux") => "aarch64-unknown-linux-musl",
        "aarch64" => "aarch64-apple-darwin",
        _ if cfg!(target_os = "linux") => "x86_64-unknown-linux-musl",
        _ => "x86_64-apple-darwin",
    };
    let released = |says: &str, sum: &str| {
        script_at(&at(&format!("release/rederive-{target}/rederive")), &format!("echo {says}"));
        let pack = format!(
            "cd release && tar -czf rederive-{target}.tgz rederive-{target} && \
             {{ sha256sum *.tgz || shasum -a 256 *.tgz; }} > SHA256SUMS && {sum}"
        );
        let done = Command::new("bash").args(["-c", &pack]).current_dir(folder.path()).status().expect("bash runs");
        assert!(done.success());
        let _ = fs::remove_dir_all(at("to"));
        let path = format!("{}:{}", at("tools").display(), std::env::var("PATH").unwrap_or_default());
        let line = format!("{0}/action/.ci/program {0}/to file://{0}/release", folder.path().display());
        run(folder.path(), &line, &[("PATH", &path)])
    };
    let own = format!("rederive {version}");
    let (code, text) = released(&own, "true");
    assert_eq!((code, text.contains("compiled")), (0, false), "{text}");
    assert!(text.trim_end().ends_with("/to/bin/rederive") && at("to/bin/rederive").is_file(), "{text}");
    // Nothing is left beside it.
    assert_eq!(fs::read_dir(at("to")).expect("listed").count(), 1);
    // Other bytes than those of the checksums; another version; no archive.
    let other = "sed -i.old -e 's/^0/f/' -e t -e 's/^./0/' SHA256SUMS";
    let (_, text) = released(&own, other);
    assert!(text.contains("not the one of its checksums") && text.contains("is compiled"), "{text}");
    let (_, text) = released("rederive 99.0.0", "true");
    assert!(text.contains("is compiled") && !at("to/bin/rederive").exists(), "{text}");
    let (_, text) = released(&own, "rm *.tgz");
    assert!(text.contains("is compiled"), "{text}");
}

#[test]
fn the_action_looks_through_papers() {
    let folder = repository(LAW);
    let at = |name: &str| folder.path().join("work").join(name);
    fs::create_dir_all(at("notes")).expect("made");
    fs::write(at("a.tex"), "\\[1+1=2\\]\n").expect("written");
    fs::write(at("notes/b.tex"), "Text.\n\\[(a+b)^2=a^2-2ab+b^2\\]\n").expect("written");
    let papers = |names: &str| {
        let inputs = [("PAPERS", names), ("SARIF", "papers.sarif"), ("PAGES", "pages")];
        let (code, text) = run(folder.path(), &script("Papers"), &inputs);
        assert_eq!(code, 0, "the step itself goes on: {text}");
        let output = fs::read_to_string(folder.path().join("output")).expect("an output");
        let found = output.lines().next_back().and_then(|l| l.strip_prefix("exit-code=")).expect("an exit code");
        let (code, _) = run(folder.path(), &script("Result"), &[("CODE", ""), ("PAPERS", found)]);
        (code, text)
    };
    assert_eq!(papers("a.tex").0, 0);
    let (code, text) = papers("a.tex ./notes/b.tex");
    assert_eq!(code, 1);
    assert!(text.contains("::error") && text.contains("notes/b.tex") && text.contains("line=2"), "{text}");
    assert!(fs::read_to_string(at("papers.sarif")).expect("written").contains("lint::wrong"));
    assert!(at("pages/a.tex.html").is_file() && at("pages/notes-b.tex.html").is_file());
    // Two papers whose names differ in a bar alone have two pages, in any order.
    fs::write(at("notes-b.tex"), "\\[x=1\\]\n").expect("written");
    papers("notes-b.tex notes/b.tex");
    let page = |name: &str| fs::read_to_string(at(&format!("pages/{name}.html"))).expect("a page");
    assert!(page("notes-b.tex-2").contains("notes/b.tex") && !page("notes-b.tex").contains("notes/b.tex"));
    assert_eq!(papers("nowhere.tex").0, 2);
    // Names that are none are not those of the project.
    fs::write(at("rederive.toml"), "sources = [\"notes/b.tex\"]\n").expect("written");
    let inputs = [("PAPERS", " "), ("SARIF", "papers.sarif"), ("PAGES", "pages")];
    assert_eq!(run(folder.path(), &script("Papers"), &inputs), (0, String::new()));
    fs::remove_file(at("rederive.toml")).expect("removed");
    // A link that the repository brings along is not followed to what it leads to.
    fs::remove_file(at("papers.sarif")).expect("removed");
    fs::write(folder.path().join("theirs"), "kept").expect("written");
    std::os::unix::fs::symlink("../theirs", at("papers.sarif")).expect("linked");
    assert_eq!(papers("a.tex").0, 2);
    assert_eq!(fs::read_to_string(folder.path().join("theirs")).expect("there"), "kept");
    // What derivation files say comes first.
    assert_eq!(run(folder.path(), &script("Result"), &[("CODE", "3"), ("PAPERS", "1")]).0, 3);
}

/// The entry of a hook, as it is run in the folder of the action's repository.
fn hook(folder: &Path, id: &str, files: &str) -> (i32, String) {
    let hooks = read(".pre-commit-hooks.yaml");
    let (_, own) = hooks.split_once(&format!("- id: {id}\n")).unwrap_or_else(|| panic!("no hook {id}"));
    let entry = own.lines().find_map(|l| l.trim().strip_prefix("entry:")).expect("an entry").trim();
    let path =
        format!("{}:{}", folder.join("runner/rederive/bin").display(), std::env::var("PATH").unwrap_or_default());
    // pre-commit puts the files that are committed behind the entry, which is of its copy of this repository.
    let line = format!("{}/{entry} {files}", env!("CARGO_MANIFEST_DIR"));
    run(folder, &line, &[("PATH", &path)])
}

#[test]
fn the_hook_stops_a_commit_with_a_wrong_claim() {
    if !in_the_repository() {
        return;
    }
    let folder = repository(LAW);
    assert_eq!(hook(folder.path(), "rederive", "derivations/decay.toml").0, 0);
    assert!(!folder.path().join("work/reports").exists(), "a commit writes nothing");
    let wrong = LAW.replace(r"always = ['\dot x=-x']", r"always = ['\dot x=x']");
    fs::write(folder.path().join("work/derivations/decay.toml"), wrong).expect("written");
    let (code, text) = hook(folder.path(), "rederive", "derivations/decay.toml");
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("law"), "{text}");
}

/// In a worktree Git tells a hook of the repository that is committed to: neither its tags nor its address say where a release is.
#[test]
fn the_hook_asks_nothing_of_the_repository_that_is_committed_to() {
    if !in_the_repository() {
        return;
    }
    let folder = repository(LAW);
    let at = |name: &str| folder.path().join(name);
    copy_of_the_action(&at("kept"));
    let theirs = at("theirs").display().to_string();
    let tag = format!("v{}", env!("CARGO_PKG_VERSION"));
    let make = format!(
        "git init -q '{theirs}' && cd '{theirs}' && git -c user.name=a -c user.email=a@b.c commit -q --allow-empty -m a && \
         git tag {tag} && git remote add origin https://github.com/evil/repo"
    );
    assert_eq!(run(folder.path(), &make, &[]).0, 0);
    // It tells what it would be asked for, and there is no installed program.
    script_at(&at("tools/curl"), "echo \"asked: $*\" >&2; exit 1");
    script_at(&at("tools/cargo"), "echo compiled >&2");
    script_at(&at("tools/rederive"), "echo rederive 0.0.0");
    let path = format!("{}:{}", at("tools").display(), std::env::var("PATH").unwrap_or_default());
    let git = format!("{theirs}/.git");
    let line = format!("{}/kept/.ci/hook list", folder.path().display());
    let (_, text) = run(folder.path(), &line, &[("PATH", &path), ("GIT_DIR", &git), ("GIT_WORK_TREE", &theirs)]);
    assert!(text.contains("compiled") && !text.contains("evil"), "{text}");
}

#[test]
fn the_hook_stops_a_commit_with_a_wrong_step_of_a_paper() {
    if !in_the_repository() {
        return;
    }
    let folder = repository(LAW);
    let at = |name: &str| folder.path().join("work").join(name);
    fs::write(at("a.tex"), "\\[1+1=2\\]\n").expect("written");
    fs::write(at("b.tex"), "\\[(a+b)^2=a^2-2ab+b^2\\]\n").expect("written");
    assert_eq!(hook(folder.path(), "rederive-lint", "a.tex").0, 0);
    let (code, text) = hook(folder.path(), "rederive-lint", "a.tex b.tex");
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("b.tex:1") && text.contains("a^2+2ab+b^2"), "{text}");
}
