//! Which claim rests on which: the graph of a derivation, as data, as a drawing and in words.
//!
//! **In:** the derivation, and the verdicts on its steps. **Out:** nodes (claims, systems, symbols) and edges (this follows from
//! that); for a claim, the nearest of what it rests on, through all steps, with the assumptions that flow into it.
//!
//! Nothing is decided here: an edge has the verdict of the step that it belongs to, `identity` of the claim at its end. A chain
//! is worth no more than its weakest step, so the steps that are not proved are named.

use std::collections::{BTreeMap, BTreeSet};

use super::story::{StoryBlock, section, words};
use super::tally::name;
use derivation::{Derivation, Premise};
use findings::standing::Decision;
use findings::{Account, ClaimAccount, IdentityAccount};

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    Claim,
    System,
    Symbol,
}

impl Kind {
    pub fn word(self) -> &'static str {
        match self {
            Kind::Claim => "claim",
            Kind::System => "system",
            Kind::Symbol => "symbol",
        }
    }
}

/// A claim, a system, or a symbol whose definition is used.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub id: String,
    pub kind: Kind,
    /// The verdict of the step that leads to the claim; `None` where it is no step.
    pub verdict: Option<&'static str>,
    /// What the proof of that step amounts to.
    pub proof: ProofStanding,
    /// The assumptions of the claim itself.
    pub assumptions: Vec<String>,
    /// What it follows from directly: positions of nodes.
    pub from: Vec<usize>,
}

/// What the proof of a claim amounts to, with everything that it rests on: the one place that says `proved`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum ProofStanding {
    /// For all values; everything that it rests on is proved, or postulated.
    Proved,
    /// Special cases of what is given are left out.
    Except,
    /// The step is proved, these claims on the way are not.
    Given(Vec<String>),
    /// The prover alone says so.
    Unreplayed,
    /// It rests on itself.
    Circular,
    /// It is not proved, or no question of that kind.
    None,
}

impl ProofStanding {
    /// What the proof of the claim `id` amounts to; what it is conditional on was seen when it was made.
    fn of(identity: &IdentityAccount, id: &str) -> ProofStanding {
        let open: Vec<String> = identity.conditional_on.iter().map(|g| g.name.clone()).collect();
        match identity.finding.decision() {
            _ if identity.finding.is_proved_in_part() && open.iter().any(|g| g == id) => ProofStanding::Circular,
            Decision::Proved if open.is_empty() => ProofStanding::Proved,
            Decision::ProvedExcept if open.is_empty() => ProofStanding::Except,
            Decision::Unreplayed if open.is_empty() => ProofStanding::Unreplayed,
            Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed => ProofStanding::Given(open),
            Decision::Refuted | Decision::Undecided => ProofStanding::None,
        }
    }

    /// In a word or two.
    pub fn word(&self) -> Option<&'static str> {
        match self {
            ProofStanding::Proved => Some("proved"),
            ProofStanding::Except => Some("proved, special cases apart"),
            ProofStanding::Given(_) => Some("proved, given claims that are not"),
            ProofStanding::Unreplayed => Some("proved by the prover, not replayed"),
            ProofStanding::Circular => Some("circular"),
            ProofStanding::None => None,
        }
    }
}

/// What is known of a step for all values, in one sentence: `proved` alone is said of what rests on nothing unproved.
pub(super) fn sentence(identity: &IdentityAccount, proof: &ProofStanding) -> String {
    let sentence = identity.decided().to_string();
    match proof {
        ProofStanding::Proved | ProofStanding::Unreplayed | ProofStanding::None => sentence,
        ProofStanding::Except => format!("Special cases of what is given apart. {sentence}"),
        ProofStanding::Circular => format!("It rests on itself, which proves nothing. The step: {sentence}"),
        ProofStanding::Given(open) => {
            let ids: Vec<String> = open.iter().map(|id| format!("“{id}”")).collect();
            format!("On condition of {}, not proved for all values. The step: {sentence}", ids.join(", "))
        }
    }
}

/// The same in a few words.
pub(super) fn brief(identity: &IdentityAccount, proof: &ProofStanding) -> String {
    let random = identity.log2_error.filter(|_| identity.evidence.trials.is_some());
    let error = random.map(|e| format!(", error below 2^{}", e.ceil())).unwrap_or_default();
    let from = if identity.from.is_empty() { String::new() } else { format!(", from {}", identity.from.join(", ")) };
    let (verdict, reason) = (identity.verdict(), identity.reason.as_ref().map(ToString::to_string).unwrap_or_default());
    match proof {
        ProofStanding::Proved => format!("proved{from}{error}."),
        ProofStanding::Except => format!("proved{from}, special cases of what is given apart{error}."),
        ProofStanding::Unreplayed => format!("proved by the prover, not replayed{from}{error}."),
        ProofStanding::Given(open) => format!("proved, given {}{from}{error}.", open.join(", ")),
        ProofStanding::Circular => "it rests on itself, which proves nothing.".to_owned(),
        ProofStanding::None if verdict == "refuted" => format!("not so{from}: a point refutes it."),
        ProofStanding::None => format!("{verdict}{from}: {reason}."),
    }
}

/// What a claim rests on, through all steps: the nearest of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Rests {
    pub systems: Vec<String>,
    pub symbols: Vec<String>,
    /// Claims from which it follows, directly or through others.
    pub claims: Vec<String>,
    /// Assumptions of these claims that are not its own, each with the first claim that makes it.
    pub assumptions: Vec<(String, String)>,
    /// Steps on the way that are not proved, each with its verdict; claims that are not decided for all values have none.
    pub open: Vec<(String, Option<&'static str>)>,
    /// It rests on more than these.
    pub more: bool,
}

/// The graph.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DerivationGraph {
    pub nodes: Vec<Node>,
    /// Where claims, systems and symbols are.
    places: BTreeMap<(Kind, String), usize>,
}

/// Of what a claim rests on through all steps, so much is told: along a chain, all of it would be half the square of its length.
const MOST_TOLD: usize = 32;

/// What the drawing shows.
const ARROWS: &str = "An arrow leads from what is given to what is said to follow from it; it is dotted where the step is not proved. \
                      Boxes: round, proved for all values; with round corners, proved but for something on the way; six-sided, no \
                      identity; with a notch, undecided; square, no such question; slanted, a system; with double sides, a definition.";

/// More edges than this are not drawn: nobody could read it.
const MOST_EDGES: usize = 300;

/// So many nodes are seen at one glance.
const SMALL: usize = 24;

impl DerivationGraph {
    /// The graph of a derivation, with the verdicts of an account.
    pub fn new(derivation: &Derivation, account: &Account) -> DerivationGraph {
        let mut graph = DerivationGraph { nodes: Vec::new(), places: BTreeMap::new() };
        // All claims of the file: those that were not checked may be given to those that were.
        let verdicts: BTreeMap<String, &IdentityAccount> =
            account.claims.iter().filter_map(|c| Some((name(c), c.identity.as_ref()?))).collect();
        for claim in &derivation.claims {
            let id = claim.name();
            graph.nodes.push(Node {
                proof: verdicts.get(&id).map_or(ProofStanding::None, |i| ProofStanding::of(i, &id)),
                verdict: verdicts.get(&id).map(|i| i.verdict()),
                id,
                kind: Kind::Claim,
                assumptions: claim.assuming.iter().map(|w| w.text.clone()).collect(),
                from: Vec::new(),
            });
        }
        for (at, claim) in derivation.claims.iter().enumerate() {
            let names = match verdicts.get(&graph.nodes[at].id) {
                Some(identity) if claim.follows_from.is_empty() => &identity.from,
                _ => &claim.follows_from,
            };
            for text in names {
                let from = graph.premise(derivation, text);
                if !graph.nodes[at].from.contains(&from) {
                    graph.nodes[at].from.push(from);
                }
            }
        }
        let used: BTreeSet<usize> = graph.nodes.iter().flat_map(|n| n.from.iter().copied()).collect();
        // What neither rests on anything nor is rested on is no part of a derivation.
        let keep: Vec<usize> =
            (0..graph.nodes.len()).filter(|i| used.contains(i) || !graph.nodes[*i].from.is_empty()).collect();
        let place = |i: &usize| keep.binary_search(i).ok();
        let nodes = keep
            .iter()
            .map(|&i| Node { from: graph.nodes[i].from.iter().filter_map(place).collect(), ..graph.nodes[i].clone() })
            .collect();
        DerivationGraph::of(nodes)
    }

    fn of(nodes: Vec<Node>) -> DerivationGraph {
        let places = nodes.iter().enumerate().map(|(at, n)| ((n.kind, n.id.clone()), at)).collect();
        DerivationGraph { nodes, places }
    }

    /// The node that a name in `follows-from` means: a system, a claim (of several readings the first), or a symbol.
    fn premise(&mut self, derivation: &Derivation, text: &str) -> usize {
        match derivation.premise(text) {
            Premise::System(_) => self.leaf(Kind::System, text),
            Premise::Claim(at) => at,
            Premise::Definition => self.leaf(Kind::Symbol, text),
        }
    }

    fn leaf(&mut self, kind: Kind, id: &str) -> usize {
        let at = *self.places.entry((kind, id.to_owned())).or_insert(self.nodes.len());
        if at == self.nodes.len() {
            let (verdict, proof, id) = (None, ProofStanding::None, id.to_owned());
            self.nodes.push(Node { id, kind, verdict, proof, assumptions: Vec::new(), from: Vec::new() });
        }
        at
    }

    /// What the node at this position rests on directly, of one kind.
    pub fn direct(&self, at: usize, kind: Kind) -> Vec<String> {
        let from = self.nodes[at].from.iter().map(|&from| &self.nodes[from]);
        from.filter(|n| n.kind == kind).map(|n| n.id.clone()).collect()
    }

    /// What the node at this position rests on, nearest first. No claim of a derivation rests on itself.
    fn rests(&self, at: usize) -> Rests {
        let mut out = Rests::default();
        let mut reached = self.nodes[at].from.clone();
        let mut seen: BTreeSet<usize> = reached.iter().copied().collect();
        let mut next = 0;
        while let Some(&one) = reached.get(next).filter(|_| reached.len() <= MOST_TOLD) {
            next += 1;
            reached.extend(self.nodes[one].from.iter().filter(|from| seen.insert(**from)));
        }
        out.more = reached.len() > MOST_TOLD;
        reached.truncate(MOST_TOLD);
        let own = &self.nodes[at].assumptions;
        for node in reached.iter().map(|&i| &self.nodes[i]) {
            match node.kind {
                Kind::System => out.systems.push(node.id.clone()),
                Kind::Symbol => out.symbols.push(node.id.clone()),
                Kind::Claim => {
                    out.claims.push(node.id.clone());
                    if node.verdict != Some("proved") {
                        out.open.push((node.id.clone(), node.verdict));
                    }
                    for text in &node.assumptions {
                        if !own.contains(text) && !out.assumptions.iter().any(|(t, _)| t == text) {
                            out.assumptions.push((text.clone(), node.id.clone()));
                        }
                    }
                }
            }
        }
        out
    }

    /// What a claim rests on; `None` where it rests on nothing that is named.
    pub fn rests_of(&self, claim: &ClaimAccount) -> Option<Rests> {
        let at = *self.places.get(&(Kind::Claim, name(claim)))?;
        (!self.nodes[at].from.is_empty()).then(|| self.rests(at))
    }

    /// What the proof of a claim amounts to.
    pub fn proof_of(&self, claim: &ClaimAccount) -> ProofStanding {
        claim.identity.as_ref().map_or(ProofStanding::None, |i| ProofStanding::of(i, &name(claim)))
    }

    /// Which nodes a drawing of many has: what is said straight of a system, is not proved and leads on to nothing, is no part of a chain.
    fn drawn(&self) -> Vec<bool> {
        let used: BTreeSet<usize> = self.nodes.iter().flat_map(|n| n.from.iter().copied()).collect();
        let on_systems = |n: &Node| n.from.iter().all(|&from| self.nodes[from].kind == Kind::System);
        let alone = |n: &Node| n.kind == Kind::Claim && n.verdict != Some("proved") && on_systems(n);
        let is_small = self.nodes.len() <= SMALL;
        self.nodes.iter().enumerate().map(|(at, n)| is_small || used.contains(&at) || !alone(n)).collect()
    }

    /// The section of `report.md`: a drawing in Mermaid, which forges render.
    pub fn section<'a>(&self) -> Option<StoryBlock<'a>> {
        let edges: usize = self.nodes.iter().map(|n| n.from.len()).sum();
        let says = |text: String| StoryBlock::Paragraph(vec![words(text)]);
        let mut blocks = vec![says(ARROWS.to_owned())];
        if edges > MOST_EDGES {
            blocks.push(says(format!("There are {edges} arrows, too many for a drawing: see graph in report.json.")));
        } else {
            let left_out = self.drawn().iter().filter(|drawn| !**drawn).count();
            blocks.extend((left_out > 0).then(|| {
                says(format!("Not drawn: {left_out} more, said straight of a system, which are not proved and lead on to nothing."))
            }));
            blocks.push(StoryBlock::Lines(self.mermaid(), "mermaid"));
        }
        (edges > 0).then(|| section("/graph", "What follows from what", blocks))
    }

    /// The drawing in Mermaid.
    fn mermaid(&self) -> String {
        let is_drawn = self.drawn();
        let mut out = "flowchart TD\n".to_owned();
        for (at, node) in self.nodes.iter().enumerate().filter(|(at, _)| is_drawn[*at]) {
            let id = label(&node.id);
            let shape = match (node.kind, node.verdict) {
                (Kind::System, _) => format!("[/\"{id}\"/]"),
                (Kind::Symbol, _) => format!("[[\"{id}\"]]"),
                (Kind::Claim, Some("proved")) => match &node.proof {
                    ProofStanding::Given(_) => format!("(\"{id}\")"),
                    ProofStanding::Proved | ProofStanding::None => format!("([\"{id}\"])"),
                    proof => format!("(\"{id}<br>{}\")", proof.word().unwrap_or("proved")),
                },
                (Kind::Claim, Some("refuted")) => format!("{{{{\"{id}\"}}}}"),
                (Kind::Claim, Some("undecided")) => format!(">\"{id}\"]"),
                (Kind::Claim, Some(verdict)) => format!(">\"{id}<br>{verdict}\"]"),
                (Kind::Claim, None) => format!("[\"{id}\"]"),
            };
            out.push_str(&format!("  n{at}{shape}\n"));
        }
        // What follows from the same is drawn by one line.
        let mut arrows: BTreeMap<(String, &str), Vec<String>> = BTreeMap::new();
        for (to, node) in self.nodes.iter().enumerate().filter(|(to, n)| is_drawn[*to] && !n.from.is_empty()) {
            let arrow = if node.verdict == Some("proved") { "-->" } else { "-.->" };
            let from: Vec<String> = node.from.iter().map(|from| format!("n{from}")).collect();
            arrows.entry((from.join(" & "), arrow)).or_default().push(format!("n{to}"));
        }
        for ((from, arrow), to) in arrows {
            out.push_str(&format!("  {from} {arrow} {}\n", to.join(" & ")));
        }
        out
    }
}

/// Text for a label of Mermaid: what might be markup becomes the number of its character.
fn label(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            c if c.is_ascii_alphanumeric() || "-_./ ".contains(c) => out.push(c),
            c => out.push_str(&format!("#{};", u32::from(c))),
        }
    }
    out
}

/// What is known for all values of a premise that is not proved.
pub(super) fn unproved(verdict: Option<&str>) -> &str {
    match verdict {
        Some("refuted") => "not so for all values",
        Some(verdict) => verdict,
        None => "not a question for all values",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn node(id: &str, verdict: Option<&'static str>, assumptions: &[&str], from: &[usize]) -> Node {
        let kind = if id == "S" { Kind::System } else { Kind::Claim };
        let assumptions = assumptions.iter().map(|&a| a.to_owned()).collect();
        let proof = ProofStanding::None;
        Node { id: id.to_owned(), kind, verdict, proof, assumptions, from: from.to_vec() }
    }

    fn chain() -> DerivationGraph {
        let nodes = vec![
            node("S", None, &[], &[]),
            node("a", Some("proved"), &["x>0"], &[0]),
            node("b", Some("refuted"), &["y>0", "x>0"], &[1]),
            node("c", Some("proved"), &["y>0"], &[2, 1]),
        ];
        DerivationGraph::of(nodes)
    }

    #[test]
    fn assumptions_flow_through_all_steps() {
        let rests = chain().rests(3);
        assert_eq!(rests.systems, ["S"]);
        assert_eq!(rests.claims, ["b", "a"]);
        assert_eq!(rests.assumptions, [("x>0".to_owned(), "b".to_owned())]);
        assert_eq!(rests.open, [("b".to_owned(), Some("refuted"))]);
        assert!(!rests.more);
        assert_eq!(chain().direct(3, Kind::Claim), ["b", "a"]);
        assert!(chain().direct(3, Kind::System).is_empty());
    }

    #[test]
    fn of_a_long_chain_the_nearest_is_told() {
        let step = |n: usize| {
            let from: Vec<usize> = n.checked_sub(1).into_iter().collect();
            node(&format!("c{n}"), Some("proved"), &[], &from)
        };
        let chain = DerivationGraph::of((0..100).map(step).collect());
        let nearest: Vec<String> = (0..MOST_TOLD).map(|k| format!("c{}", 98 - k)).collect();
        assert_eq!(chain.rests(99).claims, nearest);
        assert!(chain.rests(99).more && chain.rests(MOST_TOLD + 1).more);
        assert!(!chain.rests(MOST_TOLD).more && chain.rests(MOST_TOLD).claims.len() == MOST_TOLD);
    }

    fn section(graph: &DerivationGraph) -> String {
        let blocks: Vec<StoryBlock<'_>> = graph.section().into_iter().collect();
        super::super::story::markdown(&blocks, &|name, _| name.to_owned())
    }

    #[test]
    fn what_is_in_no_chain_is_not_drawn() {
        let mut nodes = chain().nodes;
        nodes.push(node("end", Some("undecided"), &[], &[3]));
        nodes.push(node("alone", Some("refuted"), &[], &[0]));
        assert!(section(&DerivationGraph::of(nodes.clone())).contains("alone"), "a small drawing is whole");
        nodes.extend((0..SMALL).map(|n| node(&format!("more{n}"), Some("proved"), &[], &[1])));
        let drawing = section(&DerivationGraph::of(nodes));
        assert!(!drawing.contains("alone") && drawing.contains("Not drawn: 1 more,"), "{drawing}");
        assert!(drawing.contains("end") && drawing.contains("more0"), "{drawing}");
    }

    #[test]
    fn the_drawing() {
        insta::assert_snapshot!(section(&chain()));
        assert_eq!(label("I_{(n-k)}\"]"), "I_#123;#40;n-k#41;#125;#34;#93;");
    }
}
