//! Form that saves a part of the look: its name, its words and its folder.

use std::path::PathBuf;

use chiaro_locale::tr;
use eframe::egui::{Button, ComboBox, Key, RichText, Role, TextEdit, Ui, WidgetInfo};

use super::saved::Shelf;
use crate::commands::{Command, LibraryCommand};
use crate::state::parts::saving::PartDraft;
use crate::state::parts::{FoundParts, PartKind};
use crate::widgets::theme;

/// Form that saves a part.
pub(super) struct SaveForm {
    draft: PartDraft,
    folder: Option<PathBuf>,
    is_new: bool,
}

impl SaveForm {
    pub(super) fn new(draft: PartDraft) -> Self {
        Self { draft, folder: None, is_new: true }
    }

    /// Shows the form; returns true once it is given up.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        shelves: &[Shelf],
        found: &[FoundParts],
        out: &mut Vec<Command>,
    ) -> bool {
        let mut is_over = false;
        frame(ui).show(ui, |ui| {
            let word = self.draft.kind.word();
            ui.label(RichText::new(tr!("Save to the library: {word}")).strong());
            let enters = self.fields(ui);
            let chosen = self
                .folder
                .as_ref()
                .and_then(|folder| shelves.iter().find(|shelf| shelf.folder == *folder))
                .or(shelves.first());
            ui.horizontal_wrapped(|ui| {
                self.folder = self.choose_folder(ui, shelves, chosen).or(self.folder.take());
                let there = chosen
                    .and_then(|shelf| found.iter().find(|found| found.folder == shelf.folder));
                self.buttons(ui, (chosen, there), enters, out);
                is_over = ui.button(tr!("Cancel")).clicked();
            });
            for note in &self.draft.notes {
                ui.label(RichText::new(note).small().color(theme::of(ui).warning));
            }
        });
        is_over
    }

    /// Shows the fields; returns true if Enter was pressed in one.
    fn fields(&mut self, ui: &mut Ui) -> bool {
        let mut enters = false;
        let mut field = |ui: &mut Ui, text: &mut String, label: &str, help: &str| {
            let edit = TextEdit::singleline(text)
                .hint_text(label)
                .desired_width(f32::INFINITY)
                .char_limit(200);
            let response = ui.add(edit).on_hover_text(help);
            response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, label));
            enters |= response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
            response
        };
        let look = &mut self.draft.look;
        let name = field(ui, &mut look.name, tr!("Name of the part"), tr!("What it is called"));
        if std::mem::take(&mut self.is_new) {
            name.request_focus();
        }
        let help = tr!("Words to find it by, apart by spaces");
        field(ui, &mut look.tags, tr!("Tags of the part"), help);
        let help = tr!("What it shows, how it is built");
        field(ui, &mut look.about, tr!("About the part"), help);
        enters
    }

    /// Shows the choice of a folder; returns another one that is chosen.
    fn choose_folder(
        &self,
        ui: &mut Ui,
        shelves: &[Shelf],
        chosen: Option<&Shelf>,
    ) -> Option<PathBuf> {
        let mut other = None;
        let text = chosen.map_or(tr!("No folder"), |shelf| shelf.title.as_str());
        ui.label(tr!("In"));
        let combo = ComboBox::from_id_salt("folder").selected_text(text).show_ui(ui, |ui| {
            for shelf in shelves {
                let row = ui.selectable_label(chosen == Some(shelf), &shelf.title);
                if row.on_hover_text(shelf.folder.display().to_string()).clicked() {
                    other = Some(shelf.folder.clone());
                }
            }
        });
        let info = || WidgetInfo::labeled(Role::ComboBox, true, tr!("Folder of the part"));
        combo.response.widget_info(info);
        other
    }

    /// Shows the button that saves; where the folder has a part of the name already, that which
    /// replaces it, too. Enter saves where there is nothing to choose.
    fn buttons(
        &self,
        ui: &mut Ui,
        (chosen, there): (Option<&Shelf>, Option<&FoundParts>),
        enters: bool,
        out: &mut Vec<Command>,
    ) {
        let PartDraft { kind, look, .. } = &self.draft;
        let is_read_only = there.is_some_and(|found| found.is_read_only);
        // A folder of a server that is away would be made anew, where nobody looks for it.
        let is_away = chosen.is_some_and(|shelf| shelf.is_shared)
            && there.is_some_and(|found| !found.is_there);
        let is_open = !is_read_only && !is_away;
        let is_ready = chosen.is_some() && !look.name.trim().is_empty() && is_open;
        let why_not = match (is_away, is_read_only) {
            (true, _) => tr!("This folder is not there at the moment"),
            (false, true) => tr!("You may not write to this folder"),
            (false, false) => tr!("Give it a name first"),
        };
        let button = |ui: &mut Ui, label: &str| {
            ui.add_enabled(is_ready, Button::new(label)).on_disabled_hover_text(why_not)
        };
        let draft = || Box::new(self.draft.clone());
        let namesake = there.and_then(|found| found.namesake(*kind, &look.name));
        let label = match namesake {
            Some(part) => {
                let help = tr!("Writes it over {file}", file = part.path.display());
                if button(ui, tr!("Replace")).on_hover_text(help).clicked() {
                    let replace = LibraryCommand::Replace(draft(), part.path.clone());
                    out.push(Command::Library(replace));
                }
                tr!("Keep both")
            }
            None => save_label(*kind),
        };
        let is_entered = enters && is_ready && namesake.is_none();
        if (button(ui, label).clicked() || is_entered)
            && let Some(shelf) = chosen
        {
            out.push(Command::Library(LibraryCommand::Save(draft(), shelf.folder.clone())));
        }
        if namesake.is_some() {
            let text = tr!("There is a part of this name already");
            ui.label(RichText::new(text).small().color(theme::of(ui).warning));
        }
    }
}

/// Text of the button that saves a part.
fn save_label(kind: PartKind) -> &'static str {
    match kind {
        PartKind::Look => tr!("Save look"),
        PartKind::Layer => tr!("Save layer"),
        PartKind::Nodes => tr!("Save nodes"),
        PartKind::Group => tr!("Save group"),
        PartKind::Lights => tr!("Save lights"),
        PartKind::Profile => tr!("Save profile"),
        PartKind::Ramp => tr!("Save ramp"),
    }
}

fn frame(ui: &Ui) -> eframe::egui::Frame {
    let colors = theme::of(ui);
    eframe::egui::Frame::new().fill(colors.field).corner_radius(4.0).inner_margin(8.0)
}
