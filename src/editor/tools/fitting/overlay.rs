//! Overlay of the strokes over the picture: their goals, their outlines, and where the look misses
//! them.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    Align2, Color32, ColorImage, Context, CursorIcon, FontId, Pos2, Rect, Response, Role, Stroke,
    TextureHandle, TextureId, TextureOptions, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use glam::DVec2;

use super::FitTool;
use super::ground::GroundInputs;
use super::target;
use super::veil::strokes;
use crate::commands::{Command, FitCommand};
use crate::document::Tile;
use crate::fit::picture_of;
use crate::state::session::Session;
use crate::widgets::rows::whole;
use crate::widgets::theme;

/// Key of a texture of strokes.
#[derive(PartialEq)]
struct StrokesTextureKey {
    tile: usize,
    moment: Option<GroundInputs>,
    outlines_only: bool,
}

/// Textures of the overlay.
#[derive(Default)]
pub(super) struct Textures {
    strokes: Option<(StrokesTextureKey, Arc<Tile>, TextureHandle)>,
    misses: Option<(StrokesTextureKey, TextureHandle)>,
    ground: Option<(GroundInputs, TextureHandle)>,
}

impl FitTool {
    /// Paints the ground as the picture, where no GPU draws one. Returns false if there is none.
    pub(crate) fn stand_in(&mut self, ui: &Ui, rect: Rect) -> bool {
        let (Some(ground), Some(moment)) =
            (self.grounds.latest().filter(|_| self.is_on), self.grounds.moment())
        else {
            return false;
        };
        let known = self
            .textures
            .ground
            .as_ref()
            .filter(|(of, _)| of == moment)
            .map(|(_, handle)| handle.id());
        let texture = known.unwrap_or_else(|| {
            let handle =
                ui.ctx().load_texture("ground", ground.image.clone(), TextureOptions::LINEAR);
            let id = handle.id();
            self.textures.ground = Some((moment.clone(), handle));
            id
        });
        ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
        ui.painter_at(rect).image(
            texture,
            Self::canvas(rect, ground.size),
            whole(),
            Color32::WHITE,
        );
        true
    }

    /// Shows the strokes, the misses, the brush, and messages over the picture.
    pub(super) fn show_over(
        &mut self,
        ui: &mut Ui,
        response: &Response,
        rect: Rect,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let is_here = Self::is_at_view(session);
        let canvas = Self::canvas(rect, self.size(session));
        let painter = ui.painter_at(rect);
        if is_here {
            if let Some(texture) = self.misses(ui.ctx()).filter(|_| self.shows.misses) {
                painter.image(texture, canvas, whole(), Color32::from_white_alpha(225));
            }
            if let Some(texture) = self.strokes(ui.ctx(), session) {
                painter.image(texture, canvas, whole(), Color32::WHITE);
            }
        }
        let shows_misses = self.shows.misses && is_here && !self.goals().is_empty();
        let tags = [
            (shows_misses, tr!("Black: as painted. Red to white: off by up to 25/255 and more")),
            (self.awaits(), tr!("Preview of the fit: apply or discard it")),
            (self.waiting.is_some(), tr!("Reading the picture: the stroke comes with it")),
        ];
        let mut corner = rect.left_bottom() + vec2(8.0, -8.0);
        for (_, text) in tags.into_iter().filter(|(is_seen, _)| *is_seen) {
            corner.y = tag(ui, corner, text);
        }
        self.hint = "";
        if !is_here {
            elsewhere(ui, rect, out);
            self.hint = tr!("The strokes belong to another view");
            return;
        }
        let pointer = response
            .contains_pointer()
            .then(|| ui.input(|input| input.pointer.hover_pos()))
            .flatten();
        let is_at_work = self.going.is_some() || self.waiting.is_some();
        let Some(at) =
            pointer.or(ui.input(|input| input.pointer.latest_pos()).filter(|_| is_at_work))
        else {
            return;
        };
        let is_reading = self.ground().is_none() && self.going.is_none();
        self.hint = match is_reading {
            true => tr!("Reading the picture: a stroke waits until it is read"),
            _ => {
                tr!("Drag to paint · [ and ] change the brush · Ctrl-click takes a color · \
                     Alt-drag turns the camera · Esc ends it")
            }
        };
        if self.obstacle(session).is_some() {
            return ui.ctx().set_cursor_icon(CursorIcon::NotAllowed);
        }
        let radius = (0.5 * self.tools.size) as f32 * canvas.height();
        painter.circle_stroke(at, radius, Stroke::new(3.0, theme::HALO));
        painter.circle_stroke(at, radius, Stroke::new(1.2, Color32::WHITE));
        let inner = radius * self.tools.hardness as f32;
        painter.circle_stroke(at, inner, Stroke::new(1.0, Color32::from_white_alpha(70)));
        painter.circle_filled(at, 1.2, Color32::WHITE);
        if let Some(waiting) = &self.waiting {
            let place =
                |at: &DVec2| canvas.center() + vec2(at.x as f32, at.y as f32) * canvas.height();
            painter
                .line(waiting.path.iter().map(place).collect(), Stroke::new(1.5, Color32::WHITE));
        }
        ui.ctx().set_cursor_icon(if is_reading { CursorIcon::Progress } else { CursorIcon::None });
    }

    /// Texture of the present strokes: of their outlines alone under a preview, and where strokes
    /// are not to be shown.
    fn strokes(&mut self, ctx: &Context, session: &Session) -> Option<TextureId> {
        let tile = self
            .going
            .as_ref()
            .map(|going| &going.now)
            .or(session.sketchbook.sketch().tile())?
            .clone();
        let outlines_only = !self.shows.strokes || self.shows.misses || self.awaits();
        let moment = self.grounds.moment().cloned();
        let of = StrokesTextureKey { tile: Arc::as_ptr(&tile) as usize, moment, outlines_only };
        if let Some((known, _, handle)) = &self.textures.strokes
            && *known == of
        {
            return Some(handle.id());
        }
        let image = strokes(&tile, self.grounds.latest(), outlines_only);
        let options = TextureOptions::LINEAR;
        let handle = match self.textures.strokes.take() {
            Some((_, _, mut handle)) => {
                handle.set(image, options);
                handle
            }
            None => ctx.load_texture("strokes", image, options),
        };
        let id = handle.id();
        // The tile is kept, so that no other tile gets its address, which the key holds.
        self.textures.strokes = Some((of, tile, handle));
        Some(id)
    }

    fn misses(&mut self, ctx: &Context) -> Option<TextureId> {
        let (tile, moment, goals) = self.goals.as_ref()?;
        let ground = self.grounds.latest()?;
        let of = StrokesTextureKey {
            tile: Arc::as_ptr(tile) as usize,
            moment: Some(moment.clone()),
            outlines_only: false,
        };
        if let Some((known, handle)) = &self.textures.misses
            && *known == of
        {
            return Some(handle.id());
        }
        let picture = picture_of(ground.size, &target::misses(goals, ground));
        let size = ground.size.map(|side| side as usize);
        let image = ColorImage::from_rgba_unmultiplied(size, &picture.to_rgba8());
        let handle = ctx.load_texture("misses of strokes", image, TextureOptions::LINEAR);
        let id = handle.id();
        self.textures.misses = Some((of, handle));
        Some(id)
    }
}

/// Shows a label on the present display, above a corner of the picture; returns the height that the
/// next label is above.
fn tag(ui: &Ui, corner: Pos2, text: &str) -> f32 {
    let font = FontId::proportional(theme::SMALL_TEXT);
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE);
    let place = Align2::LEFT_BOTTOM.anchor_size(corner, galley.size());
    ui.painter().rect_filled(place.expand2(vec2(6.0, 3.0)), 4.0, theme::PLATE);
    ui.painter().galley(place.min, galley, Color32::WHITE);
    place.top() - 10.0
}

/// Says that the strokes belong to another view, with a button that leads back.
fn elsewhere(ui: &mut Ui, rect: Rect, out: &mut Vec<Command>) {
    let room = Rect::from_min_max(
        pos2(rect.left() + 8.0, rect.bottom() - 44.0),
        rect.max - vec2(8.0, 8.0),
    );
    ui.scope_builder(UiBuilder::new().id_salt("elsewhere").max_rect(room), |ui| {
        let frame = egui::Frame::new()
            .fill(theme::of(ui).panel.gamma_multiply(0.9))
            .corner_radius(4.0)
            .inner_margin(egui::Margin::symmetric(8, 4));
        frame.show(ui, |ui| {
            ui.horizontal(|ui| {
                let button = ui.button(tr!("Back to the painted view"));
                button.widget_info(|| {
                    WidgetInfo::labeled(Role::Button, true, tr!("Back to the painted view"))
                });
                if button.clicked() {
                    out.push(Command::Fit(FitCommand::Back));
                }
                let text = egui::RichText::new(tr!("The strokes belong to another view"))
                    .color(theme::of(ui).accent);
                ui.add(egui::Label::new(text).truncate());
            });
        });
    });
}
