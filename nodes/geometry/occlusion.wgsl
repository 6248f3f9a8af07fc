import chiaro::types;
import chiaro::occlusion;

/// Occlusion
///
/// How much of what surrounds a surface stands close by, as a tone: 0 in the open, 1 where
/// everything about it is near. Draw it like any tone: dark creases, dust in corners, worn edges by
/// its inverse. What stands about an object is what may cast shadows onto it. Alone, without a
/// scene, nothing does.
///
/// @param near "Near" default=0 min=0 max=1000 : Up to this far away things count in full, in scene
///   units.
/// @param far "Far" default=0.5 min=0 max=1000 : From here on things do not count, in scene units.
/// @param position from=position hidden
/// @param normal from=normal hidden
/// @param across from=pixel_across hidden
/// @param down from=pixel_down hidden
/// @param object from=object_id hidden
/// @param casters from=casters hidden
/// @return occlusion "Occlusion" : From 0 in the open to 1 where all is near.
/// @error fast 1 : eight rays in place of 64, which see little of what is small or narrow
/// @source Zhukov et al. 1998, by rays over a tree of boxes; Malley's disk for their directions
fn occlusion(
    facet: Facet,
    near: f32,
    far: f32,
    position: vec3f,
    normal: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    casters: Casters,
) -> f32 {
    let receiver = Receiver(position, across, down, vec4f(0.0), 0.0, occluders(casters, object),
        object, facet);
    return occlusion_of_pixel(casters, receiver, normal, occluding_range(near, far),
        OPEN_RAYS);
}

fn occlusion_fast(
    facet: Facet,
    near: f32,
    far: f32,
    position: vec3f,
    normal: vec3f,
    object: f32,
    casters: Casters,
) -> f32 {
    let receiver = Receiver(position, vec3f(0.0), vec3f(0.0), vec4f(0.0), 0.0,
        occluders(casters, object), object, facet);
    return occlusion_of_pixel(casters, receiver, normal, occluding_range(near, far),
        FEW_OPEN_RAYS);
}

fn occlusion_prepare(
    casters: Casters,
    object: f32,
    position: vec3f,
    normal: vec3f,
    across: vec3f,
    down: vec3f,
) -> Facet {
    return facet_at(casters, object, position, normal, across, down);
}
