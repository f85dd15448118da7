//! The program `rederive`; see [`rederive`] for what it does, and `rederive --help` for how to use it.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
