//! `rederive audit`.

use std::path::{Path, PathBuf};

use rederive::diag::escape::in_one_line;
use rederive::files::{self, Kind};
use rederive::report::{ProofFile, Provenance, RecordedClaim};
use rederive::{Ending, Format, Session, report};

use super::arguments::printed_as;
use super::ending::{Stop, print_json, say};
use super::files::{find, session};

/// Largest size of a proofs.json, in bytes.
const LARGEST_FILE: u64 = 256 << 20;

/// Where derivation files are, unless it is said; there need be none.
const DERIVATIONS: &str = "derivations";

#[derive(clap::Args)]
pub struct AuditArguments {
    /// A proofs.json, or a folder with reports
    #[arg(value_name = "REPORT", default_value = "reports")]
    paths: Vec<PathBuf>,
    /// The derivation file, or a folder that contains them: each sequent is compared with what the file asks, where it is still the file
    /// that the proofs were found for
    #[arg(long = "in", value_name = "FILE", default_value = DERIVATIONS)]
    derivations: PathBuf,
    /// How the audit is printed
    #[arg(long, value_parser = printed_as(&[Format::Text, Format::Json]), default_value = "text")]
    format: Format,
}

pub fn audit(arguments: &AuditArguments) -> Result<Ending, Stop> {
    let (mut ending, mut documents) = (Ending::Good, Vec::new());
    let files = match Path::new(DERIVATIONS) == arguments.derivations && !arguments.derivations.exists() {
        true => Vec::new(),
        false => find(std::slice::from_ref(&arguments.derivations))?,
    };
    for path in &arguments.paths {
        for (name, bytes) in proofs(path)? {
            let file = ProofFile::read(&bytes).map_err(|why| format!("{name}: {why}"))?;
            let session = asking(&files, &file);
            // Whoever names the file wants to know whether the proofs are of what it asks.
            if session.is_none() && arguments.derivations != Path::new(DERIVATIONS) {
                let (name, path) = (in_one_line(&name), arguments.derivations.display().to_string());
                eprintln!(
                    "{name}: the proofs are of another file, or of another state of it, than {}",
                    in_one_line(&path)
                );
                ending = Ending::Different;
            }
            let stated = |of: &RecordedClaim| match &session {
                Some(session) if session.asks_for(of) => Provenance::AsInFile,
                Some(_) => Provenance::Otherwise,
                None => Provenance::OnTrust,
            };
            let found = report::audit(&file, &stated);
            if !found.is_replayed() {
                ending = Ending::Different;
            }
            match arguments.format {
                Format::Json => documents.push(found.json()),
                _ => say(&found.text())?,
            }
        }
    }
    if arguments.format == Format::Json {
        print_json(&documents.into())?;
    }
    Ok(ending)
}

/// The derivation that proofs are of, if one of the files is still what it was.
fn asking(files: &[PathBuf], of: &ProofFile) -> Option<Session> {
    let mut named = files.iter().filter(|path| path.file_stem().is_some_and(|stem| stem == of.derivation.as_str()));
    named.find_map(|path| session(path).ok().filter(|s| s.derivation().sha256 == of.sha256))
}

/// The proofs that a path names: a file, or every `proofs.json` below a folder.
fn proofs(path: &Path) -> Result<Vec<(String, Vec<u8>)>, Stop> {
    let kind = Kind { what: report::PROOFS, is_one: |path| path.file_name().is_some_and(|n| n == report::PROOFS) };
    let read = |file: PathBuf| Ok((file.display().to_string(), files::read(&file, LARGEST_FILE)?));
    files::meant(&[path.to_owned()], kind)?.found.into_iter().map(read).collect()
}
