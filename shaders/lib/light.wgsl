// Point and spot lights, as they arrive at a point of the surface.
import chiaro::types;
import chiaro::numeric;

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
fn light_at(
    light_position: vec3f,
    own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    fading: vec2f,
    position: vec3f,
) -> Light {
    let offset = light_position - position;
    let direction = normalize_or(offset, vec3f(0.0, 0.0, 1.0));
    let faded = intensity * light_fading(length(offset), fading);
    return Light(direction, own_from_world * direction, color, faded);
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
fn light_fading(distance: f32, fading: vec2f) -> f32 {
    var left = 1.0;
    if fading.x > 0.0 {
        let d = min(distance / fading.x, 1e15);
        left = 1.0 / (1.0 + d * d);
    }
    if fading.y > 0.0 {
        let d = min(distance / fading.y, 1.0);
        let window = max(1.0 - d * d * d * d, 0.0);
        left *= window * window;
    }
    return left;
}

/// Attenuation at an angle from a spot light's aim: smoothstep between the cosines `cone.y` (outer)
/// and `cone.x` (inner); a hard, inclusive edge where they are equal.
fn light_cone(cos_angle: f32, cone: vec2f) -> f32 {
    if cone.x <= cone.y {
        return select(0.0, 1.0, cos_angle >= cone.y);
    }
    let t = clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A light's intensity as two factors: x dims the layer (at most 1), y brightens the color (at
/// least 1).
fn light_split(intensity: f32) -> vec2f {
    return vec2f(min(intensity, 1.0), max(intensity, 1.0));
}
