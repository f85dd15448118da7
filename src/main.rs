//! The program `rederive`; see [`rederive`] for what it does, and `rederive --help` for how to use it.

#![forbid(unsafe_code)]

use std::process::ExitCode;

/// Proofs and reports ask for many small pieces of memory: this allocator gives and takes them faster than the system's.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    ExitCode::from(rederive::cli::run(std::env::args_os()))
}
