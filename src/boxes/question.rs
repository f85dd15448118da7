//! A claim over ranges as a question about cells.
//!
//! **In:** what a claim assumes and says. **Out:** [`Question`], which judges cells: see [`Part`].
//!
//! What a claim denotes is the same as along a motion, see [`denote`](claim::denote::denote): points take the place of times,
//! and equations among the assumptions select points, too. Nothing is combined here.

use super::signs::{Cell, Domain, Scratch, Signs, Truth, Variable};
use crate::derivation::{Claim, Ranged, Values};
use crate::expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational, Symbol};
use crate::findings::region::Part;
use crate::latex::{RelationKind, Scope};
use crate::verdict::{self, Possible, Proposition};

use claim::comparison::Group;
use claim::denote::denote;
use claim::program::Part as Compared;
use claim::surroundings::Surroundings;

use proof::{Condition, Identity, Premises, Proof, When};
use proved::agreement::answer;

/// Comparisons with the relations by which they are known on cells, for each sign of ±.
#[derive(Debug)]
struct Placed {
    group: Group,
    /// Whether it is about having values: then only the left sides of its equations are looked at.
    definedness: bool,
    /// `[sign][comparison]`.
    relations: Vec<Vec<Related>>,
}

/// A comparison by what is known of it on cells.
#[derive(Debug)]
struct Related {
    /// These must hold at once.
    relations: Vec<usize>,
    left: Expr,
    right: Expr,
    /// Whether it is proved to hold wherever all that is assumed does, and it has values.
    settled: bool,
}

/// The two sides of the formula that fails at a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Failing {
    /// As written.
    pub formula: String,
    /// Which of its components fails, where it has several.
    pub component: Option<String>,
    /// Left and right side; none for a formula without a value.
    pub sides: Option<(Expr, Expr)>,
}

/// See the module.
#[derive(Debug)]
pub(super) struct Question {
    pub signs: Signs,
    selectors: Vec<Placed>,
    /// What the atoms of the claim stand for: its parts, then its hypotheses, which select points as well.
    atoms: Vec<Placed>,
    hypotheses: usize,
    claim: Proposition,
    /// Whether every relation that is said is an identity.
    pub identical: bool,
    /// Equations that are identities: text, log₂ of the error probability, whether it follows from what is assumed.
    pub identities: Vec<(String, f64, bool)>,
    /// Equations that are not known to be identities.
    pub equations: Vec<String>,
}

/// Puts the definitions of symbols, and the single values of the ranges, into expressions.
pub(super) struct Insertion<'a> {
    scope: &'a Scope,
    values: FastMap<Leaf, Expr>,
    /// The formulas of fields, in which coordinates are still themselves.
    fields: FastMap<(Symbol, u16), Expr>,
}

impl<'a> Insertion<'a> {
    pub fn new(graph: &mut Graph, scope: &'a Scope, ranges: &[Ranged]) -> Insertion<'a> {
        let (mut values, mut fields) = (FastMap::default(), FastMap::default());
        let coordinates: Vec<Leaf> = graph.coordinates().collect();
        for ranged in ranges {
            if let Values::One(e) = ranged.values {
                // Single values may depend on those before them.
                if graph.is_field(ranged.leaf.symbol) {
                    let fixed = |leaf: Leaf| values.get(&leaf).copied().filter(|_| !coordinates.contains(&leaf));
                    let formula = graph.substitute(e, |_, leaf| fixed(leaf));
                    fields.insert((ranged.leaf.symbol, ranged.leaf.component), formula);
                } else {
                    let e = graph.substitute(e, |_, leaf| values.get(&leaf).copied());
                    values.insert(ranged.leaf, e);
                }
            }
        }
        Insertion { scope, values, fields }
    }

    /// The single value of a component.
    pub fn value(&self, leaf: Leaf) -> Option<Expr> {
        self.values.get(&leaf).copied()
    }

    /// `e`, in which only variables, unknowns and the sign of ± are left.
    pub fn put(&self, graph: &mut Graph, e: Expr, variables: &[Leaf]) -> Expr {
        let kept = |leaf: &Leaf| variables.contains(leaf) || self.values.contains_key(leaf);
        let mut e = e;
        // Definitions are acyclic: each is written in terms of earlier symbols. One that has a range of its own is not used.
        loop {
            let mut changed = false;
            e = graph.substitute(e, |_, leaf| {
                let definition = self.scope.definition(leaf.symbol).filter(|_| !kept(&leaf) && leaf.rate == 0)?;
                changed = true;
                definition.components.get(usize::from(leaf.component)).copied()
            });
            if !changed {
                // A field whose formula has no derivative keeps its name, and has no value.
                let formula = |symbol, component| self.fields.get(&(symbol, component)).copied();
                let e = graph.with_fields(e, formula).unwrap_or(e);
                return graph.substitute(e, |_, leaf| self.values.get(&leaf).copied());
            }
        }
    }
}

/// What is compared with 0. |l| ≤ r says that l ≤ r and −l ≤ r, which have slopes where |l| has none; the same for <, and for
/// a size on the right that is not exceeded.
fn without_absolute(graph: &mut Graph, kind: RelationKind, left: Expr, right: Expr) -> Vec<Expr> {
    let size = |graph: &Graph, e: Expr| match *graph.node(e) {
        Node::Unary(Op::Abs, inner) => Some(inner),
        _ => None,
    };
    let inner = match kind {
        RelationKind::Less | RelationKind::LessEqual => size(graph, left),
        RelationKind::Greater | RelationKind::GreaterEqual => size(graph, right),
        RelationKind::Equal | RelationKind::NotEqual => None,
    };
    let Some(inner) = inner else { return vec![graph.sub(left, right)] };
    let opposite = graph.neg(inner);
    let on_the_left = matches!(kind, RelationKind::Less | RelationKind::LessEqual);
    let one = |graph: &mut Graph, e: Expr| if on_the_left { graph.sub(e, right) } else { graph.sub(left, e) };
    vec![one(graph, inner), one(graph, opposite)]
}

impl Question {
    /// Compiles what a claim assumes and says; what it says of solutions is not looked at.
    ///
    /// # Errors
    /// A leaf without a value.
    pub fn new(graph: &mut Graph, claim: &Claim, put: &Insertion, variables: Vec<Variable>) -> Result<Question, Leaf> {
        let denoted = denote(graph, Surroundings::default(), claim, &Rational::ZERO);
        let mut question = Question {
            signs: Signs::new(variables),
            selectors: Vec::new(),
            atoms: Vec::new(),
            hypotheses: denoted.parts.len(),
            claim: denoted.claim,
            identical: false,
            identities: Vec::new(),
            equations: Vec::new(),
        };
        for selector in &denoted.selectors {
            let placed = question.placed(graph, &claim.scope, put, &selector.part)?;
            question.selectors.push(placed);
        }
        let mut hypotheses = Vec::new();
        for hypothesis in &denoted.hypotheses {
            hypotheses.push(question.placed(graph, &claim.scope, put, &hypothesis.part)?);
        }
        let given = question.given(graph, question.selectors.iter().chain(&hypotheses));
        let mut identical = !denoted.parts.is_empty();
        for part in &denoted.parts {
            let mut placed = question.placed(graph, &claim.scope, put, part)?;
            identical &= question.prove(graph, &mut placed, &given);
            question.atoms.push(placed);
        }
        question.atoms.extend(hypotheses);
        question.identical = identical;
        Ok(question)
    }

    /// What holds at every point at which the claim applies: what it assumes, and the signs of what has a range.
    fn given<'p>(&self, graph: &mut Graph, assumed: impl Iterator<Item = &'p Placed>) -> Premises {
        let mut out = Premises::default();
        for placed in assumed.filter(|p| !p.definedness && !p.group.branching && p.group.formula.is_none()) {
            for (related, c) in placed.relations.iter().flatten().zip(&placed.group.comparisons) {
                let (l, r) = (related.left, related.right);
                match c.kind {
                    RelationKind::Equal => out.give([(l, r)], When::Chosen),
                    RelationKind::NotEqual => out.nonzero.push(graph.sub(l, r)),
                    RelationKind::Greater => out.positive.push(graph.sub(l, r)),
                    RelationKind::Less => out.positive.push(graph.sub(r, l)),
                    RelationKind::GreaterEqual => out.not_negative.push(graph.sub(l, r)),
                    RelationKind::LessEqual => out.not_negative.push(graph.sub(r, l)),
                }
            }
        }
        for variable in &self.signs.variables {
            let own = graph.leaf(variable.leaf);
            let (low, high) = (variable.outer.lo(), variable.outer.hi());
            match (low, high) {
                _ if low > 0.0 => out.positive.push(own),
                _ if high < 0.0 => out.positive.push(graph.neg(own)),
                _ if low == 0.0 => out.not_negative.push(own),
                _ if high == 0.0 => out.not_negative.push(graph.neg(own)),
                _ => {}
            }
        }
        out
    }

    fn placed(&mut self, graph: &mut Graph, scope: &Scope, put: &Insertion, part: &Compared) -> Result<Placed, Leaf> {
        let variables: Vec<Leaf> = self.signs.variables.iter().map(|v| v.leaf).collect();
        let sign = scope.branch_sign();
        let definedness = part.is_definedness();
        let mut group = part.group.clone();
        if definedness {
            // Whether there is a value is known of the formula itself.
            group.comparisons.retain(|c| c.kind == RelationKind::Equal);
            group.formula = None;
        }
        let mut relations = Vec::new();
        for value in [1, -1].into_iter().take(if group.branching { 2 } else { 1 }) {
            let mut all = Vec::new();
            for c in &group.comparisons {
                let mut one = |e: Expr| {
                    let e = put.put(graph, e, &variables);
                    graph.rewrite(e, |g, leaf| (leaf == sign).then(|| g.integer(value)))
                };
                let (left, right) = (one(c.left), one(c.right));
                let (kind, terms) = match definedness {
                    true => (RelationKind::NotEqual, vec![left]),
                    false => (c.kind, without_absolute(graph, c.kind, left, right)),
                };
                let mut of = Vec::new();
                for d in terms {
                    of.push(self.signs.add(graph, d, kind)?);
                }
                all.push(Related { relations: of, left, right, settled: false });
            }
            relations.push(all);
        }
        Ok(Placed { group, definedness, relations })
    }

    /// Whether all that is said is equations that are identities, or follow from what is `given`, wherever they have values: then
    /// no interval has to see it.
    fn prove(&mut self, graph: &mut Graph, placed: &mut Placed, given: &Premises) -> bool {
        if placed.definedness {
            return false;
        }
        let mut all = placed.group.formula.is_none();
        let comparisons = &placed.group.comparisons;
        for (related, c) in placed.relations.iter_mut().flat_map(|of| of.iter_mut().zip(comparisons)) {
            let [relation] = related.relations[..] else {
                all = false;
                continue;
            };
            if self.signs.kind(relation) != RelationKind::Equal {
                all = false;
                continue;
            }
            let text = c.label.split("   [").next().unwrap_or_default().to_owned();
            let sides = [(related.left, related.right)];
            let mut proved = |premises: &Premises| match answer(graph, &sides, premises, None) {
                Ok((Identity::Proved(proof), _)) => Some(proof),
                _ => None,
            };
            let whole = |proof: &Proof| proof.conditions.iter().all(|c| c.leaves_out().is_none());
            // Where the formula for a rate of its own has no value nothing is said, see `Domain::Edges`.
            let own = |c: &Condition| c.leaves_out().is_none() || matches!(c, Condition::Rate(_));
            let identity = proved(&Premises::default()).filter(|proof| proof.conditions.iter().all(own));
            related.settled = identity.as_ref().is_some_and(whole);
            if let Some(proof) = &identity {
                self.signs.vanishes(relation);
                self.identities.push((text.clone(), proof.log2_error, false));
            }
            if !related.settled
                && let Some(proof) = proved(given).filter(whole)
            {
                // The same difference may be among what is assumed, where nothing is proved of it.
                related.settled = true;
                if identity.is_none() {
                    self.identities.push((text.clone(), proof.log2_error, true));
                }
            }
            if !related.settled {
                all = false;
                if identity.is_none() {
                    self.equations.push(text);
                }
            }
        }
        all
    }

    /// What is left possible of comparisons on a cell.
    fn value(&self, placed: &Placed, cell: &Cell, scratch: &mut Scratch) -> Possible {
        let mut signs = Vec::new();
        for of in &placed.relations {
            let known: Vec<Possible> = of.iter().map(|r| self.known(placed, r, cell, scratch)).collect();
            signs.push(placed.group.value(|c| known[c]));
        }
        placed.group.over_signs(signs.into_iter())
    }

    /// What is left possible of one comparison on a cell.
    fn known(&self, placed: &Placed, related: &Related, cell: &Cell, scratch: &mut Scratch) -> Possible {
        let each = related.relations.iter().map(|&r| match placed.definedness {
            true => self.known_of(r, Some(Domain::Edges), cell, scratch),
            false => self.known_of(r, related.settled.then_some(Domain::Open), cell, scratch),
        });
        each.fold(Possible::TRUE, Possible::and)
    }

    /// The same of one relation, which is true for certain where a domain is given: that in which it is at edges of rates.
    fn known_of(&self, relation: usize, settled: Option<Domain>, cell: &Cell, scratch: &mut Scratch) -> Possible {
        let domain = match self.signs.domain(relation, cell, scratch) {
            Domain::Edges => settled.unwrap_or(Domain::Edges),
            domain => domain,
        };
        let truth = if settled.is_some() { Truth::True } else { self.signs.truth(relation, cell, scratch) };
        match (domain, truth) {
            (Domain::Nowhere, _) => Possible::VOID,
            (Domain::Everywhere, Truth::True) => Possible::TRUE,
            (Domain::Everywhere, Truth::False) => Possible::FALSE,
            (Domain::Everywhere, Truth::Open) => Possible::OPEN,
            (Domain::Open, Truth::True) => Possible::TRUE_OR_VOID,
            (Domain::Open, Truth::False) => Possible::FALSE_OR_VOID,
            (Domain::Open, Truth::Open) | (Domain::Edges, _) => Possible::ANY,
        }
    }

    /// Whether the selectors hold on a cell.
    fn selected(&self, cell: &Cell, scratch: &mut Scratch) -> Possible {
        self.selectors.iter().fold(Possible::TRUE, |all, s| all.and(self.value(s, cell, scratch)))
    }

    /// Whether the assumptions hold on a cell; `False` where one holds at no point of it.
    pub fn applies(&self, cell: &Cell, scratch: &mut Scratch) -> Truth {
        let of = &self.atoms[self.hypotheses..];
        let all = of.iter().fold(self.selected(cell, scratch), |all, h| all.and(self.value(h, cell, scratch)));
        match (all == Possible::TRUE, all.may_be(verdict::Truth::True)) {
            (true, _) => Truth::True,
            (_, false) => Truth::False,
            _ => Truth::Open,
        }
    }

    /// The same, of a cell that was not looked at before.
    pub fn applies_now(&self, cell: &Cell, scratch: &mut Scratch) -> Truth {
        self.signs.begin(scratch);
        self.applies(cell, scratch)
    }

    /// Judges a cell.
    pub fn judge(&self, cell: &Cell, scratch: &mut Scratch) -> Part {
        self.signs.begin(scratch);
        let selected = self.selected(cell, scratch);
        if !selected.may_be(verdict::Truth::True) {
            return Part::NotApplicable;
        }
        let atoms: Vec<Possible> = self.atoms.iter().map(|a| self.value(a, cell, scratch)).collect();
        let whole = self.claim.value(&mut |n| atoms.get(n).copied().unwrap_or(Possible::ANY)).given(selected);
        match whole {
            Possible::TRUE => Part::Proved,
            Possible::FALSE => Part::Refuted,
            Possible::VOID => Part::NotApplicable,
            Possible::TRUE_OR_VOID => Part::Border,
            _ => Part::Undecided,
        }
    }

    /// Which formula fails at a point at which the claim does.
    pub fn failing(&self, cell: &Cell, scratch: &mut Scratch) -> Option<Failing> {
        self.signs.begin(scratch);
        for placed in &self.atoms[..self.hypotheses] {
            if self.value(placed, cell, scratch) != Possible::FALSE {
                continue;
            }
            let each = placed.relations.iter().flat_map(|of| of.iter().zip(&placed.group.comparisons));
            let each: Vec<_> = each.collect();
            let found = each.iter().find(|(r, _)| {
                let known = self.known(placed, r, cell, scratch);
                known == Possible::FALSE || placed.group.asserted && known == Possible::VOID
            });
            let (related, comparison) = found.or(each.first())?;
            let void = self.known(placed, related, cell, scratch) == Possible::VOID;
            let (label, component) = match comparison.label.split_once("   [") {
                Some((label, component)) => (label, Some(component.trim_end_matches(']').to_owned())),
                None => (comparison.label.as_str(), None),
            };
            let formula = label.strip_suffix(" has a value").unwrap_or(label).to_owned();
            return Some(Failing { formula, component, sides: (!void).then_some((related.left, related.right)) });
        }
        None
    }
}
