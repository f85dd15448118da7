//! The symbols that a formula may take one from in place of another.
//!
//! **In:** the declarations of a derivation and of a claim. **Out:** a [`Vocabulary`]: which symbols are of one kind, so that
//! a slip of the pen may put one for the other: the same shape, the same role, both angles or neither.

use crate::derivation::{Claim, Derivation, Motion, SymbolEntry};
use crate::expr::{Graph, Shape, Symbol};
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
}

impl Word {
    fn new(graph: &Graph, scope: &Scope, entry: &SymbolEntry) -> Option<Word> {
        let mut chains = latex::parse(&entry.name, scope).ok()?;
        let side = chains.pop()?.sides.pop()?;
        let NodeKind::Symbol(SymbolNode { name, sub, dots: 0, sup: None, .. }) = side.kind else { return None };
        let sub = sub.unwrap_or_default();
        let shape: &Shape = graph.shape(entry.symbol);
        let signs = sub.iter().any(|i| matches!(i, SubItem::Other(_)));
        // `L_i` with a formula in i is a vector: its letters are indices of it, not part of its name.
        let has_places = signs && shape.rank() > 0;
        let sub = if shape.rank() > 0 && entry.formula.is_some() { Vec::new() } else { sub };
        let diagonal = graph.is_diagonal(entry.symbol);
        Some(Word {
            name,
            sub,
            rank: shape.rank(),
            extents: shape.extents().to_vec(),
            moves: matches!(entry.role, Role::State | Role::Observable),
            is_function: !entry.arguments.is_empty(),
            is_own: false,
            has_places,
            role: entry.role,
            diagonal,
            angle: entry.angle,
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
    }
}

/// Whether a symbol has a value on some motion on which the claim is tried. What has none would be noticed by anybody.
fn is_known(derivation: &Derivation, claim: &Claim, symbol: Symbol) -> bool {
    let of_motions = |symbol: Symbol| {
        claim.trajectories.iter().any(|&t| {
            let trajectory = &derivation.trajectories[t];
            trajectory.states.contains(&symbol) || trajectory.parameter(symbol).is_some()
        })
    };
    let mut open = vec![symbol];
    let mut seen: Vec<Symbol> = Vec::new();
    while let Some(symbol) = open.pop() {
        if seen.contains(&symbol) {
            continue;
        }
        seen.push(symbol);
        match claim.scope.role(symbol) {
            Some(Role::State | Role::Parameter) if !of_motions(symbol) => return false,
            Some(Role::Observable | Role::Abbreviation) => {
                let components = claim.scope.definition(symbol).map_or(&[][..], |d| d.components.as_slice());
                open.extend(derivation.graph.leaves(components.iter().copied()).into_iter().map(|l| l.symbol));
            }
            _ => {}
        }
    }
    true
}

/// All symbols that a formula of a claim may use.
#[derive(Clone, Debug, Default)]
pub(super) struct Vocabulary {
    words: Vec<Word>,
}

impl Vocabulary {
    /// The symbols of the file, and those of the claim, which go before them.
    pub fn new(derivation: &Derivation, claim: &Claim) -> Vocabulary {
        let mut words: Vec<Word> = Vec::new();
        for entry in derivation.symbols.iter().chain(&claim.symbols) {
            if !is_known(derivation, claim, entry.symbol) {
                continue;
            }
            let Some(mut word) = Word::new(&derivation.graph, &claim.scope, entry) else { continue };
            word.is_own = claim.symbols.iter().any(|own| own.symbol == entry.symbol);
            match words.iter_mut().find(|w| w.name == word.name && w.sub == word.sub) {
                Some(hidden) => *hidden = word,
                None => words.push(word),
            }
        }
        Vocabulary { words }
    }

    /// The word that a symbol of a formula is, and how much of its subscript belongs to the name.
    pub fn word(&self, s: &SymbolNode) -> Option<(&Word, usize)> {
        let sub = s.sub.as_deref().unwrap_or(&[]);
        let named = |name: &str, tensors: bool| {
            let fits = |w: &&Word| w.name == name && sub.starts_with(&w.sub) && (w.rank > 0 || !tensors);
            self.words.iter().filter(fits).max_by_key(|w| w.sub.len()).map(|w| (w, w.sub.len()))
        };
        // `\boldsymbol\Omega` may stand for a declared vector `\Omega`, and `m_3` for a component of `{\bf m}`.
        named(&s.name, false).or_else(|| match s.name.split_once(':') {
            Some(("bf" | "vec", bare)) => named(bare, true),
            Some(_) => None,
            None => ["bf", "vec"].iter().find_map(|style| named(&format!("{style}:{}", s.name), true)),
        })
    }

    /// The words that may have been meant in place of one, in the order of their declaration.
    pub fn like<'v>(&'v self, word: &'v Word) -> impl Iterator<Item = &'v Word> {
        self.words.iter().filter(move |w| *w != word && w.is_like(word))
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
