//! Upkeep of saved parts: the menu of a card, the field that renames a part, and the question
//! before one is removed.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Button, Id, Key, Modal, Modifiers, Rect, Response, RichText, Ui, UiBuilder};

use crate::commands::{Command, LibraryCommand};
use crate::state::parts::{Part, PartKind};
use crate::widgets::confirm;
use crate::widgets::rows::NameEdit;

/// Width of the question, in points.
const WIDTH: f32 = 340.0;

/// Name of a part that is being changed, and the part that is removed once the user agrees.
#[derive(Default)]
pub(super) struct PartUpkeep {
    renaming: Option<NameEdit<PathBuf>>,
    removing: Option<Arc<Part>>,
}

impl PartUpkeep {
    /// Shows the menu of a part.
    pub(super) fn menu(
        &mut self,
        ui: &mut Ui,
        part: &Arc<Part>,
        is_read_only: bool,
        out: &mut Vec<Command>,
    ) {
        let locked = tr!("You may not write to this folder");
        let entry = |ui: &mut Ui, label: &str, help: &str, is_on: bool| {
            let button = ui.add_enabled(!is_read_only && is_on, Button::new(label));
            let why_not = if is_read_only { locked } else { tr!("The file cannot be read") };
            button.on_hover_text(help).on_disabled_hover_text(why_not).clicked()
        };
        let is_sound = part.content.is_ok();
        if entry(ui, tr!("Rename part"), tr!("Its file keeps its name (F2)"), is_sound) {
            self.rename(part);
        }
        let help = tr!("Opens the folder that its file lies in");
        if ui.button(tr!("Show the file")).on_hover_text(help).clicked() {
            out.push(Command::Library(LibraryCommand::ShowFile(part.path.clone())));
        }
        ui.separator();
        if entry(ui, tr!("Remove part…"), tr!("Deletes its file (Del)"), true) {
            self.removing = Some(part.clone());
        }
    }

    /// Handles the keys of a card that has the focus.
    pub(super) fn keys(&mut self, ui: &Ui, card: &Response, part: &Arc<Part>) {
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        if !card.has_focus() {
            return;
        }
        if part.content.is_ok() && pressed(Key::F2) {
            self.rename(part);
        }
        if pressed(Key::Delete) {
            self.removing = Some(part.clone());
        }
    }

    fn rename(&mut self, part: &Part) {
        self.renaming = Some(NameEdit::new(part.path.clone(), &part.name));
    }

    /// Shows the field in place of a part's name, while it is being changed.
    pub(super) fn field(
        &mut self,
        ui: &mut Ui,
        at: Rect,
        part: &Arc<Part>,
        out: &mut Vec<Command>,
    ) {
        let Some(edit) = self.renaming.as_mut().filter(|edit| edit.id == part.path) else { return };
        let salt = ("name", &part.path);
        let mut child = ui.new_child(UiBuilder::new().id_salt(salt).max_rect(at));
        let Some(named) =
            edit.show(&mut child, tr!("Name of the part"), tr!("New name of the part"))
        else {
            return;
        };
        self.renaming = None;
        if let Some(name) = named.filter(|name| !name.is_empty() && *name != part.name) {
            out.push(Command::Library(LibraryCommand::Rename(part.clone(), name)));
        }
    }

    /// Asks whether a part is to be removed.
    pub(super) fn ask(&mut self, ui: &Ui, out: &mut Vec<Command>) {
        let Some(part) = &self.removing else { return };
        let mut answer = None;
        let modal = Modal::new(Id::unique("part to remove")).show(ui.ctx(), |ui| {
            ui.set_width(WIDTH);
            let enters = confirm::enters(ui);
            let title = tr!("Remove \"{part}\" from the library?", part = part.name);
            ui.label(RichText::new(title).heading());
            ui.label(tr!("Its file is deleted. Looks that have a copy of it keep the copy."));
            if part.content.as_ref().is_ok_and(|content| content.kind == PartKind::Look) {
                ui.label(tr!("Objects of scenes that wear this file lose their look."));
            }
            ui.label(RichText::new(part.path.display().to_string()).small());
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                if ui.button(tr!("Remove")).clicked() || enters {
                    answer = Some(true);
                }
                if ui.button(tr!("Cancel")).clicked() {
                    answer = Some(false);
                }
            });
        });
        if modal.should_close() {
            answer = Some(false);
        }
        if let Some(is_removed) = answer
            && let Some(part) = self.removing.take()
            && is_removed
        {
            out.push(Command::Library(LibraryCommand::Remove(part)));
        }
    }
}
