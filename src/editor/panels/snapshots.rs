//! Snapshots of the open look: a picture, a name and a time of each; a click restores or compares
//! one.

use std::collections::HashMap;

use chiaro_locale::{text, tr};
use eframe::egui::{
    Button, Color32, Frame, Label, Margin, Popup, Response, RichText, Role, ScrollArea, Sense, Ui,
    WidgetInfo, vec2,
};

use super::thumbs::{Shot, Thumbs, key_on, surroundings_key};
use crate::commands::{Command, PanelId, SnapshotCommand, ViewCommand, table};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::comparison::ComparedPicture;
use crate::state::crashes::DocumentOrigin;
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::state::shelf::{self, LookSnapshot, SnapshotId, date_text};
use crate::widgets::rows::{Icon, NameEdit, icon, picture_frame, whole};
use crate::widgets::text::hint;
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::SNAPSHOTS,
    text!("Snapshots"),
    text!("States of the look that were kept with it: restored, compared, begun anew from"),
    PanelPlace::WITH_DOCUMENT.closed(),
    |bench, ui, context| bench.memory.of::<Snapshots>().show(ui, context.session, &bench.thumbs),
);

/// Side of a picture, in points.
const SIDE: f32 = 72.0;
/// Width below which a row shows no picture, in points.
const NARROW: f32 = 210.0;

/// The panel, and the name that is being changed.
#[derive(Default)]
pub(crate) struct Snapshots {
    renaming: Option<NameEdit<SnapshotId>>,
    /// Keys of the pictures, on the mesh that was shown last.
    keys: HashMap<SnapshotId, u64>,
    mesh: u64,
}

impl Snapshots {
    fn show(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        let mut out = Vec::new();
        let take = Command::Snapshot(SnapshotCommand::Take);
        if ui.button(tr!("Take a snapshot")).on_hover_text(table::help_of(&take)).clicked() {
            out.push(take);
        }
        let shelf = session.shelf();
        if let Some(problem) = shelf.problem() {
            let color = theme::of(ui).warning;
            ui.add(Label::new(RichText::new(sentence(problem)).small().color(color)).wrap());
        }
        if shelf.is_empty() {
            hint(
                ui,
                tr!("A snapshot keeps the look as it is, under a name: to come back to, and to \
                     hold what you do next against."),
            );
            return out;
        }
        let text = match session.path().map(shelf::file_of) {
            None => tr!("Save the look, and its snapshots lie in a file beside it.").to_owned(),
            Some(file) => tr!(
                "They lie in {file} beside the look: give both away.",
                file = file.file_name().unwrap_or_default().display()
            ),
        };
        hint(ui, &text);
        let mesh = surroundings_key(session);
        if std::mem::replace(&mut self.mesh, mesh) != mesh {
            self.keys.clear();
        }
        self.keys.retain(|id, _| shelf.of(*id).is_some());
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("snapshots").show(ui, |ui| {
            for snapshot in shelf.all().rev() {
                self.row(ui, session, snapshot, thumbs, &mut out);
            }
        });
        thumbs.look_again(ui);
        out
    }

    fn row(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        snapshot: &LookSnapshot,
        thumbs: &Thumbs,
        out: &mut Vec<Command>,
    ) {
        let is_wide = ui.available_width() > NARROW;
        let frame = Frame::new().fill(theme::of(ui).node).corner_radius(4.0);
        frame.inner_margin(Margin::same(4)).show(ui, |ui| {
            ui.set_width(ui.available_width() - 10.0);
            ui.horizontal_top(|ui| {
                if is_wide {
                    self.picture(ui, session, snapshot, thumbs);
                }
                ui.vertical(|ui| self.texts(ui, session, snapshot, out));
            });
        });
    }

    /// Shows the snapshot on the mesh of the picture.
    fn picture(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        snapshot: &LookSnapshot,
        thumbs: &Thumbs,
    ) {
        let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::hover());
        if !ui.is_rect_visible(rect) {
            return;
        }
        let side = SIDE * ui.pixels_per_point();
        let look = &snapshot.look;
        let key = || key_on(look, Shot::Shown, side, session);
        let key = *self.keys.entry(snapshot.id).or_insert_with(key);
        if !thumbs.is_done(key) {
            let name = || DocumentOrigin::new(&snapshot.name, session.path(), look);
            let folder = session.look.folder();
            thumbs.ask(key, name, (look.clone(), folder), session, Shot::Shown, side);
        }
        ui.painter().rect_filled(rect, 3.0, theme::of(ui).canvas);
        if let Some(texture) = thumbs.known(key) {
            ui.painter().image(texture, rect.shrink(1.0), whole(), Color32::WHITE);
        }
        picture_frame(ui, rect);
        response.widget_info(|| {
            WidgetInfo::labeled(Role::Image, true, tr!("Picture of {name}", name = snapshot.name))
        });
    }

    fn texts(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        snapshot: &LookSnapshot,
        out: &mut Vec<Command>,
    ) {
        let mut push = |command| out.push(Command::Snapshot(command));
        let (id, name) = (snapshot.id, &snapshot.name);
        let mut compared = None;
        if let Some(field) = self.renaming.as_mut().filter(|field| field.id == id) {
            if let Some(changed) = field.show(ui, name, &tr!("New name of {name}")) {
                self.renaming = None;
                if let Some(name) = changed {
                    push(SnapshotCommand::Rename(id, name));
                }
            }
        } else {
            let text = RichText::new(name).color(theme::of(ui).text);
            let label = Label::new(text).truncate().selectable(false).sense(Sense::click());
            let response = ui.add(label).on_hover_text(tr!("Double click to rename"));
            if response.double_clicked() {
                self.renaming = Some(NameEdit::new(id, name));
            }
        }
        let is_now = *snapshot.look == *session.look();
        let date = date_text(snapshot.taken);
        let text = if is_now || snapshot.is_like(session.look()) {
            tr!("{date}, as the look is now")
        } else {
            date
        };
        ui.add(Label::new(RichText::new(text).small().color(theme::of(ui).dim)).truncate());
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 3.0;
            let help = tr!("Makes the look what it was then, as one step that can be undone");
            let button = ui.add_enabled(!is_now, Button::new(tr!("Restore"))).on_hover_text(help);
            if named(button, !is_now, &tr!("Restore {name}")).clicked() {
                push(SnapshotCommand::Restore(id));
            }
            let help =
                tr!("Shows the picture beside what the snapshot holds: wipe, flicker, difference");
            let button = ui.button(tr!("Compare")).on_hover_text(help);
            if named(button, true, &tr!("Compare with {name}")).clicked() {
                compared = Some(ComparedPicture::Snapshot(id));
            }
            let more = icon(ui, Icon::More, true, &tr!("More about {name}"), tr!("More"));
            Popup::menu(&more).show(|ui| {
                if ui.button(tr!("Rename")).clicked() {
                    self.renaming = Some(NameEdit::new(id, name));
                }
                let help = tr!("A look of its own with what the snapshot holds; this look stays");
                if ui.button(tr!("New look from it")).on_hover_text(help).clicked() {
                    push(SnapshotCommand::Copy(id));
                }
                let help = tr!("Undo brings it back");
                if ui.button(tr!("Delete")).on_hover_text(help).clicked() {
                    push(SnapshotCommand::Delete(id));
                }
            });
        });
        out.extend(compared.map(|picture| Command::View(ViewCommand::Compare(Some(picture)))));
    }
}

/// Gives a button a name of its own among those with the same text.
fn named(button: Response, is_enabled: bool, name: &str) -> Response {
    button.widget_info(|| WidgetInfo::labeled(Role::Button, is_enabled, name));
    button
}
