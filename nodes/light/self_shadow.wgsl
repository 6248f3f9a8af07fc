import chiaro::types;
import chiaro::shadows;

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
/// @return shadow "Shadow" : From 0 where the light is free to 1 where it is kept away.
/// @error fast 1 : shadow within a pixel of an edge, which is as jagged as pixels are, and of a
///   light with a size, whose shadows stay hard
/// @source rays over a tree of boxes; Hanika 2021 for the turn from the light
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
    let receiver = Receiver(position, across, down, source, radius_of(size), caster_set, object,
        facet);
    let away = turned_away(receiver, normal, normal_across, normal_down);
    return own_shadow(casters, receiver, away);
}

fn self_shadow_fast(
    facet: Facet,
    source: vec4f,
    caster_set: f32,
    position: vec3f,
    normal: vec3f,
    object: f32,
    casters: Casters,
) -> f32 {
    let receiver = Receiver(position, vec3f(0.0), vec3f(0.0), source, 0.0, caster_set, object,
        facet);
    return own_shadow(casters, receiver, turned_away(receiver, normal, vec3f(0.0), vec3f(0.0)));
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
