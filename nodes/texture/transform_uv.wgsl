import chiaro::total;

/// Transform UV
///
/// Moves, turns and scales texture coordinates before a picture or a pattern takes them.
///
/// @param uv "UV" from=uv : What is moved.
/// @param scale "Scale" default=1,1 : How often the pattern repeats.
/// @param angle "Angle" unit=rad default=0 : Turns the pattern clockwise about the middle.
/// @param offset "Offset" default=0,0 : Is added in the end.
/// @param middle "Middle" default=0.5,0.5 : What stays in place as the pattern turns and grows.
/// @return uv "UV" : The new coordinates.
fn transform_uv(uv: vec2f, scale: vec2f, angle: f32, offset: vec2f, middle: vec2f) -> vec2f {
    let wave = sin_cos_of(angle);
    let p = (uv - middle) * scale;
    let turned = vec2f(wave.y * p.x - wave.x * p.y, wave.x * p.x + wave.y * p.y);
    return bounded_vec2(turned + middle + offset);
}
