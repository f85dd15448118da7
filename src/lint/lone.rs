//! Lone names: a side that is one name and nothing else, and a name without its dots or primes.

use paper::{Call, PaperName, PrintedSide, names};

/// A side that is one name and nothing else.
pub fn lone_name(side: &PrintedSide) -> Option<PaperName> {
    let mut all = names(side);
    if let Some(first) = all.first()
        && let Call::Places(places) = &first.call
        && all.len() > 1
        && all.len() <= places.len() + 1
    {
        // What stands in its parentheses are names, too.
        all.truncate(1);
    }
    // A derivative `dx/dt` names what it is derived by, too.
    if all.len() == 2 && all[0].derived_by.as_deref() == Some(all[1].key().as_str()) {
        let rest = without(&side.text, &[r"\frac", r"\dfrac", r"\tfrac", r"\mathrm", r"\dv"]);
        let letters: usize = [&all[0], &all[1]].iter().map(|n| bare(&n.key()).len()).sum();
        let plain = bare(&rest).chars().filter(|c| *c != 'd').count() == letters;
        return plain.then(|| all.swap_remove(0));
    }
    let [one] = all.as_slice() else { return None };
    if one.derived_by.is_some() || one.is_difference {
        return None;
    }
    let dots = ["", r"\dot", r"\ddot", r"\dddot"].get(one.dots)?;
    let places = match &one.call {
        Call::None => String::new(),
        Call::Places(places) => format!("({})", places.join(",")),
        Call::Other => return None,
    };
    let wanted = bare(&format!("{dots}{}{places}", one.key()));
    (sorted(&bare(&side.text)) == sorted(&wanted)).then(|| all.swap_remove(0))
}

/// A text without braces, spaces and the names of styles.
pub fn bare(text: &str) -> String {
    let text = without(
        text,
        &[
            r"\left",
            r"\right",
            r"\boldsymbol",
            r"\mathbf",
            r"\vec",
            r"\bm",
            r"\bf",
            r"\rm",
            r"\mathrm",
            r"\text",
            r"\prime",
            "'",
        ],
    );
    text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}' | '^')).collect()
}

fn without(text: &str, commands: &[&str]) -> String {
    commands.iter().fold(text.to_owned(), |text, c| text.replace(c, ""))
}

fn sorted(text: &str) -> Vec<char> {
    let mut out: Vec<char> = text.chars().collect();
    out.sort_unstable();
    out
}

/// A name by which something is derived, `\partial L/\partial\dot x`, with its dots apart.
pub fn undotted(name: PaperName) -> PaperName {
    let dots = [(r"\dot", 1), (r"\ddot", 2)];
    let found = dots.into_iter().find_map(|(command, n)| {
        let rest = name.base.strip_prefix(command)?;
        (name.dots == 0 && !rest.starts_with(|c: char| c.is_ascii_alphabetic())).then_some((rest, n))
    });
    match found {
        Some((rest, dots)) => {
            let base = rest.trim().trim_start_matches('{').trim_end_matches('}').trim().to_owned();
            PaperName { letter: base.clone(), base, dots, ..name }
        }
        None => name,
    }
}

/// A name without its primes.
pub fn unprimed(name: &PaperName) -> PaperName {
    PaperName { base: name.base.trim_end_matches('\'').to_owned(), primes: 0, ..name.clone() }
}

/// Whether a side is a rate of one name, and the other one names it, too: an equation that moves it.
pub(super) fn is_equation_of_motion(left: &PrintedSide, right: &PrintedSide) -> bool {
    let all = names(left);
    let mut rates = all.iter().filter(|n| !n.is_variable && (n.primes > 0 || n.dots > 0 || n.derived_by.is_some()));
    let Some(rate) = rates.next().filter(|_| rates.next().is_none()) else { return false };
    let is_bare = |n: &paper::PaperName| n.primes == 0 && n.dots == 0 && n.derived_by.is_none();
    // `\frac{d}{dx}\sin x` is the derivative of a formula.
    rate.derived_by.as_ref() != Some(&rate.key())
        && all.iter().filter(|n| !n.is_variable).count() == 1
        && names(right).iter().any(|n| is_bare(n) && n.key() == unprimed(rate).key())
}
