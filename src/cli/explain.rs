//! `rederive explain`.

use std::path::PathBuf;

use rederive::check::ClaimAccount;
use rederive::{Ask, report};

use super::arguments::RigorArgument;
use super::ending::{Exit, Stop, say};
use super::{files, progress};

/// The id in `id/reading`.
fn id_of(name: &str) -> &str {
    name.split('/').next().unwrap_or(name)
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
        let with_premises = session.derivation().with_premises(&claims);
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
