//! The section on the claims: what each says, how it fares, and how that is known.
//!
//! **In:** a derivation and its account. **Out:** blocks, for every kind of report, the claims by what became of them: what does not stand comes
//! first. **Guaranteed:** every claim and reading is told once, with its verdict; what is not as expected, fails, is open, or is tried over
//! ranges or families is told in full. Tables of motions and what stands behind a verdict are for the page alone.

use std::collections::BTreeSet;

use super::behind;
use super::digest::{self, Fate, Reading, Whole};
use super::discrimination;
use super::drawn;
use super::family;
use super::form::{Heading, heading};
use super::graph::{DerivationGraph, ProofStanding};
use super::headline;
use super::numbers::{count, size};
use super::pair_story;
use super::region;
use super::story::{
    Elsewhere, PartLevel, StoryBlock, StorySpan, Tone, embedded, folded, joined, on_page, part, prose, quiet, section,
    shapes, strong, words,
};
use super::tally::{Standing, declared, groups, name};
use super::text::uncapital;
use super::units;
use super::wording::slack_sentence;
use derivation::{ClaimRole, DEFAULT_PRECISION, Derivation, FormKind};
use findings::{Account, ClaimAccount, Grounds, PairAccount};
use latex::Scope;

/// On a page of more claims than this, each is a sentence and its verdict, until it is unfolded.
const MANY: usize = 40;

/// Longest formulas of a claim that is there for comparison, in bytes; longer ones are on the page alone.
const MOST_ADDED: usize = 200;

/// What claims are told with.
struct Claims<'a> {
    derivation: &'a Derivation,
    account: &'a Account,
    graph: DerivationGraph,
    /// The names of those that are not folded, however many there are.
    open: BTreeSet<String>,
}

/// The first claims that are not as expected, or fail on motions that were drawn.
fn open(account: &Account) -> BTreeSet<String> {
    let is_open = |c: &&ClaimAccount| {
        c.is_unexpected_alone() || groups(c).iter().any(|g| g.unexpected) || drawn::table(c).is_some()
    };
    account.claims.iter().filter(is_open).take(MANY).map(name).collect()
}

/// The section.
pub(super) fn claims<'a>(derivation: &'a Derivation, account: &'a Account) -> StoryBlock<'a> {
    let all = Claims { derivation, account, graph: DerivationGraph::new(derivation, account), open: open(account) };
    let wholes = digest::wholes(derivation, account);
    let mut parts = Vec::new();
    for fate in Fate::ALL {
        let found: Vec<&Whole<'a>> = wholes.iter().filter(|w| w.fate == fate).collect();
        if found.is_empty() {
            continue;
        }
        let mut told = vec![StoryBlock::Paragraph(vec![quiet(fate.meaning())])];
        told.extend(found.iter().map(|whole| all.whole(whole)));
        let title = vec![words(headline::heading(fate, &found))];
        parts.push(part(format!("/found/{}", fate.key()), PartLevel::Subsection, title, told));
    }
    let mut blocks = vec![StoryBlock::Paragraph(vec![quiet(SAID)])];
    blocks.extend(roles(&wholes).map(|text| StoryBlock::Paragraph(vec![quiet(text)])));
    let shapes = shapes(&parts).into_iter();
    let mut legend = joined(shapes.map(|s| vec![StorySpan::Shape(s), words(format!(" {}", s.says()))]), ", ");
    // Where no symbol occurs there is no legend.
    legend.push(words(if legend.is_empty() { LEFT_OUT.to_owned() } else { format!("; {LEFT_OUT}") }));
    blocks.push(folded(Vec::new(), Elsewhere::Line(legend), Vec::new()));
    blocks.extend(parts);
    section("/claims", "Claims", blocks)
}

/// What holds of all formulas.
const SAID: &str = "Formulas are said of every time, where nothing else is said.";

/// What a reader finds elsewhere.
const LEFT_OUT: &str = "† has a certificate, certificates/proof-NAME.py, with two hyphens for the stroke in a name. On the page alone: steps of \
                        proofs, curves, members of families, points that refute what is for comparison, the worth of assumptions, \
                        remarks on what holds.";

/// What a claim is to the paper, where the paper does not simply say it.
pub(super) fn whose(role: ClaimRole) -> Option<&'static str> {
    match role {
        ClaimRole::Says => None,
        ClaimRole::MayMean => Some("One of several things that the sentence may mean."),
        ClaimRole::Needs => Some("The paper needs it; it is more, or other, than it says."),
        ClaimRole::Against => Some("Against the sentence: the contrary of what the paper says."),
        ClaimRole::Added => Some("For comparison: the paper does not say it."),
        ClaimRole::Lemma => Some("A lemma of the file, which proofs use: the paper does not print it."),
        ClaimRole::Choice => Some("A choice of the paper: neither true nor false."),
    }
}

/// What the words behind the names of claims mean, of those that occur.
fn roles(wholes: &[Whole<'_>]) -> Option<String> {
    let told = |role: ClaimRole| Some(format!("({}) {}", role.word(), whose(role)?));
    let readings = wholes.iter().filter(|w| w.fate.is_of_the_paper()).flat_map(|w| &w.readings);
    let occur: Vec<ClaimRole> = readings.map(|r| r.role).collect();
    let told: Vec<String> = ClaimRole::ALL.into_iter().filter(|r| occur.contains(r)).filter_map(told).collect();
    (!told.is_empty()).then(|| told.join(" "))
}

/// Whether no more is to be said of it than that it holds wherever it applies, and how that is known.
fn is_plain(reading: &Reading<'_>) -> bool {
    let claim = reading.claim;
    reading.standing == Standing::Holds
        && is_expected(claim)
        && claim.conditions.separation.is_none()
        && claim.variants.as_ref().is_none_or(|v| v.erratum.is_none())
        && drawn::table(claim).is_none()
        && claim.results.iter().all(|p| slack_sentence(p).is_none())
}

/// Whether all is as the file expects, and is about motions or all values.
fn is_expected(claim: &ClaimAccount) -> bool {
    claim.region.is_none()
        && claim.families.is_empty()
        && !claim.is_unexpected_alone()
        && !claim.results.iter().any(PairAccount::is_unexpected)
}

/// Whether a few words tell how it fares: it is plain, or there to compare with.
fn is_short(reading: &Reading<'_>) -> bool {
    let compared = reading.role == ClaimRole::Added && reading.standing != Standing::Open;
    is_plain(reading) || compared && is_expected(reading.claim)
}

impl<'a> Claims<'a> {
    fn scope(&self, claim: &ClaimAccount) -> &'a Scope {
        declared(self.derivation, claim).map_or(&self.derivation.scope, |d| &d.scope)
    }

    /// A claim, with all its readings.
    fn whole(&self, whole: &Whole<'a>) -> StoryBlock<'a> {
        let mut title = vec![words(format!("{}: ", whole.id)), prose(&whole.says, &self.derivation.scope)];
        title.extend(self.place(whole));
        if let ([reading], false) = (whole.readings.as_slice(), whole.is_read()) {
            // What is no claim of the paper stands under a heading that says so.
            title.extend(role(reading).filter(|_| whole.fate.is_of_the_paper()));
            let mut blocks = self.told(reading, &[]);
            self.remark(whole, reading, None, &mut blocks);
            return part(whole.id, PartLevel::Claim, title, blocks);
        }
        let has_own = whole.readings.iter().any(|r| r.claim.reading.is_none());
        let mut last = None;
        let shared = shared_assumptions(whole);
        let assuming = self.assuming("All of them assume ", &shared, &self.derivation.scope);
        let readings = whole.readings.iter().map(|reading| {
            let claim = reading.claim;
            let id = claim.reading.as_ref().map_or_else(|| "as it stands".to_owned(), |id| format!("/{id}"));
            let mut title = vec![strong(id)];
            title.extend(role(reading).filter(|_| whole.fate.is_of_the_paper()));
            if claim.reading.is_some() {
                title.extend([words(": "), prose(&claim.says, self.scope(claim))]);
            }
            let mut blocks = self.told(reading, &shared);
            self.remark(whole, reading, last, &mut blocks);
            last = claim.remark.as_deref();
            part(name(claim), PartLevel::Reading, title, blocks)
        });
        let readings =
            (!shared.is_empty()).then_some(StoryBlock::Paragraph(assuming)).into_iter().chain(readings).collect();
        part(if has_own { "" } else { whole.id }, PartLevel::Family, title, readings)
    }

    /// Where the paper says it, and its label there, in brackets.
    fn place(&self, whole: &Whole<'a>) -> Vec<StorySpan<'a>> {
        let label = whole.readings.iter().find_map(|r| declared(self.derivation, r.claim)?.label.as_deref());
        // A place that names the label says enough.
        let label = label.filter(|l| !whole.place.is_some_and(|p| p.contains(l)));
        let parts: Vec<&str> = whole.place.into_iter().chain(label).collect();
        let told = || StorySpan::Prose(format!(" ({})", parts.join(", ")), &self.derivation.scope, Tone::Quiet);
        (!parts.is_empty()).then(told).into_iter().collect()
    }

    /// The remark of the file: everywhere, where the paper is not borne out; else on the page, with what is folded. That on the whole claim is
    /// every reading's, and is told once.
    fn remark(&self, whole: &Whole<'a>, reading: &Reading<'a>, last: Option<&str>, blocks: &mut Vec<StoryBlock<'a>>) {
        let Some(text) = reading.claim.remark.as_deref().filter(|text| Some(*text) != last) else { return };
        let spans = vec![quiet("Remark of the file: "), prose(text.trim(), self.scope(reading.claim))];
        let block = StoryBlock::Group("remark", vec![StoryBlock::Paragraph(spans)]);
        if whole.fate.is_against() && reading.role != ClaimRole::Added {
            return blocks.push(block);
        }
        let block = StoryBlock::Group("page", vec![block]);
        match blocks.last_mut() {
            Some(StoryBlock::Fold(fold)) if matches!(fold.elsewhere, Elsewhere::Titled) => fold.blocks.push(block),
            _ => blocks.push(block),
        }
    }

    /// What a claim says, and what was found of it. Of one that stands a line is read, and the rest is folded: few ask how it is known. On a
    /// page of many claims that of the others is folded, too: what is wrong stands above, with its witness.
    fn told(&self, reading: &Reading<'a>, shared: &[&'a str]) -> Vec<StoryBlock<'a>> {
        let claim = reading.claim;
        let scope = self.scope(claim);
        let is_many = self.account.claims.len() > MANY;
        let is_short = is_short(reading);
        let evidence = self.evidence(reading);
        let mut title = vec![StorySpan::Shape(reading.shape()), words(" ")];
        title.push(if is_short {
            prose(self.fares(reading), scope)
        } else {
            StorySpan::Prose(format!("{}.", verdict(reading)), scope, Tone::Strong)
        });
        let mut stated = self.stated(reading, is_short, shared);
        let mut evidence = if is_short { vec![StoryBlock::Group("page", evidence)] } else { evidence };
        evidence.push(behind::in_print(&self.graph, claim, scope));
        if !is_short && (!is_many || self.open.contains(&name(claim))) {
            stated.push(StoryBlock::Paragraph(title));
            return stated.into_iter().chain(evidence).collect();
        }
        if is_many {
            return vec![folded(title, Elsewhere::Titled, stated.into_iter().chain(evidence).collect())];
        }
        stated.push(folded(title, Elsewhere::Titled, evidence));
        stated
    }

    /// How it fares, and how that is known, in a few words.
    fn fares(&self, reading: &Reading<'a>) -> String {
        let (claim, identity) = (reading.claim, reading.claim.identity.as_ref());
        let is_good = reading.standing == Standing::Holds;
        let mut out = if is_good { reading.basis().words() } else { uncapital(&verdict(reading)) };
        out.push_str(match (&reading.proof, identity) {
            (ProofStanding::None, Some(identity)) if is_good && identity.verdict() == "refuted" => {
                "; not for all values"
            }
            (ProofStanding::None | ProofStanding::Circular, _) | (_, None) => "",
            // That the checker made the steps again is told on page one.
            (_, Some(identity)) => match identity.recorded.as_ref().map(|r| r.grounds()) {
                Some(Grounds::Prover) => "; prover alone",
                Some(Grounds::CheckerBut(_)) => "; replayed but for some cases",
                Some(Grounds::Checker) | None => "",
            },
        });
        if let Some(asked) = self.precision(claim) {
            out.push_str(&format!("; to {}", size(asked)));
        }
        let left_out = claim.results.iter().filter(|p| !p.verdict.evidence().excluded.is_empty()).count();
        if is_good && left_out > 0 {
            out.push_str(&format!("; some times left out on {}", count(left_out, "motion")));
        }
        out + if super::certificates::file_name(claim).is_some() { " †" } else { "" }
    }

    /// The precision asked for, where it is not the usual one.
    fn precision(&self, claim: &ClaimAccount) -> Option<f64> {
        declared(self.derivation, claim).map(|d| d.precision).filter(|p| *p != DEFAULT_PRECISION)
    }

    /// What it says: formulas, what is assumed, when it is tried.
    fn stated(&self, reading: &Reading<'a>, is_short: bool, shared: &[&'a str]) -> Vec<StoryBlock<'a>> {
        let claim = reading.claim;
        let scope = self.scope(claim);
        let declared = declared(self.derivation, claim);
        let mut out = formulas(self.derivation, claim, scope);
        let long = claim.formulas.iter().map(String::len).sum::<usize>() > MOST_ADDED;
        if is_short && long && reading.role == ClaimRole::Added {
            out = vec![on_page("Its formulas", "Its formulas are on the page.", out)];
        }
        let own: Vec<&str> = claim.assumptions.iter().map(String::as_str).filter(|a| !shared.contains(a)).collect();
        let mut line = if own.is_empty() { Vec::new() } else { self.assuming("Assuming ", &own, scope) };
        // Between members it is said with the formula.
        let at = declared.filter(|d| family::compared(d).is_none()).and_then(|d| d.at.as_ref());
        if let Some(at) = at {
            let lead = if line.is_empty() { "Tried when " } else { " Tried when " };
            line.push(prose(format!("{lead}${}${}.", at.equation.text, at.occasion.words()), scope));
        }
        if !line.is_empty() {
            out.push(StoryBlock::Paragraph(line));
        }
        if let Some(from) = declared.map(|d| &d.follows_from).filter(|f| !f.is_empty()) {
            let line = vec![quiet(format!("Said to follow from {}.", from.join(", ")))];
            out.push(StoryBlock::Group("page", vec![StoryBlock::Paragraph(line)]));
        }
        let precision = self.precision(claim).filter(|_| !is_short);
        out.extend(precision.map(|p| StoryBlock::Paragraph(vec![quiet(format!("Precision asked for: {}.", size(p)))])));
        let id = name(claim);
        for of in units::inconsistent(&self.account.units).filter(|f| f.kind == "claim" && f.of == id) {
            let mut line = vec![StorySpan::Words("Units do not agree: ".to_owned(), Tone::Bad)];
            line.extend(units::disagreement(of, scope));
            out.push(StoryBlock::Paragraph(line));
        }
        if self.account.units.missed.contains(&id) {
            let text = "Inconsistent units are expected, and its units agree.".to_owned();
            out.push(StoryBlock::Paragraph(vec![StorySpan::Words(text, Tone::Alarm)]));
        }
        out
    }

    fn assuming(&self, lead: &str, all: &[&str], scope: &'a Scope) -> Vec<StorySpan<'a>> {
        let all = joined(all.iter().map(|a| vec![StorySpan::Math((*a).to_owned(), scope)]), ", ");
        std::iter::once(words(lead)).chain(all).chain([words(".")]).collect()
    }

    /// How it is known.
    fn evidence(&self, reading: &Reading<'a>) -> Vec<StoryBlock<'a>> {
        let claim = reading.claim;
        let scope = self.scope(claim);
        let mut out: Vec<StoryBlock<'a>> = self.for_all_values(reading, scope).into_iter().collect();
        out.extend(pair_story::blocks(self.derivation, self.account, claim, scope));
        out.extend(family::blocks(claim, scope, &|of| {
            let (name, another) = (name(claim), name(claim));
            let map = of.map.as_ref().map(|map| embedded(move || super::page::map::figure(map, &name, scope)));
            let slopes = of.slope.as_ref().map(|s| embedded(move || super::page::slopes::figure(s, &another, scope)));
            map.into_iter().chain(slopes).collect()
        }));
        if let Some(of) = &claim.region {
            let class = family::class(of.verdict.outcome().word());
            let mut blocks = region::told(of, scope);
            blocks.push(embedded(move || super::page::region::figures(claim, of, scope)));
            out.push(StoryBlock::Group(class, blocks));
        }
        if let Some(text) = drawn::plain(self.derivation, claim) {
            out.push(StoryBlock::Paragraph(vec![prose(text, scope)]));
        }
        if let Some(table) = drawn::table(claim) {
            let lines = StoryBlock::Lines(table.to_owned(), "toml");
            out.push(on_page("The motion, to be put into the file", "", vec![lines]));
        }
        let erratum = claim.variants.as_ref().and_then(|v| v.erratum.as_ref());
        out.extend(erratum.map(|e| discrimination::corrections(e, scope)).unwrap_or_default());
        out.extend(behind::blocks(&self.graph, claim, scope));
        out
    }

    /// What is known for all values; where a motion refutes it, too, on the page alone.
    fn for_all_values(&self, reading: &Reading<'a>, scope: &'a Scope) -> Option<StoryBlock<'a>> {
        let claim = reading.claim;
        let identity = claim.identity.as_ref()?;
        let is_open = reading.proof == ProofStanding::None;
        let class = match identity.verdict() {
            "refuted" => "identity refuted",
            "proved" if !is_open => "identity proved",
            _ => "identity",
        };
        let mut line = vec![strong("For all values: "), prose(super::graph::brief(identity, &reading.proof), scope)];
        line.extend(identity.recorded.as_ref().map(|r| {
            words(match (r.grounds(), r.steps().unwrap_or(0)) {
                (Grounds::Checker, steps) => format!(" Replayed: {}.", count(steps, "step")),
                (Grounds::CheckerBut(n), steps) => {
                    format!(" Replayed: {}, but for {}.", count(steps, "step"), count(n, "case"))
                }
                (Grounds::Prover, _) => " Prover alone.".to_owned(),
            })
        }));
        line.extend(super::certificates::file_name(claim).map(|_| words(" †")));
        let block = StoryBlock::Group(class, vec![StoryBlock::Paragraph(line)]);
        let on_motion = claim.results.iter().any(|p| p.verdict.outcome().word() == "fails");
        Some(if on_motion && is_open { StoryBlock::Group("page", vec![block]) } else { block })
    }
}

/// What each reading of a claim assumes: it is told once.
fn shared_assumptions<'a>(whole: &Whole<'a>) -> Vec<&'a str> {
    let Some((first, rest)) = whole.readings.split_first() else { return Vec::new() };
    let all = first.claim.assumptions.iter().filter(|a| rest.iter().all(|r| r.claim.assumptions.contains(a)));
    if rest.is_empty() { Vec::new() } else { all.map(String::as_str).collect() }
}

/// The verdict, and what it holds under.
fn verdict(reading: &Reading<'_>) -> String {
    let condition = digest::condition_of(reading.claim).map(|c| format!("; {c}")).unwrap_or_default();
    format!("{}{condition}", digest::verdict(reading))
}

/// What the word behind a name is: nothing for what the paper says.
fn role<'a>(reading: &Reading<'_>) -> Option<StorySpan<'a>> {
    (reading.role != ClaimRole::Says).then(|| words(format!(" ({})", reading.role.word())))
}

/// The formulas, each kind with its words, of which what holds at every time needs none.
fn formulas<'a>(derivation: &'a Derivation, claim: &'a ClaimAccount, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let declared = declared(derivation, claim);
    let mut out = Vec::new();
    let mut last = None;
    let of = |says: &str, place: &str, id: &str| {
        let id = StorySpan::Section(id.to_owned(), format!("/{place}/{id}"));
        StoryBlock::Paragraph(vec![words(format!("The motion {says} ")), id, words(".")])
    };
    for (at, formula) in claim.formulas.iter().enumerate() {
        let (kind, said) = heading(claim, declared, at);
        match said {
            Heading::System => out.push(of("solves the system", "system", formula)),
            Heading::Trajectory => out.push(of("is that of", "trajectory", formula)),
            Heading::Words(words) => {
                if last.replace(kind) != Some(kind) && words != FormKind::Always.heading() {
                    out.push(StoryBlock::Paragraph(vec![prose(format!("{words}:"), scope)]));
                }
                out.push(StoryBlock::Formula(formula.clone(), scope));
            }
        }
    }
    out
}
