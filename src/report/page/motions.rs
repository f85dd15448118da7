//! The trajectories: what is integrated, from where, how well, and what the motion looks like.

use maud::{Markup, html};

use super::super::numbers::{count, size, time, value};
use super::text::{formula, prose};
use crate::check::{Account, TrajectoryAccount};
use crate::derivation::{Derivation, Motion};

/// All trajectories.
pub(super) fn section(derivation: &Derivation, account: &Account) -> Markup {
    html! {
        section #trajectories {
            h2 { "Trajectories" }
            @for t in &account.trajectories { (article(derivation, t)) }
        }
    }
}

fn article(derivation: &Derivation, t: &TrajectoryAccount) -> Markup {
    let scope = &derivation.scope;
    let declared = derivation.trajectories.iter().find(|d| d.id == t.id);
    html! {
        article.trajectory id={ "trajectory-" (t.id) } {
            h3 { (t.id) @if t.title != t.id { ": " (prose(&t.title, scope)) } }
            @if let Some(says) = declared.and_then(|d| d.says.as_ref()) { p { (prose(says, scope)) } }
            p.quiet {
                @match declared.map(|d| &d.motion) {
                    Some(Motion::Integrated { system, .. }) => {
                        @if let Some(s) = derivation.systems.get(*system) {
                            "Integrated from the system " a href={ "#system-" (s.id) } { (s.id) } ", "
                        }
                    },
                    Some(Motion::Derived { from, .. }) => {
                        @if let Some(s) = derivation.trajectories.get(*from) {
                            "Computed from " a href={ "#trajectory-" (s.id) } { (s.id) } ", "
                        }
                    },
                    Some(Motion::Formula { .. }) => { "Given by formulas, " },
                    None => {},
                }
                "t from " (time(t.span.0)) " to " (time(t.span.1))
                @if t.steps > 0 { ", " (count(t.steps, "step")) }
                "; error of a state at most " (size(t.error)) "."
            }
            @if let Some(problem) = &t.problem { p.alarm { (problem) } }
            @if !t.given.is_empty() {
                ul.given aria-label={ "Parameters and initial values of " (t.id) } {
                    @for (name, values) in &t.given {
                        li {
                            (given_name(name, scope)) " = "
                            @if let [one] = values.as_slice() { (value(*one)) }
                            @else { "(" (values.iter().map(|v| value(*v)).collect::<Vec<_>>().join(", ")) ")" }
                        }
                    }
                }
            }
        }
    }
}

/// The name of an initial value ends with the initial time, which is no symbol of the file.
fn given_name(name: &str, scope: &crate::latex::Scope) -> Markup {
    match name.strip_suffix("(t_0)") {
        Some(state) => html! { (formula(state, scope)) " at the start" },
        None => formula(name, scope),
    }
}
