//! What became of each sentence: the readings of a claim taken together.
//!
//! **In:** the account. **Out:** one [`Whole`] for each claim of the file, with its [`Fate`].
//! A reader asks which claims stand; thousands of verdicts do not say it. Nothing is judged here: a fate follows from the
//! verdicts of the readings by [`Fate::of`].
//!
//! **A fate is that of what the paper says.** Readings that say what the paper needs, the contrary of its sentence, or what was
//! added to compare are told beside it, and decide nothing; lemmas of the file and choices of convention are not counted among
//! the paper's claims.

use super::basis::Basis;
use super::graph::{DerivationGraph, ProofStanding};
use super::headline::CountedFate;
use super::numbers::count;
use super::story::VerdictShape;
use super::tally::{Standing, declared};
use derivation::{ClaimRole, Derivation};
use findings::conditions::{ConditionName, Explanation, Join, Separation};
use findings::{Account, ClaimAccount, Outcome, Strength};

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fate {
    /// What it says fails wherever it applies, or the contrary is shown.
    Fails,
    /// What it says holds on some motions and fails on others.
    Partly,
    /// Some of what it may mean holds throughout, some does not.
    Reading,
    /// None fails anywhere, one is undecided somewhere.
    Open,
    /// Nothing that it says could be computed.
    Untested,
    /// None applies to any trajectory.
    Nowhere,
    /// All that it says holds wherever it applies.
    Stands,
    /// The paper chooses it: it is neither true nor false.
    Choice,
    /// A lemma of the file.
    Lemma,
    /// The paper does not say it.
    Added,
}

impl Fate {
    /// In the order in which they are told: what does not stand comes first.
    pub const ALL: [Fate; 10] = [
        Fate::Fails,
        Fate::Partly,
        Fate::Reading,
        Fate::Open,
        Fate::Untested,
        Fate::Nowhere,
        Fate::Stands,
        Fate::Choice,
        Fate::Lemma,
        Fate::Added,
    ];
    /// In the order of the sentence that counts them, without what is none of the paper's claims.
    pub const TOLD: [Fate; 7] =
        [Fate::Stands, Fate::Fails, Fate::Partly, Fate::Reading, Fate::Open, Fate::Untested, Fate::Nowhere];

    /// All that is said must hold. Of what may be meant all, some or none does. The contrary, if it holds wherever it applies,
    /// settles what is not decided, and is against one of several meanings.
    fn of(readings: &[Reading<'_>]) -> Fate {
        let all = |role: ClaimRole| !readings.is_empty() && readings.iter().all(|r| r.role == role);
        if !readings.is_empty() && readings.iter().all(|r| !r.role.is_of_the_paper()) {
            return match (all(ClaimRole::Choice), all(ClaimRole::Lemma)) {
                (true, _) => Fate::Choice,
                (_, true) => Fate::Lemma,
                _ => Fate::Added,
            };
        }
        let of = |role: ClaimRole| readings.iter().filter(move |r| r.role == role).map(|r| r.standing);
        let has = |role: ClaimRole, standing: Standing| of(role).any(|s| s == standing);
        let said = |standing: Standing| has(ClaimRole::Says, standing);
        let meant = |standing: Standing| has(ClaimRole::MayMean, standing);
        let contrary = has(ClaimRole::Against, Standing::Holds);
        if said(Standing::Fails) {
            return Fate::Fails;
        }
        if said(Standing::Mixed) {
            return Fate::Partly;
        }
        match (meant(Standing::Holds), meant(Standing::Mixed), meant(Standing::Fails)) {
            (true, true, _) | (true, _, true) => return Fate::Reading,
            (false, true, _) => return Fate::Partly,
            (false, false, true) => return Fate::Fails,
            (true, false, false) if contrary && !said(Standing::Holds) => return Fate::Reading,
            (_, false, false) => {}
        }
        if !contrary && !readings.is_empty() && !readings.iter().any(|r| r.role.decides()) {
            return Fate::Untested;
        }
        let open = said(Standing::Open) || meant(Standing::Open);
        match (open, said(Standing::Holds) || meant(Standing::Holds), contrary) {
            (true, _, true) | (_, false, true) => Fate::Fails,
            (true, ..) => Fate::Open,
            (false, true, _) => Fate::Stands,
            (false, false, false) => Fate::Nowhere,
        }
    }

    /// Whether the paper's sentence is not borne out as it stands.
    pub fn is_against(self) -> bool {
        match self {
            Fate::Fails | Fate::Partly | Fate::Reading => true,
            Fate::Open | Fate::Untested | Fate::Nowhere | Fate::Stands => false,
            Fate::Choice | Fate::Lemma | Fate::Added => false,
        }
    }

    /// Whether it is counted among the claims of the paper.
    pub fn is_of_the_paper(self) -> bool {
        Fate::TOLD.contains(&self)
    }

    /// A name for links.
    pub fn key(self) -> &'static str {
        match self {
            Fate::Fails => "fail",
            Fate::Partly => "partly",
            Fate::Reading => "reading",
            Fate::Open => "open",
            Fate::Untested => "untested",
            Fate::Nowhere => "nowhere",
            Fate::Stands => "stand",
            Fate::Choice => "choice",
            Fate::Lemma => "lemma",
            Fate::Added => "added",
        }
    }

    /// The verb of a heading, for so many claims.
    pub fn words(self, n: usize) -> &'static str {
        match (self, n) {
            (Fate::Fails, 1) => "does not hold",
            (Fate::Fails, _) => "do not hold",
            (Fate::Partly, 1) => "holds on some motions and fails on others",
            (Fate::Partly, _) => "hold on some motions and fail on others",
            (Fate::Reading, 1) => "depends on what it means",
            (Fate::Reading, _) => "depend on what they mean",
            (Fate::Open, 1) => "is not settled",
            (Fate::Open, _) => "are not settled",
            (Fate::Untested, 1) => "is not tested itself",
            (Fate::Untested, _) => "are not tested themselves",
            (Fate::Nowhere, 1) => "applies to none of the motions",
            (Fate::Nowhere, _) => "apply to none of the motions",
            (Fate::Stands, 1) => "stands",
            (Fate::Stands, _) => "stand",
            (Fate::Choice, 1) => "is a choice of the paper",
            (Fate::Choice, _) => "are choices of the paper",
            (Fate::Lemma, 1) => "is a lemma of the file",
            (Fate::Lemma, _) => "are lemmas of the file",
            (Fate::Added, 1) => "was added for comparison",
            (Fate::Added, _) => "were added for comparison",
        }
    }

    /// What the words mean.
    pub fn meaning(self) -> &'static str {
        match self {
            Fate::Fails => "What it says fails on every motion to which it applies, or the contrary is shown.",
            Fate::Partly => {
                "As it stands it is refuted; where it holds all the same is said beside each, as far as it is known."
            }
            Fate::Reading => {
                "The sentence may mean several things: one holds wherever it applies, another fails somewhere."
            }
            Fate::Open => "The evidence settles no failure, and not everything.",
            Fate::Untested => "Nothing that the sentence says could be computed; what it needs is told.",
            Fate::Nowhere => "No motion meets what they assume.",
            Fate::Stands => {
                "What they say holds on every motion to which they apply. Beside each stands how that is known."
            }
            Fate::Choice => "A convention, a laboratory: what is chosen is neither true nor false.",
            Fate::Lemma => "The paper does not print them; proofs use them.",
            Fate::Added => "The paper does not say it. It is checked like the rest, to compare with.",
        }
    }
}

/// One reading of a claim, or the claim itself.
pub(super) struct Reading<'a> {
    pub claim: &'a ClaimAccount,
    pub standing: Standing,
    /// Whose it is.
    pub role: ClaimRole,
    /// What its proof amounts to.
    pub proof: ProofStanding,
}

impl<'a> Reading<'a> {
    /// That of a claim.
    pub fn of(derivation: &Derivation, graph: &DerivationGraph, claim: &'a ClaimAccount) -> Reading<'a> {
        let role = declared(derivation, claim).map(|d| d.role).unwrap_or_default();
        Reading { claim, standing: Standing::of(claim), role, proof: graph.proof_of(claim) }
    }

    /// Its symbol: how strongly it holds, or how surely it does not.
    pub fn shape(&self) -> VerdictShape {
        match self.standing {
            Standing::Holds => self.basis().shape(),
            Standing::Mixed => VerdictShape::Mixed,
            Standing::Fails => match strongest_refutation(self.claim) {
                Some(Strength::Sampled) => VerdictShape::Fails,
                Some(Strength::Enclosed | Strength::Proved) => VerdictShape::Certified,
                None if self.claim.verdict_alone() == Some("fails") => VerdictShape::Certified,
                None => VerdictShape::Fails,
            },
            Standing::Open => VerdictShape::Undecided,
            Standing::Nowhere => VerdictShape::NotApplicable,
        }
    }

    /// The symbol of the sentence to which it is the contrary, and of which it holds.
    fn shape_as_contrary(&self) -> VerdictShape {
        match self.basis() {
            Basis::Sampled(_) => VerdictShape::Fails,
            _ => VerdictShape::Certified,
        }
    }

    /// On how many motions it fails, members of families among them.
    pub fn refuting(&self) -> usize {
        let members: usize = self.claim.families.iter().map(|f| super::family::with(f, "fails")).sum();
        self.claim.results.iter().filter(|p| matches!(p.verdict.outcome(), Outcome::Fails(_))).count() + members
    }

    /// How it is known that it holds.
    pub fn basis(&self) -> Basis {
        match &self.proof {
            ProofStanding::Proved => return Basis::Proved,
            ProofStanding::Except => return Basis::Except,
            ProofStanding::Given(open) => return Basis::Given(open.clone()),
            ProofStanding::Unreplayed => return Basis::Unreplayed,
            ProofStanding::Circular | ProofStanding::None => {}
        }
        if self.claim.region.is_some() {
            return Basis::Ranges;
        }
        let holds = |p: &&findings::PairAccount| matches!(p.verdict.outcome(), Outcome::Holds(_));
        let sampled = |p: &findings::PairAccount| p.verdict.outcome() == Outcome::Holds(Strength::Sampled);
        let n = self.claim.results.iter().filter(holds).count();
        let members: usize = self.claim.families.iter().map(|f| super::family::with(f, "holds")).sum();
        let n = n + members;
        if members > 0 || self.claim.results.iter().any(sampled) { Basis::Sampled(n) } else { Basis::Enclosed(n) }
    }
}

/// A claim with all its readings.
pub(super) struct Whole<'a> {
    pub id: &'a str,
    /// What it says, in the words of the file.
    pub says: String,
    pub place: Option<&'a str>,
    /// Whether the paper concludes it.
    pub conclusion: bool,
    pub readings: Vec<Reading<'a>>,
    pub fate: Fate,
}

impl<'a> Whole<'a> {
    /// Whether it has readings of which the file names each.
    pub fn is_read(&self) -> bool {
        self.readings.iter().any(|r| r.claim.reading.is_some())
    }

    /// The readings from which its fate follows; for what is none of the paper's claims, all.
    pub fn deciding(&self) -> impl Iterator<Item = &Reading<'a>> {
        self.readings.iter().filter(|r| r.role.decides() || !self.fate.is_of_the_paper())
    }

    /// How it is known that it stands: the weakest of what its readings rest on.
    pub fn basis(&self) -> Option<Basis> {
        self.deciding().filter(|r| r.standing == Standing::Holds).map(Reading::basis).min()
    }

    /// Its symbol.
    pub fn shape(&self) -> VerdictShape {
        match self.fate {
            Fate::Stands => self.basis().map_or(VerdictShape::Sampled, |basis| basis.shape()),
            Fate::Reading => VerdictShape::Meaning,
            Fate::Partly => VerdictShape::Mixed,
            Fate::Fails => self.deciding().find(|r| r.standing == Standing::Fails).map_or_else(
                || self.contrary().map_or(VerdictShape::Fails, Reading::shape_as_contrary),
                Reading::shape,
            ),
            Fate::Open | Fate::Untested => VerdictShape::Undecided,
            Fate::Nowhere | Fate::Choice | Fate::Lemma | Fate::Added => VerdictShape::NotApplicable,
        }
    }

    /// The reading that says the contrary, and holds.
    pub fn contrary(&self) -> Option<&Reading<'a>> {
        self.readings.iter().find(|r| r.role == ClaimRole::Against && r.standing == Standing::Holds)
    }

    /// Whether all that it says is proved for all values, given nothing that is not.
    pub fn is_proved(&self) -> bool {
        let applies = |r: &&Reading<'_>| r.standing != Standing::Nowhere;
        self.deciding().any(|r| r.proof == ProofStanding::Proved)
            && self.deciding().filter(applies).all(|r| r.proof == ProofStanding::Proved)
    }

    /// A reading that the paper needs, and that fails.
    pub fn failing_need(&self) -> Option<&Reading<'a>> {
        let fails = |r: &&Reading<'_>| matches!(r.standing, Standing::Fails | Standing::Mixed);
        self.readings.iter().filter(|r| r.role == ClaimRole::Needs).find(fails)
    }

    /// A reading that the paper needs, and that fails wherever it applies; of several that on most motions.
    pub fn failing_nowhere_true(&self) -> Option<&Reading<'a>> {
        let fails = |r: &&Reading<'_>| r.role == ClaimRole::Needs && r.standing == Standing::Fails;
        self.readings.iter().filter(fails).max_by_key(|r| r.refuting())
    }

    /// A reading from which its fate follows, and that fails on a motion that was drawn at random, beside those of the file.
    pub fn failing_drawn(&self) -> Option<&Reading<'a>> {
        self.deciding().find(|r| r.claim.drawn.as_ref().is_some_and(|d| d.found.is_some()))
    }

    /// The symbol of its failure on a motion that was drawn, where it stands on those of the file and nothing else is against it.
    pub fn shape_on_drawn(&self) -> Option<VerdictShape> {
        let found = self.failing_drawn().filter(|_| self.counted_as() == CountedFate::OnFile)?;
        let motion = found.claim.drawn.as_ref()?.found.as_ref()?;
        Some(match motion.verdict.outcome() {
            Outcome::Fails(Strength::Enclosed | Strength::Proved) => VerdictShape::Certified,
            _ => VerdictShape::Fails,
        })
    }

    /// What became of it, with what the paper needs of it, and with the motions that were drawn.
    pub fn counted_as(&self) -> CountedFate {
        match self.fate {
            Fate::Stands if self.failing_need().is_some() => CountedFate::AsSaid,
            Fate::Stands if self.failing_drawn().is_some() => CountedFate::OnFile,
            fate => CountedFate::Fate(fate),
        }
    }

    /// The readings that do not hold, of those that decide.
    pub fn all_failing(&self) -> impl Iterator<Item = &Reading<'a>> {
        self.deciding().filter(|r| matches!(r.standing, Standing::Fails | Standing::Mixed))
    }

    /// Of these the one that is refuted most: for all values before on motions, on more motions before on fewer.
    pub fn failing(&self) -> Option<&Reading<'a>> {
        let weight = |r: &Reading<'_>| (r.claim.verdict_alone() == Some("fails"), r.refuting(), r.standing);
        self.all_failing().reduce(|a, b| if weight(b) > weight(a) { b } else { a })
    }
}

/// The claims of an account, in the order of the file.
pub(super) fn wholes<'a>(derivation: &'a Derivation, account: &'a Account) -> Vec<Whole<'a>> {
    let graph = DerivationGraph::new(derivation, account);
    let mut out: Vec<Whole<'a>> = Vec::new();
    for claim in &account.claims {
        let declared = declared(derivation, claim);
        let reading = Reading::of(derivation, &graph, claim);
        match out.last_mut() {
            Some(whole) if whole.id == claim.id => whole.readings.push(reading),
            _ => {
                let parent = declared.and_then(|d| d.parent_says.clone());
                let says = parent.unwrap_or_else(|| claim.says.clone());
                let (place, conclusion) = (claim.place.as_deref(), declared.is_some_and(|d| d.conclusion));
                let readings = vec![reading];
                out.push(Whole { id: &claim.id, says, place, conclusion, readings, fate: Fate::Nowhere });
            }
        }
    }
    for whole in &mut out {
        whole.fate = Fate::of(&whole.readings);
    }
    out
}

/// Several parts as one: `a, b, and c`.
pub(super) fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [one, last] => format!("{one} and {last}"),
        [more @ .., last] => format!("{}, and {last}", more.join(", ")),
    }
}

/// A condition under which claims hold that fail without it.
pub(super) struct Unsaid<'a> {
    pub explanation: &'a Explanation,
    /// The claims and readings that it separates, in the order of the file.
    pub claims: Vec<&'a ClaimAccount>,
}

/// Fewest motions that tell what separates them where several conditions do: one that holds and one that fails differ in much.
const FEWEST_SEPARATED: usize = 3;

/// Every condition that separates the motions of some claim of the paper: those of most claims first.
pub(super) fn unsaid<'a>(derivation: &Derivation, account: &'a Account) -> Vec<Unsaid<'a>> {
    let mut out: Vec<Unsaid<'a>> = Vec::new();
    let of_paper = |c: &&ClaimAccount| declared(derivation, c).is_none_or(|d| d.role.is_of_the_paper());
    for claim in account.claims.iter().filter(of_paper) {
        let separation = claim.conditions.separation.as_ref();
        let is_told = |s: &&Separation| {
            s.holds.len() + s.fails.len() >= FEWEST_SEPARATED || s.rivals.is_empty() && s.more_rivals == 0
        };
        let separation = separation.filter(is_told);
        let Some(explanation) = separation.and_then(Separation::told) else { continue };
        match out.iter_mut().find(|u| u.explanation == explanation) {
            Some(known) => known.claims.push(claim),
            None => out.push(Unsaid { explanation, claims: vec![claim] }),
        }
    }
    out.sort_by_key(|u| std::cmp::Reverse(u.claims.len()));
    out
}

/// A condition in the words of the file; its formula, between dollar signs, where it has none.
pub(super) fn condition(c: &ConditionName) -> String {
    let text = match (&c.id, &c.says) {
        (Some(_), Some(says)) => says.trim_end_matches('.').to_owned(),
        (None, Some(says)) => format!("${}$ {says}", c.formula),
        (_, None) => format!("${}$", c.formula),
    };
    if c.negated { format!("it is not so that {text}") } else { text }
}

/// Conditions put together: `A, and B`.
pub(super) fn explanation(e: &Explanation) -> String {
    let parts: Vec<String> = e.conditions.iter().map(condition).collect();
    match e.join {
        Join::And => parts.join(", and "),
        Join::Or => parts.join(", or "),
    }
}

/// How a refutation is known, over all pairs of a reading that fail: the strongest.
fn strongest_refutation(claim: &ClaimAccount) -> Option<Strength> {
    let of = |outcome| if let Outcome::Fails(strength) = outcome { Some(strength) } else { None };
    claim.verdicts().filter_map(|j| of(j.verdict.outcome())).max()
}

/// The same in a word.
fn refuted(claim: &ClaimAccount) -> &'static str {
    match strongest_refutation(claim) {
        Some(Strength::Proved | Strength::Enclosed) => "certified",
        Some(Strength::Sampled) => "at samples",
        None => "",
    }
}

/// Where a reading holds, in a few words; the beginning of a sentence.
pub(super) fn verdict(reading: &Reading<'_>) -> String {
    if let Some(region) = &reading.claim.region {
        if region.is_of_fields() {
            return match region.verdict.outcome().word() {
                "holds" => "Holds for all fields".to_owned(),
                "fails" => "Fails for some fields".to_owned(),
                _ => "Undecided".to_owned(),
            };
        }
        let (word, rest) = match region.verdict.outcome().word() {
            "holds" => ("Holds", " over the ranges"),
            "fails" => ("Fails", " over the ranges"),
            "undecided" => ("Undecided", " over the ranges"),
            _ => ("Applies", " nowhere in the ranges"),
        };
        return format!("{word}{rest}");
    }
    match reading.claim.verdict_alone() {
        Some("fails") => return "Refuted for all values".to_owned(),
        Some("undecided") => return "Undecided for all values".to_owned(),
        _ => {}
    }
    let members = |word: &str| reading.claim.families.iter().map(|f| super::family::with(f, word)).sum::<usize>();
    let n = |word: &str| {
        reading.claim.results.iter().filter(|r| r.verdict.outcome().word() == word).count() + members(word)
    };
    let how = refuted(reading.claim);
    let has_members = ["holds", "fails", "undecided"].into_iter().any(|word| members(word) > 0);
    let among = if has_members { ", members of families among them" } else { "" };
    let applies = if n("not-applicable") > 0 { " to which it applies" } else { "" };
    match reading.standing {
        Standing::Holds => format!("Holds, {}", reading.basis().words()),
        Standing::Fails => match n("fails") {
            1 if n("undecided") == 0 => format!("Fails on the one motion{applies} ({how})"),
            f if n("undecided") > 0 => format!("Fails on {} ({how}), undecided on others", count(f, "motion")),
            2 => format!("Fails on both motions{applies} ({how})"),
            f => format!("Fails on all {f} motions{applies}{among} ({how})"),
        },
        Standing::Mixed => {
            let of = n("holds") + n("fails") + n("undecided");
            format!("Fails on {} of {of} motions{applies}{among} ({how})", n("fails"))
        }
        Standing::Open if n("holds") > 0 => {
            format!("Holds on {}, undecided on {}", count(n("holds"), "motion"), n("undecided"))
        }
        Standing::Open => format!("Undecided on {}", count(n("undecided"), "motion")),
        Standing::Nowhere => "Applies to none of the motions".to_owned(),
    }
}

/// What a mixed reading needs, as far as the motions that were tried show. What separates members of a family is said with the family.
pub(super) fn condition_of(claim: &ClaimAccount) -> Option<String> {
    let s = claim.conditions.separation.as_ref()?;
    if s.explanation.is_none() {
        let mut separations = claim.families.iter().filter_map(|f| f.separation.as_ref());
        let motions = if claim.families.is_empty() { "them" } else { "those by themselves" };
        return match separations.any(|s| s.explanation.is_some()) {
            true => None,
            false => Some(format!("no condition that was tried separates {motions}")),
        };
    }
    // What separates few motions by accident is not said.
    let e = s.told()?;
    let rivals = match s.rivals.len() + s.more_rivals {
        0 => "",
        1 => " (one other condition fits as well)",
        _ => " (other conditions fit as well)",
    };
    Some(format!("on the motions tried, it holds exactly where {}{rivals}", explanation(e)))
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use ClaimRole::{Added, Against, Choice, Lemma, MayMean, Needs, Says};
    use Standing::{Fails, Holds, Mixed, Nowhere, Open};
    use findings::sample;

    fn fate(readings: &[(ClaimRole, Standing)]) -> Fate {
        let account = sample::account();
        let reading = |&(role, standing): &(ClaimRole, Standing)| Reading {
            claim: &account.claims[0],
            standing,
            role,
            proof: ProofStanding::None,
        };
        Fate::of(&readings.iter().map(reading).collect::<Vec<_>>())
    }

    #[test]
    fn a_sentence_stands_only_if_all_that_it_says_does() {
        for (standings, expected) in [
            (&[Holds][..], Fate::Stands),
            (&[Holds, Nowhere], Fate::Stands),
            (&[Holds, Open], Fate::Open),
            (&[Holds, Mixed], Fate::Partly),
            (&[Holds, Fails, Open], Fate::Fails),
            (&[Mixed], Fate::Partly),
            (&[Mixed, Fails, Open], Fate::Fails),
            (&[Fails, Nowhere], Fate::Fails),
            (&[Nowhere], Fate::Nowhere),
            (&[], Fate::Nowhere),
        ] {
            let readings: Vec<_> = standings.iter().map(|s| (Says, *s)).collect();
            assert_eq!(fate(&readings), expected, "{standings:?}");
        }
    }

    #[test]
    fn meanings_are_weighed_against_one_another() {
        assert_eq!(fate(&[(MayMean, Holds), (MayMean, Mixed)]), Fate::Reading);
        assert_eq!(fate(&[(MayMean, Holds), (MayMean, Holds)]), Fate::Stands);
        assert_eq!(fate(&[(MayMean, Fails), (MayMean, Fails)]), Fate::Fails);
        assert_eq!(fate(&[(MayMean, Fails), (MayMean, Mixed)]), Fate::Partly);
        assert_eq!(fate(&[(Says, Fails), (MayMean, Holds)]), Fate::Fails);
        assert_eq!(fate(&[(Says, Holds), (MayMean, Holds), (MayMean, Open)]), Fate::Open);
    }

    #[test]
    fn what_the_paper_does_not_say_decides_nothing() {
        for other in [Needs, Against, Added, Lemma, Choice] {
            for standing in [Holds, Mixed, Fails, Open, Nowhere] {
                assert_eq!(fate(&[(Says, Holds), (other, standing)]), Fate::Stands, "{other:?}");
                assert_eq!(fate(&[(Says, Fails), (other, standing)]), Fate::Fails, "{other:?}");
                assert_eq!(fate(&[(Says, Mixed), (other, standing)]), Fate::Partly, "{other:?}");
            }
        }
        // But for the contrary, where the sentence itself is not decided.
        assert_eq!(fate(&[(Says, Open), (Against, Holds)]), Fate::Fails);
        assert_eq!(fate(&[(Says, Open), (Against, Mixed)]), Fate::Open);
        assert_eq!(fate(&[(Against, Holds)]), Fate::Fails);
        assert_eq!(fate(&[(Says, Open), (Added, Holds)]), Fate::Open);
        assert_eq!(fate(&[(Needs, Fails)]), Fate::Untested);
        assert_eq!(fate(&[(MayMean, Holds), (Against, Holds)]), Fate::Reading);
    }

    #[test]
    fn what_is_no_claim_of_the_paper_is_not_counted() {
        assert_eq!(fate(&[(Added, Holds), (Added, Fails)]), Fate::Added);
        assert_eq!(fate(&[(Lemma, Holds)]), Fate::Lemma);
        assert_eq!(fate(&[(Choice, Mixed)]), Fate::Choice);
        assert!([Fate::Added, Fate::Lemma, Fate::Choice].iter().all(|f| !f.is_of_the_paper() && !f.is_against()));
    }

    #[test]
    fn every_claim_is_counted_once() {
        let (derivation, account) = (derivation(), sample::account());
        let wholes = wholes(&derivation, &account);
        let readings: usize = wholes.iter().map(|w| w.readings.len()).sum();
        assert_eq!(readings, account.claims.len());
        let told: usize = Fate::ALL.iter().map(|f| wholes.iter().filter(|w| w.fate == *f).count()).sum();
        assert_eq!(told, wholes.len());
    }
}
