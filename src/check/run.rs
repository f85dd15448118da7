//! One check, from the file to the account: the methods in their order.
//!
//! **In:** a [`Run`]: a file, what is asked of it, and what is known from before. **Out:** an [`Account`].
//!
//! **How:** what is chosen ([`Selection`]) is compiled ([`Compiled`]), the motions are built and tried ([`OnMotions`]), and what was found
//! becomes an account, which each further method completes. The file stays as it was read: what is compiled has a graph of its own.

use super::compilation::Compiled;
use super::memory::{Known, Question};
use super::on_motions::{Found, OnMotions};
use super::pieces;
use super::premises::{Accounts, counterexample, refuted_on, replay, strengthen};
use claim::error::{CANCELLED, CheckError};
use claim::limits::Limits;
use claim::options::{Options, Rigor};
use derivation::{Claim, Derivation};
use diag::Diagnostic;
use findings::{Account, ClaimAccount, IdentityAccount, PairAccount};
use flow::KnownSteps;
use meter::{Ended, Task};
use proved::step::Step;
use sampled::selection::{Selection, is_asked};
use sampled::stage::Stage;
use sampled::systems::Fields;
use sampled::witness;
use verdict::Verdict;
use weight::variant;

/// The code of a file whose claims take too much work to be compiled.
const TOO_LARGE: &str = "check::too-large";

/// What is to be checked.
pub(super) struct Run<'a> {
    /// The file.
    pub file: &'a Derivation,
    /// What is asked.
    pub options: &'a Options,
    /// Accounts of other claims, which are premises as if they had been tried again.
    pub known: &'a [ClaimAccount],
    /// Whether it is asked what separates the motions.
    pub separating: bool,
    /// What was found of earlier states of the file.
    pub recall: Known<'a>,
    /// Is told how many of how many motions are done.
    pub progress: &'a (dyn Fn(usize, usize) + Sync),
}

/// Accounts of claims over ranges, each with the position of its claim in the file.
type Regions = Vec<(usize, ClaimAccount)>;

impl<'a> Run<'a> {
    /// A run that knows nothing from before, and tells nobody how far it is.
    pub fn new(file: &'a Derivation, options: &'a Options) -> Run<'a> {
        let (known, recall) = Default::default();
        Run { file, options, known, separating: !options.plain, recall, progress: &|_, _| {} }
    }

    /// The account.
    ///
    /// # Errors
    /// See [`check()`](super::check()).
    pub fn account(&self) -> Result<Account, CheckError> {
        self.account_by(PLAN)
    }

    /// The verdicts that samples give, with their witnesses.
    ///
    /// # Errors
    /// See [`check()`](super::check()).
    pub fn sampled(&self) -> Result<Account, CheckError> {
        self.account_by(SAMPLES)
    }

    fn account_by(&self, plan: &[Method]) -> Result<Account, CheckError> {
        let &Run { file, options, .. } = self;
        let motionless = file.trajectories.is_empty() && file.systems.is_empty();
        if file.scope.time().is_none() && motionless && file.claims.iter().all(Claim::is_over_ranges) {
            let claims = self.regions(file)?.into_iter().map(|(_, c)| c).collect();
            return Ok(self.with_still_variants(file, Account { claims, ..Account::default() }));
        }
        let mut derivation = file.clone();
        let fields = match Fields::solve(&mut derivation.graph, file) {
            Ok(fields) => fields,
            // Problems of ranges are told first.
            Err(problems) => return Err(self.regions(file).err().unwrap_or(CheckError::Problems(problems))),
        };
        let selection = Selection::new(file, &options.claims, &options.trajectories);
        // What is compiled decides all verdicts: a time that is over leaves these open, and not this undone.
        let limits = &Limits { deadline: None, memory: None, ..options.limits.clone() };
        let too_large = |ended: Ended| match ended {
            Ended::Defect(what) => CheckError::Defect(what),
            Ended::Cancelled => CheckError::Defect(CANCELLED.to_owned()),
            ended => CheckError::Problems(vec![Diagnostic::of_file(&file.file.path, TOO_LARGE, ended.to_string())]),
        };
        let compile = || Compiled::new(self, &selection, derivation, fields);
        let mut compiled = meter::piece(Task::Compiling, limits, compile).map_err(too_large)?;
        let regions = self.regions(&compiled.derivation)?;
        // Altered formulas are made in copies.
        compiled.derivation.graph.share();
        let mut altered = match options.plain {
            true => None,
            false => Some(variant::Altered::new(&compiled.derivation, &selection, limits)),
        };
        let finish = || compiled.finish(self, &selection, altered.as_ref());
        meter::piece(Task::Compiling, limits, finish).map_err(too_large)??;
        if let Some(altered) = &mut altered {
            altered.compile(selection.starts.len(), compiled.derivation.scope.branch_sign(), &compiled.wanted, limits);
        }
        // Every claim is proved in a copy of its own.
        compiled.derivation.graph.share();
        self.unless_cancelled()?;
        let stage = compiled.build(self, &selection)?;
        self.unless_cancelled()?;
        let claims = OnMotions {
            run: self,
            selection: &selection,
            compiled: &compiled,
            altered: altered.as_ref(),
            stage: &stage,
        };
        let mut work = Work { claims, found: Found::default(), account: Account::default() };
        for method in plan {
            if method.needs.iter().all(|need| work.has(*need)) {
                (method.find)(&mut work)?;
            }
            self.unless_cancelled()?;
        }
        let Work { mut found, mut account, .. } = work;
        // They are large.
        rayon::join(|| drop(altered), || found.traces.clear());
        // Back to the order of the file.
        for (earlier, (at, of)) in regions.into_iter().enumerate() {
            let before = selection.claims.iter().filter(|&&c| c < at).count();
            account.claims.insert(before + earlier, of);
        }
        Ok(self.with_still_variants(&compiled.derivation, account))
    }

    /// What is about ranges: it needs no motion.
    fn regions(&self, derivation: &Derivation) -> Result<Regions, CheckError> {
        let asked = |c: &Claim| is_asked(&self.options.claims, &c.id);
        boxes::decide_all(derivation, asked, &self.options.limits).map_err(CheckError::Problems)
    }

    /// Adds what altered formulas say of claims that need no motion.
    fn with_still_variants(&self, derivation: &Derivation, mut account: Account) -> Account {
        if !self.options.plain {
            variant::weigh_still(derivation, &mut account.claims, &self.options.limits);
        }
        account
    }

    fn unless_cancelled(&self) -> Result<(), CheckError> {
        match self.options.limits.is_cancelled() {
            true => Err(CheckError::Defect(CANCELLED.to_owned())),
            false => Ok(()),
        }
    }
}

/// A check under way: what each method reads and completes.
struct Work<'w, 'r> {
    claims: OnMotions<'w, 'r>,
    found: Found<'w>,
    account: Account,
}

/// What must be there for a method to be of use.
#[derive(Clone, Copy)]
enum Need {
    /// Every motion that is asked for: what is said of all together is not said where some are missing.
    EveryMotion,
    /// That more is asked than samples.
    Rigor,
    /// That the run may still begin something.
    Time,
}

/// A way to find evidence, or to weigh it, with what it needs.
struct Method {
    needs: &'static [Need],
    find: fn(&mut Work) -> Result<(), CheckError>,
}

/// The methods in their order: each sees what those before it have found, and none calls another.
const PLAN: &[Method] = &[
    Method { needs: &[], find: |work| work.sample() },
    Method { needs: &[], find: |work| work.prove() },
    Method { needs: &[], find: |work| work.lend() },
    Method { needs: &[Need::Rigor, Need::Time], find: |work| work.enclose() },
    Method { needs: &[Need::EveryMotion], find: |work| work.separate() },
    Method { needs: &[], find: |work| work.point() },
    Method { needs: &[Need::EveryMotion], find: |work| work.weigh() },
];

/// Those that look at samples alone.
const SAMPLES: &[Method] =
    &[Method { needs: &[], find: |work| work.sample() }, Method { needs: &[], find: |work| work.point() }];

/// What was enclosed of a file before.
struct Enclosed<'e> {
    derivation: &'e Derivation,
    known: Known<'e>,
}

impl enclosed::Recall for Enclosed<'_> {
    fn known(&self, question: &enclosed::Question) -> Option<enclosed::Answer> {
        self.known.known(self.derivation, Question::Enclosed(*question))
    }

    fn keep(&self, question: &enclosed::Question, answer: &enclosed::Answer) {
        self.known.keep(self.derivation, Question::Enclosed(*question), answer);
    }

    fn steps(&self) -> &dyn KnownSteps {
        &self.known
    }
}

/// Encloses claims that the file does not make. Nothing of them is kept but the steps of motions.
struct EnclosedBeside<'e> {
    known: Known<'e>,
    fields: &'e Fields,
    stage: &'e Stage,
    selection: &'e Selection,
    limits: &'e Limits,
}

impl enclosed::Recall for EnclosedBeside<'_> {
    fn steps(&self) -> &dyn KnownSteps {
        &self.known
    }
}

impl variant::Encloses for EnclosedBeside<'_> {
    fn enclose(&self, derivation: &Derivation, claims: Vec<variant::Beside>) -> Vec<Vec<Verdict>> {
        let &EnclosedBeside { fields, stage, selection, limits, .. } = self;
        let pair = |(t, verdict): (usize, Verdict)| PairAccount {
            trajectory: derivation.trajectories[t].id.clone(),
            verdict,
            expected: None,
            discrimination: None,
        };
        let (mut prepared, mut accounts) = (Vec::new(), Vec::new());
        for of in claims {
            let Some(claim) = of.prepared.first().map(|p| p.claim) else { continue };
            accounts.push(ClaimAccount::of(claim, of.verdicts.into_iter().map(pair).collect()));
            prepared.push(of.prepared);
        }
        let prepared = prepared.as_slice();
        let request = enclosed::Request { derivation, fields, stage, prepared, selection, limits, recall: self };
        enclosed::strengthen(&request, &mut accounts);
        accounts.into_iter().map(|of| of.results.into_iter().map(|pair| pair.verdict).collect()).collect()
    }
}

impl Work<'_, '_> {
    fn has(&self, need: Need) -> bool {
        let run = self.claims.run;
        match need {
            Need::EveryMotion => self.found.untried == 0,
            Need::Rigor => run.options.rigor == Rigor::Enclosed,
            Need::Time => run.options.limits.reached().is_none(),
        }
    }

    /// Tries the claims on the motions, at samples.
    fn sample(&mut self) -> Result<(), CheckError> {
        let OnMotions { selection, compiled, stage, .. } = self.claims;
        self.found = self.claims.all()?;
        self.account = self.found.account(&compiled.derivation, selection, stage);
        Ok(())
    }

    /// Adds what the claims say for all values.
    fn prove(&mut self) -> Result<(), CheckError> {
        let OnMotions { run, selection, compiled, .. } = self.claims;
        let (derivation, options, columns) = (&compiled.derivation, run.options, &self.found.columns);
        let known = Accounts::of(run.known);
        let identity = |&(k, c): &(usize, usize), limits: &Limits| -> Option<Result<IdentityAccount, String>> {
            let claim = &derivation.claims[c];
            if limits.reached().is_some() {
                return None;
            }
            let step = Step::of(derivation, claim)?.with(options.plain);
            match counterexample(derivation, selection, k, &known, columns) {
                Some((t, witness)) => Some(refuted_on(&step, (&derivation.trajectories[t].id, witness), k, columns)),
                None => run.recall.answer(derivation, Question::Identity(claim), || {
                    pieces::decided(derivation, claim, limits, || step.decide())
                }),
            }
        };
        let claims: Vec<(usize, usize)> = selection.claims.iter().copied().enumerate().collect();
        let identities = meter::each(&options.limits, &claims, identity);
        for ((claim, identity), &c) in self.account.claims.iter_mut().zip(identities).zip(&selection.claims) {
            claim.identity = identity.map(|found| pieces::account(derivation, &derivation.claims[c], found));
        }
        // The accounts have the verdicts: nobody asks for them by motions any more.
        self.found.columns = Vec::new();
        Ok(())
    }

    /// Adds what separates the motions.
    fn separate(&mut self) -> Result<(), CheckError> {
        let OnMotions { run, selection, compiled, .. } = self.claims;
        let motions = self.found.motions(selection);
        compiled.probes.separate(&compiled.derivation, &motions, &run.recall, &run.options.limits, &mut self.account);
        Ok(())
    }

    /// Lends the strength of proofs to verdicts on motions.
    fn lend(&mut self) -> Result<(), CheckError> {
        let OnMotions { run, selection, compiled, .. } = self.claims;
        let limits = (&run.options.limits, run.recall);
        replay(run.file, &mut self.account.claims, run.known, limits);
        strengthen(&compiled.derivation, selection, &mut self.account.claims, run.known, limits);
        Ok(())
    }

    /// Encloses the verdicts.
    fn enclose(&mut self) -> Result<(), CheckError> {
        let OnMotions { run, selection, compiled, stage, .. } = self.claims;
        let Compiled { derivation, fields, prepared, .. } = compiled;
        let (limits, recall) = (&run.options.limits, &Enclosed { derivation, known: run.recall });
        let request = enclosed::Request { derivation, fields, stage, prepared, selection, limits, recall };
        enclosed::strengthen(&request, &mut self.account.claims);
        Ok(())
    }

    /// Gives every witness its values.
    fn point(&mut self) -> Result<(), CheckError> {
        let OnMotions { selection, compiled, stage, .. } = self.claims;
        let Compiled { derivation, prepared, wanted, .. } = compiled;
        let Selection { tried, start_of, .. } = selection;
        let points = witness::Points { derivation, stage, prepared, start_of, tried, wanted };
        witness::complete(&points, &mut self.account.claims);
        Ok(())
    }

    /// Weighs the evidence by what altered formulas would do, where that is asked.
    fn weigh(&mut self) -> Result<(), CheckError> {
        let OnMotions { run, selection, compiled, altered, stage, .. } = self.claims;
        let Some(altered) = altered else { return Ok(()) };
        let Found { weighed, traces, .. } = &self.found;
        let (known, fields) = (run.recall, &compiled.fields);
        let beside = EnclosedBeside { known, fields, stage, selection, limits: &run.options.limits };
        let encloses = self.has(Need::Rigor).then_some(&beside as &dyn variant::Encloses);
        altered.conclude(
            &compiled.derivation,
            selection,
            &mut self.account.claims,
            weighed,
            (traces, &run.options.limits),
            encloses,
        )
    }
}
