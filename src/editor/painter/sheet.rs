//! All samples of an HCBTF in one picture, as the thesis flattens it (thesis 10.2, figure 24):
//! every texel of the tile is a block of all its lights and views. The sheet is zoomed and moved
//! about; the address under the pointer is shown, and a click goes to that sample.
//!
//! Only the visible part is drawn, in pixels of the screen, when it changes: the whole sheet may be
//! larger than any texture.

use chiaro_locale::tr;
use eframe::egui::{
    Color32, ColorImage, FontId, PointerButton, Pos2, Rect, Response, RichText, Role, Sense,
    Stroke, StrokeKind, TextureHandle, TextureOptions, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::{moves, told_state};
use crate::commands::{Command, PaintCommand};
use crate::document::{Address, Direction, Grid};
use crate::hcbtf::sheet::{SheetTexel, column, held, place, row, size};
use crate::state::painting::work::OpenPainting;
use crate::state::revision::PaintingRevision;
use crate::widgets::theme;

/// Largest zoom, in points per texel of the sheet.
const CLOSEST: f64 = 64.0;
/// Part of the room that the whole sheet takes when it is fitted.
const FITTED: f64 = 0.96;
/// Largest number of texels along each side that are averaged for a pixel, where a pixel covers
/// several.
const MOST_AVERAGED: usize = 4;
/// Width of a block from which lines between blocks are drawn, in points.
const LINED: f64 = 12.0;
/// Width of a texel from which the texels of the sample at work are marked, in points.
const MARKED: f64 = 3.0;
/// Gray value that shows through transparent texels, 0 to 255.
const NOTHING: u32 = 38;

/// Display of the sheet.
#[derive(Default)]
pub(super) struct Sheet {
    /// Points per texel; `None` to fit the room.
    zoom: Option<f64>,
    /// Vector from the middle of the room to the middle of the sheet, in points.
    pan: Vec2,
    texture: Option<TextureHandle>,
    /// Inputs of the picture in the texture.
    made: Option<SheetInputs>,
    /// Placement of the sheet in the last frame.
    laid: Option<(SheetPlacement, Grid)>,
}

/// Inputs that the picture of the sheet depends on.
#[derive(Clone, Copy, PartialEq)]
struct SheetInputs {
    revision: PaintingRevision,
    laid: SheetPlacement,
    pixels: [usize; 2],
}

/// Placement of the sheet on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SheetPlacement {
    room: Rect,
    /// Upper left corner of the sheet.
    origin: Pos2,
    /// Points per texel.
    zoom: f64,
}

impl SheetPlacement {
    fn screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.origin + vec2((x * self.zoom) as f32, (y * self.zoom) as f32)
    }

    fn texel(&self, at: Pos2) -> [f64; 2] {
        let by = at - self.origin;
        [f64::from(by.x) / self.zoom, f64::from(by.y) / self.zoom]
    }

    /// Range of visible texels, from and to, along x and along y.
    fn seen(&self, size: [u32; 2]) -> [[u32; 2]; 2] {
        let (from, to) = (self.texel(self.room.min), self.texel(self.room.max));
        [0, 1].map(|axis| {
            [from[axis].max(0.0) as u32, to[axis].clamp(0.0, f64::from(size[axis])).ceil() as u32]
        })
    }
}

impl Sheet {
    /// Shows the sheet in all available space. While a stroke is under way the picture stays as it
    /// is.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        work: &OpenPainting,
        is_painting: bool,
        out: &mut Vec<Command>,
    ) {
        let grid = *work.grid();
        let whole = size(&grid);
        ui.horizontal(|ui| {
            ui.label(tr!("{width} x {height} texels", width = whole[0], height = whole[1]));
            if ui
                .small_button(tr!("Fit"))
                .on_hover_text(tr!("Shows the whole sheet again"))
                .clicked()
            {
                (self.zoom, self.pan) = (None, Vec2::ZERO);
            }
            let help = tr!(
                "Each texel of the tile is a block: light and eye sink from left to right, and go \
                 around from top to bottom"
            );
            ui.label(
                RichText::new(tr!("a block for each texel of the tile")).color(theme::of(ui).dim),
            )
            .on_hover_text(help);
        });
        let (room, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        let laid = self.navigate(ui, &response, room, whole);
        self.laid = Some((laid, grid));
        let scale = f64::from(ui.pixels_per_point());
        let most = ui.input(|input| input.max_texture_side);
        let pixels = [room.width(), room.height()]
            .map(|side| ((f64::from(side) * scale) as usize).clamp(1, most));
        let made = SheetInputs { revision: work.revision(), laid, pixels };
        if self.made != Some(made) && !(is_painting && self.texture.is_some()) {
            let image = picture(work, &laid, pixels);
            match &mut self.texture {
                Some(texture) => texture.set(image, TextureOptions::NEAREST),
                None => {
                    self.texture =
                        Some(ui.ctx().load_texture("sheet", image, TextureOptions::NEAREST));
                }
            }
            self.made = Some(made);
        }
        let painter = ui.painter_at(room);
        painter.rect_filled(room, 0.0, theme::of(ui).canvas);
        if let Some(texture) = &self.texture {
            let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), room, uv, Color32::WHITE);
        }
        lines(ui, &laid, &grid);
        mark(ui, &laid, &grid, work.at());
        let hovered = response.hover_pos().and_then(|at| texel_at(&laid, at));
        let found = hovered.and_then(|texel| Some((texel, held(&grid, texel)?)));
        let told = found.map(|(_, held)| tell(work, &held));
        response.widget_info(|| WidgetInfo {
            current_text_value: told.as_ref().map(|lines| lines.join("\n")),
            ..WidgetInfo::labeled(Role::Canvas, true, tr!("Sheet of all samples"))
        });
        if let (Some((texel, held)), Some(lines)) = (found, told) {
            outline(ui, &laid, texel, Color32::WHITE);
            plate(ui, room, lines);
            if response.clicked() {
                out.push(Command::Paint(PaintCommand::GoTo(held.address)));
            }
        }
    }

    /// Moves the view: the wheel zooms about the pointer; drags move the sheet.
    fn navigate(
        &mut self,
        ui: &Ui,
        response: &Response,
        room: Rect,
        whole: [u32; 2],
    ) -> SheetPlacement {
        let [width, height] = whole.map(f64::from);
        let fit = (f64::from(room.width()) / width).min(f64::from(room.height()) / height) * FITTED;
        let lay = |zoom: f64, pan: Vec2| {
            let half = vec2((width * zoom / 2.0) as f32, (height * zoom / 2.0) as f32);
            SheetPlacement { room, origin: room.center() + pan - half, zoom }
        };
        let laid = lay(self.zoom.unwrap_or(fit), self.pan);
        if let Some(at) = response.hover_pos() {
            let (scroll, pinch) =
                ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let factor = f64::from((scroll / 300.0).exp() * pinch);
            if factor != 1.0 {
                let zoom = (laid.zoom * factor).clamp(fit * 0.5, CLOSEST.max(fit));
                let middle = laid.screen([width / 2.0, height / 2.0]);
                self.pan = at + (middle - at) * (zoom / laid.zoom) as f32 - room.center();
                self.zoom = Some(zoom);
            }
        }
        let buttons = [PointerButton::Primary, PointerButton::Middle, PointerButton::Secondary];
        if buttons.into_iter().any(|button| response.dragged_by(button)) {
            self.pan += response.drag_delta();
        }
        lay(self.zoom.unwrap_or(fit), self.pan)
    }

    /// Position of a sample's texel on the screen.
    pub(super) fn screen(&self, address: Address, texel: [u32; 2]) -> Option<Pos2> {
        let (laid, grid) = self.laid?;
        let [x, y] = place(&grid, address, texel.map(|place| place as usize));
        Some(laid.screen([x as f64 + 0.5, y as f64 + 0.5]))
    }
}

fn texel_at(laid: &SheetPlacement, at: Pos2) -> Option<[u32; 2]> {
    let [x, y] = laid.texel(at).map(f64::floor);
    (x >= 0.0 && y >= 0.0).then_some([x as u32, y as u32])
}

/// Picture of the visible part of the sheet, one color per pixel.
fn picture(work: &OpenPainting, laid: &SheetPlacement, pixels: [usize; 2]) -> ColorImage {
    let grid = *work.grid();
    let tiles = tiles(work, &grid);
    let steps = (grid.view.phi * grid.light.phi) as usize;
    let step = f64::from(laid.room.width()) / pixels[0] as f64 / laid.zoom;
    let count = (step.ceil() as usize).clamp(1, MOST_AVERAGED);
    let from = laid.texel(laid.room.min);
    // Each pixel averages `count` texels along an axis; `place` is the coordinate of one of them.
    let place = |axis: usize, index: usize| {
        let at = from[axis] + step * (index as f64 + 0.5) / count as f64;
        (at >= 0.0).then_some(at as u32)
    };
    let columns: Vec<Option<[usize; 2]>> = (0..pixels[0] * count)
        .map(|index| {
            let [ix, view, light] = column(&grid, place(0, index)?)?;
            Some([ix as usize, (view * grid.light.theta + light) as usize * steps])
        })
        .collect();
    let rows: Vec<Option<[usize; 2]>> = (0..pixels[1] * count)
        .map(|index| {
            let ([iy, view, light], _) = row(&grid, place(1, index)?)?;
            Some([(iy * grid.size[0]) as usize, (view * grid.light.phi + light) as usize])
        })
        .collect();
    let mut colors = Vec::with_capacity(pixels[0] * pixels[1]);
    for rows in rows.chunks_exact(count) {
        for columns in columns.chunks_exact(count) {
            let mut mean = Mean::default();
            for [start, step] in rows.iter().flatten() {
                for [ix, rings] in columns.iter().flatten() {
                    mean.add(tiles[rings + step].and_then(|tile| tile.get(start + ix)));
                }
            }
            colors.push(mean.color());
        }
    }
    ColorImage::new(pixels, colors)
}

/// Texels of every sample, by the rings of view and light and then by their steps.
fn tiles<'w>(work: &'w OpenPainting, grid: &Grid) -> Vec<Option<&'w [[u8; 4]]>> {
    let directions = |theta, phi| Direction { theta, phi };
    let rings =
        (0..grid.view.theta).flat_map(|view| (0..grid.light.theta).map(move |light| [view, light]));
    let steps =
        || (0..grid.view.phi).flat_map(|view| (0..grid.light.phi).map(move |light| [view, light]));
    let all = rings.flat_map(|rings| steps().map(move |steps| (rings, steps)));
    let tile = |(rings, steps): ([u32; 2], [u32; 2])| {
        let address =
            Address { view: directions(rings[0], steps[0]), light: directions(rings[1], steps[1]) };
        Some(work.tile(address.canonical())?.bytes().as_chunks::<4>().0)
    };
    all.map(tile).collect()
}

/// Mean of texels over the gray that shows through them.
#[derive(Default)]
struct Mean {
    sum: [u32; 3],
    count: u32,
}

impl Mean {
    fn add(&mut self, texel: Option<&[u8; 4]>) {
        let [r, g, b, a] = texel.copied().unwrap_or_default();
        for (sum, channel) in self.sum.iter_mut().zip([r, g, b]) {
            *sum += (u32::from(channel) * u32::from(a) + NOTHING * (255 - u32::from(a))) / 255;
        }
        self.count += 1;
    }

    /// Mean color; transparent outside the sheet.
    fn color(&self) -> Color32 {
        let Some([r, g, b]) =
            (self.count > 0).then(|| self.sum.map(|sum| (sum / self.count) as u8))
        else {
            return Color32::TRANSPARENT;
        };
        Color32::from_rgb(r, g, b)
    }
}

/// Draws lines between the blocks, and between the views of a block where there is room.
fn lines(ui: &Ui, laid: &SheetPlacement, grid: &Grid) {
    let painter = ui.painter_at(laid.room);
    let whole = size(grid);
    let inner = [grid.light.theta, grid.light.phi + 2];
    let block = [inner[0] * grid.view.theta, inner[1] * grid.view.phi];
    let [first, last] = [laid.screen([0.0, 0.0]), laid.screen(whole.map(f64::from))];
    for (part, stroke) in [
        (inner, Stroke::new(1.0, Color32::from_white_alpha(28))),
        (block, Stroke::new(1.0, Color32::from_white_alpha(60))),
    ] {
        if part.into_iter().any(|side| f64::from(side) * laid.zoom < LINED) {
            continue;
        }
        for (axis, [from, to]) in laid.seen(whole).into_iter().enumerate() {
            for index in from / part[axis]..=to / part[axis] {
                let at = laid.screen([f64::from(index * part[axis]); 2]);
                match axis {
                    0 => painter.vline(at.x, first.y..=last.y, stroke),
                    _ => painter.hline(first.x..=last.x, at.y, stroke),
                };
            }
        }
    }
}

/// Marks the visible texels of the sample at work.
fn mark(ui: &Ui, laid: &SheetPlacement, grid: &Grid, at: Address) {
    if laid.zoom < MARKED {
        return;
    }
    let [[left, right], [top, bottom]] = laid.seen(size(grid));
    let [across, down] = [grid.view.theta * grid.light.theta, grid.view.phi * (grid.light.phi + 2)]
        .map(|side| side.max(1));
    for iy in top / down..=(bottom / down).min(grid.size[1] - 1) {
        for ix in left / across..=(right / across).min(grid.size[0] - 1) {
            let texel = place(grid, at, [ix as usize, iy as usize]).map(|side| side as u32);
            outline(ui, laid, texel, theme::of(ui).accent);
        }
    }
}

fn outline(ui: &Ui, laid: &SheetPlacement, texel: [u32; 2], color: Color32) {
    let [x, y] = texel.map(f64::from);
    let rect = Rect::from_min_max(laid.screen([x, y]), laid.screen([x + 1.0, y + 1.0]));
    let painter = ui.painter_at(laid.room);
    painter.rect_stroke(
        rect.expand(1.0),
        0.0,
        Stroke::new(1.0, Color32::BLACK),
        StrokeKind::Outside,
    );
    painter.rect_stroke(rect, 0.0, Stroke::new(1.0, color), StrokeKind::Outside);
}

/// Description of the texel under the pointer: its place in the six dimensions, its color, and its
/// origin.
fn tell(work: &OpenPainting, held: &SheetTexel) -> [String; 3] {
    let SheetTexel { address, texel: [x, y], is_copy } = *held;
    let grid = work.grid();
    let [r, g, b, a] = work.tile(address).map_or([0; 4], |tile| tile.texel(x.into(), y.into()));
    let color = format!("#{r:02x}{g:02x}{b:02x}, {:.0}%", f64::from(a) / 2.55);
    let state = told_state(work.state(address));
    let light = moves::name(grid.light, address.light);
    let view = moves::name(grid.view, address.view);
    [
        match is_copy {
            true => tr!("Texel {x}, {y}: {color}, {state}, a copy"),
            false => tr!("Texel {x}, {y}: {color}, {state}"),
        },
        tr!(
            "Light ring {ring}, step {step}: {light}",
            ring = address.light.theta,
            step = address.light.phi
        ),
        tr!(
            "Eye ring {ring}, step {step}: {view}",
            ring = address.view.theta,
            step = address.view.phi
        ),
    ]
}

/// Shows lines of text in a corner.
fn plate(ui: &Ui, room: Rect, lines: [String; 3]) {
    let font = FontId::proportional(theme::SMALL_TEXT);
    let painter = ui.painter_at(room);
    let galleys = lines.map(|text| painter.layout_no_wrap(text, font.clone(), Color32::WHITE));
    let width = galleys.iter().map(|galley| galley.size().x).fold(0.0, f32::max);
    let high: f32 = galleys.iter().map(|galley| galley.size().y).sum();
    let corner = room.left_bottom() + vec2(6.0, -high - 14.0);
    painter.rect_filled(
        Rect::from_min_size(corner, vec2(width + 14.0, high + 8.0)),
        4.0,
        theme::PLATE,
    );
    let mut at = corner + vec2(7.0, 4.0);
    for galley in galleys {
        let down = galley.size().y;
        painter.galley(at, galley, Color32::WHITE);
        at.y += down;
    }
}
