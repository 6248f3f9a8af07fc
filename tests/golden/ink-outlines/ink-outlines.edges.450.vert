#version 450 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 4.50.
// The vertex shader. Finds where surfaces end, fold and meet.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0.
// ink-outlines.json says what to put there and how to draw.

vec4 whole_picture(uint index_1) {
    return vec4(((float((index_1 & 1u)) * 4.0) - 1.0), ((float((index_1 >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

void main() {
    uint index = uint(gl_VertexID);
    vec4 _e1 = whole_picture(index);
    gl_Position = _e1;
    return;
}

