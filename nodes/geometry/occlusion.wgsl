import chiaro::types;
import chiaro::near_shares;
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
/// @param shares from=near_shares hidden
/// @param viewport from=viewport hidden
/// @param magnification from=magnification hidden
/// @return occlusion "Occlusion" : From 0 in the open to 1 where all is near.
/// @error fast 1 : found in the picture alone, which does not know what is hidden or beyond its
///   edges; farther than a third of its height away nothing counts
/// @source Zhukov et al. 1998, by rays over a tree of boxes; Malley's disk for their directions;
///   fast by horizons after Bavoil et al. 2008 and Jimenez et al. 2016
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
    near: f32,
    far: f32,
    shares: vec4f,
    viewport: vec2f,
    magnification: f32,
) -> f32 {
    let range = occluding_range(near, far);
    let steps = steps_to_unit(viewport.y, magnification);
    return occlusion_within(shares_of(shares), range.near * steps, range.far * steps);
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
