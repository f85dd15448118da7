//! How far a run is: a bar to who watches, on standard error.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rederive::files::records::Records;
use rederive::{Ask, Failure, Findings, Session};

/// After this time a check says what it does.
const PATIENCE: Duration = Duration::from_millis(400);
/// How often it shows that it goes on.
const TICK: Duration = Duration::from_millis(200);

/// A bar with a name, drawn at once; where nobody watches, it is never drawn.
pub fn bar(name: &str, template: &str) -> ProgressBar {
    let bar = hidden(name, template);
    if std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::stderr());
    }
    bar
}

fn hidden(name: &str, template: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_prefix(name.to_owned());
    bar
}

/// Checks a derivation, with a bar if it takes long; `store` has what earlier runs left.
///
/// # Errors
/// See [`Session::check`].
pub fn check(session: &Session, ask: &Ask, store: Option<&Records>) -> Result<Findings, Failure> {
    let bar = hidden(&session.derivation().id, "{spinner} {prefix}: {msg}  {wide_bar}  {pos}/{len}");
    if std::io::stderr().is_terminal() {
        bar.set_message("motions are built");
        // What takes long says so by itself, also while nothing is done yet.
        let bar = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !bar.is_finished() {
                bar.set_draw_target(ProgressDrawTarget::stderr());
                bar.enable_steady_tick(TICK);
            }
        });
    }
    let progress = |done: usize, of: usize| {
        bar.set_length(of as u64);
        bar.set_position(done as u64);
        bar.set_message(if done < of { "claims are tried on motions" } else { "proofs, enclosures, altered formulas" });
    };
    let found = match store {
        Some(store) => session.check_recorded(ask, store, &progress),
        None => session.check(ask, &progress),
    };
    bar.finish_and_clear();
    found
}
