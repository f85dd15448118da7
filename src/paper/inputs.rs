//! Files that a paper names with `\\input`, `\\include` or `\\subfile`.
//!
//! **In:** the folder of the paper, and names. **Out:** the tokens of the files, with places behind those of the paper.
//! **Guaranteed:** nothing outside of the paper's folder is read, links resolved; no file is read inside of itself; what is not
//! read is told.

use std::ops::Range;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use super::book::macros_of;
use super::chapter::main_of;
use super::environments::OwnEnvironments;
use super::kinds::{FileKind, is_markdown};
use super::markdown::printed;
use super::named::Named;
use super::note::PaperNote;
use super::notebook::printed_cells;
use super::texts::{LARGEST_PAPER, text_from};
use super::token::{MOST_TOKENS, Token, tokens, tokens_with};
use diag::Source;
use diag::escape::in_one_line;

/// The most characters of the name of a file that are told.
const LONGEST_NAME: usize = 200;
/// The largest package that is read, in bytes.
const LARGEST_PACKAGE: u64 = 1 << 20;
/// Packages whose commands have a meaning here, which a copy of the package beside the paper does not change.
const KNOWN_PACKAGES: &[&str] = &[
    "amsmath",
    "amssymb",
    "amsfonts",
    "amsthm",
    "amstext",
    "amsbsy",
    "bm",
    "braket",
    "cancel",
    "cases",
    "commath",
    "derivative",
    "diffcoeff",
    "empheq",
    "esint",
    "gensymb",
    "mathtools",
    "nicefrac",
    "physics",
    "siunitx",
    "SIunits",
    "subfiles",
    "tensor",
    "units",
    "xcolor",
    "xfrac",
    "xparse",
];
/// The most files of a paper.
const MOST_FILES: usize = 400;
/// The most bytes of all files together.
const MOST_BYTES: u64 = 4 * LARGEST_PAPER;

/// What is read beside the paper's own file.
pub(super) struct Inputs {
    folder: Option<PathBuf>,
    /// The folder of the main file, of a chapter.
    main: Option<PathBuf>,
    /// Where each begins when all are written behind each other.
    pub files: Vec<(usize, Arc<Source>)>,
    pub notes: Vec<PaperNote>,
    /// Files of which the text is being read, or was read.
    seen: Vec<PathBuf>,
    next: usize,
    bytes: u64,
    /// Environments that the files make.
    pub own: OwnEnvironments,
}

/// The tokens of a file: Markdown is known by its name.
pub(super) fn tokens_of(source: &Source, own: &mut OwnEnvironments) -> Vec<Token> {
    match FileKind::of(&source.path) {
        FileKind::Markdown => tokens_with(&printed(&source.text), own),
        FileKind::Notebook => tokens_with(&printed_cells(&source.text), own),
        FileKind::Latex | FileKind::Refused(_) => tokens_with(&source.text, own),
    }
}

impl Inputs {
    pub(super) fn new(paper: &Source, folder: Option<&Path>, own: OwnEnvironments) -> Inputs {
        let here = |f: &Path| if f.as_os_str().is_empty() { PathBuf::from(".") } else { f.to_path_buf() };
        let name = Path::new(&paper.path).file_name().map(PathBuf::from);
        Inputs {
            folder: folder.map(here),
            main: None,
            files: Vec::new(),
            notes: Vec::new(),
            seen: name.into_iter().collect(),
            next: paper.text.len() + 1,
            bytes: 0,
            own,
        }
    }

    /// The tokens of the file of this name; none, and a note, where it is not read. Of packages and classes those are read that lie in the folder of
    /// the paper: others are part of TeX, and leave no note.
    pub(super) fn tokens(&mut self, name: &str, named: Named, span: &Range<usize>) -> Vec<Token> {
        match named {
            Named::Text => self.text(name, span),
            Named::Package => self.definitions(&format!("{name}.sty"), span),
            Named::Class => self.definitions(&format!("{name}.cls"), span),
        }
    }

    /// The tokens of a package of the paper's own.
    fn definitions(&mut self, file: &str, span: &Range<usize>) -> Vec<Token> {
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        let stem = stem.rsplit('/').next().unwrap_or(stem);
        let is_own = |folder: &PathBuf| {
            let path = folder.join(file);
            let plain = Path::new(file).components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
            plain
                && files::lies_inside(&path, folder)
                && files::read(&path, LARGEST_PACKAGE).is_ok_and(|b| is_plain(&b))
        };
        if !self.folders().iter().any(is_own)
            || KNOWN_PACKAGES.contains(&stem)
            || self.seen.iter().any(|s| s.as_path() == Path::new(file))
        {
            return Vec::new();
        }
        self.text(file, span)
    }

    /// The tokens of a file with text.
    fn text(&mut self, name: &str, span: &Range<usize>) -> Vec<Token> {
        if self.folder.is_none() {
            return self.refused(name, span, "files that a text names are not read");
        }
        let wanted = Path::new(name.trim());
        let plain = wanted.components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
        if name.trim().is_empty() || !plain {
            return self.refused(name, span, "it lies outside of the folder of the paper");
        }
        let relative: PathBuf = wanted.components().filter(|c| matches!(c, Component::Normal(_))).collect();
        let with_ending = match relative.extension() {
            Some(_) => relative.clone(),
            None => relative.with_extension("tex"),
        };
        if self.seen.contains(&with_ending) {
            return self.refused(name, span, "it was read already");
        }
        if self.files.len() >= MOST_FILES || self.bytes > MOST_BYTES {
            return self.refused(name, span, "the paper has more files than are read");
        }
        let folders = self.folders();
        let Some(path) = folders.iter().map(|f| (f, f.join(&with_ending))).find(|(f, p)| files::lies_inside(p, f))
        else {
            return self.refused(name, span, "there is no such file inside of the folder of the paper");
        };
        let path = path.1;
        match files::read(&path, LARGEST_PAPER) {
            Err(_) => self.refused(name, span, "it cannot be read"),
            Ok(bytes) => {
                self.seen.push(with_ending);
                self.bytes += bytes.len() as u64;
                let source = Source { path: path.display().to_string(), text: text_from(bytes) };
                let all = tokens_of(&source, &mut self.own);
                if all.len() > MOST_TOKENS {
                    return self.refused(name, span, "it is longer than can be read");
                }
                document_alone(self.placed(source, all))
            }
        }
    }

    /// The tokens of a file, behind all others.
    fn placed(&mut self, source: Source, mut all: Vec<Token>) -> Vec<Token> {
        let base = self.next;
        self.next += source.text.len() + 1;
        for token in &mut all {
            token.span = token.span.start + base..token.span.end + base;
        }
        self.files.push((base, Arc::new(source)));
        all
    }

    /// The folders in which files are looked for: that of the paper, and of a chapter that of its main file.
    fn folders(&self) -> Vec<PathBuf> {
        self.folder.iter().chain(&self.main).cloned().collect()
    }

    /// Of a chapter, the preamble of its main file; that is told.
    pub(super) fn preamble(&mut self, paper: &Source) -> Vec<Token> {
        if is_markdown(&paper.path)
            && let Some(book) = self.folder.as_deref().and_then(macros_of)
        {
            let name = book.path.file_name().map_or_else(String::new, |n| n.display().to_string());
            let message = format!("read with the macros of `{}`", in_one_line(&name));
            self.notes.push(PaperNote { message, span: 0..0 });
            let all = tokens(&book.definitions);
            return self.placed(Source { path: book.path.display().to_string(), text: book.definitions }, all);
        }
        let Some(main) = self.folder.as_ref().and_then(|f| main_of(&paper.text, &paper.path, f)) else {
            return Vec::new();
        };
        let name = main.path.file_name().map_or_else(String::new, |n| n.display().to_string());
        let message = format!("read with the definitions of `{}`, which includes it", in_one_line(&name));
        self.notes.push(PaperNote { message, span: 0..0 });
        // What is made there is so in the chapter.
        tokens_with(&main.text, &mut self.own);
        self.main = main.path.parent().map(Path::to_path_buf);
        self.placed(Source { path: main.path.display().to_string(), text: main.text }, main.preamble)
    }

    fn refused(&mut self, name: &str, span: &Range<usize>, why: &str) -> Vec<Token> {
        let mut name = in_one_line(name.trim());
        if name.is_empty() {
            // `\input\jobname`, or one within a definition of plain TeX.
            return Vec::new();
        }
        if let Some((end, _)) = name.char_indices().nth(LONGEST_NAME) {
            name.replace_range(end.., "\u{2026}");
        }
        let message = format!("the file `{name}` is not read: {why}");
        self.notes.push(PaperNote { message, span: span.clone() });
        Vec::new()
    }
}

/// Whether a package is written with the definitions of LaTeX, not in the language of its third version.
fn is_plain(bytes: &[u8]) -> bool {
    !["\\ExplSyntaxOn", "\\ProvidesExpl"].iter().any(|w| bytes.windows(w.len()).any(|b| b == w.as_bytes()))
}

/// Of a file that is a document of its own, what stands between its beginning and its end.
fn document_alone(all: Vec<Token>) -> Vec<Token> {
    let named = |i: usize, command: &str| {
        all.get(i).is_some_and(|t| t.is(command)) && super::mark::group_text(&all, i + 1).0 == "document"
    };
    let begin = (0..all.len()).find(|&i| named(i, "begin"));
    let Some(begin) = begin else { return all };
    let end = (begin..all.len()).find(|&i| named(i, "end")).unwrap_or(all.len());
    let from = super::mark::group_text(&all, begin + 1).1;
    all.get(from..end).map(<[Token]>::to_vec).unwrap_or_default()
}
