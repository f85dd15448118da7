//! Where the claims that a step names have no value: they say nothing there, and what follows from them is open.
//!
//! **In:** a step that is proved. **Out:** the exceptions of its proof, with the claims of which they come; the proof without these claims, if
//! there is one. **Guaranteed:** where no exception is told, every claim that is named has a value wherever the step's own claim is said.
//!
//! What is needed is read in the table of domains. It is met where the claim itself needs the same, by the motions of systems that need it
//! or divide by it, by what is assumed, and by what is said of all times.

use super::gather::{Gathered, sides};
use super::{Decided, Pairs, Step, pairs};
use crate::derivation::{Claim, Form};
use crate::expr::domain::Sign;
use crate::expr::{Expr, FastMap, FastSet, Symbol};
use crate::findings::IdentityAccount;
use crate::findings::standing::Exception;
use proof::{When, is_never_negative};

impl<'a> Step<'a> {
    /// The claims that are named, but those that are left out.
    pub(super) fn claims_named(&self) -> Vec<&'a Claim> {
        let derivation = self.derivation;
        let named = Step::given(derivation, self.claim);
        let used = derivation.claims_among(&named).filter(|at| !self.left_out.contains(at));
        used.map(|at| &derivation.claims[at]).collect()
    }

    /// Where claims that are named have no value, and this one may: they say nothing there, and what follows from them is open. With the
    /// claims of which it is so.
    ///
    /// What they need is met where the claim itself has a value, on the motions of the systems that are given, by what is assumed, and by
    /// what is said of all times. What is typed is said of all values.
    pub(super) fn beyond_what_is_named(&mut self, equations: &Pairs) -> (Vec<usize>, Vec<Exception>) {
        let (mut of, mut out) = (Vec::new(), Vec::new());
        let named = self.claims_named();
        if self.inequalities == When::Always || named.is_empty() {
            return (of, out);
        }
        let mut known: Option<(FastSet<(Expr, Sign)>, Gathered)> = None;
        for premise in named {
            let needs = self.needs_of(premise);
            if needs.is_empty() {
                continue;
            }
            let (met, gathered) = known.get_or_insert_with(|| {
                let met = self.needs_met(equations);
                let gathered = self.signs_of(&met);
                (met, gathered)
            });
            let mut assumed = gathered.clone();
            self.assume(premise, &[], When::Chosen, &mut assumed.premises);
            let is_open =
                |this: &mut Self, need: (Expr, Sign)| !met.contains(&need) && !this.is_met(need.0, need.1, &assumed);
            let open: Vec<((Expr, Sign), Expr)> = needs.into_iter().filter(|(need, _)| is_open(self, *need)).collect();
            if open.is_empty() {
                continue;
            }
            of.extend(self.derivation.claims.iter().position(|c| std::ptr::eq(c, premise)));
            for ((value, sign), shown) in open {
                let one = match sign == Sign::NotZero || is_never_negative(&self.graph, value) {
                    true => Exception::HasNoValue(self.graph.root_of_zeros(shown), Sign::NotZero),
                    false => Exception::HasNoValue(shown, sign),
                };
                if !out.contains(&one) {
                    out.push(one);
                }
            }
        }
        (of, out)
    }

    /// What is asked for a value of what a claim says, with how it is shown: as it stands in the claim, or in the formula of a name.
    fn needs_of(&mut self, premise: &Claim) -> Vec<((Expr, Sign), Expr)> {
        let (equations, signs) = self.said(premise).unwrap_or_default();
        let mut roots: Vec<Expr> = sides(&equations).collect();
        roots.extend(signs.into_iter().flat_map(pairs).flat_map(|(l, r)| [l, r]));
        for form in &premise.forms {
            if let Form::FirstIntegral(w) = form {
                roots.extend(&w.value.components);
            }
        }
        let scopes = [&premise.scope, &self.claim.scope];
        let mut formulas = roots.clone();
        let mut seen: FastSet<Symbol> = FastSet::default();
        let mut at = 0;
        while let Some(&e) = formulas.get(at) {
            at += 1;
            for leaf in self.graph.leaves_within([e]) {
                if seen.insert(leaf.symbol) {
                    let defined = scopes.iter().find_map(|scope| scope.definition(leaf.symbol));
                    formulas.extend(defined.into_iter().flat_map(|d| &d.components));
                }
            }
        }
        let mut shown: FastMap<(Expr, Sign), Expr> = FastMap::default();
        for need in self.graph.needs_below(formulas) {
            let value = self.written_out(need.value, &scopes);
            shown.entry((value, need.sign)).or_insert(need.value);
        }
        let written: Vec<Expr> = roots.into_iter().map(|e| self.written_out(e, &scopes)).collect();
        let mut out: Vec<((Expr, Sign), Expr)> = Vec::new();
        for need in self.graph.needs_below(written) {
            let key = (need.value, need.sign);
            if out.iter().all(|(known, _)| *known != key) {
                out.push((key, shown.get(&key).copied().unwrap_or(need.value)));
            }
        }
        out
    }

    /// What the claim needs itself, what it assumes, and systems: where that is not so, nothing is said, or there is no motion.
    fn needs_met(&mut self, equations: &Pairs) -> FastSet<(Expr, Sign)> {
        let mut roots = self.along(equations);
        roots.extend(
            self.claim.assuming.iter().flat_map(|w| &w.value.relations).flat_map(pairs).flat_map(|(l, r)| [l, r]),
        );
        roots.extend(self.sides_of_systems());
        let written: Vec<Expr> = roots.into_iter().map(|e| self.written_out(e, &[&self.claim.scope])).collect();
        let needs = self.graph.implied_below(written);
        let divided = self.divided_by_systems().into_iter().map(|e| (e, Sign::NotZero));
        needs.iter().map(|n| (n.value, n.sign)).chain(divided).collect()
    }

    /// The signs that hold wherever the claim is said: what it assumes, what is said of all times, and what it needs.
    fn signs_of(&mut self, met: &FastSet<(Expr, Sign)>) -> Gathered {
        let mut values = self.values();
        let mut premises = self.signs_of_premises(&mut values);
        self.roles(&mut premises);
        self.assume(self.claim, &[], When::Chosen, &mut premises);
        let mut met: Vec<(Expr, Sign)> = met.iter().copied().collect();
        met.sort_unstable();
        for (value, sign) in met {
            let list = match sign {
                Sign::Positive => &mut premises.positive,
                Sign::NotNegative => &mut premises.not_negative,
                Sign::NotZero => &mut premises.nonzero,
            };
            list.push(value);
        }
        Gathered { premises, ..Gathered::default() }
    }

    /// The account of a proof that does without some of the claims that are named.
    pub(super) fn proved_without(
        &self,
        left_out: Vec<usize>,
        decide: impl FnOnce(Step<'a>) -> Option<Decided>,
    ) -> Option<IdentityAccount> {
        let step = self.afresh()?;
        let left_out = self.left_out.iter().copied().chain(left_out).collect();
        let step = Step { sign: self.sign, apart: self.apart.clone(), left_out, ..step };
        match decide(step)? {
            Ok(account) if account.finding.is_whole() => Some(account),
            Ok(_) | Err(_) => None,
        }
    }
}
