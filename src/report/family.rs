//! Claims on families of motions, in the words of every kind of report.

use super::conditions::explanation as explanation_of;
use super::numbers::{both, count, six, size, value};
use super::story::{Elsewhere, StoryBlock, StorySpan, Tone, folded, prose, quiet, strong, words};
use super::wording::label;
use derivation::{Claim, Dependence, End, Event, Form, Measure};
use findings::family::{FamilyMap, FamilySeparation, MeasureAccount, SHARES, SlopeAccount};
use findings::{ClaimAccount, FamilyAccount, MemberAccount};
use latex::Scope;

/// What a claim says of a quantity of members, for the heading of its formula, without an end; names are formulas between dollars.
/// `None` for a claim that does not compare members.
pub(super) fn compared(claim: &Claim) -> Option<String> {
    // Such a claim has no other form.
    let Some(Form::Across(across)) = claim.forms.first() else { return None };
    let with = format!("${}$", across.name);
    let point = across.point.as_ref().map(|p| p.text.as_str()).unwrap_or_default();
    let limit = across.value.as_ref().map(|v| v.text.as_str()).unwrap_or_default();
    let says = match across.dependence {
        Dependence::Independent => format!("Does not depend on {with}"),
        Dependence::Increasing => format!("Grows with {with}"),
        Dependence::Decreasing => format!("Falls with growing {with}"),
        Dependence::Power { power, to } => {
            format!("Scales as a power of {with}, whose exponent is {} to within {}", value(power), value(to))
        }
        Dependence::Extremum { maximum, to } => {
            let kind = if maximum { "largest" } else { "smallest" };
            format!("Is {kind} at ${}={point}$ to within {}", across.name, value(to))
        }
        Dependence::Limit { end, to } => {
            let end = match end {
                End::Number => point,
                End::Infinity => "\\infty",
                End::MinusInfinity => "-\\infty",
            };
            let name = &across.name;
            format!("Tends to ${limit}$ as ${name}\\rightarrow {end}$, to within {} by extrapolation", value(to))
        }
    };
    let when = claim.at.as_ref().map_or("", |at| if at.occasion.count.is_some() { ", when" } else { ", when first" });
    let event = |at: &Event| format!(" ${}${}", at.equation.text, at.occasion.words());
    let event = claim.at.as_ref().map(event).unwrap_or_default();
    Some(format!("{says}, between members that differ in it alone{when}{event}"))
}

/// A number of members.
fn members(n: u64, what: &str) -> String {
    count(usize::try_from(n).unwrap_or(usize::MAX), what)
}

/// How many members have a verdict, by its word.
pub(super) fn with(family: &FamilyAccount, word: &str) -> usize {
    let n = match word {
        "holds" => family.counts.holds,
        "fails" => family.counts.fails,
        "not-applicable" => family.counts.not_applicable,
        "undecided" => family.counts.undecided,
        _ => 0,
    };
    usize::try_from(n).unwrap_or(usize::MAX)
}

/// A share in percent, with two digits, rounded up.
fn percent(share: f64) -> String {
    let mut scale = 1.0;
    let mut digits = 0;
    let hundred = 100.0 * share;
    while hundred * scale < 10.0 && digits < 12 {
        scale *= 10.0;
        digits += 1;
    }
    format!("{:.digits$}", (hundred * scale).ceil() / scale)
}

/// The counts, in a sentence without its end.
pub(super) fn counts(family: &FamilyAccount) -> String {
    let of = members(family.counts.members, "member");
    let told = [
        (family.counts.fails, "fails on"),
        (family.counts.holds, "holds on"),
        (family.counts.undecided, "is undecided on"),
        (family.counts.not_applicable, "does not apply to"),
    ];
    let parts: Vec<String> = told.iter().filter(|(n, _)| *n > 0).map(|(n, words)| format!("{words} {n}")).collect();
    let all = match &parts[..] {
        [] => "no member was tried".to_owned(),
        [_] if family.counts.not_applicable == family.counts.members => format!("applies to none of {of} tried"),
        [one] if family.counts.members > 1 => {
            one.rsplit_once(' ').map_or(one.clone(), |(words, _)| format!("{words} all {of} tried"))
        }
        _ => format!("of {of} it {}", parts.join(", ")),
    };
    let rejected = match family.counts.rejected {
        0 => String::new(),
        n => format!("; {n} more did not satisfy the constraints and were not tried"),
    };
    let stopped = family.stopped.as_ref().map(|why| format!("; not all {} were tried: {why}", family.size));
    format!("{all}{rejected}{}", stopped.unwrap_or_default())
}

/// What the counts say of members that were not drawn, in a sentence without its end.
fn confidence(family: &FamilyAccount) -> Option<String> {
    let share = family.failing_share?;
    let fail = if family.counts.undecided > 0 { "fail or stay undecided" } else { "fail" };
    let applies = if family.counts.not_applicable > 0 { " to which it applies" } else { "" };
    Some(format!(
        "at most {} % of such members{applies} {fail}, with confidence {} %: that is said of random draws from these distributions, \
         and of nothing else",
        percent(share.at_most),
        100.0 * share.confidence,
    ))
}

/// What is said of a family beside its counts, each a sentence without its end; names are formulas between dollars.
pub(super) fn remarks(family: &FamilyAccount) -> Vec<String> {
    let found = confidence(family).into_iter().chain(family.map.as_ref().and_then(boundary));
    found.chain(family.slope.as_ref().map(slope)).chain(family.separation.as_ref().map(separation)).collect()
}

/// The slope of a scaling law over all members, and whether the claimed power lies in it: a sentence without its end.
fn slope(found: &SlopeAccount) -> String {
    let rounded = |x: f64| value(format!("{x:.5e}").parse().unwrap_or(x));
    let error = found.standard_error.map(|e| format!(" ± {e:.1e} (standard error)")).unwrap_or_default();
    let bound = if found.bound > 0.0 {
        format!(", errors of the quantities up to {:.1e} aside", found.bound)
    } else {
        String::new()
    };
    let lies =
        if found.contains { "lies within two standard errors" } else { "does not lie within two standard errors" };
    format!(
        "over {}, least squares give the slope {}{error}{bound}: the claimed power {} {lies}; single slopes are between {} and {}",
        count(usize::try_from(found.pairs).unwrap_or(usize::MAX), "pair"),
        rounded(found.slope),
        value(found.power),
        rounded(found.least),
        rounded(found.greatest),
    )
}

/// Which condition separates the members, and what it says of fresh ones: a sentence without its end; names are formulas between
/// dollars.
fn separation(found: &FamilySeparation) -> String {
    let (holds, fails) = found.sides;
    let Some(explanation) = &found.explanation else {
        return format!(
            "no condition of those that were tried separates {} on which it holds from {fails} on which it fails",
            count(holds, "member")
        );
    };
    let fresh = match found.right + found.wrong + found.open {
        0 => "; there are no fresh members to try that on".to_owned(),
        n => {
            let open = match found.open {
                0 => String::new(),
                open => format!(", and {open} undecided"),
            };
            let wrong = match &found.exception {
                None => String::new(),
                Some(of) => {
                    let values: Vec<String> = of.values.iter().map(|(name, x)| format!("${name}$ = {x:?}")).collect();
                    let says = if of.holds { "holds" } else { "fails" };
                    format!(": it {says} for {}", values.join(", "))
                }
            };
            let of = count(n, "fresh member");
            format!(
                "; of {of}, which were not used to find that, the condition is right on {}, wrong on {}{open}{wrong}",
                found.right, found.wrong
            )
        }
    };
    format!(
        "of {} it holds on the {holds} where {}, and fails on the {fails} others{fresh}",
        count(holds + fails, "member"),
        explanation_of(explanation),
    )
}

/// How finely the boundary on the map was found, in a sentence without its end; names are formulas between dollars.
fn boundary(map: &FamilyMap) -> Option<String> {
    let found = map.boundary.as_ref()?;
    let axes = [&map.across, &map.up].into_iter().zip(found.widths);
    let widths: Vec<String> =
        axes.filter_map(|(axis, width)| Some(format!("{} in ${}$", value(width?), axis.name))).collect();
    let wide = found.crossings.iter().filter(|c| !c.is_narrow).count();
    let open = if wide > 0 {
        format!(
            "; at {} it is undecided, or no motion, in between, and the two are further apart",
            count(wide, "of these")
        )
    } else {
        String::new()
    };
    let stopped = found.stopped.as_ref().map(|why| format!("; it was not finished: {why}")).unwrap_or_default();
    Some(format!(
        "between neighbours the verdict changes in {}, each found by bisection to {}, by {} beside the members{open}{stopped}",
        count(found.crossings.len(), "place"),
        widths.join(" or "),
        members(found.members, "motion"),
    ))
}

/// What a measure is of: the quantity itself, or what is taken of it between two events; formulas between dollars.
pub(super) fn taken(measure: &Measure) -> String {
    let of = format!("${}$", measure.formula.text);
    let event = |of: &Event| format!("${}${}", of.equation.text, of.occasion.words());
    match (&measure.at, &measure.since) {
        (None, _) => format!("{of}, at the initial time"),
        (Some(at), None) => format!("{of}, when {}", event(at)),
        (Some(at), Some((since, take))) => {
            format!("{} of {of} from the last {} to {}", take.words(), event(since), event(at))
        }
    }
}

/// How a measure is distributed over the members of a family: a sentence without its end.
pub(super) fn distribution(of: &MeasureAccount) -> String {
    let found = &of.distribution;
    let on = members(found.members, "member");
    let without = if found.without > 0 { format!("; no value on {}", found.without) } else { String::new() };
    let partial =
        if found.partial > 0 { format!("; on {} perhaps not all values", found.partial) } else { String::new() };
    let stopped = of.stopped.as_ref().map(|why| format!("; not all were tried: {why}")).unwrap_or_default();
    let quantile = |share: f64| {
        let (low, high) = found.quantile(share)?;
        Some(format!("{} % at most {}", 100.0 * share, value(0.5 * (low + high))))
    };
    let quantiles: Vec<String> = SHARES.into_iter().filter_map(quantile).collect();
    let range = match (&of.least, &of.greatest) {
        (Some(least), Some(greatest)) => format!(
            ", from {} (member {}) to {} (member {}); {}, to within 1/128",
            value(least.value),
            least.number,
            value(greatest.value),
            greatest.number,
            quantiles.join(", ")
        ),
        _ => String::new(),
    };
    format!("{} on {on}{range}{without}{partial}{stopped}", members(found.values(), "value"))
}

/// A member that is shown.
pub(super) struct Shown<'a> {
    /// What it is called: the beginning of a sentence that says which member it is.
    pub what: &'static str,
    pub member: &'a MemberAccount,
    /// What is seen on it, in a sentence without its end.
    pub seen: Option<String>,
}

impl Shown<'_> {
    /// Which member it is; names are formulas between dollars.
    pub fn named(&self) -> String {
        let values: Vec<String> =
            self.member.values.iter().map(|(name, x)| format!("${name}={}$", value(*x))).collect();
        format!("{} is member {}, {}", self.what, self.member.number, values.join(", "))
    }
}

/// The members that are shown, each once.
pub(super) fn shown(family: &FamilyAccount) -> Vec<Shown<'_>> {
    let same = |a: &Option<MemberAccount>, b: &Option<MemberAccount>| {
        a.as_ref().zip(b.as_ref()).is_some_and(|(a, b)| a.number == b.number)
    };
    let one = same(&family.first_failing, &family.clearest_failing);
    let first = if one { "The first and the clearest that fails" } else { "The first that fails" };
    let near = family.closest_gap.map(|gap| {
        format!("its sides come nearer than those of the others: at samples, up to {} of their size", size(gap))
    });
    let all = [
        (first, family.first_failing.as_ref(), None),
        ("The clearest that fails", family.clearest_failing.as_ref().filter(|_| !one), None),
        ("The first that is undecided", family.first_undecided.as_ref(), None),
        ("The closest call among those that hold", family.closest_call.as_ref(), near),
    ];
    let told = |(what, member, near): (&'static str, Option<_>, Option<String>)| {
        let member = member?;
        Some(Shown { what, member, seen: near.or_else(|| point(member)) })
    };
    all.into_iter().filter_map(told).collect()
}

/// Where a member fails, or why it is undecided, in a sentence without its end.
fn point(of: &MemberAccount) -> Option<String> {
    let evidence = of.verdict.evidence();
    match (&evidence.witness, &evidence.reason) {
        (Some(w), _) => {
            let ((left, right), t, bound) = (both(w.left, w.right), six(w.t), size(w.bound));
            let of = label(&w.formula);
            let component = of.component.map(|c| format!(", component ${c}$")).unwrap_or_default();
            Some(format!(
                "at t = {t}, for {}${}${}{component}, the left side is {left}, the right side {right}, the error bound of the \
                 difference {bound}",
                of.before, of.formula, of.after
            ))
        }
        (None, reason) => reason.as_ref().map(ToString::to_string),
    }
}

/// The verdict, before the id of the family.
pub(super) fn heading(family: &FamilyAccount) -> &'static str {
    match family.verdict.outcome().word() {
        "holds" if family.counts.not_applicable > 0 => "Holds, where it applies, on the members tried of",
        "holds" => "Holds on the members tried of",
        "fails" => "Fails on members of",
        "undecided" => "Undecided on",
        _ => "Applies to no member tried of",
    }
}

/// `, expected: …`, where the verdict is not as expected.
pub(super) fn expected(family: &FamilyAccount) -> String {
    match (family.is_unexpected(), family.expected) {
        (true, Some(word)) => format!(", expected: {word}"),
        (true, None) => ", not expected".to_owned(),
        (false, _) => String::new(),
    }
}

/// The names of a box for a verdict, in the style of the page.
pub(super) fn class(verdict: &str) -> &'static str {
    match verdict {
        "holds" => "region holds",
        "fails" => "region fails",
        _ => "region",
    }
}

/// What was found on a family: counts, and what is said beside them.
pub(super) fn told<'a>(of: &'a FamilyAccount, scope: &'a Scope) -> StoryBlock<'a> {
    let all = std::iter::once(counts(of)).chain(remarks(of));
    let all: Vec<String> = all.map(|text| sentence(&text)).collect();
    StoryBlock::Paragraph(vec![prose(all.join(" "), scope)])
}

/// The blocks of a claim, one for each family, with its figures. Of the members one is told everywhere; the others, and their lines for a
/// file, are on the page.
pub(super) fn blocks<'a>(
    claim: &'a ClaimAccount,
    scope: &'a Scope,
    figures: &dyn Fn(&'a FamilyAccount) -> Vec<StoryBlock<'a>>,
) -> Vec<StoryBlock<'a>> {
    let one = |of: &'a FamilyAccount| {
        let mut head = vec![strong(format!("{} {}", heading(of), of.family))];
        head.extend((of.title != of.family).then(|| prose(format!(" ({})", of.title), scope)));
        if let Some(text) = expected(of).strip_prefix(", ") {
            head.extend([words(", "), StorySpan::Words(text.to_owned(), Tone::Alarm)]);
        }
        head.push(words("."));
        let mut blocks = vec![StoryBlock::Paragraph(head), told(of, scope)];
        blocks.extend(figures(of));
        for (at, shown) in shown(of).into_iter().enumerate() {
            let named = format!("{}.", shown.named());
            let seen = shown.seen.map(|text| sentence(&text));
            let line = format!("{named} {}", seen.clone().unwrap_or_default());
            let line = if at == 0 { vec![prose(line.trim(), scope)] } else { Vec::new() };
            let mut inside: Vec<StoryBlock<'a>> =
                seen.map(|text| StoryBlock::Paragraph(vec![prose(text, scope)])).into_iter().collect();
            inside.push(StoryBlock::Paragraph(vec![quiet("The same motion for the derivation file:")]));
            inside.push(StoryBlock::Lines(shown.member.toml.clone(), "toml"));
            blocks.push(folded(vec![prose(named, scope)], Elsewhere::Line(line), inside));
        }
        StoryBlock::Group(class(of.verdict.outcome().word()), blocks)
    };
    claim.families.iter().map(one).collect()
}

/// A sentence from a part of one.
pub(super) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str().trim_end_matches('.'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_is_rounded_up() {
        assert_eq!(percent(0.014_867_1), "1.5");
        assert_eq!(percent(0.95), "95");
        assert_eq!(percent(0.394_2), "40");
        assert_eq!(percent(2.995_73e-6), "0.00030");
        assert_eq!(percent(1.0), "100");
        assert_eq!(percent(0.0), "0.000000000000");
    }
}
