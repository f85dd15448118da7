//! Premises about fields, closed under partial derivatives, and the points through which solutions pass.
//!
//! **In:** equations that hold at all places, and what is asked about. **Out:** [`Jets`]: derivatives of the equations, as many
//! as are needed; and a test whether values of derivatives at a point belong to a solution.
//!
//! # Which derivatives
//!
//! The derivatives of a field are independent unknowns (a jet). They are ranked: by total order, then by the orders by each
//! coordinate, the time first, then by field. The highest in an equation *leads* it; a field that it defines by others leads
//! before all. A derivative that is asked about, and is
//! one of a leader, asks for the same derivative of that equation, which names others, ranked lower; so this ends (Kolchin
//! 1973, ch. 0 § 17). Where two equations lead with derivatives of one field, both are derived up to the least that
//! they have in common: the difference is a condition of integrability, and a premise like any other. All of these hold wherever the
//! premises do, so what follows from them is proved; that some were left out can only lose a proof.
//!
//! # Other places
//!
//! A field at another place, u(0, t), is an unknown of its own there (see [`Place`]). The premises hold there, too, and are
//! taken there with their derivatives. No point refutes then: a solution near one place says nothing of another.
//!
//! # Points
//!
//! Whether a point that satisfies all of them belongs to a solution is the subject of [`passive`](super::passive).

use super::known::{Known, When};
use super::outcome::{Point, Premises, Reason, Vanishes};
use super::passive::{depends_on_all, least_common, passive};
use super::witness::{decimals, values_at};
use expr::domain::{self, row};
use expr::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op, Partials, Place, Symbol};

/// More derivatives are not formed: what is left out can only lose a proof.
const MOST_DERIVED: usize = 192;

/// Highest total order that is looked at.
const HIGHEST: u32 = 8;

/// More derivatives are not asked for because of what stands at other places.
const MOST_PROLONGED: usize = 48;

/// A component of a field.
type Unknown = (Symbol, u16);

/// An equation, with the derivative that leads it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Led {
    pub(super) left: Expr,
    pub(super) right: Expr,
    pub(super) leader: Leaf,
    /// Whether it holds at all places and times.
    pub(super) everywhere: bool,
}

/// Equations of fields with their derivatives.
#[derive(Clone, Debug, Default)]
pub(super) struct Jets {
    /// The derivatives.
    pub(super) derived: Vec<(Expr, Expr)>,
    /// Whether a premise names a field.
    named: bool,
    /// Whether several premises lead with derivatives of one field: further derivatives may tell more.
    pub(super) several: bool,
    /// What is divided by when each premise is solved for its leader, where Riquier's theorem applies.
    slopes: Option<Vec<Expr>>,
    /// What holds besides where nothing of that is 0.
    beside: Vec<(Expr, Expr)>,
}

/// Where a derivative stands in the ranking.
pub(super) fn rank(graph: &Graph, time: Option<Leaf>, leaf: Leaf) -> (u32, Vec<u8>, usize, Unknown) {
    let orders = leaf.partials.orders();
    let time = time.and_then(|t| graph.coordinate(t));
    let first = time.map_or(0, |at| orders[at]);
    let others = orders.into_iter().enumerate().filter(|(at, _)| Some(*at) != time).map(|(_, n)| n);
    let all = std::iter::once(first).chain(others).collect();
    let arguments = (0..graph.coordinates().count()).filter(|&at| graph.depends(leaf.symbol, at)).count();
    (leaf.partials.order(), all, arguments, (leaf.symbol, leaf.component))
}

/// The field that an equation defines by others: u in u = −φ_x/φ. There it leads, whatever the order of the others; any ranking
/// serves a proof, and a solution for the others is one for it.
fn defined(graph: &Graph, left: Expr, right: Expr) -> Option<Leaf> {
    let one = |e: Expr, of: Expr| match *graph.node(e) {
        Node::Leaf(leaf) if graph.is_field(leaf.symbol) && leaf.partials.is_none() => {
            let itself = |l: &Leaf| (l.symbol, l.component) == (leaf.symbol, leaf.component);
            (!graph.fields([of]).iter().any(itself)).then_some(leaf)
        }
        _ => None,
    };
    one(left, right).or_else(|| one(right, left))
}

/// Whether equations name fields.
pub(super) fn names_fields(graph: &Graph, (l, r): (Expr, Expr)) -> bool {
    !graph.fields([l, r]).is_empty()
}

impl Jets {
    /// Derives as far as `asked` asks for. An equation that names what has motions, and a field, is looked at as it is, and
    /// refutes nothing.
    ///
    /// # Errors
    /// [`Reason::NoDerivative`] where a derivative cannot be written.
    pub(super) fn of(
        graph: &mut Graph,
        given: &Premises,
        asked: &[Expr],
        is_zero: Vanishes,
        further: u8,
    ) -> Result<Jets, Reason> {
        let Premises { equations, time, moving, .. } = given;
        let time = *time;
        let mut out = Jets::default();
        let (mut led, mut pure) = (Vec::new(), true);
        for known in equations.iter().filter(|k| k.when.is_on_intervals()) {
            let (left, right, everywhere) = (known.left, known.right, known.when == When::Always);
            let fields = graph.fields([left, right]);
            let highest = fields.iter().copied().max_by_key(|l| rank(graph, time, *l));
            let whole = |leader: &Leaf| depends_on_all(graph, &Led { left, right, leader: *leader, everywhere });
            let defined = defined(graph, left, right);
            let leader = defined.filter(whole).or(highest.filter(whole)).or(defined).or(highest);
            let Some(leader) = leader else { continue };
            out.named = true;
            // What stands at a fixed time, or moves, is no field of its coordinates.
            let elsewhere = |l: &Leaf| l.instant.is_some() || moving.contains(&l.symbol);
            if graph.leaves_within([left, right]).iter().any(elsewhere) {
                pure = false;
                continue;
            }
            pure &= !graph.has_places([left, right]);
            led.push(Led { left, right, leader, everywhere });
        }
        if !out.named {
            return Ok(out);
        }
        // A solution near one place says nothing of other places.
        pure &= !graph.has_places(asked.iter().copied());
        let elsewhere = if pure { Vec::new() } else { instances(graph, given, &led, asked, time)? };
        let mut asked: Vec<Expr> = asked.iter().copied().chain(elsewhere.iter().flat_map(|&(l, r)| [l, r])).collect();
        let order = graph.fields(asked.iter().copied()).iter().map(|l| l.partials.order()).max().unwrap_or(0);
        let mut tied: Vec<Leaf> = led.iter().map(|p| p.leader).filter(|l| graph.place(l.symbol).is_some()).collect();
        prolong(graph, &mut tied, order);
        asked.extend(tied.into_iter().map(|l| graph.leaf(l)));
        let complete = out.derive(graph, &led, &asked, (time, further))?;
        for pair in elsewhere {
            if pair.0 != pair.1 && !out.derived.contains(&pair) {
                out.derived.push(pair);
            }
        }
        if pure && complete {
            out.slopes = out.closed(graph, (given, is_zero), &led, &asked)?;
        }
        Ok(out)
    }

    /// What must not be 0 at a point so that a solution passes through it, once the equations are passive. Those that this
    /// adds, and their derivatives, are premises like the others, but for what divides by something that the premises do not
    /// divide by: a proof from it would say less.
    fn closed(
        &mut self,
        graph: &mut Graph,
        (given, is_zero): (&Premises, Vanishes),
        led: &[Led],
        asked: &[Expr],
    ) -> Result<Option<Vec<Expr>>, Reason> {
        let Some(found) = passive(graph, led, &constants(graph, given), (given.time, is_zero))? else {
            return Ok(None);
        };
        let Some(completed) = found.completed else { return Ok(Some(found.slopes)) };
        let mut more = Jets::default();
        let complete = more.derive(graph, &completed, asked, (given.time, 0))?;
        let known = denominators(graph, given.sides());
        for pair in completed[led.len()..].iter().map(|p| (p.left, p.right)).chain(more.derived) {
            if given.says(pair) || self.derived.contains(&pair) {
                continue;
            }
            match denominators(graph, [pair.0, pair.1]).is_subset(&known) {
                true => self.derived.push(pair),
                false => self.beside.push(pair),
            }
        }
        Ok(complete.then_some(found.slopes))
    }

    /// The derivatives that are asked for, by what was asked and by each other; whether all were formed.
    fn derive(
        &mut self,
        graph: &mut Graph,
        led: &[Led],
        asked: &[Expr],
        (time, further): (Option<Leaf>, u8),
    ) -> Result<bool, Reason> {
        let mut wanted: Vec<(usize, Partials)> = Vec::new();
        // Conditions of integrability.
        for (i, a) in led.iter().enumerate() {
            for (j, b) in led.iter().enumerate().skip(i + 1) {
                if (a.leader.symbol, a.leader.component) == (b.leader.symbol, b.leader.component) {
                    self.several = true;
                    let both = least_common(a.leader.partials, b.leader.partials);
                    let beyond = (0..graph.coordinates().count()).filter(|_| further > 0);
                    for by in beyond.filter(|&by| graph.depends(a.leader.symbol, by)) {
                        let raised = Partials::NONE.raised(by);
                        wanted.extend([i, j].into_iter().flat_map(|at| raised.map(|p| (at, p))));
                    }
                    for (at, leader) in [(i, a.leader), (j, b.leader)] {
                        let beyond = both.and_then(|both| both.beyond(leader.partials));
                        wanted.extend(beyond.filter(|p| !p.is_none()).map(|p| (at, p)));
                    }
                }
            }
        }
        let mut open: Vec<Leaf> = graph.fields(asked.iter().copied());
        open.extend(graph.fields(led.iter().flat_map(|p| [p.left, p.right])));
        let (mut seen, mut formed) = (FastSet::<Leaf>::default(), FastSet::<(usize, Partials)>::default());
        let mut known: FastMap<(usize, Partials), (Expr, Expr)> = FastMap::default();
        let mut complete = true;
        loop {
            while let Some(leaf) = open.pop() {
                if !seen.insert(leaf) {
                    continue;
                }
                for (at, p) in led.iter().enumerate() {
                    let same = (p.leader.symbol, p.leader.component) == (leaf.symbol, leaf.component);
                    let beyond = leaf.partials.beyond(p.leader.partials).filter(|b| same && !b.is_none());
                    wanted.extend(beyond.map(|b| (at, b)));
                }
            }
            let Some((at, beyond)) = wanted.pop() else { break };
            if !formed.insert((at, beyond)) {
                continue;
            }
            if self.derived.len() >= MOST_DERIVED || beyond.order() + led[at].leader.partials.order() > HIGHEST {
                complete = false;
                continue;
            }
            let pair = derivative(graph, &mut known, led, (at, beyond))?;
            if pair.0 != pair.1 && !self.derived.contains(&pair) {
                self.derived.push(pair);
                open.extend(graph.fields([pair.0, pair.1]));
            }
        }
        // Lower ones first: they are solved first.
        let rank_of = |graph: &Graph, pair: &(Expr, Expr)| {
            graph.fields([pair.0, pair.1]).into_iter().map(|l| rank(graph, time, l)).max()
        };
        self.derived.sort_by_cached_key(|pair| rank_of(graph, pair));
        Ok(complete)
    }

    /// Whether a solution passes through a point at which the equations and their derivatives hold.
    pub(super) fn extends(&self, graph: &Graph, point: &Point) -> bool {
        if !self.named {
            return true;
        }
        let Some(slopes) = &self.slopes else { return false };
        let values = values_at(point);
        let known = decimals(graph, slopes, &values);
        let sides: Vec<Expr> = self.beside.iter().flat_map(|&(l, r)| [l, r]).collect();
        known.into_iter().all(|v| v.is_some_and(|v| v.value.abs() > v.error))
            && decimals(graph, &sides, &values).chunks(2).all(|pair| match pair {
                &[Some(l), Some(r)] => {
                    let error = l.error + r.error;
                    (l.value - r.value).abs() <= error && error <= 1e-6 * l.value.abs().max(1.0)
                }
                _ => false,
            })
    }
}

/// What is divided by below some expressions, numbers apart.
fn denominators(graph: &Graph, roots: impl IntoIterator<Item = Expr>) -> FastSet<Expr> {
    let divided = |e: Expr| {
        if let Node::Binary(Op::Div, _, b) = *graph.node(e) {
            return Some(b);
        }
        let Node::Unary(Op::Powi(n), a) = *graph.node(e) else { return None };
        (n < 0).then_some(a)
    };
    graph.reachable(roots).into_iter().filter_map(divided).filter(|&b| graph.as_constant(b).is_none()).collect()
}

/// What is given of constants: it holds at all places and times.
fn constants(graph: &Graph, given: &Premises) -> Premises {
    let constant = |roots: &[Expr]| {
        let changes = |l: &Leaf| {
            let moves = given.moving.contains(&l.symbol) || Some(*l) == given.time;
            moves || l.instant.is_some() || l.rate > 0 || graph.is_field(l.symbol) || graph.coordinate(*l).is_some()
        };
        !graph.leaves_within(roots.iter().copied()).iter().any(changes)
    };
    let facts = |all: &[Expr]| all.iter().copied().filter(|&e| constant(&[e])).collect();
    Premises {
        equations: given.equations.iter().copied().filter(|k| constant(&[k.left, k.right])).collect(),
        nonzero: facts(&given.nonzero),
        positive: facts(&given.positive),
        not_negative: facts(&given.not_negative),
        parameters: given.parameters.clone(),
        ..Premises::default()
    }
}

/// The equations, and their derivatives, at the other places at which their fields are named. They hold at all places, unless
/// something is given of coordinates besides: then it is not known that they do there. One that may have no value somewhere is
/// left out.
fn instances(
    graph: &mut Graph,
    given: &Premises,
    led: &[Led],
    asked: &[Expr],
    time: Option<Leaf>,
) -> Result<Vec<(Expr, Expr)>, Reason> {
    let facts = given.signs();
    let pointwise = |k: &Known| !k.when.is_on_intervals();
    let others = given.equations.iter().filter(|k| pointwise(k) || !names_fields(graph, k.sides()));
    let beside: Vec<Expr> = facts.chain(others.flat_map(|k| [k.left, k.right])).collect();
    if graph.leaves_within(beside).into_iter().any(|l| Some(l) == time || graph.coordinate(l).is_some()) {
        return Ok(Vec::new());
    }
    let sides: Vec<Expr> = asked.iter().copied().chain(given.sides()).collect();
    let fields = graph.fields(sides);
    let placed = fields.iter().filter_map(|l| Some((*l, graph.place(l.symbol)?.clone())));
    let (leaves, places): (Vec<Leaf>, Vec<Place>) = placed.unzip();
    // What holds at the places that a claim chooses need not hold at others.
    let everywhere = led.iter().filter(|p| p.everywhere);
    let here: Vec<Led> = everywhere.filter(|p| !graph.has_places([p.left, p.right])).copied().collect();
    let mut own: Vec<Leaf> = leaves.into_iter().map(|l| Leaf { symbol: graph.field_of(l.symbol), ..l }).collect();
    prolong(graph, &mut own, fields.iter().map(|l| l.partials.order()).max().unwrap_or(0));
    let own: Vec<Expr> = own.into_iter().map(|l| graph.leaf(l)).collect();
    let mut derived = Jets::default();
    derived.derive(graph, &here, &own, (time, 0))?;
    let mut all: Vec<(Expr, Expr)> = here.iter().map(|p| (p.left, p.right)).chain(derived.derived).collect();
    all.retain(|&(l, r)| has_values(graph, [l, r]));
    let coordinates: Vec<Leaf> = graph.coordinates().collect();
    let mut out: Vec<(Expr, Expr)> = Vec::new();
    for (i, place) in places.iter().enumerate() {
        if places[..i].contains(place) {
            continue;
        }
        let values: Vec<(Leaf, Expr)> =
            place.at.iter().filter_map(|&(at, e)| Some((*coordinates.get(at)?, e))).collect();
        for &(left, right) in &all {
            let pair = (graph.taken_at(left, &values), graph.taken_at(right, &values));
            if out.len() < MOST_DERIVED && !out.contains(&pair) {
                out.push(pair);
            }
        }
    }
    Ok(out)
}

/// All derivatives of some fields up to an order, unless they are too many: a condition at a boundary is derived along it, and
/// meets those of the equation there.
fn prolong(graph: &Graph, leaves: &mut Vec<Leaf>, order: u32) {
    let mut at = 0;
    while let Some(&leaf) = leaves.get(at) {
        for by in 0..graph.coordinates().count() {
            let raised = leaf.partials.raised(by).filter(|p| p.order() <= order && graph.depends(leaf.symbol, by));
            let raised = raised.map(|partials| Leaf { partials, ..leaf });
            if let Some(raised) = raised.filter(|r| leaves.len() < MOST_PROLONGED && !leaves.contains(r)) {
                leaves.push(raised);
            }
        }
        at += 1;
    }
}

/// Whether expressions have values at all places, as far as that is seen at once.
fn has_values(graph: &Graph, sides: [Expr; 2]) -> bool {
    let fixed = |e: Expr| {
        let changes = |l: &Leaf| graph.coordinate(*l).is_some() || graph.is_field(l.symbol) || l.rate > 0;
        !graph.leaves([e]).iter().any(changes)
    };
    let smooth = |op: Op| row(op).edges.iter().all(|edge| edge.place == domain::Place::Infinity);
    graph.reachable(sides).into_iter().all(|e| match *graph.node(e) {
        Node::Constant(_) | Node::Pi | Node::Leaf(_) => true,
        Node::Unary(op, a) => row(op).needs.is_empty() && smooth(op) || fixed(a),
        Node::Binary(Op::Div, _, b) => fixed(b),
        Node::Binary(op, a, b) => row(op).needs.is_empty() && smooth(op) || fixed(a) && fixed(b),
    })
}

/// Derives an equation, by steps that others share.
fn derivative(
    graph: &mut Graph,
    known: &mut FastMap<(usize, Partials), (Expr, Expr)>,
    led: &[Led],
    (at, beyond): (usize, Partials),
) -> Result<(Expr, Expr), Reason> {
    let (mut so_far, mut pair) = (Partials::NONE, (led[at].left, led[at].right));
    for by in beyond.steps() {
        so_far = so_far.raised(by).ok_or(Reason::TooLarge)?;
        pair = match known.get(&(at, so_far)) {
            Some(&pair) => pair,
            None => {
                let mut one = |e| graph.derivative_by(e, by).map_err(|_| Reason::NoDerivative);
                (one(pair.0)?, one(pair.1)?)
            }
        };
        known.insert((at, so_far), pair);
    }
    Ok(pair)
}
