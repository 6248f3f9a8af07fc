//! Tools of the picture. Each is a value: a [`ToolRow`] with its switch, its controls and its
//! overlay of the picture. A new tool is a file with a row, and a line in [`TOOLS`].

pub(crate) mod fitting;
mod handles;
pub(crate) mod probe;
mod table;
pub(crate) mod wipe;

use eframe::egui::Ui;

use crate::commands::Command;
use crate::render::Gpu;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use fitting::FitTool;
use probe::Probe;
pub(crate) use table::{PictureContext, SwitchPlace, ToolRow};
use wipe::Wipe;

/// All tools, in the order of their switches; their overlays lie in reverse order.
pub(crate) static TOOLS: &[ToolRow] = &[handles::TOOL, probe::TOOL, fitting::TOOL, wipe::TOOL];

/// Tools of the picture, and their state.
pub(crate) struct PictureTools {
    pub(crate) has_handles: bool,
    pub(crate) probe: Probe,
    pub(crate) wipe: Wipe,
    pub(crate) fitting: FitTool,
}

impl PictureTools {
    /// `wake` is called from other threads when they have results or progress.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        Self {
            has_handles: true,
            probe: Probe::new(wake.clone()),
            wipe: Wipe::new(gpu, wake.clone()),
            fitting: FitTool::new(wake),
        }
    }

    /// Tool that has the pointer over the picture to itself.
    pub(crate) fn with_pointer(&self) -> Option<&'static ToolRow> {
        TOOLS.iter().find(|tool| tool.takes_pointer && (tool.is_on)(self))
    }

    /// Shows the switches of the tools whose switch is at `place`.
    pub(crate) fn switches(&mut self, ui: &mut Ui, place: SwitchPlace, out: &mut Vec<Command>) {
        for tool in TOOLS.iter().filter(|tool| tool.place == place) {
            (tool.switch)(self, ui, out);
        }
    }

    /// Shows the rows of controls of the tools that have one.
    pub(crate) fn bars(&mut self, ui: &mut Ui, session: &Session) {
        TOOLS.iter().rev().filter_map(|tool| tool.bar).for_each(|bar| bar(self, ui, session));
    }

    /// Handles the pointer over the picture.
    pub(crate) fn interact(&mut self, ui: &Ui, context: &PictureContext<'_>) -> Vec<Command> {
        let interact = TOOLS.iter().filter_map(|tool| tool.interact);
        interact.filter_map(|interact| interact(self, ui, context)).collect()
    }

    /// Shows the tools' overlays of the picture.
    pub(crate) fn over(
        &mut self,
        ui: &mut Ui,
        context: &PictureContext<'_>,
        out: &mut Vec<Command>,
    ) {
        TOOLS
            .iter()
            .rev()
            .filter_map(|tool| tool.over)
            .for_each(|over| over(self, ui, context, out));
    }

    fn jobs(&self) -> [&dyn BackgroundJobs; 3] {
        [&self.probe, &self.wipe, &self.fitting]
    }
}

impl BackgroundJobs for PictureTools {
    fn is_busy(&self) -> bool {
        self.jobs().iter().any(|tool| tool.is_busy())
    }

    fn wait(&self) {
        self.jobs().iter().for_each(|tool| tool.wait());
    }
}
