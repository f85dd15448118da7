//! How one verdict came about: what `rederive explain` prints.

use super::graph::DerivationGraph;
use super::numbers::{count, size, time, value};
use super::summary::{Digits, sides};
use super::tally::{declared, name, says};
use super::text::{Paint, paragraph};
use super::wording::{one_line, slack_sentence};
use derivation::{Claim, Derivation, SymbolEntry};
use findings::{Account, ClaimAccount, Outcome, PairAccount, Strength};

/// Most steps of a proof that are printed; all are in `proofs.json`.
const MOST_STEPS: usize = 60;

/// Everything that is known about some claims of the account, on some trajectories and families; all where none are named. With escape
/// codes if `colour`.
pub fn explain(derivation: &Derivation, account: &Account, wanted: &[String], on: &[String], colour: bool) -> String {
    let is_meant = |id: &String| on.is_empty() || on.contains(id);
    let paint = Paint(colour);
    let graph = DerivationGraph::new(derivation, account);
    let mut out = String::new();
    for claim in
        account.claims.iter().filter(|c| wanted.is_empty() || wanted.contains(&c.id) || wanted.contains(&name(c)))
    {
        out.push_str(&about_claim(derivation, claim, &graph, paint));
        for pair in claim.results.iter().filter(|pair| is_meant(&pair.trajectory)) {
            out.push_str(&about_pair(account, pair, paint));
        }
        for family in claim.families.iter().filter(|family| is_meant(&family.family)) {
            out.push_str(&super::summary::on_family(derivation, claim, family, paint, true));
        }
        out.push_str(&super::region::explain(derivation, claim, paint));
    }
    out
}

fn about_claim(derivation: &Derivation, claim: &ClaimAccount, graph: &DerivationGraph, paint: Paint) -> String {
    let mut out = paint.bold(&name(claim));
    if let Some(place) = &claim.place {
        out.push_str(&format!("  ({place})"));
    }
    out.push('\n');
    out.push_str(&paragraph(&says(derivation, claim), 2));
    let declared = declared(derivation, claim);
    if let Some(whose) = declared.and_then(|d| super::claim_story::whose(d.role)) {
        out.push_str(&paragraph(whose, 2));
    }
    if let Some(remark) = &claim.remark {
        out.push_str(&paragraph(&format!("Remark of the file: {remark}"), 2));
    }
    let list = |title: &str, lines: &[String]| match lines {
        [] => String::new(),
        lines => format!("\n  {title}\n{}", lines.iter().map(|l| format!("    {l}\n")).collect::<String>()),
    };
    let compared = declared.and_then(super::family::compared).map(|words| format!(" ({})", words.replace('$', "")));
    let compared = compared.unwrap_or_default();
    let formulas: Vec<String> = match declared {
        Some(claim) => {
            claim.formulas.iter().map(|f| format!("{}: {}{compared}", f.kind.key(), one_line(&f.text))).collect()
        }
        None => claim.formulas.iter().map(|f| one_line(f)).collect(),
    };
    out.push_str(&list("Checked", &formulas));
    out.push_str(&list("Assuming", &claim.assumptions));
    if let Some(claim) = declared {
        out.push_str(&list("Follows from", &claim.follows_from));
        out.push_str(&list("Where", &definitions(derivation, claim)));
        out.push_str(&format!("\n  Precision asked for: {}\n", size(claim.precision)));
    }
    if let Some(identity) = &claim.identity {
        out.push('\n');
        out.push_str(&paragraph(&super::graph::sentence(identity, &graph.proof_of(claim)), 2));
        if let Some(recorded) = &identity.recorded {
            let blocks = super::recorded::blocks(recorded, &derivation.scope, MOST_STEPS);
            out.push_str(&paragraph(&recorded.sentence(), 2));
            out.push_str(&super::story::terminal(&blocks, 4, paint));
        }
        if let Some(trials) = &identity.evidence.trials {
            out.push_str(&format!(
                "  {} of random evaluation, in {}\n",
                count(trials.count, "trial"),
                count(trials.cases, "case")
            ));
        }
        if let Some(file) = super::certificates::file_name(claim) {
            out.push_str(&format!("  Exact, too: the certificate {file} of the report\n"));
        }
        for (title, lines) in identity.terms() {
            out.push_str(&list(&title.to_string(), &lines.iter().map(ToString::to_string).collect::<Vec<_>>()));
        }
        out.push_str(&list("Refuting point", &identity.witness.iter().map(ToString::to_string).collect::<Vec<_>>()));
    }
    if let Some(text) = super::card::instead(claim) {
        out.push_str(&format!("\n{}", paragraph(&text, 2)));
    }
    if let Some(text) = super::drawn::plain(derivation, claim) {
        out.push_str(&format!("\n{}", paragraph(&text.replace('$', ""), 2)));
    }
    if let Some(table) = super::drawn::table(claim) {
        out.push_str(&paragraph(super::drawn::ADVICE, 2));
        out.push('\n');
        out.extend(table.lines().map(|line| format!("    {line}\n")));
    }
    out.push('\n');
    out
}

/// The definitions that the formulas of a claim use, directly or through others.
fn definitions(derivation: &Derivation, claim: &Claim) -> Vec<String> {
    let mentions = |text: &str, s: &SymbolEntry| text.contains(s.name.trim());
    let all: Vec<&SymbolEntry> =
        derivation.symbols.iter().chain(&claim.symbols).filter(|s| s.formula.is_some()).collect();
    let mut texts: Vec<&str> = claim.formulas.iter().map(|f| f.text.as_str()).collect();
    texts.extend(claim.assuming.iter().map(|a| a.text.as_str()));
    let mut used = Vec::new();
    while let Some(next) = all.iter().find(|s| !used.contains(&s.symbol) && texts.iter().any(|t| mentions(t, s))) {
        used.push(next.symbol);
        texts.extend(next.formula.as_deref());
    }
    let line = |s: &&SymbolEntry| format!("{} = {}", s.name, s.formula.as_deref().unwrap_or_default());
    all.iter().filter(|s| used.contains(&s.symbol)).map(line).collect()
}

fn about_pair(account: &Account, pair: &PairAccount, paint: Paint) -> String {
    let outcome = pair.verdict.outcome();
    let evidence = pair.verdict.evidence();
    let strength = outcome.strength().map(|s| format!(" ({s})")).unwrap_or_default();
    let expected = match pair.expected {
        Some(word) if pair.is_unexpected() => paint.alarm(&format!(", expected: {word}")),
        Some(_) => ", as expected".to_owned(),
        None => String::new(),
    };
    let verdict = paint.verdict(outcome, &format!("{}{strength}", outcome.word()));
    let mut out = format!("  {}  {verdict}{expected}\n", paint.bold(&pair.trajectory));
    if let Some(t) = account.trajectories.iter().find(|t| t.id == pair.trajectory) {
        let steps = if t.steps > 0 { format!(", {}", count(t.steps, "step")) } else { String::new() };
        out.push_str(&format!(
            "    {}; t from {} to {}; {}{steps}, error at most {}\n",
            t.title,
            time(t.span.0),
            time(t.span.1),
            t.source,
            size(t.error)
        ));
        for (name, values) in &t.given {
            let values: Vec<String> = values.iter().map(|v| value(*v)).collect();
            out.push_str(&format!("      {name} = {}\n", values.join(", ")));
        }
        if let Some(problem) = &t.problem {
            out.push_str(&paragraph(problem, 4));
        }
    }
    if let Some(reason) = &evidence.reason {
        out.push_str(&paragraph(&reason.to_string(), 4));
    }
    if evidence.samples > 0 {
        out.push_str(&format!("    compared at {}\n", count(evidence.samples, "time")));
    }
    if let Some(r) = &evidence.residual {
        out.push_str(&format!(
            "    worst at t = {}: residual {}, error bound {}\n",
            time(r.at),
            size(r.max),
            size(r.bound)
        ));
    }
    if let Some(slack) = slack_sentence(pair) {
        out.push_str(&paragraph(&slack, 4));
    }
    if let Some(branch) = &evidence.branch {
        out.push_str(&format!("    sign: {branch}\n"));
    }
    for e in &evidence.excluded {
        out.push_str(&paragraph(&format!("left out from t = {} to {}: {}", time(e.from), time(e.to), e.reason), 4));
    }
    out.push_str(&paragraph(would_change(outcome), 4));
    if let Some(w) = &evidence.witness {
        out.push_str(&format!("    at t = {}:  {}\n{}", value(w.t), w.formula, sides(w, 6, Digits::All)));
    }
    out.push('\n');
    out
}

/// What would lead to another verdict on the same motion.
fn would_change(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Holds(Strength::Sampled) => {
            "What would change it: a time between the samples at which it fails. An enclosure or a proof would exclude that."
        }
        Outcome::Holds(Strength::Enclosed) => {
            "What would change it: nothing in this span; a longer one, or another motion, may differ."
        }
        Outcome::Holds(Strength::Proved) => "What would change it: nothing, as long as what it follows from stands.",
        Outcome::Fails(Strength::Sampled) => {
            "What would change it: an error bound that is wrong. With an assumption that excludes this point it would not apply there."
        }
        Outcome::Fails(Strength::Enclosed | Strength::Proved) => {
            "What would change it: nothing; with an assumption that excludes this point it would not apply there."
        }
        Outcome::NotApplicable(_) => "What would change it: a motion that meets what it assumes.",
        Outcome::Undecided => "What would change it: the reason above names it.",
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    #[test]
    fn everything_is_said() {
        insta::assert_snapshot!(explain(&derivation(), &sample::account(), &[], &[], false));
    }
}
