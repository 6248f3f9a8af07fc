//! Definition of a panel: a row with its name, its help, its place, the function that draws it and
//! its jobs on other threads.

use chiaro_locale::Text;
use eframe::egui::Ui;

use super::Workbench;
use crate::commands::{Command, PanelId};
use crate::state::safety::Safety;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;

/// State that a panel shows and does not change.
#[derive(Clone, Copy)]
pub(crate) struct PanelContext<'a> {
    pub(crate) session: &'a Session,
    pub(crate) safety: &'a Safety,
}

/// Function that draws a panel.
type Draw = fn(&mut Workbench, &mut Ui, PanelContext<'_>) -> Vec<Command>;
/// Function that is called once a frame, before anything is drawn.
type EachFrame = fn(&mut Workbench, &Ui, &Session, Presence) -> Vec<Command>;
/// Accessor of the threads that work for a panel.
type Jobs = fn(&Workbench) -> &dyn BackgroundJobs;

/// Panel of the window.
pub(crate) struct PanelRow {
    pub(crate) id: PanelId,
    /// Text of the panel's tab.
    pub(crate) label: Text,
    pub(crate) help: Text,
    pub(crate) place: PanelPlace,
    /// Function that handles the pointer before the panel is drawn, so that its changes to the view
    /// and to strokes are drawn in the same frame.
    pub(crate) interact: Option<Draw>,
    pub(crate) draw: Draw,
    pub(crate) each_frame: Option<EachFrame>,
    pub(crate) jobs: Option<Jobs>,
}

impl PanelRow {
    pub(crate) const fn new(
        id: PanelId,
        label: Text,
        help: Text,
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

/// Visibility of a panel in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Presence {
    /// Closed panel.
    Absent,
    /// Panel behind another's tab, or behind the start page.
    Hidden,
    Seen,
}

/// Stack of panels in one place, each behind its tab.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PanelStack {
    /// Top left.
    Picture,
    /// Below the picture.
    BelowPicture,
    /// Center.
    Graph,
    /// Top right.
    Document,
    /// Bottom right.
    Inspector,
}

/// Place of a panel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PanelPlace {
    /// Stack of the panel in a new window; `None` for a panel that is closed there.
    pub(crate) stack: Option<PanelStack>,
    /// True if a new layout for painting has the panel in front.
    pub(crate) is_for_painting: bool,
    /// Panels beside one of which a closed panel reopens: the first that is open.
    pub(crate) beside: &'static [PanelId],
    /// True if a closed panel reopens below the graph, where there is room.
    pub(crate) is_below_graph: bool,
    /// Height that the panel's stack gets when the panel is opened, where it has less and its
    /// column has more; in points.
    pub(crate) least_height: f32,
    /// True if the panel fills its area to the edges.
    pub(crate) fills_room: bool,
}

impl PanelPlace {
    /// Place of a panel that is closed in a new window, with no others to reopen beside.
    pub(crate) const CLOSED: Self = Self {
        stack: None,
        is_for_painting: false,
        beside: &[],
        is_below_graph: false,
        least_height: 200.0,
        fills_room: false,
    };
    /// Place below the picture, with the panels that tell of the look.
    pub(crate) const BELOW_PICTURE: Self = Self {
        stack: Some(PanelStack::BelowPicture),
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
    /// Place below the picture, with the panels that draw curves.
    pub(crate) const BELOW_PICTURE_WITH_CURVES: Self = Self {
        stack: Some(PanelStack::BelowPicture),
        beside: &[PanelId::PROFILE, PanelId::KEYS, PanelId::CODE, PanelId::EFFECTS],
        ..Self::CLOSED
    };
    /// Place below the graph, with the panels that need its width; closed in a new window.
    pub(crate) const BELOW_GRAPH: Self = Self {
        is_below_graph: true,
        least_height: 300.0,
        ..Self::BELOW_PICTURE_WITH_CURVES.closed()
    };
    /// Place on the right, with the panels that list the parts of a document.
    pub(crate) const WITH_DOCUMENT: Self = Self {
        stack: Some(PanelStack::Document),
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

    /// The same place, but closed in a new window.
    pub(crate) const fn closed(self) -> Self {
        Self { stack: None, ..self }
    }
}
