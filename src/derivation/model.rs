//! What a derivation file says, read and understood.

use std::ops::Range;
use std::sync::Arc;

use diag::Source;
use expr::{Expr, Graph, Leaf, Symbol, Tensor};
use latex::{Relation, Role, Scope, Statement};

use super::event::{Event, Since};
use super::family::Family;
use super::form::{Form, FormKind};
use super::formula::{Ranged, Written};
use super::list::Shared;
use super::premise::Index;
use super::role::ClaimRole;
use super::unit::Unit;

/// A derivation file.
#[derive(Clone, Debug)]
pub struct Derivation {
    /// Short name: the stem of the file's name, unless the file gives another.
    pub id: String,
    /// Title of the paper or of the derivation.
    pub title: String,
    /// The citation of what is checked.
    pub concerns: String,
    /// Where to find it.
    pub source: Option<String>,
    /// What a reader should know about the file as a whole.
    pub remark: Option<String>,
    /// Who wrote the file: the texts that are not the paper's are theirs.
    pub encoded_by: Option<String>,
    /// The file.
    pub file: Arc<Source>,
    /// SHA-256 of the file's bytes, in lower-case hexadecimal.
    pub sha256: String,
    /// The counted work of reading it, which counts for the total of the file: see [`meter`].
    pub work: u64,
    /// Conventions: name and text, in the order of the file.
    pub conventions: Vec<(String, String)>,
    /// The symbols of the whole file, in its order.
    pub symbols: Vec<SymbolEntry>,
    /// The expressions of every formula of the file.
    pub graph: Graph,
    /// What the symbols of the whole file mean in a formula.
    pub scope: Scope,
    /// Systems of differential equations.
    pub systems: Vec<System>,
    /// Motions, in the order of the file, as the claims.
    pub trajectories: Shared<Trajectory>,
    /// Families of motions, in the order of the file; copies have them in common.
    pub families: Arc<Vec<Family>>,
    /// Boxes of values that claims share, in the order of the file.
    pub domains: Vec<Domain>,
    /// Claims, in the order of the file; one entry for each reading. Copies have them in common until one is changed.
    pub claims: Shared<Claim>,
    /// Quantities to be measured.
    pub measures: Vec<Measure>,
    /// Conditions that may tell where a claim holds and where it fails.
    pub conditions: Vec<Condition>,
    /// The values that trajectories give to symbols, as they are written.
    pub given: Vec<GivenValue>,
    /// Pictures of the motions.
    pub pictures: Vec<Picture>,
    /// What is asked of the whole file again and again, found once.
    pub(super) index: Index,
}

/// A declared symbol.
#[derive(Clone, Debug)]
pub struct SymbolEntry {
    /// Its LaTeX name, as declared.
    pub name: String,
    /// The symbol of the graph.
    pub symbol: Symbol,
    /// What it is.
    pub role: Role,
    /// Its unit as written.
    pub unit: Option<String>,
    /// Its unit as understood.
    pub measured_in: Option<Unit>,
    /// Declared positive (in every component): a trajectory that gives it another value is refused.
    pub positive: bool,
    /// An angle: its values along a motion are continued without jumps of 2π.
    pub angle: bool,
    /// Its values are complex numbers: the symbol has a real and an imaginary part for each component.
    pub complex: bool,
    /// Its definition as written.
    pub formula: Option<String>,
    /// The scale factor of a coordinate that is not Cartesian, as written.
    pub scale: Option<String>,
    /// Names of the arguments of a function.
    pub arguments: Vec<String>,
    /// What it stands for, in the file's words.
    pub says: Option<String>,
    /// Place of its name in the file.
    pub span: Range<usize>,
}

impl SymbolEntry {
    /// Its role, as the file writes it.
    pub fn role_word(&self) -> &'static str {
        match self.role {
            Role::Time => "time",
            Role::State => "state",
            Role::Parameter if self.formula.is_some() => "constant",
            Role::Parameter => "parameter",
            Role::Observable => "observable",
            Role::Abbreviation => "abbreviation",
            Role::Argument => "argument",
            Role::Coordinate => "coordinate",
            Role::Field => "field",
        }
    }
}

/// A system of differential equations, as its equations are written.
#[derive(Clone, Debug)]
pub struct System {
    /// Its id.
    pub id: String,
    /// What it is, in the file's words.
    pub says: Option<String>,
    /// The label of its equations in the paper's source.
    pub label: Option<String>,
    /// The unknowns, in the order of the file; all have the role [`Role::State`]. None where the equations are those of
    /// fields: then there are no motions.
    pub states: Vec<Symbol>,
    /// Its equations; every relation is a plain `=`.
    pub equations: Vec<Written<Statement>>,
    /// Place of its id in the file.
    pub span: Range<usize>,
}

/// An initial value that equations determine.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// What the other formulas call it: a symbol of its own.
    pub leaf: Leaf,
    /// How a formula writes the quantity whose initial value it is.
    pub name: String,
    /// The guess, over parameters.
    pub near: Expr,
    /// How far the value may be from the guess, over parameters; half of the guess unless it is given.
    pub within: Option<Expr>,
    /// Place of the guess in the file.
    pub span: Range<usize>,
}

/// Initial values that equations determine. The equations have one solution in which every unknown lies as near to its guess as
/// it says: this is for those to show who compute.
#[derive(Clone, Debug)]
pub struct Start {
    /// The unknowns.
    pub unknowns: Vec<Unknown>,
    /// The equations as they are written, between states and their rates.
    pub equations: Vec<Written<Statement>>,
    /// Left − right of each component, over parameters, unknowns and rates that the system gives; as many as unknowns.
    pub differences: Vec<Expr>,
    /// Place of the equations in the file.
    pub span: Range<usize>,
}

impl Start {
    /// The same with something else put in for leaves.
    pub fn with(&self, mut put: impl FnMut(Expr) -> Expr) -> Start {
        let unknown = |u: &Unknown, put: &mut dyn FnMut(Expr) -> Expr| Unknown {
            near: put(u.near),
            within: u.within.map(&mut *put),
            ..u.clone()
        };
        Start {
            unknowns: self.unknowns.iter().map(|u| unknown(u, &mut put)).collect(),
            differences: self.differences.iter().map(|&e| put(e)).collect(),
            ..self.clone()
        }
    }
}

/// Where a motion comes from.
#[derive(Clone, Debug)]
pub enum Motion {
    /// Integrated from initial values.
    Integrated {
        /// Position in [`Derivation::systems`].
        system: usize,
        /// State, order of its rate (0 for the state itself), and one expression for each stored component, over
        /// parameters, the unknowns of `start`, and rates that the system gives; in the order of the system's states.
        initial: Vec<(Symbol, u8, Written<Vec<Expr>>)>,
        /// The values among them that equations determine.
        start: Option<Start>,
    },
    /// Given by formulas in time and parameters: one expression for each stored component.
    Formula {
        /// State and its formula.
        states: Vec<(Symbol, Written<Vec<Expr>>)>,
    },
    /// Computed from another motion.
    Derived {
        /// Position in [`Derivation::trajectories`]; it comes from no motion that comes from this one.
        from: usize,
        /// State and its formula in the states and time of the other motion, values of parameters put in; a state that is not listed is
        /// that of the other motion. A state that the other motion does not have may be added.
        map: Vec<(Symbol, Written<Vec<Expr>>)>,
    },
}

impl Motion {
    /// The formulas of states, or their initial values.
    pub fn formulas(&self) -> Vec<Expr> {
        let each: Vec<&Written<Vec<Expr>>> = match self {
            Motion::Integrated { initial, .. } => initial.iter().map(|(.., w)| w).collect(),
            Motion::Formula { states } => states.iter().map(|(_, w)| w).collect(),
            Motion::Derived { map, .. } => map.iter().map(|(_, w)| w).collect(),
        };
        each.into_iter().flat_map(|w| w.value.iter().copied()).collect()
    }

    /// The initial values that equations determine.
    pub fn start(&self) -> Option<&Start> {
        match self {
            Motion::Integrated { start, .. } => start.as_ref(),
            Motion::Formula { .. } | Motion::Derived { .. } => None,
        }
    }
}

/// A motion on which claims are tried.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// Its id.
    pub id: String,
    /// Its title; the id where none is given.
    pub title: String,
    /// What a reader should know.
    pub says: Option<String>,
    /// Where it comes from.
    pub motion: Motion,
    /// The states that have values along it.
    pub states: Vec<Symbol>,
    /// Values of parameters: one closed expression (without leaves) for each stored component. A derived motion has those
    /// of the motion that it comes from, then its own.
    pub parameters: Vec<(Symbol, Written<Vec<Expr>>)>,
    /// First and last time; finite, the first before the last.
    pub span: (f64, f64),
    /// The time at which initial values are given; inside the span.
    pub initial_time: f64,
    /// Place of its id in the file.
    pub place: Range<usize>,
}

impl Trajectory {
    /// The value of a parameter, if the trajectory gives one.
    pub fn parameter(&self, symbol: Symbol) -> Option<&[Expr]> {
        self.parameters.iter().rev().find(|(s, _)| *s == symbol).map(|(_, w)| w.value.as_slice())
    }

    /// `integrated`, `formula` or `derived`.
    pub fn source(&self) -> &'static str {
        match self.motion {
            Motion::Integrated { .. } => "integrated",
            Motion::Formula { .. } => "formula",
            Motion::Derived { .. } => "derived",
        }
    }
}

/// A formula of a claim as the file has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// As written; for `solves` and `same-motion`, which are not formulas, the id that they name.
    pub text: String,
    /// What it is there for.
    pub kind: FormKind,
}

/// A box of values, with formulas for fields, that claims share.
#[derive(Clone, Debug)]
pub struct Domain {
    /// Its id.
    pub id: String,
    /// What it is, in the file's words.
    pub says: Option<String>,
    /// The symbols that have values.
    pub ranges: Vec<Ranged>,
}

/// What a claim over ranges of values is about: no motion. Without ranges it is about fields, whatever they are.
#[derive(Clone, Debug, Default)]
pub struct Region {
    /// The symbols that have values, in the order of the file; nothing else occurs in the claim but what is defined by them.
    pub ranges: Vec<Ranged>,
    /// The expected verdict, as a word of the report.
    pub expect: Option<&'static str>,
}

/// A claim, or one reading of it.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Its id; the readings of a claim share it.
    pub id: String,
    /// The id of the reading.
    pub reading: Option<String>,
    /// What it says, in the file's words.
    pub says: String,
    /// For a reading, what the claim itself says.
    pub parent_says: Option<String>,
    /// Where it stands in the paper.
    pub place: Option<String>,
    /// The label of its equation in the paper's source.
    pub label: Option<String>,
    /// Whether its formulas are those that the paper prints under the label.
    pub printed: bool,
    /// What it is to the paper: what the paper says, what it needs, what was added …
    pub role: ClaimRole,
    /// Whether it is something that the paper concludes: what its other claims are for.
    pub conclusion: bool,
    /// Whether it says that it is a postulate: its step is not asked to be proved.
    pub postulate: bool,
    /// Claims on which the paper's argument for it rests, in words: nothing is proved from them.
    pub rests_on: Vec<String>,
    /// What a reader should know.
    pub remark: Option<String>,
    /// Symbols that are declared for this claim only.
    pub symbols: Vec<SymbolEntry>,
    /// Its formulas as written, one entry for each string of the file.
    pub formulas: Vec<Formula>,
    /// What it presupposes: all must hold for the claim to apply.
    pub assuming: Vec<Written<Statement>>,
    /// What it says; never empty. It holds if all of them hold.
    pub forms: Vec<Form>,
    /// The claim is tried only at these times.
    pub at: Option<Event>,
    /// Claims, systems and symbols that it follows from.
    pub follows_from: Vec<String>,
    /// The precision that is asked for, relative.
    pub precision: f64,
    /// Whether one sign of ± must serve the whole motion; otherwise some sign at each time.
    pub branches_throughout: bool,
    /// The motions on which it is tried: positions in [`Derivation::trajectories`], increasing.
    pub trajectories: Vec<usize>,
    /// Whether the file names them: a motion that is added is then not among them by itself.
    pub names_trajectories: bool,
    /// The expected verdict on each of `trajectories`, as a word of the report.
    pub expect: Vec<Option<&'static str>>,
    /// The families on which it is tried: positions in [`Derivation::families`], increasing.
    pub families: Vec<usize>,
    /// The expected verdict on each of `families`, as a word of the report.
    pub expect_of_families: Vec<Option<&'static str>>,
    /// The expected verdict where it is tried on nothing.
    pub expect_alone: Option<&'static str>,
    /// Whether the file expects that a formula of it is not consistent in its units.
    pub expect_inconsistent_units: bool,
    /// For a claim over ranges of values, which is tried on no motion: the ranges.
    pub region: Option<Region>,
    /// What symbols mean in its formulas.
    pub scope: Scope,
    /// Place of its id in the file.
    pub span: Range<usize>,
}

impl Claim {
    /// `id`, or `id/reading`.
    pub fn name(&self) -> String {
        match &self.reading {
            Some(reading) => format!("{}/{reading}", self.id),
            None => self.id.clone(),
        }
    }

    /// The relations that it states of every time.
    pub fn stated(&self) -> impl Iterator<Item = &Relation> {
        self.forms.iter().flat_map(|form| {
            let Form::Always(w) = form else { return &[][..] };
            &w.value.relations
        })
    }

    /// Whether it says that something is constant along each motion.
    pub fn states_integral(&self) -> bool {
        self.forms.iter().any(|form| form.kind() == FormKind::FirstIntegral)
    }

    /// Whether it is tried on motions or families, or has a verdict over ranges or for all fields.
    pub fn is_tried(&self) -> bool {
        !self.trajectories.is_empty() || !self.families.is_empty() || self.region.is_some()
    }

    /// Why its formulas were not read, if they took too much work: nothing is known of it then.
    pub fn unread(&self) -> Option<&str> {
        self.forms.iter().find_map(|form| match form {
            Form::Unread { why, .. } => Some(why.as_str()),
            _ => None,
        })
    }

    /// Whether it is decided at all points of a box.
    pub fn is_over_ranges(&self) -> bool {
        self.region.is_some() && !self.is_of_fields()
    }

    /// Whether it is about fields that have no formulas: it follows from something, or not.
    pub fn is_of_fields(&self) -> bool {
        let exists = || self.forms.iter().any(|form| form.kind() == FormKind::Exists);
        self.region.as_ref().is_some_and(|r| r.ranges.is_empty()) && !exists()
    }
}

/// A quantity to be measured at the events of a motion.
#[derive(Clone, Debug)]
pub struct Measure {
    /// Its id.
    pub id: String,
    /// What it is, in the file's words.
    pub says: String,
    /// A scalar.
    pub formula: Written<Tensor>,
    /// The quantity is taken at these times. Without it, at the initial time.
    pub at: Option<Event>,
    /// What is taken of it since another event, the last before each of these times, and not at the times alone.
    pub since: Option<(Event, Since)>,
    /// The motions on which it is measured: positions in [`Derivation::trajectories`], increasing.
    pub trajectories: Vec<usize>,
    /// The families on whose members it is measured: positions in [`Derivation::families`], increasing.
    pub families: Vec<usize>,
    /// Its unit as written.
    pub unit: Option<String>,
    /// Its unit as understood.
    pub measured_in: Option<Unit>,
    /// Place of its id in the file.
    pub span: Range<usize>,
}

/// A condition that the file offers as the reason for which a claim holds on some trajectories and fails on others.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Its id.
    pub id: String,
    /// What it is, in the file's words.
    pub says: String,
    /// It is met where all of these hold at every time.
    pub holds: Vec<Written<Statement>>,
    /// Place of its id in the file.
    pub span: Range<usize>,
}

/// A value that a trajectory gives to a symbol, before the values of other symbols are put in.
#[derive(Clone, Debug)]
pub struct GivenValue {
    /// Id of the trajectory.
    pub trajectory: String,
    /// What gets the value.
    pub symbol: Symbol,
    /// Order of its rate; 0 for the symbol itself.
    pub rate: u8,
    /// One expression for each stored component.
    pub value: Written<Vec<Expr>>,
}
/// How a picture shows a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureKind {
    /// Quantities against time.
    Time,
    /// One quantity against another.
    Curve,
    /// Three quantities of constant length, on the sphere.
    Sphere,
}

impl PictureKind {
    /// Every kind.
    pub const ALL: [PictureKind; 3] = [PictureKind::Time, PictureKind::Curve, PictureKind::Sphere];

    /// The word of the derivation file.
    pub fn key(self) -> &'static str {
        match self {
            PictureKind::Time => "time",
            PictureKind::Curve => "curve",
            PictureKind::Sphere => "sphere",
        }
    }
}

/// A picture that a report draws of motions.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Its id.
    pub id: String,
    /// What it shows, in the file's words.
    pub says: String,
    /// How.
    pub kind: PictureKind,
    /// The quantities: any number against time, two for a curve, three for a sphere.
    pub show: Vec<Written<Expr>>,
    /// For a curve: slopes that are claimed of it, drawn as short lines along it.
    pub slopes: Vec<Written<Expr>>,
    /// For a sphere: a function of the three quantities and of parameters, whose level sets are drawn.
    pub levels: Option<Written<Expr>>,
    /// The motions of which it is drawn: positions in [`Derivation::trajectories`], increasing.
    pub trajectories: Vec<usize>,
    /// Place of its id in the file.
    pub span: Range<usize>,
}
