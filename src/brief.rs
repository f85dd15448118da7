//! Findings in brief: short documents in which the strength of a verdict is in its name.
//!
//! **In:** what a session found. **Out:** JSON for a reader that reads names first, such as an agent. **Guaranteed:** what holds at samples
//! has another name than what is proved. **Why this way:** the whole documents ([`Findings::documents`](crate::Findings)) are long, and
//! whoever asks for one verdict should not have to look for its strength.

use std::sync::Arc;

use serde_json::{Map, Value, json};

use crate::check::search::SearchOptions;
use crate::units::UnitVerdict;
use crate::{Answer, Failure, Finding, Findings, Outcome, Session, Strength, diag, latex, report};

/// A verdict with its strength in its name.
fn named(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Holds(Strength::Proved) => "holds_proved",
        Outcome::Holds(Strength::Enclosed) => "holds_enclosed",
        Outcome::Holds(Strength::Sampled) => "holds_sampled",
        Outcome::Fails(Strength::Sampled) => "fails_sampled",
        Outcome::Fails(_) => "fails_certified",
        Outcome::NotApplicable(_) => "not_applicable",
        Outcome::Undecided => "undecided",
    }
}

fn id(claim: &str, reading: Option<&String>) -> String {
    reading.map_or_else(|| claim.to_owned(), |r| format!("{claim}/{r}"))
}

impl Answer {
    /// The `verdict` (`proved`, `proved_except`, `proved_unreplayed`, `refuted_by_a_point`, `undecided`, …), and what there is of: `formula`, `given`, `reason`,
    /// `witness`, `exceptions`, `conditions`, `given_only_where`, `contradiction`.
    pub fn brief(&self) -> Value {
        const KEPT: [&str; 8] =
            ["formula", "given", "reason", "witness", "exceptions", "conditions", "given_only_where", "contradiction"];
        let whole: Value = serde_json::from_str(&self.json()).unwrap_or_default();
        let verdict = match self.standing() {
            "refuted" => "refuted_by_a_point".to_owned(),
            other => other.replace(' ', "_"),
        };
        let kept = KEPT.into_iter().filter_map(|key| Some((key.to_owned(), whole.get(key)?.clone())));
        std::iter::once(("verdict".to_owned(), Value::from(verdict))).chain(kept).collect()
    }
}

impl Findings {
    /// Whether all is `as_expected`; the `verdicts`, one for each claim on each motion; how claims stand `for_all_values`.
    pub fn brief(&self) -> Value {
        let one = |f: &Finding| {
            let witness = f.witness.as_ref().map(|w| {
                json!({ "formula": w.formula, "t": w.t, "left": w.left, "right": w.right, "error_bound": w.bound, "values": w.values })
            });
            json!({
                "claim": id(&f.claim.id, f.claim.reading.as_ref()), "says": f.claim.says,
                "motion": f.trajectory.as_ref().or(f.family.as_ref()), "verdict": named(f.outcome),
                "as_expected": f.is_expected, "reason": f.reason, "witness": witness,
            })
        };
        let verdicts: Vec<Value> = self.all().iter().map(one).collect();
        let identities = self.account().claims.iter().filter_map(|c| {
            let standing = c.identity.as_ref()?.standing();
            Some((id(&c.id, c.reading.as_ref()), Value::from(standing.replace(' ', "_"))))
        });
        let identities: Map<String, Value> = identities.collect();
        json!({ "as_expected": self.is_expected(), "verdicts": verdicts, "for_all_values": identities })
    }

    /// The `verdict` on units (`units_agree_where_they_are_known`, `units_differ`, `no_units_are_known`), and the `differences`.
    pub fn units_brief(&self) -> Value {
        let formulas = &self.account().units.formulas;
        let differences = formulas.iter().filter_map(|f| {
            let UnitVerdict::Inconsistent { relation, terms } = &f.verdict else { return None };
            let terms: Vec<Value> = terms.iter().map(|t| json!({ "term": t.latex, "unit": t.unit })).collect();
            Some(
                json!({ "of": format!("{} {}", f.kind, f.of), "formula": f.formula, "these": relation, "terms": terms }),
            )
        });
        let differences: Vec<Value> = differences.collect();
        let verdict = match (differences.is_empty(), formulas.is_empty()) {
            (false, _) => "units_differ",
            (true, false) => "units_agree_where_they_are_known",
            (true, true) => "no_units_are_known",
        };
        json!({ "verdict": verdict, "differences": differences })
    }
}

impl Session {
    /// The `verdict` of a search for a motion on which a claim fails (`fails_on_this_motion`, `none_found`), the `trajectory` as a file has
    /// it, and `notes`.
    ///
    /// # Errors
    /// As for [`search`](Session::search).
    pub fn search_brief(&self, options: &SearchOptions) -> Result<Value, Failure> {
        let found = self.search(options, &|_, _| {})?;
        let notes = report::search_notes(&self.derivation().id, &found);
        let table = report::search_table(&found);
        let verdict = if table.is_some() { "fails_on_this_motion" } else { "none_found" };
        Ok(json!({ "claim": options.claim, "verdict": verdict, "trajectory": table, "notes": notes }))
    }

    /// How a formula is understood: the `verdict` (`read`, `not_read`), `read_as`, without ambiguity, or `why` it is not read.
    ///
    /// # Errors
    /// Declarations that are not understood.
    pub fn read_brief(&self, formula: String, symbols: &[String]) -> Result<Value, Failure> {
        let mut derivation = self.derivation().clone();
        let numbered = symbols.iter().enumerate();
        let typed: Vec<_> = numbered.map(|(at, text)| (format!("symbol {}", at + 1), text.clone())).collect();
        derivation.declare_typed(&typed)?;
        Ok(match latex::parse(&formula, &derivation.scope) {
            Ok(chains) => {
                let read: Vec<String> = chains.iter().map(latex::syntax::to_latex).collect();
                json!({ "verdict": "read", "read_as": read })
            }
            Err(problems) => {
                let source = Arc::new(diag::Source { path: "formula".into(), text: formula });
                let problems: Vec<_> =
                    problems.into_iter().map(|p| diag::Diagnostic::of_formula(&source, 0, p)).collect();
                json!({ "verdict": "not_read", "why": diag::render(&problems, false) })
            }
        })
    }
}
