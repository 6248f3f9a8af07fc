/// Viewport size
///
/// The picture's size: for patterns that keep their size on the screen.
///
/// @param viewport from=viewport hidden
fn viewport(viewport: vec2f) -> ViewportSize {
    return ViewportSize(viewport.x, viewport.y, viewport.x / max(viewport.y, 1.0));
}

struct ViewportSize {
    /// In pixels.
    width: f32,
    /// In pixels.
    height: f32,
    /// Width over height.
    aspect: f32,
}
