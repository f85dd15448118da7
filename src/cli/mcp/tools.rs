//! The tools of the server: what each is called with, and what it answers.

use std::panic::AssertUnwindSafe;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rederive::check::search::SearchOptions;
use rederive::check::{Limits, Proposition, Rigor};
use rederive::derivation::LARGEST_FILE;
use rederive::diag::Source;
use rederive::units::UnitVerdict;
use rederive::{Ask, Failure, Finding, Outcome, Question, Session, Strength, diag, files, latex, lint, paper, report};
use serde_json::{Map, Value, json};

use super::super::ending::Stop;

/// A tool.
pub(super) struct Tool {
    pub name: &'static str,
    says: &'static str,
    /// Its arguments: name, whether it is a list of texts, whether it must be there, and what it is.
    takes: &'static [(&'static str, Kind, &'static str)],
    run: fn(&Workbench, &Arguments<'_>) -> Result<Value, String>,
}

/// What an argument is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Text,
    /// May be left out.
    MaybeText,
    MaybeTexts,
}

const TEXT: (&str, Kind, &str) = ("text", Kind::MaybeText, "The text itself");
const PATH: (&str, Kind, &str) =
    ("path", Kind::MaybeText, "In place of the text: a file, relative to the folder of the server");

pub(super) const TOOLS: &[Tool] = &[
    Tool {
        name: "prove",
        says: "Decides an equation in LaTeX for all values of its symbols. Verdicts: proved (for all values), proved_except (but for the cases that are named), refuted_by_a_point (with the point), undecided.",
        takes: &[
            ("formula", Kind::Text, r"The equation, e.g. \sin 2x=2\sin x\cos x"),
            ("given", Kind::MaybeTexts, "Premises in LaTeX, e.g. x>0"),
            (
                "symbols",
                Kind::MaybeTexts,
                r"Declarations: `x`, `x, y`, `q: state` (a function of time, \dot q its rate), `m: positive`, `A: 3x3`",
            ),
        ],
        run: prove,
    },
    Tool {
        name: "lint",
        says: "Says of every relation in LaTeX (a chain A=B=C, a page, a paper) whether it follows_proved, holds_in_numbers, is wrong_refuted_by_a_point (`instead` is the nearest formula that is proved), defines, or is not_followed: what is not followed is not confirmed.",
        takes: &[TEXT, PATH],
        run: lint_paper,
    },
    Tool {
        name: "check",
        says: "Checks a derivation file (TOML: symbols, systems, trajectories, claims): for each claim on each motion holds_proved, holds_enclosed (at every time), holds_sampled, fails_certified, fails_sampled, not_applicable or undecided, with a witness or a reason.",
        takes: &[TEXT, PATH, ("claims", Kind::MaybeTexts, "Only these claims, `id` or `id/reading`")],
        run: check,
    },
    Tool {
        name: "explain",
        says: "How the verdicts on one claim of a derivation file came about, in words.",
        takes: &[TEXT, PATH, ("claim", Kind::Text, "The claim, `id` or `id/reading`")],
        run: explain,
    },
    Tool {
        name: "search",
        says: "Searches for a motion on which a claim of a derivation file fails; none found does not show that there is none.",
        takes: &[TEXT, PATH, ("claim", Kind::Text, "The claim, `id` or `id/reading`")],
        run: search,
    },
    Tool {
        name: "read_formula",
        says: "How a formula in LaTeX is understood, written anew without ambiguity; or why it is not read.",
        takes: &[("formula", Kind::Text, "The formula"), ("symbols", Kind::MaybeTexts, "Declarations, as for `prove`")],
        run: read_formula,
    },
    Tool {
        name: "units",
        says: "Whether the formulas of a derivation file agree in their units.",
        takes: &[TEXT, PATH],
        run: units,
    },
];

impl Tool {
    /// What a client is told of it.
    pub(super) fn described(&self) -> Value {
        let schema = |kind: Kind, says: &str| match kind {
            Kind::Text | Kind::MaybeText => json!({ "type": "string", "description": says }),
            Kind::MaybeTexts => json!({ "type": "array", "items": { "type": "string" }, "description": says }),
        };
        let properties: Map<String, Value> =
            self.takes.iter().map(|(name, kind, says)| ((*name).to_owned(), schema(*kind, says))).collect();
        let required: Vec<&str> =
            self.takes.iter().filter(|(_, k, _)| *k == Kind::Text).map(|(name, ..)| *name).collect();
        json!({
            "name": self.name,
            "description": self.says,
            "inputSchema": { "type": "object", "properties": properties, "required": required, "additionalProperties": false },
            "annotations": { "readOnlyHint": true, "openWorldHint": false },
        })
    }
}

/// The arguments of a call, which are those of its tool.
struct Arguments<'a>(&'a Value);

impl<'a> Arguments<'a> {
    fn text(&self, name: &str) -> Option<&'a str> {
        self.0.get(name).and_then(Value::as_str)
    }

    fn needed(&self, name: &str) -> String {
        self.text(name).unwrap_or_default().to_owned()
    }

    fn texts(&self, name: &str) -> Vec<String> {
        let all = self.0.get(name).and_then(Value::as_array);
        all.into_iter().flatten().filter_map(Value::as_str).map(str::to_owned).collect()
    }
}

/// Where tools work: what they may read, and how long they may take.
pub(super) struct Workbench {
    folder: Option<PathBuf>,
    seconds: f64,
}

impl Workbench {
    pub(super) fn new(folder: Option<&Path>, seconds: f64) -> Result<Workbench, Stop> {
        if let Some(none) = folder.filter(|f| !f.is_dir()) {
            return Err(format!("`{}` is no folder", none.display()).into());
        }
        Ok(Workbench { folder: folder.map(Path::to_path_buf), seconds })
    }

    /// Calls a tool; what it finds, or why it finds nothing.
    pub(super) fn call(&self, tool: &Tool, arguments: &Value) -> Result<Value, String> {
        let none = Map::new();
        let given = arguments.as_object().unwrap_or(&none);
        for (name, value) in given {
            let kind = tool.takes.iter().find(|(known, ..)| known == name).map(|(_, kind, _)| *kind);
            let fits = match kind {
                None => return Err(format!("`{}` takes no `{}`", tool.name, diag::escape::in_one_line(name))),
                Some(Kind::Text | Kind::MaybeText) => value.is_string(),
                Some(Kind::MaybeTexts) => value.as_array().is_some_and(|all| all.iter().all(Value::is_string)),
            };
            if !fits {
                return Err(format!("`{name}` is not what `{}` takes", tool.name));
            }
        }
        if let Some((name, ..)) =
            tool.takes.iter().find(|(name, kind, _)| *kind == Kind::Text && !given.contains_key(*name))
        {
            return Err(format!("`{}` needs `{name}`", tool.name));
        }
        let defect = "a defect of rederive: please report it, with the call".to_owned();
        std::panic::catch_unwind(AssertUnwindSafe(|| (tool.run)(self, &Arguments(arguments)))).unwrap_or(Err(defect))
    }

    fn limits(&self) -> Limits {
        Limits { deadline: Limits::after(Some(self.seconds)), ..Limits::default() }
    }

    /// The text that is meant, its name, and the folder in which it lies.
    fn source(&self, arguments: &Arguments<'_>, name: &str, largest: u64) -> Result<(Source, Option<PathBuf>), String> {
        match (arguments.text("text"), arguments.text("path")) {
            (Some(text), None) => Ok((Source { path: name.to_owned(), text: text.to_owned() }, None)),
            (None, Some(path)) => {
                let folder =
                    self.folder.as_deref().ok_or("the server was started without --folder: hand over the text")?;
                let file = folder.join(path);
                if !files::lies_inside(&file, folder) {
                    return Err("there is no such file inside of the folder of the server".to_owned());
                }
                let text = files::read_text(&file, largest).map_err(|e| e.to_string())?;
                Ok((Source { path: path.to_owned(), text }, file.parent().map(Path::to_path_buf)))
            }
            _ => Err("one of `text` and `path` is needed".to_owned()),
        }
    }

    fn session(&self, arguments: &Arguments<'_>) -> Result<Session, String> {
        let (Source { path, text }, _) = self.source(arguments, "derivation.toml", LARGEST_FILE)?;
        Session::open(&path, text).map_err(|problems| diag::render(&problems, false))
    }
}

fn told(failure: Failure) -> String {
    failure.to_string()
}

fn prove(_: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let proposition =
        Proposition { formula: arguments.needed("formula"), given: arguments.texts("given"), ..Proposition::default() };
    let question = Question { proposition, symbols: arguments.texts("symbols"), scope: None };
    let answer =
        Session::blank().prove(&question).map_err(|f| told(f.where_symbols_are_declared("declare it in `symbols`")))?;
    let whole: Value = serde_json::from_str(&answer.json()).map_err(|e| e.to_string())?;
    let verdict = match answer.standing() {
        "refuted" => "refuted_by_a_point".to_owned(),
        other => other.replace(' ', "_"),
    };
    let mut out = Map::from_iter([("verdict".to_owned(), Value::from(verdict))]);
    let kept =
        ["formula", "given", "reason", "witness", "exceptions", "conditions", "given_only_where", "contradiction"];
    out.extend(kept.into_iter().filter_map(|key| Some((key.to_owned(), whole.get(key)?.clone()))));
    Ok(Value::Object(out))
}

fn lint_paper(bench: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let (source, folder) = bench.source(arguments, "text.tex", paper::LARGEST_PAPER)?;
    // A file says where its formulas begin; a text that is handed over may be nothing but formulas.
    let text = if folder.is_none() { paper::in_displays(&source.text).into_owned() } else { source.text };
    let source = Source { text, ..source };
    let paper = paper::parse_in(Arc::new(source), folder.as_deref()).map_err(|p| diag::render(&[*p], false))?;
    Ok(report::lint_document(&paper, &lint::lint(&paper)))
}

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

fn check(bench: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let session = bench.session(arguments)?;
    let ask = Ask {
        claims: arguments.texts("claims"),
        rigor: Rigor::Enclosed,
        only_verdicts: true,
        limits: bench.limits(),
        ..Ask::default()
    };
    let found = session.check(&ask, &|_, _| {}).map_err(told)?;
    let one = |f: &Finding| {
        let claim = f.claim.reading.as_ref().map_or_else(|| f.claim.id.clone(), |r| format!("{}/{r}", f.claim.id));
        let witness = f.witness.as_ref().map(|w| {
            json!({ "formula": w.formula, "t": w.t, "left": w.left, "right": w.right, "error_bound": w.bound, "values": w.values })
        });
        json!({
            "claim": claim, "says": f.claim.says, "motion": f.trajectory.as_ref().or(f.family.as_ref()), "verdict": named(f.outcome),
            "as_expected": f.is_expected, "reason": f.reason, "witness": witness,
        })
    };
    let verdicts: Vec<Value> = found.all().iter().map(one).collect();
    let identities = found.account().claims.iter().filter_map(|c| {
        let standing = c.identity.as_ref()?.standing();
        let name = c.reading.as_ref().map_or_else(|| c.id.clone(), |r| format!("{}/{r}", c.id));
        Some((name, Value::from(standing.replace(' ', "_"))))
    });
    let identities: Map<String, Value> = identities.collect();
    Ok(json!({ "as_expected": found.is_expected(), "verdicts": verdicts, "for_all_values": identities }))
}

fn explain(bench: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let (session, claim) = (bench.session(arguments)?, arguments.needed("claim"));
    let ask = Ask { claims: vec![claim.clone()], rigor: Rigor::Enclosed, limits: bench.limits(), ..Ask::default() };
    let found = session.check(&ask, &|_, _| {}).map_err(told)?;
    let text = found.explanation(&claim, &[], false).ok_or("the claim is tried on no motion")?;
    Ok(json!({ "claim": claim, "explanation": text }))
}

fn search(bench: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let (session, claim) = (bench.session(arguments)?, arguments.needed("claim"));
    let options = SearchOptions { claim: claim.clone(), seed: 1, tries: 480, variant: None };
    let found = session.search(&options, &|_, _| {}).map_err(told)?;
    let notes = report::search_notes(&session.derivation().id, &found);
    let table = report::search_table(&found);
    let verdict = if table.is_some() { "fails_on_this_motion" } else { "none_found" };
    Ok(json!({ "claim": claim, "verdict": verdict, "trajectory": table, "notes": notes }))
}

fn read_formula(_: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let mut derivation = Session::blank().derivation().clone();
    let texts = arguments.texts("symbols").into_iter().enumerate();
    let typed: Vec<_> = texts.map(|(at, text)| (format!("symbol {}", at + 1), text)).collect();
    derivation.declare_typed(&typed).map_err(|problems| diag::render(&problems, false))?;
    let formula = arguments.needed("formula");
    match latex::parse(&formula, &derivation.scope) {
        Ok(chains) => {
            let read: Vec<String> = chains.iter().map(latex::syntax::to_latex).collect();
            Ok(json!({ "verdict": "read", "read_as": read }))
        }
        Err(problems) => {
            let source = Arc::new(Source { path: "formula".into(), text: formula });
            let problems: Vec<_> = problems.into_iter().map(|p| diag::Diagnostic::of_formula(&source, 0, p)).collect();
            Ok(json!({ "verdict": "not_read", "why": diag::render(&problems, false) }))
        }
    }
}

fn units(bench: &Workbench, arguments: &Arguments<'_>) -> Result<Value, String> {
    let session = bench.session(arguments)?;
    let ask = Ask { only_verdicts: true, limits: bench.limits(), ..Ask::default() };
    let found = session.check(&ask, &|_, _| {}).map_err(told)?;
    let formulas = &found.account().units.formulas;
    let differences = formulas.iter().filter_map(|f| {
        let UnitVerdict::Inconsistent { relation, terms } = &f.verdict else { return None };
        let terms: Vec<Value> = terms.iter().map(|t| json!({ "term": t.latex, "unit": t.unit })).collect();
        Some(json!({ "of": format!("{} {}", f.kind, f.of), "formula": f.formula, "these": relation, "terms": terms }))
    });
    let differences: Vec<Value> = differences.collect();
    let verdict = match (differences.is_empty(), formulas.is_empty()) {
        (false, _) => "units_differ",
        (true, false) => "units_agree_where_they_are_known",
        (true, true) => "no_units_are_known",
    };
    Ok(json!({ "verdict": verdict, "differences": differences }))
}
