//! Definition of a tool of the picture: a row with its state, its switch, its overlay of the
//! picture and its jobs on other threads.

use std::any::Any;
use std::sync::Arc;

use eframe::egui::{Pos2, Rect, Response, Ui};

use super::PictureTools;
use crate::commands::Command;
use crate::render::Gpu;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;

/// Parts of the window that a tool's state may be made with.
pub(crate) struct ToolParts {
    /// GPU of the window, if there is one.
    pub(crate) gpu: Option<Gpu>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl ToolParts {
    /// `wake` is called from other threads when they have results or progress.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self { gpu, wake: Arc::new(wake) }
    }

    /// Function that a tool's threads call when they have results or progress.
    pub(crate) fn wake(&self) -> impl Fn() + Clone + Send + Sync + 'static + use<> {
        let wake = self.wake.clone();
        move || wake()
    }
}

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
    /// The end of that bar, where others give way.
    BarEnd,
    /// The options of the picture.
    Options,
    /// Another panel, or the parts of the picture that the tool works on.
    Elsewhere,
}

/// Function that makes a tool's state, which has a type of its own.
type Start = fn(&ToolParts) -> Box<dyn Any>;
type IsOn = fn(&PictureTools) -> bool;
type ShowSwitch = fn(&mut PictureTools, &mut Ui, &mut Vec<Command>);
type ShowBar = fn(&mut PictureTools, &mut Ui, &Session);
type HandlePointer = fn(&mut PictureTools, &Ui, &PictureContext<'_>) -> Option<Command>;
type ShowOver = fn(&mut PictureTools, &mut Ui, &PictureContext<'_>, &mut Vec<Command>);
type ShowMark = fn(&PictureTools, &Ui, Rect);
type Hint = fn(&PictureTools) -> &str;
/// Accessor of the threads that work for a tool.
type Jobs = fn(&PictureTools) -> &dyn BackgroundJobs;

/// Tool of the picture.
pub(crate) struct ToolRow {
    pub(crate) place: SwitchPlace,
    pub(crate) start: Start,
    pub(crate) is_on: IsOn,
    /// True if the tool has the pointer over the picture to itself while it is on.
    pub(crate) takes_pointer: bool,
    /// True if drags over the picture are the tool's while it is on, but those with Alt.
    pub(crate) takes_drags: bool,
    /// Shows the switch that turns the tool on and off, unless that is elsewhere.
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
    pub(crate) jobs: Option<Jobs>,
}

impl ToolRow {
    pub(crate) const fn new(
        place: SwitchPlace,
        start: Start,
        is_on: IsOn,
        switch: ShowSwitch,
    ) -> Self {
        Self {
            place,
            start,
            is_on,
            takes_pointer: false,
            takes_drags: false,
            switch,
            bar: None,
            interact: None,
            over: None,
            mark: None,
            hint: None,
            jobs: None,
        }
    }

    pub(crate) const fn with_pointer(self, hint: Hint) -> Self {
        Self { takes_pointer: true, hint: Some(hint), ..self }
    }

    pub(crate) const fn with_drags(self) -> Self {
        Self { takes_drags: true, ..self }
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

    pub(crate) const fn with_jobs(self, jobs: Jobs) -> Self {
        Self { jobs: Some(jobs), ..self }
    }
}
