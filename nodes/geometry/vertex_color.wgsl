import chiaro::types;

/// Vertex color
///
/// The color painted on the mesh's vertices; white where it has none. Painters use it for masks
/// too.
///
/// @param vertex_color from=vertex_color hidden
/// @return color "Color" : Straight RGBA.
fn vertex_color(vertex_color: Color) -> Color {
    return vertex_color;
}
