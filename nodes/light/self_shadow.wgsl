import chiaro::types;
import chiaro::shadows;
import chiaro::shadow_map;

/// Self shadow
///
/// How much of a light an object keeps from its own surface, as a tone: 0 is lit, 1 is in shadow.
/// The side that is turned away from the light is in the object's own shadow; up to where the
/// smooth normal turns away, the facets of its mesh leave no jags. Alone, without a scene, nothing
/// casts a shadow.
///
/// @param light "Light" light_name : The light's id.
/// @param source from=light.source hidden
/// @param caster_set from=light.casters hidden
/// @param size "Size" default=0 min=0 max=10 : Radius of the light, in scene units; of a
///   directional light, at a distance of 1 (the sun's is 0.0047). 0 gives hard edges.
/// @param position from=position hidden
/// @param normal from=normal hidden
/// @param normal_across from=normal_across hidden
/// @param normal_down from=normal_down hidden
/// @param across from=pixel_across hidden
/// @param down from=pixel_down hidden
/// @param object from=object_id hidden
/// @param casters from=casters hidden
/// @param map from=light.shadow_map hidden
/// @param shadow_map from=shadow_map hidden
/// @param shadow_map_behind from=shadow_map_behind hidden
/// @return shadow "Shadow" : From 0 where the light is free to 1 where it is kept away.
/// @error balanced 1 : shadow within half a texel of the light's map of an edge, of a light with a
///   size, whose shadows stay hard, and where two other objects hide the object from the light;
///   what is thinner than a texel
/// @error fast 1 : the same within a texel of an edge, which is as jagged as texels are
/// @source rays over a tree of boxes, Hanika 2021 for the turn from the light; maps after Williams
///   1978, their edges after Bondarev 2014
fn self_shadow(
    facet: Facet,
    source: vec4f,
    caster_set: f32,
    size: f32,
    position: vec3f,
    normal: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    casters: Casters,
) -> f32 {
    let receiver = receiver_at(position, across, down, source, size, caster_set, object, facet);
    let away = turned_away(receiver, normal, normal_across, normal_down);
    return own_shadow(casters, receiver, away);
}

fn self_shadow_balanced(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    normal: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> f32 {
    let receiver = Receiver(position, across, down, source, 0.0, 0.0, object, NO_FACET);
    let away = turned_away(receiver, normal, normal_across, normal_down);
    if map.w < 0.0 {
        return 0.0;
    }
    if away >= 1.0 {
        return 1.0;
    }
    let seen = mapped_surface(shadow_map, map, source, position, across, down, object);
    let surface = smooth_surface(seen, receiver, normal);
    return max(away, shadow_of_edges(shadow_map, shadow_map_behind, surface, true));
}

fn self_shadow_fast(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    normal: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> f32 {
    let receiver = Receiver(position, across, down, source, 0.0, 0.0, object, NO_FACET);
    let away = turned_away(receiver, normal, normal_across, normal_down);
    if map.w < 0.0 {
        return 0.0;
    }
    if away >= 1.0 {
        return 1.0;
    }
    let seen = mapped_surface(shadow_map, map, source, position, across, down, object);
    let surface = smooth_surface(seen, receiver, normal);
    return max(away, shadow_of_texel(shadow_map, shadow_map_behind, surface, true));
}

fn self_shadow_prepare(
    casters: Casters,
    object: f32,
    position: vec3f,
    normal: vec3f,
    across: vec3f,
    down: vec3f,
) -> Facet {
    return facet_at(casters, object, position, normal, across, down);
}
