import chiaro::types;
import chiaro::total;

/// First of lights
///
/// What comes of the light of the highest priority that arrives, whole, in a group that runs for
/// each light of a set; of two of one priority the one that stands first among the lights.
///
/// @param before_color default=0,0,0,1 before=color : Of the lights before.
/// @param before_priority default=-1e30 before=priority : The highest of the lights before.
/// @param reach default=1 reach : How bright the light arrives; what does not arrive is left out.
/// @param color "Color" default=0,0,0,1 : What comes of one light.
/// @param priority "Priority" default=0 min=-1000 max=1000 : The highest takes the place.
fn first_of_lights(color: Color, priority: f32, before_color: Color, before_priority: f32,
    reach: f32) -> FirstLight {
    let p = bounded(priority);
    if (reach > 0.0) & (p > before_priority) {
        return FirstLight(color, p);
    }
    return FirstLight(before_color, before_priority);
}

struct FirstLight {
    /// Of the light that comes first; black where none arrives.
    color: Color,
    /// Priority of that light.
    priority: f32,
}
