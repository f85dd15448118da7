//! `rederive prove`.

use std::path::PathBuf;

use clap::ArgAction;
use rederive::check::Proposition;
use rederive::{Ending, Failure, Format, Question, Session};

use super::arguments::{LimitArguments, LogarithmArgument, one_of, printed_as};
use super::ending::{Stop, print, say};
use super::files::session;

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
    #[arg(long = "branches", action = ArgAction::Set, value_parser = one_of([
        ("pointwise", "At each point one sign or the other", false),
        ("throughout", "One sign for all points", true),
    ]), default_value = "pointwise")]
    throughout: bool,
    /// Print the exact certificate, as a program for SymPy
    #[arg(long)]
    certificate: bool,
    /// What is printed
    #[arg(long, value_parser = printed_as(&[Format::Text, Format::Json]), default_value = "text")]
    format: Format,
    #[command(flatten)]
    log: LogarithmArgument,
    #[command(flatten)]
    limits: LimitArguments,
}

pub fn prove(arguments: &ProveArguments) -> Result<Ending, Stop> {
    let limits = arguments.limits.begun();
    let session = match &arguments.file {
        Some(path) => session(path)?,
        None => {
            let logarithm = arguments.log.or_configured()?;
            logarithm.into_iter().fold(Session::blank(), Session::with_logarithm)
        }
    };
    let proposition = Proposition {
        formula: arguments.formula.clone(),
        given: arguments.given.clone(),
        throughout: arguments.throughout,
    };
    let (symbols, scope) = (arguments.symbol.clone(), arguments.scope.clone());
    let question = Question { proposition, symbols, scope };
    let answer = meter::under(&limits, || session.prove(&question))
        .map_err(|ended| Failure::Defect(ended.to_string()))?
        .map_err(|f| f.where_symbols_are_declared("declare it with --symbol, or give a file that does with --in"))?;
    match arguments.format {
        Format::Json => print(&answer.json())?,
        _ => say(&answer.text(arguments.certificate, true))?,
    }
    Ok(answer.ending())
}
