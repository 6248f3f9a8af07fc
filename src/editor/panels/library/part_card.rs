//! Card of a part: its picture, its name and its kind; to be dragged, or pressed twice.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use eframe::egui::{
    Area, Color32, CornerRadius, CursorIcon, FontId, Id, Order, Popup, Rect, Response, Role, Sense,
    Stroke, StrokeKind, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::super::thumbs::{Shot, ThumbStage, Thumbs, key_of};
use super::cards::{NAME, in_corner, name_below, picture_of, say};
use super::drops;
use super::upkeep::PartUpkeep;
use crate::commands::{Command, LibraryCommand, PartSpot};
use crate::document::{Look, Ramp, Value};
use crate::panels::layers::{self, LayerPreset};
use crate::state::crashes::DocumentOrigin;
use crate::state::parts::{FoundParts, Part, PartKind};
use crate::state::session::Session;
use crate::widgets::ramp;
use crate::widgets::rows::{self, ICON, Icon, picture_frame, row_ground, whole};
use crate::widgets::theme;

/// Side of a part's picture as drawn, in pixels.
const SIDE: f32 = 200.0;

/// Part that is being dragged: the payload of egui's drag and drop.
#[derive(Clone, Debug)]
pub(crate) struct DraggedPart(pub(crate) Arc<Part>);

/// Card of a part.
pub(super) struct PartCard {
    pub(super) part: Arc<Part>,
    /// Folder that the part was found in; `None` for a part that Chiaro ships.
    pub(super) folder: Option<PathBuf>,
    /// True where the folder's files can be read only.
    is_read_only: bool,
    /// Preset of *Add layer* that the part is; `None` for others.
    pub(super) preset: Option<&'static LayerPreset>,
    /// Look that the part is shown by, with the key of its picture; `None` where there is nothing
    /// to draw.
    look: Option<(Arc<Look>, u64)>,
}

impl PartCard {
    /// Card of a part that was found in a folder; without one, of a part that Chiaro ships.
    pub(super) fn new(part: &Arc<Part>, found: Option<&FoundParts>) -> Self {
        let shown = part.content.as_ref().ok().and_then(|content| content.shown.clone());
        let look = shown.map(|look| {
            let key = key_of(&look, Shot::Whole, SIDE);
            (look, key)
        });
        let folder = found.map(|found| found.folder.clone());
        let is_read_only = found.is_some_and(|found| found.is_read_only);
        Self { part: part.clone(), folder, is_read_only, preset: None, look }
    }

    /// Card of a preset of *Add layer*.
    pub(super) fn of_preset((preset, part): &(&'static LayerPreset, Arc<Part>)) -> Self {
        Self { preset: Some(preset), ..Self::new(part, None) }
    }

    /// Name and description of the part, those that Chiaro brings in the user's language.
    pub(super) fn words(&self) -> [&str; 2] {
        match self.preset {
            Some(preset) => [preset.name.tr(), preset.help.tr()],
            None => [self.part.title(), self.part.shown(&self.part.about)],
        }
    }

    /// Shows the card, with a picture of this side in points.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        side: f32,
        (session, thumbs): (&Session, &Thumbs),
        upkeep: &mut PartUpkeep,
        out: &mut Vec<Command>,
    ) {
        let id = Id::unique("part").with(&self.part.path);
        let (_, rect) = ui.allocate_space(vec2(side, side + NAME));
        let response = ui.interact(rect, id, Sense::click_and_drag());
        let word = self.part.content.as_ref().map_or(tr!("damaged"), |content| content.kind.word());
        let [name, _] = self.words();
        let label = tr!("Part {name}, {word}");
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
        if response.gained_focus() {
            response.scroll_to_me(None);
        }
        if ui.is_rect_visible(rect) {
            self.paint(ui, rect, side, &response, session, thumbs);
        }
        if self.part.content.is_ok() {
            response.dnd_set_drag_payload(DraggedPart(self.part.clone()));
            if response.dragged() {
                ghost(ui, &self.part, session);
            }
        }
        let is_pressed = response.has_focus()
            && ui.input_mut(|input| {
                input.consume_key(eframe::egui::Modifiers::NONE, eframe::egui::Key::Enter)
            });
        if response.clicked() {
            response.request_focus();
        }
        if response.double_clicked() || is_pressed {
            match self.preset {
                Some(preset) => out.extend(layers::add_preset(session, preset.name.english())),
                None => {
                    let place = LibraryCommand::Place(self.part.clone(), PartSpot::Selection);
                    out.push(Command::Library(place));
                }
            }
        }
        if self.folder.is_some() {
            self.keep_up(ui, (rect, side), &response, upkeep, out);
        }
        response.on_hover_ui(|ui| self.help(ui));
    }

    /// Shows the button and the menu that keep a saved part up, and its name while that is changed.
    fn keep_up(
        &self,
        ui: &mut Ui,
        (rect, side): (Rect, f32),
        response: &Response,
        upkeep: &mut PartUpkeep,
        out: &mut Vec<Command>,
    ) {
        let picture = picture_of(rect, side);
        let corner = picture.right_top() + vec2(-ICON - 2.0, 2.0);
        let corner = Rect::from_min_size(corner, vec2(ICON, ICON));
        ui.painter().rect_filled(corner, 4.0, theme::of(ui).panel);
        let label = tr!("More of the part {name}", name = self.part.name);
        let salt = ("more", &self.part.path);
        let mut child = ui.new_child(UiBuilder::new().id_salt(salt).max_rect(corner));
        let more = rows::icon(&mut child, Icon::More, true, &label, tr!("Rename, remove, …"));
        let mut act = |ui: &mut Ui| upkeep.menu(ui, &self.part, self.is_read_only, out);
        Popup::menu(&more).show(&mut act);
        Popup::context_menu(response).show(&mut act);
        if !self.is_read_only {
            upkeep.keys(ui, response, &self.part);
        }
        let name = Rect::from_min_max(pos2(rect.left(), picture.bottom()), rect.max);
        upkeep.field(ui, name, &self.part, out);
    }

    fn paint(
        &self,
        ui: &Ui,
        rect: Rect,
        side: f32,
        response: &Response,
        session: &Session,
        thumbs: &Thumbs,
    ) {
        row_ground(ui, rect.expand(2.0), response, response.dragged());
        let picture = picture_of(rect, side);
        ui.painter().rect_filled(picture, 3.0, theme::of(ui).canvas);
        match (&self.part.content, &self.look) {
            (Err(_), _) => say(ui, picture, tr!("cannot be read")),
            (Ok(_), Some((look, key))) => match thumbs.known(*key) {
                Some(texture) => {
                    ui.painter().image(texture, picture.shrink(1.0), whole(), Color32::WHITE);
                }
                None if thumbs.is_done(*key) || !thumbs.can_draw() => {
                    say(ui, picture, tr!("no picture"));
                }
                None => {
                    thumbs.look_again(ui);
                    say(ui, picture, tr!("drawing…"));
                    let folder = self.part.path.parent().map(PathBuf::from).unwrap_or_default();
                    let origin =
                        || DocumentOrigin::new(&self.part.name, Some(&self.part.path), look);
                    let stage = ThumbStage::default();
                    thumbs.ask_on(*key, origin, (look.clone(), folder), session, &stage, SIDE);
                }
            },
            (Ok(content), None) => match ramp_of(&content.look) {
                Some(ramp) => {
                    ramp::swatch(ui.painter(), picture.shrink(1.0), ramp);
                }
                None => {
                    let nodes = content.look.graph.nodes.len();
                    let text = match content.kind {
                        PartKind::Group => tr!("group").to_owned(),
                        _ => trn!(nodes, "{nodes} node", "{nodes} nodes"),
                    };
                    say(ui, picture, &text);
                }
            },
        }
        picture_frame(ui, picture);
        if let Ok(content) = &self.part.content {
            in_corner(ui, picture, content.kind.word());
        }
        if response.hovered() || response.has_focus() {
            let stroke = Stroke::new(1.5, theme::of(ui).accent);
            ui.painter().rect_stroke(picture, CornerRadius::same(3), stroke, StrokeKind::Inside);
        }
        name_below(ui, rect, picture, self.words()[0], theme::of(ui).text);
    }

    fn help(&self, ui: &mut Ui) {
        ui.set_max_width(320.0);
        let [name, about] = self.words();
        ui.label(eframe::egui::RichText::new(name).strong());
        let mut tell = |text: &str| {
            if !text.is_empty() {
                ui.label(text);
            }
        };
        tell(about);
        match &self.part.content {
            Ok(content) => tell(content.kind.help()),
            Err(why) => tell(why),
        }
        let tags = self.part.shown(&self.part.tags);
        let file = match self.part.is_shipped() {
            true => tr!("Comes with Chiaro").to_owned(),
            false => self.part.path.display().to_string(),
        };
        for text in [tags, file.as_str()] {
            ui.label(eframe::egui::RichText::new(text).small().color(theme::of(ui).dim));
        }
    }
}

/// The ramp that a part is.
fn ramp_of(look: &Look) -> Option<&Ramp> {
    let mut values = look.graph.nodes.values().flat_map(|node| node.values.values());
    let [ramp, None] = [values.next(), values.next()] else { return None };
    if let Some(Value::Ramp(ramp)) = ramp { Some(ramp) } else { None }
}

/// Shows a part at the pointer while it is dragged, and where it would be put.
fn ghost(ui: &Ui, part: &Part, session: &Session) {
    let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
    ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
    let text = match drops::goal(ui.ctx()) {
        Some(goal) => format!("{}: {}", part.title(), drops::words(&goal, session)),
        None => part.title().to_owned(),
    };
    let area = Area::new(Id::unique("part ghost"))
        .order(Order::Tooltip)
        .fixed_pos(at + vec2(12.0, 8.0))
        .interactable(false);
    area.show(ui.ctx(), |ui| {
        let font = FontId::proportional(theme::TEXT_SIZE);
        let galley = ui.painter().layout_no_wrap(text, font, Color32::WHITE);
        let (rect, _) = ui.allocate_exact_size(galley.size() + vec2(16.0, 8.0), Sense::hover());
        ui.painter().rect_filled(rect, 5.0, theme::PLATE);
        ui.painter().galley(pos2(rect.left() + 8.0, rect.top() + 4.0), galley, Color32::WHITE);
    });
}
