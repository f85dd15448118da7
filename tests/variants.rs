//! Variants of claims: what the evidence is worth, and what a wrong formula should have been.

use rederive::check::{Account, ClaimAccount, Correction, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};

fn derivation(text: &str) -> Derivation {
    let source = Source { path: "derivations/altered.toml".into(), text: text.into() };
    parse(source, "altered").unwrap_or_else(|e| panic!("{}", render(&e, false)))
}

fn checked(text: &str, claims: &[&str], trajectories: &[&str]) -> Account {
    let list = |l: &[&str]| l.iter().map(|s| (*s).to_owned()).collect();
    let options = Options { claims: list(claims), trajectories: list(trajectories), ..Options::default() };
    check(&mut derivation(text), &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

fn comment() -> String {
    std::fs::read_to_string("derivations/deriglazov-comment.toml").expect("the file of the Comment")
}

/// A file with one formula altered; it must be there exactly as often as said.
fn altered(text: &str, old: &str, new: &str, times: usize) -> String {
    assert_eq!(text.matches(old).count(), times, "{old}");
    text.replace(old, new)
}

fn corrections(claim: &ClaimAccount) -> &[Correction] {
    let erratum = claim.variants.as_ref().and_then(|v| v.erratum.as_ref());
    erratum.map_or(&[], |e| e.corrections.as_slice())
}

#[test]
fn a_wrong_sign_in_t9_is_corrected() {
    let printed = r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi+\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta']";
    let wrong = r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi-\frac{m_3}{I_2}\cos^2\psi)\cos\theta+\frac{m_3}{I_3}\cos\theta']";
    let text = altered(&comment(), &format!("always = ['{printed}"), &format!("always = ['{wrong}"), 2);
    let account = checked(&text, &["t9-psi"], &["racket-out", "psi-rotating", "i3-largest", "t8-stable"]);
    let found = corrections(&account.claims[0]);
    println!("{found:#?}");
    assert_eq!(found[0].formula, printed.trim_end_matches("']"));
}

#[test]
fn a_wrong_index_in_t3_is_corrected() {
    let text = comment();
    let at = text.find("id = \"t3-attitude\"").expect("the claim");
    let claim: String = text[at..].lines().take(12).collect::<Vec<_>>().join("\n");
    println!("{claim}");
}
