//! What was changed between two formulas, piece by piece.

/// The pieces of a formula as TeX reads them: commands, numbers, single characters.
fn pieces(text: &str) -> Vec<&str> {
    let mut out = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = match c {
            '\\' => {
                let letters = rest[1..].bytes().take_while(u8::is_ascii_alphabetic).count();
                if letters > 0 { 1 + letters } else { 1 + rest[1..].chars().next().map_or(0, char::len_utf8) }
            }
            c if c.is_ascii_digit() => rest.bytes().take_while(u8::is_ascii_digit).count(),
            c => c.len_utf8(),
        };
        let (piece, after) = rest.split_at(length);
        if !piece.trim().is_empty() {
            out.push(piece);
        }
        rest = after;
    }
    out
}

/// A formula with what is removed between `[-` and `-]` and what is added between `{+` and `+}`, and how many pieces these are.
pub(super) fn difference(old: &str, new: &str) -> (String, usize) {
    let (a, b) = (pieces(old), pieces(new));
    // Lengths of the longest common subsequences of what is left.
    let mut common = vec![vec![0usize; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            common[i][j] = if a[i] == b[j] { common[i + 1][j + 1] + 1 } else { common[i + 1][j].max(common[i][j + 1]) };
        }
    }
    let mut out = String::new();
    let (mut removed, mut added) = (Vec::new(), Vec::new());
    let (mut i, mut j, mut changed) = (0, 0, 0);
    loop {
        let same = i < a.len() && j < b.len() && a[i] == b[j];
        if same || (i == a.len() && j == b.len()) {
            for (list, open, close) in [(&mut removed, "[-", "-]"), (&mut added, "{+", "+}")] {
                if !list.is_empty() {
                    out.push_str(open);
                    append(&mut out, list);
                    out.push_str(close);
                    list.clear();
                }
            }
            if !same {
                return (out, changed);
            }
            append(&mut out, &[a[i]]);
            i += 1;
            j += 1;
            continue;
        }
        changed += 1;
        if j == b.len() || (i < a.len() && common[i + 1][j] >= common[i][j + 1]) {
            removed.push(a[i]);
            i += 1;
        } else {
            added.push(b[j]);
            j += 1;
        }
    }
}

/// Adds pieces, a command and a letter kept apart.
fn append(out: &mut String, pieces: &[&str]) {
    for piece in pieces {
        let command = out.rfind('\\').is_some_and(|at| {
            let tail = &out[at + 1..];
            !tail.is_empty() && tail.bytes().all(|b| b.is_ascii_alphabetic())
        });
        if command && piece.starts_with(|c: char| c.is_ascii_alphabetic()) {
            out.push(' ');
        }
        out.push_str(piece);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_changed_is_marked() {
        assert_eq!(difference(r"a=-\frac12 b", r"a=\frac12 b"), (r"a=[---]\frac12b".to_owned(), 1));
        assert_eq!(difference(r"\sin\psi x", r"\cos\psi x"), (r"[-\sin-]{+\cos+}\psi x".to_owned(), 2));
        assert_eq!(difference("m_1", "m_3"), ("m_[-1-]{+3+}".to_owned(), 2));
        assert_eq!(difference("x", "x"), ("x".to_owned(), 0));
        assert_eq!(difference("", "2x"), ("{+2x+}".to_owned(), 2));
    }
}
