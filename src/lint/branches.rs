//! Steps between sides with ±: `(a\pm b)^2=a^2\pm2ab+b^2`.
//!
//! **In:** a step of which both sides have signs of two branches. **Out:** its word: it *follows* where it does with the upper signs and with the
//! lower ones. **Guaranteed:** *wrong* is said of no step that holds with other signs: `x=-p\pm q=-p\mp(-q)` may be said of both values
//! together, in any order.

use paper::{PrintedSide, names};

use super::judge::Judge;
use super::nearest::WrongStep;
use super::step::{Place, Step};

impl Judge<'_> {
    /// Decides one step.
    pub(super) fn step(&mut self, sides: [&PrintedSide; 2], place: &Place) -> Step {
        let plain = self.step_of_one(sides, place);
        // A sign above or below a name is a part of it, and is read as one.
        if !matches!(plain, Step::NotRead(_)) || !has_branches(sides) {
            return plain;
        }
        self.of_branches(sides, place).unwrap_or(plain)
    }

    fn of_branches(&mut self, sides: [&PrintedSide; 2], place: &Place) -> Option<Step> {
        let [upper, lower] = [true, false].map(|upper| sides.map(|side| side.branch(upper)));
        let first = self.step_of_one(upper.each_ref(), place);
        let second = self.step_of_one(lower.each_ref(), place);
        Some(match (first, second) {
            (Step::NotRead(_), _) | (_, Step::NotRead(_)) => return None,
            (Step::Follows(one), Step::Follows(other)) => Step::Follows(one.and(other)),
            (Step::Follows(_) | Step::Numbers, Step::Follows(_) | Step::Numbers) => Step::Numbers,
            (Step::Wrong(one), Step::Wrong(other)) => {
                let crossed = [[&upper[0], &lower[1]], [&lower[0], &upper[1]]];
                let mut holds = |sides| matches!(self.step_of_one(sides, place), Step::Follows(_) | Step::Numbers);
                let is_one_each = sides.iter().all(|side| side.branch_signs() == 1);
                let instead = merged(&one.instead, &other.instead).filter(|_| is_one_each);
                match instead.filter(|_| !crossed.into_iter().any(&mut holds)) {
                    Some(instead) => Step::Wrong(Box::new(WrongStep { instead, ..*one })),
                    None => Step::Open(Vec::new()),
                }
            }
            (Step::Open(names), _) | (_, Step::Open(names)) => Step::Open(names),
            _ => Step::Open(Vec::new()),
        })
    }
}

/// Whether both sides have signs of two branches, and are no measured values: `2.0\pm0.1`.
fn has_branches(sides: [&PrintedSide; 2]) -> bool {
    let has = |side: &PrintedSide| side.branch_signs() > 0 && !names(side).is_empty();
    sides.into_iter().all(has) && !sides.iter().any(|side| side.text.contains('.'))
}

/// One formula for both signs, where two differ in signs alone.
fn merged(upper: &str, lower: &str) -> Option<String> {
    if upper.chars().count() != lower.chars().count() {
        return None;
    }
    let one = |(a, b): (char, char)| match (a, b) {
        _ if a == b => Some(a.to_string()),
        ('+', '-') => Some(r"\pm ".to_owned()),
        ('-', '+') => Some(r"\mp ".to_owned()),
        _ => None,
    };
    upper.chars().zip(lower.chars()).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_that_differ_in_signs_are_one() {
        assert_eq!(merged("a+b-c", "a-b+c").as_deref(), Some(r"a\pm b\mp c"));
        assert_eq!(merged("a+b", "a+b").as_deref(), Some("a+b"));
        assert_eq!(merged("a+b", "a*b"), None);
        assert_eq!(merged("a+b", "a-2b"), None);
    }
}
