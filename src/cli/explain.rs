//! `rederive explain`.

use rederive::check::Options;
use rederive::report;

use super::{Exit, ExplainArguments, Stop, check, files, say};

pub fn explain(arguments: &ExplainArguments) -> Result<Exit, Stop> {
    let claims = [arguments.claim.clone()];
    let mut derivations = files::load_all(&files::find(std::slice::from_ref(&arguments.path))?)?;
    files::known(&derivations, &claims, &arguments.on)?;
    derivations.retain(|d| files::concerns(d, &claims, &arguments.on));
    let mut shown = 0;
    for derivation in &mut derivations {
        let account = check::account(derivation, &claims, &arguments.on, &Options::default())?;
        shown += account.claims.iter().map(|c| c.verdicts().count()).sum::<usize>();
        say(&report::explain(derivation, &account, true))?;
    }
    if shown == 0 {
        return Err(Stop::Message(format!("`{}` is not tried on this trajectory", arguments.claim)));
    }
    Ok(Exit::Good)
}
