//! Start page, for newcomers and for everyone who opens the window without a file: a new look, the
//! tours, recent files, and all examples as pictures, by subject and with a search. The page takes
//! the place of the panels, and leaves as soon as a document is opened or made.

use std::collections::HashMap;
use std::path::PathBuf;

use chiaro_locale::{Text, text, tr, tr_in};
use eframe::egui;
use eframe::egui::{
    Button, EventFilter, FontId, Key, Label, Modifiers, Rect, Response, RichText, Role, ScrollArea,
    Sense, Stroke, StrokeKind, TextEdit, TextureHandle, Ui, WidgetInfo, pos2, vec2,
};

use super::library::cards::{self, Card};
use super::thumbs::Thumbs;
use crate::commands::table::{self, CommandRow};
use crate::commands::{Command, PanelId, TourTopic};
use crate::examples::{Subject, subjects};
use crate::panels::{PanelContext, Workbench};
use crate::state::revision::SuspectsRevision;
use crate::state::session::Session;
use crate::widgets::rows::whole;
use crate::widgets::text::hint;
use crate::widgets::theme;

/// Margin around the page, in points; less in a narrow window.
const MARGIN: f32 = 36.0;
/// Largest width of the page, in points.
const WIDEST: f32 = 1380.0;
/// Width from which on the tiles stand beside the title, in points.
const WIDE: f32 = 1290.0;
/// Gap between cards, in points.
const GAP: f32 = 14.0;
/// Least width of a look's picture, in points; below, the side that the picture is drawn with, in
/// pixels.
const CARD: f32 = 200.0;
const SIDE: f32 = 320.0;
/// Side of the program's icon, in points.
const LOGO: f32 = 72.0;
/// Size of a tile, in points.
const TILE: egui::Vec2 = vec2(192.0, 72.0);
/// Largest number of recent files that are shown.
const MOST_RECENT: usize = 12;

/// The page, and its cards.
#[derive(Default)]
pub(crate) struct Start {
    examples: Vec<ExampleSection>,
    /// Words that the shown cards have in their names, tags or subjects; empty for all.
    query: String,
    /// Title in English of the only subject that is shown; `None` for all.
    subject: Option<&'static str>,
    recent: Vec<RecentFile>,
    /// Revision of the suspects when the recent files were read.
    suspects: SuspectsRevision,
    logo: Option<TextureHandle>,
    /// True if the page was shown in the last frame; each time it appears it begins at its top.
    is_seen: bool,
}

/// Examples of one subject.
struct ExampleSection {
    /// Title in English, by which the subject is chosen.
    title: &'static str,
    about: &'static str,
    cards: Vec<Card>,
}

impl ExampleSection {
    /// All examples by subject.
    fn all(session: &Session) -> Vec<Self> {
        let subjects = subjects();
        let section = |subject: &Subject| Self {
            title: subject.title,
            about: subject.about,
            cards: Vec::new(),
        };
        let mut sections: Vec<Self> = subjects.iter().map(section).collect();
        let mut places = HashMap::new();
        for (index, subject) in subjects.iter().enumerate() {
            places.extend(subject.examples.iter().map(|(name, _)| (*name, index)));
        }
        for card in Card::examples(SIDE, session) {
            let place = card.example_name().and_then(|name| places.get(name)).copied();
            if let Some(section) = place.and_then(|place| sections.get_mut(place)) {
                section.cards.push(card);
            }
        }
        sections
    }

    /// Cards that a query finds, the best first.
    fn found(&self, query: &str) -> Vec<&Card> {
        cards::found(&self.cards, query, self.title)
    }
}

/// File that was opened before.
struct RecentFile {
    path: PathBuf,
    /// Card of the file; `None` where the file is gone.
    card: Option<Card>,
}

/// Tile: a way to begin.
struct StartTile {
    title: Text,
    text: Text,
    command: Command,
    /// True for the tile that newcomers are led to.
    is_first: bool,
}

static TILES: [StartTile; 5] = [
    StartTile {
        title: text!("Take the tour"),
        text: text!("Your first look, from nothing, in two minutes"),
        command: Command::StartTour(TourTopic::Look),
        is_first: true,
    },
    StartTile {
        title: text!("New look"),
        text: text!("A base and one light to begin with"),
        command: Command::New,
        is_first: false,
    },
    StartTile {
        title: text!("Light a scene"),
        text: text!("Three gray objects: key, rim, shadows, links, mixer"),
        command: Command::StartTour(TourTopic::Lights),
        is_first: false,
    },
    StartTile {
        title: text!("Paint a surface"),
        text: text!("A tile for every light and every side, by hand"),
        command: Command::ShowPanel(PanelId::PAINT),
        is_first: false,
    },
    StartTile {
        title: text!("Open a file"),
        text: text!("A look, a scene, a shot or a painting, yours or others'"),
        command: Command::Open(None),
        is_first: false,
    },
];

/// Shows the start page in place of the panels.
pub(crate) fn show(
    bench: &mut Workbench,
    ui: &mut Ui,
    PanelContext { session, safety }: PanelContext<'_>,
) -> Vec<Command> {
    let start = bench.memory.of::<Start>();
    start.know_recent(safety.recent(), session);
    start.show(ui, session, &bench.thumbs)
}

impl Start {
    /// Updates the recent files. Files are read only when the list changes.
    fn know_recent<'p>(
        &mut self,
        files: impl Iterator<Item = (&'p PathBuf, bool)>,
        session: &Session,
    ) {
        let crashes = &session.journals.crashes;
        let now: Vec<(&PathBuf, bool)> = files.take(MOST_RECENT).collect();
        let is_same = std::mem::replace(&mut self.suspects, crashes.suspects_revision())
            == crashes.suspects_revision()
            && now.len() == self.recent.len()
            && now.iter().zip(&self.recent).all(|((path, is_there), known)| {
                **path == known.path && *is_there == known.card.is_some()
            });
        if !is_same {
            let card = |(path, is_there): (&PathBuf, bool)| RecentFile {
                path: path.clone(),
                card: is_there.then(|| Card::of_file(path, SIDE, session)),
            };
            self.recent = now.into_iter().map(card).collect();
        }
    }

    /// Forgets the content of the files, so that they are read anew when the page is shown the next
    /// time.
    pub(crate) fn rest(&mut self) {
        self.recent.clear();
        self.is_seen = false;
    }

    /// Shows the page.
    fn show(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        if self.examples.is_empty() {
            self.examples = ExampleSection::all(session);
        }
        let mut out = Vec::new();
        ui.painter().rect_filled(ui.max_rect(), 0.0, theme::of(ui).panel);
        let mut area = ScrollArea::vertical().auto_shrink([false, false]).id_salt("start");
        let is_new = !std::mem::replace(&mut self.is_seen, true);
        if is_new {
            area = area.vertical_scroll_offset(0.0);
        }
        area.show(ui, |ui| {
            let room = ui.available_width();
            let width = (room - 2.0 * MARGIN.min(room * 0.04)).min(WIDEST);
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing = egui::Vec2::ZERO;
                ui.add_space((room - width) / 2.0);
                ui.vertical(|ui| {
                    ui.set_width(width);
                    ui.add_space(MARGIN.min(room * 0.03));
                    let first = self.head(ui, width, &mut out);
                    ui.add_space(GAP);
                    self.search(ui, is_new);
                    take_focus(ui, &first);
                    self.looks(ui, width, session, thumbs, &mut out);
                });
            });
        });
        out
    }

    /// Shows the title and the tiles; returns the response of the first tile.
    fn head(&mut self, ui: &mut Ui, width: f32, out: &mut Vec<Command>) -> Response {
        let mut first = None;
        ui.horizontal_top(|ui| {
            self.title(ui);
            let beside = width - ui.cursor().min.x + ui.min_rect().left();
            if width >= WIDE {
                // The tiles end at the right where the cards end.
                let tiles = (TILE.x + GAP) * TILES.len() as f32;
                ui.add_space((beside - tiles - 2.0 * GAP).max(0.0));
                ui.vertical(|ui| {
                    ui.add_space((LOGO - TILE.y) / 2.0);
                    first = tiles_in(ui, TILES.len(), TILE, out);
                });
                ui.add_space(GAP);
            } else {
                ui.add_space((beside - 24.0).max(0.0));
            }
            let close = ui.add(Button::new(RichText::new("×").size(24.0)).frame(false));
            close.widget_info(|| {
                WidgetInfo::labeled(Role::Button, true, tr!("Close the start page"))
            });
            if close.on_hover_text(tr!("To the look that is open (Esc)")).clicked() {
                out.push(Command::ShowStart(false));
            }
        });
        if first.is_none() {
            ui.add_space(GAP);
            let (columns, tile) = cards::columns(width, TILE.x, GAP);
            first = tiles_in(ui, columns.min(TILES.len()), vec2(tile, TILE.y), out);
        }
        first.unwrap_or_else(|| ui.allocate_response(egui::Vec2::ZERO, Sense::hover()))
    }

    fn title(&mut self, ui: &mut Ui) {
        let logo = self.logo.get_or_insert_with(|| {
            let image = egui::ColorImage::from(crate::icon());
            ui.ctx().load_texture("logo", image, egui::TextureOptions::LINEAR)
        });
        let (rect, _) = ui.allocate_exact_size(vec2(LOGO, LOGO), Sense::hover());
        ui.painter().image(logo.id(), rect, whole(), egui::Color32::WHITE);
        ui.add_space(GAP);
        ui.vertical(|ui| {
            ui.add_space(6.0);
            ui.label(RichText::new("Chiaro").size(34.0).strong());
            ui.label(RichText::new(tr!("Draw with light")).size(15.0).color(theme::of(ui).dim));
        });
    }

    fn looks(
        &mut self,
        ui: &mut Ui,
        width: f32,
        session: &Session,
        thumbs: &Thumbs,
        out: &mut Vec<Command>,
    ) {
        let (columns, side) = cards::columns(width, CARD, GAP);
        let is_recent_shown =
            self.subject.is_none() && self.query.trim().is_empty() && !self.recent.is_empty();
        if is_recent_shown {
            heading(
                ui,
                tr!("Recent"),
                tr!("Looks, scenes, shots and paintings that were open, the newest first"),
            );
            for row in self.recent.chunks(columns) {
                in_row(ui, row, |ui, recent| match &recent.card {
                    Some(card) => {
                        let response = card.show(ui, side, session, thumbs, out);
                        response.context_menu(|ui| {
                            if ui
                                .button(tr!("Forget"))
                                .on_hover_text(tr!("Takes it off this list; the file stays"))
                                .clicked()
                            {
                                out.push(Command::Forget(recent.path.clone()));
                            }
                        });
                    }
                    None => cards::show_gone(ui, &recent.path, side, out),
                });
            }
        }
        heading(
            ui,
            tr!("Examples"),
            tr!("Each opens as a new one of your own: change whatever you like"),
        );
        let mut is_empty = true;
        let is_chosen =
            |section: &&ExampleSection| self.subject.is_none_or(|subject| subject == section.title);
        for section in self.examples.iter().filter(is_chosen) {
            let found = section.found(&self.query);
            if found.is_empty() {
                continue;
            }
            is_empty = false;
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 10.0;
                ui.label(RichText::new(tr_in("example", section.title)).strong());
                let about =
                    RichText::new(tr_in("example", section.about)).small().color(theme::of(ui).dim);
                ui.add(Label::new(about).truncate());
            });
            ui.add_space(4.0);
            for row in found.chunks(columns) {
                in_row(ui, row, |ui, card| drop(card.show(ui, side, session, thumbs, out)));
            }
        }
        if is_empty {
            hint(ui, tr!("No example has these words in its name, its tags or its description."));
        }
        ui.add_space(GAP);
        let text = tr!(
            "Drop a look, a mesh or an image on the window to open it · Ctrl+P finds any command"
        );
        ui.label(RichText::new(text).color(theme::of(ui).dim));
        ui.add_space(MARGIN);
    }

    /// Shows the field that searches the examples, and the subjects; the field has the focus when
    /// the page appears.
    fn search(&mut self, ui: &mut Ui, is_new: bool) {
        let edit = TextEdit::singleline(&mut self.query)
            .hint_text(tr!("Find: anime, watercolor, shadow, hatching"))
            .desired_width(320.0)
            .char_limit(100);
        let response = ui.add(edit);
        // Up and down lead on to the cards, as from everything else on the page.
        let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, tr!("Find an example")));
        if is_new && ui.memory(|memory| memory.focused().is_none()) {
            response.request_focus();
        }
        ui.add_space(6.0);
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
            ui.selectable_value(&mut self.subject, None, tr!("All"));
            for section in &self.examples {
                let title = tr_in("example", section.title);
                let chip = ui.selectable_value(&mut self.subject, Some(section.title), title);
                chip.on_hover_text(tr_in("example", section.about));
            }
        });
    }
}

/// Shows the tiles, `columns` beside each other; returns the response of the first tile.
fn tiles_in(
    ui: &mut Ui,
    columns: usize,
    size: egui::Vec2,
    out: &mut Vec<Command>,
) -> Option<Response> {
    let mut first = None;
    for row in TILES.chunks(columns.max(1)) {
        in_row(ui, row, |ui, tile| {
            let response = tile.show(ui, size);
            if response.clicked() {
                out.push(tile.command.clone());
            }
            first.get_or_insert(response);
        });
    }
    first
}

impl StartTile {
    fn show(&self, ui: &mut Ui, size: egui::Vec2) -> Response {
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, self.title.tr()));
        let colors = theme::of(ui);
        let is_near = response.hovered() || response.has_focus();
        let fill = match (self.is_first, is_near) {
            (true, false) => colors.accent_dim,
            (true, true) => colors.accent_dim.lerp_to_gamma(colors.accent, 0.25),
            (false, false) => colors.field,
            (false, true) => colors.field_hovered,
        };
        ui.painter().rect_filled(rect, 6.0, fill);
        if response.has_focus() {
            ui.painter().rect_stroke(
                rect,
                6.0,
                Stroke::new(1.5, colors.accent),
                StrokeKind::Inside,
            );
        }
        let inner = rect.shrink2(vec2(14.0, 10.0));
        let dim = if self.is_first { colors.text } else { colors.dim };
        let painter = ui.painter().with_clip_rect(rect);
        let title = painter.layout_no_wrap(
            self.title.tr().to_owned(),
            FontId::proportional(15.0),
            colors.text,
        );
        let keys = table::row_of(&self.command).map(CommandRow::text).unwrap_or_default();
        let small = FontId::proportional(theme::SMALL_TEXT);
        let keys = painter.layout_no_wrap(keys, small.clone(), dim);
        let text = painter.layout(self.text.tr().to_owned(), small, dim, inner.width());
        let middle = inner.top() + title.size().y / 2.0;
        painter.galley(
            pos2(inner.right() - keys.size().x, middle - keys.size().y / 2.0),
            keys,
            dim,
        );
        let below = inner.top() + title.size().y + 4.0;
        painter.galley(inner.left_top(), title, colors.text);
        painter.galley(pos2(inner.left(), below), text, dim);
        response
    }
}

/// Shows items beside each other, and a gap below.
fn in_row<T>(ui: &mut Ui, row: &[T], mut show: impl FnMut(&mut Ui, &T)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        for each in row {
            show(ui, each);
        }
    });
    ui.add_space(GAP);
}

fn heading(ui: &mut Ui, title: &str, help: &str) {
    ui.add_space(GAP);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 10.0;
        ui.label(RichText::new(title).heading());
        ui.label(RichText::new(help).color(theme::of(ui).dim));
    });
    let rect =
        Rect::from_min_size(ui.cursor().min + vec2(0.0, 4.0), vec2(ui.available_width(), 1.0));
    ui.painter().hline(rect.x_range(), rect.top(), Stroke::new(1.0, theme::of(ui).grid));
    ui.add_space(GAP);
}

/// Moves the focus to the first tile on an arrow key, where no widget has the focus; from there
/// egui handles the arrow keys.
fn take_focus(ui: &Ui, first: &Response) {
    let arrows = [Key::ArrowDown, Key::ArrowRight];
    let is_free = ui.memory(|memory| memory.focused().is_none());
    if is_free
        && arrows.iter().any(|key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, *key)))
    {
        first.request_focus();
        // egui would otherwise move the focus once more by the same key.
        ui.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
    }
}
