//! Nodes that lights can be kept from: those that name a light or run for several, and filters.

use crate::catalog::{NodeKind, Port};
use crate::document::Node;
use crate::library::Type;

/// True if lights reach a node, which can be said for it alone.
pub(crate) fn is_lit(kind: &NodeKind, node: &Node) -> bool {
    let names_light = kind.inputs.iter().any(|port| port.ty == Type::LightName);
    names_light || node.for_each.is_some() || !node.links.layered_link().is_all()
}

/// True if a node filters lights, which can be said for each light.
pub(crate) fn is_filter(kind: &NodeKind, node: &Node) -> bool {
    let is_both =
        |is_it: fn(&Port) -> bool| kind.inputs.iter().any(is_it) && kind.outputs.iter().any(is_it);
    is_both(|port| port.ty == Type::Light)
        || is_both(|port| port.name.as_str() == "share")
        || !node.links.filtered_link().is_all()
}
