//! Handles of the selected filter of a light in the picture: what stands in the way is moved,
//! turned and sized there; flaps, thrown pictures and distances are drawn at their lamp and dragged
//! by their edges.
//!
//! Each handle is a widget with a name, so that arrow keys move it, too. A drag is one step. Values
//! that come by wires have no handle.

mod form;
mod grip;

use chiaro_locale::tr;
use eframe::egui::{Id, Pos2, Rect, Shape, Stroke, Ui, vec2};
use glam::DVec3;

use super::place::ray_through;
use super::project;
use crate::commands::Command;
use crate::fields::filter::SelectedFilter;
use crate::state::session::Session;
use crate::widgets::handle::{focus_ring, handle};
use crate::widgets::theme;
use form::FilterForm;

/// Way that an arrow key moves a handle, in points.
const STEP: f32 = 4.0;
/// Radius of a handle, in points.
const RADIUS: f32 = 4.5;

/// Draws the selected filter, and shows its handles. Returns true while one is hovered or held.
pub(super) fn show(ui: &Ui, rect: Rect, session: &Session, out: &mut Vec<Command>) -> bool {
    let Some(filter) = SelectedFilter::of(session) else { return false };
    let Some(form) = FilterForm::of(&filter, session, rect.aspect_ratio()) else { return false };
    let painter = ui.painter_at(rect);
    let accent = theme::SUN;
    for (line, is_soft) in &form.lines {
        let points = on_screen(line, rect, session);
        painter.add(Shape::line(points.clone(), Stroke::new(3.5, theme::HALO)));
        let stroke = Stroke::new(1.5, accent);
        match is_soft {
            true => painter.extend(Shape::dashed_line(&points, stroke, 5.0, 4.0)),
            false => painter.extend([Shape::line(points, stroke)]),
        }
    }
    let mut is_busy = false;
    for grip in &form.grips {
        let Some(at) = project(grip.at, rect, session) else { continue };
        // A handle at the edge of the picture can still be reached.
        if !rect.expand(2.0).contains(at) {
            continue;
        }
        let id = Id::unique("filter handle").with((&filter.node, grip.name.english()));
        let label = tr!("{handle} of {filter}", handle = grip.name, filter = filter.name);
        let handled = handle(ui, id, at, &label, grip.value, true);
        let by_keys = vec2(handled.steps.x, -handled.steps.y) * STEP;
        let by_keys = (by_keys != eframe::egui::Vec2::ZERO).then_some(at + by_keys);
        if let Some(to) = handled.to.or(by_keys) {
            let ray = ray_through(session, rect, to);
            let value = grip.dragged(session.view.orbit.direction(), ray);
            out.extend(value.and_then(|value| filter.set(session, grip.port, value, id)));
        }
        let is_hot = handled.response.hovered() || handled.response.dragged();
        is_busy |= is_hot;
        let radius = if is_hot { RADIUS + 1.5 } else { RADIUS };
        painter.circle_filled(at, radius + 1.5, theme::HALO);
        painter.circle_filled(at, radius, accent);
        focus_ring(ui, &handled.response, at, radius);
        handled.response.on_hover_text(format!("{label}: {}", grip.help));
    }
    is_busy
}

fn on_screen(points: &[DVec3], rect: Rect, session: &Session) -> Vec<Pos2> {
    points.iter().filter_map(|point| project(*point, rect, session)).collect()
}
