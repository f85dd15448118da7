//! Solutions: a formula satisfies the same linear equation as what it is said to be, with the same start.
//!
//! **In:** a claim l = r, of which one side names a function x that moves. **Out:** its proof by [`Step::Vanishes`]: e = l − r and its rate vanish at a fixed time, and ė = g·e, or ë = g·e + h·ė; or
//! nothing. **How g and h are found:** the rate of x, with all that facts say of it put in, is linear in x and ẋ.

use crate::prove::Attempt;
use crate::vanish::{Beginning, Divisor, Kind, Open, order};
use checker::{FactId, Instant, Relation, Sense, Step, Term, When};
use expr::{Expr, Leaf};

/// Most rounds of elimination.
const MOST_ROUNDS: usize = 40;

impl Attempt<'_> {
    /// The claim, since both sides solve the same equation; `goal` is their difference.
    pub(crate) fn by_uniqueness(&mut self, claim: &Relation, goal: Expr) -> Option<FactId> {
        if self.sequent.symbols.iter().any(|d| matches!(d.kind, checker::SymbolKind::Field(_))) {
            return None;
        }
        let of_values = |leaf: &Leaf| leaf.rate == 0 && self.kind_of(*leaf) == Some(Kind::Value);
        let leaf = self.search.reader.graph.leaves([goal]).into_iter().find(of_values)?;
        let (functions, row) = self.linear(leaf, goal)?;
        let because = self.throughout();
        let mut rates = Vec::new();
        for (at, function) in functions.iter().enumerate() {
            let rate = self.search.draft.derivative(function).ok()?;
            let left = self.search.reader.read(&rate)?;
            let right = match functions.get(at + 1) {
                Some(next) => self.search.reader.read(next)?,
                None => self.multiples_of(&functions, &row)?,
            };
            rates.push(self.free(left, right, &because)?);
        }
        let n = row.len();
        let unit = |i: usize, j: usize| Term::integer(i64::from(j == i + 1));
        let mut matrix: Vec<Vec<Term>> = (0..n).map(|i| (0..n).map(|j| unit(i, j)).collect()).collect();
        matrix[n - 1] = row.iter().map(|&e| self.search.reader.term(e)).collect::<Option<_>>()?;
        for at in 0..self.sequent.instants.len() as u32 {
            let Some(starts) = self.starts(&functions, at, &because) else { continue };
            let (of, matrix, rates, because) = (functions.clone(), matrix.clone(), rates.clone(), because.clone());
            let step = Step::Vanishes { of, matrix, at: Instant(at), rates, starts, because };
            if let Some(fact) = self.search.push(step) {
                let one = self.search.reader.graph.integer(1);
                self.search.solved.clear();
                return self.search.zero(claim.clone(), None, &[(fact, one)], &[]);
            }
        }
        None
    }

    /// What is known at all times: since systems have values, and since the claim has one.
    fn throughout(&mut self) -> Vec<FactId> {
        let mut out = self.values_throughout();
        let of_claim = 0..self.search.draft.claim_needs().len() as u32;
        out.extend(of_claim.filter_map(|need| self.search.push(Step::ClaimHasValue { need, within: When::Always })));
        out
    }

    /// e, or e and its rate, of which the rate of the last one is a sum of multiples, as far as the factor of a function shows it; and the multiples.
    fn linear(&mut self, leaf: Leaf, e: Expr) -> Option<(Vec<Term>, Vec<Expr>)> {
        let whole = self.search.reader.term(e)?;
        let first = self.rate_of(&whole)?;
        let alone = |this: &Self, e: Expr| {
            let moving = |l: &Leaf| this.kind_of(*l) == Some(Kind::Value) || this.kind_of(*l) == Some(Kind::Rate);
            this.search.reader.graph.leaves([e]).into_iter().filter(moving).all(|l| l == leaf)
        };
        let slope = |this: &mut Self, e: Expr, leaf: Leaf| {
            let slope = this.search.reader.graph.slope(e, leaf).ok()?;
            this.simplified(slope)
        };
        let of_leaf = slope(self, e, leaf)?;
        let ratio = |this: &mut Self, a: Expr, b: Expr| {
            let ratio = this.search.reader.graph.div(a, b);
            this.simplified(ratio)
        };
        if alone(self, first) {
            let rate = slope(self, first, leaf)?;
            return Some((vec![whole], vec![ratio(self, rate, of_leaf)?]));
        }
        let next = self.search.reader.term(first)?;
        let second = self.rate_of(&next)?;
        // Another function, or the rate, with a number before it, tells the multiple of the rate.
        let mut of_rate = self.search.reader.graph.integer(0);
        for other in self.search.reader.graph.leaves([first]).into_iter().filter(|l| *l != leaf) {
            let before = slope(self, first, other)?;
            if self.search.reader.graph.as_constant(before).is_some() && !self.search.reader.graph.is_zero(before) {
                let after = slope(self, second, other)?;
                of_rate = ratio(self, after, before)?;
            }
        }
        let (a, b) = (slope(self, first, leaf)?, slope(self, second, leaf)?);
        let graph = &mut self.search.reader.graph;
        let taken = graph.mul(of_rate, a);
        let left = graph.sub(b, taken);
        Some((vec![whole, next], vec![ratio(self, left, of_leaf)?, of_rate]))
    }

    /// The rate of a function, with what facts say of the rates in it.
    fn rate_of(&mut self, function: &Term) -> Option<Expr> {
        let rate = self.search.draft.derivative(function).ok()?;
        let rate = self.search.reader.read(&rate)?;
        self.reduced(rate)
    }

    fn multiples_of(&mut self, functions: &[Term], row: &[Expr]) -> Option<Expr> {
        let mut sum = self.search.reader.graph.integer(0);
        for (function, &factor) in functions.iter().zip(row) {
            let function = self.search.reader.read(function)?;
            let term = self.search.reader.graph.mul(factor, function);
            sum = self.search.reader.graph.add(sum, term);
        }
        Some(sum)
    }

    /// An expression with rates put in that facts are solved for, expanded.
    fn reduced(&mut self, mut e: Expr) -> Option<Expr> {
        self.search.renew();
        self.search.solved.clear();
        let mut rest: Vec<Open> = Vec::new();
        for fact in self.facts.clone() {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            rest.push(Open { fact, e: self.search.reader.graph.sub(l, r) });
        }
        for divisor in [Divisor::Number, Divisor::Constant] {
            for _ in 0..MOST_ROUNDS {
                let leaves = self.search.reader.graph.leaves([e]);
                let Some((at, leaf)) = self.best(&rest, &leaves, divisor, Kind::Rate) else { break };
                let open = rest.remove(at);
                // Solved for its highest rate only, so that no higher one comes in.
                if self.search.reader.graph.leaves([open.e]).into_iter().any(|l| order(l) > order(leaf)) {
                    continue;
                }
                let Some(solved) = self.solve(&open, leaf) else { continue };
                self.search.put_in(&mut e, solved).then_some(())?;
                rest.retain_mut(|open| self.search.put_in(&mut open.e, solved));
            }
        }
        Some(e)
    }

    /// That all functions are 0 at a fixed time.
    fn starts(&mut self, functions: &[Term], at: u32, because: &[FactId]) -> Option<Vec<FactId>> {
        self.take_values(&[at]);
        let instant = Instant(at);
        let mut out = Vec::new();
        for function in functions {
            let then = self.search.draft.at(function, instant)?;
            let (left, zero) = (self.search.reader.read(&then)?, self.search.reader.graph.integer(0));
            out.push(self.free(left, zero, because)?);
        }
        Some(out)
    }

    /// left = right as a fact that needs nothing.
    fn free(&mut self, left: Expr, right: Expr, because: &[FactId]) -> Option<FactId> {
        let says = self.search.reader.equation(left, right)?;
        debug_assert_eq!(says.sense, Sense::Equal);
        let goal = self.search.reader.graph.sub(left, right);
        let fact = self.renewed(&says, goal, Beginning::Plain)?;
        let free = self.search.push(Step::Discharge { fact, because: because.to_vec() })?;
        self.search.draft.needs(free).is_empty().then_some(free)
    }
}
