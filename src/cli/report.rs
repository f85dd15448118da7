//! `rederive report`: the first page of a report, printed; or a report as a PDF file.

use std::path::{Path, PathBuf};

use rederive::files::{self, pdf, write};
use rederive::{Ask, Detail, Document, Ending, Format};

use super::arguments::{RigorArgument, printed_as};
use super::ending::{Stop, complain, say};
use super::files::session;
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
    #[arg(long, value_parser = printed_as(&[Format::Text, Format::Tex, Format::Markdown]), default_value = "text",
        requires = "summary", conflicts_with = "pdf")]
    format: Format,
    #[command(flatten)]
    rigor: RigorArgument,
    #[command(flatten)]
    records: RecordArguments,
}

pub fn report(arguments: &ReportArguments) -> Result<Ending, Stop> {
    match &arguments.pdf {
        Some(pdf) => printed(arguments, pdf)?,
        None => say(&checked(arguments)?.text(arguments.format, Detail::FirstPage, true))?,
    }
    Ok(Ending::Good)
}

fn checked(arguments: &ReportArguments) -> Result<Document, Stop> {
    write::check_outputs(arguments.pdf.as_slice(), &[files::named(&arguments.file)?], &[])?;
    let ask = Ask { rigor: arguments.rigor.rigor, ..Ask::default() };
    Ok(progress::check(&session(&arguments.file)?, &ask, arguments.records.store().as_ref())?.into())
}

fn printed(arguments: &ReportArguments, target: &Path) -> Result<(), Stop> {
    let makers = pdf::Makers::find().map_err(|none| {
        format!(
            "{none}; without them, `rederive check FILE --format tex` prints the LaTeX source, and a browser prints the page of the \
             report"
        )
    })?;
    let document = checked(arguments)?;
    let (tex, page) = document.printed(arguments.summary);
    let (pdf, maker) = makers.make(tex, page, &complain)?;
    write::write_file(target, &pdf)?;
    complain(&format!("{}: {}: written by {maker}", document.findings.derivation().id, target.display()));
    Ok(())
}
