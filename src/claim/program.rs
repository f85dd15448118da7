//! A claim, compiled: parts with their comparisons, and the tape that measures them.
//!
//! **In:** what a claim says, see `denote`. **Out:** a [`Program`] that measures every comparison at a point of any
//! motion. **Guaranteed:** what is measured is what was written: each form becomes parts in `denote` and nowhere else.

use crate::block::{BLOCK, Block as Wide, Evaluation, Part as Block};
use crate::comparison::{Comparison, Group};
use crate::denial::Denial;
use crate::expr::tape::{Slots, Tape};
use crate::expr::{Expr, Graph, Leaf, Symbol};
use crate::flow::{Points, Sample};
use crate::latex::{LimitPoint, RelationKind};
use crate::number::{Bounded, NoValue};
use crate::sides::{Measured, Series};
use crate::verdict::{Finding, Proposition, Verdict};
use reason::Reason;
use std::cell::RefCell;
use std::ops::Range;

/// The values of all leaves at one time.
pub type Values = Vec<Result<Bounded, NoValue>>;

/// After so many blocks in a row with points without a value, points are evaluated one by one.
const PATIENCE: usize = 3;

/// Of what a part of a claim speaks.
#[derive(Clone, Debug)]
pub enum What {
    /// Of every time that counts: the group is true at it.
    Every,
    /// Of every time that counts: that is what `eventually` denies. The first time at which the group is false is told.
    Denied,
    /// Of every time that counts: the left sides have values.
    Defined,
    /// Of all pairs of times that count: the left sides are the same at both. The right sides are the values at the start.
    Constant,
    /// Of nothing: what the part before it, which is about constancy, is computed from.
    Value,
    /// Of what the left side tends to.
    Limit(LimitPoint),
    /// Of every time that counts: the states are those of another motion.
    SameMotion(usize, Vec<Symbol>),
    /// Of every time that counts: the functions are independent.
    Independent,
    /// Of members of a family: the left side is compared between them.
    Across,
    /// Of what took too much work to be read: nothing is known of it, for this reason.
    Unread(String),
}

/// One part of a claim, which speaks of all times that count at once.
#[derive(Clone, Debug)]
pub struct Part {
    /// Of what it speaks.
    pub what: What,
    /// What it compares; nothing for other motions and for independence.
    pub group: Group,
}

impl Part {
    /// What vanishes where the part may change between two samples, and the relation that it belongs to; `void` if it has no
    /// value at the samples, so that it may have one where an alternative is met.
    pub fn boundaries(&self, void: bool) -> impl Iterator<Item = (usize, RelationKind, Expr)> + '_ {
        let compared = match self.what {
            What::Limit(_) | What::Value | What::Across | What::Unread(_) => &[][..],
            What::Every | What::Denied | What::Defined | What::Constant | What::SameMotion(..) | What::Independent => {
                &self.group.comparisons[..]
            }
        };
        compared.iter().enumerate().flat_map(move |(n, c)| {
            let meetings = c.meetings.iter().filter(move |_| void);
            c.boundaries.iter().chain(meetings).map(move |&e| (n, c.kind, e))
        })
    }

    /// Whether it compares something at every time that counts.
    pub fn is_compared(&self) -> bool {
        match self.what {
            What::Every | What::Denied | What::Defined | What::Constant => true,
            What::Value
            | What::Limit(_)
            | What::SameMotion(..)
            | What::Independent
            | What::Across
            | What::Unread(_) => false,
        }
    }

    /// Whether agreement to within an allowance may count as equality in it.
    pub fn allows(&self) -> bool {
        !matches!(self.what, What::Denied) && self.group.allows()
    }

    /// Whether what has no value counts against it.
    pub fn is_definedness(&self) -> bool {
        matches!(self.what, What::Defined)
    }

    /// Whether it may be false at a single time only, with everything around it as if it were true: samples alone do not tell.
    pub fn needs_a_complete_search(&self) -> bool {
        let strict = |kind: RelationKind| match kind {
            RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater => true,
            RelationKind::Equal | RelationKind::LessEqual | RelationKind::GreaterEqual => false,
        };
        match self.what {
            What::Independent | What::Denied | What::Defined => true,
            What::Every => self.group.comparisons.iter().any(|c| strict(c.kind)),
            What::Constant | What::Value | What::Limit(_) | What::SameMotion(..) | What::Across | What::Unread(_) => {
                false
            }
        }
    }
}

/// An assumption, as written.
#[derive(Clone, Debug)]
pub struct Assumption {
    /// Its text.
    pub text: String,
    /// What it says.
    pub part: Part,
}

/// A claim ready to be measured.
#[derive(Clone, Debug)]
pub struct Program {
    /// Inequalities among the assumptions: the times at which they are all true are those that count.
    pub selectors: Vec<Assumption>,
    /// The other assumptions: what must be so of the motion.
    pub hypotheses: Vec<Assumption>,
    /// What the claim says.
    pub parts: Vec<Part>,
    /// The claim: atoms are the parts, then the hypotheses.
    pub claim: Proposition,
    /// A scalar that vanishes at the times at which the claim is to be tried.
    pub at: Option<Expr>,
    /// Sides in what it says of every time, and in what it assumes so, that may vary more rapidly than a motion is sampled.
    pub rapid: Vec<Expr>,
    /// What keeps its sign where something has a value, and whether it may be 0 there.
    pub edges: Vec<(Expr, bool)>,
    /// Whether an angle leaps in what says when the claim is to be tried: there it may meet the other side, or pass it, unseen.
    pub leaps_at: bool,
    /// Whether it is a condition that tells motions apart, and no claim: sides that agree all along count as equal.
    pub tells_apart: bool,
    /// Left, right, and left − right of every comparison; then y and x of the cuts.
    sides: Option<Block>,
    /// The size of the terms of every comparison.
    sizes: Option<Block>,
    /// The positions among the leaves of a point of everything that is needed, increasing.
    inputs: Vec<usize>,
    sign: Leaf,
    /// Parameters with those that stand for them: see [`Program::sharing`].
    shared: Vec<(Leaf, Leaf)>,
}

/// What a claim says, before it is compiled.
pub struct Denoted {
    pub selectors: Vec<Assumption>,
    pub hypotheses: Vec<Assumption>,
    pub parts: Vec<Part>,
    /// Those of the parts that deny equations.
    pub denials: Vec<Denial>,
    /// Those that state an equation of every time, with that.
    pub stated: Vec<(usize, latex::Relation)>,
    pub claim: Proposition,
    pub at: Option<Expr>,
    pub rapid: Vec<Expr>,
    pub edges: Vec<(Expr, bool)>,
    pub sign: Leaf,
}

impl From<Denoted> for Program {
    fn from(of: Denoted) -> Program {
        let Denoted { selectors, hypotheses, parts, claim, at, rapid, edges, sign, .. } = of;
        let (sides, sizes, inputs) = (None, None, Vec::new());
        let (leaps_at, tells_apart, shared) = (false, false, Vec::new());
        Program {
            selectors,
            hypotheses,
            parts,
            claim,
            at,
            rapid,
            edges,
            leaps_at,
            tells_apart,
            sides,
            sizes,
            inputs,
            sign,
            shared,
        }
    }
}

impl Program {
    /// The verdict on the claim where nothing is known, for a reason. It has the parts of the claim: what is found of them later, by other
    /// means, is weighed as what the claim says, or as what it presupposes.
    pub fn open(&self, reason: Reason) -> Verdict {
        let parts = self.parts.len() + self.hypotheses.len();
        Verdict::decide(self.claim.clone(), vec![Finding::open(reason); parts])
    }

    /// All groups: of selectors, of hypotheses, of parts; each with whether it is about having values.
    pub fn groups(&self) -> impl Iterator<Item = &Group> {
        let assumed = self.selectors.iter().chain(&self.hypotheses).map(|a| &a.part.group);
        assumed.chain(self.parts.iter().map(|p| &p.group))
    }

    /// The part, or hypothesis, that an atom of the claim stands for.
    pub fn part(&self, atom: usize) -> &Part {
        match atom.checked_sub(self.parts.len()) {
            None => &self.parts[atom],
            Some(hypothesis) => &self.hypotheses[hypothesis].part,
        }
    }

    /// The expressions whose zeros along a motion the claim depends on.
    pub fn searched(&self) -> Vec<Expr> {
        let parts = self.parts.iter().chain(self.hypotheses.iter().map(|a| &a.part));
        let met = || self.met().map(|(_, _, e)| e);
        // What is tried at events only is not looked at between them.
        match self.at {
            None => {
                let parts = parts.flat_map(|p| p.boundaries(true)).map(|(_, _, e)| e);
                let one_sided = self.groups().flat_map(|g| &g.one_sided);
                parts.chain(met()).chain(one_sided.copied()).chain(self.edges()).collect()
            }
            Some(e) => {
                let hypotheses = self.hypotheses.iter().map(|a| &a.part);
                let one_sided = hypotheses.clone().flat_map(|p| p.group.one_sided.iter().copied());
                [e].into_iter()
                    .chain(hypotheses.flat_map(|p| p.boundaries(true)).map(|(_, _, e)| e))
                    .chain(one_sided)
                    .collect()
            }
        }
    }

    /// What changes its sign where something ceases to have a value.
    pub fn edges(&self) -> impl Iterator<Item = Expr> + '_ {
        self.edges.iter().map(|&(e, _)| e)
    }

    /// What touches 0 where something may have a value at a single time only.
    pub fn closed_edges(&self) -> impl Iterator<Item = Expr> + '_ {
        self.edges.iter().filter(|(_, closed)| *closed).map(|&(e, _)| e)
    }

    /// What vanishes where a selector may change, with the selector and the relation.
    pub fn met(&self) -> impl Iterator<Item = (&Assumption, RelationKind, Expr)> {
        let comparisons = self.selectors.iter().flat_map(|a| a.part.group.comparisons.iter().map(move |c| (a, c)));
        // What differs from a number does so on all sides of it.
        let inequalities = comparisons.filter(|(_, c)| c.kind != RelationKind::NotEqual);
        inequalities.flat_map(|(a, c)| c.boundaries.iter().map(move |&e| (a, c.kind, e)))
    }

    /// Every comparison in the order in which [`Program::measure`] yields them: those of selectors, hypotheses, parts.
    pub fn comparisons(&self) -> impl Iterator<Item = &Comparison> {
        self.groups().flat_map(|g| &g.comparisons)
    }

    /// y and x of every atan2(y, x) in a comparison, with its position.
    pub fn cuts(&self) -> impl Iterator<Item = (usize, [Expr; 2])> + '_ {
        self.comparisons().enumerate().flat_map(|(n, c)| c.cuts.iter().map(move |&of| (n, of)))
    }

    /// The position of a comparison in what [`Program::measure`] yields.
    pub fn position(&self, comparison: &Comparison) -> Option<usize> {
        self.comparisons().position(|c| std::ptr::eq(c, comparison))
    }

    /// Whether a ± occurs anywhere.
    pub fn is_branching(&self) -> bool {
        self.groups().any(|g| g.branching)
    }

    /// The leaves that must be known to measure it, the sign of ± apart.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        let roots = self.comparisons().flat_map(|c| [c.left, c.right, c.magnitude]);
        let one_sided = self.groups().flat_map(|g| &g.one_sided);
        let searched = one_sided.copied().chain(self.edges());
        let cuts = self.cuts().flat_map(|(_, of)| of);
        let roots = roots.chain(self.at).chain(searched).chain(cuts).collect::<Vec<_>>();
        graph.leaves(roots).into_iter().filter(|&l| l != self.sign).collect()
    }

    /// The same on motions on which some parameters are given as others are, none of which is known exactly: what is equal in the file is
    /// compared as equal, and not as two roundings.
    #[must_use]
    pub fn sharing(mut self, parameters: &[(Leaf, Leaf)]) -> Program {
        self.shared = parameters.to_vec();
        self
    }

    /// Compiles everything. `known` are the leaves of a point, sorted.
    ///
    /// # Errors
    /// A leaf that is needed, and is not among those of a point.
    pub fn compile(&mut self, graph: &mut Graph, known: &[Leaf]) -> Result<(), Leaf> {
        let compared: Vec<(Expr, Expr)> = self.comparisons().map(|c| (c.left, c.right)).collect();
        let sizes: Vec<Expr> = self.comparisons().map(|c| c.magnitude).collect();
        let mut sides: Vec<Expr> = compared.into_iter().flat_map(|(l, r)| [l, r, graph.sub(l, r)]).collect();
        sides.extend(self.cuts().flat_map(|(_, of)| of));
        if !self.shared.is_empty() {
            for side in &mut sides {
                *side = graph.substitute(*side, |graph, leaf| {
                    let (_, other) = self.shared.iter().find(|(of, _)| *of == leaf)?;
                    Some(graph.leaf(*other))
                });
            }
        }
        let sides = Block::new(graph, known, self.sign, &sides)?;
        let sizes = Block::new(graph, known, self.sign, &sizes)?;
        self.inputs = sides.inputs().iter().chain(sizes.inputs()).copied().collect();
        self.inputs.sort_unstable();
        self.inputs.dedup();
        (self.sides, self.sizes) = (Some(sides), Some(sizes));
        Ok(())
    }

    /// The positions among the leaves of a point of everything that is needed.
    pub fn inputs(&self) -> &[usize] {
        &self.inputs
    }

    /// The position among the leaves of a point of an input of the tape.
    pub fn input(&self, position: usize) -> Option<usize> {
        self.sides.as_ref()?.inputs().get(position).copied()
    }

    /// The leaf that stands for the sign of ±.
    pub fn sign(&self) -> Leaf {
        self.sign
    }

    /// Where the reason lies that a side of a comparison, by its position, has no value at a point: the tape with its
    /// evaluation there.
    pub fn evaluated<'s>(
        &'s self,
        values: Sample,
        slots: &'s mut Option<Slots<Bounded>>,
    ) -> Option<(&'s Tape, &'s Slots<Bounded>)> {
        let sides = self.sides.as_ref()?;
        Some((sides.tape(), sides.run(values, 1.0, slots)))
    }

    /// The values at a point of y and x of every atan2(y, x) in a comparison, in the order of [`Program::cuts`]; none before it is
    /// compiled.
    pub fn angles(&self, values: Sample) -> Vec<[Option<Bounded>; 2]> {
        let (mut slots, first) = (None, SIDES * self.comparisons().count());
        let Some((tape, slots)) = self.evaluated(values, &mut slots) else { return Vec::new() };
        let output = |n: usize| tape.output(n, slots).ok().copied();
        self.cuts().enumerate().map(|(at, _)| [0, 1].map(|n| output(first + 2 * at + n))).collect()
    }

    /// Both sides of all comparisons, once compiled.
    pub(crate) fn sides(&self) -> Option<&Block> {
        self.sides.as_ref()
    }

    /// The sizes of the terms of all comparisons, once compiled.
    pub(crate) fn sizes(&self) -> Option<&Block> {
        self.sizes.as_ref()
    }

    /// Measures every comparison at the first `times` of the points, for one sign of ±.
    pub fn measure(&self, points: (&Points, usize), sign: f64) -> Vec<Series> {
        self.measure_some(points, sign, 0..self.comparisons().count(), &RefCell::default())
    }

    /// Measures some of the comparisons, by their positions. The memory is used again: fresh memory is for all of them.
    pub(crate) fn measure_some(
        &self,
        (points, times): (&Points, usize),
        sign: f64,
        some: Range<usize>,
        memory: &RefCell<Option<Slots<Wide>>>,
    ) -> Vec<Series> {
        let Some(sides) = &self.sides else { return Vec::new() };
        let mut out: Vec<Series> = some.clone().map(|_| Series::with_capacity(times)).collect();
        let has_cuts = self.cuts().next().is_some();
        // What tells of cuts stands behind all sides.
        let outputs = if has_cuts { 0..sides.tape().output_count() } else { SIDES * some.start..SIDES * some.end };
        let count = if has_cuts { self.comparisons().count() } else { 0 };
        let mut evaluation = Evaluation::new(sides, points, sign, outputs).in_memory(memory.take());
        let mut failed = 0;
        let mut from = 0;
        while from < times {
            // The last block begins earlier, and yields only what is missing.
            let begin = from.min(times.saturating_sub(BLOCK));
            let end = (begin + BLOCK).min(times);
            if times >= BLOCK && failed < PATIENCE {
                let all = evaluation.at_all(std::array::from_fn(|i| begin + i));
                let clear = |slots: &&Slots<Wide>| {
                    let lane = |output: usize, i: usize| sides.tape().output(output, slots).ok().map(|b| b.lane(i));
                    !has_cuts || (0..BLOCK).all(|i| self.crossed(count, |output| lane(output, i)).next().is_none())
                };
                if let Some(slots) = all.filter(clear) {
                    failed = 0;
                    for (k, series) in some.clone().zip(&mut out) {
                        series.push_block(three(|n| sides.tape().output(SIDES * k + n, slots)), from - begin);
                    }
                    from = end;
                    continue;
                }
                failed += 1;
            }
            for at in from..end {
                let slots = evaluation.at(at);
                let crossed: Vec<usize> =
                    self.crossed(count, |output| sides.tape().output(output, slots).ok().copied()).collect();
                for (k, series) in some.clone().zip(&mut out) {
                    if crossed.contains(&k) {
                        series.push(Err(NoValue::Indeterminate));
                        continue;
                    }
                    let of = |[left, right, difference]: [&Bounded; SIDES]| Measured {
                        left: left.value,
                        right: right.value,
                        difference: *difference,
                    };
                    series.push(three(|n| sides.tape().output(SIDES * k + n, slots)).map(of));
                }
            }
            from = end;
        }
        memory.replace(evaluation.into_memory());
        out
    }

    /// The positions of the `count` comparisons in which an angle may lie on either side of its cut.
    fn crossed<'p>(
        &'p self,
        count: usize,
        output: impl Fn(usize) -> Option<Bounded> + 'p,
    ) -> impl Iterator<Item = usize> + 'p {
        let straddles = move |at: usize| {
            let [y, x] = [0, 1].map(|n| output(SIDES * count + 2 * at + n));
            y.zip(x).is_some_and(|(y, x)| y.straddles_cut(&x))
        };
        self.cuts().enumerate().filter(move |(at, _)| straddles(*at)).map(|(_, (position, _))| position)
    }
}

/// What is computed of each comparison: left, right, left − right.
pub const SIDES: usize = 3;

/// The outputs of a comparison, or why the first that has no value has none.
fn three<'s, T>(output: impl Fn(usize) -> Result<&'s T, NoValue>) -> Result<[&'s T; SIDES], NoValue> {
    Ok([output(0)?, output(1)?, output(2)?])
}
