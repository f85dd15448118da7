//! Negations: what is shown of equations is shown of the parts of a claim that deny them.
//!
//! **In:** a claim with `never`, `eventually` or `\ne`. **Out:** its account, made of those of the equations that it denies.
//!
//! | of the equations R | `never` R, `\ne` | `eventually` R |
//! |---|---|---|
//! | proved: always so, wherever they have values, and there are motions | refuted | proved |
//! | excluded: they contradict what is given, of which there are motions | proved | refuted |
//! | else, also where a point refutes them | undecided | undecided |
//!
//! So of `always` R: excluded equations are so at no time, however close their sides are, and a point of them alone refutes it as a step.
//!
//! What refutes a negation must count, as what is proved must: it is replayed by the checker, or is about no times; and there must be
//! a motion on which what is given holds, which is shown as everywhere, by a point that refutes 0 = 1.
//!
//! A point at which R is false says nothing of other times, so it decides no negation. What is shown of each part is told beside the
//! decision: a motion on which what is given holds has it, see [`PartShown`]. This is the one rule for all of them.

use super::{Decided, Pairs, Step, sides};
use crate::agreement::answer;
use crate::derivation::{Claim, Form, Written};
use crate::expr::domain::Sign;
use crate::expr::{Expr, Leaf, Rational};
use crate::findings::IdentityAccount;
use crate::findings::standing::{Decision, Finding};
use crate::latex::{RelationKind, Statement};
use claim::denial::{Denial, without_denials};
use claim::denote::denote;
use proof::{Identity, Options, Reason, Wanted, When};
use reason::Plain;
use verdict::PartShown;

use super::definitions::Definitions;

/// Of claims that state more equations it is not asked which of them are never so.
const MOST_STATED: usize = 24;

/// Parts of a claim by their positions, with what is shown of each.
type ShownParts = Vec<(usize, PartShown)>;

impl Step<'_> {
    /// The same question of another claim of the file, or beside it.
    fn asked_of<'c>(&'c self, claim: &'c Claim) -> Option<Step<'c>> {
        let step = Step::of(self.derivation, claim)?.with(self.plain);
        let (sign, inequalities, has_few_points) = (self.sign, self.inequalities, self.has_few_points);
        Some(Step { sign, inequalities, has_few_points, ..step })
    }

    /// Decides a claim that denies equations.
    pub(super) fn decide_denials(mut self) -> Option<Decided> {
        if self.is_of_each_sign() {
            let found = self.for_each_sign(Step::decide_denials)?;
            // What is shown of a part under one sign is not shown of it.
            return Some(found.map(|account| IdentityAccount { parts: Vec::new(), ..account }));
        }
        if self.sign.is_none() && self.assumes_sign() {
            return Some(Ok(IdentityAccount {
                reason: Some(Plain::DeniedIsOpen.into()),
                ..IdentityAccount::default()
            }));
        }
        let denoted = denote(&mut self.graph, self.derivation.into(), self.claim, &Rational::ZERO);
        let mut all: Vec<IdentityAccount> = Vec::new();
        let mut parts: Vec<(usize, PartShown)> = Vec::new();
        let mut parts_from: Vec<String> = Vec::new();
        for denial in &denoted.denials {
            let one = match self.of_denial(denial)? {
                Ok(one) => one,
                defect => return Some(defect),
            };
            parts.extend(one.parts.iter().copied());
            parts_from
                .extend(one.parts_from.iter().filter(|name| !parts_from.contains(name)).cloned().collect::<Vec<_>>());
            all.push(one);
        }
        if denoted.denials.is_empty() {
            return None;
        }
        if let Some(rest) = without_denials(self.claim) {
            match self.asked_of(&rest).and_then(Step::decide) {
                Some(Ok(one)) => all.push(one),
                Some(defect) => return Some(defect),
                None => all.push(IdentityAccount::default()),
            }
        }
        // Texts of which nothing was asked: limits, signs, inequalities.
        if denoted.denials.len() < self.denying_texts() {
            all.push(IdentityAccount::default());
        }
        let finding = all.iter().map(|one| one.finding.clone()).reduce(Finding::and)?;
        let telling = all.iter().position(|one| one.finding.decision() == finding.decision())?;
        let told = all.swap_remove(telling);
        let reason = match finding.decision() {
            Decision::Undecided => told.reason.or(Some(Plain::DeniedIsOpen.into())),
            Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed | Decision::Refuted => told.reason,
        };
        Some(Ok(IdentityAccount { finding, parts, parts_from, reason, ..told }))
    }

    fn denying_texts(&self) -> usize {
        let differing = |r: &&crate::latex::Relation| r.kind == RelationKind::NotEqual && r.limit.is_none();
        let texts = self.claim.forms.iter().map(|form| match form {
            Form::Never(_) | Form::Eventually(_) => 1,
            Form::Always(w) => w.value.relations.iter().filter(differing).count(),
            Form::FirstIntegral(_) | Form::Defined(_) | Form::Solves { .. } | Form::SameMotion { .. } => 0,
            Form::Independent { .. } | Form::Exists { .. } | Form::Across(_) | Form::Unread { .. } => 0,
        });
        texts.sum()
    }

    /// What follows for one part.
    fn of_denial(&self, denial: &Denial) -> Option<Decided> {
        let positive = denial.positive(self.claim);
        let decided = match self.asked_of(&positive)?.decide() {
            Some(decided) => decided,
            None => {
                let equations: Pairs = denial.equal.value.relations.iter().flat_map(super::pairs).collect();
                self.asked_of(&positive)?.of_one_expression(&equations)
            }
        };
        let (is_so, of) = match decided {
            Ok(account) if account.finding.is_proved_in_part() => (true, account),
            Ok(open) => match self.asked_of(&positive)?.excluded() {
                Some(Ok(account)) if account.finding.is_whole() => (false, account),
                Some(Err(defect)) => return Some(Err(defect)),
                Some(Ok(_)) | None => {
                    let IdentityAccount { from, .. } = open;
                    let reason = Some(Plain::DeniedIsOpen.into());
                    let (parts, parts_from) = self.on_motions(denial, &positive)?;
                    return Some(Ok(IdentityAccount { from, parts, parts_from, reason, ..IdentityAccount::default() }));
                }
            },
            defect => return Some(defect),
        };
        let shown = if is_so { PartShown::IsNotSo } else { PartShown::IsSo };
        let parts = if of.holds_on_motions() { vec![(denial.part, shown)] } else { Vec::new() };
        let parts_from = self.rests_on(&positive, &of);
        let finding = match (is_so, denial.happens) {
            (true, true) | (false, false) => of.finding.clone(),
            (true, false) | (false, true) => {
                let never = || Claim { forms: vec![Form::Never(denial.equal.clone())], ..self.claim.clone() };
                let said = if is_so { positive.clone() } else { never() };
                let typed = self.inequalities == When::Always;
                let counts = crate::replay::is_replayed(self.derivation, &said, of.clone(), typed)
                    && self.asked_of(&positive)?.has_motion(&[], &[])?;
                if counts { of.finding.of_negation() } else { Finding::default() }
            }
        };
        let reason = match (finding.decision(), is_so) {
            (Decision::Refuted, true) => Some(Plain::DeniedIsProved.into()),
            (Decision::Refuted, false) => Some(Plain::DeniedIsExcluded.into()),
            (Decision::Undecided, _) => Some(Plain::DeniedIsOpen.into()),
            (Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed, false) if finding.is_whole() => {
                Some(Plain::DeniedIsExcluded.into())
            }
            (Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed, _) => of.reason.clone(),
        };
        Some(Ok(IdentityAccount { finding, parts, parts_from, reason, ..of }))
    }

    /// Whether there is a motion on which all that is given holds, and some formulas have values: a point of one refutes 0 = 1. Angles that
    /// these formulas or those that are `given` name are on the branch of their formulas.
    pub(crate) fn has_motion(mut self, valued: &[Expr], given: &[Expr]) -> Option<bool> {
        let mut gathered = self.gather(None);
        if !gathered.complete {
            return Some(false);
        }
        let equations = self.equations(self.claim)?;
        // Also of systems whose rates are not asked for; and what is assumed at some times is to be so on an interval.
        gathered.premises.give(gathered.systems.iter().copied(), When::Always);
        gathered.premises.equations.iter_mut().for_each(|known| known.when = When::Always);
        let angles = self.angles(valued.iter().chain(given).copied().collect());
        gathered.premises.give(angles, When::Always);
        for need in self.graph.needs_below(valued.iter().copied()) {
            let signs = match need.sign {
                Sign::NotZero => &mut gathered.premises.nonzero,
                Sign::Positive => &mut gathered.premises.positive,
                Sign::NotNegative => &mut gathered.premises.not_negative,
            };
            signs.push(need.value);
        }
        let premises = self.premises(&gathered, &equations, Definitions::All);
        let nothing: Pairs = vec![(self.graph.integer(0), self.graph.integer(1))];
        Some(matches!(self.test_only(&premises, &nothing, &Options::default()), Identity::Refuted(_)))
    }

    /// The continued angles that formulas name, each beside its formula.
    fn angles(&mut self, mut open: Vec<Expr>) -> Pairs {
        let scope = &self.claim.scope;
        let mut out: Pairs = Vec::new();
        while let Some(formula) = open.pop() {
            let written = claim::comparison::traced_without_angles(&mut self.graph, scope, formula);
            for leaf in self.graph.leaves_within([written]) {
                let definition = scope.definition(leaf.symbol).filter(|_| scope.is_angle(leaf.symbol));
                let Some(&value) = definition.and_then(|d| d.components.get(usize::from(leaf.component))) else {
                    continue;
                };
                let angle = (self.graph.leaf(Leaf::now(leaf.symbol, leaf.component)), value);
                if !out.contains(&angle) {
                    out.push(angle);
                    open.push(value);
                }
            }
        }
        out
    }

    /// What follows of a part on the motions of the claim: they obey their system, whether the claim is said to follow from it or not.
    fn on_motions(&self, denial: &Denial, positive: &Claim) -> Option<(ShownParts, Vec<String>)> {
        let nothing = Some((Vec::new(), Vec::new()));
        let systems = self.derivation.systems_of_motions(self.claim);
        let [Some(only)] = systems.as_slice() else { return nothing };
        let system = &self.derivation.systems[*only].id;
        if positive.follows_from.is_empty() || positive.follows_from.contains(system) {
            return nothing;
        }
        let mut positive = positive.clone();
        positive.follows_from.push(system.clone());
        match self.asked_of(&positive).and_then(Step::decide) {
            Some(Ok(account)) if account.holds_on_motions() => {
                Some((vec![(denial.part, PartShown::IsNotSo)], account.from))
            }
            Some(_) | None => nothing,
        }
    }

    /// The account of a step that is not proved, with the equations of the claim, each by itself, that are so at no time that counts.
    ///
    /// # Errors
    /// A description of the contradiction, if the two routes disagree.
    pub fn excluding(&self, mut account: IdentityAccount) -> Result<IdentityAccount, String> {
        if !self.is_equations() || self.assumes_sign() {
            return Ok(account);
        }
        if self.claim.stated().count() > MOST_STATED {
            return Ok(account);
        }
        let mut graph = self.graph.clone();
        for (part, relation) in denote(&mut graph, self.derivation.into(), self.claim, &Rational::ZERO).stated {
            let span = relation.span.clone();
            let value = Statement { relations: vec![relation], span: span.clone() };
            let equal = Written { text: String::new(), span, value };
            let alone = Claim { forms: vec![Form::Always(equal)], ..self.claim.clone() };
            let excluded = self.asked_of(&alone).and_then(Step::excluded).transpose()?;
            if let Some(excluded) = excluded.filter(|e| e.finding.is_whole() && e.holds_on_motions()) {
                account.parts.push((part, PartShown::IsExcluded));
                account.parts_from = self.rests_on(&alone, &excluded);
            }
        }
        Ok(account)
    }

    /// What it rests on that equations are always so, or never: what they follow from; of numbers, nothing.
    fn rests_on(&self, equations: &Claim, account: &IdentityAccount) -> Vec<String> {
        let roots: Vec<_> = equations.stated().flat_map(super::pairs).flat_map(|(l, r)| [l, r]).collect();
        let names_nothing = self.graph.leaves_within(roots).is_empty();
        if names_nothing { Vec::new() } else { account.from.clone() }
    }

    /// Whether the equations of the claim contradict what is given at every time that counts, and something satisfies what is given.
    fn excluded(mut self) -> Option<Decided> {
        let mut gathered = self.gather(None);
        let equations = self.equations(self.claim)?;
        if self.is_too_large(&gathered, &equations) || !self.apart.is_empty() {
            return None;
        }
        let given = gathered.clone();
        // At one time: nothing is said of rates.
        gathered.premises.give(equations.iter().copied(), When::Chosen);
        let premises = self.premises(&gathered, &equations, Definitions::All);
        let nothing: Pairs = vec![(self.graph.integer(0), self.graph.integer(1))];
        let options = Options { attempts: 1, wanted: Wanted::Fault, ..Options::default() };
        let found = self.test_only(&premises, &nothing, &options);
        if !matches!(found, Identity::Undecided(Reason::Contradiction)) || self.is_without_motion(&given, &equations) {
            return None;
        }
        // Something satisfies what is given, and both sides have values there.
        let premises = self.premises(&given, &equations, Definitions::All);
        let valued: Pairs = sides(&equations).map(|e| (e, e)).collect();
        let (identity, evidence) = match answer(&mut self.graph, &valued, &premises, None) {
            Ok(found) => found,
            Err(defect) => return Some(Err(defect)),
        };
        let (left_out, beyond) = self.beyond_what_is_named(&equations);
        if !beyond.is_empty()
            && let Some(account) = self.proved_without(left_out, Step::excluded)
        {
            return Some(Ok(account));
        }
        let account = self.account_along(identity, (given.from.clone(), given.complete), beyond, &[]);
        let (presupposed, assumed_at_times) = (given.inherited, given.assumed_at_times);
        Some(Ok(IdentityAccount { evidence, presupposed, assumed_at_times, ..account }))
    }
}
