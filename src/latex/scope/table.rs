//! The table of declarations: found by name, by key and by symbol, without looking at the others.
//!
//! **In:** entries, one after another. **Out:** those that have a name in common, or a symbol. **Guaranteed:** what hides another is found in
//! its place; formulas that were read before still find what they mean. The time of an answer does not grow with the number of
//! declarations, and a copy costs nothing until one of the two changes.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

use super::super::name;
use super::super::syntax::{Name, SubItem};
use super::entry::{Entry, Pattern, Role, labels, like_indices, same_kind};
use expr::Symbol;

/// What is asked of all declarations together: whether one is so.
#[derive(Clone, Copy)]
pub(super) enum Any {
    Complex,
    Moving,
    Labelled,
    Primed,
}

/// What is asked of all declarations of a name, but of the time.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    /// Depends on the time, and can have a subscript.
    MovesBelow,
    /// Depends on the time, and has no subscript.
    Moves,
    /// Is a vector or a matrix, and has no subscript.
    Tensor,
}

/// The places of declarations among all, in order.
type Places = Vec<u32>;

/// Declarations whose names may be taken for one another: they have other styles, primes or subscripts.
#[derive(Clone, Debug, Default)]
struct Like {
    /// Without a subscript.
    plain: Places,
    /// With labels for a subscript.
    labelled: HashMap<Vec<SubItem>, Places>,
    /// With indices in the subscript, as `I_{(n-k)}`.
    indexed: Places,
    /// Those with labels that could be indices of components.
    components: Places,
}

#[derive(Clone, Debug, Default)]
struct Inner {
    /// In order of declaration. What is hidden keeps its place.
    entries: Vec<Arc<Entry>>,
    hidden: HashSet<u32>,
    named: HashMap<Name, Like>,
    keyed: HashMap<String, Places>,
    /// By the number of the symbol.
    symbols: Vec<Option<u32>>,
    coordinates: Places,
    time: Option<u32>,
    /// How many are so, by [`Any`].
    counts: [usize; 4],
    /// The same by names without their first style and primes, by [`Kind`].
    kinds: HashMap<Name, [usize; 3]>,
    /// Names of several letters, by their lengths.
    words: BTreeMap<usize, HashSet<Name>>,
    /// Vectors and matrices beside which others have the names of components, `{\bf r}` beside `{\bf r}_1`.
    numbered: HashSet<Symbol>,
    /// Names whose declarations were refused, with their subscripts.
    refused: HashMap<Name, Vec<Vec<SubItem>>>,
    /// What was changed since the beginning of what will be undone.
    changes: Option<Changes>,
}

#[derive(Clone, Debug, Default)]
struct Changes {
    /// How many entries there were.
    entries: usize,
    hidden: Places,
    words: Vec<Name>,
    numbered: Vec<Symbol>,
}

/// The declarations of a scope.
#[derive(Clone, Debug, Default)]
pub(super) struct Table(Arc<Inner>);

/// What names have in common that may be taken for one another: the name without styles and primes.
fn core(name: &str) -> &str {
    let above = name.find('^').unwrap_or(name.len());
    let start = name[..above].rfind(':').map_or(0, |at| at + 1);
    name[start..].trim_end_matches('\'')
}

/// The name without its first style and primes.
pub(super) fn base(name: &str) -> &str {
    name::split(name).1.trim_end_matches('\'')
}

fn is(entry: &Entry) -> [bool; 4] {
    let mut out = [false; 4];
    out[Any::Complex as usize] = entry.complex;
    out[Any::Moving as usize] = entry.moving;
    out[Any::Labelled as usize] = name::labelled(&entry.name).is_some();
    out[Any::Primed as usize] = entry.name.ends_with('\'');
    out
}

fn kinds(entry: &Entry) -> [bool; 3] {
    let (below, counts) = (entry.rank > 0 || !entry.sub.is_empty(), entry.role != Role::Time);
    let plain = entry.sub.is_empty();
    let mut out = [false; 3];
    out[Kind::MovesBelow as usize] = counts && below && entry.moving;
    out[Kind::Moves as usize] = counts && plain && entry.moving;
    out[Kind::Tensor as usize] = counts && plain && entry.rank > 0;
    out
}

fn count(counts: &mut [usize], so: &[bool], add: bool) {
    for (count, so) in counts.iter_mut().zip(so) {
        *count = if add { *count + usize::from(*so) } else { *count - usize::from(*so) };
    }
}

impl Like {
    /// The lists in which a declaration with this subscript stands.
    fn lists(&mut self, sub: &[Pattern]) -> [Option<&mut Places>; 2] {
        let components = like_indices(sub).map(|_| &mut self.components);
        let list = match labels(sub) {
            Some(none) if none.is_empty() => &mut self.plain,
            Some(labels) => self.labelled.entry(labels).or_default(),
            None => &mut self.indexed,
        };
        [Some(list), components]
    }

    /// Places of those with just this subscript.
    fn of(&self, sub: &[SubItem]) -> &[u32] {
        if sub.is_empty() { &self.plain } else { self.labelled.get(sub).map_or(&[], Vec::as_slice) }
    }
}

impl Inner {
    fn at(&self, place: u32) -> Option<&Entry> {
        self.entries.get(place as usize).map(|e| &**e)
    }

    fn all_of<'t>(&'t self, places: &'t [u32]) -> impl DoubleEndedIterator<Item = &'t Entry> + Clone + 't {
        places.iter().filter_map(|at| self.at(*at))
    }

    /// Takes an entry out of all that it is found by but its symbol, or puts it there.
    fn set(&mut self, at: u32, is_found: bool) {
        let Some(entry) = self.entries.get(at as usize).cloned() else { return };
        let put = |places: &mut Places| match is_found {
            true => places.insert(places.partition_point(|other| *other < at), at),
            false => places.retain(|other| *other != at),
        };
        let like = self.named.entry(core(&entry.name).to_owned()).or_default();
        like.lists(&entry.sub).into_iter().flatten().for_each(put);
        put(self.keyed.entry(entry.key.clone()).or_default());
        match entry.role {
            Role::Coordinate => put(&mut self.coordinates),
            Role::Time => self.time = is_found.then_some(at),
            _ => {}
        }
        count(&mut self.counts, &is(&entry), is_found);
        count(self.kinds.entry(base(&entry.name).to_owned()).or_default(), &kinds(&entry), is_found);
        if is_found {
            self.hidden.remove(&at)
        } else {
            self.hidden.insert(at)
        };
    }
}

impl Table {
    /// Whether it is the same table, not one that says the same.
    pub fn is(&self, other: &Table) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Adds an entry. Those of the same name, which it hides, are found by their symbols alone.
    pub(super) fn add(&mut self, entry: Arc<Entry>) {
        let inner = Arc::make_mut(&mut self.0);
        let is_hidden = |at: &u32| {
            let same =
                |e: &Entry| e.name == entry.name && e.sub == entry.sub && same_kind(&e.arguments, &entry.arguments);
            inner.at(*at).is_some_and(same)
        };
        let places = inner.named.get(core(&entry.name)).map_or(&[][..], |like| match labels(&entry.sub) {
            Some(labels) => like.of(&labels),
            None => &like.indexed,
        });
        let hidden: Places = places.iter().copied().filter(is_hidden).collect();
        inner.changes.iter_mut().for_each(|changes| changes.hidden.extend(&hidden));
        hidden.into_iter().for_each(|at| inner.set(at, false));
        let at = inner.entries.len() as u32;
        let number = entry.symbol.index();
        inner.symbols.resize(inner.symbols.len().max(number + 1), None);
        inner.symbols[number] = Some(at);
        inner.entries.push(entry);
        inner.set(at, true);
    }

    /// What is declared from here on will be taken back by [`undo`](Table::undo).
    pub(super) fn begin(&mut self) {
        let inner = Arc::make_mut(&mut self.0);
        inner.changes = Some(Changes { entries: inner.entries.len(), ..Changes::default() });
    }

    /// Takes back what was declared since [`begin`](Table::begin): what it was.
    pub(super) fn undo(&mut self) -> Vec<Arc<Entry>> {
        let inner = Arc::make_mut(&mut self.0);
        let Some(changes) = inner.changes.take() else { return Vec::new() };
        for at in (changes.entries..inner.entries.len()).map(|at| at as u32) {
            if !inner.hidden.contains(&at) {
                inner.set(at, false);
            }
            inner.hidden.remove(&at);
        }
        let own = |at: &u32| (*at as usize) < changes.entries;
        changes.hidden.into_iter().filter(own).for_each(|at| inner.set(at, true));
        for word in &changes.words {
            if let Some(words) = inner.words.get_mut(&word.len()) {
                words.remove(word);
            }
        }
        inner.words.retain(|_, words| !words.is_empty());
        for symbol in &changes.numbered {
            inner.numbered.remove(symbol);
        }
        let taken = inner.entries.split_off(changes.entries);
        for entry in &taken {
            inner.symbols[entry.symbol.index()] = None;
        }
        taken
    }

    /// All that are found by name, in order of declaration.
    pub(super) fn all(&self) -> impl Iterator<Item = &Entry> {
        let found = self.0.entries.iter().enumerate().filter(|(at, _)| !self.0.hidden.contains(&(*at as u32)));
        found.map(|(_, e)| &**e)
    }

    /// Those whose names may be taken for this one, and which have just this subscript, in order of declaration.
    pub(super) fn like(&self, name: &str, sub: &[SubItem]) -> impl DoubleEndedIterator<Item = &Entry> + Clone {
        self.0.all_of(self.0.named.get(core(name)).map_or(&[], |like| like.of(sub)))
    }

    /// Those whose names may be taken for this one, and whose subscripts could be indices of its components.
    pub(super) fn components(&self, name: &str) -> impl Iterator<Item = &Entry> {
        self.0.all_of(self.0.named.get(core(name)).map_or(&[], |like| like.components.as_slice()))
    }

    /// Those whose names may be taken for this one, and with whose subscripts, labels or indices, this one begins; each with its place.
    pub(super) fn beginnings(&self, name: &str, sub: &[SubItem]) -> impl Iterator<Item = (u32, &Entry)> {
        let like = self.0.named.get(core(name));
        let longest = if like.is_some_and(|like| !like.labelled.is_empty()) { sub.len() } else { 0 };
        let labelled = like.into_iter().flat_map(move |like| (0..=longest).flat_map(|n| like.of(&sub[..n])));
        let indexed = like.into_iter().flat_map(|like| &like.indexed);
        labelled.chain(indexed).filter_map(|at| Some((*at, self.0.at(*at)?)))
    }

    /// Whether one has this name, whatever its subscript.
    pub(super) fn has(&self, is_it: impl Fn(&Entry) -> bool, name: &str) -> bool {
        let Some(like) = self.0.named.get(core(name)) else { return false };
        let places = like.plain.iter().chain(&like.indexed).chain(like.labelled.values().flatten());
        places.filter_map(|at| self.0.at(*at)).any(is_it)
    }

    /// Those that are declared under this key, as it is spelled, in order of declaration.
    pub(super) fn under(&self, key: &str) -> impl DoubleEndedIterator<Item = &Entry> + Clone {
        self.0.all_of(self.0.keyed.get(key).map_or(&[], Vec::as_slice))
    }

    /// What declares a symbol, even if it is hidden.
    pub(super) fn of(&self, symbol: Symbol) -> Option<&Entry> {
        self.0.at((*self.0.symbols.get(symbol.index())?)?)
    }

    /// Whether a symbol is found by its name.
    pub(super) fn is_found(&self, symbol: Symbol) -> bool {
        self.0.symbols.get(symbol.index()).copied().flatten().is_some_and(|at| !self.0.hidden.contains(&at))
    }

    pub(super) fn coordinates(&self) -> impl DoubleEndedIterator<Item = &Entry> + Clone {
        self.0.all_of(&self.0.coordinates)
    }

    pub(super) fn time(&self) -> Option<&Entry> {
        self.0.at(self.0.time?)
    }

    /// Whether one is so.
    pub(super) fn any(&self, what: Any) -> bool {
        self.0.counts[what as usize] > 0
    }

    /// Whether one of this name, in any style, is so.
    pub(super) fn is_any(&self, base: &str, what: Kind) -> bool {
        self.0.kinds.get(base).is_some_and(|counts| counts[what as usize] > 0)
    }

    pub(super) fn add_word(&mut self, word: &str) {
        let inner = Arc::make_mut(&mut self.0);
        if inner.words.entry(word.len()).or_default().insert(word.to_owned()) {
            inner.changes.iter_mut().for_each(|changes| changes.words.push(word.to_owned()));
        }
    }

    pub(super) fn has_words(&self) -> bool {
        !self.0.words.is_empty()
    }

    /// The longest name of several letters with which these letters begin.
    pub(super) fn word(&self, letters: &str) -> Option<&str> {
        self.0.words.iter().rev().find_map(|(length, words)| words.get(letters.get(..*length)?).map(String::as_str))
    }

    /// Notes that others have the names of components of a symbol.
    pub(super) fn number(&mut self, symbol: Symbol) {
        let inner = Arc::make_mut(&mut self.0);
        if inner.numbered.insert(symbol) {
            inner.changes.iter_mut().for_each(|changes| changes.numbered.push(symbol));
        }
    }

    pub(super) fn is_numbered(&self, symbol: Symbol) -> bool {
        self.0.numbered.contains(&symbol)
    }

    pub(super) fn refuse(&mut self, name: Name, sub: Vec<SubItem>) {
        Arc::make_mut(&mut self.0).refused.entry(name).or_default().push(sub);
    }

    /// Whether the declaration of a name was refused, with this subscript or the beginning of it.
    pub(super) fn is_refused(&self, name: &str, sub: &[SubItem]) -> bool {
        self.0.refused.get(name).is_some_and(|all| all.iter().any(|refused| sub.starts_with(refused)))
    }
}
