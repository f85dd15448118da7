//! The values of leaves at many times, leaf by leaf.
//!
//! **In:** what a motion yields at each of some times. **Out:** one column for each leaf; what is the same at all times is
//! kept once.
//!
//! **Why columns:** a claim needs few of the leaves, at all times, and takes them in blocks. About half of what formulas name
//! does not change along a motion (parameters, values at the start, constants of the motion that is looked at), and a column
//! with a value at every time needs two numbers for each.

use super::motion::Point;
use number::{Bounded, BoundedLanes, NoValue};

/// A value, or why there is none.
type Value = Result<Bounded, NoValue>;

/// Whether two values are one, bit for bit: 0 and −0 are not, since angles tell them apart.
fn is_same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Ok(a), Ok(b)) => a.value.to_bits() == b.value.to_bits() && a.error.to_bits() == b.error.to_bits(),
        (a, b) => a == b,
    }
}

/// The values of one leaf.
#[derive(Clone, Debug)]
enum Column {
    /// The same at all times.
    Same(Value),
    /// There is one at every time.
    Known(Vec<Bounded>),
    /// At some times there is none.
    Partial(Vec<Value>),
}

impl Column {
    fn get(&self, at: usize) -> Value {
        match self {
            Column::Same(x) => *x,
            Column::Known(all) => all.get(at).copied().ok_or(NoValue::OutOfDomain),
            Column::Partial(all) => all.get(at).copied().unwrap_or(Err(NoValue::OutOfDomain)),
        }
    }

    /// Adds the value at the time after `count` others, of `room` in all, as far as is known.
    fn push(&mut self, count: usize, room: usize, x: Value) {
        match self {
            Column::Same(same) if count == 0 => *same = x,
            Column::Same(same) if is_same(*same, x) => {}
            Column::Same(same) => {
                *self = match (*same, x) {
                    (Ok(same), Ok(x)) => {
                        let mut all = Vec::with_capacity(room.max(count + 1));
                        all.resize(count, same);
                        all.push(x);
                        Column::Known(all)
                    }
                    (same, x) => {
                        let mut all = vec![same; count];
                        all.push(x);
                        Column::Partial(all)
                    }
                }
            }
            Column::Known(all) => match x {
                Ok(x) => all.push(x),
                Err(_) => {
                    let mut partial: Vec<Value> = all.iter().map(|&x| Ok(x)).collect();
                    partial.push(x);
                    *self = Column::Partial(partial);
                }
            },
            Column::Partial(all) => all.push(x),
        }
    }

    fn shrink(&mut self) {
        match self {
            Column::Same(_) => {}
            Column::Known(all) => all.shrink_to_fit(),
            Column::Partial(all) => all.shrink_to_fit(),
        }
    }
}

/// The values of leaves at many times.
#[derive(Clone, Debug, Default)]
pub struct Points {
    count: usize,
    /// How many times there will be, as far as is known.
    room: usize,
    columns: Vec<Column>,
}

impl Points {
    /// No times yet, for so many leaves.
    pub(super) fn of(leaves: usize) -> Points {
        Points::with_room(leaves, 0)
    }

    /// The same, with room for so many times.
    pub(super) fn with_room(leaves: usize, room: usize) -> Points {
        Points { count: 0, room, columns: vec![Column::Same(Err(NoValue::OutOfDomain)); leaves] }
    }

    /// The number of times.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are no times.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The value of a leaf at a time; a leaf or a time that is not there has none.
    pub fn get(&self, at: usize, leaf: usize) -> Value {
        if at >= self.count {
            return Err(NoValue::OutOfDomain);
        }
        self.columns.get(leaf).map_or(Err(NoValue::OutOfDomain), |c| c.get(at))
    }

    /// The values of all leaves at a time.
    pub fn row(&self, at: usize) -> Point {
        (0..self.columns.len()).map(|leaf| self.get(at, leaf)).collect()
    }

    /// The values of all leaves at a time, to be read in place.
    pub fn sample(&self, at: usize) -> Sample<'_> {
        Sample::Among(self, at)
    }

    /// All times in their order, to be read in place.
    pub fn samples(&self) -> impl Iterator<Item = Sample<'_>> {
        (0..self.count).map(|at| self.sample(at))
    }

    /// The values of a leaf at the `N` times from `from` on; `None` where one of them has none.
    #[inline]
    pub fn lanes<const N: usize>(&self, from: usize, leaf: usize) -> Option<BoundedLanes<N>> {
        let mut lanes = BoundedLanes::splat(Bounded::exact(0.0));
        match self.columns.get(leaf)? {
            Column::Same(x) => return x.ok().map(BoundedLanes::splat),
            Column::Known(all) => {
                for (i, x) in all.get(from..from + N)?.iter().enumerate() {
                    lanes.set_lane(i, *x);
                }
            }
            Column::Partial(all) => {
                for (i, x) in all.get(from..from + N)?.iter().enumerate() {
                    lanes.set_lane(i, x.ok()?);
                }
            }
        }
        Some(lanes)
    }

    /// The values of a leaf at some times; `None` where one of them has none.
    #[inline]
    pub fn lanes_at<const N: usize>(&self, at: [usize; N], leaf: usize) -> Option<BoundedLanes<N>> {
        let from = at[0];
        if at.iter().enumerate().all(|(i, &t)| t == from + i) {
            return self.lanes(from, leaf);
        }
        let mut lanes = BoundedLanes::splat(Bounded::exact(0.0));
        for (i, &t) in at.iter().enumerate() {
            lanes.set_lane(i, self.get(t, leaf).ok()?);
        }
        Some(lanes)
    }

    /// Whether a leaf has the same value at all times, or none at any.
    pub fn is_constant(&self, leaf: usize) -> bool {
        !matches!(self.columns.get(leaf), Some(Column::Known(_) | Column::Partial(_)))
    }

    /// Why a leaf has no value at any time; `None` if it has one at some time.
    pub fn absent(&self, leaf: usize) -> Option<NoValue> {
        match self.columns.get(leaf) {
            Some(Column::Same(x)) => x.err(),
            Some(_) => None,
            None => Some(NoValue::OutOfDomain),
        }
    }

    /// Adds a time.
    pub fn push(&mut self, values: impl IntoIterator<Item = Value>) {
        let mut values = values.into_iter();
        for column in &mut self.columns {
            column.push(self.count, self.room, values.next().unwrap_or(Err(NoValue::OutOfDomain)));
        }
        self.count += 1;
    }

    /// Adds the values of a leaf at `N` further times, or why it has none at any of them.
    pub(super) fn push_lanes<const N: usize>(&mut self, leaf: usize, lanes: Result<BoundedLanes<N>, NoValue>) {
        match (self.columns.get_mut(leaf), &lanes) {
            (Some(Column::Known(all)), Ok(lanes)) => all.extend((0..N).map(|i| lanes.lane(i))),
            (Some(Column::Same(Ok(same))), Ok(lanes)) if self.count > 0 && lanes.is(*same) => {}
            (Some(column), lanes) => {
                for i in 0..N {
                    let x = lanes.as_ref().map(|lanes| lanes.lane(i)).map_err(|&reason| reason);
                    column.push(self.count + i, self.room, x);
                }
            }
            (None, _) => {}
        }
    }

    /// Adds the value of a leaf at the time that comes after `further` others that are not counted yet.
    pub(super) fn push_one(&mut self, leaf: usize, further: usize, x: Value) {
        if let Some(column) = self.columns.get_mut(leaf) {
            column.push(self.count + further, self.room, x);
        }
    }

    /// Counts the times whose values were added leaf by leaf.
    pub(super) fn counted(&mut self, more: usize) {
        self.count += more;
    }

    /// Gives memory back that is not used.
    pub(super) fn finished(mut self) -> Points {
        self.columns.iter_mut().for_each(Column::shrink);
        self
    }

    /// Forgets all leaves but these.
    pub fn keep(&mut self, leaves: &[usize]) {
        for (leaf, column) in self.columns.iter_mut().enumerate() {
            if leaves.binary_search(&leaf).is_err() {
                *column = Column::Same(Err(NoValue::OutOfDomain));
            }
        }
    }

    /// Some of the times, in their order, at which only the given leaves keep values.
    pub fn some(&self, times: &[usize], leaves: &[usize]) -> Points {
        let mut out = Points::of(self.columns.len());
        out.count = times.len();
        for &leaf in leaves.iter().filter(|l| **l < self.columns.len()) {
            let column = &self.columns[leaf];
            out.columns[leaf] = match column {
                Column::Same(x) => Column::Same(*x),
                Column::Known(all) => Column::Known(times.iter().map(|&at| all[at]).collect()),
                Column::Partial(all) => Column::Partial(times.iter().map(|&at| all[at]).collect()),
            };
        }
        out
    }

    /// The same times with the leaves in another order: for each its position here, where no two are the same; one that is
    /// not here has no value.
    pub fn arranged(mut self, places: &[Option<usize>]) -> Points {
        let nothing = || Column::Same(Err(NoValue::OutOfDomain));
        let mut column = |place: &Option<usize>| {
            let taken = place.and_then(|i| self.columns.get_mut(i)).map(|c| std::mem::replace(c, nothing()));
            taken.unwrap_or_else(nothing)
        };
        Points { count: self.count, room: self.count, columns: places.iter().map(&mut column).collect() }
    }

    /// These times and others between them: `more` has for each of the others how many of these come before it, and its
    /// values. Only the given leaves keep values.
    pub fn with(&self, more: &[(usize, Point)], leaves: &[usize]) -> Points {
        let mut out = Points::of(self.columns.len());
        out.count = self.count + more.len();
        for &leaf in leaves.iter().filter(|l| **l < self.columns.len()) {
            let mut column = Column::Same(Err(NoValue::OutOfDomain));
            let mut count = 0;
            let mut push = |x: Value| {
                column.push(count, self.count + more.len(), x);
                count += 1;
            };
            let mut next = 0;
            for (before, point) in more {
                (next..*before).for_each(|at| push(self.get(at, leaf)));
                next = next.max(*before);
                push(point.get(leaf).copied().unwrap_or(Err(NoValue::OutOfDomain)));
            }
            (next..self.count).for_each(|at| push(self.get(at, leaf)));
            out.columns[leaf] = column;
        }
        out
    }
}

impl FromIterator<Point> for Points {
    fn from_iter<I: IntoIterator<Item = Point>>(rows: I) -> Points {
        let mut rows = rows.into_iter().peekable();
        let mut out = Points::of(rows.peek().map_or(0, Vec::len));
        rows.for_each(|row| out.push(row));
        out
    }
}

/// The values of all leaves at one time.
#[derive(Clone, Copy, Debug)]
pub enum Sample<'a> {
    /// By themselves.
    Alone(&'a [Value]),
    /// Among those at other times.
    Among(&'a Points, usize),
}

impl Sample<'_> {
    /// The value of a leaf.
    #[inline]
    pub fn get(self, leaf: usize) -> Value {
        match self {
            Sample::Alone(values) => values.get(leaf).copied().unwrap_or(Err(NoValue::OutOfDomain)),
            Sample::Among(points, at) => points.get(at, leaf),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows with a constant, one that changes, one without a value at some times, and one that never has one.
    fn rows() -> Vec<Point> {
        let value = |x: f64| Ok(Bounded::new(x, 1e-16 * x));
        let partial = |i: usize| if i == 3 { Err(NoValue::Indeterminate) } else { value(2.0) };
        let row = |i: usize| vec![value(5.0), value(i as f64), partial(i), Err(NoValue::OutOfDomain)];
        (0..11).map(row).collect()
    }

    #[test]
    fn columns_say_what_rows_say() {
        let rows = rows();
        let points: Points = rows.iter().cloned().collect();
        assert_eq!(points.len(), 11);
        for (at, row) in rows.iter().enumerate() {
            assert_eq!(points.row(at), *row);
            for (leaf, x) in row.iter().enumerate() {
                assert_eq!(points.sample(at).get(leaf), *x);
                assert_eq!(Sample::Alone(row).get(leaf), *x);
            }
        }
        assert_eq!(points.get(11, 0), Err(NoValue::OutOfDomain));
        assert_eq!(points.get(0, 4), Err(NoValue::OutOfDomain));
        let lanes = points.lanes::<4>(5, 1).map(|l| [0, 1, 2, 3].map(|i| l.lane(i).value));
        assert_eq!(lanes, Some([5.0, 6.0, 7.0, 8.0]));
        assert!(points.lanes::<4>(0, 2).is_none() && points.lanes::<4>(4, 2).is_some());
        assert!(points.lanes::<4>(9, 1).is_none(), "beyond the end");
        assert!(points.lanes::<4>(0, 3).is_none());
    }

    #[test]
    fn a_zero_keeps_its_sign() {
        let points: Points = [0.0, -0.0].map(|x| vec![Ok(Bounded::exact(x))]).into_iter().collect();
        let signs = [0, 1].map(|at| points.get(at, 0).unwrap().value.is_sign_negative());
        assert_eq!(signs, [false, true]);
    }

    #[test]
    fn further_times_come_between() {
        let rows = rows();
        let points: Points = rows.iter().cloned().collect();
        let more = vec![(0, rows[9].clone()), (3, rows[1].clone()), (3, rows[3].clone()), (11, rows[0].clone())];
        let all = points.with(&more, &[1, 2]);
        let order: Vec<f64> = (0..all.len()).map(|at| all.get(at, 1).unwrap().value).collect();
        assert_eq!(order, [9.0, 0.0, 1.0, 2.0, 1.0, 3.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 0.0]);
        assert!(all.get(6, 2).is_err() && all.get(5, 2).is_err() && all.get(4, 2).is_ok());
        assert!((0..all.len()).all(|at| all.get(at, 0).is_err()), "not asked for");
        let arranged = points.clone().arranged(&[Some(1), None, Some(0)]);
        assert_eq!(arranged.row(7), [rows[7][1], Err(NoValue::OutOfDomain), rows[7][0]]);
    }
}
