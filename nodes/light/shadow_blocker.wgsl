import chiaro::types;
import chiaro::shadows;
import chiaro::shadow_map;

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
/// @param map from=light.shadow_map hidden
/// @param shadow_map from=shadow_map hidden
/// @param shadow_map_behind from=shadow_map_behind hidden
/// @error balanced 1e3 : distance, which is that of the blocker's lit side; distance and object
///   within a texel of the light's map of a shadow's edge, and where more than two objects hide one
///   another from the light, of which the second is taken
/// @source rays over a tree of boxes; maps after Williams 1978
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
    let receiver = seen_by(receiver_at(position, across, down, source, 0.0, caster_set, object,
        facet), normal);
    return found_blocker(blocker_of_pixel(casters, receiver));
}

fn shadow_blocker_balanced(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> ShadowBlocker {
    if map.w < 0.0 {
        return ShadowBlocker(0.0, -1.0);
    }
    let surface = mapped_surface(shadow_map, map, source, position, across, down, object);
    let found = blocker_in_map(shadow_map, shadow_map_behind, surface, source, position);
    return ShadowBlocker(found.x, found.y);
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
