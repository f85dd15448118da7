//! One part of a family.
//!
//! **In:** a derivation as it was read, a family of it, and which part. **Out:** what was counted of each claim. **Guaranteed:** a part
//! has every number of it, or there is none: a sweep that a limit ends finds nothing. The limits of a file hold for a part.

use super::budget::{Budget, MOST_MEMBERS};
use super::ensemble::Ensemble;
use super::of_file::{Families, measured};
use crate::derivation::{Claim, Derivation, Measure};
use crate::diag::Diagnostic;
use crate::findings::family::{Part, Row, Swept, SweptClaim, SweptMeasure};
use claim::error::CheckError;
use claim::limits::Limits;
use claim::options::Options;

/// Tries the members of a part: those claims of the file that name the family. `progress` is told how many of how many numbers are
/// done; `each` is handed every member, in the order of their numbers, also of a part that is not finished.
///
/// # Errors
/// There is no such family, no claim is tried on it, it has fewer members than there are parts; its members cannot be made; the part
/// takes more than a part may; the run was cancelled.
pub fn sweep(
    derivation: &Derivation,
    family: &str,
    part: Part,
    limits: &Limits,
    progress: &(dyn Fn(usize, usize) + Sync),
    each: &mut dyn FnMut(&Row),
) -> Result<Swept, CheckError> {
    let options = Options { trajectories: vec![family.to_owned()], limits: limits.clone(), ..Options::default() };
    let refused = |code: &'static str, message: String, hint: String| {
        let file = &derivation.file;
        let diagnostic = match derivation.families.iter().find(|f| f.id == family) {
            Some(family) => Diagnostic::at(file, code, family.span.clone(), message),
            None => Diagnostic::of_file(&file.path, code, message),
        };
        CheckError::Problems(vec![diagnostic.hint(hint)])
    };
    let Some(at) = derivation.families.iter().position(|f| f.id == family) else {
        let ids: Vec<&str> = derivation.families.iter().map(|f| f.id.as_str()).collect();
        let hint = if ids.is_empty() { "it has none".to_owned() } else { format!("it has {}", ids.join(", ")) };
        return Err(refused("sweep::no-family", format!("there is no family `{family}`"), hint));
    };
    let asked: Vec<&Claim> = derivation.claims.iter().filter(|c| c.families.contains(&at)).collect();
    let measures = measured(derivation, at, &options);
    let families = Families::of(derivation, &options)?;
    let members = families.as_ref().and_then(|f| f.members[at].as_ref());
    let (Some(families), Some(members)) = (&families, members) else {
        let message = format!("no claim is tried on the family `{family}`, and nothing is measured on it");
        return Err(refused(
            "sweep::no-family",
            message,
            format!("add families = [\"{family}\"] to a claim or a measure"),
        ));
    };
    let size = members.family.size();
    let Some(numbers) = part.numbers(size) else {
        let message =
            format!("the family `{family}` has {size} members, which are not divided into {} parts", part.of());
        return Err(refused("sweep::no-part", message, format!("take at most {size} parts")));
    };
    let many = numbers.end() - numbers.start() + 1;
    if many > MOST_MEMBERS {
        let message = format!("work limit: a part has at most {MOST_MEMBERS} members, and this one has {many}");
        let hint = format!("take at least {} parts", size.div_ceil(MOST_MEMBERS));
        return Err(refused("sweep::too-large", message, hint));
    }
    let ensemble = Ensemble::new(&families.derivation, members, &asked, &measures, &options.limits)?;
    let (sums, stopped) = ensemble.try_all(numbers, &options, &mut Budget::default(), progress, each)?;
    if let Some(stopped) = stopped {
        let message = format!("part {part} of the family `{family}` was not finished: {stopped}");
        return Err(refused("sweep::too-large", message, "take more parts".to_owned()));
    }
    let one = |(claim, tally): (&&Claim, _)| SweptClaim { id: claim.id.clone(), reading: claim.reading.clone(), tally };
    let measure = |(m, distribution): (&&Measure, _)| SweptMeasure { id: m.id.clone(), distribution };
    Ok(Swept {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        sha256: derivation.sha256.clone(),
        family: family.to_owned(),
        part,
        claims: asked.iter().zip(sums.tallies).map(one).collect(),
        measures: measures.iter().zip(sums.distributions).map(measure).collect(),
    })
}
