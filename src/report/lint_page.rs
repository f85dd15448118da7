//! The page of a paper that was looked through: its formulas in their order, each with its word, the wrong one beside the right one.
//!
//! **In:** a paper, and what was found of it. **Out:** one HTML page that needs nothing beside itself: formulas as MathML, a picture of
//! both sides of a wrong step as SVG, no script. **Guaranteed:** every text of the paper is escaped; a formula that is not read is shown
//! as it is written. A word is told by itself, not by its colour alone.

use expr::Graph;
use latex::Scope;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use paper::{Paper, PrintedRelation};

use super::differing::differing;
use super::mathml;
use super::page::FONT;
use lint::{Judgement, Lint, LintPicture, PicturePoint, Typeset, Word};

const STYLE: &str = include_str!("lint_page.css");

/// Signs of relation as characters.
const SIGNS: &[(&str, &str)] = &[
    (r"\equiv", "≡"),
    (r"\approx", "≈"),
    (r"\simeq", "≃"),
    (r"\sim", "∼"),
    (r"\cong", "≅"),
    (r"\propto", "∝"),
    (r"\ll", "≪"),
    (r"\gg", "≫"),
    (r"\le", "≤"),
    (r"\leq", "≤"),
    (r"\ge", "≥"),
    (r"\geq", "≥"),
    (r"\ne", "≠"),
    (r"\neq", "≠"),
    (r"\in", "∈"),
    (r"\to", "→"),
    (r"\rightarrow", "→"),
    (r"\mapsto", "↦"),
    (r"\coloneqq", "≔"),
    (r"\triangleq", "≜"),
    (r"\lt", "<"),
    (r"\gt", ">"),
];

/// The page.
pub fn lint_page(paper: &Paper, found: &Lint) -> String {
    let title = paper.title.clone().unwrap_or_else(|| paper.file.path.clone());
    let typeset = lint::typesetting(paper);
    let wrong: Vec<&Judgement> = found.judgements.iter().filter(|j| j.word == Word::Wrong).collect();
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                // Whatever a paper says, the page loads nothing and sends nothing.
                meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; font-src data:";
                title { (title) }
                style { (PreEscaped(FONT)) (PreEscaped(STYLE)) (PreEscaped(filters())) }
            }
            body {
                header {
                    h1 { (title) }
                    @if paper.title.is_some() { p.quiet { (paper.file.path) } }
                    @if let Some(text) = lint::nothing_tested(found) { p { b { (text) } } }
                    (counts(found))
                    @if let Some(text) = lint::tested(found) { p.quiet { (text) } }
                    @if !wrong.is_empty() {
                        p { "Wrong:" }
                        ul { @for j in &wrong { (link(paper, j, &typeset)) } }
                    }
                }
                main {
                    h2 { "Formulas" }
                    (displays(paper, found, &typeset))
                    @if let Some(unlisted) = lint::unlisted(paper, found) { p.quiet { (unlisted) "." } }
                    @if !paper.notes.is_empty() {
                        h2 { "Notes" }
                        ul { @for note in &paper.notes { li { "line " (paper.line(&note.span)) ": " (note.message) } } }
                    }
                }
            }
        }
    };
    page.into_string() + "\n"
}

/// How often each word is said, each with a button that shows its formulas alone: styles hide the others, and no script.
fn counts(found: &Lint) -> Markup {
    let button = |id: &str| html! { input type="radio" name="shown" id=(id) checked[id == "all"]; };
    html! {
        ul.counts role="radiogroup" aria-label="formulas that are shown" {
            li { label { (button("all")) " " b { (found.judgements.len()) } " all" } }
            @for word in Word::ALL {
                @if found.count(word) > 0 || word == Word::Wrong && lint::nothing_tested(found).is_none() {
                    li { label { (button(&key(word))) " " b { (found.count(word)) } " " (word.text()) } }
                }
            }
        }
    }
}

/// A word as a name in markup.
fn key(word: Word) -> String {
    word.text().replace(' ', "-")
}

/// The styles of the buttons.
fn filters() -> String {
    let one = |word: Word| format!("body:has(#{0}:checked) .relation:not([data-word={0}]){{display:none}}", key(word));
    Word::ALL.map(one).concat()
}

/// A wrong formula of the summary, with a link to its place.
fn link(paper: &Paper, judgement: &Judgement, typeset: &[Option<Typeset>]) -> Markup {
    let how = typeset.get(judgement.relation).and_then(Option::as_ref);
    html! {
        li {
            a href=(format!("#f{}", judgement.relation)) { "line " (lint::line(paper, judgement)) }
            @if let Some(relation) = paper.printed.get(judgement.relation) {
                div.formula tabindex="0" role="group" aria-label=(format!("wrong formula of line {}", lint::line(paper, judgement))) {
                    (chain(relation, judgement, how))
                }
            }
        }
    }
}

/// What is wrong: a side, or the whole relation where what holds in its place is one.
fn as_printed(relation: &PrintedRelation, judgement: &Judgement, how: Option<&Typeset>) -> String {
    let text = |k: usize| text_of(relation, how, k);
    let is_relation = judgement.instead.as_ref().is_some_and(|i| i.contains('='));
    if let ([sign], true) = (relation.signs.as_slice(), is_relation) {
        return format!("{} {sign} {}", text(0), text(1));
    }
    relation.sides.iter().position(|s| s.span == judgement.span).map_or("", text).to_owned()
}

/// A number with the sign that a formula has.
fn signed(x: f64) -> String {
    lint::decimal(x).replace('-', "−")
}

/// Each relation that was judged as markup, in the order of [`Lint::judgements`].
pub fn lint_formulas(paper: &Paper, found: &Lint) -> Vec<String> {
    let typeset = lint::typesetting(paper);
    let one = |j: &Judgement| {
        let how = typeset.get(j.relation).and_then(Option::as_ref);
        paper.printed.get(j.relation).map_or_else(String::new, |r| sides(r, how).into_string())
    };
    found.judgements.iter().map(one).collect()
}

/// The formulas, those of a display together.
fn displays(paper: &Paper, found: &Lint, typeset: &[Option<Typeset>]) -> Markup {
    let told = found.judgements.iter().filter(|j| lint::is_listed(paper, j));
    let mut groups: Vec<(Option<usize>, Vec<&Judgement>)> = Vec::new();
    for judgement in told {
        let display = paper.printed.get(judgement.relation).and_then(|r| r.display);
        match groups.last_mut() {
            Some((of, group)) if display.is_some() && *of == display => group.push(judgement),
            _ => groups.push((display, vec![judgement])),
        }
    }
    html! {
        @for (_, group) in &groups {
            div.display { @for judgement in group { (one(paper, judgement, typeset)) } }
        }
    }
}

fn one(paper: &Paper, judgement: &Judgement, typeset: &[Option<Typeset>]) -> Markup {
    let Some(relation) = paper.printed.get(judgement.relation) else { return html! {} };
    let how = typeset.get(judgement.relation).and_then(Option::as_ref);
    let class = match judgement.word {
        Word::Wrong => "relation wrong",
        Word::Follows | Word::Numbers => "relation follows",
        Word::NotFollowed | Word::NotRead | Word::Differs => "relation open",
        Word::Defines | Word::Condition | Word::Approximates => "relation",
    };
    let why = lint::explained(paper, judgement);
    html! {
        div class=(class) id=(format!("f{}", judgement.relation)) data-word=(key(judgement.word)) {
            p.quiet {
                "line " (lint::line(paper, judgement)) ": " span.word { (judgement.word.text()) }
                @if !why.is_empty() { " – " (why) }
            }
            div.formula tabindex="0" role="group" aria-label=(format!("formula of line {}", lint::line(paper, judgement))) {
                (chain(relation, judgement, how))
            }
            @if judgement.word == Word::Wrong { (wrong(relation, judgement, how)) }
        }
    }
}

/// The side that is wrong, what holds in its place, a point, a picture.
fn wrong(relation: &PrintedRelation, judgement: &Judgement, how: Option<&Typeset>) -> Markup {
    let scope = how.map(|h| &h.scope);
    let printed = as_printed(relation, judgement, how);
    html! {
        div.sides {
            div { h3 { "As printed" } div.formula tabindex="0" role="group" aria-label="as printed" { (marked(&printed, judgement.instead.as_deref(), scope, "bad")) } }
            @if let Some(instead) = &judgement.instead {
                div { h3 { "Holds" } div.formula tabindex="0" role="group" aria-label="what holds" { (marked(instead, Some(&printed), scope, "good")) } }
            }
        }
        @if let Some(witness) = &judgement.witness {
            p {
                @if witness.values.is_empty() { "Its sides" } @else { "For " }
                @for (k, (name, value)) in witness.values.iter().take(8).enumerate() {
                    @if k > 0 { ", " }
                    (formula(name, scope)) " = " (value)
                }
                ": " (signed(witness.left)) " on the left, " (signed(witness.right)) " on the right."
            }
        }
        @if let Some(picture) = &judgement.picture { (drawing(picture)) }
    }
}

/// All sides of a relation; of a wrong one the step that is wrong is marked in its place, and what holds stands beside it. Where what holds
/// is a relation itself, all of it is wrong.
fn chain(relation: &PrintedRelation, judgement: &Judgement, how: Option<&Typeset>) -> Markup {
    if judgement.word != Word::Wrong {
        return sides(relation, how);
    }
    let scope = how.map(|h| &h.scope);
    let instead = |text: &String| html! { " " span.instead { "holds: " span.good { (formula(text, scope)) } } };
    let at = relation.sides.iter().position(|s| s.span == judgement.span);
    let is_relation = judgement.instead.as_ref().is_some_and(|text| text.contains('='));
    let Some(at) = at.filter(|_| !is_relation) else {
        return html! {
            span.step.bad { span.sign { "✗ wrong: " } (sides(relation, how)) }
            @if let Some(text) = &judgement.instead { (instead(text)) }
        };
    };
    html! {
        @for k in 0..relation.sides.len() {
            @if let Some(sign) = k.checked_sub(1).and_then(|k| relation.signs.get(k)) { " " (character(sign)) " " }
            @if k == at {
                span.step.bad { span.sign { "✗ wrong: " } (formula(text_of(relation, how, k), scope)) }
                @if let Some(text) = &judgement.instead { (instead(text)) }
            } @else { (formula(text_of(relation, how, k), scope)) }
        }
        @if let Some(label) = &relation.label { span.quiet { "  (" (label) ")" } }
    }
}

/// All sides of a relation, with the signs between them.
fn sides(relation: &PrintedRelation, how: Option<&Typeset>) -> Markup {
    html! {
        @for k in 0..relation.sides.len() {
            @if let Some(sign) = k.checked_sub(1).and_then(|k| relation.signs.get(k)) { " " (character(sign)) " " }
            (formula(text_of(relation, how, k), how.map(|h| &h.scope)))
        }
        @if let Some(label) = &relation.label { span.quiet { "  (" (label) ")" } }
    }
}

/// A side as it can be read.
fn text_of<'a>(relation: &'a PrintedRelation, how: Option<&'a Typeset>, k: usize) -> &'a str {
    let printed = relation.sides.get(k).map_or("", |s| s.text.as_str());
    how.and_then(|h| h.sides.get(k)).map_or(printed, String::as_str)
}

fn character(sign: &str) -> &str {
    SIGNS.iter().find(|(command, _)| *command == sign).map_or(sign, |(_, c)| c)
}

/// A formula in which the signs have a class that the other has not: what is wrong is seen at once.
fn marked(text: &str, other: Option<&str>, scope: Option<&Scope>, class: &str) -> Markup {
    let own = Scope::new(&mut Graph::new());
    let typeset = |text: &str| mathml::formula_mathml(text, scope.unwrap_or(&own));
    match (typeset(text), other.and_then(typeset)) {
        (Some(one), Some(other)) => PreEscaped(differing(&one, &other, class)),
        _ => formula(text, scope),
    }
}

/// A formula as MathML; as it is written, where it is not read.
fn formula(text: &str, scope: Option<&Scope>) -> Markup {
    let found = match scope {
        Some(scope) => mathml::formula_mathml(text, scope),
        None => mathml::formula_mathml(text, &Scope::new(&mut Graph::new())),
    };
    match found {
        Some(math) => PreEscaped(math),
        None => html! { code { (text) } },
    }
}

const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 180.0;
const MARGIN: f64 = 34.0;

/// Both sides as curves.
fn drawing(picture: &LintPicture) -> Markup {
    let values = || picture.points.iter().flat_map(|(_, l, r)| [*l, *r]).flatten();
    let (low, high) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    let (Some(first), Some(last)) = (picture.points.first(), picture.points.last()) else { return html! {} };
    let (low, high) = if high > low { (low, high) } else { (low - 1.0, high + 1.0) };
    let x = |v: f64| MARGIN + (v - first.0) / (last.0 - first.0) * (WIDTH - 2.0 * MARGIN);
    let y = |v: f64| HEIGHT - MARGIN - (v - low) / (high - low) * (HEIGHT - 2.0 * MARGIN);
    let curve = |side: &dyn Fn(&PicturePoint) -> Option<f64>| {
        let mut path = String::new();
        let mut pen = 'M';
        for point in &picture.points {
            match side(point) {
                Some(v) => {
                    path += &format!("{pen}{:.1} {:.1}", x(point.0), y(v));
                    pen = 'L';
                }
                None => pen = 'M',
            }
        }
        path
    };
    let label =
        format!("The earlier side and the printed one for {} from {:.3} to {:.3}", picture.name, first.0, last.0);
    html! {
        svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) width=(WIDTH) height=(HEIGHT) role="img" aria-label=(label) {
            path.axis d=(format!("M{MARGIN} {MARGIN}V{0}H{1}", HEIGHT - MARGIN, WIDTH - MARGIN)) {}
            path.left d=(curve(&|p| p.1)) {}
            path.right d=(curve(&|p| p.2)) {}
            text x=(MARGIN) y=(HEIGHT - 16.0) { (short(first.0)) }
            text x=(WIDTH - MARGIN) y=(HEIGHT - 16.0) text-anchor="end" { (short(last.0)) }
            text x=(WIDTH / 2.0) y=(HEIGHT - 16.0) text-anchor="middle" { (picture.name) }
            text x=(MARGIN) y=(MARGIN - 6.0) { (short(high)) }
            text x=(MARGIN + 4.0) y=(HEIGHT - MARGIN - 4.0) { (short(low)) }
        }
        p.quiet { "Solid: the side before. Dashed: the side that is printed." }
    }
}

fn short(v: f64) -> String {
    let text = format!("{v:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
