//! `rederive completions`.

use clap::CommandFactory;

use super::{Arguments, CompletionsArguments, Exit, Stop, print};

pub fn completions(arguments: &CompletionsArguments) -> Result<Exit, Stop> {
    let mut out = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), env!("CARGO_PKG_NAME"), &mut out);
    print(&String::from_utf8_lossy(&out))?;
    Ok(Exit::Good)
}
