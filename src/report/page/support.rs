//! What the verdicts of a claim are worth: what they rest on, where they hold, what they would notice, what should stand there.
//!
//! **In:** the account of a claim. **Out:** HTML beside its verdicts. The sentences are those of the other reports; here they
//! get formulas, links and marks. Nothing is judged here.

use maud::{Markup, html};

use super::super::certificates::file_name;
use super::super::conditions::{separation_in_words, worth_in_words};
use super::super::discrimination::{sentence, smallest, standing, tried_where};
use super::super::graph::{DerivationGraph, unproved};
use super::super::numbers::count;
use super::super::tally::name;
use super::super::wording::dense;
use super::text::{bare, formula, identifier, plain, prose, proviso, unit};
use crate::latex::Scope;
use ::units::{UnitAccount, UnitVerdict};
use findings::conditions::Need;
use findings::{Account, ClaimAccount, Correction, Erratum, IdentityAccount};
use reason::{Coordinate, Point, Refuting};

/// Most altered formulas that are typeset for a claim.
const SHOWN: usize = 1;

/// What a claim rests on, through all steps.
fn rests(graph: &DerivationGraph, claim: &ClaimAccount, scope: &Scope) -> Markup {
    let Some(rests) = graph.rests_of(claim) else { return html! {} };
    let link = |prefix: &str, id: &str| html! { a href={ "#" (prefix) (id) } { (id) } };
    let mut parts: Vec<Markup> = rests.systems.iter().map(|s| html! { "the system " (link("/system/", s)) }).collect();
    parts.extend(rests.symbols.iter().map(|s| html! { "the definition of " (formula(s, scope)) }));
    parts.extend(rests.claims.iter().map(|c| link("", c)));
    html! {
        p.rests {
            "Rests on " (listed(parts)) "."
            @if !rests.assumptions.is_empty() {
                " With it come the assumptions "
                (listed(rests.assumptions.iter().map(|(text, of)| html! { (formula(text, scope)) " (of " (link("", of)) ")" })))
                "."
            }
            @if !rests.open.is_empty() {
                " Taken as given on the way, for it is not proved: "
                (listed(rests.open.iter().map(|(id, verdict)| html! { (link("", id)) " (" (unproved(*verdict)) ")" })))
                "."
            }
            @if rests.more { " These are the nearest: it rests on more, through them." }
        }
    }
}

fn listed(parts: impl IntoIterator<Item = Markup>) -> Markup {
    html! { @for (i, part) in parts.into_iter().enumerate() { @if i > 0 { ", " } (part) } }
}

/// Where the exact proof of a claim is, or why there is none.
pub(super) fn certificate(claim: &ClaimAccount, identity: &IdentityAccount, scope: &Scope) -> Markup {
    html! {
        @if let Some(branch) = &identity.evidence.branch { " ± holds " (branch.to_string()) "." }
        @if let Some(recorded) = &identity.recorded { " " (prose(&recorded.sentence(), scope)) }
        @if let Some(file) = file_name(claim) {
            " Exact, too: the certificate " a href=(file) { (file) } " can be expanded by hand."
        } @else if identity.finding.is_proved_in_part() {
            @if let Some(why) = &identity.evidence.no_certificate { " There is no certificate: " (prose(why, scope)) "." }
        }
    }
}

/// Which condition separates the motions of a claim, in a sentence.
pub(super) fn separation(claim: &ClaimAccount, scope: &Scope) -> Markup {
    let sentences = claim.conditions.separation.as_ref().map(separation_in_words).unwrap_or_default();
    html! { @if let Some(first) = sentences.first() { p.separation { b { "What separates: " } (prose(first, scope)) } } }
}

/// What stands behind the verdicts of a claim: what its proof says in full, what it rests on, what it needs, what it would notice.
/// Few readers want it of every claim, so that it is folded.
pub(super) fn behind(graph: &DerivationGraph, claim: &ClaimAccount, scope: &Scope) -> Markup {
    let inside = html! {
        @if let Some(identity) = &claim.identity { (terms(identity, scope)) }
        (rests(graph, claim, scope))
        @if let Some(recorded) = claim.identity.as_ref().and_then(|i| i.recorded.as_ref()) { (super::super::recorded::fold(recorded, scope)) }
        (conditions(claim, scope))
        (discrimination(claim, scope))
    };
    html! {
        @if !inside.0.is_empty() {
            details.behind { summary { "What it rests on, what it needs, what would be noticed" } (inside) }
        }
    }
}

/// The same in print: in small letters, without what repeats what is printed elsewhere.
pub(super) fn behind_in_print(graph: &DerivationGraph, claim: &ClaimAccount, scope: &Scope) -> Markup {
    let (rests, more) = match graph.rests_of(claim) {
        Some(r) => ([r.systems, r.symbols, r.claims].concat(), r.more),
        None => Default::default(),
    };
    let idle: Vec<_> = claim.conditions.assumptions.iter().filter(|a| a.need == Need::NotNeeded).collect();
    html! {
        @if !rests.is_empty() {
            p.quiet { "Rests on " @for (i, id) in rests.iter().enumerate() { @if i > 0 { ", " } (plain(id)) } @if more { ", and more" } "." }
        }
        @for a in idle { p.quiet { (prose(&worth_in_words(a), scope)) "." } }
        @if let Some((rejected, of)) = claim.variants.as_ref().and_then(|v| v.together()) {
            p.quiet { "Of " (count(of, "altered formula")) " " (rejected) " would be noticed." }
        }
    }
}

/// What the proof says beside its sentence, and the point that refutes a step.
fn terms(identity: &IdentityAccount, scope: &Scope) -> Markup {
    html! {
        @for (title, lines) in identity.terms() {
            p { b { (title.to_string()) ":" } }
            ul { @for c in &lines { li { (proviso(c, scope)) } } }
        }
        @if let Some(witness) = &identity.witness {
            p { b { "Refuting point:" } }
            (refuting(witness))
        }
    }
}

/// What refutes a step: the values of everything, as lines that can be pasted.
fn refuting(found: &Refuting) -> Markup {
    let point = |of: &Point| format!("left = {}\nright = {}\n{}", bare(&of.left), bare(&of.right), assignments(&of.at));
    html! {
        @match found {
            Refuting::Point { first, second } => {
                pre tabindex="0" { (point(first)) }
                @if let Some(second) = second {
                    p { "What is given leaves the difference open, as another point shows:" }
                    pre tabindex="0" { (point(second)) }
                }
            },
            Refuting::Signs { upper, lower } => {
                p { "The upper sign does not serve:" }
                pre tabindex="0" { (point(upper)) }
                p { "Nor does the lower:" }
                pre tabindex="0" { (point(lower)) }
            },
            Refuting::OnMotion { .. } => p { (plain(&found.to_string())) "." },
            Refuting::Sizes(sizes) => pre tabindex="0" { (assignments(sizes)) },
        }
    }
}

fn assignments(at: &[Coordinate]) -> String {
    let line = |coordinate: &Coordinate| match coordinate {
        Coordinate::Value(name, value) => format!("{} = {}\n", identifier(name), bare(value)),
        Coordinate::Circle(name, cos, sin) => format!("{} = atan2({}, {})\n", identifier(name), bare(sin), bare(cos)),
        Coordinate::Beyond(_) => format!("# {}\n", coordinate.shown(false)),
    };
    at.iter().map(line).collect()
}

/// What else would separate the motions, and which assumptions the claim needs.
fn conditions(claim: &ClaimAccount, scope: &Scope) -> Markup {
    let found = &claim.conditions;
    let sentences = found.separation.as_ref().map(separation_in_words).unwrap_or_default();
    html! {
        @for text in sentences.iter().skip(1) { p { (prose(text, scope)) } }
        @if !found.assumptions.is_empty() {
            div {
                p {
                    b {
                        @if found.assumptions.iter().any(|a| a.need == Need::NotNeeded) { "Assumptions, not all of them needed:" }
                        @else { "Whether the assumptions are needed:" }
                    }
                }
                ul {
                    @for a in &found.assumptions {
                        @let text = prose(&worth_in_words(a), scope);
                        li { @if a.need == Need::NotNeeded { b { (text) } } @else { (text) } }
                    }
                }
            }
        }
    }
}

/// What the evidence would notice of altered formulas.
fn discrimination(claim: &ClaimAccount, scope: &Scope) -> Markup {
    let Some(variants) = &claim.variants else { return html! {} };
    let alive: Vec<_> = variants.survivors.iter().filter(|s| s.everywhere).collect();
    html! {
        @if let Some((rejected, of)) = variants.together() {
            p {
                b { "Discrimination: " }
                "of " (count(of, "altered formula")) " " (rejected) " would be noticed "
                (tried_where(claim, variants)) (smallest(variants).replace('`', "")) ". "
                (prose(&sentence(claim, variants), scope))
            }
            @if !alive.is_empty() {
                @let nothing = if claim.region.is_some() { "nothing that was tried" } else { "no motion" };
                p { b { "Altered formulas that " (nothing) " rejects:" } }
                ul {
                    @for s in alive.iter().take(SHOWN) { li { (s.class.word()) ": " (formula(&s.formula, scope)) } }
                    @if alive.len() > SHOWN { li { "and " (alive.len() - SHOWN) " more, in report.json" } }
                }
            }
        }
    }
}

/// What a claim that fails should have said.
pub(super) fn erratum(claim: &ClaimAccount, scope: &Scope) -> Markup {
    // Where nothing can be altered, there is nothing to say.
    let erratum = claim.variants.as_ref().and_then(|v| v.erratum.as_ref()).filter(|e| e.tried != (0, 0, 0));
    html! { @if let Some(erratum) = erratum { (corrections(erratum, scope)) } }
}

fn corrections(erratum: &Erratum, scope: &Scope) -> Markup {
    let (single, completions, pairs) = erratum.tried;
    let tried = format!("{single} single edits, {completions} completions and {pairs} pairs of edits were tried");
    html! {
        div.erratum {
            @if erratum.corrections.is_empty() {
                p {
                    b { "No correction: " }
                    (prose(erratum.remark.as_deref().unwrap_or("no correction was found"), scope)) ". (" (tried) ".)"
                }
            } @else {
                p { b { "What it should have said" } ", the closest to the print first (" (tried) "):" }
                ol {
                    @for c in &erratum.corrections {
                        li {
                            (formula(&c.formula, scope)) ", " (standing(c).replace("**", "")) "."
                            div { (difference(c)) }
                        }
                    }
                }
                @if let Some(remark) = &erratum.remark { p { (prose(remark, scope)) } }
            }
        }
    }
}

/// A piece of a marked difference.
#[derive(Debug, PartialEq)]
enum Piece<'a> {
    Same(&'a str),
    Removed(&'a str),
    Added(&'a str),
}

/// The pieces of a text with `[-removed-]` and `{+added+}`.
fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut out = Vec::new();
    let (mut rest, mut from) = (text, 0);
    while let Some(at) = rest[from..].find(['[', '{']).map(|i| from + i) {
        let tail = &rest[at..];
        let mark = [("[-", "-]"), ("{+", "+}")].into_iter().find(|(open, _)| tail.starts_with(open));
        // At least one character is marked: `[---]` removes a minus.
        let inner = mark.and_then(|(open, close)| {
            let body = &tail[open.len()..];
            let first = body.chars().next()?.len_utf8();
            Some((open, &body[..first + body[first..].find(close)?]))
        });
        let Some((open, inner)) = inner else {
            from = at + 1;
            continue;
        };
        if at > 0 {
            out.push(Piece::Same(&rest[..at]));
        }
        out.push(if open == "[-" { Piece::Removed(inner) } else { Piece::Added(inner) });
        (rest, from) = (&tail[inner.len() + 4..], 0);
    }
    if !rest.is_empty() {
        out.push(Piece::Same(rest));
    }
    out
}

/// What is removed and what is added, in the LaTeX source. Brackets of a formula can look like marks: where the pieces do not
/// make up the correction, the print and the correction are shown as wholes.
fn difference(c: &Correction) -> Markup {
    let parts = pieces(&c.difference);
    let new: String = parts.iter().map(|p| if let Piece::Same(t) | Piece::Added(t) = p { *t } else { "" }).collect();
    html! {
        code.difference {
            @if dense(&new) == dense(&c.formula) {
                @for part in &parts {
                    @match part {
                        Piece::Same(text) => { (text) },
                        Piece::Removed(text) => { del { (text) } },
                        Piece::Added(text) => { ins { (text) } },
                    }
                }
            } @else {
                del { (c.printed) } " " ins { (c.formula) }
            }
        }
    }
}

fn unit_words(found: &UnitAccount, scope: &Scope) -> Markup {
    html! {
        (formula(&found.formula, scope))
        @if let UnitVerdict::Inconsistent { relation, terms } = &found.verdict {
            ": "
            @for (i, term) in terms.iter().enumerate() {
                @if i > 0 { " and " }
                (formula(&term.latex, scope)) " in " (unit(&term.unit))
            }
            " " (relation)
        }
        @if found.expected { " (as expected)" }
        "."
    }
}

fn inconsistent(account: &Account) -> impl Iterator<Item = &UnitAccount> {
    account.units.formulas.iter().filter(|f| matches!(f.verdict, UnitVerdict::Inconsistent { .. }))
}

/// The formulas of a claim whose units do not agree.
pub(super) fn units_of(account: &Account, claim: &ClaimAccount, scope: &Scope) -> Markup {
    let id = name(claim);
    html! {
        @for found in inconsistent(account).filter(|f| f.kind == "claim" && f.of == id) {
            p { b.bad { "Units do not agree: " } (unit_words(found, scope)) }
        }
        @if account.units.missed.contains(&id) {
            p { strong.alarm { "Inconsistent units are expected, and its units agree." } }
        }
    }
}

/// So many formulas whose units do not agree are seen; the others are folded.
const MOST_UNITS: usize = 40;

fn inconsistent_list<'a>(found: impl Iterator<Item = &'a UnitAccount>, scope: &Scope) -> Markup {
    html! { ul { @for found in found { li { (found.kind) " " (found.of) ", " (unit_words(found, scope)) } } } }
}

/// The units of all formulas.
pub(super) fn units(account: &Account, scope: &Scope) -> Markup {
    let units = &account.units;
    if units.formulas.is_empty() {
        return html! {};
    }
    let n = |word: &str| count(units.count(word), "formula");
    html! {
        section id="/units" {
            h2 { "Units" }
            p {
                "The units of " (n("consistent")) " agree, those of " (n("inconsistent")) " do not, and "
                (n("not-checked")) " could not be checked."
            }
            (inconsistent_list(inconsistent(account).take(MOST_UNITS), scope))
            @if inconsistent(account).nth(MOST_UNITS).is_some() {
                details {
                    summary { (inconsistent(account).count() - MOST_UNITS) " more" }
                    (inconsistent_list(inconsistent(account).skip(MOST_UNITS), scope))
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Piece::{Added, Removed, Same};

    #[test]
    fn a_marked_difference_is_taken_apart() {
        assert_eq!(pieces(r"a=[---]\frac12b"), [Same("a="), Removed("-"), Same(r"\frac12b")]);
        assert_eq!(pieces(r"m_[-1-]{+3+}"), [Same("m_"), Removed("1"), Added("3")]);
        assert_eq!(pieces("{++E+}"), [Added("+E")]);
        assert_eq!(pieces("[-]"), [Same("[-]")]);
        assert_eq!(pieces(r"\sqrt[n]{x}"), [Same(r"\sqrt[n]{x}")]);
        assert!(pieces("").is_empty());
    }

    #[test]
    fn a_point_that_refutes_can_be_pasted() {
        let value = |name: &str, value: &str| Coordinate::Value(name.to_owned(), value.to_owned());
        let circle = Coordinate::Circle(r"\theta".to_owned(), "5/13".to_owned(), "-12/13".to_owned());
        let at = vec![value(r"\dot x", "-1/2"), value("u(x,t)", "3"), circle, Coordinate::Beyond(4)];
        let first = Point { left: "-6".to_owned(), right: "0".to_owned(), at };
        let second = Some(Point { at: vec![value("x", "2")], ..first.clone() });
        let lines = "left = -6\nright = 0\nx_dot = -1/2\nu_at_xt = 3\ntheta = atan2(-12/13, 5/13)\n\
                     # 4 more values, by which what is given holds\n";
        let page = refuting(&Refuting::Point { first, second }).into_string();
        assert!(page.starts_with(&format!("<pre tabindex=\"0\">{lines}</pre>")), "{page}");
        assert!(page.ends_with("left = -6\nright = 0\nx = 2\n</pre>"), "{page}");
        let motion = Refuting::OnMotion { left: 1.0, right: -2.5, trajectory: "slow".into(), t: 0.5 };
        assert_eq!(refuting(&motion).into_string(), "<p>left 1, right -2.5 on slow at t = 0.5.</p>");
    }

    #[test]
    fn a_difference_is_no_markup_and_never_something_else() {
        let of = |difference: &str, formula: &str| {
            let correction = Correction {
                printed: "<b>p".to_owned(),
                formula: formula.to_owned(),
                difference: difference.to_owned(),
                classes: Vec::new(),
                strength: verdict::Strength::Sampled,
                holds_on: 1,
            };
            super::difference(&correction).into_string()
        };
        assert_eq!(of("x[-<i>-]{+y+}", "x y"), "<code class=\"difference\">x<del>&lt;i&gt;</del><ins>y</ins></code>");
        // The bracket belongs to the formula: the pieces are not the correction.
        assert_eq!(of("[-a-]", "[-a-]"), "<code class=\"difference\"><del>&lt;b&gt;p</del> <ins>[-a-]</ins></code>");
    }
}
