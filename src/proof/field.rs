//! The trials: evaluation over GF(p²) for all choices of signs, and the bound.

use super::generators::{Generator, Generators};
use super::growth::{Growth, MARGIN};
use super::outcome::{Options, Reason};
use expr::tape::{Instruction, Slots, Tape};
use expr::{Expr, Graph, Leaf};
use number::{Draws, Finite, FiniteField, NoValue, Number};

/// What is asked of one case, all in normal form (see [`roots`](super::roots)).
#[derive(Clone, Debug, Default)]
pub(super) struct Question {
    /// Must vanish.
    pub(super) residuals: Vec<Expr>,
    /// Premises that are not solved for: a choice of signs is admitted where they vanish.
    pub(super) filters: Vec<Expr>,
    /// Recognised as zero by random points: must vanish.
    pub(super) zeros: Vec<Expr>,
    /// Premises ≠ 0: a choice of signs is admitted where they do not vanish.
    pub(super) assumed: Vec<Expr>,
    /// Denominators: must not vanish.
    pub(super) nonzeros: Vec<Expr>,
    /// Divided by while solving. With them, a choice of signs at which no pivot vanishes, and a denominator does, is void:
    /// the formulas have no value there, and nothing is claimed.
    pub(super) pivots: Option<Vec<Expr>>,
}

/// What the trials say.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Trials {
    /// Every residual vanished on every admitted choice of signs, in every trial.
    Vanish(Bound),
    /// A residual did not vanish: certain.
    Fail { failing: usize, of: usize },
    /// No choice of signs satisfies the premises.
    Contradiction,
    /// The same, but on every admitted choice of signs some formula has no value.
    Void(Bound),
    /// A denominator vanishes at every point tried, for some choice of signs that the premises admit.
    NoValue,
    /// Not settled.
    Unsettled(Reason),
}

/// The error bound of the trials of one case.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Bound {
    pub(super) log2_error: f64,
    pub(super) degree: f64,
    pub(super) height: f64,
    pub(super) primes: Vec<u64>,
    pub(super) signs: usize,
}

impl Bound {
    /// Both together.
    pub(super) fn absorb(&mut self, other: Bound) {
        self.log2_error = sum_log2(self.log2_error, other.log2_error);
        self.degree = self.degree.max(other.degree);
        self.height = self.height.max(other.height);
        self.primes.extend(other.primes);
        self.signs = self.signs.max(other.signs);
    }
}

/// Points tried in one trial, until all roots exist and no denominator vanishes.
const DRAWS: usize = 64;
/// A filter may exclude a choice of signs only by one of these values (numerators and denominators): a constant.
const CONSTANTS: [i64; 4] = [1, 2, 3, 4];
/// How many numbers ±n/d with n, d in [`CONSTANTS`] there are, at most.
const CONSTANT_COUNT: f64 = 32.0;

enum Sheet {
    Excluded,
    Void,
    Holds,
    Fails,
    NoRoot,
    NoValue,
    Unsupported,
    /// A filter is not zero and not constant.
    Partial(usize),
    /// Something recognised as zero is not.
    NotZero,
}

/// Primes drawn in one trial where roots of numbers do not exist for all: √(2 + √2) lies in GF(p²) for half of them.
const PRIMES: usize = 32;

/// Runs the trials of one case.
pub(super) fn trials(
    graph: &Graph,
    generators: &Generators,
    question: &Question,
    options: &Options,
    draws: &mut Draws,
) -> Trials {
    match trials_with(graph, generators, question, options, draws, 1) {
        Trials::Unsettled(Reason::NoPoint) => trials_with(graph, generators, question, options, draws, PRIMES),
        settled => settled,
    }
}

/// A trial draws primes until all roots exist, so many at most. Each of them may be one that hides something: their number
/// counts in the bound.
fn trials_with(
    graph: &Graph,
    generators: &Generators,
    question: &Question,
    options: &Options,
    draws: &mut Draws,
    most_primes: usize,
) -> Trials {
    let roots: Vec<Expr> =
        [&question.residuals, &question.filters, &question.zeros, &question.assumed, &question.nonzeros]
            .into_iter()
            .chain(&question.pivots)
            .flatten()
            .copied()
            .collect();
    let leaves = graph.leaves(roots.iter().copied());
    let Ok(tape) = Tape::compile(graph, &leaves, &roots) else { return Trials::Unsettled(Reason::TooLarge) };
    let (signs, free): (Vec<usize>, Vec<usize>) =
        (0..leaves.len()).partition(|&i| generators.get(leaves[i]) == Some(&Generator::Sign));
    if signs.len() > options.most_signs.min(20) as usize {
        return Trials::Unsettled(Reason::TooManyRoots(signs.len()));
    }
    let mut tested = question.residuals.len() + question.filters.len() + question.zeros.len() + question.assumed.len();
    if question.pivots.is_some() {
        tested += question.nonzeros.len();
    }
    let Some((degree, height)) = bounds(&tape, &leaves, generators, tested, signs.len()) else {
        return Trials::Unsettled(Reason::TooLarge);
    };
    // One trial: the prime divides all coefficients of a norm, or one of the points drawn is a zero of it (or a filter took
    // one of the listed values there).
    let primes = height / FiniteField::LOG2_P * power_of_two(-FiniteField::LOG2_PRIMES);
    let points = DRAWS as f64 * (1.0 + CONSTANT_COUNT) * degree * power_of_two(-FiniteField::LOG2_P);
    let each = log2_above((primes + points) * MARGIN * most_primes as f64);
    if each.is_nan() || each >= -8.0 {
        return Trials::Unsettled(Reason::Bound(each));
    }
    let count = (options.target_log2_error / each).ceil().max(1.0) as usize;
    let is_sign = |l: Leaf| generators.get(l) == Some(&Generator::Sign);
    let rigid: Vec<bool> = question.filters.iter().map(|&e| graph.leaves([e]).into_iter().all(is_sign)).collect();
    let mut bound = Bound { log2_error: each * count as f64, degree, height, primes: Vec::new(), signs: signs.len() };
    let mut held = false;
    let choices = Choices::new(&tape, signs);
    // Primes drawn in the present trial.
    let mut drawn = 0;
    while bound.primes.len() < count {
        drawn += 1;
        let field = FiniteField::draw(draws);
        bound.primes.push(field.prime());
        let mut slots: Slots<Finite> = tape.slots(&field);
        let mut last = Trials::Unsettled(Reason::NoPoint);
        let mut passed = false;
        for _ in 0..DRAWS {
            for &i in &free {
                slots.set(i, Ok(field.draw_element(draws)));
            }
            match all_sheets(&tape, &field, &mut slots, &choices, (question, &rigid)) {
                None => {
                    (passed, held) = (true, true);
                    break;
                }
                Some(Trials::Void(_)) => {
                    passed = true;
                    break;
                }
                Some(settled @ (Trials::Fail { .. } | Trials::Contradiction)) => return settled,
                Some(Trials::Unsettled(reason)) if reason != Reason::NoPoint => return Trials::Unsettled(reason),
                Some(again) => last = again,
            }
        }
        if !passed && last == Trials::Unsettled(Reason::NoPoint) && drawn < most_primes {
            bound.primes.pop();
            continue;
        }
        if !passed {
            return last;
        }
        drawn = 0;
    }
    if held { Trials::Vanish(bound) } else { Trials::Void(bound) }
}

/// The choices of signs, in an order in which little has to be computed again from one to the next.
struct Choices {
    /// The inputs that are signs: the first changes most often.
    signs: Vec<usize>,
    /// Instructions that depend on no sign.
    fixed: Vec<Instruction>,
    /// For each sign the instructions that depend on it, and on none before it.
    of: Vec<Vec<Instruction>>,
}

impl Choices {
    fn new(tape: &Tape, mut signs: Vec<usize>) -> Choices {
        // For each slot a bit for every sign that it depends on, by the position in `signs`.
        let dependence = |signs: &[usize]| {
            let mut on = vec![0u32; tape.slot_count()];
            for (bit, &i) in signs.iter().enumerate() {
                on[i] = 1 << bit;
            }
            for step in tape.instructions() {
                on[step.out as usize] = on[step.a as usize] | on[step.b as usize];
            }
            on
        };
        // The signs on which most depends change least often.
        let on = dependence(&signs);
        let load = |bit: usize| on.iter().filter(|&&o| o >> bit & 1 == 1).count();
        let mut loads: Vec<(usize, usize)> = signs.iter().enumerate().map(|(bit, &i)| (load(bit), i)).collect();
        loads.sort_unstable();
        signs = loads.into_iter().map(|(_, i)| i).collect();
        let on = dependence(&signs);
        let (mut fixed, mut of) = (Vec::new(), vec![Vec::new(); signs.len()]);
        for &step in tape.instructions() {
            match on[step.out as usize].trailing_zeros() as usize {
                first if first < signs.len() => of[first].push(step),
                _ => fixed.push(step),
            }
        }
        Choices { signs, fixed, of }
    }

    fn count(&self) -> u64 {
        1 << self.signs.len()
    }

    /// Everything for one choice, given that the one before it was the last that was run.
    fn run(&self, choice: u64, tape: &Tape, field: &FiniteField, slots: &mut Slots<Finite>) {
        for (bit, &i) in self.signs.iter().enumerate() {
            slots.set(i, Ok(field.integer(if choice >> bit & 1 == 0 { 1 } else { -1 })));
        }
        // The bits in which a number differs from the one before are those up to its lowest one.
        let changed = match choice {
            0 => {
                tape.run_some(field, slots, &self.fixed);
                self.signs.len()
            }
            _ => choice.trailing_zeros() as usize + 1,
        };
        // What depends on an early sign may depend on what depends on late ones only.
        for steps in self.of[..changed].iter().rev() {
            tape.run_some(field, slots, steps);
        }
    }
}

/// One point, all choices of signs; `None` when everything holds.
fn all_sheets(
    tape: &Tape,
    field: &FiniteField,
    slots: &mut Slots<Finite>,
    choices: &Choices,
    (question, rigid): (&Question, &[bool]),
) -> Option<Trials> {
    let (mut holds, mut fails, mut void, mut no_value) = (0, 0, false, false);
    for choice in 0..choices.count() {
        choices.run(choice, tape, field, slots);
        match sheet(tape, field, slots, question, rigid) {
            Sheet::Excluded => {}
            Sheet::Holds => holds += 1,
            Sheet::Void => void = true,
            Sheet::Fails => fails += 1,
            Sheet::NoValue => no_value = true,
            // Whatever the other choices say.
            Sheet::Partial(filter) => return Some(Trials::Unsettled(Reason::Unsolved(question.filters[filter]))),
            Sheet::NoRoot => return Some(Trials::Unsettled(Reason::NoPoint)),
            Sheet::Unsupported => return Some(Trials::Unsettled(Reason::TooLarge)),
            Sheet::NotZero => return Some(Trials::Unsettled(Reason::Coincidence)),
        }
    }
    if fails > 0 {
        return Some(Trials::Fail { failing: fails, of: holds + fails });
    }
    if no_value {
        return Some(Trials::NoValue);
    }
    match (holds, void) {
        (0, false) => Some(Trials::Contradiction),
        (0, true) => Some(Trials::Void(Bound::default())),
        _ => None,
    }
}

fn sheet(tape: &Tape, field: &FiniteField, slots: &Slots<Finite>, question: &Question, rigid: &[bool]) -> Sheet {
    let mut at = 0;
    let mut next = || {
        at += 1;
        tape.output(at - 1, slots).copied()
    };
    let residuals: Vec<_> = question.residuals.iter().map(|_| next()).collect();
    let mut missing = None;
    let mut unsolved = None;
    for (filter, &rigid) in rigid.iter().enumerate() {
        match next() {
            Ok(v) if v.is_zero() => {}
            Ok(v) if rigid || is_listed(field, v) => return Sheet::Excluded,
            Ok(_) => unsolved = Some(filter),
            Err(reason) => missing = missing.or(Some(reason)),
        }
    }
    let (mut not_zero, mut excluded) = (false, false);
    for _ in &question.zeros {
        match next() {
            Ok(v) => not_zero |= !v.is_zero(),
            Err(reason) => missing = missing.or(Some(reason)),
        }
    }
    for _ in &question.assumed {
        match next() {
            Ok(v) => excluded |= v.is_zero(),
            Err(reason) => missing = missing.or(Some(reason)),
        }
    }
    if excluded {
        return Sheet::Excluded;
    }
    let mut vanishing = false;
    for _ in &question.nonzeros {
        match next() {
            Ok(v) if v.is_zero() => {
                vanishing = true;
                missing = missing.or(Some(NoValue::OutOfDomain));
            }
            Ok(_) => {}
            Err(reason) => missing = missing.or(Some(reason)),
        }
    }
    if let Some(pivots) = &question.pivots
        && vanishing
        && !not_zero
        && pivots.iter().all(|_| next().is_ok_and(|v| !v.is_zero()))
    {
        return Sheet::Void;
    }
    let mut fails = false;
    for residual in residuals {
        match residual {
            Ok(v) => fails |= !v.is_zero(),
            Err(reason) => missing = missing.or(Some(reason)),
        }
    }
    match missing {
        Some(NoValue::Unsupported) => Sheet::Unsupported,
        Some(NoValue::Indeterminate) => Sheet::NoRoot,
        Some(NoValue::OutOfDomain) => Sheet::NoValue,
        None if not_zero => Sheet::NotZero,
        None => match unsolved {
            // What holds without a premise holds with it.
            _ if !fails => Sheet::Holds,
            Some(filter) => Sheet::Partial(filter),
            None => Sheet::Fails,
        },
    }
}

/// Whether v = ±n/d with n, d among [`CONSTANTS`].
fn is_listed(field: &FiniteField, v: Finite) -> bool {
    let small = |w: Finite| CONSTANTS.iter().any(|&n| w == field.integer(n) || w == field.integer(-n));
    v.is_in_prime_field() && CONSTANTS.iter().any(|&d| small(field.product(v, field.integer(d))))
}

/// Degree and height of the norms: 2ᵏ times the sums over everything tested.
fn bounds(tape: &Tape, leaves: &[Leaf], generators: &Generators, tested: usize, signs: usize) -> Option<(f64, f64)> {
    let mut slots: Slots<Growth> = tape.slots(&());
    for (i, &leaf) in leaves.iter().enumerate() {
        let growth = if generators.get(leaf) == Some(&Generator::Sign) { Growth::SIGN } else { Growth::FREE };
        slots.set(i, Ok(growth));
    }
    tape.run(&(), &mut slots);
    let (mut degree, mut height) = (1.0, 1.0);
    for output in 0..tested {
        let g = tape.output(output, &slots).ok()?;
        degree += g.top_degree;
        height += g.top_bits;
    }
    let norm = power_of_two(signs as f64);
    (f64::is_finite(degree) && f64::is_finite(height)).then_some((degree * norm, height * norm))
}

/// 2ⁿ for a whole n of moderate size.
fn power_of_two(n: f64) -> f64 {
    let whole = n.abs() as u32;
    let magnitude = (0..whole).fold(1.0, |power, _| 2.0 * power);
    if n < 0.0 { 1.0 / magnitude } else { magnitude }
}

/// An upper bound of log₂ x for x > 0; not a number or infinite where x is.
fn log2_above(x: f64) -> f64 {
    let mut ln = 0.0;
    match Number::ln(&mut ln, &(), &x) {
        Ok(()) => ln / std::f64::consts::LN_2 + 1e-6,
        Err(_) => f64::INFINITY,
    }
}

/// An upper bound of log₂(2ᵃ + 2ᵇ).
pub(super) fn sum_log2(a: f64, b: f64) -> f64 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let whole = (high - low).floor().min(60.0) as i32;
    high + (1.45 / (1u64 << whole) as f64).min(1.0)
}
