//! What was asked before of one graph: different premises often come to one question once definitions are inserted.
//!
//! Only answers that rest on the lowered question alone are kept: that no order of solving settles it. Proofs and
//! refutations also say which definitions and which real points they rest on. Beside the answers, what expressions are by
//! their structure alone is computed once.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use super::generators::Generator;
use super::outcome::Reason;
use super::prove::Lowered;
use super::sign::Facts;
use super::structure::Structure;
use expr::Expr;

/// Questions of one graph that no order of solving settled.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    open: Vec<(Asked, Reason)>,
    /// Questions that the present one has led to so far.
    led_to: usize,
    /// How many nodes the graph had when the first question was asked.
    begun: usize,
    pub(super) structure: Rc<RefCell<Structure>>,
    /// So many points may still be looked at as formulas of numbers, for the present question and those that it leads to.
    pub(super) closings: Rc<Cell<u32>>,
}

/// Everything that decides what solving can do.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Asked {
    premises: Vec<(Expr, bool)>,
    claim: Vec<(Expr, Expr)>,
    assumed: Vec<Expr>,
    facts: Facts,
    generators: Vec<Generator>,
    most_nodes: usize,
    further: bool,
}

impl Asked {
    pub(super) fn new(lowered: &Lowered, most_nodes: usize, further: bool) -> Asked {
        Asked {
            premises: lowered.premises.clone(),
            claim: lowered.claim.clone(),
            assumed: lowered.assumed.clone(),
            facts: lowered.facts.clone(),
            generators: lowered.generators.list.clone(),
            most_nodes,
            further,
        }
    }
}

/// Most questions that one may lead to: each may lead to as many again, at each depth.
const MOST_QUESTIONS: usize = 160;

/// Most points that are looked at as formulas of numbers.
const MOST_CLOSINGS: u32 = 128;

/// Most nodes that all of them may make: as many as a few single questions are allowed.
const MOST_MADE: usize = 60_000;

impl Memory {
    /// Whether one more question may be asked, `depth` questions below the first one, with which counting begins; the graph has so
    /// many nodes now.
    pub(super) fn may_ask(&mut self, depth: u32, nodes: usize) -> bool {
        if depth == 0 {
            (self.led_to, self.begun) = (0, nodes);
            self.closings.set(MOST_CLOSINGS);
            return true;
        }
        self.led_to += 1;
        self.led_to <= MOST_QUESTIONS && nodes.saturating_sub(self.begun) <= MOST_MADE
    }

    pub(super) fn why_open(&self, asked: &Asked) -> Option<Reason> {
        self.open.iter().find(|(a, _)| a == asked).map(|(_, reason)| reason.clone())
    }

    /// Keeps an answer, if it is one for every point.
    pub(super) fn keep(&mut self, asked: Asked, reason: &Reason) {
        if reason.is_about_solving() {
            self.open.push((asked, reason.clone()));
        }
    }
}
