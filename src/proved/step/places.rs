//! Fields at places: values at equal places are equal, and what is given by a formula at all places is that formula.
//!
//! **In:** a claim about fields, and what is given. **Out:** what follows of single values, as further equations that are given; or the same
//! question without the fields. **Guaranteed:** two places count as equal where that is proved of their coordinates, no case left out, and
//! for nothing but what the places themselves need; a field is replaced where it is given at all places, by a formula of its coordinates.

use super::definitions::Definitions;
use super::gather::{Gathered, sides};
use super::{Pairs, Step, without_exceptions};
use crate::expr::{Expr, FastMap, Graph, Leaf, Node, Symbol};
use proof::{Identity, Options, Wanted, When, domains};

/// Most values of fields that are compared with each other.
const MOST_PLACES: usize = 8;

impl Step<'_> {
    /// What a leaf of a field is taken at: what stands for each of its coordinates.
    fn place_of(&mut self, leaf: Leaf) -> Vec<(usize, Expr)> {
        let field = self.graph.field_of(leaf.symbol);
        let put = self.graph.place(leaf.symbol).map(|p| p.at.clone()).unwrap_or_default();
        let own: Vec<Leaf> = self.graph.coordinates().collect();
        let mut out = Vec::new();
        for (at, coordinate) in own.into_iter().enumerate() {
            if !self.graph.depends(field, at) {
                continue;
            }
            let there = put.iter().find(|(of, _)| *of == at).map(|(_, e)| *e);
            out.push((at, there.unwrap_or_else(|| self.graph.leaf(coordinate))));
        }
        out
    }

    /// Values of a field at places that are equal, given what is known, are equal.
    pub(super) fn give_equal_places(&mut self, gathered: &mut Gathered, equations: &Pairs) {
        let leaves = self.graph.leaves_within(sides(equations).chain(gathered.premises.sides()));
        let leaves: Vec<Leaf> = leaves.into_iter().filter(|l| self.graph.is_field(l.symbol)).collect();
        let placed = leaves.iter().filter(|l| self.graph.place(l.symbol).is_some()).count();
        if placed == 0 || leaves.len() > MOST_PLACES {
            return;
        }
        for (at, &leaf) in leaves.iter().enumerate() {
            for &other in &leaves[..at] {
                let alike = |l: Leaf| (self.graph.field_of(l.symbol), l.component, l.partials, l.rate, l.instant);
                if alike(leaf) != alike(other) {
                    continue;
                }
                let both = self.place_of(leaf).into_iter().zip(self.place_of(other));
                let apart: Pairs = both.map(|((_, a), (_, b))| (a, b)).filter(|(a, b)| a != b).collect();
                if apart.is_empty() || !self.are_equal(gathered, &apart) {
                    continue;
                }
                let moving = sides(&apart).any(|e| self.depends(e));
                let when = if moving { When::Chosen } else { When::Always };
                let pair = (self.graph.leaf(other), self.graph.leaf(leaf));
                gathered.premises.give([pair], when);
            }
        }
    }

    /// What is known of fields at all places is so at those that are named, where it has a value wherever fields have one: signs, and
    /// equations that name a place themselves. From f(0)f = 0 follows f(0)² = 0.
    pub(super) fn give_at_places(&mut self, gathered: &mut Gathered, equations: &Pairs) {
        let named = self.graph.leaves_within(sides(equations).chain(gathered.premises.sides()));
        let mut places: Vec<Vec<(usize, Expr)>> =
            named.iter().filter_map(|l| self.graph.place(l.symbol)).map(|p| p.at.clone()).collect();
        places.sort_unstable();
        places.dedup();
        places.truncate(MOST_PLACES);
        if places.is_empty() || gathered.known != When::Always {
            return;
        }
        let coordinates: Vec<Leaf> = self.graph.coordinates().collect();
        let premises = &mut gathered.premises;
        let of_fields = |graph: &Graph, e: &[Expr]| graph.fields(e.iter().copied()).len();
        let at_places = |graph: &Graph, e: &[Expr]| {
            graph.fields(e.iter().copied()).iter().filter(|l| graph.place(l.symbol).is_some()).count()
        };
        for place in &places {
            let values: Vec<(Leaf, Expr)> = place.iter().map(|&(c, e)| (coordinates[c], e)).collect();
            let everywhere = &gathered.throughout;
            for (signs, known) in [
                (&mut premises.nonzero, &everywhere.nonzero),
                (&mut premises.positive, &everywhere.positive),
                (&mut premises.not_negative, &everywhere.not_negative),
            ] {
                for &sign in known {
                    if of_fields(&self.graph, &[sign]) == 0 || !self.graph.needs_below([sign]).is_empty() {
                        continue;
                    }
                    let there = self.graph.taken_at(sign, &values);
                    if !signs.contains(&there) {
                        signs.push(there);
                    }
                }
            }
            for known in premises.equations.clone() {
                let both = [known.left, known.right];
                let placed = at_places(&self.graph, &both);
                let is_mixed = placed > 0 && placed < of_fields(&self.graph, &both);
                if known.when != When::Always || !is_mixed || !self.graph.needs_below(both).is_empty() {
                    continue;
                }
                let there = both.map(|e| self.graph.taken_at(e, &values));
                if there != both && there[0] != there[1] && !premises.says((there[0], there[1])) {
                    premises.give([(there[0], there[1])], When::Always);
                }
            }
        }
    }

    /// Whether equations are proved wherever their sides have values.
    fn are_equal(&mut self, gathered: &Gathered, equations: &Pairs) -> bool {
        let premises = self.premises(gathered, equations, Definitions::All);
        let options = Options { attempts: super::FEW_POINTS, wanted: Wanted::Proof, ..Options::default() };
        let found = self.test_only(&premises, equations, &options);
        let roots: Vec<Expr> = sides(equations).collect();
        let own = domains(&mut self.graph, &roots);
        let known = |proof: &proof::Proof| proof.conditions.iter().all(|c| own.contains(c));
        without_exceptions(&found) && matches!(&found, Identity::Proved(proof) if known(proof))
    }

    /// The same question with fields that are given by formulas of their coordinates replaced by these.
    pub(super) fn put_in_fields(&mut self, gathered: &mut Gathered, equations: &mut Pairs) {
        let mut formulas: FastMap<(Symbol, u16), Expr> = FastMap::default();
        for known in gathered.premises.equations.iter().filter(|k| k.when == When::Always) {
            for (field, formula) in [(known.left, known.right), (known.right, known.left)] {
                let Node::Leaf(leaf) = *self.graph.node(field) else { continue };
                if self.is_formula_of(leaf, formula) {
                    formulas.entry((leaf.symbol, leaf.component)).or_insert(formula);
                }
            }
        }
        if formulas.is_empty() {
            return;
        }
        let Some(mut put) = self.with_formulas(gathered, equations, &formulas) else { return };
        put.0.premises.equations.retain(|k| k.left != k.right || !self.graph.needs_below([k.left]).is_empty());
        // What is left of places alone would have to be so at all of them: that is another question.
        let of_places = |e: Expr| self.graph.leaves_within([e]).iter().any(|l| self.graph.coordinate(*l).is_some());
        let fields = |pair: (Expr, Expr)| self.graph.fields([pair.0, pair.1]).is_empty();
        let kept = put.0.premises.pairs().chain(put.0.systems.iter().copied());
        if kept.into_iter().any(|(l, r)| l != r && fields((l, r)) && (of_places(l) || of_places(r))) {
            return;
        }
        (*gathered, *equations) = put;
    }

    /// Whether a leaf is a field at the places at hand, and a formula one of its coordinates alone.
    fn is_formula_of(&self, leaf: Leaf, formula: Expr) -> bool {
        let here = self.graph.is_field(leaf.symbol) && self.graph.place(leaf.symbol).is_none();
        let value = leaf.partials.is_none() && leaf.rate == 0 && leaf.instant.is_none();
        let own = |l: &Leaf| match self.graph.coordinate(*l) {
            Some(at) => self.graph.depends(leaf.symbol, at),
            None => !self.graph.is_field(l.symbol) && !self.claim.scope.moves(l) && l.instant.is_none(),
        };
        here && value && self.graph.leaves_within([formula]).iter().all(own)
    }

    fn with_formulas(
        &mut self,
        gathered: &Gathered,
        equations: &Pairs,
        formulas: &FastMap<(Symbol, u16), Expr>,
    ) -> Option<(Gathered, Pairs)> {
        let (mut gathered, mut equations) = (gathered.clone(), equations.clone());
        let graph = &mut self.graph;
        let mut put = |e: &mut Expr| -> Option<()> {
            *e = graph.with_fields(*e, |symbol, component| formulas.get(&(symbol, component)).copied()).ok()?;
            Some(())
        };
        for (l, r) in equations.iter_mut().chain(&mut gathered.systems) {
            put(l)?;
            put(r)?;
        }
        for premises in [&mut gathered.premises, &mut gathered.throughout] {
            for known in &mut premises.equations {
                put(&mut known.left)?;
                put(&mut known.right)?;
            }
            for e in premises.nonzero.iter_mut().chain(&mut premises.positive).chain(&mut premises.not_negative) {
                put(e)?;
            }
        }
        Some((gathered, equations))
    }
}
