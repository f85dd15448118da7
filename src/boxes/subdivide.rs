//! Ranges taken apart until every part is decided, or the work is done that was allowed.
//!
//! **In:** ranges, and a judge of cells. **Out:** [`Division`]: the parts, each judged, and a point at which the claim fails,
//! if one was met. **Guaranteed:** the parts cover the ranges; a judgement of a cell is about all of its points. At most
//! [`MOST_CELLS`] cells are judged. The result depends on nothing but the input: cells are judged in the order of their
//! making, breadth first, a generation at a time (in parallel, which changes nothing).
//!
//! **Closed ranges:** both ends belong to a range, and the cells are closed; they share their faces. Volumes are counted by
//! bisections, so that faces count nothing.

use rayon::prelude::*;

use super::signs::{Cell, Variable};
use crate::findings::region::Part;
use crate::number::Interval;

/// Most cells that are judged.
pub(super) const MOST_CELLS: usize = 20_000;
/// Cells after which it is asked whether that is used up.
const BETWEEN: usize = 64;
/// Most bisections of one cell.
const MOST_BISECTIONS: u32 = 60;
/// Bisections of each range for a picture of two.
pub(super) const PICTURE_BISECTIONS: u32 = 6;
/// Ranges up to this number have all their corners looked at.
const MOST_CORNERS: usize = 6;
/// So many generations have points of theirs looked at.
const POINTS_UNTIL: u32 = 14;

/// Judges cells.
pub(super) trait Judge: Sync {
    /// Memory for judging.
    type Scratch: Default + Send;
    /// So many cells are worth a thread.
    const TOGETHER: usize;
    /// What is known of a cell.
    fn judge(&self, cell: &Cell, scratch: &mut Self::Scratch) -> Part;
    /// Along which of so many ranges cells are taken apart: along others nothing changes.
    fn divides(&self, ranges: usize) -> Vec<bool> {
        vec![true; ranges]
    }
}

/// A part of the ranges.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    pub sides: Vec<Interval>,
    /// How many bisections of each range it took: its place among the 2ⁿ parts of each.
    pub place: Vec<(u32, u64)>,
    pub part: Part,
}

impl Piece {
    /// Number of bisections that it took.
    pub fn bisections(&self) -> u32 {
        self.place.iter().map(|(n, _)| n).sum()
    }

    /// Its part of the volume.
    pub fn volume(&self) -> f64 {
        1.0 / (1u64 << self.bisections().min(MOST_BISECTIONS)) as f64
    }
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Division {
    /// In the order of their making.
    pub pieces: Vec<Piece>,
    /// Number of cells that were judged.
    pub judged: usize,
    /// A point of the ranges at which the claim was refuted.
    pub refuted_at: Option<Cell>,
    /// Whether a point was met at which the claim holds and applies.
    pub met: bool,
    /// Whether the work was used up before all cells were judged.
    pub exhausted: bool,
}

/// The point of the ranges that is nearest to the middle of a cell, with the values that are given.
fn middle(variables: &[Variable], sides: &[Interval]) -> Option<Cell> {
    let point = |(v, side): (&Variable, &Interval)| {
        let x = v.only.unwrap_or(side.mid()).clamp(v.inner.lo(), v.inner.hi());
        side.contains(x).then(|| Interval::point(x))
    };
    Some(Cell::inside(variables.iter().zip(sides).map(point).collect::<Option<_>>()?))
}

/// The corners of the ranges: each coordinate is the exact end.
fn corners(variables: &[Variable]) -> Vec<Cell> {
    let n = variables.len();
    if n > MOST_CORNERS {
        return Vec::new();
    }
    let corner = |number: usize| {
        let upper: Vec<bool> = (0..n).map(|i| number >> i & 1 == 1).collect();
        let side = |(v, up): (&Variable, &bool)| {
            let (a, b) = if *up { (v.inner.hi(), v.outer.hi()) } else { (v.outer.lo(), v.inner.lo()) };
            Interval::point(a).hull(Interval::point(b))
        };
        let sides = variables.iter().zip(&upper).map(side).collect();
        Cell { sides, at_end: upper.into_iter().map(Some).collect() }
    };
    (0..1 << n).map(corner).collect()
}

/// The two halves of a piece along that of the marked ranges that was bisected least; `None` where it cannot be halved.
fn halves(piece: &Piece, divides: &[bool]) -> Option<[Piece; 2]> {
    if piece.bisections() >= MOST_BISECTIONS {
        return None;
    }
    let divisible = |i: &usize| {
        let side = piece.sides[*i];
        let m = side.mid();
        divides[*i] && side.lo() < m && m < side.hi()
    };
    let along = (0..piece.sides.len()).filter(divisible).min_by_key(|&i| (piece.place[i].0, i))?;
    let side = piece.sides[along];
    let half = |upper: bool| {
        let mut half = piece.clone();
        let (lo, hi) = if upper { (side.mid(), side.hi()) } else { (side.lo(), side.mid()) };
        half.sides[along] = Interval::point(lo).hull(Interval::point(hi));
        let (n, place) = half.place[along];
        half.place[along] = (n + 1, 2 * place + u64::from(upper));
        half.part = Part::Undecided;
        half
    };
    Some([half(false), half(true)])
}

/// Takes the ranges apart.
///
/// `most_work`: after so many units of counted work no cell is taken apart any more. They are charged to the piece that is under way.
pub(super) fn subdivide<J: Judge>(judge: &J, variables: &[Variable], most_cells: usize, most_work: u64) -> Division {
    let mut out = Division::default();
    let see = |out: &mut Division, cell: Cell, part: Part| match part {
        Part::Refuted if out.refuted_at.is_none() => out.refuted_at = Some(cell),
        Part::Proved => out.met = true,
        _ => {}
    };
    if variables.is_empty() {
        // One point.
        let cell = Cell::inside(Vec::new());
        let part = judge.judge(&cell, &mut J::Scratch::default());
        out.pieces.push(Piece { sides: Vec::new(), place: Vec::new(), part });
        out.judged = 1;
        see(&mut out, cell, part);
        return out;
    }
    let corners = corners(variables);
    // A part that takes too much is not known. What was begun of it is forgotten.
    let limits = meter::limits();
    let parts = corners.par_iter().map(|cell| {
        let judged = || judge.judge(cell, &mut J::Scratch::default());
        let (part, units) = meter::apart(&limits, most_work, judged);
        (part.unwrap_or(Part::Undecided), units)
    });
    let parts: Vec<(Part, u64)> = parts.collect();
    let mut work = parts.iter().map(|(_, units)| units).sum();
    meter::charge(work);
    for (cell, (part, _)) in corners.into_iter().zip(parts) {
        see(&mut out, cell, part);
    }
    let whole = Piece {
        sides: variables.iter().map(|v| v.outer).collect(),
        place: vec![(0, 0); variables.len()],
        part: Part::Undecided,
    };
    let mut generation = vec![whole];
    let divides = judge.divides(variables.len());
    let mut depth = 0;
    let picture = PICTURE_BISECTIONS * divides.iter().filter(|d| **d).count() as u32;
    while !generation.is_empty() {
        let looked = depth <= POINTS_UNTIL;
        let mut judged: Vec<(Part, Option<(Cell, Part)>)> = Vec::with_capacity(generation.len());
        for some in generation.chunks(BETWEEN.max(generation.len() / 16)) {
            if work > most_work {
                break;
            }
            let one = |scratch: &mut J::Scratch, piece: &Piece| {
                let part = judge.judge(&Cell::inside(piece.sides.clone()), scratch);
                let wanted = match part {
                    Part::Undecided | Part::Border => looked,
                    // A point that can be shown.
                    Part::Refuted => true,
                    Part::Proved | Part::NotApplicable => false,
                };
                let point = middle(variables, &piece.sides).filter(|_| wanted);
                let seen = point.map(|cell| {
                    let part = judge.judge(&cell, scratch);
                    (cell, part)
                });
                (part, seen)
            };
            let found = some.par_iter().with_min_len(J::TOGETHER);
            let found = found.map_init(J::Scratch::default, |scratch, piece| {
                let (judged, units) = meter::apart(&limits, most_work, || one(scratch, piece));
                let judged = judged.unwrap_or_else(|| {
                    *scratch = J::Scratch::default();
                    (Part::Undecided, None)
                });
                (judged, units)
            });
            let found: Vec<_> = found.collect();
            let units = found.iter().map(|(_, units)| units).sum::<u64>();
            meter::charge(units);
            work += units;
            judged.extend(found.into_iter().map(|(judged, _)| judged));
        }
        out.judged += judged.len();
        out.exhausted |= work > most_work || judged.len() < generation.len();
        // What was not looked at is not known.
        judged.resize_with(generation.len(), || (Part::Undecided, None));
        let mut next = Vec::new();
        let room = if out.exhausted { 0 } else { most_cells.saturating_sub(out.judged) };
        for (mut piece, (part, seen)) in generation.into_iter().zip(judged) {
            piece.part = part;
            if let Some((cell, part)) = seen {
                see(&mut out, cell, part);
            }
            out.met |= part == Part::Proved;
            let further = match part {
                Part::Undecided => true,
                // Where it applies is of interest for the picture only.
                Part::Border => depth < picture,
                _ => false,
            };
            match halves(&piece, &divides).filter(|_| further && next.len() + 2 <= room) {
                Some(halves) => next.extend(halves),
                None => out.pieces.push(piece),
            }
        }
        generation = next;
        depth += 1;
    }
    out
}
