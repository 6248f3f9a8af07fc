//! Commands about masks that are painted on the mesh.

use crate::ids::NodeId;
use crate::state::masks::MaskStep;

/// Command about a painted mask.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum MaskCommand {
    /// Gives a layer a mask that hides it, beside the look's file, and begins to paint that.
    New(NodeId),
    /// Begins to paint a layer's mask.
    Paint(NodeId),
    /// Keeps what a stroke made of a mask, as a step.
    Keep(MaskStep),
    /// Says so where no mesh of the look has vertex colors.
    CheckColors,
    /// Ends painting.
    Leave,
}
