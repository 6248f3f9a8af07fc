#version 300 es
// Layers: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Finds curvature from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_normals 0, u_depths 1.
// figure1-layers.json says what to put there and how to draw.

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
struct Sides {
    float forward;
    float forward_weight;
    float backward;
    float backward_weight;
};
const float WEIGHTS[3] = float[3](1.0, 0.85, 0.5);

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

vec3 neighbour(Texel center, ivec2 at_1, vec2 offset) {
    Texel _e3 = texel(at_1);
    if ((_e3.object != center.object)) {
        return vec3(0.0);
    }
    float _e11 = u_curvature.pixel;
    float _e15 = u_curvature.perspective;
    float pixel = (_e11 * mix(1.0, center.depth, _e15));
    vec2 gradient = (-(center.normal.xy) / vec2(max(center.normal.z, 0.02)));
    float expected = (dot(gradient, offset) * pixel);
    float error = abs(((center.depth - _e3.depth) - expected));
    bool is_near = (error <= (((2.0 * pixel) * length(offset)) * (1.0 + length(gradient))));
    vec2 _e47 = slope(_e3.normal);
    return (is_near ? vec3(_e47, 1.0) : vec3(0.0));
}

float derivative(Sides sides) {
    float forward = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward = (sides.backward / max(sides.backward_weight, 1e-6));
    float count = (((sides.forward_weight > 0.0) ? 1.0 : 0.0) + ((sides.backward_weight > 0.0) ? 1.0 : 0.0));
    return ((forward + backward) / max(count, 1.0));
}

void main() {
    vec4 position = gl_FragCoord;
    Sides along_x = Sides(0.0, 0.0, 0.0, 0.0);
    Sides along_y = Sides(0.0, 0.0, 0.0, 0.0);
    int k = 1;
    ivec2 at_2 = ivec2(position.xy);
    Texel _e3 = texel(at_2);
    if ((_e3.object == 0.0)) {
        out_color = 0.0;
        return;
    }
    vec2 _e9 = slope(_e3.normal);
    float _e24 = u_curvature.rows_up;
    int up = ((_e24 > 0.5) ? 1 : -1);
    float _e32 = u_curvature.viewport_height;
    int stride = max(int(roundEven((_e32 / 800.0))), 1);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e144 = k;
            k = (_e144 + 1);
        }
        loop_init = false;
        int _e41 = k;
        if ((_e41 <= 3)) {
        } else {
            break;
        }
        {
            int _e44 = k;
            int reach = (_e44 * stride);
            float distance_ = float(reach);
            int _e48 = k;
            float weight = ((WEIGHTS[(_e48 - 1)] * distance_) * distance_);
            vec3 _e61 = neighbour(_e3, (at_2 + ivec2(-(reach), 0)), vec2(-(distance_), 0.0));
            vec3 _e67 = neighbour(_e3, (at_2 + ivec2(reach, 0)), vec2(distance_, 0.0));
            vec3 _e74 = neighbour(_e3, (at_2 + ivec2(0, (up * reach))), vec2(0.0, distance_));
            vec3 _e82 = neighbour(_e3, (at_2 - ivec2(0, (up * reach))), vec2(0.0, -(distance_)));
            float _e84 = along_x.forward;
            along_x.forward = (_e84 + (((weight * _e67.z) * (_e67.x - _e9.x)) / distance_));
            float _e94 = along_x.forward_weight;
            along_x.forward_weight = (_e94 + (weight * _e67.z));
            float _e99 = along_x.backward;
            along_x.backward = (_e99 + (((weight * _e61.z) * (_e9.x - _e61.x)) / distance_));
            float _e109 = along_x.backward_weight;
            along_x.backward_weight = (_e109 + (weight * _e61.z));
            float _e114 = along_y.forward;
            along_y.forward = (_e114 + (((weight * _e74.z) * (_e74.y - _e9.y)) / distance_));
            float _e124 = along_y.forward_weight;
            along_y.forward_weight = (_e124 + (weight * _e74.z));
            float _e129 = along_y.backward;
            along_y.backward = (_e129 + (((weight * _e82.z) * (_e9.y - _e82.y)) / distance_));
            float _e139 = along_y.backward_weight;
            along_y.backward_weight = (_e139 + (weight * _e82.z));
        }
    }
    Sides _e146 = along_x;
    float _e147 = derivative(_e146);
    Sides _e148 = along_y;
    float _e149 = derivative(_e148);
    float _e155 = u_curvature.viewport_height;
    float kappa = ((0.5 * (_e147 + _e149)) * _e155);
    out_color = clamp(kappa, -10000.0, 10000.0);
    return;
}

