//! The page on the formula language is right: its examples, and those of `tests/reference/grammar.md`, mean what they say, its tables are
//! complete.

use std::collections::BTreeSet;

use crate::latex_support::{World, shown};
use rederive::expr::Op;
use rederive::latex::{RelationKind, Role};

fn read(file: &str) -> String {
    let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn page() -> String {
    read("docs/grammar.md")
}

/// Lines of the code blocks of one kind, with their line numbers.
fn blocks(page: &str, kind: &str) -> Vec<(usize, String)> {
    let mut inside = false;
    let mut out = Vec::new();
    for (number, line) in page.lines().enumerate() {
        if line.starts_with("```") {
            inside = line == format!("```{kind}");
        } else if inside {
            out.push((number + 1, line.to_owned()));
        }
    }
    out
}

/// The symbols of a block.
fn world(symbols: &[(usize, String)]) -> World {
    let mut w = World::empty();
    for (number, line) in symbols {
        let (keys, rest) = match line.split_once("  ") {
            Some(parts) => parts,
            // A key as wide as the column.
            None => line.rsplit_once(' ').unwrap_or_else(|| panic!("line {number}")),
        };
        let (rest, of) = match rest.split_once(" momentum of ") {
            Some((rest, of)) => (rest, Some(of)),
            None => (rest, None),
        };
        let (rest, velocity) = match rest.strip_suffix(" velocity") {
            Some(rest) => (rest, true),
            None => (rest, false),
        };
        let (role, more) = rest.trim().split_once(' ').unwrap_or((rest.trim(), ""));
        for key in keys.split(", ") {
            let role = match role {
                "time" => Role::Time,
                "parameter" => Role::Parameter,
                "state" => Role::State,
                "observable" => Role::Observable,
                "coordinate" => Role::Coordinate,
                "field" => Role::Field,
                _ => Role::Abbreviation,
            };
            let by_formula = matches!(role, Role::Field | Role::Coordinate | Role::Observable)
                && !matches!(more, "" | "3" | "complex");
            if role == Role::Abbreviation || by_formula {
                let arguments: &[&str] = if key.contains(r"(\alpha)") { &[r"\alpha"] } else { &[] };
                w.define(key, role, more, arguments);
            } else {
                w = w.with(key, role, more);
            }
            if let (true, Some(field)) = (velocity, w.scope.symbol(key)) {
                w.scope.set_velocity(key, field).unwrap_or_else(|e| panic!("line {number}: {e:?}"));
            }
            if let (Some(of), Some(momentum)) = (of, w.scope.symbol(key)) {
                w.scope.set_momentum(&w.graph, momentum, of).unwrap_or_else(|e| panic!("line {number}: {e:?}"));
            }
        }
    }
    w
}

fn sign(kind: RelationKind) -> &'static str {
    match kind {
        RelationKind::Equal => "=",
        RelationKind::NotEqual => r"\ne",
        RelationKind::Less => "<",
        RelationKind::LessEqual => r"\le",
        RelationKind::Greater => ">",
        RelationKind::GreaterEqual => r"\ge",
    }
}

/// What a text stands for: the components of an expression, or the first component of each relation.
fn meaning(w: &mut World, text: &str) -> Result<String, Vec<rederive::diag::Problem>> {
    let problems = match w.try_read(text) {
        Ok(statements) => {
            let relations = statements.iter().flat_map(|s| &s.relations);
            let lines: Vec<String> = relations
                .map(|r| {
                    let (left, right) = (r.left.components[0], r.right.components[0]);
                    format!("{} {} {}", w.graph.to_latex(left), sign(r.kind), w.graph.to_latex(right))
                })
                .collect();
            return Ok(lines.join("; "));
        }
        Err(problems) => problems,
    };
    // Only a text that is nothing but an expression is read as one.
    if problems.len() > 1 || problems[0].code != "latex::not-a-relation" {
        return Err(problems);
    }
    let t = match w.try_expression(text) {
        Err(p) if p[0].code == "latex::not-an-expression" => return Err(problems),
        other => other?,
    };
    let parts: Vec<String> = t.components.iter().map(|&e| w.graph.to_latex(e)).collect();
    Ok(parts.join(", "))
}

#[test]
fn examples_mean_what_the_page_says() {
    let (meanings, refusals) = examples_of(&page());
    assert!(meanings > 60 && refusals > 50, "{meanings} meanings, {refusals} refusals");
}

#[test]
fn further_examples_mean_what_is_said_of_them() {
    let (meanings, refusals) = examples_of(&read("tests/reference/grammar.md"));
    assert!(meanings > 60 && refusals > 50, "{meanings} meanings, {refusals} refusals");
}

/// How many examples show a meaning, and how many a refusal. All of them are so.
fn examples_of(page: &str) -> (usize, usize) {
    // The examples use the symbols of the last list before them.
    let symbols = blocks(page, "symbols");
    let lists: Vec<&[(usize, String)]> = symbols.chunk_by(|a, b| a.0 + 1 == b.0).collect();
    let worlds: Vec<(usize, World)> = lists.into_iter().map(|list| (list[0].0, world(list))).collect();
    let (mut meanings, mut refusals) = (0, 0);
    let mut wrong = String::new();
    for (number, line) in blocks(page, "examples") {
        let before = worlds.iter().rfind(|(at, _)| *at < number);
        let mut w = before.unwrap_or_else(|| panic!("line {number}: no symbols")).1.clone();
        if let Some((text, wanted)) = line.split_once(" ⇒ ") {
            meanings += 1;
            match meaning(&mut w, text) {
                Ok(got) if got == wanted => {}
                Ok(got) => wrong.push_str(&format!("line {number}: `{text}` means\n  {got}\n")),
                Err(p) => wrong.push_str(&format!("line {number}: {}", shown(text, &p))),
            }
        } else if let Some((text, code)) = line.split_once(" ✗ ") {
            refusals += 1;
            match meaning(&mut w, text) {
                Ok(got) => wrong.push_str(&format!("line {number}: `{text}` is read as {got}\n")),
                Err(p) if p[0].code == code => {}
                Err(p) => wrong.push_str(&format!("line {number}: {}", shown(text, &p))),
            }
        } else {
            wrong.push_str(&format!("line {number}: `{line}` is no example\n"));
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    (meanings, refusals)
}

#[test]
fn the_table_of_operations_is_that_of_the_program() {
    let page = page();
    let mut rows: Vec<String> = Vec::new();
    for op in Op::ALL {
        rows.push(rederive::expr::domain::line(*op));
    }
    let section = page.split("## Operations").nth(1).and_then(|s| s.split("##").next()).unwrap_or("");
    let found: Vec<&str> = section.lines().filter(|l| l.starts_with("| `")).collect();
    assert_eq!(found, rows, "write:\n{}", rows.join("\n"));
}

#[test]
fn every_code_is_described() {
    let page = page();
    let mut in_source = BTreeSet::new();
    let mut folders = vec![std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src/latex")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("the room can be listed") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("a source file can be read");
            for (at, _) in text.match_indices("\"latex::") {
                in_source.insert(text[at + 1..].split('"').next().unwrap_or("").to_owned());
            }
        }
    }
    let section = page.split("## Codes").nth(1).unwrap_or("");
    let described: BTreeSet<String> =
        section.lines().filter_map(|l| l.strip_prefix("| `")?.split('`').next()).map(str::to_owned).collect();
    assert_eq!(described, in_source);
}
