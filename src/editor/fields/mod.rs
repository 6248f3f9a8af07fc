//! Rows that change one value of a document each, with what they are marked by: keys, drivers,
//! what is exposed.

pub(crate) mod keyed;
pub(crate) mod lighting;
pub(crate) mod mark;
pub(crate) mod marks;
pub(crate) mod row;
pub(crate) mod still_wires;

use crate::catalog::Kind;
use crate::document::Node;
use crate::ids::NodeId;
use crate::state::session::Session;

/// The node whose values are shown, with its kind.
pub(crate) struct Subject<'a> {
    pub(crate) session: &'a Session,
    pub(crate) id: &'a NodeId,
    pub(crate) node: &'a Node,
    pub(crate) kind: &'a Kind,
}
