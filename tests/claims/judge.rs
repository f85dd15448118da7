//! What the program says of random claims, compared with what they are.

use crate::checked::said_by_prover;
use rederive::check::{CheckError, Options, Proposition, Rigor, check, prove};
use rederive::derivation::{Derivation, parse};
use rederive::diag::Source;

use super::claim::{Claim, Form, Scene, Statement, file};
use super::logic::Truth;
use super::term::{Motion, Term};
use super::truth::truth;

/// What the program said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Said {
    /// A verdict's word, its strength, and its reason.
    Verdict(String, String, String),
    /// The claim was not understood.
    Refused(String),
    /// The program contradicted itself.
    Defect(String),
}

impl Said {
    pub fn word(&self) -> &str {
        match self {
            Said::Verdict(word, ..) => word,
            Said::Refused(_) => "refused",
            Said::Defect(_) => "defect",
        }
    }

    /// Whether it contradicts the truth: `undecided` and a refusal say nothing, a defect is always wrong.
    pub fn is_wrong(&self, truth: &[Truth]) -> bool {
        match self.word() {
            "holds" => !truth.contains(&Truth::True),
            "fails" => !truth.contains(&Truth::False),
            "not-applicable" => !truth.contains(&Truth::Void),
            // Proved where something is void somewhere: true wherever it has a value.
            "proved" => !truth.contains(&Truth::True),
            "refuted" => !truth.contains(&Truth::False),
            "defect" => true,
            _ => false,
        }
    }
}

/// What the program says of each claim.
pub fn said(claims: &[&Claim]) -> Vec<Said> {
    let mut found: Vec<Option<Said>> = vec![None; claims.len()];
    let mut tried: Vec<(usize, &Claim)> = Vec::new();
    for (i, claim) in claims.iter().enumerate() {
        if claim.scene == Scene::All {
            found[i] = Some(proposition(claim));
        } else {
            tried.push((i, claim));
        }
    }
    together(&tried, &mut found);
    found.into_iter().map(|s| s.unwrap_or(Said::Refused("no verdict".to_owned()))).collect()
}

/// Tries claims in one file; those that cannot stand in one are tried by halves.
fn together(claims: &[(usize, &Claim)], found: &mut [Option<Said>]) {
    if claims.is_empty() {
        return;
    }
    let named: Vec<(String, &Claim)> = claims.iter().map(|(i, c)| (format!("c{i}"), *c)).collect();
    let text = file(&named);
    let source = Source { path: "random".to_owned(), text };
    let error = match parse(source, "random") {
        Err(problems) => Said::Refused(problems.first().map_or(String::new(), |p| p.message.clone())),
        Ok(derivation) => {
            let options = Options { plain: true, rigor: Rigor::Enclosed, ..Options::default() };
            match caught(|| check(&derivation, &options, &|_, _| {})) {
                Ok(account) => {
                    for ((i, _), (id, _)) in claims.iter().zip(&named) {
                        let judged = account.claims.iter().find(|c| c.id == *id);
                        let verdict = judged.and_then(|c| c.verdicts().next()).map(|j| {
                            let outcome = j.verdict.outcome();
                            let reason =
                                j.verdict.evidence().reason.as_ref().map(ToString::to_string).unwrap_or_default();
                            Said::Verdict(
                                outcome.word().to_owned(),
                                outcome.strength().unwrap_or("").to_owned(),
                                reason,
                            )
                        });
                        found[*i] = verdict;
                    }
                    return;
                }
                Err(CheckError::Problems(problems)) => {
                    Said::Refused(problems.first().map_or(String::new(), |p| p.message.clone()))
                }
                Err(CheckError::Defect(words)) => Said::Defect(words),
            }
        }
    };
    if let [(i, _)] = claims {
        found[*i] = Some(error);
        return;
    }
    let (first, second) = claims.split_at(claims.len() / 2);
    together(first, found);
    together(second, found);
}

/// A panic is a defect of one claim, not of the run.
fn caught<T>(f: impl FnOnce() -> Result<T, CheckError>) -> Result<T, CheckError> {
    let panic = |_| Err(CheckError::Defect("a panic".to_owned()));
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(f)).unwrap_or_else(panic)
}

/// A claim about all real numbers.
fn proposition(claim: &Claim) -> Said {
    let [Form::Always(texts)] = &claim.forms[..] else { return Said::Refused("no proposition".to_owned()) };
    let formula = texts.iter().flatten().map(Statement::latex).collect::<Vec<_>>().join(r",\quad ");
    let mut given = vec!["y=2".to_owned(), r"a=\frac{3}{2}".to_owned()];
    given.extend(claim.assuming.iter().flatten().map(Statement::latex));
    let mut derivation = Derivation::blank();
    let symbols: Vec<(String, String)> = ["x", "y", "a"].map(|s| (s.to_owned(), s.to_owned())).to_vec();
    if let Err(problems) = derivation.declare_typed(&symbols) {
        return Said::Refused(format!("{problems:?}"));
    }
    let proposition = Proposition { formula, given, throughout: claim.throughout };
    match caught(|| prove(&mut derivation, &proposition)) {
        Ok(account) => {
            let word = if said_by_prover(&account) == "proved except" { "except" } else { account.verdict() };
            Said::Verdict(word.to_owned(), String::new(), format!("{:?}", account.reason))
        }
        Err(CheckError::Problems(problems)) => {
            Said::Refused(problems.first().map_or(String::new(), |p| p.message.clone()))
        }
        Err(CheckError::Defect(words)) => Said::Defect(words),
    }
}

/// A short text by which a claim is known: FNV-1a of what is written in the file, and the scene.
pub fn key(claim: &Claim) -> String {
    let text = format!("{:?} {} {:?} {}", claim.scene, claim.span, claim.motion, claim.toml("c"));
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3));
    format!("{hash:016x}")
}

/// A wrong claim made as small as it stays wrong.
pub fn minimized(claim: &Claim) -> (Claim, Said, Vec<Truth>) {
    let look = |c: &Claim| -> Option<(Said, Vec<Truth>)> {
        let t = truth(c).ok()?;
        let s = said(&[c]).remove(0);
        s.is_wrong(&t).then_some((s, t))
    };
    let mut small = claim.clone();
    let mut known = look(&small);
    'again: loop {
        for smaller in reductions(&small) {
            if let Some(found) = look(&smaller) {
                small = smaller;
                known = Some(found);
                continue 'again;
            }
        }
        break;
    }
    let (said, truth) = known.unwrap_or((Said::Refused("not wrong by itself".to_owned()), Vec::new()));
    (small, said, truth)
}

/// Claims with a part less.
fn reductions(claim: &Claim) -> Vec<Claim> {
    let mut found = Vec::new();
    if claim.forms.len() > 1 {
        for i in 0..claim.forms.len() {
            let mut c = claim.clone();
            c.forms.remove(i);
            found.push(c);
        }
    }
    for i in 0..claim.assuming.len() {
        let mut c = claim.clone();
        c.assuming.remove(i);
        found.push(c);
        if claim.assuming[i].len() > 1 {
            for k in 0..claim.assuming[i].len() {
                let mut c = claim.clone();
                c.assuming[i].remove(k);
                found.push(c);
            }
        }
    }
    if claim.at.is_some() {
        found.push(Claim { at: None, ..claim.clone() });
    }
    if claim.throughout {
        found.push(Claim { throughout: false, ..claim.clone() });
    }
    if claim.motion != Motion::Forward {
        found.push(Claim { motion: Motion::Forward, ..claim.clone() });
    }
    if claim.scene == Scene::Derived {
        found.push(Claim { scene: Scene::Formula, ..claim.clone() });
    }
    for (i, form) in claim.forms.iter().enumerate() {
        if let Form::Always(texts) | Form::Never(texts) | Form::Eventually(texts) = form {
            let rebuilt = |t: Vec<Vec<Statement>>| match form {
                Form::Never(_) => Form::Never(t),
                Form::Eventually(_) => Form::Eventually(t),
                _ => Form::Always(t),
            };
            for k in 0..texts.len() {
                if texts.len() > 1 {
                    let mut t = texts.clone();
                    t.remove(k);
                    let mut c = claim.clone();
                    c.forms[i] = rebuilt(t);
                    found.push(c);
                }
                for j in 0..texts[k].len() {
                    if texts[k].len() > 1 {
                        let mut t = texts.clone();
                        t[k].remove(j);
                        let mut c = claim.clone();
                        c.forms[i] = rebuilt(t);
                        found.push(c);
                    }
                    if let Statement::Relation { sides, kinds, .. } = &texts[k][j] {
                        let scalar = super::claim::Shape::Scalar;
                        let mut simpler = Vec::new();
                        if kinds.len() == 2 {
                            for m in 0..2 {
                                let (s, kind) = (sides[m..m + 2].to_vec(), vec![kinds[m]]);
                                simpler.push(Statement::Relation { shape: scalar, sides: s, kinds: kind });
                            }
                        }
                        if kinds.len() == 1 && sides[0].len() > 1 {
                            for (l, r) in sides[0].iter().zip(&sides[1]) {
                                let s = vec![vec![l.clone()], vec![r.clone()]];
                                simpler.push(Statement::Relation { shape: scalar, sides: s, kinds: kinds.clone() });
                            }
                        }
                        for s in simpler {
                            let mut t = texts.clone();
                            t[k][j] = s;
                            let mut c = claim.clone();
                            c.forms[i] = rebuilt(t);
                            found.push(c);
                        }
                    }
                }
            }
        }
    }
    // Terms by their parts.
    for n in 0..count_terms(claim) {
        found.extend(replacements(claim, n));
    }
    found
}

fn count_terms(claim: &Claim) -> usize {
    let mut n = 0;
    claim.clone().for_each_term(&mut |_| n += 1);
    n
}

/// The claim with its n-th term replaced by smaller ones.
fn replacements(claim: &Claim, n: usize) -> Vec<Claim> {
    let mut options = Vec::new();
    let mut i = 0;
    claim.clone().for_each_term(&mut |t| {
        if i == n {
            options = smaller_terms(t);
        }
        i += 1;
    });
    let put = |option: Term| {
        let mut c = claim.clone();
        let mut i = 0;
        c.for_each_term(&mut |t| {
            if i == n {
                *t = option.clone();
            }
            i += 1;
        });
        c
    };
    options.into_iter().map(put).collect()
}

fn smaller_terms(term: &Term) -> Vec<Term> {
    let mut found: Vec<Term> = term.parts().into_iter().cloned().collect();
    // The same, with one part smaller.
    for (i, part) in term.parts().into_iter().enumerate() {
        for smaller in smaller_terms(part) {
            found.push(with_part(term, i, smaller));
        }
    }
    found
}

fn with_part(term: &Term, i: usize, part: Term) -> Term {
    let mut parts: Vec<Term> = term.parts().into_iter().cloned().collect();
    parts[i] = part;
    let mut parts = parts.into_iter().map(Box::new);
    let mut next = || parts.next().unwrap_or(Box::new(Term::X));
    match term {
        Term::Number(_) | Term::X | Term::Y | Term::A | Term::T | Term::U => term.clone(),
        Term::Neg(_) => Term::Neg(next()),
        Term::Power(_, n) => Term::Power(next(), *n),
        Term::Abs(_) => Term::Abs(next()),
        Term::Of(f, _) => Term::Of(*f, next()),
        Term::Rate(_) => Term::Rate(next()),
        Term::At(_, c) => Term::At(next(), c.clone()),
        Term::Signed(u, _) => Term::Signed(*u, next()),
        Term::Named(_) => Term::Named(next()),
        Term::Add(..) => Term::Add(next(), next()),
        Term::Sub(..) => Term::Sub(next(), next()),
        Term::Mul(..) => Term::Mul(next(), next()),
        Term::Div(..) => Term::Div(next(), next()),
    }
}

/// A number that is given from outside.
pub fn number_of(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(default)
}
