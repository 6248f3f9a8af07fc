import chiaro::types;
import chiaro::filter;

/// Rod
///
/// Dims light at the places inside a ball or a box, wherever the light comes from: a corner of a
/// room that shall be darker, or, inverted, the only place that is lit.
///
/// @param center "Center" default=0,0,0 : Where it lies, in world space.
/// @param toward "Toward" widget=direction default=0,1,0 : Where its own z axis points.
/// @param spin "Spin" unit=rad default=0 : Turns it around that axis.
/// @param size "Size" default=0.5,0.5,0.5 : Half its width, height and depth, in scene units.
/// @param roundness "Roundness" default=1 min=0 max=1 : 0 is a box, 1 a ball.
/// @param softness "Softness" default=0.5 min=0 max=4 : How far its edge fades outward, in its own
///   sizes.
/// @param density "Density" default=1 min=0 max=1 : How much it takes away.
/// @param inverted "Invert" default=false : Lets light through inside, and nowhere else.
/// @param share "Share" default=1 min=0 max=1 : What passes the filters before it.
/// @param position "Position" from=position : Where the light arrives.
/// @return share "Share" : How much of the light passes, from 0 to 1.
/// @unit
fn rod(center: vec3f, toward: vec3f, spin: f32, size: vec3f, roundness: f32, softness: f32,
    density: f32, inverted: bool, share: f32, position: vec3f) -> f32 {
    let place = place_along(position, center, axes_turned(toward, spin)) / half_size(size);
    let m = mixed(largest_of(place), length_of(place), clamp(bounded(roundness), 0.0, 1.0));
    return share_kept(share) * share_beside(m, softness, density, inverted);
}
