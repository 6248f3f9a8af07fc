import chiaro::types;
import chiaro::shadows;

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
/// @return shadow "Shadow" : From 0 where the light is free to 1 where it is kept away.
/// @error fast 1 : shadow within a pixel of an edge, which is as jagged as pixels are, and of a
///   light with a size, whose shadows stay hard
/// @source rays over a tree of boxes; Roberts 2018 for lights with a size
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
    return shadow_of_pixel(casters, Receiver(position, across, down, source, radius_of(size),
        caster_set, object, NO_FACET), false);
}

fn cast_shadow_fast(
    source: vec4f,
    caster_set: f32,
    position: vec3f,
    object: f32,
    casters: Casters,
) -> f32 {
    return shadow_of_ray(casters, Receiver(position, vec3f(0.0), vec3f(0.0), source, 0.0,
        caster_set, object, NO_FACET), false);
}
