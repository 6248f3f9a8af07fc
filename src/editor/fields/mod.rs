//! Rows that each change one value of a document, with their marks: keys, drivers, exposed
//! parameters.

pub(crate) mod bands;
pub(crate) mod constant_wires;
pub(crate) mod edge;
pub(crate) mod filter;
pub(crate) mod keyed;
pub(crate) mod layer;
pub(crate) mod lighting;
pub(crate) mod mark;
pub(crate) mod marks;
pub(crate) mod mix;
pub(crate) mod names;
pub(crate) mod node_links;
pub(crate) mod passes;
pub(crate) mod path;
pub(crate) mod row;
pub(crate) mod scene_names;
pub(crate) mod shot;
pub(crate) mod wedge;
pub(crate) mod wire_value;

use crate::catalog::NodeKind;
use crate::document::Node;
use crate::ids::NodeId;
use crate::state::session::Session;

/// Node whose values are shown, with its kind.
pub(crate) struct InspectedNode<'a> {
    pub(crate) session: &'a Session,
    pub(crate) id: &'a NodeId,
    pub(crate) node: &'a Node,
    pub(crate) kind: &'a NodeKind,
}
