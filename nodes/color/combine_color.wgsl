import chiaro::types;

/// Combine color
///
/// A color from its channels.
///
/// @param red "Red" default=0 min=0 max=1 : The first channel.
/// @param green "Green" default=0 min=0 max=1 : The second channel.
/// @param blue "Blue" default=0 min=0 max=1 : The third channel.
/// @param alpha "Alpha" default=1 min=0 max=1 : 0 is transparent.
/// @return color "Color" : Straight RGBA.
fn combine_color(red: f32, green: f32, blue: f32, alpha: f32) -> Color {
    return vec4f(red, green, blue, alpha);
}
