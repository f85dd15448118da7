//! `report.md`: the report for people, as a forge renders it.

use super::certificates::certificate_note;
use super::discrimination;
use super::graph::{DerivationGraph, rests_in_words};
use super::numbers::{count, size, time, value};
use super::tally::{Group, Standing, declared, glyph, groups, name, says};
use crate::check::{Account, ClaimAccount, PairAccount};
use crate::derivation::{DEFAULT_PRECISION, Derivation};

/// The report.
pub fn markdown(derivation: &Derivation, account: &Account) -> String {
    let mut out = format!("# {}\n\n", prose(&derivation.title));
    out.push_str(&format!("What is checked: {}\n\n", prose(&derivation.concerns)));
    for text in derivation.source.iter().chain(&derivation.remark) {
        out.push_str(&format!("{}\n\n", prose(text)));
    }
    out.push_str(&findings(derivation, account));
    out.push_str(&matrix(account));
    out.push_str(&super::alone::section(account));
    let graph = DerivationGraph::new(derivation, account);
    out.push_str(&graph.section());
    out.push_str(&conventions(derivation));
    out.push_str(&symbols(derivation));
    out.push_str(&systems(derivation));
    out.push_str(&trajectories(account));
    out.push_str(&claims(derivation, account, &graph));
    out.push_str(&measures(derivation, account));
    out.push_str(&super::units::section(&account.units));
    out.push_str(&repeat(derivation));
    out
}

/// Text of the file: formulas between dollar signs and code between backticks are kept, and what else Markdown would take
/// for markup is made harmless.
pub(super) fn prose(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut out = String::new();
    let mut rest = text.as_str();
    while let Some(c) = rest.chars().next() {
        let after = &rest[c.len_utf8()..];
        if let Some(end) = after.find(c).filter(|end| (c == '`' || c == '$') && *end > 0) {
            let inner = &after[..end];
            out.push_str(&if c == '$' { math(inner) } else { format!("`{}`", inner.replace('|', r"\|")) });
            rest = &after[end + 1..];
            continue;
        }
        match c {
            '<' => out.push_str("&lt;"),
            '*' | '|' | '`' | '#' | '[' | ']' | '$' => out.extend(['\\', c]),
            c => out.push(c),
        }
        rest = after;
    }
    out
}

/// A formula inside a line.
pub(super) fn math(formula: &str) -> String {
    let one_line = formula.split_whitespace().collect::<Vec<_>>().join(" ");
    // In a table a bar ends the cell, even inside a formula.
    format!("$`{}`$", one_line.replace('|', r"\vert ").replace('`', "'"))
}

/// A formula on its own lines.
fn display(formula: &str) -> String {
    let lines: Vec<&str> = formula.lines().map(str::trim).filter(|l| !l.is_empty()).collect();
    let body = lines.join("\n").replace('`', "'");
    let broken = body.contains(r"\cr") || body.contains(r"\\");
    if broken && !body.contains(r"\begin{") {
        let body = body.replace(r"\cr", r"\\");
        return format!("```math\n\\begin{{gathered}}\n{body}\n\\end{{gathered}}\n```\n\n");
    }
    format!("```math\n{body}\n```\n\n")
}

pub(super) fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut out = format!("| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
    for row in rows {
        out.push_str(&format!("| {} |\n", row.join(" | ")));
    }
    out.push('\n');
    out
}

/// A link target: the name of a claim as a forge makes an anchor of it is not the same everywhere, so it is given.
fn anchor(claim: &ClaimAccount) -> String {
    format!("claim-{}", name(claim).replace('/', "--"))
}

/// The summary in words.
fn findings(derivation: &Derivation, account: &Account) -> String {
    let s = account.summary();
    let mut out = String::from("## What was found\n\n");
    let claims = count(account.claims.len(), "claim");
    let trajectories = count(account.trajectories.len(), "trajectory");
    out.push_str(&format!(
        "{claims} (each reading counted) on {trajectories}. Of the verdicts, {} are that the claim holds, {} that it fails, \
         {} that it does not apply, {} are undecided. ",
        s.holds, s.fails, s.not_applicable, s.undecided
    ));
    out.push_str(&match s.unexpected {
        0 => "Every verdict is as the derivation file expects.\n\n".to_owned(),
        1 => "**One verdict is not as the derivation file expects.**\n\n".to_owned(),
        n => format!("**{n} verdicts are not as the derivation file expects.**\n\n"),
    });
    // What fails comes first: it is what a reader looks for.
    let order = [Standing::Fails, Standing::Mixed, Standing::Open, Standing::Nowhere, Standing::Holds];
    for standing in order {
        let found: Vec<&ClaimAccount> = account.claims.iter().filter(|c| Standing::of(c) == standing).collect();
        if found.is_empty() {
            continue;
        }
        out.push_str(&format!("**{} {}:**\n\n", count(found.len(), "claim"), standing.words(found.len())));
        for claim in found {
            let link = format!("[{}](#{})", name(claim), anchor(claim));
            let brief = super::conditions::in_brief(&claim.conditions).filter(|_| standing == Standing::Mixed);
            let brief = brief.map(|b| format!(" *Here it {b}.*")).unwrap_or_default();
            out.push_str(&format!("- {link}: {}{brief}\n", prose(&says(derivation, claim))));
        }
        out.push('\n');
    }
    out
}

fn matrix(account: &Account) -> String {
    let mut out = String::from("## Claims and trajectories\n\n");
    out.push_str(
        "H holds, h holds but weakly, F fails, – does not apply, ? undecided; **!** differs from what is expected. ",
    );
    out.push_str("The numbers are those of the [trajectories](#trajectories).\n\n");
    let numbers: Vec<String> = (1..=account.trajectories.len()).map(|n| n.to_string()).collect();
    let head: Vec<&str> = std::iter::once("claim").chain(numbers.iter().map(String::as_str)).collect();
    let cell = |pair: Option<&PairAccount>| match pair {
        None => String::new(),
        Some(pair) => {
            let glyph = if discrimination::is_weak(pair) { 'h' } else { glyph(pair.verdict.outcome()) };
            let glyph = glyph.to_string().replace('-', "–");
            if pair.is_unexpected() { format!("{glyph} **!**") } else { glyph }
        }
    };
    let row = |claim: &ClaimAccount| {
        let link = format!("[{}](#{})", name(claim), anchor(claim));
        let pair = |id: &str| claim.results.iter().find(|r| r.trajectory == id);
        std::iter::once(link).chain(account.trajectories.iter().map(|t| cell(pair(&t.id)))).collect()
    };
    out.push_str(&table(&head, account.claims.iter().map(row)));
    out
}

fn conventions(derivation: &Derivation) -> String {
    if derivation.conventions.is_empty() {
        return String::new();
    }
    let rows = derivation.conventions.iter().map(|(k, v)| vec![prose(k), prose(v)]);
    format!("## Conventions\n\n{}", table(&["convention", "as used here"], rows))
}

fn symbols(derivation: &Derivation) -> String {
    let rows = derivation.symbols.iter().map(|s| {
        let shape = derivation.graph.shape(s.symbol);
        let shape =
            if derivation.graph.is_diagonal(s.symbol) { format!("diagonal {shape}") } else { shape.to_string() };
        let mut notes: Vec<String> = s.says.iter().map(|t| prose(t)).collect();
        notes.extend(s.positive.then(|| "positive".to_owned()));
        notes.extend(s.angle.then(|| "angle, continued without jumps".to_owned()));
        let formula = s.formula.as_deref().map(math).unwrap_or_default();
        let unit = s.unit.as_deref().map(prose).unwrap_or_default();
        vec![math(&s.name), s.role_word().to_owned(), shape, unit, formula, notes.join("; ")]
    });
    format!("## Symbols\n\n{}", table(&["symbol", "role", "shape", "unit", "definition", "notes"], rows))
}

fn systems(derivation: &Derivation) -> String {
    let mut out = String::new();
    for system in &derivation.systems {
        let says = system.says.as_ref().map(|s| format!(": {}", prose(s))).unwrap_or_default();
        out.push_str(&format!("**{}**{says}\n\n", system.id));
        for equation in &system.equations {
            out.push_str(&display(&equation.text));
        }
    }
    if out.is_empty() { out } else { format!("## Systems\n\n{out}") }
}

fn trajectories(account: &Account) -> String {
    let mut out = String::from("## Trajectories\n\n");
    let rows = account.trajectories.iter().enumerate().map(|(i, t)| {
        let given: Vec<String> = t.given.iter().map(|(n, v)| format!("{} = {}", math(n), values(v))).collect();
        let steps = if t.steps > 0 { t.steps.to_string() } else { String::new() };
        vec![
            (i + 1).to_string(),
            format!("`{}`", t.id),
            if t.title == t.id { String::new() } else { prose(&t.title) },
            format!("{} … {}", time(t.span.0), time(t.span.1)),
            t.source.to_owned(),
            given.join(", "),
            steps,
            size(t.error),
        ]
    });
    let head = ["no.", "id", "title", "t", "source", "parameters and initial values", "steps", "error at most"];
    out.push_str(&table(&head, rows));
    for t in &account.trajectories {
        if let Some(problem) = &t.problem {
            out.push_str(&format!("`{}`: {}\n\n", t.id, prose(problem)));
        }
    }
    out
}

fn values(values: &[f64]) -> String {
    let all: Vec<String> = values.iter().map(|v| value(*v)).collect();
    if all.len() == 1 { all.concat() } else { format!("({})", all.join(", ")) }
}

fn claims(derivation: &Derivation, account: &Account, graph: &DerivationGraph) -> String {
    let mut out = String::from("## Claims\n\n");
    let mut last = "";
    for claim in &account.claims {
        let declared = declared(derivation, claim);
        let parent = declared.and_then(|d| d.parent_says.as_ref());
        if let Some(parent) = parent.filter(|_| last != claim.id) {
            out.push_str(&format!("### {}: {}\n\n", claim.id, prose(parent)));
        }
        last = &claim.id;
        let level = if claim.reading.is_some() { "####" } else { "###" };
        out.push_str(&format!("<a id=\"{}\"></a>\n\n", anchor(claim)));
        out.push_str(&format!("{level} {}: {}\n\n", name(claim), prose(&claim.says)));
        let mut notes: Vec<String> = claim.place.iter().map(|p| format!("Place: {}.", prose(p))).collect();
        if let Some(label) = declared.and_then(|d| d.label.as_ref()) {
            notes.push(format!("Label: `{label}`."));
        }
        if let Some(from) = declared.map(|d| &d.follows_from).filter(|f| !f.is_empty()) {
            notes.push(format!("Follows from: {}.", from.iter().map(|f| prose(f)).collect::<Vec<_>>().join(", ")));
        }
        if let Some(precision) = declared.map(|d| d.precision).filter(|p| *p != DEFAULT_PRECISION) {
            notes.push(format!("Precision asked for: {}.", size(precision)));
        }
        if !notes.is_empty() {
            out.push_str(&format!("{}\n\n", notes.join(" ")));
        }
        out.push_str(&formulas(derivation, claim));
        if !claim.assumptions.is_empty() {
            let all: Vec<String> = claim.assumptions.iter().map(|a| math(a)).collect();
            out.push_str(&format!("Assuming {}.\n\n", all.join(", ")));
        }
        if let Some(rests) = graph.rests_of(claim) {
            out.push_str(&rests_in_words(&rests, math));
        }
        if let Some(remark) = &claim.remark {
            out.push_str(&format!("> {}\n\n", prose(remark)));
        }
        if let Some(identity) = &claim.identity {
            out.push_str(&format!("**For all values:** {}\n\n", prose(&identity.sentence())));
            if identity.generic {
                out.push_str("The proof leaves out special cases of what is given; see the conditions.\n\n");
            }
            if !identity.conditions.is_empty() {
                let list: String = identity.conditions.iter().map(|c| format!("- `{c}`\n")).collect();
                out.push_str(&format!("<details><summary>Conditions</summary>\n\n{list}\n</details>\n\n"));
            }
            out.push_str(&certificate_note(claim, identity));
            if let Some(witness) = &identity.witness {
                out.push_str(&format!("<details><summary>Refuting point</summary>\n\n`{witness}`\n\n</details>\n\n"));
            }
        }
        out.push_str(&super::conditions::section(&claim.conditions));
        out.push_str(&discrimination::section(claim));
        let mut groups = groups(claim);
        groups.sort_by_key(|g| ["fails", "holds", "undecided"].iter().position(|w| *w == g.word).unwrap_or(3));
        for group in groups {
            out.push_str(&group_section(claim, &group, account.trajectories.len()));
        }
    }
    out
}

fn formulas(derivation: &Derivation, claim: &ClaimAccount) -> String {
    let mut out = String::new();
    let kinds: Vec<&str> =
        declared(derivation, claim).map(|d| d.formulas.iter().map(|f| f.kind.key()).collect()).unwrap_or_default();
    let mut last = "";
    for (i, formula) in claim.formulas.iter().enumerate() {
        let kind = kinds.get(i).copied().unwrap_or("always");
        let words = match kind {
            "always" => "At every time:",
            "never" => "At no time:",
            "eventually" => "At some time:",
            "first-integral" => "Constant along the motion:",
            "defined" => "Has a real value at every time:",
            "independent" => "Independent functions:",
            "solves" => {
                out.push_str(&format!("The motion solves the system `{formula}`.\n\n"));
                continue;
            }
            _ => {
                out.push_str(&format!("The motion is that of the trajectory `{formula}`.\n\n"));
                continue;
            }
        };
        if kind != last {
            out.push_str(&format!("{words}\n\n"));
        }
        last = kind;
        out.push_str(&display(formula));
    }
    out
}

/// The pairs of a claim with the same verdict: in one line, with the numbers folded away, and a witness.
fn group_section(claim: &ClaimAccount, group: &Group<'_>, of: usize) -> String {
    let names: Vec<String> = group.pairs.iter().map(|p| format!("`{}`", p.trajectory)).collect();
    let verdict = match group.word {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    };
    let on = if group.pairs.len() == claim.results.len() && names.len() > 3 {
        let all = count(names.len(), "trajectory");
        if names.len() < of { format!("on all {all} on which it is tried") } else { format!("on all {all}") }
    } else {
        format!("on {}", names.join(", "))
    };
    let expected = match (group.unexpected, group.expected) {
        (true, Some(word)) => format!(" — **expected: {word}**"),
        (true, None) => " — **not expected**".to_owned(),
        (false, _) => String::new(),
    };
    let mut out = format!("**{verdict}** {on}{expected}.\n\n");
    if let Some(telling) = group.telling().filter(|_| group.word == "fails") {
        out.push_str(&witness(telling));
    }
    out.push_str(&format!("<details><summary>{}</summary>\n\n", count(group.pairs.len(), "verdict")));
    let rows = group.pairs.iter().map(|p| {
        let evidence = p.verdict.evidence();
        let residual = evidence.residual.as_ref();
        vec![
            format!("`{}`", p.trajectory),
            p.verdict.outcome().strength().unwrap_or_default().to_owned(),
            residual.map(|r| size(r.max)).unwrap_or_default(),
            residual.map(|r| size(r.bound)).unwrap_or_default(),
            residual.map(|r| time(r.at)).unwrap_or_default(),
            if evidence.samples > 0 { evidence.samples.to_string() } else { String::new() },
            notes(p),
        ]
    });
    let head = ["trajectory", "strength", "largest residual", "its error bound", "at t", "samples", "notes"];
    out.push_str(&table(&head, rows));
    out.push_str("</details>\n\n");
    out
}

/// Reason, sign, and times left out.
fn notes(pair: &PairAccount) -> String {
    let evidence = pair.verdict.evidence();
    let mut all: Vec<String> = evidence.reason.iter().map(|r| prose(r)).collect();
    all.extend(discrimination::note(pair));
    all.extend(evidence.branch.iter().map(|b| format!("sign: {}", prose(b))));
    for e in &evidence.excluded {
        all.push(format!("left out {} … {}: {}", time(e.from), time(e.to), prose(&e.reason)));
    }
    all.join("; ")
}

fn witness(pair: &PairAccount) -> String {
    let Some(w) = &pair.verdict.evidence().witness else { return String::new() };
    let mut out = format!("Witness: `{}` at t = {}, {}.\n\n", pair.trajectory, value(w.t), math(&w.formula));
    let sides = [("left side", w.left), ("right side", w.right)];
    let mut rows: Vec<Vec<String>> = sides.iter().map(|(n, v)| vec![(*n).to_owned(), value(*v)]).collect();
    rows.push(vec!["error bound of the difference".to_owned(), size(w.bound)]);
    rows.extend(w.values.iter().map(|(n, v)| vec![math(n), value(*v)]));
    out.push_str(&table(&["quantity", "value"], rows));
    out
}

fn measures(derivation: &Derivation, account: &Account) -> String {
    let mut out = String::new();
    for measure in &derivation.measures {
        out.push_str(&format!("**{}**: {}, {}", measure.id, prose(&measure.says), math(&measure.formula.text)));
        if let Some(at) = &measure.at {
            out.push_str(&format!(" where {}", math(&at.text)));
        }
        out.push_str(&measure.unit.as_ref().map(|u| format!(", in {}", prose(u))).unwrap_or_default());
        out.push_str(".\n\n");
        let found = account.measurements.iter().filter(|m| m.measure == measure.id);
        let rows = found.flat_map(|m| {
            let name = format!("`{}`", m.trajectory);
            let mut rows: Vec<Vec<String>> = m
                .values
                .iter()
                .map(|(t, v, b)| vec![name.clone(), time(*t), value(*v), size(*b), String::new()])
                .collect();
            if let Some(reason) = &m.reason {
                rows.push(vec![name, String::new(), String::new(), String::new(), prose(reason)]);
            }
            rows
        });
        out.push_str(&table(&["trajectory", "t", "value", "error bound", "notes"], rows));
    }
    if out.is_empty() { out } else { format!("## Measured\n\n{out}") }
}

/// What is needed to repeat the report.
fn repeat(derivation: &Derivation) -> String {
    let path = project_path(&derivation.file.path);
    format!(
        "## How to repeat this\n\n\
         - {} {}\n\
         - derivation file `{path}`, SHA-256 `{}`\n\
         - command `rederive check {path}`\n\
         - precision asked for, unless a claim says otherwise: {}\n\n\
         A residual, left side minus right side, is compared with its own error bound, which is propagated from the error of \
         the trajectory and from rounding. A bound that is larger than the precision asked for leaves the claim undecided.\n",
        env!("CARGO_PKG_NAME"),
        env!("CARGO_PKG_VERSION"),
        derivation.sha256,
        size(DEFAULT_PRECISION),
    )
}

/// The path as the project sees it; nothing outside the project is named.
fn project_path(path: &str) -> String {
    let path = path.replace('\\', "/");
    let path = path.trim_start_matches("./");
    let outside = path.starts_with('/') || path.split('/').any(|p| p == ".." || p.ends_with(':'));
    if outside { path.rsplit('/').next().unwrap_or_default().to_owned() } else { path.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use crate::check::sample;

    #[test]
    fn the_report_of_a_small_account() {
        insta::assert_snapshot!(markdown(&derivation(), &sample::account()));
    }

    #[test]
    fn no_path_outside_the_project() {
        assert_eq!(project_path("derivations/a.toml"), "derivations/a.toml");
        assert_eq!(project_path("./derivations/a.toml"), "derivations/a.toml");
        assert_eq!(project_path("/home/someone/a.toml"), "a.toml");
        assert_eq!(project_path("../other/a.toml"), "a.toml");
        assert_eq!(project_path("C:\\Users\\a.toml"), "a.toml");
    }

    #[test]
    fn formulas_survive_markdown() {
        assert_eq!(math("|x|_1"), r"$`\vert x\vert _1`$");
        assert_eq!(prose("`a|b` and $x|y$, <b>*"), r"`a\|b` and $`x\vert y`$, &lt;b>\*");
        assert_eq!(prose("costs 3$ or `"), r"costs 3\$ or \`");
        assert!(display("a=b \\cr c=d").contains("\\begin{gathered}\na=b \\\\ c=d\n"));
    }
}
