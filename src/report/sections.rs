//! The sections on what a report is of: conventions, symbols, systems, motions, what was measured, and how it was made.
//!
//! **In:** a derivation and its account. **Out:** each section as blocks, for every kind of report; nothing where there is nothing to say.

use super::family;
use super::numbers::{count, six, size, time};
use super::story::{
    PartLevel, StoryBlock, StoryItem, StorySpan, fold, on_page, part, prose, quiet, section, texts, words,
};
use super::wording::unit;
use derivation::{DEFAULT_PRECISION, Derivation, Measure, SymbolEntry};
use findings::{Account, Measurement};

/// Most values of a measure that are shown of one motion.
const VALUES_SHOWN: usize = 12;

/// Items with what each is about before it.
fn terms<'a>(all: impl IntoIterator<Item = (String, Vec<StorySpan<'a>>)>) -> StoryBlock<'a> {
    let item = |(term, line)| StoryItem { mark: format!("{term}:"), line, below: Vec::new() };
    StoryBlock::List(all.into_iter().map(item).collect())
}

/// What the file says of itself: what is checked, and where that is printed.
pub(super) fn concerns(derivation: &Derivation) -> Vec<StoryBlock<'_>> {
    let scope = &derivation.scope;
    let what = StoryBlock::Paragraph(vec![words("What is checked: "), prose(&derivation.concerns, scope)]);
    let source = derivation.source.iter().map(|text| StoryBlock::Paragraph(vec![prose(text, scope)]));
    std::iter::once(what).chain(source).collect()
}

/// The conventions of the file.
pub(super) fn conventions(derivation: &Derivation) -> Option<StoryBlock<'_>> {
    let all = derivation.conventions.iter();
    let all = all.map(|(key, text)| (key.replace('-', " "), vec![prose(text, &derivation.scope)]));
    (!derivation.conventions.is_empty()).then(|| section("/conventions", "Conventions", vec![terms(all)]))
}

/// The symbols.
pub(super) fn symbols(derivation: &Derivation) -> StoryBlock<'_> {
    let head = ["symbol", "role", "shape", "unit", "definition", "notes"];
    let table = texts("Table of symbols", &head, derivation.symbols.iter().map(|s| symbol(derivation, s)));
    section("/symbols", "Symbols", vec![fold(count(derivation.symbols.len(), "symbol"), vec![table])])
}

fn symbol<'a>(derivation: &'a Derivation, of: &'a SymbolEntry) -> Vec<Vec<StorySpan<'a>>> {
    let scope = &derivation.scope;
    let diagonal = if derivation.graph.is_diagonal(of.symbol) { "diagonal " } else { "" };
    let mut notes: Vec<StorySpan<'a>> = of.says.iter().map(|says| prose(says, scope)).collect();
    if let Some(scale) = &of.scale {
        notes.extend([words(" (scale factor "), StorySpan::Math(scale.clone(), scope), words(")")]);
    }
    notes.extend(of.positive.then(|| words(" (positive)")));
    notes.extend(of.angle.then(|| words(" (angle, continued without jumps)")));
    vec![
        vec![StorySpan::Math(of.name.clone(), scope)],
        vec![words(of.role_word())],
        vec![words(format!("{diagonal}{}", derivation.graph.shape(of.symbol)))],
        of.unit.iter().map(|u| words(unit(u))).collect(),
        of.formula.iter().map(|f| StorySpan::Math(f.clone(), scope)).collect(),
        notes,
    ]
}

/// The systems of equations.
pub(super) fn systems(derivation: &Derivation) -> Option<StoryBlock<'_>> {
    let scope = &derivation.scope;
    let parts = derivation.systems.iter().map(|system| {
        let says = system.says.iter().map(|says| StoryBlock::Paragraph(vec![prose(says, scope)]));
        let equations = system.equations.iter().map(|e| StoryBlock::Formula(e.text.clone(), scope));
        let place = format!("/system/{}", system.id);
        part(place, PartLevel::Subsection, vec![words(&system.id)], says.chain(equations).collect())
    });
    let parts: Vec<StoryBlock<'_>> = parts.collect();
    (!parts.is_empty()).then(|| section("/systems", "Systems", parts))
}

/// The motions, a row for each: a page has an article of each instead.
pub(super) fn motions<'a>(derivation: &'a Derivation, account: &'a Account) -> Option<StoryBlock<'a>> {
    let scope = &derivation.scope;
    let rows = account.trajectories.iter().enumerate().map(|(at, t)| {
        let has_title = t.title != t.id;
        let mut what: Vec<StorySpan<'a>> = has_title.then(|| prose(&t.title, scope)).into_iter().collect();
        // Most are integrated.
        if t.source != "integrated" {
            what.push(words(format!("{}{}", if has_title { "; " } else { "" }, t.source)));
        }
        vec![
            vec![words((at + 1).to_string())],
            vec![words(&t.id)],
            what,
            vec![words(format!("{} … {}", time(t.span.0), time(t.span.1)))],
            vec![words(size(t.error))],
        ]
    });
    let table = texts("Table of motions", &["no.", "id", "what it is", "t", "error at most"], rows);
    let mut blocks = vec![
        fold(count(account.trajectories.len(), "motion"), vec![table]),
        StoryBlock::Paragraph(vec![words(
            "Integrated, where nothing else is said. Parameters and initial values: the derivation file and report.json.",
        )]),
    ];
    blocks.extend(account.trajectories.iter().filter_map(|t| {
        let problem = t.problem.as_ref()?;
        Some(StoryBlock::Paragraph(vec![words(format!("{}: {problem}", t.id))]))
    }));
    (!account.trajectories.is_empty()).then(|| section("/trajectories", "Motions", blocks))
}

/// What was measured on motions and families.
pub(super) fn measures<'a>(derivation: &'a Derivation, account: &'a Account) -> Option<StoryBlock<'a>> {
    let is_measured = !account.measurements.is_empty() || !account.distributions.is_empty();
    let parts = derivation.measures.iter().map(|of| measure(derivation, account, of)).collect();
    is_measured.then(|| section("/measures", "Measured", parts))
}

fn measure<'a>(derivation: &'a Derivation, account: &'a Account, of: &'a Measure) -> StoryBlock<'a> {
    let scope = &derivation.scope;
    let mut says = vec![prose(format!("{}: ${}$", of.says, of.formula.text), scope)];
    match (&of.at, &of.since) {
        (Some(_), Some(_)) => says.push(prose(format!(": {}", family::taken(of)), scope)),
        (Some(at), None) => {
            says.push(prose(format!(", taken when ${}${}", at.equation.text, at.occasion.words()), scope));
        }
        (None, _) => {}
    }
    says.extend(of.unit.iter().map(|u| words(format!(", in {}", unit(u)))));
    says.push(words("."));
    let found: Vec<&Measurement> = account.measurements.iter().filter(|m| m.measure == of.id).collect();
    let mut blocks = vec![StoryBlock::Paragraph(says)];
    blocks.extend(range(&found).map(|text| StoryBlock::Paragraph(vec![words(text)])));
    for of in account.distributions.iter().filter(|d| d.measure == of.id) {
        let told = format!("On the family {}: {}.", of.family, family::distribution(of));
        blocks.push(StoryBlock::Paragraph(vec![prose(told, scope)]));
    }
    if !found.is_empty() {
        let rows = found.iter().map(|m| vec![vec![motion(&m.trajectory)], values(derivation, m)]);
        let head = ["motion", "value ± error bound (time)"];
        blocks.push(on_page("Values", "", vec![texts(format!("Values of {}", of.id), &head, rows)]));
    }
    part(format!("/measure/{}", of.id), PartLevel::Subsection, vec![words(&of.id)], blocks)
}

/// A motion, by its name.
pub(super) fn motion<'a>(id: &str) -> StorySpan<'a> {
    StorySpan::Section(id.to_owned(), format!("/trajectory/{id}"))
}

fn values<'a>(derivation: &'a Derivation, of: &'a Measurement) -> Vec<StorySpan<'a>> {
    let one = |(t, v, b): &(f64, f64, f64)| format!("{} ± {} (t = {})", time(*v), size(*b), time(*t));
    let shown: Vec<String> = of.values.iter().take(VALUES_SHOWN).map(one).collect();
    let mut out = vec![words(shown.join("; "))];
    let more = of.values.len().saturating_sub(VALUES_SHOWN);
    out.extend((more > 0).then(|| words(format!("; {more} more in report.json"))));
    out.extend(of.reason.iter().map(|why| prose(format!(" {why}"), &derivation.scope)));
    out
}

/// The least and the largest value, and on how many motions there is one; all of them are in `report.json`.
fn range(found: &[&Measurement]) -> Option<String> {
    let each = || found.iter().flat_map(|m| m.values.iter().map(move |(t, v, b)| (m, *t, *v, *b)));
    let told = |(m, t, v, b): (&&Measurement, f64, f64, f64)| {
        format!("{} ± {} ({}, t = {})", six(v), size(b), m.trajectory, six(t))
    };
    let on = count(found.iter().filter(|m| !m.values.is_empty()).count(), "motion");
    let without = found.iter().filter(|m| m.values.is_empty()).count();
    let without = if without > 0 { format!(" No value on {without}.") } else { String::new() };
    let (least, most) = (each().min_by(|a, b| a.2.total_cmp(&b.2)), each().max_by(|a, b| a.2.total_cmp(&b.2)));
    match (least, most) {
        (Some(a), Some(b)) if a.2 == b.2 => Some(format!("On {on}: {}.{without}", told(a))),
        (Some(a), Some(b)) => Some(format!("On {on}, from {} to {}.{without}", told(a), told(b))),
        _ => (!without.is_empty()).then(|| without.trim().to_owned()),
    }
}

/// What is needed to repeat the report, and what its words mean.
pub(super) fn making(derivation: &Derivation) -> StoryBlock<'_> {
    let path = super::project_path(&derivation.file.path);
    let plain = |term: &str, text: String| (term.to_owned(), vec![words(text)]);
    let command = format!("{} check {path}", crate::PROGRAM);
    let all = [
        plain("program", format!("{} {}", crate::PROGRAM, env!("CARGO_PKG_VERSION"))),
        plain("derivation file", path),
        ("SHA-256 of the file".to_owned(), vec![StorySpan::Code(derivation.sha256.clone())]),
        ("to repeat it".to_owned(), vec![StorySpan::Code(command)]),
        plain(
            "precision asked for",
            format!("{} of the size of the terms, where a claim does not say otherwise", size(DEFAULT_PRECISION)),
        ),
        plain("seeds", "fixed by program and file: the same input gives the same report".to_owned()),
    ];
    let says = "A verdict is sampled (at finitely many times, each residual, left side minus right side, against its own error bound, \
                from the motion and from rounding), enclosed (rigorously, for every time) or proved (for all values). A bound that is \
                larger than the precision asked for leaves the claim undecided.";
    // Elsewhere it stands at the head.
    let source = derivation.source.as_ref().map(|text| vec![quiet("Source: "), prose(text, &derivation.scope)]);
    let source = source.map(|line| StoryBlock::Group("page", vec![StoryBlock::Paragraph(line)]));
    let blocks = source.into_iter().chain([terms(all), StoryBlock::Paragraph(vec![quiet(says)])]);
    section("/making", "How it was made", blocks.collect())
}
