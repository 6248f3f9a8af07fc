//! Places on the screen: of points of the picture and of the world.

use eframe::egui::{Pos2, Rect, vec2};
use glam::DVec3;

use super::Handles;
use crate::state::session::Session;

/// Point of the screen in parts of the picture's size.
pub(super) fn place_in(rect: Rect, at: Pos2) -> [f32; 2] {
    [(at.x - rect.min.x) / rect.width(), (at.y - rect.min.y) / rect.height()]
}

/// True if a point of the screen is on the object, or within its bounding sphere, of radius 1,
/// while no surface is known.
pub(super) fn is_on_object(at: Pos2, rect: Rect, session: &Session, handles: &Handles) -> bool {
    if let Some(surface) = &handles.surface {
        return surface.piece_at(place_in(rect, at)).is_some();
    }
    if session.open_scene().is_some() {
        return false;
    }
    let radius = session.view.orbit.radius_in_picture() as f32 * rect.height();
    let center = project(DVec3::ZERO, rect, session).unwrap_or(rect.center());
    at.distance(center) < radius * 0.92
}

/// Position of a point of the world on the screen; `None` behind the eye.
pub(super) fn project(point: DVec3, rect: Rect, session: &Session) -> Option<Pos2> {
    let [x, y] = session.view.orbit.place_in_picture(point)?;
    Some(rect.center() + vec2(x as f32, -y as f32) * rect.height())
}
