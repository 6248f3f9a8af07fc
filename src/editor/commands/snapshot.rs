//! Commands about the snapshots of the look.

use crate::state::shelf::SnapshotId;

/// Command about the snapshots of the open look.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SnapshotCommand {
    /// Takes a snapshot of the look as it is.
    Take,
    /// Makes the look what it was in the snapshot.
    Restore(SnapshotId),
    Rename(SnapshotId, String),
    Delete(SnapshotId),
    /// Begins a new look with what the snapshot holds.
    Copy(SnapshotId),
}
