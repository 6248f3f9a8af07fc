//! Tools of the picture. Each is a value: a [`ToolRow`] with its state, its switch, its controls,
//! its overlay of the picture and the threads that work for it. A new tool is a file with a row,
//! and a line in [`TOOLS`].

pub(crate) mod fitting;
pub(crate) mod flip;
pub(crate) mod handles;
pub(crate) mod masking;
pub(crate) mod notice;
pub(crate) mod onion;
pub(crate) mod picture_plan;
pub(crate) mod placing;
pub(crate) mod playback;
pub(crate) mod probe;
pub(crate) mod safe_frame;
mod surface;
mod table;
pub(crate) mod wipe;

use std::any::{Any, type_name};

use eframe::egui::Ui;

use crate::commands::Command;
use crate::render::Gpu;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use table::ToolParts;
pub(crate) use table::{PictureContext, SwitchPlace, ToolRow};

/// All tools, in the order of their switches; their overlays lie in reverse order.
pub(crate) static TOOLS: &[ToolRow] = &[
    handles::TOOL,
    safe_frame::TOOL,
    probe::TOOL,
    placing::TOOL,
    masking::TOOL,
    fitting::TOOL,
    wipe::TOOL,
    flip::TOOL,
    onion::TOOL,
    playback::TOOL,
];

/// States of the picture's tools, each of a type of its own.
pub(crate) struct PictureTools {
    states: Vec<Box<dyn Any>>,
}

impl PictureTools {
    /// `wake` is called from other threads when they have results or progress.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        let parts = ToolParts::new(gpu, wake);
        let states = TOOLS.iter().map(|tool| (tool.start)(&parts)).collect();
        Self { states }
    }

    /// State of this type, which the row of a tool starts.
    pub(crate) fn of<T: 'static>(&self) -> &T {
        let state = self.states.iter().find_map(|state| state.downcast_ref::<T>());
        state.unwrap_or_else(|| unreachable!("no tool starts a {}", type_name::<T>()))
    }

    /// State of this type, to change it.
    pub(crate) fn of_mut<T: 'static>(&mut self) -> &mut T {
        let state = self.states.iter_mut().find_map(|state| state.downcast_mut::<T>());
        state.unwrap_or_else(|| unreachable!("no tool starts a {}", type_name::<T>()))
    }

    /// States of two types, to change both.
    pub(crate) fn pair<A: 'static, B: 'static>(&mut self) -> (&mut A, &mut B) {
        let (mut a, mut b) = (None, None);
        for state in &mut self.states {
            if state.is::<A>() {
                a = state.downcast_mut::<A>();
            } else if state.is::<B>() {
                b = state.downcast_mut::<B>();
            }
        }
        let names = || (type_name::<A>(), type_name::<B>());
        a.zip(b).unwrap_or_else(|| unreachable!("no tools start {:?}", names()))
    }

    /// Tool that has the pointer over the picture to itself.
    pub(crate) fn with_pointer(&self) -> Option<&'static ToolRow> {
        TOOLS.iter().find(|tool| tool.takes_pointer && (tool.is_on)(self))
    }

    /// True if a tool that is on takes drags over the picture.
    pub(crate) fn takes_drags(&self) -> bool {
        TOOLS.iter().any(|tool| tool.takes_drags && (tool.is_on)(self))
    }

    /// Tools whose switches are in the bar above the picture, the most needed first.
    pub(crate) fn of_bar() -> impl Iterator<Item = &'static ToolRow> {
        let at = |place: SwitchPlace| TOOLS.iter().filter(move |tool| tool.place == place);
        at(SwitchPlace::BarEnd).chain(at(SwitchPlace::Bar))
    }

    /// Shows the switches that are among the options of the picture.
    pub(crate) fn options(&mut self, ui: &mut Ui, out: &mut Vec<Command>) {
        for tool in TOOLS.iter().filter(|tool| tool.place == SwitchPlace::Options) {
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

    /// Threads that work for tools.
    fn jobs(&self) -> impl Iterator<Item = &dyn BackgroundJobs> {
        TOOLS.iter().filter_map(|tool| tool.jobs).map(move |jobs| jobs(self))
    }
}

impl BackgroundJobs for PictureTools {
    fn is_busy(&self) -> bool {
        self.jobs().any(|jobs| jobs.is_busy())
    }

    fn wait(&self) {
        self.jobs().for_each(|jobs| jobs.wait());
    }
}

#[cfg(test)]
mod tests {
    use std::any::TypeId;
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn tools_start_with_states_of_their_own() {
        let tools = PictureTools::new(None, || {});
        let types: HashSet<TypeId> = tools.states.iter().map(|state| (**state).type_id()).collect();
        assert_eq!(types.len(), TOOLS.len());
        let on = TOOLS.iter().filter(|tool| (tool.is_on)(&tools)).count();
        assert_eq!(on, 2, "each row finds its state; handles and the frame are on at first");
        assert!(tools.with_pointer().is_none() && !tools.is_busy());
    }
}
