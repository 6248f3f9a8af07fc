//! The tile as the eye sees it, to be painted on: tilted and turned, with copies around it, arrows
//! to the light and the eye, and the brush's true shape under the pointer.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::epaint::{Mesh, Vertex};
use eframe::egui::{
    Color32, ColorImage, CursorIcon, Key, Painter, PointerButton, Pos2, Rect, Response, Role,
    Sense, Shape, Stroke, TextureHandle, TextureId, TextureOptions, Ui, Vec2, WidgetInfo, pos2,
    vec2,
};

use super::pointer::{self, TileGesture};
use super::textures::TileTexture;
use super::tilt::Tilt;
use super::tools::Tools;
use super::{arrows, moves};
use crate::commands::keyboard;
use crate::commands::table::{self, KeyScope};
use crate::commands::{Command, Heading, PaintTool};
use crate::document::{Address, HcbtfAngle};
use crate::state::painting::work::OpenPainting;
use crate::widgets::theme;

/// Part of the room that the tile fills when it is fitted, so that some of its copies are seen.
const FITTED: f64 = 0.6;
/// Range of the zoom, in points per texel.
const ZOOM: std::ops::RangeInclusive<f64> = 0.05..=200.0;
/// Side of a square of the checkerboard that shows through transparent texels, in points.
const CHECK: f32 = 8.0;

/// Display of the tile, and the pointer's gesture on it.
pub(super) struct Easel {
    /// Points per texel; `None` to fit the room.
    zoom: Option<f64>,
    /// Vector from the middle of the room to the middle of the tile, in points.
    pan: Vec2,
    pub(super) is_flat: bool,
    pub(super) shows_copies: bool,
    pub(super) shows_arrows: bool,
    /// Opacity of the neighboring samples over the tile, 0 to 1.
    pub(super) onion: f32,
    /// Angle along which the neighboring samples lie.
    pub(super) onion_along: HcbtfAngle,
    going: Option<TileGesture>,
    tile: TileTexture,
    neighbors: [TileTexture; 2],
    checks: Option<TextureHandle>,
    /// Placement of the tile in the last frame.
    tilt: Option<Tilt>,
    has_pointer: bool,
    /// Input of this frame, kept until the frame is drawn.
    scene: Option<EaselScene>,
    pub(super) hint: String,
}

/// Input of one frame: the room, and what is under the pointer.
struct EaselScene {
    room: Rect,
    pointer: Option<Pos2>,
    /// Sample that is only looked at, in place of the one at work.
    peek: Option<Address>,
}

impl Default for Easel {
    fn default() -> Self {
        Self {
            zoom: None,
            pan: Vec2::ZERO,
            is_flat: false,
            shows_copies: true,
            shows_arrows: true,
            onion: 0.0,
            onion_along: HcbtfAngle::ViewPhi,
            going: None,
            tile: TileTexture::default(),
            neighbors: Default::default(),
            checks: None,
            tilt: None,
            has_pointer: false,
            scene: None,
            hint: String::new(),
        }
    }
}

impl Easel {
    /// Handles the pointer on the tile, which takes all available space. `peek` is shown in place
    /// of the sample at work.
    pub(super) fn interact(
        &mut self,
        ui: &mut Ui,
        work: &OpenPainting,
        tools: &mut Tools,
        peek: Option<Address>,
    ) -> Vec<Command> {
        let (room, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Painting canvas")));
        let shown = peek.unwrap_or(work.at());
        let grid = *work.grid();
        let fitted = |tilt: &Tilt| {
            let bounds = tilt.bounds();
            let room =
                [room.width() / bounds.width(), room.height() / bounds.height()].map(f64::from);
            (tilt.scale() * room[0].min(room[1]) * FITTED).clamp(*ZOOM.start(), *ZOOM.end())
        };
        let lying = |scale: f64, pan: Vec2| {
            Tilt::new(&grid, shown.view, self.is_flat, room.center() + pan, scale)
        };
        let fit = fitted(&lying(1.0, Vec2::ZERO));
        let mut tilt = lying(self.zoom.unwrap_or(fit), self.pan);
        let pointer = response
            .contains_pointer()
            .then(|| ui.input(|input| input.pointer.hover_pos()))
            .flatten();
        self.has_pointer = pointer.is_some();
        if self.navigate(ui, &response, &tilt, room) {
            tilt = Tilt::new(
                &grid,
                shown.view,
                self.is_flat,
                room.center() + self.pan,
                self.zoom.unwrap_or(fit),
            );
        }
        self.tilt = Some(tilt);
        self.scene = Some(EaselScene { room, pointer, peek });
        match peek {
            Some(_) => Vec::new(),
            None => pointer::paint(ui, &response, &tilt, &mut self.going, tools, work),
        }
    }

    /// Draws the tile.
    pub(super) fn show(&mut self, ui: &Ui, work: &OpenPainting, tools: &Tools) {
        let (Some(EaselScene { room, pointer, peek }), Some(tilt)) = (self.scene.take(), self.tilt)
        else {
            return;
        };
        let (is_peeking, shown) = (peek.is_some(), peek.unwrap_or(work.at()));
        let grid = *work.grid();
        let painter = ui.painter_at(room);
        painter.rect_filled(room, 0.0, theme::of(ui).canvas);
        self.paint(ui, &painter, room, &tilt, work, shown);
        if self.shows_arrows {
            let light = grid.light.vector(shown.light);
            let eye = (!is_peeking || !self.is_flat).then(|| grid.view.vector(shown.view));
            arrows::paint(ui, &painter, &tilt, light, eye);
        }
        if is_peeking {
            let text =
                tr!("Only looking: {sample}. Let go to be back", sample = name_of(work, shown));
            note(ui, &painter, room, &text);
        } else if work.shown().painted.is_empty() {
            note(
                ui,
                &painter,
                room,
                tr!("Drag on the tile to paint how it looks under this light, from here"),
            );
        }
        if let Some(at) = pointer.filter(|_| !is_peeking) {
            cursor(ui, &painter, &tilt, tools, at);
            self.tell(&tilt, work, tools, at);
        }
        if pointer.is_none() {
            self.hint.clear();
        }
    }

    /// Moves the view: the wheel zooms about the pointer; drags with the middle or right button or
    /// with space move the tile. Returns true if the view has changed.
    fn navigate(&mut self, ui: &Ui, response: &Response, tilt: &Tilt, room: Rect) -> bool {
        let before = (self.zoom, self.pan);
        if let Some(at) = response.hover_pos() {
            let (scroll, pinch) =
                ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let factor = f64::from((scroll / 300.0).exp() * pinch);
            if factor != 1.0 {
                let zoom = (tilt.scale() * factor).clamp(*ZOOM.start(), *ZOOM.end());
                let by = (zoom / tilt.scale()) as f32;
                self.pan = at + (tilt.middle - at) * by - room.center();
                self.zoom = Some(zoom);
            }
        }
        let with_space = response.dragged_by(PointerButton::Primary)
            && ui.input(|input| input.key_down(Key::Space));
        let is_pan = response.dragged_by(PointerButton::Middle)
            || response.dragged_by(PointerButton::Secondary);
        if (is_pan || with_space) && self.going.is_none() {
            self.pan += response.drag_delta();
        }
        before != (self.zoom, self.pan)
    }

    fn paint(
        &mut self,
        ui: &Ui,
        painter: &Painter,
        room: Rect,
        tilt: &Tilt,
        work: &OpenPainting,
        at: Address,
    ) {
        let checks = self.checks(ui);
        let colors = theme::of(ui);
        let tile = work.tile(at);
        let texture = tile.map(|tile| self.tile.of(ui.ctx(), "painting", tile));
        let copies = if self.shows_copies && work.hcbtf().is_tiling {
            tilt.copies(room)
        } else {
            vec![[0, 0]]
        };
        if let Some(texture) = texture {
            let dimmed = Color32::from_white_alpha(90);
            let around = copies.iter().filter(|copy| **copy != [0, 0]);
            quads(painter, texture, around.map(|copy| (tilt.corners(*copy), dimmed)));
        }
        ground(painter, checks, tilt.corners([0, 0]));
        if let Some(texture) = texture {
            quads(painter, texture, std::iter::once((tilt.corners([0, 0]), Color32::WHITE)));
        }
        if self.onion > 0.0 {
            let tint = Color32::from_white_alpha((self.onion * 127.0) as u8);
            let found =
                neighbors(work, at, self.onion_along).map(|address| work.tile(address).cloned());
            for (shown, tile) in self.neighbors.iter_mut().zip(found) {
                if let Some(tile) = tile {
                    let texture = shown.of(ui.ctx(), "neighbor", &tile);
                    quads(painter, texture, std::iter::once((tilt.corners([0, 0]), tint)));
                }
            }
        }
        let edge = tilt.corners([0, 0]).to_vec();
        painter.add(Shape::closed_line(edge.clone(), Stroke::new(3.0, theme::HALO)));
        painter.add(Shape::closed_line(edge, Stroke::new(1.0, colors.swatch_edge)));
    }

    fn checks(&mut self, ui: &Ui) -> TextureId {
        let make = || {
            let [dark, light] = [Color32::from_gray(96), Color32::from_gray(124)];
            let image = ColorImage::new([2, 2], vec![light, dark, dark, light]);
            let options = TextureOptions {
                wrap_mode: egui::TextureWrapMode::Repeat,
                ..TextureOptions::NEAREST
            };
            ui.ctx().load_texture("checks", image, options)
        };
        self.checks.get_or_insert_with(make).id()
    }

    fn tell(&mut self, tilt: &Tilt, work: &OpenPainting, tools: &Tools, at: Pos2) {
        let texel = tilt.texel(at);
        let size = work.grid().size.map(f64::from);
        let place = [texel.x.rem_euclid(size[0]).floor(), texel.y.rem_euclid(size[1]).floor()];
        self.hint = tr!(
            "{tool} at {x}, {y} · wheel zooms · right-drag moves · arrows change the view, \
             Shift+arrows the light",
            tool = tools.kind.label(),
            x = place[0],
            y = place[1]
        );
    }

    /// Fits the tile into the room again.
    pub(super) fn fit(&mut self) {
        (self.zoom, self.pan) = (None, Vec2::ZERO);
    }

    /// Notes that the tile is no longer shown.
    pub(super) fn leave(&mut self) {
        (self.has_pointer, self.tilt) = (false, None);
        self.hint.clear();
    }

    /// True while the pointer is over the tile, so that keys are meant for painting.
    pub(super) fn has_pointer(&self) -> bool {
        self.has_pointer
    }

    /// True while a gesture on the tile is under way.
    pub(super) fn is_painting(&self) -> bool {
        self.going.is_some()
    }

    /// Position on the screen of a place of the tile, given in texels from the tile's upper left
    /// corner.
    pub(super) fn screen(&self, texel: [f64; 2]) -> Option<Pos2> {
        self.tilt.map(|tilt| tilt.screen(texel.into()))
    }

    /// Commands of the keys that are pressed over the tile.
    pub(super) fn keys(&self, ui: &Ui) -> Vec<Command> {
        let is_free =
            self.has_pointer && !keyboard::is_keyboard_taken(ui.ctx()) && self.going.is_none();
        if is_free { table::pressed(ui, KeyScope::Painting) } else { Vec::new() }
    }
}

/// Name of a sample for people: the directions of its light and its view.
pub(super) fn name_of(work: &OpenPainting, address: Address) -> String {
    let grid = work.grid();
    tr!(
        "light {light}, view {view}",
        light = moves::name(grid.light, address.light),
        view = moves::name(grid.view, address.view)
    )
}

/// The two samples next to a sample along an angle.
fn neighbors(work: &OpenPainting, at: Address, along: HcbtfAngle) -> [Address; 2] {
    let grid = work.grid();
    let ways = match along {
        HcbtfAngle::LightTheta | HcbtfAngle::ViewTheta => [Heading::Up, Heading::Down],
        HcbtfAngle::LightPhi | HcbtfAngle::ViewPhi => [Heading::Left, Heading::Right],
    };
    ways.map(|way| match along {
        HcbtfAngle::LightTheta | HcbtfAngle::LightPhi => {
            Address { light: moves::step(grid.light, at.light, way), ..at }
        }
        HcbtfAngle::ViewTheta | HcbtfAngle::ViewPhi => {
            Address { view: moves::step(grid.view, at.view, way), ..at }
        }
    })
}

/// Draws a texture into quadrilaterals, each in a tint.
fn quads(
    painter: &Painter,
    texture: TextureId,
    corners: impl Iterator<Item = ([Pos2; 4], Color32)>,
) {
    let mut mesh = Mesh::with_texture(texture);
    let uvs = [pos2(0.0, 0.0), pos2(1.0, 0.0), pos2(1.0, 1.0), pos2(0.0, 1.0)];
    for (corners, tint) in corners {
        add_quad(&mut mesh, corners, uvs, tint);
    }
    painter.add(Shape::mesh(mesh));
}

/// Draws the checkerboard that shows through transparent texels.
fn ground(painter: &Painter, checks: TextureId, corners: [Pos2; 4]) {
    let mut mesh = Mesh::with_texture(checks);
    let uvs = corners.map(|corner| (corner.to_vec2() / (2.0 * CHECK)).to_pos2());
    add_quad(&mut mesh, corners, uvs, Color32::WHITE);
    painter.add(Shape::mesh(mesh));
}

fn add_quad(mesh: &mut Mesh, corners: [Pos2; 4], uvs: [Pos2; 4], color: Color32) {
    let first = mesh.vertices.len() as u32;
    mesh.vertices.extend(corners.into_iter().zip(uvs).map(|(pos, uv)| Vertex { pos, uv, color }));
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}

/// Draws the brush's outline as it lies on the tile.
fn cursor(ui: &Ui, painter: &Painter, tilt: &Tilt, tools: &Tools, at: Pos2) {
    if !tools.kind.has_brush() {
        let icon =
            if tools.kind == PaintTool::Pick { CursorIcon::Crosshair } else { CursorIcon::Cell };
        return ui.ctx().set_cursor_icon(icon);
    }
    let outline = tilt.outline(tilt.texel(at), tools.size);
    painter.add(Shape::closed_line(outline.clone(), Stroke::new(3.0, theme::HALO)));
    painter.add(Shape::closed_line(outline, Stroke::new(1.2, Color32::WHITE)));
    painter.circle_filled(at, 1.2, Color32::WHITE);
    ui.ctx().set_cursor_icon(CursorIcon::None);
}

fn note(ui: &Ui, painter: &Painter, room: Rect, text: &str) {
    let font = egui::FontId::proportional(theme::TEXT_SIZE);
    let galley = painter.layout_no_wrap(text.to_owned(), font, Color32::WHITE);
    let at = room.center_top() + vec2(-galley.size().x / 2.0, 10.0);
    painter.rect_filled(
        Rect::from_min_size(at, galley.size()).expand2(vec2(8.0, 4.0)),
        4.0,
        theme::PLATE,
    );
    painter.galley(at, galley, theme::of(ui).text);
}
