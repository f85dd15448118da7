use super::super::token::tokens;
use super::*;

fn keys(text: &str) -> Vec<String> {
    let place = super::super::printed::Place { environment: "", display: None, section: 0, chapter: 0 };
    let relations = super::super::printed::relations(&tokens(text), &place);
    relations.iter().flat_map(|r| &r.sides).flat_map(names).map(|n| n.key()).collect()
}

#[test]
fn names_are_what_is_printed() {
    assert_eq!(keys(r"m\ddot x_1=-k(x_1-x_2)"), ["m", "x_1", "k", "x_1", "x_2"]);
    assert_eq!(keys(r"\frac{d\psi}{dt}=v_{\rm max}\sin\omega t"), [r"\psi", "t", r"v_{\rm max}", r"\omega", "t"]);
    assert_eq!(keys(r"e^{x}+\mathrm{e}^y\pi"), ["x", r"\mathrm{e}", "y"]);
    assert_eq!(keys(r"\vec a\cdot{\bf b}+\mathbf{c}'"), [r"\vec{a}", r"\mathbf{b}", r"\mathbf{c}'"]);
}

#[test]
fn derivatives_are_seen() {
    let place = super::super::printed::Place { environment: "", display: None, section: 0, chapter: 0 };
    let seen = |text: &str| -> Vec<(String, Option<String>, bool)> {
        let relations = super::super::printed::relations(&tokens(text), &place);
        let all = relations.iter().flat_map(|r| &r.sides).flat_map(names);
        all.filter(|n| n.derived_by.is_some()).map(|n| (n.key(), n.derived_by.clone(), n.is_partial)).collect()
    };
    for text in
        [r"\frac{dx}{dt}", r"\frac{\mathrm{d}x}{\mathrm{d}t}", r"\dv{x}{t}", r"\frac{d}{dt}x", r"\frac{d^2x}{dt^2}"]
    {
        assert_eq!(seen(text), [("x".to_owned(), Some("t".to_owned()), false)], "{text}");
    }
    assert_eq!(seen(r"\pdv{u}{x}"), [("u".to_owned(), Some("x".to_owned()), true)]);
    assert_eq!(seen(r"\partial_t u"), [("u".to_owned(), Some("t".to_owned()), true)]);
}

#[test]
fn no_text_panics() {
    let text = r"\frac{d^2\vec{x}_{a}'}{dt^2}(a,b)\dv[2]{f}{x}\partial_{t}u\mathrm{Re}{\bf a}_";
    for end in 0..text.len() {
        keys(&text[..end]);
    }
}
