//! A side that is told by cases → one relation for each case, with its condition.
//!
//! **In:** a relation whose last side is `\begin{cases}…\end{cases}` and nothing else. **Out:** for each row the relation with that row's value, and
//! what the row says of when it holds; for each of two conditions with "or" between them. **Guaranteed:** a row without a condition that relates something, "otherwise" among them, parts nothing:
//! the relation stays as it is.

use super::super::mark::group_text;
use super::super::opening::{Opening, is_opening, opening};
use super::super::token::{Kind, Token};
use super::{Nesting, Place, PrintedRelation, is_space, relations};

/// Environments that tell a value by cases.
const CASES: &[&str] = &["cases", "dcases", "cases*", "dcases*"];

impl PrintedRelation {
    /// The cases of a relation: for each the relation, and the conditions under which it holds. `None` where it is not told by cases.
    pub fn cases(&self) -> Option<Vec<Vec<PrintedRelation>>> {
        let (last, before) = self.sides.split_last()?;
        if before.is_empty() || self.opening.is_some() {
            return None;
        }
        let mut head: Vec<Token> = Vec::new();
        for (side, sign) in before.iter().zip(&self.signs) {
            head.extend(side.tokens.iter().cloned());
            head.extend(sign_of(sign, side.span.end));
        }
        let place =
            Place { environment: "equation", display: self.display, section: self.section, chapter: self.chapter };
        let mut out = Vec::new();
        let rows = rows_of(&last.tokens)?;
        let all = rows.iter().flat_map(|(value, condition)| alternatives(condition).map(move |one| (value, one)));
        for (value, condition) in all {
            let mut body = head.clone();
            body.extend(value.iter().cloned());
            let mut one = relations(&body, &place);
            let mut when = relations(&opened(condition), &place);
            let relates = |all: &[PrintedRelation]| all.len() == 1 && all[0].sides.len() > 1;
            if when.iter().any(|r| r.remark.as_deref().is_some_and(|r| !is_when(r))) {
                return None;
            }
            when.retain(|r| r.sides.len() > 1 || !r.sides[0].text.is_empty());
            if !relates(&one) || !relates(&when) {
                return None;
            }
            when[0].opening = Some(Opening::Case);
            // Words begin a condition.
            when[0].unread = None;
            one.append(&mut when);
            one.iter_mut().for_each(|r| r.label.clone_from(&self.label));
            out.push(one);
        }
        Some(out)
    }
}

/// The conditions of a case, `x<0` and `x>L` of `x<0 \text{ or } x>L`: under each of them it holds.
fn alternatives(condition: &[Token]) -> impl Iterator<Item = &[Token]> {
    let is_or = |at: usize| {
        let is_text = matches!(condition[at].text.as_str(), "text" | "mbox" | "textrm");
        is_text && condition[at].kind == Kind::Command && group_text(condition, at + 1).0.trim() == "or"
    };
    let breaks: Vec<usize> = (0..condition.len()).filter(|&at| is_or(at)).collect();
    let begins = std::iter::once(0).chain(breaks.clone().into_iter().map(|at| group_text(condition, at + 1).1));
    begins.zip(breaks.into_iter().chain([condition.len()])).map(|(from, to)| &condition[from..to.max(from)])
}

/// Whether words before a condition say that it is one, and no more.
fn is_when(words: &str) -> bool {
    let is_case = || is_opening(words) && matches!(opening(words), Some(Opening::Case | Opening::Meaning));
    words.trim().is_empty() || is_case()
}

/// A sign as a token.
fn sign_of(sign: &str, at: usize) -> Option<Token> {
    let (kind, text) = match sign.strip_prefix('\\') {
        Some(command) => (Kind::Command, command),
        None => (Kind::Other, sign),
    };
    Some(Token { kind, text: text.into(), span: at..at })
}

/// What stands between `\left\{` and `\right.`, where that is all.
fn braced(tokens: &[Token], from: usize) -> Option<Vec<Token>> {
    let printed: Vec<usize> = (from..tokens.len()).filter(|&i| !is_space(&tokens[i])).collect();
    let is = |k: usize, command: &str| printed.get(k).is_some_and(|&i| tokens[i].is(command));
    let last = printed.iter().rposition(|&i| tokens[i].is("right"))?;
    let dot = printed.get(last + 1).is_some_and(|&i| tokens[i].is_char("."));
    let rest = printed.get(last + 2..)?.iter().all(|&i| tokens[i].is_char(".") || tokens[i].is_char(","));
    let begins = is(0, "left") && is(1, "{") && is(2, "begin") && last > 2;
    (begins && dot && rest).then(|| {
        let inside = &tokens[printed[2]..printed[last]];
        let end = inside.iter().rposition(|t| !is_space(t)).map_or(0, |i| i + 1);
        inside[..end].to_vec()
    })
}

/// A condition with the formulas that stand in its words, `\text{if $x>0$}`, behind them.
fn opened(tokens: &[Token]) -> Vec<Token> {
    let mut out = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let is_text = token.kind == Kind::Command && matches!(token.text.as_str(), "text" | "mbox" | "textrm");
        let inside = if is_text { group(tokens, at + 1) } else { None };
        let formula = |t: &Token| t.kind == Kind::Dollar || t.is("(") || t.is(")");
        match inside.filter(|(from, to)| tokens[*from..*to].iter().any(formula)) {
            Some((from, to)) => {
                // Words, formulas, words: each of the words is a group of its own.
                for (k, part) in tokens[from..to].split(formula).enumerate() {
                    if k % 2 == 1 {
                        out.extend_from_slice(part);
                    } else if part.iter().any(|t| t.kind != Kind::Space) {
                        out.extend_from_slice(&tokens[at..from]);
                        out.extend_from_slice(part);
                        out.push(tokens[to].clone());
                    }
                }
                at = to + 1;
            }
            None => {
                out.push(token.clone());
                at += 1;
            }
        }
    }
    out
}

/// From where to where what stands in braces goes that begin here.
fn group(tokens: &[Token], at: usize) -> Option<(usize, usize)> {
    let open = at + tokens[at.min(tokens.len())..].iter().position(|t| t.kind != Kind::Space)?;
    let mut depth = 0i32;
    for (i, token) in tokens.iter().enumerate().skip(open) {
        depth += i32::from(token.kind == Kind::Open) - i32::from(token.kind == Kind::Close);
        if depth == 0 {
            return (token.kind == Kind::Close).then_some((open + 1, i));
        }
    }
    None
}

/// The rows of a side that is nothing but cases, each as its value and its condition.
fn rows_of(tokens: &[Token]) -> Option<Vec<(Vec<Token>, Vec<Token>)>> {
    let from = tokens.iter().position(|t| !is_space(t))?;
    let to = tokens.iter().rposition(|t| !is_space(t) && !t.is_char(".") && !t.is_char(","))?;
    let is_braced = braced(tokens, from);
    let tokens = match &is_braced {
        Some(inside) => inside,
        None => &tokens[from..=to],
    };
    let (name, mut begin) = group_text(tokens, tokens.first().filter(|t| t.is("begin")).map(|_| 1)?);
    let end = tokens.iter().rposition(|t| t.is("end"))?;
    let (closed, after) = group_text(tokens, end + 1);
    let is_array = is_braced.is_some() && name == "array";
    if is_array {
        begin = group_text(tokens, begin).1;
    }
    if !(is_array || CASES.contains(&name.as_str())) || closed != name || after < tokens.len() || begin > end {
        return None;
    }
    let mut rows: Vec<Vec<Vec<Token>>> = vec![vec![Vec::new()]];
    let mut nesting = Nesting::default();
    let inside = &tokens[begin..end];
    let mut at = 0;
    while let Some(token) = inside.get(at) {
        let outside = nesting.is_outside();
        let more = nesting.take(token, &inside[at + 1..]);
        let row = rows.last_mut()?;
        if outside && token.is("\\") {
            rows.push(vec![Vec::new()]);
        } else if outside && token.is_char("&") {
            row.push(Vec::new());
        } else {
            row.last_mut()?.extend_from_slice(&inside[at..(at + 1 + more).min(inside.len())]);
        }
        at += 1 + more;
    }
    rows.retain(|row| row.iter().flatten().any(|t| !is_space(t)));
    let whole = rows.into_iter().map(|row| match <[Vec<Token>; 2]>::try_from(row) {
        Ok([mut value, condition]) => {
            while value.last().is_some_and(|t| is_space(t) || t.is_char(",") || t.is_char(";")) {
                value.pop();
            }
            Some((value, condition))
        }
        Err(_) => None,
    });
    whole.collect::<Option<Vec<_>>>().filter(|rows| !rows.is_empty())
}
