//! What a tool of the picture is: a row with its name, what turns it on, and what it does over the
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
    /// Over the picture, while nothing is dragged there.
    pub(crate) pointer: Option<Pos2>,
}

/// Where a tool's switch is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SwitchPlace {
    /// In the bar above the picture.
    Bar,
    /// Among its options.
    Options,
}

type Is = fn(&PictureTools) -> bool;
type ShowSwitch = fn(&mut PictureTools, &mut Ui, &mut Vec<Command>);
type ShowBar = fn(&mut PictureTools, &mut Ui, &Session);
type Interact = fn(&mut PictureTools, &Ui, &PictureContext<'_>) -> Option<Command>;
type ShowOver = fn(&mut PictureTools, &mut Ui, &PictureContext<'_>, &mut Vec<Command>);
type ShowMark = fn(&PictureTools, &Ui, Rect);
type Hint = fn(&PictureTools) -> &str;

/// A tool of the picture.
pub(crate) struct ToolRow {
    pub(crate) place: SwitchPlace,
    pub(crate) is_on: Is,
    /// Whether the pointer over the picture is the tool's alone while it is on.
    pub(crate) takes_pointer: bool,
    /// Shows what turns it on and off.
    pub(crate) switch: ShowSwitch,
    /// Shows a row of controls below the bar.
    pub(crate) bar: Option<ShowBar>,
    /// Takes in what the pointer does, before anything is drawn.
    pub(crate) interact: Option<Interact>,
    /// Shows what is over the picture, below lines and handles.
    pub(crate) over: Option<ShowOver>,
    /// Marks the picture above all else.
    pub(crate) mark: Option<ShowMark>,
    /// What may be done at the pointer, while the tool has it.
    pub(crate) hint: Option<Hint>,
}

impl ToolRow {
    pub(crate) const fn new(place: SwitchPlace, is_on: Is, switch: ShowSwitch) -> Self {
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

    pub(crate) const fn with_interaction(self, interact: Interact) -> Self {
        Self { interact: Some(interact), ..self }
    }

    pub(crate) const fn with_overlay(self, over: ShowOver) -> Self {
        Self { over: Some(over), ..self }
    }

    pub(crate) const fn with_mark(self, mark: ShowMark) -> Self {
        Self { mark: Some(mark), ..self }
    }
}
