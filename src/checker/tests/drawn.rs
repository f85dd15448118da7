//! Random sequents: motions with kinks, flat parts, leaps and holes, and relations that are true of them as they are quantified; then random steps, as in [`attack`](super::attack).
//!
//! **How a sequent is drawn.** Two or three functions and a definition with a hole or a leap; formulas in them, at fixed times, too; the values of each formula at some hundred times. Two formulas that are equal wherever
//! both have values are a premise; equal and with values at all times, a system; equal at the times that random inequalities choose, an assumption; and so on. So each is true by its values.

use super::attack::{Scene, attack};
use super::formula::*;
use super::numbers::{Jet, Numbers};
use crate::*;
use number::Draws;

/// Functions with so many continuous rates.
const LIBRARY: &[(u8, Jet)] = &[
    (2, |t| [2.0 - t * t, -2.0 * t, -2.0, 0.0]),
    (2, |t| [t, 1.0, 0.0, 0.0]),
    (2, |_| [0.0; 4]),
    (2, |_| [1.0, 0.0, 0.0, 0.0]),
    (2, |t| [-t * t, -2.0 * t, -2.0, 0.0]),
    (2, |t| [1.0 - t * t, -2.0 * t, -2.0, 0.0]),
    (2, |t| [t - 1.0, 1.0, 0.0, 0.0]),
    (1, |t| [t * t.abs() / 2.0, t.abs(), t.signum(), 0.0]),
    (1, |t| [(t - 1.0) * (t - 1.0).abs() / 2.0, (t - 1.0).abs(), (t - 1.0).signum(), 0.0]),
    (2, |t| {
        let s = t.max(0.0);
        [s * s * s, 3.0 * s * s, 6.0 * s, 0.0]
    }),
    (2, |t| {
        let s = (1.0 - t).max(0.0);
        [s * s * s, -3.0 * s * s, 6.0 * s, 0.0]
    }),
    (2, |t| {
        let s = (2.0 * (1.0 - t)).max(0.0);
        [2.0 + s * s * s, -6.0 * s * s, 24.0 * s, 0.0]
    }),
    (2, |t| [t * t, 2.0 * t, 2.0, 0.0]),
    (2, |t| [t * t * t, 3.0 * t * t, 6.0 * t, 6.0]),
];

/// Formulas with a hole, a leap or an edge; [`DEFINED`] of them, by chance, is the definition r.
const HOLES: &[&str] =
    &["sqrt(x)", "sqrt(x^2)", "abs(x)", "1/x", "x/y", "atan2(0,x)", "sqrt(x^2+y^2)", "x/abs(x)", "ln(x)", "sqrt(-x^2)"];

fn pool() -> Vec<String> {
    let atoms = [
        "x", "y", "x'", "y'", "x(0)", "y(0)", "x(1)", "y'(0)", "r", "r'", "t", "1", "0", "2", "a", "-1", "r(0)",
        "abs(y)",
    ];
    let mut out: Vec<String> = atoms.iter().map(ToString::to_string).collect();
    for (i, u) in atoms.iter().enumerate().take(13) {
        for v in atoms.iter().take(13).skip(i) {
            out.push(format!("({u})*({v})"));
            out.push(format!("({u})-({v})"));
        }
        out.push(format!("sqrt({u})"));
        out.push(format!("1/({u})"));
    }
    out
}

fn times() -> Vec<f64> {
    (-32..=40).map(|n| f64::from(n) / 16.0).collect()
}

/// The values of formulas at times, and which of them are told.
struct Table {
    formulas: Vec<String>,
    values: Vec<Vec<Option<f64>>>,
}

fn table(sequent: &Sequent, motion: &Numbers) -> Table {
    let mut work = Draft::new(sequent).expect("a sequent");
    let (mut formulas, mut values) = (Vec::new(), Vec::new());
    for text in pool() {
        let Ok(e) = work.context.read(&term(&text)) else { continue };
        let found: Vec<Option<f64>> = times().iter().map(|t| motion.value(&work, e, *t)).collect();
        if found.iter().all(|v| v.is_none_or(|v| !v.is_nan())) {
            formulas.push(text);
            values.push(found);
        }
    }
    Table { formulas, values }
}

impl Table {
    fn draw(&self, draws: &mut Draws) -> usize {
        draws.below(self.formulas.len() as u64) as usize
    }

    /// Two formulas that are equal wherever both have values, among the times that `chosen` says; and have some there.
    fn equation(&self, draws: &mut Draws, chosen: &[bool], everywhere: Option<()>) -> Option<(usize, usize)> {
        for _ in 0..400 {
            let (i, j) = (self.draw(draws), self.draw(draws));
            let mut told = 0;
            let fits = (0..chosen.len()).filter(|k| chosen[*k]).all(|k| match (self.values[i][k], self.values[j][k]) {
                (Some(a), Some(b)) => {
                    told += 1;
                    (a - b).abs() < 1e-12
                }
                _ => everywhere.is_none(),
            });
            if fits && told > 0 && i != j && self.values[i] != self.values[self.formulas.len() - 1] {
                return Some((i, j));
            }
        }
        None
    }

    /// An inequality that is true at some times, or at all.
    fn inequality(&self, draws: &mut Draws, all: bool) -> Option<(String, Vec<bool>)> {
        for _ in 0..200 {
            let (i, j) = (self.draw(draws), self.draw(draws));
            let (sign, test): (&str, fn(f64) -> bool) = match draws.below(4) {
                0 => ("<", |d| d < -1e-9),
                1 => ("≤", |d| d < 1e-12),
                2 => ("#", |d| d.abs() > 1e-9),
                _ => ("≥", |d| d > -1e-12),
            };
            let at = |k: usize| self.values[i][k].zip(self.values[j][k]).map(|(a, b)| test(a - b));
            let count = self.values[i].len();
            let chosen: Vec<bool> = (0..count).map(|k| at(k) == Some(true)).collect();
            let n = chosen.iter().filter(|c| **c).count();
            let fits = if all { (0..count).all(|k| at(k) != Some(false)) && n > 0 } else { n > 0 && n < count };
            if fits && i != j {
                return Some((format!("{}{sign}{}", self.formulas[i], self.formulas[j]), chosen));
            }
        }
        None
    }

    fn text(&self, (i, j): (usize, usize)) -> String {
        format!("{}={}", self.formulas[i], self.formulas[j])
    }
}

/// A random scene.
fn drawn(seed: u64) -> Scene {
    let mut draws = Draws::new(seed);
    let pick = |draws: &mut Draws| LIBRARY[draws.below(LIBRARY.len() as u64) as usize];
    let (x, y) = (pick(&mut draws), pick(&mut draws));
    let symbol = |name: &str, (orders, _): (u8, Jet)| declared(name, SymbolKind::Moves(orders));
    let hole = HOLES[draws.below(HOLES.len() as u64) as usize];
    let mut sequent = sequent("", 0, "0=0").constant("a", ConstantSign::Positive).instant("0").instant("1");
    sequent.symbols.extend([symbol("x", x), symbol("y", y)]);
    let mut sequent = sequent.define("r", hole);
    let motion = Numbers { functions: vec![("x", x.1), ("y", y.1)], constants: vec![("a", 2.0)] };
    let table = table(&sequent, &motion);
    let always = vec![true; times().len()];
    for _ in 0..2 {
        if let Some(pair) = table.equation(&mut draws, &always, None) {
            sequent = sequent.premise(&table.text(pair));
        }
        if draws.below(2) == 0
            && let Some(pair) = table.equation(&mut draws, &always, Some(()))
        {
            sequent = sequent.system(&table.text(pair));
        }
    }
    if draws.below(2) == 0
        && let Some((text, _)) = table.inequality(&mut draws, true)
    {
        sequent = sequent.premise(&text);
    }
    // Other claims, with selectors and hypotheses of their own.
    for _ in 0..2 {
        let (mut selectors, mut chosen) = (Vec::new(), always.clone());
        if let Some((text, times)) = table.inequality(&mut draws, false).filter(|_| draws.below(3) > 0) {
            (selectors, chosen) = (vec![rel(&text)], times);
        }
        let mut hypotheses = Vec::new();
        if draws.below(2) == 0
            && let Some((i, j)) = table.equation(&mut draws, &chosen, None)
        {
            // Its times are those at which its hypotheses have values.
            for (k, c) in chosen.iter_mut().enumerate() {
                *c &= table.values[i][k].is_some() && table.values[j][k].is_some();
            }
            hypotheses.push(rel(&table.text((i, j))));
        }
        if let Some(pair) = table.equation(&mut draws, &chosen, None) {
            let says = rel(&table.text(pair));
            sequent.claims.push(Claimed { name: "c".into(), selectors, hypotheses, says });
        }
    }
    let mut chosen = always;
    if draws.below(4) > 0
        && let Some((text, times)) = table.inequality(&mut draws, false)
    {
        (sequent, chosen) = (sequent.selector(&text), times);
        // What another claim chooses, too, perhaps.
        if let Some(claimed) = sequent.claims.first_mut().filter(|_| draws.below(2) == 0) {
            claimed.selectors = vec![rel(&text)];
            claimed.hypotheses.clear();
            if let Some(pair) = table.equation(&mut draws, &chosen, None) {
                claimed.says = rel(&table.text(pair));
            } else {
                sequent.claims.remove(0);
            }
        }
    }
    for _ in 0..2 {
        if let Some((i, j)) = table.equation(&mut draws, &chosen, None) {
            sequent = sequent.assuming(&table.text((i, j)));
            for (k, c) in chosen.iter_mut().enumerate() {
                *c &= table.values[i][k].is_some() && table.values[j][k].is_some();
            }
        }
    }
    sequent.claim = rel(&table.text((table.draw(&mut draws), table.draw(&mut draws))));
    let mut formulas: Vec<&'static str> = vec!["0", "1", "x", "y", "x'", "r", "t"];
    let named = (0..8).map(|_| table.formulas[table.draw(&mut draws)].clone());
    formulas.extend(named.map(|text| &*Box::leak(text.into_boxed_str())));
    Scene { sequent, motion, formulas: Box::leak(formulas.into_boxed_slice()) }
}

#[test]
fn no_random_step_of_a_random_sequent_proves_what_a_motion_refutes() {
    let number = |name: &str, or: u64| std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(or);
    let (first, scenes) = (number("CHECKER_FIRST", 1), number("CHECKER_SCENES", 60));
    let (mut accepted, mut tried) = (0, 0);
    for seed in first..first + scenes {
        accepted += attack(&drawn(seed), seed, 450);
        tried += 450;
    }
    assert!(accepted > tried / 25, "{accepted} of {tried}");
    println!("{accepted} of {tried} steps accepted");
}
