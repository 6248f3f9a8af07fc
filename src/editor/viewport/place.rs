//! Places on the screen, of points of the picture and of the world, and places in the world where
//! the pointer is.

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

/// Ray from the eye through a place of the picture, in world space.
#[derive(Clone, Copy, Debug)]
pub(super) struct PictureRay {
    pub(super) origin: DVec3,
    /// Unit.
    pub(super) direction: DVec3,
}

/// Ray through a point of the screen.
pub(super) fn ray_through(session: &Session, rect: Rect, at: Pos2) -> PictureRay {
    let offset = (at - rect.center()) / rect.height();
    let place = [f64::from(offset.x), f64::from(-offset.y)];
    let (origin, direction) = session.view.orbit.ray_through(place);
    PictureRay { origin, direction }
}

/// Place where a ray cuts the plane through `point`; `None` where it does so behind the eye or
/// nowhere.
pub(super) fn on_plane(point: DVec3, normal: DVec3, ray: PictureRay) -> Option<DVec3> {
    let along = (point - ray.origin).dot(normal) / ray.direction.dot(normal);
    (along.is_finite() && along > 0.0).then(|| ray.origin + ray.direction * along)
}

/// Distance along a line from `center`, in a unit direction, at which a ray comes nearest to the
/// line; `None` for a line that is seen from its end, which has no length to be dragged.
pub(super) fn nearest_along(center: DVec3, axis: DVec3, ray: PictureRay) -> Option<f64> {
    let between = center - ray.origin;
    let cosine = axis.dot(ray.direction);
    let square = 1.0 - cosine * cosine;
    (square > 1e-3).then(|| (cosine * between.dot(ray.direction) - between.dot(axis)) / square)
}
