//! One check, from the file to the account: the methods in their order.
//!
//! **In:** a [`Run`]: a file, what is asked of it, and what is known from before. **Out:** an [`Account`].
//!
//! **How:** what is chosen ([`Selection`]) is compiled ([`Compiled`]), the motions are built and tried ([`OnMotions`]), and what was found
//! becomes an account, which each further method completes. The file stays as it was read: what is compiled has a graph of its own.

use super::compiled::Compiled;
use super::memory::Known;
use super::on_motions::{Found, OnMotions};
use super::premises::{counterexample, strengthen};
use claim::error::{CANCELLED, CheckError};
use claim::options::{Options, Rigor};
use derivation::{Claim, Derivation};
use findings::{Account, ClaimAccount, IdentityAccount};
use proved::step::Step;
use rayon::prelude::*;
use sampled::selection::{Selection, is_asked};
use sampled::stage::Stage;
use sampled::systems::Fields;
use sampled::witness;
use verdict::Verdict;
use weight::variant;

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
        let &Run { file, options, known, .. } = self;
        let motionless = file.trajectories.is_empty() && file.systems.is_empty();
        if file.scope.time().is_none() && motionless && !file.claims.iter().any(Claim::is_of_fields) {
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
        let mut compiled = Compiled::new(self, &selection, derivation, fields);
        let altered = || (!options.plain).then(|| variant::Altered::new(&compiled.derivation, &selection));
        let (mut altered, regions) = rayon::join(altered, || self.regions(&compiled.derivation));
        let regions = regions?;
        compiled.finish(self, &selection, altered.as_mut())?;
        self.unless_cancelled()?;
        let stage = compiled.build(self, &selection)?;
        self.unless_cancelled()?;
        // What is said of all motions together is not said where some are missing.
        let complete = selection.tried.iter().all(|&t| stage.motion(t).is_some());
        let claims = OnMotions {
            run: self,
            selection: &selection,
            compiled: &compiled,
            altered: altered.as_ref(),
            stage: &stage,
        };
        let mut found = claims.all()?;
        self.unless_cancelled()?;
        let mut account = found.account(&compiled.derivation, &selection, &stage);
        self.prove(&compiled, &selection, &found, &mut account)?;
        self.unless_cancelled()?;
        if complete {
            compiled.probes.separate(&compiled.derivation, &found.motions(&selection), &self.recall, &mut account);
        }
        strengthen(&compiled.derivation, &selection, &mut account.claims, known, (&options.limits, self.recall));
        self.enclose(&compiled, &selection, &stage, &mut account)?;
        if let Some(altered) = altered.as_ref().filter(|_| complete) {
            let (weighed, courses) = (&found.weighed, &found.courses);
            altered.conclude(&compiled.derivation, &selection, &mut account.claims, weighed, courses)?;
        }
        // They are large.
        rayon::join(|| drop(altered), || found.courses.clear());
        // Back to the order of the file.
        for (earlier, (at, of)) in regions.into_iter().enumerate() {
            let before = selection.claims.iter().filter(|&&c| c < at).count();
            account.claims.insert(before + earlier, of);
        }
        Ok(self.with_still_variants(&compiled.derivation, account))
    }

    /// Adds what the claims say for all values.
    fn prove(
        &self,
        compiled: &Compiled,
        selection: &Selection,
        found: &Found,
        account: &mut Account,
    ) -> Result<(), CheckError> {
        let (derivation, options) = (&compiled.derivation, self.options);
        let identity = |(k, &c): (usize, &usize)| -> Option<Result<IdentityAccount, String>> {
            let claim = &derivation.claims[c];
            if options.limits.reached().is_some() {
                return None;
            }
            let step = Step::of(derivation, claim)?.with(options.plain);
            match counterexample(derivation, selection, k, self.known, &found.columns) {
                Some((t, witness)) => Some(Ok(step.refuted_by(&derivation.trajectories[t].id, witness))),
                None => self.recall.identity(derivation, claim, || step.decide()),
            }
        };
        let identities: Vec<_> = selection.claims.par_iter().enumerate().with_max_len(1).map(identity).collect();
        for (claim, identity) in account.claims.iter_mut().zip(identities) {
            claim.identity = identity.transpose().map_err(CheckError::Defect)?;
        }
        Ok(())
    }

    /// Encloses the verdicts, where that is asked for, and gives every witness its values.
    fn enclose(
        &self,
        compiled: &Compiled,
        selection: &Selection,
        stage: &Stage,
        account: &mut Account,
    ) -> Result<(), CheckError> {
        let Compiled { derivation, fields, prepared, wanted, .. } = compiled;
        let limits = &self.options.limits;
        if self.options.rigor == Rigor::Enclosed && limits.reached().is_none() {
            let recall = |t: usize, by: &str, before: &[(&Claim, &Verdict)], find: &mut dyn FnMut() -> Vec<Verdict>| {
                self.recall.strengthened(("enclosed", by), derivation, t, before, find)
            };
            let recall = &recall;
            let request = enclosed::Request { derivation, fields, stage, prepared, selection, limits, recall };
            enclosed::strengthen(&request, &mut account.claims);
        }
        self.unless_cancelled()?;
        let Selection { tried, start_of, .. } = selection;
        let points = witness::Points { derivation, stage, prepared, start_of, tried, wanted };
        witness::complete(&points, &mut account.claims);
        self.unless_cancelled()
    }

    /// What is about ranges: it needs no motion.
    fn regions(&self, derivation: &Derivation) -> Result<Regions, CheckError> {
        boxes::decide_all(derivation, |c| is_asked(&self.options.claims, &c.id)).map_err(CheckError::Problems)
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
