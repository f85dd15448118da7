//! `[[picture]]`: what a report draws of every motion.

use super::keys;
use super::load::Loader;
use super::model::{Picture, PictureKind};
use super::table::{Literal, Table, Value};
use latex::Role;

impl Loader<'_> {
    /// Reads every `[[picture]]`.
    pub fn pictures(&mut self, root: &Table<'_, '_>) {
        for value in root.array(&mut self.problems, "picture", "tables, [[picture]]") {
            if let Some(picture) = self.one_picture(value) {
                self.out.pictures.push(picture);
            }
        }
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
    fn scalars(&mut self, formulas: Vec<Literal<'_>>) -> Vec<super::formula::Written<expr::Expr>> {
        let scope = self.out.scope.clone();
        let mut out = Vec::new();
        for formula in formulas {
            let Some(read) = self.quantity(&formula, &scope) else { continue };
            match read.value.as_scalar() {
                Some(value) => out.push(super::formula::Written { text: read.text, span: read.span, value }),
                None => {
                    let message = format!("a picture shows numbers, this is a {}", read.value.shape);
                    self.problems.note("derivation::wrong-components", read.span, message);
                }
            }
        }
        out
    }
}
