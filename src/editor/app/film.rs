//! Frames, farms' jobs and wedges, which the program makes beside the window.

use std::path::{Path, PathBuf};

use chiaro_locale::{Text, text, tr};
use eframe::egui::{OpenUrl, Ui};

use super::App;
use crate::app::look_export::address_of;
use crate::commands::{Command, FilePurpose, FilmCommand, PanelId};
use crate::panels::PanelContext;
use crate::state::wedge::{CellScope, WedgeCell, WedgeSheet};

impl App {
    /// Carries out a command about film.
    pub(super) fn apply_to_film(&mut self, ui: &Ui, command: FilmCommand) {
        let context = PanelContext { session: &self.session, safety: &self.safety };
        match command {
            FilmCommand::Render => match &self.program {
                Some(program) => self.bench.frames.render(context, program),
                None => self.message = Some(NO_PROGRAM.tr().to_owned()),
            },
            FilmCommand::WriteJob => match &self.program {
                Some(program) => self.bench.frames.write_job(context, program),
                None => self.message = Some(NO_PROGRAM.tr().to_owned()),
            },
            FilmCommand::DrawWedge => match &self.program {
                Some(program) => self.bench.wedge.draw(&self.session, program),
                None => self.message = Some(NO_PROGRAM.tr().to_owned()),
            },
            FilmCommand::StopFrames => self.bench.frames.stop(),
            FilmCommand::StopWedge => self.bench.wedge.stop(),
            FilmCommand::ShowFarm => {
                self.show_panel_of_film(PanelId::FRAMES);
                self.bench.frames.show_farm();
            }
            FilmCommand::ChooseFolder(folder) => self.choose_frame_folder(folder),
            FilmCommand::OpenPath(path) => {
                ui.ctx().open_url(OpenUrl::new_tab(address_of(&path)));
            }
            FilmCommand::Vary(variation) => {
                self.bench.wedge.vary(variation);
                self.show_panel_of_film(PanelId::WEDGE);
            }
            FilmCommand::EnlargeWedge(is_large) => {
                self.bench.wedge.enlarge(is_large);
                if is_large {
                    self.show_panel_of_film(PanelId::GRAPH);
                }
            }
            FilmCommand::ShowWedge(sheet) => self.show_drawn_wedge(&sheet),
        }
    }

    /// Takes the values of a wedge's cell, and tells what became of them.
    pub(super) fn take_cell(&mut self, cell: &WedgeCell, scope: CellScope) {
        let told = self.attempt(|session| session.take_cell(cell, scope));
        self.message = told.or(self.message.take());
    }

    /// Shows the graph in place of a wedge's sheet, where a command is about what is seen there.
    pub(super) fn uncover_graph(&mut self, command: &Command) {
        let is_about_graph = matches!(
            command,
            Command::Graph(_)
                | Command::Reveal(_)
                | Command::Show(_)
                | Command::OpenGraph(_)
                | Command::ShowPanel(PanelId::GRAPH)
        );
        if is_about_graph {
            self.bench.wedge.enlarge(false);
        }
    }

    fn show_panel_of_film(&mut self, panel: PanelId) {
        self.start = None;
        self.dock.open(panel);
    }

    fn choose_frame_folder(&mut self, folder: Option<PathBuf>) {
        match folder {
            Some(folder) => self.bench.frames.set_folder(&self.session, &folder),
            None => {
                let near = self.bench.frames.folder(&self.session);
                self.dialogs.ask(FilePurpose::FrameFolder, near.as_deref());
            }
        }
    }

    fn show_drawn_wedge(&mut self, sheet: &Path) {
        match WedgeSheet::read(sheet) {
            Some(sheet) => self.show_wedge(sheet),
            None => self.message = Some(tr!("{file} cannot be read", file = sheet.display())),
        }
    }
}

/// Message where the program's own file is not known.
const NO_PROGRAM: Text = text!("The program's own file is not known, so that it cannot render");
