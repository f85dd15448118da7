//! `rederive explain`.

use rederive::{Ask, Ending};

use super::arguments::{FileArguments, RigorArgument};
use super::ending::{Stop, say};
use super::progress;
use super::records::RecordArguments;

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
    #[command(flatten)]
    records: RecordArguments,
}

pub fn explain(arguments: &ExplainArguments) -> Result<Ending, Stop> {
    let ExplainArguments { claim, on, files, rigor, records } = arguments;
    let mut shown = false;
    let store = records.store();
    // What is explained is what `check` says, and it is what `check` may have left.
    let ask = Ask { rigor: rigor.rigor, ..Ask::default() };
    for (session, _) in files.sessions_with(claim, on)? {
        let found = progress::check(&session, &ask, store.as_ref())?;
        if let Some(text) = found.explanation(claim, on, true) {
            say(&text)?;
            shown = true;
        }
    }
    if shown { Ok(Ending::Good) } else { Err(format!("`{claim}` is not tried on this motion").into()) }
}
