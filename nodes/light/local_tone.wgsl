import chiaro::total;
import chiaro::local;

/// Local tone
///
/// Lightens or darkens a tone around a place on the surface: a highlight where none falls, a shadow
/// that is drawn back from an eye. Before a Profile's edge or before Bands, it moves their borders.
///
/// @param tone "Tone" default=0.5 min=0 max=1 : What is changed; chain several of these for several
///   places.
/// @param amount "Amount" default=0.3 min=-1 max=1 : How much is added at the place; below 0 it
///   darkens.
/// @param center "Center" default=0,0,1 : The place, in the space of the position.
/// @param radius "Radius" default=0.5 min=0 max=10 : How far it reaches.
/// @param hardness "Hardness" default=0 min=0 max=1 : How much of the radius is full before it
///   falls.
/// @param position "Position" from=position_object : In the object's own space, it goes along with
///   the object.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @source Todo et al. 2007
fn local_tone(tone: f32, amount: f32, center: vec3f, radius: f32, hardness: f32,
    position: vec3f) -> f32 {
    let weight = near_place(position, center, radius, hardness);
    return clamp(clamp(bounded(tone), 0.0, 1.0) + weight * clamp(bounded(amount), -1.0, 1.0), 0.0,
        1.0);
}
