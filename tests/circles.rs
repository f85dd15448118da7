//! Files of a crate that import one another in a circle are few: what is in a circle can only be understood as a whole.
//!
//! Who imports whom is read from paths in the code; a name that a module imports itself is followed to the file that defines it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::layering::{CRATES, code_only, rust_files};

/// Most files in a circle.
const MOST: usize = 5;

/// Rooms whose files are more entangled than that, and by how much at most: each is to be parted. In the checker a draft calls the rules, which make
/// facts of it.
const ENTANGLED: &[(&str, usize)] = &[("checker", 18), ("paper", 10), ("proved", 7)];

/// A module: its names from the root of the crate.
type Module = Vec<String>;

/// A path as it is written, without what it is renamed to, and the name that it gets in its module.
type Written = (Vec<String>, String);

/// What a file names.
#[derive(Default)]
struct Names {
    /// Names that are imported into the module, with the paths that they stand for.
    imported: BTreeMap<String, Vec<String>>,
    /// All paths, of imports and elsewhere.
    paths: Vec<Vec<String>>,
}

fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The paths of `a::{b, c::{d as e, self}, *}` from position `at`.
fn tree(code: &[char], at: &mut usize, prefix: &[String], out: &mut Vec<Written>) {
    let mut path = prefix.to_vec();
    let skip = |at: &mut usize| {
        while code.get(*at).is_some_and(|c| c.is_whitespace()) {
            *at += 1
        }
    };
    let word = |at: &mut usize| {
        let start = *at;
        while code.get(*at).is_some_and(|c| is_name(*c)) {
            *at += 1;
        }
        code[start..*at].iter().collect::<String>()
    };
    loop {
        skip(at);
        match code.get(*at) {
            Some('{') => {
                *at += 1;
                loop {
                    skip(at);
                    match code.get(*at) {
                        Some('}') | None => break,
                        Some(',') => *at += 1,
                        Some(_) => {
                            let before = *at;
                            tree(code, at, &path, out);
                            *at += usize::from(*at == before);
                        }
                    }
                }
                *at += 1;
                return;
            }
            Some(c) if is_name(*c) => path.push(word(at)),
            // A glob, or the end.
            _ => {
                out.push((path, "*".to_owned()));
                return;
            }
        }
        let end = *at;
        skip(at);
        if code.get(*at) == Some(&':') && code.get(*at + 1) == Some(&':') {
            *at += 2;
            continue;
        }
        let mut name = path.last().cloned().unwrap_or_default();
        if name == "self" && path.len() > 1 {
            path.pop();
            name = path.last().cloned().unwrap_or_default();
        }
        let renamed = code[*at..].starts_with(&['a', 's', ' ']) && *at > end;
        if renamed {
            *at += 3;
            skip(at);
            name = word(at);
        } else {
            *at = end;
        }
        out.push((path, name));
        return;
    }
}

/// What the code of a file names; what is compiled for tests alone does not count.
fn names(text: &str) -> Names {
    let code = code_only(text);
    let tests = ["#[cfg(test)]\nmod tests {", "#[cfg(all(test, debug_assertions))]\nmod tests {"];
    let end = tests.iter().filter_map(|begin| code.find(begin)).min().unwrap_or(code.len());
    let code: Vec<char> = code[..end].chars().collect();
    let mut out = Names::default();
    let mut at = 0;
    while at < code.len() {
        let begins = at == 0 || !(is_name(code[at - 1]) || code[at - 1] == ':');
        let word: String = code[at..].iter().take_while(|c| is_name(**c)).collect();
        if begins && word == "use" {
            // What is only passed on to others is not needed here.
            let before: String = code[at.saturating_sub(12)..at].iter().collect();
            let is_passed_on = before.trim_end().ends_with("pub");
            at += 4;
            let outside = code.get(at) == Some(&':');
            at += if outside { 2 } else { 0 };
            let mut found = Vec::new();
            tree(&code, &mut at, &[], &mut found);
            for (path, name) in found {
                // Other crates: nothing of this one.
                let path = if outside { vec!["::".to_owned()] } else { path };
                if !is_passed_on {
                    out.paths.push(path.clone());
                }
                out.imported.insert(name, path);
            }
        } else if begins && word.starts_with(|c: char| c.is_lowercase()) {
            // A path: from here, or by way of a module inside.
            let start = at;
            let mut found = Vec::new();
            tree(&code, &mut at, &[], &mut found);
            out.paths.extend(found.into_iter().map(|(path, _)| path).filter(|p| p.len() > 1));
            at = at.max(start + word.chars().count());
        } else {
            at += word.chars().count().max(1);
        }
    }
    out
}

/// The module that a path of a module leads to, as far as it leads to one of this crate.
fn resolve(files: &BTreeMap<Module, Names>, from: &Module, path: &[String], depth: usize) -> Option<Module> {
    let mut at: Module = match path.first()?.as_str() {
        "crate" => Vec::new(),
        "super" => from[..from.len().checked_sub(1)?].to_vec(),
        "self" => from.clone(),
        first => {
            let mut child = from.clone();
            child.push(first.to_owned());
            if files.contains_key(&child) {
                child
            } else {
                let path = files
                    .get(from)?
                    .imported
                    .get(first)
                    .filter(|p| depth > 0 && p.first().is_some_and(|f| f != first))?;
                resolve(files, from, path, depth - 1)?
            }
        }
    };
    for (i, name) in path.iter().enumerate().skip(1) {
        if name == "super" {
            at.pop()?;
            continue;
        }
        let mut child = at.clone();
        child.push(name.clone());
        if files.contains_key(&child) {
            at = child;
            continue;
        }
        let Some(means) = files.get(&at)?.imported.get(name).filter(|_| depth > 0) else { break };
        if means.first().is_some_and(|first| first == "::") {
            return None;
        }
        let rest: Vec<String> = means.iter().chain(&path[i + 1..]).cloned().collect();
        return resolve(files, &at, &rest, depth - 1);
    }
    Some(at)
}

/// The circles of a crate, each sorted, the largest first.
fn circles(files: &BTreeMap<Module, Names>) -> Vec<Vec<&Module>> {
    let all: Vec<&Module> = files.keys().collect();
    let place: BTreeMap<&Module, usize> = all.iter().enumerate().map(|(i, m)| (*m, i)).collect();
    let mut reach = vec![vec![false; all.len()]; all.len()];
    for (i, module) in all.iter().enumerate() {
        for path in &files[*module].paths {
            if let Some(k) = resolve(files, module, path, 8).and_then(|m| place.get(&m).copied()) {
                reach[i][k] = true;
            }
        }
    }
    for k in 0..all.len() {
        let through = reach[k].clone();
        for row in reach.iter_mut().filter(|row| row[k]) {
            row.iter_mut().zip(&through).for_each(|(r, t)| *r |= *t);
        }
    }
    let mut seen = BTreeSet::new();
    let mut out = Vec::new();
    for (i, from) in reach.iter().enumerate() {
        let circle: Vec<usize> = (0..all.len()).filter(|&k| k == i || from[k] && reach[k][i]).collect();
        if circle.len() > 1 && seen.insert(circle.clone()) {
            out.push(circle.into_iter().map(|k| all[k]).collect::<Vec<_>>());
        }
    }
    out.sort_by_key(|c| std::cmp::Reverse(c.len()));
    out
}

fn modules(folder: &Path) -> BTreeMap<Module, Names> {
    let mut found = Vec::new();
    rust_files(folder, &mut found);
    // What is a crate of its own is none of this one's.
    let crates: Vec<_> = CRATES.iter().map(|(name, _)| folder.join(name)).collect();
    found.retain(|file| !crates.iter().any(|inner| file.starts_with(inner)));
    let mut out = BTreeMap::new();
    for file in found {
        let inside = file.strip_prefix(folder).expect("a file of the folder").with_extension("");
        let mut module: Module = inside.components().map(|c| c.as_os_str().to_string_lossy().into_owned()).collect();
        if module.last().is_some_and(|m| m == "mod") || module == ["lib"] {
            module.pop();
        }
        let is_test = module.last().is_some_and(|m| m == "tests" || m.ends_with("_tests"));
        if !is_test {
            out.insert(module, names(&fs::read_to_string(&file).expect("a source file can be read")));
        }
    }
    out
}

#[test]
fn circles_are_small() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut wrong = Vec::new();
    // The crate of the library and the command line has the files that are left.
    let facade = modules(&src);
    assert!(facade.contains_key(&vec!["cli".to_owned(), "check".to_owned()]), "the command line was not looked at");
    let crates = CRATES.iter().map(|(name, _)| (*name, modules(&src.join(name))));
    for (name, files) in crates.chain([("cli", facade)]) {
        let found = circles(&files);
        let largest = found.first().map_or(0, Vec::len);
        let most = ENTANGLED.iter().find(|(of, _)| *of == name).map_or(MOST, |(_, most)| *most);
        if largest > most {
            let shown: Vec<String> = found[0].iter().map(|m| m.join("::")).collect();
            wrong.push(format!("src/{name}: {largest} files import one another: {}", shown.join(", ")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_circle_is_found() {
    let file = |module: &[&str], text: &str| (module.iter().map(|m| (*m).to_owned()).collect::<Module>(), names(text));
    // a takes from b what that has from c; c names a in an expression, by way of the root.
    let files = BTreeMap::from([
        file(&[], "mod a; mod b; mod c; pub use a::A; use ::{number, expr as e}; pub struct Own;"),
        file(&["a"], "use super::b::{C as D}; use crate::number::N;"),
        file(&["b"], "pub use super::c::{self, C};"),
        file(&["c"], "fn f() -> u8 { crate::A::new(crate::Own) }"),
        file(&["d"], "use super::{a, b}; // use crate::d; \n#[cfg(test)]\nmod tests { use crate::d; }"),
        // A command that is run by its room, and imports from it.
        file(&["room"], "mod command; fn f() { command::run(other::x, 0.5) }"),
        file(&["room", "command"], "use super::Ending;"),
    ]);
    let found = circles(&files);
    let module = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect::<Module>();
    let expected = [[module(&["a"]), module(&["c"])], [module(&["room"]), module(&["room", "command"])]];
    assert_eq!(found, expected.each_ref().map(|circle| circle.each_ref().to_vec()));
}
