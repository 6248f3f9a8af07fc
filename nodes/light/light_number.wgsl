/// Light number
///
/// A number that belongs to a light by its id, and stays when other lights come and go: a color of
/// a ramp for each light, a seed for each light's strokes.
///
/// @param light "Light" light_name : The light's id; in a group that runs for each light, that one.
/// @param own_number default=0 number : The light's number.
/// @return number "Number" : From 0 to 1, without it; as good as random.
/// @unit
fn light_number(own_number: f32) -> f32 {
    return own_number;
}
