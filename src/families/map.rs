//! The map of a family: where, over two of the symbols that vary, a claim holds and where it fails.
//!
//! **In:** how two symbols are spread, and the numbers of members. **Out:** two [`Axis`], and for each member the cell that it lies in.
//!
//! **Guaranteed:** the cell of a member is determined by its number alone. A row or list with few values has a cell for each of them,
//! so that nothing is lost; others, and what is drawn, have a fixed number of cells, whatever the members are. So a map is counts
//! as others are, and parts of it can be added in any order.

use super::draw::{exp, ln};
use crate::derivation::{Spread, WIDEST_ROW};
use crate::findings::family::Axis;

/// A row or list with at most so many values has a cell for each; a longer one has so many cells.
const MOST_CELLS: u64 = WIDEST_ROW;
/// So many cells have what is drawn.
const DRAWN_CELLS: u64 = 24;
/// What is drawn from a normal distribution is shown up to so many standard deviations; the outermost cells have the rest.
const DEVIATIONS: f64 = 4.0;

/// How values fall into cells.
#[derive(Clone, Debug)]
pub(super) struct Scale {
    pub axis: Axis,
    of: Of,
}

#[derive(Clone, Debug)]
enum Of {
    /// So many positions of a row.
    Row(u64),
    /// Values of a list, increasing.
    List(Vec<f64>),
    /// From the first to the second; of the logarithms, if so.
    Drawn(f64, f64, bool),
}

/// The cell of a position among `count`.
fn cell(position: u64, count: u64) -> u64 {
    if count <= MOST_CELLS {
        position
    } else {
        (u128::from(position) * u128::from(MOST_CELLS) / u128::from(count)) as u64
    }
}

impl Scale {
    /// The middle of each cell, with the logarithm of its size.
    pub fn middles(&self) -> Vec<(f64, f64)> {
        let middle = |(from, to): &(f64, f64)| 0.5 * (from + to);
        self.axis.cells.iter().map(middle).map(|x| (x, ln(x.abs()))).collect()
    }

    /// The scale of a symbol, with the numbers of its spread and the value at each position of a row.
    pub fn new(name: &str, spread: &Spread, numbers: &[f64], at: &dyn Fn(u64) -> f64) -> Scale {
        let drawn = |from: f64, to: f64, logarithmic: bool| {
            let edge = |k: u64| {
                let share = k as f64 / DRAWN_CELLS as f64;
                let x = (1.0 - share) * from + share * to;
                if logarithmic { exp(x) } else { x }
            };
            ((0..DRAWN_CELLS).map(|k| (edge(k), edge(k + 1))).collect(), Of::Drawn(from, to, logarithmic))
        };
        let row = |count: u64, value: &dyn Fn(u64) -> f64| {
            let cells = count.min(MOST_CELLS);
            // The first position of each cell, and the last.
            let begin =
                |k: u64| (0..count).skip((k * count / cells) as usize).find(|p| cell(*p, count) >= k).unwrap_or(count);
            (0..cells).map(|k| (value(begin(k)), value(begin(k + 1) - 1))).collect::<Vec<_>>()
        };
        let (cells, of) = match spread {
            Spread::Values(_) => {
                let mut values = numbers.to_vec();
                values.sort_by(f64::total_cmp);
                values.dedup();
                (row(values.len() as u64, &|p| values[p as usize]), Of::List(values))
            }
            Spread::Grid { count, .. } => (row(*count, at), Of::Row(*count)),
            Spread::Uniform(..) | Spread::Polar(..) => drawn(numbers[0], numbers[1], false),
            Spread::LogUniform(..) => drawn(ln(numbers[0]), ln(numbers[1]), true),
            Spread::Normal(..) => {
                drawn(numbers[0] - DEVIATIONS * numbers[1], numbers[0] + DEVIATIONS * numbers[1], false)
            }
        };
        Scale { axis: Axis { name: name.to_owned(), cells }, of }
    }

    /// The cell of a value, which stands at a position of its row.
    pub fn place(&self, position: u64, value: f64) -> usize {
        let at = match &self.of {
            Of::Row(count) => cell(position, *count),
            Of::List(values) => cell(values.partition_point(|x| *x < value) as u64, values.len() as u64),
            Of::Drawn(from, to, logarithmic) => {
                let x = if *logarithmic { ln(value) } else { value };
                ((x - from) / (to - from) * DRAWN_CELLS as f64).floor().max(0.0) as u64
            }
        };
        (at as usize).min(self.axis.cells.len().saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Graph;

    fn grid(count: u64) -> Scale {
        let mut graph = Graph::default();
        let (from, to) = (graph.integer(0), graph.integer(1));
        let spread = Spread::Grid { from, to, count, logarithmic: false };
        Scale::new("x", &spread, &[0.0, 1.0], &|p| p as f64)
    }

    #[test]
    fn every_position_of_a_row_lies_in_its_cell() {
        for count in [2, 3, 63, 64, 65, 100, 127, 128, 1000, 4097] {
            let scale = grid(count);
            let cells = &scale.axis.cells;
            assert_eq!(cells.len() as u64, count.min(MOST_CELLS));
            assert_eq!((cells[0].0, cells[cells.len() - 1].1), (0.0, (count - 1) as f64));
            for position in 0..count {
                let (least, greatest) = cells[scale.place(position, position as f64)];
                assert!((least..=greatest).contains(&(position as f64)), "{position} of {count}");
            }
            assert!(cells.windows(2).all(|w| w[0].1 + 1.0 == w[1].0), "{count}: {cells:?}");
        }
    }

    #[test]
    fn what_is_drawn_lies_in_its_cell() {
        let mut graph = Graph::default();
        let (a, b) = (graph.integer(1), graph.integer(2));
        for (spread, numbers) in [
            (Spread::Uniform(a, b), [-3.0, 5.0]),
            (Spread::LogUniform(a, b), [0.01, 100.0]),
            (Spread::Normal(a, b), [1.0, 0.5]),
        ] {
            let scale = Scale::new("x", &spread, &numbers, &|_| f64::NAN);
            let cells = &scale.axis.cells;
            let (first, last) = (cells[0].0, cells[cells.len() - 1].1);
            for k in 0..=1000 {
                let x = first + (last - first) * f64::from(k) / 1000.0;
                let (least, greatest) = cells[scale.place(0, x)];
                let room = 1e-12 * (last - first);
                assert!(least - room <= x && x <= greatest + room, "{x} in {least}, {greatest}");
            }
            assert_eq!(scale.place(0, first - 0.001), 0);
            assert_eq!(scale.place(0, last + 1000.0), cells.len() - 1);
        }
    }
}
