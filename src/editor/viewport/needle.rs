//! Needle of a directional light on the screen: from outside of what is lit toward the light.
//!
//! A needle whose end lies outside of the picture, as with a camera that stands near, is drawn up
//! to the edge and ends in an arrow there, so that it can always be seen and dragged. A drag begins
//! at the arrow without a jump of the light: on the first points of its way the end that is meant
//! comes from outside to the pointer.

use std::f64::consts::TAU;

use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};

use super::lights::resolved;
use super::project;
use crate::document::{Light, LightKind, Projection};
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;
use crate::widgets::theme;

/// Beginning and end of a needle, in radii of what is lit.
const NEAR: f64 = 1.06;
pub(super) const FAR: f64 = 1.25;
/// Distance of an arrow's tip from the edge of the picture, in points.
const MARGIN: f32 = 10.0;
/// Length of an arrow whose beginning is outside of the picture too, in points.
const ARROW: f32 = 26.0;
/// Way of the pointer up to which the end of a cut needle goes along with it, and way on which the
/// end then comes to it, in points. A step by an arrow key is within the first.
const ALONG: f32 = 8.0;
const CATCH: f32 = 90.0;
/// Number of points of the ball's outline.
const POINTS: u32 = 72;

/// End of a needle outside of the picture: where it is drawn, and how far it is from there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CutEnd {
    drawn: Pos2,
    beyond: Vec2,
}

impl CutEnd {
    /// End that is meant while the pointer is at a place.
    pub(super) fn end_for(self, pointer: Pos2) -> Pos2 {
        let way = (pointer.distance(self.drawn) - ALONG).max(0.0);
        let left = (1.0 - way / CATCH).max(0.0);
        pointer + self.beyond * left
    }
}

/// Needle on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Needle {
    pub(super) from: Pos2,
    /// End that is drawn and dragged, within the picture.
    pub(super) to: Pos2,
    /// True if the light is behind what it lights.
    pub(super) is_behind: bool,
    /// The end outside of the picture, if it is there.
    pub(super) cut: Option<CutEnd>,
}

impl Needle {
    /// Needle of a light; `None` for a lamp, and where the camera stands in its way.
    pub(super) fn of(light: &Light, rect: Rect, session: &Session) -> Option<Self> {
        if light.kind != LightKind::Directional {
            return None;
        }
        let (center, radius) = sphere_of_lights(session.open_scene());
        let toward = resolved(light, session).direction();
        let orbit = &session.view.orbit;
        let at = |far: f64| project(center + toward * far * radius, rect, session);
        // Behind is the side of the ball that turns away from the eye, which may stand near.
        let to_eye = match orbit.projection {
            Projection::Orthographic => orbit.direction(),
            Projection::Perspective => {
                orbit.target + orbit.direction() * orbit.distance - center - toward * FAR * radius
            }
        };
        let is_behind = toward.dot(to_eye) < 0.0;
        let (from, to) = (at(NEAR)?, at(FAR)?);
        // A needle at the eye's own place would be drawn anywhere.
        let is_somewhere = [from, to].iter().all(|end| end.is_finite());
        let middle = project(center, rect, session).unwrap_or(rect.center());
        is_somewhere.then(|| Self::within(rect.shrink(MARGIN), middle, [from, to], is_behind))
    }

    /// The needle with its end within `room`; `middle` is the middle of what is lit.
    fn within(room: Rect, middle: Pos2, [from, to]: [Pos2; 2], is_behind: bool) -> Self {
        if room.contains(to) || !room.is_positive() {
            return Self { from, to, is_behind, cut: None };
        }
        // The arrow points where the light is from the middle of what is lit, or else from the
        // middle of the picture.
        let start = if room.contains(middle) { middle } else { room.center() };
        let drawn = leaving(room, start, to);
        let way = (to - start).normalized();
        let from = match room.contains(from) && (drawn - from).length() >= ARROW {
            true => from,
            false => drawn - way * ARROW,
        };
        let cut = Some(CutEnd { drawn, beyond: to - drawn });
        Self { from, to: drawn, is_behind, cut }
    }

    /// Draws the needle: a pin whose head is the light, or an arrow to a light outside.
    pub(super) fn paint(&self, painter: &Painter, color: Color32, strength: f32, is_held: bool) {
        let Self { from, to, cut, .. } = *self;
        let halo = theme::HALO.gamma_multiply(strength);
        painter.line_segment([from, to], Stroke::new(4.0, halo));
        if cut.is_none() {
            painter.circle_filled(to, if is_held { 8.0 } else { 6.0 }, theme::HALO);
            painter.line_segment([from, to], Stroke::new(2.0, color));
            painter.circle_filled(to, if is_held { 6.5 } else { 4.5 }, color);
            return;
        }
        let way = (to - from).normalized();
        let head = |size: f32| {
            let back = to - way * size;
            let aside = way.rot90() * (0.5 * size);
            vec![to + way * (0.2 * size), back + aside, back - aside]
        };
        let size = if is_held { 14.0 } else { 11.0 };
        painter.add(Shape::convex_polygon(head(size + 4.0), halo, Stroke::NONE));
        painter.line_segment([from, to - way * size], Stroke::new(2.0, color));
        painter.add(Shape::convex_polygon(head(size), color, Stroke::NONE));
    }
}

/// Draws the outline of the ball that needles end on: a drag over it and back leads to the other
/// side.
pub(super) fn paint_rim(painter: &Painter, rect: Rect, session: &Session) {
    let (center, radius) = sphere_of_lights(session.open_scene());
    let (orbit, radius) = (&session.view.orbit, FAR * radius);
    let backward = orbit.direction();
    let to_eye = orbit.target + backward * orbit.distance - center;
    let is_near = orbit.projection == Projection::Perspective;
    // Seen from nearby, the outline is a smaller circle, in front of the middle.
    let (axis, share) = match is_near {
        true => (to_eye.normalize_or(backward), radius / to_eye.length()),
        false => (backward, 0.0),
    };
    if !(0.0..1.0).contains(&share) {
        return;
    }
    let (across, up) = axis.any_orthonormal_pair();
    let (middle, round) = (center + axis * radius * share, radius * (1.0 - share * share).sqrt());
    let points: Option<Vec<Pos2>> = (0..=POINTS)
        .map(|index| {
            let (sin, cos) = (f64::from(index) * TAU / f64::from(POINTS)).sin_cos();
            project(middle + (across * cos + up * sin) * round, rect, session)
        })
        .collect();
    let points = points.unwrap_or_default();
    painter.add(Shape::line(points.clone(), Stroke::new(3.0, theme::HALO.gamma_multiply(0.5))));
    painter.extend(Shape::dashed_line(&points, Stroke::new(1.2, theme::SUN), 5.0, 5.0));
}

/// Point where the way from a point within a rectangle to one outside leaves it.
fn leaving(room: Rect, from: Pos2, to: Pos2) -> Pos2 {
    let way = to - from;
    let part = |along: f32, low: f32, high: f32, start: f32| match along {
        along if along > 0.0 => (high - start) / along,
        along if along < 0.0 => (low - start) / along,
        _ => f32::INFINITY,
    };
    let x = part(way.x, room.left(), room.right(), from.x);
    let y = part(way.y, room.top(), room.bottom(), from.y);
    room.clamp(from + way * x.min(y).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use eframe::egui::pos2;

    use super::*;

    #[test]
    fn a_needle_ends_within_the_picture_and_points_to_its_light() {
        let room = Rect::from_min_max(pos2(10.0, 10.0), pos2(410.0, 310.0));
        let middle = pos2(100.0, 200.0);
        let of = |from, to| Needle::within(room, middle, [from, to], false);
        let inside = of(pos2(120.0, 150.0), pos2(130.0, 120.0));
        assert_eq!((inside.to, inside.cut), (pos2(130.0, 120.0), None));
        for to in [pos2(90.0, -300.0), pos2(9000.0, 150.0), pos2(-40.0, 900.0), pos2(600.0, 320.0)]
        {
            for share in [0.2, 0.9] {
                let needle = of(middle + (to - middle) * share, to);
                let cut = needle.cut.expect("it is cut");
                assert!(room.expand(1e-3).contains(needle.to), "{to}: {needle:?}");
                let [shown, meant] = [needle.to - needle.from, to - middle].map(Vec2::normalized);
                assert!(shown.dot(meant) > 0.9999, "{to}: {needle:?}");
                // The light does not move when its arrow is taken, nor jump while that goes on.
                assert!(cut.end_for(needle.to).distance(to) < 1e-2 * to.to_vec2().length());
                let away = needle.to - meant * (ALONG + CATCH);
                assert!(cut.end_for(away).distance(away) < 1e-3, "and then it is at the pointer");
            }
        }
    }
}
