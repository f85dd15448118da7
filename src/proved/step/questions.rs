//! The questions that a step asks: with more and more definitions, for each choice of factors, at a fixed time.
//!
//! **In:** equations, and what is given. **Out:** the answer of the test for the first question that settles it, see
//! [`Definitions::LEVELS`]. **Guaranteed:** only a question with all definitions refutes; a proof from fewer is looked at in the light of all.

use super::definitions::Definitions;
use super::gather::Gathered;
use super::{FEW_POINTS, Level, Pairs, Settled, Step, has_exceptions};
use crate::expr::{Expr, Leaf};
use proof::{
    Branching, Identity, Options, Premises, Proof, Reason, Wanted, When, branches_test_after, identity_test_after,
};
use std::collections::BTreeSet;

impl Step<'_> {
    /// One question, with more and more definitions.
    pub(super) fn levels(&mut self, gathered: &Gathered, equations: &Pairs, split: bool, wanted: Wanted) -> Identity {
        let mut tried: Option<Premises> = None;
        let last = Definitions::LEVELS.len() - 1;
        let mut everything = None;
        for (definitions, which) in Definitions::LEVELS.into_iter().enumerate().take(last) {
            let premises = self.premises(gathered, equations, which);
            if definitions + 1 == last {
                everything = Some(self.premises(gathered, equations, Definitions::LEVELS[last]));
            }
            if [&tried, &everything].into_iter().flatten().any(|t| t.equations == premises.equations) {
                continue;
            }
            let equations = &self.beyond(equations, &premises);
            if let Identity::Proved(proof) = self.ask_for(Wanted::Proof, &premises, equations, split) {
                self.proved_at = Level { split, definitions };
                let settled = self.settled.take();
                let identity = self.with_all_definitions(proof, gathered, &premises, equations, split);
                self.settled = settled;
                return identity;
            }
            tried = Some(premises);
        }
        self.proved_at = Level { split, definitions: last };
        let everything = everything.unwrap_or_else(|| self.premises(gathered, equations, Definitions::LEVELS[last]));
        self.ask_for(wanted, &everything, equations, split)
    }

    /// One question. Where only a proof is of interest, few points are tried, until there is one that wants an example; and no further
    /// derivatives are formed to see whether a point belongs to a motion.
    fn ask_for(&mut self, wanted: Wanted, premises: &Premises, equations: &Pairs, split: bool) -> Identity {
        let wanted = if self.has_few_points { Wanted::Proof } else { wanted };
        if wanted != Wanted::Proof {
            return self.ask(premises, equations, &Options { wanted, ..Options::default() }, split);
        }
        let few = Options { attempts: FEW_POINTS, wanted, ..Options::default() };
        match self.ask(premises, equations, &few, split) {
            Identity::Proved(proof) if proof.example.is_none() && !self.has_few_points => {
                match self.ask(premises, equations, &Options::default(), split) {
                    again @ Identity::Proved(_) => again,
                    _ => Identity::Proved(proof),
                }
            }
            identity => identity,
        }
    }

    /// Whether something is said about values at several times, or as a function of the time, where what is given says only what a
    /// motion has between them: its rates, or signs that no continuous motion changes without passing 0. Then a point that satisfies
    /// everything given need not belong to a motion.
    pub(super) fn joins_times(&self, gathered: &Gathered, equations: &Pairs) -> bool {
        let sides = |p: &Pairs| p.iter().flat_map(|&(l, r)| [l, r]).collect::<Vec<_>>();
        let scope = &self.claim.scope;
        let said = self.graph.leaves_within(sides(equations));
        let now = said.iter().any(|l| scope.moves(l) && l.instant.is_none());
        let named = said.iter().any(|l| l.instant.is_some() || Some(*l) == scope.time());
        let given = self.graph.leaves_within(sides(&gathered.systems).into_iter().chain(gathered.premises.sides()));
        let premises = &gathered.premises;
        let signs = premises.signs();
        let of_signs = self.graph.leaves_within(signs);
        let several = |leaves: &mut dyn Iterator<Item = &Leaf>| {
            let times: BTreeSet<Option<Expr>> = leaves.filter(|l| scope.moves(l)).map(|l| l.instant).collect();
            times.len() > 1
        };
        let fixed = |leaves: &[Leaf]| -> BTreeSet<Expr> {
            leaves.iter().filter(|l| scope.moves(l)).filter_map(|l| l.instant).collect()
        };
        // What is given of one fixed time says nothing at once of another one.
        let (claimed, started) = (fixed(&said), fixed(&given));
        let elsewhere = !claimed.is_empty() && claimed.union(&started).count() > 1;
        let signed = of_signs.iter().any(|l| scope.moves(l) && l.instant.is_none());
        let rates = given.iter().any(|l| l.rate > 0);
        now && named && (signed || rates)
            || rates && (elsewhere || several(&mut said.iter()))
            || signed && several(&mut said.iter().chain(&of_signs))
    }

    /// Whether values of fields at several places are named, and a sign that is given of a field at all of them: no field changes it
    /// from one to another without passing 0, and at x = 0 it may say something else than it does beside.
    pub(super) fn joins_places(&self, gathered: &Gathered, equations: &Pairs) -> bool {
        let premises = &gathered.premises;
        let signs = premises.signs();
        let fields = |roots: Vec<Expr>| {
            let mut leaves = self.graph.leaves_within(roots);
            leaves.retain(|l| self.graph.is_field(l.symbol));
            leaves
        };
        let signed = fields(signs.collect());
        let said = fields(equations.iter().flat_map(|&(l, r)| [l, r]).collect());
        let place = |l: &Leaf| self.graph.place(l.symbol).map(|p| p.at.clone());
        let first = signed.first().map(place);
        let everywhere = |l: &Leaf| (0..self.graph.coordinates().count()).any(|c| self.graph.depends(l.symbol, c));
        signed.iter().any(everywhere) && signed.iter().chain(&said).any(|l| Some(place(l)) != first)
    }

    /// A refutation at the fixed time that premises name, where present and fixed values are the same; `None` where no
    /// premise names one. Other values need not belong to one motion: what connects them are rates, or that a motion
    /// does not leap from one solution of the premises to another.
    pub(super) fn at_fixed_time(&mut self, gathered: &Gathered, equations: &Pairs) -> Option<Identity> {
        let mut premises = self.premises(gathered, equations, Definitions::Everything);
        let sides = |p: &Pairs| p.iter().flat_map(|&(l, r)| [l, r]).collect::<Vec<_>>();
        let leaves = self.graph.leaves_within(sides(equations).into_iter().chain(premises.sides()));
        let scope = &self.claim.scope;
        let moves = |l: &Leaf| scope.moves(l);
        // Without a present value nothing is connected.
        let now = self.graph.leaves_within(sides(equations)).iter().any(|l| moves(l) && l.instant.is_none());
        let then: Vec<Leaf> = leaves.into_iter().filter(|l| moves(l) && l.instant.is_some()).collect();
        let instant = then.first()?.instant;
        if !now {
            return None;
        }
        if then.iter().any(|l| l.instant != instant) {
            return Some(Identity::Undecided(Reason::NoDerivative));
        }
        let fixed = instant?;
        for leaf in then {
            let pair = [leaf, Leaf { instant: None, ..leaf }].map(|l| self.graph.leaf(l));
            premises.give([(pair[0], pair[1])], When::At(fixed));
        }
        if let Some(time) = scope.time() {
            premises.give([(self.graph.leaf(time), fixed)], When::At(fixed));
        }
        Some(self.ask(&premises, equations, &Options::default(), false))
    }

    /// What the premises do not say already, as it stands.
    fn beyond(&mut self, equations: &Pairs, premises: &Premises) -> Pairs {
        let mut rest: Pairs = equations.iter().filter(|&&p| !premises.says(p)).copied().collect();
        if rest.is_empty() {
            let zero = self.graph.integer(0);
            rest.push((zero, zero));
        }
        rest
    }

    /// A proof that used a part of the definitions, in the light of all: they may contradict what is given, and a point may
    /// lie among the exceptions of the proof.
    fn with_all_definitions(
        &mut self,
        proof: Proof,
        gathered: &Gathered,
        part: &Premises,
        equations: &Pairs,
        split: bool,
    ) -> Identity {
        let premises = self.premises(gathered, equations, Definitions::All);
        if premises.equations == part.equations {
            // Nothing was left out.
            return Identity::Proved(proof);
        }
        let options = Options { attempts: FEW_POINTS, wanted: Wanted::Fault, ..Options::default() };
        let generic = has_exceptions(&proof);
        match self.ask(&premises, equations, &options, split) {
            contradiction @ Identity::Undecided(Reason::Contradiction) => contradiction,
            refuted @ Identity::Refuted(_) if generic => refuted,
            Identity::Refuted(_) => {
                let what = "a step is proved without definitions, and refuted with them".to_owned();
                Identity::Undecided(Reason::Defect(what))
            }
            _ => Identity::Proved(proof),
        }
    }

    /// The test of one set of premises; with `split`, of every choice of factors of those that are products.
    pub(super) fn ask(&mut self, premises: &Premises, equations: &Pairs, options: &Options, split: bool) -> Identity {
        if !split {
            return self.test(premises, equations, options);
        }
        let mut all: Option<Proof> = None;
        // Which factor vanishes may change with time: a case is about one time, and what is near it.
        let conclusion: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        if self.graph.leaves_within(conclusion).iter().any(|leaf| leaf.instant.is_some()) {
            return self.test(premises, equations, options);
        }
        let cases = self.cases(premises);
        let several = cases.len() > 1;
        for case in cases {
            let found = self.test(&case, equations, options);
            if several {
                self.settled = None;
            }
            match found {
                Identity::Proved(proof) => match &mut all {
                    None => all = Some(proof),
                    Some(sum) => sum.absorb(proof),
                },
                Identity::Undecided(Reason::Contradiction) => {}
                other => return other,
            }
        }
        all.map_or(Identity::Undecided(Reason::Contradiction), Identity::Proved)
    }

    pub(super) fn test(&mut self, premises: &Premises, equations: &Pairs, options: &Options) -> Identity {
        let identity = self.test_only(premises, equations, options);
        self.settled = match &identity {
            Identity::Undecided(_) => None,
            _ => Some(Settled { premises: premises.clone(), equations: equations.clone(), identity: identity.clone() }),
        };
        identity
    }

    pub(super) fn test_only(&mut self, premises: &Premises, equations: &Pairs, options: &Options) -> Identity {
        let most = if self.has_few_points { FEW_POINTS } else { options.attempts };
        let options = &Options { attempts: options.attempts.min(most), ..*options };
        let sign = self.claim.scope.branch_sign();
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        if !self.graph.leaves_within(roots).contains(&sign) {
            return identity_test_after(&mut self.memory, &mut self.graph, equations, premises, options);
        }
        let branches = [1, -1].map(|value| self.branch(equations, value));
        let found = branches_test_after(&mut self.memory, &mut self.graph, &branches, premises, options);
        found.told(self.branching(equations, premises)).0
    }

    /// What ± in these equations is claimed to be. Values of parameters are points, as are times; what moves is a motion for each of them.
    pub(super) fn branching(&self, equations: &Pairs, premises: &Premises) -> Branching {
        if !self.claim.branches_throughout {
            return Branching::Pointwise;
        }
        let said = equations.iter().flat_map(|&(l, r)| [l, r]).chain(premises.sides()).chain(premises.signs());
        let named = self.graph.leaves_within(said);
        let is_field = |l: &Leaf| self.graph.is_field(l.symbol) || self.graph.place(l.symbol).is_some();
        let is_point = |l: &Leaf| Some(*l) == self.claim.scope.time() || self.graph.coordinate(*l).is_some();
        let moves = named.iter().any(|l| self.claim.scope.moves(l) || is_field(l));
        let sign = self.claim.scope.branch_sign();
        let constant = |l: &&Leaf| **l != sign && !is_point(l);
        match moves || named.iter().any(is_point) && named.iter().find(constant).is_some() {
            true => Branching::ThroughoutMotion,
            false => Branching::Throughout,
        }
    }
}
