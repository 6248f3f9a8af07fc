//! Cards: looks, scenes, shots and paintings as pictures that open when they are pressed, from
//! files and from the examples.

use std::cell::OnceCell;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{tr, tr_in};
use eframe::egui::{
    Align2, Color32, ColorImage, CornerRadius, FontId, Rect, Response, Role, Sense, Stroke,
    TextureHandle, TextureOptions, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::super::thumbs::{Shot, ThumbStage, Thumbs, key_of, key_of_scene, key_of_shot};
use super::examples::{self, Example, Listing, count, example};
use super::words;
use crate::commands::{Command, PAINTING};
use crate::document::{Document, LoadedDocument, Look};
use crate::examples::PREFIX;
use crate::hcbtf::{BytePicture, Cover, cover};
use crate::state::crashes::{CrashLog, CrashStep, DocumentOrigin, Suspect};
use crate::state::session::Session;
use crate::widgets::rows::{fitted, picture_frame, row_ground, whole};
use crate::widgets::text::cell;
use crate::widgets::theme;

/// Height of a card's name, in points.
pub(super) const NAME: f32 = 20.0;

/// Origin of a card's document.
enum CardOrigin {
    /// Example, by its number and its path.
    Example(usize, PathBuf),
    File(PathBuf),
}

/// Content that a card opens.
enum CardContent {
    Look(Arc<Look>),
    Scene,
    Shot,
    Painting(Box<PaintingSummary>),
    /// File that cannot be read; opening it tells why.
    Unreadable,
    /// File that the program crashed on while reading it; opening it says so, and asks.
    HeldBack,
}

/// HCBTF, described by its file's cover.
struct PaintingSummary {
    /// Size of the painting, in a few words.
    size: String,
    /// Description of the painting, in more words.
    about: String,
    picture: Option<BytePicture>,
    texture: OnceCell<TextureHandle>,
}

impl PaintingSummary {
    fn of(cover: Cover) -> Self {
        let Cover { grid, painted, picture } = cover;
        let size = format!("{} x {}", grid.size[0], grid.size[1]);
        let (lights, views) = (grid.light.distinct_count(), grid.view.distinct_count());
        let samples = grid.sample_count();
        let about = tr!(
            "{size} texels, {lights} lights x {views} views, {painted} of {samples} samples painted"
        );
        Self { size, about, picture, texture: OnceCell::new() }
    }

    /// Shows the painting's thumbnail, in its own aspect ratio.
    fn show(&self, ui: &Ui, rect: Rect) {
        let Some(picture) = &self.picture else { return say(ui, rect, tr!("nothing painted")) };
        let texture = self.texture.get_or_init(|| {
            let size = picture.size.map(|side| side as usize);
            let image = ColorImage::from_rgba_unmultiplied(size, &picture.rgba);
            let options = TextureOptions {
                minification: TextureOptions::LINEAR.minification,
                ..TextureOptions::NEAREST
            };
            ui.ctx().load_texture("thumbnail", image, options)
        });
        ui.painter().image(texture.id(), fitted(rect, picture.size), whole(), Color32::WHITE);
    }
}

/// Card of a look, a scene, a shot or a painting that can be opened.
pub(crate) struct Card {
    origin: CardOrigin,
    /// Name that crashes are recorded under, in English.
    name: String,
    /// Name of the document and number of the figure, for an example that is one.
    figure: Option<(String, &'static str)>,
    /// Words that say more, to find the card by.
    tags: String,
    /// Paragraph on what is shown, in English; empty for none.
    about: String,
    content: CardContent,
    key: u64,
    /// Stage that a look's picture is drawn on; `None` for that of the window.
    stage: Option<ThumbStage>,
    /// Side of the picture, in pixels. Cards grow with their panel, and their pictures are not
    /// drawn anew.
    side: f32,
}

impl Card {
    /// Cards of all examples, with pictures `side` pixels wide.
    pub(crate) fn examples(side: f32, session: &Session) -> Vec<Self> {
        let listing = Listing::new();
        let card = |index: usize| {
            let Example { stem, path, content } = example(index)?;
            // "figure1-layers" is shown under the look's own name, which people search for too.
            let figure = stem
                .strip_prefix("figure")
                .map(|rest| rest.split_once('-').map_or(rest, |(number, _)| number));
            let listed = path.to_str().and_then(|path| path.strip_prefix(PREFIX));
            let stage = listing.stage(listed.unwrap_or_default());
            let (name, about, content, key) = match content {
                examples::ExampleContent::Look(look) => {
                    let mut hasher = DefaultHasher::new();
                    (key_of(&look, Shot::Whole, side), &stage).hash(&mut hasher);
                    let (name, about) = (look.name.clone(), look.about.clone());
                    (name, about, CardContent::Look(Arc::new(look)), hasher.finish())
                }
                examples::ExampleContent::Scene(scene) => {
                    let key = key_of_scene(&path, &scene, session, side);
                    (scene.name, scene.about, CardContent::Scene, key)
                }
                examples::ExampleContent::Shot(shot) => {
                    let key = key_of_shot(&path, session, side);
                    (shot.name, shot.about, CardContent::Shot, key)
                }
            };
            let figure = figure.filter(|_| !name.is_empty()).map(|number| (name.clone(), number));
            let name = match &figure {
                Some((name, number)) => format!("{name} · Figure {number}"),
                None if name.is_empty() => stem.to_owned(),
                None => name,
            };
            let tags = listing.tags(listed.unwrap_or_default());
            let origin = CardOrigin::Example(index, path);
            let stage = Some(stage);
            Some(Self { origin, name, figure, tags, about, content, key, stage, side })
        };
        (0..count()).filter_map(card).collect()
    }

    /// Card of a file. The read is noted in the session's log of crashes, and a file that the
    /// program crashed on last time is not read.
    pub(crate) fn of_file(path: &Path, side: f32, session: &Session) -> Self {
        let files = &**session.assets.source();
        let origin = CardOrigin::File(path.to_owned());
        let Some(_going) = session.journals.crashes.begin_to_read(path) else {
            return Self::of_content(origin, name_of(path), CardContent::HeldBack, 0, side);
        };
        if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(PAINTING)) {
            let content = cover(files, path).map_or(CardContent::Unreadable, |cover| {
                CardContent::Painting(Box::new(PaintingSummary::of(cover)))
            });
            return Self::of_content(origin, name_of(path), content, 0, side);
        }
        let (content, key) = match Document::load(files, path) {
            Document::Look(LoadedDocument { value: Some(look), .. }) => {
                let key = key_of(&look, Shot::Whole, side);
                (CardContent::Look(Arc::new(look)), key)
            }
            Document::Scene(LoadedDocument { value: Some(scene), .. }) => {
                (CardContent::Scene, key_of_scene(path, &scene, session, side))
            }
            Document::Shot(LoadedDocument { value: Some(_), .. }) => {
                (CardContent::Shot, key_of_shot(path, session, side))
            }
            _ => (CardContent::Unreadable, 0),
        };
        Self::of_content(origin, name_of(path), content, key, side)
    }

    /// Card with nothing to find it by but its name.
    fn of_content(
        origin: CardOrigin,
        name: String,
        content: CardContent,
        key: u64,
        side: f32,
    ) -> Self {
        let [tags, about] = [String::new(), String::new()];
        let (figure, stage) = (None, None);
        Self { origin, name, figure, tags, about, content, key, stage, side }
    }

    /// Name as it is shown.
    fn title(&self) -> String {
        match (&self.figure, &self.origin) {
            (Some((name, figure)), _) => {
                tr!("{name} · Figure {figure}", name = tr_in("example", name))
            }
            (None, CardOrigin::Example(..)) => tr_in("example", &self.name).to_owned(),
            (None, CardOrigin::File(_)) => self.name.clone(),
        }
    }

    /// Rank of the card in a search, 0 best; `None` where a word of the query begins no word of the
    /// card, nor of `more`.
    fn rank(&self, query: &str, more: &str) -> Option<usize> {
        let both = |text: &str| format!("{text} {}", tr_in("example", text));
        let name = format!("{} {}", self.name, self.title());
        words::rank(query, &[&name, &both(&self.tags), &both(more), &both(&self.about)])
    }

    /// Name of the card's example, as the gallery lists it; `None` for a file.
    pub(crate) fn example_name(&self) -> Option<&str> {
        match &self.origin {
            CardOrigin::Example(_, path) => path.to_str()?.strip_prefix(PREFIX),
            CardOrigin::File(_) => None,
        }
    }

    /// Path of the card's file; `None` for an example.
    fn path(&self) -> Option<&Path> {
        match &self.origin {
            CardOrigin::File(path) => Some(path),
            CardOrigin::Example(..) => None,
        }
    }

    /// True if the file could be read.
    pub(crate) fn is_readable(&self) -> bool {
        !matches!(self.content, CardContent::Unreadable)
    }

    /// Shows the card, with a picture of this side in points.
    pub(crate) fn show(
        &self,
        ui: &mut Ui,
        side: f32,
        session: &Session,
        thumbs: &Thumbs,
        out: &mut Vec<Command>,
    ) -> Response {
        let (rect, response) = ui.allocate_exact_size(vec2(side, side + NAME), Sense::click());
        let suspect = self.suspect(&session.journals.crashes);
        let name = self.title();
        let label = match self.content {
            CardContent::Scene => tr!("Open the scene {name}"),
            CardContent::Shot => tr!("Open the shot {name}"),
            CardContent::Painting(_) => tr!("Open the painting {name}"),
            _ => tr!("Open the look {name}"),
        };
        let label = match suspect.as_ref().map(|suspect| suspect.step) {
            None => label,
            Some(CrashStep::Read) => tr!("{label}, which was not read"),
            Some(_) => tr!("{label}, which was not drawn"),
        };
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, label.clone()));
        if response.gained_focus() {
            response.scroll_to_me(None);
        }
        if !ui.is_rect_visible(rect) {
            return response;
        }
        row_ground(ui, rect.expand(2.0), &response, false);
        let picture = picture_of(rect, side);
        ui.painter().rect_filled(picture, 3.0, theme::of(ui).canvas);
        let held = suspect.as_ref().map(|suspect| suspect.step);
        let held = if matches!(self.content, CardContent::HeldBack) {
            Some(CrashStep::Read)
        } else {
            held
        };
        match (&self.content, thumbs.known(self.key)) {
            _ if held.is_some() => held_back(ui, picture, held.unwrap_or(CrashStep::Read)),
            (CardContent::Unreadable, _) => say(ui, picture, tr!("cannot be read")),
            (CardContent::Painting(painting), _) => {
                painting.show(ui, picture.shrink(1.0));
                in_corner(ui, picture, &painting.size);
            }
            (_, Some(texture)) => {
                ui.painter().image(texture, picture.shrink(1.0), whole(), Color32::WHITE);
            }
            (_, None) if thumbs.is_done(self.key) || !thumbs.can_draw() => {
                let text = match self.content {
                    CardContent::Scene => tr!("a scene"),
                    CardContent::Shot => tr!("a shot"),
                    _ => tr!("no picture"),
                };
                say(ui, picture, text);
            }
            (_, None) => {
                thumbs.look_again(ui);
                say(ui, picture, tr!("drawing…"));
                self.ask(session, thumbs);
            }
        }
        picture_frame(ui, picture);
        if response.hovered() {
            let stroke = Stroke::new(1.5, theme::of(ui).accent);
            ui.painter().rect_stroke(
                picture,
                CornerRadius::same(3),
                stroke,
                eframe::egui::StrokeKind::Inside,
            );
        }
        name_below(ui, rect, picture, &name, theme::of(ui).text);
        if response.clicked() {
            out.push(match &self.origin {
                CardOrigin::Example(index, _) => Command::OpenExample(*index),
                CardOrigin::File(path) => Command::Open(Some(path.clone())),
            });
        }
        response.on_hover_text(self.help(suspect.as_ref()))
    }

    /// Description of what is opened, and of the crash that is suspected of it.
    fn help(&self, suspect: Option<&Suspect>) -> String {
        let path = match &self.origin {
            CardOrigin::File(path) => path,
            CardOrigin::Example(..) => {
                let opens = match self.content {
                    CardContent::Scene => {
                        tr!("Opens it as a new scene; the example itself stays as it is")
                    }
                    CardContent::Shot => {
                        tr!("Opens it as a new shot; the example itself stays as it is")
                    }
                    _ => tr!("Opens it as a new look; the example itself stays as it is"),
                };
                let about = tr_in("example", &self.about);
                return format!("{}\n{about}\n\n{opens}", self.title());
            }
        };
        let mut lines = vec![tr!("Opens {file}", file = path.display())];
        if let CardContent::Painting(painting) = &self.content {
            lines.push(painting.about.clone());
        }
        let ended = suspect.map(|suspect| match suspect.step {
            CrashStep::Read => tr!("Chiaro ended while reading this file the last time"),
            _ => tr!(
                "Chiaro ended while drawing this file the last time: it is opened without being \
                 drawn"
            ),
        });
        lines.extend(ended.map(str::to_owned));
        lines.join("\n")
    }

    /// Crash that is suspected of this card's document.
    fn suspect(&self, crashes: &CrashLog) -> Option<Suspect> {
        if crashes.is_any() { crashes.suspect(&self.document()?) } else { None }
    }

    /// Document under which crashes are recorded.
    fn document(&self) -> Option<DocumentOrigin> {
        match (&self.content, &self.origin) {
            (CardContent::Painting(_) | CardContent::Unreadable, _) => None,
            (_, CardOrigin::File(path)) => Some(DocumentOrigin::of_file(path)),
            (CardContent::Look(look), CardOrigin::Example(..)) => {
                Some(DocumentOrigin::new(&self.name, None, look))
            }
            (_, CardOrigin::Example(_, path)) => Some(DocumentOrigin::of_file(path)),
        }
    }

    /// Requests the card's picture.
    fn ask(&self, session: &Session, thumbs: &Thumbs) {
        match (&self.content, &self.origin) {
            (CardContent::Look(look), origin) => {
                let folder = match origin {
                    CardOrigin::File(path) => {
                        path.parent().map(Path::to_path_buf).unwrap_or_default()
                    }
                    CardOrigin::Example(..) => PathBuf::new(),
                };
                let document = || DocumentOrigin::new(&self.name, self.path(), look);
                let (key, look, side) = (self.key, (look.clone(), folder), self.side);
                match &self.stage {
                    Some(stage) => thumbs.ask_on(key, document, look, session, stage, side),
                    None => thumbs.ask(key, document, look, session, Shot::Whole, side),
                }
            }
            (
                CardContent::Scene | CardContent::Shot,
                CardOrigin::File(path) | CardOrigin::Example(_, path),
            ) => {
                thumbs.ask_for_scene(self.key, path, session, self.side);
            }
            (CardContent::Painting(_) | CardContent::Unreadable | CardContent::HeldBack, _) => {}
        }
    }
}

/// Cards that a query finds by their own words, or by `more`; the best first.
pub(crate) fn found<'c>(cards: &'c [Card], query: &str, more: &str) -> Vec<&'c Card> {
    let with_rank = |card: &'c Card| Some((card.rank(query, more)?, card));
    let mut found: Vec<(usize, &Card)> = cards.iter().filter_map(with_rank).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, card)| card).collect()
}

/// Shows a card for a file that was open once and no longer exists.
pub(crate) fn show_gone(ui: &mut Ui, path: &Path, side: f32, out: &mut Vec<Command>) {
    let name = name_of(path);
    let (rect, response) = ui.allocate_exact_size(vec2(side, side + NAME), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, tr!("{name} is gone")));
    let picture = picture_of(rect, side);
    picture_frame(ui, picture);
    say(ui, picture.translate(vec2(0.0, -12.0)), tr!("gone"));
    name_below(ui, rect, picture, &name, theme::of(ui).dim);
    let size = vec2(68.0, ui.spacing().interact_size.y);
    let button = Rect::from_center_size(picture.center() + vec2(0.0, 14.0), size);
    // A widget that is put into the row itself would move what comes next under this card.
    let mut inside = ui.new_child(UiBuilder::new().id_salt(path).max_rect(rect));
    let forget = inside.put(button, eframe::egui::Button::new(tr!("Forget")));
    forget.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Forget {name}")));
    if forget.on_hover_text(tr!("Takes it off this list")).clicked() {
        out.push(Command::Forget(path.to_owned()));
    }
    response.on_hover_text(tr!("{file} was moved or removed", file = path.display()));
}

/// Name of a file as shown here.
fn name_of(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Rectangle of a card's picture: at the top.
pub(super) fn picture_of(card: Rect, side: f32) -> Rect {
    Rect::from_min_size(card.min, vec2(side, side))
}

/// Shows words in place of a picture.
pub(super) fn say(ui: &Ui, picture: Rect, text: &str) {
    let font = FontId::proportional(theme::SMALL_TEXT);
    ui.painter().text(picture.center(), Align2::CENTER_CENTER, text, font, theme::of(ui).dim);
}

/// Shows a warning sign in place of a picture that the program crashed on.
fn held_back(ui: &Ui, picture: Rect, step: CrashStep) {
    let colors = theme::of(ui);
    let (center, side) = (picture.center() - vec2(0.0, 14.0), 18.0);
    let corner =
        |turn: f32| center + side * eframe::egui::Vec2::angled(turn - std::f32::consts::FRAC_PI_2);
    let third = std::f32::consts::TAU / 3.0;
    let triangle = [0.0, third, 2.0 * third].map(corner).to_vec();
    ui.painter().add(eframe::egui::Shape::closed_line(triangle, Stroke::new(1.5, colors.warning)));
    let bold = FontId::proportional(theme::TEXT_SIZE);
    ui.painter().text(center + vec2(0.0, 1.0), Align2::CENTER_CENTER, "!", bold, colors.warning);
    say(ui, picture.translate(vec2(0.0, 12.0)), undone(step));
}

/// Words for the step that is skipped for a document that the program crashed on.
fn undone(step: CrashStep) -> &'static str {
    if step == CrashStep::Read { tr!("not read") } else { tr!("not drawn") }
}

/// Shows words over a picture, in its lower left corner.
pub(super) fn in_corner(ui: &Ui, picture: Rect, text: &str) {
    let galley = ui.painter().layout_no_wrap(
        text.to_owned(),
        FontId::proportional(theme::SMALL_TEXT),
        Color32::WHITE,
    );
    let at = picture.left_bottom() + vec2(6.0, -galley.size().y - 5.0);
    ui.painter().rect_filled(
        Rect::from_min_size(at, galley.size()).expand2(vec2(4.0, 1.0)),
        3.0,
        theme::PLATE,
    );
    ui.painter().galley(at, galley, Color32::WHITE);
}

pub(super) fn name_below(ui: &Ui, card: Rect, picture: Rect, name: &str, color: Color32) {
    let rect = Rect::from_min_max(pos2(card.left(), picture.bottom()), card.max);
    cell(ui, rect, name, FontId::proportional(theme::SMALL_TEXT), color);
}

/// Number of cards that fit beside each other with at least the side `least`, and the side that
/// they then have, in points.
pub(crate) fn columns(width: f32, least: f32, gap: f32) -> (usize, f32) {
    let columns = ((width + gap) / (least + gap)).floor().max(1.0);
    (columns as usize, ((width - gap * (columns - 1.0)) / columns).max(1.0))
}
