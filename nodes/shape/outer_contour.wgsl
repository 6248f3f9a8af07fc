import chiaro::numeric;
import chiaro::total;
import chiaro::antialias;
import chiaro::shape;

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
///
/// @param width "Width" default=4 min=0 max=40 : In thousandths of the picture's height.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @param viewport from=viewport hidden
/// @return line "Line" : 1 on the line, 0 elsewhere.
/// @unit
/// @bypass 0 when width = 0 : its width is 0
/// @source DeCarlo et al. 2003, contours
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
    let pixels = clamp(bounded(width), 0.0, 1e4) * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    // Near an outline of anything round n . v goes like the square root of the distance.
    let distance = facing / max(2.0 * footprint_of(facing), 1e-6);
    // A crease changes as fast, but far from the outline.
    let near = 1.0 - eased(facing, 0.45, 0.75);
    return line_covers(distance, pixels) * near;
}
