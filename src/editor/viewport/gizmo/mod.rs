//! Handles of the selected object in the picture: arrows that move it, rings that turn it, squares
//! that scale it.
//!
//! Moves are along the axes of the world, turns and scales along those of the object, as its
//! transform has them. Each handle is a widget with a name, so that arrow keys move it, too. A drag
//! is one step; Escape gives it back.

mod drag;

use chiaro_locale::tr;
use eframe::egui::{Id, Key, Modifiers, Pos2, Rect, Shape, Stroke, Ui, Vec2, vec2};
use glam::DVec3;

use super::place::{project, ray_through};
use crate::commands::{Command, SceneCommand};
use crate::document::Transform;
use crate::ids::ObjectId;
use crate::state::session::Session;
use crate::state::view::TransformPart;
use crate::widgets::handle::{HandleResponse, focus_ring, handle};
use crate::widgets::theme;
use drag::{GizmoHandle, PictureAxes, own_axis};

/// Distance of the handles from the object's place, in points.
const LENGTH: f32 = 72.0;
/// Least length at which an axis is seen, in points.
const LEAST_LENGTH: f32 = 14.0;
/// Radius of a handle, and way that an arrow key moves it, in points.
const RADIUS: f32 = 5.0;
const STEP: f32 = 4.0;
/// Number of points along a ring.
const POINTS: u32 = 64;
/// Opacity of the far half of a ring.
const FAR: f32 = 0.35;

/// An object whose handles are shown.
struct Gizmo<'a> {
    rect: Rect,
    session: &'a Session,
    object: &'a ObjectId,
    transform: Transform,
    axes: PictureAxes,
    /// Distance of the handles from the object's place, in scene units.
    length: f64,
    center: Pos2,
}

/// Transform and place of a handle when its drag began.
#[derive(Clone, Copy)]
struct DragOrigin(Transform, DVec3);

/// Shows the handles of the selected object. Returns true while one is hovered or held.
pub(super) fn show(ui: &Ui, rect: Rect, session: &Session, out: &mut Vec<Command>) -> bool {
    let Some(part) = session.view.handled else { return false };
    let Some(gizmo) = Gizmo::of(rect, session) else { return false };
    let mut is_busy = false;
    for handle in handles(part) {
        is_busy |= gizmo.handle(ui, handle, out);
    }
    is_busy
}

fn handles(part: TransformPart) -> Vec<GizmoHandle> {
    let along = |of: fn(usize) -> GizmoHandle| (0..3).map(of);
    match part {
        TransformPart::Place => along(GizmoHandle::Move).chain([GizmoHandle::MoveAcross]).collect(),
        TransformPart::Turn => along(GizmoHandle::Turn).collect(),
        TransformPart::Scale => along(GizmoHandle::Scale).chain([GizmoHandle::ScaleAll]).collect(),
    }
}

impl<'a> Gizmo<'a> {
    fn of(rect: Rect, session: &'a Session) -> Option<Self> {
        let (object, content) = session.open_scene()?.selected()?;
        let orbit = &session.view.orbit;
        let (right, up) = orbit.right_and_up();
        let place = DVec3::from(content.transform.translate);
        let center = project(place, rect, session)?;
        let unit = project(place + right, rect, session)?.x - center.x;
        (unit > 0.0 && unit.is_finite()).then(|| Self {
            rect,
            session,
            object,
            transform: content.transform,
            axes: PictureAxes { right, up, backward: orbit.direction() },
            length: f64::from(LENGTH / unit),
            center,
        })
    }

    /// Shows a handle. Returns true while it is hovered or held.
    fn handle(&self, ui: &Ui, of: GizmoHandle, out: &mut Vec<Command>) -> bool {
        let place = of.place(&self.transform, &self.axes, self.length);
        let Some(at) = project(place, self.rect, self.session) else { return false };
        let is_end_on = at.distance(self.center) < LEAST_LENGTH;
        let can_be_end_on = matches!(of, GizmoHandle::Move(_) | GizmoHandle::Scale(_));
        if is_end_on && can_be_end_on || !self.rect.expand(2.0).contains(at) {
            return false;
        }
        let id = Id::unique("handle of an object").with((self.object, format!("{of:?}")));
        let label = of.label(self.object.as_str());
        let handled = handle(ui, id, at, &label, of.value(&self.transform), true);
        if let Some(new) = self.dragged(ui, of, (place, at), id, &handled)
            && let Some(open_scene) = self.session.open_scene()
        {
            let edit = open_scene.change(self.object, |object| object.transform = new);
            let command = |edit| Command::Scene(SceneCommand::EditHeld(id, edit));
            out.extend(edit.filter(|_| new != self.transform).map(command));
        }
        let is_hot = handled.response.hovered() || handled.response.dragged();
        self.paint(ui, of, at, is_hot);
        focus_ring(ui, &handled.response, at, RADIUS);
        let help = tr!("Arrow keys move it, too; with Ctrl it goes by steps");
        handled.response.on_hover_text(format!("{label}. {help}"));
        is_hot
    }

    /// Transform that the pointer or the keys ask for.
    fn dragged(
        &self,
        ui: &Ui,
        of: GizmoHandle,
        (place, at): (DVec3, Pos2),
        id: Id,
        handled: &HandleResponse,
    ) -> Option<Transform> {
        let key = id.with("origin");
        let now = DragOrigin(self.transform, place);
        if handled.response.drag_started() {
            ui.data_mut(|data| data.insert_temp(key, now));
        }
        let origin = ui.data(|data| data.get_temp(key)).unwrap_or(now);
        if handled.response.dragged()
            && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape))
        {
            ui.ctx().stop_dragging();
            return Some(origin.0);
        }
        let by_keys = vec2(handled.steps.x, -handled.steps.y) * STEP;
        let (DragOrigin(start, from), to) = match handled.to {
            Some(to) => (origin, to),
            None if by_keys != Vec2::ZERO => (now, at + by_keys),
            None => return None,
        };
        let snaps = handled.to.is_some() && ui.input(|input| input.modifiers.command);
        let ray = ray_through(self.session, self.rect, to);
        of.dragged((&start, from), ray, &self.axes, snaps)
    }

    fn paint(&self, ui: &Ui, of: GizmoHandle, at: Pos2, is_hot: bool) {
        let painter = ui.painter_at(self.rect);
        let radius = if is_hot { RADIUS + 1.5 } else { RADIUS };
        let width = if is_hot { 2.5 } else { 1.75 };
        let line = |points: [Pos2; 2], color| {
            painter.line_segment(points, Stroke::new(width + 2.0, theme::HALO));
            painter.line_segment(points, Stroke::new(width, color));
        };
        match of {
            GizmoHandle::Move(axis) => {
                let color = theme::AXES[axis];
                line([self.center, at], color);
                let along = (at - self.center).normalized();
                let across = along.rot90() * radius;
                let tip = at + along * 2.0 * radius;
                let arrow = |size: f32| vec![tip, at + across * size, at - across * size];
                painter.add(Shape::convex_polygon(
                    arrow(1.0),
                    color,
                    Stroke::new(1.0, theme::HALO),
                ));
            }
            GizmoHandle::Turn(axis) => {
                self.ring(ui, axis, width);
                painter.circle_filled(at, radius + 1.5, theme::HALO);
                painter.circle_filled(at, radius, theme::AXES[axis]);
            }
            GizmoHandle::MoveAcross => {
                painter.circle_filled(at, radius + 1.5, theme::HALO);
                painter.circle_filled(at, radius, theme::SUN);
            }
            GizmoHandle::Scale(_) | GizmoHandle::ScaleAll => {
                let color = match of {
                    GizmoHandle::Scale(axis) => theme::AXES[axis],
                    _ => theme::SUN,
                };
                line([self.center, at], color);
                let square = |half: f32| Rect::from_center_size(at, Vec2::splat(2.0 * half));
                painter.rect_filled(square(radius + 1.5), 1.5, theme::HALO);
                painter.rect_filled(square(radius), 1.0, color);
            }
        }
    }

    /// Draws the ring around an axis of the object, its far half faintly.
    fn ring(&self, ui: &Ui, axis: usize, width: f32) {
        let painter = ui.painter_at(self.rect);
        let center = DVec3::from(self.transform.translate);
        let [across, up] = [1, 2].map(|next| own_axis(&self.transform, axis + next));
        let point = |index: u32| {
            let (sin, cos) =
                (f64::from(index) * std::f64::consts::TAU / f64::from(POINTS)).sin_cos();
            let away = across * cos + up * sin;
            let is_near = away.dot(self.axes.backward) > -1e-6;
            let at = project(center + away * self.length, self.rect, self.session);
            at.map(|at| (at, is_near))
        };
        let points: Vec<(Pos2, bool)> = (0..=POINTS).filter_map(point).collect();
        for pair in points.windows(2) {
            let &[(a, is_near), (b, is_near_too)] = pair else { continue };
            let color = theme::AXES[axis];
            let color = match is_near && is_near_too {
                true => color,
                false => color.gamma_multiply(FAR),
            };
            painter.line_segment([a, b], Stroke::new(width, color));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_has_handles_for_all_axes() {
        for part in TransformPart::ALL {
            let handles = handles(part);
            assert!(handles.len() >= 3, "{part:?}");
            let labels: std::collections::BTreeSet<String> =
                handles.iter().map(|handle| handle.label("hat")).collect();
            assert_eq!(labels.len(), handles.len(), "{part:?}");
        }
    }
}
