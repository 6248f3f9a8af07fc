//! Commands of the bar of unsaved work and changed files.

/// Command about unsaved work, or about a file that changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RecoveryCommand {
    /// Takes back the offer of this number.
    TakeBack(usize),
    /// Marks the offer of this number to be thrown away when the window closes, or not.
    Throw(usize, bool),
    /// Takes the look's file as another program left it.
    Reload,
    /// Lets saving write over the other program's version.
    KeepMine,
    /// Takes the scene's file as another program left it.
    ReloadScene,
    /// Lets saving the scene write over the other program's version.
    KeepMyScene,
    /// Takes the painting's file as another program left it.
    ReloadPainting,
    /// Lets saving the painting write over the other program's version.
    KeepMyPainting,
    /// Dismisses the note.
    Hide,
    /// Dismisses the note of a file that could not be opened.
    HideUnopened,
    /// Asks for another file than the one that could not be opened.
    OpenAnother,
    /// Reads a file although the last program ended over it.
    ReadAgain,
    /// Compiles and draws the open document although the last program ended over it.
    TryAgain,
}
