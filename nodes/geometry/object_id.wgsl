/// Object id
///
/// The object's number in the scene, from 0: gives each object something of its own, as a seed or a
/// place on a ramp.
///
/// @param object_id from=object_id hidden
/// @return id "Id" : A whole number.
fn object_id(object_id: f32) -> f32 {
    return object_id;
}
