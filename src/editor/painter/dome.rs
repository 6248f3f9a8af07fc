//! The hemisphere over the tile, seen from above, on which the light and the eye are dragged. The
//! middle is the normal, the rim the horizon; u points right and v up.

use chiaro_locale::tr;
use eframe::egui::{Color32, CursorIcon, Pos2, Rect, Role, Sense, Stroke, Ui, WidgetInfo, vec2};
use glam::DVec2;

use super::moves;
use crate::document::{Address, Direction, Directions};
use crate::state::painting::work::{OpenPainting, SampleState};
use crate::widgets::theme;

/// Distance of the rim from the edge of the widget, in points.
const MARGIN: f32 = 12.0;
const HANDLE: f32 = 7.0;

/// Handle that is dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HeldHandle {
    Light,
    View,
}

/// Shows the hemisphere, `side` points wide. Returns the sample that was dragged to.
pub(super) fn show(
    ui: &mut Ui,
    work: &OpenPainting,
    held: &mut Option<HeldHandle>,
    side: f32,
) -> Option<Address> {
    let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::click_and_drag());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Canvas, true, tr!("Light and eye over the tile"))
    });
    let grid = *work.grid();
    let at = work.at();
    let radius = f64::from(rect.width() / 2.0 - MARGIN);
    let screen =
        |place: DVec2| rect.center() + vec2((place.x * radius) as f32, (-place.y * radius) as f32);
    let place = |at: Pos2| {
        let by = (at - rect.center()) / radius as f32;
        DVec2::new(f64::from(by.x), f64::from(-by.y))
    };
    let light = screen(moves::place(grid.light, at.light));
    let view = screen(moves::place(grid.view, at.view))
        + if at.light == at.view { vec2(9.0, 0.0) } else { vec2(0.0, 0.0) };
    let nearest = |at: Pos2| {
        if at.distance(view) < at.distance(light) { HeldHandle::View } else { HeldHandle::Light }
    };
    let (is_down, origin) =
        ui.input(|input| (input.pointer.primary_down(), input.pointer.press_origin()));
    if !is_down {
        *held = None;
    } else if held.is_none() && response.is_pointer_button_down_on() {
        *held = origin.map(nearest);
    }
    let pointer = ui.input(|input| input.pointer.latest_pos());
    let hovered = response.hovered().then(|| pointer.map(nearest)).flatten();
    paint_ground(ui, rect, radius as f32);
    for (directions, is_view) in [(grid.light, false), (grid.view, true)] {
        if held.is_none_or(|held| (held == HeldHandle::View) == is_view) {
            dots(ui, work, directions, is_view, &screen);
        }
    }
    let ring = |held_by: HeldHandle| {
        if *held == Some(held_by) || hovered == Some(held_by) { 2.5 } else { 1.0 }
    };
    ui.painter().circle(
        view,
        HANDLE,
        theme::of(ui).second,
        Stroke::new(ring(HeldHandle::View), Color32::WHITE),
    );
    ui.painter().circle_filled(view, 2.5, Color32::WHITE);
    ui.painter().circle(
        light,
        HANDLE,
        theme::SUN,
        Stroke::new(ring(HeldHandle::Light), theme::of(ui).accent),
    );
    if hovered.is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
    }
    let to = pointer.map(place);
    let found = held.zip(to).map(|(held, to)| match held {
        HeldHandle::Light => Address { light: moves::nearest(grid.light, to), ..at },
        HeldHandle::View => Address { view: moves::nearest(grid.view, to), ..at },
    });
    response.on_hover_text(tr!(
        "Drag the sun to where the light comes from, and the eye to where it is seen from.\nThe \
         middle is straight above, the rim the horizon"
    ));
    found.filter(|found| *found != at)
}

fn paint_ground(ui: &Ui, rect: Rect, radius: f32) {
    let colors = theme::of(ui);
    let painter = ui.painter();
    painter.circle(rect.center(), radius, colors.canvas, Stroke::new(1.0, colors.swatch_edge));
    for share in [1.0 / 3.0, 2.0 / 3.0] {
        painter.circle_stroke(rect.center(), radius * share, Stroke::new(1.0, colors.grid));
    }
    painter.hline(
        rect.center().x - radius..=rect.center().x + radius,
        rect.center().y,
        Stroke::new(1.0, colors.grid),
    );
    painter.vline(
        rect.center().x,
        rect.center().y - radius..=rect.center().y + radius,
        Stroke::new(1.0, colors.grid),
    );
}

/// Draws the directions of a grid as dots; larger where a sample is painted for the direction
/// together with the other direction at work.
fn dots(
    ui: &Ui,
    work: &OpenPainting,
    directions: Directions,
    is_view: bool,
    screen: &impl Fn(DVec2) -> Pos2,
) {
    /// Largest number of directions that are drawn; more are a haze.
    const MOST: usize = 1200;
    if directions.count() > MOST {
        return;
    }
    let at = work.at();
    let of = |direction: Direction| match is_view {
        true => Address { view: direction, ..at },
        false => Address { light: direction, ..at },
    };
    let ink = if is_view { theme::of(ui).second } else { theme::of(ui).accent };
    for direction in directions.distinct() {
        let place = screen(moves::place(directions, direction));
        match work.state(of(direction)) {
            SampleState::Painted => drop(ui.painter().circle_filled(place, 3.2, ink)),
            _ => drop(ui.painter().circle_filled(place, 1.4, ink.gamma_multiply(0.6))),
        }
    }
}
