//! Fields with formulas on a domain: what `solves` says there, boundary data, traps, and the pictures of the page.

use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report;

const HEAD: &str = r#"
[derivation]
title = "T"
concerns = "C"

[symbols]
't' = { role = "time" }
'x' = { role = "coordinate" }
'y' = { role = "coordinate" }
'c' = { role = "parameter" }
'a' = { role = "parameter" }
'u(x,t)' = { role = "field" }
'f(x)' = { role = "field" }
'{\bf v}(x,y)' = { role = "field", shape = "2" }
'\psi(x,t)' = { role = "field", complex = true }

[system.string]
fields = ['u']
equations = ['\partial_t^2u=c^2\partial_x^2u']

[system.shift]
fields = ['u']
equations = ['u_t=-u_x']
"#;

fn tried(claim: &str) -> (Derivation, Account) {
    let text = format!("{HEAD}\n[[claim]]\nid = \"c\"\nsays = \"s\"\n{claim}\n");
    let derivation =
        parse(Source { path: "t.toml".into(), text }, "t").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("it is checked");
    (derivation, account)
}

fn word(claim: &str) -> &'static str {
    let (_, account) = tried(claim);
    account.claims[0].region.as_ref().expect("a region").verdict.outcome().word()
}

#[test]
fn a_problem_with_its_data_is_solved_or_not() {
    let wave = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = [1, 2], 'u' = '\sin(\pi x)\cos(c\pi t)' }
solves = 'string'
";
    for (expected, data) in [
        ("holds", r"always = ['u(0,t)=0', 'u(x,0)=\sin\pi x', 'u_t(x,0)=0']"),
        ("holds", r"always = ['\left.\partial_tu\right|_{t=0}=0']"),
        ("fails", r"always = ['u(\frac12,t)=0']"),
        ("fails", r"always = ['u_x(0,t)=0']"),
        ("fails", r"always = ['u_t(x,1)=0']"),
        ("fails", r"always = ['u(x,0)=\sin 2\pi x']"),
    ] {
        assert_eq!(word(&format!("{wave}{data}")), expected, "{data}");
    }
}

#[test]
fn what_is_not_smooth_solves_nothing() {
    let of =
        |u: &str, t: &str| word(&format!("ranges = {{ 'x' = [-1, 1], 't' = {t}, 'u' = '{u}' }}\nsolves = 'shift'"));
    assert_eq!(of("(x-t)^2", "[0, 0.5]"), "holds");
    assert_eq!(of("(x+t)^2", "[0, 0.5]"), "fails");
    // A kink, an infinite slope, and a pole inside; outside of the box they do no harm.
    assert_ne!(of("|x-t|", "[0, 0.5]"), "holds");
    assert_ne!(of(r"\sqrt{x-t}", "[0, 0.5]"), "holds");
    assert_ne!(of(r"\frac{1}{x-t}", "[0, 0.5]"), "holds");
    assert_eq!(of("|x-t|", "[2, 3]"), "holds");
}

#[test]
fn a_profile_is_taken_where_it_has_gone() {
    let of = |f: &str, u: &str| {
        word(&format!("ranges = {{ 'x' = [-1, 1], 't' = [0, 1], 'c' = [1, 2], 'f' = '{f}' }}\nalways = ['''{u}''']"))
    };
    assert_eq!(of("e^{-x^2}", r"\partial_tf(x-ct)=-c\partial_xf(x-ct)"), "holds");
    assert_eq!(of("e^{-x^2}", r"f(x-ct)=e^{-(x-ct)^2}"), "holds");
    assert_eq!(of("e^{-x^2}", r"f(x-ct)=e^{-x^2}"), "fails");
    assert_eq!(of("x^3", r"f''(ct)=6ct"), "holds");
    assert_eq!(of("x^3", r"f''(ct)=6x"), "fails");
    // Where it has no value it is not counted, and is not there.
    assert_ne!(word("ranges = { 'x' = [-1, 1], 'f' = '\\ln x' }\ndefined = ['f(x)']"), "holds");
    assert_ne!(word("ranges = { 'x' = [0.5, 1], 'f' = '\\ln x' }\ndefined = ['f(x-1)']"), "holds");
}

#[test]
fn fields_are_drawn() {
    let (derivation, account) = tried(
        r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = '\sin(x+2t)' }
always = ['u_t=u_x']",
    );
    let of = account.claims[0].region.as_ref().expect("a region");
    assert_eq!(of.portraits.iter().map(|p| p.residual).collect::<Vec<_>>(), [false, true]);
    let page = report::page(&derivation, &account);
    for said in
        ["class=fp", "class=fx", "The cross marks the point at which the claim fails", "The left side minus the right"]
    {
        assert!(page.contains(said), "{said}");
    }
    // An identity has no residual to be seen; arrows have no squares.
    let (derivation, account) = tried(
        r"ranges = { 'x' = [-1, 1], 'y' = [-1, 1], '{\bf v}' = '(-y,x)' }
always = ['\nabla\cdot{\bf v}=0']",
    );
    let of = account.claims[0].region.as_ref().expect("a region");
    assert_eq!(of.portraits.len(), 1);
    let page = report::page(&derivation, &account);
    assert!(page.contains("class=fa") && page.contains("arrows, the longest of length"));
    // One range is no map.
    let (_, account) = tried("ranges = { 'x' = [0, 1], 't' = 0, 'u' = 'x' }\nalways = ['u_x=1']");
    assert!(account.claims[0].region.as_ref().expect("a region").portraits.is_empty());
}

/// The altered formulas of the only claim: how many are rejected, of how many, and those that are not.
fn altered(claim: &str) -> Option<(usize, usize, Vec<String>)> {
    let (_, account) = tried(claim);
    let variants = account.claims[0].variants.as_ref()?;
    let (rejected, of) = variants.together()?;
    Some((rejected, of, variants.survivors.iter().map(|s| s.formula.clone()).collect()))
}

#[test]
fn altered_formulas_of_fields_are_told_from_them() {
    // By values through which solutions pass.
    let flow = r"follows-from = ['string']
always = ['\partial_t((\partial_tu)^2+(c\,\partial_xu)^2)=2c^2\partial_x(\partial_tu\,\partial_xu)']";
    let (rejected, of, left) = altered(flow).expect("they are tried");
    assert!(of > 20 && rejected == of && left.is_empty(), "{rejected} of {of}: {left:?}");
    // By points of a box. That the field solves another equation as well is no fault of the test.
    let runs = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = [1, 2], 'u' = '\sin(x-ct)' }
always = ['\partial_t^2u=c^2\partial_x^2u']";
    let (rejected, of, left) = altered(runs).expect("they are tried");
    assert!(of > 10 && rejected == of && left.is_empty(), "{rejected} of {of}: {left:?}");
    let still = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = 0, 'u' = 'x' }
always = ['\partial_t^2u=c^2\partial_x^2u']";
    let (rejected, of, left) = altered(still).expect("they are tried");
    assert!(rejected == 0 && left.len() == of, "{rejected} of {of}: {left:?}");
    // Where it applies.
    let half = r"ranges = { 'x' = [-1, 1], 't' = [-1, -0.5], 'u' = 'x|x|' }
assuming = ['x>0']
always = ['u_x=2x']";
    let (rejected, of, left) = altered(half).expect("they are tried");
    assert!(rejected == of && left.is_empty(), "{rejected} of {of}: {left:?}");
    // No point of those that are drawn is one at which this applies.
    assert_eq!(
        altered("ranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = 'x' }\nassuming = ['x=t']\nalways = ['u=t']"),
        None
    );
    // What is given, but not used, is not known to hold at a point.
    let beside = "follows-from = ['a']\nalways = ['uu_x=\\frac12\\partial_x(u^2)']\n[[claim]]\nid = \"a\"\nsays = \"s\"\nalways = ['u\\ne 1']";
    assert_eq!(altered(beside), None);
    // Where no theorem gives a solution, none is tried; and none of a claim that does not hold.
    assert_eq!(altered("assuming = ['(\\partial_xu)^2=u', '(\\partial_tu)^2=u']\nalways = ['4u_x^2=4u']"), None);
    assert_eq!(altered("always = ['u_x=u_t']"), None);
}

#[test]
fn pages_say_where_altered_formulas_were_tried() {
    for (claim, said) in [
        (
            r"follows-from = ['shift']
always = ['u_{tt}=u_{xx}']",
            "would be noticed by solutions of what is given",
        ),
        (
            r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = 'x-t' }
always = ['u_t=-u_x']",
            "would be noticed at points of the ranges",
        ),
    ] {
        let (derivation, account) = tried(claim);
        let page = report::page(&derivation, &account);
        assert!(page.contains(said), "{said}");
    }
}

/// The pictures of the only claim, as the page has them.
fn figures(claim: &str) -> Vec<String> {
    let (derivation, account) = tried(claim);
    let page = report::page(&derivation, &account);
    let parts = page.split("<figure class=map>").skip(1);
    let all = parts.filter_map(|p| p.split_once("</figure>")).map(|(figure, _)| figure.to_owned());
    // The map of the verdicts is another picture.
    all.filter(|figure| figure.contains("<title>The ")).collect()
}

/// The squares of a kind in a picture: left, bottom, side.
fn squares(figure: &str, kind: &str) -> Vec<(f64, f64, f64)> {
    let start = format!("<path class={kind} d=\"");
    let Some((path, _)) = figure.split_once(&start).and_then(|(_, rest)| rest.split_once('"')) else {
        return Vec::new();
    };
    let one = |text: &str| {
        let (at, rest) = text.split_once('h')?;
        let (x, y) = at.split_once(' ')?;
        let side = rest.split(['v', 'h']).next()?;
        Some((x.parse().ok()?, y.parse().ok()?, side.parse().ok()?))
    };
    path.split('M').skip(1).map(|text| one(text).unwrap_or_else(|| panic!("no square: {text}"))).collect()
}

#[test]
fn squares_and_axes_are_where_they_belong() {
    let across = figures("ranges = { 'x' = [-1, 3], 't' = [0, 1], 'u' = 'x' }\nalways = ['u=2x']");
    let [field, residual] = &across[..] else { panic!("{} pictures", across.len()) };
    assert!(field.contains("<title>The field u(x,t)</title>"));
    assert!(residual.contains("<title>The left side minus the right side of u=2x</title>"));
    // x = 0 is at 6 of 24 squares; the residual is −x.
    for (figure, right, left) in [(field, "fp", "fm"), (residual, "fm", "fp")] {
        let (right, left) = (squares(figure, right), squares(figure, left));
        assert_eq!((right.len(), left.len()), (18 * 24, 6 * 24));
        assert!(right.iter().all(|s| s.0 > 6.0) && left.iter().all(|s| s.0 < 6.0));
        // The area is the size.
        let (first, last) = (right[0].2, right[17].2);
        assert!((last - 0.95).abs() < 1e-9 && (first / last - (1.0f64 / 35.0).sqrt()).abs() < 0.03, "{first} {last}");
    }
    assert!(
        field.contains("between −0.917 and 2.92.") && field.contains(r#"transform="translate(84 396) scale(16 -16)""#)
    );
    let axes = r#"<path class=axis d="M84 12h384v384h-384z"></path><text x=84 y=414 text-anchor=start>−1</text><text x=78 y=396 text-anchor=end>0</text><text x=276 y=414 text-anchor=middle>1</text><text x=78 y=204 text-anchor=end>0.5</text><text x=468 y=414 text-anchor=end>3</text><text x=78 y=24 text-anchor=end>1</text><text x=276 y=434 text-anchor=middle>x</text><text transform="translate(16 204) rotate(-90)" text-anchor=middle>t</text>"#;
    assert!(field.contains(axes), "{field}");
    // With units.
    let claim =
        "[[claim]]\nid = \"c\"\nsays = \"s\"\nranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = 't' }\nalways = ['u=t']";
    let text = HEAD
        .replace("'x' = { role", "'x' = { unit = \"m\", role")
        .replace("'t' = { role", "'t' = { unit = \"s\", role");
    let derivation = parse(Source { path: "t.toml".into(), text: format!("{text}{claim}") }, "t").expect("it is read");
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("it is checked");
    let page = report::page(&derivation, &account);
    assert!(
        page.contains("text-anchor=middle>x in m</text>") && page.contains("<desc>x in m to the right, t in s upwards")
    );
    let up = figures("ranges = { 'x' = [0, 1], 't' = [-1, 3], 'u' = 't' }\nalways = ['u=2t']");
    let (above, below) = (squares(&up[0], "fp"), squares(&up[0], "fm"));
    assert!(above.iter().all(|s| s.1 > 6.0) && below.iter().all(|s| s.1 < 6.0) && above.len() == 18 * 24);
}

#[test]
fn gaps_witnesses_and_what_is_not_seen_are_told() {
    let gaps = figures("ranges = { 'x' = [-1, 1], 't' = [0, 1], 'u' = '\\ln x' }\nalways = ['u_x=1']");
    assert!(gaps[0].contains("; no value in 288 of 576 squares"));
    let dashes = gaps[0].split_once("<path class=rd d=\"").and_then(|(_, d)| d.split_once('"')).expect("dashes").0;
    assert!(dashes.starts_with("M0.3 0.5h.4M1.3 0.5h.4") && !dashes.contains("M12.3 "));
    // Where it fails: in the upper right corner.
    let marked =
        figures("ranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = 'x' }\nassuming = ['x>0.8', 't>0.8']\nalways = ['u=2x']");
    let (_, cross) = marked[0].split_once("<path class=fx d=\"M").expect("a cross");
    let (at, _) = cross.split_once('l').expect("its arms");
    let (x, y) = at.split_once(' ').expect("two numbers");
    let (x, y): (f64, f64) = (x.parse().expect("a number"), y.parse().expect("a number"));
    assert!(x + 6.0 > 84.0 + 0.8 * 384.0 && y + 6.0 < 12.0 + 0.2 * 384.0, "{x} {y}");
    // What varies besides is in the middle of its range.
    let third = figures("ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = [1, 3], 'u' = 'cx' }\nalways = ['u=x']");
    assert!(third[0].contains("between 0.0417 and 1.96.") && third[0].contains("Everything else is in the middle"));
    // The size of a complex field.
    let wave =
        figures("ranges = { 'x' = [0, 1], 't' = [0, 1], '\\psi' = 'x+\\mathrm{i}t' }\nalways = ['\\partial_x\\psi=1']");
    assert!(wave[0].contains("and 1.92."), "{}", wave[0]);
}

#[test]
fn arrows_point_where_the_field_does() {
    let of = |v: &str| {
        let claim = format!(
            "ranges = {{ 'x' = [-1, 1], 'y' = [-1, 1], '{{\\bf v}}' = '{v}' }}\nalways = ['\\nabla\\cdot{{\\bf v}}=2']"
        );
        figures(&claim).swap_remove(0)
    };
    let across = of("(x,0)");
    assert!(
        across.contains("M0.95 0.5l-0.9 0l0.31 0.19m-0.31 -0.19l0.31 -0.19")
            && across.contains("M11.05 11.5l0.9 0l-0.3")
    );
    assert!(across.contains("arrows, the longest of length 0.917"));
    let up = of("(0,y)");
    // The length of an arrow is that of the vector.
    assert!(of("(x,y)").contains("arrows, the longest of length 1.3."));
    assert!(up.contains("M0.5 0.95l0 -0.9l") && up.contains("M11.5 11.05l0 0.9l"), "{up}");
}

#[test]
fn what_claims_of_fields_should_have_said_is_offered() {
    let offered = |claim: &str| -> Vec<(String, bool)> {
        let (_, account) = tried(claim);
        let erratum = account.claims[0].variants.as_ref().and_then(|v| v.erratum.as_ref());
        erratum.map_or_else(Vec::new, |e| {
            e.corrections
                .iter()
                .map(|c| (c.formula.clone(), c.strength == rederive::verdict::Strength::Proved))
                .collect()
        })
    };
    // On a box, and for all fields.
    let box_ = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = [1, 2], 'u' = '\sin(x-ct)' }
always = ['\partial_t^2u=-c^2\partial_x^2u']";
    let found = offered(box_);
    // The other sign, on the side that does not stand alone.
    assert!(matches!(&found[..], [(f, true)] if f == r"\partial_t^2 u=c^2\partial_x^2 u"), "{found:?}");
    let found = offered("follows-from = ['shift']\nalways = ['u_{tt}=-u_{xx}']");
    assert!(matches!(&found[..], [(f, true), ..] if f == "u_{tt}=u_{xx}"), "{found:?}");
    // Nothing is offered that does not hold.
    assert!(offered("ranges = { 'x' = [1, 2], 't' = [1, 2], 'u' = '\\sin(x^2t)' }\nalways = ['u_x=u_t']").is_empty());
    assert!(offered("always = ['u_x=u_t']").is_empty());
}
