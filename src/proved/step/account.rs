//! The account of an answer: what was found about a step, with formulas as they are shown.
//!
//! **In:** the answer of a proof. **Out:** an [`IdentityAccount`]: what refutes it and why it is open as data, conditions and
//! exceptions as relations.

use super::definitions::Definitions;
use super::gather::Gathered;
use super::{Pairs, Step};
use crate::derivation::Form;
use crate::expr::domain::Sign;
use crate::expr::{Expr, Leaf, Node, Op};
use crate::findings::standing::{Exception, Finding, Void};
use crate::findings::{IdentityAccount, IdentityEvidence};
use crate::verdict::Witness;
use proof::{Condition, Identity, PointValue, Reason, Refutation, Side, follows};
use reason::{Bounded, Coordinate, Plain, Point, Proving, Proviso, Refuting};

/// Most characters of a formula that is shown whole.
const LONGEST: usize = 160;
/// Most names that are listed for one that is not.
const MOST_NAMES: usize = 6;

/// What has a sign nowhere.
fn opposite(sign: Sign) -> Bounded {
    match sign {
        Sign::Positive => Bounded::NotPositive,
        Sign::NotNegative => Bounded::Negative,
        Sign::NotZero => Bounded::Zero,
    }
}

impl Step<'_> {
    /// The answer where a motion gives it: one on which everything given holds, and the claim does not.
    pub fn refuted_by(&self, trajectory: &str, witness: &Witness) -> IdentityAccount {
        let conditions = match self.is_about_parameters() {
            true => Step::of(self.derivation, self.claim).map(|step| step.where_real()).unwrap_or_default(),
            false => Vec::new(),
        };
        IdentityAccount {
            finding: Finding::of_motion(witness),
            from: Step::given(self.derivation, self.claim),
            conditions,
            witness: Some(Refuting::OnMotion {
                left: witness.left,
                right: witness.right,
                trajectory: trajectory.into(),
                t: witness.t,
            }),
            ..IdentityAccount::default()
        }
    }

    /// What lies beyond something.
    fn unreached(&self, exceptions: &[Exception]) -> Vec<Proviso> {
        let mut out: Vec<Proviso> = Vec::new();
        for exception in exceptions {
            let one = match *exception {
                Exception::Leaps(e) => Proviso::Leap(self.shown(e).into()),
                Exception::Passes(e) if !self.graph.clone().needs_below([e]).is_empty() => {
                    Proviso::Hole(self.shown(e).into())
                }
                Exception::Divides(e) | Exception::Passes(e) => Proviso::Pole(self.shown(e).into()),
                Exception::HasNoValue(e, sign) => Proviso::Where { formula: self.shown(e).into(), is: opposite(sign) },
                Exception::OneSign => Proviso::OtherSign,
                Exception::Vanishes(_) => continue,
            };
            if !out.contains(&one) {
                out.push(one);
            }
        }
        out
    }

    pub(super) fn shown(&self, e: Expr) -> String {
        let text = self.graph.to_latex(e);
        // Names of auxiliary numbers begin with an invisible character.
        let auxiliary = text.contains('\u{2063}');
        if text.len() <= LONGEST && !auxiliary {
            text
        } else {
            let mut names: Vec<String> =
                self.graph.leaves_within([e]).iter().map(|&l| self.graph.leaf_latex(l)).collect();
            names.retain(|n| !n.contains('\u{2063}'));
            names.dedup();
            if names.is_empty() {
                names.push("auxiliary numbers".to_owned());
            }
            let more = names.len().saturating_sub(MOST_NAMES);
            names.truncate(MOST_NAMES);
            let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
            format!("(an expression in {}{rest}, too long to print)", names.join(", "))
        }
    }

    /// Both sides at a point.
    fn point(&self, refutation: &Refutation, (point, left, right): (&proof::Point, &Side, &Side)) -> Point {
        let value = |(leaf, value): &(Leaf, PointValue)| {
            let name = self.graph.leaf_latex(*leaf);
            match (&value.exact, &value.circle) {
                (Some(r), _) => Coordinate::Value(name, r.to_string()),
                (None, Some((c, s))) => Coordinate::Circle(name, c.to_string(), s.to_string()),
                (None, None) => Coordinate::Value(name, value.decimal.to_string()),
            }
        };
        let side = |s: &Side| s.exact.as_ref().map_or_else(|| s.decimal.to_string(), ToString::to_string);
        let [named, beyond] = refutation.parted(point);
        let more = (!beyond.is_empty()).then_some(Coordinate::Beyond(beyond.len()));
        Point { left: side(left), right: side(right), at: named.into_iter().map(value).chain(more).collect() }
    }

    /// What an answer says of the claim, nothing being given.
    pub fn of_identity(&mut self, identity: Identity, evidence: IdentityEvidence) -> IdentityAccount {
        IdentityAccount { evidence, ..self.account(identity, Vec::new(), true) }
    }

    /// The account of an answer, in the words of the finding.
    pub(super) fn account(&mut self, identity: Identity, from: Vec<String>, complete: bool) -> IdentityAccount {
        self.account_along(identity, (from, complete), Vec::new(), &[])
    }

    /// Of the conditions of a proof those that follow from what is given: they need not be told. What is asked of a sign that is chosen, and
    /// along a motion of what moves, is asked beyond the times that the claim chooses.
    pub(super) fn following(
        &mut self,
        identity: &Identity,
        gathered: &Gathered,
        of: &Pairs,
        moved: bool,
    ) -> Vec<Condition> {
        let Identity::Proved(proof) = identity else { return Vec::new() };
        if proof.conditions.is_empty() || self.claim.forms.iter().any(Form::has_branches) {
            return Vec::new();
        }
        let used = self.in_part.len();
        let premises = self.premises(gathered, of, Definitions::All);
        self.in_part.truncate(used);
        let mut out = proof.conditions.clone();
        out.retain(|condition| {
            let follows = |this: &mut Self, e: Expr, sign: Sign| follows(&mut this.graph, &premises, e, sign);
            match *condition {
                Condition::Pivot(_) | Condition::Rate(_) => false,
                Condition::Denominator(e)
                | Condition::Radicand(e)
                | Condition::Discriminant(e)
                | Condition::Unit(e)
                | Condition::Positive(e)
                    if moved && self.depends(e) =>
                {
                    false
                }
                Condition::Denominator(e) => follows(self, e, Sign::NotZero),
                Condition::Radicand(e) | Condition::Discriminant(e) => follows(self, e, Sign::NotNegative),
                Condition::Positive(e) => follows(self, e, Sign::Positive),
                Condition::Unit(e) => {
                    let one = self.graph.integer(1);
                    let [below, above] = [self.graph.sub(one, e), self.graph.add(one, e)];
                    follows(self, below, Sign::NotNegative) && follows(self, above, Sign::NotNegative)
                }
            }
        });
        out
    }

    /// The same; `along` is what a proof along motions does not reach, `following` are the conditions that need not be told.
    pub(super) fn account_along(
        &mut self,
        identity: Identity,
        (from, complete): (Vec<String>, bool),
        along: Vec<Exception>,
        following: &[Condition],
    ) -> IdentityAccount {
        let finding = Finding::weigh(&self.graph, &identity, complete, along);
        let mut out = IdentityAccount { finding, from, ..IdentityAccount::default() };
        match identity {
            Identity::Proved(mut proof) => {
                proof.conditions.retain(|condition| !following.contains(condition));
                for condition in &proof.conditions {
                    let (list, e, is) = match *condition {
                        Condition::Denominator(e) => (&mut out.conditions, e, Bounded::NotZero),
                        Condition::Pivot(e) | Condition::Rate(e) => (&mut out.exceptions, e, Bounded::Zero),
                        Condition::Radicand(e) => (&mut out.conditions, e, Bounded::NotNegative),
                        Condition::Discriminant(e) => (&mut out.given_only_where, e, Bounded::NotNegative),
                        Condition::Unit(e) => (&mut out.conditions, e, Bounded::ByOne),
                        Condition::Positive(e) => (&mut out.conditions, e, Bounded::Positive),
                    };
                    // Of what is bounded whatever its sign the sign is not told.
                    let has_no_sign = matches!(is, Bounded::NotZero | Bounded::Zero | Bounded::ByOne);
                    let e =
                        if let (true, Node::Unary(Op::Neg, of)) = (has_no_sign, self.graph.node(e)) { *of } else { e };
                    let one = Proviso::Where { formula: self.shown(e).into(), is };
                    if !list.contains(&one) {
                        list.push(one);
                    }
                }
                // The short ones first; not in the order of the graph, which depends on what was written before.
                for list in [&mut out.conditions, &mut out.exceptions, &mut out.given_only_where] {
                    list.sort_by_cached_key(|one| (one.to_string().chars().count(), one.to_string()));
                }
                let discriminant = |c: &Condition| matches!(c, Condition::Discriminant(_));
                if let Some(orders) = self.orders_of(&proof.conditions) {
                    // What only the premises ask for does not restrict the claim.
                    let list = match proof.conditions.iter().any(discriminant) {
                        true => &mut out.given_only_where,
                        false => &mut out.conditions,
                    };
                    list.push(orders);
                }
                let lines = self.unreached(out.finding.exceptions());
                out.exceptions.extend(lines);
                out.generic = !out.finding.exceptions().is_empty();
                out.log2_error = out.finding.is_proved_in_part().then_some(proof.log2_error);
                out.reason = match out.finding.void() {
                    Some(Void::NoValue) => Some(Plain::GivenHasNoValue.into()),
                    Some(Void::OnlySpecial) => Some(Plain::OnlySpecialCases.into()),
                    Some(Void::Unseen) => Some(Plain::EqualNowhere.into()),
                    Some(Void::Incomplete) | None => out.reason,
                };
            }
            Identity::Refuted(refutation) if complete => {
                let at =
                    |point: &proof::Point, left: &Side, right: &Side| self.point(&refutation, (point, left, right));
                let first = at(&refutation.point, &refutation.left, &refutation.right);
                let second = refutation.second.as_ref().map(|(point, left, right)| at(point, left, right));
                out.witness = Some(Refuting::Point { first, second });
            }
            Identity::Refuted(_) => {
                out.reason = Some(self.not_given());
            }
            Identity::Undecided(open) => {
                out.reason = Some(match open {
                    Reason::OnlyWhere(e) => Proving::OnlyWhere { formula: self.shown(e).into(), base: false }.into(),
                    Reason::Boundary(e) => Proving::OnlyWhere { formula: self.shown(e).into(), base: true }.into(),
                    Reason::Unsolved(e) => Proving::Unsolved(self.shown(e).into()).into(),
                    other => reason::Reason::quoted(other),
                });
            }
        }
        out
    }
}
