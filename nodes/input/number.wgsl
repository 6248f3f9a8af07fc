/// Number
///
/// A number to wire to several places, or to expose as a parameter of the look.
///
/// @param value "Value" default=0 : The number.
/// @return value "Value" : The same.
fn number(value: f32) -> f32 {
    return value;
}
