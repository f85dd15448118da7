//! Two routes to one answer: random evaluation, and exact polynomials.
//!
//! **In:** a question, and the answer of the random test. **Out:** [`IdentityEvidence`]: what the answer rests on, in words and
//! numbers for reports; among it certificates, where they exist.
//!
//! **Guaranteed:** the two routes do not contradict each other. A certificate for something that a real point refutes, an
//! exact normal form ≠ 0 of something that was proved, a proof that fails at a real point: each is a defect of the program,
//! and no verdict is given.

use crate::expr::{Expr, Graph, Leaf};
use findings::{Counterexample, IdentityEvidence, Place, Trials};
use proof::{
    Branching, Certificate, Condition, Effort, Identity, NoCertificate, Options, Point, PointValue, Premises, Proof,
    Reason, Refutation, Side, branches_test, by_domain, certify, identity_test,
};
use reason::SignsProved;

/// A formula with ±: the leaf that stands for the sign, and what is claimed of it.
#[derive(Clone, Copy, Debug)]
pub struct Signs {
    pub leaf: Leaf,
    pub branching: Branching,
}

type Equations = Vec<(Expr, Expr)>;

/// Decides equations by both routes.
///
/// # Errors
/// A description of the contradiction, if the two routes disagree.
pub fn answer(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    premises: &Premises,
    signs: Option<Signs>,
) -> Result<(Identity, IdentityEvidence), String> {
    let options = Options::default();
    let Some(signs) = signs else {
        let identity = identity_test(graph, equations, premises, &options);
        let evidence = evidence(graph, equations, premises, &identity)?;
        return Ok((reach(identity, &evidence), evidence));
    };
    let with = |graph: &mut Graph, value: i64| -> Equations {
        let mut put = |e| graph.rewrite(e, |g, l| (l == signs.leaf).then(|| g.integer(value)));
        equations.iter().map(|&(l, r)| (put(l), put(r))).collect()
    };
    let branches = [with(graph, 1), with(graph, -1)];
    let found = branches_test(graph, &branches, premises, &options);
    let signs_proved = signs_proved(&found.throughout, &found.pointwise);
    let (identity, branch) = found.told(signs.branching);
    let asked = match branch {
        Some(branch) => branches.into_iter().nth(branch),
        None => product(graph, &branches),
    };
    let mut evidence = match asked {
        Some(asked) => evidence(graph, &asked, premises, &identity)?,
        None => IdentityEvidence::default(),
    };
    let identity = reach(identity, &evidence);
    evidence.branch = signs_proved;
    Ok((identity, evidence))
}

/// The identity as far as the evidence reaches: a certificate holds wherever the premises do and the formulas have a value, also
/// where something vanishes that the first route divided by.
pub fn reach(mut identity: Identity, evidence: &IdentityEvidence) -> Identity {
    let certified = !evidence.certificates.is_empty();
    if let Identity::Proved(proof) = &mut identity
        && certified
        && evidence.certificates.iter().all(|c| c.divided_by.is_empty())
    {
        proof.conditions.retain(|c| !matches!(c, Condition::Pivot(_)));
    }
    identity
}

fn signs_proved(throughout: &[Identity], pointwise: &Identity) -> Option<SignsProved> {
    let proved = |i: Option<&Identity>| matches!(i, Some(Identity::Proved(_)));
    match (proved(throughout.first()), proved(throughout.get(1))) {
        (true, true) => Some(SignsProved::Either),
        (true, false) => Some(SignsProved::Upper),
        (false, true) => Some(SignsProved::Lower),
        (false, false) if proved(Some(pointwise)) => Some(SignsProved::PointByPoint),
        (false, false) => None,
    }
}

/// "One branch or the other" as equations: every product of a residual of the first and one of the second is 0.
fn product(graph: &mut Graph, [upper, lower]: &[Equations; 2]) -> Option<Equations> {
    if upper.len() * lower.len() > 256 {
        return None;
    }
    let zero = graph.integer(0);
    let mut out = Vec::new();
    for &(l, r) in upper {
        for &(m, n) in lower {
            let (one, other) = (graph.sub(l, r), graph.sub(m, n));
            out.push((graph.mul(one, other), zero));
        }
    }
    Some(out)
}

/// What an answer says by itself, without the second route.
///
/// # Errors
/// A description of the contradiction, if the first route contradicts itself.
pub fn evidence_of(graph: &Graph, identity: &Identity) -> Result<IdentityEvidence, String> {
    if let Identity::Undecided(Reason::Defect(what)) = identity {
        return Err(format!("two computations of one identity disagree: {what}"));
    }
    let mut out = IdentityEvidence { contradiction: is_contradiction(identity), ..IdentityEvidence::default() };
    match identity {
        Identity::Proved(proof) => out.trials = (!proof.is_certain()).then(|| trials(proof)),
        Identity::Refuted(refutation) => out.counterexample = Some(counterexample(graph, refutation)),
        Identity::Undecided(_) => {}
    }
    Ok(out)
}

/// Runs the second route, and says what the answer rests on.
///
/// # Errors
/// A description of the contradiction, if the two routes disagree.
pub fn evidence(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    premises: &Premises,
    identity: &Identity,
) -> Result<IdentityEvidence, String> {
    let mut out = evidence_of(graph, identity)?;
    // From a contradiction everything has a certificate.
    if out.contradiction {
        return Ok(out);
    }
    let found = certificates(graph, equations, premises);
    agree(identity, &found)?;
    match found {
        Ok(certificates) => out.certificates = certificates,
        // What is refuted has none, and needs no reason.
        Err(reason) => {
            let needed = match identity {
                Identity::Proved(proof) => !proof.is_certain(),
                Identity::Refuted(_) => false,
                Identity::Undecided(_) => true,
            };
            out.no_certificate = needed.then(|| reason.to_string());
        }
    }
    Ok(out)
}

/// A certificate for each equation; those that have values at other points than others by themselves, as they are tested.
fn certificates(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    premises: &Premises,
) -> Result<Vec<Certificate>, NoCertificate> {
    let mut out: Vec<(usize, Certificate)> = Vec::new();
    for group in by_domain(graph, equations, premises) {
        let own: Equations = group.iter().map(|&number| equations[number]).collect();
        match certify(graph, &own, premises, Effort::QUICK) {
            Ok(found) => out.extend(group.into_iter().zip(found)),
            Err(NoCertificate::Refuted { equation }) => {
                return Err(NoCertificate::Refuted { equation: group[equation] });
            }
            Err(other) => return Err(other),
        }
    }
    out.sort_unstable_by_key(|(number, _)| *number);
    Ok(out.into_iter().map(|(_, certificate)| certificate).collect())
}

fn is_contradiction(identity: &Identity) -> bool {
    matches!(identity, Identity::Undecided(Reason::Contradiction))
}

/// Whether the answers of both routes can both be right.
///
/// # Errors
/// The contradiction, in words.
pub fn agree(identity: &Identity, found: &Result<Vec<Certificate>, NoCertificate>) -> Result<(), String> {
    match (identity, found) {
        (Identity::Refuted(refutation), Ok(_)) => Err(format!(
            "there is a certificate for an identity that a point refutes: left {}, right {}",
            side(&refutation.left),
            side(&refutation.right)
        )),
        // Equal wherever both sides have values, which may be nowhere: nothing is proved then.
        (Identity::Proved(proof), Err(NoCertificate::Refuted { equation })) if proof.example.is_some() => Err(format!(
            "equation {} was proved by random evaluation, but its exact normal form is not 0",
            equation + 1
        )),
        _ => Ok(()),
    }
}

fn trials(proof: &Proof) -> Trials {
    Trials {
        count: proof.trials,
        primes: proof.primes.clone(),
        degree: proof.degree_bound,
        height: proof.height_bound,
        signs: proof.signs,
        cases: proof.cases,
    }
}

fn side(side: &Side) -> String {
    side.exact.as_ref().map_or_else(|| side.decimal.to_string(), ToString::to_string)
}

fn counterexample(graph: &Graph, refutation: &Refutation) -> Counterexample {
    let place = |p: &Point, left: &Side, right: &Side| {
        let [point, beyond] = refutation.parted(p).map(|values| self::point(graph, &values));
        Place { left: side(left), right: side(right), point, beyond }
    };
    Counterexample {
        equation: refutation.equation,
        first: place(&refutation.point, &refutation.left, &refutation.right),
        second: refutation.second.as_ref().map(|(p, l, r)| place(p, l, r)),
    }
}

fn point(graph: &Graph, values: &[&(Leaf, PointValue)]) -> Vec<(String, String)> {
    let mut out = Vec::new();
    for (leaf, value) in values {
        let name = graph.leaf_latex(*leaf);
        match (&value.exact, &value.circle) {
            (Some(r), _) => out.push((name, r.to_string())),
            (None, Some((c, s))) => {
                out.push((format!(r"\cos {name}"), c.to_string()));
                out.push((format!(r"\sin {name}"), s.to_string()));
            }
            (None, None) => out.push((name, value.decimal.to_string())),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Shape;
    use proof::{Options, identity_test};

    /// x² = x·x, and x² = 2x.
    fn questions() -> (Graph, [(Expr, Expr); 2]) {
        let mut g = Graph::new();
        let x = g.declare("x", Shape::scalar(), false);
        let x = g.component(x, 0);
        let (square, two) = (g.powi(x, 2), g.integer(2));
        let (sum, twice) = (g.add(x, two), g.mul(two, x));
        let left = g.mul(sum, x);
        let right = g.add(square, twice);
        (g, [(left, right), (square, twice)])
    }

    #[test]
    #[cfg(feature = "certificates")]
    fn answers_that_contradict_each_other_are_a_defect() {
        let (mut g, [truth, falsehood]) = questions();
        let given = Premises::default();
        let mut ask = |equation| {
            let equations = [equation];
            let one = identity_test(&mut g, &equations, &given, &Options::default());
            let two = certify(&mut g, &equations, &given, Effort::QUICK);
            (one, two)
        };
        let (proved, certificate) = ask(truth);
        let (refuted, none) = ask(falsehood);
        assert!(matches!(proved, Identity::Proved(_)) && certificate.is_ok());
        assert!(matches!(refuted, Identity::Refuted(_)) && none == Err(NoCertificate::Refuted { equation: 0 }));
        assert!(agree(&proved, &certificate).is_ok() && agree(&refuted, &none).is_ok());
        assert!(agree(&proved, &none).is_err_and(|e| e.contains("normal form")));
        assert!(agree(&refuted, &certificate).is_err_and(|e| e.contains("a point refutes")));
        let defect = Identity::Undecided(Reason::Defect("1 = 2".into()));
        assert!(evidence(&mut g, &[truth], &given, &defect).is_err());
    }
}
