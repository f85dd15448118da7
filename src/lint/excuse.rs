//! Excuses: what a step that is refuted may mean all the same, and then holds.
//!
//! **In:** a refuted step, and what it rests on. **Out:** whether it holds with a value that is said near it, for the whole numbers that a letter
//! stands for, or as two equations with a space between them. **Guaranteed:** an excuse keeps *wrong* from being said, and makes nothing hold.

use std::collections::BTreeSet;

use paper::{Opening, PrintedSide, names, squeezed};

use super::desk::Given;
use super::facts::Stated;
use super::judge::Judge;
use super::letters::is_charge;
use super::lone::lone_name;
use super::question::Rests;
use super::setting::{BESIDE, keys};
use super::signs::{COMPARES, is_one_of};
use super::standing::is_equation;
use super::step::Place;

/// Values that are tried.
const MOST_VALUES: usize = 6;
/// Letters that stand for whole numbers.
const WHOLE: &[&str] = &["m", "n", "k", "l", "j", "N", "p", "q", r"\ell"];

/// Letters that stand for the identity, beside operators and matrices.
const IDENTITIES: &[&str] = &["I", "E", r"\mathbb{I}", r"\mathbf{1}"];

/// Whether a letter stands in some sides as a factor alone: nobody takes the root of the identity, nor divides by it.
fn are_factors(letter: &str, sides: [&PrintedSide; 2]) -> bool {
    sides.iter().map(|s| squeezed(&s.text)).all(|text| {
        let divides = [r"\frac", r"\sqrt", r"\over", "/"].iter().any(|w| text.contains(w));
        let is_raised = ["^", "_", "("].iter().any(|sign| text.contains(&format!("{letter}{sign}")));
        !divides && !is_raised
    })
}

/// An equation that no relation of the paper says.
pub(super) fn stated(text: &str, at: usize) -> Option<Stated> {
    let paper = paper::parse_pasted("value", text).ok()?;
    let [left, right] = paper.printed.first()?.sides.as_slice() else { return None };
    let (left, right) = (left.clone(), right.clone());
    let names = keys([&left, &right]);
    Some(Stated { left, right, relation: at, section: 0, names, in_text: true })
}

/// The names that stand between bars in some sides, as they are printed.
fn between_bars(sides: [&PrintedSide; 2]) -> Vec<String> {
    let mut out = Vec::new();
    for side in sides {
        let plain = [r"\left", r"\right", r"\lvert", r"\rvert"];
        let text =
            plain.iter().fold(side.text.clone(), |t, c| t.replace(c, if c.ends_with("vert") { "|" } else { "" }));
        out.extend(text.split('|').skip(1).step_by(2).map(|t| t.trim().to_owned()));
    }
    out.retain(|t| !t.is_empty() && !t.contains(['+', '-', '=']));
    out.sort();
    out.dedup();
    out.truncate(MOST_VALUES);
    out
}

impl Judge<'_> {
    /// Whether a step that is refuted holds with the values that are said near it, before or behind, or for every whole number that a letter
    /// for one may be, beside π, or where a space of its print parts two equations.
    pub(super) fn is_excused(&mut self, sides: [&PrintedSide; 2], rests: &Rests, place: &Place) -> bool {
        if self.is_parted_by_space(sides, rests, place) {
            return true;
        }
        let mut own = keys(sides);
        // That `e` is a letter here was seen in its print.
        if is_charge(&sides.map(|s| s.text.as_str())) {
            own.insert("e".to_owned());
        }
        let near = self.values_near(place.at, &own);
        let mut tries: Vec<Vec<Stated>> = near.iter().cloned().map(|one| vec![one]).collect();
        if near.len() > 1 {
            tries.push(near);
        }
        // A letter for the identity is the factor 1.
        let identities = IDENTITIES.iter().filter(|letter| own.contains(**letter) && are_factors(letter, sides));
        tries.extend(identities.filter_map(|letter| Some(vec![stated(&format!("{letter}=1"), place.at)?])));
        // What stands between bars may be negative.
        tries.extend(
            between_bars(sides).iter().filter_map(|of| Some(vec![stated(&format!("|{of}|=-{of}"), place.at)?])),
        );
        if tries.into_iter().any(|more| self.holds_with(sides, rests, more, place)) {
            return true;
        }
        let beside_pi = sides.iter().any(|s| s.text.contains(r"\pi"));
        let mut whole = own.iter().filter(|key| beside_pi && WHOLE.contains(&key.as_str()));
        whole.any(|key| {
            let equals = |value: &str| stated(&format!("{key}={value}"), place.at);
            let values: Option<Vec<Stated>> = ["1", "2", "3"].into_iter().map(equals).collect();
            values.is_some_and(|all| all.into_iter().all(|one| self.holds_with(sides, rests, vec![one], place)))
        })
    }

    /// Whether a step that is refuted holds with what this part says of a name in another place.
    pub(super) fn holds_with_another(&mut self, sides: [&PrintedSide; 2], rests: &Rests, place: &Place) -> bool {
        let mut tries: Vec<Vec<Given>> = Vec::new();
        for (k, given) in rests.given.iter().enumerate() {
            let print = given.right.print();
            let is_other = |g: &&Given| {
                g.relation != given.relation
                    && g.is_rate == given.is_rate
                    && g.section == given.section
                    && g.right.print() != print
            };
            for other in self.facts.given.of(&given.key).rev().filter(is_other).take(MOST_VALUES) {
                let mut all = rests.given.clone();
                all[k] = other.clone();
                tries.push(all);
            }
        }
        tries.truncate(MOST_VALUES);
        tries.into_iter().any(|given| {
            let rests = Rests { given, ..rests.clone() };
            self.ask(sides, &rests, place.free).is_ok_and(|answer| answer.is_proved())
        })
    }

    /// Relations near one that say of a name of it its value, the end of its range, or that it is another one; the nearest first.
    fn values_near(&self, at: usize, own: &BTreeSet<String>) -> Vec<Stated> {
        let all = &self.paper.printed;
        let (from, to) = (at.saturating_sub(2 * BESIDE), (at + 2 * BESIDE + 1).min(all.len()));
        let mut near: Vec<usize> = (from..to).filter(|&k| k != at && all[k].section == all[at].section).collect();
        near.sort_by_key(|k| k.abs_diff(at));
        let mut out: Vec<Stated> = Vec::new();
        let is_own = |s: &PrintedSide| lone_name(s).is_some_and(|n| own.contains(&n.key()));
        let is_number = |s: &PrintedSide| names(s).is_empty() && s.text.chars().any(|c| c.is_ascii_digit());
        for k in near {
            let relation = &all[k];
            let is_case = relation.sides.len() == 2 && relation.opening == Some(Opening::Case) && is_equation(relation);
            let is_beside = k.abs_diff(at) <= BESIDE;
            for (pair, sign) in relation.sides.windows(2).zip(&relation.signs) {
                let [left, right] = pair else { continue };
                let is_value = is_own(left) && is_number(right) || is_own(right) && is_number(left);
                // At zero too much is equal: of a range it is no end that is meant.
                let ends = is_value && !pair.iter().any(|s| squeezed(&s.text) == "0");
                let is_equal = sign == "=" && is_beside || is_one_of(COMPARES, sign) && ends;
                let is_other = relation.sides.len() == 2 && relation.display.is_none() && is_own(left) && is_own(right);
                if is_beside && is_case || is_equal && (is_value || is_other) {
                    let (left, right) = (left.clone(), right.clone());
                    let again =
                        |s: &Stated| [(&s.left, &left), (&s.right, &right)].iter().all(|(a, b)| a.text == b.text);
                    if out.iter().any(again) {
                        continue;
                    }
                    let names = keys([&left, &right]);
                    out.push(Stated { left, right, relation: k, section: self.section, names, in_text: true });
                }
            }
        }
        out.truncate(MOST_VALUES);
        out
    }

    /// Whether two equations stand beside each other, `a=b\,c=d`, and the first of them, or the last, holds by itself.
    fn is_parted_by_space(&mut self, [left, right]: [&PrintedSide; 2], rests: &Rests, place: &Place) -> bool {
        let mut holds = |sides: [&PrintedSide; 2]| self.ask(sides, rests, place.free).is_ok_and(|a| a.is_proved());
        right.parted_at_spaces().iter().any(|[before, _]| holds([left, before]))
            || left.parted_at_spaces().iter().any(|[_, behind]| holds([behind, right]))
    }

    fn holds_with(&mut self, sides: [&PrintedSide; 2], rests: &Rests, more: Vec<Stated>, place: &Place) -> bool {
        let stated = rests.stated.iter().cloned().chain(more).collect();
        let rests = Rests { stated, ..rests.clone() };
        self.ask(sides, &rests, place.free).is_ok_and(|answer| answer.is_proved() || answer.is_vacuous)
    }
}
