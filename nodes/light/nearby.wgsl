import chiaro::total;
import chiaro::local;

/// Near a place
///
/// 1 around a place on the surface and 0 beyond a radius: to change whatever is wired to it there
/// and nowhere else.
///
/// @param position "Position" from=position_object : In the object's own space, it goes along with
///   the object.
/// @param center "Center" default=0,0,1 : The place, in the same space.
/// @param radius "Radius" default=0.5 min=0 max=10 : How far it reaches.
/// @param hardness "Hardness" default=0 min=0 max=1 : How much of the radius is full before it
///   falls.
/// @return weight "Weight" : From 0 to 1.
/// @unit
/// @source Todo et al. 2007
fn nearby(position: vec3f, center: vec3f, radius: f32, hardness: f32) -> f32 {
    return near_place(position, center, radius, hardness);
}
