//! What a claim denies: `never` R, `eventually` R and `l \\ne r` are made of the negation of equations.
//!
//! **In:** a text of a claim. **Out:** [`Denial`]: the part that denies, and the equations that it denies. **Guaranteed:** the part is true
//! at a time exactly where one of the equations is false there, and false where all of them are true. So what is shown of the equations is
//! shown of the part: there is no other rule for negations.

use crate::derivation::{Claim, Form, Written};
use crate::latex::{RelationKind, Statement};

/// A part of a claim that denies equations.
#[derive(Clone, Debug)]
pub struct Denial {
    /// Its position among the parts.
    pub part: usize,
    /// What it denies: equations without ± and without limits.
    pub equal: Written<Statement>,
    /// Whether the claim says that this part is false: that the equations are true at some time.
    pub happens: bool,
}

impl Denial {
    /// The claim that what is denied is always so: under the same assumptions, following from the same.
    pub fn positive(&self, claim: &Claim) -> Claim {
        Claim { forms: vec![Form::Always(self.equal.clone())], ..claim.clone() }
    }
}

/// The relations of a text that are denied, all of this kind, as equations; `None` for others, for limits, and for ±.
pub(crate) fn denied(
    w: &Written<Statement>,
    relations: &[crate::latex::Relation],
    kind: RelationKind,
) -> Option<Written<Statement>> {
    let plain = |r: &crate::latex::Relation| r.kind == kind && r.limit.is_none() && !r.has_branches;
    if relations.is_empty() || !relations.iter().all(plain) {
        return None;
    }
    let mut relations = relations.to_vec();
    relations.iter_mut().for_each(|r| r.kind = RelationKind::Equal);
    let value = Statement { relations, span: w.value.span.clone() };
    Some(Written { text: w.text.clone(), span: w.span.clone(), value })
}

/// Whether a claim denies something.
pub fn denies(claim: &Claim) -> bool {
    claim.forms.iter().any(|form| match form {
        Form::Never(_) | Form::Eventually(_) => true,
        Form::Always(w) => w.value.relations.iter().any(|r| r.kind == RelationKind::NotEqual && r.limit.is_none()),
        Form::FirstIntegral(_) | Form::Defined(_) | Form::Solves { .. } | Form::SameMotion { .. } => false,
        Form::Independent { .. } | Form::Exists { .. } | Form::Across(_) | Form::Unread { .. } => false,
    })
}

/// The same claim without what it denies; `None` where nothing else is said.
pub fn without_denials(claim: &Claim) -> Option<Claim> {
    let mut rest = claim.clone();
    rest.forms.retain_mut(|form| match form {
        Form::Never(_) | Form::Eventually(_) => false,
        Form::Always(w) => {
            w.value.relations.retain(|r| r.kind != RelationKind::NotEqual || r.limit.is_some());
            !w.value.relations.is_empty()
        }
        Form::FirstIntegral(_) | Form::Defined(_) | Form::Solves { .. } | Form::SameMotion { .. } => true,
        Form::Independent { .. } | Form::Exists { .. } | Form::Across(_) | Form::Unread { .. } => true,
    });
    (!rest.forms.is_empty()).then_some(rest)
}
