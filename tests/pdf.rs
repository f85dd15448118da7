//! `rederive report --pdf`: with programs that only look like LaTeX engines and browsers, and with those that are here.
#![cfg(unix)]

use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use predicates::prelude::*;

/// A derivation that is soon checked.
fn small() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/decay.toml")
}

/// A folder with programs, each a script.
fn programs(scripts: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, script) in scripts {
        let path = folder.path().join(name);
        std::fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("a script");
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).expect("a program");
    }
    folder
}

/// The command, with these programs only.
fn report(path: &Path, pdf: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.env("PATH", path).args(["report", "--rigor", "sampled", "--pdf"]).arg(pdf).arg(small());
    command
}

const GOOD: &str = "printf '%%PDF-1.5\\n%%%%EOF\\n' > report.pdf";

#[test]
fn the_first_program_that_is_there_makes_it() {
    let source = "for last; do :; done; [ \"$last\" = report.tex ] || exit 1; \
                  case \"$(/bin/cat report.tex)\" in *'\\documentclass'*) ;; *) exit 1;; esac; ";
    let folder = programs(&[("pdflatex", &format!("{source}{GOOD}")), ("chromium", "exit 1")]);
    let pdf = folder.path().join("out/of/the/way.pdf");
    report(folder.path(), &pdf).assert().code(0).stderr(predicate::str::contains("written by pdflatex"));
    assert_eq!(std::fs::read(pdf).expect("it is there"), b"%PDF-1.5\n%%EOF\n");
}

#[test]
fn a_browser_prints_the_page_where_latex_fails() {
    let print = "[ -s index.html ] || exit 1; for a; do case \"$a\" in --print-to-pdf=*) \
                 printf '%%PDF-1.7\\n%%%%EOF\\n' > \"${a#--print-to-pdf=}\";; esac; done";
    let folder = programs(&[("pdflatex", "echo '! a package is missing'; exit 1"), ("google-chrome", print)]);
    let pdf = folder.path().join("report.pdf");
    report(folder.path(), &pdf).assert().code(0).stderr(predicate::str::contains("written by google-chrome"));
    assert!(std::fs::read(pdf).expect("it is there").starts_with(b"%PDF-1.7"));
}

#[test]
fn what_is_missing_is_named_and_nothing_is_written() {
    let folder = programs(&[]);
    let pdf = folder.path().join("report.pdf");
    let names = predicate::str::contains("pdflatex").and(predicate::str::contains("chromium"));
    report(folder.path(), &pdf).assert().code(2).stderr(names.and(predicate::str::contains("PATH")));
    assert!(!pdf.exists());
}

#[test]
fn what_was_there_stays_where_no_program_succeeds() {
    for (script, why) in [
        ("echo '! Undefined control sequence.'; exit 1", "failed: ! Undefined control sequence."),
        ("exit 0", "wrote no PDF file"),
        ("echo nothing > report.pdf", "no whole PDF file"),
        ("printf '%%PDF-1.5\\nhalf' > report.pdf", "no whole PDF file"),
    ] {
        let folder = programs(&[("latexmk", script), ("chromium", "exit 3")]);
        let pdf = folder.path().join("report.pdf");
        std::fs::write(&pdf, "before").expect("a file");
        let told = predicate::str::contains(why).and(predicate::str::contains("chromium failed"));
        report(folder.path(), &pdf).assert().code(2).stderr(told);
        assert_eq!(std::fs::read(&pdf).expect("it is there"), b"before", "{script}");
    }
}

#[test]
fn a_file_with_problems_is_told_before_any_program_runs() {
    let folder = programs(&[("pdflatex", GOOD)]);
    let pdf = folder.path().join("report.pdf");
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.env("PATH", folder.path()).args(["report", "no-such-file.toml", "--pdf"]).arg(&pdf);
    command.assert().code(2);
    assert!(!pdf.exists());
}

/// What is on the PATH here: a PDF file with pages, or a clear refusal.
#[test]
fn the_programs_that_are_here_make_it() {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let find = |name: &&str| std::env::split_paths(&path).any(|folder| folder.join(name).is_file());
    for name in ["pdflatex", "chromium"].iter().filter(|name| find(name)) {
        // Only this one, with everything that it needs itself.
        let folder = programs(&[(*name, &format!("PATH='{}' exec {name} \"$@\"", path.to_string_lossy()))]);
        let pdf = folder.path().join("report.pdf");
        let outcome = report(folder.path(), &pdf).assert().code(0);
        outcome.stderr(predicate::str::contains(format!("written by {name}")));
        let found = std::fs::read(&pdf).expect("it is there");
        assert!(found.starts_with(b"%PDF-") && found.len() > 20_000, "{name}: {} bytes", found.len());
    }
}
