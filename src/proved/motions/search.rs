//! The search: courses of what moves, one after the other, each step checked by what is given.

mod courses;

use super::clock::{has_course, read};
use super::demand::{Demand, Question, Said, Wanted};
use super::polynomial::Fraction;
use super::scene::{Scene, definition};
use super::value::{Cell, Stop, Value, difference};
use super::{At, Motion};
use crate::derivation::{Claim, Derivation};
use crate::expr::{Expr, FastSet, Leaf, Node, Rational, Symbol};
use crate::latex::{Relation, RelationKind, Role};

/// Most components that are looked for.
const MOST_NAMES: usize = 6;
/// Most demands.
const MOST_DEMANDS: usize = 24;
/// Operations that are carried out for a span.
const MOST_WORK: usize = 150_000;
/// The same for a claim that is tried on motions, too.
const LEAST_WORK: usize = 3_000;
/// The highest rate that is looked at.
const MOST_ORDER: u8 = 4;

/// What is known of something said on a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Truth {
    True,
    False,
    Void,
}

/// A component with the order of its rate, its formula, and what that names.
type ExplicitRate = (Leaf, Expr, FastSet<(Symbol, u16)>);

struct Search<'q, 'a> {
    scene: Scene<'a>,
    question: &'q Question<'a>,
    /// Equations that give a rate of a component: the component, the order, the formula, and what that names.
    explicit: Vec<ExplicitRate>,
    positive: FastSet<Symbol>,
    unknown: Vec<Leaf>,
    /// Times about which courses are laid.
    about: Vec<Rational>,
    numbers: Vec<i64>,
    most_work: usize,
}

/// A motion that is as is wanted, if the search finds one.
pub(super) fn search<'a>(derivation: &'a Derivation, claim: &'a Claim, question: &Question<'a>) -> Option<Motion> {
    let scope = &claim.scope;
    let is_free = |l: &&Leaf| definition(derivation, scope, **l).is_none();
    let mut unknown: Vec<Leaf> = question.names.iter().filter(is_free).copied().collect();
    let graph = &derivation.graph;
    let moves = |l: &Leaf| has_course(graph, scope, question.clock, *l);
    let is_constant = |l: &Leaf| scope.role(l.symbol) == Some(Role::Parameter) && graph.coordinate(*l).is_none();
    let known_role = |l: &Leaf| moves(l) || is_constant(l);
    let too_many = unknown.len() > MOST_NAMES || question.demands.len() > MOST_DEMANDS || question.order > MOST_ORDER;
    if too_many || unknown.is_empty() || !unknown.iter().all(known_role) {
        return None;
    }
    // Constants first.
    unknown.sort_by_key(moves);
    let positive = unknown.iter().map(|l| l.symbol).filter(|s| derivation.is_positive_parameter(*s)).collect();
    let constant = |e: &Expr| derivation.graph.as_constant(*e).cloned();
    let mut about: Vec<Rational> = question.instants.iter().filter_map(constant).collect();
    about.push(Rational::ZERO);
    about.sort();
    about.dedup();
    if about.len() > 4 {
        return None;
    }
    let mut numbers = vec![0, 1, 2, -1];
    numbers.extend(question.numbers.iter().copied().filter(|n| !(-1..=2).contains(n) && n.abs() < 100).take(3));
    let explicit = explicit(derivation, question);
    let (first, last) = (about.first()?.clone(), about.last()?.clone());
    for room in [Rational::ONE / Rational::from(2), Rational::from(2)] {
        let span = (&first - &room, &last + &room);
        let mut search = Search {
            scene: Scene::new(derivation, (scope, question.clock), span),
            question,
            explicit: explicit.clone(),
            positive: FastSet::clone(&positive),
            unknown: unknown.clone(),
            about: about.clone(),
            numbers: numbers.clone(),
            most_work: if claim.is_tried() { LEAST_WORK } else { MOST_WORK },
        };
        if let Some(found) = search.choose(&FastSet::default()) {
            return Some(found);
        }
    }
    None
}

/// The equations that give a rate, or a value, of a component by others, at all times.
fn explicit(derivation: &Derivation, question: &Question) -> Vec<ExplicitRate> {
    let graph = &derivation.graph;
    let mut out = Vec::new();
    for demand in question.demands.iter().filter(|d| d.chosen_by.is_empty()) {
        let Said::Relation(relation) = demand.said else { continue };
        if relation.kind != RelationKind::Equal {
            continue;
        }
        let pairs = relation.left.components.iter().zip(&relation.right.components);
        for (&l, &r) in pairs.flat_map(|(l, r)| [(l, r), (r, l)]) {
            let Node::Leaf(leaf) = *graph.node(l) else { continue };
            let leaf = read(graph, leaf);
            if leaf.instant.is_some() || !question.names.contains(&Leaf::now(leaf.symbol, leaf.component)) {
                continue;
            }
            let mut names = demand.names.clone();
            let own = (leaf.symbol, leaf.component);
            let within = graph.leaves_within([r]).into_iter().map(|l| read(graph, l));
            let itself = within.into_iter().any(|l| (l.symbol, l.component) == own);
            names.remove(&own);
            if !itself {
                out.push((leaf, r, names));
            }
        }
    }
    out
}

impl<'a> Search<'_, 'a> {
    /// Chooses the course of one more component, and all after it.
    fn choose(&mut self, chosen: &FastSet<(Symbol, u16)>) -> Option<Motion> {
        let open: Vec<Leaf> =
            self.unknown.iter().filter(|l| !chosen.contains(&(l.symbol, l.component))).copied().collect();
        if open.is_empty() {
            return self.refuted();
        }
        let is_state = |l: &Leaf| has_course(&self.scene.derivation.graph, self.scene.scope, self.scene.clock, *l);
        let given = |l: &Leaf| {
            let of = |(leaf, _, names): &&(Leaf, Expr, FastSet<(Symbol, u16)>)| {
                (leaf.symbol, leaf.component) == (l.symbol, l.component) && names.iter().all(|n| chosen.contains(n))
            };
            self.explicit.iter().find(of).map(|(leaf, e, _)| (*leaf, *e))
        };
        // Constants; then what follows from what is chosen; then what no equation gives.
        let constant = open.iter().find(|l| !is_state(l)).copied();
        let following = open.iter().find_map(|l| Some((*l, given(l)?)));
        let named =
            |l: &&Leaf| !self.explicit.iter().any(|(of, ..)| (of.symbol, of.component) == (l.symbol, l.component));
        let before = self.scene.breaks().to_vec();
        let (next, courses) = match (constant, following) {
            (Some(constant), _) => return self.choose_constant(constant, chosen),
            (None, Some((leaf, (rate, formula)))) => (leaf, self.integrated(rate.rate, formula)),
            (None, None) => (open.iter().find(named).or(open.first()).copied()?, self.free()),
        };
        self.scene.join(before.clone());
        let component = (next.symbol, next.component);
        let mut chosen = chosen.clone();
        chosen.insert(component);
        for course in courses {
            if self.scene.work() > self.most_work {
                break;
            }
            let breaks: Vec<Rational> = course.pieces.iter().map(|(at, _)| at.clone()).collect();
            // Of fields it is claimed that they are smooth, whatever is asked of them.
            let is_field = self.scene.derivation.graph.is_field(next.symbol);
            let smooth = course.is_smooth(self.question.order + 1) && (course.pieces.is_empty() || !is_field);
            let room = smooth
                && breaks
                    .into_iter()
                    .all(|at| at <= self.scene.span.0 || at >= self.scene.span.1 || self.scene.part(at));
            if room {
                self.scene.courses.insert(component, course);
                if self.is_met(component, &chosen)
                    && let Some(found) = self.choose(&chosen)
                {
                    return Some(found);
                }
            }
            self.scene.join(before.clone());
        }
        self.scene.courses.remove(&component);
        None
    }

    fn choose_constant(&mut self, leaf: Leaf, chosen: &FastSet<(Symbol, u16)>) -> Option<Motion> {
        let component = (leaf.symbol, leaf.component);
        let mut chosen = chosen.clone();
        chosen.insert(component);
        let positive = self.positive.contains(&leaf.symbol);
        // Those that are named come last.
        let named = self.numbers.get(4..).unwrap_or_default();
        let numbers: Vec<i64> = [1, 0, 2, -1].iter().chain(named).copied().filter(|n| !positive || *n > 0).collect();
        let before = self.scene.breaks().to_vec();
        for number in numbers {
            if self.scene.work() > self.most_work {
                break;
            }
            self.scene.constants.insert(component, Rational::from(number));
            if self.is_met(component, &chosen)
                && let Some(found) = self.choose(&chosen)
            {
                return Some(found);
            }
            self.scene.join(before.clone());
        }
        self.scene.constants.remove(&component);
        None
    }

    /// An answer of pieces in which nothing changes its sign; `None` if it is not known.
    fn parted<T>(&mut self, mut ask: impl FnMut(&Self) -> Result<T, Stop>) -> Option<T> {
        loop {
            match ask(self) {
                Ok(found) => return Some(found),
                Err(Stop::Part(at)) if !self.scene.breaks().contains(&at) && self.scene.part(at.clone()) => {}
                Err(_) => return None,
            }
        }
    }

    /// Whether all demands that name a component, and nothing beyond what is chosen, are met.
    fn is_met(&mut self, component: (Symbol, u16), chosen: &FastSet<(Symbol, u16)>) -> bool {
        let question = self.question;
        let unknown = self.unknown.clone();
        let defined = |n: &(Symbol, u16)| chosen.contains(n) || !unknown.contains(&Leaf::now(n.0, n.1));
        let due: Vec<&Demand> =
            question.demands.iter().filter(|d| d.names.contains(&component) && d.names.iter().all(defined)).collect();
        if !due.into_iter().all(|demand| self.parted(|this| this.demanded(demand)) == Some(true)) {
            return false;
        }
        // Once the claim is decided: it must be as is wanted somewhere.
        let decided = question.claim_names.contains(&component) && question.claim_names.iter().all(defined);
        !decided
            || self
                .parted(|this| this.wanted(&this.chosen(&question.chosen_by)?))
                .is_some_and(|found| !found.is_empty())
    }

    /// The times of some cells that are wanted.
    fn wanted(&self, cells: &[usize]) -> Result<Vec<At>, Stop> {
        match self.question.wanted {
            Wanted::Fault => self.refutes(cells),
            Wanted::Example => self.is_example(cells),
        }
    }

    /// A time of some cells at which the claim says something, and is true, as far as it does not compare several; with ± of one sign.
    fn is_example(&self, cells: &[usize]) -> Result<Vec<At>, Stop> {
        let question = self.question;
        let signed: Vec<Said> = question.signed.iter().map(|r| Said::Relation(r)).collect();
        for &cell in cells {
            let is_so = |said: &Said| match said {
                Said::Relation(_) => self.truth(*said, cell).map(|truth| truth == Truth::True),
                Said::Constant(e) => self.scene.value(*e, cell).map(|_| true),
            };
            let all = |list: &[Said]| list.iter().try_fold(true, |all, said| Ok::<_, Stop>(all && is_so(said)?));
            let any_sign = [1, -1].into_iter().try_fold(false, |any, sign| {
                self.scene.sign.set(sign);
                Ok::<_, Stop>(any || all(&signed)?)
            });
            let place = self.scene.cells().get(cell).ok_or(Stop::Unknown)?;
            if all(&question.claimed)? && any_sign? {
                return Ok(vec![At { t: place.inside().to_string(), sides: Default::default() }]);
            }
        }
        Ok(Vec::new())
    }

    /// A time of some cells at which the claim is false; of a sign that should serve for the whole motion, one for the upper sign and one
    /// for the lower.
    fn refutes(&self, cells: &[usize]) -> Result<Vec<At>, Stop> {
        for &said in &self.question.claimed {
            if let Some(found) = self.false_at(said, cells)? {
                return Ok(vec![found]);
            }
        }
        let mut out = Vec::new();
        for sign in [1, -1] {
            self.scene.sign.set(sign);
            for &relation in self.question.signed.iter().filter(|_| out.len() < 2) {
                let found = self.false_at(Said::Relation(relation), cells)?;
                if found.is_some() {
                    out.extend(found);
                    break;
                }
            }
        }
        Ok(if out.len() == 2 { out } else { Vec::new() })
    }

    fn demanded(&self, demand: &Demand) -> Result<bool, Stop> {
        let cells = self.chosen(&demand.chosen_by)?;
        if let Said::Constant(e) = demand.said {
            return Ok(self.changes(e, &cells)?.is_none());
        }
        let mut met = demand.chosen_by.is_empty();
        for &cell in &cells {
            match self.truth(demand.said, cell)? {
                Truth::True => met = true,
                Truth::False => return Ok(false),
                Truth::Void if demand.asserted => return Ok(false),
                Truth::Void => {}
            }
        }
        Ok(met || cells.is_empty())
    }

    /// The cells at which all of some relations are true.
    fn chosen(&self, by: &[&Relation]) -> Result<Vec<usize>, Stop> {
        let mut out = Vec::new();
        for cell in 0..self.scene.cells().len() {
            let mut all = true;
            for relation in by {
                all &= self.truth(Said::Relation(relation), cell)? == Truth::True;
            }
            if all {
                out.push(cell);
            }
        }
        Ok(out)
    }

    fn truth(&self, said: Said, cell: usize) -> Result<Truth, Stop> {
        let Said::Relation(relation) = said else { return Err(Stop::Unknown) };
        let place = self.scene.cells().get(cell).ok_or(Stop::Unknown)?;
        let mut same = true;
        for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
            let (left, right) = match (self.scene.value(l, cell), self.scene.value(r, cell)) {
                (Err(part @ Stop::Part(_)), _) | (_, Err(part @ Stop::Part(_))) => return Err(part),
                (Err(Stop::Void), _) | (_, Err(Stop::Void)) => return Ok(Truth::Void),
                (Ok(left), Ok(right)) => (left, right),
                _ => return Err(Stop::Unknown),
            };
            let apart = difference(&left, &right)?.filter(|d| !d.is_zero());
            if relation.kind == RelationKind::Equal {
                same &= apart.is_none();
                continue;
            }
            let sign = place.sign(&apart.unwrap_or_else(|| Fraction::constant(Rational::ZERO)))?;
            let holds = match relation.kind {
                RelationKind::Equal => true,
                RelationKind::NotEqual => {
                    same &= sign.is_eq();
                    continue;
                }
                RelationKind::Less => sign.is_lt(),
                RelationKind::LessEqual => sign.is_le(),
                RelationKind::Greater => sign.is_gt(),
                RelationKind::GreaterEqual => sign.is_ge(),
            };
            if !holds {
                return Ok(Truth::False);
            }
        }
        let is_so = match relation.kind {
            RelationKind::NotEqual => !same,
            _ => same,
        };
        Ok(if is_so { Truth::True } else { Truth::False })
    }

    /// Two values of something at times of some cells, if they differ, and one of the times.
    fn changes(&self, e: Expr, cells: &[usize]) -> Result<Option<At>, Stop> {
        let mut first: Option<Value> = None;
        for &cell in cells {
            let place = self.scene.cells().get(cell).ok_or(Stop::Unknown)?;
            let value = match self.scene.value(e, cell) {
                Err(Stop::Void) => continue,
                found => found?,
            };
            let Value::Plain(f, k) = &value else { return Err(Stop::Unknown) };
            let shown = |v: &Value, t: &Rational| v.shown(t).ok_or(Stop::Unknown);
            if f.as_constant().is_none() {
                let Cell::Open(low, high) = place else { return Err(Stop::Unknown) };
                let quarter = (high - low) / Rational::from(4);
                let (t, s) = (low + &quarter, high - &quarter);
                if f.at(&t) != f.at(&s) {
                    return Ok(Some(At { sides: [shown(&value, &t)?, shown(&value, &s)?], t: t.to_string() }));
                }
                return Err(Stop::Unknown);
            }
            let t = place.inside();
            match &first {
                Some(Value::Plain(g, l)) if g != f || k != l => {
                    let before = first.as_ref().ok_or(Stop::Unknown)?;
                    return Ok(Some(At { sides: [shown(&value, &t)?, shown(before, &t)?], t: t.to_string() }));
                }
                Some(_) => {}
                None => first = Some(value.clone()),
            }
        }
        Ok(None)
    }

    /// A time at which the claim is false, of those of which it speaks, and at which all that is given is so.
    fn refuted(&mut self) -> Option<Motion> {
        let question = self.question;
        let found = self.parted(|this| {
            // Everything given, once more and together: nothing may be left out.
            for demand in &question.demands {
                if !this.demanded(demand)? {
                    return Ok(Vec::new());
                }
            }
            let mut cells = this.chosen(&question.chosen_by)?;
            for demand in &question.demands {
                let mut met = Vec::new();
                for &cell in &cells {
                    let is_so = match demand.said {
                        Said::Relation(_) => this.truth(demand.said, cell)? == Truth::True,
                        Said::Constant(e) => this.scene.value(e, cell).is_ok(),
                    };
                    if is_so {
                        met.push(cell);
                    }
                }
                cells = met;
            }
            let valued = this.valued()?;
            let mut reached = Vec::new();
            for cell in cells {
                if this.reaches(cell, &valued)? {
                    reached.push(cell);
                }
            }
            this.wanted(&reached)
        })?;
        let mut found = found.into_iter();
        let (first, second) = (found.next()?, found.next());
        let graph = &self.scene.derivation.graph;
        let clock = self.scene.clock.map_or_else(|| "t".to_owned(), |clock| graph.leaf_latex(clock));
        let mut courses: Vec<(String, String)> = Vec::new();
        for leaf in &self.unknown {
            let component = (leaf.symbol, leaf.component);
            let name = self.scene.derivation.graph.leaf_latex(*leaf);
            let shown = match (self.scene.courses.get(&component), self.scene.constants.get(&component)) {
                (Some(course), _) => course.shown(&clock),
                (None, Some(number)) => number.to_string(),
                (None, None) => return None,
            };
            courses.push((name, shown));
        }
        Some(Motion { courses, clock, first, second })
    }

    /// The cells at which all that is given has values, as far as it speaks of them.
    fn valued(&self) -> Result<Vec<bool>, Stop> {
        let mut out = vec![true; self.scene.cells().len()];
        for demand in &self.question.demands {
            for cell in self.chosen(&demand.chosen_by)? {
                out[cell] &= match demand.said {
                    Said::Relation(_) => self.truth(demand.said, cell)? != Truth::Void,
                    Said::Constant(e) => match self.scene.value(e, cell) {
                        Ok(_) => true,
                        Err(Stop::Void) => false,
                        Err(stop) => return Err(stop),
                    },
                };
            }
        }
        Ok(out)
    }

    /// Whether an interval of times around a cell, with the fixed times that are named, is one on which all that is given has values: the
    /// motion is one on that interval.
    fn reaches(&self, cell: usize, valued: &[bool]) -> Result<bool, Stop> {
        if !valued[cell] {
            return Ok(false);
        }
        let low = (0..=cell).rev().take_while(|&c| valued[c]).last().unwrap_or(cell);
        let high = (cell..valued.len()).take_while(|&c| valued[c]).last().unwrap_or(cell);
        let is_open = |c: usize| matches!(self.scene.cells().get(c), Some(Cell::Open(..)));
        if !(low..=high).any(is_open) {
            return Ok(false);
        }
        for &instant in &self.question.instants {
            let Value::Plain(at, 0) = self.scene.value(instant, cell)? else { return Err(Stop::Unknown) };
            let at = at.as_constant().ok_or(Stop::Unknown)?;
            match self.scene.breaks().binary_search(&at) {
                Ok(number) if (low..=high).contains(&(2 * number + 1)) => {}
                Ok(_) => return Ok(false),
                Err(_) => return Err(Stop::Part(at)),
            }
        }
        Ok(true)
    }

    fn false_at(&self, said: Said, cells: &[usize]) -> Result<Option<At>, Stop> {
        let relation = match said {
            Said::Relation(relation) => relation,
            Said::Constant(e) => return self.changes(e, cells),
        };
        for &cell in cells {
            let place = self.scene.cells().get(cell).ok_or(Stop::Unknown)?;
            let truth = match self.truth(said, cell) {
                Err(Stop::Unknown) => continue,
                found => found?,
            };
            if truth != Truth::False || relation.kind == RelationKind::NotEqual {
                continue;
            }
            // Different functions differ at some of a few times.
            for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                let (left, right) = (self.scene.value(l, cell)?, self.scene.value(r, cell)?);
                for share in [2, 3, 5, 7] {
                    let t = match place {
                        Cell::At(t) => t.clone(),
                        Cell::Open(low, high) => low + (high - low) / Rational::from(share),
                    };
                    let apart = difference(&left, &right)?.and_then(|d| d.at(&t)).filter(|d| *d != Rational::ZERO);
                    if let (Some(_), Some(left), Some(right)) = (apart, left.shown(&t), right.shown(&t)) {
                        return Ok(Some(At { t: t.to_string(), sides: [left, right] }));
                    }
                }
            }
        }
        Ok(None)
    }
}
