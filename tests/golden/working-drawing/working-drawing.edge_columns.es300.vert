#version 300 es
// Working drawing: made by Chiaro 0.1.0, GLSL ES 3.00.
// The vertex shader. Finds the nearest edges in each pixel's column.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_edges 1.
// working-drawing.json says what to put there and how to draw.

precision highp float;
precision highp int;

const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2 = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
/// What is no nearer than this many pixels is not near at all: less is rounding.
const float LEAST_NEARNESS = 1e-6;


/// A triangle over the whole picture.
vec4 whole_picture(uint index) {
    return vec4(float(index & 1u) * 4.0 - 1.0, float(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

void main() {
    uint index = uint(gl_VertexID);
    gl_Position = whole_picture(index);
}
