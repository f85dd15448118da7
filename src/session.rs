//! The program as a library: the text of a derivation file comes in, diagnostics and findings go out, as plain data.
//!
//! **In:** a text and a name for it, then questions ([`Ask`]). **Out:** [`Findings`]: one [`Finding`] for each claim on each
//! motion, or the documents that the reports are made of.
//!
//! **Guaranteed:** no file is read or written, nothing is printed, the process does not end, and the derivation stays as it
//! was read. The same text and the same question give the same findings, however many threads
//! there are.
//!
//! **Why this way:** a command line, an editor and a notebook want the same things in another order. What they share is here;
//! what is left to them is where the text comes from and how findings are shown.

use std::sync::Arc;

use crate::ask::{Ask, Unknown};
use crate::check::family::{Join, Part, Row};
use crate::check::search::SearchOptions;
use crate::check::{
    self, Account, Cache, Cancel, CheckError, ClaimAccount, IdentityAccount, Limits, Options, Outcome, Proposition,
    Recalled, Store, Witness,
};
use crate::derivation::{Claim, Derivation, is_called, parse};
use crate::diag::escape::shown;
use crate::diag::{Diagnostic, Source};
use crate::findings::search::SearchAccount;
use crate::latex::Logarithm;
use crate::reason::Reason;
use crate::report;
use crate::verdict::Residuals;
use meter::{Ended, Task};

/// Where diagnostics place a problem with the scope of a [`Question`].
const SCOPE: &str = "scope";

/// A derivation that was read, and what is known of it.
#[derive(Debug)]
pub struct Session {
    name: String,
    /// Shared with what was found: it is the largest part of a large file.
    derivation: Arc<Derivation>,
    cache: Cache,
}

/// An equation that is to be decided for all values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Question {
    /// The equation, and what is given.
    pub proposition: Proposition,
    /// Symbols beside those of the file: `NAMES`, `NAMES: WORDS`, `NAME = FORMULA` or `NAME: WORDS = FORMULA`.
    pub symbols: Vec<String>,
    /// A claim of the file whose own symbols are known, too.
    pub scope: Option<String>,
}

/// What was decided of a [`Question`].
#[derive(Clone, Debug)]
pub struct Answer {
    proposition: Proposition,
    account: IdentityAccount,
    scope: latex::Scope,
}

/// Why nothing was found.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// The text has problems, each with its place.
    Problems(Vec<Diagnostic>),
    /// The question names a claim or a trajectory that is not there.
    Unknown(Unknown),
    /// Parts of a family that cannot be joined: which, and why, in a sentence.
    Parts(String),
    /// The flag of [`Limits`] was raised.
    Cancelled,
    /// The program contradicts itself: a defect to be reported.
    Defect(String),
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Failure::Problems(found) => f.write_str(&crate::diag::render(found, false)),
            Failure::Unknown(name) => name.fmt(f),
            Failure::Parts(why) => f.write_str(why),
            Failure::Cancelled => f.write_str("the run was cancelled"),
            Failure::Defect(what) => write!(f, "a defect of this program: {what}"),
        }
    }
}

impl std::error::Error for Failure {}

impl From<Unknown> for Failure {
    fn from(unknown: Unknown) -> Failure {
        Failure::Unknown(unknown)
    }
}

impl Failure {
    /// The same, where symbols are declared otherwise than in a file: `hint` says how.
    pub fn where_symbols_are_declared(mut self, hint: &str) -> Failure {
        let Failure::Problems(found) = &mut self else { return self };
        for problem in found.iter_mut().filter(|d| d.code == "latex::unknown-symbol") {
            let other = problem.hint.take().filter(|h| !h.contains("[symbols]"));
            problem.hint = Some(other.unwrap_or_else(|| hint.to_owned()));
        }
        self
    }
}

impl From<Box<Diagnostic>> for Failure {
    fn from(found: Box<Diagnostic>) -> Failure {
        Failure::Problems(vec![*found])
    }
}

impl From<Vec<Diagnostic>> for Failure {
    fn from(found: Vec<Diagnostic>) -> Failure {
        Failure::Problems(found)
    }
}

impl From<CheckError> for Failure {
    fn from(error: CheckError) -> Failure {
        match error {
            CheckError::Problems(found) => Failure::Problems(found),
            CheckError::Defect(what) => Failure::Defect(what),
        }
    }
}

/// A claim of a derivation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClaimName {
    /// Its id.
    pub id: String,
    /// Its reading, where it has several.
    pub reading: Option<String>,
    /// What it says, in the words of the file.
    pub says: String,
}

/// What was found of one claim on one motion, or over its ranges.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The claim.
    pub claim: ClaimName,
    /// Id of the trajectory; `None` for a family and for a claim over ranges.
    pub trajectory: Option<String>,
    /// Id of the family.
    pub family: Option<String>,
    /// The verdict, with its strength.
    pub outcome: Outcome,
    /// The word that the file expects, if it expects one.
    pub expected: Option<String>,
    /// Whether the verdict is as expected; without an expectation, whether the claim does not fail.
    pub is_expected: bool,
    /// Why, where the verdict has a reason.
    pub reason: Option<String>,
    /// A point that can be checked by hand, where there is one.
    pub witness: Option<Witness>,
}

impl ClaimName {
    fn of(claim: &Claim) -> ClaimName {
        ClaimName { id: claim.id.clone(), reading: claim.reading.clone(), says: claim.says.clone() }
    }
}

impl Session {
    /// Reads the text of a derivation file. `name` is shown in diagnostics, and is the id of the derivation unless its text
    /// gives another.
    ///
    /// # Errors
    /// Every problem of the text.
    ///
    /// ```
    /// let problems = rederive::Session::open("decay", "[derivation]\ntitle = 'Decay'").unwrap_err();
    /// assert_eq!(problems[0].code, "derivation::missing-key");
    /// assert_eq!(problems[0].line_and_column(), Some((1, 1)));
    /// ```
    pub fn open(name: &str, text: impl Into<String>) -> Result<Session, Vec<Diagnostic>> {
        Ok(Session { name: name.to_owned(), derivation: Arc::new(read(name, text.into())?), cache: Cache::default() })
    }

    /// A derivation that was read already, for instance by [`load`](crate::derivation::load).
    pub fn of(derivation: Derivation) -> Session {
        Session { name: derivation.id.clone(), derivation: Arc::new(derivation), cache: Cache::default() }
    }

    /// A session without a file, for [`prove`](Session::prove). Unless it is declared, i is the imaginary unit.
    pub fn blank() -> Session {
        let mut blank = Derivation::blank();
        // What is not declared here is not declared elsewhere.
        blank.scope.set_imaginary();
        Session::of(blank)
    }

    /// The same, where `\log` is this logarithm, whatever the file says.
    #[must_use]
    pub fn with_logarithm(mut self, logarithm: Logarithm) -> Session {
        Arc::make_mut(&mut self.derivation).scope.set_logarithm(logarithm);
        self
    }

    /// The same derivation, where `\log` is this logarithm.
    pub(crate) fn with_base(&self, base: Logarithm) -> Session {
        Session::of(Derivation::clone(&self.derivation)).with_logarithm(base)
    }

    /// The derivation, as it was read.
    pub fn derivation(&self) -> &Derivation {
        &self.derivation
    }

    /// The claims, in the order of the file.
    pub fn claims(&self) -> Vec<ClaimName> {
        self.derivation.claims.iter().map(ClaimName::of).collect()
    }

    /// Whether a recorded proof proves just what the claim of its name asks: the sequents are written anew, and compared.
    pub fn asks_for(&self, of: &report::RecordedClaim) -> bool {
        use tactics::May;
        // What it may presuppose was known to who searched, and is told with it.
        let may: &[May] = match of.proof.presupposed.is_empty() {
            true => &[May::EndWithAssumptions],
            false => &[May::Presuppose, May::EndWithAssumptions],
        };
        let (id, reading) = of.claim.split_once('/').map_or((of.claim.as_str(), None), |(id, own)| (id, Some(own)));
        let claim = self.derivation.claims.iter().find(|c| c.id == id && c.reading.as_deref() == reading);
        let asked = claim.and_then(|c| tactics::Asked::of(&self.derivation, c, may).ok());
        asked.is_some_and(|asked| asked.is_answered_by(&of.proof))
    }

    /// The claims, each with the ids of the trajectories and families that it is tried on.
    pub fn pairs(&self) -> Vec<(ClaimName, Vec<String>)> {
        let of = &self.derivation;
        let on = |c: &Claim| {
            let motions = c.trajectories.iter().map(|t| &of.trajectories[*t].id);
            let all = motions.chain(c.families.iter().map(|f| &of.families[*f].id));
            all.filter(|_| c.region.is_none()).cloned().collect()
        };
        of.claims.iter().map(|c| (ClaimName::of(c), on(c))).collect()
    }

    /// Finds what is asked. `progress` is told how many of how many motions are done; it may be called by any thread.
    ///
    /// # Errors
    /// A name that is not there; problems that only show when motions are built; the flag of the limits was raised.
    ///
    /// ```
    /// # let text = "[derivation]\ntitle='x'\nconcerns='y'\n[symbols]\n't'={role='time'}\n'x'={role='state'}\n\
    /// # [system.s]\nstates=['x']\nequations=['\\dot x=1']\n[[trajectory]]\nid='a'\nsystem='s'\ninitial={'x'=0}\nspan=[0,1]\n\
    /// # [[claim]]\nid='c'\nsays='z'\nalways=['x=t']";
    /// use rederive::check::{Cancel, Limits};
    /// use rederive::{Ask, Failure, Session};
    ///
    /// let session = Session::open("rise.toml", text).expect("no problems");
    /// let flag = Cancel::default();
    /// let ask = Ask { limits: Limits { cancel: Some(flag.clone()), ..Limits::default() }, ..Ask::default() };
    /// assert!(session.check(&ask, &|_, _| {}).is_ok());
    /// flag.raise(); // by another thread, or by `progress`
    /// assert!(matches!(session.check(&ask, &|_, _| {}), Err(Failure::Cancelled)));
    /// ```
    pub fn check(&self, ask: &Ask, progress: &(dyn Fn(usize, usize) + Sync)) -> Result<Findings, Failure> {
        self.find(ask, None, progress)
    }

    /// The same, with what earlier checks of the file left in a store, also in other processes: the findings do not depend on it. The
    /// whole file is recorded; where only a part is asked for, nothing is read or kept.
    ///
    /// # Errors
    /// As for [`check`](Session::check).
    pub fn check_recorded(
        &self,
        ask: &Ask,
        store: &dyn Store,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Findings, Failure> {
        self.find(ask, Some(store), progress)
    }

    fn find(
        &self,
        ask: &Ask,
        store: Option<&dyn Store>,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Findings, Failure> {
        ask.check_names(std::iter::once(&*self.derivation))?;
        let limits = ask.limits.of_file(self.derivation.work);
        let options = Options {
            claims: ask.claims.iter().map(|name| name.split('/').next().unwrap_or(name).to_owned()).collect(),
            trajectories: ask.trajectories.clone(),
            plain: ask.only_verdicts,
            rigor: ask.rigor,
            limits,
        };
        let found = meter::under(&ask.limits, || match store {
            Some(store) => check::check_recorded(&self.derivation, &options, store, progress),
            None => Ok((check::check(&self.derivation, &options, progress)?, Recalled::Nothing)),
        });
        // Whatever it says: it was not finished.
        if ask.limits.is_cancelled() {
            return Err(Failure::Cancelled);
        }
        let (mut account, recalled) = found.map_err(|ended| Failure::Defect(ended.to_string()))??;
        let is_asked = |c: &ClaimAccount| ask.claims.iter().any(|name| is_called(name, &c.id, c.reading.as_deref()));
        account.claims.retain(|c| ask.claims.is_empty() || is_asked(c));
        Ok(Findings { derivation: Arc::clone(&self.derivation), account, recalled })
    }

    /// Counts one part of the members of a family: the text of its file. `progress` is told how many of how many members are done.
    ///
    /// # Errors
    /// See [`sweep`](check::family::sweep).
    pub fn sweep(
        &self,
        family: &str,
        part: Part,
        limits: &Limits,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<String, Failure> {
        self.sweep_each(family, part, limits, progress, &mut |_| {})
    }

    /// The same; `each` is handed the line of every member ([`member_line`](report::member_line)), in the order of their numbers.
    ///
    /// # Errors
    /// As for [`Session::sweep`]; lines that were handed out are then those of a part that is not there.
    pub fn sweep_each(
        &self,
        family: &str,
        part: Part,
        limits: &Limits,
        progress: &(dyn Fn(usize, usize) + Sync),
        each: &mut dyn FnMut(&str),
    ) -> Result<String, Failure> {
        if let Some(family) = self.derivation.families.iter().find(|f| f.id == family) {
            each(&report::members_head(&self.derivation, family));
        }
        let mut row = |row: &Row| each(&report::member_line(row));
        let found = check::family::sweep(&self.derivation, family, part, limits, progress, &mut row);
        if limits.is_cancelled() {
            return Err(Failure::Cancelled);
        }
        Ok(report::part_text(&self.derivation, &found?))
    }

    /// Whether a text is that of a part, whole, of this file, counted by this version.
    pub fn has_part(&self, text: &str, family: &str, part: Part) -> bool {
        let mut found = Vec::new();
        let taken = report::read_parts(text, |swept| {
            let same = swept.version == env!("CARGO_PKG_VERSION") && swept.sha256 == self.derivation.sha256;
            found.push(same && swept.family == family && swept.part == part);
            Ok::<(), ()>(())
        });
        taken == Ok(Ok(())) && found == [true]
    }

    /// Joins the parts of a family, in any order: names of files for messages, and their texts, one in memory at a time; or why one
    /// cannot be had. What is found is what [`check`](Session::check) finds on the family, verdicts alone.
    ///
    /// # Errors
    /// A part that is missing, comes twice, is damaged, or is of another file, family, division or version.
    pub fn join(
        &self,
        texts: impl Iterator<Item = Result<(String, String), String>>,
        limits: &Limits,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Findings, Failure> {
        let mut join = Join::new(&self.derivation);
        for text in texts {
            let (name, text) = text.map_err(Failure::Parts)?;
            let told = |why: String| Failure::Parts(format!("`{name}`: {why}"));
            report::read_parts(&text, |part| join.add(part)).map_err(told)?.map_err(|fault| told(fault.to_string()))?;
        }
        let joined = join.finish().map_err(|fault| Failure::Parts(fault.to_string()))?;
        let found = check::check_joined(&self.derivation, &joined, limits, progress);
        if limits.is_cancelled() {
            return Err(Failure::Cancelled);
        }
        Ok(Findings { derivation: Arc::clone(&self.derivation), account: found?, recalled: Recalled::Nothing })
    }

    /// Decides an equation for all values of its symbols.
    ///
    /// # Errors
    /// Formulas, symbols and names that are not understood, with their places.
    ///
    /// ```
    /// use rederive::check::Proposition;
    /// use rederive::{Question, Session};
    ///
    /// let proposition = Proposition { formula: r"\sin 2x=2\sin x\cos x".into(), ..Proposition::default() };
    /// let question = Question { proposition, symbols: vec!["x".into()], scope: None };
    /// assert_eq!(Session::blank().prove(&question)?.standing(), "proved");
    /// # Ok::<(), rederive::Failure>(())
    /// ```
    pub fn prove(&self, question: &Question) -> Result<Answer, Failure> {
        self.decide(question).or_else(|why| self.in_either_base(question).filter(|_| why.is_of_base()).ok_or(why))
    }

    pub(crate) fn decide(&self, question: &Question) -> Result<Answer, Failure> {
        let mut derivation = Derivation::clone(&self.derivation);
        if let Some(claim) = &question.scope {
            check::with_symbols_of(&mut derivation, claim, SCOPE)?;
        }
        let numbered = question.symbols.iter().enumerate();
        let typed: Vec<_> =
            numbered.map(|(at, text)| (format!("symbol {}", at + 1), shown(text).into_owned())).collect();
        derivation.declare_typed(&typed)?;
        let asked = &question.proposition;
        let proposition = Proposition {
            formula: shown(&asked.formula).into_owned(),
            given: asked.given.iter().map(|text| shown(text).into_owned()).collect(),
            throughout: asked.throughout,
        };
        let found = meter::piece(Task::Proving, &meter::limits(), || check::prove(&mut derivation, &proposition));
        let account = match found {
            Ok(found) => found?,
            Err(Ended::Defect(what)) => return Err(Failure::Defect(what)),
            Err(ended) => IdentityAccount { reason: Some(ended.into()), ..IdentityAccount::default() },
        };
        Ok(Answer { proposition, account, scope: derivation.scope })
    }

    /// Searches for a motion on which a claim fails. `progress` is told how many of how many motions are tried.
    ///
    /// # Errors
    /// See [`search`](check::search::search).
    pub fn search(
        &self,
        options: &SearchOptions,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<SearchAccount, Failure> {
        Ok(check::search::search(&self.derivation, options, progress)?)
    }

    /// Takes another state of the same file. What was found of parts that are as before is not looked for again by
    /// [`check_again`](Session::check_again).
    ///
    /// # Errors
    /// Every problem of the text; the session then keeps the state before.
    pub fn change(&mut self, text: impl Into<String>) -> Result<(), Vec<Diagnostic>> {
        self.replace(read(&self.name, text.into())?);
        Ok(())
    }

    /// The same, with a state that was read already, for instance by [`load`](crate::derivation::load).
    pub fn replace(&mut self, derivation: Derivation) {
        self.derivation = Arc::new(derivation);
    }

    /// Checks all claims, and recalls what is known from earlier states of the file. The names of the claims for which
    /// something had to be found come with the findings; these are the same as those of [`check`](Session::check).
    ///
    /// # Errors
    /// As for [`check`](Session::check).
    pub fn check_again(&mut self) -> Result<(Findings, Vec<String>), Failure> {
        let (account, checked) = self.cache.check(&self.derivation, None)?;
        Ok((Findings { derivation: Arc::clone(&self.derivation), account, recalled: Recalled::Nothing }, checked))
    }

    /// The same, unless the flag is raised before the end: then everything that was known before is still known.
    ///
    /// # Errors
    /// As for [`check`](Session::check).
    pub fn check_again_until(&mut self, cancel: &Cancel) -> Result<(Findings, Vec<String>), Failure> {
        let limits = Limits { cancel: Some(cancel.clone()), ..Limits::default() };
        let found = meter::under(&limits, || self.cache.check(&self.derivation, Some(cancel)));
        if cancel.is_raised() {
            return Err(Failure::Cancelled);
        }
        let (account, checked) = found.map_err(|ended| Failure::Defect(ended.to_string()))??;
        Ok((Findings { derivation: Arc::clone(&self.derivation), account, recalled: Recalled::Nothing }, checked))
    }

    /// The same, with what earlier processes left in a store: a state of the file that was checked before is not checked again.
    ///
    /// # Errors
    /// As for [`check`](Session::check).
    pub fn check_again_recorded(&mut self, store: &dyn Store) -> Result<(Findings, Vec<String>), Failure> {
        let (account, checked) = check::check_again_recorded(&mut self.cache, &self.derivation, store)?;
        Ok((Findings { derivation: Arc::clone(&self.derivation), account, recalled: Recalled::Nothing }, checked))
    }
}

impl Answer {
    /// What was decided: `proved`, `proved except`, `proved unreplayed`, `refuted` or `undecided`.
    pub fn standing(&self) -> &'static str {
        self.account.standing()
    }

    /// The equation, and what is given, as they were understood.
    pub fn proposition(&self) -> &Proposition {
        &self.proposition
    }

    /// Everything that was found, for the functions of [`report`].
    pub fn account(&self) -> &IdentityAccount {
        &self.account
    }

    /// The answer for a person; with `certificate`, followed by the exact proof as a program. `colour`: with escape codes.
    pub fn text(&self, certificate: bool, colour: bool) -> String {
        report::proposition_text(&self.proposition, &self.account, certificate, colour)
    }

    /// The answer as JSON.
    pub fn json(&self) -> String {
        report::proposition_json(&self.proposition, &self.account)
    }

    /// The same, with something that is to be said of it.
    pub(crate) fn with_remark(mut self, remark: &str) -> Answer {
        let before = self.account.reason.take().map(|reason| format!("{reason}; ")).unwrap_or_default();
        self.account.reason = Some(Reason::Quoted(format!("{before}{remark}").into()));
        self
    }

    /// The formula as MathML; `None` where it is not read.
    pub fn mathml(&self) -> Option<String> {
        report::formula_mathml(&self.proposition.formula, &self.scope)
    }
}

fn read(name: &str, text: String) -> Result<Derivation, Vec<Diagnostic>> {
    let stem = name.rsplit(['/', '\\']).next().unwrap_or(name).trim_end_matches(".toml");
    parse(Source { path: name.to_owned(), text }, stem)
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Findings {
    derivation: Arc<Derivation>,
    account: Account,
    recalled: Recalled,
}

impl Findings {
    /// The share of it that earlier runs had found; no document says so, since all of them are the same whether something is recalled or not.
    pub fn recalled(&self) -> Recalled {
        self.recalled
    }

    /// One entry for each claim on each motion and on each family, and for each claim over ranges, in the order of the file.
    pub fn all(&self) -> Vec<Finding> {
        let of = |c: &ClaimAccount| -> Vec<Finding> {
            let claim = ClaimName { id: c.id.clone(), reading: c.reading.clone(), says: c.says.clone() };
            let one = |judged: check::Judged<'_>| Finding {
                claim: claim.clone(),
                trajectory: judged.trajectory.map(str::to_owned),
                family: judged.family.map(|f| f.family.clone()),
                outcome: judged.verdict.outcome(),
                expected: judged.expected.map(str::to_owned),
                is_expected: !judged.unexpected,
                reason: judged.verdict.evidence().reason.as_ref().map(ToString::to_string),
                witness: judged.verdict.evidence().witness.clone(),
            };
            c.verdicts().map(one).collect()
        };
        self.account.claims.iter().flat_map(of).collect()
    }

    /// How the verdicts on a claim, `id` or `id/reading`, came about, on some trajectories and families, on all where none are named;
    /// `None` where there are none. `colour`: with escape codes.
    pub fn explanation(&self, claim: &str, on: &[String], colour: bool) -> Option<String> {
        let mut of = self.account.claims.iter().filter(|c| is_called(claim, &c.id, c.reading.as_deref()));
        let is_on = |j: check::Judged<'_>| {
            let name = j.trajectory.or(j.family.map(|f| f.family.as_str()));
            on.is_empty() || name.is_none_or(|name| on.iter().any(|of| of == name))
        };
        let stands_alone = |c: &ClaimAccount| c.alone.is_some() && c.identity.is_some();
        of.any(|c| c.verdicts().any(is_on) || on.is_empty() && stands_alone(c))
            .then(|| report::explain(&self.derivation, &self.account, &[claim.to_owned()], on, colour))
    }

    /// Whether every verdict is as the file expects.
    pub fn is_expected(&self) -> bool {
        self.account.summary().unexpected == 0
    }

    /// Both sides of the deciding comparison along a motion, thinned; `None` where none was made at times.
    pub fn curve(&self, claim: &str, reading: Option<&str>, trajectory: &str) -> Option<&Residuals> {
        let of = self.account.claims.iter().find(|c| c.id == claim && c.reading.as_deref() == reading)?;
        let pair = of.on(trajectory)?;
        pair.verdict.evidence().series.as_deref()
    }

    /// Everything that was found, for the functions of [`report`].
    pub fn account(&self) -> &Account {
        &self.account
    }

    /// The derivation that it is of.
    pub fn derivation(&self) -> &Derivation {
        &self.derivation
    }

    /// The document `report.json`: the contract of `docs/schema.md`.
    pub fn json(&self) -> String {
        report::json(&self.derivation, &self.account)
    }

    /// The page for a browser, in one file.
    pub fn page(&self) -> String {
        report::page(&self.derivation, &self.account)
    }

    /// The report in Markdown.
    pub fn markdown(&self) -> String {
        report::markdown(&self.derivation, &self.account)
    }

    /// The report as LaTeX source.
    pub fn latex(&self) -> String {
        report::tex(&self.derivation, &self.account)
    }
}
