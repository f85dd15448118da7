//! Whether equations have a solution in a box, and only one.
//!
//! **In:** n equations F(x, p) = 0 between n unknowns x in a closed box and parameters p in a cell, and other relations that a
//! solution must satisfy. **Out:** what is true for *every* p of the cell: solutions enclosed, each the only one in its
//! neighbourhood, and parts of the box that are left.
//!
//! **Theorem** ([Krawczyk 1969]; [Moore, Kearfott & Cloud 2009, Theorem 8.2]; uniqueness: [Neumaier 1990, Theorem 5.1.8]). Let
//! F have continuous partial derivatives on a box V, J ⊇ F′(V) an interval matrix, y ∈ V and C any matrix. With
//! K(V) = y − C·F(y) + (1 − C·J)(V − y), every zero of F in V lies in K(V), so that there is none if K(V) ∩ V is empty; and if
//! K(V) lies in the interior of V, then V contains exactly one zero. With p in a cell, all of this holds for each p in it.
//!
//! **How.** The box is bisected, breadth first. A part is dropped where some Fᵢ has no zero on it, or another relation is
//! false; where Krawczyk's operator, on the part made a little larger, verifies a zero, that is kept with its neighbourhood,
//! and every part inside the neighbourhood is dropped. Two zeros are different if their enclosures are disjoint, and the same
//! if one enclosure lies in the neighbourhood of the other. For one unknown a zero is also verified where F is strictly
//! monotone and changes its sign (Bolzano's theorem), which works for wide cells of parameters. A zero that is not simple is never verified; that there is one
//! may still be seen from a change of sign (one unknown), or from a point at which F is 0 exactly.
//!
//! The box is closed: a solution on its border counts, where it is seen exactly that it lies there.
//!
//! [Krawczyk 1969]: https://doi.org/10.1007/BF02234767
//! [Moore, Kearfott & Cloud 2009, Theorem 8.2]: https://doi.org/10.1137/1.9780898717716
//! [Neumaier 1990, Theorem 5.1.8]: https://doi.org/10.1017/CBO9780511526473

use reason::{Plain, Ranges};
use std::cell::OnceCell;
use std::collections::VecDeque;

use nalgebra::DMatrix;

use super::UNITS;
use super::faults;
use super::question::{Insertion, Question};
use super::signs::{Cell, Domain, Scratch as SignScratch, Signs, Truth, Variable, found};
use super::subdivide::{Division, Judge};
use crate::derivation::Written;
use crate::expr::tape::{Instruction, Slots, Tape};
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::region::{Part, RegionAccount, RegionWitness, SolutionAccount};
use crate::latex::{RelationKind, Statement};
use crate::number::{Decorated, Interval, Scalar};

/// Most parts of the box that are looked at for one value of the parameters, where these do not vary.
const MOST_PARTS: usize = 20_000;
/// The same for one cell of parameters that vary.
const MOST_PARTS_OF_A_CELL: usize = 300;
/// Most cells of parameters.
const MOST_CELLS: usize = 2_000;
/// Most times that Krawczyk's operator narrows an enclosure.
const MOST_ITERATIONS: usize = 12;
/// Whenever so many parts were looked at, all that are left are tried as one.
const TOGETHER: [usize; 5] = [4, 12, 32, 96, 256];
/// By so much of its width a part is made larger on each side before a zero is verified in it.
const LARGER: f64 = 0.1;

/// See the module.
pub(super) struct Solver {
    /// What the claim assumes of the parameters.
    question: Question,
    /// The other relations, over parameters and unknowns.
    conditions: Signs,
    relations: Vec<usize>,
    unknowns: Vec<Variable>,
    names: Vec<String>,
    parameters: usize,
    /// F.
    values: Map,
    /// F′, by rows; none where a derivative cannot be written.
    slopes: Option<Map>,
    unique: bool,
}

/// Functions of parameters and unknowns. For one cell of parameters they are evaluated on many parts of the box: what depends
/// on the parameters alone is computed once.
struct Map {
    tape: Tape,
    /// Number of parameters: the first inputs.
    parameters: usize,
    /// What depends on no unknown.
    standing: Vec<Instruction>,
    /// What depends on one.
    moving: Vec<Instruction>,
}

impl Map {
    fn new(tape: Tape, parameters: usize) -> Map {
        let mut moves: Vec<bool> =
            (0..tape.slot_count()).map(|i| (parameters..tape.inputs().len()).contains(&i)).collect();
        let (mut standing, mut moving) = (Vec::new(), Vec::new());
        for step in tape.instructions() {
            let of = moves[step.a as usize] || moves[step.b as usize];
            moves[step.out as usize] = of;
            if of { &mut moving } else { &mut standing }.push(*step);
        }
        Map { tape, parameters, standing, moving }
    }

    /// Memory for one cell of parameters; that of another cell is used again.
    fn begin(&self, p: &[Interval], slots: &mut Option<Slots<Decorated>>) {
        let slots = slots.get_or_insert_with(|| self.tape.slots::<Decorated>(&()));
        for (i, side) in p.iter().enumerate() {
            slots.set(i, Ok(Decorated::all_of(*side)));
        }
        self.tape.run_some(&(), slots, &self.standing);
    }

    /// The ranges on a part of the box; `None` where one of the functions has a value nowhere on it, or the cell is not begun.
    fn on(&self, x: &[Interval], slots: &mut Option<Slots<Decorated>>) -> Option<Vec<Decorated>> {
        let slots = slots.as_mut()?;
        for (i, side) in x.iter().enumerate() {
            slots.set(self.parameters + i, Ok(Decorated::all_of(*side)));
        }
        self.tape.run_some(&(), slots, &self.moving);
        found(&self.tape, slots).collect::<Option<Vec<Decorated>>>()
    }
}

/// What is known of F on a part of the box: each is computed when it is first asked for.
#[derive(Default)]
struct Look {
    x: Vec<Interval>,
    value: OnceCell<Option<Value>>,
    slopes: OnceCell<Option<Vec<Decorated>>>,
    image: OnceCell<Option<Vec<Interval>>>,
}

impl Look {
    fn at(x: Vec<Interval>) -> Look {
        Look { x, ..Look::default() }
    }
}

/// The memory of judging.
#[derive(Default)]
pub(super) struct Scratch {
    signs: SignScratch,
    conditions: SignScratch,
    values: Option<Slots<Decorated>>,
    slopes: Option<Slots<Decorated>>,
}

/// A verified zero.
#[derive(Clone, Debug)]
struct Zero {
    /// It is the only one here.
    neighbourhood: Vec<Interval>,
    /// It lies here.
    enclosure: Vec<Interval>,
    /// Whether it counts: it lies in the box, and the other relations hold.
    counts: Truth,
}

/// What was found for a cell of parameters.
#[derive(Clone, Debug, Default)]
struct Found {
    zeros: Vec<Zero>,
    /// Parts that are neither dropped nor decided.
    left: Vec<Vec<Interval>>,
    /// Whether there is a solution among what is left.
    seen: bool,
    /// Whether two enclosures may belong to one zero.
    unclear: bool,
}

/// What F is on a box.
struct Value {
    ranges: Vec<Interval>,
    continuous: bool,
}

impl Solver {
    /// Compiles equations and relations.
    ///
    /// # Errors
    /// A leaf without a value.
    pub fn new(
        graph: &mut Graph,
        put: &Insertion,
        question: Question,
        unknowns: Vec<Variable>,
        such_that: &[Written<Statement>],
        unique: bool,
    ) -> Result<Solver, Leaf> {
        let all: Vec<Variable> = question.signs.variables.iter().chain(&unknowns).cloned().collect();
        let leaves: Vec<Leaf> = all.iter().map(|v| v.leaf).collect();
        let mut conditions = Signs::new(all);
        let (mut equations, mut relations): (Vec<Expr>, Vec<usize>) = (Vec::new(), Vec::new());
        for relation in such_that.iter().flat_map(|w| &w.value.relations) {
            for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                let (l, r) = (put.put(graph, l, &leaves), put.put(graph, r, &leaves));
                let d = graph.sub(l, r);
                match relation.kind {
                    RelationKind::Equal => equations.push(d),
                    kind => relations.push(conditions.add(graph, d, kind)?),
                }
            }
        }
        let parameters = question.signs.variables.len();
        let values = Map::new(Tape::compile(graph, &leaves, &equations)?, parameters);
        let mut rows = Some(Vec::new());
        for &f in &equations {
            for unknown in &unknowns {
                match (graph.partial_derivative(f, unknown.leaf), &mut rows) {
                    (Ok(slope), Some(rows)) => rows.push(slope),
                    _ => rows = None,
                }
            }
        }
        let slopes = rows.and_then(|rows| Tape::compile(graph, &leaves, &rows).ok());
        let slopes = slopes.map(|tape| Map::new(tape, parameters));
        let names = unknowns.iter().map(|u| graph.leaf_latex(u.leaf)).collect();
        Ok(Solver { question, conditions, relations, unknowns, names, parameters, values, slopes, unique })
    }

    /// Most cells of parameters that are judged.
    pub fn most_cells(&self) -> usize {
        MOST_CELLS
    }

    /// Takes up a cell of parameters.
    fn begin(&self, p: &[Interval], scratch: &mut Scratch) {
        self.values.begin(p, &mut scratch.values);
        if let Some(slopes) = &self.slopes {
            slopes.begin(p, &mut scratch.slopes);
        }
    }

    /// F on a box; `None` where it has a value nowhere on it.
    fn value(&self, x: &[Interval], scratch: &mut Scratch) -> Option<Value> {
        let found = self.values.on(x, &mut scratch.values)?;
        let continuous = found.iter().all(Decorated::is_continuous);
        Some(Value { ranges: found.iter().map(Decorated::range).collect(), continuous })
    }

    fn value_on<'l>(&self, look: &'l Look, scratch: &mut Scratch) -> Option<&'l Value> {
        look.value.get_or_init(|| self.value(&look.x, scratch)).as_ref()
    }

    fn slopes_on<'l>(&self, look: &'l Look, scratch: &mut Scratch) -> Option<&'l Vec<Decorated>> {
        let found = || match &self.slopes {
            Some(slopes) => slopes.on(&look.x, &mut scratch.slopes),
            None => Some(vec![Decorated::UNKNOWN; self.unknowns.len().pow(2)]),
        };
        look.slopes.get_or_init(found).as_ref()
    }

    /// Krawczyk's operator on a box on which F is continuously differentiable; `None` where that is not known of it.
    fn krawczyk<'l>(&self, look: &'l Look, scratch: &mut Scratch) -> Option<&'l Vec<Interval>> {
        look.image.get_or_init(|| self.image(look, scratch)).as_ref()
    }

    fn image(&self, look: &Look, scratch: &mut Scratch) -> Option<Vec<Interval>> {
        let v = &look.x;
        let n = v.len();
        if !self.value_on(look, scratch)?.continuous {
            return None;
        }
        meter::charge(4 * UNITS * (n * n * n) as u64);
        let slopes = self.slopes_on(look, scratch)?;
        if !slopes.iter().all(Decorated::is_continuous) {
            return None;
        }
        let slopes: Vec<Interval> = slopes.iter().map(Decorated::range).collect();
        let inverse = inverse(n, &slopes)?;
        let y: Vec<Interval> = v.iter().map(|side| Interval::point(side.mid())).collect();
        let at = self.value(&y, scratch)?.ranges;
        let c = |i: usize, k: usize| Interval::point(inverse[n * i + k]);
        let mut out = Vec::with_capacity(n);
        for i in 0..n {
            let mut sum = y[i];
            for (k, f) in at.iter().enumerate() {
                sum = sum - c(i, k) * *f;
            }
            for k in 0..n {
                let mut entry = Interval::point(if i == k { 1.0 } else { 0.0 });
                for j in 0..n {
                    entry = entry - c(i, j) * slopes[n * j + k];
                }
                sum = sum + entry * (v[k] - y[k]);
            }
            out.push(sum.checked().ok()?);
        }
        Some(out)
    }

    /// How the other relations stand on a box.
    fn conditions(&self, p: &[Interval], x: &[Interval], scratch: &mut Scratch) -> Truth {
        if self.relations.is_empty() {
            return Truth::True;
        }
        let cell = Cell::inside(p.iter().chain(x).copied().collect());
        self.conditions.begin(&mut scratch.conditions);
        let mut out = Truth::True;
        for &relation in &self.relations {
            let truth = self.conditions.truth(relation, &cell, &mut scratch.conditions);
            match (self.conditions.domain(relation, &cell, &mut scratch.conditions), truth) {
                (Domain::Nowhere, _) => return Truth::False,
                (Domain::Everywhere | Domain::Open, Truth::False) => return Truth::False,
                (Domain::Everywhere, Truth::True) => {}
                _ => out = Truth::Open,
            }
        }
        out
    }

    /// Whether a zero that is enclosed counts.
    fn counts(&self, p: &[Interval], enclosure: &[Interval], scratch: &mut Scratch) -> Truth {
        let mut inside = true;
        for (unknown, side) in self.unknowns.iter().zip(enclosure) {
            if unknown.outer.intersection(*side).is_none() {
                return Truth::False;
            }
            inside &= unknown.inner.contains_interval(*side);
        }
        match (self.conditions(p, enclosure, scratch), inside) {
            (Truth::True, false) => Truth::Open,
            (truth, _) => truth,
        }
    }

    /// A zero in a box or next to it, if it can be verified.
    fn verify(&self, p: &[Interval], look: &Look, scratch: &mut Scratch) -> Option<Zero> {
        let x = &look.x;
        let larger = Look::at(x.iter().map(|side| side.widened(LARGER, f64::MIN_POSITIVE)).collect());
        for of in [&larger, look] {
            let v = &of.x;
            let Some(mut enclosure) = self.krawczyk(of, scratch).cloned() else { continue };
            if faults::no_inclusion() {
                let both: Option<Vec<Interval>> = enclosure.iter().zip(x).map(|(k, x)| k.intersection(*x)).collect();
                let Some(both) = both else { continue };
                enclosure = both;
            } else if !v.iter().zip(&enclosure).all(|(v, k)| v.encloses_strictly(*k)) {
                continue;
            }
            let neighbourhood = v.clone();
            for _ in 0..MOST_ITERATIONS {
                let Some(next) = self.image(&Look::at(enclosure.clone()), scratch) else { break };
                let both: Option<Vec<Interval>> =
                    next.iter().zip(&enclosure).map(|(a, b)| a.intersection(*b)).collect();
                match both {
                    Some(both) if both != enclosure => enclosure = both,
                    _ => break,
                }
            }
            let mut counts = self.counts(p, &enclosure, scratch);
            if counts == Truth::Open
                && let Some(at) = self.on_border(&enclosure, scratch)
            {
                counts = self.conditions(p, &at, scratch);
                enclosure = at;
            }
            return Some(Zero { neighbourhood, enclosure, counts });
        }
        self.crossing(p, look, scratch)
    }

    /// The zero of one function of one unknown that is strictly monotone on a part of the box, and has opposite signs at its
    /// ends, or is 0 there (Bolzano's theorem).
    fn crossing(&self, p: &[Interval], look: &Look, scratch: &mut Scratch) -> Option<Zero> {
        let x = &look.x;
        let ([only], [unknown]) = (&x[..], &self.unknowns[..]) else { return None };
        let inside = only.intersection(unknown.inner)?;
        if !self.value_on(look, scratch)?.continuous {
            return None;
        }
        let slope = self.slopes_on(look, scratch)?.first().filter(|s| s.is_defined()).map(Decorated::range)?;
        if slope.contains(0.0) {
            return None;
        }
        let mut at = |end: f64| Some(*self.value(&[Interval::point(end)], scratch)?.ranges.first()?);
        let (low, high) = (at(inside.lo())?, at(inside.hi())?);
        // At a face that two parts share both could take a zero for theirs: there the sign must be strict. At an end of the box
        // it need not be.
        let (rising, at_low, at_high) =
            (slope.lo() > 0.0, inside.lo() == unknown.inner.lo(), inside.hi() == unknown.inner.hi());
        let (below, above) = if rising { (low, high) } else { (high, low) };
        let (weak_below, weak_above) = if rising { (at_low, at_high) } else { (at_high, at_low) };
        let crosses = (below.hi() < 0.0 || weak_below && below.hi() == 0.0)
            && (above.lo() > 0.0 || weak_above && above.lo() == 0.0);
        let counts = self.conditions(p, &[inside], scratch);
        crosses.then(|| Zero { neighbourhood: x.to_vec(), enclosure: vec![inside], counts })
    }

    /// The point of an enclosure that lies on the border of the box, if F is 0 there exactly.
    fn on_border(&self, enclosure: &[Interval], scratch: &mut Scratch) -> Option<Vec<Interval>> {
        let snapped = |(unknown, side): (&Variable, &Interval)| {
            let ends = [(unknown.outer.lo(), unknown.inner.lo()), (unknown.outer.hi(), unknown.inner.hi())];
            let at = ends.iter().find(|(a, b)| a == b && side.contains(*a)).map_or(side.mid(), |(a, _)| *a);
            unknown.inner.contains(at).then(|| Interval::point(at))
        };
        let at: Vec<Interval> = self.unknowns.iter().zip(enclosure).map(snapped).collect::<Option<_>>()?;
        self.is_zero_at(&at, scratch).then_some(at)
    }

    fn is_zero_at(&self, at: &[Interval], scratch: &mut Scratch) -> bool {
        let value = self.value(at, scratch);
        value.is_some_and(|v| v.continuous && v.ranges.iter().all(|r| r.lo() == 0.0 && r.hi() == 0.0))
    }

    /// Whether what is left of the box contains a solution that Krawczyk's operator cannot verify.
    fn seen(&self, p: &[Interval], x: &[Interval], scratch: &mut Scratch) -> bool {
        let inside: Option<Vec<Interval>> =
            self.unknowns.iter().zip(x).map(|(unknown, side)| unknown.inner.intersection(*side)).collect();
        let Some(inside) = inside else { return false };
        let points = [Interval::lo, Interval::mid, Interval::hi];
        for point in points {
            let at: Vec<Interval> = inside.iter().map(|side| Interval::point(point(side))).collect();
            if self.is_zero_at(&at, scratch) && self.conditions(p, &at, scratch) == Truth::True {
                return true;
            }
        }
        let [only] = inside[..] else { return false };
        if !self.value(&inside, scratch).is_some_and(|v| v.continuous)
            || self.conditions(p, &inside, scratch) != Truth::True
        {
            return false;
        }
        let mut sign = |at: f64| {
            let value = self.value(&[Interval::point(at)], scratch)?;
            let [range] = value.ranges[..] else { return None };
            if range.lo() > 0.0 { Some(true) } else { (range.hi() < 0.0).then_some(false) }
        };
        matches!((sign(only.lo()), sign(only.hi())), (Some(a), Some(b)) if a != b)
    }

    /// Looks for all solutions, for every value of the parameters in a cell.
    fn search(&self, p: &[Interval], most: usize, scratch: &mut Scratch) -> Found {
        self.begin(p, scratch);
        let mut found = Found::default();
        let mut open: VecDeque<Vec<Interval>> = VecDeque::new();
        open.push_back(self.unknowns.iter().map(|u| u.outer).collect());
        let mut looked = 0;
        while let Some(x) = open.pop_front() {
            if looked >= most {
                found.left.push(x);
                found.left.extend(open);
                break;
            }
            looked += 1;
            if TOGETHER.contains(&looked) && found.zeros.is_empty() {
                // For parameters in a cell a zero wanders through many parts: all that are left, in one.
                let join = |a: &[Interval], b: &[Interval]| a.iter().zip(b).map(|(a, b)| a.hull(*b)).collect();
                let all = open.iter().fold(x.clone(), |all: Vec<Interval>, part| join(&all, part));
                if let Some(zero) = self.verify(p, &Look::at(all.clone()), scratch)
                    && zero.neighbourhood.iter().zip(&all).all(|(n, side)| n.contains_interval(*side))
                {
                    found.add(zero);
                    break;
                }
            }
            let inside = |z: &Zero| z.neighbourhood.iter().zip(&x).all(|(n, side)| n.contains_interval(*side));
            if found.zeros.iter().any(inside) {
                continue;
            }
            let look = Look::at(x);
            let Some(value) = self.value_on(&look, scratch) else { continue };
            if value.ranges.iter().any(|r| !r.contains(0.0)) || self.conditions(p, &look.x, scratch) == Truth::False {
                continue;
            }
            if let Some(zero) = self.verify(p, &look, scratch) {
                let covered = zero.neighbourhood.iter().zip(&look.x).all(|(n, side)| n.contains_interval(*side));
                found.add(zero);
                if covered {
                    continue;
                }
            }
            let x = match self.krawczyk(&look, scratch) {
                Some(image) => image.iter().zip(&look.x).map(|(a, b)| a.intersection(*b)).collect(),
                None => Some(look.x),
            };
            let Some(x) = x else { continue };
            match bisected(&x, &self.unknowns) {
                Some(halves) => open.extend(halves),
                None => found.left.push(x),
            }
        }
        // That there is one says nothing of whether there is only one.
        found.seen = !self.unique && found.left.iter().any(|x| self.seen(p, x, scratch));
        found
    }

    /// What follows for the claim.
    fn part(&self, found: &Found) -> Part {
        let number = |counts: Truth| found.zeros.iter().filter(|z| z.counts == counts).count();
        let (sure, open) = (number(Truth::True), number(Truth::Open));
        let complete = found.left.is_empty() && open == 0 && !found.unclear;
        let exists = sure > 0 || found.seen;
        match self.unique {
            _ if complete && sure == 0 => Part::Refuted,
            false if exists => Part::Proved,
            true if complete && sure == 1 => Part::Proved,
            true if sure > 1 && !found.unclear => Part::Refuted,
            _ => Part::Undecided,
        }
    }

    fn most(&self) -> usize {
        if self.parameters == 0 { MOST_PARTS } else { MOST_PARTS_OF_A_CELL }
    }

    /// Adds solutions and the witness to the account.
    pub fn describe(&self, division: &Division, account: &mut RegionAccount) {
        let mut scratch = Scratch::default();
        let of = |zero: &Zero| {
            let each = self.names.iter().zip(&zero.enclosure);
            SolutionAccount { values: each.map(|(name, side)| (name.clone(), side.lo(), side.hi())).collect() }
        };
        // Where the ranges were not taken apart, the solutions are those for all values.
        if let [whole] = &division.pieces[..] {
            let found = self.search(&whole.sides, self.most(), &mut scratch);
            let sure = found.zeros.iter().filter(|z| z.counts == Truth::True);
            account.solutions = sure.map(of).collect();
            account.solutions.sort_by(|a, b| order(a).total_cmp(&order(b)));
            if whole.part == Part::Undecided {
                let open = found.zeros.iter().filter(|z| z.counts == Truth::Open).count();
                account.remarks.push(Ranges::PartsLeft(found.left.len() + open).into());
            }
        }
        let Some(cell) = &division.refuted_at else { return };
        let found = self.search(&cell.sides, self.most(), &mut scratch);
        let solutions: Vec<SolutionAccount> = found.zeros.iter().filter(|z| z.counts == Truth::True).map(of).collect();
        let says = match solutions.len() {
            0 => Plain::NoSolution.into(),
            count => {
                let middle = |(name, lo, hi): &(String, f64, f64)| (name.clone(), 0.5 * lo + 0.5 * hi);
                let first = solutions.iter().take(2).map(|s| s.values.iter().map(middle).collect()).collect();
                Ranges::Solutions { count, first }.into()
            }
        };
        account.witness =
            Some(RegionWitness { values: super::account::point(account, cell), formula: None, sides: None, says });
    }
}

/// Solutions are shown in the order of their first value.
fn order(s: &SolutionAccount) -> f64 {
    s.values.first().map_or(0.0, |(_, lo, _)| *lo)
}

impl Found {
    /// Adds a zero, unless it is known.
    fn add(&mut self, mut zero: Zero) {
        let meet = |a: &[Interval], b: &[Interval]| a.iter().zip(b).all(|(a, b)| a.intersection(*b).is_some());
        let inside = |a: &[Interval], b: &[Interval]| a.iter().zip(b).all(|(a, b)| b.contains_interval(*a));
        for known in self.zeros.iter_mut().filter(|known| meet(&known.enclosure, &zero.enclosure)) {
            if inside(&zero.enclosure, &known.neighbourhood) || inside(&known.enclosure, &zero.neighbourhood) {
                // One zero: it lies in both enclosures. It is counted once; both neighbourhoods are done with.
                if known.counts == Truth::Open {
                    (known.counts, known.enclosure) = (zero.counts, zero.enclosure.clone());
                }
                zero.counts = Truth::False;
            } else {
                self.unclear = true;
            }
        }
        self.zeros.push(zero);
    }
}

/// The inverse of the matrix of the middles, by rows; `None` where there is none.
fn inverse(n: usize, slopes: &[Interval]) -> Option<Vec<f64>> {
    let found = match slopes {
        [only] => (only.mid() != 0.0).then(|| vec![1.0 / only.mid()])?,
        _ => {
            let inverse = DMatrix::from_fn(n, n, |i, k| slopes[n * i + k].mid()).try_inverse()?;
            (0..n).flat_map(|i| (0..n).map(move |k| (i, k))).map(|at| inverse[at]).collect()
        }
    };
    found.iter().all(|x| x.is_finite()).then_some(found)
}

/// The halves of a box along the side that is longest as a part of its range.
fn bisected(x: &[Interval], unknowns: &[Variable]) -> Option<[Vec<Interval>; 2]> {
    let part = |i: usize| x[i].width() / unknowns[i].outer.width();
    let divisible = |i: &usize| x[*i].lo() < x[*i].mid() && x[*i].mid() < x[*i].hi();
    let along = (0..x.len()).filter(divisible).max_by(|&a, &b| part(a).total_cmp(&part(b)).then(b.cmp(&a)))?;
    // What is left then is as narrow as rounding allows.
    if part(along) < 1e-12 {
        return None;
    }
    let half = |lo: f64, hi: f64| {
        let mut half = x.to_vec();
        half[along] = Interval::point(lo).hull(Interval::point(hi));
        half
    };
    let side = x[along];
    Some([half(side.lo(), side.mid()), half(side.mid(), side.hi())])
}

impl Judge for Solver {
    type Scratch = Scratch;
    // A search in itself.
    const TOGETHER: usize = 1;

    fn judge(&self, cell: &Cell, scratch: &mut Scratch) -> Part {
        self.question.signs.begin(&mut scratch.signs);
        let applies = self.question.applies(cell, &mut scratch.signs);
        if applies == Truth::False {
            return Part::NotApplicable;
        }
        let found = self.search(&cell.sides, self.most(), scratch);
        match (self.part(&found), applies) {
            (Part::Proved, Truth::True) => Part::Proved,
            (Part::Proved, _) => Part::Border,
            (Part::Refuted, Truth::True) => Part::Refuted,
            _ => Part::Undecided,
        }
    }
}
