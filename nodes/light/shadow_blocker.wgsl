import chiaro::types;
import chiaro::shadows;

/// Shadow blocker
///
/// What first stands between a surface and a light: how far away it is, and which object it is. For
/// shadows that change with the height of what casts them, or with who does.
///
/// @param light "Light" light_name : The light's id.
/// @param source from=light.source hidden
/// @param caster_set from=light.casters hidden
/// @param position from=position hidden
/// @param normal from=normal hidden
/// @param across from=pixel_across hidden
/// @param down from=pixel_down hidden
/// @param object from=object_id hidden
/// @param casters from=casters hidden
/// @error fast 1e3 : distance and object within a pixel of a shadow's edge, where nothing is found
///   although the shadow covers a part of the pixel
/// @source rays over a tree of boxes
fn shadow_blocker(
    facet: Facet,
    source: vec4f,
    caster_set: f32,
    position: vec3f,
    normal: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    casters: Casters,
) -> ShadowBlocker {
    let receiver = seen_by(Receiver(position, across, down, source, 0.0, caster_set, object, facet),
        normal);
    return found_blocker(blocker_of_pixel(casters, receiver));
}

fn shadow_blocker_fast(
    facet: Facet,
    source: vec4f,
    caster_set: f32,
    position: vec3f,
    normal: vec3f,
    object: f32,
    casters: Casters,
) -> ShadowBlocker {
    let receiver = seen_by(Receiver(position, vec3f(0.0), vec3f(0.0), source, 0.0, caster_set,
        object, facet), normal);
    return found_blocker(blocker_of_ray(casters, receiver, vec2f(0.0)));
}

fn found_blocker(found: vec2f) -> ShadowBlocker {
    return ShadowBlocker(max(found.x, 0.0), found.y);
}

fn shadow_blocker_prepare(
    casters: Casters,
    object: f32,
    position: vec3f,
    normal: vec3f,
    across: vec3f,
    down: vec3f,
) -> Facet {
    return facet_at(casters, object, position, normal, across, down);
}

struct ShadowBlocker {
    /// From the surface to what blocks the light, in scene units; 0 where nothing does.
    distance: f32,
    /// Number of the object that blocks it, as Object ID counts; -1 where nothing does.
    object: f32,
}
