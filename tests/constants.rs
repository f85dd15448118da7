//! Constants of nature and units behind numbers: what is exact is proved, what is measured is refused, and units are kept apart.

use rederive::check::{Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::Source;

/// A file with symbols, conventions and claims, one formula each.
fn file(symbols: &str, conventions: &str, claims: &[&str]) -> String {
    let mut text = format!(
        "[derivation]\ntitle = \"a\"\nconcerns = \"b\"\n[conventions]\n{conventions}\n[symbols]\n't' = {{ role = \"time\", unit = \"s\" }}\n\
         'x' = {{ role = \"state\", unit = \"m\" }}\n'm' = {{ role = \"parameter\", unit = \"kg\" }}\n{symbols}\n\
         [[trajectory]]\nid = \"m\"\nformula = {{ 'x' = '2t' }}\nparameters = {{ 'm' = 3 }}\nspan = [0, 1]\n"
    );
    for (at, claim) in claims.iter().enumerate() {
        text += &format!("[[claim]]\nid = \"c{at}\"\nsays = \"it\"\nalways = ['{claim}']\n");
    }
    text
}

fn read(text: String) -> Result<Derivation, Vec<(String, String)>> {
    parse(Source { path: "a.toml".into(), text }, "a").map_err(|found| {
        found.iter().map(|d| (format!("{}: {}", d.code, d.message), d.hint.clone().unwrap_or_default())).collect()
    })
}

/// The verdict on each claim, and whether its units agree.
fn verdicts(symbols: &str, conventions: &str, claims: &[&str]) -> Vec<(String, &'static str)> {
    let derivation = read(file(symbols, conventions, claims)).unwrap_or_else(|e| panic!("{e:?}"));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    (0..claims.len())
        .map(|at| {
            let id = format!("c{at}");
            let claim = account.claims.iter().find(|c| c.id == id).expect("the claim");
            let units = account.units.formulas.iter().find(|f| f.kind == "claim" && f.of == id);
            (claim.results[0].verdict.outcome().word().to_owned(), units.map_or("none", |u| u.verdict.word()))
        })
        .collect()
}

const NATURE: &str = "'c' = { role = \"constant\" }\n'h' = { role = \"constant\" }\n'\\hbar' = { role = \"constant\" }\n\
                      'k_{\\rm B}' = { role = \"constant\" }\n'N_A' = { role = \"constant\" }\n'R' = { role = \"constant\" }\n\
                      '\\sigma' = { role = \"constant\" }\n'g' = { role = \"constant\", formula = '9.81', unit = \"m/s^2\" }";

#[test]
fn exact_constants_have_their_values_and_units() {
    let claims = [
        (r"\hbar=\frac{h}{2\pi}", "holds", "consistent"),
        (r"R=N_Ak_{\rm B}", "holds", "consistent"),
        (r"\sigma=\frac{2\pi^5k_{\rm B}^4}{15h^3c^2}", "holds", "consistent"),
        (r"\sigma=\frac{2\pi^5k_{\rm B}^4}{60h^3c^2}", "fails", "consistent"),
        (r"c=299792458\,\mathrm{m/s}", "holds", "consistent"),
        (r"c=3\times10^8\,\mathrm{m/s}", "fails", "consistent"),
        (r"c=299792.458\,\mathrm{km\,s^{-1}}", "holds", "consistent"),
        (r"c=1079252848.8\,\mathrm{km/h}", "holds", "consistent"),
        (r"x=2\,\mathrm{m/s}\,t", "holds", "consistent"),
        (r"mg=29.43\,\mathrm{N}", "holds", "consistent"),
        (r"mg=29.43\,\mathrm{J}", "holds", "inconsistent"),
        (r"m=3000\,\mathrm{g}", "holds", "consistent"),
        (r"g=9.81\,\mathrm{N/kg}", "holds", "consistent"),
        (r"g=9.81\,\text{m/(s\,s)}", "holds", "consistent"),
        (r"x=ct", "fails", "consistent"),
        (r"x=ct^2", "fails", "inconsistent"),
        (r"\frac{d}{dt}(cx)=c\dot x", "holds", "consistent"),
    ];
    let formulas: Vec<&str> = claims.iter().map(|(f, ..)| *f).collect();
    let found = verdicts(NATURE, "units = \"SI\"", &formulas);
    for ((formula, outcome, units), found) in claims.iter().zip(found) {
        assert_eq!((found.0.as_str(), found.1), (*outcome, *units), "{formula}");
    }
}

/// The codes and messages of a file that is refused.
#[track_caller]
fn refused(symbols: &str, conventions: &str, claim: &str, part: &str) -> String {
    let found = match read(file(symbols, conventions, &[claim])) {
        Err(found) => found,
        Ok(_) => panic!("{symbols} {claim} was accepted"),
    };
    let fitting = found.iter().find(|(said, _)| said.contains(part));
    fitting.unwrap_or_else(|| panic!("{part} is not among {found:?}")).1.clone()
}

#[test]
fn what_is_measured_or_given_twice_is_refused() {
    let si = "units = \"SI\"";
    // What divides is one unit, or stands in parentheses.
    refused(
        "'q' = { role = \"parameter\", unit = \"J/(kg K)\" }",
        si,
        r"q=3\,\mathrm{J/kg\,K}",
        "more than one unit behind",
    );
    for name in ["G", r"\epsilon_0", r"\varepsilon_0", r"\mu_0", r"\alpha", "m_e", r"m_{\rm p}"] {
        let hint = refused(&format!("'{name}' = {{ role = \"constant\" }}"), "", "x=x", "measured");
        assert!(hint.contains("CODATA") && hint.contains("unit = "), "{name}: {hint}");
    }
    assert!(refused("'q' = { role = \"constant\" }", "", "x=x", "not the name").contains("N_A"));
    refused("'c' = { role = \"constant\", unit = \"m/s\" }", "", "x=x", "unit already");
    refused("'q' = { role = \"constant\", formula = 'm' }", "", "x=x", "not a number");
    refused("'c' = { role = \"constant\", positive = true }", "", "x=x", "has no `positive`");
    // Kilometres beside metres, and a quantity that is measured in nobody knows what.
    refused(
        "'c' = { role = \"constant\" }\n'y' = { role = \"parameter\", unit = \"km\" }",
        "",
        "x=x",
        "measured in km",
    );
    refused("'y' = { role = \"parameter\" }", si, r"x=5\,\mathrm{m}", "no unit");
    refused("", "units = \"those of the paper\"", r"x=5\,\mathrm{m}", "latex::unknown-symbol");
    refused("", si, r"g=9.81\,\mathrm{m/s\,s}", "latex::ambiguous");
    refused("", si, r"x=5\,\mathrm{furlong}", "latex::unknown");
    // Without the convention upright letters are names, and these are not declared.
    refused("", "", r"x=5\,\mathrm{m}", "latex::unknown-symbol");
    refused("", "", r"x=5\,\mathrm{m/s}", "latex::unknown");
    let given = file("'c' = { role = \"constant\" }", "", &["x=x"]).replace("'m' = 3", "'m' = 3, 'c' = 1");
    assert!(read(given).is_err_and(|e| e[0].0.contains("its value is fixed")));
    let ranged = file("'c' = { role = \"constant\" }", "", &["c>1"]) + "ranges = { 'c' = [1, 2] }\n";
    assert!(read(ranged).is_err_and(|e| e[0].0.contains("it has no range")));
}

#[test]
fn upright_letters_that_are_no_units() {
    let symbols = "'A' = { role = \"parameter\", shape = \"2x2\", unit = \"1\" }\n'F_{\\mathrm{N}}' = { role = \"parameter\", unit = \"N\" }";
    let claims = [r"x=2\,\mathrm{m/s}\,t", r"\frac{\mathrm{d}x}{\mathrm{d}t}=2\,\mathrm{m/s}"];
    let text = file(symbols, "units = \"SI\"", &claims)
        .replace("'m' = 3", r"'m' = 3, 'A' = [[1, 2], [2, 1]], 'F_{\mathrm{N}}' = 1");
    let transposed = text.clone() + "[[claim]]\nid = \"T\"\nsays = \"it\"\nalways = ['A^{\\mathrm{T}}=A']\n";
    let derivation = read(transposed).unwrap_or_else(|e| panic!("{e:?}"));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    assert!(account.claims.iter().all(|c| c.results[0].verdict.outcome().word() == "holds"), "all hold");
}

#[test]
fn a_constant_over_ranges_and_in_values() {
    let text = file("'c' = { role = \"constant\" }\n'v' = { role = \"parameter\", unit = \"m/s\" }", "", &["v<c"])
        .replace("'m' = 3", "'m' = 3, 'v' = '0.9c'")
        + "[[claim]]\nid = \"r\"\nsays = \"it\"\nranges = { 'v' = [0, 1000] }\nalways = ['v<c', 'vc>-1']\n";
    let derivation = read(text).unwrap_or_else(|e| panic!("{e:?}"));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(account.claims[0].results[0].verdict.outcome().word(), "holds");
    let region = account.claims[1].region.as_ref().expect("a region");
    assert_eq!(region.verdict.outcome().word(), "holds");
}
