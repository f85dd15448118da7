//! A family: many motions from one, by values that vary.
//!
//! **In:** what varies and how, what a member must satisfy, and the trajectory with the varied symbols left open, as `families`
//! reads them. **Out:** [`Family::member`], a trajectory with numbers put in, and [`Family::toml`], the same as a `[[trajectory]]`.
//!
//! **Guaranteed:** a member is what the loader makes of its text: the base trajectory with some values replaced, and what is given
//! by formulas of them follows. No member is made here, however many there are.

use std::ops::Range;

use super::formula::Written;
use super::model::{Motion, Trajectory};
use super::number::exact;
use expr::{Expr, Graph, Leaf, Symbol};
use latex::{RelationKind, Statement};

/// The most members that a family may have.
pub const LARGEST_FAMILY: u64 = 1_000_000_000;

/// The most values of a row or list that a map shows each by itself.
pub const WIDEST_ROW: u64 = 64;

/// How the values of a symbol are spread. Ends and parameters are expressions without leaves.
#[derive(Clone, Debug)]
pub enum Spread {
    /// These values.
    Values(Vec<Expr>),
    /// So many values from the first to the last, evenly spaced, or with even ratios.
    Grid {
        /// The first value.
        from: Expr,
        /// The last value.
        to: Expr,
        /// How many there are, at least 2.
        count: u64,
        /// Whether the ratio of neighbours is the same, and not their difference.
        logarithmic: bool,
    },
    /// Drawn, all values between the two equally likely.
    Uniform(Expr, Expr),
    /// Drawn, with a logarithm that is uniform.
    LogUniform(Expr, Expr),
    /// Drawn, an angle whose cosine is uniform: the latitude of a point of a sphere, from a pole.
    Polar(Expr, Expr),
    /// Drawn from a normal distribution: mean and standard deviation.
    Normal(Expr, Expr),
}

/// What is wrong with a spread: a code, what it is, and what to do.
type SpreadFault = (&'static str, String, &'static str);

impl Spread {
    /// Whether its values are drawn.
    pub fn is_drawn(&self) -> bool {
        match self {
            Spread::Values(_) | Spread::Grid { .. } => false,
            Spread::Uniform(..) | Spread::LogUniform(..) | Spread::Polar(..) | Spread::Normal(..) => true,
        }
    }

    /// How many values it lists; 1 for what is drawn.
    pub fn points(&self) -> u64 {
        match self {
            Spread::Values(values) => values.len() as u64,
            Spread::Grid { count, .. } => *count,
            Spread::Uniform(..) | Spread::LogUniform(..) | Spread::Polar(..) | Spread::Normal(..) => 1,
        }
    }

    /// The numbers that it is given by.
    pub fn numbers(&self) -> Vec<Expr> {
        match self {
            Spread::Values(values) => values.clone(),
            Spread::Grid { from, to, .. } => vec![*from, *to],
            Spread::Uniform(a, b) | Spread::LogUniform(a, b) | Spread::Polar(a, b) | Spread::Normal(a, b) => {
                vec![*a, *b]
            }
        }
    }

    /// What is wrong with it, as far as its numbers are known; `positive` is what the symbol is declared as.
    pub fn fault(&self, name: &str, positive: bool, number: &dyn Fn(Expr) -> Option<f64>) -> Option<SpreadFault> {
        let not_positive = || {
            let message = format!("`{name}` is declared positive");
            Some(("derivation::not-positive", message, "every value that it is given lies above 0"))
        };
        let ordered = |from: Expr, to: Expr| match (number(from), number(to)) {
            (Some(a), Some(b)) if a > b => {
                let message = "the ends of this range are in the wrong order".to_owned();
                Some(("derivation::bad-range", message, "the smaller one comes first"))
            }
            (Some(a), Some(b)) if a == b => {
                let message = "both ends of this range are the same number".to_owned();
                Some(("derivation::bad-range", message, "write { values = [a] } for a single value"))
            }
            _ => None,
        };
        let below = |e: Expr| number(e).is_some_and(|x| x <= 0.0);
        let logarithmic = |from: Expr| {
            let message = "a logarithmic range lies above 0".to_owned();
            below(from).then_some(("derivation::bad-range", message, "begin it above 0, or space it linearly"))
        };
        match self {
            Spread::Values(values) if positive && values.iter().any(|e| below(*e)) => not_positive(),
            Spread::Values(_) => None,
            Spread::Grid { from, to, logarithmic: log, .. } => ordered(*from, *to)
                .or_else(|| if positive && below(*from) { not_positive() } else { None })
                .or_else(|| if *log { logarithmic(*from) } else { None }),
            Spread::Uniform(from, to) => {
                ordered(*from, *to).or_else(|| if positive && below(*from) { not_positive() } else { None })
            }
            Spread::Polar(from, to) => {
                let outside = |e: &Expr| number(*e).is_some_and(|x| !(0.0..=std::f64::consts::PI).contains(&x));
                let message = "a polar angle lies between 0 and π".to_owned();
                let hint = "it is the angle from a pole of a sphere; an azimuth is uniform";
                ordered(*from, *to)
                    .or_else(|| if positive && below(*from) { not_positive() } else { None })
                    .or_else(|| [from, to].into_iter().any(outside).then_some(("derivation::bad-range", message, hint)))
            }
            Spread::LogUniform(from, to) => ordered(*from, *to).or_else(|| logarithmic(*from)),
            Spread::Normal(mean, _) if positive && below(*mean) => not_positive(),
            Spread::Normal(_, deviation) => {
                let message = "a standard deviation lies above 0".to_owned();
                below(*deviation).then_some(("derivation::bad-range", message, "write normal = [mean, deviation]"))
            }
        }
    }
}

/// How values are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drawing {
    /// At random, each by itself.
    #[default]
    Random,
    /// The points of a sequence that fills its space evenly.
    LowDiscrepancy,
}

/// A symbol that varies.
#[derive(Clone, Debug)]
pub struct Varied {
    /// The parameter, the initial value of a state, or that of its rate.
    pub leaf: Leaf,
    /// Its name, as the table has it.
    pub name: String,
    /// Its values.
    pub spread: Spread,
    /// Whether it is declared positive.
    pub positive: bool,
    /// Where its values stand in the file.
    pub span: Range<usize>,
}

/// What a member must satisfy.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// As written.
    pub written: Written<Statement>,
    /// Each link of it, in what varies alone.
    pub links: Vec<(RelationKind, Expr, Expr)>,
}

/// A part of the text of a member.
#[derive(Clone, Debug)]
pub(super) enum Piece {
    /// The same for all.
    Text(String),
    /// The value of what varies, by its position.
    Value(usize),
}

/// Many motions, made from one.
#[derive(Clone, Debug)]
pub struct Family {
    /// Its id.
    pub id: String,
    /// Its title; the id where none is given.
    pub title: String,
    /// What a reader should know.
    pub says: Option<String>,
    /// The trajectory whose values are varied: its position in `Derivation::trajectories`.
    pub of: usize,
    /// What varies; never empty.
    pub vary: Vec<Varied>,
    /// How many members are drawn for each point of the grid; 1 where nothing is drawn.
    pub draws: u64,
    /// Where the draws begin.
    pub seed: u64,
    /// How they are drawn.
    pub sequence: Drawing,
    /// What members must satisfy.
    pub constraints: Vec<Constraint>,
    /// The two of those that vary over which the report has a map: to the right, and upwards.
    pub map: Option<[usize; 2]>,
    /// To which width the edge of where a claim holds is found on the map, along which of its symbols.
    pub boundary: Vec<(usize, f64)>,
    /// Where the constraints stand in the file.
    pub where_span: Option<Range<usize>>,
    /// The parameters of the trajectory, in what varies.
    pub(super) parameters: Vec<(Symbol, Written<Vec<Expr>>)>,
    /// Its motion, in what varies.
    pub(super) motion: Motion,
    /// Its text, without id and title.
    pub(super) text: Vec<Piece>,
    /// Place of its id in the file.
    pub span: Range<usize>,
}

impl Family {
    /// How many members there are, before constraints.
    pub fn size(&self) -> u64 {
        self.vary.iter().map(|v| v.spread.points()).product::<u64>() * self.draws
    }

    /// Whether everything that varies is drawn at random: then members are a sample of a distribution.
    pub fn is_sample(&self) -> bool {
        self.sequence == Drawing::Random
            && self.vary.iter().all(|v| v.spread.is_drawn() || v.spread.points() == 1)
            && self.vary.iter().any(|v| v.spread.is_drawn())
    }

    /// Whether what does not satisfy the constraints is drawn again. A point of a sequence is not: nothing else has its place.
    pub fn is_drawn_again(&self) -> bool {
        self.sequence == Drawing::Random && self.vary.iter().any(|v| v.spread.is_drawn())
    }

    /// The components of parameters that are declared positive and depend on what varies.
    pub fn positive(&self, graph: &Graph, is_positive: impl Fn(Symbol) -> bool) -> Vec<Expr> {
        let given = self.parameters.iter().filter(|(symbol, _)| is_positive(*symbol));
        let all = given.flat_map(|(_, written)| written.value.iter().copied());
        all.filter(|e| !graph.leaves_within([*e]).is_empty()).collect()
    }

    /// The id of a member as a trajectory: one that nothing else in the file has.
    pub fn member_id(&self, number: u64, is_taken: impl Fn(&str) -> bool) -> String {
        let id = format!("{}-{number}", self.id);
        let more = (2_u64..).map(|n| format!("{id}.{n}"));
        std::iter::once(id.clone()).chain(more).find(|id| !is_taken(id)).unwrap_or(id)
    }

    /// The motion with what varies left open.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The title of a member.
    pub fn member_title(&self, number: u64) -> String {
        format!("Member {number} of {}", self.id)
    }

    /// A member as a trajectory: `base` with these values, one for each that varies. `None` if one is no number.
    pub fn member(&self, graph: &mut Graph, base: &Trajectory, number: u64, values: &[f64]) -> Option<Trajectory> {
        let mut constants: Vec<(Leaf, Expr)> = Vec::new();
        for (varied, value) in self.vary.iter().zip(values) {
            constants.push((varied.leaf, graph.constant(exact(&decimal(*value))?)));
        }
        let value = |leaf: Leaf| constants.iter().find(|(l, _)| *l == leaf).map(|(_, e)| *e);
        let of_parameters: Vec<Symbol> = self.parameters.iter().map(|(symbol, _)| *symbol).collect();
        // As in a file, initial values keep the parameters that they are given by.
        let of_states = |leaf: Leaf| value(leaf).filter(|_| !of_parameters.contains(&leaf.symbol));
        type Image<'a> = &'a dyn Fn(Leaf) -> Option<Expr>;
        fn put(graph: &mut Graph, written: &Written<Vec<Expr>>, value: Image) -> Written<Vec<Expr>> {
            let value = written.value.iter().map(|e| graph.substitute(*e, |_, leaf| value(leaf))).collect();
            Written { value, text: written.text.clone(), span: written.span.clone() }
        }
        let parameters = self.parameters.iter().map(|(symbol, w)| (*symbol, put(graph, w, &value))).collect();
        let motion = match &self.motion {
            Motion::Integrated { system, initial, start } => Motion::Integrated {
                system: *system,
                initial: initial.iter().map(|(symbol, rate, w)| (*symbol, *rate, put(graph, w, &of_states))).collect(),
                start: start.as_ref().map(|s| s.with(|e| graph.substitute(e, |_, leaf| of_states(leaf)))),
            },
            Motion::Formula { states } => Motion::Formula {
                states: states.iter().map(|(symbol, w)| (*symbol, put(graph, w, &of_states))).collect(),
            },
            Motion::Derived { .. } => return None,
        };
        let (id, title) = (self.member_id(number, |_| false), self.member_title(number));
        let (states, span, initial_time, place) =
            (base.states.clone(), base.span, base.initial_time, base.place.clone());
        Some(Trajectory { id, title, says: None, motion, states, parameters, span, initial_time, place })
    }

    /// A member as it is written in a file.
    pub fn toml(&self, id: &str, number: u64, values: &[f64]) -> String {
        let title = self.member_title(number);
        let mut out = format!("[[trajectory]]\nid = \"{id}\"\ntitle = \"{title}\"\n");
        for piece in &self.text {
            match piece {
                Piece::Text(text) => out.push_str(text),
                Piece::Value(at) => out.push_str(&values.get(*at).map_or_else(String::new, |x| decimal(*x))),
            }
        }
        out
    }
}

/// A number in the digits that a file has; binary64 reads the same number from them.
fn decimal(x: f64) -> String {
    format!("{x:?}")
}
