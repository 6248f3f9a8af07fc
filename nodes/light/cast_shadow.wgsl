import chiaro::types;
import chiaro::shadows;
import chiaro::shadow_map;

/// Cast shadow
///
/// How much of a light other objects keep from a surface, as a tone: 0 is lit, 1 is in shadow. Draw
/// it like any tone, through a profile, a ramp or colors of its own. What casts it, and onto what,
/// is for the scene to say. Alone, without a scene, nothing casts a shadow.
///
/// @param light "Light" light_name : The light's id.
/// @param source from=light.source hidden
/// @param caster_set from=light.casters hidden
/// @param size "Size" default=0 min=0 max=10 : Radius of the light, in scene units; of a
///   directional light, at a distance of 1 (the sun's is 0.0047). 0 gives hard edges.
/// @param position from=position hidden
/// @param across from=pixel_across hidden
/// @param down from=pixel_down hidden
/// @param object from=object_id hidden
/// @param casters from=casters hidden
/// @param map from=light.shadow_map hidden
/// @param shadow_map from=shadow_map hidden
/// @param shadow_map_behind from=shadow_map_behind hidden
/// @return shadow "Shadow" : From 0 where the light is free to 1 where it is kept away.
/// @error balanced 1 : shadow within half a texel of the light's map of an edge, and of a light
///   with a size, whose shadows stay hard; what is thinner than a texel
/// @error fast 1 : the same within a texel of an edge, which is as jagged as texels are
/// @source rays over a tree of boxes, Roberts 2018 for lights with a size; maps after Williams
///   1978, their edges after Bondarev 2014
fn cast_shadow(
    source: vec4f,
    caster_set: f32,
    size: f32,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    casters: Casters,
) -> f32 {
    return shadow_of_pixel(casters, receiver_at(position, across, down, source, size,
        caster_set, object, NO_FACET), false);
}

fn cast_shadow_balanced(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> f32 {
    if map.w < 0.0 {
        return 0.0;
    }
    let surface = mapped_surface(shadow_map, map, source, position, across, down, object);
    return shadow_of_edges(shadow_map, shadow_map_behind, surface, false);
}

fn cast_shadow_fast(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> f32 {
    if map.w < 0.0 {
        return 0.0;
    }
    let surface = mapped_surface(shadow_map, map, source, position, across, down, object);
    return shadow_of_texel(shadow_map, shadow_map_behind, surface, false);
}
