//! What a panel is: a row with its name, what it is for, where it lies, what it draws and the jobs
//! that it has on other threads.

use eframe::egui::Ui;

use super::Workbench;
use crate::commands::{Command, PanelId};
use crate::state::safety::Safety;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;

/// What a panel shows: it changes nothing of that.
#[derive(Clone, Copy)]
pub(crate) struct PanelContext<'a> {
    pub(crate) session: &'a Session,
    pub(crate) safety: &'a Safety,
}

/// Draws a panel.
type Draw = fn(&mut Workbench, &mut Ui, PanelContext<'_>) -> Vec<Command>;
/// Does what is due once a frame, before anything is drawn.
type EachFrame = fn(&mut Workbench, &Ui, &Session, Presence) -> Vec<Command>;
/// The threads that work for a panel.
type Jobs = fn(&Workbench) -> &dyn BackgroundJobs;

/// A panel of the window.
pub(crate) struct PanelRow {
    pub(crate) id: PanelId,
    /// The text of its tab.
    pub(crate) label: &'static str,
    pub(crate) help: &'static str,
    pub(crate) place: PanelPlace,
    /// Takes in what the pointer does, before the panel is drawn: what that changes of the view and
    /// of strokes is drawn already.
    pub(crate) interact: Option<Draw>,
    pub(crate) draw: Draw,
    pub(crate) each_frame: Option<EachFrame>,
    pub(crate) jobs: Option<Jobs>,
}

impl PanelRow {
    pub(crate) const fn new(
        id: PanelId,
        label: &'static str,
        help: &'static str,
        place: PanelPlace,
        draw: Draw,
    ) -> Self {
        Self { id, label, help, place, interact: None, draw, each_frame: None, jobs: None }
    }

    pub(crate) const fn with_interaction(self, interact: Draw) -> Self {
        Self { interact: Some(interact), ..self }
    }

    pub(crate) const fn with_each_frame(self, each_frame: EachFrame) -> Self {
        Self { each_frame: Some(each_frame), ..self }
    }

    pub(crate) const fn with_jobs(self, jobs: Jobs) -> Self {
        Self { jobs: Some(jobs), ..self }
    }
}

/// How far a panel is there in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Presence {
    /// Closed.
    Absent,
    /// Behind another's tab, or behind the start page.
    Hidden,
    Seen,
}

/// Panels that lie in one another's place, each behind its tab.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stack {
    /// Above on the left.
    Picture,
    /// Below the picture.
    BelowPicture,
    /// In the middle.
    Graph,
    /// Above on the right.
    Document,
    /// Below on the right.
    Inspector,
}

/// Where a panel lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PanelPlace {
    /// Its stack in a new window; none for a panel that is closed there.
    pub(crate) stack: Option<Stack>,
    /// Whether a new layout for painting has it in front.
    pub(crate) is_for_painting: bool,
    /// Where it comes back to when it was closed: beside the first of these that is there.
    pub(crate) beside: &'static [PanelId],
    /// Whether it comes back below the graph, where there is room for that.
    pub(crate) is_below_graph: bool,
    /// Whether it fills its room to the edges.
    pub(crate) fills_room: bool,
}

impl PanelPlace {
    /// Closed in a new window, and beside nothing.
    pub(crate) const CLOSED: Self = Self {
        stack: None,
        is_for_painting: false,
        beside: &[],
        is_below_graph: false,
        fills_room: false,
    };
    /// With those below the picture that tell of the look.
    pub(crate) const BELOW_PICTURE: Self = Self {
        stack: Some(Stack::BelowPicture),
        beside: &[
            PanelId::CODE,
            PanelId::PROBLEMS,
            PanelId::EFFECTS,
            PanelId::COST,
            PanelId::PROBE,
            PanelId::PROFILE,
            PanelId::KEYS,
        ],
        ..Self::CLOSED
    };
    /// With those below the picture that draw curves.
    pub(crate) const BELOW_PICTURE_WITH_CURVES: Self = Self {
        stack: Some(Stack::BelowPicture),
        beside: &[PanelId::PROFILE, PanelId::KEYS, PanelId::CODE, PanelId::EFFECTS],
        ..Self::CLOSED
    };
    /// With those on the right that list what a document has.
    pub(crate) const WITH_DOCUMENT: Self = Self {
        stack: Some(Stack::Document),
        beside: &[
            PanelId::LAYERS,
            PanelId::LIGHTS,
            PanelId::OBJECTS,
            PanelId::LIBRARY,
            PanelId::HISTORY,
            PanelId::INSPECTOR,
        ],
        ..Self::CLOSED
    };

    /// The same, but closed in a new window.
    pub(crate) const fn closed(self) -> Self {
        Self { stack: None, ..self }
    }
}
