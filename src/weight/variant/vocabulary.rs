//! The symbols that a formula may take one from in place of another.
//!
//! **In:** the declarations of a derivation and of a claim. **Out:** a [`Vocabulary`]: which symbols are of one kind, so that
//! a slip of the pen may put one for the other: the same shape, the same role, both angles or neither.

use crate::derivation::{Claim, Derivation, Motion, SymbolEntry};
use crate::expr::{FastMap, Graph, Shape, Symbol};
use crate::latex::syntax::{Chain, Name, NodeKind, SubItem, SymbolNode};
use crate::latex::{self, Role, Scope};

/// A declared symbol as a formula writes it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Word {
    /// Its name.
    pub name: Name,
    /// The part of the subscript that belongs to the name, as in `\psi_0`.
    pub sub: Vec<SubItem>,
    /// Number of indices that its components have; 0 for a scalar.
    pub rank: usize,
    /// To where each index runs.
    pub extents: Vec<u16>,
    /// Whether it changes along a motion.
    pub moves: bool,
    /// Whether it is a function of arguments in parentheses.
    pub is_function: bool,
    /// Whether it is declared for the claim alone.
    pub is_own: bool,
    /// Whether an index of a formula stands inside its name, as in `I_{(1-2)}`.
    has_places: bool,
    role: Role,
    diagonal: bool,
    angle: bool,
    /// Whether its values are complex.
    pub complex: bool,
    /// Its kind: which words may stand in its place; none where no other may.
    kind: Option<usize>,
}

impl Word {
    fn new(graph: &Graph, scope: &Scope, entry: &SymbolEntry) -> Option<Word> {
        // Nobody slips from a quantity to a constant of nature, or to a unit, whose value is another by many powers of ten.
        if entry.role == Role::Parameter && entry.formula.is_some() {
            return None;
        }
        let mut chains = latex::parse(&entry.name, scope).ok()?;
        let side = chains.pop()?.sides.pop()?;
        let NodeKind::Symbol(SymbolNode { name, sub, dots: 0, sup: None, .. }) = side.kind else { return None };
        let sub = sub.unwrap_or_default();
        let shape: &Shape = graph.shape(entry.symbol);
        let signs = sub.iter().any(|i| matches!(i, SubItem::Other(_)));
        // `L_i` with a formula in i is a vector: its letters are indices of it, not part of its name.
        let rank = shape.real_extents().len();
        let has_places = signs && rank > 0;
        let sub = if rank > 0 && entry.formula.is_some() { Vec::new() } else { sub };
        let diagonal = graph.is_diagonal(entry.symbol);
        Some(Word {
            name,
            sub,
            rank,
            extents: shape.real_extents().to_vec(),
            moves: matches!(entry.role, Role::State | Role::Observable),
            is_function: !entry.arguments.is_empty(),
            is_own: false,
            has_places,
            role: entry.role,
            diagonal,
            angle: entry.angle,
            complex: entry.complex,
            kind: None,
        })
    }

    fn is_like(&self, other: &Word) -> bool {
        let plain = |w: &Word| !w.is_function && !w.has_places && w.role != Role::Time;
        plain(self)
            && plain(other)
            && self.extents == other.extents
            && self.role == other.role
            && self.diagonal == other.diagonal
            && self.angle == other.angle
            && self.complex == other.complex
    }

    /// Whether one may be put for the other by mistake.
    pub fn may_be(&self, other: &Word) -> bool {
        self.kind.is_some() && self.kind == other.kind && self != other
    }

    /// Whether it is of another kind, and may change places with it nevertheless: an axis and a mass, say.
    pub fn may_change_places_with(&self, other: &Word) -> bool {
        let plain = |w: &Word| !w.is_function && !w.has_places;
        let alike = self.extents == other.extents && self.diagonal == other.diagonal && self.complex == other.complex;
        plain(self) && plain(other) && alike && !self.may_be(other) && self != other
    }
}

/// Which symbols have a value on some motion on which the claim is tried. What has none would be noticed by anybody.
struct Known<'a> {
    derivation: &'a Derivation,
    claim: &'a Claim,
    /// What has been found.
    found: FastMap<Symbol, bool>,
}

impl Known<'_> {
    fn is_known(&mut self, symbol: Symbol) -> bool {
        let (claim, graph) = (self.claim, &self.derivation.graph);
        // Definitions are acyclic, and may be as deep as the file is long: what is open, each with what it is made of.
        let mut open: Vec<(Symbol, Vec<Symbol>)> = Vec::new();
        let mut last = self.found.get(&symbol).copied();
        if last.is_none() {
            open.push((symbol, parts(claim, graph, symbol)));
        }
        while let Some((symbol, left)) = open.last_mut() {
            let symbol = *symbol;
            match left.pop() {
                Some(part) => match self.found.get(&part) {
                    Some(true) => {}
                    Some(false) => {
                        self.found.insert(symbol, false);
                        left.clear();
                    }
                    None => open.push((part, parts(claim, graph, part))),
                },
                None => {
                    let known = *self.found.get(&symbol).unwrap_or(&true) && self.is_given(symbol);
                    self.found.insert(symbol, known);
                    last = Some(known);
                    open.pop();
                    // What was waiting for it is as unknown.
                    if let (false, Some((waiting, left))) = (known, open.last_mut()) {
                        self.found.insert(*waiting, false);
                        left.clear();
                    }
                }
            }
        }
        last.unwrap_or(true)
    }

    /// Whether a state or a parameter has a value on some motion; true of all others. In a box, whether it has a value there; of
    /// fields whatever they are, everything may be.
    fn is_given(&self, symbol: Symbol) -> bool {
        if let Some(region) = &self.claim.region {
            let defined = matches!(self.claim.scope.role(symbol), Some(Role::Observable | Role::Abbreviation));
            return region.ranges.is_empty() || defined || region.ranges.iter().any(|r| r.leaf.symbol == symbol);
        }
        let on_some = || {
            self.claim.trajectories.iter().any(|&t| {
                let trajectory = &self.derivation.trajectories[t];
                trajectory.states.contains(&symbol) || trajectory.parameter(symbol).is_some()
            })
        };
        !matches!(self.claim.scope.role(symbol), Some(Role::State | Role::Parameter)) || on_some()
    }
}

/// The symbols in the definition of one.
fn parts(claim: &Claim, graph: &Graph, symbol: Symbol) -> Vec<Symbol> {
    if !matches!(claim.scope.role(symbol), Some(Role::Observable | Role::Abbreviation)) {
        return Vec::new();
    }
    let components = claim.scope.definition(symbol).map_or(&[][..], |d| d.components.as_slice());
    let mut out: Vec<Symbol> = graph.leaves(components.iter().copied()).into_iter().map(|l| l.symbol).collect();
    out.dedup();
    out.retain(|part| *part != symbol);
    out
}

/// All symbols that a formula of a claim may use.
#[derive(Clone, Debug, Default)]
pub(super) struct Vocabulary {
    words: Vec<Word>,
    /// The positions of the words of a name.
    by_name: FastMap<Name, Vec<usize>>,
    /// The positions of the words of a kind.
    kinds: Vec<Vec<usize>>,
}

impl Vocabulary {
    /// The symbols of the file, and those of the claim, which go before them.
    pub fn new(derivation: &Derivation, claim: &Claim) -> Vocabulary {
        let mut words: Vec<Word> = Vec::new();
        let mut by_name: FastMap<Name, Vec<usize>> = FastMap::default();
        let mut known = Known { derivation, claim, found: FastMap::default() };
        for entry in derivation.symbols.iter().chain(&claim.symbols) {
            if !known.is_known(entry.symbol) {
                continue;
            }
            let Some(mut word) = Word::new(&derivation.graph, &claim.scope, entry) else { continue };
            word.is_own = claim.symbols.iter().any(|own| own.symbol == entry.symbol);
            let named = by_name.entry(word.name.clone()).or_default();
            match named.iter().copied().find(|&at| words[at].sub == word.sub) {
                Some(hidden) => words[hidden] = word,
                None => {
                    named.push(words.len());
                    words.push(word);
                }
            }
        }
        let mut kinds: Vec<Vec<usize>> = Vec::new();
        for at in 0..words.len() {
            // There are few kinds: a shape, a role, an angle or not.
            let kind = kinds.iter().position(|kind| words[kind[0]].is_like(&words[at]));
            let kind = kind.or_else(|| words[at].is_like(&words[at]).then_some(kinds.len()));
            words[at].kind = kind;
            match kind {
                Some(new) if new == kinds.len() => kinds.push(vec![at]),
                Some(known) => kinds[known].push(at),
                None => {}
            }
        }
        Vocabulary { words, by_name, kinds }
    }

    /// The word that a symbol of a formula is, and how much of its subscript belongs to the name.
    pub fn word(&self, s: &SymbolNode) -> Option<(&Word, usize)> {
        let sub = s.sub.as_deref().unwrap_or(&[]);
        let named = |name: &str, tensors: bool| {
            let fits = |w: &&Word| sub.starts_with(&w.sub) && (w.rank > 0 || !tensors);
            let named = self.by_name.get(name).into_iter().flatten().map(|&at| &self.words[at]);
            named.filter(fits).max_by_key(|w| w.sub.len()).map(|w| (w, w.sub.len()))
        };
        // `\boldsymbol\Omega` may stand for a declared vector `\Omega`, and `m_3` for a component of `{\bf m}`.
        named(&s.name, false).or_else(|| match s.name.split_once(':') {
            Some(("bf" | "vec", bare)) => named(bare, true),
            Some(_) => None,
            None => ["bf", "vec"].iter().find_map(|style| named(&format!("{style}:{}", s.name), true)),
        })
    }

    /// The words that may have been meant in place of one, in the order of their declaration.
    pub fn like(&self, word: &Word) -> Vec<&Word> {
        let kind = word.kind.and_then(|kind| self.kinds.get(kind)).into_iter().flatten();
        kind.map(|&at| &self.words[at]).filter(|w| *w != word).collect()
    }

    /// Vectors and matrices.
    pub fn tensors(&self) -> impl Iterator<Item = &Word> {
        self.words.iter().filter(|w| w.rank > 0 && !w.is_function && !w.has_places)
    }

    /// The scalars of a formula's language: everything without indices that is not a function. What is given comes first, the
    /// time before all, and what is computed last.
    pub fn scalars(&self) -> Vec<&Word> {
        let mut out: Vec<&Word> =
            self.words.iter().filter(|w| w.rank == 0 && !w.is_function && !w.has_places).collect();
        out.sort_by_key(|w| match w.role {
            Role::Time => 0,
            Role::Parameter => 1,
            Role::State => 2,
            _ => 3,
        });
        out
    }
}

impl Word {
    /// Whether it is a matrix that is given by one number for each index.
    pub fn is_diagonal(&self) -> bool {
        self.diagonal
    }

    /// The symbol by itself.
    pub fn symbol(&self) -> SymbolNode {
        SymbolNode {
            name: self.name.clone(),
            dots: 0,
            primed: false,
            sub: (!self.sub.is_empty()).then(|| self.sub.clone()),
            sup: None,
            sup_first: false,
            arguments: None,
            arguments_text: String::new(),
        }
    }
}

/// What else is written of the same matter: the other formulas of a claim, and the equations of the systems whose motions it
/// is tried on. What a formula lacks often stands there.
pub(super) fn phrases(derivation: &Derivation, claim: &Claim) -> Vec<Chain> {
    let mut texts: Vec<&str> = claim.formulas.iter().map(|f| f.text.as_str()).collect();
    texts.extend(claim.assuming.iter().map(|w| w.text.as_str()));
    for system in &derivation.systems {
        let moves = claim.trajectories.iter().any(|&t| {
            let motion = derivation.trajectories.get(t).map(|t| &t.motion);
            matches!(motion, Some(Motion::Integrated { system: of, .. }) if derivation.systems[*of].id == system.id)
        });
        if moves {
            texts.extend(system.equations.iter().map(|w| w.text.as_str()));
        }
    }
    texts.into_iter().filter_map(|text| latex::parse(text, &claim.scope).ok()).flatten().collect()
}
