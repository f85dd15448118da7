//! Between the samples: the times at which an inequality, or what must differ, may change.
//!
//! **In:** a part of a claim, and what the search for zeros found for left − right. **Out:** what is known of the part at the
//! zeros and at the peaks of what lies between two of them; and what the search left open.
//!
//! An inequality keeps its truth as long as left − right keeps its sign. So it is enough to look where the sign changes, and
//! once between two changes: of this comparison, of another one beside it, of what is assumed, or of where there are values.
//! Where the sides only touch, or where the search is incomplete, the comparison may be anything: if the part may be false
//! then, it is not known to be true.

use std::cell::LazyCell;
use std::sync::Arc;

use crate::describe::{Describer, Left, incomplete};
use crate::expr::Expr;
use crate::flow::{Incomplete, Points};
use crate::latex::RelationKind;
use crate::number::NoValue;
use crate::pointwise::{Pointwise, Tried, selected};
use crate::trace::Trial;
use crate::verdict::{Evidence, Finding, Possible, Strength, Truth};
use crate::weigh::weigh;
use claim::program::What;
use claim::sides::{Measurements, measure_part};
use reason::{Plain, Reason, Sampling, Search};

/// Up to this share of the span a gap in the search is one point for relations that admit equality: what is true on both
/// sides of a point, and continuous, is true at it.
const POINT: f64 = 1e-9;

/// What a time is looked at for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    /// left − right of a comparison changes its sign there; how well the time is known.
    Crossing { comparison: usize, slack: f64 },
    /// Nothing that the part depends on changes there: one of the comparisons is farthest from 0 between two changes of its sign,
    /// or the time lies between two changes.
    Inside,
    /// Whether the part may be false there, whatever the comparison is, decides whether a reason stays open; where the sides are
    /// `equal`, as far as their error bounds tell, only if these are too large to take them for equal.
    Probe { reason: usize, comparison: usize, equal: bool },
}

/// One part of a claim, between the samples.
struct Between<'a> {
    /// The times, increasing.
    times: Vec<f64>,
    /// The values at these times.
    points: Arc<Points>,
    roles: Vec<Role>,
    /// What the search leaves open.
    open: Vec<Reason>,
    /// The selectors, and the part alone.
    measured: Measurements<'a>,
    position: usize,
}

/// A time inside each stretch between two changes of what a part depends on, where it was not `seen` what is there.
///
/// A comparison by itself is looked at between two changes of its own sign, where it is farthest from 0: there it may not count,
/// or another comparison decide. Changes that are closer to one another than their times are known are one.
fn unseen(trial: &Trial, position: usize, void: bool, seen: impl Fn(f64, f64) -> bool) -> Vec<f64> {
    let Trial { program, trace, .. } = *trial;
    let compared = program.parts[position].boundaries(void).map(|(_, _, e)| e);
    let assumed = program.met().map(|(_, _, e)| e);
    let mut each: Vec<Expr> = compared.chain(assumed).chain(program.edges()).collect();
    each.sort_unstable();
    each.dedup();
    if each.len() < 2 {
        return Vec::new();
    }
    let (from, to) = trace.stage.span(trace.trajectory);
    let mut changes = vec![(from, 0.0), (to, 0.0)];
    for zeros in each.into_iter().filter_map(|e| trace.zeros(e)) {
        changes.extend(zeros.times.iter().copied().zip(zeros.slack.iter().copied()));
        let ends = zeros.incomplete.iter().map(Incomplete::stretch).flat_map(|(start, end)| [start, end]);
        changes.extend(zeros.touching.iter().copied().chain(ends).map(|t| (t, 0.0)));
    }
    changes.retain(|(t, _)| (from..=to).contains(t));
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let apart = |pair: &[(f64, f64)]| {
        let ((a, before), (b, after)) = (pair[0], pair[1]);
        let middle = a + 0.5 * (b - a);
        (b - a > before + after && a < middle && middle < b && !seen(a, b)).then_some(middle)
    };
    changes.windows(2).filter_map(apart).collect()
}

/// Whether a zero lies beyond an end of the span, up to the error of its time.
pub(super) fn may_lie_beyond((from, to): (f64, f64), t: f64, slack: f64) -> bool {
    let exact = slack <= 4.5 * f64::EPSILON * t.abs().max(f64::MIN_POSITIVE);
    !exact && (t - slack < from || t + slack > to)
}

/// Whether a relation admits equality, for which touching sides make no difference.
pub(super) fn is_weak(kind: RelationKind) -> bool {
    matches!(kind, RelationKind::LessEqual | RelationKind::GreaterEqual)
}

impl<'a> Between<'a> {
    /// Looks for the changes of a part of the program, which was measured `along` the times that were `tried`; `None` where there is no time
    /// to look at.
    fn look(
        trial: &Trial<'a>,
        (along, tried): (&Measurements, &Tried),
        position: usize,
        void: bool,
    ) -> Option<Between<'a>> {
        let Trial { program, trace, .. } = *trial;
        let (from, to) = trace.stage.span(trace.trajectory);
        let mut found: Vec<(f64, Role)> = Vec::new();
        let mut open: Vec<Reason> = Vec::new();
        for (comparison, kind, e) in program.parts[position].boundaries(void) {
            let Some(zeros) = trace.zeros(e) else {
                open.push(Plain::NotSearched.into());
                let role = Role::Probe { reason: open.len() - 1, comparison, equal: false };
                found.extend([from, to].map(|t| (t, role)));
                continue;
            };
            for (&t, &slack) in zeros.times.iter().zip(&zeros.slack) {
                let role = match may_lie_beyond((from, to), t, slack) {
                    false => Role::Crossing { comparison, slack },
                    true => {
                        open.push(Sampling::MeetInSpan(t).into());
                        Role::Probe { reason: open.len() - 1, comparison, equal: false }
                    }
                };
                found.push((t, role));
            }
            found.extend(zeros.peaks.iter().map(|&t| (t, Role::Inside)));
            // Sides that are equal at a point make no difference to what admits equality, unless one side alone is seen.
            for &t in &zeros.touching {
                open.push(Sampling::Touches(t).into());
                let equal = is_weak(kind) && !zeros.cut_off.contains(&t);
                found.push((t, Role::Probe { reason: open.len() - 1, comparison, equal }));
            }
            for gap in &zeros.incomplete {
                let (start, end) = gap.stretch();
                let equal = match gap {
                    // Such times are left out, as among the samples.
                    Incomplete::NoValue { reason: NoValue::OutOfDomain, .. } => continue,
                    Incomplete::Vanishing { .. } => is_weak(kind),
                    _ => is_weak(kind) && end - start <= POINT * (to - from),
                };
                open.push(Sampling::Incomplete { search: Search::Between, gap: incomplete(gap) }.into());
                let role = Role::Probe { reason: open.len() - 1, comparison, equal };
                let probes = [start.max(from), start + 0.5 * (end - start), end.min(to)];
                found.extend(probes.into_iter().filter(|t| (from..=to).contains(t)).map(|t| (t, role)));
            }
        }
        let judged = LazyCell::new(|| Pointwise::new(&along.parts[position], trial.claim.precision));
        let clear = |i: usize| matches!(tried.left[i], Left::Out(_)) || judged.at(i).decided().is_some();
        let unseen = unseen(trial, position, void, |from, to| {
            let inside = tried.times.partition_point(|&t| t <= from)..tried.times.partition_point(|&t| t < to);
            inside.into_iter().any(clear)
        });
        found.extend(unseen.into_iter().map(|t| (t, Role::Inside)));
        if found.is_empty() {
            return None;
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let event = |&(t, role): &(f64, Role)| match role {
            Role::Crossing { slack, .. } => (t, Some(slack)),
            Role::Inside | Role::Probe { .. } => (t, None),
        };
        let points = trace.points_at_events(program, &found.iter().map(event).collect::<Vec<_>>());
        let mut measured = measure_part(program, &points, along, position);
        for group in &mut measured.selectors {
            group.equal.iter_mut().flatten().for_each(|equal| *equal = true);
        }
        let (times, roles): (Vec<f64>, Vec<Role>) = found.into_iter().unzip();
        // Where its sign changes, the sides of a comparison are equal; what else is 0 within its error there may not be.
        let crosses = |role: &Role| match role {
            Role::Crossing { comparison, .. } => Some(*comparison),
            Role::Inside | Role::Probe { .. } => None,
        };
        measured.parts[0].crossing = roles.iter().map(crosses).collect();
        Some(Between { times, points, roles, open, measured, position })
    }

    /// What the search leaves open at times that may count.
    fn still_open(&self, left: &[Left], judged: &Pointwise, precision: f64) -> Option<&Reason> {
        let group = &self.measured.parts[0];
        let reason = |(i, role): (usize, &Role)| {
            let Role::Probe { reason, comparison, equal } = *role else { return None };
            if matches!(left[i], Left::Out(_)) || judged.at(i) == Possible::VOID {
                return None;
            }
            if equal && !(0..group.signs.len()).any(|s| group.is_unequal(s, comparison, i, precision)) {
                return None;
            }
            let at = |s: usize| {
                let known = |c: usize| group.standing(s, c, i, precision);
                group.group.value(|c| if c == comparison { Possible::OPEN } else { known(c) })
            };
            let whole = group.group.over_signs((0..group.signs.len()).map(at));
            whole.may_be(Truth::False).then(|| self.open.get(reason))?
        };
        self.roles.iter().enumerate().find_map(reason)
    }

    /// Why a part that has no value at any sample may have one at a time between them.
    fn valued(&self, trial: &Trial) -> Option<Reason> {
        let describer = Describer::new(trial, &self.times, &self.points);
        let left = selected(trial, &self.measured, &describer);
        let judged = Pointwise::new(&self.measured.parts[0], trial.claim.precision);
        let valued = |i: &usize| !matches!(left[*i], Left::Out(_)) && judged.at(*i) != Possible::VOID;
        let i = (0..self.times.len()).find(valued)?;
        Some(Sampling::ValueBetween(self.times[i]).into())
    }

    /// What is known of a part that is true at all samples; `None` where there is nothing to add.
    /// `within` is what [`Evidence::within`] becomes.
    fn held(&self, trial: &Trial, within: &mut f64) -> Option<Finding> {
        let group = &self.measured.parts[0];
        let describer = Describer::new(trial, &self.times, &self.points);
        let left = selected(trial, &self.measured, &describer);
        let precision = trial.claim.precision;
        let judged = Pointwise::new(group, precision);
        // Whether a time at which the sides touch refutes cannot be told: such times are not weighed.
        let weighed = |(left, role): (&Left, &Role)| match role {
            Role::Probe { .. } => Left::Out(Arc::new(Plain::NotLookedAt.into())),
            Role::Crossing { .. } | Role::Inside => left.clone(),
        };
        let counting: Vec<Left> = left.iter().zip(&self.roles).map(weighed).collect();
        let undecided = |reason: Reason, samples: usize| {
            Some(Finding::sampled(Possible::OPEN, Evidence { samples, ..Evidence::because(reason) }))
        };
        let counted = counting.iter().filter(|l| **l == Left::In).count();
        if counted > 0 {
            let mut setting = describer.setting(counting.clone());
            setting.first = matches!(trial.program.parts[self.position].what, What::Denied);
            let finding = weigh(setting, group);
            *within = within.max(finding.evidence().within);
            if finding.known(Strength::Sampled) == Some(Possible::FALSE) {
                return Some(finding);
            }
        }
        let unclear = |i: &usize| match counting[*i] {
            Left::In => judged.at(*i).decided().is_none(),
            Left::Open(_) => judged.at(*i).may_be(Truth::False),
            Left::Out(_) => false,
        };
        if let Some(i) = (0..self.times.len()).find(unclear) {
            return undecided(Sampling::TooLargeBetween(self.times[i]).into(), counted);
        }
        self.still_open(&left, &judged, precision).and_then(|reason| undecided(reason.clone(), counted))
    }
}

/// What is known of a part that is true, or has no value, at all samples, with what lies between them.
pub(super) fn between_samples(
    trial: &Trial,
    along: (&Measurements, &Tried),
    position: usize,
    finding: Finding,
) -> Finding {
    let known = finding.known(Strength::Sampled);
    let void = known == Some(Possible::VOID);
    if trial.program.parts[position].boundaries(void).next().is_none() {
        return finding;
    }
    if void {
        return match Between::look(trial, along, position, void).and_then(|between| between.valued(trial)) {
            Some(reason) => {
                Finding::sampled(Possible::ANY, Evidence { reason: Some(reason), ..finding.evidence().clone() })
            }
            None => finding,
        };
    }
    // What needs a value and comes close to having none at a sample may have none at a change of sign beside it.
    let asserted = trial.program.parts[position].group.asserted && known == Some(Possible::OPEN);
    if known != Some(Possible::TRUE) && !asserted {
        return finding;
    }
    let mut within = finding.evidence().within;
    let between = Between::look(trial, along, position, void);
    let found = match between.and_then(|between| between.held(trial, &mut within)) {
        Some(found) if !asserted || found.known(Strength::Sampled) == Some(Possible::FALSE) => found,
        _ if asserted => return finding,
        Some(_) | None => return Finding::sampled(Possible::TRUE, Evidence { within, ..finding.evidence().clone() }),
    };
    let samples = finding.evidence().samples + found.evidence().samples;
    let excluded = finding.evidence().excluded.clone();
    let series = found.evidence().series.clone().or(finding.evidence().series.clone());
    let known = found.known(Strength::Sampled).unwrap_or(Possible::ANY);
    Finding::sampled(known, Evidence { samples, excluded, series, ..found.evidence().clone() })
}
