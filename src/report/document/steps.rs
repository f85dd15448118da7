//! What follows from what, and what became of each claim as a whole.

use super::value::{NodeKind, is_false, objects};
use crate::consequence::{Concluded, Consequences};
use crate::digest::{self, Fate, Whole};
use crate::front::Front;
use crate::graph::{self, DerivationGraph, Kind};
use derivation::Derivation;
use findings::Account;

objects! {
    /// What follows from what.
    Graph of (derivation: &Derivation, account: &Account) let graph = DerivationGraph::new(derivation, account); {
        /// Claims, systems and symbols.
        nodes: Vec<Node> = graph.nodes.iter().enumerate().map(|(at, n)| Node::of(n, RestsOn::of(&graph, at))).collect(),
        /// The steps.
        edges: Vec<Edge> = graph.nodes.iter()
            .flat_map(|to| to.from.iter().map(|from| Edge::of(&graph.nodes[*from], to))).collect(),
    }

    /// A claim, a system, or a symbol whose definition is used.
    Node of (of: &graph::Node, rests: RestsOn) {
        /// Id or name.
        id: String = of.id.clone(),
        /// What it is.
        kind: NodeKind = NodeKind(of.kind.word()),
        /// Of its step.
        verdict: Option<&'static str> = of.verdict,
        /// What the proof amounts to, with all that it rests on.
        standing: Option<&'static str> = of.proof.word(),
        /// Its own.
        assumptions: Vec<String> = of.assumptions.clone(),
        /// What it rests on directly.
        rests_on: RestsOn = rests,
    }

    /// What a node rests on directly. What these rest on stands beside them: all together, through all steps, is found by going on.
    RestsOn of (graph: &DerivationGraph, at: usize) {
        /// Ids.
        systems: Vec<String> = graph.direct(at, Kind::System),
        /// Names.
        symbols: Vec<String> = graph.direct(at, Kind::Symbol),
        /// Ids.
        claims: Vec<String> = graph.direct(at, Kind::Claim),
    }

    /// A step.
    Edge of (given: &graph::Node, follows: &graph::Node) {
        /// What is given.
        from: String = given.id.clone(),
        /// What it is.
        kind: NodeKind = NodeKind(given.kind.word()),
        /// What follows.
        to: String = follows.id.clone(),
        /// Of the step.
        verdict: Option<&'static str> = follows.verdict,
    }

    /// What became of each claim as a whole, and what hangs on it.
    Digest of (derivation: &Derivation, account: &Account)
    let front = Front::new(derivation, account);
    let wholes = digest::wholes(derivation, account);
    let hangs = Consequences::new(derivation);
    let concluded = hangs.concluded();
    let all = wholes.iter().map(|w| ClaimDigest::of(w, &front, hangs.directly_on(w.id), concluded.get(w.id))).collect(); {
        /// In one sentence.
        verdict: String = front.verdict,
        /// With what strength claims stand.
        strength: Option<String> = front.strength,
        /// What is not counted.
        beside: Option<String> = front.beside,
        /// What a reader must not overlook.
        alarms: Vec<String> = front.alarms,
        /// The claims, each with all its readings.
        claims: Vec<ClaimDigest> = all,
        /// Ids of what does not stand, the heaviest first.
        against: Vec<String> = front.lines.into_iter().map(|l| l.id).collect(),
    }

    /// A claim with all its readings.
    ClaimDigest of (of: &Whole<'_>, front: &Front, hanging: Vec<&str>, concluded: Option<&Concluded<'_>>) {
        /// Its id.
        id: String = of.id.to_owned(),
        /// In the file's words.
        says: String = of.says.clone(),
        /// Where it stands in the paper.
        place: Option<String> = of.place.map(str::to_owned),
        /// Whether the paper concludes it.
        conclusion: bool = of.conclusion,
        /// What became of it.
        #[schemars(extend("enum" = Fate::ALL.map(Fate::key)))]
        fate: &'static str = of.fate.key(),
        /// With what strength it stands.
        stands: Option<String> = of.basis().filter(|_| of.fate == Fate::Stands).map(|b| b.words()),
        /// Whether all that it says is proved for all values.
        proved: bool = of.is_proved(),
        /// Why it does not stand.
        reason: Option<String> = front.lines.iter().find(|l| l.id == of.id).map(|l| l.reason.clone()),
        /// Claims that rest on it directly: those that rest on them in turn are beside them.
        carries: Vec<String> = hanging.into_iter().map(str::to_owned).collect(),
        /// Conclusions that rest on it, through all steps: the first of them.
        conclusions: Vec<String> = concluded.iter().flat_map(|c| &c.told).map(|id| (*id).to_owned()).collect(),
        /// There, and true, if more conclusions rest on it than are told.
        #[serde(skip_serializing_if = "is_false")]
        more_conclusions: bool = concluded.is_some_and(Concluded::has_more),
    }
}
