//! A first derivation file from a paper: what can be copied is copied, what is guessed is marked.
//!
//! The draft is loaded again and again while it is made. A symbol that is missing is guessed from how it is used; a formula
//! that cannot be read stands in a comment, with the reason. What is returned loads. It decides nothing, since it has no
//! motions: every guess waits for a person.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::ops::Range;

use super::Paper;
use super::mark::{Mark, marks};
use super::names::{Call, Evidence, PaperName, names_of};
use super::token::tokens;
use derivation::parse;
use diag::{Diagnostic, Source};

/// The draft of a derivation file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draft {
    /// Its text.
    pub text: String,
    /// How many equations the paper displays.
    pub equations: usize,
    /// How many formulas it has.
    pub formulas: usize,
    /// How many more stand in comments, because they cannot be read.
    pub refused: usize,
    /// How many symbols were guessed.
    pub symbols: usize,
}

impl Draft {
    /// How much was found, and what is to be done with it.
    pub fn summary(&self) -> String {
        let Draft { equations, formulas, refused, symbols, .. } = self;
        format!(
            "{equations} equations, {formulas} formulas, {refused} more that cannot be read yet, {symbols} symbols guessed\n\
             Look for `confirm` in it; then add a system and a motion."
        )
    }
}

/// The most rounds of loading: each takes back a guess, or puts formulas into comments.
const MOST_ROUNDS: usize = 2000;
/// The most names of a formula.
const MOST_NAMES: usize = 120;

/// A formula of the draft.
struct Formula {
    text: String,
    /// Why it stands in a comment.
    refused: Option<String>,
    /// Its place in the text of the last round.
    place: Range<usize>,
    /// The guesses that it needs.
    needs: Vec<Guess>,
}

struct Claim {
    id: String,
    label: Option<String>,
    line: usize,
    formulas: Vec<Formula>,
}

/// A guessed symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Guess {
    name: String,
    role: &'static str,
    shape: Option<&'static str>,
    why: &'static str,
}

impl Guess {
    /// The name as a key of the file.
    fn key(&self) -> String {
        if self.name.contains('\'') { quoted(&self.name) } else { format!("'{}'", self.name) }
    }
}

/// A derivation file for a paper, to be confirmed and completed. `name` is what the paper's file is called in it.
///
/// Every formula is read by itself first, with the guesses that it needs; then all together. A guess that clashes with another is
/// taken back, and said: no formula is lost because of one that does not need it.
pub fn draft(paper: &Paper, name: &str) -> Draft {
    let mut claims = claims(paper);
    let all: Vec<Mark> =
        paper.equations.iter().flat_map(|e| &e.parts).chain(&paper.relations).flat_map(|p| plain(&p.text)).collect();
    let time = Guess { name: "t".into(), role: "time", shape: None, why: "the usual name" };
    let mut symbols = vec![time.clone()];
    let evidence = Evidence::of(paper);
    for claim in &mut claims {
        for formula in claim.formulas.iter_mut().filter(|f| f.refused.is_none()) {
            alone(formula, (paper, &evidence), name, &time, &all);
            for guess in &formula.needs {
                if !symbols.contains(guess) {
                    symbols.push(guess.clone());
                }
            }
        }
    }
    let mut clashes = settled(&mut symbols, &mut claims);
    for _ in 0..MOST_ROUNDS {
        let text = written(paper, name, &symbols, &clashes, &mut claims);
        let source = Source { path: "draft.toml".to_owned(), text };
        let Err(found) = parse(source, "draft") else { break };
        if !taken_back(&found, &mut symbols, &mut clashes, &mut claims) {
            // A problem that belongs to no formula and to no guess: nothing is kept that could be wrong.
            claims.iter_mut().flat_map(|c| &mut c.formulas).for_each(|f| {
                f.refused.get_or_insert_with(|| "the file could not be loaded with it".to_owned());
            });
            symbols.truncate(1);
        }
    }
    let text = written(paper, name, &symbols, &clashes, &mut claims);
    let formulas = || claims.iter().flat_map(|c| &c.formulas);
    Draft {
        text,
        equations: paper.equations.len(),
        formulas: formulas().filter(|f| f.refused.is_none()).count(),
        refused: formulas().filter(|f| f.refused.is_some()).count(),
        symbols: symbols.len(),
    }
}

/// Reads a formula by itself: what it needs, or why it is refused.
fn alone(formula: &mut Formula, (paper, evidence): (&Paper, &Evidence), name: &str, time: &Guess, all: &[Mark]) {
    let own = Formula { text: formula.text.clone(), refused: None, place: 0..0, needs: Vec::new() };
    let mut claims = [Claim { id: "one".to_owned(), label: None, line: 1, formulas: vec![own] }];
    // As the names are printed, labels among them.
    let named = guesses(&formula.text, evidence);
    if !named.is_empty() {
        let symbols: Vec<Guess> = std::iter::once(time.clone()).chain(named.iter().cloned()).collect();
        let text = written(paper, name, &symbols, &[], &mut claims);
        if parse(Source { path: "draft.toml".to_owned(), text }, "draft").is_ok() {
            formula.needs = named;
            return;
        }
    }
    let mut symbols = vec![time.clone()];
    for _ in 0..MOST_NAMES {
        let text = written(paper, name, &symbols, &[], &mut claims);
        let source = Source { path: "draft.toml".to_owned(), text };
        let Err(found) = parse(source, "draft") else { break };
        if !repair(&found, &mut symbols, &mut claims, all) {
            claims[0].formulas[0].refused.get_or_insert_with(|| "what it needs cannot be declared".to_owned());
        }
        if claims[0].formulas[0].refused.is_some() {
            break;
        }
    }
    formula.refused = claims[0].formulas[0].refused.take();
    if formula.refused.is_none() {
        formula.needs = symbols.split_off(1);
    }
}

/// Of guesses on one name the one that most formulas need is kept; formulas that need another are refused. What was taken back.
fn settled(symbols: &mut Vec<Guess>, claims: &mut [Claim]) -> Vec<String> {
    let mut wanted: BTreeMap<&str, Vec<(Guess, usize)>> = BTreeMap::new();
    let needs = |claims: &[Claim], guess: &Guess| {
        claims.iter().flat_map(|c| &c.formulas).filter(|f| f.needs.contains(guess)).count()
    };
    for guess in symbols.iter() {
        wanted.entry(&guess.name).or_default().push((guess.clone(), needs(claims, guess)));
    }
    let mut lost: Vec<Guess> = Vec::new();
    for guesses in wanted.values().filter(|g| g.len() > 1) {
        // The first of those that are needed most.
        let most = guesses.iter().map(|g| g.1).max().unwrap_or(0);
        let kept = guesses.iter().position(|g| g.1 == most).unwrap_or(0);
        lost.extend(guesses.iter().enumerate().filter(|(i, _)| *i != kept).map(|(_, g)| g.0.clone()));
    }
    let clashes =
        lost.iter().map(|g| take_back(g, "another guess on this name is needed by more formulas", claims)).collect();
    symbols.retain(|s| !lost.contains(s));
    clashes
}

/// Refuses the formulas that need a guess; what is said of it.
fn take_back(guess: &Guess, why: &str, claims: &mut [Claim]) -> String {
    for formula in claims.iter_mut().flat_map(|c| &mut c.formulas).filter(|f| f.needs.contains(guess)) {
        formula.refused.get_or_insert_with(|| format!("`{}` cannot be declared as it needs it: {why}", guess.name));
    }
    let shape = guess.shape.map(|s| format!(", shape {s}")).unwrap_or_default();
    format!("{}: {}{shape}: {why}", guess.name, guess.role)
}

/// Takes back what the whole file cannot have: the guess, or the formula, at which a problem stands. Whether there was any.
fn taken_back(found: &[Diagnostic], symbols: &mut Vec<Guess>, clashes: &mut Vec<String>, claims: &mut [Claim]) -> bool {
    let mut done = false;
    for problem in found {
        let Some(span) = problem.place.as_ref().map(|l| l.span.clone()) else { continue };
        let here = |f: &&mut Formula| f.refused.is_none() && f.place.start <= span.start && span.start <= f.place.end;
        if let Some(formula) = claims.iter_mut().flat_map(|c| &mut c.formulas).find(here) {
            formula.refused = Some(format!("beside the other names: {}", problem.message));
            done = true;
            continue;
        }
        let line = problem.source.text.get(..span.start).map_or(0, |t| t.matches('\n').count());
        let text = problem.source.text.lines().nth(line).unwrap_or_default();
        if let Some(at) = symbols.iter().skip(1).position(|s| text.starts_with(&s.key())) {
            let guess = symbols.remove(at + 1);
            clashes.push(take_back(&guess, &problem.message, claims));
            done = true;
            // Other places may mean other things now.
            break;
        }
    }
    done
}

/// Commands that choose a style: a symbol in bold is the vector of which the plain letter has the components.
const STYLES: &[&str] = &["bf", "mathbf", "boldsymbol", "bm", "vec", "pmb"];

/// The marks of a formula without styles.
fn plain(text: &str) -> Vec<Mark> {
    let kept: Vec<_> = tokens(text).into_iter().filter(|t| !STYLES.iter().any(|s| t.is(s))).collect();
    marks(&kept)
}

fn claims(paper: &Paper) -> Vec<Claim> {
    let mut taken = BTreeSet::new();
    // For a label that occurs often, the number that is tried next.
    let mut next: BTreeMap<String, usize> = BTreeMap::new();
    let mut out = Vec::new();
    for (i, equation) in paper.equations.iter().enumerate() {
        let line = paper.line(&equation.span);
        let base = equation.label.as_ref().map_or_else(|| format!("equation-{}", i + 1), |l| id_of(l));
        let mut id = base.clone();
        let n = next.entry(base.clone()).or_insert(2);
        while !taken.insert(id.clone()) {
            id = format!("{base}-{n}");
            *n += 1;
        }
        let formula = |text: &str| {
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            let refused = None;
            Formula { text, refused, place: 0..0, needs: Vec::new() }
        };
        let formulas = equation.parts.iter().map(|p| formula(&p.text)).collect();
        out.push(Claim { id, label: equation.label.clone(), line, formulas });
    }
    out
}

/// A label as an id: `eq:motion` becomes `eq-motion`.
fn id_of(label: &str) -> String {
    let kept: String =
        label.chars().map(|c| if c.is_ascii_alphanumeric() || "._".contains(c) { c } else { '-' }).collect();
    let kept: String = kept.trim_start_matches(|c: char| !c.is_ascii_alphanumeric()).chars().take(80).collect();
    if kept.is_empty() { "equation".to_owned() } else { kept }
}

/// Declares what is missing, or puts formulas into comments; whether anything was done.
fn repair(found: &[Diagnostic], symbols: &mut Vec<Guess>, claims: &mut [Claim], all: &[Mark]) -> bool {
    let mut done = false;
    let before = symbols.len();
    let mut refuse = Vec::new();
    // Letters that are declared in this round: they may be missing at many places.
    let mut declared: BTreeSet<&str> = BTreeSet::new();
    for problem in found {
        let Some(span) = problem.place.as_ref().map(|l| l.span.clone()) else { continue };
        let missing = problem.code == "latex::unknown-symbol" && problem.message.ends_with("is not declared");
        let name = problem.message.split('`').nth(1).filter(|_| missing).map(without_subscript);
        if name.is_some_and(|name| declared.contains(name)) {
            continue;
        }
        let here = |f: &Formula| f.refused.is_none() && f.place.start <= span.start && span.start <= f.place.end;
        let at = claims.iter().enumerate().find_map(|(c, claim)| Some((c, claim.formulas.iter().position(here)?)));
        let Some((c, f)) = at else { continue };
        let text = &problem.source.text;
        let (at, after) = (text.get(span.clone()).unwrap_or_default(), text.get(span.end..).unwrap_or_default());
        let guess = match name {
            Some(name) => Some(guess(name, at, after, all)),
            // The letter is known, but not with this subscript.
            None => with_subscript(at, after),
        };
        let base = |name: &str| {
            let letters: Vec<String> = plain(name).into_iter().map(|m| m.text).collect();
            letters
        };
        match guess {
            Some(guess) if !symbols.iter().any(|s| s.name == guess.name) => {
                // A letter in bold may be found once the plain one is there: one of a kind in each round.
                if !symbols[before..].iter().any(|s| base(&s.name) == base(&guess.name)) {
                    symbols.push(guess);
                }
                declared.extend(name);
                done = true;
            }
            Some(_) if done && missing => {}
            _ => refuse.push((c, f, problem.message.clone())),
        }
    }
    // A formula is given up only when no symbol is missing any more: a new one may change what is wrong with it.
    if !done {
        for (c, f, why) in refuse {
            claims[c].formulas[f].refused.get_or_insert(why);
            done = true;
        }
    }
    done
}

/// A name without what is behind its first `_`, but one in braces: what stands there may be an index.
fn without_subscript(name: &str) -> &str {
    let mut depth = 0;
    let subscript = name.bytes().position(|c| {
        depth += i32::from(c == b'{') - i32::from(c == b'}');
        c == b'_' && depth == 0
    });
    &name[..subscript.unwrap_or(name.len())]
}

/// What the names of a formula may be, from what the whole paper shows; nothing where that is not enough.
fn guesses(text: &str, evidence: &Evidence) -> Vec<Guess> {
    let all = names_of(&tokens(text));
    let other = |n: &PaperName| n.derived_by.as_deref().is_some_and(|by| by != "t") && !n.is_partial;
    if all.iter().any(|n| n.has_hat || n.is_difference || other(n)) {
        return Vec::new();
    }
    let mut coordinates: BTreeSet<&str> = BTreeSet::new();
    for name in all.iter().filter(|n| n.is_partial) {
        coordinates.extend(name.derived_by.as_deref());
    }
    let mut out: Vec<Guess> = Vec::new();
    for name in &all {
        let key = name.key();
        let is_e = name.letter == "e" && name.base != "e";
        if key == "t" || is_e || key == r"\pi" {
            continue;
        }
        let guess = match coordinates.contains(key.as_str()) {
            true => Guess { name: key, role: "coordinate", shape: None, why: "the paper derives by it" },
            false => named(name, key, &all, evidence),
        };
        if !out.iter().any(|g| g.name == guess.name) {
            out.push(guess);
        }
    }
    // Fields stand behind their coordinates.
    out.sort_by_key(|g| (g.role == "field", g.role != "coordinate"));
    out
}

/// What one name may be.
fn named(name: &PaperName, key: String, all: &[PaperName], evidence: &Evidence) -> Guess {
    let by: BTreeSet<&str> = evidence.partial.get(&key).into_iter().flatten().map(String::as_str).collect();
    if !by.is_empty() && all.iter().any(|n| n.is_partial) {
        let places: Vec<&str> = by.into_iter().collect();
        let shape = name.is_bold.then_some("3");
        return Guess {
            name: format!("{key}({})", places.join(",")),
            role: "field",
            shape,
            why: "the paper derives it partially",
        };
    }
    let moves = evidence.moving.contains(&key)
        || evidence.calls.get(&key).is_some_and(|c| c.contains_key(&Some(vec!["t".to_owned()])));
    let (role, why) = match moves {
        true => ("state", "the paper prints its rate"),
        false => ("parameter", "the paper prints no rate of it"),
    };
    if evidence.has_indices(&name.letter) && !name.is_bold {
        let two = evidence.subscripts.get(&name.letter).is_some_and(|s| s.iter().any(|s| s.chars().count() == 2));
        let shape = if two { Some("3x3") } else { Some("3") };
        return Guess { name: name.base.clone(), role, shape, why };
    }
    let why = if name.subscript.is_some() && !moves { "a subscript that is no index" } else { why };
    let place = match &name.call {
        Call::Places(places) if !moves && places.iter().any(|p| !p.chars().all(|c| c.is_ascii_digit())) => {
            format!("({})", places.join(","))
        }
        _ => String::new(),
    };
    Guess { name: format!("{key}{place}"), role, shape: name.is_bold.then_some("3"), why }
}

/// What a symbol may be, from how the paper uses it; `at` is where it is missed, `after` what follows.
fn guess(name: &str, at: &str, after: &str, all: &[Mark]) -> Guess {
    let base = plain(name);
    let base: Vec<&str> = base.iter().map(|m| m.text.as_str()).collect();
    let is_bold = base.len() < marks(&tokens(name)).iter().filter(|m| m.text != "{" && m.text != "}").count();
    let subscripts = subscripts(&base, all);
    let index = |s: &&String| s.chars().all(|c| "ijklmnpqrs123".contains(c)) && (1..=2).contains(&s.chars().count());
    let indices: Vec<&String> = subscripts.iter().filter(index).collect();
    let letter = indices.iter().any(|s| s.chars().any(|c| "ijklmnpqrs".contains(c)));
    // Digits beside each other, `N_1` and `N_2`, are several numbers, unless the letter has an index or is in bold somewhere.
    let indexed = letter || indices.len() > 1 && is_bold;
    let counts: Vec<usize> = indices.iter().map(|s| s.chars().count()).collect();
    let shape = match counts.iter().max() {
        // With one index and with two: principal values of a matrix.
        Some(2) if indexed && counts.contains(&1) => Some("diagonal 3"),
        Some(2) if indexed => Some("3x3"),
        Some(1) if indexed => Some("3"),
        _ if is_bold => Some("3"),
        _ => None,
    };
    if shape.is_none()
        && let Some(guess) = with_subscript(at, after)
    {
        return guess;
    }
    let moving = ["\\dot", "\\ddot"].iter().any(|dot| {
        let named = |w: &[Mark]| w[1..].iter().map(|m| m.text.as_str()).eq(base.iter().copied());
        all.windows(base.len() + 1).any(|w| w[0].text == *dot && named(w))
    });
    let (role, why) = match moving {
        true => ("state", "the paper prints its rate"),
        false => ("parameter", "the paper prints no rate of it"),
    };
    Guess { name: name.to_owned(), role, shape, why }
}

/// A symbol whose subscript is part of its name: where one is missed, or right after.
fn with_subscript(at: &str, after: &str) -> Option<Guess> {
    let text = match at.contains('_') {
        true => at.to_owned(),
        false => format!("{at}_{}", first_unit(after.trim_start().strip_prefix('_')?)?),
    };
    let (letter, rest) = text.split_once('_')?;
    let letter = letter.trim().trim_start_matches(r"\dot").trim_start_matches(r"\ddot").trim();
    let subscript = first_unit(rest)?;
    // A single letter may be an index over components: to take it for a name would be a misreading.
    let index = subscript.trim_matches(['{', '}']).chars().all(|c| "ijklmnpqrs,".contains(c));
    let one = marks(&tokens(letter)).len() == 1 && !index && !subscript.contains(['\\', '(']);
    let name = format!("{letter}_{subscript}");
    one.then_some(Guess { name, role: "parameter", shape: None, why: "a subscript that is no index" })
}

/// The subscripts with which a name is used, without braces.
fn subscripts(base: &[&str], all: &[Mark]) -> Vec<String> {
    let mut out = Vec::new();
    for (i, w) in all.windows(base.len() + 1).enumerate() {
        let named = w[..base.len()].iter().map(|m| m.text.as_str()).eq(base.iter().copied());
        if !named || w[base.len()].text != "_" {
            continue;
        }
        let rest = &all[i + base.len() + 1..];
        let text: String = match rest.first().map(|m| m.text.as_str()) {
            Some("{") => rest[1..].iter().map(|m| m.text.as_str()).take_while(|t| *t != "}").collect(),
            Some(one) => one.to_owned(),
            None => continue,
        };
        if !out.contains(&text) {
            out.push(text);
        }
    }
    out
}

/// The first letter, command or group of a text.
fn first_unit(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let end = match text.chars().next()? {
        '{' => text.find('}')? + 1,
        '\\' => 1 + text[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len() - 1),
        c => c.len_utf8(),
    };
    text.get(..end)
}

/// A text in double quotes.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A text in a comment of one line.
fn comment(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

fn formula(text: &str) -> String {
    match text {
        // Three quotes would end there.
        _ if text.contains("'''") || text.ends_with('\'') || text.contains(char::is_control) => quoted(text),
        _ if text.contains('\'') => format!("'''{text}'''"),
        _ => format!("'{text}'"),
    }
}

/// The text of the draft; notes where the formulas stand.
fn written(paper: &Paper, name: &str, symbols: &[Guess], clashes: &[String], claims: &mut [Claim]) -> String {
    let title = paper.title.clone().unwrap_or_else(|| format!("The derivations of {name}"));
    let mut out = String::new();
    let _ = writeln!(out, "# A draft, made from {}. What is marked `confirm` is a guess.", comment(name));
    out.push_str(
        "# It decides nothing until it has motions: see [[trajectory]] below.\n\
         # Every key is described in docs/derivation-file.md of rederive.\n\n[derivation]\n",
    );
    let _ = writeln!(out, "title = {}", quoted(&title));
    let _ = writeln!(out, "concerns = {} # confirm: the citation", quoted(&title));
    out.push_str("\n[symbols]\n# confirm: each role and shape is guessed from how the paper prints the symbol.\n");
    out.push_str(
        "# Roles: time, state, parameter, observable, abbreviation; the last two have a formula of their own.\n",
    );
    for guess in symbols {
        let shape = guess.shape.map(|s| format!(", shape = {}", quoted(s))).unwrap_or_default();
        let key = guess.key();
        let _ = writeln!(out, "{key} = {{ role = {}{shape} }} # confirm: {}", quoted(guess.role), guess.why);
    }
    for clash in clashes {
        let _ = writeln!(out, "# confirm: not declared, {}", comment(clash));
    }
    let states: Vec<String> = symbols.iter().filter(|s| s.role == "state").map(|s| formula(&s.name)).collect();
    let _ = write!(
        out,
        "\n# confirm: name a system, with the equations that move the states, and take the marks of comments away.\n\
         # [system.motion]\n# states = [{}]\n# equations = ['…']\n\n\
         # [[trajectory]]\n# id = \"first\"\n# system = \"motion\"\n# parameters = {{ }}\n# initial = {{ }}\n# span = [0, 10]\n",
        states.join(", ")
    );
    for claim in claims {
        let _ = writeln!(out, "\n# line {} of {}", claim.line, comment(name));
        for f in claim.formulas.iter().filter(|f| f.refused.is_some()) {
            let why = f.refused.as_deref().unwrap_or_default();
            let _ = writeln!(out, "# confirm: not read, {}:\n#   {}", comment(why), comment(&f.text));
        }
        let hash = if claim.formulas.iter().all(|f| f.refused.is_some()) { "# " } else { "" };
        let _ = writeln!(out, "{hash}[[claim]]\n{hash}id = {}", quoted(&claim.id));
        if let Some(label) = &claim.label {
            let _ = writeln!(out, "{hash}label = {}", quoted(label));
        }
        let _ = writeln!(out, "{hash}says = \"confirm: what this equation says\"");
        // Nothing is known yet of what it follows from: taken as it is, until somebody says so.
        let _ = writeln!(out, "{hash}postulate = true");
        let _ = writeln!(out, "{hash}always = [");
        for f in claim.formulas.iter_mut().filter(|f| f.refused.is_none()) {
            let start = out.len();
            let _ = writeln!(out, "  {},", formula(&f.text));
            f.place = start..out.len();
        }
        let _ = writeln!(out, "{hash}]");
    }
    out
}
