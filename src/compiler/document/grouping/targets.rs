//! Keys and exposed parameters of nodes that move into a group or out of it.

use crate::document::{Driver, Edit, GraphId, KeyDirection, Look, OutputPort, Target};
use crate::ids::{DefinitionId, NodeId, NodePath, PortName};

/// Step of a target's path that lies in `graph`, if one does.
pub(super) fn step_in(look: &Look, node: &NodePath, graph: &GraphId) -> Option<usize> {
    let mut here = GraphId::Look;
    for (step, id) in node.ids().iter().enumerate() {
        if here == *graph {
            return Some(step);
        }
        let kind = look.graph_of(&here)?.nodes.get(id)?.kind.as_str();
        here = GraphId::Definition(DefinitionId::from(kind));
    }
    None
}

/// Path of ids; `None` without ids.
pub(super) fn path_of(ids: &[NodeId]) -> Option<NodePath> {
    let (first, rest) = ids.split_first()?;
    Some(rest.iter().fold(NodePath::root(first.clone()), |path, id| path.join(id.clone())))
}

/// Edits that let all keys, exposed parameters and named outputs follow: `moved` gives the new
/// targets of a target, and `moved_output` the new output of a driver or a name; `None` leaves a
/// target or an output alone.
pub(super) fn follow(
    look: &Look,
    moved: impl Fn(&NodePath, &PortName) -> Option<Vec<Target>>,
    moved_output: impl Fn(&OutputPort) -> Option<OutputPort>,
) -> Vec<Edit> {
    let new = |target: &Target| match target {
        Target::Input { node, port } => moved(node, port).filter(|targets| !targets.is_empty()),
        Target::Light { .. } => None,
    };
    let mut edits = Vec::new();
    for (index, exposed) in look.exposed.iter().enumerate() {
        if let Some(target) = new(&exposed.target).and_then(|targets| targets.into_iter().next()) {
            let mut exposed = exposed.clone();
            exposed.target = target;
            edits.push(Edit::SetExposed { index, exposed });
        }
    }
    let mut aovs = look.aovs.clone();
    for aov in &mut aovs {
        aov.from = moved_output(&aov.from).unwrap_or_else(|| aov.from.clone());
    }
    if aovs != look.aovs {
        edits.push(Edit::SetAovs { aovs });
    }
    for (index, keys) in look.direction_keys.iter().enumerate() {
        let mut changed = keys.clone();
        if let KeyDirection::Drivers(drivers) = &mut changed.by {
            for driver in drivers {
                if let Some(output) = driver.output().and_then(&moved_output) {
                    *driver = Driver::Wire(output);
                }
            }
        }
        for key in &mut changed.keys {
            let values = std::mem::take(&mut key.values);
            for (target, value) in values {
                let targets = new(&target).unwrap_or_else(|| vec![target]);
                key.values.extend(targets.into_iter().map(|target| (target, value.clone())));
            }
        }
        if changed != *keys {
            edits.push(Edit::SetDirectionKeys { index, keys: changed });
        }
    }
    for (index, keys) in look.time_keys.iter().enumerate() {
        let Some(targets) = new(&keys.target) else { continue };
        let mut targets = targets.into_iter().map(|target| {
            let mut keys = keys.clone();
            keys.target = target;
            keys
        });
        edits.extend(targets.next().map(|keys| Edit::SetTimeKeys { index, keys }));
        edits.extend(targets.map(|keys| Edit::AddTimeKeys { keys, index: None }));
    }
    edits
}
