import chiaro::types;

/// Set alpha
///
/// The same color with another transparency.
///
/// @param color "Color" default=1,1,1,1 : Its own alpha does not count.
/// @param alpha "Alpha" default=1 min=0 max=1 : 0 is transparent.
/// @return color "Color" : Straight RGBA.
fn set_alpha(color: Color, alpha: f32) -> Color {
    return vec4f(color.xyz, alpha);
}
