//! Opening, saving and closing: nothing is lost on the way.

use std::path::{Path, PathBuf};

use eframe::egui::{self, RichText, Ui, ViewportCommand};

use super::App;
use crate::editor::command::Command;
use crate::editor::panels::{library, problems};

/// What would lose unsaved changes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Pending {
    New,
    Open(PathBuf),
    Example(usize),
    Close,
}

impl App {
    /// Opens a look and tells where that fails.
    pub fn open(&mut self, path: &Path) {
        if let Some(told) = self.safety.reopen(path, &mut self.session) {
            self.message = Some(told).filter(|told| !told.is_empty());
        } else {
            let is_open = self.session.open(path);
            self.message = (!is_open).then(|| format!("{} could not be opened", path.display()));
        }
        if self.message.is_none() {
            self.safety.opened(path);
        }
        self.safety.look();
    }

    /// Saves to a file and tells where that fails.
    pub fn save_as(&mut self, path: &Path) -> bool {
        match self.session.save_as(path) {
            Ok(()) => {
                self.message = Some(format!("Saved {}", path.display()));
                self.safety.opened(path);
                true
            }
            Err(problem) => {
                self.message = Some(problems::sentence(&problem).replace('\n', ": "));
                if problem.code == "changed-on-disk" {
                    self.safety.look_at_files(&mut self.session);
                }
                false
            }
        }
    }

    /// Does what would lose changes, where there are none, or where the journal keeps them; else asks first.
    pub(super) fn do_or_ask(&mut self, pending: Pending) {
        self.pending = Some(pending);
        if !self.session.is_dirty() || self.session.keeps_work() {
            self.go_on();
        }
    }

    pub(super) fn go_on(&mut self) {
        match self.pending.take() {
            Some(Pending::New) => {
                self.session.start_new();
                self.safety.look();
            }
            Some(Pending::Open(path)) => self.open(&path),
            Some(Pending::Example(index)) => {
                let (name, text) = library::EXAMPLES[index];
                self.session.start_from(text, name);
                self.safety.look();
            }
            Some(Pending::Close) => self.closes = true,
            None => {}
        }
    }

    pub(super) fn ask_about_changes(&mut self, ui: &Ui, commands: &mut Vec<Command>) {
        if self.pending.is_none() || !self.session.is_dirty() {
            return;
        }
        let modal = egui::Modal::new(egui::Id::unique("unsaved")).show(ui.ctx(), |ui| {
            ui.set_width(320.0);
            ui.label(RichText::new(format!("{} has changes", self.document_name())).heading());
            ui.label("They are lost unless you save them.");
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                if ui.button("Save").clicked() {
                    commands.push(Command::Save);
                }
                if ui.button("Do not save").clicked() {
                    self.session.give_up_changes();
                    self.go_on();
                }
                if ui.button("Cancel").clicked() {
                    self.pending = None;
                }
            });
        });
        if modal.should_close() {
            self.pending = None;
        }
    }

    pub(super) fn close_or_stay(&mut self, ctx: &egui::Context) {
        if self.closes {
            ctx.send_viewport_cmd(ViewportCommand::Close);
        } else if ctx.input(|input| input.viewport().close_requested())
            && self.session.is_dirty()
            && !self.session.keeps_work()
        {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.pending = Some(Pending::Close);
        }
    }
}
