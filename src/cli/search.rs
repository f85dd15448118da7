//! `rederive search`.

use std::path::PathBuf;

use rederive::check::search::{Found, SearchAccount, SearchOptions};

use super::ending::{Exit, Stop, complain, say};
use super::{files, progress};

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
    /// Derivation file, or a folder that contains them
    #[arg(value_name = "FILE", default_value = "derivations")]
    path: PathBuf,
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

pub fn search(arguments: &SearchArguments) -> Result<Exit, Stop> {
    let claims = [arguments.claim.clone()];
    let sessions = files::load_all(&files::find(std::slice::from_ref(&arguments.path))?)?;
    let asked = files::asked(sessions, &claims, &[])?;
    let (claim, variant) = (arguments.claim.clone(), arguments.variant);
    let options = SearchOptions { claim, seed: arguments.seed, tries: arguments.tries, variant };
    let mut exit = Exit::Undecided;
    for (session, _) in &asked {
        let derivation = session.derivation();
        let bar = progress::bar(&derivation.id, "{prefix}  {wide_bar}  {pos}/{len}");
        bar.set_length(arguments.tries as u64);
        let account = session.search(&options, &|done, _| bar.set_position(done as u64));
        bar.finish_and_clear();
        let account = account?;
        say_known(&account);
        match &account.found {
            Some(found) => {
                say(&table(found, &options, account.variant.as_deref()))?;
                if found.listed {
                    complain(&format!("`{}` names its trajectories: add \"{}\" to them\n", found.claim, found.id));
                }
                exit = Exit::Good;
            }
            None => {
                let what = account.variant.as_ref().map_or(options.claim.clone(), |formula| in_one_line(formula));
                complain(&format!("{}: no motion was found on which `{what}` fails\n", derivation.id));
            }
        }
        say_tally(&account);
    }
    Ok(exit)
}

/// Where the claim fails already.
fn say_known(account: &SearchAccount) {
    if let Some(first) = account.known.first() {
        let more = account.known.len() - 1;
        let others = if more > 0 { format!(" and {more} more trajectories") } else { String::new() };
        let what = if account.variant.is_some() { "the altered formula" } else { "the claim" };
        complain(&format!("{what} fails already on {first}{others} of the file\n"));
    }
}

fn say_tally(account: &SearchAccount) {
    let t = account.tally;
    let tried = t.holds + t.fails + t.not_applicable + t.undecided + t.impossible;
    complain(&format!(
        "{tried} tried: {} holds on {}, fails on {}, does not apply to {}, is undecided on {}; {} are no motions\n",
        if account.variant.is_some() { "the altered formula" } else { "the claim" },
        t.holds,
        t.fails,
        t.not_applicable,
        t.undecided,
        t.impossible
    ));
}

/// The table with what it shows, as comments.
fn table(found: &Found, options: &SearchOptions, variant: Option<&str>) -> String {
    let fails = match variant {
        Some(formula) => {
            format!("`{}` holds here, and would not hold as\n# {}\n# It was", found.claim, in_one_line(formula))
        }
        None => format!("`{}` fails here;", found.claim),
    };
    let mut out =
        format!("\n# {fails} found with seed {}, try {}, from `{}`.\n", options.seed, found.number, found.from);
    if let Some(w) = &found.verdict.evidence().witness {
        let formula = in_one_line(&w.formula);
        out.push_str(&format!(
            "# At t = {}: {formula}: {} and {}, error bound {:.1e}.\n",
            w.t, w.left, w.right, w.bound
        ));
    }
    out.push_str(&found.table);
    out
}

fn in_one_line(formula: &str) -> String {
    formula.split_whitespace().collect::<Vec<_>>().join(" ")
}
