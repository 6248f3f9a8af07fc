//! Commands about the graph on the canvas.

use eframe::egui;

/// Command about the open graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum GraphCommand {
    AddNode,
    Swap,
    Delete,
    Dissolve,
    Duplicate,
    Copy,
    Cut,
    Paste,
    SelectAll,
    SelectNone,
    Invert,
    Upstream,
    Downstream,
    Rename,
    /// Gives an output a name as a pass (AOV).
    NamePass,
    Mute,
    Collapse,
    Connect,
    Group,
    Ungroup,
    OpenGroup,
    LeaveGroup,
    ShareGroup,
    Frame,
    Unframe,
    Note,
    ShowAll,
    ShowSelected,
    AlignLeft,
    AlignRight,
    AlignTop,
    AlignBottom,
    DistributeAcross,
    DistributeDown,
    Layout,
    SnapGrid,
    Minimap,
    /// Shows or hides what nodes cost.
    Costs,
    /// Moves the selected nodes.
    Nudge(Heading),
    SelectNext(Heading),
    /// Goes to a bookmark.
    GoTo(u8),
    /// Bookmarks the view.
    Remember(u8),
}

/// Direction of an arrow key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Heading {
    Left,
    Right,
    Up,
    Down,
}

impl Heading {
    /// Unit step in this direction, y downward.
    pub(crate) fn step(self) -> egui::Vec2 {
        match self {
            Self::Left => egui::vec2(-1.0, 0.0),
            Self::Right => egui::vec2(1.0, 0.0),
            Self::Up => egui::vec2(0.0, -1.0),
            Self::Down => egui::vec2(0.0, 1.0),
        }
    }
}
