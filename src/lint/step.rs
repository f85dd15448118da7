//! One step, from side to side: what it is tried with, and whether it is wrong.
//!
//! **In:** two sides, and their [`Place`]. **Out:** a [`Step`]. **Guaranteed:** what follows was proved from what it names; what is wrong is
//! refuted by what this section says, and a formula that is one slip away is proved from the same.

use std::collections::BTreeSet;

use paper::{PrintedSide, names, squeezed};
use proof::Identity;

use super::desk::Given;
use super::facts::{Reach, Stated};
use super::held::{Held, has_open_derivative, held_fixed, hold, lacks_variable, leaves_derivative_free, with_given};
use super::judge::Judge;
use super::lone::lone_name;
use super::nearest::{Sureness, WrongStep, introduces_nothing, is_slip_of, nearest};
use super::numbers::agreement;
use super::question::{Asked, Positive, Rests, ask};
use super::refusal::NotRead;
use super::relation::moved;
use super::setting::keys;
use super::space::General;

/// Random points at which a step that is not proved is tried.
const POINTS: usize = 40;
/// Relations before a conclusion that its sentence may name.
pub(super) const IN_SENTENCE: usize = 3;
/// Relations right behind another, which list several values of one name.
const NEIGHBOURS: usize = 3;
/// Steps that may take too much work before equations that the paper states are left alone.
const MOST_EXHAUSTED: usize = 4;

/// The outcome of a step.
pub(super) enum Step {
    /// Proved.
    Follows(Support),
    /// Not proved, and true at random points.
    Numbers,
    /// Refuted, and one slip away from what holds.
    Wrong(Box<WrongStep>),
    /// Nothing decides it; the names that have no definition.
    Open(Vec<String>),
    NotRead(NotRead),
}

/// The relations that a proof rests on.
pub(super) struct Support {
    /// Relations.
    pub(super) with: Vec<usize>,
    /// Whether all that does not depend on time was taken to be positive.
    pub(super) of_positive: bool,
    /// Names of equations that a proof divides by, and takes to be positive.
    pub(super) divided_by: BTreeSet<String>,
    /// What was read more generally than it is meant.
    pub(super) general: General,
}

impl Support {
    /// What two proofs rest on together.
    pub(super) fn and(mut self, other: Support) -> Support {
        self.with.extend(other.with);
        self.with.sort_unstable();
        self.with.dedup();
        self.divided_by.extend(other.divided_by);
        let (of_positive, general) = (self.of_positive || other.of_positive, self.general.or(other.general));
        Support { of_positive, general, ..self }
    }
}

/// Of what *wrong* may be said.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Blame {
    /// Of nothing: what is defined here, or need not be exact.
    Nothing,
    /// Of what is wrong whatever its names stand for: in the running text much is a case, or a condition.
    Identities,
    /// Of everything that this section refutes.
    Steps,
}

/// Where a step stands.
pub(super) struct Place<'a> {
    pub(super) at: usize,
    pub(super) free: &'a BTreeSet<char>,
    /// The equations that its sentence names.
    pub(super) named: Vec<usize>,
    /// Of what *wrong* may be said.
    pub(super) blame: Blame,
    /// How sure it is that something is claimed.
    pub(super) sureness: Sureness,
    /// Whether its words conclude from what stands before it, in the same case.
    pub(super) concludes: bool,
    /// How far back a proof may reach.
    pub(super) reach: Reach,
    /// Whether it is the first step of its relation.
    pub(super) is_first: bool,
    /// The value of a name is found: its sign is part of what is said.
    pub(super) solves: bool,
}

impl Judge<'_> {
    /// Decides one step, of whose sides each is one formula.
    pub(super) fn step_of_one(&mut self, sides: [&PrintedSide; 2], place: &Place) -> Step {
        if let Some(ended) = self.evidence.ended() {
            return Step::NotRead(NotRead::ended(ended));
        }
        if sides.iter().any(|s| has_roots(&s.text)) && self.may_be_complex(keys(sides).iter()) {
            return Step::NotRead(NotRead::of("a root, a logarithm or an absolute value of what may not be real"));
        }
        let mut first_refusal = None;
        let mut asked: Vec<(Asked, Rests)> = Vec::new();
        for rests in self.supports(sides, place, place.reach) {
            match self.ask(sides, &rests, place.free) {
                Err(found) => {
                    first_refusal.get_or_insert(found);
                }
                // `\partial L/\partial x=0` of $L=T-V$: that T and V have no x is said nowhere.
                Ok(answer) if answer.is_proved() && !self.may_hold_fixed(&answer.desk.held, place.at) => {
                    first_refusal.get_or_insert(NotRead::of("a derivative of what may vary"));
                }
                Ok(answer) if answer.is_proved() && !lacks_variable(sides, &rests.given) => {
                    return Step::Follows(Support { general: answer.desk.general, ..support(sides, &rests) });
                }
                Ok(answer) if answer.is_proved() => {
                    first_refusal.get_or_insert(NotRead::of("a derivative by what the definition does not show"));
                }
                Ok(answer) => asked.push((answer, rests)),
            }
        }
        if asked.is_empty() {
            return Step::NotRead(first_refusal.unwrap_or_else(|| NotRead::of("something")));
        }
        // Of squares of sums the roots would be taken: these may be of vectors.
        let of_squares = |s: &Stated| [&s.left, &s.right].iter().any(|side| squeezed(&side.text).contains(")^2"));
        let are_plain = |r: &Rests| !r.stated.is_empty() && !r.stated.iter().any(of_squares);
        let needs_signs = sides.iter().any(|s| has_roots(&s.text)) || asked.iter().any(|(_, r)| are_plain(r));
        if needs_signs
            && !place.solves
            && !self.may_be_negative(keys(sides).iter())
            && let Some(found) = self.of_positive(sides, &asked, place)
        {
            return found;
        }
        let defined: BTreeSet<String> = asked.iter().flat_map(|(_, r)| r.given.iter().map(|g| g.key.clone())).collect();
        if asked.iter().any(|(answer, _)| holds_in_numbers(answer)) {
            return Step::Numbers;
        }
        if place.blame != Blame::Nothing
            && let Some(wrong) = self.wrong(sides, place, &mut asked)
        {
            return Step::Wrong(Box::new(wrong));
        }
        let mut open: Vec<String> = sides.into_iter().flat_map(names).map(|n| n.key()).collect();
        open.retain(|key| !defined.contains(key));
        Step::Open(open)
    }

    /// What a step is tried with, one after the other: nothing, the definitions of its names, their rates, what the paper states.
    fn supports(&mut self, sides: [&PrintedSide; 2], place: &Place, reach: Reach) -> Vec<Rests> {
        let positive = Positive::Named(self.facts.positive(self.section));
        let rests = |given, stated| Rests { given, stated, positive: positive.clone() };
        let mut out = vec![rests(Vec::new(), Vec::new())];
        let has_rates = sides.into_iter().flat_map(names).any(|n| n.dots > 0 || n.derived_by.is_some());
        let is_sure = matches!(reach, Reach::Here { .. });
        let mut plain = self.facts.definitions(&sides, reach, false);
        let mut with_rates = self.facts.definitions(&sides, reach, has_rates);
        plain.retain(|g| !self.are_parted(g.relation, place.at, is_sure));
        with_rates.retain(|g| !self.are_parted(g.relation, place.at, is_sure));
        // Of what one display defines twice it is not known which is meant.
        for list in [&mut plain, &mut with_rates].into_iter().filter(|_| is_sure) {
            list.retain(|g| !self.is_implied_beside(g, place.at) && !self.is_defined_beside(g, place.free));
            list.retain(|g| !self.is_implied_otherwise(g.relation, place.at));
        }
        hold(&sides, &mut plain);
        hold(&sides, &mut with_rates);
        if !plain.is_empty() {
            out.push(rests(plain.clone(), Vec::new()));
        }
        // `C'(r)` of a formula with V in it, which is held fixed, though it is \pi r^2h.
        if let Some(Held { of, .. }) = held_fixed(&sides, &plain, false) {
            out.push(rests(plain.iter().filter(|g| of.contains(&g.key)).cloned().collect(), Vec::new()));
        }
        if with_rates.len() > plain.len() {
            out.push(rests(with_rates, Vec::new()));
        }
        if self.exhausted > MOST_EXHAUSTED {
            return out;
        }
        let mut stated = self.facts.equations(sides, &plain, place.at, self.section, &place.named, place.concludes);
        stated
            .retain(|s| !self.are_parted(s.relation, place.at, is_sure) && self.may_divide(sides, &plain, s, place.at));
        if is_sure {
            // Equations of one display hold together: one is no step from the other.
            let display = |at: usize| self.display_of(at);
            let own = display(place.at);
            // Another right side of the same left one is said of another case.
            let first = |s: &Stated| self.paper.printed[s.relation].sides.first().map(PrintedSide::print);
            let left = sides[0].print();
            let again = |s: &Stated| left == s.left.print() || first(s).as_ref() == Some(&left);
            stated.retain(|s| !again(s) || place.sureness != Sureness::Stands);
            stated.retain(|s| !self.is_stated_otherwise(s));
            stated.retain(|s| !self.is_implied_otherwise(s.relation, place.at) && !self.is_of_former(s, place.at));
            let is_near = |s: &Stated| place.concludes && s.relation + IN_SENTENCE >= place.at;
            stated.retain(|s| {
                (!s.in_text || is_near(s)) && (place.concludes || own.is_none() || display(s.relation) != own)
            });
        }
        // Definitions of what only the equations name, too.
        let with_definitions = |stated: Vec<Stated>| {
            let all = with_stated(sides, &stated);
            let mut given = self.facts.definitions(&all, reach, false);
            hold(&all, &mut given);
            let mut rests = rests(given, stated.clone());
            let divided_by = divided_by(sides, &rests.given, &rests.stated);
            if let Positive::Named(known) = &mut rests.positive {
                known.extend(divided_by);
            }
            rests
        };
        let singles = if stated.len() > 1 { stated.clone() } else { Vec::new() };
        // Two equations of motion for the same name are two motions: together they say that nothing moves.
        let mut motions: Vec<String> = Vec::new();
        stated.retain(|s| match moved(&[&s.left, &s.right]) {
            Some(name) if motions.contains(&name) => false,
            Some(name) => {
                motions.push(name);
                true
            }
            None => true,
        });
        if !stated.is_empty() {
            out.push(with_definitions(stated.clone()));
            // A definition may be a case that makes both sides zero: what proves the step without it is asked, too, never what refutes it.
            if !plain.is_empty() && !matches!(reach, Reach::Here { .. }) {
                out.push(rests(Vec::new(), stated.clone()));
            }
        }
        out.extend(singles.into_iter().map(|one| with_definitions(vec![one])));
        out
    }

    /// Whether names may be held fixed in what is derived: the paper defines none of them, and prints none as a function of the variable.
    fn may_hold_fixed(&self, held: &BTreeSet<(String, String)>, at: usize) -> bool {
        let (file, _) = self.paper.locate(&self.paper.printed[at].span());
        held.iter().all(|(key, by)| {
            self.facts.given.of(key).next().is_none() && !squeezed(&file.text).contains(&format!("{key}({by}"))
        })
    }

    /// Whether nothing near says that what a step divides an equation by is 0, or negative.
    fn may_divide(&self, sides: [&PrintedSide; 2], given: &[Given], one: &Stated, at: usize) -> bool {
        let divided_by = divided_by(sides, given, std::slice::from_ref(one));
        let is_capital = |key: &String| key.starts_with(|c: char| c.is_ascii_uppercase());
        let has_vector = [&one.left, &one.right].into_iter().flat_map(names).any(|n| n.is_bold);
        // A capital before a vector may be a matrix.
        if has_vector && divided_by.iter().any(is_capital) {
            return false;
        }
        divided_by.is_empty()
            || !self.has_vanishing([&one.left, &one.right], at) && !self.may_be_negative(divided_by.iter())
    }

    pub(super) fn ask(
        &mut self,
        sides: [&PrintedSide; 2],
        rests: &Rests,
        free: &BTreeSet<char>,
    ) -> Result<Asked, NotRead> {
        let found = ask(sides, rests, &self.evidence, free);
        self.exhausted += usize::from(found.as_ref().is_err_and(|e| e.ended.is_some()));
        found
    }

    /// The same questions for names that are positive, where roots and logarithms need that.
    fn of_positive(&mut self, sides: [&PrintedSide; 2], asked: &[(Asked, Rests)], place: &Place) -> Option<Step> {
        for (_, rests) in asked {
            let rests = Rests { positive: Positive::Parameters, ..rests.clone() };
            if let Ok(answer) = self.ask(sides, &rests, place.free)
                && answer.is_proved()
            {
                let general = answer.desk.general;
                return Some(Step::Follows(Support { of_positive: true, general, ..support(sides, &rests) }));
            }
        }
        None
    }

    /// What an earlier definition says, where this one is a slip away from it: letter by letter, or with what defines its names.
    pub(super) fn slip_from(&mut self, sides: [&PrintedSide; 2], before: &Given, place: &Place) -> Option<String> {
        if before.relation + NEIGHBOURS < place.at
            && let Some(instead) = self.slip_of(before, sides[1], place)
        {
            return Some(format!("before it was {instead}"));
        }
        // Said again of the same names it is of another case.
        if self.paper.printed[before.relation].sides.iter().any(|s| keys([s; 2]) == keys([sides[1]; 2])) {
            return None;
        }
        let place = Place { sureness: Sureness::Concludes, named: Vec::new(), ..*place };
        let wrong = self.wrong(sides, &place, &mut Vec::new()).filter(|w| w.with.len() > 1)?;
        Some(format!("with what defines its names before, it is {}", wrong.instead))
    }

    /// The right side of an earlier definition as this one should be, where this one has the same names and is a slip away from it.
    fn slip_of(&mut self, before: &Given, right: &PrintedSide, place: &Place) -> Option<String> {
        if keys([&before.right; 2]) != keys([right; 2]) {
            return None;
        }
        let positive = Positive::Named(BTreeSet::new());
        let rests = Rests { given: Vec::new(), stated: Vec::new(), positive };
        let asked = self.ask([&before.right, right], &rests, place.free).ok()?;
        (!asked.desk.general.is_some() && is_slip_of(&asked)).then(|| before.right.text.clone())
    }

    /// What is wrong, if something is: refuted by what this section says, and one slip away from what it proves.
    fn wrong(&mut self, sides: [&PrintedSide; 2], place: &Place, asked: &mut Vec<(Asked, Rests)>) -> Option<WrongStep> {
        let defined = self.facts.definitions(&sides, place.reach, false);
        let is_open = sides.iter().any(|s| has_open_derivative(&s.text))
            || held_fixed(&sides, &defined, false).is_some()
            || held_fixed(&with_given(&sides, &defined), &defined, true).is_some();
        // Between absolute values and roots, where a name is negative counts.
        // Of numbers alone nothing vanishes.
        let has_names = sides.iter().any(|s| !names(s).is_empty());
        let is_zero = has_names && sides.iter().any(|s| has_zero_term(&s.text)) || self.is_crossed(place.at);
        let vanishes = self.has_vanishing(sides, place.at);
        // What a partial derivative holds fixed differs from factor to factor.
        let partial = sides.iter().map(|s| s.text.matches(r"\partial").count()).sum::<usize>();
        if is_zero || partial > 5 && defined.is_empty() {
            return None;
        }
        // A logarithm has no value where its sign would count.
        if is_open
            || self.is_supposed_of(sides, place.at)
            || sides.iter().any(|s| has_roots(&without_logarithms(&s.text))) && self.is_compared(sides, place.at)
        {
            return None;
        }
        for rests in self.supports(sides, place, Reach::Here { section: self.section, at: place.at }) {
            // Of an identity the zero is tried; of what rests on more it is not known what vanishes with it.
            let needs_none = vanishes || place.blame == Blame::Identities;
            if !introduces_nothing(sides, &rests) || needs_none && rests.are_some() {
                continue;
            }
            // What the left side is said to be before is no premise: it may be that of another thing.
            let left = sides[0].print();
            if place.is_first && place.named.is_empty() && rests.stated.iter().any(|s| s.left.print() == left) {
                continue;
            }
            // An equation may be one of another case than what words between lead to; a definition is one of its name.
            let is_led_to = |s: &Stated| place.named.contains(&s.relation) || self.only_reckons(s.relation, place.at);
            if !rests.stated.iter().all(is_led_to) {
                continue;
            }
            if place.is_first && defines_again(sides[0], &rests)
                || leaves_derivative_free(sides, &defined, &rests.given)
            {
                continue;
            }
            let all = with_stated(sides, &rests.stated);
            let given = self.facts.definitions(&all, place.reach, false);
            if held_fixed(&with_given(&all, &given), &given, true).is_some() {
                continue;
            }
            let known = asked.iter().position(|(_, r)| r.rests_on_the_same(&rests));
            let answer = match known {
                Some(k) => asked.swap_remove(k).0,
                None => match self.ask(sides, &rests, place.free) {
                    Ok(answer) => answer,
                    Err(_) => continue,
                },
            };
            if !matches!(answer.identity, Identity::Refuted(_)) || answer.desk.general.is_some() {
                continue;
            }
            // Where signs matter, it has to fail for positive names, too, and what holds is looked for among these.
            let mut answer = answer;
            if sides.iter().any(|s| has_roots(&s.text) || has_power_of_name(&s.text)) || !rests.stated.is_empty() {
                let positive = Rests { positive: Positive::Parameters, ..rests.clone() };
                match self.ask(sides, &positive, place.free) {
                    Ok(again) if matches!(again.identity, Identity::Refuted(_)) => answer = again,
                    _ => continue,
                }
            }
            if let Some(found) = nearest(answer, &rests, &free_in(sides, &rests, place.free), place.sureness) {
                let relation = &self.paper.printed[place.at];
                let is_meant = self.is_in_another_unit(relation, &found.witness)
                    || self.is_excused(sides, &rests, place)
                    || self.holds_with_another(sides, &rests, place)
                    || rests.given.iter().any(|g| self.is_of_another(sides, g, place));
                return (!is_meant).then_some(found);
            }
        }
        None
    }
}

/// The free indices that stand in a step, or in what it rests on: an index of the defined name that stands nowhere else is a label, as that
/// of `c_p`.
fn free_in(sides: [&PrintedSide; 2], rests: &Rests, free: &BTreeSet<char>) -> BTreeSet<char> {
    let given = rests.given.iter().flat_map(|g| [&g.left, &g.right]);
    let all = sides.into_iter().chain(given).chain(rests.stated.iter().flat_map(|s| [&s.left, &s.right]));
    let printed: BTreeSet<char> = all.flat_map(names).flat_map(|n| n.index_letters()).collect();
    free.intersection(&printed).copied().collect()
}

/// Some sides, and those of equations.
fn with_stated<'s>(sides: [&'s PrintedSide; 2], stated: &'s [Stated]) -> Vec<&'s PrintedSide> {
    sides.into_iter().chain(stated.iter().flat_map(|s| [&s.left, &s.right])).collect()
}

/// Whether a name is said to be something again, which rests on an equation beside its definition, or which is printed with a prime: it is said
/// to be it anew. What follows from definitions alone is a claim.
fn defines_again(left: &PrintedSide, rests: &Rests) -> bool {
    let is_plain = |n: &paper::PaperName| n.dots == 0 && n.derived_by.is_none();
    lone_name(left).filter(is_plain).is_some_and(|n| {
        (n.primes > 0 || !rests.stated.is_empty()) && rests.given.iter().any(|g| g.key == n.key() && !g.is_rate)
    })
}

/// Whether a 0 stands as a term in a side: something vanishes there.
fn has_zero_term(text: &str) -> bool {
    let squeezed = squeezed(text);
    let bytes = squeezed.as_bytes();
    let sign = |c: Option<&u8>| c.is_none_or(|c| matches!(c, b'+' | b'-' | b'(' | b')' | b'[' | b']'));
    bytes.len() > 1
        && (0..bytes.len())
            .any(|i| bytes[i] == b'0' && sign(i.checked_sub(1).and_then(|k| bytes.get(k))) && sign(bytes.get(i + 1)))
}

/// The names of equations that stand on both sides of one, and in no side of a step: it is divided by them.
fn divided_by(sides: [&PrintedSide; 2], given: &[Given], stated: &[Stated]) -> BTreeSet<String> {
    let of = |side: &PrintedSide| names(side).iter().map(|n| n.key()).collect::<BTreeSet<_>>();
    let given = given.iter().flat_map(|g| [&g.left, &g.right]);
    let own: BTreeSet<String> = sides.into_iter().chain(given).flat_map(of).collect();
    let both = stated.iter().flat_map(|s| &of(&s.left) & &of(&s.right));
    both.filter(|key| !own.contains(key)).collect()
}

fn support(sides: [&PrintedSide; 2], rests: &Rests) -> Support {
    let mut with: Vec<usize> = rests.given.iter().map(|g| g.relation).collect();
    with.extend(rests.stated.iter().map(|s| s.relation));
    Support {
        with,
        of_positive: false,
        divided_by: divided_by(sides, &rests.given, &rests.stated),
        general: General::default(),
    }
}

/// Whether a question without premises that is not decided has both sides equal at random points.
fn holds_in_numbers(asked: &Asked) -> bool {
    asked.premises.equations.is_empty()
        && !asked.is_vacuous
        && matches!(asked.identity, Identity::Undecided(_))
        && agreement(&asked.desk.graph, &asked.equations, POINTS).is_some_and(|(valid, all)| all && valid >= POINTS / 2)
}

/// Whether a formula has something that needs signs: a root, a logarithm, a power that is a fraction.
fn has_roots(text: &str) -> bool {
    [r"\sqrt", r"\ln", r"\log", "|", r"\lvert", "/2}", r"^{\frac", "^{1/", "^{-1/"].iter().any(|w| text.contains(w))
}

/// A formula without the commands of logarithms.
fn without_logarithms(text: &str) -> String {
    text.replace(r"\ln", "").replace(r"\log", "")
}

/// Whether something is raised to a power with a letter in it: `a^{m-n}` is real for positive a alone.
fn has_power_of_name(text: &str) -> bool {
    let squeezed = squeezed(text);
    squeezed.split('^').skip(1).any(|rest| {
        let above =
            rest.strip_prefix('{').map_or(rest.get(..1).unwrap_or_default(), |r| r.split('}').next().unwrap_or(r));
        above.contains(|c: char| c.is_ascii_alphabetic())
    })
}
