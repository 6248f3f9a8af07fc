#version 300 es
// First look: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Finds curvature from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_normals 0, u_depths 1.
// first.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
};
struct Texel {
    vec3 normal;
    float object;
    float depth;
};
uniform highp sampler2D u_normals;

uniform highp sampler2D u_depths;

layout(std140) uniform CurvatureBlock { Curvature u_curvature; };

layout(location = 0) out float out_color;

Texel texel(ivec2 at) {
    bool local = false;
    ivec2 size = ivec2(uvec2(textureSize(u_normals, 0).xy));
    if (!(any(lessThan(at, ivec2(0))))) {
        local = any(greaterThanEqual(at, size));
    } else {
        local = true;
    }
    bool _e14 = local;
    if (_e14) {
        return Texel(vec3(0.0), 0.0, 0.0);
    }
    vec4 normal_1 = texelFetch(u_normals, at, 0);
    vec4 _e27 = texelFetch(u_depths, at, 0);
    return Texel(normal_1.xyz, normal_1.w, _e27.x);
}

vec2 slope(vec3 normal) {
    return (normal.xy / vec2(max(normal.z, 0.2)));
}

vec3 neighbour(Texel center, ivec2 at_1, vec2 step_) {
    Texel _e3 = texel(at_1);
    if ((_e3.object != center.object)) {
        return vec3(0.0);
    }
    float _e11 = u_curvature.pixel;
    float _e15 = u_curvature.perspective;
    float pixel = (_e11 * mix(1.0, center.depth, _e15));
    vec2 gradient = (-(center.normal.xy) / vec2(max(center.normal.z, 0.02)));
    float expected = (dot(gradient, step_) * pixel);
    float error = abs(((center.depth - _e3.depth) - expected));
    bool is_near = (error <= ((2.0 * pixel) * (1.0 + length(gradient))));
    vec2 _e45 = slope(_e3.normal);
    return (is_near ? vec3(_e45, 1.0) : vec3(0.0));
}

float derivative(float here, vec2 before, vec2 after) {
    float total = (before.y + after.y);
    if ((total == 0.0)) {
        return 0.0;
    }
    float forward = ((after.x - here) * after.y);
    float backward = ((here - before.x) * before.y);
    return ((forward + backward) / total);
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 at_2 = ivec2(position.xy);
    Texel _e3 = texel(at_2);
    if ((_e3.object == 0.0)) {
        out_color = 0.0;
        return;
    }
    vec2 _e9 = slope(_e3.normal);
    vec3 _e17 = neighbour(_e3, (at_2 + ivec2(-1, 0)), vec2(-1.0, 0.0));
    vec3 _e25 = neighbour(_e3, (at_2 + ivec2(1, 0)), vec2(1.0, 0.0));
    float _e28 = u_curvature.rows_up;
    int up = ((_e28 > 0.5) ? 1 : -1);
    vec3 _e40 = neighbour(_e3, (at_2 + ivec2(0, up)), vec2(0.0, 1.0));
    vec3 _e47 = neighbour(_e3, (at_2 - ivec2(0, up)), vec2(0.0, -1.0));
    float _e51 = derivative(_e9.x, _e17.xz, _e25.xz);
    float _e55 = derivative(_e9.y, _e47.yz, _e40.yz);
    float _e61 = u_curvature.viewport_height;
    float kappa = ((0.5 * (_e51 + _e55)) * _e61);
    out_color = clamp(kappa, -10000.0, 10000.0);
    return;
}

