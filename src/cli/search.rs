//! `rederive search`.

use rederive::check::search::SearchOptions;
use rederive::{Ending, report};

use super::arguments::FileArguments;
use super::ending::{Stop, complain, say};
use super::progress;

/// What the exit code of a search means.
pub const EXIT_CODES: &str = "\
Exit codes:
  0   a motion was found on which the claim, or its altered formula, fails; its
      table is on standard output
  2   the command line or a file could not be read
  3   none was found, which does not show that there is none
  70  a defect of rederive itself";

#[derive(clap::Args)]
pub struct SearchArguments {
    /// The claim: its id, for any of its readings, or id/reading
    claim: String,
    #[command(flatten)]
    files: FileArguments,
    /// The seed: the same seed finds the same motion
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// An altered formula of the claim, by its number in the report: the motion is one on which the claim holds and this fails
    #[arg(long, value_name = "N")]
    variant: Option<usize>,
    /// How many motions are tried at most
    #[arg(long, value_name = "N", default_value_t = 480)]
    tries: usize,
}

pub fn search(arguments: &SearchArguments) -> Result<Ending, Stop> {
    let &SearchArguments { ref claim, seed, variant, tries, .. } = arguments;
    let options = SearchOptions { claim: claim.clone(), seed, tries, variant };
    let mut ending = Ending::Undecided;
    for (session, _) in arguments.files.sessions_with(claim, &[])? {
        let id = &session.derivation().id;
        let bar = progress::bar(id, "{prefix}  {wide_bar}  {pos}/{len}");
        let account = progress::counted(&bar, |count| session.search(&options, count))?;
        if let Some(table) = report::search_table(&account) {
            say(&table)?;
            ending = Ending::Good;
        }
        report::search_notes(id, &account).iter().for_each(|note| complain(note));
    }
    Ok(ending)
}
