//! `rederive completions`.

use rederive::Ending;

use super::ending::{Stop, print};

#[derive(clap::Args)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

pub fn completions(arguments: &CompletionsArguments, mut command: clap::Command) -> Result<Ending, Stop> {
    let mut out = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, env!("CARGO_PKG_NAME"), &mut out);
    print(&String::from_utf8_lossy(&out))?;
    Ok(Ending::Good)
}
