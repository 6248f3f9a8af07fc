//! Numbers that tell one state of a value from an earlier one, each of a type of its own.

use crate::document::DocumentRevision;

macro_rules! numbers {
    ($($(#[$doc:meta])* $name:ident;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub(crate) struct $name(pub(super) u64);
        )*
    };
}

macro_rules! counters {
    ($($(#[$doc:meta])* $name:ident;)*) => {
        numbers! { $($(#[$doc])* $name;)* }

        $(
            impl $name {
                /// Moves on to a number that was never used before, and returns it.
                pub(crate) fn advance(&mut self) -> Self {
                    self.0 += 1;
                    *self
                }
            }
        )*
    };
}

numbers! {
    /// Revision of the HCBTF that is being painted, as far as shaders see it.
    PaintingRevision;
    /// Number of the HCBTF that is being painted: another one has another number.
    PaintingNumber;
}

counters! {
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
    /// Time of a step: a count of all steps that were done in any open document.
    StepTime;
    /// Number of a gesture, of those of a document.
    GestureNumber;
    /// Number of a message to the thread that writes a journal.
    MessageNumber;
    /// Number of a request to a thread; only the answer to the newest request counts.
    RequestNumber;
    /// Revision of the list of documents over which the program ended.
    SuspectsRevision;
}

impl RequestNumber {
    /// Number of requests so far.
    pub(crate) fn count(self) -> u64 {
        self.0
    }
}

impl StepTime {
    /// Time of the next step.
    pub(crate) fn next(self) -> Self {
        Self(self.0 + 1)
    }
}

/// Revision of the look: the number of edits so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LookRevision(pub(super) DocumentRevision);

/// Identity of a gesture: a widget, for as long as it is held or has the keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GestureId(pub u64);
