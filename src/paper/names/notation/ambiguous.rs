//! Print that may be a product of numbers, and may be something else: a commutator, a transpose, an expectation.
//!
//! **In:** a formula as tokens. **Out:** whether such a thing stands in it. **Guaranteed:** it is told by the print alone; what the paper is about
//! is asked elsewhere.

use super::print::{behind, is_letter_token, is_script};

/// The tokens of a formula without those that only set brackets and thin spaces.
fn unset<'a>(all: &[&'a str]) -> Vec<&'a str> {
    let sets = |t: &str| {
        matches!(
            t,
            r"\left"
                | r"\right"
                | r"\big"
                | r"\Big"
                | r"\bigl"
                | r"\bigr"
                | r"\Bigl"
                | r"\Bigr"
                | r"\,"
                | r"\!"
                | r"\;"
        )
    };
    all.iter().copied().filter(|t| !sets(t)).collect()
}

fn is_capital(token: &str) -> bool {
    token.len() == 1 && token.chars().all(|c| c.is_ascii_uppercase())
}

/// A group in parentheses, made of letters and signs, before another one with a lone letter: `(fg)(x)`, `(-\gamma)(t)`.
pub(super) fn applies_a_group(all: &[&str]) -> bool {
    let plain = unset(all);
    (0..plain.len()).any(|at| {
        let [")", "(", inside, ")", ..] = plain[at..] else { return false };
        if !is_letter_token(inside) {
            return false;
        }
        let Some(open) = plain[..at].iter().rposition(|t| *t == "(") else { return false };
        let group = &plain[open + 1..at];
        let letters = group.iter().filter(|t| is_letter_token(t)).count();
        let signs = group.iter().filter(|t| matches!(**t, "+" | "-" | r"\circ" | r"\cdot")).count();
        // Where the letter is a factor of the group, too, it is a number.
        letters + signs == group.len() && letters + signs > 1 && letters > 0 && !group.contains(&inside)
    })
}

/// A letter before two groups in parentheses that are made of the same letters, each a single term: `\psi(L/2)=-\psi(-L/2)`. Nobody sets a factor
/// so.
pub(super) fn has_two_places(sides: &[Vec<&str>], is_function: &dyn Fn(&str) -> bool) -> bool {
    let mut seen: Vec<(String, Vec<&str>, String)> = Vec::new();
    for all in sides {
        let plain = unset(all);
        for at in (1..plain.len()).filter(|&at| plain[at] == "(") {
            let base = match plain[at - 1] {
                one if is_script(&plain, at - 1) && one != "{" => plain[at.saturating_sub(3)..at].concat(),
                one if is_letter_token(one) && !is_function(one) => one.to_owned(),
                _ => continue,
            };
            let is_named = base.starts_with(|c: char| c.is_ascii_alphabetic() || c == '\\') && !base.contains('^');
            if !is_named {
                continue;
            }
            let mut depth = 0i32;
            let Some(end) = (at..plain.len()).find(|&k| {
                depth += i32::from(plain[k] == "(") - i32::from(plain[k] == ")");
                depth == 0
            }) else {
                continue;
            };
            let inside = &plain[at + 1..end];
            let is_term = inside.iter().skip(1).all(|t| !matches!(*t, "+" | "-" | "," | "=" | "("));
            if inside.is_empty() || !is_term || plain.get(end + 1) == Some(&"^") {
                continue;
            }
            let mut letters: Vec<&str> = inside.iter().copied().filter(|t| is_letter_token(t)).collect();
            letters.sort_unstable();
            let content = inside.concat();
            if seen.iter().any(|(b, l, c)| *b == base && *l == letters && *c != content) {
                return true;
            }
            seen.push((base, letters, content));
        }
    }
    false
}

/// A letter with a plus below it beside the same with a minus: operators that raise and lower, `a_-a_+`.
pub(super) fn has_ladder(text: &str) -> bool {
    let text = super::squeezed(text);
    let beside = |sign: &str, other: &str| {
        text.match_indices(sign).any(|(at, _)| {
            let from = text[..at].rfind(|c: char| !c.is_alphabetic() && c != '\\').map_or(0, |k| k + 1);
            let base = &text[from..at];
            !base.is_empty() && text[at + sign.len()..].trim_start_matches(r"\,").starts_with(&format!("{base}{other}"))
        })
    };
    beside("_+", "_-") || beside("_-", "_+")
}

/// Two terms in parentheses, of which one is the other backwards, and subtracted: `(xy-yx)f`.
pub(super) fn has_commutator(all: &[&str]) -> bool {
    let plain = unset(all);
    (0..plain.len()).filter(|&at| plain[at] == "-" && at > 1).any(|at| {
        let unit = |from: usize| {
            let sub = plain.get(from + 1) == Some(&"_");
            let end = if sub { behind(&plain, from + 2) } else { from + 1 };
            (plain.get(from).is_some_and(|t| is_letter_token(t))).then_some(end.min(plain.len()))
        };
        let Some(first) = unit(at + 1) else { return false };
        let Some(second) = unit(first) else { return false };
        let (b, a) = (&plain[at + 1..first], &plain[first..second]);
        let written = [a, b].concat();
        a != b && plain[..at].ends_with(&written) && !plain.get(second).is_some_and(|t| matches!(*t, "^" | "_" | "("))
    })
}

/// A capital before or behind the same with a prime, `MM'`, `X'X`, or around parentheses, `M(\ldots)M'`: a matrix and its transpose.
pub(super) fn has_primed_transpose(all: &[&str]) -> bool {
    let plain = unset(all);
    (2..plain.len()).filter(|&at| plain[at] == "'" && is_capital(plain[at - 1])).any(|at| {
        let own = plain[at - 1];
        match plain[at - 2] {
            before if before == own => !is_script(&plain, at - 2),
            _ if plain.get(at + 1) == Some(&own) && !matches!(plain.get(at + 2), Some(&("'" | "_" | "^" | "("))) => {
                true
            }
            ")" => {
                let mut depth = 0i32;
                let open = (0..at - 1).rev().find(|&k| {
                    depth += i32::from(plain[k] == ")") - i32::from(plain[k] == "(");
                    depth == 0
                });
                open.and_then(|k| k.checked_sub(1)).is_some_and(|k| plain[k] == own)
            }
            _ => false,
        }
    })
}

/// An `O` or `o` before parentheses: an order of magnitude.
pub(super) fn has_order_of_magnitude(all: &[&str]) -> bool {
    let plain = unset(all);
    (1..plain.len()).any(|at| plain[at] == "(" && matches!(plain[at - 1], "O" | "o") && !is_script(&plain, at - 1))
}

/// A cross product of plain letters within another one, or beside a product with a dot: `a\times(b\times c)`.
pub(super) fn has_plain_triple_product(all: &[&str]) -> bool {
    let plain = unset(all);
    let crosses = |at: usize| {
        plain[at] == r"\times"
            && at > 0
            && is_letter_token(plain[at - 1])
            && !at.checked_sub(2).is_some_and(|k| plain[k] == "{" || plain[k].len() > 3 && plain[k].starts_with('\\'))
            && plain.get(at + 1).is_some_and(|t| is_letter_token(t) || *t == "(")
    };
    let count = (0..plain.len()).filter(|&at| crosses(at)).count();
    count > 1 && (0..plain.len()).any(|at| plain[at] == r"\times" && plain.get(at + 1) == Some(&"("))
}

/// An upright D before what is derived: `\mathrm D\frac gf`, `\mathrm{D}f`.
pub(super) fn has_upright_derivative(all: &[&str]) -> bool {
    (0..all.len()).any(|at| {
        if !matches!(all[at], r"\mathrm" | r"\operatorname" | r"\rm" | r"\mathcal") || is_script(all, at) {
            return false;
        }
        let end = behind(all, at + 1).min(all.len());
        let word: String = all[at + 1..end].iter().filter(|t| !matches!(**t, "{" | "}")).copied().collect();
        let follows = all.get(end).is_some_and(|t| {
            is_letter_token(t) || matches!(*t, r"\frac" | r"\dfrac" | r"\tfrac" | "[" | r"\left" | r"\," | "(" | "^")
        });
        word == "D" && follows
    })
}

/// A number of degrees without their sign in a function of angles: `\cos(180-\beta)`.
pub(super) fn has_bare_degrees(all: &[&str]) -> bool {
    let plain = unset(all);
    let angles = |t: &str| matches!(t, r"\sin" | r"\cos" | r"\tan" | r"\cot" | r"\sec" | r"\csc");
    (0..plain.len()).filter(|&at| angles(plain[at])).any(|at| {
        let begin = (at + 1..plain.len()).find(|&k| !matches!(plain[k], "(" | "{" | "-")).unwrap_or(plain.len());
        let is_digit = |k: &usize| plain[*k].chars().all(|c| c.is_ascii_digit());
        let end = begin + (begin..plain.len()).take_while(is_digit).count();
        let is_signed = matches!(plain.get(end), Some(&("^" | "°" | r"\degree")));
        !is_signed && matches!(plain[begin..end].concat().as_str(), "90" | "180" | "270" | "360")
    })
}

/// Two subscripts of two letters at one name, one the other backwards: `f_{xy}` and `f_{yx}`.
pub(super) fn has_turned_subscripts(all: &[&str]) -> bool {
    let mut seen: Vec<[&str; 3]> = Vec::new();
    for at in 0..all.len() {
        let [base, "_", "{", a, b, "}", ..] = all[at..] else { continue };
        if a != b && is_letter_token(base) && is_letter_token(a) && is_letter_token(b) {
            if seen.contains(&[base, b, a]) {
                return true;
            }
            seen.push([base, a, b]);
        }
    }
    false
}

/// A capital, raised by t, beside another one: `A^tB^t`, `(AB)^t`.
pub(super) fn has_small_transpose(all: &[&str]) -> bool {
    let plain = unset(all);
    let raised = |at: usize| matches!(plain[at..], ["^", "t", ..] | ["^", "{", "t", "}", ..]);
    let pair = plain.windows(2).any(|w| is_capital(w[0]) && is_capital(w[1]));
    let beside = |at: usize| {
        let end = behind(&plain, at + 1);
        plain.get(end).is_some_and(|t| is_capital(t)) || at > 1 && is_capital(plain[at - 2])
    };
    (1..plain.len())
        .any(|at| raised(at) && (is_capital(plain[at - 1]) && (beside(at) || pair) || plain[at - 1] == ")" && pair))
}

/// An E before brackets, a capital or a space: an expectation, in a paper of random variables.
pub(super) fn has_expectation(all: &[&str]) -> bool {
    (0..all.len()).any(|at| {
        let behind = all.get(at + 1);
        all[at] == "E"
            && !is_script(all, at)
            && behind.is_some_and(|t| is_capital(t) || matches!(*t, "[" | "(" | r"\," | r"\left" | "~" | r"\ "))
    })
}

/// A capital before a vector: `P\vec x`, in a paper of eigenvectors.
pub(super) fn has_map_of_vector(all: &[&str]) -> bool {
    let plain = unset(all);
    (1..plain.len()).any(|at| {
        let is_vector = matches!(plain[at], r"\vec" | r"\mathbf" | r"\boldsymbol" | r"\bm");
        let mut before = at - 1;
        while before > 0 && matches!(plain[before], "(" | "{") {
            before -= 1;
        }
        is_vector && is_capital(plain[before]) && !is_script(&plain, before)
    })
}

/// Two groups in parentheses that end with the same capital as a further term, and a side that has it once, as its last term: cosets,
/// `(a+I)+(b+I)=(a+b)+I`.
pub(super) fn has_cosets(sides: &[Vec<&str>]) -> bool {
    let plain: Vec<Vec<&str>> = sides.iter().map(|all| unset(all)).collect();
    let is_coset = |side: &[&str], letter: &str| {
        let bare = side.strip_suffix(&["."]).unwrap_or(side);
        bare.ends_with(&["+", letter]) && bare.iter().filter(|t| **t == letter).count() == 1
    };
    let letters = |side: &[&str]| -> Vec<String> {
        let ends: Vec<(usize, &str)> = (2..side.len())
            .filter(|&at| side[at] == ")" && is_capital(side[at - 1]) && side[at - 2] == "+")
            .map(|at| (at, side[at - 1]))
            .collect();
        let beside = |pair: &&[(usize, &str)]| {
            let [(first, letter), (_, other)] = **pair else { return false };
            let between = first + 1 + usize::from(matches!(side.get(first + 1), Some(&("+" | r"\cdot"))));
            letter == other && side.get(between) == Some(&"(")
        };
        ends.windows(2).filter(beside).map(|pair| pair[0].1.to_owned()).collect()
    };
    plain.iter().any(|side| letters(side).iter().any(|letter| plain.iter().any(|other| is_coset(other, letter))))
}
