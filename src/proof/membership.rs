//! The search for certificates: division, and Buchberger's algorithm with cofactors.
//!
//! **In:** equations and premises. **Out:** a [`Certificate`] for each equation, or the reason why there is none.
//!
//! The relations (premises and meanings of variables, see [`certificate`](super::certificate)) may be a Gröbner basis as they
//! stand; otherwise one is computed, with its cofactors. What is found is accepted only after d·N − Σ qᵢ·pᵢ has been expanded
//! to 0. Nothing of the random route enters: neither the solver nor the finite fields; the two share the reading of the
//! formulas (`prepare`, `lower`). Work is counted (`budget`), so that the outcome is the same on every machine.
//!
//! Where nothing is given but c² + s² = 1, the ring of the relations is a domain and its elements have a normal form. An
//! equation whose numerator is not 0 in it is no identity: [`NoCertificate::Refuted`]. That is a contradiction to any proof
//! over finite fields, and is how each route can convict the other.

use super::budget::{Coefficient, within};
use super::certificate::{Certificate, Cofactor, Effort, NoCertificate, Origin, Program};
use super::linear::Combinations;
use super::lower::Generator;
use super::outcome::{Premises, Reason};
use super::polynomial::{factors, fraction};
use super::prepare::{Explicit, explicit, with_rates};
use super::prove::{Lowered, lower};
use super::solve::insert_definitions;
use super::written::{Writer, functions, meaning};
use ::groebner::{LiftBasis, Monomial, MonomialOrder, Polynomial, PolynomialExt, verify_lift};
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::rc::Rc;

type Poly = Polynomial<Coefficient>;

/// Most characters of a formula that is shown in a certificate.
const LONGEST: usize = 400;

/// See [`certify`](super::certify).
pub(super) fn certify(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    effort: Effort,
) -> Result<Vec<Certificate>, NoCertificate> {
    let wrong = NoCertificate::NotPolynomial;
    let (premises, _) = with_rates(graph, given, equations).map_err(wrong)?;
    let solved = explicit(graph, &premises, equations, given);
    let insert = |graph: &mut Graph, e: Expr| insert_definitions(graph, &solved.definitions, e);
    let claim: Vec<(Expr, Expr)> = equations.iter().map(|&(l, r)| (insert(graph, l), insert(graph, r))).collect();
    let nonzero: Vec<Expr> = given.nonzero.iter().map(|&e| insert(graph, e)).collect();
    let positive: Vec<Expr> = given.positive.iter().map(|&e| insert(graph, e)).collect();
    // What every function of the formulas is lowered to, for the text: see `written`.
    let sides = equations.iter().copied().chain(solved.rest.iter().map(|p| (p.left, p.right)));
    let named = functions(graph, sides.flat_map(|(l, r)| [l, r]), &solved.definitions);
    let zero = graph.integer(0);
    let inserted: Vec<(Expr, Expr)> = named.iter().map(|&f| (insert(graph, f), zero)).collect();
    let all: Vec<(Expr, Expr)> = claim.iter().chain(&inserted).copied().collect();
    let lowered =
        lower(graph, &solved.rest, &all, [&nonzero, &positive, &[]], &[], [false; 2], &mut Combinations::default())
            .map_err(wrong)?;
    let images = named.iter().copied().zip(lowered.claim[claim.len()..].iter().map(|&(image, _)| image)).collect();
    let origin = Given { equations, solved: &solved, images: &images };
    let mut search = Search { graph, lowered: &lowered, origin, effort, left: effort.work };
    let mut system = search.system()?;
    let mut out = Vec::new();
    for (equation, &sides) in equations.iter().enumerate() {
        out.push(search.certificate(&mut system, equation, sides)?);
    }
    Ok(out)
}

/// The problem before it was lowered, for the text of a certificate.
#[derive(Clone, Copy)]
struct Given<'a> {
    equations: &'a [(Expr, Expr)],
    solved: &'a Explicit,
    /// Functions of the formulas, and what each is lowered to.
    images: &'a FastMap<Expr, Expr>,
}

/// Why a relation holds.
#[derive(Clone, Copy)]
enum Source {
    /// It is this one of the premises, definitions inserted.
    Premise(usize),
    /// The meaning of a variable, in words.
    Meaning(&'static str),
}

/// A relation between the variables.
struct Relation {
    polynomial: Poly,
    source: Source,
    /// What is equal.
    sides: (Expr, Expr),
}

/// (N, D), see [`written`](super::written).
type Quotient = Rc<(Poly, Poly)>;

/// An expression, and whether it is of the problem after lowering.
type Place = (Expr, bool);

/// A ring and the relations in it.
struct System {
    variables: Vec<Expr>,
    place: FastMap<Expr, usize>,
    relations: Vec<Relation>,
    basis: Option<LiftBasis<Coefficient>>,
    /// What expressions are as quotients of polynomials.
    quotients: FastMap<Place, Quotient>,
    /// Nothing is given but c² + s² = 1.
    only_circles: bool,
}

struct Search<'a> {
    graph: &'a mut Graph,
    lowered: &'a Lowered,
    origin: Given<'a>,
    effort: Effort,
    /// Work that is left.
    left: u64,
}

impl Search<'_> {
    /// A computation within the work that is left.
    fn counted<R>(&mut self, computation: impl FnOnce() -> R) -> Result<R, NoCertificate> {
        let (value, left) = within(self.left, computation);
        self.left = left;
        value.ok_or(NoCertificate::TooLarge)
    }

    fn system(&mut self) -> Result<System, NoCertificate> {
        let lowered = self.lowered;
        let mut roots: Vec<Expr> = lowered.claim.iter().flat_map(|&(l, r)| [l, r]).collect();
        roots.extend(lowered.premises.iter().map(|&(e, _)| e));
        // Variables: roots and |·| first, then rates, then the rest, so that elimination goes that way.
        let mut variables = Vec::new();
        let mut only_circles = lowered.premises.iter().all(|&(e, _)| self.graph.is_zero(e));
        only_circles &= lowered.generators.are_independent(self.graph);
        for e in self.graph.reachable(roots) {
            match *self.graph.node(e) {
                Node::Leaf(leaf) => {
                    variables.push((if leaf.rate > 0 { 1 } else { 2 }, e));
                    // The partner of a cosine or sine is needed for their relation.
                    if let Some((c, s)) = lowered.generators.circle(leaf) {
                        let (c, s) = (self.graph.leaf(c), self.graph.leaf(s));
                        variables.extend([(2, c), (2, s)]);
                    }
                }
                Node::Unary(Op::Sqrt | Op::Abs, _) => {
                    only_circles = false;
                    variables.push((0, e));
                }
                _ => {}
            }
        }
        variables.sort_unstable_by_key(|&(class, e)| (class, std::cmp::Reverse(e)));
        variables.dedup();
        let variables: Vec<Expr> = variables.into_iter().map(|(_, e)| e).collect();
        let place = variables.iter().enumerate().map(|(i, &e)| (e, i)).collect();
        let mut system = System {
            variables,
            place,
            relations: Vec::new(),
            basis: None,
            quotients: FastMap::default(),
            only_circles,
        };
        let own: Vec<(Expr, (Expr, Expr))> =
            system.variables.iter().filter_map(|&e| Some((e, own_relation(self.graph, lowered, e)?))).collect();
        for (e, sides) in own {
            let words = match *self.graph.node(e) {
                Node::Unary(Op::Sqrt, _) => "a root is squared",
                Node::Unary(..) => "an absolute value is squared",
                _ => "c² + s² = 1",
            };
            self.relate(&mut system, sides, true, Source::Meaning(words))?;
        }
        for (at, premise) in self.origin.solved.rest.iter().enumerate() {
            self.relate(&mut system, (premise.left, premise.right), false, Source::Premise(at))?;
        }
        Ok(system)
    }

    fn relate(
        &mut self,
        system: &mut System,
        sides: (Expr, Expr),
        lowered: bool,
        source: Source,
    ) -> Result<(), NoCertificate> {
        let (polynomial, _) = self.difference(system, sides, lowered)?;
        if !polynomial.terms.is_empty() {
            system.relations.push(Relation { polynomial: integral(&polynomial), source, sides });
        }
        Ok(())
    }

    /// (N, D) of the difference of two sides.
    fn difference(
        &mut self,
        system: &mut System,
        (l, r): (Expr, Expr),
        lowered: bool,
    ) -> Result<(Poly, Poly), NoCertificate> {
        let (graph, origin, most) = (&*self.graph, self.origin, self.effort.terms);
        let (value, left) = within(self.left, || {
            let l = system.quotient(graph, origin, (l, lowered), most)?;
            let r = system.quotient(graph, origin, (r, lowered), most)?;
            combined(Op::Sub, &l, &r, most)
        });
        self.left = left;
        value.ok_or(NoCertificate::TooLarge)?
    }

    fn certificate(
        &mut self,
        system: &mut System,
        equation: usize,
        (l, r): (Expr, Expr),
    ) -> Result<Certificate, NoCertificate> {
        let (conclusion, under) = self.difference(system, (l, r), false)?;
        if under.terms.is_empty() {
            return Err(NoCertificate::NotPolynomial(Reason::NoValue));
        }
        let bases = not_zero(self.graph, self.lowered);
        let one = system.constant(&Rational::ONE);
        let (mut factor, mut used) = (one.clone(), Vec::new());
        for base in bases {
            let (top, _) = fraction(self.graph, base);
            let Ok(p) = self.expand(system, top) else { continue };
            if p.terms.is_empty() {
                return Err(NoCertificate::NotPolynomial(Reason::NoValue));
            }
            if factor.terms.len() * p.terms.len() > 64 {
                break;
            }
            factor = self.counted(|| &factor * &p)?;
            used.push(base);
        }
        let mut multiplier = one;
        for power in 0..3 {
            if power > 0 {
                multiplier = self.counted(|| &multiplier * &factor)?;
            }
            if multiplier.terms.len() * conclusion.terms.len() > 4 * self.effort.terms {
                break;
            }
            let target = self.counted(|| &multiplier * &conclusion)?;
            if let Some(cofactors) = self.lift(system, &target)? {
                let used = if power > 0 { used } else { Vec::new() };
                return self.written(system, equation, (&multiplier, &used), (&conclusion, &under), &cofactors);
            }
            if system.only_circles && power == 0 {
                return Err(NoCertificate::Refuted { equation });
            }
            if used.is_empty() {
                break;
            }
        }
        Err(NoCertificate::NotMember { equation })
    }

    /// Cofactors over the relations, verified.
    fn lift(&mut self, system: &mut System, target: &Poly) -> Result<Option<Vec<Poly>>, NoCertificate> {
        let relations: Vec<Poly> = system.relations.iter().map(|r| r.polynomial.clone()).collect();
        if relations.is_empty() {
            return Ok(target.terms.is_empty().then(Vec::new));
        }
        let (quotients, remainder) = self.counted(|| target.divide_with_remainder(&relations))?;
        if remainder.terms.is_empty() {
            let verified = self.counted(|| verify_lift(&relations, &quotients, target))?;
            return Ok(verified.then_some(quotients));
        }
        if is_basis(&relations) {
            return Ok(None);
        }
        if system.basis.is_none() {
            let basis = self.counted(|| LiftBasis::new(&relations))?;
            system.basis = Some(basis.map_err(|_| NoCertificate::TooLarge)?);
        }
        let Some(basis) = &system.basis else { return Ok(None) };
        let found = self.counted(|| {
            let cofactors = basis.lift(target).ok().flatten()?;
            verify_lift(&relations, &cofactors, target).then_some(cofactors)
        })?;
        Ok(found)
    }

    /// A polynomial, from an expression without division.
    fn expand(&mut self, system: &System, e: Expr) -> Result<Poly, NoCertificate> {
        let (graph, effort) = (&*self.graph, self.effort);
        let (value, left) = within(self.left, || system.expand(graph, e, effort.terms));
        self.left = left;
        value.ok_or(NoCertificate::TooLarge)?
    }

    fn written(
        &mut self,
        system: &System,
        equation: usize,
        (multiplier, used): (&Poly, &[Expr]),
        (conclusion, under): (&Poly, &Poly),
        cofactors: &[Poly],
    ) -> Result<Certificate, NoCertificate> {
        if cofactors.iter().map(|q| q.terms.len()).sum::<usize>() > self.effort.terms {
            return Err(NoCertificate::TooLarge);
        }
        // Integer coefficients throughout: N by its own denominators, then d and all q by the common one of what is left.
        let top = integral(conclusion);
        let by = ratio(&top, conclusion);
        let scale = denominators(cofactors.iter().chain([multiplier]));
        let scaled = |p: &Poly, k: &BigRational| map(p, |c| c * k);
        let names = Names::new(self.graph, self.lowered, &system.variables);
        let mut terms = Vec::new();
        let mut occurring = vec![false; names.list.len()];
        let mut text = |p: &Poly| {
            for (m, _) in &p.terms {
                for (seen, &k) in occurring.iter_mut().zip(m.exps()) {
                    *seen |= k > 0;
                }
            }
            python(p, &names.list)
        };
        // d·(by·N) = Σ (by·q)·p, everything times the common denominator.
        let scale = BigRational::from_integer(scale * by.denom());
        for (relation, q) in system.relations.iter().zip(cofactors).filter(|(_, q)| !q.terms.is_empty()) {
            terms.push(Cofactor {
                meaning: self.meaning(relation.source),
                relation: text(&relation.polynomial),
                cofactor: text(&scaled(q, &(&by * &scale))),
            });
        }
        let (conclusion, multiplier) = (text(&top), text(&scaled(multiplier, &scale)));
        let under = text(&integral(under));
        let program = self.program(system, equation, &names.list, cofactors)?;
        let not_zero = used.iter().map(|&e| self.raised(e)).collect();
        let variables: Vec<(String, String)> = names
            .list
            .into_iter()
            .zip(&system.variables)
            .zip(occurring)
            .filter(|(_, occurs)| *occurs)
            .map(|((name, &e), _)| (name, self.raised(e)))
            .collect();
        let Given { equations, solved, .. } = self.origin;
        let graph = &*self.graph;
        let (l, r) = equations.get(equation).copied().ok_or(NoCertificate::TooLarge)?;
        let formula = format!("{} = {}", shown(graph, l), shown(graph, r));
        let put_in = |leaf: Leaf| {
            let value = shown(graph, *solved.definitions.get(&leaf)?);
            Some(format!("{} = {value}", graph.leaf_latex(leaf)))
        };
        let definitions = graph.leaves([l, r]).into_iter().filter_map(put_in).collect();
        let divided_by = solved.pivots.iter().map(|&e| shown(graph, e)).collect();
        Ok(Certificate {
            equation,
            formula,
            definitions,
            divided_by,
            variables,
            multiplier,
            not_zero,
            conclusion,
            under,
            terms,
            program,
        })
    }

    /// The problem as the reader's program has it.
    fn program(
        &mut self,
        system: &System,
        equation: usize,
        variables: &[String],
        cofactors: &[Poly],
    ) -> Result<Program, NoCertificate> {
        let (origin, lowered) = (self.origin, self.lowered);
        let &(l, r) = origin.equations.get(equation).ok_or(NoCertificate::TooLarge)?;
        let used: Vec<&Relation> =
            system.relations.iter().zip(cofactors).filter(|(_, q)| !q.terms.is_empty()).map(|(r, _)| r).collect();
        let mut roots = vec![l, r];
        roots.extend(
            used.iter().filter(|r| matches!(r.source, Source::Premise(_))).flat_map(|r| [r.sides.0, r.sides.1]),
        );
        // What variables mean: a generator's function, or the root itself.
        let mut meanings = Vec::new();
        for &e in &system.variables {
            let meant = match *self.graph.node(e) {
                Node::Leaf(leaf) => match meaning(self.graph, &lowered.generators, leaf) {
                    None => continue,
                    Some(meant) => (meant.ok_or(NoCertificate::TooLarge)?, false),
                },
                _ => (e, true),
            };
            meanings.push((e, meant));
        }
        let graph = &*self.graph;
        let named = functions(graph, roots.iter().copied(), &origin.solved.definitions);
        let mut names: FastMap<Expr, String> =
            system.variables.iter().copied().zip(variables.iter().cloned()).collect();
        let mut list = variables.to_vec();
        let texts = roots.iter().copied().chain(meanings.iter().map(|&(_, (e, _))| e));
        let values = origin.solved.definitions.values().copied();
        for e in graph.reachable(texts.chain(values)) {
            let Node::Leaf(leaf) = *graph.node(e) else { continue };
            names.entry(e).or_insert_with(|| {
                let name = free(leaf_name(graph, leaf), &list);
                list.push(name.clone());
                name
            });
        }
        let none = FastMap::default();
        let mut claimed = Writer::new(graph, &names, &origin.solved.definitions, false, "e");
        let mut meant = Writer::new(graph, &names, &none, true, "f");
        let long = || NoCertificate::TooLarge;
        let sides = (claimed.write(l).ok_or_else(long)?, claimed.write(r).ok_or_else(long)?);
        let mut relations = Vec::new();
        for relation in used {
            let writer = if matches!(relation.source, Source::Premise(_)) { &mut claimed } else { &mut meant };
            let (a, b) = relation.sides;
            relations.push((writer.write(a).ok_or_else(long)?, writer.write(b).ok_or_else(long)?));
        }
        let mut calls = Vec::new();
        for f in named {
            let Some(&image) = origin.images.get(&f) else { continue };
            calls.push((claimed.write(f).ok_or_else(long)?, meant.write(image).ok_or_else(long)?));
        }
        let mut stand_for = Vec::new();
        for (variable, (e, is_root)) in meanings {
            let name = names.get(&variable).ok_or_else(long)?.clone();
            let text = match (is_root, graph.node(e)) {
                (true, Node::Unary(op, u)) => {
                    let inner = meant.write(*u).ok_or_else(long)?;
                    format!("{}({inner})", if *op == Op::Abs { "Abs" } else { "sqrt" })
                }
                _ => claimed.write(e).ok_or_else(long)?,
            };
            stand_for.push((name, text));
        }
        let definitions = claimed.definitions.into_iter().chain(meant.definitions).collect();
        Ok(Program { names: list, sides, definitions, functions: calls, variables: stand_for, relations })
    }

    /// Why a relation holds, in words and LaTeX.
    fn meaning(&self, source: Source) -> (Origin, String) {
        let premise = match source {
            Source::Meaning(words) => return (Origin::Variable, words.to_owned()),
            Source::Premise(at) => self.origin.solved.rest.get(at),
        };
        premise.map_or((Origin::Premise, String::new()), |p| {
            let origin = if p.derived { Origin::Rate } else { Origin::Premise };
            (origin, format!("{} = {}", shown(self.graph, p.left), shown(self.graph, p.right)))
        })
    }

    /// A lowered expression in the words of the formulas.
    fn raised(&mut self, e: Expr) -> String {
        let generators = &self.lowered.generators;
        let raised = self.graph.substitute(e, |graph, leaf| {
            Some(match *generators.get(leaf)? {
                Generator::Cosine(a) => graph.unary(Op::Cos, a),
                Generator::Sine(a) => graph.unary(Op::Sin, a),
                Generator::Exponential(a) => graph.unary(Op::Exp, a),
                Generator::Opaque(e) => e,
                Generator::Sign | Generator::Half | Generator::Free => return None,
            })
        });
        shown(self.graph, raised)
    }
}

/// The operation on quotients: over a common denominator where there is one, and nothing is cancelled.
fn combined(op: Op, a: &(Poly, Poly), b: &(Poly, Poly), most: usize) -> Result<(Poly, Poly), NoCertificate> {
    let times = |p: &Poly, q: &Poly| {
        let small = p.terms.len().saturating_mul(q.terms.len()) <= 8 * most;
        let product = if small { p * q } else { return Err(NoCertificate::TooLarge) };
        if product.terms.len() <= most { Ok(product) } else { Err(NoCertificate::TooLarge) }
    };
    Ok(match op {
        Op::Mul => (times(&a.0, &b.0)?, times(&a.1, &b.1)?),
        Op::Div => (times(&a.0, &b.1)?, times(&a.1, &b.0)?),
        Op::Add if a.1.terms == b.1.terms => (&a.0 + &b.0, a.1.clone()),
        Op::Sub if a.1.terms == b.1.terms => (&a.0 - &b.0, a.1.clone()),
        Op::Add => (&times(&a.0, &b.1)? + &times(&b.0, &a.1)?, times(&a.1, &b.1)?),
        Op::Sub => (&times(&a.0, &b.1)? - &times(&b.0, &a.1)?, times(&a.1, &b.1)?),
        _ => return Err(NoCertificate::TooLarge),
    })
}

impl System {
    /// What an expression is as a quotient: what the reader's program makes of its text.
    fn quotient(
        &mut self,
        graph: &Graph,
        origin: Given<'_>,
        place: Place,
        most: usize,
    ) -> Result<Quotient, NoCertificate> {
        let one = self.constant(&Rational::ONE);
        let mut stack = vec![place];
        while let Some(&at) = stack.last() {
            if self.quotients.contains_key(&at) {
                stack.pop();
                continue;
            }
            let (e, lowered) = at;
            let node = graph.node(e);
            let image = origin.images.get(&e).copied().filter(|_| !lowered).map(|image| (image, true));
            let waits: Vec<Place> = match (image, node) {
                (Some(image), _) => vec![image],
                (None, _) if self.place.contains_key(&e) => Vec::new(),
                (None, Node::Leaf(leaf)) => match origin.solved.definitions.get(leaf) {
                    Some(&value) if !lowered => vec![(value, false)],
                    _ => return Err(NoCertificate::TooLarge),
                },
                (None, node) => node.children().map(|c| (c, lowered)).collect(),
            };
            let open: Vec<Place> = waits.iter().copied().filter(|w| !self.quotients.contains_key(w)).collect();
            if !open.is_empty() {
                stack.extend(open);
                continue;
            }
            let value = match (waits.as_slice(), node) {
                ([one], _) if image.is_some() || matches!(node, Node::Leaf(_)) => Rc::clone(&self.quotients[one]),
                _ if self.place.contains_key(&e) => {
                    let p = Poly::monomial(Monomial::var(self.place[&e], self.variables.len()), MonomialOrder::GRevLex);
                    Rc::new((p, one.clone()))
                }
                (_, Node::Constant(r)) => {
                    let (top, under) = Rational::clone(r).into_parts();
                    Rc::new((self.constant(&Rational::from(top)), self.constant(&Rational::from(under))))
                }
                ([a], Node::Unary(Op::Neg, _)) => {
                    let a = &self.quotients[a];
                    Rc::new((&self.constant(&Rational::ZERO) - &a.0, a.1.clone()))
                }
                ([a], Node::Unary(Op::Powi(k), _)) if k.unsigned_abs() <= 64 => {
                    let a = Rc::clone(&self.quotients[a]);
                    let a = if *k < 0 { (a.1.clone(), a.0.clone()) } else { (a.0.clone(), a.1.clone()) };
                    let mut out = (one.clone(), one.clone());
                    for _ in 0..k.unsigned_abs() {
                        out = combined(Op::Mul, &out, &a, most)?;
                    }
                    Rc::new(out)
                }
                ([a, b], Node::Binary(op, ..)) => Rc::new(combined(*op, &self.quotients[a], &self.quotients[b], most)?),
                _ => return Err(NoCertificate::TooLarge),
            };
            if value.0.terms.len().max(value.1.terms.len()) > most {
                return Err(NoCertificate::TooLarge);
            }
            self.quotients.insert(at, value);
        }
        self.quotients.get(&place).cloned().ok_or(NoCertificate::TooLarge)
    }

    fn constant(&self, r: &Rational) -> Poly {
        Poly::constant(Coefficient::from(big(r)), self.variables.len(), MonomialOrder::GRevLex)
    }

    fn expand(&self, graph: &Graph, e: Expr, most_terms: usize) -> Result<Poly, NoCertificate> {
        let mut known: FastMap<Expr, Poly> = FastMap::default();
        let n = self.variables.len();
        let mut stack = vec![e];
        while let Some(&node) = stack.last() {
            if known.contains_key(&node) {
                stack.pop();
                continue;
            }
            if let Some(&i) = self.place.get(&node) {
                let p = Poly::monomial(Monomial::var(i, n), MonomialOrder::GRevLex);
                known.insert(node, p);
                continue;
            }
            let waiting: Vec<Expr> = graph.node(node).children().filter(|c| !known.contains_key(c)).collect();
            if !waiting.is_empty() {
                stack.extend(waiting);
                continue;
            }
            let small = |p: &Poly, q: &Poly| {
                if p.terms.len().saturating_mul(q.terms.len()) <= 8 * most_terms {
                    Ok(p * q)
                } else {
                    Err(NoCertificate::TooLarge)
                }
            };
            let value = match *graph.node(node) {
                Node::Constant(ref r) => self.constant(r),
                Node::Unary(Op::Neg, a) => &Poly::zero(n, MonomialOrder::GRevLex) - &known[&a],
                Node::Unary(Op::Powi(k), a) if (0..=64).contains(&k) => {
                    let mut out = self.constant(&Rational::ONE);
                    for _ in 0..k {
                        out = small(&out, &known[&a])?;
                    }
                    out
                }
                Node::Binary(Op::Add, a, b) => &known[&a] + &known[&b],
                Node::Binary(Op::Sub, a, b) => &known[&a] - &known[&b],
                Node::Binary(Op::Mul, a, b) => small(&known[&a], &known[&b])?,
                _ => return Err(NoCertificate::TooLarge),
            };
            if value.terms.len() > most_terms {
                return Err(NoCertificate::TooLarge);
            }
            known.insert(node, value);
        }
        known.remove(&e).ok_or(NoCertificate::TooLarge)
    }
}

/// What a variable satisfies by its meaning.
fn own_relation(graph: &mut Graph, lowered: &Lowered, e: Expr) -> Option<(Expr, Expr)> {
    // By itself: a square of a root would be taken apart at once.
    match *graph.node(e) {
        Node::Unary(Op::Sqrt, u) => Some((graph.unary(Op::Powi(2), e), u)),
        Node::Unary(Op::Abs, u) => Some((graph.unary(Op::Powi(2), e), graph.powi(u, 2))),
        Node::Leaf(leaf) => {
            let (c, s): (Leaf, Leaf) = lowered.generators.circle(leaf)?;
            if leaf != s {
                return None;
            }
            let c = graph.leaf(c);
            let (ss, cc) = (graph.powi(e, 2), graph.powi(c, 2));
            Some((graph.add(ss, cc), graph.integer(1)))
        }
        _ => None,
    }
}

/// Factors that are not 0 where the formulas have a value and the premises hold.
fn not_zero(graph: &Graph, lowered: &Lowered) -> Vec<Expr> {
    let mut out: Vec<Expr> = Vec::new();
    for &e in lowered.denominators.iter().chain(&lowered.assumed) {
        for (base, _) in factors(graph, e).1 {
            if !out.contains(&base) && graph.as_constant(base).is_none() {
                out.push(base);
            }
        }
    }
    out
}

/// Whether the leading terms are pairwise coprime: then the relations are a Gröbner basis (Buchberger's first criterion).
fn is_basis(relations: &[Poly]) -> bool {
    relations.iter().enumerate().all(|(i, p)| {
        relations[..i].iter().all(|q| match (p.lm(), q.lm()) {
            (Some(a), Some(b)) => a.is_coprime(b),
            _ => true,
        })
    })
}

fn big(r: &Rational) -> BigRational {
    if let Ok(n) = i64::try_from(r.clone()) {
        return BigRational::from_integer(BigInt::from(n));
    }
    let integer = |text: String| text.parse::<BigInt>().unwrap_or_default();
    BigRational::new(integer(r.numerator().to_string()), integer(r.denominator().to_string()))
}

fn map(p: &Poly, f: impl Fn(&BigRational) -> BigRational) -> Poly {
    let terms = p.terms.iter().map(|(m, c)| (m.clone(), Coefficient::from(f(&c.big())))).collect();
    Poly { terms, nvars: p.nvars, order: p.order.clone() }
}

/// The least common denominator of the coefficients.
fn denominators<'p>(polynomials: impl Iterator<Item = &'p Poly>) -> BigInt {
    let mut all = BigRational::one();
    for (_, c) in polynomials.flat_map(|p| &p.terms) {
        // lcm(a, b) = a·(b / gcd(a, b)): the denominator of b/a in lowest terms is a/gcd(a, b).
        let quotient = BigRational::new(c.big().denom().clone(), all.numer().clone());
        all = BigRational::from_integer(all.numer() * quotient.numer());
    }
    all.numer().clone()
}

/// The polynomial times its least common denominator.
fn integral(p: &Poly) -> Poly {
    let k = BigRational::from_integer(denominators(std::iter::once(p)));
    map(p, |c| c * &k)
}

/// k with p = k·q; 1 for 0.
fn ratio(p: &Poly, q: &Poly) -> BigRational {
    match (p.terms.first(), q.terms.first()) {
        (Some((_, a)), Some((_, b))) => a.big() / b.big(),
        _ => BigRational::one(),
    }
}

/// A polynomial with integer coefficients, as Python writes it.
fn python(p: &Poly, names: &[String]) -> String {
    let mut out = String::new();
    for (m, c) in &p.terms {
        let coefficient = c.big().numer().clone();
        let negative = coefficient < BigInt::zero();
        out.push_str(match (out.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        let size = if negative { -coefficient } else { coefficient };
        let mut parts = Vec::new();
        for (name, &k) in names.iter().zip(m.exps()).filter(|(_, k)| **k > 0) {
            parts.push(if k == 1 { name.clone() } else { format!("{name}**{k}") });
        }
        if !size.is_one() || parts.is_empty() {
            parts.insert(0, size.to_string());
        }
        out.push_str(&parts.join("*"));
    }
    if out.is_empty() { "0".to_owned() } else { out }
}

/// A formula in LaTeX, unless it is too long to be of use.
fn shown(graph: &Graph, e: Expr) -> String {
    // As a tree it may be far larger than as a graph.
    let mut sizes: FastMap<Expr, usize> = FastMap::default();
    for node in graph.reachable([e]) {
        let below = graph.node(node).children().map(|c| sizes.get(&c).copied().unwrap_or(0));
        let size = below.fold(1usize, usize::saturating_add);
        sizes.insert(node, size);
    }
    let operations = sizes.get(&e).copied().unwrap_or(0);
    let long = || format!("(an expression of {operations} operations)");
    if operations > LONGEST {
        return long();
    }
    let text = graph.to_latex(e);
    if text.chars().count() > LONGEST { long() } else { text.split_whitespace().collect::<Vec<_>>().join(" ") }
}

/// Names that Python accepts, one for each variable.
struct Names {
    list: Vec<String>,
}

/// Words that are no names in Python or in Lean, and names that the texts use.
const TAKEN: &[&str] = &[
    "False",
    "None",
    "True",
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "nonlocal",
    "not",
    "or",
    "pass",
    "raise",
    "return",
    "try",
    "while",
    "with",
    "yield",
    "print",
    "expand",
    "symbols",
    "d",
    "N",
    "D",
    "sqrt",
    "Abs",
    "sin",
    "cos",
    "tan",
    "exp",
    "log",
    "sinh",
    "cosh",
    "tanh",
    "asin",
    "acos",
    "atan",
    "atan2",
    "agm",
    "power",
    "pi",
    "at",
    "by",
    "do",
    "end",
    "fun",
    "have",
    "let",
    "match",
    "open",
    "show",
    "then",
    "where",
    "theorem",
    "def",
    "example",
    "axiom",
    "variable",
    "section",
    "namespace",
    "instance",
    "structure",
    "universe",
    "local",
    "macro",
    "mutual",
    "partial",
    "private",
    "protected",
    "unsafe",
    "notation",
    "prefix",
    "infix",
    "syntax",
    "calc",
    "suffices",
    "obtain",
    "key",
    "top",
    "same",
    "set_option",
    "deriving",
    "extends",
    "include",
    "omit",
    "attribute",
    "noncomputable",
    "opaque",
    "abbrev",
];

impl Names {
    fn new(graph: &Graph, lowered: &Lowered, variables: &[Expr]) -> Names {
        let mut list: Vec<String> = Vec::new();
        for &e in variables {
            let wish = match *graph.node(e) {
                Node::Leaf(leaf) => match lowered.generators.get(leaf) {
                    Some(Generator::Cosine(a)) => format!("cos{}", argument(graph, *a)),
                    Some(Generator::Sine(a)) => format!("sin{}", argument(graph, *a)),
                    Some(Generator::Exponential(a)) => format!("exp{}", argument(graph, *a)),
                    Some(_) => "f".to_owned(),
                    None => leaf_name(graph, leaf),
                },
                Node::Unary(Op::Sqrt, _) => "root".to_owned(),
                _ => "absolute".to_owned(),
            };
            let name = free(wish, &list);
            list.push(name);
        }
        Names { list }
    }
}

/// A name that is not taken, as near to this one as there is.
fn free(wish: String, list: &[String]) -> String {
    // A certificate's text has relations p1, p2 …, cofactors q1, q2 …, and parts of long texts e1, e2 …, f1, f2 …
    let numbered = |name: &str| {
        let rest = name.strip_prefix(['p', 'q', 'e', 'f', 'h']);
        rest.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    };
    let is_free = |name: &String| !list.contains(name) && !TAKEN.contains(&name.as_str()) && !numbered(name);
    match is_free(&wish) {
        true => wish,
        false => (2..).map(|n| format!("{wish}_{n}")).find(is_free).unwrap_or(wish),
    }
}

fn argument(graph: &Graph, e: Expr) -> String {
    match *graph.node(e) {
        Node::Leaf(leaf) => format!("_{}", leaf_name(graph, leaf)),
        _ => String::new(),
    }
}

/// The letters and digits of a leaf's LaTeX name, without the commands for its typeface.
fn leaf_name(graph: &Graph, leaf: Leaf) -> String {
    let mut text = graph.name(leaf.symbol).to_owned();
    for face in [r"\boldsymbol", r"\mathbf", r"\mathrm", r"\mathcal", r"\vec", r"\bf", r"\rm"] {
        text = text.replace(face, "");
    }
    let mut out: String = text.chars().filter(char::is_ascii_alphanumeric).collect();
    if !out.starts_with(|c: char| c.is_ascii_alphabetic()) {
        out.insert(0, 'x');
    }
    out.extend(graph.component_indices(leaf.symbol, leaf.component).iter().map(u16::to_string));
    out.push_str(match leaf.rate {
        0 => "",
        1 => "_dot",
        2 => "_ddot",
        _ => "_rate",
    });
    for coordinate in graph.coordinates().zip(leaf.partials.orders()).filter(|(_, n)| *n > 0) {
        let (by, n) = coordinate;
        out.push_str(&format!("_d{}{}", leaf_name(graph, by), if n > 1 { n.to_string() } else { String::new() }));
    }
    if leaf.instant.is_some() {
        out.push_str("_then");
    }
    out
}
