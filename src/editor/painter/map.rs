//! All samples at a glance: views across, lights down, each ring of directions apart from the next.
//! A full square is painted, a smaller one filled by a rule, a point is empty; where there is room
//! each sample shows its thumbnail.

use chiaro_locale::tr;
use eframe::egui::{
    Color32, FontId, Pos2, Rect, Response, RichText, Role, ScrollArea, Sense, Stroke, StrokeKind,
    Ui, WidgetInfo, pos2, vec2,
};

pub(super) use super::atlas::Atlas;
use super::easel::name_of;
use super::list::copy_to;
use super::told_state;
use crate::commands::{Command, PaintCommand};
use crate::document::{Address, Direction, Directions, HcbtfEdit};
use crate::hcbtf::Provenance;
use crate::state::painting::work::{OpenPainting, SampleState};
use crate::widgets::number::number_slider;
use crate::widgets::theme;

/// Gap between rings, in points.
const GAP: f32 = 3.0;
/// Room for the names of rings, in points.
const HEAD: f32 = 24.0;
const TOP: f32 = 14.0;
/// Smallest side of a cell that shows its thumbnail, in points.
const PICTURE: f32 = 13.0;
/// Smallest side of a cell that can be hit, in points.
const LEAST: f32 = 8.0;
const LARGEST: f32 = 56.0;

/// Display of the map.
#[derive(Default)]
pub(super) struct Map {
    /// Side of a cell in points; `None` to fit the width.
    side: Option<f32>,
    /// Position of the first cell and the side of cells, in the last frame.
    laid: Option<(Pos2, f32)>,
    grid: Option<crate::document::Grid>,
    /// Cell whose menu is open.
    menu: Option<Address>,
}

/// Offset of a direction in a row of cells, in points: rings are apart.
fn offset(directions: Directions, direction: Direction, side: f32) -> f32 {
    directions.index(direction) as f32 * side + direction.theta as f32 * GAP
}

fn length(directions: Directions, side: f32) -> f32 {
    directions.distinct_count() as f32 * side + (directions.theta.max(1) - 1) as f32 * GAP
}

/// Direction at an offset in a row of cells.
fn at(directions: Directions, place: f32, side: f32) -> Option<Direction> {
    directions.distinct().find(|direction| {
        let from = offset(directions, *direction, side);
        (from..from + side).contains(&place)
    })
}

impl Map {
    /// Shows the map. `peek` is set while a sample is only looked at.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        work: &OpenPainting,
        atlas: &Atlas,
        peek: &mut Option<Address>,
        out: &mut Vec<Command>,
    ) {
        let grid = *work.grid();
        let room = ui.available_width() - HEAD - 14.0;
        let gaps = (grid.view.theta.max(1) - 1) as f32 * GAP;
        let across = ((room - gaps) / grid.view.distinct_count() as f32).clamp(4.0, LARGEST);
        // All rows are fitted where that leaves cells that can be hit; otherwise the map scrolls
        // downward.
        let rows = ui.available_height() - TOP - 40.0 - (grid.light.theta.max(1) - 1) as f32 * GAP;
        let fitting = across.min((rows / grid.light.distinct_count() as f32).max(LEAST));
        ui.horizontal_wrapped(|ui| {
            legend(ui, work);
            let mut side = self.side.unwrap_or(fitting);
            ui.spacing_mut().slider_width = 70.0;
            let help = tr!("How large the cells are; larger ones show their pictures");
            ui.label(tr!("Cells")).on_hover_text(help);
            let slider = ui.add(number_slider(ui, &mut side, 4.0..=LARGEST).show_value(false));
            slider.widget_info(|| {
                WidgetInfo::slider(true, f64::from(side), tr!("Size of the map's cells"))
            });
            if slider.on_hover_text(help).changed() {
                self.side = Some(side);
            }
            if self.side.is_some()
                && ui
                    .small_button(tr!("Fit"))
                    .on_hover_text(tr!("All views side by side"))
                    .clicked()
            {
                self.side = None;
            }
        });
        let side = self.side.unwrap_or(fitting);
        let size = vec2(length(grid.view, side) + HEAD, length(grid.light, side) + TOP + 4.0);
        let height = ui.available_height().max(60.0);
        ScrollArea::both().id_salt("map").max_height(height).auto_shrink([false, true]).show(
            ui,
            |ui| {
                let (rect, response) = ui.allocate_exact_size(size, Sense::click());
                response
                    .widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Map of samples")));
                let origin = rect.min + vec2(HEAD, TOP);
                (self.laid, self.grid) = (Some((origin, side)), Some(grid));
                heads(ui, work, rect, origin, side);
                cells(ui, work, atlas, origin, side);
                self.point(ui, &response, work, peek, out);
            },
        );
    }

    /// Rectangle of a sample's cell on the screen.
    pub(super) fn cell(&self, address: Address) -> Option<Rect> {
        let ((origin, side), grid) = self.laid.zip(self.grid)?;
        let address = address.canonical();
        let by =
            vec2(offset(grid.view, address.view, side), offset(grid.light, address.light, side));
        grid.contains(address).then(|| Rect::from_min_size(origin + by, vec2(side, side)))
    }

    fn point(
        &mut self,
        ui: &Ui,
        response: &Response,
        work: &OpenPainting,
        peek: &mut Option<Address>,
        out: &mut Vec<Command>,
    ) {
        let Some((origin, side)) = self.laid else { return };
        let grid = work.grid();
        let found = |place: Pos2| {
            let by = place - origin;
            Some(Address { view: at(grid.view, by.x, side)?, light: at(grid.light, by.y, side)? })
        };
        let hovered = response.hover_pos().and_then(found);
        let (alt, shift) = ui.input(|input| (input.modifiers.alt, input.modifiers.shift));
        if let Some(address) = hovered {
            let cell = self.cell(address).unwrap_or(Rect::NOTHING);
            ui.painter().rect_stroke(
                cell,
                0.0,
                Stroke::new(1.5, Color32::WHITE),
                StrokeKind::Outside,
            );
            if alt {
                *peek = Some(address);
            }
            if response.secondary_clicked() {
                self.menu = Some(address);
            }
            if response.clicked() && shift {
                out.extend(copy_to(work, address, work.at()));
            } else if response.clicked() {
                out.push(Command::Paint(PaintCommand::GoTo(address)));
            }
        }
        if let Some(address) = self.menu {
            response.context_menu(|ui| menu(ui, work, address, out));
        }
        if let Some(address) = hovered {
            let state = match work.state(address) {
                SampleState::Empty => tr!("empty: no rule fills it").to_owned(),
                state => told_state(state),
            };
            let name = name_of(work, address);
            let help = tr!(
                "Click: work here · Shift-click: copy it to the sample at work · hold Alt: only \
                 look"
            );
            response.clone().on_hover_text_at_pointer(format!("{name}\n{state}\n{help}"));
        }
    }
}

fn menu(ui: &mut Ui, work: &OpenPainting, address: Address, out: &mut Vec<Command>) {
    ui.label(name_of(work, address));
    if ui.button(tr!("Work here")).clicked() {
        out.push(Command::Paint(PaintCommand::GoTo(address)));
    }
    if ui.button(tr!("Copy to the sample at work")).clicked() {
        out.extend(copy_to(work, address, work.at()));
    }
    if ui.button(tr!("Copy the sample at work to here")).clicked() {
        out.extend(copy_to(work, work.at(), address));
    }
    let is_painted = work.state(address) == SampleState::Painted;
    if ui
        .add_enabled(is_painted, eframe::egui::Button::new(tr!("Delete what is painted here")))
        .clicked()
    {
        out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::DeleteTile { address })));
    }
}

/// Shows the meaning of the marks, and the number of samples of each.
fn legend(ui: &mut Ui, work: &OpenPainting) {
    let painted = work.hcbtf().painted.len();
    let filled = work.filled().map_or(0, |filled| {
        filled
            .iter()
            .filter(|(_, _, provenance)| matches!(provenance, Provenance::Filled { .. }))
            .count()
    });
    let all = work.grid().sample_count() as usize;
    let colors = theme::of(ui);
    let marks = [
        (9.0, colors.accent, tr!("{count} painted", count = painted)),
        (5.0, colors.second, tr!("{count} filled", count = filled)),
    ];
    for (side, color, text) in marks {
        let (rect, _) = ui.allocate_exact_size(vec2(10.0, 12.0), Sense::hover());
        ui.painter().rect_filled(
            Rect::from_center_size(rect.center(), vec2(side, side)),
            0.0,
            color,
        );
        ui.label(text);
    }
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, 12.0), Sense::hover());
    ui.painter().circle_filled(rect.center(), 1.5, colors.dim);
    ui.label(tr!("{count} empty", count = all.saturating_sub(painted + filled)));
    let help = tr!(
        "Each column is a place of the eye, each row one of the light, from straight above to the \
         horizon"
    );
    ui.label(RichText::new(tr!("eye across, light down")).color(colors.dim)).on_hover_text(help);
}

/// Draws the names of rings: the angle between the direction and the normal.
fn heads(ui: &Ui, work: &OpenPainting, rect: Rect, origin: Pos2, side: f32) {
    let grid = work.grid();
    let font = FontId::proportional(theme::SMALL_TEXT - 1.0);
    let ink = theme::of(ui).dim;
    let painter = ui.painter();
    for (directions, is_across) in [(grid.view, true), (grid.light, false)] {
        for theta in 0..directions.theta {
            let first = Direction { theta, phi: 0 };
            let from = offset(directions, first, side);
            let angle = directions.angles(first)[0].to_degrees();
            let at = match is_across {
                true => pos2(origin.x + from, rect.top()),
                false => pos2(rect.left(), origin.y + from),
            };
            // The ring of the normal is a single cell, which has no room for a name where cells are
            // small.
            let has_room = theta > 0 || side > 24.0 || !is_across && side > 10.0;
            if has_room {
                let text = format!("{angle:.0}°");
                painter.text(at, eframe::egui::Align2::LEFT_TOP, text, font.clone(), ink);
            }
        }
    }
}

fn cells(ui: &Ui, work: &OpenPainting, atlas: &Atlas, origin: Pos2, side: f32) {
    let colors = theme::of(ui);
    let painter = ui.painter();
    let grid = work.grid();
    let clip = ui.clip_rect();
    for view in grid.view.distinct() {
        let x = origin.x + offset(grid.view, view, side);
        if x > clip.max.x || x + side < clip.min.x {
            continue;
        }
        for light in grid.light.distinct() {
            let cell = Rect::from_min_size(
                pos2(x, origin.y + offset(grid.light, light, side)),
                vec2(side, side),
            );
            if !cell.intersects(clip) {
                continue;
            }
            let address = Address { view, light };
            let state = work.state(address);
            let inner = cell.shrink(if side > 8.0 { 1.0 } else { 0.5 });
            match state {
                SampleState::Empty => {
                    painter.circle_filled(cell.center(), (side * 0.1).max(0.6), colors.dim);
                }
                SampleState::Painted | SampleState::Filled(_) if side >= PICTURE => {
                    let picture = if state == SampleState::Painted {
                        inner
                    } else {
                        inner.shrink(side * 0.1)
                    };
                    atlas.paint(painter, work, address, picture);
                    if state == SampleState::Painted {
                        painter.rect_stroke(
                            inner,
                            0.0,
                            Stroke::new(1.5, colors.accent),
                            StrokeKind::Inside,
                        );
                    }
                }
                SampleState::Painted => drop(painter.rect_filled(inner, 0.0, colors.accent)),
                SampleState::Filled(_) => {
                    painter.rect_filled(
                        cell.shrink(side * 0.26),
                        0.0,
                        colors.second.gamma_multiply(0.75),
                    );
                }
            }
        }
    }
    let at = work.at();
    let by = vec2(offset(grid.view, at.view, side), offset(grid.light, at.light, side));
    let cell = Rect::from_min_size(origin + by, vec2(side, side));
    painter.rect_stroke(
        cell.expand(1.0),
        0.0,
        Stroke::new(2.0, Color32::WHITE),
        StrokeKind::Outside,
    );
    painter.rect_stroke(
        cell.expand(2.5),
        0.0,
        Stroke::new(1.0, Color32::BLACK),
        StrokeKind::Outside,
    );
}
