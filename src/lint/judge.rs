//! The words: relation by relation, in the order of the paper.

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;

use meter::Limits;
use paper::{Opening, Paper, PrintedRelation, PrintedSide, names};

use super::blame::{OfStep, Whole};
use super::cases::{Cases, Stance};
use super::chain::{Slip, said};
use super::desk::{Given, evidence_of};
use super::facts::{Facts, Reach, Stated};
use super::kinds::{Unsigned, other_kind, unsigned};
use super::lone::{is_equation_of_motion, lone_name, unprimed};
use super::nearest::{Sureness, WrongStep};
use super::notation::Evidence;
use super::refusal::NotRead;
use super::relation::{defines_no_name, free_indices, gives_values, is_congruence, is_letter_at_place, lone_right};
use super::sentence::{Sentence, explains, is_assumed, is_supposed, parts};
use super::setting::Noted;
use super::signs::{COMPARES, EQUALS, is_about, is_one_of};
use super::space::General;
use super::standing::{Standing, standings};
use super::step::{Blame, Place, Step};
use super::{Judgement, Lint, Word};

/// Longest side, in bytes, that is looked at.
pub(super) const LONGEST: usize = 1500;
/// Relations behind a display that may explain its names.
pub(super) const MOST_EXPLAINED: usize = 8;

/// The words on every relation that a paper prints. What the limits end is *not followed*: all of the paper together may take as much as a
/// file may.
pub fn lint(paper: &Paper, limits: &Limits) -> Lint {
    let evidence = evidence_of(paper, limits);
    let facts = Facts::default();
    let parts = parts(paper);
    let mut judge = Judge {
        paper,
        evidence,
        facts,
        unsigned: unsigned(paper, &parts),
        parts,
        standings: standings(paper),
        section: 0,
        exhausted: 0,
        display: None,
        earlier: None,
        named: by_name(paper),
        cases: Vec::new(),
        compared: Vec::new(),
        supposed: Vec::new(),
    };
    // Words that stand alone in a display are no formula.
    let is_formula = |at: &usize| paper.printed[*at].sides.iter().any(|s| s.is_whole_display() || !s.text.is_empty());
    let judgements = (0..paper.printed.len()).filter(is_formula).map(|at| judge.relation(at)).collect();
    Lint { judgements }
}

pub(super) struct Judge<'p> {
    pub(super) paper: &'p Paper,
    pub(super) evidence: Evidence,
    pub(super) facts: Facts,
    /// The displayed relations by their labels and numbers.
    named: HashMap<String, Vec<usize>>,
    /// The part of each relation in which its names mean the same.
    pub(super) parts: Vec<usize>,
    /// The names that may not be positive, by these parts.
    pub(super) unsigned: HashMap<usize, Unsigned>,
    /// How each relation is said.
    pub(super) standings: Vec<Standing>,
    /// The part that is looked at.
    pub(super) section: usize,
    /// Questions that took too much work.
    pub(super) exhausted: usize,
    /// The display that is looked at, and what the words around it say.
    pub(super) display: Option<OfDisplay>,
    /// The place of the last relation of a display.
    earlier: Option<Range<usize>>,
    /// The cases of each file.
    pub(super) cases: Vec<(std::sync::Arc<diag::Source>, Cases)>,
    /// Comparisons, with their names: until when they hold is not known.
    pub(super) compared: Vec<Noted>,
    /// Equations that are supposed in the running text, "if $a=b$", with their names.
    pub(super) supposed: Vec<Noted>,
}

/// A display, and what the words around it say.
pub(super) struct OfDisplay {
    pub(super) number: usize,
    /// From its first formula to its last.
    pub(super) place: Range<usize>,
    sentence: Sentence,
}

/// What became of the steps of a relation.
#[derive(Default)]
struct Tally {
    /// Names that nothing defines.
    open: Vec<String>,
    /// Why a step was not read.
    unread: Option<NotRead>,
    /// Steps that are proved.
    follows: usize,
    /// Steps that hold in numbers.
    numbers: usize,
    /// Whether a proof is one for positive names.
    of_positive: bool,
    /// Names by which proofs divide.
    divided_by: BTreeSet<String>,
    /// What proofs read more generally than it is meant.
    general: General,
    /// Whether a name is defined.
    defines: bool,
    /// The relation that defined it before.
    anew: Option<usize>,
    /// What was said of it before, where this definition is a slip away from that.
    differs: Option<String>,
}

/// The displayed relations by their labels and numbers, with and without parentheses.
fn by_name(paper: &Paper) -> HashMap<String, Vec<usize>> {
    let mut out: HashMap<String, Vec<usize>> = HashMap::new();
    for (at, relation) in paper.printed.iter().enumerate().filter(|(_, r)| r.display.is_some()) {
        for name in [&relation.label, &relation.tag].into_iter().flatten() {
            for name in [name.as_str(), name.trim_matches(['(', ')'])] {
                out.entry(name.to_owned()).or_default().push(at);
            }
        }
    }
    out
}

/// Says *wrong*, with what shows it.
fn be_wrong(out: &mut Judgement, wrong: WrongStep, why: &str) {
    out.word = Word::Wrong;
    out.why = why.to_owned();
    out.witness = Some(wrong.witness);
    out.instead = Some(wrong.instead);
    out.picture = wrong.picture;
    out.with = wrong.with;
}

impl Judge<'_> {
    fn relation(&mut self, at: usize) -> Judgement {
        let relation = &self.paper.printed[at];
        self.section = self.parts[at];
        let mut out = Judgement {
            relation: at,
            word: Word::NotRead,
            span: relation.span(),
            why: String::new(),
            witness: None,
            instead: None,
            picture: None,
            with: Vec::new(),
            steps: (0, 0),
            chain: Vec::new(),
        };
        if relation.sides.len() < 2 {
            let is_long = relation.sides.iter().any(PrintedSide::is_whole_display);
            let why = if is_long { "longer than is taken apart" } else { "a formula that relates nothing" };
            out.why = why.to_owned();
            return out;
        }
        if let Some(why) = &relation.unread {
            out.why = why.clone();
            // What it may define is not known any more.
            self.define(relation, at);
            return out;
        }
        if self.evidence.has_modulus() && relation.signs.iter().any(|s| is_congruence(s)) {
            out.why = "a congruence, or an equation".to_owned();
            return out;
        }
        self.unbind(relation);
        let is = |list: &[&str], sign: &String| is_one_of(list, sign);
        if let Some(sign) = relation.signs.iter().find(|s| !is(EQUALS, s) && !is_about(s) && !is(COMPARES, s)) {
            out.why = format!("the sign `{}`", diag::escape::in_one_line(sign));
            return out;
        }
        // That a name is positive is known to the proofs.
        let is_sign = relation.sides.len() == 2
            && (relation.signs[0] == ">"
                && relation.sides[1].text.trim() == "0"
                && lone_name(&relation.sides[0]).is_some()
                || relation.signs[0] == "<"
                    && relation.sides[0].text.trim() == "0"
                    && lone_name(&relation.sides[1]).is_some());
        if relation.signs.iter().any(|s| is(COMPARES, s)) && !is_sign {
            let all = relation.sides.iter().flat_map(names).map(|n| n.key()).collect();
            self.compared.push(Noted { section: self.section, relation: at, names: all });
        }
        if relation.signs.iter().all(|s| is(COMPARES, s)) || self.standings[at] == Standing::Condition {
            out.word = Word::Condition;
            self.note_signs(relation, at);
            self.suppose(relation, at);
            return out;
        }
        if relation.sides.iter().any(|s| s.text.len() > LONGEST) {
            out.why = "a formula that is too long".to_owned();
            return out;
        }
        if let Some(ended) = self.evidence.ended() {
            (out.word, out.why) = (Word::NotFollowed, ended.to_string());
            return out;
        }
        // A letter before two places, each of which is a side of a chain with it, is a function.
        let all: Vec<&PrintedSide> = relation.sides.iter().filter(|s| is_letter_at_place(s)).collect();
        if let Some(found) = self.evidence.obstacle_together(&all) {
            out.why = found.feature;
            return out;
        }
        if let Some(why) = other_kind(self.paper, relation) {
            out.why = why;
            return out;
        }
        let sentence = self.sentence(relation, at);
        let taken = match self.stance(relation, at) {
            Stance::Denied => Some("the words around it deny it"),
            Stance::Asked => Some("it is asked, or one of several answers"),
            Stance::Said if self.is_alternative(at) => Some("one of several that are possible"),
            Stance::Said => None,
        };
        if let Some(why) = taken {
            out.word = Word::Condition;
            out.why = why.to_owned();
            return out;
        }
        let before = self.facts.given.len();
        self.explain(relation, at);
        let open = self.steps(relation, at, &sentence, &mut out);
        self.facts.given.truncate(before);
        if !matches!(out.word, Word::Follows | Word::Wrong | Word::NotRead)
            && let Some(wrong) = self.misses_root(relation, at, &sentence)
        {
            out.span = relation.sides[1].span.clone();
            be_wrong(&mut out, wrong, "the equation before it has one solution, at which it fails");
        }
        if out.word != Word::Wrong && relation.signs.iter().any(|s| is_about(s)) {
            out.word = Word::Approximates;
        } else if out.word != Word::Wrong && relation.signs.iter().any(|s| is(COMPARES, s)) {
            out.word = Word::Condition;
        }
        let inline = relation.display.is_none();
        if out.word == Word::Follows && inline && is_assumed(self.paper, relation) {
            (out.word, out.why) = (Word::Condition, "what is supposed does not follow".to_owned());
        }
        if out.word != Word::Wrong
            && !sentence.loosens
            && !sentence.aims
            && self.standings[at] == Standing::Stated
            && !(inline && is_supposed(self.paper, relation))
            && !self.is_no_premise(relation)
        {
            self.state(relation, at, &open);
        }
        if inline && is_supposed(self.paper, relation) {
            self.suppose(relation, at);
        }
        if out.word == Word::Defines && self.standings[at] != Standing::Stated {
            (out.word, out.why) = (Word::Condition, "only where the condition beside it holds".to_owned());
        }
        // One name for another in the running text is a case more often than a definition.
        let is_rate = |n: &paper::PaperName| n.dots > 0 || n.derived_by.is_some();
        if !sentence.aims && !(inline && lone_name(&relation.sides[1]).is_some_and(|n| !is_rate(&n))) {
            self.define(relation, at);
        }
        out
    }

    /// What the words around the display of a relation say; a formula of the running text has none.
    fn sentence(&mut self, relation: &PrintedRelation, at: usize) -> Sentence {
        let Some(number) = relation.display else { return Sentence::default() };
        if self.display.as_ref().is_none_or(|known| known.number != number) {
            let sentence = Sentence::of(self.paper, &relation.span(), self.earlier.as_ref());
            self.display = Some(OfDisplay { number, place: self.place_of_display(at), sentence });
        }
        self.earlier = Some(relation.span());
        let sentence = self.display.as_ref().map(|known| known.sentence.clone()).unwrap_or_default();
        relation.sides.first().map_or(Sentence::default(), |side| sentence.of_side(side))
    }

    /// Takes the definitions that a "where" behind a display gives of its names.
    fn explain(&mut self, relation: &PrintedRelation, at: usize) {
        if relation.display.is_none() {
            return;
        }
        let paper = self.paper;
        let behind = paper.printed.iter().enumerate().skip(at + 1).take(MOST_EXPLAINED);
        for (k, other) in behind {
            if other.display == relation.display {
                if other.opening == Some(Opening::Meaning) {
                    self.define(other, k);
                }
                continue;
            }
            if other.display.is_some() || self.parts[k] != self.parts[at] || !explains(paper, relation, other) {
                break;
            }
            self.define(other, k);
        }
    }

    /// Notes the equations that a relation states and that are not proved.
    fn state(&mut self, relation: &PrintedRelation, at: usize, open: &[usize]) {
        for &k in open {
            let (left, right) = (&relation.sides[k - 1], &relation.sides[k]);
            let mut keys: BTreeSet<String> = names(left).iter().map(|n| n.key()).collect();
            keys.extend(names(right).iter().map(|n| n.key()));
            let is_value = names(right).is_empty() && lone_name(left).is_some();
            // An equation for an eigenvector says that it is 0, where it is of a matrix that can be inverted.
            let is_homogeneous = right.text.trim() == "0" && left.text.contains("matrix}");
            if !is_value && !left.is_list && !right.is_list && !is_homogeneous {
                let (left, right, section) = (left.clone(), right.clone(), self.parts[at]);
                let in_text = relation.display.is_none();
                self.facts.state(Stated { left, right, relation: at, section, names: keys, in_text });
            }
        }
    }

    /// Decides the steps of a relation from side to side. The later sides of those that are read and that nothing decides.
    fn steps(&mut self, relation: &PrintedRelation, at: usize, sentence: &Sentence, out: &mut Judgement) -> Vec<usize> {
        let free = free_indices(relation);
        let first = lone_name(&relation.sides[0]);
        let inline = relation.display.is_none();
        let named = self.named(sentence, at);
        let concludes = sentence.concludes || relation.remark.as_deref().is_some_and(|r| r.contains('⇒'));
        let mut tally = Tally::default();
        let mut open = Vec::new();
        let mut slip: Option<Slip> = None;
        let (whole, mut integrated) = (Whole::of(relation), false);
        for k in 1..relation.sides.len() {
            let (left, right) = (&relation.sides[k - 1], &relation.sides[k]);
            integrated |= left.text.contains(r"\int");
            let sign = &relation.signs[k - 1];
            if !EQUALS.contains(&sign.as_str()) {
                let word = if is_about(sign) { Word::Approximates } else { Word::Condition };
                out.chain.push(said(right.span.clone(), word));
                continue;
            }
            let known = first.as_ref().is_some_and(|n| {
                let same_section = |g: &Given| !g.is_rate && g.section == self.section;
                n.dots == 0 && self.facts.given.of(&n.key()).any(same_section)
            });
            let defining = k == 1 && first.is_some() && !known;
            let derived = k == 1 && self.is_derived(left);
            let is_stated = defining && self.is_stated(first.as_ref(), right, at);
            if defining {
                // Whether it can be read is all that there is to say of it.
                tally.defines = true;
                let rate = self.is_rate(first.as_ref());
                match self.readable(left, right, &free) {
                    Err(found) => tally.unread = Some(found),
                    Ok(()) if !concludes && !rate => {
                        out.chain.push(said(right.span.clone(), Word::Defines));
                        continue;
                    }
                    Ok(()) => {}
                }
                let is_asked = rate && !inline && !self.facts.given.is_empty() || concludes && is_stated;
                if !derived && !is_asked {
                    let word = if tally.unread.is_some() { Word::NotRead } else { Word::Defines };
                    out.chain.push(said(right.span.clone(), word));
                    continue;
                }
            }
            out.steps.1 += 1;
            // What equations before are solved for is no choice.
            let solved = concludes && !sentence.changes && is_stated;
            let alone = relation.sides.len() == 2 && (first.is_none() || defining);
            let of = OfStep { relation, k, sentence, defining, derived, solved, alone, integrated, whole: &whole };
            // `y'=-ky` may be another equation than the one before, unless its sentence concludes.
            let is_another = k == 1 && (!concludes || sentence.changes) && is_equation_of_motion(left, right);
            let blame = if is_another && !derived { Blame::Nothing } else { self.blame(&of, at) };
            let concludes = concludes && !(self.is_inexact(&of, at) && !defining);
            // What is said again is no step from itself.
            if let Some(before) = self.same_definition(first.as_ref().filter(|_| k == 1 && known), right) {
                out.steps.1 -= 1;
                tally.defines = true;
                tally.anew = Some(before);
                out.chain.push(said(right.span.clone(), Word::Defines));
                continue;
            }
            let solves = defining && !self.is_rate(first.as_ref());
            let reach = if alone { Reach::Near { section: self.section, at } } else { Reach::Paper };
            let concludes = concludes && !sentence.changes && self.is_the_same_case(first.as_ref(), at);
            let sureness = self.sureness(&of, concludes);
            let blame = match sureness {
                Sureness::Stands | Sureness::Chain if !self.is_asserted(relation, at) => Blame::Nothing,
                _ => blame,
            };
            let place = Place {
                at,
                free: &free,
                named: named.clone(),
                blame,
                sureness,
                concludes,
                reach,
                is_first: k == 1,
                solves,
            };
            let mut step = self.in_either_base(|judge| judge.step([left, right], &place));
            if let (Some(slip), false) = (&mut slip, matches!(step, Step::Follows(_))) {
                step = self.behind_slip(relation, slip, k, &place).unwrap_or(step);
            }
            let word = match step {
                Step::Open(_) if defines_no_name([left, right], sign).is_some() => {
                    tally.unread = defines_no_name([left, right], sign).map(NotRead::of);
                    Word::NotRead
                }
                Step::Follows(support) => {
                    tally.follows += 1;
                    out.steps.0 += 1;
                    tally.of_positive |= support.of_positive;
                    tally.divided_by.extend(support.divided_by);
                    tally.general = tally.general.or(support.general);
                    out.with.extend(support.with);
                    if defining {
                        tally.defines = false;
                    }
                    Word::Follows
                }
                Step::Numbers => {
                    tally.numbers += 1;
                    Word::Numbers
                }
                // Said otherwise than in its definition, it may be of another thing.
                Step::Wrong(wrong) if k == 1 && self.contradicts_definition(first.as_ref(), &wrong, &place) => {
                    out.steps.1 -= 1;
                    tally.defines = true;
                    let before = first.as_ref().and_then(|n| self.latest_definition(n));
                    tally.anew = before.map(|g| g.relation);
                    tally.differs = before.map(|g| format!("before it was {}", g.right.text));
                    Word::Defines
                }
                // An equation of motion of what has a formula: it may be of another motion.
                Step::Wrong(wrong) if is_another => {
                    out.steps.1 -= 1;
                    tally.defines = true;
                    let before = first.as_ref().and_then(|n| self.latest_definition(&unprimed(n)));
                    tally.anew = before.map(|g| g.relation);
                    tally.differs = before.map(|_| format!("its formula gives {}", wrong.instead));
                    Word::Defines
                }
                Step::Wrong(wrong) => {
                    if slip.is_none() {
                        slip = Some(Slip { wrong: *wrong, k, is_taken_back: false });
                    }
                    Word::Wrong
                }
                // Said otherwise than before, of a name alone: it is defined anew.
                Step::Open(_) if k == 1 && known => {
                    out.steps.1 -= 1;
                    tally.defines = true;
                    let before = first.as_ref().and_then(|n| self.latest_definition(n)).cloned();
                    tally.anew = before.as_ref().map(|g| g.relation);
                    if blame == Blame::Steps
                        && !sentence.changes
                        && !names(right).is_empty()
                        && first.as_ref().is_some_and(|n| n.dots + n.primes == 0 && n.derived_by.is_none())
                    {
                        tally.differs = before.and_then(|g| self.slip_from([left, right], &g, &place));
                    }
                    Word::Defines
                }
                Step::Open(names) if !defining => {
                    open.push(k);
                    tally.open.extend(names);
                    Word::NotFollowed
                }
                // What cannot be asked was read as a definition.
                Step::NotRead(_) if defining && tally.unread.is_none() => {
                    out.steps.1 -= 1;
                    Word::Defines
                }
                Step::Open(_) => {
                    out.steps.1 -= 1;
                    Word::Defines
                }
                Step::NotRead(found) => {
                    tally.unread = Some(found);
                    Word::NotRead
                }
            };
            out.chain.push(said(right.span.clone(), word));
        }
        if let Some(slip) = slip {
            out.span = relation.sides[slip.side(&out.chain)].span.clone();
            let why = match slip.wrong.witness.values.is_empty() {
                true => "reckoned, its sides differ",
                false => "false at a point; with one change it is proved",
            };
            let wrong = slip.told(relation, &out.chain);
            be_wrong(out, wrong, why);
            return Vec::new();
        }
        // The second rate of a name is an equation of motion.
        let is_second = first.as_ref().is_some_and(|n| n.dots > 1 || n.primes > 1);
        // What has its own name on the other side is an equation for it.
        let is_implicit = relation.sides.len() == 2
            && first.as_ref().is_some_and(|n| {
                n.dots == 0 && n.derived_by.is_none() && names(&relation.sides[1]).iter().any(|m| m.key() == n.key())
            });
        if tally.defines && (is_second || is_implicit) && tally.unread.is_none() && open.is_empty() {
            open.push(1);
        }
        self.conclude(relation, at, tally, out);
        open
    }

    /// The relations that a sentence names by their labels or numbers.
    fn named(&self, sentence: &Sentence, at: usize) -> Vec<usize> {
        if sentence.names.is_empty() {
            return Vec::new();
        }
        let all = sentence.names.iter().filter_map(|name| self.named.get(name)).flatten();
        let found: BTreeSet<usize> = all.copied().filter(|k| *k != at).collect();
        found.into_iter().collect()
    }

    /// The word, from what became of the steps.
    fn conclude(&self, relation: &PrintedRelation, at: usize, tally: Tally, out: &mut Judgement) {
        let first = lone_name(&relation.sides[0]);
        let inline = relation.display.is_none();
        out.with.sort_unstable();
        out.with.dedup();
        out.with.retain(|w| *w != at);
        let Tally { mut open, unread, follows, numbers, of_positive, divided_by, general, defines, anew, differs } =
            tally;
        let undecided = out.steps.1 - follows - numbers;
        if let Some(found) = unread {
            out.why = match &found.why {
                Some(why) => format!("{}: {why}", found.feature),
                None => found.feature.clone(),
            };
            out.word = if found.ended.is_some() { Word::NotFollowed } else { Word::NotRead };
        } else if undecided > 0 && !defines {
            // An equation between two things that are not defined is what is assumed, or to be solved.
            let single = relation.sides.len() == 2;
            out.word = if single && first.is_none() || inline { Word::Condition } else { Word::NotFollowed };
            open.sort();
            open.dedup();
            if out.word == Word::NotFollowed {
                out.why = match open.is_empty() {
                    true => "nothing above decides it".to_owned(),
                    false => format!("nothing above defines {}", open.join(", ")),
                };
            }
        } else if defines && undecided == 0 {
            out.word = Word::Defines;
        } else if defines {
            out.word = match relation.sides.len() > 2 || out.steps.1 > 1 {
                true if gives_values(relation) => Word::Condition,
                true => Word::NotFollowed,
                false => Word::Defines,
            };
            if out.word == Word::NotFollowed {
                out.why = "a step between its later sides is not decided".to_owned();
            }
        } else {
            out.word = Word::Follows;
        }
        if out.word == Word::Defines && out.steps.0 > 0 {
            out.word = Word::Follows;
        }
        if numbers > 0 && matches!(out.word, Word::Follows | Word::Defines) {
            out.word = Word::Numbers;
            out.why = "not proved, and true at random points".to_owned();
        }
        if let Some(before) = anew.filter(|_| out.word == Word::Defines) {
            let again = lone_right(relation).is_some_and(|right| {
                let same = |g: &Given| g.relation == before && g.right.print() == right.print();
                first.as_ref().is_some_and(|n| self.facts.given.of(&n.key()).any(same))
            });
            (out.word, out.why) = match differs {
                None if again => (out.word, "as before".to_owned()),
                Some(instead) => (Word::Differs, instead),
                None => (out.word, "otherwise than before".to_owned()),
            };
            out.with.push(before);
        }
        let is_proved = matches!(out.word, Word::Follows | Word::NotFollowed);
        let positive = (of_positive && is_proved).then(|| "where its constants are positive".to_owned());
        let divided: Vec<&str> = divided_by.iter().map(String::as_str).collect();
        let is = if divided.len() > 1 { "are" } else { "is" };
        let divided = (!of_positive && is_proved && !divided.is_empty())
            .then(|| format!("where {} {is} positive", divided.join(" and ")));
        let general = general.words().filter(|_| is_proved);
        let words = relation
            .described
            .as_ref()
            .map(|words| format!("the words in the place of a side, “{words}”, are left out"));
        for more in [positive, divided, general, words].into_iter().flatten() {
            out.why = if out.why.is_empty() { more } else { format!("{}; {more}", out.why) };
        }
        let value = relation.sides.len() == 2
            && names(&relation.sides[1]).is_empty()
            && !relation.sides[1].text.contains("matrix}");
        let is_rate = first.as_ref().is_some_and(|n| n.dots > 0 || n.derived_by.is_some());
        if out.word == Word::Defines && !is_rate && (value || lone_name(&relation.sides[1]).is_some()) {
            out.word = Word::Condition;
        }
    }
}
