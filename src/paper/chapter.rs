//! Chapters: the main file of a text that is a part of a paper, whose preamble defines what the text prints with.
//!
//! **In:** a text without a preamble, and its folder. **Out:** the file that includes it: the one that it names itself, `% !TEX root = ../main.tex`,
//! or the first in its folder or the one above that has a preamble and includes it. **Guaranteed:** no other file is read; nothing of it but its
//! definitions counts; links are resolved before a file is taken for one of these folders.

use std::path::{Component, Path, PathBuf};

use super::named::COMMANDS_OF_TEXT;
use super::token::{Kind, Token, tokens};

/// The most files of a folder that are looked at.
const MOST_FILES: usize = 40;
/// The largest main file, in bytes.
const LARGEST_MAIN: u64 = 1 << 20;
/// The lines in which a text names its main file.
const FIRST_LINES: usize = 30;

/// The main file of a chapter.
pub(super) struct Main {
    pub path: PathBuf,
    pub text: String,
    /// Its tokens before the document begins.
    pub preamble: Vec<Token>,
}

/// The main file of a chapter, if it has one.
pub(super) fn main_of(text: &str, path: &str, folder: &Path) -> Option<Main> {
    if text.contains("\\documentclass") && named_by_class(text).is_none() || text.contains("\\documentstyle") {
        return None;
    }
    let own = files::real(&folder.join(Path::new(path).file_name()?))?;
    let base = own.parent()?.to_path_buf();
    let allowed: Vec<PathBuf> = base.ancestors().take(3).map(Path::to_path_buf).collect();
    if let Some(name) = named_by_comment(text).or_else(|| named_by_class(text)) {
        let name = if Path::new(&name).extension().is_some() { name } else { format!("{name}.tex") };
        let main = files::real(&base.join(name))?;
        let near = main.parent().is_some_and(|p| allowed.iter().any(|a| a == p)) && main != own;
        return if near { preamble(&main) } else { None };
    }
    // A text that is no part of anything is looked for in no folder.
    if !text.contains('\\') {
        return None;
    }
    allowed.iter().take(2).find_map(|above| {
        files::listed(above, "tex", MOST_FILES).iter().filter(|file| **file != own).find_map(|file| {
            let main = preamble(file)?;
            includes(&main.text, above, &own).then_some(main)
        })
    })
}

/// `% !TEX root = main.tex`
fn named_by_comment(text: &str) -> Option<String> {
    text.lines().take(FIRST_LINES).find_map(|line| {
        let rest = line.trim_start().strip_prefix('%')?.trim_start();
        let (before, name) = rest.split_once('=')?;
        before.replace(' ', "").eq_ignore_ascii_case("!texroot").then(|| name.trim().to_owned())
    })
}

/// `\documentclass[main.tex]{subfiles}`
fn named_by_class(text: &str) -> Option<String> {
    let (_, rest) = text.split_once("\\documentclass[")?;
    let (name, class) = rest.split_once(']')?;
    class.trim_start().starts_with("{subfiles}").then(|| name.trim().to_owned())
}

/// A file, where it is a document with a preamble.
fn preamble(path: &Path) -> Option<Main> {
    let bytes = files::read(path, LARGEST_MAIN).ok()?;
    let text = super::texts::text_from(bytes);
    let end = text.find("\\begin{document}")?;
    if !text[..end].contains("\\documentclass") {
        return None;
    }
    let all = tokens(&text[..end]);
    Some(Main { path: path.to_path_buf(), text, preamble: all })
}

/// Whether a main file includes this one.
fn includes(text: &str, folder: &Path, own: &Path) -> bool {
    let all = tokens(text);
    let stem = own.with_extension("");
    (0..all.len()).filter(|&i| all[i].kind == Kind::Command && COMMANDS_OF_TEXT.contains(&all[i].text.as_str())).any(
        |i| {
            let name = super::mark::group_text(&all, i + 1).0;
            let mut path = folder.to_path_buf();
            for part in Path::new(name.trim()).components() {
                match part {
                    Component::Normal(part) => path.push(part),
                    Component::ParentDir => drop(path.pop()),
                    _ => {}
                }
            }
            path == own || path == stem
        },
    )
}
