//! `rederive explain`.

use rederive::{Ask, Ending};

use super::arguments::{FileArguments, RigorArgument};
use super::ending::{Stop, say};
use super::progress;

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
    let ExplainArguments { claim, on, files, rigor } = arguments;
    let mut shown = false;
    for (session, asked) in files.sessions_with(claim, on)? {
        let ask = Ask { rigor: rigor.rigor, ..asked }.explaining(session.derivation());
        if let Some(text) = progress::check(&session, &ask, None)?.explanation(claim, true) {
            say(&text)?;
            shown = true;
        }
    }
    if shown { Ok(Ending::Good) } else { Err(format!("`{claim}` is not tried on this trajectory").into()) }
}
