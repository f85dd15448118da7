//! Macros of a book in Markdown: those of its configuration, `myst.yml` of MyST or `_config.yml` of Jupyter Book.
//!
//! **In:** the folder of a text in Markdown. **Out:** definitions in LaTeX, and the file that has them: the first in the folder or in one of
//! the two above it. **Guaranteed:** no other file is read; of a configuration only names and texts of macros count, and a text whose
//! braces are not balanced is left out.

use std::path::{Path, PathBuf};

/// The names of configurations.
const NAMES: &[&str] = &["myst.yml", "_config.yml"];
/// The keys below which macros stand.
const KEYS: &[&str] = &["math:", "macros:"];
/// The largest configuration, in bytes.
const LARGEST: u64 = 1 << 20;

/// The macros of a book.
pub(super) struct Macros {
    /// The configuration.
    pub path: PathBuf,
    /// Its macros, each as a `\newcommand`.
    pub definitions: String,
}

/// The macros of the book to which a folder belongs.
pub(super) fn macros_of(folder: &Path) -> Option<Macros> {
    let own = files::real(folder)?;
    own.ancestors().take(3).flat_map(|above| NAMES.iter().map(|name| above.join(name))).find_map(|path| {
        let bytes = files::read(&path, LARGEST).ok()?;
        let definitions = definitions(&super::texts::with_plain_ends(String::from_utf8(bytes).ok()?));
        (!definitions.is_empty()).then_some(Macros { path, definitions })
    })
}

/// The macros in a configuration, as definitions in LaTeX.
fn definitions(text: &str) -> String {
    let mut out = String::new();
    // How far the key is indented below which macros stand.
    let mut below: Option<usize> = None;
    for line in text.lines() {
        let bare = line.trim();
        let depth = line.len() - line.trim_start().len();
        if bare.is_empty() || bare.starts_with('#') {
            continue;
        }
        if below.is_some_and(|key| depth <= key) {
            below = None;
        }
        match below {
            None if KEYS.contains(&bare) => below = Some(depth),
            None => {}
            Some(_) => out.extend(definition(bare)),
        }
    }
    out
}

/// `vector: ["\\boldsymbol{#1}", 1]`, or `'\op': '\hat{#1}'`.
fn definition(line: &str) -> Option<String> {
    let (key, value) = line.split_once(':')?;
    let name = key.trim().trim_matches(['\'', '"']).trim_start_matches('\\');
    let value = value.trim();
    let text = scalar(value.strip_prefix('[').unwrap_or(value).trim_start())?;
    let most = (1..=9).rev().find(|n| text.contains(&format!("#{n}"))).unwrap_or(0);
    let is_name = !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphabetic());
    let option = if most == 0 { String::new() } else { format!("[{most}]") };
    (is_name && is_balanced(&text)).then(|| format!("\\newcommand{{\\{name}}}{option}{{{text}}}\n"))
}

/// A text of YAML in one line: in single quotes as it stands, in double quotes with its escapes, or bare.
fn scalar(value: &str) -> Option<String> {
    if let Some(rest) = value.strip_prefix('\'') {
        return rest.split_once('\'').map(|(text, _)| text.to_owned());
    }
    let Some(rest) = value.strip_prefix('"') else {
        let bare = value.split_once(" #").map_or(value, |(text, _)| text).trim();
        return bare.starts_with('\\').then(|| bare.to_owned());
    };
    let mut out = String::new();
    let mut chars = rest.chars();
    loop {
        match chars.next()? {
            '"' => return Some(out),
            '\\' => match chars.next()? {
                c @ ('\\' | '"' | '/') => out.push(c),
                _ => return None,
            },
            c => out.push(c),
        }
    }
}

fn is_balanced(text: &str) -> bool {
    let mut depth = 0i32;
    let mut escaped = false;
    for c in text.chars() {
        match c {
            '{' if !escaped => depth += 1,
            '}' if !escaped => depth -= 1,
            '%' if !escaped => return false,
            _ => {}
        }
        escaped = c == '\\' && !escaped;
        if depth < 0 {
            return false;
        }
    }
    depth == 0
}

#[cfg(test)]
mod tests {
    use super::definitions;

    #[test]
    fn macros_stand_below_their_key() {
        let jupyter = r##"
title: "macros: no"
parse:
  myst_extended_syntax: true
sphinx:
  config:
    mathjax3_config:
      tex:
        macros:
          vector: ["\\boldsymbol{#1}", 1]
          cross: "\\times" # a comment
          bad: "\\{{"
          pair: ["#1~#2", 2]
        other: "\\x"
"##;
        let found = [
            r"\newcommand{\vector}[1]{\boldsymbol{#1}}",
            r"\newcommand{\cross}{\times}",
            r"\newcommand{\pair}[2]{#1~#2}",
            "",
        ];
        assert_eq!(definitions(jupyter), found.join("\n"));
        let myst = "project:\n  math:\n    '\\op' : '\\hat{#1}_{\\mathrm{w}}'\n    \\Ebox: E_0\n    '\\E': \\mathcal{E}\n  title: 'a'\n";
        assert_eq!(
            definitions(myst),
            "\\newcommand{\\op}[1]{\\hat{#1}_{\\mathrm{w}}}\n\\newcommand{\\E}{\\mathcal{E}}\n"
        );
    }
}
