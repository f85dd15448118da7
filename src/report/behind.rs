//! What stands behind the verdicts of a claim: what its proof says in full, what it rests on, what it needs, what it would notice.
//!
//! **In:** the account of a claim. **Out:** a fold of the page; few readers want it of every claim. Nothing is judged here.

use super::certificates::file_name;
use super::conditions::{sentences, worth};
use super::discrimination::{sentence, smallest, tried_where};
use super::graph::{self, DerivationGraph, unproved};
use super::numbers::count;
use super::plain::{bare, plain};
use super::recorded;
use super::story::{
    Medium, StoryBlock, StorySpan, Tone, claim as link, embedded, html, joined, list, on_page, prose, quiet, strong,
    words,
};
use super::wording::identifier;
use findings::conditions::Need;
use findings::{ClaimAccount, IdentityAccount};
use latex::Scope;
use reason::{Coordinate, Point, Proviso, Refuting};

/// Most altered formulas that are typeset for a claim.
const SHOWN: usize = 1;
/// Most steps of a proof that the page shows: nobody reads more, and of some thousand steps a page would be half.
const STEPS: usize = 8;

/// The fold; nothing where there is nothing in it.
pub(super) fn blocks<'a>(graph: &DerivationGraph, claim: &'a ClaimAccount, scope: &'a Scope) -> Option<StoryBlock<'a>> {
    let mut inside = Vec::new();
    if let Some(identity) = &claim.identity {
        inside.extend(proof(graph, claim, identity, scope));
    }
    inside.extend(rests(graph, claim, scope));
    if let Some(recorded) = claim.identity.as_ref().and_then(|i| i.recorded.as_ref()).filter(|r| r.steps().is_some()) {
        // To tell steps they are replayed: no other printer has them.
        let steps = move || [on_page("The proof, step by step", "", recorded::blocks(recorded, scope, STEPS))];
        inside.push(embedded(move || html(&steps(), Medium::Screen)));
    }
    inside.extend(conditions(claim, scope));
    inside.extend(discrimination(claim, scope));
    (!inside.is_empty()).then(|| on_page("What it rests on, what it needs, what would be noticed", "", inside))
}

/// The same for paper, in short: what repeats what is printed elsewhere is left out.
pub(super) fn in_print<'a>(graph: &DerivationGraph, claim: &ClaimAccount, scope: &'a Scope) -> StoryBlock<'a> {
    let mut lines = Vec::new();
    if let Some(rests) = graph.rests_of(claim) {
        let all: Vec<String> =
            [rests.systems, rests.symbols, rests.claims].concat().iter().map(|id| plain(id)).collect();
        let more = if rests.more { ", and more" } else { "" };
        lines.push(quiet(format!("Rests on {}{more}.", all.join(", "))));
    }
    let idle = claim.conditions.assumptions.iter().filter(|a| a.need == Need::NotNeeded);
    lines.extend(idle.map(|a| StorySpan::Prose(format!("{}.", worth(a)), scope, Tone::Quiet)));
    if let Some((rejected, of)) = claim.variants.as_ref().and_then(|v| v.together()) {
        lines.push(quiet(format!("Of {} {rejected} would be noticed.", count(of, "altered formula"))));
    }
    StoryBlock::Group("paper", lines.into_iter().map(|line| StoryBlock::Paragraph(vec![line])).collect())
}

/// What the proof says in full, and the point that refutes a step.
fn proof<'a>(
    graph: &DerivationGraph,
    claim: &'a ClaimAccount,
    identity: &'a IdentityAccount,
    scope: &'a Scope,
) -> Vec<StoryBlock<'a>> {
    let mut line = vec![StorySpan::Reason(graph::sentence(identity, &graph.proof_of(claim)), scope)];
    line.extend(identity.evidence.branch.as_ref().map(|branch| words(format!(" ± holds {branch}."))));
    line.extend(identity.recorded.as_ref().map(|recorded| prose(format!(" {}", recorded.sentence()), scope)));
    match (file_name(claim), &identity.evidence.no_certificate) {
        (Some(file), _) => {
            line.extend([
                words(" Exact, too: the certificate "),
                StorySpan::File(file),
                words(" can be expanded by hand."),
            ]);
        }
        (None, Some(why)) if identity.finding.is_proved_in_part() => {
            line.push(prose(format!(" There is no certificate: {why}."), scope));
        }
        (None, _) => {}
    }
    let mut out = vec![StoryBlock::Paragraph(line)];
    for (title, lines) in identity.terms() {
        out.push(StoryBlock::Paragraph(vec![strong(format!("{title}:"))]));
        out.push(list(lines.iter().map(|of| proviso(of, scope))));
    }
    if let Some(witness) = &identity.witness {
        out.push(StoryBlock::Paragraph(vec![strong("Refuting point:")]));
        out.extend(refuting(witness));
    }
    out
}

/// What a proof needs or leaves out, with its formulas.
fn proviso<'a>(of: &Proviso, scope: &'a Scope) -> Vec<StorySpan<'a>> {
    let math = |text: &str| StorySpan::Math(text.to_owned(), scope);
    let beyond = |of: &str, is| vec![words("beyond a time at which "), math(of), words(is)];
    match of {
        Proviso::Where { formula: of, is } => {
            let (left, rest) = is.parts(of);
            vec![math(&left), words(rest)]
        }
        Proviso::Leap(of) => beyond(of, " leaps or has an edge"),
        Proviso::Pole(of) => beyond(of, " = 0, unless the motion is analytic there"),
        Proviso::Hole(of) => beyond(of, " = 0 or has no value"),
        Proviso::Written(of) if of.starts_with("where ") => vec![words(plain(of))],
        Proviso::Written(of) => vec![math(of)],
        Proviso::Orders(_) | Proviso::OtherSign => vec![words(plain(&of.to_string()))],
    }
}

/// What a claim rests on, through all steps.
fn rests<'a>(graph: &DerivationGraph, claim: &ClaimAccount, scope: &'a Scope) -> Option<StoryBlock<'a>> {
    let rests = graph.rests_of(claim)?;
    let system = |id: String| vec![words("the system "), StorySpan::Section(id.clone(), format!("/system/{id}"))];
    let mut parts: Vec<Vec<StorySpan<'a>>> = rests.systems.into_iter().map(system).collect();
    parts.extend(rests.symbols.into_iter().map(|s| vec![words("the definition of "), StorySpan::Math(s, scope)]));
    parts.extend(rests.claims.into_iter().map(|c| vec![link(c)]));
    let mut line = vec![words("Rests on ")];
    line.extend(joined(parts, ", "));
    if !rests.assumptions.is_empty() {
        line.push(words(". With it come the assumptions "));
        let of = |(text, of)| vec![StorySpan::Math(text, scope), words(" (of "), link::<'a>(of), words(")")];
        line.extend(joined(rests.assumptions.into_iter().map(of), ", "));
    }
    if !rests.open.is_empty() {
        line.push(words(". Taken as given on the way, for it is not proved: "));
        let of = |(id, verdict)| vec![link::<'a>(id), words(format!(" ({})", unproved(verdict)))];
        line.extend(joined(rests.open.into_iter().map(of), ", "));
    }
    line.push(words(if rests.more { ". These are the nearest: it rests on more, through them." } else { "." }));
    Some(StoryBlock::Paragraph(line))
}

/// What refutes a step: the values of everything, as lines that can be pasted.
fn refuting<'a>(found: &Refuting) -> Vec<StoryBlock<'a>> {
    let says = |text: &str| StoryBlock::Paragraph(vec![words(text)]);
    let point = |of: &Point| {
        let lines = format!("left = {}\nright = {}\n{}", bare(&of.left), bare(&of.right), assignments(&of.at));
        StoryBlock::Lines(lines, "")
    };
    match found {
        Refuting::Point { first, second: None } => vec![point(first)],
        Refuting::Point { first, second: Some(second) } => {
            vec![point(first), says("What is given leaves the difference open, as another point shows:"), point(second)]
        }
        Refuting::Signs { upper, lower } => {
            vec![says("The upper sign does not serve:"), point(upper), says("Nor does the lower:"), point(lower)]
        }
        Refuting::OnMotion { .. } => vec![says(&format!("{}.", plain(&found.to_string())))],
        Refuting::Sizes(sizes) => vec![StoryBlock::Lines(assignments(sizes), "")],
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
fn conditions<'a>(claim: &ClaimAccount, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let found = &claim.conditions;
    let told = found.separation.as_ref().map(sentences).unwrap_or_default();
    let mut out: Vec<StoryBlock<'a>> =
        told.into_iter().map(|text| StoryBlock::Paragraph(vec![prose(text, scope)])).collect();
    if !found.assumptions.is_empty() {
        let has_idle = found.assumptions.iter().any(|a| a.need == Need::NotNeeded);
        let title =
            if has_idle { "Assumptions, not all of them needed:" } else { "Whether the assumptions are needed:" };
        out.push(StoryBlock::Paragraph(vec![strong(title)]));
        out.push(list(found.assumptions.iter().map(|a| {
            let tone = if a.need == Need::NotNeeded { Tone::Strong } else { Tone::Plain };
            vec![StorySpan::Prose(worth(a), scope, tone)]
        })));
    }
    out
}

/// What the evidence would notice of altered formulas.
fn discrimination<'a>(claim: &'a ClaimAccount, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let Some((variants, (rejected, of))) = claim.variants.as_ref().and_then(|v| Some((v, v.together()?))) else {
        return Vec::new();
    };
    let alive: Vec<_> = variants.survivors.iter().filter(|s| s.everywhere).collect();
    let noticed = format!(
        "of {} {rejected} would be noticed {}{}. {}",
        count(of, "altered formula"),
        tried_where(claim, variants),
        smallest(variants).replace('`', ""),
        sentence(claim, variants)
    );
    let mut out = vec![StoryBlock::Paragraph(vec![strong("Discrimination: "), prose(noticed, scope)])];
    if !alive.is_empty() {
        let nothing = if claim.region.is_some() { "nothing that was tried" } else { "no motion" };
        out.push(StoryBlock::Paragraph(vec![strong(format!("Altered formulas that {nothing} rejects:"))]));
        let shown = alive.iter().take(SHOWN);
        let shown =
            shown.map(|s| vec![words(format!("{}: ", s.class.word())), StorySpan::Math(s.formula.clone(), scope)]);
        let more = alive.len().saturating_sub(SHOWN);
        let more = (more > 0).then(|| vec![words(format!("and {more} more, in report.json"))]);
        out.push(list(shown.chain(more)));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::story::{Medium, html};
    use super::*;

    #[test]
    fn a_point_that_refutes_can_be_pasted() {
        let value = |name: &str, value: &str| Coordinate::Value(name.to_owned(), value.to_owned());
        let circle = Coordinate::Circle(r"\theta".to_owned(), "5/13".to_owned(), "-12/13".to_owned());
        let at = vec![value(r"\dot x", "-1/2"), value("u(x,t)", "3"), circle, Coordinate::Beyond(4)];
        let first = Point { left: "-6".to_owned(), right: "0".to_owned(), at };
        let second = Some(Point { at: vec![value("x", "2")], ..first.clone() });
        let lines = "left = -6\nright = 0\nx_dot = -1/2\nu_at_xt = 3\ntheta = atan2(-12/13, 5/13)\n\
                     # 4 more values, by which what is given holds\n";
        let page = html(&refuting(&Refuting::Point { first, second }), Medium::Screen).into_string();
        assert!(page.starts_with(&format!("<pre tabindex=\"0\">{lines}</pre>")), "{page}");
        assert!(page.ends_with("left = -6\nright = 0\nx = 2\n</pre>"), "{page}");
        let motion = Refuting::OnMotion { left: 1.0, right: -2.5, trajectory: "slow".into(), t: 0.5 };
        assert_eq!(
            html(&refuting(&motion), Medium::Screen).into_string(),
            "<p>left 1, right -2.5 on slow at t = 0.5.</p>"
        );
    }
}
