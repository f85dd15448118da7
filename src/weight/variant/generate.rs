//! Claims → variants: edited formulas with a meaning of their own.
//!
//! **In:** a claim. **Out:** [`ClaimVariants`]: for every formula that can be judged time by time its residuals, and those of
//! every edit of it that means something else; for all other edits, what became of them.
//!
//! Variants live in a copy of the graph: the many nodes are nobody else's burden. They may only ask for values that a motion
//! can give without being asked for a new time.

use std::collections::BTreeMap;
use std::ops::Range;

use super::edit::Edit;
use super::rate::Rate;
use super::sites::Sites;
use super::tree::walk;
use super::vocabulary::Vocabulary;
use crate::derivation::{Claim, Derivation, Form, FormFormula};
use crate::expr::{Expr, FastMap, Graph, Leaf, Rational, Tensor};
use crate::findings::{ClassCount, EditClass, SEED};
use crate::latex::syntax::{Chain, to_latex};
use crate::latex::{self, RelationKind, Scope, Statement};
use claim::comparison::{at_instant, magnitude_of};

/// One scalar equation or inequality: left − right, and how it is to be judged.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// What is claimed of the difference and 0.
    pub kind: RelationKind,
    /// Left − right, for every initial time.
    pub difference: Vec<Expr>,
    /// Both sides; the second is that of the first initial time.
    pub sides: (Expr, Expr),
}

/// What a formula is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Manner {
    /// Relations that hold at every time.
    Relation,
    /// Expressions that keep their value.
    Constant,
}

/// A formula of a claim that has variants.
#[derive(Clone, Debug)]
pub(super) struct Formula {
    /// As written.
    pub text: String,
    /// Its place in the file; none for a definition that stands for a name.
    pub place: Option<Range<usize>>,
    /// Its tree.
    pub tree: Chain,
    /// Relation or constant.
    pub manner: Manner,
    /// Its parts.
    pub parts: Vec<Part>,
    /// The size of the terms of each part, where a judgement needs it.
    pub magnitudes: Vec<Option<Expr>>,
    /// Whether a ± occurs.
    pub branching: bool,
    /// Of a scalar that is said to be constant, its rate, in rates of the states.
    pub rate: Option<Rate>,
}

/// An altered formula.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    /// What was altered.
    pub class: EditClass,
    /// Which formula.
    pub formula: usize,
    /// How the altered tree is made.
    pub source: Source,
    /// The parts that are not those of the formula: position, and the part.
    pub altered: Vec<(usize, Part)>,
}

/// Where the tree of an altered formula comes from. Most are never looked at again, so that a description is kept.
#[derive(Clone, Debug)]
pub(super) enum Source {
    /// An edit of the formula.
    Edit(Edit),
    /// The tree itself.
    Tree(Box<Chain>),
}

impl Variant {
    /// The altered tree of one of these formulas.
    pub fn tree(&self, formulas: &[Formula]) -> Chain {
        match &self.source {
            Source::Edit(edit) => edit.apply(&formulas[self.formula].tree),
            Source::Tree(tree) => (**tree).clone(),
        }
    }

    /// Its edit, where another says the same by an edit of another side.
    pub fn on_another_side(&self, other: &Variant) -> Option<Edit> {
        match (&self.source, &other.source) {
            (Source::Edit(own), Source::Edit(other)) if own.side != other.side => Some(own.clone()),
            _ => None,
        }
    }

    /// The altered formula, of one of these.
    pub fn text(&self, formulas: &[Formula]) -> String {
        match &self.source {
            Source::Edit(_) => to_latex(&self.tree(formulas)),
            Source::Tree(tree) => to_latex(tree),
        }
    }
}

/// Everything about the variants of one claim.
#[derive(Clone, Debug, Default)]
pub(super) struct ClaimVariants {
    /// Its formulas that have variants.
    pub formulas: Vec<Formula>,
    /// The variants.
    pub variants: Vec<Variant>,
    /// Edited formulas that are true by the definitions alone: no variants, but they may be what was meant.
    pub empty: Vec<Variant>,
    /// Edits of another side that say what a variant says: its position, and the edit. It may be the simpler to print.
    pub alike: Vec<(usize, Edit)>,
    /// What became of all edits.
    pub counts: BTreeMap<EditClass, ClassCount>,
    /// Formulas without variants, and why.
    pub skipped: Vec<(String, String)>,
}

/// What is needed to give an edited tree its meaning.
pub(super) struct Setting<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// The initial times.
    pub starts: &'a [Rational],
    /// Nodes below this are everybody's; times must be among them.
    pub shared: usize,
}

impl Setting<'_> {
    fn scope(&self) -> &Scope {
        &self.claim.scope
    }

    fn relation_parts(&self, graph: &mut Graph, statement: &Statement) -> Vec<Part> {
        let mut parts = Vec::new();
        for relation in &statement.relations {
            for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                let difference = graph.sub(l, r);
                let difference = vec![difference; self.starts.len()];
                parts.push(Part { kind: relation.kind, difference, sides: (l, r) });
            }
        }
        parts
    }

    fn constant_parts(&self, graph: &mut Graph, tensor: &Tensor) -> Vec<Part> {
        let one = |graph: &mut Graph, e: Expr| {
            let mut difference = Vec::new();
            let mut first = e;
            for (k, start) in self.starts.iter().enumerate() {
                let start = graph.constant(start.clone());
                let then = at_instant(graph, self.scope(), e, start);
                first = if k == 0 { then } else { first };
                difference.push(graph.sub(e, then));
            }
            Part { kind: RelationKind::Equal, difference, sides: (e, first) }
        };
        tensor.components.iter().map(|&e| one(graph, e)).collect()
    }

    /// The parts of a tree; `None` where it has no meaning, or another shape than `like` has.
    pub fn parts(&self, graph: &mut Graph, tree: &Chain, manner: Manner, like: usize) -> Option<Vec<Part>> {
        let parts = match manner {
            Manner::Relation => {
                let statement = latex::elaborate(tree, self.scope(), graph).ok()?;
                self.relation_parts(graph, &statement)
            }
            Manner::Constant => {
                let tensor = latex::elaborate_expression(tree.sides.first()?, self.scope(), graph).ok()?;
                self.constant_parts(graph, &tensor)
            }
        };
        let roots = parts.iter().flat_map(|p| p.difference.iter().copied());
        let known = |l: &Leaf| l.instant.is_none_or(|e| e.index() < self.shared);
        (parts.len() == like && graph.leaves(roots).iter().all(known)).then_some(parts)
    }

    /// The parts of an altered tree that are not those of the formula.
    pub fn altered(&self, graph: &mut Graph, formula: &Formula, tree: &Chain) -> Option<Vec<(usize, Part)>> {
        let parts = self.parts(graph, tree, formula.manner, formula.parts.len())?;
        let same = |(_, (new, old)): &(usize, (Part, &Part))| {
            new.sides == old.sides || new.sides == (old.sides.1, old.sides.0) && new.kind == RelationKind::Equal
        };
        let pairs = parts.into_iter().zip(&formula.parts).enumerate();
        let mut out: Vec<_> = pairs.filter(|pair| !same(pair)).map(|(at, (new, _))| (at, new)).collect();
        // One of four, mostly; and a file may have a million of them.
        out.shrink_to_fit();
        Some(out)
    }
}

/// The tree of a text, if it is one chain of relations, or one expression.
pub(super) fn tree(text: &str, scope: &Scope) -> Option<Chain> {
    let mut chains = latex::parse(text, scope).ok()?;
    chains.pop().filter(|_| chains.is_empty())
}

impl Formula {
    /// A formula that stands nowhere in a file, without inequalities.
    pub fn read(graph: &mut Graph, setting: &Setting, text: &str, manner: Manner) -> Option<Formula> {
        let tree = tree(text, &setting.claim.scope)?;
        let parts = match manner {
            Manner::Relation => {
                let statement = latex::elaborate(&tree, &setting.claim.scope, graph).ok()?;
                setting.relation_parts(graph, &statement)
            }
            Manner::Constant => {
                let tensor = latex::elaborate_expression(tree.sides.first()?, &setting.claim.scope, graph).ok()?;
                setting.constant_parts(graph, &tensor)
            }
        };
        let magnitudes = vec![None; parts.len()];
        let sign = setting.claim.scope.branch_sign();
        let branching = graph.leaves(parts.iter().map(|p| p.difference[0])).contains(&sign);
        Some(Formula { text: text.to_owned(), place: None, tree, manner, parts, magnitudes, branching, rate: None })
    }
}

/// The definition of a symbol, where a text is nothing but its name.
pub(super) fn defined_as<'a>(derivation: &'a Derivation, claim: &'a Claim, text: &str) -> Option<&'a str> {
    let symbols = claim.symbols.iter().rev().chain(&derivation.symbols);
    let named = symbols.into_iter().find(|s| s.name == text.trim())?;
    // The definition must mean here what it meant where it stands.
    let hidden = claim.symbols.iter().any(|s| derivation.symbols.iter().any(|d| d.name == s.name));
    if hidden || !named.arguments.is_empty() { None } else { named.formula.as_deref() }
}

/// A formula before its tree is looked at: what it is for, its text and place, its parts, whether a ± occurs.
type Taken<'a> = (Manner, &'a str, Option<&'a Range<usize>>, Vec<Part>, bool);

/// The formulas of a claim that can be altered; the others, with the reason.
fn formulas(derivation: &Derivation, graph: &mut Graph, setting: &Setting) -> (Vec<Formula>, Vec<(String, String)>) {
    let claim = setting.claim;
    let mut out = Vec::new();
    let mut skipped = Vec::new();
    let mut written: Vec<Taken> = Vec::new();
    for form in &claim.forms {
        let mut relation = |text: &'_ str, value: &Statement| {
            if value.relations.iter().any(|r| r.limit.is_some()) {
                skipped.push((text.to_owned(), "a limit is no relation at a time".to_owned()));
                return None;
            }
            let branching = value.relations.iter().any(|r| r.has_branches);
            Some((Manner::Relation, setting.relation_parts(graph, value), branching))
        };
        match form {
            Form::Always(w) => {
                if let Some((manner, parts, branching)) = relation(&w.text, &w.value) {
                    written.push((manner, &w.text, Some(&w.span), parts, branching));
                }
            }
            Form::Solves { system } => {
                for w in &derivation.systems[*system].equations {
                    if let Some((manner, parts, branching)) = relation(&w.text, &w.value) {
                        written.push((manner, &w.text, Some(&w.span), parts, branching));
                    }
                }
            }
            Form::FirstIntegral(w) => {
                // Of a quantity that is only named, the definition is what can be wrong.
                let named = defined_as(derivation, claim, &w.text);
                let meant = named.and_then(|text| latex::read_expression(text, &claim.scope, graph).ok());
                let (text, place, value) = match (named, &meant) {
                    (Some(text), Some(value)) if value.shape == w.value.shape => (text, None, value),
                    _ => (w.text.as_str(), Some(&w.span), &w.value),
                };
                let parts = setting.constant_parts(graph, value);
                written.push((Manner::Constant, text, place, parts, false));
            }
            other => {
                let key = other.kind().key();
                let texts = other.formulas().into_iter().filter_map(|formula| match (formula, other) {
                    (FormFormula::Limit { .. }, _) | (FormFormula::Statement(_), Form::Independent { .. }) => None,
                    (FormFormula::Statement(w), _) => Some(w.text.as_str()),
                    (FormFormula::Quantity(w), _) => Some(w.text.as_str()),
                });
                let mut texts: Vec<&str> = texts.collect();
                if texts.is_empty() {
                    texts.push(key);
                }
                let reason = |text: &str| (text.to_owned(), format!("what `{key}` says is no relation at a time"));
                skipped.extend(texts.into_iter().map(reason));
            }
        }
    }
    for (manner, text, place, parts, branching) in written {
        let Some(tree) = tree(text, &claim.scope) else {
            skipped.push((text.to_owned(), "it is not one chain of relations".to_owned()));
            continue;
        };
        let mut size = |p: &Part| {
            let (l, r) = p.sides;
            (p.kind != RelationKind::Equal).then(|| magnitude_of(graph, &claim.scope, l, r))
        };
        let magnitudes = parts.iter().map(&mut size).collect();
        let text = text.trim().to_owned();
        let place = place.cloned();
        let rate = match parts.as_slice() {
            [part] if manner == Manner::Constant => Rate::of(graph, claim, part.sides.0),
            _ => None,
        };
        out.push(Formula { text, place, tree, manner, parts, magnitudes, branching, rate });
    }
    (out, skipped)
}

/// Whether the one component of a constant is a power of the printed one: then each is constant if the other is.
fn is_power(graph: &mut Graph, formula: &Formula, altered: &[(usize, Part)]) -> bool {
    let ([(_, new)], [old]) = (altered, formula.parts.as_slice()) else { return false };
    (-3..=3).any(|n| n != 0 && graph.powi(old.sides.0, n) == new.sides.0)
}

/// Most edits of a formula that are looked at; of a formula that has more, they are drawn, and it says so.
const MOST_EDITS: usize = 1500;
/// Fewest edits that are looked at where there are more, however large a formula is.
const FEWEST_EDITS: usize = 16;
/// The work that the edits of a claim may take, in nodes: of the trees that are built, and of what they mean.
pub(super) const MOST_NODES: usize = 400_000;

impl Formula {
    /// What one altered formula takes, in nodes: a tree that is read, and at worst all of what it means.
    pub fn size(&self, graph: &Graph) -> usize {
        let meaning = graph.reachable(self.parts.iter().flat_map(|p| [p.sides.0, p.sides.1])).len();
        let mut nodes = Vec::new();
        self.tree.sides.iter().for_each(|side| walk(side, &mut nodes));
        (meaning + nodes.len()).max(1)
    }
}

/// At most `most` of `count` positions, in order: one from each of as many stretches of one length. Which one is drawn, so that
/// what comes at regular distances is not always the same kind of edit.
pub(super) fn drawn(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let mut state = SEED;
    (0..count.min(most)).map(move |k| {
        if count <= most {
            return k;
        }
        let (from, to) = (k * count / most, (k + 1) * count / most);
        // Knuth's multiplier; the upper half of the bits is what is random.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (state >> 33) as usize % (to - from)
    })
}

impl ClaimVariants {
    /// All edits of all formulas of a claim that mean something else than any before them.
    /// `room`: the work that they may take, in nodes.
    pub fn new(derivation: &Derivation, graph: &mut Graph, setting: &Setting, room: usize) -> ClaimVariants {
        // Without a motion nothing is tried.
        if setting.starts.is_empty() {
            return ClaimVariants::default();
        }
        let vocabulary = Vocabulary::new(derivation, setting.claim);
        let (formulas, skipped) = formulas(derivation, graph, setting);
        let mut out = ClaimVariants { skipped, ..ClaimVariants::default() };
        let mut seen: FastMap<(usize, Vec<(usize, Expr)>), ()> = FastMap::default();
        for (at, formula) in formulas.iter().enumerate() {
            let sites = Sites::new(&formula.tree, &vocabulary);
            let most = (room / formulas.len() / formula.size(graph)).clamp(FEWEST_EDITS, MOST_EDITS);
            let left = sites.count().saturating_sub(most);
            if left > 0 {
                out.skipped.push((formula.text.clone(), format!("{left} more edits were not looked at")));
            }
            for edit in sites.at(&mut drawn(sites.count(), most)) {
                let class = edit.class;
                let count = out.count(class);
                count.generated += 1;
                let tree = edit.apply(&formula.tree);
                let Some(altered) = setting.altered(graph, formula, &tree) else {
                    count.meaningless += 1;
                    continue;
                };
                if altered.is_empty() || formula.manner == Manner::Constant && is_power(graph, formula, &altered) {
                    count.equivalent += 1;
                    continue;
                }
                let key: Vec<(usize, Expr)> = altered.iter().map(|(i, p)| (*i, p.difference[0])).collect();
                if seen.insert((at, key), ()).is_some() {
                    count.repeated += 1;
                    continue;
                }
                count.kept += 1;
                let source = Source::Edit(edit);
                out.variants.push(Variant { class, formula: at, source, altered });
            }
        }
        out.formulas = formulas;
        out
    }

    /// The count of a class.
    pub fn count(&mut self, class: EditClass) -> &mut ClassCount {
        self.counts.entry(class).or_insert(ClassCount {
            class,
            generated: 0,
            meaningless: 0,
            repeated: 0,
            equivalent: 0,
            empty: 0,
            kept: 0,
        })
    }

    /// Everything that is evaluated.
    pub fn expressions_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let sizes = self.formulas.iter_mut().flat_map(|f| {
            let parts = f.parts.iter_mut().flat_map(|p| &mut p.difference);
            parts.chain(f.magnitudes.iter_mut().flatten())
        });
        sizes.chain(self.variants.iter_mut().flat_map(|v| &mut v.altered).flat_map(|(_, p)| &mut p.difference))
    }

    /// Everything that is evaluated for one initial time.
    pub fn roots(&self, start: usize) -> Vec<Expr> {
        let own = self
            .formulas
            .iter()
            .flat_map(|f| &f.parts)
            .chain(self.variants.iter().flat_map(|v| v.altered.iter().map(|(_, p)| p)));
        let sizes = self.formulas.iter().flat_map(|f| &f.magnitudes).flatten().copied();
        own.map(|p| p.difference[start]).chain(sizes).collect()
    }
}
