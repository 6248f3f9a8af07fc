/// Reroute
///
/// A bend in a wire: it passes on whatever it is given, of any type, and costs nothing.
///
/// @param value "Value" wire : Anything.
/// @return value "Value" : The same.
fn reroute(value: vec4f) -> vec4f {
    return value;
}
