//! `rederive report`: the first page of a report, printed; or a report as a PDF file.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use rederive::derivation::load;
use rederive::files::{self, pdf, write};
use rederive::{Ask, Findings, Session, report};

use super::arguments::RigorArgument;
use super::ending::{Exit, Stop, complain, say};
use super::progress;
use super::records::RecordArguments;

#[derive(clap::Args)]
pub struct ReportArguments {
    /// The derivation file
    file: PathBuf,
    /// The PDF file. It is made by latexmk, pdflatex or tectonic; without them, by Chromium, Chrome or Edge
    #[arg(long, value_name = "OUT.PDF", required_unless_present = "summary")]
    pdf: Option<PathBuf>,
    /// The first page alone: printed, or, with --pdf, as a PDF file
    #[arg(long)]
    summary: bool,
    /// How the first page is printed
    #[arg(long, value_enum, default_value = "text", requires = "summary", conflicts_with = "pdf")]
    format: SummaryFormat,
    /// How much is asked of a verdict
    #[arg(long, value_enum, default_value = "enclosed")]
    rigor: RigorArgument,
    #[command(flatten)]
    records: RecordArguments,
}

/// How the first page of a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SummaryFormat {
    /// For a terminal
    Text,
    /// As LaTeX source, for a letter
    Tex,
    /// As Markdown
    Markdown,
}

pub fn report(arguments: &ReportArguments) -> Result<Exit, Stop> {
    match &arguments.pdf {
        Some(pdf) => printed(arguments, pdf),
        None => first_page(arguments),
    }
}

fn checked(arguments: &ReportArguments) -> Result<Findings, Stop> {
    let path = files::named(&arguments.file)?;
    write::check_outputs(arguments.pdf.as_slice(), std::slice::from_ref(&path), &[])?;
    let session = Session::of(load(&path).map_err(Stop::Diagnostics)?);
    let ask = Ask { rigor: arguments.rigor.into(), ..Ask::default() };
    Ok(progress::check(&session, &ask, arguments.records.store().as_ref())?)
}

/// The first page, to standard output.
fn first_page(arguments: &ReportArguments) -> Result<Exit, Stop> {
    let found = checked(arguments)?;
    let (derivation, account) = (found.derivation(), found.account());
    say(&match arguments.format {
        SummaryFormat::Text => report::front_page(derivation, account, true),
        SummaryFormat::Tex => report::tex_summary(derivation, account),
        SummaryFormat::Markdown => report::front_markdown(derivation, account),
    })?;
    Ok(Exit::Good)
}

fn printed(arguments: &ReportArguments, target: &Path) -> Result<Exit, Stop> {
    let makers = pdf::Makers::find().map_err(|none| {
        Stop::Message(format!(
            "{none}; without them, `rederive check FILE --format tex` prints the LaTeX source, and a browser prints the page of the \
             report"
        ))
    })?;
    let found = checked(arguments)?;
    let (derivation, account) = (found.derivation(), found.account());
    let (tex, page) = match arguments.summary {
        true => (report::tex_summary(derivation, account), report::first_page(derivation, account)),
        false => (report::tex(derivation, account), report::printed_page(derivation, account)),
    };
    let made = makers.make(tex, page, &|note| complain(&format!("{note}\n")));
    let (pdf, maker) = made.map_err(|failure| Stop::Message(failure.to_string()))?;
    write::write_file(target, &pdf)?;
    complain(&format!("{}: {}: written by {maker}\n", derivation.id, target.display()));
    Ok(Exit::Good)
}
