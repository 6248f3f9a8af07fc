//! The panels beside the picture and the graph: layers, lights, problems, history and the library.

pub(crate) mod code;
pub(crate) mod cost;
pub(crate) mod curves;
pub(crate) mod effects;
mod history;
pub(crate) mod inspector;
pub(crate) mod layers;
pub(crate) mod library;
pub(crate) mod lights;
mod objects;
pub(crate) mod problems;
mod start;
mod thumbs;

use eframe::egui::Ui;

use crate::app::dock::Panel;
use crate::commands::Command;
use crate::render::Gpu;
use crate::state::safety::crashes::CrashLog;
use crate::state::session::Session;
use thumbs::Thumbs;

/// The panels, and what they remember.
pub(crate) struct Panels {
    layers: layers::Layers,
    lights: lights::Lights,
    objects: objects::Objects,
    history: history::History,
    library: library::Library,
    start: start::Start,
    thumbs: Thumbs,
}

impl Panels {
    /// `wake` is called from another thread when there is a new small picture; what goes on is
    /// noted in `crashes`.
    pub(crate) fn new(
        gpu: Option<Gpu>,
        crashes: CrashLog,
        wake: impl Fn() + Send + 'static,
    ) -> Self {
        Self {
            layers: layers::Layers::default(),
            lights: lights::Lights::default(),
            objects: objects::Objects::default(),
            history: history::History::default(),
            library: library::Library::default(),
            start: start::Start::default(),
            thumbs: Thumbs::new(gpu, crashes, wake),
        }
    }

    /// Shows one of them; nothing for a panel that is none of them.
    pub(crate) fn show(&mut self, ui: &mut Ui, panel: Panel, session: &Session) -> Vec<Command> {
        match panel {
            Panel::Layers => self.layers.show(ui, session, &self.thumbs),
            Panel::Lights => self.lights.show(ui, session),
            Panel::Objects => self.objects.show(ui, session),
            Panel::Problems => problems::show(ui, session),
            Panel::History => self.history.show(ui, session),
            Panel::Library => self.library.show(ui, session, &self.thumbs),
            _ => Vec::new(),
        }
    }

    /// Shows the start page in their place. `recent` are the files opened before, with whether each
    /// is still there.
    pub(crate) fn show_start<'p>(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        recent: impl Iterator<Item = (&'p std::path::PathBuf, bool)>,
    ) -> Vec<Command> {
        self.start.know_recent(recent, &session.crashes);
        self.start.show(ui, session, &self.thumbs)
    }

    /// The start page is not shown any more.
    pub(crate) fn end_start(&mut self) {
        self.start.rest();
    }

    /// Learns which files were opened before, with whether each is still there.
    pub(crate) fn know_recent<'p>(
        &mut self,
        files: impl Iterator<Item = (&'p std::path::PathBuf, bool)>,
        crashes: &CrashLog,
    ) {
        self.library.know_recent(files, crashes);
    }

    /// What is due once a frame, whichever are seen.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session) {
        self.thumbs.update(ui, session);
    }

    /// How many small pictures there are.
    pub(crate) fn pictures(&self) -> usize {
        self.thumbs.count()
    }

    pub(crate) fn is_busy(&self) -> bool {
        self.thumbs.is_busy()
    }

    pub(crate) fn wait(&self) {
        self.thumbs.wait();
    }
}
