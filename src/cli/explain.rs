//! `rederive explain`.

use std::path::PathBuf;

use rederive::check::ClaimAccount;
use rederive::derivation::Derivation;
use rederive::{Ask, report};

use super::arguments::RigorArgument;
use super::ending::{Exit, Stop, say};
use super::{files, progress};

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

#[derive(clap::Args)]
pub struct ExplainArguments {
    /// The claim: its id, or id/reading
    claim: String,
    /// Only on this trajectory; may be repeated
    #[arg(long, value_name = "TRAJECTORY")]
    on: Vec<String>,
    /// Derivation file, or a folder that contains them
    #[arg(value_name = "FILE", default_value = "derivations")]
    path: PathBuf,
    /// How much is asked of a verdict
    #[arg(long, value_enum, default_value = "enclosed")]
    rigor: RigorArgument,
}

pub fn explain(arguments: &ExplainArguments) -> Result<Exit, Stop> {
    let claims = [arguments.claim.clone()];
    let sessions = files::load_all(&files::find(std::slice::from_ref(&arguments.path))?)?;
    let mut shown = 0;
    for (session, asked) in files::asked(sessions, &claims, &arguments.on)? {
        let with_premises = premises(session.derivation(), &claims);
        let ask = Ask { claims: with_premises, rigor: arguments.rigor.into(), ..asked };
        let found = progress::check(&session, &ask, None)?;
        let wanted = |c: &&ClaimAccount| c.id == id_of(&arguments.claim);
        shown += found.account().claims.iter().filter(wanted).map(|c| c.verdicts().count()).sum::<usize>();
        say(&report::explain(found.derivation(), found.account(), &claims, true))?;
    }
    if shown == 0 {
        return Err(Stop::Message(format!("`{}` is not tried on this trajectory", arguments.claim)));
    }
    Ok(Exit::Good)
}
