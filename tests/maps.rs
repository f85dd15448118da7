//! Maps of families: what is counted in their cells, in one run and in parts, on the page and in the report's data.

use rederive::check::family::Part;
use rederive::check::{Account, Limits, Options, Rigor, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::{Ask, Session, report};

const HEAD: &str = r"
[derivation]
title = 't'
concerns = 'c'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'a' = { role = 'parameter' }
'b' = { role = 'parameter' }
'c' = { role = 'parameter' }
[[trajectory]]
id = 'one'
parameters = { 'a' = 1, 'b' = 1, 'c' = 1 }
formula = { 'x' = 'a+bt+ct^2' }
span = [0, 1]
";

fn derivation(text: &str) -> Result<Derivation, String> {
    let text = format!("{HEAD}{text}");
    parse(Source { path: "t.toml".into(), text }, "t").map_err(|found| render(&found, false))
}

fn run(derivation: &mut Derivation) -> Account {
    let options = Options { plain: true, rigor: Rigor::Sampled, ..Options::default() };
    check(derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

const ROW: &str = r"
[[family]]
id = 'row'
of = 'one'
vary = { 'a' = { from = -1, to = 1, count = 5 }, 'b' = { values = [3, -0.25, 1] }, 'c' = { values = [0, 7] } }
where = ['a+b<3.9']
map = ['b', 'a']
[[claim]]
id = 'above'
says = 's'
trajectories = []
families = ['row']
assuming = ['a\ne 0']
always = ['x>0']
expect = { fails = ['row'] }
";

/// What the claim is on a member: a, b and c; without a value where it is no member.
fn truth(a: f64, b: f64, c: f64) -> Option<usize> {
    // The smallest of a + b t + c t² on [0, 1], at an end or between.
    let at = |t: f64| a + b * t + c * t * t;
    let least = at(0.0).min(at(1.0)).min(if c > 0.0 { at((-b / (2.0 * c)).clamp(0.0, 1.0)) } else { f64::INFINITY });
    (a + b < 3.9).then_some(if a == 0.0 {
        2
    } else if least > 0.0 {
        0
    } else {
        1
    })
}

#[test]
fn every_member_is_counted_in_its_cell() {
    let account = run(&mut derivation(ROW).expect("a derivation"));
    let family = &account.claims[0].families[0];
    let map = family.map.as_ref().expect("a map");
    assert_eq!((map.across.name.as_str(), map.up.name.as_str()), ("b", "a"));
    // A list is shown in the order of its values.
    assert_eq!(map.across.cells, [(-0.25, -0.25), (1.0, 1.0), (3.0, 3.0)]);
    assert_eq!(map.up.cells, [-1.0, -0.5, 0.0, 0.5, 1.0].map(|x| (x, x)));
    let mut sums = [0; 4];
    for (row, (a, _)) in map.up.cells.iter().enumerate() {
        for (column, (b, _)) in map.across.cells.iter().enumerate() {
            let mut expected = [0; 4];
            [0.0, 7.0].iter().filter_map(|c| truth(*a, *b, *c)).for_each(|kind| expected[kind] += 1);
            let found = map.cells[row * 3 + column];
            assert_eq!(found, expected, "a = {a}, b = {b}");
            sums.iter_mut().zip(found).for_each(|(sum, n)| *sum += n);
        }
    }
    assert_eq!(sums, [family.counts.holds, family.counts.fails, family.counts.not_applicable, family.counts.undecided]);
    assert!(sums[0] > 0 && sums[1] > 0 && sums[2] > 0 && family.counts.rejected == 2, "{family:?}");
}

#[test]
fn the_page_draws_what_the_data_say() {
    let mut derivation = derivation(ROW).expect("a derivation");
    let account = run(&mut derivation);
    let data: serde_json::Value = serde_json::from_str(&report::json(&derivation, &account)).expect("JSON");
    let map = &data["claims"][0]["families"][0]["map"];
    assert_eq!(map["across"]["cells"], serde_json::json!([[-0.25, -0.25], [1.0, 1.0], [3.0, 3.0]]));
    assert_eq!(map["rows"].as_array().map(Vec::len), Some(5));
    assert_eq!(map["rows"][4][1], serde_json::json!([2, 0, 0, 0]));
    let page = report::page(&derivation, &account);
    let from = page.find("<figure class=map>").expect("a map on the page");
    let figure = &page[from..from + page[from..].find("</figure>").expect("its end")];
    // Row by row from below: a run of cells in which it holds on all members is one rectangle.
    for part in [
        "role=img",
        "<title>Where above holds</title>",
        "b from −0.25 to 3 to the right, a from −1 to 1 upwards",
        "class=rp",
        "class=rf",
        "class=rd",
        "M0 3h3v1h-3zM0 4h2v1h-2z",
    ] {
        assert!(figure.contains(part), "{part}\n{figure}");
    }
    assert!(figure.contains("shows the worst of them") && figure.contains("An empty cell has no members"), "{figure}");
    assert_eq!(page, report::page(&derivation, &account));
}

#[test]
fn a_map_is_over_two_symbols_that_vary() {
    let cases = [
        ("['b', 'a']", "no problem"),
        ("['b']", "a map is over two of the symbols that vary"),
        ("['a', 'b', 'c']", "a map is over two of the symbols that vary"),
        ("['a', 'a']", "two different symbols"),
        ("['a', 'x']", "does not vary `x`"),
        ("'a'", "must be an array"),
    ];
    for (map, expected) in cases {
        let found = match derivation(&ROW.replace("['b', 'a']", map)) {
            Err(found) => found,
            Ok(_) => "no problem".to_owned(),
        };
        assert!(found.contains(expected), "{map}: {found}");
    }
}

const DISC: &str = r"
[[family]]
id = 'disc'
of = 'one'
vary = { 'a' = { from = -2, to = 2, count = 5 }, 'b' = { values = [2, -2, 1, 0, -1] } }
map = ['a', 'b']
boundary = { 'a' = 1e-6, 'b' = 0.01 }
[[claim]]
id = 'inside'
says = 's'
trajectories = []
families = ['disc']
always = ['a^2+b^2<1.7+0x']
expect = { fails = ['disc'] }
";

#[test]
fn the_boundary_is_where_the_verdict_changes() {
    let mut derivation = derivation(DISC).expect("a derivation");
    let account = run(&mut derivation);
    let family = &account.claims[0].families[0];
    // What is tried to find it is counted nowhere.
    assert_eq!((family.counts.members, family.counts.holds), (25, 5));
    let map = family.map.as_ref().expect("a map");
    let boundary = map.boundary.as_ref().expect("a boundary");
    assert_eq!((boundary.widths, boundary.crossings.len()), ([Some(1e-6), Some(0.01)], 12));
    // From 1 to 2 ⁻²⁰ and to 2⁻⁷.
    assert_eq!((boundary.members, boundary.stopped.clone()), (6 * 20 + 6 * 7, None));
    for c in &boundary.crossings {
        let (ends, other, width) = if c.along == 0 { (c.across, c.up, 1e-6) } else { (c.up, c.across, 0.01) };
        let edge = (1.7 - other.0 * other.0).sqrt().copysign(ends.0 + ends.1);
        assert!(c.is_narrow && ends.0 < edge && edge < ends.1 && ends.1 - ends.0 <= width, "{c:?}");
        assert_eq!((other.0, c.first_holds), (other.1, ends.0 > 0.0), "{c:?}");
    }
    let data: serde_json::Value = serde_json::from_str(&report::json(&derivation, &account)).expect("JSON");
    let found = &data["claims"][0]["families"][0]["map"]["boundary"];
    assert_eq!(found["widths"], serde_json::json!({ "across": 1e-6, "up": 0.01 }));
    assert_eq!(found["crossings"].as_array().map(Vec::len), Some(12));
    assert_eq!(found["crossings"][0]["first"], "fails");
    let page = report::page(&derivation, &account);
    let line = page.find("class=rb").map(|at| &page[at..at + 400]).expect("a line");
    // Twelve points, and a line across each square that it cuts.
    assert!(line.contains("h0") && line.contains('L') && page.contains("The line is the edge"), "{line}");
    for text in [page, report::markdown(&derivation, &account), report::tex(&derivation, &account)] {
        assert!(text.contains("the verdict changes in 12 places"), "{text}");
        assert!(text.contains("by 162 motions beside the members"), "{text}");
    }
}

#[test]
fn what_was_counted_in_parts_has_the_same_boundary() {
    let session = |text: &str| Session::of(derivation(text).expect("a derivation"));
    let whole = session(DISC)
        .check(&Ask { only_verdicts: true, trajectories: vec!["disc".into()], ..Ask::default() }, &|_, _| {});
    let part = |k: u64| session(DISC).sweep("disc", Part::new(k, 3).expect("a part"), &Limits::default(), &|_, _| {});
    let parts = [2, 3, 1].map(|k| Ok((format!("{k}"), part(k).unwrap_or_else(|e| panic!("{e}")))));
    let joined = session(DISC).join(parts.into_iter(), &Limits::default(), &|_, _| {});
    let text = |found: Result<rederive::Findings, rederive::Failure>| found.unwrap_or_else(|e| panic!("{e}")).json();
    let whole = text(whole);
    assert!(whole.contains("\"boundary\""));
    assert_eq!(text(joined), whole);
}

#[test]
fn a_boundary_has_a_map_of_single_members() {
    let cases = [
        ("boundary = { 'a' = 1 }", "no problem"),
        ("boundary = { 'c' = 1 }", "the map is not over `c`"),
        ("boundary = { 'a' = 0 }", "a width is a number above 0"),
        ("boundary = { 'a' = '1' }", "must be a number"),
        ("boundary = {}", "this boundary has no width"),
        ("boundary = 0.1", "must be a table of symbols and widths"),
    ];
    let with = |line: &str, old: &str, new: &str| match derivation(
        &DISC.replace("boundary = { 'a' = 1e-6, 'b' = 0.01 }", line).replace(old, new),
    ) {
        Err(found) => found,
        Ok(_) => "no problem".to_owned(),
    };
    for (line, expected) in cases {
        let found = with(line, "", "");
        assert!(found.contains(expected), "{line}: {found}");
    }
    let line = "boundary = { 'a' = 1 }";
    assert!(with(line, "map = ['a', 'b']", "").contains("a boundary is that of a map"));
    let third = with(line, "0, -1] }", "0, -1] }, 'c' = { values = [0, 1] }");
    assert!(third.contains("differ in one value alone"), "{third}");
    assert_eq!(with(line, "0, -1] }", "0, -1] }, 'c' = { values = [1] }"), "no problem");
    let drawn =
        with(line, "0, -1] }", "0, -1] }, 'c' = { uniform = [0, 1] } }\ndraws = 1\nseed = 1\nwhere = ['a>0'] #");
    assert!(drawn.contains("draw nothing"), "{drawn}");
    assert!(with(line, "count = 5", "count = 65").contains("more than 64"));
}

#[test]
fn limits_and_constraints_end_a_bisection() {
    let with = |line: &str| {
        let mut derivation =
            derivation(&DISC.replace("map =", &format!("where = ['{line}']\nmap ="))).expect("a derivation");
        run(&mut derivation).claims[0].families[0].map.clone().and_then(|m| m.boundary).expect("a boundary")
    };
    // The ring in which the edge lies has no members.
    let boundary = with(r"(a^2+b^2-1.7)^2>0.01");
    assert_eq!(boundary.crossings.len(), 12);
    assert!(boundary.crossings.iter().all(|c| !c.is_narrow && c.across.1 - c.across.0 + c.up.1 - c.up.0 > 0.01));
}
