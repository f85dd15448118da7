//! What follows from what, and what became of each claim as a whole.

use super::{NodeKind, objects};
use crate::consequence::Consequences;
use crate::derivation::Derivation;
use crate::digest::{self, Fate, Whole};
use crate::front::Front;
use crate::graph::{self, DerivationGraph};
use findings::Account;

objects! {
    /// What follows from what.
    Graph of (derivation: &Derivation, account: &Account) let graph = DerivationGraph::new(derivation, account); {
        /// Claims, systems and symbols.
        nodes: Vec<Node> = graph.nodes.iter().enumerate().map(|(at, n)| Node::of(n, graph.rests(at))).collect(),
        /// The steps.
        edges: Vec<Edge> = graph.nodes.iter()
            .flat_map(|to| to.from.iter().map(|from| Edge::of(&graph.nodes[*from], to))).collect(),
    }

    /// A claim, a system, or a symbol whose definition is used.
    Node of (of: &graph::Node, rests: graph::Rests) {
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
        /// Everything that it rests on.
        rests_on: RestsOn = RestsOn::of(rests),
    }

    /// Everything that a node rests on, through all steps.
    RestsOn of (of: graph::Rests) {
        /// Ids.
        systems: Vec<String> = of.systems,
        /// Names.
        symbols: Vec<String> = of.symbols,
        /// Ids.
        claims: Vec<String> = of.claims,
        /// Assumptions of these claims that are not its own.
        assumptions: Vec<AssumptionOf> = of.assumptions.into_iter().map(AssumptionOf::of).collect(),
        /// Steps on the way that are not proved.
        not_proved: Vec<NotProved> = of.open.into_iter().map(NotProved::of).collect(),
        /// Whether it rests on itself.
        circular: bool = of.circular,
    }

    /// An assumption of another claim.
    AssumptionOf of (of: (String, String)) {
        /// As written.
        formula: String = of.0,
        /// The first claim that makes it.
        of: String = of.1,
    }

    /// A step that is not proved.
    NotProved of (of: (String, Option<&'static str>)) {
        /// Of a claim.
        id: String = of.0,
        /// Of its step.
        verdict: Option<&'static str> = of.1,
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
    let all = wholes.iter().map(|w| ClaimDigest::of(w, &front, hangs.carried_by(w.id, &wholes), hangs.conclusions_of(w.id))).collect(); {
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
    ClaimDigest of (of: &Whole<'_>, front: &Front, hanging: Vec<String>, concluded: Vec<&str>) {
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
        /// Claims that rest on it.
        carries: Vec<String> = hanging,
        /// Conclusions that rest on it.
        conclusions: Vec<String> = concluded.into_iter().map(str::to_owned).collect(),
    }
}
