//! What a check compiles before it builds motions.
//!
//! **In:** what is chosen of a file. **Out:** a [`Compiled`]: the claims, what may be asked beside them, the measures, and all leaves that
//! points of motions must have values of. **Guaranteed:** the file is not changed; expressions that are made here are in a graph of
//! their own, which begins as that of the file, and grows in the same order in every run.

use super::picture;
use super::run::Run;
use claim::error::CheckError;
use claim::program::Program;
use derivation::{Claim, Derivation};
use expr::{Leaf, Rational};
use sampled::claim_program::Prepared;
use sampled::independence::Gradients;
use sampled::measure;
use sampled::same_motion;
use sampled::selection::Selection;
use sampled::stage::{Requests, Stage};
use sampled::systems::Fields;
use weight::separation::Probes;
use weight::variant::Altered;

/// What is compiled of a file.
pub(super) struct Compiled<'a> {
    /// The file, with the graph of all that was compiled.
    pub derivation: Derivation,
    pub fields: Fields,
    /// The claims, by initial time: the value "at the start" is part of what a first integral says.
    pub prepared: Vec<Vec<Prepared<'a>>>,
    /// What they will be asked on the same motions is known before these are built.
    pub probes: Probes,
    pub measures: Vec<measure::Compiled>,
    /// Leaves that pictures need; none where nothing is drawn.
    pub pictures: Vec<Leaf>,
    /// All leaves that points must have values of, increasing.
    pub wanted: Vec<Leaf>,
}

impl<'a> Compiled<'a> {
    /// Makes the expressions. `derivation` is the file, with the graph in which its systems were solved.
    pub fn new(run: &Run<'a>, selection: &Selection, mut derivation: Derivation, fields: Fields) -> Compiled<'a> {
        let (file, graph) = (run.file, &mut derivation.graph);
        let mut prepared: Vec<Vec<Prepared>> = Vec::new();
        for &c in &selection.claims {
            let claim = &file.claims[c];
            let starts = selection.starts.iter().zip(&selection.shared);
            let program =
                |(s, shared): (&Rational, &Vec<_>)| Program::new(graph, file.into(), claim, s).sharing(shared);
            let programs: Vec<Program> = starts.map(program).collect();
            let gradients = Gradients::of_claim(graph, &file.trajectories, claim, &fields);
            let one = |program| Prepared { claim, program, gradients: gradients.clone() };
            prepared.push(programs.into_iter().map(one).collect());
        }
        let probes = if run.separating { Probes::new(file, graph, selection) } else { Probes::default() };
        let whole = run.options.claims.is_empty();
        let measures = if whole { measure::compile(graph, file) } else { Vec::new() };
        let pictures = if whole && !run.options.plain { picture::leaves(file) } else { Vec::new() };
        Compiled { derivation, fields, prepared, probes, measures, pictures, wanted: Vec::new() }
    }

    /// Collects the leaves that points must have values of, and makes everything ready for such points, with the altered formulas.
    ///
    /// # Errors
    /// A leaf that is needed was not asked for: a defect of this program.
    pub fn finish(&mut self, run: &Run, selection: &Selection, altered: Option<&Altered>) -> Result<(), CheckError> {
        let Compiled { derivation, prepared, probes, .. } = &*self;
        let (starts, sign) = (selection.starts.len(), derivation.scope.branch_sign());
        let graph = &derivation.graph;
        let mut wanted: Vec<Leaf> = prepared.iter().flatten().flat_map(|p| p.leaves(graph)).collect();
        wanted.extend(probes.programs().flat_map(|p| p.leaves(graph)));
        wanted.extend(self.measures.iter().flat_map(|m| m.leaves(graph)));
        wanted.extend(same_motion::leaves(derivation));
        wanted.extend(altered.iter().flat_map(|a| a.leaves(derivation, starts, sign)));
        wanted.extend(&self.pictures);
        wanted.sort_unstable();
        wanted.dedup();
        run.recall.asks(derivation, &selection.claims, |k| {
            let of_claim = prepared[k].iter().flat_map(|p| p.leaves(graph));
            let without = probes.without(k).flat_map(|p| p.leaves(graph));
            let altered = altered.iter().flat_map(|a| a.leaves_of(k, starts));
            of_claim.chain(without).chain(altered).collect()
        });
        let graph = &mut self.derivation.graph;
        let programs = self.prepared.iter_mut().flatten().map(|p| &mut p.program);
        for program in programs.chain(self.probes.programs_mut()) {
            if let Err(leaf) = program.compile(graph, &wanted) {
                let name = graph.leaf_latex(leaf);
                return Err(CheckError::Defect(format!("{name} is needed by a claim, but was not asked for")));
            }
        }
        self.measures = std::mem::take(&mut self.measures).into_iter().map(|m| m.on(graph, &wanted)).collect();
        self.wanted = wanted;
        Ok(())
    }

    /// Builds the motions, for everything that will be asked of them.
    ///
    /// # Errors
    /// Trajectories that cannot be built.
    pub fn build(&self, run: &Run, selection: &Selection) -> Result<Stage, CheckError> {
        let own = selection.claims.iter().zip(&self.prepared);
        let own = own.map(|(&c, of)| (&self.derivation.claims[c], of.iter().map(|p| &p.program).collect()));
        let beside = self.probes.asked().map(|(claim, programs)| (claim, programs.iter().collect()));
        let (claims, programs): (Vec<&Claim>, Vec<Vec<&Program>>) = own.chain(beside).unzip();
        let requests = Requests {
            idle: &[],
            pattern: None,
            part: !run.options.claims.is_empty(),
            wanted: &self.wanted,
            tried: &selection.tried,
            claims: &claims,
            programs: &programs,
            start_of: &selection.start_of,
            measured: &|derivation, t| measure::searched(&self.measures, derivation, t),
            limits: &run.options.limits,
        };
        Stage::build(&self.derivation, &self.fields, &requests, &run.recall)
    }
}
