//! Marks on nodes: errors and warnings with their fixes, and the reasons why nodes have no effect.

use std::collections::HashMap;

use chiaro_locale::{Text, text, tr};

use crate::compile::{Proof, Removal};
use crate::diag::Severity;
use crate::ids::NodeId;
use crate::state::fixes::{self, Fix};
use crate::state::problem_text::{labelled, sentence};
use crate::state::session::Session;

/// Problem of a node, as marked on the node.
pub(super) struct Mark {
    pub(super) severity: Severity,
    pub(super) text: String,
    pub(super) fixes: Vec<Fix>,
}

/// Reason why a node adds nothing to the result.
pub(super) struct IdleReason {
    /// Reason in one or two words, shown on the node.
    pub(super) word: Text,
    /// Finding of the compiler; `None` where no wire leads to the output.
    why: Option<String>,
}

impl IdleReason {
    /// Reason in a sentence.
    pub(super) fn text(&self) -> String {
        match &self.why {
            Some(why) => tr!("Adds nothing: {why}."),
            None => tr!("Nothing that reaches the output uses it.").to_owned(),
        }
    }
}

/// Worst problem of each node of the open graph, with the texts of all its problems.
pub(super) fn marks(session: &Session) -> HashMap<NodeId, Mark> {
    let mut marks: HashMap<NodeId, Mark> = HashMap::new();
    for problem in session.all_problems().filter(|problem| problem.severity > Severity::Note) {
        let Some(path) = &problem.place.node else { continue };
        let Some(id) = session.graph_view().step_of(path) else { continue };
        let text = labelled(session.look_with_library(), problem, &sentence(problem));
        let fixes = if path.last() == Some(id) { fixes::of(session, problem) } else { Vec::new() };
        match marks.get_mut(id) {
            // A group that is used several times reports the same problem for each use.
            Some(mark) if mark.text.contains(&text) => {}
            Some(mark) => {
                mark.severity = mark.severity.max(problem.severity);
                mark.text += "\n";
                mark.text += &text;
                mark.fixes.extend(fixes);
            }
            None => {
                drop(marks.insert(id.clone(), Mark { severity: problem.severity, text, fixes }));
            }
        }
    }
    marks
}

/// Nodes of the open graph that the compiler found to add nothing, with the reasons.
pub(super) fn idle(session: &Session) -> HashMap<NodeId, IdleReason> {
    let mut found = HashMap::new();
    let Some(shader) = session.compilation().baked().filter(|_| session.view.wire.is_none()) else {
        return found;
    };
    let here = session.selection.open_groups();
    let mut by_step: HashMap<&NodeId, Vec<&Removal>> = HashMap::new();
    for removal in shader.removed.iter().filter(|removal| removal.path.ids().starts_with(here)) {
        if let Some(id) = removal.path.ids().get(here.len()) {
            by_step.entry(id).or_default().push(removal);
        }
    }
    // A group is idle only where no node within it is left in the shader.
    let mut is_left: std::collections::HashSet<&NodeId> = std::collections::HashSet::new();
    for path in shader.spans.nodes().filter(|path| path.ids().starts_with(here)) {
        is_left.extend(path.ids().get(here.len()));
    }
    for (id, removals) in by_step {
        let own = removals.iter().find(|removal| removal.path.ids().len() == here.len() + 1);
        let inner =
            || removals.iter().find(|removal| word(removal).is_some_and(|word| word != UNUSED));
        let removal = match own {
            Some(own) => Some(own),
            None if is_left.contains(id) => None,
            None => inner(),
        };
        if let Some(removal) = removal
            && let Some(word) = word(removal)
        {
            found.insert(id.clone(), IdleReason { word, why: Some(removal.reason.clone()) });
        }
    }
    // Nodes that drive keys are evaluated before the shader runs, and so count as used.
    for driving in session.graph_view().driving_nodes() {
        found.remove(&driving);
    }
    found
}

const UNUSED: Text = text!("unused");
const NO_EFFECT: Text = text!("no effect");

/// Short word for a proof, shown on a node; `None` where the node still gives its value.
fn word(removal: &Removal) -> Option<Text> {
    match removal.proof {
        Proof::Unreachable => Some(UNUSED),
        Proof::ZeroWeight | Proof::NoEffect => Some(NO_EFFECT),
        // Bounds also prove that a value is the same everywhere; the node then still gives that
        // value.
        Proof::Ranges if !removal.still_gives => Some(NO_EFFECT),
        _ => None,
    }
}

/// Reason of a node from which no wire leads to the output.
pub(super) static UNWIRED: IdleReason = IdleReason { word: UNUSED, why: None };
