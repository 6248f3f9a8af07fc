import chiaro::types;
import chiaro::convert;
import chiaro::numeric;

/// Dominant light
///
/// The one of two lights that gives the surface more, whole: what is painted for a light keeps its
/// strokes where two of them would be blended into a mess. Chain it for more lights.
///
/// @param a "A" wire : A light.
/// @param b "B" wire : Another light; where both give the same, A is taken.
/// @param normal "Normal" from=normal : World space; a light gives the less the more it grazes, and
///   nothing from behind.
/// @return light "Light" : A or B, as it is.
/// @source thesis 12.6
fn dominant_light(a: Light, b: Light, normal: vec3f) -> Light {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let from_a = a.intensity * luminance(vec4f(a.color, 1.0)) * max(dot(a.direction, n), 0.0);
    let from_b = b.intensity * luminance(vec4f(b.color, 1.0)) * max(dot(b.direction, n), 0.0);
    if from_b > from_a {
        return b;
    }
    return a;
}
