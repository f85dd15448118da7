//! Several facts, solved for several rates at once.
//!
//! **In:** what is to vanish, and facts that are linear in its highest rates. **Out:** each rate by Cramer's rule, put in. **Why not one after the other:** a pivot such as cos θ may vanish where the
//! determinant, r(sin²θ + cos²θ) = r, does not; what is divided by must not be 0 at any time.

use crate::eliminate::Solved;
use crate::prove::Attempt;
use crate::vanish::{Kind, Open, order};
use checker::FactId;
use expr::{Expr, Graph, Leaf};

/// Most rates that are solved for at once.
const MOST_RATES: usize = 4;
/// Most choices of facts that are tried.
const MOST_CHOICES: usize = 24;

/// The determinant of a square matrix.
fn determinant(graph: &mut Graph, rows: &[Vec<Expr>]) -> Expr {
    let Some((first, others)) = rows.split_first() else { return graph.integer(1) };
    let mut sum = graph.integer(0);
    for (at, &factor) in first.iter().enumerate() {
        if graph.is_zero(factor) {
            continue;
        }
        let minor: Vec<Vec<Expr>> = others.iter().map(|row| without(row, at)).collect();
        let minor = determinant(graph, &minor);
        let term = graph.mul(factor, minor);
        sum = if at % 2 == 0 { graph.add(sum, term) } else { graph.sub(sum, term) };
    }
    sum
}

fn without<T: Clone>(list: &[T], at: usize) -> Vec<T> {
    list.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, x)| x.clone()).collect()
}

/// The cofactor of row i and column j.
fn cofactor(graph: &mut Graph, rows: &[Vec<Expr>], i: usize, j: usize) -> Expr {
    let minor: Vec<Vec<Expr>> = without(rows, i).iter().map(|row| without(row, j)).collect();
    let minor = determinant(graph, &minor);
    if (i + j).is_multiple_of(2) { minor } else { graph.neg(minor) }
}

/// Choices of n of the numbers below m, in order.
fn choices(n: usize, m: usize) -> Vec<Vec<usize>> {
    let mut out: Vec<Vec<usize>> = vec![vec![]];
    for _ in 0..n {
        let longer = |c: &Vec<usize>| {
            let from = c.last().map_or(0, |l| l + 1);
            (from..m).map(|next| [&c[..], &[next]].concat()).collect::<Vec<_>>()
        };
        out = out.iter().flat_map(longer).take(MOST_CHOICES * 4).collect();
    }
    out.truncate(MOST_CHOICES);
    out
}

/// A fact, its slopes in the rates, and what it is without them.
struct Row {
    at: usize,
    slopes: Vec<Expr>,
    rest: Expr,
}

impl Attempt<'_> {
    /// Solves facts for the highest rates of an expression at once, and puts them in; nothing where that is too large.
    pub(crate) fn solve_block(&mut self, e: &mut Expr, rest: &mut Vec<Open>) -> Option<()> {
        let wanted = self.highest(*e, rest);
        if !(2..=MOST_RATES).contains(&wanted.len()) {
            return Some(());
        }
        let rows = self.rows(&wanted, rest);
        for choice in choices(wanted.len(), rows.len()) {
            let chosen: Vec<&Row> = choice.iter().map(|&i| &rows[i]).collect();
            let matrix: Vec<Vec<Expr>> = chosen.iter().map(|row| row.slopes.clone()).collect();
            let det = determinant(&mut self.search.reader.graph, &matrix);
            let Some(divisor) = self.simplified(det).filter(|d| !self.search.reader.graph.is_zero(*d)) else {
                continue;
            };
            let solved: Option<Vec<(FactId, Solved)>> =
                (0..wanted.len()).map(|i| self.by_cramer(wanted[i], i, &chosen, &matrix, divisor, rest)).collect();
            let Some(solved) = solved else { continue };
            let mut used: Vec<usize> = chosen.iter().map(|row| row.at).collect();
            used.sort_unstable();
            for at in used.into_iter().rev() {
                rest.remove(at);
            }
            for (fact, solved) in solved {
                self.search.solved.push(fact);
                self.search.put_in(e, solved).then_some(())?;
                rest.retain_mut(|open| self.search.put_in(&mut open.e, solved));
            }
            return Some(());
        }
        Some(())
    }

    /// The rates of highest order in an expression, and those that facts name beside them.
    fn highest(&mut self, e: Expr, rest: &[Open]) -> Vec<Leaf> {
        let leaves = self.search.reader.graph.leaves([e]);
        let rates: Vec<Leaf> = leaves.into_iter().filter(|l| self.kind_of(*l) == Some(Kind::Rate)).collect();
        let Some(top) = rates.iter().map(|l| order(*l)).max() else { return Vec::new() };
        let mut out: Vec<Leaf> = rates.into_iter().filter(|l| order(*l) == top).collect();
        for open in rest {
            let named = self.search.reader.graph.leaves([open.e]);
            if named.iter().any(|l| out.contains(l)) {
                let others = named.into_iter().filter(|l| self.kind_of(*l) == Some(Kind::Rate) && order(*l) >= top);
                let new: Vec<Leaf> = others.filter(|l| !out.contains(l)).collect();
                out.extend(new);
            }
        }
        out
    }

    /// Facts that are linear in rates.
    fn rows(&mut self, wanted: &[Leaf], rest: &[Open]) -> Vec<Row> {
        let mut out = Vec::new();
        for (at, open) in rest.iter().enumerate() {
            self.search.work += self.search.reader.graph.reachable([open.e]).len() * wanted.len();
            if self.search.is_spent() {
                return Vec::new();
            }
            let graph = &mut self.search.reader.graph;
            let slopes: Result<Vec<Expr>, _> = wanted.iter().map(|leaf| graph.slope(open.e, *leaf)).collect();
            let Ok(slopes) = slopes else { continue };
            let is_linear = graph.leaves(slopes.iter().copied()).iter().all(|l| !wanted.contains(l));
            if !is_linear || slopes.iter().all(|s| graph.is_zero(*s)) {
                continue;
            }
            let zero = graph.integer(0);
            let rest = graph.replaced(open.e, |_, l| wanted.contains(&l).then_some(zero));
            out.push(Row { at, slopes, rest });
        }
        out
    }

    /// An expression, expanded and divided by the laws of its functions.
    pub(crate) fn simplified(&mut self, e: Expr) -> Option<Expr> {
        let laws = self.laws(e);
        let term = self.search.reader.term(e)?;
        let normal = self.search.draft.normal_form(&term, &laws)?;
        self.search.reader.read(&normal)
    }

    fn by_cramer(
        &mut self,
        leaf: Leaf,
        column: usize,
        chosen: &[&Row],
        matrix: &[Vec<Expr>],
        divisor: Expr,
        rest: &[Open],
    ) -> Option<(FactId, Solved)> {
        let graph = &mut self.search.reader.graph;
        let mut top = graph.integer(0);
        let mut terms = Vec::new();
        for (i, row) in chosen.iter().enumerate() {
            let factor = cofactor(graph, matrix, i, column);
            let term = graph.mul(factor, row.rest);
            top = graph.sub(top, term);
            terms.push((rest[row.at].fact, factor));
        }
        let ratio = graph.div(top, divisor);
        let value = self.simplified(ratio).unwrap_or(ratio);
        let graph = &mut self.search.reader.graph;
        let node = graph.leaf(leaf);
        let product = graph.mul(divisor, ratio);
        let all = graph.add(product, value);
        let laws = self.laws(all);
        let says = self.search.reader.equation(node, value)?;
        let fact = self.search.zero(says, Some(divisor), &terms, &laws)?;
        Some((fact, Solved { node, value }))
    }
}
