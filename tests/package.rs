//! What is shipped: the package, the licences of what it is built from, the oldest compiler, the files for a repository's CI.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Licences under which a dependency may be used: permissive, without conditions on programs that link to it.
const LICENCES: &[&str] = &[
    "MIT",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "Zlib",
    "CC0-1.0",
    "Unicode-3.0",
    "Unicode-DFS-2016",
    "Unlicense",
    "0BSD",
    "BSL-1.0",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn cargo(arguments: &[&str]) -> String {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let output = Command::new(cargo).current_dir(root()).args(arguments).output().expect("cargo runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The dependency graph on this platform.
fn metadata() -> Value {
    let version = Command::new(std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned())).arg("-vV").output();
    let version = String::from_utf8(version.expect("rustc runs").stdout).expect("UTF-8");
    let host = version.lines().find_map(|l| l.strip_prefix("host: ")).expect("a host").to_owned();
    let arguments = ["metadata", "--locked", "--format-version", "1", "--filter-platform", &host];
    serde_json::from_str(&cargo(&arguments)).expect("metadata is JSON")
}

/// Packages by id that the program is built from; with `tests`, also those of its tests.
fn reached(metadata: &Value, tests: bool) -> BTreeSet<String> {
    let nodes = metadata["resolve"]["nodes"].as_array().expect("nodes");
    let nodes: BTreeMap<&str, &Value> = nodes.iter().map(|n| (n["id"].as_str().expect("an id"), n)).collect();
    let start = metadata["resolve"]["root"].as_str().expect("a root").to_owned();
    let mut out = BTreeSet::from([start.clone()]);
    let mut open = vec![start.clone()];
    while let Some(id) = open.pop() {
        for dependency in nodes[id.as_str()]["deps"].as_array().expect("dependencies") {
            let kinds = dependency["dep_kinds"].as_array().expect("kinds");
            let of_program = kinds.iter().any(|k| k["kind"] != "dev") || tests && id == start;
            let target = dependency["pkg"].as_str().expect("an id").to_owned();
            if of_program && out.insert(target.clone()) {
                open.push(target);
            }
        }
    }
    out
}

fn packages(metadata: &Value, tests: bool) -> Vec<Value> {
    let ids = reached(metadata, tests);
    let all = metadata["packages"].as_array().expect("packages").iter();
    all.filter(|p| p["id"].as_str().is_some_and(|id| ids.contains(id))).cloned().collect()
}

/// Whether a licence expression leaves a choice of allowed licences: AND binds what OR offers.
fn is_allowed(expression: &str) -> bool {
    let expression = expression.replace('/', " OR ");
    // Groups in parentheses are choices in the expressions that occur; any other nesting is refused.
    let one = |part: &str| part.split(" OR ").any(|l| LICENCES.contains(&l.trim()));
    expression.split(" AND ").all(|part| {
        let part = part.trim();
        let inner = part.strip_prefix('(').and_then(|p| p.strip_suffix(')')).unwrap_or(part);
        !inner.contains(['(', ')']) && one(inner)
    })
}

#[test]
fn licences_are_read_rightly() {
    for good in ["MIT", "MIT/Apache-2.0", "GPL-3.0 OR MIT", "(MIT OR Apache-2.0) AND Unicode-3.0"] {
        assert!(is_allowed(good), "{good}");
    }
    for bad in ["", "GPL-3.0", "LGPL-3.0-or-later", "MIT AND GPL-3.0", "MPL-2.0", "(MIT AND GPL-3.0) OR LGPL-2.1"] {
        assert!(!is_allowed(bad), "{bad}");
    }
}

#[test]
fn every_dependency_has_a_permissive_licence() {
    let metadata = metadata();
    let all = packages(&metadata, true);
    assert!(all.len() > 50, "{}", all.len());
    for package in all {
        let licence = package["license"].as_str().unwrap_or_default();
        assert!(is_allowed(licence), "{}: `{licence}`", package["name"]);
    }
}

#[test]
fn the_oldest_compiler_is_what_the_dependencies_need() {
    let number = |text: &str| -> Vec<u64> { text.split('.').filter_map(|n| n.parse().ok()).take(2).collect() };
    let metadata = metadata();
    let all = packages(&metadata, false);
    let own = all.iter().find(|p| p["name"] == env!("CARGO_PKG_NAME")).expect("this package");
    let own = number(own["rust_version"].as_str().expect("a stated version"));
    for package in &all {
        let needed = package["rust_version"].as_str().map(number).unwrap_or_default();
        assert!(needed <= own, "{} needs {needed:?}, stated is {own:?}", package["name"]);
    }
    // The README and the page on stability say the same.
    let shown = own.iter().map(u64::to_string).collect::<Vec<_>>().join(".");
    assert!(read("docs/stability.md").contains(&format!("Rust {shown}")), "docs/stability.md names another version");
}

#[test]
fn the_package_has_what_it_needs_and_nothing_else() {
    let list = cargo(&["package", "-p", env!("CARGO_PKG_NAME"), "--list", "--offline", "--allow-dirty"]);
    let files: BTreeSet<&str> = list.lines().collect();
    for needed in [
        "Cargo.toml",
        "Cargo.lock",
        "README.md",
        "CHANGELOG.md",
        "LICENSE-MIT",
        "LICENSE-APACHE",
        "src/main.rs",
        "src/lib.rs",
        "docs/derivation-file.md",
        "docs/schema/derivation.schema.json",
        "derivations/pendulum.toml",
    ] {
        assert!(files.contains(needed), "{needed} is not in the package");
    }
    let mut size = 0;
    for file in files {
        let stray = [".ci/", "reports/", "target/"].iter().any(|f| file.starts_with(f)) || file.ends_with(".snap.new");
        assert!(!stray, "{file} is in the package");
        size += std::fs::metadata(root().join(file)).map_or(0, |m| m.len());
    }
    assert!(size < 8 << 20, "the package has {size} bytes");
}

/// A front end of another kind does not drag in a command line.
#[test]
fn the_library_needs_no_terminal() {
    let tree = |more: &[&str]| {
        let base = ["tree", "--offline", "--locked", "-p", env!("CARGO_PKG_NAME"), "-e", "normal", "--prefix", "none"];
        cargo(&[&base[..], more].concat())
    };
    let names =
        |text: &str| text.lines().filter_map(|l| l.split(' ').next()).map(str::to_owned).collect::<BTreeSet<_>>();
    let (program, library) = (names(&tree(&[])), names(&tree(&["--no-default-features"])));
    for name in ["clap", "clap_complete", "clap_mangen", "indicatif", "mimalloc"] {
        assert!(program.contains(name) && !library.contains(name), "{name}");
    }
    assert!(library.contains("rederive-check") && library.contains("rederive-report"));
}

#[test]
fn the_files_for_ci_use_what_the_program_has() {
    let help = |command: &str| {
        let run = Command::new(env!("CARGO_BIN_EXE_rederive")).args([command, "--help"]).output().expect("it runs");
        String::from_utf8(run.stdout).expect("UTF-8")
    };
    let has = ["check", "diff", "lint"].map(help);
    for file in ["action.yml", ".pre-commit-hooks.yaml", "docs/continuous-integration.md"] {
        let text = read(file);
        let mut seen = 0;
        for line in text.lines().filter(|l| l.contains("--") && !l.contains("cargo install") && !l.contains("rustup")) {
            for word in line.split(|c: char| c.is_whitespace() || "`()\"".contains(c)).filter(|w| w.starts_with("--")) {
                let flag = word.split('=').next().unwrap_or(word).trim_end_matches([',', '.', ';', ':']);
                if flag.len() > 2 && !flag.starts_with("---") {
                    assert!(has.iter().any(|h| h.contains(flag)), "{file}: there is no {flag}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 0, "{file}");
    }
    // Every input is used, every input that is used is there.
    let action = read("action.yml");
    let named: BTreeSet<&str> = action
        .split("inputs:\n")
        .nth(1)
        .and_then(|t| t.split("\noutputs:").next())
        .map(|t| {
            t.lines().filter(|l| l.starts_with("  ") && !l.starts_with("   ")).map(|l| l.trim().trim_end_matches(':'))
        })
        .expect("inputs")
        .filter(|l| !l.is_empty())
        .collect();
    let used: BTreeSet<&str> = action
        .split("inputs.")
        .skip(1)
        .filter_map(|t| t.split(|c: char| !c.is_ascii_alphanumeric() && c != '-').next())
        .collect();
    assert_eq!(named, used);
    assert!(!action.contains('\t') && !read(".pre-commit-hooks.yaml").contains('\t'), "YAML has no tabs");
}

#[test]
fn the_page_on_rules_has_every_rule() {
    let page = read("docs/continuous-integration.md");
    for file in ["src/report/finding.rs", "src/report/paper.rs", "src/paper/lib.rs"] {
        for part in read(file).split('"').skip(1).step_by(2) {
            let is_rule = ["verdict::", "paper::"].iter().any(|r| part.starts_with(r) && part.len() > r.len());
            assert!(!is_rule || page.contains(&format!("`{part}`")), "{file}: `{part}` is not on the page");
        }
    }
}

/// `cargo binstall` finds the archives of a release by name. The workflow is not in the package.
#[test]
fn binstall_takes_what_a_release_makes() {
    let Ok(release) = std::fs::read_to_string(root().join(".github/workflows/release.yml")) else { return };
    let manifest: toml::Table = read("Cargo.toml").parse().expect("TOML");
    let taken = |key: &str| manifest["package"]["metadata"]["binstall"][key].as_str().expect("a text");
    let name = release.lines().find_map(|l| l.trim().strip_prefix("name=\"")?.strip_suffix('"')).expect("a name");
    let name = name.replace("$TARGET", "{ target }");
    assert!(release.contains("tar -czf \"$name.tgz\" \"$name\"") && release.contains("tags: [\"v[0-9]*\"]"));
    assert_eq!(taken("pkg-fmt"), "tgz");
    assert_eq!(taken("pkg-url"), format!("{{ repo }}/releases/download/v{{ version }}/{name}.tgz"));
    assert_eq!(taken("bin-dir"), format!("{name}/{{ bin }}{{ binary-ext }}"));
}

/// What a workflow takes from elsewhere is named by the hash of its content, with the version beside it. Workflows are not in the package.
#[test]
fn workflows_name_what_they_take_by_its_hash() {
    let Ok(folder) = std::fs::read_dir(root().join(".github/workflows")) else { return };
    let mut taken = 0;
    for file in folder.map(|entry| entry.expect("an entry").path()) {
        let text = std::fs::read_to_string(&file).expect("a workflow");
        assert!(text.contains("\npermissions: {}\n"), "{}: a job has the permissions that it names", file.display());
        for line in text.lines().filter_map(|l| l.trim().trim_start_matches("- ").strip_prefix("uses: ")) {
            let (name, version) = line.split_once(" # v").unwrap_or((line, ""));
            let hash = name.split_once('@').map_or("", |(_, hash)| hash);
            let is_hash = hash.len() == 40 && hash.bytes().all(|b| b.is_ascii_hexdigit());
            assert!(is_hash && !version.is_empty(), "{}: {line}", file.display());
            taken += 1;
        }
    }
    assert!(taken > 10, "{taken}");
}

/// `cargo run` is about all crates here, `cargo install` about one: what the first has compiled serves the second.
#[test]
fn what_is_run_here_is_what_is_installed() {
    let features = |more: &[&str]| -> BTreeSet<String> {
        let base = ["tree", "--offline", "--locked", "-e", "normal", "--prefix", "none", "-f", "{p} {f}"];
        let text = cargo(&[&base[..], more].concat());
        let own = text.lines().filter(|l| l.starts_with("rederive"));
        own.map(|l| l.trim_end_matches(" (*)").to_owned()).collect()
    };
    let all = features(&[]);
    assert!(all.len() > 10, "{all:?}");
    assert_eq!(all, features(&["-p", env!("CARGO_PKG_NAME")]));
}

/// Every lane of `.ci/lanes` is one of `.ci/run`, and what brings it in is there. Neither file is in the package.
#[test]
fn lanes_of_ci_name_what_is_there() {
    let Ok(lanes) = std::fs::read_to_string(root().join(".ci/lanes")) else { return };
    let run = read(".ci/run");
    // Up to its first `*`, a pattern is a folder and the beginning of a name.
    let is_there = |pattern: &str| {
        let (before, _) = pattern.split_once('*').unwrap_or((pattern, ""));
        if before.len() == pattern.len() {
            return root().join(pattern).exists();
        }
        let (folder, name) = before.rsplit_once('/').unwrap_or(("", before));
        std::fs::read_dir(root().join(folder))
            .is_ok_and(|mut all| all.any(|e| e.is_ok_and(|e| e.file_name().to_string_lossy().starts_with(name))))
    };
    let mut count = 0;
    for line in lanes.lines().filter(|l| !l.starts_with('#') && !l.trim().is_empty()) {
        let mut words = line.split_whitespace();
        let lane = words.next().expect("the line has words");
        assert!(run.contains(&format!("\nlane_{lane}() {{\n")), ".ci/run: there is no lane {lane}");
        let patterns: Vec<&str> = words.collect();
        assert!(!patterns.is_empty(), ".ci/lanes: nothing brings {lane} in");
        for pattern in patterns {
            assert!(is_there(pattern), ".ci/lanes, {lane}: there is no {pattern}");
        }
        count += 1;
    }
    assert!(count > 5 && run.matches("\nlane_").count() == count, "{count} lanes");
}
