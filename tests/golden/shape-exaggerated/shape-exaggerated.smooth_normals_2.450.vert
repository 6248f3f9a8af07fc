#version 450 core
// Exaggerated shape: made by Chiaro 0.1.0, GLSL 4.50.
// The vertex shader. Smooths normals further, from neighbors four steps away.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_normals 1.
// shape-exaggerated.json says what to put there and how to draw.

/// A triangle over the whole picture.
vec4 whole_picture(uint index) {
    return vec4(float(index & 1u) * 4.0 - 1.0, float(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

void main() {
    uint index = uint(gl_VertexID);
    gl_Position = whole_picture(index);
}
