//! `rederive explain`.

use rederive::report;

use super::arguments::{FileArguments, RigorArgument};
use super::ending::{Stop, say};
use super::progress;
use rederive::{Ask, Ending};

#[derive(clap::Args)]
pub struct ExplainArguments {
    /// The claim: its id, or id/reading
    claim: String,
    /// Only on this trajectory; may be repeated
    #[arg(long, value_name = "TRAJECTORY")]
    on: Vec<String>,
    #[command(flatten)]
    files: FileArguments,
    #[command(flatten)]
    rigor: RigorArgument,
}

pub fn explain(arguments: &ExplainArguments) -> Result<Ending, Stop> {
    let claims = [arguments.claim.clone()];
    let mut shown = 0;
    for (session, asked) in arguments.files.sessions_with(&arguments.claim, &arguments.on)? {
        let with_premises = session.derivation().with_premises(&claims);
        let ask = Ask { claims: with_premises, rigor: arguments.rigor.rigor, ..asked };
        let found = progress::check(&session, &ask, None)?;
        let id = arguments.claim.split('/').next();
        let wanted = found.account().claims.iter().filter(|c| Some(c.id.as_str()) == id);
        shown += wanted.map(|c| c.verdicts().count()).sum::<usize>();
        say(&report::explain(found.derivation(), found.account(), &claims, true))?;
    }
    if shown == 0 {
        return Err(Stop::Message(format!("`{}` is not tried on this trajectory", arguments.claim)));
    }
    Ok(Ending::Good)
}
