//! What all points of a scene have in common, found once.
//!
//! **In:** a scene. **Out:** which leaves and angles are drawn, and what each definition needs before it has a value.

use super::{Bounds, Combinations, Expr, FastMap, FastSet, Generator, Leaf, Node, Rational, Scene, Values};

/// What all points of a scene have in common.
pub(in super::super) struct Frame {
    /// The leaves of the problem as given.
    pub(super) given: Vec<Leaf>,
    /// Leaves that are given as positive.
    pub(super) declared: FastSet<Leaf>,
    /// Where the leaves lie by what is given of each alone.
    pub(super) bounds: Bounds,
    /// The angles whose half-angle tangents are drawn: q and leaf, for arguments q·leaf.
    pub(super) angles: Vec<(Rational, Leaf)>,
    /// The leaves that are drawn if no angle is, and whether each is a root by which something it is of is defined.
    pub(super) drawn: Vec<(Leaf, bool)>,
    /// The leaves that a definition, or the argument of a generator, needs.
    pub(super) needs: FastMap<Expr, Vec<Leaf>>,
    /// For arguments of generators that are multiples of a leaf, the factor and the leaf.
    pub(super) multiples: FastMap<Expr, Option<(Rational, Leaf)>>,
}

impl Frame {
    /// Whether every leaf of a definition, or of the argument of a generator, has a value.
    pub(super) fn has_what_it_needs(&self, e: Expr, values: &Values) -> bool {
        self.needs.get(&e).is_some_and(|needs| needs.iter().all(|l| values.contains_key(l)))
    }
}

impl Scene<'_> {
    /// What is the same at all points.
    pub(in super::super) fn frame(&self) -> Frame {
        let all: Vec<Expr> = self.everything();
        let given = self.graph.leaves(all.iter().copied());
        let wanted = self.graph.leaves(all.into_iter().chain(self.lowered_exprs()));
        let leaf = |&e: &Expr| match self.graph.node(e) {
            Node::Leaf(l) => Some(*l),
            _ => None,
        };
        let arguments = || self.generators.list.iter().filter_map(Generator::argument);
        let definitions = self.defined.values().chain(self.explicit.values()).copied().chain(arguments());
        let multiples = arguments().map(|e| (e, self.multiple_of_leaf(e))).collect();
        // Roots by which something they are of is defined: they are chosen, and it follows.
        let chosen = self.chosen();
        let is_drawn = |&leaf: &Leaf| {
            let made = self.generators.get(leaf).is_some_and(|g| *g != Generator::Free && !chosen.contains(&leaf));
            !(made || self.explicit.contains_key(&leaf) || self.defined.contains_key(&leaf) || self.awaited(leaf))
        };
        Frame {
            angles: self.angles(&multiples),
            drawn: wanted.iter().copied().filter(is_drawn).map(|l| (l, chosen.contains(&l))).collect(),
            given,
            declared: self.positive.iter().filter_map(leaf).collect(),
            bounds: Bounds::of(self.graph, self.positive.iter().chain(self.not_negative).copied()),
            needs: definitions.map(|e| (e, self.graph.leaves([e]))).collect(),
            multiples,
        }
    }

    /// Angles that occur only as such, in the order of their cosines: their half-angle tangents may be drawn.
    fn angles(&self, multiples: &FastMap<Expr, Option<(Rational, Leaf)>>) -> Vec<(Rational, Leaf)> {
        let outside = self.lowered.iter().flat_map(|&(l, r)| [l, r]).chain(self.defined.values().copied());
        let outside: FastSet<Leaf> = self.graph.leaves(outside).into_iter().collect();
        let mut out = Vec::new();
        for at in 0..self.generators.list.len() {
            let Generator::Cosine(argument) = self.generators.list[at] else { continue };
            let Some(&Some((ref q, leaf))) = multiples.get(&argument) else { continue };
            if self.awaited(leaf) || self.explicit.contains_key(&leaf) || self.defined.contains_key(&leaf) {
                continue;
            }
            let others = self.generators.list.iter().enumerate().any(|(i, g)| match *g {
                Generator::Cosine(a) | Generator::Exponential(a) | Generator::Opaque(a) if i != at => {
                    self.graph.leaves([a]).contains(&leaf)
                }
                _ => false,
            });
            if !others && !outside.contains(&leaf) {
                out.push((q.clone(), leaf));
            }
        }
        out
    }

    /// The roots u^{1/n} for which a leaf of u is defined by the root.
    fn chosen(&self) -> Vec<Leaf> {
        let radicals = self.generators.radicals.iter();
        let roots =
            radicals.filter_map(|r| Some((self.generators.leaf(r.generator)?, self.generators.list.get(r.generator)?)));
        let defining = roots.filter(|&(leaf, generator)| {
            let own = generator.argument().map(|a| self.graph.leaves([a])).unwrap_or_default();
            own.iter().any(|l| self.defined.get(l).is_some_and(|&e| self.graph.leaves([e]).contains(&leaf)))
        });
        defining.map(|(leaf, _)| leaf).collect()
    }

    fn everything(&self) -> Vec<Expr> {
        let sides = self.claim.iter().chain(self.premises).flat_map(|&(l, r)| [l, r]);
        let facts = self.nonzero.iter().chain(self.positive).chain(self.not_negative);
        sides.chain(facts.copied()).collect()
    }

    fn lowered_exprs(&self) -> Vec<Expr> {
        let sides = self.lowered.iter().flat_map(|&(l, r)| [l, r]);
        let arguments = self.generators.list.iter().filter_map(Generator::argument);
        sides.chain(self.defined.values().copied()).chain(self.explicit.values().copied()).chain(arguments).collect()
    }

    /// q and leaf when e = q·leaf.
    fn multiple_of_leaf(&self, e: Expr) -> Option<(Rational, Leaf)> {
        let combination = Combinations::default().of(self.graph, e);
        let mut terms = combination.into_iter();
        let (Some((m, q)), None) = (terms.next(), terms.next()) else { return None };
        match m.as_slice() {
            &[(base, 1)] => match self.graph.node(base) {
                Node::Leaf(leaf) => Some((q, *leaf)),
                _ => None,
            },
            _ => None,
        }
    }
}
