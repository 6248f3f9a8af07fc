//! Directions to the light and to the eye, drawn as translucent arrows that end at the middle of
//! the tile.

use eframe::egui::{Color32, Painter, Pos2, Shape, Stroke, Ui, Vec2};
use glam::DVec3;

use super::tilt::Tilt;
use crate::widgets::theme;

/// Length of an arrow that lies flat, as a part of the tile's size on the screen.
const LENGTH: f32 = 0.62;
/// Length below which an arrow is seen end-on and drawn as a ring, in points.
const SHORT: f32 = 14.0;

/// Paints the arrow from the light, and the one from the eye where `eye` is given.
pub(super) fn paint(ui: &Ui, painter: &Painter, tilt: &Tilt, light: DVec3, eye: Option<DVec3>) {
    let bounds = tilt.bounds();
    let length = bounds.width().max(bounds.height()) * LENGTH;
    if let Some(eye) = eye {
        arrow(painter, tilt.middle, tilt.tip(eye) * length, theme::of(ui).second, Head::Eye);
    }
    arrow(painter, tilt.middle, tilt.tip(light) * length, theme::SUN, Head::Sun);
}

#[derive(Clone, Copy, PartialEq)]
enum Head {
    Sun,
    Eye,
}

/// Paints an arrow that begins on the side of its light or eye and ends at the middle of the tile.
fn arrow(painter: &Painter, middle: Pos2, from: Vec2, color: Color32, head: Head) {
    let ink = color.gamma_multiply(0.75);
    let start = middle + from;
    if from.length() > SHORT {
        let along = from.normalized();
        let tip = middle + along * 6.0;
        let side = along.rot90() * 6.0;
        let neck = tip + along * 13.0;
        for (stroke, color) in [(5.0, theme::HALO), (2.5, ink)] {
            painter.line_segment([start, neck], Stroke::new(stroke, color));
        }
        painter.add(Shape::convex_polygon(
            vec![tip, neck + side, neck - side],
            ink,
            Stroke::new(1.0, theme::HALO),
        ));
    }
    match head {
        Head::Sun => {
            for step in 0..8_u8 {
                let ray = Vec2::angled(f32::from(step) * std::f32::consts::FRAC_PI_4);
                for (width, color) in [(4.0, theme::HALO), (1.8, ink)] {
                    painter.line_segment(
                        [start + ray * 9.0, start + ray * 13.0],
                        Stroke::new(width, color),
                    );
                }
            }
            painter.circle(start, 6.5, ink, Stroke::new(1.0, theme::HALO));
        }
        Head::Eye => {
            painter.circle(start, 8.0, Color32::TRANSPARENT, Stroke::new(4.0, theme::HALO));
            painter.circle(start, 8.0, Color32::TRANSPARENT, Stroke::new(2.0, ink));
            painter.circle_filled(start, 3.0, ink);
        }
    }
}
