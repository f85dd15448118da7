//! Which claim rests on which: the graph of a derivation, as data, as a drawing and in words.
//!
//! **In:** the derivation, and the verdicts on its steps. **Out:** nodes (claims, systems, symbols) and edges (this follows from
//! that); for every claim, everything that it rests on, through all steps, with the assumptions that flow into it.
//!
//! Nothing is decided here: an edge has the verdict of the step that it belongs to, `identity` of the claim at its end. A chain
//! is worth no more than its weakest step, so the steps that are not proved are named.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};

use super::tally::name;
use crate::check::{Account, ClaimAccount, IdentityAccount};
use crate::derivation::Derivation;

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Claim,
    System,
    Symbol,
}

impl Kind {
    fn word(self) -> &'static str {
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
    /// The assumptions of the claim itself.
    assumptions: Vec<String>,
    /// What it follows from directly: positions of nodes.
    from: Vec<usize>,
}

/// Everything that a claim rests on.
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
    /// It rests on itself: a circle proves nothing.
    pub circular: bool,
}

/// The graph.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DerivationGraph {
    nodes: Vec<Node>,
}

/// More edges than this are not drawn: nobody could read it.
const MOST_EDGES: usize = 300;

impl DerivationGraph {
    /// The graph of a derivation, with the verdicts of an account.
    pub fn new(derivation: &Derivation, account: &Account) -> DerivationGraph {
        let mut graph = DerivationGraph { nodes: Vec::new() };
        // All claims of the file: those that were not checked may be given to those that were.
        let verdicts: BTreeMap<String, &IdentityAccount> =
            account.claims.iter().filter_map(|c| Some((name(c), c.identity.as_ref()?))).collect();
        for claim in &derivation.claims {
            let id = claim.name();
            graph.nodes.push(Node {
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
        DerivationGraph { nodes }
    }

    /// The node that a name in `follows-from` means: a system, a claim (of several readings the first), or a symbol.
    fn premise(&mut self, derivation: &Derivation, text: &str) -> usize {
        if derivation.systems.iter().any(|s| s.id == text) {
            return self.leaf(Kind::System, text);
        }
        let claim = derivation.claims.iter().position(|c| c.name() == text || c.id == text);
        claim.unwrap_or_else(|| self.leaf(Kind::Symbol, text))
    }

    fn leaf(&mut self, kind: Kind, id: &str) -> usize {
        let known = self.nodes.iter().position(|n| n.kind == kind && n.id == id);
        known.unwrap_or_else(|| {
            self.nodes.push(Node { id: id.to_owned(), kind, verdict: None, assumptions: Vec::new(), from: Vec::new() });
            self.nodes.len() - 1
        })
    }

    /// What the node at this position rests on, nearest first.
    fn rests(&self, at: usize) -> Rests {
        let mut out = Rests::default();
        let mut reached: Vec<usize> = Vec::new();
        let mut seen = vec![false; self.nodes.len()];
        let mut next = 0;
        let mut open = self.nodes[at].from.clone();
        while next < open.len() {
            let one = open[next];
            next += 1;
            if one == at {
                out.circular = true;
            } else if !std::mem::replace(&mut seen[one], true) {
                reached.push(one);
                open.extend(&self.nodes[one].from);
            }
        }
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
        let id = name(claim);
        let at = self.nodes.iter().position(|n| n.kind == Kind::Claim && n.id == id)?;
        (!self.nodes[at].from.is_empty()).then(|| self.rests(at))
    }

    /// `graph` of `report.json`.
    pub fn json(&self) -> Value {
        let nodes = self.nodes.iter().enumerate().map(|(at, node)| {
            let rests = self.rests(at);
            json!({
                "id": node.id,
                "kind": node.kind.word(),
                "verdict": node.verdict,
                "assumptions": node.assumptions,
                "rests_on": {
                    "systems": rests.systems,
                    "symbols": rests.symbols,
                    "claims": rests.claims,
                    "assumptions": rests.assumptions.iter().map(|(text, from)| json!({ "formula": text, "of": from }))
                        .collect::<Vec<_>>(),
                    "not_proved": rests.open.iter().map(|(id, verdict)| json!({ "id": id, "verdict": verdict }))
                        .collect::<Vec<_>>(),
                    "circular": rests.circular,
                },
            })
        });
        let edges = self.nodes.iter().flat_map(|node| {
            node.from.iter().map(|&from| {
                json!({ "from": self.nodes[from].id, "kind": self.nodes[from].kind.word(), "to": node.id, "verdict": node.verdict })
            })
        });
        json!({ "nodes": nodes.collect::<Vec<_>>(), "edges": edges.collect::<Vec<_>>() })
    }

    /// The section of `report.md`: a drawing in Mermaid, which forges render.
    pub fn section(&self) -> String {
        let edges: usize = self.nodes.iter().map(|n| n.from.len()).sum();
        if edges == 0 {
            return String::new();
        }
        let mut out = String::from(
            "## What follows from what\n\n\
             An arrow leads from what is given to what is said to follow from it. The box says whether it does, for all values: \
             round when it is proved, six-sided when a point refutes it, with a notch when it is undecided, square when it is \
             not a question of that kind. Systems are slanted; definitions of symbols have double sides. An arrow to a step \
             that is not proved is dotted.\n\n",
        );
        if edges > MOST_EDGES {
            out.push_str(&format!(
                "There are {edges} arrows, too many for a drawing: see `graph` in `report.json`.\n\n"
            ));
            return out;
        }
        out.push_str("```mermaid\nflowchart TD\n");
        for (at, node) in self.nodes.iter().enumerate() {
            let id = label(&node.id);
            let shape = match (node.kind, node.verdict) {
                (Kind::System, _) => format!("[/\"{id}\"/]"),
                (Kind::Symbol, _) => format!("[[\"{id}\"]]"),
                (Kind::Claim, Some("proved")) => format!("([\"{id}<br>proved\"])"),
                (Kind::Claim, Some("refuted")) => format!("{{{{\"{id}<br>refuted\"}}}}"),
                (Kind::Claim, Some(verdict)) => format!(">\"{id}<br>{verdict}\"]"),
                (Kind::Claim, None) => format!("[\"{id}\"]"),
            };
            out.push_str(&format!("  n{at}{shape}\n"));
        }
        for (to, node) in self.nodes.iter().enumerate() {
            let arrow = if node.verdict == Some("proved") { "-->" } else { "-.->" };
            for from in &node.from {
                out.push_str(&format!("  n{from} {arrow} n{to}\n"));
            }
        }
        out.push_str("```\n\n");
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

/// What a claim rests on, in one paragraph of `report.md`; `math` writes a formula.
pub(super) fn rests_in_words(rests: &Rests, math: impl Fn(&str) -> String) -> String {
    let code = |ids: &[String]| ids.iter().map(|id| format!("`{id}`")).collect::<Vec<_>>().join(", ");
    let mut parts = Vec::new();
    if !rests.systems.is_empty() {
        let word = if rests.systems.len() == 1 { "the system" } else { "the systems" };
        parts.push(format!("{word} {}", code(&rests.systems)));
    }
    if !rests.symbols.is_empty() {
        let names: Vec<String> = rests.symbols.iter().map(|s| math(s)).collect();
        parts.push(format!("the definition of {}", names.join(", ")));
    }
    if !rests.claims.is_empty() {
        parts.push(code(&rests.claims));
    }
    let mut out = format!("Rests on: {}.", parts.join("; "));
    if !rests.assumptions.is_empty() {
        let all: Vec<String> =
            rests.assumptions.iter().map(|(text, from)| format!("{} (of `{from}`)", math(text))).collect();
        out.push_str(&format!(" With it come the assumptions {}.", all.join(", ")));
    }
    if !rests.open.is_empty() {
        let all: Vec<String> =
            rests.open.iter().map(|(id, verdict)| format!("`{id}` ({})", unproved(*verdict))).collect();
        out.push_str(&format!(" Taken as given on the way, for it is not proved: {}.", all.join(", ")));
    }
    if rests.circular {
        out.push_str(" **It rests on itself: a circle proves nothing.**");
    }
    out.push_str("\n\n");
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn node(id: &str, verdict: Option<&'static str>, assumptions: &[&str], from: &[usize]) -> Node {
        let kind = if id == "S" { Kind::System } else { Kind::Claim };
        let assumptions = assumptions.iter().map(|&a| a.to_owned()).collect();
        Node { id: id.to_owned(), kind, verdict, assumptions, from: from.to_vec() }
    }

    fn chain() -> DerivationGraph {
        let nodes = vec![
            node("S", None, &[], &[]),
            node("a", Some("proved"), &["x>0"], &[0]),
            node("b", Some("refuted"), &["y>0", "x>0"], &[1]),
            node("c", Some("proved"), &["y>0"], &[2, 1]),
        ];
        DerivationGraph { nodes }
    }

    #[test]
    fn assumptions_flow_through_all_steps() {
        let rests = chain().rests(3);
        assert_eq!(rests.systems, ["S"]);
        assert_eq!(rests.claims, ["b", "a"]);
        assert_eq!(rests.assumptions, [("x>0".to_owned(), "b".to_owned())]);
        assert_eq!(rests.open, [("b".to_owned(), Some("refuted"))]);
        assert!(!rests.circular);
        let words = rests_in_words(&rests, |f| format!("${f}$"));
        assert_eq!(
            words,
            "Rests on: the system `S`; `b`, `a`. With it come the assumptions $x>0$ (of `b`). \
             Taken as given on the way, for it is not proved: `b` (not so for all values).\n\n"
        );
    }

    #[test]
    fn a_circle_is_named() {
        let mut graph = chain();
        graph.nodes[1].from = vec![3];
        assert!(graph.rests(3).circular && graph.rests(1).circular && graph.rests(2).circular);
        assert!(rests_in_words(&graph.rests(1), str::to_owned).contains("rests on itself"));
        assert!(!graph.rests(0).circular);
    }

    #[test]
    fn the_drawing() {
        insta::assert_snapshot!(chain().section());
        assert_eq!(label("I_{(n-k)}\"]"), "I_#123;#40;n-k#41;#125;#34;#93;");
    }
}
