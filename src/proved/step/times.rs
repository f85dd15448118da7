//! Fixed times of a step: which of them are one, what is asked at a single one, and motions that stand still.
//!
//! **In:** a claim as equations, and what is given. **Out:** the same question with fewer times in it, where that is possible.
//!
//! A claim about values at one fixed time only is a claim about the present, given that the time is that one. A claim about values at
//! several is claimed of all presents in place of one of them: that is more, and can be followed along rates.

use super::gather::Gathered;
use super::{Definitions, Pairs, Step};
use crate::expr::{Expr, Leaf};
use claim::comparison::at_instant;
use proof::{Identity, Options, Premises, Wanted, When, identity_test_after};

/// Most values at fixed times of which it is asked whether they are the same.
const MOST_TIES: usize = 4;

/// What is known of the fixed times.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Times {
    /// Two of them may be one, or not: a point at which they have different values refutes nothing.
    pub(super) unclear: bool,
}

impl Step<'_> {
    fn instants(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        let mut out: Vec<Expr> = self.graph.leaves_within(roots).into_iter().filter_map(|l| l.instant).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// Times that are equal, given what is said of parameters, become one.
    pub(super) fn unite_times(&mut self, gathered: &mut Gathered, equations: &mut Pairs) -> Times {
        let sides = |p: &Pairs| p.iter().flat_map(|&(l, r)| [l, r]).collect::<Vec<_>>();
        let roots = sides(equations).into_iter().chain(gathered.premises.sides());
        let mut instants = self.instants(roots);
        let mut times = Times::default();
        let about_parameters =
            |this: &Self, roots: [Expr; 2]| this.graph.leaves_within(roots).iter().all(|l| !this.claim.scope.moves(l));
        let zero = self.graph.integer(0);
        let keep = |this: &Self, list: &[Expr]| -> Vec<Expr> {
            list.iter().copied().filter(|&e| about_parameters(this, [e, zero])).collect()
        };
        let premises = Premises {
            equations: gathered
                .premises
                .equations
                .iter()
                .copied()
                .filter(|k| about_parameters(self, [k.left, k.right]))
                .collect(),
            nonzero: keep(self, &gathered.premises.nonzero),
            positive: keep(self, &gathered.premises.positive),
            not_negative: keep(self, &gathered.premises.not_negative),
            ..Premises::default()
        };
        let mut premises = premises;
        let named = instants.iter().copied().chain(premises.sides());
        for leaf in self.graph.leaves_within(named) {
            if self.is_positive_parameter(leaf) {
                let node = self.graph.leaf(leaf);
                premises.positive.push(node);
            }
        }
        let mut same: Vec<(Expr, Expr)> = Vec::new();
        let mut at = 0;
        while at < instants.len() {
            let mut other = at + 1;
            while other < instants.len() {
                let pair = (instants[at], instants[other]);
                let options = Options { attempts: 48, wanted: Wanted::Answer, ..Options::default() };
                let found = identity_test_after(&mut self.memory, &mut self.graph, &[pair], &premises, &options);
                match found {
                    Identity::Proved(proof) if !super::has_exceptions(&proof) => {
                        same.push((instants.remove(other), pair.0));
                        continue;
                    }
                    Identity::Refuted(_) => {}
                    Identity::Proved(_) | Identity::Undecided(_) => times.unclear = true,
                }
                other += 1;
            }
            at += 1;
        }
        if same.is_empty() {
            return times;
        }
        let mut put = |e: Expr| {
            self.graph.substitute(e, |graph, leaf| {
                let instant = leaf.instant?;
                let &(_, one) = same.iter().find(|(gone, _)| *gone == instant)?;
                Some(graph.leaf(Leaf { instant: Some(one), ..leaf }))
            })
        };
        let Premises { equations: given, nonzero, positive, not_negative, .. } = &mut gathered.premises;
        for (l, r) in equations.iter_mut().chain(&mut gathered.systems) {
            (*l, *r) = (put(*l), put(*r));
        }
        for known in given {
            *known = known.with((put(known.left), put(known.right)));
        }
        for e in nonzero.iter_mut().chain(positive).chain(not_negative) {
            *e = put(*e);
        }
        if equations.iter().all(|(l, r)| l == r) {
            *equations = vec![(zero, zero)];
        }
        times
    }

    /// A claim without present values, as one about the present, and whether that says the same and not more; `None` where it has
    /// present values, or names the time.
    pub(super) fn at_present(&mut self, gathered: &mut Gathered, equations: &Pairs) -> Option<(Pairs, bool)> {
        let time = self.claim.scope.time()?;
        if gathered.known != When::Always {
            return None;
        }
        let said: Vec<Leaf> = self.graph.leaves_within(equations.iter().flat_map(|&(l, r)| [l, r]));
        if said.contains(&time) || said.iter().any(|l| self.claim.scope.moves(l) && l.instant.is_none()) {
            return None;
        }
        let instants = self.instants(equations.iter().flat_map(|&(l, r)| [l, r]));
        let &chosen = instants.first()?;
        let mut of_premises: Vec<Leaf> = self.graph.leaves_within(gathered.premises.sides());
        // A sign that is known at another time ties the value there to the one that is asked about, where signs are known at all times.
        let given = &gathered.premises;
        let signs = given.signs();
        let of_signs = self.graph.leaves_within(signs);
        of_premises.extend(&of_signs);
        of_premises.sort_unstable();
        of_premises.dedup();
        let moves = |l: &Leaf| self.claim.scope.moves(l);
        let are_tied = of_signs.iter().any(|l| moves(l) && l.instant.is_some_and(|i| i != chosen))
            && of_signs.iter().any(|l| moves(l) && l.instant.is_none());
        let alone =
            !are_tied && instants.len() == 1 && of_premises.iter().all(|l| l.instant.is_none_or(|i| i == chosen));
        if alone {
            for leaf in of_premises.into_iter().filter(|l| l.instant.is_some()) {
                let pair = [leaf, Leaf { instant: None, ..leaf }].map(|l| self.graph.leaf(l));
                gathered.premises.give([(pair[0], pair[1])], When::At(chosen));
            }
            let systems = gathered.systems.iter().flat_map(|&(l, r)| [l, r]);
            let named: Vec<Expr> = gathered.premises.sides().chain(systems).collect();
            if self.graph.leaves_within(named).contains(&time) {
                let now = self.graph.leaf(time);
                gathered.premises.give([(now, chosen)], When::At(chosen));
            }
            gathered.premises.present = When::At(chosen);
        }
        let mut put = |e: Expr| {
            self.graph.substitute(e, |graph, leaf| {
                (leaf.instant == Some(chosen)).then(|| graph.leaf(Leaf { instant: None, ..leaf }))
            })
        };
        Some((equations.iter().map(|&(l, r)| (put(l), put(r))).collect(), alone))
    }

    /// Whether what is given at several fixed times contradicts what is given always: ẋ = 0, x(0) = 1, x(1) = 2. Values that are shown to be the
    /// same at two of them are given as such.
    pub(super) fn excludes_between_times(&mut self, gathered: &Gathered, equations: &Pairs) -> bool {
        let given = &gathered.premises;
        let mut leaves = self.graph.leaves_within(given.sides().chain(given.signs()));
        leaves.retain(|l| l.instant.is_some() && l.rate == 0 && self.claim.scope.moves(l));
        let pairs = leaves.iter().enumerate().flat_map(|(at, l)| leaves[..at].iter().map(move |other| (*l, *other)));
        let alike = |&(l, other): &(Leaf, Leaf)| Leaf { instant: other.instant, ..l } == other;
        let pairs: Vec<(Leaf, Leaf)> = pairs.filter(alike).take(MOST_TIES).collect();
        if pairs.is_empty() {
            return false;
        }
        let (settled, level, start) = (self.settled.take(), self.proved_at, self.start);
        let mut same = gathered.clone();
        for (one, other) in pairs {
            let now = self.graph.leaf(Leaf { instant: None, ..one });
            let [one, other] = [one, other].map(|l| self.graph.leaf(l));
            let is_kept = match self.by_rate(gathered, &vec![(now, one)]) {
                Some((Identity::Proved(proof), _)) => !super::has_exceptions(&proof),
                _ => false,
            };
            if is_kept {
                same.premises.give([(one, other)], When::Always);
            }
        }
        let excluded =
            same.premises.equations.len() > given.equations.len() && self.is_without_motion(&same, equations);
        (self.settled, self.proved_at, self.start) = (settled, level, start);
        excluded
    }

    /// Whether what is proved of all times contradicts what is given at fixed ones: tx = 0 and x(0) = 1 leave x = 0 but at time 0, and no
    /// motion leaps there.
    pub(super) fn excludes_at_times(&mut self, gathered: &Gathered, equations: &Pairs) -> bool {
        let given = &gathered.premises;
        let instants = self.instants(given.sides().chain(given.signs()));
        let said = self.equations(self.claim).unwrap_or_default();
        let sides: Vec<Expr> = said.iter().flat_map(|&(l, r)| [l, r]).collect();
        let leaves = self.graph.leaves_within(sides.iter().copied());
        let is_plain = |l: &Leaf| l.rate == 0 && *l != self.claim.scope.branch_sign();
        let valued = self.graph.needs_below(sides.into_iter().chain(given.sides())).is_empty();
        if instants.is_empty() || gathered.known != When::Always || !valued || !leaves.iter().all(is_plain) {
            return false;
        }
        let mut more = gathered.clone();
        for instant in instants {
            for &(l, r) in &said {
                let then = [l, r].map(|e| at_instant(&mut self.graph, &self.claim.scope, e, instant));
                if then[0] != then[1] && !more.premises.says((then[0], then[1])) {
                    more.premises.give([(then[0], then[1])], When::Always);
                }
            }
        }
        more.premises.equations.len() > given.equations.len() && self.is_without_motion(&more, equations)
    }

    /// Whether what is given ties anything that moves: else values at different times are free.
    pub(super) fn ties(&self, gathered: &Gathered) -> bool {
        let systems = gathered.systems.iter().flat_map(|&(l, r)| [l, r]);
        self.graph.leaves_within(gathered.premises.sides().chain(systems)).iter().any(|l| self.claim.scope.moves(l))
    }

    /// A refutation by a motion that stands still: all rates are 0, and values at all times are one. `None` if what is given names
    /// the time, or such a motion does not refute.
    pub(super) fn at_rest(&mut self, gathered: &Gathered, equations: &Pairs) -> Option<Identity> {
        let time = self.claim.scope.time()?;
        // Whatever rates occur: the motion that stands still must satisfy the systems.
        let mut gathered = gathered.clone();
        let systems = std::mem::take(&mut gathered.systems);
        gathered.premises.give(systems, When::Always);
        let mut premises = self.premises(&gathered, equations, Definitions::All);
        // A motion that stands still has its present values at the fixed time.
        premises.equations.retain(|k| !matches!(k.when, When::At(_)));
        let zero = self.graph.integer(0);
        let claim = &self.claim.scope;
        let moves = |leaf: Leaf| claim.moves(&leaf);
        let mut put = |e: Expr| {
            self.graph.substitute(e, |graph, leaf| {
                if !moves(leaf) {
                    None
                } else if leaf.rate > 0 {
                    Some(zero)
                } else {
                    leaf.instant.is_some().then(|| graph.leaf(Leaf { instant: None, ..leaf }))
                }
            })
        };
        for known in &mut premises.equations {
            *known = known.with((put(known.left), put(known.right)));
        }
        for e in premises.nonzero.iter_mut().chain(&mut premises.positive).chain(&mut premises.not_negative) {
            *e = put(*e);
        }
        let equations: Pairs = equations.iter().map(|&(l, r)| (put(l), put(r))).collect();
        // What has no value everywhere says something, whatever its sides are.
        premises.equations.retain(|k| k.left != k.right || !self.graph.needs_below([k.left]).is_empty());
        let signs = premises.signs();
        let named: Vec<Expr> = premises.sides().chain(signs).collect();
        if self.graph.leaves_within(named).contains(&time) || equations.iter().all(|(l, r)| l == r) {
            return None;
        }
        let options = Options { special_cases: 2, ..Options::default() };
        let found = self.test_only(&premises, &equations, &options);
        matches!(found, Identity::Refuted(_)).then_some(found)
    }
}
