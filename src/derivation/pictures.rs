//! `[[picture]]`: what a report draws of every motion.

use super::formula::Written;
use super::keys;
use super::load::Loader;
use super::model::{Motion, Picture, PictureKind};
use super::table::{Literal, Table, Value};
use expr::{Expr, Leaf, Partials, Symbol};
use latex::Role;

/// Most kinds of motions that are drawn without being asked for, and most motions of each.
const KINDS: (usize, usize) = (3, 2);
/// Most states that are drawn against time without being asked for.
const STATES: usize = 4;

impl Loader<'_> {
    /// Reads every `[[picture]]`.
    pub fn pictures(&mut self, root: &Table<'_, '_>) {
        for value in root.array(&mut self.problems, "picture", "tables, [[picture]]") {
            if let Some(picture) = self.one_picture(value) {
                self.out.pictures.push(picture);
            }
        }
    }

    /// What is drawn of the kinds of motions of which the file draws nothing: their states against time, and the first in the plane of its
    /// rate, or of the second.
    pub fn default_pictures(&mut self) {
        let drawn = |at: usize| self.out.pictures.iter().any(|p| p.trajectories.contains(&at));
        let mut kinds: Vec<(Option<usize>, Vec<usize>)> = Vec::new();
        for (at, trajectory) in self.out.trajectories.iter().enumerate() {
            let kind = match &trajectory.motion {
                Motion::Integrated { system, .. } => Some(*system),
                Motion::Formula { .. } => None,
                // It is seen in what it comes from.
                Motion::Derived { .. } => continue,
            };
            match kinds.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, all)) => all.push(at),
                None => kinds.push((kind, vec![at])),
            }
        }
        kinds.retain(|(_, all)| !all.iter().any(|at| drawn(*at)));
        for (kind, mut all) in kinds.into_iter().take(KINDS.0) {
            all.truncate(KINDS.1);
            let Some(first) = all.first().and_then(|at| self.out.trajectories.get(*at)) else { continue };
            let states = states(&first.motion);
            let of =
                kind.and_then(|system| self.out.systems.get(system)).map_or("formulas", |s| s.id.as_str()).to_owned();
            let span = first.place.clone();
            self.default_pair(&of, states, all, span);
        }
    }

    /// The two pictures of one kind of motions, as far as it has states for them.
    fn default_pair(&mut self, of: &str, states: Vec<Leaf>, trajectories: Vec<usize>, span: std::ops::Range<usize>) {
        let mut written = |leaf: Leaf| {
            let value = self.out.graph.leaf(leaf);
            Written { text: self.out.graph.leaf_latex(leaf), span: span.clone(), value }
        };
        let now: Vec<Leaf> = states.iter().copied().filter(|l| l.rate == 0).take(STATES).collect();
        let rate = now.first().and_then(|first| {
            states.iter().copied().find(|l| l.rate == 1 && (l.symbol, l.component) == (first.symbol, first.component))
        });
        let plane: Vec<Leaf> = now.first().copied().into_iter().chain(rate.or_else(|| now.get(1).copied())).collect();
        let kinds =
            [(PictureKind::Time, "states", "The states", now), (PictureKind::Curve, "plane", "The phase plane", plane)];
        let mut pictures = Vec::new();
        for (kind, key, says, show) in kinds {
            if show.len() < if kind == PictureKind::Curve { 2 } else { 1 } {
                continue;
            }
            let show = show.into_iter().map(&mut written).collect();
            pictures.push(Picture {
                // No id of a file has a stroke in it.
                id: format!("{key}/{of}"),
                says: says.to_owned(),
                kind,
                show,
                slopes: Vec::new(),
                levels: None,
                trajectories: trajectories.clone(),
                span: span.clone(),
            });
        }
        self.out.pictures.extend(pictures);
    }

    fn one_picture(&mut self, value: &Value<'_>) -> Option<Picture> {
        let table = Table::open(&mut self.problems, value, "[[picture]]", keys::PICTURE)?;
        let id = table.id(&mut self.problems, "id");
        let says = table.needed_text(&mut self.problems, "says");
        let kind = self.picture_kind(&table);
        if table.get("show").is_none() {
            table.missing(&mut self.problems, "show");
        }
        let before = self.problems.found.len();
        let (shown, sloped) =
            (table.formulas(&mut self.problems, "show"), table.formulas(&mut self.problems, "slopes"));
        let (show, slopes) = (self.scalars(shown), self.scalars(sloped));
        let levels = table.formula(&mut self.problems, "levels");
        let levels = levels.and_then(|f| self.scalars(vec![f]).pop());
        let trajectories = match table.get("trajectories") {
            Some(_) => self.some_trajectories(&table),
            None => (0..self.out.trajectories.len()).collect(),
        };
        let (id, span) = id?;
        let new = self.take("picture", &id, span.clone());
        let (says, kind) = (says?, kind?);
        if self.problems.found.len() > before {
            return None;
        }
        let wrong = match (kind, show.len()) {
            (PictureKind::Time, 0) => "a picture against time shows at least one quantity",
            (PictureKind::Curve, n) if n != 2 => "a curve shows two quantities: across, and up",
            (PictureKind::Sphere, n) if n != 3 => "a sphere shows three quantities",
            (PictureKind::Time | PictureKind::Sphere, _) if !slopes.is_empty() => "only a curve has `slopes`",
            (PictureKind::Time | PictureKind::Curve, _) if levels.is_some() => "only a sphere has `levels`",
            _ => "",
        };
        if !wrong.is_empty() {
            self.problems.note("derivation::picture", span, wrong);
            return None;
        }
        let picture = Picture { id, says, kind, show, slopes, levels, trajectories, span };
        if let Some(levels) = &picture.levels {
            let graph = &self.out.graph;
            let shown = graph.leaves_within(picture.show.iter().map(|w| w.value));
            let fixed = |leaf: &expr::Leaf| self.out.scope.role(leaf.symbol) == Some(Role::Parameter);
            let other = graph.leaves_within([levels.value]).into_iter().find(|l| !shown.contains(l) && !fixed(l));
            if shown.len() != 3 || other.is_some() {
                let message = "`levels` is a formula in the three symbols that are shown, and in parameters";
                self.problems.note("derivation::picture", levels.span.clone(), message);
                return None;
            }
        }
        new.then_some(picture)
    }

    fn picture_kind(&mut self, table: &Table<'_, '_>) -> Option<PictureKind> {
        let word = table.needed_text(&mut self.problems, "kind")?;
        let kind = PictureKind::ALL.iter().copied().find(|k| k.key() == word);
        if let (None, Some(value)) = (kind, table.get("kind")) {
            let known = PictureKind::ALL.iter().map(|k| k.key());
            self.problems.unknown("derivation::unknown-key", value.span(), "kind of picture", &word, known);
        }
        kind
    }

    /// Formulas for one number each.
    fn scalars(&mut self, formulas: Vec<Literal<'_>>) -> Vec<Written<Expr>> {
        let scope = self.out.scope.clone();
        let mut out = Vec::new();
        for formula in formulas {
            let Some(read) = self.quantity(&formula, &scope) else { continue };
            match read.value.as_scalar() {
                Some(value) => out.push(Written { text: read.text, span: read.span, value }),
                None => {
                    let message = format!("a picture shows numbers, this is a {}", read.value.shape);
                    self.problems.note("derivation::wrong-components", read.span, message);
                }
            }
        }
        out
    }
}

/// The components of the states of a motion, in the order of the file.
fn states(motion: &Motion) -> Vec<Leaf> {
    let leaves = |symbol: Symbol, rate: u8, n: usize| {
        let components = (0..n).filter_map(|at| u16::try_from(at).ok());
        components.map(move |component| Leaf { symbol, component, rate, partials: Partials::default(), instant: None })
    };
    match motion {
        Motion::Integrated { initial, .. } => {
            initial.iter().flat_map(|(symbol, rate, w)| leaves(*symbol, *rate, w.value.len())).collect()
        }
        Motion::Formula { states } | Motion::Derived { map: states, .. } => {
            states.iter().flat_map(|(symbol, w)| leaves(*symbol, 0, w.value.len())).collect()
        }
    }
}
