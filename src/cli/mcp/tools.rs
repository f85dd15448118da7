//! The tools of the server: what each is called with, and what it answers. What a client is told of them is in `tools.json`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use rederive::check::search::SearchOptions;
use rederive::check::{Limits, Proposition, Rigor};
use rederive::derivation::LARGEST_FILE;
use rederive::diag::Source;
use rederive::latex::Logarithm;
use rederive::{Ask, Findings, Question, Session, diag, files, lint, paper, report};
use serde_json::{Map, Value, json};

use super::super::ending::Stop;

/// Longest text of a paper that is handed over, in bytes; one in a file may be longer.
const LONGEST_TEXT: usize = 1 << 20;
/// Most relations of a text: an answer has some kilobytes for each.
const MOST_RELATIONS: usize = 10_000;

/// Where tools work: what they are, what they may read, and how long they may take.
pub(super) struct Workbench {
    tools: Vec<Value>,
    folder: Option<PathBuf>,
    seconds: f64,
}

/// The arguments of a call, which are as the schema of its tool says.
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

impl Workbench {
    pub(super) fn new(folder: Option<&Path>, seconds: f64) -> Result<Workbench, Stop> {
        if let Some(none) = folder.filter(|f| !f.is_dir()) {
            return Err(format!("`{}` is no folder", none.display()).into());
        }
        let mut tools: Vec<Value> =
            serde_json::from_str(include_str!("tools.json")).map_err(|e| format!("the list of tools: {e}"))?;
        for tool in &mut tools {
            tool["annotations"] = json!({ "readOnlyHint": true, "openWorldHint": false });
        }
        Ok(Workbench { tools, folder: folder.map(Path::to_path_buf), seconds })
    }

    /// The tools, as a client is told of them.
    pub(super) fn described(&self) -> &[Value] {
        &self.tools
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.tools.iter().any(|tool| tool["name"] == name)
    }

    /// Calls a tool; what it finds, or why it finds nothing.
    pub(super) fn call(&self, name: &str, arguments: &Value) -> Result<Value, String> {
        let tool = self.tools.iter().find(|tool| tool["name"] == name).unwrap_or(&Value::Null);
        fits(tool, arguments)?;
        let defect = "a defect of rederive: please report it, with the call".to_owned();
        let limits = Limits { deadline: Limits::after(Some(self.seconds)), ..Limits::default() };
        meter::under(&limits, || self.run(name, &Arguments(arguments))).unwrap_or(Err(defect))
    }

    fn run(&self, name: &str, given: &Arguments<'_>) -> Result<Value, String> {
        let claim = given.needed("claim");
        match name {
            "prove" => prove(given),
            "lint" => self.lint(given),
            "check" => {
                let claims = given.texts("claims");
                Ok(self.checked(given, Ask { claims, only_verdicts: true, ..Ask::default() })?.brief())
            }
            "explain" => {
                let found = self.checked(given, Ask { claims: vec![claim.clone()], ..Ask::default() })?;
                let text = found.explanation(&claim, &[], false).ok_or("the claim is tried on no motion")?;
                Ok(json!({ "claim": claim, "explanation": text }))
            }
            "search" => {
                let options = SearchOptions { claim, seed: 1, tries: 480, variant: None };
                self.session(given)?.search_brief(&options).map_err(|f| f.to_string())
            }
            "read_formula" => {
                let read = Session::blank().read_brief(given.needed("formula"), &given.texts("symbols"));
                read.map_err(|f| f.to_string())
            }
            "units" => Ok(self.checked(given, Ask { only_verdicts: true, ..Ask::default() })?.units_brief()),
            _ => Err("this tool does nothing".to_owned()),
        }
    }

    /// The text that is meant, its name, and the folder in which it lies.
    fn source(&self, given: &Arguments<'_>, name: &str, largest: u64) -> Result<(Source, Option<PathBuf>), String> {
        match (given.text("text"), given.text("path")) {
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

    fn session(&self, given: &Arguments<'_>) -> Result<Session, String> {
        let (Source { path, text }, _) = self.source(given, "derivation.toml", LARGEST_FILE)?;
        Session::open(&path, text).map_err(|problems| diag::render(&problems, false))
    }

    /// The findings of a derivation file, enclosed where that is possible.
    fn checked(&self, given: &Arguments<'_>, ask: Ask) -> Result<Findings, String> {
        let ask = Ask { rigor: Rigor::Enclosed, limits: meter::limits(), ..ask };
        self.session(given)?.check(&ask, &|_, _| {}).map_err(|f| f.to_string())
    }

    fn lint(&self, given: &Arguments<'_>) -> Result<Value, String> {
        if let Some(n) = given.text("text").map(str::len).filter(|n| *n > LONGEST_TEXT) {
            return Err(format!("the text has {n} bytes, and {LONGEST_TEXT} are looked through: hand over a part"));
        }
        let (source, folder) = self.source(given, "text.tex", paper::LARGEST_PAPER)?;
        let paper = match folder {
            Some(folder) => paper::parse_in(Arc::new(source), Some(&folder)),
            None => paper::parse_pasted(&source.path, &source.text),
        };
        let mut paper = paper.map_err(|p| diag::render(&[*p], false))?;
        paper.logarithm = logarithm(given)?;
        if paper.relations.len() > MOST_RELATIONS {
            let n = paper.relations.len();
            return Err(format!("there are {n} relations, and {MOST_RELATIONS} are looked through: hand over a part"));
        }
        Ok(report::lint_document(&paper, &lint::lint(&paper, &meter::limits())))
    }
}

/// What `\log` is, where a call says it.
fn logarithm(given: &Arguments<'_>) -> Result<Option<Logarithm>, String> {
    let named = |name| Logarithm::named(name).ok_or_else(|| "`log` is `natural` or `decimal`".to_owned());
    given.text("log").map(named).transpose()
}

fn prove(given: &Arguments<'_>) -> Result<Value, String> {
    let (formula, premises) = (given.needed("formula"), given.texts("given"));
    let proposition = Proposition { formula, given: premises, ..Proposition::default() };
    let question = Question { proposition, symbols: given.texts("symbols"), scope: None };
    let answer = logarithm(given)?.into_iter().fold(Session::blank(), Session::with_logarithm).prove(&question);
    let told = answer.map_err(|f| f.where_symbols_are_declared("declare it in `symbols`").to_string());
    Ok(told?.brief())
}

/// Whether arguments are as the schema of a tool says: texts, or lists of texts.
fn fits(tool: &Value, arguments: &Value) -> Result<(), String> {
    let (name, schema) = (tool["name"].as_str().unwrap_or_default(), &tool["inputSchema"]);
    let none = Map::new();
    let given = arguments.as_object().unwrap_or(&none);
    for (key, value) in given {
        let is_right = match schema["properties"][key]["type"].as_str() {
            Some("string") => value.is_string(),
            Some(_) => value.as_array().is_some_and(|all| all.iter().all(Value::is_string)),
            None => return Err(format!("`{name}` takes no `{}`", diag::escape::in_one_line(key))),
        };
        if !is_right {
            return Err(format!("`{key}` is not what `{name}` takes"));
        }
    }
    let mut needed = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
    needed.find(|key| !given.contains_key(*key)).map_or(Ok(()), |key| Err(format!("`{name}` needs `{key}`")))
}
