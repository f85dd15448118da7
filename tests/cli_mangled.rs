//! Mangled files: whatever bytes a file has, the program reads it, or says what is wrong with it, and never panics.
//!
//! The three derivations of the project and a paper are cut, doubled, flipped and mixed from fixed seeds. `REDERIVE_SEEDS` sets
//! how many of each there are.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use assert_cmd::Command;

/// A reproducible source of numbers (splitmix64).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n.max(1) as u64) as usize
    }
}

/// What may be put into a file: bytes that mean something there, and bytes that mean nothing anywhere.
const PIECES: &[&[u8]] = &[
    b"\0",
    b"\xff",
    b"\xc3",
    b"\n",
    b"'",
    b"\"",
    b"'''",
    b"[",
    b"]",
    b"{",
    b"}",
    b"[[claim]]\n",
    b"=",
    b"\\frac",
    b"\\dot",
    b"_{",
    b"^",
    b"&",
    b"\\\\",
    b"1e999",
    b"-",
    b"nan",
    b"9223372036854775808",
    b"\\left(",
    b"$",
    b"\\begin{array}",
    b"\r\n",
    b"\xef\xbb\xbf",
    b"\xe2\x80\xae",
    b"0.000000000000000000000000000000000000000000000001",
];

fn mangled(bytes: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut out = bytes.to_vec();
    for _ in 0..1 + dice.below(4) {
        let at = dice.below(out.len() + 1);
        let end = (at + dice.below(40)).min(out.len());
        match dice.below(7) {
            0 => out.truncate(at),
            1 => drop(out.drain(at..end)),
            2 => {
                let copy = out[at..end].to_vec();
                let to = dice.below(out.len() + 1);
                out.splice(to..to, copy);
            }
            3 if at < out.len() => out[at] ^= 1 << dice.below(8),
            4 if at < out.len() => out[at] = dice.below(256) as u8,
            _ => {
                let piece = PIECES[dice.below(PIECES.len())];
                out.splice(at..at, piece.iter().copied());
            }
        }
    }
    out
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn seeds() -> u64 {
    std::env::var("REDERIVE_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(24)
}

/// Runs the program; its exit code, which must be one of those that it promises, and no panic.
#[track_caller]
fn code(folder: &Path, arguments: &[&str], allowed: &[i32], what: &str) -> i32 {
    let mut command = Command::cargo_bin("rederive").expect("it is built");
    let run = command.current_dir(folder).args(arguments).timeout(Duration::from_secs(300)).output().expect("it runs");
    let problems = String::from_utf8_lossy(&run.stderr).into_owned();
    let code = run.status.code().unwrap_or(-1);
    assert!(!problems.contains("panicked"), "{what}: {problems}");
    assert!(allowed.contains(&code), "{what}: exit code {code}: {problems}");
    assert!(code != 2 || !problems.is_empty(), "{what}: exit code 2 without a word");
    code
}

/// A file on which the program is tried, in a folder of its own.
fn placed(name: &str, bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, bytes).expect("written");
    (folder, path)
}

#[test]
fn mangled_derivations_are_read_or_refused() {
    let mut refused = 0;
    for name in ["deriglazov-comment.toml", "kepler.toml", "pendulum.toml"] {
        let whole = fs::read(root().join("derivations").join(name)).expect("it is there");
        for seed in 0..seeds() {
            let bytes = mangled(&whole, &mut Dice(seed));
            let (folder, _) = placed(name, &bytes);
            let what = format!("{name}, seed {seed}");
            refused += u64::from(code(folder.path(), &["list", name], &[0, 2], &what) == 2);
        }
    }
    assert!(refused > seeds(), "most are no derivations: {refused}");
}

#[test]
fn what_is_left_of_a_mangled_derivation_is_checked() {
    let whole = fs::read(root().join("derivations/pendulum.toml")).expect("it is there");
    let mut read = 0;
    for seed in 100..100 + 2 * seeds() {
        let bytes = mangled(&whole, &mut Dice(seed));
        let (folder, _) = placed("pendulum.toml", &bytes);
        let what = format!("seed {seed}");
        let found = code(folder.path(), &["check", "pendulum.toml", "--quiet"], &[0, 1, 2, 3], &what);
        read += usize::from(found != 2);
        assert_eq!(
            folder.path().join("reports").exists(),
            found != 2,
            "{what}: reports are written of what could be read"
        );
    }
    assert!(read > 0, "some can still be read");
}

#[test]
fn strange_files_are_refused() {
    let huge = vec![b'#'; (4 << 20) + 1];
    let nested = [b"a = ".to_vec(), vec![b'['; 100_000]].concat();
    let deep = format!("[derivation]\ntitle = 'x'\nconcerns = '{}'\n", "{".repeat(200_000)).into_bytes();
    let keys = "a.".repeat(50_000).into_bytes();
    let cases: [(&str, Vec<u8>); 7] = [
        ("empty", Vec::new()),
        ("huge", huge),
        ("nested", nested),
        ("deep", deep),
        ("keys", keys),
        ("binary", (0..=255).cycle().take(5000).collect()),
        ("half a letter", b"title = '\xc3".to_vec()),
    ];
    for (what, bytes) in cases {
        let (folder, _) = placed("strange.toml", &bytes);
        for command in ["check", "list"] {
            code(folder.path(), &[command, "strange.toml"], &[2], what);
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("folder.toml")).expect("made");
    code(folder.path(), &["check", "folder.toml"], &[2], "a folder");
    code(folder.path(), &["check", "missing.toml"], &[2], "no file");
}

#[test]
fn mangled_papers_are_read_or_refused() {
    let whole = fs::read(root().join("tests/source/paper.tex")).expect("it is there");
    for seed in 0..seeds() {
        let bytes = mangled(&whole, &mut Dice(seed));
        let (folder, _) = placed("paper.tex", &bytes);
        code(folder.path(), &["init", "paper.tex", "--output", "out.toml"], &[0, 2], &format!("seed {seed}"));
    }
}
