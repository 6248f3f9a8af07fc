//! Numbers that tell one state of a value from an earlier one, each of a type of its own.

macro_rules! revisions {
    ($($(#[$doc:meta])* $name:ident;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub(crate) struct $name(pub(super) u64);

            impl $name {
                /// Moves on to a number that was never used before.
                pub(crate) fn advance(&mut self) {
                    self.0 += 1;
                }
            }
        )*
    };
}

revisions! {
    /// Number of the open look: another look has another number, and its revisions begin anew.
    DocumentNumber;
    /// Revision of the look as far as its nodes mean anything: unchanged while nodes are only moved
    /// about.
    MeaningRevision;
    /// Revision of the picture, as far as documents decide it.
    PictureRevision;
    /// Revision of the list of problems.
    ProblemsRevision;
    /// Revision of the solo, as far as it needs another shader.
    SoloRevision;
    /// Revision of the look that is shown in place of the open one.
    PreviewRevision;
    /// Revision of the files that the look uses.
    FilesRevision;
    /// Number of the open graph, of those of the look.
    GraphNumber;
}

/// Revision of the look: the number of edits so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LookRevision(pub(super) u64);
