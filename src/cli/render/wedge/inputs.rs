//! Inputs of nodes that vary, within groups too: found by the paths of their nodes.

use indexmap::IndexSet;

use super::target::Place;
use crate::diag::Diagnostic;
use crate::document::{Endpoint, Look, Node, Target};
use crate::frame::Setup;
use crate::ids::{GROUP_INPUTS, NodePath, PortName};
use crate::library::Library;

/// An input of a node, of all looks that have the node.
pub(super) fn inputs(
    setup: &Setup,
    library: &Library,
    node: &str,
    port: &str,
) -> Result<Vec<Place>, Diagnostic> {
    let (path, port) = (NodePath::parse(node), PortName::from(port));
    let mut places = Vec::new();
    for (look, worn) in setup.looks.iter().enumerate() {
        let found = library.node_of(&worn.look, path.ids());
        let Some((graph, found)) = found else { continue };
        if !ports(&worn.look, library, found).contains(&port) {
            continue;
        }
        let wire = path.last().and_then(|id| graph.wire_into(id, &port));
        if let Some(wire) = wire {
            let message = format!("`{node}.{port}` is wired, and has no value to vary");
            let from = source(&path, &wire.from);
            let hint = format!("vary what feeds it, `{from}`, or take the wire out");
            return Err(Diagnostic::error("wired-target", message).hint(hint));
        }
        if let Some(name) = covering(setup, look, &path, &port) {
            let message = format!("`{name}`, which the objects set, stands over `{node}.{port}`");
            let problem = Diagnostic::error("covered-target", message);
            return Err(problem.hint(format!("vary `{name}`")));
        }
        places.push(Place::Input { look, node: path.clone(), port: port.clone() });
    }
    Ok(places)
}

/// The exposed parameter of an input that all objects with the look set.
fn covering<'s>(
    setup: &'s Setup,
    look: usize,
    path: &NodePath,
    port: &PortName,
) -> Option<&'s PortName> {
    let target = Target::Input { node: path.clone(), port: port.clone() };
    let exposed = setup.looks[look].look.exposed.iter().find(|it| it.target == target)?;
    let wearers =
        setup.objects.iter().filter(|object| object.worn_looks().any(|worn| worn == look));
    let mut wearers = wearers.peekable();
    wearers.peek()?;
    wearers.all(|object| object.values.contains_key(&exposed.name)).then_some(&exposed.name)
}

/// Name of the end of a wire into a node: of a group's input as it is called outside.
fn source(path: &NodePath, from: &Endpoint) -> String {
    match path.parent() {
        Some(group) if from.node.as_str() == GROUP_INPUTS => format!("{group}.{}", from.port),
        Some(group) => format!("{group}/{from}"),
        None => from.to_string(),
    }
}

/// The inputs of a node.
fn ports(look: &Look, library: &Library, node: &Node) -> Vec<PortName> {
    let mut names: IndexSet<PortName> = node.values.keys().cloned().collect();
    if let Some(found) = library.nodes.get(&node.kind) {
        names.extend(found.inputs.iter().map(|input| input.name.clone()));
    } else if let Some(found) = library.groups.get(&node.kind) {
        names.extend(found.ports(library).inputs.into_iter().map(|input| input.name));
    }
    let own = look.definitions.get(node.kind.as_str());
    names.extend(own.iter().flat_map(|own| own.inputs.iter().map(|port| port.name.clone())));
    names.into_iter().collect()
}
