//! Where the arguments of functions lie: facts that say on which stretch of the table of domains an argument is, so that the rules of signs see the sign of the function.
//!
//! **In:** the sides of the claim, and what is known of signs. **Out:** facts a > c or a ≥ c, a < c or a ≤ c, for arguments a of functions and ends c of stretches. **Guaranteed:**
//! the checker has shown each from what is known; a function that lies on no stretch has none.

use crate::prove::Attempt;
use checker::{FactId, Relation, Sense, Step};
use expr::domain::{Bound, rises, stretches};
use expr::{Expr, Graph, Node, Op};

/// Most arguments that are looked at.
const MOST_ARGUMENTS: usize = 12;

/// A formula whose sign its argument may say, or two arguments.
enum Candidate {
    /// A function of something.
    Function(Op, Expr),
    /// The difference of two values of a rising function, at these.
    Difference(Expr, Expr),
}

/// Functions whose sign the rules of signs do not tell from that of the argument, and differences of rising functions.
fn candidates(graph: &Graph, sides: [Expr; 2]) -> Vec<Candidate> {
    let of = |node: Expr| {
        if let Node::Unary(op, a) = *graph.node(node) {
            let by_argument = matches!(op, Op::Powi(_)) || stretches(op).is_empty();
            return (!by_argument).then_some(Candidate::Function(op, a));
        }
        let Node::Binary(Op::Sub, x, y) = *graph.node(node) else { return None };
        let (Node::Unary(f, a), Node::Unary(g, b)) = (graph.node(x), graph.node(y)) else { return None };
        (f == g && rises(*f)).then_some(Candidate::Difference(*a, *b))
    };
    graph.reachable(sides).into_iter().filter_map(of).take(MOST_ARGUMENTS).collect()
}

impl Attempt<'_> {
    /// Facts about the arguments of functions in the sides of the claim.
    pub(crate) fn on_stretches(&mut self) -> Vec<FactId> {
        let Some((left, right)) = self.search.draft.claim_says().and_then(|says| self.search.reader.sides(&says))
        else {
            return Vec::new();
        };
        let candidates = candidates(&self.search.reader.graph, [left, right]);
        if candidates.is_empty() {
            return Vec::new();
        }
        let known = self.of_known_sign();
        if known.is_empty() {
            return Vec::new();
        }
        let mut out = Vec::new();
        for candidate in candidates {
            match candidate {
                Candidate::Function(op, a) => {
                    let found = stretches(op).iter().find_map(|stretch| {
                        let ends = [(stretch.from, true), (stretch.to, false)];
                        let each = ends.into_iter().filter_map(|(end, is_lower)| Some((end?, is_lower)));
                        each.map(|(end, is_lower)| self.beyond(a, end, is_lower, &known))
                            .collect::<Option<Vec<FactId>>>()
                    });
                    out.extend(found.into_iter().flatten());
                }
                Candidate::Difference(a, b) => {
                    out.extend(self.ordered_by(a, b, &known).or_else(|| self.ordered_by(b, a, &known)));
                }
            }
        }
        out
    }

    /// a beyond an end.
    fn beyond(&mut self, a: Expr, end: Bound, is_lower: bool, known: &[FactId]) -> Option<FactId> {
        let end = end.expression(&mut self.search.reader.graph);
        if is_lower { self.ordered_by(end, a, known) } else { self.ordered_by(a, end, known) }
    }

    /// a < b or a ≤ b.
    fn ordered_by(&mut self, a: Expr, b: Expr, known: &[FactId]) -> Option<FactId> {
        let [left, right] = [self.search.reader.term(a)?, self.search.reader.term(b)?];
        let difference = self.search.reader.graph.sub(a, b);
        [Sense::Less, Sense::LessOrEqual].into_iter().find_map(|sense| {
            let says = Relation { left: left.clone(), sense, right: right.clone() };
            let plain = self.search.push(Step::Sign { says: says.clone(), from: known.to_vec() });
            plain.or_else(|| {
                let found = self.signed(difference, sense, known)?;
                self.search.push(Step::Sign { says, from: vec![found] })
            })
        })
    }
}
