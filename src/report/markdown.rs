//! `report.md`: the report for people, as a forge renders it.

use super::discrimination;
use super::graph::DerivationGraph;
use super::mathml;
use super::numbers::{count, size, time, value};
use super::tally::{Group, declared, glyph, groups, name};
use crate::check::{Account, ClaimAccount, PairAccount};
use crate::derivation::{ClaimRole, DEFAULT_PRECISION, Derivation};
use crate::latex::printed;

/// The report.
pub fn markdown(derivation: &Derivation, account: &Account) -> String {
    let mut out = format!("# {}\n\n", prose(&derivation.title));
    out.push_str(&format!("What is checked: {}\n\n", prose(&derivation.concerns)));
    if let Some(source) = &derivation.source {
        out.push_str(&format!("{}\n\n", prose(source)));
    }
    out.push_str("Pictures, curves and every pair: `index.html`. All numbers: `report.json`.\n\n");
    out.push_str(&super::overview::section(derivation, account));
    out.push_str(&matrix(account));
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
            out.push_str(&if c == '$' {
                written_math(inner)
            } else {
                code(&printed(inner).unwrap_or_else(|| inner.to_owned()))
            });
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

/// A formula in a text. What a forge could do more with than set it is shown as it is written.
fn written_math(formula: &str) -> String {
    let formula = printed(formula).unwrap_or_else(|| formula.to_owned());
    let mut commands = formula.split('\\').skip(1).map(|rest| {
        let name = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        &rest[..name]
    });
    let harmless = |name: &str| name.is_empty() || mathml::letter(name).is_some() || SET_ONLY.contains(&name);
    if commands.all(harmless) && !formula.contains('%') { math(&formula) } else { code(&formula) }
}

/// Commands of LaTeX, beside those of letters, that set something and do nothing else.
const SET_ONLY: &[&str] = &[
    "arccos",
    "arcsin",
    "arctan",
    "array",
    "bar",
    "bf",
    "big",
    "Big",
    "boldsymbol",
    "cal",
    "cdot",
    "cdots",
    "circ",
    "cos",
    "cosh",
    "cot",
    "coth",
    "cr",
    "ddot",
    "dddot",
    "det",
    "dfrac",
    "displaystyle",
    "div",
    "dot",
    "dots",
    "ell",
    "equiv",
    "exists",
    "exp",
    "forall",
    "frac",
    "ge",
    "geq",
    "gg",
    "hat",
    "in",
    "infty",
    "int",
    "it",
    "langle",
    "ldots",
    "le",
    "left",
    "leq",
    "lim",
    "limits",
    "ln",
    "log",
    "lvert",
    "mathbb",
    "mathbf",
    "mathcal",
    "mathrm",
    "mathsf",
    "max",
    "min",
    "mp",
    "nabla",
    "ne",
    "neq",
    "not",
    "operatorname",
    "partial",
    "perp",
    "pm",
    "prime",
    "prod",
    "propto",
    "qquad",
    "quad",
    "rangle",
    "right",
    "rightarrow",
    "rm",
    "rvert",
    "sf",
    "sim",
    "simeq",
    "sin",
    "sinh",
    "sqrt",
    "sum",
    "tan",
    "tanh",
    "text",
    "textstyle",
    "tfrac",
    "tilde",
    "times",
    "to",
    "top",
    "Rightarrow",
    "vec",
    "vert",
    "wedge",
    "approx",
];

/// A text as it is written.
pub(super) fn code(text: &str) -> String {
    format!("`{}`", text.replace('|', r"\|").replace('`', "'"))
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
    let body = lines.join("\n");
    let broken = body.contains(r"\cr") || body.contains(r"\\");
    if broken && !body.contains(r"\begin{") {
        let body = body.replace(r"\cr", r"\\");
        return fenced("math", &format!("\\begin{{gathered}}\n{body}\n\\end{{gathered}}"));
    }
    fenced("math", &body)
}

/// Text between fences that are longer than any that it has.
pub(super) fn fenced(kind: &str, body: &str) -> String {
    let mut longest = 0;
    let mut run = 0;
    for c in body.chars() {
        run = if c == '`' { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    let fence = "`".repeat(3.max(longest + 1));
    format!("{fence}{kind}\n{body}\n{fence}\n\n")
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
fn anchor(name: &str) -> String {
    format!("claim-{}", name.replace('/', "--"))
}

/// A link to the section on a claim.
pub(super) fn link_to(name: &str) -> String {
    format!("[{name}](#{})", anchor(name))
}

/// Something that is unfolded on request.
fn folded(summary: &str, body: &str) -> String {
    if body.is_empty() {
        String::new()
    } else {
        format!("<details><summary>{summary}</summary>\n\n{body}</details>\n\n")
    }
}

/// One letter for each pair: the whole matrix in a few kilobytes.
fn matrix(account: &Account) -> String {
    // What is about ranges has no cells.
    let rows: Vec<&ClaimAccount> = account.claims.iter().filter(|c| c.region.is_none()).collect();
    if rows.is_empty() {
        return String::new();
    }
    let cell = |claim: &ClaimAccount, id: &str| match claim.results.iter().find(|r| r.trajectory == id) {
        None => ' ',
        Some(pair) if pair.is_unexpected() => '!',
        Some(pair) if discrimination::is_weak(pair) => 'h',
        Some(pair) => glyph(pair.verdict.outcome()),
    };
    let names: Vec<String> = rows.iter().map(|c| name(c)).collect();
    let wide = names.iter().map(|n| n.chars().count()).max().unwrap_or(0);
    let mut body = String::new();
    let numbers: Vec<String> = (1..=account.trajectories.len()).map(|n| n.to_string()).collect();
    let digits = numbers.last().map_or(1, String::len);
    for digit in 0..digits {
        let at = |n: &String| format!("{n:>digits$}").chars().nth(digit).unwrap_or(' ');
        body.push_str(&format!("{:wide$}  {}\n", "", numbers.iter().map(at).collect::<String>()));
    }
    for (claim, name) in rows.iter().zip(&names) {
        let cells: String = account.trajectories.iter().map(|t| cell(claim, &t.id)).collect();
        body.push_str(format!("{name:wide$}  {cells}").trim_end());
        body.push('\n');
    }
    format!(
        "## Claims and trajectories\n\nH holds, h holds but weakly, F fails, - does not apply, ? undecided; ! differs from \
         what is expected. Columns are the [trajectories](#trajectories) by number.\n\n{}",
        fenced("text", body.trim_end())
    )
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
    let number = count(derivation.symbols.len(), "symbol");
    let table = table(&["symbol", "role", "shape", "unit", "definition", "notes"], rows);
    format!("## Symbols\n\n{}", folded(&number, &table))
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
        let steps = if t.steps > 0 { t.steps.to_string() } else { String::new() };
        vec![
            (i + 1).to_string(),
            format!("`{}`", t.id),
            if t.title == t.id { String::new() } else { prose(&t.title) },
            format!("{} … {}", time(t.span.0), time(t.span.1)),
            t.source.to_owned(),
            steps,
            size(t.error),
        ]
    });
    let head = ["no.", "id", "title", "t", "source", "steps", "error at most"];
    let summary = count(account.trajectories.len(), "trajectory");
    out.push_str(&folded(&summary, &table(&head, rows)));
    out.push_str("Parameters and initial values are in the derivation file and in `report.json`.\n\n");
    for t in &account.trajectories {
        if let Some(problem) = &t.problem {
            out.push_str(&format!("`{}`: {}\n\n", t.id, prose(problem)));
        }
    }
    out
}

fn claims(derivation: &Derivation, account: &Account, graph: &DerivationGraph) -> String {
    let mut out = String::from("## Claims\n\n");
    let mut last = "";
    for claim in &account.claims {
        let declared = declared(derivation, claim);
        let parent = declared.and_then(|d| d.parent_says.as_ref());
        if let Some(parent) = parent.filter(|_| last != claim.id) {
            out.push_str(&format!("<a id=\"{}\"></a>\n\n### {}: {}\n\n", anchor(&claim.id), claim.id, prose(parent)));
        }
        last = &claim.id;
        let level = if claim.reading.is_some() { "####" } else { "###" };
        out.push_str(&format!("<a id=\"{}\"></a>\n\n", anchor(&name(claim))));
        out.push_str(&format!("{level} {}: {}\n\n", name(claim), prose(&claim.says)));
        let mut notes: Vec<String> = claim.place.iter().map(|p| format!("Place: {}.", prose(p))).collect();
        notes.extend(declared.and_then(|d| whose(d.role)).map(str::to_owned));
        if let Some(label) = declared.and_then(|d| d.label.as_ref()) {
            notes.push(format!("Label: {}.", prose(label)));
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
        if let Some(identity) = &claim.identity {
            let certificate = super::certificates::file_name(claim).map(|f| format!(" [Certificate]({f})."));
            let sentence = prose(&super::graph::brief(identity, &graph.proof_of(claim)));
            out.push_str(&format!("**For all values:** {sentence}{}\n\n", certificate.unwrap_or_default()));
        }
        out.push_str(&super::region::section(claim));
        out.push_str(&super::conditions::separation(&claim.conditions));
        let mut groups = groups(claim);
        groups.sort_by_key(|g| ["fails", "holds", "undecided"].iter().position(|w| *w == g.word).unwrap_or(3));
        for group in groups {
            out.push_str(&group_section(claim, &group, account.trajectories.len()));
        }
        if let Some(erratum) = claim.variants.as_ref().and_then(|v| v.erratum.as_ref()) {
            out.push_str(&discrimination::corrections_markdown(erratum));
        }
    }
    out
}

/// What a claim is to the paper, where the paper does not simply say it.
pub(super) fn whose(role: ClaimRole) -> Option<&'static str> {
    match role {
        ClaimRole::Says => None,
        ClaimRole::MayMean => Some("One of several things that the sentence may mean."),
        ClaimRole::Needs => Some("The paper needs it; it is more, or other, than it says."),
        ClaimRole::Against => Some("Against the sentence: the contrary of what the paper says."),
        ClaimRole::Added => Some("For comparison: the paper does not say it."),
        ClaimRole::Lemma => Some("A lemma of the file, which proofs use: the paper does not print it."),
        ClaimRole::Choice => Some("A choice of the paper: neither true nor false."),
    }
}

fn formulas(derivation: &Derivation, claim: &ClaimAccount) -> String {
    let mut out = String::new();
    let kinds: Vec<&str> =
        declared(derivation, claim).map(|d| d.formulas.iter().map(|f| f.kind.key()).collect()).unwrap_or_default();
    let mut last = "";
    for (i, formula) in claim.formulas.iter().enumerate() {
        let kind = kinds.get(i).copied().unwrap_or("always");
        let over = declared(derivation, claim).and_then(|d| Some((d.formulas.get(i)?.kind, claim.region.as_ref()?)));
        let over = over.map(|(kind, region)| prose(&format!("{}:", super::region::heading(kind, region))));
        let words = match kind {
            _ if over.is_some() => over.as_deref().unwrap_or_default(),
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

/// Most trajectories that are named beside a verdict that is as expected.
const NAMED: usize = 3;

/// The pairs of a claim with the same verdict, in one line: where, the largest residual, and a witness or a reason.
fn group_section(claim: &ClaimAccount, group: &Group<'_>, of: usize) -> String {
    let names: Vec<String> = group.pairs.iter().map(|p| format!("`{}`", p.trajectory)).collect();
    let verdict = match group.word {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    };
    let shown = if names.len() > NAMED + 1 && !group.unexpected { NAMED } else { names.len() };
    let on = if group.pairs.len() == claim.results.len() && names.len() > 3 {
        let all = count(names.len(), "trajectory");
        if names.len() < of { format!("on all {all} on which it is tried") } else { format!("on all {all}") }
    } else if shown < names.len() {
        format!("on {}: {} and {} more", names.len(), names[..shown].join(", "), names.len() - shown)
    } else {
        format!("on {}", names.join(", "))
    };
    let expected = match (group.unexpected, group.expected) {
        (true, Some(word)) => format!(" — **expected: {word}**"),
        (true, None) => " — **not expected**".to_owned(),
        (false, _) => String::new(),
    };
    let mut out = format!("**{verdict}** {on}{expected}.");
    if let Some(pair) = group.telling() {
        out.push_str(&match group.word {
            "fails" => witness(pair),
            "not-applicable" if !group.unexpected => String::new(),
            word => told(pair, word == "holds"),
        });
    }
    out.push_str("\n\n");
    out
}

/// The pair that tells most of those that do not fail.
fn told(pair: &PairAccount, holds: bool) -> String {
    let evidence = pair.verdict.evidence();
    let mut out = String::new();
    if let Some(r) = evidence.residual.as_ref().filter(|_| holds) {
        out.push_str(&format!(
            " Largest residual {}, error bound {}, on `{}` at t = {} ({}, {}).",
            size(r.max),
            size(r.bound),
            pair.trajectory,
            time(r.at),
            pair.verdict.outcome().strength().unwrap_or_default(),
            count(evidence.samples, "sample"),
        ));
    }
    if let Some(reason) = evidence.reason.as_ref().filter(|_| !holds) {
        out.push_str(&format!(" On `{}`: {}.", pair.trajectory, prose(reason)));
    }
    if let Some(e) = evidence.excluded.first() {
        out.push_str(&format!(
            " Left out on `{}`: {} … {}, {}",
            pair.trajectory,
            time(e.from),
            time(e.to),
            prose(&e.reason)
        ));
        out.push_str(if evidence.excluded.len() > 1 { ", and more." } else { "." });
    }
    out
}

/// A refuting point: both sides in a line, and what they depend on.
fn witness(pair: &PairAccount) -> String {
    let Some(w) = &pair.verdict.evidence().witness else { return String::new() };
    let mut out = format!(
        " On `{}` at t = {}: {} has the left side **{}**, the right side **{}**, and the error bound {}.",
        pair.trajectory,
        value(w.t),
        math(&w.formula),
        value(w.left),
        value(w.right),
        size(w.bound)
    );
    // Values that would fill a page are in `report.json`, to be recomputed.
    if (1..=FEW).contains(&w.values.len()) {
        let values: Vec<String> = w.values.iter().map(|(n, v)| format!("{} = {}", math(n), value(*v))).collect();
        out.push_str(&format!(" There {}.", values.join(", ")));
    }
    out
}

/// So many values of a witness are written out.
const FEW: usize = 3;

/// Most trajectories of which a measure is written.
const MEASURED: usize = 8;
/// Most values of a measure that are written for a trajectory.
const VALUES_SHOWN: usize = 1;

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
        let rows = found.map(|m| {
            let shown = m.values.iter().take(VALUES_SHOWN);
            let mut cells: Vec<String> =
                shown.map(|(t, v, b)| format!("{} ± {} (t = {})", time(*v), size(*b), time(*t))).collect();
            let more = m.values.len().saturating_sub(VALUES_SHOWN);
            cells.extend((more > 0).then(|| format!("{more} more")));
            cells.extend(m.reason.iter().map(|r| prose(r)));
            vec![format!("`{}`", m.trajectory), cells.join("; ")]
        });
        let mut rows: Vec<Vec<String>> = rows.collect();
        let summary = format!("Values on {}", count(rows.len(), "trajectory"));
        let more = rows.len().saturating_sub(MEASURED);
        rows.truncate(MEASURED);
        rows.extend((more > 0).then(|| vec![format!("and {more} more"), "in report.json".to_owned()]));
        out.push_str(&folded(&summary, &table(&["trajectory", "value ± error bound (time)"], rows)));
    }
    if out.is_empty() { out } else { format!("## Measured\n\n{out}") }
}

/// What is needed to repeat the report.
fn repeat(derivation: &Derivation) -> String {
    let path = super::front::project_path(&derivation.file.path);
    format!(
        "## How to repeat this\n\n\
         - {} {}\n\
         - derivation file `{path}`, SHA-256 `{}`\n\
         - command `rederive check {path}`\n\
         - precision asked for, unless a claim says otherwise: {}\n\n\
         A residual, left side minus right side, is compared with its own error bound, which is propagated from the error of \
         the trajectory and from rounding. A bound that is larger than the precision asked for leaves the claim undecided.\n",
        crate::PROGRAM,
        env!("CARGO_PKG_VERSION"),
        derivation.sha256,
        size(DEFAULT_PRECISION),
    )
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use crate::check::sample;

    #[test]
    fn the_report_of_a_small_account() {
        insta::assert_snapshot!(markdown(&derivation(), &sample::account()));
    }

    #[test]
    fn formulas_survive_markdown() {
        assert_eq!(math("|x|_1"), r"$`\vert x\vert _1`$");
        assert_eq!(prose("`a|b` and $x|y$, <b>*"), r"`a\|b` and $`x\vert y`$, &lt;b>\*");
        assert_eq!(prose("costs 3$ or `"), r"costs 3\$ or \`");
        assert_eq!(fenced("", "a```b"), "````\na```b\n````\n\n");
        assert!(display("a=b \\cr c=d").contains("\\begin{gathered}\na=b \\\\ c=d\n"));
    }
}
