//! The report page and the LaTeX source: nothing from outside, nothing unescaped, nothing missing, the same every time.
//!
//! What a browser makes of the page is tested by `tests/browser/run`.

use std::path::Path;
use std::process::Command;

use crate::checked::{Checked, anew, checked};
use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report::{json, page, tex};

fn of_file(name: &str) -> Checked {
    checked(Path::new("derivations").join(name))
}

fn of_text(text: &str) -> (Derivation, Account) {
    let source = Source { path: "derivations/hostile.toml".into(), text: text.into() };
    let derivation = parse(source, "hostile").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    (derivation, account)
}

/// Everything that a person who writes a file can put into texts.
const HOSTILE: &str = r#"
[derivation]
title = '<script>alert(1)</script></title><h1>'
concerns = '"><img src=x onerror=alert(2)> \input{/etc/hostname} 100 % # & _'
source = '<iframe src="file:///"></iframe>'
remark = '`<script>alert(3)</script>` and $<b>x</b>$ and $\operatorname{<script>}$ \end{document}'

[conventions]
'<i>key</i>' = '</dd><script>alert(4)</script>'

[symbols]
't' = { role = "time", unit = 's', says = '<u>s</u>' }
'x' = { role = "state", says = '<svg onload=alert(5)>', unit = 'm' }

[system.s]
says = '<script>alert(7)</script>'
states = ['x']
equations = ['\dot x=-x']

[[trajectory]]
id = "a"
title = '<script>alert(8)</script>'
says = '<style>*{display:none}</style>'
system = "s"
initial = { 'x' = 1 }
span = [0, 3]

[[claim]]
id = "data"
says = '</script><script>alert(9)</script> <!-- '
place = '<a href="javascript:alert(10)">here</a>'
label = '<script>alert(11)</script>'
remark = '<base href="http://example.org/">'
always = ['\dot x<x', '\dot x=x']
expect = "fails"

[[measure]]
id = "m"
says = '<script>alert(12)</script>'
formula = 'x'
unit = 'm'

[[picture]]
id = "p"
says = '<script>alert(13)</script>'
kind = "time"
show = ['x']
"#;

#[test]
fn no_text_of_a_file_is_markup() {
    let (derivation, account) = of_text(HOSTILE);
    let page = page(&derivation, &account);
    assert_eq!(page.matches("<script").count(), 2, "the data and the program of the page");
    assert_eq!(page.matches("</script").count(), 2);
    let lower = page.to_lowercase();
    for bad in
        ["<img", "<iframe", "<base", "<svg onload", "<i>", "<b>x", "<u>", "<!--", "href=\"javascript", "<style>*{"]
    {
        assert!(!lower.contains(bad), "{bad}");
    }
    assert_eq!(
        page.matches("<title>").count(),
        1 + page.matches("<svg").count(),
        "one for the page, one for each picture"
    );
}

#[test]
fn no_text_of_a_file_is_a_command_of_latex() {
    let (derivation, account) = of_text(HOSTILE);
    let source = tex(&derivation, &account);
    assert!(!source.contains(r"\input{/"));
    assert_eq!(source.matches(r"\end{document}").count(), 1);
    compiles(&source);
}

#[test]
fn nothing_is_fetched() {
    for name in ["pendulum.toml", "kepler.toml"] {
        let (derivation, account) = &*of_file(name);
        let page = page(derivation, account);
        // The name of the SVG name space is no address.
        let rest = page.replace("http://www.w3.org/2000/svg", "");
        // The letters of formulas are in the page, and a clip is one of its own places.
        let rest = rest.replace("url(data:font/woff2;base64,", "").replace("url(#${clip})", "");
        for outside in ["http:", "https:", "url(", "@import", "<link", "<img", "<iframe", " src="] {
            assert!(!rest.contains(outside), "{name}: {outside}");
        }
        assert!(page.contains("default-src 'none'"));
    }
}

#[test]
fn everything_essential_is_there_without_the_program() {
    let (derivation, account) = &*of_file("pendulum.toml");
    let page = page(derivation, account);
    let html = page.split("<script").next().unwrap_or_default();
    for claim in &account.claims {
        let name = claim.reading.as_ref().map_or(claim.id.clone(), |r| format!("{}/{r}", claim.id));
        assert!(
            [format!(" id={name}>"), format!(" id=\"{name}\">")].iter().any(|place| html.contains(place)),
            "{name}"
        );
    }
    let (pairs, cells) =
        (account.claims.iter().map(|c| c.results.len()).sum::<usize>(), html.matches("<tr id=/p").count());
    assert_eq!(pairs, cells, "a row for each pair");
    for t in &account.trajectories {
        assert!(html.contains(&format!("id=/trajectory/{}>", t.id)), "{}", t.id);
    }
    assert!(html.contains(&derivation.sha256) && html.contains("<math") && html.contains("<svg"));
    assert!(html.contains("id=/filters hidden"), "filters that cannot work are not shown");
}

#[test]
fn the_same_input_gives_the_same_page() {
    let (derivation, account) = &*of_file("pendulum.toml");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/pendulum.toml");
    let (again, once_more) = anew(&path);
    assert_eq!(page(derivation, account), page(&again, &once_more));
    assert_eq!(tex(derivation, account), tex(&again, &once_more));
}

#[test]
fn curves_pass_through_the_witness_and_stay_out_of_the_data_file() {
    let (derivation, account) = &*of_file("pendulum.toml");
    let mut seen = 0;
    for pair in account.claims.iter().flat_map(|c| &c.results) {
        let evidence = pair.verdict.evidence();
        let Some(series) = &evidence.series else { continue };
        assert!(series.points.windows(2).all(|w| w[0].t < w[1].t), "times increase");
        assert!(series.points.len() <= 64, "{}", series.points.len());
        assert!(series.points.len() <= series.of);
        if let Some(w) = &evidence.witness
            && w.formula == series.formula
        {
            let at = series.points.iter().find(|p| p.t == w.t).expect("the witness is drawn");
            assert_eq!((at.left, at.right, at.bound), (w.left, w.right, w.bound));
            seen += 1;
        }
    }
    assert!(seen > 0);
    assert!(!json(derivation, account).contains("series"));
}

#[test]
fn pictures_show_what_the_file_declares() {
    let (_, account) = &*of_file("pendulum.toml");
    assert!(account.pictures.iter().any(|p| p.picture == "phase-plane" && p.reason.is_none()));
    for picture in &account.pictures {
        assert!(picture.lines.iter().flat_map(|l| &l.points).all(|p| p.0.is_finite() && p.1.is_finite()));
        assert_eq!(picture.lines.is_empty(), picture.reason.is_some());
    }
}

#[test]
fn the_latex_source_compiles() {
    let (derivation, account) = &*of_file("pendulum.toml");
    compiles(&tex(derivation, account));
}

/// Compiles a source where there is a compiler; elsewhere says that it was not tried.
fn compiles(source: &str) {
    if Command::new("pdflatex").arg("--version").output().is_err() {
        eprintln!("pdflatex is not installed: that the source compiles was not tried");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("report.tex"), source).expect("written");
    let arguments = ["-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "report.tex"];
    let run = Command::new("pdflatex").args(arguments).current_dir(folder.path()).output().expect("pdflatex runs");
    let log = String::from_utf8_lossy(&run.stdout);
    let problem: Vec<&str> = log.lines().filter(|l| l.starts_with('!') || l.starts_with("l.")).collect();
    assert!(run.status.success(), "{}", problem.join("\n"));
    assert!(folder.path().join("report.pdf").exists());
}
