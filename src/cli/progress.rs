//! How far a run is: a bar to who watches, on standard error.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rederive::files::records::Records;
use rederive::{Ask, Failure, Findings, Session};

/// After this time a check says what it does.
const PATIENCE: Duration = Duration::from_millis(400);
/// How often it shows that it goes on.
const TICK: Duration = Duration::from_millis(200);

/// A bar with a name; where nobody watches, it is never drawn.
pub fn bar(name: &str, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(0).with_style(style).with_prefix(name.to_owned())
}

/// Does what counts how much of it is done, with a bar that shows so.
pub fn counted<T>(bar: &ProgressBar, work: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T) -> T {
    let found = work(&|done, of| {
        bar.set_length(of as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    found
}

/// Checks a derivation, with a bar if it takes long; `store` has what earlier runs left.
///
/// # Errors
/// See [`Session::check`].
pub fn check(session: &Session, ask: &Ask, store: Option<&Records>) -> Result<Findings, Failure> {
    let bar = bar(&session.derivation().id, "{spinner} {prefix}: {msg}  {wide_bar}  {pos}/{len}");
    if !bar.is_hidden() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
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
    counted(&bar, |count| {
        let progress = |done: usize, of: usize| {
            count(done, of);
            bar.set_message(if done < of {
                "claims are tried on motions"
            } else {
                "proofs, enclosures, altered formulas"
            });
        };
        match store {
            Some(store) => session.check_recorded(ask, store, &progress),
            None => session.check(ask, &progress),
        }
    })
}
