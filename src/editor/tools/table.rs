//! Definition of a tool of the picture: a row with its name, its switch, and its overlay of the
//! picture.

use eframe::egui::{Pos2, Rect, Response, Ui};

use super::PictureTools;
use crate::commands::Command;
use crate::state::session::Session;

/// The picture as tools see it in a frame.
pub(crate) struct PictureContext<'a> {
    pub(crate) session: &'a Session,
    pub(crate) response: &'a Response,
    pub(crate) rect: Rect,
    /// Position of the pointer over the picture; `None` during a drag.
    pub(crate) pointer: Option<Pos2>,
}

/// Place of a tool's switch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SwitchPlace {
    /// The bar above the picture.
    Bar,
    /// The options of the picture.
    Options,
}

type IsOn = fn(&PictureTools) -> bool;
type ShowSwitch = fn(&mut PictureTools, &mut Ui, &mut Vec<Command>);
type ShowBar = fn(&mut PictureTools, &mut Ui, &Session);
type HandlePointer = fn(&mut PictureTools, &Ui, &PictureContext<'_>) -> Option<Command>;
type ShowOver = fn(&mut PictureTools, &mut Ui, &PictureContext<'_>, &mut Vec<Command>);
type ShowMark = fn(&PictureTools, &Ui, Rect);
type Hint = fn(&PictureTools) -> &str;

/// Tool of the picture.
pub(crate) struct ToolRow {
    pub(crate) place: SwitchPlace,
    pub(crate) is_on: IsOn,
    /// True if the tool has the pointer over the picture to itself while it is on.
    pub(crate) takes_pointer: bool,
    /// Shows the switch that turns the tool on and off.
    pub(crate) switch: ShowSwitch,
    /// Shows a row of controls below the bar.
    pub(crate) bar: Option<ShowBar>,
    /// Handles the pointer, before anything is drawn.
    pub(crate) interact: Option<HandlePointer>,
    /// Shows the overlay of the picture, below lines and handles.
    pub(crate) over: Option<ShowOver>,
    /// Marks the picture above all else.
    pub(crate) mark: Option<ShowMark>,
    /// Hint on the actions possible at the pointer, while the tool has the pointer.
    pub(crate) hint: Option<Hint>,
}

impl ToolRow {
    pub(crate) const fn new(place: SwitchPlace, is_on: IsOn, switch: ShowSwitch) -> Self {
        Self {
            place,
            is_on,
            takes_pointer: false,
            switch,
            bar: None,
            interact: None,
            over: None,
            mark: None,
            hint: None,
        }
    }

    pub(crate) const fn with_pointer(self, hint: Hint) -> Self {
        Self { takes_pointer: true, hint: Some(hint), ..self }
    }

    pub(crate) const fn with_bar(self, bar: ShowBar) -> Self {
        Self { bar: Some(bar), ..self }
    }

    pub(crate) const fn with_interaction(self, interact: HandlePointer) -> Self {
        Self { interact: Some(interact), ..self }
    }

    pub(crate) const fn with_overlay(self, over: ShowOver) -> Self {
        Self { over: Some(over), ..self }
    }

    pub(crate) const fn with_mark(self, mark: ShowMark) -> Self {
        Self { mark: Some(mark), ..self }
    }
}
