//! A card of page one: a claim that does not stand, as it is printed, with the nearest right formula, the motion on which it fails, and
//! both sides along that motion.
//!
//! **In:** a claim with all its readings. **Out:** blocks. What is right is found by the check: a correction, or a reading of the file that
//! holds; that the contrary holds is no correction.

use super::basis::Basis;
use super::digest::{Fate, Reading, Whole};
use super::discrimination::{alone, standing};
use super::finding::{of_step_brief, over_ranges_brief};
use super::form::{Heading, heading};
use super::front::Line;
use super::numbers::{ascii_six, both, count, retold, six, size};
use super::refuting::Refutes;
use super::sketch::Sketch;
use super::story::{StoryBlock, StorySpan, Tone, joined, quiet, roomy, words};
use super::tally::{Standing, declared, motion_title};
use super::wording::dense;
use derivation::{ClaimRole, Derivation, FormKind};
use findings::{ClaimAccount, Correction, Evidence, Residuals, Witness};
use latex::Scope;
use reason::Refuting;

/// Longest formula, in bytes of LaTeX, that page one prints: the whole is in the section on the claim.
const LONGEST: usize = 600;
/// Longest side, in bytes of LaTeX, that stands before its value.
const LONGEST_SIDE: usize = 40;
/// Longest print, in bytes of LaTeX, beside which what holds has room.
const LONGEST_TOGETHER: usize = 36;
/// Longest title of a motion, in letters.
const LONGEST_TITLE: usize = 48;
/// Most fields that are named with what is put in for them.
const MOST_PUT_IN: usize = 3;
/// A side that changes by no more than this share of itself is constant.
const SAME: f64 = 1e-9;

/// Whether a terminal has room for the titles of motions.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Room {
    Everywhere,
    /// On a page, and not on a terminal.
    OnPage,
}

impl Room {
    /// A span for which there may be no room.
    fn span(self, span: StorySpan<'_>) -> StorySpan<'_> {
        match self {
            Room::Everywhere => span,
            Room::OnPage => StorySpan::Roomy(vec![span]),
        }
    }
}

/// A motion that refutes a claim: its name, and what was found on it.
pub(super) struct RefutingMotion<'a> {
    pub name: String,
    evidence: &'a Evidence,
    /// What the claim says of the formula that is refuted.
    kind: FormKind,
}

impl<'a> RefutingMotion<'a> {
    /// The motion that tells most of why a claim fails: the largest residual, else a member of a family.
    pub fn of(derivation: &Derivation, claim: &'a ClaimAccount) -> Option<RefutingMotion<'a>> {
        let (name, evidence) = Self::found(claim)?;
        let kind = kind_at(derivation, claim, evidence.witness.as_ref());
        Some(RefutingMotion { name, evidence, kind })
    }

    fn found(claim: &'a ClaimAccount) -> Option<(String, &'a Evidence)> {
        let residual = |p: &&'a findings::PairAccount| p.verdict.evidence().residual.as_ref().map_or(-1.0, |r| r.max);
        let fails = claim.results.iter().filter(|p| p.verdict.outcome().word() == "fails");
        // Of equals the first.
        let pair = fails.reduce(|a, b| if residual(&b) > residual(&a) { b } else { a });
        if let Some(pair) = pair {
            return Some((pair.trajectory.clone(), pair.verdict.evidence()));
        }
        let (family, member) = claim.families.iter().find_map(|f| Some((f, f.first_failing.as_ref()?)))?;
        Some((format!("member {} of {}", member.number, family.family), member.verdict.evidence()))
    }

    /// The point at which it refutes.
    pub fn witness(&self) -> Option<&'a Witness> {
        self.evidence.witness.as_ref()
    }

    /// Both sides along it, drawn; of constants, and of what was tried at one time, two levels.
    pub fn sketch(&self) -> Option<Sketch> {
        let along = self.series().filter(|_| !self.is_constant());
        let drawn = along.and_then(|series| Sketch::sides(series, self.witness().map(|w| w.t), &self.name));
        drawn.or_else(|| {
            self.witness().and_then(|w| Sketch::levels(w.left, w.right, format!("Both sides on {}", self.name)))
        })
    }

    /// Both sides along it.
    fn series(&self) -> Option<&'a Residuals> {
        self.evidence.series.as_deref()
    }

    /// Whether both sides keep their values along it, as far as it was sampled: then no time is named.
    fn is_constant(&self) -> bool {
        let Some((first, rest)) = self.series().and_then(|s| s.points.split_first()) else { return false };
        let same = |a: f64, b: f64, bound: f64| (a - b).abs() <= bound + SAME * a.abs().max(b.abs());
        !rest.is_empty()
            && rest.iter().all(|p| same(p.left, first.left, p.bound) && same(p.right, first.right, p.bound))
    }

    /// The point in a sentence, with six digits: the motion with its title, the sides by their formulas.
    pub fn says<'s>(&self, derivation: &'s Derivation, scope: &'s Scope, room: Room) -> Vec<StorySpan<'s>> {
        let title = motion_title(derivation, &self.name, LONGEST_TITLE);
        let title = title.map(|t| room.span(StorySpan::Prose(format!(" ({t})"), &derivation.scope, Tone::Quiet)));
        let mut out: Vec<StorySpan<'s>> = std::iter::once(words(format!("On {}", self.name))).chain(title).collect();
        let Some(w) = self.witness() else {
            let why = self.evidence.reason.as_ref().map(|r| format!(": {r}")).unwrap_or_default();
            out.extend([StorySpan::Prose(why, scope, Tone::Plain), words(".")]);
            return out;
        };
        // What is looked for at some time, and not met, may be met in one of its components.
        if w.left == w.right && self.kind == FormKind::Eventually {
            out.push(words(" both sides are the same at no time."));
            return out;
        }
        let constant = self.is_constant();
        if !constant {
            out.extend([words(" at "), StorySpan::Math(format!("t={}", ascii_six(w.t)), scope)]);
        }
        let label = super::wording::label(&w.formula);
        let refutes = Refutes::of(w);
        // What shall never be is refuted where it is, in every component.
        let everywhere = refutes == Refutes::Same && self.kind == FormKind::Never;
        if let Some(component) = label.component.filter(|_| !everywhere) {
            out.push(words(" (component "));
            out.push(StorySpan::Math(component.to_owned(), scope));
            out.push(words(")"));
        }
        let constant = if constant && refutes == Refutes::Apart { "; both constant" } else { "" };
        match refutes {
            Refutes::NoValue => {
                out.extend([words(" "), StorySpan::Math(label.formula.to_owned(), scope), words(" has no value.")]);
                return out;
            }
            // What denies an equation is refuted where the sides agree.
            Refutes::Same => {
                let components = if everywhere && label.component.is_some() { ", in every component" } else { "" };
                let value = if components.is_empty() { format!(" ({})", six(w.left)) } else { String::new() };
                out.push(words(" both sides are equal"));
                out.push(StorySpan::Roomy(vec![words(components)]));
                out.push(words(format!("{value}, and should differ")));
            }
            Refutes::Apart => {
                let sides = label.component.is_none().then(|| sides(label.formula)).flatten();
                let (left, right) = both(w.left, w.right);
                let short = |side: &&str| side.len() <= LONGEST_SIDE;
                match sides {
                    // Beside a number a value says all.
                    Some((side, sign, number)) if sign != "=" && is_number(number) && short(&side) => {
                        out.extend(named_side(": ", Some(side), left, scope));
                        out.push(words(format!(", not {} ", in_words(sign))));
                        out.push(StorySpan::Math(number.to_owned(), scope));
                    }
                    sides => {
                        out.extend(named_side(": left ", sides.map(|s| s.0).filter(short), left, scope));
                        out.extend(named_side(", right ", sides.map(|s| s.2).filter(short), right, scope));
                    }
                }
            }
        }
        // What is exact needs no bound.
        if refutes != Refutes::Same || w.bound != 0.0 {
            out.push(roomy(format!(" (error bound {}{constant})", size(w.bound))));
        }
        out.push(quiet("."));
        out
    }
}

/// What a claim says of the formula that a witness is of.
pub(super) fn kind_at(derivation: &Derivation, claim: &ClaimAccount, witness: Option<&Witness>) -> FormKind {
    let formula = witness.map(|w| dense(super::wording::label(&w.formula).formula));
    let at = claim.formulas.iter().position(|f| Some(dense(f)) == formula).unwrap_or(0);
    heading(claim, declared(derivation, claim), at).0
}

/// A side with its value, and by its formula where that is no number itself.
fn named_side<'s>(lead: &str, formula: Option<&str>, value: String, scope: &'s Scope) -> Vec<StorySpan<'s>> {
    let mut out = vec![words(lead.to_owned())];
    if let Some(formula) = formula.filter(|f| !is_number(f)) {
        out.extend([StorySpan::Math(formula.to_owned(), scope), words(" = ")]);
    }
    out.push(StorySpan::Words(value, Tone::Strong));
    out
}

/// Whether a formula is a number: its value says all.
fn is_number(formula: &str) -> bool {
    formula.chars().all(|c| c.is_ascii_digit() || "+-. ^{}".contains(c))
}

/// The sides of a relation, where it has two, with the sign between them.
fn sides(formula: &str) -> Option<(&str, &str, &str)> {
    let signs = ["=", "<", ">", r"\le ", r"\ge ", r"\leq ", r"\geq "];
    let mut found = signs.iter().flat_map(|sign| formula.match_indices(sign));
    let (at, sign) = found.next()?;
    if found.next().is_some() {
        return None;
    }
    let (left, right) = (formula[..at].trim(), formula[at + sign.len()..].trim());
    (!left.is_empty() && !right.is_empty()).then_some((left, sign, right))
}

/// The sign of an inequality in words.
fn in_words(sign: &str) -> &'static str {
    match sign.trim() {
        "<" => "below",
        ">" => "above",
        r"\le" | r"\leq" => "at most",
        _ => "at least",
    }
}

/// How many powers of ten the sides of a claim that fails differ by less than they are large, at the point that refutes it; 0 where
/// no such point is known, and where the sides should differ.
pub(super) fn error_decades(claim: &ClaimAccount) -> u32 {
    let witness = RefutingMotion::found(claim).and_then(|(_, evidence)| evidence.witness.as_ref());
    witness.map_or(0, |w| decades_apart(w.left, w.right, w.bound))
}

/// The same of two sides: 0 where they differ by a tenth or more, and where their difference is not known from 0.
fn decades_apart(left: f64, right: f64, bound: f64) -> u32 {
    let apart = (left - right).abs();
    let share = apart / left.abs().max(right.abs());
    if apart > bound && share > 0.0 { (-pxfm::f_log10(share)).floor().clamp(0.0, 300.0) as u32 } else { 0 }
}

/// The formula of a claim that is shown: that of the witness, or of the correction; else the first.
pub(super) fn shown_formula(claim: &ClaimAccount, correction: Option<&Correction>) -> usize {
    let witness = RefutingMotion::found(claim).and_then(|(_, e)| e.witness.as_ref()).map(|w| dense(&w.formula));
    let wanted = correction.map(|c| dense(&c.printed)).or(witness);
    let is_wanted = |f: &String| wanted.as_ref().is_some_and(|w| *w == dense(f));
    claim.formulas.iter().position(is_wanted).unwrap_or(0)
}

/// A formula of a claim with what is said of it.
pub(super) fn formula_of<'a>(
    derivation: &'a Derivation,
    claim: &'a ClaimAccount,
    at: usize,
) -> Option<FormulaShown<'a>> {
    let declared = declared(derivation, claim);
    let scope = declared.map_or(&derivation.scope, |d| &d.scope);
    let text = claim.formulas.get(at)?;
    let (_, of) = heading(claim, declared, at);
    let (lead, formula) = match of {
        Heading::Words(lead) => (lead, Some(text.clone()).filter(|t| t.len() <= LONGEST)),
        Heading::System => {
            let system = derivation.systems.iter().find(|s| s.id == text.trim());
            let equation = system.and_then(|s| s.equations.first()).map(|e| e.text.clone());
            (format!("The motion solves the system {text}"), equation.filter(|t| t.len() <= LONGEST))
        }
        Heading::Trajectory => (format!("The motion is that of {text}"), None),
    };
    Some(FormulaShown { lead, formula, scope, more: claim.formulas.len().saturating_sub(1) })
}

/// A formula as it is shown.
pub(super) struct FormulaShown<'a> {
    /// What is said of it.
    lead: String,
    formula: Option<String>,
    scope: &'a Scope,
    /// How many formulas more the claim has.
    more: usize,
}

impl<'a> FormulaShown<'a> {
    /// Whether there is a formula of at most so many bytes.
    pub fn is_within(&self, most: usize) -> bool {
        self.formula.as_ref().is_some_and(|f| f.len() <= most)
    }

    /// The line, the formula marked where it differs from another.
    pub fn spans(&self, beside: Option<&str>, wrong: bool) -> Vec<StorySpan<'a>> {
        let mut out = Vec::new();
        if self.lead != "At every time" || self.formula.is_none() {
            let colon = if self.formula.is_some() { ": " } else { "" };
            out.push(StorySpan::Prose(format!("{}{colon}", self.lead), self.scope, Tone::Quiet));
        }
        out.extend(self.formula.clone().map(|formula| match beside {
            Some(beside) => StorySpan::Marked { formula, beside: beside.to_owned(), scope: self.scope, wrong },
            None => StorySpan::Math(formula, self.scope),
        }));
        if self.more > 0 {
            let formulas = if self.more == 1 { " formula" } else { " formulas" };
            out.extend([quiet(format!(" and {} more", self.more)), roomy(formulas)]);
        }
        out
    }
}

/// The nearest right formula, with how it is known; what the file offers where no correction was found.
fn right<'a>(
    derivation: &'a Derivation,
    whole: &Whole<'a>,
    failing: &'a ClaimAccount,
    correction: Option<&'a Correction>,
) -> Option<Vec<StorySpan<'a>>> {
    if let Some(c) = correction {
        let scope = declared(derivation, failing).map_or(&derivation.scope, |d| &d.scope);
        let is_located = is_located(failing, c);
        let alone = alone(failing, c).unwrap_or_else(|| " instead".to_owned());
        let mut out = vec![quiet(format!("holds{alone}: "))];
        let (formula, beside) = (c.formula.clone(), c.printed.clone());
        out.push(match is_located {
            true => StorySpan::Marked { formula, beside, scope, wrong: false },
            false => StorySpan::Math(formula, scope),
        });
        out.push(quiet(format!(", {}", standing(c).replace("**", ""))));
        return Some(out);
    }
    if let Some(rate) = rate(failing) {
        let scope = declared(derivation, failing).map_or(&derivation.scope, |d| &d.scope);
        return Some(vec![quiet("its rate: "), StorySpan::Math(rate.to_owned(), scope), quiet(", proved")]);
    }
    let order = [ClaimRole::Added, ClaimRole::MayMean, ClaimRole::Says];
    let holds = |role: ClaimRole| {
        whole.readings.iter().find(move |r| {
            let first = r.claim.formulas.first().map(|f| dense(f));
            // The print itself, said of other motions, is no other formula.
            let is_another = first.is_some_and(|f| failing.formulas.iter().all(|printed| dense(printed) != f));
            r.role == role && r.standing == Standing::Holds && is_another
        })
    };
    if let Some(reading) = order.into_iter().find_map(holds) {
        let shown = formula_of(derivation, reading.claim, 0)?;
        // It is another statement than the one that fails.
        let lead = if reading.role == ClaimRole::Added { "beside it holds: " } else { "in another reading it holds: " };
        let mut out = vec![quiet(lead)];
        out.extend(shown.spans(None, false));
        let says = format!(" — {}", reading.claim.says.trim_end_matches('.'));
        out.push(StorySpan::Roomy(vec![StorySpan::Prose(says, shown.scope, Tone::Quiet)]));
        out.push(quiet(", "));
        let basis = reading.basis();
        let known = if basis == Basis::Proved { basis.kind().to_owned() } else { basis.words() };
        out.push(StorySpan::Prose(known, shown.scope, Tone::Quiet));
        return Some(out);
    }
    let erratum = failing.variants.as_ref()?.erratum.as_ref()?;
    let tried = erratum.tried.0 + erratum.tried.1 + erratum.tried.2;
    (tried > 0).then(|| vec![quiet(format!("{} one change away were tried, and none holds", count(tried, "formula")))])
}

/// The correction nearest to the print.
pub(super) fn correction(claim: &ClaimAccount) -> Option<&Correction> {
    claim.variants.as_ref()?.erratum.as_ref()?.corrections.first()
}

/// Whether what a correction changes is what is wrong in the print. What was tried with some fields put in, or on one motion, fits these: what
/// is wrong may be in what was put in.
fn is_located(claim: &ClaimAccount, correction: &Correction) -> bool {
    alone(claim, correction).is_none()
}

/// The nearest right formula of a claim that fails, in a sentence; `None` where none was found.
fn correction_says(claim: &ClaimAccount) -> Option<String> {
    let c = correction(claim)?;
    let formula = c.formula.split_whitespace().collect::<Vec<_>>().join(" ");
    let alone = alone(claim, c).unwrap_or_else(|| " instead".to_owned());
    Some(format!("Holds{alone}: {formula}, {}.", standing(c).replace("**", "")))
}

/// The rate of a quantity that is said to be constant and is not, as an equation that is proved; `None` where none was found.
pub(super) fn rate(claim: &ClaimAccount) -> Option<&str> {
    claim.variants.as_ref()?.erratum.as_ref()?.rate.as_deref()
}

/// What holds instead of a claim that fails, and how fast a quantity changes that is said not to, in sentences.
pub(super) fn instead(claim: &ClaimAccount) -> Option<String> {
    let rate = rate(claim).map(|rate| format!("Its rate: {rate}, proved."));
    let says: Vec<String> = correction_says(claim).into_iter().chain(rate).collect();
    (!says.is_empty()).then(|| says.join(" "))
}

/// The reading that a card is about: that which fails, else that which shows the contrary, else the first.
fn subject<'w, 'a>(whole: &'w Whole<'a>) -> Option<(&'w Reading<'a>, bool)> {
    if let Some(failing) = whole.failing() {
        return Some((failing, true));
    }
    let contrary = whole.readings.iter().find(|r| r.role == ClaimRole::Against && r.standing == Standing::Holds);
    contrary.or(whole.readings.first()).map(|r| (r, false))
}

/// Blocks of a card; its number is 0 where there is no other.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    whole: &Whole<'a>,
    line: &Line,
    number: usize,
) -> Vec<StoryBlock<'a>> {
    let scope = &derivation.scope;
    let lead = (number > 0).then(|| StorySpan::Words(format!("{number}. "), Tone::Strong));
    let lead = lead.map(|of| if line.is_brief { StorySpan::Roomy(vec![of]) } else { of });
    let mut head: Vec<StorySpan<'a>> = lead.into_iter().collect();
    head.push(StorySpan::Prose(line.says.clone(), scope, Tone::Strong));
    head.push(quiet(" ("));
    if whole.fate == Fate::Added {
        head.push(quiet("for comparison, "));
    }
    if let Some(place) = &line.place {
        head.push(StorySpan::Prose(format!("{place}, "), scope, Tone::Quiet));
    }
    head.extend([StorySpan::Claim(line.id.clone(), Tone::Plain), quiet(")")]);
    let mut out = vec![StoryBlock::Paragraph(head)];
    let Some((reading, fails)) = subject(whole) else { return out };
    let claim = reading.claim;
    let own = declared(derivation, claim).map_or(scope, |d| &d.scope);
    let correction = correction(claim).filter(|_| fails);
    let motion = RefutingMotion::of(derivation, claim).filter(|_| fails);
    let sketch = match &motion {
        Some(motion) => motion.sketch(),
        None => at_point(claim).filter(|_| fails),
    };
    if let Some(sketch) = sketch {
        // Beside conclusions a terminal has no room for a drawing.
        let figure = StoryBlock::Figure(sketch, Vec::new());
        out.push(if line.is_brief { StoryBlock::Group("roomy", vec![figure]) } else { figure });
    }
    if let Some(shown) = formula_of(derivation, claim, shown_formula(claim, correction)) {
        let is_print = declared(derivation, claim).is_some_and(|d| d.printed && d.label.is_some());
        let lead = match (fails, is_print) {
            (true, true) => "printed: ",
            (true, false) => "tested as: ",
            (false, _) => "the contrary, which holds: ",
        };
        let mut print = vec![quiet(lead)];
        let located = correction.filter(|c| is_located(claim, c));
        print.extend(shown.spans(located.map(|c| c.formula.as_str()), true));
        print.extend(provided(derivation, claim));
        out.push(StoryBlock::Paragraph(print));
    }
    let right = right(derivation, whole, claim, correction).filter(|_| fails);
    match (out.last_mut(), right) {
        // A terminal has the print and what holds in one line, where both are short.
        (Some(StoryBlock::Paragraph(print)), Some(right)) if is_short(claim) => {
            print.push(quiet("; "));
            print.extend(right);
        }
        (_, right) => out.extend(right.map(StoryBlock::Paragraph)),
    }
    let mut why = vec![StorySpan::Prose(format!("{} ", line.brief), scope, Tone::Plain)];
    match &motion {
        Some(motion) => {
            let room = if line.is_brief { Room::OnPage } else { Room::Everywhere };
            why.extend(motion.says(derivation, own, room));
        }
        None => why.extend(
            over_ranges_brief(claim)
                .or_else(|| of_step_brief(claim))
                .filter(|_| fails)
                .map(|text| StorySpan::Prose(retold(&text), own, Tone::Plain)),
        ),
    }
    if let Some(text) = &line.consequence {
        why.push(StorySpan::Prose(format!(" {text}"), scope, Tone::Quiet));
    }
    out.push(StoryBlock::Paragraph(why));
    out
}

/// Whether the print of a claim leaves room for another formula in its line.
fn is_short(claim: &ClaimAccount) -> bool {
    claim.assumptions.is_empty() && claim.formulas.first().is_some_and(|f| f.len() <= LONGEST_TOGETHER)
}

/// Both sides at the point that refutes a claim that has no motion: of its ranges, else of what is said for all values.
fn at_point(claim: &ClaimAccount) -> Option<Sketch> {
    let middle = |(low, high): (f64, f64)| low + (high - low) / 2.0;
    let over_ranges = claim.region.as_ref().and_then(|r| r.witness.as_ref()?.sides);
    let over_ranges = over_ranges.map(|(left, right)| (middle(left), middle(right)));
    let number = |text: &str| text.trim().replace('−', "-").parse::<f64>().ok();
    let of_step = || match claim.identity.as_ref()?.witness.as_ref()? {
        Refuting::Point { first, second: None } => Some((number(&first.left)?, number(&first.right)?)),
        Refuting::OnMotion { left, right, .. } => Some((*left, *right)),
        Refuting::Point { .. } | Refuting::Signs { .. } | Refuting::Sizes(_) => None,
    };
    let (left, right) = over_ranges.or_else(of_step)?;
    Sketch::levels(left, right, "Both sides at a point".to_owned())
}

/// When a claim is tried, and what it assumes.
fn provided<'a>(derivation: &'a Derivation, claim: &'a ClaimAccount) -> Vec<StorySpan<'a>> {
    let declared = declared(derivation, claim);
    let scope = declared.map_or(&derivation.scope, |d| &d.scope);
    let when = declared.and_then(|d| d.at.as_ref()).map(|at| {
        let occasion = StorySpan::Prose(at.occasion.words().to_owned(), scope, Tone::Quiet);
        vec![quiet("tried when "), StorySpan::Math(at.equation.text.clone(), scope), occasion]
    });
    let assumed: Vec<&String> = claim.assumptions.iter().filter(|a| a.len() <= LONGEST / 4).collect();
    let hidden = claim.assumptions.len() - assumed.len();
    let mut assumed: Vec<Vec<StorySpan<'a>>> =
        assumed.into_iter().map(|a| vec![StorySpan::Math(a.clone(), scope)]).collect();
    if hidden > 0 {
        assumed.push(vec![quiet(format!("{hidden} more"))]);
    }
    let mut assuming = joined(assumed, ", ");
    if !assuming.is_empty() {
        assuming.insert(0, quiet("assuming "));
    }
    // What the claim puts in for a field is as much of it as its formula.
    let ranges = claim.region.iter().flat_map(|r| &r.ranges).filter(|r| r.is_field());
    let put_in = ranges.filter_map(|r| Some(format!("{}={}", r.name, r.formula.as_ref()?)));
    let put_in = put_in.filter(|text| text.len() <= LONGEST / 4).take(MOST_PUT_IN);
    let mut put_in = joined(put_in.map(|text| vec![StorySpan::Math(text, scope)]), ", ");
    if !put_in.is_empty() {
        put_in.insert(0, quiet("with "));
    }
    let parts = when.into_iter().chain([assuming, put_in].into_iter().filter(|a| !a.is_empty()));
    let mut out = joined(parts, "; ");
    if !out.is_empty() {
        out.insert(0, quiet(" ("));
        out.push(quiet(")"));
    }
    out
}

/// Both sides of a claim that holds, along the motion on which it was tried best: the picture of a paper without a failure.
pub(super) fn sketch_that_holds(whole: &Whole<'_>) -> Option<(Sketch, String)> {
    let pairs = whole.deciding().flat_map(|r| &r.claim.results);
    let drawn = pairs.filter_map(|p| Some((p.verdict.evidence().series.as_deref()?, p)));
    let (series, pair) = drawn.max_by_key(|(s, _)| s.points.len())?;
    let sketch = Sketch::sides(series, None, &pair.trajectory).filter(Sketch::varies)?;
    Some((sketch, pair.trajectory.clone()))
}

/// The claim as it is checked, in a line, for what has no card.
pub(super) fn formula_line<'a>(derivation: &'a Derivation, whole: &Whole<'a>) -> Option<Vec<StorySpan<'a>>> {
    let reading = whole.deciding().next()?;
    Some(formula_of(derivation, reading.claim, shown_formula(reading.claim, None))?.spans(None, false))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_relation_of_two_short_sides_has_their_names() {
        assert_eq!(sides("2E= I^{-1}_i m_i^2"), Some(("2E", "=", "I^{-1}_i m_i^2")));
        assert_eq!(sides(r"0\le x"), Some(("0", r"\le ", "x")));
        assert_eq!(sides(r"\left|x\right|<1"), Some((r"\left|x\right|", "<", "1")));
        assert_eq!(sides("a=b=c"), None);
        assert_eq!(sides(r"0\le x<1"), None);
        assert_eq!(sides("x"), None);
        assert!(is_number("-1.5") && !is_number("2E"));
    }

    #[test]
    fn an_error_is_as_heavy_as_its_share_of_the_sides() {
        assert_eq!(decades_apart(1.0, -1.0, 1e-12), 0);
        assert_eq!(decades_apart(2.3, 1e-4, 1e-12), 0);
        assert_eq!(decades_apart(1.0, 1.002, 1e-12), 2);
        assert_eq!(decades_apart(3e20, 3.000_000_1e20, 1.0), 7);
        // The sides agree, or nothing is known of them.
        assert_eq!(decades_apart(1.0, 1.0, 0.0), 0);
        assert_eq!(decades_apart(1.0, 1.0 + 1e-12, 1e-9), 0);
        assert_eq!(decades_apart(f64::NAN, 1.0, 0.0), 0);
        assert_eq!(decades_apart(0.0, 0.0, 0.0), 0);
    }
}
