#version 330 core
// Curvature in the color: made by Chiaro 0.1.0, GLSL 3.30.
// The vertex shader. Finds curvature from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0.
// figure4-color.json says what to put there and how to draw.

/// A triangle over the whole picture.
vec4 whole_picture(uint index) {
    return vec4(float(index & 1u) * 4.0 - 1.0, float(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

void main() {
    uint index = uint(gl_VertexID);
    gl_Position = whole_picture(index);
}
