import chiaro::types;

/// Separate color
///
/// A color's channels: a mask packed into a texture, the alpha of a picture.
///
/// @param color "Color" default=0,0,0,1 : What is taken apart.
fn separate_color(color: Color) -> ColorParts {
    return ColorParts(color.x, color.y, color.z, color.w);
}

struct ColorParts {
    /// The first channel.
    red: f32,
    /// The second channel.
    green: f32,
    /// The third channel.
    blue: f32,
    /// 0 is transparent.
    alpha: f32,
}
