//! What the bar of unsaved work and changed files asks for.

/// Something that is asked for of work that is not saved, or of a file that changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RecoveryCommand {
    /// Opens what is offered under this number.
    TakeBack(usize),
    /// Throws it away when the window closes, or does not.
    Throw(usize, bool),
    /// Takes the file as another program left it.
    Reload,
    /// Lets saving write over it.
    KeepMine,
    /// Takes the scene's file as another program left it.
    ReloadScene,
    /// Lets saving the scene write over it.
    KeepMyScene,
    /// Takes what is painted as another program left its file.
    ReloadPainting,
    /// Lets saving what is painted write over it.
    KeepMyPainting,
    /// The note was read.
    Hide,
    /// The note of a file that could not be opened was read.
    HideUnopened,
    /// Asks for another file in its place.
    OpenAnother,
    /// Reads the file all the same over which the last program ended.
    ReadAgain,
    /// Compiles and draws what is open all the same, over which the last program ended.
    TryAgain,
}
