//! From the bytes of a file to a [`Derivation`].

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sha2::{Digest, Sha256};
use toml::de::{DeTable, DeValue};

use super::formula::Written;
use super::keys;
use super::model::{Derivation, System, Trajectory, Unknown};
use super::table::{Literal, Problems, Table, as_printed, check_id, text_of};
use diag::escape::{in_one_line, shown};
use diag::{Diagnostic, Problem, Source, sort};
use expr::{Symbol, Tensor};
use files::{FileError, Kind, Search, Why};
use latex::{self, DeclareError, Logarithm, Relation, RelationKind, Scope, Signature, Statement};
use meter::{Ended, Task};

/// Largest size of a derivation file, in bytes.
pub const LARGEST_FILE: u64 = 4 << 20;

/// Reads a derivation file.
///
/// # Errors
/// Every problem of the file, in the order of their places.
pub fn load(path: &Path) -> Result<Derivation, Vec<Diagnostic>> {
    let shown = shown(&path.display().to_string()).into_owned();
    let one = |d: Diagnostic| vec![d];
    let bytes = files::read(path, LARGEST_FILE).map_err(|error| {
        let (code, message) = match error.why {
            Why::NotAFile(what) => ("derivation::unreadable", format!("this is {what}, not a file")),
            Why::TooLarge(_) => ("derivation::too-large", format!("this file {}", error.why)),
            why => ("derivation::unreadable", format!("this file {why}")),
        };
        one(Diagnostic::of_file(&shown, code, message))
    })?;
    let text = String::from_utf8(bytes).map_err(|e| {
        let at = e.utf8_error().valid_up_to();
        let line = e.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1;
        let d = Diagnostic::of_file(
            &shown,
            "derivation::not-utf8",
            format!("this file is not UTF-8 text, see line {line}"),
        );
        one(d.hint("save it in the encoding UTF-8"))
    })?;
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    parse(Source { path: shown, text }, &stem)
}

/// The derivation files that paths mean, each of them once.
///
/// # Errors
/// As for [`files::meant`].
pub fn meant(paths: &[PathBuf]) -> Result<Search, FileError> {
    let toml = Kind { what: "derivation file (*.toml)", is_one: |path| path.extension().is_some_and(|e| e == "toml") };
    let mut out = files::meant(paths, toml)?;
    let mut seen = BTreeSet::new();
    out.found.retain(|path| seen.insert(path.clone()));
    Ok(out)
}

/// Reads several derivation files.
///
/// # Errors
/// Every problem of every file; ids that two of them have, or that differ in nothing but case: on some systems their reports are one folder.
pub fn load_all(paths: &[PathBuf]) -> Result<Vec<Derivation>, Vec<Diagnostic>> {
    let mut derivations: Vec<Derivation> = Vec::new();
    let mut problems = Vec::new();
    for read in paths.iter().map(|path| load(path)) {
        match read {
            Ok(derivation) => {
                let folded = derivation.id.to_lowercase();
                if let Some(first) = derivations.iter().find(|d| d.id.to_lowercase() == folded) {
                    let message = match first.id == derivation.id {
                        true => format!("`{}` has the same id, `{}`", first.file.path, derivation.id),
                        false => format!(
                            "`{}` has the id `{}`, and this one `{}`: where a system does not tell case, their reports are one",
                            first.file.path, first.id, derivation.id
                        ),
                    };
                    let d = Diagnostic::of_file(&derivation.file.path, "derivation::duplicate-id", message);
                    problems.push(d.hint("give one of them another id, in its table [derivation]"));
                }
                derivations.push(derivation);
            }
            Err(found) => problems.extend(found),
        }
    }
    if problems.is_empty() { Ok(derivations) } else { Err(problems) }
}

/// Reads the text of a derivation file; `stem` is its id unless it gives another.
///
/// # Errors
/// Every problem of the file, in the order of their places.
pub fn parse(source: Source, stem: &str) -> Result<Derivation, Vec<Diagnostic>> {
    let source = Arc::new(source);
    let (read, work) = meter::counted(Task::Reading, || parsed(Arc::clone(&source), stem));
    let mut read =
        read.unwrap_or_else(|ended| Err(vec![Diagnostic::at(&source, TOO_LARGE, 0..0, ended.to_string())]))?;
    // Each claim is proved in a copy of its own: copies would grow with the square of a file.
    read.graph.share();
    Ok(Derivation { work, ..read })
}

/// The code of what takes too much work to be read.
pub(super) const TOO_LARGE: &str = "derivation::work-limit";

fn too_large(text: &str, ended: &Ended) -> Problem {
    let hint = Some("say it with fewer calls of functions within one another, or with fewer indices".to_owned());
    Problem { code: TOO_LARGE, message: ended.to_string(), span: 0..text.len(), hint }
}

/// Reads a formula, as far as the work of one goes.
pub(super) fn within<T>(text: &str, read: impl FnOnce() -> Result<T, Vec<Problem>>) -> Result<T, Vec<Problem>> {
    meter::part(Task::Formula, read).unwrap_or_else(|ended| Err(vec![too_large(text, &ended)]))
}

/// Declares a symbol, as far as the work of its formula goes.
pub(super) fn declared<T>(
    formula: Option<&str>,
    declare: impl FnOnce() -> Result<T, DeclareError>,
) -> Result<T, DeclareError> {
    let found = meter::part(Task::Formula, declare);
    found.unwrap_or_else(|ended| Err(DeclareError::Formula(vec![too_large(formula.unwrap_or_default(), &ended)])))
}

fn parsed(source: Arc<Source>, stem: &str) -> Result<Derivation, Vec<Diagnostic>> {
    let (root, errors) = DeTable::parse_recoverable(&source.text);
    let mut problems = Problems { source: &source, found: Vec::new() };
    if !errors.is_empty() {
        let mut found: Vec<Diagnostic> = errors.iter().map(|e| syntax_error(&source, e)).collect();
        sort(&mut found);
        return Err(found);
    }
    let span = root.span();
    let entries = root.into_inner();
    let root = Table { entries: &entries, span: span.start..span.start, what: "a derivation file" };
    root.check_keys(&mut problems, keys::FILE);

    let mut loader = Loader::new(problems);
    loader.header(&root, stem);
    loader.small_symbols(&root);
    loader.systems(&root);
    loader.trajectories(&root);
    loader.families(&root);
    loader.domains(&root);
    loader.claims(&root);
    loader.circles();
    loader.measures(&root);
    loader.conditions(&root);
    loader.pictures(&root);
    loader.default_pictures();
    loader.finish()
}

fn syntax_error(source: &Arc<Source>, error: &toml::de::Error) -> Diagnostic {
    let message = error.message().trim_end_matches('.').replace('\n', "; ");
    let span = error.span().unwrap_or(0..0);
    let mut d = Diagnostic::at(source, "derivation::toml", span.clone(), message);
    if d.message.contains("escape") {
        d.hint = Some("formulas are written in single quotes: '\\Omega', not \"\\Omega\"".to_owned());
    } else if source.text.get(..span.start).zip(source.text.get(span.start..)).is_some_and(closed_twice) {
        let hint = "a prime ends what is in single quotes: write `^\\prime`, or a formula between ''' and ''', a name in double \
                    quotes with every backslash twice";
        d.hint = Some(hint.to_owned());
    }
    d
}

/// Whether a quote stands behind one that closes a string: it was meant as a prime.
fn closed_twice((before, after): (&str, &str)) -> bool {
    before.ends_with('\'') && after.starts_with('\'')
}

/// What is known while a file is read.
pub(super) struct Loader<'s> {
    pub problems: Problems<'s>,
    pub out: Derivation,
    /// Ids that are taken, by kind, with the place of each.
    taken: HashMap<(&'static str, String), Range<usize>>,
    /// Ids of things that were refused: no second complaint about a use of them.
    pub refused: Vec<String>,
    /// Constants whose values are in coherent units of the SI.
    pub in_si: Vec<String>,
    /// Whether upright names are units.
    pub has_units: bool,
    /// Initial values that are guessed, where guesses are taken.
    pub guesses: Option<Vec<Unknown>>,
    /// Symbols whose formulas take too much work to be read: that is no problem of the file, unless something else than a claim needs them.
    too_large: Vec<Diagnostic>,
}

impl<'s> Loader<'s> {
    fn new(problems: Problems<'s>) -> Loader<'s> {
        let file = Arc::clone(problems.source);
        let sha256 = Sha256::digest(file.text.as_bytes()).iter().map(|b| format!("{b:02x}")).collect();
        let out = Derivation { file, sha256, ..Derivation::blank() };
        Loader {
            problems,
            out,
            taken: HashMap::new(),
            refused: Vec::new(),
            in_si: Vec::new(),
            has_units: false,
            guesses: None,
            too_large: Vec::new(),
        }
    }

    /// Takes back the problems since some number of them, where all say that formulas take too much work, or need a symbol that does:
    /// why, in words.
    pub fn only_too_large(&mut self, before: usize) -> Option<String> {
        let found = self.problems.found.get(before..)?;
        let of_large = |d: &Diagnostic| d.code == "latex::unknown-symbol" && d.message == latex::REFUSED;
        let is_one = |d: &Diagnostic| d.code == TOO_LARGE || !self.too_large.is_empty() && of_large(d);
        if found.is_empty() || !found.iter().all(is_one) {
            return None;
        }
        let why = found.iter().chain(&self.too_large).find(|d| d.code == TOO_LARGE)?.message.clone();
        self.problems.found.truncate(before);
        Some(why)
    }

    /// The symbols of the file; those that take too much work are not there.
    fn small_symbols(&mut self, root: &Table<'_, '_>) {
        let before = self.problems.found.len();
        self.symbols(root);
        // What was refused for another reason is told, and so is what needs it.
        let large = self.problems.found.get(before..).unwrap_or_default().iter().filter(|d| d.code == TOO_LARGE);
        self.too_large = large.cloned().collect();
        if self.only_too_large(before).is_none() {
            self.too_large.clear();
        }
    }

    fn finish(self) -> Result<Derivation, Vec<Diagnostic>> {
        let mut found = self.problems.found;
        if found.is_empty() {
            return Ok(self.out);
        }
        found.extend(self.too_large);
        sort(&mut found);
        // A name that is not declared is told once, and one whose declaration was refused was told there.
        let mut told = BTreeSet::new();
        found.retain(|d| {
            let undeclared = d.code == "latex::unknown-symbol";
            !undeclared || d.message != latex::REFUSED && told.insert(d.message.clone())
        });
        Err(found)
    }

    fn header(&mut self, root: &Table<'_, '_>, stem: &str) {
        let problems = &mut self.problems;
        self.out.id = stem.to_owned();
        match root.get("derivation") {
            None => root.missing(problems, "[derivation]"),
            Some(value) => {
                if let Some(table) = Table::open(problems, value, "[derivation]", keys::DERIVATION) {
                    if table.get("id").is_some() {
                        self.out.id = table.id(problems, "id").map(|(id, _)| id).unwrap_or_default();
                    } else {
                        check_id(problems, stem, table.span.clone());
                    }
                    self.out.title = table.needed_text(problems, "title").unwrap_or_default();
                    self.out.concerns = table.needed_text(problems, "concerns").unwrap_or_default();
                    self.out.source = table.text(problems, "source");
                    self.out.remark = table.text(problems, "remark");
                    self.out.encoded_by = table.text(problems, "encoded-by");
                }
            }
        }
        if let Some(value) = root.get("conventions") {
            match value.get_ref() {
                DeValue::Table(entries) => {
                    for (key, value) in entries {
                        if let Some(text) = text_of(problems, value, key.get_ref()) {
                            if key.get_ref() == "log" {
                                match Logarithm::named(text.trim()) {
                                    Some(which) => self.out.scope.set_logarithm(which),
                                    None => {
                                        let other = text.trim();
                                        let message = format!("`log` is `natural` or `decimal`, not `{other}`");
                                        problems.note("derivation::wrong-type", value.span(), message);
                                    }
                                }
                            }
                            if key.get_ref() == "signature" {
                                match text.trim() {
                                    "+---" => self.out.scope.set_signature(Signature::Time),
                                    "-+++" => self.out.scope.set_signature(Signature::Space),
                                    // A sentence for the reader: `\Box` is then refused.
                                    _ => {}
                                }
                            }
                            // Any other text is for the reader of the report.
                            if key.get_ref() == "units" && text.trim() == "SI" {
                                self.out.scope.set_units();
                                self.has_units = true;
                            }
                            if key.get_ref() == "i" && text.trim() == "imaginary unit" {
                                self.out.scope.set_imaginary();
                            }
                            self.out.conventions.push((in_one_line(key.get_ref()), shown(text.trim()).into_owned()));
                        }
                    }
                }
                _ => problems.wrong_type(value, "conventions", "a table"),
            }
        }
    }

    /// Whether an id of this kind is new; the second use of one is noted.
    pub fn take(&mut self, kind: &'static str, id: &str, span: Range<usize>) -> bool {
        if let Some(first) = self.taken.get(&(kind, id.to_owned())) {
            let first = first.clone();
            self.problems
                .note("derivation::duplicate-id", span, format!("there are two of {kind} `{id}`"))
                .see(first, "the first one");
            return false;
        }
        self.taken.insert((kind, id.to_owned()), span);
        true
    }

    /// The statements of a formula, each with the part of the text that says it.
    pub fn statements(&mut self, formula: &Literal<'_>, scope: &Scope) -> Vec<Written<Statement>> {
        match within(formula.text, || latex::read(formula.text, scope, &mut self.out.graph)) {
            Ok(statements) if statements.is_empty() => {
                self.problems.note("derivation::empty-formula", formula.span.clone(), "this formula says nothing");
                Vec::new()
            }
            Ok(statements) if statements.len() == 1 => {
                let whole = 0..formula.text.len();
                statements.into_iter().map(|s| written(formula, whole.clone(), s)).collect()
            }
            Ok(statements) => statements.into_iter().map(|s| written(formula, s.span.clone(), s)).collect(),
            Err(found) => {
                self.note_formula(formula, found);
                Vec::new()
            }
        }
    }

    /// A formula without a relation.
    pub fn expression(&mut self, formula: &Literal<'_>, scope: &Scope) -> Option<Written<Tensor>> {
        match within(formula.text, || latex::read_expression(formula.text, scope, &mut self.out.graph)) {
            Ok(tensor) => Some(written(formula, 0..formula.text.len(), tensor)),
            Err(found) => {
                self.note_formula(formula, found);
                None
            }
        }
    }

    /// A formula that stands for one value: without ±.
    pub fn quantity(&mut self, formula: &Literal<'_>, scope: &Scope) -> Option<Written<Tensor>> {
        match within(formula.text, || latex::read_quantity(formula.text, scope, &mut self.out.graph)) {
            Ok(tensor) => Some(written(formula, 0..formula.text.len(), tensor)),
            Err(found) => {
                self.note_formula(formula, found);
                None
            }
        }
    }

    /// Relations where ± has no scope: it is refused.
    pub fn with_one_sign(&mut self, formula: &Literal<'_>, scope: &Scope) -> Vec<Written<Statement>> {
        let statements = self.statements(formula, scope);
        for statement in statements.iter().filter(|s| s.value.relations.iter().any(|r| r.has_branches)) {
            let message = "± has no meaning here: there is no claim that it belongs to";
            self.problems
                .note("latex::branches", statement.span.clone(), message)
                .hint("write the relation for one sign, or for both");
        }
        statements
    }

    /// Notes the problems that were found in a formula.
    pub fn note_formula(&mut self, formula: &Literal<'_>, found: Vec<diag::Problem>) {
        let source = self.problems.source;
        self.problems.found.extend(found.into_iter().map(|p| Diagnostic::of_formula(source, formula.start, p)));
    }

    /// The position of a trajectory, noted if there is none.
    pub fn trajectory(&mut self, name: &str, span: Range<usize>) -> Option<usize> {
        let found = self.out.trajectories.iter().position(|t: &Trajectory| t.id == name);
        if found.is_none() && !self.refused.iter().any(|r| r == name) {
            let ids = self.out.trajectories.iter().map(|t| t.id.as_str());
            self.problems.unknown("derivation::unknown-trajectory", span, "trajectory", name, ids);
        }
        found
    }

    /// The position of a system, noted if there is none.
    pub fn system(&mut self, name: &str, span: Range<usize>) -> Option<usize> {
        let found = self.out.systems.iter().position(|s: &System| s.id == name);
        if found.is_none() && !self.refused.iter().any(|r| r == name) {
            let ids = self.out.systems.iter().map(|s| s.id.as_str());
            self.problems.unknown("derivation::unknown-system", span, "system", name, ids);
        }
        found
    }

    /// Notes that the declaration of a name was refused.
    pub fn refuse_symbol(&mut self, name: &str, scope: &mut Scope) {
        scope.note_refused(name);
        self.refused.push(name.to_owned());
    }

    /// The symbol with this name, noted if there is none.
    pub fn symbol(&mut self, name: &str, span: Range<usize>, scope: &Scope) -> Option<Symbol> {
        let found = scope.symbol(name);
        if found.is_none() && !self.refused.iter().any(|r| r == name) {
            let names = self.out.symbols.iter().map(|s| s.name.as_str());
            self.problems.unknown("derivation::unknown-symbol", span, "symbol", name, names);
        }
        found
    }
}

/// Whether a relation is a plain equation, without a limit and without ±.
pub(super) fn is_equation(relation: &Relation) -> bool {
    relation.kind == RelationKind::Equal && relation.limit.is_none() && !relation.has_branches
}

/// A part of a formula with its meaning.
pub(super) fn written<T>(formula: &Literal<'_>, part: Range<usize>, value: T) -> Written<T> {
    let (part, text) = match formula.text.get(part.clone()) {
        Some(text) => (part, text),
        None => (0..formula.text.len(), formula.text),
    };
    let trimmed = text.trim();
    let start = formula.start + part.start + (text.len() - text.trim_start().len());
    Written { text: as_printed(trimmed), span: start..start + trimmed.len(), value }
}
