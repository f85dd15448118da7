//! Statements about fields whose truth is known by how they were made: solutions first, then equations.
//!
//! Of fields that are polynomials every differential polynomial has a value, a polynomial; that it has this value is a premise that
//! they satisfy. What is added up from derivatives of premises follows, and must not be refuted. What has another value for
//! these fields does not follow, and must not be proved.

use crate::checked::said_by_prover;
use std::collections::BTreeMap;

use rederive::check::{Proposition, prove};
use rederive::derivation::Derivation;
use rederive::number::Draws;

/// A polynomial in x and t: the coefficients of its monomials.
#[derive(Clone, Default)]
struct Polynomial(BTreeMap<[u8; 2], i64>);

impl Polynomial {
    fn constant(c: i64) -> Polynomial {
        Polynomial(BTreeMap::from([([0, 0], c)]))
    }

    fn plus(mut self, other: &Polynomial) -> Polynomial {
        other.0.iter().for_each(|(powers, c)| *self.0.entry(*powers).or_default() += c);
        self
    }

    fn times(&self, other: &Polynomial) -> Polynomial {
        let mut out = Polynomial::default();
        for (a, c) in &self.0 {
            for (b, d) in &other.0 {
                *out.0.entry([a[0] + b[0], a[1] + b[1]]).or_default() += c * d;
            }
        }
        out
    }

    fn derived(&self, by: usize) -> Polynomial {
        let mut out = Polynomial::default();
        for (powers, c) in self.0.iter().filter(|(powers, _)| powers[by] > 0) {
            let mut lower = *powers;
            lower[by] -= 1;
            *out.0.entry(lower).or_default() += c * i64::from(powers[by]);
        }
        out
    }

    fn text(&self) -> String {
        let power = |name: &str, n: u8| if n == 0 { String::new() } else { format!(r"\cdot {name}^{{{n}}}") };
        let terms = self.0.iter().map(|([x, t], c)| format!("({c}){}{}", power("x", *x), power("t", *t)));
        terms.chain(["0".to_owned()]).collect::<Vec<_>>().join("+")
    }
}

struct Maker {
    draws: Draws,
    solutions: [Polynomial; 2],
}

impl Maker {
    fn below(&mut self, n: u64) -> u64 {
        self.draws.bits() % n
    }

    fn coefficient(&mut self) -> i64 {
        [-2, -1, 1, 2, 3][self.below(5) as usize]
    }

    fn solution(&mut self) -> Polynomial {
        let mut out = Polynomial::default();
        for _ in 0..=self.below(3) {
            let powers = [self.below(4) as u8, self.below(3) as u8];
            let c = self.coefficient();
            out = out.plus(&Polynomial(BTreeMap::from([(powers, c)])));
        }
        out
    }

    /// A derivative of a field, and its value.
    fn jet(&mut self) -> (String, Polynomial) {
        let field = self.below(2) as usize;
        let (mut text, mut value) = (["u", "v"][field].to_owned(), self.solutions[field].clone());
        for _ in 0..self.below(4) {
            let by = self.below(2) as usize;
            text = format!(r"(\partial_{}{text})", ["x", "t"][by]);
            value = value.derived(by);
        }
        (text, value)
    }

    /// A sum of products of derivatives, and its value.
    fn sum(&mut self) -> (String, Polynomial) {
        let (mut text, mut value) = (String::from("0"), Polynomial::default());
        let factors = 1 + self.below(2);
        for _ in 0..=self.below(2) {
            let c = self.coefficient();
            let (mut term, mut of) = (format!("+({c})"), Polynomial::constant(c));
            for _ in 0..factors {
                let (jet, value) = self.jet();
                term.push_str(&format!(r"\cdot {jet}"));
                of = of.times(&value);
            }
            text.push_str(&term);
            value = value.plus(&of);
        }
        (text, value)
    }
}

/// What becomes of a statement.
fn standing(claim: &str, given: &[String]) -> &'static str {
    let mut derivation = Derivation::blank();
    let fields = "u(x,t), v(x,t): field".to_owned();
    derivation.declare_typed(&[(fields.clone(), fields)]).unwrap_or_else(|e| panic!("{e:?}"));
    let proposition = Proposition { formula: claim.to_owned(), given: given.to_vec(), throughout: false };
    let account = prove(&mut derivation, &proposition);
    said_by_prover(&account.unwrap_or_else(|e| panic!("{claim}, given {given:?}: {e:?}")))
}

#[test]
fn consequences_are_not_refuted_and_what_has_another_value_is_not_proved() {
    let mut counts: BTreeMap<(bool, &str), u32> = BTreeMap::new();
    let mut maker = Maker { draws: Draws::new(19), solutions: Default::default() };
    for _ in 0..200 {
        maker.solutions = [maker.solution(), maker.solution()];
        let premises: Vec<(String, Polynomial)> = (0..=maker.below(2)).map(|_| maker.sum()).collect();
        let given: Vec<String> = premises.iter().map(|(text, value)| format!("{text}={}", value.text())).collect();
        let follows = maker.below(2) == 0;
        let claim = if follows {
            let terms = premises.iter().map(|(text, value)| {
                let by = [r"\partial_x", r"\partial_t", ""][maker.below(3) as usize];
                format!(r"({})\cdot ({by}({text}-({})))", maker.jet().0, value.text())
            });
            format!("{}=0", terms.collect::<Vec<_>>().join("+"))
        } else {
            let (text, value) = maker.sum();
            let (premise, known) = &premises[0];
            format!("{text}+{premise}-({})={}+1", known.text(), value.text())
        };
        let found = standing(&claim, &given);
        let is_wrong = if follows { found == "refuted" } else { found.starts_with("proved") };
        assert!(!is_wrong, "{found}: {claim}\n  given {given:?}");
        *counts.entry((follows, found)).or_default() += 1;
    }
    // It is not that nothing is decided.
    let of = |follows: bool, word: &str| counts.get(&(follows, word)).copied().unwrap_or(0);
    assert!(of(true, "proved") > 50 && of(false, "refuted") > 30, "{counts:?}");
}
