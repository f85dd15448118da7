//! The text of a draft.
//!
//! **In:** the formulas, and what the file declares. **Out:** TOML. **Guaranteed:** every formula is in it, and where it stands is noted.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::super::Paper;
use super::formula::{Formula, Printed};
use super::guess::{Guess, Reading};
use super::settle::Settled;
use super::spelling::quoted;
use super::system::System;

/// Ids of claims: labels, where there are.
#[derive(Default)]
pub(super) struct Ids {
    taken: BTreeSet<String>,
    /// For a label that occurs often, the number that is tried next.
    next: BTreeMap<String, usize>,
}

impl Ids {
    /// The id for a label, or for the display of a number.
    pub fn next(&mut self, label: Option<&str>, number: usize) -> String {
        let base = label.map_or_else(|| format!("equation-{number}"), id_of);
        let mut id = base.clone();
        let n = self.next.entry(base.clone()).or_insert(2);
        while !self.taken.insert(id.clone()) {
            id = format!("{base}-{n}");
            *n += 1;
        }
        id
    }
}

/// A label as an id: `eq:motion` becomes `eq-motion`.
fn id_of(label: &str) -> String {
    let kept: String =
        label.chars().map(|c| if c.is_ascii_alphanumeric() || "._".contains(c) { c } else { '-' }).collect();
    let kept: String = kept.trim_start_matches(|c: char| !c.is_ascii_alphanumeric()).chars().take(80).collect();
    if kept.is_empty() { "equation".to_owned() } else { kept }
}

/// A text in a comment of one line.
fn comment(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

pub(super) fn formula(text: &str) -> String {
    match text {
        // Three quotes would end there.
        _ if text.contains("'''") || text.ends_with('\'') || text.contains(char::is_control) => quoted(text),
        _ if text.contains('\'') => format!("'''{text}'''"),
        _ => format!("'{text}'"),
    }
}

const TIME: &str = "'t' = { role = \"time\" } # confirm: the usual name\n";

/// A file with one formula.
pub(super) fn single(text: &str, reading: &Reading) -> String {
    let mut out = String::from("[derivation]\ntitle = \"one\"\nconcerns = \"one\"\n");
    if reading.is_complex || reading.has_logarithm {
        out.push_str("[conventions]\n");
    }
    if reading.is_complex {
        out.push_str("i = \"imaginary unit\"\n");
    }
    if reading.has_logarithm {
        out.push_str("log = \"natural\"\n");
    }
    out.push_str("[symbols]\n");
    out.push_str(TIME);
    for guess in &reading.symbols {
        let _ = writeln!(out, "{}", guess.line());
    }
    let _ = writeln!(out, "[[claim]]\nid = \"one\"\nsays = \"one\"\npostulate = true\nalways = [{}]", formula(text));
    out
}

/// What stands at the head of a draft.
pub(super) struct Head<'a> {
    /// The paper.
    pub paper: &'a Paper,
    /// What its file is called.
    pub name: &'a str,
}

/// The text of the draft; notes where the formulas stand.
pub(super) fn written(head: &Head<'_>, settled: &Settled, all: &mut [Printed], system: Option<&System>) -> String {
    let Head { paper, name } = head;
    let title = paper.title.clone().unwrap_or_else(|| format!("The derivations of {name}"));
    let mut out = String::from("#:schema derivation.schema.json\n");
    out.push_str("# (for an editor: `rederive schema derivation > derivation.schema.json` beside this file)\n");
    let _ = writeln!(out, "# A draft, made from {}. What is marked `confirm` is a guess.", comment(name));
    out.push_str(
        "# Nothing in it is decided until what is guessed is confirmed.\n\
         # Every key is described in docs/derivation-file.md of rederive.\n\n[derivation]\n",
    );
    let _ = writeln!(out, "title = {}", quoted(&title));
    let _ = writeln!(out, "concerns = {} # confirm: the citation", quoted(&title));
    let needs = |what: fn(&Reading) -> bool| {
        all.iter().flat_map(|p| &p.formulas).any(|f| f.refused.is_none() && what(&f.needs))
    };
    let (is_complex, has_logarithm) = (needs(|r| r.is_complex), needs(|r| r.has_logarithm));
    if is_complex || has_logarithm {
        out.push_str("\n[conventions]\n");
    }
    if is_complex {
        out.push_str("i = \"imaginary unit\" # confirm: it stands in exponents, or before ħ\n");
    }
    if has_logarithm {
        out.push_str("log = \"natural\" # confirm: the paper prints no \\ln, or \\log(10)\n");
    }
    out.push_str("\n[symbols]\n# confirm: each role and shape is guessed from how the paper prints the symbol.\n");
    out.push_str(
        "# Roles: time, state, parameter, observable, abbreviation; the last two have a formula of their own.\n",
    );
    out.push_str(TIME);
    for guess in settled.symbols.iter() {
        let _ = writeln!(out, "{}", guess.line());
    }
    for clash in &settled.clashes {
        let _ = writeln!(out, "# confirm: not declared for all, {}", comment(clash));
    }
    let states: Vec<String> = settled.symbols.iter().filter(|s| s.role == "state").map(|s| formula(&s.name)).collect();
    if let Some(system) = system {
        out.push_str(&system.text());
        for printed in all {
            claims(&mut out, name, (settled, Some(system)), printed);
        }
        return out;
    }
    let _ = write!(
        out,
        "\n# confirm: name a system, with the equations that move the states, and take the marks of comments away.\n\
         # [system.motion]\n# states = [{}]\n# equations = ['…']\n\n\
         # [[trajectory]]\n# id = \"first\"\n# system = \"motion\"\n# parameters = {{ }}\n# initial = {{ }}\n# span = [0, 10]\n",
        states.join(", ")
    );
    for printed in all {
        claims(&mut out, name, (settled, None), printed);
    }
    out
}

/// The claims of what is printed under one number: formulas that need the same symbols stand in one.
fn claims(out: &mut String, name: &str, (settled, system): (&Settled, Option<&System>), printed: &mut Printed) {
    let _ = writeln!(out, "\n# line {} of {}", printed.line, comment(printed.file.as_deref().unwrap_or(name)));
    for remark in &printed.remarks {
        let _ = writeln!(out, "# printed beside it: {}", comment(remark));
    }
    for expression in &printed.expressions {
        let _ = writeln!(out, "# relates nothing:\n#   {}", comment(expression));
    }
    for f in printed.formulas.iter().filter(|f| f.refused.is_some()) {
        let why = f.refused.as_deref().unwrap_or_default();
        let condition = if f.is_condition { "a condition, " } else { "" };
        let _ = writeln!(out, "# confirm: not read, {condition}{}:\n#   {}", comment(why), comment(&f.text));
    }
    for f in printed.formulas.iter().filter(|f| f.refused.is_none()) {
        if let Some((what, text)) = &f.printed {
            let _ = writeln!(out, "# confirm: {what}; printed:\n#   {}", comment(text));
        }
    }
    let mut groups: Vec<(Vec<Guess>, Vec<usize>)> = Vec::new();
    let mut group_of: BTreeMap<Vec<Guess>, usize> = BTreeMap::new();
    let mut of_all: Vec<Guess> = Vec::new();
    // A number of a condition is what its formula is a function of.
    let read = || printed.formulas.iter().filter(|f| printed.is_case && f.refused.is_none());
    let of_the_file = |name: &str| {
        let mut known = read().flat_map(|f| &f.needs.symbols).filter(|g| settled.symbols.contains(g));
        known.any(|g| g.bare() == name && g.shape.is_none())
    };
    let is_number = |g: &Guess| g.role == "parameter" && g.shape.is_none();
    for f in read() {
        let is_shared = |g: &Guess| f.is_condition && is_number(g) && of_the_file(g.bare());
        let own = settled.own_symbols(f).into_iter().filter(|g| !of_all.contains(g) && !is_shared(g));
        of_all.extend(own.collect::<Vec<_>>());
    }
    for (i, f) in printed.formulas.iter().enumerate().filter(|(_, f)| f.refused.is_none()) {
        let own = if printed.is_case { of_all.clone() } else { settled.own_symbols(f) };
        match group_of.get(&own) {
            Some(&group) => groups[group].1.push(i),
            None => {
                group_of.insert(own.clone(), groups.len());
                groups.push((own, vec![i]));
            }
        }
    }
    for (number, (symbols, formulas)) in groups.into_iter().enumerate() {
        let id = if number == 0 { printed.id.clone() } else { format!("{}.{}", printed.id, number + 1) };
        let _ = writeln!(out, "[[claim]]\nid = {}", quoted(&id));
        if let Some(label) = &printed.label {
            let _ = writeln!(out, "label = {}", quoted(label));
        }
        out.push_str("says = \"confirm: what this equation says\"\n");
        // Nothing is known yet of what it follows from: taken as it is, until somebody says so.
        out.push_str("postulate = true\n");
        // What the motion has no values of is not tried on it; what is said of fields is tried on none anyway.
        let all = || formulas.iter().flat_map(|&i| &printed.formulas[i].needs.symbols).collect::<Vec<_>>();
        let is_of_fields = all().iter().any(|g| matches!(g.role, "field" | "coordinate"));
        if !is_of_fields && system.is_some_and(|s| !symbols.is_empty() || !s.has(&all())) {
            out.push_str("trajectories = []\n");
        }
        for condition in [true, false] {
            let these: Vec<usize> =
                formulas.iter().copied().filter(|&i| printed.formulas[i].is_condition == condition).collect();
            if condition && these.is_empty() {
                continue;
            }
            out.push_str(if condition && these.len() < formulas.len() { "assuming = [\n" } else { "always = [\n" });
            place(out, &mut printed.formulas, &these);
            out.push_str("]\n");
            if condition && these.len() == formulas.len() {
                break;
            }
        }
        let start = out.len();
        if !symbols.is_empty() {
            out.push_str("[claim.symbols]\n");
            for guess in &symbols {
                let _ = writeln!(out, "{}", guess.line());
            }
        }
        for i in formulas {
            printed.formulas[i].symbols = start..out.len();
        }
    }
}

/// Writes formulas, and notes where.
fn place(out: &mut String, formulas: &mut [Formula], these: &[usize]) {
    for &i in these {
        let start = out.len();
        let _ = writeln!(out, "  {},", formula(&formulas[i].text));
        formulas[i].place = start..out.len();
    }
}

/// The guesses of a draft, a line each.
pub(super) fn guesses(text: &str) -> Vec<String> {
    let (mut out, mut told_already) = (Vec::new(), BTreeSet::new());
    for line in text.lines().filter(|l| l.contains("{ role = \"")) {
        let Some((name, rest)) = line.split_once(" = { role = ") else { continue };
        let (what, why) = rest.split_once(" } # confirm: ").unwrap_or((rest, ""));
        let told = format!("{}: {}: {why}", name.trim_matches(['\'', '"']), what.replace('"', ""));
        if told_already.insert(told.clone()) {
            out.push(told);
        }
    }
    out
}
