//! `rederive prove`.

use std::path::PathBuf;
use std::sync::Arc;

use clap::ValueEnum;
use rederive::check::Proposition;
use rederive::check::standing::Decision;
use rederive::derivation::load;
use rederive::diag::{Diagnostic, Source};
use rederive::files::named;
use rederive::{Failure, Question, SCOPE, Session, report};

use super::ending::{Exit, Stop, print, say};

pub const AFTER_HELP: &str = r"Symbols: NAMES, NAMES: WORDS, NAME = FORMULA or NAME: WORDS = FORMULA. Words
are those of [symbols] in a derivation file: a role (parameter, which is so
unless given; state, observable, abbreviation, time, constant), a shape (3, 3x3,
diagonal 3), positive, complex. Where a state is declared, and no time, t is the
time. Unless it is declared, i is the imaginary unit.

  rederive prove '\sin 2x=2\sin x\cos x' --symbol x
  rederive prove '\sqrt{x^2}=x' --symbol x --given 'x>0'
  rederive prove '\frac12\dot q^2-\omega^2\cos q=C' --symbol 'q: state' \
      --symbol '\omega, C'
  rederive prove '\ell\dot q\ddot q=-g\dot q\sin q' \
      --in derivations/pendulum.toml --given pendulum

Exit codes:
  0   proved: no case is left out
  1   refuted
  2   the command line, a formula or a file could not be read
  3   undecided, also when what is given contradicts itself; or proved except
      in cases that are named
  70  a defect of rederive itself";

/// For which points a sign of ± must serve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Signs {
    /// At each point one sign or the other
    Pointwise,
    /// One sign for all points
    Throughout,
}

#[derive(clap::Args)]
pub struct ProveArguments {
    /// The equation, in LaTeX; several are separated by commas, and all must hold
    #[arg(allow_hyphen_values = true)]
    formula: String,
    /// A premise: a relation in LaTeX, or with --in the name of a claim or system; may be repeated
    #[arg(long, short, value_name = "FORMULA|NAME", allow_hyphen_values = true)]
    given: Vec<String>,
    /// Declares symbols, see below; may be repeated
    #[arg(long, short, value_name = "SYMBOL")]
    symbol: Vec<String>,
    /// A derivation file whose symbols are known
    #[arg(long = "in", value_name = "FILE")]
    file: Option<PathBuf>,
    /// A claim of this file whose own symbols are known, too
    #[arg(long, value_name = "CLAIM", requires = "file")]
    scope: Option<String>,
    /// What ± means
    #[arg(long, value_enum, default_value = "pointwise")]
    branches: Signs,
    /// Print the exact certificate, as a program for SymPy
    #[arg(long)]
    certificate: bool,
    /// What is printed
    #[arg(long, value_enum, default_value = "text")]
    format: Output,
}

/// How an answer is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Output {
    /// For people
    Text,
    /// As JSON
    Json,
}

pub fn prove(arguments: &ProveArguments) -> Result<Exit, Stop> {
    let session = match &arguments.file {
        Some(path) => Session::of(load(&named(path)?).map_err(Stop::Diagnostics)?),
        None => Session::blank(),
    };
    let proposition = Proposition {
        formula: arguments.formula.clone(),
        given: arguments.given.clone(),
        throughout: arguments.branches == Signs::Throughout,
    };
    let (symbols, scope) = (arguments.symbol.clone(), arguments.scope.clone());
    let answer = session.prove(&Question { proposition, symbols, scope }).map_err(|failure| match failure {
        Failure::Problems(found) => Stop::Diagnostics(found.into_iter().map(of_this_command).collect()),
        other => other.into(),
    })?;
    let text = match arguments.format {
        Output::Json => answer.json(),
        Output::Text => report::proposition_text(answer.proposition(), answer.account(), arguments.certificate, true),
    };
    match arguments.format {
        Output::Json => print(&text)?,
        Output::Text => say(&text)?,
    }
    Ok(match answer.account().finding.decision() {
        Decision::Proved => Exit::Good,
        Decision::Refuted => Exit::Different,
        Decision::ProvedExcept | Decision::Undecided => Exit::Undecided,
    })
}

/// On a command line a scope is an option, and symbols are declared otherwise than in a file.
fn of_this_command(mut diagnostic: Diagnostic) -> Diagnostic {
    if diagnostic.source.path == SCOPE {
        diagnostic.source = Arc::new(Source { path: "--scope".to_owned(), text: diagnostic.source.text.clone() });
    }
    if diagnostic.code != "latex::unknown-symbol" {
        return diagnostic;
    }
    let known = diagnostic.hint.clone().filter(|h| !h.contains("[symbols]"));
    diagnostic.hint(known.unwrap_or_else(|| "declare it with --symbol, or give a file that does with --in".to_owned()))
}
