//! Pairs of canonical variables: which momentum belongs to which coordinate.
//!
//! **In:** a momentum, and the name of its coordinate, as they are declared. **Out:** the pairs, component by component.
//! **Guaranteed:** both are real, of one kind and of one shape, neither is given by a formula, and none stands in two pairs.

use super::{DeclareError, Role, Scope};
use diag::Problem;
use expr::{Graph, Leaf, Symbol};

impl Scope {
    /// Says that `momentum` is conjugate to the symbol that is declared as `of`: {of, momentum} = 1, component by component.
    ///
    /// # Errors
    /// [`DeclareError::Formula`], with a place in `of`.
    pub fn set_momentum(&mut self, graph: &Graph, momentum: Symbol, of: &str) -> Result<(), DeclareError> {
        let wrong = |message: String, hint: &str| {
            let hint = Some(hint.to_owned());
            Err(DeclareError::Formula(vec![Problem { code: "latex::bad-name", message, span: 0..of.len(), hint }]))
        };
        let Some(place) = self.symbol(of) else {
            return wrong(format!("`{of}` is not declared"), "declare it before its momentum");
        };
        let (Some(p), Some(q)) = (self.by_symbol(momentum), self.by_symbol(place)) else {
            return wrong(format!("`{of}` is not declared"), "declare it before its momentum");
        };
        if p.role != q.role || !matches!(p.role, Role::State | Role::Coordinate | Role::Parameter) {
            let hint = "canonical variables are two states, two coordinates of fields, or two parameters";
            return wrong(format!("`{of}` and `{}` are not of one kind", p.key), hint);
        }
        let alike = graph.shape(momentum) == graph.shape(place)
            && graph.component_count(momentum) == graph.component_count(place);
        if !alike || p.complex || q.complex || p.definition.is_some() || q.definition.is_some() {
            let hint = "both are real, of one shape, and have no formula";
            return wrong(format!("`{of}` and `{}` are no pair of canonical variables", p.key), hint);
        }
        if place == momentum || self.pairs.iter().any(|&(a, b)| [a, b].iter().any(|s| [place, momentum].contains(s))) {
            let hint = "a coordinate has one momentum, and no momentum has one";
            return wrong(format!("`{of}` or `{}` stands in a pair already", p.key), hint);
        }
        self.pairs.push((place, momentum));
        Ok(())
    }

    /// The pairs of canonical variables, each a coordinate and its momentum. Those that another declaration hides are among
    /// them: formulas that were read before still mean them.
    pub(crate) fn canonical_pairs(&self, graph: &Graph) -> Vec<(Leaf, Leaf)> {
        let components = |symbol: Symbol| 0..graph.component_count(symbol) as u16;
        let pairs = self.pairs.iter();
        pairs.flat_map(|&(q, p)| components(q).map(move |c| (Leaf::now(q, c), Leaf::now(p, c)))).collect()
    }

    /// Whether a symbol is the momentum of another.
    pub(super) fn is_momentum(&self, symbol: Symbol) -> bool {
        self.pairs.iter().any(|&(_, p)| p == symbol)
    }

    /// Whether a symbol stands in a pair of canonical variables.
    pub(crate) fn is_canonical(&self, symbol: Symbol) -> bool {
        self.pairs.iter().any(|&(q, p)| q == symbol || p == symbol)
    }
}
