//! Maps of families: what is counted in their cells, in one run and in parts, on the page and in the report's data.

use rederive::check::{Account, Options, Rigor, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report;

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
    assert_eq!(sums, [family.holds, family.fails, family.not_applicable, family.undecided]);
    assert!(sums[0] > 0 && sums[1] > 0 && sums[2] > 0 && family.rejected == 2, "{family:?}");
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
