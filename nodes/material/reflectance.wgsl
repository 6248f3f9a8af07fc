import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::surface;
import chiaro::material;

/// Reflectance
///
/// How strongly a realistic surface shines toward the eye: to be laid beside drawn shading, for
/// contrast, or as a layer's tone.
///
/// @choice model "Model" default=ggx lambert="Lambert" half_lambert="Half Lambert" wrap="Wrapped"
///   oren_nayar="Oren-Nayar" phong="Phong" blinn_phong="Blinn-Phong" ggx="Cook-Torrance, GGX"
///   ward="Ward, anisotropic" : Lambert, Half Lambert (the far side keeps its form), Wrapped (light
///   creeps around, as through skin) and Oren-Nayar (rough, flatter) are matt; the others are
///   highlights, normalized so that a rougher one is dimmer.
/// @param light "Light" wire : Its direction counts, not its color.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @param tangent "Along" from=tangent : Ward: along the brushing.
/// @param roughness "Roughness" default=0.4 min=0 max=1 : 0 is a mirror, 1 is chalk.
/// @param across "Roughness across" default=0.15 min=0 max=1 : Ward: the roughness at a right angle
///   to Along.
/// @param at_normal "Reflectance" default=0.04 min=0 max=1 : GGX: what is reflected straight on;
///   metals are above 0.5.
/// @param wrap "Light wrap" default=0.5 min=0 max=1 : Wrapped: how far light creeps around.
/// @return tone "Tone" : 0 or more; a highlight may be far above 1.
/// @source Phong 1975, Blinn 1977, Cook and Torrance 1982, Ward 1992, Oren and Nayar 1994, Green
///   2004, Mitchell et al. 2006, Walter et al. 2007
fn reflectance_lambert(light: Light, normal: vec3f) -> f32 {
    return max(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction), 0.0);
}

fn reflectance_half_lambert(light: Light, normal: vec3f) -> f32 {
    let half = 0.5 + 0.5 * dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    return clamp(half * half, 0.0, 1.0);
}

fn reflectance_wrap(light: Light, normal: vec3f, wrap: f32) -> f32 {
    let w = clamp(bounded(wrap), 0.0, 1.0);
    let cosine = dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    return max((cosine + w) / (1.0 + w), 0.0);
}

fn reflectance_oren_nayar(light: Light, normal: vec3f, view: vec3f, roughness: f32) -> f32 {
    // At a roughness of 1 slopes deviate by a radian.
    let sigma = clamp(bounded(roughness), 0.0, 1.0);
    return oren_nayar(light.direction, normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view, sigma);
}

fn reflectance_phong(light: Light, normal: vec3f, view: vec3f, roughness: f32) -> f32 {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let e = exponent_of_width(width_of_roughness(roughness));
    let n_l = max(dot(n, light.direction), 0.0);
    let mirrored = normalize_or(2.0 * dot(n, view) * n - view, n);
    let shine = cosine_power(dot(mirrored, light.direction),
        sine_squared(mirrored, light.direction), e);
    return min(0.5 * (e + 2.0) * shine * n_l, 1e6);
}

fn reflectance_blinn_phong(light: Light, normal: vec3f, view: vec3f, roughness: f32) -> f32 {
    let r = reflection_of(light.direction, normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view);
    let e = exponent_of_width(width_of_roughness(roughness));
    let shine = cosine_power(r.n_h, r.sine2, e);
    return min(0.125 * (e + 8.0) * shine * max(r.n_l, 0.0), 1e6);
}

fn reflectance_ggx(light: Light, normal: vec3f, view: vec3f, roughness: f32,
    at_normal: f32) -> f32 {
    let r = reflection_of(light.direction, normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view);
    return ggx(r, width_of_roughness(roughness), clamp(bounded(at_normal), 0.0, 1.0));
}

fn reflectance_ward(light: Light, normal: vec3f, view: vec3f, tangent: vec3f, roughness: f32,
    across: f32) -> f32 {
    let frame = world_from_tangent(tangent, vec3f(0.0), normal);
    // Below a roughness of a twentieth the lobe is narrower than a pixel.
    let widths = max(vec2f(width_of_roughness(roughness), width_of_roughness(across)),
        vec2f(0.0025));
    return ward(light.direction, frame[2], view, frame[0], frame[1], widths);
}
