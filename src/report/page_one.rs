//! Page one: what a reader asks first, on one screen, made once as a story and printed four ways.
//!
//! **In:** a derivation and its account. **Out:** the sentence; the matrix of the claims that matter; what is wrong, each as a card; the
//! conclusions with the chain under each; what the steps use and do not say; how to repeat it.
//!
//! **Guaranteed:** every part is there and bounded, whatever the file: without motions, without a failure, with a thousand claims.

use std::collections::{BTreeMap, BTreeSet};

use super::argument;
use super::card;
use super::consequence::Consequences;
use super::digest::{self, Fate, Reading, Whole};
use super::discrimination;
use super::drawn;
use super::front::{self, Front, Line};
use super::headline::{self, CountedFate};
use super::hypotheses;
use super::limited::{self, Limited};
use super::motion_matrix::{self, that_matter};
use super::numbers::count;
use super::said;
use super::sketch::Sketch;
use super::story::{self, Elsewhere, StoryBlock, StorySpan, Tone, fold, folded as folded_as, quiet, roomy, words};
use super::tally::{Standing, declared, name};
use super::text::{Paint, capital, paragraph, uncapital};
use derivation::Derivation;
use findings::conditions::Separation;
use findings::{Account, Correction};

/// Most claims of a list in a sentence.
const MOST_NAMED: usize = 6;
/// Longest words for a claim that is not as the file expects, in letters.
const LONGEST_NAME: usize = 60;
/// The same in a list of those that have a card on the page.
const LONGEST_LISTED: usize = 36;
/// Cards on the first screen; more are folded. Conclusions need the room of those that a terminal leaves out, too.
const MOST_CARDS: usize = 3;
/// Most lines of a terminal that have the remark of a file; the rest is folded.
const MOST_REMARKED: usize = 3;
/// Longest words for a claim on which a conclusion rests, in letters.
const LONGEST_GROUND: usize = 34;
/// Most labels and letters that a sentence lists.
const MOST_LABELS: usize = 12;
/// Longest formula, in bytes of LaTeX, that a sentence quotes.
const LONGEST_TOLD: usize = 80;
/// Cards that a terminal has room for, if there are few of them; of more only the first.
const FEW_CARDS: usize = 2;

/// The page as blocks; the last has no room on the first screen.
pub(super) fn blocks<'a>(derivation: &'a Derivation, account: &'a Account) -> Vec<StoryBlock<'a>> {
    let wholes = digest::wholes(derivation, account);
    let hangs = Consequences::new(derivation);
    let front = Front::of(derivation, account, &wholes, &hangs);
    let scope = &derivation.scope;
    let mut head = headline(derivation, account, &wholes, &hangs, &front);
    for alarm in &front.alarms {
        head.push(StoryBlock::Paragraph(vec![StorySpan::Prose(format!("! {alarm}"), scope, Tone::Alarm)]));
    }
    head.extend(not_as_expected(derivation, account, &wholes));
    head.extend(remark(derivation));
    // What fails as the paper uses it, or on a motion that was drawn, is not shown as what stands.
    let field = |w: &Whole<'_>| w.counted_as().shape().unwrap_or_else(|| w.shape());
    let fields = wholes.iter().filter(|w| w.fate.is_of_the_paper()).map(field);
    let strip = Sketch::Strip(fields.collect());
    let shown = front.lines.first().map(|l| l.id.as_str());
    let concludes = argument::blocks(derivation, &wholes, &hangs, shown);
    let mut matrix =
        vec![StoryBlock::Group("strip", vec![StoryBlock::Figure(strip, vec![quiet("its claims in order")])])];
    matrix.extend(motion_matrix::blocks(derivation, account, (&wholes, &hangs), story::shapes(&concludes)));
    // What has no room on the first screen: the counts, where they are not the first sentence, and how much is proved.
    let counts = [Some(headline::headline(&wholes)), front.strength.clone()].into_iter().flatten();
    let counts = counts.filter(|_| has_sentences(derivation, account, &wholes, &hangs));
    let strength = counts.chain(front.proofs.clone()).chain(front.beside.clone());
    let strength = strength.map(|text| StorySpan::Prose(format!("{text} "), scope, Tone::Quiet)).collect();
    let mut unsaid = limited::limits(derivation, &wholes, &hangs);
    unsaid.extend(hypotheses::blocks(derivation, account, &wholes));
    let author = front.author.trim_end_matches('.');
    let (author, rest) = author.split_at(author.find(';').unwrap_or(author.len()));
    let rest = StorySpan::Roomy(vec![StorySpan::Prose(rest.to_owned(), scope, Tone::Quiet)]);
    let mut foot = vec![StorySpan::Prose(author.to_owned(), scope, Tone::Quiet), rest, quiet(". To repeat it: ")];
    foot.extend([StorySpan::Code(front.command.clone()), roomy(format!(" ({})", front.version)), quiet(".")]);
    vec![
        StoryBlock::Group("head", head),
        StoryBlock::Group("matters", matrix),
        StoryBlock::Group(
            "argues",
            vec![
                StoryBlock::Group("cards", wrong(derivation, &wholes, &hangs, &front)),
                StoryBlock::Group("drawn", drawn::blocks(derivation, &wholes)),
                StoryBlock::Group("concludes", concludes),
            ],
        ),
        StoryBlock::Group("unsaid", unsaid),
        StoryBlock::Group("foot", vec![StoryBlock::Paragraph(foot)]),
        StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(strength)]),
    ]
}

/// The claims of which a verdict is not as the file expects, here and nowhere else; a terminal tells of each by itself.
fn not_as_expected<'a>(derivation: &'a Derivation, account: &Account, wholes: &[Whole<'a>]) -> Option<StoryBlock<'a>> {
    let names: BTreeSet<&str> = headline::unexpected(account).into_iter().map(|c| c.id.as_str()).collect();
    let all: Vec<&Whole<'a>> = wholes.iter().filter(|w| names.contains(w.id)).collect();
    let mut line = vec![StorySpan::Words("Not as the file expects: ".to_owned(), Tone::Alarm)];
    line.extend(said::list(derivation, &all, (MOST_NAMED, LONGEST_NAME), 0));
    line.push(words("."));
    (!all.is_empty()).then(|| StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(line)]))
}

/// Whether something is said of printed equations or of conclusions, before claims are counted.
fn has_sentences(derivation: &Derivation, account: &Account, wholes: &[Whole<'_>], hangs: &Consequences<'_>) -> bool {
    equations(derivation, account, wholes).is_some() || conclusions(wholes, hangs).is_some()
}

/// The first sentences, for a reader who knows none of the words of a report: what became of the printed equations, where the argument goes
/// wrong, what became of the conclusions; and the counts. Of a paper without labels and conclusions the counts are the first sentence.
fn headline<'a>(
    derivation: &'a Derivation,
    account: &Account,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
    front: &Front,
) -> Vec<StoryBlock<'a>> {
    let scope = &derivation.scope;
    let of_equations = equations(derivation, account, wholes);
    let of_conclusions = conclusions(wholes, hangs);
    let is_short = !has_sentences(derivation, account, wholes, hangs);
    let mut counts = vec![StorySpan::Prose(headline::headline(wholes), scope, Tone::Strong)];
    counts.extend(front.strength.iter().map(|text| StorySpan::Prose(format!(" {text}"), scope, Tone::Quiet)));
    let limited = limited::limited(derivation, wholes, hangs);
    let besides = limited.first().and_then(|first| needed_besides(wholes, hangs, Some(first.whole.id)));
    let gap = gap(&limited, wholes, front).map(|text| text + " " + &besides.unwrap_or_default());
    let sentences = of_equations.into_iter().chain(gap).chain(of_conclusions);
    let sentence = |text| StoryBlock::Paragraph(vec![StorySpan::Prose(text, scope, Tone::Strong)]);
    let mut first: Vec<StoryBlock<'a>> = sentences.map(sentence).collect();
    if is_short {
        first.insert(0, StoryBlock::Paragraph(counts));
    }
    vec![StoryBlock::Group("headline", first)]
}

/// How a printed equation stands; the worst comes last.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum StandsAs {
    Printed,
    /// Its proof uses a condition that nothing says.
    Conditional,
    /// It fails on a motion that was drawn, beside those of the file.
    OnFile,
}

/// What became of the printed equations: those that hold as they are printed, and the others by what became of the worst claim on them.
fn equations(derivation: &Derivation, account: &Account, wholes: &[Whole<'_>]) -> Option<String> {
    let unsaid = hypotheses::claims_with_unsaid(derivation, account, wholes);
    let mut labels: Vec<(&str, (Fate, StandsAs))> = Vec::new();
    for whole in wholes.iter().filter(|w| w.fate.is_of_the_paper()) {
        let label = whole.readings.iter().find_map(|r| declared(derivation, r.claim)?.label.as_deref());
        let Some(label) = label else { continue };
        let stands_as = match whole.counted_as() {
            CountedFate::OnFile => StandsAs::OnFile,
            _ if whole.deciding().any(|r| unsaid.contains(&name(r.claim))) => StandsAs::Conditional,
            _ => StandsAs::Printed,
        };
        match labels.iter_mut().find(|(known, _)| *known == label) {
            Some((_, worst)) => *worst = (whole.fate.min(worst.0), stands_as.max(worst.1)),
            None => labels.push((label, (whole.fate, stands_as))),
        }
    }
    let mut parts = Vec::new();
    let standing = [StandsAs::Printed, StandsAs::Conditional, StandsAs::OnFile];
    let kinds = standing.map(|of| (Fate::Stands, Some(of))).into_iter();
    let others = Fate::TOLD.into_iter().filter(|fate| *fate != Fate::Stands).map(|fate| (fate, None));
    for (fate, stands_as) in kinds.chain(others) {
        let is_it = |found: &(Fate, StandsAs)| found.0 == fate && stands_as.is_none_or(|of| of == found.1);
        let of: Vec<String> = labels.iter().filter(|(_, f)| is_it(f)).map(|(l, _)| (*l).to_owned()).collect();
        let shown = &of[..of.len().min(MOST_LABELS)];
        let more = (of.len() > shown.len()).then(|| format!("{} more", of.len() - shown.len()));
        let listed = digest::listed(&shown.iter().cloned().chain(more).collect::<Vec<_>>());
        let word = match (parts.is_empty(), of.len()) {
            (_, 0) => continue,
            (false, _) => "",
            (true, 1) => "Equation ",
            (true, _) => "Equations ",
        };
        let verb = match (fate, of.len()) {
            (Fate::Stands, n) => match (stands_as, n) {
                (Some(StandsAs::Conditional), 1) => "holds under conditions that it does not say",
                (Some(StandsAs::Conditional), _) => "hold under conditions that they do not say",
                (Some(StandsAs::OnFile), n) => CountedFate::OnFile.words(n),
                (Some(StandsAs::Printed) | None, 1) => "holds as printed",
                (Some(StandsAs::Printed) | None, _) => "hold as printed",
            },
            (Fate::Reading, 1) if !parts.is_empty() => "only in one of its readings",
            (Fate::Reading, _) if !parts.is_empty() => "only in one of their readings",
            (fate, n) => fate.words(n),
        };
        parts.push(format!("{word}{listed} {verb}"));
    }
    (!parts.is_empty()).then(|| format!("{}.", parts.join("; ")))
}

/// Where the argument goes wrong: at a claim that holds as it is stated and fails as it is used, which most others assume; where there is
/// none, at the heaviest of those that do not hold.
fn gap(limited: &[Limited<'_, '_>], wholes: &[Whole<'_>], front: &Front) -> Option<String> {
    let fails_on = |reading: &Reading<'_>| {
        let text = digest::verdict(reading).replace(" to which it applies", "");
        text.strip_prefix("Fails on ")
            .map(|rest| format!("fails on {rest}"))
            .unwrap_or_else(|| format!("fails: {}", uncapital(&text)))
    };
    let quoted = |whole: &Whole<'_>| format!("“{}”", whole.says.trim_end_matches('.'));
    if let Some(first) = limited.first() {
        let sense = |r: &Reading<'_>| match r.claim.reading {
            Some(_) => format!(" ({})", uncapital(r.claim.says.trim_end_matches('.'))),
            None => String::new(),
        };
        let stated = first.whole.deciding().find(|r| r.standing == Standing::Holds).map(sense).unwrap_or_default();
        return Some(format!(
            "{} holds as stated{stated}, but {} as used{}.",
            quoted(first.whole),
            fails_on(first.used).trim_end_matches(" (certified)"),
            sense(first.used)
        ));
    }
    let heaviest = front.lines.first()?;
    let whole = wholes.iter().find(|w| w.id == heaviest.id)?;
    Some(match (whole.failing(), whole.contrary()) {
        (Some(failing), _) => match corrected(failing) {
            Some(found) => {
                let (printed, right) = (found.printed.trim(), found.formula.trim());
                let how = discrimination::alone(failing.claim, found).unwrap_or_else(|| " instead".to_owned());
                format!("{}, tested as ${printed}$, {}; ${right}$ holds{how}.", quoted(whole), fails_on(failing))
            }
            None => format!("{} {}.", quoted(whole), fails_on(failing)),
        },
        (None, Some(contrary)) => {
            format!("{} is false: the contrary holds, {}.", quoted(whole), contrary.basis().words())
        }
        (None, None) => format!("{} {}.", quoted(whole), whole.fate.words(1)),
    })
}

/// The formula of a claim that fails, and the nearest right one, where both are short: the words of a sentence may say what is right.
fn corrected<'a>(failing: &Reading<'a>) -> Option<&'a Correction> {
    let found = card::correction(failing.claim)?;
    let is_short = |formula: &str| formula.len() <= LONGEST_TOLD && !formula.contains('$');
    (is_short(&found.printed) && is_short(&found.formula)).then_some(found)
}

/// What the argument of the paper needs besides, and what fails on every motion: premises that exclude one another, an effect that a
/// motion shows all the same. Of these the one under which most conclusions stand, and not one that is told already.
fn needed_besides(wholes: &[Whole<'_>], hangs: &Consequences<'_>, told: Option<&str>) -> Option<String> {
    let fails = |w: &Whole<'_>| -> bool { w.failing_nowhere_true().is_some() };
    let others =
        wholes.iter().filter(|w| Some(w.id) != told && !w.fate.is_against() && w.fate.is_of_the_paper() && fails(w));
    let whole = others.reduce(|a, b| if hangs.weight(b.id) > hangs.weight(a.id) { b } else { a })?;
    let reading = whole.failing_nowhere_true()?;
    let on = digest::verdict(reading).replace(" to which it applies", "");
    let on = on.trim_end_matches(" (certified)").trim_end_matches(" (at samples)");
    let on = uncapital(on.trim_end_matches(" motions"));
    Some(format!("The paper also needs “{}”, which {on}.", reading.claim.says.trim_end_matches('.')))
}

/// What became of the conclusions, by their letters.
fn conclusions(wholes: &[Whole<'_>], hangs: &Consequences<'_>) -> Option<String> {
    let by_id: BTreeMap<&str, &Whole<'_>> = wholes.iter().map(|w| (w.id, w)).collect();
    let all: Vec<&Whole<'_>> = hangs.conclusions().iter().filter_map(|id| by_id.get(id).copied()).collect();
    if all.is_empty() {
        return None;
    }
    let on = |breaks: fn(&Whole<'_>) -> bool| hangs.resting_on(wholes.iter().filter(|w| breaks(w)).map(|w| w.id));
    let (against, needed) = (on(|w| w.fate.is_against()), on(|w| w.failing_need().is_some()));
    let heaviest = |whole: &Whole<'_>, breaks: fn(&Whole<'_>) -> bool| {
        let grounds = hangs.grounds_of(whole.id);
        let broken = grounds.into_iter().filter_map(|id| by_id.get(id).copied()).filter(|w| breaks(w));
        broken.reduce(|a, b| if hangs.weight(b.id) > hangs.weight(a.id) { b } else { a })
    };
    let after = |whole: &Whole<'_>| match () {
        () if against.contains(whole.id) => broken_ground(heaviest(whole, |w| w.fate.is_against())),
        () if needed.contains(whole.id) => match heaviest(whole, |w| w.failing_need().is_some()) {
            Some(ground) => {
                format!(", but rests on {}, which fails as it is used", said::quoted(ground, LONGEST_GROUND))
            }
            None => ", but rests on claims that fail as they are used".to_owned(),
        },
        () => String::new(),
    };
    let mut groups: Vec<(CountedFate, String, Vec<String>)> = Vec::new();
    for whole in &all {
        let key = (whole.counted_as(), if whole.fate.is_against() { String::new() } else { after(whole) });
        let letter = hangs.letter(whole.id).map_or_else(|| whole.id.to_owned(), String::from);
        match groups.iter_mut().find(|(fate, after, _)| *fate == key.0 && *after == key.1) {
            Some((.., letters)) => letters.push(letter),
            None => groups.push((key.0, key.1, vec![letter])),
        }
    }
    let part = |(fate, after, letters): &(CountedFate, String, Vec<String>)| {
        let n = letters.len();
        let verb = match fate {
            CountedFate::Fate(Fate::Stands) if n == 1 => "holds",
            CountedFate::Fate(Fate::Stands) => "hold",
            fate => fate.words(n),
        };
        // One that holds rests on what does not: with more of them the verb is another.
        let after = if n > 1 { after.replacen("but rests", "but rest", 1) } else { after.clone() };
        // One "but" is enough.
        let also = if n > 1 { "; they also rest" } else { "; it also rest" };
        let after = if fate.stands() { after } else { after.replacen(", but rest", also, 1) };
        format!("{} {verb}{after}", digest::listed(&letters[..n.min(MOST_LABELS)]))
    };
    let of =
        if all.len() == 1 { "Of its one conclusion".to_owned() } else { format!("Of its {} conclusions", all.len()) };
    Some(format!("{of} {}.", groups.iter().map(part).collect::<Vec<_>>().join("; ")))
}

/// That a conclusion rests on a claim that does not stand: which, and where it holds; else on how much it fails.
fn broken_ground(ground: Option<&Whole<'_>>) -> String {
    let Some(ground) = ground else { return ", but rests on claims that do not stand".to_owned() };
    let failing = ground.failing();
    let separation = failing.and_then(|r| r.claim.conditions.separation.as_ref());
    let why = match (failing, separation.and_then(Separation::told), ground.contrary()) {
        (Some(_), Some(told), _) => format!("on the motions tried holds exactly where {}", digest::explanation(told)),
        (Some(failing), None, _) => uncapital(&digest::verdict(failing)).replace(" to which it applies", ""),
        (None, _, Some(_)) => "is false: the contrary holds".to_owned(),
        (None, _, None) => ground.fate.words(1).to_owned(),
    };
    format!(", but rests on {}, which {}", said::quoted(ground, LONGEST_GROUND), why.trim_end_matches(" (certified)"))
}

/// What the file remarks: the sentences that have room in two lines of a terminal, and the others folded.
fn remark(derivation: &Derivation) -> Option<StoryBlock<'_>> {
    const LEAD: &str = "Remark of the file: ";
    let text = derivation.remark.as_deref()?.trim();
    let fits = |end: &usize| paragraph(&format!("{LEAD}{}", &text[..*end]), 0).lines().count() <= MOST_REMARKED;
    let sentences = text.match_indices(". ").map(|(at, _)| at + 1).chain([text.len()]);
    let spaces = text.match_indices(' ').map(|(at, _)| at);
    let end = sentences.take_while(fits).last().or_else(|| spaces.take_while(fits).last()).unwrap_or(text.len());
    let (first, rest) = text.split_at(end);
    let dots = if first.ends_with('.') { "" } else { " …" };
    let prose = |text: String| StorySpan::Prose(text.trim().to_owned(), &derivation.scope, Tone::Plain);
    let mut inside = vec![StoryBlock::Paragraph(vec![quiet(LEAD), prose(format!("{first}{dots}"))])];
    if !rest.trim().is_empty() {
        let blocks = vec![StoryBlock::Paragraph(vec![prose(rest.to_owned())])];
        inside.push(fold("The rest of the remark", blocks));
    }
    Some(StoryBlock::Group("remark", inside))
}

/// What does not stand, as cards; where all stands, what most rests on, as it is printed.
fn wrong<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
    front: &Front,
) -> Vec<StoryBlock<'a>> {
    if front.lines.is_empty() {
        return nothing_wrong(derivation, wholes, hangs, front);
    }
    let of = |line: &Line| wholes.iter().find(|w| w.id == line.id);
    let cards = front.lines.iter().enumerate().filter_map(|(at, line)| {
        // The only one has no number.
        let number = if front.lines.len() > 1 { at + 1 } else { 0 };
        Some(StoryBlock::Group("card", card::blocks(derivation, of(line)?, line, number)))
    });
    let mut cards: Vec<StoryBlock<'a>> = cards.collect();
    let on_terminal = if front.lines.len() <= MOST_CARDS { FEW_CARDS } else { 1 };
    let most = if hangs.conclusions().is_empty() { MOST_CARDS } else { on_terminal };
    let folded = cards.split_off(cards.len().min(most));
    // Beside conclusions a terminal has no room for names.
    let all = front.lines.len() + front.more;
    let names_them = hangs.conclusions().is_empty() || all <= on_terminal;
    let title = if all == 1 {
        "What does not stand".to_owned()
    } else if names_them {
        "What does not stand, the heaviest first".to_owned()
    } else {
        format!("What does not stand, the heaviest of {all}")
    };
    let mut out = vec![StoryBlock::Heading(title)];
    let roomy = cards.split_off(cards.len().min(on_terminal));
    out.extend(cards);
    if !roomy.is_empty() {
        out.push(StoryBlock::Group("roomy", roomy));
    }
    let named: Vec<&Whole<'a>> = front.lines.iter().skip(on_terminal).filter_map(of).collect();
    if !named.is_empty() {
        let title = format!("{} more", folded.len() + front.more);
        let mut line = vec![words("Others that do not stand: ")];
        line.extend(said::list(derivation, &named, (MOST_NAMED, LONGEST_LISTED), front.more));
        line.push(words("."));
        let line = if names_them { line } else { Vec::new() };
        out.push(folded_as(vec![words(title)], Elsewhere::Line(line), folded));
    }
    // Beside conclusions there is no room for what the paper does not say.
    if hangs.conclusions().is_empty() {
        out.extend(compared(derivation, &front::refuted_beside(wholes).collect::<Vec<_>>()));
    }
    out
}

/// What was added for comparison, and is refuted, by name: a sentence by itself, also where headings lead sentences.
fn compared<'a>(derivation: &'a Derivation, refuted: &[&Whole<'a>]) -> Option<StoryBlock<'a>> {
    let mut line = vec![quiet("Added for comparison, and refuted: ")];
    line.extend(said::list(derivation, refuted, (MOST_NAMED, LONGEST_LISTED), 0));
    line.push(words("."));
    (!refuted.is_empty()).then(|| StoryBlock::Group("compared", vec![StoryBlock::Paragraph(line)]))
}

/// Where nothing is wrong: the claim that most rests on, with both of its sides.
fn nothing_wrong<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
    front: &Front,
) -> Vec<StoryBlock<'a>> {
    let scope = &derivation.scope;
    let told = that_matter(derivation, wholes, hangs);
    let of_file: Vec<&Whole<'a>> = front::refuted_beside(wholes).collect();
    let on_file = wholes.iter().any(|w| w.counted_as() == CountedFate::OnFile);
    let title = match (on_file, of_file.is_empty()) {
        (true, _) => "No claim of the paper fails on a motion of the file",
        (false, true) => "Nothing is refuted",
        (false, false) => "No claim of the paper is refuted",
    };
    let mut out = vec![StoryBlock::Heading(title.to_owned())];
    out.extend(compared(derivation, &of_file));
    let mut heaviest: Vec<&&Whole<'a>> = told.iter().collect();
    heaviest.sort_by_cached_key(|w| {
        let drawn = card::sketch_that_holds(w);
        let varies = drawn.as_ref().is_some_and(|(sketch, _)| sketch.varies());
        (!w.counted_as().stands(), drawn.is_none(), !varies, std::cmp::Reverse(hangs.weight(w.id)))
    });
    let Some(whole) = heaviest.first() else {
        out.push(StoryBlock::Paragraph(vec![quiet("The file has no claim.")]));
        return out;
    };
    let mut inside = vec![StoryBlock::Paragraph(vec![
        StorySpan::Prose(whole.says.clone(), scope, Tone::Strong),
        quiet(" ("),
        StorySpan::Claim(whole.id.to_owned(), Tone::Plain),
        quiet(")"),
    ])];
    let drawn = card::sketch_that_holds(whole);
    if let Some((sketch, _)) = &drawn {
        inside.push(StoryBlock::Figure(sketch.clone(), Vec::new()));
    }
    inside.extend(card::formula_line(derivation, whole).map(StoryBlock::Paragraph));
    let basis = whole.basis().map(|b| format!("Holds: {}", b.words()));
    let mut says = vec![StorySpan::Prose(basis.unwrap_or_else(|| capital(whole.fate.words(1))), scope, Tone::Plain)];
    if let Some((_, motion)) = &drawn {
        says.push(quiet(format!("; drawn: both sides on {motion}")));
    }
    says.push(words("."));
    inside.push(StoryBlock::Paragraph(says));
    let rest = hangs.carried_by(whole.id).len();
    if rest > 0 {
        let verb = if rest == 1 { "rests" } else { "rest" };
        inside.push(StoryBlock::Paragraph(vec![quiet(format!("{} {verb} on it.", count(rest, "claim")))]));
    }
    let card = StoryBlock::Group("card", inside);
    out.push(if whole.counted_as().stands() { StoryBlock::Group("good", vec![card]) } else { card });
    // What the paper itself says on a motion that was drawn needs the room of the others.
    let room = if on_file { 1 } else { front.compared.len() };
    let cards = front.compared.iter().take(room).enumerate().filter_map(|(at, line)| {
        let whole = wholes.iter().find(|w| w.id == line.id)?;
        Some(StoryBlock::Group("card", card::blocks(derivation, whole, line, at + 1)))
    });
    let cards: Vec<StoryBlock<'a>> = cards.collect();
    if !cards.is_empty() {
        let of =
            if cards.len() < of_file.len() { format!(", {} of {}", cards.len(), of_file.len()) } else { String::new() };
        let title = StoryBlock::Heading(format!("Added for comparison, and refuted{of}"));
        out.push(StoryBlock::Group("roomy", std::iter::once(title).chain(cards).collect()));
    }
    out
}

/// Page one for a terminal, with escape codes if `colour`.
pub fn front_page(derivation: &Derivation, account: &Account, colour: bool) -> String {
    let paint = Paint(colour);
    let title = paragraph(&derivation.title, 0);
    let head = format!("{}\n{}", paint.bold(title.trim_end()), paragraph(&derivation.concerns, 2));
    head + &story::terminal(&blocks(derivation, account), 0, paint)
}

/// Page one as Markdown.
pub fn front_markdown(derivation: &Derivation, account: &Account) -> String {
    use super::markup::prose;
    let head = format!("# {}\n\nWhat is checked: {}\n\n", prose(&derivation.title), prose(&derivation.concerns));
    head + &story::markdown(&blocks(derivation, account), &|id, words| {
        words.map_or_else(|| format!("`{id}`"), str::to_owned)
    })
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    /// The names of all groups of a story.
    fn groups(blocks: &[StoryBlock<'_>], out: &mut Vec<&'static str>) {
        for block in blocks {
            match block {
                StoryBlock::Group(name, inside) => {
                    out.push(name);
                    groups(inside, out);
                }
                StoryBlock::Fold(of) => groups(&of.blocks, out),
                StoryBlock::List(items) => items.iter().for_each(|item| groups(&item.below, out)),
                StoryBlock::Part(of) => groups(&of.blocks, out),
                StoryBlock::Heading(_)
                | StoryBlock::Paragraph(_)
                | StoryBlock::Formula(..)
                | StoryBlock::Lines(..)
                | StoryBlock::Embedded(_)
                | StoryBlock::Table(_)
                | StoryBlock::Figure(..) => {}
            }
        }
    }

    #[track_caller]
    fn has_all_parts(account: &findings::Account) -> String {
        let derivation = derivation();
        let story = blocks(&derivation, account);
        let mut found = Vec::new();
        groups(&story, &mut found);
        for part in ["headline", "strip", "matters", "cards", "concludes", "unsaid", "foot"] {
            assert!(found.contains(&part), "{part} is missing: {found:?}");
        }
        assert!(found.iter().filter(|g| **g == "card").count() <= 14);
        let text = front_page(&derivation, account, false);
        assert!(text.lines().count() < 80, "{text}");
        let page = story::html(&story, story::Medium::Screen).into_string();
        assert!(page.len() < 60_000, "{}", page.len());
        page
    }

    /// Claims that the file does not know, many of them, without motions, without a failure, or none at all.
    #[test]
    fn every_part_is_there_and_bounded_whatever_is_found() {
        let whole = sample::account();
        has_all_parts(&whole);
        has_all_parts(&findings::Account::default());
        let mut many = whole.clone();
        for at in 0..1000 {
            let mut claim = whole.claims[at % whole.claims.len()].clone();
            claim.id = format!("<stranger-{at}>");
            many.claims.push(claim);
        }
        let page = has_all_parts(&many);
        assert!(!page.contains("<stranger"), "an id is no markup");
        let mut without = many.clone();
        without.trajectories.clear();
        without.claims.iter_mut().for_each(|c| c.results.clear());
        has_all_parts(&without);
        let mut good = whole.clone();
        good.claims.retain(|c| super::super::tally::Standing::of(c) == super::super::tally::Standing::Holds);
        assert!(has_all_parts(&good).contains("Nothing is refuted"));
    }

    #[test]
    fn page_one_of_a_small_account() {
        insta::assert_snapshot!(front_page(&derivation(), &sample::account(), false));
        insta::assert_snapshot!(front_markdown(&derivation(), &sample::account()));
    }
}
