// Slopes of a surface over the picture, and the texels by which passes over the picture know it
// (docs/math.md 3.3).

/// The least n.z that divides: beyond it every rim would saturate to convex.
const LEAST_NZ = 0.2;

/// The slope n.xy / n.z of a normal in camera axes.
fn slope_of(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, LEAST_NZ);
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
fn surface_texel(normal: vec3f, depth: f32, number: f32) -> vec4f {
    return vec4f(slope_of(normal), depth, select(number, -number, normal.z < 0.0));
}

/// Materials of an object, ids and objects that the numbers of texels tell apart; beyond that many
/// they repeat.
const MATERIALS = 32.0;
const IDS = 128.0;
const OBJECTS = 4096.0;

/// The number of an object in texels, from 1 on.
fn object_number(object: f32) -> f32 {
    return object - OBJECTS * floor(object / OBJECTS) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
fn facet_number(object: f32, material: f32, id: f32) -> f32 {
    let whole = round(select(0.0, id, abs(id) <= 1e6));
    let parts = IDS * (material - MATERIALS * floor(material / MATERIALS))
        + whole - IDS * floor(whole / IDS);
    return object_number(object) + parts / (MATERIALS * IDS);
}

/// The normal that a texel was made from.
fn normal_of(texel: vec4f) -> vec3f {
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    let aside = LEAST_NZ * texel.xy;
    let rest = sqrt(max(1.0 - dot(aside, aside), 0.0));
    let nz = select(rest, -rest, texel.w < 0.0);
    let facing = vec3f(texel.xy, 1.0) / sqrt(1.0 + dot(texel.xy, texel.xy));
    return select(vec3f(aside, nz), facing, nz >= LEAST_NZ);
}
