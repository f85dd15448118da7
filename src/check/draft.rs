//! Trajectories of a file with other numbers in them.
//!
//! **In:** a derivation, and a seed. **Out:** a [`Draft`] of each trajectory, and others made from it; each as text of a derivation file.
//! **Guaranteed:** the seed and the number of a draft determine it: every one has its own draws.
//!
//! **How:** numbers are changed, formulas kept, so that what the formulas build in (a rotation matrix, a momentum along an axis, the
//! relation of a closed solution) stays true. Numbers of matrices are kept, since they are seldom free. Each draft changes some numbers of
//! one trajectory: to something else, to 0, to the opposite, to another number of the same symbol, or by little; so equations between them
//! are met by many and broken by many.

use crate::derivation::{Derivation, GivenValue, Motion, Trajectory};
use crate::latex::Role;
use crate::number::Draws;
use findings::search::ChangedNumber;

/// The longest stretch of time that is tried, unless a trajectory of the file is shorter.
const LONGEST: f64 = 40.0;

/// A value of a trajectory.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// As the file has it.
    Kept(String),
    /// One number.
    Number(f64),
    /// A row of numbers.
    Row(Vec<f64>),
}

impl Value {
    fn numbers(&self) -> &[f64] {
        match self {
            Value::Kept(_) => &[],
            Value::Number(x) => std::slice::from_ref(x),
            Value::Row(row) => row,
        }
    }

    fn numbers_mut(&mut self) -> &mut [f64] {
        match self {
            Value::Kept(_) => &mut [],
            Value::Number(x) => std::slice::from_mut(x),
            Value::Row(row) => row,
        }
    }

    fn text(&self) -> String {
        match self {
            Value::Kept(text) => text.clone(),
            Value::Number(x) => number(*x),
            Value::Row(row) => format!("[{}]", row.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ")),
        }
    }
}

/// A number as the loader reads it back, exactly.
fn number(x: f64) -> String {
    let x = if x == 0.0 { 0.0 } else { x };
    if x.abs() >= 1e-5 && x.abs() < 1e15 || x == 0.0 { format!("{x}") } else { format!("{x:e}") }
}

/// What has a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Slot {
    key: String,
    parameter: bool,
    positive: bool,
    /// A number without unit may be an angle: it is drawn from one turn.
    angle: bool,
    value: Value,
}

/// A trajectory that can be written down.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Draft {
    /// The trajectory that it was made from.
    pub from: String,
    /// The system that it is integrated from; formulas otherwise.
    pub system: Option<String>,
    pub slots: Vec<Slot>,
    pub span: (f64, f64),
    pub initial_time: f64,
}

/// A key of a table.
fn key(name: &str) -> String {
    if name.contains('\'') { format!("\"{name}\"") } else { format!("'{name}'") }
}

impl Draft {
    /// The family of a trajectory of the file; `None` for one that is derived from another.
    pub fn of(derivation: &Derivation, trajectory: &Trajectory) -> Option<Draft> {
        let system = match &trajectory.motion {
            // What is solved for has no number that could be changed.
            Motion::Integrated { .. } if trajectory.motion.start().is_some() => return None,
            Motion::Integrated { system, .. } => Some(derivation.systems.get(*system)?.id.clone()),
            Motion::Formula { .. } => None,
            Motion::Derived { .. } => return None,
        };
        let given = derivation.given.iter().filter(|g| g.trajectory == trajectory.id);
        let slots = given.map(|g| slot(derivation, g)).collect::<Option<Vec<Slot>>>()?;
        let (from, to) = trajectory.span;
        let start = trajectory.initial_time;
        let span = (from.max(start - LONGEST / 2.0), to.min(start + LONGEST));
        Some(Draft { from: trajectory.id.clone(), system, slots, span, initial_time: start })
    }

    /// The same on a stretch of time that ends so long after its start at the latest, and begins as long before it at the earliest.
    #[must_use]
    pub fn up_to(self, longest: f64) -> Draft {
        let (from, to) = self.span;
        let span = (from.max(self.initial_time - longest), to.min(self.initial_time + longest));
        Draft { span, ..self }
    }

    /// The table of the file.
    pub fn table(&self, id: &str) -> String {
        let part = |wanted: bool| -> String {
            let all = self.slots.iter().filter(|s| s.parameter == wanted);
            all.map(|s| format!("{} = {}", key(&s.key), s.value.text())).collect::<Vec<_>>().join(", ")
        };
        let mut out = format!("[[trajectory]]\nid = \"{id}\"\n");
        if let Some(system) = &self.system {
            out.push_str(&format!("system = \"{system}\"\n"));
        }
        let parameters = part(true);
        if !parameters.is_empty() {
            out.push_str(&format!("parameters = {{ {parameters} }}\n"));
        }
        let states = if self.system.is_some() { "initial" } else { "formula" };
        out.push_str(&format!("{states} = {{ {} }}\n", part(false)));
        out.push_str(&format!("span = [{}, {}]\n", number(self.span.0), number(self.span.1)));
        let usual = if self.span.0 <= 0.0 && self.span.1 >= 0.0 { 0.0 } else { self.span.0 };
        if self.initial_time != usual {
            out.push_str(&format!("initial-time = {}\n", number(self.initial_time)));
        }
        out
    }

    /// Whether there is a number that may be changed.
    pub fn is_free(&self) -> bool {
        !self.entries().is_empty()
    }

    /// Where numbers stand that may be changed: slot and position.
    pub fn entries(&self) -> Vec<(usize, usize)> {
        let each = |(s, slot): (usize, &Slot)| (0..slot.value.numbers().len()).map(move |i| (s, i)).collect::<Vec<_>>();
        self.slots.iter().enumerate().flat_map(each).collect()
    }

    pub fn get(&self, (slot, at): (usize, usize)) -> f64 {
        self.slots.get(slot).and_then(|s| s.value.numbers().get(at)).copied().unwrap_or(0.0)
    }

    /// The numbers that are other than in the draft that this one was made from.
    pub fn changed(&self, from: &Draft) -> Vec<ChangedNumber> {
        let one = |at: (usize, usize)| {
            let (now, then) = (self.get(at), from.get(at));
            (now != then).then(|| ChangedNumber { name: self.name(at), now, then })
        };
        self.entries().into_iter().filter_map(one).collect()
    }

    /// LaTeX of a number: a component of a row has its index.
    fn name(&self, (slot, at): (usize, usize)) -> String {
        let Some(slot) = self.slots.get(slot) else { return String::new() };
        match (&slot.value, slot.key.contains(['_', '^'])) {
            (Value::Row(_), false) => format!("{}_{}", slot.key, at + 1),
            (Value::Row(_), true) => format!("({})_{}", slot.key, at + 1),
            _ => slot.key.clone(),
        }
    }

    pub fn set(&mut self, (slot, at): (usize, usize), x: f64) {
        if let Some(place) = self.slots.get_mut(slot).and_then(|s| s.value.numbers_mut().get_mut(at)) {
            *place = x;
        }
    }
}

/// A value as the file gives it: numbers apart from everything else.
fn slot(derivation: &Derivation, given: &GivenValue) -> Option<Slot> {
    let (graph, source) = (&derivation.graph, &derivation.file.text);
    let entry = derivation.symbols.iter().find(|s| s.symbol == given.symbol)?;
    let quoted = given.value.span.start.checked_sub(1).and_then(|i| source.as_bytes().get(i)) == Some(&b'\'');
    let raw = given.value.text.as_str();
    let constants: Option<Vec<f64>> =
        given.value.value.iter().map(|e| graph.as_constant(*e).map(|r| r.to_f64().value())).collect();
    let rank = if graph.is_diagonal(given.symbol) { 1 } else { graph.shape(given.symbol).rank() };
    let value = match (quoted || raw.contains('\''), rank, constants) {
        (false, 0, Some(numbers)) => Value::Number(*numbers.first()?),
        (false, 1, Some(numbers)) => Value::Row(numbers),
        _ if quoted && raw.contains('\'') => Value::Kept(format!("'''{raw}'''")),
        _ if quoted => Value::Kept(format!("'{raw}'")),
        _ => Value::Kept(raw.to_owned()),
    };
    let dots = match given.rate {
        0 => "",
        1 => r"\dot ",
        _ => r"\ddot ",
    };
    Some(Slot {
        key: format!("{dots}{}", entry.name),
        parameter: entry.role == Role::Parameter,
        positive: entry.positive,
        angle: entry.angle || entry.measured_in.as_ref().is_some_and(|u| u.is_number()),
        value,
    })
}

/// A number in [0, 1).
fn uniform(draws: &mut Draws) -> f64 {
    draws.below(1 << 30) as f64 / (1_u64 << 30) as f64
}

/// A number with this many digits.
pub(super) fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x)
}

/// Another motion of the family.
pub(super) fn draw(families: &[Draft], seed: u64, number: usize) -> Option<Draft> {
    let mut draws = Draws::new(seed ^ (number as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15));
    draws.bits();
    let mut draft = families.get(draws.below(families.len() as u64) as usize)?.clone();
    let entries = draft.entries();
    if entries.is_empty() {
        return None;
    }
    // Few changes keep what equations ask for; many leave the neighbourhood of what the file has.
    let few = draws.below(3) > 0;
    let count = if few { 1 + draws.below(2) as usize } else { 1 + draws.below(entries.len() as u64) as usize };
    for _ in 0..count {
        let at = entries[draws.below(entries.len() as u64) as usize];
        let old = draft.get(at);
        let slot = draft.slots.get(at.0)?.clone();
        let u = uniform(&mut draws);
        let factor = if draws.below(2) == 0 { 1.0 + 3.0 * u } else { 1.0 / (1.0 + 3.0 * u) };
        let new = match draws.below(8) {
            0 if !slot.positive => 0.0,
            1 if !slot.positive => -old,
            2 | 3 if slot.value.numbers().len() > 1 => {
                draft.get((at.0, draws.below(slot.value.numbers().len() as u64) as usize))
            }
            4 => old * (1.0 + 0.02 * (u - 0.5)),
            5 | 6 if slot.angle && !slot.positive => 6.2 * u - 3.1,
            _ if old == 0.0 => 4.0 * u - 2.0,
            _ => old * factor,
        };
        let new = if slot.positive && new <= 0.0 { 1.0 + u } else { new };
        draft.set(at, rounded(new, 4));
    }
    Some(draft)
}
