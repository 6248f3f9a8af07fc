import chiaro::types;
import chiaro::numeric;
import chiaro::angle;

/// Parametrization
///
/// The angle u between a light and a direction of the surface; it decides how shading moves.
/// Diffuse stays on the surface, Specular moves with the eye, Half-vector is Blinn's highlight,
/// Screen-aligned ignores the illumination frame and the camera: the light is read in the picture's
/// own axes.
///
/// @choice type "Type" default=diffuse diffuse="Diffuse" specular="Specular"
///   screen_aligned="Screen-aligned" half_vector="Half-vector" : Which direction of the surface the
///   light is held against.
/// @param light "Light" wire : Toward where the angle is 0.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view "View" from=view hidden
/// @param camera_from_world from=camera_from_world hidden
/// @return angle "Angle" : u, from 0 (facing the light) to pi.
/// @error balanced 1e-6 : angle in radians, for normals between 1e-15 and 1e18 long; others count
///   as pointing to +z
/// @source BADF eq. 4
fn parametrization_diffuse(light: Light, normal: vec3f) -> Angle {
    return angle_between(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
}

fn parametrization_specular(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let mirrored = 2.0 * dot(n, view) * n - view;
    return angle_between(normalize_or(mirrored, n), light.direction);
}

fn parametrization_screen_aligned(light: Light, normal: vec3f,
    camera_from_world: mat3x3f) -> Angle {
    let n = camera_from_world * normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    return angle_between(normalize_or(n, vec3f(0.0, 0.0, 1.0)), light.own_direction);
}

fn parametrization_half_vector(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    // Where the light is exactly behind, the half-vector has no direction; the edge of the
    // highlight is then meant.
    let half = light.direction + view;
    if dot(half, half) < 1e-12 {
        return Angle(0.707106781186547524, 0.707106781186547524);
    }
    return angle_between(n, normalize_or(half, n));
}

fn parametrization_diffuse_balanced(light: Light, normal: vec3f) -> Angle {
    return angle_of_units(normalize_quick(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
}

fn parametrization_specular_balanced(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let n = normalize_quick(normal, vec3f(0.0, 0.0, 1.0));
    return angle_of_units(2.0 * dot(n, view) * n - view, light.direction);
}

fn parametrization_screen_aligned_balanced(light: Light, normal: vec3f,
    camera_from_world: mat3x3f) -> Angle {
    return angle_of_units(camera_from_world * normalize_quick(normal, vec3f(0.0, 0.0, 1.0)),
        light.own_direction);
}

fn parametrization_half_vector_balanced(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let half = light.direction + view;
    let n = normalize_quick(normal, vec3f(0.0, 0.0, 1.0));
    let angle = angle_of_units(n, normalize_quick(half, n));
    let is_behind = dot(half, half) < 1e-12;
    return Angle(select(angle.half_sin, 0.707106781186547524, is_behind),
        select(angle.half_cos, 0.707106781186547524, is_behind));
}
