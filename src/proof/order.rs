//! Signs of expressions in positive parameters, for every order of their sizes.
//!
//! **In:** positive parameters, and requirements: expressions in them that are to be 0, not 0, positive, not negative.
//! **Out:** for each order of size (ties included) whether the requirements hold: for all values in that order, for none, or
//! not settled.
//!
//! In the order x₁ < x₂ = x₃ < … the parameters are u₁, u₁ + u₂, u₁ + u₂, …, with any uᵢ > 0. An expression becomes a fraction
//! of polynomials in the uᵢ. Where all coefficients of a polynomial have one sign, that is its sign for all uᵢ > 0: a proof.
//! Where they do not, nothing is claimed but what exact values at single points show. |·| and √ are taken apart by the sign of
//! what they are taken of.

use super::exact::Exact;
use super::generators::{Generator, Generators};
use super::linear::Combinations;
use super::outcome::Condition;
use super::polynomial::fraction;
use super::witness::{Decimals, Values};
use expr::domain::{self, Term};
use expr::tape::{Slots, Tape};
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational};

/// What is asked of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// = 0.
    Zero,
    /// ≠ 0.
    NotZero,
    /// > 0.
    Positive,
    /// ≥ 0.
    NotNegative,
}

/// A question about positive parameters.
#[derive(Clone, Debug, Default)]
pub struct Question {
    /// The parameters, all positive.
    pub parameters: Vec<Leaf>,
    /// What is given.
    pub assumed: Vec<(Requirement, Expr)>,
    /// What is claimed.
    pub claimed: Vec<(Requirement, Expr)>,
    /// Whether it is claimed that there is a value: otherwise values for which a formula has none do not count.
    pub asserted: bool,
}

/// Groups of equal parameters (by their number), in increasing order.
pub type Order = Vec<Vec<usize>>;

/// Whether requirements hold in one order.
#[derive(Clone, Debug, PartialEq)]
pub enum Fate {
    /// For all values in this order.
    Holds,
    /// For none.
    Fails,
    /// For none, because a formula has no value.
    NoValue,
    /// Not for these values; for others in this order it is not settled.
    FailsAt(Vec<Rational>),
    /// Not settled.
    Open,
}

/// What is found.
#[derive(Clone, Debug, PartialEq)]
pub struct Orders {
    /// Each order of size in which the assumptions hold or may hold, with the fate of what is claimed.
    pub list: Vec<(Order, Fate)>,
    /// Whether the assumptions are settled in every order.
    pub settled: bool,
}

/// Most parameters: of five there are 541 orders.
const MOST_PARAMETERS: usize = 4;
/// Values at the points that are looked at where coefficients do not decide.
const STEPS: [[i64; 4]; 6] = [[1, 1, 1, 1], [1, 3, 1, 5], [5, 1, 2, 1], [2, 7, 9, 1], [9, 1, 1, 8], [1, 1, 12, 3]];

/// All orders of n things, ties included.
fn orders(n: usize) -> Vec<Order> {
    let mut all: Vec<Order> = vec![Vec::new()];
    for x in 0..n {
        let mut next = Vec::new();
        for order in &all {
            for at in 0..=order.len() {
                let mut alone = order.clone();
                alone.insert(at, vec![x]);
                next.push(alone);
                if at < order.len() {
                    let mut tied = order.clone();
                    tied[at].push(x);
                    next.push(tied);
                }
            }
        }
        all = next;
    }
    all.sort();
    all
}

/// The fate of the claim in every order that the assumptions admit; empty where there are too many parameters.
pub fn decide(graph: &mut Graph, question: &Question) -> Orders {
    let n = question.parameters.len();
    let mut out = Orders { list: Vec::new(), settled: true };
    // Whether numbers have values is asked; what they are, the prover knows.
    if n > MOST_PARAMETERS || n == 0 && !question.asserted {
        out.settled = false;
        return out;
    }
    let mut generators = Generators::new(graph);
    let steps: Vec<Expr> =
        (0..n).filter_map(|_| generators.add(Generator::Free)).map(|leaf| graph.leaf(leaf)).collect();
    for order in orders(n) {
        let mut signs = Signs { graph, parameters: &question.parameters, steps: &steps, order: &order };
        match signs.all(&question.assumed) {
            Fate::Holds => {
                let fate = signs.all(&question.claimed);
                if question.asserted || fate != Fate::NoValue {
                    out.list.push((order, fate));
                }
            }
            Fate::Fails | Fate::NoValue => {}
            // The assumptions hold for a part of the values only, perhaps for none.
            Fate::FailsAt(_) | Fate::Open => match signs.all(&question.claimed) {
                // Of what is assumed of numbers nothing may be open: it may be so for no values at all.
                Fate::Holds if signs.numbers_meet(&question.assumed) => out.list.push((order, Fate::Holds)),
                _ => {
                    let fate = signs.counterexample(question).map_or(Fate::Open, Fate::FailsAt);
                    out.settled = false;
                    out.list.push((order, fate));
                }
            },
        }
    }
    out
}

/// What formulas need to have values: all of it, so that they have values where it is met, and nowhere else.
pub fn of_needs(graph: &mut Graph, formulas: &[Expr]) -> Vec<(Requirement, Expr)> {
    let mut out = Vec::new();
    for need in graph.needs_below(formulas.iter().copied()) {
        let one = match (need.term, need.sign) {
            (Term::Unit, _) => within_unit(graph, need.first),
            (_, domain::Sign::Positive) => (Requirement::Positive, need.value),
            (_, domain::Sign::NotNegative) => (Requirement::NotNegative, need.value),
            (_, domain::Sign::NotZero) => (Requirement::NotZero, need.value),
        };
        if !out.contains(&one) {
            out.push(one);
        }
    }
    out
}

/// |e| ≤ 1.
fn within_unit(graph: &mut Graph, e: Expr) -> (Requirement, Expr) {
    let square = match *graph.node(e) {
        Node::Unary(Op::Sqrt, x) => x,
        _ => graph.powi(e, 2),
    };
    let one = graph.integer(1);
    (Requirement::NotNegative, graph.sub(one, square))
}

/// Requirements for formulas to have real values, as far as they are about the given parameters, and about nothing else.
pub fn of_conditions(graph: &mut Graph, conditions: &[Condition], parameters: &[Leaf]) -> Vec<(Requirement, Expr)> {
    let mut out = Vec::new();
    for condition in conditions {
        let (requirement, e) = match *condition {
            Condition::Denominator(e) | Condition::Pivot(e) | Condition::Rate(e) => (Requirement::NotZero, e),
            Condition::Radicand(e) | Condition::Discriminant(e) => (Requirement::NotNegative, e),
            Condition::Positive(e) => (Requirement::Positive, e),
            Condition::Unit(e) => within_unit(graph, e),
        };
        let leaves = graph.leaves([e]);
        if !leaves.is_empty() && leaves.iter().all(|l| parameters.contains(l)) && !out.contains(&(requirement, e)) {
            out.push((requirement, e));
        }
    }
    out
}

/// The sign of an expression in one order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    Zero,
    Positive,
    Negative,
    /// ≥ 0 and ≤ 0 both occur, or cannot be told.
    Unknown,
    NoValue,
}

struct Signs<'a> {
    graph: &'a mut Graph,
    parameters: &'a [Leaf],
    steps: &'a [Expr],
    order: &'a Order,
}

impl Signs<'_> {
    fn all(&mut self, requirements: &[(Requirement, Expr)]) -> Fate {
        let mut fate = Fate::Holds;
        for &(requirement, e) in requirements {
            match self.one(requirement, e) {
                Fate::Holds => {}
                // Something false beside it decides.
                Fate::NoValue => fate = Fate::NoValue,
                Fate::Open if fate == Fate::Holds => fate = Fate::Open,
                Fate::Open => {}
                settled @ (Fate::Fails | Fate::FailsAt(_)) => return settled,
            }
        }
        fate
    }

    fn one(&mut self, requirement: Requirement, e: Expr) -> Fate {
        let inserted = self.inserted(e);
        let sign = match self.plain(inserted) {
            Ok(plain) => self.sign(plain),
            Err(Sign::Unknown) if self.graph.leaves([e]).is_empty() => self.of_number(e),
            Err(sign) => sign,
        };
        let holds = match (requirement, sign) {
            (_, Sign::NoValue) => return Fate::NoValue,
            (_, Sign::Unknown) => return self.sampled(requirement, e),
            (Requirement::Zero, s) => s == Sign::Zero,
            (Requirement::NotZero, s) => s != Sign::Zero,
            (Requirement::Positive, s) => s == Sign::Positive,
            (Requirement::NotNegative, s) => s != Sign::Negative,
        };
        if holds { Fate::Holds } else { Fate::Fails }
    }

    /// Whether all that is required of numbers, in which no parameter occurs, is so.
    fn numbers_meet(&mut self, requirements: &[(Requirement, Expr)]) -> bool {
        requirements.iter().all(|&(r, e)| !self.graph.leaves([e]).is_empty() || self.one(r, e) == Fate::Holds)
    }

    /// The sign of a number, by a ball that contains it.
    fn of_number(&self, e: Expr) -> Sign {
        let ball = Decimals::of(self.graph, &[e]).at(&Values::default()).pop().flatten();
        match ball {
            Some(ball) if ball.value > ball.error => Sign::Positive,
            Some(ball) if -ball.value > ball.error => Sign::Negative,
            _ => Sign::Unknown,
        }
    }

    /// The parameters as sums of steps.
    fn inserted(&mut self, e: Expr) -> Expr {
        let mut values: FastMap<Leaf, Expr> = FastMap::default();
        let mut sum: Option<Expr> = None;
        for (group, &step) in self.order.iter().zip(self.steps) {
            let value = sum.map_or(step, |s| self.graph.add(s, step));
            sum = Some(value);
            for &x in group {
                values.insert(self.parameters[x], value);
            }
        }
        self.graph.replaced(e, |_, leaf| values.get(&leaf).copied())
    }

    /// The expression without |·|; `Err` where a sign below one is not known, or a root or another function is left.
    fn plain(&mut self, e: Expr) -> Result<Expr, Sign> {
        let mut image: FastMap<Expr, Expr> = FastMap::default();
        for node in self.graph.reachable([e]) {
            let new = match *self.graph.node(node) {
                Node::Unary(Op::Abs, a) => {
                    let a = image[&a];
                    match self.sign(a) {
                        Sign::Positive | Sign::Zero => a,
                        Sign::Negative => self.graph.neg(a),
                        other => return Err(other),
                    }
                }
                Node::Unary(Op::Sqrt, a) => {
                    let a = image[&a];
                    match self.sign(a) {
                        Sign::Negative => return Err(Sign::NoValue),
                        Sign::Zero => self.graph.integer(0),
                        // At the top, a root has the sign of its radicand.
                        Sign::Positive if node == e => a,
                        Sign::NoValue => return Err(Sign::NoValue),
                        _ => return Err(Sign::Unknown),
                    }
                }
                Node::Unary(op @ (Op::Neg | Op::Powi(_)), a) => self.graph.unary(op, image[&a]),
                Node::Unary(..) | Node::Pi => return Err(Sign::Unknown),
                Node::Binary(op @ (Op::Add | Op::Sub | Op::Mul), a, b) => self.graph.binary(op, image[&a], image[&b]),
                Node::Binary(Op::Div, a, b) => {
                    let (a, b) = (image[&a], image[&b]);
                    match self.sign(b) {
                        Sign::Zero | Sign::NoValue => return Err(Sign::NoValue),
                        _ => self.graph.div(a, b),
                    }
                }
                Node::Binary(..) => return Err(Sign::Unknown),
                Node::Constant(_) | Node::Leaf(_) => node,
            };
            image.insert(node, new);
        }
        Ok(image[&e])
    }

    /// The sign of a fraction of polynomials in the steps.
    fn sign(&mut self, e: Expr) -> Sign {
        let (top, under) = fraction(self.graph, e);
        match (self.of_polynomial(top), self.of_polynomial(under)) {
            (_, Sign::Zero) => Sign::NoValue,
            (Sign::Zero, Sign::Positive | Sign::Negative) => Sign::Zero,
            (Sign::Unknown | Sign::NoValue, _) | (_, Sign::Unknown | Sign::NoValue) => Sign::Unknown,
            (a, b) if a == b => Sign::Positive,
            _ => Sign::Negative,
        }
    }

    fn of_polynomial(&self, e: Expr) -> Sign {
        let polynomial = Combinations::default().of(self.graph, e);
        let in_steps = |m: &Vec<(Expr, i32)>| m.iter().all(|(base, k)| *k > 0 && self.steps.contains(base));
        if !polynomial.keys().all(in_steps) {
            return Sign::Unknown;
        }
        let positive = polynomial.values().filter(|q| **q > Rational::ZERO).count();
        match (positive, polynomial.len()) {
            (_, 0) => Sign::Zero,
            (p, n) if p == n => Sign::Positive,
            (0, _) => Sign::Negative,
            _ => Sign::Unknown,
        }
    }

    /// Points in this order.
    fn points(&self) -> Vec<Vec<Rational>> {
        let point = |steps: &[i64; 4]| {
            let mut values = vec![Rational::ZERO; self.parameters.len()];
            let mut sum = 0;
            for (group, step) in self.order.iter().zip(steps) {
                sum += step;
                for &x in group {
                    values[x] = Rational::from(sum);
                }
            }
            values
        };
        STEPS.iter().map(point).collect()
    }

    /// Whether a requirement holds at a point, exactly; `None` where that cannot be told.
    fn at(&self, requirement: Requirement, e: Expr, point: &[Rational]) -> Option<bool> {
        let leaves = self.graph.leaves([e]);
        let tape = Tape::compile(self.graph, &leaves, &[e]).ok()?;
        let mut slots: Slots<Exact> = tape.slots(&());
        for (i, leaf) in leaves.iter().enumerate() {
            let x = self.parameters.iter().position(|p| p == leaf)?;
            slots.set(i, Ok(Exact(point[x].clone())));
        }
        tape.run(&(), &mut slots);
        match tape.output(0, &slots) {
            Ok(Exact(v)) => Some(match requirement {
                Requirement::Zero => *v == Rational::ZERO,
                Requirement::NotZero => *v != Rational::ZERO,
                Requirement::Positive => *v > Rational::ZERO,
                Requirement::NotNegative => *v >= Rational::ZERO,
            }),
            // What has no value there says nothing.
            Err(_) => None,
        }
    }

    fn sampled(&self, requirement: Requirement, e: Expr) -> Fate {
        let fails = self.points().into_iter().find(|p| self.at(requirement, e, p) == Some(false));
        fails.map_or(Fate::Open, Fate::FailsAt)
    }

    /// A point in this order at which all assumptions hold and something claimed does not.
    fn counterexample(&self, question: &Question) -> Option<Vec<Rational>> {
        let all =
            |list: &[(Requirement, Expr)], p: &[Rational]| list.iter().all(|&(r, e)| self.at(r, e, p) == Some(true));
        let fails = |p: &[Rational]| question.claimed.iter().any(|&(r, e)| self.at(r, e, p) == Some(false));
        self.points().into_iter().find(|p| all(&question.assumed, p) && fails(p))
    }
}

impl Orders {
    /// The claim holds for all values, in every order that the assumptions admit, and there is one.
    pub fn is_proved(&self) -> bool {
        !self.list.is_empty() && self.list.iter().all(|(_, fate)| *fate == Fate::Holds)
    }

    /// Whether some order is settled, so that a list of orders tells anything.
    pub fn tells(&self) -> bool {
        self.list.iter().any(|(_, fate)| matches!(fate, Fate::Holds | Fate::Fails | Fate::NoValue))
    }

    /// Values for which the assumptions hold and the claim does not.
    pub fn refuting(&self) -> Option<Vec<Rational>> {
        self.list.iter().find_map(|(order, fate)| match fate {
            Fate::FailsAt(point) => Some(point.clone()),
            Fate::Fails | Fate::NoValue => {
                let n = order.iter().map(Vec::len).sum();
                let mut values = vec![Rational::ZERO; n];
                for (size, group) in order.iter().enumerate() {
                    for &x in group {
                        values[x] = Rational::from(size + 1);
                    }
                }
                Some(values)
            }
            Fate::Holds | Fate::Open => None,
        })
    }

    /// In which orders the claim holds, in words, for parameters with these names.
    pub fn words(&self, names: &[String]) -> String {
        let with = |fate: fn(&Fate) -> bool| -> Vec<&Order> {
            self.list.iter().filter(|(_, f)| fate(f)).map(|(order, _)| order).collect()
        };
        let holds = with(|f| *f == Fate::Holds);
        let open = with(|f| matches!(f, Fate::Open | Fate::FailsAt(_)));
        let list = |orders: &[&Order]| orders.iter().map(|o| chain(o, names)).collect::<Vec<_>>().join(" or ");
        let mut out = match (holds.is_empty(), open.is_empty()) {
            (true, true) => return "never".to_owned(),
            (true, false) => "not settled for any order".to_owned(),
            (false, true) if holds.len() == self.list.len() => "always".to_owned(),
            (false, true) => match between(&holds, &self.list, names) {
                Some(words) => format!("exactly when {words}: {}", list(&holds)),
                None => format!("exactly when {}", list(&holds)),
            },
            (false, false) => format!("when {}", list(&holds)),
        };
        if !open.is_empty() {
            out.push_str(&format!("; not for all values, or not settled, when {}", list(&open)));
        }
        out
    }
}

/// x < y = z.
fn chain(order: &Order, names: &[String]) -> String {
    let group = |g: &Vec<usize>| {
        let mut g = g.clone();
        g.sort_unstable();
        g.into_iter().filter_map(|x| names.get(x).cloned()).collect::<Vec<_>>().join(" = ")
    };
    order.iter().map(group).collect::<Vec<_>>().join(" < ")
}

/// "x lies between y and z", where that describes exactly the orders that hold among those considered.
fn between(holds: &[&Order], all: &[(Order, Fate)], names: &[String]) -> Option<String> {
    let [_, _, _] = names else { return None };
    let place = |order: &Order, x: usize| order.iter().position(|g| g.contains(&x)).unwrap_or(usize::MAX);
    for (a, b, c) in [(0, 1, 2), (1, 0, 2), (2, 0, 1)] {
        for kind in ["strictly", "weakly", "weakly, apart"] {
            let inside = |order: &Order| {
                let (a, b, c) = (place(order, a), place(order, b), place(order, c));
                let (low, high) = (b.min(c), b.max(c));
                match kind {
                    "strictly" => low < a && a < high,
                    "weakly" => low <= a && a <= high,
                    _ => low <= a && a <= high && low < high,
                }
            };
            if all.iter().all(|(order, _)| inside(order) == holds.contains(&order)) {
                let (a, b, c) = (&names[a], &names[b], &names[c]);
                return Some(match kind {
                    "strictly" => format!("{a} lies strictly between {b} and {c}"),
                    "weakly" => format!("{a} lies between {b} and {c} or is equal to one of them"),
                    _ => format!("{b} and {c} differ, and {a} lies between them or is equal to one of them"),
                });
            }
        }
    }
    None
}
