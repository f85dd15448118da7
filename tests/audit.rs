//! Recorded proofs are replayed from the report alone, and what was changed in one is refused.

use assert_cmd::Command;
use std::fs;
use std::path::{Path, PathBuf};

fn audit(path: &Path) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    let run = command.args(["audit", &path.display().to_string()]).output().expect("it runs");
    let text = String::from_utf8(run.stdout).expect("UTF-8") + &String::from_utf8_lossy(&run.stderr);
    (run.status.code().unwrap_or(-1), text)
}

fn reports() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports")
}

#[test]
fn every_recorded_proof_of_the_reports_is_replayed() {
    let (code, text) = audit(&reports());
    // A package without the committed reports has nothing to replay.
    if !reports().exists() {
        return;
    }
    assert_eq!(code, 0, "{text}");
    assert!(!text.contains("REFUSED") && text.contains("13 of 13 recorded claims are replayed."), "{text}");
    let words = r"`\ddot{q}=-\frac{g}{\ell}\cdot \sin(q)` at all times";
    assert!(text.contains(words) && text.contains(r"at every time, `h=h(t_{\ast})`"), "{text}");
}

#[test]
fn what_was_changed_in_a_proof_is_refused_with_its_step() {
    let path = reports().join("pendulum/proofs.json");
    let Ok(text) = fs::read_to_string(&path) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let changed = folder.path().join("proofs.json");
    // Another system, another claim, another fact, a step less; none of them proves what it says then.
    for (old, new) in [
        (r#""name":"\\ell","component":0,"rate":0,"at":null"#, r#""name":"g","component":0,"rate":0,"at":null"#),
        (r#""rate":2"#, r#""rate":1"#),
        (r#""1/2""#, r#""1/3""#),
        (r#"{"conclude":"#, r#"{"rate":"#),
    ] {
        let dense: String = text.split_whitespace().collect();
        assert!(dense.contains(old), "{old}");
        fs::write(&changed, dense.replacen(old, new, 1)).expect("written");
        let (code, said) = audit(&changed);
        assert!(code == 1 && said.contains("refused"), "{old}: {code}, {said}");
    }
    fs::write(&changed, "{}").expect("written");
    let (code, said) = audit(&changed);
    assert!(code == 2 && said.contains("this is no proofs.json"), "{code}, {said}");
}
