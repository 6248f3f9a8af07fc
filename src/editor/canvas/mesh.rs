//! Shapes of the canvas, written straight into one mesh with antialiased edges.

use eframe::egui::epaint::{Mesh, Vertex};
use eframe::egui::{Color32, Galley, Pos2, Rect, Vec2, pos2, vec2};

use super::table::point_at;
use crate::drawing::SocketShape;

/// Number of straight pieces that keep within `tolerance` of a curve, 1 to 64.
fn pieces(c: &[Pos2; 4], tolerance: f32) -> usize {
    let a = (c[0].to_vec2() - 2.0 * c[1].to_vec2() + c[2].to_vec2()).length();
    let b = (c[1].to_vec2() - 2.0 * c[2].to_vec2() + c[3].to_vec2()).length();
    ((0.75 * a.max(b) / tolerance).sqrt().ceil() as usize).clamp(1, 64)
}

/// Adds a curve as a ribbon with soft edges; pieces outside `clip` are left out.
pub(crate) fn ribbon(
    mesh: &mut Mesh,
    c: &[Pos2; 4],
    width: f32,
    color: Color32,
    clip: Rect,
    tolerance: f32,
) {
    let n = pieces(c, tolerance);
    let half = width * 0.5 + 0.5;
    let core = (width * 0.5 - 0.5).max(0.0);
    let color = if width < 1.0 { color.gamma_multiply(width) } else { color };
    let across: u32 = if core > 0.05 { 4 } else { 3 };
    let mut is_open = false;
    let mut previous = c[0];
    for i in 1..=n {
        let p = if i == n { c[3] } else { point_at(c, i as f32 / n as f32) };
        if !Rect::from_two_pos(previous, p).intersects(clip) {
            (is_open, previous) = (false, p);
            continue;
        }
        let d = p - previous;
        let normal = d.rot90() / d.length().max(1e-6);
        let mut add = |p: Pos2| {
            mesh.vertices.push(Vertex::untextured(p - normal * half, Color32::TRANSPARENT));
            if across == 4 {
                mesh.vertices.push(Vertex::untextured(p - normal * core, color));
                mesh.vertices.push(Vertex::untextured(p + normal * core, color));
            } else {
                mesh.vertices.push(Vertex::untextured(p, color));
            }
            mesh.vertices.push(Vertex::untextured(p + normal * half, Color32::TRANSPARENT));
        };
        if !is_open {
            add(previous);
        }
        add(p);
        (is_open, previous) = (true, p);
        let end = mesh.vertices.len() as u32 - across;
        let start = end - across;
        for k in 0..across - 1 {
            mesh.indices.extend_from_slice(&[
                start + k,
                start + k + 1,
                end + k,
                end + k,
                start + k + 1,
                end + k + 1,
            ]);
        }
    }
}

/// Adds a filled convex outline with a soft edge one point wide.
pub(crate) fn convex(mesh: &mut Mesh, outline: &[Pos2], center: Pos2, color: Color32) {
    let first = mesh.vertices.len() as u32;
    let n = outline.len() as u32;
    mesh.vertices.push(Vertex::untextured(center, color));
    for &p in outline {
        let out = (p - center).normalized() * 0.5;
        mesh.vertices.push(Vertex::untextured(p - out, color));
        mesh.vertices.push(Vertex::untextured(p + out, Color32::TRANSPARENT));
    }
    for k in 0..n {
        let (i, j) = (first + 1 + 2 * k, first + 1 + 2 * ((k + 1) % n));
        mesh.indices.extend_from_slice(&[first, i, j, i, i + 1, j, j, i + 1, j + 1]);
    }
}

/// Adds a socket's shape around its center.
pub(crate) fn socket(
    mesh: &mut Mesh,
    shape: SocketShape,
    center: Pos2,
    radius: f32,
    color: Color32,
) {
    let points = shape.outline();
    let mut outline = [Pos2::ZERO; 12];
    for (place, &(x, y)) in outline.iter_mut().zip(points) {
        *place = center + vec2(x, y) * radius;
    }
    convex(mesh, &outline[..points.len()], center, color);
}

/// Adds a rectangle on whole points, without soft edges: four vertices.
pub(crate) fn plain(mesh: &mut Mesh, r: Rect, color: Color32) {
    let min = pos2(r.min.x.round(), r.min.y.round());
    mesh.add_colored_rect(Rect::from_min_size(min, r.size().round().max(vec2(1.0, 1.0))), color);
}

/// Adds a rectangle whose corners are round at the top, the bottom, or both.
pub(crate) fn rounded(
    mesh: &mut Mesh,
    r: Rect,
    radius: f32,
    (top, bottom): (bool, bool),
    color: Color32,
) {
    const STEPS: usize = 4;
    let radius = radius.min(r.width() / 2.0).min(r.height() / 2.0);
    let corners = [
        (r.left_top(), vec2(1.0, 1.0), std::f32::consts::PI, top),
        (r.right_top(), vec2(-1.0, 1.0), std::f32::consts::PI * 1.5, top),
        (r.right_bottom(), vec2(-1.0, -1.0), 0.0, bottom),
        (r.left_bottom(), vec2(1.0, -1.0), std::f32::consts::FRAC_PI_2, bottom),
    ];
    let first = mesh.vertices.len() as u32;
    mesh.vertices.push(Vertex::untextured(r.center(), color));
    let mut n = 0;
    for (corner, inward, start, is_round) in corners {
        let steps = if is_round && radius > 1.0 { STEPS } else { 0 };
        for step in 0..=steps {
            let angle = start
                + std::f32::consts::FRAC_PI_2
                    * (if steps == 0 { 0.5 } else { step as f32 / steps as f32 });
            let out = vec2(angle.cos(), angle.sin());
            let p = if steps == 0 { corner } else { corner + inward * radius + out * radius };
            let soft = if steps == 0 { -inward * 0.5 } else { out * 0.5 };
            mesh.vertices.push(Vertex::untextured(p - soft, color));
            mesh.vertices.push(Vertex::untextured(p + soft, Color32::TRANSPARENT));
            n += 1;
        }
    }
    for k in 0..n {
        let (i, j) = (first + 1 + 2 * k, first + 1 + 2 * ((k + 1) % n));
        mesh.indices.extend_from_slice(&[first, i, j, i, i + 1, j, j, i + 1, j + 1]);
    }
}

/// Copies a galley's glyphs as egui's tessellator does, but without a shape for each line. `uv` is
/// one over the size of the font image; `pixels` is the number of pixels per point.
pub(crate) fn glyphs(mesh: &mut Mesh, at: Pos2, galley: &Galley, uv: Vec2, pixels: f32) {
    // Glyphs lie on whole pixels, as in the tessellator; otherwise they blur and catch specks of
    // their neighbors.
    let at = pos2((at.x * pixels).round() / pixels, (at.y * pixels).round() / pixels);
    for row in &galley.rows {
        let from = &row.visuals.mesh;
        let first = mesh.vertices.len() as u32;
        let offset = at.to_vec2() + row.pos.to_vec2();
        mesh.indices.extend(from.indices.iter().map(|index| index + first));
        mesh.vertices.extend(from.vertices.iter().map(|vertex| Vertex {
            pos: vertex.pos + offset,
            uv: (vertex.uv.to_vec2() * uv).to_pos2(),
            color: vertex.color,
        }));
    }
}
