//! `rederive explain`.

use rederive::check::{ClaimAccount, Options};
use rederive::derivation::Derivation;
use rederive::report;

use super::{Exit, ExplainArguments, Stop, check, files, say};

/// The id in `id/reading`.
fn id_of(name: &str) -> &str {
    name.split('/').next().unwrap_or(name)
}

/// The claims, then all from which they are said to follow, through all steps: a proof is worth what these are.
fn premises(derivation: &Derivation, claims: &[String]) -> Vec<String> {
    let mut out = claims.to_vec();
    let mut at = 0;
    while let Some(name) = out.get(at).cloned() {
        at += 1;
        let of = derivation.claims.iter().filter(|c| c.name() == name || c.id == name);
        for premise in of.flat_map(|c| &c.follows_from) {
            let is_claim = derivation.claims.iter().any(|c| c.name() == *premise || c.id == *premise);
            if is_claim && !out.contains(premise) {
                out.push(premise.clone());
            }
        }
    }
    out
}

pub fn explain(arguments: &ExplainArguments) -> Result<Exit, Stop> {
    let claims = [arguments.claim.clone()];
    let mut derivations = files::load_all(&files::find(std::slice::from_ref(&arguments.path))?)?;
    files::known(&derivations, &claims, &arguments.on)?;
    derivations.retain(|d| files::concerns(d, &claims, &arguments.on));
    let mut shown = 0;
    for derivation in &mut derivations {
        let with_premises = premises(derivation, &claims);
        let options = Options { rigor: arguments.rigor.into(), ..Options::default() };
        let account = check::account(derivation, &with_premises, &arguments.on, &options)?;
        let wanted = |c: &&ClaimAccount| c.id == id_of(&arguments.claim);
        shown += account.claims.iter().filter(wanted).map(|c| c.verdicts().count()).sum::<usize>();
        say(&report::explain(derivation, &account, &claims, true))?;
    }
    if shown == 0 {
        return Err(Stop::Message(format!("`{}` is not tried on this trajectory", arguments.claim)));
    }
    Ok(Exit::Good)
}
