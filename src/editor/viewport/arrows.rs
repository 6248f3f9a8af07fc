//! Arrows on the surface toward the eye and the lights, as an HCBTF lookup there sees them (thesis
//! Appendix B).
//!
//! A light's arrow points at the light. The eye's arrow would be a point, seen from the eye itself;
//! so its trace on the surface is shown, as long as the eye stands low, and the light's trace too:
//! those are the directions by which samples are found. Arrows stand at sparse places, and larger
//! ones under the pointer.

use eframe::egui::{Color32, Pos2, Rect, Stroke, Ui};
use glam::DVec3;

use super::lights::resolved;
use super::surface::Surface;
use super::{place_in, project};
use crate::compile::LightValues;
use crate::document::LightKind;
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;
use crate::widgets::theme;

/// Distance between sparse places, in points.
const APART: f32 = 72.0;
/// Length of an arrow at a sparse place and under the pointer, in radii of the visible bounds.
const LENGTHS: [f64; 2] = [0.09, 0.2];
/// Length below which a trace counts as a point, in points.
const SHORTEST: f32 = 2.0;
/// Color of the eye's arrows, and the opacities of an arrow and of a trace.
const EYE: Color32 = Color32::from_rgb(110, 190, 255);
const STRENGTHS: [f32; 2] = [0.85, 0.45];

/// Arrow on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Arrow {
    pub(super) from: Pos2,
    pub(super) to: Pos2,
    /// True if the arrow lies on the surface.
    is_trace: bool,
    /// Color of the arrow's light; `None` for the eye's own arrow.
    light: Option<Color32>,
}

/// Arrows at sparse places, then those at the pointer.
pub(super) fn of(
    session: &Session,
    surface: &Surface,
    rect: Rect,
    pointer: Option<Pos2>,
) -> Vec<Arrow> {
    let lights: Vec<(LightValues, Color32)> = session
        .keys()
        .shining()
        .map(|(_, light)| {
            let [r, g, b] = light.color.map(|c| (c.clamp(0.0, 1.0) * 255.0) as u8);
            (resolved(light, session), Color32::from_rgb(r, g, b))
        })
        .collect();
    let directional: Vec<bool> =
        session.keys().shining().map(|(_, light)| light.kind == LightKind::Directional).collect();
    let (_, radius) = sphere_of_lights(session.open_scene());
    let mut arrows = Vec::new();
    let mut stand = |place: [f32; 2], length: f64| {
        let Some(pixel) = surface.pixel_at(place).filter(|pixel| surface.is_covered(*pixel)) else {
            return;
        };
        let position = surface.positions[pixel].as_dvec3();
        let normal = surface.normals[pixel].as_dvec3();
        let mut push = |along: DVec3, is_trace: bool, light: Option<Color32>| {
            let ends = [position, position + along * length].map(|end| project(end, rect, session));
            if let [Some(from), Some(to)] = ends {
                arrows.push(Arrow { from, to, is_trace, light });
            }
        };
        let trace = |toward: DVec3| toward - normal * normal.dot(toward);
        push(trace(surface.toward_viewer(pixel).as_dvec3()), true, None);
        for ((light, color), is_directional) in lights.iter().zip(&directional) {
            let toward =
                if *is_directional { light.direction() } else { light.position() - position };
            let toward = toward.normalize_or_zero();
            // Light from below the surface does not reach it.
            if toward.dot(normal) > 0.0 {
                push(trace(toward), true, Some(*color));
                push(toward, false, Some(*color));
            }
        }
    };
    let [sparse, near] = LENGTHS.map(|length| length * radius);
    let count = [rect.width(), rect.height()].map(|side| (side / APART).floor().max(1.0) as usize);
    for y in 0..count[1] {
        for x in 0..count[0] {
            stand([(x as f32 + 0.5) / count[0] as f32, (y as f32 + 0.5) / count[1] as f32], sparse);
        }
    }
    if let Some(at) = pointer.filter(|at| rect.contains(*at)) {
        stand(place_in(rect, at), near);
    }
    arrows
}

pub(super) fn paint(ui: &Ui, rect: Rect, arrows: &[Arrow]) {
    let painter = ui.painter_at(rect);
    for Arrow { from, to, is_trace, light } in arrows {
        let strength = STRENGTHS[usize::from(*is_trace && light.is_some())];
        let color = light.unwrap_or(EYE).gamma_multiply(strength);
        let halo = theme::HALO.gamma_multiply(strength);
        let along = *to - *from;
        if along.length() < SHORTEST {
            painter.circle_filled(*from, 3.0, halo);
            painter.circle_filled(*from, 2.0, color);
            continue;
        }
        let head = (0.35 * along.length()).min(7.0) * along.normalized();
        let barbs = [0.45, -0.45].map(|side| *to - head + side * head.rot90());
        for (width, color) in [(3.5, halo), (1.5, color)] {
            painter.line_segment([*from, *to], Stroke::new(width, color));
            barbs
                .iter()
                .for_each(|barb| _ = painter.line_segment([*barb, *to], Stroke::new(width, color)));
        }
    }
}
