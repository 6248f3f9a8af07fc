//! Numbers that tell a thing as it is from the same thing as it was, each of a type of its own.

macro_rules! revisions {
    ($($(#[$doc:meta])* $name:ident;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub(crate) struct $name(pub(super) u64);

            impl $name {
                /// Another one from now on.
                pub(crate) fn advance(&mut self) {
                    self.0 += 1;
                }
            }
        )*
    };
}

revisions! {
    /// The look that is open: another one has another number, and its revisions begin anew.
    DocumentNumber;
    /// The look as far as nodes give anything: it stays while nodes are only moved about.
    MeaningRevision;
    /// The picture, as far as documents decide it.
    PictureRevision;
    /// Everything that is wrong.
    ProblemsRevision;
    /// The solo, as far as it needs another shader.
    SoloRevision;
    /// The look that is shown in place of the open one.
    PreviewRevision;
    /// The files that the look uses.
    FilesRevision;
    /// The graph that is open, of those of the look.
    GraphNumber;
}

/// The look as an edit left it, by how many there were.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LookRevision(pub(super) u64);
