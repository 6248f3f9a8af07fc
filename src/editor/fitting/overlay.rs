//! What is seen of the strokes over the picture: what they wish, where they end, where the look misses them.

use std::sync::Arc;

use eframe::egui;
use eframe::egui::{
    Align2, Color32, ColorImage, Context, CursorIcon, FontId, Rect, Response, Role, Stroke, TextureHandle, TextureId,
    TextureOptions, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::ground::{Ground, Moment};
use super::target::{self, FINENESS};
use super::{Fitting, Wish};
use crate::document::Tile;
use crate::editor::command::Command;
use crate::editor::session::Session;
use crate::editor::theme;
use crate::fit::picture_of;

/// The outline of strokes is dashed: so many pixels of the sketch light, as many dark.
const DASH: u32 = 4;
/// What stays as it is, is hatched by lines so many pixels of the sketch apart.
const HATCH: u32 = 8;
/// A wish that is no farther from what is shown is that it stays; the steps of eight bits.
const SAME: f64 = 2.5 / 255.0;

/// What a texture of strokes is of.
#[derive(PartialEq)]
struct Of {
    tile: usize,
    moment: Option<Moment>,
    outlines_only: bool,
}

/// What is on the GPU for it.
#[derive(Default)]
pub(super) struct Textures {
    strokes: Option<(Of, Arc<Tile>, TextureHandle)>,
    misses: Option<(Of, TextureHandle)>,
    ground: Option<(Moment, TextureHandle)>,
}

impl Fitting {
    /// What the look shows, as a picture in place of one that a GPU would draw.
    pub(crate) fn stand_in(&mut self, ui: &Ui, rect: Rect) -> bool {
        let (Some(ground), Some(moment)) = (self.grounds.latest().filter(|_| self.is_on), self.grounds.moment()) else {
            return false;
        };
        let known = self.textures.ground.as_ref().filter(|(of, _)| of == moment).map(|(_, handle)| handle.id());
        let texture = known.unwrap_or_else(|| {
            let handle = ui.ctx().load_texture("ground", ground.image.clone(), TextureOptions::LINEAR);
            let id = handle.id();
            self.textures.ground = Some((moment.clone(), handle));
            id
        });
        ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
        ui.painter_at(rect).image(texture, Self::canvas(rect, ground.size), whole(), Color32::WHITE);
        true
    }

    /// Strokes, misses, the brush, and what there is to be said over the picture.
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
        if self.awaits() {
            tag(ui, rect, "Preview of the fit: apply or discard it");
        } else if self.shows.misses && is_here && !self.wishes().is_empty() {
            tag(ui, rect, "Black: as painted. Red to white: off by up to 25/255 and more");
        }
        self.hint = "";
        if !is_here {
            elsewhere(ui, rect, out);
            self.hint = "The strokes belong to another view";
            return;
        }
        let pointer = response.contains_pointer().then(|| ui.input(|input| input.pointer.hover_pos())).flatten();
        let Some(at) = pointer.or(self.going.as_ref().and(ui.input(|input| input.pointer.latest_pos()))) else {
            return;
        };
        self.hint = match self.ground() {
            None if self.going.is_none() => "Reading the picture: paint in a moment",
            _ => {
                "Drag to paint · [ and ] change the brush · Ctrl-click takes a color · Alt-drag turns the camera · Esc ends it"
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
        ui.ctx().set_cursor_icon(CursorIcon::None);
    }

    /// The strokes as they are now. Under a preview, and where they are not to be seen, their outlines alone.
    fn strokes(&mut self, ctx: &Context, session: &Session) -> Option<TextureId> {
        let tile = self.going.as_ref().map(|going| &going.now).or(session.sketch().tile())?.clone();
        let outlines_only = !self.shows.strokes || self.shows.misses || self.outcome.is_some();
        let moment = self.grounds.moment().cloned();
        let of = Of { tile: Arc::as_ptr(&tile) as usize, moment, outlines_only };
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
        // The tile is kept, so that no other one comes to lie where it lay.
        self.textures.strokes = Some((of, tile, handle));
        Some(id)
    }

    fn misses(&mut self, ctx: &Context) -> Option<TextureId> {
        let (tile, moment, wishes) = self.wishes.as_ref()?;
        let ground = self.grounds.latest()?;
        let of = Of { tile: Arc::as_ptr(tile) as usize, moment: Some(moment.clone()), outlines_only: false };
        if let Some((known, handle)) = &self.textures.misses
            && *known == of
        {
            return Some(handle.id());
        }
        let picture = picture_of(ground.size, &target::misses(wishes, ground));
        let size = ground.size.map(|side| side as usize);
        let image = ColorImage::from_rgba_unmultiplied(size, &picture.to_rgba8());
        let handle = ctx.load_texture("misses of strokes", image, TextureOptions::NEAREST);
        let id = handle.id();
        self.textures.misses = Some((of, handle));
        Some(id)
    }
}

fn whole() -> Rect {
    Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0))
}

/// The strokes as a picture: veils over what is shown, hatched where it stays as it is, with a dashed outline
/// that is seen on anything.
fn strokes(tile: &Tile, ground: Option<&Ground>, outlines_only: bool) -> ColorImage {
    let [width, height] = tile.size();
    let (texels, _) = tile.bytes().as_chunks::<4>();
    let at = |x: u32, y: u32| texels[(y * width + x) as usize];
    let is_in = |x: u32, y: u32| at(x, y)[3] >= 128;
    let shown = |x: u32, y: u32| {
        let place = |x: u32| (f64::from(x) + 0.5) / f64::from(FINENESS);
        ground.map(|ground| ground.at(place(x), place(y)).0)
    };
    let mut image = ColorImage::filled([width as usize, height as usize], Color32::TRANSPARENT);
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let [r, g, b, alpha] = at(x, y);
        if alpha == 0 {
            continue;
        }
        let is_edge = is_in(x, y)
            && !(x > 0
                && is_in(x - 1, y)
                && y > 0
                && is_in(x, y - 1)
                && x + 1 < width
                && is_in(x + 1, y)
                && y + 1 < height
                && is_in(x, y + 1));
        let pixel = &mut image.pixels[(y * width + x) as usize];
        if is_edge {
            let is_light = ((x + y) / DASH).is_multiple_of(2);
            *pixel = if is_light { Color32::from_white_alpha(220) } else { Color32::from_black_alpha(200) };
        } else if !outlines_only && let Some(shown) = shown(x, y) {
            let wish = [r, g, b].map(|byte| f64::from(byte) / 255.0);
            let stays = wish.iter().zip(shown).all(|(wish, shown)| (wish - shown).abs() < SAME);
            *pixel = match (stays, (x + y) % HATCH < 2 && is_in(x, y)) {
                (true, true) => Color32::from_white_alpha(110),
                (true, false) => Color32::TRANSPARENT,
                (false, _) => veil(shown, wish, f64::from(alpha) / 255.0),
            };
        }
    }
    image
}

/// The thinnest veil over what is shown through which it looks as wished, so that the picture's own detail is seen through
/// it; as much of it as there is of the wish.
fn veil(shown: [f64; 3], wish: [f64; 3], share: f64) -> Color32 {
    let cover = shown.iter().zip(wish).map(|(shown, wish)| {
        let room = if wish > *shown { 1.0 - shown } else { *shown };
        ((wish - shown).abs() / room.max(1e-6)).min(1.0)
    });
    let cover = cover.fold(0.0, f64::max).max(1e-6);
    let byte = |x: f64| x.clamp(0.0, 1.0).mul_add(255.0, 0.5) as u8;
    let color = |c: usize| byte((wish[c] - shown[c] * (1.0 - cover)) / cover);
    Color32::from_rgba_unmultiplied(color(0), color(1), color(2), byte(cover * share))
}

/// What is seen now, in a corner of the picture.
fn tag(ui: &Ui, rect: Rect, text: &str) {
    let font = FontId::proportional(theme::SMALL_TEXT);
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE);
    let place = Align2::LEFT_BOTTOM.anchor_size(rect.left_bottom() + vec2(8.0, -8.0), galley.size());
    ui.painter().rect_filled(place.expand2(vec2(6.0, 3.0)), 4.0, theme::PLATE);
    ui.painter().galley(place.min, galley, Color32::WHITE);
}

/// Says that the strokes are not seen from here, and leads back.
fn elsewhere(ui: &mut Ui, rect: Rect, out: &mut Vec<Command>) {
    let room = Rect::from_min_max(pos2(rect.left() + 8.0, rect.bottom() - 44.0), rect.max - vec2(8.0, 8.0));
    ui.scope_builder(UiBuilder::new().id_salt("elsewhere").max_rect(room), |ui| {
        let frame = egui::Frame::new()
            .fill(theme::of(ui).panel.gamma_multiply(0.9))
            .corner_radius(4.0)
            .inner_margin(egui::Margin::symmetric(8, 4));
        frame.show(ui, |ui| {
            ui.horizontal(|ui| {
                let button = ui.button("Back to the painted view");
                button.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Back to the painted view"));
                if button.clicked() {
                    out.push(Command::Fit(Wish::Back));
                }
                let text = egui::RichText::new("The strokes belong to another view").color(theme::of(ui).accent);
                ui.add(egui::Label::new(text).truncate());
            });
        });
    });
}
