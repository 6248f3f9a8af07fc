//! What a look can be made of: nodes by category, and finished looks as pictures. A node is dragged onto the canvas or
//! added by a click; a look opens as a new one.

mod examples;
mod nodes;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui;
use eframe::egui::{Align2, Color32, FontId, Rect, Role, ScrollArea, Sense, TextEdit, Ui, WidgetInfo, pos2, vec2};

use super::super::command::Command;
use super::super::dock::{cell, hint};
use super::super::session::Session;
use super::super::theme;
use super::thumbs::{Shot, Thumbs, key_of};
use super::widgets::{picture_frame, row_ground, whole};
use crate::document::Look;
pub(crate) use examples::EXAMPLES;

/// A node that is being dragged to the canvas: the payload of egui's drag and drop.
#[derive(Clone, Debug)]
pub(crate) struct DraggedKind(pub(crate) String);

/// The least width of a look's picture, and the height of its name.
const CARD: f32 = 96.0;
const NAME: f32 = 20.0;
/// The side of a picture that is drawn, in pixels: cards grow with the panel, and their pictures are not drawn anew.
const SIDE: f32 = 200.0;
/// As many of the files opened before are shown.
const MOST_RECENT: usize = 8;

/// The panel.
#[derive(Default)]
pub(crate) struct Library {
    shows_looks: bool,
    query: String,
    looks: Vec<Card>,
    /// What was opened before, and which files that is.
    recent: Vec<Card>,
    recent_of: Vec<PathBuf>,
}

/// Where a look comes from.
enum Origin {
    Example(usize),
    File(PathBuf),
}

/// A look that can be opened.
struct Card {
    origin: Origin,
    name: String,
    look: Arc<Look>,
    key: u64,
}

impl Library {
    /// Shows nodes or looks.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        ui.horizontal(|ui| {
            ui.selectable_value(&mut self.shows_looks, false, "Nodes").on_hover_text("What looks are made of");
            ui.selectable_value(&mut self.shows_looks, true, "Looks").on_hover_text("Finished looks to begin with");
            let what = if self.shows_looks { "Search looks" } else { "Search nodes" };
            let edit = TextEdit::singleline(&mut self.query).hint_text(what).desired_width(f32::INFINITY);
            let response = ui.add(edit);
            response.widget_info(|| WidgetInfo::labeled(Role::SearchInput, true, what));
        });
        ui.add_space(2.0);
        if self.shows_looks { self.looks(ui, session, thumbs) } else { nodes::show(ui, session, &self.query) }
    }

    /// Learns what was opened before. Files are read when that changes, which is when one is opened or saved.
    pub(crate) fn know_recent<'p>(&mut self, files: impl Iterator<Item = (&'p PathBuf, bool)>) {
        if !self.shows_looks {
            return;
        }
        let there: Vec<PathBuf> = files.filter(|(_, is_there)| *is_there).map(|(path, _)| path.clone()).collect();
        if self.recent_of != there {
            self.recent = there.iter().take(MOST_RECENT).filter_map(|path| recent(path)).collect();
            self.recent_of = there;
        }
    }

    fn looks(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        if self.looks.is_empty() {
            self.looks =
                EXAMPLES.iter().enumerate().filter_map(|(index, (name, text))| card(index, name, text)).collect();
        }
        let words = self.query.to_lowercase();
        let is_found = |card: &&Card| words.split_whitespace().all(|word| card.name.to_lowercase().contains(word));
        let groups = [("Recent", &self.recent), ("Examples", &self.looks)];
        let groups = groups.map(|(title, cards)| (title, cards.iter().filter(is_found).collect::<Vec<&Card>>()));
        let mut out = Vec::new();
        if groups.iter().all(|(_, found)| found.is_empty()) {
            hint(ui, "No look of that name");
            return out;
        }
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("looks").show(ui, |ui| {
            let gap = 6.0;
            let width = ui.available_width() - 8.0;
            let columns = ((width + gap) / (CARD + gap)).floor().max(1.0);
            let side = (width - gap * (columns - 1.0)) / columns;
            ui.spacing_mut().item_spacing = vec2(gap, gap);
            let is_split = groups.iter().all(|(_, found)| !found.is_empty());
            for (title, found) in &groups {
                if is_split {
                    hint(ui, title);
                }
                // One row of what was opened before; a search finds the others.
                let is_short = *title == "Recent" && is_split && words.is_empty();
                let rows = if is_short { 1 } else { usize::MAX };
                for row in found.chunks(columns as usize).take(rows) {
                    ui.horizontal(|ui| {
                        for card in row {
                            show_card(ui, card, side, session, thumbs, &mut out);
                        }
                    });
                }
            }
        });
        out
    }
}

fn recent(path: &Path) -> Option<Card> {
    let look = Look::load(path).value?;
    let key = key_of(&look, Shot::Whole, SIDE);
    let name = path.file_stem()?.to_string_lossy().into_owned();
    Some(Card { origin: Origin::File(path.to_owned()), name, look: Arc::new(look), key })
}

fn card(index: usize, name: &str, text: &str) -> Option<Card> {
    let look = Look::read(text, name).value?;
    let key = key_of(&look, Shot::Whole, SIDE);
    // "figure1-layers" is shown as what the look calls itself, which people search for too.
    let figure = name.split_once('-').map_or(name, |(figure, _)| figure).replace("figure", "Figure ");
    let name = if look.name.is_empty() { name.to_owned() } else { format!("{} · {figure}", look.name) };
    Some(Card { origin: Origin::Example(index), name, look: Arc::new(look), key })
}

fn show_card(ui: &mut Ui, card: &Card, side: f32, session: &Session, thumbs: &Thumbs, out: &mut Vec<Command>) {
    let (rect, response) = ui.allocate_exact_size(vec2(side, side + NAME), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("Open the look {}", card.name)));
    if !ui.is_rect_visible(rect) {
        return;
    }
    row_ground(ui, rect.expand(2.0), &response, false);
    let picture = Rect::from_min_size(rect.min, vec2(side, side));
    ui.painter().rect_filled(picture, 3.0, theme::of(ui).canvas);
    match thumbs.known(card.key) {
        Some(texture) => drop(ui.painter().image(texture, picture.shrink(1.0), whole(), Color32::WHITE)),
        None if thumbs.is_done(card.key) || !thumbs.can_draw() => {
            let font = FontId::proportional(theme::SMALL_TEXT);
            ui.painter().text(picture.center(), Align2::CENTER_CENTER, "no picture", font, theme::of(ui).dim);
        }
        None => {
            thumbs.look_again(ui);
            let folder = match &card.origin {
                Origin::File(path) => path.parent().map(Path::to_path_buf).unwrap_or_default(),
                Origin::Example(_) => PathBuf::new(),
            };
            thumbs.ask(card.key, card.look.clone(), folder, session, Shot::Whole, SIDE);
        }
    }
    picture_frame(ui, picture);
    let name = Rect::from_min_max(pos2(rect.left(), picture.bottom()), rect.max);
    cell(ui, name, &card.name, FontId::proportional(theme::SMALL_TEXT), theme::of(ui).text);
    let clicked = response.clicked();
    let (help, command) = match &card.origin {
        Origin::Example(index) => (
            format!("{}\nOpens it as a new look; the example itself stays as it is", card.name),
            Command::OpenExample(*index),
        ),
        Origin::File(path) => (format!("Opens {}", path.display()), Command::Open(Some(path.clone()))),
    };
    response.on_hover_text(help);
    if clicked {
        out.push(command);
    }
}

/// Takes a node that is let go of over `rect`, the canvas; says what would be added while it is held there.
pub(crate) fn dropped(ui: &Ui, rect: Rect) -> Option<(String, egui::Pos2)> {
    let at = ui.input(|input| input.pointer.latest_pos()).filter(|at| rect.contains(*at))?;
    let held = egui::DragAndDrop::payload::<DraggedKind>(ui.ctx())?;
    if !ui.input(|input| input.pointer.any_released()) {
        return None;
    }
    egui::DragAndDrop::clear_payload(ui.ctx());
    Some((held.0.clone(), at))
}
