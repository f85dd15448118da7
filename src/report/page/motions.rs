//! The trajectories: what is integrated, from where, how well, and what the motion looks like.

use maud::{Markup, PreEscaped, html};

use super::super::numbers::{count, size, time, value};
use super::super::plot;
use super::super::tally::{declared, name};
use super::text::{self, formula, plain, prose, unit};
use derivation::{Derivation, FormKind, Motion, Picture, PictureKind, Written};
use expr::Expr;
use findings::{Account, PictureAccount, TrajectoryAccount};

/// All trajectories.
pub(super) fn section(derivation: &Derivation, account: &Account) -> Markup {
    html! {
        section id="/trajectories" hidden[account.trajectories.is_empty()] {
            h2 { "Motions" }
            (what_is_drawn(derivation))
            @for (at, t) in account.trajectories.iter().enumerate() { (article(derivation, account, t, at >= SHOWN)) }
        }
    }
}

/// So many motions are shown; of the others what they are, and the rest is folded.
const SHOWN: usize = 3;

/// What every picture of a kind shows, said once.
fn what_is_drawn(derivation: &Derivation) -> Markup {
    let scope = &derivation.scope;
    html! {
        @if !derivation.pictures.is_empty() {
            p { "What is drawn of each motion:" }
            ul {
                @for picture in &derivation.pictures {
                    li {
                        (prose(&picture.says, scope)) ": "
                        @for (k, w) in picture.show.iter().enumerate() {
                            @if k > 0 { ", " }
                            (formula(&w.text, scope))
                        }
                        @match picture.kind {
                            PictureKind::Time => { " against time." },
                            PictureKind::Curve => { ", the first to the right, the second up." },
                            PictureKind::Sphere => { ", on the sphere of their length; faint on its far side." },
                        }
                        @if let Some(levels) = &picture.levels {
                            " Thin lines are level sets of " (formula(&levels.text, scope))
                            "; dashed ones go through its saddles and part the motions."
                        }
                        @if !picture.slopes.is_empty() {
                            " Short lines along the curve have the slope "
                            @for (k, w) in picture.slopes.iter().enumerate() {
                                @if k > 0 { " or " }
                                (formula(&w.text, scope))
                            }
                            "; where that is right, one of them lies on the curve."
                        }
                    }
                }
            }
        }
    }
}

fn article(derivation: &Derivation, account: &Account, t: &TrajectoryAccount, folded: bool) -> Markup {
    let scope = &derivation.scope;
    let declared = derivation.trajectories.iter().find(|d| d.id == t.id);
    html! {
        article.trajectory id={ "/trajectory/" (t.id) } {
            h3 { (t.id) @if t.title != t.id { ": " (prose(&t.title, scope)) } }
            @if let Some(says) = declared.and_then(|d| d.says.as_ref()) { p { (prose(says, scope)) } }
            @if let Some(problem) = &t.problem { p.alarm { (problem) } }
            @if folded { details { summary { "Its numbers and pictures" } (told(derivation, account, t)) } }
            @else { (told(derivation, account, t)) }
        }
    }
}

/// What is told of a motion: from where and how it is integrated, its numbers, and what it looks like.
fn told(derivation: &Derivation, account: &Account, t: &TrajectoryAccount) -> Markup {
    let scope = &derivation.scope;
    let declared = derivation.trajectories.iter().find(|d| d.id == t.id);
    html! {
        p.quiet {
            @match declared.map(|d| &d.motion) {
                Some(Motion::Integrated { system, .. }) => {
                    @if let Some(s) = derivation.systems.get(*system) {
                        "Integrated from the system " a href={ "#/system/" (s.id) } { (s.id) } ", "
                    }
                },
                Some(Motion::Derived { from, .. }) => {
                    @if let Some(s) = derivation.trajectories.get(*from) {
                        "Computed from " a href={ "#/trajectory/" (s.id) } { (s.id) } ", "
                    }
                },
                Some(Motion::Formula { .. }) => { "Given by formulas, " },
                None => {},
            }
            "t from " (time(t.span.0)) " to " (time(t.span.1))
            @if t.steps > 0 { ", " (count(t.steps, "step")) }
            "; error of a state at most " (size(t.error)) "."
        }
        @if let Some(start) = declared.and_then(|d| d.motion.start()) {
            p.quiet {
                "Initial values are the solution of "
                @for (k, w) in start.equations.iter().enumerate() {
                    @if k > 0 { ", " }
                    (formula(&w.text, scope))
                }
                "."
            }
        }
        @if !t.given.is_empty() {
            details { summary { "Parameters and initial values" }
            ul.given aria-label={ "Parameters and initial values of " (t.id) } {
                @for (name, values) in &t.given {
                    li {
                        (given_name(name, scope)) " = "
                        @if let [one] = values.as_slice() { (value(*one)) }
                        @else { "(" (values.iter().map(|v| value(*v)).collect::<Vec<_>>().join(", ")) ")" }
                    }
                }
            } }
        }
        (integrals(derivation, account, t))
        (pictures(derivation, account, t))
    }
}

/// How well the declared first integrals are kept, which tells of the integration and of the claim alike.
fn integrals(derivation: &Derivation, account: &Account, t: &TrajectoryAccount) -> Markup {
    let kept: Vec<(String, &findings::Residual)> = account
        .claims
        .iter()
        .filter(|c| {
            declared(derivation, c).is_some_and(|d| d.forms.iter().all(|f| f.kind() == FormKind::FirstIntegral))
        })
        .filter_map(|c| {
            let pair = c.on(&t.id)?;
            Some((name(c), pair.verdict.evidence().residual.as_ref()?))
        })
        .collect();
    html! {
        @if !kept.is_empty() {
            details { summary { "How well first integrals are kept" } p {
                "Largest change since the start: "
                @for (i, (claim, r)) in kept.iter().enumerate() {
                    @if i > 0 { "; " }
                    a href={ "#" (claim) } { (claim) } " " span.one { (size(r.max)) " (bound " (size(r.bound)) ")" }
                }
                "."
            } }
        }
    }
}

fn pictures(derivation: &Derivation, account: &Account, t: &TrajectoryAccount) -> Markup {
    let drawn = account.pictures.iter().filter(|p| p.trajectory == t.id);
    html! {
        div.pictures {
            @for account in drawn {
                @if let Some(picture) = derivation.pictures.iter().find(|p| p.id == account.picture) {
                    (figure(derivation, picture, account))
                }
            }
        }
    }
}

fn figure(derivation: &Derivation, picture: &Picture, account: &PictureAccount) -> Markup {
    let scope = &derivation.scope;
    let names: Vec<String> = picture.show.iter().map(|w| plain(&w.text)).collect();
    let title = format!("{}: {}", account.trajectory, picture.id);
    let unit_of = |w: &Written<Expr>| {
        let entry = derivation.symbols.iter().find(|s| {
            derivation.graph.leaves([w.value]).iter().all(|l| l.symbol == s.symbol && l.rate == 0)
                && w.text.starts_with(&s.name)
        });
        entry.and_then(|s| s.unit.as_deref())
    };
    let with_unit = |w: &Written<Expr>| {
        let unit = unit_of(w).map(|u| format!(" ({})", unit(u))).unwrap_or_default();
        format!("{}{unit}", plain(&w.text))
    };
    let time = derivation.scope.time().and_then(|l| derivation.symbols.iter().find(|s| s.symbol == l.symbol));
    let time_unit = time.and_then(|s| s.unit.as_deref()).map(|u| format!(" ({})", unit(u))).unwrap_or_default();
    let time_name = time.map_or_else(|| "t".to_owned(), |s| plain(&s.name));
    let describe = match (picture.kind, names.as_slice()) {
        (PictureKind::Curve, [x, y]) => format!("{y} going up against {x} to the right."),
        (PictureKind::Sphere, _) => format!("The motion of ({}) on a sphere.", names.join(", ")),
        _ => format!("{} against time.", names.join(", ")),
    };
    let units: Vec<String> = picture.show.iter().map(with_unit).collect();
    let (across, up) = match (picture.kind, units.as_slice()) {
        (PictureKind::Curve, [x, y]) => (x.clone(), y.clone()),
        _ => (format!("{time_name}{time_unit}"), units.join(", ")),
    };
    // An orbit has its shape where both of its coordinates have one unit.
    let scale = match (picture.kind, picture.show.as_slice()) {
        (PictureKind::Curve, [x, y]) if unit_of(x).is_some() && unit_of(x) == unit_of(y) => plot::Scale::Equal,
        _ => plot::Scale::Own,
    };
    let words = plot::Words { title: &title, describe: &describe, across: &across, up: &up, axes: &names, scale };
    let svg = match picture.kind {
        PictureKind::Sphere => plot::sphere(&account.lines, &words),
        _ => plot::plane(&account.lines, &words),
    };
    html! {
        @match (&account.reason, svg) {
            (None, Some(svg)) => {
                figure class={ "picture " (picture.kind.key()) } {
                    (PreEscaped(svg))
                    figcaption {
                        (prose(&picture.says, scope))
                        @if picture.kind == PictureKind::Sphere {
                            " (faint: the far side"
                            @if picture.levels.is_some() { "; thin: level sets; dashed: those through saddles" }
                            ")"
                        }
                        @if picture.kind == PictureKind::Time && picture.show.len() > 1 {
                            ": "
                            @for (k, w) in picture.show.iter().enumerate() {
                                @if k > 0 { ", " }
                                span { span class={ "key k" (k % 6) } aria-hidden="true" {} (plain(&w.text)) }
                            }
                        }
                    }
                }
            },
            (Some(reason), _) => { p.quiet { (prose(&picture.says, scope)) ": no picture, " (text::reason(&reason.to_string(), scope)) "." } },
            (None, None) => {},
        }
    }
}

/// The name of an initial value ends with the initial time, which is no symbol of the file.
fn given_name(name: &str, scope: &latex::Scope) -> Markup {
    match name.strip_suffix("(t_0)") {
        Some(state) => html! { (formula(state, scope)) " at the start" },
        None => formula(name, scope),
    }
}
