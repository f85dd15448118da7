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

use super::budget::within;
use super::certificate::{Certificate, Cofactor, Effort, NoCertificate, Origin, Program};
use super::generators::Generator;
use super::linear::Combinations;
use super::names::{free, leaf_name, names_of, python};
use super::notation::{Writer, functions, meaning};
use super::outcome::{Premises, Reason};
use super::polynomial::{factors, fraction};
use super::prepare::{Premise, explicit, with_rates};
use super::prove::{Lowered, MOST_FURTHER, lower, vanishes};
use super::rates::mark_partial;
use super::ring::{Given, Poly, Relation, Source, System, combined, denominators, integral, is_basis, map, ratio};
use super::solve::insert_definitions;
use ::groebner::{LiftBasis, PolynomialExt, verify_lift};
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational};
use num_rational::BigRational;

/// Most characters of a formula that is shown in a certificate.
const LONGEST: usize = 400;

/// See [`certify`](super::certify). Where further derivatives of what is given may say more, they are taken as long as there is no
/// certificate, and nothing is convicted.
pub(super) fn certify(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    effort: Effort,
) -> Result<Vec<Certificate>, NoCertificate> {
    let mut found = certify_after(graph, equations, given, effort, 0);
    for further in 1..=MOST_FURTHER {
        match found {
            (Err(NoCertificate::NotMember { equation } | NoCertificate::Refuted { equation }), true) => {
                found = certify_after(graph, equations, given, effort, further);
                if matches!(found.0, Err(NoCertificate::Refuted { .. })) {
                    found.0 = Err(NoCertificate::NotMember { equation });
                }
            }
            _ => break,
        }
    }
    found.0
}

/// Certificates with further derivatives, and whether still more of them may say more.
fn certify_after(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    effort: Effort,
    further: u8,
) -> (Result<Vec<Certificate>, NoCertificate>, bool) {
    match with_rates(graph, given, equations, vanishes, further) {
        Ok((mut premises, solutions)) => {
            // A certificate holds wherever the formulas have values: rates that may have none are left out.
            let whole = mark_partial(graph, equations, &mut premises, given).is_empty();
            premises.retain(|p| !p.partial);
            let may_say_more = solutions.may_hide_constraints();
            let found = match certify_from(graph, equations, given, &premises, effort) {
                // What is left out may say more.
                Err(NoCertificate::Refuted { equation }) if !whole => Err(NoCertificate::NotMember { equation }),
                found => found,
            };
            (found, may_say_more)
        }
        Err(reason) => (Err(NoCertificate::NotPolynomial(reason)), false),
    }
}

/// Certificates by premises and the derivatives of these.
fn certify_from(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    premises: &[Premise],
    effort: Effort,
) -> Result<Vec<Certificate>, NoCertificate> {
    let wrong = NoCertificate::NotPolynomial;
    let solved = explicit(graph, premises, equations, given);
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
        let own: Vec<(Origin, (Expr, Expr))> =
            system.variables.iter().filter_map(|&e| own_relation(self.graph, lowered, e)).collect();
        for (origin, sides) in own {
            self.relate(&mut system, sides, true, Source::Variable(origin))?;
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
        let names = names_of(self.graph, self.lowered, &system.variables);
        let mut terms = Vec::new();
        let mut occurring = vec![false; names.len()];
        let mut text = |p: &Poly| {
            for (m, _) in &p.terms {
                for (seen, &k) in occurring.iter_mut().zip(m.exps()) {
                    *seen |= k > 0;
                }
            }
            python(p, &names)
        };
        // d·(by·N) = Σ (by·q)·p, everything times the common denominator.
        let scale = BigRational::from_integer(scale * by.denom());
        for (relation, q) in system.relations.iter().zip(cofactors).filter(|(_, q)| !q.terms.is_empty()) {
            terms.push(Cofactor {
                origin: self.origin_of(&relation.source),
                relation: text(&relation.polynomial),
                cofactor: text(&scaled(q, &(&by * &scale))),
            });
        }
        let (conclusion, multiplier) = (text(&top), text(&scaled(multiplier, &scale)));
        let under = text(&integral(under));
        let program = self.program(system, equation, &names, cofactors)?;
        let not_zero = used.iter().map(|&e| self.raised(e)).collect();
        let variables: Vec<(String, String)> = names
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

    /// Where a relation comes from.
    fn origin_of(&self, source: &Source) -> Origin {
        let premise = match source {
            Source::Variable(origin) => return origin.clone(),
            Source::Premise(at) => self.origin.solved.rest.get(*at),
        };
        premise.map_or(Origin::Premise(String::new()), |p| {
            let formula = format!("{} = {}", shown(self.graph, p.left), shown(self.graph, p.right));
            if p.derived { Origin::Rate(formula) } else { Origin::Premise(formula) }
        })
    }

    /// A lowered expression in the words of the formulas.
    fn raised(&mut self, e: Expr) -> String {
        let generators = &self.lowered.generators;
        let raised = self.graph.replaced(e, |graph, leaf| {
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

/// What a variable satisfies by its meaning.
fn own_relation(graph: &mut Graph, lowered: &Lowered, e: Expr) -> Option<(Origin, (Expr, Expr))> {
    // By itself: a square of a root would be taken apart at once.
    match *graph.node(e) {
        Node::Unary(Op::Sqrt, u) => Some((Origin::Root, (graph.unary(Op::Powi(2), e), u))),
        Node::Unary(Op::Abs, u) => Some((Origin::AbsoluteValue, (graph.unary(Op::Powi(2), e), graph.powi(u, 2)))),
        Node::Leaf(leaf) => {
            let (c, s): (Leaf, Leaf) = lowered.generators.circle(leaf)?;
            if leaf != s {
                return None;
            }
            let c = graph.leaf(c);
            let (ss, cc) = (graph.powi(e, 2), graph.powi(c, 2));
            Some((Origin::Circle, (graph.add(ss, cc), graph.integer(1))))
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
