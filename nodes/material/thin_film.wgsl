import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::material;

/// Thin film
///
/// The colors of soap bubbles, beetles and oil on water: a film that is as thin as light's waves
/// are long reflects some and cancels others, changing with the angle.
///
/// @param thickness "Thickness" default=400 min=0 max=2000 : In nanometres, up to 2000; a gradient
///   or noise makes it swirl.
/// @param index "Refractive index" default=1.33 min=1 max=3 : From 1 to 3; water is 1.33, oil and
///   lacquer 1.5.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @return color "Color" : Opaque; black where the film has no thickness.
/// @unit
/// @source Airy 1833, at 650, 532 and 450 nm
fn thin_film(thickness: f32, index: f32, normal: vec3f, view: vec3f) -> Color {
    let cosine = clamp(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view), 0.0, 1.0);
    let n = clamp(bounded(index), 1.0, 3.0);
    // Snell's law: the cosine within the film, times the index; a film of index 1 does not bend
    // light at all.
    let inside = sqrt((n - 1.0) * (n + 1.0) + cosine * cosine);
    let path = 2.0 * clamp(bounded(thickness), 0.0, 2000.0) * inside;
    return vec4f(interference(path, 650.0), interference(path, 532.0), interference(path, 450.0),
        1.0);
}
