//! Taylor series of the solutions of a system, several motions side by side.
//!
//! **In:** the steps of a program that computes the rates of states, and which of its slots move; then times, states and
//! constants, one in each lane. **Out:** the series of all slots. **Guaranteed:** a lane is, bit for bit, what it is alone, in
//! however many lanes and on every processor: the same operations of IEEE 754 in the same order, no fused ones. What is not
//! finite becomes NaN in its lane and stays so.
//!
//! **Why this way:** nearly all work is sums of products, Σ aⱼ·bₖ₋ⱼ, one for each product of two series and each order. Products
//! with a factor in common are summed in one loop, which reads that factor once, and whose sums do not wait for each other.
//! What kind of step comes next is asked once for all steps of a kind and an order, and all orders are one call into the code
//! for the registers of this processor. Operations without a loop of their own are carried out on [`Jet`]s.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use super::{Instruction, Jet, Lanes, Op, Orders, Scalar};
use pulp::{Arch, Simd, WithSimd};

/// How the coefficients of a result are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// A multiple, by a constant.
    Multiple,
    /// A part, by a constant.
    Share,
    Negative,
    Sum,
    Difference,
    /// A product of two series. All of a row have the first factor in common.
    Product,
    Quotient,
    Root,
    /// On jets.
    Other,
}

/// Steps of one kind that do not need each other.
#[derive(Clone, Debug, PartialEq)]
struct Row {
    kind: Kind,
    /// First argument, second argument, result; of what is done on jets the number of the instruction in place of the first.
    steps: Vec<[usize; 3]>,
}

/// How the series of a system are grown. The inputs are the time, the states, and what does not move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recurrences {
    slots: usize,
    rows: Vec<Row>,
    /// The steps that are carried out on jets.
    others: Vec<Instruction>,
    /// The slots of the rates of the states.
    rates: Vec<usize>,
}

/// Most products in one loop: their sums in all lanes fill the registers, four for each product at most.
const TOGETHER: usize = 3;

/// How a step is carried out where its arguments move or do not.
fn kind(step: &Instruction, moves: &[bool]) -> Kind {
    let (a, b) = (moves[step.a as usize], moves[step.b as usize]);
    match step.op {
        Op::Neg => Kind::Negative,
        Op::Add => Kind::Sum,
        Op::Sub => Kind::Difference,
        Op::Mul if a && b => Kind::Product,
        Op::Powi(2) => Kind::Product,
        Op::Mul => Kind::Multiple,
        Op::Div if b => Kind::Quotient,
        Op::Div => Kind::Share,
        Op::Sqrt => Kind::Root,
        // On jets, which know every operation.
        _ => Kind::Other,
    }
}

impl Recurrences {
    /// For a program whose slot 0 is the time, followed by as many states as there are `rates`, the slots of their rates.
    /// `moves` says of every slot whether it depends on time or state.
    pub fn new(steps: &[Instruction], moves: &[bool], rates: Vec<usize>) -> Recurrences {
        let mut depth = vec![0_usize; moves.len()];
        let mut others = Vec::new();
        let mut ordered: Vec<(usize, Kind, [usize; 3])> = Vec::new();
        for step in steps.iter().filter(|step| moves[step.out as usize]) {
            let [mut a, mut b, out] = [step.a as usize, step.b as usize, step.out as usize];
            let kind = kind(step, moves);
            depth[out] = 1 + depth[a].max(depth[b]);
            match kind {
                // The constant first.
                Kind::Multiple if moves[a] => std::mem::swap(&mut a, &mut b),
                Kind::Other => {
                    a = others.len();
                    others.push(*step);
                }
                Kind::Multiple
                | Kind::Share
                | Kind::Negative
                | Kind::Sum
                | Kind::Difference
                | Kind::Product
                | Kind::Quotient
                | Kind::Root => {}
            }
            ordered.push((depth[out], kind, [a, b, out]));
        }
        ordered.sort_by_key(|(depth, kind, _)| (*depth, *kind));
        let mut rows = Vec::new();
        for level in ordered.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
            let kind = level[0].1;
            let steps: Vec<[usize; 3]> = level.iter().map(|(_, _, step)| *step).collect();
            match kind {
                Kind::Product => rows.extend(with_common_factors(steps)),
                _ => rows.push(Row { kind, steps }),
            }
        }
        Recurrences { slots: moves.len(), rows, others, rates }
    }
}

/// Products, each row with a factor in common: first the factor that most of them have, of those that occur equally often the first. In
/// about as many operations as there are products.
fn with_common_factors(products: Vec<[usize; 3]>) -> Vec<Row> {
    let mut with: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (at, &[a, b, _]) in products.iter().enumerate() {
        with.entry(a).or_default().push(at);
        if a != b {
            with.entry(b).or_default().push(at);
        }
    }
    let mut left: BTreeMap<usize, usize> = with.iter().map(|(&slot, all)| (slot, all.len())).collect();
    let mut queue: BTreeSet<(Reverse<usize>, usize)> = left.iter().map(|(&slot, &n)| (Reverse(n), slot)).collect();
    let mut done = vec![false; products.len()];
    let mut rows = Vec::new();
    while let Some((_, common)) = queue.pop_first() {
        let mut turned: Vec<[usize; 3]> = Vec::new();
        for &at in with.get(&common).into_iter().flatten() {
            if std::mem::replace(&mut done[at], true) {
                continue;
            }
            let [a, b, out] = products[at];
            let (first, other) = if a == common { (a, b) } else { (b, a) };
            turned.push([first, other, out]);
            let count = left.get_mut(&other).filter(|_| other != common);
            if let Some(count) = count {
                queue.remove(&(Reverse(*count), other));
                *count -= 1;
                if *count > 0 {
                    queue.insert((Reverse(*count), other));
                }
            }
        }
        rows.extend(turned.chunks(TOGETHER).map(|some| Row { kind: Kind::Product, steps: some.to_vec() }));
    }
    rows
}

/// An operation that is carried out on jets: its arguments and its result.
#[derive(Clone, Debug)]
struct OnJets<const N: usize> {
    a: Jet<Lanes<N>>,
    b: Jet<Lanes<N>>,
    out: Jet<Lanes<N>>,
}

/// The series of the slots of a program in several lanes.
#[derive(Clone, Debug)]
pub struct Growth<const N: usize> {
    /// Room for so many coefficients.
    room: usize,
    /// The coefficients of a slot, then those of the next.
    values: Vec<Lanes<N>>,
    others: Vec<OnJets<N>>,
    /// 1/k.
    shares: Vec<f64>,
}

impl<const N: usize> Growth<N> {
    /// Room for series up to an order.
    pub fn new(of: &Recurrences, order: usize) -> Growth<N> {
        let room = order + 1;
        let orders = Orders::all(order);
        let blank = || Jet::constant(Lanes::ZERO, &orders);
        let others = of.others.iter().map(|_| OnJets { a: blank(), b: blank(), out: blank() }).collect();
        let shares = (0..=order).map(|k| 1.0 / k as f64).collect();
        Growth { room, values: vec![Lanes::ZERO; of.slots * room], others, shares }
    }

    /// What is in a slot at order 0: to be set for everything that is not computed.
    #[inline]
    pub fn start_mut(&mut self, slot: usize) -> &mut Lanes<N> {
        &mut self.values[slot * self.room]
    }

    /// Coefficient `k` of a slot.
    #[inline]
    pub fn coefficient(&self, slot: usize, k: usize) -> &Lanes<N> {
        &self.values[slot * self.room + k]
    }

    /// The first coefficients of a slot.
    #[inline]
    pub fn coefficients(&self, slot: usize) -> &[Lanes<N>] {
        &self.values[slot * self.room..(slot + 1) * self.room]
    }

    /// Grows the series of the states up to an order for which there is room, those of other slots to one less, from the time,
    /// the states and the constants.
    pub fn grow(&mut self, of: &Recurrences, order: usize) {
        let order = order.min(self.room - 1);
        dispatch(self, of, order);
    }
}

/// Grows with the widest registers that the lanes fill.
fn dispatch<const N: usize>(growth: &mut Growth<N>, of: &Recurrences, order: usize) {
    #[cfg(target_arch = "x86_64")]
    if N.is_multiple_of(4)
        && !N.is_multiple_of(8)
        && let Some(simd) = pulp::x86::V3::try_new()
    {
        return pulp::Simd::vectorize(simd, Grow { of, order, growth });
    }
    Arch::new().dispatch(Grow { of, order, growth });
}

/// Growing, with some instruction set.
struct Grow<'g, const N: usize> {
    of: &'g Recurrences,
    order: usize,
    growth: &'g mut Growth<N>,
}

impl<const N: usize> WithSimd for Grow<'_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Grow { of, order, growth } = self;
        if N.is_multiple_of(S::F64_LANES) {
            grow(simd, of, order, growth);
        } else {
            grow(pulp::Scalar::new(), of, order, growth);
        }
    }
}

/// A register of lanes: that with this number.
#[inline(always)]
fn part<S: Simd, const N: usize>(x: &Lanes<N>, register: usize) -> S::f64s {
    S::as_simd_f64s(&x.0).0[register]
}

/// Writes a result, of which there is a function of the register; what is not finite is NaN.
#[inline(always)]
fn put<S: Simd, const N: usize>(simd: S, out: &mut Lanes<N>, of: impl Fn(usize) -> S::f64s) {
    for (register, out) in S::as_mut_simd_f64s(&mut out.0).0.iter_mut().enumerate() {
        let x = of(register);
        // x − x is 0, or NaN where x is not finite.
        *out = simd.add_f64s(x, simd.sub_f64s(x, x));
    }
}

/// Σⱼ bⱼ·aₖ₋ⱼ for one a and several b of one length, register by register; there are no more registers than lanes. A macro, so that
/// each slice has a name of its own, whose length is looked at once.
macro_rules! products {
    ($simd:ident, $a:expr, $($b:ident $sum:ident),+) => {{
        let n = $a.len();
        let a = &$a[..n];
        $(let $b = &$b[..n];)+
        $(let mut $sum = [$simd.splat_f64s(0.0); N];)+
        for j in 0..n {
            let a = &a[n - 1 - j];
            $(let $b = &$b[j];)+
            for register in 0..N / S::F64_LANES {
                let x = part::<S, N>(a, register);
                $($sum[register] = $simd.add_f64s($sum[register], $simd.mul_f64s(part::<S, N>($b, register), x));)+
            }
        }
        [$($sum),+]
    }};
}

/// Coefficient `k` of products with a factor in common.
#[inline(always)]
fn product_row<S: Simd, const N: usize>(
    simd: S,
    values: &mut [Lanes<N>],
    (room, k): (usize, usize),
    steps: &[[usize; 3]],
) {
    let Some(&[common, ..]) = steps.first() else { return };
    macro_rules! row {
        ($($step:ident $b:ident $sum:ident),+) => {{
            let a = &values[common * room..][..k + 1];
            $(let $b = &values[$step[1] * room..][..k + 1];)+
            let [$($sum),+] = products!(simd, a, $($b $sum),+);
            $(put::<S, N>(simd, &mut values[$step[2] * room + k], |register| $sum[register]);)+
        }};
    }
    match steps {
        [s1] => row!(s1 b1 x1),
        [s1, s2] => row!(s1 b1 x1, s2 b2 x2),
        [s1, s2, s3] => row!(s1 b1 x1, s2 b2 x2, s3 b3 x3),
        // No row is longer.
        _ => {}
    }
}

#[inline(always)]
fn grow<S: Simd, const N: usize>(simd: S, of: &Recurrences, order: usize, growth: &mut Growth<N>) {
    let room = growth.room;
    let values = &mut growth.values[..of.slots * room];
    if order > 0 {
        values[1] = Lanes::splat(1.0);
    }
    for k in 0..order {
        for row in &of.rows {
            grow_row(simd, row, values, (room, k), of, &mut growth.others);
        }
        let share = simd.splat_f64s(growth.shares[k + 1]);
        for (state, &rate) in of.rates.iter().enumerate() {
            let x = values[rate * room + k];
            let of = |register| simd.mul_f64s(part::<S, N>(&x, register), share);
            put::<S, N>(simd, &mut values[(1 + state) * room + k + 1], of);
        }
    }
}

/// Coefficient `k` of an operation that is carried out on jets.
#[inline(never)]
fn other<const N: usize>(
    of: &Recurrences,
    at: usize,
    values: &mut [Lanes<N>],
    (room, k): (usize, usize),
    others: &mut [OnJets<N>],
) {
    let (step, OnJets { a, b, out }) = (&of.others[at], &mut others[at]);
    a.set_coefficient(k, values[step.a as usize * room + k]);
    b.set_coefficient(k, values[step.b as usize * room + k]);
    // No operation on lanes fails as a whole; what the type does not know has no value.
    let found = step.op.apply(&Orders::only(k, room - 1), out, a, b);
    values[step.out as usize * room + k] = if found.is_ok() { out.coefficient(k) } else { Lanes::INVALID };
}

/// Coefficient `k` of the results of a row.
#[inline(always)]
fn grow_row<S: Simd, const N: usize>(
    simd: S,
    row: &Row,
    values: &mut [Lanes<N>],
    (room, k): (usize, usize),
    of: &Recurrences,
    others: &mut [OnJets<N>],
) {
    // For each step two coefficients in, one out.
    macro_rules! each {
        (|[$first:expr, $second:expr]: [$a:ident, $b:ident]| $value:expr) => {
            for &[first, second, out] in &row.steps {
                let ($a, $b) = (values[first * room + $first], values[second * room + $second]);
                put::<S, N>(simd, &mut values[out * room + k], |register| {
                    let ($a, $b) = (part::<S, N>(&$a, register), part::<S, N>(&$b, register));
                    $value
                });
            }
        };
        (|$a:ident| $value:expr) => {
            for &[first, _, out] in &row.steps {
                let $a = values[first * room + k];
                put::<S, N>(simd, &mut values[out * room + k], |register| {
                    let $a = part::<S, N>(&$a, register);
                    $value
                });
            }
        };
    }
    match row.kind {
        Kind::Multiple => each!(|[0, k]: [a, b]| simd.mul_f64s(a, b)),
        Kind::Share => each!(|[k, 0]: [a, b]| simd.div_f64s(a, b)),
        Kind::Negative => each!(|a| simd.neg_f64s(a)),
        Kind::Sum => each!(|[k, k]: [a, b]| simd.add_f64s(a, b)),
        Kind::Difference => each!(|[k, k]: [a, b]| simd.sub_f64s(a, b)),
        Kind::Product => product_row(simd, values, (room, k), &row.steps),
        // x·b = a.
        Kind::Quotient => {
            for &[a, b, out] in &row.steps {
                let (x, b) = (&values[out * room..out * room + k], &values[b * room..b * room + k + 1]);
                let (a, b0, b1) = (values[a * room + k], b[0], &b[1..]);
                let [known] = products!(simd, x, b1 sum);
                put::<S, N>(simd, &mut values[out * room + k], |register| {
                    let rest = simd.sub_f64s(part::<S, N>(&a, register), known[register]);
                    simd.div_f64s(rest, part::<S, N>(&b0, register))
                });
            }
        }
        Kind::Root if k == 0 => each!(|a| simd.sqrt_f64s(a)),
        // x·x = a.
        Kind::Root => {
            for &[a, _, out] in &row.steps {
                let x = &values[out * room..out * room + k];
                let (a, x0, x1) = (values[a * room + k], x[0], &x[1..]);
                let [known] = products!(simd, x1, x1 sum);
                put::<S, N>(simd, &mut values[out * room + k], |register| {
                    let rest = simd.sub_f64s(part::<S, N>(&a, register), known[register]);
                    let first = part::<S, N>(&x0, register);
                    simd.div_f64s(rest, simd.add_f64s(first, first))
                });
            }
        }
        Kind::Other => {
            for &[at, _, _] in &row.steps {
                other(of, at, values, (room, k), others);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Draws, Number};

    /// The rows, found slowly: each time the factor is looked for that most of the products have.
    fn with_common_factors_slowly(mut left: Vec<[usize; 3]>) -> Vec<Vec<[usize; 3]>> {
        let mut rows = Vec::new();
        while !left.is_empty() {
            let count = |slot: usize| left.iter().filter(|[a, b, _]| *a == slot || *b == slot).count();
            let factors = left.iter().flat_map(|[a, b, _]| [*a, *b]);
            let Some(common) = factors.min_by_key(|&slot| (usize::MAX - count(slot), slot)) else { break };
            let (with, without): (Vec<_>, Vec<_>) =
                left.into_iter().partition(|[a, b, _]| *a == common || *b == common);
            left = without;
            let turned: Vec<_> =
                with.into_iter().map(|[a, b, out]| if a == common { [a, b, out] } else { [b, a, out] }).collect();
            rows.extend(turned.chunks(TOGETHER).map(<[_]>::to_vec));
        }
        rows
    }

    #[test]
    fn common_factors_are_those_that_most_products_have() {
        let mut seed = 1_u64;
        let mut draw = |below: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((seed >> 33) % below) as usize
        };
        for round in 0..200 {
            let products: Vec<[usize; 3]> = (0..round).map(|out| [draw(12), draw(12), 100 + out]).collect();
            let rows: Vec<_> = with_common_factors(products.clone()).into_iter().map(|row| row.steps).collect();
            assert_eq!(rows, with_common_factors_slowly(products));
        }
        // All products of 400 factors, which took minutes.
        let all = (0..400).flat_map(|a| (0..=a).map(move |b| [a, b, 400 + 400 * a + b])).collect();
        assert_eq!(with_common_factors(all).iter().map(|row| row.steps.len()).sum::<usize>(), 400 * 401 / 2);
    }

    const DEGREE: usize = 12;
    /// Time, states and constants.
    const INPUTS: u32 = 6;
    const STATES: usize = 3;

    /// A random program, and which of its slots move.
    fn program(draws: &mut Draws) -> (Vec<Instruction>, Vec<bool>) {
        let ops = [
            Op::Add,
            Op::Sub,
            Op::Mul,
            Op::Mul,
            Op::Mul,
            Op::Div,
            Op::Neg,
            Op::Powi(2),
            Op::Sqrt,
            Op::Sin,
            Op::Powi(3),
            Op::Abs,
            Op::Arctan2,
            Op::DirectionCosine,
        ];
        let mut moves = vec![true, true, true, true, false, false];
        let steps: Vec<Instruction> = (INPUTS..INPUTS + 14)
            .map(|out| {
                let (a, b) = (draws.below(u64::from(out)) as u32, draws.below(u64::from(out)) as u32);
                let op = ops[draws.below(ops.len() as u64) as usize];
                let b = if op.arity() == 1 { a } else { b };
                moves.push(moves[a as usize] || moves[b as usize]);
                Instruction { op, a, b, out }
            })
            .collect();
        (steps, moves)
    }

    /// All series of a program in lanes, from inputs one after the other.
    fn grown<const N: usize>(
        of: &Recurrences,
        steps: &[Instruction],
        moves: &[bool],
        inputs: [[f64; 6]; N],
    ) -> Growth<N> {
        let mut growth = Growth::<N>::new(of, DEGREE);
        for slot in 0..INPUTS as usize {
            *growth.start_mut(slot) = Lanes(inputs.map(|of| of[slot]));
        }
        for step in steps.iter().filter(|step| !moves[step.out as usize]) {
            let (a, b) = (*growth.start_mut(step.a as usize), *growth.start_mut(step.b as usize));
            step.op.apply(&(), growth.start_mut(step.out as usize), &a, &b).unwrap();
        }
        growth.grow(of, DEGREE);
        growth
    }

    /// The same by the recurrences of jets; `None` where one has no value.
    fn by_jets(of: &Recurrences, steps: &[Instruction], inputs: &[f64; 6]) -> Option<Vec<Jet<f64>>> {
        let orders = Orders::all(DEGREE);
        let count = INPUTS as usize + steps.len();
        let mut values: Vec<Jet<f64>> = (0..count).map(|_| Jet::constant(0.0, &orders)).collect();
        for (slot, &x) in inputs.iter().enumerate() {
            values[slot] = Jet::constant(x, &orders);
        }
        values[0].set_coefficient(1, 1.0);
        let mut missing = vec![None; count];
        for k in 0..DEGREE {
            Jet::run(&Orders::only(k, DEGREE), &mut values, &mut missing, steps);
            if missing.iter().any(Option::is_some) {
                return None;
            }
            for (state, &rate) in of.rates.iter().enumerate() {
                let c = values[rate].coefficient(k) / (k + 1) as f64;
                values[1 + state].set_coefficient(k + 1, c);
            }
        }
        Some(values)
    }

    #[test]
    fn lanes_are_what_they_are_alone_and_what_jets_are_up_to_rounding() {
        let mut draws = Draws::new(23);
        let (mut same, mut near, mut far) = (0, 0, 0);
        for _ in 0..400 {
            let (steps, moves) = program(&mut draws);
            let count = moves.len() as u64;
            let rates = (0..STATES).map(|_| draws.below(count) as usize).collect();
            let of = Recurrences::new(&steps, &moves, rates);
            // Away from 0, where quotients would cancel.
            let mut number =
                || (0.5 + draws.below(1 << 20) as f64 / 524_288.0) * if draws.below(2) == 0 { 1.0 } else { -1.0 };
            let inputs: [[f64; 6]; 8] = std::array::from_fn(|_| std::array::from_fn(|_| number()));
            let wide = grown(&of, &steps, &moves, inputs);
            let some: [[f64; 6]; 3] = std::array::from_fn(|i| inputs[i]);
            let half: [[f64; 6]; 4] = std::array::from_fn(|i| inputs[i]);
            let (three, four) = (grown(&of, &steps, &moves, some), grown(&of, &steps, &moves, half));
            for (lane, input) in inputs.iter().enumerate() {
                let one = grown(&of, &steps, &moves, [*input]);
                let jets = by_jets(&of, &steps, input);
                for slot in 0..moves.len() {
                    let known = if (1..=STATES).contains(&slot) { DEGREE } else { DEGREE - 1 };
                    for k in 0..=known {
                        let x = wide.coefficient(slot, k).0[lane];
                        let mut others = vec![one.coefficient(slot, k).0[0]];
                        others.extend(three.coefficient(slot, k).0.get(lane));
                        others.extend(four.coefficient(slot, k).0.get(lane));
                        assert!(
                            others.iter().all(|y| y.to_bits() == x.to_bits() || x.is_nan() && y.is_nan()),
                            "{steps:?}"
                        );
                        assert!(x.is_nan() || x.is_finite());
                        same += others.len();
                        if let Some(y) = jets.as_ref().map(|jets| jets[slot].coefficient(k)) {
                            let is_near = (x - y).abs() <= 1e-9 * y.abs().max(1.0);
                            *if is_near { &mut near } else { &mut far } += 1;
                        }
                    }
                }
            }
        }
        // Where something cancels, rounding counts for much.
        assert!(same > 1_000_000 && near > 100_000 && far * 100 < near, "{same} {near} {far}");
    }

    #[test]
    fn products_with_a_factor_in_common_are_one_row() {
        let step = |op, a, b, out| Instruction { op, a, b, out };
        let steps = [step(Op::Mul, 1, 2, 4), step(Op::Mul, 3, 1, 5), step(Op::Mul, 2, 2, 6), step(Op::Sub, 4, 5, 7)];
        let of = Recurrences::new(&steps, &[true; 8], vec![7, 6, 4]);
        let rows: Vec<(Kind, usize)> = of.rows.iter().map(|row| (row.kind, row.steps.len())).collect();
        assert_eq!(rows, [(Kind::Product, 2), (Kind::Product, 1), (Kind::Difference, 1)]);
    }
}
